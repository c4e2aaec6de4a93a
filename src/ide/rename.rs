//! Another name for a variable, a parameter or an entry of the sidecar; refused where the program would mean something else then.
//!
//! The edits are tried: the new text is read, and each of its names must mean what it meant before. What cannot be told from
//! the text (a keyword argument of a function that is not known, a variable that is looked up by its text) is refused.

use super::attributes;
use super::docs;
use super::find::{callee, functions, named_function, nodes_at, occurrences_of, variable_of};
use super::hover::module_of;
use super::names::{calls, entry_at, entry_of, function_of, variable_at, variable_of_id};
use super::program::{Program, View};
use crate::scene::template::Template;
use crate::syntax::ast::{self, AnyNodeRef, Expr, Ranged as _};
use crate::syntax::scope::{Occurrence, Role, Variable};
use crate::syntax::{Edit, LineIndex, ScopeId, ScopeKind};
use ruff_text_size::{TextRange, TextSize};
use rustc_hash::FxHashMap;

/// A sidecar template that could be read.
#[derive(Clone, Copy, Debug)]
pub struct TemplateText<'a> {
    /// Its text.
    pub text: &'a str,
    /// What it says.
    pub template: &'a Template,
}

/// What is renamed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum At {
    /// What stands at a place of the program.
    Program(TextSize),
    /// The id at a place of the sidecar.
    Template(TextSize),
}

/// The edits, of the program and of the sidecar, by place.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Rename {
    /// Of the program.
    pub program: Vec<Edit>,
    /// Of the sidecar.
    pub template: Vec<Edit>,
}

/// Why a name cannot be changed, for people.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refusal(pub String);

fn refuse<T>(why: impl Into<String>) -> Result<T, Refusal> {
    Err(Refusal(why.into()))
}

/// What is to be renamed at a place: its range there and its name.
///
/// # Errors
/// Nothing there can be renamed.
pub fn prepare(view: &View, sidecar: Option<TemplateText>, at: At) -> Result<(TextRange, String), Refusal> {
    let (_, range, name) = meant(view, sidecar, at)?;
    Ok((range, name))
}

/// What a name stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Named {
    Variable(Variable),
    /// An attribute of a class of the program.
    Attribute,
    /// An entry of the sidecar that the program does not use.
    Entry,
}

/// What is meant, where it stands, and its name.
fn meant(view: &View, sidecar: Option<TemplateText>, at: At) -> Result<(Named, TextRange, String), Refusal> {
    if !view.program.parsed.is_complete() {
        return refuse("the program has syntax errors: correct them first");
    }
    let template = sidecar.map(|sidecar| sidecar.template);
    let (variable, range) = match at {
        At::Program(offset) if let Some((name, range)) = attributes::name_at(view, offset) => {
            attributes::places(view, name).map_err(Refusal)?;
            return Ok((Named::Attribute, range, name.to_string()));
        }
        At::Program(offset) => variable_at(view, offset).ok_or(Refusal("there is no name here that could be changed".into()))?,
        At::Template(offset) => {
            let Some(entry) = template.and_then(|template| entry_at(template, offset)) else {
                return refuse("there is no id here");
            };
            let named = variable_of_id(view, &entry.id).map_or(Named::Entry, Named::Variable);
            return Ok((named, inner(entry.id_range, sidecar), entry.id.clone()));
        }
    };
    let name = view.program.parsed.scopes.name(variable.name).to_string();
    let all = occurrences_of(view, variable);
    let bound = all.iter().any(|found| found.role == Role::Bind) || entry_of(view, template, variable).is_some();
    if !bound {
        return refuse(if docs::global(&name).is_some() {
            format!("{name} belongs to the language")
        } else {
            format!("nothing binds {name}")
        });
    }
    if all.iter().any(|found| view.slice(found.range) != name) {
        return refuse(format!("{name} is not written like that everywhere"));
    }
    Ok((Named::Variable(variable), range, name))
}

