//! The compiler at work: small sources and the code that they become.

mod listings;
mod verify;

use super::{CompileError, compile};
use crate::python::code::{Op, Program};
use crate::syntax::{parse, tune};

fn compiled(source: &str) -> Result<Program, CompileError> {
    let parsed = parse(source);
    assert!(parsed.errors.is_empty(), "{:?}", parsed.errors);
    let program = compile(&parsed.module, source, &parsed.scopes, &tune(&parsed, source))?;
    program.codes.iter().for_each(verify::verify);
    Ok(program)
}

fn code(source: &str) -> String {
    compiled(source).map_or_else(|error| error.message, |program| program.to_string())
}

/// The text behind the first instruction that is asked for.
fn underlined(source: &str, is_it: fn(&Op) -> bool) -> &str {
    let program = compiled(source).unwrap();
    let code = program.codes.iter().find(|code| code.ops.iter().any(is_it)).unwrap();
    let at = code.ops.iter().position(is_it).unwrap();
    &source[code.ranges[at]]
}

#[test]
fn errors_can_underline_what_failed() {
    assert_eq!(underlined("x = a.b + f(1)[2]", |op| matches!(op, Op::LoadAttr(_))), "a.b");
    assert_eq!(underlined("x = a.b + f(1)[2]", |op| matches!(op, Op::Call(_))), "f(1)");
    assert_eq!(underlined("x = a.b + f(1)[2]", |op| matches!(op, Op::LoadSubscrConst(_))), "f(1)[2]");
    assert_eq!(underlined("x = a.b + f(1)[2]", |op| matches!(op, Op::Binary(_))), "a.b + f(1)[2]");
    assert_eq!(underlined("def f(a): return 1 + a.b", |op| matches!(op, Op::LoadFastAttr { .. })), "a.b");
}

#[test]
fn a_return_from_an_except_clause_handles_nothing_any_more() {
    let program = compiled("def f():\n    try: g()\n    except A:\n        try: g()\n        except B: return 1").unwrap();
    let before_return = |ops: &[Op]| matches!(ops, [Op::PopExc, Op::PopExc, Op::Return]);
    assert!(program.codes[1].ops.windows(3).any(before_return));
}

#[test]
fn what_follows_an_endless_statement_is_still_there() {
    let program = compiled("while True: f()\ng()").unwrap();
    assert_eq!(program.statements.len(), 2);
    assert!(program.statements[1].end > program.statements[1].start + 1);
}

#[test]
fn loops_in_code_that_nothing_reaches_keep_the_height() {
    let copied = "def f():\n    for x in y:\n        try:\n            return 1\n            return 2\n        finally:\n            for z in y: g()";
    assert!(compiled(copied).is_ok());
}

#[test]
fn a_lambda_that_yields_returns_its_value() {
    let program = compiled("f = lambda: (yield 1)").unwrap();
    assert!(matches!(program.codes[1].ops[..], [Op::Const(_), Op::Yield, Op::Return]));
}

#[test]
fn deep_nesting_is_refused_as_in_python() {
    let nested = |n: usize| (0..n).map(|i| format!("{}for i in x:\n", " ".repeat(i))).collect::<String>() + &" ".repeat(n) + "pass";
    assert!(compiled(&nested(20)).is_ok());
    assert_eq!(code(&nested(21)), "too many statically nested blocks");
}

#[test]
fn copies_of_finally_cannot_fill_the_memory() {
    let mut source = String::from("def f():\n");
    for i in 1..=15 {
        let indent = " ".repeat(i);
        source += &format!("{indent}try: return\n{indent}finally:\n");
    }
    source += &(" ".repeat(16) + "pass");
    assert!(matches!(code(&source).as_str(), "the program is too long to be compiled" | "too many statically nested blocks"));
}

#[test]
fn every_program_at_hand_compiles_to_sound_code() {
    let mut folders = vec!["tests/python".into(), "examples".into(), "src/python/lib".into()];
    folders.extend(std::env::var_os("PSDL_CORPUS").map(std::path::PathBuf::from));
    let mut count = 0;
    for entry in folders.iter().filter_map(|folder| std::fs::read_dir(folder).ok()).flatten().flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|extension| extension != "py" && extension != "psdl") {
            continue;
        }
        let source = std::fs::read_to_string(&path).unwrap();
        if let Err(error) = compiled(&source) {
            panic!("{}: {} at {:?}", path.display(), error.message, error.range);
        }
        count += 1;
    }
    assert!(count > 30, "only {count}");
}
