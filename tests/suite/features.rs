//! Where functions are narrow or infinite, and that no surface is handed out as if they were not.

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostic, Source};
use trimline::features::{Feature, Features, locate};
use trimline::method::Options;
use trimline::verify::Verification;

use crate::spec::{BOUNDARY, patch, problem, with_data};

const TURN: [f64; 2] = [0.0, std::f64::consts::TAU];

/// What is found of boundary data along v.
fn of_data(value: &str) -> Features {
    let problem = problem(&with_data(value));
    let root = patch(&problem).conditions[0].value[0];
    locate(&problem.graph, &[root], &[], [[0.0, 1.0], TURN], 0.25)
}

/// What is found of a force in z.
fn of_force(value: &str) -> Features {
    let problem = problem(&format!("pde d4S/du4 = [0, 0, {value}]\n{BOUNDARY}"));
    locate(&problem.graph, &patch(&problem).operator.force, &[], [[0.0, 1.0], TURN], 0.0)
}

/// The narrowest feature.
fn narrowest(features: &[Feature]) -> Feature {
    *features.iter().min_by(|a, b| a.width.total_cmp(&b.width)).expect("a feature")
}

#[test]
fn spikes_and_steps_are_located_however_narrow() {
    // The place, and a width within which the function changes by a quarter to all of its size.
    let cases = [
        ("1000 e^(-1e3(v - 3)^2)", 3.0, 3e-2),
        ("1000/(1 + 1e6(v - 3.01)^2)", 3.01, 1e-3),
        ("3/(1 + 1e8(v - 3.01)^2)", 3.01, 1e-4),
        ("3/(1 + 1e20(v - 3.01)^2)", 3.01, 1e-10),
        ("tanh(1e6(v - 3))", 3.0, 1e-6),
        ("sin(v) + 1e-3 atan(1e9(v - 1))", 1.0, 1e-9),
        ("1/(1 + e^(-1e7(v - 2)))", 2.0, 1e-7),
        ("e^(-1e5 sin(v - 2)^2)", 2.0, 3e-3),
        ("cos(tanh(1e5(v - 4)))", 4.0, 1e-5),
        // In the very middle between two samples of 65.
        ("1/(1 + e^(-1e7(v - 63 π/64)))", 63.0 / 64.0 * std::f64::consts::PI, 1e-7),
        ("(1 - (v - 3)^2/40)^1000000000", 3.0, 2e-4),
        ("sign(v - 5)", 5.0, 1e-15),
        ("e^(-1e4 v)", 0.0, 1e-4),
        ("tanh(1e8(v - 1 - t))", 1.25, 1e-8),
    ];
    for (value, at, width) in cases {
        let found = of_data(value).v;
        let is_it = |feature: &Feature| (feature.at - at).abs() <= 4.0 * width && feature.width <= 4.0 * width;
        assert!(found.iter().any(is_it), "{value}: {found:?}");
    }
}

#[test]
fn two_spikes_between_two_samples_are_both_located() {
    let found = of_data("e^(-1e14 (v - 2.96)^2 (v - 3.02)^2)").v;
    for place in [2.96, 3.02] {
        assert!(found.iter().any(|feature| (feature.at - place).abs() < 1e-4), "{place}: {found:?}");
    }
}

#[test]
fn ordinary_functions_are_not_narrow() {
    let ordinary = [
        "sin(5 v) cos(v)^3",
        "e^(v/10)",
        "e^(-v^2/2)",
        "sinh(0.3 v - 0.9)",
        "1/(2 + cos(v))",
        "sqrt(1 + v^2)",
        "tanh(v - 3)",
        "atan(3 (v - 3))",
        "tan(v/20)",
        "ln(1 + v)",
        "v^5 - 3 v",
        "1/(v + 1)",
        "cosh(v)^-2",
    ];
    for value in ordinary {
        assert_eq!(of_data(value), Features::default(), "{value}");
    }
}

#[test]
fn spike_in_two_coordinates_is_located_in_both() {
    let found = of_force("e^(-1e8((u - 0.513)^2 + (v - 3.01)^2))");
    let (u, v) = (narrowest(&found.u), narrowest(&found.v));
    assert!((u.at - 0.513).abs() < 1e-6 && u.width < 2e-4, "{found:?}");
    assert!((v.at - 3.01).abs() < 1e-6 && v.width < 2e-4, "{found:?}");
}

#[test]
fn poles_are_located_and_removable_ones_are_none() {
    let poles = [
        ("1e-12/(v - 3.01)", 3.01),
        ("5 + 1e-20/(v - 3)", 3.0),
        ("1/(v^2 - 3 v + 2.25)", 1.5),
        ("tan(v)", std::f64::consts::FRAC_PI_2),
        ("1/sin(v - 1)", 1.0),
        ("ln((v - 2)^2)", 2.0),
        ("e^(1/(v - 2)^2)", 2.0),
        ("sin(v)/(v - 1 - t)", 1.25),
    ];
    for (value, at) in poles {
        let found = of_data(value);
        let [pole, ..] = found.poles.as_slice() else { panic!("{value}: {found:?}") };
        // The discriminant of a double zero is rounding.
        assert!((pole.point[1] - at).abs() < 1e-7, "{value}: {found:?}");
    }
    for value in
        ["sin(v - 1)/(v - 1)", "e^(-1/(v - 1)^2)", "1/(1e-20 + (v - 3)^2)", "atan(1/(v - 1))", "(v - 1) ln((v - 1)^2)"]
    {
        assert_eq!(of_data(value).poles, [], "{value}");
    }
}

