//! One block of the equation in one component: its numbers, its solution, and what that leaves of the equation.

use std::ops::Range;
use std::sync::Arc;

use nalgebra::DMatrix;

use super::amplification::RESONANT;
use super::block::{BlockSystem, Factorised, subtract_scaled};
use super::discretisation::Discretisation;
use super::system::Place;
use super::{Amplified, ExactSolver, Progress};
use crate::diagnostic::Diagnostic;

impl ExactSolver {
    /// The weights of the trial functions of all members, for some columns x, y, z.
    pub(super) fn solve_component(
        &self,
        members: &[usize],
        component: usize,
        columns: Range<usize>,
        discretisation: &Discretisation,
        terms: usize,
        progress: &mut Progress<'_>,
    ) -> Result<DMatrix<f64>, Diagnostic> {
        let (block, right, _) = self.block_of(members, component, discretisation, terms, progress);
        let right = right.columns(columns.start, columns.len()).into_owned();
        let j = members.first().copied().unwrap_or(0);
        if !block.determines_highest(self.order) {
            return Err(self.order_drops(j));
        }
        if right.iter().all(|value| *value == 0.0) {
            return Ok(DMatrix::zeros(members.len() * terms, columns.len()));
        }
        if right.iter().any(|value| !value.is_finite()) {
            return Err(self.overflows(j));
        }
        let factorised = self.factorised(&block, members, component, discretisation, terms, progress)?;
        // Resonance is refused above, so what is not finite here has overflowed.
        factorised.solve(&right).ok_or_else(|| self.overflows(j))
    }

    /// The factorised block, known if one of the same numbers was before, and not resonant.
    fn factorised(
        &self,
        block: &BlockSystem,
        members: &[usize],
        component: usize,
        discretisation: &Discretisation,
        terms: usize,
        progress: &mut Progress<'_>,
    ) -> Result<Arc<Factorised>, Diagnostic> {
        let key = (terms, block.numbers());
        if let Some(known) = progress.factorised.get(&key) {
            return Ok(Arc::clone(known));
        }
        let amplified = self.factorise(block, members, component, discretisation, terms)?;
        if amplified.factor > RESONANT {
            return Err(self.resonant_at(&amplified, progress));
        }
        let factorised = Arc::clone(&amplified.factorised);
        progress.factorised.insert(key, Arc::clone(&factorised));
        if progress.worst.as_ref().is_none_or(|worst| amplified.factor > worst.factor) {
            progress.worst = Some(amplified);
        }
        Ok(factorised)
    }

    /// Factorises the block and measures how it amplifies.
    fn factorise(
        &self,
        block: &BlockSystem,
        members: &[usize],
        component: usize,
        discretisation: &Discretisation,
        terms: usize,
    ) -> Result<Amplified, Diagnostic> {
        let j = members.first().copied().unwrap_or(0);
        let tables = &discretisation.tables;
        let trial = tables.cardinal..tables.cardinal + terms;
        let matrix = block.matrix(tables, trial.clone());
        if matrix.iter().any(|value| !value.is_finite()) {
            return Err(self.overflows(j));
        }
        let factorised = Factorised::new(matrix).ok_or_else(|| self.resonant(None, None, j))?;
        let definite = block.definite_matrix(tables, trial);
        let factor = factorised.amplification(&definite, block.is_symmetric(self.order));
        if !factor.is_finite() {
            return Err(self.overflows(j));
        }
        Ok(Amplified { factor, members: members.to_vec(), component, terms, factorised: Arc::new(factorised) })
    }

    /// The largest residual of a block's equations at `nodes` others than they were imposed at, relative to their
    /// largest term: where it is small, the solution is resolved.
    pub(super) fn residual_at(
        &self,
        members: &[usize],
        component: usize,
        columns: Range<usize>,
        weights: &DMatrix<f64>,
        nodes: usize,
        progress: &mut Progress<'_>,
    ) -> Result<f64, Diagnostic> {
        let terms = weights.nrows() / members.len().max(1);
        let discretisation = self.discretise(nodes, terms, progress)?;
        let nodes = discretisation.tables.values.first().map_or(0, DMatrix::nrows);
        let (block, right, largest) = self.block_of(members, component, &discretisation, nodes, progress);
        let cardinal = discretisation.tables.cardinal;
        let trial = cardinal..cardinal + terms;
        let mut residual = right.columns(columns.start, columns.len()).into_owned();
        // Single terms, not their sum: near resonance large terms cancel.
        let scale = largest.max(block.subtract_image(&discretisation.tables, trial, weights, &mut residual));
        let residual = residual.amax();
        Ok(match residual / scale {
            _ if scale == 0.0 => 0.0,
            ratio if ratio.is_nan() => f64::INFINITY,
            ratio => ratio,
        })
    }

    /// The numbers of a block, its right-hand side (force, boundary part, and functions solved before), and the
    /// largest single term of the latter.
    pub(super) fn block_of(
        &self,
        members: &[usize],
        component: usize,
        discretisation: &Discretisation,
        terms: usize,
        progress: &Progress<'_>,
    ) -> (BlockSystem, DMatrix<f64>, f64) {
        let tables = &discretisation.tables;
        let mut right = DMatrix::zeros(members.len() * terms, 3);
        for (member, &j) in members.iter().enumerate() {
            for axis in 0..3 {
                let force = discretisation.forces.get(3 * j + axis).map_or(&[][..], Vec::as_slice);
                for (slot, value) in right.view_mut((member * terms, axis), (terms, 1)).iter_mut().zip(force) {
                    *slot = *value;
                }
            }
        }
        let mut largest = right.amax();
        let mut entries = Vec::new();
        for ((place, _), values) in self.system.entries.iter().zip(&discretisation.entries) {
            let Place { component: of, equation, unknown, order } = *place;
            let Some(row) = members.iter().position(|member| *member == equation) else { continue };
            if of != component {
                continue;
            }
            let own = members.iter().position(|member| *member == unknown);
            // Inside the block the boundary part of G is known; outside all of it.
            let known = match own {
                Some(_) => Some(self.stated(unknown, progress)),
                None => progress.solved.get(unknown).cloned().flatten(),
            };
            if let (Some(known), Some(table)) = (known, tables.values.get(order)) {
                let image = table.rows(0, terms).columns(0, known.nrows()) * known;
                largest = largest.max(subtract_scaled(&mut right, row * terms, &image, values));
            }
            if let Some(column) = own {
                entries.push((order, row, column, values.clone()));
            }
        }
        (BlockSystem { entries, members: members.len() }, right, largest)
    }
}
