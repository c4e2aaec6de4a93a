//! What can be written at a place: what the scene has, what the language has, and whole placements.

use super::context::{Call, Context, Place, context};
use super::docs::{self, Doc};
use super::find::functions;
use super::hover::signature;
use super::names::parameters;
use super::program::{Program, Scene, View};
use super::snippets::{self, Placement};
use super::symbols::variables;
use super::values::Values;
use super::words;
use crate::scene::Anchor;
use crate::syntax::ast::{Expr, Stmt};
use crate::syntax::tune::Cardinal;
use ruff_text_size::{TextRange, TextSize};

/// What an entry is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CompletionKind {
    /// An object, or a list of some.
    Object,
    /// A variable.
    Variable,
    /// A function.
    Function,
    /// A method.
    Method,
    /// An attribute.
    Property,
    /// A class.
    Class,
    /// A module.
    Module,
    /// A direction or a support.
    Constant,
    /// A word of the language.
    Keyword,
    /// A keyword argument.
    Argument,
    /// A whole placement.
    Snippet,
}

/// An entry.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Completion {
    /// What is shown, and what is typed to find it.
    pub label: String,
    /// A few words about it.
    pub detail: String,
    /// What it is.
    pub kind: CompletionKind,
    /// What replaces the word before the place, as a snippet where `is_snippet`.
    pub insert: String,
    /// `$1` and the like are places to fill in.
    pub is_snippet: bool,
    /// The best have the smallest.
    pub rank: u8,
    /// Its owner and name in the tables of documentation.
    pub doc: Option<(&'static str, &'static str)>,
}

/// The entries, and the word that they replace.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Completions {
    /// The word before the place.
    pub replaces: TextRange,
    /// The best first.
    pub items: Vec<Completion>,
}

/// What can be written at a place.
pub fn completions(view: &View, offset: TextSize) -> Completions {
    // What lies behind the end means the end, and the middle of a character its start.
    let text = view.text();
    let offset = TextSize::of(&text[..text.floor_char_boundary(offset.to_usize())]);
    let context = context(text, offset.to_usize());
    let mut items = Vec::new();
    match context.place {
        Place::Nowhere | Place::NewName => {}
        Place::Member(receiver) => members(view, receiver, offset, &mut items),
        Place::Facing => {
            directions(view, &mut items);
            names(view, offset, &mut items);
        }
        Place::Support => {
            items.extend(["STANDING", "MOUNTED", "FLOATING"].into_iter().filter_map(|name| global(docs::of("scene", name)?, 0)))
        }
        Place::Import => items.extend(docs::owned("module").map(|doc| entry(doc, CompletionKind::Module, 0))),
        Place::From(module) => items.extend(docs::owned(module).map(|doc| member(doc, 0, false))),
        Place::Expression => expression(view, &context, offset, &mut items),
    }
    let prefix = context.prefix.to_lowercase();
    items.retain(|item| is_inside(&prefix, &item.label));
    items.sort_by(|a, b| (a.rank, &a.label).cmp(&(b.rank, &b.label)));
    items.dedup_by(|a, b| a.label == b.label && a.kind == b.kind);
    let length = TextSize::of(context.prefix).min(offset);
    Completions { replaces: TextRange::new(offset - length, offset), items }
}

/// Whether the letters of a word occur in a text in this order.
fn is_inside(prefix: &str, label: &str) -> bool {
    let mut letters = label.chars().flat_map(char::to_lowercase);
    prefix.chars().all(|letter| letters.any(|other| other == letter))
}

fn plain(label: impl Into<String>, kind: CompletionKind, rank: u8) -> Completion {
    let label = label.into();
    Completion { insert: label.clone(), label, detail: String::new(), kind, is_snippet: false, rank, doc: None }
}

fn entry(doc: &'static Doc, kind: CompletionKind, rank: u8) -> Completion {
    Completion { detail: doc.signature.to_string(), doc: Some((doc.owner, doc.name)), ..plain(doc.name, kind, rank) }
}

