//! What builtin types and functions ask of the machine itself.

use super::Vm;
use super::attr::Found;
use super::generator::{Resume, Step};
use crate::python::classes::Builtin;
use crate::python::code::Op;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::native::Args;
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};

impl Vm<'_> {
    /// `g.send(value)`
    pub(crate) fn generator_send(&mut self, generator: Value, value: Value) -> R<Value> {
        let Value::Generator(g) = generator else { return Err(self.type_error("a generator is wanted")) };
        match self.step_generator(g, Resume::Send(value))? {
            Step::Yielded(v) => Ok(v),
            Step::Returned(v) => Err(self.stop_with(v)),
        }
    }

    fn stop_with(&mut self, value: Value) -> Raise {
        if value.is_none() { self.stop_iteration() } else { self.error_with(Builtin::StopIteration, value) }
    }

    /// `g.throw(exception)`, `g.throw(class, value)`
    pub(crate) fn generator_throw(&mut self, args: Args<'_>) -> R<Value> {
        let Value::Generator(g) = args.at(0) else { return Err(self.type_error("a generator is wanted")) };
        if let (Value::Instance(_), Some(value)) = (args.at(1), args.get(2))
            && !value.is_none()
        {
            return Err(self.type_error("instance exception may not have a separate value"));
        }
        let exception = match (args.at(1), args.get(2)) {
            (Value::Class(c), Some(value)) if !value.is_none() => {
                if self.is_instance(value, Builtin::BaseException) {
                    value
                } else {
                    self.call(Value::Class(c), &[value])?
                }
            }
            (value, _) => {
                let complaint =
                    format!("exceptions must be classes or instances deriving from BaseException, not {}", self.type_name(value));
                self.make_exception(value, &complaint)?
            }
        };
        match self.step_generator(g, Resume::Throw(exception))? {
            Step::Yielded(v) => Ok(v),
            Step::Returned(v) => Err(self.stop_with(v)),
        }
    }

    /// `g.close()`
    pub(crate) fn generator_close(&mut self, generator: Value) -> R<Value> {
        let Value::Generator(g) = generator else { return Err(self.type_error("a generator is wanted")) };
        self.close_generator(g)?;
        Ok(Value::None)
    }

    /// `g.gi_yieldfrom`: what a generator hands its values through from.
    pub(crate) fn generator_waits_for(&self, generator: Value) -> Value {
        let Value::Generator(g) = generator else { return Value::None };
        let Some(frame) = self.heap[g].frame.as_ref().filter(|_| self.heap[g].started) else { return Value::None };
        match self.codes[frame.code.0 as usize].code().ops.get(frame.pc as usize) {
            Some(Op::YieldFrom) => frame.stack.last().copied().unwrap_or(Value::None),
            _ => Value::None,
        }
    }

    /// `__class__` and the first argument of the running function: what `super()` means.
    pub(crate) fn super_arguments(&mut self) -> R<(Value, Value)> {
        let linked = self.codes[self.frame.code.0 as usize].clone();
        let code = linked.code();
        let base = self.frame.base as usize;
        if code.params.positional == 0 {
            return Err(self.error(Builtin::RuntimeError, "super(): no arguments".to_string()));
        }
        let Some(free) = code.frees.iter().position(|n| &**n == "__class__") else {
            return Err(self.error(Builtin::RuntimeError, "super(): __class__ cell not found".to_string()));
        };
        let class = match self.stack[base + code.locals.len() + code.cells.len() + free] {
            Value::Cell(cell) => self.heap[cell].0,
            _ => Value::Undefined,
        };
        if class.is_undefined() {
            return Err(self.error(Builtin::RuntimeError, "super(): empty __class__ cell".to_string()));
        }
        let object = match code.cells.iter().position(|c| c.1 == Some(0)) {
            Some(cell) => match self.stack[base + code.locals.len() + cell] {
                Value::Cell(cell) => self.heap[cell].0,
                _ => Value::Undefined,
            },
            None => self.stack[base],
        };
        if object.is_undefined() {
            return Err(self.error(Builtin::RuntimeError, "super(): arg[0] deleted".to_string()));
        }
        Ok((class, object))
    }

    /// `object.__getattribute__(o, name)`
    pub(crate) fn get_attr_without_hooks(&mut self, object: Value, name: Symbol) -> R<Value> {
        let found = match object {
            Value::Instance(i) => self.default_instance_attr(object, i, name)?,
            _ => self.find_attr(object, name)?,
        };
        match found {
            Some(Found::Value(v)) => Ok(v),
            Some(Found::Method(callee)) => Ok(self.bind_method(callee, object)),
            None => Err(self.no_attribute(object, name)),
        }
    }

    /// `object.__setattr__(o, name, value)`, `type.__setattr__(C, name, value)`
    pub(crate) fn set_attr_without_hooks(&mut self, object: Value, name: Symbol, value: Value) -> R<()> {
        match object {
            Value::Instance(i) => self.set_instance_attr(object, i, name, value),
            Value::Class(c) => self.set_type_attr(c, name, value),
            _ => self.set_attr(object, name, value),
        }
    }

    /// `object.__delattr__(o, name)`
    pub(crate) fn del_attr_without_hooks(&mut self, object: Value, name: Symbol) -> R<()> {
        match object {
            Value::Instance(i) => self.del_instance_attr(object, i, name),
            Value::Class(c) if !self.heap[c].builtin => self.del_type_attr(c, name),
            _ => self.del_attr(object, name),
        }
    }

    /// The names that `dir()` shows, sorted.
    pub fn dir_names(&mut self, object: Value) -> R<Vec<String>> {
        let mut names: Vec<String> = Vec::new();
        let class = match object {
            Value::Class(c) => c,
            _ => self.class_of(object),
        };
        for base in self.heap[class].mro.clone() {
            self.load_natives(base);
            names.extend(self.heap[base].attrs.keys().map(|k| self.symbols.text(*k).to_string()));
        }
        match object {
            Value::Instance(i) => match &self.heap[i].attrs {
                Attrs::Inline(items) => names.extend(items.iter().map(|p| self.symbols.text(p.0).to_string())),
                Attrs::Dict(d) => {
                    let keys: Vec<Value> = self.heap[*d].0.iter().map(|e| e.key).collect();
                    names.extend(keys.into_iter().map(|k| self.display(k)));
                }
            },
            Value::Module(m) => {
                names = self.heap[m].names.iter().map(|n| self.symbols.text(*n).to_string()).collect();
            }
            _ => {}
        }
        names.extend(["__class__", "__doc__"].map(str::to_string));
        self.charge(names.len() as u64 * 200)?;
        names.sort();
        names.dedup();
        Ok(names)
    }

    /// `isinstance(value, class)` as the class itself decides, without `__instancecheck__`.
    pub(crate) fn plain_isinstance(&mut self, value: Value, class: Value) -> R<bool> {
        let Value::Class(of) = class else {
            return Err(self.type_error("isinstance() arg 2 must be a type, a tuple of types, or a union"));
        };
        let own = self.class_of(value);
        if self.is_subclass(own, of) {
            return Ok(true);
        }
        // `__class__` may say otherwise than the type.
        if let Value::Instance(_) = value
            && let Some(Value::Class(said)) = self.get_attr_opt(value, sym::CLASS)?
        {
            return Ok(said != own && self.is_subclass(said, of));
        }
        Ok(false)
    }

    /// `e.__traceback__`: there once the exception was raised. What it shows is for people, not for programs.
    pub(crate) fn traceback(&mut self, exception: Value) -> Value {
        let Some(data) = self.heap.exception_data(exception) else { return Value::None };
        let entries = data.traceback.clone();
        let mut next = Value::None;
        for entry in entries {
            let line = self.codes[entry.code.0 as usize].program.lines.line(entry.range.start());
            let fields = [("tb_frame", Value::None), ("tb_next", next), ("tb_lineno", Value::int(i64::from(line) + 1))];
            let attrs = fields.map(|(name, value)| (self.symbols.intern(name), value)).to_vec();
            let class = Builtin::Traceback.class();
            next = Value::Instance(self.heap.alloc(Instance { class, attrs: Attrs::Inline(attrs), base: Base::None }));
        }
        next
    }

    /// `isinstance(value, class)`: tuples, unions and `__instancecheck__` included.
    pub fn isinstance(&mut self, value: Value, class: Value) -> R<bool> {
        match class {
            Value::Class(c) => {
                if self.class_of(value) == c {
                    return Ok(true);
                }
                let meta = self.heap[c].meta;
                if meta == Builtin::Type.class() {
                    return self.plain_isinstance(value, class);
                }
                match self.call_special(class, sym::INSTANCECHECK, &[value])? {
                    Some(said) => self.truth(said),
                    None => self.plain_isinstance(value, class),
                }
            }
            Value::Tuple(t) => {
                for i in 0..self.heap[t].0.len() {
                    let item = self.heap[t].0[i];
                    if self.nested("", |vm| vm.isinstance(value, item))? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
            Value::Alias(a) if self.heap[a].origin.is_none() => {
                for item in self.heap[a].args.clone() {
                    if self.isinstance(value, item)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
            Value::Alias(_) => Err(self.type_error("isinstance() argument 2 cannot be a parameterized generic")),
            Value::Host(_) | Value::Record(_) => match self.host_is_instance(value, class) {
                Some(is) => Ok(is),
                None => Err(self.type_error("isinstance() arg 2 must be a type, a tuple of types, or a union")),
            },
            Value::Instance(_) => match self.call_special(class, sym::INSTANCECHECK, &[value])? {
                Some(said) => self.truth(said),
                None => Err(self.type_error("isinstance() arg 2 must be a type, a tuple of types, or a union")),
            },
            _ => Err(self.type_error("isinstance() arg 2 must be a type, a tuple of types, or a union")),
        }
    }

    /// `f.__code__`: a small object with the numbers and names that programs ask for.
    pub(crate) fn code_object(&mut self, function: Value) -> R<Value> {
        let code = match function {
            Value::Function(f) => self.heap[f].code,
            Value::Generator(g) => match &self.heap[g].frame {
                Some(frame) => frame.code,
                None => return Ok(Value::None),
            },
            _ => return Ok(Value::None),
        };
        let linked = self.codes[code.0 as usize].clone();
        let code = linked.code();
        let names: Vec<Value> = code.locals.iter().filter(|n| !n.starts_with('.')).map(|n| self.heap.str(&**n)).collect();
        let cells: Vec<Value> = code.cells.iter().map(|c| self.heap.str(&*c.0)).collect();
        let used: Vec<Value> = code.names.iter().map(|n| self.heap.str(&**n)).collect();
        let frees: Vec<Value> = code.frees.iter().map(|n| self.heap.str(&**n)).collect();
        let flags =
            3 | if code.params.varargs { 4 } else { 0 } | if code.params.varkw { 8 } else { 0 } | if code.generator { 32 } else { 0 };
        let fields = [
            ("co_name", linked.name),
            ("co_qualname", linked.qualname),
            ("co_argcount", Value::int(i64::from(code.params.positional))),
            ("co_posonlyargcount", Value::int(i64::from(code.params.positional_only))),
            ("co_kwonlyargcount", Value::int(i64::from(code.params.keyword_only))),
            ("co_nlocals", Value::int(names.len() as i64)),
            ("co_flags", Value::int(flags)),
            ("co_varnames", self.heap.tuple(names)),
            ("co_freevars", self.heap.tuple(frees)),
            ("co_cellvars", self.heap.tuple(cells)),
            ("co_names", self.heap.tuple(used)),
            ("co_filename", self.heap.str("<program>")),
        ];
        let attrs = fields.iter().map(|(name, value)| (self.symbols.intern(name), *value)).collect();
        let class = Builtin::CodeObject.class();
        Ok(Value::Instance(self.heap.alloc(Instance { class, attrs: Attrs::Inline(attrs), base: Base::None })))
    }
}
