//! What `auto` chooses, why, and when it thinks again; the method `legendre`, its last choice.

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Source};
use trimline::method::{Options, Settings};

use crate::spec::{at, example, with_data};

fn blend(text: &str) -> Blend {
    Blend::compile(&Source::new("spec.trim", text), &Options::default()).unwrap_or_else(|found| panic!("{found:?}"))
}

fn method(blend: &Blend, t: f64) -> &'static str {
    blend.solve(0, t).unwrap_or_else(|finding| panic!("{finding}")).report.method
}

#[test]
fn functions_of_time_need_no_closure_where_no_derivative_in_time_remains() {
    // The standard equation has ρ = η = 0.
    let text = with_data("sqrt(1 + t)*cos(v) + v/(2 + t)");
    let blend = blend(&text);
    for t in [0.0, 0.3, 1.0] {
        let solution = blend.solve(0, t).expect("a solution");
        assert_eq!((solution.report.method, solution.report.is_exact), ("exact", true));
        assert_eq!(solution.separable().expect("a sum of products").instant, None);
        assert!(solution.report.warnings.is_empty());
        let measured = blend.verify(0, &solution, t).expect("finite");
        assert!(measured.boundary_error() < 1e-14 && measured.relative_residual() < 1e-12, "{measured:?}");
        // cos v and v are solved by the same functions of u at every instant.
        let [first, later] = [0.0, t].map(|t| at(&*solution.surface, "", [0.5, std::f64::consts::PI, t])[0]);
        let wave = |t: f64| (1.0 + t).sqrt();
        let line = |t: f64| std::f64::consts::PI / (2.0 + t);
        // At u = 1/2 the cubic of v is 1/2 v; the rest belongs to cos π = -1.
        let amplitude = (first - 0.5 * line(0.0)) / wave(0.0);
        assert!((later - 0.5 * line(t) - amplitude * wave(t)).abs() < 1e-14, "{t}");
    }
}

#[test]
fn derivative_in_time_that_vanishes_or_returns_changes_the_choice() {
    let mut blend = blend(&with_data("sqrt(1 + t)*cos(v)"));
    assert_eq!(method(&blend, 0.2), "exact");
    blend.set("eta", "1").expect("a coefficient");
    let report = blend.solve(0, 0.2).expect("a solution").report;
    assert_eq!(report.method, "legendre");
    let reasons: Vec<&str> = report.warnings.iter().map(|note| note.message.as_str()).collect();
    assert!(
        reasons[0].contains("`(t + 1)^(1/2)` has no finite closure") || reasons[0].contains("no finite closure"),
        "{reasons:?}"
    );
    assert!(reasons[1].contains("not by `fourier`: the method `fourier` cannot treat derivatives in t"), "{reasons:?}");
    blend.set("eta", "0").expect("a coefficient");
    assert_eq!(method(&blend, 0.2), "exact");
}

#[test]
fn derivative_that_the_equation_does_not_take_need_not_be_finite() {
    // ∂√t/∂t is infinite at t = 0, and ρ = η = 0.
    let blend = blend(&with_data("sqrt(t)*cos(v)"));
    assert_eq!(method(&blend, 0.0), "exact");
}

#[test]
fn periodic_data_without_closure_go_to_fourier_as_long_as_they_close() {
    let text = format!("param k = 1\n{}", with_data("exp(cos(k*v))"));
    let mut blend = blend(&text);
    let report = blend.solve(0, 0.0).expect("a solution").report;
    assert_eq!((report.method, report.is_exact), ("fourier", false));
    let [note] = report.warnings.as_slice() else { panic!("{:?}", report.warnings) };
    assert_eq!(note.code, Code::MethodPassedOver);
    assert!(note.message.contains("solved by `fourier`, not by `exact`"), "{note}");
    blend.set("k", "0.5").expect("a param");
    assert_eq!(method(&blend, 0.0), "legendre");
    blend.set("k", "3").expect("a param");
    assert_eq!(method(&blend, 0.0), "fourier");
}

