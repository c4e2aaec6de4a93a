//! Calls of the language's functions.

use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::native::Args;
use crate::python::value::Value;
use crate::python::vm::HostCx;
use crate::scene::terms::{Given, Scalar, Target};
use crate::scene::world::NewObject;

use super::convert::{color, number, text, truth, type_name};
use super::names::Function;
use super::{SceneHost, Thing, raise, vector};
use crate::trace::{Arith as _, Num, Op};

/// The parameters of a function: their names, and how many must be given.
fn parameters(function: Function) -> (&'static [&'static str], usize) {
    match function {
        Function::Object => (&["name", "width", "depth", "height", "support", "color", "dynamic"], 4),
        Function::Door | Function::Window => (&["name", "width", "depth", "height", "color", "support", "dynamic"], 4),
        Function::SetTitle => (&["title"], 1),
        Function::SetSize => (&["width", "depth", "height"], 3),
        Function::SetFloorAsset => (&["asset_name", "color"], 1),
        Function::SetWallAsset => (&["asset_name", "interior", "color"], 1),
        Function::SetCoordinateFrame | Function::Center => (&["o"], 1),
        Function::Opposite => (&["dir"], 1),
        Function::Vec => (&["x", "y", "z"], 3),
    }
}

/// The most parameters that a function has.
const MOST: usize = 7;

/// Arguments by parameter, as a Python function of these parameters takes them; the errors are CPython's.
fn bind(cx: &mut HostCx<'_>, function: Function, args: Args<'_>) -> R<[Option<Value>; MOST]> {
    let ((names, required), called) = (parameters(function), function.name());
    let mut bound = [None; MOST];
    let type_error = |cx: &mut HostCx<'_>, message: String| -> Raise { cx.error(Builtin::TypeError, message) };
    for (slot, value) in bound[..names.len()].iter_mut().zip(args.pos) {
        *slot = Some(*value);
    }
    for (symbol, value) in args.kw {
        let name = cx.symbols.text(*symbol);
        match names.iter().position(|known| *known == name) {
            None => {
                let message = format!("{called}() got an unexpected keyword argument '{name}'");
                return Err(type_error(cx, message));
            }
            Some(index) if bound[index].is_some() => {
                let message = format!("{called}() got multiple values for argument '{name}'");
                return Err(type_error(cx, message));
            }
            Some(index) => bound[index] = Some(*value),
        }
    }
    if args.pos.len() > names.len() {
        let takes = if required == names.len() { required.to_string() } else { format!("from {required} to {}", names.len()) };
        let plural = if names.len() == 1 { "" } else { "s" };
        let given = args.pos.len();
        return Err(type_error(cx, format!("{called}() takes {takes} positional argument{plural} but {given} were given")));
    }
    let missing: Vec<String> = (0..required).filter(|index| bound[*index].is_none()).map(|index| format!("'{}'", names[index])).collect();
    let listed = match &missing[..] {
        [] => return Ok(bound),
        [one] => one.clone(),
        [one, two] => format!("{one} and {two}"),
        [head @ .., last] => format!("{}, and {last}", head.join(", ")),
    };
    let plural = if missing.len() == 1 { "" } else { "s" };
    Err(type_error(cx, format!("{called}() missing {} required positional argument{plural}: {listed}", missing.len())))
}

