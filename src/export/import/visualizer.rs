//! The JSON of the SceneVisualizer, see [the writer](super::super::visualizer).

use super::ImportError;
use super::flat::{Facing, Flat, Item, anchored};
use super::json::Reader;
use super::layout::SUPPORTS;
use super::naming::wishes;
use crate::scene::{Cardinal, Kind, Scalar, Surface};
use jsonc_parser::ast::Object;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Type {
    Thing(Kind),
    Wall,
    Floor,
}

const TYPES: [(&str, Type); 5] = [
    ("OBJECT", Type::Thing(Kind::Object)),
    ("DOOR", Type::Thing(Kind::Door)),
    ("WINDOW", Type::Thing(Kind::Window)),
    ("WALL", Type::Wall),
    ("FLOOR", Type::Floor),
];
const FACINGS: [(&str, Cardinal); 4] =
    [("EAST", Cardinal::XMax), ("NORTH", Cardinal::YMax), ("WEST", Cardinal::XMin), ("SOUTH", Cardinal::YMin)];

pub(super) fn read(text: &str) -> Result<Flat, Vec<ImportError>> {
    let mut reader = Reader::default();
    let root = reader.root(text);
    let scene = root.and_then(|root| scene(&mut reader, &root));
    reader.finish(scene)
}

/// Three positive lengths.
fn sizes(reader: &mut Reader, object: &Object) -> Option<[f64; 3]> {
    let value = reader.required(object, "size")?;
    let sizes = reader.triple(value, "size")?;
    if sizes.iter().any(|size| *size <= 0.0) {
        reader.error(jsonc_parser::common::Ranged::range(value), "\"size\" has three positive numbers");
        return None;
    }
    Some(sizes)
}

fn scene(reader: &mut Reader, root: &Object) -> Option<Flat> {
    let title = Reader::optional(root, "name").and_then(|value| reader.text(value, "name")).unwrap_or_default();
    let size = sizes(reader, root);
    let entries = reader.required(root, "objects").and_then(|value| reader.objects(value, "objects"))?;
    let [width, height, depth] = size?;
    let dims = [width, depth, height].map(Scalar::float);
    let mut scene = Flat { title, dims, interior: false, floor: None, wall: None, items: Vec::new(), remarks: Vec::new() };
    let mut complete = true;
    for entry in entries {
        let kind = match Reader::optional(entry, "type") {
            None => Some(Type::Thing(Kind::Object)),
            Some(value) => reader.one_of(value, "type", &TYPES),
        };
        match kind {
            None => complete = false,
            Some(Type::Thing(kind)) => match item(reader, entry, kind, &scene) {
                Some(item) => scene.items.push(item),
                None => complete = false,
            },
            Some(Type::Floor) => scene.floor = scene.floor.or(surface(reader, entry, "Floor")),
            Some(Type::Wall) => {
                scene.interior = true;
                scene.wall = scene.wall.or(surface(reader, entry, "Wall"));
            }
        }
    }
    let wishes = wishes(scene.items.iter().map(|item| item.category.as_str()));
    scene.items.iter_mut().zip(wishes).for_each(|(item, wish)| item.wish = wish);
    complete.then_some(scene)
}

/// A floor or wall that says more than that it is one.
fn surface(reader: &mut Reader, entry: &Object, plain: &str) -> Option<Surface> {
    let asset = Reader::optional(entry, "name").and_then(|value| reader.text(value, "name")).unwrap_or_else(|| plain.to_owned());
    let color = reader.color(entry, "color");
    (asset != plain || color.is_some()).then_some(Surface { asset, color })
}

fn item(reader: &mut Reader, entry: &Object, kind: Kind, scene: &Flat) -> Option<Item> {
    let category = reader.required(entry, "name").and_then(|value| reader.text(value, "name"));
    let position = reader.required(entry, "position").and_then(|value| reader.triple(value, "position"));
    let size = sizes(reader, entry);
    let turn = reader.required(entry, "facing").and_then(|value| reader.one_of(value, "facing", &FACINGS));
    let color = reader.color(entry, "color");
    let [x, up, back] = position?;
    let center = [x, -back + 0.0, up];
    let ([along_x, height, along_y], turn) = (size?, turn?);
    // Width is across the facing; turning back gives what the size was before it was turned.
    let dims = crate::scene::extents([along_x, along_y, height], turn);
    let support = match Reader::optional(entry, "support") {
        Some(value) => reader.one_of(value, "support", &SUPPORTS)?,
        None => scene.likely_support(center, [along_x, along_y, height]),
    };
    Some(Item {
        wish: String::new(),
        category: category?,
        kind,
        support,
        dims: dims.map(Scalar::float),
        color,
        anchors: anchored(center, dims, turn),
        turn,
        facing: Facing::Direction,
        remark: None,
    })
}
