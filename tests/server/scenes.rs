//! psdl's own requests about the scene of a program.

use super::actions::{applied, resolving};
use super::client::{Client, uri};
use psdl::analysis::{Input, Options, analyse};
use serde_json::{Value, json};

const DESK: &str = "\
desk = Object('Desk', 1.6, 0.7, 0.8)
lamp = Object('Lamp', 0.2, 0.2, 0.4)
gap = 0.25
desk.center.x = scene.min.x + 1.5
desk.max.y = scene.max.y - gap
desk.facing = Y_MIN
lamp.center.x = desk.center.x + 0.5
lamp.center.y = desk.center.y
lamp.min.z = desk.max.z
";

fn opened(text: &str) -> Client {
    let mut client = Client::start(resolving());
    client.open("untitled:1", 5, text);
    client
}

fn about(more: Value) -> Value {
    let mut params = json!({"textDocument": {"uri": "untitled:1"}});
    params.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    params
}

fn ask(client: &mut Client, method: &str, more: Value) -> Value {
    let answer = client.request(method, about(more));
    assert!(answer["error"].is_null(), "{answer}");
    answer["result"].clone()
}

/// The center of an object and its facing, of a run of a text.
fn place(text: &str, object: usize) -> (Vec<f64>, &'static str) {
    let layout = analyse(&Input { text, template: None }, &Options::default(), None).layout.unwrap();
    let body = &layout.objects[object].body;
    (body.center.to_vec(), body.turn.short_name())
}

#[test]
fn the_layout_comes_with_its_places() {
    let mut client = opened(DESK);
    let found = ask(&mut client, "psdl/layout", json!({}));
    assert_eq!((&found["version"], &found["stale"], &found["partial"]), (&json!(5), &json!(false), &json!(false)));
    assert_eq!(found["layout"]["objects"][1]["path"], "lamp");
    assert_eq!(found["ranges"][0]["declaration"]["start"], json!({"line": 0, "character": 0}));
    assert_eq!(found["ranges"][0]["placements"].as_array().unwrap().len(), 3);
    client.change("untitled:1", 6, json!([{"text": format!("{DESK}x = (\n")}]));
    let found = ask(&mut client, "psdl/layout", json!({}));
    assert_eq!((&found["version"], &found["stale"]), (&json!(6), &json!(true)));
    assert_eq!(found["layout"]["objects"].as_array().unwrap().len(), 2);
    client.finish();
}

#[test]
fn a_file_that_is_not_open_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("desk.psdl");
    std::fs::write(&path, DESK).unwrap();
    let mut client = Client::start(resolving());
    let params = json!({"textDocument": {"uri": uri(&path)}});
    let found = client.request("psdl/layout", params.clone())["result"].clone();
    assert_eq!((&found["version"], &found["layout"]["objects"][0]["path"]), (&Value::Null, &json!("desk")));
    assert_eq!(client.request("psdl/fix", params)["result"]["before"]["errors"], json!(0));
    client.finish();
}

#[test]
fn constants_say_what_they_move_and_where_no_errors_are() {
    let mut client = opened(DESK);
    let found = ask(&mut client, "psdl/constants", json!({}));
    let constants = found["constants"].as_array().unwrap();
    let texts: Vec<&str> = constants.iter().map(|constant| constant["text"].as_str().unwrap()).collect();
    assert_eq!(texts, ["0.25", "1.5", "0.5"]);
    let gap = &constants[0];
    assert_eq!((&gap["name"], &gap["errors"]), (&json!("gap"), &json!(0)));
    let moved: Vec<&str> = gap["moves"].as_array().unwrap().iter().map(|moved| moved["path"].as_str().unwrap()).collect();
    assert_eq!((moved, &gap["moves"][0]["by"]), (vec!["desk", "lamp"], &json!(1.0)));
    // The desk may go from wall to wall: 6 metres less its own 0.7, and what is less than 0.01 is none.
    let (low, high) = (gap["good"][0][0].as_f64().unwrap(), gap["good"][0][1].as_f64().unwrap());
    assert!((low + 0.004).abs() < 0.005 && (high - 5.304).abs() < 0.005, "{gap}");
    client.finish();
}

#[test]
fn an_object_is_moved_by_the_edits_that_are_offered() {
    let mut client = opened(DESK);
    let found = ask(&mut client, "psdl/move", json!({"object": "lamp", "to": [-1.2, null, null]}));
    let best = &found["choices"][0];
    assert_eq!((&best["title"], &best["exact"], &best["errors"]), (&json!("Change 0.5 on line 7 → 0.3"), &json!(true), &json!(0)));
    assert!((place(&applied(DESK, 5, &best["edit"]), 1).0[0] + 1.2).abs() < 1e-3);
    // Nothing but the desk decides about y: the statement gets an offset.
    let found = ask(&mut client, "psdl/move", json!({"object": 1, "to": [null, 2.5, null]}));
    let best = &found["choices"][0];
    assert!((place(&applied(DESK, 5, &best["edit"]), 1).0[1] - 2.5).abs() < 1e-3, "{found}");
    let wrong = client.request("psdl/move", about(json!({"object": "table", "to": [0, 0, 0]})));
    assert_eq!(wrong["error"]["code"], json!(-32803));
    client.finish();
}

#[test]
fn an_object_is_turned_by_its_direction_or_a_new_statement() {
    let mut client = opened(DESK);
    let found = ask(&mut client, "psdl/turn", json!({"object": "desk", "facing": "X+"}));
    let best = &found["choices"][0];
    assert_eq!((&best["reached"], &best["edits"][0]["newText"]), (&json!("X+"), &json!("X_MAX")));
    assert_eq!(place(&applied(DESK, 5, &best["edit"]), 0).1, "X+");
    let found = ask(&mut client, "psdl/turn", json!({"object": "lamp", "facing": "X-"}));
    assert_eq!(found["choices"][0]["title"], "Add lamp.facing = X_MIN");
    assert_eq!(place(&applied(DESK, 5, &found["choices"][0]["edit"]), 1).1, "X-");
    assert_eq!(client.request("psdl/turn", about(json!({"object": "desk", "facing": "up"})))["error"]["code"], json!(-32602));
    client.finish();
}

#[test]
fn a_picture_is_drawn() {
    let mut client = opened(DESK);
    let found = ask(&mut client, "psdl/render", json!({"format": "svg", "view": "top", "width": 400, "height": 300}));
    let svg = found["data"].as_str().unwrap();
    assert!(found["mime"] == "image/svg+xml" && svg.contains("data-object=\"1\""));
    assert_eq!((&found["objects"][1]["path"], &found["objects"][1]["range"]["start"]["line"]), (&json!("lamp"), &json!(8)));
    let found = ask(&mut client, "psdl/render", json!({"format": "png", "width": 64, "height": 64, "highlight": "desk"}));
    assert!(found["data"].as_str().unwrap().starts_with("iVBORw0KGgo"));
    client.finish();
}
