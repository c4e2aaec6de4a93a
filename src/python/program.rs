//! From a parsed text to a program that can be run.

use super::code::Program;
use super::compile::{CompileError, compile};
use crate::syntax::{Parsed, Tuning};
use std::sync::Arc;

/// Compiles a program that has no syntax errors.
///
/// # Errors
/// What PSDL leaves out of Python, and programs that are too long.
pub fn build(parsed: &Parsed, text: &str, tuning: &Tuning) -> Result<Arc<Program>, CompileError> {
    parsed.with_stack(|| compile(&parsed.module, text, &parsed.scopes, tuning)).map(Arc::new)
}
