//! Colours, RRGGBB: where they stand, and how another one is written.

use super::find::for_each_node;
use super::program::View;
use crate::syntax::ast::{AnyNodeRef, Expr, ExprCall, Ranged as _};
use ruff_text_size::{TextRange, TextSize};

/// A colour in a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Color {
    /// The six digits.
    pub range: TextRange,
    /// Red, green, blue.
    pub rgb: [u8; 3],
}

/// The colours that a program gives to objects, floor and walls.
pub fn colors(view: &View) -> Vec<Color> {
    let mut found = Vec::new();
    for_each_node(view, &mut |node| {
        if let AnyNodeRef::ExprCall(call) = node {
            found.extend(argument(call).and_then(|expr| literal(view, expr)));
        }
    });
    found
}

/// The argument that is a colour.
fn argument(call: &ExprCall) -> Option<&Expr> {
    let Expr::Name(name) = call.func.as_ref() else { return None };
    let place = match name.id.as_str() {
        "Object" => 5,
        "Door" | "Window" => 4,
        "set_floor_asset" => 1,
        "set_wall_asset" => 2,
        _ => return None,
    };
    let named = call.arguments.keywords.iter().find(|keyword| keyword.arg.as_ref().is_some_and(|arg| arg.id == "color"));
    named.map(|keyword| &keyword.value).or_else(|| call.arguments.args.get(place))
}

fn literal(view: &View, expr: &Expr) -> Option<Color> {
    let Expr::StringLiteral(string) = expr else { return None };
    let digits = string.value.to_str();
    let rgb = parse(digits)?;
    let at = view.slice(string.range()).find(digits)?;
    let start = string.range().start() + TextSize::new(u32::try_from(at).ok()?);
    Some(Color { range: TextRange::at(start, TextSize::of(digits)), rgb })
}

/// The colours of a sidecar: each six digits behind `"color":`.
pub fn template_colors(text: &str) -> Vec<Color> {
    let mut found = Vec::new();
    for (at, key) in text.match_indices("\"color\"") {
        let rest = &text[at + key.len()..];
        let value = rest.trim_start().strip_prefix(':').map(str::trim_start).and_then(|rest| rest.strip_prefix('"'));
        let digits = value.and_then(|value| value.split('"').next()).unwrap_or_default();
        if let (Some(rgb), Some(value)) = (parse(digits), value) {
            let start = text.len() - value.len();
            if let Ok(start) = u32::try_from(start) {
                found.push(Color { range: TextRange::at(start.into(), TextSize::of(digits)), rgb });
            }
        }
    }
    found
}

fn parse(digits: &str) -> Option<[u8; 3]> {
    if digits.len() != 6 || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let number = u32::from_str_radix(digits, 16).ok()?;
    let [_, red, green, blue] = number.to_be_bytes();
    Some([red, green, blue])
}

/// A colour as programs write it.
pub fn presentation(rgb: [u8; 3]) -> String {
    format!("{:02X}{:02X}{:02X}", rgb[0], rgb[1], rgb[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    #[test]
    fn colours_are_found_where_they_are_colours() {
        let text = "a = Object('A', 1, 1, 1, STANDING, '4169e1')\nset_floor_asset('Wood', color=\"9B7D60\")\nx = '123456'\nDoor('D', 1, 1, 1, 'brown')\n";
        let fixture = Fixture::new(text);
        let found: Vec<_> = colors(&fixture.view()).into_iter().map(|color| (&text[color.range], color.rgb)).collect();
        assert_eq!(found, [("4169e1", [0x41, 0x69, 0xe1]), ("9B7D60", [0x9b, 0x7d, 0x60])]);
        assert_eq!(presentation([0x41, 0x69, 0xe1]), "4169E1");
    }

    #[test]
    fn colours_of_a_sidecar() {
        let text = r#"{"objects": [{"id": "a", "color" : "FF0000"}, {"color": "red"}, {"color": "00ff00"#;
        let found: Vec<_> = template_colors(text).into_iter().map(|color| &text[color.range]).collect();
        assert_eq!(found, ["FF0000", "00ff00"]);
    }
}
