//! The method `polynomial` against reference values, against `exact`, and against manufactured solutions.

use serde_json::Value;
use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostic, Source};
use trimline::expr::Derivative;
use trimline::method::{Fit, Options, Settings, Size, Solution, Terms};

const EQ13: &str = include_str!("../../examples/eq13.trim");
const EQ19: &str = include_str!("../../examples/eq19.trim");
const EQ27: &str = include_str!("../../examples/eq27.trim");

fn polynomial(terms: usize, points: &str, fit: Fit) -> Options {
    let settings = Settings {
        terms: Some((Terms { first: terms, second: None }, None)),
        points: Some((Size::read(points).expect("a grid"), None)),
        fit: Some((fit, None)),
        ..Settings::default()
    };
    Options { method: Some("polynomial".to_owned()), settings, ..Options::default() }
}

fn exact() -> Options {
    Options { method: Some("exact".to_owned()), ..Options::default() }
}

fn compile(text: &str, options: &Options) -> Blend {
    Blend::compile(&Source::new("test.trim", text), options).unwrap_or_else(|findings| panic!("{findings:?}"))
}

fn solve(text: &str, options: &Options, t: f64) -> Solution {
    compile(text, options).solve(0, t).unwrap_or_else(|finding| panic!("{finding:?}"))
}

fn refusal(text: &str, options: &Options) -> Diagnostic {
    match Blend::compile(&Source::new("test.trim", text), options) {
        Ok(_) => panic!("accepted"),
        Err(findings) => findings.into_iter().next().expect("a finding"),
    }
}

const S_T: Derivative = Derivative::new(0, 0, 1);
const S_TT: Derivative = Derivative::new(0, 0, 2);

/// Values on 101 x 101 points of `[0, 1] x [0, 2π]`.
fn sampled(solution: &Solution, derivative: Derivative, t: f64) -> Vec<[f64; 3]> {
    let u: Vec<f64> = (0..=100).map(|i| f64::from(i) / 100.0).collect();
    let v: Vec<f64> = (0..=100).map(|i| std::f64::consts::TAU * f64::from(i) / 100.0).collect();
    let mut values = vec![[0.0; 3]; u.len() * v.len()];
    solution.surface.evaluate_grid(derivative, (&u, &v, t), &mut values).expect("a finite surface");
    values
}

fn distance(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// The largest error of S against the exact solution.
fn error(text: &str, options: &Options, t: f64) -> f64 {
    distance(
        &sampled(&solve(text, options, t), Derivative::NONE, t),
        &sampled(&solve(text, &exact(), t), Derivative::NONE, t),
    )
}

/// The largest deviations of S, S_u, S_v from a table of reference values, over the largest |S| of the table.
fn deviation(table: &str, text: &str, options: &Options) -> f64 {
    let table: Value = serde_json::from_str(table).expect("valid JSON");
    let number = |value: &Value| value.as_f64().expect("a number");
    let blend = compile(text, options);
    let (mut largest, mut size) = (0.0_f64, 0.0_f64);
    for row in table["rows"].as_array().expect("rows") {
        let row: Vec<f64> = row.as_array().expect("a row").iter().map(number).collect();
        let solution = blend.solve(0, row[2]).expect("solvable");
        let derivatives = [Derivative::NONE, Derivative::new(1, 0, 0), Derivative::new(0, 1, 0)];
        for (derivative, expected) in derivatives.into_iter().zip(row[3..].chunks(3)) {
            let mut found = [[0.0; 3]];
            solution.surface.evaluate(derivative, &[[row[0], row[1], row[2]]], &mut found).expect("finite");
            for (found, expected) in found[0].iter().zip(expected) {
                largest = largest.max((found - expected).abs());
            }
        }
        size = row[3..6].iter().fold(size, |most, value| most.max(value.abs()));
    }
    largest / size
}

#[test]
fn joint_fit_of_equation_13_reproduces_reference_values() {
    // Rounding times the condition, 4e3; the limit of the reference is 1e-10.
    let ends = include_str!("../reference/eq13_polynomial_ends.json");
    let found = deviation(ends, EQ13, &polynomial(7, "6x6:ends", Fit::Joint));
    assert!(found < 1e-11, "{found:e}");
    let midpoints = include_str!("../reference/eq13_polynomial_midpoints.json");
    let found = deviation(midpoints, EQ13, &polynomial(7, "6x6", Fit::Joint));
    assert!(found < 1e-11, "{found:e}");
}

#[test]
fn per_basis_fit_of_equation_27_reproduces_reference_values() {
    let table = include_str!("../reference/eq27_polynomial_per_basis.json");
    let found = deviation(table, EQ27, &polynomial(7, "6x6", Fit::PerBasis));
    assert!(found < 1e-11, "{found:e}");
}

/// The largest number of `found`, in units of `expected`: within 3 % both ways, as printed with two or three digits.
fn assert_near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 0.03, "{found:e} instead of {expected:e}");
}

