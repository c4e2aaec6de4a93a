//! The parameters of the call that is being written.

use super::context::{Call, context};
use super::docs;
use super::find::functions;
use super::hover::{docstring, signature};
use super::program::View;
use ruff_text_size::TextSize;

/// How something is called.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Signature {
    /// `Object(name, width, …)`
    pub label: String,
    /// Its parameters, as bytes of the label.
    pub parameters: Vec<(usize, usize)>,
    /// The parameter that is being written.
    pub active: Option<usize>,
    /// What it does, in Markdown.
    pub documentation: String,
}

/// The call around a place.
pub fn signature_help(view: &View, offset: TextSize) -> Option<Signature> {
    let call = context(view.text(), offset.to_usize()).call?;
    let (label, texts, documentation) = called(view, &call)?;
    let mut parameters = Vec::with_capacity(texts.len());
    let mut from = label.find('(').map_or(0, |at| at + 1);
    for text in &texts {
        let start = from + label[from..].find(text.as_str())?;
        from = start + text.len();
        parameters.push((start, from));
    }
    Some(Signature { active: active(&call, &texts), label, parameters, documentation })
}

/// How it is written, its parameters, and what it does.
fn called(view: &View, call: &Call) -> Option<(String, Vec<String>, String)> {
    let functions = functions(view);
    if let Some(def) = functions.iter().rev().find(|def| def.name.as_str() == call.callee) {
        let label = signature(view, def);
        let label = label.strip_prefix("def ").unwrap_or(&label).to_string();
        let texts = def.parameters.iter_source_order().map(|parameter| {
            let text = view.slice(ruff_text_size::Ranged::range(&parameter.as_parameter().name));
            text.to_string()
        });
        return Some((label, texts.collect(), docstring(def).map(|text| super::words::escaped(&text)).unwrap_or_default()));
    }
    let doc = match call.callee.rsplit_once('.') {
        None => docs::global(call.callee)?,
        Some((owner, name)) => docs::of(owner, name).or_else(|| docs::TYPES.iter().find_map(|owner| docs::of(owner, name)))?,
    };
    let parameters = doc.parameters().into_iter().filter(|text| *text != "*").map(str::to_string).collect();
    doc.is_callable().then(|| (doc.signature.to_string(), parameters, doc.text.to_string()))
}

/// The parameter that the last argument is for.
fn active(call: &Call, parameters: &[String]) -> Option<usize> {
    let last = call.arguments.last()?;
    let name = |text: &String| text.trim_start_matches('*').split(['=', ':']).next().unwrap_or_default().trim().to_string();
    if let Some(keyword) = Call::keyword(last) {
        let all = parameters.iter().position(|text| text.starts_with("**"));
        return parameters.iter().position(|text| name(text) == keyword).or(all);
    }
    let at = call.arguments.len() - 1;
    let rest = parameters.iter().position(|text| text.starts_with('*') && !text.starts_with("**"));
    let at = rest.map_or(at, |rest| at.min(rest));
    (at < parameters.len()).then_some(at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    /// The call at the `$0`, with the active parameter between `[` and `]`.
    fn check(marked: &str, expected: &str) {
        let fixture = Fixture::new(marked);
        let shown = signature_help(&fixture.view(), fixture.offset).map(|found| {
            let mut label = found.label.clone();
            if let Some((start, end)) = found.active.map(|active| found.parameters[active]) {
                label.insert(end, ']');
                label.insert(start, '[');
            }
            label
        });
        assert_eq!(shown.unwrap_or_default(), expected, "{marked}");
    }

    #[test]
    fn calls_that_are_being_written() {
        check("a = Object('A', 1$0", "Object(name, [width], depth, height, support=STANDING, color=None, dynamic=False)");
        check("a = Object('A', height=$0", "Object(name, width, depth, [height], support=STANDING, color=None, dynamic=False)");
        check("def row(items, gap=0.1):\n    pass\nrow(a, $0)\n", "row(items, [gap]=0.1)");
        check("x = math.atan2(1, $0", "math.atan2(y, [x])".strip_prefix("math.").unwrap());
        check("print(1, 2, 3$0", "print([*objects], sep=' ', end='\\n')");
        check("[].append($0", "append([object])");
        check("x = 1$0", "");
        check("# print($0", "");
    }
}
