//! The method `static_blend` against values of You and Zhang's scheme computed apart from this program, and what it
//! says about its limits. The method `exact` on the same problems.

use serde_json::Value;
use trimline::blend::Blend;
use trimline::diagnostic::{Class, Code, Diagnostic, Source};
use trimline::expr::Derivative;
use trimline::method::{Options, Settings, Solution};
use trimline::surface::Surface;

fn options(method: &str, settings: &[(&str, &str)]) -> Options {
    let mut all = Settings::default();
    for (key, value) in settings {
        all.set(key, value, None).expect("a known setting");
    }
    Options { method: Some(method.to_owned()), settings: all, ..Options::default() }
}

fn example(number: usize) -> String {
    let path = format!("{}/examples/p1_ex{number}.trim", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).expect("the example is there")
}

fn compiled(text: &str, options: &Options) -> Result<Blend, Diagnostic> {
    Blend::compile(&Source::new("spec.trim", text), options).map_err(|mut findings| findings.remove(0))
}

fn solved(text: &str, options: &Options, t: f64) -> Result<(Blend, Solution), Diagnostic> {
    let blend = compiled(text, options)?;
    let solution = blend.solve(0, t)?;
    Ok((blend, solution))
}

fn at(surface: &dyn Surface, derivative: Derivative, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut values = vec![[0.0; 3]; points.len()];
    surface.evaluate(derivative, points, &mut values).expect("points of the domain");
    values
}

fn reference() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/p1.json");
    serde_json::from_str(&std::fs::read_to_string(path).expect("the file is there")).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|number| number.as_f64().expect("a number")).collect()
}

/// The largest `|error| / (1 + |value|)` of position and first derivatives.
fn deviation(surface: &dyn Surface, variant: &Value) -> f64 {
    let rows: Vec<Vec<f64>> = variant["values"].as_array().expect("rows").iter().map(numbers).collect();
    let points: Vec<[f64; 3]> = rows.iter().map(|row| [row[0], row[1], 0.0]).collect();
    let mut worst = 0.0_f64;
    for (group, derivative) in [Derivative::NONE, Derivative::new(1, 0, 0), Derivative::new(0, 1, 0)].iter().enumerate()
    {
        for (row, found) in rows.iter().zip(at(surface, *derivative, &points)) {
            for (component, found) in found.iter().enumerate() {
                let expected = row[2 + 3 * group + component];
                worst = worst.max((found - expected).abs() / (1.0 + expected.abs()));
            }
        }
    }
    worst
}

#[test]
fn published_scheme_agrees_with_the_reference_on_every_grid() {
    let reference = reference();
    let variants = [
        ("square_E_5", "5x5", "6x6:ends"),
        ("square_C_4", "4x4", "5x5"),
        ("square_G_6", "6x6", "7x7:chebyshev"),
        ("lsq_G_5", "5x5", "12x12:chebyshev"),
    ];
    for number in [1, 2, 5] {
        for (variant, terms, points) in variants {
            let options = options("static_blend", &[("terms", terms), ("points", points)]);
            let (_, solution) = solved(&example(number), &options, 0.0).expect("solvable");
            let worst = deviation(&*solution.surface, &reference["problems"][format!("p1_ex{number}")][variant]);
            // Rounding times the condition, up to 2e3 for fitted parts of size 1.
            assert!(worst < 1e-12, "ex{number} {variant}: {worst:.1e}");
        }
    }
}

#[test]
fn exact_agrees_with_the_reference() {
    let reference = reference();
    for number in [1, 2, 5] {
        let (_, solution) = solved(&example(number), &options("exact", &[]), 0.0).expect("solvable");
        let worst = deviation(&*solution.surface, &reference["problems"][format!("p1_ex{number}")]["exact_closure"]);
        // Derivatives of 40 terms of size 1.
        assert!(worst < 1e-13, "ex{number}: {worst:.1e}");
    }
}

