//! Clients that are broken, hasty or malicious: they are refused, and the next good request works.

use super::client::{Client, capabilities, frame};
use super::flows::OVERLAP;
use proptest::prelude::*;
use serde_json::{Value, json};

fn code(answer: &Value) -> i64 {
    answer["error"]["code"].as_i64().unwrap_or_else(|| panic!("no error: {answer}"))
}

#[test]
fn what_is_no_message_is_refused() {
    let mut client = Client::start(capabilities("utf-16"));
    let bodies: [(&[u8], i64); 12] = [
        (b"", -32700),
        (b"{", -32700),
        (b"nonsense", -32700),
        (b"\xff\xfe", -32700),
        (b"[]", -32600),
        (b"[{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"shutdown\"}]", -32600),
        (b"\"text\"", -32600),
        (b"{}", -32600),
        (b"{\"jsonrpc\":\"2.0\",\"method\":1}", -32600),
        (b"{\"jsonrpc\":\"1.0\",\"id\":1,\"method\":\"shutdown\"}", -32600),
        (b"{\"jsonrpc\":\"2.0\",\"id\":{},\"method\":\"shutdown\"}", -32600),
        (b"{\"jsonrpc\":\"2.0\",\"id\":[[[]]],\"result\":1}", -32600),
    ];
    for (body, expected) in bodies {
        client.raw(format!("Content-Length: {}\r\n\r\n", body.len()).as_bytes());
        client.raw(body);
        let refusal = client.wait("a refusal", |message| message["error"].is_object());
        assert_eq!(code(&refusal), expected, "{:?}", String::from_utf8_lossy(body));
        client.is_well();
    }
    let deep = format!("{{\"jsonrpc\":\"2.0\",\"id\":9,\"method\":\"x\",\"params\":{}1{}}}", "[".repeat(100_000), "]".repeat(100_000));
    client.raw(format!("Content-Length: {}\r\n\r\n{deep}", deep.len()).as_bytes());
    assert_eq!(code(&client.wait("a refusal", |message| message["error"].is_object())), -32600);
    client.is_well();
    client.finish();
}

#[test]
fn headers_that_lie_are_got_over() {
    let mut client = Client::start(capabilities("utf-16"));
    let wrong: [&[u8]; 7] = [
        b"Content-Length: x\r\n\r\n",
        b"Content-Length: -1\r\n\r\n{}",
        b"Content-Length: 99999999999999999999999999\r\n\r\n{}",
        b"Content-Length: 99999999999\r\n\r\n{}\r\n",
        b"Length: 2\r\n\r\n{}\r\n",
        b"\x00\xff\r\n\r\n",
        b"Content-Length: 1\r\n\r\n{\"a\": \"longer than it said\"}",
    ];
    for bytes in wrong {
        client.raw(bytes);
        client.is_well();
    }
    client.raw(b"content-length:  2  \r\nContent-Type: application/vscode-jsonrpc; charset=utf-8\r\nX: y\r\n\r\n{}");
    client.is_well();
    client.finish();
}

#[test]
fn unknown_methods_and_wrong_types_are_answered() {
    let mut client = Client::start(capabilities("utf-16"));
    assert_eq!(code(&client.request("psdl/nothing", json!({}))), -32601);
    assert_eq!(code(&client.request("$/nothing", json!({}))), -32601);
    client.notify("psdl/nothing", json!({}));
    client.notify("$/nothing", json!([1]));
    assert_eq!(code(&client.request("psdl/text", json!({"textDocument": 7}))), -32602);
    assert_eq!(code(&client.request("psdl/text", json!([]))), -32602);
    assert_eq!(code(&client.request("textDocument/codeAction", json!({"textDocument": {"uri": "no uri at all %%"}}))), -32602);
    assert_eq!(code(&client.request("initialize", json!({"capabilities": {}}))), -32600);
    for method in ["didOpen", "didChange", "didClose", "didSave"] {
        for params in [Value::Null, json!([]), json!({}), json!({"textDocument": null}), json!({"textDocument": {"uri": 1}})] {
            client.notify(&format!("textDocument/{method}"), params);
        }
    }
    client.notify("workspace/didChangeWatchedFiles", json!({"changes": "all"}));
    client.notify("$/setTrace", json!({"value": "loudly"}));
    client.notify("$/cancelRequest", json!({"id": {}}));
    client.notify("$/cancelRequest", json!({"id": 12345}));
    client.notify("$/cancelRequest", json!({"id": "unknown"}));
    client.send(&json!({"jsonrpc": "2.0", "id": 777, "result": "an answer to nothing"}));
    client.is_well();
    client.finish();
}

#[test]
fn documents_that_are_not_open_are_not_changed() {
    let mut client = Client::start(capabilities("utf-16"));
    client.change("untitled:1", 1, json!([{"text": "x"}]));
    client.close("untitled:1");
    client.notify("textDocument/didSave", json!({"textDocument": {"uri": "untitled:1"}}));
    assert_eq!(code(&client.request("psdl/text", json!({"textDocument": {"uri": "untitled:1"}}))), -32602);
    client.open("untitled:1", 1, "x = 1\n");
    client.open("untitled:1", 2, OVERLAP);
    assert_eq!(client.text("untitled:1"), OVERLAP);
    assert_eq!(client.diagnostics("untitled:1", 2)[0]["code"], "overlap");
    client.finish();
}

