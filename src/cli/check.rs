//! `psdl check`: many programs in parallel, one report in a stable order, in memory that does not grow with their number.

use super::args::CheckArgs;
use super::baseline::{self, Baseline};
use super::configuration::Configuration;
use super::files::{Loaded, Program, Trouble, programs};
use super::output::{self, Failure};
use super::picture::Screen;
use super::progress::Progress;
use super::watch::Lookout;
use super::{Outcome, STACK, changed};
use crate::analysis::{self, Input, Options};
use crate::check::finding::{Code, Finding, Place, Source};
use crate::repair;
use crate::report::{FileReport, Format, Printer, Summary};
use rayon::prelude::*;
use ruff_text_size::TextRange;
use std::collections::BTreeMap;

/// So many files are under way before their part of the report is written.
const BATCH: usize = 256;

/// What one program adds to the report.
struct Piece {
    path: String,
    text: String,
    summary: Summary,
    unreadable: bool,
    /// What a new baseline remembers.
    remembered: BTreeMap<String, String>,
    /// Findings that the baseline knows and that are gone.
    fixed: Vec<String>,
}

/// All that decides how a program is checked.
struct Checker<'a> {
    args: &'a CheckArgs,
    printer: Printer,
    configuration: Configuration,
    baseline: Option<Baseline>,
    screen: Option<Screen>,
    pool: rayon::ThreadPool,
}

pub(super) fn check(args: &CheckArgs, color: bool, error_color: bool) -> Result<Outcome, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().stack_size(STACK).build();
    let checker = Checker {
        args,
        printer: Printer { format: args.format, color: color && args.format == Format::Text, statistics: args.statistics },
        configuration: Configuration::new(&args.options, error_color),
        baseline: args.baseline.as_deref().map(Baseline::read).transpose()?,
        screen: args.picture.filter(|_| args.format == Format::Text).and_then(Screen::of),
        pool: pool.map_err(|error| Failure::new(format!("threads could not be started: {error}")))?,
    };
    if !args.watch {
        return checker.check_all();
    }
    let lookout = Lookout::new(&args.paths)?;
    loop {
        // What is wrong now may be right after the next change.
        if let Err(failure) = checker.check_all() {
            output::complain(&failure);
        }
        output::note("waiting for changes (Ctrl+C ends)");
        if !lookout.wait() {
            return Ok(Outcome::Clean);
        }
        checker.configuration.forget();
    }
}

impl Checker<'_> {
    fn keeps(&self, code: Code) -> bool {
        (self.args.select.is_empty() || self.args.select.contains(&code)) && !self.args.ignore.contains(&code)
    }

    fn programs(&self) -> Result<Vec<Program>, Failure> {
        let left_out = |path: &std::path::Path| self.configuration.excludes(path);
        let mut programs = programs(&self.args.paths, self.args.stdin_filename.as_deref(), &left_out)?;
        if let Some(revision) = &self.args.changed_since {
            let changed = changed::since(revision)?;
            programs.retain(|program| matches!(program, Program::Stdin(_)) || changed::touches(&changed, program.path()));
        }
        Ok(programs)
    }

    fn check_all(&self) -> Result<Outcome, Failure> {
        let programs = self.programs()?;
        let mut report = Report { printer: self.printer, ..Report::default() };
        report.open = true;
        let mut progress = Progress::new(programs.len());
        report.write(&self.printer.head())?;
        for batch in programs.chunks(BATCH) {
            let pieces = self.pool.install(|| {
                batch.par_iter().map(|program| self.piece(program, programs.len() == 1)).collect::<Result<Vec<Piece>, Failure>>()
            })?;
            progress.advance(batch.len());
            progress.around(|| report.add(pieces))?;
            // Without a reader the work goes on only for what is written elsewhere.
            if !report.open && self.args.write_baseline.is_none() {
                break;
            }
        }
        progress.done();
        let tail = self.printer.tail(&report.summary);
        report.write(&tail)?;
        for fixed in &report.fixed {
            output::note(&format!("fixed since the baseline: {fixed}"));
        }
        if !report.fixed.is_empty() {
            output::note("write the baseline again to make it smaller");
        }
        if report.unreadable {
            return Err(Failure::new("some files could not be read"));
        }
        if let Some(path) = &self.args.write_baseline {
            report.remembered.write(path)?;
            return Ok(Outcome::Clean);
        }
        Ok(if report.summary.fails() && !self.args.exit_zero { Outcome::Findings } else { Outcome::Clean })
    }

    fn piece(&self, program: &Program, alone: bool) -> Result<Piece, Failure> {
        let options = self.configuration.options(program.path())?;
        let loaded = program.load();
        let unreadable = matches!(loaded.text, Err(Trouble::Io(_)));
        let (text, template, mut findings, objects, picture) = findings(&loaded, &options, self.screen);
        findings.retain(|finding| self.keeps(finding.code));
        if self.args.suggest && findings.iter().any(|finding| finding.code.is_layout()) {
            let input = Input { text, template: template.map(|(_, text)| text) };
            repair::add_suggestions(&input, &options, &mut findings);
        }
        let template = template.map(|(path, text)| (path.as_str(), text));
        let file = FileReport { path: &loaded.path, text, template, findings: &findings, objects: &objects };
        let (mut remembered, mut fixed) = (BTreeMap::new(), Vec::new());
        if self.args.write_baseline.is_some() {
            remembered = baseline::remembered(&file);
        }
        let sifted = self.baseline.as_ref().map(|baseline| {
            let (new, seen) = baseline.sift(&file);
            fixed = baseline.fixed(&loaded.path, &seen);
            new
        });
        let file = FileReport { findings: sifted.as_ref().unwrap_or(&findings), ..file };
        let mut summary = Summary::default();
        summary.add(file.findings);
        let mut text = self.printer.file(&file);
        if alone || !text.is_empty() {
            text.push_str(&picture);
        }
        Ok(Piece { text, summary, unreadable, remembered, fixed, path: loaded.path.clone() })
    }
}

