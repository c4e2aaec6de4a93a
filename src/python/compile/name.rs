//! Variables: from a name to the instruction that reads, binds or deletes it.

use ruff_text_size::TextRange;

use super::emit::narrow;
use super::{CodeKind, Compiler};
use crate::python::code::{Op, Slot};
use crate::syntax::NameKind;
use crate::syntax::scope::Capture;

/// Where a variable lives, as seen from the code under construction. Cells count from the first cell.
enum Place {
    Fast(u16),
    Deref(u16),
    Global(u32),
    /// In the namespace of the class body, else the global.
    Namespace,
}

/// Scopes with more variables than fit were refused when they were opened.
fn slot(n: usize) -> u16 {
    u16::try_from(n).unwrap_or(u16::MAX)
}

impl Compiler<'_> {
    /// The slot of a global variable.
    pub(super) fn global(&mut self, name: &str) -> u32 {
        if let Some(at) = self.global_index.get(name) {
            return *at;
        }
        let at = narrow(self.globals.len());
        self.globals.push(name.into());
        self.global_index.insert(name.into(), at);
        at
    }

    /// The slot of a variable that an inner function captures, counted from the first cell.
    pub(super) fn captured_slot(&self, capture: Capture) -> u16 {
        match capture {
            Capture::Cell(cell) => slot(cell as usize),
            Capture::Free(free) => slot(self.scopes.get(self.unit.scope).cells.len() + free as usize),
        }
    }

    fn place(&mut self, name: &str) -> Place {
        match self.scopes.lookup(self.unit.scope, name) {
            Some(NameKind::Local(local)) => Place::Fast(slot(local as usize)),
            Some(NameKind::Cell(cell)) => Place::Deref(self.captured_slot(Capture::Cell(cell))),
            Some(NameKind::Free(free)) => Place::Deref(self.captured_slot(Capture::Free(free))),
            Some(NameKind::GlobalExplicit(global) | NameKind::GlobalImplicit(global)) => Place::Global(global.0),
            Some(NameKind::Class(_)) => Place::Namespace,
            None if self.unit.kind == CodeKind::Class => Place::Namespace,
            None => Place::Global(self.global(name)),
        }
    }

    /// A name of the class body's namespace, an attribute or a keyword, as Python stores it.
    pub(super) fn attribute(&mut self, name: &str) -> u32 {
        let mangled = self.scopes.mangle(self.unit.scope, name);
        self.unit.emitter.name(&mangled)
    }

    pub(super) fn load_name(&mut self, name: &str, range: TextRange) {
        if name == "__debug__" {
            return self.constant(super::Const::Bool(true), range);
        }
        let op = match self.place(name) {
            Place::Fast(slot) => Op::LoadFast(slot),
            Place::Deref(slot) if self.unit.kind == CodeKind::Class => Op::LoadClassDeref { slot, name: self.attribute(name) },
            Place::Deref(slot) => Op::LoadDeref(slot),
            Place::Global(slot) => Op::LoadGlobal(slot),
            Place::Namespace => Op::LoadName(self.attribute(name)),
        };
        self.emit(op, range);
    }

    pub(super) fn store_name(&mut self, name: &str, range: TextRange) {
        let op = match self.place(name) {
            Place::Fast(slot) => Op::StoreFast(slot),
            Place::Deref(slot) => Op::StoreDeref(slot),
            Place::Global(slot) => Op::StoreGlobal(slot),
            Place::Namespace => Op::StoreName(self.attribute(name)),
        };
        self.emit(op, range);
    }

    pub(super) fn delete_name(&mut self, name: &str, range: TextRange) {
        let op = match self.place(name) {
            Place::Fast(slot) => Op::DeleteFast(slot),
            Place::Deref(slot) => Op::DeleteDeref(slot),
            Place::Global(slot) => Op::DeleteGlobal(slot),
            Place::Namespace => Op::DeleteName(self.attribute(name)),
        };
        self.emit(op, range);
    }

    /// The slot of a loop variable; a class body has none.
    pub(super) fn variable(&mut self, name: &str) -> Option<(Box<str>, Slot)> {
        let slot = match self.place(name) {
            Place::Fast(slot) => Slot::Fast(slot),
            Place::Deref(slot) => Slot::Deref(slot),
            Place::Global(slot) => Slot::Global(slot),
            Place::Namespace => return None,
        };
        Some((name.into(), slot))
    }
}
