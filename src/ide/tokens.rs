//! What the words of a program are, for colours: objects, constants that may be tuned, directions, frames, and the rest of Python.

use super::docs;
use super::find::{for_each_node, occurrences_of, root, variable_of};
use super::program::View;
use super::values::Values;
use crate::syntax::ScopeId;
use crate::syntax::ast::{AnyNodeRef, Expr, Ranged as _};
use crate::syntax::scope::{Role, Variable};
use crate::syntax::tune::DirectionKind;
use ruff_text_size::TextRange;
use rustc_hash::{FxHashMap, FxHashSet};

/// What a word is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum TokenKind {
    /// A name that stands for objects, or the scene.
    Object,
    /// A direction, by name or by number.
    Direction,
    /// What becomes the frame.
    Frame,
    /// A constant that may be tuned.
    Constant,
    /// A function.
    Function,
    /// A parameter, or a keyword argument.
    Parameter,
    /// Any other variable.
    Variable,
    /// A class.
    Class,
    /// A module.
    Module,
    /// An attribute.
    Property,
}

impl TokenKind {
    /// All kinds, in the order in which an editor is told of them.
    pub const ALL: [TokenKind; 10] = [
        TokenKind::Object,
        TokenKind::Direction,
        TokenKind::Frame,
        TokenKind::Constant,
        TokenKind::Function,
        TokenKind::Parameter,
        TokenKind::Variable,
        TokenKind::Class,
        TokenKind::Module,
        TokenKind::Property,
    ];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            TokenKind::Object => "object",
            TokenKind::Direction => "direction",
            TokenKind::Frame => "frame",
            TokenKind::Constant => "constant",
            TokenKind::Function => "function",
            TokenKind::Parameter => "parameter",
            TokenKind::Variable => "variable",
            TokenKind::Class => "class",
            TokenKind::Module => "namespace",
            TokenKind::Property => "property",
        }
    }
}

/// A word of the program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Token {
    /// Where.
    pub range: TextRange,
    /// What.
    pub kind: TokenKind,
    /// It is bound here.
    pub declares: bool,
    /// It is PSDL's or Python's.
    pub library: bool,
}

/// The words of a program, by place. None spans lines.
pub fn tokens(view: &View) -> Vec<Token> {
    let mut finder = Finder { kinds: FxHashMap::default(), frames: FxHashSet::default(), tokens: Vec::new() };
    for_each_node(view, &mut |node| finder.node(node));
    finder.names(view);
    let tuning = &view.program.tuning;
    let constants = tuning.constants.iter().filter(|constant| constant.excluded.is_none());
    let mut tokens = finder.tokens;
    tokens.extend(constants.map(|constant| plain(constant.range, TokenKind::Constant)));
    let literals = tuning.directions.iter().filter(|direction| matches!(direction.kind, DirectionKind::Literal(_)));
    let numbers = literals.filter(|direction| view.slice(direction.range).starts_with(|ch: char| ch.is_ascii_digit()));
    tokens.extend(numbers.map(|direction| plain(direction.range, TokenKind::Direction)));
    tokens.retain(|token| !token.range.is_empty() && !view.slice(token.range).contains(['\n', '\r']));
    tokens.sort_by_key(|token| (token.range.start(), token.range.end()));
    // Editors take no words that overlap.
    let mut end = ruff_text_size::TextSize::new(0);
    tokens.retain(|token| {
        let free = token.range.start() >= end;
        if free {
            end = token.range.end();
        }
        free
    });
    tokens
}

fn plain(range: TextRange, kind: TokenKind) -> Token {
    Token { range, kind, declares: false, library: false }
}

struct Finder {
    /// What the names that are bound at these places are.
    kinds: FxHashMap<TextRange, TokenKind>,
    /// The names that become the frame.
    frames: FxHashSet<TextRange>,
    tokens: Vec<Token>,
}

