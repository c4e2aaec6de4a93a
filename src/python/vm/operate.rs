//! Operators: numbers and strings at once, everything else by its special methods.

use super::Vm;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::numbers;
use crate::python::symbols::sym;
use crate::python::types::containers;
use crate::python::value::{BinaryOp, CompareOp, Symbol, UnaryOp, Value};
use num_bigint::BigInt;

/// The special methods of an operator: `a op b`, the reflected one, `a op= b`.
fn methods(op: BinaryOp) -> (Symbol, Symbol, Symbol) {
    match op {
        BinaryOp::Add => (sym::ADD, sym::RADD, sym::IADD),
        BinaryOp::Sub => (sym::SUB, sym::RSUB, sym::ISUB),
        BinaryOp::Mul => (sym::MUL, sym::RMUL, sym::IMUL),
        BinaryOp::Div => (sym::TRUEDIV, sym::RTRUEDIV, sym::ITRUEDIV),
        BinaryOp::FloorDiv => (sym::FLOORDIV, sym::RFLOORDIV, sym::IFLOORDIV),
        BinaryOp::Mod => (sym::MOD, sym::RMOD, sym::IMOD),
        BinaryOp::Pow => (sym::POW, sym::RPOW, sym::IPOW),
        BinaryOp::LShift => (sym::LSHIFT, sym::RLSHIFT, sym::ILSHIFT),
        BinaryOp::RShift => (sym::RSHIFT, sym::RRSHIFT, sym::IRSHIFT),
        BinaryOp::And => (sym::AND, sym::RAND, sym::IAND),
        BinaryOp::Or => (sym::OR, sym::ROR, sym::IOR),
        BinaryOp::Xor => (sym::XOR, sym::RXOR, sym::IXOR),
        BinaryOp::MatMul => (sym::MATMUL, sym::RMATMUL, sym::IMATMUL),
    }
}

fn comparison_method(op: CompareOp) -> Symbol {
    match op {
        CompareOp::Lt => sym::LT,
        CompareOp::Le => sym::LE,
        CompareOp::Eq => sym::EQ,
        CompareOp::Ne => sym::NE,
        CompareOp::Gt => sym::GT,
        CompareOp::Ge => sym::GE,
    }
}

fn is_number(value: Value) -> bool {
    matches!(value, Value::Int(..) | Value::Float(..) | Value::Bool(_) | Value::Big(_) | Value::Complex(_))
}

fn is_sequence(value: Value) -> bool {
    matches!(value, Value::Str(_) | Value::List(_) | Value::Tuple(_) | Value::Bytes(_) | Value::ByteArray(_))
}

fn is_host(value: Value) -> bool {
    matches!(value, Value::Host(_) | Value::Record(_))
}