/// A function that is called right away: with the cursor between its brackets.
fn called(item: Completion, has_parameters: bool) -> Completion {
    let insert = if has_parameters { format!("{}($0)", item.label) } else { format!("{}()$0", item.label) };
    Completion { insert, is_snippet: true, ..item }
}

/// What a module or a type has.
fn member(doc: &'static Doc, rank: u8, call: bool) -> Completion {
    match doc.is_callable() {
        true if call => called(entry(doc, CompletionKind::Method, rank), !doc.parameters().is_empty()),
        true => entry(doc, CompletionKind::Function, rank),
        false => entry(doc, CompletionKind::Property, rank),
    }
}

/// What every program has.
fn global(doc: &'static Doc, rank: u8) -> Option<Completion> {
    let item = match (doc.owner, doc.name) {
        (_, "Object" | "Door" | "Window") => snippets::constructor(doc.name).map(|insert| Completion {
            insert,
            is_snippet: true,
            ..entry(doc, CompletionKind::Function, rank)
        })?,
        (_, "math" | "random") => entry(doc, CompletionKind::Module, rank),
        ("exception", _) | (_, "Facing" | "Support") => entry(doc, CompletionKind::Class, rank),
        (_, "scene" | "CENTER") => entry(doc, CompletionKind::Object, rank),
        _ if doc.is_callable() => called(entry(doc, CompletionKind::Function, rank), !doc.parameters().is_empty()),
        _ => entry(doc, CompletionKind::Constant, rank),
    };
    Some(item)
}

/// The four directions, spelled as in the file.
fn directions(view: &View, items: &mut Vec<Completion>) {
    for cardinal in Cardinal::ALL {
        let name = crate::syntax::tune::Spelling::Max.spell(cardinal);
        let spelled = view.program.tuning.spelling.spell(cardinal);
        let doc = docs::of("scene", name);
        let detail = doc.map(|doc| doc.text.split(',').next().unwrap_or_default().to_string()).unwrap_or_default();
        let label = if spelled.starts_with(|ch: char| ch.is_ascii_digit()) { name } else { spelled };
        items.push(Completion { detail, doc: doc.map(|doc| (doc.owner, doc.name)), ..plain(label, CompletionKind::Constant, 0) });
    }
}

/// The variables that can be seen.
fn names(view: &View, offset: TextSize, items: &mut Vec<Completion>) {
    for (name, objects) in variables(view, offset) {
        let detail = view.scene.map(|scene| about(scene, &objects)).unwrap_or_default();
        let kind = if objects.is_empty() { CompletionKind::Variable } else { CompletionKind::Object };
        items.push(Completion { detail, ..plain(name, kind, if objects.is_empty() { 2 } else { 1 }) });
    }
    for def in functions(view) {
        let detail = signature(view, def).trim_start_matches("def ").to_string();
        items.retain(|item| item.label != def.name.as_str());
        let item = Completion { detail, ..plain(def.name.as_str(), CompletionKind::Function, 2) };
        items.push(called(item, !def.parameters.is_empty()));
    }
    items.extend(docs::of("scene", "scene").and_then(|doc| global(doc, 1)));
}

/// Objects in a few words.
fn about(scene: &Scene, objects: &[usize]) -> String {
    match objects {
        [] => String::new(),
        [object] => scene.object(*object).map(|object| format!("{}, {}", object.name, words::size(object))).unwrap_or_default(),
        [first, ..] => {
            let name = scene.object(*first).map(|object| object.name.clone()).unwrap_or_default();
            format!("{} × {name}", objects.len())
        }
    }
}

