//! The main loop.

use super::Vm;
use super::advance::Next;
use super::attr::{Found, QuickAttr};
use super::call::Begun;
use super::fast::{Quick, arithmetic, comparison, push_copy, set};
use crate::python::code::Op;
use crate::python::error::{R, Raise};
use crate::python::frame::Return;
use crate::python::heap::*;
use crate::python::value::{CompareOp, Symbol, UnaryOp, Value};
use smallvec::SmallVec;
use std::rc::Rc;

/// Goes on with the next instruction where a number came out at once, after `$then`.
macro_rules! quick {
    ($number:expr, $value:ident => $then:expr) => {
        match $number {
            Quick::Float(x) => {
                let $value = Value::float(x);
                $then;
                continue;
            }
            Quick::Int(x) => {
                let $value = Value::int(x);
                $then;
                continue;
            }
            Quick::No => {}
        }
    };
}

impl Vm<'_> {
    /// Runs the frame that was just pushed until it is done.
    pub(super) fn run_nested(&mut self) -> R<Value> {
        let bottom = self.frames.len() - 1;
        self.nested_run(bottom)
    }

    /// Runs the current frame until the frames are `bottom` again.
    pub(super) fn nested_run(&mut self, bottom: usize) -> R<Value> {
        self.countdown = self.countdown.saturating_sub(12);
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
    pub(super) fn top(&self) -> Value {
        self.stack[self.stack.len() - 1]
    }

    #[inline(always)]
    pub(super) fn set_top(&mut self, value: Value) {
        let top = self.stack.len() - 1;
        self.stack[top] = value;
    }

    #[inline(always)]
    pub(super) fn pop2(&mut self) -> (Value, Value) {
        let b = self.pop();
        let a = self.pop();
        (a, b)
    }

    /// Runs instructions until a frame that native code began is done, or a generator yields.
    fn execute(&mut self) -> R<Value> {
        'frame: loop {
            let linked = Rc::clone(&self.codes[self.frame.code.0 as usize]);
            let ops = &linked.ops[..];
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
                    Op::Dup => {
                        let top = self.stack.len() - 1;
                        self.push_from(top);
                    }
                    Op::Dup2 => {
                        let n = self.stack.len();
                        self.stack.extend_from_within(n - 2..);
                    }
                    Op::Swap => {
                        let n = self.stack.len();
                        self.stack.swap(n - 1, n - 2);
                    }
                    Op::Copy(n) => {
                        let at = self.stack.len() - 1 - usize::from(n);
                        self.push_from(at);
                    }
                    Op::Const(i) => push_copy(&mut self.stack, &linked.consts[i as usize]),
                    Op::LoadFast(slot) => {
                        let at = base + usize::from(slot);
                        if self.stack[at].is_undefined() {
                            return Err(self.unbound_slot(&linked, slot));
                        }
                        self.push_from(at);
                    }
                    Op::LoadFastFast { a, b } => {
                        for slot in [a, b] {
                            let at = base + usize::from(slot);
                            if self.stack[at].is_undefined() {
                                return Err(self.unbound_slot(&linked, slot));
                            }
                            self.push_from(at);
                        }
                    }
                    Op::StoreFast(slot) => {
                        let top = self.stack.len() - 1;
                        self.copy_on_stack(top, base + usize::from(slot));
                        self.stack.truncate(top);
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
                    Op::LoadClosure(slot) => self.stack.push(self.stack[base + usize::from(slot)]),
                    Op::LoadGlobal(slot) => {
                        let place = &self.heap[self.frame.module].slots[slot as usize];
                        if place.is_undefined() {
                            let value = self.load_builtin(slot)?;
                            self.stack.push(value);
                        } else {
                            push_copy(&mut self.stack, place);
                        }
                    }
                    Op::StoreGlobal(slot) => {
                        let top = self.stack.len() - 1;
                        let place = &mut self.heap[self.frame.module].slots[slot as usize];
                        set(place, &self.stack[top]);
                        self.stack.truncate(top);
                    }
                    Op::LoadAttr(name) => {
                        let name = linked.names[name as usize];
                        let top = self.stack.len() - 1;
                        match Vm::quick_attr(&self.heap, &self.attr_cache, &self.stack[top], name) {
                            QuickAttr::Value(value) => set(&mut self.stack[top], value),
                            QuickAttr::Property(getter) => {
                                if let Begun::Frame = self.begin_function(getter, top, top, &[], Return::Push)? {
                                    continue 'frame;
                                }
                            }
                            QuickAttr::Method(_) | QuickAttr::No => {
                                let value = self.get_attr(self.stack[top], name)?;
                                self.stack[top] = value;
                            }
                        }
                    }
                    Op::LoadFastAttr { slot, name } => {
                        let at = base + usize::from(slot);
                        let name = linked.names[name as usize];
                        match Vm::quick_attr(&self.heap, &self.attr_cache, &self.stack[at], name) {
                            QuickAttr::Value(value) => push_copy(&mut self.stack, value),
                            QuickAttr::Property(getter) => {
                                let start = self.stack.len();
                                self.stack.push(self.stack[at]);
                                if self.enter(getter, start, start) {
                                    continue 'frame;
                                }
                                if let Begun::Frame = self.begin_function(getter, start, start, &[], Return::Push)? {
                                    continue 'frame;
                                }
                            }
                            QuickAttr::Method(_) | QuickAttr::No => {
                                if self.stack[at].is_undefined() {
                                    return Err(self.unbound_slot(&linked, slot));
                                }
                                let value = self.get_attr(self.stack[at], name)?;
                                self.stack.push(value);
                            }
                        }
                    }
                    Op::StoreAttr(name) => {
                        let name = linked.names[name as usize];
                        let top = self.stack.len() - 1;
                        if !self.quick_store(name) {
                            let (value, object) = (self.stack[top - 1], self.stack[top]);
                            self.stack.truncate(top - 1);
                            self.set_attr(object, name, value)?;
                        }
                    }
                    Op::LoadMethod(name) => {
                        let name = linked.names[name as usize];
                        let top = self.stack.len() - 1;
                        match Vm::quick_attr(&self.heap, &self.attr_cache, &self.stack[top], name) {
                            QuickAttr::Method(function) => {
                                let object = self.stack[top];
                                self.stack[top] = function;
                                self.stack.push(object);
                            }
                            QuickAttr::Value(value) => {
                                self.stack[top] = *value;
                                self.stack.push(Value::Undefined);
                            }
                            QuickAttr::Property(_) | QuickAttr::No => self.load_method(name)?,
                        }
                    }
                    Op::LoadSubscr => {
                        let top = self.stack.len() - 1;
                        if let [.., object, index] = self.stack.as_mut_slice()
                            && let Some(item) = item_at(&self.heap, object, index)
                        {
                            set(object, item);
                            self.stack.truncate(top);
                            continue;
                        }
                        let (object, index) = self.pop2();
                        let result = self.get_item(object, index);
                        self.finish(top - 1, result)?;
                    }
                    Op::LoadSubscrConst(constant) => {
                        let index = &linked.consts[constant as usize];
                        let top = self.stack.len() - 1;
                        if let Some(item) = item_at(&self.heap, &self.stack[top], index) {
                            set(&mut self.stack[top], item);
                            continue;
                        }
                        let result = self.get_item(self.stack[top], *index);
                        self.finish(top, result)?;
                    }
                    Op::StoreSubscr => {
                        let top = self.stack.len() - 1;
                        if let [.., value, object, index] = self.stack.as_slice()
                            && let Some(place) = place_of(&mut self.heap, object, index)
                        {
                            set(place, value);
                            self.stack.truncate(top - 2);
                            continue;
                        }
                        let (object, index) = self.pop2();
                        let value = self.pop();
                        self.set_item(object, index, value)?;
                    }
                    Op::Binary(op) => {
                        let top = self.stack.len() - 1;
                        if let [.., a, b] = self.stack.as_mut_slice() {
                            quick!(arithmetic(op, a, b), v => {
                                *a = v;
                                self.stack.truncate(top);
                            });
                        }
                        let b = self.pop();
                        let a = self.top();
                        let result = self.binary(op, a, b);
                        self.finish(top - 1, result)?;
                    }
                    Op::BinaryFastFast { op, a, b } => {
                        let (x, y) = (base + usize::from(a), base + usize::from(b));
                        quick!(arithmetic(op, &self.stack[x], &self.stack[y]), v => self.stack.push(v));
                        for (at, slot) in [(x, a), (y, b)] {
                            if self.stack[at].is_undefined() {
                                return Err(self.unbound_slot(&linked, slot));
                            }
                        }
                        let value = self.binary(op, self.stack[x], self.stack[y])?;
                        self.stack.push(value);
                    }
                    Op::BinaryFastConst { op, a, constant } => {
                        let x = base + usize::from(a);
                        let y = &linked.consts[usize::from(constant)];
                        quick!(arithmetic(op, &self.stack[x], y), v => self.stack.push(v));
                        if self.stack[x].is_undefined() {
                            return Err(self.unbound_slot(&linked, a));
                        }
                        let value = self.binary(op, self.stack[x], *y)?;
                        self.stack.push(value);
                    }
                    Op::BinaryConst { op, constant } => {
                        let top = self.stack.len() - 1;
                        let y = &linked.consts[usize::from(constant)];
                        let a = &mut self.stack[top];
                        quick!(arithmetic(op, a, y), v => *a = v);
                        let result = self.binary(op, self.stack[top], *y);
                        self.finish(top, result)?;
                    }
                    Op::BinaryFast { op, b } => {
                        let (top, y) = (self.stack.len() - 1, base + usize::from(b));
                        quick!(arithmetic(op, &self.stack[top], &self.stack[y]), v => self.stack[top] = v);
                        if self.stack[y].is_undefined() {
                            return Err(self.unbound_slot(&linked, b));
                        }
                        let result = self.binary(op, self.stack[top], self.stack[y]);
                        self.finish(top, result)?;
                    }
                    Op::Inplace(op) => {
                        let top = self.stack.len() - 1;
                        if let [.., a, b] = self.stack.as_mut_slice() {
                            quick!(arithmetic(op, a, b), v => {
                                *a = v;
                                self.stack.truncate(top);
                            });
                        }
                        let b = self.pop();
                        let a = self.top();
                        let result = self.inplace(op, a, b);
                        self.finish(top - 1, result)?;
                    }
                    Op::Unary(op) => {
                        let top = self.stack.len() - 1;
                        match (op, &mut self.stack[top]) {
                            (UnaryOp::Neg, Value::Float(x, h)) if h.is_none() => *x = -*x,
                            (UnaryOp::Neg, Value::Int(x, h)) if h.is_none() && *x != i64::MIN => *x = -*x,
                            (_, &mut value) => {
                                let value = self.unary(op, value)?;
                                self.set_top(value);
                            }
                        }
                    }
                    Op::Not => {
                        let top = self.stack.len() - 1;
                        let truth = self.quick_truth(top)?;
                        self.set_top(Value::Bool(!truth));
                    }
                    Op::Compare(op) => {
                        let top = self.stack.len() - 1;
                        if let [.., a, b] = self.stack.as_mut_slice()
                            && let Some(holds) = comparison(op, a, b)
                        {
                            *a = Value::Bool(holds);
                            self.stack.truncate(top);
                            continue;
                        }
                        let b = self.pop();
                        let a = self.top();
                        let value = self.compare(op, a, b)?;
                        self.set_top(value);
                    }
                    Op::CompareJump { op, target } => {
                        let top = self.stack.len() - 1;
                        let holds = match comparison(op, &self.stack[top - 1], &self.stack[top]) {
                            Some(holds) => holds,
                            None => self.compare_at(op, self.stack[top - 1], self.stack[top])?,
                        };
                        self.stack.truncate(top - 1);
                        if !holds {
                            pc = target as usize;
                        }
                    }
                    Op::CompareConstJump { op, constant, target } => {
                        let top = self.stack.len() - 1;
                        let b = &linked.consts[usize::from(constant)];
                        let holds = match comparison(op, &self.stack[top], b) {
                            Some(holds) => holds,
                            None => self.compare_at(op, self.stack[top], *b)?,
                        };
                        self.stack.truncate(top);
                        if !holds {
                            pc = target as usize;
                        }
                    }
                    Op::Is(negated) => {
                        let (a, b) = self.pop2();
                        let same = match (a, b) {
                            (Value::Instance(a), Value::Instance(b)) => a == b,
                            (a, Value::None) => a.is_none(),
                            (a, b) => self.pin(a).is(self.pin(b)),
                        };
                        self.stack.push(Value::Bool(same != negated));
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
                        let top = self.stack.len() - 1;
                        let truth = self.quick_truth(top)?;
                        self.stack.truncate(top);
                        if !truth {
                            pc = target as usize;
                        }
                    }
                    Op::PopJumpIfTrue(target) => {
                        let top = self.stack.len() - 1;
                        let truth = self.quick_truth(top)?;
                        self.stack.truncate(top);
                        if truth {
                            pc = target as usize;
                        }
                    }
                    Op::JumpIfFalseOrPop(target) => {
                        let top = self.stack.len() - 1;
                        if self.quick_truth(top)? {
                            self.stack.truncate(top);
                        } else {
                            pc = target as usize;
                        }
                    }
                    Op::JumpIfTrueOrPop(target) => {
                        let top = self.stack.len() - 1;
                        if self.quick_truth(top)? {
                            pc = target as usize;
                        } else {
                            self.stack.truncate(top);
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
                        match self.quick_next(self.stack[top - 1], ops.get(pc), base)? {
                            Next::Item => {}
                            Next::Stored => pc += 1,
                            Next::Over => {
                                self.stack.truncate(top - 1);
                                pc = target as usize;
                                continue;
                            }
                        }
                        if let Value::Int(n, _) = &mut self.stack[top] {
                            *n += 1;
                        }
                    }
                    Op::BuildTuple(n) => {
                        let at = self.stack.len() - n as usize;
                        let tuple = self.heap.tuple_from(&self.stack[at..]);
                        self.stack.truncate(at);
                        self.stack.push(tuple);
                    }
                    Op::BuildList(n) => {
                        let at = self.stack.len() - n as usize;
                        let items = self.stack.split_off(at);
                        let list = self.heap.list(items);
                        self.stack.push(list);
                    }
                    Op::BuildString(n) => self.build_string(n as usize)?,
                    Op::Format { conversion, spec } => self.format_op(conversion, spec)?,
                    Op::ListAppend(n) => {
                        let top = self.stack.len() - 1;
                        if let Value::List(list) = self.stack[top - 1 - usize::from(n)] {
                            let items = &mut self.heap[list].0;
                            if items.len() < items.capacity() {
                                push_copy(items, &self.stack[top]);
                                self.stack.truncate(top);
                            } else {
                                let item = self.pop();
                                self.list_push(list, item)?;
                            }
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
                    Op::Unpack(n) => {
                        let top = self.stack.len() - 1;
                        if let Value::Tuple(t) = self.stack[top]
                            && let items = &self.heap[t].0
                            && items.len() == n as usize
                        {
                            self.stack.truncate(top);
                            for item in items.iter().rev() {
                                push_copy(&mut self.stack, item);
                            }
                            continue;
                        }
                        self.unpack(n as usize)?;
                    }
                    Op::Call(n) => {
                        let start = self.stack.len() - n as usize;
                        let callee = self.stack[start - 1];
                        match callee {
                            Value::Function(f) if self.enter(f, start - 1, start) => continue 'frame,
                            Value::Native(native) => self.call_on_stack(native, start - 1, start)?,
                            _ => {
                                if let Begun::Frame = self.begin_call(callee, start - 1, start, &[])? {
                                    continue 'frame;
                                }
                            }
                        }
                    }
                    Op::CallMethod(n) => {
                        let start = self.stack.len() - n as usize;
                        let floor = start - 2;
                        let start = if self.stack[start - 1].is_undefined() { start } else { start - 1 };
                        let callee = self.stack[floor];
                        match callee {
                            Value::Function(f) if self.enter(f, floor, start) => continue 'frame,
                            Value::Native(native) => self.call_on_stack(native, floor, start)?,
                            _ => {
                                if let Begun::Frame = self.begin_call(callee, floor, start, &[])? {
                                    continue 'frame;
                                }
                            }
                        }
                    }
                    Op::CallKw { count, names } => {
                        let keywords = self.take_keywords(linked.keywords(names));
                        let start = self.stack.len() + keywords.len() - usize::from(count);
                        let callee = self.stack[start - 1];
                        if let Begun::Frame = self.begin_call(callee, start - 1, start, &keywords)? {
                            continue 'frame;
                        }
                    }
                    Op::CallMethodKw { count, names } => {
                        let keywords = self.take_keywords(linked.keywords(names));
                        let start = self.stack.len() + keywords.len() - usize::from(count);
                        let floor = start - 2;
                        let start = if self.stack[start - 1].is_undefined() { start } else { start - 1 };
                        if let Begun::Frame = self.begin_call(self.stack[floor], floor, start, &keywords)? {
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
                        let top = self.stack.len() - 1;
                        let floor = self.frame.floor as usize;
                        let ret = self.frame.ret;
                        if let Some(below) = self.frames.last() {
                            self.frame = *below;
                            self.frames.pop();
                        }
                        match ret {
                            Return::Push => {
                                self.copy_on_stack(top, floor);
                                self.stack.truncate(floor + 1);
                            }
                            Return::Native => {
                                let value = self.stack[top];
                                self.stack.truncate(floor);
                                return Ok(value);
                            }
                            Return::Instance => {
                                let value = self.stack[top];
                                self.stack.truncate(floor);
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
                    Op::Statement(_) => self.host.statement_begins(),
                    Op::Rot3
                    | Op::Rot4
                    | Op::DeleteFast(_)
                    | Op::DeleteDeref(_)
                    | Op::LoadClassDeref { .. }
                    | Op::DeleteGlobal(_)
                    | Op::LoadName(_)
                    | Op::StoreName(_)
                    | Op::DeleteName(_)
                    | Op::DeleteAttr(_)
                    | Op::DeleteSubscr
                    | Op::BuildSet(_)
                    | Op::BuildDict(_)
                    | Op::BuildSlice(_)
                    | Op::ListExtend
                    | Op::SetUpdate
                    | Op::DictUpdate
                    | Op::DictMerge(_)
                    | Op::ListToTuple
                    | Op::UnpackEx { .. }
                    | Op::MakeFunction { .. }
                    | Op::PushExc
                    | Op::PopExc
                    | Op::ExcMatch
                    | Op::ExcGroupMatch
                    | Op::ExcGroupFinish
                    | Op::BeforeWith
                    | Op::WithExcept
                    | Op::Import { .. }
                    | Op::ImportFrom(_)
                    | Op::ImportStar
                    | Op::BuildClass
                    | Op::AssertionError
                    | Op::MatchSequence
                    | Op::MatchMapping
                    | Op::GetLen
                    | Op::MatchKeys
                    | Op::MatchClass(_)
                    | Op::MatchRest
                    | Op::Direction(_) => self.rare(*op, &linked)?,
                }
            }
        }
    }

    #[inline(always)]
    pub(super) fn cell_value(&self, at: usize) -> Value {
        match self.stack[at] {
            Value::Cell(cell) => self.heap[cell].0,
            _ => Value::Undefined,
        }
    }

    /// Whether the operand at `at` is true.
    #[inline(always)]
    fn quick_truth(&mut self, at: usize) -> R<bool> {
        match self.stack[at] {
            Value::Bool(b) => Ok(b),
            Value::None => Ok(false),
            Value::Int(v, h) if h.is_none() => Ok(v != 0),
            value => self.truth(value),
        }
    }

    #[inline(never)]
    fn compare_at(&mut self, op: CompareOp, a: Value, b: Value) -> R<bool> {
        let value = self.compare(op, a, b)?;
        self.truth(value)
    }

    /// `o.name(…)` where nothing is known beforehand.
    #[inline(never)]
    fn load_method(&mut self, name: Symbol) -> R<()> {
        let object = self.top();
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
        Ok(())
    }

    /// Takes the values of keyword arguments off the stack.
    fn take_keywords(&mut self, names: &[Symbol]) -> SmallVec<[(Symbol, Value); 8]> {
        let at = self.stack.len() - names.len();
        let mut out = SmallVec::new();
        for (name, value) in names.iter().zip(&self.stack[at..]) {
            out.push((*name, *value));
        }
        self.stack.truncate(at);
        out
    }
}

/// `object[index]` of a list or tuple, where the index lies within, and of a dict that has this text as a key.
#[inline(always)]
fn item_at<'a>(heap: &'a Heap, object: &Value, index: &Value) -> Option<&'a Value> {
    let i = match *index {
        Value::Int(i, h) if h.is_none() => i,
        Value::Str(key) => {
            let Value::Dict(dict) = *object else { return None };
            return heap.value_of(dict, key);
        }
        _ => return None,
    };
    let items = match *object {
        Value::List(list) => heap[list].0.as_slice(),
        Value::Tuple(tuple) => heap[tuple].0.as_slice(),
        _ => return None,
    };
    let at = if i < 0 { i.wrapping_add(items.len() as i64) } else { i };
    items.get(at as usize)
}

/// The place of `object[index]` in a list, where the index lies within, and in a dict that has this text as a key.
#[inline(always)]
fn place_of<'a>(heap: &'a mut Heap, object: &Value, index: &Value) -> Option<&'a mut Value> {
    match (*object, *index) {
        (Value::List(list), Value::Int(i, h)) if h.is_none() => {
            let items = &mut heap[list].0;
            let at = if i < 0 { i.wrapping_add(items.len() as i64) } else { i };
            items.get_mut(at as usize)
        }
        (Value::Dict(dict), Value::Str(key)) => heap.place_of(dict, key),
        _ => None,
    }
}
