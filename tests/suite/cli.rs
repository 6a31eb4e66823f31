//! The command as its users run it: results, exit statuses, and what it leaves behind.

mod bench;
mod measured;
mod notation;
mod patches;
mod reports;
mod scenes;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

/// A folder that goes away with the test.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Folder {
        Folder(tempfile::tempdir().expect("a temporary folder can be made"))
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn spec(&self, text: impl AsRef<[u8]>) -> String {
        let path = self.path("spec.trim");
        std::fs::write(&path, text).expect("the folder can be written");
        path.to_string_lossy().into_owned()
    }

    pub fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).expect("the folder can be read");
        let mut names: Vec<String> =
            entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

pub fn trimline(arguments: &[&str]) -> Output {
    trimline_reading("", arguments)
}

fn trimline_reading(input: &str, arguments: &[&str]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_trimline"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    // A command that fails early does not read its input.
    let _ = child.stdin.take().expect("piped").write_all(input.as_bytes());
    child.wait_with_output().expect("the command ends")
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

pub fn status(output: &Output) -> i32 {
    output.status.code().expect("the command was not killed")
}

pub fn done(output: &Output) -> String {
    assert_eq!(status(output), 0, "{}", text(&output.stderr));
    text(&output.stdout)
}

pub fn example(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name).to_string_lossy().into_owned()
}

const COMPLETE: &str = "at u = 0: S = [cos v, sin v, 1], ∂S/∂u = [0, 0, -1]\n\
                        at u = 1: S = [2 cos v, 2 sin v, 0], ∂S/∂u = [cos v, sin v, 0]\n";

#[test]
fn bad_input_has_its_status_and_leaves_nothing() {
    let complete = COMPLETE;
    let cases: &[(&str, Vec<u8>, i32, &str)] = &[
        ("unknown name", b"at u = 0: S_x = kv".to_vec(), 1, "did you mean"),
        ("u in boundary data", b"at u = 0: S_x = sinh(v + u)".to_vec(), 1, "depends on `u`"),
        ("twice", format!("{complete}at u = 1: S_y = 0").into_bytes(), 1, "given twice"),
        ("missing", complete.replace("S = [2 cos v, 2 sin v, 0]", "S_x = 1, S_z = 0").into_bytes(), 1, "S_y at u = 1"),
        ("wrong number", b"at u = 0: S = [1, 2, 3]".to_vec(), 1, "needs 4"),
        ("not linear", format!("pde S*S = 0\n{complete}").into_bytes(), 1, "not linear"),
        ("brackets", b"at u = 0: S_x = (1 + v".to_vec(), 1, "never closed"),
        ("infinite param", format!("param b1 = 1, x = 1/(b1-b1)\n{complete}").into_bytes(), 1, "infinity"),
        ("NaN param", format!("param x = log(-1)\n{complete}").into_bytes(), 1, "NaN"),
        (
            "pole",
            complete.replace("cos v, sin v, 1", "1/v, sin v, 1").into_bytes(),
            1,
            "`1/v` (S_x at u = 0) is inf at v = 0",
        ),
        ("domain that overflows", format!("domain t in [-1e308, 1e308]\n{complete}").into_bytes(), 1, "is no number"),
        ("empty domain", format!("domain v in [1, 1]\n{complete}").into_bytes(), 1, "is empty"),
        ("empty file", Vec::new(), 1, "states nothing"),
        ("not UTF-8", b"param a = \xff".to_vec(), 1, "not UTF-8"),
        ("deep", format!("at u = 0: S_x = {}1{}", "(".repeat(10_000), ")".repeat(10_000)).into_bytes(), 4, "`nesting`"),
        ("large", vec![b'#'; 2 << 20], 4, "`source-bytes`"),
        ("explosion", complete.replace("sin v, 1]", "(1+v+sin t)^200, 1]").into_bytes(), 4, "`monomials`"),
        ("no terms", format!("{complete}solve sine, terms = 0").into_bytes(), 1, "terms is 0"),
        ("no grid", format!("{complete}solve sine, points = 0 x 5").into_bytes(), 1, "no points"),
        ("large grid", format!("{complete}solve sine, points = 100000 x 100000").into_bytes(), 4, "`samples`"),
    ];
    for (name, spec, expected, fragment) in cases {
        let folder = Folder::new();
        let spec = folder.spec(spec);
        let target = folder.path("out.obj").to_string_lossy().into_owned();
        let output = trimline(&["mesh", &spec, "-o", &target]);
        let errors = text(&output.stderr);
        assert_eq!(status(&output), *expected, "{name}: {errors}");
        assert!(errors.contains(fragment), "{name}: {errors}");
        assert!(errors.contains("spec.trim:") || *name == "large", "{name} has no place: {errors}");
        assert!(output.stdout.is_empty(), "{name}");
        assert_eq!(folder.files(), ["spec.trim"], "{name}");
    }
}

