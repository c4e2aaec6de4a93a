//! What the client asks, and what is done about it. Documents are written before the first wait of a handler.

use super::client::Client;
use super::diagnostics::Report;
use super::document::{self, Document, Role};
use super::lookout::Lookout;
use super::progress::Task;
use super::run::Outcome;
use super::settings::{self, Settings};
use super::shared::{Latest, Shared};
use super::state::{Key, State};
use super::watch::Ask;
use super::{actions, watch};
use crate::check::finding::Source;
use crate::repair::{self, Watch};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use tower_lsp_server::LanguageServer;
use tower_lsp_server::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp_server::ls_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem, CallHierarchyOutgoingCall,
    CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams, CodeLens, CodeLensParams, ColorInformation, ColorPresentation,
    ColorPresentationParams, CompletionItem, CompletionParams, CompletionResponse, DocumentColorParams, DocumentHighlight,
    DocumentHighlightParams, DocumentLink, DocumentLinkParams, DocumentSymbolParams, DocumentSymbolResponse, FoldingRange,
    FoldingRangeParams, GotoDefinitionParams, GotoDefinitionResponse, InlayHint, InlayHintParams, Location, PrepareRenameResponse,
    ReferenceParams, RenameParams, SelectionRange, SelectionRangeParams, SemanticTokensDeltaParams, SemanticTokensFullDeltaResult,
    SemanticTokensParams, SemanticTokensRangeParams, SemanticTokensRangeResult, SemanticTokensResult, SignatureHelp, SignatureHelpParams,
    TextDocumentPositionParams, WorkspaceEdit, WorkspaceSymbolParams, WorkspaceSymbolResponse,
};
use tower_lsp_server::ls_types::{CodeAction, ExecuteCommandParams, LSPAny, WorkspaceDiagnosticParams, WorkspaceDiagnosticReportResult};
use tower_lsp_server::ls_types::{
    CodeActionParams, CodeActionResponse, DidChangeConfigurationParams, DidChangeTextDocumentParams, DidChangeWatchedFilesParams,
    DidChangeWorkspaceFoldersParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams,
    DocumentDiagnosticParams, DocumentDiagnosticReport, DocumentDiagnosticReportKind, DocumentDiagnosticReportResult,
    FullDocumentDiagnosticReport, Hover, HoverParams, InitializeParams, InitializeResult, InitializedParams,
    RelatedFullDocumentDiagnosticReport, RelatedUnchangedDocumentDiagnosticReport, ServerInfo, SetTraceParams, TextDocumentIdentifier,
    UnchangedDocumentDiagnosticReport, Uri,
};

/// The number of the protocol for a request that was fine, but failed.
const REQUEST_FAILED: i64 = -32803;

/// The handlers.
#[derive(Clone, Debug)]
pub(super) struct Backend {
    pub shared: Arc<Shared>,
    pub client: tower_lsp_server::Client,
    /// Whether the client has asked to end.
    pub ending: Arc<AtomicBool>,
    pub refresh: watch::Refresh,
    /// Our own look-out for changes on the disk, for a client that keeps none.
    pub lookout: Arc<Mutex<Option<Lookout>>>,
}

/// `psdl/text`: what the server believes to stand in a document.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct TextParams {
    text_document: TextDocumentIdentifier,
}

/// The answer to `psdl/text`.
#[derive(Debug, Serialize)]
pub(super) struct TextResult {
    version: i32,
    text: String,
}

/// A request that could not be done, for a reason that a person understands.
pub(super) fn failed(why: &str) -> Error {
    Error { code: ErrorCode::ServerError(REQUEST_FAILED), message: why.to_string().into(), data: None }
}

pub(super) fn not_open() -> Error {
    Error::invalid_params("the document is not open")
}

impl LanguageServer for Backend {
    async fn initialize(&self, params: InitializeParams) -> Result<InitializeResult> {
        let client = Client::new(&params);
        let mut state = self.shared.state();
        state.client = client;
        state.trace = params.trace.unwrap_or_default();
        state.settings = params.initialization_options.as_ref().map(Settings::read).unwrap_or_default();
        let folders = params.workspace_folders.iter().flatten().map(|folder| &folder.uri);
        state.roots = folders.filter_map(document::file_path).collect();
        if state.roots.is_empty() {
            // What clients say that know of one folder only.
            #[expect(deprecated, reason = "older clients say nothing else")]
            let root = params.root_uri.as_ref().and_then(document::file_path);
            state.roots.extend(root);
        }
        tracing::info!("initialize: columns in {:?}, diagnostics {}", client.encoding, if client.pulls { "pulled" } else { "pushed" });
        let server_info = ServerInfo { name: "psdl".into(), version: Some(env!("CARGO_PKG_VERSION").into()) };
        Ok(InitializeResult { capabilities: client.offer(), server_info: Some(server_info), offset_encoding: None })
    }

