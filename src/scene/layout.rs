//! The layout: where everything is in the end, and which statements put it there.

use smallvec::SmallVec;

use crate::trace::{AS_WRITTEN, Arith, Handle, Num};

use super::origin::{OriginId, Origins};
use super::settle::extents;
use super::terms::{Anchor, Axis, Cardinal, Kind, ObjectId, Scalar, Support, Target};
use super::thing::{How, Known};
use super::world::{SceneInfo, World};

/// What the program told an object to face.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Told {
    /// Nothing.
    Never,
    /// A direction.
    Direction,
    /// A point.
    Point,
    /// An object or the scene.
    Toward(Target),
}

/// The geometry of a placed object: all that layout errors are about. World coordinates, metres.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Body {
    /// Object, door or window.
    pub kind: Kind,
    /// What holds it up.
    pub support: Support,
    /// Width (across its facing), depth (along it), height.
    pub dims: [f64; 3],
    /// The center of its box.
    pub center: [f64; 3],
    /// The smallest coordinates of its box.
    pub min: [f64; 3],
    /// The largest coordinates of its box.
    pub max: [f64; 3],
    /// Where it faces.
    pub turn: Cardinal,
    /// What it was told to face.
    pub told: Told,
    /// Whether its facing was set, or followed from walls or from its category.
    pub directed: bool,
    /// The last anchor of each axis; an axis without one was never written.
    pub anchors: [Option<Anchor>; 3],
}

impl Body {
    /// World extents: width across the facing, depth along it.
    pub fn size(&self) -> [f64; 3] {
        extents(self.dims, self.turn)
    }

    /// False where x or y was never written: such an object takes no part in layout errors.
    pub fn is_placed(&self) -> bool {
        self.anchors[0].is_some() && self.anchors[1].is_some()
    }

    /// The body moved to another center, with its facing as it is.
    pub fn at(&self, center: [f64; 3]) -> Body {
        let size = self.size();
        let min = [0, 1, 2].map(|k| center[k] - 0.5 * size[k]);
        let max = [0, 1, 2].map(|k| center[k] + 0.5 * size[k]);
        Body { center, min, max, ..*self }
    }
}

/// The last anchor of an axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlacedAnchor {
    /// The world axis.
    pub axis: Axis,
    /// The part of the box.
    pub anchor: Anchor,
    /// World coordinate.
    pub value: Scalar,
    /// The statement that wrote it.
    pub origin: OriginId,
    /// When it was written, counted in writes of the run.
    pub when: u32,
}

/// An object of the layout.
#[derive(Clone, PartialEq, Debug)]
pub struct Placed {
    /// Its geometry.
    pub body: Body,
    /// What the program calls it (`nightstands[1]`).
    pub path: String,
    /// Its category.
    pub name: String,
    /// Width, depth, height as the program gave them.
    pub dims: [Scalar; 3],
    /// The center as the program would read it.
    pub center: [Scalar; 3],
    /// RRGGBB.
    pub color: Option<String>,
    /// Whether physics may move it.
    pub dynamic: bool,
    /// The last anchors, in the order in which their axes were first written.
    pub anchors: SmallVec<[PlacedAnchor; 3]>,
    /// The statement that declared it.
    pub declared: OriginId,
    /// The statement that set its facing last, and when.
    pub faced: Option<(OriginId, u32)>,
    /// The number of how it settled, see [`Outcome::code`](super::Outcome::code).
    pub settled: Num,
    /// The direction that stands in place of what it was told to face, where it is not negative.
    pub instead: Num,
}

impl Placed {
    /// The last anchor of a world axis.
    pub fn anchor(&self, axis: Axis) -> Option<&PlacedAnchor> {
        self.anchors.iter().find(|anchor| anchor.axis == axis)
    }

    /// The records of the center's coordinates.
    pub fn handles(&self) -> [Handle; 3] {
        self.center.map(|coordinate| coordinate.num.handle)
    }
}

/// Something that a program did which means nothing.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Warning {
    /// What.
    pub kind: WarningKind,
    /// To which object.
    pub object: Option<ObjectId>,
    /// The statement.
    pub origin: OriginId,
}

/// What a [`Warning`] is about.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum WarningKind {
    /// An object was told to face itself.
    SelfFacing,
    /// A colour that is not RRGGBB.
    Color {
        /// What was given instead, cut short.
        text: String,
    },
}

/// Where everything is in the end.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The scene.
    pub scene: SceneInfo,
    /// The objects, in order of declaration.
    pub objects: Vec<Placed>,
    /// What the program did in vain.
    pub warnings: Vec<Warning>,
    /// What the origins of the layout mean.
    pub origins: Origins,
}

impl Layout {
    /// The geometry of all objects.
    pub fn bodies(&self) -> Vec<Body> {
        self.objects.iter().map(|object| object.body).collect()
    }
}

impl World {
    /// Settles what is not settled yet, in order of declaration, and gives the layout. Objects are called by their
    /// category and number until someone who knows the program's names says better.
    pub fn into_layout<R: Arith + ?Sized>(mut self, rec: &mut R) -> Layout {
        for index in 0..self.things.len() {
            self.settle(rec, ObjectId(index as u32));
        }
        let mut seen = vec![0_usize; self.categories.len()];
        let mut objects = Vec::with_capacity(self.things.len());
        for index in 0..self.things.len() {
            let category = self.things[index].category;
            seen[category] += 1;
            let path = format!("{} #{}", self.categories[category], seen[category]);
            objects.push(self.placed(rec, index, path));
        }
        Layout { scene: self.scene, objects, warnings: self.warnings, origins: self.origins }
    }

    fn placed<R: Arith + ?Sized>(&mut self, rec: &mut R, index: usize, path: String) -> Placed {
        let Known { outcome, code, turn } = self.settle(rec, ObjectId(index as u32));
        let thing = &self.things[index];
        let center = Axis::ALL.map(|axis| thing.center(rec, axis, turn));
        let told = match thing.told.map(|told| told.how) {
            None => Told::Never,
            Some(How::Direction(_)) => Told::Direction,
            Some(How::Point(_)) => Told::Point,
            Some(How::Toward(target)) => Told::Toward(target),
        };
        let body = Body {
            kind: thing.kind,
            support: thing.support,
            dims: thing.size(),
            center: [0.0; 3],
            min: [0.0; 3],
            max: [0.0; 3],
            turn: outcome.turn,
            told,
            directed: outcome.directed,
            anchors: thing.slots.map(|slot| slot.map(|slot| slot.anchor)),
        };
        let placed_anchor = |axis: &Axis| {
            let slot = thing.slots[axis.index()]?;
            Some(PlacedAnchor { axis: *axis, anchor: slot.anchor, value: slot.value, origin: slot.origin, when: slot.when })
        };
        Placed {
            body: body.at(center.map(Scalar::value)),
            path,
            name: self.categories[thing.category].clone(),
            dims: thing.dims,
            center,
            color: thing.color.clone(),
            dynamic: thing.dynamic,
            anchors: thing.order.iter().filter_map(placed_anchor).collect(),
            declared: thing.declared,
            faced: thing.told.map(|told| (told.origin, told.when)),
            settled: code,
            instead: thing.told.map_or(Num::plain(AS_WRITTEN), |told| told.instead),
        }
    }
}
