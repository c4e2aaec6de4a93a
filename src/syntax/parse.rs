//! The door of the parser: text → tree, names and errors.

use ruff_python_ast::token::Token;
use ruff_python_ast::{AtomicNodeIndex, ModModule, PythonVersion, Stmt, Suite};
use ruff_python_parser::{Mode, ParseError, ParseOptions, UnsupportedSyntaxError};
use ruff_text_size::{Ranged, TextRange, TextSize};
use rustc_hash::FxHashSet;

use super::depth::measure;
use super::error::{ErrorKind, SyntaxError};
use super::fences;
use super::message::{message, unsupported};
use super::resolve::resolve;
use super::scan::{Scan, scan};
use super::scope::Scopes;

/// The most bytes of a program.
pub const MAX_TEXT: usize = 4 << 20;
/// Statements, expressions and patterns stand at most this deep inside each other. A walk that
/// spends up to 2 KiB of stack on each can go as deep as it likes; one that spends more, or that
/// starts deep in a stack, goes through [`Parsed::with_stack`].
pub const MAX_DEPTH: usize = 600;
/// Trees that nest no deeper than this need no thought.
const SHALLOW: usize = 64;
/// The most errors that are reported.
const MAX_ERRORS: usize = 100;
/// The most errors of the parser that are put into words, to choose those from.
const MAX_READ_ERRORS: usize = 10_000;
/// Stack for walks over deep trees.
const WALK_STACK: usize = 16 << 20;
/// Where the scan expects trees deeper than this, they are built, measured and freed on a stack of their own.
const DEEP: u32 = 300;
const DEEP_STACK: usize = 64 << 20;

/// A text, read.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// The statements. Those that hold an error are the parser's best guess.
    pub module: ModModule,
    /// What the names mean. Sound where the program is complete, a guess around errors.
    pub scopes: Scopes,
    /// In the order of the text; the first hundred.
    pub errors: Vec<SyntaxError>,
    tokens: Vec<Token>,
    whole: Vec<bool>,
    depth: usize,
}

impl Parsed {
    /// No error: the program can run.
    pub fn is_complete(&self) -> bool {
        self.errors.is_empty()
    }

    /// Whether a top-level statement (by its place in the module's body) holds no error.
    pub fn is_whole(&self, statement: usize) -> bool {
        self.whole.get(statement).copied().unwrap_or(false)
    }

    /// The top-level statements that hold no error.
    pub fn whole_statements(&self) -> impl Iterator<Item = &Stmt> {
        self.module.body.iter().zip(&self.whole).filter_map(|(stmt, whole)| whole.then_some(stmt))
    }

    /// Names, numbers, operators, comments, line ends… in the order of the text.
    pub fn tokens(&self) -> &[Token] {
        &self.tokens
    }

    /// How deep statements, expressions and patterns stand inside each other: at most [`MAX_DEPTH`].
    pub fn depth(&self) -> usize {
        self.depth
    }

    /// Runs a recursive walk over the tree with room for 24 KiB of stack a level. Costs nothing where the tree is shallow.
    pub fn with_stack<R>(&self, walk: impl FnOnce() -> R) -> R {
        with_stack(self.depth, walk)
    }
}

fn with_stack<R>(depth: usize, walk: impl FnOnce() -> R) -> R {
    if depth <= SHALLOW { walk() } else { stacker::maybe_grow(WALK_STACK - (1 << 20), WALK_STACK, walk) }
}

/// Reads a program. Never fails: what is wrong stands in [`Parsed::errors`].
pub fn parse(text: &str) -> Parsed {
    let head = &text[..text.floor_char_boundary(MAX_TEXT)];
    let mut scanned = scan(head);
    if head.len() < text.len() && scanned.cut.is_none() {
        let end = TextRange::empty(TextSize::of(head));
        scanned.errors.push(SyntaxError::too_big(end, format!("program too long: more than {MAX_TEXT} bytes")));
        scanned.cut = Some(head.rfind('\n').map_or(0, |end| end + 1));
    }
    if scanned.fences.is_empty() {
        return on_stack(scanned.deepest, || parse_scanned(head, scanned));
    }
    let (blanked, errors) = fences::without(head, &scanned.fences, is_program);
    let mut again = scan(&blanked);
    if again.cut.is_none() {
        again.cut = scanned.cut;
    }
    again.errors.extend(scanned.errors.into_iter().filter(|error| error.kind == ErrorKind::TooBig));
    again.errors.extend(errors);
    on_stack(again.deepest, || parse_scanned(&blanked, again))
}

