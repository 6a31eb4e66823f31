//! Surfaces as B-splines: the promised distance, measured apart, and what happens at edges and seams.

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostic, Source};
use trimline::expr::Derivative;
use trimline::fit::{Fitted, Settings, Target, fit};
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::surface::{BsplineSurface, Surface};

use crate::bspline::{distance, places, surface};
use crate::spec::{Prepared, at, example};

/// A surface whose coordinates are products `f(u) g(v)`, each given with all its derivatives.
struct Product([(Curve, Curve); 3]);

/// The derivative of an order at a place.
type Curve = fn(usize, f64) -> f64;

impl Surface for Product {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        for (point, value) in points.iter().zip(values) {
            let [u, v, _] = *point;
            *value = self.0.map(|(f, g)| f(derivative.u, u) * g(derivative.v, v));
        }
        Ok(())
    }
}

fn sine(order: usize, x: f64) -> f64 {
    (x + order as f64 * std::f64::consts::FRAC_PI_2).sin()
}

fn cosine(order: usize, x: f64) -> f64 {
    sine(order + 1, x)
}

fn exponential(_: usize, x: f64) -> f64 {
    x.exp()
}

fn one(order: usize, _: f64) -> f64 {
    if order == 0 { 1.0 } else { 0.0 }
}

/// x (2π - x), which closes over a turn with a corner.
fn arch(order: usize, x: f64) -> f64 {
    match order {
        0 => x * (TURN - x),
        1 => TURN - 2.0 * x,
        2 => -2.0,
        _ => 0.0,
    }
}

const TURN: f64 = std::f64::consts::TAU;

/// A trumpet: closed in v, with no symmetry that would make anything exact.
const TRUMPET: Product = Product([(exponential, cosine), (exponential, sine), (sine, one)]);

fn target(surface: &dyn Surface, u: [f64; 2], v: [f64; 2]) -> Target<'_> {
    Target { name: "part", surface, u, v }
}

fn fitted(target: &Target, degree: usize, tolerance: f64) -> Fitted {
    let settings = Settings { degree, tolerance: Some(tolerance) };
    let mut fits =
        fit(std::slice::from_ref(target), 0.0, &settings, &Limits::default()).unwrap_or_else(|found| panic!("{found}"));
    fits.remove(0)
}

