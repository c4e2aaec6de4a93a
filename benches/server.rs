//! The language server as an editor feels it, through the real program: from a key to its diagnostics, from the start to
//! the answer to `initialize`, and what 100,000 edits leave behind in memory.
//!
//! `cargo bench --bench server [-- FOLDER…]`: the programs of the folders, of `$PSDL_CORPUS`, or else of `examples`.

#![allow(clippy::print_stdout, reason = "a table on standard output is what it is for")]

#[path = "../tests/server/client.rs"]
mod client;

use client::{Client, capabilities, memory, uri};
use psdl::syntax::{Encoding, LineIndex, parse, tune};
use ruff_text_size::TextSize;
use serde_json::{Value, json};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Keys that are pressed in each program.
const KEYS: i32 = 60;
/// Findings of each program whose actions are asked for, and corrections of it.
const ACTIONS: usize = 8;
const SEARCHES: usize = 3;
/// Places of each program that are asked about.
const PLACES: usize = 24;
/// Edits of the test of endurance.
const EDITS: i32 = 100_000;

/// What is asked about a place.
const ABOUT_PLACES: [&str; 6] = [
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/signatureHelp",
    "textDocument/definition",
    "textDocument/documentHighlight",
    "textDocument/prepareCallHierarchy",
];
/// What is asked about a document.
const ABOUT_ALL: [&str; 6] = [
    "textDocument/semanticTokens/full",
    "textDocument/codeLens",
    "textDocument/foldingRange",
    "textDocument/documentSymbol",
    "textDocument/documentColor",
    "psdl/layout",
];

struct Program {
    /// Names, and behind members' dots.
    names: Vec<Value>,
    /// Constants that may be tuned.
    constants: Vec<Value>,
    name: String,
    uri: String,
    text: String,
    /// Behind the number nearest to the middle of the text.
    middle: Value,
    /// The same with a digit more.
    behind: Value,
}

fn programs() -> Vec<Program> {
    let mut folders: Vec<PathBuf> = std::env::args().skip(1).filter(|arg| !arg.starts_with("--")).map(PathBuf::from).collect();
    if folders.is_empty() {
        folders.push(std::env::var_os("PSDL_CORPUS").map_or_else(|| "examples".into(), PathBuf::from));
    }
    let mut paths: Vec<PathBuf> = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap()).map(|e| e.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "psdl"));
    paths.sort();
    paths.into_iter().filter_map(program).collect()
}

fn program(path: PathBuf) -> Option<Program> {
    let path = path.canonicalize().unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    let parsed = parse(&text);
    let tuning = tune(&parsed, &text);
    let constants = tuning.constants.iter().filter(|constant| constant.excluded.is_none());
    let constant = constants.min_by_key(|constant| constant.range.end().to_usize().abs_diff(text.len() / 2))?;
    let place = LineIndex::new(&text).line_column(constant.range.end(), &text, Encoding::Utf16);
    let position = |more: u32| json!({"line": place.line, "character": place.column + more});
    let lines = LineIndex::new(&text);
    let places = |offsets: Vec<TextSize>| -> Vec<Value> {
        let step = offsets.len().div_ceil(PLACES).max(1);
        let places = offsets.into_iter().step_by(step).map(|offset| lines.line_column(offset, &text, Encoding::Utf16));
        places.map(|place| json!({"line": place.line, "character": place.column})).collect()
    };
    let dots = text.match_indices('.').map(|(at, _)| TextSize::new(at as u32 + 1));
    let names = places(parsed.scopes.occurrences().iter().map(|found| found.range.end()).chain(dots).collect());
    let free = tuning.constants.iter().filter(|constant| constant.excluded.is_none());
    let constants = places(free.map(|constant| constant.range.start()).collect());
    let name = path.file_stem().unwrap().to_string_lossy().into_owned();
    Some(Program { names, constants, name, uri: uri(&path), middle: position(0), behind: position(1), text })
}

/// The edits of a key and of the one that takes it back.
fn key(program: &Program, version: i32) -> Value {
    let (end, text) = if version % 2 == 1 { (&program.middle, "1") } else { (&program.behind, "") };
    json!([{"range": {"start": program.middle, "end": end}, "text": text}])
}

fn at(times: &mut [Duration], part: f64) -> f64 {
    times.sort();
    times[((times.len() - 1) as f64 * part).round() as usize].as_secs_f64() * 1e3
}

