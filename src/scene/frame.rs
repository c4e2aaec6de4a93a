//! Coordinate frames: an origin and a turn. z is the same in all of them.

use crate::trace::{Arith, Num};

use super::terms::{Anchor, Axis, Cardinal};

/// A frame: its y axis points along `turn`, its x axis 90° clockwise from that.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Frame {
    /// World x and y of the origin, metres.
    pub origin: [Num; 2],
    /// The world direction of the frame's y axis.
    pub turn: Cardinal,
}

impl Frame {
    /// The frame of the scene itself.
    pub const WORLD: Frame = Frame { origin: [Num::plain(0.0), Num::plain(0.0)], turn: Cardinal::YMax };

    /// The world axis (0 or 1) along which an axis of the frame lies, and whether it runs against it. `None` for z.
    fn along(&self, axis: Axis) -> Option<(usize, bool)> {
        match axis {
            Axis::X => Some([(1, true), (0, false), (1, false), (0, true)][self.turn.index()]),
            Axis::Y => Some([(0, false), (1, false), (0, true), (1, true)][self.turn.index()]),
            Axis::Z => None,
        }
    }

    /// Which part of a box, on which world axis, an anchor in this frame means.
    pub fn anchor_in_world(&self, anchor: Anchor, axis: Axis) -> (Anchor, Axis) {
        match self.along(axis) {
            None => (anchor, Axis::Z),
            Some((world, against)) => (if against { anchor.flipped() } else { anchor }, Axis::ALL[world]),
        }
    }

    /// The coordinate of this frame at world coordinate `value` of the world axis that `axis` lies along.
    pub fn local<R: Arith + ?Sized>(&self, rec: &mut R, axis: Axis, value: Num) -> Num {
        match self.along(axis) {
            None => value,
            Some((world, against)) => {
                let distance = rec.sub(value, self.origin[world]);
                if against { rec.neg(distance) } else { distance }
            }
        }
    }

    /// The world coordinate of a coordinate of this frame. The negation of an integer
    /// zero has no sign.
    pub fn world<R: Arith + ?Sized>(&self, rec: &mut R, axis: Axis, value: Num, int: bool) -> Num {
        match self.along(axis) {
            None => value,
            Some((world, against)) => {
                let signed = match against {
                    false => value,
                    true if int => rec.sub(Num::plain(0.0), value),
                    true => rec.neg(value),
                };
                rec.add(self.origin[world], signed)
            }
        }
    }

    /// World coordinates of a point of this frame.
    pub fn point<R: Arith + ?Sized>(&self, rec: &mut R, x: Num, y: Num) -> [Num; 2] {
        let [x, y] = match self.turn {
            Cardinal::XMax => [y, rec.neg(x)],
            Cardinal::YMax => [x, y],
            Cardinal::XMin => [rec.neg(y), x],
            Cardinal::YMin => [rec.neg(x), rec.neg(y)],
        };
        [rec.add(self.origin[0], x), rec.add(self.origin[1], y)]
    }
}