/// The largest distance on a grid that has nothing to do with knots.
fn apart(surface: &dyn Surface, fitted: &BsplineSurface, t: f64) -> f64 {
    let [u, v] = fitted
        .domain()
        .map(|[a, b]| (0..=97).map(|i| a + (b - a) * f64::from(i) / 97.0).map(|x| x.min(b)).collect::<Vec<f64>>());
    let mut values = [vec![[0.0; 3]; u.len() * v.len()], vec![[0.0; 3]; u.len() * v.len()]];
    surface.evaluate_grid(Derivative::NONE, (&u, &v, t), &mut values[0]).expect("finite");
    fitted.evaluate_grid(Derivative::NONE, (&u, &v, t), &mut values[1]).expect("finite");
    let norm = |p: [f64; 3], q: [f64; 3]| (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt();
    values[0].iter().zip(&values[1]).fold(0.0_f64, |most, (p, q)| most.max(norm(*p, *q)))
}

#[test]
fn distance_stays_below_the_tolerance_where_nothing_was_measured() {
    for degree in 3..=5 {
        for tolerance in [1e-3, 1e-6, 1e-9] {
            for v in [[0.0, TURN], [0.3, 2.0]] {
                let fit = fitted(&target(&TRUMPET, [-0.5, 1.0], v), degree, tolerance);
                let apart = apart(&TRUMPET, &fit.surface, 0.0);
                assert!(fit.deviation <= tolerance, "{degree} {tolerance:e} {:.1e}", fit.deviation);
                // Between Gauss points the error may be a little larger than on them.
                assert!(
                    apart <= 1.1 * fit.deviation,
                    "{degree} {tolerance:e}: {apart:.2e} above {:.2e}",
                    fit.deviation
                );
                assert!(
                    apart >= 0.3 * fit.deviation,
                    "{degree} {tolerance:e}: {apart:.2e} far below {:.2e}",
                    fit.deviation
                );
                assert_eq!(fit.is_closed_in_v, v == [0.0, TURN]);
            }
        }
    }
}

#[test]
fn eq19_at_its_instant_is_fitted_to_a_millionth() {
    let solution = Prepared::new(&example("eq19"), &[]).solve(0.2);
    let target = Target { name: "eq19", surface: &*solution.surface, u: [0.0, 1.0], v: [0.0, TURN] };
    let settings = Settings { tolerance: Some(1e-6), ..Settings::default() };
    let fits = fit(&[target], 0.2, &settings, &Limits::default()).unwrap_or_else(|found| panic!("{found}"));
    let apart = apart(&*solution.surface, &fits[0].surface, 0.2);
    assert!((1e-8..=1e-6).contains(&apart), "{apart:.1e}");
    assert!(fits[0].is_closed_in_v);
    assert!(fits[0].edge_deviation <= 1e-6);
    assert!(fits[0].tangent_deviation <= 1e-4, "{:.1e}", fits[0].tangent_deviation);
}

#[test]
fn polynomial_of_the_degree_is_met_to_rounding_by_the_first_knots() {
    for degree in 3..=5 {
        // One span is a polynomial surface.
        let polynomial = surface(60, [degree; 2], [degree + 1; 2]);
        let [u, v] = polynomial.domain();
        let fit = fitted(&target(&polynomial, u, v), degree, 1e-12);
        assert!(apart(&polynomial, &fit.surface, 0.0) <= 1e-14, "{degree}");
        assert_eq!(fit.surface.knots().map(|knots| knots.points()), [4 + degree, 8 + degree]);
    }
}

#[test]
fn ends_of_u_are_met_exactly_at_the_knots_in_position_and_tangent() {
    let fit = fitted(&target(&TRUMPET, [-0.5, 1.0], [0.3, 2.0]), 3, 1e-4);
    for u in [-0.5, 1.0] {
        for v in fit.surface.knots()[1].breakpoints() {
            // Rounding of solved coefficients of size e.
            for derivative in ["", "u"] {
                let gap = distance(at(&fit.surface, derivative, [u, v, 0.0]), at(&TRUMPET, derivative, [u, v, 0.0]));
                assert!(gap <= 1e-14 * 4.0, "{derivative} {u} {v}: {gap:.1e}");
            }
        }
    }
    assert!(fit.edge_deviation > 1e-9, "between knots it is interpolated: {:.1e}", fit.edge_deviation);
}

#[test]
fn closed_surface_has_one_seam_column_and_smooth_derivatives_there() {
    for degree in 3..=5 {
        let fit = fitted(&target(&TRUMPET, [-0.5, 1.0], [0.0, TURN]), degree, 1e-5);
        for row in fit.surface.rows() {
            assert_eq!(row.first(), row.last());
        }
        for u in places(fit.surface.knots()[0]) {
            for (order, derivative) in ["", "v", "vv", "vvv"].into_iter().enumerate().take(degree) {
                let [start, end] = [0.0, TURN].map(|v| at(&fit.surface, derivative, [u, v, 0.0]));
                // Rounding over steps h of at least 0.05: eps / h^order.
                let allowed = 1e-14 * 20.0_f64.powi(order as i32);
                assert!(distance(start, end) <= allowed, "{degree} {derivative} {:.1e}", distance(start, end));
            }
        }
    }
}

#[test]
fn surface_that_closes_in_a_corner_keeps_its_corner_and_one_column() {
    let cup = Product([(one, cosine), (one, arch), (sine, one)]);
    let fit = fitted(&target(&cup, [0.0, 1.0], [0.0, TURN]), 3, 1e-5);
    assert!(fit.is_closed_in_v);
    assert!(fit.surface.rows().all(|row| row.first() == row.last()));
    assert!(apart(&cup, &fit.surface, 0.0) <= 1e-5);
    let [start, end] = [0.0, TURN].map(|v| at(&fit.surface, "v", [0.5, v, 0.0])[1]);
    assert!((start - TURN).abs() < 1e-12 && (end + TURN).abs() < 1e-12, "{start} {end}");
}

#[test]
fn patches_fitted_together_have_their_common_edge_bit_for_bit() {
    let targets = |ranges: [([f64; 2], [f64; 2]); 2]| ranges.map(|(u, v)| target(&TRUMPET, u, v));
    let settings = Settings { tolerance: Some(1e-5), ..Settings::default() };
    let both = |targets: [Target; 2]| fit(&targets, 0.0, &settings, &Limits::default()).expect("two fits");
    // The second range is steeper and needs more knots; along the common edge both have them.
    let across = both(targets([([-3.0, 0.0], [0.0, 2.0]), ([0.0, 2.0], [0.0, 2.0])]));
    assert_eq!(across[0].surface.knots()[1], across[1].surface.knots()[1]);
    assert_eq!(across[0].surface.rows().next_back(), across[1].surface.rows().next());
    let along = both(targets([([0.0, 1.0], [0.0, 1.0]), ([0.0, 1.0], [1.0, 4.0])]));
    assert_eq!(along[0].surface.knots()[0], along[1].surface.knots()[0]);
    let columns = |fit: &Fitted| fit.surface.transposed();
    assert_eq!(columns(&along[0]).rows().next_back(), columns(&along[1]).rows().next());
}

/// Another surface over other parameters: turned by a quarter or a half, stretched and shifted.
struct Turned<'a> {
    base: &'a dyn Surface,
    /// Of u and of v of the base: which parameter here it comes from, the factor and the summand.
    maps: [(usize, f64, f64); 2],
}

