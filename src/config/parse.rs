//! One `psdl.toml`: its keys held against the settings, each with its place.

use super::settings::{Range, Setting, Value, all};
use crate::check::finding::Severity;
use ruff_text_size::{TextRange, TextSize};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// After so many errors the rest is not worth reading.
const MAX_PROBLEMS: usize = 50;

/// Something wrong at a place of the TOML.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Problem {
    /// Where, in bytes.
    pub range: TextRange,
    /// What.
    pub message: String,
}

/// A value where it was written.
#[derive(Clone, Debug)]
pub(super) struct Assigned {
    /// Which setting, as an index of [`all`].
    pub setting: usize,
    pub value: Value,
    pub range: TextRange,
}

/// Settings for some paths only.
#[derive(Clone, Debug)]
pub(super) struct Override {
    pub paths: Vec<(String, TextRange)>,
    pub assigned: Vec<Assigned>,
}

/// What a file says.
#[derive(Clone, Debug, Default)]
pub(super) struct Parsed {
    pub extend: Option<(String, TextRange)>,
    pub exclude: Vec<(String, TextRange)>,
    pub assigned: Vec<Assigned>,
    pub overrides: Vec<Override>,
}

/// Reads a file.
pub(super) fn parse(text: &str) -> Result<Parsed, Vec<Problem>> {
    let (table, errors) = DeTable::parse_recoverable(text);
    let mut reader = Reader { settings: all(), problems: Vec::new() };
    for error in &errors {
        let span = error.span().unwrap_or_default();
        reader.problem(&span, error.message().to_string());
    }
    // What the parser made of a text with errors would only be complained about again.
    if reader.problems.is_empty() {
        let parsed = reader.file(table.get_ref());
        if reader.problems.is_empty() {
            return Ok(parsed);
        }
    }
    Err(reader.problems)
}

struct Reader {
    settings: Vec<Setting>,
    problems: Vec<Problem>,
}

type Span = std::ops::Range<usize>;

fn range(span: &Span) -> TextRange {
    let size = |at: usize| TextSize::new(u32::try_from(at).unwrap_or(u32::MAX));
    TextRange::new(size(span.start), size(span.end.max(span.start)))
}

impl Reader {
    fn problem(&mut self, span: &Span, message: String) {
        if self.problems.len() < MAX_PROBLEMS {
            self.problems.push(Problem { range: range(span), message });
        }
    }

    fn file(&mut self, table: &DeTable) -> Parsed {
        let mut parsed = Parsed::default();
        for (key, value) in table {
            match key.get_ref().as_ref() {
                "extend" => parsed.extend = self.text(value).map(|text| (text, range(&value.span()))),
                "exclude" => parsed.exclude = self.texts(value),
                "override" => parsed.overrides = self.overrides(value),
                name => self.settings(name.to_string(), &key.span(), value, &["extend", "exclude", "override"], &mut parsed.assigned),
            }
        }
        parsed
    }

    fn overrides(&mut self, value: &Spanned<DeValue>) -> Vec<Override> {
        let DeValue::Array(list) = value.get_ref() else {
            self.problem(&value.span(), "overrides are written as [[override]]".into());
            return Vec::new();
        };
        list.iter().filter_map(|item| self.one_override(item)).collect()
    }

    fn one_override(&mut self, item: &Spanned<DeValue>) -> Option<Override> {
        let DeValue::Table(table) = item.get_ref() else {
            self.problem(&item.span(), "an override is a table".into());
            return None;
        };
        let mut one = Override { paths: Vec::new(), assigned: Vec::new() };
        for (key, value) in table {
            match key.get_ref().as_ref() {
                "paths" => one.paths = self.texts(value),
                name => self.settings(name.to_string(), &key.span(), value, &["paths"], &mut one.assigned),
            }
        }
        if !table.keys().any(|key| key.get_ref().as_ref() == "paths") {
            self.problem(&item.span(), "an override says for which \"paths\" it holds".into());
        }
        Some(one)
    }

