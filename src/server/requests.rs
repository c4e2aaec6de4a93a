//! psdl's own requests and commands: `psdl/fix`, `psdl.server.fixAll` and their like.

use super::actions::{annotated_edit, kinds_named, workspace_edit};
use super::handlers::{Backend, failed};
use super::progress::Task;
use super::run::{Outcome, Text};
use crate::ide::Search;
use crate::repair::{Fix, Method, Problem, Settings, edit_titles};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::{ExecuteCommandParams, LSPAny, ProgressToken, Range, TextDocumentIdentifier, Uri, WorkspaceEdit};

/// The commands that are offered.
pub(super) const COMMANDS: [&str; 2] = ["psdl.server.fixAll", "psdl.server.fixRange"];

/// `psdl/fix`
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct FixParams {
    text_document: TextDocumentIdentifier,
    #[serde(default)]
    range: Option<Range>,
    #[serde(default)]
    kinds: Vec<String>,
    #[serde(default)]
    method: MethodName,
    #[serde(default)]
    max_edits: Option<usize>,
    #[serde(default)]
    work_done_token: Option<ProgressToken>,
}

/// How to look for a correction.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum MethodName {
    #[default]
    Guided,
    Paper,
}

/// One edit of a correction.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct OneEdit {
    range: Range,
    new_text: String,
    title: String,
}

/// Errors and their weighted loss.
#[derive(Debug, Serialize)]
struct Errors {
    errors: usize,
    loss: u64,
}

/// The answer to `psdl/fix`.
#[derive(Debug, Serialize)]
pub(super) struct FixResult {
    version: Option<i32>,
    edit: WorkspaceEdit,
    edits: Vec<OneEdit>,
    before: Errors,
    after: Errors,
    moved: usize,
    transport: f64,
    evaluations: usize,
}

/// A correction, and the text that it is for.
struct Found {
    outcome: Arc<Outcome>,
    fix: Arc<Fix>,
    problem: Arc<Problem>,
}

impl Backend {
    /// `psdl/fix`
    pub(super) async fn fix(&self, params: FixParams) -> Result<FixResult> {
        let method = if matches!(params.method, MethodName::Paper) { Method::Paper } else { Method::Guided };
        let default = Settings::default();
        let settings = Settings { method, max_edits: params.max_edits.unwrap_or(default.max_edits), ..default };
        let uri = params.text_document.uri;
        let Found { outcome, fix, problem } = self.searched(&uri, params.range, &params.kinds, settings, params.work_done_token).await?;
        let (text, client) = (&outcome.main.text, self.shared.state().client);
        let titles = edit_titles(&problem, &fix);
        let edit = |((range, new), title): (&crate::syntax::Edit, String)| {
            let range = text.range(*range, client);
            OneEdit { range, new_text: new.clone(), title }
        };
        Ok(FixResult {
            version: text.version,
            edit: workspace_edit(text, &fix.edits, client),
            edits: fix.edits.iter().zip(titles).map(edit).collect(),
            before: Errors { errors: fix.errors_before(), loss: fix.before.loss() },
            after: Errors { errors: fix.errors_after(), loss: fix.after.loss() },
            moved: fix.moved,
            transport: fix.transport,
            evaluations: fix.effort.evaluations,
        })
    }

    /// Searches for corrections of a document.
    async fn searched(
        &self,
        uri: &Uri,
        range: Option<Range>,
        kinds: &[String],
        settings: Settings,
        token: Option<ProgressToken>,
    ) -> Result<Found> {
        let kinds = kinds_named(kinds).ok_or_else(|| Error::invalid_params("there is no such kind of error"))?;
        let (outcome, client) = self.outcome_of(uri).await?;
        let within = range.map(|range| outcome.main.text.bytes(range, client));
        let search = Search { title: String::new(), kinds, within };
        let study = self.shared.study(&outcome);
        let watch = self.shared.watch(uri);
        let task = Task { token, title: "Fixing layout errors", budget: settings.budget, watch: watch.clone() };
        let shared = watch.clone();
        let work = self.thought(watch, move |watch| {
            let problem = study.with_lab(watch, |lab| lab.problem.clone())?;
            let plain = settings.method == Method::Guided && settings.max_edits == Settings::default().max_edits;
            let fix = if plain { study.fix(&search, &shared)? } else { Arc::new(study.fix_with(&search, settings, &shared)?) };
            Some((fix, problem))
        });
        let found = self.followed(task, work).await?;
        let (fix, problem) = found.ok_or_else(|| failed("the program cannot be run as it is"))?;
        Ok(Found { outcome, fix, problem })
    }

    /// `workspace/executeCommand`
    pub(super) async fn execute(&self, params: ExecuteCommandParams) -> Result<Option<LSPAny>> {
        let argument = |at: usize| params.arguments.get(at).cloned().unwrap_or_default();
        let wrong = |_| Error::invalid_params("the arguments are a URI and a range");
        let uri: Uri = serde_json::from_value(argument(0)).map_err(wrong)?;
        let (range, kinds): (Option<Range>, Option<Vec<String>>) = match params.command.as_str() {
            "psdl.server.fixAll" => (None, None),
            "psdl.server.fixRange" => {
                (serde_json::from_value(argument(1)).map_err(wrong)?, serde_json::from_value(argument(2)).map_err(wrong)?)
            }
            _ => return Err(Error::invalid_params("there is no such command")),
        };
        let token = params.work_done_progress_params.work_done_token;
        let found = self.searched(&uri, range, &kinds.unwrap_or_default(), Settings::default(), token).await?;
        let (fix, text, client) = (&found.fix, &found.outcome.main.text, self.shared.state().client);
        if fix.edits.is_empty() {
            return Err(failed("nothing was found that leaves fewer errors"));
        }
        let edit = annotated_edit(text, &fix.edits, "Fix layout errors", fix.moved, client);
        let applied = self.client.apply_edit(edit).await?;
        Ok(serde_json::to_value(applied).ok())
    }

    /// What there is to say about a program: of an open document as it is now, else of the file.
    pub(super) async fn seen(&self, uri: &Uri) -> Result<(Arc<Outcome>, super::client::Client)> {
        let Some((latest, client)) = self.latest(uri)? else { return Err(Error::invalid_params("the document is no program")) };
        let outcome = latest.wait().await?;
        let same = |text: &Text| text.uri.as_ref() == Some(uri);
        if same(&outcome.main.text) { Ok((outcome, client)) } else { Err(Error::invalid_params("the document is no program")) }
    }
}
