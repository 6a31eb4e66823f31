//! What a patch states, compiled: its boundary data and its equation, by the interpreter.

use std::sync::Arc;

use super::sides;
use crate::diagnostic::{Code, Diagnostic};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{ExprId, Graph};
use crate::problem::{Bindings, Patch};

/// The expressions of one patch as programs: for any parameters, at any instant.
pub struct Programs {
    /// The data of each condition, in order: those at fixed u, then those at fixed v.
    pub(super) sides: Vec<VectorProgram>,
    pub(super) force: VectorProgram,
    /// The coefficient of each term of the equation.
    pub(super) coefficients: Vec<VectorProgram>,
}

impl Programs {
    /// Compiles what `patch`, whose expressions are in `graph`, states.
    #[must_use]
    pub fn compile(graph: &Graph, patch: &Patch) -> Programs {
        let terms = &patch.operator.terms;
        Programs {
            sides: sides(patch).map(|side| VectorProgram::compile(graph, side.value)).collect(),
            force: VectorProgram::compile(graph, &patch.operator.force),
            coefficients: terms.iter().map(|term| VectorProgram::compile(graph, &term.coefficient)).collect(),
        }
    }
}

/// Three expressions.
pub(super) struct VectorProgram {
    evaluator: Arc<dyn Evaluator>,
    /// Whether any depends on u or v.
    varies: bool,
}

impl VectorProgram {
    pub(super) fn compile(graph: &Graph, expressions: &[ExprId; 3]) -> VectorProgram {
        let (evaluator, _) = compile(Program::compile(graph, expressions), Backend::Interpreter);
        let varies = expressions.iter().map(|expr| graph.dependence(*expr)).any(|depends| depends.u || depends.v);
        VectorProgram { evaluator, varies }
    }

    /// The values on a grid, component after component, u-major.
    pub(super) fn on_grid(
        &self,
        bindings: &Bindings,
        (u, v, t): (&[f64], &[f64], f64),
    ) -> Result<Vec<f64>, Diagnostic> {
        let points = u.len() * v.len();
        if !self.varies {
            let everywhere = self.at(bindings, Samples { u: &[0.0], v: &[0.0], t: &[t] })?;
            return Ok(everywhere.into_iter().flat_map(|value| std::iter::repeat_n(value, points)).collect());
        }
        let us: Vec<f64> = u.iter().flat_map(|&u| v.iter().map(move |_| u)).collect();
        let vs: Vec<f64> = u.iter().flat_map(|_| v.iter().copied()).collect();
        self.at(bindings, Samples { u: &us, v: &vs, t: &vec![t; points] })
    }

    /// The values at samples, row after row.
    pub(super) fn at(&self, bindings: &Bindings, samples: Samples<'_>) -> Result<Vec<f64>, Diagnostic> {
        let mut values = vec![0.0; 3 * samples.u.len()];
        self.evaluator
            .evaluate(bindings.as_slice(), samples, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        Ok(values)
    }
}
