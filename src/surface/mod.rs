//! Surfaces: anything with a position and partial derivatives over (u, v, t).
//!
//! Judges ([`verify`](crate::verify)) and tessellators see only [`Surface`], never how one was made.

mod basis;
pub mod bspline;
mod coons;
mod deformed;
mod functions;
mod gregory;
mod separable;
mod sides;
mod symbolic;
mod validity;

pub use basis::Basis;
pub use bspline::{BsplineCurve, BsplineSurface, KnotVector, MovingBspline};
pub use coons::CoonsSurface;
pub use deformed::{Bump, DeformedSurface, Region};
pub use functions::Functions;
pub use separable::{Coefficients, SeparableSurface};
pub use sides::{Corner, Sides};
pub use symbolic::SymbolicSurface;

use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;

/// A surface `S(u, v, t)` in space that can be differentiated.
pub trait Surface {
    /// Writes a partial derivative of S at every point; [`Derivative::NONE`] is the position.
    ///
    /// `points` are `(u, v, t)` in the patch's own parameters; `values` has the same length, x, y, z each.
    ///
    /// # Errors
    /// A diagnostic when a value is not finite (naming the function and the point), when a needed derivative
    /// does not exist, or when the surface is not defined at a point's `t`. `values` is then unspecified.
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic>;

    /// The surface as a sum of products over a finite basis, if it is one.
    fn as_separable(&self) -> Option<&SeparableSurface> {
        None
    }

    /// Writes a partial derivative of S at instant `t` on the grid of all `u` and `v`, u-major:
    /// `values[i * v.len() + j]` belongs to `(u[i], v[j], t)`.
    ///
    /// # Errors
    /// As [`Surface::evaluate`].
    fn evaluate_grid(
        &self,
        derivative: Derivative,
        (u, v, t): (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        let points: Vec<[f64; 3]> = u.iter().flat_map(|&u| v.iter().map(move |&v| [u, v, t])).collect();
        self.evaluate(derivative, &points, values)
    }
}