#[test]
fn bad_options_have_their_status_and_leave_nothing() {
    let cases: &[(&[&str], i32, &str)] = &[
        (&["--grid", "0x5"], 2, "no quads"),
        (&["--grid", "100000x100000"], 4, "samples"),
        (&["--grid", "many"], 2, "not a grid"),
        (&["--terms", "0", "--method", "sine"], 2, "--terms"),
        (&["--terms", "5", "--method", "exact"], 2, "no setting `terms`"),
        (&["--points", "0x5", "--method", "sine"], 2, "no points"),
        (&["--method", "magic"], 2, "no method"),
        (&["--set", "q=1"], 2, "no param"),
        (&["--set", "gamma=1/0"], 2, "infinity"),
        (&["--set", "gamma"], 2, "NAME=EXPR"),
        (&["--patch", "other"], 2, "no patch"),
        (&["--time", "7"], 2, "outside"),
        (&["--time", "1e300"], 2, "t = 1e300 lies outside"),
        (&["--time", "-7"], 2, "t = -7 lies outside"),
        (&["--grid", "-1x4"], 2, "`-1x4` is not a grid"),
        (&["--frames", "-1"], 2, "'-1' for '--frames <N>': write a whole number"),
        (&["--terms", "-1"], 2, "--terms"),
        (&["--terms", "-1", "--method", "sine"], 2, "`-1` is not a number of terms"),
        (&["--modes", "-1", "--method", "fourier"], 2, "`-1` is not a number of modes"),
        (&["--tolerance", "-1"], 2, "the tolerance -1 lies outside"),
        (&["--points", "-1x4"], 2, "`-1x4` is not a grid"),
        (&["--frames", "0"], 2, "frames"),
        (&["--limits", "nesting=0"], 4, "nesting"),
        (&["--tolerance", "nan"], 2, "the tolerance NaN lies outside"),
        (&["--method", "legendre", "--terms", "x"], 2, "`x` is not a number of terms"),
        (&["--limits", "size=3"], 2, "no limit"),
        (&["--what"], 2, "--what"),
    ];
    for (options, expected, fragment) in cases {
        let folder = Folder::new();
        let spec = folder.spec(COMPLETE);
        let target = folder.path("out.obj").to_string_lossy().into_owned();
        let mut arguments = vec!["mesh", &spec, "-o", &target];
        arguments.extend(*options);
        let output = trimline(&arguments);
        let errors = text(&output.stderr);
        assert_eq!(status(&output), *expected, "{options:?}: {errors}");
        assert!(errors.contains(fragment), "{options:?}: {errors}");
        assert!(output.stdout.is_empty(), "{options:?}");
        assert_eq!(folder.files(), ["spec.trim"], "{options:?}");
    }
}

#[test]
fn a_missing_spec_is_wrong_usage() {
    let output = trimline(&["check", "no-such-file.trim"]);
    assert_eq!(status(&output), 2);
    assert!(text(&output.stderr).contains("no-such-file.trim"));
}

#[test]
fn an_unwritable_target_is_the_machines_fault() {
    let folder = Folder::new();
    let target = folder.path("no-such-folder/out.obj").to_string_lossy().into_owned();
    assert_eq!(status(&trimline(&["mesh", &folder.spec(COMPLETE), "-o", &target])), 5);
}

