//! A small editor: starts the server, frames messages, remembers what comes.

use serde_json::{Value, json};
use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// What takes longer does not come.
const PATIENCE: Duration = Duration::from_secs(60);

/// A server and the messages that it sent.
pub struct Client {
    child: Child,
    stdin: Option<ChildStdin>,
    messages: Receiver<Value>,
    /// Notifications and requests of the server that nobody has looked at yet.
    pub unread: VecDeque<Value>,
    last_id: i64,
}

/// The capabilities of an editor that shows all that it is told.
pub fn capabilities(encoding: &str) -> Value {
    json!({
        "general": {"positionEncodings": [encoding]},
        "textDocument": {"publishDiagnostics": {
            "relatedInformation": true, "versionSupport": true, "codeDescriptionSupport": true, "dataSupport": true,
            "tagSupport": {"valueSet": [1, 2]},
        }, "hover": {"contentFormat": ["markdown", "plaintext"]}, "completion": {"completionItem": {"snippetSupport": true}}},
        "workspace": {"workspaceEdit": {"documentChanges": true}},
    })
}

/// The same for one that asks for diagnostics.
#[allow(dead_code, reason = "the benchmark does not ask")]
pub fn pulling() -> Value {
    let mut capabilities = capabilities("utf-16");
    capabilities["textDocument"]["diagnostic"] = json!({"relatedDocumentSupport": true});
    capabilities["workspace"]["diagnostics"] = json!({"refreshSupport": true});
    capabilities["workspace"]["didChangeWatchedFiles"] = json!({"dynamicRegistration": true});
    capabilities
}

pub fn uri(path: &Path) -> String {
    format!("file://{}", path.to_str().unwrap().replace(' ', "%20").replace('\'', "%27"))
}

