//! Separable surfaces on a grid: tables along u and along v, multiplied as small matrices.
//!
//! `S = Σ_m φ_m(u) H_m(v)` with `H_m = Σ_j C_mj F_j`, or `S = Σ_j G_j(u) F_j(v)` with `G_j = Σ_m C_mj φ_m`, whichever sum is the
//! shorter. What does not depend on t is kept from one instant to the next: the modes, or the G_j, at every u.

use std::ops::Range;
use std::slice::ChunksMut;
use std::sync::Arc;

use super::separable::Contraction;
use super::validity::{check_instant, finite};
use super::{Basis, Coefficients, SeparableSurface};
use crate::diagnostic::Diagnostic;
use crate::eval::JetValues;
use crate::expr::Derivative;
use crate::kernels::grid::{self, Across, Along, Number, Outputs, Stores};
use crate::kernels::{InstructionSet, Rows};
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
    /// What the tables below belong to.
    last: Option<Last>,
    /// The derivatives of the modes of each order asked for.
    modes: Vec<(usize, Arc<Rows>)>,
    /// What each derivative asked for is made of.
    across: Vec<(Derivative, Arc<AcrossTable>)>,
    /// Derivatives of the basis that were asked for together.
    along: Vec<(Vec<Derivative>, JetValues)>,
}

/// The parts of a surface that tables are made from.
struct Last {
    modes: Arc<dyn Modes>,
    basis: Arc<Basis>,
    coefficients: Arc<Vec<Coefficients>>,
    /// Whether further derivatives of the coefficients are unknown, and not zero.
    is_of_one_instant: bool,
}

/// One derivative in u and t of the factors along u, which do not depend on t.
struct AcrossTable {
    contraction: Contraction,
    /// In doubles; the modes of the outer sum, or the G_j.
    table: Across<f64>,
    largest: Vec<f64>,
}

/// Vertices that are worth handing to another thread.
const PIECE: usize = 1 << 14;

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

