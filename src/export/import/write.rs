//! The text of a flat program.

use super::flat::{Facing, Flat, Item};
use super::naming::{Names, Shape, name};
use crate::python::text::unicode::is_printable;
use crate::scene::{Kind, Scalar, Surface, Target};
use std::fmt::Write as _;

/// Lines of a list are put one below the other from this length on.
const LONGEST: usize = 140;

/// A string of Python. What cannot be seen, or turns the direction of what follows, is written as an escape.
fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if is_printable(c) => out.push(c),
            c if u32::from(c) < 0x100 => drop(write!(out, "\\x{:02x}", u32::from(c))),
            c if u32::from(c) < 0x10000 => drop(write!(out, "\\u{:04x}", u32::from(c))),
            c => drop(write!(out, "\\U{:08x}", u32::from(c))),
        }
    }
    out.push('"');
    out
}

/// Text for a comment: one line, nothing that hides.
fn comment(text: &str) -> String {
    text.chars().map(|c| if is_printable(c) { c } else { '\u{fffd}' }).collect()
}

fn color(color: Option<&str>) -> String {
    color.map_or(String::new(), |color| format!(", color={}", quoted(color)))
}

pub(super) fn program(scene: &Flat) -> String {
    let names = name(&scene.items);
    let mut out = String::new();
    for remark in &scene.remarks {
        let _ = writeln!(out, "# {}", comment(remark));
    }
    if !scene.title.is_empty() {
        let _ = writeln!(out, "set_title({})", quoted(&scene.title));
    }
    let [width, depth, height] = scene.dims.map(Scalar::shown);
    let _ = writeln!(out, "set_size(width={width}, depth={depth}, height={height})");
    if let Some(Surface { asset, color: rgb }) = &scene.floor {
        let _ = writeln!(out, "set_floor_asset({}{})", quoted(asset), color(rgb.as_deref()));
    }
    let wall = scene.wall.clone().or_else(|| (!scene.interior).then(|| Surface { asset: "None".into(), color: None }));
    if let Some(Surface { asset, color: rgb }) = wall {
        let interior = if scene.interior { "True" } else { "False" };
        let _ = writeln!(out, "set_wall_asset({}, interior={interior}{})", quoted(&asset), color(rgb.as_deref()));
    }
    if !names.variables.is_empty() {
        out.push('\n');
    }
    for (variable, shape) in &names.variables {
        let line = format!("{variable} = {}", value(scene, shape));
        let _ = writeln!(out, "{line}");
    }
    for (index, item) in scene.items.iter().enumerate() {
        out.push('\n');
        placement(&mut out, &names, index, item);
    }
    out
}

fn constructor(item: &Item) -> String {
    let [width, depth, height] = item.dims.map(Scalar::shown);
    let (call, support) = match item.kind {
        Kind::Object => ("Object", format!(", support={}", item.support.name())),
        Kind::Door => ("Door", String::new()),
        Kind::Window => ("Window", String::new()),
    };
    let (name, color) = (quoted(&item.declared_name()), color(item.color.as_deref()));
    format!("{call}({name}, width={width}, depth={depth}, height={height}{support}{color})")
}

/// What a variable is bound to.
fn value(scene: &Flat, shape: &Shape) -> String {
    match shape {
        Shape::One(index) => constructor(&scene.items[*index]),
        Shape::List(parts) => {
            let parts: Vec<String> = parts.iter().map(|part| value(scene, part)).collect();
            match parts.split_first() {
                Some((first, rest)) if !rest.is_empty() && rest.iter().all(|part| part == first) => {
                    format!("[{first} for _ in range({})]", parts.len())
                }
                _ => container('[', &parts, ']'),
            }
        }
        Shape::Dict(parts) => {
            let parts: Vec<String> = parts.iter().map(|(key, part)| format!("{key}: {}", value(scene, part))).collect();
            container('{', &parts, '}')
        }
    }
}

fn container(open: char, parts: &[String], close: char) -> String {
    let line = parts.join(", ");
    if line.len() <= LONGEST && !line.contains('\n') {
        return format!("{open}{line}{close}");
    }
    let lines: String = parts.iter().map(|part| format!("    {},\n", part.replace('\n', "\n    "))).collect();
    format!("{open}\n{lines}{close}")
}

fn placement(out: &mut String, names: &Names, index: usize, item: &Item) {
    let path = &names.paths[index];
    for (axis, anchor, value) in &item.anchors {
        let _ = writeln!(out, "{path}.{}.{} = {}", anchor.name(), axis.name(), value.shown());
    }
    let facing = match item.facing {
        Facing::Free => None,
        Facing::Direction => Some(item.turn.name()),
        Facing::Toward(Target::Scene) => Some("scene"),
        Facing::Toward(Target::Object(id)) => names.paths.get(id.index()).map(String::as_str),
    };
    if let Some(facing) = facing {
        let remark = item.remark.as_ref().map_or(String::new(), |remark| format!("  # {}", comment(remark)));
        let _ = writeln!(out, "{path}.facing = {facing}{remark}");
    } else if item.anchors.is_empty() {
        let _ = writeln!(out, "# {path} is nowhere");
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_name_cannot_leave_its_string() {
        assert_eq!(super::quoted("a\"\\\n\u{202e}\u{1}床🪑"), "\"a\\\"\\\\\\n\\u202e\\x01床🪑\"");
    }
}
