//! Settling: which way an object faces, decided from everything that the decision reads.
//!
//! The decision is one function of one value, [`decide`] of a [`Question`], so that a replay can ask it again with
//! other numbers: how an object settles is a number of the record like all others, and so is the extent that follows from it.

use crate::trace::{Derivation, Num};

use super::terms::{Anchor, Axis, Cardinal};

/// The last anchor of each world axis.
pub type Anchors<N> = [Option<(Anchor, N)>; 3];

/// Which way an object faces, and whether something decided it (see PSDL on *directed* objects).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Outcome {
    /// The direction.
    pub turn: Cardinal,
    /// Set by the program, or followed from walls or from a directed object of the category.
    pub directed: bool,
}

impl Outcome {
    /// One number for both: the direction's, and 4 more where it is directed.
    pub fn code(self) -> f64 {
        f64::from(self.turn as u8 + if self.directed { 4 } else { 0 })
    }

    /// The outcome that a number stands for.
    pub fn from_code(code: f64) -> Outcome {
        Outcome { turn: Cardinal::from_turns(code as i64), directed: code >= 4.0 }
    }
}

/// What an object was told to face.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Aim<N> {
    /// A direction, in turns or degrees.
    Direction(N),
    /// A point, in world coordinates.
    Point([N; 2]),
    /// The scene.
    Scene,
    /// Another object, as it is when the question is asked.
    Object {
        /// Its width, depth, height.
        dims: [f64; 3],
        /// Its anchors.
        anchors: Anchors<N>,
        /// The number of its direction; in a cycle that is not decided yet, that of `YMax`.
        turn: N,
    },
    /// Nothing. `precedent` is the first settled object of the category.
    Free {
        /// The number of its outcome.
        precedent: Option<N>,
    },
}

/// Everything that a settling reads. `N` is a float, or a number with its place in the record.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Question<N> {
    /// Width, depth, height of the object.
    pub dims: [f64; 3],
    /// Its anchors.
    pub anchors: Anchors<N>,
    /// Width, depth, height of the scene.
    pub scene: [f64; 3],
    /// What it was told.
    pub aim: Aim<N>,
    /// The direction that stands in place of what it was told, where it is not negative.
    pub instead: N,
}

fn map_anchors<N: Copy, M>(anchors: &Anchors<N>, f: &mut impl FnMut(N) -> M) -> Anchors<M> {
    anchors.map(|slot| slot.map(|(anchor, value)| (anchor, f(value))))
}

impl<N: Copy> Question<N> {
    /// The same question with other numbers.
    pub fn map<M>(&self, mut f: impl FnMut(N) -> M) -> Question<M> {
        let anchors = map_anchors(&self.anchors, &mut f);
        let aim = match &self.aim {
            Aim::Direction(turn) => Aim::Direction(f(*turn)),
            Aim::Point(point) => Aim::Point(point.map(&mut f)),
            Aim::Scene => Aim::Scene,
            Aim::Object { dims, anchors, turn } => Aim::Object { dims: *dims, anchors: map_anchors(anchors, &mut f), turn: f(*turn) },
            Aim::Free { precedent } => Aim::Free { precedent: precedent.map(&mut f) },
        };
        Question { dims: self.dims, anchors, scene: self.scene, aim, instead: f(self.instead) }
    }
}

/// A settling as a number of the record: that of its outcome.
#[derive(Debug)]
pub(super) struct Settled(pub(super) Question<Num>);

impl Derivation for Settled {
    fn value(&self, now: &dyn Fn(Num) -> f64) -> f64 {
        decide(&self.0.map(now)).code()
    }
}

/// World extents of an object of width, depth, height `dims` that faces `turn`: width across, depth along.
pub fn extents(dims: [f64; 3], turn: Cardinal) -> [f64; 3] {
    let [width, depth, height] = dims;
    if turn.axis() == Axis::X { [depth, width, height] } else { [width, depth, height] }
}

/// The center on one axis: from the anchor, or where an axis that was never written rests.
fn center_on(axis: usize, slot: Option<(Anchor, f64)>, extent: f64) -> f64 {
    match slot {
        Some((Anchor::Min, value)) => value + 0.5 * extent,
        Some((Anchor::Center, value)) => value,
        Some((Anchor::Max, value)) => value - 0.5 * extent,
        None if axis == 2 => 0.5 * extent,
        None => 0.0,
    }
}

