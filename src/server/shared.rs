//! The state behind its lock, and the workers that take jobs from it.
//!
//! A unit is with one worker at a time, so that a program that uses up its whole budget leaves the other workers to the
//! other files; an edit cancels the run, and the newest text is the next to be looked at.

use super::client::Client;
use super::diagnostics::Report;
use super::output::Output;
use super::run::{self, Job, Outcome};
use super::state::{Key, State};
use super::study::Studies;
use super::think::Desk;
use super::workspace::LookedAt;
use crate::repair::Watch;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::oneshot;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::{LogTraceParams, TraceValue, Uri};

/// Deep recursion is for the program's limits to end, not for the system.
const STACK: usize = 64 << 20;
/// Nothing is run for a client that leaves more than this unread.
const MAX_BACKLOG: usize = 32 << 20;

/// What handlers and workers share.
pub(super) struct Shared {
    state: Mutex<State>,
    work: Condvar,
    /// Work for requests.
    pub desk: Desk,
    /// What is known about some texts.
    pub studies: Studies,
    /// What was said about programs that are not open.
    pub looked_at: LookedAt,
    pub output: Output,
}

/// An outcome that is there, or that will be.
#[derive(Debug)]
pub(super) enum Latest {
    Now(Arc<Outcome>),
    Later(oneshot::Receiver<Option<Arc<Outcome>>>),
}

impl std::fmt::Debug for Shared {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Shared").finish_non_exhaustive()
    }
}

impl Shared {
    pub(super) fn new(output: Output) -> Shared {
        Shared {
            state: Mutex::default(),
            work: Condvar::new(),
            desk: Desk::default(),
            studies: Studies::default(),
            looked_at: LookedAt::default(),
            output,
        }
    }

    /// The state. A panic under the lock leaves it as it is: each change of it is complete by itself.
    pub(super) fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Wakes the workers; after each change of the queue.
    pub(super) fn wake(&self) {
        self.work.notify_all();
    }

    /// Starts the workers: at least two, so that one slow program leaves one for the others.
    pub(super) fn start(self: &Arc<Shared>) -> std::io::Result<()> {
        let count = std::thread::available_parallelism().map_or(2, std::num::NonZero::get).clamp(2, 4);
        for index in 0..count {
            let shared = self.clone();
            let work = move || {
                loop {
                    shared.work_once(run::run);
                }
            };
            std::thread::Builder::new().name(format!("worker {index}")).stack_size(STACK).spawn(work)?;
        }
        self.start_thinking(STACK)
    }

    /// Waits for a job and does it.
    fn work_once(&self, run: impl FnOnce(&Job) -> Option<Outcome>) {
        let (key, wanted, job) = self.next();
        let start = Instant::now();
        let result = catch_unwind(AssertUnwindSafe(|| run(&job)));
        let took = start.elapsed();
        let mut state = self.state();
        let (current, more) = state.done(&key, wanted, &job.cancel);
        match result {
            Ok(Some(outcome)) if current => {
                self.tell(&state, &outcome, took);
                self.finish(&mut state, &key, wanted, outcome);
            }
            Ok(_) => tracing::trace!("a run ended after {took:?}: something newer is wanted"),
            Err(_) => {
                tracing::error!("a run panicked after {took:?}");
                // Whoever waits learns that nothing will come.
                for waiting in state.units.get_mut(&key).into_iter().flat_map(|unit| unit.waiting.drain(..)) {
                    let _ = waiting.send(None);
                }
            }
        }
        drop(state);
        if more {
            self.wake();
        }
    }

