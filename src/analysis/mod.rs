//! One engine for all faces: a program's text → everything there is to say about it.
//!
//! It wires the rooms before it together (parse, run, place, check) and knows how each of them fails; nothing else does.
//!
//! Invariants:
//! - A plain function of its arguments: no I/O, no clock, no threads. Long runs poll a cancel flag.
//! - Every text gets an answer: a layout, or findings that say why there is none.
//! - What does not depend on a run (syntax, the template, unknown names) is said even where nothing could be run.

mod constants;
mod failures;
mod names;
mod options;
mod run;
mod suppress;

pub use failures::findings as failures;
pub use options::{Options, Severities};
pub use run::{Execution, Mode, Prepared, execute, prepare};

use crate::check::finding::{Code, Finding};
use crate::check::{Verdict, check, findings as layout_findings};
use crate::python::error::Stop;
use crate::scene::Layout;
use std::sync::atomic::AtomicBool;

/// A program to look at.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// The program.
    pub text: &'a str,
    /// Its sidecar template, if it has one.
    pub template: Option<&'a str>,
}

/// All that was found out about a program.
#[derive(Debug)]
pub struct Analysis {
    /// The program, read.
    pub prepared: Prepared,
    /// What there is to say, by place.
    pub findings: Vec<Finding>,
    /// Where everything is, if the program could be run.
    pub layout: Option<Layout>,
    /// The errors of the layout.
    pub verdict: Verdict,
    /// What the program printed.
    pub output: String,
    /// The layout is that of a program that did not run to its end.
    pub partial: bool,
    /// The run was cancelled: there is no layout, and the findings are not all.
    pub cancelled: bool,
}

impl Analysis {
    /// The names of the objects, in the order that [`Finding::objects`] counts.
    pub fn object_names(&self) -> Vec<String> {
        self.layout.iter().flat_map(|layout| &layout.objects).map(|object| object.path.clone()).collect()
    }
}

/// Says everything there is to say about a program.
pub fn analyse(input: &Input, options: &Options, cancel: Option<&AtomicBool>) -> Analysis {
    let mut prepared = prepare(input);
    let findings = std::mem::take(&mut prepared.findings);
    let mut output = String::new();
    let mode = Mode { lenient: true, trace: options.severities.of(Code::UnusedConstant).is_some() };
    let run = execute(&prepared, options, mode, cancel, &mut |text| output.push_str(text));
    let mut analysis = Analysis { prepared, findings, layout: None, verdict: Verdict::default(), output, partial: false, cancelled: false };
    if let Some(run) = run {
        analysis.judge(run, input.text, options);
    }
    let complete = analysis.layout.is_some() && !analysis.partial;
    suppress::apply(&mut analysis.findings, &analysis.prepared.parsed, input.text, complete);
    finish(&mut analysis.findings, options);
    analysis
}

impl Analysis {
    /// Adds what a run tells.
    fn judge(&mut self, run: Execution, text: &str, options: &Options) {
        self.partial = !run.exceptions.is_empty() || run.stop.is_some();
        if matches!(run.stop, Some((Stop::Cancelled, _))) {
            self.cancelled = true;
            return;
        }
        let unknown = names::findings(&self.prepared.parsed, &run);
        self.findings.extend(failures::findings(&run, &unknown, options));
        self.findings.extend(unknown);
        self.verdict = check(&run.layout, &options.rules);
        let mut found = layout_findings(&run.layout, &self.verdict, &options.rules);
        if self.partial {
            // What was to place an object may be what failed.
            found.retain(|finding| finding.code != Code::Unplaced);
            found.iter_mut().for_each(|finding| finding.partial = true);
        } else {
            found.extend(constants::findings(&self.prepared, &run, text));
        }
        self.findings.extend(found);
        self.layout = Some(run.layout);
    }
}

/// Gives every finding the weight that holds here, leaves out what is turned off, and puts the rest in order.
fn finish(findings: &mut Vec<Finding>, options: &Options) {
    findings.retain_mut(|finding| match options.severities.of(finding.code) {
        Some(severity) => {
            finding.severity = severity;
            true
        }
        None => false,
    });
    findings.sort_by_key(|finding| (finding.place.source, finding.place.range.start(), finding.place.range.end(), finding.code));
}
