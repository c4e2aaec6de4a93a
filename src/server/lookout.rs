//! A look-out of our own for changes on the disk.

use super::document::{self, Role};
use notify::{EventKind, RecursiveMode, Watcher};
use rustc_hash::FxHashSet;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::channel;
use std::time::Duration;

/// Changes that come so close together are one: a file is written in several steps.
const SETTLE: Duration = Duration::from_millis(30);

/// A look-out of our own for a client that does not watch files (Neovim on Linux, as it comes). It watches the folders of
/// what is open and those above, not what lies in them: nothing is spent on a large workspace.
pub(super) struct Lookout {
    watcher: notify::RecommendedWatcher,
    folders: FxHashSet<PathBuf>,
}

impl Lookout {
    /// A look-out that watches nothing yet, and whom it tells. To be made where the runtime is at hand.
    pub(super) fn new(tell: impl Fn(&[PathBuf]) + Send + 'static) -> io::Result<Lookout> {
        let runtime = tokio::runtime::Handle::current();
        let (send, changes) = channel();
        let watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
            let Ok(event) = event else { return };
            if matches!(event.kind, EventKind::Access(_)) {
                return;
            }
            for path in event.paths.into_iter().filter(|path| document::role(Some(path), "") != Role::Other) {
                // Nobody listens any more when the server ends.
                let _ = send.send(path);
            }
        });
        let watcher = watcher.map_err(io::Error::other)?;
        std::thread::Builder::new().name("lookout".into()).spawn(move || {
            let _entered = runtime.enter();
            while let Ok(first) = changes.recv() {
                let mut paths = vec![first];
                while let Ok(path) = changes.recv_timeout(SETTLE) {
                    paths.push(path);
                }
                tell(&paths);
            }
        })?;
        Ok(Lookout { watcher, folders: FxHashSet::default() })
    }

    /// Watches the folder of a document and those above it.
    pub(super) fn watch(&mut self, document: &Path) {
        for folder in document.ancestors().skip(1) {
            if !self.folders.insert(folder.to_path_buf()) {
                return;
            }
            if let Err(error) = self.watcher.watch(folder, RecursiveMode::NonRecursive) {
                tracing::debug!("a folder is not watched: {error}");
            }
        }
    }
}

impl std::fmt::Debug for Lookout {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Lookout").field("folders", &self.folders).finish_non_exhaustive()
    }
}