#[test]
fn an_existing_file_is_kept_when_the_command_fails() {
    let folder = Folder::new();
    let target = folder.path("out.obj");
    std::fs::write(&target, "precious").expect("the folder can be written");
    let spec = folder.spec("at u = 0: S_x = 1");
    assert_eq!(status(&trimline(&["mesh", &spec, "-o", &target.to_string_lossy()])), 1);
    assert_eq!(std::fs::read_to_string(&target).expect("still there"), "precious");
}

#[test]
fn surface_of_auto_that_does_not_solve_its_equation_is_warned_of_by_every_command() {
    let folder = Folder::new();
    let spec = folder.spec("at u = 0: S = [1/(0.05 + v), v, 0], dS/du = 0\nat u = 1: S = [v, 1, 2], dS/du = [0, 0, 1]");
    let target = folder.path("out.obj").to_string_lossy().into_owned();
    let mesh = trimline(&["mesh", &spec, "-o", &target, "--grid", "2x2"]);
    for output in [trimline(&["solve", &spec]), trimline(&["check", &spec]), mesh] {
        assert_eq!(text(&output.stderr).matches("W0417").count(), 1, "{}", text(&output.stderr));
    }
    // More terms were not tried, and not for lack of use.
    let limited = trimline(&["solve", &spec, "--limits", "operations=100000"]);
    let told = text(&limited.stderr);
    assert!(
        told.contains("W0417") && told.contains("above the limit `operations` of 100000: `--limits` raises it"),
        "{told}"
    );
    // Whoever names the method judges for himself.
    assert!(!text(&trimline(&["solve", &spec, "--method", "legendre"]).stderr).contains("W0417"));
}

#[test]
fn colours_appear_only_when_asked_for() {
    let folder = Folder::new();
    let spec = folder.spec("at u = 0: S_x = kv");
    assert!(!text(&trimline(&["check", &spec]).stderr).contains('\u{1b}'));
    assert!(text(&trimline(&["check", &spec, "--color", "always"]).stderr).contains('\u{1b}'));
}

#[test]
fn derivative_asked_for_twice_is_wrong_usage() {
    let output =
        trimline_reading("u,v\n0,0\n", &["eval", &example("eq19.trim"), "--points", "-", "--derivatives", "uv,u,vu"]);
    assert_eq!(status(&output), 2);
    assert!(text(&output.stderr).contains("`uv` is asked for twice"), "{}", text(&output.stderr));
}

/// abs has no second derivative, so `fourier` is chosen, and its series leaves nothing out at t = 0 but much at t = 1.
#[test]
fn warning_of_a_later_instant_is_given_once() {
    let spec = "at u = 0: S = [cos v, sin v, t abs(sin v)], ∂S/∂u = [0, 0, 1]\n\
                at u = 1: S = [cos v, sin v, 2], ∂S/∂u = [0, 0, 1]\nsolve fourier, modes = 8";
    let errors = text(&trimline_reading(spec, &["check", "-"]).stderr);
    assert_eq!(errors.matches("W0414").count(), 1, "{errors}");
    let errors = text(&trimline_reading(spec, &["check", "-", "--time", "0"]).stderr);
    assert_eq!(errors.matches("W0414").count(), 0, "{errors}");
}

#[test]
fn coefficients_stand_in_columns_and_only_zeros_read_0() {
    let spec = "at u = 0: S = [1e-9 sin v, -25 sin v, 0], ∂S/∂u = 0\nat u = 1: S = [sin v, 0, 0], ∂S/∂u = 0";
    let solution = done(&trimline_reading(spec, &["solve", "-"]));
    let first =
        solution.lines().find(|line| line.trim_start().starts_with("b ")).unwrap_or_else(|| panic!("{solution}"));
    assert_eq!(first, "  b        1.000000e-9    -25.000000       0", "{solution}");
}