/// The report as far as it is written.
#[derive(Default)]
struct Report {
    printer: Printer,
    summary: Summary,
    begun: bool,
    open: bool,
    unreadable: bool,
    fixed: Vec<String>,
    remembered: baseline::Writer,
}

impl Report {
    fn write(&mut self, text: &str) -> Result<(), Failure> {
        if self.open && !text.is_empty() {
            self.open = output::write(text.as_bytes())?;
        }
        Ok(())
    }

    fn add(&mut self, pieces: Vec<Piece>) -> Result<(), Failure> {
        let mut text = String::new();
        for piece in pieces {
            self.summary.merge(&piece.summary);
            self.unreadable |= piece.unreadable;
            self.fixed.extend(piece.fixed);
            self.remembered.add(piece.path, piece.remembered);
            if piece.text.is_empty() {
                continue;
            }
            if std::mem::replace(&mut self.begun, true) {
                text.push_str(self.printer.between());
            }
            text.push_str(&piece.text);
        }
        self.write(&text)
    }
}

type Found<'a> = (&'a str, Option<(&'a String, &'a str)>, Vec<Finding>, Vec<String>, String);

/// The findings of a program, with the texts that they are about, and a picture if one is wanted.
fn findings<'a>(loaded: &'a Loaded, options: &Options, screen: Option<Screen>) -> Found<'a> {
    let text = match &loaded.text {
        Ok(text) => text,
        Err(trouble) => {
            let (text, place, message) = trouble.describe("the file");
            return (text, None, vec![Finding::new(Code::Unreadable, Place::program(place), message)], Vec::new(), String::new());
        }
    };
    let template = match &loaded.template {
        None => None,
        Some((path, Ok(text))) => Some((path, text.as_str())),
        Some((path, Err(trouble))) => {
            let (template, place, message) = trouble.describe("the template");
            let finding = Finding::new(Code::Unreadable, Place { source: Source::Template, range: place }, message);
            return (text, Some((path, template)), vec![finding], Vec::new(), String::new());
        }
    };
    let input = Input { text, template: template.map(|(_, text)| text) };
    let analysis = analysis::analyse(&input, options, None);
    let objects = analysis.object_names();
    let picture = screen.map_or(String::new(), |screen| screen.show(&analysis, options));
    (text, template, analysis.findings, objects, picture)
}

impl Trouble {
    /// The text as far as there is one, the place of the trouble, and a sentence.
    fn describe(&self, what: &str) -> (&str, TextRange, String) {
        match self {
            Trouble::Io(error) => ("", TextRange::default(), format!("{what} could not be read: {error}")),
            Trouble::Encoding(text, at) => {
                let start = u32::try_from(*at).unwrap_or(u32::MAX);
                let size = char::REPLACEMENT_CHARACTER.len_utf8() as u32;
                (
                    text,
                    TextRange::at(start.into(), size.into()),
                    format!("{what} is not UTF-8: the byte at offset {at} begins no character"),
                )
            }
        }
    }
}
