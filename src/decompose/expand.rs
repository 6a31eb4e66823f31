//! Expansion of an expression in v and t into `Σ coefficient(params) * monomial(v, t)`.
//!
//! A loop over the nodes of the expression, operands first. Sums merge, products multiply out, integer powers of
//! sums multiply out but for those of first degree in v and t, exponents stay together but for what depends on u. Arguments
//! of functions are multiplied out only to be compared: `sin((v - 9)^2)` and `sin(v^2 - 18v + 81)` are one function, which
//! is evaluated as it was written first. Whatever cannot be taken apart is one factor. The number of monomials is bounded
//! at every step.

use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

use super::closure::is_affine;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Function, Graph, Node, Number, Variable};
use crate::limits::Limits;

/// Coefficients by monomial, in order of first appearance.
pub type Monomials = IndexMap<ExprId, ExprId, FxBuildHasher>;

/// How functions are written that can be written in several ways. What shares one finds equal functions equal.
#[derive(Debug, Default)]
pub struct Forms {
    /// The arguments of functions, by what they are multiplied out.
    arguments: FxHashMap<ExprId, ExprId>,
    /// Sums of first degree that stay whole as first powers too.
    whole: FxHashSet<ExprId>,
}

impl Forms {
    /// Lets first powers stay whole of the sums whose powers are factors of `function`.
    pub fn keep_bases(&mut self, graph: &Graph, function: ExprId) {
        let factors = match graph.node(function) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![function],
        };
        for factor in factors {
            if let Node::Power(base, _) = graph.node(factor)
                && matches!(graph.node(*base), Node::Sum(_))
            {
                self.whole.insert(*base);
            }
        }
    }

    /// Of the arguments that are `multiplied_out`, the one that was met first, which may be `argument`.
    fn first(&mut self, graph: &Graph, multiplied_out: ExprId, argument: ExprId) -> ExprId {
        // Of first degree nothing cancels, and closures want to see it.
        if is_affine(graph, multiplied_out) {
            return multiplied_out;
        }
        *self.arguments.entry(multiplied_out).or_insert(argument)
    }
}

/// Expands `expr`; u counts as a constant. Monomials whose coefficient is zero are left out.
///
/// # Errors
/// [`Code::LimitReached`] without a place, which the caller knows.
pub fn expand(graph: &mut Graph, expr: ExprId, forms: &mut Forms, limits: &Limits) -> Result<Monomials, Diagnostic> {
    let nodes = graph.reachable(&[expr]);
    let in_functions: Vec<ExprId> = nodes.iter().flat_map(|id| arguments(graph, *id)).collect();
    let in_functions = graph.reachable(&in_functions);
    let multiplied_out = expand_all(graph, &in_functions, None, limits)?;
    let mut known = expand_all(graph, &nodes, Some((&multiplied_out, forms)), limits)?;
    let mut result = known.remove(&expr).unwrap_or_default();
    result.retain(|_, coefficient| !graph.is_zero(*coefficient));
    Ok(result)
}

/// Expansions by node.
type Known = FxHashMap<ExprId, Monomials>;

