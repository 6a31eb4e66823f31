//! Values of expressions at many points: one program, two interchangeable evaluators.
//!
//! [`Program::compile`] lowers expressions to straight-line code; [`compile`] makes an [`Evaluator`] of it, either
//! machine code or an interpreter. Invariant: for every input, both give the same bits. They run the same ops in
//! the same order in IEEE double arithmetic and call the same functions of the operator table; the one freedom
//! the standard leaves, sign and payload of a NaN, is taken away where outputs are stored. So which of them runs is
//! a question of time alone: the interpreter for many samples, machine code for few (`adaptive`).
//!
//! A [`Jet`] is what a surface asks for: many functions and derivatives at once, of which equal ones are computed and
//! stored once.
//!
//! Absent on purpose: judging values. Poles and overflow are results like any other; callers that need finite
//! values ask [`first_non_finite`].

#[cfg(feature = "jit")]
mod adaptive;
mod interpreter;
mod jet;
#[cfg(feature = "jit")]
mod jit;
mod lowering;
mod program;
mod schedule;

use std::sync::Arc;

use crate::diagnostic::{Code, Diagnostic};
use crate::kernels::Rows;

pub use interpreter::Workspace;
pub use jet::{Jet, JetValues};
pub use lowering::LARGEST_MULTIPLIED_POWER;
pub use program::{Op, OpId, Program};

/// The coordinates of a block of points: slices of one length.
#[derive(Debug, Clone, Copy)]
pub struct Samples<'a> {
    /// Across the blend.
    pub u: &'a [f64],
    /// Along the trimlines.
    pub v: &'a [f64],
    /// Time.
    pub t: &'a [f64],
}

/// Something that runs a [`Program`]. Every implementation gives the same bits.
pub trait Evaluator: Send + Sync {
    /// The program it runs.
    fn program(&self) -> &Program;

    /// Writes every output at every sample: row k of `values`, one entry a sample, is output k.
    ///
    /// `params` holds a value for each of the graph's symbols; entries past [`Program::symbols`] are not read.
    /// Infinities and NaN are values; every NaN is stored as [`f64::NAN`].
    ///
    /// # Errors
    /// When a length does not fit; nothing is written in that case.
    fn evaluate(&self, params: &[f64], samples: Samples<'_>, values: &mut [f64]) -> Result<(), EvalError>;

    /// The same, into `target`, which gets a row for each output; what the work needs is kept in `workspace` for the next
    /// call, which then begins sooner. A workspace may go from one evaluator to another.
    ///
    /// # Errors
    /// As [`Evaluator::evaluate`].
    fn evaluate_rows(
        &self,
        params: &[f64],
        samples: Samples<'_>,
        target: &mut Rows,
        _workspace: &mut Workspace,
    ) -> Result<(), EvalError> {
        let (count, points) = (self.program().outputs(), samples.u.len());
        let mut values = vec![0.0; count.saturating_mul(points)];
        self.evaluate(params, samples, &mut values)?;
        target.reshape(count, points);
        for (row, values) in target.iter_mut().zip(values.chunks(points.max(1))) {
            row.copy_from_slice(values);
        }
        Ok(())
    }
}

/// How programs are run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Backend {
    /// Whichever is sooner done: the interpreter for many samples, machine code where single ones are asked for often.
    #[default]
    Auto,
    /// The interpreter.
    Interpreter,
    /// Machine code; the interpreter, with a note, where it cannot be had.
    Jit,
}

/// A call of [`Evaluator::evaluate`] whose slices do not fit together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum EvalError {
    /// The three coordinates differ in length.
    #[error("the coordinates of the samples differ in number: u has {u}, v has {v}, t has {t}")]
    SampleLengths {
        /// Length of `u`.
        u: usize,
        /// Length of `v`.
        v: usize,
        /// Length of `t`.
        t: usize,
    },
    /// `values` is not outputs times samples long.
    #[error("the values of all outputs at all samples number {expected}, the slice for them has {found}")]
    ValueLength {
        /// Outputs times samples.
        expected: usize,
        /// Length of `values`.
        found: usize,
    },
    /// The program reads a parameter past the end of `params`.
    #[error("the program reads {expected} parameters, given are {found}")]
    MissingParameters {
        /// [`Program::symbols`].
        expected: usize,
        /// Length of `params`.
        found: usize,
    },
}

/// An evaluator for `program`, and a note when it is not the one `backend` asks for.
///
/// Never fails: the interpreter runs every program on every machine. Only [`Backend::Jit`] gives a note.
#[must_use]
pub fn compile(program: Program, backend: Backend) -> (Arc<dyn Evaluator>, Option<Diagnostic>) {
    let program = Arc::new(program);
    match backend {
        Backend::Interpreter => (interpreted(program), None),
        Backend::Auto => (adapted(program), None),
        Backend::Jit => match machine_code(&program) {
            Ok(evaluator) => (evaluator, None),
            Err(reason) => {
                let note = Diagnostic::new(Code::HostUnsupported, format!("no machine code, interpreting: {reason}"));
                (interpreted(program), Some(note))
            }
        },
    }
}

fn interpreted(program: Arc<Program>) -> Arc<dyn Evaluator> {
    Arc::new(interpreter::Interpreter::new(program))
}

#[cfg(feature = "jit")]
fn adapted(program: Arc<Program>) -> Arc<dyn Evaluator> {
    Arc::new(adaptive::Adaptive::new(program))
}

#[cfg(not(feature = "jit"))]
fn adapted(program: Arc<Program>) -> Arc<dyn Evaluator> {
    interpreted(program)
}

#[cfg(feature = "jit")]
fn machine_code(program: &Arc<Program>) -> Result<Arc<dyn Evaluator>, String> {
    Ok(Arc::new(jit::Jit::new(Arc::clone(program))?))
}

#[cfg(not(feature = "jit"))]
fn machine_code(_program: &Arc<Program>) -> Result<Arc<dyn Evaluator>, String> {
    Err("this build is without the feature `jit`".to_owned())
}

/// The first value that is infinite or NaN: output, sample and value, in the order of `values`.
///
/// `values` are rows of `points` entries, as [`Evaluator::evaluate`] writes them.
#[must_use]
pub fn first_non_finite(values: &[f64], points: usize) -> Option<(usize, usize, f64)> {
    let (index, &value) = values.iter().enumerate().find(|(_, value)| !value.is_finite())?;
    Some((index.checked_div(points)?, index.checked_rem(points)?, value))
}

/// The number of samples, once every length is known to fit the program.
fn checked_points(program: &Program, params: &[f64], samples: Samples<'_>, values: &[f64]) -> Result<usize, EvalError> {
    let points = checked_samples(program, params, samples)?;
    // A product past usize::MAX saturates to a length that no slice of doubles has.
    let expected = program.outputs().saturating_mul(points);
    if values.len() != expected {
        return Err(EvalError::ValueLength { expected, found: values.len() });
    }
    Ok(points)
}

/// The number of samples, once samples and parameters are known to fit the program.
fn checked_samples(program: &Program, params: &[f64], samples: Samples<'_>) -> Result<usize, EvalError> {
    let (u, v, t) = (samples.u.len(), samples.v.len(), samples.t.len());
    if u != v || u != t {
        return Err(EvalError::SampleLengths { u, v, t });
    }
    if params.len() < program.symbols() {
        return Err(EvalError::MissingParameters { expected: program.symbols(), found: params.len() });
    }
    Ok(u)
}

#[cfg(test)]
mod tests;
