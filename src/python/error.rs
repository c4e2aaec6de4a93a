//! How a run leaves the ordinary path: a Python exception, or a stop that no program can catch.

use super::value::Value;

/// The result of everything that may raise.
pub type R<T> = Result<T, Raise>;

/// What ends an operation early.
#[derive(Clone, Copy, Debug)]
pub enum Raise {
    /// A Python exception: an instance of a subclass of `BaseException`.
    Exception(Value),
    /// The end of the whole run; no `except` or `finally` sees it.
    Stop(Stop),
}

/// Why a run was stopped from outside the program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stop {
    /// More steps than the budget.
    Steps,
    /// More output than the budget.
    Output,
    /// Someone asked for it.
    Cancelled,
}