fn expression(view: &View, context: &Context, offset: TextSize, items: &mut Vec<Completion>) {
    if let Some(call) = context.call.as_ref().filter(|call| call.is_innermost) {
        arguments(view, call, items);
    }
    names(view, offset, items);
    let bound: Vec<String> = items.iter().map(|item| item.label.clone()).collect();
    for doc in docs::globals().filter(|doc| !bound.iter().any(|name| name == doc.name)) {
        let rank = match doc.owner {
            "scene" => 3,
            "exception" => 7,
            _ => 5,
        };
        items.extend(global(doc, rank));
    }
    items.extend(docs::owned("keyword").map(|doc| entry(doc, CompletionKind::Keyword, 6)));
    if context.first {
        placements(view, items);
    }
}

/// The keyword arguments that a call does not have yet.
fn arguments(view: &View, call: &Call, items: &mut Vec<Completion>) {
    let (last, before) = match call.arguments.split_last() {
        Some((last, before)) => (*last, before),
        None => ("", &[][..]),
    };
    if last.contains('=') {
        return;
    }
    let given: Vec<&str> = before.iter().filter_map(|argument| Call::keyword(argument)).collect();
    let by_place = before.len() - given.len();
    let names: Vec<(String, Option<&'static Doc>)> = match functions(view).iter().rev().find(|def| def.name.as_str() == call.callee) {
        Some(def) => parameters(def).map(|parameter| (parameter.name.to_string(), None)).collect(),
        None => {
            let parameters = docs::global(call.callee).map(Doc::parameters).unwrap_or_default();
            let named = parameters.into_iter().filter(|text| !text.starts_with('*')).map(|text| text.split('=').next().unwrap_or(text));
            let scene = docs::of("scene", call.callee).is_some();
            named.map(|name| (name.to_string(), docs::of("parameter", name).filter(|_| scene))).collect()
        }
    };
    let is_builtin = docs::of("builtin", call.callee).is_some();
    for (name, doc) in names.into_iter().skip(if is_builtin { 0 } else { by_place }) {
        if !given.contains(&name.as_str()) {
            let detail = doc.map(|doc| doc.text.to_string()).unwrap_or_default();
            let item = plain(format!("{name}="), CompletionKind::Argument, 0);
            items.push(Completion { detail, doc: doc.map(|doc| (doc.owner, doc.name)), ..item });
        }
    }
}

/// Whole placements, about the objects that are there; those that are not placed yet first.
fn placements(view: &View, items: &mut Vec<Completion>) {
    let Some(scene) = view.scene else { return };
    let mut single: Vec<(bool, String)> = Vec::new();
    let mut lists: Vec<(bool, String)> = Vec::new();
    for object in &scene.layout.objects {
        let placed = object.body.is_placed();
        match object.path.split_once('[') {
            None if !object.path.contains([' ', '.', '(']) => single.push((placed, object.path.clone())),
            Some((list, index)) if index.starts_with('0') => lists.push((placed, list.to_string())),
            _ => {}
        }
    }
    for names in [&mut single, &mut lists] {
        names.sort_by_key(|(placed, _)| *placed);
        names.truncate(20);
    }
    let only = |names: Vec<(bool, String)>| names.into_iter().map(|(_, name)| name).collect::<Vec<_>>();
    let (single, lists) = (only(single), only(lists));
    for placement in Placement::ALL {
        let insert = placement.snippet(&single, &lists);
        let detail = placement.detail().to_string();
        items.push(Completion { insert, detail, is_snippet: true, ..plain(placement.label(), CompletionKind::Snippet, 4) });
    }
}

