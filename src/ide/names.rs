//! Where a name is bound, and where it is used.

use super::attributes;
use super::find::{callee, for_each_node, functions, keyword_at, nodes_at, occurrence_at, occurrences_of, variable_of};
use super::program::View;
use crate::scene::template::{Template, TemplateObject};
use crate::syntax::ScopeId;
use crate::syntax::ast::{self, AnyNodeRef};
use crate::syntax::scope::{Role, Variable};
use ruff_text_size::{TextRange, TextSize};

/// A range of the program, or of its sidecar.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Site {
    /// Of the program.
    Program(TextRange),
    /// Of the sidecar template.
    Template(TextRange),
}

/// What a highlighted name is used for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Use {
    /// It is read.
    Read,
    /// It gets a value.
    Write,
}

/// The variable at a place: a name, or a keyword argument of a function of the program.
pub(super) fn variable_at(view: &View, offset: TextSize) -> Option<(Variable, TextRange)> {
    let nodes = nodes_at(view, offset);
    if let Some((keyword, call)) = keyword_at(&nodes, offset) {
        let name = keyword.arg.as_ref()?;
        let functions = functions(view);
        let def = callee(view, call, &functions)?;
        let parameter = parameters(def).find(|parameter| parameter.name.id == name.id)?;
        let occurrence = occurrence_at(view, parameter.name.range.start())?;
        return Some((variable_of(view, occurrence)?, name.range));
    }
    let occurrence = occurrence_at(view, offset)?;
    Some((variable_of(view, occurrence)?, occurrence.range))
}

/// The variable that an entry of the sidecar becomes, where the program uses it.
pub(super) fn variable_of_id(view: &View, id: &str) -> Option<Variable> {
    let name = view.program.parsed.scopes.name_id(id)?;
    Some(Variable { owner: ScopeId::MODULE, name })
}

/// The entry of the sidecar that a variable stands for.
pub(super) fn entry_of<'t>(view: &View, template: Option<&'t Template>, variable: Variable) -> Option<&'t TemplateObject> {
    let name = view.program.parsed.scopes.name(variable.name);
    let entries = template.filter(|_| variable.owner == ScopeId::MODULE)?.objects.iter();
    entries.into_iter().find(|entry| entry.id == name.as_str())
}

/// The entry of the sidecar whose id stands at a place of it.
pub(super) fn entry_at(template: &Template, offset: TextSize) -> Option<&TemplateObject> {
    template.objects.iter().find(|entry| entry.id_range.contains_inclusive(offset))
}

/// The parameters of a function that can be given by their names.
pub(super) fn parameters(def: &ast::StmtFunctionDef) -> impl Iterator<Item = &ast::Parameter> {
    def.parameters.args.iter().chain(&def.parameters.kwonlyargs).map(|parameter| &parameter.parameter)
}

/// The function that a variable is a parameter of.
pub(super) fn function_of<'a>(view: &View<'a>, variable: Variable) -> Option<&'a ast::StmtFunctionDef> {
    let bound: Vec<TextRange> = occurrences_of(view, variable).iter().map(|found| found.range).collect();
    functions(view).into_iter().find(|def| parameters(def).any(|parameter| bound.contains(&parameter.name.range)))
}

/// Every call of the program.
pub(super) fn calls<'a>(view: &View<'a>) -> Vec<&'a ast::ExprCall> {
    let mut calls = Vec::new();
    for_each_node(view, &mut |node| {
        if let AnyNodeRef::ExprCall(call) = node {
            calls.push(call);
        }
    });
    calls
}

/// Where a parameter is given by its name.
fn keywords_of(view: &View, variable: Variable) -> Vec<TextRange> {
    let Some(def) = function_of(view, variable) else { return Vec::new() };
    let name = view.program.parsed.scopes.name(variable.name);
    let functions = functions(view);
    let calls = calls(view).into_iter().filter(|call| callee(view, call, &functions).is_some_and(|called| std::ptr::eq(called, def)));
    let names = calls.flat_map(|call| call.arguments.keywords.iter().filter_map(|keyword| keyword.arg.as_ref()));
    names.filter(|arg| arg.id == *name).map(|arg| arg.range).collect()
}

/// The places of the attribute of a class of the program that stands at a place, where they can be told.
fn attribute_places(view: &View, offset: TextSize) -> Option<Vec<attributes::Place>> {
    let (name, _) = attributes::name_at(view, offset)?;
    attributes::places(view, name).ok()
}

/// Where the name at a place is bound.
pub fn definition(view: &View, template: Option<&Template>, offset: TextSize) -> Vec<Site> {
    if let Some(places) = attribute_places(view, offset) {
        return places.into_iter().filter(|place| place.binds).map(|place| Site::Program(place.range)).collect();
    }
    let Some((variable, _)) = variable_at(view, offset) else { return Vec::new() };
    let bound = occurrences_of(view, variable).into_iter().filter(|found| found.role == Role::Bind).map(|found| Site::Program(found.range));
    entry_of(view, template, variable).map(|entry| Site::Template(entry.id_range)).into_iter().chain(bound).collect()
}