#[test]
fn edits_out_of_range_are_refused_and_the_next_good_one_works() {
    let log = tempfile::NamedTempFile::new().unwrap();
    let mut client = Client::start_with(&["--log", log.path().to_str().unwrap()], capabilities("utf-16"));
    client.open("untitled:1", 1, "a = 1\n");
    let most = 2_147_483_647;
    let range = |from: (u32, u32), to: (u32, u32)| json!({"start": {"line": from.0, "character": from.1}, "end": {"line": to.0, "character": to.1}});
    let mut refused = |version: i32, changes: Value| {
        client.change("untitled:1", version, changes);
        assert_eq!(client.text("untitled:1"), "a = 1\n", "version {version}");
    };
    refused(2, json!([{"range": range((2, 0), (2, 0)), "text": "b"}]));
    refused(3, json!([{"range": range((most, most), (most, most)), "text": "b"}]));
    refused(4, json!([{"range": range((0, 3), (0, 1)), "text": "b"}]));
    refused(5, json!([{"range": range((7, 0), (7, 0)), "text": "b"}, {"range": range((0, 0), (0, 0)), "text": "c"}]));
    refused(6, json!([{"range": {"start": {"line": -1, "character": 0}, "end": {"line": 0, "character": 0}}, "text": "x"}]));
    let text = std::fs::read_to_string(log.path()).unwrap();
    assert_eq!(text.matches("refused").count(), 5, "{text}");
    // Behind the end of a line means its end, and an end behind the last line the end of the text.
    client.change("untitled:1", 7, json!([{"range": range((0, most), (0, most)), "text": "0"}]));
    assert_eq!(client.text("untitled:1"), "a = 10\n");
    client.change("untitled:1", 8, json!([{"range": range((0, 0), (most, 0)), "rangeLength": 1, "text": ""}]));
    assert_eq!(client.text("untitled:1"), "");
    client.change("untitled:1", 9, json!([]));
    assert!(client.diagnostics("untitled:1", 9).is_empty());
    client.finish();
}

#[test]
fn requests_before_the_beginning_and_after_the_end_are_refused() {
    let log = tempfile::NamedTempFile::new().unwrap();
    let mut client = Client::spawn(&["--log", log.path().to_str().unwrap()]);
    assert_eq!(code(&client.request("psdl/text", json!({"textDocument": {"uri": "untitled:1"}}))), -32002);
    client.open("untitled:1", 1, OVERLAP);
    assert_eq!(code(&client.request("initialize", json!({"capabilities": 7}))), -32602);
    assert!(std::fs::read_to_string(log.path()).unwrap().contains("refused: textDocument/didOpen before initialize"));
    assert!(client.request("initialize", json!({"capabilities": {}}))["result"].is_object());
    client.is_well();
    assert_eq!(client.request("shutdown", Value::Null)["result"], Value::Null);
    assert_eq!(code(&client.request("psdl/text", json!({"textDocument": {"uri": "untitled:1"}}))), -32600);
    assert_eq!(code(&client.request("shutdown", Value::Null)), -32600);
    client.open("untitled:1", 1, OVERLAP);
    client.notify("exit", Value::Null);
    assert_eq!(client.ended(), 0);
}

#[test]
fn a_huge_text_is_taken_and_told_to_be_too_long() {
    let mut client = Client::start(capabilities("utf-16"));
    let line = "a = 'x😀'\n";
    let huge = line.repeat((6 << 20) / line.len());
    client.open("untitled:huge", 1, &huge);
    client.open("untitled:1", 1, OVERLAP);
    assert_eq!(client.diagnostics("untitled:1", 1)[0]["code"], "overlap");
    let found = client.diagnostics("untitled:huge", 1);
    assert!(found.iter().any(|diagnostic| diagnostic["code"] == "limit"), "{found:?}");
    assert_eq!(client.text("untitled:huge").len(), huge.len());
    client.finish();
}

#[test]
fn nesting_without_measure_is_a_finding() {
    let mut client = Client::start(capabilities("utf-16"));
    let texts = [
        format!("x = {}1{}\n", "(".repeat(50_000), ")".repeat(50_000)),
        format!("x = {}1\n", "-".repeat(50_000)),
        "def f():\n    return f()\nf()\n".to_string(),
        "x = []\nx.append(x)\nprint(x)\ny = [x]\nwhile True: y = [y, y]\n".to_string(),
    ];
    for (version, text) in (1..).zip(texts) {
        client.open("untitled:1", version, &text);
        assert!(!client.diagnostics("untitled:1", version).is_empty());
        client.is_well();
    }
    client.finish();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn messages_may_be_split_and_joined_anywhere(sizes in prop::collection::vec(1usize..90, 1..40)) {
        let mut client = Client::start(capabilities("utf-16"));
        let item = json!({"uri": "untitled:1", "languageId": "psdl", "version": 1, "text": OVERLAP});
        let messages = [
            json!({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"textDocument": item}}),
            json!({"jsonrpc": "2.0", "id": "t", "method": "psdl/text", "params": {"textDocument": {"uri": "untitled:1"}}}),
            json!({"jsonrpc": "2.0", "id": "u", "method": "psdl/nothing"}),
        ];
        let bytes: Vec<u8> = messages.iter().flat_map(frame).collect();
        let mut rest = bytes.as_slice();
        for size in sizes {
            let (piece, behind) = rest.split_at(size.min(rest.len()));
            client.raw(piece);
            rest = behind;
        }
        client.raw(rest);
        prop_assert_eq!(&client.answer(&json!("t"))["result"]["text"], &json!(OVERLAP));
        prop_assert_eq!(code(&client.answer(&json!("u"))), -32601);
        prop_assert_eq!(&client.diagnostics("untitled:1", 1)[0]["code"], &json!("overlap"));
        client.finish();
    }

    #[test]
    fn noise_between_messages_is_passed_over(noise in prop::collection::vec(any::<u8>(), 0..200)) {
        let mut client = Client::start(capabilities("utf-16"));
        client.raw(&noise);
        // Noise may by chance end in the middle of a header's end; then it takes one message with it.
        client.raw(b"\r\n\r\n");
        client.is_well();
        client.finish();
    }
}
