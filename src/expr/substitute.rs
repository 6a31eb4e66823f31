//! Rebuilding an expression with some parts replaced, and its value at one point.

use rustc_hash::FxHashMap;

use super::function::{Function, Value};
use super::graph::{Constant, ExprId, Graph, Node, Variable};

impl Graph {
    /// `expr` with every occurrence of a key of `replacements` replaced by its value, in canonical form.
    pub fn substitute(&mut self, expr: ExprId, replacements: &FxHashMap<ExprId, ExprId>) -> ExprId {
        let mut known = replacements.clone();
        for id in self.reachable(&[expr]) {
            if !known.contains_key(&id) {
                let result = self.construct(self.node(id).clone(), &known);
                known.insert(id, result);
            }
        }
        known.get(&expr).copied().unwrap_or(expr)
    }

    /// `expr` with splines that have all derivatives, those of their pieces
    /// ([`SplineCall::is_piecewise`](super::SplineCall::is_piecewise)).
    pub fn piecewise(&mut self, expr: ExprId) -> ExprId {
        let mut known: FxHashMap<ExprId, ExprId> = FxHashMap::default();
        for id in self.reachable(&[expr]) {
            let node = match self.node(id).clone() {
                Node::Spline(call, arguments) => Node::Spline(call.piecewise(), arguments),
                node => node,
            };
            let result = self.construct(node, &known);
            known.insert(id, result);
        }
        known.get(&expr).copied().unwrap_or(expr)
    }

    /// A node of this graph's symbols, with each operand replaced by what is known of it.
    fn construct(&mut self, node: Node, known: &FxHashMap<ExprId, ExprId>) -> ExprId {
        let of = |id: &ExprId| known.get(id).copied().unwrap_or(*id);
        match node {
            Node::Number(number) => self.number(number),
            Node::Constant(constant) => self.constant(constant),
            Node::Symbol(symbol) => self.symbol_node(symbol),
            Node::Variable(variable) => self.variable(variable),
            Node::Sum(terms) => self.sum(terms.iter().map(of).collect::<Vec<_>>()),
            Node::Product(factors) => self.product(factors.iter().map(of).collect::<Vec<_>>()),
            Node::Power(base, exponent) => self.power(of(&base), of(&exponent)),
            Node::Call(function, arguments) => self.call(function, &arguments.iter().map(of).collect::<Vec<_>>()),
            Node::Spline(call, arguments) => self.spline(call, &arguments.iter().map(of).collect::<Vec<_>>()),
        }
    }

    /// `expr` of another graph as an expression of this one, in canonical form.
    ///
    /// `known` holds what expressions of `other` become here: replacements, for symbols above all, and afterwards also
    /// all parts of `expr`, so that several expressions share the work. Other symbols keep their names.
    pub fn import(&mut self, other: &Graph, expr: ExprId, known: &mut FxHashMap<ExprId, ExprId>) -> ExprId {
        let mut result = expr;
        for id in other.reachable(&[expr]) {
            result = match known.get(&id) {
                Some(here) => *here,
                None => {
                    let here = match other.node(id) {
                        Node::Symbol(symbol) => self.symbol(other.symbol_name(*symbol)),
                        node => self.construct(node.clone(), known),
                    };
                    known.insert(id, here);
                    here
                }
            };
        }
        result
    }

    /// The value of `expr` at one point, walked node by node: the plain definition that the compiled
    /// evaluators are tested against, and what parameters and other single values use.
    ///
    /// `symbols` holds a value for each of [`Graph::symbols`]; a missing one reads as NaN. `point` is (u, v, t).
    #[must_use]
    pub fn value(&self, expr: ExprId, symbols: &[f64], point: [f64; 3]) -> f64 {
        let [u, v, t] = point;
        let mut known: FxHashMap<ExprId, f64> = FxHashMap::default();
        for id in self.reachable(&[expr]) {
            let of = |id: &ExprId| known.get(id).copied().unwrap_or(f64::NAN);
            let value = match self.node(id) {
                Node::Number(number) => number.to_f64(),
                Node::Constant(constant) => constant.value(),
                Node::Symbol(symbol) => symbols.get(symbol.index()).copied().unwrap_or(f64::NAN),
                Node::Variable(Variable::U) => u,
                Node::Variable(Variable::V) => v,
                Node::Variable(Variable::T) => t,
                Node::Sum(terms) => terms.iter().map(of).sum(),
                Node::Product(factors) => factors.iter().map(of).product(),
                Node::Power(base, exponent) => libm::pow(of(base), of(exponent)),
                Node::Call(function, arguments) => function.value(&arguments.iter().map(of).collect::<Vec<_>>()),
                Node::Spline(call, arguments) => match &**arguments {
                    [x] => call.value(of(x), 0.0),
                    [x, y] => call.value(of(x), of(y)),
                    _ => f64::NAN,
                },
            };
            known.insert(id, value);
        }
        known.get(&expr).copied().unwrap_or(f64::NAN)
    }
}

impl Constant {
    /// The nearest double.
    #[must_use]
    pub fn value(self) -> f64 {
        match self {
            Constant::Pi => std::f64::consts::PI,
            Constant::E => std::f64::consts::E,
        }
    }
}

impl Function {
    /// The value at `arguments`; NaN for the wrong number of them.
    #[must_use]
    pub fn value(self, arguments: &[f64]) -> f64 {
        match (self.row().value, arguments) {
            (Value::Unary(f), &[x]) => f(x),
            (Value::Binary(f), &[x, y]) => f(x, y),
            _ => f64::NAN,
        }
    }
}
