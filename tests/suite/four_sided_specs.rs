//! Specs with constraints at fixed v and with deformations, through the command: against reference values, and what is
//! refused.

use serde_json::Value;

use crate::cli::{Folder, done, example, status, text, trimline};

/// The rows of a reference file, each with as many numbers.
fn rows(file: &str, key: &str) -> Vec<Vec<f64>> {
    let path = format!("{}/tests/reference/{file}", env!("CARGO_MANIFEST_DIR"));
    let reference: Value =
        serde_json::from_str(&std::fs::read_to_string(path).expect("the file is there")).expect("JSON");
    let rows = reference[key].as_array().expect("rows");
    let numbers = |row: &Value| row.as_array().expect("a row").iter().map(|x| x.as_f64().expect("a number")).collect();
    rows.iter().map(numbers).collect()
}

/// The largest distance of `trimline eval` from rows u, v, x, y, z, in any coordinate.
fn distance(spec: &str, rows: &[Vec<f64>]) -> f64 {
    let folder = Folder::new();
    let points: Vec<String> = rows.iter().map(|row| format!("{:?},{:?},0\n", row[0], row[1])).collect();
    let file = folder.path("points.csv");
    std::fs::write(&file, format!("u,v,t\n{}", points.concat())).expect("a folder to write to");
    let table = done(&trimline(&["eval", &example(spec), "--points", &file.to_string_lossy()]));
    let mut worst = 0.0_f64;
    let mut lines = table.lines().skip(1);
    for row in rows {
        let line = lines.next().expect("a line for every point");
        let found: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        for (found, expected) in found[found.len() - 3..].iter().zip(&row[2..5]) {
            worst = worst.max((found - expected).abs());
        }
    }
    assert_eq!(lines.next(), None);
    worst
}

#[test]
fn spec_with_four_sides_agrees_with_the_reference() {
    let rows = rows("p4_four_sided.json", "samples_u_v_x_y_z");
    assert_eq!(rows.len(), 81);
    // 12 x 12 terms leave rounding of a surface of size 2.
    let worst = distance("four_sided.trim", &rows);
    assert!(worst < 1e-13, "{worst:.1e}");
}

#[test]
fn spec_with_a_deformation_agrees_with_the_reference() {
    let rows = rows("p4_local_c1.json", "samples_u_v_deformed_xyz_base_xyz");
    assert_eq!(rows.len(), 81);
    assert!(rows.iter().any(|row| (row[4] - row[7]).abs() > 1.0), "the deformation moves something");
    // Rounding of coordinates up to 3.
    let worst = distance("deformed.trim", &rows);
    assert!(worst < 1e-13, "{worst:.1e}");
}

#[test]
fn specs_without_separable_surfaces_are_checked_and_meshed_and_emitted_as_splines_when_told_how_near() {
    for spec in ["four_sided.trim", "deformed.trim"] {
        let folder = Folder::new();
        done(&trimline(&["check", &example(spec)]));
        let mesh = folder.path("out.obj");
        done(&trimline(&["mesh", &example(spec), "-o", &mesh.to_string_lossy()]));
        assert!(std::fs::metadata(&mesh).expect("a mesh").len() > 1000);
        let refused = trimline(&["emit", &example(spec), "--lang", "c"]);
        assert_eq!(status(&refused), 1, "{}", text(&refused.stderr));
        let errors = text(&refused.stderr);
        assert!(errors.contains("E0709") && errors.contains("--within"), "{errors}");
        let emitted = done(&trimline(&["emit", &example(spec), "--lang", "c", "--within", "1e-5"]));
        let stated = emitted.split("at most ").nth(1).and_then(|rest| rest.split(' ').next());
        let deviation: f64 = stated.and_then(|text| text.parse().ok()).expect("a deviation");
        assert!(deviation > 0.0 && deviation <= 1e-5, "{deviation}");
        let refused = trimline(&["emit", &example(spec), "--lang", "c", "--within", "-1"]);
        assert!(status(&refused) == 2 && text(&refused.stderr).contains("no positive length"));
        let refused = trimline(&["emit", &example(spec), "--lang", "c", "--within", "1e-30"]);
        assert_eq!(status(&refused), 2, "{}", text(&refused.stderr));
        let errors = text(&refused.stderr);
        assert!(errors.contains("--within") && errors.contains("ask for") && errors.contains("or more"), "{errors}");
    }
}

#[test]
fn corners_that_disagree_are_refused_at_the_boundary() {
    let folder = Folder::new();
    let stated = std::fs::read_to_string(example("four_sided.trim")).expect("the example");
    let spec = folder.spec(stated.replace("S     = [u, 3", "S     = [u + 0.25, 3").as_bytes());
    let output = trimline(&["check", &spec]);
    let errors = text(&output.stderr);
    assert_eq!(status(&output), 1, "{errors}");
    assert!(errors.contains("E0701") && errors.contains("spec.trim:"), "{errors}");
}

#[test]
fn deformation_that_moves_a_trimline_is_refused_where_it_stands() {
    let folder = Folder::new();
    let stated = std::fs::read_to_string(example("deformed.trim")).expect("the example");
    let spec = folder.spec(stated.replace("u in [0.4, 0.5]", "u in [0, 0.5]").replace("C1", "C0").as_bytes());
    let output = trimline(&["check", &spec]);
    let errors = text(&output.stderr);
    assert_eq!(status(&output), 1, "{errors}");
    assert!(errors.contains("E0705") && errors.contains("deform u in"), "{errors}");
}

#[test]
fn patch_of_several_has_its_own_deformation() {
    let folder = Folder::new();
    let boundary = "at u = 0: S = [v, 0, 0], dS/du = 0\nat u = 1: S = [v, 1, 0], dS/du = 0\n";
    let deform = "deform u in [0, 1], v in [0, 1] by [0, 0, 1] keeping C2\n";
    let inside = folder.spec(format!("patch a {{\n{boundary}{deform}}}\npatch b {{\n{boundary}}}\n").as_bytes());
    done(&trimline(&["check", &inside]));
    let outside = folder.spec(format!("patch a {{\n{boundary}}}\n{deform}").as_bytes());
    let output = trimline(&["check", &outside]);
    assert_eq!(status(&output), 1);
    assert!(text(&output.stderr).contains("a deformation stands outside the patches"), "{}", text(&output.stderr));
}
