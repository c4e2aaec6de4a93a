//! Which objects an expression stands for, as far as the text and the last run tell.
//!
//! A global is asked for by the paths of the objects; other names by what they are bound to; and a statement that places
//! something by what it did. What cannot be told apart is told together: in a loop, all that the line made.

use super::find::{for_each_node, occurrences_of, variable_of};
use super::program::{Deed, Mark, View};
use crate::scene::Anchor;
use crate::syntax::ScopeId;
use crate::syntax::ast::{self, AnyNodeRef, Expr, Ranged as _};
use crate::syntax::scope::{Occurrence, Role, Variable};
use ruff_text_size::TextRange;
use rustc_hash::FxHashMap;

/// How far names are followed.
const MAX_DEPTH: usize = 16;

/// What a name is bound to at one place.
#[derive(Clone, Copy, Debug)]
enum Source<'a> {
    /// A value.
    Value(&'a Expr),
    /// Each of the items of a value.
    Items(&'a Expr),
    /// An argument of a function: its name, and its place.
    Argument { function: TextRange, index: usize },
}

/// What is known about the values of a program.
#[derive(Debug)]
pub(super) struct Values<'a> {
    view: View<'a>,
    /// See [`View::marks`].
    pub(super) marks: Vec<Mark>,
    /// What names are bound to, by where they stand.
    bindings: FxHashMap<TextRange, Source<'a>>,
    calls: Vec<&'a ast::ExprCall>,
    /// Where the names of functions stand, each with the place of its `def` among the functions.
    called: FxHashMap<TextRange, usize>,
    occurrences: FxHashMap<TextRange, &'a Occurrence>,
    /// Each `def` of the program.
    pub(super) functions: Vec<&'a ast::StmtFunctionDef>,
}

impl<'a> Values<'a> {
    pub(super) fn new(view: View<'a>) -> Values<'a> {
        let occurrences = view.program.parsed.scopes.occurrences().iter().map(|found| (found.range, found)).collect();
        let mut values = Values {
            view,
            marks: view.marks(),
            bindings: FxHashMap::default(),
            calls: Vec::new(),
            called: FxHashMap::default(),
            occurrences,
            functions: Vec::new(),
        };
        for_each_node(&view, &mut |node| values.note(node));
        for (index, def) in values.functions.iter().enumerate() {
            let variable = values.occurrences.get(&def.name.range).and_then(|found| variable_of(&view, found));
            let named = variable.map(|variable| occurrences_of(&view, variable)).unwrap_or_default();
            if named.iter().filter(|found| found.role == Role::Bind).count() == 1 {
                values.called.extend(named.iter().map(|found| (found.range, index)));
            }
        }
        values
    }

    /// Notes what a node binds.
    fn note(&mut self, node: AnyNodeRef<'a>) {
        match node {
            AnyNodeRef::StmtAssign(assign) => assign.targets.iter().for_each(|target| self.unpack(target, Source::Value(&assign.value))),
            AnyNodeRef::StmtAugAssign(assign) => self.unpack(&assign.target, Source::Value(&assign.value)),
            AnyNodeRef::StmtAnnAssign(assign) => {
                assign.value.iter().for_each(|value| self.unpack(&assign.target, Source::Value(value)));
            }
            AnyNodeRef::ExprNamed(named) => self.unpack(&named.target, Source::Value(&named.value)),
            AnyNodeRef::StmtFor(each) => self.unpack(&each.target, Source::Items(&each.iter)),
            AnyNodeRef::Comprehension(each) => self.unpack(&each.target, Source::Items(&each.iter)),
            AnyNodeRef::StmtFunctionDef(def) => {
                for (index, parameter) in def.parameters.iter_non_variadic_params().enumerate() {
                    let source = Source::Argument { function: def.name.range, index };
                    self.bindings.insert(parameter.parameter.name.range, source);
                }
                self.functions.push(def);
            }
            AnyNodeRef::ExprCall(call) => self.calls.push(call),
            _ => {}
        }
    }

    /// Notes the names of a target, each with its part of the value where that can be told.
    fn unpack(&mut self, target: &'a Expr, source: Source<'a>) {
        let parts = match target {
            Expr::Name(name) => {
                self.bindings.insert(name.range, source);
                return;
            }
            Expr::Starred(starred) => return self.unpack(&starred.value, source),
            Expr::Tuple(tuple) => &tuple.elts[..],
            Expr::List(list) => &list.elts[..],
            _ => return,
        };
        for (index, part) in parts.iter().enumerate() {
            if let Some(source) = part_of(source, index) {
                self.unpack(part, source);
            }
        }
    }

    /// The objects that a name or an expression stands for, in the order of the layout.
    pub(super) fn of(&self, expr: &'a Expr) -> Vec<usize> {
        let mut objects = Vec::new();
        self.collect(expr, &mut Vec::new(), &mut objects);
        objects.sort_unstable();
        objects.dedup();
        objects
    }

    /// The objects that a variable stands for.
    pub(super) fn of_variable(&self, variable: Variable) -> Vec<usize> {
        let mut objects = Vec::new();
        self.collect_variable(variable, &mut Vec::new(), &mut objects);
        objects.sort_unstable();
        objects.dedup();
        objects
    }

    /// The objects that a statement of this range did something to, as `deed` says.
    pub(super) fn done_by(&self, range: TextRange, deed: impl Fn(Deed) -> bool) -> Vec<usize> {
        let from = self.marks.partition_point(|mark| (mark.range.start(), mark.range.end()) < (range.start(), range.end()));
        let same = self.marks[from..].iter().take_while(|mark| mark.range == range);
        let mut objects: Vec<usize> = same.filter(|mark| deed(mark.deed)).map(|mark| mark.object).collect();
        objects.sort_unstable();
        objects.dedup();
        objects
    }

    /// The objects to which a path of the program leads: `chairs`, `chairs[3]`.
    pub(super) fn at_path(&self, path: &str) -> Vec<usize> {
        let objects = self.view.scene.map(|scene| scene.layout.objects.as_slice()).unwrap_or_default();
        let inside = |known: &str| known.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with(['[', '.']));
        objects.iter().enumerate().filter(|(_, object)| inside(&object.path)).map(|(index, _)| index).collect()
    }

