//! The closed quintic spline through points, run through at constant speed.
//!
//! Points become a periodic spline of degree 5 with a knot at each (docs/methods.md, P1), which has four continuous
//! derivatives. Its parameter begins as the length of the chords and is replaced by the length of the curve so found,
//! [`ROUNDS`] times (P2); chord lengths alone would bound the order of convergence by 4, whatever the degree (Floater and
//! Surazhsky 2006).

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::expr::{Knots, Spline, SplineCall};
use crate::numeric::{CyclicBanded, gauss_rule};

/// The degree of the pieces.
const DEGREE: usize = 5;

/// How often the parameter is replaced by the curve's length. Each round takes the error of the parameter to the order
/// of that of the curve before; two take chords to the order of a quintic, the third sees to the constant.
const ROUNDS: usize = 3;

/// Fewer points make no closed spline of degree 5 with a knot at each.
pub const LEAST_POINTS: usize = 6;

/// The coordinates of a closed curve as functions of a parameter in [0, 2π], in which it runs at constant speed.
#[derive(Debug, Clone)]
pub struct ClosedCurve {
    /// x, y and z.
    pub coordinates: [SplineCall; 3],
    /// Its length.
    pub length: f64,
    /// The parameter at each point.
    pub parameters: Vec<f64>,
}

