//! Division as Python's floats do it: rounding down, the remainder with the sign of the divisor.

/// `x % y` for y ≠ 0: the sign of y.
pub fn float_mod(x: f64, y: f64) -> f64 {
    float_divmod(x, y).1
}

/// `x // y` for y ≠ 0.
pub fn float_floor_div(x: f64, y: f64) -> f64 {
    float_divmod(x, y).0
}

/// `divmod(x, y)` for y ≠ 0.
pub fn float_divmod(x: f64, y: f64) -> (f64, f64) {
    let mut rest = x % y;
    let mut quotient = (x - rest) / y;
    if rest != 0.0 {
        if (y < 0.0) != (rest < 0.0) {
            rest += y;
            quotient -= 1.0;
        }
    } else {
        rest = 0f64.copysign(y);
    }
    let floor = if quotient != 0.0 {
        let floor = quotient.floor();
        if quotient - floor > 0.5 { floor + 1.0 } else { floor }
    } else {
        0f64.copysign(x / y)
    };
    (floor, rest)
}
