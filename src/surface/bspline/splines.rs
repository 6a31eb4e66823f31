//! B-spline surfaces as functions that expressions can call.

use std::sync::Arc;

use super::{BsplineSurface, KnotVector};
use crate::expr::{Knots, Spline, SplineCall};

impl BsplineSurface {
    /// x, y and z as functions `NAME_x`, `NAME_y`, `NAME_z` of two arguments.
    ///
    /// `seams` says for u and for v how many derivatives across agree at both ends, as
    /// [`BsplineSurface::closed_in_u`] finds them: there the functions are periodic, and have these derivatives. In other
    /// directions they have no values beyond the knots. `None` if coefficients overflow.
    #[must_use]
    pub fn splines(&self, name: &str, arguments: [&str; 2], seams: [Option<usize>; 2]) -> Option<[SplineCall; 3]> {
        let knots = |knots: &KnotVector, seam: Option<usize>| Knots {
            degree: knots.degree(),
            knots: knots.as_slice().to_vec(),
            seam,
        };
        let [first, second] = arguments;
        let axes = [(first, knots(&self.u, seams[0])), (second, knots(&self.v, seams[1]))];
        let coordinate = |axis: usize, suffix: &str| {
            let controls: Vec<f64> = self.net.iter().filter_map(|point| point.get(axis)).copied().collect();
            let spline = Spline::new(&format!("{name}_{suffix}"), &axes, &controls)?;
            Some(SplineCall::new(Arc::new(spline)))
        };
        Some([coordinate(0, "x")?, coordinate(1, "y")?, coordinate(2, "z")?])
    }
}