/// The coefficients of `sin²(πu) u^m v^n` in a surface over u in [0, 1] and v in [low, high].
fn powers(solution: &Solution, [m, n]: [usize; 2], [low, high]: [f64; 2], component: usize) -> Vec<f64> {
    // T_k(2x - 1) and T_k((2v - low - high)/(high - low)) as polynomials, by the recurrence.
    let chebyshev = |count: usize, [at_zero, slope]: [f64; 2]| {
        let mut all: Vec<Vec<f64>> = vec![vec![1.0], vec![at_zero, slope]];
        while all.len() < count {
            let (one, two) = (&all[all.len() - 1], &all[all.len() - 2]);
            let mut next = vec![0.0; one.len() + 1];
            for (power, value) in one.iter().enumerate() {
                next[power] += 2.0 * at_zero * value;
                next[power + 1] += 2.0 * slope * value;
            }
            for (power, value) in two.iter().enumerate() {
                next[power] -= value;
            }
            all.push(next);
        }
        all
    };
    let in_u = chebyshev(m + 1, [-1.0, 2.0]);
    let in_v = chebyshev(n + 1, [-(low + high) / (high - low), 2.0 / (high - low)]);
    let surface = crate::spec::separable(solution);
    let count = surface.basis.len();
    let data = count - (n + 1);
    let mut sums = vec![0.0; (m + 1) * (n + 1)];
    for (i, of_u) in in_u.iter().enumerate().take(m + 1) {
        for (j, of_v) in in_v.iter().enumerate().take(n + 1) {
            let weight = surface.coefficients[0][(4 + i) * count + data + j][component];
            for (a, u) in of_u.iter().enumerate() {
                for (b, v) in of_v.iter().enumerate() {
                    sums[a * (n + 1) + b] += weight * u * v;
                }
            }
        }
    }
    sums
}

#[test]
fn coefficients_of_plain_powers_are_those_of_the_reference() {
    let reference = reference();
    for (number, range) in [(1, [0.0, std::f64::consts::TAU]), (2, [0.0, 1.0]), (5, [0.0, std::f64::consts::TAU])] {
        let options = options("static_blend", &[("terms", "4x4"), ("points", "5x5")]);
        let (_, solution) = solved(&example(number), &options, 0.0).expect("solvable");
        let expected = &reference["problems"][format!("p1_ex{number}")]["square_C_4"]["a_mn"];
        for component in 0..3 {
            let found = powers(&solution, [4, 4], range, component);
            for (found, expected) in found.iter().zip(numbers(&expected[component])) {
                // The step from Chebyshev polynomials to powers amplifies rounding up to 10^5 times.
                assert!((found - expected).abs() < 1e-10 * (1.0 + expected.abs()), "ex{number}: {found} {expected}");
            }
        }
    }
}

