//! The method `fourier` against values computed apart from this program, against `exact` on truncated series, and what
//! it says about its limits.

use serde_json::Value;
use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostic, Source};
use trimline::expr::Derivative;
use trimline::method::{Options, Settings, Solution};
use trimline::trial::{CardinalExponentials, Modes};

use crate::spec::{at, example, with_data};

fn compiled(text: &str, method: &str, settings: &[(&str, &str)]) -> Result<Blend, Diagnostic> {
    let mut all = Settings::default();
    for (key, value) in settings {
        all.set(key, value, None)?;
    }
    let options = Options { method: Some(method.to_owned()), settings: all, ..Options::default() };
    Blend::compile(&Source::new("spec.trim", text), &options).map_err(|mut findings| findings.remove(0))
}

fn solved(text: &str, settings: &[(&str, &str)]) -> (Blend, Solution) {
    let blend = compiled(text, "fourier", settings).unwrap_or_else(|finding| panic!("{finding}\n{text}"));
    let solution = blend.solve(0, 0.0).unwrap_or_else(|finding| panic!("{finding}\n{text}"));
    (blend, solution)
}

fn refusal(text: &str, settings: &[(&str, &str)]) -> Diagnostic {
    match compiled(text, "fourier", settings) {
        Err(finding) => finding,
        Ok(blend) => blend.solve(0, 0.0).err().expect("no surface"),
    }
}

