//! All programs of the workspace at once, and rewritings that touch files.

use super::actions::{actions, resolving};
use super::client::{Client, pulling, uri};
use serde_json::{Value, json};
use std::path::Path;

const WRONG: &str = "a = Object('A', 1, 1, 1)\na.center = (0, 0, 2.5)\n";
const FINE: &str = "a = Object('A', 1, 1, 1)\na.center = (0, 0, 0.5)\n";

fn started(folder: &Path, capabilities: Value) -> Client {
    let mut client = Client::spawn(&[]);
    let folders = json!([{"uri": uri(folder), "name": "w"}]);
    client.request("initialize", json!({"processId": null, "rootUri": null, "capabilities": capabilities, "workspaceFolders": folders}));
    client.notify("initialized", json!({}));
    client
}

/// Name and kind of each report, with the number of its findings.
fn reports(answer: &Value) -> Vec<(String, String, usize)> {
    let name = |item: &Value| item["uri"].as_str().unwrap().rsplit('/').next().unwrap().to_string();
    let items = answer["items"].as_array().unwrap_or_else(|| panic!("{answer}")).iter();
    items.map(|item| (name(item), item["kind"].as_str().unwrap().to_string(), item["items"].as_array().map_or(0, Vec::len))).collect()
}

fn told(name: &str, kind: &str, count: usize) -> (String, String, usize) {
    (name.to_string(), kind.to_string(), count)
}

#[test]
fn what_did_not_change_is_not_sent_again() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    };
    write("a.psdl", WRONG);
    write("b.psdl", FINE);
    write("old/c.psdl", WRONG);
    write("psdl.toml", "exclude = [\"old\"]\n");
    let mut client = started(folder.path(), pulling());
    let ask = |client: &mut Client, known: &Value| {
        let mut answer = client.request("workspace/diagnostic", json!({"identifier": "psdl", "previousResultIds": known}));
        answer["result"].take()
    };
    let first = ask(&mut client, &json!([]));
    assert_eq!(reports(&first), [told("a.psdl", "full", 1), told("b.psdl", "full", 0)]);
    let known: Vec<Value> =
        first["items"].as_array().unwrap().iter().map(|item| json!({"uri": item["uri"], "value": item["resultId"]})).collect();
    let known = json!(known);
    assert_eq!(reports(&ask(&mut client, &known)), [told("a.psdl", "unchanged", 0), told("b.psdl", "unchanged", 0)]);
    write("b.psdl", &FINE.replace("0.5)", "1.75)"));
    assert_eq!(reports(&ask(&mut client, &known)), [told("a.psdl", "unchanged", 0), told("b.psdl", "full", 1)]);
    client.open(&uri(&folder.path().join("a.psdl")), 4, FINE);
    let third = ask(&mut client, &known);
    assert_eq!((reports(&third)[0].clone(), &third["items"][0]["version"]), (told("a.psdl", "full", 0), &json!(4)));
    client.finish();
}

#[test]
fn reports_come_in_pieces_to_those_who_ask_for_that() {
    let folder = tempfile::tempdir().unwrap();
    for index in 0..20 {
        std::fs::write(folder.path().join(format!("{index:02}.psdl")), WRONG).unwrap();
    }
    let mut client = started(folder.path(), pulling());
    let answer = client.request("workspace/diagnostic", json!({"previousResultIds": [], "partialResultToken": "p"}));
    assert_eq!(answer["result"]["items"], json!([]));
    let pieces = client.unread.iter().filter(|message| message["method"] == "$/progress" && message["params"]["token"] == "p");
    let sizes: Vec<usize> = pieces.map(|message| message["params"]["value"]["items"].as_array().unwrap().len()).collect();
    assert_eq!(sizes, [16, 4]);
    client.finish();
}

#[test]
fn a_template_moves_between_program_and_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("room.psdl");
    let mut capabilities = resolving();
    capabilities["workspace"]["workspaceEdit"]["resourceOperations"] = json!(["create", "delete"]);
    let mut client = started(folder.path(), capabilities);
    client.open(&uri(&path), 1, FINE);
    let start = json!({"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 0}});
    let offered = actions(&mut client, &uri(&path), &start, json!(["refactor.rewrite.psdl.template"]));
    let [action] = offered.as_slice() else { panic!("{offered:?}") };
    assert_eq!(action["title"], "Move the template into a file beside the program");
    let changes = action["edit"]["documentChanges"].as_array().unwrap();
    assert_eq!((&changes[1]["kind"], &changes[1]["uri"]), (&json!("create"), &json!(uri(&folder.path().join("room.template.json")))));
    assert!(changes[2]["edits"][0]["newText"].as_str().unwrap().contains("\"id\": \"a\""));
    client.finish();
}

#[test]
fn rewritings_are_offered_where_they_are_asked_for() {
    let mut client = Client::start(resolving());
    let text = "a = Object('A', 1, 1, 1)\na.center = (0, 0, 0.5)\na.min.x = a.max.y = 1\na.facing = 0\n";
    client.open("untitled:1", 1, text);
    let at =
        |line: u32, character: u32| json!({"start": {"line": line, "character": character}, "end": {"line": line, "character": character}});
    let mut titles = |place: Value, only: &str| -> Vec<String> {
        let offered = actions(&mut client, "untitled:1", &place, json!([only]));
        offered.iter().map(|action| action["title"].as_str().unwrap().to_string()).collect()
    };
    assert_eq!(titles(at(3, 11), "refactor"), ["Write X_MAX for 0", "Write X_POS for 0"]);
    assert_eq!(titles(at(2, 21), "refactor.rewrite"), ["Make 1 tunable: 1.0"]);
    assert!(titles(at(2, 21), "refactor.extract").is_empty());
    client.finish();
}
