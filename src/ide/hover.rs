//! What a place means: an object, a constant, a direction, a name of PSDL or of Python.

use super::constant::integer;
use super::docs::{self, Doc};
use super::find::{
    attribute_at, callee, expressions_at, functions, keyword_at, named_function, nodes_at, occurrence_at, occurrences_of, root,
    statement_at, targets, variable_of,
};
use super::program::{Deed, Scene, View};
use super::values::Values;
use super::words;
use crate::scene::{Anchor, Axis};
use crate::syntax::ast::{self, AnyNodeRef, Expr, Ranged as _};
use crate::syntax::scope::{Occurrence, Role};
use crate::syntax::tune::{DirectionKind, Excluded, Spelling};
use crate::syntax::{ConstantId, ScopeId};
use ruff_text_size::{TextRange, TextSize};

/// Of many objects so many are told one by one.
const MAX_OBJECTS: usize = 8;
/// Of the errors of one object so many are told.
const MAX_ERRORS: usize = 6;

/// What to show.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Hover {
    /// What it is about.
    pub range: TextRange,
    /// What to say, in Markdown.
    pub markdown: String,
    /// The objects that it is about, as indices of the layout: what a picture would show.
    pub objects: Vec<usize>,
    /// The constant that it is about.
    pub constant: Option<ConstantId>,
}

impl Hover {
    fn new(range: TextRange, markdown: impl Into<String>) -> Hover {
        Hover { range, markdown: markdown.into(), objects: Vec::new(), constant: None }
    }
}

/// What is to be said about a place.
pub fn hover(view: &View, offset: TextSize) -> Option<Hover> {
    let nodes = nodes_at(view, offset);
    if let Some((keyword, call)) = keyword_at(&nodes, offset) {
        return parameter(view, keyword, call);
    }
    if let Some(attribute) = attribute_at(&nodes, offset) {
        return attribute_hover(view, attribute, offset);
    }
    if let Some(occurrence) = occurrence_at(view, offset) {
        return name(view, occurrence, &nodes);
    }
    if let Some(found) = constant(view, offset).or_else(|| direction(view, offset)) {
        return Some(found);
    }
    let subscript = expressions_at(view, offset).into_iter().rev().find(|expr| expr.is_subscript_expr());
    let indexed = subscript.and_then(|expr| objects(view, &Values::new(*view).of(expr), view.slice(expr.range()), expr.range()));
    let integer = || integer(view, offset).map(|(range, markdown)| Hover::new(range, markdown));
    indexed.or_else(integer).or_else(|| keyword_of_python(view, offset))
}

/// A float literal that may be tuned, or why it may not.
fn constant(view: &View, offset: TextSize) -> Option<Hover> {
    let constants = &view.program.tuning.constants;
    let at = constants.iter().position(|constant| constant.range.contains_inclusive(offset))?;
    Some(constant_hover(view, ConstantId(u32::try_from(at).ok()?), constants[at].range))
}

fn constant_hover(view: &View, id: ConstantId, range: TextRange) -> Hover {
    let constant = view.program.tuning.constant(id);
    let text = constant.map_or("", |constant| constant.text(view.text()));
    let markdown = match constant.and_then(|constant| constant.excluded) {
        None => format!("{} · a constant that may be tuned", words::code(text)),
        Some(Excluded::Template) => format!("{} · belongs to the template: it is never tuned", words::code(text)),
        Some(Excluded::Pi) => format!("{} · π: it is never tuned", words::code(text)),
        Some(Excluded::Infinite) => format!("{} · infinite: it is never tuned", words::code(text)),
    };
    let free = constant.is_some_and(|constant| constant.excluded.is_none());
    Hover { constant: free.then_some(id), ..Hover::new(range, markdown) }
}

/// A number that names a direction.
fn direction(view: &View, offset: TextSize) -> Option<Hover> {
    let directions = &view.program.tuning.directions;
    directions.iter().find_map(|direction| match direction.kind {
        DirectionKind::Literal(cardinal) if direction.range.contains_inclusive(offset) => {
            let name = Spelling::Max.spell(cardinal);
            Some(Hover::new(direction.range, docs::global(name)?.markdown()))
        }
        _ => None,
    })
}

/// The name of a keyword argument.
fn parameter(view: &View, keyword: &ast::Keyword, call: &ast::ExprCall) -> Option<Hover> {
    let name = keyword.arg.as_ref()?;
    let functions = functions(view);
    if let Some(def) = callee(view, call, &functions) {
        return Some(Hover::new(name.range, format!("```python\n{}\n```\nparameter {}", signature(view, def), words::code(name))));
    }
    let Expr::Name(called) = call.func.as_ref() else { return None };
    let doc = docs::of("parameter", name).filter(|_| docs::of("scene", &called.id).is_some());
    doc.map(|doc| Hover::new(name.range, doc.markdown()))
}

