//! Each format by a reader of its own.

use super::{Scene, all, hard};
use psdl::export::Format;
use psdl::scene::Placed;
use serde_json::Value;

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    (0..3).all(|k| (a[k] - b[k]).abs() <= 1e-5 * a[k].abs().max(b[k].abs()).max(1.0))
}

/// The box in Y-up coordinates: (x, z, −y).
fn y_up(object: &Placed) -> [[f64; 3]; 2] {
    let (min, max) = (object.body.min, object.body.max);
    [[min[0], min[2], -max[1]], [max[0], max[2], -min[1]]]
}

fn assert_glb(name: &str, scene: &Scene) {
    let bytes = scene.export(Format::Glb).bytes;
    let file = gltf::Gltf::from_slice(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
    let extras = |node: &gltf::Node| node.extras().as_ref().and_then(|raw| serde_json::from_str::<Value>(raw.get()).ok());
    let nodes: Vec<(gltf::Node, Value)> = file.nodes().filter_map(|node| extras(&node).map(|extras| (node, extras))).collect();
    let drawn = scene.drawn();
    assert_eq!(nodes.len(), drawn.len(), "{name}");
    let blob = file.blob.as_deref();
    for ((node, extras), object) in nodes.iter().zip(drawn) {
        assert_eq!((node.name(), extras["category"].as_str()), (Some(object.path.as_str()), Some(object.name.as_str())), "{name}");
        assert_eq!((extras["path"].as_str(), extras["support"].as_str()), (node.name(), Some(object.body.support.name())), "{name}");
        let matrix = node.transform().matrix();
        let primitive = node.mesh().expect("a mesh").primitives().next().expect("a primitive");
        let reader = primitive.reader(|_| blob);
        let corners = reader
            .read_positions()
            .expect("positions")
            .map(|point| [0, 1, 2].map(|k| f64::from((0..3).map(|c| matrix[c][k] * point[c]).sum::<f32>() + matrix[3][k])));
        let corners: Vec<[f64; 3]> = corners.collect();
        let bound =
            |pick: fn(f64, f64) -> f64| corners.iter().copied().reduce(|a, b| [0, 1, 2].map(|k| pick(a[k], b[k]))).expect("corners");
        let [min, max] = y_up(object);
        assert!(near(bound(f64::min), min) && near(bound(f64::max), max), "{name}: {}", object.path);
        let material = primitive.material();
        let given = object.color.as_ref().map(|color| color.to_uppercase());
        assert!(given.is_none() || given.as_deref() == material.name(), "{name}: {}", object.path);
    }
}

fn assert_obj(name: &str, scene: &Scene) {
    let exported = scene.export(Format::Obj);
    let library = exported.companion.expect("materials");
    let options = tobj::LoadOptions { single_index: false, triangulate: false, ..tobj::LoadOptions::default() };
    let (models, materials) = tobj::load_obj_buf(&mut exported.bytes.as_slice(), &options, |path| {
        assert_eq!(path.to_str(), Some(library.name.as_str()));
        tobj::load_mtl_buf(&mut library.bytes.as_slice())
    })
    .unwrap_or_else(|error| panic!("{name}: {error}"));
    let materials = materials.unwrap_or_else(|error| panic!("{name}: {error}"));
    let drawn = scene.drawn();
    assert!(models.len() >= drawn.len(), "{name}");
    for (model, object) in models.iter().zip(drawn) {
        assert_eq!(model.mesh.face_arities, [4; 6], "{name}: {}", object.path);
        let points: Vec<[f64; 3]> = model.mesh.positions.chunks(3).map(|point| [0, 1, 2].map(|k| f64::from(point[k]))).collect();
        let bound = |pick: fn(f64, f64) -> f64| points.iter().copied().reduce(|a, b| [0, 1, 2].map(|k| pick(a[k], b[k]))).expect("points");
        let [min, max] = y_up(object);
        assert!(near(bound(f64::min), min) && near(bound(f64::max), max), "{name}: {}", object.path);
        let material = &materials[model.mesh.material_id.expect("a material")];
        assert!(object.color.as_ref().is_none_or(|color| color.to_uppercase() == material.name), "{name}: {}", object.path);
    }
}

fn assert_csv(name: &str, scene: &Scene) {
    let text = scene.text_of(Format::Csv);
    let mut table = csv::Reader::from_reader(text.as_bytes());
    let columns = table.headers().expect("a head").clone();
    let rows: Vec<csv::StringRecord> = table.records().map(|row| row.expect("a row")).collect();
    let objects = &scene.layout().objects;
    assert_eq!(rows.len(), objects.len(), "{name}");
    for (row, object) in rows.iter().zip(objects) {
        let cell = |column: &str| columns.iter().position(|known| known == column).and_then(|at| row.get(at)).expect("a cell");
        assert_eq!((cell("path"), cell("category").trim_start_matches('\'')), (object.path.as_str(), object.name.trim_start_matches('\'')));
        assert_eq!(cell("center_x").parse(), Ok(object.body.center[0]), "{name}");
        assert_eq!(cell("max_z").parse(), Ok(object.body.max[2]), "{name}");
        assert_eq!(cell("placed"), object.body.is_placed().to_string());
    }
}

fn assert_xml(name: &str, scene: &Scene) {
    let drawn = scene.drawn();
    for (format, element, more) in [(Format::Mjcf, "geom", 0), (Format::Urdf, "link", 1)] {
        let text = scene.text_of(format);
        let document = roxmltree::Document::parse(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let found: Vec<roxmltree::Node> = document.descendants().filter(|node| node.has_tag_name(element)).collect();
        let surfaces = ["floor", "right_wall", "top_wall", "left_wall", "bottom_wall"];
        let is_surface = |node: &roxmltree::Node| surfaces.contains(&node.attribute("name").unwrap_or_default());
        let own = found.iter().filter(|node| !is_surface(node)).count();
        assert_eq!(own, drawn.len() + more, "{name}");
        let mut names: Vec<&str> = found.iter().filter_map(|node| node.attribute("name")).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), found.len(), "{name}: every name stands once");
    }
}

