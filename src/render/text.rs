//! Text for pictures: names that may hold anything, made harmless and short, and measured.

use super::font::Face;

/// No name is looked at further than this; what is shown is shorter still.
const MOST: usize = 400;

/// A text that can be shown: control characters and those that turn the direction of what follows become a visible mark.
pub fn harmless(text: &str) -> String {
    text.chars().take(MOST).map(|c| if is_harmful(c) { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

fn is_harmful(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff0}'..='\u{fffb}' | '\u{fffe}' | '\u{ffff}' | '\u{e0000}'..='\u{e0fff}')
}

/// A text cut to a width in pixels at a size in pixels, with an ellipsis where something is missing.
pub fn fitted(text: &str, face: Face, size: f32, width: f32) -> String {
    let long = text.chars().nth(MOST).is_some();
    let text = harmless(text);
    if !long && face.width(&text, size) <= width {
        return text;
    }
    let mut left = width - face.width("…", size);
    let mut shown = String::new();
    for c in text.chars() {
        left -= face.advance(c, size);
        if left < 0.0 {
            break;
        }
        shown.push(c);
    }
    shown.truncate(shown.trim_end().len());
    shown.push('…');
    shown
}

/// The name of an object cut to a width; of `seats[12]` the number stays.
pub fn fitted_name(name: &str, face: Face, size: f32, width: f32) -> String {
    let number = name.rfind('[').map_or("", |at| &name[at..]);
    let tail = face.width(&harmless(number), size);
    if number.len() > 12 || number.len() == name.len() || tail > 0.6 * width || face.width(&harmless(name), size) <= width {
        return fitted(name, face, size, width);
    }
    format!("{}{}", fitted(&name[..name.len() - number.len()], face, size, width - tail), harmless(number))
}

/// A length for people: two decimals, more where it is short.
pub fn metres(value: f64) -> String {
    match value.abs() {
        long if long >= 1e6 => format!("{value:.0e} m"),
        long if long >= 99.95 => format!("{value:.0} m"),
        long if long >= 0.095 => format!("{value:.2} m"),
        _ => format!("{} m", format!("{value:.3}").trim_end_matches('0').trim_end_matches('.')),
    }
}

/// A number with its noun.
pub fn counted(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_disturb_a_line_becomes_visible() {
        assert_eq!(harmless("a\u{0}b\nc\u{202e}d\u{1b}[0m"), "a\u{fffd}b\u{fffd}c\u{fffd}d\u{fffd}[0m");
        assert_eq!(harmless("Ωmega </script> \"é\""), "Ωmega </script> \"é\"");
    }

    #[test]
    fn long_names_end_in_an_ellipsis_and_fit() {
        let long = "x".repeat(10_000);
        for width in [5.0, 40.0, 200.0] {
            let shown = fitted(&long, Face::Sans, 12.0, width);
            assert!(shown.ends_with('…') && Face::Sans.width(&shown, 12.0) <= width.max(Face::Sans.width("…", 12.0)));
        }
        assert_eq!(fitted_name("marshalling_yard[12]", Face::Sans, 10.0, 60.0), "mars…[12]");
        assert_eq!(fitted("bed", Face::Sans, 12.0, 100.0), "bed");
    }
}