/// `o.min`, `math.sin`, `Facing.X_MAX`, `names.append`.
fn attribute_hover(view: &View, attribute: &ast::ExprAttribute, offset: TextSize) -> Option<Hover> {
    let (name, range) = (attribute.attr.as_str(), attribute.attr.range);
    let told = |docs: Vec<&Doc>| {
        let texts: Vec<String> = docs.iter().take(3).map(|doc| doc.markdown()).collect();
        (!texts.is_empty()).then(|| Hover::new(range, texts.join("\n\n")))
    };
    if let Some(module) = module_of(view, &attribute.value) {
        return told(docs::of(module, name).into_iter().collect());
    }
    if matches!(attribute.value.as_ref(), Expr::Name(owner) if owner.id == "Facing" || owner.id == "Support") {
        return told(docs::of("scene", name).into_iter().collect());
    }
    let geometry = docs::of("object", name).or_else(|| docs::of("vector", name));
    if let Some(doc) = geometry {
        let exprs = expressions_at(view, offset);
        let objects = exprs.last().map(|expr| Values::new(*view).of(expr)).unwrap_or_default();
        let mut markdown = doc.markdown();
        if let (Some(scene), [object]) = (view.scene, &objects[..]) {
            markdown.push_str(&reading(scene, *object, attribute));
        }
        return Some(Hover { objects, ..Hover::new(range, markdown) });
    }
    told(literal_type(&attribute.value).map_or_else(
        || docs::TYPES.iter().filter_map(|owner| docs::of(owner, name)).collect(),
        |owner| docs::of(owner, name).into_iter().collect(),
    ))
}

/// What an attribute of one object is in the end.
fn reading(scene: &Scene, object: usize, attribute: &ast::ExprAttribute) -> String {
    let Some(placed) = scene.object(object) else { return String::new() };
    let corner = |anchor: Anchor| match anchor {
        Anchor::Min => placed.body.min,
        Anchor::Center => placed.body.center,
        Anchor::Max => placed.body.max,
    };
    let of = words::code(&placed.path);
    let outer = match attribute.value.as_ref() {
        Expr::Attribute(outer) => Anchor::from_name(&outer.attr),
        _ => None,
    };
    match (Anchor::from_name(&attribute.attr), outer.zip(Axis::from_name(&attribute.attr))) {
        (Some(anchor), _) => format!("\n\n{of}: {} in the world", words::vector(corner(anchor))),
        (None, Some((anchor, axis))) => format!("\n\n{of}: {} m in the world", words::number(corner(anchor)[axis.index()])),
        _ => match attribute.attr.as_str() {
            "facing" => format!("\n\n{of} {}", words::facing(placed, scene)),
            "width" => format!("\n\n{of}: {} m", words::number(placed.body.dims[0])),
            "depth" => format!("\n\n{of}: {} m", words::number(placed.body.dims[1])),
            "height" => format!("\n\n{of}: {} m", words::number(placed.body.dims[2])),
            _ => String::new(),
        },
    }
}

/// The type of a literal.
fn literal_type(expr: &Expr) -> Option<&'static str> {
    Some(match expr {
        Expr::StringLiteral(_) | Expr::FString(_) => "str",
        Expr::List(_) | Expr::ListComp(_) => "list",
        Expr::Tuple(_) => "tuple",
        Expr::Dict(_) | Expr::DictComp(_) => "dict",
        Expr::Set(_) | Expr::SetComp(_) => "set",
        _ => return None,
    })
}

