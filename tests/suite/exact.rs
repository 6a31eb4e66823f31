//! The method `exact` against published values, closed forms, manufactured solutions and the fitted method.

use serde_json::Value;

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostics, Source};
use trimline::expr::Derivative;
use trimline::method::{Options, Settings, Solution};

const EQ19: &str = include_str!("../../examples/eq19.trim");

/// The comparison problem of You and Zhang 2003, Eq. 13.
const EQ13: &str = "pde with γ = 18, λ = 81
    at u = 0:
      S = [-3.395 e^(v/10) + 0.017 sin v + 4.763, 0.0159 v - 0.475 cos v + 0.475, 3 - v/10]
      ∂S/∂u = [0, 0.0159 v - 0.475 cos v + 0.475, v/10 - 3]
    at u = 1:
      S = [sin v, -cos v, 0]
      ∂S/∂u = [sin v, -cos v, 0]";

/// The vase of You and Zhang 2003, Eq. 27.
const EQ27: &str = "pde with γ = 2, ρ = 1, η = 1
    at u = 0:
      S = [t + 0.9 cos v, t + 0.9 sin v, 3]
      ∂S/∂u = [-1.47 t^3 cos v, -1.47 t^3 sin v, -0.3 t^2]
    at u = 1:
      S = [0.4 cos v, 0.4 sin v, 0]
      ∂S/∂u = [0.77 t^2 cos v, 0.77 t^2 sin v, 0.3 t^3]";

fn exact() -> Options {
    Options { method: Some("exact".to_owned()), ..Options::default() }
}

fn compile(text: &str) -> Result<Blend, Diagnostics> {
    Blend::compile(&Source::new("test", text), &exact())
}

fn blend(text: &str) -> Blend {
    compile(text).unwrap_or_else(|found| panic!("{found:?}"))
}

fn at(solution: &Solution, derivative: &str, point: [f64; 3]) -> [f64; 3] {
    let derivative = Derivative::parse(derivative).expect("letters u, v and t");
    let mut value = [[0.0; 3]];
    solution.surface.evaluate(derivative, &[point], &mut value).expect("a finite surface");
    value[0]
}

fn vectors(value: &Value) -> Vec<[f64; 3]> {
    let number = |value: &Value| value.as_f64().expect("a number");
    let rows = value.as_array().expect("rows").iter();
    rows.map(|row| [number(&row[0]), number(&row[1]), number(&row[2])]).collect()
}

#[test]
fn published_exact_solutions_are_reproduced_by_one_solution_for_all_instants() {
    let files = [
        (EQ19, include_str!("../reference/eq19_exact.json")),
        (EQ13, include_str!("../reference/eq13_exact.json")),
        (EQ27, include_str!("../reference/eq27_exact.json")),
    ];
    for (text, reference) in files {
        let reference: Value = serde_json::from_str(reference).expect("JSON");
        let solution = blend(text).solve(0, 0.0).expect("solvable");
        let points = vectors(&reference["points"]);
        let size = vectors(&reference["S"]).iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
        // Bounds stated with the values: 1e-12 for positions, 1e-11 for derivatives, of the largest coordinate.
        for (key, derivative, allowed) in [("S", "", 1e-12), ("S_u", "u", 1e-11), ("S_v", "v", 1e-11)] {
            for (point, expected) in points.iter().zip(vectors(&reference[key])) {
                for (found, expected) in at(&solution, derivative, *point).iter().zip(expected) {
                    assert!((found - expected).abs() <= allowed * size, "{key} at {point:?}: {found} {expected}");
                }
            }
        }
    }
}

