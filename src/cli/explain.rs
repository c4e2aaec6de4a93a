//! `psdl explain`

use super::Outcome;
use super::args::ExplainArgs;
use super::output::{self, Failure};
use crate::check::codes;
use crate::check::finding::Code;
use std::fmt::Write as _;

pub(super) fn explain(args: &ExplainArgs) -> Result<Outcome, Failure> {
    let Some(kind) = &args.kind else {
        return output::print(&list());
    };
    let code: Code = kind.parse().map_err(|error: codes::UnknownCode| Failure::new(error.to_string()))?;
    output::print(&code.info().page())
}

fn list() -> String {
    let width = codes::all().map(|info| info.name.len()).max().unwrap_or(0);
    codes::all().fold(String::new(), |mut list, info| {
        let _ = writeln!(list, "{:width$}  {:7}  {}", info.name, info.severity.name(), info.summary);
        list
    })
}