impl Finder {
    fn node(&mut self, node: AnyNodeRef) {
        match node {
            AnyNodeRef::StmtFunctionDef(def) => {
                self.kinds.insert(def.name.range, TokenKind::Function);
            }
            AnyNodeRef::StmtClassDef(def) => {
                self.kinds.insert(def.name.range, TokenKind::Class);
            }
            AnyNodeRef::Parameter(parameter) => {
                self.kinds.insert(parameter.name.range, TokenKind::Parameter);
            }
            AnyNodeRef::StmtImport(import) => {
                let names = import.names.iter().map(|alias| alias.asname.as_ref().map_or(alias.name.range, |name| name.range));
                self.kinds.extend(names.map(|range| (range, TokenKind::Module)));
            }
            AnyNodeRef::ExprCall(call) => {
                if let (Expr::Name(name), Some(argument)) = (call.func.as_ref(), call.arguments.args.first()) {
                    self.frames.extend(root(argument).filter(|_| name.id == "set_coordinate_frame").map(|root| root.range));
                }
            }
            AnyNodeRef::Keyword(keyword) => {
                self.tokens.extend(keyword.arg.as_ref().map(|arg| plain(arg.range, TokenKind::Parameter)));
            }
            AnyNodeRef::ExprAttribute(attribute) => {
                let owner = matches!(attribute.value.as_ref(), Expr::Name(name) if name.id == "Facing");
                let kind = if owner { TokenKind::Direction } else { TokenKind::Property };
                self.tokens.push(plain(attribute.attr.range(), kind));
            }
            _ => {}
        }
    }

    fn names(&mut self, view: &View) {
        let values = Values::new(*view);
        let mut known: FxHashMap<Variable, (TokenKind, bool)> = FxHashMap::default();
        for found in view.program.parsed.scopes.occurrences() {
            let Some(variable) = variable_of(view, found) else { continue };
            let (kind, library) = *known.entry(variable).or_insert_with(|| self.kind(view, &values, variable));
            let kind = if self.frames.contains(&found.range) { TokenKind::Frame } else { kind };
            self.tokens.push(Token { range: found.range, kind, declares: found.role == Role::Bind, library });
        }
    }

    /// What a variable is, and whether it is of the language.
    fn kind(&self, view: &View, values: &Values, variable: Variable) -> (TokenKind, bool) {
        let bound: Vec<TextRange> =
            occurrences_of(view, variable).iter().filter(|found| found.role == Role::Bind).map(|found| found.range).collect();
        let name = view.program.parsed.scopes.name(variable.name).as_str();
        if let (true, ScopeId::MODULE, Some(doc)) = (bound.is_empty(), variable.owner, docs::global(name)) {
            let kind = match (doc.owner, name) {
                (_, "scene" | "CENTER") => TokenKind::Object,
                _ if crate::syntax::tune::Cardinal::from_name(name).is_some() => TokenKind::Direction,
                (_, "math" | "random") => TokenKind::Module,
                ("exception", _) => TokenKind::Class,
                _ if doc.is_callable() => TokenKind::Function,
                _ => TokenKind::Variable,
            };
            return (kind, true);
        }
        let told = bound.iter().find_map(|range| self.kinds.get(range)).copied();
        if let Some(kind) = told.filter(|kind| *kind != TokenKind::Parameter) {
            return (kind, false);
        }
        let objects = !values.of_variable(variable).is_empty();
        (if objects { TokenKind::Object } else { told.unwrap_or(TokenKind::Variable) }, false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    #[test]
    fn words_are_what_they_mean() {
        let text = "bed = Object('Bed', 2, 2, 1)\ngap = 0.5\nbed.min.x = scene.min.x + gap\nbed.facing = 2\nset_coordinate_frame(bed)\ndef put(o, n=X_MAX):\n    o.min.y = len([n])\nput(bed, n=Facing.Y_MIN)\n";
        let fixture = Fixture::new(text);
        let found: Vec<String> =
            tokens(&fixture.view()).iter().map(|token| format!("{}:{}", &text[token.range], token.kind.name())).collect();
        let expected = "bed:object Object:function gap:variable 0.5:constant bed:object min:property x:property scene:object min:property x:property gap:variable bed:object facing:property 2:direction set_coordinate_frame:function bed:frame put:function o:object n:parameter X_MAX:direction o:object min:property y:property len:function n:parameter put:function bed:object n:parameter Facing:variable Y_MIN:direction";
        assert_eq!(found.join(" "), expected);
    }
}
