//! The command line: arguments → the rooms of the core → text on standard output.
//!
//! Files are read and written here, threads are started here and the terminal is known here; what is said about a
//! program is decided elsewhere, so that an editor says the same.
//!
//! Invariants:
//! - Exit status 0: nothing found that counts; 1: something was; 2: the command could not do its work.
//! - Standard output carries results only; progress, warnings and errors go to standard error.
//! - A closed pipe ends the command quietly.

pub mod args;
mod baseline;
mod changed;
mod check;
mod configuration;
mod explain;
mod export;
mod files;
mod film;
mod fix;
mod generate;
mod import;
mod lsp;
mod output;
mod picture;
mod progress;
mod render;
mod run;
mod traceback;
mod version;
mod watch;

use args::{Args, Command};
use clap::{CommandFactory, Parser};
use output::Failure;
use std::process::ExitCode;

/// How a command ended when it could do its work.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Outcome {
    Clean,
    Findings,
}

/// Stack of the threads that run programs: deep recursion is theirs to end, not the system's.
const STACK: usize = 64 << 20;

/// Runs the command that the process was started with.
pub fn main() -> ExitCode {
    let args = Args::parse();
    args.color.write_global();
    match dispatch(args) {
        Ok(Outcome::Clean) => ExitCode::SUCCESS,
        Ok(Outcome::Findings) => ExitCode::from(1),
        Err(failure) => {
            output::complain(&failure);
            ExitCode::from(2)
        }
    }
}

fn dispatch(args: Args) -> Result<Outcome, Failure> {
    let color = args.color.resolve(&std::io::stdout());
    let errors = args.color.resolve(&std::io::stderr());
    if args.version {
        return output::print(&version::text(args.verbose));
    }
    match args.command {
        Some(Command::Check(args)) => check::check(&args, color, errors),
        Some(Command::Fix(args)) => with_stack(|| fix::fix(&args, color, errors)),
        Some(Command::Run(args)) => with_stack(|| run::run(&args, errors)),
        Some(Command::Render(args)) => with_stack(|| render::render(&args, errors)),
        Some(Command::Export(args)) => with_stack(|| export::export(&args, errors)),
        Some(Command::Import(args)) => with_stack(|| import::import(&args)),
        Some(Command::Explain(args)) => explain::explain(&args),
        Some(Command::Config(args)) => configuration::show(&args, errors),
        Some(Command::Completions(args)) => generate::completions(&args),
        Some(Command::Man(args)) => generate::man(&args),
        Some(Command::Lsp(args)) => lsp::lsp(args),
        None => {
            let help = Args::command().render_help();
            output::print(&help.to_string())?;
            Err(Failure::new("no command was given"))
        }
    }
}

/// Does the work on a thread whose stack is large enough to run programs.
fn with_stack<T: Send>(work: impl FnOnce() -> Result<T, Failure> + Send) -> Result<T, Failure> {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
        match thread.map_err(|error| Failure::new(format!("a thread could not be started: {error}")))?.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}
