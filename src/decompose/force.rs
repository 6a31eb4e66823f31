//! The force of an equation, split into what has a finite closure and functions that have none.
//!
//! `q = q_closed + Σ_j a_j(u) f_j(v, t)`, where derivatives of each f_j that the equation takes are ever new functions. What
//! remains of the f_j in a series has a finite closure; a series for each f_j needs no knowledge of the a_j.

use super::Decomposition;
use super::closure::{check_closes, differentiated};
use super::expand::{Forms, expand};
use crate::diagnostic::Diagnostic;
use crate::expr::{ExprId, Graph};
use crate::limits::Limits;

/// A force that was split.
#[derive(Debug, Clone)]
pub struct SplitForce {
    /// The decomposition's graph, extended by what splitting made.
    pub graph: Graph,
    /// x, y and z of what has a finite closure.
    pub closed: [ExprId; 3],
    /// The f_j in order of first use, each with x, y and z of its a_j. An f_j that cannot be separated depends on u.
    pub open: Vec<(ExprId, [ExprId; 3])>,
}

/// Splits the force of `decomposition`.
///
/// # Errors
/// [`Code::LimitReached`](crate::diagnostic::Code::LimitReached) when its expansion grows past its limit.
pub fn split_force(decomposition: &Decomposition, limits: &Limits) -> Result<SplitForce, Diagnostic> {
    let mut graph = decomposition.graph.clone();
    let operator = &decomposition.operator;
    let variables = differentiated(operator);
    let zero = graph.integer(0);
    let mut forms = Forms::default();
    let mut closed = [zero; 3];
    let mut open: Vec<(ExprId, [ExprId; 3])> = Vec::new();
    for (component, (sum, force)) in closed.iter_mut().zip(operator.force).enumerate() {
        let monomials = expand(&mut graph, force, &mut forms, limits).map_err(|finding| finding.at(operator.origin))?;
        let mut terms = Vec::with_capacity(monomials.len());
        for (function, amplitude) in monomials {
            if check_closes(&graph, function, variables, None).is_ok() {
                terms.push(graph.product([amplitude, function]));
                continue;
            }
            let known = open.iter().position(|(known, _)| *known == function);
            let index = known.unwrap_or(open.len());
            if known.is_none() {
                open.push((function, [zero; 3]));
            }
            if let Some(slot) = open.get_mut(index).and_then(|(_, each)| each.get_mut(component)) {
                *slot = amplitude;
            }
        }
        *sum = graph.sum(terms);
    }
    Ok(SplitForce { graph, closed, open })
}
