//! What is being written at a place, told from the text alone: it works on a line that does not parse.

/// Where in the text a place is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Context<'t> {
    /// The part of a word before the place.
    pub prefix: &'t str,
    /// What stands before the word.
    pub place: Place<'t>,
    /// The innermost call that is open.
    pub call: Option<Call<'t>>,
    /// The word is the first of its line, and of its statement.
    pub first: bool,
}

/// What stands before the word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Place<'t> {
    /// The place is in a comment, a string or a number.
    Nowhere,
    /// `RECEIVER.`
    Member(&'t str),
    /// `facing =`
    Facing,
    /// `support =`
    Support,
    /// `import `
    Import,
    /// `from MODULE import `
    From(&'t str),
    /// `def `, `class `, `for `, `as `: a new name.
    NewName,
    /// Anything else.
    Expression,
}

/// A call whose bracket is open.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Call<'t> {
    /// What is called: `Object`, `math.sin`, `chairs[0].append`.
    pub callee: &'t str,
    /// The byte of the bracket.
    pub open: usize,
    /// The arguments so far, the last one as far as it is written.
    pub arguments: Vec<&'t str>,
    /// No other bracket is open inside of it.
    pub is_innermost: bool,
}

impl<'t> Call<'t> {
    /// The keyword that an argument is given by.
    pub(super) fn keyword(argument: &'t str) -> Option<&'t str> {
        let (name, rest) = argument.split_once('=')?;
        let name = name.trim();
        (is_word(name) && !rest.starts_with('=')).then_some(name)
    }
}

struct Open {
    at: usize,
    /// Where each element begins.
    starts: Vec<usize>,
    /// It is the brace of an f-string.
    field: bool,
}

fn is_word(text: &str) -> bool {
    !text.is_empty() && text.chars().all(is_part) && !text.starts_with(|ch: char| ch.is_ascii_digit())
}

fn is_part(ch: char) -> bool {
    ch == '_' || ch.is_alphanumeric()
}

/// Tells where a place is.
pub(super) fn context(text: &str, offset: usize) -> Context<'_> {
    let before = &text[..text.floor_char_boundary(offset.min(text.len()))];
    let scan = scan(before);
    let prefix_start = before.rfind(|ch| !is_part(ch)).map_or(0, |at| at + before[at..].chars().next().map_or(1, char::len_utf8));
    let prefix = &before[prefix_start..];
    let call = call(before, &scan.open);
    if scan.quoted || prefix.starts_with(|ch: char| ch.is_ascii_digit()) {
        return Context { prefix: "", place: Place::Nowhere, call, first: false };
    }
    let statement = &before[scan.statement.min(prefix_start)..prefix_start];
    let first = statement.trim().is_empty() && scan.open.is_empty();
    Context { prefix, place: place(before, prefix_start, statement), call, first }
}

struct Scan {
    open: Vec<Open>,
    /// The place is in a string or a comment.
    quoted: bool,
    /// Where the statement begins.
    statement: usize,
}

/// An f-string that is open: what stands in its braces is code.
struct FString {
    quote: u8,
    triple: bool,
    /// How many brackets are open around it.
    depth: usize,
}

/// Goes through the text up to the place. A line that begins at its very start ends whatever bracket was left open.
fn scan(before: &str) -> Scan {
    let mut scanner = Scanner { text: before, at: 0, open: Vec::new(), strings: Vec::new(), statement: 0 };
    let quoted = scanner.code().is_none();
    Scan { open: scanner.open, quoted, statement: scanner.statement }
}

struct Scanner<'t> {
    text: &'t str,
    at: usize,
    open: Vec<Open>,
    /// The f-strings in whose braces the place is.
    strings: Vec<FString>,
    statement: usize,
}

