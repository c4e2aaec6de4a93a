//! `import`.

use super::{Compiled, Compiler, error};
use crate::python::code::Op;
use crate::syntax::ast;

impl<'a> Compiler<'a> {
    pub(super) fn import(&mut self, node: &'a ast::StmtImport) -> Compiled {
        for alias in &node.names {
            let name = self.unit.emitter.name(&alias.name);
            self.emit(Op::Import { name, from: alias.asname.is_some() }, alias.range);
            match &alias.asname {
                Some(name) => self.store_name(name, name.range),
                None => self.store_name(alias.name.split('.').next().unwrap_or_default(), alias.name.range),
            }
        }
        Ok(())
    }

    pub(super) fn import_from(&mut self, node: &'a ast::StmtImportFrom) -> Compiled {
        let module = node.module.as_ref().map_or("", |module| module.as_str());
        if node.level == 0 && module == "__future__" {
            return error(node.range, "'from __future__ import' is not part of PSDL");
        }
        let dots = ".".repeat(usize::try_from(node.level).unwrap_or(1).min(16));
        let name = self.unit.emitter.name(&(dots + module));
        self.emit(Op::Import { name, from: true }, node.range);
        for alias in &node.names {
            if alias.name.as_str() == "*" {
                self.emit(Op::ImportStar, alias.range);
                return Ok(());
            }
            let name = self.unit.emitter.name(&alias.name);
            self.emit(Op::ImportFrom(name), alias.range);
            let bound = alias.asname.as_ref().unwrap_or(&alias.name);
            self.store_name(bound, bound.range);
        }
        self.emit(Op::Pop, node.range);
        Ok(())
    }
}