    async fn initialized(&self, _: InitializedParams) {
        let client = self.shared.state().client;
        let files = client.watches.then(watch::registration);
        let settings = client.watches_settings.then(settings::registration);
        let registrations: Vec<_> = files.into_iter().chain(settings).collect();
        if !registrations.is_empty() {
            watch::register(self.client.clone(), registrations);
        }
        if client.has_settings {
            self.take_settings(&serde_json::Value::Null);
        }
    }

    async fn shutdown(&self) -> Result<()> {
        self.ending.store(true, Ordering::Relaxed);
        Ok(())
    }

    async fn did_open(&self, params: DidOpenTextDocumentParams) {
        let item = params.text_document;
        let mut state = self.shared.state();
        let document = Document::new(item.uri.clone(), &item.language_id, item.version, &item.text);
        let role = document.role;
        let path = document.path.clone().filter(|_| role != Role::Other && !state.client.watches);
        if state.documents.insert(item.uri.clone(), document).is_some() {
            tracing::warn!("a document was opened that was open already: its text is the new one");
        }
        let Some((key, source)) = state.documents.get(&item.uri).and_then(|document| state.unit_of(document)) else { return };
        let unit = state.unit(&key, if role == Role::Config { Role::Config } else { Role::Program });
        if source == Source::Program {
            unit.uri = Some(item.uri);
        }
        if let Some(path) = path {
            // Before the run that reads the files, so that no change slips between.
            drop(state);
            self.look_out(&path);
            state = self.shared.state();
        }
        self.touched(state, &key, role);
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        let mut state = self.shared.state();
        let encoding = state.client.encoding;
        let uri = params.text_document.uri;
        let Some(document) = state.documents.get_mut(&uri) else {
            return tracing::warn!("refused: a change of a document that is not open");
        };
        if params.text_document.version <= document.version {
            tracing::warn!("a change leads from version {} to {}", document.version, params.text_document.version);
        }
        document.version = params.text_document.version;
        let mut changes = Vec::with_capacity(params.content_changes.len());
        for change in &params.content_changes {
            if change.range.is_some_and(|range| range.start > range.end || !document.holds(range.start)) {
                tracing::warn!("refused: a change outside of the document, and those that come with it; the whole text sets it right");
                break;
            }
            changes.push(document.apply(change, encoding));
        }
        let role = document.role;
        let Some((key, source)) = state.documents.get(&uri).and_then(|document| state.unit_of(document)) else { return };
        changes.iter().for_each(|change| state.carry(&key, source, change));
        self.touched(state, &key, role);
    }

    async fn did_save(&self, params: DidSaveTextDocumentParams) {
        let Some(path) = document::file_path(&params.text_document.uri) else { return };
        let state = self.shared.state();
        // A client that watches files tells the same again, and more.
        if !state.client.watches {
            self.files_changed(state, &[path]);
        }
    }

    async fn did_close(&self, params: DidCloseTextDocumentParams) {
        let mut state = self.shared.state();
        let uri = params.text_document.uri;
        let Some(document) = state.documents.get(&uri) else {
            return tracing::warn!("refused: the closing of a document that is not open");
        };
        let unit = state.unit_of(document);
        let role = document.role;
        state.documents.remove(&uri);
        let pushes = !state.client.pulls;
        if role == Role::Program && pushes {
            self.shared.clear(&uri);
        }
        let Some((key, source)) = unit else { return };
        self.shared.forget_study(&uri);
        if let Some(unit) = state.units.get_mut(&key).filter(|_| source == Source::Program) {
            unit.uri = None;
        }
        let program_open = state.units.get(&key).is_some_and(|unit| unit.uri.is_some());
        if !program_open && state.open_template(&key).is_none() {
            state.forget(&key);
            let template = if let Key::Path(path) = &key { Uri::from_file_path(document::template_of(path)) } else { None };
            for uri in template.iter().chain([&uri]) {
                self.shared.clear_beside(&mut state, uri);
            }
        }
        self.touched(state, &key, role);
    }

