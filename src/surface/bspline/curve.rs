//! B-spline curves, from which boundary layers and edges are made.

use super::insertion::{insert_until, restrict};
use super::knots::KnotVector;
use super::{add_scaled, is_finite, point_not_finite};
use crate::diagnostic::{Code, Diagnostic};

/// A B-spline curve `C(x) = Σ_i N_i(x) P_i`.
#[derive(Debug, Clone, PartialEq)]
pub struct BsplineCurve {
    knots: KnotVector,
    /// Finite.
    points: Vec<[f64; 3]>,
}

impl BsplineCurve {
    /// The curve over `knots` with the control points `points`.
    ///
    /// # Errors
    /// [`Code::NetSize`] unless there are `knots.points()`; [`Code::PointNotFinite`].
    pub fn new(knots: KnotVector, points: Vec<[f64; 3]>) -> Result<BsplineCurve, Diagnostic> {
        if points.len() != knots.points() {
            let message =
                format!("the knots belong to a curve of {} points, and {} are given", knots.points(), points.len());
            return Err(Diagnostic::new(Code::NetSize, message).hint("there are degree + 1 knots more than points"));
        }
        match points.iter().position(|point| !is_finite(point)) {
            Some(at) => Err(point_not_finite(&format!("P({at})"), points.get(at))),
            None => Ok(BsplineCurve { knots, points }),
        }
    }

    /// The knots.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        &self.knots
    }

    /// The control points.
    #[must_use]
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// The derivative of order `order` at `x`; outside the domain the nearest span's polynomial continues.
    #[must_use]
    pub fn derivative(&self, order: usize, x: f64) -> [f64; 3] {
        let (first, values) = self.knots.basis(order, x);
        let mut sum = [0.0; 3];
        for (value, point) in values.iter().zip(self.points.iter().skip(first).take(self.knots.degree() + 1)) {
            add_scaled(&mut sum, *value, point);
        }
        sum
    }

    /// The same curve run through backwards: x of one is -x of the other.
    #[must_use]
    pub fn reversed(&self) -> BsplineCurve {
        BsplineCurve { knots: self.knots.reversed(), points: self.points.iter().rev().copied().collect() }
    }

    /// The curve before `x` and the one behind, clamped and with the point at `x` in common.
    ///
    /// # Errors
    /// [`Code::PointOutsideDomain`] unless `x` lies inside the domain.
    pub fn split(&self, x: f64) -> Result<[BsplineCurve; 2], Diagnostic> {
        let [start, end] = self.knots.domain();
        if !(start < x && x < end) {
            let message = format!("a curve on [{start}, {end}] cannot be split at {x}");
            return Err(Diagnostic::new(Code::PointOutsideDomain, message).hint("choose a place inside"));
        }
        // First for both, so that they have the same point in common bit for bit.
        let degree = self.knots.degree();
        let (knots, points) = insert_until(self.knots.clone(), self.points.clone(), 1, (x, degree));
        Ok([[start, x], [x, end]].map(|part| {
            let (knots, points) = restrict(&knots, &points, 1, part);
            BsplineCurve { knots, points }
        }))
    }
}
