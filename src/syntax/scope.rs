//! Which variable a name means, decided once, before anything runs: CPython 3.11's rules.
//!
//! A scope is a namespace of its own: the module, each class body, function, lambda and
//! comprehension (in 3.11 a comprehension is a function with one hidden parameter, the iterator over
//! its outermost iterable, which is evaluated outside). The tables here are what a compiler needs to
//! lay out frames and closures, and what an editor needs to find every occurrence of a variable.

use std::borrow::Cow;

use ruff_python_ast::name::Name;
use ruff_text_size::{TextRange, TextSize};
use rustc_hash::FxHashMap;

/// Bytes after which a qualified name stops growing outwards.
const MAX_QUALIFIED_NAME: usize = 1000;

/// One scope of a program.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct ScopeId(pub u32);

impl ScopeId {
    /// The module itself: always the first.
    pub const MODULE: ScopeId = ScopeId(0);
}

/// The place of a global name in [`Scopes::globals`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct GlobalId(pub u32);

/// A name (mangled, where Python mangles) that occurs in the program; equal names have equal ids.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct NameId(pub(crate) u32);

/// What opened a scope.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ScopeKind {
    /// The program.
    Module,
    /// A class body.
    Class,
    /// `def`.
    Function,
    /// `lambda`.
    Lambda,
    /// `[… for …]`.
    ListComp,
    /// `{… for …}`.
    SetComp,
    /// `{…: … for …}`.
    DictComp,
    /// `(… for …)`.
    Generator,
}

impl ScopeKind {
    /// Has fast locals and can be closed over: everything but the module and class bodies.
    pub fn is_function_like(self) -> bool {
        !matches!(self, ScopeKind::Module | ScopeKind::Class)
    }

    /// A comprehension or generator expression.
    pub fn is_comprehension(self) -> bool {
        matches!(self, ScopeKind::ListComp | ScopeKind::SetComp | ScopeKind::DictComp | ScopeKind::Generator)
    }
}

/// How a scope reaches the variable that a name means in it. Numbers are places in that scope's own lists.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum NameKind {
    /// In `locals[i]` of the scope.
    Local(u32),
    /// In `cells[i]`: a local that an inner scope closes over.
    Cell(u32),
    /// In `frees[i]`: a variable of an enclosing function.
    Free(u32),
    /// Declared `global`: the module's, then the builtins.
    GlobalExplicit(GlobalId),
    /// Bound nowhere nearer: the module's, then the builtins. All names of the module scope are this.
    GlobalImplicit(GlobalId),
    /// In a class body: its own namespace first, then as a global.
    Class(GlobalId),
}

/// Where the creator of a closure finds a variable to hand over: in its own lists.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Capture {
    /// `cells[i]` of the enclosing scope.
    Cell(u32),
    /// `frees[i]` of the enclosing scope.
    Free(u32),
}

/// A local that an inner scope closes over.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cell {
    /// Its name.
    pub name: Name,
    /// Where it is a parameter too: its place among `locals`; the call fills the cell from there.
    pub parameter: Option<u32>,
}

/// A variable of an enclosing scope that this one uses or passes on.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Free {
    /// Its name.
    pub name: Name,
    /// Where the enclosing scope (`Scope::parent`) has it.
    pub from: Capture,
}

/// One scope, resolved.
#[derive(Clone, PartialEq, Debug)]
pub struct Scope {
    /// What opened it.
    pub kind: ScopeKind,
    /// The scope that it is written in; `None` for the module.
    pub parent: Option<ScopeId>,
    /// The node: the whole `def` with its decorators, the whole comprehension with its brackets…
    pub range: TextRange,
    /// `f`, `C`, `<lambda>`, `<listcomp>`, `<module>`…
    pub name: Name,
    /// How many of `locals` are parameters.
    pub parameter_count: u32,
    /// Parameters first, as CPython orders them (positional, keyword-only, `*args`, `**kwargs`; for
    /// a comprehension the one hidden `.0`), then the other fast locals. Empty for module and class.
    pub locals: Vec<Name>,
    /// Locals that inner scopes close over. For a class body: `__class__`, where a method needs it.
    pub cells: Vec<Cell>,
    /// What it takes from enclosing functions, in the order in which closures are laid out.
    pub frees: Vec<Free>,
    /// It contains `yield` (generator expressions always count).
    pub is_generator: bool,
    /// The class that mangles private names here, without its leading underscores.
    pub(crate) private: Option<Name>,
}

/// What an occurrence of a name does.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Role {
    /// Reads it.
    Load,
    /// Gives it a value (assignment, `for`, `import`, `def`, parameter, capture pattern…).
    Bind,
    /// Deletes it.
    Delete,
    /// `global` or `nonlocal`.
    Declare,
}

/// One place where a variable's name stands in the text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Occurrence {
    /// The name itself.
    pub range: TextRange,
    /// The scope that it is looked up in.
    pub scope: ScopeId,
    /// The name.
    pub name: NameId,
    /// What happens to it.
    pub role: Role,
}

/// A variable: a name in the scope that owns it (the module, for globals and builtins).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Variable {
    /// The scope that holds the value.
    pub owner: ScopeId,
    /// The name.
    pub name: NameId,
}

