//! From bytes to calls of the service and back.
//!
//! `tower_lsp_server::Server` is not used: it ends at the first malformed header, and lets four requests that wait hold
//! up the edit that they wait for. Here each message is handled up to its first wait before the next is read, so that
//! the order of edits is the order of messages; what waits goes on beside. Nothing that a client sends ends the loop.

use super::frame::{Frame, FrameReader};
use super::output::Output;
use super::params;
use futures_util::{FutureExt, SinkExt};
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Value;
use std::future::Future;
use std::io::BufRead;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::task::{Context, Poll, Waker};
use tokio::runtime::Handle;
use tower_lsp_server::jsonrpc::{Error, Id, Request, Response};
use tower_lsp_server::{ExitedError, Loopback};
use tower_service::Service;

/// The part of a message that says what it is.
#[derive(Deserialize)]
struct Probe {
    #[serde(default)]
    id: Option<Value>,
    #[serde(default)]
    method: Option<IgnoredAny>,
}

#[derive(Debug)]
enum Message {
    Request(Request),
    Response(Response),
    Wrong(Response),
}

/// Handles messages until `exit` or the end of the stream.
pub(super) fn serve<S, L>(input: impl BufRead, output: &Output, mut service: S, socket: L, runtime: &Handle)
where
    S: Service<Request, Response = Option<Response>, Error = ExitedError>,
    S::Future: Send + 'static,
    L: Loopback,
    L::RequestStream: Send + 'static,
{
    let _entered = runtime.enter();
    let (requests, mut responses) = socket.split();
    runtime.spawn(forward(requests, output.clone()));
    let mut frames = FrameReader::new(input);
    let mut begun = false;
    loop {
        let message = match frames.next() {
            Ok(Some(Frame::Body(body))) => read(&body),
            Ok(Some(Frame::Refused(why))) => {
                tracing::warn!("refused: {why}");
                Message::Wrong(Response::from_error(Id::Null, Error::parse_error()))
            }
            Ok(None) => return,
            Err(error) => return tracing::error!("standard input: {error}"),
        };
        match message {
            Message::Request(request) => {
                let exit = request.method() == "exit";
                begun |= request.method() == "initialize";
                if !begun && !exit && request.id().is_none() {
                    // The service passes it by without a word.
                    tracing::warn!("refused: {:.80} before initialize", request.method());
                }
                call(&mut service, request, output, runtime);
                if exit {
                    return;
                }
            }
            Message::Response(response) => {
                // The way back never fills up, so this does not wait.
                let _ = responses.send(response).now_or_never();
            }
            Message::Wrong(response) => output.send(&response),
        }
    }
}

/// Sends on what the server asks the client.
async fn forward(mut requests: impl futures_util::Stream<Item = Request> + Unpin, output: Output) {
    while let Some(request) = futures_util::StreamExt::next(&mut requests).await {
        output.send(&request);
    }
}

fn read(body: &[u8]) -> Message {
    let wrong = |id: Option<Value>, error| {
        tracing::warn!("refused: a message that is no request and no response");
        let id = id.and_then(|id| serde_json::from_value(id).ok()).unwrap_or(Id::Null);
        Message::Wrong(Response::from_error(id, error))
    };
    let probe: Probe = match serde_json::from_slice(body) {
        Ok(probe) => probe,
        Err(error) if error.is_data() => return wrong(None, Error::invalid_request()),
        Err(_) => return wrong(None, Error::parse_error()),
    };
    if probe.method.is_some() {
        serde_json::from_slice(body).map_or_else(|_| wrong(probe.id, Error::invalid_request()), Message::Request)
    } else {
        serde_json::from_slice(body).map_or_else(|_| wrong(probe.id, Error::invalid_request()), Message::Response)
    }
}

/// Handles a message up to its first wait; the rest goes on beside the next messages.
fn call<S>(service: &mut S, request: Request, output: &Output, runtime: &Handle)
where
    S: Service<Request, Response = Option<Response>, Error = ExitedError>,
    S::Future: Send + 'static,
{
    let method = request.method().to_string();
    let id = request.id().cloned();
    if id.is_none() && !params::fit(&method, request.params()) {
        return tracing::warn!("refused: {method:.80} with parameters that it does not take");
    }
    let mut context = Context::from_waker(Waker::noop());
    if let Poll::Ready(Err(error)) = service.poll_ready(&mut context) {
        return tracing::warn!("refused: {method:.80}: {error}");
    }
    let Ok(future) = catch_unwind(AssertUnwindSafe(|| service.call(request))) else {
        return reply(output, &method, id, Err(()));
    };
    let mut future = Box::pin(caught(future));
    match future.poll_unpin(&mut context) {
        Poll::Ready(result) => reply(output, &method, id, result),
        Poll::Pending => {
            let output = output.clone();
            runtime.spawn(async move { reply(&output, &method, id, future.await) });
        }
    }
}

