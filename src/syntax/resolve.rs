//! One walk over the tree: opens the scopes, notes what each name does in them, and reports what
//! CPython's compiler would refuse. `layout` then decides what each name means.

use ruff_python_ast::name::Name;
use ruff_python_ast::visitor::Visitor;
use ruff_python_ast::{self as ast, Expr, Identifier, Stmt};
use ruff_python_parser::semantic_errors::SemanticSyntaxChecker;
use ruff_text_size::{Ranged, TextRange, TextSize};
use rustc_hash::FxHashMap;

use super::checks::{Checks, Place};
use super::error::SyntaxError;
use super::scope::{NameId, Occurrence, Role, Scope, ScopeId, ScopeKind, Scopes, mangled};

mod definitions;
mod layout;
mod walk;

/// More decimal digits than CPython reads into an integer.
const MAX_INT_DIGITS: usize = 4300;
/// More type parameters than anyone writes; the checker compares each with each.
const MAX_TYPE_PARAMS: usize = 255;

/// What a scope does with a name.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
struct Uses(u8);

impl Uses {
    const PARAMETER: Uses = Uses(1);
    const BOUND: Uses = Uses(2);
    const READ: Uses = Uses(4);
    const GLOBAL: Uses = Uses(8);
    const NONLOCAL: Uses = Uses(16);
    const ANNOTATED: Uses = Uses(32);
    /// Only because `super` was mentioned.
    const IMPLICIT: Uses = Uses(64);

    fn has(self, other: Uses) -> bool {
        self.0 & other.0 != 0
    }
    fn add(&mut self, other: Uses) {
        self.0 |= other.0;
    }
    /// The scope itself holds the variable.
    fn is_own(self) -> bool {
        (self.has(Uses::PARAMETER) || self.has(Uses::BOUND)) && !self.has(Uses::GLOBAL) && !self.has(Uses::NONLOCAL)
    }
}

/// A name in a scope.
struct Entry {
    scope: ScopeId,
    name: NameId,
    uses: Uses,
    /// Where it was declared `nonlocal`.
    declared: Option<TextRange>,
}

struct Resolver<'a> {
    scopes: Scopes,
    entries: Vec<Entry>,
    entry_of: FxHashMap<(ScopeId, NameId), u32>,
    current: ScopeId,
    checker: SemanticSyntaxChecker,
    checks: Checks<'a>,
}

/// Resolves every name of the statements, and reports what the compiler would refuse.
pub(super) fn resolve(body: &[Stmt], range: TextRange, source: &str) -> (Scopes, Vec<SyntaxError>) {
    let mut resolver = Resolver {
        scopes: Scopes::default(),
        entries: Vec::with_capacity(64),
        entry_of: FxHashMap::default(),
        current: ScopeId::MODULE,
        checker: SemanticSyntaxChecker::new(),
        checks: Checks::new(source),
    };
    // About what programs have: a name every ten bytes, a new one every eighty.
    resolver.scopes.occurrences.reserve(source.len() / 10);
    resolver.scopes.names.reserve(source.len() / 80);
    resolver.scopes.name_ids.reserve(source.len() / 80);
    resolver.entry_of.reserve(source.len() / 60);
    resolver.push_scope(ScopeKind::Module, range, Name::new_static("<module>"), None);
    resolver.visit_body(body);
    resolver.scopes.kinds.reserve(resolver.entries.len());
    let errors = resolver.lay_out();
    (resolver.scopes, [resolver.checks.errors.into_inner(), errors].concat())
}

/// What [`Resolver::open`] changed, to be handed to [`Resolver::close`].
struct Outer {
    scope: ScopeId,
    place: Place,
}

impl<'a> Resolver<'a> {
    fn push_scope(&mut self, kind: ScopeKind, range: TextRange, name: Name, parent: Option<ScopeId>) -> ScopeId {
        let id = ScopeId(u32::try_from(self.scopes.scopes.len()).unwrap_or(u32::MAX));
        let private = match kind {
            ScopeKind::Class => Some(name.trim_start_matches('_')).filter(|class| !class.is_empty()).map(Name::new),
            _ => parent.and_then(|parent| self.scopes.get(parent).private.clone()),
        };
        self.scopes.scopes.push(Scope {
            kind,
            parent,
            range,
            name,
            parameter_count: 0,
            locals: Vec::new(),
            cells: Vec::new(),
            frees: Vec::new(),
            is_generator: kind == ScopeKind::Generator,
            private,
        });
        id
    }

    fn open(&mut self, kind: ScopeKind, range: TextRange, name: Name) -> Outer {
        let outer = Outer { scope: self.current, place: self.checks.place };
        self.current = self.push_scope(kind, range, name, Some(outer.scope));
        self.scopes.nodes.insert(range, self.current);
        self.checks.place = outer.place.inside(kind);
        outer
    }

    fn close(&mut self, outer: Outer) {
        self.current = outer.scope;
        self.checks.place = outer.place;
    }

