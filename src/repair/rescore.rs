//! The score of a layout of which some bodies were moved: only the terms that read them are measured again.

use smallvec::SmallVec;

use crate::check::measure as terms;
use crate::check::{Checker, ErrorKind, Violation};
use crate::scene::{Body, Support};

use super::measure::{Score, step, volume};
use super::problem::Problem;
use super::state::{Record, State};

/// Errors to measure again because of bodies that moved.
#[derive(Default)]
pub(super) struct Again {
    pub(super) standing: SmallVec<[u32; 16]>,
    facers: SmallVec<[u32; 16]>,
}

/// What a body takes up: nothing where it takes no part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    min: [f64; 3],
    max: [f64; 3],
}

impl Room {
    const NONE: Room = Room { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    pub(super) fn of(body: &Body) -> Room {
        if body.is_placed() { Room { min: body.min, max: body.max } } else { Room::NONE }
    }
}

/// Whether two rooms share a point.
fn meet(one: &Room, other: &Room) -> bool {
    (0..3).fold(true, |meet, k| meet & (one.min[k] < other.max[k]) & (other.min[k] < one.max[k]))
}

/// How a moved layout is measured.
pub(super) struct Measure<'a> {
    /// Gets the errors.
    pub(super) keep: Option<&'a mut Vec<Violation>>,
    /// Whether it can be given up: what is known of the score only grows.
    pub(super) too_much: &'a dyn Fn(&Score) -> bool,
    /// How many bodies were measured.
    pub(super) bodies: usize,
}

impl Measure<'_> {
    /// All of it, and nothing kept.
    pub(super) const ALL: Measure<'static> = Measure { keep: None, too_much: &|_| false, bodies: 0 };

    fn add(&mut self, score: &mut Score, violation: Violation) {
        if violation.kind != ErrorKind::Unplaced {
            score.loss += violation.loss;
            score.count += 1;
            self.keep.iter_mut().for_each(|kept| kept.push(violation));
        }
    }
}

impl State {
    /// The score after the bodies in `old` were moved from there; `None` where it was given up.
    pub(super) fn rescore(
        &self,
        problem: &Problem,
        record: &Record,
        old: &[(u32, Body)],
        again: &Again,
        measure: &mut Measure<'_>,
    ) -> Option<Score> {
        let checker = Checker { rules: &problem.options().rules, bounds: record.bounds, bodies: &self.bodies };
        let mut score = self.without_moved(problem, old, again, measure);
        if (measure.too_much)(&score) {
            return None;
        }
        for violation in again.standing.iter().filter_map(|object| checker.standing_of(*object as usize)) {
            measure.add(&mut score, violation);
        }
        for object in &again.facers {
            let facing = checker.alone(*object as usize).filter(|violation| violation.kind == ErrorKind::Facing);
            facing.for_each(|violation| measure.add(&mut score, violation));
        }
        for (object, _) in old {
            if (measure.too_much)(&score) {
                return None;
            }
            measure.bodies += 1;
            let object = *object as usize;
            checker.alone(object).for_each(|violation| measure.add(&mut score, violation));
            if self.bodies[object].is_placed() {
                self.pairs(&checker, &record.keepers, object, &mut |violation| measure.add(&mut score, violation));
            }
        }
        Some(score)
    }

    /// The score with the new movement and without the errors that are to be measured again.
    fn without_moved(&self, problem: &Problem, old: &[(u32, Body)], again: &Again, measure: &mut Measure<'_>) -> Score {
        let mut score = self.score;
        for (object, before) in old {
            let original = &problem.layout().objects[*object as usize].body;
            let ((was, far), (is, further)) = (step(original, before), step(original, &self.bodies[*object as usize]));
            score.work += volume(original) * (is - was);
            score.moved = score.moved + usize::from(further) - usize::from(far);
        }
        for violation in &self.violations {
            let dropped = match violation.kind {
                ErrorKind::Standing => again.standing.contains(&violation.culprit),
                _ => violation.objects().any(|object| self.moved[object]),
            };
            if dropped {
                score.loss -= violation.loss;
                score.count -= 1;
            } else if let Some(kept) = &mut measure.keep {
                kept.push(*violation);
            }
        }
        score
    }

    /// The errors of a moved body with each other body; of two that moved, told by the first.
    fn pairs(&self, checker: &Checker<'_>, keepers: &[usize], object: usize, add: &mut impl FnMut(Violation)) {
        let room = &self.boxes[object];
        let told_here = |other: usize| other != object && !(self.moved[other] && other < object);
        for (other, second) in self.boxes.iter().enumerate() {
            if meet(room, second) && told_here(other) {
                checker.overlap(object, other).into_iter().for_each(&mut *add);
            }
        }
        let kept_clear = |index: usize| terms::clearance_box(checker.rules, &self.bodies[index]).map(|(min, max)| Room { min, max });
        if let Some(clear) = kept_clear(object) {
            for (other, second) in self.boxes.iter().enumerate() {
                if meet(&clear, second) && told_here(other) {
                    checker.clearance(object, other).into_iter().for_each(&mut *add);
                }
            }
        }
        for &other in keepers {
            if told_here(other) && self.bodies[other].is_placed() && kept_clear(other).is_some_and(|clear| meet(&clear, room)) {
                checker.clearance(other, object).into_iter().for_each(&mut *add);
            }
        }
    }

    /// What reads the moved bodies besides themselves.
    pub(super) fn to_measure(&self, record: &Record, old: &[(u32, Body)]) -> Again {
        let mut again = Again::default();
        for (index, body) in self.bodies.iter().enumerate() {
            let carrier_moved = self.carriers[index].is_some_and(|carrier| self.moved[carrier as usize]);
            if body.is_placed() && body.support == Support::Standing && (self.moved[index] || carrier_moved) {
                again.standing.push(index as u32);
            }
        }
        let floating = self.violations.iter().filter(|violation| violation.kind == ErrorKind::Standing);
        let floating = floating.map(|violation| violation.culprit).filter(|culprit| !self.moved[*culprit as usize]);
        let floating: SmallVec<[u32; 8]> = floating.filter(|culprit| !again.standing.contains(culprit)).collect();
        again.standing.extend(floating);
        let facers = old.iter().flat_map(|(object, _)| &record.facers[*object as usize]);
        again.facers = facers.copied().filter(|facer| !self.moved[*facer as usize]).collect();
        again
    }
}
