//! The server of the interactive view: what it answers, and whom.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::Value;

/// A running view; ends with the test.
struct View {
    child: Child,
    port: u16,
    folder: tempfile::TempDir,
}

impl Drop for View {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// An answer: status, header lines in lower case, body.
struct Answer {
    status: u16,
    headers: String,
    body: String,
    bytes: Vec<u8>,
}

impl Answer {
    fn json(&self) -> Value {
        serde_json::from_str(&self.body).unwrap_or_else(|error| panic!("{error}: {}", self.body))
    }
}

impl View {
    fn of(text: &str, options: &[&str]) -> View {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("spec.trim"), text).expect("a file");
        let mut child = Command::new(env!("CARGO_BIN_EXE_trimline"))
            .arg("view")
            .arg(folder.path().join("spec.trim"))
            .args(["--port", "0", "--quiet"])
            .args(options)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the command starts");
        let mut address = String::new();
        let mut output = BufReader::new(child.stdout.take().expect("piped"));
        output.read_line(&mut address).expect("the address");
        let port = address.trim().strip_prefix("http://127.0.0.1:").and_then(|rest| rest.strip_suffix('/'));
        let port = port.and_then(|port| port.parse().ok()).unwrap_or_else(|| panic!("no address: {address}"));
        View { child, port, folder }
    }

    fn spec(&self) -> PathBuf {
        self.folder.path().join("spec.trim")
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).expect("the view listens");
        stream.set_read_timeout(Some(Duration::from_secs(60))).expect("a timeout");
        stream
    }

    /// Sends a request line with its own headers; the connection is closed after the answer.
    fn request(&self, line: &str, headers: &str) -> Answer {
        let mut stream = self.connect();
        let request = format!("{line} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n");
        stream.write_all(request.as_bytes()).expect("sent");
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).expect("an answer");
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let (head, body) = text.split_once("\r\n\r\n").unwrap_or_else(|| panic!("no answer to {line}: {text}"));
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).expect("a status");
        let start = bytes.windows(4).position(|window| window == b"\r\n\r\n").map_or(0, |at| at + 4);
        let bytes = bytes.get(start..).unwrap_or_default().to_vec();
        Answer { status, headers: head.to_lowercase(), body: body.to_owned(), bytes }
    }

    fn get(&self, path: &str) -> Answer {
        self.request(&format!("GET {path}"), &format!("Host: 127.0.0.1:{}\r\n", self.port))
    }
}

const VASE: &str = "param r = 1 in [0.5, 2], k = 3\n\
                    at u = 0: S = [r cos v, r sin v, 1], ∂S/∂u = [0, 0, -1]\n\
                    at u = 1: S = [2 cos v, 2 sin v, 0], ∂S/∂u = [cos v, sin v, 0]\n";

#[test]
fn page_is_whole_and_may_load_nothing_from_elsewhere() {
    let view = View::of(VASE, &[]);
    let page = view.get("/");
    assert_eq!(page.status, 200);
    assert!(page.headers.contains("content-security-policy: default-src 'self'"), "{}", page.headers);
    for path in ["/viewer.js", "/viewer.css"] {
        assert!(page.body.contains(&format!("\"{path}\"")), "{path}");
        assert_eq!(view.get(path).status, 200, "{path}");
    }
    assert!(!page.body.contains("http"), "the page names another server");
}

#[test]
fn only_the_servers_own_pages_are_answered() {
    let view = View::of(VASE, &[]);
    let own = format!("Host: 127.0.0.1:{}\r\n", view.port);
    let by_name = format!("Host: localhost:{}\r\n", view.port);
    let cases = [
        (own.clone(), 200),
        (by_name, 200),
        (format!("{own}Origin: http://127.0.0.1:{}\r\n", view.port), 200),
        ("Host: example.com\r\n".to_owned(), 403),
        (format!("Host: example.com:{}\r\n", view.port), 403),
        ("Host: 127.0.0.1:1\r\n".to_owned(), 403),
        (format!("{own}Origin: http://example.com\r\n"), 403),
        (format!("{own}Origin: null\r\n"), 403),
        (format!("{own}Sec-Fetch-Site: cross-site\r\n"), 403),
    ];
    for (headers, status) in cases {
        assert_eq!(view.request("GET /scene", &headers).status, status, "{headers}");
    }
    for method in ["POST", "PUT", "DELETE", "OPTIONS"] {
        assert_eq!(view.request(&format!("{method} /scene"), &own).status, 405, "{method}");
    }
}

