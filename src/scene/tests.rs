//! The scene as a program uses it: what each call means for what comes after.

use super::*;
use crate::trace::{Handle, LiteralSlice, Num, Plain, Replay, Slices, Trace};

const ORIGIN: OriginId = Origins::NOWHERE;

/// A world with calls in short form; coordinates as numbers, objects by id.
struct Program(World);

impl Program {
    fn new(width: f64, depth: f64) -> Program {
        let mut world = World::new();
        world.set_size(&mut Plain, &[width, depth, 3.0].map(Given::from)).expect("a good size");
        Program(world)
    }

    fn try_add(&mut self, name: &str, dims: [Given; 3]) -> Result<ObjectId, SceneError> {
        let support = Scalar::int(0).into();
        self.0.add_object(&mut Plain, &NewObject { kind: Kind::Object, name, dims, support, color: None, dynamic: false }, ORIGIN)
    }

    fn add(&mut self, name: &str, dims: [f64; 3]) -> ObjectId {
        self.try_add(name, dims.map(Given::from)).expect("a good object")
    }

    fn try_write(&mut self, object: ObjectId, place: &str, value: Given) -> Result<(), SceneError> {
        let (anchor, axis) = part(place);
        self.0.write(&mut Plain, Target::Object(object), anchor, axis, &value, ORIGIN)
    }

    fn write(&mut self, object: ObjectId, place: &str, value: f64) {
        self.try_write(object, place, value.into()).expect("a good number");
    }

    fn read(&mut self, target: Target, place: &str) -> f64 {
        let (anchor, axis) = part(place);
        self.0.read(&mut Plain, target, anchor, axis).value()
    }

    fn get(&mut self, object: ObjectId, place: &str) -> f64 {
        self.read(Target::Object(object), place)
    }

    fn face(&mut self, object: ObjectId, spec: FacingSpec) {
        self.0.set_facing(&mut Plain, object, &spec, Handle::NONE, ORIGIN).expect("a good facing");
    }

    fn face_number(&mut self, object: ObjectId, number: f64) {
        self.face(object, FacingSpec::Number(Scalar::float(number)));
    }

    fn toward(&mut self, object: ObjectId, other: ObjectId) {
        self.face(object, FacingSpec::Toward(Target::Object(other)));
    }

    fn facing(&mut self, object: ObjectId) -> Cardinal {
        Cardinal::from_number(self.0.facing(&mut Plain, Target::Object(object)).value()).expect("a direction")
    }

    fn frame(&mut self, object: ObjectId) {
        self.0.set_frame(&mut Plain, Target::Object(object));
    }

    fn layout(self) -> Layout {
        self.0.into_layout(&mut Plain)
    }
}

/// `"min.x"`
fn part(place: &str) -> (Anchor, Axis) {
    let (anchor, axis) = place.split_once('.').expect("anchor.axis");
    (Anchor::from_name(anchor).expect("an anchor"), Axis::from_name(axis).expect("an axis"))
}

#[test]
fn an_anchor_holds_after_a_turn_swaps_the_extents() {
    let mut p = Program::new(10.0, 10.0);
    let chair = p.add("Chair", [0.5, 1.0, 1.0]);
    p.write(chair, "min.y", 2.0);
    assert_eq!(p.get(chair, "max.y"), 3.0);
    p.face_number(chair, 0.0);
    assert_eq!((p.get(chair, "min.y"), p.get(chair, "max.y")), (2.0, 2.5));
}

#[test]
fn what_was_never_written_rests_on_the_ground_at_the_center() {
    let mut p = Program::new(10.0, 10.0);
    let chair = p.add("Chair", [0.5, 1.0, 1.5]);
    assert_eq!(["center.x", "center.y", "center.z", "min.z"].map(|place| p.get(chair, place)), [0.0, 0.0, 0.75, 0.0]);
    p.write(chair, "center.x", 1.0);
    assert!(!p.layout().objects[0].body.is_placed());
}

