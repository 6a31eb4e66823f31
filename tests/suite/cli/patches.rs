//! The command on documents of several patches: which it takes, and what it says of joins and seams.

use serde_json::Value;

use super::{Folder, done, status, text, trimline, trimline_reading};

const TWO: &str = "param r = 1
patch low { at u = 0: S = [r cos v, r sin v, 0], dS/du = [0, 0, 1]; at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1] }
patch high {
    domain u in [1, 2]
    at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]
    at u = 2: S = [cos v, sin v, 2], dS/du = [0, 0, 1]
}
";

#[test]
fn every_command_takes_all_patches_or_the_one_that_is_named() {
    let folder = Folder::new();
    let spec = folder.spec(TWO);
    for command in ["check", "basis", "solve"] {
        let names = |options: &[&str]| {
            let arguments = [&[command, &spec, "--format", "json", "--quiet"], options].concat();
            let report: Value = serde_json::from_str(&done(&trimline(&arguments))).expect("JSON");
            let patches = report["patches"].as_array().expect("patches").clone();
            patches.iter().map(|patch| patch["name"].as_str().expect("a name").to_owned()).collect::<Vec<_>>()
        };
        assert_eq!(names(&[]), ["low", "high"], "{command}");
        assert_eq!(names(&["--patch", "high"]), ["high"], "{command}");
        let output = trimline(&[command, &spec, "--patch", "middle"]);
        assert_eq!(status(&output), 2, "{command}");
        assert!(text(&output.stderr).contains("patches: low, high"), "{command}");
    }
}

#[test]
fn emit_takes_one_patch_and_names_those_there_are() {
    let folder = Folder::new();
    let spec = folder.spec(TWO);
    let output = trimline(&["emit", &spec, "--lang", "c"]);
    assert_eq!(status(&output), 2);
    assert!(text(&output.stderr).contains("patches: low, high"), "{}", text(&output.stderr));
    assert!(output.stdout.is_empty());
    let emitted = done(&trimline(&["emit", &spec, "--lang", "c", "--patch", "high"]));
    assert!(emitted.contains("high_surface(") && emitted.contains("u in [1.0, 2.0]"), "{emitted}");
}

#[test]
fn mesh_of_several_patches_has_an_object_for_each() {
    let folder = Folder::new();
    let (spec, target) = (folder.spec(TWO), folder.path("out.obj"));
    done(&trimline(&["mesh", &spec, "-o", &target.to_string_lossy(), "--grid", "2x4"]));
    let written = std::fs::read_to_string(&target).expect("a mesh");
    let objects: Vec<&str> = written.lines().filter_map(|line| line.strip_prefix("o ")).collect();
    assert_eq!(objects, ["low", "high"]);
}

#[test]
fn points_of_several_patches_name_theirs() {
    let folder = Folder::new();
    let spec = folder.spec(TWO);
    let run = |points: &str, options: &[&str]| {
        trimline_reading(points, &[&["eval", &spec, "--points", "-"], options].concat())
    };
    assert_eq!(
        done(&run("patch,u,v\nhigh,2,0\nlow,0,0\nhigh,1,0\n", &["--derivatives", "u"])),
        "patch,u,v,x,y,z,x_u,y_u,z_u\nhigh,2,0,1.0,0.0,2.0,0.0,0.0,1.0\nlow,0,0,1.0,0.0,0.0,0.0,0.0,1.0\n\
         high,1,0,1.0,0.0,1.0,0.0,0.0,1.0\n"
    );
    assert_eq!(done(&run("u,v\n2,0\n", &["--patch", "high"])), "u,v,x,y,z\n2,0,1.0,0.0,2.0\n");
    for (points, expected, fragment) in [
        ("u,v\n0,0\n", 2, "low, high"),
        ("patch,u,v\nmiddle,0,0\n", 1, "no patch `middle`"),
        ("patch,u,v\nhigh,0.5,0\n", 1, "outside the domain [1, 2]"),
        ("patch,u,v\n,0,0\n", 1, "no patch ``"),
    ] {
        let output = run(points, &[]);
        assert_eq!(status(&output), expected, "{points}");
        assert!(text(&output.stderr).contains(fragment), "{points}: {}", text(&output.stderr));
    }
    // A row of another patch than the one that is chosen is not evaluated on that one.
    let output = run("patch,u,v\nhigh,1,0\nlow,1,0\n", &["--patch", "high"]);
    assert_eq!(status(&output), 1);
    assert!(text(&output.stderr).contains("line 3: there is no patch `low` among"), "{}", text(&output.stderr));
}

