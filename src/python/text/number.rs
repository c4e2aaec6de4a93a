//! Numbers in a format spec.

use super::FormatError;
use super::float::{Style, Wishes, write};
use super::spec::{Spec, unknown_kind};
use crate::python::heap::Complex;
use crate::python::numbers;
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};

fn error<T>(message: &str) -> Result<T, FormatError> {
    Err(FormatError::Value(message.into()))
}

/// `format(v, spec)` of a small int.
pub fn format_int(v: i64, spec: &Spec, class: &str) -> Result<String, FormatError> {
    if spec.kind == 'd' && spec.precision.is_none() && !spec.no_negative_zero {
        return Ok(lay_out(spec, v < 0, "", &v.unsigned_abs().to_string(), ""));
    }
    format_big(&BigInt::from(v), spec, class)
}

/// `format(v, spec)` of any int.
pub fn format_big(v: &BigInt, spec: &Spec, class: &str) -> Result<String, FormatError> {
    match spec.kind {
        'e' | 'E' | 'f' | 'F' | 'g' | 'G' | '%' => {
            let Some(float) = v.to_f64().filter(|f| f.is_finite()) else {
                return Err(FormatError::Overflow("int too large to convert to float"));
            };
            return format_float(float, spec, class);
        }
        'd' | 'n' | 'b' | 'o' | 'x' | 'X' | 'c' => {}
        kind => return unknown_kind(kind, class),
    }
    if spec.precision.is_some() {
        return error("Precision not allowed in integer format specifier");
    }
    if spec.no_negative_zero {
        return error("Negative zero coercion (z) not allowed in integer format specifier");
    }
    if spec.kind == 'c' {
        return format_character(v, spec);
    }
    let (prefix, digits) = digits_of(v, spec.kind)?;
    Ok(lay_out(spec, v.is_negative(), if spec.alternate { prefix } else { "" }, &digits, ""))
}

/// The prefix and the digits of an int in the base of a type code.
pub(super) fn digits_of(v: &BigInt, kind: char) -> Result<(&'static str, String), FormatError> {
    let magnitude = v.magnitude();
    Ok(match kind {
        'b' => ("0b", magnitude.to_str_radix(2)),
        'o' => ("0o", magnitude.to_str_radix(8)),
        'x' => ("0x", magnitude.to_str_radix(16)),
        'X' => ("0X", magnitude.to_str_radix(16).to_uppercase()),
        _ => ("", numbers::int_to_string(&v.abs())?),
    })
}

fn format_character(v: &BigInt, spec: &Spec) -> Result<String, FormatError> {
    if spec.sign.is_some() {
        return error("Sign not allowed with integer format specifier 'c'");
    }
    if spec.alternate {
        return error("Alternate form (#) not allowed with integer format specifier 'c'");
    }
    let Some(code) = v.to_i64() else { return Err(FormatError::Overflow("Python int too large to convert to C long")) };
    if !(0..0x110000).contains(&code) {
        return Err(FormatError::Overflow("%c arg not in range(0x110000)"));
    }
    let c = u32::try_from(code).ok().and_then(char::from_u32).unwrap_or(char::REPLACEMENT_CHARACTER);
    Ok(lay_out(spec, false, "", "", c.encode_utf8(&mut [0; 4])))
}

/// The style of a float's type code.
pub(super) fn style(kind: char, precision: Option<usize>) -> Style {
    match (kind.to_ascii_lowercase(), precision) {
        ('\0', None) => Style::Shortest,
        ('\0' | 'g' | 'n', n) => Style::General(n.unwrap_or(6)),
        ('e', n) => Style::Exponent(n.unwrap_or(6)),
        (_, n) => Style::Fixed(n.unwrap_or(6)),
    }
}

fn check_precision(spec: &Spec) -> Result<(), FormatError> {
    if spec.precision.is_some_and(|p| p > i32::MAX as usize) { error("precision too big") } else { Ok(()) }
}

/// `format(x, spec)` of a float.
pub fn format_float(x: f64, spec: &Spec, class: &str) -> Result<String, FormatError> {
    if !matches!(spec.kind, '\0' | 'e' | 'E' | 'f' | 'F' | 'g' | 'G' | 'n' | '%') {
        return unknown_kind(spec.kind, class);
    }
    check_precision(spec)?;
    let wishes = Wishes { alternate: spec.alternate, dot_zero: spec.kind == '\0', no_negative_zero: spec.no_negative_zero };
    let percent = spec.kind == '%';
    let mut text = write(if percent { x * 100.0 } else { x }, style(spec.kind, spec.precision), wishes);
    if percent {
        text.push('%');
    }
    if spec.kind.is_ascii_uppercase() {
        text.make_ascii_uppercase();
    }
    Ok(lay_out_float(spec, &text))
}

