//! The residual of the equation over a patch, for colouring.

use serde::Serialize;

use trimline::diagnostic::{Code, Diagnostic};
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
    live.answer(&question.changes, question.time, |answerable, _| {
        let Some(answerable) = answerable else {
            return Err(Failure::Usage("the spec has errors, so there is no surface".to_owned()));
        };
        let answerable = answerable?;
        let spec = answerable.spec;
        let mut patches = Vec::new();
        for (patched, solved) in &answerable.patches {
            let (patch, domain) = (patched.prepared.patch(), &patched.prepared.domain);
            let surface = &*solved.solution.surface;
            let (u, v) = (nodes(NodeKind::Ends, GRID[0], domain.u), nodes(NodeKind::Ends, GRID[1], domain.v));
            let at = (u.as_slice(), v.as_slice(), solved.time);
            let found = residuals(&spec.problem, patch, surface, &spec.bindings, at);
            let (sums, largest) = found.map_err(|finding| spec.fault(finding))?;
            let largest = if largest > 0.0 { largest } else { 1.0 };
            let components: Vec<&[f64]> = sums.chunks(GRID[0] * GRID[1]).collect();
            let [x, y, z] = components.as_slice() else {
                return Err(spec.fault(Diagnostic::new(Code::SolutionNotFinite, "the residual has no components")));
            };
            let most = x.iter().zip(*y).zip(*z).map(|((x, y), z)| x.abs().max(y.abs()).max(z.abs()) / largest);
            patches.push(Field { rows: GRID[0], columns: GRID[1], values: most.map(|most| most as f32).collect() });
        }
        Ok(Residual { patches })
    })
}
