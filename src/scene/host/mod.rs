//! The scene as a Python program sees it: the names that every program has, objects, and vectors.
//!
//! Implements the interpreter's [`Host`] on a [`World`]. What things mean is the world's business; here Python's values are turned into
//! numbers and back, calls into arguments, and errors into exceptions.

mod args;
mod convert;
mod facing;
mod names;
mod paths;
mod run;
mod vector;

pub use paths::{bound_in_loops, name_after_globals};
pub use run::{Run, run, run_unnamed};

use std::sync::Arc;

use smallvec::SmallVec;

use crate::python::classes::Builtin;
use crate::python::code::Program;
use crate::python::error::{R, Raise};
use crate::python::heap::Heap;
use crate::python::host::{Host, HostName};
use crate::python::native::Args;
use crate::python::value::{BinaryOp, HostObject, UnaryOp, Value};
use crate::python::vm::{HostCx, PathStep};
use crate::trace::{Arith, Handle};

use super::error::SceneError;
use super::frame::Frame;
use super::layout::Layout;
use super::names::{Label, Node, Root};
use super::origin::{Origin, OriginId, Source, StepKind};
use super::template::{Declared, Template};
use super::terms::{Anchor, Axis, ObjectId, Target};
use super::world::World;

use convert::{number, scalar_value, shown, type_name};
use names::Function;

/// What a [`HostObject`] of the scene is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Thing {
    /// The scene or an object.
    Target(Target),
    /// `o.center`, `o.min`, `o.max`: bound to what it was read from.
    Part(Target, Anchor),
    /// A function of the language.
    Function(Function),
}

const SCENE: u16 = 0;
const OBJECT: u16 = 1;
const SCENE_PART: u16 = 2;
const OBJECT_PART: u16 = 3;
const FUNCTION: u16 = 4;

/// The kind of record that a vector is.
const VECTOR: u16 = 0;

impl Thing {
    fn of(value: Value) -> Option<Thing> {
        let Value::Host(HostObject { kind, part, id, .. }) = value else { return None };
        let anchor = || Anchor::ALL.get(usize::from(part)).copied();
        Some(match kind {
            SCENE => Thing::Target(Target::Scene),
            OBJECT => Thing::Target(Target::Object(ObjectId(id))),
            SCENE_PART => Thing::Part(Target::Scene, anchor()?),
            OBJECT_PART => Thing::Part(Target::Object(ObjectId(id)), anchor()?),
            _ => Thing::Function(*Function::ALL.get(id as usize)?),
        })
    }

    fn value(self) -> Value {
        let host = |kind, part, id| Value::Host(HostObject { kind, part, id, site: Handle::NONE });
        match self {
            Thing::Target(Target::Scene) => host(SCENE, 0, 0),
            Thing::Target(Target::Object(id)) => host(OBJECT, 0, id.0),
            Thing::Part(Target::Scene, anchor) => host(SCENE_PART, anchor as u8, 0),
            Thing::Part(Target::Object(id), anchor) => host(OBJECT_PART, anchor as u8, id.0),
            Thing::Function(function) => host(FUNCTION, 0, function as u32),
        }
    }
}

/// A scene under construction by a program. See the [module](self).
#[derive(Debug, Default)]
pub struct SceneHost {
    world: World,
    /// The variables of the sidecar template.
    variables: Vec<(String, Declared)>,
    /// The frame before the statement that is running.
    frame: Option<Frame>,
}

impl SceneHost {
    /// An empty scene.
    pub fn new() -> SceneHost {
        SceneHost::default()
    }

    /// A scene whose objects a sidecar declares.
    pub fn with_template(template: &Template) -> Result<SceneHost, SceneError> {
        let mut world = World::new();
        let variables = template.declare(&mut world)?;
        let variables = variables.into_iter().map(|(name, declared)| (name.to_owned(), declared)).collect();
        Ok(SceneHost { world, variables, frame: None })
    }

    /// The world so far.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// Settles everything and gives the layout. `roots` are the globals that lead to objects, as [`name_after_globals`] finds them.
    pub fn into_layout<R: Arith + ?Sized>(self, rec: &mut R, mut roots: Vec<Root>) -> Layout {
        let rebound = |name: &str| roots.iter().any(|root| root.name == name);
        let variables: Vec<Root> = self.variables.iter().filter(|(name, _)| !rebound(name)).map(template_root).collect();
        roots.splice(0..0, variables);
        let mut layout = self.world.into_layout(rec);
        super::names::name_objects(&mut layout, &roots);
        layout
    }

    /// Where the program stands.
    fn origin(&mut self, cx: &HostCx<'_>) -> OriginId {
        let origins = &mut self.world.origins;
        let mut inside = None;
        let range = cx.walk(&mut |step| {
            inside = match step {
                PathStep::Call { range, function } => origins.step(inside, range, 0, || StepKind::Call { function: function.into() }),
                PathStep::Loop { range, iteration, variable, value } => origins.step(inside, range, iteration, || {
                    let value = cx.show(value);
                    let variable = if value.is_empty() { "" } else { variable };
                    StepKind::Loop { variable: variable.into(), value: value.into() }
                }),
            };
        });
        origins.intern(Origin { source: Source::Program, range, inside })
    }