#[test]
fn boundary_and_equation_are_met_to_rounding_for_mild_and_stiff_coefficients() {
    let examples = [
        ("eq6", include_str!("../../examples/eq6.trim")),
        ("eq19", EQ19),
        ("eq29_30", include_str!("../../examples/eq29_30.trim")),
        ("eq31_32", include_str!("../../examples/eq31_32.trim")),
        ("eq13", EQ13),
        ("eq27", EQ27),
    ];
    let coefficients: [&[(&str, &str)]; 3] =
        [&[], &[("beta", "0.01"), ("gamma", "10")], &[("beta", "0.01"), ("gamma", "10"), ("lambda", "100")]];
    for (name, text) in examples {
        let mut blend = blend(text);
        for changes in coefficients {
            for (coefficient, value) in changes {
                blend.set(coefficient, value).expect("a coefficient of the standard equation");
            }
            let [start, end] = blend.patches[0].domain.t;
            for t in [start, 0.5 * (start + end), end] {
                let solution = blend.solve(0, t).unwrap_or_else(|finding| panic!("{name} {changes:?}: {finding}"));
                let measured = blend.verify(0, &solution, t).expect("finite");
                assert!(
                    measured.boundary_error() <= 1e-13 * measured.size.max(1.0),
                    "{name} {changes:?} {t}: {measured:?}"
                );
                assert!(measured.relative_residual() <= 1e-11, "{name} {changes:?} {t}: {measured:?}");
            }
        }
    }
}

/// `∂ⁿS/∂uⁿ + 2 ∂²S/∂u∂v + 3 S + ∂S/∂t - ∂³S/∂u²∂v = q` with `S = [cos 2u sin v e^t, e^u v t, u⁹]`.
fn manufactured(order: usize) -> String {
    let (first, last) = match order {
        2 => ("-4", "72 u^7"),
        4 => ("16", "3024 u^5"),
        _ => ("-64", "60480 u^3"),
    };
    let mut text = format!(
        "pde d{order}S/du{order} + 2 d2S/dudv + 3 S + dS/dt - d3S/du2dv = [
            ({first} + 4) cos(2u) sin(v) e^t - 4 sin(2u) cos(v) e^t + 4 cos(2u) cos(v) e^t,
            e^u (4 v t + t + v),
            {last} + 3 u^9]\n"
    );
    for u in ["0", "1"] {
        text += &format!("at u = {u}:\n S = [cos(2*{u}) sin(v) e^t, e^{u} v t, {u}]\n");
        if order >= 4 {
            text += &format!(" dS/du = [-2 sin(2*{u}) sin(v) e^t, e^{u} v t, 9*{u}]\n");
        }
        if order >= 6 {
            text += &format!(" d2S/du2 = [-4 cos(2*{u}) sin(v) e^t, e^{u} v t, 72*{u}]\n");
        }
    }
    text
}

#[test]
fn manufactured_solutions_of_order_two_four_and_six_are_found_with_a_force() {
    for order in [2, 4, 6] {
        let solution = blend(&manufactured(order)).solve(0, 0.0).unwrap_or_else(|finding| panic!("{order}: {finding}"));
        for point in [[0.1, 0.4, 0.0], [0.5, 3.0, 0.7], [0.83, 6.0, 1.0]] {
            let [u, v, t]: [f64; 3] = point;
            let expected = [(2.0 * u).cos() * v.sin() * t.exp(), u.exp() * v * t, u.powi(9)];
            for (found, expected) in at(&solution, "", point).iter().zip(expected) {
                // Values up to e·6; the tail of the series is below 1e-12 of the largest coefficient.
                assert!((found - expected).abs() <= 1e-11, "order {order} at {point:?}: {found} {expected}");
            }
        }
    }
}

#[test]
fn coefficients_and_forces_may_depend_on_u() {
    let text = "pde (2 + u) d4S/du4 + d4S/dv4 = [(3 + u) e^u sin v, 0, (2 + u) sin(u)]
        at u = 0: S = [sin v, 0, 0], dS/du = [sin v, 0, 1]
        at u = 1: S = [e sin v, 0, sin(1)], dS/du = [e sin v, 0, cos(1)]";
    let solution = blend(text).solve(0, 0.0).expect("solvable");
    let [x, y, z] = at(&solution, "", [0.4, 1.0, 0.0]);
    assert!((x - 0.4_f64.exp() * 1.0_f64.sin()).abs() < 1e-12, "{x}");
    assert_eq!(y, 0.0);
    assert!((z - 0.4_f64.sin()).abs() < 1e-12, "{z}");
}

