//! Layout JSON, as PSDL describes it.

use ruff_text_size::TextSize;
use serde::Serialize;
use serde_json::{Value, json};

use super::layout::{Layout, Placed, Told};
use super::origin::Source;
use super::terms::{Scalar, Target};

/// A layout error as layout JSON tells it: kind, objects, weighted loss.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct JsonViolation<'a> {
    /// Such as `overlap`.
    pub kind: &'a str,
    /// Indices of the objects, culprit first.
    pub objects: &'a [usize],
    /// int(weight × loss)
    pub loss: u64,
}

#[derive(Serialize)]
struct JsonObject<'a> {
    path: &'a str,
    name: &'a str,
    r#type: &'a str,
    support: &'a str,
    width: Value,
    depth: Value,
    height: Value,
    center: [Value; 3],
    min: [f64; 3],
    max: [f64; 3],
    facing: &'a str,
    facing_set: bool,
    facing_target: Value,
    directed: bool,
    anchors: Vec<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    skip: Option<bool>,
    color: Option<&'a str>,
    lines: Vec<usize>,
}

/// An integer of the program stays one.
fn number(scalar: Scalar) -> Value {
    match scalar.int && scalar.value().abs() <= 9e15 {
        true => Value::from(scalar.value() as i64),
        false => Value::from(scalar.value()),
    }
}

/// The layout as JSON, one object a line. `line_of` gives the line (from 1) of an offset of the program.
pub fn layout_json(layout: &Layout, violations: &[JsonViolation], line_of: &dyn Fn(TextSize) -> usize) -> String {
    let [width, depth, height] = layout.scene.dims.map(number);
    #[derive(Serialize)]
    struct Scene<'a> {
        title: &'a str,
        width: Value,
        depth: Value,
        height: Value,
        interior: bool,
    }
    let scene = Scene { title: &layout.scene.title, width, depth, height, interior: layout.scene.interior };
    let objects = layout.objects.iter().map(|object| text(&json_object(layout, object, line_of)));
    let violations = violations.iter().map(text);
    format!("{{\"scene\": {},\n\"objects\": {},\n\"violations\": {}}}\n", text(&scene), lines(objects), lines(violations))
}

fn json_object<'a>(layout: &'a Layout, object: &'a Placed, line_of: &dyn Fn(TextSize) -> usize) -> JsonObject<'a> {
    let body = &object.body;
    let [width, depth, height] = object.dims.map(number);
    JsonObject {
        path: &object.path,
        name: &object.name,
        r#type: body.kind.name(),
        support: body.support.name(),
        width,
        depth,
        height,
        center: object.center.map(number),
        min: body.min,
        max: body.max,
        facing: body.turn.short_name(),
        facing_set: body.told != Told::Never,
        facing_target: match body.told {
            Told::Toward(Target::Scene) => json!("scene"),
            Told::Toward(Target::Object(id)) => json!(id.index()),
            _ => Value::Null,
        },
        directed: body.directed,
        anchors: object.anchors.iter().map(|slot| json!([slot.anchor.name(), slot.axis.name(), number(slot.value)])).collect(),
        skip: (!body.is_placed()).then_some(true),
        color: object.color.as_deref(),
        lines: layout.placing_lines(object, line_of),
    }
}

impl Layout {
    /// The lines of the program whose statements placed or turned an object, ascending. `line_of` as for [`layout_json`].
    pub fn placing_lines(&self, object: &Placed, line_of: &dyn Fn(TextSize) -> usize) -> Vec<usize> {
        let origins = object.anchors.iter().map(|anchor| anchor.origin).chain(object.faced.map(|(origin, _)| origin));
        let places = origins.map(|id| self.origins.get(id)).filter(|origin| origin.source == Source::Program);
        let mut lines: Vec<usize> = places.map(|origin| line_of(origin.range.start())).collect();
        lines.sort_unstable();
        lines.dedup();
        lines
    }
}

/// Plain data of ours always serializes: its keys are strings, and numbers that JSON lacks become null.
fn text(value: &impl Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

fn lines(items: impl Iterator<Item = String>) -> String {
    let items: Vec<String> = items.collect();
    if items.is_empty() { "[]".into() } else { format!("[\n{}\n]", items.join(",\n")) }
}