#[test]
fn error_of_equation_13_is_that_of_the_reference() {
    assert_near(error(EQ13, &polynomial(7, "6x6:ends", Fit::Joint), 0.0), 1.14e-3);
    assert_near(error(EQ13, &polynomial(7, "6x6", Fit::Joint), 0.0), 1.67e-4);
    assert_near(error(EQ13, &polynomial(9, "6x6:ends", Fit::Joint), 0.0), 1.64e-6);
}

#[test]
fn error_of_equation_19_falls_exponentially_with_the_highest_power() {
    let expected = [(5, 1.47e-3), (7, 4.47e-5), (9, 1.15e-7), (11, 4.86e-10), (13, 1.14e-12)];
    for (terms, expected) in expected {
        assert_near(error(EQ19, &polynomial(terms, "17x17:ends", Fit::PerBasis), 0.0), expected);
    }
    // At rounding level: at most some 20 roundings of numbers near 3.
    let last = error(EQ19, &polynomial(15, "17x17:ends", Fit::PerBasis), 0.0);
    assert!(last < 20.0 * 3.0 * f64::EPSILON, "{last:e}");
}

#[test]
fn joint_fit_at_one_instant_is_deficient_and_says_which_functions_depend_on_each_other() {
    // Two digits of the reference, minimum norm on the grid with end points.
    let blend = compile(EQ27, &polynomial(7, "6x6:ends", Fit::Joint));
    for (t, expected) in [(0.3, 1.122e-4), (0.6, 1.737e-4), (0.8, 2.151e-4), (1.0, 2.504e-4)] {
        let solution = blend.solve(0, t).expect("solvable");
        let found = distance(
            &sampled(&solution, Derivative::NONE, t),
            &sampled(&solve(EQ27, &exact(), t), Derivative::NONE, t),
        );
        assert_near(found, expected);
        assert_eq!((solution.report.rank, solution.report.unknowns), (26, 44));
        let warning = solution.report.warnings.first().expect("a warning");
        assert_eq!(warning.code, Code::RankDeficient);
        assert!(warning.message.contains("10 of 16 terms of S_x") && warning.message.contains("F2, F5, F8"));
        assert!(warning.span.is_some());
    }
}

#[test]
fn derivatives_in_time_are_those_of_the_surfaces_at_neighbouring_instants() {
    for fit in [Fit::PerBasis, Fit::Joint] {
        let blend = compile(EQ27, &polynomial(7, "6x6", fit));
        let (t, h) = (0.6, 1e-3);
        let [before, now, after] = [t - h, t, t + h].map(|t| blend.solve(0, t).expect("solvable"));
        let values = |solution: &Solution, t: f64| sampled(solution, Derivative::NONE, t);
        let (before, middle, after) = (values(&before, t - h), values(&now, t), values(&after, t + h));
        let quotient = |f: fn(f64, f64, f64, f64) -> f64| -> Vec<[f64; 3]> {
            let rows = before.iter().zip(&middle).zip(&after);
            rows.map(|((a, b), c)| [0, 1, 2].map(|i| f(a[i], b[i], c[i], h))).collect()
        };
        let first = quotient(|a, _, c, h| (c - a) / (2.0 * h));
        let second = quotient(|a, b, c, h| (a - 2.0 * b + c) / (h * h));
        // Truncation h²/6 and h²/12 times derivatives of order 3 and 4, which are below 10.
        assert!(distance(&sampled(&now, S_T, t), &first) < 2e-6);
        assert!(distance(&sampled(&now, S_TT, t), &second) < 2e-6);
    }
}