fn blend(text: &str) -> Blend {
    Blend::compile(&Source::new("test", text), &Options::default()).unwrap_or_else(|found| panic!("{text}\n{found:?}"))
}

/// The codes of what is said of the surface at t = 0, and what is measured of it.
fn solved(text: &str) -> Result<(Vec<Code>, Verification), Diagnostic> {
    let blend = blend(text);
    let solution = blend.solve(0, 0.0)?;
    let measured = blend.verify(0, &solution, 0.0)?;
    Ok((solution.report.warnings.iter().map(|finding| finding.code).collect(), measured))
}

#[test]
fn surface_that_leaves_out_a_narrow_force_coefficient_or_datum_is_warned_of() {
    let biharmonic = "pde d4S/du4 + 2 d4S/du2dv2 + d4S/dv4";
    let cases = [
        format!("{biharmonic} = [0, 0, 1000/(1 + 1e6(v - 3.01)^2)]\n{BOUNDARY}"),
        format!("pde d4S/du4 + (2 + 1e5 e^(-1e8(v - 3.01)^2)) d4S/du2dv2 + d4S/dv4 = 0\n{BOUNDARY}"),
        with_data("tanh(1e6(v - 3))"),
        with_data("3/(1 + 1e8(v - 3.01)^2)"),
    ];
    for text in cases {
        let (codes, measured) = solved(&text).unwrap_or_else(|found| panic!("{text}\n{found:?}"));
        assert!(codes.contains(&Code::LargeResidual), "{text}\n{codes:?}");
        assert!(measured.relative_residual() > 0.5, "{text}\n{measured:?}");
    }
}

#[test]
fn narrow_coefficient_or_force_in_u_is_refused_with_its_place_and_width() {
    let coefficient = "pde d4S/du4 + (2 + 1e5 e^(-1e8(u - 0.5137)^2)) d4S/du2dv2 + d4S/dv4 = 0";
    let force = "pde d4S/du4 + d4S/dv4 = [0, 0, 1e3 e^(-1e8(u - 0.5137)^2)]";
    for equation in [coefficient, force] {
        let found = solved(&format!("{equation}\n{BOUNDARY}")).expect_err("not resolved");
        assert_eq!(found.code, Code::SolutionNotFinite);
        assert!(found.message.contains("at u = 0.513700"), "{found}");
    }
}

#[test]
fn narrow_periodic_data_do_not_hide_from_the_samples_of_a_series() {
    // Between 64 samples the spike is not seen; the series would be that of a constant.
    let refused = solved(&with_data("3/(1 + 1e10 sin((v - 3.01)/2)^2)")).expect_err("no series of 256 modes has it");
    assert_eq!(refused.code, Code::UnsupportedByMethod);
    assert!(refused.message.contains("of the boundary data of size 3.0e0"), "{refused}");
}

#[test]
fn poles_inside_the_domain_are_refused_wherever_they_stand() {
    let deformed = |by: &str| format!("{BOUNDARY}deform u in [0.3, 0.6], v in [1, 2] by [0, 0, {by}] keeping C1");
    let cases = [
        (with_data("1e-12/(v - 3.01)"), "v = 3.01"),
        (with_data("tan(v)"), "v = 1.57"),
        (format!("pde d4S/du4 = [0, 0, 1/(u - 0.3)]\n{BOUNDARY}"), "u = 0.3"),
        (format!("pde d4S/du4 + (1/(v - 3.01))*d4S/dv4 = 0\n{BOUNDARY}"), "v = 3.01"),
        (deformed("1/(v - 1.5)"), "v = 1.5"),
        (deformed("1e-12/(v - 1.3)"), "v = 1.3"),
    ];
    for (text, place) in cases {
        let found = solved(&text).expect_err("a pole");
        assert_eq!(found.code, Code::DataNotFinite, "{text}\n{found}");
        assert!(found.message.contains(&format!("has a pole at {place}")), "{text}\n{found}");
        assert!(found.span.is_some() && !found.hints.is_empty(), "{text}\n{found:?}");
    }
    // It vanishes where the displacement does.
    assert!(solved(&deformed("1e-3/(v - 1)")).is_ok());
}

#[test]
fn displacement_that_leaves_no_digits_of_the_surface_is_refused() {
    let deformed = |by: &str| format!("{BOUNDARY}deform u in [0.3, 0.6], v in [1, 1.1] by [0, 0, {by}] keeping C1");
    assert_eq!(solved(&deformed("1e300")).expect_err("too large").code, Code::ShapeLost);
    assert!(solved(&deformed("1e3")).is_ok());
}
