//! `psdl check`: many programs in parallel, one report in a stable order, in memory that does not grow with their number.

use super::args::CheckArgs;
use super::files::{Loaded, Program, Trouble, programs};
use super::output::{self, Failure};
use super::progress::Progress;
use super::{Outcome, STACK};
use crate::analysis::{self, Input, Options};
use crate::check::finding::{Code, Finding, Place, Source};
use crate::report::{FileReport, Format, Printer, Summary};
use rayon::prelude::*;
use ruff_text_size::TextRange;

/// So many files are under way before their part of the report is written.
const BATCH: usize = 256;

/// What one program adds to the report.
struct Piece {
    text: String,
    summary: Summary,
    unreadable: bool,
}

/// Which findings are reported.
struct Filter<'a> {
    select: &'a [Code],
    ignore: &'a [Code],
}

impl Filter<'_> {
    fn keeps(&self, code: Code) -> bool {
        (self.select.is_empty() || self.select.contains(&code)) && !self.ignore.contains(&code)
    }
}

pub(super) fn check(args: &CheckArgs, color: bool) -> Result<Outcome, Failure> {
    let programs = programs(&args.paths, args.stdin_filename.as_deref())?;
    let printer = Printer { format: args.format, color: color && args.format == Format::Text, statistics: args.statistics };
    let filter = Filter { select: &args.select, ignore: &args.ignore };
    let pool = rayon::ThreadPoolBuilder::new().stack_size(STACK).build();
    let pool = pool.map_err(|error| Failure::new(format!("threads could not be started: {error}")))?;
    let options = Options::default();

    let mut report = Report { printer, summary: Summary::default(), first: true, open: true, unreadable: false };
    let mut progress = Progress::new(programs.len());
    report.write(printer.head())?;
    for batch in programs.chunks(BATCH) {
        let pieces: Vec<Piece> = pool.install(|| batch.par_iter().map(|program| piece(program, &printer, &filter, &options)).collect());
        progress.advance(batch.len());
        progress.around(|| report.add(pieces))?;
        if !report.open {
            break;
        }
    }
    progress.done();
    report.finish()?;
    if report.unreadable {
        return Err(Failure::new("some files could not be read"));
    }
    Ok(if report.summary.fails() && !args.exit_zero { Outcome::Findings } else { Outcome::Clean })
}

/// The report as far as it is written.
struct Report {
    printer: Printer,
    summary: Summary,
    first: bool,
    open: bool,
    unreadable: bool,
}

impl Report {
    fn write(&mut self, text: String) -> Result<(), Failure> {
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
            if piece.text.is_empty() {
                continue;
            }
            if !std::mem::take(&mut self.first) {
                text.push_str(self.printer.between());
            }
            text.push_str(&piece.text);
        }
        self.write(text)
    }

    fn finish(&mut self) -> Result<(), Failure> {
        self.write(self.printer.tail(&self.summary))
    }
}

fn piece(program: &Program, printer: &Printer, filter: &Filter, options: &Options) -> Piece {
    let loaded = program.load();
    let unreadable = matches!(loaded.text, Err(Trouble::Io(_)));
    let (text, template, mut findings, objects) = findings(&loaded, options);
    findings.retain(|finding| filter.keeps(finding.code));
    let template = template.map(|(path, text)| (path.as_str(), text));
    let file = FileReport { path: &loaded.path, text, template, findings: &findings, objects: &objects };
    let mut summary = Summary::default();
    summary.add(&findings);
    Piece { text: printer.file(&file), summary, unreadable }
}

type Found<'a> = (&'a str, Option<(&'a String, &'a str)>, Vec<Finding>, Vec<String>);

/// The findings of a program, with the texts that they are about.
fn findings<'a>(loaded: &'a Loaded, options: &Options) -> Found<'a> {
    let text = match &loaded.text {
        Ok(text) => text,
        Err(trouble) => {
            let (text, place, message) = trouble.describe("the file");
            return (text, None, vec![Finding::new(Code::Unreadable, Place::program(place), message)], Vec::new());
        }
    };
    let template = match &loaded.template {
        None => None,
        Some((path, Ok(text))) => Some((path, text.as_str())),
        Some((path, Err(trouble))) => {
            let (template, place, message) = trouble.describe("the template");
            let finding = Finding::new(Code::Unreadable, Place { source: Source::Template, range: place }, message);
            return (text, Some((path, template)), vec![finding], Vec::new());
        }
    };
    let input = Input { text, template: template.map(|(_, text)| text) };
    let analysis = analysis::analyse(&input, options, None);
    let objects = analysis.object_names();
    (text, template, analysis.findings, objects)
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
