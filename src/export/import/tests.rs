//! What each format becomes.

use super::*;
use Source::{Holodeck, LayoutGpt, Visualizer};

fn read(text: &str) -> String {
    let source = detect(text).expect("a known format");
    import(text, source).unwrap_or_else(|errors| panic!("{errors:?}"))
}

/// Each mistake as the text that it stands at, and the message.
fn mistakes(text: &str, source: Source) -> Vec<(&str, String)> {
    let errors = import(text, source).expect_err("mistakes");
    errors.into_iter().map(|error| (&text[error.range], error.message)).collect()
}

#[test]
fn a_layout_becomes_a_program_with_its_anchors() {
    let text = r#"{"scene": {"title": "Room", "width": 5, "depth": 6.0, "height": 2.8, "interior": false},
"objects": [
{"path": "bed", "name": "Double Bed", "type": "OBJECT", "support": "STANDING", "width": 1.6, "depth": 2, "height": 0.6, "facing": "Y-", "facing_set": true, "facing_target": null, "anchors": [["max", "y", 3.0], ["center", "x", 0.1]], "color": "4169E1"},
{"path": "stands[0]", "name": "Stand", "type": "OBJECT", "support": "STANDING", "width": 0.5, "depth": 0.4, "height": 0.6, "facing": "Y-", "facing_set": true, "facing_target": 0, "anchors": [["center", "x", 0.2], ["max", "y", 5.5]]},
{"path": "stands[1]", "name": "Stand", "type": "OBJECT", "support": "STANDING", "width": 0.5, "depth": 0.4, "height": 0.6, "facing": "X+", "facing_set": true, "facing_target": 0, "anchors": [["center", "x", 0.1], ["max", "y", 5.5]], "color": null}],
"violations": []}"#;
    let program = r#"set_title("Room")
set_size(width=5, depth=6.0, height=2.8)
set_wall_asset("None", interior=False)

bed = Object("Double Bed", width=1.6, depth=2, height=0.6, support=STANDING, color="4169E1")
stands = [Object("Stand", width=0.5, depth=0.4, height=0.6, support=STANDING) for _ in range(2)]

bed.max.y = 3.0
bed.center.x = 0.1
bed.facing = Y_MIN

stands[0].center.x = 0.2
stands[0].max.y = 5.5
stands[0].facing = bed

stands[1].center.x = 0.1
stands[1].max.y = 5.5
stands[1].facing = X_MAX  # was told to face bed
"#;
    assert_eq!(read(text), program);
}

#[test]
fn a_scene_of_the_visualizer_is_turned_upright() {
    let text = r#"{"name": "", "size": [4, 3, 6], "objects": [
{"name": "Desk", "type": "OBJECT", "position": [1.5, 0.375, 2.25], "size": [0.75, 0.75, 1.5], "facing": "WEST"},
{"name": "Lamp", "type": "OBJECT", "position": [0, 2.5, -2.9], "size": [0.4, 0.4, 0.2], "facing": "SOUTH"},
{"name": "Oak", "type": "FLOOR", "position": [0, -0.05, 0], "size": [4, 0.1, 6], "facing": "NORTH", "color": "AA8866"},
{"name": "Wall", "type": "WALL", "position": [0, 1.5, -3.05], "size": [4, 3, 0.1], "facing": "SOUTH"}],
"relations": [], "number_of_constants": 3, "fill_percentage": 1.5}"#;
    let program = r#"set_size(width=4.0, depth=6.0, height=3.0)
set_floor_asset("Oak", color="AA8866")

desk = Object("Desk", width=1.5, depth=0.75, height=0.75, support=STANDING)
lamp = Object("Lamp", width=0.4, depth=0.2, height=0.4, support=MOUNTED)

desk.center.x = 1.5
desk.min.y = -3.0
desk.min.z = 0.0
desk.facing = X_MIN

lamp.center.x = 0.0
lamp.center.y = 2.9
lamp.min.z = 2.3
lamp.facing = Y_MIN
"#;
    assert_eq!(detect(text), Some(Visualizer));
    assert_eq!(read(text), program);
}

#[test]
fn lines_of_boxes_become_objects_in_a_room() {
    let text = "Room Size: max length 4m, max width 5m\nLayout:\n\
        bed {length: 1.6m; width: 2.0m; height: 0.5m; left: 2m; top: 1m; depth: 0.25m; orientation: 0 degrees;}\n\
        desk {length: 120px; width: 60px; height: 75px; left: 370px; top: 300px; depth: 37.5px; orientation: 270 degrees;}\n";
    let program = r#"# The file does not give the height of the room: 3.0 m were taken.
# The file counts pixels: one is taken for a centimetre.
set_size(width=4.0, depth=5.0, height=3.0)

bed = Object("bed", width=1.6, depth=2.0, height=0.5, support=STANDING)
desk = Object("desk", width=1.2, depth=0.6, height=0.75, support=STANDING)

bed.center.x = 0.0
bed.center.y = 1.5
bed.min.z = 0.0
bed.facing = Y_MIN

desk.center.x = 1.7
desk.center.y = -0.5
desk.min.z = 0.0
desk.facing = X_MIN
"#;
    assert_eq!(detect(text), Some(LayoutGpt));
    assert_eq!(read(text), program);
}

