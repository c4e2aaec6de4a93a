//! Whether the parameters of a notification can be read: there is nobody to send an error to, so it goes to the log.

use serde::de::DeserializeOwned;
use serde_json::Value;
use tower_lsp_server::ls_types::{
    CancelParams, DidChangeConfigurationParams, DidChangeTextDocumentParams, DidChangeWatchedFilesParams, DidChangeWorkspaceFoldersParams,
    DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams, SetTraceParams,
};

/// Whether a notification takes these parameters; of methods that are not known here it is not decided here.
pub(super) fn fit(method: &str, params: Option<&Value>) -> bool {
    match method {
        "textDocument/didOpen" => reads::<DidOpenTextDocumentParams>(params),
        "textDocument/didChange" => reads::<DidChangeTextDocumentParams>(params),
        "textDocument/didClose" => reads::<DidCloseTextDocumentParams>(params),
        "textDocument/didSave" => reads::<DidSaveTextDocumentParams>(params),
        "workspace/didChangeConfiguration" => reads::<DidChangeConfigurationParams>(params),
        "workspace/didChangeWatchedFiles" => reads::<DidChangeWatchedFilesParams>(params),
        "workspace/didChangeWorkspaceFolders" => reads::<DidChangeWorkspaceFoldersParams>(params),
        "$/cancelRequest" => reads::<CancelParams>(params),
        "$/setTrace" => reads::<SetTraceParams>(params),
        _ => true,
    }
}

fn reads<T: DeserializeOwned>(params: Option<&Value>) -> bool {
    params.is_some_and(|params| T::deserialize(params).is_ok())
}
