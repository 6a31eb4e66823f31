//! The order of work on one block: which row each op of a program is computed in.
//!
//! Input: a [`Program`]; output: a [`Schedule`], steps over rows of one block. There is a row for each output, then
//! registers, which are used again and again. An op that is an output is computed in that output's row and read
//! from there.
//!
//! Invariant: a step never writes a row that it reads, because the register of a dead operand is released after the
//! target has been chosen.

use rustc_hash::FxHashMap;

use crate::expr::{Function, Variable};

use super::program::{Op, OpId, Program};

/// Where a step finds an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operand {
    Uniform(usize),
    Variable(Variable),
    Row(usize),
}

/// Functions of one argument that are cheaper together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Pairing {
    SinCos,
    SinhCosh,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Step {
    Compute {
        target: usize,
        op: Op<Operand>,
    },
    /// `sum + a * b`, or `sum - a * b`, with both roundings: one loop for two ops.
    Accumulate {
        target: usize,
        sum: Operand,
        factors: [Operand; 2],
        is_subtracted: bool,
    },
    Pair {
        pairing: Pairing,
        targets: [usize; 2],
        argument: Operand,
    },
    /// An output that is uniform, a coordinate or the same as one before.
    Copy {
        target: usize,
        from: Operand,
    },
}

/// Steps over the rows of the outputs and of `registers`.
pub(super) struct Schedule {
    steps: Vec<Step>,
    registers: usize,
}

impl Schedule {
    pub(super) fn of(program: &Program) -> Schedule {
        let mut allocation = Allocation::new(program);
        for (index, &op) in program.varying().iter().enumerate() {
            allocation.compute(program.uniform().len() + index, op);
        }
        let copies = program.output_ops().iter().enumerate().filter_map(|(target, id)| {
            let from = allocation.operand(*id);
            (from != Operand::Row(target)).then_some(Step::Copy { target, from })
        });
        let copies: Vec<Step> = copies.collect();
        allocation.steps.extend(copies);
        Schedule { steps: allocation.steps, registers: allocation.registers }
    }

    pub(super) fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// How many rows follow those of the outputs.
    pub(super) fn registers(&self) -> usize {
        self.registers
    }
}

/// The pair a function belongs to, and whether it is the second of it.
fn pairing(op: Op) -> Option<(Pairing, OpId, usize)> {
    match op {
        Op::Call1(Function::Sin, a) => Some((Pairing::SinCos, a, 0)),
        Op::Call1(Function::Cos, a) => Some((Pairing::SinCos, a, 1)),
        Op::Call1(Function::Sinh, a) => Some((Pairing::SinhCosh, a, 0)),
        Op::Call1(Function::Cosh, a) => Some((Pairing::SinhCosh, a, 1)),
        _ => None,
    }
}

/// Which products are the right operand of a sum or difference, of no other op, and no output.
fn absorbed(program: &Program) -> Vec<bool> {
    let mut uses = vec![0_usize; program.ops().len()];
    for id in program.ops().iter().flat_map(|op| op.operands()).chain(program.output_ops().iter().copied()) {
        if let Some(count) = uses.get_mut(id.index()) {
            *count += 1;
        }
    }
    let mut is_absorbed = vec![false; uses.len()];
    for op in program.varying() {
        if let Op::Add(_, term) | Op::Sub(_, term) = op
            && term.index() >= program.uniform().len()
            && matches!(program.ops().get(term.index()), Some(Op::Mul(..)))
            && uses.get(term.index()) == Some(&1)
            && let Some(mark) = is_absorbed.get_mut(term.index())
        {
            *mark = true;
        }
    }
    is_absorbed
}

/// The sum, the factors of the absorbed product that is added to it, and whether it is subtracted instead.
fn accumulation(program: &Program, is_absorbed: &[bool], op: Op) -> Option<(OpId, [OpId; 2], bool)> {
    let (Op::Add(sum, term) | Op::Sub(sum, term)) = op else { return None };
    match program.ops().get(term.index()) {
        Some(&Op::Mul(a, b)) if is_absorbed.get(term.index()) == Some(&true) => {
            Some((sum, [a, b], matches!(op, Op::Sub(..))))
        }
        _ => None,
    }
}

/// What the step of an op reads.
fn reads(program: &Program, is_absorbed: &[bool], op: Op) -> Vec<OpId> {
    match accumulation(program, is_absorbed, op) {
        Some((sum, [a, b], _)) => vec![sum, a, b],
        None => op.operands().collect(),
    }
}

