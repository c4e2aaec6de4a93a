//! What is drawn of a layout: boxes cut to the room of the picture, and their faces.

use crate::check::measure::Bounds;
use crate::scene::{Body, Kind, Layout, Support};

use super::colour::{self, Rgb};

/// A box, in metres.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Cuboid {
    /// The smallest coordinates.
    pub min: [f64; 3],
    /// The largest coordinates.
    pub max: [f64; 3],
}

impl Cuboid {
    /// The common part of two boxes, if it has a volume or at least an area.
    pub fn cut(&self, other: &Cuboid) -> Option<Cuboid> {
        let cut = Cuboid { min: [0, 1, 2].map(|k| self.min[k].max(other.min[k])), max: [0, 1, 2].map(|k| self.max[k].min(other.max[k])) };
        (0..3).all(|k| cut.min[k] <= cut.max[k]).then_some(cut)
    }

    /// The smallest box around two.
    pub fn with(&self, other: &Cuboid) -> Cuboid {
        Cuboid { min: [0, 1, 2].map(|k| self.min[k].min(other.min[k])), max: [0, 1, 2].map(|k| self.max[k].max(other.max[k])) }
    }

    /// Its middle.
    pub fn center(&self) -> [f64; 3] {
        [0, 1, 2].map(|k| 0.5 * (self.min[k] + self.max[k]))
    }

    /// Its eight corners.
    pub fn corners(&self) -> [[f64; 3]; 8] {
        std::array::from_fn(|corner| [0, 1, 2].map(|k| if corner >> k & 1 == 0 { self.min[k] } else { self.max[k] }))
    }
}

/// A body of the picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Solid {
    /// The object.
    pub object: u32,
    /// The part of it that lies in the room of the picture.
    pub cuboid: Cuboid,
    /// Its colour under full light.
    pub colour: Rgb,
    /// How much it hides of what is behind, from 0 to 1.
    pub opacity: f32,
}

/// The scene, and all of it that is drawn.
#[derive(Debug)]
pub struct Space<'a> {
    /// The layout.
    pub layout: &'a Layout,
    /// The box of the scene.
    pub bounds: Bounds,
    /// Nothing is drawn beyond.
    pub limits: Cuboid,
    /// The bodies, in order of declaration.
    pub solids: Vec<Solid>,
    /// Objects whose x or y was never written: they are only hinted at.
    pub ghosts: Vec<Solid>,
    /// How many objects lie outside the room of the picture, or are too many.
    pub left_out: usize,
}

/// More boxes than this are not drawn.
const MOST: usize = 10_000;

/// How far the picture reaches beyond the scene, as a part of its longer side.
const BEYOND: f64 = 0.35;

impl<'a> Space<'a> {
    /// What is drawn of a layout.
    pub fn of(layout: &'a Layout) -> Space<'a> {
        let bounds = Bounds::of(&layout.scene);
        let limits = limits(&bounds);
        let mut space = Space { layout, bounds, limits, solids: Vec::new(), ghosts: Vec::new(), left_out: 0 };
        for (index, (object, colour)) in layout.objects.iter().zip(colour::objects(layout)).enumerate() {
            let body = &object.body;
            let finite = body.min.iter().chain(&body.max).all(|coordinate| coordinate.is_finite());
            let cuboid = Cuboid { min: body.min, max: body.max }.cut(&limits).filter(|_| finite);
            let list = if body.is_placed() { &mut space.solids } else { &mut space.ghosts };
            match cuboid {
                Some(cuboid) if list.len() < MOST => list.push(Solid { object: index as u32, cuboid, colour, opacity: 1.0 }),
                _ => space.left_out += 1,
            }
        }
        space
    }

    /// The body of an object.
    pub fn body(&self, object: u32) -> &Body {
        &self.layout.objects[object as usize].body
    }

    /// The longer side of the floor. Metres.
    pub fn longest(&self) -> f64 {
        (self.bounds.max[0] - self.bounds.min[0]).max(self.bounds.max[1] - self.bounds.min[1])
    }

    /// How thick walls and floor are drawn. Metres.
    pub fn thickness(&self) -> f64 {
        0.016 * self.longest()
    }

    /// The floor, as a box without height.
    pub fn floor(&self) -> Cuboid {
        let (min, max) = (self.bounds.min, self.bounds.max);
        Cuboid { min, max: [max[0], max[1], 0.0] }
    }

    /// Whether an object hangs at the cut-away wall of an axis (its lower side for y, its upper for x) and would hide the room.
    pub fn hangs_before(&self, object: u32) -> bool {
        let body = self.body(object);
        let near_y = (body.min[1] - self.bounds.min[1]).abs() < 0.15;
        let near_x = (self.bounds.max[0] - body.max[0]).abs() < 0.15;
        let size = body.size();
        let along_y = near_y && size[1] <= size[0];
        let along_x = near_x && size[0] <= size[1];
        self.bounds.interior && (body.kind != Kind::Object || body.support == Support::Mounted) && (along_x || along_y)
    }
}

fn limits(bounds: &Bounds) -> Cuboid {
    let size = [0, 1, 2].map(|k| bounds.max[k] - bounds.min[k]);
    let beyond = BEYOND * size[0].max(size[1]);
    let above = beyond.max(0.5 * size[2]);
    Cuboid {
        min: [bounds.min[0] - beyond, bounds.min[1] - beyond, -beyond],
        max: [bounds.max[0] + beyond, bounds.max[1] + beyond, bounds.max[2] + above],
    }
}

/// A part of a side of a box: a rectangle in a plane across an axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Face {
    /// Which of the solids.
    pub solid: usize,
    /// The axis across the plane.
    pub axis: usize,
    /// Where on that axis the plane is.
    pub at: f64,
    /// Whether the side looks toward larger coordinates.
    pub up: bool,
    /// The smallest coordinates on the two other axes, in their order.
    pub min: [f64; 2],
    /// The largest coordinates on the two other axes.
    pub max: [f64; 2],
}

