//! Lowers expressions to the ops of a program.
//!
//! Sums and products are folded left to right; a term with a negative factor is subtracted; terms that differ only in
//! numbers and parameters are collected first, so that these are summed once; integer powers up to
//! [`LARGEST_MULTIPLIED_POWER`] are multiplied out by repeated squaring; exponents 1/2 and -1/2 are square roots.
//!
//! Absent on purpose: algebra, which [`expr`](crate::expr) has done, and fused multiply-add, which would round
//! differently from one machine to the next.

use indexmap::IndexMap;
use rustc_hash::FxHashMap;

use crate::expr::{ExprId, Function, Graph, Node, Number, SplineCall, Value};

use super::program::{Op, OpId};

/// Integer exponents of at most this magnitude become multiplications; larger ones call `pow`.
///
/// Sixteen needs at most six multiplications, each off by half an ulp: still cheaper than `pow`, and close to it.
pub const LARGEST_MULTIPLIED_POWER: u32 = 16;

/// The ops of `outputs` in an order in which operands come first, the op of each output, and the splines that ops name.
pub(super) fn lower(graph: &Graph, outputs: &[ExprId]) -> (Vec<Op>, Vec<OpId>, Vec<SplineCall>) {
    let mut lowering = Lowering {
        graph,
        ops: Vec::new(),
        known: FxHashMap::default(),
        lowered: FxHashMap::default(),
        magnitudes: FxHashMap::default(),
        splines: Vec::new(),
    };
    for id in graph.reachable(outputs) {
        let op = lowering.lower(id);
        lowering.lowered.insert(id, op);
    }
    let outputs = outputs.iter().map(|id| lowering.of(id)).collect();
    (lowering.ops, outputs, lowering.splines)
}

/// Kinds of ops from here on are splines, one each; functions of the table are far fewer.
const SPLINES: u32 = 1 << 16;

/// What two ops must share to be one op.
type Key = (u32, u64, u64);

fn key(op: Op) -> Key {
    let id = |id: OpId| u64::from(id.0);
    // Addition and multiplication of doubles commute; only a NaN's payload could tell.
    let unordered = |a: OpId, b: OpId| (id(a.min(b)), id(a.max(b)));
    let (kind, (first, second)) = match op {
        Op::Constant(value) => (0, (value.to_bits(), 0)),
        Op::Parameter(index) => (1, (index as u64, 0)),
        Op::Variable(variable) => (2, (variable as u64, 0)),
        Op::Neg(a) => (3, (id(a), 0)),
        Op::Add(a, b) => (4, unordered(a, b)),
        Op::Sub(a, b) => (5, (id(a), id(b))),
        Op::Mul(a, b) => (6, unordered(a, b)),
        Op::Div(a, b) => (7, (id(a), id(b))),
        Op::Sqrt(a) => (8, (id(a), 0)),
        Op::Call1(function, a) => (9 + function as u32, (id(a), 0)),
        Op::Call2(function, a, b) => (9 + function as u32, (id(a), id(b))),
        Op::Spline1(index, a) => (SPLINES + index as u32, (id(a), 0)),
        Op::Spline2(index, a, b) => (SPLINES + index as u32, (id(a), id(b))),
    };
    (kind, first, second)
}

struct Lowering<'a> {
    graph: &'a Graph,
    ops: Vec<Op>,
    known: FxHashMap<Key, OpId>,
    lowered: FxHashMap<ExprId, OpId>,
    /// Products with a negative number in front, without its sign.
    magnitudes: FxHashMap<ExprId, OpId>,
    splines: Vec<SplineCall>,
}