#[allow(dead_code, reason = "each user of this file uses a part of it")]
impl Client {
    /// A server to which nothing has been said.
    pub fn spawn(arguments: &[&str]) -> Client {
        let mut command = Command::new(env!("CARGO_BIN_EXE_psdl"));
        command.arg("lsp").args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped());
        if !arguments.contains(&"--log") {
            command.stderr(Stdio::null());
        }
        let mut child = command.spawn().unwrap();
        let stdin = child.stdin.take();
        let mut output = BufReader::new(child.stdout.take().unwrap());
        let (sender, messages) = channel();
        std::thread::spawn(move || {
            while let Some(message) = read(&mut output) {
                if sender.send(message).is_err() {
                    break;
                }
            }
        });
        Client { child, stdin, messages, unread: VecDeque::new(), last_id: 0 }
    }

    /// A server that is ready for documents.
    pub fn start(capabilities: Value) -> Client {
        Client::start_with(&[], capabilities)
    }

    pub fn start_with(arguments: &[&str], capabilities: Value) -> Client {
        let mut client = Client::spawn(arguments);
        let answer = client.request("initialize", json!({"processId": null, "rootUri": null, "capabilities": capabilities}));
        assert!(answer["result"]["capabilities"].is_object(), "{answer}");
        client.notify("initialized", json!({}));
        client
    }

    pub fn pid(&self) -> u32 {
        self.child.id()
    }

    /// Bytes as they are.
    pub fn raw(&mut self, bytes: &[u8]) {
        let stdin = self.stdin.as_mut().unwrap();
        stdin.write_all(bytes).and_then(|()| stdin.flush()).unwrap();
    }

    pub fn send(&mut self, message: &Value) {
        let bytes = frame(message);
        self.raw(&bytes);
    }

    pub fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({"jsonrpc": "2.0", "method": method, "params": params}));
    }

    /// Asks, without waiting for the answer.
    pub fn ask(&mut self, method: &str, params: Value) -> i64 {
        self.last_id += 1;
        self.send(&json!({"jsonrpc": "2.0", "id": self.last_id, "method": method, "params": params}));
        self.last_id
    }

    pub fn request(&mut self, method: &str, params: Value) -> Value {
        let id = self.ask(method, params);
        self.answer(&json!(id))
    }

    /// The answer to a question; what else comes until then is remembered.
    pub fn answer(&mut self, id: &Value) -> Value {
        self.wait(&format!("the answer to {id}"), |message| message.get("method").is_none() && message.get("id") == Some(id))
    }

    /// The next message that is meant.
    pub fn wait(&mut self, what: &str, meant: impl Fn(&Value) -> bool) -> Value {
        if let Some(at) = self.unread.iter().position(&meant) {
            return self.unread.remove(at).unwrap();
        }
        let start = Instant::now();
        loop {
            let left = PATIENCE.checked_sub(start.elapsed()).unwrap_or_else(|| panic!("{what} did not come"));
            let message = self.messages.recv_timeout(left).unwrap_or_else(|_| panic!("{what} did not come; but {:?}", self.unread));
            if message.get("method").is_some() && message.get("id").is_some() {
                self.send(&json!({"jsonrpc": "2.0", "id": message["id"], "result": null}));
            }
            if meant(&message) {
                return message;
            }
            self.unread.push_back(message);
        }
    }

    pub fn open(&mut self, uri: &str, version: i32, text: &str) {
        let item = json!({"uri": uri, "languageId": "psdl", "version": version, "text": text});
        self.notify("textDocument/didOpen", json!({"textDocument": item}));
    }

    pub fn close(&mut self, uri: &str) {
        self.notify("textDocument/didClose", json!({"textDocument": {"uri": uri}}));
    }

    /// Changes as the protocol writes them.
    pub fn change(&mut self, uri: &str, version: i32, changes: Value) {
        self.notify("textDocument/didChange", json!({"textDocument": {"uri": uri, "version": version}, "contentChanges": changes}));
    }

    /// What is published about a version of a document; what was published about it before is forgotten.
    pub fn diagnostics(&mut self, uri: &str, version: i32) -> Vec<Value> {
        let published = |message: &Value| message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == *uri;
        let mut message = self
            .wait(&format!("version {version} of {uri}"), |message| published(message) && message["params"]["version"] == json!(version));
        self.unread.retain(|message| !published(message));
        serde_json::from_value(message["params"]["diagnostics"].take()).unwrap()
    }

    /// The next thing published about a document, whatever its version.
    pub fn published(&mut self, uri: &str) -> Value {
        let meant = |message: &Value| message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == *uri;
        self.wait(&format!("diagnostics of {uri}"), meant)["params"].clone()
    }

    /// What the server believes to stand in a document.
    pub fn text(&mut self, uri: &str) -> String {
        let answer = self.request("psdl/text", json!({"textDocument": {"uri": uri}}));
        answer["result"]["text"].as_str().unwrap_or_else(|| panic!("{answer}")).to_string()
    }

    /// Shows that the server is well: it answers, and what it was told before is done.
    pub fn is_well(&mut self) {
        let answer = self.request("psdl/text", json!({"textDocument": {"uri": "file:///there/is/no/such.psdl"}}));
        assert_eq!(answer["error"]["code"], json!(-32602), "{answer}");
    }

    /// Closes standard input.
    pub fn hang_up(&mut self) {
        self.stdin = None;
    }

    /// The status that the server ended with.
    pub fn ended(&mut self) -> i32 {
        let start = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.code().expect("it ended by itself");
            }
            assert!(start.elapsed() < PATIENCE, "the server does not end");
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    /// Ends the server as an editor does.
    pub fn finish(mut self) {
        let answer = self.request("shutdown", Value::Null);
        assert_eq!(answer["result"], Value::Null, "{answer}");
        self.notify("exit", Value::Null);
        assert_eq!(self.ended(), 0);
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A message as it is sent.
pub fn frame(message: &Value) -> Vec<u8> {
    let body = message.to_string();
    format!("Content-Length: {}\r\n\r\n{body}", body.len()).into_bytes()
}

fn read(output: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim().split_once(": ") {
            Some(("Content-Length", value)) => length = value.parse().unwrap(),
            Some(_) => {}
            None => break,
        }
    }
    let mut body = vec![0; length];
    output.read_exact(&mut body).ok()?;
    Some(serde_json::from_slice(&body).unwrap())
}

/// Bytes that a process holds in memory, where the system tells.
#[allow(dead_code, reason = "for the soak and the benchmark")]
pub fn memory(pid: u32) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{pid}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok().map(|kilobytes| kilobytes * 1024)
}
