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
    assert!(done(&trimline(&["emit", &spec, "--lang", "c", "--within", "1e-3"])).contains("spec_surface"));
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
    assert!(
        code == 1 && errors.contains("E0222") && errors.contains("data/ring.csv: row 1 has no column z"),
        "{errors}"
    );
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

#[test]
fn negative_value_of_an_option_is_told_its_range() {
    let cases: &[(&[&str], &str)] = &[
        (&["check", "--max-gap", "-1"], "--max-gap takes a number, 0 or more"),
        (&["check", "--max-angle", "-1"], "--max-angle takes a number, 0 or more"),
        (&["morph", "--at", "-0.1"], "-0.1 lies outside [0, 1]"),
        (&["morph", "--steps", "-1"], "'-1' for '--steps <M>': write a whole number"),
        (&["eval", "--points", "-", "--morph", "-2"], "-2 lies outside [0, 1]"),
        (&["bench", "--patch", "vase", "--seconds", "-1"], "--seconds -1: give a number from 0 to 3600"),
    ];
    let spec = example("p3_vase_to_flask.trim");
    for (arguments, said) in cases {
        let (command, options) = arguments.split_first().expect("a command");
        let output = trimline(&[&[*command, spec.as_str()], options].concat());
        let errors = text(&output.stderr);
        assert!(errors.contains(said) && !errors.contains("unexpected argument"), "{arguments:?}: {errors}");
        assert_ne!(status(&output), 0, "{arguments:?}");
    }
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::symlink;
    use std::os::unix::process::ExitStatusExt;
    use std::process::{Child, Command, Stdio};
    use std::time::{Duration, Instant};

    use super::{RING, SPEC, folder};
    use crate::cli::{Folder, done, example, status, text, trimline};

    fn make_pipe(path: &std::path::Path) {
        assert!(Command::new("mkfifo").arg(path).status().is_ok_and(|status| status.success()));
    }

    #[test]
    fn pipe_or_device_in_place_of_a_file_is_refused_and_not_waited_for() {
        let (folder, spec) = folder(RING);
        std::fs::remove_file(folder.path("data/ring.csv")).expect("gone");
        make_pipe(&folder.path("data/ring.csv"));
        let output = trimline(&["check", &spec]);
        assert!(text(&output.stderr).contains("E0221"), "{}", text(&output.stderr));
        assert!(text(&output.stderr).contains("not a regular file"), "{}", text(&output.stderr));
        let pipe = folder.path("data/ring.csv").to_string_lossy().into_owned();
        let eq19 = example("eq19.trim");
        let cases = [vec!["check", &pipe], vec!["check", "/dev/zero"], vec!["eval", &eq19, "--points", &pipe]];
        for arguments in cases {
            let output = trimline(&arguments);
            assert_eq!(status(&output), 2, "{arguments:?}");
            assert!(text(&output.stderr).contains("not a regular file"), "{}", text(&output.stderr));
        }
    }

    #[test]
    fn spec_that_a_shell_hands_over_is_read() {
        let run = |script: &str| Command::new("bash").args(["-c", script]).output().expect("bash runs");
        let (command, spec) = (env!("CARGO_BIN_EXE_trimline"), example("eq19.trim"));
        done(&run(&format!("cat '{spec}' | '{command}' basis /dev/stdin")));
        done(&run(&format!("'{command}' basis <(cat '{spec}')")));
    }

    #[test]
    fn link_out_of_the_folder_is_not_followed_and_one_within_is() {
        let (folder, spec) = folder(RING);
        let outside = Folder::new();
        std::fs::write(outside.path("ring.csv"), RING).expect("a file");
        std::fs::rename(folder.path("data/ring.csv"), folder.path("measured.csv")).expect("moved");
        symlink("../measured.csv", folder.path("data/ring.csv")).expect("a link");
        done(&trimline(&["check", &spec]));
        std::fs::remove_file(folder.path("data/ring.csv")).expect("gone");
        symlink(outside.path("ring.csv"), folder.path("data/ring.csv")).expect("a link");
        let refused = |spec: &str| {
            let output = trimline(&["check", spec]);
            let errors = text(&output.stderr);
            assert!(status(&output) == 1 && errors.contains("E0221") && errors.contains("leads out"), "{errors}");
        };
        refused(&spec);
        std::fs::remove_dir_all(folder.path("data")).expect("gone");
        symlink(outside.path("."), folder.path("data")).expect("a link");
        refused(&spec);
        // The spec itself may be reached by a link; its folder is the one that the user names.
        let there = outside.spec(SPEC.replace("data/", ""));
        symlink(outside.path("."), folder.path("project")).expect("a link");
        done(&trimline(&[
            "check",
            &there.replace(&*outside.path("").to_string_lossy(), &folder.path("project/").to_string_lossy()),
        ]));
    }

    /// A command that takes a while, once its unfinished file is there.
    fn started(folder: &Folder, script: &str) -> Child {
        let target = folder.path("out.obj").to_string_lossy().into_owned();
        let child = Command::new("sh")
            .args(["-c", script, "sh", env!("CARGO_BIN_EXE_trimline"), &example("eq19.trim"), &target])
            .stderr(Stdio::null())
            .spawn()
            .expect("the command starts");
        let start = Instant::now();
        while !folder.files().iter().any(|name| name.starts_with(".trimline-")) {
            assert!(start.elapsed() < Duration::from_secs(60), "no file was begun");
            std::thread::sleep(Duration::from_millis(2));
        }
        child
    }

    fn send(signal: &str, child: &Child) {
        let sent = Command::new("kill").args([signal, &child.id().to_string()]).status();
        assert!(sent.is_ok_and(|status| status.success()), "{signal} was not sent");
    }

    #[test]
    fn signal_that_ends_a_command_leaves_no_file() {
        for (name, number) in [("-HUP", 1), ("-INT", 2), ("-QUIT", 3), ("-ALRM", 14), ("-TERM", 15), ("-XCPU", 24)] {
            let folder = Folder::new();
            let mut child = started(&folder, "exec \"$1\" mesh \"$2\" -o \"$3\" --frames 500 --grid 200x200");
            send(name, &child);
            assert_eq!(child.wait().expect("it ends").signal(), Some(number));
            assert!(folder.files().is_empty(), "{name}: {:?}", folder.files());
        }
    }

    #[test]
    fn limit_of_file_size_leaves_no_file() {
        let folder = Folder::new();
        let mut child = Command::new("sh")
            .args([
                "-c",
                "ulimit -f 8; exec \"$0\" mesh \"$1\" -o \"$2\" --grid 300x300",
                env!("CARGO_BIN_EXE_trimline"),
            ])
            .args([&example("eq19.trim"), &*folder.path("out.obj").to_string_lossy()])
            .stderr(Stdio::null())
            .spawn()
            .expect("a shell starts");
        assert!(!child.wait().expect("it ends").success());
        assert!(folder.files().is_empty(), "{:?}", folder.files());
    }

    #[test]
    fn signal_that_is_ignored_stays_ignored() {
        let folder = Folder::new();
        let mut child = started(&folder, "trap '' HUP; exec \"$1\" mesh \"$2\" -o \"$3\" --frames 12 --grid 100x100");
        send("-HUP", &child);
        assert!(child.wait().expect("it ends").success());
        assert_eq!(folder.files().len(), 12);
    }
}
