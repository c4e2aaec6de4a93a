//! What surrounds a statement: loops, `try`, `with`; and what must run when `return`, `break` or `continue` leaves them.
//!
//! A block may own a region of the exception table. Code that runs on the way out of a block is not within its region, so leaving
//! early cuts the region in pieces.

use ruff_text_size::TextRange;

use super::emit::Label;
use super::{CompileError, Compiled, Compiler, error};
use crate::python::code::{Const, Loop, Op, Slot};
use crate::syntax::ast::{Identifier, Stmt};

/// As in CPython.
const MAX_BLOCKS: usize = 20;

/// What the compiler is inside of.
#[derive(Clone)]
pub(super) enum BlockKind<'a> {
    /// `while`.
    While { next: Label, end: Label },
    /// `for`: iterator and counter are on the stack.
    For { next: Label, end: Label, piece: LoopPiece },
    /// The body of a `try` with `except` clauses.
    Try,
    /// The part of a `try` before its `finally`, whose body this is.
    Finally(&'a [Stmt]),
    /// A `finally` that an exception entered, which is on the stack and being handled.
    FinallyEnd,
    /// The body of a `with`: the manager's exit is on the stack.
    With(TextRange),
    /// An `except` clause and the name it binds.
    Except(Option<&'a Identifier>),
    /// An `except*` clause.
    ExceptStar,
    /// A value below, which is dropped on the way out: what a `return` was about to return.
    Value,
}

/// Where the code of a loop that is under way began.
#[derive(Clone)]
pub(super) struct LoopPiece {
    pub start: u32,
    pub depth: u32,
    pub range: TextRange,
    pub variable: Option<(Box<str>, Slot)>,
}

impl LoopPiece {
    pub fn until(&self, end: u32) -> Loop {
        Loop { start: self.start, end, depth: self.depth, range: self.range, variable: self.variable.clone() }
    }
}

/// Where exceptions of a block go.
#[derive(Clone, Copy)]
pub(super) struct Region {
    start: u32,
    target: Label,
    depth: u32,
    handling: u32,
}

/// See [`BlockKind`].
#[derive(Clone)]
pub(super) struct Block<'a> {
    pub kind: BlockKind<'a>,
    region: Option<Region>,
}

impl<'a> Compiler<'a> {
    /// Enters a block without a region.
    pub(super) fn push_block(&mut self, kind: BlockKind<'a>, range: TextRange) -> Compiled {
        if self.unit.blocks.len() >= MAX_BLOCKS {
            return error(range, "too many statically nested blocks");
        }
        self.unit.blocks.push(Block { kind, region: None });
        Ok(())
    }

    /// Enters a block whose exceptions go to `target`, with `depth` operands left and `handling` exceptions still being handled.
    pub(super) fn push_region(&mut self, kind: BlockKind<'a>, target: Label, depth: u32, handling: u32, range: TextRange) -> Compiled {
        self.push_block(kind, range)?;
        let start = self.unit.emitter.here();
        self.unit.emitter.expect_depth(target, depth + 1);
        if let Some(block) = self.unit.blocks.last_mut() {
            block.region = Some(Region { start, target, depth, handling });
        }
        Ok(())
    }