#[test]
fn nothing_else_is_served_from_disk() {
    let view = View::of(VASE, &[]);
    for path in
        ["/spec.trim", "/../spec.trim", "/%2e%2e/spec.trim", "//etc/passwd", "/etc/passwd", "/viewer.js/x", "/dist"]
    {
        assert_eq!(view.get(path).status, 404, "{path}");
    }
}

#[test]
fn scene_has_sliders_patches_and_programs() {
    let view = View::of(VASE, &[]);
    let scene = view.get("/scene").json();
    assert_eq!((&scene["is_current"], &scene["findings"]), (&Value::Bool(true), &Value::Array(Vec::new())));
    let parameters = scene["solved"]["parameters"].as_array().expect("parameters");
    let r = parameters.iter().find(|parameter| parameter["name"] == "r").expect("r");
    assert_eq!(r["range"], serde_json::json!([0.5, 2.0]));
    let coefficients = parameters.iter().filter(|parameter| parameter["is_coefficient"] == true).count();
    assert_eq!(coefficients, 5);
    let patch = &scene["solved"]["patches"][0];
    // The rim of radius r at u = 0: the series of cos v at the low end is Σ (-1)^k c_k.
    assert_eq!(patch["form"]["kind"], "separable");
    let rows = patch["form"]["amplitudes"]["coefficients"].as_array().expect("rows");
    let at_low_end: f64 = rows
        .iter()
        .enumerate()
        .map(|(k, row)| row[0].as_f64().expect("a number") * if k % 2 == 0 { 1.0 } else { -1.0 })
        .sum();
    assert!((at_low_end - 1.0).abs() < 1e-14, "{at_low_end}");
    let conditions = |side: usize| patch["boundary"][side]["conditions"].as_array().map(Vec::len);
    assert_eq!((conditions(0), conditions(1)), (Some(4), Some(0)));
}

#[test]
fn values_come_with_the_question_and_leave_no_trace() {
    let view = View::of(VASE, &[]);
    let r_of = |answer: &Value| answer["solved"]["parameters"][0]["value"].as_f64();
    assert_eq!(r_of(&view.get("/scene?set=r%3D1.5").json()), Some(1.5));
    assert_eq!(r_of(&view.get("/scene").json()), Some(1.0));
}

#[test]
fn wrong_questions_are_answered_with_findings() {
    let view = View::of(VASE, &[]);
    for (path, status, fragment) in [
        ("/scene?t=now", 400, "not a number"),
        ("/scene?t=inf", 400, "not a number"),
        ("/export?format=exe", 400, "no format"),
        ("/export?grid=64", 400, "not a grid"),
        ("/export?grid=0x4", 422, "no quads"),
        ("/export?grid=100000x100000", 422, "samples"),
        ("/export?set=r%3D1/0", 422, "infinity"),
        ("/residual?set=q%3D1", 422, "q"),
        ("/vertices?patches=1", 400, "no patch number 1"),
        ("/vertices?patches=first", 400, "numbers"),
        ("/vertices?grid=0x4", 422, "no quads"),
        ("/vertices?grid=100000x100000", 422, "samples"),
        ("/gaps?set=q%3D1", 422, "q"),
    ] {
        let answer = view.get(path);
        assert_eq!(answer.status, status, "{path}: {}", answer.body);
        let message = answer.json()["findings"][0]["message"].as_str().expect("a message").to_owned();
        assert!(message.contains(fragment), "{path}: {message}");
    }
    assert_eq!(view.get(&format!("/scene?x={}", "1".repeat(40_000))).status, 414);
}

#[test]
fn finding_has_its_place_in_the_value_that_was_sent() {
    let view = View::of(VASE, &[]);
    let scene = view.get("/scene?set=r%3D2%2B").json();
    assert_eq!(scene["solved"], Value::Null);
    let finding = &scene["findings"][0];
    assert_eq!((finding["source"].as_str(), finding["code"].as_str()), (Some("--set r"), Some("E0102")));
    assert_eq!(finding["place"]["text"], "2+");
}

