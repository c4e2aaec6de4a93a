//! Any text: no panic, and no place outside of it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use psdl::syntax::ast::{Ranged, TextRange};
use psdl::syntax::{parse, tune};

fuzz_target!(|text: &str| {
    let inside = |range: TextRange| assert!(text.get(range.start().to_usize()..range.end().to_usize()).is_some(), "{range:?}");
    let parsed = parse(text);
    parsed.errors.iter().for_each(|error| inside(error.range));
    parsed.module.body.iter().for_each(|stmt| inside(stmt.range()));
    let tuning = tune(&parsed, text);
    tuning.constants.iter().for_each(|constant| inside(constant.range));
    tuning.directions.iter().for_each(|direction| inside(direction.range));
});
