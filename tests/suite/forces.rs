//! Forces along v that have no finite closure: the method `fourier` against the closed form of each wave number.

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Source};
use trimline::method::{Options, Solution};

use crate::spec::{BOUNDARY, at};

/// What `auto` makes of `text` at instant `t`.
fn solved(text: &str, t: f64) -> (Blend, Solution) {
    let blend = Blend::compile(&Source::new("spec.trim", text), &Options::default());
    let blend = blend.unwrap_or_else(|found| panic!("{text}\n{found:?}"));
    let solution = blend.solve(0, t).unwrap_or_else(|found| panic!("{text}\n{found:?}"));
    (blend, solution)
}

fn codes(solution: &Solution) -> Vec<Code> {
    solution.report.warnings.iter().map(|finding| finding.code).collect()
}

/// The G with `(D² - n²)² G = 1` that is zero with its slope at u = 0 and 1: `1/n⁴ + a cosh ny + b y sinh ny` with
/// y = u - 1/2, and u² (1 - u)²/24 for n = 0.
fn clamped(n: i32, u: f64) -> f64 {
    if n == 0 {
        return (u * (1.0 - u)).powi(2) / 24.0;
    }
    let (n, y, h) = (f64::from(n), u - 0.5, 0.5);
    let (sinh, cosh) = ((n * h).sinh(), (n * h).cosh());
    // a cosh + b h sinh = -1/n⁴ and a n sinh + b (sinh + h n cosh) = 0 at y = h.
    let determinant = cosh * (sinh + h * n * cosh) - h * n * sinh * sinh;
    let a = -(sinh + h * n * cosh) / (n.powi(4) * determinant);
    let b = n * sinh / (n.powi(4) * determinant);
    1.0 / n.powi(4) + a * (n * y).cosh() + b * y * (n * y).sinh()
}

/// The clamped solution of the biharmonic equation for `size e^(-sharpness (v - centre)²)`, whose nth cosine about the centre
/// is `size √(π/sharpness) e^(-n²/(4 sharpness))/π`: what lies more than half a turn away is less than e^-800.
fn bulge(size: f64, sharpness: f64, centre: f64, [u, v]: [f64; 2]) -> f64 {
    let wave = |n: i32| {
        let share = if n == 0 { 0.5 } else { 1.0 };
        let decay = (-f64::from(n).powi(2) / (4.0 * sharpness)).exp();
        share * decay * clamped(n, u) * (f64::from(n) * (v - centre)).cos()
    };
    size * (std::f64::consts::PI / sharpness).sqrt() / std::f64::consts::PI * (0..=250).map(wave).sum::<f64>()
}

/// z of a surface about `v = c`, at places given from there; c must not show.
fn about(c: f64, values: &str, places: &[[f64; 2]]) -> Vec<f64> {
    let text = format!("param c = {c}\ndomain v in [c, c + 6]\n{values}");
    let (_, solution) = solved(&text, 0.0);
    assert!(!codes(&solution).contains(&Code::SeriesTruncated), "{c}: {:?}", solution.report.warnings);
    places.iter().map(|[u, v]| at(&*solution.surface, "", [*u, c + v, 0.0])[2]).collect()
}

#[test]
fn functions_about_a_far_centre_keep_the_digits_that_v_has() {
    let equation = "pde d4S/du4 + 2 d4S/du2dv2 + d4S/dv4";
    let force = format!(
        "{equation} = [0, 0, exp(-100 (v - c - 3)^2)]
        at u = 0: S = [v - c, 0, 0], dS/du = [0, 1, 0]\nat u = 1: S = [v - c, 1, 0], dS/du = [0, 1, 0]"
    );
    let boundary = format!(
        "{equation} = 0\nat u = 0: S = [0, 0, exp(-100 (v - c - 3)^2)], dS/du = [0, 1, 0]
        at u = 1: S = [0, 1, sin((v - c)^2)], dS/du = [0, 1, 0]"
    );
    // Binary fractions: v is exact about every centre.
    let places = [[0.5, 3.0], [0.25, 3.125], [0.75, 5.0]];
    let periodic = boundary.replace("sin((v - c)^2)", "0");
    for values in [force, boundary, periodic] {
        let near = about(0.0, &values, &places);
        let largest = near.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        for c in [1e3, 1e4, 1e5] {
            for (found, expected) in about(c, &values, &places).iter().zip(&near) {
                // The wave cos nv is rounded as n v is.
                assert!((found - expected).abs() <= 1e-15 * c * largest, "{c}: {found} {expected}");
            }
        }
    }
}

