//! SARIF 2.1.0, as code scanning services read it.

use super::fingerprint::fingerprints;
use super::view::{Span, View};
use super::{FileReport, object_name, to_json};
use crate::check::codes;
use crate::check::finding::{Finding, Place, Severity};
use serde_json::{Value, json};
use std::fmt::Write as _;

pub(super) fn head() -> String {
    let rules: Vec<Value> = codes::all()
        .map(|info| {
            json!({
                "id": info.name,
                "shortDescription": {"text": info.summary},
                "fullDescription": {"text": info.explanation},
                "help": {"text": format!("{}\n\n{}", info.explanation, info.remedy), "markdown": info.page()},
                "helpUri": info.code.url(),
                "defaultConfiguration": {"level": level(info.severity)},
            })
        })
        .collect();
    let driver = json!({
        "name": "psdl",
        "version": env!("CARGO_PKG_VERSION"),
        "informationUri": env!("CARGO_PKG_REPOSITORY"),
        "rules": rules,
    });
    format!(
        "{{\"$schema\":\"https://json.schemastore.org/sarif-2.1.0.json\",\"version\":\"2.1.0\",\"runs\":[{{\"tool\":{{\"driver\":{driver}}},\
         \"columnKind\":\"unicodeCodePoints\",\"results\":[\n"
    )
}

pub(super) fn tail() -> String {
    "\n]}]}\n".to_string()
}

pub(super) fn file(file: &FileReport) -> String {
    let view = View::new(file);
    let results = file.findings.iter().zip(fingerprints(file)).map(|(finding, print)| to_json(&result(file, &view, finding, &print)));
    results.collect::<Vec<String>>().join(",\n")
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "note",
    }
}

fn result(file: &FileReport, view: &View, finding: &Finding, fingerprint: &str) -> Value {
    let message = finding.notes.iter().fold(finding.message.clone(), |message, note| message + "\n" + note);
    let mut result = json!({
        "ruleId": finding.code.name(),
        "ruleIndex": codes::all().position(|info| info.code == finding.code),
        "level": level(finding.severity),
        "message": {"text": message},
        "locations": [{"physicalLocation": physical(&view.span(finding.place))}],
        "partialFingerprints": {"psdl/v1": fingerprint},
        "properties": {
            "objects": finding.objects.iter().map(|index| object_name(file, *index)).collect::<Vec<String>>(),
            "count": finding.count,
            "metres": finding.metres,
            "loss": finding.loss,
            "partial": finding.partial,
        },
    });
    if !finding.related.is_empty() {
        let related = finding.related.iter();
        let related = related.map(|r| json!({"physicalLocation": physical(&view.span(r.place)), "message": {"text": r.message}}));
        result["relatedLocations"] = related.collect();
    }
    let fixes = finding.fix.iter().chain(&finding.suggestion).map(|fix| {
        let replacements = fix.edits.iter().map(|(range, text)| {
            let span = view.span(Place::program(*range));
            json!({"deletedRegion": region(&span), "insertedContent": {"text": text}})
        });
        json!({
            "description": {"text": fix.title},
            "artifactChanges": [{"artifactLocation": {"uri": uri(file.path)}, "replacements": replacements.collect::<Vec<Value>>()}],
        })
    });
    let fixes: Vec<Value> = fixes.collect();
    if !fixes.is_empty() {
        result["fixes"] = Value::Array(fixes);
    }
    result
}

fn physical(span: &Span) -> Value {
    json!({"artifactLocation": {"uri": uri(span.path)}, "region": region(span)})
}

fn region(span: &Span) -> Value {
    json!({
        "startLine": span.start.line,
        "startColumn": span.start.column,
        "endLine": span.end.line,
        "endColumn": span.end.column,
    })
}

/// A path as a URI reference: relative ones stay relative.
fn uri(path: &str) -> String {
    let (scheme, path) = match path.strip_prefix('/') {
        Some(_) => ("file://", path),
        None => ("", path.strip_prefix("./").unwrap_or(path)),
    };
    path.bytes().fold(scheme.to_string(), |mut uri, byte| {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => uri.push(byte as char),
            _ => {
                let _ = write!(uri, "%{byte:02X}");
            }
        }
        uri
    })
}