impl Surface for Turned<'_> {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let orders = [derivative.u, derivative.v];
        let place = |[u, v, t]: &[f64; 3]| {
            let [a, b] = self.maps.map(|(which, factor, summand)| factor * [u, v][which] + summand);
            [a, b, *t]
        };
        let of_base = self.maps.map(|(which, _, _)| orders[which]);
        let factor: f64 = self.maps.iter().map(|(which, factor, _)| factor.powi(orders[*which] as i32)).product();
        let places: Vec<[f64; 3]> = points.iter().map(place).collect();
        self.base.evaluate(Derivative::new(of_base[0], of_base[1], 0), &places, values)?;
        values.iter_mut().flatten().for_each(|x| *x *= factor);
        Ok(())
    }
}

/// The control points of a side: along u or v, at the low or the high end.
fn side(fit: &Fitted, axis: usize, is_high: bool) -> Vec<[f64; 3]> {
    let surface = if axis == 0 { fit.surface.transposed() } else { fit.surface.clone() };
    let mut rows = surface.rows();
    if is_high { rows.next_back() } else { rows.next() }.expect("a row").to_vec()
}

#[test]
fn common_edge_is_one_across_u_and_v_in_both_directions_and_over_other_ranges() {
    for degree in 3..=5 {
        // The part of the trumpet with u in [0, 1], and that with u in [1, 2] told in other parameters (p, q), so that
        // the edge u = 1 is a side along p or along q.
        for (maps, ranges, axis, is_high, is_reversed) in [
            // u = 1 + q, v = 2p.
            ([(1, 1.0, 1.0), (0, 2.0, 0.0)], [[0.0, 1.0], [0.0, 1.0]], 0, false, false),
            // u = 1 + q, v = 2 - 2p.
            ([(1, 1.0, 1.0), (0, -2.0, 2.0)], [[0.0, 1.0], [0.0, 1.0]], 0, false, true),
            // u = 2 - q, v = p/3 - 1.
            ([(1, -1.0, 2.0), (0, 1.0 / 3.0, -1.0)], [[3.0, 9.0], [0.0, 1.0]], 0, true, false),
            // u = 2 - p, v = 2 - q.
            ([(0, -1.0, 2.0), (1, -1.0, 2.0)], [[0.0, 1.0], [0.0, 2.0]], 1, true, true),
        ] {
            let turned = Turned { base: &TRUMPET, maps };
            let near = target(&TRUMPET, [0.0, 1.0], [0.0, 2.0]);
            let far = target(&turned, ranges[0], ranges[1]);
            let settings = Settings { degree, tolerance: Some(1e-6) };
            let fits = fit(&[near, far], 0.0, &settings, &Limits::default()).expect("two fits");
            let edge = side(&fits[0], 1, true);
            let mut other = side(&fits[1], axis, is_high);
            if is_reversed {
                other.reverse();
            }
            assert_eq!(edge, other, "{maps:?}");
            let knots = fits[0].surface.knots()[1].breakpoints().into_iter().map(|v| v / 2.0);
            let [low, high] = ranges[axis];
            let share = |at: f64| if is_reversed { (high - at) / (high - low) } else { (at - low) / (high - low) };
            let mut others: Vec<f64> = fits[1].surface.knots()[axis].breakpoints().into_iter().map(share).collect();
            if is_reversed {
                others.reverse();
            }
            assert_eq!(knots.len(), others.len());
            assert!(knots.zip(&others).all(|(a, b)| (a - b).abs() < 1e-14), "{maps:?}");
            for (fit, surface) in fits.iter().zip([&TRUMPET as &dyn Surface, &turned]) {
                assert!(apart(surface, &fit.surface, 0.0) <= 1.1e-6 && fit.deviation <= 1e-6, "{maps:?}");
            }
        }
    }
}

