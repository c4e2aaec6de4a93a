//! The instructions that loops seldom spend their time in, kept out of the main loop so that it stays small.

use super::call::Few;
use super::{Linked, Vm};
use crate::python::classes::Builtin;
use crate::python::code::Op;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};
use smallvec::SmallVec;
use std::rc::Rc;

impl Vm<'_> {
    /// Runs an instruction that neither jumps nor enters or leaves a frame.
    #[inline(never)]
    pub(super) fn rare(&mut self, op: Op, linked: &Linked) -> R<()> {
        let code = linked.code();
        let base = self.frame.base as usize;
        match op {
            Op::Rot3 => {
                let n = self.stack.len();
                self.stack[n - 3..].rotate_right(1);
            }
            Op::Rot4 => {
                let n = self.stack.len();
                self.stack[n - 4..].rotate_right(1);
            }
            Op::DeleteFast(slot) => {
                let place = &mut self.stack[base + usize::from(slot)];
                if std::mem::replace(place, Value::Undefined).is_undefined() {
                    return Err(self.unbound_local(&code.locals[usize::from(slot)]));
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
            Op::DeleteGlobal(slot) => {
                let place = &mut self.heap[self.frame.module].slots[slot as usize];
                if std::mem::replace(place, Value::Undefined).is_undefined() {
                    let name = self.heap[self.frame.module].names[slot as usize];
                    return Err(self.name_error(name));
                }
            }
            Op::LoadName(name) => {
                let name = linked.names[name as usize];
                let value = match self.namespace_get(self.frame.namespace, name)? {
                    Some(v) => v,
                    None => self.global(name)?,
                };
                self.stack.push(value);
            }
            Op::StoreName(name) => {
                let value = self.pop();
                self.store_name(linked.names[name as usize], value)?;
            }
            Op::DeleteName(name) => self.delete_name(linked.names[name as usize])?,
            Op::DeleteAttr(name) => {
                let object = self.pop();
                self.del_attr(object, linked.names[name as usize])?;
            }
            Op::DeleteSubscr => {
                let (object, index) = self.pop2();
                self.del_item(object, index)?;
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
            Op::BuildSlice(n) => {
                let step = if n == 3 { self.pop() } else { Value::None };
                let (start, stop) = self.pop2();
                let slice = Value::Slice(self.heap.alloc(Slice { start, stop, step }));
                self.stack.push(slice);
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
            Op::UnpackEx { before, after } => self.unpack_ex(usize::from(before), usize::from(after))?,
            Op::MakeFunction { child, flags } => {
                let function = self.make_function(child, flags);
                self.stack.push(function);
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
                let top = self.pop();
                let value = self.direction(id, top);
                self.stack.push(value);
            }
            other => debug_assert!(false, "{other:?} belongs to the main loop"),
        }
        Ok(())
    }

    pub(super) fn keywords_from_dict(&mut self) -> R<SmallVec<[(Symbol, Value); 8]>> {
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

    /// A global variable, or what is Python's or the host's own.
    fn global(&mut self, name: Symbol) -> R<Value> {
        let module = &self.heap[self.frame.module];
        match module.index.get(&name) {
            Some(&slot) => match module.slots[slot as usize] {
                Value::Undefined => self.load_builtin(slot),
                value => Ok(value),
            },
            None => self.builtin(name).ok_or_else(|| self.name_error(name)),
        }
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

    /// A local variable without a value was read.
    #[cold]
    pub(super) fn unbound_slot(&mut self, linked: &Linked, slot: u16) -> Raise {
        self.unbound_local(&linked.code().locals[usize::from(slot)])
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
    pub(super) fn unbound_cell(&mut self, slot: usize) -> Raise {
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
