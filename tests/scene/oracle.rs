//! Thousands of random scripts of scene calls mean the same here and in the reference implementation.
//!
//! `PSDL_ORACLE` names oracle.py or its folder; without it there is nothing to compare with.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use proptest::test_runner::TestRunner;
use psdl::check::{Rules, check};
use psdl::scene::{
    Anchor, Axis, FacingSpec, Given, JsonViolation, Kind, NewObject, ObjectId, Origins, Scalar, SceneError, Target, WarningKind, World,
    layout_json,
};
use psdl::trace::{Num, Plain};
use serde_json::{Value, json};

use super::layouts::assert_same;
use super::read;

const SCRIPTS: usize = 6_000;

/// A coordinate: a number, one read from something with an offset, or no number at all.
fn coordinate(objects: i64) -> impl Strategy<Value = Value> {
    let offset = prop_oneof![Just(0.0), Just(0.0), Just(0.1), Just(-0.5), -3.0..3.0];
    let relative =
        (-1..objects, anchor(), 0..3_usize, offset).prop_map(|(target, part, axis, plus)| json!([target, part, "xyz"[axis..=axis], plus]));
    prop_oneof![
        8 => (-4.0..4.0_f64).prop_map(|value| json!(value)),
        3 => (-4..4_i64).prop_map(|value| json!(value)),
        2 => (-16..16_i64).prop_map(|step| json!(step as f64 * 0.25)),
        12 => relative,
        1 => prop::sample::select(vec![json!("nan"), json!("inf"), json!("text"), json!("true"), json!("none"), json!(-0.0)]),
    ]
}

fn anchor() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec!["min", "center", "max"])
}

fn size() -> impl Strategy<Value = Value> {
    prop_oneof![
        10 => (0.05..2.0_f64).prop_map(|value| json!(value)),
        4 => prop::sample::select(vec![json!(1), json!(0.5), json!(1.0), json!(2), json!(0.1), json!(0.02), json!(7.5)]),
    ]
}

fn bad_size() -> impl Strategy<Value = Value> {
    prop::sample::select(vec![json!(0), json!(-1.5), json!("nan"), json!("inf"), json!("text"), json!("true"), json!(-1e-7)])
}

fn declaration() -> impl Strategy<Value = Value> {
    let kind = prop::sample::select(vec!["Object", "Object", "Object", "Object", "Door", "Window"]);
    let name = prop::sample::select(vec!["Chair", "Chair 2", "Chair  10", "Table", "Lamp", "Lamp2", "Rug 3", "Sofa"]);
    (kind, name, size(), size(), size(), 0..3).prop_map(|(kind, name, w, d, h, support)| json!(["add", kind, name, w, d, h, support]))
}

/// A declaration that raises.
fn bad_declaration() -> impl Strategy<Value = Value> {
    let support = prop::sample::select(vec![json!(3), json!("text"), json!(-1.0)]);
    prop_oneof![
        (bad_size(), size()).prop_map(|(bad, size)| json!(["add", "Door", "Gate 1", size, bad, size, 5])),
        (bad_size(), support, size()).prop_map(|(bad, support, size)| json!(["add", "Object", "Gate 1", bad, size, size, support])),
        (bad_size(), bad_size()).prop_map(|(bad, worse)| json!(["add", "Object", "Gate 1", 1, bad, worse, 2])),
    ]
}

fn facing(objects: i64) -> impl Strategy<Value = Value> {
    let number = prop_oneof![
        4 => (0..4_i64).prop_map(|value| json!(value)),
        1 => (-9..9_i64).prop_map(|value| json!(value)),
        1 => (-400.0..800.0_f64).prop_map(|value| json!(value)),
        1 => prop::sample::select(vec![json!(90), json!(180), json!(270.0), json!(9.99), json!(10), json!("nan"), json!("inf")]),
    ];
    let point = prop::array::uniform2(-4.0..4.0_f64).prop_map(|[x, y]| json!(["point", [x, y]]));
    let tied = (-8..8_i64, -8..8_i64).prop_map(|(x, y)| json!(["point", [x as f64 * 0.5, y as f64 * 0.5]]));
    let how = prop_oneof![
        3 => number.prop_map(|value| json!(["number", value])),
        6 => (-1..objects).prop_map(|target| json!(["toward", target])),
        2 => (anchor(), -1..objects).prop_map(|(part, target)| json!([part, target])),
        1 => point,
        1 => tied,
        1 => Just(json!(["nothing", null])),
    ];
    (0..objects, how).prop_map(|(object, how)| json!(["face", object, how[0], how[1]]))
}