#[test]
fn a_line_without_a_size_is_told() {
    let text = "bed {length: 2m; width: 1m; left: 1m; top: 1m; depth: 1m}\n";
    assert_eq!(mistakes(text, LayoutGpt), [("bed ", "height is missing".to_owned())]);
    let text = "bed {length: 2 ells; width: -1m; height: 1m; left: 1m; top: 1m; depth: 1m}\nsofa {";
    let told: Vec<&str> = mistakes(text, LayoutGpt).into_iter().map(|(at, _)| at).collect();
    assert_eq!(told, ["length: 2 ells", "width: -1m", "{"]);
}

const HOLODECK: &str = r#"{"query": "a bedroom", "wall_height": 2.7,
"rooms": [{"id": "bedroom", "floorPolygon": [{"x": 0, "y": 0, "z": 0}, {"x": 4, "y": 0, "z": 0}, {"x": 4, "y": 0, "z": 6}, {"x": 0, "y": 0, "z": 6}], "floorMaterial": {"name": "Oak"}}],
"objects": [
{"assetId": "a1", "id": "bed-0 (bedroom)", "object_name": "bed-0", "position": {"x": 2, "y": 0.3, "z": 5}, "rotation": {"x": 0, "y": 180, "z": 0}, "size": {"x": 1.6, "y": 0.6, "z": 2}},
{"assetId": "a2", "id": "desk-0 (bedroom)", "object_name": "desk-0", "position": {"x": 3.7, "y": 0.375, "z": 1}, "rotation": {"x": 0, "y": 270, "z": 0}, "vertices": [[340, 40], [340, 160], [400, 160], [400, 40]]}],
"floor_objects": [{"id": "desk-0 (bedroom)"}],
"doors": [{"assetId": "d", "id": "door|0|1", "doorSegment": [[1, 0], [2, 0]], "holePolygon": [{"x": 1, "y": 0, "z": 0}, {"x": 2, "y": 2.1, "z": 0}]}],
"windows": [], "walls": []}"#;

#[test]
fn a_scene_of_holodeck_is_moved_to_the_middle() {
    let program = r#"set_title("a bedroom")
set_size(width=4.0, depth=6.0, height=2.7)
set_floor_asset("Oak")

bed = Object("bed", width=1.6, depth=2.0, height=0.6, support=STANDING)
desk = Object("desk", width=1.2, depth=0.6, height=0.75, support=STANDING)
door = Door("Door", width=1.0, depth=0.1, height=2.1)

bed.center.x = 0.0
bed.center.y = 2.0
bed.min.z = 0.0
bed.facing = Y_MIN

desk.center.x = 1.7
desk.center.y = -2.0
desk.min.z = 0.0
desk.facing = X_MIN

door.center.x = -0.5
door.center.y = -3.0
door.min.z = 0.0
door.facing = Y_MAX
"#;
    assert_eq!(detect(HOLODECK), Some(Holodeck));
    assert_eq!(read(HOLODECK), program);
}

#[test]
fn an_object_without_a_size_is_refused_at_its_place() {
    let text = HOLODECK.replace(r#", "size": {"x": 1.6, "y": 0.6, "z": 2}"#, "").replace(r#"[{"id": "desk-0 (bedroom)"}]"#, "[]");
    let told = mistakes(&text, Holodeck);
    assert_eq!(told.len(), 2);
    assert!(told.iter().all(|(at, message)| *at == "{" && message.starts_with("the size of the object is missing")), "{told:?}");
}

#[test]
fn every_mistake_of_a_layout_is_told() {
    let text = r#"{"scene": {"width": 0, "depth": 6, "height": 3}, "objects": [{"name": 7, "support": "LEANING", "width": 1, "depth": 1, "facing": "up", "anchors": [["min", "x", 1e999]]}, []]}"#;
    let told: Vec<&str> = mistakes(text, super::Source::Layout).into_iter().map(|(at, _)| at).collect();
    assert_eq!(told, ["[]"]);
    let text = text.replace(", []", "");
    let told: Vec<&str> = mistakes(&text, super::Source::Layout).into_iter().map(|(at, _)| at).collect();
    assert_eq!(told, ["0", "7", r#""LEANING""#, "{", r#""up""#]);
}

#[test]
fn what_is_none_of_the_formats_is_not_guessed() {
    assert_eq!(["", "bed 2 m", "[]", "{}", "{\"a\": 1}"].map(detect), [None; 5]);
    assert!(mistakes(&"[".repeat(100_000), Visualizer)[0].1.starts_with("this is no JSON"));
}

proptest::proptest! {
    #[test]
    fn no_text_breaks_a_reader(text in "[\\[\\]{}:,;\"'a-z0-9.eE+ \\n\\\\/é🪑\u{feff}-]{0,80}", damage in 0..400_usize, piece in "\\PC{0,3}") {
        let cut = (0..=damage.min(HOLODECK.len())).rev().find(|cut| HOLODECK.is_char_boundary(*cut)).unwrap_or(0);
        let damaged = format!("{}{piece}{}", &HOLODECK[..cut], HOLODECK.get(cut + 1..).unwrap_or(""));
        for text in [text, damaged] {
            for (source, ..) in Source::ALL {
                for error in import(&text, source).err().into_iter().flatten() {
                    proptest::prop_assert!(text.get(error.range).is_some());
                }
            }
        }
    }
}
