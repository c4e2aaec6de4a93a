//! Writing: standard output that may close, files that are either old or new but never half, complaints.

use super::Outcome;
use std::fmt;
use std::io::{self, Write};
use std::path::Path;

/// Why a command could not do its work.
#[derive(Debug)]
pub(super) struct Failure {
    message: String,
    /// Findings that belong to it, as they are to be shown.
    report: String,
}

impl Failure {
    pub(super) fn new(message: impl Into<String>) -> Failure {
        Failure { message: message.into(), report: String::new() }
    }

    /// A failure that has to do with a file.
    pub(super) fn at(path: &Path, error: &dyn fmt::Display) -> Failure {
        Failure::new(format!("{}: {error}", path.display()))
    }

    /// A failure with findings that explain it.
    pub(super) fn with_report(report: String, message: &str) -> Failure {
        Failure { message: message.into(), report }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// Says on standard error why the command ends.
pub(super) fn complain(failure: &Failure) {
    report_error(&failure.report);
    let lines: Vec<String> = failure.message.lines().map(annotate_snippets::normalize_untrusted_str).collect();
    // There is nobody left to tell when standard error is closed.
    let _ = writeln!(anstream::stderr().lock(), "\u{1b}[1;31merror\u{1b}[0m: {}", lines.join("\n"));
}

/// Says something on standard error that is no failure.
pub(super) fn note(message: &str) {
    report_error(&format!("{}\n", annotate_snippets::normalize_untrusted_str(message)));
}

/// Writes findings or a traceback to standard error.
pub(super) fn report_error(text: &str) {
    let _ = anstream::stderr().lock().write_all(text.as_bytes());
}

/// Writes to standard output; false where nobody reads it any more.
pub(super) fn write(text: &[u8]) -> Result<bool, Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text).and_then(|()| out.flush()) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(Failure::new(format!("standard output: {error}"))),
    }
}

/// A result that is one text.
pub(super) fn print(text: &str) -> Result<Outcome, Failure> {
    write(text.as_bytes())?;
    Ok(Outcome::Clean)
}

/// Replaces a file at once: a reader sees what was there before or all that is new.
pub(super) fn write_file(path: &Path, text: &[u8]) -> Result<(), Failure> {
    replace(path, text).map_err(|error| Failure::at(path, &error))
}

fn replace(path: &Path, text: &[u8]) -> io::Result<()> {
    // A link stays a link, and what is no file (a pipe, a device) is written to, not replaced.
    let path = match path.canonicalize() {
        Ok(path) if !path.is_file() => return std::fs::OpenOptions::new().write(true).open(path)?.write_all(text),
        Ok(path) => path,
        Err(_) => path.to_path_buf(),
    };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".psdl-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = path.metadata().map_or(0o666, |metadata| metadata.permissions().mode());
        builder.permissions(std::fs::Permissions::from_mode(mode));
    }
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(text)?;
    file.as_file().sync_all()?;
    file.persist(&path).map_err(|error| error.error)?;
    Ok(())
}

/// `1 error`, `2 errors`.
pub(super) fn counted(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.json");
        write_file(&path, b"old and long").unwrap();
        write_file(&path, b"new").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"new");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_folder_that_is_not_there_is_a_failure_with_its_name() {
        let folder = tempfile::tempdir().unwrap();
        let failure = write_file(&folder.path().join("no/out.json"), b"x").unwrap_err();
        assert!(failure.to_string().contains("out.json: "), "{failure}");
    }

    #[cfg(unix)]
    #[test]
    fn what_is_no_file_is_written_to() {
        write_file(Path::new("/dev/null"), b"x").unwrap();
        assert!(!Path::new("/dev/null").is_file());
    }
}
