//! The constructors of canonical expressions: a fixed, ordered list of rules, applied once, bottom up.
//!
//! Sums: nested sums are flattened; numbers fold; terms that differ by a numeric factor merge; zero terms go.
//! Products: nested products are flattened; numbers fold; equal bases merge with their exponents added;
//! `exp(a) exp(b) = exp(a + b)`; a number times a single sum is distributed over it.
//! Powers: `x^0 = 1`, `x^1 = x`, numbers fold, `(x^a)^n = x^(a n)` and `(x y)^n = x^n y^n` for integers n,
//! `exp(a)^b = exp(a b)`, `e^x = exp(x)`.
//! Calls: an argument that begins with a minus is turned around for odd and even functions; a few exact
//! values fold (`sin(0)`, `exp(0)`, `ln(1)`).
//!
//! Two rules can widen where an expression is defined: equal factors cancel (`v/v = 1`) and powers multiply
//! (`sqrt(v)^2 = v`). Deliberately absent: other such rules; identities such as `sin^2 + cos^2 = 1`; expansion of products of sums, which is
//! [`decompose`](crate::decompose)'s business. Division by the number zero is kept, so that it is reported.

use std::collections::BTreeMap;

use super::function::{Function, Parity};
use super::graph::{Constant, ExprId, Graph, Node, SymbolId, Variable};
use super::number::Number;
use super::spline::SplineCall;

impl Graph {
    /// A number.
    pub fn number(&mut self, value: Number) -> ExprId {
        self.intern(Node::Number(value))
    }

    /// An integer.
    pub fn integer(&mut self, value: i64) -> ExprId {
        self.number(Number::integer(value))
    }

    /// `pi` or `e`.
    pub fn constant(&mut self, constant: Constant) -> ExprId {
        self.intern(Node::Constant(constant))
    }

    /// One of the coordinates.
    pub fn variable(&mut self, variable: Variable) -> ExprId {
        self.intern(Node::Variable(variable))
    }

    /// The parameter called `name`.
    pub fn symbol(&mut self, name: &str) -> ExprId {
        let symbol = self.symbol_id(name);
        self.symbol_node(symbol)
    }

    /// The parameter behind a symbol.
    pub fn symbol_node(&mut self, symbol: SymbolId) -> ExprId {
        self.intern(Node::Symbol(symbol))
    }

    /// The sum of all terms; zero when there are none.
    pub fn sum(&mut self, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
        let mut constant = Number::ZERO;
        let mut like: BTreeMap<ExprId, Number> = BTreeMap::new();
        for term in terms {
            let flat = match self.node(term) {
                Node::Sum(inner) => inner.to_vec(),
                _ => vec![term],
            };
            self.count_work(flat.len());
            for term in flat {
                if let Some(number) = self.as_number(term) {
                    constant = constant + number;
                } else {
                    let (factor, rest) = self.split_factor(term);
                    like.entry(rest).and_modify(|total| *total = *total + factor).or_insert(factor);
                }
            }
        }
        let mut operands = Vec::with_capacity(like.len() + 1);
        if !constant.is_zero() {
            operands.push(self.number(constant));
        }
        for (rest, factor) in like {
            if !factor.is_zero() {
                operands.push(self.scale(factor, rest));
            }
        }
        match operands.as_slice() {
            [] => self.integer(0),
            [single] => *single,
            _ => self.intern(Node::Sum(operands.into())),
        }
    }

