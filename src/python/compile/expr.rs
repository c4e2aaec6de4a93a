//! Expressions: each leaves one value on the stack.

use ruff_text_size::{Ranged, TextRange};

use super::collection::Sequence;
use super::{Compiled, Compiler, Label, RED_ZONE, STACK_PIECE, error};
use crate::python::code::{Const, Op};
use crate::python::value::{BinaryOp, CompareOp, UnaryOp};
use crate::syntax::ast::{self, BoolOp, CmpOp, Expr, Operator};

pub(super) fn binary_op(op: Operator) -> BinaryOp {
    match op {
        Operator::Add => BinaryOp::Add,
        Operator::Sub => BinaryOp::Sub,
        Operator::Mult => BinaryOp::Mul,
        Operator::MatMult => BinaryOp::MatMul,
        Operator::Div => BinaryOp::Div,
        Operator::Mod => BinaryOp::Mod,
        Operator::Pow => BinaryOp::Pow,
        Operator::LShift => BinaryOp::LShift,
        Operator::RShift => BinaryOp::RShift,
        Operator::BitOr => BinaryOp::Or,
        Operator::BitXor => BinaryOp::Xor,
        Operator::BitAnd => BinaryOp::And,
        Operator::FloorDiv => BinaryOp::FloorDiv,
    }
}

fn compare_op(op: CmpOp) -> Op {
    match op {
        CmpOp::Eq => Op::Compare(CompareOp::Eq),
        CmpOp::NotEq => Op::Compare(CompareOp::Ne),
        CmpOp::Lt => Op::Compare(CompareOp::Lt),
        CmpOp::LtE => Op::Compare(CompareOp::Le),
        CmpOp::Gt => Op::Compare(CompareOp::Gt),
        CmpOp::GtE => Op::Compare(CompareOp::Ge),
        CmpOp::Is => Op::Is(false),
        CmpOp::IsNot => Op::Is(true),
        CmpOp::In => Op::In(false),
        CmpOp::NotIn => Op::In(true),
    }
}

impl<'a> Compiler<'a> {
    /// Leaves the value of an expression on the stack.
    pub(super) fn expr(&mut self, expr: &'a Expr) -> Compiled {
        stacker::maybe_grow(RED_ZONE, STACK_PIECE, || self.plain_expr(expr))?;
        if let Some(id) = self.tuning.direction_at(expr.range()) {
            self.emit(Op::Direction(id), expr.range());
        }
        Ok(())
    }

    fn plain_expr(&mut self, expr: &'a Expr) -> Compiled {
        let range = expr.range();
        match expr {
            Expr::BoolOp(node) => return self.bool_op(node),
            Expr::Named(node) => {
                self.expr(&node.value)?;
                self.emit(Op::Dup, range);
                return self.store(&node.target);
            }
            Expr::BinOp(node) => {
                self.expr(&node.left)?;
                self.expr(&node.right)?;
                self.emit(Op::Binary(binary_op(node.op)), range);
            }
            Expr::UnaryOp(node) => return self.unary(node),
            Expr::Lambda(node) => return self.lambda(node),
            Expr::If(node) => return self.ternary(node),
            Expr::Dict(node) => return self.dict(node),
            Expr::Set(node) => return self.sequence(Sequence::Set, 0, &node.elts, range),
            Expr::List(node) => return self.sequence(Sequence::List, 0, &node.elts, range),
            Expr::Tuple(node) => return self.sequence(Sequence::Tuple, 0, &node.elts, range),
            Expr::ListComp(_) | Expr::SetComp(_) | Expr::DictComp(_) | Expr::Generator(_) => return self.comprehension(expr),
            Expr::Yield(node) => return self.yield_value(node),
            Expr::YieldFrom(node) => {
                self.in_function(range, "'yield' outside function")?;
                self.expr(&node.value)?;
                self.emit(Op::GetIter, range);
                self.constant(Const::None, range);
                self.emit(Op::YieldFrom, range);
            }
            Expr::Compare(node) => return self.compare(node),
            Expr::Call(node) => return self.call(node),
            Expr::FString(node) => return self.fstring(node),
            Expr::NumberLiteral(node) => {
                let value = self.number(node, false, range)?;
                self.constant(value, range);
            }
            Expr::StringLiteral(node) => self.constant(Const::Str(node.value.to_str().into()), range),
            Expr::BytesLiteral(node) => self.constant(Const::Bytes(node.value.bytes().collect()), range),
            Expr::BooleanLiteral(node) => self.constant(Const::Bool(node.value), range),
            Expr::NoneLiteral(_) => self.constant(Const::None, range),
            Expr::EllipsisLiteral(_) => self.constant(Const::Ellipsis, range),
            Expr::Attribute(node) => {
                self.expr(&node.value)?;
                let name = self.attribute(&node.attr);
                self.emit(Op::LoadAttr(name), range);
            }
            Expr::Subscript(node) => {
                self.expr(&node.value)?;
                self.expr(&node.slice)?;
                self.emit(Op::LoadSubscr, range);
            }
            Expr::Name(node) => self.load_name(&node.id, range),
            Expr::Slice(node) => return self.slice(node),
            Expr::Starred(_) => return error(range, "can't use starred expression here"),
            Expr::Await(_) => return error(range, "'await' is not part of PSDL"),
            Expr::TString(_) => return error(range, "template strings (t\"…\") are not part of PSDL"),
            Expr::IpyEscapeCommand(_) => return error(range, "shell commands are not part of PSDL"),
        }
        Ok(())
    }

