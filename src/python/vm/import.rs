//! Modules: the ones written in Rust, the ones written in Python that come with psdl, and no others.

use super::Vm;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::modules::{self, Item};
use crate::python::native::{ANY, Native};
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};
use rustc_hash::FxHashMap;

/// `__build_class__`
pub(super) static BUILD_CLASS: Native = Native::function("__build_class__", 2, ANY, |vm, args| vm.build_class(args)).keywords();

/// `__import__`
pub(super) static IMPORT: Native = Native::function("__import__", 1, 5, |vm, args| {
    let name = vm.intern_value(args.at(0));
    vm.import(name, false)
})
.keywords();

/// What a program may import; a name that begins with an underscore is for the modules themselves.
const ALLOWED: &[&str] = &[
    "math",
    "random",
    "itertools",
    "functools",
    "collections",
    "collections.abc",
    "dataclasses",
    "enum",
    "operator",
    "string",
    "copy",
    "statistics",
    "typing",
];

impl Vm<'_> {
    /// `import name`
    pub(super) fn import(&mut self, name: Symbol, from: bool) -> R<Value> {
        let text = self.symbols.text(name).to_string();
        if text.starts_with('.') {
            return Err(self.error(Builtin::ImportError, "attempted relative import with no known parent package".to_string()));
        }
        let own = self.codes[self.frame.code.0 as usize].first == 0;
        if own && !ALLOWED.contains(&text.as_str()) {
            return Err(self.no_module(name, &text));
        }
        let Some(module) = self.load_module(name)? else { return Err(self.no_module(name, &text)) };
        if from || !text.contains('.') {
            return Ok(Value::Module(module));
        }
        let package = self.symbols.intern(text.split('.').next().unwrap_or(&text));
        let Some(package) = self.load_module(package)? else { return Err(self.no_module(name, &text)) };
        let leaf = self.symbols.intern(text.rsplit('.').next().unwrap_or(&text));
        self.module_set(package, leaf, Value::Module(module));
        Ok(Value::Module(package))
    }

    fn no_module(&mut self, name: Symbol, text: &str) -> Raise {
        let raise = self.error(Builtin::ModuleNotFoundError, format!("No module named '{text}'"));
        if let Raise::Exception(e) = raise {
            let value = self.symbol_text(name);
            self.set_own_attr(e, sym::N_NAME, value);
            self.set_own_attr(e, sym::N_PATH, Value::None);
        }
        raise
    }

    /// A module that comes with psdl, run when it is first asked for; `None` where there is none of that name.
    pub(super) fn load_module(&mut self, name: Symbol) -> R<Option<Ref<Module>>> {
        if let Some(module) = self.modules.get(&name) {
            return Ok(Some(*module));
        }
        let text = self.symbols.text(name).to_string();
        if text == "collections.abc" {
            let inner = self.symbols.intern("_collections_abc");
            let module = self.load_module(inner)?;
            if let Some(module) = module {
                let public = self.heap.str("collections.abc");
                self.heap[module].name = public;
                self.module_set(module, sym::NAME, public);
            }
            return Ok(module);
        }
        if let Some(items) = modules::native_module(&text) {
            let module = self.native_module(&text, items);
            self.modules.insert(name, module);
            return Ok(Some(module));
        }
        let Some(program) = modules::python_module(&text).or_else(|| self.host.module(&text)) else { return Ok(None) };
        let main = self.link(program);
        let module = self.new_module(&text, main);
        self.modules.insert(name, module);
        match self.run_module(main, module) {
            Ok(()) => Ok(Some(module)),
            Err(raise) => {
                self.modules.remove(&name);
                Err(raise)
            }
        }
    }

    fn native_module(&mut self, text: &str, items: &'static [(&'static str, Item)]) -> Ref<Module> {
        let name = self.heap.str(text);
        let module = self.heap.alloc(Module { name, slots: Vec::new(), names: Vec::new(), index: FxHashMap::default(), dict: None });
        for (key, item) in items {
            let value = match item {
                Item::Native(native) => Value::Native(native),
                Item::Float(v) => Value::float(*v),
                Item::Int(v) => Value::int(*v),
                Item::Class(class) => class.value(),
            };
            let key = self.symbols.intern(key);
            self.module_set(module, key, value);
        }
        module
    }

    /// `from module import name`
    pub(super) fn import_from(&mut self, module: Value, name: Symbol) -> R<Value> {
        if let Some(value) = self.get_attr_opt(module, name)? {
            return Ok(value);
        }
        let Value::Module(m) = module else { return Err(self.no_attribute(module, name)) };
        let package = self.display(self.heap[m].name);
        let inner = self.symbols.intern(&format!("{package}.{}", self.symbols.text(name)));
        if ALLOWED.contains(&self.symbols.text(inner))
            && let Some(inner) = self.load_module(inner)?
        {
            return Ok(Value::Module(inner));
        }
        let message = format!("cannot import name '{}' from '{package}' (unknown location)", self.symbols.text(name));
        let raise = self.error(Builtin::ImportError, message);
        if let Raise::Exception(e) = raise {
            let package = self.heap.str(package);
            self.set_own_attr(e, sym::N_NAME, package);
            self.set_own_attr(e, sym::N_PATH, Value::None);
        }
        Err(raise)
    }

    /// `from module import *`
    pub(super) fn import_star(&mut self, module: Value) -> R<()> {
        let Value::Module(m) = module else { return Ok(()) };
        let named = match self.get_attr_opt(module, sym::ALL)? {
            Some(names) => {
                let mut out = Vec::new();
                for name in self.collect(names)? {
                    out.push(self.intern_value(name));
                }
                out
            }
            None => {
                let names = self.heap[m].names.clone();
                names.into_iter().filter(|n| !self.symbols.text(*n).starts_with('_')).collect()
            }
        };
        let into = self.frame.module;
        for name in named {
            let value = self.get_attr(module, name)?;
            self.module_set(into, name, value);
        }
        Ok(())
    }
}
