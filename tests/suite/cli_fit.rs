//! `trimline fit` as its users run it.

use serde_json::Value;

use trimline::limits::Limits;
use trimline::surface::BsplineSurface;
use trimline::surface::bspline::from_json;

use crate::cli::{self, Folder, done, example, status, trimline};

#[test]
fn fit_writes_every_format_and_says_how_close_it_is() {
    for extension in ["step", "stp", "igs", "iges", "json"] {
        let folder = Folder::new();
        let target = folder.path(&format!("part.{extension}")).to_string_lossy().into_owned();
        let output = trimline(&["fit", &example("eq19.trim"), "-o", &target, "--tolerance", "1e-4", "--time", "0.2"]);
        assert!(done(&output).is_empty(), "the report for people goes to standard error");
        let said = cli::text(&output.stderr);
        assert!(said.contains("closed in v; largest deviation") && said.contains("of 1.0e-4 allowed"), "{said}");
        assert_eq!(folder.files(), [format!("part.{extension}")]);
    }
}

#[test]
fn report_as_json_agrees_with_the_file() {
    let folder = Folder::new();
    let target = folder.path("part.json");
    let name = target.to_string_lossy().into_owned();
    let options = ["--tolerance", "1e-5", "--degree", "5", "--format", "json"];
    let output = done(&trimline(&[&["fit", &example("eq19.trim"), "-o", &name], &options[..]].concat()));
    let report: Value = serde_json::from_str(&output).expect("JSON");
    let patch = &report["patches"][0];
    let read = from_json(&std::fs::read_to_string(target).expect("written"), &Limits::default()).expect("a surface");
    let [(read_name, surface)] = read.as_slice() else { panic!("one patch") };
    assert_eq!(patch["name"].as_str(), Some(read_name.as_str()));
    let points = surface.knots().map(|knots| knots.points());
    assert_eq!(patch["control_points"], serde_json::json!(points));
    assert_eq!(patch["degree"], 5);
    assert_eq!(patch["closed_in_v"], true);
    assert!(patch["deviation"].as_f64().expect("a number") <= 1e-5);
}

/// A patch at early and one at late instants, with ranges of t.
fn patches_at(times: [&str; 2]) -> String {
    let patch = |name: &str, times: &str, height: &str| {
        format!(
            "patch {name} {{ domain v in [0, 1], t in {times}\n at u = 0: S = [0, v, {height}], dS/du = [1, 0, 0]\n \
             at u = 1: S = [1, v, 0], dS/du = [1, 0, 0] }}\n"
        )
    };
    // The root of the second is real from t = 2 on only.
    patch("early", times[0], "0") + &patch("late", times[1], "sqrt(t - 2)")
}

#[test]
fn patches_are_fitted_at_an_instant_of_all_or_refused_with_their_times() {
    let cases: &[([&str; 2], &[&str], i32, &str)] = &[
        (["[0, 1]", "[2, 3]"], &[], 1, "`early` has t in [0, 1], `late` has t in [2, 3]"),
        (["[0, 3]", "[2, 4]"], &["--time", "1"], 2, "t = 1 lies outside the time domain [2, 4] of `late`"),
        (["[0, 3]", "[2, 4]"], &["--time", "3.5"], 2, "t = 3.5 lies outside the time domain [0, 3] of `early`"),
        (["[0, 3]", "[2, 4]"], &[], 0, "late at t = 2"),
    ];
    for (times, options, expected, words) in cases {
        let folder = Folder::new();
        let spec = folder.path("two.trim");
        std::fs::write(&spec, patches_at(*times)).expect("written");
        let [spec, target] = [spec, folder.path("two.json")].map(|path| path.to_string_lossy().into_owned());
        let output = trimline(&[&["fit", &spec, "-o", &target], *options].concat());
        let said = cli::text(&output.stderr);
        assert_eq!(status(&output), *expected, "{times:?} {options:?}: {said}");
        assert!(said.contains(words), "{times:?} {options:?}: {said}");
    }
}

#[test]
fn copy_of_a_net_is_the_image_of_its_points_and_sews_to_it() {
    let folder = Folder::new();
    let spec = folder.path("mirrored.trim");
    let net = "bspline un { net 5 x 5 from [j (1 + 0.1 i), i (1 + 0.2 j), 0.4 sin(j) cos(i/2)] }\nmirror un in y = 0\n";
    std::fs::write(&spec, net).expect("written");
    let [json, step] = ["un.json", "un.step"].map(|name| folder.path(name));
    for target in [&json, &step] {
        let [spec, target] = [&spec, target].map(|path| path.to_string_lossy().into_owned());
        done(&trimline(&["fit", &spec, "-o", &target]));
    }
    let read = from_json(&std::fs::read_to_string(json).expect("written"), &Limits::default()).expect("surfaces");
    let [(_, original), (_, copy)] = read.as_slice() else { panic!("two patches") };
    assert_eq!(original.knots(), copy.knots());
    let mirrored: Vec<[f64; 3]> = original.net().iter().map(|[x, y, z]| [*x, -y, *z]).collect();
    assert_eq!(copy.net(), mirrored);
    let step = std::fs::read_to_string(step).expect("written");
    let count = |entity: &str| step.matches(entity).count();
    assert_eq!([count("OPEN_SHELL("), count("EDGE_CURVE(")], [1, 7], "of eight sides two are one");
}

