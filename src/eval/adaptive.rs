//! Chooses the evaluator by the number of samples.
//!
//! The interpreter shares the cost of choosing an op among a block of samples and runs on whole vectors, which machine
//! code of Cranelift cannot; for a single sample that cost is most of the time. So short calls run machine code, once
//! there were enough of them to be worth compiling it. Both give the same bits: no result shows which one ran.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

use super::interpreter::{Interpreter, Workspace};
use super::jit::Jit;
use super::program::Program;
use super::{EvalError, Evaluator, Samples};
use crate::kernels::Rows;

/// From so many samples on the interpreter is faster than machine code (docs/performance.md).
const MANY: usize = 10;

/// Short calls before machine code is made: by then interpreting them has cost about what compiling costs
/// (docs/performance.md).
const CALLS: usize = 1000;

/// The interpreter, and machine code for short calls once it has paid.
pub(super) struct Adaptive {
    program: Arc<Program>,
    interpreter: Interpreter,
    short_calls: AtomicUsize,
    /// `None` in it where machine code cannot be had.
    code: OnceLock<Option<Jit>>,
}

impl Adaptive {
    pub(super) fn new(program: Arc<Program>) -> Self {
        Adaptive {
            interpreter: Interpreter::new(Arc::clone(&program)),
            program,
            short_calls: AtomicUsize::new(0),
            code: OnceLock::new(),
        }
    }

    /// What runs a call with so many samples.
    fn suited_to(&self, samples: usize) -> &dyn Evaluator {
        if samples >= MANY {
            return &self.interpreter;
        }
        let known = self.code.get().or_else(|| {
            let is_worth_it = self.short_calls.fetch_add(1, Ordering::Relaxed) >= CALLS;
            is_worth_it.then(|| self.code.get_or_init(|| Jit::new(Arc::clone(&self.program)).ok()))
        });
        match known {
            Some(Some(code)) => code,
            _ => &self.interpreter,
        }
    }
}

impl Evaluator for Adaptive {
    fn program(&self) -> &Program {
        &self.program
    }

    fn evaluate(&self, params: &[f64], samples: Samples<'_>, values: &mut [f64]) -> Result<(), EvalError> {
        self.suited_to(samples.u.len()).evaluate(params, samples, values)
    }

    fn evaluate_rows(
        &self,
        params: &[f64],
        samples: Samples<'_>,
        target: &mut Rows,
        workspace: &mut Workspace,
    ) -> Result<(), EvalError> {
        self.suited_to(samples.u.len()).evaluate_rows(params, samples, target, workspace)
    }
}
