//! Text inside of XML and HTML, for every room that writes them.

use std::fmt::Write as _;

/// Text for an attribute or the content of an element. What XML 1.0 cannot hold becomes U+FFFD.
pub fn xml(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&apos;"),
            '\t' | '\n' | '\r' => {
                let _ = write!(out, "&#{};", u32::from(c));
            }
            '\u{fffe}' | '\u{ffff}' => out.push(char::REPLACEMENT_CHARACTER),
            c if c.is_control() => out.push(char::REPLACEMENT_CHARACTER),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_leaves_its_attribute_or_element() {
        assert_eq!(xml("<a href='x'>\"&\n\u{1}\u{85}"), "&lt;a href=&apos;x&apos;&gt;&quot;&amp;&#10;\u{fffd}\u{fffd}");
    }
}
