//! From what each scope does with a name to where the variable lives: frames, cells and closures.

use rustc_hash::{FxHashMap, FxHashSet};

use super::{Resolver, SyntaxError, Uses};
use crate::syntax::scope::{Capture, Cell, Free, GlobalId, NameId, NameKind, ScopeId, ScopeKind};

/// Which variables are closed over, and by whom.
#[derive(Default)]
struct Captures {
    /// Variables (owner and name) that need a cell.
    owners: FxHashSet<(ScopeId, NameId)>,
    /// What each scope takes from outside, in order, and where each stands in that order.
    frees: FxHashMap<ScopeId, Vec<NameId>>,
    free_index: FxHashMap<(ScopeId, NameId), u32>,
}

impl Resolver<'_> {
    /// Decides every name; the errors are `nonlocal` declarations without a variable.
    pub(super) fn lay_out(&mut self) -> Vec<SyntaxError> {
        let mut errors = Vec::new();
        let mut captures = Captures::default();
        for at in 0..self.entries.len() {
            self.capture(at, &mut captures, &mut errors);
        }
        let cells = self.place_own(&captures);
        self.place_frees(&captures, &cells);
        errors
    }

    /// The enclosing function scope that holds a name for an inner scope.
    fn owner(&self, scope: ScopeId, name: NameId) -> Option<ScopeId> {
        let class_cell = self.scopes.names[name.0 as usize] == "__class__";
        let mut at = self.scopes.get(scope).parent?;
        loop {
            let outer = self.scopes.get(at);
            match outer.kind {
                ScopeKind::Module => return None,
                ScopeKind::Class if class_cell => return Some(at),
                ScopeKind::Class => {}
                _ => match self.entry_of.get(&(at, name)).map(|i| self.entries[*i as usize].uses) {
                    Some(uses) if uses.has(Uses::GLOBAL) => return None,
                    Some(uses) if uses.is_own() => return Some(at),
                    _ => {}
                },
            }
            at = outer.parent?;
        }
    }

    /// Gives an entry that is not its scope's own its kind, and notes the closures on the way.
    fn capture(&mut self, at: usize, captures: &mut Captures, errors: &mut Vec<SyntaxError>) {
        let (scope, name, uses, declared) = {
            let entry = &self.entries[at];
            (entry.scope, entry.name, entry.uses, entry.declared)
        };
        if scope == ScopeId::MODULE || uses.has(Uses::GLOBAL) || uses.is_own() {
            return;
        }
        let Some(owner) = self.owner(scope, name) else {
            if let Some(range) = declared {
                let name = &self.scopes.names[name.0 as usize];
                errors.push(SyntaxError::new(range, format!("no binding for nonlocal '{name}' found")));
            }
            return;
        };
        captures.owners.insert((owner, name));
        let mut inner = scope;
        while inner != owner {
            let frees = captures.frees.entry(inner).or_default();
            let next = u32::try_from(frees.len()).unwrap_or(u32::MAX);
            if *captures.free_index.entry((inner, name)).or_insert(next) == next {
                frees.push(name);
            }
            inner = self.scopes.get(inner).parent.unwrap_or(owner);
        }
    }

    fn global_id(&mut self, name: NameId) -> GlobalId {
        let next = GlobalId(u32::try_from(self.scopes.globals.len()).unwrap_or(u32::MAX));
        let id = *self.scopes.global_ids.entry(name).or_insert(next);
        if id == next {
            self.scopes.globals.push(name);
        }
        id
    }

    /// Fills the scopes' locals and cells and says what every entry means. Returns where the cells are.
    fn place_own(&mut self, captures: &Captures) -> FxHashMap<(ScopeId, NameId), u32> {
        let mut cells = FxHashMap::default();
        for (owner, name) in &captures.owners {
            if self.scopes.get(*owner).kind == ScopeKind::Class {
                self.add_cell(&mut cells, *owner, *name, None);
            }
        }
        for at in 0..self.entries.len() {
            let (scope, name, uses) = (self.entries[at].scope, self.entries[at].name, self.entries[at].uses);
            let kind = self.scopes.get(scope).kind;
            let captured = captures.owners.contains(&(scope, name));
            let free = captures.free_index.get(&(scope, name));
            let meaning = if kind != ScopeKind::Module && uses.has(Uses::GLOBAL) {
                NameKind::GlobalExplicit(self.global_id(name))
            } else if kind == ScopeKind::Module {
                NameKind::GlobalImplicit(self.global_id(name))
            } else if uses.is_own() && kind == ScopeKind::Class {
                NameKind::Class(self.global_id(name))
            } else if uses.is_own() {
                let parameter = uses.has(Uses::PARAMETER);
                let slot = (parameter || !captured).then(|| self.add_local(scope, name, parameter));
                match slot {
                    Some(slot) if !captured => NameKind::Local(slot),
                    _ => NameKind::Cell(self.add_cell(&mut cells, scope, name, slot)),
                }
            } else if let Some(free) = free {
                NameKind::Free(*free)
            } else if uses == Uses::IMPLICIT {
                continue;
            } else if kind == ScopeKind::Class {
                NameKind::Class(self.global_id(name))
            } else {
                NameKind::GlobalImplicit(self.global_id(name))
            };
            self.scopes.kinds.insert((scope, name), meaning);
        }
        cells
    }

    fn add_local(&mut self, scope: ScopeId, name: NameId, parameter: bool) -> u32 {
        let text = self.scopes.names[name.0 as usize].clone();
        let scope = &mut self.scopes.scopes[scope.0 as usize];
        scope.locals.push(text);
        scope.parameter_count += u32::from(parameter);
        u32::try_from(scope.locals.len() - 1).unwrap_or(u32::MAX)
    }

    fn add_cell(&mut self, cells: &mut FxHashMap<(ScopeId, NameId), u32>, scope: ScopeId, name: NameId, parameter: Option<u32>) -> u32 {
        let text = self.scopes.names[name.0 as usize].clone();
        let list = &mut self.scopes.scopes[scope.0 as usize].cells;
        list.push(Cell { name: text, parameter });
        let at = u32::try_from(list.len() - 1).unwrap_or(u32::MAX);
        cells.insert((scope, name), at);
        at
    }

    /// Tells each closure where the scope around it has what it takes.
    fn place_frees(&mut self, captures: &Captures, cells: &FxHashMap<(ScopeId, NameId), u32>) {
        for at in 0..self.scopes.scopes.len() {
            let scope = ScopeId(u32::try_from(at).unwrap_or(u32::MAX));
            let (Some(names), Some(parent)) = (captures.frees.get(&scope), self.scopes.scopes[at].parent) else { continue };
            let from = |name: NameId| match cells.get(&(parent, name)) {
                Some(cell) => Some(Capture::Cell(*cell)),
                None => captures.free_index.get(&(parent, name)).map(|free| Capture::Free(*free)),
            };
            let frees = names.iter().filter_map(|name| Some(Free { name: self.scopes.names[name.0 as usize].clone(), from: from(*name)? }));
            self.scopes.scopes[at].frees = frees.collect();
        }
    }
}
