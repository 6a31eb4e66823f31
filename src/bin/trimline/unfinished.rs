//! Files that are not complete yet do not outlive the process: a signal that ends it removes them first.

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// The names of unfinished files. While this is held no signal ends the process.
pub fn names() -> MutexGuard<'static, Vec<PathBuf>> {
    #[cfg(unix)]
    unix::heed_signals();
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(unix)]
mod unix {
    use std::sync::Once;

    use signal_hook::consts::{
        SIGALRM, SIGHUP, SIGINT, SIGPROF, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU, SIGXFSZ,
    };
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    /// What ends a process that does not heed it, but for what no process can heed and for faults of its own.
    const ENDING: [i32; 11] =
        [SIGHUP, SIGINT, SIGTERM, SIGQUIT, SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ];

    /// From now on the signals that end a process remove what is unfinished before they do.
    pub fn heed_signals() {
        static ONCE: Once = Once::new();
        ONCE.call_once(|| {
            let heeded = ENDING.into_iter().filter(|signal| !is_ignored(*signal));
            let Ok(mut signals) = Signals::new(heeded) else { return };
            std::thread::spawn(move || {
                if let Some(signal) = signals.forever().next() {
                    // Held to the end: nothing is made or renamed any more.
                    let names = super::names();
                    for name in names.iter() {
                        // It may have got its name already.
                        let _ = std::fs::remove_file(name);
                    }
                    // Not `exit`: a shell ends its loop only if the signal is what ended the command.
                    let _ = emulate_default_handler(signal);
                }
            });
        });
    }

    /// Whether the process was started with this signal ignored, as by `nohup`. Linux tells.
    fn is_ignored(signal: i32) -> bool {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        mask.is_some_and(|mask| (mask >> (signal - 1)) & 1 == 1)
    }
}
