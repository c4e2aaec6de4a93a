//! Whole programs give their recorded layouts: the examples, and those of each folder in `PSDL_CORPUS`.

use std::path::Path;

use psdl::check::{Rules, check};
use psdl::python::program::build;
use psdl::python::vm::Options;
use psdl::scene::host::{SceneHost, bound_in_loops, run};
use psdl::scene::{JsonViolation, layout_json, template};
use psdl::syntax::{parse, tune};
use serde_json::Value;

use super::layouts::{assert_same, recorded};
use super::read;

/// The layout of a program as JSON, with its errors, and what it printed.
pub fn layout_and_output(text: &str, template: Option<&str>) -> (Result<Value, String>, String) {
    let mut printed = String::new();
    (layout_of(text, template, &mut |text| printed.push_str(text)), printed)
}

fn layout_of(text: &str, template: Option<&str>, output: &mut dyn FnMut(&str)) -> Result<Value, String> {
    let host = match template {
        None => SceneHost::new(),
        Some(template) => {
            let template = template::parse(template).map_err(|errors| format!("{errors:?}"))?;
            SceneHost::with_template(&template).map_err(|error| error.to_string())?
        }
    };
    let parsed = parse(text);
    if !parsed.is_complete() {
        return Err(format!("{:?}", parsed.errors));
    }
    let program = build(&parsed, text, &tune(&parsed, text)).map_err(|error| error.message)?;
    let run = run(program, &bound_in_loops(&parsed), host, Options::default(), output);
    if let Some(uncaught) = run.outcome.exceptions.first() {
        return Err(uncaught.chain.last().map_or(String::new(), |shown| shown.line.clone()));
    }
    if let Some((stop, _)) = run.outcome.stop {
        return Err(format!("{stop:?}"));
    }
    let verdict = check(&run.layout, &Rules::default());
    let objects: Vec<Vec<usize>> = verdict.counted().map(|found| found.objects().collect()).collect();
    let violations: Vec<JsonViolation> = std::iter::zip(verdict.counted(), &objects)
        .map(|(found, objects)| JsonViolation { kind: found.kind.name(), objects, loss: found.loss })
        .collect();
    serde_json::from_str(&layout_json(&run.layout, &violations, &|_| 1)).map_err(|error| error.to_string())
}

/// Asserts the same boxes within 1e-9, the same facings, and the same errors.
pub fn assert_same_layout(name: &str, found: &Value, expected: &Value) {
    let objects = |layout: &Value| layout["objects"].as_array().expect("objects").clone();
    let (ours, theirs) = (objects(found), objects(expected));
    assert_eq!(ours.len(), theirs.len(), "{name}");
    for (index, (ours, theirs)) in ours.iter().zip(&theirs).enumerate().filter(|(_, pair)| pair.1["skip"] != true) {
        for k in 0..3 {
            let [ours, theirs] = [ours, theirs].map(|object| object["center"][k].as_f64().expect("a coordinate"));
            assert!((ours - theirs).abs() <= 1e-9, "{name}: object {index}: {ours}, expected {theirs}");
        }
        for key in ["name", "type", "support", "facing", "facing_set", "facing_target", "directed"] {
            assert_eq!(ours[key], theirs[key], "{name}: object {index}: {key}");
        }
    }
    assert_same(name, &read::violations(found), &read::violations(expected));
}

#[test]
fn programs_give_their_recorded_layouts() {
    let mut raised = Vec::new();
    for path in recorded() {
        let stem = path.to_string_lossy().replace(".expected.json", "");
        let read = |suffix: &str| std::fs::read_to_string(Path::new(&format!("{stem}{suffix}")));
        let text = read(".psdl").expect("a program");
        let expected = serde_json::from_str(&read(".expected.json").expect("a layout")).expect("JSON");
        match layout_and_output(&text, read(".template.json").ok().as_deref()).0 {
            Ok(found) => assert_same_layout(&stem, &found, &expected),
            Err(error) => raised.push(format!("{stem}: {error}")),
        }
    }
    assert_eq!(raised, [""; 0]);
}
