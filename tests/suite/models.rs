//! Models of many patches in specs: loops of edges, shared edges, patches with an apex, mirrored and repeated parts.

use std::f64::consts::TAU;
use std::fmt::Write;

use serde_json::Value;
use trimline::blend::Blend;
use trimline::diagnostic::{Code, Source};
use trimline::expr::{Derivative, Variable};
use trimline::method::Options;
use trimline::verify::{Edge, Line};

use crate::cli::{Folder, done, status, text, trimline};
use crate::spec::{all_examples, example, is_model, problem_within, told};

const UNIT: [f64; 2] = [0.0, 1.0];

/// A loop over an irregular polygon in space, whose edges sag and move.
fn polygon(count: usize) -> String {
    let corner = |index: usize| {
        let turn = TAU * (index % count) as f64 / count as f64;
        let angle = turn + 0.2 * (3.0 * turn + 1.0).sin() / count as f64;
        let radius = 1.0 + 0.25 * (2.0 * turn).cos();
        [radius * angle.cos(), radius * angle.sin(), 0.3 * (2.0 * turn + 0.5).sin()]
    };
    let mut spec = "param k = 1\nnsided hole {\n".to_owned();
    for index in 0..count {
        let ([a, b, c], [x, y, z]) = (corner(index), corner(index + 1));
        let sag = 0.4 * (1.0 + 2.0 * index as f64).sin();
        let line = |from: f64, to: f64| format!("({from:?})(1 - u) + ({to:?}) u");
        let bowed = format!("{} + ({sag:?}) k u (1 - u) (1 + t)", line(c, z));
        let _ = writeln!(spec, "    edge [{}, {}, {bowed}]", line(a, x), line(b, y));
    }
    spec + "}\n"
}

fn blend(spec: &str) -> Blend {
    let compiled = Blend::compile(&Source::new("spec", spec), &Options::default());
    compiled.unwrap_or_else(|found| panic!("{spec}\n{}", told(spec, &found)))
}

#[test]
fn loops_of_a_spec_are_filled_without_gap_crease_or_fold() {
    for count in 3..=8 {
        let blend = blend(&polygon(count));
        assert_eq!(blend.patches.len(), count);
        let t = 0.3;
        let solved: Vec<_> = (0..count).map(|patch| blend.solve(patch, t).expect("a surface").surface).collect();
        let edge = |patch: usize, across: Variable| {
            let line = Line { across, position: 1.0, domain: UNIT, along: UNIT };
            Edge::sample(&*solved[patch % count], line, t).expect("finite")
        };
        for (patch, surface) in solved.iter().enumerate() {
            let seam = edge(patch, Variable::U).meet(&edge(patch + 1, Variable::V));
            let angle = seam.angle_degrees.expect("normals");
            assert!(seam.gap <= 1e-12 && angle <= 1e-10, "{count} {patch}: {seam:?}");
            let inside: Vec<f64> = (1..9).map(|step| f64::from(step) / 9.0).collect();
            let values = |orders: Derivative| {
                let mut values = vec![[0.0; 3]; 64];
                surface.evaluate_grid(orders, (&inside, &inside, t), &mut values).expect("finite");
                values
            };
            let (u, v) = (values(Derivative::new(1, 0, 0)), values(Derivative::new(0, 1, 0)));
            // The polygon lies about the plane of x and y, so a patch that does not fold faces up everywhere.
            let up = u.iter().zip(&v).map(|(u, v)| u[0] * v[1] - u[1] * v[0]).fold(f64::INFINITY, f64::min);
            assert!(up > 0.0, "{count} {patch}: {up}");
        }
    }
}

/// Two halves of a tube that share an edge; what stands behind the edge, and the tangent of the upper half.
fn tube(edge: &str, tangent: &str) -> String {
    format!(
        "domain v in [0, π/2]
edge rim = [cos(π u/2), sin(π u/2), t]{edge}
patch low {{
    at u = 0: S = [cos v, sin v, -1], ∂S/∂u = [0, 0, 1]
    at u = 1: join rim{tangent}
}}
patch high {{
    at u = 0: S = [sin v, cos v, 1], ∂S/∂u = [0, 0, -1]
    at u = 1: join rim, reversed, flip{}
}}
",
        tangent.replace("0, 0, 1", "0.1 v, 0, -1")
    )
}