/// Runs what builds and frees trees that the scan expects to be this deep.
fn on_stack<R>(deepest: u32, run: impl FnOnce() -> R) -> R {
    if deepest <= DEEP { run() } else { stacker::grow(DEEP_STACK, run) }
}

/// Text that is Python as it stands.
fn is_program(text: &str) -> bool {
    let scanned = scan(text);
    scanned.errors.is_empty() && scanned.cut.is_none() && on_stack(scanned.deepest, || run_parser(text, &[]).errors.is_empty())
}

/// What the parser made of a text.
struct Tree {
    module: ModModule,
    errors: Vec<ParseError>,
    unsupported: Vec<UnsupportedSyntaxError>,
    tokens: Vec<Token>,
}

/// Parses the text, afresh from each split.
fn run_parser(text: &str, splits: &[usize]) -> Tree {
    let options = ParseOptions::from(Mode::Module).with_target_version(PythonVersion::PY314);
    let module = ModModule { node_index: AtomicNodeIndex::NONE, range: TextRange::up_to(size(text.len())), body: Suite::new() };
    let mut tree = Tree { module, errors: Vec::new(), unsupported: Vec::new(), tokens: Vec::new() };
    let ends = splits.iter().copied().filter(|split| *split < text.len()).chain([text.len()]);
    let mut start = 0;
    for end in ends {
        let part = TextRange::new(size(start), size(end));
        let parsed = ruff_python_parser::parse_cells_unchecked(text, [part], &options);
        // What is missing at the end of a part is missing before the line end there.
        let inside = |location: TextRange| {
            if end == text.len() || location.start() < part.end() { location } else { TextRange::empty(size(end - 1)) }
        };
        let errors = parsed.errors().iter();
        tree.errors.extend(errors.map(|error| ParseError { error: error.error.clone(), location: inside(error.location) }));
        tree.unsupported.extend_from_slice(parsed.unsupported_syntax_errors());
        tree.tokens.extend_from_slice(parsed.tokens());
        let next = parsed.into_syntax().body;
        if tree.module.body.is_empty() {
            tree.module.body = next;
        } else {
            tree.module.body.extend(next);
        }
        start = end;
    }
    tree
}

fn parse_scanned(text: &str, scanned: Scan) -> Parsed {
    let text = scanned.cut.map_or(text, |cut| &text[..cut]);
    let Tree { mut module, errors: found, unsupported: newer, tokens } = run_parser(text, &scanned.splits);
    let mut errors = scanned.errors;
    let confused: Vec<TextRange> = errors.iter().filter_map(|cause| confused_by(cause, &scanned.splits, text)).collect();
    let depth = limit_depth(&mut module, &mut errors);

    let mut whole = vec![true; module.body.len()];
    let located = found.iter().map(|error| error.location).chain(newer.iter().map(|error| error.range));
    for range in errors.iter().map(|error| error.range).chain(located) {
        touched(&module, range).for_each(|at| whole[at] = false);
    }
    errors.extend(in_words(&found, &confused, text));
    errors.extend(newer.iter().filter_map(|error| Some(SyntaxError::new(clamp(error.range, text), unsupported(error)?))));

    let (scopes, refused) = with_stack(depth, || resolve(&module.body, module.range, text));
    let sound = whole.clone();
    for error in refused {
        if touched(&module, error.range).all(|at| sound[at]) || error.kind == ErrorKind::LeftOut {
            touched(&module, error.range).for_each(|at| whole[at] = false);
            errors.push(error);
        }
    }
    errors.sort_by_key(|error| error.range.start());
    errors.dedup_by_key(|error| error.range.start());
    errors.truncate(MAX_ERRORS);
    Parsed { module, scopes, errors, tokens, whole, depth }
}

