//! What the client can do, and what is offered to it in return.

use super::actions::action_kinds;
use super::requests::COMMANDS;
use crate::syntax::Encoding;
use tower_lsp_server::ls_types::{
    CallHierarchyServerCapability, CodeLensOptions, ColorProviderCapability, CompletionOptions, DocumentLinkOptions,
    FoldingRangeProviderCapability, MarkupKind, RenameOptions, SelectionRangeProviderCapability, SemanticTokensFullOptions,
    SemanticTokensOptions, SignatureHelpOptions, WorkDoneProgressOptions,
};
use tower_lsp_server::ls_types::{
    CodeActionOptions, CodeActionProviderCapability, DiagnosticOptions, DiagnosticServerCapabilities, DiagnosticTag,
    HoverProviderCapability, InitializeParams, OneOf, PositionEncodingKind, SaveOptions, ServerCapabilities, TextDocumentSyncCapability,
    TextDocumentSyncKind, TextDocumentSyncOptions, TextDocumentSyncSaveOptions, WorkspaceFoldersServerCapabilities,
    WorkspaceServerCapabilities,
};
use tower_lsp_server::ls_types::{ExecuteCommandOptions, ResourceOperationKind};

/// What the client can do.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Client {
    /// In what columns are counted.
    pub encoding: Encoding,
    /// It asks for diagnostics; then none are sent to it unasked.
    pub pulls: bool,
    /// It can be told to ask again.
    pub refreshes: bool,
    /// It takes the diagnostics of other documents with those that it asked for.
    pub related_documents: bool,
    /// It shows second places.
    pub related_information: bool,
    /// It greys out what is not needed.
    pub unnecessary: bool,
    /// It shows the page of a code.
    pub code_description: bool,
    /// It takes edits with the version that they are for.
    pub document_changes: bool,
    /// It asks for the edit of an action when that is chosen.
    pub resolves_edits: bool,
    /// It lets the user look at edits before they are made.
    pub annotates: bool,
    /// It writes and deletes files.
    pub makes_files: bool,
    /// It shows the progress of work that the server began.
    pub progress: bool,
    /// It takes snippets, with places to fill in.
    pub snippets: bool,
    /// It shows Markdown at a hover.
    pub hover_markdown: bool,
    /// It names its reader of Markdown, as those do that show pictures.
    pub hover_pictures: bool,
    /// It watches files when it is asked to.
    pub watches: bool,
    /// It is asked for the user's settings.
    pub has_settings: bool,
    /// It tells when they change if it is asked to.
    pub watches_settings: bool,
    /// It can be told to ask for inlay hints again.
    pub refreshes_hints: bool,
    /// The same for code lenses.
    pub refreshes_lenses: bool,
    /// The same for semantic tokens.
    pub refreshes_tokens: bool,
}

impl Default for Client {
    fn default() -> Client {
        Client {
            encoding: Encoding::Utf16,
            pulls: false,
            refreshes: false,
            related_documents: false,
            related_information: false,
            unnecessary: false,
            code_description: false,
            document_changes: false,
            resolves_edits: false,
            annotates: false,
            makes_files: false,
            progress: false,
            snippets: false,
            hover_markdown: false,
            hover_pictures: false,
            watches: false,
            has_settings: false,
            watches_settings: false,
            refreshes_hints: false,
            refreshes_lenses: false,
            refreshes_tokens: false,
        }
    }
}

impl Client {
    pub(super) fn new(params: &InitializeParams) -> Client {
        let document = params.capabilities.text_document.as_ref();
        let workspace = params.capabilities.workspace.as_ref();
        let publish = document.and_then(|document| document.publish_diagnostics.as_ref());
        let pull = document.and_then(|document| document.diagnostic.as_ref());
        let action = document.and_then(|document| document.code_action.as_ref());
        let tags = publish.and_then(|publish| publish.tag_support.as_ref());
        let offered = params.capabilities.general.as_ref().and_then(|general| general.position_encodings.as_ref());
        Client {
            encoding: offered.and_then(|offered| offered.iter().find_map(encoding)).unwrap_or(Encoding::Utf16),
            pulls: pull.is_some(),
            refreshes: workspace.and_then(|workspace| workspace.diagnostics.as_ref()?.refresh_support).unwrap_or(false),
            related_documents: pull.and_then(|pull| pull.related_document_support).unwrap_or(false),
            related_information: publish.and_then(|publish| publish.related_information).unwrap_or(false),
            unnecessary: tags.is_some_and(|tags| tags.value_set.contains(&DiagnosticTag::UNNECESSARY)),
            code_description: publish.and_then(|publish| publish.code_description_support).unwrap_or(false),
            document_changes: workspace.and_then(|workspace| workspace.workspace_edit.as_ref()?.document_changes).unwrap_or(false),
            resolves_edits: action.is_some_and(|action| {
                let resolves = action.resolve_support.as_ref().is_some_and(|resolve| resolve.properties.iter().any(|name| name == "edit"));
                resolves && action.data_support == Some(true)
            }),
            annotates: workspace.and_then(|workspace| workspace.workspace_edit.as_ref()?.change_annotation_support.as_ref()).is_some(),
            makes_files: workspace.and_then(|workspace| workspace.workspace_edit.as_ref()?.resource_operations.as_ref()).is_some_and(
                |kinds| [ResourceOperationKind::Create, ResourceOperationKind::Delete].iter().all(|kind| kinds.contains(kind)),
            ),
            progress: params.capabilities.window.as_ref().and_then(|window| window.work_done_progress).unwrap_or(false),
            snippets: document
                .and_then(|document| document.completion.as_ref()?.completion_item.as_ref()?.snippet_support)
                .unwrap_or(false),
            hover_markdown: document
                .and_then(|document| document.hover.as_ref()?.content_format.as_ref())
                .is_some_and(|formats| formats.contains(&MarkupKind::Markdown)),
            hover_pictures: params.capabilities.general.as_ref().is_some_and(|general| general.markdown.is_some()),
            watches: workspace.and_then(|workspace| workspace.did_change_watched_files.as_ref()?.dynamic_registration).unwrap_or(false),
            has_settings: workspace.and_then(|workspace| workspace.configuration).unwrap_or(false),
            watches_settings: workspace
                .and_then(|workspace| workspace.did_change_configuration.as_ref()?.dynamic_registration)
                .unwrap_or(false),
            refreshes_hints: workspace.and_then(|workspace| workspace.inlay_hint.as_ref()?.refresh_support).unwrap_or(false),
            refreshes_lenses: workspace.and_then(|workspace| workspace.code_lens.as_ref()?.refresh_support).unwrap_or(false),
            refreshes_tokens: workspace.and_then(|workspace| workspace.semantic_tokens.as_ref()?.refresh_support).unwrap_or(false),
        }
    }