#[test]
fn value_that_leaves_no_problem_leaves_the_blend_as_it_was() {
    let mut blend = blend(&with_data("exp(cos(v))"));
    assert!(blend.set("beta", "1/0").is_err());
    assert_eq!(method(&blend, 0.0), "fourier");
}

fn by_legendre(text: &str, settings: &[(&str, &str)]) -> Blend {
    let mut all = Settings::default();
    for (key, value) in settings {
        all.set(key, value, None).expect("a setting");
    }
    let options = Options { method: Some("legendre".to_owned()), settings: all, ..Options::default() };
    Blend::compile(&Source::new("spec.trim", text), &options).unwrap_or_else(|found| panic!("{found:?}"))
}

#[test]
fn legendre_finds_the_exact_solution_where_basis_functions_are_eigenfunctions() {
    let options = Options { method: Some("exact".to_owned()), ..Options::default() };
    let exact = Blend::compile(&Source::new("spec.trim", example("eq19")), &options).expect("a closure");
    let exact = exact.solve(0, 0.2).expect("a solution");
    let blend = by_legendre(&example("eq19"), &[]);
    let solution = blend.solve(0, 0.2).expect("a solution");
    for (u, v) in [(0.1, 0.3), (0.5, 2.0), (0.93, 5.5)] {
        for letters in ["", "u", "v", "t"] {
            let [a, b] = [&exact, &solution].map(|found| at(&*found.surface, letters, [u, v, 0.2]));
            for (a, b) in a.iter().zip(b) {
                // The search ends at a residual of 1e-12 of the largest term, which is 500 times the surface's size at most.
                assert!((a - b).abs() < 1e-11, "{letters} {u} {v}: {a} {b}");
            }
        }
    }
    assert!(!solution.report.is_exact);
    assert!(blend.verify(0, &solution, 0.2).expect("finite").relative_residual() < 1e-10);
}

#[test]
fn legendre_stops_where_the_residual_does_and_leaves_it_to_be_seen() {
    let blend = by_legendre(&with_data("tan(v/20)"), &[]);
    let solution = blend.solve(0, 0.0).expect("a solution");
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    // tan(v/20) is no eigenfunction: nothing of this form has a residual of zero.
    assert!(measured.relative_residual() > 1e-6, "{measured:?}");
    assert!(measured.boundary_error() < 1e-14);
    assert!(solution.report.modes < 40, "{}", solution.report.modes);
    let few = by_legendre(&with_data("tan(v/20)"), &[("terms", "2")]).solve(0, 0.0).expect("a solution");
    assert_eq!(few.report.modes, 2);
}

#[test]
fn boundary_of_high_order_on_a_long_interval_is_met_to_rounding() {
    let sixth = "domain u in [-1, 2.5], v in [0, 3]
        pde d6S/du6 + 3*d6S/du4dv2 + 3*d6S/du2dv4 + d6S/dv6 = 0
        at u = -1: S = [cos(v), v, 1], dS/du = [v^2, 1, sin(v)], d2S/du2 = [1, 0, v]
        at u = 2.5: S = [0, e^v, v], dS/du = [1, 2, 3], d2S/du2 = [0, sin(v), 0]";
    let eighth = "domain u in [0.1, 7.3]
        pde d8S/du8 + d8S/dv8 = 0
        at u = 0.1: S = [cos(v), sin(v), 1], dS/du = 0, d2S/du2 = [1, 0, sin(v)], d3S/du3 = [0, 1, 0]
        at u = 7.3: S = [0, sin(v), 2], dS/du = [1, cos(v), 3], d2S/du2 = 0, d3S/du3 = [1, 0, 0]";
    let scattered = "domain u in [-3, 4]
        pde d4S/du4 + 2*d4S/du2dv2 + d4S/dv4 = 0
        at u = -3: S = [cos(v), sin(v), 0]
        at u = 0.5: S = [cos(v), sin(v), 1], dS/du = [0, 0, 1]
        at u = 4: S = [2*cos(v), sin(v), 2]";
    for text in [sixth, eighth, scattered] {
        let blend = blend(text);
        let solution = blend.solve(0, 0.0).expect("a solution");
        assert_eq!(solution.report.method, "exact");
        let measured = blend.verify(0, &solution, 0.0).expect("finite");
        let miss = measured.boundary_error() / measured.data_size.max(1.0);
        assert!(miss <= 1e-13, "{miss:.1e}\n{text}");
    }
}

