//! The method `four_sided` against surfaces that are known everywhere: exact solutions of the equation, made-up ones with
//! their force, and reference values computed elsewhere.

use serde_json::Value;
use trimline::diagnostic::Code;
use trimline::expr::Derivative;
use trimline::method::Options;
use trimline::surface::Surface;

use crate::sides::{distance, manufactured, restrict, solve, terms, with_vector};

const UNIT: &str = "domain u in [0, 1], v in [0, 1], t in [0, 1]";
const BIHARMONIC: &str = "d4S/du4 + 2*d4S/du2dv2 + d4S/dv4";
/// Biharmonic in each component: the example of the reference.
const KNOWN: &str =
    "[u + v*exp(u)*cos(v)/10, 3/20*u*exp(v)*sin(u) + v, (3/10*u^2 + 3/10*v^2)*(u^3 - 3*u*v^2) + cos(2*u)*cosh(2*v)/5]";
/// No solution of anything: needs a force.
const ANY: &str = "[u + sin(2*u + v), v + exp(u*v)/3, cos(3*v - u)]";

#[test]
fn biharmonic_surface_is_reproduced_from_its_four_sides() {
    let (mut problem, known) = with_vector(UNIT, BIHARMONIC, KNOWN);
    restrict(&mut problem, known);
    let (blend, solution) = solve(&problem, &Options::default(), 0.0).expect("solvable");
    assert_eq!(solution.report.method, "four_sided");
    assert!(solution.report.warnings.is_empty(), "{:?}", solution.report.warnings);
    // The terms of 12 x 12 that are left out are below rounding; derivatives magnify rounding by (2 · 12)² per order.
    assert!(distance(&blend, &*solution.surface, known, Derivative::NONE, 0.0) < 1e-14);
    assert!(distance(&blend, &*solution.surface, known, Derivative::new(1, 1, 0), 0.0) < 1e-11);
    assert!(distance(&blend, &*solution.surface, known, Derivative::new(2, 2, 0), 0.0) < 1e-8);
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert_eq!(measured.boundary_errors.len(), 8);
    assert!(measured.boundary_error() < 4e-15, "{:?}", measured.boundary_errors);
    assert!(measured.relative_residual() < 1e-8, "{:.1e}", measured.relative_residual());
}

#[test]
fn biharmonic_surface_agrees_with_the_reference_values() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/p4_four_sided.json");
    let reference: Value =
        serde_json::from_str(&std::fs::read_to_string(path).expect("the file is there")).expect("JSON");
    let (mut problem, known) = with_vector(UNIT, BIHARMONIC, KNOWN);
    restrict(&mut problem, known);
    // What the reference found with as many terms: 9.4e-9 and 4.7e-14, and 1.5e-6 with 2.
    for (count, tolerance) in [("2", 3e-6), ("4", 2e-8), ("8", 1e-13)] {
        let (_, solution) = solve(&problem, &terms(count), 0.0).expect("solvable");
        let rows = reference["samples_u_v_x_y_z"].as_array().expect("rows");
        assert_eq!(rows.len(), 81);
        let mut worst = 0.0_f64;
        for row in rows {
            let row: Vec<f64> = row.as_array().expect("a row").iter().filter_map(Value::as_f64).collect();
            let mut found = [[0.0; 3]];
            solution.surface.evaluate(Derivative::NONE, &[[row[0], row[1], 0.0]], &mut found).expect("inside");
            worst = found[0]
                .iter()
                .zip(&row[2..])
                .fold(worst, |most, (found, expected)| most.max((found - expected).abs()));
        }
        assert!(worst < tolerance, "{count} terms: {worst:.1e}");
        assert!(count == "8" || worst > tolerance / 100.0, "{count} terms: {worst:.1e}");
    }
}

