//! `psdl lsp`

use super::Outcome;
use super::output::Failure;
use crate::server::{self, End, LogLevel};
use clap::ValueHint;
use std::path::PathBuf;

/// `psdl lsp`
#[derive(clap::Args, Debug)]
#[command(after_help = "Exit status: 0 after a shutdown request, 1 without one, 2 if the server could not be started.")]
pub struct LspArgs {
    /// Speak over standard input and output, which is the only way there is; editors like to say so.
    #[arg(long, hide = true)]
    pub stdio: bool,

    /// Log to this file and not to standard error.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub log: Option<PathBuf>,

    /// How much is logged.
    #[arg(long, value_enum, default_value_t, value_name = "LEVEL")]
    pub log_level: LogLevel,
}

/// Serves an editor until it is gone.
pub(super) fn lsp(args: LspArgs) -> Result<Outcome, Failure> {
    let options = server::Options { log: args.log, log_level: args.log_level };
    match server::serve(&options) {
        Ok(End::Asked) => Ok(Outcome::Clean),
        Ok(End::Sudden) => Ok(Outcome::Findings),
        Err(error) => Err(Failure::new(format!("the server could not be started: {error}"))),
    }
}