/// Data of wave number 5 for an equation with a param a.
fn with_layers(equation: &str) -> String {
    format!(
        "param a = 2000\npde {equation} = 0
        at u = 0: S = [cos(5v), sin(5v), 0], dS/du = 0
        at u = 1: S = [2cos(5v), 2sin(5v), 1], dS/du = 0\n"
    )
}

#[test]
fn layers_too_thin_for_exact_are_solved_by_fourier_in_closed_form() {
    let mut blend = blend(&with_layers("(d2/du2 + a^2 d2/dv2)^2 S"));
    let solution = blend.solve(0, 0.0).expect("a solution");
    assert_eq!(solution.report.method, "fourier");
    let [note] = solution.report.warnings.as_slice() else { panic!("{:?}", solution.report.warnings) };
    assert_eq!(note.code, Code::MethodPassedOver);
    assert!(note.message.starts_with("solved by `fourier`, not by `exact`: the solution along `"), "{note}");
    assert!(note.message.contains("layers too thin for 512 terms"), "{note}");
    // Of (D² - w²)² G = 0 with w = 5a one end is e^-10000 at the other: G = (1 + s) e^-s with s = w u.
    let w = 5.0 * 2000.0;
    for (u, v) in [(1e-5_f64, 0.3_f64), (1e-4, 2.0), (4e-4, 5.1), (0.5, 1.0)] {
        let [x, y, _] = at(&*solution.surface, "", [u, v, 0.0]);
        let layer = (1.0 + w * u) * (-w * u).exp();
        assert!((x - layer * (5.0 * v).cos()).abs() < 1e-13, "{u} {v}: {x}");
        assert!((y - layer * (5.0 * v).sin()).abs() < 1e-13, "{u} {v}: {y}");
    }
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() < 1e-14 && measured.relative_residual() < 1e-13, "{measured:?}");
    // The numbers decide anew each time.
    for (value, expected) in [("2", "exact"), ("3000", "fourier"), ("20", "exact")] {
        blend.set("a", value).expect("a param");
        assert_eq!(method(&blend, 0.0), expected, "{value}");
    }
}

#[test]
fn tolerance_below_those_of_fourier_leaves_it_to_stand_in() {
    let mut options = Options::default();
    options.settings.set("tolerance", "1e-15", None).expect("a tolerance");
    let source = Source::new("spec.trim", with_layers("(d2/du2 + a^2 d2/dv2)^2 S"));
    let blend = Blend::compile(&source, &options).unwrap_or_else(|found| panic!("{found:?}"));
    assert_eq!(method(&blend, 0.0), "fourier");
}

#[test]
fn layers_that_neither_exact_nor_fourier_resolve_are_refused_with_every_reason_once() {
    // Without a closed form `fourier` solves each wave number as `exact` does, and fails as it does.
    let refused = blend(&with_layers("d4S/du4 + a^4 d4S/dv4")).solve(0, 0.0).err().expect("too thin");
    assert_eq!(refused.code, Code::LayersTooThin);
    assert!(refused.message.contains("layers too thin"), "{refused}");
    assert!(!refused.hints.iter().any(|hint| hint.starts_with("fourier:")), "{refused:?}");
    let open = with_layers("d4S/du4 + a^4 d4S/dv4").replace("cos(5v)", "e^(5v)");
    let refused = blend(&open).solve(0, 0.0).err().expect("too thin");
    assert!(refused.hints.iter().any(|hint| hint.contains("is not periodic over the range of v")), "{refused:?}");
}