/// All scopes of a program and the meaning of each name in each.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Scopes {
    pub(crate) scopes: Vec<Scope>,
    pub(crate) names: Vec<Name>,
    pub(crate) name_ids: FxHashMap<Name, NameId>,
    pub(crate) kinds: FxHashMap<(ScopeId, NameId), NameKind>,
    pub(crate) nodes: FxHashMap<TextRange, ScopeId>,
    pub(crate) globals: Vec<NameId>,
    pub(crate) global_ids: FxHashMap<NameId, GlobalId>,
    pub(crate) occurrences: Vec<Occurrence>,
}

impl Scopes {
    /// The scope that the node with this range opens: a `def`, class, lambda or comprehension. (Two
    /// such nodes never share a range, though they may share a start.)
    pub fn of(&self, node: TextRange) -> Option<ScopeId> {
        self.nodes.get(&node).copied()
    }

    /// A scope by its id; the module for an id of another program.
    pub fn get(&self, id: ScopeId) -> &Scope {
        &self.scopes[if (id.0 as usize) < self.scopes.len() { id.0 as usize } else { 0 }]
    }

    /// All scopes, outer before inner, in the order of the text.
    pub fn iter(&self) -> impl Iterator<Item = (ScopeId, &Scope)> {
        (0..).map(ScopeId).zip(&self.scopes)
    }

    /// How `scope` reaches what the name means there. The name is as the program writes it; private
    /// names of classes are mangled here. `None` for a name that does not occur as a variable in that scope.
    pub fn lookup(&self, scope: ScopeId, name: &str) -> Option<NameKind> {
        let id = self.name_id(&self.mangle(scope, name))?;
        self.kinds.get(&(scope, id)).copied()
    }

    /// A name as Python stores it: `__x` in class `C` is `_C__x`. Attributes and keywords too.
    pub fn mangle<'n>(&self, scope: ScopeId, name: &'n str) -> Cow<'n, str> {
        mangled(self.get(scope).private.as_ref(), name)
    }

    /// Every name that is looked up as a global anywhere: the module's variables and the builtins it uses.
    pub fn globals(&self) -> impl ExactSizeIterator<Item = &Name> {
        self.globals.iter().map(|id| &self.names[id.0 as usize])
    }

    /// The place of a global, where the program uses it at all.
    pub fn global(&self, name: &str) -> Option<GlobalId> {
        self.global_ids.get(&self.name_id(name)?).copied()
    }

    /// A scope's name as error messages give it: `outer.<locals>.f`. Absurdly long ones lose their front.
    pub fn qualified_name(&self, id: ScopeId) -> String {
        let scope = self.get(id);
        let mut parts = vec![scope.name.as_str()];
        let (mut at, mut length) = (scope, scope.name.len());
        while let Some(parent) = at.parent.filter(|parent| *parent != ScopeId::MODULE && length < MAX_QUALIFIED_NAME) {
            let declared_global = self.name_ids.get(at.name.as_str()).and_then(|name| self.kinds.get(&(parent, *name)));
            if matches!(declared_global, Some(NameKind::GlobalExplicit(_))) {
                break;
            }
            at = self.get(parent);
            parts.push(if matches!(at.kind, ScopeKind::Function | ScopeKind::Lambda) { ".<locals>." } else { "." });
            parts.push(at.name.as_str());
            length += at.name.len();
        }
        parts.reverse();
        parts.concat()
    }

    /// The id of a (mangled) name, where the program has it.
    pub fn name_id(&self, name: &str) -> Option<NameId> {
        self.name_ids.get(name).copied()
    }

    /// The text of a name.
    pub fn name(&self, id: NameId) -> &Name {
        &self.names[id.0 as usize]
    }

    /// The innermost scope whose node holds the byte (or ends at it).
    pub fn at(&self, offset: TextSize) -> ScopeId {
        let mut found = ScopeId::MODULE;
        for (id, scope) in self.iter().skip(1) {
            if scope.range.start() > offset {
                break;
            }
            if scope.range.contains_inclusive(offset) {
                found = id;
            }
        }
        found
    }

    /// Every occurrence of a variable's name, in the order in which they were met (nearly the text's).
    pub fn occurrences(&self) -> &[Occurrence] {
        &self.occurrences
    }

    /// The variable that a name means in a scope.
    pub fn variable(&self, scope: ScopeId, name: NameId) -> Option<Variable> {
        let mut at = scope;
        let mut kind = *self.kinds.get(&(at, name))?;
        loop {
            match kind {
                NameKind::GlobalExplicit(_) | NameKind::GlobalImplicit(_) => return Some(Variable { owner: ScopeId::MODULE, name }),
                NameKind::Local(_) | NameKind::Cell(_) => return Some(Variable { owner: at, name }),
                NameKind::Class(_) => {
                    let bound = |o: &Occurrence| o.scope == at && o.name == name && o.role == Role::Bind;
                    let owner = if self.occurrences.iter().any(bound) { at } else { ScopeId::MODULE };
                    return Some(Variable { owner, name });
                }
                NameKind::Free(i) => {
                    let scope = self.get(at);
                    let from = scope.frees.get(i as usize)?.from;
                    at = scope.parent?;
                    kind = match from {
                        Capture::Cell(i) => NameKind::Cell(i),
                        Capture::Free(i) => NameKind::Free(i),
                    };
                }
            }
        }
    }
}

/// See [`Scopes::mangle`].
pub(crate) fn mangled<'n>(class: Option<&Name>, name: &'n str) -> Cow<'n, str> {
    match class {
        Some(class) if name.starts_with("__") && !name.ends_with("__") && !name.contains('.') => Cow::Owned(format!("_{class}{name}")),
        _ => Cow::Borrowed(name),
    }
}