/// A name of a variable, of PSDL or of Python.
fn name(view: &View, occurrence: &Occurrence, nodes: &[AnyNodeRef]) -> Option<Hover> {
    let range = occurrence.range;
    let text = view.slice(range);
    let variable = variable_of(view, occurrence)?;
    let all = occurrences_of(view, variable);
    let bindings: Vec<TextRange> = all.iter().filter(|found| found.role == Role::Bind).map(|found| found.range).collect();
    let values = Values::new(*view);
    if bindings.is_empty()
        && variable.owner == ScopeId::MODULE
        && let Some(doc) = docs::global(text)
    {
        return Some(named(view, text, doc, range));
    }
    let placed = placed_here(&values, text, nodes);
    if let Some(objects) = placed {
        return self::objects(view, &objects, text, range);
    }
    let exprs = expressions_at(view, range.start());
    let indexed = exprs.iter().rev().find(|expr| matches!(expr, Expr::Subscript(subscript) if subscript.value.range() == range));
    if let Some(expr) = indexed {
        let some = values.of(expr);
        if !some.is_empty() && some.len() < values.of_variable(variable).len() {
            return objects(view, &some, view.slice(expr.range()), expr.range());
        }
    }
    if let Some(def) = named_function(view, range, &values.functions) {
        return Some(function(view, &values, def, range));
    }
    if let Some(found) = objects(view, &values.of_variable(variable), text, range) {
        return Some(found);
    }
    if let Some(module) = bindings.first().and_then(|binding| imported(view, *binding)) {
        return Some(Hover::new(range, module));
    }
    Some(plain_variable(view, text, &bindings, variable.owner == ScopeId::MODULE, range))
}

/// A name that every program has.
fn named(view: &View, text: &str, doc: &Doc, range: TextRange) -> Hover {
    let mut markdown = doc.markdown();
    if let (Some(scene), "scene" | "CENTER") = (view.scene, text) {
        let info = &scene.layout.scene;
        let size = info.size().map(words::number).join(" × ");
        let (objects, errors) = (scene.layout.objects.len(), scene.verdict.counted().count());
        markdown.push_str(&format!("\n\n{size} m · {} · {}", words::counted(objects, "object"), words::counted(errors, "error")));
    }
    Hover::new(range, markdown)
}

/// Where a statement places what the name stands for: the objects that it placed.
fn placed_here(values: &Values, name: &str, nodes: &[AnyNodeRef]) -> Option<Vec<usize>> {
    let statement = statement_at(nodes)?;
    let mut targets = targets(statement).into_iter().filter(|target| target.is_attribute_expr());
    targets.next().filter(|target| targets.next().is_none() && root(target).is_some_and(|root| root.id == name))?;
    let done = values.done_by(statement.range(), |deed| matches!(deed, Deed::Anchored(_) | Deed::Faced));
    (!done.is_empty()).then_some(done)
}

/// What is imported under a name.
fn imported(view: &View, binding: TextRange) -> Option<String> {
    let nodes = nodes_at(view, binding.start());
    let alias = nodes.iter().rev().find_map(|node| match node {
        AnyNodeRef::Alias(alias) => Some(*alias),
        _ => None,
    })?;
    let doc = match statement_at(&nodes)? {
        AnyNodeRef::StmtImportFrom(from) => docs::of(from.module.as_ref()?, &alias.name),
        _ => docs::of("module", &alias.name),
    };
    doc.map(Doc::markdown)
}

/// The module that an expression means.
pub(super) fn module_of<'a>(view: &View<'a>, expr: &Expr) -> Option<&'a str> {
    let Expr::Name(name) = expr else { return None };
    let occurrence = occurrence_at(view, name.range.start())?;
    let bound = occurrences_of(view, variable_of(view, occurrence)?).into_iter().find(|found| found.role == Role::Bind);
    let Some(binding) = bound else {
        return ["math", "random"].into_iter().find(|module| *module == name.id);
    };
    let nodes = nodes_at(view, binding.range.start());
    let alias = nodes.iter().rev().find_map(|node| match node {
        AnyNodeRef::Alias(alias) => Some(*alias),
        _ => None,
    })?;
    matches!(statement_at(&nodes), Some(AnyNodeRef::StmtImport(_))).then(|| alias.name.id.as_str()).filter(|name| docs::is_module(name))
}

/// A variable that stands for no object.
fn plain_variable(view: &View, text: &str, bindings: &[TextRange], global: bool, range: TextRange) -> Hover {
    let kind = if global { "variable" } else { "local variable" };
    let mut constant = None;
    let value = match bindings {
        [binding] => assigned(view, *binding),
        _ => None,
    };
    let mut markdown = format!("{} · {kind}", words::code(text));
    if let Some(value) = value {
        markdown = format!("```python\n{text} = {}\n```\n{kind}", first_line(view.slice(value)));
        constant = view
            .program
            .tuning
            .constant_at(value)
            .filter(|id| view.program.tuning.constant(*id).is_some_and(|constant| constant.excluded.is_none()));
        if constant.is_some() {
            markdown.push_str(" · a constant that may be tuned");
        }
    } else if bindings.len() > 1 {
        markdown.push_str(&format!(", bound at {} places", bindings.len()));
    }
    Hover { constant, ..Hover::new(range, markdown) }
}

