//! What helps to move about in a program: where names are bound and used, the outline, calls, links, colours.

use super::document::{Role, role};
use super::handlers::{Backend, failed};
use super::sidecar::{Pair, read};
use super::view::{Snapshot, Wait};
use crate::check::finding::Source;
use crate::ide::{self, FoldKind, Program, Refusal, SymbolKind as Kind, Use, View};
use crate::syntax::{Edit, LineIndex};
use ruff_text_size::TextRange;
use std::sync::Arc;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem, CallHierarchyOutgoingCall,
    CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams, Color, ColorInformation, ColorPresentation, ColorPresentationParams,
    DocumentColorParams, DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, DocumentLink, DocumentLinkParams,
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, FoldingRange, FoldingRangeKind, FoldingRangeParams, GotoDefinitionParams,
    GotoDefinitionResponse, Location, OneOf, PrepareRenameResponse, Range, ReferenceParams, RenameParams, SelectionRange,
    SelectionRangeParams, SymbolKind, TextDocumentPositionParams, TextEdit, Uri, WorkspaceEdit, WorkspaceSymbol, WorkspaceSymbolParams,
    WorkspaceSymbolResponse,
};

/// Of so many programs on the disk the names are searched.
const MAX_FILES: usize = 500;
/// So many names are found.
const MAX_SYMBOLS: usize = 500;

impl Backend {
    pub(super) async fn show_definition(&self, params: GotoDefinitionParams) -> Result<Option<GotoDefinitionResponse>> {
        let at = params.text_document_position_params;
        let Some(pair) = self.pair(&at.text_document.uri, Wait::No).await? else { return Ok(None) };
        let sites = match (pair.asked, &pair.sidecar, pair.template()) {
            (Source::Program, _, template) => ide::definition(&pair.program.view(), template, pair.program.offset(at.position)),
            (Source::Template, Some(sidecar), Some(template)) => {
                ide::references_of_id(&pair.program.view(), template, sidecar.offset(at.position), false)
            }
            _ => Vec::new(),
        };
        let locations: Vec<Location> = sites.into_iter().filter_map(|site| pair.location(site)).collect();
        Ok((!locations.is_empty()).then_some(GotoDefinitionResponse::Array(locations)))
    }

    pub(super) async fn show_references(&self, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
        let at = params.text_document_position;
        let with_bindings = params.context.include_declaration;
        let Some(pair) = self.pair(&at.text_document.uri, Wait::No).await? else { return Ok(None) };
        let view = pair.program.view();
        let sites = match (pair.asked, &pair.sidecar, pair.template()) {
            (Source::Program, _, template) => ide::references(&view, template, pair.program.offset(at.position), with_bindings),
            (Source::Template, Some(sidecar), Some(template)) => {
                ide::references_of_id(&view, template, sidecar.offset(at.position), with_bindings)
            }
            _ => Vec::new(),
        };
        Ok(Some(sites.into_iter().filter_map(|site| pair.location(site)).collect()))
    }

    pub(super) async fn show_highlights(&self, params: DocumentHighlightParams) -> Result<Option<Vec<DocumentHighlight>>> {
        let at = params.text_document_position_params;
        let Some(shot) = self.snapshot(&at.text_document.uri, Wait::No).await? else { return Ok(None) };
        let kind = |what| if what == Use::Write { DocumentHighlightKind::WRITE } else { DocumentHighlightKind::READ };
        let found = ide::highlights(&shot.view(), shot.offset(at.position)).into_iter();
        Ok(Some(found.map(|(range, what)| DocumentHighlight { range: shot.range(range), kind: Some(kind(what)) }).collect()))
    }

    pub(super) async fn ask_rename(&self, params: TextDocumentPositionParams) -> Result<Option<PrepareRenameResponse>> {
        let Some(pair) = self.pair(&params.text_document.uri, Wait::No).await? else { return Ok(None) };
        let at = place(&pair, params.position);
        let (range, placeholder) = ide::prepare(&pair.program.view(), pair.readable(), at).map_err(refused)?;
        let range = match (at, &pair.sidecar) {
            (ide::At::Template(_), Some(sidecar)) => sidecar.range(range),
            _ => pair.program.range(range),
        };
        Ok(Some(PrepareRenameResponse::RangeWithPlaceholder { range, placeholder }))
    }

