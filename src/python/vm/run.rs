//! The main loop.

use super::Vm;
use super::attr::Found;
use super::call::{Begun, Few};
use crate::python::classes::Builtin;
use crate::python::code::Op;
use crate::python::error::{R, Raise};
use crate::python::frame::Return;
use crate::python::heap::*;
use crate::python::iter::IterState;
use crate::python::symbols::sym;
use crate::python::value::{BinaryOp, CompareOp, Symbol, Value};
use smallvec::SmallVec;
use std::rc::Rc;

impl Vm<'_> {
    /// Runs the frame that was just pushed until it is done.
    pub(super) fn run_nested(&mut self) -> R<Value> {
        let bottom = self.frames.len() - 1;
        self.nested_run(bottom)
    }

    /// Runs the current frame until the frames are `bottom` again.
    pub(super) fn nested_run(&mut self, bottom: usize) -> R<Value> {
        self.native_depth += 1;
        let result = stacker::maybe_grow(256 << 10, 4 << 20, || self.run(bottom));
        self.native_depth -= 1;
        result
    }

    pub(super) fn run(&mut self, bottom: usize) -> R<Value> {
        loop {
            match self.execute() {
                Ok(value) => return Ok(value),
                Err(raise) => self.unwind(raise, bottom)?,
            }
        }
    }

    #[inline(always)]
    pub(super) fn pop(&mut self) -> Value {
        self.stack.pop().unwrap_or(Value::Undefined)
    }

    #[inline(always)]
    fn top(&self) -> Value {
        self.stack[self.stack.len() - 1]
    }

    #[inline(always)]
    fn set_top(&mut self, value: Value) {
        let top = self.stack.len() - 1;
        self.stack[top] = value;
    }

    #[inline(always)]
    fn pop2(&mut self) -> (Value, Value) {
        let b = self.pop();
        let a = self.pop();
        (a, b)
    }

    /// Runs instructions until a frame that native code began is done, or a generator yields.
    fn execute(&mut self) -> R<Value> {
        'frame: loop {
            let linked = Rc::clone(&self.codes[self.frame.code.0 as usize]);
            let code = linked.code();
            let ops = &code.ops[..];
            let base = self.frame.base as usize;
            let mut pc = self.frame.pc as usize;
            loop {
                let op = &ops[pc];
                pc += 1;
                self.frame.pc = pc as u32;
                // By reference: only the operands of the instruction at hand are read.
                match *op {
                    Op::Nop => {}
                    Op::Pop => {
                        self.stack.pop();
                    }
                    Op::Dup => self.stack.push(self.top()),
                    Op::Dup2 => {
                        let n = self.stack.len();
                        self.stack.extend_from_within(n - 2..);
                    }
                    Op::Swap => {
                        let n = self.stack.len();
                        self.stack.swap(n - 1, n - 2);
                    }
                    Op::Rot3 => {
                        let n = self.stack.len();
                        self.stack[n - 3..].rotate_right(1);
                    }
                    Op::Rot4 => {
                        let n = self.stack.len();
                        self.stack[n - 4..].rotate_right(1);
                    }
                    Op::Copy(n) => {
                        let at = self.stack.len() - 1 - usize::from(n);
                        self.stack.push(self.stack[at]);
                    }
                    Op::Const(i) => self.stack.push(linked.consts[i as usize]),
                    Op::LoadFast(slot) => {
                        let value = self.stack[base + usize::from(slot)];
                        if value.is_undefined() {
                            return Err(self.unbound_local(&code.locals[usize::from(slot)]));
                        }
                        self.stack.push(value);
                    }
                    Op::LoadFastFast { a, b } => {
                        let (x, y) = (self.stack[base + usize::from(a)], self.stack[base + usize::from(b)]);
                        if x.is_undefined() || y.is_undefined() {
                            let slot = if x.is_undefined() { a } else { b };
                            return Err(self.unbound_local(&code.locals[usize::from(slot)]));
                        }
                        self.stack.push(x);
                        self.stack.push(y);
                    }
                    Op::StoreFast(slot) => {
                        let value = self.pop();
                        self.stack[base + usize::from(slot)] = value;
                    }
                    Op::DeleteFast(slot) => {
                        let place = &mut self.stack[base + usize::from(slot)];
                        if std::mem::replace(place, Value::Undefined).is_undefined() {
                            return Err(self.unbound_local(&code.locals[usize::from(slot)]));
                        }
                    }
                    Op::LoadDeref(slot) => {
                        let value = self.cell_value(base + usize::from(slot));
                        if value.is_undefined() {
                            return Err(self.unbound_cell(usize::from(slot)));
                        }
                        self.stack.push(value);
                    }
                    Op::StoreDeref(slot) => {
                        let value = self.pop();
                        if let Value::Cell(cell) = self.stack[base + usize::from(slot)] {
                            self.heap[cell].0 = value;
                        }
                    }
                    Op::DeleteDeref(slot) => {
                        let old = self.cell_value(base + usize::from(slot));
                        if old.is_undefined() {
                            return Err(self.unbound_cell(usize::from(slot)));
                        }
                        if let Value::Cell(cell) = self.stack[base + usize::from(slot)] {
                            self.heap[cell].0 = Value::Undefined;
                        }
                    }
                    Op::LoadClosure(slot) => self.stack.push(self.stack[base + usize::from(slot)]),
                    Op::LoadClassDeref { slot, name } => {
                        let value = match self.namespace_get(self.frame.namespace, linked.names[name as usize])? {
                            Some(v) => v,
                            None => self.cell_value(base + usize::from(slot)),
                        };
                        if value.is_undefined() {
                            return Err(self.unbound_cell(usize::from(slot)));
                        }
                        self.stack.push(value);
                    }
                    Op::LoadGlobal(slot) => {
                        let mut value = self.heap[self.frame.module].slots[slot as usize];
                        if value.is_undefined() {
                            value = self.load_builtin(slot)?;
                        }
                        self.stack.push(value);
                    }
                    Op::StoreGlobal(slot) => {
                        let value = self.pop();
                        self.heap[self.frame.module].slots[slot as usize] = value;
                    }
                    Op::DeleteGlobal(slot) => {
                        let place = &mut self.heap[self.frame.module].slots[slot as usize];
                        if std::mem::replace(place, Value::Undefined).is_undefined() {
                            let name = self.heap[self.frame.module].names[slot as usize];
                            return Err(self.name_error(name));
                        }
                    }
                    Op::LoadName { name, slot } => {
                        let value = match self.namespace_get(self.frame.namespace, linked.names[name as usize])? {
                            Some(v) => v,
                            None => match self.heap[self.frame.module].slots[slot as usize] {
                                Value::Undefined => self.load_builtin(slot)?,
                                v => v,
                            },
                        };
                        self.stack.push(value);
                    }
                    Op::StoreName(name) => {
                        let value = self.pop();
                        self.store_name(linked.names[name as usize], value)?;
                    }
                    Op::DeleteName(name) => self.delete_name(linked.names[name as usize])?,
                    Op::LoadAttr(name) => {
                        let object = self.top();
                        let name = linked.names[name as usize];
                        if let Some(Found::Value(value)) = self.quick_attr(object, name) {
                            self.set_top(value);
                            continue;
                        }
                        if let Some(getter) = self.property_getter(object, name) {
                            let start = self.stack.len() - 1;
                            if let Begun::Frame = self.begin_function(getter, start, start, &[], Return::Push)? {
                                continue 'frame;
                            }
                            continue;
                        }
                        let value = self.get_attr(object, name)?;
                        self.set_top(value);
                    }
                    Op::LoadFastAttr { slot, name } => {
                        let object = self.stack[base + usize::from(slot)];
                        if object.is_undefined() {
                            return Err(self.unbound_local(&code.locals[usize::from(slot)]));
                        }
                        let name = linked.names[name as usize];
                        if let Some(Found::Value(value)) = self.quick_attr(object, name) {
                            self.stack.push(value);
                            continue;
                        }
                        if let Some(getter) = self.property_getter(object, name) {
                            let start = self.stack.len();
                            self.stack.push(object);
                            if let Begun::Frame = self.begin_function(getter, start, start, &[], Return::Push)? {
                                continue 'frame;
                            }
                            continue;
                        }
                        let value = self.get_attr(object, name)?;
                        self.stack.push(value);
                    }
                    Op::StoreAttr(name) => {
                        let object = self.pop();
                        let value = self.pop();
                        self.set_attr(object, linked.names[name as usize], value)?;
                    }
                    Op::DeleteAttr(name) => {
                        let object = self.pop();
                        self.del_attr(object, linked.names[name as usize])?;
                    }
                    Op::LoadMethod(name) => {
                        let object = self.top();
                        let name = linked.names[name as usize];
                        match self.find_attr(object, name)? {
                            Some(Found::Method(function)) => {
                                self.set_top(function);
                                self.stack.push(object);
                            }
                            Some(Found::Value(value)) => {
                                self.set_top(value);
                                self.stack.push(Value::Undefined);
                            }
                            None => return Err(self.no_attribute(object, name)),
                        }
                    }
                    Op::LoadSubscr => {
                        let (object, index) = self.pop2();
                        let value = match (object, index) {
                            (Value::List(l), Value::Int(i, h)) if h.is_none() => {
                                let items = &self.heap[l].0;
                                let at = if i < 0 { i + items.len() as i64 } else { i };
                                match usize::try_from(at).ok().and_then(|at| items.get(at)) {
                                    Some(v) => *v,
                                    None => self.get_item(object, index)?,
                                }
                            }
                            (Value::Tuple(t), Value::Int(i, h)) if h.is_none() && i >= 0 => match self.heap[t].0.get(i as usize) {
                                Some(v) => *v,
                                None => self.get_item(object, index)?,
                            },
                            _ => self.get_item(object, index)?,
                        };
                        self.stack.push(value);
                    }
                    Op::StoreSubscr => {
                        let (object, index) = self.pop2();
                        let value = self.pop();
                        self.set_item(object, index, value)?;
                    }
                    Op::DeleteSubscr => {
                        let (object, index) = self.pop2();
                        self.del_item(object, index)?;
                    }
                    Op::Binary(op) => {
                        let b = self.pop();
                        let a = self.top();
                        let value = match fast_binary(op, a, b) {
                            Some(v) => v,
                            None => self.binary(op, a, b)?,
                        };
                        self.set_top(value);
                    }
                    Op::BinaryFastFast { op, a, b } => {
                        let (x, y) = (self.stack[base + usize::from(a)], self.stack[base + usize::from(b)]);
                        let value = match fast_binary(op, x, y) {
                            Some(v) => v,
                            None => {
                                if x.is_undefined() || y.is_undefined() {
                                    let slot = if x.is_undefined() { a } else { b };
                                    return Err(self.unbound_local(&code.locals[usize::from(slot)]));
                                }
                                self.binary(op, x, y)?
                            }
                        };
                        self.stack.push(value);
                    }
                    Op::BinaryFastConst { op, a, constant } => {
                        let x = self.stack[base + usize::from(a)];
                        let y = linked.consts[usize::from(constant)];
                        let value = match fast_binary(op, x, y) {
                            Some(v) => v,
                            None => {
                                if x.is_undefined() {
                                    return Err(self.unbound_local(&code.locals[usize::from(a)]));
                                }
                                self.binary(op, x, y)?
                            }
                        };
                        self.stack.push(value);
                    }
                    Op::BinaryConst { op, constant } => {
                        let a = self.top();
                        let b = linked.consts[usize::from(constant)];
                        let value = match fast_binary(op, a, b) {
                            Some(v) => v,
                            None => self.binary(op, a, b)?,
                        };
                        self.set_top(value);
                    }
                    Op::BinaryFast { op, b } => {
                        let a = self.top();
                        let y = self.stack[base + usize::from(b)];
                        if y.is_undefined() {
                            return Err(self.unbound_local(&code.locals[usize::from(b)]));
                        }
                        let value = match fast_binary(op, a, y) {
                            Some(v) => v,
                            None => self.binary(op, a, y)?,
                        };
                        self.set_top(value);
                    }
                    Op::Inplace(op) => {
                        let b = self.pop();
                        let a = self.top();
                        let value = match fast_binary(op, a, b) {
                            Some(v) => v,
                            None => self.inplace(op, a, b)?,
                        };
                        self.set_top(value);
                    }
                    Op::Unary(op) => {
                        let value = self.top();
                        let value = self.unary(op, value)?;
                        self.set_top(value);
                    }
                    Op::Not => {
                        let value = self.top();
                        let truth = self.truth(value)?;
                        self.set_top(Value::Bool(!truth));
                    }
                    Op::Compare(op) => {
                        let b = self.pop();
                        let a = self.top();
                        let value = match fast_compare(op, a, b) {
                            Some(v) => Value::Bool(v),
                            None => self.compare(op, a, b)?,
                        };
                        self.set_top(value);
                    }
                    Op::CompareJump { op, target } => {
                        let (a, b) = self.pop2();
                        let holds = match fast_compare(op, a, b) {
                            Some(v) => v,
                            None => {
                                let value = self.compare(op, a, b)?;
                                self.truth(value)?
                            }
                        };
                        if !holds {
                            pc = target as usize;
                        }
                    }
                    Op::Is(negated) => {
                        let (a, b) = self.pop2();
                        self.stack.push(Value::Bool(a.is(b) != negated));
                    }
                    Op::In(negated) => {
                        let (item, container) = self.pop2();
                        let found = self.contains(container, item)?;
                        self.stack.push(Value::Bool(found != negated));
                    }
                    Op::Jump(target) => pc = target as usize,
                    Op::JumpBack(target) => {
                        self.charge((pc - target as usize) as u64)?;
                        if self.heap.bytes > self.collect_at && self.native_depth == 0 {
                            self.collect_garbage()?;
                        }
                        pc = target as usize;
                    }
                    Op::PopJumpIfFalse(target) => {
                        let value = self.pop();
                        let truth = if let Value::Bool(b) = value { b } else { self.truth(value)? };
                        if !truth {
                            pc = target as usize;
                        }
                    }
                    Op::PopJumpIfTrue(target) => {
                        let value = self.pop();
                        let truth = if let Value::Bool(b) = value { b } else { self.truth(value)? };
                        if truth {
                            pc = target as usize;
                        }
                    }
                    Op::JumpIfFalseOrPop(target) => {
                        let value = self.top();
                        if self.truth(value)? {
                            self.stack.pop();
                        } else {
                            pc = target as usize;
                        }
                    }
                    Op::JumpIfTrueOrPop(target) => {
                        let value = self.top();
                        if self.truth(value)? {
                            pc = target as usize;
                        } else {
                            self.stack.pop();
                        }
                    }
                    Op::PopJumpIfNone(target) => {
                        if self.pop().is_none() {
                            pc = target as usize;
                        }
                    }
                    Op::GetIter => {
                        let value = self.top();
                        let iter = self.iter(value)?;
                        self.set_top(iter);
                    }
                    Op::StartLoop => {
                        let value = self.top();
                        let iter = self.iter(value)?;
                        self.set_top(iter);
                        self.stack.push(Value::int(0));
                    }
                    Op::ForIter(target) => {
                        let top = self.stack.len() - 1;
                        match self.next_item(self.stack[top - 1])? {
                            Some(item) => {
                                if let Value::Int(n, _) = &mut self.stack[top] {
                                    *n += 1;
                                }
                                self.stack.push(item);
                            }
                            None => {
                                self.stack.truncate(top - 1);
                                pc = target as usize;
                            }
                        }
                    }
                    Op::BuildTuple(n) => {
                        let items: SmallVec<[Value; 3]> = self.stack.drain(self.stack.len() - n as usize..).collect();
                        let tuple = self.heap.tuple(items);
                        self.stack.push(tuple);
                    }
                    Op::BuildList(n) => {
                        let at = self.stack.len() - n as usize;
                        let items = self.stack.split_off(at);
                        let list = self.heap.list(items);
                        self.stack.push(list);
                    }
                    Op::BuildSet(n) => {
                        let items: Few = self.stack.drain(self.stack.len() - n as usize..).collect();
                        let set = self.heap.alloc(Set::default());
                        for item in items {
                            self.set_add(set, item)?;
                        }
                        self.stack.push(Value::Set(set));
                    }
                    Op::BuildDict(n) => {
                        let items: Few = self.stack.drain(self.stack.len() - 2 * n as usize..).collect();
                        let dict = self.heap.dict();
                        for pair in items.chunks_exact(2) {
                            self.dict_set(dict, pair[0], pair[1])?;
                        }
                        self.stack.push(Value::Dict(dict));
                    }
                    Op::BuildString(n) => self.build_string(n as usize)?,
                    Op::BuildSlice(n) => {
                        let step = if n == 3 { self.pop() } else { Value::None };
                        let (start, stop) = self.pop2();
                        let slice = Value::Slice(self.heap.alloc(Slice { start, stop, step }));
                        self.stack.push(slice);
                    }
                    Op::ListAppend(n) => {
                        let item = self.pop();
                        let at = self.stack.len() - 1 - usize::from(n);
                        if let Value::List(l) = self.stack[at] {
                            self.list_push(l, item)?;
                        }
                    }
                    Op::SetAdd(n) => {
                        let item = self.pop();
                        let at = self.stack.len() - 1 - usize::from(n);
                        if let Value::Set(s) = self.stack[at] {
                            self.set_add(s, item)?;
                        }
                    }
                    Op::DictAdd(n) => {
                        let (key, value) = self.pop2();
                        let at = self.stack.len() - 1 - usize::from(n);
                        if let Value::Dict(d) = self.stack[at] {
                            self.dict_set(d, key, value)?;
                        }
                    }
                    Op::ListExtend => {
                        let iterable = self.pop();
                        let items = self.collect_starred(iterable)?;
                        if let Value::List(l) = self.top() {
                            self.heap.bytes += items.len() * 16;
                            self.heap[l].0.extend(items);
                        }
                    }
                    Op::SetUpdate => {
                        let iterable = self.pop();
                        let items = self.collect(iterable)?;
                        if let Value::Set(s) = self.top() {
                            for item in items {
                                self.set_add(s, item)?;
                            }
                        }
                    }
                    Op::DictUpdate => {
                        let mapping = self.pop();
                        if let Value::Dict(d) = self.top() {
                            self.update_from_mapping(d, mapping)?;
                        }
                    }
                    Op::DictMerge(n) => {
                        let mapping = self.pop();
                        let callee = self.stack[self.stack.len() - 1 - usize::from(n)];
                        if let Value::Dict(d) = self.top() {
                            self.merge_keywords(d, mapping, callee)?;
                        }
                    }
                    Op::ListToTuple => {
                        if let Value::List(l) = self.top() {
                            let items = self.heap[l].0.clone();
                            let tuple = self.heap.tuple(items);
                            self.set_top(tuple);
                        }
                    }
                    Op::Format { conversion, spec } => self.format_op(conversion, spec)?,
                    Op::Unpack(n) => self.unpack(n as usize)?,
                    Op::UnpackEx { before, after } => self.unpack_ex(usize::from(before), usize::from(after))?,
                    Op::MakeFunction { child, flags } => {
                        let function = self.make_function(child, flags);
                        self.stack.push(function);
                    }
                    Op::Call(n) => {
                        let start = self.stack.len() - n as usize;
                        let callee = self.stack[start - 1];
                        if let Begun::Frame = self.begin_call(callee, start - 1, start, &[])? {
                            continue 'frame;
                        }
                    }
                    Op::CallMethod(n) => {
                        let start = self.stack.len() - n as usize;
                        let callee = self.stack[start - 2];
                        if let Value::Native(native) = callee
                            && !self.stack[start - 1].is_undefined()
                        {
                            let args: Few = SmallVec::from_slice(&self.stack[start - 1..]);
                            let value = self.call_native(native, crate::python::native::Args::new(&args))?;
                            self.stack.truncate(start - 2);
                            self.stack.push(value);
                            continue;
                        }
                        if let Begun::Frame = self.begin_method(callee, start, &[])? {
                            continue 'frame;
                        }
                    }
                    Op::CallKw { count, names } => {
                        let keywords = self.take_keywords(linked.consts[names as usize]);
                        let start = self.stack.len() + keywords.len() - usize::from(count);
                        let callee = self.stack[start - 1];
                        if let Begun::Frame = self.begin_call(callee, start - 1, start, &keywords)? {
                            continue 'frame;
                        }
                    }
                    Op::CallMethodKw { count, names } => {
                        let keywords = self.take_keywords(linked.consts[names as usize]);
                        let start = self.stack.len() + keywords.len() - usize::from(count);
                        let callee = self.stack[start - 2];
                        if let Begun::Frame = self.begin_method(callee, start, &keywords)? {
                            continue 'frame;
                        }
                    }
                    Op::CallEx(with_keywords) => {
                        let keywords = if with_keywords { self.keywords_from_dict()? } else { SmallVec::new() };
                        let args = self.pop();
                        let floor = self.stack.len() - 1;
                        let callee = self.stack[floor];
                        let args = self.starred_arguments(callee, args)?;
                        self.stack.extend_from_slice(&args);
                        if let Begun::Frame = self.begin_call(callee, floor, floor + 1, &keywords)? {
                            continue 'frame;
                        }
                    }
                    Op::Return => {
                        let value = self.pop();
                        let frame = self.frame;
                        self.stack.truncate(frame.floor as usize);
                        if let Some(below) = self.frames.pop() {
                            self.frame = below;
                        }
                        match frame.ret {
                            Return::Push => self.stack.push(value),
                            Return::Native => return Ok(value),
                            Return::Instance => {
                                if !value.is_none() {
                                    let message = format!("__init__() should return None, not '{}'", self.type_name(value));
                                    return Err(self.type_error(message));
                                }
                            }
                        }
                        continue 'frame;
                    }
                    Op::Yield => {
                        let value = self.pop();
                        return Ok(self.suspend(value));
                    }
                    Op::YieldFrom => {
                        if let Some(value) = self.delegate()? {
                            self.frame.pc = (pc - 1) as u32;
                            return Ok(self.suspend(value));
                        }
                    }
                    Op::Raise(n) => return Err(self.raise_op(n)),
                    Op::Reraise => {
                        let exception = self.pop();
                        self.reraising = true;
                        return Err(Raise::Exception(exception));
                    }
                    Op::PushExc => {
                        let exception = self.top();
                        self.handling.push(exception);
                    }
                    Op::PopExc => {
                        self.handling.pop();
                    }
                    Op::ExcMatch => {
                        let class = self.pop();
                        let exception = self.top();
                        let matches = self.exception_matches(exception, class)?;
                        self.stack.push(Value::Bool(matches));
                    }
                    Op::ExcGroupMatch => {
                        let (group, class) = self.pop2();
                        let (matched, rest) = self.split_group(group, class)?;
                        self.stack.push(rest);
                        self.stack.push(matched);
                    }
                    Op::ExcGroupFinish => {
                        let (original, raised) = self.pop2();
                        let raised = self.collect(raised)?;
                        let value = self.finish_group(original, &raised)?;
                        self.stack.push(value);
                    }
                    Op::BeforeWith => {
                        let manager = self.pop();
                        let (exit, entered) = self.before_with(manager)?;
                        self.stack.push(exit);
                        self.stack.push(entered);
                    }
                    Op::WithExcept => {
                        let n = self.stack.len();
                        let (exit, exception) = (self.stack[n - 2], self.stack[n - 1]);
                        let class = Value::Class(self.class_of(exception));
                        let traceback = self.traceback(exception);
                        let said = self.call(exit, &[class, exception, traceback])?;
                        let truth = self.truth(said)?;
                        self.stack.push(Value::Bool(truth));
                    }
                    Op::Import { name, from } => {
                        let module = self.import(linked.names[name as usize], from)?;
                        self.stack.push(module);
                    }
                    Op::ImportFrom(name) => {
                        let module = self.top();
                        let value = self.import_from(module, linked.names[name as usize])?;
                        self.stack.push(value);
                    }
                    Op::ImportStar => {
                        let module = self.pop();
                        self.import_star(module)?;
                    }
                    Op::BuildClass => self.stack.push(Value::Native(&super::import::BUILD_CLASS)),
                    Op::AssertionError => self.stack.push(Builtin::AssertionError.value()),
                    Op::MatchSequence => {
                        let value = self.match_sequence(self.top());
                        self.stack.push(Value::Bool(value));
                    }
                    Op::MatchMapping => {
                        let value = self.match_mapping(self.top());
                        self.stack.push(Value::Bool(value));
                    }
                    Op::GetLen => {
                        let n = self.len(self.top())?;
                        self.stack.push(Value::int(n as i64));
                    }
                    Op::MatchKeys => {
                        let n = self.stack.len();
                        let (subject, keys) = (self.stack[n - 2], self.stack[n - 1]);
                        let values = self.match_keys(subject, keys)?;
                        self.stack.push(values);
                    }
                    Op::MatchClass(n) => {
                        let names = self.pop();
                        let (subject, class) = self.pop2();
                        let value = self.match_class(subject, class, n as usize, names)?;
                        self.stack.push(value);
                    }
                    Op::MatchRest => {
                        let (subject, keys) = self.pop2();
                        let rest = self.match_rest(subject, keys)?;
                        self.stack.push(rest);
                    }
                    Op::Direction(id) => {
                        if let Some(turn) = self.direction_override(id) {
                            self.set_top(Value::int(i64::from(turn)));
                        }
                    }
                    Op::Statement(_) => self.host.statement_begins(),
                }
            }
        }
    }

    #[inline(always)]
    fn cell_value(&self, at: usize) -> Value {
        match self.stack[at] {
            Value::Cell(cell) => self.heap[cell].0,
            _ => Value::Undefined,
        }
    }

    /// The next item of an iterator, the common ones at once.
    #[inline]
    fn next_item(&mut self, iter: Value) -> R<Option<Value>> {
        if let Value::Iter(r) = iter {
            match &mut self.heap[r].0 {
                IterState::Range { next, step, left } => {
                    if *left == 0 {
                        return Ok(None);
                    }
                    *left -= 1;
                    let value = *next;
                    *next = next.wrapping_add(*step);
                    return Ok(Some(Value::int(value)));
                }
                IterState::List { list, index } => {
                    let (list, at) = (*list, *index);
                    *index += 1;
                    if let Some(v) = self.heap[list].0.get(at) {
                        return Ok(Some(*v));
                    }
                    self.heap[r].0.finish();
                    return Ok(None);
                }
                _ => {}
            }
        }
        self.next(iter)
    }

    fn begin_method(&mut self, callee: Value, start: usize, keywords: &[(Symbol, Value)]) -> R<Begun> {
        if self.stack[start - 1].is_undefined() {
            self.begin_call(callee, start - 2, start, keywords)
        } else {
            self.begin_call(callee, start - 2, start - 1, keywords)
        }
    }

    /// Takes the values of keyword arguments off the stack.
    fn take_keywords(&mut self, names: Value) -> SmallVec<[(Symbol, Value); 8]> {
        let Value::Tuple(t) = names else { return SmallVec::new() };
        let n = self.heap[t].0.len();
        let values: Few = self.stack.drain(self.stack.len() - n..).collect();
        let mut out = SmallVec::new();
        for (i, value) in values.into_iter().enumerate() {
            let name = self.heap[t].0[i];
            out.push((self.intern_value(name), value));
        }
        out
    }

    fn keywords_from_dict(&mut self) -> R<SmallVec<[(Symbol, Value); 8]>> {
        let Value::Dict(d) = self.pop() else { return Ok(SmallVec::new()) };
        let items: Vec<(Value, Value)> = self.heap[d].0.iter().map(|e| (e.key, e.value)).collect();
        let mut out = SmallVec::new();
        for (key, value) in items {
            if !matches!(self.plain(key), Value::Str(_)) {
                return Err(self.type_error("keywords must be strings"));
            }
            out.push((self.intern_value(key), value));
        }
        Ok(out)
    }

    fn store_name(&mut self, name: Symbol, value: Value) -> R<()> {
        let key = self.symbol_text(name);
        match self.frame.namespace {
            Value::Dict(d) => self.dict_set(d, key, value),
            Value::Undefined => {
                self.module_set(self.frame.module, name, value);
                Ok(())
            }
            namespace => self.set_item(namespace, key, value),
        }
    }

    fn delete_name(&mut self, name: Symbol) -> R<()> {
        let key = self.symbol_text(name);
        match self.frame.namespace {
            Value::Dict(d) => match self.dict_remove(d, key)? {
                Some(_) => Ok(()),
                None => Err(self.name_error(name)),
            },
            namespace => self.del_item(namespace, key),
        }
    }

    #[cold]
    fn unbound_local(&mut self, name: &str) -> Raise {
        let message = if name.starts_with('.') {
            "a hidden variable is unbound".to_string()
        } else {
            format!("cannot access local variable '{name}' where it is not associated with a value")
        };
        self.error(Builtin::UnboundLocalError, message)
    }

    #[cold]
    fn unbound_cell(&mut self, slot: usize) -> Raise {
        let linked = Rc::clone(&self.codes[self.frame.code.0 as usize]);
        let code = linked.code();
        let at = slot - code.locals.len();
        match code.cells.get(at) {
            Some((name, _)) => self.unbound_local(name),
            None => {
                let name = code.frees.get(at - code.cells.len()).map_or("", |n| n);
                let message = format!("cannot access free variable '{name}' where it is not associated with a value in enclosing scope");
                self.error(Builtin::NameError, message)
            }
        }
    }

    #[cold]
    pub(super) fn name_error(&mut self, name: Symbol) -> Raise {
        let text = self.symbols.text(name).to_string();
        let raise = self.error(Builtin::NameError, format!("name '{text}' is not defined"));
        if let Raise::Exception(e) = raise {
            let value = self.symbol_text(name);
            self.set_own_attr(e, sym::N_NAME, value);
        }
        raise
    }
}