#[test]
fn made_up_surface_with_its_force_is_found_for_any_coefficients() {
    let general = "domain u in [-1, 2], v in [0, 1/2], t in [0, 1]";
    let cases = [
        (UNIT, "d4S/du4 + 1/2*d4S/du2dv2 + 3*d4S/dv4"),
        // On a range that is not the unit square, with lower and odd derivatives.
        (general, "d4S/du4 + d4S/du3dv + 2*d4S/du2dv2 + 2*d4S/dv4 - 3*d2S/du2 + d3S/du2dv + dS/dv + 5*S"),
        // Coefficients in u and v, and one per component.
        (UNIT, "(1 + u*v)*d4S/du4 + 2*cos(u)*d4S/du2dv2 + exp(v)*d4S/dv4 + v*dS/du"),
        (UNIT, "[1, 2, 3]*d4S/du4 + 2*d4S/du2dv2 + [1, 1 + u, 4]*d4S/dv4"),
    ];
    for (domain, equation) in cases {
        let (problem, known) = manufactured(domain, equation, ANY);
        let (blend, solution) = solve(&problem, &terms("14"), 0.0).expect("solvable");
        // Smooth data: 14 terms leave rounding, which a condition of up to 1e5 may magnify.
        let worst = distance(&blend, &*solution.surface, known, Derivative::NONE, 0.0);
        assert!(worst < 1e-11, "{equation}: {worst:.1e}");
        let measured = blend.verify(0, &solution, 0.0).expect("finite");
        assert!(measured.boundary_error() < 4e-14, "{equation}: {:?}", measured.boundary_errors);
        assert!(measured.relative_residual() < 1e-6, "{equation}: {:.1e}", measured.relative_residual());
    }
}

#[test]
fn boundary_is_met_whatever_the_number_of_terms() {
    let (problem, known) = manufactured(UNIT, BIHARMONIC, ANY);
    let mut before = f64::INFINITY;
    for count in ["1", "2x5", "6", "10"] {
        let (blend, solution) = solve(&problem, &terms(count), 0.0).expect("solvable");
        let measured = blend.verify(0, &solution, 0.0).expect("finite");
        assert!(measured.boundary_error() < 2e-14, "{count}: {:?}", measured.boundary_errors);
        let error = distance(&blend, &*solution.surface, known, Derivative::NONE, 0.0);
        assert!(error < before, "{count}: {error:.1e} after {before:.1e}");
        before = error;
    }
}

#[test]
fn corners_that_no_smooth_solution_fits_limit_the_rate() {
    // The data of a surface that does not solve the equation, without its force: second derivatives do not fit in the
    // corners. Twice the terms leave about a hundredth, where smooth solutions leave a millionth.
    let (mut problem, known) = with_vector(UNIT, "d4S/du4 + 1/2*d4S/du2dv2 + 3*d4S/dv4", ANY);
    restrict(&mut problem, known);
    let lines: Vec<f64> = (0..=40).map(|step| f64::from(step) / 40.0).collect();
    let values = |count: &str| {
        let (_, solution) = solve(&problem, &terms(count), 0.0).expect("solvable");
        let mut values = vec![[0.0; 3]; 41 * 41];
        solution.surface.evaluate_grid(Derivative::NONE, (&lines, &lines, 0.0), &mut values).expect("inside");
        values
    };
    let best = values("26");
    let [few, more] = ["8", "16"].map(|count| {
        let found = values(count);
        found.iter().flatten().zip(best.iter().flatten()).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
    });
    assert!(few < 1e-5 && (30.0..1000.0).contains(&(few / more)), "{few:.1e} {more:.1e}");
}

#[test]
fn params_and_time_change_the_data_and_nothing_is_compiled_again() {
    let before = "param r = 1/2\ndomain u in [0, 1], v in [0, 1], t in [0, 1]";
    let (problem, known) = manufactured(before, BIHARMONIC, "[u + r*t*sin(u + v), v*exp(t*u), r*cos(t + v)]");
    let mut blend = trimline::blend::Blend::new(problem, &terms("10")).expect("a problem");
    blend.set("r", "2").expect("a param");
    let solution = blend.solve(0, 0.75).expect("solvable");
    assert!(distance(&blend, &*solution.surface, known, Derivative::NONE, 0.75) < 1e-11);
    // The corrections belong to the instant.
    let mut value = [[0.0; 3]];
    assert!(solution.surface.evaluate(Derivative::NONE, &[[0.5, 0.5, 0.7]], &mut value).is_err());
}