/// Equation 27 with the shape functions of the paper's Eq. 29, as in its Figs. 5 and 6.
fn shape_functions(rho: f64, eta: f64, d0: f64) -> String {
    let end = EQ27.find("pde").expect("an equation");
    let data = EQ27.find("at u = 0").expect("data");
    let statement = EQ27.find("solve").expect("a solve statement");
    let parameters =
        EQ27[..end].replace("dr0 = 0.77, dr1 = -1.47", "dr0 = 1.32, dr1 = -2.52").replace("= 1, r0", "= 0, r0");
    format!(
        "{parameters}pde (1 - t) u (u - 1) ∂⁴S/∂u⁴ + 2 (1 + t) u (u - 1) ∂⁴S/∂u²∂v² \
         - {d0} (1 + t²) u (u - 1) ∂⁴S/∂v⁴ + {rho} ∂²S/∂t² + {eta} ∂S/∂t = 0\n{}",
        &EQ27[data..statement]
    )
}

#[test]
fn shape_functions_give_the_reference_surfaces() {
    let x_at_middle = |text: &str, options: &Options| {
        let mut value = [[0.0; 3]];
        let solution = solve(text, options, 0.5);
        solution.surface.evaluate(Derivative::NONE, &[[0.5, 0.0, 0.5]], &mut value).expect("finite");
        value[0][0]
    };
    // Figs. 5a and 5b, all as printed in the reference with two decimals; the joint fit is the shortest solution.
    for (d0, terms, points, fit, expected) in [
        (1300.0, 7, "6x6", Fit::PerBasis, -0.41),
        (1300.0, 7, "6x6:ends", Fit::PerBasis, -0.46),
        (1300.0, 10, "17x17", Fit::PerBasis, -0.44),
        (9000.0, 7, "6x6", Fit::PerBasis, -0.03),
        (9000.0, 7, "6x6:ends", Fit::PerBasis, 0.34),
        (9000.0, 10, "17x17", Fit::PerBasis, 0.79),
        (1300.0, 7, "6x6", Fit::Joint, 1.20),
        (1300.0, 7, "6x6:ends", Fit::Joint, -0.99),
    ] {
        let found = x_at_middle(&shape_functions(1.0, 1.0, d0), &polynomial(terms, points, fit));
        assert!((found - expected).abs() <= 0.005, "{found} instead of {expected}");
    }
    // Fig. 6: density and damping change the surface by about 1e-3.
    let [plain, dense, damped] = [(1.0, 1.0), (8.0, 1.0), (1.0, 9.0)]
        .map(|(rho, eta)| x_at_middle(&shape_functions(rho, eta, 1300.0), &polynomial(7, "6x6", Fit::PerBasis)));
    for changed in [dense, damped] {
        assert!((2e-4..5e-3).contains(&(changed - plain).abs()), "{plain} {changed}");
    }
}

/// An equation with coefficients in u, v and t, and a force in t, whose solution has terms that do not depend on t:
/// `[(u⁶ + w) sin v, t² u⁵ e^(v/2), u⁷ v]` with `w = 2u² - 3u³ + u⁵`.
const MANUFACTURED: &str = "
let b = 1 + u v, c = 2 + sin(t), d = e^u, m = 1 + v², n = u t
let w = 2u² - 3u³ + u⁵, w2 = 4 - 18u + 20u³, g = e^(0.5v)
let X = 360b u² - 30c u⁴ + d u⁶ + 120b u - c w2 + d w
let Y = t² (120b u + 5c u³ + 0.0625d u⁵) + 2 m u⁵ + 2 n t u⁵
domain v in [0, 2], t in [0, 1]
pde b ∂⁴S/∂u⁴ + c ∂⁴S/∂u²∂v² + d ∂⁴S/∂v⁴ + m ∂²S/∂t² + n ∂S/∂t = [X sin v, Y g, 840b u³ v]
at u = 0:
    S = 0, ∂S/∂u = 0
at u = 1:
    S = [sin v, t² g, v], ∂S/∂u = [6 sin v, 5t² g, 7v]
";

