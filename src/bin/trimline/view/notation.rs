//! The problem as understood, in LaTeX: what the page shows back to its author.

use trimline::expr::{Derivative, ExprId, Graph, Node, Notation};
use trimline::problem::{BoundaryCondition, PdeOperator};

/// Longer expressions are not readable, whatever their notation.
const LONGEST: usize = 2000;

/// An expression.
pub fn expression(graph: &Graph, expr: ExprId) -> String {
    graph.text(expr, Notation::Latex, LONGEST).unwrap_or_else(|_| r"\text{(a long expression)}".to_owned())
}

/// The equation, terms on the left, force on the right.
pub fn equation(graph: &Graph, operator: &PdeOperator) -> String {
    let mut text = String::new();
    for term in &operator.terms {
        let factor = factor(graph, &term.coefficient);
        let derivative = derivative(term.derivative);
        let (sign, factor) = match factor.strip_prefix('-') {
            Some(magnitude) => (" - ", magnitude.to_owned()),
            None => (if text.is_empty() { "" } else { " + " }, factor),
        };
        text.push_str(&format!("{sign}{factor}{derivative}"));
    }
    let force = if operator.is_homogeneous(graph) { r"\mathbf{0}".to_owned() } else { vector(graph, &operator.force) };
    format!("{text} = {force}")
}

/// One boundary condition.
pub fn condition(graph: &Graph, condition: &BoundaryCondition) -> String {
    let left = derivative(Derivative::new(condition.order, 0, 0));
    let place = expression(graph, condition.u);
    format!(r"{left}\Big|_{{u = {place}}} = {}", vector(graph, &condition.value))
}

fn factor(graph: &Graph, coefficient: &[ExprId; 3]) -> String {
    let [x, y, z] = coefficient;
    match graph.node(*x) {
        _ if x != y || x != z => format!(r"{} \circ ", vector(graph, coefficient)),
        _ if graph.is_one(*x) => String::new(),
        Node::Sum(_) => format!(r"\left({}\right)", expression(graph, *x)),
        _ => format!(r"{}\,", expression(graph, *x)),
    }
}

fn vector(graph: &Graph, components: &[ExprId; 3]) -> String {
    let rows: Vec<String> = components.iter().map(|expr| expression(graph, *expr)).collect();
    format!(r"\begin{{pmatrix}} {} \end{{pmatrix}}", rows.join(r" \\ "))
}

fn derivative(derivative: Derivative) -> String {
    let orders = [("u", derivative.u), ("v", derivative.v), ("t", derivative.t)];
    let total: usize = orders.iter().map(|(_, order)| order).sum();
    let power = |order: usize| if order == 1 { String::new() } else { format!("^{{{order}}}") };
    let below = orders.iter().filter(|(_, order)| *order > 0);
    let below: Vec<String> = below.map(|(name, order)| format!(r"\partial {name}{}", power(*order))).collect();
    match total {
        0 => r"\mathbf{S}".to_owned(),
        _ => format!(r"\frac{{\partial{}\mathbf{{S}}}}{{{}}}", power(total), below.join(r"\,")),
    }
}
