//! A quick look at the text before it is parsed: brackets, strings and nesting.
//!
//! It finds what is said better here than by the parser (a bracket that is never closed, a string
//! that does not end), and where the text would nest deeper than the parser and the walks over its
//! tree should go. There it stops: only the statements before are parsed. It counts generously (each
//! prefix operator, `lambda`, `else`… since the last comma is a level), never too little: the exact
//! depth of the tree is measured afterwards.

use ruff_text_size::{TextRange, TextSize};

use super::error::SyntaxError;

mod code;
mod strings;

/// Brackets inside brackets, as CPython limits them.
const MAX_BRACKETS: usize = 200;
/// Blocks inside blocks, as CPython limits them.
const MAX_INDENTS: usize = 100;
/// Everything that makes the parser call itself, taken together.
const MAX_NESTING: u32 = 400;
/// Operators, attributes and calls in one element of a list: `1 + 1 + …`, `a.b.c…`.
const MAX_CHAIN: u32 = 20_000;
/// Names, numbers, strings, operators and lines in one program.
const MAX_TOKENS: u32 = 500_000;
/// How often the scan goes back because of an open bracket.
const MAX_REWINDS: usize = 20;
/// Nobody reads more than these; what follows is not looked at.
const MAX_ERRORS: usize = 100;

/// What the look at the text found.
#[derive(Default)]
pub(super) struct Scan {
    /// In the order of the text.
    pub(super) errors: Vec<SyntaxError>,
    /// The text from here on is not to be parsed: the start of the statement that is too big.
    pub(super) cut: Option<usize>,
    /// No tree of this text nests deeper than about this.
    pub(super) deepest: u32,
    /// Lines that begin with a Markdown fence, without their line ends.
    pub(super) fences: Vec<TextRange>,
    /// Starts of top-level statements behind brackets that were left open (or closed wrongly): from
    /// each of them the text is to be parsed afresh.
    pub(super) splits: Vec<usize>,
}

/// How far the current element of a list (between two commas, in one pair of brackets) nests.
#[derive(Clone, Copy, Default)]
struct Element {
    /// Unary `-`, `+`, `~`, `**`: until a binary operator.
    tight: u32,
    /// `not`: until `and` or `or`.
    nots: u32,
    /// `lambda` behind its colon, `if`, `else`, `yield`, `:=`…: until the comma.
    loose: u32,
    /// `lambda` before its colon: commas do not end it.
    lambdas: u32,
    /// Binary operators, attributes, calls.
    chain: u32,
}

impl Element {
    fn nesting(self) -> u32 {
        self.tight + self.nots + self.loose + self.lambdas
    }
}

/// What the scanner stands in.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Frame {
    /// One of `(`, `[`, `{`.
    Bracket(u8),
    /// The text of an f-string.
    Text { quote: u8, triple: bool, raw: bool },
    /// A replacement field of it.
    Field,
    /// The format of a field, behind its colon.
    Spec,
}

struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
    scan: Scan,
    /// Frames, where each begins, and the element around each.
    frames: Vec<(Frame, usize, Element)>,
    element: Element,
    /// Sum over `frames` and `element`.
    nesting: u32,
    chain: u32,
    brackets: usize,
    indents: Vec<u32>,
    /// The start of the last line without indentation, outside brackets.
    statement: usize,
    /// The last token ends an operand: what follows is a binary operator.
    operand: bool,
    tokens: u32,
    /// Brackets were closed wrongly since the last split.
    broken: bool,
}

/// Looks through the text.
pub(super) fn scan(text: &str) -> Scan {
    let mut scanner = Scanner {
        bytes: text.as_bytes(),
        at: if text.starts_with('\u{feff}') { 3 } else { 0 },
        scan: Scan::default(),
        frames: Vec::new(),
        element: Element::default(),
        nesting: 0,
        chain: 0,
        brackets: 0,
        indents: Vec::new(),
        statement: 0,
        operand: false,
        tokens: 0,
        broken: false,
    };
    scanner.begin_line();
    scanner.run();
    while scanner.scan.cut.is_none() && scanner.rewind() {
        scanner.run();
    }
    if scanner.scan.cut.is_none() {
        scanner.report_open();
    }
    scanner.scan.errors.sort_by_key(|error| error.range.start());
    scanner.scan
}

