//! Random typing: the server's text is the client's, and what it says is what a fresh look says.

use super::client::{Client, capabilities, uri};
use proptest::prelude::*;
use psdl::syntax::{Encoding, LineColumn, LineIndex};
use serde_json::{Value, json};
use std::path::Path;
use std::process::Command;

const BASE: &str = "\
# 🪑 und ein Bücherregal\r
set_size(5, 6, 3)
chairs = [Object('Stühle 𝒳', 0.5, 0.5, 1.0, STANDING) for _ in range(3)]
gap = 0.1
for i, chair in enumerate(chairs):
    chair.center.x = scene.min.x + 0.3 + i * gap; chair.center.y = 0.0  # 😀
    chair.facing = Y_MIN
";

/// Pieces that people type and paste.
const PIECES: &[&str] = &[
    "x",
    "0",
    "7",
    ".",
    "5",
    " ",
    "\n",
    "\r\n",
    "\r",
    "    ",
    "(",
    ")",
    "'",
    "#",
    "é",
    "椅",
    "😀",
    "𝒳",
    "🪑🪑",
    "= 1.5",
    "gap",
    "\u{2028}",
    "\t",
    "chairs[0].center.x = 1.25\n",
    "'😀'; chairs[1].center.x = -1.5\n",
    "y = 2.5  # 𝒳\n",
    "chairs[2].facing = 2\n",
    "```\n",
    "# é\r\n",
];

/// An edit, in parts of the text, so that it fits every text.
#[derive(Clone, Debug)]
struct Edit {
    from: f64,
    length: usize,
    whole_lines: bool,
    text: &'static str,
}

fn edit() -> impl Strategy<Value = Edit> {
    let length = prop_oneof![4 => Just(0usize), 3 => 1usize..4, 1 => 4usize..60];
    (0.0..1.0f64, length, any::<bool>(), prop::sample::select(PIECES)).prop_map(|(from, length, whole_lines, text)| Edit {
        from,
        length,
        whole_lines,
        text,
    })
}

/// A character boundary near a byte, not in the middle of a line end: no editor puts a cursor there.
fn boundary(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) || (text[..at].ends_with('\r') && text[at..].starts_with('\n')) {
        at -= 1;
    }
    at
}

fn position(text: &str, at: usize, encoding: Encoding) -> Value {
    // Counted from scratch, not by the index that the server uses.
    let before = &text[..at];
    let breaks = before.char_indices().filter(|(i, ch)| *ch == '\n' || (*ch == '\r' && !text[i + 1..].starts_with('\n')));
    let starts: Vec<usize> = breaks.map(|(i, _)| i + 1).collect();
    let line = &before[starts.last().copied().unwrap_or(0)..];
    let column = match encoding {
        Encoding::Utf8 => line.len(),
        Encoding::Utf16 => line.encode_utf16().count(),
        Encoding::Utf32 => line.chars().count(),
    };
    json!({"line": starts.len(), "character": column})
}

/// Makes the edit, and says it in the words of the protocol.
fn make(text: &mut String, edit: &Edit, encoding: Encoding) -> Value {
    let mut from = boundary(text, (edit.from * text.len() as f64) as usize);
    let mut to = boundary(text, from + edit.length).max(from);
    if edit.whole_lines {
        from = text[..from].rfind('\n').map_or(0, |at| at + 1);
        to = if edit.length > 0 { text[to..].find('\n').map_or(text.len(), |at| to + at + 1) } else { from };
    }
    let range = json!({"start": position(text, from, encoding), "end": position(text, to, encoding)});
    text.replace_range(from..to, edit.text);
    json!({"range": range, "text": edit.text})
}

/// A finding without the way in which it was told: code, severity, words, place in bytes, related places.
type Said = (String, String, String, (u32, u32), Vec<(String, u32)>);

fn told_by_server(text: &str, encoding: Encoding, diagnostics: &[Value]) -> Vec<Said> {
    let index = LineIndex::new(text);
    let offset = |position: &Value| {
        let number = |name: &str| u32::try_from(position[name].as_u64().unwrap()).unwrap();
        index.offset(LineColumn { line: number("line"), column: number("character") }, text, encoding).to_u32()
    };
    let word = |value: &Value| value.as_str().unwrap().to_string();
    let one = |found: &Value| {
        let severity = ["error", "warning", "info"][found["severity"].as_u64().unwrap() as usize - 1];
        let related = found["relatedInformation"].as_array().into_iter().flatten();
        let related = related.map(|related| (word(&related["message"]), offset(&related["location"]["range"]["start"]))).collect();
        let place = (offset(&found["range"]["start"]), offset(&found["range"]["end"]));
        (word(&found["code"]), severity.to_string(), word(&found["message"]), place, related)
    };
    diagnostics.iter().map(one).collect()
}

