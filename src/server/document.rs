//! A document as the client has it: a rope, its version, and what it is to us.

use super::moved::TextChange;
use super::reading::Painted;
use crate::syntax::Encoding;
use ropey::Rope;
use std::path::{Path, PathBuf};
use tower_lsp_server::ls_types::{Position, TextDocumentContentChangeEvent, Uri};

/// The ending of sidecar templates, after the name of their program.
const TEMPLATE: &str = ".template.json";
/// The ending of programs.
const PROGRAM: &str = "psdl";

/// What a document is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Role {
    /// A scene program.
    Program,
    /// The template of a program, beside it.
    Template,
    /// A `psdl.toml`.
    Config,
    /// Nothing of ours: it is kept, for the client may ask, but nobody looks at it.
    Other,
}

/// An open document.
#[derive(Clone, Debug)]
pub(super) struct Document {
    pub uri: Uri,
    pub path: Option<PathBuf>,
    pub role: Role,
    pub version: i32,
    pub text: Rope,
    /// The semantic tokens that the client has.
    pub painted: Option<Painted>,
}

impl Document {
    pub(super) fn new(uri: Uri, language: &str, version: i32, text: &str) -> Document {
        let path = file_path(&uri);
        let role = role(path.as_deref(), language);
        Document { uri, path, role, version, text: Rope::from_str(text), painted: None }
    }

    /// Makes a change, and says which bytes it replaced.
    pub(super) fn apply(&mut self, change: &TextDocumentContentChangeEvent, encoding: Encoding) -> TextChange {
        match change.range {
            Some(range) => {
                let (from, to) = (self.char(range.start, encoding), self.char(range.end, encoding));
                self.replace(from.min(to), from.max(to), &change.text)
            }
            None => self.replace_whole(&change.text),
        }
    }

    fn replace(&mut self, from: usize, to: usize, text: &str) -> TextChange {
        let (start, end) = (self.text.char_to_byte(from), self.text.char_to_byte(to));
        self.text.remove(from..to);
        self.text.insert(from, text);
        TextChange { start, end, length: text.len() }
    }

    /// The same as a change of what lies between the first and the last difference: places outside of it keep their meaning.
    fn replace_whole(&mut self, text: &str) -> TextChange {
        let old = &self.text;
        let same = old.chars().zip(text.chars()).take_while(|(a, b)| a == b);
        let (before, bytes) = same.fold((0, 0), |(chars, bytes), (ch, _)| (chars + 1, bytes + ch.len_utf8()));
        let room = (old.len_chars() - before).min(text[bytes..].chars().count());
        let mut ends = old.chars_at(old.len_chars());
        let mut news = text.chars().rev();
        let mut after = (0, 0);
        while after.0 < room {
            match (ends.prev(), news.next()) {
                (Some(a), Some(b)) if a == b => after = (after.0 + 1, after.1 + a.len_utf8()),
                _ => break,
            }
        }
        let to = old.len_chars() - after.0;
        let middle = text[bytes..text.len() - after.1].to_string();
        self.replace(before, to, &middle)
    }

    /// The character at a position. Behind the end of a line means its end, behind the last line the end of the text,
    /// inside of a character the start of it.
    fn char(&self, position: Position, encoding: Encoding) -> usize {
        let line = position.line as usize;
        if line >= self.text.len_lines() {
            return self.text.len_chars();
        }
        let start = self.text.line_to_char(line);
        let content = self.text.line(line);
        let mut length = content.len_chars();
        while length > 0 && matches!(content.char(length - 1), '\n' | '\r') {
            length -= 1;
        }
        let content = content.slice(..length);
        let column = position.character as usize;
        let chars = match encoding {
            Encoding::Utf8 => content.byte_to_char(column.min(content.len_bytes())),
            Encoding::Utf16 => content.utf16_cu_to_char(column.min(content.len_utf16_cu())),
            Encoding::Utf32 => column.min(length),
        };
        start + chars
    }

    /// Whether a position lies in the text: no client that is in step with the server sends another.
    pub(super) fn holds(&self, position: Position) -> bool {
        (position.line as usize) < self.text.len_lines()
    }
}

/// The path of a file; documents of other schemes have none.
pub(super) fn file_path(uri: &Uri) -> Option<PathBuf> {
    if !uri.scheme().as_str().eq_ignore_ascii_case("file") {
        return None;
    }
    uri.to_file_path().map(std::borrow::Cow::into_owned).filter(|path| path.is_absolute())
}

