//! Surfaces from data on four sides: the bicubically blended Coons surface, and corrections that no side can see.
//!
//! `S = Σ_a H_a(u) X_a(v) + Σ_b H_b(v) Y_b(u) - Σ_ab H_a(u) H_b(v) C_ab + Σ_mn c_mn f_m(u) f_n(v)` (docs/methods.md,
//! H1). H are the cubic Hermite functions of each range, X and Y the data, C what the corners state, f functions with
//! double zeros at both ends. So position and tangent on every side are those stated, whatever the c_mn.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::gregory::turn;
use super::sides::CONDITIONS;
use super::validity::{check_instant, finite, unknown_in_time};
use super::{Basis, Coefficients, Corner, Sides, Surface};
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Derivative;
use crate::trial::Modes;

/// A surface with given position and tangent on four sides.
pub struct CoonsSurface {
    /// The data.
    pub sides: Arc<Sides>,
    /// The functions of u and of v: the four cubic Hermite ones, then those with double zeros at both ends.
    pub modes: [Arc<dyn Modes>; 2],
    /// Values of the parameters.
    pub params: Vec<f64>,
    /// Whether the twists of the sides disagree, by corner as in [`Sides::corners`].
    pub is_twisted: [bool; 4],
    /// The coefficients c_mn, n running faster, then their derivatives in time as far as they are known; all further
    /// ones are zero if the coefficients hold for every t.
    pub corrections: Vec<Coefficients>,
    /// The only instant at which the corrections hold; `None` if they hold for every t.
    pub instant: Option<f64>,
}

/// At one instant, for each component, the matrix between the functions of u and of v; and for each corner half the
/// difference of its twists.
struct Core {
    matrices: [DMatrix<f64>; 3],
    turns: Vec<(Corner, [f64; 3])>,
}

impl CoonsSurface {
    /// The corners' values and the corrections, differentiated `order` times in t.
    fn core(&self, t: f64, order: usize) -> Result<Core, Diagnostic> {
        let corrections = match self.corrections.get(order) {
            None if self.instant.is_some() => return Err(unknown_in_time(order)),
            corrections => corrections,
        };
        let [rows, columns] = [0, 1].map(|axis| self.modes.get(axis).map_or(0, |modes| modes.count()));
        let mut matrices = [(); 3].map(|()| DMatrix::zeros(rows, columns));
        let mut turns = Vec::new();
        for (corner, is_twisted) in self.sides.corners(&self.params, t, order)?.into_iter().zip(self.is_twisted) {
            let [i, j] = corner.ends;
            for (quantity, (a, b)) in corner.at_u.iter().zip(&corner.at_v).enumerate() {
                let place = (2 * i + quantity % 2, 2 * j + quantity / 2);
                for ((matrix, a), b) in matrices.iter_mut().zip(a).zip(b) {
                    if let Some(entry) = matrix.get_mut(place) {
                        *entry = -0.5 * (a + b);
                    }
                }
            }
            if let (true, [.., a], [.., b]) = (is_twisted, corner.at_u, corner.at_v) {
                let half = |axis: usize| a.get(axis).zip(b.get(axis)).map_or(f64::NAN, |(a, b)| 0.5 * (a - b));
                turns.push((corner, [half(0), half(1), half(2)]));
            }
        }
        let inner = columns.saturating_sub(CONDITIONS).max(1);
        for (index, vector) in corrections.into_iter().flatten().enumerate() {
            let place = (CONDITIONS + index / inner, CONDITIONS + index % inner);
            for (matrix, value) in matrices.iter_mut().zip(vector) {
                if let Some(entry) = matrix.get_mut(place) {
                    *entry = *value;
                }
            }
        }
        Ok(Core { matrices, turns })
    }

    fn modes_at(&self, axis: usize, order: usize, at: f64) -> Vec<f64> {
        self.modes.get(axis).map(|modes| modes.derivatives(order, at)).unwrap_or_default()
    }

    /// What a corner whose twists disagree takes away at (u, v), per unit of half their difference.
    ///
    /// `in_u` holds the cubic function that carries the corner's tangent in u, differentiated 0, 1, … times; `in_v` the
    /// same for v.
    fn turned(&self, corner: &Corner, [u, v]: [f64; 2], in_u: &[f64], in_v: &[f64]) -> Result<f64, Diagnostic> {
        let distance = |[low, high]: [f64; 2], end: usize, at: f64| {
            let (from, sign) = if end == 0 { (low, 1.0) } else { (high, -1.0) };
            (sign * (at - from) / (high - low), sign / (high - low))
        };
        let [(x, slope_x), (y, slope_y)] =
            [distance(self.sides.ranges[0], corner.ends[0], u), distance(self.sides.ranges[1], corner.ends[1], v)];
        let (p, q) = (in_u.len().saturating_sub(1), in_v.len().saturating_sub(1));
        if x == 0.0 && y == 0.0 && p + q > 2 {
            let message = format!(
                "the sides' twists differ at u = {u}, v = {v}, so S has no derivative of order {} there",
                p + q
            );
            return Err(Diagnostic::new(Code::NotDifferentiable, message)
                .hint("make the derivatives in v of the tangent at fixed u, and in u of the tangent at fixed v, agree in the corner"));
        }
        let mut sum = 0.0;
        let mut choose_i = 1.0;
        let mut factor_x = 1.0;
        for (i, of_u) in in_u.iter().rev().enumerate() {
            let (mut choose_j, mut factor_y) = (1.0, 1.0);
            for (j, of_v) in in_v.iter().rev().enumerate() {
                sum += choose_i * choose_j * factor_x * factor_y * of_u * of_v * turn(i, j, x, y);
                choose_j *= (q - j) as f64 / (j + 1) as f64;
                factor_y *= slope_y;
            }
            choose_i *= (p - i) as f64 / (i + 1) as f64;
            factor_x *= slope_x;
        }
        Ok(sum)
    }

