//! Findings that are known and do not fail a run: a file that remembers them by what stays when lines move.

use super::output::{self, Failure};
use crate::check::finding::Finding;
use crate::report::{FileReport, fingerprints};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The version of the file's format.
const VERSION: u32 = 1;

/// What the file holds: by path of the program, the fingerprints of its findings with a message for people.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Stored {
    version: u32,
    files: BTreeMap<String, BTreeMap<String, String>>,
}

/// Known findings.
pub(super) struct Baseline {
    files: BTreeMap<String, BTreeMap<String, String>>,
}

/// What a run makes of the known findings of one file: those that were found again.
pub(super) type Seen = BTreeSet<String>;

impl Baseline {
    pub(super) fn read(path: &Path) -> Result<Baseline, Failure> {
        let text = std::fs::read_to_string(path).map_err(|error| Failure::at(path, &error))?;
        let stored: Stored = serde_json::from_str(&text).map_err(|error| Failure::at(path, &format!("this is no baseline: {error}")))?;
        if stored.version != VERSION {
            return Err(Failure::at(path, &format!("a baseline of version {}, not {VERSION}", stored.version)));
        }
        Ok(Baseline { files: stored.files })
    }

    /// Takes away the findings that are known, and says which of the known ones they were.
    pub(super) fn sift(&self, file: &FileReport) -> (Vec<Finding>, Seen) {
        let Some(known) = self.files.get(file.path) else { return (file.findings.to_vec(), Seen::new()) };
        let mut seen = Seen::new();
        let new = file.findings.iter().zip(fingerprints(file)).filter_map(|(finding, print)| {
            if known.contains_key(&print) {
                seen.insert(print);
                return None;
            }
            Some(finding.clone())
        });
        (new.collect(), seen)
    }

    /// The known findings of a file that were not found again, as sentences.
    pub(super) fn fixed(&self, path: &str, seen: &Seen) -> Vec<String> {
        let known = self.files.get(path).into_iter().flatten();
        known.filter(|(print, _)| !seen.contains(*print)).map(|(_, message)| format!("{path}: {message}")).collect()
    }
}

/// A baseline under construction.
#[derive(Default)]
pub(super) struct Writer(BTreeMap<String, BTreeMap<String, String>>);

impl Writer {
    /// Remembers the findings of a file.
    pub(super) fn add(&mut self, path: String, findings: BTreeMap<String, String>) {
        if !findings.is_empty() {
            self.0.insert(path, findings);
        }
    }

    pub(super) fn write(self, path: &Path) -> Result<(), Failure> {
        let stored = Stored { version: VERSION, files: self.0 };
        let text = serde_json::to_string_pretty(&stored).map_err(|error| Failure::at(path, &error))?;
        output::write_file(path, (text + "\n").as_bytes())
    }
}

/// The findings of a file that count, as a baseline remembers them.
pub(super) fn remembered(file: &FileReport) -> BTreeMap<String, String> {
    let failing = file.findings.iter().zip(fingerprints(file)).filter(|(finding, _)| finding.severity.fails());
    failing.map(|(finding, print)| (print, format!("{}: {}", finding.code, finding.message))).collect()
}
