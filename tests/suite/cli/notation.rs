//! `fmt`, `check --explain` and `basis --format latex`.

use serde_json::Value;

use super::{Folder, status, text, trimline, trimline_reading};

#[test]
fn fmt_lays_files_out_in_place_and_says_nothing() {
    let folder = Folder::new();
    let spec = folder.spec("at u=0: S=[cos v,0,0],∂S/∂u=0\nat u = 1: S=0, ∂S/∂u =0");
    let output = trimline(&["fmt", &spec]);
    assert_eq!((status(&output), text(&output.stdout), text(&output.stderr)), (0, String::new(), String::new()));
    let expected = "at u = 0: S = [cos v, 0, 0], ∂S/∂u = 0\nat u = 1: S = 0, ∂S/∂u = 0\n";
    assert_eq!(std::fs::read_to_string(&spec).expect("the file"), expected);
    assert_eq!(folder.files(), ["spec.trim"]);
    assert_eq!(status(&trimline(&["fmt", "--check", &spec])), 0);
}

#[test]
fn fmt_check_names_files_and_changes_none() {
    let folder = Folder::new();
    let before = "at u=0: S=[cos v,0,0],dS/du=0\nat u = 1: S=0, dS/du =0";
    let spec = folder.spec(before);
    let output = trimline(&["fmt", "--check", &spec]);
    assert_eq!((status(&output), text(&output.stdout)), (1, format!("{spec}\n")));
    assert_eq!(std::fs::read_to_string(&spec).expect("the file"), before);
}

#[test]
fn fmt_prints_standard_input_in_the_wanted_alphabet() {
    let output = trimline_reading("pde d4S/du4=0\nat u = 0: x = v", &["fmt", "--unicode", "-"]);
    assert_eq!((status(&output), text(&output.stdout).as_str()), (0, "pde ∂⁴S/∂u⁴ = 0\nat u = 0: x = v\n"));
    let output = trimline_reading("at u = 0: x = πt", &["fmt", "--ascii", "-"]);
    assert_eq!(text(&output.stdout), "at u = 0: x = pi t\n");
}

#[test]
fn fmt_of_a_faulty_file_changes_no_file() {
    let folder = Folder::new();
    let spec = folder.spec("at u=0: x=v");
    let faulty = folder.path("faulty.trim").to_string_lossy().into_owned();
    std::fs::write(&faulty, "at u = 0: x = +").expect("the folder can be written");
    let output = trimline(&["fmt", &spec, &faulty]);
    assert_eq!(status(&output), 1);
    assert!(text(&output.stderr).contains("E0102"), "{}", text(&output.stderr));
    assert_eq!(std::fs::read_to_string(&spec).expect("the file"), "at u=0: x=v");
}

#[test]
fn read_only_file_is_neither_laid_out_nor_overwritten() {
    let folder = Folder::new();
    let before = "at u=0: S=[cos v,0,0],∂S/∂u=0\nat u = 1: S=0, ∂S/∂u =0";
    let spec = folder.spec(before);
    let mut permissions = std::fs::metadata(&spec).expect("the file").permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&spec, permissions).expect("its owner may");
    for command in [&["fmt", &spec][..], &["mesh", &spec, "-o", &spec.replace("spec.trim", "out.obj")]] {
        std::fs::copy(&spec, folder.path("out.obj")).expect("a file that is read-only as well");
        let output = trimline(command);
        assert_eq!(status(&output), 5, "{command:?}");
        assert!(text(&output.stderr).contains("the file is read-only"), "{}", text(&output.stderr));
        for file in [folder.path("spec.trim"), folder.path("out.obj")] {
            assert_eq!(std::fs::read_to_string(file).expect("the file"), before);
        }
        std::fs::remove_file(folder.path("out.obj")).expect("the folder is not read-only");
    }
}

#[cfg(unix)]
#[test]
fn file_that_is_written_anew_keeps_its_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    let spec = folder.spec("at u=0: S=[cos v,0,0],∂S/∂u=0\nat u = 1: S=0, ∂S/∂u =0");
    std::fs::set_permissions(&spec, std::fs::Permissions::from_mode(0o640)).expect("its owner may");
    assert_eq!(status(&trimline(&["fmt", &spec])), 0);
    assert_eq!(std::fs::metadata(&spec).expect("the file").permissions().mode() & 0o777, 0o640);
}

#[test]
fn check_explains_what_it_understood_in_both_notations() {
    let folder = Folder::new();
    let spec =
        folder.spec("param a = 2\nlet s = a t\nat u = 0: S = [s cos v, 0, 0], dS/du = 0\nat u = 1: S = 0, dS/du = 0");
    let output = trimline(&["check", "--explain", &spec]);
    let shown = text(&output.stdout);
    for expected in ["at u = 0:\n    S = [a t cos(v), 0, 0]", "param a = 2", r"a\, t\, \cos\left(v\right)", "passed"] {
        assert!(shown.contains(expected), "{shown}");
    }
    let output = trimline(&["check", "--explain", "--format", "json", &spec]);
    let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let explanation = &report["patches"][0]["explanation"];
    assert_eq!(explanation["unicode"]["domain"], "domain u in [0, 1], v in [0, 2 π], t in [0, 1]");
    for key in ["params", "equation", "domain", "constraints"] {
        assert!(explanation["latex"][key].as_str().expect("a text").starts_with(r"\begin{aligned}"), "{explanation}");
    }
    let plain = trimline(&["check", "--format", "json", &spec]);
    let report: Value = serde_json::from_slice(&plain.stdout).expect("JSON");
    assert!(report["patches"][0].get("explanation").is_none());
}

#[test]
fn basis_in_latex_is_one_environment_per_patch() {
    let output = trimline(&["basis", "--format", "latex", "examples/eq19.trim"]);
    let latex = text(&output.stdout);
    assert_eq!(status(&output), 0);
    assert!(latex.starts_with("\\begin{aligned}\nF_{1}(v, t) &= "), "{latex}");
    assert!(latex.ends_with("\n\\end{aligned}\n"), "{latex}");
    assert_eq!(status(&trimline(&["basis", "--format", "latex", "--closure", "examples/eq19.trim"])), 2);
}

#[test]
fn basis_of_an_imported_cubic_says_which_derivatives_do_not_exist() {
    let spec = "examples/import_step.trim";
    let told = text(&trimline(&["basis", spec]).stdout);
    let line = "  F2_vvvv does not exist: `S1_y` is made of polynomials that fit together up to derivative 2, and its derivative `vvvv` is needed";
    assert!(told.lines().any(|found| found == line), "{told}");
    assert!(told.contains("  F1_vv = "), "{told}");
    let json: Value = serde_json::from_slice(&trimline(&["basis", spec, "--format", "json"]).stdout).expect("JSON");
    let derivatives = &json["patches"][0]["basis"][0]["derivatives"];
    assert!(derivatives["vvvv"].is_null() && derivatives["vv"].is_string(), "{derivatives}");
    let latex = text(&trimline(&["basis", spec, "--format", "latex"]).stdout);
    assert!(latex.contains(r"\frac{\partial^{4} F_{1}}{\partial v^{4}} &\quad \text{does not exist}"), "{latex}");
    // There is no closure under derivatives that do not exist.
    assert_eq!(status(&trimline(&["basis", spec, "--closure"])), 1);
}
