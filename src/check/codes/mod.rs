//! What each [`Code`] is called and means: the one place from which `psdl explain`, the pages in
//! `docs/findings/`, the rules of a SARIF log and the completion of `--select` are made.

mod layout;
mod program;

use super::finding::{Code, Severity};
use std::fmt::{self, Write as _};
use std::str::FromStr;

/// Where the pages of the codes are published; each is `<base>/<name>.md`.
pub const DOCS: &str = "https://github.com/psdl-lang/psdl/blob/main/docs/findings";

/// Everything there is to say about a code.
#[derive(Debug)]
pub struct Info {
    /// The code.
    pub code: Code,
    /// Its stable name in kebab case; never reused for another meaning.
    pub name: &'static str,
    /// How much a finding of this code weighs unless configured otherwise.
    pub severity: Severity,
    /// One sentence for tables and rule lists.
    pub summary: &'static str,
    /// What it means and when it is reported: a paragraph or two of Markdown.
    pub explanation: &'static str,
    /// The sidecar template that the example needs, if it needs one.
    pub template: Option<&'static str>,
    /// A program that has the finding. Empty where no program can show it.
    pub example: &'static str,
    /// The way out, in words.
    pub remedy: &'static str,
    /// The program of the example without the finding. Empty where the remedy is not a change of the text.
    pub fixed: &'static str,
}

/// A name that is no code, with the nearest one that is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownCode {
    /// What was written.
    pub name: String,
    /// The code that was probably meant.
    pub nearest: Option<Code>,
}

impl fmt::Display for UnknownCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no finding called `{}`", self.name)?;
        match self.nearest {
            Some(code) => write!(f, "; did you mean `{}`?", code.name()),
            None => f.write_str("; `psdl explain` lists them"),
        }
    }
}

impl std::error::Error for UnknownCode {}

/// All codes with their descriptions, in the order of [`Code`].
pub fn all() -> impl Iterator<Item = &'static Info> {
    program::BEFORE.iter().chain(layout::LAYOUT).chain(program::AFTER)
}

impl Code {
    /// What there is to say about this code.
    pub fn info(self) -> &'static Info {
        // Every code has an entry: a test holds the tables against the enum.
        all().find(|info| info.code == self).unwrap_or(&program::BEFORE[0])
    }

    /// The stable name: `out-of-bounds`.
    pub fn name(self) -> &'static str {
        self.info().name
    }

    /// How much a finding of this code weighs unless configured otherwise.
    pub fn severity(self) -> Severity {
        self.info().severity
    }

    /// The page that explains this code.
    pub fn url(self) -> String {
        format!("{DOCS}/{}.md", self.name())
    }

    /// Whether this is a weighted error of the layout (what the error correction minimises).
    pub fn is_layout(self) -> bool {
        layout::LAYOUT.iter().any(|info| info.code == self)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Code {
    type Err = UnknownCode;

    fn from_str(name: &str) -> Result<Code, UnknownCode> {
        let folded = name.trim().to_ascii_lowercase().replace('_', "-");
        match all().find(|info| info.name == folded) {
            Some(info) => Ok(info.code),
            None => Err(UnknownCode { name: name.to_string(), nearest: nearest(&folded) }),
        }
    }
}

/// The code whose name is most like this one.
fn nearest(name: &str) -> Option<Code> {
    let meant = crate::syntax::suggest(name, all().map(|info| info.name))?;
    all().find(|info| info.name == meant).map(|info| info.code)
}

impl Severity {
    /// The word for it: `error`, `warning`, `info`.
    pub fn name(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Info => "info",
        }
    }

    /// Whether findings of this weight make a run fail.
    pub fn fails(self) -> bool {
        self != Severity::Info
    }
}

impl Info {
    /// The page of this code, in Markdown.
    pub fn page(&self) -> String {
        let mut page = String::new();
        let _ = writeln!(
            page,
            "# {}\n\n{}\n\nDefault severity: **{}**.\n\n{}",
            self.name,
            self.summary,
            self.severity.name(),
            self.explanation
        );
        if !self.example.is_empty() {
            let _ = writeln!(page, "\n## Example\n");
            if let Some(template) = self.template {
                let _ = writeln!(page, "`NAME.template.json`:\n\n```json\n{}\n```\n\n`NAME.psdl`:\n", template.trim_end());
            }
            let _ = writeln!(page, "```python\n{}\n```", self.example.trim_end().replace("```", "` ` `"));
        }
        let _ = writeln!(page, "\n## What to do\n\n{}", self.remedy);
        if !self.fixed.is_empty() {
            let _ = writeln!(page, "\n```python\n{}\n```", self.fixed.trim_end());
        }
        page
    }
}

/// The table of contents of `docs/findings/`.
pub fn index_page() -> String {
    let mut page = String::from(
        "# Findings\n\nWhat `psdl check` and the editor can say about a program. `psdl explain NAME` prints the page of one.\n\n\
         | name | severity | what it says |\n| --- | --- | --- |\n",
    );
    for info in all() {
        let _ = writeln!(page, "| [{0}]({0}.md) | {1} | {2} |", info.name, info.severity.name(), info.summary);
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_found_again_and_no_two_are_the_same() {
        let mut seen = std::collections::BTreeSet::new();
        for info in all() {
            assert!(seen.insert(info.name), "{} stands twice", info.name);
            assert_eq!(info.name.parse(), Ok(info.code));
            assert_eq!(info.code.name(), info.name);
            assert!(info.code.url().ends_with(&format!("{}.md", info.name)));
        }
    }

    #[test]
    fn the_tables_are_in_the_order_of_the_codes() {
        let codes: Vec<Code> = all().map(|info| info.code).collect();
        assert!(codes.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(codes.len(), Code::UnusedSuppression as usize + 1);
    }

    #[test]
    fn a_slip_of_the_pen_is_understood() {
        assert_eq!("Facing_Wall".parse(), Ok(Code::FacingWall));
        assert_eq!("overlpa".parse::<Code>().map_err(|e| e.nearest), Err(Some(Code::Overlap)));
        assert_eq!("sideways".parse::<Code>().map_err(|e| e.nearest), Err(None));
        assert_eq!("overlpa".parse::<Code>().unwrap_err().to_string(), "there is no finding called `overlpa`; did you mean `overlap`?");
    }
}