    pub(super) async fn do_rename(&self, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
        let at = params.text_document_position;
        let Some(pair) = self.pair(&at.text_document.uri, Wait::No).await? else { return Ok(None) };
        let place = place(&pair, at.position);
        let rename = ide::rename(&pair.program.view(), pair.readable(), place, params.new_name.trim()).map_err(refused)?;
        let shot = &pair.program;
        let edits = |edits: Vec<Edit>, range: &dyn Fn(TextRange) -> Range| -> Vec<TextEdit> {
            edits.into_iter().map(|(place, text)| TextEdit::new(range(place), text)).collect()
        };
        let mut files = vec![(shot.uri.clone(), shot.version, edits(rename.program, &|place| shot.range(place)))];
        if let Some(sidecar) = &pair.sidecar {
            files.push((sidecar.uri.clone(), sidecar.version, edits(rename.template, &|place| sidecar.range(place))));
        }
        files.retain(|(_, _, edits)| !edits.is_empty());
        Ok(Some(shot.edit(files)))
    }

    pub(super) async fn show_outline(&self, params: DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>> {
        let Some(shot) = self.snapshot(&params.text_document.uri, Wait::Shortly).await? else { return Ok(None) };
        let symbols = ide::symbols(&shot.view()).into_iter().map(|symbol| outline(&shot, symbol)).collect();
        Ok(Some(DocumentSymbolResponse::Nested(symbols)))
    }

    pub(super) async fn find_symbols(&self, params: WorkspaceSymbolParams) -> Result<Option<WorkspaceSymbolResponse>> {
        let open = self.open_programs();
        let roots = self.shared.state().roots.clone();
        let known: Vec<Uri> = open.iter().map(|shot| shot.uri.clone()).collect();
        let encoding = self.shared.state().client.encoding;
        let query = params.query.to_lowercase();
        let mut found: Vec<WorkspaceSymbol> = Vec::new();
        for shot in &open {
            let symbols = ide::flat(&shot.view()).into_iter().filter(|(symbol, _)| is_inside(&query, &symbol.name));
            found.extend(symbols.map(|(symbol, inside)| workspace_symbol(&symbol, inside, shot.location(symbol.selection))));
        }
        // Reading files is no work for the thread that answers.
        let closed = tokio::task::spawn_blocking(move || closed_symbols(&roots, &known, &query, encoding));
        found.extend(closed.await.unwrap_or_default());
        found.truncate(MAX_SYMBOLS);
        Ok(Some(WorkspaceSymbolResponse::Nested(found)))
    }

    pub(super) async fn show_folds(&self, params: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
        let Some(shot) = self.snapshot(&params.text_document.uri, Wait::No).await? else { return Ok(None) };
        let kind = |kind| match kind {
            FoldKind::Comment => Some(FoldingRangeKind::Comment),
            FoldKind::Imports => Some(FoldingRangeKind::Imports),
            FoldKind::Code => None,
        };
        let folds = ide::folds(&shot.view()).into_iter();
        let range =
            |fold: ide::Fold| FoldingRange { start_line: fold.start, end_line: fold.end, kind: kind(fold.kind), ..FoldingRange::default() };
        Ok(Some(folds.map(range).collect()))
    }

    pub(super) async fn grow_selections(&self, params: SelectionRangeParams) -> Result<Option<Vec<SelectionRange>>> {
        let Some(shot) = self.snapshot(&params.text_document.uri, Wait::No).await? else { return Ok(None) };
        let grown = params.positions.iter().map(|position| {
            let steps = ide::selections(&shot.view(), shot.offset(*position));
            let outer = steps
                .into_iter()
                .rev()
                .fold(None, |parent, range| Some(SelectionRange { range: shot.range(range), parent: parent.map(Box::new) }));
            outer.unwrap_or(SelectionRange { range: Range::new(*position, *position), parent: None })
        });
        Ok(Some(grown.collect()))
    }

    pub(super) async fn ask_calls(&self, params: CallHierarchyPrepareParams) -> Result<Option<Vec<CallHierarchyItem>>> {
        let at = params.text_document_position_params;
        let Some(shot) = self.snapshot(&at.text_document.uri, Wait::Shortly).await? else { return Ok(None) };
        Ok(ide::function_at(&shot.view(), shot.offset(at.position)).map(|function| vec![called(&shot, function)]))
    }

    pub(super) async fn show_callers(&self, params: CallHierarchyIncomingCallsParams) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
        let Some(shot) = self.snapshot(&params.item.uri, Wait::Shortly).await? else { return Ok(None) };
        let calls = ide::incoming(&shot.view(), shot.bytes(params.item.selection_range)).into_iter();
        let call = |(from, places): (ide::Caller, Vec<TextRange>)| CallHierarchyIncomingCall {
            from: called(&shot, from),
            from_ranges: places.into_iter().map(|place| shot.range(place)).collect(),
        };
        Ok(Some(calls.map(call).collect()))
    }

