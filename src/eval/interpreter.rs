//! Runs a program op by op over blocks of samples.
//!
//! Input: a [`Program`]; output: an evaluator whose every step is a loop over a block, so that the cost of
//! choosing an op is shared by [`BLOCK`] samples and the loops vectorise.
//!
//! Invariant: a step never writes a register that it reads, because the register of a dead operand is released
//! after the target has been chosen. Coordinates and uniform values are read where they are, not copied.
//! The plain definition of an evaluator: the machine code is tested against it.

use std::sync::Arc;

use crate::expr::{Function, Value, Variable};

use super::program::{Op, OpId, Program};
use super::{EvalError, Evaluator, Samples, canonical, checked_points};

/// Samples a step treats at once: 2 KiB a register, so that a dozen live registers stay in the first-level cache.
const BLOCK: usize = 256;

/// Where a step finds an operand.
#[derive(Debug, Clone, Copy)]
enum Operand {
    Uniform(usize),
    Variable(Variable),
    Register(usize),
}

#[derive(Debug, Clone, Copy)]
enum Step {
    Compute {
        target: usize,
        op: Op<Operand>,
    },
    /// Written as soon as it is known, so that outputs do not hold registers.
    Store {
        output: usize,
        from: Operand,
    },
}

/// An operand in one block.
#[derive(Clone, Copy)]
enum Block<'a> {
    Same(f64),
    Each(&'a [f64]),
}

/// The evaluator that runs everywhere.
pub(super) struct Interpreter {
    program: Arc<Program>,
    steps: Vec<Step>,
    registers: usize,
}

impl Interpreter {
    pub(super) fn new(program: Arc<Program>) -> Self {
        let (steps, registers) = steps(&program);
        Interpreter { program, steps, registers }
    }

    /// Runs every step on one block, and hands every output to `store`.
    fn run(
        &self,
        uniform: &[f64],
        samples: Samples<'_>,
        registers: &mut [f64],
        mut store: impl FnMut(usize, Block<'_>),
    ) {
        let length = samples.u.len();
        for step in &self.steps {
            match *step {
                Step::Compute { target, op } => {
                    let (before, rest) = registers.split_at_mut(target * length);
                    let (block, after) = rest.split_at_mut(length);
                    let inputs = Inputs { uniform, samples, before, after };
                    compute(op.map(|operand| inputs.block(operand)), block);
                }
                Step::Store { output, from } => {
                    let inputs = Inputs { uniform, samples, before: registers, after: &[] };
                    store(output, inputs.block(from));
                }
            }
        }
    }
}

impl Evaluator for Interpreter {
    fn program(&self) -> &Program {
        &self.program
    }

    fn evaluate(&self, params: &[f64], samples: Samples<'_>, values: &mut [f64]) -> Result<(), EvalError> {
        let points = checked_points(&self.program, params, samples, values)?;
        let uniform = uniform_values(&self.program, params);
        let mut registers = vec![0.0; self.registers * points.min(BLOCK)];
        let blocks = samples.u.chunks(BLOCK).zip(samples.v.chunks(BLOCK)).zip(samples.t.chunks(BLOCK));
        for (index, ((u, v), t)) in blocks.enumerate() {
            self.run(&uniform, Samples { u, v, t }, &mut registers, |output, block| {
                let start = output * points + index * BLOCK;
                let row = values.get_mut(start..start + u.len()).expect("values are outputs times points long");
                match block {
                    Block::Same(value) => row.fill(canonical(value)),
                    Block::Each(block) => row.iter_mut().zip(block).for_each(|(value, &x)| *value = canonical(x)),
                }
            });
        }
        Ok(())
    }
}

/// Everything a step may read: all registers but its target, which lies between `before` and `after`.
struct Inputs<'a> {
    uniform: &'a [f64],
    samples: Samples<'a>,
    before: &'a [f64],
    after: &'a [f64],
}

impl<'a> Inputs<'a> {
    fn block(&self, operand: Operand) -> Block<'a> {
        match operand {
            Operand::Uniform(index) => Block::Same(*self.uniform.get(index).expect("every uniform op has a value")),
            Operand::Variable(Variable::U) => Block::Each(self.samples.u),
            Operand::Variable(Variable::V) => Block::Each(self.samples.v),
            Operand::Variable(Variable::T) => Block::Each(self.samples.t),
            Operand::Register(index) => {
                let length = self.samples.u.len();
                let start = index * length;
                let register = if start < self.before.len() {
                    self.before.get(start..start + length)
                } else {
                    // The target, of one register's length, is left out.
                    let start = start - self.before.len() - length;
                    self.after.get(start..start + length)
                };
                Block::Each(register.expect("an operand is in a register other than the target"))
            }
        }
    }
}