#[test]
fn export_is_the_mesh_of_the_command_line() {
    let view = View::of(VASE, &[]);
    let target = view.folder.path().join("expected.obj");
    let status = Command::new(env!("CARGO_BIN_EXE_trimline"))
        .args(["mesh", "--grid", "5x7", "--set", "r=0.75", "--quiet", "-o"])
        .args([&target, &view.spec()])
        .status();
    assert!(status.expect("the command runs").success());
    let answer = view.get("/export?format=obj&grid=5x7&set=r%3D0.75");
    assert_eq!(answer.status, 200, "{}", answer.body);
    assert!(answer.headers.contains("attachment; filename=\"spec.obj\""), "{}", answer.headers);
    assert_eq!(answer.body, std::fs::read_to_string(target).expect("a mesh"));
}

/// Rows of numbers that `eval` gives at points of the spec.
fn evaluated(spec: &Path, points: &[[f64; 3]]) -> Vec<Vec<f64>> {
    let folder = tempfile::tempdir().expect("a folder");
    let rows: String = points.iter().map(|[u, v, t]| format!("{u:?},{v:?},{t:?}\n")).collect();
    let table = folder.path().join("points.csv");
    std::fs::write(&table, format!("u,v,t\n{rows}")).expect("a file");
    let output = Command::new(env!("CARGO_BIN_EXE_trimline"))
        .args([Path::new("eval"), spec, Path::new("--points"), &table])
        .args(["--derivatives", "u,v"])
        .output()
        .expect("the command runs");
    let text = String::from_utf8(output.stdout).expect("text");
    let numbers = |line: &str| line.split(',').skip(3).map(|number| number.parse().expect("a number")).collect();
    text.lines().skip(1).map(numbers).collect()
}

#[test]
fn surface_that_is_no_sum_of_products_comes_as_vertices_with_normals() {
    let text = "at u = 0: S = [(1 + t) cos v, sin v, 0], ∂S/∂u = [0, 0, 1]\n\
                at u = 1: S = [cos v, sin v, 2], ∂S/∂u = [0, 0, 1]\n\
                deform u in [0.2, 0.8], v in [1, 6] by [0.5, t, 0] keeping C1\n";
    let view = View::of(text, &[]);
    let scene = view.get("/scene").json();
    let patch = &scene["solved"]["patches"][0];
    assert_eq!(patch["form"], serde_json::json!({ "kind": "sampled" }));
    assert_eq!(patch["regions"], serde_json::json!([[[0.2, 0.8], [1.0, 6.0]]]));
    let answer = view.get("/vertices?patches=0&grid=5x7&t=0.75");
    assert_eq!(answer.status, 200, "{}", answer.body);
    assert!(answer.headers.contains("trimline-revision: 1"), "{}", answer.headers);
    let numbers: Vec<f64> =
        answer.bytes.chunks(4).map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap()))).collect();
    let vertices = 6 * 8;
    assert_eq!(numbers.len(), 8 * vertices);
    let node = |k: usize| [(k / 8) as f64 / 5.0, (k % 8) as f64 / 7.0 * std::f64::consts::TAU, 0.75];
    let expected = evaluated(&view.spec(), &(0..vertices).map(node).collect::<Vec<_>>());
    for (k, row) in expected.iter().enumerate() {
        let (position, normal) = (&numbers[4 * k..4 * k + 3], &numbers[4 * (vertices + k)..4 * (vertices + k) + 3]);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        // Single precision of numbers up to 3.
        assert!(position.iter().zip(row).all(|(a, b)| (a - b).abs() < 4e-7), "{k}: {position:?} {row:?}");
        assert!((dot(normal, normal) - 1.0).abs() < 4e-7, "{k}: {normal:?}");
        for tangent in [&row[3..6], &row[6..9]] {
            assert!(dot(normal, tangent).abs() < 1e-6, "{k}: {normal:?} {tangent:?}");
        }
    }
}

