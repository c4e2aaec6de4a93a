//! The template moves into the program, or out of it.

use super::{Ground, Refactoring, RefactoringKind, Sidecar};
use crate::scene::template::{self, Template, TemplateObject};
use crate::scene::{Kind, Scalar, Support};
use crate::syntax::Edit;
use crate::syntax::ast::{Arguments, Expr, ExprCall, Number, Ranged as _, Stmt};
use crate::syntax::tune::format_constant;
use ruff_text_size::{TextRange, TextSize};
use serde_json::{Map, Value, json};
use std::fmt::Write as _;

/// The move that is possible for a program, offered at its beginning.
pub(super) fn move_template(ground: &Ground, range: TextRange) -> Option<Refactoring> {
    if !ground.has_place {
        return None;
    }
    match ground.template {
        Some(json) => inside(ground, range, &template::parse(json).ok()?),
        None => outside(ground, range),
    }
}

/// Text between quotes, for Python as for JSON.
fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

fn number(scalar: Scalar) -> String {
    if scalar.int { format!("{}", scalar.value()) } else { format_constant(scalar.value(), false) }
}

fn inside(ground: &Ground, range: TextRange, template: &Template) -> Option<Refactoring> {
    let text = ground.text();
    let first = text.find('\n').unwrap_or(text.len());
    if range.start().to_usize() > first {
        return None;
    }
    let newline = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let mut lines = Vec::new();
    if !template.title.is_empty() {
        lines.push(format!("set_title({})", quoted(&template.title)));
    }
    let [width, depth, height] = template.dims.map(number);
    lines.push(format!("set_size({width}, {depth}, {height})"));
    if !template.interior {
        lines.push("set_wall_asset(\"Wall\", interior=False)".into());
    }
    lines.extend(template.objects.iter().map(declaration));
    let start = if text.starts_with('\u{feff}') { TextSize::of('\u{feff}') } else { TextSize::new(0) };
    let prelude = lines.iter().fold(String::new(), |prelude, line| prelude + line + newline) + newline;
    Some(Refactoring {
        title: "Move the template into the program".into(),
        kind: RefactoringKind::Template,
        edits: vec![(TextRange::empty(start), prelude)],
        sidecar: Some(Sidecar::Deleted),
    })
}

fn declaration(object: &TemplateObject) -> String {
    let [width, depth, height] = object.dims.map(number);
    let (class, support) = match object.kind {
        Kind::Object => ("Object", format!(", {}", object.support.name())),
        Kind::Door => ("Door", String::new()),
        Kind::Window => ("Window", String::new()),
    };
    let mut call = format!("{class}({}, {width}, {depth}, {height}{support}", quoted(&object.name));
    // Writing to a string cannot fail.
    if let Some(color) = &object.color {
        let _ = write!(call, ", color={}", quoted(color));
    }
    if object.dynamic {
        call.push_str(", dynamic=True");
    }
    call.push(')');
    match object.count {
        Some(count) => format!("{} = [{call} for _ in range({count})]", object.id),
        None => format!("{} = {call}", object.id),
    }
}

/// A statement of the template, read off the program.
enum Told {
    Title(String),
    Size([Value; 3]),
    Object(Map<String, Value>),
    /// One that the sidecar has no word for; it stays.
    Other,
}

fn outside(ground: &Ground, range: TextRange) -> Option<Refactoring> {
    let text = ground.text();
    let parsed = ground.problem.parsed();
    let (mut title, mut size, mut objects) = (None, [json!(6), json!(6), json!(3)], Vec::new());
    let (mut edits, mut end): (Vec<Edit>, TextSize) = (Vec::new(), TextSize::new(0));
    for stmt in &parsed.module.body {
        match told(stmt) {
            None => break,
            Some(Told::Other) => continue,
            Some(Told::Title(text)) => title = Some(text),
            Some(Told::Size(dims)) => size = dims,
            Some(Told::Object(object)) => objects.push(object),
        }
        edits.push((lines_of(text, stmt.range())?, String::new()));
        end = stmt.end();
    }
    if objects.is_empty() || range.start() > end {
        return None;
    }
    let mut json = String::from("{\n");
    // Writing to a string cannot fail.
    if let Some(title) = title {
        let _ = writeln!(json, "  \"title\": {},", quoted(&title));
    }
    let interior = ground.problem.layout().scene.interior;
    let [width, depth, height] = size;
    let _ = writeln!(json, "  \"width\": {width}, \"depth\": {depth}, \"height\": {height}, \"interior\": {interior},\n  \"objects\": [");
    let pair = |(key, value): (&String, &Value)| format!("{}: {value}", quoted(key));
    let line = |object: &Map<String, Value>| format!("    {{{}}}", object.iter().map(pair).collect::<Vec<_>>().join(", "));
    let _ = write!(json, "{}\n  ]\n}}\n", objects.iter().map(line).collect::<Vec<_>>().join(",\n"));
    Some(Refactoring {
        title: "Move the template into a file beside the program".into(),
        kind: RefactoringKind::Template,
        edits,
        sidecar: Some(Sidecar::Created(json)),
    })
}

