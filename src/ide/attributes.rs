//! Attributes of the program's own classes: where they are bound and used, as far as the text tells.
//!
//! An attribute is told by its name alone: whatever stands behind a dot under that name is taken for it. That is sound where one family
//! of classes binds the name, nothing of PSDL or Python has it, and no attribute is looked up by its text.

use super::docs;
use super::find::{
    attribute_at, for_each_node, functions, keyword_at, named_function, nodes_at, occurrence_at, occurrences_of, variable_of,
};
use super::hover::module_of;
use super::program::View;
use super::words::code;
use crate::syntax::ScopeKind;
use crate::syntax::ast::{self, AnyNodeRef, Expr, ExprContext, Stmt};
use crate::syntax::scope::Role;
use ruff_text_size::{Ranged as _, TextRange, TextSize};

/// By these attributes are looked up by their text, or shown with it.
const READERS: [&str; 11] =
    ["getattr", "setattr", "hasattr", "delattr", "vars", "dir", "attrgetter", "methodcaller", "asdict", "make_dataclass", "namedtuple"];
/// The same for functions of `dataclasses` and `copy` whose names other things have as well.
const MODULE_READERS: [&str; 2] = ["replace", "fields"];
/// Attributes by which a class looks up others.
const HOOKS: [&str; 9] =
    ["__dict__", "__slots__", "__getattr__", "__getattribute__", "__setattr__", "__match_args__", "_replace", "_asdict", "_fields"];
/// Bases that bring no attributes of their own that a program would bind.
const BASES: [&str; 4] = ["object", "ABC", "NamedTuple", "Generic"];

/// One place of an attribute.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Place {
    pub range: TextRange,
    /// It gets a value there.
    pub binds: bool,
}

/// The name of the attribute that stands at a place, with its range.
pub(super) fn name_at<'a>(view: &View<'a>, offset: TextSize) -> Option<(&'a str, TextRange)> {
    let nodes = nodes_at(view, offset);
    if let Some((keyword, call)) = keyword_at(&nodes, offset) {
        let class = class_of(view, &call.func, &classes(view))?;
        let arg = keyword.arg.as_ref().filter(|_| has_fields(class))?;
        return Some((arg.id.as_str(), arg.range));
    }
    if let Some(attribute) = attribute_at(&nodes, offset) {
        let own = module_of(view, &attribute.value).is_none();
        return own.then_some((attribute.attr.id.as_str(), attribute.attr.range));
    }
    let found = occurrence_at(view, offset)?;
    let scopes = &view.program.parsed.scopes;
    let variable = variable_of(view, found)?;
    (scopes.get(variable.owner).kind == ScopeKind::Class).then(|| (scopes.name(variable.name).as_str(), found.range))
}

/// Every place of an attribute, in the order of the text; or why that cannot be told.
pub(super) fn places(view: &View, name: &str) -> Result<Vec<Place>, String> {
    let owner = ["object", "vector", "module"].into_iter().chain(docs::TYPES).find(|owner| docs::of(owner, name).is_some());
    if owner.is_some() {
        return Err(format!("{name} is an attribute of what belongs to the language, too"));
    }
    if name.starts_with("__") {
        return Err(format!("{name} is a name that Python treats in its own way"));
    }
    let classes = classes(view);
    let family = family(view, name, &classes)?;
    looked_up(view)?;
    let mut finder = Finder { view, name, classes: &classes, family: &family, places: Vec::new(), unclear: None };
    for_each_node(view, &mut |node| finder.node(node));
    if let Some(why) = finder.unclear {
        return Err(why);
    }
    let mut places = finder.places;
    places.extend(family.iter().flat_map(|class| bound_in(view, class, name)));
    places.sort_by_key(|place| (place.range.start(), !place.binds));
    places.dedup_by_key(|place| place.range);
    Ok(places)
}

/// Whether the program has an attribute of this name, of whatever.
pub(super) fn is_taken(view: &View, name: &str) -> bool {
    let mut taken = classes(view).iter().any(|class| !bound_in(view, class, name).is_empty());
    for_each_node(view, &mut |node| taken |= matches!(node, AnyNodeRef::ExprAttribute(attribute) if attribute.attr.as_str() == name));
    taken || docs::of("object", name).is_some() || docs::of("vector", name).is_some()
}

