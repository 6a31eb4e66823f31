//! Lowers expressions to a straight-line program that every evaluator runs in the same order.
//!
//! Input: expressions of one [`Graph`]; output: a [`Program`], a list of [`Op`]s in which every operand is
//! computed before it is used, and the op that holds each output.
//!
//! Invariant: operands have smaller ids than the op that uses them, equal ops are one op, every op is needed by
//! some output, and the uniform ops, which see only numbers and parameters, come before the varying ones.
//!
//! The program, not the evaluator, decides how a sum or a power is computed, so evaluators cannot disagree:
//! sums and products are folded left to right; a term with a negative factor is subtracted; integer powers up to
//! [`LARGEST_MULTIPLIED_POWER`] are multiplied out by repeated squaring; exponents 1/2 and -1/2 are square roots.
//! Absent on purpose: algebra, which [`expr`](crate::expr) has done, and fused multiply-add, which would round
//! differently from one machine to the next.

use std::fmt;

use rustc_hash::FxHashMap;

use crate::expr::{ExprId, Function, Graph, Node, Number, SplineCall, Value, Variable};

/// Integer exponents of at most this magnitude become multiplications; larger ones call `pow`.
///
/// Sixteen needs at most six multiplications, each off by half an ulp: still cheaper than `pow`, and close to it.
pub const LARGEST_MULTIPLIED_POWER: u32 = 16;

/// An op of a [`Program`]: its position in [`Program::ops`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct OpId(u32);

impl OpId {
    /// The position.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One operation on doubles; evaluators replace the ids by operands of their own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op<Operand = OpId> {
    /// A number.
    Constant(f64),
    /// The parameter at this index.
    Parameter(usize),
    /// A coordinate of the sample.
    Variable(Variable),
    /// `-a`
    Neg(Operand),
    /// `a + b`
    Add(Operand, Operand),
    /// `a - b`
    Sub(Operand, Operand),
    /// `a * b`
    Mul(Operand, Operand),
    /// `a / b`
    Div(Operand, Operand),
    /// The correctly rounded square root.
    Sqrt(Operand),
    /// A function of one argument.
    Call1(Function, Operand),
    /// A function of two arguments.
    Call2(Function, Operand, Operand),
    /// The spline of [`Program::splines`] at this index, of one argument.
    Spline1(usize, Operand),
    /// The spline at this index, of two arguments.
    Spline2(usize, Operand, Operand),
}