#[test]
fn knots_crowd_where_the_surface_bends() {
    /// A hill of width 1/20 at x = 0.2.
    fn hill(order: usize, x: f64) -> f64 {
        let y = (x - 0.2) * 20.0;
        let bell = (-y * y).exp();
        match order {
            0 => bell,
            1 => -2.0 * y * bell * 20.0,
            2 => (4.0 * y * y - 2.0) * bell * 400.0,
            _ => unreachable!("cubic splines take no more"),
        }
    }
    fn line(order: usize, x: f64) -> f64 {
        [x, 1.0, 0.0][order]
    }
    let ridge = Product([(line, one), (one, line), (hill, one)]);
    let fit = fitted(&target(&ridge, [0.0, 1.0], [0.0, 1.0]), 3, 1e-6);
    let knots = fit.surface.knots()[0].breakpoints();
    let near = knots.iter().filter(|u| (**u - 0.2).abs() < 0.15).count();
    assert!(near * 2 > knots.len(), "{near} of {}", knots.len());
    assert_eq!(fit.surface.knots()[1].points(), 11, "v is straight: no knots are added there");
}

#[test]
fn higher_degree_takes_fewer_points() {
    let points =
        [3, 4, 5].map(|degree| fitted(&target(&TRUMPET, [-0.5, 1.0], [0.0, TURN]), degree, 1e-9).surface.net().len());
    assert!(points[0] > 2 * points[1] && points[1] > points[2], "{points:?}");
}

fn refused(target: &Target, settings: &Settings, limits: &Limits) -> Diagnostic {
    fit(std::slice::from_ref(target), 0.0, settings, limits).expect_err("refused")
}

#[test]
fn settings_out_of_range_are_refused() {
    let part = target(&TRUMPET, [0.0, 1.0], [0.0, 1.0]);
    for degree in [0, 2, 6] {
        let found = refused(&part, &Settings { degree, tolerance: None }, &Limits::default());
        assert_eq!(found.code, Code::SettingOutOfRange, "{found}");
    }
    for tolerance in [0.0, -1.0, f64::NAN, 1e-17] {
        let found = refused(&part, &Settings { degree: 3, tolerance: Some(tolerance) }, &Limits::default());
        assert_eq!(found.code, Code::SettingOutOfRange, "{found}");
        assert!(found.message.contains("below the rounding"), "{found}");
    }
    let empty = target(&TRUMPET, [1.0, 1.0], [0.0, 1.0]);
    assert_eq!(refused(&empty, &Settings::default(), &Limits::default()).code, Code::EmptyDomain);
}

