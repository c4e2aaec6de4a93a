//! A program that can be run again with other values.

use rustc_hash::FxHashSet;

use crate::analysis::{Input, Options, Prepared, prepare};
use crate::check::finding::Finding;
use crate::check::{Verdict, check};
use crate::python::error::Stop;
use crate::python::vm::{self, Limits};
use crate::scene::Layout;
use crate::scene::host::{self, SceneHost, bound_in_loops};
use crate::syntax::Edit;
use crate::syntax::{ConstantId, Parsed, Tuning};
use crate::trace::{Slices, Trace};

use super::changes::Changes;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A record of more operations than this is of no use for a search.
const MAX_TRACE: usize = 400_000;

/// Why a program cannot be corrected.
#[derive(Debug)]
pub enum Unfit {
    /// The text or the template has errors.
    Broken(Vec<Finding>),
    /// The run met a limit.
    Stopped(Stop),
}

/// A run of the program with some changes.
#[derive(Debug)]
pub struct Ran {
    /// Where everything is.
    pub layout: Layout,
    /// The record, where one was asked for.
    pub trace: Arc<Trace>,
    /// How many statements raised.
    pub exceptions: usize,
    steps: u64,
}

/// A program that was read and run once, ready to be run with other values.
#[derive(Debug)]
pub struct Problem {
    text: String,
    template: Option<String>,
    prepared: Prepared,
    options: Options,
    in_loops: FxHashSet<String>,
    original: Ran,
    slices: Arc<Slices>,
    verdict: Verdict,
    limits: Limits,
    stone: FxHashSet<ConstantId>,
}

impl Problem {
    /// Reads and runs a program.
    pub fn new(input: &Input, options: &Options) -> Result<Problem, Unfit> {
        Problem::unless_cancelled(input, options, None)
    }

    /// The same with a flag that stops the run.
    pub fn unless_cancelled(input: &Input, options: &Options, cancel: Option<&AtomicBool>) -> Result<Problem, Unfit> {
        let mut prepared = prepare(input);
        if prepared.program.is_none() {
            return Err(Unfit::Broken(std::mem::take(&mut prepared.findings)));
        }
        let in_loops = bound_in_loops(&prepared.parsed);
        let manner = Manner { limits: &options.limits, cancel, record: true, named: Some(&in_loops) };
        let first = execute(&prepared, &Changes::default(), manner);
        let original = match first {
            None => return Err(Unfit::Broken(std::mem::take(&mut prepared.findings))),
            Some(Err(stop)) => return Err(Unfit::Stopped(stop)),
            Some(Ok(ran)) => ran,
        };
        let verdict = check(&original.layout, &options.rules);
        // What is tried may loop for ever.
        let limits = Limits { steps: (8 * original.steps + 100_000).min(options.limits.steps), ..options.limits };
        let slices = Slices::of(&original.trace).map(Arc::new);
        let stone = stone(&original.trace, slices.as_deref(), &prepared.tuning);
        let (text, template) = (input.text.to_string(), input.template.map(str::to_string));
        let options = options.clone();
        Ok(Problem { text, template, prepared, options, in_loops, original, slices: slices.unwrap_or_default(), verdict, limits, stone })
    }

    /// The program.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The program, read.
    pub fn parsed(&self) -> &Parsed {
        &self.prepared.parsed
    }

    /// What of it may be rewritten.
    pub fn tuning(&self) -> &Tuning {
        &self.prepared.tuning
    }

    /// What counts as an error.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The record of the program as it is, and its slices: none where it is too long.
    pub(super) fn record(&self) -> (Arc<Trace>, Arc<Slices>) {
        (Arc::clone(&self.original.trace), Arc::clone(&self.slices))
    }

    /// The layout as the program is.
    pub fn layout(&self) -> &Layout {
        &self.original.layout
    }

    /// The errors as the program is.
    pub fn verdict(&self) -> &Verdict {
        &self.verdict
    }

    /// What a run costs, in units of the budget.
    pub(super) fn run_cost(&self) -> usize {
        let objects = self.original.layout.objects.len();
        20 + self.original.trace.nodes().len() / 16 + objects * objects / 256 + (self.original.steps / 64) as usize
    }

    /// How many statements of the program raise; what they would have placed is not corrected.
    pub fn exceptions(&self) -> usize {
        self.original.exceptions
    }

