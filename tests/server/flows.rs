//! What an editor does all day.

use super::client::{Client, capabilities, uri};
use serde_json::{Value, json};

/// Two chairs in one place; the line of the second holds characters of one, two, three and four bytes.
pub const OVERLAP: &str = "\
set_size(5, 6, 3)
a = Object('Chair', 0.5, 0.5, 1.0, STANDING)
b = Object('Chair', 0.5, 0.5, 1.0, STANDING)
a.center.x = 0.0
a.center.y = 0.0
'aé椅😀'; b.center.x = 0.1
b.center.y = 0.0
";

fn codes(diagnostics: &[Value]) -> Vec<&str> {
    diagnostics.iter().map(|diagnostic| diagnostic["code"].as_str().unwrap()).collect()
}

#[test]
fn columns_are_counted_as_agreed() {
    for (encoding, column) in [("utf-8", 14), ("utf-16", 9), ("utf-32", 8)] {
        let mut client = Client::start(capabilities(encoding));
        client.open("untitled:1", 1, OVERLAP);
        let found = client.diagnostics("untitled:1", 1);
        let overlap = found.iter().find(|diagnostic| diagnostic["code"] == "overlap").unwrap_or_else(|| panic!("{found:?}"));
        assert_eq!(overlap["range"]["start"], json!({"line": 5, "character": column}), "{encoding}");
        client.finish();
    }
}

#[test]
fn an_encoding_that_nobody_knows_is_passed_over() {
    let mut client = Client::spawn(&["--stdio"]);
    let offered = json!({"general": {"positionEncodings": ["utf-7", "utf-32", "utf-8"]}});
    let answer = client.request("initialize", json!({"capabilities": offered}));
    assert_eq!(answer["result"]["capabilities"]["positionEncoding"], "utf-32");
    let mut client = Client::spawn(&[]);
    let answer = client.request("initialize", json!({"capabilities": {}}));
    assert_eq!(answer["result"]["capabilities"]["positionEncoding"], "utf-16");
}

#[test]
fn a_diagnostic_says_all_that_is_known() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:1", 7, &format!("{OVERLAP}spare = 3.25\n"));
    let found = client.diagnostics("untitled:1", 7);
    let of = |code: &str| found.iter().find(|diagnostic| diagnostic["code"] == code).unwrap_or_else(|| panic!("{code} of {found:?}"));
    let overlap = of("overlap");
    assert_eq!((&overlap["source"], &overlap["severity"]), (&json!("psdl"), &json!(1)));
    assert!(overlap["message"].as_str().unwrap().contains("overlaps"), "{overlap}");
    assert!(overlap["codeDescription"]["href"].as_str().unwrap().ends_with("/overlap.md"), "{overlap}");
    assert_eq!(overlap["relatedInformation"][0]["location"]["uri"], "untitled:1");
    assert_eq!(overlap["data"]["stale"], false);
    assert_eq!(overlap["data"]["objects"], json!(["b", "a"]));
    assert_eq!(of("unused-constant")["tags"], json!([1]));
    client.finish();
}

#[test]
fn an_editor_that_shows_less_is_told_less() {
    let mut client = Client::start(json!({}));
    client.open("untitled:1", 1, &format!("{OVERLAP}spare = 3.25\n"));
    for diagnostic in client.diagnostics("untitled:1", 1) {
        for field in ["relatedInformation", "tags", "codeDescription"] {
            assert_eq!(diagnostic.get(field), None, "{diagnostic}");
        }
    }
    client.finish();
}

#[test]
fn an_edit_mends_it() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:1", 1, OVERLAP);
    assert_eq!(codes(&client.diagnostics("untitled:1", 1)), ["overlap"]);
    let range = json!({"start": {"line": 5, "character": 22}, "end": {"line": 5, "character": 23}});
    client.change("untitled:1", 2, json!([{"range": range, "text": "9"}]));
    assert_eq!(client.text("untitled:1").lines().nth(5), Some("'aé椅😀'; b.center.x = 9.1"));
    assert_eq!(codes(&client.diagnostics("untitled:1", 2)), ["out-of-bounds"]);
    client.change("untitled:1", 3, json!([{"range": range, "text": "1"}]));
    assert!(client.diagnostics("untitled:1", 3).is_empty());
    client.close("untitled:1");
    assert_eq!(client.published("untitled:1")["diagnostics"], json!([]));
    client.finish();
}

