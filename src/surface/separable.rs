//! Surfaces `S(u, v, t) = Σ_j F_j(v, t) Σ_m φ_m(u) C_mj(t)`, the form of every solution over a finite basis.

use std::sync::Arc;

use super::validity::{check_instant, unknown_in_time};
use super::{Basis, GridShape, Surface, SurfaceOnGrid, scattered};
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
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
    pub coefficients: Vec<Coefficients>,
    /// The only instant at which the coefficients hold; `None` if they hold for every t.
    pub instant: Option<f64>,
}

impl SeparableSurface {
    /// The derivative of order `order` in u of every G_j, so that `S = Σ_j G_j(u) F_j(v, t)`.
    #[must_use]
    pub fn amplitudes(&self, order: usize, u: f64) -> Vec<[f64; 3]> {
        let mut amplitudes = vec![[0.0; 3]; self.basis.len()];
        if let Some(coefficients) = self.coefficients.first() {
            let term = Term::new(coefficients, 1.0, 0, self.basis.len());
            term.add_amplitudes(&self.modes.derivatives(order, u), &mut amplitudes);
        }
        amplitudes
    }

    /// The coefficients that are not zero, of what a derivative of order `order` in t consists of: for each derivative
    /// of the coefficients in time, with its binomial factor, the order that is left for the basis.
    ///
    /// # Errors
    /// When the coefficients' derivatives are not known.
    pub(super) fn terms(&self, order: usize) -> Result<Vec<Term>, Diagnostic> {
        let mut terms = Vec::new();
        let mut binomial = 1.0;
        for s in 0..=order {
            match self.coefficients.get(s) {
                Some(coefficients) => terms.push(Term::new(coefficients, binomial, order - s, self.basis.len())),
                None if self.instant.is_none() => {}
                None => return Err(unknown_in_time(order)),
            }
            binomial = binomial * (order - s) as f64 / (s + 1) as f64;
        }
        Ok(terms)
    }

    /// Whether there are fewer modes than basis functions, so that `Σ_m φ_m(u) H_m(v, t)` is shorter than
    /// `Σ_j G_j(u) F_j(v, t)`.
    ///
    /// Points and grids choose alike, and so get the same bits.
    pub(super) fn sums_over_modes(&self, terms: &[Term]) -> bool {
        self.modes.count() < self.basis.len() * terms.len()
    }
}

/// What one derivative of the coefficients in time contributes.
pub(super) struct Term {
    /// The order in t that is left for the basis.
    pub order: usize,
    /// For each mode, basis functions and their coefficients: of N wave numbers, each with its own modes, one in N is
    /// not zero.
    pub rows: Vec<Vec<(usize, [f64; 3])>>,
}

impl Term {
    fn new(coefficients: &Coefficients, factor: f64, order: usize, basis: usize) -> Term {
        let row = |row: &[[f64; 3]]| {
            let scaled = row.iter().map(|coefficient| coefficient.map(|x| factor * x)).enumerate();
            scaled.filter(|(_, coefficient)| *coefficient != [0.0; 3]).collect()
        };
        Term { order, rows: coefficients.chunks(basis.max(1)).map(row).collect() }
    }

    /// `G_j(u) = Σ_m φ_m(u) C_mj` for every j, from the values of the modes: added to zeros.
    pub(super) fn add_amplitudes(&self, modes: &[f64], amplitudes: &mut [[f64; 3]]) {
        for (mode, row) in modes.iter().zip(&self.rows) {
            for (j, coefficient) in row {
                if let Some(sum) = amplitudes.get_mut(*j) {
                    add_scaled(sum, *mode, coefficient);
                }
            }
        }
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

/// `total + factor * vector`, each rounded once, as the kernels do.
#[inline(always)]
fn add_scaled(total: &mut [f64; 3], factor: f64, vector: &[f64; 3]) {
    for (sum, component) in total.iter_mut().zip(vector) {
        *sum = factor.mul_add(*component, *sum);
    }
}