#[test]
fn a_turned_frame_turns_writes_and_reads() {
    for (turn, world) in [(0.0, [5.0, -2.0]), (1.0, [4.0, 4.0]), (2.0, [-2.0, 3.0]), (3.0, [-1.0, -3.0])] {
        let mut p = Program::new(20.0, 20.0);
        let bed = p.add("Bed", [2.0, 2.0, 1.0]);
        p.write(bed, "center.x", 1.5);
        p.write(bed, "center.y", 0.5);
        p.face_number(bed, turn);
        let lamp = p.add("Lamp", [1.0, 1.0, 1.0]);
        p.frame(bed);
        p.write(lamp, "min.x", 2.0);
        p.write(lamp, "max.y", 4.0);
        assert_eq!(["min.x", "max.y", "center.x", "center.y"].map(|place| p.get(lamp, place)), [2.0, 4.0, 2.5, 3.5], "turn {turn}");
        let box_ = p.layout().objects[1].body;
        assert_eq!([box_.center[0], box_.center[1]], world, "turn {turn}");
    }
}

#[test]
fn anchors_are_listed_in_the_order_in_which_their_axes_were_first_written() {
    let mut p = Program::new(10.0, 10.0);
    let chair = p.add("Chair", [0.5, 1.0, 1.0]);
    p.write(chair, "min.y", 2.0);
    p.write(chair, "center.x", 1.0);
    p.write(chair, "max.y", 4.0);
    let layout = p.layout();
    let anchors: Vec<_> = layout.objects[0].anchors.iter().map(|slot| (slot.anchor, slot.axis, slot.value.value())).collect();
    assert_eq!(anchors, [(Anchor::Max, Axis::Y, 4.0), (Anchor::Center, Axis::X, 1.0)]);
}

#[test]
fn a_facing_is_decided_when_the_object_settles() {
    let mut p = Program::new(20.0, 20.0);
    let [table, chair] = ["Table", "Chair"].map(|name| p.add(name, [1.0, 1.0, 1.0]));
    p.write(chair, "center.x", -5.0);
    p.toward(chair, table);
    assert_eq!(p.facing(chair), Cardinal::XMax);
    p.write(chair, "center.x", 5.0);
    assert_eq!(p.facing(chair), Cardinal::XMax, "a late write moves it, but does not turn it");
    p.toward(chair, table);
    assert_eq!(p.facing(chair), Cardinal::XMin);
}

#[test]
fn in_a_cycle_the_target_counts_as_turned_away() {
    let mut p = Program::new(20.0, 20.0);
    let [a, b] = [4.0, 0.5].map(|width| p.add("Sofa", [width, 1.0, 1.0]));
    p.write(a, "min.x", 3.0);
    p.write(b, "max.y", -1.0);
    p.toward(a, b);
    p.toward(b, a);
    assert_eq!([p.facing(a), p.facing(b)], [Cardinal::XMin, Cardinal::XMax]);
    assert!(p.layout().objects.iter().all(|object| object.body.directed));
}

#[test]
fn a_long_chain_of_facings_does_not_overflow_the_stack() {
    let mut p = Program::new(20.0, 20.0);
    let chain: Vec<_> = (0..MAX_OBJECTS).map(|_| p.add("Person", [0.5, 0.5, 1.7])).collect();
    chain.windows(2).for_each(|pair| p.toward(pair[0], pair[1]));
    assert_eq!(p.facing(chain[0]), Cardinal::YMin);
    let more = p.try_add("Person", [0.5, 0.5, 1.7].map(Given::from)).expect_err("the scene is full");
    assert_eq!(more.to_string(), "MemoryError: a scene holds at most 200000 objects");
}

