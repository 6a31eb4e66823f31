//! Separable surfaces on a grid: tables along u and along v, multiplied as small matrices.
//!
//! `S = Σ_m φ_m(u) H_m(v)` with `H_m = Σ_j C_mj F_j`, or `S = Σ_j G_j(u) F_j(v)` with `G_j = Σ_m C_mj φ_m`, whichever sum is the
//! shorter. What does not depend on t is kept from one instant to the next: the modes at every u.

use std::ops::Range;
use std::slice::ChunksMut;
use std::sync::Arc;

use super::SeparableSurface;
use super::separable::Term;
use super::validity::{check_instant, finite};
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::kernels::InstructionSet;
use crate::kernels::grid::{self, Across, Along, Number, Outputs, Stores};
use crate::threads;
use crate::trial::Modes;

/// A surface's points and directions on a grid, u-major.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct GridShape {
    /// S.
    pub positions: Vec<[f64; 3]>,
    /// S_u.
    pub tangents_u: Vec<[f64; 3]>,
    /// S_v.
    pub tangents_v: Vec<[f64; 3]>,
    /// `S_u x S_v` at unit length, if it was found on the way.
    pub normals: Option<UnitNormals>,
}

/// Unit normals, of which the caller decides whether they are more than rounding.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitNormals {
    /// One for each vertex; not finite where the product of the tangents is zero.
    pub unit: Vec<[f64; 3]>,
    /// The least of `|S_u x S_v|²`.
    pub least_square: f64,
}

/// A grid of parameters, and what is known about separable surfaces on it.
pub struct SurfaceOnGrid<'a> {
    u: &'a [f64],
    v: &'a [f64],
    set: InstructionSet,
    /// The modes of the last surface, and their derivatives of each order asked for: a row for each u.
    modes: Option<Arc<dyn Modes>>,
    tables: Vec<(usize, Arc<Vec<f64>>)>,
}

/// Vertices that are worth handing to another thread.
const PIECE: usize = 1 << 14;
/// Rows that kernels write together.
const TILE: usize = 8;

/// Outputs in pieces of `size` vertices.
fn cut<'a, N>(outputs: Outputs<'a, N>, size: usize) -> impl Iterator<Item = Outputs<'a, N>> {
    let Outputs { positions, normals, tangents } = outputs;
    let mut tangents = tangents.map(|both| both.map(|values| values.chunks_mut(size)));
    let pieces = positions.chunks_mut(size).zip(normals.chunks_mut(size));
    pieces.map(move |(positions, normals)| {
        let next = |[u, v]: &mut [ChunksMut<'a, [N; 3]>; 2]| Some([u.next()?, v.next()?]);
        Outputs { positions, normals, tangents: tangents.as_mut().and_then(next) }
    })
}

/// The factors of one derivative.
struct Factors<N> {
    across: Across<N>,
    along: Along<N>,
}

impl<'a> SurfaceOnGrid<'a> {
    /// The grid of all `u` and `v`.
    #[must_use]
    pub fn new(u: &'a [f64], v: &'a [f64]) -> Self {
        SurfaceOnGrid { u, v, set: InstructionSet::best(), modes: None, tables: Vec::new() }
    }

    /// The same, evaluated with other instructions; the results are the same.
    #[must_use]
    pub fn with_instructions(self, set: InstructionSet) -> Self {
        SurfaceOnGrid { set, ..self }
    }

