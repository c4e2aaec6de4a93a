//! Layout JSON: its anchors, facings and sizes become the program's, to the last bit.

use super::ImportError;
use super::flat::{Facing, Flat, Item, anchored};
use super::json::Reader;
use super::naming::wishes;
use crate::scene::{Anchor, Axis, Cardinal, Kind, ObjectId, Scalar, Support, Target};
use jsonc_parser::ast::{Object, Value};
use jsonc_parser::common::Ranged;

pub(super) const KINDS: [(&str, Kind); 3] = [("OBJECT", Kind::Object), ("DOOR", Kind::Door), ("WINDOW", Kind::Window)];
pub(super) const SUPPORTS: [(&str, Support); 4] =
    [("STANDING", Support::Standing), ("MOUNTED", Support::Mounted), ("FLOATING", Support::Floating), ("WALL_MOUNTED", Support::Mounted)];
const FACINGS: [(&str, Cardinal); 4] = [("X+", Cardinal::XMax), ("Y+", Cardinal::YMax), ("X-", Cardinal::XMin), ("Y-", Cardinal::YMin)];
const ANCHORS: [(&str, Anchor); 3] = [("min", Anchor::Min), ("center", Anchor::Center), ("max", Anchor::Max)];
const AXES: [(&str, Axis); 3] = [("x", Axis::X), ("y", Axis::Y), ("z", Axis::Z)];

pub(super) fn read(text: &str) -> Result<Flat, Vec<ImportError>> {
    let mut reader = Reader::default();
    let root = reader.root(text);
    let scene = root.and_then(|root| scene(&mut reader, &root));
    reader.finish(scene)
}

pub(super) fn sizes(reader: &mut Reader, object: &Object) -> Option<[Scalar; 3]> {
    let [width, depth, height] = ["width", "depth", "height"].map(|key| {
        let value = reader.required(object, key)?;
        reader.size(value, key)
    });
    Some([width?, depth?, height?])
}

fn scene(reader: &mut Reader, root: &Object) -> Option<Flat> {
    let about = reader.required(root, "scene").and_then(|value| reader.object(value, "scene"));
    let objects = reader.required(root, "objects").and_then(|value| reader.objects(value, "objects"));
    let (about, objects) = (about?, objects?);
    let dims = sizes(reader, about);
    let title = Reader::optional(about, "title").and_then(|value| reader.text(value, "title")).unwrap_or_default();
    let interior = Reader::optional(about, "interior").map_or(Some(true), |value| reader.truth(value, "interior"));
    let read: Vec<Option<Item>> = objects.iter().map(|object| item(reader, object, objects.len())).collect();
    let mut items = read.into_iter().collect::<Option<Vec<Item>>>()?;
    if items.iter().any(|item| item.wish.is_empty()) {
        let wishes = wishes(items.iter().map(|item| item.category.as_str()));
        items.iter_mut().zip(wishes).for_each(|(item, wish)| item.wish = wish);
    }
    for (index, item) in items.iter_mut().enumerate() {
        if item.facing == Facing::Toward(Target::Object(ObjectId(index as u32))) {
            item.facing = Facing::Direction;
        }
    }
    Some(Flat { title, dims: dims?, interior: interior?, floor: None, wall: None, items, remarks: Vec::new() })
}

fn item(reader: &mut Reader, object: &Object, count: usize) -> Option<Item> {
    let category = reader.required(object, "name").and_then(|value| reader.text(value, "name"));
    let wish = Reader::optional(object, "path").and_then(|value| reader.text(value, "path")).unwrap_or_default();
    let kind = Reader::optional(object, "type").map_or(Some(Kind::Object), |value| reader.one_of(value, "type", &KINDS));
    let support = reader.required(object, "support").and_then(|value| reader.one_of(value, "support", &SUPPORTS));
    let dims = sizes(reader, object);
    let turn = reader.required(object, "facing").and_then(|value| reader.one_of(value, "facing", &FACINGS));
    let is_set = Reader::optional(object, "facing_set").map_or(Some(true), |value| reader.truth(value, "facing_set"));
    let target = Reader::optional(object, "facing_target").map_or(Some(None), |value| target(reader, value, count).map(Some));
    let color = reader.color(object, "color");
    let facing = match (is_set?, target?) {
        (true, Some(target)) => Facing::Toward(target),
        (true, None) => Facing::Direction,
        (false, _) => Facing::Free,
    };
    let (dims, turn) = (dims?, turn?);
    let anchors = match Reader::optional(object, "anchors") {
        Some(value) => anchors(reader, value)?,
        None => {
            let center = reader.required(object, "center")?;
            anchored(reader.triple(center, "center")?, dims.map(Scalar::value), turn)
        }
    };
    Some(Item { wish, category: category?, kind: kind?, support: support?, dims, color, anchors, turn, facing, remark: None })
}

fn target(reader: &mut Reader, value: &Value, count: usize) -> Option<Target> {
    match value {
        Value::StringLit(_) => reader.one_of(value, "facing_target", &[("scene", Target::Scene)]),
        _ => {
            let index = reader.number(value, "facing_target")?;
            let known = index.int && index.value() >= 0.0 && index.value() < count as f64;
            if !known {
                reader.error(value.range(), format!("\"facing_target\" is the index of an object, not {}", index.shown()));
            }
            known.then_some(Target::Object(ObjectId(index.value() as u32)))
        }
    }
}

fn anchors(reader: &mut Reader, value: &Value) -> Option<Vec<(Axis, Anchor, Scalar)>> {
    let mut found: Vec<(Axis, Anchor, Scalar)> = Vec::with_capacity(3);
    for element in &reader.list(value, "anchors")?.elements {
        let list = reader.list(element, "an anchor")?;
        let [anchor, axis, value] = list.elements.as_slice() else {
            reader.error(list.range, "an anchor is a part of the box, an axis and a number");
            return None;
        };
        let (anchor, axis) = (reader.one_of(anchor, "an anchor", &ANCHORS), reader.one_of(axis, "an axis", &AXES));
        let (anchor, axis, number) = (anchor?, axis?, reader.number(value, "a coordinate")?);
        if found.iter().any(|(known, ..)| *known == axis) {
            reader.error(list.range, format!("{} has an anchor already", axis.name()));
            return None;
        }
        found.push((axis, anchor, number));
    }
    Some(found)
}