    /// A setting, or a table of settings.
    fn settings(&mut self, key: String, span: &Span, value: &Spanned<DeValue>, beside: &[&str], assigned: &mut Vec<Assigned>) {
        if let Some(index) = self.settings.iter().position(|setting| setting.key == key) {
            if let Some(value_) = self.value(index, value) {
                assigned.push(Assigned { setting: index, value: value_, range: range(&value.span()) });
            }
            return;
        }
        let inside = format!("{key}.");
        if !self.settings.iter().any(|setting| setting.key.starts_with(&inside)) {
            return self.unknown(&key, span, beside);
        }
        let DeValue::Table(table) = value.get_ref() else {
            return self.problem(&value.span(), format!("\"{key}\" is a table of settings, not {}", value.get_ref().type_str()));
        };
        for (name, value) in table {
            self.settings(format!("{inside}{}", name.get_ref()), &name.span(), value, &[], assigned);
        }
    }

    fn unknown(&mut self, key: &str, span: &Span, beside: &[&str]) {
        let (outer, name) = key.rsplit_once('.').map_or(("", key), |(outer, name)| (outer, name));
        let prefix = if outer.is_empty() { String::new() } else { format!("{outer}.") };
        let inner = self.settings.iter().filter_map(|setting| setting.key.strip_prefix(&prefix)?.split('.').next());
        let names = inner.chain(beside.iter().copied());
        let meant = crate::syntax::suggest(name, names).map_or_else(String::new, |nearest| format!("; did you mean \"{nearest}\"?"));
        let place = if outer.is_empty() { String::new() } else { format!(" in \"{outer}\"") };
        let message = format!("there is no setting \"{name}\"{place}{meant}");
        self.problem(span, message);
    }

    fn value(&mut self, index: usize, value: &Spanned<DeValue>) -> Option<Value> {
        let setting = &self.settings[index];
        let read = match (setting.range, value.get_ref()) {
            (Range::Number(from, to), DeValue::Float(float)) => {
                number(float.as_str()).filter(|n| (from..=to).contains(n)).map(Value::Number)
            }
            (Range::Number(from, to), DeValue::Integer(int)) => {
                integer(int.as_str(), int.radix()).map(|n| n as f64).filter(|n| (from..=to).contains(n)).map(Value::Number)
            }
            (Range::Count(from, to), DeValue::Integer(int)) => {
                let count = integer(int.as_str(), int.radix()).and_then(|n| u64::try_from(n).ok());
                count.filter(|n| (from..=to).contains(n)).map(Value::Count)
            }
            (Range::Severity, DeValue::String(text)) => match text.as_ref() {
                "error" => Some(Value::Severity(Some(Severity::Error))),
                "warning" => Some(Value::Severity(Some(Severity::Warning))),
                "info" => Some(Value::Severity(Some(Severity::Info))),
                "off" => Some(Value::Severity(None)),
                _ => None,
            },
            _ => None,
        };
        if read.is_none() {
            let message = format!("\"{}\" takes {}", setting.key, setting.range.describe());
            self.problem(&value.span(), message);
        }
        read
    }

    fn text(&mut self, value: &Spanned<DeValue>) -> Option<String> {
        let text = value.get_ref().as_str().map(str::to_string);
        if text.is_none() {
            self.problem(&value.span(), format!("this is a text, not {}", value.get_ref().type_str()));
        }
        text
    }

    fn texts(&mut self, value: &Spanned<DeValue>) -> Vec<(String, TextRange)> {
        let Some(list) = value.get_ref().as_array() else {
            self.problem(&value.span(), format!("this is a list of texts, not {}", value.get_ref().type_str()));
            return Vec::new();
        };
        list.iter().filter_map(|item| self.text(item).map(|text| (text, range(&item.span())))).collect()
    }
}

fn number(text: &str) -> Option<f64> {
    text.replace('_', "").parse::<f64>().ok().filter(|number| number.is_finite())
}

fn integer(text: &str, radix: u32) -> Option<i64> {
    let text = text.replace('_', "");
    i64::from_str_radix(text.trim_start_matches('+'), radix).ok()
}