#[test]
fn gaps_are_measured_along_every_edge_and_at_the_ends_of_v() {
    let patch = |name: &str, from: f64, x: &str| {
        format!(
            "patch {name} {{\ndomain u in [{from}, {}]\n\
             at u = {from}: S = [{x}, sin v, {from}], ∂S/∂u = [0, 0, 1]\n\
             at u = {0}: S = [cos v, sin v, {0}], ∂S/∂u = [0, 0, 1]\n}}\n",
            from + 1.0
        )
    };
    // The second begins a little beside the end of the first, by 2e-4 (1 - cos v) / 2.
    let view = View::of(&(patch("a", 0.0, "cos v") + &patch("b", 1.0, "cos v + 1e-4 (1 - cos v)")), &[]);
    let gaps = view.get("/gaps").json();
    let lines = |patch: usize, kind: &str| gaps["patches"][patch][kind].as_array().expect("lines").clone();
    let values = |line: &Value| line["values"].as_array().expect("values").iter().filter_map(Value::as_f64).collect();
    for patch in 0..2 {
        let boundary = lines(patch, "boundary");
        assert_eq!(boundary.len(), 2);
        let largest = boundary.iter().flat_map(|line| -> Vec<f64> { values(line) }).fold(0.0, f64::max);
        assert!(largest < 1e-14, "{largest}");
    }
    let (first, second) = (lines(0, "seams"), lines(1, "seams"));
    let places =
        |lines: &[Value]| lines.iter().map(|line| format!("{} {}", line["across"], line["at"])).collect::<Vec<_>>();
    assert_eq!(places(&first), ["\"v\" 0.0", "\"v\" 6.283185307179586", "\"u\" 1.0"]);
    assert_eq!(places(&second), ["\"v\" 0.0", "\"v\" 6.283185307179586", "\"u\" 1.0"]);
    for seam in [&first[2], &second[2]] {
        let found: Vec<f64> = values(seam);
        let last = (found.len() - 1) as f64;
        for (k, gap) in found.iter().enumerate() {
            let v = std::f64::consts::TAU * k as f64 / last;
            assert!((gap - 1e-4 * (1.0 - v.cos())).abs() < 1e-14, "{k}: {gap}");
        }
    }
}

#[test]
fn terms_of_the_equation_that_vanish_return_with_their_slider() {
    let text = "param c = 0, g = 1\npde d4S/du4 + c d4S/du2dv2 + g d4S/dv4 = 0\n\
                at u = 0: S = [exp(cos(v)), sin v, 0], dS/du = [0, 0, 1]\nat u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]";
    let view = View::of(text, &[]);
    let ask = |c: &str| view.get(&format!("/export?format=obj&grid=6x12&set=c={c}")).body;
    let spec = view.spec().to_string_lossy().into_owned();
    for c in ["0", "20", "0"] {
        let target = view.folder.path().join("direct.obj");
        let set = format!("c={c}");
        let arguments = ["mesh", &spec, "-o", &target.to_string_lossy(), "--grid", "6x12", "--set", &set, "--quiet"];
        let status = Command::new(env!("CARGO_BIN_EXE_trimline")).args(arguments).status().expect("run");
        assert!(status.success(), "c = {c}");
        assert_eq!(ask(c), std::fs::read_to_string(&target).expect("written"), "c = {c}");
    }
}

#[test]
fn residual_of_an_exact_solution_is_rounding() {
    let view = View::of(VASE, &["--method", "exact"]);
    let field = &view.get("/residual").json()["patches"][0];
    let values = field["values"].as_array().expect("values");
    assert_eq!(values.len() as u64, field["rows"].as_u64().unwrap_or(0) * field["columns"].as_u64().unwrap_or(0));
    // Exact solutions are refused above 1e-6; this one is resolved to rounding in fourth derivatives.
    assert!(values.iter().all(|value| value.as_f64().is_some_and(|value| value < 1e-9)));
}