fn codes(spec: &str) -> Vec<Code> {
    let found = problem_within(spec, &Options::default().limits).map(|_| Vec::new());
    found.unwrap_or_else(|found| found).iter().map(|finding| finding.code).collect()
}

#[test]
fn shared_edge_is_a_seam_that_must_be_smooth_unless_it_is_a_crease() {
    let folder = Folder::new();
    let smooth = folder.spec(tube(", across = [0, 0, 1]", ""));
    let report: Value = serde_json::from_str(&done(&trimline(&["check", &smooth, "--format", "json"]))).expect("JSON");
    let seam = &report["seams"][0];
    assert_eq!(seam["stated"], true, "{report}");
    // Rounding of 1 at nine instants.
    assert!(seam["gap"].as_f64().expect("a gap") < 1e-15 && seam["angle_degrees"].as_f64().expect("an angle") < 1e-10);
    let tilted = ", ∂S/∂u = [0, 0, 1]";
    assert_eq!(codes(&tube("", tilted)), [Code::EdgeSidesDiffer]);
    assert_eq!(codes(&tube(" keeping C0", tilted)), []);
    // A patch that leaves an edge on the side of the other lies over it: planes agree, the surface folds.
    let folded = folder.spec(tube(", across = [0, 0, 1]", "").replace(", flip", ""));
    let output = trimline(&["check", &folded]);
    assert_eq!(status(&output), 1);
    assert!(text(&output.stderr).contains("E0711"), "{}", text(&output.stderr));
}

#[test]
fn loop_and_patch_go_on_smoothly_across_the_edge_they_share() {
    // A square whose edge y = 0 bulges down; the patch below leaves it as the loop enters.
    let spec = "domain t in [0, 1]
edge front = [u, 0, -t u^2 (1 - u)^2], across = [0, 1, 0]
nsided cap {
    edge front
    edge [1, u, 0]
    edge [1 - u, 1, 0]
    edge [0, 1 - u, 0]
    centre = [0.5, 0.5, 0.1]
}
patch apron {
    domain v in [0, 1]
    pde with γ = 3
    at u = 0: S = [v, -1, 0], ∂S/∂u = [0, 1, 0]
    at u = 1: join front
}
";
    let folder = Folder::new();
    let output = done(&trimline(&["check", &folder.spec(spec), "--format", "json", "--max-gap", "1e-12"]));
    let report: Value = serde_json::from_str(&output).expect("JSON");
    let seams = report["seams"].as_array().expect("seams");
    let stated: Vec<&Value> = seams.iter().filter(|seam| seam["stated"] == true).collect();
    // The edge is divided between two patches of the loop; beside it there are four seams inside.
    assert_eq!((stated.len(), seams.len()), (2, 6), "{output}");
    for seam in seams {
        assert!(seam["angle_degrees"].as_f64().expect("an angle") < 1e-10, "{seam}");
    }
    assert_eq!(stated[0]["between"][1]["part"], serde_json::json!([0.0, 0.5]), "{output}");
}