    fn bool_op(&mut self, node: &'a ast::ExprBoolOp) -> Compiled {
        let end = self.label();
        let Some((last, first)) = node.values.split_last() else { return error(node.range, "invalid syntax") };
        let jump = if node.op == BoolOp::And { Op::JumpIfFalseOrPop } else { Op::JumpIfTrueOrPop };
        for value in first {
            self.expr(value)?;
            self.jump(jump, end, value.range());
        }
        self.expr(last)?;
        self.bind(end);
        Ok(())
    }

    fn unary(&mut self, node: &'a ast::ExprUnaryOp) -> Compiled {
        if let Some(value) = self.signed(node)? {
            self.constant(value, node.range);
            return Ok(());
        }
        self.expr(&node.operand)?;
        let op = match node.op {
            ast::UnaryOp::Not => Op::Not,
            ast::UnaryOp::Invert => Op::Unary(UnaryOp::Invert),
            ast::UnaryOp::UAdd => Op::Unary(UnaryOp::Pos),
            ast::UnaryOp::USub => Op::Unary(UnaryOp::Neg),
        };
        self.emit(op, node.range);
        Ok(())
    }

    fn ternary(&mut self, node: &'a ast::ExprIf) -> Compiled {
        let (otherwise, end) = (self.label(), self.label());
        self.jump_if(&node.test, false, otherwise)?;
        self.expr(&node.body)?;
        self.jump(Op::Jump, end, node.range);
        self.bind(otherwise);
        self.expr(&node.orelse)?;
        self.bind(end);
        Ok(())
    }

    fn yield_value(&mut self, node: &'a ast::ExprYield) -> Compiled {
        self.in_function(node.range, "'yield' outside function")?;
        match &node.value {
            Some(value) => self.expr(value)?,
            None => self.constant(Const::None, node.range),
        }
        self.emit(Op::Yield, node.range);
        Ok(())
    }

    fn slice(&mut self, node: &'a ast::ExprSlice) -> Compiled {
        for bound in [&node.lower, &node.upper] {
            match bound {
                Some(bound) => self.expr(bound)?,
                None => self.constant(Const::None, node.range),
            }
        }
        if let Some(step) = &node.step {
            self.expr(step)?;
        }
        self.emit(Op::BuildSlice(if node.step.is_some() { 3 } else { 2 }), node.range);
        Ok(())
    }

    /// The right side of a comparison: a display that is searched and then forgotten, being the last one, needs no list.
    fn comparator(&mut self, op: CmpOp, expr: &'a Expr, is_last: bool) -> Compiled {
        if is_last && matches!(op, CmpOp::In | CmpOp::NotIn) {
            let folded = match expr {
                Expr::List(node) => self.constants_of(&node.elts).map(Const::Tuple),
                Expr::Set(node) => self.constants_of(&node.elts).map(Const::FrozenSet),
                _ => None,
            };
            if let Some(value) = folded {
                self.constant(value, expr.range());
                return Ok(());
            }
        }
        self.expr(expr)
    }

