//! Surfaces `S(u, v, t) = Σ_j F_j(v, t) Σ_m φ_m(u) C_mj(t)`, the form of every solution over a finite basis.

use std::sync::Arc;

use super::validity::{check_instant, finite, unknown_in_time};
use super::{Basis, Surface};
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::trial::Modes;

/// Vector coefficients, mode after mode: that of mode m and basis function j is at `m * basis.len() + j`.
pub type Coefficients = Vec<[f64; 3]>;

/// A surface over modes φ_m(u) and a basis F_j(v, t).
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
        self.coefficients.first().map_or_else(Vec::new, |coefficients| {
            self.combined(&self.modes.derivatives(order, u), &self.rows(coefficients))
        })
    }

    /// The coefficients' derivatives that a derivative of order `order` in t needs, with their binomial factors
    /// and the order that is left for the basis.
    fn time_terms(&self, order: usize) -> Result<Vec<(&Coefficients, f64, usize)>, Diagnostic> {
        let mut terms = Vec::new();
        let mut binomial = 1.0;
        for s in 0..=order {
            match self.coefficients.get(s) {
                Some(coefficients) => terms.push((coefficients, binomial, order - s)),
                None if self.instant.is_none() => {}
                None => return Err(unknown_in_time(order)),
            }
            binomial = binomial * (order - s) as f64 / (s + 1) as f64;
        }
        Ok(terms)
    }

    /// `G_j(u) = Σ_m φ_m(u) C_mj` for every j, from the values of the modes.
    fn combined(&self, modes: &[f64], rows: &Rows) -> Vec<[f64; 3]> {
        let mut sum = vec![[0.0; 3]; self.basis.len()];
        for (mode, row) in modes.iter().zip(rows) {
            for (j, coefficient) in row {
                if let Some(total) = sum.get_mut(*j) {
                    add_scaled(total, *mode, coefficient);
                }
            }
        }
        sum
    }

    /// The coefficients that are not zero: of N wave numbers, each with its own modes, one in N is not.
    fn rows(&self, coefficients: &Coefficients) -> Rows {
        let row = |row: &[[f64; 3]]| {
            row.iter().copied().enumerate().filter(|(_, coefficient)| *coefficient != [0.0; 3]).collect()
        };
        coefficients.chunks(self.basis.len().max(1)).map(row).collect()
    }
}

/// For each mode, basis functions and their coefficients.
type Rows = Vec<Vec<(usize, [f64; 3])>>;

impl Surface for SeparableSurface {
    fn as_separable(&self) -> Option<&SeparableSurface> {
        Some(self)
    }

    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        points.iter().try_for_each(|[_, _, t]| check_instant(self.instant, *t))?;
        let v: Vec<f64> = points.iter().map(|[_, v, _]| *v).collect();
        let t: Vec<f64> = points.iter().map(|[_, _, t]| *t).collect();
        values.fill([0.0; 3]);
        for (coefficients, factor, order) in self.time_terms(derivative.t)? {
            let basis = self.basis.values(Derivative { t: order, ..derivative }, &self.params, &v, &t)?;
            let rows = self.rows(coefficients);
            for (index, ([u, ..], value)) in points.iter().zip(values.iter_mut()).enumerate() {
                let amplitudes = self.combined(&self.modes.derivatives(derivative.u, *u), &rows);
                for (amplitude, row) in amplitudes.iter().zip(basis.chunks(points.len().max(1))) {
                    add_scaled(value, factor * row.get(index).copied().unwrap_or(f64::NAN), amplitude);
                }
            }
        }
        finite(values)
    }

    fn evaluate_grid(
        &self,
        derivative: Derivative,
        (u, v, t): (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        check_instant(self.instant, t)?;
        let t = vec![t; v.len()];
        values.fill([0.0; 3]);
        for (coefficients, factor, order) in self.time_terms(derivative.t)? {
            let basis = self.basis.values(Derivative { t: order, ..derivative }, &self.params, v, &t)?;
            let rows = self.rows(coefficients);
            for (u, row) in u.iter().zip(values.chunks_mut(v.len().max(1))) {
                let amplitudes = self.combined(&self.modes.derivatives(derivative.u, *u), &rows);
                for (amplitude, function) in amplitudes.iter().zip(basis.chunks(v.len().max(1))) {
                    for (value, basis) in row.iter_mut().zip(function) {
                        add_scaled(value, factor * basis, amplitude);
                    }
                }
            }
        }
        finite(values)
    }
}

fn add_scaled(total: &mut [f64; 3], factor: f64, vector: &[f64; 3]) {
    for (sum, component) in total.iter_mut().zip(vector) {
        *sum += factor * component;
    }
}
