//! Templates and `psdl.toml`, open and on the disk.

use super::client::{Client, capabilities, uri};
use super::flows::OVERLAP;
use serde_json::{Value, json};
use std::path::PathBuf;

pub const TEMPLATE: &str = r#"{"title": "Room", "width": 5, "depth": 6, "height": 3, "interior": true, "objects": [{"id": "desk", "name": "Desk", "width": 1, "depth": 1, "height": 1, "support": "STANDING"}]}"#;
const PLACED: &str = "desk.center.x = 0.0\ndesk.center.y = 0.0\n";

struct Place {
    folder: tempfile::TempDir,
}

impl Place {
    fn new() -> Place {
        Place { folder: tempfile::tempdir().unwrap() }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn uri(&self, name: &str) -> String {
        uri(&self.path(name))
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }
}

fn codes(published: &Value) -> Vec<String> {
    published["diagnostics"].as_array().unwrap().iter().map(|found| found["code"].as_str().unwrap().to_string()).collect()
}

fn saved(client: &mut Client, uri: &str) {
    client.notify("textDocument/didSave", json!({"textDocument": {"uri": uri}}));
}

#[test]
fn an_open_template_takes_the_place_of_the_file() {
    let place = Place::new();
    let (program, template) = (place.uri("a.psdl"), place.uri("a.template.json"));
    place.write("a.template.json", TEMPLATE);
    let mut client = Client::start(capabilities("utf-16"));
    client.open(&program, 1, PLACED);
    assert_eq!(codes(&client.published(&program)), [""; 0]);
    client.open(&template, 1, &TEMPLATE.replace("desk", "table"));
    assert_eq!(codes(&client.published(&program)), ["unknown-name"]);
    client.change(&template, 2, json!([{"text": TEMPLATE.replace("\"width\": 1", "\"width\": 0")}]));
    let wrong = client.wait("the template's errors", |message| {
        message["params"]["uri"] == *template && !codes(&message["params"]).is_empty() && message["params"]["version"] == 2
    });
    assert_eq!(codes(&wrong["params"]), ["template"]);
    client.close(&template);
    let cleared = client.wait("no errors", |message| message["params"]["uri"] == *template && codes(&message["params"]).is_empty());
    assert_eq!(cleared["params"]["version"], Value::Null);
    client.finish();
}

#[test]
fn a_template_is_looked_at_without_its_program() {
    let place = Place::new();
    let template = place.uri("alone.template.json");
    let mut client = Client::start(capabilities("utf-16"));
    client.open(&template, 1, "{\"objects\": [{\"id\": \"1\"}]}");
    let found = client.published(&template);
    assert!(!codes(&found).is_empty() && codes(&found).iter().all(|code| code == "template"), "{found}");
    client.change(&template, 2, json!([{"text": TEMPLATE}]));
    assert!(codes(&client.published(&template)).is_empty());

    // A program on the disk says more: nothing places the desk.
    place.write("alone.psdl", "desk.center.x = 0.0\n");
    client.change(&template, 3, json!([{"text": format!("{TEMPLATE}\n")}]));
    assert_eq!(codes(&client.published(&template)), ["unplaced"]);
    client.close(&template);
    assert!(codes(&client.published(&template)).is_empty());
    client.finish();
}

#[test]
fn a_template_that_is_no_text_is_told() {
    let place = Place::new();
    std::fs::write(place.path("a.template.json"), b"{\"title\": \"\xff\"}").unwrap();
    let mut client = Client::start(capabilities("utf-16"));
    client.open(&place.uri("a.psdl"), 1, PLACED);
    let found = client.published(&place.uri("a.template.json"));
    assert_eq!(codes(&found), ["unreadable"]);
    assert_eq!(found["diagnostics"][0]["range"]["start"], json!({"line": 0, "character": 11}));
    client.finish();
}

#[test]
fn the_configuration_holds_and_its_changes_too() {
    let place = Place::new();
    let program = place.uri("a.psdl");
    place.write("psdl.toml", "severity.overlap = \"warning\"\n");
    let mut client = Client::start(capabilities("utf-16"));
    client.open(&program, 1, OVERLAP);
    assert_eq!(client.diagnostics(&program, 1)[0]["severity"], 2);
    place.write("psdl.toml", "severity.overlap = \"off\"\n");
    client.notify("workspace/didChangeWatchedFiles", json!({"changes": [{"uri": place.uri("psdl.toml"), "type": 2}]}));
    assert_eq!(codes(&client.published(&program)), [""; 0]);
    place.write("psdl.toml", "severity.overlap = \"info\"\n");
    saved(&mut client, &place.uri("psdl.toml"));
    client.wait("the new severity", |message| message["params"]["diagnostics"][0]["severity"] == 3);
    client.finish();
}

#[test]
fn a_wrong_configuration_is_told_at_its_place_and_at_the_program() {
    let place = Place::new();
    let (program, config) = (place.uri("a.psdl"), place.uri("psdl.toml"));
    place.write("psdl.toml", "\nseverity.overlop = \"off\"\n");
    let mut client = Client::start(capabilities("utf-16"));
    client.open(&program, 1, OVERLAP);
    let found = client.published(&program);
    assert_eq!(codes(&found), ["configuration", "overlap"]);
    assert!(found["diagnostics"][0]["message"].as_str().unwrap().contains("psdl.toml:2: "), "{found}");
    let found = client.published(&config);
    assert_eq!(found["diagnostics"][0]["range"]["start"]["line"], 1);

    // What is not yet saved holds.
    client.open(&config, 1, "severity.overlap = \"off\"\n");
    assert_eq!(codes(&client.published(&program)), [""; 0]);
    let cleared = client.wait("no errors", |message| message["params"]["uri"] == *config && codes(&message["params"]).is_empty());
    assert!(cleared["params"]["diagnostics"].is_array());
    client.change(&config, 2, json!([{"text": "severity = 1\n"}]));
    assert_eq!(codes(&client.published(&program)), ["configuration", "overlap"]);
    client.finish();
}

#[test]
fn nothing_is_said_about_what_the_configuration_leaves_out() {
    let place = Place::new();
    place.write("psdl.toml", "exclude = [\"old/\"]\n");
    let (old, new) = (place.uri("old/a.psdl"), place.uri("a.psdl"));
    let mut client = Client::start(capabilities("utf-16"));
    client.open(&old, 1, OVERLAP);
    assert_eq!(codes(&client.published(&old)), [""; 0]);
    client.open(&new, 1, OVERLAP);
    assert_eq!(codes(&client.published(&new)), ["overlap"]);
    client.finish();
}

#[test]
fn changes_on_the_disk_are_noticed_for_a_client_that_does_not_watch() {
    let place = Place::new();
    let program = place.uri("a.psdl");
    let mut client = Client::start(capabilities("utf-16"));
    client.open(&program, 1, OVERLAP);
    assert_eq!(codes(&client.published(&program)), ["overlap"]);
    place.write("psdl.toml", "[severity]\noverlap = \"off\"\n");
    client.wait("no findings", |message| message["params"]["uri"] == *program && codes(&message["params"]).is_empty());
    std::fs::remove_file(place.path("psdl.toml")).unwrap();
    client.wait("the finding", |message| message["params"]["uri"] == *program && codes(&message["params"]) == ["overlap"]);
    client.finish();
}