    fn intern(&mut self, name: &Name) -> NameId {
        let private = self.scopes.scopes[self.current.0 as usize].private.as_ref();
        let owned;
        let name = if private.is_some() && name.starts_with("__") {
            owned = Name::new(mangled(private, name));
            &owned
        } else {
            name
        };
        if let Some(id) = self.scopes.name_ids.get(name) {
            return *id;
        }
        let id = NameId(u32::try_from(self.scopes.names.len()).unwrap_or(u32::MAX));
        self.scopes.names.push(name.clone());
        self.scopes.name_ids.insert(name.clone(), id);
        id
    }

    fn entry(&mut self, scope: ScopeId, name: NameId) -> &mut Entry {
        let next = u32::try_from(self.entries.len()).unwrap_or(u32::MAX);
        let at = *self.entry_of.entry((scope, name)).or_insert(next);
        if at == next {
            self.entries.push(Entry { scope, name, uses: Uses::default(), declared: None });
        }
        &mut self.entries[at as usize]
    }

    /// Notes an occurrence of a name in the current scope.
    fn note(&mut self, name: &Name, range: TextRange, role: Role, uses: Uses) {
        let name = self.intern(name);
        let scope = self.current;
        self.entry(scope, name).uses.add(uses);
        self.scopes.occurrences.push(Occurrence { range, scope, name, role });
    }

    fn bind(&mut self, name: &Identifier) {
        self.note(&name.id, name.range, Role::Bind, Uses::BOUND);
    }

    fn report(&mut self, range: TextRange, message: String) {
        self.checks.report(SyntaxError::new(range, message));
    }

    fn left_out(&mut self, range: TextRange, what: &str) {
        self.checks.report(SyntaxError::left_out(range, what));
    }

    /// The keyword at the start of a node, for errors that are about the keyword.
    fn keyword(range: TextRange, keyword: &str) -> TextRange {
        TextRange::at(range.start(), TextSize::of(keyword).min(range.len()))
    }

    fn declare(&mut self, names: &[Identifier], uses: Uses, word: &str) {
        for name in names {
            let id = self.intern(&name.id);
            let scope = self.current;
            let before = self.entry(scope, id).uses;
            let both = if uses == Uses::GLOBAL { Uses::NONLOCAL } else { Uses::GLOBAL };
            if before.has(Uses::PARAMETER) {
                self.report(name.range, format!("name '{}' is parameter and {word}", name.id));
            } else if before.has(both) {
                self.report(name.range, format!("name '{}' is nonlocal and global", name.id));
            } else if before.has(Uses::READ) {
                self.report(name.range, format!("name '{}' is used prior to {word} declaration", name.id));
            } else if before.has(Uses::ANNOTATED) {
                self.report(name.range, format!("annotated name '{}' can't be {word}", name.id));
            } else if before.has(Uses::BOUND) {
                self.report(name.range, format!("name '{}' is assigned to before {word} declaration", name.id));
            }
            self.note(&name.id, name.range, Role::Declare, uses);
            if uses == Uses::NONLOCAL {
                self.entry(scope, id).declared = Some(name.range);
            }
        }
    }

    /// `name := value`: binds in the function around the comprehensions, not in them.
    fn walrus(&mut self, node: &'a ast::ExprNamed) {
        self.visit_expr(&node.value);
        let Expr::Name(target) = node.target.as_ref() else {
            self.visit_expr(&node.target);
            return;
        };
        if !self.checks.place.kind.is_comprehension() {
            self.visit_expr(&node.target);
            return;
        }
        let mut owner = self.current;
        while self.scopes.get(owner).kind.is_comprehension() {
            owner = self.scopes.get(owner).parent.unwrap_or(ScopeId::MODULE);
        }
        let name = self.intern(&target.id);
        let entry = self.entry(owner, name);
        entry.uses.add(Uses::BOUND);
        let is_global = owner == ScopeId::MODULE || entry.uses.has(Uses::GLOBAL);
        self.note(&target.id, target.range, Role::Bind, if is_global { Uses::GLOBAL } else { Uses::NONLOCAL });
    }

    fn yields(&mut self, range: TextRange) {
        let scope = self.current.0 as usize;
        let place = match self.checks.place.kind {
            ScopeKind::Function | ScopeKind::Lambda => {
                self.scopes.scopes[scope].is_generator = true;
                return;
            }
            ScopeKind::Module | ScopeKind::Class => "outside function",
            ScopeKind::ListComp => "inside list comprehension",
            ScopeKind::SetComp => "inside set comprehension",
            ScopeKind::DictComp => "inside dict comprehension",
            ScopeKind::Generator => "inside generator expression",
        };
        self.report(range, format!("'yield' {place}"));
    }

    fn looped(&mut self, body: &'a [Stmt], orelse: &'a [Stmt]) {
        let before = self.checks.place;
        self.checks.place = before.looped();
        self.visit_body(body);
        self.checks.place = before;
        self.visit_body(orelse);
    }

