//! `psdl lsp`: the language server protocol over standard input and output.
//!
//! The way of a key: `transport` reads the message on the main thread and calls a handler, which writes the document and
//! asks for a run; a worker takes the texts as they are, runs them (`run`) and, if nothing newer is wanted by then, puts
//! what came of it into the words of the protocol (`diagnostics`) and on the way out (`output`).
//!
//! Invariants:
//! - There is one owner of what is known, `state`; its lock is held neither while a program runs nor across a wait.
//! - Handlers write documents before their first wait, and messages are handled in order up to that.
//! - A newer edit cancels the older run. A program is with one worker at a time and there are at least two, so that a
//!   program that uses up its budget delays no other file.
//! - Diagnostics are sent unasked or when asked for, as the client can, never both; they carry the version they are for.
//! - Nothing that a client or a program does ends the server but `exit` and the end of standard input.
//! - Nothing but the protocol goes to standard output, and no text of the user to the log.
//!
//! This is the only room that knows types of the protocol. It does not know how any feature works: that is in [`crate::ide`].

mod actions;
mod client;
mod diagnostics;
mod document;
mod frame;
mod handlers;
mod log;
mod lookout;
mod moved;
mod moving;
mod output;
mod params;
mod progress;
mod reading;
mod requests;
mod run;
mod scenes;
mod settings;
mod shared;
mod sidecar;
mod state;
mod study;
mod think;
mod transport;
mod view;
mod watch;
mod workspace;
mod writing;

pub use log::LogLevel;

use handlers::Backend;
use output::Output;
use shared::Shared;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tower_lsp_server::LspService;

/// How the server is started.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// Where the log goes; without a file to standard error.
    pub log: Option<PathBuf>,
    /// How much is logged.
    pub log_level: LogLevel,
}

/// How the server ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum End {
    /// The client had asked for it.
    Asked,
    /// The client went away, or sent `exit` without `shutdown`.
    Sudden,
}

/// Serves one client over standard input and output until it is gone.
///
/// # Errors
/// The log cannot be written, or threads cannot be started.
pub fn serve(options: &Options) -> io::Result<End> {
    log::start(options.log.as_ref(), options.log_level)?;
    serve_on(io::stdin().lock(), io::BufWriter::new(io::stdout()))
}

/// The same over any pair of streams, without a log.
///
/// # Errors
/// Threads cannot be started.
pub fn serve_on(input: impl io::BufRead, output: impl io::Write + Send + 'static) -> io::Result<End> {
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(1).enable_time().build()?;
    let output = Output::start(output)?;
    let shared = Arc::new(Shared::new(output.clone()));
    shared.start()?;
    let ending = Arc::new(AtomicBool::new(false));
    let backend = |client| Backend { shared, client, ending: ending.clone(), refresh: watch::Refresh::default(), lookout: Arc::default() };
    let (service, socket) = LspService::build(backend)
        .custom_method("psdl/text", Backend::text)
        .custom_method("psdl/fix", Backend::fix)
        .custom_method("psdl/layout", Backend::layout)
        .custom_method("psdl/constants", Backend::constants)
        .custom_method("psdl/move", Backend::move_object)
        .custom_method("psdl/turn", Backend::turn_object)
        .custom_method("psdl/render", Backend::render)
        .custom_method("window/workDoneProgress/cancel", Backend::cancel_progress)
        .custom_method("$/setTrace", Backend::set_trace)
        .finish();
    tracing::info!("psdl {} serves", env!("CARGO_PKG_VERSION"));
    transport::serve(input, &output, service, socket, runtime.handle());
    runtime.shutdown_background();
    output.flush();
    let end = if ending.load(Ordering::Relaxed) { End::Asked } else { End::Sudden };
    tracing::info!("the end: {end:?}");
    Ok(end)
}