#[test]
fn mesh_needs_an_instant_that_every_patch_has() {
    let folder = Folder::new();
    let target = folder.path("out.obj").to_string_lossy().into_owned();
    let apart = TWO.replace("domain u in [1, 2]", "domain u in [1, 2], t in [2, 3]");
    let output = trimline(&["mesh", &folder.spec(apart), "-o", &target]);
    assert_eq!((status(&output), folder.files()), (1, vec!["spec.trim".to_owned()]));
    let later = TWO.replace("domain u in [1, 2]", "domain u in [1, 2], t in [0.5, 3]");
    let output = trimline(&["mesh", &folder.spec(later), "-o", &target]);
    done(&output);
    assert!(text(&output.stderr).contains("at t = 0.5"), "{}", text(&output.stderr));
}

/// Patches that meet at a kink of 45 degrees, and a surface that the first joins.
const KINKED: &str = "surface A(u, v) = cylinder(u, v, 1, 1)
patch low { at u = 0: join A at u = 0; at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1] }
patch high {
    domain u in [1, 2]
    at u = 1: S = [cos v, sin v, 1], dS/du = [cos v, sin v, 1]
    at u = 2: S = [2 cos v, 2 sin v, 2], dS/du = [cos v, sin v, 1]
}
";

#[test]
fn check_reports_joins_and_seams() {
    let folder = Folder::new();
    let spec = folder.spec(KINKED);
    let report: Value = serde_json::from_str(&done(&trimline(&["check", &spec, "--format", "json"]))).expect("JSON");
    let join = &report["patches"][0]["joins"][0];
    assert_eq!((join["surface"].as_str(), join["u"].as_f64()), (Some("A"), Some(0.0)));
    assert!(join["gap"].as_f64().expect("a gap") < 1e-15 && join["tangent"].as_f64().expect("a difference") < 1e-15);
    assert!(join["angle_degrees"].as_f64().expect("an angle") < 1e-12);
    assert_eq!(report["patches"][1]["joins"].as_array().map(Vec::len), Some(0));
    let seams = report["seams"].as_array().expect("seams");
    assert_eq!(seams.len(), 1, "{seams:?}");
    assert_eq!(seams[0]["between"], serde_json::json!([{"patch": "low", "u": 1.0}, {"patch": "high", "u": 1.0}]));
    assert!((seams[0]["angle_degrees"].as_f64().expect("an angle") - 45.0).abs() < 1e-12);
    assert!(seams[0]["gap"].as_f64().expect("a gap") < 1e-15);
}

#[test]
fn check_fails_above_the_largest_angle_or_gap() {
    let folder = Folder::new();
    let spec = folder.spec(KINKED);
    for (options, expected) in
        [(["--max-angle", "46"], 0), (["--max-angle", "44"], 1), (["--max-gap", "1e-9"], 0), (["--max-angle", "-1"], 2)]
    {
        assert_eq!(status(&trimline(&[&["check", &spec], &options[..]].concat())), expected, "{options:?}");
    }
    assert_eq!(status(&trimline(&["check", &spec, "--max-angle", "44", "--patch", "low"])), 0);
    let apart = KINKED
        .replace("at u = 1: S = [cos v, sin v, 1], dS/du = [cos", "at u = 1: S = [cos v, sin v, 1.001], dS/du = [cos");
    assert_eq!(status(&trimline(&["check", &folder.spec(&apart)])), 0);
    assert_eq!(status(&trimline(&["check", &folder.spec(&apart), "--max-gap", "1e-4"])), 1);
}

#[test]
fn check_fails_at_a_stated_seam_that_is_open_and_says_where() {
    let folder = Folder::new();
    let open = format!("{KINKED}seam low at u = 0 with high at u = 2\n");
    let output = trimline(&["check", &folder.spec(open), "--format", "json"]);
    assert_eq!(status(&output), 1);
    let errors = text(&output.stderr);
    assert!(errors.contains("E0416") && errors.contains("spec.trim:8:1"), "{errors}");
    let report: Value = serde_json::from_str(&text(&output.stdout)).expect("JSON");
    assert_eq!(report["passed"], Value::Bool(false));
    let closed = format!("{KINKED}seam low at u = 1 with high at u = 1\n");
    assert_eq!(status(&trimline(&["check", &folder.spec(closed)])), 0);
}

