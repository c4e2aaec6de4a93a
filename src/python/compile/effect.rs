//! What each instruction does to the height of the operand stack.

use crate::python::code::Op;

/// The label or instruction that an instruction may jump to.
pub(super) fn target_mut(op: &mut Op) -> Option<&mut u32> {
    match op {
        Op::Jump(target)
        | Op::JumpBack(target)
        | Op::PopJumpIfFalse(target)
        | Op::PopJumpIfTrue(target)
        | Op::JumpIfFalseOrPop(target)
        | Op::JumpIfTrueOrPop(target)
        | Op::PopJumpIfNone(target)
        | Op::ForIter(target)
        | Op::CompareJump { target, .. }
        | Op::CompareConstJump { target, .. } => Some(target),
        _ => None,
    }
}

fn built(count: u32) -> i32 {
    1 - i32::try_from(count).unwrap_or(i32::MAX)
}

/// By how much the stack grows where the instruction goes on, and where it jumps.
pub(super) fn effect(op: Op) -> (i32, i32) {
    use Op::*;
    let next = match op {
        JumpIfFalseOrPop(_) | JumpIfTrueOrPop(_) => return (-1, 0),
        ForIter(_) => return (1, -2),
        Nop
        | Swap
        | Rot3
        | Rot4
        | LoadAttr(_)
        | Unary(_)
        | Not
        | Jump(_)
        | JumpBack(_)
        | GetIter
        | ListToTuple
        | Yield
        | PushExc
        | PopExc
        | ExcMatch
        | ExcGroupMatch
        | Direction(_)
        | Statement(_)
        | LoadSubscrConst(_)
        | BinaryConst { .. }
        | BinaryFast { .. } => 0,
        DeleteFast(_) | DeleteDeref(_) | DeleteGlobal(_) | DeleteName(_) => 0,
        Dup
        | Copy(_)
        | Const(_)
        | LoadFast(_)
        | LoadDeref(_)
        | LoadClosure(_)
        | LoadClassDeref { .. }
        | LoadGlobal(_)
        | LoadName(_)
        | LoadMethod(_)
        | StartLoop
        | BeforeWith
        | WithExcept
        | Import { .. }
        | ImportFrom(_)
        | BuildClass
        | AssertionError
        | MatchSequence
        | MatchMapping
        | GetLen
        | MatchKeys
        | BinaryFastFast { .. }
        | BinaryFastConst { .. }
        | LoadFastAttr { .. } => 1,
        Dup2 | LoadFastFast { .. } => 2,
        Pop
        | StoreFast(_)
        | StoreDeref(_)
        | StoreGlobal(_)
        | StoreName(_)
        | DeleteAttr(_)
        | LoadSubscr
        | Binary(_)
        | Inplace(_)
        | Compare(_)
        | Is(_)
        | In(_)
        | PopJumpIfFalse(_)
        | PopJumpIfTrue(_)
        | PopJumpIfNone(_)
        | ListAppend(_)
        | SetAdd(_)
        | ListExtend
        | SetUpdate
        | DictUpdate
        | DictMerge(_)
        | Return
        | YieldFrom
        | Reraise
        | ExcGroupFinish
        | ImportStar
        | MatchRest
        | CompareConstJump { .. } => -1,
        StoreAttr(_) | DeleteSubscr | DictAdd(_) | CompareJump { .. } | MatchClass(_) => -2,
        StoreSubscr => -3,
        BuildTuple(n) | BuildList(n) | BuildSet(n) | BuildString(n) => built(n),
        BuildDict(n) => built(n.saturating_mul(2)),
        BuildSlice(n) => built(n.into()),
        Format { spec, .. } => -i32::from(spec),
        Unpack(n) => -built(n),
        UnpackEx { before, after } => i32::from(before) + i32::from(after),
        MakeFunction { flags, .. } => built((flags & 15).count_ones()),
        Call(n) => built(n) - 1,
        CallKw { count, .. } => built(count.into()) - 1,
        CallEx(keywords) => -1 - i32::from(keywords),
        CallMethod(n) => built(n) - 2,
        CallMethodKw { count, .. } => built(count.into()) - 2,
        Raise(n) => -i32::from(n),
    };
    (next, next)
}