#[test]
fn four_positions_determine_a_surface() {
    // sinh(u) sin v solves (∂²/∂u² + ∂²/∂v²)² S = 0; on other intervals of u as well.
    let text = "domain u in [-1, 2]
        at u = -1: S = [sinh(-1) sin v, 0, -1]
        at u = 0: S = [0, 0, 0]
        at u = 0.5: S = [sinh(0.5) sin v, 0, 0.5]
        at u = 2: S = [sinh(2) sin v, 0, 2]";
    let solution = blend(text).solve(0, 0.0).expect("solvable");
    for u in [-0.7_f64, 0.3, 1.4] {
        let [x, _, z] = at(&solution, "", [u, 2.0, 0.0]);
        assert!((x - u.sinh() * 2.0_f64.sin()).abs() < 1e-12, "{u}: {x}");
        assert!((z - u).abs() < 1e-12, "{u}: {z}");
    }
}

#[test]
fn components_may_have_coefficients_of_their_own() {
    // Order 2, S'' = k² S: cosh and cos with different k per component.
    let text = "pde d2S/du2 + [-4, 1, 0] S = 0
        at u = 0: S = [1, 1, 1]
        at u = 1: S = [cosh(2), cos(1), 3]";
    let solution = blend(text).solve(0, 0.0).expect("solvable");
    let [x, y, z] = at(&solution, "", [0.3, 0.0, 0.0]);
    for (found, expected) in [(x, 0.6_f64.cosh()), (y, 0.3_f64.cos()), (z, 1.6)] {
        assert!((found - expected).abs() < 1e-13, "{found} {expected}");
    }
}

/// The problem of Fig. 4 of the 2012 paper at one η.
fn figure_4(eta: &str) -> Blend {
    let mut blend = blend(EQ19);
    for (name, value) in [("beta", "0.01"), ("gamma", "10"), ("lambda", "0.01"), ("rho", "0.01"), ("eta", eta)] {
        blend.set(name, value).expect("a coefficient");
    }
    blend
}

#[test]
fn resonance_is_found_on_both_sides_with_its_critical_coefficient() {
    // S_x(1/2, π/2, 0) from a solution in 50 digits: the sign turns at the pole η = -113.6148.
    for (eta, expected, amplification) in
        [("-120", -18.3, 36.6), ("-114", -302.0, 592.0), ("-113", 189.0, 371.0), ("-100", 8.45, 15.7)]
    {
        let solution = figure_4(eta).solve(0, 0.0).expect("solvable");
        let [x, ..] = at(&solution, "", [0.5, std::f64::consts::FRAC_PI_2, 0.0]);
        assert!((x - expected).abs() <= 0.005 * expected.abs(), "{eta}: {x}");
        let found = solution.report.amplification.expect("measured");
        assert!((found - amplification).abs() <= 0.02 * amplification, "{eta}: {found}");
        let warning = solution.report.warnings.first().expect("a note");
        assert_eq!(warning.code, Code::Amplified);
        assert!(warning.hints.iter().any(|hint| hint.contains("eta = -113.6148")), "{warning:?}");
    }
    let near = figure_4("-113.61").solve(0, 0.0).expect("solvable");
    assert_eq!(near.report.warnings.first().map(|warning| warning.code), Some(Code::NearlyResonant));
    assert!(figure_4("-50").solve(0, 0.0).expect("solvable").report.warnings.is_empty());
}