/// What comes behind a dot.
fn members(view: &View, receiver: &str, offset: TextSize, items: &mut Vec<Completion>) {
    let last = receiver.rsplit('.').next().unwrap_or(receiver);
    if receiver == "Facing" || receiver == "Support" {
        let names: &[&str] = if receiver == "Facing" {
            &["X_MAX", "Y_MAX", "X_MIN", "Y_MIN", "X_POS", "Y_POS", "X_NEG", "Y_NEG"]
        } else {
            &["STANDING", "MOUNTED", "WALL_MOUNTED", "FLOATING"]
        };
        return items.extend(names.iter().filter_map(|name| Some(entry(docs::of("scene", name)?, CompletionKind::Constant, 0))));
    }
    if let Some(module) = module(view, receiver) {
        return items.extend(docs::owned(module).map(|doc| member(doc, 0, true)));
    }
    if Anchor::from_name(last).is_some() && receiver.contains('.') || receiver.starts_with("Vec(") {
        return items.extend(docs::owned("vector").map(|doc| entry(doc, CompletionKind::Property, 0)));
    }
    let kind = literal(receiver);
    if let Some(owner) = kind {
        return items.extend(docs::owned(owner).map(|doc| member(doc, 0, true)));
    }
    let found = receiver_objects(view, receiver, offset);
    if receiver == "scene" || receiver == "CENTER" || matches!(found, Found::Object) {
        return items.extend(docs::owned("object").map(|doc| entry(doc, CompletionKind::Property, 0)));
    }
    match found {
        Found::List => items.extend(docs::owned("list").map(|doc| member(doc, 0, true))),
        Found::Dict => items.extend(docs::owned("dict").map(|doc| member(doc, 0, true))),
        Found::Fields(fields) => items.extend(fields.into_iter().map(|field| plain(field, CompletionKind::Property, 0))),
        Found::Object | Found::Nothing => {
            items.extend(docs::owned("object").map(|doc| entry(doc, CompletionKind::Property, 0)));
            for owner in docs::TYPES {
                items.extend(docs::owned(owner).map(|doc| member(doc, 5, true)));
            }
        }
    }
}

/// The module that a name stands for.
fn module<'a>(view: &View<'a>, receiver: &'a str) -> Option<&'a str> {
    let imports = view.program.parsed.module.body.iter().filter_map(|stmt| match stmt {
        Stmt::Import(import) => Some(&import.names),
        _ => None,
    });
    let mut aliases = imports.flatten();
    let named = aliases.find(|alias| alias.asname.as_ref().unwrap_or(&alias.name).id == receiver);
    let module = named.map(|alias| alias.name.id.as_str()).or_else(|| ["math", "random"].into_iter().find(|name| *name == receiver));
    module.filter(|name| docs::is_module(name))
}

/// The type of a literal.
fn literal(receiver: &str) -> Option<&'static str> {
    match receiver.as_bytes().first()? {
        b'"' | b'\'' => Some("str"),
        b'[' => Some("list"),
        b'(' => Some("tuple"),
        _ => None,
    }
}

/// What a receiver stands for.
enum Found {
    Object,
    List,
    Dict,
    Fields(Vec<String>),
    Nothing,
}

fn receiver_objects(view: &View, receiver: &str, offset: TextSize) -> Found {
    let Some(scene) = view.scene else { return Found::Nothing };
    let values = Values::new(*view);
    let objects = values.at_path(receiver);
    let paths: Vec<&str> = objects.iter().filter_map(|index| scene.object(*index)).map(|object| object.path.as_str()).collect();
    if let Some(first) = paths.first() {
        return match first[receiver.len()..].chars().next() {
            None => Found::Object,
            Some('[') if first[receiver.len()..].starts_with('[') && first.as_bytes().get(receiver.len() + 1) == Some(&b'\'') => {
                Found::Dict
            }
            Some('[') => Found::List,
            _ => Found::Fields(fields(&paths, receiver)),
        };
    }
    let read = Program::read(receiver.into());
    let root = read.parsed.module.body.first().and_then(|stmt| match stmt {
        Stmt::Expr(expr) => super::find::root(&expr.value).cloned().map(Expr::Name),
        _ => None,
    });
    let Some(Expr::Name(name)) = root else { return Found::Nothing };
    let scopes = &view.program.parsed.scopes;
    let variable = scopes.name_id(&name.id).and_then(|id| {
        let mut at = Some(scopes.at(offset));
        std::iter::from_fn(|| {
            let scope = at?;
            at = scopes.get(scope).parent;
            Some(scopes.variable(scope, id))
        })
        .flatten()
        .next()
    });
    match variable.map(|variable| values.of_variable(variable)) {
        Some(objects) if !objects.is_empty() => Found::Object,
        _ => Found::Nothing,
    }
}

