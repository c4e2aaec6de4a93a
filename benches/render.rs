//! Pictures: `cargo bench --bench render`.
//!
//! The scene with most objects of `PSDL_CORPUS` (a folder), else of the examples, and a made-up scene of 400 objects. Prints medians.

#![allow(missing_docs, clippy::print_stdout)]

use psdl::analysis::{Analysis, Input, Options as Engine, analyse};
use psdl::ide::{self, Scene};
use psdl::render::{Options, Picture, draw};
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

/// Rows of chairs at tables, every tenth chair in its table, on a floor of 40 × 40 m.
const CROWD: &str = "set_title(\"Crowd\")\nset_size(width=40, depth=40, height=4)\n\
    tables = [Object(\"Table\", 1.2, 0.8, 0.75, STANDING) for _ in range(100)]\n\
    chairs = [Object(\"Chair\", 0.45, 0.45, 0.9, STANDING) for _ in range(200)]\n\
    cups = [Object(\"Cup\", 0.1, 0.1, 0.12, STANDING) for _ in range(100)]\n\
    for i, table in enumerate(tables):\n    row, column = divmod(i, 10)\n    table.center.x = -17.0 + 3.6 * column\n    \
    table.center.y = -17.0 + 3.6 * row\n    table.min.z = 0.0\n    table.facing = Y_MAX\n    cups[i].center.x = table.center.x + 0.2\n    \
    cups[i].center.y = table.center.y\n    cups[i].min.z = table.max.z\n    for k in range(2):\n        chair = chairs[2 * i + k]\n        \
    chair.center.x = table.center.x\n        shift = 0.3 if i % 10 == 3 else 0.75\n        \
    chair.center.y = table.center.y + (shift if k else -shift)\n        chair.min.z = 0.0\n        chair.facing = table\n";

fn measure(name: &str, analysis: &Analysis) {
    let layout = analysis.layout.as_ref().expect("a program that runs");
    let rules = Engine::default().rules;
    let picture = Picture { layout, verdict: &analysis.verdict, rules: &rules };
    let large = Options { size: (1200, 1200), ..Options::default() };
    let shown = |what: &str, (ms, bytes): (f64, usize)| println!("  {what:<28} {ms:>7.2} ms  {:>5} kB", bytes / 1000);
    println!("{name}: {} objects, {} errors", layout.objects.len(), analysis.verdict.counted().count());
    shown("drawing list, 1200 × 1200", median(21, || draw(&picture, &large).items.len()));
    shown("PNG, 1200 × 1200", median(21, || draw(&picture, &large).to_png().len()));
    shown("SVG, 1200 × 1200", median(21, || draw(&picture, &large).to_svg().len()));
    shown("mask, 1200 × 1200", median(21, || draw(&picture, &large).id_mask_png().len()));
    let scene = Scene { text: "".into(), layout: layout.clone(), verdict: analysis.verdict.clone(), template: None, partial: false };
    shown("of a hover, 320 × 240", median(21, || ide::picture(&scene, &[0]).map_or(0, |png| png.len())));
}

fn main() {
    let folder = std::env::var("PSDL_CORPUS").unwrap_or_else(|_| concat!(env!("CARGO_MANIFEST_DIR"), "/examples").to_string());
    let mut scenes = Vec::new();
    for entry in std::fs::read_dir(Path::new(&folder)).expect("the folder is there").flatten() {
        let path = entry.path();
        if path.extension().is_some_and(|ending| ending == "psdl") {
            let text = std::fs::read_to_string(&path).expect("a program is UTF-8");
            let template = std::fs::read_to_string(path.with_extension("template.json")).ok();
            let analysis = analyse(&Input { text: &text, template: template.as_deref() }, &Engine::default(), None);
            scenes.push((path.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default(), analysis));
        }
    }
    let objects = |analysis: &Analysis| analysis.layout.as_ref().map_or(0, |layout| layout.objects.len());
    if let Some((name, analysis)) = scenes.iter().max_by_key(|(_, analysis)| objects(analysis)) {
        measure(name, analysis);
    }
    measure("made-up scene", &analyse(&Input { text: CROWD, template: None }, &Engine::default(), None));
}
