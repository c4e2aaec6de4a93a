//! `$/progress` of long work.

use super::output::Output;
use crate::repair::Watch;
use serde_json::{Value, json};
use std::future::Future;
use std::sync::atomic::Ordering;
use std::time::Duration;
use tower_lsp_server::ls_types::ProgressToken;

/// How often progress is told.
const BEAT: Duration = Duration::from_millis(100);

/// Waits for work and tells its progress meanwhile, if somebody wants to know.
pub(super) async fn told<T>(
    output: &Output,
    token: Option<ProgressToken>,
    title: &str,
    budget: usize,
    watch: &Watch,
    work: impl Future<Output = T>,
) -> T {
    let Some(token) = token else { return work.await };
    let tell = |value: Value| output.notify("$/progress", json!({ "token": token, "value": value }));
    tell(json!({ "kind": "begin", "title": title, "cancellable": true, "percentage": 0 }));
    let _end = End(output, token.clone());
    let mut work = std::pin::pin!(work);
    loop {
        match tokio::time::timeout(BEAT, work.as_mut()).await {
            Ok(result) => return result,
            Err(_) => {
                let percentage = 100 * watch.spent.load(Ordering::Relaxed) / budget.max(1);
                tell(json!({ "kind": "report", "percentage": percentage.min(99) }));
            }
        }
    }
}

/// Tells the end once, also where the request is cancelled.
struct End<'a>(&'a Output, ProgressToken);

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.0.notify("$/progress", json!({ "token": self.1, "value": { "kind": "end" } }));
    }
}