/// The value that is assigned to a name where it stands alone on the left.
fn assigned(view: &View, binding: TextRange) -> Option<TextRange> {
    match statement_at(&nodes_at(view, binding.start()))? {
        AnyNodeRef::StmtAssign(assign) => assign.targets.iter().any(|target| target.range() == binding).then(|| assign.value.range()),
        _ => None,
    }
}

fn first_line(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default();
    let cut: String = line.chars().take(120).collect();
    if cut.len() < text.trim_end().len() { format!("{cut} …") } else { cut }
}

/// `def row(objects, gap=0.1)`
pub(super) fn signature(view: &View, def: &ast::StmtFunctionDef) -> String {
    let parameters = view.slice(def.parameters.range).split_whitespace().collect::<Vec<_>>().join(" ");
    let parameters: String = parameters.chars().take(300).collect();
    format!("def {}{parameters}", def.name)
}

/// The text right under a `def`.
pub(super) fn docstring(def: &ast::StmtFunctionDef) -> Option<String> {
    let expr = def.body.first()?.as_expr_stmt()?;
    let text = expr.value.as_string_literal_expr()?.value.to_str();
    Some(text.lines().map(str::trim).collect::<Vec<_>>().join("\n").trim().to_string())
}

fn function(view: &View, values: &Values, def: &ast::StmtFunctionDef, range: TextRange) -> Hover {
    let mut markdown = format!("```python\n{}\n```", signature(view, def));
    if let Some(text) = docstring(def) {
        markdown.push_str(&format!("\n{}", words::escaped(&text)));
    }
    let (objects, calls) = values.done_in(def);
    if calls > 0 {
        let errors = view.scene.map_or(0, |scene| scene.errors_among(&objects));
        let parts = [words::counted(calls, "call"), words::counted(objects.len(), "object"), words::counted(errors, "error")];
        markdown.push_str(&format!("\n\n{}", parts.join(" · ")));
    }
    Hover { objects, ..Hover::new(range, markdown) }
}

/// Objects, one by one or together.
fn objects(view: &View, objects: &[usize], title: &str, range: TextRange) -> Option<Hover> {
    let scene = view.scene?;
    let mut markdown = match objects {
        [] => return None,
        [object] => one(scene, *object)?,
        many => several(scene, many, title),
    };
    if view.is_stale() {
        markdown.push_str("\n\n*of the last run: the text is another by now*");
    } else if scene.partial {
        markdown.push_str("\n\n*the program did not run to its end*");
    }
    Some(Hover { objects: objects.to_vec(), ..Hover::new(range, markdown) })
}

fn one(scene: &Scene, object: usize) -> Option<String> {
    let placed = scene.object(object)?;
    let body = &placed.body;
    let mut out = format!("**{}** · {} · {}\n\n", words::code(&placed.path), words::escaped(&placed.name), words::kind(placed));
    out.push_str("| m | x | y | z |\n| --- | ---: | ---: | ---: |\n");
    for (name, corner) in [("max", body.max), ("center", body.center), ("min", body.min)] {
        let [x, y, z] = corner.map(words::number);
        out.push_str(&format!("| {name} | {x} | {y} | {z} |\n"));
    }
    out.push_str(&format!("\n{} (width × depth × height) · {}", words::size(placed), words::facing(placed, scene)));
    let errors: Vec<String> = scene.errors_of(object).map(|violation| words::error(violation, object, scene)).collect();
    if !errors.is_empty() {
        out.push('\n');
    }
    for error in errors.iter().take(MAX_ERRORS) {
        out.push_str(&format!("\n- ⛔ {error}"));
    }
    if errors.len() > MAX_ERRORS {
        out.push_str(&format!("\n- … and {} more", errors.len() - MAX_ERRORS));
    }
    Some(out)
}

fn several(scene: &Scene, objects: &[usize], title: &str) -> String {
    let errors = scene.errors_among(objects);
    let counts = format!("{} · {}", words::counted(objects.len(), "object"), words::counted(errors, "error"));
    let mut out =
        format!("**{}** · {counts}\n\n| | center | faces | errors |\n| --- | --- | --- | ---: |\n", words::code(&first_line(title)));
    for (index, placed) in objects.iter().filter_map(|index| Some((*index, scene.object(*index)?))).take(MAX_OBJECTS) {
        let errors = scene.errors_among(&[index]);
        let center = words::vector(placed.body.center);
        let path = words::code(&placed.path).replace('|', "\\|");
        out.push_str(&format!("| {path} | {center} | {} | {errors} |\n", placed.body.turn.name().replace('_', "\\_")));
    }
    if objects.len() > MAX_OBJECTS {
        out.push_str(&format!("\n… and {} more", objects.len() - MAX_OBJECTS));
    }
    out
}