    /// The product of all factors; one when there are none.
    pub fn product(&mut self, factors: impl IntoIterator<Item = ExprId>) -> ExprId {
        let mut flat: Vec<ExprId> = Vec::new();
        for factor in factors {
            match self.node(factor) {
                Node::Product(inner) => flat.extend(inner.iter()),
                _ => flat.push(factor),
            }
        }
        self.count_work(flat.len());
        let mut coefficient = Number::ONE;
        let mut exponents: BTreeMap<ExprId, Vec<ExprId>> = BTreeMap::new();
        let mut exp_arguments: Vec<ExprId> = Vec::new();
        let mut divides_by_zero = false;
        for factor in flat {
            match self.node(factor).clone() {
                Node::Number(number) => coefficient = coefficient * number,
                Node::Call(Function::Exp, arguments) => exp_arguments.extend(arguments),
                Node::Constant(Constant::E) => exp_arguments.push(self.integer(1)),
                Node::Power(base, exponent) => {
                    divides_by_zero |= self.is_zero(base);
                    exponents.entry(base).or_default().push(exponent);
                }
                _ => {
                    let one = self.integer(1);
                    exponents.entry(factor).or_default().push(one);
                }
            }
        }
        if coefficient.is_zero() && !divides_by_zero {
            return self.integer(0);
        }
        let mut operands: Vec<ExprId> = Vec::new();
        let mut was_merged = false;
        for (base, powers) in exponents {
            operands.push(match powers.as_slice() {
                // The power stood in a product or alone, so it is canonical as it is.
                [single] if self.is_one(*single) => base,
                [single] => self.intern(Node::Power(base, *single)),
                _ => {
                    was_merged = true;
                    let exponent = self.sum(powers);
                    self.power(base, exponent)
                }
            });
        }
        if !exp_arguments.is_empty() {
            let argument = self.sum(exp_arguments);
            operands.push(self.call(Function::Exp, &[argument]));
        }
        operands.retain(|&operand| match self.node(operand) {
            Node::Number(number) => {
                coefficient = coefficient * *number;
                false
            }
            _ => true,
        });
        // Merging can end in a product, `sqrt(2 x) sqrt(2 x) = 2 x`, whose factors may meet others here.
        if was_merged && operands.iter().any(|&operand| matches!(self.node(operand), Node::Product(_))) {
            let coefficient = self.number(coefficient);
            return self.product(operands.into_iter().chain([coefficient]));
        }
        operands.sort_unstable();
        self.product_of_canonical(coefficient, operands)
    }

    fn product_of_canonical(&mut self, coefficient: Number, operands: Vec<ExprId>) -> ExprId {
        match operands.as_slice() {
            [] => self.number(coefficient),
            [single] if coefficient.is_one() => *single,
            [single] => {
                if let Node::Sum(terms) = self.node(*single).clone() {
                    let scaled: Vec<ExprId> = terms.iter().map(|&term| self.scale(coefficient, term)).collect();
                    return self.sum(scaled);
                }
                let number = self.number(coefficient);
                self.intern(Node::Product([number, *single].into()))
            }
            _ if coefficient.is_one() => self.intern(Node::Product(operands.into())),
            _ => {
                let number = self.number(coefficient);
                self.intern(Node::Product(std::iter::once(number).chain(operands).collect()))
            }
        }
    }

    /// `factor * expr`.
    pub fn scale(&mut self, factor: Number, expr: ExprId) -> ExprId {
        if factor.is_one() {
            return expr;
        }
        let factor = self.number(factor);
        self.product([factor, expr])
    }

    /// `-expr`.
    pub fn neg(&mut self, expr: ExprId) -> ExprId {
        self.scale(Number::MINUS_ONE, expr)
    }

    /// `left - right`.
    pub fn difference(&mut self, left: ExprId, right: ExprId) -> ExprId {
        let negated = self.neg(right);
        self.sum([left, negated])
    }

    /// `1 / expr`.
    pub fn inverse(&mut self, expr: ExprId) -> ExprId {
        self.power_integer(expr, -1)
    }

    /// `numerator / denominator`.
    pub fn quotient(&mut self, numerator: ExprId, denominator: ExprId) -> ExprId {
        let inverse = self.inverse(denominator);
        self.product([numerator, inverse])
    }

    /// The square root.
    pub fn sqrt(&mut self, expr: ExprId) -> ExprId {
        let half = self.number(Number::Exact(num_rational::Ratio::new_raw(1, 2)));
        self.power(expr, half)
    }

    /// `base^exponent` for an integer.
    pub fn power_integer(&mut self, base: ExprId, exponent: i64) -> ExprId {
        let exponent = self.integer(exponent);
        self.power(base, exponent)
    }

    /// `base^exponent`.
    pub fn power(&mut self, base: ExprId, exponent: ExprId) -> ExprId {
        if let Some(number) = self.as_number(exponent) {
            return self.power_number(base, exponent, number);
        }
        self.power_by_base(base, exponent)
    }

    fn power_by_base(&mut self, base: ExprId, exponent: ExprId) -> ExprId {
        match self.node(base).clone() {
            Node::Constant(Constant::E) => self.call(Function::Exp, &[exponent]),
            Node::Call(Function::Exp, arguments) => {
                let product = self.product(arguments.iter().copied().chain([exponent]));
                self.call(Function::Exp, &[product])
            }
            _ => self.intern(Node::Power(base, exponent)),
        }
    }

