//! What a feature is asked about: a document as it was when the client asked, and the scene of the last run.

use super::client::Client;
use super::document::{Document, Role};
use super::handlers::Backend;
use super::run::Outcome;
use super::settings::Settings;
use super::shared::Latest;
use super::state::{Key, State};
use crate::ide::{Program, Scene, View};
use crate::syntax::{LineColumn, LineIndex};
use ruff_text_size::{TextRange, TextSize};
use std::sync::Arc;
use std::time::Duration;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::{
    DocumentChanges, Location, OneOf, OptionalVersionedTextDocumentIdentifier, Position, Range, TextDocumentEdit, TextEdit, Uri,
    WorkspaceEdit,
};

/// How long an answer waits for a run that is under way, before it tells of the scene before.
const PATIENCE: Duration = Duration::from_millis(100);

/// For what a feature waits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Wait {
    /// The text is enough; of the scene, what is known.
    No,
    /// A moment, for the scene of the text as it is.
    Shortly,
    /// The scene of the text as it is, or of a newer one.
    Until,
}

/// A document, and what is known about it.
#[derive(Clone, Debug)]
pub(super) struct Snapshot {
    pub uri: Uri,
    /// `None` where it is not open.
    pub version: Option<i32>,
    pub key: Key,
    pub lines: Arc<LineIndex>,
    pub program: Arc<Program>,
    pub scene: Option<Arc<Scene>>,
    pub client: Client,
    pub settings: Settings,
}

impl Snapshot {
    /// What the features of `ide` take.
    pub(super) fn view(&self) -> View<'_> {
        View::new(&self.program, self.scene.as_deref())
    }

    pub(super) fn text(&self) -> &str {
        &self.program.text
    }

    pub(super) fn offset(&self, position: Position) -> TextSize {
        let place = LineColumn { line: position.line, column: position.character };
        self.lines.offset(place, self.text(), self.client.encoding)
    }

    pub(super) fn position(&self, offset: TextSize) -> Position {
        let place = self.lines.line_column(offset, self.text(), self.client.encoding);
        Position::new(place.line, place.column)
    }

    pub(super) fn range(&self, range: TextRange) -> Range {
        Range::new(self.position(range.start()), self.position(range.end()))
    }

    /// The bytes of a range, turned around where it is the wrong way.
    pub(super) fn bytes(&self, range: Range) -> TextRange {
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        TextRange::new(start.min(end), start.max(end))
    }

    pub(super) fn location(&self, range: TextRange) -> Location {
        Location { uri: self.uri.clone(), range: self.range(range) }
    }

    /// Edits of files, for the versions that they were made for where the client can tell.
    pub(super) fn edit(&self, files: Vec<(Uri, Option<i32>, Vec<TextEdit>)>) -> WorkspaceEdit {
        if !self.client.document_changes {
            let changes = files.into_iter().map(|(uri, _, edits)| (uri, edits)).collect();
            return WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() };
        }
        let files = files.into_iter().map(|(uri, version, edits)| TextDocumentEdit {
            text_document: OptionalVersionedTextDocumentIdentifier { uri, version },
            edits: edits.into_iter().map(OneOf::Left).collect(),
        });
        WorkspaceEdit { document_changes: Some(DocumentChanges::Edits(files.collect())), ..WorkspaceEdit::default() }
    }
}

/// A document as it stands.
struct Asked {
    uri: Uri,
    version: i32,
    key: Key,
    text: ropey::Rope,
}

impl Backend {
    /// A program that is open, as it stands now; `None` for a document that is no program.
    pub(super) async fn snapshot(&self, uri: &Uri, wait: Wait) -> Result<Option<Snapshot>> {
        let asked = {
            let state = self.shared.state();
            let Some(document) = state.documents.get(uri) else { return Err(Error::invalid_params("the document is not open")) };
            match asked(&state, document) {
                Some(asked) => asked,
                None => return Ok(None),
            }
        };
        let latest = if wait == Wait::No { None } else { self.shared.latest(uri) };
        match (wait, latest) {
            (Wait::Shortly, Some((latest @ Latest::Later(_), _))) => {
                // Where it takes longer, the scene before has to do.
                let _ = tokio::time::timeout(PATIENCE, latest.wait()).await;
            }
            (_, Some((latest, _))) => {
                latest.wait().await?;
            }
            _ => {}
        }
        Ok(Some(self.look(asked)))
    }

    /// Puts together what is known now.
    fn look(&self, asked: Asked) -> Snapshot {
        let state = self.shared.state();
        let unit = state.units.get(&asked.key);
        let outcome = unit.and_then(|unit| unit.latest.as_ref()).map(|(_, outcome)| outcome.clone());
        let scene = unit.and_then(|unit| unit.scene.clone());
        let (client, settings) = (state.client, state.settings);
        drop(state);
        let same = |outcome: &&Arc<Outcome>| {
            outcome.main.text.version == Some(asked.version) && outcome.main.text.uri.as_ref() == Some(&asked.uri)
        };
        let read = outcome.as_ref().filter(same).and_then(|outcome| Some((outcome.program.clone()?, outcome.main.text.lines.clone())));
        let (program, lines) = read.unwrap_or_else(|| {
            let program = Program::read(asked.text.to_string().into());
            let lines = LineIndex::new(&program.text);
            (Arc::new(program), Arc::new(lines))
        });
        Snapshot { uri: asked.uri, version: Some(asked.version), key: asked.key, lines, program, scene, client, settings }
    }

    /// The programs that are open, as they stand now.
    pub(super) fn open_programs(&self) -> Vec<Snapshot> {
        let state = self.shared.state();
        let all: Vec<Asked> = state.documents.values().filter_map(|document| asked(&state, document)).collect();
        drop(state);
        all.into_iter().map(|asked| self.look(asked)).collect()
    }
}

fn asked(state: &State, document: &Document) -> Option<Asked> {
    if document.role != Role::Program {
        return None;
    }
    let (key, _) = state.unit_of(document)?;
    Some(Asked { uri: document.uri.clone(), version: document.version, key, text: document.text.clone() })
}
