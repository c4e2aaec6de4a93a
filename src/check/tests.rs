//! Scenes of a few calls, and what is said about them: `line n: sentence`.

use ruff_text_size::TextRange;

use super::*;
use crate::scene::{
    Anchor, Axis, FacingSpec, Given, Kind, Layout, NewObject, ObjectId, Origin, OriginId, Scalar, Source, StepKind, Support, Target, World,
};
use crate::trace::Plain;

/// A program whose every call stands on a line of its own, ten bytes each.
struct Program {
    world: World,
    line: u32,
    paths: Vec<&'static str>,
}

fn range(line: u32) -> TextRange {
    TextRange::new((line * 10).into(), (line * 10 + 9).into())
}

impl Program {
    /// A room of 8 × 6 × 3.
    fn new() -> Program {
        let mut world = World::new();
        world.set_size(&mut Plain, &[8.0, 6.0, 3.0].map(Given::from)).expect("a good size");
        Program { world, line: 0, paths: Vec::new() }
    }

    fn origin(&mut self) -> OriginId {
        self.line += 1;
        self.world.origins.intern(Origin { source: Source::Program, range: range(self.line), inside: None })
    }

    fn add(&mut self, path: &'static str, kind: Kind, dims: [f64; 3], support: Support) -> ObjectId {
        let origin = self.origin();
        self.paths.push(path);
        let support = Scalar::int(support as i64).into();
        let new = NewObject { kind, name: path, dims: dims.map(Given::from), support, color: None, dynamic: false };
        self.world.add_object(&mut Plain, &new, origin).expect("a good object")
    }

    fn object(&mut self, path: &'static str, dims: [f64; 3]) -> ObjectId {
        self.add(path, Kind::Object, dims, Support::Standing)
    }

    fn write_from(&mut self, origin: OriginId, object: ObjectId, place: &str, value: f64) {
        let (anchor, axis) = place.split_once('.').expect("anchor.axis");
        let (anchor, axis) = (Anchor::from_name(anchor).expect("an anchor"), Axis::from_name(axis).expect("an axis"));
        self.world.write(&mut Plain, Target::Object(object), anchor, axis, &value.into(), origin).expect("a good number");
    }

    fn write(&mut self, object: ObjectId, place: &str, value: f64) {
        let origin = self.origin();
        self.write_from(origin, object, place, value);
    }

    /// x and y by their centers, on two lines.
    fn put(&mut self, object: ObjectId, x: f64, y: f64) {
        self.write(object, "center.x", x);
        self.write(object, "center.y", y);
    }

    fn face(&mut self, object: ObjectId, spec: FacingSpec) {
        let origin = self.origin();
        self.world.set_facing(&mut Plain, object, &spec, crate::trace::Handle::NONE, origin).expect("a good facing");
    }

    fn face_number(&mut self, object: ObjectId, number: i64) {
        self.face(object, FacingSpec::Number(Scalar::int(number)));
    }

    fn toward(&mut self, object: ObjectId, other: ObjectId) {
        self.face(object, FacingSpec::Toward(Target::Object(other)));
    }

    fn layout(self) -> Layout {
        let mut layout = self.world.into_layout(&mut Plain);
        layout.objects.iter_mut().zip(self.paths).for_each(|(object, path)| object.path = path.into());
        layout
    }

    fn findings(self) -> Vec<finding::Finding> {
        let (layout, rules) = (self.layout(), Rules::default());
        findings(&layout, &check(&layout, &rules), &rules)
    }

    fn says(self) -> Vec<String> {
        let line = |finding: &finding::Finding| u32::from(finding.place.range.start()) / 10;
        self.findings().iter().map(|finding| format!("line {}: {}", line(finding), finding.message)).collect()
    }
}

