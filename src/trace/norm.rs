//! The length of a vector, as CPython's `math.hypot` computes it: nearly always the correctly rounded one.

/// √(Σ vᵢ²) without overflow or underflow on the way. What [`Op::Hypot`](super::Op::Hypot) means for two numbers.
pub fn norm(vector: &[f64]) -> f64 {
    let max = vector.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    if vector.iter().any(|v| v.is_infinite()) {
        return f64::INFINITY;
    }
    if vector.iter().any(|v| v.is_nan()) {
        return f64::NAN;
    }
    if max == 0.0 || vector.len() <= 1 {
        return max;
    }
    let (_, exponent) = libm::frexp(max);
    let mut sum = Sum { total: 1.0, lost: [0.0; 3] };
    if exponent < -1023 {
        for v in vector {
            let x = v / max;
            sum.add(0, x * x);
        }
        return max * (sum.total - 1.0 + sum.lost[0]).sqrt();
    }
    let scale = libm::ldexp(1.0, -exponent);
    for v in vector {
        let (high, low) = split(v * scale);
        sum.add(0, high * high);
        sum.add(1, 2.0 * high * low);
        sum.lost[2] += low * low;
    }
    let root = sum.value().sqrt();
    let (high, low) = split(root);
    sum.add(0, -high * high);
    sum.add(1, -2.0 * high * low);
    sum.add(2, -low * low);
    (root + sum.value() / (2.0 * root)) / scale
}

/// A compensated sum; the total begins at 1, so that it is larger than all that is added.
struct Sum {
    total: f64,
    lost: [f64; 3],
}

impl Sum {
    fn add(&mut self, part: usize, x: f64) {
        let before = self.total;
        self.total += x;
        self.lost[part] += (before - self.total) + x;
    }

    fn value(&self) -> f64 {
        self.total - 1.0 + (self.lost[0] + self.lost[1] + self.lost[2])
    }
}

/// A float as the sum of two of half as many bits.
fn split(x: f64) -> (f64, f64) {
    let t = x * 134_217_729.0;
    let high = t - (t - x);
    (high, x - high)
}

#[cfg(test)]
mod tests {
    use super::norm;

    #[test]
    fn lengths_of_vectors() {
        assert_eq!(norm(&[3.0, 4.0]), 5.0);
        assert_eq!(norm(&[3.0, 4.0, 5.0]), 7.071_067_811_865_475_5);
        assert_eq!(norm(&[1e300, 1e300]), 1.414_213_562_373_095_2e300);
        assert_eq!(norm(&[5e-324, 5e-324]), 5e-324);
        assert_eq!(norm(&[f64::NAN, f64::NEG_INFINITY]), f64::INFINITY);
        assert!(norm(&[f64::NAN, 1.0]).is_nan());
    }
}