/// The center that anchors and extents give.
fn center(anchors: &Anchors<f64>, size: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| center_on(k, anchors[k], size[k]))
}

/// The cardinal from a point to a box: the axis along which the point lies further outside it, y on a tie; where it lies
/// inside, the axis along which the centers are further apart; the negative side where the centers agree.
pub fn toward(from: [f64; 3], target: [f64; 3], size: [f64; 3]) -> Cardinal {
    let mut out = [0, 1].map(|k| {
        let half = 0.5 * size[k];
        (target[k] - half - from[k]).max(from[k] - target[k] - half).max(0.0)
    });
    if out == [0.0, 0.0] {
        out = [0, 1].map(|k| (from[k] - target[k]).abs());
    }
    match out[0] <= out[1] {
        true if target[1] > from[1] => Cardinal::YMax,
        true => Cardinal::YMin,
        false if target[0] > from[0] => Cardinal::XMax,
        false => Cardinal::XMin,
    }
}

/// Which way the object faces.
pub fn decide(question: &Question<f64>) -> Outcome {
    let aimed = |target, size| Outcome { turn: settle_toward(question, target, size), directed: true };
    let directed = |number| Outcome { turn: Cardinal::from_number(number).unwrap_or(Cardinal::YMax), directed: true };
    if question.instead >= 0.0 {
        return directed(question.instead);
    }
    match &question.aim {
        Aim::Direction(turn) => directed(*turn),
        Aim::Point([x, y]) => aimed([*x, *y, 0.0], [0.0; 3]),
        Aim::Scene => aimed([0.0; 3], question.scene),
        Aim::Object { dims, anchors, turn } => {
            let size = extents(*dims, Cardinal::from_turns(*turn as i64));
            aimed(center(anchors, size), size)
        }
        Aim::Free { precedent } => infer(question, precedent.map(Outcome::from_code)),
    }
}

/// The first orientation that agrees with the box that it gives, else the estimate made facing `YMax`.
fn settle_toward(question: &Question<f64>, target: [f64; 3], size: [f64; 3]) -> Cardinal {
    let aim = |turn| toward(center(&question.anchors, extents(question.dims, turn)), target, size);
    let first = aim(Cardinal::YMax);
    [first, aim(first)].into_iter().chain(Cardinal::ALL).find(|turn| aim(*turn) == *turn).unwrap_or(first)
}

/// The facing of an object that was never told one.
fn infer(question: &Question<f64>, precedent: Option<Outcome>) -> Outcome {
    let ([width, depth, height], scene) = (question.dims, question.scene);
    let fits = |x: f64, y: f64| x <= scene[0] && y <= scene[1];
    if !fits(width, depth) && fits(depth, width) {
        return Outcome { turn: Cardinal::XMax, directed: false };
    }
    if !fits(depth, width) && fits(width, depth) {
        return Outcome { turn: Cardinal::YMax, directed: false };
    }
    let at_wall = |wall: &Cardinal| {
        let (k, sign, part) = match wall {
            Cardinal::XMax => (0, 0.5, Anchor::Max),
            Cardinal::YMax => (1, 0.5, Anchor::Max),
            Cardinal::XMin => (0, -0.5, Anchor::Min),
            Cardinal::YMin => (1, -0.5, Anchor::Min),
        };
        matches!(question.anchors[k], Some((anchor, value)) if anchor == part && (value - sign * scene[k]).abs() < 1e-9)
    };
    let mut walls = Cardinal::ALL.into_iter().filter(at_wall);
    let Some(first) = walls.next() else {
        return precedent.unwrap_or(Outcome { turn: Cardinal::YMax, directed: false });
    };
    let turn = first.opposite();
    if walls.next().is_none() && depth <= 2.0 * width {
        return Outcome { turn, directed: true };
    }
    let bottom = center_on(2, question.anchors[2], height) - 0.5 * height;
    Outcome { turn, directed: bottom > 0.1 }
}
