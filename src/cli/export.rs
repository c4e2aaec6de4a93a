//! `psdl export`

use super::Outcome;
use super::args::ExportArgs;
use super::configuration::Configuration;
use super::files::Program;
use super::output::{self, Failure};
use crate::analysis::{Analysis, Input, analyse};
use crate::check::finding::Code;
use crate::export::{Exported, Subject, export as write};
use crate::report::{FileReport, Printer};
use crate::scene::Layout;
use crate::syntax::LineIndex;
use std::io::IsTerminal as _;
use std::path::Path;

pub(super) fn export(args: &ExportArgs, color: bool) -> Result<Outcome, Failure> {
    let target = args.output.as_deref().filter(|path| path.as_os_str() != "-");
    if target.is_none() && args.to.is_binary() && std::io::stdout().is_terminal() {
        return Err(Failure::new("this format is no text, and standard output is a terminal: name a file with -o"));
    }
    let loaded = Program::named(&args.file).load();
    let options = Configuration::new(&args.options, color).options(&args.file)?;
    let (text, template) = loaded.texts()?;
    let analysis = analyse(&Input { text, template: template.map(|(_, text)| text) }, &options, None);
    let whole = analysis.layout.as_ref().filter(|_| !analysis.partial);
    let Some(layout) = whole else {
        let objects = analysis.object_names();
        let findings: Vec<_> = analysis.findings.into_iter().filter(|finding| finding.code < Code::OutOfBounds).collect();
        let file = FileReport { path: &loaded.path, text, template, findings: &findings, objects: &objects };
        output::report_error(&Printer { color, ..Printer::default() }.file(&file));
        return Ok(Outcome::Findings);
    };
    let stem = target.and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
    let exported = exported(args.to, text, layout, &analysis, stem.as_deref());
    match target {
        Some(path) => {
            // What is named in a file is there before the file is.
            if let Some(companion) = &exported.companion {
                output::write_file(&path.with_file_name(&companion.name), &companion.bytes)?;
            }
            output::write_file(path, &exported.bytes)?;
        }
        None => {
            output::write(&exported.bytes)?;
        }
    }
    Ok(Outcome::Clean)
}

fn exported(format: crate::export::Format, text: &str, layout: &Layout, analysis: &Analysis, stem: Option<&str>) -> Exported {
    let lines = LineIndex::new(text);
    let line_of = |offset| lines.line(offset) as usize + 1;
    let constants = analysis.prepared.tuning.constants.iter().filter(|constant| constant.excluded.is_none()).count();
    let subject = Subject { layout, verdict: &analysis.verdict, findings: &analysis.findings, constants, line_of: &line_of };
    write(format, &subject, stem)
}
