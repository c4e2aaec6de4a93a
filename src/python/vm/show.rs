//! What a person reads of an exception that nobody caught.

use super::Vm;
use super::provenance::CallChain;
use super::start::Shown;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::symbols::sym;
use crate::python::value::Value;

/// How many exceptions of a chain are shown.
const MAX_CHAIN: usize = 32;

impl Vm<'_> {
    /// An exception with what caused it, first cause first.
    pub(super) fn show_chain(&mut self, exception: Value) -> Vec<Shown> {
        let mut chain = Vec::new();
        let mut at = exception;
        let mut direct = false;
        while chain.len() < MAX_CHAIN {
            let mut shown = self.show(at);
            shown.direct = direct;
            chain.push(shown);
            let Some(data) = self.heap.exception_data(at) else { break };
            let next = if !data.cause.is_none() {
                direct = true;
                data.cause
            } else if !data.suppress {
                direct = false;
                data.context
            } else {
                break;
            };
            if next.is_none() {
                break;
            }
            at = next;
        }
        // `direct` was noted at the cause; the reader wants it there: "the above exception was the direct cause of the following".
        chain.reverse();
        chain
    }

    fn show(&mut self, exception: Value) -> Shown {
        let class = self.class_of(exception);
        let name = self.display(self.heap[class].qualname);
        let text = match self.str(exception) {
            Ok(text) => text,
            Err(_) => "<exception str() failed>".to_string(),
        };
        let module = match self.class_attr(class, sym::MODULE) {
            Some(m) if !self.heap[class].builtin => self.display(m),
            _ => String::new(),
        };
        let full =
            if module.is_empty() || module == "__main__" || module == "builtins" { name.clone() } else { format!("{module}.{name}") };
        let line = if text.is_empty() { full } else { format!("{full}: {text}") };
        let notes = self.notes(exception).unwrap_or_default();
        Shown {
            class: name,
            line,
            notes,
            calls: self.call_chain(exception),
            direct: false,
            name: self.name_in_question(exception),
            exit: self.exit_status(exception),
        }
    }

    fn notes(&mut self, exception: Value) -> R<Vec<String>> {
        let mut out = Vec::new();
        if let Some(notes) = self.get_attr_opt(exception, sym::NOTES)? {
            for note in self.collect(notes)? {
                out.push(self.str(note)?);
            }
        }
        if self.is_instance(exception, Builtin::BaseExceptionGroup)
            && let Some(members) = self.get_attr_opt(exception, sym::N_EXCEPTIONS)?
        {
            for (i, member) in self.collect(members)?.into_iter().enumerate() {
                let shown = self.nested("", |vm| Ok(vm.show(member)))?;
                out.push(format!("[{}] {}", i + 1, shown.line));
                out.extend(shown.notes.iter().map(|n| format!("    {n}")));
            }
        }
        Ok(out)
    }

    /// Where an exception passed, in the program's own code, outermost first.
    fn call_chain(&self, exception: Value) -> CallChain {
        let Some(data) = self.heap.exception_data(exception) else { return CallChain::default() };
        let mut levels: Vec<_> = data
            .traceback
            .iter()
            .rev()
            .filter(|entry| self.codes[entry.code.0 as usize].first == 0)
            .map(|entry| (self.codes[entry.code.0 as usize].code().name.to_string(), entry.range))
            .collect();
        if levels.len() > 24 {
            levels.drain(12..levels.len() - 12);
        }
        CallChain { levels }
    }

    fn name_in_question(&mut self, exception: Value) -> Option<String> {
        let Value::Instance(i) = exception else { return None };
        match self.own_attr(i, sym::N_NAME)? {
            Value::Str(s) => Some(self.heap[s].text.to_string()),
            _ => None,
        }
    }

    /// The status of a SystemExit: its int, 0 for none, 1 for anything else.
    fn exit_status(&self, exception: Value) -> Option<i32> {
        if !self.is_instance(exception, Builtin::SystemExit) {
            return None;
        }
        let args = match self.heap.exception_data(exception)?.args {
            Value::Tuple(t) => self.heap[t].0.clone(),
            _ => return Some(0),
        };
        Some(match args.first() {
            None | Some(Value::None) => 0,
            Some(Value::Int(n, _)) => (*n & 0xff) as i32,
            Some(Value::Bool(b)) => i32::from(*b),
            Some(_) => 1,
        })
    }

    /// A fresh dict of the variables of the running frame: `locals()`.
    pub fn locals_dict(&mut self) -> Ref<Dict> {
        if let Value::Dict(namespace) = self.plain(self.frame.namespace) {
            return namespace;
        }
        let linked = self.codes[self.frame.code.0 as usize].clone();
        let code = linked.code();
        if code.kind == crate::python::code::CodeKind::Module {
            return self.globals_dict();
        }
        let base = self.frame.base as usize;
        let mut items = Vec::new();
        let names = code.locals.iter().chain(code.cells.iter().map(|c| &c.0)).chain(&code.frees);
        for (slot, name) in names.enumerate() {
            let value = match self.stack[base + slot] {
                Value::Cell(cell) => self.heap[cell].0,
                value => value,
            };
            if !value.is_undefined() && !name.starts_with('.') {
                items.push((self.symbols.intern(name), value));
            }
        }
        self.symbols_dict(items)
    }

    /// A fresh dict of the globals of the running module: `globals()`.
    pub fn globals_dict(&mut self) -> Ref<Dict> {
        let module = self.frame.module;
        self.module_dict(module)
    }
}
