//! Modules that programs may import.

use super::classes::Builtin;
use super::native::Native;

pub mod itertools;
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
        _ => None,
    }
}