#[test]
fn points_evaluate_at_the_constraints_themselves_on_the_boundary() {
    let output = trimline_reading(
        "name,u,v,t\na,0,0,0.1\nb,1,0,0.2\n",
        &["eval", &example("eq19.trim"), "--points", "-", "--derivatives", "u,vv"],
    );
    let csv = done(&output);
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("name,u,v,t,x,y,z,x_u,y_u,z_u,x_vv,y_vv,z_vv"));
    let row: Vec<&str> = lines.next().expect("the first row").split(',').collect();
    assert_eq!(row[..4], ["a", "0", "0", "0.1"]);
    let values: Vec<f64> = row[4..].iter().map(|value| value.parse().expect("a number")).collect();
    let y = (-0.1_f64).exp();
    for (value, expected) in values.iter().zip([0.0, y, 2.0, 0.0, 0.0, -3.0, 0.0, -y, 0.0]) {
        // One exponential and one product.
        assert!((value - expected).abs() <= 4.0 * f64::EPSILON, "{csv}");
    }
    assert_eq!(lines.count(), 1);
}

#[test]
fn a_grid_beside_the_file_of_points_sets_the_collocation() {
    let run = |options: &[&str]| {
        let spec = example("eq19.trim");
        let mut arguments = vec!["eval", &spec, "--points", "-"];
        arguments.extend(options);
        done(&trimline_reading("u,v\n0.5,1\n", &arguments))
    };
    assert_eq!(run(&[]), run(&["--points", "11x11"]));
    assert_ne!(run(&[]), run(&["--points", "11x11:ends"]));
}

