//! The first room: text → tree with byte ranges, syntax errors, resolved names, the constants and
//! directions that may be rewritten.
//!
//! It knows nothing of what a program does or what a scene is; it reads text and says what stands
//! where. It is also the only room that calls the parser: others read the tree through [`ast`].
//!
//! Invariants, for every sequence of bytes that is valid UTF-8:
//! - [`parse()`] returns soon, without panic, and never nests deeper than [`MAX_DEPTH`]: what comes
//!   out may be walked (and dropped) by plain recursion, given about 2 MiB of stack.
//! - Every range lies within the text that was given and on character boundaries, whatever line
//!   ends, byte order mark or Markdown fences the text has.
//! - A tree without errors ([`Parsed::is_complete`]) compiles: what CPython's compiler would refuse
//!   is refused here, with its words where it has any.

mod checks;
mod depth;
mod error;
mod fences;
mod line_index;
mod message;
mod parse;
mod resolve;
mod scan;
pub mod scope;
mod suggest;
pub mod tune;

pub use error::{Edit, ErrorKind, Fix, SyntaxError};
pub use line_index::{Encoding, LineColumn, LineIndex};
pub use parse::{MAX_DEPTH, MAX_TEXT, Parsed, parse};
pub use scope::{NameKind, ScopeId, ScopeKind, Scopes};
pub use suggest::suggest;
pub use tune::{ConstantId, DirectionId, Tuning, tune};

/// The nodes of the tree, and the ranges that they carry.
pub mod ast {
    pub use ruff_python_ast::*;
    pub use ruff_text_size::{Ranged, TextRange, TextSize};
}
