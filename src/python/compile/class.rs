//! `class`.

use ruff_text_size::{Ranged, TextRange};

use super::function::docstring;
use super::stmt::has_annotations;
use super::{Compiled, Compiler, error};
use crate::python::code::{CodeKind, Const, Op};
use crate::syntax::ast;

impl<'a> Compiler<'a> {
    pub(super) fn class(&mut self, node: &'a ast::StmtClassDef) -> Compiled {
        if let Some(parameters) = &node.type_params {
            return error(parameters.range, "type parameters are not part of PSDL");
        }
        self.decorators(&node.decorator_list)?;
        let end = node.arguments.as_ref().map_or(node.name.range, |arguments| arguments.range);
        let header = self.definition_header(node.range, &node.name, "class", end);
        self.unit.emitter.mark(header);
        self.emit(Op::BuildClass, header);
        let outer = self.open(node.range, CodeKind::Class)?;
        self.class_body(node, header)?;
        self.close(outer, 0, header);
        self.constant(Const::Str(node.name.as_str().into()), header);
        match &node.arguments {
            Some(arguments) => self.arguments(2, arguments, header)?,
            None => self.emit(Op::Call(2), header),
        }
        self.decorate(&node.decorator_list);
        self.store_name(&node.name, node.name.range);
        Ok(())
    }

    fn store_in_namespace(&mut self, name: &str, range: TextRange) {
        let name = self.unit.emitter.name(name);
        self.emit(Op::StoreName(name), range);
    }

    fn class_body(&mut self, node: &'a ast::StmtClassDef, header: TextRange) -> Compiled {
        self.unit.emitter.mark(header);
        let module = self.global("__name__");
        self.emit(Op::LoadGlobal(module), header);
        self.store_in_namespace("__module__", header);
        let qualname = self.scopes.qualified_name(self.unit.scope);
        self.constant(Const::Str(qualname.into()), header);
        self.store_in_namespace("__qualname__", header);
        if has_annotations(&node.body) {
            self.emit(Op::BuildDict(0), header);
            self.store_in_namespace("__annotations__", header);
        }
        if let Some(doc) = docstring(&node.body) {
            self.unit.doc = Some(doc.clone());
            self.constant(Const::Str(doc), header);
            self.store_in_namespace("__doc__", header);
        }
        self.body(&node.body)?;
        let last = node.body.last().map_or(header, Ranged::range);
        let cells = &self.scopes.get(self.unit.scope).cells;
        if let Some(cell) = cells.iter().position(|cell| cell.name == "__class__") {
            self.emit(Op::LoadClosure(u16::try_from(cell).unwrap_or(u16::MAX)), last);
            self.store_in_namespace("__classcell__", last);
        }
        self.constant(Const::None, last);
        self.emit(Op::Return, last);
        Ok(())
    }
}
