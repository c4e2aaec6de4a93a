//! `psdl lsp`, spoken to as an editor does, through the real program.

#[path = "server/actions.rs"]
mod actions;
#[path = "server/cancel.rs"]
mod cancel;
#[path = "server/client.rs"]
mod client;
#[path = "server/config.rs"]
mod config;
#[path = "server/edits.rs"]
mod edits;
#[path = "server/flows.rs"]
mod flows;
#[path = "server/hostile.rs"]
mod hostile;
#[path = "server/moving.rs"]
mod moving;
#[path = "server/pull.rs"]
mod pull;
#[path = "server/reading.rs"]
mod reading;
#[path = "server/scenes.rs"]
mod scenes;
#[path = "server/soak.rs"]
mod soak;
#[path = "server/stale.rs"]
mod stale;
#[path = "server/sweep.rs"]
mod sweep;
#[path = "server/workspace.rs"]
mod workspace;
#[path = "server/writing.rs"]
mod writing;