/// The id without its quotes.
fn inner(range: TextRange, sidecar: Option<TemplateText>) -> TextRange {
    let text = sidecar.and_then(|sidecar| sidecar.text.get(range.start().to_usize()..range.end().to_usize())).unwrap_or_default();
    let quoted = text.len() >= 2 && text.starts_with('"') && text.ends_with('"');
    if quoted { TextRange::new(range.start() + TextSize::new(1), range.end() - TextSize::new(1)) } else { range }
}

/// The edits that give what stands at a place another name.
///
/// # Errors
/// The name is none, is taken, or the program would mean something else.
pub fn rename(view: &View, sidecar: Option<TemplateText>, at: At, new: &str) -> Result<Rename, Refusal> {
    let (named, _, name) = meant(view, sidecar, at)?;
    allowed(new, &name)?;
    let template = sidecar.map(|sidecar| sidecar.template);
    if template.is_some_and(|template| template.objects.iter().any(|entry| entry.id == new)) {
        return refuse(format!("{new} is an id of the sidecar"));
    }
    let mut edits: Vec<Edit> = Vec::new();
    if named == Named::Attribute {
        if attributes::is_taken(view, new) {
            return refuse(format!("{new} is an attribute already"));
        }
        edits.extend(attributes::places(view, &name).map_err(Refusal)?.into_iter().map(|place| (place.range, new.to_string())));
        verify(view, &edits, new)?;
        return Ok(Rename { program: edits, template: Vec::new() });
    }
    if let Named::Variable(variable) = named {
        let reader = ["globals", "locals", "vars", "dir"].into_iter().find(|reader| is_read(view, reader));
        if let Some(reader) = reader {
            return refuse(format!("{reader}() is used: variables may be looked up by their text"));
        }
        for found in occurrences_of(view, variable) {
            edits.push(edit(view, found, new)?);
        }
        for range in keywords(view, variable, &name, new)? {
            edits.push((range, new.to_string()));
        }
        edits.sort_by_key(|(range, _)| range.start());
        verify(view, &edits, new)?;
    }
    let entry = match named {
        Named::Variable(variable) => entry_of(view, template, variable),
        _ => template.and_then(|template| template.objects.iter().find(|entry| entry.id == name)),
    };
    let template = entry.map(|entry| (inner(entry.id_range, sidecar), new.to_string())).into_iter().collect();
    Ok(Rename { program: edits, template })
}

/// Whether a name may be given.
fn allowed(new: &str, old: &str) -> Result<(), Refusal> {
    let mut chars = new.chars();
    let starts = chars.next().is_some_and(|first| first == '_' || unicode_ident::is_xid_start(first));
    if !starts || !chars.all(unicode_ident::is_xid_continue) || new.len() > 200 {
        return refuse(format!("{new:?} is no name"));
    }
    if new == old {
        return refuse(format!("it is called {new} already"));
    }
    if docs::of("keyword", new).is_some() || ["async", "await", "True", "False", "None"].contains(&new) {
        return refuse(format!("{new} is a keyword of Python"));
    }
    if docs::global(new).is_some() {
        return refuse(format!("{new} belongs to the language"));
    }
    if new.starts_with("__") {
        return refuse(format!("{new} would be a name that Python treats in its own way"));
    }
    Ok(())
}

/// Whether a builtin is used.
fn is_read(view: &View, name: &str) -> bool {
    let scopes = &view.program.parsed.scopes;
    let Some(id) = scopes.name_id(name) else { return false };
    let found = occurrences_of(view, Variable { owner: ScopeId::MODULE, name: id });
    !found.is_empty() && found.iter().all(|found| found.role != Role::Bind)
}

