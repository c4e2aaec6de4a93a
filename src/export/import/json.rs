//! Reading JSON so that every mistake is told at its place.

use super::ImportError;
use crate::scene::template::{STRICT, kind_of};
use crate::scene::{MAX_OBJECTS, Scalar};
use jsonc_parser::ast::{Array, Object, Value};
use jsonc_parser::common::{Range, Ranged};
use jsonc_parser::{CollectOptions, parse_to_ast};

/// More mistakes than this are not listed.
const MOST: usize = 100;

/// JSON as RFC 8259 has it. A byte order mark counts as three blanks.
pub(super) fn parse(text: &str) -> Result<Value<'_>, ImportError> {
    if u32::try_from(text.len()).is_err() {
        return Err(ImportError::new(0..0, "the file is too large"));
    }
    match parse_to_ast(text, &CollectOptions::default(), &STRICT) {
        Ok(parsed) => parsed.value.ok_or_else(|| ImportError::new(0..0, "the file is empty")),
        Err(error) => Err(ImportError::new(error.range().start..error.range().end, format!("this is no JSON: {}", error.kind()))),
    }
}

/// Reads values, and remembers what is wrong with them.
#[derive(Default)]
pub(super) struct Reader {
    pub(super) errors: Vec<ImportError>,
}

impl Reader {
    pub(super) fn error(&mut self, range: Range, message: impl Into<String>) {
        if self.errors.len() < MOST {
            self.errors.push(ImportError::new(range.start..range.end, message));
        }
    }

    /// The value, if nothing is wrong.
    pub(super) fn finish<T>(self, value: Option<T>) -> Result<T, Vec<ImportError>> {
        match value {
            Some(value) if self.errors.is_empty() => Ok(value),
            _ => Err(self.errors),
        }
    }

    pub(super) fn root<'a>(&mut self, text: &'a str) -> Option<Object<'a>> {
        match parse(text) {
            Ok(Value::Object(root)) => Some(root),
            Ok(other) => {
                self.error(other.range(), format!("a scene is an object, not {}", kind_of(&other)));
                None
            }
            Err(error) => {
                self.errors.push(error);
                None
            }
        }
    }

    /// A value that may be left out, or null.
    pub(super) fn optional<'a, 'b>(object: &'b Object<'a>, key: &str) -> Option<&'b Value<'a>> {
        object.get(key).map(|property| &property.value).filter(|value| !matches!(value, Value::NullKeyword(_)))
    }

    pub(super) fn required<'a, 'b>(&mut self, object: &'b Object<'a>, key: &str) -> Option<&'b Value<'a>> {
        let found = Self::optional(object, key);
        if found.is_none() {
            self.error(Range::new(object.range.start, object.range.start + 1), format!("{key:?} is missing"));
        }
        found
    }

    fn wrong<T>(&mut self, value: &Value, what: &str, wanted: &str) -> Option<T> {
        self.error(value.range(), format!("{what:?} is {wanted}, not {}", kind_of(value)));
        None
    }

    pub(super) fn text(&mut self, value: &Value, what: &str) -> Option<String> {
        if let Value::StringLit(text) = value { Some(text.value.to_string()) } else { self.wrong(value, what, "a string") }
    }

    pub(super) fn truth(&mut self, value: &Value, what: &str) -> Option<bool> {
        if let Value::BooleanLit(truth) = value { Some(truth.value) } else { self.wrong(value, what, "true or false") }
    }

    pub(super) fn object<'a, 'b>(&mut self, value: &'b Value<'a>, what: &str) -> Option<&'b Object<'a>> {
        if let Value::Object(object) = value { Some(object) } else { self.wrong(value, what, "an object") }
    }

    pub(super) fn list<'a, 'b>(&mut self, value: &'b Value<'a>, what: &str) -> Option<&'b Array<'a>> {
        if let Value::Array(list) = value { Some(list) } else { self.wrong(value, what, "a list") }
    }

    /// The objects of a list of no more than a scene holds.
    pub(super) fn objects<'a, 'b>(&mut self, value: &'b Value<'a>, what: &str) -> Option<Vec<&'b Object<'a>>> {
        let list = self.list(value, what)?;
        if list.elements.len() > MAX_OBJECTS {
            self.error(list.range, format!("a scene holds at most {MAX_OBJECTS} objects"));
            return None;
        }
        list.elements.iter().map(|element| self.object(element, "an entry")).collect()
    }

    /// A finite number; an integer stays one.
    pub(super) fn number(&mut self, value: &Value, what: &str) -> Option<Scalar> {
        let Value::NumberLit(number) = value else { return self.wrong(value, what, "a number") };
        let parsed = number.value.parse::<f64>().ok().filter(|parsed| parsed.is_finite());
        let Some(parsed) = parsed else {
            self.error(number.range, format!("{what:?} must be finite, not {}", number.value));
            return None;
        };
        let int = !number.value.contains(['.', 'e', 'E']) && parsed.abs() <= 9e15;
        Some(Scalar { int, ..Scalar::float(parsed + 0.0) })
    }

    /// A length that an object can have.
    pub(super) fn size(&mut self, value: &Value, what: &str) -> Option<Scalar> {
        let size = self.number(value, what)?;
        if size.value() <= 0.0 {
            self.error(value.range(), format!("{what:?} must be positive, not {}", size.shown()));
            return None;
        }
        Some(size)
    }

    /// Three numbers in a list.
    pub(super) fn triple(&mut self, value: &Value, what: &str) -> Option<[f64; 3]> {
        let list = self.list(value, what)?;
        let [x, y, z] = list.elements.as_slice() else {
            self.error(list.range, format!("{what:?} has three numbers, not {}", list.elements.len()));
            return None;
        };
        let [x, y, z] = [x, y, z].map(|value| self.number(value, what).map(Scalar::value));
        Some([x?, y?, z?])
    }

    /// One of some words.
    pub(super) fn one_of<T: Copy>(&mut self, value: &Value, what: &str, words: &[(&str, T)]) -> Option<T> {
        let text = self.text(value, what)?;
        let found = words.iter().find(|(word, _)| *word == text).map(|(_, meaning)| *meaning);
        if found.is_none() {
            let known: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
            let text: String = text.chars().take(40).collect();
            self.error(value.range(), format!("{what:?} is one of {}, not {text:?}", known.join(", ")));
        }
        found
    }

    /// RRGGBB, with or without `#`; no colour where there is none.
    pub(super) fn color(&mut self, object: &Object, key: &str) -> Option<String> {
        let value = Self::optional(object, key)?;
        let text = self.text(value, key)?;
        let digits = text.strip_prefix('#').unwrap_or(&text);
        if digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
            return Some(digits.to_owned());
        }
        let text: String = text.chars().take(40).collect();
        self.error(value.range(), format!("{key:?} is RRGGBB, not {text:?}"));
        None
    }
}
