//! What holds for an analysis.

use crate::check::Rules;
use crate::check::finding::{Code, Severity};
use crate::python::vm::Limits;
use std::collections::BTreeMap;

/// How a program is run and what counts as an error. The default is the specification.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Options {
    /// The budget of the run.
    pub limits: Limits,
    /// Tolerances and weights.
    pub rules: Rules,
    /// What each kind of finding weighs.
    pub severities: Severities,
}

/// What each kind of finding weighs, where that differs from what it usually does.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Severities(BTreeMap<Code, Option<Severity>>);

impl Severities {
    /// What findings of a kind weigh; `None` turns them off.
    pub fn of(&self, code: Code) -> Option<Severity> {
        self.0.get(&code).copied().unwrap_or(Some(code.severity()))
    }

    /// Sets what findings of a kind weigh.
    pub fn set(&mut self, code: Code, severity: Option<Severity>) {
        if severity == Some(code.severity()) {
            self.0.remove(&code);
        } else {
            self.0.insert(code, severity);
        }
    }
}
