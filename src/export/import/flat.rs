//! A scene as a flat program will have it, whatever file it came from.

use crate::scene::{
    Anchor, Axis, Cardinal, FacingSpec, Given, Kind, Layout, NewObject, ObjectId, Origins, Scalar, SceneError, Support, Surface, Target,
    World,
};
use crate::trace::Plain;

/// How often facings are tried before all are written as directions.
const TRIES: usize = 8;

/// A scene.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Flat {
    pub(super) title: String,
    pub(super) dims: [Scalar; 3],
    pub(super) interior: bool,
    pub(super) floor: Option<Surface>,
    pub(super) wall: Option<Surface>,
    pub(super) items: Vec<Item>,
    /// What was taken where the file says nothing; comments at the top.
    pub(super) remarks: Vec<String>,
}

/// An object.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Item {
    /// What the program should call it: a path (`chairs[1]`), or any text.
    pub(super) wish: String,
    pub(super) category: String,
    pub(super) kind: Kind,
    pub(super) support: Support,
    pub(super) dims: [Scalar; 3],
    pub(super) color: Option<String>,
    /// One anchor an axis, in the order in which they are written.
    pub(super) anchors: Vec<(Axis, Anchor, Scalar)>,
    /// Where it faces in the end.
    pub(super) turn: Cardinal,
    pub(super) facing: Facing,
    /// Of its facing; a comment behind the statement.
    pub(super) remark: Option<String>,
}

/// What the program says about a facing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Facing {
    /// Nothing: it follows.
    Free,
    /// The direction.
    Direction,
    /// What it faces.
    Toward(Target),
}

/// A number rounded to a micrometre, for what was computed and not read.
pub(super) fn rounded(value: f64) -> f64 {
    let micro = libm::round(value * 1e6) / 1e6;
    if micro.is_finite() { micro + 0.0 } else { value }
}

/// The statements that give a box its center: on each axis the part of the box whose coordinate is written shortest, to the last bit.
pub(super) fn anchored(center: [f64; 3], dims: [f64; 3], turn: Cardinal) -> Vec<(Axis, Anchor, Scalar)> {
    let extents = crate::scene::extents(dims, turn);
    Axis::ALL
        .map(|axis| (axis, center[axis.index()], 0.5 * extents[axis.index()]))
        .map(|(axis, at, half)| shortest(axis, at, half))
        .to_vec()
}

fn shortest(axis: Axis, center: f64, half: f64) -> (Axis, Anchor, Scalar) {
    let length = |value: f64| format!("{:?}", value.abs()).len();
    // What stands on something is told by its bottom.
    let order = if axis == Axis::Z { [Anchor::Min, Anchor::Center, Anchor::Max] } else { [Anchor::Center, Anchor::Min, Anchor::Max] };
    let found = order.into_iter().filter_map(|anchor| {
        let value = match anchor {
            Anchor::Center => Some(center),
            Anchor::Min => rounds_to(center - half, |value| value + half == center),
            Anchor::Max => rounds_to(center + half, |value| value - half == center),
        };
        value.map(|value| (anchor, value + 0.0))
    });
    let best = found.min_by_key(|(_, value)| length(*value)).unwrap_or((Anchor::Center, center));
    (axis, best.0, Scalar::float(best.1))
}

/// The shortest decimal near a value for which a condition holds.
fn rounds_to(value: f64, holds: impl Fn(f64) -> bool) -> Option<f64> {
    let exact = holds(value).then_some(value);
    if !value.is_finite() || value.abs() > 1e9 {
        return exact;
    }
    let decimals = (1..=12).filter_map(|digits| format!("{value:.digits$}").parse().ok());
    decimals.into_iter().find(|rounded| holds(*rounded)).or(exact)
}