/// The parser's errors that say something new: one a line, and none that only echo the scan's.
fn in_words(found: &[ParseError], confused: &[TextRange], text: &str) -> Vec<SyntaxError> {
    let mut ranges: Vec<(TextRange, &ParseError)> =
        found.iter().take(MAX_READ_ERRORS).map(|error| (clamp(error.location, text), error)).collect();
    ranges.retain(|(range, _)| !confused.iter().any(|confused| confused.contains_inclusive(range.start())));
    ranges.sort_by_key(|(range, _)| range.start());
    let mut line_end = None;
    ranges.retain(|(range, _)| {
        let start = range.start().to_usize();
        let fresh = line_end.is_none_or(|end| start > end);
        if fresh {
            line_end = Some(text[start..].find(['\n', '\r']).map_or(text.len(), |length| start + length));
        }
        fresh
    });
    ranges.into_iter().map(|(range, error)| SyntaxError::new(range, message(error, text))).collect()
}

/// The top-level statements that a range touches, by their places in the body.
fn touched(module: &ModModule, range: TextRange) -> std::ops::Range<usize> {
    let first = module.body.partition_point(|stmt| stmt.range().end() < range.start());
    let last = module.body.partition_point(|stmt| stmt.range().start() < range.end() || stmt.range().start() == range.start());
    first..last.max(first)
}

/// Where the parser's errors only echo one of the scan's: a bracket or string that stays open
/// confuses everything up to the next split.
fn confused_by(cause: &SyntaxError, splits: &[usize], text: &str) -> Option<TextRange> {
    let start = cause.range.start();
    let split = splits.iter().copied().find(|split| *split > start.to_usize());
    let end = split.map_or(text.len(), |split| split - 1);
    (cause.kind == ErrorKind::Syntax).then(|| TextRange::new(start, size(end).max(start)))
}

/// The parser's ranges, kept inside the text and on character boundaries whatever it says. A line's end is a place, no range.
fn clamp(range: TextRange, text: &str) -> TextRange {
    let start = text.floor_char_boundary(range.start().to_usize());
    let end = text.ceil_char_boundary(range.end().to_usize()).max(start);
    let end = if text[start..end].starts_with(['\n', '\r']) { start } else { end };
    TextRange::new(size(start), size(end))
}

fn size(at: usize) -> TextSize {
    TextSize::new(u32::try_from(at).unwrap_or(u32::MAX))
}