#[test]
fn sweep_of_figure_4_has_one_resonance_and_says_so_on_both_sides() {
    let mut before: Option<(f64, f64)> = None;
    let mut turns = Vec::new();
    for eta in (-120..=-50).step_by(2).map(f64::from) {
        let solution = figure_4(&eta.to_string()).solve(0, 0.0).unwrap_or_else(|finding| panic!("{eta}: {finding}"));
        let warnings = &solution.report.warnings;
        // The amplification falls below 10, where nothing is said, well before η = -90.
        assert_eq!(!warnings.is_empty(), solution.report.amplification.expect("measured") >= 10.0, "{eta}");
        assert!(!warnings.is_empty() || eta > -106.0, "{eta}");
        assert!(warnings.iter().all(|warning| warning.hints[0].contains("eta = -113.6148")), "{eta} {warnings:?}");
        let [x, ..] = at(&solution, "", [0.5, std::f64::consts::FRAC_PI_2, 0.0]);
        turns.extend(before.filter(|(_, other)| other.signum() != x.signum()).map(|(other, _)| (other, eta)));
        before = Some((eta, x));
    }
    // Below the resonance the surface swings to the other side; beyond it x stays positive.
    assert_eq!(turns, [(-114.0, -112.0)]);
}

#[test]
fn critical_value_of_a_number_in_the_equation_is_named_with_its_term() {
    // 0.01 D⁴ - 10 D² has the first clamped eigenvalue 113.594841 (reference of figure 4); along sin v the rest is 1 - 114.
    let text = "pde 0.01 d4S/du4 + 10 d4S/du2dv2 + d4S/dv4 - 114 S = 0
        at u = 0: S = [cos(v), sin(v), 1], dS/du = [0, 0, 1]\nat u = 1: S = [cos(v), sin(v), 0], dS/du = [0, 0, 1]";
    let solution = blend(text).solve(0, 0.0).expect("solvable");
    let hint = &solution.report.warnings.first().expect("a note").hints[0];
    assert!(hint.starts_with("there is no solution with `-114.594841 S` for `-114 S`, or with `"), "{hint}");
}

#[test]
fn critical_value_is_found_where_a_coefficient_enters_the_equation_as_a_square() {
    // S'' + a² S = 0 is resonant at a = π, and S'' + (a + a³) S = 0 where a + a³ = π².
    for (term, start, critical) in [("a^2", "3.1", "a = 3.141593"), ("(a + a^3)", "2.0", "a = 1.989923")] {
        let text = format!("param a = {start}\npde d2S/du2 + {term} S = 0\nat u = 0: S = [1, 0, 0]\nat u = 1: S = 0");
        let solution = blend(&text).solve(0, 0.0).expect("solvable");
        let warning = solution.report.warnings.first().expect("a note");
        assert_eq!(warning.hints, [format!("there is no solution at {critical}")], "{term}");
    }
}

#[test]
fn critical_value_has_digits_whatever_its_size() {
    // β S'' + k S = 0 is resonant at k = π² β.
    for (beta, start, critical) in [("1e-8", "9.8e-8", "9.869604e-8"), ("1e-4", "9.8e-4", "0.0009869604")] {
        let text = format!("param k = {start}\npde {beta} d2S/du2 + k S = 0\nat u = 0: S = [1, 0, 0]\nat u = 1: S = 0");
        let solution = blend(&text).solve(0, 0.0).expect("solvable");
        let warning = solution.report.warnings.first().expect("a note");
        assert_eq!(warning.hints, [format!("there is no solution at k = {critical}")], "{start}");
    }
}

#[test]
fn coefficient_that_is_critical_is_called_so() {
    let text = "param k = π^2\npde d2S/du2 + k S = 0\nat u = 0: S = [1, 0, 0]\nat u = 1: S = 0";
    let refused = blend(text).solve(0, 0.0).err().expect("resonant");
    assert_eq!(refused.hints[0], "there is no solution at k = 9.869604401089358, which is exactly critical");
}

#[test]
fn force_with_a_feature_between_the_nodes_is_not_taken_for_smooth() {
    // 24 terms are checked at 49 nodes, 0.02 to 0.03 apart, all of which miss a bump of this width.
    for (width, is_resolved) in [("0.1", true), ("0.0008", false)] {
        let text = format!(
            "pde d4S/du4 = [exp(-((u - 0.391)/{width})^2), 0, 0]\nat u = 0: S = 0, ∂S/∂u = 0\nat u = 1: S = 0, ∂S/∂u = 0"
        );
        let solved = blend(&text).solve(0, 0.0);
        assert_eq!(solved.is_ok(), is_resolved, "{width}: {:?}", solved.err());
    }
}

