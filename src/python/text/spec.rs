//! The format specification mini-language.

use super::FormatError;

/// `[[fill]align][sign][z][#][0][width][grouping][.precision][type]`
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spec {
    /// What padding is made of.
    pub fill: char,
    /// `<`, `>`, `^`, or `=` (between sign and digits).
    pub align: char,
    /// `+`, `-` or a space.
    pub sign: Option<char>,
    /// `z`: no negative zero.
    pub no_negative_zero: bool,
    /// `#`
    pub alternate: bool,
    /// The least number of characters.
    pub width: usize,
    /// `,` or `_`
    pub grouping: Option<char>,
    /// Digits after the point, or the most characters of a string.
    pub precision: Option<usize>,
    /// The presentation type.
    pub kind: char,
}

fn error<T>(message: impl Into<String>) -> Result<T, FormatError> {
    Err(FormatError::Value(message.into()))
}

/// A type code as a message shows it.
fn shown(kind: char) -> String {
    if (' '..'\x7f').contains(&kind) && kind != ' ' { kind.to_string() } else { format!("\\x{:x}", kind as u32) }
}

/// The exception for a type code that the class does not know.
pub(super) fn unknown_kind<T>(kind: char, class: &str) -> Result<T, FormatError> {
    error(format!("Unknown format code '{}' for object of type '{class}'", shown(kind)))
}

/// A number at the beginning of the text, and the rest.
fn integer(text: &str) -> Result<(Option<usize>, &str), FormatError> {
    let mut value: Option<usize> = None;
    let mut rest = text;
    while let Some(digit) = rest.chars().next().and_then(super::unicode::decimal) {
        let next = value.unwrap_or(0).checked_mul(10).and_then(|v| v.checked_add(digit as usize)).filter(|v| *v <= isize::MAX as usize);
        if next.is_none() {
            return error("Too many decimal digits in format string");
        }
        value = next;
        rest = &rest[rest.chars().next().map_or(0, char::len_utf8)..];
    }
    Ok((value, rest))
}

impl Spec {
    /// Reads a spec for a value of this class, whose type code and alignment are these where none is given.
    pub fn parse(text: &str, class: &str, kind: char, align: char) -> Result<Spec, FormatError> {
        let mut spec = Spec {
            fill: ' ',
            align,
            sign: None,
            no_negative_zero: false,
            alternate: false,
            width: 0,
            grouping: None,
            precision: None,
            kind,
        };
        let is_align = |c: Option<char>| matches!(c, Some('<' | '>' | '=' | '^'));
        let mut chars = text.chars();
        let (first, second) = (chars.next(), chars.next());
        let (mut filled, mut aligned) = (false, false);
        let mut rest = text;
        if let (Some(fill), Some(align)) = (first, second.filter(|c| is_align(Some(*c)))) {
            (spec.fill, spec.align, filled, aligned) = (fill, align, true, true);
            rest = chars.as_str();
        } else if let Some(align) = first.filter(|c| is_align(Some(*c))) {
            (spec.align, aligned) = (align, true);
            rest = &rest[1..];
        }
        let take = |rest: &mut &str, wanted: char| match rest.strip_prefix(wanted) {
            Some(after) => {
                *rest = after;
                true
            }
            None => false,
        };
        for sign in [' ', '+', '-'] {
            if spec.sign.is_none() && take(&mut rest, sign) {
                spec.sign = Some(sign);
            }
        }
        spec.no_negative_zero = take(&mut rest, 'z');
        spec.alternate = take(&mut rest, '#');
        if !filled && take(&mut rest, '0') {
            spec.fill = '0';
            if !aligned && align == '>' {
                spec.align = '=';
            }
        }
        let (width, mut rest) = integer(rest)?;
        spec.width = width.unwrap_or(0);
        if take(&mut rest, ',') {
            spec.grouping = Some(',');
        }
        if take(&mut rest, '_') {
            if spec.grouping.is_some() {
                return error("Cannot specify both ',' and '_'.");
            }
            spec.grouping = Some('_');
        }
        if spec.grouping == Some('_') && rest.starts_with(',') {
            return error("Cannot specify both ',' and '_'.");
        }
        if take(&mut rest, '.') {
            let (precision, after) = integer(rest)?;
            if precision.is_none() {
                return error("Format specifier missing precision");
            }
            (spec.precision, rest) = (precision, after);
        }
        let mut last = rest.chars();
        if let Some(kind) = last.next() {
            if !last.as_str().is_empty() {
                return error(format!("Invalid format specifier '{text}' for object of type '{class}'"));
            }
            spec.kind = kind;
        }
        spec.check_grouping()?;
        Ok(spec)
    }

    fn check_grouping(&self) -> Result<(), FormatError> {
        match (self.grouping, self.kind) {
            (None, _) | (_, 'd' | 'e' | 'f' | 'g' | 'E' | 'G' | '%' | 'F' | '\0') | (Some('_'), 'b' | 'o' | 'x' | 'X') => Ok(()),
            (Some(grouping), kind) => error(format!("Cannot specify '{grouping}' with '{}'.", shown(kind))),
        }
    }

    /// Bytes that a text of this spec may take, beside the value's own.
    pub fn size(&self) -> usize {
        // A precision beyond 32 bits is an error of its own.
        let digits = if self.kind == 's' { 0 } else { self.precision.filter(|p| *p <= i32::MAX as usize).unwrap_or(0) };
        self.width.saturating_mul(self.fill.len_utf8()).saturating_add(digits)
    }

    /// How much padding goes before and behind a text of so many characters.
    pub(super) fn padding(&self, length: usize) -> (usize, usize) {
        let missing = self.width.saturating_sub(length);
        match self.align {
            '<' => (0, missing),
            '^' => (missing / 2, missing - missing / 2),
            _ => (missing, 0),
        }
    }
}

/// `format(text, spec)`
pub fn format_str(text: &str, spec: &Spec) -> Result<String, FormatError> {
    if spec.kind != 's' {
        return unknown_kind(spec.kind, "str");
    }
    match spec.sign {
        Some(' ') => return error("Space not allowed in string format specifier"),
        Some(_) => return error("Sign not allowed in string format specifier"),
        None => {}
    }
    if spec.no_negative_zero {
        return error("Negative zero coercion (z) not allowed in string format specifier");
    }
    if spec.alternate {
        return error("Alternate form (#) not allowed in string format specifier");
    }
    if spec.align == '=' {
        return error("'=' alignment not allowed in string format specifier");
    }
    let kept = match spec.precision {
        Some(most) => text.char_indices().nth(most).map_or(text, |(end, _)| &text[..end]),
        None => text,
    };
    let (before, after) = spec.padding(if spec.width == 0 { 0 } else { kept.chars().count() });
    let mut out = String::with_capacity(kept.len() + before + after);
    out.extend(std::iter::repeat_n(spec.fill, before));
    out.push_str(kept);
    out.extend(std::iter::repeat_n(spec.fill, after));
    Ok(out)
}
