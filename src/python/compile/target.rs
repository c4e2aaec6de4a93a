//! What can be assigned to and deleted.

use ruff_text_size::{Ranged, TextRange};

use super::emit::narrow;
use super::expr::binary_op;
use super::{Compiled, Compiler, RED_ZONE, STACK_PIECE, error};
use crate::python::code::Op;
use crate::syntax::ast::{self, Expr};

impl<'a> Compiler<'a> {
    /// value →, stored in the target.
    pub(super) fn store(&mut self, target: &'a Expr) -> Compiled {
        let range = target.range();
        match target {
            Expr::Name(node) => self.store_name(&node.id, range),
            Expr::Attribute(node) => {
                self.expr(&node.value)?;
                let name = self.attribute(&node.attr);
                self.emit(Op::StoreAttr(name), range);
            }
            Expr::Subscript(node) => {
                self.expr(&node.value)?;
                self.expr(&node.slice)?;
                self.emit(Op::StoreSubscr, range);
            }
            Expr::Tuple(node) => return self.unpack(&node.elts, range),
            Expr::List(node) => return self.unpack(&node.elts, range),
            _ => return error(range, "cannot assign to this expression"),
        }
        Ok(())
    }

    fn unpack(&mut self, targets: &'a [Expr], range: TextRange) -> Compiled {
        let starred = targets.iter().position(Expr::is_starred_expr);
        if targets.iter().filter(|target| target.is_starred_expr()).count() > 1 {
            return error(range, "multiple starred expressions in assignment");
        }
        let op = match starred.map(|before| (u16::try_from(before), u16::try_from(targets.len() - before - 1))) {
            None => Op::Unpack(narrow(targets.len())),
            Some((Ok(before), Ok(after))) => Op::UnpackEx { before, after },
            Some(_) => return error(range, "too many expressions in star-unpacking assignment"),
        };
        self.emit(op, range);
        for target in targets {
            let target = if let Expr::Starred(starred) = target { &starred.value } else { target };
            stacker::maybe_grow(RED_ZONE, STACK_PIECE, || self.store(target))?;
        }
        Ok(())
    }

    pub(super) fn delete(&mut self, target: &'a Expr) -> Compiled {
        let range = target.range();
        match target {
            Expr::Name(node) => self.delete_name(&node.id, range),
            Expr::Attribute(node) => {
                self.expr(&node.value)?;
                let name = self.attribute(&node.attr);
                self.emit(Op::DeleteAttr(name), range);
            }
            Expr::Subscript(node) => {
                self.expr(&node.value)?;
                self.expr(&node.slice)?;
                self.emit(Op::DeleteSubscr, range);
            }
            Expr::Tuple(ast::ExprTuple { elts, .. }) | Expr::List(ast::ExprList { elts, .. }) => {
                for target in elts {
                    stacker::maybe_grow(RED_ZONE, STACK_PIECE, || self.delete(target))?;
                }
            }
            _ => return error(range, "cannot delete this expression"),
        }
        Ok(())
    }

    pub(super) fn assign(&mut self, node: &'a ast::StmtAssign) -> Compiled {
        if let [target] = node.targets.as_slice()
            && self.swapped(target, &node.value)?
        {
            return Ok(());
        }
        self.expr(&node.value)?;
        let Some((last, first)) = node.targets.split_last() else { return error(node.range, "invalid syntax") };
        for target in first {
            self.emit(Op::Dup, node.range);
            self.store(target)?;
        }
        self.store(last)
    }

    /// `a, b = b, a` without a tuple, for two or three targets. False where the statement is something else.
    fn swapped(&mut self, target: &'a Expr, value: &'a Expr) -> Result<bool, super::CompileError> {
        let (Expr::Tuple(targets), Expr::Tuple(values)) = (target, value) else { return Ok(false) };
        let starred = targets.iter().chain(values).any(Expr::is_starred_expr);
        if starred || targets.len() != values.len() || !(2..=3).contains(&targets.len()) || self.constants_of(&values.elts).is_some() {
            return Ok(false);
        }
        for value in values {
            self.expr(value)?;
        }
        if values.len() == 3 {
            self.emit(Op::Rot3, value.range());
        }
        self.emit(Op::Swap, value.range());
        for target in targets {
            self.store(target)?;
        }
        Ok(true)
    }

    pub(super) fn augmented(&mut self, node: &'a ast::StmtAugAssign) -> Compiled {
        let op = Op::Inplace(binary_op(node.op));
        let range = node.target.range();
        match node.target.as_ref() {
            Expr::Name(name) => {
                self.load_name(&name.id, range);
                self.expr(&node.value)?;
                self.emit(op, node.range);
                self.store_name(&name.id, range);
            }
            Expr::Attribute(attribute) => {
                self.expr(&attribute.value)?;
                let name = self.attribute(&attribute.attr);
                self.emit(Op::Dup, range);
                self.emit(Op::LoadAttr(name), range);
                self.expr(&node.value)?;
                self.emit(op, node.range);
                self.emit(Op::Swap, range);
                self.emit(Op::StoreAttr(name), range);
            }
            Expr::Subscript(subscript) => {
                self.expr(&subscript.value)?;
                self.expr(&subscript.slice)?;
                self.emit(Op::Dup2, range);
                self.emit(Op::LoadSubscr, range);
                self.expr(&node.value)?;
                self.emit(op, node.range);
                self.emit(Op::Rot3, range);
                self.emit(Op::StoreSubscr, range);
            }
            _ => return error(range, "cannot assign to this expression"),
        }
        Ok(())
    }

    pub(super) fn annotated(&mut self, node: &'a ast::StmtAnnAssign) -> Compiled {
        if let Some(value) = &node.value {
            self.expr(value)?;
            self.store(&node.target)?;
        }
        let is_namespace = !self.scopes.get(self.unit.scope).kind.is_function_like();
        match node.target.as_ref() {
            Expr::Name(name) if node.simple && is_namespace => {
                self.expr(&node.annotation)?;
                self.load_name("__annotations__", node.annotation.range());
                let name = self.scopes.mangle(self.unit.scope, &name.id);
                self.constant(crate::python::code::Const::Str(name.into()), node.annotation.range());
                self.emit(Op::StoreSubscr, node.range);
                return Ok(());
            }
            Expr::Attribute(attribute) if node.value.is_none() => self.evaluate(&attribute.value)?,
            Expr::Subscript(subscript) if node.value.is_none() => {
                self.evaluate(&subscript.value)?;
                self.evaluate(&subscript.slice)?;
            }
            _ => {}
        }
        if is_namespace && !node.simple { self.evaluate(&node.annotation) } else { Ok(()) }
    }

    /// Evaluates an expression for its effects.
    fn evaluate(&mut self, expr: &'a Expr) -> Compiled {
        self.expr(expr)?;
        self.emit(Op::Pop, expr.range());
        Ok(())
    }
}
