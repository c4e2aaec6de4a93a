//! Encodings: `str.encode` and `bytes.decode`.

use super::quote::push_escape;
use std::fmt::Write;

/// A text encoding.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Encoding {
    /// `utf-8`, with a byte order mark or without.
    Utf8 {
        /// `utf-8-sig`
        mark: bool,
    },
    /// `ascii`
    Ascii,
    /// `latin-1`
    Latin1,
    /// `utf-16` and `utf-32`: units of so many bytes.
    Wide {
        /// 2 or 4.
        unit: usize,
        /// The order of bytes; `None`: little, told by a mark.
        big: Option<bool>,
    },
}

/// What is done about what cannot be converted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Handler {
    Strict,
    Ignore,
    Replace,
    BackslashReplace,
    XmlCharRefReplace,
}

/// Why a conversion failed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CodecError {
    /// A UnicodeEncodeError or UnicodeDecodeError: the codec's name, and which characters or bytes it is about.
    Unicode {
        /// As messages name it.
        codec: &'static str,
        /// The first character or byte…
        start: usize,
        /// …and the one behind the last.
        end: usize,
        /// Why.
        reason: String,
    },
    /// A TypeError, with its message.
    Type(&'static str),
    /// The handler's name is not known: a LookupError.
    Handler,
}

impl Encoding {
    /// The encoding of this name.
    pub fn by_name(name: &str) -> Option<Encoding> {
        let name: String = name.chars().map(|c| if matches!(c, '_' | ' ') { '-' } else { c.to_ascii_lowercase() }).collect();
        let wide = |unit, big| Some(Encoding::Wide { unit, big });
        match name.as_str() {
            "utf-8" | "utf8" | "u8" | "utf" | "cp65001" => Some(Encoding::Utf8 { mark: false }),
            "utf-8-sig" => Some(Encoding::Utf8 { mark: true }),
            "ascii" | "us-ascii" | "646" | "ansi-x3.4-1968" | "iso646-us" => Some(Encoding::Ascii),
            "latin-1" | "latin1" | "latin" | "iso-8859-1" | "iso8859-1" | "8859" | "cp819" | "l1" => Some(Encoding::Latin1),
            "utf-16" | "utf16" | "u16" => wide(2, None),
            "utf-16-le" | "utf-16le" => wide(2, Some(false)),
            "utf-16-be" | "utf-16be" => wide(2, Some(true)),
            "utf-32" | "utf32" | "u32" => wide(4, None),
            "utf-32-le" | "utf-32le" => wide(4, Some(false)),
            "utf-32-be" | "utf-32be" => wide(4, Some(true)),
            _ => None,
        }
    }
}

impl Handler {
    /// The handler of this name.
    pub fn by_name(name: &str) -> Option<Handler> {
        Some(match name {
            "strict" => Handler::Strict,
            "ignore" => Handler::Ignore,
            "replace" => Handler::Replace,
            "backslashreplace" => Handler::BackslashReplace,
            "xmlcharrefreplace" => Handler::XmlCharRefReplace,
            _ => return None,
        })
    }
}

/// `text.encode(encoding, errors)`; `None` for a handler whose name is not known, which matters only once it is needed.
pub fn encode(text: &str, encoding: Encoding, handler: Option<Handler>) -> Result<Vec<u8>, CodecError> {
    match encoding {
        Encoding::Utf8 { mark } => {
            let mut out = if mark { b"\xef\xbb\xbf".to_vec() } else { Vec::new() };
            out.extend_from_slice(text.as_bytes());
            Ok(out)
        }
        Encoding::Ascii => encode_narrow(text, "ascii", 128, handler),
        Encoding::Latin1 => encode_narrow(text, "latin-1", 256, handler),
        Encoding::Wide { unit, big } => {
            let mut out = Vec::with_capacity((text.len() + 1) * unit);
            let mut put = |code: u32| {
                let bytes = if big == Some(true) { code.to_be_bytes() } else { code.to_le_bytes() };
                out.extend_from_slice(if big == Some(true) { &bytes[4 - unit..] } else { &bytes[..unit] });
            };
            if big.is_none() {
                put(0xFEFF);
            }
            for c in text.chars() {
                if unit == 4 {
                    put(c as u32);
                } else {
                    c.encode_utf16(&mut [0; 2]).iter().for_each(|half| put(u32::from(*half)));
                }
            }
            Ok(out)
        }
    }
}

