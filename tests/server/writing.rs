//! What editors offer while a program is written.

use super::client::{Client, capabilities};
use super::reading::{ROOM, at, open_room, result};
use serde_json::{Value, json};

fn labels(answer: &Value) -> Vec<&str> {
    result(answer)["items"].as_array().unwrap().iter().map(|item| item["label"].as_str().unwrap()).collect()
}

#[test]
fn completion_knows_the_scene_on_a_line_that_does_not_parse() {
    let mut client = open_room();
    let text = format!("{ROOM}chairs[0].facing = ");
    client.change("untitled:room", 2, json!([{"text": text}]));
    let answer = client.request("textDocument/completion", at("untitled:room", &text, "chairs[0].facing = "));
    assert_eq!(labels(&answer)[..7], ["X_MAX", "X_MIN", "Y_MAX", "Y_MIN", "bed", "c", "chairs"]);
    let item = result(&answer)["items"][0].clone();
    let answer = client.request("completionItem/resolve", item);
    assert!(result(&answer)["documentation"]["value"].as_str().unwrap().contains("Direction 0"), "{answer}");
    client.finish();
}

#[test]
fn snippets_are_for_those_who_take_them() {
    let text = format!("{ROOM}agai");
    for (snippets, format) in [(true, 2), (false, 1)] {
        let mut capabilities = capabilities("utf-8");
        capabilities["textDocument"]["completion"]["completionItem"]["snippetSupport"] = json!(snippets);
        let mut client = Client::start(capabilities);
        client.open("untitled:room", 1, ROOM);
        client.diagnostics("untitled:room", 1);
        client.change("untitled:room", 2, json!([{"text": text}]));
        let answer = client.request("textDocument/completion", at("untitled:room", &text, "agai"));
        let item = result(&answer)["items"].as_array().unwrap().iter().find(|item| item["label"] == "against a wall").unwrap().clone();
        assert_eq!(item["insertTextFormat"], format);
        assert_eq!(item["textEdit"]["newText"].as_str().unwrap().contains('$'), snippets, "{item}");
        client.finish();
    }
}

#[test]
fn the_call_that_is_written_shows_its_parameters() {
    let mut client = open_room();
    let text = format!("{ROOM}t = Object(\"T\", height=");
    client.change("untitled:room", 2, json!([{"text": text}]));
    let answer = client.request("textDocument/signatureHelp", at("untitled:room", &text, "height="));
    let help = result(&answer);
    assert_eq!(help["activeParameter"], 3);
    assert!(help["signatures"][0]["label"].as_str().unwrap().starts_with("Object(name, width"), "{help}");
    client.finish();
}
