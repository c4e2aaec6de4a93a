//! Against what CPython answered.

use super::*;
use crate::python::error::Stop;
use crate::python::host::Nothing;
use crate::python::recorded::{bits, float, int, rows};
use crate::python::vm::Options;
use crate::trace::{Guard, Node, Trace};
use std::cmp::Ordering;

#[test]
fn ints_divide_to_the_nearest_float() {
    for (a, b, expected) in rows::<(String, String, String)>(include_str!("../recorded/divide.json")) {
        match true_divide(&int(&a), &int(&b)) {
            Some(quotient) => assert_eq!(bits(quotient), expected, "{a} / {b}"),
            None => assert_eq!(expected, "OverflowError: integer division result too large for a float", "{a} / {b}"),
        }
    }
}

#[test]
fn floats_round_as_their_exact_decimals_do() {
    for (x, digits, expected) in rows::<(String, i64, String)>(include_str!("../recorded/round.json")) {
        match round_float(float(&x), digits) {
            Some(rounded) => assert_eq!(bits(rounded), expected, "round({:?}, {digits})", float(&x)),
            None => assert_eq!(expected, "OverflowError: rounded value too large to represent", "round({:?}, {digits})", float(&x)),
        }
    }
}

#[test]
fn floats_divide_with_the_sign_of_the_divisor() {
    for (x, y, quotient, rest) in rows::<(String, String, String, String)>(include_str!("../recorded/divmod.json")) {
        let (q, r) = float_divmod(float(&x), float(&y));
        assert_eq!((bits(q), bits(r)), (quotient, rest), "divmod({:?}, {:?})", float(&x), float(&y));
    }
}

#[test]
fn equal_numbers_have_equal_hashes() {
    for (x, expected) in rows::<(String, i64)>(include_str!("../recorded/hash_float.json")) {
        assert_eq!(hash_float(float(&x)), expected, "hash({:?})", float(&x));
    }
    for (n, expected) in rows::<(String, i64)>(include_str!("../recorded/hash_int.json")) {
        assert_eq!(hash_big(&int(&n)), expected, "hash({n})");
    }
}

#[test]
fn ints_are_read_in_every_base() {
    for (text, base, expected) in rows::<(String, u32, String)>(include_str!("../recorded/parse_int.json")) {
        match parse_int(&text, base) {
            Ok(value) => assert_eq!(format!("{value:#x}"), expected, "{text:?} in base {base}"),
            Err(IntError::Invalid) => assert!(expected.starts_with("ValueError: invalid literal"), "{text:?} in base {base}: {expected}"),
            Err(IntError::TooManyDigits(n)) => assert!(expected.contains(&format!("value has {n} digits")), "{text:?}: {expected}"),
        }
    }
}

#[test]
fn floats_and_complex_numbers_are_read() {
    for (text, expected) in rows::<(String, String)>(include_str!("../recorded/parse_float.json")) {
        match parse_float(&text) {
            Some(value) => assert_eq!(bits(value), expected, "{text:?}"),
            None => assert!(expected.starts_with("ValueError"), "{text:?}: {expected}"),
        }
    }
    for (text, expected) in rows::<(String, String)>(include_str!("../recorded/parse_complex.json")) {
        match parse_complex(&text) {
            Some(c) => assert_eq!(format!("{} {}", bits(c.re), bits(c.im)), expected, "{text:?}"),
            None => assert!(expected.starts_with("ValueError"), "{text:?}: {expected}"),
        }
    }
}

#[test]
fn long_ints_are_not_written() {
    assert_eq!(int_to_string(&-BigInt::from(10).pow(4299)).map(|t| t.len()), Ok(4301));
    assert_eq!(int_to_string(&BigInt::from(10).pow(4300)), Err(TooManyDigits));
}

/// What an operation does to a traced number: the nodes and guards that it leaves, in a machine of its own.
fn traced(values: &[f64], body: impl FnOnce(&mut Vm<'_>, Vec<Handle>)) -> (Vec<Node>, Vec<Guard>) {
    let (mut host, mut output) = (Nothing, |_: &str| {});
    let mut vm = Vm::new(&mut host, &mut output, Options { trace: Trace::recording(100), ..Options::default() });
    let handles = (0..).zip(values).map(|(id, value)| vm.trace.literal(id, *value)).collect();
    body(&mut vm, handles);
    (vm.trace.nodes()[values.len()..].to_vec(), vm.trace.guards().to_vec())
}

fn compute(vm: &mut Vm<'_>, op: BinaryOp, a: Value, b: Value) -> Value {
    binary(vm, op, a, b).ok().flatten().expect("numbers that take the operator")
}

#[test]
fn sums_of_floats_keep_their_handles_without_a_guard() {
    let (nodes, guards) = traced(&[1.5], |vm, h| {
        let sum = compute(vm, BinaryOp::Add, Value::Float(1.5, h[0]), Value::int(2));
        assert!(!sum.handle().is_none());
    });
    assert_eq!(nodes, [Node::Binary(TraceOp::Add, num(1.5, Handle(1)), Num::plain(2.0), 3.5)]);
    assert_eq!(guards, []);
}

#[test]
fn what_could_raise_is_guarded() {
    let (_, guards) = traced(&[4.0], |vm, h| {
        compute(vm, BinaryOp::Div, Value::float(1.0), Value::Float(4.0, h[0]));
    });
    assert_eq!(guards, [Guard::Zero(num(4.0, Handle(1)), false)]);
    let (_, guards) = traced(&[-8.0, 0.5], |vm, h| {
        let root = compute(vm, BinaryOp::Pow, Value::Float(-8.0, h[0]), Value::Float(0.5, h[1]));
        assert!(matches!(root, Value::Complex(_)));
    });
    assert!(guards.contains(&Guard::Equals(num(-8.0, Handle(1)))) && guards.contains(&Guard::Equals(num(0.5, Handle(2)))));
}

#[test]
fn ints_from_floats_stay_traced_while_they_are_exact() {
    let (nodes, guards) = traced(&[2.5], |vm, h| {
        let two = trunc(vm, num(2.5, h[0])).expect("finite");
        assert!(matches!(two, Value::Int(2, h) if !h.is_none()));
        let masked = compute(vm, BinaryOp::And, two, Value::int(6));
        assert!(masked.handle().is_none(), "bits are not in the table");
    });
    assert_eq!(nodes[0], Node::Unary(TraceOp::Trunc, num(2.5, Handle(1)), 2.0));
    assert!(matches!(guards[0], Guard::Order(a, b, Some(Ordering::Less)) if a.value == 2.0 && b.value == EXACT));
    assert!(matches!(guards[1], Guard::Equals(n) if n.value == 2.0));
}

#[test]
fn work_on_big_ints_is_paid_for() {
    let outcome = |op, a: BigInt, b: i64| {
        let (mut host, mut output) = (Nothing, |_: &str| {});
        let mut vm = Vm::new(&mut host, &mut output, Options::default());
        let a = vm.heap.big(a);
        binary(&mut vm, op, a, Value::int(b)).map(|_| ())
    };
    assert!(matches!(outcome(BinaryOp::Pow, BigInt::from(10), 10_000_000_000), Err(Raise::Exception(_))), "MemoryError");
    assert!(matches!(outcome(BinaryOp::Pow, BigInt::from(10), 100_000_000), Err(Raise::Stop(Stop::Steps))));
    assert!(matches!(outcome(BinaryOp::LShift, BigInt::from(1), 1 << 40), Err(Raise::Exception(_))), "MemoryError");
    assert!(outcome(BinaryOp::Pow, BigInt::from(3), 10_000).is_ok());
}
