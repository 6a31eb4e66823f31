//! Shapes between shapes: against values of extended precision, against sums of both shapes, and what does not fit.

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostic};
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::morph::{Kind, Sequence, distance, interpolate};
use trimline::problem::Problem;
use trimline::surface::Surface;

use crate::spec::{BOUNDARY, at, example, problem};

fn between(source: &str, target: &str) -> Problem {
    try_between(source, target).unwrap_or_else(|finding| panic!("{finding}"))
}

fn try_between(source: &str, target: &str) -> Result<Problem, Diagnostic> {
    interpolate(&problem(source), &problem(target), &Limits::default())
}

fn blend(problem: Problem) -> Blend {
    Blend::new(problem, &Options::default()).unwrap_or_else(|finding| panic!("{finding}"))
}

fn at_epsilon(source: &str, target: &str, epsilon: &str) -> Blend {
    let mut blend = blend(between(source, target));
    blend.set("ε", epsilon).unwrap_or_else(|found| panic!("{found:?}"));
    blend
}

fn modes_of(sequence: &Sequence) -> Vec<(f64, f64)> {
    let frames = (1..=sequence.steps()).map(|index| sequence.frame(index));
    frames.map(|frame| (frame.epsilon, frame.modes.expect("a number of modes"))).collect()
}

#[test]
fn glass_between_two_glasses_is_that_of_extended_precision_with_its_derivatives() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/p3_morph.json");
    let text = std::fs::read_to_string(path).expect("the reference");
    let reference: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let blend = at_epsilon(&example("p3_water_glass"), &example("p3_wine_glass"), "0.3");
    for (index, id) in ["patch_base", "patch_body"].into_iter().enumerate() {
        let variants = reference["variants"].as_array().expect("variants");
        let variant = variants.iter().find(|variant| variant["id"] == id).expect("the patch");
        let solution = blend.solve(index, 0.0).expect("a surface");
        let rows = variant["values"].as_array().expect("rows");
        assert_eq!(rows.len(), 40);
        for row in rows {
            let row: Vec<f64> = row.as_array().expect("a row").iter().map(|x| x.as_f64().expect("a number")).collect();
            for (group, letters) in ["", "u", "v"].into_iter().enumerate() {
                let found = at(&*solution.surface, letters, [row[0], row[1], 0.0]);
                for (found, expected) in found.iter().zip(&row[2 + 3 * group..]) {
                    // A handful of rounded terms below 5.
                    assert!(
                        (found - expected).abs() <= 1e-12 * (1.0 + expected.abs()),
                        "{id} {letters} {row:?}: {found}"
                    );
                }
            }
        }
    }
}

#[test]
fn shape_between_is_the_weighted_sum_of_both_shapes() {
    // The problem is linear; source and target are solved on their own here, with their params.
    let (source, target) = (example("p3_positions"), example("p3_flask"));
    let middle = at_epsilon(&source, &target, "0.35").solve(0, 0.0).expect("a surface");
    let [source, target] = [source, target].map(|text| blend(problem(&text)).solve(0, 0.0).expect("a surface"));
    for i in 0..=10 {
        for j in 0..=17 {
            let point = [f64::from(i) / 10.0, std::f64::consts::TAU * f64::from(j) / 17.0, 0.0];
            for letters in ["", "u", "v", "uv"] {
                let [found, a, b] = [&middle, &source, &target].map(|solution| at(&*solution.surface, letters, point));
                for ((found, a), b) in found.iter().zip(a).zip(b) {
                    // Derivatives reach 50; rounding of some hundred terms.
                    assert!((found - (0.65 * a + 0.35 * b)).abs() <= 1e-11, "{letters} {point:?}");
                }
            }
        }
    }
}

#[test]
fn params_of_the_same_name_keep_a_value_in_each_shape() {
    let [thin, wide] = ["1", "3"].map(|r| {
        format!("param r = {r}\nat u = 0: S = [r cos v, r sin v, 0], dS/du = [0, 0, 1]\nat u = 1: S = [r cos v, r sin v, 1], dS/du = [0, 0, 1]")
    });
    let solution = at_epsilon(&thin, &wide, "0.25").solve(0, 0.0).expect("a surface");
    let [x, y, z] = at(&*solution.surface, "", [0.0, 0.0, 0.0]);
    assert!((x - 1.5).abs() < 1e-14 && y.abs() < 1e-14 && z.abs() < 1e-14, "{x} {y} {z}");
}

