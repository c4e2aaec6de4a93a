//! Modules that programs may import.

use super::classes::Builtin;
use super::code::Program;
use super::native::Native;
use std::sync::{Arc, OnceLock};

pub mod itertools;
pub mod math;
pub mod operator;
pub mod random;

/// What a native module binds a name to.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub enum Item {
    Native(&'static Native),
    Float(f64),
    Int(i64),
    Class(Builtin),
}

/// The names of a module written in Rust; `None` where there is none of that name.
pub fn native_module(name: &str) -> Option<&'static [(&'static str, Item)]> {
    match name {
        "itertools" => Some(itertools::ITEMS),
        "math" => Some(math::ITEMS),
        "_operator" => Some(operator::ITEMS),
        "_random" => Some(random::ITEMS),
        _ => None,
    }
}

/// The modules written in Python, by name.
const SOURCES: &[(&str, &str)] = &[
    ("_abc", include_str!("../lib/_abc.py")),
    ("_binding", include_str!("../lib/_binding.py")),
    ("_collections_abc", include_str!("../lib/_collections_abc.py")),
    ("_collections_counter", include_str!("../lib/_collections_counter.py")),
    ("_collections_user", include_str!("../lib/_collections_user.py")),
    ("_enum_checks", include_str!("../lib/_enum_checks.py")),
    ("_fraction", include_str!("../lib/_fraction.py")),
    ("_normal_dist", include_str!("../lib/_normal_dist.py")),
    ("_singledispatch", include_str!("../lib/_singledispatch.py")),
    ("_types", include_str!("../lib/_types.py")),
    ("_typing_helpers", include_str!("../lib/_typing_helpers.py")),
    ("_typing_protocol", include_str!("../lib/_typing_protocol.py")),
    ("_typing_rare", include_str!("../lib/_typing_rare.py")),
    ("_typing_records", include_str!("../lib/_typing_records.py")),
    ("collections", include_str!("../lib/collections.py")),
    ("copy", include_str!("../lib/copy.py")),
    ("dataclasses", include_str!("../lib/dataclasses.py")),
    ("enum", include_str!("../lib/enum.py")),
    ("functools", include_str!("../lib/functools.py")),
    ("operator", include_str!("../lib/operator.py")),
    ("random", include_str!("../lib/random.py")),
    ("statistics", include_str!("../lib/statistics.py")),
    ("string", include_str!("../lib/string.py")),
    ("typing", include_str!("../lib/typing.py")),
];

static PROGRAMS: [OnceLock<Option<Arc<Program>>>; SOURCES.len()] = [const { OnceLock::new() }; SOURCES.len()];

/// A module written in Python, compiled once in a process; `None` where there is none of that name.
pub fn python_module(name: &str) -> Option<Arc<Program>> {
    let at = SOURCES.iter().position(|s| s.0 == name)?;
    PROGRAMS[at].get_or_init(|| compiled(SOURCES[at].1)).clone()
}

fn compiled(text: &str) -> Option<Arc<Program>> {
    let parsed = crate::syntax::parse(text);
    if !parsed.is_complete() {
        return None;
    }
    super::program::build(&parsed, text, &crate::syntax::Tuning::default()).ok()
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_module_that_comes_with_psdl_compiles() {
        for (name, _) in super::SOURCES {
            assert!(super::python_module(name).is_some(), "{name}");
        }
    }
}
