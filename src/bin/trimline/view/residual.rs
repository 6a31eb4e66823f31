//! The residual of the equation over a patch, for colouring.

use serde::Serialize;

use trimline::numeric::{NodeKind, nodes};
use trimline::verify::residuals;

use super::live::Live;
use super::pieces::Of;
use super::server::Question;
use crate::failure::Failure;

/// Samples across and along.
const GRID: [usize; 2] = [33, 65];

/// The residual of every patch on a regular grid; a B-spline net has none worth a colour.
#[derive(Serialize)]
pub struct Residual {
    patches: Vec<Option<Field>>,
}

/// Values on a regular grid over u and v, u-major, both ends included.
#[derive(Clone, Serialize)]
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
        let mut known: Vec<(usize, Field)> = Vec::new();
        let mut patches = Vec::with_capacity(answerable.pieces.len());
        for piece in &answerable.pieces {
            // A copy has the residual of its original, point by point.
            if let Some((_, field)) = known.iter().find(|(original, _)| *original == piece.original) {
                patches.push(Some(field.clone()));
                continue;
            }
            let Of::Patch(patched, solved) = piece.of else {
                patches.push(None);
                continue;
            };
            let (patch, domain) = (patched.prepared.patch(), &patched.prepared.domain);
            let surface = &*solved.solution.surface;
            let (u, v) = (nodes(NodeKind::Ends, GRID[0], domain.u), nodes(NodeKind::Ends, GRID[1], domain.v));
            let at = (u.as_slice(), v.as_slice(), solved.time);
            let found = residuals(&spec.problem, patch, surface, &spec.bindings, at);
            let values = found.map_err(|finding| spec.fault(finding))?.into_iter().map(|value| value as f32).collect();
            let field = Field { rows: GRID[0], columns: GRID[1], values };
            known.push((piece.original, field.clone()));
            patches.push(Some(field));
        }
        Ok(Residual { patches })
    })
}