    /// Whether a constant may be rewritten: it is none of the template's, and reaches no size.
    pub fn is_free(&self, id: ConstantId) -> bool {
        let excluded = self.tuning().constant(id).is_none_or(|constant| constant.excluded.is_some());
        !excluded && !self.stone.contains(&id)
    }

    /// A run with some changes; its objects are not named as the program names them. `None` where it is no correction of the same scene: it was stopped, raised more than the program as it
    /// is, or has other objects.
    pub fn run(&self, changes: &Changes, record: bool) -> Option<Ran> {
        let manner = Manner { limits: &self.limits, cancel: None, record, named: None };
        let ran = execute(&self.prepared, changes, manner)?.ok()?;
        self.is_same_scene(&ran).then_some(ran)
    }

    fn is_same_scene(&self, ran: &Ran) -> bool {
        let (old, new) = (&self.original.layout, &ran.layout);
        let same_objects = old.objects.len() == new.objects.len()
            && old.objects.iter().zip(&new.objects).all(|(a, b)| {
                a.body.dims == b.body.dims && a.body.kind == b.body.kind && a.body.support == b.body.support && a.name == b.name
            });
        let placed = |layout: &Layout| layout.objects.iter().filter(|object| object.body.is_placed()).count();
        same_objects && old.scene.size() == new.scene.size() && placed(new) >= placed(old) && ran.exceptions <= self.original.exceptions
    }

    /// The text after some changes, and its edits. `None` where an edit does not lie in the text.
    pub fn rewrite(&self, changes: &Changes) -> Option<(String, Vec<Edit>)> {
        let edits = changes.edits(self.tuning());
        let mut text = String::with_capacity(self.text.len());
        let mut from = 0;
        for (range, new) in &edits {
            text.push_str(self.text.get(from..range.start().to_usize())?);
            text.push_str(new);
            from = range.end().to_usize();
        }
        text.push_str(self.text.get(from..)?);
        Some((text, edits))
    }

    /// Layout and errors of a rewritten text, read and run afresh; `None` where it is no correction of the same scene.
    pub fn judge_text(&self, text: &str) -> Option<(Layout, Verdict)> {
        let prepared = prepare(&Input { text, template: self.template.as_deref() });
        let manner = Manner { limits: &self.options.limits, cancel: None, record: false, named: Some(&self.in_loops) };
        let ran = execute(&prepared, &Changes::default(), manner)?.ok()?;
        let verdict = self.is_same_scene(&ran).then(|| check(&ran.layout, &self.options.rules))?;
        Some((ran.layout, verdict))
    }
}

/// The constants that reach the size of something.
fn stone(trace: &Trace, slices: Option<&Slices>, tuning: &Tuning) -> FxHashSet<ConstantId> {
    let all = || (0..tuning.constants.len()).filter_map(|at| u32::try_from(at).ok()).map(ConstantId).collect();
    let Some(slices) = slices else { return all() };
    trace.stone().iter().flat_map(|handle| slices.reaching(*handle)).map(|literal| ConstantId(slices.literals()[literal].id)).collect()
}

/// How a program is run.
#[derive(Clone, Copy)]
struct Manner<'a> {
    limits: &'a Limits,
    cancel: Option<&'a AtomicBool>,
    /// Keeps a record.
    record: bool,
    /// Names objects as the program does; these are the names that loops bind.
    named: Option<&'a FxHashSet<String>>,
}

fn execute(prepared: &Prepared, changes: &Changes, manner: Manner<'_>) -> Option<Result<Ran, Stop>> {
    let program = prepared.program.clone()?;
    let host = match &prepared.template {
        None => SceneHost::new(),
        Some(template) => SceneHost::with_template(template).ok()?,
    };
    let options = vm::Options {
        limits: *manner.limits,
        cancel: manner.cancel,
        lenient: true,
        trace: if manner.record { Trace::recording(MAX_TRACE).with_turns() } else { Trace::default() },
        constants: changes.constants().collect(),
        directions: changes.turns().map(|(id, cardinal)| (id, cardinal as u8)).collect(),
    };
    let run = match manner.named {
        Some(in_loops) => host::run(program, in_loops, host, options, &mut |_| {}),
        None => host::run_unnamed(program, host, options),
    };
    Some(match run.outcome.stop {
        Some((stop, _)) => Err(stop),
        None => {
            let steps = manner.limits.steps.saturating_sub(run.outcome.steps_left);
            Ok(Ran { layout: run.layout, trace: Arc::new(run.trace), exceptions: run.outcome.exceptions.len(), steps })
        }
    })
}
