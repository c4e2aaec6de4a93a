//! `$/progress` of long work, and its end where the client ends it.

use super::handlers::Backend;
use super::output::Output;
use super::shared::Shared;
use super::state::Cancellable;
use crate::repair::Watch;
use futures_util::future::{Either, select};
use serde_json::{Value, json};
use std::future::Future;
use std::pin::{Pin, pin};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::{ProgressToken, WorkDoneProgressCancelParams};

/// How often progress is told.
const BEAT: Duration = Duration::from_millis(100);
/// Work that is done by then is not told of, unless the client gave a token for it.
const UNTOLD: Duration = Duration::from_millis(150);

/// A search that can be followed.
pub(super) struct Task<'a> {
    /// Under which token the client wants to be told; without one it is asked for one, if the work takes long.
    pub token: Option<ProgressToken>,
    /// What is shown.
    pub title: &'a str,
    /// What the watch counts up to.
    pub budget: usize,
    pub watch: Arc<Watch>,
}

impl Backend {
    /// Waits for work and tells its progress meanwhile. The client may end it: then the answer is that it did.
    pub(super) async fn followed<T>(&self, task: Task<'_>, work: impl Future<Output = Result<T>>) -> Result<T> {
        let mut work = pin!(work);
        let token = match task.token.clone() {
            Some(token) => Some(token),
            None => match tokio::time::timeout(UNTOLD, work.as_mut()).await {
                Ok(result) => return result,
                // A client that does not answer holds nothing up.
                Err(_) => match select(pin!(self.own_token()), work.as_mut()).await {
                    Either::Left((token, _)) => token,
                    Either::Right((result, _)) => return result,
                },
            },
        };
        let Some(token) = token else { return work.await };
        self.shared.cancellable(&token, &task.watch);
        let result = told(&self.shared.output, &token, &task, work).await;
        if self.shared.was_cancelled(&token) { Err(Error::request_cancelled()) } else { result }
    }

    /// A token for progress that nobody asked for, where the client shows such.
    async fn own_token(&self) -> Option<ProgressToken> {
        let token = {
            let mut state = self.shared.state();
            let number = state.client.progress.then(|| state.number())?;
            ProgressToken::String(format!("psdl/{number}"))
        };
        self.client.create_work_done_progress(token.clone()).await.ok().map(|()| token)
    }

    /// `window/workDoneProgress/cancel`
    pub(super) async fn cancel_progress(&self, params: WorkDoneProgressCancelParams) {
        let mut state = self.shared.state();
        for known in state.tokens.iter_mut().filter(|known| known.token == params.token) {
            known.ended = true;
            known.watch.upgrade().into_iter().for_each(|watch| watch.cancelled.store(true, Ordering::Relaxed));
        }
    }
}

impl Shared {
    /// Lets a client end work by the token of its progress.
    fn cancellable(&self, token: &ProgressToken, watch: &Arc<Watch>) {
        let mut state = self.state();
        state.tokens.retain(|known| known.watch.strong_count() > 0);
        state.tokens.push(Cancellable { token: token.clone(), watch: Arc::downgrade(watch), ended: false });
    }

    /// Whether the client has ended the work; forgets the token.
    fn was_cancelled(&self, token: &ProgressToken) -> bool {
        let mut state = self.state();
        let ended = state.tokens.iter().any(|known| known.token == *token && known.ended);
        state.tokens.retain(|known| known.token != *token);
        ended
    }
}

async fn told<T>(output: &Output, token: &ProgressToken, task: &Task<'_>, mut work: Pin<&mut impl Future<Output = T>>) -> T {
    let tell = |value: Value| output.notify("$/progress", json!({ "token": token, "value": value }));
    tell(json!({ "kind": "begin", "title": task.title, "cancellable": true, "percentage": 0 }));
    let _end = End(output, token);
    loop {
        match tokio::time::timeout(BEAT, work.as_mut()).await {
            Ok(result) => return result,
            Err(_) => {
                let percentage = 100 * task.watch.spent.load(Ordering::Relaxed) / task.budget.max(1);
                tell(json!({ "kind": "report", "percentage": percentage.min(99) }));
            }
        }
    }
}

/// Tells the end once, also where the request is cancelled.
struct End<'a>(&'a Output, &'a ProgressToken);

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.0.notify("$/progress", json!({ "token": self.1, "value": { "kind": "end" } }));
    }
}
