//! What the names of PSDL and of Python mean, in a sentence each: the tables behind hovers, completions and signatures.

use std::sync::OnceLock;

/// One name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Doc {
    /// Where it belongs: `scene`, `object`, `builtin`, `list`, `math`…
    pub owner: &'static str,
    /// The name.
    pub name: &'static str,
    /// How it is written, with parameters where it is called: `len(object)`.
    pub signature: &'static str,
    /// What it means, in Markdown.
    pub text: &'static str,
}

const TABLES: [&str; 3] = [include_str!("docs/psdl.txt"), include_str!("docs/python.txt"), include_str!("docs/modules.txt")];

/// The functions of `math` that every program has by their bare names.
pub(super) const BARE: [&str; 11] = ["sin", "cos", "tan", "atan2", "sqrt", "pi", "radians", "degrees", "floor", "ceil", "hypot"];

/// The builtin types whose methods are told.
pub(super) const TYPES: [&str; 7] = ["str", "list", "tuple", "dict", "set", "int", "float"];

/// All names. The tables are text, a line a name under the heading of its owner; they are read once.
pub fn all() -> &'static [Doc] {
    static DOCS: OnceLock<Vec<Doc>> = OnceLock::new();
    DOCS.get_or_init(|| TABLES.iter().flat_map(|table| read(table)).collect())
}

fn read(table: &'static str) -> impl Iterator<Item = Doc> {
    let mut owner = "";
    table.lines().filter_map(move |line| {
        if let Some(heading) = line.strip_prefix("# ") {
            owner = heading;
        }
        let (signature, text) = line.split_once(" :: ")?;
        let name = signature.split('(').next().unwrap_or(signature);
        Some(Doc { owner, name, signature, text })
    })
}

/// A name of an owner.
pub fn of(owner: &str, name: &str) -> Option<&'static Doc> {
    all().iter().find(|doc| doc.owner == owner && doc.name == name)
}

/// A name as every program has it, without an owner in front.
pub fn global(name: &str) -> Option<&'static Doc> {
    let bare = || BARE.contains(&name).then(|| of("math", name)).flatten();
    ["scene", "builtin", "exception"].into_iter().find_map(|owner| of(owner, name)).or_else(bare)
}

/// What every program can say by its bare name.
pub(super) fn globals() -> impl Iterator<Item = &'static Doc> {
    let everywhere =
        |doc: &&Doc| matches!(doc.owner, "scene" | "builtin" | "exception") || (doc.owner == "math" && BARE.contains(&doc.name));
    all().iter().filter(everywhere)
}

/// All of one owner.
pub(super) fn owned<'o>(owner: &'o str) -> impl Iterator<Item = &'static Doc> + 'o {
    all().iter().filter(move |doc| doc.owner == owner)
}

/// Whether a module can be imported.
pub(super) fn is_module(name: &str) -> bool {
    of("module", name).is_some()
}

impl Doc {
    /// In Markdown: how it is written, then what it means.
    pub fn markdown(&self) -> String {
        let owner = match self.owner {
            "scene" | "builtin" | "exception" | "keyword" | "parameter" | "module" => String::new(),
            owner => format!("{owner}."),
        };
        format!("```python\n{owner}{}\n```\n{}", self.signature, self.text)
    }

    /// Whether it is called.
    pub fn is_callable(&self) -> bool {
        self.signature.contains('(')
    }

    /// Its parameters as they are written.
    pub fn parameters(&self) -> Vec<&'static str> {
        let inner = self.signature.split_once('(').and_then(|(_, rest)| rest.strip_suffix(')'));
        inner.map_or_else(Vec::new, split_parameters)
    }
}

/// Cuts at the commas that stand in no brackets and no quotes.
fn split_parameters(inner: &str) -> Vec<&str> {
    let (mut parts, mut start, mut depth, mut quoted) = (Vec::new(), 0, 0_i32, false);
    for (at, ch) in inner.char_indices() {
        match ch {
            '\'' | '"' => quoted = !quoted,
            '(' | '[' if !quoted => depth += 1,
            ')' | ']' if !quoted => depth -= 1,
            ',' if !quoted && depth == 0 => {
                parts.push(inner[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(inner[start..].trim());
    parts.retain(|part| !part.is_empty());
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::python::builtins::FUNCTIONS;
    use crate::python::host::Host as _;
    use crate::python::modules::native_module;
    use crate::python::native::NativeKind;
    use crate::python::types;
    use crate::scene::host::SceneHost;

    #[test]
    fn every_name_that_a_program_has_is_told() {
        let host = SceneHost::new();
        let named = host.names().into_iter().chain(FUNCTIONS.iter().map(|function| function.name));
        let missing: Vec<&str> = named.filter(|name| global(name).is_none()).collect();
        assert_eq!(missing, [""; 0]);
    }

    #[test]
    fn every_method_is_told() {
        let tables = [("str", types::str::METHODS), ("list", types::list::METHODS), ("tuple", types::tuple::METHODS)];
        let more =
            [("dict", types::dict::METHODS), ("set", types::set::METHODS), ("int", types::int::METHODS), ("float", types::float::METHODS)];
        for (owner, methods) in tables.into_iter().chain(more) {
            let called = methods.iter().filter(|method| method.kind != NativeKind::Getter && !method.name.starts_with('_'));
            let missing: Vec<&str> = called.map(|method| method.name).filter(|name| of(owner, name).is_none()).collect();
            assert_eq!(missing, [""; 0], "{owner}");
        }
    }

    #[test]
    fn every_function_of_a_module_is_told() {
        for module in ["math", "itertools"] {
            let names = native_module(module).unwrap().iter().map(|(name, _)| *name).filter(|name| !name.starts_with('_'));
            let missing: Vec<&str> = names.filter(|name| of(module, name).is_none()).collect();
            assert_eq!(missing, [""; 0], "{module}");
        }
    }

    #[test]
    fn no_name_is_told_twice() {
        for (at, doc) in all().iter().enumerate() {
            assert!(!all()[..at].iter().any(|other| (other.owner, other.name) == (doc.owner, doc.name)), "{doc:?}");
            assert!(doc.text.ends_with('.') && !doc.name.is_empty(), "{doc:?}");
        }
    }

    #[test]
    fn parameters_are_cut_at_commas() {
        assert_eq!(global("print").unwrap().parameters(), ["*objects", "sep=' '", "end='\\n'"]);
        assert_eq!(of("functools", "partial").unwrap().parameters(), ["function", "*args", "**kwargs"]);
        assert!(of("str", "lower").unwrap().parameters().is_empty());
    }
}