    fn next(&self) -> (Key, u64, Job) {
        let mut state = self.state();
        loop {
            if self.output.backlog() > MAX_BACKLOG {
                let wait = self.work.wait_timeout(state, Duration::from_millis(20));
                state = wait.unwrap_or_else(PoisonError::into_inner).0;
                continue;
            }
            if let Some(next) = state.next() {
                return next;
            }
            state = self.work.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Says in the log, and to a client that traces, that a run has ended.
    fn tell(&self, state: &State, outcome: &Outcome, took: Duration) {
        let Report { text, items, .. } = &outcome.main;
        let name = text.uri.as_ref().map_or("", |uri| uri.as_str());
        let count = items.len();
        tracing::debug!("{name}: version {:?}, {count} findings, {took:?}", text.version);
        if state.trace != TraceValue::Off {
            let verbose = (state.trace == TraceValue::Verbose).then(|| format!("{} bytes, {took:?}", text.text.len()));
            self.output.notify("$/logTrace", LogTraceParams { message: format!("{name}: {count} findings"), verbose });
        }
    }

    /// Keeps what came of a run, publishes it to a client that does not ask, and answers those who wait.
    fn finish(&self, state: &mut State, key: &Key, wanted: u64, mut outcome: Outcome) {
        let fresh = outcome.fresh.take();
        let outcome = Arc::new(outcome);
        let Some(unit) = state.units.get_mut(key) else { return };
        if let Some(fresh) = fresh {
            unit.kept = fresh.kept;
            unit.scene = Some(fresh.scene);
        }
        unit.latest = Some((wanted, outcome.clone()));
        for waiting in unit.waiting.drain(..) {
            // Who has gone needs no answer.
            let _ = waiting.send(Some(outcome.clone()));
        }
        if !state.client.pulls {
            self.publish(state, &outcome);
        }
    }

    fn publish(&self, state: &mut State, outcome: &Outcome) {
        if outcome.main.text.version.is_some() {
            self.send(&outcome.main);
        }
        outcome.template.iter().for_each(|report| self.publish_beside(state, report));
        if let Some(report) = &outcome.config {
            self.publish_beside(state, report);
        }
        // A configuration that could be read has no errors any more.
        for file in &outcome.config_files {
            if let Some(uri) = Uri::from_file_path(file) {
                self.clear_beside(state, &uri);
            }
        }
    }

    /// Publishes what is said about a file beside the program, if it is news.
    fn publish_beside(&self, state: &mut State, report: &Report) {
        let Some(uri) = &report.text.uri else { return };
        let news = (report.text.version, report.id.clone());
        match state.published.get(uri) {
            None if report.items.is_empty() => return,
            Some(known) if *known == news => return,
            _ => {}
        }
        if report.items.is_empty() {
            state.published.remove(uri);
        } else {
            state.published.insert(uri.clone(), news);
        }
        self.send(report);
    }

    /// Takes back what was said about a file beside the program.
    pub(super) fn clear_beside(&self, state: &mut State, uri: &Uri) {
        if state.published.remove(uri).is_some() {
            self.clear(uri);
        }
    }

    /// Takes back what was said about a document.
    pub(super) fn clear(&self, uri: &Uri) {
        self.output.notify("textDocument/publishDiagnostics", serde_json::json!({ "uri": uri, "diagnostics": [] }));
    }

    fn send(&self, report: &Report) {
        let Some(uri) = &report.text.uri else { return };
        let version = report.text.version.map_or_else(String::new, |version| format!("\"version\":{version},"));
        // What a URI consists of needs no escape in JSON.
        let params = format!("{{\"uri\":\"{}\",{version}\"diagnostics\":{}}}", uri.as_str(), report.json);
        let message = format!("{{\"jsonrpc\":\"2.0\",\"method\":\"textDocument/publishDiagnostics\",\"params\":{params}}}");
        self.output.send_body(message.into_bytes());
    }

    /// A watch over work about an open document; the next edit of it ends the work.
    pub(super) fn watch(&self, uri: &Uri) -> Arc<Watch> {
        let watch = Arc::new(Watch::default());
        let mut state = self.state();
        let key = state.documents.get(uri).and_then(|document| state.unit_of(document));
        if let Some(unit) = key.and_then(|(key, _)| state.units.get_mut(&key)) {
            unit.asked.retain(|asked| asked.strong_count() > 0);
            unit.asked.push(Arc::downgrade(&watch));
        }
        watch
    }

    /// What there is to say about the unit of an open document as it is now.
    pub(super) fn latest(&self, uri: &Uri) -> Option<(Latest, Client)> {
        let mut state = self.state();
        let document = state.documents.get(uri)?;
        let (key, _) = state.unit_of(document)?;
        let client = state.client;
        let unit = state.units.get_mut(&key)?;
        let latest = match &unit.latest {
            Some((wanted, outcome)) if *wanted == unit.wanted => Latest::Now(outcome.clone()),
            _ => {
                let (sender, receiver) = oneshot::channel();
                unit.waiting.retain(|waiting| !waiting.is_closed());
                unit.waiting.push(sender);
                Latest::Later(receiver)
            }
        };
        Some((latest, client))
    }
}

impl Latest {
    /// Waits for it. Nothing comes where the document was closed, which is as good as modified, or where the run failed.
    pub(super) async fn wait(self) -> Result<Arc<Outcome>> {
        match self {
            Latest::Now(outcome) => Ok(outcome),
            Latest::Later(receiver) => receiver.await.map_err(|_| Error::content_modified())?.ok_or_else(Error::internal_error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::document::{Document, Role};
    use super::*;
    use std::str::FromStr;

    fn shared(names: &[&str]) -> Shared {
        let shared = Shared::new(Output::start(std::io::sink()).unwrap());
        for name in names {
            let uri = Uri::from_str(&format!("untitled:{name}")).unwrap();
            let document = Document::new(uri.clone(), "psdl", 1, "x = 1\n");
            let mut state = shared.state();
            let key = state.unit_of(&document).unwrap().0;
            state.documents.insert(uri.clone(), document);
            state.unit(&key, Role::Program).uri = Some(uri);
            state.schedule(&key, true);
        }
        shared
    }

    fn uri(name: &str) -> Uri {
        Uri::from_str(&format!("untitled:{name}")).unwrap()
    }

    #[test]
    fn a_panic_of_a_run_leaves_the_server_alive_and_those_who_wait_informed() {
        let shared = shared(&["a"]);
        let Some((Latest::Later(mut waiting), _)) = shared.latest(&uri("a")) else { panic!("nothing ran yet") };
        shared.work_once(|_| panic!("on purpose"));
        assert!(waiting.try_recv().unwrap().is_none());
        let key = Key::of(&uri("a"), None);
        shared.state().schedule(&key, true);
        shared.work_once(run::run);
        assert!(matches!(shared.latest(&uri("a")), Some((Latest::Now(_), _))));
    }

    #[test]
    fn an_edit_cancels_the_run_and_only_what_is_newest_is_kept() {
        let shared = shared(&["a"]);
        let key = Key::of(&uri("a"), None);
        shared.work_once(|job| {
            shared.state().schedule(&key, true);
            assert!(job.cancel.load(std::sync::atomic::Ordering::Relaxed));
            let cancel = Arc::default();
            run::run(&Job { cancel, ..job.clone() })
        });
        assert!(matches!(shared.latest(&uri("a")), Some((Latest::Later(_), _))), "the outcome is of an older text");
        shared.work_once(run::run);
        assert!(matches!(shared.latest(&uri("a")), Some((Latest::Now(_), _))));
        assert!(shared.state().next().is_none());
    }

    #[test]
    fn a_unit_is_with_one_worker_at_a_time() {
        let shared = shared(&["a", "b"]);
        let (first, ..) = shared.next();
        shared.state().schedule(&first, true);
        let (second, ..) = shared.next();
        assert_ne!(first, second);
        assert!(shared.state().next().is_none(), "the first is asked for again, but still under way");
    }

    #[test]
    fn what_was_edited_goes_before_what_is_only_looked_at_again() {
        let shared = shared(&["a", "b", "c"]);
        shared.state().configure();
        let key = Key::of(&uri("b"), None);
        shared.state().schedule(&key, true);
        assert_eq!(shared.next().0, key);
    }
}
