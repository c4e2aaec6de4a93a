//! The whole check: all errors of a layout.

use crate::scene::{Body, Layout, Support, Target, Told};

use super::index::Index;
use super::measure::{self, Bounds};
use super::rules::Rules;
use super::violation::{ErrorKind, Verdict, Violation};

/// Finds the errors of a set of bodies.
#[derive(Clone, Copy, Debug)]
pub struct Checker<'a> {
    /// What counts.
    pub rules: &'a Rules,
    /// The box of the scene.
    pub bounds: Bounds,
    /// All objects of the scene; indices of violations are theirs.
    pub bodies: &'a [Body],
}

/// The violations found so far, and how much work may still be done for the kind at hand.
struct Found<'a> {
    rules: &'a Rules,
    verdict: Verdict,
    pairs_left: usize,
    left: usize,
}

impl Found<'_> {
    /// Starts on another kind.
    fn begin(&mut self) {
        self.pairs_left = self.rules.limits.pairs;
        self.left = self.rules.limits.violations;
    }

    /// False where the next pair is one too many.
    fn next_pair(&mut self) -> bool {
        let goes_on = self.pairs_left > 0 && self.left > 0;
        self.pairs_left = self.pairs_left.saturating_sub(1);
        self.verdict.truncated |= !goes_on;
        goes_on
    }

    fn add(&mut self, violation: Option<Violation>) {
        if let Some(violation) = violation {
            if self.left == 0 {
                self.verdict.truncated = true;
                return;
            }
            self.left -= 1;
            self.verdict.violations.push(violation);
        }
    }
}

/// The errors of a layout, by culprit, kind and other object.
pub fn check(layout: &Layout, rules: &Rules) -> Verdict {
    let bodies = layout.bodies();
    Checker { rules, bounds: Bounds::of(&layout.scene), bodies: &bodies }.check()
}

/// An error of a length; it counts where its weighted loss is at least 1.
fn long(kind: ErrorKind, culprit: usize, other: Option<usize>, metres: f64, weight: f64) -> Option<Violation> {
    let loss = (weight * metres) as u64;
    (loss > 0).then_some(Violation { kind, culprit: culprit as u32, other: other.map(|index| index as u32), metres, loss, support: None })
}