/// A range of bytes; texts are shorter than 4 GiB (`MAX_TEXT`).
fn range(start: usize, end: usize) -> TextRange {
    let size = |at: usize| TextSize::new(u32::try_from(at).unwrap_or(u32::MAX));
    TextRange::new(size(start), size(end.max(start)))
}

impl Scanner<'_> {
    fn run(&mut self) {
        while self.at < self.bytes.len() && self.scan.cut.is_none() {
            match self.frames.last() {
                Some((Frame::Text { .. } | Frame::Spec, ..)) => self.text(),
                _ => self.code(),
            }
        }
    }

    /// At the end of the text, with brackets open: goes back to the first statement behind the
    /// outermost of them, which the open bracket swallowed.
    fn rewind(&mut self) -> bool {
        let Some((_, open, _)) = self.frames.first().copied() else { return false };
        if self.scan.splits.len() >= MAX_REWINDS || !self.only_brackets() {
            return false;
        }
        let mut line = self.line_end(open);
        while line < self.bytes.len() && !self.starts_line(line + 1) {
            line = self.line_end(line + 1);
        }
        let split = line + 1;
        if split >= self.bytes.len() {
            return false;
        }
        self.at = split;
        self.scan.errors.retain(|error| error.range.start().to_usize() < split);
        self.scan.fences.retain(|fence| fence.start().to_usize() < split);
        self.frames.retain(|(_, at, _)| *at < split);
        self.restart(split);
        true
    }

    /// Leaves all brackets behind, with an error for those that are open.
    fn restart(&mut self, split: usize) {
        self.report_open();
        while !self.frames.is_empty() {
            self.pop();
        }
        self.end_levels(|_| Element::default());
        self.brackets = 0;
        self.operand = false;
        self.indents.clear();
        self.scan.splits.retain(|before| *before < split);
        self.scan.splits.push(split);
        self.broken = false;
        self.begin_line();
    }

    fn only_brackets(&self) -> bool {
        self.frames.iter().all(|(frame, ..)| matches!(frame, Frame::Bracket(_)))
    }

    /// A top-level statement may begin here: not the rest of one, and no closing bracket.
    fn starts_line(&self, at: usize) -> bool {
        const RESTS: [&[u8]; 4] = [b"else", b"elif", b"except", b"finally"];
        let text = &self.bytes[at.min(self.bytes.len())..];
        matches!(text.first(), Some(b'a'..=b'z' | b'A'..=b'Z' | b'_' | b'@')) && !RESTS.iter().any(|word| text.starts_with(word))
    }

    fn byte(&self, ahead: usize) -> u8 {
        self.bytes.get(self.at + ahead).copied().unwrap_or(b'\n')
    }

    fn error(&mut self, start: usize, end: usize, message: impl Into<String>) {
        self.scan.errors.push(SyntaxError::new(range(start, end), message));
        if self.scan.errors.len() >= MAX_ERRORS {
            self.scan.cut = Some(self.statement);
        }
    }

    /// Ends the scan: the statement that is being read cannot be handled.
    fn stop(&mut self, at: usize, message: impl Into<String>) {
        if self.scan.cut.is_none() {
            let end = (at + 1..self.bytes.len()).find(|end| self.bytes[*end] & 0xC0 != 0x80).unwrap_or(self.bytes.len());
            self.scan.errors.push(SyntaxError::too_big(range(at, end), message));
            self.scan.cut = Some(self.statement);
        }
    }

    fn null_byte(&mut self) {
        self.error(self.at, self.at + 1, "source code cannot contain null bytes");
        self.scan.cut = Some(self.statement);
    }

    /// The element nests one level deeper; `count` says in which way.
    fn deepen(&mut self, count: fn(&mut Element) -> &mut u32) {
        *count(&mut self.element) += 1;
        self.nesting += 1;
        self.check_nesting();
    }

    fn check_nesting(&mut self) {
        self.scan.deepest = self.scan.deepest.max(self.nesting + self.chain);
        if self.nesting + u32::try_from(self.indents.len()).unwrap_or(u32::MAX) > MAX_NESTING {
            self.stop(self.at, "expression nested too deeply");
        }
    }

    fn lengthen(&mut self) {
        self.element.chain += 1;
        self.chain += 1;
        self.scan.deepest = self.scan.deepest.max(self.nesting + self.chain);
        if self.chain > MAX_CHAIN {
            self.stop(self.at, "expression too long");
        }
    }

    /// Some of the element's levels end.
    fn end_levels(&mut self, keep: fn(Element) -> Element) {
        let kept = keep(self.element);
        self.nesting -= self.element.nesting() - kept.nesting();
        self.chain -= self.element.chain - kept.chain;
        self.element = kept;
    }

    fn end_element(&mut self) {
        self.end_levels(|element| Element { lambdas: element.lambdas, ..Element::default() });
        self.operand = false;
    }

    fn push(&mut self, frame: Frame) {
        self.frames.push((frame, self.at, self.element));
        self.element = Element::default();
        self.nesting += 1;
        self.operand = false;
        self.check_nesting();
    }

    fn pop(&mut self) {
        if let Some((_, _, element)) = self.frames.pop() {
            self.end_levels(|_| Element::default());
            self.element = element;
            self.nesting -= 1;
            self.operand = true;
        }
    }

    fn open(&mut self, bracket: u8) {
        if self.operand {
            self.lengthen();
        }
        self.brackets += 1;
        if self.brackets > MAX_BRACKETS {
            self.stop(self.at, "too many nested parentheses");
        }
        self.push(Frame::Bracket(bracket));
        self.at += 1;
    }

    fn close(&mut self, closer: u8) {
        let opener = match closer {
            b')' => b'(',
            b']' => b'[',
            _ => b'{',
        };
        let start = self.at;
        self.at += 1;
        match self.frames.last().copied() {
            Some((Frame::Bracket(open), ..)) if open == opener => self.pop_bracket(),
            Some((Frame::Field, ..)) if closer == b'}' => self.pop(),
            Some((Frame::Bracket(open), open_at, _)) => {
                let line = self.line(open_at);
                let same = line == self.line(start);
                let place = if same { String::new() } else { format!(" on line {line}") };
                let (closer, open) = (char::from(closer), char::from(open));
                self.error(start, start + 1, format!("closing parenthesis '{closer}' does not match opening parenthesis '{open}'{place}"));
                self.broken = true;
                self.close_around(opener);
            }
            _ => {
                self.error(start, start + 1, format!("unmatched '{}'", char::from(closer)));
                self.broken = true;
            }
        }
        self.operand = true;
    }

    /// A closer that does not fit the innermost bracket: it closes an outer one, and those inside
    /// were forgotten; or, where none fits, it is a slip of the keyboard for the innermost's.
    fn close_around(&mut self, opener: u8) {
        let mut brackets = self.frames.iter().rev().take_while(|(frame, ..)| matches!(frame, Frame::Bracket(_)));
        let inner = brackets.position(|(frame, ..)| *frame == Frame::Bracket(opener)).unwrap_or(0);
        for _ in 0..=inner {
            self.pop_bracket();
        }
    }

    fn pop_bracket(&mut self) {
        self.brackets = self.brackets.saturating_sub(1);
        self.pop();
    }

    /// The end of a line: of a statement too, outside brackets.
    fn newline(&mut self) {
        self.at += if self.byte(0) == b'\r' && self.byte(1) == b'\n' && self.at + 1 < self.bytes.len() { 2 } else { 1 };
        if self.starts_statement() {
            self.restart(self.at);
        } else if self.frames.is_empty() {
            self.end_levels(|_| Element::default());
            self.operand = false;
            if self.broken && self.starts_line(self.at) {
                self.restart(self.at);
            } else {
                self.begin_line();
            }
        } else {
            self.fence();
        }
    }

    /// Inside brackets, at the start of a line: a word stands there that no expression holds, so
    /// the brackets were left open.
    fn starts_statement(&self) -> bool {
        const WORDS: [&[u8]; 13] = [
            b"def ", b"class ", b"while ", b"with ", b"return ", b"import ", b"try:", b"del ", b"global ", b"raise ", b"assert ",
            b"pass\n", b"break\n",
        ];
        !self.frames.is_empty() && self.only_brackets() && WORDS.iter().any(|word| self.bytes[self.at..].starts_with(word))
    }

    /// One error for each line on which brackets stay open, at the innermost.
    fn report_open(&mut self) {
        let open: Vec<(Frame, usize)> = self.frames.iter().map(|(frame, at, _)| (*frame, *at)).collect();
        let mut seen: Option<usize> = None;
        for (frame, at) in open.into_iter().rev() {
            if seen.is_some_and(|inner| self.line_end(at) >= inner) {
                continue;
            }
            seen = Some(at);
            match frame {
                Frame::Bracket(open) => self.error(at, at + 1, format!("'{}' was never closed", char::from(open))),
                Frame::Field => self.error(at, at + 1, "'{' was never closed"),
                Frame::Text { triple: true, .. } => self.unterminated(at, "triple-quoted f-string"),
                Frame::Text { .. } => self.unterminated(at, "f-string"),
                Frame::Spec => seen = None,
            }
        }
    }

    fn unterminated(&mut self, start: usize, what: &str) {
        let line = self.line(self.at.min(self.bytes.len()));
        self.error(start, self.at, format!("unterminated {what} literal (detected at line {line})"));
    }

    /// A string that does not end on its line has swallowed the closers of that line's brackets.
    fn close_line(&mut self, string: usize) {
        let line = self.bytes[..string].iter().rposition(|byte| matches!(byte, b'\n' | b'\r')).map_or(0, |end| end + 1);
        self.broken = true;
        while matches!(self.frames.last(), Some((Frame::Bracket(_), at, _)) if *at >= line) {
            self.pop_bracket();
        }
    }

    /// Reads the indentation of a line outside brackets.
    fn begin_line(&mut self) {
        let start = self.at;
        let mut width = 0u32;
        loop {
            match self.bytes.get(self.at) {
                Some(b' ') => width += 1,
                Some(b'\t') => width = (width / 8 + 1) * 8,
                Some(b'\x0c') => width = 0,
                _ => break,
            }
            self.at += 1;
        }
        if matches!(self.bytes.get(self.at), None | Some(b'\n' | b'\r' | b'#')) {
            return;
        }
        while self.indents.last().is_some_and(|outer| *outer > width) {
            self.indents.pop();
        }
        if width > self.indents.last().copied().unwrap_or(0) {
            self.indents.push(width);
            if self.indents.len() > MAX_INDENTS {
                self.stop(start, "too many levels of indentation");
            }
        }
        if width == 0 {
            self.statement = start;
        }
        self.fence();
    }

    /// Notes a line that begins with three backticks, and steps over it.
    fn fence(&mut self) {
        let blanks = self.bytes[self.at..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let start = self.at + blanks;
        if self.bytes[start..].starts_with(b"```") {
            let end = self.line_end(start);
            self.scan.fences.push(range(start, end));
            if self.scan.fences.len() > MAX_ERRORS {
                self.stop(start, "too many Markdown fences");
            }
            self.at = end;
        }
    }

    /// The line of a byte, from 1.
    fn line(&self, at: usize) -> usize {
        let before = &self.bytes[..at];
        let ends =
            before.iter().enumerate().filter(|(i, byte)| **byte == b'\n' || (**byte == b'\r' && self.bytes.get(i + 1) != Some(&b'\n')));
        1 + ends.count()
    }

    fn line_end(&self, from: usize) -> usize {
        self.bytes[from..].iter().position(|byte| matches!(byte, b'\n' | b'\r')).map_or(self.bytes.len(), |length| from + length)
    }
}
