//! Values of a solved surface: its basis, its grid, points anywhere.

use std::hint::black_box;

use trimline::diagnostic::Diagnostic;
use trimline::expr::Derivative;

use crate::failure::Failure;

use super::clock::Clock;
use super::machine::Machine;
use super::{Row, Subject};

/// Points of the basis in one repetition, in blocks that stay in the caches.
const BASIS_POINTS: usize = 64 * BLOCK;
const BLOCK: usize = 1024;
/// Points anywhere in one repetition.
const SCATTERED: usize = 1 << 14;

pub fn measure(subject: &Subject<'_>, clock: &Clock, machine: &Machine) -> Result<Vec<Row>, Failure> {
    let fault = |finding: Diagnostic| subject.spec.fault(finding);
    let mut rows = basis(subject, clock).map_err(fault)?;
    rows.extend(grid(subject, clock, machine).map_err(fault)?);
    rows.push(scattered(subject, clock).map_err(fault)?);
    Ok(rows)
}

/// Every basis function with the derivatives of the equation.
fn basis(subject: &Subject<'_>, clock: &Clock) -> Result<Vec<Row>, Diagnostic> {
    let about = "basis functions and derivatives, a point";
    let Some(surface) = subject.solved.solution.surface.as_separable() else {
        return Ok(vec![Row::none("basis_ns_per_point", about, "ns")]);
    };
    let derivatives = subject.derivatives();
    let mut jet = surface.basis.jet(&derivatives)?;
    let (v, t): (Vec<f64>, Vec<f64>) = subject.scattered(BASIS_POINTS).iter().map(|[_, v, t]| (*v, *t)).unzip();
    let seconds = clock.fastest(|| {
        let mut blocks = v.chunks(BLOCK).zip(t.chunks(BLOCK));
        let evaluated =
            blocks.try_for_each(|block| surface.basis.evaluate((&derivatives, &mut jet), &surface.params, block));
        black_box(jet.row(0));
        evaluated
    })?;
    Ok(vec![Row::new("basis_ns_per_point", about, "ns", 1e9 * seconds / BASIS_POINTS as f64)])
}

/// Positions on a grid.
fn grid(subject: &Subject<'_>, clock: &Clock, machine: &Machine) -> Result<Vec<Row>, Diagnostic> {
    let (surface, time) = (&subject.solved.solution.surface, subject.solved.time);
    let [u, v] = subject.axes();
    let vertices = u.len() * v.len();
    let mut values = vec![[0.0; 3]; vertices];
    let seconds = clock.fastest(|| surface.evaluate_grid(Derivative::NONE, (&u, &v, time), black_box(&mut values)))?;
    let bytes = size_of_val(values.as_slice()) as f64 / seconds;
    Ok(vec![
        Row::new("grid_ns_per_vertex", "grid of positions, a vertex", "ns", 1e9 * seconds / vertices as f64),
        Row::new("grid_gb_per_s", "grid of positions, written", "GB/s", 1e-9 * bytes)
            .of_limit(bytes / machine.store, "the store bandwidth"),
    ])
}

/// Positions at points anywhere.
fn scattered(subject: &Subject<'_>, clock: &Clock) -> Result<Row, Diagnostic> {
    let surface = &subject.solved.solution.surface;
    let mut points = subject.scattered(SCATTERED);
    // Fitted solutions of moving problems hold at one instant.
    points.iter_mut().for_each(|point| point[2] = subject.solved.time);
    let mut values = vec![[0.0; 3]; points.len()];
    let seconds = clock.fastest(|| surface.evaluate(Derivative::NONE, &points, black_box(&mut values)))?;
    Ok(Row::new("scattered_ns_per_point", "positions anywhere, a point", "ns", 1e9 * seconds / points.len() as f64))
}
