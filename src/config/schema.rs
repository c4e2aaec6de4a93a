//! The JSON schema of `psdl.toml`, for editors of TOML.

use super::settings::{Range, Setting, all};
use crate::analysis::Options;
use crate::check::finding::Severity;
use crate::config::settings::Value as SettingValue;
use serde_json::{Map, Value, json};

/// The schema.
pub fn schema() -> Value {
    let texts = |what: &str| json!({"type": "array", "items": {"type": "string"}, "description": what});
    let mut properties = tables();
    let mut overridden = properties.clone();
    overridden.insert("paths".into(), texts("Patterns as in .gitignore, relative to this file."));
    properties.insert("extend".into(), json!({"type": "string", "description": "Another file whose settings hold where this one says nothing else; relative to this file."}));
    properties.insert(
        "exclude".into(),
        texts("Programs that are left out when a folder is searched; patterns as in .gitignore, relative to this file."),
    );
    properties.insert(
        "override".into(),
        json!({
            "type": "array",
            "description": "Settings for some paths only; later ones win.",
            "items": {"type": "object", "required": ["paths"], "additionalProperties": false, "properties": overridden},
        }),
    );
    json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "psdl.toml",
        "description": "Configuration of psdl.",
        "type": "object",
        "additionalProperties": false,
        "properties": properties,
    })
}

/// The settings as nested tables.
fn tables() -> Map<String, Value> {
    let mut root = Map::new();
    for setting in all() {
        insert(&mut root, &setting.key, property(&setting));
    }
    root
}

/// Puts a property at a place like `check.weights.overlap`.
fn insert(table: &mut Map<String, Value>, key: &str, property: Value) {
    let Some((outer, rest)) = key.split_once('.') else {
        table.insert(key.into(), property);
        return;
    };
    let inner = table.entry(outer).or_insert_with(|| json!({"type": "object", "additionalProperties": false, "properties": {}}));
    if let Some(properties) = inner.get_mut("properties").and_then(Value::as_object_mut) {
        insert(properties, rest, property);
    }
}

fn property(setting: &Setting) -> Value {
    let default = match setting.get(&Options::default()) {
        SettingValue::Number(number) => json!(number),
        SettingValue::Count(count) => json!(count),
        SettingValue::Severity(severity) => json!(severity.map_or("off", Severity::name)),
    };
    let mut property = match setting.range {
        Range::Number(from, to) => json!({"type": "number", "minimum": from, "maximum": to}),
        Range::Count(from, to) => json!({"type": "integer", "minimum": from, "maximum": to}),
        Range::Severity => json!({"enum": ["error", "warning", "info", "off"]}),
    };
    property["description"] = setting.doc.clone().into();
    property["default"] = default;
    property
}
