//! Separable surfaces at scattered points: the coefficients are contracted block by block, never expanded.
//!
//! For each point the same sums in the same order as on a grid (`on_grid`), so that both give the same bits.

use super::SeparableSurface;
use super::separable::Term;
use super::validity::finite;
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::kernels::grid::{Combination, contract};
use crate::kernels::{InstructionSet, Rows};

/// Points treated together: the rows of basis and modes stay in the second-level cache.
const BLOCK: usize = 512;

/// Writes each of `derivatives` at every point.
pub(super) fn evaluate(
    surface: &SeparableSurface,
    derivatives: &[Derivative],
    points: &[[f64; 3]],
    values: &mut [&mut [[f64; 3]]],
) -> Result<(), Diagnostic> {
    let plan = Plan::new(surface, derivatives)?;
    let mut work = Work::default();
    for (block, points) in points.chunks(BLOCK).enumerate() {
        let from = block * BLOCK;
        plan.block(surface, points, &mut work)?;
        for (sums, values) in work.sums.iter().zip(values.iter_mut()) {
            let values = values.get_mut(from..).and_then(|rest| rest.get_mut(..points.len())).unwrap_or_default();
            let mut rows = sums.iter();
            let (x, y, z) = (rows.next(), rows.next(), rows.next());
            let xyz = x.unwrap_or_default().iter().zip(y.unwrap_or_default()).zip(z.unwrap_or_default());
            for (value, ((x, y), z)) in values.iter_mut().zip(xyz) {
                *value = [*x, *y, *z];
            }
            finite(values)?;
        }
    }
    Ok(())
}

/// What the requested derivatives have in common.
struct Plan {
    set: InstructionSet,
    /// The orders in u that are needed.
    orders: Vec<usize>,
    /// The derivatives of the basis that are needed.
    bases: Vec<Derivative>,
    /// For each derivative: which order, which bases (one for each term), which terms.
    parts: Vec<Part>,
}

struct Part {
    order: usize,
    bases: Vec<usize>,
    combination: Combination,
    over_modes: bool,
}

/// Buffers of one block.
#[derive(Default)]
struct Work {
    modes: Vec<Rows>,
    bases: Vec<Vec<f64>>,
    /// For each derivative the rows of x, y and z.
    sums: Vec<Rows>,
}

impl Plan {
    fn new(surface: &SeparableSurface, derivatives: &[Derivative]) -> Result<Plan, Diagnostic> {
        let mut plan = Plan { set: InstructionSet::best(), orders: Vec::new(), bases: Vec::new(), parts: Vec::new() };
        for derivative in derivatives {
            let terms = surface.terms(derivative.t)?;
            let over_modes = surface.sums_over_modes(&terms);
            let order = index_of(&mut plan.orders, derivative.u);
            let along = |term: &Term| Derivative { u: 0, t: term.order, ..*derivative };
            let bases = terms.iter().map(|term| index_of(&mut plan.bases, along(term))).collect();
            let combination = combination(&terms, surface.basis.len(), over_modes);
            plan.parts.push(Part { order, bases, combination, over_modes });
        }
        Ok(plan)
    }

    fn block(&self, surface: &SeparableSurface, points: &[[f64; 3]], work: &mut Work) -> Result<(), Diagnostic> {
        let length = points.len();
        let column = |axis: usize| points.iter().filter_map(|point| point.get(axis).copied()).collect::<Vec<f64>>();
        let [u, v, t] = [column(0), column(1), column(2)];
        work.bases.clear();
        for derivative in &self.bases {
            work.bases.push(surface.basis.values(*derivative, &surface.params, &v, &t)?);
        }
        work.modes.clear();
        for order in &self.orders {
            let mut rows = Rows::zeros(surface.modes.count(), length);
            surface.modes.tabulate(*order, &u, &mut rows);
            work.modes.push(rows);
        }
        work.sums.clear();
        for part in &self.parts {
            let mut sums = Rows::zeros(3, length);
            let modes: Vec<&[f64]> = work.modes.get(part.order).into_iter().flat_map(Rows::iter).collect();
            let bases = part.bases.iter().filter_map(|basis| work.bases.get(*basis));
            let bases: Vec<&[f64]> = bases.flat_map(|basis| basis.chunks(length.max(1))).collect();
            let (inner, outer) = if part.over_modes { (&bases, &modes) } else { (&modes, &bases) };
            let mut targets = sums.iter_mut();
            if let (Some(x), Some(y), Some(z)) = (targets.next(), targets.next(), targets.next()) {
                contract(self.set, &part.combination, inner, outer, [x, y, z]);
            }
            drop(targets);
            work.sums.push(sums);
        }
        Ok(())
    }
}

/// For each row of the outer sum the rows of the inner one and their coefficients.
fn combination(terms: &[Term], basis: usize, over_modes: bool) -> Combination {
    let modes = terms.iter().map(|term| term.rows.len()).max().unwrap_or(0);
    let mut rows = vec![Vec::new(); if over_modes { modes } else { terms.len() * basis }];
    for (number, term) in terms.iter().enumerate() {
        for (m, row) in term.rows.iter().enumerate() {
            for (j, coefficient) in row {
                let function = number * basis + j;
                let (outer, inner) = if over_modes { (m, function) } else { (function, m) };
                if let Some(row) = rows.get_mut(outer) {
                    row.push((inner, *coefficient));
                }
            }
        }
    }
    rows
}

/// The index of `item`, which is added if it is not there.
fn index_of<T: PartialEq>(items: &mut Vec<T>, item: T) -> usize {
    items.iter().position(|known| *known == item).unwrap_or_else(|| {
        items.push(item);
        items.len() - 1
    })
}
