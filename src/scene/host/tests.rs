//! Programs, and the scene they make.

use super::*;
use crate::python::program::build;
use crate::python::vm::Options;
use crate::scene::{Cardinal, Kind, Scalar, Support, WarningKind, template};
use crate::syntax::{parse, tune};

/// The layout of a program, what it printed, and the last line of each exception.
fn run_on(host: SceneHost, text: &str) -> (Layout, String, Vec<String>) {
    let parsed = parse(text);
    assert!(parsed.is_complete(), "{:?}", parsed.errors);
    let program = build(&parsed, text, &tune(&parsed, text)).expect("it compiles");
    let mut printed = String::new();
    let options = Options { lenient: true, ..Options::default() };
    let run = run(program, &bound_in_loops(&parsed), host, options, &mut |text| printed.push_str(text));
    assert_eq!(run.outcome.stop, None);
    let last = |uncaught: &crate::python::vm::Uncaught| uncaught.chain.last().map_or(String::new(), |shown| shown.line.clone());
    (run.layout, printed, run.outcome.exceptions.iter().map(last).collect())
}

fn scene(text: &str) -> Layout {
    let (layout, _, exceptions) = run_on(SceneHost::new(), text);
    assert_eq!(exceptions, [""; 0]);
    layout
}

fn printed(text: &str) -> String {
    let (_, printed, exceptions) = run_on(SceneHost::new(), text);
    assert_eq!(exceptions, [""; 0]);
    printed
}

fn exceptions(text: &str) -> Vec<String> {
    run_on(SceneHost::new(), text).2
}

fn paths(layout: &Layout) -> Vec<&str> {
    layout.objects.iter().map(|object| object.path.as_str()).collect()
}

const BED: &str = "bed = Object('Bed', 1.6, 2.0, 0.6)\n";

#[test]
fn the_example_of_the_specification() {
    let layout = scene(
        r#"
set_title("Bedroom")
set_size(width=5, depth=6, height=2.8)
set_floor_asset("Wooden Floor", color="9B7D60")
set_wall_asset("Painted Wall", interior=True, color="C7B9A8")
bed = Object("Double Bed", width=1.6, depth=2.0, height=0.6, support=STANDING, color="4169E1")
nightstands = [Object("Nightstand", 0.5, 0.4, 0.6, STANDING) for _ in range(2)]
door = Door("Wooden Door", width=0.9, depth=0.1, height=2.0, color="8B4513")

bed.max.y = scene.max.y
bed.center.x = scene.center.x
bed.min.z = scene.min.z
bed.facing = Y_MIN
set_coordinate_frame(bed)
gap = 0.1
for i, stand in enumerate(nightstands):
    if i == 0: stand.max.x = bed.min.x - gap
    else:      stand.min.x = bed.max.x + gap
    stand.min.y = bed.min.y
    stand.facing = bed.facing
set_coordinate_frame(scene)
"#,
    );
    assert_eq!(layout.scene.title, "Bedroom");
    assert_eq!(layout.scene.dims, [Scalar::int(5), Scalar::int(6), Scalar::float(2.8)]);
    assert_eq!(paths(&layout), ["bed", "nightstands[0]", "nightstands[1]", "door"]);
    let bodies = layout.bodies();
    assert_eq!(bodies[0].center, [0.0, 2.0, 0.3]);
    assert_eq!([bodies[1].center[0], bodies[2].center[0]], [1.15, -1.15], "in the frame of a bed that faces down, left is right");
    assert_eq!(bodies[1].turn, Cardinal::YMin);
    assert_eq!((bodies[3].kind, bodies[3].support, bodies[3].is_placed()), (Kind::Door, Support::Mounted, false));
}

#[test]
fn each_write_remembers_its_statement_loop_and_calls() {
    let text = "
def place(chair, x):
    chair.min.x = x

chairs = [Object('Chair', 1, 1, 1) for _ in range(3)]
for i, chair in enumerate(chairs):
    place(chair, i)
";
    let layout = scene(text);
    let anchor = layout.objects[2].anchors[0];
    assert_eq!(&text[layout.origins.get(anchor.origin).range], "chair.min.x = x");
    let steps: Vec<_> = layout.origins.steps_around(anchor.origin).map(|step| (&text[step.range], step.kind.clone())).collect();
    assert_eq!(steps[0], ("place(chair, i)", StepKind::Call { function: "place".into() }));
    assert_eq!(steps[1].1, StepKind::Loop { variable: "i".into(), value: "2".into() });
    assert_eq!(paths(&layout), ["chairs[0]", "chairs[1]", "chairs[2]"]);
}

