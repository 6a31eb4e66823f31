//! What `check` tells scripts: findings, bounds that are exceeded, and each of several specs.

use serde_json::{Value, json};

use super::{Folder, status, text, trimline, trimline_reading};

const SOUND: &str =
    "at u = 0: S = [cos v, sin v, 0], dS/du = [0, 0, 1]\nat u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]\n";

fn report(output: &std::process::Output) -> Value {
    serde_json::from_str(&text(&output.stdout)).expect("JSON")
}

#[test]
fn findings_stand_in_the_report_with_code_place_and_hint() {
    let output = trimline_reading("at u = 0: S_x = kv\n", &["check", "-", "--format", "json"]);
    assert_eq!(status(&output), 1);
    let found = report(&output);
    let finding = &found["findings"][0];
    assert_eq!((&finding["severity"], &finding["code"]), (&json!("error"), &json!("E0201")));
    assert_eq!((&finding["place"]["line"], &finding["place"]["column"]), (&json!(1), &json!(17)));
    assert!(finding["hints"][0].as_str().is_some_and(|hint| hint.contains("did you mean")), "{finding}");
    assert_eq!((&found["passed"], &found["spec"]), (&json!(false), &Value::Null));
    let unused = format!("param q = 1\n{SOUND}");
    let output = trimline_reading(&unused, &["check", "-", "--format", "json", "--quiet"]);
    let found = report(&output);
    assert_eq!((status(&output), found["findings"][0]["code"].as_str()), (0, Some("W0218")));
    assert!(output.stderr.is_empty());
    // Lists are there when they are empty.
    for list in ["nets", "copies", "seams", "exceeded"] {
        assert_eq!(found[list], json!([]), "{list}");
    }
    assert_eq!(found["patches"][0]["apexes"], json!([]));
}

#[test]
fn one_broken_spec_does_not_hide_the_others() {
    let folder = Folder::new();
    let names = [("a.trim", SOUND), ("b.trim", "at u = 0: S_x = kv\n"), ("c.trim", SOUND)].map(|(name, spec)| {
        std::fs::write(folder.path(name), spec).expect("written");
        folder.path(name).to_string_lossy().into_owned()
    });
    let [a, b, c] = &names;
    let output = trimline(&["check", a, b, c]);
    let (said, printed) = (text(&output.stderr), text(&output.stdout));
    assert_eq!(status(&output), 1);
    assert!(said.contains("E0201") && said.contains("b.trim:1:17"), "{said}");
    let expected = [format!("{a}: passed"), format!("{b}: at fault"), format!("{c}: passed"), "not passed".to_owned()];
    assert!(expected.iter().all(|line| printed.lines().any(|printed| printed == line)), "{printed}");
    let found = report(&trimline(&["check", a, b, c, "--format", "json"]));
    let specs = |list: &str| -> Vec<String> {
        let items = found[list].as_array().expect("a list").iter();
        items.map(|item| item["spec"].as_str().expect("a spec").to_owned()).collect()
    };
    assert_eq!((specs("patches"), specs("findings")), (vec![a.clone(), c.clone()], vec![b.clone()]));
}

#[test]
fn what_exceeds_a_bound_is_said_with_its_line() {
    // Two patches that meet at 45 degrees, 1e-4 apart.
    let spec = "patch low { at u = 0: S = [cos v, sin v, 0], dS/du = [0, 0, 1]; at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1] }
        patch high { domain u in [1, 2]
            at u = 1: S = [cos v, sin v, 1.0001], dS/du = [cos v, sin v, 1]
            at u = 2: S = [2 cos v, 2 sin v, 2], dS/du = [cos v, sin v, 1] }\n";
    let check = |options: &[&str]| trimline_reading(spec, &[&["check", "-"], options].concat());
    let output = check(&["--max-gap", "1e-5", "--max-angle", "44", "--max-residual", "0.5"]);
    let printed = text(&output.stdout);
    assert_eq!(status(&output), 1);
    let lines: Vec<&str> = printed.lines().filter(|line| line.contains("exceeds")).collect();
    let place = "seam low at u = 1 with high at u = 1";
    assert!(lines[0].starts_with(place) && lines[0].ends_with("exceeds --max-gap 1e-5"), "{printed}");
    assert!(lines[1].starts_with(place) && lines[1].ends_with("exceeds --max-angle 44"), "{printed}");
    assert_eq!(lines.len(), 2);
    let found = report(&check(&["--max-angle", "44", "--format", "json"]));
    let exceeded = &found["exceeded"][0];
    assert_eq!(
        (&exceeded["option"], &exceeded["bound"], &exceeded["place"]),
        (&json!("--max-angle"), &json!(44.0), &json!(place))
    );
    assert!((exceeded["value"].as_f64().expect("an angle") - 45.0).abs() < 1e-3);
    assert_eq!(status(&check(&["--max-residual", "-1"])), 2);
}

#[test]
fn residuals_and_warnings_can_be_bounded() {
    let spec = "param q = 1\nat u = 0: S = [1/(0.5 + v), v, 0], dS/du = 0\nat u = 1: S = [v, 1, 2], dS/du = [0, 0, 1]\nsolve legendre, terms = 3\n";
    let check = |options: &[&str]| trimline_reading(spec, &[&["check", "-"], options].concat());
    let residual = report(&check(&["--format", "json"]))["patches"][0]["pde_residual"].as_f64().expect("a number");
    assert!(residual > 1e-12, "{residual}");
    assert_eq!(status(&check(&["--max-residual", &format!("{}", 1.01 * residual)])), 0);
    assert_eq!(status(&check(&["--max-residual", &format!("{}", 0.99 * residual)])), 1);
    let output = check(&["--deny-warnings"]);
    assert_eq!(status(&output), 1);
    assert!(text(&output.stdout).contains("W0218"), "{}", text(&output.stdout));
    assert_eq!(status(&trimline_reading(SOUND, &["check", "-", "--deny-warnings"])), 0);
}

#[test]
fn reader_that_goes_away_ends_the_command_quietly() {
    let folder = Folder::new();
    let spec = folder.spec(SOUND);
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_trimline"))
        .args(["solve", &spec])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("the command starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the command ends");
    assert!(output.status.success(), "{output:?}");
}