/// The largest distance between two surfaces on the grid of the reference.
fn distance(a: &dyn Surface, b: &dyn Surface, [low, high]: [f64; 2]) -> f64 {
    let points: Vec<[f64; 3]> = (0..=60)
        .flat_map(|k| (0..=96).map(move |l| [f64::from(k) / 60.0, low + (high - low) * f64::from(l) / 96.0, 0.0]))
        .collect();
    let (a, b) = (at(a, Derivative::NONE, &points), at(b, Derivative::NONE, &points));
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

#[test]
fn distance_from_the_exact_solution_is_that_of_the_reference() {
    // M = N = 4, 6 and 8 on equally spaced points with ends, to two digits; ex6 turns away.
    let expected = [
        [0.045, 0.0046, 4e-4],
        [0.0019, 5e-5, 3e-6],
        [0.031, 0.013, 0.0025],
        [0.036, 0.0037, 3e-4],
        [0.37, 0.26, 0.11],
        [0.14, 0.074, 0.17],
    ];
    for (number, row) in (1..).zip(expected) {
        let text = example(number);
        let (blend, exact) = solved(&text, &options("exact", &[]), 0.0).expect("solvable");
        for (terms, expected) in ["4x4", "6x6", "8x8"].into_iter().zip(row) {
            let (_, fitted) = solved(&text, &options("static_blend", &[("terms", terms)]), 0.0).expect("solvable");
            let found = distance(&*fitted.surface, &*exact.surface, blend.patches[0].domain.v);
            // The reference gives one or two digits, on a grid that may miss the very largest value.
            assert!((found / expected - 1.0).abs() < 0.25, "ex{number} {terms}: {found:.2e}, not {expected:.1e}");
        }
    }
}

#[test]
fn least_squares_has_the_smaller_residual_and_the_wrong_surface() {
    let text = example(2);
    let (_, exact) = solved(&text, &options("exact", &[]), 0.0).expect("solvable");
    let fit = |terms, points| {
        let options = options("static_blend", &[("terms", terms), ("points", points)]);
        let (blend, solution) = solved(&text, &options, 0.0).expect("solvable");
        let residual = blend.verify(0, &solution, 0.0).expect("measurable").residual;
        (residual, distance(&*solution.surface, &*exact.surface, [0.0, 1.0]))
    };
    let (square, least) = (fit("6x6", "7x7:ends"), fit("8x8", "18x18:chebyshev"));
    // The reference has residuals 8.7 and 0.18 on its own grid, and distances 5e-5 and 6.2.
    assert!(least.0 < 0.1 * square.0, "{square:?} {least:?}");
    assert!(square.1 < 6e-5 && (least.1 - 6.2).abs() < 0.06, "{square:?} {least:?}");
}

#[test]
fn boundary_is_met_to_rounding_on_any_range() {
    let ranges = "domain u in [-0.7, 2.3], v in [1, 4]\n\
                  pde β ∂⁴S/∂u⁴ + γ ∂⁴S/∂u²∂v² + λ ∂⁴S/∂v⁴ + ∂³S/∂u²∂v = [v, u, t] with β = 1 + u²/9, γ = 2, λ = 1\n\
                  at u = -0.7: S = [cos v, v t, e^v], ∂S/∂u = [1, sqrt(v), t²]\n\
                  at u = 2.3: S = [1/v, 0, 2], ∂S/∂u = [v, 1, atan(v)]\n";
    let specs = (1..=6).map(example).chain([ranges.to_owned()]);
    for (index, text) in specs.enumerate() {
        let (blend, solution) = solved(&text, &options("static_blend", &[]), 0.3).expect("solvable");
        let measured = blend.verify(0, &solution, 0.3).expect("measurable");
        assert!(measured.boundary_error() < 1e-14 * measured.size.max(1.0), "{index}: {measured:?}");
        assert_eq!(solution.report.rank, solution.report.unknowns, "{index}");
    }
}

#[test]
fn equation_holds_at_the_collocation_points() {
    let text = "domain u in [-0.7, 2.3], v in [1, 4]\n\
                pde ∂⁴S/∂u⁴ + 2 ∂⁴S/∂u²∂v² + ∂⁴S/∂v⁴ = [v, u t, 1]\n\
                at u = -0.7: S = [cos v, v t, e^v], ∂S/∂u = [1, sqrt(v), t²]\n\
                at u = 2.3: S = [1/v, 0, 2], ∂S/∂u = [v, 1, atan(v)]\n";
    let options = options("static_blend", &[("terms", "3x2"), ("points", "4x3:ends")]);
    let (_, solution) = solved(text, &options, 0.5).expect("solvable");
    let points: Vec<[f64; 3]> = (0..12).map(|i| [-0.7 + f64::from(i / 3), 1.0 + 1.5 * f64::from(i % 3), 0.5]).collect();
    let part = |u, v| at(&*solution.surface, Derivative::new(u, v, 0), &points);
    let (fourth, mixed, along) = (part(4, 0), part(2, 2), part(0, 4));
    for (index, [u, v, t]) in points.iter().enumerate() {
        for (component, force) in [*v, u * t, 1.0].into_iter().enumerate() {
            let terms = [fourth[index][component], 2.0 * mixed[index][component], along[index][component]];
            let size = terms.iter().fold(1.0_f64, |most, term| most.max(term.abs()));
            // The system's condition, below 1e3, times rounding.
            assert!((terms.iter().sum::<f64>() - force).abs() < 1e-11 * size, "{index} {component}: {terms:?}");
        }
    }
}

fn codes(solution: &Solution) -> Vec<Code> {
    solution.report.warnings.iter().map(|finding| finding.code).collect()
}

#[test]
fn seam_and_other_solutions_are_reported_with_their_numbers() {
    // The gap that the reference gives for M = N = 5 with end points, and the smallest exponents.
    for (number, gap, exponent) in [
        (1, "up to 7.9e-3 apart", "|λ| = 4.739"),
        (3, "up to 2.1e-2 apart", "|λ| = 4.912"),
        (4, "up to 6.4e-3 apart", "|λ| = 4.739"),
        (5, "up to 3.5e-1 apart", "|λ| = 2.018"),
    ] {
        let (_, solution) =
            solved(&example(number), &options("static_blend", &[("terms", "5")]), 0.0).expect("solvable");
        let [other, seam] = solution.report.warnings.as_slice() else { panic!("{:?}", solution.report.warnings) };
        assert_eq!([other.code, seam.code], [Code::SolutionNotUnique, Code::SeamOpens]);
        assert!(seam.message.ends_with(gap), "ex{number}: {}", seam.message);
        assert!(other.message.contains(exponent), "ex{number}: {}", other.message);
    }
    // Open shapes have no seam; sin 6v is beyond the reach of polynomials, and its place is given.
    for number in [2, 6] {
        let (_, solution) = solved(&example(number), &options("static_blend", &[]), 0.0).expect("solvable");
        assert_eq!(codes(&solution), [Code::SolutionNotUnique]);
        let finding = &solution.report.warnings[0];
        assert!(finding.message.contains("|λ| = 3.61"), "{}", finding.message);
        assert_eq!(finding.message.contains("varies at the rate 6"), number == 6, "{}", finding.message);
        assert_eq!(finding.span.is_some(), number == 6);
    }
}

#[test]
fn an_equation_of_u_alone_has_one_solution() {
    let text = "domain v in [0, 1]\npde ∂⁴S/∂u⁴ = 0\n\
                at u = 0: S = [0, v, 0], ∂S/∂u = [1, 0, v]\nat u = 1: S = [1, v, v], ∂S/∂u = [1, 0, 0]\n";
    let (_, solution) = solved(text, &options("static_blend", &[]), 0.0).expect("solvable");
    assert_eq!(codes(&solution), []);
}

#[test]
fn midpoints_with_highest_power_one_are_reported_as_singular() {
    // At u = 1/4 and 3/4 the fourth derivatives of sin²(πu) and u sin²(πu) are proportional.
    let options = options("static_blend", &[("terms", "1x3"), ("points", "2x4")]);
    let (blend, solution) = solved(&example(1), &options, 0.0).expect("the smallest solution");
    assert!(solution.report.rank < solution.report.unknowns, "{:?}", solution.report);
    assert!(codes(&solution).contains(&Code::RankDeficient));
    assert!(blend.verify(0, &solution, 0.0).expect("measurable").boundary_error() < 1e-14);
}

const TIMED: &str = "pde with γ = 3\n\
    at u = 0: S = [cos v, sin v, t], ∂S/∂u = [0, 0, 1 + t²]\n\
    at u = 1: S = [2 cos v, e^t sin v, 3], ∂S/∂u = [0, 0, t v]\n";

#[test]
fn each_instant_is_solved_and_knows_its_derivatives_in_t() {
    let options = options("static_blend", &[]);
    let blend = compiled(TIMED, &options).expect("static");
    let (t, h) = (0.4, 1e-4);
    let points = |t: f64| [[0.3, 0.7, t], [0.8, 5.0, t]];
    let position = |t: f64| at(&*blend.solve(0, t).expect("solvable").surface, Derivative::NONE, &points(t));
    let (before, now, after) = (position(t - h), position(t), position(t + h));
    let surface = blend.solve(0, t).expect("solvable").surface;
    let (slope, bend) =
        (at(&*surface, Derivative::new(0, 0, 1), &points(t)), at(&*surface, Derivative::new(0, 0, 2), &points(t)));
    for index in 0..2 {
        for component in 0..3 {
            let of = |values: &[[f64; 3]]| values[index][component];
            // Truncation h² times derivatives below 2; rounding ε/h² times values below 10.
            assert!(((of(&after) - of(&before)) / (2.0 * h) - of(&slope)).abs() < 1e-7);
            assert!(((of(&after) - 2.0 * of(&now) + of(&before)) / (h * h) - of(&bend)).abs() < 3e-6);
        }
    }
    let refused = surface.evaluate(Derivative::NONE, &points(0.5), &mut [[0.0; 3]; 2]).expect_err("another instant");
    assert_eq!(refused.code, Code::UnsupportedByMethod);
}

#[test]
fn what_does_not_depend_on_time_is_solved_once() {
    let (_, solution) = solved(&example(1), &options("static_blend", &[]), 0.0).expect("solvable");
    assert_eq!(
        at(&*solution.surface, Derivative::NONE, &[[0.3, 1.0, 0.0]]),
        at(&*solution.surface, Derivative::NONE, &[[0.3, 1.0, 0.9]])
    );
}

#[test]
fn problems_beyond_the_method_are_refused_with_reason_and_place() {
    let ends = "at u = 0: S = [cos v, sin v, 0], ∂S/∂u = 0\nat u = 1: S = [cos v, sin v, 1], ∂S/∂u = 0\n";
    let four = "at u = 0: S = [cos v, sin v, 0]\nat u = 0.3: S = [cos v, sin v, 1]\n\
                at u = 0.6: S = [cos v, sin v, 2]\nat u = 1: S = [cos v, sin v, 3]\n";
    let inner = ends.replace("u = 1", "u = 0.5");
    let bent = ends.replace("∂S/∂u = 0\nat u = 1", "∂²S/∂u² = 0\nat u = 1");
    let second = "pde ∂²S/∂u² + ∂²S/∂v² = 0\nat u = 0: S = [cos v, sin v, 0]\nat u = 1: S = [cos v, sin v, 1]\n";
    let cases = [
        ("order 2", second.to_owned(), "of order 4 in u; this one has 2"),
        ("four positions", four.to_owned(), "the constraints have S at u = 0.3"),
        ("inside", inner, "the constraints have S at u = 0.5"),
        ("curvature", bent, "the constraints have ∂²S/∂u² at u = 0"),
        ("in time", format!("pde ∂⁴S/∂u⁴ + ∂⁴S/∂v⁴ + 2 ∂S/∂t = 0\n{ends}"), "derivatives in t"),
        ("param in time", format!("pde with ρ = 1\n{ends}"), "derivatives in t"),
        ("no fourth derivative", format!("pde with β = 0\n{ends}"), "∂⁴S/∂u⁴ is 0 for S_x"),
        ("coefficient in time", format!("pde (1 + t) ∂⁴S/∂u⁴ + η ∂S/∂t = 0 with η = 0\n{ends}"), "do not depend on t"),
    ];
    for (name, text, reason) in cases {
        let refused = solved(&format!("{text}solve static_blend"), &Options::default(), 0.0).err();
        let refused = refused.unwrap_or_else(|| panic!("{name} is accepted"));
        assert_eq!((refused.code, refused.class()), (Code::UnsupportedByMethod, Class::Unsupported), "{name}");
        assert!(refused.message.contains(reason), "{name}: {}", refused.message);
        assert!(refused.span.is_some(), "{name} has no place");
    }
}

#[test]
fn settings_out_of_range_are_refused_with_their_place() {
    for (settings, code, reason) in [
        ("terms = 5 x 5, points = 5 x 6", Code::SettingOutOfRange, "do not determine"),
        ("terms = 5 x 33", Code::SettingOutOfRange, "powers go to 32"),
        ("points = 100000 x 100000", Code::LimitReached, "`system-entries`"),
        ("fit = joint", Code::UnknownSetting, "no setting `fit`"),
    ] {
        let text = example(1).replace("terms = 6 x 6", settings);
        let refused = compiled(&text, &Options::default()).err().unwrap_or_else(|| panic!("{settings} is accepted"));
        assert_eq!(refused.code, code, "{settings}: {refused}");
        assert!(refused.message.contains(reason), "{settings}: {refused}");
        assert!(refused.span.is_some(), "{settings} has no place");
    }
}