#[test]
fn a_quick_fix_takes_the_fences_away() {
    let mut client = Client::start(capabilities("utf-16"));
    let fenced = format!("```python\n{OVERLAP}```\n");
    client.open("untitled:1", 4, &fenced);
    let found = client.diagnostics("untitled:1", 4);
    assert_eq!(codes(&found), ["markdown-fence", "markdown-fence"]);
    let ask = |range: &Value, only: Value| json!({"textDocument": {"uri": "untitled:1"}, "range": range, "context": {"diagnostics": [], "only": only}});
    let answer = client.request("textDocument/codeAction", ask(&found[0]["range"], json!(["quickfix"])));
    let [action] = answer["result"].as_array().unwrap().as_slice() else { panic!("{answer}") };
    assert_eq!(action["diagnostics"], json!([found[0]]));
    let edit = &action["edit"]["documentChanges"][0];
    assert_eq!(edit["textDocument"], json!({"uri": "untitled:1", "version": 4}));
    let mut edits = edit["edits"].as_array().unwrap().clone();
    edits.reverse();
    let changes: Vec<Value> = edits.iter().map(|edit| json!({"range": edit["range"], "text": edit["newText"]})).collect();
    client.change("untitled:1", 5, json!(changes));
    assert_eq!(client.text("untitled:1"), OVERLAP);
    assert_eq!(codes(&client.diagnostics("untitled:1", 5)), ["overlap"]);

    let other = client.request("textDocument/codeAction", ask(&found[0]["range"], json!(["refactor"])));
    assert_eq!(other["result"], json!([]));
    client.finish();
}

#[test]
fn a_program_without_an_end_delays_nobody_and_an_edit_ends_it() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:slow", 1, "while True: pass\n");
    client.open("untitled:quick", 1, OVERLAP);
    assert_eq!(codes(&client.diagnostics("untitled:quick", 1)), ["overlap"]);
    client.change("untitled:slow", 2, json!([{"text": OVERLAP}]));
    assert_eq!(codes(&client.diagnostics("untitled:slow", 2)), ["overlap"]);
    client.change("untitled:slow", 3, json!([{"text": "while True: pass\n"}]));
    assert_eq!(codes(&client.diagnostics("untitled:slow", 3)), ["limit"]);
    client.finish();
}

#[test]
fn the_end_is_the_end() {
    let mut asked = Client::start(capabilities("utf-16"));
    asked.open("untitled:slow", 1, "while True: pass\n");
    asked.request("shutdown", Value::Null);
    asked.hang_up();
    assert_eq!(asked.ended(), 0);

    let mut unasked = Client::start(capabilities("utf-16"));
    unasked.open("untitled:slow", 1, "while True: pass\n");
    unasked.notify("exit", Value::Null);
    assert_eq!(unasked.ended(), 1);

    let mut gone = Client::start(capabilities("utf-16"));
    gone.hang_up();
    assert_eq!(gone.ended(), 1);

    let mut unmet = Client::spawn(&[]);
    unmet.notify("exit", Value::Null);
    assert_eq!(unmet.ended(), 1);
}

#[test]
fn the_log_goes_to_a_file_and_holds_nothing_of_the_text() {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("psdl.log");
    let mut client = Client::start_with(&["--log", log.to_str().unwrap(), "--log-level", "trace"], capabilities("utf-16"));
    client.open("untitled:1", 1, "hush = 'xyzzy' + 1\n");
    assert_eq!(codes(&client.diagnostics("untitled:1", 1)), ["exception"]);
    client.notify("textDocument/didChange", json!({"textDocument": "xyzzy"}));
    client.raw(b"Content-Length: 9\r\n\r\n{\"xyzzy\":");
    client.is_well();
    client.finish();
    let log = std::fs::read_to_string(log).unwrap();
    assert!(log.contains("untitled:1: version Some(1), 1 findings"), "{log}");
    assert!(log.contains("refused: textDocument/didChange"), "{log}");
    assert!(!log.contains("xyzzy"), "{log}");
}

#[test]
fn a_client_that_traces_is_told_of_runs() {
    let mut client = Client::start(capabilities("utf-16"));
    client.notify("$/setTrace", json!({"value": "verbose"}));
    client.open("untitled:1", 1, OVERLAP);
    let trace = client.wait("a trace", |message| message["method"] == "$/logTrace");
    assert_eq!(trace["params"]["message"], "untitled:1: 1 findings");
    client.notify("$/setTrace", json!({"value": "off"}));
    client.change("untitled:1", 2, json!([{"text": ""}]));
    client.diagnostics("untitled:1", 2);
    assert!(!client.unread.iter().any(|message| message["method"] == "$/logTrace"));
    client.finish();
}

#[test]
fn a_file_of_another_kind_is_kept_but_not_looked_at() {
    let folder = tempfile::tempdir().unwrap();
    let notes = uri(&folder.path().join("notes.txt"));
    let mut client = Client::start(capabilities("utf-16"));
    let item = json!({"uri": notes, "languageId": "plaintext", "version": 1, "text": "not a program"});
    client.notify("textDocument/didOpen", json!({"textDocument": item}));
    assert_eq!(client.text(&notes), "not a program");
    let range = json!({"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 0}});
    let ask = json!({"textDocument": {"uri": notes}, "range": range, "context": {"diagnostics": []}});
    assert_eq!(client.request("textDocument/codeAction", ask)["result"], Value::Null);
    client.finish();
}
