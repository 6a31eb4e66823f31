//! `bench`: the shape of what it prints, and numbers that fit together. How fast it is, is not for tests.

use serde_json::Value;

use super::{done, example, text, trimline};

fn measured(arguments: &[&str]) -> Value {
    let output = done(&trimline(&[&["bench"], arguments, &["--seconds", "0", "--format", "json"]].concat()));
    serde_json::from_str(&output).expect("bench prints JSON")
}

#[test]
fn bench_prints_positive_numbers_that_fit_together() {
    let bench = measured(&[&example("eq24.trim"), "--patch", "bowl", "--grid", "40x30"]);
    let number = |key: &str| bench[key].as_f64().unwrap_or_else(|| panic!("no number `{key}` in {bench}"));
    for key in [
        "compile_ms",
        "solve_us",
        "verify_us",
        "first_value_ms",
        "basis_ns_per_point",
        "grid_ns_per_vertex",
        "grid_gb_per_s",
        "scattered_ns_per_point",
        "store_gb_per_s",
        "cached_store_gb_per_s",
        "multiply_adds_per_ns",
    ] {
        assert!(number(key) > 0.0 && number(key).is_finite(), "{key}: {bench}");
    }
    // Three doubles a vertex, from the same measurement.
    let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
    assert!(close(number("grid_gb_per_s") * number("grid_ns_per_vertex"), 24.0), "{bench}");
    let share = bench["shares"]["grid_gb_per_s"].as_f64().expect("a share of the store bandwidth");
    assert!(close(share * number("store_gb_per_s"), number("grid_gb_per_s")), "{bench}");
    assert_eq!((&bench["grid"][0], &bench["grid"][1], &bench["patch"]), (&40.into(), &30.into(), &"bowl".into()));
}

#[test]
fn bench_of_a_surface_without_a_basis_says_so() {
    let bench = measured(&[&example("four_sided.trim"), "--grid", "9x9"]);
    assert!(bench["basis_ns_per_point"].is_null() && bench["grid_ns_per_vertex"].is_f64(), "{bench}");
}

#[test]
fn bench_in_text_names_what_is_compared() {
    let output = done(&trimline(&["bench", &example("eq19.trim"), "--seconds", "0", "--grid", "20x20"]));
    assert!(output.contains("% of the store bandwidth") && output.contains("method sine"), "{output}");
}

#[test]
fn bench_refuses_what_it_cannot_measure() {
    for (arguments, reason) in [
        (&["--grid", "1x9"][..], "at least 2x2"),
        (&["--grid", "99999x99999"], "limit `samples`"),
        (&["--seconds", "-1"], "from 0 to 3600"),
        (&["--seconds", "NaN"], "from 0 to 3600"),
    ] {
        let output = trimline(&[&["bench", &example("eq19.trim")], arguments].concat());
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(2) && output.stdout.is_empty() && said.contains(reason), "{said}");
    }
    let output = trimline(&["bench", &example("eq24.trim")]);
    assert!(text(&output.stderr).contains("name it with --patch"), "{}", text(&output.stderr));
}
