//! A program together with its sidecar template, for what concerns both files.

use super::document::{Document, Role, file_path, program_of, template_of};
use super::handlers::{Backend, not_open};
use super::state::Key;
use super::view::{Snapshot, Wait};
use crate::check::finding::Source;
use crate::ide::{self, Program, Site};
use crate::scene::template::{self, Template};
use crate::syntax::{Encoding, LineColumn, LineIndex};
use ruff_text_size::{TextRange, TextSize};
use std::path::Path;
use std::sync::Arc;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::{Location, Position, Range, Uri};

/// Larger templates are not read.
const MAX_BYTES: u64 = 4 << 20;

/// A sidecar as it stands, open or on the disk.
#[derive(Debug)]
pub(super) struct Sidecar {
    pub uri: Uri,
    /// `None` where it is not open.
    pub version: Option<i32>,
    pub text: String,
    lines: LineIndex,
    encoding: Encoding,
    /// What it says, if it can be read.
    pub template: Option<Template>,
}

/// A program and its sidecar, and which of them was asked about.
#[derive(Debug)]
pub(super) struct Pair {
    pub program: Snapshot,
    pub sidecar: Option<Sidecar>,
    pub asked: Source,
}

impl Sidecar {
    fn new(uri: Uri, version: Option<i32>, text: String, encoding: Encoding) -> Sidecar {
        Sidecar { lines: LineIndex::new(&text), template: template::parse(&text).ok(), uri, version, text, encoding }
    }

    pub(super) fn range(&self, range: TextRange) -> Range {
        let position = |offset| {
            let at = self.lines.line_column(offset, &self.text, self.encoding);
            Position::new(at.line, at.column)
        };
        Range::new(position(range.start()), position(range.end()))
    }

    pub(super) fn offset(&self, position: Position) -> TextSize {
        let place = LineColumn { line: position.line, column: position.character };
        self.lines.offset(place, &self.text, self.encoding)
    }
}

impl Pair {
    pub(super) fn template(&self) -> Option<&Template> {
        self.sidecar.as_ref().and_then(|sidecar| sidecar.template.as_ref())
    }

    /// What the renaming takes.
    pub(super) fn readable(&self) -> Option<ide::TemplateText<'_>> {
        let sidecar = self.sidecar.as_ref()?;
        Some(ide::TemplateText { text: &sidecar.text, template: sidecar.template.as_ref()? })
    }

    /// A place in one of the two files.
    pub(super) fn location(&self, site: Site) -> Option<Location> {
        match site {
            Site::Program(range) => Some(self.program.location(range)),
            Site::Template(range) => {
                let sidecar = self.sidecar.as_ref()?;
                Some(Location { uri: sidecar.uri.clone(), range: sidecar.range(range) })
            }
        }
    }
}

impl Backend {
    /// The program and the sidecar that a document is one of; `None` for any other document, and for a sidecar without a program.
    pub(super) async fn pair(&self, uri: &Uri, wait: Wait) -> Result<Option<Pair>> {
        if let Some(program) = self.snapshot(uri, wait).await? {
            let sidecar = self.sidecar(&program.key);
            return Ok(Some(Pair { program, sidecar, asked: Source::Program }));
        }
        let open = {
            let state = self.shared.state();
            let document = state.documents.get(uri).ok_or_else(not_open)?;
            match state.unit_of(document) {
                Some((key, Source::Template)) => state.units.get(&key).map(|unit| unit.uri.clone()),
                _ => return Ok(None),
            }
        };
        let program = match open.flatten() {
            Some(program) => self.snapshot(&program, wait).await?,
            None => self.program_on_disk(uri),
        };
        let Some(program) = program else { return Ok(None) };
        let sidecar = self.sidecar(&program.key);
        Ok(Some(Pair { program, sidecar, asked: Source::Template }))
    }

    /// The sidecar of a program.
    fn sidecar(&self, key: &Key) -> Option<Sidecar> {
        let Key::Path(path) = key else { return None };
        let state = self.shared.state();
        let encoding = state.client.encoding;
        if let Some(Document { uri, version, text, .. }) = state.open_template(key) {
            return Some(Sidecar::new(uri.clone(), Some(*version), text.to_string(), encoding));
        }
        drop(state);
        let path = template_of(path);
        Some(Sidecar::new(Uri::from_file_path(&path)?, None, read(&path)?, encoding))
    }

    /// The program of a sidecar that is open, from the disk.
    fn program_on_disk(&self, template: &Uri) -> Option<Snapshot> {
        let path = program_of(&file_path(template)?)?;
        let program = Program::read(read(&path)?.into());
        let state = self.shared.state();
        debug_assert!(state.documents.get(template).is_none_or(|document| document.role == Role::Template));
        Some(Snapshot {
            uri: Uri::from_file_path(&path)?,
            version: None,
            key: Key::Path(path.as_path().into()),
            lines: Arc::new(LineIndex::new(&program.text)),
            program: Arc::new(program),
            scene: None,
            client: state.client,
            settings: state.settings,
        })
    }
}

/// A file that is there, is text, and is not too large.
pub(super) fn read(path: &Path) -> Option<String> {
    let size = std::fs::metadata(path).ok().filter(std::fs::Metadata::is_file)?.len();
    if size > MAX_BYTES { None } else { std::fs::read_to_string(path).ok() }
}
