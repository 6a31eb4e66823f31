//! Data files of specs as the command line finds them.

use crate::cli::{Folder, done, example, status, text, trimline};

const SPEC: &str = "curve C = points(\"data/ring.csv\")\nat u = 0: S = C(v), dS/du = [0, 0, 1]\n\
                    at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]\n";

fn folder(rows: &str) -> (Folder, String) {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("data")).expect("a folder");
    std::fs::write(folder.path("data/ring.csv"), rows).expect("a file");
    let spec = folder.spec(SPEC);
    (folder, spec)
}

const RING: &str = "1,0,0\n0.6,0.8,0\n-0.2,0.9,0\n-1,0.1,0\n-0.7,-0.7,0\n0.1,-1,0\n0.8,-0.5,0\n";

#[test]
fn every_command_takes_the_files_that_lie_beside_the_spec() {
    let (folder, spec) = folder(RING);
    let path = |name: &str| folder.path(name).to_string_lossy().into_owned();
    std::fs::write(folder.path("points.csv"), "u,v\n0,0\n").expect("a file");
    assert!(done(&trimline(&["check", &spec, "--explain"])).contains("curve C = points(\"data/ring.csv\")"));
    assert!(done(&trimline(&["basis", &spec])).contains("C_x(v)"));
    done(&trimline(&["solve", &spec]));
    let table = done(&trimline(&["eval", &spec, "--points", &path("points.csv")]));
    let x = table.lines().nth(1).and_then(|row| row.split(',').nth(2)).and_then(|x| x.parse::<f64>().ok());
    assert!(x.is_some_and(|x| (x - 1.0).abs() < 1e-14), "{table}");
    done(&trimline(&["mesh", &spec, "-o", &path("ring.obj"), "--grid", "4x8"]));
    done(&trimline(&["render", &spec, "-o", &path("ring.png"), "--size", "40x30"]));
    done(&trimline(&["morph", &spec, &spec, "--steps", "1"]));
    done(&trimline(&["fit", &spec, "-o", &path("ring.json"), "--tolerance", "1e-2"]));
    done(&trimline(&["fmt", &spec, "--check"]));
    let emitted = trimline(&["emit", &spec, "--lang", "c"]);
    assert_eq!(status(&emitted), 1);
    assert!(text(&emitted.stderr).contains("E0710"), "{}", text(&emitted.stderr));
    let series = ["emit", &spec, "--lang", "c", "--method", "fourier", "--remainder", "off", "--modes", "8"];
    assert!(done(&trimline(&series)).contains("spec_surface"));
    done(&trimline(&["check", &example("measured.trim")]));
}

#[test]
fn faults_of_files_have_their_status_and_their_place_in_the_spec() {
    let (folder, spec) = folder("1,2\n");
    let told = |arguments: &[&str]| {
        let output = trimline(arguments);
        (status(&output), text(&output.stderr))
    };
    let (code, errors) = told(&["check", &spec]);
    assert!(code == 1 && errors.contains("E0222") && errors.contains("data/ring.csv: row 1 has 2 columns"), "{errors}");
    assert!(errors.contains("spec.trim:1:18"), "{errors}");
    let (code, errors) = told(&["check", &spec, "--limits", "file-bytes=3"]);
    assert!(code == 4 && errors.contains("`file-bytes` of 3"), "{errors}");
    std::fs::write(folder.path("data/ring.csv"), RING).expect("a file");
    let (code, errors) = told(&["check", &spec, "--limits", "curve-points=3"]);
    assert!(code == 4 && errors.contains("`curve-points` of 3"), "{errors}");
    std::fs::remove_file(folder.path("data/ring.csv")).expect("gone");
    let (code, errors) = told(&["check", &spec]);
    assert!(code == 1 && errors.contains("E0221") && errors.contains("cannot be read"), "{errors}");
    std::fs::create_dir(folder.path("data/ring.csv")).expect("a folder");
    let (code, errors) = told(&["check", &spec]);
    assert!(code == 1 && errors.contains("it is not a regular file"), "{errors}");
}
