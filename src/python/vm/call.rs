//! Calls: of functions, classes, natives, anything.

use super::fast::{array, set};
use super::{Linked, Vm};
use crate::python::classes::Builtin;
use crate::python::code::{CodeId, CodeKind};
use crate::python::error::{R, Raise};
use crate::python::frame::{Frame, Return, SavedFrame};
use crate::python::heap::*;
use crate::python::native::{ANY, Args, Native, NativeKind};
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};
use smallvec::SmallVec;
use std::rc::Rc;

/// Arguments of a call, off the stack.
pub(super) type Few = SmallVec<[Value; 8]>;

/// What the main loop does after a call was begun.
pub(super) enum Begun {
    /// A new frame is current.
    Frame,
    /// The result is on the stack.
    Done,
}

impl Vm<'_> {
    /// `callee(*args)` from native code.
    pub fn call(&mut self, callee: Value, args: &[Value]) -> R<Value> {
        self.call_with(callee, Args::new(args))
    }

    /// `callee(*args, **keywords)` from native code.
    pub fn call_with(&mut self, callee: Value, args: Args<'_>) -> R<Value> {
        match callee {
            Value::Function(f) => {
                let floor = self.stack.len();
                self.stack.extend_from_slice(args.pos);
                match self.begin_function(f, floor, floor, args.kw, Return::Native)? {
                    Begun::Done => Ok(self.pop()),
                    Begun::Frame => self.run_nested(),
                }
            }
            Value::Native(native) => self.nested(" while calling a Python object", |vm| vm.call_native(native, args)),
            Value::Method(m) => {
                let Method { callee, receiver } = self.heap[m];
                let mut all = Few::new();
                all.push(receiver);
                all.extend_from_slice(args.pos);
                self.call_with(callee, Args { pos: &all, kw: args.kw })
            }
            Value::Class(c) => self.nested(" while calling a Python object", |vm| vm.call_class(c, args)),
            Value::Host(_) | Value::Record(_) => self.call_host(callee, args),
            Value::StaticMethod(w) => {
                let inner = self.heap[w].0;
                self.nested(" while calling a Python object", |vm| vm.call_with(inner, args))
            }
            Value::Alias(a) if !self.heap[a].origin.is_none() => {
                let origin = self.heap[a].origin;
                self.nested(" while calling a Python object", |vm| vm.call_with(origin, args))
            }
            _ => match self.special(callee, sym::CALL) {
                Some(method) => self.nested(" while calling a Python object", |vm| vm.call_with(method, args)),
                None => {
                    let message = format!("'{}' object is not callable", self.type_name(callee));
                    Err(self.type_error(message))
                }
            },
        }
    }

    fn call_host(&mut self, callee: Value, args: Args<'_>) -> R<Value> {
        let plain: Few = args.pos.iter().map(|v| self.plain(*v)).collect();
        let keywords: SmallVec<[(Symbol, Value); 8]> = args.kw.iter().map(|p| (p.0, self.plain(p.1))).collect();
        let (host, mut cx) = self.host_cx();
        match host.call(&mut cx, callee, Args { pos: &plain, kw: &keywords })? {
            Some(value) => Ok(value),
            None => {
                let message = format!("'{}' object is not callable", self.type_name(callee));
                Err(self.type_error(message))
            }
        }
    }

    /// Calls a native function after checking how many arguments it gets.
    pub fn call_native(&mut self, native: &'static Native, args: Args<'_>) -> R<Value> {
        self.charge(4)?;
        let (min, max) = native.arity;
        let takes_receiver = match native.kind {
            NativeKind::Function | NativeKind::StaticMethod => false,
            NativeKind::Method | NativeKind::Getter if matches!(args.at(0), Value::Instance(_)) => {
                return self.call_native_slow(native, args);
            }
            _ => true,
        };
        let given = args.pos.len().wrapping_sub(usize::from(takes_receiver));
        if args.kw.is_empty() && given >= usize::from(min) && (given <= usize::from(max) || max == ANY && given < usize::MAX) {
            let result = (native.body)(self, args);
            if takes_receiver && result.is_err() {
                return self.receiver_named(native, args, result);
            }
            return result;
        }
        self.call_native_slow(native, args)
    }

    /// Calls a native function that stands on the stack with its positional arguments from `start` on; the result takes their place.
    #[inline(always)]
    pub(super) fn call_on_stack(&mut self, native: &'static Native, floor: usize, start: usize) -> R<()> {
        let result = match &self.stack[start..] {
            args @ [_] => self.call_native(native, Args::new(&array::<1>(args))),
            args @ [_, _] => self.call_native(native, Args::new(&array::<2>(args))),
            args @ [_, _, _] => self.call_native(native, Args::new(&array::<3>(args))),
            args => self.call_native(native, Args::new(&Few::from_slice(args))),
        };
        self.finish(floor, result)
    }

    /// A method that was handed something else than its type says which method it is.
    #[cold]
    fn receiver_named(&mut self, native: &'static Native, args: Args<'_>, result: R<Value>) -> R<Value> {
        let Err(Raise::Exception(e)) = result else { return result };
        if !matches!(native.kind, NativeKind::Method | NativeKind::Raw) || !self.is_instance(e, Builtin::TypeError) {
            return result;
        }
        let message = match self.heap.exception_data(e).map(|d| d.args) {
            Some(Value::Tuple(t)) => self.heap[t].0.first().copied().unwrap_or(Value::None),
            _ => return result,
        };
        if !self.display(message).starts_with("descriptor requires a ") {
            return result;
        }
        let Some(owner) = Builtin::owner(native) else { return result };
        let (name, owner, found) = (native.name, owner.name(), self.type_name(args.at(0)));
        Err(self.type_error(match Self::native_class(native) {
            Builtin::SlotWrapper => format!("descriptor '{name}' requires a '{owner}' object but received a '{found}'"),
            _ => format!("descriptor '{name}' for '{owner}' objects doesn't apply to a '{found}' object"),
        }))
    }

    #[inline(never)]
    fn call_native_slow(&mut self, native: &'static Native, args: Args<'_>) -> R<Value> {
        let bound = matches!(native.kind, NativeKind::Method | NativeKind::Raw | NativeKind::ClassMethod | NativeKind::Getter);
        let given = args.pos.len() - usize::from(bound && !args.pos.is_empty());
        if bound && args.pos.is_empty() {
            let owner = Builtin::owner(native).map(|b| format!("{}.", b.name())).unwrap_or_default();
            let message = match Self::native_class(native) {
                Builtin::SlotWrapper => {
                    format!("descriptor '{}' of '{}' object needs an argument", native.name, owner.trim_end_matches('.'))
                }
                _ => format!("unbound method {owner}{}() needs an argument", native.name),
            };
            return Err(self.type_error(message));
        }
        if !args.kw.is_empty() && !native.keywords {
            let name = self.native_name(native, args);
            return Err(self.type_error(format!("{name}() takes no keyword arguments")));
        }
        let (min, max) = native.arity;
        let out_of_range = given < usize::from(min) || (max != ANY && given > usize::from(max));
        let by_keyword = native.keywords && given < usize::from(min) && given + args.kw.len() >= usize::from(min);
        if out_of_range && !by_keyword {
            return Err(self.arity_error(native, args, given));
        }
        if matches!(native.kind, NativeKind::Method | NativeKind::Getter) {
            let receiver = args.pos[0];
            if let Value::Instance(_) = receiver {
                let plain = self.plain(receiver);
                let mut all: Few = SmallVec::from_slice(args.pos);
                all[0] = plain;
                let result = (native.body)(self, Args { pos: &all, kw: args.kw });
                return match result {
                    // `super().__getitem__(key)` in a subclass of dict asks the subclass's `__missing__`.
                    Err(raise)
                        if native.name == "__getitem__" && matches!(plain, Value::Dict(_)) && self.raised(&raise, Builtin::KeyError) =>
                    {
                        self.call_special(receiver, sym::MISSING, &all[1..])?.ok_or(raise)
                    }
                    result => result,
                };
            }
        }
        (native.body)(self, args)
    }

    fn native_name(&mut self, native: &'static Native, args: Args<'_>) -> String {
        match native.kind {
            NativeKind::Method | NativeKind::Raw | NativeKind::Getter => {
                let receiver = self.plain(args.at(0));
                format!("{}.{}", self.type_name(receiver), native.name)
            }
            NativeKind::ClassMethod => match args.at(0) {
                Value::Class(c) => format!("{}.{}", self.class_name(c), native.name),
                _ => native.name.to_string(),
            },
            _ if !native.module.is_empty() => format!("{}.{}", native.module, native.name),
            _ => native.name.to_string(),
        }
    }

    fn arity_error(&mut self, native: &'static Native, args: Args<'_>, given: usize) -> Raise {
        let (min, max) = native.arity;
        let name = self.native_name(native, args);
        let slot = matches!(native.kind, NativeKind::Method | NativeKind::Raw) && Self::native_class(native) == Builtin::SlotWrapper;
        let message = if slot && max == min {
            format!("expected {min} argument{}, got {given}", if min == 1 { "" } else { "s" })
        } else if max == min && min == 0 {
            format!("{name}() takes no arguments ({given} given)")
        } else if max == min && min == 1 {
            format!("{name}() takes exactly one argument ({given} given)")
        } else {
            let short = native.name;
            let (word, n) = match (given < usize::from(min), min == max) {
                (true, false) => ("at least ", min),
                (false, false) => ("at most ", max),
                (_, true) => ("", min),
            };
            format!("{short} expected {word}{n} argument{}, got {given}", if n == 1 { "" } else { "s" })
        };
        self.type_error(message)
    }

    /// Begins a call whose callee stands at `floor` on the stack with its arguments from `start` on; keywords are off the stack.
    pub(super) fn begin_call(&mut self, callee: Value, floor: usize, start: usize, keywords: &[(Symbol, Value)]) -> R<Begun> {
        match callee {
            Value::Function(f) => self.begin_function(f, floor, start, keywords, Return::Push),
            Value::Method(m) => {
                let Method { callee, receiver } = self.heap[m];
                self.stack.insert(start, receiver);
                self.begin_call(callee, floor, start, keywords)
            }
            Value::Native(native) if keywords.is_empty() => {
                self.call_on_stack(native, floor, start)?;
                Ok(Begun::Done)
            }
            Value::Class(c) if !self.heap[c].builtin && self.plain_init(c) => self.begin_instance(c, floor, start, keywords),
            _ => {
                let args: Few = SmallVec::from_slice(&self.stack[start..]);
                let result = self.call_with(callee, Args { pos: &args, kw: keywords })?;
                self.stack.truncate(floor);
                self.stack.push(result);
                Ok(Begun::Done)
            }
        }
    }

    /// True for a class whose instances are made by `object.__new__` and a Python `__init__`: no native code needs to stand between.
    fn plain_init(&mut self, class: Ref<Class>) -> bool {
        self.heap[class].layout == Layout::Object
            && self.heap[class].meta == Builtin::Type.class()
            && matches!(self.class_attr(class, sym::INIT), Some(Value::Function(_)))
            && matches!(self.class_attr(class, sym::NEW), Some(Value::Native(_)))
    }

    fn begin_instance(&mut self, class: Ref<Class>, floor: usize, start: usize, keywords: &[(Symbol, Value)]) -> R<Begun> {
        let instance = Value::Instance(self.heap.alloc(Instance { class, attrs: Attrs::default(), base: Base::None }));
        let Some(Value::Function(init)) = self.class_attr(class, sym::INIT) else { return Ok(Begun::Done) };
        // The instance takes the place of the callee and stays there as the result; a second copy is `self`.
        if start == floor {
            self.stack.insert(floor, instance);
        } else {
            self.stack[floor] = instance;
            // `module.Class(x)` leaves the empty place of a receiver between the two.
            self.stack.drain(floor + 1..start);
        }
        let start = floor + 1;
        self.stack.insert(start, instance);
        self.begin_function(init, start, start, keywords, Return::Instance)
    }

    /// Enters a function that takes its arguments as they stand from `start` to the top; where it needs more thought, `false` and nothing
    /// is done.
    #[inline(always)]
    pub(super) fn enter(&mut self, function: Ref<Function>, floor: usize, start: usize) -> bool {
        let Function { code, module, .. } = self.heap[function];
        let linked = &self.codes[code.0 as usize];
        let given = self.stack.len() - start;
        let cost = linked.cost as i64;
        if !linked.plain || given != linked.positional || self.frames.len() >= self.limits.recursion || self.countdown < cost {
            return false;
        }
        self.countdown -= cost;
        for _ in given..linked.slots {
            self.stack.push(Value::Undefined);
        }
        let frame = Frame {
            code,
            pc: 0,
            base: start as u32,
            floor: floor as u32,
            module,
            namespace: Value::Undefined,
            ret: Return::Push,
            handling: self.handling.len() as u32,
            generator: None,
        };
        self.frames.push(self.frame);
        self.frame = frame;
        true
    }

    /// Begins a Python function; its positional arguments stand on the stack from `start` to the top.
    pub(super) fn begin_function(
        &mut self,
        function: Ref<Function>,
        floor: usize,
        start: usize,
        keywords: &[(Symbol, Value)],
        ret: Return,
    ) -> R<Begun> {
        let code_id = self.heap[function].code;
        let linked = Rc::clone(&self.codes[code_id.0 as usize]);
        if self.frames.len() >= self.limits.recursion {
            return Err(self.recursion_error());
        }
        let given = self.stack.len() - start;
        if !(linked.simple && keywords.is_empty() && given == linked.positional) {
            self.bind_parameters(function, &linked, start, keywords)?;
        }
        self.charge(linked.cost)?;
        self.stack.resize(start + linked.slots, Value::Undefined);
        if linked.has_cells {
            self.fill_cells(function, &linked, start);
        }
        if linked.generator {
            return self.begin_generator(function, code_id, floor, start, ret);
        }
        let frame = Frame {
            code: code_id,
            pc: 0,
            base: start as u32,
            floor: floor as u32,
            module: self.heap[function].module,
            namespace: Value::Undefined,
            ret,
            handling: self.handling.len() as u32,
            generator: None,
        };
        self.frames.push(self.frame);
        self.frame = frame;
        Ok(Begun::Frame)
    }

    fn fill_cells(&mut self, function: Ref<Function>, linked: &Linked, start: usize) {
        let code = linked.code();
        let mut slot = start + code.locals.len();
        for (_, parameter) in &code.cells {
            let value = match parameter {
                Some(local) => std::mem::replace(&mut self.stack[start + usize::from(*local)], Value::Undefined),
                None => Value::Undefined,
            };
            self.stack[slot] = Value::Cell(self.heap.alloc(Cell(value)));
            slot += 1;
        }
        for i in 0..self.heap[function].closure.len() {
            self.stack[slot + i] = Value::Cell(self.heap[function].closure[i]);
        }
    }

    fn begin_generator(&mut self, function: Ref<Function>, code: CodeId, floor: usize, start: usize, ret: Return) -> R<Begun> {
        let stack = self.stack.split_off(start);
        self.stack.truncate(floor);
        let Function { module, name, qualname, .. } = self.heap[function].clone();
        let frame = Some(Box::new(SavedFrame { code, pc: 0, module, stack, handling: Vec::new() }));
        let generator = Value::Generator(self.heap.alloc(Generator { frame, spare: None, running: false, name, qualname, started: false }));
        if ret == Return::Instance {
            return Err(self.type_error("__init__() should return None, not 'generator'"));
        }
        self.stack.push(generator);
        Ok(Begun::Done)
    }

    /// The same for calls without surprises; else `false` and nothing is done.
    fn bind_quickly(&mut self, function: Ref<Function>, linked: &Linked, start: usize, keywords: &[(Symbol, Value)]) -> bool {
        let params = &linked.code().params;
        let (given, named) = (self.stack.len() - start, linked.params.len());
        let (positional, posonly) = (usize::from(params.positional), usize::from(params.positional_only));
        if params.varargs || params.varkw || given > positional {
            return false;
        }
        self.stack.resize(start + named, Value::Undefined);
        let complete = self.fill_parameters(function, linked, start, given, posonly, keywords);
        if !complete {
            self.stack.truncate(start + given);
        }
        complete
    }

    /// Puts keywords and defaults into the places behind the arguments that were given by position; whether all are filled.
    fn fill_parameters(
        &mut self,
        function: Ref<Function>,
        linked: &Linked,
        start: usize,
        given: usize,
        posonly: usize,
        keywords: &[(Symbol, Value)],
    ) -> bool {
        let slots = &mut self.stack[start..];
        for (name, value) in keywords {
            match linked.params.iter().position(|p| p == name) {
                Some(at) if at >= posonly && slots[at].is_undefined() => set(&mut slots[at], value),
                _ => return false,
            }
        }
        let function = &self.heap[function];
        let without_default = linked.positional - function.defaults.len().min(linked.positional);
        for (at, slot) in slots.iter_mut().enumerate().skip(given) {
            if !slot.is_undefined() {
                continue;
            }
            let default = if at < linked.positional {
                at.checked_sub(without_default).and_then(|i| function.defaults.get(i))
            } else {
                function.kwdefaults.iter().find(|d| d.0 == linked.params[at]).map(|d| &d.1)
            };
            match default {
                Some(value) => set(slot, value),
                None => return false,
            }
        }
        true
    }

    /// Brings the arguments into the order of the parameters, with defaults, `*args` and `**kwargs`.
    fn bind_parameters(&mut self, function: Ref<Function>, linked: &Linked, start: usize, keywords: &[(Symbol, Value)]) -> R<()> {
        if self.bind_quickly(function, linked, start, keywords) {
            return Ok(());
        }
        let params = &linked.code().params;
        let (positional, posonly, kwonly) =
            (usize::from(params.positional), usize::from(params.positional_only), usize::from(params.keyword_only));
        let given = self.stack.len() - start;
        let mut locals: SmallVec<[Value; 12]> = SmallVec::from_elem(Value::Undefined, linked.params.len());
        for (slot, value) in locals[..positional].iter_mut().zip(&self.stack[start..]) {
            *slot = *value;
        }
        let extra: SmallVec<[Value; 3]> = self.stack[start..].iter().skip(positional).copied().collect();
        let varargs = positional + kwonly;
        let varkw = varargs + usize::from(params.varargs);
        let mut rest: Vec<(Symbol, Value)> = Vec::new();
        for &(name, value) in keywords {
            match linked.params[posonly..varargs].iter().position(|p| *p == name) {
                Some(i) if !locals[posonly + i].is_undefined() => {
                    let message =
                        format!("{}() got multiple values for argument '{}'", self.function_name(function), self.symbols.text(name));
                    return Err(self.type_error(message));
                }
                Some(i) => locals[posonly + i] = value,
                None if params.varkw => rest.push((name, value)),
                None => return Err(self.unexpected_keyword(function, linked, keywords, name)),
            }
        }
        if !extra.is_empty() && !params.varargs {
            return Err(self.too_many(function, linked, given, &locals[positional..varargs]));
        }
        let defaults = self.heap[function].defaults.clone();
        let first_default = positional.saturating_sub(defaults.len());
        for (i, value) in defaults.iter().enumerate() {
            if let Some(slot) = locals.get_mut(first_default + i).filter(|s| s.is_undefined()) {
                *slot = *value;
            }
        }
        for &(name, value) in &self.heap[function].kwdefaults {
            if let Some(i) = linked.params[positional..varargs].iter().position(|p| *p == name)
                && locals[positional + i].is_undefined()
            {
                locals[positional + i] = value;
            }
        }
        self.check_missing(function, linked, &locals[..positional], 0, "positional")?;
        self.check_missing(function, linked, &locals[positional..varargs], positional, "keyword-only")?;
        if params.varargs {
            locals[varargs] = self.heap.tuple(extra);
        }
        if params.varkw {
            locals[varkw] = Value::Dict(self.symbols_dict(rest));
        }
        self.stack.truncate(start);
        self.stack.extend_from_slice(&locals);
        Ok(())
    }

    fn function_name(&self, function: Ref<Function>) -> String {
        self.display(self.heap[function].qualname)
    }

    fn check_missing(&mut self, function: Ref<Function>, linked: &Linked, locals: &[Value], first: usize, kind: &str) -> R<()> {
        let missing: Vec<String> = (0..locals.len())
            .filter(|&i| locals[i].is_undefined())
            .map(|i| format!("'{}'", self.symbols.text(linked.params[first + i])))
            .collect();
        if missing.is_empty() {
            return Ok(());
        }
        let names = match missing.as_slice() {
            [one] => one.clone(),
            [a, b] => format!("{a} and {b}"),
            [all @ .., last] => format!("{}, and {last}", all.join(", ")),
            [] => String::new(),
        };
        let s = if missing.len() == 1 { "" } else { "s" };
        let message = format!("{}() missing {} required {kind} argument{s}: {names}", self.function_name(function), missing.len());
        Err(self.type_error(message))
    }

    fn unexpected_keyword(&mut self, function: Ref<Function>, linked: &Linked, keywords: &[(Symbol, Value)], name: Symbol) -> Raise {
        let posonly = usize::from(linked.code().params.positional_only);
        let wrong: Vec<&str> =
            keywords.iter().filter(|k| linked.params[..posonly].contains(&k.0)).map(|k| self.symbols.text(k.0)).collect();
        let message = if wrong.is_empty() {
            format!("{}() got an unexpected keyword argument '{}'", self.function_name(function), self.symbols.text(name))
        } else {
            format!(
                "{}() got some positional-only arguments passed as keyword arguments: '{}'",
                self.function_name(function),
                wrong.join(", ")
            )
        };
        self.type_error(message)
    }

    fn too_many(&mut self, function: Ref<Function>, linked: &Linked, given: usize, kwonly: &[Value]) -> Raise {
        let positional = usize::from(linked.code().params.positional);
        let defaults = self.heap[function].defaults.len();
        let s = |n: usize| if n == 1 { "" } else { "s" };
        let takes = if defaults > 0 {
            format!("from {} to {positional} positional arguments", positional - defaults)
        } else {
            format!("{positional} positional argument{}", s(positional))
        };
        let kw_given = kwonly.iter().filter(|v| !v.is_undefined()).count();
        let were = if kw_given > 0 {
            format!("{given} positional argument{} (and {kw_given} keyword-only argument{}) were given", s(given), s(kw_given))
        } else {
            format!("{given} {} given", if given == 1 { "was" } else { "were" })
        };
        let message = format!("{}() takes {takes} but {were}", self.function_name(function));
        self.type_error(message)
    }

    /// `C(...)`
    pub(super) fn call_class(&mut self, class: Ref<Class>, args: Args<'_>) -> R<Value> {
        let meta = self.heap[class].meta;
        if meta != Builtin::Type.class()
            && let Some(hook) = self.class_attr(meta, sym::CALL)
            && !matches!(hook, Value::Native(_))
        {
            return self.call_hook(hook, Value::Class(class), args);
        }
        self.make_instance(class, args)
    }

    /// Calls a function found on a class, with a receiver and all kinds of arguments.
    pub(crate) fn call_hook(&mut self, hook: Value, receiver: Value, args: Args<'_>) -> R<Value> {
        let mut all = Few::new();
        all.push(receiver);
        all.extend_from_slice(args.pos);
        match hook {
            Value::Function(_) | Value::Native(_) => self.call_with(hook, Args { pos: &all, kw: args.kw }),
            _ => {
                let class = self.class_of(receiver);
                let bound = self.bind_value(hook, receiver, class)?;
                self.call_with(bound, args)
            }
        }
    }

    /// What `type.__call__` does: `__new__`, then `__init__`.
    pub fn make_instance(&mut self, class: Ref<Class>, args: Args<'_>) -> R<Value> {
        if class == Builtin::Type.class() && args.pos.len() == 1 && args.kw.is_empty() {
            return Ok(Value::Class(self.class_of(args.at(0))));
        }
        let new = self.class_attr(class, sym::NEW);
        let instance = match new {
            Some(Value::StaticMethod(w)) => {
                let inner = self.heap[w].0;
                self.call_hook(inner, Value::Class(class), args)?
            }
            Some(f @ Value::Function(_)) => self.call_hook(f, Value::Class(class), args)?,
            Some(f @ Value::Native(_)) if self.heap[class].layout == Layout::Exception => {
                let is_default = self.class_attr(Builtin::Object.class(), sym::NEW).is_some_and(|d| d.is(f));
                if is_default { self.default_new(class, args)? } else { self.call_hook(f, Value::Class(class), args)? }
            }
            _ => self.default_new(class, args)?,
        };
        let own = self.class_of(instance);
        if !self.is_subclass(own, class) || self.heap[own].builtin && self.heap[own].layout != Layout::Exception {
            return Ok(instance);
        }
        match self.class_attr(own, sym::INIT) {
            Some(Value::Native(native)) if native.name == "__init__" && self.heap[own].layout == Layout::Object => {}
            Some(init) => {
                let result = self.call_hook(init, instance, args)?;
                if !result.is_none() {
                    let message = format!("__init__() should return None, not '{}'", self.type_name(result));
                    return Err(self.type_error(message));
                }
            }
            None => {}
        }
        Ok(instance)
    }

    /// What the `__new__` of the builtin base does.
    pub fn default_new(&mut self, class: Ref<Class>, args: Args<'_>) -> R<Value> {
        let layout = self.heap[class].layout;
        if self.heap[class].builtin && layout != Layout::Object && layout != Layout::Exception {
            return self.construct_builtin(class, args);
        }
        let base = match layout {
            Layout::Object => {
                self.check_object_new(class, args)?;
                Base::None
            }
            Layout::Exception => {
                let tuple = self.heap.tuple(args.pos);
                let data = ExceptionData { args: tuple, cause: Value::None, context: Value::None, suppress: false, traceback: Vec::new() };
                Base::Exception(Box::new(data))
            }
            Layout::Type => return self.new_type(class, args),
            Layout::Property => Base::Value(self.construct_layout(layout, args)?),
            // Mutable ones are filled by their `__init__`.
            Layout::List | Layout::Dict | Layout::Set | Layout::ByteArray => Base::Value(self.construct_layout(layout, Args::new(&[]))?),
            _ => Base::Value(self.construct_layout(layout, args)?),
        };
        Ok(Value::Instance(self.heap.alloc(Instance { class, attrs: Attrs::default(), base })))
    }

    fn new_type(&mut self, meta: Ref<Class>, args: Args<'_>) -> R<Value> {
        if args.pos.len() != 3 {
            return Err(self.type_error("type() takes 1 or 3 arguments"));
        }
        self.new_class(meta, args.at(0), args.at(1), args.at(2), args.kw)
    }

    fn check_object_new(&mut self, class: Ref<Class>, args: Args<'_>) -> R<()> {
        if args.pos.is_empty() && args.kw.is_empty() {
            return Ok(());
        }
        let new_is_ours = !matches!(self.class_attr(class, sym::NEW), Some(Value::Native(_)));
        let init_is_default = matches!(self.class_attr(class, sym::INIT), Some(Value::Native(_)) | None);
        if new_is_ours {
            return Err(self.type_error("object.__new__() takes exactly one argument (the type to instantiate)"));
        }
        if init_is_default {
            let message = format!("{}() takes no arguments", self.class_name(class));
            return Err(self.type_error(message));
        }
        Ok(())
    }

    /// The value that a builtin class makes from these arguments.
    fn construct_builtin(&mut self, class: Ref<Class>, args: Args<'_>) -> R<Value> {
        use crate::python::types;
        let index = class.index();
        macro_rules! route {
            ($($builtin:ident => $call:expr,)*) => {
                $(if index == Builtin::$builtin as u32 { return $call(self, args); })*
            };
        }
        route! {
            Int => types::int::construct, Float => types::float::construct, Bool => types::int::construct_bool, Complex => types::complex::construct,
            Str => types::str::construct, Bytes => types::bytes::construct, ByteArray => types::bytes::construct_array,
            Tuple => types::tuple::construct, List => types::list::construct, Dict => types::dict::construct, Set => types::set::construct,
            FrozenSet => types::set::construct_frozen, Slice => types::slice::construct, Range => types::range::construct,
            Enumerate => types::iterator::construct_enumerate, Zip => types::iterator::construct_zip, Map => types::iterator::construct_map,
            Filter => types::iterator::construct_filter, Reversed => types::iterator::construct_reversed,
            MappingProxy => types::dict::construct_proxy,
            Property => types::function::construct_property, ClassMethod => types::function::construct_class_method,
            StaticMethod => types::function::construct_static_method, Super => types::function::construct_super, Type => types::object::construct_type,
            Method => types::function::construct_method, GenericAlias => types::object::construct_alias,
        }
        if let Some(tool) = crate::python::modules::itertools::construct(self, index, args)? {
            return Ok(tool);
        }
        let message = format!("cannot create '{}' instances", self.class_name(class));
        Err(self.type_error(message))
    }

    fn construct_layout(&mut self, layout: Layout, args: Args<'_>) -> R<Value> {
        let builtin = match layout {
            Layout::Int => Builtin::Int,
            Layout::Float => Builtin::Float,
            Layout::Complex => Builtin::Complex,
            Layout::Str => Builtin::Str,
            Layout::Bytes => Builtin::Bytes,
            Layout::ByteArray => Builtin::ByteArray,
            Layout::Tuple => Builtin::Tuple,
            Layout::List => Builtin::List,
            Layout::Dict => Builtin::Dict,
            Layout::Set => Builtin::Set,
            Layout::FrozenSet => Builtin::FrozenSet,
            Layout::Property => Builtin::Property,
            Layout::Object | Layout::Exception | Layout::Type | Layout::Sealed => return Ok(Value::None),
        };
        let made = self.construct_builtin(builtin.class(), args)?;
        // A copy: `tuple(t)` and `str(s)` return their argument itself, which is fine; an instance never leaks as a base.
        Ok(self.plain(made))
    }

    /// Makes a function from what `MakeFunction` finds on the stack.
    pub(super) fn make_function(&mut self, child: u32, flags: u8) -> Value {
        let current = &self.codes[self.frame.code.0 as usize];
        let id = CodeId(current.first + current.code().children[child as usize]);
        let closure: SmallVec<[Ref<Cell>; 2]> = if flags & 8 != 0 { self.pop_cells() } else { SmallVec::new() };
        let annotations = if flags & 4 != 0 { self.pop() } else { Value::None };
        let kwdefaults = if flags & 2 != 0 { self.pop_keywords() } else { SmallVec::new() };
        let defaults = match if flags & 1 != 0 { self.pop() } else { Value::None } {
            Value::Tuple(t) => SmallVec::from_slice(&self.heap[t].0),
            _ => SmallVec::new(),
        };
        let linked = Rc::clone(&self.codes[id.0 as usize]);
        let module = self.frame.module;
        let module_name = self.heap[module].name;
        self.heap.bytes += 64;
        Value::Function(self.heap.alloc(Function {
            code: id,
            module,
            name: linked.name,
            qualname: linked.qualname,
            doc: linked.doc,
            module_name,
            defaults,
            kwdefaults,
            closure,
            annotations,
            attrs: Attrs::default(),
        }))
    }

    fn pop_cells(&mut self) -> SmallVec<[Ref<Cell>; 2]> {
        let Value::Tuple(t) = self.pop() else { return SmallVec::new() };
        self.heap[t].0.iter().filter_map(|v| if let Value::Cell(c) = v { Some(*c) } else { None }).collect()
    }

    fn pop_keywords(&mut self) -> SmallVec<[(Symbol, Value); 1]> {
        let Value::Dict(d) = self.pop() else { return SmallVec::new() };
        let items: Vec<(Value, Value)> = self.heap[d].0.iter().map(|e| (e.key, e.value)).collect();
        items.into_iter().map(|(k, v)| (self.intern_value(k), v)).collect()
    }

    /// Runs a class body over its namespace.
    pub(super) fn run_class_body(&mut self, body: Ref<Function>, namespace: Value) -> R<()> {
        let start = self.stack.len();
        match self.begin_function(body, start, start, &[], Return::Native)? {
            Begun::Done => {
                self.pop();
                Ok(())
            }
            Begun::Frame => {
                debug_assert_eq!(self.codes[self.frame.code.0 as usize].code().kind, CodeKind::Class);
                self.frame.namespace = namespace;
                self.run_nested().map(|_| ())
            }
        }
    }
}