impl Scanner<'_> {
    /// Goes through code; `None` where the text ends in a string or a comment.
    fn code(&mut self) -> Option<()> {
        let bytes = self.text.as_bytes();
        while self.at < bytes.len() {
            let at = self.at;
            self.at += 1;
            match bytes[at] {
                b'#' if self.strings.is_empty() => self.at = at + self.text[at..].find('\n')?,
                quote @ (b'"' | b'\'') if is_formatted(&bytes[..at]) => {
                    let triple = bytes[at..].starts_with(&[quote; 3]);
                    self.at += if triple { 2 } else { 0 };
                    self.strings.push(FString { quote, triple, depth: self.open.len() });
                    self.formatted()?;
                }
                quote @ (b'"' | b'\'') => self.at = string_end(self.text, at, quote)?,
                b'(' | b'[' | b'{' => self.open.push(Open { at, starts: vec![at + 1], field: false }),
                b'}' | b':' if self.open.last().is_some_and(|inner| inner.field) => {
                    self.open.pop();
                    self.formatted()?;
                }
                b')' | b']' | b'}' => {
                    self.open.pop();
                }
                b',' => self.open.last_mut().into_iter().for_each(|inner| inner.starts.push(at + 1)),
                b'\n' | b'\r' => self.line_ends(),
                // `if a: b.min.x = …`; an annotation or a lambda looks the same and does no harm.
                b':' if self.open.is_empty() && bytes.get(at + 1) == Some(&b' ') => self.statement = self.at,
                b';' if self.open.is_empty() => self.statement = self.at,
                _ => {}
            }
        }
        Some(())
    }

    fn line_ends(&mut self) {
        if let Some(first) = self.strings.iter().position(|string| !string.triple) {
            self.open.truncate(self.strings[first].depth);
            self.strings.truncate(first);
        }
        let next = self.text.as_bytes().get(self.at);
        if next.is_some_and(|next| !matches!(next, b' ' | b'\t' | b'\n' | b'\r' | b')' | b']' | b'}' | b'#')) {
            self.open.retain(|inner| inner.field);
        }
        if self.open.is_empty() {
            self.statement = self.at;
        }
    }

    /// Goes through the text of the innermost f-string, to the next brace with code or behind its end; `None` where the text ends before.
    fn formatted(&mut self) -> Option<()> {
        let bytes = self.text.as_bytes();
        let Some(&FString { quote, triple, .. }) = self.strings.last() else { return Some(()) };
        while self.at < bytes.len() {
            match bytes[self.at] {
                b'\\' => self.at += 2,
                b'{' if bytes.get(self.at + 1) == Some(&b'{') => self.at += 2,
                b'{' => {
                    self.open.push(Open { at: self.at, starts: vec![self.at + 1], field: true });
                    self.at += 1;
                    return Some(());
                }
                // One with simple quotes ends with its line.
                b'\n' if !triple => {
                    self.strings.pop();
                    return Some(());
                }
                byte if byte == quote && (!triple || bytes[self.at..].starts_with(&[quote; 3])) => {
                    self.at += if triple { 3 } else { 1 };
                    self.strings.pop();
                    return Some(());
                }
                _ => self.at += 1,
            }
        }
        None
    }
}

/// Whether the letters before a quote make it an f-string.
fn is_formatted(before: &[u8]) -> bool {
    let letters = before.iter().rev().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_' || !byte.is_ascii()).count();
    let prefix = &before[before.len() - letters..];
    matches!(prefix.to_ascii_lowercase().as_slice(), b"f" | b"fr" | b"rf")
}

/// Behind the end of a string that begins at a quote; `None` where it does not end. One with simple quotes ends with its line.
fn string_end(text: &str, start: usize, quote: u8) -> Option<usize> {
    let bytes = text.as_bytes();
    let triple = bytes[start..].starts_with(&[quote; 3]);
    let mut at = start + if triple { 3 } else { 1 };
    while at < bytes.len() {
        match bytes[at] {
            b'\\' => at += 2,
            b'\n' if !triple => return Some(at),
            byte if byte == quote && !triple => return Some(at + 1),
            byte if byte == quote && bytes[at..].starts_with(&[quote; 3]) => return Some(at + 3),
            _ => at += 1,
        }
    }
    None
}

/// The innermost call that is open. What stands in the braces of an f-string is no part of the call around the string.
fn call<'t>(before: &'t str, open: &[Open]) -> Option<Call<'t>> {
    let inside = open.iter().rev().take_while(|inner| !inner.field);
    inside.enumerate().find_map(|(depth, inner)| {
        let callee = receiver(&before[..inner.at]);
        let called = before.as_bytes()[inner.at] == b'(' && !callee.is_empty() && !KEYWORDS.contains(&callee);
        let ends = inner.starts.iter().skip(1).map(|start| start - 1).chain([before.len()]);
        called.then(|| {
            let arguments = inner.starts.iter().zip(ends).map(|(start, end)| before[*start..end].trim_start()).collect();
            Call { callee, open: inner.at, arguments, is_innermost: depth == 0 }
        })
    })
}

/// Words before a bracket that call nothing.
const KEYWORDS: [&str; 17] =
    ["and", "or", "not", "in", "is", "if", "else", "elif", "while", "for", "return", "yield", "lambda", "assert", "del", "raise", "import"];

/// The expression of names, attributes, indices and calls that ends here: `chairs[0].min`.
fn receiver(text: &str) -> &str {
    let bytes = text.as_bytes();
    let mut at = text.len();
    loop {
        let word = text[..at].trim_end_matches(is_part).len();
        if word < at {
            at = word;
            if at > 0 && bytes[at - 1] == b'.' {
                at -= 1;
                continue;
            }
            return &text[at..];
        }
        let closing = at.checked_sub(1).map(|last| bytes[last]);
        match closing {
            Some(b')' | b']') => match opening(bytes, at - 1) {
                Some(open) => at = open,
                None => return &text[at..],
            },
            Some(b'"' | b'\'') => return "\"\"",
            _ => return &text[at..],
        }
    }
}