#[test]
fn product_of_powers_about_a_far_centre_is_the_one_about_zero() {
    let values = "at u = 0: S = [v - c, 0, (v - c)^5 (v - c + 1)^5], dS/du = 0\nat u = 1: S = [v - c, 1, 0], dS/du = 0";
    let places = [[0.5, 0.75], [0.25, 1.5], [0.75, 5.0]];
    for (found, expected) in about(1e6, values, &places).iter().zip(about(0.0, values, &places)) {
        assert!((found - expected).abs() <= 1e-14 * expected.abs(), "{found} {expected}");
    }
}

#[test]
fn narrow_force_is_a_series_and_boundary_data_that_close_stay_exact() {
    // v does not close over the range of v; it needs no series.
    let text = "pde (d2/du2 + d2/dv2)^2 S = [u*sin(v), 0, 100 e^(-100(v - 3)^2)]
        at u = 0: S = [v, 0, 0], dS/du = [0, 0, 1]
        at u = 1: S = [v, 1, 0], dS/du = [0, 0, 1]\n";
    let (blend, solution) = solved(text, 0.0);
    assert_eq!((solution.report.method, codes(&solution)), ("fourier", vec![Code::MethodPassedOver]));
    let left_out = solution.report.truncation.as_ref().and_then(|truncation| truncation.of_force).expect("a series");
    assert!(left_out > 0.0 && left_out < 1e-12, "{left_out:e}");
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() < 1e-14 && measured.relative_residual() < 1e-11, "{measured:?}");
    for [u, v] in [[0.5, 3.0], [0.3, 3.1], [0.7, 1.0], [0.25, 2.9], [0.9, 6.0]] {
        let [_, y, z] = at(&*solution.surface, "", [u, v, 0.0]);
        let expected = u * (1.0 - u) * (1.0 - 2.0 * u) + bulge(100.0, 100.0, 3.0, [u, v]);
        assert!((z - expected).abs() < 1e-13, "{u} {v}: {z} {expected}");
        assert!((y - u * u * (3.0 - 2.0 * u)).abs() < 1e-14, "{u} {v}: {y}");
    }
}

#[test]
fn force_narrower_than_the_limit_of_modes_says_what_is_left_out() {
    let text = format!("pde (d2/du2 + d2/dv2)^2 S = [0, 0, 1000 e^(-1000(v - 3)^2)]\n{BOUNDARY}");
    let (blend, solution) = solved(&text, 0.0);
    assert_eq!(codes(&solution), [Code::MethodPassedOver, Code::SeriesTruncated]);
    let warning = &solution.report.warnings[1];
    assert!(warning.message.contains("in the force, which the equation misses"), "{warning}");
    let left_out = solution.report.truncation.as_ref().and_then(|truncation| truncation.of_force).expect("a series");
    // √(1000/π)⁻¹/π Σ_(n > 256) e^(-n²/4000), by its integral: 256 modes of the Gaussian.
    assert!(left_out > 5e-9 && left_out < 2e-8, "{left_out:e}");
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.relative_residual() <= 1.1 * left_out, "{measured:?}");
    // 1/2 of the blend and 0.1926063495843668 of the force, computed with 40 digits.
    let [_, _, z] = at(&*solution.surface, "", [0.5, 3.0, 0.0]);
    assert!((z - 0.692_606_349_584_366_8).abs() < 2e-14, "{z}");
}

#[test]
fn force_over_an_open_range_is_a_polynomial_and_a_series() {
    let text = "domain v in [0, 1]
        param c = 0.2
        pde d4S/du4 + 3 d4S/du2dv2 + d4S/dv4 = [u e^(-100(v - c)^2), v^2 e^u, e^(-20(v - c)^2) + 2 sin(v)]
        at u = 0: S = [v, e^v, 0], dS/du = [0, 0, 1]
        at u = 1: S = [v, 1, 1], dS/du = [0, 0, 1]\n";
    let (blend, solution) = solved(text, 0.0);
    assert_eq!(solution.report.method, "fourier");
    let measured = blend.verify(0, &solution, 0.0).expect("finite");
    assert!(measured.boundary_error() < 1e-14, "{measured:?}");
    // The third derivative jumps at the ends: coefficients fall like 1/n⁴, and 256 modes leave out 1e-8 of the force.
    assert!(measured.relative_residual() < 1e-8, "{measured:?}");
}

#[test]
fn force_that_moves_and_boundary_data_without_closure_are_expanded_at_each_instant() {
    let text = "pde d4S/du4 + 3 d4S/du2dv2 + d4S/dv4 = [u e^(cos(v - t)), (e^(u))/(2 + sin v), t cos v]
        at u = 0: S = [cos v, sin v, e^(cos(v + t))], dS/du = [0, 0, 1]
        at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]\n";
    for t in [0.0, 0.7] {
        let (blend, solution) = solved(text, t);
        assert_eq!(solution.report.method, "fourier");
        assert_eq!(solution.separable().expect("a sum of products").instant, Some(t));
        let measured = blend.verify(0, &solution, t).expect("finite");
        assert!(measured.boundary_error() < 1e-14, "{measured:?}");
        // As without a force: the remainder of 1e-12 has fourth derivatives of up to 40^4 times its size.
        assert!(measured.relative_residual() < 1e-8, "{measured:?}");
    }
}

