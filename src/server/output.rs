//! The way out: whoever has something to say queues it, one thread writes. Nobody waits for a client that does not read.

use super::frame::write_frame;
use serde::Serialize;
use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::time::Duration;

/// How long the end waits for what is still to be written.
const LAST_WORDS: Duration = Duration::from_millis(500);

enum Piece {
    Message(Vec<u8>),
    Flush(SyncSender<()>),
}

/// Where messages to the client go.
#[derive(Clone, Debug)]
pub(super) struct Output {
    queue: Sender<Piece>,
    backlog: Arc<AtomicUsize>,
}

/// A notification; requests and responses have types of their own.
#[derive(Serialize)]
struct Notification<'a, P> {
    jsonrpc: &'static str,
    method: &'a str,
    params: P,
}

impl Output {
    /// Starts the thread that writes.
    pub(super) fn start(writer: impl Write + Send + 'static) -> std::io::Result<Output> {
        let (queue, pieces) = channel();
        let backlog = Arc::new(AtomicUsize::new(0));
        let output = Output { queue, backlog: backlog.clone() };
        std::thread::Builder::new().name("output".into()).spawn(move || write(writer, &pieces, &backlog))?;
        Ok(output)
    }

    /// Queues a message.
    pub(super) fn send(&self, message: &impl Serialize) {
        match serde_json::to_vec(message) {
            Ok(body) => self.send_body(body),
            Err(error) => tracing::error!("a message could not be written as JSON: {error}"),
        }
    }

    /// Queues a message that is written as JSON already.
    pub(super) fn send_body(&self, body: Vec<u8>) {
        self.backlog.fetch_add(body.len(), Ordering::Relaxed);
        // The thread that writes ends only with the process.
        let _ = self.queue.send(Piece::Message(body));
    }

    /// Queues a notification.
    pub(super) fn notify(&self, method: &str, params: impl Serialize) {
        self.send(&Notification { jsonrpc: "2.0", method, params });
    }

    /// Bytes that are queued.
    pub(super) fn backlog(&self) -> usize {
        self.backlog.load(Ordering::Relaxed)
    }

    /// Waits until what is queued is written, but not for long.
    pub(super) fn flush(&self) {
        let (done, written) = sync_channel(1);
        let _ = self.queue.send(Piece::Flush(done));
        let _ = written.recv_timeout(LAST_WORDS);
    }
}

fn write(mut writer: impl Write, pieces: &Receiver<Piece>, backlog: &AtomicUsize) {
    let mut open = true;
    for piece in pieces {
        match piece {
            Piece::Message(body) => {
                if open && let Err(error) = write_frame(&mut writer, &body) {
                    tracing::error!("standard output: {error}");
                    open = false;
                }
                backlog.fetch_sub(body.len(), Ordering::Relaxed);
            }
            Piece::Flush(done) => {
                let _ = done.send(());
            }
        }
    }
}
