//! Placements that are written often, as snippets with places to fill in.

/// A placement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Placement {
    AgainstWall,
    OnTop,
    InFront,
    Beside,
    Row,
    Ring,
    Grid,
}

impl Placement {
    pub(super) const ALL: [Placement; 7] =
        [Placement::AgainstWall, Placement::OnTop, Placement::InFront, Placement::Beside, Placement::Row, Placement::Ring, Placement::Grid];

    pub(super) const fn label(self) -> &'static str {
        match self {
            Placement::AgainstWall => "against a wall",
            Placement::OnTop => "on top of",
            Placement::InFront => "in front of",
            Placement::Beside => "beside",
            Placement::Row => "row",
            Placement::Ring => "ring around",
            Placement::Grid => "grid",
        }
    }

    pub(super) const fn detail(self) -> &'static str {
        match self {
            Placement::AgainstWall => "an object with its back to a wall",
            Placement::OnTop => "an object in the middle of another's top",
            Placement::InFront => "an object in front of another, facing it",
            Placement::Beside => "an object to the right of another",
            Placement::Row => "a list of objects in a row",
            Placement::Ring => "a list of objects in a circle, facing the middle",
            Placement::Grid => "a list of objects in rows and columns",
        }
    }

    /// The text, about the first of the objects and lists that there are.
    pub(super) fn snippet(self, objects: &[String], lists: &[String]) -> String {
        let object = choice(1, objects, 0, "object");
        let other = choice(2, objects, 1, "other");
        let list = choice(1, lists, 0, "objects");
        match self {
            Placement::AgainstWall => format!(
                "{object}.${{2|max.y,min.y,max.x,min.x|}} = scene.$2\n$1.${{3|center.x,center.y|}} = scene.$3\n$1.min.z = scene.min.z\n$1.facing = ${{4|Y_MIN,Y_MAX,X_MIN,X_MAX|}}$0"
            ),
            Placement::OnTop => {
                format!("{object}.center.x = {other}.center.x\n$1.center.y = $2.center.y\n$1.min.z = $2.max.z\n$1.facing = $2.facing$0")
            }
            Placement::InFront => format!(
                "set_coordinate_frame({other})\n{object}.center.x = $2.center.x\n$1.min.y = $2.max.y + ${{3:0.05}}\n$1.min.z = scene.min.z\n$1.facing = $2\nset_coordinate_frame(scene)$0"
            ),
            Placement::Beside => format!(
                "set_coordinate_frame({other})\n{object}.min.x = $2.max.x + ${{3:0.1}}\n$1.center.y = $2.center.y\n$1.min.z = $2.min.z\n$1.facing = $2.facing\nset_coordinate_frame(scene)$0"
            ),
            Placement::Row => format!(
                "gap = ${{2:0.5}}\nfor i, item in enumerate({list}):\n    item.min.x = scene.min.x + gap + i * (item.width + gap)\n    item.center.y = scene.center.y\n    item.min.z = scene.min.z\n    item.facing = ${{3|Y_MIN,Y_MAX|}}$0"
            ),
            Placement::Ring => {
                let middle = choice(3, objects, 0, "table");
                format!(
                    "radius = ${{2:1.5}}\nfor i, item in enumerate({list}):\n    angle = 2 * pi * i / len($1)\n    item.center.x = {middle}.center.x + radius * cos(angle)\n    item.center.y = $3.center.y + radius * sin(angle)\n    item.min.z = scene.min.z\n    item.facing = $3$0"
                )
            }
            Placement::Grid => format!(
                "columns = ${{2:3}}\nmargin = ${{3:1.0}}\nstep = ${{4:1.5}}\nfor i, item in enumerate({list}):\n    row, column = divmod(i, columns)\n    item.center.x = scene.min.x + margin + column * step\n    item.center.y = scene.min.y + margin + row * step\n    item.min.z = scene.min.z\n    item.facing = ${{5|Y_MIN,Y_MAX,X_MIN,X_MAX|}}$0"
            ),
        }
    }
}

