//! A request that is taken back, or overtaken by an edit, is answered, and the answer says which of the two.

use super::actions::resolving;
use super::client::Client;
use serde_json::{Value, json};

/// Every value of the constant takes a run of its own, and each run takes its time.
const SLOW: &str = "\
chairs = [Object('Chair', 0.5, 0.5, 1.0) for _ in range(5)]
gap = 0.4
for _ in range(int(gap * 4000000)):
    pass
for i, chair in enumerate(chairs):
    chair.min.x = scene.min.x + i * gap
    chair.center.y = scene.center.y
";
const CANCELLED: i64 = -32800;
const MODIFIED: i64 = -32801;

fn open_slow(mut capabilities: Value) -> Client {
    capabilities["window"] = json!({"workDoneProgress": true});
    let mut client = Client::start(capabilities);
    client.open("untitled:slow", 1, SLOW);
    client.diagnostics("untitled:slow", 1);
    client
}

fn ask_for_fix(client: &mut Client) -> i64 {
    client.ask("psdl/fix", json!({"textDocument": {"uri": "untitled:slow"}, "method": "paper", "workDoneToken": "t"}))
}

fn progress<'a>(kind: &'a str) -> impl Fn(&Value) -> bool + 'a {
    move |message| message["method"] == "$/progress" && message["params"]["value"]["kind"] == kind
}

fn code(answer: &Value) -> i64 {
    answer["error"]["code"].as_i64().unwrap_or_else(|| panic!("no error: {answer}"))
}

#[test]
fn a_request_that_is_taken_back_says_so() {
    let mut client = open_slow(resolving());
    let id = ask_for_fix(&mut client);
    client.wait("the begin", progress("begin"));
    client.notify("$/cancelRequest", json!({"id": id}));
    assert_eq!(code(&client.answer(&json!(id))), CANCELLED);
    client.wait("the end", progress("end"));
    client.is_well();
    client.finish();
}

#[test]
fn work_that_is_ended_by_its_progress_says_so() {
    let mut client = open_slow(resolving());
    let id = ask_for_fix(&mut client);
    client.wait("the begin", progress("begin"));
    client.notify("window/workDoneProgress/cancel", json!({"token": "t"}));
    assert_eq!(code(&client.answer(&json!(id))), CANCELLED);
    client.finish();
}

#[test]
fn an_edit_overtakes_what_is_under_way() {
    let mut client = open_slow(resolving());
    let id = ask_for_fix(&mut client);
    client.wait("the begin", progress("begin"));
    client.change("untitled:slow", 2, json!([{"text": "x = 1\n"}]));
    assert_eq!(code(&client.answer(&json!(id))), MODIFIED);
    client.finish();
}

#[test]
fn what_waits_for_a_run_of_a_document_that_is_closed_is_overtaken() {
    let mut client = Client::start(resolving());
    client.open("untitled:endless", 1, "while True: pass\n");
    let uri = json!({"uri": "untitled:endless"});
    let all = json!({"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}});
    let asked = [
        client.ask("textDocument/codeLens", json!({"textDocument": uri})),
        client.ask("textDocument/inlayHint", json!({"textDocument": uri, "range": all})),
        client.ask("textDocument/codeAction", json!({"textDocument": uri, "range": all, "context": {"diagnostics": []}})),
        client.ask("psdl/layout", json!({"textDocument": uri})),
    ];
    client.close("untitled:endless");
    for id in asked {
        assert_eq!(code(&client.answer(&json!(id))), MODIFIED);
    }
    client.finish();
}