/// The lines of a statement, if nothing else stands on them.
fn lines_of(text: &str, range: TextRange) -> Option<TextRange> {
    let (before, after) = (text.get(..range.start().to_usize())?, text.get(range.end().to_usize()..)?);
    let start = before.rfind('\n').map_or(0, |at| at + 1);
    let end = after.find('\n').map_or(after.len(), |at| at + 1);
    let alone = before[start..].trim_matches(['\u{feff}', ' ']).is_empty() && after[..end].trim().is_empty();
    let start = if before[start..].starts_with('\u{feff}') { start + '\u{feff}'.len_utf8() } else { start };
    let size = |at: usize| u32::try_from(at).map(TextSize::new).ok();
    alone.then(|| Some(TextRange::new(size(start)?, size(range.end().to_usize() + end)?))).flatten()
}

fn told(stmt: &Stmt) -> Option<Told> {
    match stmt {
        Stmt::Expr(node) => {
            let (name, call) = called(&node.value)?;
            match name {
                "set_title" => Some(Told::Title(string(argument(&call.arguments, 0, "title")?)?)),
                "set_size" => {
                    let at = |index, name| numeral(argument(&call.arguments, index, name)?);
                    Some(Told::Size([at(0, "width")?, at(1, "depth")?, at(2, "height")?]))
                }
                "set_wall_asset" | "set_floor_asset" => Some(Told::Other),
                _ => None,
            }
        }
        Stmt::Assign(node) => {
            let [Expr::Name(target)] = node.targets.as_slice() else { return None };
            let (value, count) = match &*node.value {
                Expr::ListComp(list) => (&*list.elt, Some(repetitions(list.generators.as_slice())?)),
                value => (value, None),
            };
            let mut object = object(target.id.as_str(), value)?;
            if let Some(count) = count {
                object.insert("count".into(), count);
            }
            Some(Told::Object(object))
        }
        _ => None,
    }
}

fn called(expr: &Expr) -> Option<(&str, &ExprCall)> {
    let Expr::Call(call) = expr else { return None };
    let Expr::Name(name) = &*call.func else { return None };
    Some((name.id.as_str(), call))
}

fn object(id: &str, expr: &Expr) -> Option<Map<String, Value>> {
    let (class, call) = called(expr)?;
    let names: &[&str] = match class {
        "Object" => &["name", "width", "depth", "height", "support", "color", "dynamic"],
        "Door" | "Window" => &["name", "width", "depth", "height", "color", "support", "dynamic"],
        _ => return None,
    };
    let known = call.arguments.keywords.iter().all(|keyword| keyword.arg.as_ref().is_some_and(|name| names.contains(&name.id.as_str())));
    if !known || call.arguments.args.len() > names.len() {
        return None;
    }
    let given = |name: &str| names.iter().position(|known| *known == name).and_then(|at| argument(&call.arguments, at, name));
    let mut object = Map::new();
    object.insert("id".into(), id.into());
    object.insert("name".into(), string(given("name")?)?.into());
    if class != "Object" {
        object.insert("kind".into(), class.to_lowercase().into());
    }
    for name in ["width", "depth", "height"] {
        object.insert(name.into(), numeral(given(name)?)?);
    }
    let support = match given("support") {
        None if class == "Object" => Support::Standing,
        None => Support::Mounted,
        Some(expr) => support(expr)?,
    };
    object.insert("support".into(), if class == "Object" { support.name() } else { Support::Mounted.name() }.into());
    match given("color") {
        None | Some(Expr::NoneLiteral(_)) => {}
        Some(color) => drop(object.insert("color".into(), string(color)?.into())),
    }
    match given("dynamic") {
        None => {}
        Some(Expr::BooleanLiteral(dynamic)) => drop(object.insert("dynamic".into(), dynamic.value.into())),
        Some(_) => return None,
    }
    Some(object)
}

fn argument<'a>(arguments: &'a Arguments, at: usize, name: &str) -> Option<&'a Expr> {
    let keyword = arguments.keywords.iter().find(|keyword| keyword.arg.as_ref().is_some_and(|known| known.id == name));
    arguments.args.get(at).or_else(|| keyword.map(|keyword| &keyword.value))
}

fn string(expr: &Expr) -> Option<String> {
    expr.as_string_literal_expr().map(|literal| literal.value.to_str().to_string())
}

fn numeral(expr: &Expr) -> Option<Value> {
    match expr {
        Expr::NumberLiteral(node) => match &node.value {
            Number::Int(int) => int.as_i64().map(Value::from),
            Number::Float(value) => Some(Value::from(*value)),
            Number::Complex { .. } => None,
        },
        _ => None,
    }
}

fn support(expr: &Expr) -> Option<Support> {
    let name = match expr {
        Expr::Name(name) => name.id.as_str(),
        Expr::Attribute(node) if matches!(&*node.value, Expr::Name(class) if class.id == "Support") => node.attr.id.as_str(),
        _ => return None,
    };
    match name {
        "STANDING" => Some(Support::Standing),
        "MOUNTED" | "WALL_MOUNTED" => Some(Support::Mounted),
        "FLOATING" => Some(Support::Floating),
        _ => None,
    }
}

/// The count of `for _ in range(3)`.
fn repetitions(generators: &[crate::syntax::ast::Comprehension]) -> Option<Value> {
    let [each] = generators else { return None };
    let (name, call) = called(&each.iter)?;
    let [count] = &*call.arguments.args else { return None };
    (name == "range" && each.ifs.is_empty() && call.arguments.keywords.is_empty()).then(|| numeral(count)).flatten().filter(Value::is_i64)
}
