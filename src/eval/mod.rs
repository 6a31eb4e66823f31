//! Values of expressions at many points: one program, two interchangeable evaluators.
//!
//! [`Program::compile`] lowers expressions to straight-line code; [`compile`] makes an [`Evaluator`] of it, either
//! machine code or an interpreter. Invariant: for every input, both give the same bits. They run the same ops in
//! the same order in IEEE double arithmetic and call the same functions of the operator table; the one freedom
//! the standard leaves, sign and payload of a NaN, is taken away where outputs are stored.
//!
//! Absent on purpose: judging values. Poles and overflow are results like any other; callers that need finite
//! values ask [`first_non_finite`].

mod interpreter;
#[cfg(feature = "jit")]
mod jit;
mod program;
mod schedule;

use std::sync::Arc;

use crate::diagnostic::{Code, Diagnostic};

pub use program::{LARGEST_MULTIPLIED_POWER, Op, OpId, Program};

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
}

/// How programs are run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Backend {
    /// Machine code where it can be had, the interpreter elsewhere.
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
/// Never fails: the interpreter runs every program on every machine. [`Backend::Auto`] gives a note only when
/// machine code was to be had in this build, but not on this machine or for this program.
#[must_use]
pub fn compile(program: Program, backend: Backend) -> (Arc<dyn Evaluator>, Option<Diagnostic>) {
    let program = Arc::new(program);
    let interpret = |program| -> Arc<dyn Evaluator> { Arc::new(interpreter::Interpreter::new(program)) };
    if backend == Backend::Interpreter {
        return (interpret(program), None);
    }
    match machine_code(&program) {
        Ok(evaluator) => (evaluator, None),
        Err(reason) => {
            let is_note_due = cfg!(feature = "jit") || backend == Backend::Jit;
            let note = || Diagnostic::new(Code::HostUnsupported, format!("no machine code, interpreting: {reason}"));
            (interpret(program), is_note_due.then(note))
        }
    }
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
    let (u, v, t) = (samples.u.len(), samples.v.len(), samples.t.len());
    if u != v || u != t {
        return Err(EvalError::SampleLengths { u, v, t });
    }
    // A product past usize::MAX saturates to a length that no slice of doubles has.
    let expected = program.outputs().saturating_mul(u);
    if values.len() != expected {
        return Err(EvalError::ValueLength { expected, found: values.len() });
    }
    if params.len() < program.symbols() {
        return Err(EvalError::MissingParameters { expected: program.symbols(), found: params.len() });
    }
    Ok(u)
}

#[cfg(test)]
mod tests;
