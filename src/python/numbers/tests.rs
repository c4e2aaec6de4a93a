//! Against what CPython answered.

use super::*;
use crate::python::recorded::{bits, float, int, rows};

#[test]
fn ints_divide_to_the_nearest_float() {
    for (a, b, expected) in rows::<(String, String, String)>(include_str!("../recorded/divide.json")) {
        match true_divide(&int(&a), &int(&b)) {
            Some(quotient) => assert_eq!(bits(quotient), expected, "{a} / {b}"),
            None => assert_eq!(expected, "OverflowError: integer division result too large for a float", "{a} / {b}"),
        }
    }
}

#[test]
fn floats_round_as_their_exact_decimals_do() {
    for (x, digits, expected) in rows::<(String, i64, String)>(include_str!("../recorded/round.json")) {
        match round_float(float(&x), digits) {
            Some(rounded) => assert_eq!(bits(rounded), expected, "round({:?}, {digits})", float(&x)),
            None => assert_eq!(expected, "OverflowError: rounded value too large to represent", "round({:?}, {digits})", float(&x)),
        }
    }
}

#[test]
fn floats_divide_with_the_sign_of_the_divisor() {
    for (x, y, quotient, rest) in rows::<(String, String, String, String)>(include_str!("../recorded/divmod.json")) {
        let (q, r) = float_divmod(float(&x), float(&y));
        assert_eq!((bits(q), bits(r)), (quotient, rest), "divmod({:?}, {:?})", float(&x), float(&y));
    }
}

#[test]
fn equal_numbers_have_equal_hashes() {
    for (x, expected) in rows::<(String, i64)>(include_str!("../recorded/hash_float.json")) {
        assert_eq!(hash_float(float(&x)), expected, "hash({:?})", float(&x));
    }
    for (n, expected) in rows::<(String, i64)>(include_str!("../recorded/hash_int.json")) {
        assert_eq!(hash_big(&int(&n)), expected, "hash({n})");
    }
}

#[test]
fn ints_are_read_in_every_base() {
    for (text, base, expected) in rows::<(String, u32, String)>(include_str!("../recorded/parse_int.json")) {
        match parse_int(&text, base) {
            Ok(value) => assert_eq!(format!("{value:#x}"), expected, "{text:?} in base {base}"),
            Err(IntError::Invalid) => assert!(expected.starts_with("ValueError: invalid literal"), "{text:?} in base {base}: {expected}"),
            Err(IntError::TooManyDigits(n)) => assert!(expected.contains(&format!("value has {n} digits")), "{text:?}: {expected}"),
        }
    }
}

#[test]
fn floats_and_complex_numbers_are_read() {
    for (text, expected) in rows::<(String, String)>(include_str!("../recorded/parse_float.json")) {
        match parse_float(&text) {
            Some(value) => assert_eq!(bits(value), expected, "{text:?}"),
            None => assert!(expected.starts_with("ValueError"), "{text:?}: {expected}"),
        }
    }
    for (text, expected) in rows::<(String, String)>(include_str!("../recorded/parse_complex.json")) {
        match parse_complex(&text) {
            Some(c) => assert_eq!(format!("{} {}", bits(c.re), bits(c.im)), expected, "{text:?}"),
            None => assert!(expected.starts_with("ValueError"), "{text:?}: {expected}"),
        }
    }
}

#[test]
fn long_ints_are_not_written() {
    assert_eq!(int_to_string(&-BigInt::from(10).pow(4299)).map(|t| t.len()), Ok(4301));
    assert_eq!(int_to_string(&BigInt::from(10).pow(4300)), Err(TooManyDigits));
}
