//! The closure of a basis under the derivatives in v and t that the equation takes.
//!
//! Input: a [`Decomposition`]; output: a [`Closure`], functions F_1 … F_M that begin with the basis and satisfy
//! `∂F_j = Σ_k A_jk F_k` for each of those derivatives, with coefficients A in the params (docs/methods.md, X1).
//! On a closed basis the equation becomes a finite system of ordinary differential equations in u.
//!
//! Polynomials times exp, sin, cos, sinh and cosh of affine arguments, their products and powers, close after
//! finitely many steps. For anything else the factor that does not is named.

use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

use super::Decomposition;
use super::expand::{Forms, Monomials, expand};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, ExprId, Function, Graph, Node, Notation, Variable};
use crate::limits::Limits;
use crate::problem::PdeOperator;

/// A basis that is closed under the equation's derivatives in v and t.
#[derive(Debug, Clone)]
pub struct Closure {
    /// The decomposition's graph, extended by what the closure made.
    pub graph: Graph,
    /// The functions: the basis, in order, then those added, each with the place of what it came from.
    pub functions: Vec<(ExprId, Option<Span>)>,
    /// The matrix A of each derivative in v and t of the equation.
    pub derivatives: Vec<DerivativeMatrix>,
    /// The x, y and z of the force in front of each function, functions of u and the params.
    pub force: Vec<[ExprId; 3]>,
}

/// `∂F_j = Σ_k A_jk F_k`
#[derive(Debug, Clone)]
pub struct DerivativeMatrix {
    /// Which derivative.
    pub orders: Derivative,
    /// For each function j, the pairs (k, A_jk) that are not zero.
    pub rows: Vec<Vec<(usize, ExprId)>>,
}

/// Closes the basis of `decomposition`, enlarged by the functions of the force.
///
/// # Errors
/// [`Code::UnsupportedByMethod`] names the factor without a finite closure; [`Code::LimitReached`] when there
/// are more functions than [`Limits::closure`].
pub fn close(decomposition: &Decomposition, limits: &Limits) -> Result<Closure, Diagnostic> {
    let mut graph = decomposition.graph.clone();
    let operator = &decomposition.operator;
    let mut functions: IndexMap<ExprId, Option<Span>, FxBuildHasher> =
        decomposition.basis.iter().map(|function| (function.expr, function.origin)).collect();
    let mut forms = Forms::default();
    let mut force_terms: Vec<Monomials> = Vec::new();
    for component in operator.force {
        let monomials =
            expand(&mut graph, component, &mut forms, limits).map_err(|finding| finding.at(operator.origin))?;
        functions.extend(monomials.keys().map(|function| (*function, operator.origin)));
        force_terms.push(monomials);
    }
    let wanted = operator.basis_derivatives();
    let mut derivatives: Vec<DerivativeMatrix> =
        wanted.into_iter().map(|orders| DerivativeMatrix { orders, rows: Vec::new() }).collect();
    let variables = differentiated(operator);
    let mut next = 0;
    while let Some((&function, &origin)) = functions.get_index(next) {
        check_closes(&graph, function, variables, origin)?;
        // Derivatives of `(v - c)^5 (v - d)^5` end in first powers. Parts of these would have coefficients as large as c and
        // d, whose effects cancel.
        forms.keep_bases(&graph, function);
        for DerivativeMatrix { orders, rows } in &mut derivatives {
            let derivative = super::bounded_derivative(&mut graph, function, *orders, limits, origin)?;
            let monomials = expand(&mut graph, derivative, &mut forms, limits).map_err(|finding| finding.at(origin))?;
            let mut row = Vec::with_capacity(monomials.len());
            for (monomial, coefficient) in monomials {
                let index = functions.get_index_of(&monomial);
                let index = index.unwrap_or_else(|| functions.insert_full(monomial, origin).0);
                row.push((index, coefficient));
            }
            rows.push(row);
        }
        if functions.len() > limits.closure {
            let message = format!("the closure has more functions than the limit `closure` of {}", limits.closure);
            return Err(Diagnostic::new(Code::LimitReached, message).at(origin));
        }
        next += 1;
    }
    let zero = graph.integer(0);
    let force = functions
        .keys()
        .map(|function| {
            let mut vector = [zero; 3];
            for (slot, monomials) in vector.iter_mut().zip(&force_terms) {
                *slot = monomials.get(function).copied().unwrap_or(zero);
            }
            vector
        })
        .collect();
    Ok(Closure { graph, functions: functions.into_iter().collect(), derivatives, force })
}

/// Whether `operator` takes derivatives in v, and in t.
pub(super) fn differentiated(operator: &PdeOperator) -> [bool; 2] {
    let derivatives = operator.basis_derivatives();
    [Variable::V, Variable::T].map(|variable| derivatives.iter().any(|orders| orders.order(variable) > 0))
}

/// Refuses a function that has a factor without a finite closure under the derivatives in v and t that occur.
pub(super) fn check_closes(
    graph: &Graph,
    function: ExprId,
    [in_v, in_t]: [bool; 2],
    origin: Option<Span>,
) -> Result<(), Diagnostic> {
    let factors = match graph.node(function) {
        Node::Product(factors) => factors.to_vec(),
        _ => vec![function],
    };
    let is_differentiated = |factor: &ExprId| {
        let dependence = graph.dependence(*factor);
        (dependence.v && in_v) || (dependence.t && in_t)
    };
    let offending = |factor: &ExprId| is_differentiated(factor) && !factor_closes(graph, *factor);
    let Some(factor) = factors.into_iter().find(offending) else { return Ok(()) };
    let dependence = graph.dependence(factor);
    let by = match (dependence.v && in_v, dependence.t && in_t) {
        (true, true) => "v and t",
        (true, false) => "v",
        _ => "t",
    };
    let text = graph.text(factor, Notation::Ascii, 80).unwrap_or_else(|_| "a long expression".to_owned());
    let message = format!("`{text}` has no finite closure: its derivatives in {by} are ever new functions");
    Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(origin).hint(
        "polynomials times exp, sin, cos, sinh and cosh of affine arguments in v and t have one; a fitted method takes any function",
    ))
}

fn factor_closes(graph: &Graph, factor: ExprId) -> bool {
    match graph.node(factor) {
        Node::Number(_) | Node::Variable(_) => true,
        Node::Power(base, exponent) => {
            let is_natural = graph.as_number(*exponent).and_then(|number| number.as_integer()).is_some_and(|n| n > 0);
            is_natural && factor_closes(graph, *base)
        }
        Node::Sum(_) => is_affine(graph, factor),
        Node::Call(Function::Exp | Function::Sin | Function::Cos | Function::Sinh | Function::Cosh, arguments) => {
            arguments.iter().all(|argument| is_affine(graph, *argument))
        }
        _ => false,
    }
}

/// Whether an expanded sum is of first degree in v and t together.
pub(super) fn is_affine(graph: &Graph, argument: ExprId) -> bool {
    let terms = match graph.node(argument) {
        Node::Sum(terms) => terms.to_vec(),
        _ => vec![argument],
    };
    terms.into_iter().all(|term| {
        let factors = match graph.node(term) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![term],
        };
        let mut varying = factors.into_iter().filter(|factor| !graph.dependence(*factor).is_constant());
        match (varying.next(), varying.next()) {
            (None, _) => true,
            (Some(only), None) => matches!(graph.node(only), Node::Variable(_)),
            _ => false,
        }
    })
}
