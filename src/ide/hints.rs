//! Hints between the words: where a placement put things, what a loop made, what an argument is for.

use super::docs;
use super::find::{callee, for_each_node, functions, targets};
use super::names::parameters;
use super::program::{Deed, Mark, Scene, View};
use super::words;
use crate::scene::{Anchor, Axis};
use crate::syntax::ast::{AnyNodeRef, Expr, ExprCall, Ranged as _};
use ruff_text_size::{TextRange, TextSize};

/// Of many values so many are shown.
const MAX_VALUES: usize = 3;

/// Which hints are wanted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Wanted {
    /// Where placements put things.
    pub coordinates: bool,
    /// Where things look.
    pub facings: bool,
    /// The names of parameters.
    pub parameters: bool,
    /// What loops placed, and how many errors that has.
    pub loops: bool,
}

/// What a hint tells.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum HintKind {
    /// What came of a statement.
    Result,
    /// What an argument is for.
    Parameter,
}

/// A hint.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Hint {
    /// Where it stands.
    pub at: TextSize,
    /// What it says.
    pub label: String,
    /// More, for a tooltip.
    pub tooltip: String,
    /// What it tells.
    pub kind: HintKind,
}

/// The hints of a part of the program, by place.
pub fn hints(view: &View, range: TextRange, wanted: Wanted) -> Vec<Hint> {
    let mut hints = Vec::new();
    let marks = view.marks();
    let functions = if wanted.parameters { functions(view) } else { Vec::new() };
    for_each_node(view, &mut |node| {
        if node.range().intersect(range).is_none() {
            return;
        }
        match node {
            AnyNodeRef::StmtAssign(_) | AnyNodeRef::StmtAugAssign(_) => hints.extend(placement(view, &marks, node, wanted)),
            AnyNodeRef::StmtFor(each) if wanted.loops => {
                let header = TextRange::new(each.range.start(), each.iter.range().end());
                hints.extend(repeated(view, &marks, header));
            }
            AnyNodeRef::ExprCall(call) if wanted.parameters => {
                let names = parameter_names(view, call, &functions);
                for (argument, name) in call.arguments.args.iter().zip(names) {
                    hints.extend(parameter(argument, &name));
                }
            }
            _ => {}
        }
    });
    hints.retain(|hint| range.contains_inclusive(hint.at));
    hints.sort_by_key(|hint| hint.at);
    hints
}

/// The marks of a statement.
fn marks_of(marks: &[Mark], range: TextRange) -> &[Mark] {
    let from = marks.partition_point(|mark| (mark.range.start(), mark.range.end()) < (range.start(), range.end()));
    let count = marks[from..].iter().take_while(|mark| mark.range == range).count();
    &marks[from..from + count]
}

/// What came of `o.min.x = …` or `o.facing = …`.
fn placement(view: &View, marks: &[Mark], node: AnyNodeRef, wanted: Wanted) -> Option<Hint> {
    let scene = view.scene?;
    let mut targets = targets(node).into_iter();
    let (Some(Expr::Attribute(target)), None) = (targets.next(), targets.next()) else { return None };
    let done = marks_of(marks, node.range());
    let (label, tooltip) = match (Axis::from_name(&target.attr), target.value.as_ref()) {
        (Some(axis), Expr::Attribute(inner)) if wanted.coordinates => {
            let anchor = Anchor::from_name(&inner.attr)?;
            (coordinates(scene, done, (anchor, axis), written(node)), "in the coordinates of the scene, metres")
        }
        (None, _) if target.attr.as_str() == "facing" && wanted.facings => (facings(scene, done, written(node)), "where it faces"),
        _ => return None,
    };
    let tooltip = if view.is_stale() { format!("{tooltip}; of the last run") } else { tooltip.to_string() };
    Some(Hint { at: node.range().end(), label: label?, tooltip, kind: HintKind::Result })
}

/// The value of a statement that assigns, where it is all that is written.
fn written(node: AnyNodeRef<'_>) -> Option<&Expr> {
    match node {
        AnyNodeRef::StmtAssign(assign) => Some(&assign.value),
        _ => None,
    }
}

