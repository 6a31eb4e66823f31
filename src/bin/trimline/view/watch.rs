//! Follows the spec's file and its data files: reads all again when one was saved.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};

use super::live::Live;
use crate::files;

/// Editors write in several steps; the file is read when nothing happened for this long.
const QUIET: Duration = Duration::from_millis(10);

/// The files that are followed, and what tells of changes in their folders.
struct Followed {
    files: Arc<Mutex<Vec<PathBuf>>>,
    folders: Vec<PathBuf>,
    watcher: RecommendedWatcher,
}

/// Begins to follow the files for as long as the process runs. Standard input is not followed.
///
/// Folders are watched, not files: most editors replace the file when they save it.
pub fn follow(live: &Arc<Live>) -> notify::Result<()> {
    if live.path == "-" {
        return Ok(());
    }
    let files = Arc::new(Mutex::new(Vec::new()));
    let ours = Arc::clone(&files);
    let (changed, changes) = channel();
    let watcher = notify::recommended_watcher(move |event: notify::Result<Event>| {
        let is_ours = |event: &Event| {
            let ours: std::sync::MutexGuard<'_, Vec<PathBuf>> = ours.lock().unwrap_or_else(PoisonError::into_inner);
            !event.kind.is_access() && event.paths.iter().any(|path| ours.contains(path))
        };
        if event.is_ok_and(|event| is_ours(&event)) {
            // The reader is gone when the server ends.
            let _ = changed.send(());
        }
    })?;
    let mut followed = Followed { files, folders: Vec::new(), watcher };
    followed.update(live)?;
    let live = Arc::clone(live);
    std::thread::spawn(move || reload_after(&changes, &live, &mut followed));
    Ok(())
}

impl Followed {
    /// Follows what the spec names now; what a text named that cannot be read any more stays.
    fn update(&mut self, live: &Live) -> notify::Result<()> {
        let named = files::named_by(&live.path, &live.limits());
        let named = named.unwrap_or_default().into_iter().chain([PathBuf::from(&live.path)]);
        // Behind a link, the file that it leads to is the one that is edited.
        let mut files: Vec<PathBuf> =
            named.flat_map(|file| std::fs::canonicalize(&file).into_iter().chain([whole(&file)])).collect();
        for folder in files.iter().filter_map(|file| file.parent()).map(Path::to_path_buf).collect::<Vec<_>>() {
            // A folder that does not exist yet cannot be watched; the spec's own does.
            if !self.folders.contains(&folder) && folder.is_dir() {
                self.watcher.watch(&folder, RecursiveMode::NonRecursive)?;
                self.folders.push(folder);
            }
        }
        let mut known = self.files.lock().unwrap_or_else(PoisonError::into_inner);
        files.extend(known.iter().filter(|file| !files.contains(file)).cloned().collect::<Vec<_>>());
        *known = files;
        Ok(())
    }
}

/// The path as events name it: with its folder resolved, whether the file exists or not.
fn whole(file: &Path) -> PathBuf {
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let folder = std::fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
    folder.join(file.file_name().unwrap_or_default())
}

fn reload_after(changes: &Receiver<()>, live: &Live, followed: &mut Followed) {
    while changes.recv().is_ok() {
        let saved = Instant::now();
        loop {
            match changes.recv_timeout(QUIET) {
                Ok(()) => {}
                Err(RecvTimeoutError::Timeout) => break,
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
        // First, so that a change during the reading is seen. A folder that cannot be watched is not followed.
        let _ = followed.update(live);
        live.reload(saved);
    }
}
