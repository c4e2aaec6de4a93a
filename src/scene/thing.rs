//! An object under way: what was written and told so far, and the coordinates that follow.

use smallvec::SmallVec;

use crate::trace::{Arith, Num};

use super::origin::OriginId;
use super::settle::{Outcome, extents};
use super::terms::{Anchor, Axis, Cardinal, Kind, Scalar, Support, Target};

/// The last anchor of an axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Slot {
    pub(super) anchor: Anchor,
    /// World coordinate.
    pub(super) value: Scalar,
    pub(super) origin: OriginId,
    /// When it was written, in writes of the run.
    pub(super) when: u32,
}

/// The last facing that an object was told.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Told {
    pub(super) how: How,
    /// The direction that may stand in its place.
    pub(super) instead: Num,
    pub(super) origin: OriginId,
    pub(super) when: u32,
}

/// What it was told, resolved to world coordinates.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum How {
    /// As the program gave it.
    Direction(Num),
    Point([Num; 2]),
    Toward(Target),
}

/// An object under way.
#[derive(Clone, Debug)]
pub(super) struct Thing {
    /// Index of the category.
    pub(super) category: usize,
    pub(super) kind: Kind,
    pub(super) support: Support,
    pub(super) dims: [Scalar; 3],
    pub(super) color: Option<String>,
    pub(super) dynamic: bool,
    pub(super) declared: OriginId,
    /// By world axis.
    pub(super) slots: [Option<Slot>; 3],
    /// Axes in the order in which they were first written.
    pub(super) order: SmallVec<[Axis; 3]>,
    pub(super) told: Option<Told>,
    /// `None` until settled, and again after a new facing.
    pub(super) outcome: Option<Known>,
}

/// How an object settled.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Known {
    pub(super) outcome: Outcome,
    /// The outcome's number.
    pub(super) code: Num,
    /// The number of its direction.
    pub(super) turn: Num,
}

impl Thing {
    pub(super) fn size(&self) -> [f64; 3] {
        self.dims.map(Scalar::value)
    }

    pub(super) fn anchors(&self) -> [Option<(Anchor, Num)>; 3] {
        self.slots.map(|slot| slot.map(|slot| (slot.anchor, slot.value.num)))
    }

    /// Half the extent on one axis, facing `turn`.
    fn half<R: Arith + ?Sized>(&self, rec: &mut R, axis: Axis, turn: Num) -> Num {
        let [width, depth, height] = self.size();
        match axis {
            Axis::Z => Num::plain(0.5 * height),
            _ if turn.handle.is_none() || width == depth => Num::plain(0.5 * extents(self.size(), Cardinal::of_turn(turn))[axis.index()]),
            Axis::X => rec.choose(turn, [0.5 * depth, 0.5 * width]),
            Axis::Y => rec.choose(turn, [0.5 * width, 0.5 * depth]),
        }
    }

    /// The center on one axis, facing `turn`.
    pub(super) fn center<R: Arith + ?Sized>(&self, rec: &mut R, axis: Axis, turn: Num) -> Scalar {
        let half = self.half(rec, axis, turn);
        match self.slots[axis.index()] {
            Some(Slot { anchor: Anchor::Center, value, .. }) => value,
            Some(Slot { anchor: Anchor::Min, value, .. }) => rec.add(value.num, half).into(),
            Some(Slot { anchor: Anchor::Max, value, .. }) => rec.sub(value.num, half).into(),
            None if axis == Axis::Z => half.into(),
            None => Num::plain(0.0).into(),
        }
    }

    /// A part of the box in world coordinates, facing `turn`.
    pub(super) fn part<R: Arith + ?Sized>(&self, rec: &mut R, anchor: Anchor, axis: Axis, turn: Num) -> Scalar {
        let center = self.center(rec, axis, turn);
        let half = self.half(rec, axis, turn);
        match anchor {
            Anchor::Center => center,
            Anchor::Min => rec.sub(center.num, half).into(),
            Anchor::Max => rec.add(center.num, half).into(),
        }
    }
}
