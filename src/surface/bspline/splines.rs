//! B-spline surfaces as functions that expressions can call.

use std::sync::Arc;

use super::{BsplineSurface, KnotVector};
use crate::expr::{Knots, Spline, SplineCall};

/// Of the largest coordinate: edges farther apart are two, not one with rounding errors.
const ONE_EDGE: f64 = 1e-12;

/// Of the largest derivative of its order: what files with 10 digits and more leave between equal ones.
const ONE_SLOPE: f64 = 1e-9;

impl BsplineSurface {
    /// x, y and z as functions `NAME_x`, `NAME_y`, `NAME_z` of two arguments.
    ///
    /// In a direction whose two edges are one curve they are periodic, and have the derivatives across it that agree
    /// there; in the other ones they have no values beyond the knots. `None` if coefficients overflow.
    #[must_use]
    pub fn splines(&self, name: &str, arguments: [&str; 2]) -> Option<[SplineCall; 3]> {
        let knots = |knots: &KnotVector, seam: Option<usize>| Knots {
            degree: knots.degree(),
            knots: knots.as_slice().to_vec(),
            seam,
        };
        let [first, second] = arguments;
        let axes = [(first, knots(&self.u, self.seam())), (second, knots(&self.v, self.transposed().seam()))];
        let coordinate = |axis: usize, suffix: &str| {
            let controls: Vec<f64> = self.net.iter().filter_map(|point| point.get(axis)).copied().collect();
            let spline = Spline::new(&format!("{name}_{suffix}"), &axes, &controls)?;
            Some(SplineCall::new(Arc::new(spline)))
        };
        Some([coordinate(0, "x")?, coordinate(1, "y")?, coordinate(2, "z")?])
    }

    /// The highest derivative in u that agrees at both ends of u; `None` if positions do not.
    fn seam(&self) -> Option<usize> {
        let [start, end] = self.u.domain();
        let agrees = |order: &usize| {
            let [before, behind] = [start, end].map(|u| self.row_at(*order, u));
            let pairs = || before.iter().flatten().zip(behind.iter().flatten());
            let size = pairs().fold(0.0_f64, |most, (a, b)| most.max(a.abs()).max(b.abs()));
            let gap = pairs().fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            gap <= size * if *order == 0 { ONE_EDGE } else { ONE_SLOPE }
        };
        (0..self.u.degree()).take_while(agrees).last()
    }
}