    /// Writes a derivative of `surface` at instant `t`: `values[i * v.len() + j]` belongs to `(u[i], v[j], t)`.
    ///
    /// Points are rounded from doubles to `N` before they are combined, so that `f32` has errors of its own precision
    /// times the number of terms.
    ///
    /// # Errors
    /// As [`Surface::evaluate`](super::Surface::evaluate).
    pub fn evaluate<N: Number>(
        &mut self,
        surface: &SeparableSurface,
        derivative: Derivative,
        t: f64,
        values: &mut [[N; 3]],
    ) -> Result<(), Diagnostic> {
        let factors = self.factors::<N>(surface, derivative, t)?;
        let along = factors.along.interleaved();
        let bound = grid::bound(&factors.across, &factors.along);
        let stores = Stores::suited_to(size_of_val(values));
        let pieces = self.pieces().zip(values.chunks_mut(self.vertices_of_a_piece()));
        threads::map(pieces.collect(), |(rows, values)| {
            grid::positions(self.set, stores, (&factors.across, &along), rows, values);
        });
        if bound <= N::LARGEST { Ok(()) } else { finite(values) }
    }

    /// Positions, tangents and unit normals of `surface` at instant `t`.
    ///
    /// # Errors
    /// As [`Surface::evaluate`](super::Surface::evaluate).
    pub fn shape(&mut self, surface: &SeparableSurface, t: f64) -> Result<GridShape, Diagnostic> {
        let zeros = || vec![[0.0; 3]; self.u.len() * self.v.len()];
        let (mut positions, mut tangents_u, mut tangents_v, mut unit) = (zeros(), zeros(), zeros(), zeros());
        let outputs = Outputs {
            positions: &mut positions,
            normals: &mut unit,
            tangents: Some([&mut tangents_u, &mut tangents_v]),
        };
        let least_square = self.write_shape(surface, t, outputs)?;
        let normals = least_square.map(|least_square| UnitNormals { unit, least_square });
        Ok(GridShape { positions, tangents_u, tangents_v, normals })
    }

    /// Writes positions, unit normals and perhaps tangents of `surface` at instant `t`; returns the least of
    /// `|S_u x S_v|²`, or `None` where products of tangents leave the range of numbers and the normals are worthless.
    ///
    /// # Errors
    /// As [`Surface::evaluate`](super::Surface::evaluate).
    pub fn write_shape<N: Number>(
        &mut self,
        surface: &SeparableSurface,
        t: f64,
        outputs: Outputs<'_, N>,
    ) -> Result<Option<f64>, Diagnostic> {
        let values = self.factors::<N>(surface, Derivative::NONE, t)?;
        let slopes_u = self.factors::<N>(surface, Derivative::new(1, 0, 0), t)?;
        let slopes_v = self.factors::<N>(surface, Derivative::new(0, 1, 0), t)?;
        let bounds = [&values, &slopes_u, &slopes_v].map(|factors| grid::bound(&factors.across, &factors.along));
        let Outputs { positions, normals, mut tangents } = outputs;
        let bytes = size_of_val(positions) * if tangents.is_some() { 4 } else { 2 };
        let outputs = Outputs {
            positions: &mut *positions,
            normals,
            tangents: tangents.as_mut().map(|[u, v]| [&mut **u, &mut **v]),
        };
        let across = [&values.across, &slopes_u.across];
        let along = [&values.along, &slopes_v.along];
        let stores = Stores::suited_to(bytes);
        let pieces = self.pieces().zip(cut(outputs, self.vertices_of_a_piece())).collect();
        let work = |(rows, outputs)| grid::shape(self.set, stores, (across, along), rows, outputs);
        // A least that is not a number must stay one.
        let lesser = |least: f64, here: f64| if here < least || here.is_nan() { here } else { least };
        let least = threads::map(pieces, work).into_iter().fold(f64::INFINITY, lesser);
        if !bounds.iter().all(|bound| *bound <= N::LARGEST) {
            finite(positions)?;
            for tangents in tangents.into_iter().flatten() {
                finite(tangents)?;
            }
        }
        let are_moderate = bounds.iter().skip(1).all(|bound| *bound <= N::MODERATE);
        Ok(are_moderate.then_some(least))
    }

    /// Rows that one thread writes at a time: enough to be worth a thread, in whole tiles.
    fn rows_of_a_piece(&self) -> usize {
        PIECE.div_ceil(self.v.len().max(1)).next_multiple_of(TILE)
    }