/// Takes out the statements that nest too deep, each with an error; returns the depth of the rest.
fn limit_depth(module: &mut ModModule, errors: &mut Vec<SyntaxError>) -> usize {
    let mut deepest = 0;
    let mut too_deep = FxHashSet::default();
    for (at, stmt) in module.body.iter().enumerate() {
        match measure(stmt, MAX_DEPTH) {
            Ok(depth) => deepest = deepest.max(depth),
            Err(range) => {
                errors.push(SyntaxError::too_big(range, "expression nested too deeply"));
                too_deep.insert(at);
            }
        }
    }
    if !too_deep.is_empty() {
        let mut at = 0;
        module.body.retain(|_| {
            at += 1;
            !too_deep.contains(&(at - 1))
        });
    }
    deepest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parses a program whose errors are written under their lines: `#   ^^ message`.
    fn check(program: &str) {
        let mut clean = String::new();
        let mut expected = Vec::new();
        let mut line_start = 0;
        for line in program.lines() {
            match line.trim_start().strip_prefix('#').filter(|rest| rest.trim_start().starts_with('^')) {
                Some(rest) => {
                    let column = line.find('^').unwrap();
                    let carets = rest.chars().filter(|ch| *ch == '^').count();
                    expected.push((line_start + column, carets, rest.trim_start().trim_start_matches('^').trim().to_string()));
                }
                None => {
                    line_start = clean.len();
                    clean.push_str(line);
                    clean.push('\n');
                }
            }
        }
        let parsed = parse(&clean);
        let found: Vec<_> = parsed
            .errors
            .iter()
            .map(|error| (error.range.start().to_usize(), error.range.len().to_usize(), error.message.clone()))
            .collect();
        assert_eq!(found, expected, "{clean}");
    }

    #[test]
    fn programs_without_errors() {
        check("");
        check("x = [i * 0.5 for i in range(3) if i]\nbed.min.x = max(x)");
        let sum = vec!["a"; 300].join(" + ");
        assert!(parse(&format!("x = {sum}")).is_complete());
        for text in ["\u{feff}x = 1\r\ny = 2\rz = 3", "\x0cx = 1\n\x0c\ny = 2", "if x:\r\n\ty = 1"] {
            assert_eq!(parse(text).errors, [], "{text:?}");
        }
    }

    #[test]
    fn brackets_and_strings() {
        check("a = (1,\n#   ^ '(' was never closed\nb = 2");
        check("a = f(x[1)\n#        ^ closing parenthesis ')' does not match opening parenthesis '['\nb = 2");
        check("a = 1)\n#    ^ unmatched ')'\nb = 2");
        check("a = f('half)\n#     ^^^^^^ unterminated string literal (detected at line 1)\nb = 2");
        check("a = (1]\n#     ^ closing parenthesis ']' does not match opening parenthesis '('\nb = 2");
        check("a = 'half\n#   ^^^^^ unterminated string literal (detected at line 1)\nb = 2");
        check("a = f'{b} half\n#   ^^^^^^^^^^ unterminated f-string literal (detected at line 1)\nb = 2");
        check("a = (1,\n#   ^ '(' was never closed\ndef f(): return 1\nc = = 2\n#   ^ expected an expression");
    }

    #[test]
    fn every_error_is_reported() {
        let parsed = parse("a = = 1\nb = 2\nreturn 3\nc = 4 +\nd = 5\n");
        let lines: Vec<&str> = parsed.errors.iter().map(|error| error.message.as_str()).collect();
        assert_eq!(lines, ["expected an expression", "'return' outside function", "expected an expression"]);
        assert_eq!(parsed.whole_statements().count(), 2);
    }

    #[test]
    fn an_open_bracket_swallows_no_statements() {
        let parsed = parse("a = 1\nb = max(a, \nc = 3\nfor i in range(c):\n    d = [i\nelse:\n    e = 1\nf = 6\n");
        assert_eq!(parsed.errors.iter().map(|error| error.range.start().to_u32()).collect::<Vec<_>>(), [13, 51]);
        let whole: Vec<u32> = parsed.whole_statements().map(|stmt| stmt.range().start().to_u32()).collect();
        assert_eq!(whole, [0, 18, 70]);
    }

    #[test]
    fn too_deep_is_an_error_at_its_place() {
        let deep = |part: &str| parse(&format!("a = 1\nx = {}", part.repeat(50_000)));
        for part in
            ["(", "[", "{", "-", "not ", "lambda: ", "1+", "a.", "f(", "a[", "2**", "a if b else ", "f'{", "lambda x=", "a:=", "await "]
        {
            let parsed = deep(part);
            assert!(parsed.errors.iter().any(|error| error.kind == ErrorKind::TooBig), "{part}: {:?}", parsed.errors);
            assert!(parsed.is_whole(0) && parsed.depth() <= MAX_DEPTH, "{part}");
        }
        let parsed = parse(&format!("a = 1\nx = {}1", "1+".repeat(2000)));
        assert_eq!(parsed.errors.len(), 1);
        assert_eq!(parsed.whole_statements().count(), 1);
    }

    #[test]
    fn fences_are_errors_with_a_fix() {
        let program = "Here's your room:\n\n```python\na = 1\nb = 2\n```\nIt isn't large.\n";
        let parsed = parse(program);
        assert_eq!(parsed.module.body.len(), 2);
        assert!(parsed.errors.iter().all(|error| error.kind == ErrorKind::Fence));
        let mut fixed = program.to_string();
        for (range, text) in parsed.errors[0].fix.as_ref().unwrap().edits.iter().rev() {
            fixed.replace_range(range.start().to_usize()..range.end().to_usize(), text);
        }
        assert_eq!(fixed, "a = 1\nb = 2\n");
        assert!(parse("s = '''\n```\n'''\n").is_complete());
    }
}
