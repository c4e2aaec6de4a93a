//! The replay table: every operation that a traced number survives.

/// An operation on floats. What Python computes on ints that came from floats is here too, as the float of the same value; whoever
/// records it makes sure that the int is exact (below 2⁵³).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs)]
pub enum Op {
    Add,
    Sub,
    Mul,
    /// `/`; a zero denominator raises, so it is guarded by whoever records it.
    Div,
    /// `//` of Python: rounds down.
    FloorDiv,
    /// `%` of Python: the sign of the divisor.
    Mod,
    /// `**`; what raises or turns complex is guarded by whoever records it.
    Pow,
    Neg,
    Abs,
    /// `min(a, b)` of Python: `a` unless `b` is less.
    Min,
    /// `max(a, b)` of Python: `a` unless `b` is greater.
    Max,
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Log,
    Hypot,
    Radians,
    Degrees,
    Floor,
    Ceil,
    Trunc,
    /// `round(x)`: to even.
    Round,
    Fmod,
    Copysign,
    /// `a` unless it is negative, else `b`: what stands in place of a direction, or the direction as it is written.
    Override,
    /// `int → float` and back where nothing is lost.
    Same,
}
