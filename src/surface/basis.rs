//! Basis functions F_j(v, t), or of u and t, and their derivatives as compiled programs.

use super::Functions;
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::eval::{Backend, JetValues, Program, Samples, first_non_finite};
use crate::expr::{Derivative, ExprId, Graph, Notation, Variable};
use crate::limits::Limits;

/// Functions of v and t, or of u and t, that can be evaluated together with any of their derivatives.
///
/// A derivative is made and compiled when it is first asked for, and kept.
pub struct Basis {
    functions: Functions,
    names: Vec<String>,
    along: Variable,
}

/// Longer functions are cut in messages.
const NAME_BYTES: usize = 80;

impl Basis {
    /// The `functions` of `graph`, each with the place it comes from.
    #[must_use]
    pub fn new(graph: &Graph, functions: &[(ExprId, Option<Span>)], backend: Backend, limits: &Limits) -> Basis {
        let name = |(expr, _): &(ExprId, Option<Span>)| {
            graph.text(*expr, Notation::Ascii, NAME_BYTES).unwrap_or_else(|_| "a long expression".to_owned())
        };
        let names = functions.iter().map(name).collect();
        Basis { functions: Functions::new(graph, functions, backend, limits), names, along: Variable::V }
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
        let derivative = self.own(derivative);
        // The functions depend on u or on v, never on both.
        let values = self.functions.values(derivative, params, Samples { u: v, v, t })?;
        match first_non_finite(&values, v.len()) {
            None => Ok(values),
            Some((function, sample, value)) => {
                Err(self.not_finite(derivative, function, value, (v.get(sample), t.get(sample))))
            }
        }
    }

    /// Room for the values of several derivatives of every function, all functions of the first derivative, then of the
    /// next; for [`Basis::evaluate`] of this basis.
    ///
    /// # Errors
    /// [`Code::NotDifferentiable`] for a derivative that does not exist, [`Code::LimitReached`] for one that grows too
    /// large.
    pub fn jet(&self, derivatives: &[Derivative]) -> Result<JetValues, Diagnostic> {
        let derivatives: Vec<Derivative> = derivatives.iter().map(|derivative| self.own(*derivative)).collect();
        Ok(JetValues::new(self.functions.jet(&derivatives)?))
    }

    /// Evaluates the `derivatives` that `jet` was made for at every sample `(v, t)`.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`] for the first value that is not finite, with its function.
    pub fn evaluate(
        &self,
        (derivatives, jet): (&[Derivative], &mut JetValues),
        params: &[f64],
        (v, t): (&[f64], &[f64]),
    ) -> Result<(), Diagnostic> {
        jet.evaluate(params, Samples { u: v, v, t })
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        let Some((output, sample, value)) = jet.first_non_finite() else { return Ok(()) };
        let count = self.len().max(1);
        let derivative = derivatives.get(output / count).copied().unwrap_or(Derivative::NONE);
        Err(self.not_finite(derivative, output % count, value, (v.get(sample), t.get(sample))))
    }

    /// A derivative in v and t as one of the functions, which depend on u or on v.
    fn own(&self, derivative: Derivative) -> Derivative {
        match self.along {
            Variable::U => Derivative::new(derivative.v, 0, derivative.t),
            _ => Derivative { u: 0, ..derivative },
        }
    }

    /// The values of v, or of u, inside `range` at instant `t` at which functions are put together of pieces.
    ///
    /// # Errors
    /// When parameters are missing.
    pub fn breaks(&self, params: &[f64], range: [f64; 2], t: f64) -> Result<Vec<f64>, Diagnostic> {
        self.functions.breaks(params, range, t)
    }

    /// One program for some derivatives of every function: all functions of the first derivative, then of the next.
    ///
    /// # Errors
    /// [`Code::NotDifferentiable`] for a derivative that does not exist, [`Code::LimitReached`] for one that grows too
    /// large.
    pub fn program(&self, derivatives: &[Derivative]) -> Result<Program, Diagnostic> {
        self.functions.program(derivatives)
    }

    fn not_finite(
        &self,
        derivative: Derivative,
        function: usize,
        value: f64,
        (v, t): (Option<&f64>, Option<&f64>),
    ) -> Diagnostic {
        let name = self.names.get(function).map_or("?", String::as_str);
        let origin = self.functions.origin(function);
        let of =
            if derivative == Derivative::NONE { String::new() } else { format!("the derivative `{derivative}` of ") };
        let at = |at: Option<&f64>| Shortest(at.copied().unwrap_or(f64::NAN));
        let along = self.along.name();
        let message =
            format!("{of}`{name}` (basis function F{}) is {value} at {along} = {}, t = {}", function + 1, at(v), at(t));
        Diagnostic::new(Code::DataNotFinite, message)
            .at(origin)
            .hint("boundary data must be finite on the whole domain; change the function or the domain")
    }
}
