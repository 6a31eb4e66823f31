//! Surfaces given by expressions.

use super::Surface;
use crate::diagnostic::{Code, Diagnostic};
use crate::eval::{Backend, Program, Samples, compile};
use crate::expr::Derivative;
use crate::limits::Limits;
use crate::problem::{Bindings, PrimarySurface, Problem};

/// A primary surface with numbers for its params; u and v are its own parameters.
///
/// Every call differentiates and compiles anew: it is for judging and showing, a few calls of many points each.
pub struct SymbolicSurface<'a> {
    problem: &'a Problem,
    primary: &'a PrimarySurface,
    bindings: &'a Bindings,
    limits: &'a Limits,
}

impl<'a> SymbolicSurface<'a> {
    /// `primary`, a surface of `problem`, with the numbers in `bindings`.
    #[must_use]
    pub fn new(
        problem: &'a Problem,
        primary: &'a PrimarySurface,
        bindings: &'a Bindings,
        limits: &'a Limits,
    ) -> SymbolicSurface<'a> {
        SymbolicSurface { problem, primary, bindings, limits }
    }
}

impl Surface for SymbolicSurface<'_> {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let mut graph = self.problem.graph.clone();
        let mut outputs = self.primary.position;
        // The derivatives come on top of what the document fills of the limit.
        let allowed = graph.size().saturating_add(self.limits.graph_nodes);
        for expr in &mut outputs {
            let result = graph.derivative_within(*expr, derivative, allowed);
            *expr = result.map_err(|fault| fault.to_diagnostic(derivative, allowed).at(self.primary.origin))?;
        }
        let column =
            |index: usize| -> Vec<f64> { points.iter().filter_map(|point| point.get(index)).copied().collect() };
        let (u, v, t) = (column(0), column(1), column(2));
        let (evaluator, _) = compile(Program::compile(&graph, &outputs), Backend::Interpreter);
        let mut rows = vec![0.0; 3 * points.len()];
        evaluator
            .evaluate(self.bindings.as_slice(), Samples { u: &u, v: &v, t: &t }, &mut rows)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        for (component, row) in rows.chunks(points.len().max(1)).enumerate() {
            for ((value, x), [u, v, t]) in values.iter_mut().zip(row).zip(points) {
                if !x.is_finite() {
                    let what = if derivative == Derivative::NONE { "" } else { "a derivative of " };
                    let message = format!("{what}the surface `{}` is {x} at ({u}, {v}), t = {t}", self.primary.name);
                    return Err(Diagnostic::new(Code::DataNotFinite, message)
                        .at(self.primary.origin)
                        .hint("a surface must be smooth where it is joined or shown"));
                }
                if let Some(slot) = value.get_mut(component) {
                    *slot = *x;
                }
            }
        }
        Ok(())
    }
}