#[test]
fn objects_are_named_after_globals_makers_or_categories() {
    let text = "
class Room:
    def __init__(self):
        self.bed = Object('Bed', 1, 1, 1)

def create_wall():
    return Object('Wall', 1, 1, 1)

room = Room()
lamps = {'left': Object('Lamp', 1, 1, 1), 4: (Object('Lamp', 1, 1, 1),)}
for i in range(2):
    wall = create_wall()
Object('Chair', 1, 1, 1)
";
    assert_eq!(paths(&scene(text)), ["room.bed", "lamps['left']", "lamps[4][0]", "create_wall() #1", "create_wall() #2", "Chair #1"]);
}

#[test]
fn vectors_are_values_and_parts_are_bound() {
    let text = "
bed.center.x, bed.center.y, bed.min.z = 1, 2.5, 0
c = bed.center
c.x = 3
print(bed.center, bed.center.x, len(c), c[1], tuple(c))
print(c + (1, 1, 1), c - Vec(0, 0.5, 0), c * 2, 2 * c, c / 2, -c)
print(c == Vec(3.0, 2.5, 0.3), Vec(1, 2, 3) == Vec(1, 2, 3), Vec(1, 2, 3) == (1, 2, 3), Vec(1, 2, 3).y)
x, y, z = bed.max
print(x, z, bed.facing, bed.width, scene.width, scene.max.z, bed.name, bed.support, opposite(1), center(bed) is bed)
print(isinstance(bed, Object), isinstance(bed, Door), isinstance(c + c, Vec), {bed: 1}[bed])
";
    let expected = "\
Vec(3.0, 2.5, 0.3) 3.0 3 2.5 (3.0, 2.5, 0.3)
Vec(4.0, 3.5, 1.3) Vec(3.0, 2.0, 0.3) Vec(6.0, 5.0, 0.6) Vec(6.0, 5.0, 0.6) Vec(1.5, 1.25, 0.15) Vec(-3.0, -2.5, -0.3)
True True False 2
3.8 0.6 1 1.6 6.0 3.0 Bed 0 3 True
True False True 1
";
    assert_eq!(printed(&format!("{BED}{text}")), expected);
}

#[test]
fn whole_vectors_are_assigned_from_sequences() {
    let text = "bed.center = (v + i for i, v in enumerate([1, 2, 3]))\nlamp = Object('Lamp', 1, 1, 1)\nlamp.min = bed.max";
    let layout = scene(&format!("{BED}{text}"));
    assert_eq!(layout.objects[0].body.center, [1.0, 3.0, 5.0]);
    assert_eq!(layout.objects[1].body.center, [2.3, 4.5, 5.8]);
}

#[test]
fn every_kind_of_facing() {
    let text = "
things = [Object('Thing %d' % i, 1, 1, 1) for i in range(9)]
a, b, c, d, e, f, g, h, i = things
for k, thing in enumerate(things):
    thing.center = (k, 0, 1)
a.facing = 2
b.facing = 270
c.facing = a
d.facing = (3, 9)
e.facing = a.center
f.facing = scene
g.facing = g
h.facing = a.facing
i.facing = bed.max
";
    let layout = scene(&format!("set_size(40, 40, 3)\n{BED}bed.center.y = -9\n{text}"));
    use Cardinal::{XMin, YMax, YMin};
    let turns: Vec<Cardinal> = layout.objects[1..].iter().map(|object| object.body.turn).collect();
    assert_eq!(turns, [XMin, YMin, XMin, YMax, XMin, XMin, XMin, XMin, YMin]);
    assert_eq!(layout.warnings.iter().map(|warning| warning.kind.clone()).collect::<Vec<_>>(), [WarningKind::SelfFacing]);
}

#[test]
fn errors_say_what_the_reference_says() {
    let raised = |statement: &str| exceptions(&format!("{BED}{statement}")).join(" | ");
    assert_eq!(raised("bed.center.x = 'a'"), "TypeError: Bed.center.x takes a number, not str");
    assert_eq!(raised("bed.center.x = True"), "TypeError: Bed.center.x takes a number, not bool");
    assert_eq!(raised("bed.center.x = float('nan')"), "ValueError: Bed.center.x must be finite, not nan");
    assert_eq!(raised("bed.center.x = 10**400"), "OverflowError: int too large to convert to float");
    assert_eq!(raised("bed.center = (1, 2)"), "ValueError: center takes three coordinates, not 2");
    assert_eq!(raised("bed.center = 5"), "TypeError: 'int' object is not iterable");
    assert_eq!(raised("bed.center.w = 5"), "AttributeError: a vec3 has x, y and z, not 'w'");
    assert_eq!(raised("bed.center.w"), "AttributeError: a vec3 has x, y and z, not 'w'");
    assert_eq!(raised("bed.colour"), "AttributeError: 'Bed' has no attribute 'colour'");
    assert_eq!(raised("bed.width = 5"), "AttributeError: cannot set 'width' of 'Bed'");
    assert_eq!(raised("scene.min.x = 5"), "AttributeError: the scene cannot be moved");
    assert_eq!(raised("scene.colour"), "AttributeError: scene has no attribute 'colour'");
    assert_eq!(raised("scene.min = 5"), "AttributeError: cannot set 'min' of the scene");
    let copy = "AttributeError: a vector that was read is a copy; write o.center.x = ... instead";
    assert_eq!(raised("(bed.center + bed.max).x = 5"), copy);
    assert_eq!(raised("bed.facing = 'a'"), "TypeError: Bed.facing takes a direction, an object or a point, not str");
    assert_eq!(raised("bed.facing = float('inf')"), "OverflowError: cannot convert float infinity to integer");
    assert_eq!(raised("Object('A', 1, -2, 1)"), "ValueError: A: depth must be a positive number, not -2");
    assert_eq!(raised("Object('A 1', 1, 1, 1, 7)"), "ValueError: A 1: support must be STANDING, MOUNTED or FLOATING, not 7");
    assert_eq!(raised("bed.center / 0"), "ZeroDivisionError: float division by zero");
    assert_eq!(raised("bed.center + 1"), "TypeError: unsupported operand type(s) for +: 'vec3' and 'int'");
    assert_eq!(raised("set_coordinate_frame(3)"), "TypeError: set_coordinate_frame() takes an object or the scene, not int");
}