impl<Operand: Copy> Op<Operand> {
    /// The operands, in order.
    pub fn operands(self) -> impl DoubleEndedIterator<Item = Operand> {
        let (first, second) = match self {
            Op::Constant(_) | Op::Parameter(_) | Op::Variable(_) => (None, None),
            Op::Neg(a) | Op::Sqrt(a) | Op::Call1(_, a) | Op::Spline1(_, a) => (Some(a), None),
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Div(a, b) => (Some(a), Some(b)),
            Op::Call2(_, a, b) | Op::Spline2(_, a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }

    /// The same operation on other operands.
    pub fn map<Other>(self, mut of: impl FnMut(Operand) -> Other) -> Op<Other> {
        match self {
            Op::Constant(value) => Op::Constant(value),
            Op::Parameter(index) => Op::Parameter(index),
            Op::Variable(variable) => Op::Variable(variable),
            Op::Neg(a) => Op::Neg(of(a)),
            Op::Add(a, b) => Op::Add(of(a), of(b)),
            Op::Sub(a, b) => Op::Sub(of(a), of(b)),
            Op::Mul(a, b) => Op::Mul(of(a), of(b)),
            Op::Div(a, b) => Op::Div(of(a), of(b)),
            Op::Sqrt(a) => Op::Sqrt(of(a)),
            Op::Call1(function, a) => Op::Call1(function, of(a)),
            Op::Call2(function, a, b) => Op::Call2(function, of(a), of(b)),
            Op::Spline1(index, a) => Op::Spline1(index, of(a)),
            Op::Spline2(index, a, b) => Op::Spline2(index, of(a), of(b)),
        }
    }
}

/// A straight-line program for a list of outputs.
#[derive(Debug, Clone)]
pub struct Program {
    ops: Vec<Op>,
    /// How many leading ops are uniform.
    uniform: usize,
    outputs: Vec<OpId>,
    symbols: usize,
    splines: Vec<SplineCall>,
}

impl Program {
    /// Lowers `outputs`, in order, to a program; what they share is computed once.
    ///
    /// Linear in the size of the expressions, and without recursion, so any graph within
    /// [`Limits`](crate::limits::Limits) can be lowered on a small stack.
    #[must_use]
    pub fn compile(graph: &Graph, outputs: &[ExprId]) -> Program {
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
        Program { splines: lowering.splines, ..schedule(&lowering.ops, outputs) }
    }

    /// The program for other outputs, which are ops of this one.
    pub(super) fn with_outputs(&self, outputs: Vec<OpId>) -> Program {
        Program { splines: self.splines.clone(), ..schedule(&self.ops, outputs) }
    }

    /// Every op, uniform ones first; the position of an op is its [`OpId`].
    #[must_use]
    pub fn ops(&self) -> &[Op] {
        &self.ops
    }

    /// The ops that depend on numbers and parameters alone: once per call, whatever the number of samples.
    #[must_use]
    pub fn uniform(&self) -> &[Op] {
        self.ops.get(..self.uniform).unwrap_or_default()
    }

    /// The ops that depend on a coordinate: once per sample. The first has the id after the last uniform op.
    #[must_use]
    pub fn varying(&self) -> &[Op] {
        self.ops.get(self.uniform..).unwrap_or_default()
    }

    /// The op that holds each output.
    #[must_use]
    pub fn output_ops(&self) -> &[OpId] {
        &self.outputs
    }

    /// The number of outputs.
    #[must_use]
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// The splines that ops name by their index.
    #[must_use]
    pub fn splines(&self) -> &[SplineCall] {
        &self.splines
    }

    /// The number of parameter values an evaluation needs: one more than the largest index in use.
    #[must_use]
    pub fn symbols(&self) -> usize {
        self.symbols
    }
}

impl fmt::Display for Program {
    /// One line an op, `r2 = r0 * r1`, under `uniform:` and `varying:`; then `outputs: r2`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (id, op) in self.ops.iter().enumerate() {
            if id == 0 && self.uniform > 0 {
                writeln!(f, "uniform:")?;
            }
            if id == self.uniform {
                writeln!(f, "varying:")?;
            }
            write!(f, "  r{id} = ")?;
            match op.map(OpId::index) {
                Op::Constant(value) => writeln!(f, "{value:?}"),
                Op::Parameter(index) => writeln!(f, "parameter {index}"),
                Op::Variable(variable) => writeln!(f, "{}", variable.name()),
                Op::Neg(a) => writeln!(f, "-r{a}"),
                Op::Add(a, b) => writeln!(f, "r{a} + r{b}"),
                Op::Sub(a, b) => writeln!(f, "r{a} - r{b}"),
                Op::Mul(a, b) => writeln!(f, "r{a} * r{b}"),
                Op::Div(a, b) => writeln!(f, "r{a} / r{b}"),
                Op::Sqrt(a) => writeln!(f, "sqrt(r{a})"),
                Op::Call1(function, a) => writeln!(f, "{}(r{a})", function.row().name),
                Op::Call2(function, a, b) => writeln!(f, "{}(r{a}, r{b})", function.row().name),
                Op::Spline1(index, a) => writeln!(f, "spline {index}(r{a})"),
                Op::Spline2(index, a, b) => writeln!(f, "spline {index}(r{a}, r{b})"),
            }?;
        }
        write!(f, "outputs:")?;
        for (position, output) in self.outputs.iter().enumerate() {
            write!(f, "{} r{}", if position == 0 { "" } else { "," }, output.index())?;
        }
        writeln!(f)
    }
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

/// Keeps the ops that `outputs` need, in the order in which they are first needed, uniform ones first.
///
/// First need (post-order) rather than graph order: a value is computed next to its use, so few are live at once.
fn schedule(ops: &[Op], outputs: Vec<OpId>) -> Program {
    let op = |id: OpId| *ops.get(id.index()).expect("an id comes from emitting an op");
    let mut is_uniform: Vec<bool> = Vec::with_capacity(ops.len());
    for &op in ops {
        let operands_are = op.operands().all(|id| is_uniform.get(id.index()).copied().unwrap_or(false));
        is_uniform.push(operands_are && !matches!(op, Op::Variable(_)));
    }
    let (mut uniform, mut varying) = (Vec::new(), Vec::new());
    let mut is_seen = vec![false; ops.len()];
    let mut pending: Vec<(OpId, bool)> = outputs.iter().rev().map(|&id| (id, false)).collect();
    while let Some((id, operands_are_done)) = pending.pop() {
        if operands_are_done {
            let group = if is_uniform.get(id.index()) == Some(&true) { &mut uniform } else { &mut varying };
            group.push(id);
        } else if let Some(mark @ false) = is_seen.get_mut(id.index()) {
            *mark = true;
            pending.push((id, true));
            pending.extend(op(id).operands().rev().map(|operand| (operand, false)));
        }
    }
    let mut position = vec![OpId(0); ops.len()];
    for (new, old) in (0_u32..).zip(uniform.iter().chain(&varying)) {
        if let Some(entry) = position.get_mut(old.index()) {
            *entry = OpId(new);
        }
    }
    let renumbered = |id: OpId| *position.get(id.index()).expect("an id comes from emitting an op");
    let kept: Vec<Op> = uniform.iter().chain(&varying).map(|&id| op(id).map(renumbered)).collect();
    let parameters = kept.iter().filter_map(|op| if let Op::Parameter(index) = op { Some(index + 1) } else { None });
    Program {
        symbols: parameters.max().unwrap_or(0),
        uniform: uniform.len(),
        outputs: outputs.into_iter().map(renumbered).collect(),
        ops: kept,
        splines: Vec::new(),
    }
}
