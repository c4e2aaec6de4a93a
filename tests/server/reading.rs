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
fn nothing_is_told_of_what_is_not_open_or_not_there() {
    let mut client = open_room();
    let answer = client.request("textDocument/hover", at("untitled:other", ROOM, "\nbed"));
    assert_eq!(answer["error"]["code"], -32602, "{answer}");
    let far = json!({"textDocument": {"uri": "untitled:room"}, "position": {"line": 4_000_000_000_u32, "character": 7}});
    assert_eq!(client.request("textDocument/hover", far)["result"], Value::Null);
    client.finish();
}
