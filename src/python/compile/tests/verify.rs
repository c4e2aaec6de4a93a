//! Checks what the machine relies on: the operand stack is as high on every way to an instruction, jumps stay in the code, operands name what exists.

use crate::python::code::{Code, Op};
use crate::python::compile::effect::{effect, target_mut};

fn target(mut op: Op) -> Option<usize> {
    target_mut(&mut op).map(|target| *target as usize)
}

fn goes_on(op: Op) -> bool {
    !matches!(op, Op::Return | Op::Raise(_) | Op::Reraise | Op::Jump(_) | Op::JumpBack(_))
}

/// Walks all ways through the code.
pub(super) fn verify(code: &Code) {
    let name = &code.qualname;
    assert_eq!(code.ops.len(), code.ranges.len());
    assert!(code.statements.is_sorted_by_key(|statement| statement.0), "{name}: statements in order");
    let mut depths: Vec<Option<i32>> = vec![None; code.ops.len()];
    let mut todo = vec![(0, 0)];
    while let Some((pc, depth)) = todo.pop() {
        assert!(pc < code.ops.len(), "{name}: runs off its end");
        if let Some(known) = depths[pc] {
            assert_eq!(known, depth, "{name}: two heights at {pc} {:?}", code.ops[pc]);
            continue;
        }
        depths[pc] = Some(depth);
        let op = code.ops[pc];
        let (next, jumped) = effect(op);
        if let Some(target) = target(op) {
            assert!(target > pc || matches!(op, Op::JumpBack(_)), "{name}: only JumpBack goes back, at {pc}");
            todo.push((target, depth + jumped));
        }
        if goes_on(op) {
            assert!(depth + next >= 0, "{name}: empty stack at {pc} {op:?}");
            todo.push((pc + 1, depth + next));
        }
        if let Some(handler) = handler(code, pc) {
            assert!(i64::from(depth) >= i64::from(handler.depth), "{name}: handler wants more than there is at {pc}");
            todo.push((handler.target as usize, i32::try_from(handler.depth).unwrap() + 1));
        }
        match op {
            Op::Const(at) => assert!((at as usize) < code.consts.len()),
            Op::LoadFast(at) | Op::StoreFast(at) | Op::DeleteFast(at) => assert!(usize::from(at) < code.locals.len()),
            Op::LoadDeref(at) | Op::StoreDeref(at) | Op::DeleteDeref(at) | Op::LoadClosure(at) => {
                let cells = code.locals.len()..code.locals.len() + code.cells.len() + code.frees.len();
                assert!(cells.contains(&usize::from(at)), "{name}: no cell {at}");
            }
            Op::MakeFunction { child, .. } => assert!((child as usize) < code.children.len()),
            _ => {}
        }
        for piece in code.loops.iter().filter(|piece| (piece.start as usize..piece.end as usize).contains(&pc)) {
            let early = code.ops[pc..].iter().take(3).any(|op| matches!(op, Op::Jump(_) | Op::Return));
            assert!(depth >= i32::try_from(piece.depth).unwrap() + 2 || early, "{name}: a loop without its iterator at {pc} {op:?}");
        }
    }
}

fn handler(code: &Code, pc: usize) -> Option<crate::python::code::Handler> {
    let pc = u32::try_from(pc).unwrap();
    code.handlers.iter().copied().find(|handler| (handler.start..handler.end).contains(&pc))
}