fn call(objects: i64) -> impl Strategy<Value = Value> {
    let axis = || prop::sample::select(vec!["x", "x", "y", "y", "z"]);
    let late_size = (4..9_i64, 2.5..9.0_f64).prop_map(|(width, depth)| json!(["size", width, depth, 3]));
    prop_oneof![
        30 => (0..objects, anchor(), axis(), coordinate(objects)).prop_map(|(o, part, axis, value)| json!(["write", o, part, axis, value])),
        1 => (anchor(), axis()).prop_map(|(part, axis)| json!(["write", -1, part, axis, 1.0])),
        8 => facing(objects),
        4 => (-1..objects, anchor(), axis()).prop_map(|(target, part, axis)| json!(["read", target, part, axis])),
        2 => (-1..objects).prop_map(|target| json!(["facing", target])),
        3 => (-1..objects).prop_map(|target| json!(["frame", target])),
        1 => Just(json!(["frame", -1])),
        1 => late_size,
        1 => declaration(),
        1 => bad_declaration(),
    ]
}

fn script() -> impl Strategy<Value = Vec<Value>> {
    let room = prop::sample::select(vec![(6.0, 6.0), (8.0, 4.5), (3.0, 7.0), (12.0, 10.0)]);
    let head =
        (room, any::<bool>()).prop_map(|((width, depth), interior)| vec![json!(["size", width, depth, 3]), json!(["interior", interior])]);
    (head, prop::collection::vec(declaration(), 1..9)).prop_flat_map(|(head, declarations)| {
        let objects = declarations.len() as i64;
        prop::collection::vec(call(objects), 0..40).prop_map(move |calls| [head.clone(), declarations.clone(), calls].concat())
    })
}

/// A script under way in a [`World`].
struct Script(World);

impl Script {
    fn target(&self, index: &Value) -> Target {
        match index.as_i64().expect("an index") {
            -1 => Target::Scene,
            index => Target::Object(ObjectId(index as u32)),
        }
    }

    fn read(&mut self, target: &Value, part: &Value, axis: &Value) -> Scalar {
        let (anchor, axis) = place(part, axis);
        self.0.read(&mut Plain, self.target(target), anchor, axis)
    }

    fn given(&mut self, spec: &Value) -> Given {
        let other = |type_name: &str, repr: &str| Given::Other { type_name: type_name.into(), repr: repr.into() };
        match spec {
            Value::Number(number) => Given::Number(match number.as_i64() {
                Some(value) => Scalar::int(value),
                None => Scalar::float(number.as_f64().expect("a number")),
            }),
            Value::Array(items) => {
                let base = self.read(&items[0], &items[1], &items[2]);
                Given::from(base.value() + items[3].as_f64().expect("a number"))
            }
            _ => match spec.as_str().expect("a name") {
                "nan" => f64::NAN.into(),
                "inf" => f64::INFINITY.into(),
                "text" => other("str", "'a'"),
                "true" => other("bool", "True"),
                _ => other("NoneType", "None"),
            },
        }
    }

    fn spec(&mut self, how: &str, what: &Value) -> FacingSpec {
        match how {
            "number" => match self.given(what) {
                Given::Number(number) => FacingSpec::Number(number),
                Given::Other { .. } => unreachable!("scripts face numbers"),
            },
            "toward" => FacingSpec::Toward(self.target(what)),
            "center" => FacingSpec::CenterOf(self.target(what)),
            "min" | "max" => FacingSpec::Point([json!("x"), json!("y")].map(|axis| self.read(what, &json!(how), &axis).num)),
            "point" => FacingSpec::Point([0, 1].map(|k| Num::plain(what[k].as_f64().expect("a number")))),
            _ => FacingSpec::Nothing,
        }
    }

    fn run(&mut self, call: &Value) -> Result<Value, SceneError> {
        let shown = |scalar: Scalar| if scalar.int { json!(scalar.value() as i64) } else { json!(scalar.value()) };
        match call[0].as_str().expect("a call") {
            "size" => self.0.set_size(&mut Plain, &[1, 2, 3].map(|k| number(&call[k]).into()))?,
            "interior" => self.0.set_wall_asset("", call[1] == true, None, Origins::NOWHERE),
            "add" => self.add(call)?,
            "write" => {
                let (anchor, axis) = place(&call[2], &call[3]);
                let (target, value) = (self.target(&call[1]), self.given(&call[4]));
                self.0.write(&mut Plain, target, anchor, axis, &value, Origins::NOWHERE)?;
            }
            "read" => return Ok(shown(self.read(&call[1], &call[2], &call[3]))),
            "facing" => return Ok(json!(self.0.facing(&mut Plain, self.target(&call[1])).value() as usize)),
            "frame" => self.0.set_frame(&mut Plain, self.target(&call[1])),
            "face" => {
                let spec = self.spec(call[2].as_str().expect("how"), &call[3]);
                let Target::Object(id) = self.target(&call[1]) else { unreachable!("scripts turn objects") };
                self.0.set_facing(&mut Plain, id, &spec, psdl::trace::Handle::NONE, Origins::NOWHERE)?;
            }
            other => unreachable!("{other}"),
        }
        Ok(Value::Null)
    }

