//! What editors show about a program that they read.

use super::client::{Client, capabilities};
use serde_json::{Value, json};

/// A small room with an error.
pub const ROOM: &str = "\
set_size(4, 4, 3)
bed = Object(\"Bed\", 2, 1, 1, color=\"4169E1\")
chairs = [Object(\"Chair\", 1, 1, 1) for _ in range(2)]
bed.center.x = scene.center.x + 0.5
bed.min.y = scene.min.y
bed.facing = Y_MAX
def put(o, gap=0.25):
    o.min.y = bed.max.y + gap
    o.facing = bed
for i, c in enumerate(chairs):
    c.center.x = 0.5 * i
    put(c)
";

/// A question about the place right behind `mark` (plus some columns) in the room.
pub fn at(uri: &str, text: &str, mark: &str) -> Value {
    let offset = text.find(mark).unwrap_or_else(|| panic!("no {mark}")) + mark.len();
    let line = text[..offset].matches('\n').count();
    let column = offset - text[..offset].rfind('\n').map_or(0, |at| at + 1);
    json!({"textDocument": {"uri": uri}, "position": {"line": line, "character": column}})
}

/// A client that has the room open.
pub fn open_room() -> Client {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:room", 1, ROOM);
    client.diagnostics("untitled:room", 1);
    client
}

pub fn result(answer: &Value) -> &Value {
    assert!(answer.get("error").is_none(), "{answer}");
    &answer["result"]
}

#[test]
fn a_hover_tells_of_the_object() {
    let mut client = open_room();
    let answer = client.request("textDocument/hover", at("untitled:room", ROOM, "\nbed"));
    let hover = result(&answer);
    let text = hover["contents"]["value"].as_str().unwrap();
    assert!(text.contains("**`bed`** · Bed · standing"), "{text}");
    assert_eq!(hover["range"], json!({"start": {"line": 1, "character": 0}, "end": {"line": 1, "character": 3}}));
    // While the text does not parse, of the last run.
    let broken = ROOM.replace("bed.facing = Y_MAX", "bed.facing = (");
    client.change("untitled:room", 2, json!([{"text": broken}]));
    let answer = client.request("textDocument/hover", at("untitled:room", &broken, "\nbed"));
    assert!(answer["result"]["contents"]["value"].as_str().unwrap().contains("of the last run"), "{answer}");
    client.finish();
}

#[test]
fn a_hover_over_a_constant_tells_what_it_moves_and_where_no_errors_are() {
    let mut client = open_room();
    let answer = client.request("textDocument/hover", at("untitled:room", ROOM, "gap=0.25"));
    let text = result(&answer)["contents"]["value"].as_str().unwrap();
    assert!(text.contains("moves 2 objects; for each +1:\n- `chairs[0]`, `chairs[1]`: y + 1 m"), "{text}");
    assert!(text.contains("no value near is without errors") && text.contains("1 error now"), "{text}");
    // The text has become another: the constant is told of as soon as that has been run.
    let apart = ROOM.replace("0.5 * i", "1.5 * i");
    client.change("untitled:room", 2, json!([{"text": apart}]));
    client.diagnostics("untitled:room", 2);
    let answer = client.request("textDocument/hover", at("untitled:room", &apart, "gap=0.25"));
    let text = result(&answer)["contents"]["value"].as_str().unwrap();
    assert!(text.contains("no errors from −0.01 to 2.0"), "{text}");
    client.finish();
}

#[test]
fn a_hover_has_a_picture_where_it_can_be_shown() {
    for (markdown, shown) in [(json!({"parser": "marked"}), true), (Value::Null, false)] {
        let mut capabilities = capabilities("utf-16");
        capabilities["general"]["markdown"] = markdown;
        let mut client = Client::start(capabilities);
        client.open("untitled:room", 1, ROOM);
        client.diagnostics("untitled:room", 1);
        let answer = client.request("textDocument/hover", at("untitled:room", ROOM, "\nbed"));
        let text = answer["result"]["contents"]["value"].as_str().unwrap();
        assert_eq!(text.contains("data:image/png;base64,iVBOR"), shown, "{text}");
        client.notify("workspace/didChangeConfiguration", json!({"settings": {"hover": {"picture": false}}}));
        let answer = client.request("textDocument/hover", at("untitled:room", ROOM, "\nbed"));
        assert!(!answer["result"]["contents"]["value"].as_str().unwrap().contains("data:"));
        client.finish();
    }
}

#[test]
fn nothing_is_told_of_what_is_not_open_or_not_there() {
    let mut client = open_room();
    let answer = client.request("textDocument/hover", at("untitled:other", ROOM, "\nbed"));
    assert_eq!(answer["error"]["code"], -32602, "{answer}");
    let far = json!({"textDocument": {"uri": "untitled:room"}, "position": {"line": 4_000_000_000_u32, "character": 7}});
    assert_eq!(client.request("textDocument/hover", far)["result"], Value::Null);
    client.finish();
}

fn whole() -> Value {
    json!({"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}})
}

#[test]
fn hints_tell_where_things_are_unless_the_user_wants_none() {
    let mut client = open_room();
    let ask = |client: &mut Client| {
        let answer = client.request("textDocument/inlayHint", json!({"textDocument": {"uri": "untitled:room"}, "range": whole()}));
        let labels = result(&answer).as_array().unwrap().iter().map(|hint| hint["label"].as_str().unwrap().to_string());
        labels.collect::<Vec<_>>()
    };
    let labels = ask(&mut client);
    assert!(labels.contains(&"→ 0.5".into()) && labels.iter().any(|label| label.starts_with("2 objects")), "{labels:?}");
    let settings = json!({"psdl": {"inlayHints": {"coordinates": false, "loops": false, "facings": false}}});
    client.notify("workspace/didChangeConfiguration", json!({"settings": settings}));
    assert_eq!(ask(&mut client), [""; 0]);
    client.finish();
}

#[test]
fn settings_come_with_the_start_and_are_asked_for() {
    let mut capabilities = capabilities("utf-16");
    capabilities["workspace"]["configuration"] = json!(true);
    capabilities["workspace"]["codeLens"] = json!({"refreshSupport": true});
    let mut client = Client::spawn(&[]);
    client.request("initialize", json!({"capabilities": capabilities, "initializationOptions": {"codeLens": false}}));
    client.open("untitled:room", 1, ROOM);
    let lenses = |client: &mut Client| {
        let answer = client.request("textDocument/codeLens", json!({"textDocument": {"uri": "untitled:room"}}));
        result(&answer).as_array().unwrap().len()
    };
    assert_eq!(lenses(&mut client), 0);
    client.notify("initialized", json!({}));
    let asked = client.wait("a question for settings", |message| message["method"] == "workspace/configuration");
    assert_eq!(asked["params"]["items"], json!([{"section": "psdl"}]));
    client.finish();
}

#[test]
fn lenses_count_and_correct() {
    let mut client = open_room();
    let answer = client.request("textDocument/codeLens", json!({"textDocument": {"uri": "untitled:room"}}));
    let commands: Vec<_> = result(&answer).as_array().unwrap().iter().map(|lens| lens["command"].clone()).collect();
    assert!(commands[0]["title"].as_str().unwrap().starts_with("3 objects · "), "{commands:?}");
    assert!(commands.iter().any(|command| command["command"] == "psdl.server.fixAll" && command["arguments"] == json!(["untitled:room"])));
    assert!(commands.iter().any(|command| command["title"].as_str().unwrap().starts_with("1 call · 2 objects")), "{commands:?}");
    client.finish();
}

/// Applies the edits of a delta to the numbers of before.
fn patched(mut data: Vec<Value>, edits: &Value) -> Vec<Value> {
    for edit in edits.as_array().unwrap().iter().rev() {
        let (start, count) = (edit["start"].as_u64().unwrap() as usize, edit["deleteCount"].as_u64().unwrap() as usize);
        data.splice(start..start + count, edit["data"].as_array().cloned().unwrap_or_default());
    }
    data
}

#[test]
fn words_are_coloured_and_then_only_what_changed() {
    let mut client = open_room();
    let document = json!({"uri": "untitled:room"});
    let answer = client.request("textDocument/semanticTokens/full", json!({"textDocument": document}));
    let full = result(&answer).clone();
    let data = full["data"].as_array().unwrap().clone();
    assert!(data.len() > 100 && data.len().is_multiple_of(5));
    client.change("untitled:room", 2, json!([{"text": ROOM.replace("gap=0.25", "space=0.25").replace("+ gap", "+ space")}]));
    let params = json!({"textDocument": document, "previousResultId": full["resultId"]});
    let answer = client.request("textDocument/semanticTokens/full/delta", params);
    let delta = result(&answer).clone();
    let answer = client.request("textDocument/semanticTokens/full", json!({"textDocument": document}));
    assert_eq!(patched(data, &delta["edits"]), *result(&answer)["data"].as_array().unwrap());
    // Of an older result nothing is known any more.
    let params = json!({"textDocument": document, "previousResultId": full["resultId"]});
    assert!(result(&client.request("textDocument/semanticTokens/full/delta", params))["data"].is_array());
    let range = json!({"start": {"line": 1, "character": 0}, "end": {"line": 2, "character": 0}});
    let answer = client.request("textDocument/semanticTokens/range", json!({"textDocument": document, "range": range}));
    assert!(result(&answer)["data"].as_array().unwrap().len() < 100);
    client.finish();
}