fn encode_narrow(text: &str, codec: &'static str, limit: u32, handler: Option<Handler>) -> Result<Vec<u8>, CodecError> {
    if text.is_ascii() {
        return Ok(text.as_bytes().to_vec());
    }
    let mut out = Vec::with_capacity(text.len());
    for (i, c) in text.chars().enumerate() {
        if (c as u32) < limit {
            out.push(c as u32 as u8);
            continue;
        }
        match handler.ok_or(CodecError::Handler)? {
            Handler::Strict => {
                let more = text.chars().skip(i).take_while(|c| *c as u32 >= limit).count();
                let reason = format!("ordinal not in range({limit})");
                return Err(CodecError::Unicode { codec, start: i, end: i + more, reason });
            }
            Handler::Ignore => {}
            Handler::Replace => out.push(b'?'),
            Handler::BackslashReplace => {
                let mut shown = String::new();
                push_escape(&mut shown, c);
                out.extend_from_slice(shown.as_bytes());
            }
            Handler::XmlCharRefReplace => out.extend_from_slice(format!("&#{};", c as u32).as_bytes()),
        }
    }
    Ok(out)
}

/// The text of a UnicodeEncodeError: which characters cannot be encoded, of which the first is this.
pub fn encode_message(codec: &str, first: Option<char>, start: i64, end: i64, reason: &str) -> String {
    match first.filter(|_| end - start == 1) {
        Some(c) => {
            let mut shown = String::new();
            push_escape(&mut shown, c);
            format!("'{codec}' codec can't encode character '{shown}' in position {start}: {reason}")
        }
        None => format!("'{codec}' codec can't encode characters in position {start}-{}: {reason}", end - 1),
    }
}

/// The text of a UnicodeDecodeError: which bytes cannot be decoded, of which the first is this.
pub fn decode_message(codec: &str, first: Option<u8>, start: i64, end: i64, reason: &str) -> String {
    match first.filter(|_| end - start == 1) {
        Some(byte) => format!("'{codec}' codec can't decode byte {byte:#04x} in position {start}: {reason}"),
        None => format!("'{codec}' codec can't decode bytes in position {start}-{}: {reason}", end - 1),
    }
}

/// A decoding under way.
struct Decoder<'a> {
    name: &'static str,
    bytes: &'a [u8],
    handler: Option<Handler>,
    out: String,
}

impl Decoder<'_> {
    /// Deals with bytes that mean nothing.
    fn fail(&mut self, start: usize, end: usize, reason: &str) -> Result<(), CodecError> {
        match self.handler.ok_or(CodecError::Handler)? {
            Handler::Strict => Err(CodecError::Unicode { codec: self.name, start, end, reason: reason.into() }),
            Handler::Ignore => Ok(()),
            Handler::Replace => {
                self.out.push(char::REPLACEMENT_CHARACTER);
                Ok(())
            }
            Handler::BackslashReplace => {
                for byte in &self.bytes[start..end] {
                    // Writing to a string cannot fail.
                    let _ = write!(self.out, "\\x{byte:02x}");
                }
                Ok(())
            }
            Handler::XmlCharRefReplace => Err(CodecError::Type("don't know how to handle UnicodeDecodeError in error callback")),
        }
    }
}

