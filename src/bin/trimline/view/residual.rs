//! The residual of the equation over a patch, for colouring.

use serde::Serialize;

use trimline::numeric::{NodeKind, nodes};
use trimline::verify::residuals;

use super::live::Live;
use super::server::Question;
use crate::failure::Failure;

/// Samples across and along.
const GRID: [usize; 2] = [33, 65];

/// The residual of every patch on a regular grid.
#[derive(Serialize)]
pub struct Residual {
    patches: Vec<Field>,
}

/// Values on a regular grid over u and v, u-major, both ends included.
#[derive(Serialize)]
struct Field {
    rows: usize,
    columns: usize,
    /// The largest component of the residual over the equation's largest term.
    values: Vec<f32>,
}

/// The residuals at the page's instant and values.
pub fn of(live: &Live, question: &Question) -> Result<Residual, Failure> {
    live.answer_with(&question.changes, question.time, |answerable| {
        let spec = answerable.spec;
        let mut patches = Vec::new();
        for (patched, solved) in &answerable.patches {
            let (patch, domain) = (patched.prepared.patch(), &patched.prepared.domain);
            let surface = &*solved.solution.surface;
            let (u, v) = (nodes(NodeKind::Ends, GRID[0], domain.u), nodes(NodeKind::Ends, GRID[1], domain.v));
            let at = (u.as_slice(), v.as_slice(), solved.time);
            let found = residuals(&spec.problem, patch, surface, &spec.bindings, at);
            let values = found.map_err(|finding| spec.fault(finding))?.into_iter().map(|value| value as f32).collect();
            patches.push(Field { rows: GRID[0], columns: GRID[1], values });
        }
        Ok(Residual { patches })
    })
}