    fn power_number(&mut self, base: ExprId, exponent: ExprId, number: Number) -> ExprId {
        if number.is_one() {
            return base;
        }
        if number.is_zero() {
            return self.integer(1);
        }
        let integer = number.as_integer();
        match self.node(base).clone() {
            Node::Number(value) => match integer.and_then(|n| value.powi(n)) {
                Some(folded) => self.number(folded),
                None if value.is_one() => base,
                None => self.intern(Node::Power(base, exponent)),
            },
            Node::Power(inner, inner_exponent) if integer.is_some() => {
                let product = self.product([inner_exponent, exponent]);
                self.power(inner, product)
            }
            Node::Product(factors) if integer.is_some() => {
                let powers: Vec<ExprId> = factors.iter().map(|&factor| self.power(factor, exponent)).collect();
                self.product(powers)
            }
            _ => self.power_by_base(base, exponent),
        }
    }

    /// `function(arguments)`.
    ///
    /// The caller keeps the arity; an evaluator reads missing arguments as NaN.
    pub fn call(&mut self, function: Function, arguments: &[ExprId]) -> ExprId {
        let &[argument] = arguments else {
            return self.intern(Node::Call(function, arguments.into()));
        };
        if let Some(value) = self.exact_value(function, argument) {
            return value;
        }
        match function.row().parity {
            Parity::Odd if self.begins_with_minus(argument) => {
                let turned = self.neg(argument);
                let value = self.call(function, &[turned]);
                self.neg(value)
            }
            Parity::Even if self.begins_with_minus(argument) => {
                let turned = self.neg(argument);
                self.call(function, &[turned])
            }
            _ => self.intern(Node::Call(function, [argument].into())),
        }
    }

    /// A spline of its arguments, of which there must be as many as it has.
    pub fn spline(&mut self, call: SplineCall, arguments: &[ExprId]) -> ExprId {
        if call.is_zero() { self.integer(0) } else { self.intern(Node::Spline(call, arguments.into())) }
    }

    fn exact_value(&mut self, function: Function, argument: ExprId) -> Option<ExprId> {
        if self.is_zero(argument) {
            return match function {
                Function::Sin
                | Function::Tan
                | Function::Sinh
                | Function::Tanh
                | Function::Asin
                | Function::Atan
                | Function::Asinh
                | Function::Atanh
                | Function::Cbrt
                | Function::Abs
                | Function::Floor
                | Function::Sign => Some(self.integer(0)),
                Function::Cos | Function::Cosh | Function::Exp | Function::Sec => Some(self.integer(1)),
                _ => None,
            };
        }
        match (function, self.node(argument)) {
            (Function::Ln, Node::Number(number)) if number.is_one() => Some(self.integer(0)),
            (Function::Ln, Node::Constant(Constant::E)) => Some(self.integer(1)),
            (Function::Ln, Node::Call(Function::Exp, inner)) => inner.first().copied(),
            (Function::Exp, Node::Number(number)) if number.is_one() => Some(self.constant(Constant::E)),
            _ => None,
        }
    }

    /// A term as a number times the rest.
    pub(crate) fn split_factor(&mut self, term: ExprId) -> (Number, ExprId) {
        let Node::Product(factors) = self.node(term).clone() else { return (Number::ONE, term) };
        match factors.split_first() {
            Some((&first, rest)) => match self.as_number(first) {
                // Zero times a division by zero is kept as it is.
                Some(number) if number.is_zero() => (Number::ONE, term),
                Some(number) => (number, self.product_of_canonical(Number::ONE, rest.to_vec())),
                None => (Number::ONE, term),
            },
            None => (Number::ONE, term),
        }
    }

    /// Whether the first term, in canonical order, has a negative numeric factor.
    fn begins_with_minus(&mut self, expr: ExprId) -> bool {
        let leading = match self.node(expr) {
            Node::Sum(terms) => terms.first().copied().unwrap_or(expr),
            _ => expr,
        };
        match self.as_number(leading) {
            Some(number) => number.is_negative(),
            None => self.split_factor(leading).0.is_negative(),
        }
    }
}