#[test]
fn limits_stop_a_fit_and_are_named_with_what_was_reached() {
    let part = target(&TRUMPET, [0.0, 1.0], [0.0, TURN]);
    let settings = Settings { degree: 3, tolerance: Some(1e-12) };
    let found = refused(&part, &settings, &Limits { control_points: 1000, ..Limits::default() });
    assert_eq!(found.code, Code::LimitReached);
    assert!(found.message.contains("`control-points` of 1000; with fewer knots it deviates by"), "{found}");
    let found = refused(&part, &settings, &Limits { samples: 2000, ..Limits::default() });
    assert!(found.message.contains("`samples` of 2000"), "{found}");
}

#[test]
fn jump_is_not_fitted_and_says_so() {
    fn step(order: usize, x: f64) -> f64 {
        if order == 0 && x > 0.3 { 1.0 } else { 0.0 }
    }
    let cliff = Product([(sine, one), (one, sine), (step, one)]);
    let found = refused(
        &target(&cliff, [0.0, 1.0], [0.0, 1.0]),
        &Settings { degree: 3, tolerance: Some(1e-3) },
        &Limits::default(),
    );
    assert_eq!(found.code, Code::ToleranceNotReached, "{found}");
    assert!(found.message.contains("`part` deviates by"), "{found}");
}

/// A plane with a hill that is zero, with two derivatives, outside a rectangle.
struct Hill {
    u: [f64; 2],
    v: [f64; 2],
    /// Whether the surface tells where the rectangle is.
    is_announced: bool,
}

impl Surface for Hill {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        for ([u, v, _], value) in points.iter().zip(values) {
            let [x, y] = [(u, self.u), (v, self.v)].map(|(at, [low, high])| (at - low) / (high - low));
            let is_inside = (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y);
            let bell = |x: f64| 64.0 * (x * (1.0 - x)).powi(3);
            *value = match (derivative.u, derivative.v) {
                (0, 0) if is_inside => [*u, *v, 0.5 * bell(x) * bell(y)],
                (0, 0) => [*u, *v, 0.0],
                // Asked for at the ends of the ranges, where there is no hill.
                (1, 0) => [1.0, 0.0, 0.0],
                (0, 1) => [0.0, 1.0, 0.0],
                _ => [0.0; 3],
            };
        }
        Ok(())
    }

    fn breaks(&self, _: [[f64; 2]; 2], _: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        Ok(if self.is_announced { [self.u.to_vec(), self.v.to_vec()] } else { [Vec::new(), Vec::new()] })
    }
}

/// The largest distance inside a rectangle.
fn apart_within(surface: &dyn Surface, fitted: &BsplineSurface, rectangle: [[f64; 2]; 2], t: f64) -> f64 {
    let [u, v] = rectangle.map(|[a, b]| (0..=40).map(|i| a + (b - a) * f64::from(i) / 40.0).collect::<Vec<f64>>());
    let points = u.iter().flat_map(|u| v.iter().map(move |v| [*u, *v, t]));
    points.fold(0.0, |most, point| f64::max(most, distance(at(surface, "", point), at(fitted, "", point))))
}

#[test]
fn hill_between_all_first_knots_is_fitted() {
    // The first was between all nodes and Gauss points of 4 x 8 spans, others between those of v or of u alone.
    let hills = [
        ([0.0325, 0.0975], [0.064, 0.096]),
        ([0.0325, 0.0975], [0.02, 0.052]),
        ([0.4, 0.45], [0.4, 0.45]),
        ([0.4, 0.5], [0.4, 0.5]),
        ([0.35, 0.5], [0.4, 0.5]),
        ([0.61, 0.82], [0.13, 0.22]),
        // A thousand times narrower than what is looked at unannounced.
        ([0.7, 0.70001], [0.2, 0.20001]),
    ];
    for (u, v) in hills {
        for is_announced in [true, false] {
            // Ten points of a look are as close as that.
            if !is_announced && f64::min(u[1] - u[0], v[1] - v[0]) < 0.08 {
                continue;
            }
            for tolerance in [1e-1, 1e-3] {
                let hill = Hill { u, v, is_announced };
                let fit = fitted(&target(&hill, [0.0, 1.0], [0.0, 1.0]), 3, tolerance);
                let apart = apart_within(&hill, &fit.surface, [u, v], 0.0);
                assert!(apart <= 1.1 * tolerance, "{u:?} {v:?} {is_announced} {tolerance:e}: {apart:.1e}");
                assert!(apart <= 1.2 * fit.deviation, "{u:?} {v:?}: {apart:.2e} above {:.2e}", fit.deviation);
            }
        }
    }
}

