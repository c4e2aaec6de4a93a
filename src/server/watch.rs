//! What the client is asked for: to tell about files that change, and to ask for diagnostics again.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use tower_lsp_server::Client;
use tower_lsp_server::ls_types::{DidChangeWatchedFilesRegistrationOptions, FileSystemWatcher, GlobPattern, Registration};

/// A client that does not answer for so long will not.
const PATIENCE: Duration = Duration::from_secs(10);

/// Asks the client to tell about programs, templates and configurations that change on the disk.
pub(super) fn registration() -> Registration {
    let globs = ["**/*.psdl", "**/*.template.json", "**/psdl.toml"];
    let watch = |glob: &str| FileSystemWatcher { glob_pattern: GlobPattern::String(glob.into()), kind: None };
    let watchers = globs.into_iter().map(watch).collect();
    let options = serde_json::to_value(DidChangeWatchedFilesRegistrationOptions { watchers }).ok();
    Registration { id: "psdl-files".into(), method: "workspace/didChangeWatchedFiles".into(), register_options: options }
}

/// Asks the client to tell about what is registered.
pub(super) fn register(client: Client, registrations: Vec<Registration>) {
    tokio::spawn(async move {
        if let Err(error) = client.register_capability(registrations).await {
            tracing::warn!("the client does not tell of changes: {}", error.code);
        }
    });
}

/// What the client can be told to ask for again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Ask {
    Diagnostics,
    Hints,
    Lenses,
    Tokens,
}

/// Whether the client was asked to ask again and has not answered yet, and whether it has to be asked once more then.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
enum Asked {
    #[default]
    No,
    Once,
    Again,
}

/// Asks the client to ask again, of each kind once at a time however often there is reason to.
#[derive(Clone, Debug, Default)]
pub(super) struct Refresh(Arc<Mutex<[Asked; 4]>>);

impl Refresh {
    pub(super) fn ask(&self, client: &Client, what: Ask) {
        let first = self.step(what, |asked| match asked {
            Asked::No => (Asked::Once, true),
            Asked::Once | Asked::Again => (Asked::Again, false),
        });
        if first {
            let (refresh, client) = (self.clone(), client.clone());
            tokio::spawn(async move {
                loop {
                    // What the answer is makes no difference.
                    let _ = tokio::time::timeout(PATIENCE, async {
                        match what {
                            Ask::Diagnostics => client.workspace_diagnostic_refresh().await,
                            Ask::Hints => client.inlay_hint_refresh().await,
                            Ask::Lenses => client.code_lens_refresh().await,
                            Ask::Tokens => client.semantic_tokens_refresh().await,
                        }
                    })
                    .await;
                    let again = refresh.step(what, |asked| match asked {
                        Asked::Again => (Asked::Once, true),
                        Asked::Once | Asked::No => (Asked::No, false),
                    });
                    if !again {
                        return;
                    }
                }
            });
        }
    }

    fn step(&self, what: Ask, next: impl FnOnce(Asked) -> (Asked, bool)) -> bool {
        let mut asked = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (then, result) = next(asked[what as usize]);
        asked[what as usize] = then;
        result
    }
}
