//! A program run on a scene: what it leaves behind.

use std::sync::Arc;

use rustc_hash::FxHashSet;

use crate::python::code::Program;
use crate::python::vm::{Options, Outcome, Vm};
use crate::scene::layout::Layout;
use crate::trace::Trace;

use super::SceneHost;
use super::paths::name_after_globals;

/// A run and its result.
#[derive(Debug)]
pub struct Run {
    /// Where everything is in the end; of a program that raised, what it did up to then.
    pub layout: Layout,
    /// How it ended.
    pub outcome: Outcome,
    /// The record, where one was asked for.
    pub trace: Trace,
    /// The globals of the program's text that had no value in the end, and that are no names of Python or of the scene.
    pub unbound: Vec<String>,
}

/// Runs a compiled program on a scene. `in_loops` are the names that [`bound_in_loops`](super::bound_in_loops) finds in its text;
/// what it prints goes to `output`.
pub fn run(
    program: Arc<Program>,
    in_loops: &FxHashSet<String>,
    mut host: SceneHost,
    options: Options<'_>,
    output: &mut dyn FnMut(&str),
) -> Run {
    let mut vm = Vm::new(&mut host, output, options);
    let outcome = vm.run_program(Arc::clone(&program));
    let roots = name_after_globals(&vm.heap, &vm.symbols, vm.globals(), in_loops);
    let unbound = unbound(&program, &mut vm);
    let mut trace = std::mem::take(&mut vm.trace);
    drop(vm);
    let layout = host.into_layout(&mut trace, roots);
    Run { layout, outcome, trace, unbound }
}

/// The same for a search: where everything is, without the names that the program has for it.
pub fn run_unnamed(program: Arc<Program>, mut host: SceneHost, options: Options<'_>) -> Run {
    let mut output = |_: &str| {};
    let mut vm = Vm::new(&mut host, &mut output, options);
    let outcome = vm.run_program(program);
    let mut trace = std::mem::take(&mut vm.trace);
    drop(vm);
    let layout = host.world.into_layout(&mut trace);
    Run { layout, outcome, trace, unbound: Vec::new() }
}

fn unbound(program: &Program, vm: &mut Vm<'_>) -> Vec<String> {
    let bound: FxHashSet<String> = vm.globals().into_iter().map(|(name, _)| name.to_owned()).collect();
    let unbound = program.globals.iter().filter(|name| !bound.contains(&***name));
    let unknown = unbound.filter(|name| {
        let symbol = vm.symbols.intern(name);
        vm.builtin(symbol).is_none()
    });
    unknown.map(|name| name.to_string()).collect()
}