#[test]
fn octant_of_three_sides_is_smooth_at_its_apex() {
    let octant = "domain u in [0, 1], v in [0, 1]
at u = 0: S = [cos(π v/2), sin(π v/2), 0], ∂S/∂u = [0, 0, π/2]
at v = 0: S = [cos(π u/2), 0, sin(π u/2)], ∂S/∂v = [0, cos(π u/2) π/2, 0]
at v = 1: S = [0, cos(π u/2), sin(π u/2)], ∂S/∂v = [-cos(π u/2) π/2, 0, LIFT]
at u = 1: apex
";
    let folder = Folder::new();
    let output = trimline(&["check", &folder.spec(octant.replace("LIFT", "0")), "--max-gap", "1e-12"]);
    assert!(done(&output).contains("passed") && !text(&output.stderr).contains("W0708"), "{}", text(&output.stderr));
    let tilted = trimline(&["check", &folder.spec(octant.replace("LIFT", "0.3 u^2 (1 - u)"))]);
    let said = text(&tilted.stderr);
    assert!(said.contains("W0708") && said.contains("degrees out of one plane"), "{said}");
    // At the apex ∂S/∂u is the cubic of v between the tangents of both sides, with the slopes that ∂S/∂v has there.
    let angle = |v: f64| {
        let (half, slope) = (std::f64::consts::FRAC_PI_2, std::f64::consts::PI.powi(2) / 4.0);
        let (smooth, first, last) = (3.0 * v * v - 2.0 * v.powi(3), v * (1.0 - v).powi(2), v * v * (v - 1.0));
        let (x, y, z) = (-half * (1.0 - smooth) + slope * last, -half * smooth - slope * first, -0.3 * last);
        (z / x.hypot(y)).atan().to_degrees().abs()
    };
    let expected = (0..=60).map(|step| angle(f64::from(step) / 60.0)).fold(0.0, f64::max);
    for (lift, expected, tolerance) in [("0", 0.0, 1e-9), ("0.3 u^2 (1 - u)", expected, 1e-9)] {
        let spec = folder.spec(octant.replace("LIFT", lift));
        let report: Value =
            serde_json::from_str(&done(&trimline(&["check", &spec, "--format", "json"]))).expect("JSON");
        let apexes = report["patches"][0]["apexes"].as_array().expect("a list");
        assert_eq!((apexes.len(), &apexes[0]["u"]), (1, &Value::from(1.0)), "{apexes:?}");
        let found = apexes[0]["angle_degrees"].as_f64().expect("a plane");
        assert!((found - expected).abs() <= tolerance, "{found} {expected}");
        assert!(done(&trimline(&["check", &spec])).contains("apex at u = 1        tangents leave one plane by up to "));
    }
}

/// A bent blade that moves, with two copies of different kinds.
const BLADES: &str = "param c = 0.25
domain v in [0, 1], t in [0, 1]
patch blade {
    at u = 0: S = [1, v, 0.2 t v], ∂S/∂u = [1, 0, 0]
    at u = 1: S = [2, v + 1, t], ∂S/∂u = [1, 0, v]
}
repeat blade 3 times rotated about z by 2π/3 + t
mirror blade in y = c
repeat blade 2 times moved by [0, t^2, 5]
";

#[test]
fn copies_are_images_of_their_original_at_every_instant() {
    let folder = Folder::new();
    let points = folder.path("points.csv");
    let names = ["blade", "blade2", "blade3", "blade_mirrored"];
    let rows: Vec<String> = names.iter().map(|name| format!("{name},0.3,0.6,0.5\n")).collect();
    std::fs::write(&points, format!("patch,u,v,t\n{}", rows.concat())).expect("a folder to write to");
    let spec = folder.spec(BLADES.lines().take(8).collect::<Vec<_>>().join("\n"));
    let points = points.to_string_lossy().into_owned();
    let table = done(&trimline(&["eval", &spec, "--points", &points, "--derivatives", "u,t"]));
    let found: Vec<Vec<f64>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').skip(4).map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    let [base, second, third, mirrored] = found.as_slice() else { panic!("{table}") };
    for (copy, turns) in [(second, 1.0), (third, 2.0)] {
        let angle = turns * (TAU / 3.0 + 0.5);
        let turned = |x: f64, y: f64| [angle.cos() * x - angle.sin() * y, angle.sin() * x + angle.cos() * y];
        let [x, y] = turned(base[0], base[1]);
        let [x_u, y_u] = turned(base[3], base[4]);
        // d/dt R(angle(t)) S = R S_t + angle' R' S
        let [x_t, y_t] = turned(base[6], base[7]);
        let expected = [x, y, base[2], x_u, y_u, base[5], x_t - turns * y, y_t + turns * x, base[8]];
        for (found, expected) in copy.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{copy:?}\n{expected:?}");
        }
    }
    for (axis, (found, base)) in mirrored.iter().zip(base).enumerate() {
        let expected = match axis {
            1 => 0.5 - base,
            4 | 7 => -base,
            _ => *base,
        };
        assert!((found - expected).abs() < 1e-15, "{axis}: {found} {expected}");
    }
}

