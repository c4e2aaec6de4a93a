//! From text to findings: `cargo bench --bench analysis`.
//!
//! Programs of `PSDL_CORPUS` (a folder), else the examples; then made-up scenes of 160 and 10,000 objects. Prints medians.

#![allow(missing_docs, clippy::print_stdout)]

use psdl::analysis::{Input, Options, analyse};
use std::path::Path;
use std::time::Instant;

fn median(runs: usize, mut work: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..runs)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64() * 1000.0
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[runs / 2]
}

fn time(text: &str, template: Option<&str>, runs: usize) -> (f64, usize) {
    let (input, options) = (Input { text, template }, Options::default());
    let objects = analyse(&input, &options, None).layout.map_or(0, |l| l.objects.len());
    (median(runs, || drop(analyse(&input, &options, None))), objects)
}

/// A grid of chairs, every tenth of which overlaps its neighbour.
fn grid(count: usize) -> String {
    format!(
        "set_title(\"Grid\")\nset_size(width=200, depth=200, height=4)\n\
         chairs = [Object(\"Chair\", width=0.5, depth=0.5, height=1.0, support=STANDING) for _ in range({count})]\n\
         gap = 1.2\nside = {side}\n\
         for i, chair in enumerate(chairs):\n    row, column = divmod(i, side)\n    shift = 0.9 if i % 10 == 3 else 0.0\n    \
         chair.center.x = scene.min.x + 2.0 + column * gap + shift\n    chair.center.y = scene.min.y + 2.0 + row * gap\n    \
         chair.min.z = scene.min.z\n    chair.facing = Y_MAX\n",
        side = (count as f64).sqrt().ceil()
    )
}

fn main() {
    let folder = std::env::var("PSDL_CORPUS").unwrap_or_else(|_| concat!(env!("CARGO_MANIFEST_DIR"), "/examples").to_string());
    let mut rows = Vec::new();
    for entry in std::fs::read_dir(Path::new(&folder)).expect("the folder is there").flatten() {
        let path = entry.path();
        if path.extension().is_some_and(|e| e == "psdl") {
            let text = std::fs::read_to_string(&path).expect("a program is UTF-8");
            let template = std::fs::read_to_string(path.with_extension("template.json")).ok();
            let (ms, objects) = time(&text, template.as_deref(), 101);
            rows.push((ms, objects, path.file_stem().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()));
        }
    }
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    println!("{} programs of {folder}, text to findings, ms", rows.len());
    println!("  median {:.3}", rows[rows.len() / 2].0);
    for (ms, objects, name) in rows.iter().rev().take(5) {
        println!("  {ms:.3}  {objects:>4} objects  {name}");
    }
    for (count, runs) in [(160, 51), (10_000, 11)] {
        let (ms, objects) = time(&grid(count), None, runs);
        println!("made-up scene of {objects} objects: {ms:.3}");
    }
}