/// Loops of three, four and five edges, whose patches meet in spokes: u = 1 of one is v = 1 of the next.
const LOOPS: [(usize, &str); 3] = [
    (3, "edge [u, 0, 0.3u(1-u)]\nedge [1 - u/2, u, 0]\nedge [(1-u)/2, 1-u, 0.2 u (1 - u)]"),
    (4, "edge [u, 0, -u^2 (1 - u)^2]\nedge [1, u, 0]\nedge [1 - u, 1, 0.2 u (1 - u)]\nedge [0, 1 - u, 0]"),
    (
        5,
        "edge [u, 0, 0]\nedge [1 + u/2, u, 0]\nedge [1.5 - u, 1 + u/2, sin(u) (1 - u)]\nedge [0.5 - u, 1.5 - u/2, 0]\n\
         edge [-0.5 + u/2, 1 - u, 0]",
    ),
];

#[test]
fn patches_of_a_loop_sew_into_one_shell_and_have_their_spokes_bit_for_bit() {
    for (count, edges) in LOOPS {
        let folder = Folder::new();
        let spec = folder.path("loop.trim");
        std::fs::write(&spec, format!("nsided cap {{\n{edges}\n}}\n")).expect("written");
        let [json, step] = ["loop.json", "loop.step"].map(|name| folder.path(name));
        for target in [&json, &step] {
            let [spec, target] = [&spec, target].map(|path| path.to_string_lossy().into_owned());
            done(&trimline(&["fit", &spec, "-o", &target]));
        }
        let step = std::fs::read_to_string(step).expect("written");
        let found = ["OPEN_SHELL(", "ADVANCED_FACE(", "EDGE_CURVE("].map(|entity| step.matches(entity).count());
        // A spoke for each edge, and two halves of each edge.
        assert_eq!(found, [1, count, 3 * count]);
        let read = from_json(&std::fs::read_to_string(json).expect("written"), &Limits::default()).expect("surfaces");
        let sides = |surface: &BsplineSurface| {
            let turned = surface.transposed();
            let ends = |surface: &BsplineSurface| {
                [surface.rows().next(), surface.rows().next_back()].map(|row| row.expect("a row").to_vec())
            };
            [ends(surface), ends(&turned)].concat()
        };
        let sides: Vec<_> = read.iter().flat_map(|(_, surface)| sides(surface)).collect();
        let is_one = |one: &Vec<[f64; 3]>, other: &Vec<[f64; 3]>| one == other || one.iter().rev().eq(other);
        let pairs = sides.iter().enumerate().flat_map(|(i, one)| sides[i + 1..].iter().map(move |other| (one, other)));
        assert_eq!(pairs.filter(|(one, other)| is_one(one, other)).count(), count, "spokes");
    }
}

#[test]
fn surfaces_without_area_are_refused_as_faults_of_the_spec() {
    let specs = [
        "at u = 0: S = [5, 0, 0], dS/du = [0, 0, 0]\nat u = 1: S = [5, 0, 0], dS/du = [0, 0, 0]",
        "domain v in [0, 1]\nat u = 0: S = [v, 0, 0], dS/du = [0, 0, 0]\nat u = 1: S = [v, 0, 0], dS/du = [0, 0, 0]",
        "bspline s { net 5 x 3 from [0, 0, 0] }",
    ];
    for spec in specs {
        let folder = Folder::new();
        let path = folder.path("thin.trim");
        std::fs::write(&path, spec).expect("written");
        let path = path.to_string_lossy().into_owned();
        for (command, file) in [("fit", "thin.step"), ("fit", "thin.json"), ("mesh", "thin.stl")] {
            let target = folder.path(file).to_string_lossy().into_owned();
            let output = trimline(&[command, &path, "-o", &target]);
            let said = cli::text(&output.stderr);
            assert_eq!(status(&output), 1, "{command} {spec}: {said}");
            assert!(said.contains("error[E0611]") && said.contains("has no area"), "{command} {spec}: {said}");
            assert_eq!(folder.files(), ["thin.trim"], "{command} {spec}");
        }
    }
}

