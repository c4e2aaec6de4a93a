//! Thousands of generated programs do the same here and in the reference implementation, which `PSDL_ORACLE` names.

use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};

use super::oracle::{ask, reference};
use super::programs::{assert_same_layout, layout_and_output};

const PROGRAMS: usize = 3_000;
const OBJECTS: usize = 5;

fn pick(choices: &'static [&'static str]) -> impl Strategy<Value = String> + Clone {
    prop::sample::select(choices).prop_map(str::to_owned)
}

fn object() -> impl Strategy<Value = String> {
    (0..OBJECTS).prop_map(|index| format!("o[{index}]"))
}

fn target() -> impl Strategy<Value = String> {
    prop_oneof![8 => object(), 2 => Just("scene".to_owned())]
}

fn part() -> impl Strategy<Value = String> {
    (target(), pick(&["min", "center", "max"])).prop_map(|(target, part)| format!("{target}.{part}"))
}

fn float() -> impl Strategy<Value = String> {
    prop_oneof![
        (-30..30_i32).prop_map(|step| format!("{:?}", f64::from(step) * 0.1)),
        (-3.0..3.0_f64).prop_map(|value| format!("{value:?}"))
    ]
}

fn number() -> BoxedStrategy<String> {
    let read = (part(), pick(&["x", "y", "z"])).prop_map(|(part, axis)| format!("{part}.{axis}"));
    let size = (target(), pick(&["width", "depth", "height", "facing", "support"])).prop_map(|(target, name)| format!("{target}.{name}"));
    let leaf = prop_oneof![4 => float(), 2 => (-3..9_i32).prop_map(|value| value.to_string()), 6 => read, 2 => size];
    let made = (leaf.clone(), pick(&["+", "-", "*", "/"]), leaf.clone()).prop_map(|(a, op, b)| format!("{a} {op} {b}"));
    prop_oneof![leaf, made].boxed()
}

fn vector() -> impl Strategy<Value = String> {
    let made = (number(), number(), number(), pick(&["Vec", ""])).prop_map(|(x, y, z, name)| format!("{name}({x}, {y}, {z})"));
    let leaf = || prop_oneof![part(), made.clone().prop_filter("a tuple has no arithmetic", |text| text.starts_with('V'))];
    let sum = (leaf(), pick(&["+", "-"]), prop_oneof![part(), made.clone()]).prop_map(|(a, op, b)| format!("{a} {op} {b}"));
    let scaled = (leaf(), pick(&["*", "/"]), number()).prop_map(|(a, op, k)| format!("{a} {op} ({k})"));
    let odd = pick(&[
        "(1, 2)",
        "[1, 2.5, 0]",
        "5",
        "'abc'",
        "(True, 0, 1)",
        "o[0]",
        "range(3)",
        "2 * o[1].max",
        "-o[2].center",
        "(v for v in (1, 2, 3))",
    ]);
    prop_oneof![4 => part(), 3 => made.clone(), 3 => sum, 2 => scaled, 2 => odd]
}

fn facing() -> impl Strategy<Value = String> {
    let named = pick(&[
        "X_MAX",
        "Y_MAX",
        "X_MIN",
        "Y_MIN",
        "TOP_WALL",
        "X_NEG",
        "None",
        "'up'",
        "True",
        "opposite(o[0].facing)",
        "90",
        "CENTER",
        "Object",
    ]);
    prop_oneof![4 => named, 6 => target(), 3 => vector(), 2 => number(), 1 => target().prop_map(|target| format!("{target}.facing"))]
}

