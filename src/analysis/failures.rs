//! Exceptions and limits as findings, with the calls that led to them.

use super::Options;
use super::run::Execution;
use crate::check::finding::{Code, Finding, Place, Related};
use crate::python::error::Stop;
use crate::python::vm::{CallChain, Shown, Uncaught};

/// Of a long chain of calls so many are told.
const MAX_CALLS: usize = 12;

/// What was raised and not caught, and the limit that ended the run. A NameError is left out where its name is told already as
/// unknown, and where it follows from a statement that failed before: that one should have bound the name.
pub fn findings(run: &Execution, unknown: &[Finding], options: &Options) -> Vec<Finding> {
    let told = |uncaught: &Uncaught| {
        let last = uncaught.chain.last();
        last.is_some_and(|shown| {
            let about =
                |finding: &Finding| shown.name.as_ref().is_some_and(|name| finding.message == format!("name '{name}' is not defined"));
            shown.class == "NameError" && unknown.iter().any(about)
        })
    };
    let follows = |at: usize| {
        let shown = run.exceptions[at].chain.last();
        let name = shown.filter(|shown| shown.class == "NameError").and_then(|shown| shown.name.as_ref());
        at > 0 && name.is_some_and(|name| !run.unknown.iter().any(|(unknown, _)| unknown == name))
    };
    let exit = |uncaught: &Uncaught| uncaught.chain.last().is_some_and(|shown| shown.exit == Some(0));
    let exceptions = run.exceptions.iter().enumerate().filter(|(at, uncaught)| !told(uncaught) && !follows(*at) && !exit(uncaught));
    let mut findings: Vec<Finding> = exceptions.filter_map(|(_, uncaught)| exception(uncaught)).collect();
    findings.extend(run.stop.as_ref().and_then(|(stop, calls)| limit(*stop, calls, options)));
    findings
}

fn exception(uncaught: &Uncaught) -> Option<Finding> {
    let (last, causes) = uncaught.chain.split_last()?;
    let mut finding = Finding::new(Code::Exception, place(&last.calls), last.line.clone());
    finding.related = calls(&last.calls);
    finding.notes.extend(last.notes.iter().cloned());
    let mut later: &Shown = last;
    for cause in causes.iter().rev() {
        let how = if cause.direct || later.direct { "it was raised because of" } else { "it was raised while this was handled:" };
        finding.notes.push(format!("{how} {}", cause.line));
        if let Some((_, range)) = cause.calls.levels.last() {
            finding.related.push(Related { place: Place::program(*range), message: cause.line.clone() });
        }
        later = cause;
    }
    Some(finding)
}

fn limit(stop: Stop, calls_: &CallChain, options: &Options) -> Option<Finding> {
    let message = match stop {
        Stop::Steps => format!("the program did not end within {} steps; is there a loop without an end?", options.limits.steps),
        Stop::Output => format!("the program printed more than {} bytes", options.limits.output),
        Stop::Cancelled => return None,
    };
    let mut finding = Finding::new(Code::Limit, place(calls_), message);
    finding.related = calls(calls_);
    Some(finding)
}

/// Where it happened.
fn place(calls: &CallChain) -> Place {
    Place::program(calls.levels.last().map(|(_, range)| *range).unwrap_or_default())
}

/// The calls that led there, the innermost first.
fn calls(calls: &CallChain) -> Vec<Related> {
    let pairs = calls.levels.iter().zip(calls.levels.iter().skip(1));
    let related = pairs.rev().take(MAX_CALLS).map(|((_, range), (function, _))| Related {
        place: Place::program(*range),
        message: if function.starts_with('<') { "from here".into() } else { format!("{function}() is called here") },
    });
    related.collect()
}
