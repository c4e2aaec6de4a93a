//! While the text cannot be run, what was found last stays, where the text has moved it.

use super::client::{Client, capabilities};
use super::flows::OVERLAP;
use serde_json::{Value, json};

fn at(line: u32, from: u32, to: u32) -> Value {
    json!({"start": {"line": line, "character": from}, "end": {"line": line, "character": to}})
}

fn overlap(diagnostics: &[Value]) -> &Value {
    diagnostics.iter().find(|diagnostic| diagnostic["code"] == "overlap").unwrap_or_else(|| panic!("{diagnostics:?}"))
}

#[test]
fn it_moves_with_the_text_and_says_that_it_is_old() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:1", 1, OVERLAP);
    let fresh = client.diagnostics("untitled:1", 1);
    client.change("untitled:1", 2, json!([{"range": at(1, 0, 0), "text": "x = (\n\n"}]));
    let found = client.diagnostics("untitled:1", 2);
    assert!(found.iter().any(|diagnostic| diagnostic["code"] == "syntax-error" && diagnostic["data"]["stale"] == false), "{found:?}");
    let old = overlap(&found);
    assert_eq!(old["data"]["stale"], true);
    assert!(old["message"].as_str().unwrap().contains("(stale:"), "{old}");
    assert_eq!(old["range"]["start"], json!({"line": 7, "character": overlap(&fresh)["range"]["start"]["character"]}));
    assert_eq!(old["relatedInformation"][0]["location"]["range"]["start"]["line"], 5);

    client.change("untitled:1", 3, json!([{"range": at(0, 0, 0), "text": "\n"}]));
    assert_eq!(overlap(&client.diagnostics("untitled:1", 3))["range"]["start"]["line"], 8);

    client.change("untitled:1", 4, json!([{"text": OVERLAP}]));
    assert_eq!(client.diagnostics("untitled:1", 4), fresh);
    client.finish();
}

#[test]
fn it_goes_with_its_line() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:1", 1, OVERLAP);
    client.diagnostics("untitled:1", 1);
    let line = json!({"start": {"line": 5, "character": 0}, "end": {"line": 6, "character": 0}});
    client.change("untitled:1", 2, json!([{"range": line, "text": ""}, {"range": at(0, 0, 0), "text": "("}]));
    let found = client.diagnostics("untitled:1", 2);
    assert!(found.iter().all(|diagnostic| diagnostic["code"] == "syntax-error"), "{found:?}");
    client.finish();
}

#[test]
fn a_new_text_as_a_whole_keeps_what_it_shares_with_the_old() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:1", 1, OVERLAP);
    client.diagnostics("untitled:1", 1);
    client.change("untitled:1", 2, json!([{"text": format!("# a\n(\n{OVERLAP}")}]));
    assert_eq!(overlap(&client.diagnostics("untitled:1", 2))["range"]["start"]["line"], 7);
    client.finish();
}