impl Lowering<'_> {
    fn emit(&mut self, op: Op) -> OpId {
        let next = OpId(u32::try_from(self.ops.len()).expect("limits keep a program far below 2^32 ops"));
        let id = *self.known.entry(key(op)).or_insert(next);
        if id == next {
            self.ops.push(op);
        }
        id
    }

    fn of(&self, id: &ExprId) -> OpId {
        self.lowered.get(id).copied().expect("operands come before the nodes that use them")
    }

    fn lower(&mut self, id: ExprId) -> OpId {
        let graph = self.graph;
        match graph.node(id) {
            Node::Number(number) => self.emit(Op::Constant(number.to_f64())),
            Node::Constant(constant) => self.emit(Op::Constant(constant.value())),
            Node::Symbol(symbol) => self.emit(Op::Parameter(symbol.index())),
            Node::Variable(variable) => self.emit(Op::Variable(*variable)),
            Node::Sum(terms) => self.sum(terms),
            Node::Product(factors) => match self.leading_number(factors) {
                Some((number, rest)) if number == Number::MINUS_ONE => {
                    let magnitude = self.product(rest);
                    self.emit(Op::Neg(magnitude))
                }
                _ => self.product(factors),
            },
            Node::Power(base, exponent) => self.power(*base, *exponent),
            Node::Call(function, arguments) => match (function.row().value, &**arguments) {
                (Value::Unary(_), [a]) => self.emit(Op::Call1(*function, self.of(a))),
                (Value::Binary(_), [a, b]) => self.emit(Op::Call2(*function, self.of(a), self.of(b))),
                _ => self.emit(Op::Constant(f64::NAN)),
            },
            Node::Spline(call, arguments) => {
                let known = self.splines.iter().position(|other| other == call);
                let index = known.unwrap_or_else(|| {
                    self.splines.push(call.clone());
                    self.splines.len() - 1
                });
                match &**arguments {
                    [a] => self.emit(Op::Spline1(index, self.of(a))),
                    [a, b] => self.emit(Op::Spline2(index, self.of(a), self.of(b))),
                    _ => self.emit(Op::Constant(f64::NAN)),
                }
            }
        }
    }

    fn leading_number<'a>(&self, factors: &'a [ExprId]) -> Option<(Number, &'a [ExprId])> {
        let (first, rest) = factors.split_first()?;
        self.graph.as_number(*first).map(|number| (number, rest))
    }

    fn sum(&mut self, terms: &[ExprId]) -> OpId {
        if let Some(collected) = collected(self.graph, terms) {
            return self.collected_sum(collected);
        }
        let Some((first, rest)) = terms.split_first() else { return self.emit(Op::Constant(0.0)) };
        let mut total = self.of(first);
        for term in rest {
            total = match self.magnitude(*term) {
                Some(magnitude) => self.emit(Op::Sub(total, magnitude)),
                None => self.emit(Op::Add(total, self.of(term))),
            };
        }
        total
    }

    /// A sum of which several terms differ only in what does not depend on a coordinate: one term for all of them.
    fn collected_sum(&mut self, collected: Collected) -> OpId {
        let mut uniform: Vec<(Vec<ExprId>, OpId)> = Vec::with_capacity(collected.len());
        for (varying, coefficients) in collected {
            let mut sum = None;
            for coefficient in coefficients {
                let product = self.product(&coefficient);
                sum = Some(sum.map_or(product, |sum| self.emit(Op::Add(sum, product))));
            }
            let coefficient = sum.unwrap_or_else(|| self.emit(Op::Constant(0.0)));
            uniform.push((varying, coefficient));
        }
        let Some(factor) = commonest_factor(&uniform) else { return self.weighted_sum(&uniform) };
        let (mut inside, outside): (Vec<_>, Vec<_>) =
            uniform.into_iter().partition(|(varying, _)| varying.contains(&factor));
        for (varying, _) in &mut inside {
            varying.remove(varying.iter().position(|id| *id == factor).unwrap_or(0));
        }
        let inside = self.weighted_sum(&inside);
        let product = self.emit(Op::Mul(self.of(&factor), inside));
        if outside.is_empty() {
            return product;
        }
        let outside = self.weighted_sum(&outside);
        self.emit(Op::Add(outside, product))
    }

    /// `Σ coefficient * product(varying)`, what does not vary first.
    fn weighted_sum(&mut self, terms: &[(Vec<ExprId>, OpId)]) -> OpId {
        let (constant, varying): (Vec<_>, Vec<_>) = terms.iter().partition(|(varying, _)| varying.is_empty());
        let mut total = constant.first().map(|(_, coefficient)| *coefficient);
        for (varying, coefficient) in varying {
            let product = self.product(varying);
            let is_one = self.ops.get(coefficient.index()) == Some(&Op::Constant(1.0));
            let term = if is_one { product } else { self.emit(Op::Mul(*coefficient, product)) };
            total = Some(total.map_or(term, |total| self.emit(Op::Add(total, term))));
        }
        total.unwrap_or_else(|| self.emit(Op::Constant(0.0)))
    }

    /// `-term`, when the term carries a minus sign that a subtraction can take over.
    fn magnitude(&mut self, term: ExprId) -> Option<OpId> {
        let graph = self.graph;
        let Node::Product(factors) = graph.node(term) else { return None };
        let (number, rest) = self.leading_number(factors).filter(|(number, _)| number.is_negative())?;
        if let Some(&known) = self.magnitudes.get(&term) {
            return Some(known);
        }
        let magnitude = if number == Number::MINUS_ONE {
            self.product(rest)
        } else {
            let start = self.emit(Op::Constant(-number.to_f64()));
            self.multiply(start, rest)
        };
        self.magnitudes.insert(term, magnitude);
        Some(magnitude)
    }

    fn product(&mut self, factors: &[ExprId]) -> OpId {
        match factors.split_first() {
            Some((first, rest)) => self.multiply(self.of(first), rest),
            None => self.emit(Op::Constant(1.0)),
        }
    }

    fn multiply(&mut self, start: OpId, factors: &[ExprId]) -> OpId {
        factors.iter().fold(start, |product, factor| self.emit(Op::Mul(product, self.of(factor))))
    }

    fn power(&mut self, base: ExprId, exponent: ExprId) -> OpId {
        let number = self.graph.as_number(exponent);
        let (base, exponent) = (self.of(&base), self.of(&exponent));
        let Some(number) = number else { return self.emit(Op::Call2(Function::Pow, base, exponent)) };
        let magnitude = if number.is_negative() { -number } else { number };
        let integer = magnitude.as_integer().and_then(|n| u32::try_from(n).ok());
        let power = match integer {
            Some(n) if n <= LARGEST_MULTIPLIED_POWER => self.integer_power(base, n),
            _ if Some(magnitude) == Number::fraction(1, 2) => self.emit(Op::Sqrt(base)),
            _ => return self.emit(Op::Call2(Function::Pow, base, exponent)),
        };
        if number.is_negative() {
            let one = self.emit(Op::Constant(1.0));
            self.emit(Op::Div(one, power))
        } else {
            power
        }
    }

    /// `base^exponent` from the bits of the exponent, lowest first.
    fn integer_power(&mut self, base: OpId, exponent: u32) -> OpId {
        let (mut power, mut square, mut left) = (None, base, exponent);
        while left > 0 {
            if left % 2 == 1 {
                power = Some(power.map_or(square, |power| self.emit(Op::Mul(power, square))));
            }
            left /= 2;
            if left > 0 {
                square = self.emit(Op::Mul(square, square));
            }
        }
        power.unwrap_or_else(|| self.emit(Op::Constant(1.0)))
    }
}

