//! Expansion of an expression in v and t into `Σ coefficient(params) * monomial(v, t)`.
//!
//! A loop over the nodes of the expression, operands first. Sums merge, products multiply out, integer powers of
//! sums multiply out but for those of first degree in v and t, exponents stay together but for what depends on u, arguments
//! of functions are expanded, such powers too, so that `sin(2(v + 1))` and `sin(2v + 2)` are one function. Whatever cannot
//! be taken apart is one factor. The number of monomials is bounded at every step.

use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap};

use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Function, Graph, Node};
use crate::limits::Limits;

/// Coefficients by monomial, in order of first appearance.
pub type Monomials = IndexMap<ExprId, ExprId, FxBuildHasher>;

/// Expands `expr`; u counts as a constant. Monomials whose coefficient is zero are left out.
///
/// # Errors
/// [`Code::LimitReached`] without a place, which the caller knows.
pub fn expand(graph: &mut Graph, expr: ExprId, limits: &Limits) -> Result<Monomials, Diagnostic> {
    let nodes = graph.reachable(&[expr]);
    let in_functions: Vec<ExprId> = nodes.iter().flat_map(|id| arguments(graph, *id)).collect();
    let in_functions = graph.reachable(&in_functions);
    let arguments = expand_all(graph, &in_functions, None, limits)?;
    let mut known = expand_all(graph, &nodes, Some(&arguments), limits)?;
    let mut result = known.remove(&expr).unwrap_or_default();
    result.retain(|_, coefficient| !graph.is_zero(*coefficient));
    Ok(result)
}

/// Expansions by node.
type Known = FxHashMap<ExprId, Monomials>;

/// Expands all `nodes`, given the expansions of the arguments of functions among them; `None` if `nodes` belong to arguments
/// themselves.
fn expand_all(
    graph: &mut Graph,
    nodes: &[ExprId],
    arguments: Option<&Known>,
    limits: &Limits,
) -> Result<Known, Diagnostic> {
    let mut known = Known::default();
    for &id in nodes {
        let monomials = expand_node(graph, id, (&known, arguments), limits)?;
        if graph.size() > limits.graph_nodes {
            return Err(limit("the expanded data have more distinct parts", "graph-nodes", limits.graph_nodes));
        }
        known.insert(id, monomials);
    }
    Ok(known)
}

/// The arguments of a function; none of anything else.
fn arguments(graph: &Graph, id: ExprId) -> Vec<ExprId> {
    match graph.node(id) {
        Node::Call(_, arguments) | Node::Spline(_, arguments) => arguments.to_vec(),
        _ => Vec::new(),
    }
}

fn expand_node(
    graph: &mut Graph,
    id: ExprId,
    (operands, arguments): (&Known, Option<&Known>),
    limits: &Limits,
) -> Result<Monomials, Diagnostic> {
    let one = graph.integer(1);
    if is_coefficient(graph, id) {
        return Ok([(one, id)].into_iter().collect());
    }
    let of = |id: &ExprId| operands.get(id).cloned().unwrap_or_default();
    let argument = |id: &ExprId| arguments.unwrap_or(operands).get(id).cloned().unwrap_or_default();
    match graph.node(id).clone() {
        Node::Sum(terms) => {
            let mut sum = Monomials::default();
            for term in terms.iter() {
                for (monomial, coefficient) in of(term) {
                    add(graph, &mut sum, monomial, coefficient);
                }
                bounded(&sum, limits)?;
            }
            Ok(sum)
        }
        Node::Product(factors) => {
            let mut product: Monomials = [(one, one)].into_iter().collect();
            for factor in factors.iter() {
                product = multiply(graph, &product, &of(factor), limits)?;
            }
            Ok(product)
        }
        Node::Power(base, exponent) => {
            let integer = graph.as_number(exponent).and_then(|number| number.as_integer());
            match (integer, of(&base)) {
                // Of `(v - 10)^6` for v in [9, 11] the terms are 10^6 times as large as their sum, and leave ten digits of
                // it. In functions powers are multiplied out, so that equal arguments are found.
                (Some(2..), sum) if arguments.is_some() && sum.len() > 1 && is_first_degree(graph, &sum) => {
                    let base = assemble(graph, &sum);
                    let power = graph.power(base, exponent);
                    Ok(factor(graph, power))
                }
                (Some(times), sum) if times > 0 && sum.len() > 1 => power(graph, &sum, times, limits),
                (Some(_), single) if single.len() == 1 => {
                    let raised = single.into_iter().map(|(monomial, coefficient)| {
                        (graph.power(monomial, exponent), graph.power(coefficient, exponent))
                    });
                    let raised: Vec<(ExprId, ExprId)> = raised.collect();
                    Ok(raised.into_iter().collect())
                }
                _ => Ok(factor(graph, id)),
            }
        }
        Node::Call(Function::Exp, of_exp) => {
            let Some(exponent) = of_exp.first() else { return Ok(factor(graph, id)) };
            let mut exponent = argument(exponent);
            // The exponent stays together: of `e^(-100 (v - 3)²)` the parts e^-900 and e^(600 v) leave the doubles, and
            // their product does not. Only what depends on u cannot stay in a function of v and t.
            let constant = exponent.get(&one).copied().unwrap_or_else(|| graph.integer(0));
            let (of_u, others) = split_by_u(graph, constant);
            exponent.insert(one, others);
            let exponent = assemble(graph, &exponent);
            let function = graph.call(Function::Exp, &[exponent]);
            let (constant, monomial) = split_coefficient(graph, function);
            let of_u = graph.call(Function::Exp, &[of_u]);
            Ok([(monomial, graph.product([of_u, constant]))].into_iter().collect())
        }
        Node::Call(function, of_call) => {
            let mut expanded = Vec::with_capacity(of_call.len());
            for id in of_call.iter() {
                expanded.push(assemble(graph, &argument(id)));
            }
            let value = graph.call(function, &expanded);
            Ok(factor(graph, value))
        }
        Node::Spline(call, of_call) => {
            let mut expanded = Vec::with_capacity(of_call.len());
            for id in of_call.iter() {
                expanded.push(assemble(graph, &argument(id)));
            }
            let value = graph.spline(call, &expanded);
            Ok(factor(graph, value))
        }
        _ => Ok(factor(graph, id)),
    }
}