fn reference(name: &str) -> Value {
    let path = format!("{}/tests/reference/{name}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).expect("the file is there")).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|number| number.as_f64().expect("a number")).collect()
}

/// The largest difference of two surfaces and of their first derivatives, over a grid of the domain.
fn distance(first: &Blend, one: &Solution, other: &Solution) -> f64 {
    let domain = &first.patches[0].domain;
    let mut worst = 0.0_f64;
    for i in 0..=10 {
        for j in 0..=17 {
            let between = |[low, high]: [f64; 2], share: f64| low + (high - low) * share;
            let point = [between(domain.u, f64::from(i) / 10.0), between(domain.v, f64::from(j) / 17.0), 0.0];
            for letters in ["", "u", "v"] {
                let [a, b] = [one, other].map(|solution| at(&*solution.surface, letters, point));
                worst = a.iter().zip(b).fold(worst, |most, (a, b)| most.max((a - b).abs()));
            }
        }
    }
    worst
}

#[test]
fn published_shape_of_five_modes_is_reproduced_with_its_derivatives() {
    let reference = reference("p3");
    let cases = [
        ("pos4_5modes", "p3_positions", "off"),
        ("pos4_5modes_remainder", "p3_positions", "on"),
        ("standard_5modes_remainder", "p3_tangents", "on"),
    ];
    for (id, name, remainder) in cases {
        let (_, solution) = solved(&example(name), &[("modes", "5"), ("remainder", remainder)]);
        let variants = reference["variants"].as_array().expect("variants");
        let variant = variants.iter().find(|variant| variant["id"] == id).expect("the variant");
        let rows: Vec<Vec<f64>> = variant["values"].as_array().expect("rows").iter().map(numbers).collect();
        assert_eq!(rows.len(), 40);
        for row in rows {
            for (group, letters) in ["", "u", "v"].into_iter().enumerate() {
                let found = at(&*solution.surface, letters, [row[0], row[1], 0.0]);
                for (found, expected) in found.iter().zip(&row[2 + 3 * group..]) {
                    // Sums of a few dozen rounded numbers below 5; the reference asks for 1e-9.
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
fn functions_of_one_wave_number_are_those_of_extended_precision_up_to_2000() {
    let reference = reference("exponentials");
    let third = 1.0 / 3.0;
    let points: Vec<Vec<f64>> = reference["points"].as_array().expect("points").iter().map(numbers).collect();
    for case in reference["cases"].as_array().expect("cases") {
        let functionals: &[(f64, usize)] = match case["conditions"].as_str() {
            Some("ends") => &[(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)],
            Some("positions") => &[(0.0, 0), (third, 0), (2.0 * third, 0), (1.0, 0)],
            _ => &[(0.0, 0), (0.0, 1), (0.0, 2), (1.0, 0), (1.0, 1), (1.0, 2)],
        };
        let w = case["w"].as_f64().expect("a number");
        let functions = CardinalExponentials::new(w, [0.0, 1.0], functionals).expect("independent");
        let rows: Vec<Vec<f64>> = case["values"].as_array().expect("rows").iter().map(numbers).collect();
        for order in [0, 1, 2, 4] {
            let here = |point: &Vec<f64>| point[1] == order as f64;
            for i in 0..functionals.len() {
                let largest = points
                    .iter()
                    .zip(&rows)
                    .filter(|(point, _)| here(point))
                    .fold(0.0_f64, |most, (_, row)| most.max(row[i].abs()));
                for (point, row) in points.iter().zip(&rows).filter(|(point, _)| here(point)) {
                    let error = (functions.derivatives(order, point[0])[i] - row[i]).abs();
                    // The argument w u of an exponential is rounded: w times 1e-16; conditions below w = 10 reach 1e3.
                    let allowed = 2e-13 + 4e-16 * w;
                    assert!(
                        error <= allowed * largest,
                        "{} w = {w}, order {order}, function {i}: {:.1e}",
                        case["conditions"],
                        error / largest
                    );
                }
            }
        }
    }
}

/// `Σ_n c_n cos nv`, with closed forms of the coefficients, as text.
fn cosines(coefficient: impl Fn(usize) -> f64, modes: usize) -> String {
    (0..=modes)
        .map(|n| format!("({:e})*cos({n} v)", coefficient(n)))
        .collect::<Vec<_>>()
        .join(" + ")
        .replace("cos(0 v)", "1")
}

/// The modified Bessel function I_n(x), by its series.
fn bessel_i(n: usize, x: f64) -> f64 {
    let first = (1..=n).fold(1.0, |term, k| term * 0.5 * x / k as f64);
    let terms = (1..40).scan(first, |term, k| {
        *term *= 0.25 * x * x / (k as f64 * (n + k) as f64);
        Some(*term)
    });
    first + terms.sum::<f64>()
}

#[test]
fn smooth_periodic_data_need_the_modes_that_their_decay_predicts_and_reach_1e_12() {
    // 1/(2 + cos v) has the coefficients (2/√3) (-r)^n, r = 2 - √3; exp(cos v) has 2 I_n(1).
    let ratio = 2.0 - 3.0_f64.sqrt();
    let pole = move |n: usize| (if n == 0 { 1.0 } else { 2.0 }) / 3.0_f64.sqrt() * (-ratio).powi(n as i32);
    let bell = |n: usize| (if n == 0 { 1.0 } else { 2.0 }) * bessel_i(n, 1.0);
    // Beyond these the coefficients add up to less than 1e-12 of the largest value, 1 and e.
    let cases: [(&str, String, usize); 2] =
        [("1/(2 + cos(v))", cosines(pole, 40), 21), ("exp(cos(v))", cosines(bell, 30), 11)];
    for equation in ["(d2/du2 + 4*d2/dv2)^2 S = 0", "d4S/du4 + 3*d4S/du2dv2 + 2*d4S/dv4 = 0"] {
        for (function, written, modes) in &cases {
            let spec = |data: &str| {
                format!(
                    "pde {equation}\nat u = 0: S = [{data}, 0, 1], dS/du = 0\nat u = 1: S = 0, dS/du = [0, {data}, 0]\n"
                )
            };
            let (blend, solution) = solved(&spec(function), &[]);
            assert!(solution.report.modes.abs_diff(*modes) <= 1, "{function}: {}", solution.report.modes);
            let exact = compiled(&spec(written), "exact", &[]).expect("a closure").solve(0, 0.0).expect("a solution");
            let found = distance(&blend, &solution, &exact);
            // 1e-12 of the data is left out, and slopes of what is left out count as many times as there are modes.
            assert!(found < 1e-12 * *modes as f64, "{function}, {equation}: {found:.1e}");
        }
    }
}

#[test]
fn composed_sines_meet_boundary_and_equation() {
    let text = "pde (d2/du2 + d2/dv2)^2 S = 0
        at u = 0: S = [sin(sin(v)), cos(2 sin(v)), 0], dS/du = 0
        at u = 1: S = [cos(v), sin(v), 1], dS/du = [exp(sin(3 v)), 0, 0]";
    let (blend, solution) = solved(text, &[]);
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() < 1e-14, "{measured:?}");
    // What is left out is 1e-12, and the fourth derivatives of its functions are up to 80^4 times as large.
    assert!(measured.relative_residual() < 1e-7, "{measured:?}");
    assert!(!solution.report.is_exact);
}

#[test]
fn any_equation_with_force_and_odd_derivatives_is_solved_as_exact_solves_it() {
    let spec = |data: &str| {
        format!(
            "pde d4S/du4 + [1, 2, 3] d4S/du2dv2 + d3S/du2dv - dS/dv + d4S/dv4 = [sin(v), u, exp(u)*cos(2 v)]
        at u = 0: S = [{data}, sin(v), 0], dS/du = 0
        at u = 1: S = [0, {data}, 0], dS/du = [0, 0, {data}]\n"
        )
    };
    let (blend, solution) = solved(&spec("exp(cos(v))"), &[]);
    let written = cosines(|n| (if n == 0 { 1.0 } else { 2.0 }) * bessel_i(n, 1.0), 20);
    let exact = compiled(&spec(&written), "exact", &[]).expect("a closure").solve(0, 0.0).expect("a solution");
    let found = distance(&blend, &solution, &exact);
    assert!(found < 1e-11, "{found:.1e}");
}

#[test]
fn period_is_the_range_of_v_wherever_it_lies() {
    let spec = |range: &str, v: &str| {
        format!(
            "domain v in {range}\npde (d2/du2 + d2/dv2)^2 S = 0
        at u = 0: S = [exp(cos({v})), sin({v}), 0], dS/du = 0
        at u = 1: S = [0, exp(sin({v})), 1], dS/du = 0\n"
        )
    };
    // With w = π(v - 1)/2 the equation has (π/2)² in front of its derivatives in w.
    let (blend, solution) = solved(&spec("[-1, 3]", "π(v - 1)/2"), &[]);
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() < 1e-14, "{measured:?}");
    let turned = spec("[0, 2π]", "v").replace("(d2/du2 + d2/dv2)", "(d2/du2 + (π/2)^2 d2/dv2)");
    let (_, expected) = solved(&turned, &[]);
    for (u, v) in [(0.2, -0.7), (0.5, 0.4), (0.9, 2.9)] {
        let w = std::f64::consts::FRAC_PI_2 * (v - 1.0);
        let [a, b] = [at(&*solution.surface, "", [u, v, 0.0]), at(&*expected.surface, "", [u, w, 0.0])];
        for (a, b) in a.iter().zip(b) {
            assert!((a - b).abs() < 1e-11, "{u} {v}: {a} {b}");
        }
    }
}

#[test]
fn remainder_meets_the_boundary_and_its_absence_misses_by_what_is_reported() {
    for name in ["p3_positions", "p3_tangents"] {
        for modes in ["0", "1", "5"] {
            let (blend, with) = solved(&example(name), &[("modes", modes)]);
            let measured = blend.verify(0, &with, 0.0).expect("finite");
            assert!(measured.boundary_error() < 1e-13, "{name} {modes}: {measured:?}");
            let truncation = with.report.truncation.expect("a truncated series");
            let (blend, without) = solved(&example(name), &[("modes", modes), ("remainder", "off")]);
            let missed = blend.verify(0, &without, 0.0).expect("finite").boundary_error();
            // Measured at different points, which see the same extremes to a few per cent.
            assert!((missed / truncation.left_out - 1.0).abs() < 0.1, "{name} {modes}: {missed} {truncation:?}");
            let codes: Vec<Code> = without.report.warnings.iter().map(|warning| warning.code).collect();
            assert_eq!(codes, [Code::SeriesTruncated], "{name} {modes}");
        }
    }
}

#[test]
fn high_wave_numbers_neither_overflow_nor_lose_the_boundary() {
    let text = "pde (d2/du2 + 100 d2/dv2)^2 S = 0
        at u = 0: S = [1/(1.02 + cos(v)), sin(v), 0], dS/du = [0, 0, 1]
        at u = 1: S = [cos(v), 1/(1.02 + sin(v)), 1], dS/du = 0";
    // a n = 2000.
    let (blend, solution) = solved(text, &[("modes", "200")]);
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() <= 1e-13 * measured.data_size, "{measured:?}");
    // The values are 50 times and their coefficients fall like 0.82^n: all of them count.
    assert!(solution.report.truncation.expect("a series").left_out < 1e-12 * 50.0);
}

#[test]
fn data_that_do_not_close_are_a_polynomial_and_a_series() {
    // Both sides of a strip that has no period: e^(v/3) is solved in closed form by `exact`.
    let data = "at u = 0: S = [1 + v/2, exp(v/3), v^5], dS/du = [0, v, 1]\nat u = 1: S = [2, v^2, 0], dS/du = [0, 0, exp(-v/4)]";
    for (equation, tolerance) in
        [("pde (d2/du2 + d2/dv2)^2 S = 0", 1e-13), ("pde d4S/du4 + 3 d4S/du2dv2 + d4S/dv4 = [1, u, 0]", 1e-11)]
    {
        let text = format!("domain v in [0.5, 3]\n{equation}\n{data}\n");
        let (blend, solution) = solved(&text, &[("tolerance", "1e-8")]);
        let measured = blend.verify(0, &solution, 0.0).expect("finite");
        assert!(measured.boundary_error() <= tolerance * measured.data_size, "{measured:?}");
        let truncation = solution.report.truncation.expect("a series");
        assert!(truncation.left_out > 0.0 && truncation.left_out < 1e-5 && truncation.has_remainder, "{truncation:?}");
        // Polynomials of degree 5 are no part of a series, and so solved exactly.
        let polynomial = format!(
            "domain v in [0.5, 3]\n{equation}\n{}\n",
            data.replace("exp(v/3)", "v").replace("exp(-v/4)", "v^3")
        );
        let (_, found) = solved(&polynomial, &[]);
        let exact = Blend::compile(
            &Source::new("spec", polynomial),
            &Options { method: Some("exact".to_owned()), ..Options::default() },
        );
        let exact = exact.expect("a problem").solve(0, 0.0).expect("a closure");
        for point in [[0.3, 0.7, 0.0], [0.5, 1.9, 0.0], [0.9, 2.9, 0.0]] {
            let [a, b] = [&found, &exact].map(|solution| at(&*solution.surface, "", point));
            assert!(crate::bspline::distance(a, b) <= 1e-9 * measured.data_size, "{equation}: {a:?} {b:?}");
        }
    }
}

#[test]
fn data_that_vary_fast_are_not_taken_for_data_with_a_corner() {
    let (_, solution) = solved(&with_data("cos(3000 v)"), &[("modes", "8")]);
    let warning = solution.report.warnings.first().expect("the wave is left out");
    assert!(warning.hints[0].contains("more modes leave out less"), "{warning:?}");
}

#[test]
fn data_whose_slope_jumps_are_solved_and_their_slow_decay_is_told() {
    let text = format!("pde (d2/du2 + d2/dv2)^2 S = 0\n{}", with_data("v*sin(v)"));
    let (blend, solution) = solved(&text, &[]);
    assert_eq!(solution.report.modes, 256);
    let left_out = solution.report.truncation.as_ref().expect("a series").left_out;
    // v sin v has the coefficients 2/(1 - n²): the tail from 257 on is 2/256.
    assert!((left_out - 2.0 / 256.5).abs() < 0.05 * left_out, "{left_out}");
    let warning = solution.report.warnings.first().expect("a warning");
    assert_eq!(warning.code, Code::SeriesTruncated);
    assert!(warning.hints[0].contains("a slope jumps by 6.28"), "{warning:?}");
    assert!(blend.verify(0, &solution, 0.0).expect("finite").boundary_error() < 1e-13);
}

/// Sizes of the position functions in extended precision: 1.63, 1.985, 3.606, 43.78 and 809.7 for w = 1, 6, 10, 20, 30
/// between positions at thirds, 1.132 for w = 10 between 0, 0.1, 0.9 and 1.
#[test]
fn amplification_between_positions_is_reported() {
    let spec = |inner: [&str; 2]| {
        format!(
            "pde (d2/du2 + d2/dv2)^2 S = 0
        at u = 0: S = [cos(v), sin(v), 0]
        at u = {}: S = [cos(v), sin(v), 1]
        at u = {}: S = [cos(v), sin(v), 2]
        at u = 1: S = [exp(cos(v)), sin(v), 3]\n",
            inner[0], inner[1]
        )
    };
    let told = |inner: [&str; 2], modes: &str| {
        let (_, solution) = solved(&spec(inner), &[("modes", modes)]);
        let warnings = solution.report.warnings.into_iter().filter(|warning| warning.code == Code::PositionsAmplify);
        warnings.map(|warning| warning.message).next()
    };
    let thirds = ["1/3", "2/3"];
    assert_eq!(told(thirds, "5"), None);
    assert!(told(thirds, "9").expect("a warning").contains("grows 3.6e0 times"));
    assert!(told(thirds, "19").expect("a warning").contains("grows 4.4e1 times"));
    assert!(told(thirds, "29").expect("a warning").contains("grows 8.1e2 times"));
    assert_eq!(told(["0.1", "0.9"], "9"), None);
}

#[test]
fn functions_that_exceed_the_doubles_are_refused() {
    // e^(2570/3) is above 1e308.
    let text = example("p3_positions").replace("param a = 1", "param a = 10");
    let found = refusal(&text, &[("modes", "256")]);
    assert_eq!(found.code, Code::SolutionNotFinite);
    assert!(found.message.contains("exceed the doubles"), "{found}");
}

#[test]
fn each_instant_has_its_own_series() {
    let text = "pde (d2/du2 + d2/dv2)^2 S = 0
        at u = 0: S = [exp(t cos(v)), sin(v), 0], dS/du = 0
        at u = 1: S = [cos(v), exp(t sin(v)), sqrt(1 + t)], dS/du = 0";
    let blend = compiled(text, "fourier", &[]).expect("periodic");
    for t in [0.0, 0.4, 1.0] {
        let solution = blend.solve(0, t).expect("a solution");
        assert_eq!(solution.separable().expect("a sum of products").instant, Some(t));
        assert!(blend.verify(0, &solution, t).expect("finite").boundary_error() < 1e-14);
    }
    let still = compiled(&text.replace("t cos", "cos").replace("t sin", "sin").replace("1 + t", "2"), "fourier", &[]);
    assert_eq!(
        still.expect("periodic").solve(0, 0.3).expect("a solution").separable().expect("a sum of products").instant,
        None
    );
}

#[test]
fn settings_out_of_range_are_refused() {
    let text = example("p3_tangents");
    assert_eq!(refusal(&text, &[("modes", "257")]).code, Code::LimitReached);
    assert_eq!(refusal(&text, &[("modes", "many")]).code, Code::UnknownSetting);
    assert_eq!(refusal(&text, &[("remainder", "maybe")]).code, Code::UnknownSetting);
    let plain = text.replace(", modes = 5", "");
    assert_eq!(refusal(&plain, &[("tolerance", "1")]).code, Code::SettingOutOfRange);
    assert_eq!(refusal(&plain, &[("tolerance", "1e-6"), ("modes", "5")]).code, Code::UnknownSetting);
    let (_, few) = solved(&plain, &[("tolerance", "1e-4")]);
    let (_, many) = solved(&plain, &[("tolerance", "1e-10")]);
    assert!(few.report.modes < many.report.modes, "{} {}", few.report.modes, many.report.modes);
}

#[test]
fn equations_that_couple_wave_numbers_or_instants_are_refused() {
    for equation in
        ["d4S/du4 + cos(v) d4S/dv4 = 0", "d4S/du4 + dS/dt = 0", "d4S/du4 + d4S/dv4 = [exp(cos(u + v)), 0, 0]"]
    {
        let found = refusal(&format!("pde {equation}\n{}", with_data("exp(cos(v))")), &[]);
        assert_eq!(found.code, Code::UnsupportedByMethod, "{equation}: {found}");
    }
}

#[test]
fn derivatives_of_the_surface_are_its_differences() {
    let (_, solution) = solved(&example("p3_tangents"), &[]);
    let step = 1e-5;
    let value = |letters: &str, u: f64, v: f64| at(&*solution.surface, letters, [u, v, 0.0])[0];
    for (u, v) in [(0.3, 1.1), (0.8, 4.0)] {
        for (letters, more) in [("", "u"), ("uu", "uuu"), ("vv", "uvv")] {
            let quotient = (value(letters, u + step, v) - value(letters, u - step, v)) / (2.0 * step);
            let found = value(more, u, v);
            // Truncation 1e-10 times a derivative of order five, rounding 1e-16/1e-5 times the value.
            assert!((quotient - found).abs() < 1e-6 * (1.0 + found.abs()), "{more}: {quotient} {found}");
        }
    }
    let mut values = [[0.0; 3]];
    let orders = Derivative::new(0, 0, 1);
    solution.surface.evaluate(orders, &[[0.3, 1.0, 0.0]], &mut values).expect("data that do not move");
    assert_eq!(values, [[0.0; 3]]);
}

#[test]
fn data_without_derivatives_are_solved_by_their_series_alone() {
    let text = with_data("abs(sin(v))");
    let (blend, solution) = solved(&text, &[]);
    let truncation = solution.report.truncation.as_ref().expect("a series");
    // |sin v| has the coefficients -4/π/(n² - 1) for even n: the tail from 258 on adds up to 2/π/257 at v = 0.
    assert!(
        (truncation.left_out - 2.0 / std::f64::consts::PI / 257.0).abs() < 0.05 * truncation.left_out,
        "{truncation:?}"
    );
    assert!(!truncation.has_remainder);
    let missed = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(missed.boundary_error() <= 1.05 * truncation.left_out, "{missed:?}");
    // Nothing but the modes, each of which solves the equation.
    assert!(missed.relative_residual() < 1e-12, "{missed:?}");
    let found = refusal(&text, &[("remainder", "on")]);
    assert_eq!(found.code, Code::NotDifferentiable);
    assert!(found.hints.iter().any(|hint| hint.contains("`remainder = off`")), "{found:?}");
}

#[test]
fn data_with_a_pole_or_a_jump_are_refused() {
    let pole = refusal(&with_data("1/(1 + 1.2 sin(2 v))"), &[("remainder", "off")]);
    assert_eq!(pole.code, Code::DataNotFinite, "{pole}");
    // Half of π + arcsin(1/1.2).
    assert!(pole.message.contains("has a pole at v = 2.0633517184637"), "{pole}");
    let jump = refusal(&with_data("atan(tan(v/2 + 1))"), &[("remainder", "off")]);
    assert_eq!(jump.code, Code::UnsupportedByMethod, "{jump}");
    assert!(jump.message.contains("of the boundary data of size"), "{jump}");
}