#[test]
fn a_resonant_equation_has_no_solution() {
    // S'' + π² S = 0 with S = 0 at both ends has sin πu for a solution: data that do not fit it have none.
    let text = "pde d2S/du2 + π^2 S = 0
        at u = 0: S = [1, 0, 0]
        at u = 1: S = [0, 0, 0]";
    let finding = blend(text).solve(0, 0.0).err().expect("resonant");
    assert_eq!(finding.code, Code::Resonant, "{finding:?}");
}

#[test]
fn an_order_that_drops_is_explained() {
    let mut blend = blend(EQ19);
    blend.set("beta", "0").expect("a coefficient");
    let finding = blend.solve(0, 0.0).err().expect("order drops");
    assert_eq!(finding.code, Code::OrderDrops);
    assert!(finding.hints.iter().any(|hint| hint.contains("`sine`")));
}

#[test]
fn layers_too_thin_are_reported() {
    let mut blend = blend(EQ19);
    blend.set("beta", "1e-12").expect("a coefficient");
    let finding = blend.solve(0, 0.0).err().expect("unresolved");
    assert!(finding.message.contains("layers"), "{finding:?}");
}

#[test]
fn what_does_not_close_is_named() {
    let rest = "∂S/∂u = 0\nat u = 1: S = [cos v, 1, 0], ∂S/∂u = 0";
    for (data, named) in [
        ("sin(v^2)", "sin(v^2)"),
        ("tan v", "tan(v)"),
        ("1/(1 + v^2)", "1/(1 + v^2)"),
        ("t sqrt(v + 1)", "sqrt(1 + v)"),
        ("log(1 + v)", "ln(1 + v)"),
        ("e^sin(v)", "exp(sin(v))"),
        ("sin(v t)", "sin(v*t)"),
    ] {
        let found = compile(&format!("at u = 0: S = [{data}, 1, 1], {rest}")).err().expect("refused");
        assert_eq!(found[0].code, Code::UnsupportedByMethod);
        assert!(found[0].message.contains(&format!("`{named}`")), "{data}: {}", found[0].message);
    }
}

#[test]
fn closures_have_the_sizes_that_theory_predicts() {
    // Functions of a whole problem before and after closing it, with ρ and η present.
    for (data, size) in [
        ("t sin(5v)", 2),
        ("t^2 cos v", 3),
        ("t^3 cos v", 4),
        ("v sin v", 2),
        ("v e^(0.1 v)", 2),
        ("e^t sin v", 1),
        ("sin(π t/2) cos v", 2),
        ("sin(2v) cos(3t)", 2),
        ("v^4", 3),
    ] {
        let data = data.replace("π t/2", "(π t)/2");
        let text =
            format!("pde with ρ = 1, η = 1\nat u = 0: S = [{data}, 0, 0], ∂S/∂u = 0\nat u = 1: S = 0, ∂S/∂u = 0");
        let solution = blend(&text).solve(0, 0.5).expect("solvable");
        assert_eq!(solution.report.closure_size, Some(size), "{data}");
    }
}

#[test]
fn a_closed_problem_is_solved_exactly_unless_told_otherwise() {
    let text = EQ19.lines().filter(|line| !line.starts_with("solve")).collect::<Vec<_>>().join("\n");
    let blend = Blend::compile(&Source::new("test", text), &Options::default()).expect("complete");
    assert_eq!(blend.solve(0, 0.0).expect("solvable").report.method, "exact");
}