/// What `psdl check` says about the text of the program itself.
fn told_by_check(file: &Path) -> Vec<Said> {
    let output = Command::new(env!("CARGO_BIN_EXE_psdl")).args(["check", "--format", "json"]).arg(file).output().unwrap();
    let report: Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{output:?}"));
    let word = |value: &Value| value.as_str().unwrap().to_string();
    let offset = |value: &Value| u32::try_from(value["offset"].as_u64().unwrap()).unwrap();
    let one = |found: &Value| {
        let lines: Vec<String> = std::iter::once(&found["message"]).chain(found["notes"].as_array().unwrap()).map(word).collect();
        let related = found["related"].as_array().unwrap().iter();
        let related = related.map(|related| (word(&related["message"]), offset(&related["location"]["start"]))).collect();
        let place = (offset(&found["location"]["start"]), offset(&found["location"]["end"]));
        (word(&found["code"]), word(&found["severity"]), lines.join("\n"), place, related)
    };
    let found = report["files"].as_array().unwrap().iter().flat_map(|file| file["findings"].as_array().unwrap());
    found.filter(|found| found["location"]["path"].as_str().unwrap().ends_with(".psdl")).map(one).collect()
}

fn typed(encoding: Encoding, name: &str, rounds: &[Vec<Edit>]) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("typed.psdl");
    let document = uri(&file);
    let mut text = BASE.to_string();
    let mut client = Client::start(capabilities(name));
    let mut fresh = Client::start(capabilities(name));
    client.open(&document, 0, &text);
    for (version, edits) in (1..).zip(rounds) {
        let changes: Vec<Value> = edits.iter().map(|edit| make(&mut text, edit, encoding)).collect();
        client.change(&document, version, json!(changes));
        assert_eq!(client.text(&document), text);
        if version % 4 != 0 && (version as usize) < rounds.len() {
            continue;
        }
        let found = client.diagnostics(&document, version);
        if !psdl::syntax::parse(&text).is_complete() {
            assert!(found.iter().any(|found| found["data"]["stale"] == false), "{found:?}");
            continue;
        }
        fresh.open(&document, version, &text);
        assert_eq!(found, fresh.diagnostics(&document, version), "{text:?}");
        std::fs::write(&file, &text).unwrap();
        assert_eq!(told_by_server(&text, encoding, &found), told_by_check(&file), "{text:?}");
    }
    client.finish();
    fresh.finish();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, max_shrink_iters: 60, ..ProptestConfig::default() })]

    #[test]
    fn in_bytes(rounds in prop::collection::vec(prop::collection::vec(edit(), 1..4), 1..24)) {
        typed(Encoding::Utf8, "utf-8", &rounds);
    }

    #[test]
    fn in_utf_16(rounds in prop::collection::vec(prop::collection::vec(edit(), 1..4), 1..24)) {
        typed(Encoding::Utf16, "utf-16", &rounds);
    }

    #[test]
    fn in_characters(rounds in prop::collection::vec(prop::collection::vec(edit(), 1..4), 1..24)) {
        typed(Encoding::Utf32, "utf-32", &rounds);
    }
}

#[test]
fn what_is_opened_is_told_as_check_tells_it() {
    let folders = [Some("examples".into()), std::env::var_os("PSDL_CORPUS").map(std::path::PathBuf::from)];
    let mut client = Client::start(capabilities("utf-16"));
    let mut count = 0;
    for folder in folders.into_iter().flatten() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path().canonicalize().unwrap();
            if path.extension().is_none_or(|ending| ending != "psdl") {
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            client.open(&uri(&path), 1, &text);
            let found = client.diagnostics(&uri(&path), 1);
            // Places in the template, which is another document, are left out.
            let bare = |said: Vec<Said>| -> Vec<_> { said.into_iter().map(|said| (said.0, said.1, said.2, said.3)).collect() };
            let told = bare(told_by_check(&path));
            assert_eq!(bare(told_by_server(&text, Encoding::Utf16, &found)), told, "{}", path.display());
            client.close(&uri(&path));
            count += 1;
        }
    }
    assert!(count > 5);
    client.finish();
}
