//! Straight-line programs, which every evaluator runs in the same order.
//!
//! Input: expressions of one [`Graph`]; output: a [`Program`], a list of [`Op`]s in which every operand is
//! computed before it is used, and the op that holds each output.
//!
//! Invariant: operands have smaller ids than the op that uses them, equal ops are one op, every op is needed by
//! some output, and the uniform ops, which see only numbers and parameters, come before the varying ones.
//!
//! The program, not the evaluator, decides how a sum or a power is computed (`lowering`), so evaluators cannot disagree.

use std::fmt;

use crate::expr::{ExprId, Function, Graph, SplineCall, Variable};

use super::lowering::lower;

/// An op of a [`Program`]: its position in [`Program::ops`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct OpId(pub(super) u32);

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
    #[inline(always)]
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
        let (ops, outputs, splines) = lower(graph, outputs);
        Program { splines, ..schedule(&ops, outputs) }
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