impl SceneHost {
    pub(super) fn call_function(&mut self, cx: &mut HostCx<'_>, function: Function, args: Args<'_>) -> R<Value> {
        let bound = bind(cx, function, args)?;
        let at = |index: usize| bound[index].unwrap_or(Value::None);
        match function {
            Function::Object => return self.declare(cx, function, &bound, at(4), at(5), at(6)),
            Function::Door | Function::Window => return self.declare(cx, function, &bound, at(5), at(4), at(6)),
            Function::SetTitle => {
                let title = text(cx, at(0));
                self.world.set_title(&title);
            }
            Function::SetSize => {
                let dims = [number(cx, at(0))?, number(cx, at(1))?, number(cx, at(2))?];
                self.world.set_size(cx.trace, &dims).map_err(|error| raise(cx, error))?;
            }
            Function::SetFloorAsset => {
                let (asset, color, origin) = (text(cx, at(0)), color(cx, bound[1]), self.origin(cx));
                self.world.set_floor_asset(&asset, color.as_deref(), origin);
            }
            Function::SetWallAsset => {
                let interior = bound[1].is_none_or(|value| truth(cx, value));
                let (asset, color, origin) = (text(cx, at(0)), color(cx, bound[2]), self.origin(cx));
                self.world.set_wall_asset(&asset, interior, color.as_deref(), origin);
            }
            Function::SetCoordinateFrame => self.set_frame(cx, at(0))?,
            Function::Center => return Ok(at(0)),
            Function::Opposite => return opposite(cx, at(0)),
            Function::Vec => return Ok(vector::record(cx, [at(0), at(1), at(2)])),
        }
        Ok(Value::None)
    }

    fn declare(
        &mut self,
        cx: &mut HostCx<'_>,
        function: Function,
        bound: &[Option<Value>; MOST],
        support: Value,
        color_given: Value,
        dynamic: Value,
    ) -> R<Value> {
        let Some(Value::Str(name)) = bound[0] else {
            let given = type_name(cx, bound[0].unwrap_or(Value::None));
            return Err(cx.error(Builtin::TypeError, format!("{}() takes a name as text, not {given}", function.name())));
        };
        let name = cx.heap[name].text.to_string();
        let dim = |cx: &mut HostCx<'_>, index: usize| number(cx, bound[index].unwrap_or(Value::None));
        let dims = [dim(cx, 1)?, dim(cx, 2)?, dim(cx, 3)?];
        let is_given = |index: usize| bound[index].is_some();
        let standing = function == Function::Object && !is_given(4);
        let support = if standing { Given::from(Scalar::int(0)) } else { number(cx, support)? };
        if let Given::Number(support) = &support {
            cx.trace.pin(support.num);
        }
        let (color, dynamic) = (color(cx, Some(color_given)), truth(cx, dynamic));
        let new = NewObject { kind: function.kind(), name: &name, dims, support, color: color.as_deref(), dynamic };
        let origin = self.origin(cx);
        let id = self.world.add_object(cx.trace, &new, origin).map_err(|error| raise(cx, error))?;
        Ok(Thing::Target(Target::Object(id)).value())
    }

    fn set_frame(&mut self, cx: &mut HostCx<'_>, value: Value) -> R<()> {
        let Some(Thing::Target(target)) = Thing::of(value) else {
            let message = format!("set_coordinate_frame() takes an object or the scene, not {}", type_name(cx, value));
            return Err(cx.error(Builtin::TypeError, message));
        };
        self.world.set_frame(cx.trace, target);
        Ok(())
    }
}

/// `(dir + 2) % 4`
fn opposite(cx: &mut HostCx<'_>, value: Value) -> R<Value> {
    let turns = match value {
        Value::Bool(turns) => i64::from(turns),
        Value::Int(turns, _) => turns,
        Value::Float(turns, _) => {
            let Given::Number(number) = number(cx, value)? else { return Ok(Value::None) };
            cx.trace.pin(number.num);
            return Ok(Value::float(crate::python::numbers::float_mod(turns + 2.0, 4.0)));
        }
        _ => {
            let message = format!("opposite() takes a direction, not {}", type_name(cx, value));
            return Err(cx.error(Builtin::TypeError, message));
        }
    };
    let opposite = (turns.rem_euclid(4) + 2) % 4;
    let Given::Number(number) = number(cx, value)? else { return Ok(Value::int(opposite)) };
    if turns.unsigned_abs() >= 1 << 50 {
        cx.trace.pin(number.num);
    }
    let magnitude = cx.trace.unary(Op::Abs, number.num, number.num.value.abs());
    cx.trace.order(Num { value: number.num.value.abs(), handle: magnitude }, Num::plain(1e15));
    let turned = cx.trace.compute(Op::Add, number.num, Num::plain(2.0));
    let handle = cx.trace.compute(Op::Mod, turned, Num::plain(4.0)).handle;
    Ok(Value::Int(opposite, handle))
}
