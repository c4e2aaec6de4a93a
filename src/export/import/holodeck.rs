//! Scenes of AI2's Holodeck (ProcTHOR's JSON): Y up, metres, degrees clockwise as seen from above, 0 looks along +z.
//!
//! (x, y, z) of the file becomes (x, z, y), moved so that the middle of the rooms' floors is the middle of the scene. The size of an
//! object is looked for in this order: `size`, `bbox`, `boundingBox`, `assetBoundingBox` or `dimensions` ({x, y, z}, {size: …} or
//! {min, max}; of the asset, before it is turned), `axisAlignedBoundingBox` (after it is turned), then Holodeck's own
//! `vertices` (the footprint in the room, centimetres) with twice the height of the center, which holds for what stands on the floor
//! (`floor_objects`). An object with none of these is refused at its place.

use super::ImportError;
use super::flat::{Facing, Flat, Item, anchored, rounded};
use super::json::Reader;
use super::naming::wishes;
use crate::scene::{Cardinal, Kind, MAX_OBJECTS, Scalar, Support, Surface};
use jsonc_parser::ast::{Object, Value};
use jsonc_parser::common::Ranged;
use rustc_hash::FxHashSet;

/// How thick a door or window is drawn, metres: the file gives them no thickness.
const THICKNESS: f64 = 0.1;
/// Taken where no height of the walls is given, metres.
const HEIGHT: f64 = 3.0;

/// x, y (up), z of the file.
type Point = [f64; 3];

/// What was read of an object, in the file's coordinates.
struct Found {
    category: String,
    kind: Kind,
    support: Option<Support>,
    center: Point,
    /// Along x, y (up) and z, after the turn.
    size: Point,
    turn: Cardinal,
    remark: Option<String>,
}

/// The ids of the objects in Holodeck's own lists.
#[derive(Default)]
struct Lists {
    floor: FxHashSet<String>,
    wall: FxHashSet<String>,
    ceiling: FxHashSet<String>,
}

pub(super) fn read(text: &str) -> Result<Flat, Vec<ImportError>> {
    let mut reader = Reader::default();
    let root = reader.root(text);
    let scene = root.and_then(|root| scene(&mut reader, &root));
    reader.finish(scene)
}

fn scene(reader: &mut Reader, root: &Object) -> Option<Flat> {
    let mut remarks = Vec::new();
    let (min, max) = floors(reader, root)?;
    let lists = Lists { floor: ids(root, "floor_objects"), wall: ids(root, "wall_objects"), ceiling: ids(root, "ceiling_objects") };
    let mut found = Vec::new();
    let mut complete = true;
    let value = reader.required(root, "objects")?;
    for object in reader.objects(value, "objects")? {
        let thing = thing(reader, object, &lists);
        complete &= thing.is_some();
        found.extend(thing);
    }
    for (key, kind) in [("doors", Kind::Door), ("windows", Kind::Window)] {
        let Some(value) = Reader::optional(root, key) else { continue };
        for object in reader.objects(value, key)? {
            let opening = opening(reader, object, kind);
            complete &= opening.is_some();
            found.extend(opening);
        }
    }
    if found.len() > MAX_OBJECTS {
        reader.error(root.range, format!("a scene holds at most {MAX_OBJECTS} objects"));
        return None;
    }
    let height = height(reader, root).unwrap_or_else(|| {
        remarks.push(format!("The file does not give the height of the walls: {HEIGHT} m were taken."));
        HEIGHT
    });
    let title = Reader::optional(root, "query").and_then(|value| reader.text(value, "query")).unwrap_or_default();
    let dims = [rounded(max[0] - min[0]), rounded(max[1] - min[1]), height].map(Scalar::float);
    let middle = [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1])];
    let floor = material(reader, root);
    let mut scene = Flat { title, dims, interior: true, floor, wall: None, items: Vec::new(), remarks };
    let wishes = wishes(found.iter().map(|found| found.category.as_str()));
    for (found, wish) in found.iter().zip(wishes) {
        let item = item(found, wish, middle, &scene);
        scene.items.push(item);
    }
    complete.then_some(scene)
}

fn item(found: &Found, wish: String, middle: [f64; 2], scene: &Flat) -> Item {
    let [x, up, z] = found.center;
    let center = [x - middle[0], z - middle[1], up].map(rounded);
    let size = [found.size[0], found.size[2], found.size[1]].map(rounded);
    let dims = crate::scene::extents(size, found.turn);
    // Doors look into the room.
    let turn = match (found.kind, found.turn) {
        (Kind::Object, turn) => turn,
        (_, turn) => {
            let k = turn.axis().index();
            let out = if turn == Cardinal::XMax || turn == Cardinal::YMax { center[k] > 0.0 } else { center[k] < 0.0 };
            if out { turn.opposite() } else { turn }
        }
    };
    Item {
        wish,
        category: found.category.clone(),
        kind: found.kind,
        support: found.support.unwrap_or_else(|| scene.likely_support(center, size)),
        dims: dims.map(Scalar::float),
        color: None,
        anchors: anchored(center, dims, turn),
        turn,
        facing: Facing::Direction,
        remark: found.remark.clone(),
    }
}