#[test]
fn borders_of_deformed_regions_and_knots_of_curves_are_places_a_fit_knows() {
    let region = "deform u in [0.31, 0.36], v in [5.03, 5.45]";
    let text = example("deformed").replace("deform u in [0.4, 0.5], v in [5.03, 5.65]", region);
    assert!(text.contains(region));
    let blend = Blend::compile(&Source::new("deformed", text), &Options::default()).expect("an example");
    let solution = blend.solve(0, 0.0).expect("solved");
    let found = solution.surface.breaks([[0.0, 1.0], [0.0, TURN]], 0.0).expect("known");
    assert_eq!(found, [[0.31, 0.36], [5.03, 5.45]]);
    let fit = fitted(&target(&*solution.surface, [0.0, 1.0], [0.0, TURN]), 3, 1e-4);
    let apart = apart_within(&*solution.surface, &fit.surface, [[0.31, 0.36], [5.03, 5.45]], 0.0);
    assert!(apart <= 1.1e-4, "{apart:.1e}");

    let corner = "pde ∂⁴S/∂u⁴ = 0\ndomain v in [0, 1]\nat u = 0: S = [0, v, abs(v - 0.3)], ∂S/∂u = [1, 0, 0]\n\
                  at u = 1: S = [1, v, 0], ∂S/∂u = [1, 0, 0]";
    let solution = Prepared::new(corner, &[]).solve(0.0);
    assert_eq!(solution.surface.breaks([[0.0, 1.0]; 2], 0.0).expect("known"), [vec![], vec![0.3]]);

    let spline = surface(7, [3, 3], [6, 9]);
    let found = spline.breaks(spline.domain(), 0.0).expect("known");
    let inner = spline.knots().map(|knots| knots.breakpoints()[1..knots.breakpoints().len() - 1].to_vec());
    assert_eq!(found, inner);
}

#[test]
fn corner_along_a_line_is_reached_by_knots_that_crowd_at_it() {
    fn ridge(order: usize, x: f64) -> f64 {
        match order {
            0 => (x - 0.3).abs(),
            1 => (x - 0.3).signum(),
            _ => 0.0,
        }
    }
    fn line(order: usize, x: f64) -> f64 {
        [x, 1.0, 0.0, 0.0][order]
    }
    let roof = Product([(line, one), (one, line), (ridge, one)]);
    let fit = fitted(&target(&roof, [0.0, 1.0], [0.0, 1.0]), 3, 1e-6);
    assert!(apart_within(&roof, &fit.surface, [[0.2999, 0.3001], [0.0, 1.0]], 0.0) <= 1.1e-6);
    assert!(fit.surface.knots()[0].points() < 200);
}

#[test]
fn point_and_far_away_patch_are_fitted_too() {
    let point = Product([(one, one); 3]);
    let fit =
        fit(&[target(&point, [0.0, 1.0], [0.0, 1.0])], 0.0, &Settings::default(), &Limits::default()).expect("a point");
    assert!(fit[0].deviation <= 1e-15 * 4.0);
    fn far(order: usize, x: f64) -> f64 {
        if order == 0 { 1e6 + x.sin() } else { sine(order, x) }
    }
    let patch = Product([(far, one), (one, sine), (sine, cosine)]);
    let far = fitted(&target(&patch, [0.0, 1.0], [0.0, 1.0]), 3, 1e-6);
    assert!(far.deviation <= 1e-6 && !far.is_closed_in_v);
}