/// Whether an expanded sum is of first degree in v and t, with coefficients that do not depend on u.
fn is_first_degree(graph: &Graph, sum: &Monomials) -> bool {
    sum.iter().all(|(monomial, coefficient)| {
        let is_linear = is_coefficient(graph, *monomial) || matches!(graph.node(*monomial), Node::Variable(_));
        is_linear && !graph.dependence(*coefficient).u
    })
}

/// Whether `expr` belongs to the coefficients. Those of a force may depend on u.
fn is_coefficient(graph: &Graph, expr: ExprId) -> bool {
    let dependence = graph.dependence(expr);
    !dependence.v && !dependence.t
}

/// `expr` as a number times one monomial; a constant, if it turned out as one.
fn factor(graph: &mut Graph, expr: ExprId) -> Monomials {
    let one = graph.integer(1);
    if is_coefficient(graph, expr) {
        return [(one, expr)].into_iter().collect();
    }
    let (number, monomial) = graph.split_factor(expr);
    [(monomial, graph.number(number))].into_iter().collect()
}

/// The terms of a sum that depend on u, and the others.
fn split_by_u(graph: &mut Graph, expr: ExprId) -> (ExprId, ExprId) {
    let terms = match graph.node(expr) {
        Node::Sum(terms) => terms.to_vec(),
        _ => vec![expr],
    };
    let (of_u, others): (Vec<ExprId>, Vec<ExprId>) = terms.into_iter().partition(|term| graph.dependence(*term).u);
    (graph.sum(of_u), graph.sum(others))
}

/// The factors of a product that belong to the coefficients, and the others.
fn split_coefficient(graph: &mut Graph, product: ExprId) -> (ExprId, ExprId) {
    let one = graph.integer(1);
    if is_coefficient(graph, product) {
        return (product, one);
    }
    let Node::Product(factors) = graph.node(product).clone() else { return (one, product) };
    // Zero times a division by zero is kept as it is.
    if factors.iter().any(|factor| graph.is_zero(*factor)) {
        return (one, product);
    }
    let (constant, varying): (Vec<ExprId>, Vec<ExprId>) =
        factors.iter().partition(|factor| is_coefficient(graph, **factor));
    (graph.product(constant), graph.product(varying))
}

fn assemble(graph: &mut Graph, monomials: &Monomials) -> ExprId {
    let terms: Vec<ExprId> =
        monomials.iter().map(|(monomial, coefficient)| graph.product([*coefficient, *monomial])).collect();
    graph.sum(terms)
}

fn add(graph: &mut Graph, sum: &mut Monomials, monomial: ExprId, coefficient: ExprId) {
    // Factors that merge can leave a number in front, and exponents that cancel a constant.
    let (factor, monomial) = split_coefficient(graph, monomial);
    let coefficient = graph.product([factor, coefficient]);
    match sum.get(&monomial).copied() {
        Some(before) => sum.insert(monomial, graph.sum([before, coefficient])),
        None => sum.insert(monomial, coefficient),
    };
}

fn multiply(graph: &mut Graph, left: &Monomials, right: &Monomials, limits: &Limits) -> Result<Monomials, Diagnostic> {
    let mut product = Monomials::default();
    for (&monomial, &coefficient) in left {
        for (&other, &factor) in right {
            let monomial = graph.product([monomial, other]);
            let coefficient = graph.product([coefficient, factor]);
            add(graph, &mut product, monomial, coefficient);
        }
        bounded(&product, limits)?;
        if graph.size() > limits.graph_nodes {
            return Err(limit("the expanded data have more distinct parts", "graph-nodes", limits.graph_nodes));
        }
    }
    Ok(product)
}

fn power(graph: &mut Graph, base: &Monomials, times: i32, limits: &Limits) -> Result<Monomials, Diagnostic> {
    let mut product = base.clone();
    for _ in 1..times {
        product = multiply(graph, &product, base, limits)?;
    }
    Ok(product)
}

fn bounded(monomials: &Monomials, limits: &Limits) -> Result<(), Diagnostic> {
    if monomials.len() <= limits.monomials {
        return Ok(());
    }
    Err(limit("this expands to more terms", "monomials", limits.monomials))
}

fn limit(what: &str, name: &str, value: usize) -> Diagnostic {
    Diagnostic::new(Code::LimitReached, format!("{what} than the limit `{name}` of {value}"))
        .hint("write it as a product or power of one function, or simplify it")
}