/// A point as {x, y, z}, as [x, y, z], or as [x, z] on the ground.
fn point(reader: &mut Reader, value: &Value, what: &str) -> Option<Point> {
    match value {
        Value::Array(list) if list.elements.len() == 2 => {
            let [x, z] = [0, 1].map(|k| reader.number(&list.elements[k], what).map(Scalar::value));
            Some([x?, 0.0, z?])
        }
        Value::Array(_) => reader.triple(value, what),
        _ => {
            let object = reader.object(value, what)?;
            let [x, y, z] = ["x", "y", "z"].map(|key| {
                let value = reader.required(object, key)?;
                reader.number(value, key).map(Scalar::value)
            });
            Some([x?, y?, z?])
        }
    }
}

fn points(reader: &mut Reader, value: &Value, what: &str) -> Option<Vec<Point>> {
    let list = reader.list(value, what)?;
    let points: Vec<Option<Point>> = list.elements.iter().map(|element| point(reader, element, what)).collect();
    points.into_iter().collect()
}

/// The smallest and the largest coordinates of points.
fn bounds(points: &[Point]) -> Option<(Point, Point)> {
    let join = |pick: fn(f64, f64) -> f64| points.iter().copied().reduce(|a, b| [0, 1, 2].map(|k| pick(a[k], b[k])));
    Some((join(f64::min)?, join(f64::max)?))
}

/// What all floors cover, x and z.
fn floors(reader: &mut Reader, root: &Object) -> Option<([f64; 2], [f64; 2])> {
    let value = reader.required(root, "rooms")?;
    let mut corners = Vec::new();
    for room in reader.objects(value, "rooms")? {
        let polygon = Reader::optional(room, "floorPolygon").or_else(|| Reader::optional(room, "vertices"));
        let Some(polygon) = polygon else {
            reader.required(room, "floorPolygon");
            continue;
        };
        corners.extend(points(reader, polygon, "floorPolygon")?);
    }
    let found = bounds(&corners).filter(|(min, max)| max[0] > min[0] && max[2] > min[2]);
    let Some((min, max)) = found else {
        reader.error(value.range(), "the rooms cover no floor");
        return None;
    };
    Some(([min[0], min[2]], [max[0], max[2]]))
}

fn height(reader: &mut Reader, root: &Object) -> Option<f64> {
    if let Some(value) = Reader::optional(root, "wall_height") {
        return reader.size(value, "wall_height").map(Scalar::value);
    }
    let mut corners = Vec::new();
    for wall in root.get_array("walls")?.elements.iter().filter_map(|wall| wall.as_object()) {
        if let Some(polygon) = Reader::optional(wall, "polygon") {
            corners.extend(points(reader, polygon, "polygon")?);
        }
    }
    bounds(&corners).map(|(_, max)| max[1]).filter(|height| *height > 0.0)
}

/// The floor's material, if all rooms agree.
fn material(reader: &mut Reader, root: &Object) -> Option<Surface> {
    let rooms = root.get_array("rooms")?.elements.iter().filter_map(|room| room.as_object());
    let mut names = Vec::new();
    for room in rooms {
        let material = Reader::optional(room, "floorMaterial")?;
        let name = material.as_object().map_or(Some(material), |material| Reader::optional(material, "name"))?;
        names.push(reader.text(name, "floorMaterial")?);
    }
    names.dedup();
    if names.len() == 1 { names.pop().map(|asset| Surface { asset, color: None }) } else { None }
}

fn ids(root: &Object, key: &str) -> FxHashSet<String> {
    let entries = root.get_array(key).into_iter().flat_map(|list| &list.elements);
    entries.filter_map(|entry| Some(entry.as_object()?.get_string("id")?.value.to_string())).collect()
}

/// `bed-0|desk-1 (bedroom)` is a bed.
fn category(name: &str) -> String {
    let name = name.split(['|', '(']).next().unwrap_or_default().trim();
    let name = match name.rsplit_once('-') {
        Some((base, number)) if !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()) => base,
        _ => name,
    };
    let name = name.replace('_', " ");
    if name.trim().is_empty() { "Object".to_owned() } else { name.trim().to_owned() }
}

/// Degrees clockwise from +z, to the nearest quarter; what was rounded is told.
fn turned(degrees: f64) -> (Cardinal, Option<String>) {
    let quarters = libm::round(degrees / 90.0);
    // 0 looks along the file's +z, Y_MAX; each quarter clockwise is the cardinal before.
    let turn = Cardinal::from_turns(1 - (quarters % 4.0) as i64);
    (turn, (quarters * 90.0 != degrees).then(|| format!("turned by {} degrees", Scalar::float(degrees).shown())))
}

