//! The spec as it is now: the last text that could be read, ready to be solved, and what is wrong with the newest.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use tokio::sync::watch;

use trimline::limits::Limits;

use super::pieces::{Compiled, Piece, Solutions};
use crate::failure::Failure;
use crate::options::{Solving, Terminal};
use crate::workflow::Spec;

/// A spec that is read again when its file changes.
pub struct Live {
    /// Its path, or `-`.
    pub path: String,
    solving: Solving,
    points: Option<String>,
    state: Mutex<State>,
    /// How often it was read.
    pub revision: watch::Sender<u64>,
}

struct State {
    /// The last spec without errors.
    good: Option<Ready>,
    /// Why the newest text is not it.
    failure: Option<Failure>,
    /// From the first sign of the last save until its text was read and compiled.
    reading: Duration,
}

/// A spec whose parts are compiled.
struct Ready {
    spec: Spec,
    compiled: Compiled,
    /// The newest solutions: a page asks for the same ones several times, for positions, residuals and files.
    known: Option<Known>,
}

/// The spec with values from the page, and its parts solved at one instant.
struct Known {
    changes: Vec<String>,
    spec: Spec,
    times: [f64; 2],
    time: f64,
    solutions: Solutions,
}

/// A spec with values from the page, and its parts solved at one instant.
pub struct Answerable<'a> {
    pub spec: &'a Spec,
    /// How often the spec was read.
    pub revision: u64,
    /// The instants that all parts have.
    pub times: [f64; 2],
    /// The instant of the solutions.
    pub time: f64,
    pub pieces: Vec<Piece<'a>>,
}

impl Live {
    /// Reads the spec; only a path that cannot be read is a failure.
    pub fn open(path: String, solving: Solving, points: Option<String>) -> Result<Live, Failure> {
        let compiled = Ready::read(&path, &solving, points.as_deref());
        let state = match compiled {
            Ok(compiled) => State { good: Some(compiled), failure: None, reading: Duration::ZERO },
            Err(failure @ (Failure::Found { .. } | Failure::Option { .. })) => {
                State { good: None, failure: Some(failure), reading: Duration::ZERO }
            }
            Err(failure) => return Err(failure),
        };
        Ok(Live { path, solving, points, state: Mutex::new(state), revision: watch::Sender::new(1) })
    }

    /// The limits on what is read.
    pub fn limits(&self) -> Limits {
        self.solving.reading.limits().unwrap_or_default()
    }

    /// From the first sign of the last save until its text was read and compiled.
    pub fn reading(&self) -> Duration {
        self.state().reading
    }

    /// Says on standard error what is wrong.
    pub fn print_findings(&self, terminal: &Terminal) {
        if let Some(failure) = &self.state().failure {
            failure.print(terminal);
        }
    }

    /// Reads the file again, of which `saved` was the first sign of a change; the last good text stays until there is a
    /// better one.
    pub fn reload(&self, saved: Instant) {
        let compiled = Ready::read(&self.path, &self.solving, self.points.as_deref());
        let mut state = self.state();
        match compiled {
            Ok(compiled) => *state = State { good: Some(compiled), failure: None, reading: saved.elapsed() },
            Err(failure) => state.failure = Some(failure),
        }
        // Before anybody can be answered from the new text.
        self.revision.send_modify(|revision| *revision += 1);
    }

    /// Solves the last good text with `changes` at `time`, and gives it and what is wrong with the newest text to
    /// `answer`; `None` if there is no good text.
    ///
    /// One at a time: a solution may take all the memory that limits allow.
    pub fn answer<T>(
        &self,
        changes: &[String],
        time: Option<f64>,
        answer: impl FnOnce(Option<Result<Answerable<'_>, Failure>>, Option<&Failure>) -> T,
    ) -> T {
        let mut state = self.state();
        let revision = *self.revision.borrow();
        let State { good, failure, .. } = &mut *state;
        let Some(compiled) = good else { return answer(None, failure.as_ref()) };
        let answerable = compiled.answerable(changes, time.or(self.solving.time), revision);
        answer(Some(answerable), failure.as_ref())
    }

    /// As [`Live::answer`], for what is only there with a surface.
    pub fn answer_with<T>(
        &self,
        changes: &[String],
        time: Option<f64>,
        answer: impl FnOnce(&Answerable<'_>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        self.answer(changes, time, |answerable, _| match answerable {
            Some(answerable) => answer(&answerable?),
            None => Err(Failure::Usage("the spec has errors, so there is no surface".to_owned())),
        })
    }

    fn state(&self) -> MutexGuard<'_, State> {
        // A panic elsewhere leaves a spec that can still be solved.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Ready {
    fn read(path: &str, solving: &Solving, points: Option<&str>) -> Result<Ready, Failure> {
        let spec = Spec::read(path, &solving.reading)?;
        let compiled = Compiled::new(&spec, solving, points)?;
        Ok(Ready { spec, compiled, known: None })
    }

    fn answerable(&mut self, changes: &[String], time: Option<f64>, revision: u64) -> Result<Answerable<'_>, Failure> {
        let known =
            self.known.take().filter(|known| known.changes == changes && instant(time, known.times) == known.time);
        let known = match known {
            Some(known) => known,
            None => self.solve(changes, time)?,
        };
        let Known { spec, times, time, solutions, .. } = self.known.insert(known);
        let pieces = self.compiled.pieces(spec, solutions, *time)?;
        Ok(Answerable { spec, revision, times: *times, time: *time, pieces })
    }

    fn solve(&mut self, changes: &[String], time: Option<f64>) -> Result<Known, Failure> {
        let spec = self.spec.with(changes)?;
        self.compiled.refresh(&spec)?;
        let times = self.compiled.times(&spec)?;
        let time = instant(time, times);
        let solutions = self.compiled.solve(&spec, time)?;
        Ok(Known { changes: changes.to_vec(), spec, times, time, solutions })
    }
}

/// The page's instant; an edit may have moved the time domain away from it.
fn instant(time: Option<f64>, [start, end]: [f64; 2]) -> f64 {
    time.unwrap_or(start).clamp(start, end)
}