    fn collect(&self, expr: &'a Expr, seen: &mut Vec<Variable>, found: &mut Vec<usize>) {
        let mut each = |parts: &mut dyn Iterator<Item = &'a Expr>| parts.for_each(|part| self.collect(part, seen, found));
        match expr {
            Expr::Name(name) => {
                let occurrence = self.occurrence(name.range);
                if let Some(variable) = occurrence.and_then(|found| variable_of(&self.view, found)) {
                    self.collect_variable(variable, seen, found);
                }
            }
            Expr::Attribute(attribute) if Anchor::from_name(&attribute.attr).is_some() || is_axis(&attribute.attr) => {
                each(&mut std::iter::once(&*attribute.value));
            }
            Expr::Attribute(ast::ExprAttribute { value, .. }) | Expr::Subscript(ast::ExprSubscript { value, .. }) => {
                match self.path(expr).map(|path| self.at_path(&path)).filter(|objects| !objects.is_empty()) {
                    Some(objects) => found.extend(objects),
                    None => each(&mut std::iter::once(&**value)),
                }
            }
            Expr::Call(call) => {
                let done = self.done_by(call.range(), |deed| deed == Deed::Around);
                if done.is_empty() {
                    self.collect_call(call, seen, found);
                } else {
                    found.extend(done);
                }
            }
            Expr::List(ast::ExprList { elts, .. }) | Expr::Tuple(ast::ExprTuple { elts, .. }) | Expr::Set(ast::ExprSet { elts, .. }) => {
                each(&mut elts.iter());
            }
            Expr::Dict(dict) => each(&mut dict.iter_values()),
            Expr::Starred(starred) => each(&mut std::iter::once(&*starred.value)),
            Expr::Named(named) => each(&mut std::iter::once(&*named.value)),
            Expr::If(choice) => each(&mut [&*choice.body, &*choice.orelse].into_iter()),
            Expr::BinOp(sum) => each(&mut [&*sum.left, &*sum.right].into_iter()),
            Expr::ListComp(ast::ExprListComp { elt, .. }) | Expr::Generator(ast::ExprGenerator { elt, .. }) => {
                each(&mut std::iter::once(&**elt));
            }
            _ => {}
        }
    }

