//! Surfaces `S(u, v, t) = Σ_j F_j(v, t) Σ_m φ_m(u) C_mj(t)`, the form of every solution over a finite basis.

use std::sync::Arc;

use super::validity::{check_instant, unknown_in_time};
use super::{Basis, GridShape, Surface, SurfaceOnGrid, scattered};
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::kernels::grid::Combination;
use crate::trial::Modes;

/// Vector coefficients, mode after mode: that of mode m and basis function j is at `m * basis.len() + j`.
pub type Coefficients = Vec<[f64; 3]>;

/// A surface over modes φ_m(u) and a basis F_j(v, t).
#[derive(Clone)]
pub struct SeparableSurface {
    /// The modes φ_m; usually cardinal functions, then corrected trial functions.
    pub modes: Arc<dyn Modes>,
    /// The basis F_j.
    pub basis: Arc<Basis>,
    /// Values of the parameters.
    pub params: Vec<f64>,
    /// The coefficients C, then their derivatives in time, as far as they are known; all further ones are zero
    /// if the coefficients hold for every t.
    pub coefficients: Arc<Vec<Coefficients>>,
    /// The only instant at which the coefficients hold; `None` if they hold for every t.
    pub instant: Option<f64>,
}

impl SeparableSurface {
    /// The derivative of order `order` in u of every G_j, so that `S = Σ_j G_j(u) F_j(v, t)`.
    #[must_use]
    pub fn amplitudes(&self, order: usize, u: f64) -> Vec<[f64; 3]> {
        let modes = self.modes.derivatives(order, u);
        let mut amplitudes = vec![[0.0; 3]; self.basis.len()];
        let rows = self.coefficients.iter().take(1).flat_map(|first| first.chunks(self.basis.len().max(1)));
        for (mode, row) in modes.iter().zip(rows) {
            for (amplitude, coefficient) in amplitudes.iter_mut().zip(row) {
                for (sum, component) in amplitude.iter_mut().zip(coefficient) {
                    *sum += mode * component;
                }
            }
        }
        amplitudes
    }

    /// What a derivative of order `order` in t consists of.
    ///
    /// # Errors
    /// When the coefficients' derivatives are not known.
    pub(super) fn contraction(&self, order: usize) -> Result<Contraction, Diagnostic> {
        let (mut orders, mut terms, count) = (Vec::new(), Vec::new(), self.basis.len());
        let mut binomial = 1.0;
        for s in 0..=order {
            match self.coefficients.get(s) {
                Some(coefficients) => {
                    for (index, coefficient) in coefficients.iter().enumerate() {
                        let (mode, function) = (index / count.max(1), orders.len() * count + index % count.max(1));
                        let scaled = coefficient.iter().map(|component| binomial * component);
                        terms.extend(scaled.enumerate().map(|(component, value)| (mode, component, function, value)));
                    }
                    orders.push(order - s);
                }
                None if self.instant.is_none() => {}
                None => return Err(unknown_in_time(order)),
            }
            binomial = binomial * (order - s) as f64 / (s + 1) as f64;
        }
        Ok(Contraction::new(orders, (self.modes.count(), count), terms))
    }
}

/// One derivative in t as a sum of products of modes and basis functions.
///
/// Either `Σ_m φ_m(u) H_m(v, t)` with `H_m = Σ_j C_mj F_j`, or `Σ_j G_j(u) F_j(v, t)` with `G_j = Σ_m C_mj φ_m`, whichever
/// is the shorter sum. Points and grids choose alike, and so get the same bits.
pub(super) struct Contraction {
    /// For each derivative of the coefficients in time the order in t that is left for the basis; functions count on
    /// from one to the next.
    pub orders: Vec<usize>,
    /// Whether the outer sum is that over the modes.
    pub over_modes: bool,
    /// The coefficients, with a row for each term of the outer sum.
    pub combination: Combination,
}

impl Contraction {
    /// From terms of mode, component, function and coefficient, in ascending order of modes for each function.
    fn new(orders: Vec<usize>, (modes, functions): (usize, usize), mut terms: Vec<(usize, usize, usize, f64)>) -> Self {
        terms.retain(|(.., coefficient)| *coefficient != 0.0);
        let functions = functions * orders.len();
        let by_function: Vec<_> =
            terms.iter().map(|(mode, component, function, value)| (*function, *component, *mode, *value)).collect();
        let over_functions = Combination::new(functions, &by_function);
        // A component of a vector that is zero for every u is no term of the sum.
        let products: usize = (0..3).map(|component| over_functions.rows_of(component).count()).sum();
        let over_modes = 3 * modes < products;
        let combination = if over_modes { Combination::new(modes, &terms) } else { over_functions };
        Contraction { orders, over_modes, combination }
    }
}

impl Surface for SeparableSurface {
    fn as_separable(&self) -> Option<&SeparableSurface> {
        Some(self)
    }

    fn breaks(&self, [_, range_v]: [[f64; 2]; 2], t: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        Ok([Vec::new(), self.basis.breaks(&self.params, range_v, t)?])
    }

    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        self.evaluate_all(&[derivative], points, &mut [values])
    }

    fn evaluate_all(
        &self,
        derivatives: &[Derivative],
        points: &[[f64; 3]],
        values: &mut [&mut [[f64; 3]]],
    ) -> Result<(), Diagnostic> {
        points.iter().try_for_each(|[_, _, t]| check_instant(self.instant, *t))?;
        scattered::evaluate(self, derivatives, points, values)
    }

    fn evaluate_grid(
        &self,
        derivative: Derivative,
        (u, v, t): (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        SurfaceOnGrid::new(u, v).evaluate(self, derivative, t, values)
    }

    fn shape(&self, (u, v, t): (&[f64], &[f64], f64)) -> Result<GridShape, Diagnostic> {
        SurfaceOnGrid::new(u, v).shape(self, t)
    }
}