/// The attributes of an instance that lead to objects.
fn fields(paths: &[&str], receiver: &str) -> Vec<String> {
    let mut fields: Vec<String> = Vec::new();
    for path in paths {
        let rest = path.get(receiver.len() + 1..).unwrap_or_default();
        let field = rest.split(['.', '[']).next().unwrap_or_default();
        if !field.is_empty() && !fields.iter().any(|known| known == field) {
            fields.push(field.to_string());
        }
    }
    fields
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    const SCENE: &str = "bed = Object('Bed', 2, 2, 1)\nchairs = [Object('Chair', 1, 1, 1) for _ in range(2)]\ngap = 0.5\n";

    /// The first entries at the `$0`, behind the scene.
    fn first(marked: &str, count: usize) -> Vec<String> {
        let fixture = Fixture::stale(SCENE, &format!("{SCENE}{marked}"));
        completions(&fixture.view(), fixture.offset).items.into_iter().map(|item| item.label).take(count).collect()
    }

    fn all(marked: &str) -> Vec<String> {
        first(marked, usize::MAX)
    }

    #[test]
    fn directions_come_first_behind_facing() {
        assert_eq!(first("bed.facing = $0\n", 7), ["X_MAX", "X_MIN", "Y_MAX", "Y_MIN", "bed", "chairs", "scene"]);
        assert_eq!(first("bed.facing = Y_$0", 2), ["Y_MAX", "Y_MIN"]);
    }

    #[test]
    fn objects_have_their_members() {
        assert_eq!(first("bed.$0\n", 3), ["center", "depth", "facing"]);
        assert_eq!(all("bed.ma$0\n"), ["max"]);
        assert_eq!(all("x = (bed.min.$0\n"), ["x", "y", "z"]);
        assert_eq!(all("for c in chairs:\n    c.fac$0"), ["facing"]);
        assert!(all("chairs.$0").contains(&"append".to_string()));
        assert!(all("chairs[0].$0").contains(&"min".to_string()) && !all("chairs[0].$0").contains(&"append".to_string()));
        assert_eq!(all("math.atan$0"), ["atan", "atan2", "atanh"]);
        assert!(all("Facing.$0").contains(&"X_NEG".to_string()));
    }

    #[test]
    fn calls_offer_the_arguments_that_are_missing() {
        assert_eq!(first("t = Object('T', width=1, $0", 4), ["color=", "depth=", "dynamic=", "height="]);
        assert_eq!(first("t = Object('T', support=$0", 3), ["FLOATING", "MOUNTED", "STANDING"]);
        assert_eq!(first("def put(o, gap=1): pass\nput(bed, $0", 1), ["gap="]);
        assert!(!all("def put(o, gap=1): pass\nput([$0").contains(&"gap=".to_string()));
    }

    #[test]
    fn names_are_those_of_the_scene_first() {
        assert_eq!(first("x = $0\n", 4), ["bed", "chairs", "scene", "gap"]);
        assert!(all("x = rang$0\n").contains(&"range".to_string()));
        assert!(all("x = 'be$0").is_empty() && all("# be$0").is_empty());
        assert!(all("print(f'{be$0").contains(&"bed".to_string()) && all("print(f'{bed} be$0").is_empty());
        assert_eq!(all("print(f'{bed.mi$0}')\n"), ["min"]);
    }

    #[test]
    fn a_line_that_begins_can_be_a_placement() {
        assert!(all("agai$0\n").contains(&"against a wall".to_string()));
        assert!(!all("x = agai$0\n").contains(&"against a wall".to_string()));
        assert_eq!(all("from copy import de$0"), ["deepcopy"]);
        assert!(all("import ma$0").contains(&"math".to_string()));
    }
}