#[test]
fn force_is_interpolated_with_the_boundary() {
    let with_force = |q: &str| format!("pde d4S/du4 + d4S/dv4 = [{q}, 0, 0]\n{BOUNDARY}");
    let solution = at_epsilon(&with_force("24"), &with_force("72"), "0.5").solve(0, 0.0).expect("a surface");
    // S_uuuu + S_vvvv of the mode 0 of x, which cos v does not touch: the mean over v.
    let mean: f64 = (0..8)
        .map(|j| at(&*solution.surface, "uuuu", [0.5, std::f64::consts::FRAC_PI_4 * f64::from(j), 0.0])[0] / 8.0)
        .sum();
    assert!((mean - 48.0).abs() < 1e-9, "{mean}");
}

#[test]
fn examples_of_morphs_meet_their_boundary_with_the_remainder() {
    let names = [
        "p3_positions",
        "p3_flask",
        "p3_water_glass",
        "p3_wine_glass",
        "p3_water_glass_smooth",
        "p3_wine_glass_smooth",
        "p3_glasses",
        "p3_vase_to_flask",
    ];
    for name in names {
        let blend = blend(problem(&example(name)));
        for index in 0..blend.patches.len() {
            let solution = blend.solve(index, 0.0).expect("a surface");
            let miss = blend.verify(index, &solution, 0.0).expect("measured").boundary_error();
            assert!(miss <= 1e-12, "{name} patch {index}: {miss:.1e}");
        }
    }
}

#[test]
fn smooth_glasses_stay_smooth_at_the_seam_on_the_whole_way() {
    for epsilon in ["0", "0.1", "0.5", "0.77", "1"] {
        let blend = at_epsilon(&example("p3_water_glass_smooth"), &example("p3_wine_glass_smooth"), epsilon);
        let [base, body] = [0, 1].map(|index| blend.solve(index, 0.0).expect("a surface").surface);
        for j in 0..12 {
            let v = 0.5 * f64::from(j);
            let [below, above] = [at(&*base, "u", [1.0, v, 0.0]), at(&*body, "u", [0.0, v, 0.0])];
            for (below, above) in below.iter().zip(above) {
                assert!((10.0 * below - above).abs() < 1e-13, "ε = {epsilon}, v = {v}");
            }
        }
    }
}

#[test]
fn boundary_sequence_has_equal_steps_of_epsilon() {
    let sequence = Sequence::new(Kind::Boundary, None, [1, 1], &Limits::default()).expect("a sequence");
    assert_eq!(sequence.steps(), 9);
    assert_eq!(sequence.frame(3).epsilon, 0.3);
    assert_eq!(sequence.frame(9).epsilon, 0.9);
}

#[test]
fn modes_fall_to_one_and_rise_again_but_never_vanish() {
    let sequence = Sequence::new(Kind::Modes, None, [5, 3], &Limits::default()).expect("a sequence");
    let modes = modes_of(&sequence);
    let source = [5.0, 4.0, 3.0, 2.0, 1.0].map(|modes| (0.0, modes));
    let target = [1.0, 2.0, 3.0].map(|modes| (1.0, modes));
    assert_eq!(modes, [&source[..], &target[..]].concat());
}

#[test]
fn combined_sequence_is_that_of_the_paper_at_its_own_number_of_frames() {
    let sequence = Sequence::new(Kind::Both, None, [5, 5], &Limits::default()).expect("a sequence");
    let modes = [5.0, 4.0, 3.0, 2.0, 1.0, 1.0, 1.0, 2.0, 3.0, 4.0, 5.0];
    let expected: Vec<(f64, f64)> = modes.iter().enumerate().map(|(i, modes)| (i as f64 / 10.0, *modes)).collect();
    assert_eq!(modes_of(&sequence), expected);
}