impl ClosedCurve {
    /// The curve called `name` through `points` and back to the first, which is not repeated at the end.
    ///
    /// It passes through the points to rounding; between them, for a smooth closed curve, position and parameter are off
    /// by the sixth power of the distance of neighbours. `None` for fewer than [`LEAST_POINTS`] points, neighbours that
    /// are equal, or distances so different that the spline is not finite. Cost: linear.
    #[must_use]
    pub fn through(name: &str, points: &[[f64; 3]]) -> Option<ClosedCurve> {
        if points.len() < LEAST_POINTS {
            return None;
        }
        let next = points.iter().skip(1).chain(points.first());
        let chords = points.iter().zip(next).map(|(point, next)| distance(*point, *next));
        let mut parameters = scaled(chords)?;
        let mut length = f64::NAN;
        for _ in 0..ROUNDS {
            let coordinates = interpolate(name, &parameters, points)?;
            let lengths = arc_lengths(&coordinates, &parameters);
            length = lengths.iter().sum();
            parameters = scaled(lengths.into_iter())?;
        }
        let coordinates = interpolate(name, &parameters, points)?;
        parameters.pop();
        Some(ClosedCurve { coordinates, length, parameters })
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    libm::sqrt(a.iter().zip(b).map(|(a, b)| (b - a) * (b - a)).sum())
}

/// Steps summed up and scaled to end at 2π; `None` unless they ascend.
fn scaled(steps: impl Iterator<Item = f64>) -> Option<Vec<f64>> {
    let mut sums = vec![0.0];
    let mut sum = 0.0;
    for step in steps {
        sum += step;
        sums.push(sum);
    }
    let count = sums.len();
    let mut parameters: Vec<f64> = sums.into_iter().map(|part| TAU * (part / sum)).collect();
    *parameters.get_mut(count - 1)? = TAU;
    let is_ascending = parameters.windows(2).all(|pair| matches!(pair, [low, high] if low < high));
    is_ascending.then_some(parameters)
}

/// Periodic splines of degree 5 with knots at `parameters`, whose last is the period, through `points` (P1).
fn interpolate(name: &str, parameters: &[f64], points: &[[f64; 3]]) -> Option<[SplineCall; 3]> {
    let count = points.len();
    // Knot 0 of the period is number DEGREE of the list.
    let knots: Vec<f64> = (0..count + 2 * DEGREE + 1)
        .map(|index| {
            let around = index + (DEGREE / count + 1) * count - DEGREE;
            let turns = around / count;
            let turns = turns as f64 - (DEGREE / count + 1) as f64;
            parameters.get(around % count).map_or(f64::NAN, |parameter| parameter + TAU * turns)
        })
        .collect();
    // At a knot the five B-splines of the pieces around it do not vanish; the middle one belongs to the point.
    let rows: Vec<Vec<f64>> = (0..count).map(|index| values_at_knot(&knots, index + DEGREE)).collect();
    let controls = CyclicBanded::new(DEGREE / 2, &rows)?.solve(points)?;
    let coordinate = |axis: usize, suffix: &str| {
        let around = (0..count + DEGREE).map(|index| {
            // Control value k of the list belongs to point k - 2.
            let point = (index + (DEGREE / count + 1) * count - DEGREE / 2) % count;
            controls.get(point).and_then(|control| control.get(axis)).copied().unwrap_or(f64::NAN)
        });
        let knots = Knots { degree: DEGREE, knots: knots.clone(), seam: Some(DEGREE - 1) };
        let spline = Spline::new(&format!("{name}_{suffix}"), &[("v", knots)], &around.collect::<Vec<f64>>());
        spline.map(|spline| SplineCall::new(Arc::new(spline)))
    };
    Some([coordinate(0, "x")?, coordinate(1, "y")?, coordinate(2, "z")?])
}

/// The values at knot number `at` of the five B-splines of degree 5 that do not vanish there.
fn values_at_knot(knots: &[f64], at: usize) -> Vec<f64> {
    let knot = |index: usize| knots.get(index).copied().unwrap_or(f64::NAN);
    let x = knot(at);
    let mut values = vec![1.0];
    for degree in 1..=DEGREE {
        // B_i of this degree from those of one less, on the piece that begins at the knot.
        let mut raised = vec![0.0; degree + 1];
        for (index, value) in values.iter().enumerate() {
            let (low, high) = (knot(at + 1 + index - degree), knot(at + 1 + index));
            let share = value / (high - low);
            if let Some([left, right]) = raised.get_mut(index..index + 2) {
                *left += (high - x) * share;
                *right += (x - low) * share;
            }
        }
        values = raised;
    }
    // The last begins at the knot, where it is zero.
    values.truncate(DEGREE);
    values
}

/// The length of the curve between neighbours (P2).
fn arc_lengths(coordinates: &[SplineCall; 3], parameters: &[f64]) -> Vec<f64> {
    let slopes = coordinates.clone().map(|coordinate| coordinate.differentiated(0).unwrap_or(coordinate));
    let speed = |v: f64| distance([0.0; 3], slopes.each_ref().map(|slope| slope.value(v, 0.0)));
    let between = |pair: &[f64]| match pair {
        // The integrand is the root of a polynomial of degree 8.
        [low, high] => {
            let (nodes, weights) = gauss_rule(8, [*low, *high]);
            nodes.iter().zip(weights).map(|(node, weight)| weight * speed(*node)).sum()
        }
        _ => 0.0,
    };
    parameters.windows(2).map(between).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uneven steps that repeat themselves: neighbours differ by a factor of three.
    fn uneven(count: usize) -> Vec<f64> {
        (0..count).map(|index| TAU * index as f64 / count as f64).map(|v| v + 0.5 * libm::sin(v)).collect()
    }

    fn circle(count: usize) -> Vec<[f64; 3]> {
        uneven(count).into_iter().map(|v| [2.0 * libm::cos(v), 2.0 * libm::sin(v), 1.0]).collect()
    }

    /// The largest distance from the circle at the same parameter, for as many as ten times the points.
    fn error(curve: &ClosedCurve, count: usize) -> f64 {
        let off = |index: usize| {
            let v = TAU * index as f64 / (10 * count) as f64;
            let exact = [2.0 * libm::cos(v), 2.0 * libm::sin(v), 1.0];
            distance(curve.coordinates.each_ref().map(|coordinate| coordinate.value(v, 0.0)), exact)
        };
        (0..10 * count).map(off).fold(0.0, f64::max)
    }

    #[test]
    fn circle_with_uneven_points_is_met_at_sixth_order_in_position_and_parameter() {
        let errors: Vec<f64> = [16, 32, 64, 128]
            .into_iter()
            .map(|count| error(&ClosedCurve::through("C", &circle(count)).expect("a circle"), count))
            .collect();
        for pair in errors.windows(2) {
            let order = libm::log2(pair[0] / pair[1]);
            assert!(order > 5.5, "orders fall to {order}: {errors:?}");
        }
        assert!(errors[3] < 1e-9, "{errors:?}");
    }

    #[test]
    fn curve_passes_through_its_points_and_closes_with_four_derivatives() {
        let points = circle(12);
        let curve = ClosedCurve::through("C", &points).expect("a circle");
        for (point, v) in points.iter().zip(&curve.parameters) {
            let found = curve.coordinates.each_ref().map(|coordinate| coordinate.value(*v, 0.0));
            assert!(distance(found, *point) < 1e-14, "{found:?} {point:?}");
        }
        assert!((curve.length - 2.0 * TAU).abs() < 1e-3);
        let mut coordinate = curve.coordinates[0].clone();
        for order in 0..=4 {
            let gap = coordinate.value(0.0, 0.0) - coordinate.value(TAU - 1e-13, 0.0);
            // Rounding, times what each derivative costs on pieces of length 0.3.
            assert!(gap.abs() < 1e-9, "derivative {order} jumps by {gap}");
            match coordinate.differentiated(0) {
                Ok(next) => coordinate = next,
                Err(highest) => assert_eq!((highest, order), (4, 4)),
            }
        }
    }

    #[test]
    fn too_few_or_equal_points_make_no_curve() {
        assert!(ClosedCurve::through("C", &circle(6)).is_some());
        assert!(ClosedCurve::through("C", &circle(5)).is_none());
        let mut points = circle(8);
        points[3] = points[2];
        assert!(ClosedCurve::through("C", &points).is_none());
    }
}
