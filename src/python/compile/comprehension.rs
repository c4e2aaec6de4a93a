//! Comprehensions and generator expressions: functions of one parameter, the iterator over the outermost iterable.

use ruff_text_size::{Ranged, TextRange};

use super::blocks::LoopPiece;
use super::{Compiled, Compiler, RED_ZONE, STACK_PIECE, error};
use crate::python::code::{CodeKind, Const, Op, Params};
use crate::syntax::ast::{self, Expr};

/// What becomes of each element.
#[derive(Clone, Copy)]
enum Element<'a> {
    List(&'a Expr),
    Set(&'a Expr),
    Dict(&'a Expr, &'a Expr),
    /// `{**mapping for …}`
    Mapping(&'a Expr),
    Yield(&'a Expr),
}

impl<'a> Compiler<'a> {
    pub(super) fn comprehension(&mut self, expr: &'a Expr) -> Compiled {
        match expr {
            Expr::ListComp(node) => self.comprehend(node.range, &node.generators, Element::List(&node.elt)),
            Expr::SetComp(node) => self.comprehend(node.range, &node.generators, Element::Set(&node.elt)),
            Expr::DictComp(node) => {
                let element = node.key.as_ref().map_or(Element::Mapping(&node.value), |key| Element::Dict(key, &node.value));
                self.comprehend(node.range, &node.generators, element)
            }
            Expr::Generator(node) => self.comprehend(node.range, &node.generators, Element::Yield(&node.elt)),
            _ => Ok(()),
        }
    }

    fn comprehend(&mut self, range: TextRange, generators: &'a [ast::Comprehension], element: Element<'a>) -> Compiled {
        let Some(first) = generators.first() else { return error(range, "invalid syntax") };
        let outer = self.open(range, CodeKind::Comprehension)?;
        self.unit.params = Params { positional: 1, positional_only: 1, ..Params::default() };
        self.unit.emitter.mark(range);
        match element {
            Element::List(_) => self.emit(Op::BuildList(0), range),
            Element::Set(_) => self.emit(Op::BuildSet(0), range),
            Element::Dict(..) | Element::Mapping(_) => self.emit(Op::BuildDict(0), range),
            Element::Yield(_) => {}
        }
        self.generators(range, generators, 0, element)?;
        if matches!(element, Element::Yield(_)) {
            self.constant(Const::None, range);
        }
        self.emit(Op::Return, range);
        self.close(outer, 0, range);
        self.expr(&first.iter)?;
        self.emit(Op::GetIter, first.iter.range());
        self.emit(Op::Call(1), range);
        Ok(())
    }

    /// The loops from the `at`-th on.
    fn generators(&mut self, range: TextRange, generators: &'a [ast::Comprehension], at: usize, element: Element<'a>) -> Compiled {
        let Some(generator) = generators.get(at) else { return self.element(generators.len(), element, range) };
        if generator.is_async {
            return error(generator.range, "'async for' is not part of PSDL");
        }
        let (next, more, done) = (self.label(), self.label(), self.label());
        let depth = self.unit.emitter.depth();
        let iter = generator.iter.range();
        if at == 0 {
            self.emit(Op::LoadFast(0), iter);
            self.constant(Const::Int(0), iter);
        } else {
            self.expr(&generator.iter)?;
            self.emit(Op::StartLoop, iter);
        }
        self.bind(next);
        let variable = self.loop_variable(&generator.target);
        let piece = LoopPiece { start: self.unit.emitter.here(), depth, range: generator.range, variable };
        self.jump(Op::ForIter, done, iter);
        self.store(&generator.target)?;
        for test in &generator.ifs {
            self.jump_if(test, false, more)?;
        }
        stacker::maybe_grow(RED_ZONE, STACK_PIECE, || self.generators(range, generators, at + 1, element))?;
        self.bind(more);
        self.jump(Op::JumpBack, next, generator.range);
        let end = self.unit.emitter.here();
        self.unit.emitter.add_loop(piece.until(end));
        self.bind(done);
        Ok(())
    }

    /// The innermost part; the container stands below `loops` pairs of iterator and counter.
    fn element(&mut self, loops: usize, element: Element<'a>, range: TextRange) -> Compiled {
        let Ok(below) = u16::try_from(loops * 2) else { return error(range, "too many loops in one comprehension") };
        match element {
            Element::List(Expr::Starred(node)) => self.merge(below, &node.value, Op::ListExtend)?,
            Element::Set(Expr::Starred(node)) => self.merge(below, &node.value, Op::SetUpdate)?,
            Element::Mapping(value) => self.merge(below, value, Op::DictUpdate)?,
            Element::Yield(Expr::Starred(node)) => self.yield_each(&node.value)?,
            Element::List(value) => {
                self.expr(value)?;
                self.emit(Op::ListAppend(below), value.range());
            }
            Element::Set(value) => {
                self.expr(value)?;
                self.emit(Op::SetAdd(below), value.range());
            }
            Element::Dict(key, value) => {
                self.expr(key)?;
                self.expr(value)?;
                self.emit(Op::DictAdd(below), key.range().cover(value.range()));
            }
            Element::Yield(value) => {
                self.expr(value)?;
                self.emit(Op::Yield, value.range());
                self.emit(Op::Pop, value.range());
            }
        }
        Ok(())
    }

    /// `[*items for …]`
    fn merge(&mut self, below: u16, value: &'a Expr, op: Op) -> Compiled {
        self.emit(Op::Copy(below), value.range());
        self.expr(value)?;
        self.emit(op, value.range());
        self.emit(Op::Pop, value.range());
        Ok(())
    }

    /// `(*items for …)`
    fn yield_each(&mut self, value: &'a Expr) -> Compiled {
        let (next, done) = (self.label(), self.label());
        self.expr(value)?;
        self.emit(Op::StartLoop, value.range());
        self.bind(next);
        self.jump(Op::ForIter, done, value.range());
        self.emit(Op::Yield, value.range());
        self.emit(Op::Pop, value.range());
        self.jump(Op::JumpBack, next, value.range());
        self.bind(done);
        Ok(())
    }
}