/// The edit of one occurrence: an import keeps the name of what it imports.
fn edit(view: &View, found: &Occurrence, new: &str) -> Result<Edit, Refusal> {
    let nodes = nodes_at(view, found.range.start());
    let imported = nodes.iter().rev().find_map(|node| match node {
        AnyNodeRef::Alias(alias) if alias.range.contains_range(found.range) => Some(*alias),
        _ => None,
    });
    match imported {
        Some(alias) if alias.asname.is_none() && alias.name.id.contains('.') => refuse("a part of a module's name cannot be changed"),
        Some(alias) if alias.asname.is_none() => Ok((TextRange::empty(alias.name.range.end()), format!(" as {new}"))),
        _ => Ok((found.range, new.to_string())),
    }
}

/// Where a parameter is given by its name.
fn keywords(view: &View, variable: Variable, name: &str, new: &str) -> Result<Vec<TextRange>, Refusal> {
    let scopes = &view.program.parsed.scopes;
    let owner = scopes.get(variable.owner);
    let is_parameter = owner.locals.iter().take(owner.parameter_count as usize).any(|local| local == name);
    if !is_parameter || owner.kind.is_comprehension() {
        return Ok(Vec::new());
    }
    let functions = functions(view);
    let def = function_of(view, variable);
    let wild = def.is_none_or(|def| escapes(view, def, &functions));
    let mut ranges = Vec::new();
    for call in calls(view) {
        let called = callee(view, call, &functions);
        let is_it = called.zip(def).is_some_and(|(called, def)| std::ptr::eq(called, def));
        let unknown = wild && called.is_none() && !is_of_the_language(view, call);
        if !is_it && !unknown {
            continue;
        }
        for keyword in &call.arguments.keywords {
            match &keyword.arg {
                None if is_it || unknown => return refuse(format!("{name} may be given through ** at {}", line(view, keyword.range))),
                Some(arg) if arg.id.as_str() == new => return refuse(format!("{new} is given by name at {}", line(view, arg.range))),
                Some(arg) if arg.id.as_str() == name && unknown => {
                    return refuse(format!("what is called with {name}= at {} cannot be told from the text", line(view, arg.range)));
                }
                Some(arg) if arg.id.as_str() == name => ranges.push(arg.range),
                _ => {}
            }
        }
    }
    Ok(ranges)
}

/// Whether a function may be called where its name does not stand.
fn escapes(view: &View, def: &ast::StmtFunctionDef, functions: &[&ast::StmtFunctionDef]) -> bool {
    if !def.decorator_list.is_empty() || named_function(view, def.name.range, functions).is_none() {
        return true;
    }
    let Some((variable, _)) = variable_at(view, def.name.range.start()) else { return true };
    if view.program.parsed.scopes.get(variable.owner).kind == ScopeKind::Class {
        return true;
    }
    let called: Vec<TextRange> = calls(view).iter().map(|call| call.func.range()).collect();
    occurrences_of(view, variable).iter().any(|found| found.role == Role::Load && !called.contains(&found.range))
}

/// Whether a call is one of a name of PSDL or of Python.
fn is_of_the_language(view: &View, call: &ast::ExprCall) -> bool {
    match call.func.as_ref() {
        Expr::Name(name) => docs::global(&name.id).is_some() && is_read(view, &name.id) && name.id != "map" && name.id != "super",
        Expr::Attribute(attribute) => module_of(view, &attribute.value).is_some_and(|module| module != "functools" && module != "operator"),
        _ => false,
    }
}

fn line(view: &View, range: TextRange) -> String {
    format!("line {}", LineIndex::new(view.text()).line(range.start()) + 1)
}

