//! Text of values, unpacking, keyword arguments: what single instructions need.

use super::call::Few;
use super::{HostCx, Vm};
use crate::python::classes::Builtin;
use crate::python::code::DirectionId;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::host::Host;
use crate::python::symbols::sym;
use crate::python::text;
use crate::python::value::{HostObject, Symbol, Value};
use crate::trace::{AS_WRITTEN, Num, Op as TraceOp};
use smallvec::SmallVec;

impl Vm<'_> {
    /// The host and what it may use of the machine.
    #[inline]
    pub(super) fn host_cx(&mut self) -> (&mut dyn Host, HostCx<'_>) {
        let cx = HostCx {
            heap: &mut self.heap,
            symbols: &mut self.symbols,
            trace: &mut self.trace,
            frame: &self.frame,
            frames: &self.frames,
            codes: &self.codes,
            stack: &self.stack,
        };
        (&mut *self.host, cx)
    }

    /// A host object as a sequence.
    pub fn host_items(&mut self, object: Value) -> R<Option<SmallVec<[Value; 4]>>> {
        let (host, mut cx) = self.host_cx();
        host.items(&mut cx, object)
    }

    /// `isinstance` where the class is the host's; `None` where it is none.
    pub fn host_is_instance(&mut self, object: Value, class: Value) -> Option<bool> {
        let (host, mut cx) = self.host_cx();
        host.is_instance(&mut cx, object, class)
    }

    pub(super) fn host_type_name(&self, object: Value) -> &'static str {
        self.host.type_name(&self.heap, object)
    }

    pub(super) fn host_class(&self, object: Value) -> Ref<Class> {
        let name = self.host.type_name(&self.heap, object);
        self.host_classes.iter().find(|c| c.0 == name).map_or(Builtin::Object.class(), |c| c.1)
    }

    /// Whether objects of the host's kind may be keys.
    pub fn host_hashable(&self, object: Value) -> bool {
        self.host.hashable(&self.heap, object)
    }

    /// A text of the heap.
    pub fn text(&self, text: Ref<Str>) -> &str {
        &self.heap[text].text
    }

    /// A new `str`.
    pub fn new_str(&mut self, text: impl Into<Box<str>>) -> Value {
        self.heap.str(text)
    }

    /// A new `tuple`.
    pub fn new_tuple(&mut self, items: impl Into<SmallVec<[Value; 3]>>) -> Value {
        self.heap.tuple(items)
    }

    /// A new `list`.
    pub fn new_list(&mut self, items: Vec<Value>) -> Value {
        self.heap.list(items)
    }

    /// Pins a traced number: the run depends on its very value. Returns it without its handle.
    #[inline]
    pub fn pin(&mut self, value: Value) -> Value {
        match value {
            Value::Int(v, h) => {
                self.trace.pin(Num { value: v as f64, handle: h });
                Value::int(v)
            }
            Value::Float(v, h) => {
                self.trace.pin(Num { value: v, handle: h });
                Value::float(v)
            }
            other => other,
        }
    }

    /// A float made by `op` from one number.
    pub fn float_of(&mut self, op: TraceOp, a: Num, result: f64) -> Value {
        let handle = self.trace.unary(op, a, result);
        Value::Float(result, handle)
    }

    /// The `str` of a symbol; one object a symbol.
    pub fn symbol_text(&mut self, name: Symbol) -> Value {
        let at = name.0 as usize;
        if at >= self.symbol_texts.len() {
            self.symbol_texts.resize(self.symbols.len(), Value::Undefined);
        }
        if self.symbol_texts[at].is_undefined() {
            let text = self.heap.str(self.symbols.text(name));
            self.symbol_texts[at] = text;
        }
        self.symbol_texts[at]
    }

    /// The symbol of a `str` value.
    pub fn intern_value(&mut self, value: Value) -> Symbol {
        match self.plain(value) {
            Value::Str(s) => self.symbols.intern(&self.heap[s].text),
            _ => self.symbols.intern(""),
        }
    }

    /// The text of a `str` value that is known to be one.
    pub(super) fn display(&self, value: Value) -> String {
        match self.plain(value) {
            Value::Str(s) => self.heap[s].text.to_string(),
            _ => String::new(),
        }
    }

    /// `repr(value)`
    pub fn repr(&mut self, value: Value) -> R<String> {
        match value {
            Value::None | Value::Undefined => return Ok("None".to_string()),
            Value::Bool(b) => return Ok(if b { "True" } else { "False" }.to_string()),
            Value::Ellipsis => return Ok("Ellipsis".to_string()),
            Value::NotImplemented => return Ok("NotImplemented".to_string()),
            Value::Int(..) | Value::Float(..) => {
                // A text of a number that decides nothing need not pin it; what reads the text cannot be known, so it does.
                return Ok(match self.pin(value) {
                    Value::Int(v, _) => v.to_string(),
                    Value::Float(v, _) => text::float_repr(v),
                    _ => String::new(),
                });
            }
            Value::Str(s) => {
                self.charge(self.heap[s].text.len() as u64)?;
                return Ok(text::repr_str(&self.heap[s].text));
            }
            Value::Host(_) | Value::Record(_) => {
                let (host, mut cx) = self.host_cx();
                return host.repr(&mut cx, value);
            }
            _ => {}
        }
        self.charge(8)?;
        let said = self.nested(" while getting the repr of an object", |vm| vm.call_special(value, sym::REPR, &[]))?;
        match said {
            Some(said) => self.expect_text(said, "__repr__"),
            None => Ok(self.default_repr(value)),
        }
    }

    fn expect_text(&mut self, said: Value, method: &str) -> R<String> {
        match self.plain(said) {
            Value::Str(s) => Ok(self.heap[s].text.to_string()),
            _ => {
                let message = format!("{method} returned non-string (type {})", self.type_name(said));
                Err(self.type_error(message))
            }
        }
    }

    /// `str(value)`
    pub fn str(&mut self, value: Value) -> R<String> {
        match value {
            Value::Str(s) => return Ok(self.heap[s].text.to_string()),
            Value::Instance(_) | Value::Class(_) => {}
            _ => return self.repr(value),
        }
        match self.nested(" while getting the str of an object", |vm| vm.call_special(value, sym::STR, &[]))? {
            Some(said) => self.expect_text(said, "__str__"),
            None => self.repr(value),
        }
    }

    /// `ascii(value)`
    pub fn ascii(&mut self, value: Value) -> R<String> {
        let shown = self.repr(value)?;
        Ok(text::ascii(&shown))
    }

    /// `format(value, spec)`
    pub fn format(&mut self, value: Value, spec: &str) -> R<String> {
        match value {
            Value::Instance(_) | Value::Class(_) | Value::Host(_) | Value::Record(_) => {}
            _ if spec.is_empty() => return self.str(value),
            Value::Int(..) | Value::Float(..) | Value::Bool(_) | Value::Big(_) | Value::Complex(_) | Value::Str(_) => {
                let plain = self.pin(value);
                return text::format_value(self, plain, spec);
            }
            _ => {}
        }
        if let Value::Instance(_) = value {
            // A builtin type's own `__format__` answers an empty spec with `str(self)`, which a subclass may have changed.
            if spec.is_empty() && self.special(value, sym::FORMAT).is_some_and(|method| self.is_native(method)) {
                return self.str(value);
            }
            let spec = self.heap.str(spec);
            if let Some(said) = self.call_special(value, sym::FORMAT, &[spec])? {
                return match self.plain(said) {
                    Value::Str(s) => Ok(self.heap[s].text.to_string()),
                    _ => {
                        let message = format!("__format__ must return a str, not {}", self.type_name(said));
                        Err(self.type_error(message))
                    }
                };
            }
        }
        if spec.is_empty() {
            return self.str(value);
        }
        let message = format!("unsupported format string passed to {}.__format__", self.type_name(value));
        Err(self.type_error(message))
    }

    pub(super) fn format_op(&mut self, conversion: u8, with_spec: bool) -> R<()> {
        let spec = if with_spec { Some(self.pop()) } else { None };
        let value = self.pop();
        if let (Value::Int(v, h), 0, None) = (value, conversion, spec)
            && h.is_none()
        {
            use std::io::Write;
            let mut digits = [0; 20];
            let mut rest = &mut digits[..];
            let _ = write!(rest, "{v}");
            let left = rest.len();
            let text = std::str::from_utf8(&digits[..20 - left]).unwrap_or_default();
            let text = self.heap.str(text);
            self.stack.push(text);
            return Ok(());
        }
        let value = match conversion {
            b's' => {
                let t = self.str(value)?;
                self.heap.str(t)
            }
            b'r' => {
                let t = self.repr(value)?;
                self.heap.str(t)
            }
            b'a' => {
                let t = self.ascii(value)?;
                self.heap.str(t)
            }
            _ => value,
        };
        let text = match spec {
            Some(Value::Str(s)) => {
                let spec = self.heap[s].text.clone();
                self.format(value, &spec)?
            }
            _ if matches!(value, Value::Str(_)) => {
                self.stack.push(value);
                return Ok(());
            }
            _ => self.format(value, "")?,
        };
        let text = self.heap.str(text);
        self.stack.push(text);
        Ok(())
    }

    pub(super) fn build_string(&mut self, n: usize) -> R<()> {
        let at = self.stack.len() - n;
        let bytes = self.stack[at..].iter().map(|part| if let Value::Str(s) = part { self.heap[*s].text.len() } else { 0 }).sum();
        let mut out = String::with_capacity(bytes);
        for part in &self.stack[at..] {
            if let Value::Str(s) = part {
                out.push_str(&self.heap[*s].text);
            }
        }
        self.stack.truncate(at);
        self.charge((out.len() / 64) as u64)?;
        let text = self.heap.str(out);
        self.stack.push(text);
        Ok(())
    }

    /// `a, b = value`: the items are pushed, the first on top.
    pub(super) fn unpack(&mut self, n: usize) -> R<()> {
        let value = self.pop();
        let items: SmallVec<[Value; 4]> = match value {
            Value::Tuple(t) => SmallVec::from_slice(&self.heap[t].0),
            Value::List(l) => SmallVec::from_slice(&self.heap[l].0),
            _ => self.unpack_some(value, n)?,
        };
        match items.len() {
            found if found < n => Err(self.value_error(format!("not enough values to unpack (expected {n}, got {found})"))),
            found if found > n => Err(self.value_error(format!("too many values to unpack (expected {n})"))),
            _ => {
                self.stack.extend(items.iter().rev());
                Ok(())
            }
        }
    }

    /// At most one item more than is wanted: the iterable may be endless.
    fn unpack_some(&mut self, value: Value, n: usize) -> R<SmallVec<[Value; 4]>> {
        let iter = self.iter_to_unpack(value)?;
        let mut items = SmallVec::new();
        while items.len() <= n {
            match self.next(iter)? {
                Some(item) => items.push(item),
                None => break,
            }
        }
        Ok(items)
    }

    fn iter_to_unpack(&mut self, value: Value) -> R<Value> {
        match self.iter(value) {
            Err(raise) if self.raised(&raise, Builtin::TypeError) && self.special(value, sym::ITER).is_none() => {
                let message = format!("cannot unpack non-iterable {} object", self.type_name(value));
                Err(self.type_error(message))
            }
            other => other,
        }
    }

    /// `a, *b, c = value`
    pub(super) fn unpack_ex(&mut self, before: usize, after: usize) -> R<()> {
        let value = self.pop();
        let iter = self.iter_to_unpack(value)?;
        let items = self.collect(iter)?;
        if items.len() < before + after {
            let message = format!("not enough values to unpack (expected at least {}, got {})", before + after, items.len());
            return Err(self.value_error(message));
        }
        let split = items.len() - after;
        self.stack.extend(items[split..].iter().rev());
        let middle = self.heap.list(items[before..split].to_vec());
        self.stack.push(middle);
        self.stack.extend(items[..before].iter().rev());
        Ok(())
    }

    /// The items of `*value` in a list or tuple display.
    pub(super) fn collect_starred(&mut self, value: Value) -> R<Vec<Value>> {
        match self.collect(value) {
            Err(raise) if self.raised(&raise, Builtin::TypeError) && !self.is_iterable(value) => {
                let message = format!("Value after * must be an iterable, not {}", self.type_name(value));
                Err(self.type_error(message))
            }
            other => other,
        }
    }

    fn is_iterable(&mut self, value: Value) -> bool {
        matches!(value, Value::Iter(_)) || self.special(value, sym::ITER).is_some() || self.special(value, sym::GETITEM).is_some()
    }

    /// The arguments of `f(*value)`.
    pub(super) fn starred_arguments(&mut self, callee: Value, value: Value) -> R<Few> {
        match value {
            Value::Tuple(t) => return Ok(SmallVec::from_slice(&self.heap[t].0)),
            Value::List(l) => return Ok(SmallVec::from_slice(&self.heap[l].0)),
            _ => {}
        }
        match self.collect(value) {
            Ok(items) => Ok(SmallVec::from_vec(items)),
            Err(raise)
                if self.raised(&raise, Builtin::TypeError)
                    && !matches!(value, Value::Instance(_) | Value::Generator(_) | Value::Iter(_)) =>
            {
                let message = format!("{} argument after * must be an iterable, not {}", self.callee_name(callee), self.type_name(value));
                Err(self.type_error(message))
            }
            Err(raise) => Err(raise),
        }
    }

    /// How an error message names what is called: `__main__.f()`.
    fn callee_name(&mut self, callee: Value) -> String {
        match callee {
            Value::Function(f) => {
                let function = &self.heap[f];
                format!("{}.{}()", self.display(function.module_name), self.display(function.qualname))
            }
            Value::Method(m) => {
                let inner = self.heap[m].callee;
                self.callee_name(inner)
            }
            Value::Class(c) if !self.heap[c].builtin => {
                let module = self.class_attr(c, sym::MODULE).map_or(String::new(), |m| self.display(m));
                format!("{module}.{}()", self.display(self.heap[c].qualname))
            }
            Value::Class(c) => format!("{}()", self.class_name(c)),
            Value::Native(n) => format!("{}()", n.name),
            _ => format!("{} object", self.type_name(callee)),
        }
    }

    /// `{**mapping}`
    pub(super) fn update_from_mapping(&mut self, dict: Ref<Dict>, mapping: Value) -> R<()> {
        for (key, value) in self.mapping_items(mapping)?.ok_or(()).map_err(|()| {
            let message = format!("'{}' object is not a mapping", self.type_name(mapping));
            self.type_error(message)
        })? {
            self.dict_set(dict, key, value)?;
        }
        Ok(())
    }

    /// A dict whose items are read without asking its class: not one of a class with an `__iter__` of its own.
    pub(crate) fn plain_dict(&mut self, mapping: Value) -> Option<Ref<Dict>> {
        if let Value::Instance(i) = mapping
            && !matches!(self.class_attr(self.heap[i].class, sym::ITER), Some(Value::Native(_)))
        {
            return None;
        }
        match self.plain(mapping) {
            Value::Dict(d) => Some(d),
            _ => None,
        }
    }

    /// The items of a mapping; `None` where it is none.
    fn mapping_items(&mut self, mapping: Value) -> R<Option<Vec<(Value, Value)>>> {
        if let Some(d) = self.plain_dict(mapping) {
            return Ok(Some(self.heap[d].0.iter().map(|e| (e.key, e.value)).collect()));
        }
        let Some(keys) = self.get_attr_opt(mapping, sym::N_KEYS)? else { return Ok(None) };
        let keys = self.call(keys, &[])?;
        let mut items = Vec::new();
        for key in self.collect(keys)? {
            let value = self.get_item(mapping, key)?;
            items.push((key, value));
        }
        Ok(Some(items))
    }

    /// `f(**mapping)`
    pub(super) fn merge_keywords(&mut self, dict: Ref<Dict>, mapping: Value, callee: Value) -> R<()> {
        let Some(items) = self.mapping_items(mapping)? else {
            let message = format!("{} argument after ** must be a mapping, not {}", self.callee_name(callee), self.type_name(mapping));
            return Err(self.type_error(message));
        };
        for (key, value) in items {
            if self.dict_get(dict, key)?.is_some() {
                let message = match self.plain(key) {
                    Value::Str(_) => {
                        format!("{} got multiple values for keyword argument '{}'", self.callee_name(callee), self.display(key))
                    }
                    _ => "keywords must be strings".to_string(),
                };
                return Err(self.type_error(message));
            }
            self.dict_set(dict, key, value)?;
        }
        Ok(())
    }

    /// A global that the module does not bind: a builtin, a name of the host, or a NameError.
    #[cold]
    pub(super) fn load_builtin(&mut self, slot: u32) -> R<Value> {
        let name = self.heap[self.frame.module].names[slot as usize];
        if let Some(value) = self.builtin(name) {
            return Ok(value);
        }
        let module = self.frame.module;
        if let Some(dict) = self.heap[module].dict
            && let Some(value) = self.dict_get_symbol(dict, name)
        {
            self.heap[module].slots[slot as usize] = value;
            return Ok(value);
        }
        Err(self.missing_name(name))
    }

    fn missing_name(&mut self, name: Symbol) -> Raise {
        let text = self.symbols.text(name);
        match crate::python::builtins::left_out(text) {
            Some(why) => {
                let message = format!("name '{text}' is not defined: {why}");
                self.error(Builtin::NameError, message)
            }
            None => self.name_error(name),
        }
    }

    /// The value of a name that is Python's or the host's own.
    pub fn builtin(&mut self, name: Symbol) -> Option<Value> {
        if let Some(value) = self.builtins.get(&name) {
            return Some(*value);
        }
        let text = self.symbols.text(name).to_string();
        let value = self.find_builtin(&text)?;
        self.builtins.insert(name, value);
        Some(value)
    }

    fn find_builtin(&mut self, text: &str) -> Option<Value> {
        use crate::python::host::HostName;
        let (host, mut cx) = self.host_cx();
        match host.lookup(&mut cx, text) {
            Some(HostName::Value(value)) => return Some(value),
            Some(HostName::Import(module, attribute)) => {
                let module = self.symbols.intern(module);
                let attribute = self.symbols.intern(attribute);
                let module = self.load_module(module).ok()??;
                return self.get_attr(Value::Module(module), attribute).ok();
            }
            None => {}
        }
        if let Some(class) = Builtin::by_name(text) {
            return Some(class.value());
        }
        if let Some(native) = crate::python::builtins::FUNCTIONS.iter().find(|n| n.name == text) {
            return Some(Value::Native(native));
        }
        Some(match text {
            "None" => Value::None,
            "True" => Value::Bool(true),
            "False" => Value::Bool(false),
            "NotImplemented" => Value::NotImplemented,
            "Ellipsis" => Value::Ellipsis,
            "EnvironmentError" | "IOError" => Builtin::OSError.value(),
            "__debug__" => Value::Bool(true),
            "__import__" => Value::Native(&super::import::IMPORT),
            "__build_class__" => Value::Native(&super::import::BUILD_CLASS),
            _ => return None,
        })
    }

    /// `__name__` of the module that is running.
    pub(super) fn frame_module_name(&self) -> Option<Value> {
        Some(self.heap[self.frame.module].name)
    }

    /// What stands at a direction of the program: its value, or the turn that a run puts in its place. Where directions are recorded,
    /// it remembers that another turn could stand there.
    pub(super) fn direction(&mut self, id: DirectionId, value: Value) -> Value {
        if let Some(turn) = self.directions.get(&id).copied() {
            return Value::Int(i64::from(turn), self.trace.site(id.0, f64::from(turn)));
        }
        if !self.trace.has_turns() {
            return value;
        }
        match value {
            Value::Int(turn, handle) if turn.abs() < 1000 => {
                let site = Num { value: AS_WRITTEN, handle: self.trace.site(id.0, AS_WRITTEN) };
                let number = turn as f64;
                Value::Int(turn, self.trace.binary(TraceOp::Override, site, Num { value: number, handle }, number))
            }
            Value::Host(object) => Value::Host(HostObject { site: self.trace.site(id.0, AS_WRITTEN), ..object }),
            other => other,
        }
    }
}
