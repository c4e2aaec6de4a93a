//! A model for MuJoCo: one box an object, a floor, and the walls of an interior. Z up.
//!
//! All boxes belong to the world, which does not move. Bodies of their own would be tried against each other by the engine, and ten
//! thousand of them exhaust its memory.

use super::Subject;
use super::colour::Rgb;
use super::pieces::Pieces;
use super::words::{Unique, numbers, xml_comment};
use crate::markup::xml;
use crate::scene::Cardinal;
use std::fmt::Write as _;

/// Names longer than this are cut: the engine keeps them in fixed tables.
const LONGEST: usize = 200;

fn rgba(colour: Rgb) -> String {
    format!("{} 1", numbers(colour.fractions()))
}

/// Degrees about the vertical that turn the box's own +y to where the object faces.
fn degrees(turn: Cardinal) -> &'static str {
    match turn {
        Cardinal::YMax => "0",
        Cardinal::XMin => "90",
        Cardinal::YMin => "180",
        Cardinal::XMax => "-90",
    }
}

fn half(size: [f64; 3]) -> String {
    numbers(size.map(|extent| 0.5 * extent))
}

pub(super) fn mjcf(subject: &Subject, pieces: &Pieces) -> String {
    let scene = &subject.layout.scene;
    let title: String = scene.title.chars().take(LONGEST).collect();
    let mut out = String::new();
    let _ = writeln!(out, "<mujoco model=\"{}\">", if title.is_empty() { "scene".to_owned() } else { xml(&title) });
    for (object, hidden) in &pieces.hidden {
        let _ = writeln!(out, "  <!-- left out: {}: {} -->", xml_comment(&object.path), hidden.reason());
    }
    out.push_str("  <compiler angle=\"degree\" autolimits=\"true\"/>\n  <worldbody>\n    <light directional=\"true\" pos=\"0 0 10\" dir=\"0 0 -1\"/>\n");
    let mut names = Unique::default();
    for surface in &pieces.surfaces {
        let name = names.take(surface.name.to_owned());
        let (pos, size, rgba) = (numbers(surface.center), half(surface.size), rgba(surface.colour));
        let _ = writeln!(out, "    <geom name=\"{name}\" type=\"box\" pos=\"{pos}\" size=\"{size}\" rgba=\"{rgba}\"/>");
    }
    for piece in &pieces.shown {
        let body = &piece.object.body;
        let name: String = piece.object.path.chars().take(LONGEST).collect();
        let name = names.take(xml(&name));
        let (pos, turn, size, rgba) = (numbers(body.center), degrees(body.turn), half(body.dims), rgba(piece.colour));
        let _ =
            writeln!(out, "    <geom name=\"{name}\" type=\"box\" pos=\"{pos}\" euler=\"0 0 {turn}\" size=\"{size}\" rgba=\"{rgba}\"/>");
    }
    out.push_str("  </worldbody>\n</mujoco>\n");
    out
}
