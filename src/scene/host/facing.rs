//! `o.facing = …`

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::value::Value;
use crate::python::vm::HostCx;
use crate::scene::terms::{Anchor, Axis, Given, ObjectId, Target};
use crate::scene::world::FacingSpec;
use crate::trace::{AS_WRITTEN, Handle, Num};

use super::convert::{number, scalar, type_name};
use super::{SceneHost, Thing, raise};

impl SceneHost {
    pub(super) fn face(&mut self, cx: &mut HostCx<'_>, id: ObjectId, value: Value) -> R<()> {
        let spec = self.facing_spec(cx, id, value)?;
        let origin = self.origin(cx);
        let site = match value {
            Value::Host(object) => object.site,
            _ => Handle::NONE,
        };
        if let FacingSpec::Point(_) = spec {
            // What was read for the point settled its object.
            cx.trace.pin(Num { value: AS_WRITTEN, handle: site });
        }
        self.world.set_facing(cx.trace, id, &spec, site, origin).map_err(|error| raise(cx, error))
    }

    fn facing_spec(&mut self, cx: &mut HostCx<'_>, id: ObjectId, value: Value) -> R<FacingSpec> {
        match Thing::of(value) {
            Some(Thing::Target(target)) => return Ok(FacingSpec::Toward(target)),
            Some(Thing::Part(target, Anchor::Center)) => return Ok(FacingSpec::CenterOf(target)),
            Some(Thing::Part(target, anchor)) => {
                let [x, y] = [Axis::X, Axis::Y].map(|axis| self.world.read(cx.trace, target, anchor, axis).num);
                return Ok(FacingSpec::Point([x, y]));
            }
            Some(Thing::Function(_)) => return Err(self.no_facing(cx, id, value)),
            None => {}
        }
        if value.is_none() {
            return Ok(FacingSpec::Nothing);
        }
        if let Some(items) = self.sequence(cx, value) {
            let [x, y, ..] = items[..] else {
                return Err(cx.error(Builtin::IndexError, "tuple index out of range"));
            };
            let coordinate = |value| if let Value::Bool(truth) = value { scalar(Value::int(truth.into())) } else { scalar(value) };
            return match (coordinate(x), coordinate(y)) {
                (Some(x), Some(y)) => Ok(FacingSpec::Point([x.num, y.num])),
                _ => Err(self.no_facing(cx, id, value)),
            };
        }
        match number(cx, value)? {
            Given::Number(number) => Ok(FacingSpec::Number(number)),
            Given::Other { .. } => Err(self.no_facing(cx, id, value)),
        }
    }

    fn no_facing(&self, cx: &mut HostCx<'_>, id: ObjectId, value: Value) -> crate::python::error::Raise {
        let name = self.world.name(Target::Object(id));
        let message = format!("{name}.facing takes a direction, an object or a point, not {}", type_name(cx, value));
        cx.error(Builtin::TypeError, message)
    }
}