fn starts() {
    let mut times: Vec<Duration> = (0..40)
        .map(|_| {
            let start = Instant::now();
            let client = Client::start(capabilities("utf-16"));
            let took = start.elapsed();
            client.finish();
            took
        })
        .collect();
    println!(
        "initialize answered after the start: p50 {:.1} ms, worst {:.1} ms (allowed: 20 ms)\n",
        at(&mut times, 0.5),
        at(&mut times, 1.0)
    );
}

fn keys(programs: &[Program]) {
    println!("{:28} {:>7} {:>9} {:>9} {:>9}", "key to diagnostics", "bytes", "p50 ms", "p99 ms", "worst ms");
    let mut all = Vec::new();
    let mut client = Client::start(capabilities("utf-16"));
    for program in programs {
        client.open(&program.uri, 0, &program.text);
        client.diagnostics(&program.uri, 0);
        let mut times = Vec::new();
        for version in 1..=KEYS {
            let start = Instant::now();
            client.change(&program.uri, version, key(program, version));
            client.diagnostics(&program.uri, version);
            times.push(start.elapsed());
            // Nobody types without a pause.
            std::thread::sleep(Duration::from_millis(2));
        }
        client.close(&program.uri);
        client.published(&program.uri);
        all.extend(&times);
        let (middle, most, worst) = (at(&mut times, 0.5), at(&mut times, 0.99), at(&mut times, 1.0));
        println!("{:28.28} {:7} {middle:9.2} {most:9.2} {worst:9.2}", program.name, program.text.len());
    }
    let (middle, most, worst) = (at(&mut all, 0.5), at(&mut all, 0.99), at(&mut all, 1.0));
    println!("{:28} {:7} {middle:9.2} {most:9.2} {worst:9.2}   (allowed: p99 5 ms)\n", "all", "");
    client.finish();
}

/// The actions for each finding, each after a key, so that nothing is known about the text; and the correction of the whole program.
fn fixes(programs: &[Program]) {
    let mut able = capabilities("utf-16");
    able["textDocument"]["codeAction"] = json!({"dataSupport": true, "resolveSupport": {"properties": ["edit"]}});
    let mut client = Client::start(able);
    let (mut lists, mut searches, mut offered) = (Vec::new(), Vec::new(), 0);
    for program in programs {
        client.open(&program.uri, 0, &program.text);
        let mut version = 0;
        let mut found = client.diagnostics(&program.uri, version);
        let mut press = |client: &mut Client| {
            version += 1;
            client.change(&program.uri, version, key(program, version));
            client.diagnostics(&program.uri, version)
        };
        let ask = |range: &Value, only: Value| json!({"textDocument": {"uri": program.uri}, "range": range, "context": {"diagnostics": [], "only": only}});
        for at in 0..found.len().min(ACTIONS) {
            let Some(range) = found.get(at).map(|finding| finding["range"].clone()) else { break };
            let start = Instant::now();
            let answer = client.request("textDocument/codeAction", ask(&range, Value::Null));
            lists.push(start.elapsed());
            offered += answer["result"].as_array().map_or(0, Vec::len);
            found = press(&mut client);
        }
        for _ in 0..SEARCHES {
            press(&mut client);
            let start = json!({"line": 0, "character": 0});
            let range = json!({"start": start, "end": start});
            let answer = client.request("textDocument/codeAction", ask(&range, json!(["source.fixAll"])));
            let Some(action) = answer["result"].get(0) else { break };
            let start = Instant::now();
            client.request("codeAction/resolve", action.clone());
            searches.push(start.elapsed());
        }
        client.close(&program.uri);
        client.published(&program.uri);
    }
    for (what, times, allowed) in [("code actions for a finding", &mut lists, 20), ("resolve of the whole correction", &mut searches, 60)] {
        if !times.is_empty() {
            let count = times.len();
            let (middle, most, worst) = (at(times, 0.5), at(times, 0.95), at(times, 1.0));
            println!("{what}: {count} times, p50 {middle:.2} ms, p95 {most:.2} ms, worst {worst:.2} ms (allowed: p95 {allowed} ms)");
        }
    }
    println!("{offered} actions were offered\n");
    client.finish();
}

