//! What `auto` prepares where it chooses `exact`: whether that resolves thin layers shows only while it solves, and where it
//! does not, `fourier` may know the functions of u in closed form.

use std::sync::{Mutex, OnceLock, PoisonError};

use super::exact::Exact;
use super::fourier::{Fourier, LEAST_TOLERANCE};
use super::{Method, Numbers, Options, Solution, Solver, passed_over};
use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic};
use crate::problem::DomainValues;

/// A solver that asks `fourier` where layers are too thin for `exact`.
pub struct ExactOrFourier {
    exact: Box<dyn Solver>,
    /// Compiled when it is asked for.
    fourier: OnceLock<Result<Box<dyn Solver>, Diagnostic>>,
    decomposition: Decomposition,
    options: Options,
    /// Where `exact` failed last: it would fail there at every instant, and takes longest to do so.
    failed: Mutex<Option<Failure>>,
}

/// The numbers for which there is no solution, and why.
struct Failure {
    params: Vec<f64>,
    ranges: [[f64; 2]; 2],
    reason: Diagnostic,
}

impl ExactOrFourier {
    /// Compiles the problem for `exact`.
    ///
    /// # Errors
    /// As [`Method::prepare`] of `exact`.
    pub fn prepare(decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        Ok(Box::new(ExactOrFourier {
            exact: Exact.prepare(decomposition, options)?,
            fourier: OnceLock::new(),
            decomposition: decomposition.clone(),
            options: options.clone(),
            failed: Mutex::default(),
        }))
    }

    fn solve_exactly(&self, params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        // A panic elsewhere leaves either the one failure or the other.
        let lock = || self.failed.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = lock().as_ref().filter(|known| known.params == params && known.ranges == ranges) {
            return Err(known.reason.clone());
        }
        self.exact.solve(params, ranges, t).inspect_err(|reason| {
            *lock() = Some(Failure { params: params.to_vec(), ranges, reason: reason.clone() });
        })
    }

    fn solve_by_series(&self, params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let [u, v] = ranges;
        let numbers = Numbers { params, domain: &DomainValues { u, v, t: [t, t] } };
        Fourier.accepts(&self.decomposition, &self.options.limits)?;
        Fourier.suits(&self.decomposition, &numbers, &self.options.limits)?;
        let prepared = self.fourier.get_or_init(|| {
            let mut settings = self.options.settings.clone().only(Fourier.settings());
            // The tolerance is `exact`'s, which may be smaller.
            settings.tolerance = settings.tolerance.map(|(tolerance, at)| (tolerance.max(LEAST_TOLERANCE), at));
            Fourier.prepare(&self.decomposition, &Options { settings, ..self.options.clone() })
        });
        prepared.as_ref().map_err(Diagnostic::clone)?.solve(params, ranges, t)
    }
}

impl Solver for ExactOrFourier {
    fn solve(&self, params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let reason = match self.solve_exactly(params, ranges, t) {
            Err(reason) if reason.code == Code::LayersTooThin => reason,
            solved => return solved,
        };
        match self.solve_by_series(params, ranges, t) {
            Ok(mut solution) => {
                solution.report.warnings.insert(0, passed_over(Exact.name(), Fourier.name(), &reason));
                Ok(solution)
            }
            Err(other) if other.message == reason.message => Err(reason),
            Err(other) => Err(reason.hint(format!("{}: {}", Fourier.name(), other.message))),
        }
    }

    fn is_everlasting(&self, solution: &Solution) -> bool {
        solution.report.method == Exact.name() && self.exact.is_everlasting(solution)
    }
}
