//! Runs a program op by op over blocks of samples.
//!
//! Input: a [`Program`]; output: an evaluator whose every step is a loop over a block, so that the cost of choosing an
//! op is shared by [`BLOCK`] samples and the loops run on whole vectors, with the functions of
//! [`kernels`](crate::kernels).
//!
//! Outputs are computed where they belong; coordinates and uniform values are read where they are. Every output is
//! [`canonical`]; what is read again may be any NaN, which no operation tells from another. The plain definition of an
//! evaluator: the machine code is tested against it.

use std::sync::Arc;

use crate::expr::{Function, SplineCall, Value, Variable};
use crate::kernels::elementary::{self, Cos, Cosh, Exp, Ln, Sin, SinCos, Sinh, SinhCosh, Tan, Tanh};
use crate::kernels::{InstructionSet, Rows, canonical, multiversion};

use super::program::{Op, Program};
use super::schedule::{Operand, Pairing, Schedule, Step};
use super::{EvalError, Evaluator, Samples, checked_points, checked_samples};

/// Samples a step treats at once: enough that choosing a step takes little of the time, and so few that all rows of a
/// large program stay in the second-level cache (docs/performance.md).
const BLOCK: usize = 1024;

/// An operand in one block.
#[derive(Clone, Copy)]
enum Block<'a> {
    Same(f64),
    Each(&'a [f64]),
}

/// The evaluator that runs everywhere.
pub(super) struct Interpreter {
    program: Arc<Program>,
    schedule: Schedule,
}

impl Interpreter {
    pub(super) fn new(program: Arc<Program>) -> Self {
        let schedule = Schedule::of(&program);
        Interpreter { program, schedule }
    }
}

impl Evaluator for Interpreter {
    fn program(&self) -> &Program {
        &self.program
    }

    fn evaluate(&self, params: &[f64], samples: Samples<'_>, values: &mut [f64]) -> Result<(), EvalError> {
        let points = checked_points(&self.program, params, samples, values)?;
        self.run(params, samples, (values, points), &mut Workspace::default());
        Ok(())
    }

    fn evaluate_rows(
        &self,
        params: &[f64],
        samples: Samples<'_>,
        target: &mut Rows,
        workspace: &mut Workspace,
    ) -> Result<(), EvalError> {
        let points = checked_samples(&self.program, params, samples)?;
        target.reshape(self.program.outputs(), points);
        self.run(params, samples, target.strided(), workspace);
        Ok(())
    }
}

impl Interpreter {
    /// Evaluates block by block, once all lengths are known to fit; rows of values begin `stride` apart.
    fn run(
        &self,
        params: &[f64],
        samples: Samples<'_>,
        (values, stride): (&mut [f64], usize),
        workspace: &mut Workspace,
    ) {
        let points = samples.u.len();
        if points == 0 {
            return;
        }
        let set = InstructionSet::best();
        workspace.prepare(&self.program, params, (self.schedule.registers(), points.min(BLOCK)));
        let Workspace { uniform, registers, .. } = workspace;
        let count = self.program.outputs();
        let mut outputs = Vec::with_capacity(count);
        for values in values.chunks_mut(stride).take(count) {
            let (row, _) = values.split_at_mut_checked(points).unwrap_or_default();
            outputs.push(row.chunks_mut(BLOCK));
        }
        let mut rows: Vec<&mut [f64]> = Vec::with_capacity(count + self.schedule.registers());
        rows.resize_with(count, Default::default);
        rows.extend(registers.iter_mut());
        let blocks = samples.u.chunks(BLOCK).zip(samples.v.chunks(BLOCK)).zip(samples.t.chunks(BLOCK));
        for ((u, v), t) in blocks {
            let (now, registers) = rows.split_at_mut(count);
            now.iter_mut().zip(&mut outputs).for_each(|(row, output)| *row = output.next().unwrap_or_default());
            registers.iter_mut().for_each(|register| shorten(register, u.len()));
            let splines = self.program.splines();
            run(set, self.schedule.steps(), (uniform, splines, count), Samples { u, v, t }, &mut rows);
        }
    }
}

/// What an evaluation needs besides its arguments, kept for the next: values of the uniform ops, and registers.
#[derive(Debug, Default)]
pub struct Workspace {
    /// The program and the parameters that the uniform values belong to.
    of: Option<Arc<Program>>,
    params: Vec<f64>,
    uniform: Vec<f64>,
    registers: Rows,
}

impl Workspace {
    fn prepare(&mut self, program: &Arc<Program>, params: &[f64], (registers, length): (usize, usize)) {
        let is_known = self.of.as_ref().is_some_and(|of| Arc::ptr_eq(of, program)) && are_same(&self.params, params);
        if !is_known {
            self.uniform = uniform_values(program, params);
            self.params = params.to_vec();
            self.of = Some(Arc::clone(program));
        }
        self.registers.reshape(registers, length);
    }
}

/// Whether numbers are the same to the last bit, the sign of a zero included.
pub(super) fn are_same(some: &[f64], others: &[f64]) -> bool {
    some.iter().map(|number| number.to_bits()).eq(others.iter().map(|number| number.to_bits()))
}

