//! How long work takes: the shortest of many repetitions.

use std::time::{Duration, Instant};

/// Repetitions at least, however long they take.
const FEWEST: usize = 3;

/// Measures every piece of work for as long as the user allows.
pub struct Clock {
    pub budget: Duration,
}

impl Clock {
    /// Seconds of the fastest repetition.
    ///
    /// The fastest, not the mean: other programs on the machine only ever make it slower.
    pub fn fastest<E>(&self, mut work: impl FnMut() -> Result<(), E>) -> Result<f64, E> {
        // Pages are mapped and caches filled by the first, which does not count.
        work()?;
        let (start, mut fastest, mut repetitions) = (Instant::now(), f64::INFINITY, 0);
        while repetitions < FEWEST || start.elapsed() < self.budget {
            let before = Instant::now();
            work()?;
            fastest = fastest.min(before.elapsed().as_secs_f64());
            repetitions += 1;
        }
        Ok(fastest)
    }
}