#[test]
fn equation_with_derivatives_in_time_reports_its_true_residual() {
    let (problem, _) = manufactured(
        UNIT,
        "d4S/du4 + 2*d4S/du2dv2 + d4S/dv4 + dS/dt + d2S/dt2",
        "[u + t*v, v + sin(u*v), exp(t)*u^2*v^2]",
    );
    let (blend, solution) = solve(&problem, &Options::default(), 0.5).expect("solvable");
    // Position and force are bicubic Hermite data in space: the corrections are zero at every instant and so are their
    // derivatives in t.
    let measured = blend.verify(0, &solution, 0.5).expect("finite");
    assert!(measured.relative_residual() < 1e-8, "{:.1e}", measured.relative_residual());
}

#[test]
fn derivatives_agree_with_difference_quotients() {
    let (problem, _) = manufactured(UNIT, BIHARMONIC, ANY);
    let (_, solution) = solve(&problem, &terms("6"), 0.0).expect("solvable");
    differences(&*solution.surface);
}

/// Compares first and mixed derivatives with quotients at points inside.
fn differences(surface: &dyn Surface) {
    let at = |derivative: Derivative, u: f64, v: f64| {
        let mut value = [[0.0; 3]];
        surface.evaluate(derivative, &[[u, v, 0.0]], &mut value).expect("inside");
        value[0]
    };
    let h = 1e-5;
    for (u, v) in [(0.3, 0.6), (0.05, 0.9), (0.5, 0.02), (0.97, 0.96)] {
        for (p, q) in [(0, 0), (1, 0), (0, 1), (1, 1), (2, 1)] {
            let order = |p, q| Derivative::new(p, q, 0);
            for axis in 0..3 {
                let in_u = (at(order(p, q), u + h, v)[axis] - at(order(p, q), u - h, v)[axis]) / (2.0 * h);
                let in_v = (at(order(p, q), u, v + h)[axis] - at(order(p, q), u, v - h)[axis]) / (2.0 * h);
                // Derivatives of order 5 reach 1e4 near corners whose twists differ: h² of it, and ε/h of order 3.
                assert!((in_u - at(order(p + 1, q), u, v)[axis]).abs() < 2e-5, "{u} {v} {p} {q}");
                assert!((in_v - at(order(p, q + 1), u, v)[axis]).abs() < 2e-5, "{u} {v} {p} {q}");
            }
        }
    }
}

#[test]
fn grid_and_points_give_the_same_values() {
    let (problem, _) = twisted();
    let (_, solution) = solve(&problem, &terms("6"), 0.0).expect("solvable");
    let (u, v) = ([0.0, 0.3, 1.0], [0.0, 0.1, 0.8, 1.0]);
    for derivative in [Derivative::NONE, Derivative::new(1, 0, 0), Derivative::new(1, 1, 0)] {
        let mut grid = vec![[0.0; 3]; 12];
        solution.surface.evaluate_grid(derivative, (&u, &v, 0.0), &mut grid).expect("inside");
        let points: Vec<[f64; 3]> = u.iter().flat_map(|&u| v.iter().map(move |&v| [u, v, 0.0])).collect();
        let mut single = vec![[0.0; 3]; 12];
        solution.surface.evaluate(derivative, &points, &mut single).expect("inside");
        for (a, b) in grid.iter().flatten().zip(single.iter().flatten()) {
            // The same sums in another order.
            assert!((a - b).abs() < 1e-14, "{derivative}: {a} {b}");
        }
    }
}

/// A known surface, but the tangent on u = 0 turns by v (1 - v)² more: position and tangent still fit in every corner,
/// the twist in u = 0, v = 0 does not.
fn twisted() -> (trimline::problem::Problem, crate::sides::Vector) {
    let (mut problem, known) = with_vector(UNIT, BIHARMONIC, KNOWN);
    restrict(&mut problem, known);
    let graph = &mut problem.graph;
    let v = graph.variable(trimline::expr::Variable::V);
    let one = graph.integer(1);
    let rest = graph.difference(one, v);
    let turn = graph.product([v, rest, rest]);
    let tangent = &mut problem.patches[0].conditions[1].value[2];
    *tangent = graph.sum([*tangent, turn]);
    (problem, known)
}

#[test]
fn twists_that_differ_are_reported_and_position_and_tangent_still_met() {
    let (problem, _) = twisted();
    let (blend, solution) = solve(&problem, &Options::default(), 0.0).expect("solvable");
    let codes: Vec<Code> = solution.report.warnings.iter().map(|warning| warning.code).collect();
    assert_eq!(codes, [Code::TwistsDisagree]);
    let message = &solution.report.warnings[0].message;
    assert!(message.contains("1.0e0 in the corner u = 0, v = 0"), "{message}");
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() < 4e-15, "{:?}", measured.boundary_errors);
    differences(&*solution.surface);
}

