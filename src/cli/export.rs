//! `psdl export`

use super::Outcome;
use super::args::{ExportArgs, ExportFormat};
use super::configuration::Configuration;
use super::files::Program;
use super::output::{self, Failure};
use crate::analysis::{Analysis, Input, analyse};
use crate::report::{FileReport, Printer};
use crate::scene::{JsonViolation, Layout, layout_json};
use crate::syntax::LineIndex;

pub(super) fn export(args: &ExportArgs, color: bool) -> Result<Outcome, Failure> {
    let loaded = Program::named(&args.file).load();
    let options = Configuration::new(&args.options, color).options(&args.file)?;
    let (text, template) = loaded.texts()?;
    let analysis = analyse(&Input { text, template: template.map(|(_, text)| text) }, &options, None);
    let whole = analysis.layout.as_ref().filter(|_| !analysis.partial);
    let Some(layout) = whole else {
        let objects = analysis.object_names();
        let findings: Vec<_> =
            analysis.findings.into_iter().filter(|finding| finding.code < crate::check::finding::Code::OutOfBounds).collect();
        let file = FileReport { path: &loaded.path, text, template, findings: &findings, objects: &objects };
        output::report_error(&Printer { color, ..Printer::default() }.file(&file));
        return Ok(Outcome::Findings);
    };
    let exported = match args.to {
        ExportFormat::Layout => layout_text(text, layout, &analysis),
    };
    match args.output.as_deref().filter(|path| path.as_os_str() != "-") {
        Some(path) => output::write_file(path, exported.as_bytes()).map(|()| Outcome::Clean),
        None => output::print(&exported),
    }
}

fn layout_text(text: &str, layout: &Layout, analysis: &Analysis) -> String {
    let lines = LineIndex::new(text);
    let counted: Vec<_> = analysis.verdict.counted().map(|violation| (violation, violation.objects().collect::<Vec<usize>>())).collect();
    let violation = |(violation, objects)| {
        let violation: &crate::check::Violation = violation;
        JsonViolation { kind: violation.kind.name(), objects, loss: violation.loss }
    };
    let violations: Vec<JsonViolation> = counted.iter().map(|(found, objects)| violation((*found, objects.as_slice()))).collect();
    layout_json(layout, &violations, &|offset| lines.line(offset) as usize + 1)
}
