//! Which files a command works on, and what is in them.

use super::output::Failure;
use ignore::WalkBuilder;
use rustc_hash::FxHashSet;
use std::fmt;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Larger files are not read: no program is that long.
const MAX_BYTES: u64 = 64 << 20;

/// What a program without a name is called.
const STDIN: &str = "<stdin>";

/// A program to work on.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Program {
    /// A file.
    File(PathBuf),
    /// Standard input, under a name.
    Stdin(PathBuf),
}

/// What was read.
#[derive(Debug)]
pub(super) struct Loaded {
    /// The path as it is shown.
    pub path: String,
    /// The program, or why there is none.
    pub text: Result<String, Trouble>,
    /// Path and text of the sidecar template, if there is one.
    pub template: Option<(String, Result<String, Trouble>)>,
}

/// A program, and path and text of its template.
pub(super) type Texts<'a> = (&'a str, Option<(&'a str, &'a str)>);

/// Why a file is no text.
#[derive(Debug)]
pub(super) enum Trouble {
    /// It could not be read.
    Io(String),
    /// It holds bytes that are no UTF-8; the text with these replaced, the byte where the first of them stands.
    Encoding(String, usize),
}

/// The programs that the paths of a command line name, each once, in a stable order.
/// Those that are found in folders are asked whether they are left out.
pub(super) fn programs(
    paths: &[PathBuf],
    stdin_name: Option<&Path>,
    left_out: &dyn Fn(&Path) -> Result<bool, Failure>,
) -> Result<Vec<Program>, Failure> {
    let mut seen = FxHashSet::default();
    let mut programs = Vec::new();
    for path in paths {
        if path.as_os_str() == "-" {
            programs.push(Program::Stdin(stdin_name.unwrap_or(Path::new(STDIN)).to_path_buf()));
        } else if path.is_dir() {
            for found in walk(path) {
                if !left_out(&found)? && seen.insert(found.clone()) {
                    programs.push(Program::File(found));
                }
            }
        } else if seen.insert(path.clone()) {
            programs.push(Program::File(path.clone()));
        }
    }
    if programs.iter().filter(|program| matches!(program, Program::Stdin(_))).count() > 1 {
        return Err(Failure::new("standard input can be read only once, but `-` stands twice"));
    }
    Ok(programs)
}

/// The scene programs in a folder, sorted; entries that cannot be listed are passed over.
fn walk(folder: &Path) -> impl Iterator<Item = PathBuf> + use<> {
    let walk = WalkBuilder::new(folder).sort_by_file_name(std::ffi::OsStr::cmp).build();
    walk.flatten()
        .filter(|entry| entry.file_type().is_some_and(|kind| kind.is_file()) && entry.path().extension().is_some_and(|end| end == "psdl"))
        .map(ignore::DirEntry::into_path)
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Trouble::Io(error) => f.write_str(error),
            Trouble::Encoding(_, at) => write!(f, "not UTF-8: the byte at offset {at} begins no character"),
        }
    }
}

impl Loaded {
    /// The program, and path and text of its template, where all of them are texts.
    pub(super) fn texts(&self) -> Result<Texts<'_>, Failure> {
        let wrong = |path: &str, trouble: &Trouble| Failure::new(format!("{path}: {trouble}"));
        let text = self.text.as_ref().map_err(|trouble| wrong(&self.path, trouble))?;
        let template = self.template.as_ref().map(|(path, text)| match text {
            Ok(text) => Ok((path.as_str(), text.as_str())),
            Err(trouble) => Err(wrong(path, trouble)),
        });
        Ok((text, template.transpose()?))
    }
}

impl Program {
    /// The one that an argument names.
    pub(super) fn named(path: &Path) -> Program {
        if path.as_os_str() == "-" { Program::Stdin(PathBuf::from(STDIN)) } else { Program::File(path.to_path_buf()) }
    }

    /// Where the program is, or claims to be.
    pub(super) fn path(&self) -> &Path {
        match self {
            Program::File(path) | Program::Stdin(path) => path,
        }
    }