    /// Subtracts what corners with two twists change at one point.
    fn subtract_turns(
        &self,
        turns: &[(Corner, [f64; 3])],
        derivative: Derivative,
        [u, v]: [f64; 2],
        value: &mut [f64; 3],
    ) -> Result<(), Diagnostic> {
        for (corner, half) in turns {
            let [i, j] = corner.ends;
            let tangent = |axis: usize, order: usize, end: usize, at: f64| {
                self.modes_at(axis, order, at).get(2 * end + 1).copied().unwrap_or(f64::NAN)
            };
            let in_u: Vec<f64> = (0..=derivative.u).map(|order| tangent(0, order, i, u)).collect();
            let in_v: Vec<f64> = (0..=derivative.v).map(|order| tangent(1, order, j, v)).collect();
            let share = self.turned(corner, [u, v], &in_u, &in_v)?;
            for (value, half) in value.iter_mut().zip(half) {
                *value -= share * half;
            }
        }
        Ok(())
    }

    /// The data along v and along u, differentiated.
    fn data(
        &self,
        derivative: Derivative,
        v: &[f64],
        u: &[f64],
        times: [&[f64]; 2],
    ) -> Result<[Vec<f64>; 2], Diagnostic> {
        let along = |basis: &Basis, order: usize, at: &[f64], t: &[f64]| {
            basis.values(Derivative::new(0, order, derivative.t), &self.params, at, t)
        };
        let [in_v, in_u] = times;
        Ok([along(&self.sides.at_u, derivative.v, v, in_v)?, along(&self.sides.at_v, derivative.u, u, in_u)?])
    }
}

impl Surface for CoonsSurface {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        points.iter().try_for_each(|[_, _, t]| check_instant(self.instant, *t))?;
        let coordinate =
            |axis: usize| -> Vec<f64> { points.iter().filter_map(|point| point.get(axis)).copied().collect() };
        let (u, v, t) = (coordinate(0), coordinate(1), coordinate(2));
        let [across, along] = self.data(derivative, &v, &u, [&t, &t])?;
        let mut known: Option<(f64, Core)> = None;
        for (index, ([u, v, t], value)) in points.iter().zip(values.iter_mut()).enumerate() {
            let core = match known.take() {
                Some((at, core)) if at == *t => core,
                _ => self.core(*t, derivative.t)?,
            };
            let in_u = self.modes_at(0, derivative.u, *u);
            let in_v = self.modes_at(1, derivative.v, *v);
            for (component, (value, matrix)) in value.iter_mut().zip(&core.matrices).enumerate() {
                let of = |data: &[f64], condition: usize| {
                    data.get((condition * 3 + component) * points.len() + index).copied().unwrap_or(f64::NAN)
                };
                let mut sum = 0.0;
                for (condition, (in_u, in_v)) in in_u.iter().zip(&in_v).take(CONDITIONS).enumerate() {
                    sum += in_u * of(&across, condition) + in_v * of(&along, condition);
                }
                for (in_u, row) in in_u.iter().zip(matrix.row_iter()) {
                    sum += in_u * row.iter().zip(&in_v).map(|(entry, in_v)| entry * in_v).sum::<f64>();
                }
                *value = sum;
            }
            self.subtract_turns(&core.turns, derivative, [*u, *v], value)?;
            known = Some((*t, core));
        }
        finite(values)
    }

    fn breaks(&self, [range_u, range_v]: [[f64; 2]; 2], t: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        let in_u = self.sides.at_v.breaks(&self.params, range_u, t)?;
        Ok([in_u, self.sides.at_u.breaks(&self.params, range_v, t)?])
    }

    fn evaluate_grid(
        &self,
        derivative: Derivative,
        (u, v, t): (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        check_instant(self.instant, t)?;
        let [across, along] = self.data(derivative, v, u, [&vec![t; v.len()], &vec![t; u.len()]])?;
        let core = self.core(t, derivative.t)?;
        let table = |axis: usize, order: usize, at: &[f64]| {
            let rows: Vec<f64> = at.iter().flat_map(|at| self.modes_at(axis, order, *at)).collect();
            DMatrix::from_row_slice(at.len(), rows.len().checked_div(at.len()).unwrap_or(0), &rows)
        };
        let (in_u, in_v) = (table(0, derivative.u, u), table(1, derivative.v, v).transpose());
        for (component, matrix) in core.matrices.iter().enumerate() {
            let of = |data: &[f64], condition: usize, sample: usize, samples: usize| {
                data.get((condition * 3 + component) * samples + sample).copied().unwrap_or(f64::NAN)
            };
            let across = DMatrix::from_fn(CONDITIONS, v.len(), |condition, j| of(&across, condition, j, v.len()));
            let along = DMatrix::from_fn(u.len(), CONDITIONS, |i, condition| of(&along, condition, i, u.len()));
            let sum = in_u.columns(0, CONDITIONS) * across + along * in_v.rows(0, CONDITIONS) + &in_u * matrix * &in_v;
            for (row, slots) in sum.row_iter().zip(values.chunks_mut(v.len().max(1))) {
                for (value, slot) in row.iter().zip(slots) {
                    if let Some(slot) = slot.get_mut(component) {
                        *slot = *value;
                    }
                }
            }
        }
        if !core.turns.is_empty() {
            let points = u.iter().flat_map(|&u| v.iter().map(move |&v| [u, v]));
            for (point, value) in points.zip(values.iter_mut()) {
                self.subtract_turns(&core.turns, derivative, point, value)?;
            }
        }
        finite(values)
    }
}
