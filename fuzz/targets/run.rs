//! Any program: the interpreter ends it within its limits, and every finding lies in the text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use psdl::analysis::{Input, Options, analyse};
use psdl::python::vm::Limits;

fuzz_target!(|text: &str| {
    let limits = Limits { steps: 200_000, memory: 32 << 20, recursion: 200, output: 1 << 16 };
    let options = Options { limits, ..Options::default() };
    for finding in analyse(&Input { text, template: None }, &options, None).findings {
        let range = finding.place.range;
        assert!(text.get(range.start().to_usize()..range.end().to_usize()).is_some(), "{finding:?}");
        assert!(!finding.message.is_empty());
    }
});