/// Every place where the name at a place stands; without the places that bind it, unless they are asked for.
pub fn references(view: &View, template: Option<&Template>, offset: TextSize, with_bindings: bool) -> Vec<Site> {
    if let Some(places) = attribute_places(view, offset) {
        return places.into_iter().filter(|place| with_bindings || !place.binds).map(|place| Site::Program(place.range)).collect();
    }
    variable_at(view, offset).map(|(variable, _)| sites(view, template, variable, with_bindings)).unwrap_or_default()
}

/// The same for an id in the sidecar.
pub fn references_of_id(view: &View, template: &Template, offset: TextSize, with_bindings: bool) -> Vec<Site> {
    let Some(entry) = entry_at(template, offset) else { return Vec::new() };
    match variable_of_id(view, &entry.id) {
        Some(variable) => sites(view, Some(template), variable, with_bindings),
        None if with_bindings => vec![Site::Template(entry.id_range)],
        None => Vec::new(),
    }
}

fn sites(view: &View, template: Option<&Template>, variable: Variable, with_bindings: bool) -> Vec<Site> {
    let named = occurrences_of(view, variable).into_iter().filter(|found| with_bindings || found.role != Role::Bind);
    let mut ranges: Vec<TextRange> = named.map(|found| found.range).chain(keywords_of(view, variable)).collect();
    ranges.sort_by_key(|range| range.start());
    let entry = entry_of(view, template, variable).filter(|_| with_bindings);
    entry.map(|entry| Site::Template(entry.id_range)).into_iter().chain(ranges.into_iter().map(Site::Program)).collect()
}

/// Every place in the program where the name at a place stands, and what is done there.
pub fn highlights(view: &View, offset: TextSize) -> Vec<(TextRange, Use)> {
    if let Some(places) = attribute_places(view, offset) {
        return places.into_iter().map(|place| (place.range, if place.binds { Use::Write } else { Use::Read })).collect();
    }
    let Some((variable, _)) = variable_at(view, offset) else { return Vec::new() };
    let named = occurrences_of(view, variable)
        .into_iter()
        .map(|found| (found.range, if matches!(found.role, Role::Bind | Role::Delete) { Use::Write } else { Use::Read }));
    named.chain(keywords_of(view, variable).into_iter().map(|range| (range, Use::Write))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    /// What stands between `<` and `>` is what refers to the name at the `$0`.
    fn check(marked: &str) {
        let plain = marked.replace(['<', '>'], "");
        let fixture = Fixture::new(&plain);
        let mut shown = fixture.text().to_string();
        for site in references(&fixture.view(), None, fixture.offset, true).into_iter().rev() {
            let Site::Program(range) = site else { panic!("there is no sidecar") };
            shown.insert(range.end().to_usize(), '>');
            shown.insert(range.start().to_usize(), '<');
        }
        assert_eq!(shown, marked.replacen("$0", "", 1));
    }

    #[test]
    fn scopes_are_kept_apart() {
        check("<x$0> = 1\ndef f(x):\n    return x\ny = [x for x in (1,)]\nprint(<x>)\n");
        check("x = 1\ndef f(<x>):\n    return <x$0>\nf(<x>=2)\nprint(x)\n");
        check("def f():\n    <n> = 1\n    def g():\n        nonlocal <n>\n        <n$0> += 1\n    return g\nn = 3\n");
        check("<gap> = 0.5\nprint(f'{<gap$0>:.2f} {<gap>=}')\n");
    }

    #[test]
    fn a_keyword_argument_is_its_parameter() {
        check("def row(items, <gap>=1):\n    return <gap>\nrow([], <ga$0p>=2)\nrow([], <gap>=3)\ndict(gap=4)\n");
    }

    #[test]
    fn a_name_of_the_sidecar_is_bound_there() {
        let template = r#"{"title": "Room", "width": 4, "depth": 4, "height": 3, "interior": true, "objects": [{"id": "desk", "name": "Desk", "width": 1, "depth": 1, "height": 1, "support": "STANDING"}]}"#;
        let fixture = Fixture::with_template("des$0k.min.x = 0.5\nprint(desk)\n", Some(template));
        let read = fixture.scene.as_ref().and_then(|scene| scene.template.as_ref());
        let at = u32::try_from(template.find("\"desk\"").unwrap()).unwrap();
        let id = TextRange::at(at.into(), 6.into());
        assert_eq!(definition(&fixture.view(), read, fixture.offset), [Site::Template(id)]);
        assert_eq!(references(&fixture.view(), read, fixture.offset, true).len(), 3);
        assert_eq!(references_of_id(&fixture.view(), read.unwrap(), (at + 2).into(), false).len(), 2);
    }

    #[test]
    fn names_are_highlighted_by_what_is_done() {
        let fixture = Fixture::new("a$0 = 1\nb = a\n");
        let uses: Vec<Use> = highlights(&fixture.view(), fixture.offset).into_iter().map(|(_, what)| what).collect();
        assert_eq!(uses, [Use::Write, Use::Read]);
    }
}