impl Checker<'_> {
    /// All errors.
    pub fn check(&self) -> Verdict {
        let mut found = Found { rules: self.rules, verdict: Verdict::default(), pairs_left: 0, left: usize::MAX };
        for index in 0..self.bodies.len() {
            self.alone(index).for_each(|violation| found.add(Some(violation)));
        }
        self.pairs(&mut found);
        self.standing(&mut found);
        let mut verdict = found.verdict;
        verdict.violations.sort_unstable_by_key(|violation| (violation.culprit, violation.kind, violation.other));
        verdict
    }

    /// The bodies that take part, with their indices.
    fn placed(&self) -> impl Iterator<Item = (usize, &Body)> {
        self.bodies.iter().enumerate().filter(|(_, body)| body.is_placed())
    }

    /// The errors of an object that rest on its own body, on the scene, and on the object that it was told to face.
    pub fn alone(&self, index: usize) -> impl Iterator<Item = Violation> + use<> {
        let (body, bounds, weights) = (&self.bodies[index], &self.bounds, &self.rules.weights);
        if !body.is_placed() {
            let unplaced = Violation { kind: ErrorKind::Unplaced, culprit: index as u32, other: None, metres: 0.0, loss: 0, support: None };
            return [Some(unplaced), None, None, None, None].into_iter().flatten();
        }
        let against = measure::against(self.rules, bounds, body);
        let out = long(ErrorKind::OutOfBounds, index, None, measure::out_of_bounds(bounds, body), weights.out_of_bounds);
        let mounted = measure::mounted(bounds, body).and_then(|gap| long(ErrorKind::Mounted, index, None, gap, weights.mounted));
        let fixed = |kind, other, weight: f64| long(kind, index, other, 1.0, weight).map(|found| Violation { metres: 0.0, ..found });
        let facing = self.misses_target(index).then(|| fixed(ErrorKind::Facing, self.target(index), weights.facing)).flatten();
        let wall = measure::faces_wall(body, against).then(|| fixed(ErrorKind::FacingWall, None, weights.facing_wall)).flatten();
        let short = measure::short_side(body, against).and_then(|_| self.short_side(index));
        [out, mounted, facing, wall, short].into_iter().flatten()
    }

    fn target(&self, index: usize) -> Option<usize> {
        match self.bodies[index].told {
            Told::Toward(Target::Object(id)) => Some(id.index()),
            _ => None,
        }
    }

    /// Whether an object was told to face something and does not.
    pub fn misses_target(&self, index: usize) -> bool {
        let body = &self.bodies[index];
        measure::direction_told(&self.bounds, body, |target| self.bodies[target]).is_some_and(|turn| turn != body.turn)
    }

    fn short_side(&self, index: usize) -> Option<Violation> {
        let (body, weights) = (&self.bodies[index], &self.rules.weights);
        let weight = if body.support == Support::Mounted { weights.short_side_mounted } else { weights.short_side };
        let [x, y, z] = body.size();
        let loss = ((weight * x.max(y).max(z)) as u64).max(1);
        let violation = Violation { kind: ErrorKind::ShortSide, culprit: index as u32, other: None, metres: 0.0, loss, support: None };
        (weight > 0.0).then_some(violation)
    }

    /// The error of two bodies that share volume; the later declared is the culprit.
    pub fn overlap(&self, a: usize, b: usize) -> Option<Violation> {
        let metres = measure::overlap(self.rules, &self.bodies[a], &self.bodies[b])?;
        long(ErrorKind::Overlap, a.max(b), Some(a.min(b)), metres, self.rules.weights.overlap)
    }

    /// The error of a body in the clearance of a door or window.
    pub fn clearance(&self, door: usize, other: usize) -> Option<Violation> {
        let metres = measure::clearance(self.rules, &self.bodies[door], &self.bodies[other])?;
        long(ErrorKind::Clearance, door, Some(other), metres, self.rules.weights.clearance)
    }

    fn pairs(&self, found: &mut Found) {
        let solid = || self.placed().filter(|(_, body)| !measure::is_rug(self.rules, body));
        let (index, depth) = (Index::of_boxes(solid()), self.rules.tolerance);
        found.begin();
        for (a, body) in solid() {
            for b in index.meeting(body.min, body.max, depth) {
                if !found.next_pair() {
                    break;
                }
                found.add((b < a).then(|| self.overlap(a, b)).flatten());
            }
        }
        found.begin();
        for (door, body) in self.placed() {
            let Some((min, max)) = measure::clearance_box(self.rules, body) else { continue };
            for other in index.meeting(min, max, depth) {
                if !found.next_pair() {
                    break;
                }
                found.add((other != door).then(|| self.clearance(door, other)).flatten());
            }
        }
    }

    /// The error of a standing body that nothing carries, among all bodies.
    pub fn standing_of(&self, index: usize) -> Option<Violation> {
        let supports = self.placed().filter(|(support, _)| *support != index);
        self.floating(index, measure::standing(self.rules, &self.bodies[index], supports)?)
    }

    fn floating(&self, index: usize, gap: measure::Gap) -> Option<Violation> {
        let found = long(ErrorKind::Standing, index, None, gap.metres, self.rules.weights.standing)?;
        Some(Violation { support: gap.support.map(|support| support as u32), ..found })
    }

    fn standing(&self, found: &mut Found) {
        let rules = self.rules;
        let lifted = |(_, body): &(usize, &Body)| body.support == Support::Standing && body.min[2].abs() >= rules.tolerance;
        let mut above = self.placed().filter(lifted).peekable();
        if above.peek().is_none() {
            return;
        }
        found.begin();
        let tops = Index::of_tops(self.placed());
        for (index, body) in above {
            let gap = self.nearest_support(index, body, &tops, found);
            if gap.metres >= rules.tolerance {
                found.add(self.floating(index, gap));
            }
        }
    }

    /// [`measure::standing`] by the index: supports are asked in the order of their straight distance, which is never more than the
    /// distance that counts, until none can be nearer or one is near enough.
    fn nearest_support(&self, index: usize, body: &Body, tops: &Index, found: &mut Found) -> measure::Gap {
        let mut gap = measure::Gap::to_ground(body);
        for (support, straight) in tops.nearest([body.center[0], body.center[1], body.min[2]]) {
            let far = straight > gap.metres * gap.metres * (1.0 + 1e-9);
            if far || gap.metres < self.rules.tolerance || !found.next_pair() {
                break;
            }
            if support != index {
                gap = gap.or(body, support, &self.bodies[support]);
            }
        }
        gap
    }
}
