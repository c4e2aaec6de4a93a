//! A robot description that is no robot: a link an object, fixed to the link `scene`. Z up, x forward as URDF has it: a link's own
//! +x is where the object faces.

use super::Subject;
use super::colour::Rgb;
use super::pieces::Pieces;
use super::words::{Unique, identifier, numbers, xml_comment};
use crate::markup::xml;
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write as _;

/// By a cardinal's number.
const YAWS: [f64; 4] = [0.0, FRAC_PI_2, PI, -FRAC_PI_2];

struct Link<'a> {
    name: String,
    comment: Option<&'a str>,
    colour: Rgb,
    center: [f64; 3],
    yaw: f64,
    size: [f64; 3],
}

pub(super) fn urdf(subject: &Subject, pieces: &Pieces) -> String {
    let mut names = Unique::reserve(["scene"]);
    let mut links = Vec::with_capacity(pieces.surfaces.len() + pieces.shown.len());
    for surface in &pieces.surfaces {
        links.push(Link {
            name: names.take(surface.name.to_owned()),
            comment: None,
            colour: surface.colour,
            center: surface.center,
            yaw: 0.0,
            size: surface.size,
        });
    }
    for piece in &pieces.shown {
        let body = &piece.object.body;
        let [width, depth, height] = body.dims;
        links.push(Link {
            name: names.take(identifier(&piece.object.path, "object")),
            comment: Some(&piece.object.path),
            colour: piece.colour,
            center: body.center,
            yaw: YAWS[body.turn.index()],
            size: [depth, width, height],
        });
    }
    let title = &subject.layout.scene.title;
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let _ = writeln!(out, "<robot name=\"{}\">", if title.is_empty() { "scene".to_owned() } else { xml(title) });
    for (object, hidden) in &pieces.hidden {
        let _ = writeln!(out, "  <!-- left out: {}: {} -->", xml_comment(&object.path), hidden.reason());
    }
    for colour in links.iter().map(|link| link.colour).collect::<BTreeSet<Rgb>>() {
        let rgb = numbers(colour.fractions());
        let _ = writeln!(out, "  <material name=\"{}\"><color rgba=\"{rgb} 1\"/></material>", colour.hex());
    }
    out.push_str("  <link name=\"scene\"/>\n");
    for link in &links {
        write_link(&mut out, link);
    }
    out.push_str("</robot>\n");
    out
}

fn write_link(out: &mut String, link: &Link) {
    if let Some(path) = link.comment.filter(|path| *path != link.name) {
        let _ = writeln!(out, "  <!-- {} -->", xml_comment(path));
    }
    let (name, colour, size) = (&link.name, link.colour.hex(), numbers(link.size));
    let (xyz, yaw) = (numbers(link.center), numbers([0.0, 0.0, link.yaw]));
    let shape = format!("<geometry><box size=\"{size}\"/></geometry>");
    let _ = writeln!(
        out,
        "  <link name=\"{name}\">\n    <visual>{shape}<material name=\"{colour}\"/></visual>\n    <collision>{shape}</collision>\n  </link>"
    );
    let _ = writeln!(
        out,
        "  <joint name=\"{name}_joint\" type=\"fixed\"><parent link=\"scene\"/><child link=\"{name}\"/><origin xyz=\"{xyz}\" rpy=\"{yaw}\"/></joint>"
    );
}