    fn read(&mut self, cx: &mut HostCx<'_>, target: Target, anchor: Anchor, axis: Axis) -> Value {
        scalar_value(self.world.read(cx.trace, target, anchor, axis))
    }

    /// `o.center` as x, y, z.
    fn read_all(&mut self, cx: &mut HostCx<'_>, target: Target, anchor: Anchor) -> [Value; 3] {
        Axis::ALL.map(|axis| self.read(cx, target, anchor, axis))
    }

    fn write(&mut self, cx: &mut HostCx<'_>, target: Target, anchor: Anchor, axis: Axis, value: Value) -> R<()> {
        let given = number(cx, value)?;
        let origin = self.origin(cx);
        self.world.write(cx.trace, target, anchor, axis, &given, origin).map_err(|error| raise(cx, error))
    }

    /// `o.center = (x, y, z)`
    fn write_all(&mut self, cx: &mut HostCx<'_>, target: Target, anchor: Anchor, value: Value) -> R<()> {
        let Some(items) = self.sequence(cx, value) else {
            let message = format!("'{}' object is not iterable", type_name(cx, value));
            return Err(cx.error(Builtin::TypeError, message));
        };
        let [x, y, z] = items[..] else {
            let message = format!("{} takes three coordinates, not {}", anchor.name(), items.len());
            return Err(cx.error(Builtin::ValueError, message));
        };
        for (axis, value) in Axis::ALL.into_iter().zip([x, y, z]) {
            self.write(cx, target, anchor, axis, value)?;
        }
        Ok(())
    }

    /// The items of a vector, a tuple or a list.
    fn sequence(&mut self, cx: &mut HostCx<'_>, value: Value) -> Option<SmallVec<[Value; 4]>> {
        match value {
            Value::Tuple(tuple) => Some(SmallVec::from_slice(&cx.heap[tuple].0)),
            Value::List(list) => Some(SmallVec::from_slice(&cx.heap[list].0)),
            Value::Record(record) => Some(SmallVec::from_slice(&cx.heap[record].items)),
            _ => match Thing::of(value) {
                Some(Thing::Part(target, anchor)) => Some(SmallVec::from_slice(&self.read_all(cx, target, anchor))),
                _ => None,
            },
        }
    }

    /// How messages call it: an object by the repr of its category.
    fn called(&self, target: Target) -> String {
        match target {
            Target::Scene => "scene".into(),
            Target::Object(_) => crate::python::text::repr_str(self.world.name(target)),
        }
    }

    fn target_attr(&mut self, cx: &mut HostCx<'_>, target: Target, name: &str) -> R<Value> {
        if let Some(anchor) = Anchor::from_name(name) {
            return Ok(Thing::Part(target, anchor).value());
        }
        let [width, depth, height] = self.world.dims(target).map(scalar_value);
        Ok(match name {
            "width" => width,
            "depth" => depth,
            "height" => height,
            "facing" => scalar_value(self.world.facing(cx.trace, target)),
            "name" => cx.heap.str(self.world.name(target)),
            "support" => Value::int(self.world.support(target) as i64),
            _ => {
                let message = format!("{} has no attribute {}", self.called(target), crate::python::text::repr_str(name));
                return Err(cx.error(Builtin::AttributeError, message));
            }
        })
    }
}

fn template_root((name, declared): &(String, Declared)) -> Root {
    let node = match declared {
        Declared::One(id) => Node::Object(*id),
        Declared::Many(ids) => Node::Group(ids.iter().enumerate().map(|(index, id)| (Label::Index(index), Node::Object(*id))).collect()),
    };
    Root { name: name.clone(), node }
}

/// The exception for an error of the scene.
fn raise(cx: &mut HostCx<'_>, error: SceneError) -> Raise {
    let class = Builtin::by_name(error.exception).unwrap_or(Builtin::RuntimeError);
    cx.error(class, error.message)
}

fn no_component(cx: &mut HostCx<'_>, name: &str) -> Raise {
    let message = format!("a vec3 has x, y and z, not {}", crate::python::text::repr_str(name));
    cx.error(Builtin::AttributeError, message)
}

impl Host for SceneHost {
    fn lookup(&mut self, cx: &mut HostCx<'_>, name: &str) -> Option<HostName> {
        if let Some((_, declared)) = self.variables.iter().find(|(variable, _)| variable == name) {
            let object = |id: ObjectId| Thing::Target(Target::Object(id)).value();
            return Some(HostName::Value(match declared {
                Declared::One(id) => object(*id),
                Declared::Many(ids) => cx.heap.list(ids.iter().map(|id| object(*id)).collect()),
            }));
        }
        names::lookup(name)
    }

