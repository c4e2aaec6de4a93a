//! Export, import, export: the same scene, and from the second file on the same bytes.

use super::{Scene, all};
use psdl::export::Format;
use psdl::export::import::{Source, detect, import};
use serde_json::{Map, Value};

fn imported(name: &str, text: &str, source: Source) -> String {
    assert_eq!(detect(text), Some(source), "{name}");
    import(text, source).unwrap_or_else(|errors| panic!("{name}: {errors:?}"))
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

fn objects(layout: &mut Value) -> impl Iterator<Item = &mut Map<String, Value>> {
    layout["objects"].as_array_mut().expect("objects").iter_mut().filter_map(Value::as_object_mut)
}

/// Numbers of lines, and what objects are called, are the program's; the rest is the scene's. What an object was told to face and does
/// not cannot be said by a flat program, which has the direction instead.
fn without_program(mut layout: Value) -> Value {
    let violations = layout["violations"].as_array_mut().expect("violations");
    let stale: Vec<Value> = violations.extract_if(.., |found| found["kind"] == "facing").collect();
    for culprit in stale.iter().filter_map(|found| found["objects"][0].as_u64()) {
        layout["objects"][culprit as usize]["facing_target"] = Value::Null;
    }
    for object in objects(&mut layout) {
        object.remove("lines");
        object.remove("path");
    }
    layout
}

fn without_comments(program: &str) -> String {
    program.lines().map(|line| format!("{}\n", line.split("  # was told").next().unwrap_or_default())).collect()
}

/// A path that a flat program can have: a name, or places in lists and dicts one after the other.
fn is_plain(path: &str) -> bool {
    path.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

#[test]
fn layouts_come_out_as_they_went_in() {
    let mut kept = 0;
    for path in all() {
        let name = path.display().to_string();
        let first = Scene::load(&path).text_of(Format::Layout);
        if first.contains("null,null") || name.ends_with("extreme.psdl") {
            continue;
        }
        let program = imported(&name, &first, Source::Layout);
        let second = Scene::run(&program, None).text_of(Format::Layout);
        let (before, after) = (json(&first), json(&second));
        for (a, b) in before["objects"].as_array().expect("objects").iter().zip(after["objects"].as_array().expect("objects")) {
            let path = a["path"].as_str().expect("a path");
            assert!(!is_plain(path) || a["path"] == b["path"], "{name}: {path} became {}", b["path"]);
            kept += usize::from(a["path"] == b["path"]);
        }
        assert_eq!(without_program(before), without_program(after), "{name}");
        let again = imported(&name, &second, Source::Layout);
        // What an object was told to face in vain is said once, in a comment.
        assert_eq!(again, without_comments(&program), "{name}");
        assert_eq!(Scene::run(&again, None).text_of(Format::Layout), second, "{name}");
    }
    assert!(kept > 500, "{kept} paths were kept");
}

#[test]
fn scenes_of_the_visualizer_come_out_as_they_went_in() {
    // What rests on how a program says it: the format holds boxes and directions only.
    let told = ["facing", "facing-wall", "short-side"];
    for path in all() {
        let name = path.display().to_string();
        let first = Scene::load(&path).text_of(Format::Visualizer);
        if name.ends_with("extreme.psdl") {
            continue;
        }
        let program = imported(&name, &first, Source::Visualizer);
        let second = Scene::run(&program, None).text_of(Format::Visualizer);
        let (mut before, mut after) = (json(&first), json(&second));
        before["relations"].as_array_mut().expect("relations").retain(|relation| !told.iter().any(|kind| relation["name"] == *kind));
        for scene in [&mut before, &mut after] {
            scene.as_object_mut().expect("an object").remove("number_of_constants");
        }
        assert_eq!(before, after, "{name}");
        let again = imported(&name, &second, Source::Visualizer);
        assert_eq!(again, program, "{name}");
        assert_eq!(Scene::run(&again, None).text_of(Format::Visualizer), second, "{name}");
    }
}

#[test]
fn recorded_layouts_of_others_become_programs_with_the_same_boxes() {
    let recorded = all().into_iter().map(|path| path.with_extension("expected.json")).filter(|path| path.is_file());
    let mut count = 0;
    for path in recorded {
        let (name, text) = (path.display().to_string(), std::fs::read_to_string(&path).expect("a readable file"));
        let program = imported(&name, &text, Source::Layout);
        let mut after = json(&Scene::run(&program, None).text_of(Format::Layout));
        let mut before = json(&text);
        for (a, b) in objects(&mut before).zip(objects(&mut after)) {
            for key in ["name", "type", "support", "facing", "center", "min", "max", "anchors"] {
                let skipped = a.get("skip").is_some();
                assert!(skipped || a[key] == b[key], "{name}: {key} of {} is {}, was {}", a["name"], b[key], a[key]);
            }
        }
        count += 1;
    }
    assert!(count >= 12, "{count} recorded layouts");
}
