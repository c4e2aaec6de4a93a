//! Which functions call which, and what they place.

use super::find::{functions, named_function, occurrence_at};
use super::names::calls;
use super::program::View;
use super::values::Values;
use super::words;
use crate::syntax::ast::{self, Ranged as _};
use ruff_text_size::{TextRange, TextSize};

/// A function of the program, or the program itself.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Caller {
    /// Its name.
    pub name: String,
    /// What it placed, in a few words.
    pub detail: String,
    /// All of it.
    pub range: TextRange,
    /// Its name, or nothing at the start for the program itself.
    pub selection: TextRange,
}

/// The function that is defined or called at a place.
pub fn function_at(view: &View, offset: TextSize) -> Option<Caller> {
    let occurrence = occurrence_at(view, offset)?;
    let functions = functions(view);
    named_function(view, occurrence.range, &functions).map(|def| caller(&Values::new(*view), view, def))
}

fn caller(values: &Values, view: &View, def: &ast::StmtFunctionDef) -> Caller {
    let (objects, _) = values.done_in(def);
    let errors = view.scene.map_or(0, |scene| scene.errors_among(&objects));
    let detail = match objects.len() {
        0 => String::new(),
        count => format!("places {} · {}", words::counted(count, "object"), words::counted(errors, "error")),
    };
    Caller { name: def.name.to_string(), detail, range: def.range, selection: def.name.range }
}

/// Who calls a function (by where its name stands in its definition), and where.
pub fn incoming(view: &View, function: TextRange) -> Vec<(Caller, Vec<TextRange>)> {
    let values = Values::new(*view);
    let mut found: Vec<(Caller, Vec<TextRange>)> = Vec::new();
    for call in calls(view) {
        if values.callee(call).is_none_or(|def| def.name.range != function) {
            continue;
        }
        let around = values.functions.iter().filter(|def| def.range.contains_range(call.range()));
        let from = match around.min_by_key(|def| def.range.len()) {
            Some(def) => caller(&values, view, def),
            None => {
                let range = TextRange::up_to(TextSize::of(view.text()));
                Caller { name: "<module>".into(), detail: "the program".into(), range, selection: TextRange::default() }
            }
        };
        add(&mut found, from, call.func.range());
    }
    found
}

/// What a function (by where its name stands in its definition) calls, and where.
pub fn outgoing(view: &View, function: TextRange) -> Vec<(Caller, Vec<TextRange>)> {
    let values = Values::new(*view);
    let Some(def) = values.functions.iter().find(|def| def.name.range == function) else { return Vec::new() };
    let mut found: Vec<(Caller, Vec<TextRange>)> = Vec::new();
    for call in calls(view).into_iter().filter(|call| def.range.contains_range(call.range())) {
        if let Some(called) = values.callee(call) {
            add(&mut found, caller(&values, view, called), call.func.range());
        }
    }
    found
}

fn add(found: &mut Vec<(Caller, Vec<TextRange>)>, caller: Caller, place: TextRange) {
    match found.iter_mut().find(|(known, _)| known.selection == caller.selection) {
        Some((_, places)) => places.push(place),
        None => found.push((caller, vec![place])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    #[test]
    fn functions_that_place_objects() {
        let text = "a = [Object('A', 1, 1, 1) for _ in range(2)]\ndef put(o):\n    o.min.x = 1\ndef row(items):\n    for o in items:\n        pu$0t(o)\nrow(a)\nput(a[0])\n";
        let fixture = Fixture::new(text);
        let view = fixture.view();
        let put = function_at(&view, fixture.offset).unwrap();
        assert_eq!((put.name.as_str(), put.detail.as_str()), ("put", "places 2 objects · 0 errors"));
        let names: Vec<String> = incoming(&view, put.selection).into_iter().map(|(caller, _)| caller.name).collect();
        assert_eq!(names, ["row", "<module>"]);
        let row = incoming(&view, put.selection)[0].0.selection;
        let called: Vec<(String, usize)> = outgoing(&view, row).into_iter().map(|(caller, places)| (caller.name, places.len())).collect();
        assert_eq!(called, [("put".to_string(), 1)]);
    }
}