    /// Compares with all comparators but the last, jumping to `failed` with one value too many on the stack; then evaluates the last
    /// one and returns its operator.
    fn comparisons(&mut self, node: &'a ast::ExprCompare, jump: fn(u32) -> Op, failed: Label) -> Result<Op, super::CompileError> {
        self.expr(&node.left)?;
        let last = node.comparators.len().saturating_sub(1);
        for (i, (op, right)) in node.ops.iter().zip(&node.comparators).enumerate() {
            self.comparator(*op, right, i == last)?;
            if i == last {
                return Ok(compare_op(*op));
            }
            self.emit(Op::Dup, node.range);
            self.emit(Op::Rot3, node.range);
            self.emit(compare_op(*op), node.range);
            self.jump(jump, failed, node.range);
        }
        error(node.range, "invalid syntax")
    }

    fn compare(&mut self, node: &'a ast::ExprCompare) -> Compiled {
        let (failed, end) = (self.label(), self.label());
        let op = self.comparisons(node, Op::JumpIfFalseOrPop, failed)?;
        self.emit(op, node.range);
        if node.comparators.len() > 1 {
            self.jump(Op::Jump, end, node.range);
            self.bind(failed);
            self.emit(Op::Swap, node.range);
            self.emit(Op::Pop, node.range);
            self.bind(end);
        }
        Ok(())
    }

    /// Jumps to the label where the expression is as true as `when`; goes on otherwise. Leaves nothing on the stack.
    pub(super) fn jump_if(&mut self, expr: &'a Expr, when: bool, label: Label) -> Compiled {
        stacker::maybe_grow(RED_ZONE, STACK_PIECE, || self.plain_jump_if(expr, when, label))
    }

    fn plain_jump_if(&mut self, expr: &'a Expr, when: bool, label: Label) -> Compiled {
        let range = expr.range();
        match expr {
            Expr::UnaryOp(node) if node.op == ast::UnaryOp::Not => return self.jump_if(&node.operand, !when, label),
            Expr::BoolOp(node) => {
                let decides = node.op == BoolOp::Or;
                let end = self.label();
                let short = if decides == when { label } else { end };
                let Some((last, first)) = node.values.split_last() else { return error(range, "invalid syntax") };
                for value in first {
                    self.jump_if(value, decides, short)?;
                }
                self.jump_if(last, when, label)?;
                self.bind(end);
            }
            Expr::If(node) => {
                let (otherwise, end) = (self.label(), self.label());
                self.jump_if(&node.test, false, otherwise)?;
                self.jump_if(&node.body, when, label)?;
                self.jump(Op::Jump, end, range);
                self.bind(otherwise);
                self.jump_if(&node.orelse, when, label)?;
                self.bind(end);
            }
            Expr::Compare(node) if node.comparators.len() > 1 => self.jump_if_compared(node, when, label)?,
            _ => {
                self.expr(expr)?;
                self.jump(if when { Op::PopJumpIfTrue } else { Op::PopJumpIfFalse }, label, range);
            }
        }
        Ok(())
    }

    fn jump_if_compared(&mut self, node: &'a ast::ExprCompare, when: bool, label: Label) -> Compiled {
        let (failed, end) = (self.label(), self.label());
        let op = self.comparisons(node, Op::PopJumpIfFalse, failed)?;
        self.emit(op, node.range);
        self.jump(if when { Op::PopJumpIfTrue } else { Op::PopJumpIfFalse }, label, node.range);
        self.jump(Op::Jump, end, node.range);
        self.bind(failed);
        self.emit(Op::Pop, node.range);
        if !when {
            self.jump(Op::Jump, label, node.range);
        }
        self.bind(end);
        Ok(())
    }

    /// Refuses what only functions may contain.
    pub(super) fn in_function(&self, range: TextRange, message: &str) -> Compiled {
        if self.scopes.get(self.unit.scope).kind.is_function_like() { Ok(()) } else { error(range, message) }
    }
}
