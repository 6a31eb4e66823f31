//! Surfaces: anything with a position and partial derivatives over (u, v, t).
//!
//! Judges ([`verify`](crate::verify)) and tessellators see only [`Surface`], never how one was made.

mod apex;
mod basis;
mod breaks;
pub mod bspline;
mod coons;
mod deformed;
mod functions;
mod gregory;
mod on_grid;
mod placed;
mod scattered;
mod separable;
mod sides;
mod symbolic;
mod tabulated;
mod validity;

pub use apex::Apex;
pub use basis::Basis;
pub use bspline::{BsplineCurve, BsplineSurface, KnotVector, MovingBspline};
pub use coons::{CoonsSurface, Corrections};
pub use deformed::{Bump, DeformedSurface, Region};
pub use functions::Functions;
pub use on_grid::{GridShape, SurfaceOnGrid, UnitNormals};
pub use placed::{CompiledPlacement, PlacedSurface, is_lost};
pub use separable::{Coefficients, SeparableSurface};
pub use sides::{Corner, Sides};
pub use symbolic::SymbolicSurface;
pub use tabulated::TabulatedModes;

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

    /// Ranges of u and v of the parts of the domain in which something was added to the surface: across their borders
    /// it is less smooth than elsewhere. None for most surfaces.
    fn regions(&self) -> Vec<[[f64; 2]; 2]> {
        Vec::new()
    }

    /// The values of u, and of v, inside `domain` at which the surface is known to be put together of pieces at instant
    /// `t`, in no order: borders of deformed regions, knots, corners of data. Between them a part of the surface may be
    /// hidden from a look at the others.
    ///
    /// # Errors
    /// When it cannot be evaluated.
    fn breaks(&self, _domain: [[f64; 2]; 2], _t: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        Ok([Vec::new(), Vec::new()])
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

    /// Several partial derivatives at every point: `values[d]` for `derivatives[d]`, each as [`Surface::evaluate`]
    /// writes it. What they have in common is computed once.
    ///
    /// # Errors
    /// As [`Surface::evaluate`].
    fn evaluate_all(
        &self,
        derivatives: &[Derivative],
        points: &[[f64; 3]],
        values: &mut [&mut [[f64; 3]]],
    ) -> Result<(), Diagnostic> {
        derivatives.iter().zip(values).try_for_each(|(derivative, values)| self.evaluate(*derivative, points, values))
    }

    /// Positions and tangents on the grid of all `u` and `v` at instant `t`, u-major, and where it costs little the unit
    /// normals.
    ///
    /// # Errors
    /// As [`Surface::evaluate`].
    fn shape(&self, axes: (&[f64], &[f64], f64)) -> Result<GridShape, Diagnostic> {
        let field = |derivative| {
            let mut values = vec![[0.0; 3]; axes.0.len() * axes.1.len()];
            self.evaluate_grid(derivative, axes, &mut values).map(|()| values)
        };
        let (positions, tangents_u) = (field(Derivative::NONE)?, field(Derivative::new(1, 0, 0))?);
        Ok(GridShape { positions, tangents_u, tangents_v: field(Derivative::new(0, 1, 0))?, normals: None })
    }
}
