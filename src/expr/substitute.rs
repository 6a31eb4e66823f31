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
                let result = self.rebuild(id, &known);
                known.insert(id, result);
            }
        }
        known.get(&expr).copied().unwrap_or(expr)
    }

    fn rebuild(&mut self, id: ExprId, known: &FxHashMap<ExprId, ExprId>) -> ExprId {
        let of = |id: &ExprId| known.get(id).copied().unwrap_or(*id);
        match self.node(id).clone() {
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) | Node::Variable(_) => id,
            Node::Sum(terms) => self.sum(terms.iter().map(of).collect::<Vec<_>>()),
            Node::Product(factors) => self.product(factors.iter().map(of).collect::<Vec<_>>()),
            Node::Power(base, exponent) => self.power(of(&base), of(&exponent)),
            Node::Call(function, arguments) => self.call(function, &arguments.iter().map(of).collect::<Vec<_>>()),
        }
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