/// The steps of a program and the number of registers they use.
fn steps(program: &Program) -> (Vec<Step>, usize) {
    let varying = || program.varying().iter().enumerate().map(|(index, &op)| (program.uniform().len() + index, op));
    let mut last_use = vec![0; program.ops().len()];
    for (id, op) in varying() {
        for operand in op.operands() {
            if let Some(last) = last_use.get_mut(operand.index()) {
                *last = id;
            }
        }
    }
    let mut outputs: Vec<(OpId, usize)> = program.output_ops().iter().copied().zip(0..).collect();
    outputs.sort_unstable();
    let mut outputs = outputs.into_iter().peekable();
    let mut places: Vec<Operand> = (0..program.uniform().len()).map(Operand::Uniform).collect();
    let mut steps: Vec<Step> = Vec::new();
    while let Some((id, output)) = outputs.next_if(|(id, _)| id.index() < places.len()) {
        steps.push(Step::Store { output, from: Operand::Uniform(id.index()) });
    }
    let (mut free, mut registers) = (Vec::new(), 0);
    for (id, op) in varying() {
        let place_of = |operand: OpId| *places.get(operand.index()).expect("operands come before their op");
        let place = if let Op::Variable(variable) = op {
            Operand::Variable(variable)
        } else {
            let target = free.pop().unwrap_or_else(|| {
                registers += 1;
                registers - 1
            });
            steps.push(Step::Compute { target, op: op.map(place_of) });
            Operand::Register(target)
        };
        let mut dying: Vec<OpId> = op.operands().filter(|operand| last_use.get(operand.index()) == Some(&id)).collect();
        dying.dedup();
        free.extend(dying.into_iter().map(place_of).filter_map(Operand::register));
        places.push(place);
        while let Some((_, output)) = outputs.next_if(|(output, _)| output.index() == id) {
            steps.push(Step::Store { output, from: place });
        }
        // An output that nothing else reads is done with once it is stored.
        if last_use.get(id) == Some(&0) {
            free.extend(place.register());
        }
    }
    (steps, registers)
}

impl Operand {
    fn register(self) -> Option<usize> {
        match self {
            Operand::Register(register) => Some(register),
            Operand::Uniform(_) | Operand::Variable(_) => None,
        }
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
        };
        values.push(value);
    }
    values
}

/// One op over a block.
fn compute(op: Op<Block<'_>>, target: &mut [f64]) {
    match op {
        // Read in place, never computed: see `steps`.
        Op::Constant(_) | Op::Parameter(_) | Op::Variable(_) => {}
        Op::Neg(a) => unary(target, a, |a| -a),
        Op::Add(a, b) => binary(target, a, b, |a, b| a + b),
        Op::Sub(a, b) => binary(target, a, b, |a, b| a - b),
        Op::Mul(a, b) => binary(target, a, b, |a, b| a * b),
        Op::Div(a, b) => binary(target, a, b, |a, b| a / b),
        // Correctly rounded by IEEE 754, so the same from the hardware as from libm.
        Op::Sqrt(a) => unary(target, a, f64::sqrt),
        Op::Call1(function, a) => match function.row().value {
            Value::Unary(f) => unary(target, a, f),
            Value::Binary(_) => target.fill(f64::NAN),
        },
        Op::Call2(function, a, b) => call2(function, target, a, b),
    }
}

fn call2(function: Function, target: &mut [f64], a: Block<'_>, b: Block<'_>) {
    match function.row().value {
        Value::Unary(_) => target.fill(f64::NAN),
        Value::Binary(f) => binary(target, a, b, f),
    }
}

fn unary(target: &mut [f64], a: Block<'_>, f: impl Fn(f64) -> f64) {
    match a {
        Block::Same(a) => target.fill(f(a)),
        Block::Each(a) => target.iter_mut().zip(a).for_each(|(target, &a)| *target = f(a)),
    }
}

fn binary(target: &mut [f64], a: Block<'_>, b: Block<'_>, f: impl Fn(f64, f64) -> f64) {
    match (a, b) {
        (Block::Same(a), Block::Same(b)) => target.fill(f(a, b)),
        (Block::Same(a), Block::Each(b)) => target.iter_mut().zip(b).for_each(|(target, &b)| *target = f(a, b)),
        (Block::Each(a), Block::Same(b)) => target.iter_mut().zip(a).for_each(|(target, &a)| *target = f(a, b)),
        (Block::Each(a), Block::Each(b)) => {
            target.iter_mut().zip(a.iter().zip(b)).for_each(|(target, (&a, &b))| *target = f(a, b));
        }
    }
}
