//! Preparing a program, and running it on an empty scene.

use super::{Input, Options};
use crate::check::finding::{Code, Finding, Fix, Place, Severity, Source};
use crate::python::code::Program;
use crate::python::compile::compile;
use crate::python::error::Stop;
use crate::python::host::Host as _;
use crate::python::vm::{self, CallChain, Outcome, Uncaught};
use crate::scene::Layout;
use crate::scene::host::{self, SceneHost, bound_in_loops};
use crate::scene::template::{self, Template, TemplateError};
use crate::syntax::scope::{Occurrence, Role};
use crate::syntax::{ErrorKind, Parsed, ScopeId, SyntaxError, Tuning};
use crate::trace::Trace;
use ruff_text_size::TextRange;
use rustc_hash::FxHashSet;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A record of more operations than this is of no use for a check.
const MAX_TRACE: usize = 2_000_000;

/// A program that was read; it can be run many times if it is without errors.
#[derive(Debug)]
pub struct Prepared {
    /// The text, read.
    pub parsed: Parsed,
    /// What of it may be rewritten.
    pub tuning: Tuning,
    /// The sidecar template, where there is one without errors.
    pub template: Option<Template>,
    /// The code; none where the text or the template has errors.
    pub program: Option<Arc<Program>>,
    /// What is wrong with the text and the template.
    pub findings: Vec<Finding>,
}

/// How a program is run.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Mode {
    /// Go on with the next top-level statement after one that raised.
    pub lenient: bool,
    /// Record where numbers come from.
    pub trace: bool,
}

/// What became of a run.
#[derive(Debug)]
pub struct Execution {
    /// Where everything is as far as the program got.
    pub layout: Layout,
    /// What was raised and not caught.
    pub exceptions: Vec<Uncaught>,
    /// Why the run was stopped, if it was.
    pub stop: Option<(Stop, CallChain)>,
    /// The record, if one was asked for.
    pub trace: Trace,
    /// The globals that the program reads but nobody binds, each with the name that was probably meant.
    pub unknown: Vec<(String, Option<String>)>,
}

/// Reads a program and its template.
pub fn prepare(input: &Input) -> Prepared {
    let parsed = crate::syntax::parse(input.text);
    let mut findings: Vec<Finding> = parsed.errors.iter().map(syntax_finding).collect();
    let template = input.template.map(template::parse).and_then(|template| match template {
        Ok(template) => {
            findings.extend(template.warnings.iter().map(|error| template_finding(error, Severity::Warning)));
            Some(template)
        }
        Err(errors) => {
            findings.extend(errors.iter().map(|error| template_finding(error, Code::Template.severity())));
            None
        }
    });
    if let Some(Err(error)) = template.as_ref().map(SceneHost::with_template) {
        let error = TemplateError { range: TextRange::default(), message: error.message };
        findings.push(template_finding(&error, Code::Template.severity()));
    }
    let mut prepared = Prepared { tuning: Tuning::default(), program: None, parsed, template, findings };
    if prepared.parsed.is_complete() {
        prepared.compile(input.text);
    }
    prepared
}

impl Prepared {
    fn compile(&mut self, text: &str) {
        let parsed = &self.parsed;
        self.tuning = crate::syntax::tune(parsed, text);
        let usable = !self.findings.iter().any(|finding| finding.severity == Severity::Error);
        match parsed.with_stack(|| compile(&parsed.module, text, &parsed.scopes, &self.tuning)) {
            Ok(program) => self.program = usable.then(|| Arc::new(program)),
            Err(error) => self.findings.push(Finding::new(Code::SyntaxError, Place::program(error.range), error.message)),
        }
    }
}

/// Runs a program; `None` where it has errors. `output` gets what it prints, as it prints it.
pub fn execute(
    prepared: &Prepared,
    options: &Options,
    mode: Mode,
    cancel: Option<&AtomicBool>,
    output: &mut dyn FnMut(&str),
) -> Option<Execution> {
    let program = prepared.program.clone()?;
    let host = match &prepared.template {
        None => SceneHost::new(),
        Some(template) => SceneHost::with_template(template).ok()?,
    };
    let host_names = host.names();
    let trace = if mode.trace { Trace::recording(MAX_TRACE) } else { Trace::default() };
    let settings = vm::Options { limits: options.limits, cancel, lenient: mode.lenient, trace, ..vm::Options::default() };
    let run = host::run(program, &bound_in_loops(&prepared.parsed), host, settings, output);
    let unknown = unknown_names(prepared, &host_names, run.unbound);
    let Outcome { exceptions, stop, .. } = run.outcome;
    Some(Execution { layout: run.layout, exceptions, stop, trace: run.trace, unknown })
}

/// The globals without a value that no statement of the program would have bound, each with the name that was probably meant.
fn unknown_names(prepared: &Prepared, host_names: &[&str], unbound: Vec<String>) -> Vec<(String, Option<String>)> {
    if unbound.is_empty() {
        return Vec::new();
    }
    let scopes = &prepared.parsed.scopes;
    let is_global = |found: &&Occurrence| scopes.variable(found.scope, found.name).is_some_and(|v| v.owner == ScopeId::MODULE);
    let binding = scopes.occurrences().iter().filter(|found| found.role == Role::Bind).filter(is_global);
    let bound: FxHashSet<&str> = binding.map(|found| scopes.name(found.name).as_str()).collect();
    let declared = prepared.template.iter().flat_map(|template| &template.objects).map(|object| object.id.as_str());
    let mut candidates: Vec<&str> = bound.iter().copied().chain(declared).chain(host_names.iter().copied()).collect();
    candidates.sort_unstable();
    let unknown = unbound.into_iter().filter(|name| !bound.contains(name.as_str()));
    unknown
        .map(|name| {
            let meant = crate::syntax::suggest(&name, candidates.iter().copied()).map(str::to_string);
            (name, meant)
        })
        .collect()
}

fn syntax_finding(error: &SyntaxError) -> Finding {
    let code = match error.kind {
        ErrorKind::Fence => Code::MarkdownFence,
        ErrorKind::TooBig => Code::Limit,
        ErrorKind::Syntax | ErrorKind::LeftOut => Code::SyntaxError,
    };
    let mut finding = Finding::new(code, Place::program(error.range), error.message.clone());
    finding.fix = error.fix.as_ref().map(|fix| Fix { title: fix.title.clone(), edits: fix.edits.clone() });
    finding
}

fn template_finding(error: &TemplateError, severity: Severity) -> Finding {
    let place = Place { source: Source::Template, range: error.range };
    Finding { severity, ..Finding::new(Code::Template, place, error.message.clone()) }
}