/// What the file is, going by its name.
pub(super) fn role(path: Option<&Path>, language: &str) -> Role {
    let name = path.and_then(Path::file_name).map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    if name == crate::config::FILE_NAME {
        Role::Config
    } else if name.ends_with(TEMPLATE) {
        Role::Template
    } else if language == PROGRAM || path.and_then(Path::extension).is_some_and(|ending| ending == PROGRAM) {
        Role::Program
    } else {
        Role::Other
    }
}

/// Where the template of a program stands.
pub(super) fn template_of(program: &Path) -> PathBuf {
    program.with_extension(&TEMPLATE[1..])
}

/// Where the program of a template stands, if it is called as programs are.
pub(super) fn program_of(template: &Path) -> Option<PathBuf> {
    let name = template.file_name()?.to_str()?.strip_suffix(TEMPLATE)?;
    Some(template.with_file_name(format!("{name}.{PROGRAM}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::str::FromStr;
    use tower_lsp_server::ls_types::Range;

    fn document(text: &str) -> Document {
        Document::new(Uri::from_str("file:///a/b.psdl").unwrap(), "psdl", 1, text)
    }

    fn change(from: (u32, u32), to: (u32, u32), text: &str) -> TextDocumentContentChangeEvent {
        let range = Range::new(Position::new(from.0, from.1), Position::new(to.0, to.1));
        TextDocumentContentChangeEvent { range: Some(range), range_length: None, text: text.into() }
    }

    #[test]
    fn columns_are_counted_as_agreed() {
        for (encoding, column) in [(Encoding::Utf8, 5), (Encoding::Utf16, 3), (Encoding::Utf32, 2)] {
            let mut document = document("x\r\né😀b\n");
            // é takes 2 bytes or 1 unit, 😀 takes 4 bytes, 2 units or 1 character.
            let column = if encoding == Encoding::Utf8 { column + 1 } else { column };
            document.apply(&change((1, column), (1, column + 1), "!"), encoding);
            assert_eq!(document.text.to_string(), "x\r\né😀!\n", "{encoding:?}");
        }
    }

    #[test]
    fn what_lies_outside_is_brought_inside_and_what_is_turned_is_turned_back() {
        let mut document = document("ab\ncd");
        document.apply(&change((0, 99), (0, 99), "!"), Encoding::Utf16);
        document.apply(&change((99, 0), (1, 1), "?"), Encoding::Utf16);
        assert_eq!(document.text.to_string(), "ab!\nc?");
        assert!(document.holds(Position::new(1, 7)) && !document.holds(Position::new(2, 0)));
    }

    #[test]
    fn the_middle_of_a_character_is_its_start() {
        let mut document = document("a😀b");
        document.apply(&change((0, 2), (0, 3), ""), Encoding::Utf16);
        assert_eq!(document.text.to_string(), "ab");
    }

    #[test]
    fn of_a_whole_new_text_only_the_difference_counts() {
        for (old, new, expected) in [
            ("one two three", "one 2 three", TextChange { start: 4, end: 7, length: 1 }),
            ("aa", "aaa", TextChange { start: 2, end: 2, length: 1 }),
            ("aaa", "aa", TextChange { start: 2, end: 3, length: 0 }),
            ("", "é", TextChange { start: 0, end: 0, length: 2 }),
        ] {
            let mut document = document(old);
            let whole = TextDocumentContentChangeEvent { range: None, range_length: None, text: new.into() };
            assert_eq!(document.apply(&whole, Encoding::Utf16), expected);
            assert_eq!(document.text.to_string(), new);
        }
    }

    #[test]
    fn programs_and_templates_find_each_other() {
        assert_eq!(template_of(Path::new("/a/b.psdl")), Path::new("/a/b.template.json"));
        assert_eq!(program_of(Path::new("/a/b.template.json")).as_deref(), Some(Path::new("/a/b.psdl")));
        assert_eq!(role(Some(Path::new("/a/b.template.json")), "json"), Role::Template);
        assert_eq!(role(Some(Path::new("/a/psdl.toml")), "toml"), Role::Config);
        assert_eq!((role(None, "psdl"), role(Some(Path::new("/a/b.py")), "python")), (Role::Program, Role::Other));
    }
}
