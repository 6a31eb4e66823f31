//! Nodes for the unknowns of a block, with everything that is evaluated there.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::block::Tables;
use super::system::evaluate;
use super::{ExactSolver, MANY_NODES, Progress};
use crate::diagnostic::{Code, Diagnostic};
use crate::features::Features;
use crate::kernels::Rows;
use crate::numeric::{NodeKind, nodes};
use crate::trial::{CorrectedTrial, IntegratedLegendre, Modes};

/// The equation and the functions of u at some nodes.
#[derive(Clone)]
pub(super) struct Discretisation {
    pub tables: Tables,
    /// The entries of the system, each at every node, or once for all if it does not depend on u.
    pub entries: Vec<Vec<f64>>,
    /// By function and component.
    pub forces: Vec<Vec<f64>>,
}

impl ExactSolver {
    /// The functions of u with `terms` trial functions.
    pub(super) fn modes(&self, terms: usize, progress: &mut Progress<'_>) -> Result<Arc<CorrectedTrial>, Diagnostic> {
        if let Some(known) = progress.modes.get(&terms) {
            return Ok(Arc::clone(known));
        }
        let family = Arc::new(IntegratedLegendre::new(self.order, terms));
        let modes = CorrectedTrial::new(family, terms, progress.range, &progress.functionals).ok_or_else(|| {
            let message = "with these parameters the constraints do not determine a surface";
            Diagnostic::new(Code::DependentConstraints, message)
        })?;
        let modes = Arc::new(modes);
        progress.modes.insert(terms, Arc::clone(&modes));
        Ok(modes)
    }

    /// `count` nodes, with tables of at least `terms` trial functions; if `count` is [`MANY_NODES`], also nodes where entries
    /// and forces are narrow.
    pub(super) fn discretise(
        &self,
        count: usize,
        terms: usize,
        progress: &mut Progress<'_>,
    ) -> Result<Arc<Discretisation>, Diagnostic> {
        // Functions solved before may have more terms than this block will.
        let most = progress.solved.iter().flatten().map(|rows| rows.nrows() - self.orders.len()).max().unwrap_or(0);
        let wanted = terms.max(most);
        if let Some(known) = progress.discretisations.get(&count)
            && known.tables.values.first().is_some_and(|table| table.ncols() >= wanted + self.orders.len())
        {
            return Ok(Arc::clone(known));
        }
        let modes = self.modes(wanted, progress)?;
        let mut u = nodes(NodeKind::Gauss, count, progress.range);
        if count == MANY_NODES {
            u = Features::refined(&progress.features, &u, progress.range);
        }
        let (orders, mut tables): (Vec<usize>, _) = ((0..=self.order).collect(), Vec::new());
        modes.tabulate(&orders, &u, &mut tables);
        let matrix = |rows: &Rows| DMatrix::from_iterator(u.len(), modes.count(), rows.iter().flatten().copied());
        let values = tables.iter().map(matrix).collect();
        let tables = Tables { values, cardinal: self.orders.len() };
        let entries = self.entries_at(progress.params, &u)?;
        let forces = if self.has_force { evaluate(&*self.force_values, progress.params, &u)? } else { Vec::new() };
        if forces.iter().chain(entries.iter().flatten()).any(|value| !value.is_finite()) {
            let message = "a coefficient or the force of the equation is not finite inside the domain";
            return Err(Diagnostic::new(Code::DataNotFinite, message));
        }
        let forces = forces.chunks(u.len().max(1)).map(<[f64]>::to_vec).collect();
        let discretisation = Arc::new(Discretisation { tables, entries, forces });
        progress.discretisations.insert(count, Arc::clone(&discretisation));
        Ok(discretisation)
    }

    /// The entries of the system at the nodes, or at the first of them if they do not depend on u.
    pub(super) fn entries_at(&self, params: &[f64], u: &[f64]) -> Result<Vec<Vec<f64>>, Diagnostic> {
        let at = if self.entries_vary { u } else { u.get(..1).unwrap_or(&[]) };
        let entries = evaluate(&*self.entry_values, params, at)?;
        Ok(entries.chunks(at.len().max(1)).map(<[f64]>::to_vec).collect())
    }
}
