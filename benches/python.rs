//! The interpreter against CPython on five small programs of the kind that scenes contain: `cargo bench --bench python`.
//!
//! Prints the median of several runs, text to last instruction, and CPython's for the same programs where `python3` is there
//! (measured inside a running CPython: compile and exec, without its start).

#![allow(missing_docs, clippy::print_stdout)]

use std::process::Command;
use std::time::Instant;

const RUNS: usize = 15;

fn psdl(text: &str) -> f64 {
    let mut times: Vec<f64> = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            let parsed = psdl::syntax::parse(text);
            let program = psdl::python::program::build(&parsed, text, &psdl::syntax::tune(&parsed, text)).expect("it compiles");
            let mut host = psdl::python::host::Nothing;
            let mut out = String::new();
            let mut print = |text: &str| out.push_str(text);
            let mut vm = psdl::python::vm::Vm::new(&mut host, &mut print, psdl::python::vm::Options::default());
            let outcome = vm.run_program(program);
            assert!(outcome.exceptions.is_empty() && outcome.stop.is_none(), "{outcome:?}");
            start.elapsed().as_secs_f64() * 1000.0
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[RUNS / 2]
}

fn cpython(path: &std::path::Path) -> Option<f64> {
    let driver = "import sys, time, io, contextlib\nt = open(sys.argv[1]).read()\nr = []\nfor _ in range(15):\n    s = time.perf_counter()\n    with contextlib.redirect_stdout(io.StringIO()):\n        exec(compile(t, 'x', 'exec'), {'__name__': '__main__'})\n    r.append(time.perf_counter() - s)\nprint(sorted(r)[7] * 1000)";
    let out = Command::new("python3").args(["-c", driver]).arg(path).output().ok()?;
    String::from_utf8(out.stdout).ok()?.trim().parse().ok()
}

fn main() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/python");
    let mut paths: Vec<_> = std::fs::read_dir(folder).expect("the programs are there").flatten().map(|e| e.path()).collect();
    paths.sort();
    println!("{:<12} {:>10} {:>12} {:>8}", "program", "psdl ms", "CPython ms", "ratio");
    for path in paths.iter().filter(|p| p.extension().is_some_and(|e| e == "py")) {
        let text = std::fs::read_to_string(path).expect("a program is UTF-8");
        let own = psdl(&text);
        let name = path.file_stem().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        match cpython(path) {
            Some(theirs) => println!("{name:<12} {own:>10.2} {theirs:>12.2} {:>8.2}", own / theirs),
            None => println!("{name:<12} {own:>10.2} {:>12} {:>8}", "-", "-"),
        }
    }
}
