//! The texts of objects that have no special text of their own.

use super::Vm;
use crate::python::classes::Builtin;
use crate::python::heap::*;
use crate::python::symbols::sym;
use crate::python::value::Value;

impl Vm<'_> {
    /// The number that stands for an object's address: the same in every run.
    pub fn address(&self, value: Value) -> u64 {
        self.identity(value) as u64
    }

    /// `<module.Class object at 0x…>` and its like.
    pub(crate) fn default_repr(&mut self, value: Value) -> String {
        let at = self.address(value);
        match value {
            Value::Class(c) => self.class_repr(c),
            Value::Function(f) => format!("<function {} at {at:#x}>", self.display(self.heap[f].qualname)),
            Value::Native(n) => match Self::native_class(n) {
                Builtin::NativeFunction => format!("<built-in function {}>", n.name),
                kind => {
                    let what = match kind {
                        Builtin::SlotWrapper => "slot wrapper",
                        Builtin::GetSet => "attribute",
                        _ => "method",
                    };
                    match Builtin::owner(n) {
                        Some(owner) => format!("<{what} '{}' of '{}' objects>", n.name, owner.name()),
                        None => format!("<{what} '{}'>", n.name),
                    }
                }
            },
            Value::Method(m) => self.method_repr(self.heap[m]),
            Value::Generator(g) => format!("<generator object {} at {at:#x}>", self.display(self.heap[g].qualname)),
            Value::Module(m) => format!("<module '{}'>", self.display(self.heap[m].name)),
            Value::Super(s) => {
                let Super { class, object_class, object } = self.heap[s];
                if object.is_undefined() {
                    return format!("<super: <class '{}'>, NULL>", self.class_name(class));
                }
                format!("<super: <class '{}'>, <{} object>>", self.class_name(class), self.class_name(object_class))
            }
            Value::ClassMethod(w) | Value::StaticMethod(w) => {
                let inner = self.heap[w].0;
                let inner = self.repr(inner).unwrap_or_else(|_| "?".to_string());
                let what = if matches!(value, Value::ClassMethod(_)) { "classmethod" } else { "staticmethod" };
                format!("<{what}({inner})>")
            }
            Value::Alias(_) => self.alias_repr(value),
            _ => format!("<{} object at {at:#x}>", self.full_class_name(self.class_of(value))),
        }
    }

    fn method_repr(&mut self, method: Method) -> String {
        let receiver = self.repr(method.receiver).unwrap_or_else(|_| "?".to_string());
        match method.callee {
            Value::Native(n) => {
                let kind = self.type_name(method.receiver);
                if Self::native_class(n) == Builtin::SlotWrapper {
                    return format!("<method-wrapper '{}' of {kind} object at {:#x}>", n.name, self.address(method.receiver));
                }
                format!("<built-in method {} of {kind} object at {:#x}>", n.name, self.address(method.receiver))
            }
            Value::Function(f) => format!("<bound method {} of {receiver}>", self.display(self.heap[f].qualname)),
            Value::Instance(i) => {
                let name = self.full_class_name(self.heap[i].class);
                format!("<bound method {name} of {receiver}>")
            }
            _ => format!("<bound method of {receiver}>"),
        }
    }

    /// `module.Class`, without the module for builtin classes.
    pub fn full_class_name(&mut self, class: Ref<Class>) -> String {
        let name = self.display(self.heap[class].qualname);
        if self.heap[class].builtin {
            return Builtin::full_name(class).map_or(name, str::to_string);
        }
        match self.class_attr(class, sym::MODULE).map(|m| self.display(m)) {
            Some(module) if !module.is_empty() && module != "builtins" => format!("{module}.{name}"),
            _ => name,
        }
    }

    /// `<class 'C'>`
    pub fn class_repr(&mut self, class: Ref<Class>) -> String {
        format!("<class '{}'>", self.full_class_name(class))
    }

    /// `list[int]`, `int | str`
    fn alias_repr(&mut self, value: Value) -> String {
        let Value::Alias(a) = value else { return String::new() };
        let Alias { origin, args } = self.heap[a].clone();
        let shown: Vec<String> = args.iter().map(|v| self.type_argument(*v)).collect();
        if origin.is_none() {
            return shown.join(" | ");
        }
        format!("{}[{}]", self.type_argument(origin), shown.join(", "))
    }

    fn type_argument(&mut self, value: Value) -> String {
        match value {
            Value::Class(c) if c == Builtin::NoneType.class() => "None".to_string(),
            Value::Class(c) => self.full_class_name(c),
            Value::Ellipsis => "...".to_string(),
            Value::Alias(_) => self.nested("", |vm| Ok(vm.alias_repr(value))).unwrap_or_else(|_| "...".to_string()),
            other => self.repr(other).unwrap_or_default(),
        }
    }
}