impl Flat {
    /// What holds an object up, from where it is: a wall if it touches one and not the ground, else what is under it.
    pub(super) fn likely_support(&self, center: [f64; 3], size: [f64; 3]) -> Support {
        let near = |a: f64, b: f64| (a - b).abs() < 0.05;
        let [width, depth, height] = self.dims.map(Scalar::value);
        let (bottom, top) = (center[2] - 0.5 * size[2], center[2] + 0.5 * size[2]);
        let at_wall = [(0, width), (1, depth)].iter().any(|&(k, extent)| near(center[k].abs() + 0.5 * size[k], 0.5 * extent));
        if bottom < 0.05 {
            Support::Standing
        } else if at_wall {
            Support::Mounted
        } else if self.interior && near(top, height) {
            Support::Floating
        } else {
            Support::Standing
        }
    }

    /// The layout of the program that this becomes.
    fn layout(&self) -> Result<Layout, SceneError> {
        let mut world = World::new();
        let nowhere = Origins::NOWHERE;
        world.set_size(&mut Plain, &self.dims.map(Given::from))?;
        world.set_interior(self.interior);
        for item in &self.items {
            let (dims, support) = (item.dims.map(Given::from), Scalar::int(item.support as i64).into());
            let new = NewObject { kind: item.kind, name: &item.declared_name(), dims, support, color: None, dynamic: false };
            world.add_object(&mut Plain, &new, nowhere)?;
        }
        for (index, item) in self.items.iter().enumerate() {
            let id = ObjectId(index as u32);
            for (axis, anchor, value) in &item.anchors {
                world.write(&mut Plain, Target::Object(id), *anchor, *axis, &(*value).into(), nowhere)?;
            }
            let facing = match item.facing {
                Facing::Free => FacingSpec::Nothing,
                Facing::Direction => FacingSpec::Number(Scalar::int(item.turn.index() as i64)),
                Facing::Toward(target) => FacingSpec::Toward(target),
            };
            world.set_facing(&mut Plain, id, &facing, crate::trace::Handle::NONE, nowhere)?;
        }
        Ok(world.into_layout(&mut Plain))
    }

    /// The same scene, with directions in place of the facings that would not come out as the file has them.
    pub(super) fn settled(mut self) -> Result<Flat, String> {
        for attempt in 1..=TRIES {
            let layout = self.layout().map_err(|error| error.message)?;
            let turned: Vec<usize> =
                (0..self.items.len()).filter(|&index| layout.objects[index].body.turn != self.items[index].turn).collect();
            if turned.is_empty() {
                return Ok(self);
            }
            let all = 0..if attempt + 1 == TRIES { self.items.len() } else { 0 };
            for index in turned.into_iter().chain(all) {
                self.direct(index);
            }
        }
        Ok(self)
    }

    fn direct(&mut self, index: usize) {
        let wish = match self.items[index].facing {
            Facing::Direction | Facing::Free => None,
            Facing::Toward(Target::Scene) => Some("the scene".to_owned()),
            Facing::Toward(Target::Object(id)) => self.items.get(id.index()).map(|other| other.wish.clone()),
        };
        let item = &mut self.items[index];
        item.facing = Facing::Direction;
        item.remark = wish.map(|wish| format!("was told to face {wish}")).or(item.remark.take());
    }
}

impl Item {
    /// The name with which a program declares the category: a number at the end of a name is dropped, so one that belongs to the
    /// category needs another behind it.
    pub(super) fn declared_name(&self) -> String {
        if crate::scene::category_of(&self.category) == self.category { self.category.clone() } else { format!("{} 1", self.category) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_is_written_the_shortest_way_that_is_exact() {
        let center = [0.9 + 0.25, -1.0 / 3.0, 0.3];
        let anchors = anchored(center, [0.5, 0.4, 0.6], Cardinal::YMax);
        let told: Vec<(Anchor, f64)> = anchors.iter().map(|(_, anchor, value)| (*anchor, value.value())).collect();
        assert_eq!([told[0], told[2]], [(Anchor::Min, 0.9), (Anchor::Min, 0.0)]);
        assert_eq!(told[1], (Anchor::Center, -1.0 / 3.0));
    }
}
