//! Provenance: which statement did something, inside which calls and loop iterations.

use ruff_text_size::TextRange;
use rustc_hash::FxHashMap;

/// Which text a range belongs to.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Source {
    /// The program.
    Program,
    /// Its sidecar `NAME.template.json`.
    Template,
}

/// An entry of [`Origins`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct OriginId(u32);

/// An entry of the table of calls and iterations in [`Origins`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct StepId(u32);

/// Where something was done.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Origin {
    /// The text that `range` belongs to.
    pub source: Source,
    /// The statement, in bytes.
    pub range: TextRange,
    /// The innermost call or iteration around it.
    pub inside: Option<StepId>,
}

/// A call or a loop iteration that was under way.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Step {
    /// The call expression, or the loop statement or comprehension.
    pub range: TextRange,
    /// The iteration, from 0; for calls 0.
    pub index: u32,
    /// What it is.
    pub kind: StepKind,
    /// The call or iteration around it.
    pub outer: Option<StepId>,
}

/// What a [`Step`] is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum StepKind {
    /// A call of a function of the program.
    Call {
        /// Its name.
        function: Box<str>,
    },
    /// An iteration.
    Loop {
        /// The loop variable; empty for `while`.
        variable: Box<str>,
        /// Its value, shown shortly.
        value: Box<str>,
    },
}

/// How many calls and iterations are told apart; later ones are attributed to what is around them.
const MAX_STEPS: usize = 1 << 18;

/// The table of origins of a run. Equal origins have one entry; memory is bounded by the text and a limit on steps.
#[derive(Clone, Debug)]
pub struct Origins {
    origins: Vec<Origin>,
    known: FxHashMap<Origin, OriginId>,
    latest: Option<(Origin, OriginId)>,
    steps: Vec<Step>,
    known_steps: FxHashMap<(Option<StepId>, TextRange, u32), StepId>,
}

impl Default for Origins {
    fn default() -> Origins {
        let nowhere = Origin { source: Source::Program, range: TextRange::default(), inside: None };
        let known = FxHashMap::from_iter([(nowhere, Origins::NOWHERE)]);
        Origins { origins: vec![nowhere], known, latest: None, steps: Vec::new(), known_steps: FxHashMap::default() }
    }
}

impl Origins {
    /// The beginning of the program, for what no statement did.
    pub const NOWHERE: OriginId = OriginId(0);

    /// The entry of an origin.
    pub fn intern(&mut self, origin: Origin) -> OriginId {
        match self.latest {
            Some((latest, id)) if latest == origin => return id,
            _ => {}
        }
        let origins = &mut self.origins;
        let id = *self.known.entry(origin).or_insert_with(|| {
            origins.push(origin);
            OriginId((origins.len() - 1) as u32)
        });
        self.latest = Some((origin, id));
        id
    }

    /// The entry of a call or iteration. `describe` is asked only where it is new.
    pub fn step(&mut self, outer: Option<StepId>, range: TextRange, index: u32, describe: impl FnOnce() -> StepKind) -> Option<StepId> {
        if let Some(id) = self.known_steps.get(&(outer, range, index)) {
            return Some(*id);
        }
        if self.steps.len() >= MAX_STEPS {
            return outer;
        }
        let id = StepId(self.steps.len() as u32);
        self.steps.push(Step { range, index, kind: describe(), outer });
        self.known_steps.insert((outer, range, index), id);
        Some(id)
    }

    /// An origin by its entry.
    pub fn get(&self, id: OriginId) -> Origin {
        self.origins[id.0 as usize]
    }

    /// The calls and iterations around an origin, innermost first.
    pub fn steps_around(&self, id: OriginId) -> impl Iterator<Item = &Step> {
        let first = self.get(id).inside;
        std::iter::successors(first.map(|id| self.by_id(id)), |step| step.outer.map(|id| self.by_id(id)))
    }

    fn by_id(&self, id: StepId) -> &Step {
        &self.steps[id.0 as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(start: u32, end: u32) -> TextRange {
        TextRange::new(start.into(), end.into())
    }

    #[test]
    fn an_origin_remembers_the_call_and_the_iterations_around_it() {
        let mut origins = Origins::default();
        let row =
            origins.step(None, range(0, 90), 2, || StepKind::Loop { variable: "i".into(), value: "2".into() }).expect("there is room");
        let call = origins.step(Some(row), range(20, 30), 0, || StepKind::Call { function: "place".into() });
        let origin = Origin { source: Source::Program, range: range(50, 60), inside: call };
        let id = origins.intern(origin);
        assert_eq!(origins.intern(origin), id);
        assert_eq!(origins.get(id), origin);
        let around: Vec<_> = origins.steps_around(id).map(|step| (step.range, step.index)).collect();
        assert_eq!(around, [(range(20, 30), 0), (range(0, 90), 2)]);
    }

    #[test]
    fn equal_steps_have_one_entry_and_are_described_once() {
        let mut origins = Origins::default();
        let first = origins.step(None, range(0, 9), 1, || StepKind::Call { function: "f".into() });
        let again = origins.step(None, range(0, 9), 1, || unreachable!("known"));
        assert_eq!(first, again);
    }

    #[test]
    fn an_endless_loop_does_not_fill_the_table() {
        let mut origins = Origins::default();
        for index in 0..(MAX_STEPS as u32 + 10) {
            origins.step(None, range(0, 9), index, || StepKind::Loop { variable: "".into(), value: "".into() });
        }
        assert_eq!(origins.steps.len(), MAX_STEPS);
    }
}
