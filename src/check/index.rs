//! Which boxes may meet: a spatial index that leaves out no pair, and lets pass few that do not meet.

use rstar::{AABB, PointDistance, RTree, RTreeObject};

use crate::scene::Body;

/// Coordinates are cut off here in the index (not in what is measured), so that areas and distances stay finite. Metres.
const FAR: f64 = 1e15;

fn near(corner: [f64; 3]) -> [f64; 3] {
    corner.map(|value| value.clamp(-FAR, FAR))
}

/// A box and the object that it belongs to.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) object: u32,
    envelope: AABB<[f64; 3]>,
}

impl RTreeObject for Entry {
    type Envelope = AABB<[f64; 3]>;

    fn envelope(&self) -> AABB<[f64; 3]> {
        self.envelope
    }
}

impl PointDistance for Entry {
    fn distance_2(&self, point: &[f64; 3]) -> f64 {
        rstar::Envelope::distance_2(&self.envelope, point)
    }
}

/// An index of boxes.
pub(super) struct Index(RTree<Entry>);

impl Index {
    /// The boxes of bodies.
    pub(super) fn of_boxes<'a>(bodies: impl Iterator<Item = (usize, &'a Body)>) -> Index {
        Index::of(bodies.map(|(object, body)| (object, body.min, body.max)))
    }

    /// The tops of bodies, as flat boxes.
    pub(super) fn of_tops<'a>(bodies: impl Iterator<Item = (usize, &'a Body)>) -> Index {
        Index::of(bodies.map(|(object, body)| (object, [body.min[0], body.min[1], body.max[2]], body.max)))
    }

    fn of(boxes: impl Iterator<Item = (usize, [f64; 3], [f64; 3])>) -> Index {
        let entry = |(object, min, max)| Entry { object: object as u32, envelope: AABB::from_corners(near(min), near(max)) };
        Index(RTree::bulk_load(boxes.map(entry).collect()))
    }

    /// The objects whose box goes at least `depth` into the given one along each axis, and some that do not quite.
    pub(super) fn meeting(&self, min: [f64; 3], max: [f64; 3], depth: f64) -> impl Iterator<Item = usize> {
        let (mut min, mut max) = (near(min), near(max));
        let inset = 0.99 * depth;
        for k in 0..3 {
            if max[k] - min[k] > 2.0 * inset {
                min[k] += inset;
                max[k] -= inset;
            }
        }
        self.0.locate_in_envelope_intersecting(AABB::from_corners(min, max)).map(|entry| entry.object as usize)
    }

    /// All objects, nearest first, with a distance squared that is not more than the true one.
    pub(super) fn nearest(&self, point: [f64; 3]) -> impl Iterator<Item = (usize, f64)> {
        self.0.nearest_neighbor_iter_with_distance_2(near(point)).map(|(entry, distance)| (entry.object as usize, distance))
    }
}