/// The bracket that belongs to a closing one.
fn opening(bytes: &[u8], close: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for at in (0..=close).rev() {
        match bytes[at] {
            b')' | b']' | b'}' => depth += 1,
            b'(' | b'[' | b'{' => {
                depth -= 1;
                if depth == 0 {
                    return Some(at);
                }
            }
            b'\n' => return None,
            _ => {}
        }
    }
    None
}

fn place<'t>(before: &'t str, prefix_start: usize, statement: &'t str) -> Place<'t> {
    let head = &before[..prefix_start];
    if let Some(rest) = head.strip_suffix('.') {
        let receiver = receiver(rest);
        // `1.` is a number.
        return if receiver.starts_with(|ch: char| ch.is_ascii_digit()) { Place::Nowhere } else { Place::Member(receiver) };
    }
    let trimmed = head.trim_end_matches([' ', '\t']);
    let assigned = trimmed.trim_end_matches('=');
    if assigned.len() < trimmed.len() {
        let left = assigned.trim_end_matches([' ', '\t', '!']);
        let word = &left[left.trim_end_matches(is_part).len()..];
        match word {
            "facing" => return Place::Facing,
            "support" => return Place::Support,
            _ => {}
        }
    }
    let words: Vec<&str> = statement.split_whitespace().collect();
    match words[..] {
        ["from"] => Place::Import,
        ["import", ..] if words.last() != Some(&"as") => Place::Import,
        ["from", module, "import", ..] if words.last() != Some(&"as") => Place::From(module),
        ["def" | "class"] | [.., "as" | "for" | "global" | "nonlocal"] if statement.ends_with([' ', '\t']) => Place::NewName,
        _ => Place::Expression,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(marked: &str) -> Context<'_> {
        let (before, _) = marked.split_once("$0").unwrap();
        context(before, before.len())
    }

    #[test]
    fn members() {
        assert_eq!(at("x = bed.$0").place, Place::Member("bed"));
        assert_eq!(at("x = (chairs[i + 1].min.ma$0").place, Place::Member("chairs[i + 1].min"));
        assert_eq!(at("f(a, b).$0").place, Place::Member("f(a, b)"));
        assert_eq!(at("x = 1.$0").place, Place::Nowhere);
        assert_eq!(at("'a'.$0").place, Place::Member("\"\""));
    }

    #[test]
    fn words_in_strings_and_comments_are_left_alone() {
        for text in ["# be$0", "x = 'be$0", "x = \"\"\"a\nbe$0", "x = f(\"a, b$0"] {
            assert_eq!(at(text).place, Place::Nowhere, "{text}");
        }
        for text in ["x = f'be$0", "x = f'{bed} be$0", "x = f'{bed:.be$0", "x = f'{{be$0", "x = bf'{be$0", "x = f'{bed['be$0"] {
            assert_eq!(at(text).place, Place::Nowhere, "{text}");
        }
        assert_eq!(at("x = 'a' + be$0").place, Place::Expression);
        assert_eq!(at("x = 'never ended\nbe$0").place, Place::Expression);
    }

    #[test]
    fn the_braces_of_f_strings_hold_code() {
        let texts = [
            "x = f'{be$0",
            "print(f\"a {{}} {x:.2f} {be$0",
            "x = rf'{ be$0",
            "x = f\"\"\"\n{be$0",
            "x = f'{a:{be$0",
            "x = f'{d['a']} {be$0",
        ];
        for text in texts {
            let found = at(text);
            assert_eq!((found.place, found.prefix, found.call), (Place::Expression, "be", None), "{text}");
        }
        assert_eq!(at("print(f'{bed.mi$0").place, Place::Member("bed"));
        assert_eq!(at("print(f'{len(be$0").call.unwrap().callee, "len");
        assert_eq!(at("print(f'{bed}', be$0").call.unwrap().callee, "print");
        let next = at("x = f'{never ended\nbe$0");
        assert!(next.first && next.call.is_none());
    }

    #[test]
    fn facings_and_supports() {
        assert_eq!(at("bed.facing = $0").place, Place::Facing);
        assert_eq!(at("bed.facing=X_$0").place, Place::Facing);
        assert_eq!(at("if bed.facing == $0").place, Place::Facing);
        assert_eq!(at("a = Object('A', support=$0").place, Place::Support);
        assert_eq!(at("import $0").place, Place::Import);
        assert_eq!(at("from math import si$0").place, Place::From("math"));
    }

    #[test]
    fn calls() {
        let call = at("a = Object('A, B', width=1, de$0").call.unwrap();
        assert_eq!((call.callee, call.arguments), ("Object", vec!["'A, B'", "width=1", "de"]));
        assert_eq!(Call::keyword("width=1"), Some("width"));
        assert_eq!(Call::keyword("a == 1"), None);
        assert_eq!(at("f(g(1), [2, 3$0").call.unwrap().callee, "f");
        assert_eq!(at("f(g(1), 2)$0").call, None);
        assert_eq!(at("f(1,\nbed.mi$0").call, None);
        assert!(at("for a in b: be$0").first && at("    be$0").first && !at("x = be$0").first);
    }
}
