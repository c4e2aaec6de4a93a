//! Literals, and what is folded: a sign before a number, tuples of constants.

use num_bigint::BigInt;
use num_traits::{Num, ToPrimitive};
use ruff_text_size::{Ranged, TextRange};

use super::{CompileError, Compiler, error};
use crate::python::code::{Const, ConstantId};
use crate::syntax::ast::{self, Expr};

fn integer(value: &ast::Int) -> Option<BigInt> {
    if let Some(small) = value.as_u64() {
        return Some(small.into());
    }
    let text: String = value.to_string().chars().filter(|c| *c != '_').collect();
    let (digits, radix) = match text.get(..2) {
        Some("0x" | "0X") => (&text[2..], 16),
        Some("0o" | "0O") => (&text[2..], 8),
        Some("0b" | "0B") => (&text[2..], 2),
        _ => (&text[..], 10),
    };
    BigInt::from_str_radix(digits, radix).ok()
}

impl Compiler<'_> {
    fn tunable(&self, range: TextRange) -> Option<ConstantId> {
        let id = self.tuning.constant_at(range)?;
        self.tuning.constant(id)?.excluded.is_none().then_some(id)
    }

    /// A number, with a minus before it where `negative`; `range` is that of the whole.
    pub(super) fn number(&self, node: &ast::ExprNumberLiteral, negative: bool, range: TextRange) -> Result<Const, CompileError> {
        let sign = |value: f64| if negative { -value } else { value };
        Ok(match &node.value {
            ast::Number::Int(value) => {
                let Some(value) = integer(value) else { return error(range, "invalid integer literal") };
                let value = if negative { -value } else { value };
                value.to_i64().map_or_else(|| Const::Big(value), Const::Int)
            }
            ast::Number::Float(value) => Const::Float(sign(*value), self.tunable(range)),
            ast::Number::Complex { real, imag } => Const::Complex(sign(*real), sign(*imag)),
        })
    }

    /// `-0.5` and `+0.5`: one literal with its sign, unless only the number itself is tunable.
    pub(super) fn signed(&self, node: &ast::ExprUnaryOp) -> Result<Option<Const>, CompileError> {
        let (Expr::NumberLiteral(number), ast::UnaryOp::USub | ast::UnaryOp::UAdd) = (node.operand.as_ref(), node.op) else {
            return Ok(None);
        };
        if self.tunable(number.range).is_some() {
            return Ok(None);
        }
        self.number(number, node.op == ast::UnaryOp::USub, node.range).map(Some)
    }

    /// The value of an expression that is a constant without tunable parts.
    pub(super) fn constant_of(&self, expr: &Expr) -> Option<Const> {
        if self.tuning.direction_at(expr.range()).is_some() {
            return None;
        }
        let value = match expr {
            Expr::NumberLiteral(node) => self.number(node, false, node.range).ok()?,
            Expr::UnaryOp(node) => self.signed(node).ok()??,
            Expr::StringLiteral(node) => Const::Str(node.value.to_str().into()),
            Expr::BytesLiteral(node) => Const::Bytes(node.value.bytes().collect()),
            Expr::BooleanLiteral(node) => Const::Bool(node.value),
            Expr::NoneLiteral(_) => Const::None,
            Expr::EllipsisLiteral(_) => Const::Ellipsis,
            Expr::Tuple(node) => Const::Tuple(self.constants_of(&node.elts)?),
            _ => return None,
        };
        (!matches!(value, Const::Float(_, Some(_)))).then_some(value)
    }

    /// The values of expressions that are all constants without tunable parts.
    pub(super) fn constants_of(&self, items: &[Expr]) -> Option<Vec<Const>> {
        items.iter().map(|item| self.constant_of(item)).collect()
    }
}
