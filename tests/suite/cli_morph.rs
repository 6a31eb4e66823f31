//! `trimline morph` as its users run it.

use serde_json::Value;

use crate::cli::{Folder, done, example, status, text, trimline};

fn shapes() -> [String; 2] {
    ["p3_positions.trim", "p3_flask.trim"].map(example)
}

fn glasses() -> [String; 2] {
    ["p3_water_glass.trim", "p3_wine_glass.trim"].map(example)
}

fn report(options: &[&str]) -> Value {
    let [source, target] = shapes();
    let arguments = [&["morph", &source, &target, "--format", "json", "-q"], options].concat();
    serde_json::from_str(&done(&trimline(&arguments))).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn points_of_a_frame_are_those_of_extended_precision() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/p3_morph.json");
    let reference: Value = serde_json::from_str(&std::fs::read_to_string(path).expect("a text")).expect("JSON");
    let rows: Vec<(&str, Vec<f64>)> = reference["variants"]
        .as_array()
        .expect("variants")
        .iter()
        .flat_map(|variant| {
            let patch = if variant["id"] == "patch_base" { "base" } else { "body" };
            let rows = variant["values"].as_array().expect("rows").iter();
            rows.map(move |row| (patch, row.as_array().expect("a row").iter().map(number).collect()))
        })
        .collect();
    let folder = Folder::new();
    let points = folder.path("points.csv");
    let lines: String = rows.iter().map(|(patch, row)| format!("{patch},{:?},{:?}\n", row[0], row[1])).collect();
    std::fs::write(&points, format!("patch,u,v\n{lines}")).expect("written");
    let points = points.to_string_lossy().into_owned();
    let [source, target] = glasses();
    let choices: [&[&str]; 2] = [&["--steps", "9", "--frame", "3"], &["--at", "0.3"]];
    for choice in choices {
        let arguments = ["morph", &source, &target, "--points", &points, "--derivatives", "u,v"];
        let table = done(&trimline(&[&arguments[..], choice].concat()));
        assert_eq!(table.lines().count(), 81);
        for (line, (_, expected)) in table.lines().skip(1).zip(&rows) {
            let found: Vec<f64> = line.split(',').skip(3).map(|cell| cell.parse().expect("a number")).collect();
            assert_eq!(found.len(), 9);
            for (found, expected) in found.iter().zip(&expected[2..]) {
                // What the reference asks for.
                assert!((found - expected).abs() <= 1e-9 * (1.0 + expected.abs()), "{line}");
            }
        }
    }
}

#[test]
fn steps_of_boundary_morphs_fall_as_one_over_their_number() {
    let [few, many] = ["9", "39"].map(|steps| number(&report(&["--steps", steps])["largest_step"]));
    // The shapes lie on a straight line, so that all steps are equal: 10 and 40 of them.
    assert!((few / many - 4.0).abs() < 1e-9, "{few} {many}");
}

#[test]
fn steps_of_combined_morphs_fall_as_one_over_their_number() {
    let inner = |steps| number(&report(&["--by", "both", "--steps", steps])["largest_inner_step"]);
    let [few, many] = ["41", "81"].map(inner);
    // Steps are straight up to second order: halving them changes what is left of the ratio by about 1/40.
    assert!((few / many - 2.0).abs() < 0.1, "{few} {many}");
}

#[test]
fn morph_by_modes_jumps_where_the_boundary_changes_at_once() {
    let report = report(&["--by", "modes"]);
    let frames = report["frames"].as_array().expect("frames");
    let modes: Vec<Option<f64>> = frames.iter().map(|frame| frame["modes"].as_f64()).collect();
    let between = [5.0, 4.0, 3.0, 2.0, 1.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Some);
    assert_eq!(modes, [&[None], &between[..], &[None]].concat());
    let largest = number(&report["largest_step"]);
    assert_eq!(number(&frames[6]["step"]), largest, "from one mode of the source to one of the target");
}

#[test]
fn first_and_last_step_of_a_morph_by_modes_are_the_remainders() {
    // Frame 1 has the source's modes without its remainder; the vase's is 0.050, from arithmetic of 50 digits.
    let report = report(&["--by", "modes"]);
    assert!((number(&report["frames"][1]["step"]) - 0.050).abs() < 5e-4, "{report}");
}

#[test]
fn frames_become_one_animation_or_numbered_files() {
    let [source, target] = glasses();
    let folder = Folder::new();
    for name in ["glass.glb", "glass.obj"] {
        let path = folder.path(name).to_string_lossy().into_owned();
        let arguments = ["morph", &source, &target, "--steps", "2", "--grid", "4x12", "-o", &path];
        let output = trimline(&arguments);
        assert!(done(&output).is_empty());
        assert!(text(&output.stderr).contains("largest step"), "{}", text(&output.stderr));
    }
    let files = ["glass.0000.obj", "glass.0001.obj", "glass.0002.obj", "glass.0003.obj", "glass.glb"];
    assert_eq!(folder.files(), files);
    let one = folder.path("one.obj").to_string_lossy().into_owned();
    done(&trimline(&["morph", &source, &target, "--at", "0.5", "--grid", "4x12", "-o", &one]));
    assert!(folder.files().contains(&"one.obj".to_owned()));
}

#[test]
fn bad_requests_have_their_status_and_leave_nothing() {
    let ([water, wine], [vase, _]) = (glasses(), shapes());
    let cases: &[(&str, &[&str], i32, &str)] = &[
        (&vase, &[], 1, "the source has no patch `base`"),
        (&wine, &["--frame", "11"], 1, "the target is frame 10"),
        (&wine, &["--at", "1.5"], 1, "outside [0, 1]"),
        (&wine, &["--by", "modes", "--at", "0.5"], 2, "--frame"),
        (&wine, &["--by", "modes", "--steps", "7"], 1, "has 1 + 1 frames"),
        (&wine, &["--by", "modes", "--method", "exact"], 1, "needs `fourier`"),
        (&wine, &["--steps", "0"], 1, "nothing in between"),
        (&wine, &["--steps", "20000"], 4, "frames = 10000"),
        (&wine, &["--points", "nowhere.csv"], 2, "choose it with --frame or --at"),
        (&wine, &["--frame", "2"], 2, "say what to write"),
        (&wine, &["-o", "glass.xyz"], 2, "the extension `.xyz`"),
        (&wine, &["--frame", "1", "--at", "0.5"], 2, "cannot be used with"),
    ];
    for (target, options, expected, words) in cases {
        let source = if *target == vase { &wine } else { &water };
        let (source, target) = if *target == vase { (*target, source.as_str()) } else { (source.as_str(), *target) };
        let output = trimline(&[&["morph", source, target], *options].concat());
        let said = text(&output.stderr);
        assert_eq!(status(&output), *expected, "{options:?}: {said}");
        assert!(said.contains(words), "{options:?}: {said}");
        assert!(output.stdout.is_empty(), "{options:?}");
    }
}
