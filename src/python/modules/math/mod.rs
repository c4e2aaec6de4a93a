//! `math`. Transcendental functions come from one portable implementation, so their bits are the same on every platform. What the trace
//! has an operation for keeps the handles of traced numbers, guarded where another value could raise; all else pins.

mod float;
mod int;
mod sums;

use super::Item;
use crate::python::native::{ANY, Args, Native};
use crate::python::value::Value;
use crate::trace::Op;
use float::{One, one};

macro_rules! functions {
    ($($static:ident = $native:expr;)*) => { $(static $static: Native = $native.of("math");)* };
}

macro_rules! of_one {
    ($name:literal, $function:expr, $op:expr, $overflows:literal) => {
        Native::function($name, 1, 1, |vm, args| one(vm, args.at(0), One { function: $function, op: $op, overflows: $overflows }))
    };
}

functions! {
    ACOS = of_one!("acos", libm::acos, Some(Op::Acos), false);
    ACOSH = of_one!("acosh", libm::acosh, None, false);
    ASIN = of_one!("asin", libm::asin, Some(Op::Asin), false);
    ASINH = of_one!("asinh", libm::asinh, None, false);
    ATAN = of_one!("atan", libm::atan, Some(Op::Atan), false);
    ATAN2 = Native::function("atan2", 2, 2, float::atan2);
    ATANH = of_one!("atanh", libm::atanh, None, false);
    CBRT = of_one!("cbrt", libm::cbrt, None, false);
    CEIL = Native::function("ceil", 1, 1, float::ceil);
    COMB = Native::function("comb", 2, 2, int::comb);
    COPYSIGN = Native::function("copysign", 2, 2, float::copysign);
    COS = of_one!("cos", libm::cos, Some(Op::Cos), false);
    COSH = of_one!("cosh", libm::cosh, Some(Op::Cosh), true);
    DEGREES = Native::function("degrees", 1, 1, float::degrees);
    DIST = Native::function("dist", 2, 2, sums::dist);
    ERF = of_one!("erf", libm::erf, None, false);
    ERFC = of_one!("erfc", libm::erfc, None, false);
    EXP = of_one!("exp", libm::exp, Some(Op::Exp), true);
    EXP2 = of_one!("exp2", libm::exp2, None, true);
    EXPM1 = of_one!("expm1", libm::expm1, None, true);
    FABS = of_one!("fabs", f64::abs, Some(Op::Abs), false);
    FACTORIAL = Native::function("factorial", 1, 1, int::factorial);
    FLOOR = Native::function("floor", 1, 1, float::floor);
    FMOD = Native::function("fmod", 2, 2, float::fmod);
    FREXP = Native::function("frexp", 1, 1, float::frexp);
    FSUM = Native::function("fsum", 1, 1, sums::fsum);
    GAMMA = Native::function("gamma", 1, 1, float::gamma);
    GCD = Native::function("gcd", 0, ANY, int::gcd);
    HYPOT = Native::function("hypot", 0, ANY, sums::hypot);
    ISCLOSE = Native::function("isclose", 0, ANY, sums::is_close).keywords();
    ISFINITE = Native::function("isfinite", 1, 1, |vm, args| float::classify(vm, args, f64::is_finite));
    ISINF = Native::function("isinf", 1, 1, |vm, args| float::classify(vm, args, f64::is_infinite));
    ISNAN = Native::function("isnan", 1, 1, |vm, args| float::classify(vm, args, f64::is_nan));
    ISQRT = Native::function("isqrt", 1, 1, int::isqrt);
    LCM = Native::function("lcm", 0, ANY, int::lcm);
    LDEXP = Native::function("ldexp", 2, 2, float::ldexp);
    LGAMMA = Native::function("lgamma", 1, 1, float::lgamma);
    LOG = Native::function("log", 0, ANY, float::log);
    LOG10 = Native::function("log10", 1, 1, |vm, args| float::logarithm(vm, args.at(0), libm::log10, None));
    LOG1P = of_one!("log1p", libm::log1p, None, false);
    LOG2 = Native::function("log2", 1, 1, |vm, args| float::logarithm(vm, args.at(0), libm::log2, None));
    MODF = Native::function("modf", 1, 1, float::modf);
    NEXTAFTER = Native::function("nextafter", 2, 2, float::nextafter);
    PERM = Native::function("perm", 1, 2, int::perm);
    POW = Native::function("pow", 2, 2, float::pow);
    PROD = Native::function("prod", 1, ANY, int::prod).keywords();
    RADIANS = Native::function("radians", 1, 1, float::radians);
    REMAINDER = Native::function("remainder", 2, 2, float::remainder);
    SIN = of_one!("sin", libm::sin, Some(Op::Sin), false);
    SINH = of_one!("sinh", libm::sinh, Some(Op::Sinh), true);
    SQRT = of_one!("sqrt", f64::sqrt, Some(Op::Sqrt), false);
    TAN = of_one!("tan", libm::tan, Some(Op::Tan), false);
    TANH = of_one!("tanh", libm::tanh, Some(Op::Tanh), false);
    TRUNC = Native::function("trunc", 1, 1, float::trunc);
    ULP = Native::function("ulp", 1, 1, float::ulp);
}