    async fn did_change_watched_files(&self, params: DidChangeWatchedFilesParams) {
        let paths: Vec<_> = params.changes.iter().filter_map(|event| document::file_path(&event.uri)).collect();
        self.files_changed(self.shared.state(), &paths);
    }

    async fn did_change_configuration(&self, params: DidChangeConfigurationParams) {
        self.take_settings(&params.settings);
    }

    async fn did_change_workspace_folders(&self, params: DidChangeWorkspaceFoldersParams) {
        let mut state = self.shared.state();
        let paths = |folders: &[tower_lsp_server::ls_types::WorkspaceFolder]| -> Vec<_> {
            folders.iter().filter_map(|folder| document::file_path(&folder.uri)).collect()
        };
        let removed = paths(&params.event.removed);
        state.roots.retain(|root| !removed.contains(root));
        state.roots.extend(paths(&params.event.added));
    }

    async fn diagnostic(&self, params: DocumentDiagnosticParams) -> Result<DocumentDiagnosticReportResult> {
        let uri = params.text_document.uri;
        let outcome = self.latest(&uri)?;
        let Some((latest, client)) = outcome else { return Ok(full(None, None)) };
        let outcome = latest.wait().await?;
        let report = outcome.report(&uri);
        let related = client.related_documents.then(|| related(&outcome, &uri)).flatten();
        Ok(match report {
            Some(report) if params.previous_result_id.as_ref() == Some(&report.id) => unchanged(report, related),
            report => full(report, related),
        })
    }

    async fn workspace_diagnostic(&self, params: WorkspaceDiagnosticParams) -> Result<WorkspaceDiagnosticReportResult> {
        self.whole_workspace(params).await
    }

    async fn hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        self.show_hover(params).await
    }

    async fn inlay_hint(&self, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
        self.show_hints(params).await
    }

    async fn code_lens(&self, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
        self.show_lenses(params).await
    }

    async fn semantic_tokens_full(&self, params: SemanticTokensParams) -> Result<Option<SemanticTokensResult>> {
        self.paint(params).await
    }

    async fn semantic_tokens_full_delta(&self, params: SemanticTokensDeltaParams) -> Result<Option<SemanticTokensFullDeltaResult>> {
        self.repaint(params).await
    }

    async fn semantic_tokens_range(&self, params: SemanticTokensRangeParams) -> Result<Option<SemanticTokensRangeResult>> {
        self.paint_range(params).await
    }

    async fn goto_definition(&self, params: GotoDefinitionParams) -> Result<Option<GotoDefinitionResponse>> {
        self.show_definition(params).await
    }

    async fn references(&self, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
        self.show_references(params).await
    }

    async fn document_highlight(&self, params: DocumentHighlightParams) -> Result<Option<Vec<DocumentHighlight>>> {
        self.show_highlights(params).await
    }

    async fn prepare_rename(&self, params: TextDocumentPositionParams) -> Result<Option<PrepareRenameResponse>> {
        self.ask_rename(params).await
    }

    async fn rename(&self, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
        self.do_rename(params).await
    }

    async fn document_symbol(&self, params: DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>> {
        self.show_outline(params).await
    }

    async fn symbol(&self, params: WorkspaceSymbolParams) -> Result<Option<WorkspaceSymbolResponse>> {
        self.find_symbols(params).await
    }

    async fn folding_range(&self, params: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
        self.show_folds(params).await
    }

    async fn selection_range(&self, params: SelectionRangeParams) -> Result<Option<Vec<SelectionRange>>> {
        self.grow_selections(params).await
    }

    async fn prepare_call_hierarchy(&self, params: CallHierarchyPrepareParams) -> Result<Option<Vec<CallHierarchyItem>>> {
        self.ask_calls(params).await
    }

    async fn incoming_calls(&self, params: CallHierarchyIncomingCallsParams) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
        self.show_callers(params).await
    }

    async fn outgoing_calls(&self, params: CallHierarchyOutgoingCallsParams) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
        self.show_called(params).await
    }

    async fn document_link(&self, params: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
        self.show_links(params).await
    }

    async fn document_color(&self, params: DocumentColorParams) -> Result<Vec<ColorInformation>> {
        self.show_colors(params).await
    }

    async fn color_presentation(&self, params: ColorPresentationParams) -> Result<Vec<ColorPresentation>> {
        self.write_color(params).await
    }

    async fn completion(&self, params: CompletionParams) -> Result<Option<CompletionResponse>> {
        self.complete(params).await
    }

    async fn signature_help(&self, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
        self.show_signature(params).await
    }

    async fn completion_resolve(&self, item: CompletionItem) -> Result<CompletionItem> {
        Ok(self.explain(item))
    }

    async fn code_action(&self, params: CodeActionParams) -> Result<Option<CodeActionResponse>> {
        let Some((latest, client)) = self.latest(&params.text_document.uri)? else { return Ok(None) };
        let outcome = latest.wait().await?;
        if outcome.main.text.uri.as_ref() != Some(&params.text_document.uri) {
            return Ok(None);
        }
        let study = self.shared.study(&outcome);
        let watch = self.shared.watch(&params.text_document.uri);
        let work = move |watch: &Watch| actions::list(&study, &params, client, watch);
        self.thought(watch, work).await.map(Some)
    }

    async fn execute_command(&self, params: ExecuteCommandParams) -> Result<Option<LSPAny>> {
        self.execute(params).await
    }

    async fn code_action_resolve(&self, mut action: CodeAction) -> Result<CodeAction> {
        let Some(data) = actions::data(&action) else { return Ok(action) };
        let (outcome, client) = self.as_it_was(&data.uri, data.version).await?;
        let study = self.shared.study(&outcome);
        let watch = self.shared.watch(&data.uri);
        let task = Task { token: None, title: "Fixing layout errors", budget: repair::Settings::default().budget, watch: watch.clone() };
        let shared = watch.clone();
        let work = self.thought(watch, move |_| actions::resolve(&study, &data, &shared));
        let found = self.followed(task, work).await?;
        let found = found.filter(|found| !found.edits.is_empty());
        let found = found.ok_or_else(|| failed("nothing was found that leaves fewer errors"))?;
        let text = &outcome.main.text;
        action.edit = Some(actions::annotated_edit(text, &found.edits, &action.title, found.moves, client));
        Ok(action)
    }
}