#[test]
fn combined_sequence_of_more_frames_passes_between_numbers_of_modes() {
    let sequence = Sequence::new(Kind::Both, Some(21), [5, 5], &Limits::default()).expect("a sequence");
    assert_eq!(sequence.frame(2).modes, Some(4.5));
    assert_eq!(sequence.at(0.05).and_then(|frame| frame.modes), Some(4.5));
}

#[test]
fn sequences_of_a_wrong_length_are_refused() {
    let limits = Limits { frames: 20, ..Limits::default() };
    let cases = [
        (Kind::Boundary, Some(0), Code::SettingOutOfRange),
        (Kind::Boundary, Some(19), Code::LimitReached),
        (Kind::Boundary, Some(usize::MAX), Code::LimitReached),
        (Kind::Modes, Some(9), Code::SettingOutOfRange),
    ];
    for (kind, steps, code) in cases {
        let refused = Sequence::new(kind, steps, [5, 5], &limits).expect_err("a wrong length");
        assert_eq!(refused.code, code, "{kind:?} {steps:?}");
    }
    assert!(Sequence::new(Kind::Boundary, Some(18), [5, 5], &limits).is_ok());
    let empty = Sequence::new(Kind::Modes, None, [0, 0], &limits).expect_err("no frames");
    assert_eq!(empty.code, Code::SettingOutOfRange);
}

#[test]
fn shapes_that_do_not_correspond_are_refused_with_what_differs() {
    let spec = |head: &str| format!("{head}\n{BOUNDARY}");
    let two = "at u = 0: S = [cos v, sin v, 0], dS/du = 0; at u = 1: S = [cos v, sin v, 1], dS/du = 0";
    let cases = [
        (spec(""), spec("domain v in [0, 1]"), "patch `spec`: the ranges of v differ"),
        (spec(""), spec("pde with γ = 3"), "patch `spec`: the equations differ"),
        (spec(""), spec("pde d4S/du4 + d2S/dv2 = 0"), "patch `spec`: the equations differ"),
        (spec(""), BOUNDARY.replace("u = 1", "u = 0.5"), "constraint number 3 differs"),
        (spec("solve exact"), spec("solve fourier"), "the ways to solve differ"),
        (spec("solve fourier, modes = 4"), spec("solve fourier"), "the ways to solve differ"),
        (format!("patch a {{ {two} }}\npatch b {{ {two} }}"), spec(""), "the source has no patch `spec`"),
        (
            format!("patch a {{ {two} }}\npatch b {{ {two} }}"),
            format!("patch b {{ {two} }}"),
            "the target has no patch `a`",
        ),
    ];
    for (source, target, words) in cases {
        let refused = try_between(&source, &target).expect_err(words);
        assert_eq!(refused.code, Code::ShapesDiffer, "{words}");
        assert!(refused.message.contains(words), "{}", refused.message);
        assert!(!refused.hints.is_empty(), "{words}");
    }
}

#[test]
fn larger_number_of_modes_is_taken_for_the_shapes_between() {
    let spec = |modes: usize| example("p3_positions").replace("modes = 5", &format!("modes = {modes}"));
    let mut problem = between(&spec(3), &spec(7));
    let patch = problem.patches.pop().expect("a patch");
    assert_eq!(patch.solve.settings[0].value, "7");
}

#[test]
fn shapes_that_are_too_large_together_are_a_limit() {
    let limits = Limits { graph_nodes: 60, ..Limits::default() };
    let [source, target] = ["p3_positions", "p3_flask"].map(|name| problem(&example(name)));
    assert_eq!(interpolate(&source, &target, &limits).expect_err("too large").code, Code::LimitReached);
}

#[test]
fn distance_is_the_largest_of_any_point() {
    struct Bump(f64);
    impl Surface for Bump {
        fn evaluate(&self, _: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
            for ([u, ..], value) in points.iter().zip(values) {
                *value = [3.0 * self.0 * u, 4.0 * self.0 * u, 0.0];
            }
            Ok(())
        }
    }
    let found = distance(&Bump(1.0), &Bump(2.0), [[0.0, 1.0], [0.0, 1.0]], 0.0).expect("a distance");
    assert!((found - 5.0).abs() < 1e-15, "{found}");
}
