//! Universal Scene Description as text: metres, Z up, one `Cube` of 1 m a object, scaled to its size and turned to its facing.

use super::Subject;
use super::colour::Rgb;
use super::pieces::{Piece, Pieces, Surface};
use super::words::{Unique, identifier, number};
use crate::scene::Cardinal;
use std::fmt::Write as _;

/// A string of USD. What its C strings cannot hold becomes U+FFFD.
fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            '\0' => out.push('\u{fffd}'),
            '\x01'..='\x1f' | '\x7f' => {
                let _ = write!(out, "\\x{:02x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

fn vector(values: [f64; 3]) -> String {
    format!("({})", values.map(number).join(", "))
}

fn colour(rgb: Rgb) -> String {
    vector(rgb.linear())
}

/// Degrees about the vertical that turn +y to where an object faces.
fn degrees(turn: Cardinal) -> f64 {
    match turn {
        Cardinal::YMax => 0.0,
        Cardinal::XMin => 90.0,
        Cardinal::YMin => 180.0,
        Cardinal::XMax => 270.0,
    }
}

pub(super) fn usda(subject: &Subject, pieces: &Pieces) -> String {
    let scene = &subject.layout.scene;
    let mut out = String::from("#usda 1.0\n(\n    defaultPrim = \"Scene\"\n    metersPerUnit = 1\n    upAxis = \"Z\"\n");
    let _ = writeln!(out, "    customLayerData = {{\n        string creator = \"psdl\"");
    let _ = writeln!(out, "        string title = {}", quoted(&scene.title));
    if !pieces.hidden.is_empty() {
        let names: Vec<String> = pieces.hidden.iter().map(|(object, _)| quoted(&object.path)).collect();
        let _ = writeln!(out, "        string[] leftOut = [{}]", names.join(", "));
    }
    out.push_str("    }\n)\n\ndef Xform \"Scene\" (\n    kind = \"assembly\"\n)\n{\n");
    let mut names = Unique::default();
    for surface in &pieces.surfaces {
        surface_prim(&mut out, surface, &names.take(surface.name.to_owned()));
    }
    for piece in &pieces.shown {
        let name = names.take(identifier(&piece.object.path, "object"));
        object_prim(&mut out, subject, piece, &name);
    }
    out.push_str("}\n");
    out
}

fn object_prim(out: &mut String, subject: &Subject, piece: &Piece, name: &str) {
    let (object, body) = (piece.object, &piece.object.body);
    let _ = write!(
        out,
        "    def Cube \"{name}\" (\n        displayName = {}\n        customData = {{\n            string category = {}\n            string path = {}\n            string support = \"{}\"\n            string type = \"{}\"\n            string facing = \"{}\"\n            bool dynamic = {}\n",
        quoted(&object.path),
        quoted(&object.name),
        quoted(&object.path),
        body.support.name(),
        body.kind.name(),
        body.turn.name(),
        object.dynamic,
    );
    if let Some(line) = subject.line_of_object(object) {
        let _ = writeln!(out, "            int line = {line}");
    }
    let _ = write!(
        out,
        "        }}\n    )\n    {{\n        double size = 1\n        float3[] extent = [(-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)]\n        color3f[] primvars:displayColor = [{}]\n        double3 xformOp:translate = {}\n        double xformOp:rotateZ = {}\n        double3 xformOp:scale = {}\n        uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateZ\", \"xformOp:scale\"]\n    }}\n",
        colour(piece.colour),
        vector(body.center),
        number(degrees(body.turn)),
        vector(body.dims),
    );
}

/// A surface shows its inner side only, so that one looks into the room through the near walls.
fn surface_prim(out: &mut String, surface: &Surface, name: &str) {
    let points = surface.corners.map(vector).join(", ");
    let bound = |pick: fn(f64, f64) -> f64| {
        let corners = surface.corners.into_iter().reduce(|a, b| [0, 1, 2].map(|k| pick(a[k], b[k])));
        vector(corners.unwrap_or_default())
    };
    let _ = write!(
        out,
        "    def Mesh \"{name}\"\n    {{\n        uniform bool doubleSided = 0\n        float3[] extent = [{}, {}]\n        int[] faceVertexCounts = [4]\n        int[] faceVertexIndices = [0, 1, 2, 3]\n        point3f[] points = [{points}]\n        uniform token subdivisionScheme = \"none\"\n        color3f[] primvars:displayColor = [{}]\n    }}\n",
        bound(f64::min),
        bound(f64::max),
        colour(surface.colour),
    );
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_string_cannot_end_early() {
        assert_eq!(super::quoted("a\"b\\c\n\0\u{1}é"), "\"a\\\"b\\\\c\\n\u{fffd}\\x01é\"");
    }
}
