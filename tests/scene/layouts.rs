//! Recorded layouts have the errors that were recorded with them.

use std::path::{Path, PathBuf};

use psdl::check::{Checker, Rules};
use serde_json::Value;

use super::read::{self, Expected};

/// Recorded layouts: the examples, and those of each folder in `PSDL_CORPUS`.
pub fn recorded() -> Vec<PathBuf> {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let more = std::env::var_os("PSDL_CORPUS").unwrap_or_default();
    let folders = std::iter::once(examples).chain(std::env::split_paths(&more).filter(|path| !path.as_os_str().is_empty()));
    let files = |folder: PathBuf| std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths = folders.flat_map(files).map(|entry| entry.expect("an entry").path());
    let mut recorded: Vec<PathBuf> = paths.filter(|path| path.to_string_lossy().ends_with(".expected.json")).collect();
    recorded.sort();
    recorded
}

/// The errors that the check finds, in the words of layout JSON. `unplaced` is no error there.
pub fn found(layout: &Value) -> Vec<Expected> {
    let (bounds, bodies) = read::bodies(layout);
    let verdict = Checker { rules: &Rules::default(), bounds, bodies: &bodies }.check();
    assert!(!verdict.truncated);
    verdict.counted().map(|found| (found.kind.name().to_owned(), found.objects().collect(), found.loss)).collect()
}

/// Asserts the same errors, in the same order, with losses that differ by 1 at most.
pub fn assert_same(name: &str, found: &[Expected], expected: &[Expected]) {
    let bare = |errors: &[Expected]| errors.iter().map(|(kind, objects, _)| (kind.clone(), objects.clone())).collect::<Vec<_>>();
    assert_eq!(bare(found), bare(expected), "{name}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.2.abs_diff(expected.2) <= 1, "{name}: {found:?}, expected {expected:?}");
    }
}

#[test]
fn recorded_layouts_have_their_recorded_errors() {
    let recorded = recorded();
    let mut errors = 0;
    for path in &recorded {
        let text = std::fs::read_to_string(path).expect("a readable file");
        let layout: Value = serde_json::from_str(&text).expect("JSON");
        let expected = read::violations(&layout);
        assert_same(&path.display().to_string(), &found(&layout), &expected);
        errors += expected.len();
    }
    assert!(recorded.len() >= 12 && errors > 0, "{} layouts, {errors} errors", recorded.len());
}
