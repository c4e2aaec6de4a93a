//! The scanner outside strings.

use super::{Element, Frame, MAX_TOKENS, Scanner};

impl Scanner<'_> {
    /// Reads one token or line end, or the blanks before it.
    pub(super) fn code(&mut self) {
        let byte = self.byte(0);
        match byte {
            b' ' | b'\t' | b'\x0c' => {
                while matches!(self.bytes.get(self.at), Some(b' ' | b'\t' | b'\x0c')) {
                    self.at += 1;
                }
                return;
            }
            b'#' => {
                self.at = self.line_end(self.at);
                return;
            }
            _ => {}
        }
        self.tokens += 1;
        if self.tokens > MAX_TOKENS {
            self.stop(self.at, format!("program too long: more than {MAX_TOKENS} tokens"));
        }
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'_' | 0x80.. => self.word(),
            b'0'..=b'9' => {
                while matches!(self.bytes.get(self.at), Some(b'0'..=b'9' | b'a'..=b'z' | b'A'..=b'Z' | b'_' | b'.')) {
                    self.at += 1;
                }
                self.operand = true;
            }
            b'"' | b'\'' => self.string(self.at, false, false),
            b'(' | b'[' | b'{' => self.open(byte),
            b')' | b']' | b'}' => self.close(byte),
            b'\\' => self.continuation(),
            b'\n' | b'\r' => self.newline(),
            0 => self.null_byte(),
            _ => self.operator(byte),
        }
    }

    /// A backslash joins the next line to this one.
    fn continuation(&mut self) {
        self.at += 1;
        if self.byte(0) == b'\r' && self.byte(1) == b'\n' {
            self.at += 1;
        }
        if matches!(self.bytes.get(self.at), Some(b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    fn operator(&mut self, byte: u8) {
        let doubled = self.byte(1) == byte;
        let before = self.operand;
        self.operand = false;
        match byte {
            b',' => self.end_element(),
            b';' => self.end_levels(|_| Element::default()),
            b':' if matches!(self.frames.last(), Some((Frame::Field, ..))) => self.push(Frame::Spec),
            b':' if self.byte(1) == b'=' => {
                self.deepen(|element| &mut element.loose);
                self.at += 1;
            }
            b':' if self.element.lambdas > 0 => {
                self.element.lambdas -= 1;
                self.element.loose += 1;
            }
            b'*' if doubled => {
                self.lengthen();
                self.deepen(|element| &mut element.tight);
                self.at += 1;
            }
            b'*' if !before => self.deepen(|element| &mut element.loose),
            b'~' => self.deepen(|element| &mut element.tight),
            b'+' | b'-' if !before => self.deepen(|element| &mut element.tight),
            b'.' => self.lengthen(),
            b'+' | b'-' | b'*' | b'/' | b'%' | b'@' | b'&' | b'|' | b'^' | b'<' | b'>' | b'=' | b'!' => {
                self.lengthen();
                self.end_levels(|element| Element { tight: 0, ..element });
            }
            _ => {}
        }
        self.at += 1;
    }

    /// A name, a keyword, or the prefix of a string.
    fn word(&mut self) {
        let start = self.at;
        while matches!(self.bytes.get(self.at), Some(b'0'..=b'9' | b'a'..=b'z' | b'A'..=b'Z' | b'_' | 0x80..)) {
            self.at += 1;
        }
        let word = &self.bytes[start..self.at];
        if word.len() <= 2 && matches!(self.byte(0), b'"' | b'\'') && self.at < self.bytes.len() {
            let has = |letter: u8| word.iter().any(|byte| byte.eq_ignore_ascii_case(&letter));
            let letters = word.iter().all(|byte| b"rbuftRBUFT".contains(byte));
            let twice = word.len() == 2 && word[0].eq_ignore_ascii_case(&word[1]);
            if letters && !twice && (word.len() == 1 || (has(b'r') && !has(b'u'))) {
                self.string(start, has(b'f') || has(b't'), has(b'r'));
                return;
            }
        }
        // The longest keyword has eight letters, and all of them are small.
        if word.len() > 8 || !word[0].is_ascii_lowercase() {
            self.operand = true;
            return;
        }
        self.operand = false;
        match word {
            b"not" => self.deepen(|element| &mut element.nots),
            b"and" | b"or" => {
                self.lengthen();
                self.end_levels(|element| Element { tight: 0, nots: 0, ..element });
            }
            b"in" | b"is" => {
                self.lengthen();
                self.end_levels(|element| Element { tight: 0, ..element });
            }
            b"lambda" => self.deepen(|element| &mut element.lambdas),
            b"await" | b"async" | b"yield" | b"if" | b"elif" | b"else" | b"for" | b"while" | b"with" | b"def" | b"class" | b"try"
            | b"except" | b"finally" => self.deepen(|element| &mut element.loose),
            // Soft keywords: names elsewhere, so what follows may be either.
            b"match" | b"case" => {
                self.deepen(|element| &mut element.loose);
                self.operand = true;
            }
            b"return" | b"from" | b"import" | b"as" | b"assert" | b"raise" | b"del" | b"global" | b"nonlocal" | b"pass" | b"break"
            | b"continue" => {}
            _ => self.operand = true,
        }
    }
}