/// The anchors that a statement wrote. In a turned frame these are others than the ones that stand there: then they are named.
fn coordinates(scene: &Scene, done: &[Mark], named: (Anchor, Axis), value: Option<&Expr>) -> Option<String> {
    let anchor_of = |mark: &Mark| match mark.deed {
        Deed::Anchored(axis) => scene.object(mark.object)?.anchor(axis),
        _ => None,
    };
    let anchors: Vec<_> = done.iter().filter_map(anchor_of).collect();
    let first = anchors.first()?;
    if let (Some(Expr::NumberLiteral(_) | Expr::UnaryOp(_)), [only]) = (value, &anchors[..])
        && (only.anchor, only.axis) == named
    {
        return None;
    }
    let elsewhere = anchors.iter().any(|anchor| (anchor.anchor, anchor.axis) != named);
    let name = if elsewhere { format!("{}.{} ", first.anchor.name(), first.axis.name()) } else { String::new() };
    let values = anchors.iter().map(|anchor| words::number(anchor.value.value())).collect();
    Some(format!("→ {name}{}", listed(values)))
}

fn facings(scene: &Scene, done: &[Mark], value: Option<&Expr>) -> Option<String> {
    let faced = done.iter().filter(|mark| mark.deed == Deed::Faced);
    let turns: Vec<String> = faced.filter_map(|mark| scene.object(mark.object)).map(|object| object.body.turn.name().to_string()).collect();
    if turns.is_empty() || matches!(value, Some(Expr::Name(name)) if turns.iter().all(|turn| *turn == name.id.as_str())) {
        return None;
    }
    Some(format!("→ {}", listed(turns)))
}

/// Values, shortly: one that all have, else the first few, and how many there are.
fn listed(values: Vec<String>) -> String {
    let count = values.len();
    let times = if count > 1 { format!(" (×{count})") } else { String::new() };
    if values.iter().all(|value| Some(value) == values.first()) {
        return format!("{}{times}", values.first().map(String::as_str).unwrap_or_default());
    }
    let more = if count > MAX_VALUES { format!(", …{times}") } else { String::new() };
    format!("{}{more}", values[..count.min(MAX_VALUES)].join(", "))
}

/// What a loop did to how many objects.
fn repeated(view: &View, marks: &[Mark], header: TextRange) -> Option<Hint> {
    let scene = view.scene?;
    let of_loop = |mark: &&Mark| {
        mark.deed == Deed::Around && mark.range.start() == header.start() && mark.range.end() >= header.end() && {
            // The header may end with its colon.
            mark.range.end() <= header.end() + TextSize::new(80)
        }
    };
    let mut objects: Vec<usize> = marks.iter().filter(of_loop).map(|mark| mark.object).collect();
    objects.sort_unstable();
    objects.dedup();
    if objects.is_empty() {
        return None;
    }
    let errors = scene.errors_among(&objects);
    let wrong = if errors > 0 { format!(", {}", words::counted(errors, "error")) } else { String::new() };
    let label = format!("{}{wrong}", words::counted(objects.len(), "object"));
    let names: Vec<&str> = objects.iter().filter_map(|index| scene.object(*index)).map(|object| object.path.as_str()).take(20).collect();
    let colon = view.text().get(header.end().to_usize()..).and_then(|rest| rest.find(':')).unwrap_or_default();
    let at = header.end() + TextSize::new(u32::try_from(colon + 1).unwrap_or(0));
    Some(Hint { at: at.min(TextSize::of(view.text())), label, tooltip: names.join(", "), kind: HintKind::Result })
}

/// The names of the parameters of what is called.
fn parameter_names(view: &View, call: &ExprCall, functions: &[&crate::syntax::ast::StmtFunctionDef]) -> Vec<String> {
    if let Some(def) = callee(view, call, functions) {
        return parameters(def).take(def.parameters.args.len()).map(|parameter| parameter.name.to_string()).collect();
    }
    let Expr::Name(name) = call.func.as_ref() else { return Vec::new() };
    let Some(doc) = docs::of("scene", &name.id).filter(|doc| doc.parameters().len() > 1) else { return Vec::new() };
    doc.parameters().into_iter().map(|text| text.split('=').next().unwrap_or(text).to_string()).collect()
}

