//! True division of ints.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

const MANTISSA: i64 = 53;
const MIN_EXPONENT: i64 = -1021;
const MAX_EXPONENT: i64 = 1024;

/// `a / b`, correctly rounded (half to even) for b ≠ 0; `None` where no float is that large.
pub fn true_divide(a: &BigInt, b: &BigInt) -> Option<f64> {
    let negative = a.is_negative() != b.is_negative();
    let sign = if negative { -1.0 } else { 1.0 };
    if a.is_zero() || b.is_zero() {
        return Some(sign * 0.0);
    }
    let (a, b) = (a.magnitude(), b.magnitude());
    let difference = a.bits() as i64 - b.bits() as i64;
    if difference > MAX_EXPONENT {
        return None;
    }
    if difference < MIN_EXPONENT - MANTISSA - 1 {
        return Some(sign * 0.0);
    }
    // A quotient of two or three bits more than a float has, the last one sticky.
    let shift = difference.max(MIN_EXPONENT) - MANTISSA - 2;
    let (quotient, rest) = if shift <= 0 { (a << (-shift) as u64).div_rem(b) } else { a.div_rem(&(b << shift as u64)) };
    let quotient = quotient.to_u64()? | u64::from(!rest.is_zero());
    // Where the result is subnormal, fewer bits are kept; round here, once.
    let bits = 64 - i64::from(quotient.leading_zeros());
    let extra = bits.max(MIN_EXPONENT - shift) - MANTISSA;
    let half = 1u64 << (extra - 1);
    let rounded = if quotient & half != 0 && quotient & (3 * half - 1) != 0 { quotient + half } else { quotient };
    let value = libm::ldexp((rounded & !(2 * half - 1)) as f64, shift as i32);
    value.is_finite().then_some(sign * value)
}