#[test]
fn force_that_is_no_sum_of_products_or_too_narrow_is_left_to_others_with_the_reason() {
    let cases = [
        ("1/(2 + u + cos v)", "in the force is no sum of products of functions of u and of v"),
        ("1000/(1 + 1e6(v - 3.01)^2)", "a Fourier series of 256 modes leaves out"),
    ];
    for (force, reason) in cases {
        let (_, solution) = solved(&format!("pde (d2/du2 + d2/dv2)^2 S = [0, 0, {force}]\n{BOUNDARY}"), 0.0);
        assert_eq!(solution.report.method, "legendre");
        assert!(solution.report.warnings.iter().any(|note| note.message.contains(reason)), "{reason}");
    }
}

#[test]
fn tube_stays_closed_under_a_force_that_does_not_close_or_says_that_it_opens() {
    let tube = |force: &str| {
        format!(
            "pde (d2/du2 + d2/dv2)^2 S = [0, 0, {force}]
            at u = 0: S = [cos(v), sin(v), 2], dS/du = [0, 0, -2]
            at u = 1: S = [cos(v), sin(v), 0], dS/du = [0, 0, -2]\n"
        )
    };
    // e^-6.25 and nothing at the ends of v: the force jumps by 0.002 of its size.
    let (_, solution) = solved(&tube("e^(-100(v - 0.25)^2)"), 0.0);
    assert_eq!(solution.report.method, "fourier");
    assert!(codes(&solution).contains(&Code::SeriesTruncated) && !codes(&solution).contains(&Code::SeamOpens));
    let closed = [[0.5, 0.0], [0.5, std::f64::consts::TAU]].map(|[u, v]| at(&*solution.surface, "", [u, v, 0.0])[2]);
    assert!((closed[0] - closed[1]).abs() < 1e-15, "{closed:?}");
    // The exact solution for e^-v is no more periodic than that is.
    let (_, solution) = solved(&tube("300 e^(-v)"), 0.0);
    assert_eq!((solution.report.method, codes(&solution)), ("exact", vec![Code::SeamOpens]));
    let (_, solution) = solved(&tube("300 cos(v)"), 0.0);
    assert_eq!((solution.report.method, codes(&solution)), ("exact", vec![]));
}

#[test]
fn solution_that_the_ends_of_v_make_far_larger_than_its_force_is_warned_of() {
    let sheet = |end: f64| {
        format!(
            "domain v in [0, {end}]
            pde (d2/du2 + d2/dv2)^2 S = [0, 0, 500 e^(-500(v - 1)^2)]
            at u = 0: S = [v, 0, 0], dS/du = [0, 1, 0]
            at u = 1: S = [v, 1, 0], dS/du = [0, 1, 0]\n"
        )
    };
    let (_, steep_at_the_end) = solved(&sheet(1.0), 0.0);
    assert!(codes(&steep_at_the_end).contains(&Code::EndsDominate));
    let (_, flat_at_the_ends) = solved(&sheet(2.0), 0.0);
    assert!(!codes(&flat_at_the_ends).contains(&Code::EndsDominate));
    // A plate under 500 everywhere bends by 500/384 in its middle.
    let [large, small] =
        [&steep_at_the_end, &flat_at_the_ends].map(|solution| at(&*solution.surface, "", [0.5, 1.0, 0.0])[2].abs());
    assert!(large > 3.0 * 500.0 / 384.0 && small < 500.0 / 384.0, "{large} {small}");
}

#[test]
fn boundary_data_that_are_steep_at_an_end_of_v_are_warned_of_as_well() {
    let bump = |end: f64| {
        format!(
            "domain v in [0, {end}]
            pde (d2/du2 + d2/dv2)^2 S = 0
            at u = 0: S = [v, 0, e^(-500(v - 1)^2)], dS/du = [0, 1, 0]
            at u = 1: S = [v, 1, 0], dS/du = [0, 1, 0]
            solve fourier\n"
        )
    };
    let (_, steep_at_the_end) = solved(&bump(1.0), 0.0);
    assert!(codes(&steep_at_the_end).contains(&Code::EndsDominate));
    // A bump of height 1 cannot lift the middle by more, and lifts it by far more here.
    assert!(at(&*steep_at_the_end.surface, "", [0.5, 1.0, 0.0])[2].abs() > 3.0);
    let (_, flat_at_the_ends) = solved(&bump(2.0), 0.0);
    assert!(!codes(&flat_at_the_ends).contains(&Code::EndsDominate));
    assert!(at(&*flat_at_the_ends.surface, "", [0.5, 1.0, 0.0])[2].abs() < 1.0);
}
