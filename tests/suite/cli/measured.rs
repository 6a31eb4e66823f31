//! What `check` measures and says: nothing that the program knows is left out of it.

use serde_json::Value;

use super::{Folder, done, status, text, trimline, trimline_reading};

/// Jumps of 0.3: in the middle of one a Fourier series misses both sides by half of it.
const STEPS: &str = "at u = 0: S = [cos v, sin v, 0.3 floor(v)], dS/du = [0, 0, 1]\n\
                     at u = 1: S = [cos v, sin v, 3], dS/du = [0, 0, 1]\n";

#[test]
fn what_a_series_is_known_to_leave_out_is_measured() {
    let output = trimline_reading(STEPS, &["check", "-", "--format", "json"]);
    let report: Value = serde_json::from_str(&done(&output)).expect("JSON");
    let error = report["patches"][0]["boundaries"][0]["max_error"].as_f64().expect("an error");
    // No less than half a jump, up to the distance of the nearest of the 2145 places from it; no more than a whole one.
    assert!((0.14..0.3).contains(&error), "{error}");
    assert_eq!(status(&trimline_reading(STEPS, &["check", "-", "--max-gap", "0.05"])), 1);
    assert_eq!(status(&trimline_reading(STEPS, &["check", "-", "--max-gap", "0.3"])), 0);
}

#[test]
fn chosen_copy_is_measured_as_its_original_is() {
    let folder = Folder::new();
    let body = STEPS.replace("[cos v", "[3 + cos v");
    let spec = folder.spec(format!("patch a {{\n{body}}}\nmirror a in x = 0\nrepeat a 2 times moved by [9, 0, 0]\n"));
    let patches = |options: &[&str]| {
        let output = trimline(&[&["check", &spec, "--format", "json"], options].concat());
        let report: Value = serde_json::from_str(&text(&output.stdout)).expect("JSON");
        (report["patches"].clone(), text(&output.stderr))
    };
    let (original, said) = patches(&["--patch", "a"]);
    let (copy, said_of_copy) = patches(&["--patch", "a_mirrored"]);
    assert_eq!((copy[0]["name"].as_str(), &copy, said_of_copy), (Some("a"), &original, said));
    assert_eq!(status(&trimline(&["check", &spec, "--patch", "a_mirrored", "--max-gap", "0.05"])), 1);
    let target = folder.path("out.obj").to_string_lossy().into_owned();
    for options in [&["--patch", "a_mirrored"][..], &[]] {
        let mesh = trimline(&[&["mesh", &spec, "-o", &target, "--grid", "2x2"], options].concat());
        assert_eq!(text(&mesh.stderr).matches("W0414").count(), 1, "{}", text(&mesh.stderr));
    }
}

/// Two corners whose twists differ, in one statement.
#[test]
fn second_warning_at_the_same_place_is_given() {
    let spec = "domain u in [0, 1], v in [0, 1], t in [0, 1]\n\
                at u = 0: S = [0, v, 0], dS/du = [1, 0, (1 + t) v (1 - v)]\n\
                at u = 1: S = [1, v, 0], dS/du = [1, 0, 0]\n\
                at v = 0: S = [u, 0, 0], dS/dv = [0, 1, 0]\n\
                at v = 1: S = [u, 1, 0], dS/dv = [0, 1, 0]\n";
    let errors = text(&trimline_reading(spec, &["check", "-"]).stderr);
    assert_eq!(errors.matches("N0702").count(), 2, "{errors}");
    assert!(errors.contains("in the corner u = 0, v = 0") && errors.contains("in the corner u = 0, v = 1"), "{errors}");
}

const APART: &str = "patch a { domain t in [0, 1]
    at u = 0: S = [cos v, sin v, 0], dS/du = [0, 0, 1]
    at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]
}
patch b { domain t in [2, 3]
    at u = 0: S = [cos v, sin v, 0], dS/du = [0, 0, -1]
    at u = 1: S = [cos v, sin v, -1], dS/du = [0, 0, -1]
}
patch c { domain t in [0.5, 2.5]
    at u = 0: S = [cos v, sin v, 1], dS/du = [0, 0, 1]
    at u = 1: S = [cos v, sin v, 2], dS/du = [0, 0, 1]
}
";

#[test]
fn seam_of_patches_that_share_no_instant_fails_the_check() {
    let output = trimline_reading(&format!("{APART}seam a at u = 0 with b at u = 0\n"), &["check", "-"]);
    let errors = text(&output.stderr);
    assert_eq!(status(&output), 1, "{errors}");
    assert!(errors.contains("E0416") && errors.contains("no instant in common"), "{errors}");
}

