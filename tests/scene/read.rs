//! Layout JSON as bodies and expected errors.

use psdl::check::measure::Bounds;
use psdl::scene::{Anchor, Body, Cardinal, Kind, ObjectId, Support, Target, Told};
use serde_json::Value;

/// An expected error: kind, objects, loss.
pub type Expected = (String, Vec<usize>, u64);

/// The scene's box and the objects of a layout.
pub fn bodies(layout: &Value) -> (Bounds, Vec<Body>) {
    let scene = &layout["scene"];
    let [width, depth, height] = ["width", "depth", "height"].map(|key| number(&scene[key]));
    let interior = scene["interior"].as_bool().expect("interior");
    let bounds = Bounds { min: [-0.5 * width, -0.5 * depth, 0.0], max: [0.5 * width, 0.5 * depth, height], interior };
    (bounds, layout["objects"].as_array().expect("objects").iter().map(body).collect())
}

/// The errors that a layout is said to have.
pub fn violations(layout: &Value) -> Vec<Expected> {
    let one = |found: &Value| {
        let objects = found["objects"].as_array().expect("objects").iter().map(|index| index.as_u64().expect("index") as usize);
        (found["kind"].as_str().expect("kind").to_owned(), objects.collect(), found["loss"].as_u64().expect("loss"))
    };
    layout["violations"].as_array().expect("violations").iter().map(one).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn vector(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|k| number(&value[k]))
}

fn body(object: &Value) -> Body {
    let text = |key: &str| object[key].as_str().expect("text");
    let kind = [Kind::Object, Kind::Door, Kind::Window].into_iter().find(|kind| kind.name() == text("type"));
    let told = match &object["facing_target"] {
        Value::String(_) => Told::Toward(Target::Scene),
        Value::Number(index) => Told::Toward(Target::Object(ObjectId(index.as_u64().expect("index") as u32))),
        _ if object["facing_set"] == true => Told::Direction,
        _ => Told::Never,
    };
    let mut anchors = [None; 3];
    for anchor in object["anchors"].as_array().expect("anchors") {
        let axis = "xyz".find(anchor[1].as_str().expect("axis")).expect("an axis");
        anchors[axis] = Anchor::from_name(anchor[0].as_str().expect("anchor"));
    }
    Body {
        kind: kind.expect("a kind"),
        support: Support::from_name(text("support")).expect("a support"),
        dims: ["width", "depth", "height"].map(|key| number(&object[key])),
        center: vector(&object["center"]),
        min: vector(&object["min"]),
        max: vector(&object["max"]),
        turn: Cardinal::ALL.into_iter().find(|turn| turn.short_name() == text("facing")).expect("a facing"),
        told,
        directed: object["directed"].as_bool().expect("directed"),
        anchors,
    }
}