#[test]
fn a_problem_without_closure_is_fitted_and_says_why() {
    let text = "at u = 0: S = [tan(v/20), 1, 1], ∂S/∂u = 0\nat u = 1: S = 0, ∂S/∂u = 0";
    let blend = Blend::compile(&Source::new("test", text), &Options::default()).expect("complete");
    let report = blend.solve(0, 0.0).expect("solvable").report;
    assert_eq!(report.method, "legendre");
    assert!(report.warnings.iter().all(|warning| warning.code == Code::MethodPassedOver));
    let [first, second] = report.warnings.as_slice() else { panic!("{:?}", report.warnings) };
    assert!(first.message.contains("not by `exact`: `tan(0.05*v)` has no finite closure"), "{first:?}");
    assert!(second.message.contains("not by `fourier`: `tan(0.05*v)` (S_x at u = 0) is not periodic"), "{second:?}");
}

#[test]
fn the_sine_fit_misses_the_exact_solution_by_what_is_published() {
    let exact = blend(EQ19).solve(0, 0.0).expect("solvable");
    // Largest error of S on a 101 x 101 grid: midpoints, then both ends.
    for (terms, points, expected) in [
        ("5", "11x11", 7.43e-4),
        ("7", "11x11", 3.95e-4),
        ("10", "11x11", 1.10e-4),
        ("5", "11x11:ends", 3.09e-3),
        ("10", "41x11:ends", 1.08e-3),
    ] {
        let mut settings = Settings::default();
        settings.set("terms", terms, None).expect("a number");
        settings.set("points", points, None).expect("a grid");
        let options = Options { method: Some("sine".to_owned()), settings, ..Options::default() };
        let blend = Blend::compile(&Source::new("test", EQ19), &options).expect("complete");
        let fitted = blend.solve(0, 0.0).expect("solvable");
        let u: Vec<f64> = (0..=100).map(|i| f64::from(i) / 100.0).collect();
        let v: Vec<f64> = u.iter().map(|share| share * 2.0 * std::f64::consts::PI).collect();
        let mut grids = [vec![[0.0; 3]; 101 * 101], vec![[0.0; 3]; 101 * 101]];
        for (solution, grid) in [&exact, &fitted].into_iter().zip(&mut grids) {
            solution.surface.evaluate_grid(Derivative::NONE, (&u, &v, 0.0), grid).expect("finite");
        }
        let distance =
            |(a, b): (&[f64; 3], &[f64; 3])| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let error = grids[0].iter().zip(&grids[1]).map(distance).fold(0.0, f64::max);
        // Published with three digits, as the largest component or the distance: equal within a few per cent.
        assert!((error - expected).abs() <= 0.05 * expected, "{terms} {points}: {error:.3e} {expected:.3e}");
    }
}

#[test]
fn hostile_numbers_are_refused_not_answered() {
    // Positions that nearly coincide, coefficients of hopelessly different sizes, waves no grid resolves, a spike
    // between the nodes, data near the largest double: an error, or a solution that keeps its promises.
    let positions = "param c = 1, g = 2
        pde with γ = g
        at u = 0: S = [cos v, sin v, 0], ∂S/∂u = 0
        at u = c: S = [cos v, sin v, 1], ∂S/∂u = 0";
    let wave = "at u = 0: S = [cos(k v), 0, 1], ∂S/∂u = 0\nat u = 1: S = [cos v, sin v, 0], ∂S/∂u = 0";
    let spike = "pde d4S/du4 = [exp(-((u - 0.4)/0.0005)^2)*1e6, 0, 0]
        at u = 0: S = [0, 0, v], ∂S/∂u = 0\nat u = 1: S = 0, ∂S/∂u = 0";
    let mut answered = 0;
    for method in ["exact", "sine", "polynomial"] {
        let options = Options { method: Some(method.to_owned()), ..Options::default() };
        let texts = ["1e-4", "1e-9", "1e-18"].map(|c| (positions.to_owned(), "c", c));
        let stiff = ["1e25", "1e154", "1e300"].map(|g| (positions.to_owned(), "g", g));
        let waves = ["1e10"].map(|k| (wave.replace("(k v)", &format!("({k} v)")), "γ", "2"));
        let spikes = [(spike.to_owned(), "", "")];
        for (text, name, value) in texts.into_iter().chain(stiff).chain(waves).chain(spikes) {
            let Ok(mut blend) = Blend::compile(&Source::new("test", text), &options) else { continue };
            if !name.is_empty() && blend.set(name, value).is_err() {
                continue;
            }
            if let Ok(solution) = blend.solve(0, 0.0) {
                answered += 1;
                let measured = blend.verify(0, &solution, 0.0).expect("finite");
                // The data are of size 1 whatever the surface does in between.
                assert!(measured.boundary_error() <= 1e-9, "{method} {name} = {value}");
                assert!(method != "exact" || measured.relative_residual() <= 1e-6, "{method} {name} = {value}");
            }
        }
    }
    assert!(answered > 0);
}