/// The name before an argument that does not say it itself.
fn parameter(argument: &Expr, name: &str) -> Option<Hint> {
    let says = match argument {
        Expr::Starred(_) => true,
        Expr::Name(text) => text.id.as_str().eq_ignore_ascii_case(name),
        Expr::Attribute(attribute) => attribute.attr.as_str() == name,
        _ => false,
    };
    let tooltip = docs::of("parameter", name).map_or_else(String::new, |doc| doc.text.to_string());
    (!says).then(|| Hint { at: argument.range().start(), label: format!("{name}:"), tooltip, kind: HintKind::Parameter })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    const ALL: Wanted = Wanted { coordinates: true, facings: true, parameters: false, loops: true };

    /// The program with its hints between `«` and `»`.
    fn shown(text: &str, wanted: Wanted) -> String {
        let fixture = Fixture::new(text);
        let mut out = fixture.text().to_string();
        for hint in hints(&fixture.view(), TextRange::up_to(TextSize::of(text)), wanted).into_iter().rev() {
            out.insert_str(hint.at.to_usize(), &format!("«{}»", hint.label));
        }
        out
    }

    const SCENE: &str = "bed = Object('Bed', 2, 2, 1)\nchairs = [Object('Chair', 1, 1, 1, FLOATING) for _ in range(4)]\n";

    fn check(text: &str, wanted: Wanted, expected: &str) {
        assert_eq!(shown(&format!("{SCENE}{text}"), wanted).strip_prefix(SCENE), Some(expected));
    }

    #[test]
    fn placements_tell_where() {
        check("bed.max.x = scene.max.x - 0.5\nbed.min.y = 0.5\n", ALL, "bed.max.x = scene.max.x - 0.5«→ 2.5»\nbed.min.y = 0.5\n");
        check("bed.facing = scene\nbed.facing = X_MAX\n", ALL, "bed.facing = scene\nbed.facing = X_MAX\n");
        check("chairs[0].facing = bed\n", ALL, "chairs[0].facing = bed«→ Y_MIN»\n");
        check(
            "bed.facing = X_MAX\nset_coordinate_frame(bed)\nchairs[0].min.x = 1 + 1\n",
            ALL,
            "bed.facing = X_MAX\nset_coordinate_frame(bed)\nchairs[0].min.x = 1 + 1«→ max.y −2»\n",
        );
    }

    #[test]
    fn loops_tell_the_first_values_and_how_many() {
        let text = "for i, c in enumerate(chairs):\n    c.min.x = i * 0.5\n    c.min.y = bed.min.y\n";
        let expected = "for i, c in enumerate(chairs):«4 objects, 7 errors»\n    c.min.x = i * 0.5«→ 0, 0.5, 1, … (×4)»\n    c.min.y = bed.min.y«→ −1 (×4)»\n";
        let found = shown(&format!("{SCENE}bed.center.x = 2.0\nbed.center.y = 0.0\n{text}"), ALL);
        let found = found.split("0.0\n").nth(1).unwrap().to_string();
        let (head, tail) = found.split_once('»').unwrap();
        assert!(head.starts_with("for i, c in enumerate(chairs):«4 objects, "), "{head}");
        assert_eq!(Some(tail), expected.split_once('»').map(|(_, tail)| tail));
        assert_eq!(shown(&format!("{SCENE}{text}"), Wanted { coordinates: false, loops: false, ..ALL }), format!("{SCENE}{text}"));
    }

    #[test]
    fn arguments_tell_what_they_are_for() {
        let only = Wanted { coordinates: false, facings: false, loops: false, parameters: true };
        assert_eq!(
            shown("width = 2\nt = Object('T', width, 1, height=1)\ndef put(o, gap): pass\nput(t, 2)\nlen('a')\n", only),
            "width = 2\nt = Object(«name:»'T', width, «depth:»1, height=1)\ndef put(o, gap): pass\nput(«o:»t, «gap:»2)\nlen('a')\n"
        );
    }
}
