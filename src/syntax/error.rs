//! What can be wrong with a text.

use ruff_text_size::TextRange;

/// One replacement: the bytes of the range give way to the text.
pub type Edit = (TextRange, String);

/// A change of the text that resolves an error by itself.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fix {
    /// What it does, as a title.
    pub title: String,
    /// Disjoint, in ascending order.
    pub edits: Vec<Edit>,
}

/// What sort of error it is; all of them keep the program from running.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum ErrorKind {
    /// No Python, or Python that its compiler refuses.
    Syntax,
    /// Python, but not part of PSDL (`async`, say).
    LeftOut,
    /// Markdown around the program.
    Fence,
    /// Nested too deep or too long to be handled.
    TooBig,
}

/// One error, at its place in the text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SyntaxError {
    /// What sort.
    pub kind: ErrorKind,
    /// The bytes to underline; may be empty where something is missing.
    pub range: TextRange,
    /// One sentence without a full stop, in CPython's words where it has any.
    pub message: String,
    /// How to get rid of it, where that is certain.
    pub fix: Option<Fix>,
}

impl SyntaxError {
    /// An error of plain syntax.
    pub(crate) fn new(range: TextRange, message: impl Into<String>) -> SyntaxError {
        SyntaxError { kind: ErrorKind::Syntax, range, message: message.into(), fix: None }
    }

    /// Something of Python that PSDL leaves out.
    pub(crate) fn left_out(range: TextRange, what: &str) -> SyntaxError {
        SyntaxError { kind: ErrorKind::LeftOut, range, message: format!("{what} not part of PSDL"), fix: None }
    }

    /// A limit that the text exceeds.
    pub(crate) fn too_big(range: TextRange, message: impl Into<String>) -> SyntaxError {
        SyntaxError { kind: ErrorKind::TooBig, range, message: message.into(), fix: None }
    }
}