    /// The objects that the calls of a function did something to, and how many calls there are.
    pub(super) fn done_in(&self, function: &ast::StmtFunctionDef) -> (Vec<usize>, usize) {
        let called = |call: &&&ast::ExprCall| self.callee(call).is_some_and(|def| def.name.range == function.name.range);
        let calls: Vec<_> = self.calls.iter().filter(called).collect();
        let mut objects: Vec<usize> = calls.iter().flat_map(|call| self.done_by(call.range(), |deed| deed == Deed::Around)).collect();
        objects.sort_unstable();
        objects.dedup();
        (objects, calls.len())
    }

    /// What a call gives: the object that it declares, or for functions that hand on, what they are given.
    fn collect_call(&self, call: &'a ast::ExprCall, seen: &mut Vec<Variable>, found: &mut Vec<usize>) {
        let Expr::Name(name) = call.func.as_ref() else { return };
        match name.id.as_str() {
            "Object" | "Door" | "Window" => {
                let declared = |mark: &&Mark| mark.deed == Deed::Declared && mark.range.contains_range(call.range());
                let innermost = self.marks.iter().filter(declared).map(|mark| mark.range).min_by_key(|range| range.len());
                found.extend(innermost.into_iter().flat_map(|range| self.done_by(range, |deed| deed == Deed::Declared)));
            }
            "center" | "list" | "tuple" | "sorted" | "reversed" | "enumerate" | "zip" | "iter" | "next" | "max" | "min" => {
                call.arguments.args.iter().for_each(|argument| self.collect(argument, seen, found));
            }
            _ => {}
        }
    }

    fn collect_variable(&self, variable: Variable, seen: &mut Vec<Variable>, found: &mut Vec<usize>) {
        if seen.contains(&variable) || seen.len() >= MAX_DEPTH {
            return;
        }
        seen.push(variable);
        if variable.owner == ScopeId::MODULE {
            found.extend(self.at_path(self.view.program.parsed.scopes.name(variable.name)));
        }
        for occurrence in occurrences_of(&self.view, variable) {
            match self.bindings.get(&occurrence.range) {
                Some(Source::Value(value) | Source::Items(value)) => self.collect(value, seen, found),
                Some(Source::Argument { function, index }) => self.collect_arguments(*function, *index, occurrence.range, seen, found),
                None => {}
            }
        }
        seen.pop();
    }

    /// What a function is called with.
    fn collect_arguments(&self, function: TextRange, index: usize, name: TextRange, seen: &mut Vec<Variable>, found: &mut Vec<usize>) {
        for call in &self.calls {
            if self.callee(call).is_none_or(|def| def.name.range != function) {
                continue;
            }
            let keyword = call
                .arguments
                .keywords
                .iter()
                .find(|keyword| keyword.arg.as_ref().is_some_and(|arg| arg.as_str() == self.view.slice(name)));
            let argument = keyword.map(|keyword| &keyword.value).or_else(|| call.arguments.args.get(index));
            argument.into_iter().for_each(|argument| self.collect(argument, seen, found));
        }
    }