fn classes<'a>(view: &View<'a>) -> Vec<&'a ast::StmtClassDef> {
    let mut found = Vec::new();
    for_each_node(view, &mut |node| {
        if let AnyNodeRef::StmtClassDef(class) = node {
            found.push(class);
        }
    });
    found
}

/// The class that an expression names, where the name means only that.
fn class_of<'a>(view: &View, expr: &Expr, classes: &[&'a ast::StmtClassDef]) -> Option<&'a ast::StmtClassDef> {
    let Expr::Name(name) = expr else { return None };
    let variable = variable_of(view, occurrence_at(view, name.range.start())?)?;
    let mut bound = occurrences_of(view, variable).into_iter().filter(|found| found.role == Role::Bind);
    let binding = bound.next().filter(|_| bound.next().is_none())?;
    classes.iter().find(|class| class.name.range == binding.range).copied()
}

/// Whether the constructor of a class takes its fields by their names.
fn has_fields(class: &ast::StmtClassDef) -> bool {
    let named = |expr: &Expr, wanted: &str| {
        let called = expr.as_call_expr().map_or(expr, |call| &call.func);
        matches!(called, Expr::Name(name) if name.id == wanted)
            || matches!(called, Expr::Attribute(attribute) if attribute.attr.as_str() == wanted)
    };
    class.decorator_list.iter().any(|decorator| named(&decorator.expression, "dataclass"))
        || class.bases().iter().any(|base| named(base, "NamedTuple"))
}

/// Where the body of a class binds or reads a name of its own.
fn bound_in(view: &View, class: &ast::StmtClassDef, name: &str) -> Vec<Place> {
    let scopes = &view.program.parsed.scopes;
    let own = |range: TextRange| class.range.contains_range(range);
    let of_class = scopes.occurrences().iter().filter(|found| own(found.range) && scopes.name(found.name) == name);
    let of_class = of_class.filter(|found| {
        let owner = variable_of(view, found).map(|variable| scopes.get(variable.owner));
        owner.is_some_and(|scope| scope.kind == ScopeKind::Class && scope.range == class.range)
    });
    let of_class = of_class.map(|found| Place { range: found.range, binds: found.role == Role::Bind });
    of_class.chain(class.body.iter().flat_map(|stmt| view.with_stack(|| set_on_self(stmt, name)))).collect()
}

/// Where a method gives an attribute of its first parameter a value.
fn set_on_self(stmt: &Stmt, name: &str) -> Vec<Place> {
    struct Stores<'n> {
        of: &'n str,
        name: &'n str,
        found: Vec<Place>,
    }
    impl<'a> ast::visitor::Visitor<'a> for Stores<'_> {
        fn visit_expr(&mut self, expr: &'a Expr) {
            if let Expr::Attribute(attribute) = expr
                && attribute.ctx == ExprContext::Store
                && attribute.attr.as_str() == self.name
                && matches!(attribute.value.as_ref(), Expr::Name(owner) if owner.id == self.of)
            {
                self.found.push(Place { range: attribute.attr.range, binds: true });
            }
            ast::visitor::walk_expr(self, expr);
        }
    }
    let Stmt::FunctionDef(def) = stmt else { return Vec::new() };
    let Some(first) = def.parameters.posonlyargs.iter().chain(&def.parameters.args).next() else { return Vec::new() };
    let mut stores = Stores { of: first.parameter.name.as_str(), name, found: Vec::new() };
    ast::visitor::Visitor::visit_body(&mut stores, &def.body);
    stores.found
}

