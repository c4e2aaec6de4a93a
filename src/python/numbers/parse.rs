//! Numbers from text: what `int()`, `float()` and `complex()` take.

use super::convert::MAX_DIGITS;
use crate::python::heap::Complex;
use crate::python::text::unicode;
use num_bigint::BigInt;
use std::borrow::Cow;

/// Why a text is no int.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IntError {
    /// It is not spelled like one.
    Invalid,
    /// It has so many digits, more than may be converted.
    TooManyDigits(usize),
}

/// Decimal digits of all scripts as ASCII, blanks as spaces, without blanks at the ends; anything else beyond ASCII as `?`.
fn to_ascii(text: &str) -> Cow<'_, str> {
    let text = text.trim_matches(unicode::is_space);
    if text.is_ascii() {
        return Cow::Borrowed(text);
    }
    let digit = |c: char| match unicode::decimal(c) {
        Some(d) => char::from(b'0' + d),
        None if c.is_ascii() => c,
        None if unicode::is_space(c) => ' ',
        None => '?',
    };
    Cow::Owned(text.chars().map(digit).collect())
}

/// `int(text, base)`; base 0 asks the text's own prefix.
pub fn parse_int(text: &str, base: u32) -> Result<BigInt, IntError> {
    let text = to_ascii(text);
    let (negative, body) = match text.as_bytes() {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        all => (false, all),
    };
    let prefixed = match body {
        [b'0', b'x' | b'X', ..] => 16,
        [b'0', b'o' | b'O', ..] => 8,
        [b'0', b'b' | b'B', ..] => 2,
        _ => 0,
    };
    let (radix, mut digits) = match base {
        0 if prefixed == 0 => (10, body),
        0 => (prefixed, &body[2..]),
        _ if base == prefixed => (base, &body[2..]),
        _ => (base, body),
    };
    // After a prefix, one underscore may stand before the first digit.
    if digits.len() != body.len() && digits.first() == Some(&b'_') {
        digits = &digits[1..];
    }
    let plain = digits_of(digits, radix).ok_or(IntError::Invalid)?;
    if base == 0 && prefixed == 0 && plain.first() == Some(&b'0') && plain.iter().any(|d| *d != b'0') {
        return Err(IntError::Invalid);
    }
    if !radix.is_power_of_two() && plain.len() > MAX_DIGITS {
        return Err(IntError::TooManyDigits(plain.len()));
    }
    let value = BigInt::parse_bytes(&plain, radix).ok_or(IntError::Invalid)?;
    Ok(if negative { -value } else { value })
}

/// The digits without their underscores, of which each stands between two digits.
fn digits_of(text: &[u8], radix: u32) -> Option<Vec<u8>> {
    let mut plain = Vec::with_capacity(text.len());
    let mut after_digit = false;
    for &c in text {
        if c == b'_' && after_digit {
            after_digit = false;
        } else if char::from(c).is_digit(radix) {
            after_digit = true;
            plain.push(c);
        } else {
            return None;
        }
    }
    after_digit.then_some(plain)
}

/// The text without underscores, of which each stands between two decimal digits.
fn without_underscores(text: &str) -> Option<Cow<'_, str>> {
    if !text.contains('_') {
        return Some(Cow::Borrowed(text));
    }
    let bytes = text.as_bytes();
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    for (i, &c) in bytes.iter().enumerate() {
        if c == b'_' && !(i > 0 && digit(i - 1) && digit(i + 1)) {
            return None;
        }
    }
    Some(Cow::Owned(text.replace('_', "")))
}

/// `float(text)`
pub fn parse_float(text: &str) -> Option<f64> {
    let text = to_ascii(text);
    let text = without_underscores(&text)?;
    let (value, length) = float_prefix(text.as_bytes())?;
    (length == text.len()).then_some(value)
}

/// The longest float at the beginning of a text, and its length in bytes.
fn float_prefix(text: &[u8]) -> Option<(f64, usize)> {
    let signed = usize::from(matches!(text.first(), Some(b'+' | b'-')));
    let body = &text[signed..];
    let named = |name: &[u8]| body.get(..name.len()).is_some_and(|head| head.eq_ignore_ascii_case(name));
    let length = if named(b"infinity") {
        8
    } else if named(b"inf") || named(b"nan") {
        3
    } else {
        decimal_length(body)?
    };
    let literal = std::str::from_utf8(&text[..signed + length]).ok()?;
    Some((literal.parse().ok()?, signed + length))
}

fn decimal_length(body: &[u8]) -> Option<usize> {
    let run = |from: usize| body[from..].iter().take_while(|c| c.is_ascii_digit()).count();
    let whole = run(0);
    let mut end = whole;
    let mut digits = whole;
    if body.get(end) == Some(&b'.') {
        let fraction = run(end + 1);
        digits += fraction;
        end += 1 + fraction;
    }
    if digits == 0 {
        return None;
    }
    if matches!(body.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(body.get(end + 1), Some(b'+' | b'-')));
        let exponent = run((end + 1 + sign).min(body.len()));
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    Some(end)
}

/// Whether a text cannot be a float or complex number for its underscores alone: CPython says that in other words.
pub fn misplaces_underscores(text: &str) -> bool {
    without_underscores(&to_ascii(text)).is_none()
}

/// `complex(text)`
pub fn parse_complex(text: &str) -> Option<Complex> {
    let text = to_ascii(text);
    let text = without_underscores(&text)?;
    let mut body = text.as_ref();
    if let Some(inner) = body.strip_prefix('(') {
        body = inner.strip_suffix(')')?.trim_matches(unicode::is_space);
    }
    let bytes = body.as_bytes();
    let is_j = |i: usize| matches!(bytes.get(i), Some(b'j' | b'J'));
    let sign_at = |i: usize| match bytes.get(i) {
        Some(b'+') => Some(1.0),
        Some(b'-') => Some(-1.0),
        _ => None,
    };
    let (re, im, end) = match float_prefix(bytes) {
        Some((first, length)) if is_j(length) => (0.0, first, length + 1),
        Some((first, length)) => match sign_at(length) {
            Some(sign) => {
                let (im, used) = float_prefix(&bytes[length..]).unwrap_or((sign, 1));
                if !is_j(length + used) {
                    return None;
                }
                (first, im, length + used + 1)
            }
            None => (first, 0.0, length),
        },
        None => {
            let (im, start) = sign_at(0).map_or((1.0, 0), |sign| (sign, 1));
            if !is_j(start) {
                return None;
            }
            (0.0, im, start + 1)
        }
    };
    (end == bytes.len()).then_some(Complex { re, im })
}
