//! `def` and `lambda`.

use ruff_text_size::{Ranged, TextRange};

use super::emit::narrow;
use super::{CompileError, Compiled, Compiler, error};
use crate::python::code::{CodeKind, Const, Op, Params};
use crate::syntax::ast::{self, Decorator, Expr, Parameter, Parameters, Stmt};

/// The docstring at the start of a body.
pub(super) fn docstring(body: &[Stmt]) -> Option<Box<str>> {
    match body.first()? {
        Stmt::Expr(node) => node.value.as_string_literal_expr().map(|text| text.value.to_str().into()),
        _ => None,
    }
}

fn params(parameters: &Parameters) -> Params {
    let count = |n: usize| u16::try_from(n).unwrap_or(u16::MAX);
    Params {
        positional: count(parameters.posonlyargs.len() + parameters.args.len()),
        positional_only: count(parameters.posonlyargs.len()),
        keyword_only: count(parameters.kwonlyargs.len()),
        varargs: parameters.vararg.is_some(),
        varkw: parameters.kwarg.is_some(),
    }
}

impl<'a> Compiler<'a> {
    /// `def` or `class` with its header, without the decorators.
    pub(super) fn definition_header(&self, node: TextRange, name: &ast::Identifier, keyword: &str, end: TextRange) -> TextRange {
        let before = self.text.get(node.start().to_usize()..name.start().to_usize()).unwrap_or_default();
        let offset = u32::try_from(before.rfind(keyword).unwrap_or(0)).unwrap_or(0);
        TextRange::new(node.start() + ruff_text_size::TextSize::new(offset), end.end().max(name.end()))
    }

    pub(super) fn decorators(&mut self, decorators: &'a [Decorator]) -> Compiled {
        for decorator in decorators {
            self.unit.emitter.mark(decorator.range);
            self.expr(&decorator.expression)?;
        }
        Ok(())
    }

    pub(super) fn decorate(&mut self, decorators: &'a [Decorator]) {
        for decorator in decorators.iter().rev() {
            self.emit(Op::Call(1), decorator.expression.range());
        }
    }

    pub(super) fn function(&mut self, node: &'a ast::StmtFunctionDef) -> Compiled {
        if node.is_async {
            return error(node.name.range, "'async def' is not part of PSDL");
        }
        if let Some(parameters) = &node.type_params {
            return error(parameters.range, "type parameters are not part of PSDL");
        }
        self.decorators(&node.decorator_list)?;
        let end = node.returns.as_ref().map_or(node.parameters.range, |returns| returns.range());
        let header = self.definition_header(node.range, &node.name, "def", end);
        self.unit.emitter.mark(header);
        let mut flags = self.defaults(&node.parameters, header)?;
        if self.annotations(&node.parameters, node.returns.as_deref(), header)? {
            flags |= 4;
        }
        let outer = self.open(node.range, CodeKind::Function)?;
        self.unit.params = params(&node.parameters);
        self.unit.doc = docstring(&node.body);
        self.body(&node.body)?;
        let last = node.body.last().map_or(header, Ranged::range);
        self.constant(Const::None, last);
        self.emit(Op::Return, last);
        self.close(outer, flags, header);
        self.decorate(&node.decorator_list);
        self.store_name(&node.name, node.name.range);
        Ok(())
    }

    pub(super) fn lambda(&mut self, node: &'a ast::ExprLambda) -> Compiled {
        let flags = match &node.parameters {
            Some(parameters) => self.defaults(parameters, node.range)?,
            None => 0,
        };
        let outer = self.open(node.range, CodeKind::Lambda)?;
        self.unit.params = node.parameters.as_deref().map(params).unwrap_or_default();
        self.unit.emitter.mark(node.range);
        self.expr(&node.body)?;
        self.emit(Op::Return, node.body.range());
        self.close(outer, flags, node.range);
        Ok(())
    }

    /// Evaluates default values; returns the flags of `MakeFunction`.
    fn defaults(&mut self, parameters: &'a Parameters, range: TextRange) -> Result<u8, CompileError> {
        let mut flags = 0;
        let positional = parameters.posonlyargs.iter().chain(&parameters.args).filter_map(|parameter| parameter.default.as_deref());
        let mut count = 0;
        for default in positional {
            self.expr(default)?;
            count += 1;
        }
        if count > 0 {
            self.emit(Op::BuildTuple(count), range);
            flags |= 1;
        }
        let mut count = 0;
        for parameter in &parameters.kwonlyargs {
            if let Some(default) = &parameter.default {
                self.mangled_constant(parameter.name(), parameter.range);
                self.expr(default)?;
                count += 1;
            }
        }
        if count > 0 {
            self.emit(Op::BuildDict(count), range);
            flags |= 2;
        }
        Ok(flags)
    }

    fn mangled_constant(&mut self, name: &str, range: TextRange) {
        let name = self.scopes.mangle(self.unit.scope, name);
        self.constant(Const::Str(name.into()), range);
    }

    /// Evaluates annotations; tells whether there are any.
    fn annotations(&mut self, parameters: &'a Parameters, returns: Option<&'a Expr>, range: TextRange) -> Result<bool, CompileError> {
        let plain = |list: &'a [ast::ParameterWithDefault]| list.iter().map(|parameter| &parameter.parameter);
        let in_order = plain(&parameters.args)
            .chain(plain(&parameters.posonlyargs))
            .chain(parameters.vararg.as_deref())
            .chain(plain(&parameters.kwonlyargs))
            .chain(parameters.kwarg.as_deref());
        let mut count = 0_usize;
        let named = |parameter: &'a Parameter| parameter.annotation.as_deref().map(|annotation| (parameter.name.as_str(), annotation));
        for (name, annotation) in in_order.filter_map(named).chain(returns.map(|returns| ("return", returns))) {
            self.mangled_constant(name, annotation.range());
            match annotation {
                Expr::Starred(starred) => {
                    self.expr(&starred.value)?;
                    self.emit(Op::Unpack(1), starred.range);
                }
                annotation => self.expr(annotation)?,
            }
            count += 1;
        }
        if count > 0 {
            self.emit(Op::BuildDict(narrow(count)), range);
        }
        Ok(count > 0)
    }
}