impl Vm<'_> {
    /// `a op b`
    pub fn binary(&mut self, op: BinaryOp, a: Value, b: Value) -> R<Value> {
        match self.try_binary(op, a, b)? {
            Some(value) => Ok(value),
            None => Err(self.unsupported(op.text(), a, b)),
        }
    }

    fn unsupported(&mut self, op: &str, a: Value, b: Value) -> Raise {
        let (x, y) = (self.type_name(a), self.type_name(b));
        self.type_error(format!("unsupported operand type(s) for {op}: '{x}' and '{y}'"))
    }

    fn try_binary(&mut self, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
        if is_number(a) && is_number(b) {
            return numbers::binary(self, op, a, b);
        }
        if let (BinaryOp::Add, Value::Str(x), Value::Str(y)) = (op, a, b) {
            let bytes = self.heap[x].text.len() + self.heap[y].text.len();
            self.reserve(bytes)?;
            let mut text = String::with_capacity(bytes);
            text.push_str(&self.heap[x].text);
            text.push_str(&self.heap[y].text);
            return Ok(Some(self.heap.str(text)));
        }
        if is_host(a) || is_host(b) {
            let (x, y) = (self.plain(a), self.plain(b));
            let (host, mut cx) = self.host_cx();
            if let Some(value) = host.binary(&mut cx, op, x, y)? {
                return Ok(Some(value));
            }
        }
        self.binary_by_methods(op, a, b)
    }

    fn binary_by_methods(&mut self, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
        let (left_name, right_name, _) = methods(op);
        let (left, right) = (self.class_of(a), self.class_of(b));
        let reflected = if left == right { None } else { self.class_attr(right, right_name) };
        let mut tried = false;
        if let Some(function) = reflected {
            let overrides = self.is_subclass(right, left) && !self.class_attr(left, right_name).is_some_and(|f| f.is(function));
            // A sequence's own `+` and `*` come after whatever the right side says.
            if overrides || is_sequence(a) && matches!(b, Value::Instance(_)) {
                tried = true;
                if let Some(value) = self.operator_call(function, b, a)? {
                    return Ok(Some(value));
                }
            }
        }
        if let Some(function) = self.class_attr(left, left_name)
            && let Some(value) = self.operator_call(function, a, b)?
        {
            return Ok(Some(value));
        }
        match reflected {
            Some(function) if !tried => self.operator_call(function, b, a),
            _ => Ok(None),
        }
    }

    /// A special method's answer; `None` for NotImplemented.
    fn operator_call(&mut self, function: Value, receiver: Value, other: Value) -> R<Option<Value>> {
        if function.is_none() {
            return Ok(None);
        }
        let value = self.call_unbound(function, receiver, &[other])?;
        Ok(if matches!(value, Value::NotImplemented) { None } else { Some(value) })
    }

    /// `a op= b`
    pub fn inplace(&mut self, op: BinaryOp, a: Value, b: Value) -> R<Value> {
        if !is_number(a) && !matches!(a, Value::Str(_) | Value::Tuple(_)) && !is_host(a) {
            let class = self.class_of(a);
            if let Some(function) = self.class_attr(class, methods(op).2)
                && let Some(value) = self.operator_call(function, a, b)?
            {
                // `class Stack(list)`: the method of `list` answers with the list inside.
                let inner = self.plain(a);
                return Ok(if matches!(a, Value::Instance(_)) && value.is(inner) { a } else { value });
            }
        }
        match self.try_binary(op, a, b)? {
            Some(value) => Ok(value),
            None => {
                let text = if op == BinaryOp::Pow { "**=".to_string() } else { format!("{}=", op.text()) };
                Err(self.unsupported(&text, a, b))
            }
        }
    }

    /// `op a`
    pub fn unary(&mut self, op: UnaryOp, a: Value) -> R<Value> {
        if is_number(a)
            && let Some(value) = numbers::unary(self, op, a)?
        {
            return Ok(value);
        }
        if is_host(a) {
            let (host, mut cx) = self.host_cx();
            if let Some(value) = host.unary(&mut cx, op, a)? {
                return Ok(value);
            }
        }
        let (name, text) = match op {
            UnaryOp::Neg => (sym::NEG, "unary -"),
            UnaryOp::Pos => (sym::POS, "unary +"),
            UnaryOp::Invert => (sym::INVERT, "unary ~"),
        };
        match self.call_special(a, name, &[])? {
            Some(value) => Ok(value),
            None => {
                let message = format!("bad operand type for {text}: '{}'", self.type_name(a));
                Err(self.type_error(message))
            }
        }
    }

    /// A rich comparison.
    pub fn compare(&mut self, op: CompareOp, a: Value, b: Value) -> R<Value> {
        if is_number(a) && is_number(b) {
            if let Some(holds) = numbers::compare(self, op, a, b)? {
                return Ok(Value::Bool(holds));
            }
        } else if let (Value::Str(x), Value::Str(y)) = (a, b) {
            return Ok(Value::Bool(op.holds(self.heap[x].text.cmp(&self.heap[y].text))));
        } else if let (Value::Tuple(_), Value::Tuple(_)) | (Value::List(_), Value::List(_)) = (a, b) {
            if let Some(holds) = self.quick_sequences(op, a, b) {
                return Ok(Value::Bool(holds));
            }
            let holds = self.nested(" in comparison", |vm| containers::compare(vm, op, a, b))?;
            return Ok(holds.map_or(Value::NotImplemented, Value::Bool));
        } else if let Some(value) = self.compare_by_methods(op, a, b)? {
            return Ok(value);
        }
        match op {
            CompareOp::Eq => Ok(Value::Bool(a.is(b))),
            CompareOp::Ne => Ok(Value::Bool(!a.is(b))),
            _ => {
                let (x, y) = (self.type_name(a), self.type_name(b));
                Err(self.type_error(format!("'{}' not supported between instances of '{x}' and '{y}'", op.text())))
            }
        }
    }

    /// Two tuples or lists of short length whose items up to the first difference are untraced numbers and texts.
    fn quick_sequences(&self, op: CompareOp, a: Value, b: Value) -> Option<bool> {
        let (x, y): (&[Value], &[Value]) = match (a, b) {
            (Value::Tuple(x), Value::Tuple(y)) => (&self.heap[x].0, &self.heap[y].0),
            (Value::List(x), Value::List(y)) => (&self.heap[x].0, &self.heap[y].0),
            _ => return None,
        };
        if x.len().min(y.len()) > 16 {
            return None;
        }
        for (p, q) in x.iter().zip(y) {
            let order = match (*p, *q) {
                (Value::Int(p, h), Value::Int(q, k)) if (h.0 | k.0) == 0 => p.cmp(&q),
                (Value::Float(p, h), Value::Float(q, k)) if (h.0 | k.0) == 0 => p.partial_cmp(&q)?,
                (Value::Str(p), Value::Str(q)) if p == q => continue,
                (Value::Str(p), Value::Str(q)) => self.heap[p].text.cmp(&self.heap[q].text),
                _ => return None,
            };
            if order.is_ne() {
                return Some(match op {
                    CompareOp::Eq => false,
                    CompareOp::Ne => true,
                    _ => op.holds(order),
                });
            }
        }
        Some(op.holds(x.len().cmp(&y.len())))
    }

    fn compare_by_methods(&mut self, op: CompareOp, a: Value, b: Value) -> R<Option<Value>> {
        if is_host(a) || is_host(b) {
            let equal = match op {
                CompareOp::Eq | CompareOp::Ne => {
                    let (x, y) = (self.plain(a), self.plain(b));
                    let (host, mut cx) = self.host_cx();
                    host.equals(&mut cx, x, y)?
                }
                _ => None,
            };
            if let Some(equal) = equal {
                return Ok(Some(Value::Bool(equal == (op == CompareOp::Eq))));
            }
        }
        let (left, right) = (self.class_of(a), self.class_of(b));
        let (name, swapped) = (comparison_method(op), comparison_method(op.swapped()));
        let mut tried = false;
        if left != right && self.is_subclass(right, left) {
            tried = true;
            if let Some(function) = self.class_attr(right, swapped)
                && let Some(value) = self.nested(" in comparison", |vm| vm.operator_call(function, b, a))?
            {
                return Ok(Some(value));
            }
        }
        if let Some(function) = self.class_attr(left, name)
            && let Some(value) = self.nested(" in comparison", |vm| vm.operator_call(function, a, b))?
        {
            return Ok(Some(value));
        }
        if !tried
            && let Some(function) = self.class_attr(right, swapped)
            && let Some(value) = self.nested(" in comparison", |vm| vm.operator_call(function, b, a))?
        {
            return Ok(Some(value));
        }
        Ok(None)
    }

    /// `a is b or a == b`, as containers compare their items.
    pub fn eq(&mut self, a: Value, b: Value) -> R<bool> {
        match (a, b) {
            // A number is itself, NaN included; how traced ones compare is recorded by `compare`.
            (Value::Int(x, h), Value::Int(y, k)) if (h.0 | k.0) == 0 => return Ok(x == y),
            (Value::Str(x), Value::Str(y)) => return Ok(x == y || self.heap[x].text == self.heap[y].text),
            _ if a.handle().is_none() && b.handle().is_none() && a.is(b) => return Ok(true),
            _ => {}
        }
        match self.compare(CompareOp::Eq, a, b)? {
            Value::Bool(b) => Ok(b),
            other => self.truth(other),
        }
    }

    /// `a < b`
    pub fn less(&mut self, a: Value, b: Value) -> R<bool> {
        match self.compare(CompareOp::Lt, a, b)? {
            Value::Bool(b) => Ok(b),
            other => self.truth(other),
        }
    }

    /// `bool(value)`
    pub fn truth(&mut self, value: Value) -> R<bool> {
        Ok(match value {
            Value::Bool(b) => b,
            Value::None => false,
            Value::Int(..) | Value::Float(..) | Value::Big(_) | Value::Complex(_) => numbers::truth(self, value).unwrap_or(true),
            Value::Str(s) => !self.heap[s].text.is_empty(),
            Value::Bytes(b) => !self.heap[b].0.is_empty(),
            Value::ByteArray(b) => !self.heap[b].0.is_empty(),
            Value::Tuple(t) => !self.heap[t].0.is_empty(),
            Value::List(l) => !self.heap[l].0.is_empty(),
            Value::Dict(d) => !self.heap[d].0.is_empty(),
            Value::Set(s) | Value::FrozenSet(s) => !self.heap[s].0.is_empty(),
            Value::Range(r) => !self.heap[r].is_empty(),
            Value::View(_) | Value::Proxy(_) => self.len(value)? > 0,
            Value::Instance(_) | Value::Class(_) => return self.truth_by_methods(value),
            _ => true,
        })
    }

    fn truth_by_methods(&mut self, value: Value) -> R<bool> {
        if let Some(said) = self.call_special(value, sym::BOOL, &[])? {
            return match said {
                Value::Bool(b) => Ok(b),
                other => {
                    let message = format!("__bool__ should return bool, returned {}", self.type_name(other));
                    Err(self.type_error(message))
                }
            };
        }
        match self.call_special(value, sym::LEN, &[])? {
            Some(n) => {
                let n = self.index(n)?;
                if n < 0 { Err(self.value_error("__len__() should return >= 0")) } else { Ok(n != 0) }
            }
            None => Ok(true),
        }
    }

    /// An int from an object that is one or has `__index__`.
    pub fn index_value(&mut self, value: Value) -> R<Value> {
        match value {
            Value::Int(..) | Value::Big(_) => return Ok(value),
            Value::Bool(b) => return Ok(Value::int(i64::from(b))),
            _ => {}
        }
        if let plain @ (Value::Int(..) | Value::Big(_)) = self.plain(value) {
            return Ok(plain);
        }
        match self.call_special(value, sym::INDEX, &[])? {
            Some(found) => match self.plain(found) {
                plain @ (Value::Int(..) | Value::Big(_)) => Ok(plain),
                Value::Bool(b) => Ok(Value::int(i64::from(b))),
                _ => {
                    let message = format!("__index__ returned non-int (type {})", self.type_name(found));
                    Err(self.type_error(message))
                }
            },
            None => {
                let message = format!("'{}' object cannot be interpreted as an integer", self.type_name(value));
                Err(self.type_error(message))
            }
        }
    }

    /// `__index__` as a machine integer; a traced one is pinned.
    pub fn index(&mut self, value: Value) -> R<i64> {
        let value = self.index_value(value)?;
        match self.pin(value) {
            Value::Int(i, _) => Ok(i),
            _ => Err(self.error(Builtin::OverflowError, "Python int too large to convert to C ssize_t".to_string())),
        }
    }

    /// `__index__` of any size.
    pub fn index_big(&mut self, value: Value) -> R<BigInt> {
        let value = self.index_value(value)?;
        match self.pin(value) {
            Value::Int(i, _) => Ok(BigInt::from(i)),
            Value::Big(b) => Ok(self.heap[b].clone()),
            _ => Ok(BigInt::from(0)),
        }
    }

    /// A float from a number; a traced one is pinned.
    pub fn as_float(&mut self, value: Value) -> R<f64> {
        let plain = match value {
            Value::Instance(_) => match self.plain(value) {
                Value::Instance(_) => {
                    if let Some(found) = self.call_special(value, sym::FLOAT, &[])? {
                        match self.plain(found) {
                            Value::Float(f, _) => return Ok(f),
                            _ => {
                                let message =
                                    format!("{}.__float__ returned non-float (type {})", self.type_name(value), self.type_name(found));
                                return Err(self.type_error(message));
                            }
                        }
                    }
                    match self.special(value, sym::INDEX) {
                        Some(_) => self.index_value(value)?,
                        None => value,
                    }
                }
                plain => plain,
            },
            other => other,
        };
        let pinned = self.pin(plain);
        match numbers::to_float(self, pinned)? {
            Some(f) => Ok(f),
            None => {
                let message = format!("must be real number, not {}", self.type_name(value));
                Err(self.type_error(message))
            }
        }
    }

    /// The exact class of a value.
    pub fn class_of(&self, value: Value) -> Ref<Class> {
        let builtin = match value {
            Value::Instance(i) => return self.heap[i].class,
            Value::Class(c) => return self.heap[c].meta,
            Value::Host(_) | Value::Record(_) => return self.host_class(value),
            Value::Undefined | Value::None => Builtin::NoneType,
            Value::Ellipsis => Builtin::Ellipsis,
            Value::NotImplemented => Builtin::NotImplementedType,
            Value::Bool(_) => Builtin::Bool,
            Value::Int(..) | Value::Big(_) => Builtin::Int,
            Value::Float(..) => Builtin::Float,
            Value::Complex(_) => Builtin::Complex,
            Value::Str(_) => Builtin::Str,
            Value::Bytes(_) => Builtin::Bytes,
            Value::ByteArray(_) => Builtin::ByteArray,
            Value::Tuple(_) => Builtin::Tuple,
            Value::List(_) => Builtin::List,
            Value::Dict(_) => Builtin::Dict,
            Value::Set(_) => Builtin::Set,
            Value::FrozenSet(_) => Builtin::FrozenSet,
            Value::Slice(_) => Builtin::Slice,
            Value::Range(_) => Builtin::Range,
            Value::Function(_) => Builtin::Function,
            Value::Native(n) => Self::native_class(n),
            Value::Method(m) => match self.heap[m].callee {
                Value::Native(_) => Builtin::NativeFunction,
                _ => Builtin::Method,
            },
            Value::Generator(_) => Builtin::Generator,
            Value::Module(_) => Builtin::Module,
            Value::Cell(_) => Builtin::Cell,
            Value::Property(_) => Builtin::Property,
            Value::ClassMethod(_) => Builtin::ClassMethod,
            Value::StaticMethod(_) => Builtin::StaticMethod,
            Value::Proxy(_) => Builtin::MappingProxy,
            Value::Super(_) => Builtin::Super,
            Value::View(v) => match self.heap[v].kind {
                ViewKind::Keys => Builtin::DictKeys,
                ViewKind::Values => Builtin::DictValues,
                ViewKind::Items => Builtin::DictItems,
            },
            Value::Alias(a) => {
                if self.heap[a].origin.is_none() {
                    Builtin::UnionType
                } else {
                    Builtin::GenericAlias
                }
            }
            Value::Iter(i) => self.heap[i].0.class(),
        };
        builtin.class()
    }

    /// `type(value).__name__`
    pub fn type_name(&self, value: Value) -> String {
        if let Value::Host(_) | Value::Record(_) = value {
            return self.host_type_name(value).to_string();
        }
        self.class_name(self.class_of(value))
    }

    /// `isinstance` without hooks.
    pub fn is_instance(&self, value: Value, class: Builtin) -> bool {
        self.is_subclass(self.class_of(value), class.class())
    }

    /// The builtin value that an instance of a subclass of a builtin type holds; any other value as it is.
    #[inline]
    pub fn plain(&self, value: Value) -> Value {
        match value {
            Value::Instance(i) => match &self.heap[i].base {
                Base::Value(inner) => *inner,
                _ => value,
            },
            other => other,
        }
    }
}
