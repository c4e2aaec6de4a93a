//! Editors that ask for diagnostics get none unasked.

use super::client::{Client, capabilities, pulling, uri};
use super::config::TEMPLATE;
use super::flows::OVERLAP;
use serde_json::{Value, json};

fn pull(client: &mut Client, uri: &str, previous: &Value) -> Value {
    let answer = client.request("textDocument/diagnostic", json!({"textDocument": {"uri": uri}, "previousResultId": previous}));
    assert!(answer["result"].is_object(), "{answer}");
    answer["result"].clone()
}

fn nothing_came_unasked(client: &Client) {
    assert!(client.unread.iter().all(|message| message["method"] != "textDocument/publishDiagnostics"), "{:?}", client.unread);
}

#[test]
fn who_asks_is_answered_for_the_text_as_it_is() {
    let mut client = Client::start(pulling());
    client.open("untitled:1", 1, OVERLAP);
    let first = pull(&mut client, "untitled:1", &Value::Null);
    assert_eq!((&first["kind"], &first["items"][0]["code"]), (&json!("full"), &json!("overlap")));
    let same = pull(&mut client, "untitled:1", &first["resultId"]);
    assert_eq!(same, json!({"kind": "unchanged", "resultId": first["resultId"]}));
    client.change("untitled:1", 2, json!([{"text": ""}]));
    let empty = pull(&mut client, "untitled:1", &first["resultId"]);
    assert_eq!((&empty["kind"], &empty["items"]), (&json!("full"), &json!([])));
    client.change("untitled:1", 3, json!([{"text": OVERLAP}]));
    assert_eq!(pull(&mut client, "untitled:1", &first["resultId"])["kind"], "unchanged");
    client.close("untitled:1");
    nothing_came_unasked(&client);
    client.finish();
}

#[test]
fn the_offer_is_made_to_those_who_can_ask_and_to_no_other() {
    for (capabilities, offered) in [(pulling(), true), (capabilities("utf-8"), false)] {
        let mut client = Client::spawn(&[]);
        let answer = client.request("initialize", json!({"capabilities": capabilities}));
        assert_eq!(answer["result"]["capabilities"]["diagnosticProvider"].is_object(), offered);
        client.finish();
    }
}

#[test]
fn who_asks_many_times_while_a_program_runs_gets_every_answer() {
    let mut client = Client::start(pulling());
    client.open("untitled:slow", 1, "while True: pass\n");
    let asked: Vec<i64> =
        (0..20).map(|_| client.ask("textDocument/diagnostic", json!({"textDocument": {"uri": "untitled:slow"}}))).collect();
    let cancelled = client.ask("textDocument/diagnostic", json!({"textDocument": {"uri": "untitled:slow"}}));
    client.notify("$/cancelRequest", json!({"id": cancelled}));
    client.change("untitled:slow", 2, json!([{"text": OVERLAP}]));
    for id in asked {
        let answer = client.answer(&json!(id));
        let code = &answer["result"]["items"][0]["code"];
        assert!(code == "overlap" || code == "limit", "{answer}");
    }
    let answer = client.answer(&json!(cancelled));
    assert!(answer["error"]["code"] == json!(-32800) || answer["result"].is_object(), "{answer}");
    client.finish();
}

#[test]
fn a_closed_document_answers_those_who_wait() {
    let mut client = Client::start(pulling());
    client.open("untitled:slow", 1, "while True: pass\n");
    let asked = client.ask("textDocument/diagnostic", json!({"textDocument": {"uri": "untitled:slow"}}));
    client.close("untitled:slow");
    let answer = client.answer(&json!(asked));
    assert!(answer["error"].is_object() || answer["result"].is_object(), "{answer}");
    let late = client.request("textDocument/diagnostic", json!({"textDocument": {"uri": "untitled:slow"}}));
    assert_eq!(late["error"]["code"], json!(-32602));
    client.finish();
}

#[test]
fn a_change_of_a_template_makes_the_client_ask_again() {
    let folder = tempfile::tempdir().unwrap();
    let (program, template) = (folder.path().join("a.psdl"), folder.path().join("a.template.json"));
    let mut client = Client::start(pulling());
    client.wait("a registration", |message| message["method"] == "client/registerCapability");
    let text = "desk.center.x = 0.0\ndesk.center.y = 0.0\n";
    client.open(&uri(&program), 1, text);
    assert_eq!(pull(&mut client, &uri(&program), &Value::Null)["items"][0]["code"], "unknown-name");
    std::fs::write(&template, TEMPLATE).unwrap();
    client.notify("workspace/didChangeWatchedFiles", json!({"changes": [{"uri": uri(&template), "type": 1}]}));
    client.wait("a refresh", |message| message["method"] == "workspace/diagnostic/refresh");
    assert_eq!(pull(&mut client, &uri(&program), &Value::Null)["items"], json!([]));

    client.open(&uri(&template), 1, &TEMPLATE.replace("\"width\": 1", "\"width\": 0"));
    client.wait("a refresh", |message| message["method"] == "workspace/diagnostic/refresh");
    let answer = pull(&mut client, &uri(&program), &Value::Null);
    assert_eq!(answer["relatedDocuments"][uri(&template)]["items"][0]["code"], "template", "{answer}");
    let own = pull(&mut client, &uri(&template), &Value::Null);
    assert_eq!(own["items"][0]["code"], "template", "{own}");
    nothing_came_unasked(&client);
    client.finish();
}

#[test]
fn what_is_written_to_the_disk_changes_nothing_about_an_open_document() {
    let folder = tempfile::tempdir().unwrap();
    let program = folder.path().join("a.psdl");
    let mut client = Client::start(pulling());
    client.open(&uri(&program), 1, OVERLAP);
    pull(&mut client, &uri(&program), &Value::Null);
    // A correction is looked for when the editor tells of the file that it has saved.
    let asked = client.ask("psdl/fix", json!({"textDocument": {"uri": uri(&program)}}));
    std::fs::write(&program, OVERLAP).unwrap();
    client.notify("workspace/didChangeWatchedFiles", json!({"changes": [{"uri": uri(&program), "type": 1}]}));
    let answer = client.answer(&json!(asked));
    assert!(answer["result"]["edits"].is_array(), "{answer}");
    client.is_well();
    assert!(client.unread.iter().all(|message| message["method"] != "workspace/diagnostic/refresh"), "{:?}", client.unread);
    client.finish();
}