    fn names(&self) -> Vec<&'static str> {
        names::all().collect()
    }

    fn module(&self, name: &str) -> Option<Arc<Program>> {
        names::module(name)
    }

    fn type_name(&self, _: &Heap, object: Value) -> &'static str {
        match Thing::of(object) {
            Some(Thing::Target(Target::Scene)) => "Scene",
            Some(Thing::Target(Target::Object(_))) => "Object",
            Some(Thing::Part(..)) => "vec3",
            Some(Thing::Function(_)) => "function",
            None => "Vec",
        }
    }

    fn type_names(&self) -> &'static [&'static str] {
        &["Scene", "Object", "vec3", "function", "Vec"]
    }

    fn get_attr(&mut self, cx: &mut HostCx<'_>, object: Value, name: &str) -> R<Option<Value>> {
        match Thing::of(object) {
            Some(Thing::Target(target)) => self.target_attr(cx, target, name).map(Some),
            Some(Thing::Part(target, anchor)) => match Axis::from_name(name) {
                Some(axis) => Ok(Some(self.read(cx, target, anchor, axis))),
                None => Err(no_component(cx, name)),
            },
            Some(Thing::Function(function)) => Ok(matches!(name, "__name__" | "__qualname__").then(|| cx.heap.str(function.name()))),
            None => {
                let Value::Record(record) = object else { return Ok(None) };
                let axis = Axis::from_name(name);
                Ok(axis.and_then(|axis| cx.heap[record].items.get(axis.index()).copied()))
            }
        }
    }

    fn set_attr(&mut self, cx: &mut HostCx<'_>, object: Value, name: &str, value: Value) -> R<()> {
        let message = match Thing::of(object) {
            Some(Thing::Target(Target::Scene)) => format!("cannot set {} of the scene", crate::python::text::repr_str(name)),
            Some(Thing::Target(target @ Target::Object(id))) => {
                if let Some(anchor) = Anchor::from_name(name) {
                    return self.write_all(cx, target, anchor, value);
                }
                if name == "facing" {
                    return self.face(cx, id, value);
                }
                format!("cannot set {} of {}", crate::python::text::repr_str(name), self.called(target))
            }
            Some(Thing::Part(target, anchor)) => match Axis::from_name(name) {
                Some(axis) => return self.write(cx, target, anchor, axis, value),
                None => return Err(no_component(cx, name)),
            },
            Some(Thing::Function(function)) => format!("cannot set {name:?} of {}", function.name()),
            None => format!("a vector that was read is a copy; write o.center.{name} = ... instead"),
        };
        Err(cx.error(Builtin::AttributeError, message))
    }

    fn wants_sequence(&self, object: Value, name: &str) -> bool {
        matches!(Thing::of(object), Some(Thing::Target(Target::Object(_)))) && Anchor::from_name(name).is_some()
    }

    fn call(&mut self, cx: &mut HostCx<'_>, object: Value, args: Args<'_>) -> R<Option<Value>> {
        match Thing::of(object) {
            Some(Thing::Function(function)) => self.call_function(cx, function, args).map(Some),
            _ => Ok(None),
        }
    }

    fn binary(&mut self, cx: &mut HostCx<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
        self.vector_binary(cx, op, a, b)
    }

    fn unary(&mut self, cx: &mut HostCx<'_>, op: UnaryOp, a: Value) -> R<Option<Value>> {
        self.vector_unary(cx, op, a)
    }

    fn items(&mut self, cx: &mut HostCx<'_>, object: Value) -> R<Option<SmallVec<[Value; 4]>>> {
        Ok(self.sequence(cx, object))
    }

    fn equals(&mut self, cx: &mut HostCx<'_>, a: Value, b: Value) -> R<Option<bool>> {
        Ok(self.vector_equals(cx, a, b))
    }

    fn hashable(&self, _: &Heap, object: Value) -> bool {
        !matches!(Thing::of(object), Some(Thing::Part(..)))
    }

    fn repr(&mut self, cx: &mut HostCx<'_>, object: Value) -> R<String> {
        Ok(match Thing::of(object) {
            Some(Thing::Target(Target::Scene)) => "<scene>".into(),
            Some(Thing::Target(target)) => format!("<Object {}>", self.called(target)),
            Some(Thing::Function(function)) => format!("<function {}>", function.name()),
            Some(Thing::Part(..)) | None => {
                let items = self.sequence(cx, object).unwrap_or_default();
                let items: Vec<String> = items.into_iter().map(|item| shown(cx, item)).collect();
                format!("Vec({})", items.join(", "))
            }
        })
    }

    fn is_instance(&mut self, _: &mut HostCx<'_>, object: Value, class: Value) -> Option<bool> {
        let Some(Thing::Function(class)) = Thing::of(class) else { return None };
        match class {
            Function::Vec => Some(matches!(object, Value::Record(_))),
            Function::Object => Some(matches!(Thing::of(object), Some(Thing::Target(Target::Object(_))))),
            Function::Door | Function::Window => Some(match Thing::of(object) {
                Some(Thing::Target(Target::Object(id))) => self.world.kind(id) == class.kind(),
                _ => false,
            }),
            _ => None,
        }
    }

    fn statement_begins(&mut self) {
        self.frame = Some(self.world.frame());
    }

    fn statement_failed(&mut self) {
        if let Some(frame) = self.frame {
            self.world.restore_frame(frame);
        }
    }
}

#[cfg(test)]
mod tests;
