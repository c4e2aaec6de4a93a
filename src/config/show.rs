//! What holds for a program, as a `psdl.toml` that would say the same.

use super::resolve::Resolved;
use super::settings::{Value, all};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Where a value was written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Origin {
    /// The file.
    pub path: PathBuf,
    /// The line, from 1.
    pub line: u32,
}

/// All settings with their values and where they came from, as TOML with comments. `name` shortens paths for display.
pub fn show(resolved: &Resolved, name: &dyn Fn(&Path) -> String) -> String {
    let mut text = String::new();
    for file in &resolved.files {
        let _ = writeln!(text, "# from {}", name(file));
    }
    if resolved.files.is_empty() {
        text.push_str("# no psdl.toml was found: all values are defaults\n");
    }
    if resolved.excluded {
        text.push_str("# this path is excluded: it is checked only if it is named\n");
    }
    let mut table = String::new();
    let lines: Vec<(String, String, String)> = all()
        .iter()
        .zip(&resolved.origins)
        .map(|(setting, origin)| {
            let (outer, key) = setting.key.rsplit_once('.').unwrap_or(("", &setting.key));
            let from = origin.as_ref().map_or_else(|| "default".into(), |origin| format!("{}:{}", name(&origin.path), origin.line));
            let value: Value = setting.get(&resolved.options);
            (outer.to_string(), format!("{key} = {}", value.to_toml()), from)
        })
        .collect();
    let width = lines.iter().map(|(_, line, _)| line.len()).max().unwrap_or(0);
    for (outer, line, from) in lines {
        if outer != table {
            let _ = writeln!(text, "\n[{outer}]");
            table = outer;
        }
        let _ = writeln!(text, "{line:width$}  # {from}");
    }
    text
}