/// The two axes in the plane across an axis.
pub fn others(axis: usize) -> [usize; 2] {
    [[1, 2], [0, 2], [0, 1]][axis]
}

impl Face {
    /// One side of a box.
    pub fn of(solid: usize, cuboid: &Cuboid, axis: usize, up: bool) -> Face {
        let [a, b] = others(axis);
        let at = if up { cuboid.max[axis] } else { cuboid.min[axis] };
        Face { solid, axis, at, up, min: [cuboid.min[a], cuboid.min[b]], max: [cuboid.max[a], cuboid.max[b]] }
    }

    /// A point of the plane in the world.
    pub fn point(&self, at: [f64; 2]) -> [f64; 3] {
        let [a, b] = others(self.axis);
        let mut point = [self.at; 3];
        (point[a], point[b]) = (at[0], at[1]);
        point
    }

    /// The corners, around.
    pub fn corners(&self) -> [[f64; 2]; 4] {
        [self.min, [self.max[0], self.min[1]], self.max, [self.min[0], self.max[1]]]
    }

    /// The extent on one of the three axes.
    pub fn span(&self, axis: usize) -> (f64, f64) {
        match others(self.axis).iter().position(|other| *other == axis) {
            Some(k) => (self.min[k], self.max[k]),
            None => (self.at, self.at),
        }
    }

    /// The parts below and above a plane that goes through it.
    pub fn split(&self, axis: usize, at: f64) -> (Face, Face) {
        let (mut below, mut above) = (*self, *self);
        if let Some(k) = others(self.axis).iter().position(|other| *other == axis) {
            below.max[k] = at;
            above.min[k] = at;
        }
        (below, above)
    }
}

/// The part of a convex polygon that lies in a rectangle.
pub fn clipped(polygon: &[[f64; 2]], min: [f64; 2], max: [f64; 2]) -> Vec<[f64; 2]> {
    let mut points = polygon.to_vec();
    for (k, bound, sign) in [(0, min[0], 1.0), (0, max[0], -1.0), (1, min[1], 1.0), (1, max[1], -1.0)] {
        let inside = |p: &[f64; 2]| sign * (p[k] - bound) >= 0.0;
        let mut kept = Vec::with_capacity(points.len() + 2);
        for (i, here) in points.iter().enumerate() {
            let next = &points[(i + 1) % points.len()];
            if inside(here) {
                kept.push(*here);
            }
            if inside(here) != inside(next) {
                let part = (bound - here[k]) / (next[k] - here[k]);
                let mut cut = [here[0] + part * (next[0] - here[0]), here[1] + part * (next[1] - here[1])];
                cut[k] = bound;
                kept.push(cut);
            }
        }
        points = kept;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_are_cut_to_a_rectangle() {
        let triangle = [[-1.0, 0.5], [0.5, 0.5], [0.5, 2.0]];
        let cut = clipped(&triangle, [0.0, 0.0], [1.0, 1.0]);
        let corners: Vec<[f64; 2]> = vec![[0.0, 0.5], [0.5, 0.5], [0.5, 1.0], [0.0, 1.0]];
        assert_eq!(cut.len(), corners.len());
        assert!(corners.iter().all(|corner| cut.contains(corner)), "{cut:?}");
        assert!(clipped(&triangle, [3.0, 3.0], [4.0, 4.0]).is_empty());
    }
}