/// What `import math` brings.
pub const ITEMS: &[(&str, Item)] = &[
    ("acos", Item::Native(&ACOS)),
    ("acosh", Item::Native(&ACOSH)),
    ("asin", Item::Native(&ASIN)),
    ("asinh", Item::Native(&ASINH)),
    ("atan", Item::Native(&ATAN)),
    ("atan2", Item::Native(&ATAN2)),
    ("atanh", Item::Native(&ATANH)),
    ("cbrt", Item::Native(&CBRT)),
    ("ceil", Item::Native(&CEIL)),
    ("comb", Item::Native(&COMB)),
    ("copysign", Item::Native(&COPYSIGN)),
    ("cos", Item::Native(&COS)),
    ("cosh", Item::Native(&COSH)),
    ("degrees", Item::Native(&DEGREES)),
    ("dist", Item::Native(&DIST)),
    ("e", Item::Float(std::f64::consts::E)),
    ("erf", Item::Native(&ERF)),
    ("erfc", Item::Native(&ERFC)),
    ("exp", Item::Native(&EXP)),
    ("exp2", Item::Native(&EXP2)),
    ("expm1", Item::Native(&EXPM1)),
    ("fabs", Item::Native(&FABS)),
    ("factorial", Item::Native(&FACTORIAL)),
    ("floor", Item::Native(&FLOOR)),
    ("fmod", Item::Native(&FMOD)),
    ("frexp", Item::Native(&FREXP)),
    ("fsum", Item::Native(&FSUM)),
    ("gamma", Item::Native(&GAMMA)),
    ("gcd", Item::Native(&GCD)),
    ("hypot", Item::Native(&HYPOT)),
    ("inf", Item::Float(f64::INFINITY)),
    ("isclose", Item::Native(&ISCLOSE)),
    ("isfinite", Item::Native(&ISFINITE)),
    ("isinf", Item::Native(&ISINF)),
    ("isnan", Item::Native(&ISNAN)),
    ("isqrt", Item::Native(&ISQRT)),
    ("lcm", Item::Native(&LCM)),
    ("ldexp", Item::Native(&LDEXP)),
    ("lgamma", Item::Native(&LGAMMA)),
    ("log", Item::Native(&LOG)),
    ("log10", Item::Native(&LOG10)),
    ("log1p", Item::Native(&LOG1P)),
    ("log2", Item::Native(&LOG2)),
    ("modf", Item::Native(&MODF)),
    ("nan", Item::Float(f64::NAN)),
    ("nextafter", Item::Native(&NEXTAFTER)),
    ("perm", Item::Native(&PERM)),
    ("pi", Item::Float(std::f64::consts::PI)),
    ("pow", Item::Native(&POW)),
    ("prod", Item::Native(&PROD)),
    ("radians", Item::Native(&RADIANS)),
    ("remainder", Item::Native(&REMAINDER)),
    ("sin", Item::Native(&SIN)),
    ("sinh", Item::Native(&SINH)),
    ("sqrt", Item::Native(&SQRT)),
    ("tan", Item::Native(&TAN)),
    ("tanh", Item::Native(&TANH)),
    ("tau", Item::Float(std::f64::consts::TAU)),
    ("trunc", Item::Native(&TRUNC)),
    ("ulp", Item::Native(&ULP)),
];

/// The arguments at the first two places.
fn pair(args: &Args<'_>) -> [Value; 2] {
    [args.at(0), args.at(1)]
}