    fn add(&mut self, call: &Value) -> Result<(), SceneError> {
        let kind = match call[1].as_str() {
            Some("Door") => Kind::Door,
            Some("Window") => Kind::Window,
            _ => Kind::Object,
        };
        let (dims, support) = ([3, 4, 5].map(|k| self.given(&call[k])), self.given(&call[6]));
        let new = NewObject { kind, name: call[2].as_str().expect("a name"), dims, support, color: None, dynamic: false };
        self.0.add_object(&mut Plain, &new, Origins::NOWHERE)?;
        Ok(())
    }
}

fn number(value: &Value) -> Scalar {
    value.as_i64().map_or_else(|| Scalar::float(value.as_f64().expect("a number")), Scalar::int)
}

fn place(part: &Value, axis: &Value) -> (Anchor, Axis) {
    let text = |value: &Value| value.as_str().expect("a name").to_owned();
    (Anchor::from_name(&text(part)).expect("an anchor"), Axis::from_name(&text(axis)).expect("an axis"))
}

/// The layout of a script as JSON, with what its calls gave and how many objects were told to face themselves.
fn ours(calls: &[Value]) -> Value {
    let mut script = Script(World::new());
    let results: Vec<Value> = calls.iter().map(|call| script.run(call).unwrap_or_else(|error| json!(error.to_string()))).collect();
    let layout = script.0.into_layout(&mut Plain);
    let verdict = check(&layout, &Rules::default());
    let objects: Vec<Vec<usize>> = verdict.counted().map(|found| found.objects().collect()).collect();
    let violations: Vec<JsonViolation> = std::iter::zip(verdict.counted(), &objects)
        .map(|(found, objects)| JsonViolation { kind: found.kind.name(), objects, loss: found.loss })
        .collect();
    let mut json: Value = serde_json::from_str(&layout_json(&layout, &violations, &|_| 1)).expect("layout JSON");
    json["results"] = json!(results);
    json["warnings"] = json!(layout.warnings.iter().filter(|warning| warning.kind == WarningKind::SelfFacing).count());
    json
}

fn compare(calls: &[Value], theirs: &Value) {
    let (script, ours) = (json!(calls), ours(calls));
    // A script of one program line warns once; the reference warns each time.
    assert_eq!(ours["warnings"] == 0, theirs["warnings"] == 0, "{script}");
    assert_eq!(ours["results"], theirs["results"], "{script}");
    assert_eq!(ours["scene"], theirs["scene"], "{script}");
    let objects = |layout: &Value| layout["objects"].as_array().expect("objects").clone();
    let (our_objects, their_objects) = (objects(&ours), objects(theirs));
    assert_eq!(our_objects.len(), their_objects.len(), "{script}");
    for (mut ours, theirs) in our_objects.into_iter().zip(their_objects) {
        for key in ["path", "color", "lines"] {
            ours.as_object_mut().expect("an object").remove(key);
        }
        assert_eq!(ours, theirs, "{script}");
    }
    assert_same(&script.to_string(), &read::violations(&ours), &read::violations(theirs));
}

/// The folder of the reference implementation, if there is one.
#[allow(clippy::print_stdout, reason = "a skipped test says so")]
pub fn reference() -> Option<PathBuf> {
    let Some(oracle) = std::env::var_os("PSDL_ORACLE").map(PathBuf::from) else {
        println!("skipped: PSDL_ORACLE does not name oracle.py");
        return None;
    };
    Some(if oracle.is_dir() { oracle } else { oracle.parent().expect("a folder").to_owned() })
}

/// The answers of a driver in Python to questions, a line each.
pub fn ask(driver: &str, reference: &Path, questions: impl Iterator<Item = Value>) -> Vec<Value> {
    let driver = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scene").join(driver);
    let mut python = Command::new("python3");
    python.arg("-B").arg(driver).arg(reference).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut python = python.spawn().expect("PSDL_ORACLE is set, so python3 is there");
    let mut input = python.stdin.take().expect("a pipe");
    let lines: String = questions.map(|question| format!("{question}\n")).collect();
    let writer = std::thread::spawn(move || input.write_all(lines.as_bytes()));
    let output = python.wait_with_output().expect("python3 ends");
    writer.join().expect("no panic").expect("python3 reads");
    let output = String::from_utf8(output.stdout).expect("UTF-8");
    output.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

#[test]
fn random_scripts_mean_what_the_reference_says() {
    let Some(folder) = reference() else { return };
    let mut runner = TestRunner::deterministic();
    let scripts: Vec<Vec<Value>> = (0..SCRIPTS).map(|_| script().new_tree(&mut runner).expect("a script").current()).collect();
    let answers = ask("driver.py", &folder, scripts.iter().map(|calls| json!(calls)));
    assert_eq!(answers.len(), SCRIPTS);
    let mut kinds = std::collections::BTreeMap::<String, usize>::new();
    for (calls, theirs) in scripts.iter().zip(&answers) {
        compare(calls, theirs);
        read::violations(theirs).into_iter().for_each(|(kind, ..)| *kinds.entry(kind).or_default() += 1);
    }
    assert_eq!(kinds.len(), 8, "every kind of error occurs: {kinds:?}");
}