#[test]
fn copies_of_copies_have_names_and_one_copy_can_be_asked_for() {
    let problem = problem_within(&BLADES.replace("repeat blade 2", "repeat blade2 2"), &Options::default().limits)
        .unwrap_or_else(|found| panic!("{}", told(BLADES, &found)));
    let names: Vec<&str> = problem.copies.iter().map(|copy| copy.name.as_str()).collect();
    assert_eq!(names, ["blade2", "blade3", "blade_mirrored", "blade22"]);
    let folder = Folder::new();
    let spec = folder.spec(BLADES.lines().take(8).collect::<Vec<_>>().join("\n"));
    let mesh = folder.path("copy.obj");
    done(&trimline(&["mesh", &spec, "--patch", "blade_mirrored", "--grid", "2x2", "-o", &mesh.to_string_lossy()]));
    let written = std::fs::read_to_string(&mesh).expect("a mesh");
    assert!(written.contains("blade_mirrored") && !written.contains("blade3"), "{written}");
    let emitted = done(&trimline(&["emit", &spec, "--patch", "blade_mirrored", "--lang", "c"]));
    assert!(emitted.contains("a copy of blade") && emitted.contains("A mirror image"), "{emitted}");
}

#[test]
fn copy_so_far_away_that_no_digits_of_it_remain_is_refused() {
    let folder = Folder::new();
    for (plane, is_lost) in [("1e300", true), ("1e12", true), ("1e5", false)] {
        let text = BLADES.lines().take(6).chain(["mirror blade in y = "]).collect::<Vec<_>>().join("\n");
        let spec = folder.spec(format!("{text}{plane}"));
        for chosen in [&[][..], &["--patch", "blade_mirrored"]] {
            let checked = trimline(&[&["check", &spec], chosen].concat());
            assert_eq!(text_of(&checked).contains("E0713"), is_lost, "{plane}: {}", text_of(&checked));
        }
    }
}

/// What a command says on standard error.
fn text_of(output: &std::process::Output) -> String {
    text(&output.stderr)
}

#[test]
fn mirrored_mesh_faces_outward_as_its_original_does() {
    // The cubic across a cylinder is the cylinder.
    let spec = "patch half {
    pde ∂⁴S/∂u⁴ = 0
    at u = 0: S = [cos v, sin v + 2, 0], ∂S/∂u = [0, 0, 1]
    at u = 1: S = [cos v, sin v + 2, 1], ∂S/∂u = [0, 0, 1]
}
mirror half in y = 0
";
    let folder = Folder::new();
    let mesh = folder.path("both.obj");
    done(&trimline(&["mesh", &folder.spec(spec), "--grid", "2x8", "-o", &mesh.to_string_lossy()]));
    let written = std::fs::read_to_string(&mesh).expect("a mesh");
    let vectors = |key: &str| -> Vec<[f64; 3]> {
        let rows = written.lines().filter_map(|line| line.strip_prefix(key));
        let parse = |row: &str| {
            let numbers: Vec<f64> = row.split_whitespace().map(|x| x.parse().expect("a number")).collect();
            [numbers[0], numbers[1], numbers[2]]
        };
        rows.map(parse).collect()
    };
    let (points, normals) = (vectors("v "), vectors("vn "));
    assert_eq!((points.len(), normals.len()), (48, 48), "{written}");
    let outward: Vec<f64> =
        points.iter().zip(&normals).map(|(p, n)| n[0] * p[0] + n[1] * (p[1] - 2.0 * p[1].signum())).collect();
    let sign = outward[0].signum();
    assert!(outward.iter().all(|along| (along * sign - 1.0).abs() < 1e-12), "{outward:?}");
}

