//! Moving about in a program: where names are bound and used, renaming, outlines, calls, links, colours.

use super::client::{Client, capabilities, uri};
use super::config::TEMPLATE;
use super::reading::{ROOM, at, open_room, result};
use serde_json::{Value, json};

/// Adds the name of what is asked for.
fn with(mut params: Value, key: &str, value: Value) -> Value {
    params[key] = value;
    params
}

/// The text after the edits of one file.
fn edited(text: &str, edits: &Value) -> String {
    let offset = |position: &Value| {
        let line = position["line"].as_u64().unwrap() as usize;
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        start + position["character"].as_u64().unwrap() as usize
    };
    let mut out = text.to_string();
    for edit in edits.as_array().unwrap().iter().rev() {
        out.replace_range(offset(&edit["range"]["start"])..offset(&edit["range"]["end"]), edit["newText"].as_str().unwrap());
    }
    out
}

#[test]
fn names_lead_to_where_they_are_bound_and_used() {
    let mut client = open_room();
    let place = at("untitled:room", ROOM, "bed.max.y + ga");
    let answer = client.request("textDocument/definition", place.clone());
    assert_eq!(result(&answer)[0]["range"]["start"], json!({"line": 6, "character": 11}));
    let answer = client.request("textDocument/references", with(place.clone(), "context", json!({"includeDeclaration": true})));
    assert_eq!(result(&answer).as_array().unwrap().len(), 2);
    let answer = client.request("textDocument/documentHighlight", place);
    let kinds: Vec<&Value> = result(&answer).as_array().unwrap().iter().map(|found| &found["kind"]).collect();
    assert_eq!(kinds, [3, 2]);
    client.finish();
}

#[test]
fn a_variable_is_renamed_and_a_word_of_the_language_is_not() {
    let mut client = open_room();
    let place = at("untitled:room", ROOM, "bed.max.y + ga");
    let answer = client.request("textDocument/prepareRename", place.clone());
    assert_eq!(result(&answer)["placeholder"], "gap");
    let answer = client.request("textDocument/rename", with(place.clone(), "newName", json!("space")));
    let file = &result(&answer)["documentChanges"][0];
    assert_eq!(file["textDocument"], json!({"uri": "untitled:room", "version": 1}));
    assert_eq!(edited(ROOM, &file["edits"]), ROOM.replace("gap", "space"));
    for (place, name) in [(place, "for"), (at("untitled:room", ROOM, "scen"), "room")] {
        let answer = client.request("textDocument/rename", with(place, "newName", json!(name)));
        assert_eq!(answer["error"]["code"], -32803, "{answer}");
    }
    client.finish();
}

#[test]
fn an_id_is_renamed_in_the_program_and_in_the_sidecar() {
    let folder = tempfile::tempdir().unwrap();
    let (program, template) = (uri(&folder.path().join("a.psdl")), uri(&folder.path().join("a.template.json")));
    let text = "desk.center.x = 0.0\ndesk.center.y = 0.0\n";
    std::fs::write(folder.path().join("a.psdl"), text).unwrap();
    std::fs::write(folder.path().join("a.template.json"), TEMPLATE).unwrap();
    let mut client = Client::start(capabilities("utf-16"));
    client.open(&program, 1, text);
    client.diagnostics(&program, 1);
    let both = |answer: &Value| {
        let changes = result(answer)["documentChanges"].as_array().unwrap().clone();
        let of = |name: &str| changes.iter().find(|file| file["textDocument"]["uri"] == *name).unwrap().clone();
        (edited(text, &of(&program)["edits"]), edited(TEMPLATE, &of(&template)["edits"]), of(&template)["textDocument"]["version"].clone())
    };
    let answer = client.request("textDocument/rename", with(at(&program, text, "des"), "newName", json!("table")));
    let expected = (text.replace("desk", "table"), TEMPLATE.replace("\"desk\"", "\"table\""));
    assert_eq!(both(&answer), (expected.0.clone(), expected.1.clone(), Value::Null));
    // The same from the other side, where the sidecar is open.
    client.open(&template, 7, TEMPLATE);
    let answer = client.request("textDocument/rename", with(at(&template, TEMPLATE, "\"id\": \"de"), "newName", json!("table")));
    assert_eq!(both(&answer), (expected.0, expected.1, json!(7)));
    let answer = client.request("textDocument/definition", at(&program, text, "des"));
    assert_eq!(result(&answer)[0]["uri"], json!(template));
    let answer = client
        .request("textDocument/references", with(at(&template, TEMPLATE, "\"id\": \"de"), "context", json!({"includeDeclaration": true})));
    assert_eq!(result(&answer).as_array().unwrap().len(), 3);
    let answer = client.request("textDocument/documentLink", json!({"textDocument": {"uri": program}}));
    let target = result(&answer)[0]["target"].as_str().unwrap();
    assert!(target.starts_with(&template) && target.contains("#L1,"), "{target}");
    client.finish();
}

