//! Code as text, for people who read tests or look for a fault.

use std::fmt::{self, Display, Formatter};

use crate::python::code::{Code, Const, Op, Program};

impl Display for Program {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for code in &self.codes {
            write_code(f, self, code)?;
        }
        Ok(())
    }
}

fn write_code(f: &mut Formatter<'_>, program: &Program, code: &Code) -> fmt::Result {
    let kind = if code.generator { " generator" } else { "" };
    writeln!(f, "{:?}{kind} {}({})", code.kind, code.qualname, code.locals.join(" "))?;
    for (name, local) in &code.cells {
        match local {
            Some(local) => writeln!(f, "  cell {name} from {local}")?,
            None => writeln!(f, "  cell {name}")?,
        }
    }
    if !code.frees.is_empty() {
        writeln!(f, "  free {}", code.frees.join(" "))?;
    }
    for (pc, op) in code.ops.iter().enumerate() {
        match operand(program, code, *op) {
            Some(text) => writeln!(f, "{pc:4} {op:?} {text}")?,
            None => writeln!(f, "{pc:4} {op:?}")?,
        }
    }
    for h in &code.handlers {
        writeln!(f, "  {}..{} raises to {} depth {} handling {}", h.start, h.end, h.target, h.depth, h.handling)?;
    }
    for l in &code.loops {
        let variable = l.variable.as_ref().map_or("", |(name, _)| name);
        writeln!(f, "  {}..{} loops over {variable:?} depth {}", l.start, l.end, l.depth)?;
    }
    Ok(())
}

/// What the operand of an instruction stands for, where that is no number.
fn operand(program: &Program, code: &Code, op: Op) -> Option<String> {
    let constant = |at: usize| code.consts.get(at).map(show);
    let name = |at: u32| code.names.get(at as usize).map(ToString::to_string);
    let local = |at: u16| code.locals.get(usize::from(at)).map(ToString::to_string);
    let cell = |at: u16| {
        let at = usize::from(at).checked_sub(code.locals.len())?;
        let cells = code.cells.iter().map(|(name, _)| name);
        cells.chain(&code.frees).nth(at).map(ToString::to_string)
    };
    match op {
        Op::Const(at) | Op::LoadSubscrConst(at) => constant(at as usize),
        Op::LoadFast(at) | Op::StoreFast(at) | Op::DeleteFast(at) | Op::BinaryFast { b: at, .. } => local(at),
        Op::LoadDeref(at) | Op::StoreDeref(at) | Op::DeleteDeref(at) | Op::LoadClosure(at) | Op::LoadClassDeref { slot: at, .. } => {
            cell(at)
        }
        Op::LoadGlobal(at) | Op::StoreGlobal(at) | Op::DeleteGlobal(at) => program.globals.get(at as usize).map(ToString::to_string),
        Op::LoadName(at) | Op::StoreName(at) | Op::DeleteName(at) => name(at),
        Op::LoadAttr(at) | Op::StoreAttr(at) | Op::DeleteAttr(at) | Op::LoadMethod(at) | Op::ImportFrom(at) => name(at),
        Op::Import { name: at, .. } => name(at),
        Op::CallKw { names, .. } | Op::CallMethodKw { names, .. } => constant(names as usize),
        Op::MakeFunction { child, .. } => {
            let number = code.children.get(child as usize)?;
            program.codes.get(*number as usize).map(|code| code.qualname.to_string())
        }
        Op::BinaryFastFast { a, b, .. } | Op::LoadFastFast { a, b } => Some(format!("{} {}", local(a)?, local(b)?)),
        Op::BinaryFastConst { a, constant: at, .. } => Some(format!("{} {}", local(a)?, constant(at.into())?)),
        Op::BinaryConst { constant: at, .. } | Op::CompareConstJump { constant: at, .. } => constant(at.into()),
        Op::LoadFastAttr { slot, name: at } => Some(format!("{}.{}", local(slot)?, name(at)?)),
        _ => None,
    }
}

fn show(value: &Const) -> String {
    let list = |items: &[Const]| items.iter().map(show).collect::<Vec<_>>().join(", ");
    match value {
        Const::None => "None".into(),
        Const::Ellipsis => "...".into(),
        Const::Bool(value) => if *value { "True" } else { "False" }.into(),
        Const::Int(value) => value.to_string(),
        Const::Big(value) => value.to_string(),
        Const::Float(value, None) => format!("{value:?}"),
        Const::Float(value, Some(id)) => format!("{value:?} tunable {}", id.0),
        Const::Complex(real, imaginary) => format!("{real:?}+{imaginary:?}j"),
        Const::Str(text) => format!("{text:?}"),
        Const::Bytes(bytes) => format!("b\"{}\"", bytes.escape_ascii()),
        Const::Tuple(items) => format!("({})", list(items)),
        Const::FrozenSet(items) => format!("frozenset({})", list(items)),
    }
}
