//! Random layouts: the index finds what comparing every pair finds.

use proptest::prelude::*;
use psdl::check::measure::Bounds;
use psdl::check::{Checker, ErrorKind, Rules, Verdict, Violation};
use psdl::scene::{Anchor, Body, Cardinal, Kind, Support, Told};

const BOUNDS: Bounds = Bounds { min: [-50.0, -50.0, 0.0], max: [50.0, 50.0, 10.0], interior: true };

/// A body from a few numbers; positions on a coarse grid, so that many boxes touch and many tops are level.
fn body(kind: u8, support: u8, dims: [f64; 3], at: [f64; 3], turn: usize) -> Body {
    let kind = [Kind::Object, Kind::Door, Kind::Window][kind as usize];
    Body {
        kind,
        support: if kind == Kind::Object { Support::ALL[support as usize] } else { Support::Mounted },
        dims,
        center: [0.0; 3],
        min: [0.0; 3],
        max: [0.0; 3],
        turn: Cardinal::ALL[turn],
        told: Told::Direction,
        directed: true,
        anchors: [Some(Anchor::Center); 3],
    }
    .at(at)
}

fn any_body(spread: i32) -> impl Strategy<Value = Body> {
    let size = prop_oneof![Just(0.05), Just(0.5), Just(1.0), Just(2.5), 0.004..3.0];
    let place = move || prop_oneof![(-spread..spread).prop_map(|step| f64::from(step) * 0.25), -10.0..10.0];
    let height = prop_oneof![Just(0.0), Just(0.5), Just(1.0), 0.0..6.0, -1.0..0.0];
    let kind = prop_oneof![8 => Just(0_u8), 1 => Just(1), 1 => Just(2)];
    (kind, 0..3_u8, [size.clone(), size.clone(), size], place(), place(), height, 0..4_usize)
        .prop_map(|(kind, support, dims, x, y, bottom, turn)| body(kind, support, dims, [x, y, bottom + 0.5 * dims[2]], turn))
}

/// The errors of pairs and supports, by comparing everything with everything.
fn brute_force(checker: &Checker) -> Vec<Violation> {
    let count = checker.bodies.len();
    let mut violations = Vec::new();
    for a in 0..count {
        violations.extend((0..a).filter_map(|b| checker.overlap(a, b)));
        violations.extend(checker.standing_of(a));
        violations.extend((0..count).filter(|b| *b != a).filter_map(|b| checker.clearance(a, b)));
        violations.extend(checker.alone(a));
    }
    violations.sort_by_key(|violation| (violation.culprit, violation.kind, violation.other));
    violations
}

fn indexed(bodies: &[Body], rules: &Rules) -> Verdict {
    Checker { rules, bounds: BOUNDS, bodies }.check()
}

proptest! {
    #[test]
    fn the_index_finds_what_comparing_every_pair_finds(bodies in prop::collection::vec(any_body(20), 0..120)) {
        let rules = Rules::default();
        let verdict = indexed(&bodies, &rules);
        prop_assert_eq!(verdict.violations, brute_force(&Checker { rules: &rules, bounds: BOUNDS, bodies: &bodies }));
    }

    #[test]
    fn dense_scenes_too(bodies in prop::collection::vec(any_body(4), 0..60), tolerance in prop_oneof![Just(0.0), 0.0..0.5]) {
        let rules = Rules { tolerance, ..Rules::default() };
        let verdict = indexed(&bodies, &rules);
        prop_assert_eq!(verdict.violations, brute_force(&Checker { rules: &rules, bounds: BOUNDS, bodies: &bodies }));
    }

    #[test]
    fn no_coordinate_breaks_the_check(
        values in prop::collection::vec((prop::array::uniform3(any::<f64>()), prop::array::uniform3(0.0..f64::MAX), 0..4_usize), 0..20),
    ) {
        let finite = |value: f64| if value.is_finite() { value } else { 1e308 };
        let bodies: Vec<Body> = values.into_iter().map(|(at, dims, turn)| body(0, 0, dims, at.map(finite), turn)).collect();
        let rules = Rules::default();
        let verdict = indexed(&bodies, &rules);
        prop_assert_eq!(verdict.violations, brute_force(&Checker { rules: &rules, bounds: BOUNDS, bodies: &bodies }));
    }
}

#[test]
fn ten_thousand_objects_of_which_a_few_overlap() {
    let grid = |i: usize| [(i % 100) as f64 - 49.5, (i / 100) as f64 - 49.5, 0.5];
    let mut bodies: Vec<Body> = (0..10_000).map(|i| body(0, 0, [0.9, 0.8, 1.0], grid(i), i % 4)).collect();
    for i in (7..10_000).step_by(500) {
        bodies[i] = bodies[i].at([bodies[i].center[0] + 0.3, bodies[i].center[1], 0.5]);
    }
    let verdict = indexed(&bodies, &Rules::default());
    assert_eq!(verdict.violations.len(), 20);
    assert!(verdict.violations.iter().all(|found| found.kind == ErrorKind::Overlap));
}

#[test]
fn thousands_of_objects_in_one_place_end_at_a_limit_and_say_so() {
    let bodies: Vec<Body> = (0..3_000).map(|_| body(0, 0, [1.0, 1.0, 1.0], [0.0, 0.0, 0.5], 1)).collect();
    let rules = Rules::default();
    let verdict = indexed(&bodies, &rules);
    assert!(verdict.truncated);
    assert_eq!(verdict.violations.len(), rules.limits.violations);
}