#[test]
fn resonance_of_an_odd_order_is_found() {
    let text = "param κ = 20
        pde d3S/du3 + κ dS/du = 0
        at u = 0: S = [1, 0, 0], ∂S/∂u = [0, 1, 0]
        at u = 1: S = [0, 0, 1]";
    let mut blend = blend(text);
    let report = blend.solve(0, 0.0).expect("solvable").report;
    assert!(report.amplification.expect("measured") >= 1.0);
    // With κ = 4π² the solution 1 - cos 2πu meets zero conditions.
    blend.set("κ", "4*π^2").expect("a param");
    assert_eq!(blend.solve(0, 0.0).err().expect("resonant").code, Code::Resonant);
}

#[test]
fn a_surface_that_misses_its_boundary_is_refused_however_large_it_is() {
    // The constraints at 0 and c all but coincide, the domain goes on to 2: sines explode there, and rounding with them.
    let text = "param c = 1
        domain u in [0, 2]
        at u = c: S = [cos v, sin v, 0], ∂S/∂u = [0, 0, 1]
        at u = 0: S = [cos v, 2 sin v, 3], ∂S/∂u = [0, 0, 1]
        solve sine";
    let mut blend = Blend::compile(&Source::new("test", text), &Options::default()).expect("complete");
    assert!(blend.solve(0, 0.0).is_ok());
    for c in ["1e-8", "1e-9", "1e-11"] {
        blend.set("c", c).expect("a param");
        assert_eq!(blend.solve(0, 0.0).err().map(|finding| finding.code), Some(Code::PromiseBroken), "{c}");
    }
    // The size of the data is what a miss is compared with, however small it is.
    let small = text
        .replace("cos v", "(1e-9) cos v")
        .replace("sin v", "(1e-9) sin v")
        .replace("3]", "3e-9]")
        .replace("0, 1]", "0, 1e-9]");
    let mut blend = Blend::compile(&Source::new("test", small), &Options::default()).expect("complete");
    assert!(blend.solve(0, 0.0).is_ok());
    blend.set("c", "1e-9").expect("a param");
    assert_eq!(blend.solve(0, 0.0).err().map(|finding| finding.code), Some(Code::PromiseBroken));
}

#[test]
fn an_animation_needs_one_solution_until_a_param_changes() {
    let mut blend = blend(
        "param r = 1\ndomain t in [0, 1]\nat u = 0: S = [cos v, sin v, r t], ∂S/∂u = [0, 0, 1]\nat u = 1: S = [2 cos v, 2 sin v, 2], ∂S/∂u = [0, 0, 1]",
    );
    let solved = |blend: &Blend, t: f64| blend.solve(0, t).expect("solvable").surface;
    let first = solved(&blend, 0.0);
    assert!(std::sync::Arc::ptr_eq(&first, &solved(&blend, 0.75)));
    blend.set("r", "2").expect("a param");
    let other = solved(&blend, 0.75);
    assert!(!std::sync::Arc::ptr_eq(&first, &other));
    let height = |surface: &dyn trimline::surface::Surface| {
        let mut value = [[0.0; 3]];
        surface.evaluate(Derivative::NONE, &[[0.0, 0.3, 0.75]], &mut value).expect("finite");
        value[0][2]
    };
    assert!((height(&*first) - 0.75).abs() < 1e-14 && (height(&*other) - 1.5).abs() < 1e-14);
}
