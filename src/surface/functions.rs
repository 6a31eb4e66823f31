//! Functions of u, v and t as compiled programs, with all their derivatives.

use std::sync::{Arc, Mutex, PoisonError};

use rustc_hash::FxHashMap;

use super::breaks::breaks;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::eval::{Backend, Evaluator, Jet, Program, Samples, compile};
use crate::expr::{Derivative, ExprId, Graph};
use crate::limits::Limits;

/// Functions that are evaluated together.
///
/// A derivative is made and compiled when it is first asked for, and kept. It is made from the functions themselves,
/// not from others that were made before, so it has the same bits whoever asks for what first.
pub struct Functions {
    /// The graph of the functions alone.
    graph: Graph,
    functions: Vec<(ExprId, Option<Span>)>,
    compiled: Mutex<FxHashMap<Derivative, Arc<dyn Evaluator>>>,
    jets: Mutex<Vec<(Vec<Derivative>, Arc<Jet>)>>,
    backend: Backend,
    graph_nodes: usize,
}

impl Functions {
    /// The `functions` of `graph`, each with the place it comes from.
    #[must_use]
    pub fn new(graph: &Graph, functions: &[(ExprId, Option<Span>)], backend: Backend, limits: &Limits) -> Functions {
        let (exprs, origins): (Vec<ExprId>, Vec<Option<Span>>) = functions.iter().copied().unzip();
        let (graph, exprs) = graph.part(&exprs);
        let functions = exprs.into_iter().zip(origins).collect();
        Functions {
            graph,
            functions,
            compiled: Mutex::default(),
            jets: Mutex::default(),
            backend,
            graph_nodes: limits.graph_nodes,
        }
    }

    /// The number of functions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.functions.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.functions.is_empty()
    }

    /// Where function number `index` is written.
    #[must_use]
    pub fn origin(&self, index: usize) -> Option<Span> {
        self.functions.get(index).and_then(|(_, origin)| *origin)
    }

    /// A derivative of every function at every sample, row after row: function j at sample i is
    /// `values[j * samples + i]`. Values need not be finite.
    ///
    /// # Errors
    /// [`Code::NotDifferentiable`] for a derivative that does not exist, [`Code::LimitReached`] for one that grows too
    /// large.
    pub fn values(&self, derivative: Derivative, params: &[f64], samples: Samples<'_>) -> Result<Vec<f64>, Diagnostic> {
        let evaluator = self.evaluator(derivative)?;
        let mut values = vec![0.0; self.len() * samples.u.len()];
        evaluator
            .evaluate(params, samples, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        Ok(values)
    }

    /// One program for some derivatives of every function: all functions of the first derivative, then of the next.
    ///
    /// # Errors
    /// [`Code::NotDifferentiable`] for a derivative that does not exist, [`Code::LimitReached`] for one that grows too
    /// large.
    pub fn program(&self, derivatives: &[Derivative]) -> Result<Program, Diagnostic> {
        let (graph, outputs) = self.derived(derivatives)?;
        Ok(Program::compile(&graph, &outputs))
    }

    /// The same functions as [`Functions::program`], of which equal ones are computed once; kept for who asks next.
    ///
    /// # Errors
    /// As [`Functions::program`].
    pub fn jet(&self, derivatives: &[Derivative]) -> Result<Arc<Jet>, Diagnostic> {
        // A panic elsewhere leaves the list whole.
        let mut jets = self.jets.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, jet)) = jets.iter().find(|(known, _)| known == derivatives) {
            return Ok(Arc::clone(jet));
        }
        let (graph, outputs) = self.derived(derivatives)?;
        let jet = Arc::new(Jet::new(&graph, &outputs, self.backend));
        jets.push((derivatives.to_vec(), Arc::clone(&jet)));
        Ok(jet)
    }

    /// Some derivatives of every function: all functions of the first derivative, then of the next.
    fn derived(&self, derivatives: &[Derivative]) -> Result<(Graph, Vec<ExprId>), Diagnostic> {
        let mut graph = self.graph.clone();
        let mut outputs = Vec::with_capacity(derivatives.len() * self.functions.len());
        for derivative in derivatives {
            for (expr, origin) in &self.functions {
                let result = graph.derivative_within(*expr, *derivative, self.graph_nodes);
                outputs.push(result.map_err(|fault| fault.to_diagnostic(*derivative, self.graph_nodes).at(*origin))?);
            }
        }
        Ok((graph, outputs))
    }

    /// The values of the coordinate the functions depend on, inside `range` at instant `t`, at which they are put together
    /// of pieces.
    ///
    /// # Errors
    /// When parameters are missing.
    pub fn breaks(&self, params: &[f64], range: [f64; 2], t: f64) -> Result<Vec<f64>, Diagnostic> {
        let functions: Vec<ExprId> = self.functions.iter().map(|(function, _)| *function).collect();
        breaks(&self.graph, &functions, params, range, t)
    }

    fn evaluator(&self, derivative: Derivative) -> Result<Arc<dyn Evaluator>, Diagnostic> {
        // A panic elsewhere leaves the map as it was.
        let mut compiled = self.compiled.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(evaluator) = compiled.get(&derivative) {
            return Ok(Arc::clone(evaluator));
        }
        let (evaluator, _) = compile(self.program(&[derivative])?, self.backend);
        compiled.insert(derivative, Arc::clone(&evaluator));
        Ok(evaluator)
    }
}