#[test]
fn an_object_that_was_told_nothing_turns_away_from_its_wall() {
    let mut p = Program::new(8.0, 6.0);
    let [desk, shelf, corner, narrow] = ["Desk", "Shelf", "Plant", "Carpet"].map(|name| p.add(name, [1.0, 0.5, 1.0]));
    p.write(desk, "max.x", 4.0);
    p.write(shelf, "min.y", -3.0);
    p.write(shelf, "center.x", 0.0);
    p.write(corner, "min.x", -4.0);
    p.write(corner, "max.y", 3.0);
    let long = p.add("Table", [0.4, 1.0, 1.0]);
    p.write(long, "max.y", 3.0);
    let layout = p.layout();
    let facings: Vec<_> = layout.objects.iter().map(|object| (object.body.turn, object.body.directed)).collect();
    assert_eq!(
        facings,
        [(Cardinal::XMin, true), (Cardinal::YMax, true), (Cardinal::YMin, false), (Cardinal::YMax, false), (Cardinal::YMin, false)]
    );
    assert_eq!(layout.objects[narrow.index()].path, "Carpet #1");
}

#[test]
fn an_object_that_was_told_nothing_follows_the_first_settled_of_its_category() {
    let mut p = Program::new(8.0, 6.0);
    let [first, second, third] = ["Chair 1", "Chair 2", "Chair 3"].map(|name| p.add(name, [0.5, 0.5, 1.0]));
    p.face_number(second, 2.0);
    p.face_number(third, 0.0);
    p.facing(third);
    assert_eq!(p.facing(first), Cardinal::XMax, "the second is not settled yet");
    let layout = p.layout();
    assert!(layout.objects[0].body.directed);
    assert_eq!(layout.objects[0].body.told, Told::Never);
}

#[test]
fn an_object_that_fits_only_one_way_lies_that_way() {
    let mut p = Program::new(8.0, 3.0);
    let [wide, deep] = [[2.0, 5.0], [5.0, 2.0]].map(|[width, depth]| p.add("Pool", [width, depth, 1.0]));
    assert_eq!([p.facing(wide), p.facing(deep)], [Cardinal::XMax, Cardinal::YMax]);
}

#[test]
fn facing_itself_means_nothing_but_its_own_corner_is_a_point() {
    let mut p = Program::new(8.0, 8.0);
    let chair = p.add("Chair", [1.0, 0.5, 1.0]);
    p.face_number(chair, 2.0);
    p.toward(chair, chair);
    p.face(chair, FacingSpec::CenterOf(Target::Object(chair)));
    assert_eq!(p.facing(chair), Cardinal::XMin);
    let corner = [p.get(chair, "max.x"), p.get(chair, "center.y")].map(Num::plain);
    p.face(chair, FacingSpec::Point(corner));
    assert_eq!(p.facing(chair), Cardinal::XMax);
    assert_eq!(p.layout().warnings.len(), 1, "one statement, one warning");
}

#[test]
fn wrong_values_raise_what_python_programs_would_see() {
    let mut p = Program::new(8.0, 8.0);
    let chair = p.add("Chair 2", [1.0, 0.5, 1.0]);
    let text = Given::Other { type_name: "str".into(), repr: "'a'".into() };
    let write = |p: &mut Program, value: Given| p.try_write(chair, "min.x", value).expect_err("no coordinate").to_string();
    assert_eq!(write(&mut p, text.clone()), "TypeError: Chair.min.x takes a number, not str");
    assert_eq!(write(&mut p, f64::NAN.into()), "ValueError: Chair.min.x must be finite, not nan");
    let dims = |width: Given| [width, 1.0.into(), 1.0.into()];
    let add = |p: &mut Program, width| p.try_add("Desk 1", dims(width)).expect_err("no size").to_string();
    assert_eq!(add(&mut p, Scalar::int(-1).into()), "ValueError: Desk: width must be a positive number, not -1");
    assert_eq!(add(&mut p, text), "ValueError: Desk: width must be a positive number, not 'a'");
    let scene = p.0.write(&mut Plain, Target::Scene, Anchor::Min, Axis::X, &1.0.into(), ORIGIN);
    assert_eq!(scene.expect_err("fixed").to_string(), "AttributeError: the scene cannot be moved");
}

