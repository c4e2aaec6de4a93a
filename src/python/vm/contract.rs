//! Signatures for native code.
#![allow(unused_variables, clippy::unimplemented)]
use super::Vm;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::native::Args;
use crate::python::value::*;
use crate::trace::{Num, Op as TraceOp};
use num_bigint::BigInt;
use smallvec::SmallVec;

macro_rules! contract {
    ($($name:ident($($arg:ident: $t:ty),*) -> $r:ty;)*) => { $(pub fn $name(&mut self, $($arg: $t),*) -> $r { unimplemented!() })* };
}
#[allow(missing_docs)]
impl Vm<'_> {
    contract! {
        error(class: Builtin, message: String) -> Raise;
        key_error(key: Value) -> Raise;
        stop_iteration() -> Raise;
        call(callee: Value, args: &[Value]) -> R<Value>;
        resume_generator(generator: Ref<Generator>, sent: Value) -> R<Option<Value>>;
        isinstance(value: Value, class: Value) -> R<bool>;
        globals_dict() -> Ref<Dict>;
        locals_dict() -> Ref<Dict>;
        dir_names(object: Value) -> R<Vec<String>>;
        host_items(object: Value) -> R<Option<SmallVec<[Value; 4]>>>;
        call_with(callee: Value, args: Args<'_>) -> R<Value>;
        call_method(object: Value, name: Symbol, args: &[Value]) -> R<Value>;
        special(object: Value, name: Symbol) -> Option<Value>;
        get_attr(object: Value, name: Symbol) -> R<Value>;
        get_attr_opt(object: Value, name: Symbol) -> R<Option<Value>>;
        set_attr(object: Value, name: Symbol, value: Value) -> R<()>;
        del_attr(object: Value, name: Symbol) -> R<()>;
        truth(value: Value) -> R<bool>;
        eq(a: Value, b: Value) -> R<bool>;
        compare(op: CompareOp, a: Value, b: Value) -> R<Value>;
        less(a: Value, b: Value) -> R<bool>;
        binary(op: BinaryOp, a: Value, b: Value) -> R<Value>;
        inplace(op: BinaryOp, a: Value, b: Value) -> R<Value>;
        unary(op: UnaryOp, a: Value) -> R<Value>;
        index(value: Value) -> R<i64>;
        index_big(value: Value) -> R<BigInt>;
        as_float(value: Value) -> R<f64>;
        repr(value: Value) -> R<String>;
        str(value: Value) -> R<String>;
        ascii(value: Value) -> R<String>;
        format(value: Value, spec: &str) -> R<String>;
        charge(steps: u64) -> R<()>;
        reserve(bytes: usize) -> R<()>;
        write_output(text: &str) -> R<()>;
    }
    pub fn bind<const N: usize>(
        &mut self,
        function: &str,
        args: Args<'_>,
        names: [&'static str; N],
        required: usize,
    ) -> R<[Option<Value>; N]> {
        unimplemented!()
    }
    pub fn type_error(&mut self, message: impl Into<String>) -> Raise {
        unimplemented!()
    }
    pub fn value_error(&mut self, message: impl Into<String>) -> Raise {
        unimplemented!()
    }
    pub fn class_of(&self, value: Value) -> Ref<Class> {
        unimplemented!()
    }
    pub fn type_name(&self, value: Value) -> String {
        unimplemented!()
    }
    pub fn is_instance(&self, value: Value, class: Builtin) -> bool {
        unimplemented!()
    }
    pub fn plain(&self, value: Value) -> Value {
        unimplemented!()
    }
    pub fn text(&self, text: Ref<Str>) -> &str {
        &self.heap[text].text
    }
    pub fn new_str(&mut self, text: impl Into<Box<str>>) -> Value {
        self.heap.str(text)
    }
    pub fn new_tuple(&mut self, items: impl Into<SmallVec<[Value; 3]>>) -> Value {
        self.heap.tuple(items)
    }
    pub fn new_list(&mut self, items: Vec<Value>) -> Value {
        self.heap.list(items)
    }
    /// Pins a traced number: the run depends on its very value. Returns it without its handle.
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
        let h = self.trace.unary(op, a, result);
        Value::Float(result, h)
    }
}