#[test]
fn corner_of_two_twists_has_no_third_derivatives() {
    let (problem, _) = twisted();
    let (_, solution) = solve(&problem, &terms("4"), 0.0).expect("solvable");
    let mut value = [[0.0; 3]];
    for (derivative, is_there) in
        [(Derivative::new(1, 0, 0), true), (Derivative::new(1, 1, 0), true), (Derivative::new(2, 1, 0), false)]
    {
        let result = solution.surface.evaluate(derivative, &[[0.0, 0.0, 0.0]], &mut value);
        assert_eq!(result.is_ok(), is_there, "{derivative}");
    }
    let refused = solution.surface.evaluate(Derivative::new(2, 1, 0), &[[0.0, 0.0, 0.0]], &mut value).unwrap_err();
    assert_eq!(refused.code, Code::NotDifferentiable);
}

#[test]
fn sides_that_do_not_meet_are_refused_with_all_corners() {
    let (mut problem, known) = with_vector(UNIT, BIHARMONIC, KNOWN);
    restrict(&mut problem, known);
    let graph = &mut problem.graph;
    let tenth = graph.number(trimline::expr::Number::fraction(1, 4).expect("a number"));
    let side = &mut problem.patches[0].side_conditions[2].value[1];
    *side = graph.sum([*side, tenth]);
    let refused = solve(&problem, &Options::default(), 0.0).err().expect("refused");
    assert_eq!(refused.code, Code::SidesDisagree);
    assert!(refused.message.contains("the corner u = 0, v = 1: S differs by 2.5e-1, ∂S/∂u by"), "{}", refused.message);
    assert_eq!(refused.hints.len(), 5, "{:?}", refused.hints);
    assert!(refused.hints[3].starts_with("u = 1, v = 1: differences in S 2.5e-1"), "{:?}", refused.hints);
}

#[test]
fn amplification_is_that_of_the_eigenvalue_of_the_clamped_plate() {
    // The smallest eigenvalue Λ of the clamped unit square is 1294.93397959 (35.98515 squared; tables of plates), so an
    // equation with -k S amplifies Λ/|Λ - k| times.
    let eigenvalue = 1_294.933_979_59;
    for (k, code, accuracy) in [(1200.0, Code::Amplified, 1e-6), (1294.0, Code::NearlyResonant, 1e-4)] {
        let equation = format!("d4S/du4 + 2*d4S/du2dv2 + d4S/dv4 - {k}*S");
        let (mut problem, known) = with_vector(UNIT, &equation, "[u, v, u*v]");
        restrict(&mut problem, known);
        let (_, solution) = solve(&problem, &Options::default(), 0.0).expect("solvable");
        assert_eq!(solution.report.warnings.first().map(|warning| warning.code), Some(code));
        let expected = eigenvalue / (eigenvalue - k);
        let found = solution.report.amplification.expect("measured");
        // 12 terms leave an error of 1e-7 in the eigenvalue, magnified by the amplification.
        assert!((found / expected - 1.0).abs() < accuracy, "{k}: {found} {expected}");
    }
}

#[test]
fn equation_that_is_not_elliptic_is_reported() {
    let (mut problem, known) = with_vector(UNIT, "d4S/du4 - 3*d4S/du2dv2 + d4S/dv4", "[u, v, u*v]");
    restrict(&mut problem, known);
    let (_, solution) = solve(&problem, &Options::default(), 0.0).expect("solvable");
    assert_eq!(solution.report.warnings.iter().map(|w| w.code).collect::<Vec<_>>(), [Code::NotElliptic]);
}

#[test]
fn too_few_terms_for_the_data_are_reported() {
    let (problem, _) = manufactured(UNIT, BIHARMONIC, "[u, v, sin(12*u)*sin(12*v)]");
    let (_, few) = solve(&problem, &terms("4"), 0.0).expect("solvable");
    assert_eq!(few.report.warnings.iter().map(|w| w.code).collect::<Vec<_>>(), [Code::TermsTooFew]);
    let (_, enough) = solve(&problem, &terms("20"), 0.0).expect("solvable");
    assert!(enough.report.warnings.is_empty(), "{:?}", enough.report.warnings);
}

