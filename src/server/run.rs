//! One run: the texts of a program, its template and its configuration as they were → what there is to say about them.

use super::client::Client;
use super::diagnostics::{self, Item, Report, Writer};
use super::document::{Role, template_of};
use crate::analysis::{self, Analysis, Input, Options, Prepared};
use crate::check::finding::{Code, Finding, Place, Source};
use crate::config::{ConfigError, Resolved, Resolver};
use crate::ide::{Program, Scene};
use crate::syntax::LineIndex;
use ropey::Rope;
use ruff_text_size::TextRange;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use tower_lsp_server::ls_types::Uri;

/// Larger files are not read: no program is that long.
const MAX_BYTES: u64 = 64 << 20;

/// A document that is open.
#[derive(Clone, Debug)]
pub(super) struct Open {
    pub uri: Uri,
    pub version: i32,
    pub text: Rope,
}

/// A finding of the last run that came to something, at its place in the text as it is now.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Kept {
    pub finding: Finding,
    /// The names of the objects of the finding.
    pub objects: Vec<String>,
}

/// What is to be done: nothing in it changes while it is done.
#[derive(Clone)]
pub(super) struct Job {
    /// Where the file is. A program that has none is called as if it were in the first folder of the workspace, so that
    /// the configuration there holds for it.
    pub path: Option<PathBuf>,
    /// Whether it is a program or a configuration.
    pub role: Role,
    /// Whether the program is on the disk, or may be.
    pub on_disk: bool,
    /// The document, if it is open.
    pub document: Option<Open>,
    /// The document of the template, if it is open.
    pub template: Option<Open>,
    pub resolver: Arc<Resolver<'static>>,
    pub client: Client,
    pub kept: Vec<Kept>,
    pub cancel: Arc<AtomicBool>,
}

/// What came of a run.
#[derive(Debug)]
pub(super) struct Outcome {
    /// About the program or the configuration.
    pub main: Report,
    /// About the template, where there is one.
    pub template: Option<Report>,
    /// About the configuration, where it cannot be used.
    pub config: Option<Report>,
    /// The files of the configuration that holds.
    pub config_files: Vec<PathBuf>,
    /// What holds for the program.
    pub options: Options,
    /// Whether the program could be run.
    pub ran: bool,
    /// The program, read.
    pub program: Option<Arc<Program>>,
    /// What is kept of a program that could be run.
    pub fresh: Option<Fresh>,
}

/// What is kept until the next run that comes to something.
#[derive(Debug)]
pub(super) struct Fresh {
    pub kept: Vec<Kept>,
    pub scene: Arc<Scene>,
}

/// A text with its name and its lines.
#[derive(Debug)]
pub(super) struct Text {
    pub uri: Option<Uri>,
    pub version: Option<i32>,
    pub text: Arc<str>,
    pub lines: Arc<LineIndex>,
}

impl Text {
    pub(super) fn new(uri: Option<Uri>, version: Option<i32>, text: impl Into<Arc<str>>) -> Text {
        let text = text.into();
        Text { lines: Arc::new(LineIndex::new(&text)), uri, version, text }
    }

    pub(super) fn open(open: &Open) -> Text {
        Text::new(Some(open.uri.clone()), Some(open.version), open.text.to_string())
    }

    fn file(path: &Path, text: String) -> Text {
        Text::new(Uri::from_file_path(path), None, text)
    }
}

/// Does it; `None` if it was cancelled.
pub(super) fn run(job: &Job) -> Option<Outcome> {
    match job.role {
        Role::Config => Some(configuration(job)),
        _ => program(job),
    }
}

/// Looks at a configuration that is open.
fn configuration(job: &Job) -> Outcome {
    let text = job.document.as_ref().map_or_else(|| Text::new(None, None, String::new()), Text::open);
    let beside = job.path.as_ref().map(|path| path.with_file_name("any.psdl"));
    let items = match beside.map(|path| job.resolver.resolve(&path)) {
        Some(Err(error)) if Some(&error.path) == job.path.as_ref() => diagnostics::configuration(&error, &text, job.client),
        _ => Vec::new(),
    };
    Outcome {
        main: Report::new(text, items),
        template: None,
        config: None,
        config_files: Vec::new(),
        options: Options::default(),
        ran: false,
        program: None,
        fresh: None,
    }
}

