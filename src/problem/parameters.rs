//! Parameters, and the numbers they stand for.

use super::Problem;
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::expr::{ExprId, Graph, SymbolId};

/// Where a parameter belongs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ParameterKind {
    /// Declared by `param`.
    Parameter,
    /// A coefficient of the equation, given by `with` or by default.
    Coefficient,
}

/// A named constant that the user may change.
#[derive(Debug, Clone)]
pub struct Parameter {
    /// The symbol expressions use.
    pub symbol: SymbolId,
    /// Its canonical name.
    pub name: String,
    /// Its value, in terms of earlier parameters.
    pub value: ExprId,
    /// The range a viewer offers, in terms of earlier parameters.
    pub interval: Option<[ExprId; 2]>,
    /// What declares it.
    pub kind: ParameterKind,
    /// Where its value is written.
    pub origin: Option<Span>,
    /// Whether the value came from outside the document, which may leave the range.
    pub is_overridden: bool,
}

/// The number behind every symbol of a problem's graph.
///
/// Changing a parameter makes new bindings; expressions, programs and decompositions stay as they are.
#[derive(Debug, Clone, PartialEq)]
pub struct Bindings {
    values: Vec<f64>,
}

impl Bindings {
    /// Evaluates every parameter in order.
    ///
    /// # Errors
    /// [`Code::ParameterNotFinite`] for a value that is infinite or NaN, [`Code::ParameterOutOfRange`] for a
    /// declared value outside its declared range.
    pub fn evaluate(problem: &Problem) -> Result<Bindings, Diagnostic> {
        let mut bindings = Bindings { values: vec![f64::NAN; problem.graph.symbols().len()] };
        for parameter in &problem.parameters {
            let name = &parameter.name;
            let value = bindings.constant(problem, parameter.value, parameter.origin, &format!("`{name}`"))?;
            if let Some(slot) = bindings.values.get_mut(parameter.symbol.index()) {
                *slot = value;
            }
            let Some([low, high]) = parameter.interval else { continue };
            let range = format!("the range of `{name}`");
            let low = bindings.constant(problem, low, parameter.origin, &range)?;
            let high = bindings.constant(problem, high, parameter.origin, &range)?;
            if !parameter.is_overridden && !(low..=high).contains(&value) {
                let (value, low, high) = (Shortest(value), Shortest(low), Shortest(high));
                return Err(Diagnostic::new(
                    Code::ParameterOutOfRange,
                    format!("`{name}` is {value}, outside [{low}, {high}]"),
                )
                .at(parameter.origin)
                .hint("widen the range or change the value"));
            }
        }
        Ok(bindings)
    }

    /// The values, one for each of [`Graph::symbols`](crate::expr::Graph::symbols).
    #[must_use]
    pub fn as_slice(&self) -> &[f64] {
        &self.values
    }

    /// The value of a constant expression, which a finding calls `what`.
    ///
    /// # Errors
    /// [`Code::ParameterNotFinite`] if it is infinite or NaN.
    pub fn constant(
        &self,
        problem: &Problem,
        expr: ExprId,
        origin: Option<Span>,
        what: &str,
    ) -> Result<f64, Diagnostic> {
        self.constant_in(&problem.graph, expr, origin, what)
    }

    /// As [`Bindings::constant`], with the graph of the problem.
    ///
    /// # Errors
    /// As [`Bindings::constant`].
    pub fn constant_in(
        &self,
        graph: &Graph,
        expr: ExprId,
        origin: Option<Span>,
        what: &str,
    ) -> Result<f64, Diagnostic> {
        let value = graph.value(expr, &self.values, [f64::NAN; 3]);
        if value.is_finite() {
            return Ok(value);
        }
        let message = format!("{what} evaluates to {}", spelled(value));
        Err(Diagnostic::new(Code::ParameterNotFinite, message)
            .at(origin)
            .hint("look for a division by zero, a logarithm or root of a negative number, or an overflow"))
    }
}

/// The name of a value that is not finite.
fn spelled(value: f64) -> &'static str {
    match value {
        _ if value.is_nan() => "NaN (not a number)",
        _ if value < 0.0 => "-infinity",
        _ => "infinity",
    }
}