    fn vertices_of_a_piece(&self) -> usize {
        (self.rows_of_a_piece() * self.v.len()).max(1)
    }

    /// All rows, in pieces.
    fn pieces(&self) -> impl Iterator<Item = Range<usize>> {
        let (all, size) = (self.u.len(), self.rows_of_a_piece());
        (0..all).step_by(size).map(move |first| first..all.min(first + size))
    }

    /// The factors of a derivative, the shorter of the two sums.
    fn factors<N: Number>(
        &mut self,
        surface: &SeparableSurface,
        derivative: Derivative,
        t: f64,
    ) -> Result<Factors<N>, Diagnostic> {
        check_instant(surface.instant, t)?;
        let (instants, columns, count) = (vec![t; self.v.len()], self.v.len(), surface.basis.len());
        let terms = surface.terms(derivative.t)?;
        let mut functions = Vec::with_capacity(terms.len());
        for term in &terms {
            let orders = Derivative { t: term.order, ..derivative };
            functions.push(surface.basis.values(orders, &surface.params, self.v, &instants)?);
        }
        let modes = self.modes_of(surface, derivative.u);
        let modes = modes.chunks_exact(surface.modes.count().max(1));
        if surface.sums_over_modes(&terms) {
            let rank = surface.modes.count();
            let mut across = Across::scalars(self.u.len(), rank);
            for (row, modes) in across.rows_mut().zip(modes) {
                row.iter_mut().zip(modes).for_each(|(slot, mode)| *slot = N::rounded(*mode));
            }
            let mut along = Along::vectors(rank, columns);
            let mut sums = [(); 3].map(|()| vec![0.0; columns]);
            let mut rows = along.rows_mut();
            for m in 0..rank {
                sums.iter_mut().for_each(|sum| sum.fill(0.0));
                for (term, functions) in terms.iter().zip(&functions) {
                    grid::combine(self.set, term.rows.get(m).map_or(&[], Vec::as_slice), functions, &mut sums);
                }
                // In this order: the other takes a row too many.
                for (sum, row) in sums.iter().zip(rows.by_ref()) {
                    row.iter_mut().zip(sum).for_each(|(slot, sum)| *slot = N::rounded(*sum));
                }
            }
            drop(rows);
            return Ok(Factors { across, along });
        }
        let rank = count * terms.len();
        let mut across = Across::vectors(self.u.len(), rank);
        let mut amplitudes = vec![[0.0; 3]; count];
        for (row, modes) in across.rows_mut().zip(modes) {
            let mut slots = row.iter_mut();
            for term in &terms {
                amplitudes.fill([0.0; 3]);
                Term::add_amplitudes(term, modes, &mut amplitudes);
                amplitudes.iter().flatten().zip(slots.by_ref()).for_each(|(x, slot)| *slot = N::rounded(*x));
            }
        }
        let mut along = Along::scalars(rank, columns);
        let functions = functions.iter().flat_map(|functions| functions.chunks(columns.max(1)));
        for (row, function) in along.rows_mut().zip(functions) {
            row.iter_mut().zip(function).for_each(|(slot, value)| *slot = N::rounded(*value));
        }
        Ok(Factors { across, along })
    }

    /// The derivatives of order `order` of the modes, a row for each u.
    fn modes_of(&mut self, surface: &SeparableSurface, order: usize) -> Arc<Vec<f64>> {
        if !self.modes.as_ref().is_some_and(|modes| Arc::ptr_eq(modes, &surface.modes)) {
            self.modes = Some(Arc::clone(&surface.modes));
            self.tables.clear();
        }
        if let Some((_, table)) = self.tables.iter().find(|(known, _)| *known == order) {
            return Arc::clone(table);
        }
        let table = Arc::new(self.u.iter().flat_map(|u| surface.modes.derivatives(order, *u)).collect());
        self.tables.push((order, Arc::clone(&table)));
        table
    }
}
