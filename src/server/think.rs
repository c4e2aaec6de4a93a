//! Work that a client asks for and that is more than a lookup: done on threads of its own, so that no run waits for it.

use super::shared::Shared;
use crate::repair::Watch;
use std::collections::VecDeque;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::Ordering;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use tokio::sync::oneshot;

/// Threads for such work.
const THREADS: usize = 2;

type Task = Box<dyn FnOnce() + Send>;

/// The work that waits.
#[derive(Default)]
pub(super) struct Desk {
    queue: Mutex<VecDeque<Task>>,
    some: Condvar,
}

/// Ends the work when nobody waits for it any more.
struct Guard(Option<Arc<Watch>>);

impl Drop for Guard {
    fn drop(&mut self) {
        self.0.iter().for_each(|watch| watch.cancelled.store(true, Ordering::Relaxed));
    }
}

impl Desk {
    fn put(&self, task: Task) {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner).push_back(task);
        self.some.notify_one();
    }

    fn work(&self) {
        let mut queue = self.queue.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            match queue.pop_front() {
                Some(task) => {
                    drop(queue);
                    if catch_unwind(AssertUnwindSafe(task)).is_err() {
                        tracing::error!("work for a request panicked");
                    }
                    queue = self.queue.lock().unwrap_or_else(PoisonError::into_inner);
                }
                None => queue = self.some.wait(queue).unwrap_or_else(PoisonError::into_inner),
            }
        }
    }
}

impl Shared {
    /// Starts the threads.
    pub(super) fn start_thinking(self: &Arc<Shared>, stack: usize) -> std::io::Result<()> {
        for index in 0..THREADS {
            let shared = self.clone();
            std::thread::Builder::new().name(format!("thinker {index}")).stack_size(stack).spawn(move || shared.desk.work())?;
        }
        Ok(())
    }

    /// Has work done. It is told to end where the request is cancelled, that is, where this future is dropped. `None` where it failed.
    pub(super) async fn think<T: Send + 'static>(&self, watch: Arc<Watch>, work: impl FnOnce(&Watch) -> T + Send + 'static) -> Option<T> {
        let (sender, receiver) = oneshot::channel();
        let mut guard = Guard(Some(watch.clone()));
        self.desk.put(Box::new(move || {
            if !watch.cancelled.load(Ordering::Relaxed) {
                // Who has gone needs no answer.
                let _ = sender.send(work(&watch));
            }
        }));
        let result = receiver.await.ok();
        // There is nothing left to end.
        guard.0 = None;
        result
    }
}
