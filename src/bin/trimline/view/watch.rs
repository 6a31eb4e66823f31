//! Follows the spec's file: reads it again when it was saved.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};

use super::live::Live;

/// Editors write in several steps; the file is read when nothing happened for this long.
const QUIET: Duration = Duration::from_millis(10);

/// Begins to follow the file; ends when the result is dropped. Standard input is not followed.
///
/// The folder is watched, not the file: most editors replace the file when they save it.
pub fn follow(live: &Arc<Live>) -> notify::Result<Option<RecommendedWatcher>> {
    if live.path == "-" {
        return Ok(None);
    }
    let file = std::fs::canonicalize(&live.path).unwrap_or_else(|_| PathBuf::from(&live.path));
    let folder = file.parent().map_or_else(|| PathBuf::from("."), Path::to_path_buf);
    let (changed, changes) = channel();
    let mut watcher = notify::recommended_watcher(move |event: notify::Result<Event>| {
        let is_ours = |event: &Event| {
            !event.kind.is_access() && event.paths.iter().any(|path| path.file_name() == file.file_name())
        };
        if event.is_ok_and(|event| is_ours(&event)) {
            // The reader is gone when the server ends.
            let _ = changed.send(());
        }
    })?;
    watcher.watch(&folder, RecursiveMode::NonRecursive)?;
    let live = Arc::clone(live);
    std::thread::spawn(move || reload_after(&changes, &live));
    Ok(Some(watcher))
}

fn reload_after(changes: &Receiver<()>, live: &Live) {
    while changes.recv().is_ok() {
        loop {
            match changes.recv_timeout(QUIET) {
                Ok(()) => {}
                Err(RecvTimeoutError::Timeout) => break,
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
        live.reload();
    }
}
