//! What formats that draw can show of a layout: boxes and the surfaces of the room.

use super::colour::{self, Rgb};
use crate::scene::{Layout, Placed, SceneInfo};

/// Coordinates beyond this are left out, metres: simulators and 32-bit floats end not far behind.
const FARTHEST: f64 = 1e9;
/// Extents below this are left out, metres.
const THINNEST: f64 = 1e-6;
/// How thick floor and walls are where they need to be boxes, metres.
const THICKNESS: f64 = 0.1;

/// An object that can be shown.
#[derive(Clone, Copy)]
pub(super) struct Piece<'a> {
    /// Its place in the layout.
    pub(super) index: usize,
    pub(super) object: &'a Placed,
    pub(super) colour: Rgb,
}

/// Why an object cannot be shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Hidden {
    /// x or y was never written.
    Unplaced,
    /// Its box is not finite, or too far away, too large or too thin.
    Extreme,
}

impl Hidden {
    pub(super) fn reason(self) -> &'static str {
        match self {
            Hidden::Unplaced => "it was never placed",
            Hidden::Extreme => "its box is not finite, or too large, too thin or too far away to be drawn",
        }
    }
}

/// The floor or a wall.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Surface {
    pub(super) name: &'static str,
    pub(super) colour: Rgb,
    /// Its corners, counterclockwise as seen from inside. World coordinates.
    pub(super) corners: [[f64; 3]; 4],
    /// Toward the inside.
    pub(super) normal: [f64; 3],
    /// The same as a box that lies outside: its center and extents.
    pub(super) center: [f64; 3],
    pub(super) size: [f64; 3],
}

/// What can be shown of a layout.
pub(super) struct Pieces<'a> {
    pub(super) shown: Vec<Piece<'a>>,
    /// What cannot, in order.
    pub(super) hidden: Vec<(&'a Placed, Hidden)>,
    /// Floor first, then the walls of an interior; empty where the scene's own box cannot be drawn.
    pub(super) surfaces: Vec<Surface>,
}

fn drawable(min: [f64; 3], max: [f64; 3]) -> bool {
    (0..3).all(|k| min[k].abs() <= FARTHEST && max[k].abs() <= FARTHEST && max[k] - min[k] >= THINNEST)
}

impl<'a> Pieces<'a> {
    pub(super) fn of(layout: &'a Layout) -> Pieces<'a> {
        let mut pieces = Pieces { shown: Vec::new(), hidden: Vec::new(), surfaces: surfaces(&layout.scene) };
        for (index, (object, colour)) in layout.objects.iter().zip(colour::objects(layout)).enumerate() {
            let body = &object.body;
            if !body.is_placed() {
                pieces.hidden.push((object, Hidden::Unplaced));
            } else if drawable(body.min, body.max) {
                pieces.shown.push(Piece { index, object, colour });
            } else {
                pieces.hidden.push((object, Hidden::Extreme));
            }
        }
        pieces
    }
}

fn surfaces(scene: &SceneInfo) -> Vec<Surface> {
    let [width, depth, height] = scene.size();
    let (x, y, z, t) = (0.5 * width, 0.5 * depth, height, THICKNESS);
    if !drawable([-x, -y, 0.0], [x, y, z]) {
        return Vec::new();
    }
    let [floor, paint] = colour::surfaces(scene);
    let surface = |name, colour, corners, normal, center, size| Surface { name, colour, corners, normal, center, size };
    let ground = [[-x, -y, 0.0], [x, -y, 0.0], [x, y, 0.0], [-x, y, 0.0]];
    let mut surfaces = vec![surface("floor", floor, ground, [0.0, 0.0, 1.0], [0.0, 0.0, -0.5 * t], [width, depth, t])];
    if scene.interior {
        // A wall from one corner of the room to another, seen from inside with its first corner on the left.
        let wall = |name, a: [f64; 2], b: [f64; 2], normal: [f64; 3]| {
            let corners = [[a[0], a[1], 0.0], [b[0], b[1], 0.0], [b[0], b[1], z], [a[0], a[1], z]];
            let [cx, cy] = [0, 1].map(|k| 0.5 * (a[k] + b[k]) - 0.5 * t * normal[k]);
            let [sx, sy] = [0, 1].map(|k| if normal[k] == 0.0 { 2.0 * [x, y][k] } else { t });
            surface(name, paint, corners, normal, [cx, cy, 0.5 * z], [sx, sy, z])
        };
        surfaces.extend([
            wall("right_wall", [x, y], [x, -y], [-1.0, 0.0, 0.0]),
            wall("top_wall", [-x, y], [x, y], [0.0, -1.0, 0.0]),
            wall("left_wall", [-x, -y], [-x, y], [1.0, 0.0, 0.0]),
            wall("bottom_wall", [x, -y], [-x, -y], [0.0, 1.0, 0.0]),
        ]);
    }
    surfaces
}