/// The result, or nothing where the handler panicked.
async fn caught<T>(future: impl Future<Output = Result<T, ExitedError>>) -> Result<Option<T>, ()> {
    AssertUnwindSafe(future).catch_unwind().await.map(Result::ok).map_err(|_| ())
}

fn reply(output: &Output, method: &str, id: Option<Id>, result: Result<Option<Option<Response>>, ()>) {
    match (result, id) {
        (Ok(Some(Some(response))), _) => {
            if let Some(error) = response.error() {
                tracing::debug!("{method:.80}: error {}", error.code);
            }
            output.send(&response);
        }
        (Ok(_), None) => {}
        // The service says nothing to requests of unknown methods that begin with `$/`.
        (Ok(_), Some(id)) => output.send(&Response::from_error(id, Error::method_not_found())),
        (Err(()), id) => {
            tracing::error!("{method:.80}: the handler panicked");
            if let Some(id) = id {
                output.send(&Response::from_error(id, Error::internal_error()));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::frame::write_frame;
    use super::*;
    use serde_json::json;
    use std::io::Write;
    use std::sync::{Arc, Mutex};
    use tower_lsp_server::jsonrpc::Result;
    use tower_lsp_server::ls_types::{InitializeParams, InitializeResult};
    use tower_lsp_server::{LanguageServer, LspService};

    #[derive(Debug)]
    struct Panicking;

    impl LanguageServer for Panicking {
        async fn initialize(&self, _: InitializeParams) -> Result<InitializeResult> {
            Ok(InitializeResult::default())
        }

        async fn shutdown(&self) -> Result<()> {
            Ok(())
        }
    }

    impl Panicking {
        async fn at_once(&self) -> Result<()> {
            panic!("on purpose")
        }

        async fn later(&self) -> Result<()> {
            tokio::task::yield_now().await;
            panic!("on purpose")
        }

        async fn fine(&self) -> Result<u32> {
            Ok(7)
        }
    }

    #[derive(Clone, Default)]
    struct Sink(Arc<Mutex<Vec<u8>>>);

    impl Write for Sink {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0.lock().unwrap().extend(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }

    fn answers(messages: &[Value]) -> Vec<Value> {
        let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(1).build().unwrap();
        let sink = Sink::default();
        let output = Output::start(sink.clone()).unwrap();
        let (service, socket) = LspService::build(|_| Panicking)
            .custom_method("at/once", Panicking::at_once)
            .custom_method("later", Panicking::later)
            .custom_method("fine", Panicking::fine)
            .finish();
        let mut input = Vec::new();
        for message in messages {
            write_frame(&mut input, message.to_string().as_bytes()).unwrap();
        }
        serve(input.as_slice(), &output, service, socket, runtime.handle());
        runtime.block_on(async { tokio::task::yield_now().await });
        drop(runtime);
        output.flush();
        let bytes = sink.0.lock().unwrap().clone();
        let mut reader = FrameReader::new(bytes.as_slice());
        let mut found = Vec::new();
        while let Some(Frame::Body(body)) = reader.next().unwrap() {
            found.push(serde_json::from_slice(&body).unwrap());
        }
        found
    }

    #[test]
    fn a_panic_is_an_error_reply_and_the_next_request_works() {
        let request = |id: u32, method: &str| json!({"jsonrpc": "2.0", "id": id, "method": method});
        let first = json!({"jsonrpc": "2.0", "id": 0, "method": "initialize", "params": {"capabilities": {}}});
        let found = answers(&[first, request(1, "at/once"), request(2, "later"), request(3, "fine"), request(4, "$/strange")]);
        let of = |id: u32| found.iter().find(|answer| answer["id"] == json!(id)).unwrap_or_else(|| panic!("{id} of {found:?}"));
        assert_eq!(of(1)["error"]["code"], json!(-32603));
        assert_eq!(of(3)["result"], json!(7));
        assert_eq!(of(4)["error"]["code"], json!(-32601));
        assert!(found.iter().all(|answer| answer["id"] != json!(2) || answer["error"]["code"] == json!(-32603)));
    }
}