/// Expands all `nodes`, given how the arguments of functions among them are multiplied out; `None` multiplies everything
/// out.
fn expand_all(
    graph: &mut Graph,
    nodes: &[ExprId],
    mut written: Option<(&Known, &mut Forms)>,
    limits: &Limits,
) -> Result<Known, Diagnostic> {
    let mut known = Known::default();
    for &id in nodes {
        let written = written.as_mut().map(|(multiplied_out, forms)| (*multiplied_out, &mut **forms));
        let monomials = expand_node(graph, id, &known, written, limits)?;
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
    operands: &Known,
    mut written: Option<(&Known, &mut Forms)>,
    limits: &Limits,
) -> Result<Monomials, Diagnostic> {
    let one = graph.integer(1);
    if is_coefficient(graph, id) {
        return Ok([(one, id)].into_iter().collect());
    }
    let of = |id: &ExprId| operands.get(id).cloned().unwrap_or_default();
    let mut argument = |graph: &mut Graph, id: &ExprId| match &mut written {
        Some((multiplied_out, forms)) => {
            let multiplied_out = multiplied_out.get(id).map(|monomials| assemble(graph, monomials));
            multiplied_out.map_or(*id, |multiplied_out| forms.first(graph, multiplied_out, *id))
        }
        None => assemble(graph, &of(id)),
    };
    match graph.node(id).clone() {
        Node::Sum(terms) => {
            let mut sum = Monomials::default();
            for term in terms.iter() {
                for (monomial, coefficient) in of(term) {
                    add(graph, &mut sum, monomial, coefficient);
                }
                bounded(&sum, limits)?;
            }
            let Some((_, forms)) = written.filter(|_| is_first_degree(graph, &sum)) else { return Ok(sum) };
            let (number, base) = primitive(graph, &sum, 1);
            Ok(if forms.whole.contains(&base) { [(base, graph.number(number))].into_iter().collect() } else { sum })
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
                // it.
                (Some(times @ 2..), sum) if written.is_some() && sum.len() > 1 && is_first_degree(graph, &sum) => {
                    let (number, base) = primitive(graph, &sum, times);
                    let number = graph.number(number);
                    let power = graph.power(base, exponent);
                    Ok([(power, graph.power(number, exponent))].into_iter().collect())
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
            // The exponent stays together: of `e^(-100 (v - 3)²)` the parts e^-900 and e^(600 v) leave the doubles, and
            // their product does not. Only what depends on u cannot stay in a function of v and t.
            let mut others = of(exponent);
            let of_u = take_u(graph, &mut others);
            let exponent = match written {
                _ if graph.is_zero(of_u) => argument(graph, exponent),
                Some((multiplied_out, forms)) => {
                    let mut multiplied_out = multiplied_out.get(exponent).cloned().unwrap_or_default();
                    take_u(graph, &mut multiplied_out);
                    let (multiplied_out, others) = (assemble(graph, &multiplied_out), assemble(graph, &others));
                    forms.first(graph, multiplied_out, others)
                }
                None => assemble(graph, &others),
            };
            let function = graph.call(Function::Exp, &[exponent]);
            let (constant, monomial) = split_coefficient(graph, function);
            let of_u = graph.call(Function::Exp, &[of_u]);
            Ok([(monomial, graph.product([of_u, constant]))].into_iter().collect())
        }
        Node::Call(function, of_call) => {
            let arguments: Vec<ExprId> = of_call.iter().map(|id| argument(graph, id)).collect();
            let value = graph.call(function, &arguments);
            Ok(factor(graph, value))
        }
        Node::Spline(call, of_call) => {
            let arguments: Vec<ExprId> = of_call.iter().map(|id| argument(graph, id)).collect();
            let value = graph.spline(call, &arguments);
            Ok(factor(graph, value))
        }
        _ => Ok(factor(graph, id)),
    }
}

/// A sum of first degree as a number times a sum in which that of v, or else of t, has none: `2b - 2v` is -2 times `v - b`.
/// 1 if the power of the number `times` would leave the doubles.
fn primitive(graph: &mut Graph, sum: &Monomials, times: i32) -> (Number, ExprId) {
    let variables = [Variable::V, Variable::T].map(|variable| graph.variable(variable));
    let leading = variables.iter().find_map(|variable| sum.get(variable)).map(|coefficient| {
        match graph.as_number(*coefficient) {
            Some(number) => number,
            None => graph.split_factor(*coefficient).0,
        }
    });
    let whole = assemble(graph, sum);
    let is_bounded = |number: &Number| number.powi(times).is_some_and(|power| power.to_f64().is_normal());
    match leading.filter(is_bounded).and_then(|number| Some((number, number.powi(-1)?))) {
        Some((number, inverse)) => (number, graph.scale(inverse, whole)),
        None => (Number::integer(1), whole),
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

/// Takes out of the constant of a sum the terms that depend on u.
fn take_u(graph: &mut Graph, sum: &mut Monomials) -> ExprId {
    let one = graph.integer(1);
    let Some(constant) = sum.get(&one).copied() else { return graph.integer(0) };
    let terms = match graph.node(constant) {
        Node::Sum(terms) => terms.to_vec(),
        _ => vec![constant],
    };
    let (of_u, others): (Vec<ExprId>, Vec<ExprId>) = terms.into_iter().partition(|term| graph.dependence(*term).u);
    sum.insert(one, graph.sum(others));
    graph.sum(of_u)
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
