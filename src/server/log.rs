//! The log: to standard error or a file, never to standard output, and never with a text of the user in it.

use std::fs::OpenOptions;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// How much is logged.
#[derive(clap::ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum LogLevel {
    /// What should never happen.
    Error,
    /// And what was refused.
    #[default]
    Warn,
    /// And when the server starts and ends.
    Info,
    /// And each run with its time.
    Debug,
    /// And each scheduling decision.
    Trace,
}

impl From<LogLevel> for tracing::Level {
    fn from(level: LogLevel) -> tracing::Level {
        match level {
            LogLevel::Error => tracing::Level::ERROR,
            LogLevel::Warn => tracing::Level::WARN,
            LogLevel::Info => tracing::Level::INFO,
            LogLevel::Debug => tracing::Level::DEBUG,
            LogLevel::Trace => tracing::Level::TRACE,
        }
    }
}

/// Starts logging, for the whole process.
pub(super) fn start(file: Option<&PathBuf>, level: LogLevel) -> io::Result<()> {
    let builder = tracing_subscriber::fmt().with_max_level(tracing::Level::from(level)).with_ansi(false);
    // A second server in the same process writes to the log of the first.
    let _ = match file {
        None => builder.with_writer(io::stderr).try_init(),
        Some(path) => builder.with_writer(Mutex::new(open(path)?)).try_init(),
    };
    // The words of a panic may quote the user's text; its place does not.
    std::panic::set_hook(Box::new(|panic| match panic.location() {
        Some(place) => tracing::error!("panic at {}:{}", place.file(), place.line()),
        None => tracing::error!("panic"),
    }));
    Ok(())
}

fn open(path: &Path) -> io::Result<std::fs::File> {
    OpenOptions::new().create(true).append(true).open(path)
}
