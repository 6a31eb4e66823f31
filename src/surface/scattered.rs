//! Separable surfaces at scattered points: the coefficients are contracted block by block, never expanded.
//!
//! For each point the same sums in the same order as on a grid (`on_grid`), so that both give the same bits.

use std::ops::Range;

use super::SeparableSurface;
use super::separable::Contraction;
use super::validity::finite;
use crate::diagnostic::Diagnostic;
use crate::eval::JetValues;
use crate::expr::Derivative;
use crate::kernels::grid::{assemble, contract};
use crate::kernels::{InstructionSet, Rows, are_finite};

/// Points treated together: the rows of basis, modes and sums stay in the second-level cache.
const BLOCK: usize = 512;

/// Writes each of `derivatives` at every point.
pub(super) fn evaluate(
    surface: &SeparableSurface,
    derivatives: &[Derivative],
    points: &[[f64; 3]],
    values: &mut [&mut [[f64; 3]]],
) -> Result<(), Diagnostic> {
    let plan = Plan::new(surface, derivatives)?;
    let mut work = Work::new(surface, &plan)?;
    let set = InstructionSet::best();
    for (block, points) in points.chunks(BLOCK).enumerate() {
        let from = block * BLOCK;
        plan.block(surface, points, &mut work)?;
        for (place, values) in values.iter_mut().enumerate() {
            let values = values.get_mut(from..).and_then(|rest| rest.get_mut(..points.len())).unwrap_or_default();
            let rows = [0, 1, 2].map(|component| work.sums.row(3 * place + component));
            assemble(set, values, rows);
            if !rows.iter().all(|row| are_finite(set, row)) {
                finite(values)?;
            }
        }
    }
    Ok(())
}

/// What the requested derivatives have in common.
struct Plan {
    /// The orders in u that are needed.
    orders: Vec<usize>,
    /// The derivatives of the basis that are needed.
    bases: Vec<Derivative>,
    groups: Vec<Group>,
    /// The number of derivatives.
    count: usize,
}

/// Derivatives of the same functions of v and t, which differ in their order in u.
struct Group {
    contraction: Contraction,
    /// Which of the plan's bases stand for the contraction's orders in t.
    bases: Vec<usize>,
    /// Of each derivative, its place among those requested and its place in the plan's orders.
    members: Vec<(usize, usize)>,
}

/// Buffers of one block.
struct Work {
    modes: Vec<Rows>,
    bases: JetValues,
    /// For each derivative the rows of x, y and z.
    sums: Rows,
}

impl Work {
    fn new(surface: &SeparableSurface, plan: &Plan) -> Result<Work, Diagnostic> {
        Ok(Work { modes: Vec::new(), bases: surface.basis.jet(&plan.bases)?, sums: Rows::default() })
    }
}

impl Plan {
    fn new(surface: &SeparableSurface, derivatives: &[Derivative]) -> Result<Plan, Diagnostic> {
        let (orders, bases, groups) = (Vec::new(), Vec::new(), Vec::new());
        let mut plan = Plan { orders, bases, groups, count: derivatives.len() };
        let mut known: Vec<Derivative> = Vec::new();
        for (place, derivative) in derivatives.iter().enumerate() {
            let order = index_of(&mut plan.orders, derivative.u);
            let group = index_of(&mut known, Derivative { u: 0, ..*derivative });
            if group == plan.groups.len() {
                let contraction = surface.contraction(derivative.t)?;
                let along = |order: &usize| Derivative { u: 0, t: *order, ..*derivative };
                let bases = contraction.orders.iter().map(|order| index_of(&mut plan.bases, along(order))).collect();
                plan.groups.push(Group { contraction, bases, members: Vec::new() });
            }
            if let Some(group) = plan.groups.get_mut(group) {
                group.members.push((place, order));
            }
        }
        Ok(plan)
    }

    fn block(&self, surface: &SeparableSurface, points: &[[f64; 3]], work: &mut Work) -> Result<(), Diagnostic> {
        let u: Vec<f64> = points.iter().map(|[u, _, _]| *u).collect();
        let v: Vec<f64> = points.iter().map(|[_, v, _]| *v).collect();
        let t: Vec<f64> = points.iter().map(|[_, _, t]| *t).collect();
        surface.basis.evaluate((&self.bases, &mut work.bases), &surface.params, (&v, &t))?;
        surface.modes.tabulate(&self.orders, &u, &mut work.modes);
        work.sums.reshape(3 * self.count, points.len());
        let mut sums: Vec<&mut [f64]> = work.sums.iter_mut().collect();
        for group in &self.groups {
            let functions = surface.basis.len();
            let of = |basis: &usize| -> Range<usize> { basis * functions..(basis + 1) * functions };
            let bases: Vec<&[f64]> = group.bases.iter().flat_map(of).map(|output| work.bases.row(output)).collect();
            let modes = |order: usize| work.modes.get(order).into_iter().flat_map(Rows::iter).collect::<Vec<&[f64]>>();
            let mut target = |place: &usize| {
                let mut row = |component| sums.get_mut(3 * place + component).map(std::mem::take).unwrap_or_default();
                [row(0), row(1), row(2)]
            };
            let mut targets: Vec<[&mut [f64]; 3]> = group.members.iter().map(|(place, _)| target(place)).collect();
            let Contraction { over_modes, combination, .. } = &group.contraction;
            let set = InstructionSet::best();
            if *over_modes {
                let outers: Vec<Vec<&[f64]>> = group.members.iter().map(|(_, order)| modes(*order)).collect();
                contract(set, combination, &bases, &outers, &mut targets);
                continue;
            }
            for ((_, order), target) in group.members.iter().zip(&mut targets) {
                contract(set, combination, &modes(*order), std::slice::from_ref(&bases), std::slice::from_mut(target));
            }
        }
        Ok(())
    }
}

/// The index of `item`, which is added if it is not there.
fn index_of<T: PartialEq>(items: &mut Vec<T>, item: T) -> usize {
    items.iter().position(|known| *known == item).unwrap_or_else(|| {
        items.push(item);
        items.len() - 1
    })
}
