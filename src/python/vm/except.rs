//! Exceptions: raising, unwinding, matching, groups.

use super::Vm;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::frame::Return;
use crate::python::heap::*;
use crate::python::symbols::sym;
use crate::python::value::Value;
use std::rc::Rc;

/// A statement of the module that raised, in a run that goes on after it.
#[derive(Clone, Copy, Debug)]
pub struct Failure {
    /// Which statement.
    pub statement: u32,
    /// The exception.
    pub exception: Value,
}

impl Vm<'_> {
    /// Finds who handles what was raised, down to the frame above `bottom`; where nobody does, the frames are gone and it goes on.
    pub(super) fn unwind(&mut self, raise: Raise, bottom: usize) -> R<()> {
        // What a raise takes besides its instructions: at the next look, for a stop on the way would be lost.
        self.countdown = self.countdown.saturating_sub(60);
        let Raise::Exception(exception) = raise else {
            return self.abandon(raise, bottom);
        };
        if !self.reraising {
            self.set_context(exception);
        }
        loop {
            self.countdown = self.countdown.saturating_sub(20);
            self.note_frame(exception);
            let linked = Rc::clone(&self.codes[self.frame.code.0 as usize]);
            let at = self.frame.pc.saturating_sub(1);
            if let Some(handler) = linked.code().handlers.iter().find(|h| h.start <= at && at < h.end) {
                let operands = self.frame.base as usize + linked.slots;
                self.stack.truncate(operands + handler.depth as usize);
                self.handling.truncate((self.frame.handling + handler.handling) as usize);
                self.stack.push(exception);
                self.frame.pc = handler.target;
                return Ok(());
            }
            if self.frames.len() == 1 && self.lenient {
                return self.skip_statement(exception);
            }
            let gone = self.pop_frame();
            if gone == Return::Native {
                debug_assert!(self.frames.len() <= bottom);
                return Err(raise);
            }
        }
    }

    /// Leaves the current frame without a result.
    fn pop_frame(&mut self) -> Return {
        let frame = self.frame;
        self.stack.truncate(frame.floor as usize);
        self.handling.truncate(frame.handling as usize);
        if let Some(below) = self.frames.pop() {
            self.frame = below;
        }
        frame.ret
    }

    /// A stop runs no handlers.
    fn abandon(&mut self, raise: Raise, bottom: usize) -> R<()> {
        if self.stopped_at.is_none() {
            self.stopped_at = Some(self.capture_path());
        }
        while self.frames.len() > bottom {
            if self.pop_frame() == Return::Native {
                break;
            }
        }
        Err(raise)
    }

    /// The rest of the module runs after a statement that raised.
    fn skip_statement(&mut self, exception: Value) -> R<()> {
        let linked = Rc::clone(&self.codes[self.frame.code.0 as usize]);
        let at = self.frame.pc.saturating_sub(1);
        let statements = &linked.program.statements;
        let Some(n) = statements.iter().position(|s| s.start <= at && at < s.end) else {
            self.pop_frame();
            return Err(Raise::Exception(exception));
        };
        self.stack.truncate(self.frame.base as usize + linked.slots);
        self.handling.truncate(self.frame.handling as usize);
        self.frame.pc = statements[n].end;
        self.failures.push(Failure { statement: n as u32, exception });
        self.host.statement_failed();
        Ok(())
    }

    fn set_context(&mut self, exception: Value) {
        let Some(&current) = self.handling.last() else { return };
        let fresh = self.heap.exception_data(exception).is_some_and(|d| d.traceback.is_empty() && d.context.is_none());
        if fresh && !current.is(exception) {
            self.link_context(exception, current);
        }
    }

    /// `exception` was raised while `current` was being handled.
    fn link_context(&mut self, exception: Value, current: Value) {
        // Never a circle: cut the chain of the current one where it reaches the new one.
        let mut at = current;
        for _ in 0..1000 {
            self.countdown = self.countdown.saturating_sub(2);
            let Some(context) = self.heap.exception_data(at).map(|d| d.context) else { break };
            if context.is(exception) {
                if let Some(data) = self.heap.exception_data_mut(at) {
                    data.context = Value::None;
                }
                break;
            }
            at = context;
        }
        if let Some(data) = self.heap.exception_data_mut(exception) {
            data.context = current;
        }
    }

    /// Notes in the exception that it passed the current frame.
    fn note_frame(&mut self, exception: Value) {
        let code = self.frame.code;
        let linked = &self.codes[code.0 as usize];
        let at = self.frame.pc.saturating_sub(1) as usize;
        let range = linked.code().ranges.get(at).copied().unwrap_or_default();
        if let Some(data) = self.heap.exception_data_mut(exception)
            && data.traceback.len() < 2000
            && !(self.reraising && data.traceback.last().is_some_and(|t| t.code == code))
        {
            data.traceback.push(TraceEntry { code, range });
        }
        self.reraising = false;
    }

    /// `raise`, `raise e`, `raise e from c`
    pub(super) fn raise_op(&mut self, count: u8) -> Raise {
        if count == 0 {
            return match self.handling.last().copied() {
                Some(current) => {
                    self.reraising = true;
                    Raise::Exception(current)
                }
                None => self.error(Builtin::RuntimeError, "No active exception to reraise".to_string()),
            };
        }
        let cause = if count == 2 { Some(self.pop()) } else { None };
        let value = self.pop();
        let exception = match self.make_exception(value, "exceptions must derive from BaseException") {
            Ok(e) => e,
            Err(raise) => return raise,
        };
        if let Some(cause) = cause {
            let cause = match cause {
                Value::None => Value::None,
                other => match self.make_exception(other, "exception causes must derive from BaseException") {
                    Ok(c) => c,
                    Err(raise) => return raise,
                },
            };
            if let Some(data) = self.heap.exception_data_mut(exception) {
                data.cause = cause;
                data.suppress = true;
            }
        }
        if let Some(&current) = self.handling.last()
            && !current.is(exception)
        {
            self.link_context(exception, current);
        }
        Raise::Exception(exception)
    }

    /// An exception from what stands after `raise`: an instance, or a class to instantiate.
    pub(crate) fn make_exception(&mut self, value: Value, complaint: &str) -> R<Value> {
        match value {
            Value::Class(c) if self.is_subclass(c, Builtin::BaseException.class()) => {
                let made = self.call(value, &[])?;
                if self.is_instance(made, Builtin::BaseException) { Ok(made) } else { Err(self.type_error(complaint)) }
            }
            _ if self.is_instance(value, Builtin::BaseException) => Ok(value),
            _ => Err(self.type_error(complaint)),
        }
    }

    /// `except T`
    pub(crate) fn exception_matches(&mut self, exception: Value, class: Value) -> R<bool> {
        match class {
            Value::Class(c) if self.is_subclass(c, Builtin::BaseException.class()) => {
                let own = self.class_of(exception);
                Ok(self.is_subclass(own, c))
            }
            Value::Tuple(t) => {
                let items = self.heap[t].0.clone();
                // All of them are looked at before any decides.
                let mut matches = false;
                for item in items {
                    matches |= matches!(item, Value::Class(_)) && self.exception_matches(exception, item)?;
                    if !matches!(item, Value::Class(_)) {
                        return self.exception_matches(exception, Value::None);
                    }
                }
                Ok(matches)
            }
            _ => Err(self.type_error("catching classes that do not inherit from BaseException is not allowed")),
        }
    }

    /// `except* T`: what of the exception matches, and what does not.
    pub(super) fn split_group(&mut self, exception: Value, class: Value) -> R<(Value, Value)> {
        let classes = match class {
            Value::Tuple(t) => self.heap[t].0.to_vec(),
            class => vec![class],
        };
        self.exception_matches(exception, class)?;
        if classes.iter().any(|class| matches!(class, Value::Class(c) if self.is_subclass(*c, Builtin::BaseExceptionGroup.class()))) {
            return Err(self.type_error("catching ExceptionGroup with except* is not allowed. Use except instead."));
        }
        if exception.is_none() {
            return Ok((Value::None, Value::None));
        }
        if !self.is_instance(exception, Builtin::BaseExceptionGroup) {
            if !self.exception_matches(exception, class)? {
                return Ok((Value::None, exception));
            }
            let text = self.heap.str("");
            let members = self.heap.tuple([exception].as_slice());
            let group = self.call(Builtin::BaseExceptionGroup.value(), &[text, members])?;
            return Ok((group, Value::None));
        }
        let name = self.symbols.intern("split");
        let pair = self.call_method(exception, name, &[class])?;
        let parts = self.collect(pair)?;
        match parts.as_slice() {
            [matched, rest] => Ok((*matched, *rest)),
            _ => Err(self.type_error("split must return a 2-tuple")),
        }
    }

    /// The end of a `try … except*`: what is still to be raised. Parts of the original come back as one group like the original.
    pub(super) fn finish_group(&mut self, original: Value, raised: &[Value]) -> R<Value> {
        let raised: Vec<Value> = raised.iter().copied().filter(|v| !v.is_none()).collect();
        if raised.is_empty() {
            return Ok(Value::None);
        }
        if !self.is_instance(original, Builtin::BaseExceptionGroup) {
            // It matched one clause at most, which raised something; or none, and it goes on as it was.
            return Ok(raised[0]);
        }
        let own = self.group_leaves(original);
        let (mut parts, mut fresh) = (Vec::new(), Vec::new());
        for exception in raised {
            let leaves = self.group_leaves(exception);
            let is_part = self.is_instance(exception, Builtin::BaseExceptionGroup) && leaves.iter().all(|l| own.iter().any(|o| o.is(*l)));
            if is_part { parts.extend(leaves) } else { fresh.push(exception) }
        }
        if !parts.is_empty() {
            let projected = crate::python::types::exception::project(self, original, &parts)?;
            if fresh.is_empty() {
                return Ok(projected);
            }
            fresh.push(projected);
        } else if let [one] = fresh.as_slice() {
            return Ok(*one);
        }
        self.new_group(fresh)
    }

    fn new_group(&mut self, members: Vec<Value>) -> R<Value> {
        let text = self.heap.str("");
        let members = self.heap.list(members);
        self.call(Builtin::BaseExceptionGroup.value(), &[text, members])
    }

    /// The exceptions of a group that are no groups themselves.
    fn group_leaves(&self, exception: Value) -> Vec<Value> {
        let mut leaves = Vec::new();
        let mut todo = vec![exception];
        while let Some(at) = todo.pop() {
            if self.is_instance(at, Builtin::BaseExceptionGroup) {
                todo.extend(crate::python::types::exception::members(self, at));
            } else {
                leaves.push(at);
            }
        }
        leaves
    }

    /// `with`: the bound `__exit__`, then what `__enter__` returned.
    pub(super) fn before_with(&mut self, manager: Value) -> R<(Value, Value)> {
        let Some(enter) = self.special(manager, sym::ENTER) else {
            let message = format!("'{}' object does not support the context manager protocol", self.type_name(manager));
            return Err(self.type_error(message));
        };
        let Some(exit) = self.special(manager, sym::EXIT) else {
            let message =
                format!("'{}' object does not support the context manager protocol (missed __exit__ method)", self.type_name(manager));
            return Err(self.type_error(message));
        };
        let entered = self.call(enter, &[])?;
        Ok((exit, entered))
    }
}
