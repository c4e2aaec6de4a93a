//! `workspace/diagnostic`: what there is to say about all programs of the workspace, a piece at a time.

use super::diagnostics::Report;
use super::document::template_of;
use super::handlers::Backend;
use super::run::{self, Job};
use crate::config::Resolver;
use ignore::WalkBuilder;
use rustc_hash::FxHashMap;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::SystemTime;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::{
    FullDocumentDiagnosticReport, UnchangedDocumentDiagnosticReport, Uri, WorkspaceDiagnosticParams, WorkspaceDiagnosticReport,
    WorkspaceDiagnosticReportResult, WorkspaceDocumentDiagnosticReport, WorkspaceFullDocumentDiagnosticReport,
    WorkspaceUnchangedDocumentDiagnosticReport,
};

/// So many programs are looked at before what was found is sent.
const PIECE: usize = 16;
/// So many programs are remembered.
const REMEMBERED: usize = 20_000;

/// How a file was when it was looked at: when it was written, and its size.
type Stamp = Option<(SystemTime, u64)>;

/// What was said about a file, and about what.
struct Said {
    stamps: [Stamp; 2],
    resolver: Arc<Resolver<'static>>,
    reports: Vec<(Uri, String)>,
}

/// What was said about files that are not open: the ids of the reports, so that files which stayed as they are need no other look.
#[derive(Default)]
pub(super) struct LookedAt(Mutex<FxHashMap<PathBuf, Said>>);

/// What the client knows, by document.
type Known = FxHashMap<Uri, String>;

impl Backend {
    /// `workspace/diagnostic`
    pub(super) async fn whole_workspace(&self, params: WorkspaceDiagnosticParams) -> Result<WorkspaceDiagnosticReportResult> {
        let known: Known = params.previous_result_ids.into_iter().map(|known| (known.uri, known.value)).collect();
        let known = Arc::new(known);
        let token = params.partial_result_params.partial_result_token;
        let (roots, settings, resolver) = {
            let state = self.shared.state();
            (state.roots.clone(), state.settings, state.resolver.clone())
        };
        let mut all = Vec::new();
        if settings.workspace_diagnostics == Some(false) {
            return Ok(WorkspaceDiagnosticReport { items: all }.into());
        }
        let programs = self.thought(Arc::default(), move |_| programs(&roots, &resolver)).await?;
        for piece in programs.chunks(PIECE) {
            let mut items = Vec::new();
            let mut closed = Vec::new();
            for path in piece {
                match self.open_as(path) {
                    Some(uri) => items.extend(self.about_open(&uri, &known).await),
                    None => closed.push(path.clone()),
                }
            }
            let (shared, known) = (self.shared.clone(), known.clone());
            let found = self.thought(Arc::default(), move |_| {
                let look = |path: PathBuf| {
                    let job = shared.state().job_of_file(path.clone());
                    shared.looked_at.about(&path, &job, &known)
                };
                closed.into_iter().flat_map(look).collect::<Vec<_>>()
            });
            items.extend(found.await?);
            match &token {
                Some(token) if !items.is_empty() => {
                    self.shared.output.notify("$/progress", json!({ "token": token, "value": { "items": items } }));
                }
                _ => all.extend(items),
            }
        }
        Ok(WorkspaceDiagnosticReport { items: all }.into())
    }

    /// The document of a program, if it is open.
    fn open_as(&self, path: &Path) -> Option<Uri> {
        let state = self.shared.state();
        state.documents.values().find(|document| document.path.as_deref() == Some(path)).map(|document| document.uri.clone())
    }

    async fn about_open(&self, uri: &Uri, known: &Known) -> Vec<WorkspaceDocumentDiagnosticReport> {
        let Some((latest, _)) = self.shared.latest(uri) else { return Vec::new() };
        let Ok(outcome) = latest.wait().await else { return Vec::new() };
        [&outcome.main].into_iter().chain(&outcome.template).filter_map(|report| item(report, known)).collect()
    }
}

impl LookedAt {
    /// What there is to say about a file; nothing new where neither it nor its template nor the configuration changed.
    fn about(&self, path: &Path, job: &Job, known: &Known) -> Vec<WorkspaceDocumentDiagnosticReport> {
        let stamps = [stamp(path), stamp(&template_of(path))];
        let lock = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if job.template.is_none()
            && let Some(said) = lock().get(path)
            && said.stamps == stamps
            && Arc::ptr_eq(&said.resolver, &job.resolver)
            && said.reports.iter().all(|(uri, id)| known.get(uri) == Some(id))
        {
            return said.reports.iter().map(|(uri, id)| unchanged(uri.clone(), None, id.clone())).collect();
        }
        let Some(outcome) = run::run(job) else { return Vec::new() };
        let reports = || [&outcome.main].into_iter().chain(&outcome.template);
        let ids = reports().filter_map(|report| Some((report.text.uri.clone()?, report.id.clone()))).collect();
        let mut remembered = lock();
        if remembered.len() >= REMEMBERED {
            remembered.clear();
        }
        remembered.insert(path.to_path_buf(), Said { stamps, resolver: job.resolver.clone(), reports: ids });
        drop(remembered);
        reports().filter_map(|report| item(report, known)).collect()
    }
}

fn item(report: &Report, known: &Known) -> Option<WorkspaceDocumentDiagnosticReport> {
    let uri = report.text.uri.clone()?;
    let version = report.text.version.map(i64::from);
    if known.get(&uri) == Some(&report.id) {
        return Some(unchanged(uri, version, report.id.clone()));
    }
    let full = FullDocumentDiagnosticReport { result_id: Some(report.id.clone()), items: report.diagnostics() };
    Some(WorkspaceFullDocumentDiagnosticReport { uri, version, full_document_diagnostic_report: full }.into())
}

fn unchanged(uri: Uri, version: Option<i64>, result_id: String) -> WorkspaceDocumentDiagnosticReport {
    let unchanged_document_diagnostic_report = UnchangedDocumentDiagnosticReport { result_id };
    WorkspaceUnchangedDocumentDiagnosticReport { uri, version, unchanged_document_diagnostic_report }.into()
}

/// The programs of some folders, in a stable order, without those that the configuration leaves out.
fn programs(roots: &[PathBuf], resolver: &Resolver) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for root in roots {
        let walk = WalkBuilder::new(root).sort_by_file_name(std::ffi::OsStr::cmp).build();
        let files = walk.flatten().filter(|entry| entry.file_type().is_some_and(|kind| kind.is_file()));
        let paths = files.map(ignore::DirEntry::into_path).filter(|path| path.extension().is_some_and(|end| end == "psdl"));
        found.extend(paths.filter(|path| !resolver.resolve(path).is_ok_and(|resolved| resolved.excluded)));
    }
    found.sort();
    found.dedup();
    found
}

fn stamp(path: &Path) -> Stamp {
    let metadata = std::fs::metadata(path).ok()?;
    Some((metadata.modified().ok()?, metadata.len()))
}