#[test]
fn problems_that_do_not_suit_the_method_are_refused() {
    let refusal = |equation: &str| {
        let (mut problem, known) = with_vector(UNIT, equation, "[u, v, u*v]");
        restrict(&mut problem, known);
        solve(&problem, &Options::default(), 0.0).err().expect("refused")
    };
    for equation in ["d4S/du4 + d2S/dv2", "d4S/du4 + d4S/dv4 + d5S/du4dv", "d4S/du4 + d4S/dv4 + t*dS/du + dS/dt"] {
        let refused = refusal(equation);
        assert_eq!(refused.code, Code::UnsupportedByMethod, "{equation}");
        assert_eq!(refused.hints.len(), 1, "{equation}: {:?}", refused.hints);
    }
    let (mut problem, known) = with_vector(UNIT, BIHARMONIC, "[u, v, u*v]");
    restrict(&mut problem, known);
    problem.patches[0].side_conditions.pop();
    assert_eq!(solve(&problem, &Options::default(), 0.0).err().map(|e| e.code), Some(Code::UnsupportedByMethod));
    // A method for two sides would leave two unread.
    let (mut problem, known) = with_vector(UNIT, BIHARMONIC, "[u, v, u*v]");
    restrict(&mut problem, known);
    let options = Options { method: Some("exact".to_owned()), ..Options::default() };
    let refused = solve(&problem, &options, 0.0).err().expect("refused");
    assert_eq!(
        (refused.code, refused.hints.as_slice()),
        (Code::UnsupportedByMethod, &["methods: four_sided".to_owned()][..])
    );
    for count in ["0", "33", "4x0"] {
        assert_eq!(solve(&problem, &terms(count), 0.0).err().map(|e| e.code), Some(Code::SettingOutOfRange));
    }
}

#[test]
fn data_that_are_not_finite_are_named() {
    let (mut problem, known) = with_vector(UNIT, BIHARMONIC, "[u, v, u*v]");
    restrict(&mut problem, known);
    let graph = &mut problem.graph;
    let u = graph.variable(trimline::expr::Variable::U);
    problem.patches[0].side_conditions[0].value[2] = graph.inverse(u);
    let refused = solve(&problem, &Options::default(), 0.0).err().expect("refused");
    assert_eq!(refused.code, Code::DataNotFinite);
    assert!(refused.message.contains("at u = 0"), "{}", refused.message);
}

#[test]
fn velocity_and_acceleration_of_moving_sides_are_those_of_the_surfaces_at_other_instants() {
    let (mut problem, known) = with_vector(
        "param rest = 0\ndomain u in [0, 1], v in [0, 1], t in [0, 2]",
        "d4S/du4 + 2*d4S/du2dv2 + d4S/dv4 + rest*d2S/dt2",
        "[u + t^2*sin(u + v), v*exp(t*u), cos(t + u*v)]",
    );
    restrict(&mut problem, known);
    let blend = trimline::blend::Blend::new(problem, &terms("10")).expect("a problem");
    let at = |t: f64, derivative: &str| {
        let solution = blend.solve(0, t).expect("solvable");
        let mut value = [[0.0; 3]];
        let derivative = Derivative::parse(derivative).expect("letters");
        solution.surface.evaluate(derivative, &[[0.4, 0.7, t]], &mut value).expect("known");
        value[0]
    };
    let (t, h) = (0.75, 1e-4);
    let (before, now, after) = (at(t - h, ""), at(t, ""), at(t + h, ""));
    let (velocity, acceleration) = (at(t, "t"), at(t, "tt"));
    for axis in 0..3 {
        let first = (after[axis] - before[axis]) / (2.0 * h);
        let second = (after[axis] - 2.0 * now[axis] + before[axis]) / (h * h);
        // Truncation: h² times a derivative below 10; rounding of numbers near 3 over h², 1e-16/1e-8.
        assert!((velocity[axis] - first).abs() < 1e-7, "{axis}: {} {first}", velocity[axis]);
        assert!((acceleration[axis] - second).abs() < 1e-5, "{axis}: {} {second}", acceleration[axis]);
    }
}
