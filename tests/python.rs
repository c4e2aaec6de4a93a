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

/// CPython's own stack overflows on some of these.
#[test]
fn natives_within_natives_end_in_a_recursion_error() {
    let wrap = |start: &str, again: &str, end: &str| format!("x = {start}\nfor i in range(30000): x = {again}\n{end}\n");
    let programs = [
        wrap("iter([1])", "map(str, x)", "list(x)"),
        wrap("iter([1])", "zip(x)", "list(x)"),
        wrap("iter([1])", "filter(None, x)", "list(x)"),
        wrap("iter([1])", "enumerate(x)", "list(x)"),
        wrap("iter([1])", "map(next, [x])", "list(x)"),
        wrap("iter([1])", "iter(x.__next__, 5)", "list(x)"),
        format!("import itertools\n{}", wrap("iter([1])", "itertools.chain(x)", "list(x)")),
        format!("import itertools\n{}", wrap("iter([1])", "itertools.islice(x, 5)", "list(x)")),
        wrap("len", "staticmethod(x)", "x('')"),
        wrap("len", "staticmethod(x)", "x.__name__"),
        wrap("property()", "property(x)", "x.__isabstractmethod__"),
    ];
    for program in programs {
        let found = run(&program);
        assert!(found.starts_with("RecursionError: maximum recursion depth exceeded"), "{program}{found}");
    }
    // A view of a view is a view of what lies behind both.
    let views = wrap("type.__dict__", "type(x)(x)", "print(len(x) > 0, len(list(x)) > 0)");
    assert_eq!(run(&views), "True True\n");
}

/// Work that costs much costs many steps, so that a run ends in time whatever it does.
#[test]
fn costly_work_ends_at_the_limit() {
    for program in [
        "d = {}\nfor i in range(10**6): d[i * (2**61 - 1)] = 1",
        "d = {}\nwhile True: d[float('nan')] = 1",
        "a = dict.fromkeys(range(10**5))\nwhile True: a.copy()",
        "import math\na = 1\nfor i in range(1, 10**7): a = math.lcm(a, i)",
        "a = 'é' * 10**6\nwhile True: a[5 * 10**5]",
        "a = tuple(range(10**5))\nwhile True: hash(a)",
        "class A: pass\nwhile True: dir(A())",
        "def f():\n try: f()\n finally: f()\nf()",
    ] {
        let found = run(program);
        assert!(found.starts_with("stopped: Steps") || found.starts_with("MemoryError"), "{program}\n{found}");
    }
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
