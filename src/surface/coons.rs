//! Surfaces from data on four sides: the bicubically blended Coons surface, and corrections that no side can see.
//!
//! `S = Σ_a H_a(u) X_a(v) + Σ_b H_b(v) Y_b(u) - Σ_ab H_a(u) H_b(v) C_ab + Σ_mn c_mn f_m(u) f_n(v)` (docs/methods.md,
//! H1). H are the cubic Hermite functions of each range, X and Y the data, C what the corners state, f functions with
//! double zeros at both ends. So position and tangent on every side are those stated, whatever the c_mn.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use nalgebra::DMatrix;

use super::gregory::turn;
use super::sides::CONDITIONS;
use super::validity::{check_instant, finite, unknown_in_time};
use super::{Basis, Coefficients, Corner, Sides, Surface, TabulatedModes};
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Derivative;

/// A surface with given position and tangent on four sides.
pub struct CoonsSurface {
    /// The data.
    sides: Arc<Sides>,
    /// The functions of u and of v: the four cubic Hermite ones, then those with double zeros at both ends.
    modes: [Arc<TabulatedModes>; 2],
    /// Values of the parameters.
    params: Vec<f64>,
    /// Whether the twists of the sides disagree, by corner as in [`Sides::corners`].
    is_twisted: [bool; 4],
    corrections: Corrections,
    /// The only instant at which the corrections hold; `None` if they hold for every t.
    instant: Option<f64>,
    /// What was found for the last instants and orders in t: every grid asks for it.
    cores: Mutex<Vec<(f64, usize, Arc<Core>)>>,
}

/// The coefficients c_mn, n running faster, and their derivatives in time, each found when it is first asked for.
///
/// Those beyond are unknown, or zero if the coefficients hold for every t.
#[derive(Default)]
pub struct Corrections {
    levels: Vec<OnceLock<Result<Coefficients, Diagnostic>>>,
    find: Option<Box<Find>>,
}

/// Finds the derivative of a given order.
type Find = dyn Fn(usize) -> Result<Coefficients, Diagnostic> + Send + Sync;

impl Corrections {
    /// `first`, and the `further` derivatives that `find` finds.
    #[must_use]
    pub fn new(first: Coefficients, further: usize, find: Box<Find>) -> Corrections {
        let levels = std::iter::once(OnceLock::from(Ok(first))).chain((0..further).map(|_| OnceLock::new()));
        Corrections { levels: levels.collect(), find: Some(find) }
    }

    /// The derivative of order `order` in t; `None` beyond those there are.
    fn level(&self, order: usize) -> Option<Result<&Coefficients, Diagnostic>> {
        let (level, find) = (self.levels.get(order)?, self.find.as_ref()?);
        Some(level.get_or_init(|| find(order)).as_ref().map_err(Clone::clone))
    }
}

/// Instants and orders in t of which a surface remembers what they have in common.
const REMEMBERED: usize = 4;

/// At one instant, for each component, the matrix between the functions of u and of v; and for each corner half the
/// difference of its twists.
struct Core {
    matrices: [DMatrix<f64>; 3],
    turns: Vec<(Corner, [f64; 3])>,
}

impl CoonsSurface {
    /// The surface between `sides`, where `is_twisted` says, by corner as in [`Sides::corners`], whether their twists
    /// disagree.
    ///
    /// `modes` are the functions of u and of v: the four cubic Hermite ones, then as many as there are corrections. The
    /// corrections hold at `instant` alone, or for every t.
    #[must_use]
    pub fn new(
        sides: Arc<Sides>,
        modes: [Arc<TabulatedModes>; 2],
        params: &[f64],
        is_twisted: [bool; 4],
        (corrections, instant): (Corrections, Option<f64>),
    ) -> CoonsSurface {
        let (params, cores) = (params.to_vec(), Mutex::default());
        CoonsSurface { sides, modes, params, is_twisted, corrections, instant, cores }
    }

    /// The corners' values and the corrections, differentiated `order` times in t.
    fn core(&self, t: f64, order: usize) -> Result<Arc<Core>, Diagnostic> {
        // A panic elsewhere leaves the list whole.
        let lock = || self.cores.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((.., core)) = lock().iter().find(|(at, of, _)| *at == t && *of == order) {
            return Ok(Arc::clone(core));
        }
        let core = Arc::new(self.new_core(t, order)?);
        let mut cores = lock();
        if cores.len() >= REMEMBERED {
            cores.remove(0);
        }
        cores.push((t, order, Arc::clone(&core)));
        Ok(core)
    }

    fn new_core(&self, t: f64, order: usize) -> Result<Core, Diagnostic> {
        let corrections = match self.corrections.level(order).transpose()? {
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
        let mut known: Option<(f64, Arc<Core>)> = None;
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
        let [of_u, of_v] = &self.modes;
        let (in_u, in_v) = (of_u.table(derivative.u, u), of_v.table(derivative.v, v));
        let columns = v.len();
        // Values of the four functions of v, and of the data along v, at every v: four slices each.
        let functions = first_four(in_v.values.as_slice().chunks(columns.max(1)));
        for (component, matrix) in core.matrices.iter().enumerate() {
            let data = first_four(across.chunks(columns.max(1)).skip(component).step_by(3));
            let inner = &in_u.values * matrix * &in_v.transposed;
            let rows = in_u.values.row_iter().zip(inner.row_iter()).zip(values.chunks_mut(columns.max(1)));
            for (i, ((in_u, inner), slots)) in rows.enumerate() {
                let of_data = four(in_u.iter().copied());
                let of_functions = four(along.iter().skip(component * u.len() + i).step_by(3 * u.len()).copied());
                let (data, functions) = (sums(of_data, data), sums(of_functions, functions));
                for (((slot, data), functions), inner) in slots.iter_mut().zip(data).zip(functions).zip(inner.iter()) {
                    if let Some(slot) = slot.get_mut(component) {
                        *slot = data + functions + inner;
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

/// The first four slices; what is not there is empty.
fn first_four<'a>(mut all: impl Iterator<Item = &'a [f64]>) -> [&'a [f64]; CONDITIONS] {
    [(); CONDITIONS].map(|()| all.next().unwrap_or_default())
}

/// The first four numbers.
fn four(mut all: impl Iterator<Item = f64>) -> [f64; CONDITIONS] {
    [(); CONDITIONS].map(|()| all.next().unwrap_or(f64::NAN))
}

/// `Σ_c factors_c rows_c` for every entry of the rows, in ascending order.
fn sums([a, b, c, d]: [f64; CONDITIONS], [x, y, z, w]: [&[f64]; CONDITIONS]) -> impl Iterator<Item = f64> {
    x.iter().zip(y).zip(z).zip(w).map(move |(((x, y), z), w)| a * x + b * y + c * z + d * w)
}