#[test]
fn calls_take_arguments_as_python_functions_do() {
    let raised = |statement: &str| exceptions(statement).join(" | ");
    assert_eq!(raised("Object('A', 1)"), "TypeError: Object() missing 2 required positional arguments: 'depth' and 'height'");
    assert_eq!(raised("Door()"), "TypeError: Door() missing 4 required positional arguments: 'name', 'width', 'depth', and 'height'");
    assert_eq!(raised("Object('A', 1, 1, 1, colour=2)"), "TypeError: Object() got an unexpected keyword argument 'colour'");
    assert_eq!(raised("Object('A', 1, 1, 1, name=2)"), "TypeError: Object() got multiple values for argument 'name'");
    assert_eq!(raised("set_title(1, 2)"), "TypeError: set_title() takes 1 positional argument but 2 were given");
    assert_eq!(raised("Object(1, 2, 3, 4, 5, 6, 7, 8)"), "TypeError: Object() takes from 4 to 7 positional arguments but 8 were given");
    let layout = scene("door = Door('Door', 1, 0.1, 2, 'FF0000', STANDING)\nchair = Object('Chair 1', 1, 1, 1, FLOATING, '#00ff00', True)");
    assert_eq!(layout.objects.iter().map(|object| object.color.as_deref()).collect::<Vec<_>>(), [Some("FF0000"), Some("00ff00")]);
    assert_eq!(layout.objects.iter().map(|object| object.body.support).collect::<Vec<_>>(), [Support::Mounted, Support::Floating]);
    assert!(layout.objects[1].dynamic && layout.objects[1].name == "Chair");
}

#[test]
fn a_statement_that_fails_leaves_the_frame_as_it_was() {
    let text = "
bed.facing = X_MAX
def shift():
    set_coordinate_frame(bed)
    raise ValueError('no')
shift()
bed.center.x = 1
";
    let (layout, _, exceptions) = run_on(SceneHost::new(), &format!("{BED}{text}"));
    assert_eq!(exceptions, ["ValueError: no"]);
    assert_eq!(layout.objects[0].body.center[0], 1.0);
}

#[test]
fn a_sidecar_declares_the_variables() {
    let json = r#"{"width": 8, "depth": 8, "height": 3, "objects": [
        {"id": "sum", "name": "Table", "width": 1, "depth": 1, "height": 1},
        {"id": "chairs", "name": "Chair", "width": 0.5, "depth": 0.5, "height": 1, "count": 2}]}"#;
    let template = template::parse(json).expect("a good template");
    let host = SceneHost::with_template(&template).expect("a good template");
    let text = "sum.center = scene.center\nfor i, chair in enumerate(chairs): chair.min.x = i\nfirst = chairs[0]";
    let (layout, _, exceptions) = run_on(host, text);
    assert_eq!(exceptions, [""; 0]);
    assert_eq!(paths(&layout), ["sum", "first", "chairs[1]"]);
    assert_eq!(layout.objects[2].body.min[0], 1.0);
}

#[test]
fn names_behind_which_modules_stand() {
    let text = "
print(math.pi == pi, sin(0), hypot(3, 4), floor(2.5))
print(Facing.X_MIN, Facing(1) is Facing.Y_POS, Support.WALL_MOUNTED == MOUNTED, list(Facing) == [0, 1, 2, 3])
bed.facing = Facing.X_MIN
bed.facing = opposite(bed.facing)
print(bed.facing)
";
    assert_eq!(printed(&format!("{BED}{text}")), "True 0.0 5.0 2\n2 True True True\n0\n");
}