    /// The path that an expression writes out, as objects are called.
    fn path(&self, expr: &Expr) -> Option<String> {
        match expr {
            Expr::Name(name) => Some(name.id.to_string()),
            Expr::Attribute(attribute) => Some(format!("{}.{}", self.path(&attribute.value)?, attribute.attr)),
            Expr::Subscript(subscript) => {
                let base = self.path(&subscript.value)?;
                match subscript.slice.as_ref() {
                    Expr::NumberLiteral(ast::ExprNumberLiteral { value: ast::Number::Int(index), .. }) => Some(format!("{base}[{index}]")),
                    Expr::StringLiteral(key) => Some(format!("{base}[{}]", crate::python::text::repr_str(key.value.to_str()))),
                    Expr::UnaryOp(ast::ExprUnaryOp { op: ast::UnaryOp::USub, operand, .. }) => {
                        let Expr::NumberLiteral(ast::ExprNumberLiteral { value: ast::Number::Int(back), .. }) = operand.as_ref() else {
                            return None;
                        };
                        let index = self.count(&base).checked_sub(back.as_usize()?)?;
                        Some(format!("{base}[{index}]"))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// How many items a list of objects has.
    fn count(&self, base: &str) -> usize {
        let objects = self.view.scene.map(|scene| scene.layout.objects.as_slice()).unwrap_or_default();
        let index = |path: &str| path.strip_prefix(base)?.strip_prefix('[')?.split(']').next()?.parse::<usize>().ok();
        objects.iter().filter_map(|object| index(&object.path)).max().map_or(0, |last| last.saturating_add(1))
    }

    fn occurrence(&self, range: TextRange) -> Option<&'a Occurrence> {
        self.occurrences.get(&range).copied()
    }

    /// The function that a call calls by its name, where the name means only that function.
    pub(super) fn callee(&self, call: &ast::ExprCall) -> Option<&'a ast::StmtFunctionDef> {
        self.called.get(&call.func.range()).map(|index| self.functions[*index])
    }
}

fn is_axis(name: &str) -> bool {
    crate::scene::Axis::from_name(name).is_some()
}

/// A part of what is unpacked; `None` where it is no object.
fn part_of(source: Source<'_>, index: usize) -> Option<Source<'_>> {
    match source {
        Source::Value(Expr::Tuple(ast::ExprTuple { elts, .. }) | Expr::List(ast::ExprList { elts, .. })) => {
            elts.get(index).map(Source::Value)
        }
        Source::Items(Expr::Call(call)) => {
            let argument = |at: usize| call.arguments.args.get(at);
            match call.func.as_ref() {
                Expr::Name(name) if name.id == "enumerate" => argument(0).filter(|_| index == 1).map(Source::Items),
                Expr::Name(name) if name.id == "zip" => argument(index).map(Source::Items),
                Expr::Attribute(method) if method.attr.as_str() == "items" => (index == 1).then_some(Source::Items(&method.value)),
                _ => Some(source),
            }
        }
        // `for a, b in [(chair, 1), (table, 2)]`: of each item its part; the whole list says the same with more than is meant.
        source => Some(source),
    }
}

#[cfg(test)]
mod tests {
    use super::super::find::expressions_at;
    use super::*;
    use crate::ide::tests::Fixture;

    /// The names of the objects of the innermost expression at the `$0`.
    fn check(marked: &str, expected: &[&str]) {
        let fixture = Fixture::new(marked);
        let view = fixture.view();
        let values = Values::new(view);
        let expr = *expressions_at(&view, fixture.offset).last().expect("an expression");
        let scene = fixture.scene.as_ref().expect("a scene");
        let names: Vec<&str> = values.of(expr).into_iter().map(|index| scene.layout.objects[index].path.as_str()).collect();
        assert_eq!(names, expected, "{marked}");
    }

    const SCENE: &str = "bed = Object('Bed', 2, 2, 1)\nchairs = [Object('Chair', 1, 1, 1) for _ in range(3)]\n";

    #[test]
    fn globals_and_their_items() {
        check(&format!("{SCENE}be$0d.min.x = 0.5\n"), &["bed"]);
        check(&format!("{SCENE}chair$0s\n"), &["chairs[0]", "chairs[1]", "chairs[2]"]);
        check(&format!("{SCENE}chairs[1]$0\n"), &["chairs[1]"]);
        check(&format!("{SCENE}chairs[-1]$0\n"), &["chairs[2]"]);
    }

    #[test]
    fn names_of_loops_stand_for_all_that_they_go_through() {
        check(&format!("{SCENE}for i, c in enumerate(chairs):\n    c$0.min.x = i\n"), &["chairs[0]", "chairs[1]", "chairs[2]"]);
        check(&format!("{SCENE}for a, b in zip(chairs, [bed]):\n    b$0.min.x = 1\n"), &["bed"]);
        check(&format!("{SCENE}x = [c$0 for c in chairs]\n"), &["chairs[0]", "chairs[1]", "chairs[2]"]);
    }

    #[test]
    fn arguments_stand_for_what_functions_are_called_with() {
        check(&format!("{SCENE}def put(o, n):\n    o$0.min.x = n\nput(bed, 1)\nput(n=2, o=chairs[0])\n"), &["bed", "chairs[0]"]);
    }

    #[test]
    fn endless_names_end() {
        check(&format!("{SCENE}a = bed\nb = a\na = b\nb$0\n"), &["bed"]);
    }
}