impl Backend {
    /// `psdl/text`
    pub(super) async fn text(&self, params: TextParams) -> Result<TextResult> {
        let state = self.shared.state();
        let document = state.documents.get(&params.text_document.uri).ok_or_else(not_open)?;
        Ok(TextResult { version: document.version, text: document.text.to_string() })
    }

    /// `$/setTrace`
    pub(super) async fn set_trace(&self, params: SetTraceParams) {
        self.shared.state().trace = params.value;
    }

    /// What there is to say about an open document; `None` about one that nobody looks at.
    pub(super) fn latest(&self, uri: &Uri) -> Result<Option<(Latest, Client)>> {
        if !self.shared.state().documents.contains_key(uri) {
            return Err(not_open());
        }
        Ok(self.shared.latest(uri))
    }

    /// What there is to say about a version of a document, if that is still the newest.
    pub(super) async fn as_it_was(&self, uri: &Uri, version: Option<i32>) -> Result<(Arc<Outcome>, Client)> {
        let Some((latest, client)) = self.latest(uri)? else { return Err(not_open()) };
        let outcome = latest.wait().await?;
        let same = outcome.main.text.version == version && outcome.main.text.uri.as_ref() == Some(uri);
        if same { Ok((outcome, client)) } else { Err(Error::content_modified()) }
    }

