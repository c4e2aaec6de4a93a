//! Whole programs against layouts that an independent implementation of the language computed for them: those of this project, and
//! those of any folder that `PSDL_CORPUS` names (`NAME.psdl` beside `NAME.expected.json`).

use psdl::analysis::{Analysis, Input, Options, analyse};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Programs may recurse as deep as the limits let them.
const STACK: usize = 64 << 20;

fn folder() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    std::env::var_os("PSDL_CORPUS").map_or(own, PathBuf::from)
}

fn programs(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be listed");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut programs: Vec<PathBuf> = paths.filter(|path| path.extension().is_some_and(|end| end == "psdl")).collect();
    programs.sort();
    programs
}

fn analysed(path: &Path) -> Analysis {
    let text = std::fs::read_to_string(path).expect("the program can be read");
    let template = std::fs::read_to_string(path.with_extension("template.json")).ok();
    let work = move || analyse(&Input { text: &text, template: template.as_deref() }, &Options::default(), None);
    std::thread::Builder::new().stack_size(STACK).spawn(work).expect("a thread").join().expect("no panic")
}

/// What differs between a program's layout and the expected one.
fn differences(path: &Path) -> Vec<String> {
    let analysis = analysed(path);
    let expected = std::fs::read_to_string(path.with_extension("expected.json")).expect("there is an expected layout");
    let expected: Value = serde_json::from_str(&expected).expect("it is JSON");
    let Some(layout) = analysis.layout.as_ref().filter(|_| !analysis.partial) else {
        return vec![format!("it does not run: {:#?}", analysis.findings)];
    };
    let objects = expected["objects"].as_array().expect("it has objects");
    if layout.objects.len() != objects.len() {
        return vec![format!("{} objects instead of {}", layout.objects.len(), objects.len())];
    }
    let skipped = |index: usize| objects[index]["skip"] == true;
    let mut differences = Vec::new();
    for (index, (object, expected)) in layout.objects.iter().zip(objects).enumerate().filter(|(index, _)| !skipped(*index)) {
        for axis in 0..3 {
            let (is, should) = (object.body.center[axis], expected["center"][axis].as_f64().expect("a number"));
            if (is - should).abs() > 1e-9 {
                differences.push(format!("{} (object {index}): center {is} instead of {should} on axis {axis}", object.path));
            }
        }
        if expected["facing"] != object.body.turn.short_name() {
            differences.push(format!("{} (object {index}) faces {}", object.path, object.body.turn.short_name()));
        }
    }
    let key = |kind: &str, mut objects: Vec<usize>| {
        // Of two that overlap, either may be called the culprit.
        if kind == "overlap" {
            objects.sort_unstable();
        }
        (kind.to_string(), objects)
    };
    let mut errors: BTreeMap<(String, Vec<usize>), [u64; 2]> = BTreeMap::new();
    for violation in analysis.verdict.counted() {
        errors.entry(key(violation.kind.name(), violation.objects().collect())).or_default()[0] = violation.loss;
    }
    for violation in expected["violations"].as_array().expect("it has violations") {
        let objects = violation["objects"].as_array().expect("a list").iter().filter_map(Value::as_u64).map(|index| index as usize);
        let entry = errors.entry(key(violation["kind"].as_str().expect("a kind"), objects.collect())).or_default();
        entry[1] = violation["loss"].as_u64().expect("a loss");
    }
    for ((kind, objects), [is, should]) in errors {
        let missing = (is == 0) != (should == 0);
        if (missing || is.abs_diff(should) > 1) && !objects.iter().any(|index| skipped(*index)) {
            differences.push(format!("{kind} of {objects:?}: loss {is} instead of {should}"));
        }
    }
    differences
}

#[test]
fn every_program_gives_the_expected_layout_and_errors() {
    let folder = folder();
    let programs = programs(&folder);
    assert!(!programs.is_empty(), "there are no programs in {}", folder.display());
    for path in programs {
        assert_eq!(differences(&path), [""; 0], "{}", path.display());
    }
}

#[test]
fn the_examples_show_every_kind_of_error() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut kinds = std::collections::BTreeSet::new();
    for path in programs(&own) {
        kinds.extend(analysed(&path).findings.into_iter().map(|finding| finding.code.name()));
    }
    for info in psdl::check::codes::all().filter(|info| info.code.is_layout()) {
        assert!(kinds.contains(info.name), "no example has {}", info.name);
    }
    assert!(kinds.contains("unplaced") && kinds.contains("self-facing"), "{kinds:?}");
}