/// The terms of a sum by what they have of coordinates: factors that depend on one, and for each term that has them the
/// factors that do not.
type Collected = IndexMap<Vec<ExprId>, Vec<Vec<ExprId>>>;

/// The terms of a sum in which several terms differ only in what does not depend on a coordinate, as in
/// `a² sin v + b sin v`; `None` for others.
fn collected(graph: &Graph, terms: &[ExprId]) -> Option<Collected> {
    let varies = |id: &ExprId| {
        let dependence = graph.dependence(*id);
        dependence.u || dependence.v || dependence.t
    };
    let mut collected = Collected::with_capacity(terms.len());
    for term in terms {
        let factors = match graph.node(*term) {
            Node::Product(factors) => factors,
            _ => std::slice::from_ref(term),
        };
        let (varying, uniform): (Vec<ExprId>, Vec<ExprId>) = factors.iter().partition(|id| varies(id));
        collected.entry(varying).or_default().push(uniform);
    }
    let is_shorter = collected.iter().any(|(varying, terms)| !varying.is_empty() && terms.len() > 1);
    is_shorter.then_some(collected)
}

/// Sums of fewer terms gain nothing from a factor in common.
const MANY_TERMS: usize = 8;

/// The factor that most terms of a long sum have, the first of them; `None` if none has two.
fn commonest_factor(terms: &[(Vec<ExprId>, OpId)]) -> Option<ExprId> {
    let mut counts: IndexMap<ExprId, usize> = IndexMap::new();
    for factor in terms.iter().flat_map(|(varying, _)| varying) {
        *counts.entry(*factor).or_insert(0) += 1;
    }
    let most = counts.values().copied().max().filter(|most| *most >= 2 && terms.len() >= MANY_TERMS)?;
    counts.into_iter().find_map(|(factor, count)| (count == most).then_some(factor))
}