#[test]
fn the_outline_is_the_scene() {
    let mut client = open_room();
    let answer = client.request("textDocument/documentSymbol", json!({"textDocument": {"uri": "untitled:room"}}));
    let names: Vec<&str> = result(&answer).as_array().unwrap().iter().map(|symbol| symbol["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["Bed", "Chair", "put"]);
    assert_eq!(result(&answer)[1]["children"].as_array().unwrap().len(), 2);
    let answer = client.request("workspace/symbol", json!({"query": "chrs"}));
    let names: Vec<&str> = result(&answer).as_array().unwrap().iter().map(|symbol| symbol["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["chairs[0]", "chairs[1]"]);
    client.finish();
}

#[test]
fn programs_that_are_not_open_are_searched_too() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.psdl"), "def place_lamps(): pass\n").unwrap();
    let mut client = Client::spawn(&[]);
    let folders = json!([{"uri": uri(folder.path()), "name": "a"}]);
    client.request("initialize", json!({"capabilities": capabilities("utf-16"), "workspaceFolders": folders}));
    client.notify("initialized", json!({}));
    let answer = client.request("workspace/symbol", json!({"query": "lamps"}));
    assert_eq!(result(&answer)[0]["name"], "place_lamps");
    client.finish();
}

#[test]
fn blocks_fold_and_selections_grow() {
    let mut client = open_room();
    let answer = client.request("textDocument/foldingRange", json!({"textDocument": {"uri": "untitled:room"}}));
    let lines: Vec<_> =
        result(&answer).as_array().unwrap().iter().map(|fold| (fold["startLine"].clone(), fold["endLine"].clone())).collect();
    assert_eq!(lines, [(json!(6), json!(8)), (json!(9), json!(11))]);
    let place = at("untitled:room", ROOM, "bed.center.x");
    let params = json!({"textDocument": place["textDocument"], "positions": [place["position"]]});
    let answer = client.request("textDocument/selectionRange", params);
    let (mut range, mut depth) = (&result(&answer)[0], 0);
    while range["parent"].is_object() {
        (range, depth) = (&range["parent"], depth + 1);
    }
    assert!(depth >= 3 && range["range"]["start"] == json!({"line": 0, "character": 0}), "{answer}");
    client.finish();
}

#[test]
fn calls_of_functions_that_place_objects() {
    let mut client = open_room();
    let answer = client.request("textDocument/prepareCallHierarchy", at("untitled:room", ROOM, "    pu"));
    let item = result(&answer)[0].clone();
    assert!(item["name"] == "put" && item["detail"].as_str().unwrap().starts_with("places 2 objects"), "{item}");
    let answer = client.request("callHierarchy/incomingCalls", json!({"item": item}));
    assert_eq!(result(&answer)[0]["fromRanges"][0]["start"], json!({"line": 11, "character": 4}));
    let answer = client.request("callHierarchy/outgoingCalls", json!({"item": item}));
    assert_eq!(*result(&answer), json!([]));
    client.finish();
}

#[test]
fn colours_are_shown_and_written() {
    let mut client = open_room();
    let answer = client.request("textDocument/documentColor", json!({"textDocument": {"uri": "untitled:room"}}));
    let color = result(&answer)[0].clone();
    assert_eq!(color["range"]["start"]["line"], 1);
    let params = json!({"textDocument": {"uri": "untitled:room"}, "color": {"red": 1, "green": 0.5, "blue": 0, "alpha": 1}, "range": color["range"]});
    let answer = client.request("textDocument/colorPresentation", params);
    assert_eq!(result(&answer)[0]["textEdit"]["newText"], "FF8000");
    client.finish();
}