/// Arithmetic on untraced numbers that needs no thought.
#[inline(always)]
fn fast_binary(op: BinaryOp, a: Value, b: Value) -> Option<Value> {
    match (a, b) {
        (Value::Float(x, h), Value::Float(y, k)) if (h.0 | k.0) == 0 => fast_float(op, x, y),
        (Value::Int(x, h), Value::Int(y, k)) if (h.0 | k.0) == 0 => match op {
            BinaryOp::Add => x.checked_add(y).map(Value::int),
            BinaryOp::Sub => x.checked_sub(y).map(Value::int),
            BinaryOp::Mul => x.checked_mul(y).map(Value::int),
            BinaryOp::FloorDiv if y > 0 => Some(Value::int(x.div_euclid(y))),
            BinaryOp::Mod if y > 0 => Some(Value::int(x.rem_euclid(y))),
            BinaryOp::And => Some(Value::int(x & y)),
            BinaryOp::Or => Some(Value::int(x | y)),
            BinaryOp::Xor => Some(Value::int(x ^ y)),
            _ => None,
        },
        (Value::Float(x, h), Value::Int(y, k)) if (h.0 | k.0) == 0 && y.unsigned_abs() < 1 << 53 => fast_float(op, x, y as f64),
        (Value::Int(x, h), Value::Float(y, k)) if (h.0 | k.0) == 0 && x.unsigned_abs() < 1 << 53 => fast_float(op, x as f64, y),
        _ => None,
    }
}

#[inline(always)]
fn fast_float(op: BinaryOp, x: f64, y: f64) -> Option<Value> {
    Some(Value::float(match op {
        BinaryOp::Add => x + y,
        BinaryOp::Sub => x - y,
        BinaryOp::Mul => x * y,
        BinaryOp::Div if y != 0.0 => x / y,
        _ => return None,
    }))
}

#[inline(always)]
fn fast_compare(op: CompareOp, a: Value, b: Value) -> Option<bool> {
    match (a, b) {
        (Value::Int(x, h), Value::Int(y, k)) if (h.0 | k.0) == 0 => Some(match op {
            CompareOp::Lt => x < y,
            CompareOp::Le => x <= y,
            CompareOp::Eq => x == y,
            CompareOp::Ne => x != y,
            CompareOp::Gt => x > y,
            CompareOp::Ge => x >= y,
        }),
        (Value::Float(x, h), Value::Float(y, k)) if (h.0 | k.0) == 0 => Some(match op {
            CompareOp::Lt => x < y,
            CompareOp::Le => x <= y,
            CompareOp::Eq => x == y,
            CompareOp::Ne => x != y,
            CompareOp::Gt => x > y,
            CompareOp::Ge => x >= y,
        }),
        _ => None,
    }
}
