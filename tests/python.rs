//! What CPython 3.11 prints, psdl prints: every snippet of `tests/python`, against the output recorded beside it.
//!
//! Those that are known to differ stand in `differences.txt`, with the reason.
//!
//! `PSDL_SNIPPET=name` runs one and shows the difference; `PSDL_PYTHON_TESTS=DIR` runs assert-based test files of a folder as well.

use std::path::{Path, PathBuf};

/// What a program prints; the last line of the traceback follows where it raises.
fn run(text: &str) -> String {
    let mut out = String::new();
    let parsed = psdl::syntax::parse(text);
    if let Some(error) = parsed.errors.first() {
        return format!("SyntaxError: {} at {:?}\n", error.message, error.range);
    }
    let program = match psdl::python::program::build(&parsed, text, &psdl::syntax::tune(&parsed, text)) {
        Ok(program) => program,
        Err(error) => return format!("SyntaxError: {} at {:?}\n", error.message, error.range),
    };
    let mut host = psdl::python::host::Nothing;
    let mut print = |text: &str| out.push_str(text);
    let mut vm = psdl::python::vm::Vm::new(&mut host, &mut print, psdl::python::vm::Options::default());
    let outcome = vm.run_program(program);
    drop(vm);
    if let Some(last) = outcome.exceptions.last().and_then(|e| e.chain.last()) {
        out.push_str(&last.line);
        out.push('\n');
    }
    if let Some((stop, _)) = outcome.stop {
        out.push_str(&format!("stopped: {stop:?}\n"));
    }
    out
}

fn python_files(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|e| e == "py"))
        .collect();
    files.sort();
    files
}

fn first_difference(expected: &str, found: &str) -> String {
    let (mut a, mut b) = (expected.lines(), found.lines());
    for n in 1.. {
        match (a.next(), b.next()) {
            (None, None) => break,
            (x, y) if x == y => {}
            (x, y) => return format!("line {n}\n  expected {}\n  found    {}", x.unwrap_or("(nothing)"), y.unwrap_or("(nothing)")),
        }
    }
    "line ends".to_string()
}

#[test]
fn snippets_print_what_cpython_prints() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/python");
    let only = std::env::var("PSDL_SNIPPET").ok();
    let known = std::fs::read_to_string(folder.join("differences.txt")).expect("the list of differences");
    let known: Vec<&str> = known.lines().filter(|l| !l.starts_with('#')).filter_map(|l| l.split_whitespace().next()).collect();
    let mut failures = Vec::new();
    let mut count = 0;
    for path in python_files(&folder) {
        let Ok(expected) = std::fs::read_to_string(path.with_extension("out")) else { continue };
        let name = path.file_stem().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        if only.as_ref().is_some_and(|o| *o != name) {
            continue;
        }
        count += 1;
        let text = std::fs::read_to_string(&path).expect("a snippet is UTF-8");
        let found = run(&text);
        let differs = found != expected;
        if only.is_none() && known.contains(&name.as_str()) {
            if !differs {
                failures.push(format!("{name}: no longer differs; take it off tests/python/differences.txt"));
            }
        } else if differs {
            failures.push(format!("{name}: {}", first_difference(&expected, &found)));
        }
    }
    assert!(count > 0, "no snippet was run");
    assert!(failures.is_empty(), "{} of {count} snippets differ\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn assert_based_test_files_pass() {
    let Ok(folder) = std::env::var("PSDL_PYTHON_TESTS") else { return };
    let mut failures = Vec::new();
    let files = python_files(Path::new(&folder));
    for path in &files {
        let Ok(text) = std::fs::read_to_string(path) else { continue };
        let found = run(&text);
        let last = found.lines().last().unwrap_or("");
        if last.contains("Error") || last.starts_with("stopped") {
            failures.push(format!("{}: {last}", path.display()));
        }
    }
    let passed = files.len() - failures.len();
    assert!(passed * 10 >= files.len() * 9, "{passed} of {} files pass\n{}", files.len(), failures.join("\n"));
}