    pub(super) async fn show_called(&self, params: CallHierarchyOutgoingCallsParams) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
        let Some(shot) = self.snapshot(&params.item.uri, Wait::Shortly).await? else { return Ok(None) };
        let calls = ide::outgoing(&shot.view(), shot.bytes(params.item.selection_range)).into_iter();
        let call = |(to, places): (ide::Caller, Vec<TextRange>)| CallHierarchyOutgoingCall {
            to: called(&shot, to),
            from_ranges: places.into_iter().map(|place| shot.range(place)).collect(),
        };
        Ok(Some(calls.map(call).collect()))
    }

    pub(super) async fn show_links(&self, params: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
        let Some(pair) = self.pair(&params.text_document.uri, Wait::No).await? else { return Ok(None) };
        let (Some(sidecar), Some(template)) = (&pair.sidecar, pair.template()) else { return Ok(None) };
        let view = pair.program.view();
        let line =
            |uri: &Uri, range: Range| format!("{}#L{},{}", uri.as_str(), range.start.line + 1, range.start.character + 1).parse().ok();
        let links = match pair.asked {
            Source::Program => ide::to_template(&view, template),
            Source::Template => ide::from_template(&view, template),
        };
        let link = |link: ide::Link| match pair.asked {
            Source::Program => (pair.program.range(link.range), line(&sidecar.uri, sidecar.range(link.target)), link.tooltip),
            Source::Template => (sidecar.range(link.range), line(&pair.program.uri, pair.program.range(link.target)), link.tooltip),
        };
        let links = links.into_iter().map(link);
        Ok(Some(links.map(|(range, target, tooltip)| DocumentLink { range, target, tooltip: Some(tooltip), data: None }).collect()))
    }

    pub(super) async fn show_colors(&self, params: DocumentColorParams) -> Result<Vec<ColorInformation>> {
        let Some(pair) = self.pair(&params.text_document.uri, Wait::No).await? else { return Ok(Vec::new()) };
        let part = |value: u8| f32::from(value) / 255.0;
        let color = |color: ide::Color, range: Range| {
            let [red, green, blue] = color.rgb.map(part);
            ColorInformation { range, color: Color { red, green, blue, alpha: 1.0 } }
        };
        Ok(match (pair.asked, &pair.sidecar) {
            (Source::Template, Some(sidecar)) => {
                ide::template_colors(&sidecar.text).into_iter().map(|found| color(found, sidecar.range(found.range))).collect()
            }
            _ => ide::colors(&pair.program.view()).into_iter().map(|found| color(found, pair.program.range(found.range))).collect(),
        })
    }

    pub(super) async fn write_color(&self, params: ColorPresentationParams) -> Result<Vec<ColorPresentation>> {
        let part = |value: f32| (value.clamp(0.0, 1.0) * 255.0).round() as u8;
        let label = ide::presentation([params.color.red, params.color.green, params.color.blue].map(part));
        let text_edit = Some(TextEdit::new(params.range, label.clone()));
        Ok(vec![ColorPresentation { label, text_edit, additional_text_edits: None }])
    }
}