#[test]
fn mesh_includes_primary_surfaces_over_their_own_ranges_when_asked() {
    let folder = Folder::new();
    let spec = folder.spec(KINKED.replace("cylinder(u, v, 1, 1)", "cylinder(u, v, 1, 1) with u in [-3, -2]"));
    let target = folder.path("out.obj");
    let objects = |options: &[&str]| {
        let target = target.to_string_lossy().into_owned();
        done(&trimline(&[&["mesh", &spec, "-o", &target, "--grid", "2x4"], options].concat()));
        std::fs::read_to_string(&target).expect("a mesh")
    };
    let names =
        |text: &str| text.lines().filter_map(|line| line.strip_prefix("o ").map(str::to_owned)).collect::<Vec<_>>();
    assert_eq!(names(&objects(&[])), ["low", "high"]);
    let with = objects(&["--with-surfaces"]);
    assert_eq!(names(&with), ["low", "high", "A"]);
    let (_, cylinder) = with.split_once("o A\n").expect("the surface");
    let heights = cylinder.lines().filter_map(|line| line.strip_prefix("v ")?.split(' ').nth(2)?.parse::<f64>().ok());
    let (low, high) = heights.fold((f64::MAX, f64::MIN), |(low, high), z| (low.min(z), high.max(z)));
    assert_eq!((low, high), (-3.0, -2.0));
}

/// A square with data on four sides, and one with data on two.
const SIDES: &str = "patch square {
    at u = 0: S = [0, v, 0], dS/du = [1, 0, 0]
    at u = 1: S = [1, v, 0], dS/du = [1, 0, 0]
    at v = 0: S = [u, 0, 0], dS/dv = [0, 1, 0]
    at v = 1: S = [u, 1, 0], dS/dv = [0, 1, 0]
}
patch strip {
    at u = 0: S = [0, v, 0], dS/du = [1, 0, 0]
    at u = 1: S = [1, v, 0], dS/du = [1, 0, 0]
}
domain v in [0, 1]
";

#[test]
fn basis_of_four_sides_is_said_to_be_none_and_the_data_are_printed() {
    let printed = done(&trimline_reading(SIDES, &["basis", "-"]));
    let (square, strip) = printed.split_once("basis of `strip`").expect("both patches");
    assert!(
        square.starts_with("basis of `square`: none, data on four sides are interpolated and not factored\n"),
        "{square}"
    );
    assert!(square.contains("\nS at u = 0\n  [0, v, 0]\n"), "{square}");
    assert!(square.contains("\n∂S/∂v at v = 1\n  [0, 1, 0]\n"), "{square}");
    assert!(!square.contains("F_j"), "{square}");
    assert!(strip.contains(": 2 functions"), "{strip}");
    let arguments = ["basis", "-", "--format", "json", "--closure"];
    let json: Value = serde_json::from_str(&done(&trimline_reading(SIDES, &arguments))).expect("JSON");
    let [square, strip] = [&json["patches"][0], &json["patches"][1]];
    let sides = square["sides"].as_array().expect("sides");
    assert_eq!(sides.len(), 8);
    assert_eq!(sides[1], serde_json::json!({"u": "0", "order": 1, "value": ["1", "0", "0"]}));
    assert_eq!(sides[6], serde_json::json!({"v": "1", "order": 0, "value": ["u", "1", "0"]}));
    assert_eq!((square["conditions"].as_array().map(Vec::len), square.get("closure")), (Some(0), None));
    assert!(strip.get("sides").is_none() && strip["conditions"].as_array().map(Vec::len) == Some(4), "{strip}");
    let latex = done(&trimline_reading(SIDES, &["basis", "-", "--format", "latex"]));
    assert!(latex.contains(r"\left.\mathbf{S}\right|_{v = 1} &= \begin{bmatrix} u \\ 1 \\ 0 \end{bmatrix}"), "{latex}");
}
