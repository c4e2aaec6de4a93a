//! Between Python's values and the numbers of the scene.

use num_traits::ToPrimitive as _;

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::text::repr_str;
use crate::python::value::Value;
use crate::python::vm::HostCx;
use crate::scene::terms::{Given, Scalar};
use crate::trace::Num;

/// A number of the scene as Python has it.
pub(super) fn scalar_value(scalar: Scalar) -> Value {
    let Num { value, handle } = scalar.num;
    if scalar.int { Value::Int(value as i64, handle) } else { Value::Float(value, handle) }
}

/// The float or small int that a value is.
pub(super) fn scalar(value: Value) -> Option<Scalar> {
    match value {
        Value::Int(value, handle) => Some(Scalar { num: Num { value: value as f64, handle }, int: true }),
        Value::Float(value, handle) => Some(Scalar { num: Num { value, handle }, int: false }),
        _ => None,
    }
}

/// A value where a number is wanted; OverflowError for an int beyond all floats.
pub(super) fn number(cx: &mut HostCx<'_>, value: Value) -> R<Given> {
    if let Some(scalar) = scalar(value) {
        return Ok(scalar.into());
    }
    if let Value::Big(big) = value {
        return match cx.heap[big].to_f64().filter(|value| value.is_finite()) {
            Some(value) => Ok(Scalar::float(value).into()),
            None => Err(cx.error(Builtin::OverflowError, "int too large to convert to float")),
        };
    }
    Ok(Given::Other { type_name: type_name(cx, value), repr: shown(cx, value) })
}

/// `type(value).__name__`
pub(super) fn type_name(cx: &HostCx<'_>, value: Value) -> String {
    let class = match value {
        Value::Instance(instance) => cx.heap[instance].class,
        Value::None | Value::Undefined => return "NoneType".into(),
        Value::Bool(_) => return "bool".into(),
        Value::Int(..) | Value::Big(_) => return "int".into(),
        Value::Float(..) => return "float".into(),
        Value::Complex(_) => return "complex".into(),
        Value::Str(_) => return "str".into(),
        Value::Bytes(_) => return "bytes".into(),
        Value::Tuple(_) => return "tuple".into(),
        Value::List(_) => return "list".into(),
        Value::Dict(_) => return "dict".into(),
        Value::Set(_) => return "set".into(),
        Value::FrozenSet(_) => return "frozenset".into(),
        Value::Range(_) => return "range".into(),
        Value::Function(_) => return "function".into(),
        Value::Native(_) => return "builtin_function_or_method".into(),
        Value::Method(_) => return "method".into(),
        Value::Class(_) => return "type".into(),
        Value::Generator(_) => return "generator".into(),
        Value::Module(_) => return "module".into(),
        Value::Record(_) => return "Vec".into(),
        Value::Host(_) => return host_type_name(value).into(),
        _ => return "object".into(),
    };
    match cx.heap[class].name {
        Value::Str(name) => cx.heap[name].text.to_string(),
        _ => "object".into(),
    }
}

fn host_type_name(value: Value) -> &'static str {
    use super::{Target, Thing};
    match Thing::of(value) {
        Some(Thing::Target(Target::Scene)) => "Scene",
        Some(Thing::Target(Target::Object(_))) => "Object",
        Some(Thing::Part(..)) => "vec3",
        _ => "function",
    }
}

/// A value for a message or a vector's repr: numbers and texts as `repr` shows them, others by their type. A number that is
/// shown decides what the program reads, so its value is pinned.
pub(super) fn shown(cx: &mut HostCx<'_>, value: Value) -> String {
    match value {
        Value::Int(..) | Value::Float(..) => scalar(value).map_or_else(String::new, |scalar| {
            cx.trace.pin(scalar.num);
            if let Value::Int(int, _) = value { int.to_string() } else { scalar.shown() }
        }),
        Value::None => "None".into(),
        Value::Bool(truth) => if truth { "True" } else { "False" }.into(),
        Value::Str(text) => repr_str(&cx.heap[text].text),
        other => format!("<{}>", type_name(cx, other)),
    }
}

/// The text of a value where a text is wanted: a `str` as it is, others as they are shown.
pub(super) fn text(cx: &mut HostCx<'_>, value: Value) -> String {
    match value {
        Value::Str(text) => cx.heap[text].text.to_string(),
        other => shown(cx, other),
    }
}

/// The text of a color; nothing for `None`.
pub(super) fn color(cx: &mut HostCx<'_>, value: Option<Value>) -> Option<String> {
    value.filter(|value| !value.is_none()).map(|value| text(cx, value))
}

/// Whether Python takes a value for true; what has no evident emptiness is.
pub(super) fn truth(cx: &mut HostCx<'_>, value: Value) -> bool {
    match value {
        Value::None => false,
        Value::Bool(truth) => truth,
        Value::Int(..) | Value::Float(..) => scalar(value).is_some_and(|scalar| {
            cx.trace.zero(scalar.num);
            scalar.value() != 0.0
        }),
        Value::Str(text) => !cx.heap[text].text.is_empty(),
        Value::Tuple(tuple) => !cx.heap[tuple].0.is_empty(),
        Value::List(list) => !cx.heap[list].0.is_empty(),
        _ => true,
    }
}