fn thing(reader: &mut Reader, object: &Object, lists: &Lists) -> Option<Found> {
    let id = Reader::optional(object, "id").and_then(|value| reader.text(value, "id"));
    let name = Reader::optional(object, "object_name").and_then(|value| reader.text(value, "object_name"));
    let asset = Reader::optional(object, "assetId").and_then(|value| reader.text(value, "assetId"));
    let center = reader.required(object, "position").and_then(|value| point(reader, value, "position"));
    let degrees = match Reader::optional(object, "rotation") {
        None => Some(0.0),
        Some(value @ Value::NumberLit(_)) => reader.number(value, "rotation").map(Scalar::value),
        Some(value) => point(reader, value, "rotation").map(|[_, y, _]| y),
    };
    let (center, (turn, remark)) = (center?, turned(degrees?));
    let is_in = |list: &FxHashSet<String>| id.as_ref().is_some_and(|id| list.contains(id));
    let size = size(reader, object, turn, is_in(&lists.floor).then_some(2.0 * center[1]))?;
    let support = match () {
        () if is_in(&lists.wall) => Some(Support::Mounted),
        () if is_in(&lists.ceiling) => Some(Support::Floating),
        () if is_in(&lists.floor) => Some(Support::Standing),
        () => None,
    };
    let category = category(&name.or(id).or(asset).unwrap_or_default());
    Some(Found { category, kind: Kind::Object, support, center, size, turn, remark })
}

/// The size after the turn, along x, y (up) and z; see the head of this file for where it is looked for.
fn size(reader: &mut Reader, object: &Object, turn: Cardinal, standing_height: Option<f64>) -> Option<Point> {
    let checked = |reader: &mut Reader, value: &Value, size: Point| {
        let is_size = size.iter().all(|extent| *extent > 0.0);
        if !is_size {
            reader.error(value.range(), "a size has three positive numbers");
        }
        is_size.then_some(size)
    };
    for key in ["size", "bbox", "boundingBox", "assetBoundingBox", "dimensions"] {
        if let Some(value) = Reader::optional(object, key) {
            let [x, y, z] = extents_of(reader, value, key)?;
            let [x, z, y] = crate::scene::extents([x, z, y], turn);
            return checked(reader, value, [x, y, z]);
        }
    }
    if let Some(value) = Reader::optional(object, "axisAlignedBoundingBox") {
        let size = extents_of(reader, value, "axisAlignedBoundingBox")?;
        return checked(reader, value, size);
    }
    if let (Some(value), Some(height)) = (Reader::optional(object, "vertices"), standing_height) {
        let corners = points(reader, value, "vertices")?;
        let (min, max) = bounds(&corners).unwrap_or_default();
        return checked(reader, value, [(max[0] - min[0]) / 100.0, height, (max[2] - min[2]) / 100.0]);
    }
    let at = object.range.start;
    reader.error(
        jsonc_parser::common::Range::new(at, at + 1),
        "the size of the object is missing: it has neither \"size\", \"bbox\", \"boundingBox\", \"assetBoundingBox\", \"dimensions\" nor \"axisAlignedBoundingBox\"",
    );
    None
}

/// {x, y, z}, [x, y, z], {size: …} or {min: …, max: …}.
fn extents_of(reader: &mut Reader, value: &Value, key: &str) -> Option<Point> {
    let Value::Object(object) = value else { return reader.triple(value, key) };
    if let Some(size) = Reader::optional(object, "size") {
        return point(reader, size, key);
    }
    if let (Some(min), Some(max)) = (Reader::optional(object, "min"), Reader::optional(object, "max")) {
        let (min, max) = (point(reader, min, "min"), point(reader, max, "max"));
        let (min, max) = (min?, max?);
        return Some([0, 1, 2].map(|k| max[k] - min[k]));
    }
    point(reader, value, key)
}

/// A door or window: a segment of a wall, and the height of the hole in it.
fn opening(reader: &mut Reader, object: &Object, kind: Kind) -> Option<Found> {
    let (segment_key, plain) = if kind == Kind::Door { ("doorSegment", "Door") } else { ("windowSegment", "Window") };
    let hole = reader.required(object, "holePolygon").and_then(|value| Some((value.range(), points(reader, value, "holePolygon")?)));
    let segment = reader.required(object, segment_key).and_then(|value| Some((value.range(), points(reader, value, segment_key)?)));
    let ((hole_range, hole), (segment_range, segment)) = (hole?, segment?);
    let (low, high) = bounds(&hole).map(|(min, max)| (min[1], max[1])).filter(|(low, high)| high > low).or_else(|| {
        reader.error(hole_range, "the hole has no height");
        None
    })?;
    let (min, max) = bounds(&segment)?;
    let (along_x, along_z) = (max[0] - min[0], max[2] - min[2]);
    if along_x.max(along_z) <= 0.0 {
        reader.error(segment_range, "the segment has no length");
        return None;
    }
    let (turn, size) = if along_x >= along_z {
        (Cardinal::YMax, [along_x, high - low, along_z.max(THICKNESS)])
    } else {
        (Cardinal::XMax, [along_x.max(THICKNESS), high - low, along_z])
    };
    let center = [0.5 * (min[0] + max[0]), 0.5 * (low + high), 0.5 * (min[2] + max[2])];
    let category = plain.to_owned();
    Some(Found { category, kind, support: Some(Support::Mounted), center, size, turn, remark: None })
}
