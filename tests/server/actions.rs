//! What is offered to change: titles at once, edits when chosen, and each keeps its word.

use super::client::{Client, capabilities};
use psdl::analysis::{Input, Options, analyse};
use serde_json::{Value, json};

/// Five chairs in a row that is too narrow, and a lamp above the ground.
const ROW: &str = "\
chairs = [Object('Chair', 0.5, 0.5, 1.0) for _ in range(5)]
lamp = Object('Lamp', 0.4, 0.4, 0.5)
gap = 0.4
for i, chair in enumerate(chairs):
    chair.min.x = scene.min.x + i * gap
    chair.center.y = scene.center.y
lamp.center.x = lamp.min.y = 2
lamp.min.z = 0.25
";

/// An editor that asks for edits when an action is chosen.
pub fn resolving() -> Value {
    let mut capabilities = capabilities("utf-16");
    capabilities["textDocument"]["codeAction"] =
        json!({"dataSupport": true, "isPreferredSupport": true, "resolveSupport": {"properties": ["edit"]}});
    capabilities["workspace"]["workspaceEdit"]["changeAnnotationSupport"] = json!({});
    capabilities
}

/// The actions for a range.
pub fn actions(client: &mut Client, uri: &str, range: &Value, only: Value) -> Vec<Value> {
    let params = json!({"textDocument": {"uri": uri}, "range": range, "context": {"diagnostics": [], "only": only}});
    let mut answer = client.request("textDocument/codeAction", params);
    serde_json::from_value(answer["result"].take()).unwrap_or_else(|_| panic!("{answer}"))
}

/// The text after the edits of a document.
pub fn applied(text: &str, version: i32, edit: &Value) -> String {
    let change = &edit["documentChanges"][0];
    assert_eq!(change["textDocument"]["version"], json!(version), "{edit}");
    let offset = |position: &Value| {
        let (line, column) = (position["line"].as_u64().unwrap() as usize, position["character"].as_u64().unwrap() as usize);
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        let mut units = 0;
        let within = text[start..].char_indices().find(|(_, ch)| {
            let found = units >= column;
            units += ch.len_utf16();
            found
        });
        start + within.map_or(text.len() - start, |(at, _)| at)
    };
    let mut edits: Vec<(usize, usize, String)> = change["edits"]
        .as_array()
        .unwrap()
        .iter()
        .map(|edit| (offset(&edit["range"]["start"]), offset(&edit["range"]["end"]), edit["newText"].as_str().unwrap().to_string()))
        .collect();
    edits.sort();
    let mut text = text.to_string();
    for (start, end, new) in edits.into_iter().rev() {
        text.replace_range(start..end, &new);
    }
    text
}

fn errors(text: &str) -> usize {
    analyse(&Input { text, template: None }, &Options::default(), None).verdict.counted().count()
}

fn titles(actions: &[Value]) -> Vec<&str> {
    actions.iter().map(|action| action["title"].as_str().unwrap()).collect()
}

#[test]
fn the_best_edits_stand_beside_a_finding() {
    let mut client = Client::start(resolving());
    client.open("untitled:1", 3, ROW);
    let found = client.diagnostics("untitled:1", 3);
    let overlap = found.iter().find(|diagnostic| diagnostic["code"] == "overlap").unwrap();
    let offered = actions(&mut client, "untitled:1", &overlap["range"], json!(["quickfix"]));
    let best = "Change gap 0.4 → 0.5: clears 4 overlaps, moves 4 chairs";
    let others = ["Fix what can be fixed in the selection", "Fix all 4 overlap errors that can be fixed", "Ignore overlap here"];
    assert_eq!(titles(&offered)[0], best);
    assert_eq!(titles(&offered)[offered.len() - 3..], others);
    let first = &offered[0];
    assert_eq!((&first["isPreferred"], &first["diagnostics"], &first["edit"]), (&json!(true), &json!([overlap]), &Value::Null));
    let chosen = client.request("codeAction/resolve", first.clone());
    let after = applied(ROW, 3, &chosen["result"]["edit"]);
    assert_eq!((after.contains("gap = 0.5\n"), errors(&after)), (true, 1));
    client.finish();
}

#[test]
fn an_editor_that_cannot_ask_later_gets_the_edits_at_once() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:1", 1, ROW);
    let found = client.diagnostics("untitled:1", 1);
    let offered = actions(&mut client, "untitled:1", &found[0]["range"], json!(["quickfix"]));
    assert!(errors(&applied(ROW, 1, &offered[0]["edit"])) < errors(ROW), "{offered:?}");
    let search = offered.iter().find(|action| action["title"].as_str().unwrap().starts_with("Fix all")).unwrap();
    assert_eq!(search["command"]["command"], "psdl.server.fixRange");
    let arguments = search["command"]["arguments"].clone();
    let id = client.ask("workspace/executeCommand", json!({"command": "psdl.server.fixRange", "arguments": arguments}));
    let asked = client.wait("an edit", |message| message["method"] == "workspace/applyEdit");
    assert!(errors(&applied(ROW, 1, &asked["params"]["edit"])) < errors(ROW), "{asked}");
    client.answer(&json!(id));
    client.finish();
}

