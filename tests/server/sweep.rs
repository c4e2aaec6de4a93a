//! Everything is asked at every place of programs, whole and half typed: nothing fails but what is said to.

use super::client::{Client, capabilities};
use serde_json::{Value, json};

/// Objects, a loop, a function, a class, an f-string, a frame, a colour, letters of one to four bytes.
const PROGRAM: &str = "\
set_size(4, 4, 3)
from dataclasses import dataclass
bed = Object('Bett 😀', 2, 1, 1, color='4169E1')
é椅 = [Object('椅', 0.5, 0.5, 1) for _ in range(2)]
@dataclass
class Slot:
    gap: float = 0.25
def put(o, n, slot=Slot(gap=0.5)):
    '''Puts 𝒙.'''
    o.min.y = bed.max.y + slot.gap * n
    o.facing = bed
bed.center.x = bed.min.y = -0.5
set_coordinate_frame(bed)
for i, c in enumerate(é椅):
    c.center.x = 0.5 * i; put(c, n=i)
set_coordinate_frame(scene)
bed.facing = 3
print(f'{bed.name!r:>{8}} 😀 {é椅[0].min.x:.2f}')
";

/// What may be refused with a reason.
const REFUSED: [&str; 2] = ["textDocument/prepareRename", "textDocument/rename"];
const REQUEST_FAILED: i64 = -32803;

fn units(ch: char, encoding: &str) -> usize {
    match encoding {
        "utf-8" => ch.len_utf8(),
        "utf-16" => ch.len_utf16(),
        _ => 1,
    }
}

/// All positions of a text, also between the halves of a character and behind the ends of lines.
fn positions(text: &str, encoding: &str) -> Vec<Value> {
    let of_line = |(line, content): (usize, &str)| {
        let length: usize = content.chars().map(|ch| units(ch, encoding)).sum();
        (0..=length + 1).map(move |character| json!({"line": line, "character": character})).collect::<Vec<_>>()
    };
    text.split('\n').enumerate().flat_map(of_line).collect()
}

/// Asks all about a place; the answers are waited for.
fn ask_at(client: &mut Client, uri: &str, position: &Value) {
    let document = json!({"uri": uri});
    let at = json!({"textDocument": document, "position": position});
    let with = |more: Value| {
        let mut params = at.clone();
        params.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        params
    };
    let range = json!({"start": position, "end": position});
    let requests = [
        ("textDocument/hover", at.clone()),
        ("textDocument/completion", at.clone()),
        ("textDocument/signatureHelp", at.clone()),
        ("textDocument/definition", at.clone()),
        ("textDocument/documentHighlight", at.clone()),
        ("textDocument/prepareCallHierarchy", at.clone()),
        ("textDocument/prepareRename", at.clone()),
        ("textDocument/references", with(json!({"context": {"includeDeclaration": true}}))),
        ("textDocument/rename", with(json!({"newName": "quite_new"}))),
        ("textDocument/selectionRange", json!({"textDocument": document, "positions": [position]})),
        ("textDocument/semanticTokens/range", json!({"textDocument": document, "range": range})),
    ];
    ask(client, &requests);
}

/// Asks all about a whole document.
fn ask_about(client: &mut Client, uri: &str) {
    let document = json!({"uri": uri});
    let of = json!({"textDocument": document});
    let all = json!({"start": {"line": 0, "character": 0}, "end": {"line": 999, "character": 0}});
    let requests = [
        ("textDocument/semanticTokens/full", of.clone()),
        ("textDocument/semanticTokens/full/delta", json!({"textDocument": document, "previousResultId": "1"})),
        ("textDocument/inlayHint", json!({"textDocument": document, "range": all})),
        ("textDocument/codeLens", of.clone()),
        ("textDocument/foldingRange", of.clone()),
        ("textDocument/documentSymbol", of.clone()),
        ("textDocument/documentColor", of.clone()),
        ("textDocument/documentLink", of.clone()),
        ("textDocument/codeAction", json!({"textDocument": document, "range": all, "context": {"diagnostics": []}})),
        ("workspace/symbol", json!({"query": "e"})),
        ("psdl/layout", of.clone()),
    ];
    ask(client, &requests);
}

fn ask(client: &mut Client, requests: &[(&str, Value)]) {
    let ids: Vec<i64> = requests.iter().map(|(method, params)| client.ask(method, params.clone())).collect();
    for (id, (method, params)) in ids.into_iter().zip(requests) {
        let answer = client.answer(&json!(id));
        let allowed = REFUSED.contains(method) && answer["error"]["code"] == json!(REQUEST_FAILED);
        assert!(answer.get("error").is_none() || allowed, "{method} {params}: {answer}");
    }
}

#[test]
fn every_place_can_be_asked_about_in_every_encoding() {
    for (encoding, step) in [("utf-16", 1), ("utf-8", 7), ("utf-32", 7)] {
        let mut client = Client::start(capabilities(encoding));
        client.open("untitled:1", 1, PROGRAM);
        client.diagnostics("untitled:1", 1);
        ask_about(&mut client, "untitled:1");
        positions(PROGRAM, encoding).iter().step_by(step).for_each(|position| ask_at(&mut client, "untitled:1", position));
        client.finish();
    }
}

#[test]
fn half_typed_programs_can_be_asked_about_while_they_are_typed() {
    let mut client = Client::start(capabilities("utf-16"));
    client.open("untitled:1", 0, PROGRAM);
    client.diagnostics("untitled:1", 0);
    let cuts = PROGRAM.char_indices().map(|(at, _)| at).step_by(13);
    for (version, cut) in (1..).zip(cuts) {
        // Cut off at the cursor, or with a piece missing behind it.
        let behind = PROGRAM.ceil_char_boundary((cut + 11).min(PROGRAM.len()));
        let rest = if version % 2 == 0 { &PROGRAM[behind..] } else { "" };
        let text = format!("{}{rest}", &PROGRAM[..cut]);
        client.change("untitled:1", version, json!([{"text": text}]));
        let before = &text[..cut];
        let line = before.matches('\n').count();
        let character = before[before.rfind('\n').map_or(0, |at| at + 1)..].encode_utf16().count();
        ask_at(&mut client, "untitled:1", &json!({"line": line, "character": character}));
        if version % 8 == 0 {
            ask_about(&mut client, "untitled:1");
        }
    }
    client.is_well();
    client.finish();
}
