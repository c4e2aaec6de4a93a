//! The outline of a program: its objects by category, its functions, its variables.

use super::find::occurrence_at;
use super::program::View;
use super::values::Values;
use super::words;
use crate::scene::{Kind, Source};
use crate::syntax::ScopeId;
use crate::syntax::ast::{Expr, Ranged as _, Stmt};
use crate::syntax::scope::{Role, Variable};
use ruff_text_size::{TextRange, TextSize};

/// What a symbol is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SymbolKind {
    /// Objects of one category.
    Category,
    /// An object.
    Object,
    /// A door or a window.
    Opening,
    /// A function.
    Function,
    /// A class.
    Class,
    /// A variable that stands for no object.
    Variable,
}

/// A symbol and what is in it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Symbol {
    /// What it is called.
    pub name: String,
    /// More about it, in a few words.
    pub detail: String,
    /// What it is.
    pub kind: SymbolKind,
    /// All of it.
    pub range: TextRange,
    /// The part to go to; inside of `range`.
    pub selection: TextRange,
    /// What is in it.
    pub children: Vec<Symbol>,
}

/// The outline.
pub fn symbols(view: &View) -> Vec<Symbol> {
    let mut found = objects(view);
    view.with_stack(|| statements(view, &view.program.parsed.module.body, ScopeId::MODULE, &mut found));
    found
}

/// All symbols without their order, each with what it is in.
pub fn flat(view: &View) -> Vec<(Symbol, String)> {
    fn flatten(symbols: Vec<Symbol>, inside: &str, found: &mut Vec<(Symbol, String)>) {
        for mut symbol in symbols {
            let children = std::mem::take(&mut symbol.children);
            let name = symbol.name.clone();
            if symbol.kind != SymbolKind::Category {
                found.push((symbol, inside.to_string()));
            }
            flatten(children, &name, found);
        }
    }
    let mut found = Vec::new();
    flatten(symbols(view), "", &mut found);
    found
}

/// The objects by category, in the order in which they are declared.
fn objects(view: &View) -> Vec<Symbol> {
    let Some(scene) = view.scene else { return Vec::new() };
    let mut categories: Vec<Symbol> = Vec::new();
    for (index, object) in scene.layout.objects.iter().enumerate() {
        let range = declared(view, index);
        let errors = scene.errors_among(&[index]);
        let wrong = if errors > 0 { format!(" · {}", words::counted(errors, "error")) } else { String::new() };
        let symbol = Symbol {
            name: object.path.clone(),
            detail: format!("{}{wrong}", words::size(object)),
            kind: if object.body.kind == Kind::Object { SymbolKind::Object } else { SymbolKind::Opening },
            range,
            selection: range,
            children: Vec::new(),
        };
        match categories.iter_mut().find(|category| category.name == object.name) {
            Some(category) => {
                category.range = category.range.cover(range);
                category.children.push(symbol);
            }
            None => categories.push(Symbol {
                name: object.name.clone(),
                detail: String::new(),
                kind: SymbolKind::Category,
                range,
                selection: range,
                children: vec![symbol],
            }),
        }
    }
    for category in &mut categories {
        // No outline shows a symbol without a name.
        if category.name.trim().is_empty() {
            category.name = "(no name)".into();
        }
        category.detail = words::counted(category.children.len(), "object");
    }
    categories
}

/// Where an object is declared; one of the sidecar where the program names it first.
fn declared(view: &View, index: usize) -> TextRange {
    let Some(object) = view.scene.and_then(|scene| scene.object(index)) else { return TextRange::default() };
    let origin = view.scene.map(|scene| scene.layout.origins.get(object.declared));
    if let Some(range) = origin.filter(|origin| origin.source == Source::Program).and_then(|origin| view.now(origin.range)) {
        return range;
    }
    let root = object.path.split(['[', '.', '(', ' ']).next().unwrap_or_default();
    let scopes = &view.program.parsed.scopes;
    let named = |name| scopes.occurrences().iter().filter(move |found| found.name == name).map(|found| found.range);
    scopes.name_id(root).and_then(|name| named(name).min_by_key(|range| range.start())).unwrap_or_default()
}