fn program(job: &Job) -> Option<Outcome> {
    let (Resolved { options, files, excluded, .. }, error) = match job.path.as_deref().map(|path| job.resolver.resolve(path)) {
        None => (Resolved::default(), None),
        Some(Ok(resolved)) => (resolved, None),
        Some(Err(error)) => (Resolved::default(), Some(error)),
    };
    let (text, is_program) = program_text(job);
    let (template, trouble) = template_text(job);
    let writer = Writer { program: &text, template: template.as_ref(), client: job.client };

    let (mut read, mut fresh) = (None, None);
    let mut items = match trouble {
        Some(finding) => vec![writer.item(finding, &[], false)],
        None => {
            let input = Input { text: &text.text, template: template.as_ref().map(|template| &*template.text) };
            if is_program {
                let analysis = analysis::analyse(&input, &options, Some(&job.cancel));
                if analysis.cancelled {
                    return None;
                }
                let judged = judged(job, &writer, analysis);
                (read, fresh) = (Some(judged.program), judged.fresh);
                judged.items
            } else {
                let found = analysis::prepare(&input).findings.into_iter();
                found.map(|finding| writer.item(finding, &[], false)).collect()
            }
        }
    };
    if excluded {
        // As in a walk over the folder, nothing is said about it; all else works.
        items.clear();
    }
    if let Some(error) = &error {
        items.insert(0, writer.bad_configuration(error));
    }
    let (about_template, about_program): (Vec<Item>, Vec<Item>) =
        items.into_iter().partition(|item| item.finding.as_ref().is_some_and(|finding| finding.place.source == Source::Template));
    let config = error.map(|error| config_report(&error, job.client));
    Some(Outcome {
        main: Report::new(text, about_program),
        template: template.map(|template| Report::new(template, about_template)),
        config,
        config_files: files,
        options,
        program: read,
        ran: fresh.is_some(),
        fresh,
    })
}

/// What came of an analysis.
struct Judged {
    items: Vec<Item>,
    program: Arc<Program>,
    fresh: Option<Fresh>,
}

/// What was found; where nothing could be run, what was found last, marked stale.
fn judged(job: &Job, writer: &Writer, analysis: Analysis) -> Judged {
    let names = analysis.object_names();
    let named = |finding: Finding| {
        let objects = finding.objects.iter().filter_map(|index| names.get(*index).cloned()).collect();
        Kept { finding, objects }
    };
    let found: Vec<Kept> = analysis.findings.into_iter().map(named).collect();
    let mut items: Vec<Item> = found.iter().map(|kept| writer.item(kept.finding.clone(), &kept.objects, false)).collect();
    let text = writer.program.text.clone();
    let Prepared { parsed, mut tuning, template, .. } = analysis.prepared;
    if !parsed.is_complete() {
        tuning = crate::syntax::tune(&parsed, &text);
    }
    let program = Arc::new(Program { text: text.clone(), parsed, tuning });
    let Some(layout) = analysis.layout else {
        items.extend(job.kept.iter().map(|kept| writer.item(kept.finding.clone(), &kept.objects, true)));
        return Judged { items, program, fresh: None };
    };
    let scene = Arc::new(Scene { text, layout, verdict: analysis.verdict, template, partial: analysis.partial });
    Judged { items, program, fresh: Some(Fresh { kept: found, scene }) }
}

/// The program, and whether there is one: a template may be open beside no program at all.
fn program_text(job: &Job) -> (Text, bool) {
    if let Some(open) = &job.document {
        return (Text::open(open), true);
    }
    let read = job.path.as_deref().filter(|_| job.on_disk).map(|path| (path, read(path)));
    match read {
        Some((path, Ok(Some(Ok(text))))) => (Text::file(path, text), true),
        _ => (Text::new(job.path.as_deref().and_then(Uri::from_file_path), None, String::new()), false),
    }
}

/// The template, and what stands in the way of reading it.
fn template_text(job: &Job) -> (Option<Text>, Option<Finding>) {
    if let Some(open) = &job.template {
        return (Some(Text::open(open)), None);
    }
    let Some(path) = job.path.as_deref().filter(|_| job.on_disk).map(template_of) else { return (None, None) };
    let unreadable = |range, message: String| {
        let place = Place { source: Source::Template, range };
        Some(Finding::new(Code::Unreadable, place, message))
    };
    match read(&path) {
        Ok(None) => (None, None),
        Ok(Some(Ok(text))) => (Some(Text::file(&path, text)), None),
        Ok(Some(Err((text, at)))) => {
            let at = u32::try_from(at).unwrap_or(u32::MAX);
            let range = TextRange::at(at.into(), (char::REPLACEMENT_CHARACTER.len_utf8() as u32).into());
            let message = format!("the template is not UTF-8: the byte at offset {at} begins no character");
            (Some(Text::file(&path, text)), unreadable(range, message))
        }
        Err(error) => {
            let message = format!("the template could not be read: {error}");
            (Some(Text::file(&path, String::new())), unreadable(TextRange::default(), message))
        }
    }
}

fn config_report(error: &ConfigError, client: Client) -> Report {
    let text = Text::file(&error.path, error.text.clone());
    let items = diagnostics::configuration(error, &text, client);
    Report::new(text, items)
}

/// A text with what is no UTF-8 replaced, and the byte where the first of that stands.
type Broken = (String, usize);

/// Reads a file; `None` where there is none.
fn read(path: &Path) -> io::Result<Option<Result<String, Broken>>> {
    let file = match std::fs::File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    };
    if !file.metadata()?.is_file() {
        return Ok(None);
    }
    let mut bytes = Vec::new();
    file.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(io::Error::other(format!("larger than {} MiB", MAX_BYTES >> 20)));
    }
    Ok(Some(String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        (String::from_utf8_lossy(error.as_bytes()).into_owned(), at)
    })))
}
