//! Modules that programs may import.

use super::classes::Builtin;
use super::code::Program;
use super::native::Native;
use std::sync::Arc;

pub mod itertools;
pub mod math;
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
        _ => None,
    }
}

/// A module written in Python, compiled; `None` where there is none of that name.
pub fn python_module(_name: &str) -> Option<Arc<Program>> {
    None
}
