//! `psdl run`: what a program prints, as it prints it; and the traceback of what it raised.

use super::Outcome;
use super::args::RunArgs;
use super::configuration::Configuration;
use super::files::Program;
use super::output::{self, Failure};
use super::traceback::traceback;
use crate::analysis::{Input, Mode, execute, failures, prepare};
use crate::check::finding::Finding;
use crate::report::{FileReport, Printer};
use std::sync::atomic::{AtomicBool, Ordering};

pub(super) fn run(args: &RunArgs, color: bool) -> Result<Outcome, Failure> {
    let loaded = Program::named(&args.file).load();
    let options = Configuration::new(&args.options, color).options(&args.file)?;
    let (text, template) = loaded.texts()?;
    let input = Input { text, template: template.map(|(_, text)| text) };
    let complain = |findings: &[Finding]| {
        let file = FileReport { path: &loaded.path, text, template, findings, objects: &[] };
        output::report_error(&Printer { color, ..Printer::default() }.file(&file));
        Ok(Outcome::Findings)
    };
    let (prepared, options) = (prepare(&input), options);
    let closed = AtomicBool::new(false);
    let mut trouble = None;
    let mut print = |text: &str| match output::write(text.as_bytes()) {
        Ok(true) => {}
        // Nobody reads what it prints any more: there is no use in going on.
        Ok(false) => closed.store(true, Ordering::Relaxed),
        Err(failure) => {
            closed.store(true, Ordering::Relaxed);
            trouble = Some(failure);
        }
    };
    let run = execute(&prepared, &options, Mode::default(), Some(&closed), &mut print);
    if let Some(failure) = trouble {
        return Err(failure);
    }
    let Some(run) = run else { return complain(&prepared.findings) };
    if let Some(uncaught) = run.exceptions.first() {
        let last = uncaught.chain.last();
        return match last.and_then(|shown| shown.exit) {
            Some(0) => Ok(Outcome::Clean),
            _ => {
                output::report_error(&traceback(&loaded.path, text, uncaught));
                Ok(Outcome::Findings)
            }
        };
    }
    match run.stop {
        Some((crate::python::error::Stop::Cancelled, _)) | None => Ok(Outcome::Clean),
        Some(_) => complain(&failures(&run, &[], &options)),
    }
}
