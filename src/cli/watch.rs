//! `psdl check --watch`: checks again whenever a program, a template or a configuration changes.

use super::output::Failure;
use notify::{EventKind, RecursiveMode, Watcher};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

/// Changes that come so close together are one: editors write a file in several steps.
const SETTLE: Duration = Duration::from_millis(50);

/// A look-out for changes. It watches as long as it lives.
pub(super) struct Lookout {
    changes: Receiver<()>,
    _watcher: notify::RecommendedWatcher,
}

impl Lookout {
    /// Looks out for changes at these paths.
    pub(super) fn new(paths: &[PathBuf]) -> Result<Lookout, Failure> {
        let (send, changes) = channel();
        let watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
            let matters =
                event.is_ok_and(|event| !matches!(event.kind, EventKind::Access(_)) && event.paths.iter().any(|path| is_ours(path)));
            if matters {
                // Nobody listens any more when the command ends.
                let _ = send.send(());
            }
        });
        let mut watcher = watcher.map_err(|error| Failure::new(format!("changes cannot be watched: {error}")))?;
        for path in paths {
            // Files are replaced when they are saved: their folder is what stays.
            let (folder, mode) = if path.is_dir() {
                (path.as_path(), RecursiveMode::Recursive)
            } else {
                let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty());
                (parent.unwrap_or(Path::new(".")), RecursiveMode::NonRecursive)
            };
            watcher.watch(folder, mode).map_err(|error| Failure::at(folder, &error))?;
        }
        Ok(Lookout { changes, _watcher: watcher })
    }

    /// Waits for the next change, and for the end of those that come with it; false when there will be no more.
    pub(super) fn wait(&self) -> bool {
        if self.changes.recv().is_err() {
            return false;
        }
        while self.changes.recv_timeout(SETTLE).is_ok() {}
        true
    }
}

fn is_ours(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    [".psdl", ".py", ".template.json"].iter().any(|end| name.ends_with(end)) || name == crate::config::FILE_NAME
}