/// `format(c, spec)` of a complex number.
pub fn format_complex(c: Complex, spec: &Spec) -> Result<String, FormatError> {
    if !matches!(spec.kind, '\0' | 'e' | 'E' | 'f' | 'F' | 'g' | 'G' | 'n') {
        return unknown_kind(spec.kind, "complex");
    }
    if spec.fill == '0' {
        return error("Zero padding is not allowed in complex format specifier");
    }
    if spec.align == '=' {
        return error("'=' alignment flag is not allowed in complex format specifier");
    }
    check_precision(spec)?;
    let style = style(spec.kind, spec.precision);
    let wishes = Wishes { alternate: spec.alternate, dot_zero: false, no_negative_zero: spec.no_negative_zero };
    let part = |x: f64, sign: Option<char>| {
        let mut text = write(x, style, wishes);
        if spec.kind.is_ascii_uppercase() {
            text.make_ascii_uppercase();
        }
        lay_out_float(&Spec { fill: ' ', align: '<', width: 0, sign, ..*spec }, &text)
    };
    let bare = spec.kind == '\0';
    let text = if bare && c.re == 0.0 && c.re.is_sign_positive() {
        part(c.im, spec.sign) + "j"
    } else {
        let (open, close) = if bare { ("(", ")") } else { ("", "") };
        format!("{open}{}{}j{close}", part(c.re, spec.sign), part(c.im, Some('+')))
    };
    let (before, after) = spec.padding(text.chars().count());
    Ok(std::iter::repeat_n(spec.fill, before).chain(text.chars()).chain(std::iter::repeat_n(spec.fill, after)).collect())
}

/// Lays out the text of a float: digits are grouped up to the first character that is none.
fn lay_out_float(spec: &Spec, text: &str) -> String {
    let (negative, body) = match text.strip_prefix('-') {
        Some(body) => (true, body),
        None => (false, text),
    };
    let whole = body.bytes().take_while(u8::is_ascii_digit).count();
    lay_out(spec, negative, "", &body[..whole], &body[whole..])
}

/// Puts sign, prefix, grouped digits and what follows them into the width.
fn lay_out(spec: &Spec, negative: bool, prefix: &str, digits: &str, rest: &str) -> String {
    let sign = match spec.sign {
        _ if negative => "-",
        Some('+') => "+",
        Some(' ') => " ",
        _ => "",
    };
    let others = sign.len() + prefix.len() + rest.chars().count();
    let least = if spec.fill == '0' && spec.align == '=' { spec.width.saturating_sub(others) } else { 0 };
    let digits = if digits.is_empty() { String::new() } else { group(digits, spec, least) };
    let (before, after) = spec.padding(others + digits.len());
    let mut out = String::with_capacity(others + digits.len() + (before + after) * spec.fill.len_utf8());
    if spec.align != '=' {
        out.extend(std::iter::repeat_n(spec.fill, before));
    }
    out.push_str(sign);
    out.push_str(prefix);
    if spec.align == '=' {
        out.extend(std::iter::repeat_n(spec.fill, before));
    }
    out.push_str(&digits);
    out.push_str(rest);
    out.extend(std::iter::repeat_n(spec.fill, after));
    out
}

/// Parts the digits into groups, with zeros in front up to a length; a separator never comes first.
fn group(digits: &str, spec: &Spec, least: usize) -> String {
    let Some(separator) = spec.grouping else {
        return std::iter::repeat_n('0', least.saturating_sub(digits.len())).chain(digits.chars()).collect();
    };
    let size = if matches!(spec.kind, 'b' | 'o' | 'x' | 'X') { 4 } else { 3 };
    let mut backwards = Vec::with_capacity(digits.len().max(least) + digits.len().max(least) / size + 1);
    let mut source = digits.bytes().rev();
    let mut placed = 0;
    while let Some(digit) = source.next().or((backwards.len() < least).then_some(b'0')) {
        if placed > 0 && placed % size == 0 {
            backwards.push(separator as u8);
        }
        backwards.push(digit);
        placed += 1;
    }
    backwards.into_iter().rev().map(char::from).collect()
}