/// A word of the language.
fn keyword_of_python(view: &View, offset: TextSize) -> Option<Hover> {
    let tokens = view.program.parsed.tokens();
    let token = tokens.iter().find(|token| token.range().contains_inclusive(offset) && token.kind().is_keyword())?;
    let doc = docs::of("keyword", view.slice(token.range())).or_else(|| docs::global(view.slice(token.range())))?;
    Some(Hover::new(token.range(), doc.markdown()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    const SCENE: &str = "\
set_size(4, 4, 3)
bed = Object('Double Bed', 2, 1, 1)
bed.center.x = 0.5
bed.min.y = scene.min.y
bed.facing = Y_MAX
chairs = [Object('Chair', 1, 1, 1, FLOATING) for _ in range(3)]
for i, c in enumerate(chairs):
    c.min.x = i * 0.5
    c.min.y = 0
";

    /// The text of the hover at the `$0` of a program (after the scene), and what it is about.
    fn check(marked: &str, expected: &[&str]) -> Hover {
        let fixture = Fixture::new(&format!("{SCENE}{marked}"));
        let hover = hover(&fixture.view(), fixture.offset).unwrap_or_else(|| panic!("nothing at {marked}"));
        for part in expected {
            assert!(hover.markdown.contains(part), "{part} is not in:\n{}", hover.markdown);
        }
        hover
    }

    #[test]
    fn an_object_tells_where_it_is_and_what_is_wrong() {
        let hover =
            check("be$0d.min.z = 0.5\n", &["**`bed`** · Double Bed · standing", "| center | 0.5 | −1.5 | 1 |", "faces `Y_MAX`", "floats"]);
        assert_eq!(hover.objects, [0]);
        check("chairs[1]$0\n", &["`chairs[1]`", "overlaps `chairs[0]`"]);
    }

    #[test]
    fn in_a_loop_all_that_the_line_made_is_told() {
        let hover = check("for c in chairs:\n    c$0.max.z = 2\n", &["**`c`** · 3 objects", "`chairs[2]`"]);
        assert_eq!(hover.objects, [1, 2, 3]);
    }

    #[test]
    fn attributes_tell_what_they_read() {
        check("print(bed.max$0.x)\n", &["corner of the box", "`bed`: (1.5, −1, 1)"]);
        check("print(bed.max.y$0)\n", &["`bed`: −1 m"]);
        check("print(math.si$0n(1))\n", &["math.sin(x)"]);
        check("[].appen$0d(1)\n", &["list.append(object)"]);
    }

    #[test]
    fn names_of_psdl_and_python_are_explained() {
        check("print(scen$0e.width)\n", &["4 × 4 × 3 m", "4 objects"]);
        check("set_coordinate_fram$0e(bed)\n", &["origin"]);
        check("x = le$0n(chairs)\n", &["number of items"]);
        check("bed.facing = X_MI$0N\n", &["Direction 2"]);
        check("bed.facing = 2$0\n", &["Direction 2"]);
        check("fo$0r c in chairs: pass\n", &["goes through"]);
        check("t = Object('T', wid$0th=1, depth=1, height=1)\n", &["across the facing"]);
    }

    #[test]
    fn constants_and_variables() {
        let hover = check("gap = 0.2$05\nbed.min.x = gap\n", &["`0.25` · a constant that may be tuned"]);
        assert_eq!(hover.constant, Some(ConstantId(2)));
        let hover = check("gap = 0.25\nbed.min.x = ga$0p\n", &["gap = 0.25"]);
        assert_eq!(hover.constant, Some(ConstantId(2)));
        check("t = Object('T', 1.5$0, 1, 1)\n", &["never tuned"]);
        check("t = Object('T', 1$0, 1, 1)\n", &["belongs to the template"]);
        check("bed.min.x = 2$0\n", &["`2` · an integer"]);
    }

    #[test]
    fn functions_tell_what_they_placed() {
        check(
            "def put(o, n=1):\n    'Puts it.'\n    o.min.x = n\npu$0t(bed)\nput(chairs[0])\n",
            &["def put(o, n=1)", "Puts it\\.", "2 calls · 2 objects"],
        );
    }

    #[test]
    fn the_last_scene_answers_while_the_text_does_not_parse() {
        let fixture = Fixture::stale(SCENE, &format!("{SCENE}be$0d.min.z = (\n"));
        let hover = hover(&fixture.view(), fixture.offset).unwrap();
        assert!(hover.markdown.contains("of the last run"), "{}", hover.markdown);
    }
}
