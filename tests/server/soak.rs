//! An hour of typing in short: the server does not grow.

use super::client::{Client, capabilities, memory};
use super::flows::OVERLAP;
use serde_json::{Value, json};

const EDITS: i32 = 2000;

fn at(line: u32, from: u32, to: u32) -> Value {
    json!({"start": {"line": line, "character": from}, "end": {"line": line, "character": to}})
}

#[test]
fn the_server_stays_as_large_as_it_was() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:1", 0, OVERLAP);
    let mut halves = Vec::new();
    for version in 1..=EDITS {
        // A line comes, breaks, is mended and goes.
        let change = match version % 4 {
            1 => json!({"range": at(6, 0, 0), "text": "c = 0.125\n"}),
            2 => json!({"range": at(6, 4, 4), "text": "("}),
            3 => json!({"range": at(6, 4, 5), "text": ""}),
            _ => json!({"range": {"start": {"line": 6, "character": 0}, "end": {"line": 7, "character": 0}}, "text": ""}),
        };
        client.change("untitled:1", version, json!([change]));
        // Now and then the typing is faster than the runs.
        if version % 3 != 0 || version == EDITS {
            client.diagnostics("untitled:1", version);
        }
        if version % (EDITS / 2) == 0 {
            halves.push(memory(client.pid()));
        }
    }
    assert_eq!(client.text("untitled:1"), OVERLAP);
    if let [Some(first), Some(second)] = halves[..] {
        // A megabyte more or less is how allocators are.
        assert!(second <= first + (first / 20).max(1 << 20), "{first} bytes became {second}");
    }
    client.finish();
}