    /// Has work done beside the runs; an edit of the document ends it.
    pub(super) async fn thought<T: Send + 'static>(&self, watch: Arc<Watch>, work: impl FnOnce(&Watch) -> T + Send + 'static) -> Result<T> {
        let result = self.shared.think(watch.clone(), work).await;
        match result {
            _ if watch.cancelled.load(Ordering::Relaxed) => Err(Error::content_modified()),
            Some(result) => Ok(result),
            None => Err(Error::internal_error()),
        }
    }

    /// Does what follows from a document having become another.
    fn touched(&self, mut state: std::sync::MutexGuard<'_, State>, key: &Key, role: Role) {
        if role == Role::Config {
            state.configure();
        }
        state.schedule(key, true);
        let client = state.client;
        drop(state);
        self.shared.wake();
        if role != Role::Program {
            self.ask_again(client);
        }
    }

    /// Tells the client to ask again for all that does not follow from the text of a program alone.
    fn ask_again(&self, client: Client) {
        let kinds = [
            (client.pulls && client.refreshes, Ask::Diagnostics),
            (client.refreshes_hints, Ask::Hints),
            (client.refreshes_lenses, Ask::Lenses),
            (client.refreshes_tokens, Ask::Tokens),
        ];
        kinds.into_iter().filter(|(can, _)| *can).for_each(|(_, what)| self.refresh.ask(&self.client, what));
    }

    /// Looks out for changes beside a document and above it, where the client does not.
    fn look_out(&self, document: &std::path::Path) {
        let mut lookout = self.lookout.lock().unwrap_or_else(PoisonError::into_inner);
        if lookout.is_none() {
            let backend = Backend { lookout: Arc::default(), ..self.clone() };
            match Lookout::new(move |paths| backend.files_changed(backend.shared.state(), paths)) {
                Ok(new) => *lookout = Some(new),
                Err(error) => tracing::warn!("changes on the disk are not noticed: {error}"),
            }
        }
        if let Some(lookout) = lookout.as_mut() {
            lookout.watch(document);
        }
    }

    /// Does what follows from files having become others.
    fn files_changed(&self, mut state: std::sync::MutexGuard<'_, State>, paths: &[PathBuf]) {
        // What is open counts as it is open: to save it changes nothing, and must not end the work on it.
        let open = |path: &PathBuf| state.documents.values().any(|document| document.path.as_ref() == Some(path));
        let paths: Vec<&PathBuf> = paths.iter().filter(|path| !open(path)).collect();
        let roles: Vec<Role> = paths.iter().map(|path| document::role(Some(path), "")).collect();
        if roles.contains(&Role::Config) {
            state.configure();
        } else {
            let keys: Vec<Key> = state.units.keys().cloned().collect();
            let reads = |key: &Key| match key {
                Key::Path(program) => paths.iter().any(|path| ***path == **program || **path == document::template_of(program)),
                Key::Name(_) => false,
            };
            keys.iter().filter(|key| reads(key)).for_each(|key| state.schedule(key, false));
        }
        let client = state.client;
        drop(state);
        self.shared.wake();
        if roles.iter().any(|role| *role != Role::Other) {
            self.ask_again(client);
        }
    }
}

impl Outcome {
    /// All that is said, by document.
    fn reports(&self) -> impl Iterator<Item = &Report> {
        [&self.main].into_iter().chain(&self.template).chain(&self.config)
    }

    /// What is said about one document.
    fn report(&self, uri: &Uri) -> Option<&Report> {
        self.reports().find(|report| report.text.uri.as_ref() == Some(uri))
    }
}

/// What is said about other documents than the one that was asked for.
fn related(outcome: &Outcome, asked: &Uri) -> Option<HashMap<Uri, DocumentDiagnosticReportKind>> {
    let others = outcome.reports().skip(1).filter_map(|report| Some((report.text.uri.clone()?, report)));
    let related: HashMap<_, _> = others.filter(|(uri, _)| uri != asked).map(|(uri, report)| (uri, kind(report))).collect();
    (!related.is_empty()).then_some(related)
}

fn items(report: Option<&Report>) -> FullDocumentDiagnosticReport {
    FullDocumentDiagnosticReport {
        result_id: report.map(|report| report.id.clone()),
        items: report.map(Report::diagnostics).unwrap_or_default(),
    }
}

fn kind(report: &Report) -> DocumentDiagnosticReportKind {
    DocumentDiagnosticReportKind::Full(items(Some(report)))
}

fn full(report: Option<&Report>, related_documents: Option<HashMap<Uri, DocumentDiagnosticReportKind>>) -> DocumentDiagnosticReportResult {
    let full_document_diagnostic_report = items(report);
    let report = RelatedFullDocumentDiagnosticReport { related_documents, full_document_diagnostic_report };
    DocumentDiagnosticReportResult::Report(DocumentDiagnosticReport::Full(report))
}

fn unchanged(report: &Report, related_documents: Option<HashMap<Uri, DocumentDiagnosticReportKind>>) -> DocumentDiagnosticReportResult {
    let unchanged_document_diagnostic_report = UnchangedDocumentDiagnosticReport { result_id: report.id.clone() };
    let report = RelatedUnchangedDocumentDiagnosticReport { related_documents, unchanged_document_diagnostic_report };
    DocumentDiagnosticReportResult::Report(DocumentDiagnosticReport::Unchanged(report))
}
