//! The JSON of the SceneVisualizer. Y is up: a position is (x, z, −y), a size (x, z, y) after the turn to the facing.

use super::Subject;
use crate::scene::{Body, Cardinal, Kind};
use serde::Serialize;
use serde_json::{Value, json};

/// How thick floor and walls are drawn, metres.
const THICKNESS: f64 = 0.1;

/// By a cardinal's number.
pub(super) const FACINGS: [&str; 4] = ["EAST", "NORTH", "WEST", "SOUTH"];

#[derive(Serialize)]
struct Entry<'a> {
    name: &'a str,
    r#type: &'a str,
    position: [f64; 3],
    size: [f64; 3],
    facing: &'a str,
    color: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    support: Option<&'a str>,
}

#[derive(Serialize)]
struct Relation<'a> {
    name: &'a str,
    arity: String,
    args: Vec<usize>,
    loss: u64,
}

/// The scene's coordinates as the visualizer's. The sum takes the sign off a zero.
fn position([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, z, -y].map(|value| value + 0.0)
}

/// World extents as the visualizer's.
fn size([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, z, y]
}

fn is_shown(body: &Body) -> bool {
    body.is_placed() && [body.center, body.min, body.max].as_flattened().iter().all(|value| value.is_finite())
}

fn letter(kind: Kind) -> char {
    match kind {
        Kind::Object => 'o',
        Kind::Door => 'd',
        Kind::Window => 'w',
    }
}

pub(super) fn visualizer(subject: &Subject) -> String {
    let layout = subject.layout;
    let [width, depth, height] = layout.scene.size();
    // Where each object stands in the file: what was not placed is not in it.
    let mut places = Vec::with_capacity(layout.objects.len());
    let mut entries = Vec::with_capacity(layout.objects.len() + 5);
    let mut filled = 0.0;
    for object in &layout.objects {
        let body = &object.body;
        places.push(is_shown(body).then_some(entries.len()));
        if !is_shown(body) {
            continue;
        }
        if body.kind == Kind::Object {
            filled += body.dims[0] * body.dims[1] * body.dims[2];
        }
        entries.push(Entry {
            name: &object.name,
            r#type: body.kind.name(),
            position: position(body.center),
            size: size(body.size()),
            facing: FACINGS[body.turn.index()],
            color: object.color.as_deref(),
            support: Some(body.support.name()),
        });
    }
    surfaces(subject, &mut entries);
    let relations = subject.verdict.counted().filter_map(|violation| {
        let args = violation.objects().map(|index| places[index]).collect::<Option<Vec<usize>>>()?;
        let arity = violation.objects().map(|index| letter(layout.objects[index].body.kind)).collect();
        Some(text(&Relation { name: violation.kind.name(), arity, args, loss: violation.loss }))
    });
    let relations: Vec<String> = relations.collect();
    let percentage = 100.0 * filled / (width * depth * height);
    // JSON knows neither infinity nor NaN.
    let number = |value: f64| if value.is_finite() { Value::from(value) } else { Value::Null };
    format!(
        "{{\"name\": {},\n\"size\": {},\n\"objects\": {},\n\"relations\": {},\n\"number_of_constants\": {},\n\"fill_percentage\": {}}}\n",
        json!(layout.scene.title),
        text(&size([width, depth, height])),
        lines(&entries.iter().map(text).collect::<Vec<_>>()),
        lines(&relations),
        subject.constants,
        number(percentage),
    )
}

/// Floor and, where there is a ceiling, walls. They lie outside of the scene's box.
fn surfaces<'a>(subject: &Subject<'a>, entries: &mut Vec<Entry<'a>>) {
    let scene = &subject.layout.scene;
    let [width, depth, height] = scene.size();
    let surface = |surface: &'a Option<crate::scene::Surface>, name: &'a str| {
        surface.as_ref().map_or((name, None), |surface| (surface.asset.as_str(), surface.color.as_deref()))
    };
    let (name, color) = surface(&scene.floor, "Floor");
    let at = |r#type, (name, color): (&'a str, Option<&'a str>), center, extents, facing: Cardinal| {
        let facing = FACINGS[facing.index()];
        Entry { name, r#type, position: position(center), size: size(extents), facing, color, support: None }
    };
    entries.push(at("FLOOR", (name, color), [0.0, 0.0, -0.5 * THICKNESS], [width, depth, THICKNESS], Cardinal::YMax));
    if scene.interior {
        let wall = surface(&scene.wall, "Wall");
        let (x, y, z) = (0.5 * (width + THICKNESS), 0.5 * (depth + THICKNESS), 0.5 * height);
        let (along_x, along_y) = ([width, THICKNESS, height], [THICKNESS, depth, height]);
        entries.push(at("WALL", wall, [x, 0.0, z], along_y, Cardinal::XMin));
        entries.push(at("WALL", wall, [0.0, y, z], along_x, Cardinal::YMin));
        entries.push(at("WALL", wall, [-x, 0.0, z], along_y, Cardinal::XMax));
        entries.push(at("WALL", wall, [0.0, -y, z], along_x, Cardinal::YMax));
    }
}

/// Plain data of ours always serializes.
fn text(value: &impl Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

fn lines(items: &[String]) -> String {
    if items.is_empty() { "[]".into() } else { format!("[\n{}\n]", items.join(",\n")) }
}