struct Allocation<'a> {
    program: &'a Program,
    /// Where each op is found; `None` if it has not been computed.
    places: Vec<Option<Operand>>,
    /// The last op that reads each op; zero if none does. Products that are taken over by their sum read nothing.
    last_use: Vec<usize>,
    /// The first output that is this op.
    output_of: FxHashMap<usize, usize>,
    /// The ops that are the first and the second function of a pair.
    pairs: FxHashMap<(Pairing, OpId), [Option<usize>; 2]>,
    /// The products that are computed by the one sum that reads them.
    is_absorbed: Vec<bool>,
    outputs: usize,
    free: Vec<usize>,
    registers: usize,
    steps: Vec<Step>,
}

impl Allocation<'_> {
    fn new(program: &Program) -> Allocation<'_> {
        let uniform = program.uniform().len();
        let is_absorbed = absorbed(program);
        let mut last_use = vec![0; program.ops().len()];
        let mut pairs: FxHashMap<_, [Option<usize>; 2]> = FxHashMap::default();
        for (id, &op) in program.ops().iter().enumerate().skip(uniform) {
            if is_absorbed.get(id) == Some(&true) {
                continue;
            }
            for operand in reads(program, &is_absorbed, op) {
                if let Some(last) = last_use.get_mut(operand.index()) {
                    *last = id;
                }
            }
            if let Some((pairing, argument, place)) = pairing(op)
                && let Some(member) = pairs.entry((pairing, argument)).or_default().get_mut(place)
            {
                *member = Some(id);
            }
        }
        let mut output_of = FxHashMap::default();
        for (output, id) in program.output_ops().iter().enumerate() {
            output_of.entry(id.index()).or_insert(output);
        }
        let places = (0..program.ops().len()).map(|id| (id < uniform).then_some(Operand::Uniform(id))).collect();
        let (free, steps) = (Vec::new(), Vec::new());
        Allocation {
            program,
            places,
            last_use,
            output_of,
            pairs,
            is_absorbed,
            outputs: program.outputs(),
            free,
            registers: 0,
            steps,
        }
    }

    fn operand(&self, id: OpId) -> Operand {
        self.places.get(id.index()).copied().flatten().expect("operands come before their op")
    }

    /// The step that computes op `id`, unless it came with the other of its pair.
    fn compute(&mut self, id: usize, op: Op) {
        if self.is_absorbed.get(id) == Some(&true) {
            return;
        }
        if self.places.get(id).is_some_and(Option::is_some) {
            return self.release(id, op);
        }
        if let Op::Variable(variable) = op {
            return self.put(id, Operand::Variable(variable));
        }
        let both = pairing(op).and_then(|(pairing, argument, _)| {
            let [first, second] = *self.pairs.get(&(pairing, argument))?;
            Some((pairing, argument, first?, second?))
        });
        if let Some((pairing, argument, first, second)) = both {
            let targets = [first, second].map(|member| self.row_for(member));
            self.steps.push(Step::Pair { pairing, targets, argument: self.operand(argument) });
        } else if let Some((sum, factors, is_subtracted)) = accumulation(self.program, &self.is_absorbed, op) {
            let target = self.row_for(id);
            let (sum, factors) = (self.operand(sum), factors.map(|factor| self.operand(factor)));
            self.steps.push(Step::Accumulate { target, sum, factors, is_subtracted });
        } else {
            let target = self.row_for(id);
            self.steps.push(Step::Compute { target, op: op.map(|operand| self.operand(operand)) });
        }
        self.release(id, op);
    }

    /// Chooses the row of op `id`.
    fn row_for(&mut self, id: usize) -> usize {
        let row = self.output_of.get(&id).copied().or_else(|| self.free.pop()).unwrap_or_else(|| {
            self.registers += 1;
            self.outputs + self.registers - 1
        });
        self.put(id, Operand::Row(row));
        row
    }

    fn put(&mut self, id: usize, operand: Operand) {
        if let Some(place) = self.places.get_mut(id) {
            *place = Some(operand);
        }
    }

    /// Gives back the registers of the operands that op `id` is the last to read.
    fn release(&mut self, id: usize, op: Op) {
        let mut dying = reads(self.program, &self.is_absorbed, op);
        dying.retain(|operand| self.last_use.get(operand.index()) == Some(&id));
        dying.sort_unstable();
        dying.dedup();
        for operand in dying {
            match self.operand(operand) {
                Operand::Row(row) if row >= self.outputs => self.free.push(row),
                _ => {}
            }
        }
    }
}
