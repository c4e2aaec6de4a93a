//! Exact proposals: for an error, the values of literals at which it clears.
//!
//! A way out is a shift of one object against another, or against the scene, along one axis. The derivative of that shift by a literal
//! says how far the literal must go. Nearly all programs are affine in each of their literals, so that this is where the error ends.

use crate::check::measure::{clearance_box, penetration};
use crate::check::{ErrorKind, Rules, Violation};
use crate::scene::{Axis, Body, Cardinal};
use crate::syntax::tune;
use crate::syntax::{ConstantId, DirectionId};

use super::Settings;
use super::changes::Change;
use super::problem::Problem;
use super::state::State;

/// A literal that goes further than this is no correction. In the units of the literal.
const FAR: f64 = 1e4;

/// Objects that shall not face a wall stand this much further than what counts as against it. Metres.
const CLEAR_OF_WALL: f64 = 0.001;

/// A movement that may clear an error: `object` by `shift` metres along `axis`, relative to `against` or to the scene.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Way {
    object: usize,
    against: Option<usize>,
    axis: usize,
    shift: f64,
}

/// A value for a literal of the record.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Proposal {
    pub(super) literal: usize,
    pub(super) value: f64,
}

/// Which literals may be changed, and how objects move with them.
pub(super) struct Movers {
    /// Per literal that was asked for, per object, the derivative of its center.
    slopes: Vec<Option<Box<[[f64; 3]]>>>,
}

impl Movers {
    /// Nothing is known yet.
    pub(super) fn of(state: &State) -> Movers {
        Movers { slopes: vec![None; state.literals().len()] }
    }

    fn slope(&mut self, state: &mut State, literal: usize, object: usize, axis: usize) -> f64 {
        let slopes = self.slopes[literal].get_or_insert_with(|| {
            let mut slopes = vec![[0.0; 3]; state.bodies.len()].into_boxed_slice();
            state.slopes(literal).iter().for_each(|(moved, slope)| slopes[*moved as usize] = *slope);
            slopes
        });
        slopes[object][axis]
    }

    /// The value of a literal at which a way is gone.
    fn value(&mut self, state: &mut State, way: &Way, literal: usize) -> Option<f64> {
        let own = self.slope(state, literal, way.object, way.axis);
        let others = way.against.map_or(0.0, |other| self.slope(state, literal, other, way.axis));
        let step = way.shift / (own - others);
        (step.is_finite() && step.abs() < FAR && step != 0.0).then(|| state.value(literal) + step)
    }
}

/// The values of one literal at which some errors clear.
pub(super) fn of_literal(problem: &Problem, state: &mut State, errors: &[Violation], literal: usize) -> Vec<f64> {
    let (mut movers, mut ways) = (Movers::of(state), Vec::new());
    errors.iter().for_each(|error| ways_out(&problem.options().rules, state, error, &mut ways));
    let mut values: Vec<f64> = ways.iter().filter_map(|way| movers.value(state, way, literal)).collect();
    values.sort_by(f64::total_cmp);
    values.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    values
}

/// Whether a constant may be rewritten under these settings.
pub(super) fn is_allowed(problem: &Problem, settings: &Settings, id: ConstantId) -> bool {
    let inside = |constant: &tune::Constant| settings.within.is_none_or(|range| range.contains_range(constant.range));
    problem.is_free(id) && problem.tuning().constant(id).is_some_and(inside)
}

/// The values of literals at which errors clear. `wide`: also where an object would stand beside any other.
pub(super) fn constants(problem: &Problem, settings: &Settings, state: &mut State, errors: &[Violation], wide: bool) -> Vec<Proposal> {
    let mut movers = Movers::of(state);
    let mut ways = Vec::new();
    for error in errors {
        ways_out(&problem.options().rules, state, error, &mut ways);
        if wide {
            for object in error.objects() {
                beside_others(state, object, &mut ways);
            }
        }
    }
    let mut proposals = Vec::new();
    let mut literals: Vec<usize> = Vec::new();
    let allowed: Vec<bool> = state.literals().iter().map(|slice| is_allowed(problem, settings, ConstantId(slice.id))).collect();
    for way in &ways {
        literals.clear();
        literals.extend(state.movers(way.object));
        let own = literals.len();
        for other in way.against.into_iter().flat_map(|other| state.movers(other)) {
            if literals[..own].binary_search(other).is_err() {
                literals.push(*other);
            }
        }
        for &literal in literals.iter().filter(|literal| allowed[**literal]) {
            if let Some(value) = movers.value(state, way, literal) {
                proposals.push(Proposal { literal, value });
            }
        }
    }
    proposals.sort_by(|a, b| a.literal.cmp(&b.literal).then(a.value.total_cmp(&b.value)));
    proposals.dedup_by(|a, b| a.literal == b.literal && (a.value - b.value).abs() < 1e-6);
    proposals
}

/// The turns of directions that decide where objects with errors face.
pub(super) fn turns(problem: &Problem, settings: &Settings, state: &State, errors: &[Violation]) -> Vec<Change> {
    let mut directions: Vec<_> =
        errors.iter().flat_map(|error| error.objects()).flat_map(|object| state.directions(object)).copied().collect();
    directions.sort_unstable();
    directions.dedup();
    let tuning = problem.tuning();
    let inside = |range| settings.within.is_none_or(|within: ruff_text_size::TextRange| within.contains_range(range));
    directions.retain(|id| tuning.direction(*id).is_some_and(|direction| inside(direction.range)));
    let turned = |id| state.changes.turns().find(|(turned, _)| *turned == id).map(|(_, cardinal)| cardinal);
    let written = |id| match tuning.direction(id).map(|direction| direction.kind) {
        Some(tune::DirectionKind::Literal(cardinal)) => Some(cardinal),
        _ => None,
    };
    let others = |id| tune::Cardinal::ALL.into_iter().filter(move |cardinal| turned(id).or(written(id)) != Some(*cardinal));
    directions.into_iter().flat_map(|id| others(id).map(move |cardinal| Change::Turn(id, cardinal))).collect()
}