#[test]
fn bad_points_name_line_and_column() {
    let spec = example("eq19.trim");
    let cases = [
        ("u\n0.5\n", "no column `v`"),
        ("u,v\n0.5,one\n", "line 2: `one` in column `v`"),
        ("u,v\n0.5,1\n1.5,1\n", "line 3: u = 1.5 lies outside"),
        ("u,v,u\n0,0,0\n", "`u` occurs twice"),
        ("u,v\n0.5\n", "line"),
        ("u,v\n0.5,NaN\n", "outside"),
        ("", "no column"),
        ("u,v,y\n0,0,0\n", "a column is called `y`"),
        ("u;v\n0;6.2831853072\n", "line 2: v = 6.2831853072 lies outside"),
    ];
    for (points, fragment) in cases {
        let output = trimline_reading(points, &["eval", &spec, "--points", "-"]);
        let errors = text(&output.stderr);
        assert_eq!(status(&output), 1, "{points:?}: {errors}");
        assert!(errors.contains(fragment), "{points:?}: {errors}");
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn points_are_separated_as_their_first_line_shows_and_may_have_comments() {
    let evaluated = |points: &str| done(&trimline_reading(points, &["eval", &example("eq19.trim"), "--points", "-"]));
    let expected = evaluated("u,v\n0.25,1\n1,0\n");
    let with_comments = evaluated("# measured\n\nu,v\n0.25,1\n# the rim\n1,0\n");
    assert_eq!(with_comments, expected);
    for separator in [";", "\t"] {
        let points = format!("u{separator}v\n0.25{separator}1\n1{separator}0\n");
        assert_eq!(evaluated(&points).replace(separator, ","), expected);
    }
}

#[test]
fn point_that_rounding_puts_outside_lies_on_the_end() {
    let evaluated = |points: &str| {
        let table = done(&trimline_reading(points, &["eval", &example("eq19.trim"), "--points", "-"]));
        table.lines().nth(1).expect("a row").splitn(3, ',').nth(2).expect("values").to_owned()
    };
    assert_eq!(evaluated("u,v\n1.0000000000000002,0\n"), evaluated("u,v\n1,0\n"));
    assert_eq!(evaluated("u,v\n0,6.283185307179587\n"), evaluated("u,v\n0,6.283185307179586\n"));
}

#[test]
fn the_spec_may_come_from_standard_input() {
    let from_file = done(&trimline(&["basis", &example("eq6.trim")]));
    let spec = std::fs::read_to_string(example("eq6.trim")).expect("the example exists");
    let from_input = done(&trimline_reading(&spec, &["basis", "-"]));
    assert_eq!(from_file.replace("`eq6`", "`standard input`"), from_input);
}

#[test]
fn json_has_the_keys_scripts_rely_on() {
    let json = |command: &str| -> Value {
        let output = done(&trimline(&[command, &example("eq19.trim"), "--format", "json"]));
        serde_json::from_str(&output).expect("valid JSON")
    };
    let basis = json("basis");
    let patch = &basis["patches"][0];
    assert_eq!(patch["name"], "eq19");
    assert_eq!(patch["basis"].as_array().map(Vec::len), Some(5));
    assert_eq!(patch["basis"][0]["derivatives"]["vv"], "-exp(t)*sin(v)");
    assert_eq!(patch["conditions"][0]["symbol"], "b");
    assert_eq!(patch["conditions"][0]["values"][0], serde_json::json!([1.6, 0.0, 0.0]));
    let solve = json("solve");
    let patch = &solve["patches"][0];
    for key in
        ["method", "exact", "basis_size", "closure_size", "modes", "amplification", "condition", "rank", "warnings"]
    {
        assert!(patch.get(key).is_some(), "{key}");
    }
    assert!(patch["boundary_error"].as_f64().expect("a number") <= 1e-12);
    assert!(patch["seconds"]["solve"].as_f64().expect("a number") >= 0.0);
    let check = json("check");
    assert_eq!(check["passed"], true);
    assert_eq!(check["patches"][0]["boundaries"].as_array().map(Vec::len), Some(4));
}

#[test]
fn a_gap_above_the_allowed_one_fails_the_check() {
    let output = trimline(&["check", &example("eq19.trim"), "--max-gap", "0"]);
    assert_eq!(status(&output), 1);
    assert!(text(&output.stdout).contains("not passed"));
    assert_eq!(status(&trimline(&["check", &example("eq19.trim"), "--max-gap", "1e-12"])), 0);
}

#[test]
fn a_set_coefficient_changes_the_surface_and_a_set_param_its_boundary() {
    let x = |options: &[&str]| {
        let spec = example("eq19.trim");
        let mut arguments = vec!["eval", &spec, "--points", "-"];
        arguments.extend(options);
        let csv = done(&trimline_reading("u,v\n0,1\n0.5,1\n", &arguments));
        let column = |line: &str| line.split(',').nth(2).expect("x").to_owned();
        csv.lines().skip(1).map(column).collect::<Vec<String>>()
    };
    let (plain, coefficient, param) = (x(&[]), x(&["--set", "γ=20"]), x(&["--set", "a=2*0.9"]));
    assert_eq!(plain[0], coefficient[0]);
    assert_ne!(plain[1], coefficient[1]);
    assert_eq!(param[0].parse::<f64>().expect("a number"), 1.8 * 1.0_f64.sin());
}

#[test]
fn quiet_says_nothing_on_success() {
    let output = trimline(&["solve", &example("eq19.trim"), "--quiet"]);
    done(&output);
    assert!(output.stderr.is_empty());
}

#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_trimline"))
        .args(["solve", &example("eq29_30.trim"), "--format", "json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the command ends");
    assert!(!text(&output.stderr).contains("panicked"), "{}", text(&output.stderr));
}

#[test]
fn published_values_of_eq19_come_out_of_eval() {
    let vectors = |value: &Value| -> Vec<Vec<f64>> {
        let rows = value.as_array().expect("rows").iter();
        rows.map(|row| row.as_array().expect("a row").iter().map(|x| x.as_f64().expect("a number")).collect()).collect()
    };
    for case in ["K5_mid", "K5_end", "K7_mid", "K7_end", "K10_mid", "K10_end"] {
        let path = format!("{}/tests/reference/eq19_sine_{case}.json", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("a reference file");
        let reference: Value = serde_json::from_str(&text).expect("JSON");
        let terms = reference["settings"]["terms"].to_string();
        let points = reference["settings"]["points"].as_str().expect("a grid");
        let lines = vectors(&reference["points"]).into_iter().map(|p| format!("{:?},{:?},{:?}\n", p[0], p[1], p[2]));
        let input = format!("u,v,t\n{}", lines.collect::<String>());
        let spec = example("eq19.trim");
        let output = trimline_reading(
            &input,
            &["eval", &spec, "--points", "-", "--points", points, "--terms", &terms, "--derivatives", "u,v"],
        );
        let csv = done(&output);
        let size = vectors(&reference["S"]).iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        let [s, s_u, s_v] = ["S", "S_u", "S_v"].map(|key| vectors(&reference[key]));
        assert_eq!(csv.lines().count(), s.len() + 1);
        for (index, line) in csv.lines().skip(1).enumerate() {
            let found = line.split(',').skip(3).map(|cell| cell.parse::<f64>().expect("a number"));
            let expected = s[index].iter().chain(&s_u[index]).chain(&s_v[index]);
            for (found, expected) in found.zip(expected) {
                // The bound stated with the values.
                assert!((found - expected).abs() <= 1e-10 * size, "{case}: {line}");
            }
        }
    }
}

#[test]
fn solve_prints_every_function_the_surface_is_made_of() {
    for (name, method) in [("eq6.trim", "exact"), ("p1_ex1.trim", "static_blend")] {
        let output = done(&trimline(&["solve", &example(name), "--method", method, "--format", "json"]));
        let solution: Value = serde_json::from_str(&output).expect("valid JSON");
        let patch = &solution["patches"][0];
        let functions = patch["coefficients"].as_array().expect("functions");
        assert!(functions.len() > patch["basis_size"].as_u64().expect("a number") as usize, "{name}");
        let terms = functions.iter().flat_map(|function| function["terms"].as_array().expect("terms"));
        assert!(terms.flat_map(|term| term.as_array().expect("x, y, z")).any(|x| x.as_f64() != Some(0.0)), "{name}");
    }
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_a_folder_is_left_alone() {
    let folder = Folder::new();
    let spec = folder.spec(COMPLETE);
    let (target, link) = (folder.path("target.obj"), folder.path("link.obj"));
    std::fs::write(&target, "old").expect("the folder can be written");
    std::os::unix::fs::symlink(&target, &link).expect("a link can be made");
    done(&trimline(&["mesh", &spec, "-o", &link.to_string_lossy(), "--grid", "2x4"]));
    assert!(link.is_symlink() && std::fs::read_to_string(&target).expect("written").contains("o spec"));

    // The third frame cannot be written, so none is.
    std::fs::create_dir(folder.path("a.0002.obj")).expect("the folder can be written");
    let output = trimline(&["mesh", &spec, "-o", &folder.path("a.obj").to_string_lossy(), "--frames", "4"]);
    assert_eq!(status(&output), 2, "{}", text(&output.stderr));
    assert_eq!(folder.files(), ["a.0002.obj", "link.obj", "spec.trim", "target.obj"]);
}

#[test]
fn series_is_reported_with_what_it_leaves_out() {
    let spec = example("p3_tangents.trim");
    let solved = trimline(&["solve", &spec, "--modes", "3", "--format", "json"]);
    let report: Value = serde_json::from_str(&done(&solved)).expect("JSON");
    let patch = &report["patches"][0];
    assert_eq!(
        (patch["method"].as_str(), patch["modes"].as_u64(), patch["exact"].as_bool()),
        (Some("fourier"), Some(3), Some(false))
    );
    let left_out = patch["truncation"].as_f64().expect("a number");
    let second = &patch["coefficients"][1];
    assert_eq!((second["basis"].as_str(), second["boundary"].as_array().map(Vec::len)), (Some("cos(v)"), Some(4)));
    // x = 0.8 exp(0.3 cos 2v) cos v has the coefficient 0.8 (I_0(0.3) + I_1(0.3)) of cos v.
    let expected = 0.8 * (1.022_626_879_351_597 + 0.151_693_840);
    let found = second["boundary"][0][0].as_f64().expect("a number");
    assert!((found - expected).abs() < 1e-6, "{found} {expected}");
    let checked = trimline(&["check", &spec, "--modes", "3", "--remainder", "off", "--format", "json"]);
    let report: Value = serde_json::from_str(&done(&checked)).expect("JSON");
    let missed = report["patches"][0]["boundaries"].as_array().expect("boundaries").iter();
    let missed = missed.filter_map(|boundary| boundary["max_error"].as_f64()).fold(0.0, f64::max);
    assert!((missed / left_out - 1.0).abs() < 0.1, "{missed} {left_out}");
    assert!(text(&checked.stderr).contains("W0414"));
    assert_eq!(status(&trimline(&["check", &spec, "--remainder", "half"])), 2);
}
