//! Any bytes between good messages: the server answers the next good request.
//!
//! The first byte of the input says how what follows is sent: as the body of a message, or as it is.
#![no_main]

use std::io::{BufRead, BufReader, Read, Write};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Mutex, OnceLock};
use std::time::{Duration, Instant};

use libfuzzer_sys::fuzz_target;
use serde_json::{Value, json};

/// What takes longer does not come.
const PATIENCE: Duration = Duration::from_secs(20);

/// The bytes of a channel, as they come.
struct Incoming {
    pieces: Receiver<Vec<u8>>,
    piece: Vec<u8>,
}

impl Read for Incoming {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        if self.piece.is_empty() {
            self.piece = self.pieces.recv().unwrap_or_default();
        }
        let count = self.piece.len().min(into.len());
        into[..count].copy_from_slice(&self.piece[..count]);
        self.piece.drain(..count);
        Ok(count)
    }
}

/// What the server writes goes into a channel.
struct Outgoing(Sender<Vec<u8>>);

impl Write for Outgoing {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let _ = self.0.send(bytes.to_vec());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

struct Client {
    to_server: Sender<Vec<u8>>,
    answers: Receiver<Value>,
    last: u64,
}

impl Client {
    fn start() -> Client {
        let (to_server, pieces) = channel();
        let (written, from_server) = channel();
        let (told, answers) = channel();
        std::thread::spawn(move || psdl::server::serve_on(BufReader::new(Incoming { pieces, piece: Vec::new() }), Outgoing(written)));
        std::thread::spawn(move || {
            let mut from_server = BufReader::new(Incoming { pieces: from_server, piece: Vec::new() });
            while let Some(message) = message(&mut from_server) {
                let _ = told.send(message);
            }
        });
        let mut client = Client { to_server, answers, last: 0 };
        client.ask("initialize", &json!({"processId": null, "rootUri": null, "capabilities": {}}));
        client.send(json!({"jsonrpc": "2.0", "method": "initialized", "params": {}}).to_string().as_bytes());
        client
    }

    fn send(&self, body: &[u8]) {
        let mut bytes = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
        bytes.extend(body);
        let _ = self.to_server.send(bytes);
    }

    /// Asks and waits for the answer.
    fn ask(&mut self, method: &str, params: &Value) -> Value {
        self.last += 1;
        let id = format!("fuzz-{}", self.last);
        self.send(json!({"jsonrpc": "2.0", "id": id, "method": method, "params": params}).to_string().as_bytes());
        let end = Instant::now() + PATIENCE;
        loop {
            match self.answers.recv_timeout(end.saturating_duration_since(Instant::now())) {
                Ok(answer) if answer["id"] == id.as_str() => return answer,
                Ok(_) => {}
                Err(RecvTimeoutError::Timeout) => panic!("no answer to {method}"),
                Err(RecvTimeoutError::Disconnected) => panic!("the server is gone"),
            }
        }
    }
}

fn message(from: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if from.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim().split_once(": ") {
            Some(("Content-Length", count)) => length = count.parse().ok()?,
            Some(_) => {}
            None => break,
        }
    }
    let mut body = vec![0; length];
    from.read_exact(&mut body).ok()?;
    serde_json::from_slice(&body).ok()
}

/// Whether a message would end the server, as it may.
fn ends(body: &[u8]) -> bool {
    ["exit", "shutdown", "initialize"].iter().any(|word| body.windows(word.len()).any(|window| window == word.as_bytes()))
}

fuzz_target!(|bytes: &[u8]| {
    static CLIENT: OnceLock<Mutex<Client>> = OnceLock::new();
    let Some((how, body)) = bytes.split_first() else { return };
    if ends(body) {
        return;
    }
    let mut client = CLIENT.get_or_init(|| Mutex::new(Client::start())).lock().expect("one at a time");
    match how % 4 {
        // Params for a known request.
        0 => {
            let params = serde_json::from_slice(body).unwrap_or_else(|_| json!({"textDocument": {"uri": String::from_utf8_lossy(body)}}));
            for method in ["textDocument/hover", "textDocument/codeAction", "psdl/move"] {
                client.ask(method, &params);
            }
        }
        // A text, opened and closed.
        1 => {
            let uri = "untitled:fuzz.psdl";
            let text = String::from_utf8_lossy(body);
            let opened = json!({"textDocument": {"uri": uri, "languageId": "psdl", "version": 1, "text": text}});
            client.send(json!({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": opened}).to_string().as_bytes());
            client.ask("textDocument/documentSymbol", &json!({"textDocument": {"uri": uri}}));
            let closed = json!({"textDocument": {"uri": uri}});
            client.send(json!({"jsonrpc": "2.0", "method": "textDocument/didClose", "params": closed}).to_string().as_bytes());
        }
        // The body of a message.
        2 => client.send(body),
        // Bytes as they are, then a blank line: headers without sense.
        _ => {
            let bare: Vec<u8> = body.iter().copied().filter(|byte| !byte.is_ascii_digit()).chain(*b"\r\n\r\n").collect();
            let _ = client.to_server.send(bare);
        }
    }
    let answer =
        client.ask("textDocument/hover", &json!({"textDocument": {"uri": "file:///none.psdl"}, "position": {"line": 0, "character": 0}}));
    assert!(answer.get("result").is_some() || answer.get("error").is_some());
});