#[test]
fn integers_stay_integers_where_python_keeps_them() {
    let mut p = Program::new(8.0, 8.0);
    let shelf = p.try_add("Shelf", [Scalar::int(1).into(), 0.5.into(), 2.0.into()]).expect("a good object");
    for place in ["center.x", "center.y", "center.z"] {
        p.try_write(shelf, place, Scalar::int(2).into()).expect("a good number");
    }
    let json: serde_json::Value = serde_json::from_str(&layout_json(&p.layout(), &[], &|_| 1)).expect("JSON");
    let object = &json["objects"][0];
    assert_eq!(object["width"].to_string(), "1");
    assert_eq!(object["center"].to_string(), "[2.0,2.0,2]");
    assert_eq!(object["anchors"].to_string(), r#"[["center","x",2.0],["center","y",2.0],["center","z",2]]"#);
    assert_eq!(json["scene"]["width"].to_string(), "8.0");
}

#[test]
fn a_settling_is_one_number_that_follows_from_others() {
    let mut trace = Trace::recording(1_000);
    let mut literal = |id, value| Num { value, handle: trace.literal(id, value) };
    let (x, y) = (literal(0, 1.0), literal(1, -3.0));
    let mut world = World::new();
    let add = |world: &mut World, trace: &mut Trace, name| {
        let (dims, support) = ([1.0, 0.5, 1.0].map(Given::from), Scalar::int(0).into());
        world.add_object(trace, &NewObject { kind: Kind::Object, name, dims, support, color: None, dynamic: false }, ORIGIN)
    };
    let [table, chair] = ["Table", "Chair"].map(|name| add(&mut world, &mut trace, name).expect("a good object"));
    let write = |world: &mut World, trace: &mut Trace, object, axis, value| {
        world.write(trace, Target::Object(object), Anchor::Center, axis, &Scalar::from(value).into(), ORIGIN).expect("a good number");
    };
    write(&mut world, &mut trace, table, Axis::X, x);
    write(&mut world, &mut trace, chair, Axis::Y, y);
    let told = world.set_facing(&mut trace, chair, &FacingSpec::Toward(Target::Object(table)), Handle::NONE, ORIGIN);
    told.expect("a good facing");
    let facing = world.facing(&mut trace, Target::Object(chair)).num;
    assert_eq!(facing.value, 1.0);
    let slices = Slices::of(&trace).expect("a short record");
    let mut replay = Replay::new(&trace);
    let mut with = |literal: usize, value: f64| {
        let slice: &LiteralSlice = &slices.literals()[literal];
        replay.set(&trace, slice, value);
        assert!(replay.holds(&trace, slice));
        let facing = replay.now(facing);
        replay.undo();
        facing
    };
    assert_eq!((with(0, 2.0), with(1, -4.0)), (1.0, 1.0));
    assert_eq!(with(0, 4.0), 0.0, "the table moved so far to the right that the chair faces it there");
    assert_eq!(with(1, 3.0), 3.0, "the chair moved behind the table");
}

#[test]
fn what_becomes_a_size_is_set_in_stone() {
    let mut trace = Trace::recording(10);
    let (width, gap) = (trace.literal(0, 2.0), trace.literal(1, 0.5));
    let number = |value, handle| Given::Number(Num { value, handle }.into());
    let mut world = World::new();
    let dims = [number(2.0, width), 1.0.into(), 1.0.into()];
    let new = NewObject { kind: Kind::Object, name: "Table", dims, support: Scalar::int(0).into(), color: None, dynamic: false };
    let table = Target::Object(world.add_object(&mut trace, &new, ORIGIN).expect("a good object"));
    world.write(&mut trace, table, Anchor::Min, Axis::X, &number(0.5, gap), ORIGIN).expect("a good number");
    assert_eq!(trace.stone(), [width]);
    assert!(world.dims(table)[0].num.handle.is_none());
    let max = world.read(&mut trace, table, Anchor::Max, Axis::X).num;
    assert_eq!((max.value, max.handle.is_none()), (2.5, false));
}