#[test]
fn motion_is_for_solutions_of_one_instant_only() {
    let moving = VASE.replace("[r cos v,", "[r e^t cos v,") + "pde with ρ = 1, η = 1\n";
    let exact = View::of(&moving, &["--method", "exact"]);
    assert_eq!(exact.get("/motion").json()["patches"], serde_json::json!([null]));
    let fitted = View::of(&moving, &["--method", "sine"]);
    let motion = &fitted.get("/motion").json()["patches"][0];
    assert!(motion["error"].as_f64().is_some_and(|error| error <= 1e-4), "{motion}");
    let instants = motion["instants"].as_array().expect("instants").len();
    assert_eq!(motion["amplitudes"].as_array().expect("a table").len(), instants);
}

#[test]
fn saved_edit_is_announced_and_a_broken_one_keeps_the_surface() {
    let view = View::of(VASE, &[]);
    let mut events = BufReader::new(view.connect());
    let request = format!("GET /events HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", view.port);
    events.get_mut().write_all(request.as_bytes()).expect("sent");
    let mut next = || {
        let mut line = String::new();
        loop {
            line.clear();
            assert!(events.read_line(&mut line).expect("an event in time") > 0, "the stream ended");
            if let Some(revision) = line.strip_prefix("data: ") {
                return revision.trim().parse::<u64>().expect("a number");
            }
        }
    };
    assert_eq!(next(), 1);
    std::fs::write(view.spec(), VASE.replace("2 sin v", "q sin v")).expect("saved");
    let broken = next();
    assert!(broken > 1);
    let scene = view.get("/scene").json();
    assert_eq!((&scene["is_current"], scene["revision"].as_u64()), (&Value::Bool(false), Some(broken)));
    assert_eq!(scene["findings"][0]["code"], "E0201");
    assert_eq!(scene["findings"][0]["place"]["line"], 3);
    assert!(scene["solved"]["patches"][0]["form"]["amplitudes"].is_object(), "the last good surface is gone");
    std::fs::write(view.spec(), VASE.replace("r = 1", "r = 1.25")).expect("saved");
    assert!(next() > broken);
    let mended = view.get("/scene").json();
    assert_eq!(
        (&mended["is_current"], mended["solved"]["parameters"][0]["value"].as_f64()),
        (&Value::Bool(true), Some(1.25))
    );
}

#[test]
fn saved_data_file_is_read_again() {
    let ring = |x: f64| format!("{x},0,0\n0.6,0.8,0\n-0.2,0.9,0\n-1,0.1,0\n-0.7,-0.7,0\n0.1,-1,0\n0.8,-0.5,0\n");
    let text = VASE.replace("S = [r cos v, r sin v, 1]", "S = r C(v)");
    let view = View::of(&format!("curve C = points(\"ring.csv\")\n{text}"), &[]);
    let scene = view.get("/scene").json();
    assert_eq!((&scene["is_current"], &scene["findings"][0]["code"]), (&Value::Bool(false), &Value::from("E0221")));
    let mut known = scene["revision"].as_u64().expect("a number");
    for x in [1.0, 1.5] {
        std::fs::write(view.folder.path().join("ring.csv"), ring(x)).expect("saved");
        let scene = (0..600).find_map(|_| {
            let scene = view.get("/scene").json();
            let is_newer = scene["revision"].as_u64() > Some(known) && scene["is_current"] == Value::Bool(true);
            if !is_newer {
                std::thread::sleep(Duration::from_millis(50));
            }
            is_newer.then_some(scene)
        });
        let scene = scene.expect("the file is read again");
        known = scene["revision"].as_u64().expect("a number");
        let program = &scene["solved"]["patches"][0]["boundary"][0]["program"];
        let first = program["splines"][0]["coefficients"][0].as_f64().expect("a number");
        assert!((first - x).abs() < 1e-14, "{program}");
    }
}

#[test]
fn spec_that_does_not_exist_and_port_in_use_end_the_command() {
    let run = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_trimline")).arg("view").args(arguments).output();
        let output = output.expect("the command ends");
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    assert_eq!(run(&["no-such.trim"]).0, Some(2));
    let view = View::of(VASE, &[]);
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/eq13.trim");
    let (status, errors) = run(&[&example.to_string_lossy(), "--port", &view.port.to_string()]);
    assert_eq!(status, Some(5), "{errors}");
    assert!(errors.contains("cannot listen on 127.0.0.1"), "{errors}");
}
