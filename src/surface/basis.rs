//! Basis functions F_j(v, t), or of u and t, and their derivatives as compiled programs.

use std::sync::{Arc, Mutex, PoisonError};

use rustc_hash::FxHashMap;

use crate::diagnostic::{Code, Diagnostic, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile, first_non_finite};
use crate::expr::{Derivative, ExprId, Graph, Notation, Variable};
use crate::limits::Limits;

/// Functions of v and t, or of u and t, that can be evaluated together with any of their derivatives.
///
/// A derivative is made and compiled when it is first asked for, and kept.
pub struct Basis {
    functions: Vec<(ExprId, Option<Span>)>,
    names: Vec<String>,
    along: Variable,
    compiled: Mutex<Compiled>,
    backend: Backend,
    graph_nodes: usize,
}

/// What grows when a new derivative is asked for.
struct Compiled {
    graph: Graph,
    evaluators: FxHashMap<Derivative, Arc<dyn Evaluator>>,
}

/// Longer functions are cut in messages.
const NAME_BYTES: usize = 80;

impl Basis {
    /// The `functions` of `graph`, each with the place it comes from.
    #[must_use]
    pub fn new(graph: Graph, functions: Vec<(ExprId, Option<Span>)>, backend: Backend, limits: &Limits) -> Basis {
        let name = |(expr, _): &(ExprId, Option<Span>)| {
            graph.text(*expr, Notation::Ascii, NAME_BYTES).unwrap_or_else(|_| "a long expression".to_owned())
        };
        let names = functions.iter().map(name).collect();
        let compiled = Mutex::new(Compiled { graph, evaluators: FxHashMap::default() });
        Basis { functions, names, along: Variable::V, compiled, backend, graph_nodes: limits.graph_nodes }
    }

    /// The basis for functions of u and t: everything said about v then holds for u.
    #[must_use]
    pub fn in_u(self) -> Basis {
        Basis { along: Variable::U, ..self }
    }

    /// The text of every function; long ones are cut.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
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

    /// A derivative of every function at every sample `(v, t)`, row after row: function j at sample i is
    /// `values[j * v.len() + i]`. `derivative.u` is ignored.
    ///
    /// # Errors
    /// [`Code::NotDifferentiable`] for a derivative that does not exist, [`Code::LimitReached`] for one that grows too
    /// large, [`Code::DataNotFinite`] for the first value that is not finite, with its function.
    pub fn values(&self, derivative: Derivative, params: &[f64], v: &[f64], t: &[f64]) -> Result<Vec<f64>, Diagnostic> {
        let derivative = match self.along {
            Variable::U => Derivative::new(derivative.v, 0, derivative.t),
            _ => Derivative { u: 0, ..derivative },
        };
        let evaluator = self.evaluator(derivative)?;
        let mut values = vec![0.0; self.len() * v.len()];
        // The functions depend on u or on v, never on both.
        evaluator
            .evaluate(params, Samples { u: v, v, t }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        match first_non_finite(&values, v.len()) {
            None => Ok(values),
            Some((function, sample, value)) => {
                Err(self.not_finite(derivative, function, value, (v.get(sample), t.get(sample))))
            }
        }
    }

    fn evaluator(&self, derivative: Derivative) -> Result<Arc<dyn Evaluator>, Diagnostic> {
        // A panic elsewhere cannot leave the graph inconsistent: it only ever grows.
        let mut guard = self.compiled.lock().unwrap_or_else(PoisonError::into_inner);
        let Compiled { graph, evaluators } = &mut *guard;
        if let Some(evaluator) = evaluators.get(&derivative) {
            return Ok(Arc::clone(evaluator));
        }
        let mut outputs = Vec::with_capacity(self.functions.len());
        for (expr, origin) in &self.functions {
            let result = graph.derivative_within(*expr, derivative, self.graph_nodes);
            outputs.push(result.map_err(|fault| fault.to_diagnostic(derivative, self.graph_nodes).at(*origin))?);
        }
        let (evaluator, _) = compile(Program::compile(graph, &outputs), self.backend);
        evaluators.insert(derivative, Arc::clone(&evaluator));
        Ok(evaluator)
    }

    fn not_finite(
        &self,
        derivative: Derivative,
        function: usize,
        value: f64,
        (v, t): (Option<&f64>, Option<&f64>),
    ) -> Diagnostic {
        let name = self.names.get(function).map_or("?", String::as_str);
        let origin = self.functions.get(function).and_then(|(_, origin)| *origin);
        let of =
            if derivative == Derivative::NONE { String::new() } else { format!("the derivative `{derivative}` of ") };
        let at = |at: Option<&f64>| at.copied().unwrap_or(f64::NAN);
        let along = self.along.name();
        let message =
            format!("{of}`{name}` (basis function F{}) is {value} at {along} = {}, t = {}", function + 1, at(v), at(t));
        Diagnostic::new(Code::DataNotFinite, message)
            .at(origin)
            .hint("boundary data must be finite on the whole domain; change the function or the domain")
    }
}
