//! Text of values: number formatting, format specs, `%`, `str.format`, reprs of strings, encodings.
//!
//! Invariants: what is written is CPython's, to the last character; a width or precision that the program chooses is asked of the
//! machine (`Vm::reserve`) before anything of that size is built. A string holds no lone surrogates: Rust's cannot, so what would make one
//! is an error or U+FFFD. Must not know: the scene, the trace (who formats a traced number pins it here).

pub mod unicode;