#[test]
fn an_overlap_is_blamed_on_the_axis_where_least_movement_parts_the_two() {
    let mut p = Program::new();
    let [table, chair] = [("table", 1.6), ("chair", 0.5)].map(|(path, width)| p.object(path, [width, 0.8, 0.75]));
    p.put(chair, 0.2, 0.7);
    p.put(table, 0.0, 0.0);
    let findings = p.findings();
    assert_eq!(findings.len(), 1);
    let (place, related) = (findings[0].place, &findings[0].related);
    assert_eq!(findings[0].message, "table overlaps chair by 0.10 m");
    assert_eq!(place, finding::Place::program(range(6)), "the table was placed later, and y needs less");
    let related: Vec<_> = related.iter().map(|related| (related.place.range, related.message.as_str())).collect();
    let expected = [(4, "chair is placed here"), (1, "table is declared here"), (2, "chair is declared here")];
    assert_eq!(related, expected.map(|(line, message)| (range(line), message)));
    assert_eq!((findings[0].objects.as_slice(), findings[0].count), ([0, 1].as_slice(), 1));
}

#[test]
fn errors_of_one_statement_are_one_finding_with_the_worst_as_its_headline() {
    let mut p = Program::new();
    let table = p.object("table", [1.0, 1.0, 1.0]);
    p.put(table, 0.0, 0.0);
    let paths: Vec<&'static str> = (0..15).map(|i| &*format!("chairs[{i}]").leak()).collect();
    let chairs: Vec<_> = paths.iter().map(|path| p.object(path, [0.1, 0.1, 0.9])).collect();
    for (i, chair) in chairs.into_iter().enumerate() {
        let describe = || StepKind::Loop { variable: "i".into(), value: i.to_string().into() };
        let inside = p.world.origins.step(None, range(90), i as u32, describe);
        let call = p.world.origins.step(inside, range(93), 0, || StepKind::Call { function: "place".into() });
        let origin = p.world.origins.intern(Origin { source: Source::Program, range: range(95), inside: call });
        p.write_from(origin, chair, "max.x", -0.5 + 0.015 + 0.005 * (i % 8) as f64);
        p.write_from(origin, chair, "min.y", 0.12 * i as f64 - 0.5);
    }
    let findings = p.findings();
    let overlap = &findings[0];
    assert_eq!(overlap.message, "chairs[7] overlaps table by 0.05 m (and 8 more from this line)");
    assert_eq!(overlap.notes, ["chairs[7], i = 7"]);
    assert_eq!((overlap.count, overlap.objects.as_slice()), (9, [8, 0].as_slice()));
    let related: Vec<&str> = overlap.related.iter().map(|related| related.message.as_str()).collect();
    let head = ["table is placed here", "chairs[7] is declared here", "table is declared here", "place() is called here"];
    assert_eq!(related[..4], head);
    assert_eq!(related[4], "chairs[6] overlaps table by 0.045 m");
    assert_eq!(related.len(), 12);
}

#[test]
fn each_way_out_of_the_scene_has_its_words() {
    let mut p = Program::new();
    let ways = [(4.0, 0.0, 0.5), (0.0, 3.0, 0.5), (-4.0, 0.0, 0.5), (0.0, -3.0, 0.5), (2.0, 0.0, -0.1), (-2.0, 0.0, 2.7)];
    for (x, y, z) in ways {
        let lamp = p.add("lamp", Kind::Object, [1.0, 1.0, 1.0], Support::Floating);
        p.put(lamp, x, y);
        p.write(lamp, "center.z", z);
    }
    assert_eq!(
        p.says(),
        [
            "line 2: lamp sticks out of the scene by 0.50 m through the right wall",
            "line 7: lamp sticks out of the scene by 0.50 m through the top wall",
            "line 10: lamp sticks out of the scene by 0.50 m through the left wall",
            "line 15: lamp sticks out of the scene by 0.50 m through the bottom wall",
            "line 20: lamp sticks out of the scene by 0.60 m below the ground",
            "line 24: lamp sticks out of the scene by 0.20 m above the ceiling",
        ]
    );
}

#[test]
fn standing_names_the_nearest_support() {
    let mut p = Program::new();
    let desk = p.object("desk", [1.0, 1.0, 0.7]);
    p.put(desk, 0.0, 0.0);
    for (path, x, bottom) in [("lamp", 0.0, 0.9), ("crane", 3.0, 1.5), ("book", 0.6, 0.7)] {
        let object = p.object(path, [0.1, 0.1, 0.3]);
        p.put(object, x, 0.3);
        p.write(object, "min.z", bottom);
    }
    assert_eq!(
        p.says(),
        [
            "line 7: lamp floats 0.20 m above desk",
            "line 11: crane floats 1.50 m above the ground",
            "line 13: book stands on the edge of desk: its center is 0.10 m beside it",
        ]
    );
}

