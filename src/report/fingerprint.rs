//! What stays the same about a finding while the text around it moves.

use super::view::View;
use super::{FileReport, object_name};
use rustc_hash::FxHashMap;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;

/// One fingerprint a finding: 32 hexadecimal digits made of its kind, the names of its objects and the words of its
/// line, but neither of its line number nor of the path. Those of one file differ from each other.
pub fn fingerprints(file: &FileReport) -> Vec<String> {
    let view = View::new(file);
    let mut seen: FxHashMap<String, usize> = FxHashMap::default();
    let keys = file.findings.iter().map(|finding| {
        let mut key = finding.code.name().to_string();
        for index in &finding.objects {
            let _ = write!(key, "\0{}", object_name(file, *index));
        }
        let line = view.line_text(finding.place.source, view.span(finding.place).start.line);
        for word in line.split_whitespace() {
            let _ = write!(key, "\u{1}{word}");
        }
        key
    });
    keys.map(|key| {
        let nth = seen.entry(key.clone()).or_default();
        *nth += 1;
        hash(&format!("{key}\u{2}{nth}"))
    })
    .collect()
}

/// A fingerprint that is different for each file.
pub(super) fn in_file(path: &str, fingerprint: &str) -> String {
    hash(&format!("{path}\0{fingerprint}"))
}

fn hash(key: &str) -> String {
    Sha256::digest(key.as_bytes()).iter().take(16).fold(String::with_capacity(32), |mut hex, byte| {
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}