/// The classes that bind an attribute: one, or several that inherit from each other.
fn family<'a>(view: &View, name: &str, classes: &[&'a ast::StmtClassDef]) -> Result<Vec<&'a ast::StmtClassDef>, String> {
    let owners: Vec<_> = classes.iter().copied().filter(|class| !bound_in(view, class, name).is_empty()).collect();
    if owners.is_empty() {
        return Err(format!("no class of the program binds {name}"));
    }
    // Related are those that a chain of bases joins.
    let mut family = vec![owners[0]];
    loop {
        let known = family.len();
        for class in classes {
            let bases =
                |class: &ast::StmtClassDef| -> Vec<_> { class.bases().iter().filter_map(|base| class_of(view, base, classes)).collect() };
            let is_in = |wanted: &ast::StmtClassDef, family: &[&ast::StmtClassDef]| family.iter().any(|class| class.range == wanted.range);
            let related = bases(class).iter().any(|base| is_in(base, &family))
                || family.iter().any(|member| bases(member).iter().any(|base| base.range == class.range));
            if related && !is_in(class, &family) {
                family.push(class);
            }
        }
        if family.len() == known {
            break;
        }
    }
    if let Some(other) = owners.iter().find(|owner| family.iter().all(|class| class.range != owner.range)) {
        let (first, other) = (owners[0].name.as_str(), other.name.as_str());
        return Err(format!(
            "{first} and {other} both have an attribute {name}: which of them is meant where cannot be told from the text"
        ));
    }
    for class in &family {
        let known =
            |base: &Expr| class_of(view, base, classes).is_some() || matches!(base, Expr::Name(name) if BASES.contains(&name.id.as_str()));
        if let Some(base) = class.bases().iter().find(|base| !known(base)) {
            let base = code(view.slice(base.range()));
            return Err(format!("{} inherits from {base}, which may look up attributes by their text", class.name));
        }
    }
    Ok(family)
}

/// Whether attributes may be looked up by their text.
fn looked_up(view: &View) -> Result<(), String> {
    let mut found = None;
    for_each_node(view, &mut |node| match node {
        AnyNodeRef::ExprName(name) if READERS.contains(&name.id.as_str()) || MODULE_READERS.contains(&name.id.as_str()) => {
            found = Some(name.id.to_string());
        }
        AnyNodeRef::ExprAttribute(attribute) => {
            let of_module = module_of(view, &attribute.value).is_some();
            let (name, readers) = (attribute.attr.as_str(), READERS.iter().chain(&MODULE_READERS));
            if HOOKS.contains(&name) || of_module && readers.into_iter().any(|reader| *reader == name) {
                found = Some(name.to_string());
            }
        }
        AnyNodeRef::StmtFunctionDef(def) if HOOKS.contains(&def.name.as_str()) => found = Some(def.name.to_string()),
        _ => {}
    });
    let hook = view.program.parsed.scopes.occurrences().iter().map(|found| view.slice(found.range)).find(|name| HOOKS.contains(name));
    match found.as_deref().or(hook) {
        Some(name) => Err(format!("{name} is used: attributes may be looked up by their text")),
        None => Ok(()),
    }
}

/// Goes through the program for the places outside of the classes' own names.
struct Finder<'v, 'a> {
    view: &'v View<'a>,
    name: &'v str,
    classes: &'v [&'a ast::StmtClassDef],
    family: &'v [&'a ast::StmtClassDef],
    places: Vec<Place>,
    unclear: Option<String>,
}

impl<'a> Finder<'_, 'a> {
    fn node(&mut self, node: AnyNodeRef<'a>) {
        match node {
            AnyNodeRef::ExprAttribute(attribute)
                if attribute.attr.as_str() == self.name && module_of(self.view, &attribute.value).is_none() =>
            {
                self.places.push(Place { range: attribute.attr.range, binds: attribute.ctx == ExprContext::Store });
            }
            AnyNodeRef::PatternKeyword(keyword) if keyword.attr.as_str() == self.name => {
                self.places.push(Place { range: keyword.attr.range, binds: false });
            }
            AnyNodeRef::ExprCall(call) if self.family.iter().any(|class| has_fields(class)) => self.call(call),
            _ => {}
        }
    }

    /// A field may be given by its name.
    fn call(&mut self, call: &'a ast::ExprCall) {
        let class = class_of(self.view, &call.func, self.classes);
        let in_family = class.is_some_and(|class| self.family.iter().any(|member| member.range == class.range));
        for keyword in &call.arguments.keywords {
            match &keyword.arg {
                None if in_family => self.unclear = Some(format!("{} may be given through **", self.name)),
                Some(arg) if arg.as_str() == self.name && in_family => self.places.push(Place { range: arg.range, binds: true }),
                Some(arg) if arg.as_str() == self.name && class.is_none() && !self.is_known(call) => {
                    self.unclear = Some(format!("what is called with {}= cannot be told from the text", self.name));
                }
                _ => {}
            }
        }
    }

    /// Whether a call is one of a function of the program or of the language, which has parameters of its own.
    fn is_known(&self, call: &ast::ExprCall) -> bool {
        let Expr::Name(name) = call.func.as_ref() else { return false };
        let functions = functions(self.view);
        named_function(self.view, name.range, &functions).is_some() || docs::global(&name.id).is_some()
    }
}