fn assert_visualizer(name: &str, scene: &Scene) {
    let root: Value = serde_json::from_str(&scene.text_of(Format::Visualizer)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let keys: Vec<&String> = root.as_object().expect("an object").keys().collect();
    let mut wanted = ["name", "size", "objects", "relations", "number_of_constants", "fill_percentage"];
    wanted.sort_unstable();
    assert_eq!(keys, wanted, "{name}");
    let placed =
        scene.layout().objects.iter().filter(|object| object.body.is_placed() && object.body.max.iter().all(|value| value.is_finite()));
    let objects = root["objects"].as_array().expect("a list");
    for (found, object) in objects.iter().zip(placed) {
        let ([x, y, z], [sx, sy, sz]) = (object.body.center, object.body.size());
        assert_eq!(found["position"], serde_json::json!([x + 0.0, z + 0.0, -y + 0.0]), "{name}: {}", object.path);
        assert_eq!(found["size"], serde_json::json!([sx, sz, sy]), "{name}: {}", object.path);
        assert_eq!(found["facing"], ["EAST", "NORTH", "WEST", "SOUTH"][object.body.turn.index()]);
        assert_eq!((found["name"].as_str(), found["type"].as_str()), (Some(object.name.as_str()), Some(object.body.kind.name())));
    }
    let types: Vec<&str> = objects.iter().filter_map(|object| object["type"].as_str()).collect();
    let floor = types.iter().position(|kind| *kind == "FLOOR").expect("a floor");
    let walls = if scene.layout().scene.interior { 4 } else { 0 };
    assert_eq!(types[floor + 1..], vec!["WALL"; walls], "{name}");
    for relation in root["relations"].as_array().expect("a list") {
        assert_eq!(relation["arity"].as_str().map(str::len), relation["args"].as_array().map(Vec::len), "{name}");
    }
}

fn assert_html(name: &str, scene: &Scene) {
    let page = scene.text_of(Format::Html);
    let (_, rest) = page.split_once(r#"<script type="application/json" id="data">"#).expect("data");
    let (data, rest) = rest.split_once("</script>").expect("an end");
    assert_eq!(rest.matches("<script").count(), 1, "{name}");
    let data: Value = serde_json::from_str(data).unwrap_or_else(|error| panic!("{name}: {error}"));
    let names: Vec<&str> = data["objects"].as_array().expect("objects").iter().filter_map(|object| object["name"].as_str()).collect();
    assert_eq!(names, scene.drawn().iter().map(|object| object.name.as_str()).collect::<Vec<_>>(), "{name}");
    assert_eq!(data["title"].as_str(), Some(scene.layout().scene.title.as_str()));
}

#[test]
fn every_scene_is_read_back_from_every_format() {
    for path in all() {
        let (name, scene) = (path.display().to_string(), Scene::load(&path));
        assert_glb(&name, &scene);
        assert_obj(&name, &scene);
        assert_csv(&name, &scene);
        assert_xml(&name, &scene);
        assert_visualizer(&name, &scene);
        assert_html(&name, &scene);
        let usda = scene.text_of(Format::Usda);
        assert_eq!(usda.matches("\n    def Cube \"").count(), scene.drawn().len(), "{name}");
    }
}

#[test]
fn what_cannot_be_drawn_is_listed() {
    let scene = hard("unplaced");
    assert_eq!(scene.drawn().len(), 1);
    let listed = |format, text: &str| assert!(scene.text_of(format).contains(text), "{format:?}");
    listed(Format::Obj, "# left out: a: it was never placed");
    listed(Format::Usda, "string[] leftOut = [\"a\"]");
    listed(Format::Mjcf, "<!-- left out: a: it was never placed -->");
    listed(Format::Urdf, "<!-- left out: a: it was never placed -->");
    listed(Format::Html, r#""leftOut":[{"path":"a","reason":"it was never placed"}]"#);
    assert!(String::from_utf8_lossy(&scene.export(Format::Glb).bytes).contains(r#""leftOut":["a"]"#));
    let extreme = hard("extreme");
    assert_eq!(extreme.drawn().iter().map(|object| object.path.as_str()).collect::<Vec<_>>(), ["d"]);
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    for (format, ..) in Format::ALL {
        assert_eq!(hard("hostile").export(format), hard("hostile").export(format), "{format:?}");
    }
}
