//! What kind of character each is, as the methods of `str` see it.

use unicode_properties::{GeneralCategory, UnicodeGeneralCategory};

/// `str.isspace`: bidirectional type WS, B or S, or category Zs.
pub fn is_space(c: char) -> bool {
    matches!(c,
        '\t'..='\r' | '\x1c'..='\x20' | '\u{85}' | '\u{a0}' | '\u{1680}' | '\u{2000}'..='\u{200a}'
        | '\u{2028}' | '\u{2029}' | '\u{202f}' | '\u{205f}' | '\u{3000}')
}

/// Where `str.splitlines` ends a line.
pub fn is_line_break(c: char) -> bool {
    matches!(c, '\n'..='\r' | '\x1c'..='\x1e' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// `str.isprintable`; what is not is escaped by `repr`.
pub fn is_printable(c: char) -> bool {
    use GeneralCategory::*;
    if c.is_ascii() {
        return (' '..='~').contains(&c);
    }
    !matches!(
        c.general_category(),
        Control | Format | Surrogate | PrivateUse | Unassigned | LineSeparator | ParagraphSeparator | SpaceSeparator
    )
}

/// `str.isalpha`: the letters.
pub fn is_alpha(c: char) -> bool {
    use GeneralCategory::*;
    if c.is_ascii() {
        return c.is_ascii_alphabetic();
    }
    matches!(c.general_category(), UppercaseLetter | LowercaseLetter | TitlecaseLetter | ModifierLetter | OtherLetter)
}

/// The value of a decimal digit of any script.
pub fn decimal(c: char) -> Option<u8> {
    if c.is_ascii() {
        return c.to_digit(10).map(|d| d as u8);
    }
    if c.general_category() != GeneralCategory::DecimalNumber {
        return None;
    }
    // Digits stand in runs of ten, from 0 to 9, and several runs may follow on each other.
    let before =
        (1..60).take_while(|back| char::from_u32(c as u32 - back).is_some_and(|c| c.general_category() == GeneralCategory::DecimalNumber));
    Some((before.count() % 10) as u8)
}

/// `str.isdigit`: decimal digits, and those within a sign of their own (superscripts, circled digits).
pub fn is_digit(c: char) -> bool {
    if c.is_ascii() {
        return c.is_ascii_digit();
    }
    matches!(c as u32,
        0xB2..=0xB3 | 0xB9 | 0x1369..=0x1371 | 0x19DA | 0x2070 | 0x2074..=0x2079 | 0x2080..=0x2089 | 0x2460..=0x2468
        | 0x2474..=0x247C | 0x2488..=0x2490 | 0x24EA | 0x24F5..=0x24FD | 0x24FF | 0x2776..=0x277E | 0x2780..=0x2788
        | 0x278A..=0x2792 | 0x10A40..=0x10A43 | 0x10E60..=0x10E68 | 0x11052..=0x1105A | 0x1F100..=0x1F10A)
        || c.general_category() == GeneralCategory::DecimalNumber
}

/// CJK ideographs that mean a number.
#[rustfmt::skip]
const NUMBER_IDEOGRAPHS: &[u32] = &[
    0x3405, 0x3483, 0x382A, 0x3B4D, 0x4E00, 0x4E03, 0x4E07, 0x4E09, 0x4E5D, 0x4E8C, 0x4E94, 0x4E96, 0x4EBF, 0x4EC0, 0x4EDF, 0x4EE8,
    0x4F0D, 0x4F70, 0x5104, 0x5146, 0x5169, 0x516B, 0x516D, 0x5341, 0x5343, 0x5344, 0x5345, 0x534C, 0x53C1, 0x53C2, 0x53C3, 0x53C4,
    0x56DB, 0x58F1, 0x58F9, 0x5E7A, 0x5EFE, 0x5EFF, 0x5F0C, 0x5F0D, 0x5F0E, 0x5F10, 0x62FE, 0x634C, 0x67D2, 0x6F06, 0x7396, 0x767E,
    0x8086, 0x842C, 0x8CAE, 0x8CB3, 0x8D30, 0x9621, 0x9646, 0x964C, 0x9678, 0x96F6, 0xF96B, 0xF973, 0xF978, 0xF9B2, 0xF9D1, 0xF9D3,
    0xF9FD, 0x20001, 0x20064, 0x200E2, 0x20121, 0x2092A, 0x20983, 0x2098C, 0x2099C, 0x20AEA, 0x20AFD, 0x20B19, 0x22390, 0x22998,
    0x23B1B, 0x2626D, 0x2F890,
];

/// `str.isnumeric`: everything that stands for a number.
pub fn is_numeric(c: char) -> bool {
    use GeneralCategory::*;
    if c.is_ascii() {
        return c.is_ascii_digit();
    }
    matches!(c.general_category(), DecimalNumber | LetterNumber | OtherNumber) || NUMBER_IDEOGRAPHS.binary_search(&(c as u32)).is_ok()
}

/// Whether a character is a titlecase letter, such as ǅ.
pub fn is_title(c: char) -> bool {
    !c.is_ascii() && c.general_category() == GeneralCategory::TitlecaseLetter
}

/// Whether a character has a case.
pub fn is_cased(c: char) -> bool {
    c.is_lowercase() || c.is_uppercase() || is_title(c)
}

/// Appends the titlecase of a character.
pub fn push_title(out: &mut String, c: char) {
    match c as u32 {
        0x149 => out.extend(c.to_uppercase()),
        0x1C4..=0x1CC => out.extend(char::from_u32((c as u32 - 0x1C4) / 3 * 3 + 0x1C5)),
        0x1F1..=0x1F3 => out.push('\u{1F2}'),
        0x10D0..=0x10FF => out.push(c),
        0x1F80..=0x1FAF => out.extend(char::from_u32(c as u32 | 8)),
        0x1FB3 | 0x1FBC => out.push('\u{1FBC}'),
        0x1FC3 | 0x1FCC => out.push('\u{1FCC}'),
        0x1FF3 | 0x1FFC => out.push('\u{1FFC}'),
        _ => {
            let mut upper = c.to_uppercase();
            out.extend(upper.next());
            for rest in upper {
                // The iota of Greek goes under its letter.
                if rest == '\u{399}' { out.push('\u{345}') } else { out.extend(rest.to_lowercase()) }
            }
        }
    }
}

/// Appends the full case folding of a character.
pub fn push_folded(out: &mut String, c: char) {
    match c as u32 {
        0x131 | 0x13A0..=0x13F5 => out.push(c),
        0x1E9E => out.push_str("ss"),
        0x13F8..=0x13FD | 0xAB70..=0xABBF => out.extend(c.to_uppercase()),
        _ => out.extend(c.to_uppercase().flat_map(char::to_lowercase)),
    }
}
