//! Generators: suspended frames.

use super::Vm;
use crate::python::classes::Builtin;
use crate::python::code::Op;
use crate::python::error::{R, Raise};
use crate::python::frame::{Frame, Return, SavedFrame};
use crate::python::heap::*;
use crate::python::symbols::sym;
use crate::python::value::Value;

/// What a generator is given when it goes on.
#[derive(Clone, Copy)]
pub(super) enum Resume {
    Send(Value),
    Throw(Value),
}

/// What a generator did.
pub(super) enum Step {
    Yielded(Value),
    Returned(Value),
}

impl Vm<'_> {
    /// `next()`, as far as loops care: `None` when it is over.
    pub fn resume_generator(&mut self, generator: Ref<Generator>, sent: Value) -> R<Option<Value>> {
        match self.step_generator(generator, Resume::Send(sent))? {
            Step::Yielded(v) => Ok(Some(v)),
            Step::Returned(_) => Ok(None),
        }
    }

    /// Runs a generator to its next `yield` or its end.
    pub(super) fn step_generator(&mut self, g: Ref<Generator>, resume: Resume) -> R<Step> {
        if self.heap[g].running {
            return Err(self.value_error("generator already executing"));
        }
        let started = self.heap[g].started;
        match resume {
            Resume::Send(v) if !started && !v.is_none() && self.heap[g].frame.is_some() => {
                return Err(self.type_error("can't send non-None value to a just-started generator"));
            }
            _ => {}
        }
        let Some(saved) = self.heap[g].frame.take() else {
            return match resume {
                Resume::Send(_) => Ok(Step::Returned(Value::None)),
                Resume::Throw(e) => Err(Raise::Exception(e)),
            };
        };
        if self.frames.len() >= self.limits.recursion {
            self.heap[g].frame = Some(saved);
            return Err(self.recursion_error());
        }
        self.heap[g].running = true;
        self.heap[g].started = true;
        let outcome = self.run_generator(g, saved, started, resume);
        self.heap[g].running = false;
        self.heap[g].spare = None;
        match outcome {
            Ok(value) if self.yielded => {
                self.yielded = false;
                Ok(Step::Yielded(value))
            }
            Ok(value) => Ok(Step::Returned(value)),
            Err(Raise::Exception(e)) if self.is_instance(e, Builtin::StopIteration) => {
                // PEP 479
                let Raise::Exception(error) = self.error(Builtin::RuntimeError, "generator raised StopIteration".to_string()) else {
                    return Err(Raise::Exception(e));
                };
                if let Some(data) = self.heap.exception_data_mut(error) {
                    data.cause = e;
                    data.context = e;
                    data.suppress = true;
                }
                Err(Raise::Exception(error))
            }
            Err(raise) => Err(raise),
        }
    }

    fn run_generator(&mut self, g: Ref<Generator>, mut saved: Box<SavedFrame>, started: bool, resume: Resume) -> R<Value> {
        let base = self.stack.len();
        let frame = Frame {
            code: saved.code,
            pc: saved.pc,
            base: base as u32,
            floor: base as u32,
            module: saved.module,
            namespace: Value::Undefined,
            ret: Return::Native,
            handling: self.handling.len() as u32,
            generator: Some(g),
        };
        self.stack.append(&mut saved.stack);
        self.handling.append(&mut saved.handling);
        self.heap[g].spare = Some(saved);
        self.frames.push(std::mem::replace(&mut self.frame, frame));
        let bottom = self.frames.len() - 1;
        match resume {
            Resume::Send(value) => {
                if started {
                    self.stack.push(value);
                }
            }
            Resume::Throw(exception) if !started => {
                self.stack.truncate(base);
                if let Some(below) = self.frames.pop() {
                    self.frame = below;
                }
                return Err(Raise::Exception(exception));
            }
            Resume::Throw(exception) => match self.throw_into_delegate(started, exception) {
                Delegated::Yielded(value) => return Ok(self.suspend(value)),
                Delegated::Go => {}
                Delegated::Raise(raise) => self.unwind(raise, bottom)?,
            },
        }
        self.nested_run(bottom)
    }

    /// A generator that waits in `yield from` passes what is thrown on to its inner iterator.
    fn throw_into_delegate(&mut self, started: bool, exception: Value) -> Delegated {
        let linked = self.codes[self.frame.code.0 as usize].clone();
        let waiting = started && matches!(linked.code().ops.get(self.frame.pc as usize), Some(Op::YieldFrom));
        if !waiting {
            return Delegated::Raise(Raise::Exception(exception));
        }
        let inner = *self.stack.last().unwrap_or(&Value::None);
        let outcome = match inner {
            Value::Generator(g) if self.is_instance(exception, Builtin::GeneratorExit) => {
                self.close_generator(g).and(Err(Raise::Exception(exception)))
            }
            Value::Generator(g) => self.step_generator(g, Resume::Throw(exception)),
            _ => self.throw_into_object(inner, exception),
        };
        match outcome {
            Ok(Step::Yielded(value)) => Delegated::Yielded(value),
            Ok(Step::Returned(value)) => {
                self.stack.pop();
                self.stack.push(value);
                self.frame.pc += 1;
                Delegated::Go
            }
            Err(raise) => {
                self.frame.pc += 1;
                Delegated::Raise(raise)
            }
        }
    }

    fn throw_into_object(&mut self, inner: Value, exception: Value) -> R<Step> {
        let name = if self.is_instance(exception, Builtin::GeneratorExit) { sym::N_CLOSE } else { sym::N_THROW };
        let Some(method) = self.get_attr_opt(inner, name)? else { return Err(Raise::Exception(exception)) };
        if name == sym::N_CLOSE {
            self.call(method, &[])?;
            return Err(Raise::Exception(exception));
        }
        match self.call(method, &[exception]) {
            Ok(value) => Ok(Step::Yielded(value)),
            Err(raise) => self.stop_value(raise).map(Step::Returned),
        }
    }

    /// The value of a StopIteration; anything else goes on.
    pub(super) fn stop_value(&mut self, raise: Raise) -> R<Value> {
        match raise {
            Raise::Exception(e) if self.is_instance(e, Builtin::StopIteration) => {
                let args = self.heap.exception_data(e).map_or(Value::None, |d| d.args);
                Ok(match args {
                    Value::Tuple(t) => self.heap[t].0.first().copied().unwrap_or(Value::None),
                    _ => Value::None,
                })
            }
            other => Err(other),
        }
    }

    /// Suspends the current frame, which is a generator's; the frame below goes on.
    pub(super) fn suspend(&mut self, value: Value) -> Value {
        let frame = self.frame;
        let base = frame.base as usize;
        let handling = (frame.handling as usize).min(self.handling.len());
        if let Some(g) = frame.generator {
            let generator = &mut self.heap[g];
            if let Some(mut saved) = generator.spare.take() {
                saved.pc = frame.pc;
                saved.stack.extend_from_slice(&self.stack[base..]);
                saved.handling.extend_from_slice(&self.handling[handling..]);
                generator.frame = Some(saved);
            }
        }
        self.stack.truncate(base);
        self.handling.truncate(handling);
        if let Some(below) = self.frames.pop() {
            self.frame = below;
        }
        self.yielded = true;
        value
    }

    /// One step of `yield from`: the iterator and what was sent are on the stack. `None`: it is over, its value is on the stack.
    pub(super) fn delegate(&mut self) -> R<Option<Value>> {
        let sent = self.pop();
        let inner = *self.stack.last().unwrap_or(&Value::None);
        let step = match inner {
            Value::Generator(g) => self.step_generator(g, Resume::Send(sent))?,
            _ if sent.is_none() => match self.next_or_stop(inner) {
                Ok(value) => Step::Yielded(value),
                Err(raise) => Step::Returned(self.stop_value(raise)?),
            },
            _ => match self.call_method(inner, sym::N_SEND, &[sent]) {
                Ok(value) => Step::Yielded(value),
                Err(raise) => Step::Returned(self.stop_value(raise)?),
            },
        };
        match step {
            Step::Yielded(value) => Ok(Some(value)),
            Step::Returned(value) => {
                self.pop();
                self.stack.push(value);
                Ok(None)
            }
        }
    }

    /// `next(o)`: raises StopIteration, with its value, at the end.
    pub(super) fn next_or_stop(&mut self, iter: Value) -> R<Value> {
        match iter {
            Value::Instance(_) => match self.call_special(iter, sym::NEXT, &[])? {
                Some(value) => Ok(value),
                None => {
                    let message = format!("'{}' object is not an iterator", self.type_name(iter));
                    Err(self.type_error(message))
                }
            },
            _ => match self.next(iter)? {
                Some(value) => Ok(value),
                None => Err(self.stop_iteration()),
            },
        }
    }

    /// `g.close()`
    pub(super) fn close_generator(&mut self, g: Ref<Generator>) -> R<Step> {
        if !self.heap[g].started {
            self.heap[g].frame = None;
            self.heap[g].started = true;
            return Ok(Step::Returned(Value::None));
        }
        let args = self.heap.tuple([].as_slice());
        let exit = self.heap.exception(Builtin::GeneratorExit.class(), args);
        match self.step_generator(g, Resume::Throw(exit)) {
            Ok(Step::Yielded(_)) => Err(self.error(Builtin::RuntimeError, "generator ignored GeneratorExit".to_string())),
            Ok(Step::Returned(_)) => Ok(Step::Returned(Value::None)),
            Err(raise) if self.raised(&raise, Builtin::GeneratorExit) || self.raised(&raise, Builtin::StopIteration) => {
                Ok(Step::Returned(Value::None))
            }
            Err(raise) => Err(raise),
        }
    }
}

/// What became of an exception thrown into a `yield from`.
pub(super) enum Delegated {
    Yielded(Value),
    Go,
    Raise(Raise),
}