/// Cuts a register to `length`: only the last block is shorter than those before.
fn shorten(row: &mut &mut [f64], length: usize) {
    if let Some((short, _)) = std::mem::take(row).split_at_mut_checked(length) {
        *row = short;
    }
}

multiversion! {
    /// Runs every step on one block.
    fn run(
        steps: &[Step],
        numbers: (&[f64], &[SplineCall], usize),
        samples: Samples<'_>,
        rows: &mut [&mut [f64]],
    ) {
        let (uniform, splines, outputs) = numbers;
        for step in steps {
            match *step {
                Step::Compute { target, op } => {
                    let row = taken(rows, target);
                    compute(op.map(|operand| block(operand, uniform, samples, rows)), splines, row);
                    give_back(rows, target, row);
                }
                Step::Accumulate { target, sum, factors, is_subtracted } => {
                    let row = taken(rows, target);
                    let [sum, a, b] = [sum, factors[0], factors[1]].map(|operand| block(operand, uniform, samples, rows));
                    if target < outputs {
                        accumulate(row, sum, [a, b], is_subtracted, canonical);
                    } else {
                        accumulate(row, sum, [a, b], is_subtracted, |value| value);
                    }
                    give_back(rows, target, row);
                }
                Step::Pair { pairing, targets: [first, second], argument } => {
                    let (sine, cosine) = (taken(rows, first), taken(rows, second));
                    pair(pairing, sine, cosine, block(argument, uniform, samples, rows));
                    give_back(rows, first, sine);
                    give_back(rows, second, cosine);
                }
                Step::Copy { target, from } => {
                    let row = taken(rows, target);
                    unary(row, block(from, uniform, samples, rows), |value| value);
                    give_back(rows, target, row);
                }
            }
        }
    }
}

/// The row to be written: nothing reads it meanwhile.
#[inline(always)]
fn taken<'a>(rows: &mut [&'a mut [f64]], index: usize) -> &'a mut [f64] {
    std::mem::take(rows.get_mut(index).expect("the schedule counts its rows"))
}

#[inline(always)]
fn give_back<'a>(rows: &mut [&'a mut [f64]], index: usize, row: &'a mut [f64]) {
    *rows.get_mut(index).expect("the schedule counts its rows") = row;
}

#[inline(always)]
fn block<'a>(operand: Operand, uniform: &[f64], samples: Samples<'a>, rows: &'a [&mut [f64]]) -> Block<'a> {
    match operand {
        Operand::Uniform(index) => Block::Same(*uniform.get(index).expect("every uniform op has a value")),
        Operand::Variable(Variable::U) => Block::Each(samples.u),
        Operand::Variable(Variable::V) => Block::Each(samples.v),
        Operand::Variable(Variable::T) => Block::Each(samples.t),
        Operand::Row(index) => Block::Each(rows.get(index).expect("the schedule counts its rows")),
    }
}

/// The values of the uniform ops, in order.
fn uniform_values(program: &Program, params: &[f64]) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::with_capacity(program.uniform().len());
    for op in program.uniform() {
        let value = match op.map(|id| *values.get(id.index()).expect("operands come before their op")) {
            Op::Constant(value) => value,
            Op::Parameter(index) => *params.get(index).expect("the number of parameters was checked"),
            Op::Variable(_) => f64::NAN,
            Op::Neg(a) => -a,
            Op::Add(a, b) => a + b,
            Op::Sub(a, b) => a - b,
            Op::Mul(a, b) => a * b,
            Op::Div(a, b) => a / b,
            Op::Sqrt(a) => a.sqrt(),
            Op::Call1(function, a) => function.value(&[a]),
            Op::Call2(function, a, b) => function.value(&[a, b]),
            Op::Spline1(index, a) => spline(program.splines(), index)(a, 0.0),
            Op::Spline2(index, a, b) => spline(program.splines(), index)(a, b),
        };
        values.push(value);
    }
    values
}

/// One op over a block.
#[inline(always)]
fn compute(op: Op<Block<'_>>, splines: &[SplineCall], target: &mut [f64]) {
    match op {
        // Read in place, never computed: see `Schedule`.
        Op::Constant(_) | Op::Parameter(_) | Op::Variable(_) => {}
        Op::Neg(a) => unary(target, a, |a| -a),
        Op::Add(a, b) => binary(target, a, b, |a, b| a + b),
        Op::Sub(a, b) => binary(target, a, b, |a, b| a - b),
        Op::Mul(a, b) => binary(target, a, b, |a, b| a * b),
        Op::Div(a, b) => binary(target, a, b, |a, b| a / b),
        // Correctly rounded by IEEE 754, so the same from the hardware as from libm.
        Op::Sqrt(a) => unary(target, a, f64::sqrt),
        Op::Call1(function, a) => call1(function, target, a),
        Op::Call2(function, a, b) => call2(function, target, a, b),
        Op::Spline1(index, a) => {
            let value = spline(splines, index);
            unary(target, a, |a| value(a, 0.0));
        }
        Op::Spline2(index, a, b) => binary(target, a, b, spline(splines, index)),
    }
}