    /// Reads the program and its template.
    pub(super) fn load(&self) -> Loaded {
        let text = match self {
            Program::File(path) => std::fs::File::open(path).and_then(read),
            Program::Stdin(_) => read(std::io::stdin().lock()),
        };
        let template = self.path().with_extension("template.json");
        // With a program that has no name there is no "beside".
        let template = (self.path().as_os_str() != STDIN && template.is_file()).then(|| {
            let text = decode(std::fs::File::open(&template).and_then(read));
            (shown(&template), text)
        });
        Loaded { path: shown(self.path()), text: decode(text), template }
    }
}

fn read(from: impl Read) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(std::io::Error::other(format!("larger than {} MiB", MAX_BYTES >> 20)));
    }
    Ok(bytes)
}

fn decode(bytes: std::io::Result<Vec<u8>>) -> Result<String, Trouble> {
    match bytes {
        Err(error) => Err(Trouble::Io(error.to_string())),
        Ok(bytes) => String::from_utf8(bytes).map_err(|error| {
            let at = error.utf8_error().valid_up_to();
            Trouble::Encoding(String::from_utf8_lossy(error.as_bytes()).into_owned(), at)
        }),
    }
}

/// A path as reports show it: with forward slashes, and without a `./` that says nothing.
pub(super) fn shown(path: &Path) -> String {
    let path = path.strip_prefix("./").unwrap_or(path).to_string_lossy().into_owned();
    if std::path::MAIN_SEPARATOR == '/' { path } else { path.replace(std::path::MAIN_SEPARATOR, "/") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        folder
    }

    fn names(folder: &tempfile::TempDir, paths: &[PathBuf]) -> Vec<String> {
        let programs = programs(paths, None, &|_| Ok(false)).unwrap();
        programs.iter().map(|program| shown(program.path().strip_prefix(folder.path()).unwrap())).collect()
    }

    #[test]
    fn folders_are_searched_for_programs_in_order_with_ignore_rules() {
        let files = [("b.psdl", ""), ("a/z.psdl", ""), ("a/x.py", ""), ("a/old/y.psdl", ""), (".hidden/q.psdl", ""), (".ignore", "old\n")];
        let folder = folder(&files);
        assert_eq!(names(&folder, &[folder.path().to_path_buf()]), ["a/z.psdl", "b.psdl"]);
    }

    #[test]
    fn what_is_left_out_is_checked_only_if_it_is_named() {
        let folder = folder(&[("a.psdl", ""), ("old.psdl", "")]);
        let left_out = |path: &Path| Ok(path.ends_with("old.psdl"));
        let count = |paths: &[PathBuf]| programs(paths, None, &left_out).unwrap().len();
        assert_eq!(count(&[folder.path().to_path_buf()]), 1);
        assert_eq!(count(&[folder.path().join("old.psdl")]), 1);
    }

    #[test]
    fn what_is_named_is_taken_once_whatever_its_ending() {
        let folder = folder(&[("b.psdl", ""), ("a.py", "")]);
        let (a, b) = (folder.path().join("a.py"), folder.path().join("b.psdl"));
        assert_eq!(names(&folder, &[b.clone(), a, folder.path().to_path_buf(), b]), ["b.psdl", "a.py"]);
    }

    #[test]
    fn a_template_beside_the_program_is_found() {
        let folder = folder(&[("a.psdl", "x"), ("a.template.json", "{}"), ("b.psdl", "x")]);
        let load = |name: &str| Program::File(folder.path().join(name)).load();
        assert!(matches!(load("a.psdl").template, Some((path, Ok(text))) if path.ends_with("a.template.json") && text == "{}"));
        assert!(load("b.psdl").template.is_none());
    }

    #[test]
    fn what_is_no_text_says_why() {
        let folder = folder(&[]);
        std::fs::write(folder.path().join("latin.psdl"), b"x = '\xe9'").unwrap();
        let load = |name: &str| Program::File(folder.path().join(name)).load().text;
        assert!(matches!(load("latin.psdl"), Err(Trouble::Encoding(text, 5)) if text == "x = '\u{fffd}'"));
        assert!(matches!(load("none.psdl"), Err(Trouble::Io(_))));
    }

    #[test]
    fn standard_input_is_read_once() {
        assert!(programs(&["-".into(), "-".into()], None, &|_| Ok(false)).is_err());
        assert_eq!(programs(&["-".into()], Some(Path::new("a.psdl")), &|_| Ok(false)).unwrap(), [Program::Stdin("a.psdl".into())]);
    }
}