    /// What is offered to it.
    pub(super) fn offer(&self) -> ServerCapabilities {
        let diagnostics = DiagnosticOptions {
            identifier: Some("psdl".into()),
            inter_file_dependencies: true,
            workspace_diagnostics: self.pulls,
            ..DiagnosticOptions::default()
        };
        let actions =
            CodeActionOptions { code_action_kinds: Some(action_kinds()), resolve_provider: Some(true), ..CodeActionOptions::default() };
        let commands = ExecuteCommandOptions { commands: COMMANDS.map(String::from).to_vec(), ..ExecuteCommandOptions::default() };
        ServerCapabilities {
            position_encoding: Some(match self.encoding {
                Encoding::Utf8 => PositionEncodingKind::UTF8,
                Encoding::Utf16 => PositionEncodingKind::UTF16,
                Encoding::Utf32 => PositionEncodingKind::UTF32,
            }),
            text_document_sync: Some(TextDocumentSyncCapability::Options(TextDocumentSyncOptions {
                open_close: Some(true),
                change: Some(TextDocumentSyncKind::INCREMENTAL),
                save: Some(TextDocumentSyncSaveOptions::SaveOptions(SaveOptions { include_text: Some(false) })),
                ..TextDocumentSyncOptions::default()
            })),
            diagnostic_provider: self.pulls.then_some(DiagnosticServerCapabilities::Options(diagnostics)),
            code_action_provider: Some(CodeActionProviderCapability::Options(actions)),
            execute_command_provider: Some(commands),
            experimental: Some(serde_json::json!({ "psdl": { "version": 1 } })),
            workspace: Some(WorkspaceServerCapabilities {
                workspace_folders: Some(WorkspaceFoldersServerCapabilities {
                    supported: Some(true),
                    change_notifications: Some(OneOf::Left(true)),
                }),
                ..WorkspaceServerCapabilities::default()
            }),
            ..reading_and_writing()
        }
    }
}

/// What is offered to every client.
fn reading_and_writing() -> ServerCapabilities {
    let words = |words: &[&str]| Some(words.iter().map(ToString::to_string).collect());
    let completion = CompletionOptions { resolve_provider: Some(true), trigger_characters: words(&["."]), ..CompletionOptions::default() };
    let signature = SignatureHelpOptions {
        trigger_characters: words(&["(", ","]),
        retrigger_characters: words(&["="]),
        ..SignatureHelpOptions::default()
    };
    let tokens = SemanticTokensOptions {
        legend: super::reading::legend(),
        range: Some(true),
        full: Some(SemanticTokensFullOptions::Delta { delta: Some(true) }),
        ..SemanticTokensOptions::default()
    };
    ServerCapabilities {
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        inlay_hint_provider: Some(OneOf::Left(true)),
        code_lens_provider: Some(CodeLensOptions { resolve_provider: Some(false) }),
        semantic_tokens_provider: Some(tokens.into()),
        definition_provider: Some(OneOf::Left(true)),
        references_provider: Some(OneOf::Left(true)),
        document_highlight_provider: Some(OneOf::Left(true)),
        rename_provider: Some(OneOf::Right(RenameOptions {
            prepare_provider: Some(true),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        })),
        document_symbol_provider: Some(OneOf::Left(true)),
        workspace_symbol_provider: Some(OneOf::Left(true)),
        folding_range_provider: Some(FoldingRangeProviderCapability::Simple(true)),
        selection_range_provider: Some(SelectionRangeProviderCapability::Simple(true)),
        call_hierarchy_provider: Some(CallHierarchyServerCapability::Simple(true)),
        document_link_provider: Some(DocumentLinkOptions {
            resolve_provider: Some(false),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        }),
        color_provider: Some(ColorProviderCapability::Simple(true)),
        completion_provider: Some(completion),
        signature_help_provider: Some(signature),
        ..ServerCapabilities::default()
    }
}

fn encoding(kind: &PositionEncodingKind) -> Option<Encoding> {
    match kind.as_str() {
        "utf-8" => Some(Encoding::Utf8),
        "utf-16" => Some(Encoding::Utf16),
        "utf-32" => Some(Encoding::Utf32),
        _ => None,
    }
}
