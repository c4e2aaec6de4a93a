//! Whom to blame for a layout error: the object, the statement, and how far something would have to move.

use crate::scene::{Axis, Cardinal, OriginId, Placed};

use super::measure::{self, Bounds};
use super::rules::Rules;
use super::violation::{ErrorKind, Violation};

/// What a layout error is told from.
#[derive(Clone, Copy)]
pub(super) struct Case<'a> {
    pub(super) objects: &'a [Placed],
    pub(super) bounds: Bounds,
    pub(super) rules: &'a Rules,
}

/// Whom to blame.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Blame {
    /// The object that should move or turn: of two, the one that was placed later.
    pub(super) subject: usize,
    /// The other object that takes part.
    pub(super) other: Option<usize>,
    /// The statement.
    pub(super) origin: OriginId,
    /// The axis along which the least movement clears the error, where a movement does.
    pub(super) axis: Option<Axis>,
    /// That movement, or how far the object is from where it should be. Metres; 0 where the error has no length.
    pub(super) metres: f64,
}

/// How a standing object misses what should carry it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Miss {
    /// The height of its bottom above the support's top; negative below it.
    pub(super) above: f64,
    /// How far its center lies beside the support along x and y.
    pub(super) beside: [f64; 2],
}

/// When an object got its place, in writes of the run.
fn placed_at(object: &Placed) -> u32 {
    object.anchors.iter().map(|anchor| anchor.when).max().unwrap_or(0)
}

/// The statement that gave an object its place last.
pub(super) fn placement(object: &Placed) -> OriginId {
    object.anchors.iter().max_by_key(|anchor| anchor.when).map_or(object.declared, |anchor| anchor.origin)
}

/// The statement that set the first of some axes that any statement set.
fn set_along(object: &Placed, axes: impl IntoIterator<Item = Axis>) -> OriginId {
    axes.into_iter().find_map(|axis| object.anchor(axis)).map_or(object.declared, |anchor| anchor.origin)
}

/// The axes, that of the smallest value first.
fn by_least(values: [f64; 3]) -> [Axis; 3] {
    let mut axes = Axis::ALL;
    axes.sort_by(|a, b| values[a.index()].total_cmp(&values[b.index()]));
    axes
}

impl Case<'_> {
    pub(super) fn blame(&self, violation: &Violation) -> Blame {
        let subject = violation.culprit as usize;
        let object = &self.objects[subject];
        let alone = |origin, axis, metres| Blame { subject, other: None, origin, axis, metres };
        match (violation.kind, violation.other) {
            (ErrorKind::Overlap | ErrorKind::Clearance, Some(other)) => self.pair(violation.kind, subject, other as usize),
            (ErrorKind::OutOfBounds, _) => {
                let (axis, _, metres) = self.side(subject);
                alone(set_along(object, [axis]), Some(axis), metres)
            }
            (ErrorKind::Standing, _) => {
                let support = violation.support.map(|index| index as usize);
                let miss = self.miss(subject, support);
                let [x, y] = miss.beside;
                let axes = by_least([-x, -y, -miss.above.abs()]);
                Blame { other: support, ..alone(set_along(object, axes), Some(axes[0]), miss.above.abs() + x + y) }
            }
            (ErrorKind::Mounted, _) => {
                let axis = self.wall_axis(subject);
                let turned = if self.hangs_by_narrow_side(subject) { object.faced } else { None };
                let origin = turned.map_or_else(|| set_along(object, [axis]), |(origin, _)| origin);
                alone(origin, Some(axis), violation.metres)
            }
            (ErrorKind::Facing, other) => {
                let other = other.map(|index| index as usize);
                Blame { other, ..alone(self.faced_or(object, [Axis::X, Axis::Y]), None, 0.0) }
            }
            (ErrorKind::FacingWall, _) => alone(self.faced_or(object, [object.body.turn.axis()]), None, 0.0),
            (ErrorKind::ShortSide, _) => {
                let axes = self.short_wall(subject).map(Cardinal::axis);
                alone(self.faced_or(object, axes), None, 0.0)
            }
            (ErrorKind::Overlap | ErrorKind::Clearance | ErrorKind::Unplaced, _) => alone(object.declared, None, 0.0),
        }
    }

    /// The statement that set the facing, else one that set an axis.
    fn faced_or(&self, object: &Placed, axes: impl IntoIterator<Item = Axis>) -> OriginId {
        object.faced.map_or_else(|| set_along(object, axes), |(origin, _)| origin)
    }

    fn pair(&self, kind: ErrorKind, culprit: usize, other: usize) -> Blame {
        let (a, b) = (&self.objects[culprit], &self.objects[other]);
        let kept = (kind == ErrorKind::Clearance).then(|| measure::clearance_box(self.rules, &a.body)).flatten();
        let (min, max) = kept.unwrap_or((a.body.min, a.body.max));
        let depths = measure::penetration(min, max, &b.body);
        let axes = by_least(depths);
        let (subject, second) = if placed_at(b) > placed_at(a) { (other, culprit) } else { (culprit, other) };
        let origin = set_along(&self.objects[subject], axes);
        Blame { subject, other: Some(second), origin, axis: Some(axes[0]), metres: depths[axes[0].index()] }
    }

    /// Where an object sticks out most: the axis, whether at its far end, how far.
    pub(super) fn side(&self, index: usize) -> (Axis, bool, f64) {
        let (body, bounds) = (&self.objects[index].body, &self.bounds);
        let low = Axis::ALL.map(|axis| (axis, false, bounds.min[axis.index()] - body.min[axis.index()]));
        let high = Axis::ALL.map(|axis| (axis, true, body.max[axis.index()] - bounds.max[axis.index()]));
        let counted = high.into_iter().filter(|(axis, ..)| *axis != Axis::Z || bounds.interior);
        low.into_iter().chain(counted).fold(low[0], |worst, side| if side.2 > worst.2 { side } else { worst })
    }

    pub(super) fn miss(&self, index: usize, support: Option<usize>) -> Miss {
        let body = &self.objects[index].body;
        let Some(support) = support.map(|index| &self.objects[index].body) else {
            return Miss { above: body.min[2], beside: [0.0; 2] };
        };
        let beside = [0, 1].map(|k| (support.min[k] - body.center[k]).max(0.0) + (body.center[k] - support.max[k]).max(0.0));
        Miss { above: body.min[2] - support.max[2], beside }
    }

    /// The axis toward the wall that a mounted object should hang on.
    fn wall_axis(&self, index: usize) -> Axis {
        let body = &self.objects[index].body;
        let ([x, y], size) = (measure::wall_gaps(&self.bounds, body), body.size());
        if size[0] < size[1] || size[0] == size[1] && x < y { Axis::X } else { Axis::Y }
    }

    /// Whether a mounted object touches a wall, but not with its wider side.
    pub(super) fn hangs_by_narrow_side(&self, index: usize) -> bool {
        let gaps = measure::wall_gaps(&self.bounds, &self.objects[index].body);
        gaps[1 - self.wall_axis(index).index()] < self.rules.tolerance
    }

    /// The wall that an object has its short side to.
    pub(super) fn short_wall(&self, index: usize) -> Option<Cardinal> {
        let body = &self.objects[index].body;
        measure::short_side(body, measure::against(self.rules, &self.bounds, body))
    }
}