/// A place to fill in with one of some names, the one at `first` before the others.
fn choice(number: u8, names: &[String], first: usize, default: &str) -> String {
    match names {
        [] => format!("${{{number}:{default}}}"),
        [only] => format!("${{{number}:{only}}}"),
        many => {
            let first = first.min(many.len() - 1);
            let rest = many.iter().enumerate().filter(|(at, _)| *at != first).map(|(_, name)| name.as_str());
            let names: Vec<&str> = std::iter::once(many[first].as_str()).chain(rest).collect();
            format!("${{{number}|{}|}}", names.join(","))
        }
    }
}

/// The call of a constructor, to fill in.
pub(super) fn constructor(name: &str) -> Option<String> {
    Some(match name {
        "Object" => {
            "Object(\"${1:Name}\", width=${2:1.0}, depth=${3:1.0}, height=${4:1.0}, support=${5|STANDING,MOUNTED,FLOATING|}, color=\"${6:8B4513}\")$0".into()
        }
        "Door" => "Door(\"${1:Door}\", width=${2:0.9}, depth=${3:0.1}, height=${4:2.0}, color=\"${5:8B4513}\")$0".into(),
        "Window" => "Window(\"${1:Window}\", width=${2:1.2}, depth=${3:0.1}, height=${4:1.2}, color=\"${5:ADD8E6}\")$0".into(),
        _ => return None,
    })
}

/// A snippet as plain text: each place filled in with its first choice.
pub fn plain_text(snippet: &str) -> String {
    let mut values: Vec<(u32, String)> = Vec::new();
    let mut out = String::with_capacity(snippet.len());
    let mut rest = snippet;
    while let Some(at) = rest.find('$') {
        out.push_str(&rest[..at]);
        rest = &rest[at + 1..];
        if let Some(inner) = rest.strip_prefix('{') {
            let end = inner.find('}').unwrap_or(inner.len());
            let body = &inner[..end];
            let digits = body.chars().take_while(char::is_ascii_digit).count();
            let number = body[..digits].parse().unwrap_or(0);
            let value = body[digits..].trim_start_matches([':', '|']).split([',', '|']).next().unwrap_or_default();
            out.push_str(value);
            values.push((number, value.to_string()));
            rest = inner.get(end + 1..).unwrap_or_default();
        } else {
            let digits = rest.chars().take_while(char::is_ascii_digit).count();
            let number: u32 = rest[..digits].parse().unwrap_or(0);
            let value = values.iter().find(|(known, _)| *known == number).map(|(_, value)| value.as_str()).unwrap_or_default();
            out.push_str(value);
            rest = &rest[digits..];
        }
    }
    out.push_str(rest);
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Input, Options, analyse};
    use crate::check::finding::Code;

    #[test]
    fn every_placement_runs_and_places_what_it_names() {
        let scene = "set_size(8, 8, 3)\ntable = Object('Table', 2, 1, 1)\nlamp = Object('Lamp', 0.2, 0.2, 0.4)\nchairs = [Object('Chair', 0.5, 0.5, 1) for _ in range(4)]\ntable.center.x = 0.5\ntable.center.y = 0.0\n";
        let (objects, lists) = (["lamp".to_string(), "table".to_string()], ["chairs".to_string()]);
        for placement in Placement::ALL {
            let text = format!("{scene}{}\n", plain_text(&placement.snippet(&objects, &lists)));
            let analysis = analyse(&Input { text: &text, template: None }, &Options::default(), None);
            let broken = |code| matches!(code, Code::Exception | Code::SyntaxError | Code::UnknownName);
            assert!(!analysis.findings.iter().any(|finding| broken(finding.code)), "{text}: {:?}", analysis.findings);
            let layout = analysis.layout.unwrap();
            let placed = layout.objects.iter().filter(|object| object.body.is_placed()).count();
            assert!(placed > 1, "{text}");
        }
    }

    #[test]
    fn constructors_are_calls() {
        for name in ["Object", "Door", "Window"] {
            let text = format!("a = {}\n", plain_text(&constructor(name).unwrap()));
            let analysis = analyse(&Input { text: &text, template: None }, &Options::default(), None);
            assert_eq!(analysis.layout.unwrap().objects.len(), 1, "{text}");
        }
    }

    #[test]
    fn a_snippet_as_plain_text() {
        assert_eq!(plain_text("${1|a,b|}.x = ${2:0.5} + $1$0"), "a.x = 0.5 + a");
    }
}