/// `bytes.decode(encoding, errors)`; `None` for a handler whose name is not known, which matters only once it is needed.
pub fn decode(bytes: &[u8], encoding: Encoding, handler: Option<Handler>) -> Result<String, CodecError> {
    let mut decoder = Decoder { name: "utf-8", bytes, handler, out: String::with_capacity(bytes.len()) };
    match encoding {
        Encoding::Utf8 { mark } => {
            if mark && bytes.starts_with(b"\xef\xbb\xbf") {
                decoder.bytes = &bytes[3..];
            }
            decode_utf8(&mut decoder)?;
        }
        Encoding::Latin1 => decoder.out.extend(bytes.iter().map(|b| char::from(*b))),
        Encoding::Ascii => {
            decoder.name = "ascii";
            for (i, &byte) in bytes.iter().enumerate() {
                if byte.is_ascii() { decoder.out.push(char::from(byte)) } else { decoder.fail(i, i + 1, "ordinal not in range(128)")? }
            }
        }
        Encoding::Wide { unit, big } => decode_wide(&mut decoder, unit, big)?,
    }
    Ok(decoder.out)
}

fn decode_utf8(decoder: &mut Decoder<'_>) -> Result<(), CodecError> {
    let mut start = 0;
    let bytes = decoder.bytes;
    for chunk in bytes.utf8_chunks() {
        decoder.out.push_str(chunk.valid());
        let (bad, invalid) = (start + chunk.valid().len(), chunk.invalid());
        start = bad + invalid.len();
        let Some(&first) = invalid.first() else { continue };
        let needed = match first {
            0xC2..=0xDF => 2,
            0xE0..=0xEF => 3,
            0xF0..=0xF4 => 4,
            _ => 1,
        };
        let reason = if needed == 1 {
            "invalid start byte"
        } else if start == bytes.len() && invalid.len() < needed {
            "unexpected end of data"
        } else {
            "invalid continuation byte"
        };
        decoder.fail(bad, start, reason)?;
    }
    Ok(())
}

fn decode_wide(decoder: &mut Decoder<'_>, unit: usize, big: Option<bool>) -> Result<(), CodecError> {
    let bytes = decoder.bytes;
    let read = |at: usize, big: bool| {
        let unit = bytes.get(at..at + unit)?;
        let next = |code: u32, byte: &u8| code << 8 | u32::from(*byte);
        Some(if big { unit.iter().fold(0, next) } else { unit.iter().rev().fold(0, next) })
    };
    let mut at = 0;
    let big = big.unwrap_or_else(|| {
        let reversed = read(0, true) == Some(0xFEFF);
        if reversed || read(0, false) == Some(0xFEFF) {
            at = unit;
        }
        reversed
    });
    decoder.name = match (unit, big) {
        (2, false) => "utf-16-le",
        (2, true) => "utf-16-be",
        (_, false) => "utf-32-le",
        (_, true) => "utf-32-be",
    };
    while at < bytes.len() {
        let Some(code) = read(at, big) else {
            decoder.fail(at, bytes.len(), "truncated data")?;
            break;
        };
        let mut end = at + unit;
        match code {
            0xD800..=0xDFFF if unit == 4 => decoder.fail(at, end, "code point in surrogate code point range(0xd800, 0xe000)")?,
            0xDC00..=0xDFFF => decoder.fail(at, end, "illegal encoding")?,
            0xD800..=0xDBFF => match read(end, big) {
                Some(low @ 0xDC00..=0xDFFF) => {
                    end += unit;
                    decoder.out.extend(char::from_u32(0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00)));
                }
                Some(_) => decoder.fail(at, end, "illegal UTF-16 surrogate")?,
                None => {
                    end = bytes.len();
                    decoder.fail(at, end, "unexpected end of data")?;
                }
            },
            _ => match char::from_u32(code) {
                Some(c) => decoder.out.push(c),
                None => decoder.fail(at, end, "code point not in range(0x110000)")?,
            },
        }
        at = end;
    }
    Ok(())
}