#[test]
fn loop_is_copied_as_a_whole() {
    let folder = Folder::new();
    let spec = folder.spec(polygon(3) + "repeat hole 2 times moved by [0, 0, 3]\n");
    let output = done(&trimline(&["check", &spec, "--time", "0", "--format", "json"]));
    let report: Value = serde_json::from_str(&output).expect("JSON");
    assert_eq!(
        report["copies"][2],
        serde_json::json!({"spec": spec, "name": "hole2.3", "original": "hole.3"}),
        "{output}"
    );
    assert_eq!(report["seams"].as_array().map(Vec::len), Some(6), "{output}");
}

/// The path of an example.
fn path(name: &str) -> String {
    format!("{}/examples/{name}.trim", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn examples_of_models_are_closed_and_smooth_at_every_instant() {
    let models: Vec<_> = all_examples().into_iter().filter(|(_, text)| is_model(text)).collect();
    assert!(models.len() >= 3);
    for (name, _) in models {
        let output = done(&trimline(&["check", &path(&name), "--max-gap", "1e-9", "--max-angle", "0.01"]));
        assert!(output.ends_with("passed\n"), "{name}\n{output}");
    }
}

#[test]
fn aircraft_has_its_parts_and_can_be_shaped() {
    let text = example("aircraft");
    assert!(text.lines().count() < 300);
    let problem = problem_within(&text, &Options::default().limits).expect("an example");
    let names: Vec<&str> = (0..).map_while(|index| problem.part_name(index)).collect();
    let count = |stem: &str| names.iter().filter(|name| name.starts_with(stem)).count();
    // Four engines of four patches, each on a pylon.
    assert_eq!((count("hull_"), count("wing_"), count("tail_"), count("fin_")), (4, 6, 6, 3), "{names:?}");
    assert_eq!((count("pod_"), count("pylon")), (16, 4), "{names:?}");
    let shaped = ["--set", "span=21", "--set", "sweep=11", "--set", "dihedral=-0.5", "--set", "cabin=21"];
    let limits = ["--max-gap", "1e-9", "--max-angle", "0.01", "--time", "0.5"];
    done(&trimline(&[&["check", &path("aircraft")], &shaped[..], &limits[..]].concat()));
}

#[test]
fn wings_of_the_aircraft_flex_and_their_roots_stay_on_the_fuselage() {
    let folder = Folder::new();
    let points = folder.path("points.csv");
    let places = "wing_tip,1,0,0\nwing_tip,1,0,0.5\nwing_joint,0,1,0\nwing_joint,0,1,0.5\n";
    std::fs::write(&points, format!("patch,u,v,t\n{places}")).expect("a folder to write to");
    let table = done(&trimline(&["eval", &path("aircraft"), "--points", &points.to_string_lossy()]));
    let rows: Vec<Vec<f64>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').skip(4).map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    // All of `flex` = 1.2 at the tip, when sin(π t) is 1; the fuselage, of radius 2, stands still.
    assert!((rows[1][2] - rows[0][2] - 1.2).abs() < 1e-12, "{table}");
    assert_eq!(rows[2], rows[3], "{table}");
    assert!((rows[2][1].hypot(rows[2][2]) - 2.0).abs() < 1e-14, "{table}");
}

#[test]
fn aircraft_is_written_for_cad_and_as_an_animation() {
    let folder = Folder::new();
    let [step, glb] = ["aircraft.step", "aircraft.glb"].map(|name| folder.path(name).to_string_lossy().into_owned());
    done(&trimline(&["fit", &path("aircraft"), "--time", "0.5", "-o", &step]));
    let written = std::fs::read_to_string(&step).expect("a file");
    assert_eq!(written.matches("=B_SPLINE_SURFACE_WITH_KNOTS(").count(), 39);
    done(&trimline(&["mesh", &path("aircraft"), "--grid", "4x12", "--frames", "3", "-o", &glb]));
    assert!(std::fs::read(&glb).expect("a file").starts_with(b"glTF"));
}
