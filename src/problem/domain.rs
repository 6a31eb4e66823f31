//! The ranges of u, v and t.

use super::{Bindings, Problem};
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::expr::{Constant, ExprId, Graph, Number, Variable};

/// A range for each variable; the ends are constant expressions.
#[derive(Debug, Clone)]
pub struct Domain {
    /// Ends of the range of u, v and t.
    pub ends: [[ExprId; 2]; 3],
    /// Where each range is written; `None` for a default.
    pub origins: [Option<Span>; 3],
}

/// The ranges as numbers, each with its lower end below its upper end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DomainValues {
    /// Across the blend.
    pub u: [f64; 2],
    /// Along the trimlines.
    pub v: [f64; 2],
    /// Time.
    pub t: [f64; 2],
}

impl Domain {
    /// u in [0, 1], v in [0, 2π], t in [0, 1].
    pub fn standard(graph: &mut Graph) -> Domain {
        let (zero, one) = (graph.integer(0), graph.integer(1));
        let pi = graph.constant(Constant::Pi);
        let turn = graph.scale(Number::integer(2), pi);
        Domain { ends: [[zero, one], [zero, turn], [zero, one]], origins: [None; 3] }
    }

    /// The ranges as numbers.
    ///
    /// # Errors
    /// [`Code::EmptyDomain`] when a range has no extent or its ends are swapped, [`Code::ParameterNotFinite`]
    /// when an end is not finite.
    pub fn evaluate(&self, problem: &Problem, bindings: &Bindings) -> Result<DomainValues, Diagnostic> {
        self.evaluate_in(&problem.graph, bindings)
    }

    /// As [`Domain::evaluate`], with the graph of the problem.
    ///
    /// # Errors
    /// As [`Domain::evaluate`].
    pub fn evaluate_in(&self, graph: &Graph, bindings: &Bindings) -> Result<DomainValues, Diagnostic> {
        let mut values = [[0.0; 2]; 3];
        let ranges = self.ends.iter().zip(self.origins).zip(Variable::ALL).zip(&mut values);
        for (((ends, origin), variable), value) in ranges {
            let name = variable.name();
            *value = interval(graph, bindings, *ends, (&format!("the range of {name}"), name), origin)?;
        }
        let [u, v, t] = values;
        Ok(DomainValues { u, v, t })
    }
}

/// Of the larger end: the length of a range in which doubles lie dense enough for six digits.
const SHORTEST: f64 = 1e-9;

/// The ends of the range of the coordinate `name` as numbers; a finding calls the range `what`.
pub(super) fn interval(
    graph: &Graph,
    bindings: &Bindings,
    [low, high]: [ExprId; 2],
    (what, name): (&str, &str),
    origin: Option<Span>,
) -> Result<[f64; 2], Diagnostic> {
    let low = bindings.constant_in(graph, low, origin, what)?;
    let high = bindings.constant_in(graph, high, origin, what)?;
    let farthest = low.abs().max(high.abs());
    let length = high - low;
    if length.is_finite() && low < high && length >= SHORTEST * farthest {
        return Ok([low, high]);
    }
    if length == f64::INFINITY {
        let (low, high) = (Shortest(low), Shortest(high));
        let message = format!("the domain {name} in [{low}, {high}] is so long that its length is no number");
        let finding = Diagnostic::new(Code::EmptyDomain, message).at(origin);
        return Err(finding.hint(format!("measure {name} in a larger unit")));
    }
    if low < high {
        let (low, high) = (Shortest(low), Shortest(high));
        let message = format!(
            "the domain {name} in [{low}, {high}] is too short for its distance from 0: rounding leaves too few values in it"
        );
        let finding = Diagnostic::new(Code::EmptyDomain, message).at(origin);
        return Err(finding.hint(format!("measure {name} from the beginning of the domain")));
    }
    let is_reversed = low > high;
    let (low, high) = (Shortest(low), Shortest(high));
    let finding = Diagnostic::new(Code::EmptyDomain, format!("the domain {name} in [{low}, {high}] is empty"));
    let finding = if is_reversed {
        finding.hint(format!("write the smaller end first: `{name} in [{high}, {low}]`"))
    } else {
        finding.hint("the lower end must be below the upper end")
    };
    Err(finding.at(origin))
}
