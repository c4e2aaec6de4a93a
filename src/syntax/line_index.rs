//! Where the lines of a text begin, and columns in the units that editors count in.

use ruff_text_size::{TextRange, TextSize};

/// The unit of a column.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Encoding {
    /// Bytes.
    Utf8,
    /// 16-bit code units: what most editors count.
    Utf16,
    /// Characters (code points).
    Utf32,
}

/// A place as line and column, both counted from 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct LineColumn {
    /// The line.
    pub line: u32,
    /// The column, in the unit that was asked for.
    pub column: u32,
}

/// The starts of the lines of one text. A line ends with CR LF, LF or CR.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LineIndex {
    starts: Vec<u32>,
    ascii: bool,
}

impl LineIndex {
    /// Reads the text once.
    pub fn new(text: &str) -> LineIndex {
        let bytes = text.as_bytes();
        let mut starts = vec![0];
        for (at, byte) in bytes.iter().enumerate() {
            if *byte == b'\n' || (*byte == b'\r' && bytes.get(at + 1) != Some(&b'\n')) {
                starts.push(u32::try_from(at + 1).unwrap_or(u32::MAX));
            }
        }
        LineIndex { starts, ascii: text.is_ascii() }
    }

    /// How many lines there are; the one after a final line end counts, so there is at least one.
    pub fn line_count(&self) -> usize {
        self.starts.len()
    }

    /// The line (from 0) that holds the byte.
    pub fn line(&self, offset: TextSize) -> u32 {
        let line = self.starts.partition_point(|start| *start <= offset.to_u32()) - 1;
        u32::try_from(line).unwrap_or(u32::MAX)
    }

    /// The first byte of a line; the end of the text for lines behind it.
    pub fn line_start(&self, line: u32, text: &str) -> TextSize {
        let start = self.starts.get(line as usize).map_or(text.len(), |start| *start as usize);
        TextSize::new(u32::try_from(start.min(text.len())).unwrap_or(u32::MAX))
    }

    /// The bytes of a line without its line end.
    pub fn line_range(&self, line: u32, text: &str) -> TextRange {
        let start = self.line_start(line, text);
        let end = self.line_start(line.saturating_add(1), text);
        let content = text.get(start.to_usize()..end.to_usize()).unwrap_or_default();
        let kept = content.strip_suffix("\r\n").or_else(|| content.strip_suffix(['\n', '\r'])).unwrap_or(content);
        TextRange::at(start, TextSize::of(kept))
    }

    /// Line and column of a byte. One inside a character counts as the start of it, one behind the text as its end.
    pub fn line_column(&self, offset: TextSize, text: &str, encoding: Encoding) -> LineColumn {
        let mut end = offset.to_usize().min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let line = self.line(TextSize::new(u32::try_from(end).unwrap_or(u32::MAX)));
        let start = self.line_start(line, text).to_usize();
        let column = match encoding {
            _ if self.ascii => end - start,
            Encoding::Utf8 => end - start,
            Encoding::Utf16 => text[start..end].chars().map(char::len_utf16).sum(),
            Encoding::Utf32 => text[start..end].chars().count(),
        };
        LineColumn { line, column: u32::try_from(column).unwrap_or(u32::MAX) }
    }

    /// The byte at a line and column. A column behind the line's end is its end, one inside a
    /// character the start of it, a line behind the text its end: as the language server protocol asks.
    pub fn offset(&self, place: LineColumn, text: &str, encoding: Encoding) -> TextSize {
        let range = self.line_range(place.line, text);
        let content = &text[range];
        let mut left = place.column as usize;
        if self.ascii {
            return range.start() + TextSize::new(u32::try_from(left.min(content.len())).unwrap_or(u32::MAX));
        }
        for (at, ch) in content.char_indices() {
            let units = match encoding {
                Encoding::Utf8 => ch.len_utf8(),
                Encoding::Utf16 => ch.len_utf16(),
                Encoding::Utf32 => 1,
            };
            if left < units {
                return range.start() + TextSize::new(u32::try_from(at).unwrap_or(u32::MAX));
            }
            left -= units;
        }
        range.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_in_three_units() {
        let text = "a = 'é😀'\r\nb\rc\n";
        let index = LineIndex::new(text);
        assert_eq!(index.line_count(), 4);
        let quote = TextSize::new(u32::try_from(text.rfind('\'').unwrap()).unwrap());
        let column = |encoding| index.line_column(quote, text, encoding).column;
        assert_eq!((column(Encoding::Utf8), column(Encoding::Utf16), column(Encoding::Utf32)), (11, 8, 7));
        for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
            for (at, _) in text.char_indices().filter(|(_, ch)| !"\r\n".contains(*ch)) {
                let at = TextSize::new(u32::try_from(at).unwrap());
                assert_eq!(index.offset(index.line_column(at, text, encoding), text, encoding), at);
            }
        }
    }

    #[test]
    fn places_outside_the_text_are_brought_inside() {
        let text = "ab\r\ncd";
        let index = LineIndex::new(text);
        assert_eq!(index.offset(LineColumn { line: 0, column: 99 }, text, Encoding::Utf16), TextSize::new(2));
        assert_eq!(index.offset(LineColumn { line: 7, column: 0 }, text, Encoding::Utf16), TextSize::new(6));
        assert_eq!(index.line_column(TextSize::new(99), text, Encoding::Utf8), LineColumn { line: 1, column: 2 });
        assert_eq!(&text[index.line_range(0, text)], "ab");
    }
}
