//! Layout → each format, and back: `cargo bench --bench export`. Prints medians.
//!
//! The largest scene of `PSDL_CORPUS` (a folder), else of the examples; then a made-up scene of 10,000 objects.

#![allow(missing_docs, clippy::print_stdout)]

use psdl::analysis::{Input, Options, analyse};
use psdl::export::import::{Source, import};
use psdl::export::{Format, Subject, export};
use psdl::syntax::LineIndex;
use std::path::Path;
use std::time::Instant;

fn median(runs: usize, mut work: impl FnMut() -> usize) -> (f64, usize) {
    let mut bytes = 0;
    let mut times: Vec<f64> = (0..runs)
        .map(|_| {
            let start = Instant::now();
            bytes = work();
            start.elapsed().as_secs_f64() * 1000.0
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[runs / 2], bytes)
}

fn measure(name: &str, text: &str, runs: usize) {
    let analysis = analyse(&Input { text, template: None }, &Options::default(), None);
    let layout = analysis.layout.as_ref().expect("a layout");
    println!("{name}, {} objects", layout.objects.len());
    let write = |format| {
        let lines = LineIndex::new(text);
        let line_of = |offset| lines.line(offset) as usize + 1;
        let constants = analysis.prepared.tuning.constants.len();
        export(format, &Subject { layout, verdict: &analysis.verdict, findings: &analysis.findings, constants, line_of: &line_of }, None)
            .bytes
    };
    for (format, label, _) in Format::ALL {
        let (ms, bytes) = median(runs, || write(format).len());
        println!("  {label:<12}{ms:8.3} ms  {bytes:>9} bytes");
    }
    for (format, source, label) in [(Format::Layout, Source::Layout, "layout"), (Format::Visualizer, Source::Visualizer, "visualizer")] {
        let file = String::from_utf8(write(format)).expect("UTF-8");
        let (ms, bytes) = median(runs, || import(&file, source).expect("a scene").len());
        println!("  import {label:<12}{ms:8.3} ms  {bytes:>9} bytes");
    }
}

fn main() {
    let folder = std::env::var("PSDL_CORPUS").unwrap_or_else(|_| concat!(env!("CARGO_MANIFEST_DIR"), "/examples").to_string());
    let entries = std::fs::read_dir(Path::new(&folder)).expect("the folder is there").flatten();
    let programs = entries.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|end| end == "psdl"));
    let objects =
        |text: &str| analyse(&Input { text, template: None }, &Options::default(), None).layout.map_or(0, |layout| layout.objects.len());
    let texts = programs.map(|path| (std::fs::read_to_string(&path).expect("a program is UTF-8"), path));
    let (largest, path) = texts.max_by_key(|(text, _)| objects(text)).expect("a program");
    measure(&path.display().to_string(), &largest, 101);
    measure("made-up scene", include_str!("../tests/foreign/scenes/many.psdl"), 11);
}