/// A spline of the program as a function.
fn spline(splines: &[SplineCall], index: usize) -> impl Fn(f64, f64) -> f64 {
    let call = splines.get(index).expect("a program has the splines that its ops name");
    |a, b| call.value(a, b)
}

/// A function of one argument: by its kernel if it has one, else lane by lane.
#[inline(always)]
fn call1(function: Function, target: &mut [f64], a: Block<'_>) {
    match (function, a) {
        (Function::Sin, Block::Each(a)) => elementary::map::<Sin>(target, a),
        (Function::Cos, Block::Each(a)) => elementary::map::<Cos>(target, a),
        (Function::Tan, Block::Each(a)) => elementary::map::<Tan>(target, a),
        (Function::Exp, Block::Each(a)) => elementary::map::<Exp>(target, a),
        (Function::Sinh, Block::Each(a)) => elementary::map::<Sinh>(target, a),
        (Function::Cosh, Block::Each(a)) => elementary::map::<Cosh>(target, a),
        (Function::Tanh, Block::Each(a)) => elementary::map::<Tanh>(target, a),
        (Function::Ln, Block::Each(a)) => elementary::map::<Ln>(target, a),
        _ => match function.row().value {
            Value::Unary(f) => unary(target, a, f),
            Value::Binary(_) => target.fill(f64::NAN),
        },
    }
}

#[inline(always)]
fn call2(function: Function, target: &mut [f64], a: Block<'_>, b: Block<'_>) {
    match function.row().value {
        Value::Unary(_) => target.fill(f64::NAN),
        Value::Binary(f) => binary(target, a, b, f),
    }
}

/// Two functions of one argument, which varies: else both would be uniform.
#[inline(always)]
fn pair(pairing: Pairing, first: &mut [f64], second: &mut [f64], a: Block<'_>) {
    let Block::Each(a) = a else { return };
    match pairing {
        Pairing::SinCos => elementary::map_pair::<SinCos>(first, second, a),
        Pairing::SinhCosh => elementary::map_pair::<SinhCosh>(first, second, a),
    }
}

/// `sum ± a * b`, rounded after the product and after the sum, and then `stored`.
#[inline(always)]
fn accumulate(
    target: &mut [f64],
    sum: Block<'_>,
    factors: [Block<'_>; 2],
    is_subtracted: bool,
    stored: impl Fn(f64) -> f64,
) {
    // Taking the sign into a factor changes no rounding.
    let signed = |a: f64| if is_subtracted { -a } else { a };
    let targets = target.iter_mut();
    match (sum, factors) {
        (Block::Each(sum), [Block::Same(a), Block::Each(b)] | [Block::Each(b), Block::Same(a)]) => {
            let a = signed(a);
            targets.zip(sum.iter().zip(b)).for_each(|(target, (&sum, &b))| *target = stored(sum + a * b));
        }
        (Block::Each(sum), [Block::Each(a), Block::Each(b)]) => {
            let lanes = targets.zip(sum.iter().zip(a.iter().zip(b)));
            lanes.for_each(|(target, (&sum, (&a, &b)))| *target = stored(sum + signed(a) * b));
        }
        (Block::Same(sum), [Block::Same(a), Block::Each(b)] | [Block::Each(b), Block::Same(a)]) => {
            let a = signed(a);
            targets.zip(b).for_each(|(target, &b)| *target = stored(sum + a * b));
        }
        (Block::Same(sum), [Block::Each(a), Block::Each(b)]) => {
            targets.zip(a.iter().zip(b)).for_each(|(target, (&a, &b))| *target = stored(sum + signed(a) * b));
        }
        // A product of uniform values is uniform and never absorbed.
        (_, [Block::Same(_), Block::Same(_)]) => target.fill(f64::NAN),
    }
}

#[inline(always)]
fn unary(target: &mut [f64], a: Block<'_>, f: impl Fn(f64) -> f64) {
    match a {
        Block::Same(a) => target.fill(canonical(f(a))),
        Block::Each(a) => target.iter_mut().zip(a).for_each(|(target, &a)| *target = canonical(f(a))),
    }
}

#[inline(always)]
fn binary(target: &mut [f64], a: Block<'_>, b: Block<'_>, f: impl Fn(f64, f64) -> f64) {
    let f = |a, b| canonical(f(a, b));
    match (a, b) {
        (Block::Same(a), Block::Same(b)) => target.fill(f(a, b)),
        (Block::Same(a), Block::Each(b)) => target.iter_mut().zip(b).for_each(|(target, &b)| *target = f(a, b)),
        (Block::Each(a), Block::Same(b)) => target.iter_mut().zip(a).for_each(|(target, &a)| *target = f(a, b)),
        (Block::Each(a), Block::Each(b)) => {
            target.iter_mut().zip(a.iter().zip(b)).for_each(|(target, (&a, &b))| *target = f(a, b));
        }
    }
}
