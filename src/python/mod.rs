//! A small, exact, limited Python: tree → effects on a [`host::Host`].
//!
//! The semantics are CPython 3.11's. A program is compiled once (`compile`) to a stack machine (`vm`) whose objects live in a
//! [`heap`] of typed arenas. Invariants: the same program gives the same effects, on every platform; nothing outside the host and the
//! output can be reached; no program can panic, hang, overflow the stack or exhaust memory. Must not know: scenes, editors, files.

pub mod builtins;
pub mod classes;
pub mod code;
pub mod compile;
pub mod error;
pub mod frame;
mod gc;
pub mod hashing;
pub mod heap;
pub mod host;
pub mod items;
pub mod iter;
pub mod iterate;
pub mod modules;
pub mod native;
pub mod numbers;
pub mod program;
#[cfg(test)]
mod recorded;
pub mod symbols;
pub mod table;
pub mod text;
pub mod types;
pub mod value;
pub mod vm;
