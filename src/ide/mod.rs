//! What an editor can ask about an analysed program: one file a feature, plain functions over plain data.
//!
//! A feature takes a [`View`] (a [`Program`] as its text stands and the [`Scene`] of the last run that came to something, which
//! may be that of an older text) and a place, and works on a text that does not parse as well as it can.
//!
//! Invariants:
//! - Places are bytes of the program's text. Lines, columns and documents are the business of the caller.
//! - No I/O, no clock, no threads, no types of a protocol: a test is a text with a place in it.
//! - No text and no place makes a feature panic.

mod attributes;
mod calls;
mod colors;
mod complete;
mod constant;
mod context;
mod docs;
mod find;
mod fixes;
mod fold;
mod hints;
mod hover;
mod lab;
mod layout;
mod lens;
mod links;
mod names;
mod picture;
mod program;
mod refactor;
mod rename;
pub mod search;
mod signature;
mod snippets;
mod suppress;
mod symbols;
mod tokens;
mod values;
mod words;

pub use calls::{Caller, function_at, incoming, outgoing};
pub use colors::{Color, colors, presentation, template_colors};
pub use complete::{Completion, CompletionKind, Completions, completions};
pub use constant::about_constant;
pub use docs::{Doc, of as doc_of};
pub use fixes::{QuickFix, quick_fixes, touches};
pub use fold::{Fold, FoldKind, folds, selections};
pub use hints::{Hint, HintKind, Wanted, hints};
pub use hover::{Hover, hover};
pub use lab::{Lab, Offer};
pub use layout::{Places, layout_text, places};
pub use lens::{Lens, LensKind, lenses};
pub use links::{Link, from_template, to_template};
pub use names::{Site, Use, definition, highlights, references, references_of_id};
pub use picture::picture;
pub use program::{Deed, Mark, Program, Scene, View};
pub use refactor::{Ground, Refactoring, RefactoringKind, Sidecar, refactorings};
pub use rename::{At, Refusal, Rename, TemplateText, prepare, rename};
pub use search::Search;
pub use signature::{Signature, signature_help};
pub use snippets::plain_text;
pub use suppress::suppress;
pub use symbols::{Symbol, SymbolKind, flat, symbols};
pub use tokens::{Token, TokenKind, tokens};

#[cfg(test)]
mod tests;