#[test]
fn mounted_things_hang_on_the_wall_for_their_wider_side() {
    let mut p = Program::new();
    let [clock, picture] = ["clock", "picture"].map(|path| p.add(path, Kind::Object, [1.0, 0.1, 0.5], Support::Mounted));
    p.face_number(clock, 1);
    p.put(clock, 0.0, -2.5);
    p.write(picture, "max.x", 4.0);
    p.write(picture, "center.y", 0.0);
    p.face_number(picture, 3);
    assert_eq!(
        p.says(),
        [
            "line 5: clock hangs 0.45 m off the nearest wall",
            "line 8: picture hangs on a wall by its narrow side: its wider side is 2.95 m off the nearest wall it can lie against",
        ]
    );
}

#[test]
fn whatever_was_placed_later_is_to_blame_for_a_blocked_door() {
    let mut p = Program::new();
    let door = p.add("door", Kind::Door, [0.9, 0.1, 2.0], Support::Mounted);
    let shelf = p.object("shelf", [0.6, 0.3, 1.8]);
    p.put(shelf, 0.0, -2.6);
    p.face_number(door, 1);
    p.write(door, "min.y", -3.0);
    p.write(door, "center.x", 0.0);
    let findings = p.findings();
    assert_eq!(findings[0].message, "shelf stands in the way of door (0.30 m)");
    assert_eq!((findings[0].place.range, findings[0].objects.as_slice()), (range(6), [0, 1].as_slice()));
}

#[test]
fn facings_are_blamed_on_the_statement_that_set_them() {
    let mut p = Program::new();
    let [stage, seat, desk] = ["stage", "seat", "desk"].map(|path| p.object(path, [1.0, 0.5, 0.5]));
    p.put(stage, 0.0, 2.0);
    p.put(seat, -2.0, 0.0);
    p.toward(seat, stage);
    p.world.facing(&mut Plain, Target::Object(seat));
    p.write(stage, "center.y", -2.0);
    p.write(desk, "max.x", 4.0);
    p.write(desk, "center.y", 0.0);
    p.face(desk, FacingSpec::Point([4.0, 0.0].map(crate::trace::Num::plain)));
    p.toward(desk, desk);
    let lamp = p.object("lamp", [0.1, 0.1, 0.1]);
    p.write(lamp, "max.x", 4.0);
    p.write(lamp, "center.y", -1.0);
    let shelf = p.object("shelf", [2.0, 0.3, 1.5]);
    p.write(shelf, "min.y", -3.0);
    p.write(shelf, "center.x", 1.0);
    p.toward(shelf, lamp);
    p.object("lost", [1.0, 1.0, 1.0]);
    assert_eq!(
        p.says(),
        [
            "line 8: seat does not face stage: it looks Y_MAX, stage lies toward Y_MIN",
            "line 13: desk is told to face itself, which means nothing",
            "line 20: shelf stands with its short side to the bottom wall",
            "line 21: x and y of lost were never written",
        ]
    );
}

#[test]
fn whoever_is_told_to_look_at_a_wall_faces_it() {
    let mut p = Program::new();
    let [screen, chair] = ["screen", "chair"].map(|path| p.object(path, [0.5, 0.4, 1.0]));
    p.write(screen, "max.x", 4.0);
    p.write(screen, "center.y", 2.0);
    p.write(chair, "max.x", 4.0);
    p.write(chair, "center.y", 0.0);
    p.toward(chair, screen);
    p.write(screen, "max.x", 6.0);
    p.write(screen, "center.y", 0.0);
    let findings = p.findings();
    let wall = findings.iter().find(|finding| finding.code == finding::Code::FacingWall).expect("the chair looks at the wall");
    assert_eq!(wall.message, "chair faces the right wall it stands against");
    assert_eq!((wall.place.range, wall.notes.as_slice()), (range(7), ["it was told to face screen".to_owned()].as_slice()));
}
