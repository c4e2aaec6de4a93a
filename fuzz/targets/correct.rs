//! Any program: a correction never leaves more errors, and a run of the new text says the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use psdl::analysis::{Input, Options};
use psdl::python::vm::Limits;
use psdl::repair::{Problem, Settings, fix};

fuzz_target!(|text: &str| {
    let limits = Limits { steps: 100_000, memory: 32 << 20, recursion: 200, output: 1 << 16 };
    let options = Options { limits, ..Options::default() };
    let Ok(problem) = Problem::new(&Input { text, template: None }, &options) else { return };
    let found = fix(&problem, &Settings { budget: 300, ..Settings::default() });
    assert!(found.errors_after() <= found.errors_before());
    let (layout, verdict) = problem.judge_text(&found.text).expect("the corrected program runs");
    assert_eq!(verdict.loss(), found.after.loss());
    assert_eq!(layout.objects.len(), problem.layout().objects.len());
});
