//! The scanner in strings.

use super::{Frame, Scanner};

impl Scanner<'_> {
    /// A string whose quotes are next; `start` is its prefix.
    pub(super) fn string(&mut self, start: usize, fields: bool, raw: bool) {
        let quote = self.byte(0);
        let triple = self.bytes[self.at..].starts_with(&[quote; 3]);
        if fields {
            let quotes = self.at;
            self.at = start;
            self.push(Frame::Text { quote, triple, raw });
            self.at = quotes + if triple { 3 } else { 1 };
            return;
        }
        self.at += if triple { 3 } else { 1 };
        self.operand = true;
        while let Some(byte) = self.bytes.get(self.at) {
            match byte {
                b'\\' => self.escape(),
                b'\n' | b'\r' if !triple => break,
                0 => {
                    self.null_byte();
                    return;
                }
                byte if *byte == quote && (!triple || self.bytes[self.at..].starts_with(&[quote; 3])) => {
                    self.at += if triple { 3 } else { 1 };
                    return;
                }
                _ => self.at += 1,
            }
        }
        self.unterminated(start, if triple { "triple-quoted string" } else { "string" });
        if !triple {
            self.close_line(start);
        }
    }

    /// A backslash and what it protects.
    fn escape(&mut self) {
        self.at += if self.byte(1) == b'\r' && self.bytes.get(self.at + 2) == Some(&b'\n') { 3 } else { 2 };
        self.at = self.at.min(self.bytes.len());
    }

    /// One step in the text of an f-string or in the format of a field.
    pub(super) fn text(&mut self) {
        let Some((quote, triple, raw)) = self.frames.iter().rev().find_map(|(frame, ..)| match frame {
            Frame::Text { quote, triple, raw } => Some((*quote, *triple, *raw)),
            _ => None,
        }) else {
            self.pop();
            return;
        };
        let in_spec = matches!(self.frames.last(), Some((Frame::Spec, ..)));
        match self.byte(0) {
            b'\\' if matches!(self.byte(1), b'{' | b'}') => self.at += 1,
            b'\\' if !raw && self.byte(1) == b'N' && self.byte(2) == b'{' => {
                self.at += self.bytes[self.at..].iter().position(|byte| matches!(byte, b'}' | b'\n' | b'\r' | b'"' | b'\'')).unwrap_or(3);
            }
            b'\\' => self.escape(),
            b'{' if !in_spec && self.byte(1) == b'{' => self.at += 2,
            b'{' => {
                self.push(Frame::Field);
                self.at += 1;
            }
            b'}' if in_spec => {
                self.pop();
                self.pop();
                self.at += 1;
            }
            b'\n' | b'\r' if !triple && in_spec => self.pop(),
            b'\n' | b'\r' if !triple => {
                let start = self.frames.last().map_or(self.at, |(_, start, _)| *start);
                self.unterminated(start, "f-string");
                self.pop();
                self.close_line(start);
            }
            0 => self.null_byte(),
            byte if byte == quote && (!triple || self.bytes[self.at..].starts_with(&[quote; 3])) => {
                while !matches!(self.frames.last(), Some((Frame::Text { .. }, ..)) | None) {
                    self.pop();
                }
                self.pop();
                self.at += if triple { 3 } else { 1 };
            }
            _ => self.at += 1,
        }
    }
}