    fn annotated(&mut self, node: &'a ast::StmtAnnAssign) {
        if let Some(value) = &node.value {
            self.visit_expr(value);
        }
        self.visit_expr(&node.annotation);
        let Expr::Name(target) = node.target.as_ref() else {
            self.visit_expr(&node.target);
            return;
        };
        if !node.simple {
            if node.value.is_some() {
                self.visit_expr(&node.target);
            }
            return;
        }
        let name = self.intern(&target.id);
        let scope = self.current;
        let before = self.entry(scope, name).uses;
        if scope != ScopeId::MODULE && (before.has(Uses::GLOBAL) || before.has(Uses::NONLOCAL)) {
            let word = if before.has(Uses::GLOBAL) { "global" } else { "nonlocal" };
            self.report(target.range, format!("annotated name '{}' can't be {word}", target.id));
        }
        self.note(&target.id, target.range, Role::Bind, Uses::BOUND);
        self.entry(scope, name).uses.add(Uses::ANNOTATED);
    }

    fn import(&mut self, names: &[ast::Alias], from: bool) {
        for alias in names {
            match &alias.asname {
                Some(name) => self.bind(name),
                None if from && alias.name.id == "*" => {}
                None if from => self.bind(&alias.name),
                None => {
                    let first = alias.name.id.split('.').next().unwrap_or_default();
                    let range = TextRange::at(alias.name.start(), TextSize::of(first).min(alias.name.range.len()));
                    self.note(&Name::new(first), range, Role::Bind, Uses::BOUND);
                }
            }
        }
    }

    fn attempt(&mut self, node: &'a ast::StmtTry) {
        self.visit_body(&node.body);
        for (i, ast::ExceptHandler::ExceptHandler(handler)) in node.handlers.iter().enumerate() {
            match &handler.type_ {
                Some(kind) => self.visit_expr(kind),
                None if i + 1 < node.handlers.len() => {
                    self.report(Self::keyword(handler.range, "except"), "default 'except:' must be last".to_string());
                }
                None => {}
            }
            if let Some(name) = &handler.name {
                self.bind(name);
            }
            let before = self.checks.place.in_star_handler;
            self.checks.place.in_star_handler |= node.is_star;
            self.visit_body(&handler.body);
            self.checks.place.in_star_handler = before;
        }
        self.visit_body(&node.orelse);
        self.visit_body(&node.finalbody);
    }

    fn integer(&mut self, range: TextRange) {
        let text = self.checks.source.get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default();
        if text.len() > MAX_INT_DIGITS && text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'_') {
            let digits = text.bytes().filter(u8::is_ascii_digit).count();
            if digits > MAX_INT_DIGITS {
                let limit = format!("Exceeds the limit ({MAX_INT_DIGITS} digits) for integer string conversion: value has {digits} digits");
                self.report(range, limit);
            }
        }
    }

    /// `*x` where only a list of expressions may hold one.
    fn stars(&mut self, stmt: &Stmt) {
        let value = match stmt {
            Stmt::Expr(node) => Some(&node.value),
            Stmt::AnnAssign(node) => node.value.as_ref(),
            Stmt::AugAssign(node) => Some(&node.value),
            _ => None,
        };
        if let Some(value) = value.filter(|value| value.is_starred_expr()) {
            self.report(value.range(), "can't use starred expression here".to_string());
        }
        if let Stmt::Assign(node) = stmt {
            let chained = if node.targets.len() > 1 { node.targets.as_slice() } else { &[] };
            for target in chained.iter().filter(|target| target.is_starred_expr()) {
                self.report(target.range(), "starred assignment target must be in a list or tuple".to_string());
            }
        }
    }

    /// Jumps out of an `except*` handler.
    fn jumps(&mut self, stmt: &Stmt) {
        let out = match stmt {
            Stmt::Break(_) | Stmt::Continue(_) => self.checks.place.in_star_handler,
            Stmt::Return(_) => self.checks.place.in_star_handler || self.checks.place.in_star_handler_loop,
            _ => false,
        };
        if out {
            self.report(stmt.range(), "'break', 'continue' and 'return' cannot appear in an except* block".to_string());
        }
    }

    /// Lists so long that checking them takes too long.
    fn is_checkable(&mut self, stmt: &Stmt) -> bool {
        let type_params = match stmt {
            Stmt::FunctionDef(node) => &node.type_params,
            Stmt::ClassDef(node) => &node.type_params,
            Stmt::TypeAlias(node) => &node.type_params,
            _ => return true,
        };
        match type_params {
            Some(params) if params.len() > MAX_TYPE_PARAMS => {
                self.checks.report(SyntaxError::too_big(params.range, "too many type parameters"));
                false
            }
            _ => true,
        }
    }
}

#[cfg(test)]
mod tests;
