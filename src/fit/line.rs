//! Spline interpolation along one parameter: from data at nodes to control points.

use crate::numeric::{Banded, CyclicBanded, NodeKind, nodes};
use crate::surface::KnotVector;

/// A spline space over given breakpoints with the functionals that determine its elements.
pub(super) struct Line {
    knots: KnotVector,
    /// Places and orders of the derivatives that are interpolated.
    functionals: Vec<(f64, usize)>,
    system: System,
}

enum System {
    /// Clamped; the equations of the first and last control points are triangular, the others banded.
    Open { start: Vec<Vec<f64>>, end: Vec<Vec<f64>>, inner: Vec<(usize, Vec<f64>)>, banded: Banded },
    /// Control points repeat after `spans` of them.
    Periodic { spans: usize, banded: CyclicBanded },
}

impl Line {
    /// Splines of degree `degree` over ascending `breakpoints`; `None` when rounding leaves no solution.
    ///
    /// Odd degrees interpolate at breakpoints, even ones in the middle of spans and at the ends; open ones at the ends also
    /// the derivatives up to order [`end_orders`].
    pub fn new(degree: usize, breakpoints: &[f64], is_periodic: bool) -> Option<Line> {
        if is_periodic { Line::periodic(degree, breakpoints) } else { Line::open(degree, breakpoints) }
    }

    fn open(degree: usize, breakpoints: &[f64]) -> Option<Line> {
        let knots = KnotVector::clamped(degree, breakpoints).ok()?;
        let [low, high] = knots.domain();
        let known = end_orders(degree) + 1;
        let count = knots.points();
        let inside = inner_nodes(degree, breakpoints);
        // At an end, the derivative of order r involves the r + 1 outermost control points.
        let triangle = |x: f64, is_start: bool| -> Vec<Vec<f64>> {
            let row = |order: usize| {
                (0..=order)
                    .map(|point| value(&knots, order, x, if is_start { point } else { count - 1 - point }))
                    .collect()
            };
            (0..known).map(row).collect()
        };
        let (start, end) = (triangle(low, true), triangle(high, false));
        let width = degree / 2;
        let mut inner = Vec::with_capacity(inside.len());
        let mut band = Vec::with_capacity(inside.len());
        for (index, &x) in inside.iter().enumerate() {
            // The diagonal's control point is that of the middle function at the node.
            let first = (index + known).checked_sub(width)?;
            let row: Vec<f64> = (first..=index + known + width).map(|point| value(&knots, 0, x, point)).collect();
            band.push(row.clone());
            inner.push((first, row));
        }
        let banded = Banded::new(width, &band)?;
        let ends = |x: f64| (0..known).map(move |order| (x, order));
        let functionals = ends(low).chain(inside.iter().map(|x| (*x, 0))).chain(ends(high)).collect();
        Some(Line { knots, functionals, system: System::Open { start, end, inner, banded } })
    }

    fn periodic(degree: usize, breakpoints: &[f64]) -> Option<Line> {
        let spans = breakpoints.len().checked_sub(1)?;
        let (low, high) = (breakpoints.first()?, breakpoints.last()?);
        let period = high - low;
        let before = breakpoints.iter().skip(spans.checked_sub(degree)?).take(degree).map(|x| x - period);
        let behind = breakpoints.iter().skip(1).take(degree).map(|x| x + period);
        let knots = KnotVector::new(degree, before.chain(breakpoints.iter().copied()).chain(behind).collect()).ok()?;
        let nodes: Vec<f64> = if degree % 2 == 1 {
            breakpoints.iter().copied().take(spans).collect()
        } else {
            inner_nodes(degree, breakpoints)
        };
        let width = degree / 2;
        // Unknown i is control point i + width, so that the middle function at node i is on the diagonal.
        let row =
            |(index, x): (usize, &f64)| (index..=index + 2 * width).map(|point| value(&knots, 0, *x, point)).collect();
        let rows: Vec<Vec<f64>> = nodes.iter().enumerate().map(row).collect();
        let banded = CyclicBanded::new(width, &rows)?;
        let functionals = nodes.into_iter().map(|x| (x, 0)).collect();
        Some(Line { knots, functionals, system: System::Periodic { spans, banded } })
    }

    pub fn knots(&self) -> &KnotVector {
        &self.knots
    }

    /// Places and orders of the derivatives that [`Line::control_points`] takes, in its order.
    pub fn functionals(&self) -> &[(f64, usize)] {
        &self.functionals
    }

    /// The control points of the spline with these data; `None` when they are not finite.
    pub fn control_points(&self, data: &[[f64; 3]]) -> Option<Vec<[f64; 3]>> {
        match &self.system {
            System::Periodic { spans, banded } => {
                let solution = banded.solve(data)?;
                let width = self.knots.degree() / 2;
                let shifted =
                    (0..self.knots.points()).map(|point| solution.get((point + spans - width) % spans).copied());
                shifted.collect()
            }
            System::Open { start, end, inner, banded } => {
                let known = start.len();
                let (from_start, rest) = data.split_at_checked(known)?;
                let (inside, from_end) = rest.split_at_checked(rest.len().checked_sub(known)?)?;
                let first = outermost(start, from_start)?;
                let last = outermost(end, from_end)?;
                let count = self.knots.points();
                // What the known control points add to the inner equations goes to their right-hand sides.
                let known_point =
                    |point: usize| first.get(point).or_else(|| last.get(count.checked_sub(point + 1)?)).copied();
                let mut right = inside.to_vec();
                for (value, (begin, row)) in right.iter_mut().zip(inner) {
                    for (offset, factor) in row.iter().enumerate() {
                        if let Some(point) = known_point(begin + offset) {
                            subtract(value, *factor, &point);
                        }
                    }
                }
                let middle = banded.solve(&right);
                Some(first.into_iter().chain(middle).chain(last.into_iter().rev()).collect())
            }
        }
    }
}

/// The highest derivative that open splines of degree `degree` interpolate at their ends.
pub(super) fn end_orders(degree: usize) -> usize {
    (degree - 1) / 2
}

fn inner_nodes(degree: usize, breakpoints: &[f64]) -> Vec<f64> {
    if degree % 2 == 1 {
        let inner = breakpoints.len().saturating_sub(2);
        return breakpoints.iter().skip(1).take(inner).copied().collect();
    }
    let middle = |span: &[f64]| match span {
        [a, b] => nodes(NodeKind::Midpoints, 1, [*a, *b]),
        _ => Vec::new(),
    };
    breakpoints.windows(2).flat_map(middle).collect()
}

/// The derivative of order `order` of basis function number `point` at `x`.
fn value(knots: &KnotVector, order: usize, x: f64, point: usize) -> f64 {
    knots.basis_function(point, order, x)
}

/// The outermost control points from the derivatives of order 0, 1, … at an end.
fn outermost(triangle: &[Vec<f64>], derivatives: &[[f64; 3]]) -> Option<Vec<[f64; 3]>> {
    let mut points: Vec<[f64; 3]> = Vec::with_capacity(triangle.len());
    for (row, derivative) in triangle.iter().zip(derivatives) {
        let (own, others) = row.split_last()?;
        let mut value = *derivative;
        for (factor, point) in others.iter().zip(&points) {
            subtract(&mut value, *factor, point);
        }
        points.push(value.map(|x| x / own));
    }
    Some(points)
}

fn subtract(value: &mut [f64; 3], factor: f64, point: &[f64; 3]) {
    for (x, y) in value.iter_mut().zip(point) {
        *x -= factor * y;
    }
}
