//! Names and numbers as the formats can hold them.

use rustc_hash::FxHashSet;

/// Identifiers are cut to this many letters.
const LONGEST: usize = 60;

/// Names that were given out; each is given once.
#[derive(Default)]
pub(super) struct Unique {
    taken: FxHashSet<String>,
}

impl Unique {
    /// None of these is given out.
    pub(super) fn reserve(names: impl IntoIterator<Item = impl Into<String>>) -> Unique {
        Unique { taken: names.into_iter().map(Into::into).collect() }
    }

    /// True where nobody has the name yet.
    pub(super) fn is_free(&self, name: &str) -> bool {
        !self.taken.contains(name)
    }

    /// The name, with a number behind it where somebody has it already.
    pub(super) fn take(&mut self, name: String) -> String {
        if self.taken.insert(name.clone()) {
            return name;
        }
        let mut number = 2_usize;
        loop {
            let numbered = format!("{name}_{number}");
            if self.taken.insert(numbered.clone()) {
                return numbered;
            }
            // Steps grow, so that ten thousand equal names do not take a hundred million looks.
            number += 1 + number / 64;
        }
    }
}

/// An identifier of ASCII letters, digits and underscores that resembles a text; `other` where nothing of it is left.
pub(super) fn identifier(text: &str, other: &str) -> String {
    let mut name = String::new();
    for c in text.chars() {
        if name.len() >= LONGEST {
            break;
        }
        match c {
            c if c.is_ascii_alphanumeric() => name.push(c),
            _ if name.ends_with('_') || name.is_empty() => {}
            _ => name.push('_'),
        }
    }
    let name = name.trim_end_matches('_');
    match name.chars().next() {
        None => other.to_owned(),
        Some(first) if first.is_ascii_digit() => format!("{other}_{name}"),
        Some(_) => name.to_owned(),
    }
}

/// One line without blanks, for formats whose words end at them.
pub(super) fn word(text: &str) -> String {
    let plain = |c: char| if c.is_whitespace() || c.is_control() || c == '#' || c == '\\' { '_' } else { c };
    text.chars().map(plain).collect()
}

/// Text for an XML comment, which knows no escapes: its end must not stand in it.
pub(super) fn xml_comment(text: &str) -> String {
    let plain = |c: char| if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') { '\u{fffd}' } else { c };
    text.chars().map(plain).collect::<String>().replace('-', "\u{2010}")
}

/// The shortest decimal that reads back as the same number; no sign before a zero.
pub(super) fn number(value: f64) -> String {
    let text = format!("{:?}", if value == 0.0 { 0.0 } else { value });
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// Several numbers with blanks between them.
pub(super) fn numbers<const N: usize>(values: [f64; N]) -> String {
    values.map(number).join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_identifier_resembles_its_name() {
        let made =
            ["nightstands[1]", "create_wall() #3", "lamps['left']", "床", "2 x 4", "</script>"].map(|name| identifier(name, "object"));
        assert_eq!(made, ["nightstands_1", "create_wall_3", "lamps_left", "object", "object_2_x_4", "script"]);
        assert_eq!(identifier(&"a".repeat(10_000), "object").len(), LONGEST);
    }

    #[test]
    fn equal_names_are_numbered() {
        let mut names = Unique::default();
        let given: Vec<String> = ["a", "a", "a_2", "b", "a"].map(|name| names.take(name.to_owned())).to_vec();
        assert_eq!(given, ["a", "a_2", "a_2_2", "b", "a_3"]);
    }

    #[test]
    fn numbers_are_short_and_exact() {
        assert_eq!([0.1, -0.0, 3.0, 1e-7, 1e300, f64::INFINITY].map(number), ["0.1", "0", "3", "1e-7", "1e300", "inf"]);
    }

    #[test]
    fn a_comment_does_not_end_early() {
        assert!(!xml_comment("--> <x>").contains("--"));
    }
}
