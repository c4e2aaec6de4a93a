//! One engine for all faces: a program's text → everything there is to say about it.
//!
//! It wires the rooms before it together (parse, run, place, check) and knows how each of them fails; nothing else does.
//!
//! Invariants:
//! - A plain function of its arguments: no I/O, no clock, no threads. Long runs poll a cancel flag.
//! - Every text gets an answer: a layout, or findings that say why there is none.

mod options;

pub use options::{Options, Severities};
