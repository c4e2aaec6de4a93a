//! `psdl import`

use super::Outcome;
use super::args::ImportArgs;
use super::files::Program;
use super::output::{self, Failure};
use crate::export::import::{ImportError, detect, import as read};
use crate::syntax::{Encoding, LineIndex};
use ruff_text_size::TextSize;

pub(super) fn import(args: &ImportArgs) -> Result<Outcome, Failure> {
    let loaded = Program::named(&args.file).load();
    let text = loaded.text.as_ref().map_err(|trouble| Failure::new(format!("{}: {trouble}", loaded.path)))?;
    let source = args.from.or_else(|| detect(text));
    let unknown = || Failure::new(format!("{}: this is none of the formats that can be read; --from says which one is meant", loaded.path));
    let program = read(text, source.ok_or_else(unknown)?).map_err(|errors| listed(&loaded.path, text, &errors))?;
    match args.output.as_deref().filter(|path| path.as_os_str() != "-") {
        Some(path) => output::write_file(path, program.as_bytes()).map(|()| Outcome::Clean),
        None => output::print(&program),
    }
}

/// Each mistake with its line and column.
fn listed(path: &str, text: &str, errors: &[ImportError]) -> Failure {
    let lines = LineIndex::new(text);
    let line = |error: &ImportError| {
        let at = TextSize::new(u32::try_from(error.range.start).unwrap_or(u32::MAX));
        let place = lines.line_column(at, text, Encoding::Utf32);
        format!("{path}:{}:{}: {}", place.line + 1, place.column + 1, error.message)
    };
    Failure::new(errors.iter().map(line).collect::<Vec<_>>().join("\n"))
}
