//! What a whole run found, in numbers.

use crate::check::finding::{Code, Finding, Severity};
use serde::Serialize;
use std::collections::BTreeMap;

/// The numbers of a run.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Summary {
    /// Files that were looked at.
    pub files: usize,
    /// Those of them with a finding that makes the run fail.
    pub failing_files: usize,
    /// Findings that are errors.
    pub errors: usize,
    /// Findings that are warnings.
    pub warnings: usize,
    /// Findings that are for information only.
    pub infos: usize,
    /// Weighted loss of all layouts.
    pub loss: u64,
    /// How often each kind was found, by name; a finding that stands for several errors counts as many.
    pub kinds: BTreeMap<&'static str, usize>,
}

impl Summary {
    /// Adds the findings of one file.
    pub fn add(&mut self, findings: &[Finding]) {
        let mut one = Summary { files: 1, ..Summary::default() };
        for finding in findings {
            match finding.severity {
                Severity::Error => one.errors += 1,
                Severity::Warning => one.warnings += 1,
                Severity::Info => one.infos += 1,
            }
            one.loss = one.loss.saturating_add(finding.loss);
            *one.kinds.entry(finding.code.name()).or_default() += finding.count.max(1);
        }
        one.failing_files = usize::from(one.fails());
        self.merge(&one);
    }

    /// Adds another summary.
    pub fn merge(&mut self, other: &Summary) {
        self.files += other.files;
        self.failing_files += other.failing_files;
        self.errors += other.errors;
        self.warnings += other.warnings;
        self.infos += other.infos;
        self.loss = self.loss.saturating_add(other.loss);
        for (kind, count) in &other.kinds {
            *self.kinds.entry(kind).or_default() += count;
        }
    }

    /// Whether anything was found that makes a run fail.
    pub fn fails(&self) -> bool {
        self.errors + self.warnings > 0
    }

    /// The kinds, the most frequent first.
    pub fn by_frequency(&self) -> Vec<(&'static str, usize)> {
        let mut kinds: Vec<(&'static str, usize)> = self.kinds.iter().map(|(kind, count)| (*kind, *count)).collect();
        kinds.sort_by_key(|(kind, count)| (std::cmp::Reverse(*count), *kind));
        kinds
    }

    /// How often a kind was found.
    pub fn count(&self, code: Code) -> usize {
        self.kinds.get(code.name()).copied().unwrap_or_default()
    }
}