#[test]
fn an_action_for_an_older_text_is_refused() {
    let mut client = Client::start(resolving());
    client.open("untitled:1", 1, ROW);
    let found = client.diagnostics("untitled:1", 1);
    let offered = actions(&mut client, "untitled:1", &found[0]["range"], json!(["quickfix"]));
    client.change("untitled:1", 2, json!([{"text": format!("{ROW}# more\n")}]));
    assert_eq!(client.request("codeAction/resolve", offered[0].clone())["error"]["code"], json!(-32801));
    assert_eq!(client.request("codeAction/resolve", json!({"title": "of another server"}))["result"]["title"], "of another server");
    client.finish();
}

#[test]
fn the_whole_program_is_fixed_by_one_action() {
    let mut client = Client::start(resolving());
    client.open("untitled:1", 1, ROW);
    let everywhere = json!({"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 0}});
    let offered = actions(&mut client, "untitled:1", &everywhere, json!(["source.fixAll"]));
    assert_eq!(titles(&offered), ["Fix all layout errors that can be fixed"]);
    assert_eq!(offered[0]["kind"], "source.fixAll.psdl");
    let chosen = client.request("codeAction/resolve", offered[0].clone());
    assert_eq!(errors(&applied(ROW, 1, &chosen["result"]["edit"])), 0);
    assert!(actions(&mut client, "untitled:1", &everywhere, json!(["quickfix"])).is_empty());
    client.finish();
}

#[test]
fn an_edit_that_moves_much_is_to_be_looked_at_first() {
    let text = ROW.replace("range(5)", "range(13)").replace("gap = 0.4", "set_size(12, 6, 3)\ngap = 0.4");
    let mut client = Client::start(resolving());
    client.open("untitled:1", 1, &text);
    let found = client.diagnostics("untitled:1", 1);
    let overlap = found.iter().find(|diagnostic| diagnostic["code"] == "overlap").unwrap();
    let offered = actions(&mut client, "untitled:1", &overlap["range"], json!(["quickfix"]));
    let edit = client.request("codeAction/resolve", offered[0].clone())["result"]["edit"].clone();
    assert_eq!(edit["changeAnnotations"]["psdl"]["needsConfirmation"], true, "{edit}");
    assert_eq!(edit["documentChanges"][0]["edits"][0]["annotationId"], "psdl");
    assert_eq!(edit["changeAnnotations"]["psdl"]["label"], offered[0]["title"]);
    client.finish();
}

#[test]
fn a_correction_can_be_asked_for_with_its_progress() {
    let mut client = Client::start(resolving());
    client.open("untitled:1", 7, ROW);
    let answer = client.request("psdl/fix", json!({"textDocument": {"uri": "untitled:1"}, "workDoneToken": "t"}));
    let fix = &answer["result"];
    assert_eq!((&fix["version"], &fix["before"]["errors"], &fix["after"]["errors"]), (&json!(7), &json!(5), &json!(0)), "{answer}");
    assert_eq!(errors(&applied(ROW, 7, &fix["edit"])), 0);
    let titles: Vec<&str> = fix["edits"].as_array().unwrap().iter().map(|edit| edit["title"].as_str().unwrap()).collect();
    assert_eq!(titles, ["Change gap 0.4 → 0.5: clears 4 errors, moves 4 objects", "Change 0.25 → 0.0: clears 1 error, moves 1 object"]);
    let told = |message: &Value| message["method"] == "$/progress" && message["params"]["token"] == "t";
    assert_eq!(client.wait("the begin", told)["params"]["value"]["kind"], "begin");
    client.wait("the end", |message| told(message) && message["params"]["value"]["kind"] == "end");
    let only = json!({"textDocument": {"uri": "untitled:1"}, "kinds": ["standing"]});
    assert_eq!(client.request("psdl/fix", only)["result"]["edits"].as_array().unwrap().len(), 1);
    let wrong = json!({"textDocument": {"uri": "untitled:1"}, "kinds": ["stand"]});
    assert_eq!(client.request("psdl/fix", wrong)["error"]["code"], json!(-32602));
    client.finish();
}

#[test]
fn a_program_that_cannot_be_run_offers_no_search() {
    let mut client = Client::start(resolving());
    client.open("untitled:1", 1, ROW);
    client.diagnostics("untitled:1", 1);
    client.change("untitled:1", 2, json!([{"text": format!("{ROW}x = (\n")}]));
    let found = client.diagnostics("untitled:1", 2);
    let stale = found.iter().find(|diagnostic| diagnostic["data"]["stale"] == true).unwrap();
    assert!(actions(&mut client, "untitled:1", &stale["range"], Value::Null).is_empty());
    assert_eq!(client.request("psdl/fix", json!({"textDocument": {"uri": "untitled:1"}}))["error"]["code"], json!(-32803));
    client.finish();
}