#[test]
fn bad_requests_have_their_status_and_leave_nothing() {
    let cases: &[(&str, &[&str], i32, &str)] = &[
        ("part.obj", &[], 2, "write .step, .stp, .igs, .iges, .json"),
        ("part", &[], 2, "has no extension"),
        ("part.step", &["--degree", "2"], 2, "use degree 3, 4 or 5"),
        ("part.step", &["--tolerance", "0"], 2, "no positive length"),
        ("part.step", &["--tolerance", "1e-30"], 2, "below the rounding"),
        ("part.step", &["--tolerance", "1e-12", "--limits", "control-points=500"], 4, "`control-points` of 500"),
        ("part.step", &["--time", "7"], 2, "outside the time domain"),
        ("part.step", &["--schema", "ap203"], 2, "ap203"),
    ];
    for (name, options, expected, words) in cases {
        let folder = Folder::new();
        let target = folder.path(name).to_string_lossy().into_owned();
        let output = trimline(&[&["fit", &example("eq19.trim"), "-o", &target], *options].concat());
        let said = cli::text(&output.stderr);
        assert_eq!(status(&output), *expected, "{options:?}: {said}");
        assert!(said.contains(words), "{options:?}: {said}");
        assert!(output.stdout.is_empty(), "{options:?}");
        assert_eq!(folder.files(), Vec::<String>::new(), "{options:?}");
    }
}

#[test]
fn bad_nets_and_imports_are_one_error_and_nothing_is_written() {
    let net = |inside: &str| format!("bspline b {{\n{inside}\n}}\n");
    let from_formula = |knots: &str| net(&format!("knots {knots} in u\nnet 5 x 5 from [i, j, 0]"));
    let table = |rows: &str| (net("net 3 x 3 from points(\"part.csv\")"), "part.csv", rows.to_owned());
    let import = |name: &'static str, face: &str, contents: &str| {
        let declared = format!("surface A = bspline(\"{name}\"{face})\ndomain v in [0, 1]\n");
        let text = declared + "at u = 0: S = A(1, v), ∂S/∂u = 0\nat u = 1: S = [v, 3, 0], ∂S/∂u = 0\n";
        (text, name, contents.to_owned())
    };
    let plain = |text: String| (text, "part.csv", String::new());
    let flat = r#"{"patches":[{"name":"p","degree":[1,1],"knots_u":[0,0,1,1],"knots_v":[0,0,1,1],"control_net":[[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]]}]}"#;
    let point = "0,0,0\n";
    for ((text, name, contents), words) in [
        (plain(net("net 2 x 5 from [i, j, 0]")), "error[E0603]"),
        (plain(net("net 5 x 5")), "error[E0"),
        (table(&point.repeat(15)), "error[E0222]: part.csv: a net 3 x 3 has 16 points, and it holds 15"),
        (plain(from_formula("[0, 0, 0, 0, 1, 1, 2, 2, 2, 2]")), "error[E0602]: the knot 1 of u stands 2 times"),
        (plain(from_formula("[0, 0, 0, 0, 2, 1, 3, 3, 3, 3]")), "error[E0601]: the knots descend from 2 to 1"),
        (plain(net("net 5 x 5 from [1/(i - 1), j, 0]")), "error[E0604]: the control point P(1, 0) is [inf, 0, 0]"),
        (
            table(&(point.repeat(4) + "0,1e999,0\n")),
            "error[E0222]: part.csv: row 5, column y: `1e999` is not a finite number",
        ),
        (table(&(point.repeat(2) + "0,0\n")), "error[E0222]: part.csv: row 3 has no column z"),
        (
            import("part.step", "", "ISO-10303-21;\nDATA;\n#1=PLANE('',#2);\nENDSEC;\nEND-ISO-10303-21;\n"),
            "error[E0609]: part.step: the STEP file has no face",
        ),
        (import("part.json", ", face = 2", flat), "error[E0609]: part.json: there is no face 2"),
        (import("part.json", ", face = 0", flat), "error[E0609]: part.json: there is no face 0"),
    ] {
        let folder = Folder::new();
        let spec = folder.spec(&text);
        std::fs::write(folder.path(name), &contents).expect("the folder can be written");
        for target in ["out.step", "out.igs", "out.json"] {
            let target = folder.path(target).to_string_lossy().into_owned();
            let output = trimline(&["fit", &spec, "-o", &target]);
            let said = cli::text(&output.stderr);
            assert_eq!(status(&output), 1, "{text}{said}");
            assert!(said.starts_with(words) && said.matches("error[").count() == 1, "{words}\n{said}");
        }
        assert_eq!(folder.files(), [name, "spec.trim"], "{text}");
    }
}

#[test]
fn extension_without_a_meaning_is_refused_in_one_wording_by_every_command() {
    let cases = [
        ("fit", "a.obj", "has the extension `.obj`; write .step, .stp,"),
        ("mesh", "a.step", "has the extension `.step`; write .obj,"),
        ("render", "a.obj", "has the extension `.obj`; write .png, .gif"),
        ("render", "a", "has no extension; write .png, .gif"),
    ];
    for (command, name, words) in cases {
        let folder = Folder::new();
        let target = folder.path(name).to_string_lossy().into_owned();
        let output = trimline(&[command, &example("eq19.trim"), "-o", &target]);
        let said = cli::text(&output.stderr);
        assert_eq!(status(&output), 2, "{command} {name}: {said}");
        assert!(said.contains(words), "{command} {name}: {said}");
        assert_eq!(folder.files(), Vec::<String>::new());
    }
}
