//! Floats in decimal: CPython's `PyOS_double_to_string`.

use crate::python::heap::Complex;

/// More decimals than this are zeros in every float.
const MOST_DECIMALS: usize = 1100;

/// A finite, non-negative float in decimal: 0.DIGITS × 10^point.
struct Decimal {
    /// Without zeros at either end; `0` for zero.
    digits: Vec<u8>,
    point: i64,
}

impl Decimal {
    fn from_exponential(text: &str) -> Decimal {
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let mut digits: Vec<u8> = mantissa.bytes().filter(u8::is_ascii_digit).collect();
        while digits.len() > 1 && digits.last() == Some(&b'0') {
            digits.pop();
        }
        Decimal { digits, point: exponent.parse().unwrap_or(0) + 1 }
    }

    /// The shortest that reads back as the same float, and of those the nearest; where two are, the one with an even last digit.
    fn shortest(x: f64) -> Decimal {
        let text = format!("{x:e}");
        let shortest = Decimal::from_exponential(&text);
        // Two of fewer digits are never as near.
        if shortest.digits.len() >= 16 {
            let even = format!("{x:.*e}", shortest.digits.len() - 1);
            if even != text && even.parse() == Ok(x) {
                return Decimal::from_exponential(&even);
            }
        }
        shortest
    }

    /// The nearest of `n` significant digits.
    fn significant(x: f64, n: usize) -> Decimal {
        Decimal::from_exponential(&format!("{x:.*e}", n.clamp(1, MOST_DECIMALS) - 1))
    }

    /// The nearest with `n` decimals.
    fn decimals(x: f64, n: usize) -> Decimal {
        let text = format!("{x:.*}", n.min(MOST_DECIMALS));
        let whole = text.find('.').unwrap_or(text.len());
        let digits: Vec<u8> = text.bytes().filter(u8::is_ascii_digit).collect();
        let zeros = digits.iter().take_while(|d| **d == b'0').count();
        let end = digits.iter().rposition(|d| *d != b'0').map_or(zeros, |last| last + 1);
        if zeros == digits.len() {
            return Decimal { digits: vec![b'0'], point: 1 };
        }
        Decimal { digits: digits[zeros..end].to_vec(), point: whole as i64 - zeros as i64 }
    }
}

/// What a float looks like, beside its sign.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Style {
    /// `e`: so many decimals and an exponent.
    Exponent(usize),
    /// `f`: so many decimals.
    Fixed(usize),
    /// `g`: so many significant digits, without zeros at the end.
    General(usize),
    /// `repr`
    Shortest,
}

/// Further wishes.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Wishes {
    /// `#`: keep the decimal point and the zeros.
    pub alternate: bool,
    /// At least one decimal.
    pub dot_zero: bool,
    /// `z`: no sign where all digits are zeros.
    pub no_negative_zero: bool,
}

/// The text of a float, with a `-` where it is negative.
pub(super) fn write(x: f64, style: Style, wishes: Wishes) -> String {
    if x.is_nan() {
        return "nan".into();
    }
    if x.is_infinite() {
        return if x > 0.0 { "inf".into() } else { "-inf".into() };
    }
    let magnitude = x.abs();
    let (decimal, decimals, exponential) = match style {
        Style::Exponent(n) => (Decimal::significant(magnitude, n.saturating_add(1)), n as i64 + 1, true),
        Style::Fixed(n) => {
            let decimal = Decimal::decimals(magnitude, n);
            let end = decimal.point.saturating_add(n as i64);
            (decimal, end, false)
        }
        Style::General(n) => {
            let n = n.max(1);
            let decimal = Decimal::significant(magnitude, n);
            let exponential = decimal.point <= -4 || decimal.point > n as i64 - i64::from(wishes.dot_zero);
            let end = if wishes.alternate { n as i64 } else { decimal.digits.len() as i64 };
            (decimal, end, exponential)
        }
        Style::Shortest => {
            let decimal = Decimal::shortest(magnitude);
            let exponential = decimal.point <= -4 || decimal.point > 16;
            let end = decimal.digits.len() as i64;
            (decimal, end, exponential)
        }
    };
    let zero = decimal.digits == b"0";
    let negative = x.is_sign_negative() && !(wishes.no_negative_zero && zero);
    let mut out = String::new();
    if negative {
        out.push('-');
    }
    lay_out(&mut out, &decimal, decimals, exponential, wishes);
    out
}

/// Writes the digits up to place `end`, counted from the first.
fn lay_out(out: &mut String, decimal: &Decimal, end: i64, exponential: bool, wishes: Wishes) {
    let (point, exponent) = if exponential { (1, Some(decimal.point - 1)) } else { (decimal.point, None) };
    let start = if point <= 0 { point - 1 } else { 0 };
    let end = end.max(if !exponential && wishes.dot_zero { point + 1 } else { point });
    let digit = |i: i64| usize::try_from(i).ok().and_then(|i| decimal.digits.get(i)).map_or('0', |d| char::from(*d));
    for i in start..end {
        if i == point {
            out.push('.');
        }
        out.push(digit(i));
    }
    if end == point && wishes.alternate {
        out.push('.');
    }
    if let Some(exponent) = exponent {
        let sign = if exponent < 0 { '-' } else { '+' };
        out.push_str(&format!("e{sign}{:02}", exponent.abs()));
    }
}

/// `repr(x)`: the shortest text that reads back as the same float.
pub fn float_repr(x: f64) -> String {
    write(x, Style::Shortest, Wishes { dot_zero: true, ..Wishes::default() })
}

/// `repr(c)`
pub fn complex_repr(c: Complex) -> String {
    let part = |x| write(x, Style::Shortest, Wishes::default());
    if c.re == 0.0 && c.re.is_sign_positive() {
        return part(c.im) + "j";
    }
    let im = part(c.im);
    let sign = if im.starts_with('-') { "" } else { "+" };
    format!("({}{sign}{im}j)", part(c.re))
}
