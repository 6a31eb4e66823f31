//! `trimline fit` as its users run it.

use serde_json::Value;

use trimline::limits::Limits;
use trimline::surface::bspline::from_json;

use crate::cli::{Folder, done, example, status, text, trimline};

#[test]
fn fit_writes_every_format_and_says_how_close_it_is() {
    for extension in ["step", "stp", "igs", "iges", "json"] {
        let folder = Folder::new();
        let target = folder.path(&format!("part.{extension}")).to_string_lossy().into_owned();
        let output = trimline(&["fit", &example("eq19.trim"), "-o", &target, "--tolerance", "1e-4", "--time", "0.2"]);
        assert!(done(&output).is_empty(), "the report for people goes to standard error");
        let said = text(&output.stderr);
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

#[test]
fn bad_requests_have_their_status_and_leave_nothing() {
    let cases: &[(&str, &[&str], i32, &str)] = &[
        ("part.obj", &[], 2, "write .step, .stp, .igs, .iges, .json"),
        ("part", &[], 2, "has no extension"),
        ("part.step", &["--degree", "2"], 1, "use degree 3, 4 or 5"),
        ("part.step", &["--tolerance", "0"], 1, "no positive length"),
        ("part.step", &["--tolerance", "1e-30"], 1, "below the rounding"),
        ("part.step", &["--tolerance", "1e-12", "--limits", "control-points=500"], 4, "`control-points` of 500"),
        ("part.step", &["--time", "7"], 1, "outside the time domain"),
        ("part.step", &["--schema", "ap203"], 2, "ap203"),
    ];
    for (name, options, expected, words) in cases {
        let folder = Folder::new();
        let target = folder.path(name).to_string_lossy().into_owned();
        let output = trimline(&[&["fit", &example("eq19.trim"), "-o", &target], *options].concat());
        let said = text(&output.stderr);
        assert_eq!(status(&output), *expected, "{options:?}: {said}");
        assert!(said.contains(words), "{options:?}: {said}");
        assert!(output.stdout.is_empty(), "{options:?}");
        assert_eq!(folder.files(), Vec::<String>::new(), "{options:?}");
    }
}