/// Functions, classes and the variables of the module.
fn statements(view: &View, body: &[Stmt], scope: ScopeId, found: &mut Vec<Symbol>) {
    for stmt in body {
        match stmt {
            Stmt::FunctionDef(def) => {
                let mut children = Vec::new();
                statements(view, &def.body, ScopeId(u32::MAX), &mut children);
                let selection = def.name.range;
                let detail = words::plain_line(view.slice(def.parameters.range));
                found.push(Symbol { name: named(&def.name), detail, kind: SymbolKind::Function, range: stmt.range(), selection, children });
            }
            Stmt::ClassDef(def) => {
                let mut children = Vec::new();
                statements(view, &def.body, ScopeId(u32::MAX), &mut children);
                let (selection, detail) = (def.name.range, String::new());
                found.push(Symbol { name: named(&def.name), detail, kind: SymbolKind::Class, range: stmt.range(), selection, children });
            }
            Stmt::Assign(assign) if scope == ScopeId::MODULE => {
                for target in &assign.targets {
                    variable(view, target, stmt.range(), &words::plain_line(view.slice(assign.value.range())), found);
                }
            }
            _ => {}
        }
    }
}

fn named(name: &str) -> String {
    if name.is_empty() { "(no name)".into() } else { name.to_string() }
}

/// A variable where it is bound first, if it stands for no object.
fn variable(view: &View, target: &Expr, range: TextRange, value: &str, found: &mut Vec<Symbol>) {
    let Expr::Name(name) = target else { return };
    let scopes = &view.program.parsed.scopes;
    let Some(occurrence) = occurrence_at(view, name.range.start()) else { return };
    let bound = scopes.occurrences().iter().filter(|other| other.name == occurrence.name && other.scope == occurrence.scope);
    let first = bound.filter(|other| other.role == Role::Bind).map(|other| other.range.start()).min();
    let objects = view.scene.is_some_and(|scene| {
        let inside = |path: &str| path.strip_prefix(name.id.as_str()).is_some_and(|rest| rest.is_empty() || rest.starts_with(['[', '.']));
        scene.layout.objects.iter().any(|object| inside(&object.path))
    });
    if first == Some(name.range.start()) && !objects {
        let detail = value.to_string();
        found.push(Symbol {
            name: name.id.to_string(),
            detail,
            kind: SymbolKind::Variable,
            range,
            selection: name.range,
            children: Vec::new(),
        });
    }
}

/// The objects that the variables of the module stand for, by variable, for completion.
pub(super) fn variables(view: &View, offset: TextSize) -> Vec<(String, Vec<usize>)> {
    let scopes = &view.program.parsed.scopes;
    let values = Values::new(*view);
    let mut at = Some(scopes.at(offset));
    let mut found: Vec<(String, Vec<usize>)> = Vec::new();
    while let Some(scope) = at {
        for occurrence in scopes.occurrences().iter().filter(|found| found.scope == scope && found.role == Role::Bind) {
            let name = scopes.name(occurrence.name).to_string();
            let standing_here = occurrence.range.contains_inclusive(offset);
            if !standing_here && !found.iter().any(|(known, _)| *known == name) {
                let variable = scopes.variable(scope, occurrence.name).unwrap_or(Variable { owner: scope, name: occurrence.name });
                found.push((name, values.of_variable(variable)));
            }
        }
        at = scopes.get(scope).parent;
    }
    let entries = view.scene.and_then(|scene| scene.template.as_ref()).map(|template| template.objects.as_slice()).unwrap_or_default();
    for entry in entries {
        if !found.iter().any(|(known, _)| *known == entry.id) {
            found.push((entry.id.clone(), values.at_path(&entry.id)));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    fn shown(symbols: &[Symbol], depth: usize) -> String {
        let line = |symbol: &Symbol| {
            let inner = shown(&symbol.children, depth + 1);
            format!("{}{} ({:?}) {}\n{inner}", "  ".repeat(depth), symbol.name, symbol.kind, symbol.detail)
        };
        symbols.iter().map(line).collect()
    }

    #[test]
    fn the_scene_is_a_tree_of_categories_and_objects() {
        let fixture = Fixture::new(
            "bed = Object('Bed', 2, 2, 1)\nchairs = [Object('Chair 1', 1, 1, 1) for _ in range(2)]\ngap = 0.5\ndef put(o):\n    def inner(): pass\n",
        );
        let outline = shown(&symbols(&fixture.view()), 0);
        let expected = "Bed (Category) 1 object\n  bed (Object) 2 × 2 × 1 m\nChair (Category) 2 objects\n  chairs[0] (Object) 1 × 1 × 1 m\n  chairs[1] (Object) 1 × 1 × 1 m\ngap (Variable) 0.5\nput (Function) (o)\n  inner (Function) ()\n";
        assert_eq!(outline, expected);
    }

    #[test]
    fn a_program_that_never_ran_has_an_outline_too() {
        let fixture = Fixture::new("bed = Object(\ndef put(o): pass\n");
        assert!(fixture.scene.is_none());
        assert!(symbols(&fixture.view()).iter().any(|symbol| symbol.name == "put"));
    }
}
