//! Work that is shared among threads, with results that do not depend on how many there are.
//!
//! Work is cut into pieces by its own size, each piece is done alone and put where it belongs, and nothing is summed across
//! pieces in an order that time decides: one thread and seven give the same bits. With the feature `threads` the pieces
//! run in the current pool of rayon, by default one thread for each core; without it, one after the other.

/// Why a number of threads cannot be had.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ThreadsError {
    /// More than one thread in a build that has none to share work with.
    #[error("this build was made without the feature `threads` and has 1 thread, not {0}")]
    OneOnly(usize),
    /// The system does not give them, or they were decided on before.
    #[error("{count} threads cannot be had: {reason}")]
    Refused {
        /// How many were asked for.
        count: usize,
        /// What stands against it.
        reason: String,
    },
}

/// The number of threads that share work now.
#[must_use]
pub fn count() -> usize {
    #[cfg(feature = "threads")]
    {
        rayon::current_num_threads()
    }
    #[cfg(not(feature = "threads"))]
    {
        1
    }
}

/// The results of `work` for every item, in the order of the items.
pub fn map<T: Send, R: Send>(items: Vec<T>, work: impl Fn(T) -> R + Send + Sync) -> Vec<R> {
    #[cfg(feature = "threads")]
    {
        use rayon::prelude::*;
        items.into_par_iter().map(work).collect()
    }
    #[cfg(not(feature = "threads"))]
    {
        items.into_iter().map(work).collect()
    }
}

/// As [`map`], or the error of the first item that has one, whichever was found first.
///
/// # Errors
/// That of `work`.
pub fn try_map<T: Send, R: Send, E: Send>(
    items: Vec<T>,
    work: impl Fn(T) -> Result<R, E> + Send + Sync,
) -> Result<Vec<R>, E> {
    #[cfg(feature = "threads")]
    {
        map(items, work).into_iter().collect()
    }
    // One after the other, nothing needs to be done after the first error.
    #[cfg(not(feature = "threads"))]
    {
        items.into_iter().map(work).collect()
    }
}

/// Does `work` with `count` threads, at least one: it shares what it shares among so many.
///
/// # Errors
/// [`ThreadsError`]; nothing is done in that case.
pub fn with<R: Send>(count: usize, work: impl FnOnce() -> R + Send) -> Result<R, ThreadsError> {
    #[cfg(feature = "threads")]
    {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count.max(1)).build();
        let pool = pool.map_err(|error| ThreadsError::Refused { count, reason: error.to_string() })?;
        Ok(pool.install(work))
    }
    #[cfg(not(feature = "threads"))]
    {
        if count > 1 { Err(ThreadsError::OneOnly(count)) } else { Ok(work()) }
    }
}

/// Lets all work of this process that is done outside of [`with`] have `count` threads, at least one; before the first
/// such work is done, and once.
///
/// # Errors
/// [`ThreadsError`].
pub fn set_default(count: usize) -> Result<(), ThreadsError> {
    #[cfg(feature = "threads")]
    {
        let built = rayon::ThreadPoolBuilder::new().num_threads(count.max(1)).build_global();
        built.map_err(|error| ThreadsError::Refused { count, reason: error.to_string() })
    }
    #[cfg(not(feature = "threads"))]
    {
        if count > 1 { Err(ThreadsError::OneOnly(count)) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_the_order_of_the_items() {
        let work = || map((0..1000).collect(), |i: usize| i * i);
        let expected: Vec<usize> = (0..1000).map(|i| i * i).collect();
        let counts: &[usize] = if cfg!(feature = "threads") { &[1, 2, 7] } else { &[1] };
        for count in counts {
            assert_eq!(with(*count, work).expect("a few threads"), expected, "{count}");
        }
    }

    #[test]
    fn the_first_error_is_that_of_the_first_item_that_has_one() {
        let work = |i: usize| if i % 100 == 99 { Err(i) } else { Ok(i) };
        assert_eq!(try_map((0..1000).collect(), work), Err(99));
    }

    #[cfg(feature = "threads")]
    #[test]
    fn work_sees_the_number_of_threads_it_was_given() {
        assert_eq!(with(3, count).expect("three threads"), 3);
    }

    #[cfg(not(feature = "threads"))]
    #[test]
    fn a_build_without_threads_refuses_two() {
        assert_eq!(with(2, count), Err(ThreadsError::OneOnly(2)));
        assert_eq!(with(1, count), Ok(1));
    }
}