    /// Leaves the innermost block; its region, or this piece of it, ends here.
    pub(super) fn pop_block(&mut self) -> Option<Block<'a>> {
        let block = self.unit.blocks.pop()?;
        if let Some(Region { start, target, depth, handling }) = block.region {
            self.unit.emitter.handler(self.unit.blocks.len(), start, target, depth, handling);
        }
        Some(block)
    }

    /// Emits what must happen on the way out of all blocks but the outermost `keep`, below the topmost value if there is one to
    /// preserve; then the jump that `leave` emits; then goes on as if nothing had happened.
    pub(super) fn leave(&mut self, keep: usize, value: bool, range: TextRange, leave: impl FnOnce(&mut Self)) -> Compiled {
        let (depth, handling) = (self.unit.emitter.depth(), self.unit.handling);
        let mut left = Vec::new();
        while self.unit.blocks.len() > keep
            && let Some(block) = self.pop_block()
        {
            if let BlockKind::For { piece, .. } = &block.kind {
                let end = self.unit.emitter.here();
                self.unit.emitter.add_loop(piece.until(end));
            }
            let kind = block.kind.clone();
            left.push(block);
            self.unwind(kind, value, range)?;
        }
        leave(self);
        self.unit.emitter.set_depth(depth);
        self.unit.handling = handling;
        let here = self.unit.emitter.here();
        while let Some(mut block) = left.pop() {
            if let Some(region) = &mut block.region {
                region.start = here;
            }
            if let BlockKind::For { piece, .. } = &mut block.kind {
                piece.start = here;
            }
            self.unit.blocks.push(block);
        }
        Ok(())
    }

    fn unwind(&mut self, kind: BlockKind<'a>, value: bool, range: TextRange) -> Compiled {
        match kind {
            BlockKind::While { .. } | BlockKind::Try => {}
            BlockKind::For { .. } => {
                if value {
                    self.emit(Op::Rot3, range);
                }
                self.emit(Op::Pop, range);
                self.emit(Op::Pop, range);
            }
            BlockKind::Finally(body) => {
                if value {
                    self.push_block(BlockKind::Value, range)?;
                }
                self.body(body)?;
                if value {
                    self.pop_block();
                }
            }
            BlockKind::FinallyEnd => {
                self.drop_value(value, range);
                self.end_handling(range);
            }
            BlockKind::With(header) => {
                if value {
                    self.emit(Op::Swap, range);
                }
                self.exit_manager(header);
            }
            BlockKind::Except(name) => {
                self.end_handling(range);
                self.forget(name);
            }
            BlockKind::ExceptStar => {
                return error(range, "'break', 'continue' and 'return' cannot appear in an except* block");
            }
            BlockKind::Value => self.drop_value(value, range),
        }
        Ok(())
    }

    /// Drops the topmost value, or the one below the value to preserve.
    fn drop_value(&mut self, below: bool, range: TextRange) {
        if below {
            self.emit(Op::Swap, range);
        }
        self.emit(Op::Pop, range);
    }

    pub(super) fn begin_handling(&mut self, range: TextRange) {
        self.emit(Op::PushExc, range);
        self.unit.handling += 1;
    }

    pub(super) fn end_handling(&mut self, range: TextRange) {
        self.emit(Op::PopExc, range);
        self.unit.handling = self.unit.handling.saturating_sub(1);
    }

    /// The end of an `except … as name`.
    pub(super) fn forget(&mut self, name: Option<&'a Identifier>) {
        if let Some(name) = name {
            self.constant(Const::None, name.range);
            self.store_name(name, name.range);
            self.delete_name(name, name.range);
        }
    }

    /// exit →, called as at the end of a `with` without exception.
    pub(super) fn exit_manager(&mut self, header: TextRange) {
        self.unit.emitter.mark(header);
        for _ in 0..3 {
            self.constant(Const::None, header);
        }
        self.emit(Op::Call(3), header);
        self.emit(Op::Pop, header);
    }

    /// `return`, with the value on the stack.
    pub(super) fn leave_function(&mut self, range: TextRange) -> Compiled {
        let quiet = |block: &Block<'_>| {
            matches!(block.kind, BlockKind::While { .. } | BlockKind::For { .. } | BlockKind::Try | BlockKind::FinallyEnd)
                || matches!(block.kind, BlockKind::Except(None) | BlockKind::Value)
        };
        if self.unit.blocks.iter().all(quiet) {
            for _ in 0..self.unit.handling {
                self.emit(Op::PopExc, range);
            }
            self.emit(Op::Return, range);
            return Ok(());
        }
        self.leave(0, true, range, |compiler| compiler.emit(Op::Return, range))
    }

    /// `break` (`out`) and `continue`.
    pub(super) fn leave_loop(&mut self, out: bool, range: TextRange) -> Compiled {
        let Some(at) = self.unit.blocks.iter().rposition(|b| matches!(b.kind, BlockKind::While { .. } | BlockKind::For { .. })) else {
            return error(range, if out { "'break' outside loop" } else { "'continue' not properly in loop" });
        };
        let Some((is_for, next, end)) = self.unit.blocks.get(at).and_then(|block| match block.kind {
            BlockKind::While { next, end } => Some((false, next, end)),
            BlockKind::For { next, end, .. } => Some((true, next, end)),
            _ => None,
        }) else {
            return Ok(());
        };
        self.leave(at + 1, false, range, |compiler| match out {
            true if is_for => {
                compiler.emit(Op::Pop, range);
                compiler.emit(Op::Pop, range);
                compiler.jump(Op::Jump, end, range);
            }
            true => compiler.jump(Op::Jump, end, range),
            false => compiler.jump(Op::JumpBack, next, range),
        })
    }

    /// Stops where the program has become too long.
    pub(super) fn check_length(&mut self, range: TextRange) -> Result<(), CompileError> {
        self.work += 1;
        if self.work > super::MAX_OPS {
            return error(range, "the program is too long to be compiled");
        }
        Ok(())
    }
}