fn statement() -> impl Strategy<Value = String> {
    let axis = || pick(&["x", "x", "y", "y", "z"]);
    let written = prop_oneof![12 => number(), 1 => pick(&["'a'", "None", "True", "float('nan')", "10**400", "1e308 * 10", "2**40"])];
    let call = pick(&[
        "set_coordinate_frame(scene)",
        "set_size(7, 8.5, 3)",
        "o.append(Object('Chair 9', 1, 0.5, 1, FLOATING))",
        "o.append(Door('Gate', 1, 0.1, 2))",
        "o.append(Window('Pane', 1.2, 0.1, 1, support=STANDING))",
        "o.append(Object(name='Rug', width=3, depth=2, height=0.01))",
        "Object('Chair', 1, 0, 1)",
        "Object('Chair', 1, 1, 'a')",
        "Object('Chair', 1, 1, 1, 4)",
        "o[0].colour",
        "o[0].width = 3",
        "o[0].center.w",
        "o[0].center.w = 3",
        "scene.center = (1, 2, 3)",
        "scene.colour",
        "(o[0].center + o[1].max).x = 3",
        "print(o[0].center == o[0].center, o[0].center == tuple(o[0].center), Vec(1, 2, 3) == Vec(1.0, 2, 3), o[0] == o[1])",
        "x, y, z = o[1].max; print(x, y, z)",
        "print(len(o[0].min), o[1].min[-1], list(o[2].center)[0], o[0].name, hash(Vec(1, 2, 3)) == hash((1, 2, 3)))",
        "print(sorted(o, key=lambda p: p.center.x)[0].center)",
        "print(sum(p.width for p in o), max(p.max.z for p in o))",
    ]);
    prop_oneof![
        12 => (object(), pick(&["min", "center", "max"]), axis(), written).prop_map(|(o, part, axis, value)| format!("{o}.{part}.{axis} = {value}")),
        2 => (object(), pick(&["min", "center", "max"]), axis(), pick(&["+=", "-="]), float()).prop_map(|(o, part, axis, op, value)| format!("{o}.{part}.{axis} {op} {value}")),
        4 => (object(), pick(&["min", "center", "max"]), vector()).prop_map(|(o, part, value)| format!("{o}.{part} = {value}")),
        5 => (object(), facing()).prop_map(|(o, value)| format!("{o}.facing = {value}")),
        2 => object().prop_map(|o| format!("set_coordinate_frame({o})")),
        2 => vector().prop_map(|value| format!("print(*({value}))")),
        2 => number().prop_map(|value| format!("print({value})")),
        3 => call,
    ]
}

/// Statements that raise end a program now and then; mostly they are caught, and say what they raised.
fn program() -> impl Strategy<Value = String> {
    let caught = statement()
        .prop_map(|statement| format!("try:\n    {statement}\nexcept Exception as error:\n    print(type(error).__name__, error)\n"));
    let looped = statement().prop_map(|statement| format!("for o[0] in o[:2]:\n    {statement}\n"));
    let line = prop_oneof![10 => caught, 1 => statement().prop_map(|statement| statement + "\n"), 1 => looped];
    let dims = prop::sample::select(vec!["1, 0.5, 1", "2, 1, 0.75", "0.5, 0.5, 1", "0.3, 1.5, 2", "7.5, 0.4, 1", "1.5, 1, 0.05"]);
    let declared = (pick(&["Chair", "Chair 2", "Table", "Lamp 10"]), dims, 0..3_u8)
        .prop_map(|(name, dims, support)| format!("    Object('{name}', {dims}, {support}),\n"));
    let room = pick(&["set_size(6, 6, 3)\n", "set_size(8, 4.5, 3)\n", "set_size(3.5, 7, 2.5)\nset_wall_asset('Wall', interior=False)\n"]);
    (room, prop::collection::vec(declared, OBJECTS), prop::collection::vec(line, 0..25))
        .prop_map(|(room, declared, lines)| format!("{room}o = [\n{}]\n{}", declared.concat(), lines.concat()))
}

#[test]
fn generated_programs_do_what_the_reference_does() {
    let Some(folder) = reference() else { return };
    let mut runner = TestRunner::deterministic();
    let programs: Vec<String> = (0..PROGRAMS).map(|_| program().new_tree(&mut runner).expect("a program").current()).collect();
    // The reference has a class of its own for objects.
    let renamed = |text: &Value| text.as_str().map(|text| text.replace("Thing", "Object"));
    let answers = ask("run_programs.py", &folder, programs.iter().map(|program| json!(program)));
    assert_eq!(answers.len(), PROGRAMS);
    for (program, theirs) in programs.iter().zip(&answers) {
        let (ours, printed) = layout_and_output(program, None);
        assert_eq!(Some(printed), renamed(&theirs["printed"]), "{program}");
        match ours {
            Ok(ours) => {
                assert_eq!(theirs["raised"], Value::Null, "{program}");
                assert_same_layout(program, &ours, theirs);
            }
            Err(error) => assert_eq!(Some(error), renamed(&theirs["raised"]), "{program}"),
        }
    }
}