fn refused(refusal: Refusal) -> tower_lsp_server::jsonrpc::Error {
    failed(&refusal.0)
}

/// What is renamed.
fn place(pair: &Pair, position: tower_lsp_server::ls_types::Position) -> ide::At {
    match (pair.asked, &pair.sidecar) {
        (Source::Template, Some(sidecar)) => ide::At::Template(sidecar.offset(position)),
        _ => ide::At::Program(pair.program.offset(position)),
    }
}

fn symbol_kind(kind: Kind) -> SymbolKind {
    match kind {
        Kind::Category => SymbolKind::NAMESPACE,
        Kind::Object => SymbolKind::OBJECT,
        Kind::Opening => SymbolKind::INTERFACE,
        Kind::Function => SymbolKind::FUNCTION,
        Kind::Class => SymbolKind::CLASS,
        Kind::Variable => SymbolKind::VARIABLE,
    }
}

#[allow(deprecated, reason = "the type has a field that is")]
fn outline(shot: &Snapshot, symbol: ide::Symbol) -> DocumentSymbol {
    let children: Vec<DocumentSymbol> = symbol.children.into_iter().map(|child| outline(shot, child)).collect();
    DocumentSymbol {
        name: symbol.name,
        detail: Some(symbol.detail).filter(|detail| !detail.is_empty()),
        kind: symbol_kind(symbol.kind),
        tags: None,
        deprecated: None,
        range: shot.range(symbol.range),
        selection_range: shot.range(symbol.selection),
        children: (!children.is_empty()).then_some(children),
    }
}

fn workspace_symbol(symbol: &ide::Symbol, inside: String, location: Location) -> WorkspaceSymbol {
    WorkspaceSymbol {
        name: symbol.name.clone(),
        kind: symbol_kind(symbol.kind),
        tags: None,
        container_name: Some(inside).filter(|inside| !inside.is_empty()),
        location: OneOf::Left(location),
        data: None,
    }
}

/// Whether the letters of a query occur in a name in this order.
fn is_inside(query: &str, name: &str) -> bool {
    let mut letters = name.chars().flat_map(char::to_lowercase);
    query.chars().all(|letter| letters.any(|other| other == letter))
}

/// The names in programs that are not open: what can be told from their text.
fn closed_symbols(roots: &[std::path::PathBuf], open: &[Uri], query: &str, encoding: crate::syntax::Encoding) -> Vec<WorkspaceSymbol> {
    let files = roots.iter().flat_map(|root| ignore::WalkBuilder::new(root).build()).filter_map(std::result::Result::ok);
    let programs = files.filter(|file| role(Some(file.path()), "") == Role::Program).take(MAX_FILES);
    let mut found = Vec::new();
    for file in programs {
        let Some(uri) = Uri::from_file_path(file.path()).filter(|uri| !open.contains(uri)) else { continue };
        let Some(text) = read(file.path()) else { continue };
        let program = Arc::new(Program::read(text.into()));
        let lines = LineIndex::new(&program.text);
        let place = |range: TextRange| {
            let position = |offset| {
                let at = lines.line_column(offset, &program.text, encoding);
                tower_lsp_server::ls_types::Position::new(at.line, at.column)
            };
            Location { uri: uri.clone(), range: Range::new(position(range.start()), position(range.end())) }
        };
        let symbols = ide::flat(&View::new(&program, None)).into_iter().filter(|(symbol, _)| is_inside(query, &symbol.name));
        found.extend(symbols.map(|(symbol, inside)| workspace_symbol(&symbol, inside, place(symbol.selection))));
        if found.len() > MAX_SYMBOLS {
            break;
        }
    }
    found
}

fn called(shot: &Snapshot, function: ide::Caller) -> CallHierarchyItem {
    CallHierarchyItem {
        name: function.name,
        kind: SymbolKind::FUNCTION,
        tags: None,
        detail: Some(function.detail).filter(|detail| !detail.is_empty()),
        uri: shot.uri.clone(),
        range: shot.range(function.range),
        selection_range: shot.range(function.selection),
        data: None,
    }
}
