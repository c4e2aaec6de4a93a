//! What CPython 3.11 answers, as recorded by `record.py`, for unit tests.

use num_bigint::BigInt;
use serde::de::DeserializeOwned;

/// The rows of a table.
pub fn rows<T: DeserializeOwned>(table: &str) -> Vec<T> {
    serde_json::from_str(table).expect("a recorded table is JSON")
}

/// A float from its bits in decimal.
pub fn float(bits: &str) -> f64 {
    f64::from_bits(bits.parse().expect("the bits of a float"))
}

/// A float's bits in decimal, all NaNs alike.
pub fn bits(x: f64) -> String {
    if x.is_nan() { f64::NAN.to_bits().to_string() } else { x.to_bits().to_string() }
}

/// An int from its decimal digits.
pub fn int(text: &str) -> BigInt {
    text.parse().expect("an int")
}
