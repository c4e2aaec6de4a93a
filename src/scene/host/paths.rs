//! From the globals of a program to the names of its objects.

use ruff_text_size::TextRange;
use rustc_hash::FxHashSet;

use crate::python::heap::{Attrs, Heap, Ref};
use crate::python::symbols::Interner;
use crate::python::text::repr_str;
use crate::python::value::Value;
use crate::scene::names::{Label, Node, Root};
use crate::scene::terms::Target;
use crate::syntax::ast::{self, Ranged as _, Stmt};
use crate::syntax::scope::Role;
use crate::syntax::{Parsed, ScopeId};

use super::Thing;

/// How deep containers are searched for objects.
const DEPTH: usize = 5;
/// How many values are looked at.
const VALUES: usize = 1_000_000;

/// The globals that lead to objects, in the order in which they are given. Names that loops bind are left out, see [`bound_in_loops`].
pub fn name_after_globals<'a>(
    heap: &Heap,
    symbols: &Interner,
    globals: impl IntoIterator<Item = (&'a str, Value)>,
    left_out: &FxHashSet<String>,
) -> Vec<Root> {
    let mut search = Search { heap, symbols, left: VALUES };
    let lasting = globals.into_iter().filter(|(name, _)| !left_out.contains(*name));
    lasting.filter_map(|(name, value)| Some(Root { name: name.to_owned(), node: search.node(value, DEPTH)? })).collect()
}

struct Search<'a> {
    heap: &'a Heap,
    symbols: &'a Interner,
    left: usize,
}

impl Search<'_> {
    /// A value as far as it leads to objects.
    fn node(&mut self, value: Value, depth: usize) -> Option<Node> {
        self.left = self.left.checked_sub(1)?;
        if let Some(Thing::Target(Target::Object(id))) = Thing::of(value) {
            return Some(Node::Object(id));
        }
        let depth = depth.checked_sub(1)?;
        let heap = self.heap;
        let parts = match value {
            Value::List(list) => self.items(&heap[list].0, depth),
            Value::Tuple(tuple) => self.items(&heap[tuple].0, depth),
            Value::Dict(dict) => self.entries(dict, depth),
            Value::Instance(instance) => match &heap[instance].attrs {
                Attrs::Inline(attrs) => {
                    let symbols = self.symbols;
                    let part =
                        |&(name, value): &(_, Value)| Some((Label::Attribute(symbols.text(name).to_owned()), self.node(value, depth)?));
                    attrs.iter().filter_map(part).collect()
                }
                Attrs::Dict(dict) => self.entries(*dict, depth),
            },
            _ => Vec::new(),
        };
        (!parts.is_empty()).then_some(Node::Group(parts))
    }

    fn items(&mut self, items: &[Value], depth: usize) -> Vec<(Label, Node)> {
        let part = |(index, value): (usize, &Value)| Some((Label::Index(index), self.node(*value, depth)?));
        items.iter().enumerate().filter_map(part).collect()
    }

    fn entries(&mut self, dict: Ref<crate::python::heap::Dict>, depth: usize) -> Vec<(Label, Node)> {
        let heap = self.heap;
        let part = |entry: crate::python::table::Entry| {
            let key = match entry.key {
                Value::Str(text) if heap[text].text.len() <= 80 => repr_str(&heap[text].text),
                Value::Int(int, _) => int.to_string(),
                _ => return None,
            };
            Some((Label::Key(key), self.node(entry.value, depth)?))
        };
        heap[dict].0.iter().filter_map(part).collect()
    }
}

/// The names of the module that a loop binds anew each time, as its variable or in its body: they name no object, because they
/// stand for another one in each iteration.
pub fn bound_in_loops(parsed: &Parsed) -> FxHashSet<String> {
    let mut loops = Vec::new();
    parsed.with_stack(|| find_loops(&parsed.module.body, &mut loops));
    let scopes = &parsed.scopes;
    let in_loop = |range: TextRange| loops.iter().any(|body: &TextRange| body.contains_range(range));
    let bound = scopes.occurrences().iter().filter(|found| found.role == Role::Bind && found.scope == ScopeId::MODULE);
    bound.filter(|found| in_loop(found.range)).map(|found| scopes.name(found.name).to_string()).collect()
}

/// The outermost loops among statements and the blocks of `if`, `with` and `try`.
fn find_loops(body: &[Stmt], loops: &mut Vec<TextRange>) {
    for statement in body {
        match statement {
            Stmt::For(ast::StmtFor { .. }) | Stmt::While(ast::StmtWhile { .. }) => loops.push(statement.range()),
            Stmt::If(branch) => {
                find_loops(&branch.body, loops);
                branch.elif_else_clauses.iter().for_each(|clause| find_loops(&clause.body, loops));
            }
            Stmt::With(with) => find_loops(&with.body, loops),
            Stmt::Try(attempt) => {
                [&attempt.body, &attempt.orelse, &attempt.finalbody].into_iter().for_each(|body| find_loops(body, loops));
            }
            _ => {}
        }
    }
}