/// Every direction of the program to every other cardinal.
pub(super) fn all_turns(problem: &Problem) -> impl Iterator<Item = Change> {
    let turns = |(at, direction): (usize, &tune::Direction)| {
        let (id, kind) = (DirectionId(at as u32), direction.kind);
        let others = tune::Cardinal::ALL.into_iter().filter(move |cardinal| kind != tune::DirectionKind::Literal(*cardinal));
        others.map(move |cardinal| Change::Turn(id, cardinal))
    };
    problem.tuning().directions.iter().enumerate().flat_map(turns)
}

fn ways_out(rules: &Rules, state: &State, error: &Violation, ways: &mut Vec<Way>) {
    let object = error.culprit as usize;
    let body = &state.bodies[object];
    let mut way = |against, axis, shift| ways.push(Way { object, against, axis, shift });
    match (error.kind, error.other) {
        (ErrorKind::OutOfBounds, _) => {
            let bounds = state.bounds();
            for k in 0..3 {
                let (low, high) = (bounds.min[k] - body.min[k], bounds.max[k] - body.max[k]);
                if low > 0.0 || high < 0.0 && (k < 2 || bounds.interior) {
                    way(None, k, low);
                    way(None, k, high);
                }
            }
        }
        (ErrorKind::Overlap, Some(other)) => part(body.min, body.max, &state.bodies[other as usize], other, &mut way),
        (ErrorKind::Clearance, Some(other)) => {
            if let Some((min, max)) = clearance_box(rules, body) {
                part(min, max, &state.bodies[other as usize], other, &mut way);
            }
        }
        (ErrorKind::Standing, _) => stand(state, object, error.support, &mut way),
        (ErrorKind::Mounted, _) => {
            let (bounds, size) = (state.bounds(), body.size());
            for k in (0..2).filter(|k| size[*k] <= size[1 - *k]) {
                way(None, k, bounds.min[k] - body.min[k]);
                way(None, k, bounds.max[k] - body.max[k]);
            }
        }
        (ErrorKind::Facing, Some(other)) => {
            let target = &state.bodies[other as usize];
            for k in 0..2 {
                way(Some(other as usize), k, target.center[k] - body.center[k]);
                way(Some(other as usize), k, body.center[k].clamp(target.min[k], target.max[k]) - body.center[k]);
            }
        }
        (ErrorKind::FacingWall | ErrorKind::ShortSide, _) => {
            for wall in Cardinal::ALL {
                let distance = state.bounds().distance(body, wall);
                let sign = if matches!(wall, Cardinal::XMax | Cardinal::YMax) { -1.0 } else { 1.0 };
                let axis = if wall.axis() == Axis::X { 0 } else { 1 };
                if distance.abs() < rules.wall_tolerance {
                    way(None, axis, sign * (rules.wall_tolerance + CLEAR_OF_WALL - distance));
                }
            }
        }
        _ => {}
    }
}

/// Both ways along each axis to part two boxes.
fn part(min: [f64; 3], max: [f64; 3], other: &Body, index: u32, way: &mut impl FnMut(Option<usize>, usize, f64)) {
    if penetration(min, max, other).iter().any(|depth| *depth <= 0.0) {
        return;
    }
    for k in 0..3 {
        way(Some(index as usize), k, other.max[k] - min[k]);
        way(Some(index as usize), k, other.min[k] - max[k]);
    }
}

/// To the ground, onto the top of what lies below, and over the nearest support.
fn stand(state: &State, object: usize, nearest: Option<u32>, way: &mut impl FnMut(Option<usize>, usize, f64)) {
    let body = &state.bodies[object];
    way(None, 2, -body.min[2]);
    for (index, support) in state.bodies.iter().enumerate() {
        if index == object || !support.is_placed() {
            continue;
        }
        let inside = |k: usize| (support.min[k]..=support.max[k]).contains(&body.center[k]);
        let (under, level) = (inside(0) && inside(1), (body.min[2] - support.max[2]).abs() < 0.01);
        if under && !level || nearest == Some(index as u32) {
            way(Some(index), 2, support.max[2] - body.min[2]);
        }
        if nearest == Some(index as u32) || level && (inside(0) || inside(1)) {
            for k in (0..2).filter(|k| !inside(*k)) {
                way(Some(index), k, body.center[k].clamp(support.min[k], support.max[k]) - body.center[k]);
                way(Some(index), k, support.center[k] - body.center[k]);
            }
        }
    }
}

/// Against each other object and each wall along x and y: the places where an object fits in.
fn beside_others(state: &State, object: usize, ways: &mut Vec<Way>) {
    let (body, bounds) = (&state.bodies[object], state.bounds());
    for k in 0..2 {
        ways.push(Way { object, against: None, axis: k, shift: bounds.min[k] - body.min[k] });
        ways.push(Way { object, against: None, axis: k, shift: bounds.max[k] - body.max[k] });
        for (index, other) in state.bodies.iter().enumerate() {
            let across = [1 - k, 2].into_iter().all(|k| body.min[k] < other.max[k] && other.min[k] < body.max[k]);
            if index != object && other.is_placed() && across {
                ways.push(Way { object, against: Some(index), axis: k, shift: other.max[k] - body.min[k] });
                ways.push(Way { object, against: Some(index), axis: k, shift: other.min[k] - body.max[k] });
            }
        }
    }
}