/// Reads the new text: each name must mean what it meant before.
fn verify(view: &View, edits: &[Edit], new: &str) -> Result<(), Refusal> {
    let mut text = view.text().to_string();
    for (range, replacement) in edits.iter().rev() {
        text.replace_range(range.start().to_usize()..range.end().to_usize(), replacement);
    }
    let program = Program::read(text.into());
    if !program.parsed.is_complete() {
        return refuse(format!("with {new} the program would have syntax errors"));
    }
    let after = View::new(&program, None);
    let ordered = |view: &View| {
        let mut all: Vec<Occurrence> = view.program.parsed.scopes.occurrences().to_vec();
        all.sort_by_key(|found| (found.range.start(), found.range.end()));
        all
    };
    let (old, now) = (ordered(view), ordered(&after));
    let (mut forth, mut back) = (FxHashMap::default(), FxHashMap::default());
    let same = old.len() == now.len();
    let clash = old.iter().zip(&now).find(|(old, now)| {
        let (from, to) = (variable_of(view, old), variable_of(&after, now));
        old.role != now.role || *forth.entry(from).or_insert(to) != to || *back.entry(to).or_insert(from) != from
    });
    match clash {
        Some((old, _)) => refuse(format!("{new} means something else at {}", line(view, old.range))),
        None if !same => refuse(format!("{new} would change what other names mean")),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    fn renamed(marked: &str, new: &str) -> Result<String, String> {
        let fixture = Fixture::new(marked);
        let rename = rename(&fixture.view(), None, At::Program(fixture.offset), new).map_err(|refusal| refusal.0)?;
        let mut text = fixture.text().to_string();
        for (range, new) in rename.program.iter().rev() {
            text.replace_range(range.start().to_usize()..range.end().to_usize(), new);
        }
        Ok(text)
    }

    fn check(marked: &str, new: &str, expected: &str) {
        assert_eq!(renamed(marked, new).as_deref(), Ok(expected), "{marked}");
    }

    fn refused(marked: &str, new: &str, why: &str) {
        let refusal = renamed(marked, new).expect_err(marked);
        assert!(refusal.contains(why), "{marked}: {refusal}");
    }

    #[test]
    fn a_variable_is_renamed_where_it_is_that_variable() {
        check(
            "ga$0p = 1\ndef f(gap):\n    return gap\ndef g():\n    global gap\n    gap = 2\nprint(f'{gap}', [gap for _ in 'a'])\n",
            "space",
            "space = 1\ndef f(gap):\n    return gap\ndef g():\n    global space\n    space = 2\nprint(f'{space}', [space for _ in 'a'])\n",
        );
        check("x = [i$0 + 1 for i in range(3)]\ni = 5\n", "n", "x = [n + 1 for n in range(3)]\ni = 5\n");
        check(
            "def f():\n    n$0 = 1\n    def g():\n        nonlocal n\n        n += 1\n    return g\n",
            "m",
            "def f():\n    m = 1\n    def g():\n        nonlocal m\n        m += 1\n    return g\n",
        );
    }

    #[test]
    fn keyword_arguments_go_with_their_parameter() {
        check(
            "def row(a, gap=1):\n    return gap\nrow(1, ga$0p=2)\ndict(gap=3)\n",
            "space",
            "def row(a, space=1):\n    return space\nrow(1, space=2)\ndict(gap=3)\n",
        );
        refused("def row(a, gap=1):\n    return ga$0p\nf = row\nf(1, gap=2)\n", "space", "cannot be told");
        refused("def row(a, gap=1):\n    return ga$0p\nrow(**{'a': 1})\n", "space", "through **");
        refused("def row(a, gap=1, **more):\n    return ga$0p\nrow(1, space=2)\n", "space", "given by name");
    }

    const CLASS: &str = "from dataclasses import dataclass\n@dataclass\nclass Slot:\n    gap: float = 0.5\n    def twice(self):\n        return self.gap * 2\n";

    #[test]
    fn an_attribute_is_renamed_where_one_family_of_classes_has_it() {
        let expected = CLASS.replace("gap", "space");
        check(
            &format!("{CLASS}s = Slot(ga$0p=1)\nprint(s.gap, s.twice())\n"),
            "space",
            &format!("{expected}s = Slot(space=1)\nprint(s.space, s.twice())\n"),
        );
        check(
            &format!("{CLASS}class Wide(Slot):\n    pass\nprint(Wide(gap=2).gap$0)\n"),
            "space",
            &format!("{expected}class Wide(Slot):\n    pass\nprint(Wide(space=2).space)\n"),
        );
        check(
            "class C:\n    n$0 = 1\n    m = n\n    def __init__(self, n):\n        self.n = n\nprint(C(n=2).n, C.n)\n",
            "k",
            "class C:\n    k = 1\n    m = k\n    def __init__(self, n):\n        self.k = n\nprint(C(n=2).k, C.k)\n",
        );
        check(
            "class C:\n    def put$0(self):\n        pass\nC().put()\n",
            "place",
            "class C:\n    def place(self):\n        pass\nC().place()\n",
        );
    }

    #[test]
    fn an_attribute_that_cannot_be_told_apart_keeps_its_name() {
        refused(&format!("{CLASS}class Other:\n    gap = 1\nprint(Slot().ga$0p)\n"), "space", "both have an attribute gap");
        refused(&format!("{CLASS}print(getattr(Slot(), 'gap').ga$0p)\n"), "space", "looked up by their text");
        refused(&format!("{CLASS}make = Slot\nprint(make(gap=1).ga$0p)\n"), "space", "cannot be told");
        refused(&format!("{CLASS}print(Slot(**{{'gap': 1}}).ga$0p)\n"), "space", "through **");
        refused(&format!("{CLASS}print(Slot().ga$0p)\n"), "twice", "attribute already");
        refused("from enum import Enum\nclass C(Enum):\n    RED$0 = 1\n", "BLUE", "inherits from `Enum`");
        refused("class C:\n    width$0 = 1\n", "w", "belongs to the language");
        refused("scene.width$0\n", "w", "belongs to the language");
        refused("x = object()\nx.n$0\n", "w", "no class of the program");
    }

    #[test]
    fn an_import_keeps_what_it_imports() {
        check("import itertools\nitertool$0s.count()\n", "it", "import itertools as it\nit.count()\n");
        check("from math import sin as s\ns$0(1)\n", "sine", "from math import sin as sine\nsine(1)\n");
    }

    #[test]
    fn names_that_would_mean_something_else_are_refused() {
        refused("a$0 = 1\nb = 2\n", "b", "means something else");
        refused("a$0 = 1\ndef f(b):\n    return a\n", "b", "means something else");
        refused("a$0 = 1\n", "for", "keyword");
        refused("a$0 = 1\n", "len", "belongs to the language");
        refused("a$0 = 1\n", "2x", "no name");
        refused("a$0 = 1\n", "a", "already");
        refused("scen$0e.width\n", "room", "belongs to the language");
        refused("a$0 = 1\nprint(globals()['a'])\n", "b", "looked up by their text");
        refused("a$0 = (\n", "b", "syntax errors");
    }

    #[test]
    fn an_id_of_the_sidecar_is_renamed_in_both_files() {
        let template = r#"{"title": "Room", "width": 4, "depth": 4, "height": 3, "interior": true, "objects": [{"id": "desk", "name": "Desk", "width": 1, "depth": 1, "height": 1, "support": "STANDING"}, {"id": "lamp", "name": "Lamp", "width": 1, "depth": 1, "height": 1, "support": "STANDING"}]}"#;
        let fixture = Fixture::with_template("desk.min.x = 0.5\ndes$0k.min.y = 0.5\n", Some(template));
        let read = fixture.scene.as_ref().and_then(|scene| scene.template.as_ref()).unwrap();
        let sidecar = Some(TemplateText { text: template, template: read });
        let both = rename(&fixture.view(), sidecar, At::Program(fixture.offset), "table").unwrap();
        let id = u32::try_from(template.find("desk").unwrap()).unwrap();
        assert_eq!((both.program.len(), &both.template[..]), (2, &[(TextRange::at(id.into(), 4.into()), "table".to_string())][..]));
        assert_eq!(rename(&fixture.view(), sidecar, At::Template(id.into()), "table").unwrap(), both);
        assert!(rename(&fixture.view(), sidecar, At::Program(fixture.offset), "lamp").unwrap_err().0.contains("id of the sidecar"));
    }
}
