//! Which files changed since a revision, as git tells it.

use super::output::Failure;
use rustc_hash::FxHashSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The absolute paths of the files below the working folder that differ from the revision, new ones included.
pub(super) fn since(revision: &str) -> Result<FxHashSet<PathBuf>, Failure> {
    if revision.starts_with('-') {
        return Err(Failure::new(format!("`{revision}` is no revision")));
    }
    let top = git(&["rev-parse", "--show-toplevel"])?;
    let top = Path::new(top.trim_end_matches(['\r', '\n'])).to_path_buf();
    let changed = git(&["diff", "--name-only", "-z", "--no-renames", revision, "--"])?;
    let new = git(&["ls-files", "--others", "--exclude-standard", "--full-name", "-z"])?;
    let names = changed.split('\0').chain(new.split('\0')).filter(|name| !name.is_empty());
    Ok(names.map(|name| canonical(&top.join(name))).collect())
}

/// Whether a program, or the template beside it, is among the changed files.
pub(super) fn touches(changed: &FxHashSet<PathBuf>, program: &Path) -> bool {
    [program.to_path_buf(), program.with_extension("template.json")].iter().any(|path| changed.contains(&canonical(path)))
}

fn canonical(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_path_buf())
}

fn git(args: &[&str]) -> Result<String, Failure> {
    let output = Command::new("git").args(args).output().map_err(|error| Failure::new(format!("git could not be run: {error}")))?;
    if !output.status.success() {
        let why = String::from_utf8_lossy(&output.stderr);
        return Err(Failure::new(format!("git {}: {}", args[0], why.trim())));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