/// Hovers and completions, each after a key, so that nothing is known about the text but its scene.
fn reading(programs: &[Program]) {
    let mut able = capabilities("utf-16");
    for (pictures, allowed) in [(false, 5), (true, 20)] {
        if pictures {
            able["general"]["markdown"] = json!({"parser": "marked"});
        }
        let mut client = Client::start(able.clone());
        let mut times: Vec<(&str, Vec<Duration>)> = Vec::new();
        for program in programs {
            client.open(&program.uri, 0, &program.text);
            client.diagnostics(&program.uri, 0);
            let mut version = 0;
            let mut ask = |client: &mut Client, what: &'static str, method: &str, place: &Value| {
                version += 1;
                client.change(&program.uri, version, key(program, version));
                client.diagnostics(&program.uri, version);
                let start = Instant::now();
                client.request(method, json!({"textDocument": {"uri": program.uri}, "position": place}));
                let took = start.elapsed();
                match times.iter_mut().find(|(known, _)| *known == what) {
                    Some((_, times)) => times.push(took),
                    None => times.push((what, vec![took])),
                }
            };
            for place in &program.names {
                ask(&mut client, "hover over a name", "textDocument/hover", place);
                if !pictures {
                    ask(&mut client, "completion", "textDocument/completion", place);
                }
            }
            for place in program.constants.iter().filter(|_| !pictures) {
                ask(&mut client, "hover over a constant", "textDocument/hover", place);
            }
            client.close(&program.uri);
            client.published(&program.uri);
        }
        for (what, mut times) in times {
            let (count, pictured) = (times.len(), if pictures { ", with a picture" } else { "" });
            let (middle, most, worst) = (at(&mut times, 0.5), at(&mut times, 0.95), at(&mut times, 1.0));
            println!(
                "{what}{pictured}: {count} times, p50 {middle:.2} ms, p95 {most:.2} ms, worst {worst:.2} ms (allowed: p95 {allowed} ms)"
            );
        }
        client.finish();
    }
    println!();
}

/// Asks for everything, and waits for the answers.
fn ask_for_all(client: &mut Client, program: &Program) {
    let document = json!({"uri": program.uri});
    let places = program.names.first().into_iter().chain(program.constants.first());
    let mut ids: Vec<i64> = Vec::new();
    for place in places {
        ids.extend(ABOUT_PLACES.map(|method| client.ask(method, json!({"textDocument": document, "position": place}))));
        let range = json!({"start": place, "end": place});
        let context = json!({"diagnostics": []});
        ids.push(client.ask("textDocument/codeAction", json!({"textDocument": document, "range": range, "context": context})));
        ids.push(client.ask("textDocument/inlayHint", json!({"textDocument": document, "range": range})));
    }
    ids.extend(ABOUT_ALL.map(|method| client.ask(method, json!({"textDocument": document}))));
    ids.into_iter().for_each(|id| drop(client.answer(&json!(id))));
}

fn endurance(programs: &[Program]) {
    let mut able = capabilities("utf-16");
    able["general"]["markdown"] = json!({"parser": "marked"});
    let mut client = Client::start(able);
    for program in programs {
        client.open(&program.uri, 0, &program.text);
        client.diagnostics(&program.uri, 0);
    }
    let mut halves = Vec::new();
    let start = Instant::now();
    for edit in 1..=EDITS {
        let program = &programs[edit as usize / 500 % programs.len()];
        client.change(&program.uri, edit, key(program, edit));
        // Every fifth edit is waited for; those before it may be overtaken.
        if edit % 5 == 0 {
            client.diagnostics(&program.uri, edit);
        }
        // And now and then everything is asked for.
        if edit % 100 == 0 {
            ask_for_all(&mut client, program);
        }
        if edit % (EDITS / 2) == 0 {
            halves.push(memory(client.pid()).unwrap_or(0) as f64 / f64::from(1 << 20));
        }
    }
    println!(
        "{EDITS} edits in {} open programs: {:.1} MB after the first half, {:.1} MB after the second ({:+.1} %), {:.0} s (allowed: +5 %, 80 MB)",
        programs.len(),
        halves[0],
        halves[1],
        (halves[1] / halves[0] - 1.0) * 100.0,
        start.elapsed().as_secs_f64(),
    );
    client.finish();
}

fn main() {
    // `cargo test --benches` only wants to see that it starts.
    if std::env::args().any(|arg| arg == "--test") {
        return;
    }
    let programs = programs();
    starts();
    keys(&programs);
    fixes(&programs);
    reading(&programs);
    endurance(&programs);
}
