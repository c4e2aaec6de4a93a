//! A table, one row an object: every number to the last digit, in metres and world coordinates.

use super::Subject;
use super::words::number;

const COLUMNS: [&str; 24] = [
    "path",
    "category",
    "type",
    "support",
    "width",
    "depth",
    "height",
    "center_x",
    "center_y",
    "center_z",
    "min_x",
    "min_y",
    "min_z",
    "max_x",
    "max_y",
    "max_z",
    "facing",
    "facing_set",
    "placed",
    "color",
    "dynamic",
    "line",
    "errors",
    "loss",
];

/// A text that a spreadsheet would take for a formula gets an apostrophe in front.
fn cell(text: &str) -> String {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']) { format!("'{text}") } else { text.to_owned() }
}

pub(super) fn csv(subject: &Subject) -> String {
    let objects = &subject.layout.objects;
    let mut errors = vec![(0_usize, 0_u64); objects.len()];
    for violation in subject.verdict.counted() {
        if let Some((count, loss)) = errors.get_mut(violation.culprit as usize) {
            *count += 1;
            *loss = loss.saturating_add(violation.loss);
        }
    }
    let mut table = csv::WriterBuilder::new().terminator(csv::Terminator::CRLF).from_writer(Vec::new());
    // A vector takes everything that is written to it.
    let _ = table.write_record(COLUMNS);
    for (index, object) in objects.iter().enumerate() {
        let body = &object.body;
        let mut row = vec![cell(&object.path), cell(&object.name), body.kind.name().into(), body.support.name().into()];
        row.extend([body.dims, body.center, body.min, body.max].as_flattened().iter().map(|value| number(*value)));
        let told = body.told != crate::scene::Told::Never;
        let line = subject.line_of_object(object).map_or(String::new(), |line| line.to_string());
        let color = object.color.clone().unwrap_or_default();
        row.extend([body.turn.name().into(), told.to_string(), body.is_placed().to_string(), color, object.dynamic.to_string(), line]);
        row.extend([errors[index].0.to_string(), errors[index].1.to_string()]);
        let _ = table.write_record(&row);
    }
    table.into_inner().map_or(String::new(), |bytes| String::from_utf8_lossy(&bytes).into_owned())
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_formula_is_only_text() {
        assert_eq!(["=1+1", "@x", "Chair"].map(super::cell), ["'=1+1", "'@x", "Chair"]);
    }
}