#[test]
fn manufactured_solution_with_variable_coefficients_and_a_force_is_found_to_rounding() {
    let t = 0.7;
    // A force and coefficients in v and t leave only `legendre` to `auto`, which shares this joint fit.
    for options in [Options::default(), polynomial(7, "8x8", Fit::Joint), polynomial(9, "12x12:gauss", Fit::Joint)] {
        let blend = compile(MANUFACTURED, &options);
        let solution = blend.solve(0, t).expect("solvable");
        // `auto` notes why it passed over other methods; there is nothing else to say.
        let other = solution.report.warnings.iter().filter(|warning| warning.code != Code::MethodPassedOver);
        let method = options.method.as_deref().unwrap_or("legendre");
        assert_eq!((solution.report.method, other.count()), (method, 0));
        let measured = blend.verify(0, &solution, t).expect("finite");
        // The residual contains second derivatives of the terms in t; the condition is below 1e5.
        assert!(measured.relative_residual() < 1e-11, "{:e}", measured.relative_residual());
        assert!(measured.boundary_error() < 1e-12, "{:e}", measured.boundary_error());
        let (u, v): (f64, f64) = (0.37, 1.1);
        let w = 2.0 * u * u - 3.0 * u.powi(3) + u.powi(5);
        let expected = [(u.powi(6) + w) * v.sin(), t * t * u.powi(5) * (0.5 * v).exp(), u.powi(7) * v];
        let mut found = [[0.0; 3]];
        solution.surface.evaluate(Derivative::NONE, &[[u, v, t]], &mut found).expect("finite");
        assert!(distance(&found, &[expected]) < 1e-11, "{found:?} {expected:?}");
    }
}

#[test]
fn boundary_is_met_to_rounding_for_any_order_position_and_range() {
    let sixth = "domain u in [-1, 2.5], v in [0, 3]
pde ∂⁶S/∂u⁶ + (1 + u²) ∂⁴S/∂u²∂v² + [1, 2, v] ∂S/∂v = 0
at u = -1: S = [cos v, v, 1], ∂S/∂u = [v², 1, sin v], ∂²S/∂u² = [1, 0, v]
at u = 2.5: S = [0, e^v, v], ∂S/∂u = [1, 2, 3], ∂²S/∂u² = [0, sin v, 0]";
    let four = "pde ∂⁴S/∂u⁴ + u ∂⁴S/∂v⁴ = 0
at u = 0: S = [cos v, sin v, 0]
at u = 0.3: S = [cos v, sin v, 1]
at u = 0.6: S = [2cos v, sin v, 2]
at u = 1: S = [cos v, 3sin v, 3]";
    for (text, terms) in [(sixth, 11), (four, 7), (EQ13, 7), (EQ19, 7), (EQ27, 7)] {
        for fit in [Fit::PerBasis, Fit::Joint] {
            let blend = compile(text, &polynomial(terms, "9x9", fit));
            let solution = blend.solve(0, 0.3).expect("solvable");
            let measured = blend.verify(0, &solution, 0.3).expect("finite");
            // Relative to the surface: cardinal polynomials of order 6 on a range of 3.5 are exact to 1e-13.
            let limit = 1e-12 * measured.size.max(1.0);
            assert!(measured.boundary_error() <= limit, "{:e}", measured.boundary_error());
        }
    }
}

#[test]
fn coefficients_that_differ_per_component_are_solved_per_component() {
    let all = EQ13.replace("pde β", "pde [1, 2, 1] β");
    let twice = EQ13.replace("pde β", "pde 2 β");
    for fit in [Fit::PerBasis, Fit::Joint] {
        let options = polynomial(7, "6x6", fit);
        let values =
            [all.as_str(), EQ13, &twice].map(|text| sampled(&solve(text, &options, 0.0), Derivative::NONE, 0.0));
        for ((mixed, plain), doubled) in values[0].iter().zip(&values[1]).zip(&values[2]) {
            assert!(distance(&[*mixed], &[[plain[0], doubled[1], plain[2]]]) < 1e-12);
        }
    }
}

#[test]
fn nothing_is_fitted_where_the_cubic_solves_the_equation() {
    let solution = solve(EQ13, &polynomial(7, "6x6", Fit::Joint), 0.0);
    let surface = crate::spec::separable(&solution);
    let count = surface.basis.len();
    // S_z is linear in v, so its terms are exactly zero.
    assert!(surface.coefficients[0].iter().skip(4 * count).all(|vector| vector[2] == 0.0));
}