impl<'a> SurfaceOnGrid<'a> {
    /// The grid of all `u` and `v`.
    #[must_use]
    pub fn new(u: &'a [f64], v: &'a [f64]) -> Self {
        let (modes, across, along) = (Vec::new(), Vec::new(), Vec::new());
        SurfaceOnGrid { u, v, set: InstructionSet::best(), last: None, modes, across, along }
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
        check_instant(surface.instant, t)?;
        self.turn_to(surface);
        let table = self.across(surface, derivative)?;
        let (set, columns) = (self.set, self.v.len());
        let in_time = |order: &usize| Derivative { u: 0, t: *order, ..derivative };
        let bases: Vec<Derivative> = table.contraction.orders.iter().map(in_time).collect();
        let along = along::<N>(set, &table.contraction, &self.functions(surface, &bases, t)?, columns);
        let across = table.table.rounded();
        let bound = grid::bound(&across, &table.largest, &along);
        let along = along.interleaved();
        let stores = Stores::suited_to(size_of_val(values));
        let (pieces, size) = self.pieces::<N>(stores);
        threads::map(pieces.into_iter().zip(values.chunks_mut(size)).collect(), |(rows, values)| {
            grid::positions(self.set, stores, (&across, &along), rows, values);
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
        check_instant(surface.instant, t)?;
        self.turn_to(surface);
        let values = self.across(surface, Derivative::NONE)?;
        let slopes_u = self.across(surface, Derivative::new(1, 0, 0))?;
        let (set, columns) = (self.set, self.v.len());
        let functions = self.functions(surface, &[Derivative::NONE, Derivative::new(0, 1, 0)], t)?;
        let (functions, slopes_v) = functions.split_at_checked(surface.basis.len()).unwrap_or_default();
        let [f, f_v] = [functions, slopes_v].map(|rows| along::<N>(set, &values.contraction, rows, columns));
        let [g, g_u] = [&values, &slopes_u].map(|known| known.table.rounded::<N>());
        let bounds = [(&g, &values, &f), (&g_u, &slopes_u, &f), (&g, &values, &f_v)]
            .map(|(across, known, along)| grid::bound(across, &known.largest, along));
        let Outputs { positions, normals, mut tangents } = outputs;
        let bytes = size_of_val(positions) * if tangents.is_some() { 4 } else { 2 };
        let outputs = Outputs {
            positions: &mut *positions,
            normals,
            tangents: tangents.as_mut().map(|[u, v]| [&mut **u, &mut **v]),
        };
        let (across, along) = ([&g, &g_u], [&f, &f_v]);
        let stores = Stores::suited_to(bytes);
        let (pieces, size) = self.pieces::<N>(stores);
        let pieces = pieces.into_iter().zip(cut(outputs, size)).collect();
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

    /// All rows, in pieces that one thread writes at a time, and the vertices of a piece: enough to be worth a thread, in
    /// whole tiles.
    fn pieces<N: Number>(&self, stores: Stores) -> (Vec<Range<usize>>, usize) {
        let (all, columns) = (self.u.len(), self.v.len());
        let size = PIECE.div_ceil(columns.max(1)).next_multiple_of(stores.rows_together::<N>(columns));
        let pieces = (0..all).step_by(size).map(|first| first..all.min(first + size));
        (pieces.collect(), (size * columns).max(1))
    }

    /// Forgets what was known about another surface.
    fn turn_to(&mut self, surface: &SeparableSurface) {
        let is_it = |last: &Last| {
            Arc::ptr_eq(&last.modes, &surface.modes)
                && Arc::ptr_eq(&last.basis, &surface.basis)
                && Arc::ptr_eq(&last.coefficients, &surface.coefficients)
                && last.is_of_one_instant == surface.instant.is_some()
        };
        if self.last.as_ref().is_some_and(is_it) {
            return;
        }
        // A fit has other coefficients at each instant, of the same modes and basis.
        self.across.clear();
        if !self.last.as_ref().is_some_and(|last| Arc::ptr_eq(&last.modes, &surface.modes)) {
            self.modes.clear();
        }
        if !self.last.as_ref().is_some_and(|last| Arc::ptr_eq(&last.basis, &surface.basis)) {
            self.along.clear();
        }
        let SeparableSurface { modes, basis, coefficients, instant, .. } = surface;
        let (modes, basis, coefficients) = (modes.clone(), basis.clone(), coefficients.clone());
        self.last = Some(Last { modes, basis, coefficients, is_of_one_instant: instant.is_some() });
    }

    /// The factors along u of a derivative in u and t of the surface that was turned to.
    fn across(&mut self, surface: &SeparableSurface, derivative: Derivative) -> Result<Arc<AcrossTable>, Diagnostic> {
        let derivative = Derivative { v: 0, ..derivative };
        if let Some((_, table)) = self.across.iter().find(|(known, _)| *known == derivative) {
            return Ok(Arc::clone(table));
        }
        let contraction = surface.contraction(derivative.t)?;
        let modes = self.modes_of(surface, derivative.u);
        let table = Arc::new(AcrossTable::new(self.set, contraction, surface.basis.len(), &modes));
        self.across.push((derivative, Arc::clone(&table)));
        Ok(table)
    }

    /// The derivatives of order `order` of the modes, a row for each mode.
    fn modes_of(&mut self, surface: &SeparableSurface, order: usize) -> Arc<Rows> {
        if let Some((_, table)) = self.modes.iter().find(|(known, _)| *known == order) {
            return Arc::clone(table);
        }
        let mut tables = Vec::new();
        surface.modes.tabulate(&[order], self.u, &mut tables);
        let table = Arc::new(tables.pop().unwrap_or_default());
        self.modes.push((order, Arc::clone(&table)));
        table
    }

    /// Derivatives of the basis at every v: a row for each function of the first derivative, then of the next.
    fn functions(
        &mut self,
        surface: &SeparableSurface,
        derivatives: &[Derivative],
        t: f64,
    ) -> Result<Vec<&[f64]>, Diagnostic> {
        let known = self.along.iter().position(|(known, _)| known == derivatives);
        let index = match known {
            Some(index) => index,
            None => {
                self.along.push((derivatives.to_vec(), surface.basis.jet(derivatives)?));
                self.along.len() - 1
            }
        };
        let Some((_, jet)) = self.along.get_mut(index) else { return Ok(Vec::new()) };
        surface.basis.evaluate((derivatives, jet), &surface.params, (self.v, &vec![t; self.v.len()]))?;
        let jet = &*jet;
        Ok((0..derivatives.len() * surface.basis.len()).map(move |output| jet.row(output)).collect())
    }
}

impl AcrossTable {
    /// From `modes`, a row for each.
    fn new(set: InstructionSet, contraction: Contraction, functions: usize, modes: &Rows) -> AcrossTable {
        let (rows, combination) = (modes.length(), &contraction.combination);
        let mut table = if contraction.over_modes {
            Across::scalars(rows, modes.count())
        } else {
            let parts = [0, 1, 2].map(|component| combination.rows_of(component).collect());
            Across::vectors(rows, functions * contraction.orders.len(), parts)
        };
        let mut columns: Vec<Vec<f64>> = Vec::with_capacity(table.width());
        if contraction.over_modes {
            columns.extend(modes.iter().map(<[f64]>::to_vec));
        } else {
            let modes: Vec<&[f64]> = modes.iter().collect();
            for (component, part) in table.parts().iter().enumerate() {
                for function in part {
                    let mut column = vec![0.0; rows];
                    grid::combine(set, combination.entries(*function, component), &modes, &mut column);
                    columns.push(column);
                }
            }
        }
        for (i, row) in table.rows_mut().enumerate() {
            row.iter_mut().zip(&columns).for_each(|(slot, column)| *slot = column.get(i).copied().unwrap_or(f64::NAN));
        }
        let largest = table.largest();
        AcrossTable { contraction, table, largest }
    }
}

/// The factors along v of a sum, from the rows of its functions.
fn along<N: Number>(set: InstructionSet, contraction: &Contraction, functions: &[&[f64]], columns: usize) -> Along<N> {
    let combination = &contraction.combination;
    if !contraction.over_modes {
        let mut along = Along::scalars(functions.len(), columns);
        for (row, function) in along.rows_mut().zip(functions) {
            row.iter_mut().zip(*function).for_each(|(slot, value)| *slot = N::rounded(*value));
        }
        return along;
    }
    let mut along = Along::vectors(combination.rows(), columns);
    let mut sum = vec![0.0; columns];
    for (index, row) in along.rows_mut().enumerate() {
        grid::combine(set, combination.entries(index / 3, index % 3), functions, &mut sum);
        row.iter_mut().zip(&sum).for_each(|(slot, sum)| *slot = N::rounded(*sum));
    }
    along
}