#[test]
fn seam_is_measured_when_its_own_patches_exist() {
    let seams = |statement: &str| {
        let output = trimline_reading(&format!("{APART}{statement}\n"), &["check", "-", "--format", "json"]);
        let report: Value = serde_json::from_str(&text(&output.stdout)).expect("JSON");
        (status(&output), report["seams"].as_array().map_or(0, Vec::len))
    };
    // `a` and `c` meet though no instant lies in the time of all three patches; whether that is stated or not.
    assert_eq!(seams("seam a at u = 1 with c at u = 0"), (0, 1));
    assert_eq!(seams(""), (0, 1));
    assert_eq!(seams("seam a at u = 1 with c at u = 1"), (1, 2));
}

#[test]
fn number_of_modes_and_tolerance_stand_for_each_other() {
    let data =
        "at u = 0: S = [exp(cos v), sin v, 0], dS/du = [0, 0, 1]\nat u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]\n";
    let modes = |settings: &str, options: &[&str]| {
        let arguments = [&["solve", "-", "--format", "json", "-q"], options].concat();
        let report = done(&trimline_reading(&format!("{data}solve fourier, {settings}\n"), &arguments));
        let report: Value = serde_json::from_str(&report).expect("JSON");
        report["patches"][0]["modes"].as_u64().expect("a number")
    };
    assert_eq!(modes("tolerance = 1e-7", &["--modes", "4"]), 4);
    assert_eq!(modes("modes = 4", &["--tolerance", "1e-7"]), modes("tolerance = 1e-7", &[]));
    assert!(modes("tolerance = 1e-7", &[]) > 4);
}

/// The equation has no derivative in t, so a function of t needs none and has a closure.
#[test]
fn closure_is_the_one_that_exact_solves_on() {
    let spec = "at u = 0: S = [sqrt(1 + t) cos v, sin v, 2], dS/du = [0, 0, -1]\n\
                at u = 1: S = [v cos v, sin v, 0], dS/du = [0, 0, -1]\n";
    let json = |arguments: &[&str]| -> Value {
        serde_json::from_str(&done(&trimline_reading(spec, arguments))).expect("JSON")
    };
    let basis = json(&["basis", "-", "--closure", "--format", "json"]);
    let solve = json(&["solve", "-", "--format", "json"]);
    let [basis, solve] = [&basis["patches"][0], &solve["patches"][0]];
    let count = |list: &Value| list.as_array().map_or(0, Vec::len) as u64;
    assert_eq!(count(&basis["basis"]) + count(&basis["closure"]), solve["closure_size"].as_u64().expect("a number"));
    assert!(done(&trimline_reading(spec, &["basis", "-", "--closure"])).contains("sqrt"));
}

#[test]
fn equation_whose_terms_all_vanish_is_satisfied() {
    for first in ["cos^2 v + sin^2 v, v", "cosh^2 v - sinh^2 v, 0"] {
        let spec = format!(
            "domain v in [0, 1]\nat u = 0: S = [{first}, 2], dS/du = [0, 0, -1]\nat u = 1: S = [0, 0, 0], dS/du = [0, 0, -1]\n"
        );
        // Of data that are linear in v the surface is a cubic in u: `u^3` is all that is left of the equation's terms.
        let report: Value =
            serde_json::from_str(&done(&trimline_reading(&spec, &["check", "-", "--format", "json"]))).expect("JSON");
        assert_eq!(report["patches"][0]["pde_residual"].as_f64(), Some(0.0), "{first}");
    }
}

#[test]
fn critical_values_have_digits_enough_to_differ_from_those_at_hand() {
    let spec = "param k = 5\npde with β = -0.01, γ = 9.8669058\n\
        at u = 0: S = [cos v + 0.1 cos(k v), sin v, 1 + 0.2 sin(k v)], dS/du = [0, 0, -1]\n\
        at u = 1: S = [2 cos v, 2 sin v, 0], dS/du = [cos v, sin v, 0]\n";
    let errors = text(&trimline_reading(spec, &["check", "-"]).stderr);
    let hint =
        errors.lines().find(|line| line.contains("there is no solution at")).unwrap_or_else(|| panic!("{errors}"));
    for (name, value) in [("beta = ", -0.01), ("gamma = ", 9.866_905_8)] {
        let (_, rest) = hint.split_once(name).unwrap_or_else(|| panic!("{hint}"));
        let found: f64 = rest.split(',').next().expect("a number").trim().parse().expect("a number");
        // Near, and not the same: two digits of the difference are there.
        assert!(found != value && (found - value).abs() < 1e-6, "{hint}");
    }
}

#[test]
fn degrees_in_a_domain_are_told_from_periods() {
    let spec = "domain v in [0, 360]\nat u = 0: S = [cos v, sin v, 0], dS/du = [0, 0, 1]\nat u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]\n";
    let errors = text(&trimline_reading(spec, &["check", "-"]).stderr);
    assert!(errors.contains("W0221") && errors.contains("angles are in radians"), "{errors}");
}

#[test]
fn advice_for_a_series_at_its_limit_is_not_to_take_more_modes() {
    let errors = text(&trimline_reading(STEPS, &["check", "-"]).stderr);
    assert!(errors.contains("--limits modes=512"), "{errors}");
}