#[test]
fn force_is_refused_per_basis_function_and_where_the_data_are_zero() {
    let finding = refusal(MANUFACTURED, &polynomial(7, "8x8", Fit::PerBasis));
    assert_eq!(finding.code, Code::UnsupportedByMethod);
    assert!(finding.span.is_some() && finding.hints.iter().any(|hint| hint.contains("joint")), "{finding:?}");
    let zero = "pde ∂⁴S/∂u⁴ + v ∂⁴S/∂v⁴ = [1, 0, 0]\nat u = 0: S = 0, ∂S/∂u = 0\nat u = 1: S = 0, ∂S/∂u = 0\n";
    let finding = refusal(zero, &polynomial(7, "8x8", Fit::Joint));
    assert_eq!(finding.code, Code::UnsupportedByMethod);
    assert!(finding.span.is_some(), "{finding:?}");
}

#[test]
fn basis_function_that_no_point_sees_is_an_error_in_every_fit() {
    let text = EQ13.replace("b sin v", "b sin(5v)");
    for fit in [Fit::PerBasis, Fit::Joint] {
        let blend = compile(&text, &polynomial(7, "6x6:ends", fit));
        let finding = blend.solve(0, 0.0).err().expect("refused");
        assert_eq!(finding.code, Code::VanishesOnGrid);
        assert!(finding.span.is_some());
    }
}

#[test]
fn settings_out_of_range_are_refused_with_the_reason() {
    for (terms, points, fit, code, text) in [
        (3, "6x6", Fit::Joint, Code::SettingOutOfRange, "decide all powers below 4"),
        (7, "0x6", Fit::Joint, Code::SettingOutOfRange, "no points"),
        (7, "2x5", Fit::Joint, Code::SettingOutOfRange, "do not determine 12 terms"),
        (7, "2x1", Fit::PerBasis, Code::SettingOutOfRange, "do not determine 4 terms"),
        (100_000, "400x400", Fit::PerBasis, Code::LimitReached, "`unknowns`"),
        (7, "100000x100000", Fit::PerBasis, Code::LimitReached, "`system-entries`"),
    ] {
        let finding = refusal(EQ13, &polynomial(terms, points, fit));
        assert_eq!(finding.code, code, "{finding:?}");
        assert!(finding.message.contains(text), "{finding:?}");
    }
}

#[test]
fn functions_that_the_equation_only_multiplies_are_fitted_as_all_others_are() {
    // The square root is cos v on this domain, but its derivatives are no multiples of it that can be seen: it is fitted at
    // all points, cos v at those in u alone.
    let spec = |function: &str| {
        format!(
            "domain v in [-1, 1], t in [0, 1]\n
             at u = 0: S = [{function}, v, t {function}], ∂S/∂u = [0, 1, 2 {function}]\n
             at u = 1: S = [2 {function}, v, 0], ∂S/∂u = [{function}, 0, t]"
        )
    };
    for method in ["sine", "polynomial"] {
        let points = |function: &str| {
            let options = Options { method: Some(method.to_owned()), ..Options::default() };
            let blend = Blend::compile(&Source::new("test", spec(function)), &options).expect("a spec");
            [0.25, 0.75].map(|t| {
                let solution = blend.solve(0, t).expect("solvable");
                let (u, v) = ([0.1, 0.5, 0.8], [-0.9, 0.2, 0.6]);
                let mut values = [[0.0; 3]; 9];
                solution.surface.evaluate_grid(Derivative::NONE, (&u, &v, t), &mut values).expect("finite");
                (values, solution.report.rank)
            })
        };
        let (shared, plain) = (points("cos(v)"), points("sqrt(1 - sin(v)^2)"));
        for ((shared, rank), (plain, other)) in shared.iter().zip(&plain) {
            let apart = shared.iter().flatten().zip(plain.iter().flatten()).map(|(a, b)| (a - b).abs());
            let apart = apart.fold(0.0, f64::max);
            // Rounding times the condition of ten terms, about 1e5.
            assert!(apart < 1e-10 && rank == other, "{method}: {apart:.1e}, rank {rank} and {other}");
        }
    }
}
