//! What features are asked about: a program as its text stands, and the scene of its last run.

use crate::check::{Verdict, Violation};
use crate::scene::template::Template;
use crate::scene::{Axis, Layout, Origin, Placed, Source};
use crate::syntax::{Parsed, Tuning, parse, tune};
use ruff_text_size::{TextRange, TextSize};
use std::sync::Arc;

/// A program, read.
#[derive(Clone, Debug)]
pub struct Program {
    /// The text.
    pub text: Arc<str>,
    /// Its tree and its names.
    pub parsed: Parsed,
    /// What of it may be rewritten.
    pub tuning: Tuning,
}

impl Program {
    /// Reads a text.
    pub fn read(text: Arc<str>) -> Program {
        let parsed = parse(&text);
        let tuning = tune(&parsed, &text);
        Program { text, parsed, tuning }
    }
}

/// The scene that a run made.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The text that was run.
    pub text: Arc<str>,
    /// Where everything is.
    pub layout: Layout,
    /// The errors.
    pub verdict: Verdict,
    /// The sidecar template of the run.
    pub template: Option<Template>,
    /// The program did not come to its end.
    pub partial: bool,
}

/// What a statement did to an object.
#[derive(Clone, Copy, PartialEq, Eq, Debug, PartialOrd, Ord)]
pub enum Deed {
    /// Declared it.
    Declared,
    /// Wrote the last anchor of a world axis.
    Anchored(Axis),
    /// Set its facing last.
    Faced,
    /// Called or repeated what did.
    Around,
}

/// That a piece of the program's text did something to an object.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Mark {
    /// The statement, call or loop header, in the text that was run.
    pub range: TextRange,
    /// The object, as an index of the layout.
    pub object: usize,
    /// What.
    pub deed: Deed,
}

impl Scene {
    /// What each statement of the program did, by place and then by object.
    pub fn marks(&self) -> Vec<Mark> {
        let mut marks = Vec::with_capacity(self.layout.objects.len() * 6);
        for (object, placed) in self.layout.objects.iter().enumerate() {
            let anchors = placed.anchors.iter().map(|anchor| (anchor.origin, Deed::Anchored(anchor.axis)));
            let faced = placed.faced.map(|(origin, _)| (origin, Deed::Faced));
            for (id, deed) in anchors.chain(faced).chain([(placed.declared, Deed::Declared)]) {
                let Origin { source, range, .. } = self.layout.origins.get(id);
                if source == Source::Program && !range.is_empty() {
                    marks.push(Mark { range, object, deed });
                    let around = self.layout.origins.steps_around(id);
                    marks.extend(around.map(|step| Mark { range: step.range, object, deed: Deed::Around }));
                }
            }
        }
        marks.sort_unstable_by_key(|mark| (mark.range.start(), mark.range.end(), mark.object, mark.deed));
        marks.dedup();
        marks
    }

    /// An object.
    pub fn object(&self, index: usize) -> Option<&Placed> {
        self.layout.objects.get(index)
    }

    /// The errors that an object takes part in.
    pub fn errors_of(&self, index: usize) -> impl Iterator<Item = &Violation> {
        self.verdict.violations.iter().filter(move |violation| violation.objects().any(|object| object == index))
    }

    /// How many errors some objects take part in, each counted once.
    pub fn errors_among(&self, objects: &[usize]) -> usize {
        let counted = self.verdict.counted();
        counted.filter(|violation| violation.objects().any(|object| objects.binary_search(&object).is_ok())).count()
    }
}

/// A program and the scene of its last run that came to something, maybe of an older text.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// The program as it stands.
    pub program: &'a Program,
    /// The scene.
    pub scene: Option<&'a Scene>,
    /// Where the texts differ: from here on…
    same: TextSize,
    /// …to here in the text that was run, and in the program.
    ends: (TextSize, TextSize),
}

impl<'a> View<'a> {
    /// A program with its last scene.
    pub fn new(program: &'a Program, scene: Option<&'a Scene>) -> View<'a> {
        let now = program.text.as_bytes();
        let (same, ends) = match scene {
            Some(scene) if !Arc::ptr_eq(&scene.text, &program.text) => difference(scene.text.as_bytes(), now),
            _ => (now.len(), (now.len(), now.len())),
        };
        let size = |at: usize| TextSize::new(u32::try_from(at).unwrap_or(u32::MAX));
        View { program, scene, same: size(same), ends: (size(ends.0), size(ends.1)) }
    }

    /// The text.
    pub fn text(&self) -> &'a str {
        &self.program.text
    }

    /// What stands in a range; nothing where the range is not of this text.
    pub fn slice(&self, range: TextRange) -> &'a str {
        self.text().get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default()
    }

    /// Whether the scene is that of another text.
    pub fn is_stale(&self) -> bool {
        self.scene.is_some_and(|scene| self.ends.0 != self.ends.1 || *scene.text != *self.program.text)
    }

    /// Where a place of the text that was run stands now; `None` where it was edited.
    pub fn now(&self, range: TextRange) -> Option<TextRange> {
        if range.end() <= self.same {
            return Some(range);
        }
        (range.start() >= self.ends.0).then(|| range - self.ends.0 + self.ends.1)
    }

    /// Where a place of this text stood in the text that was run; `None` where it was edited.
    pub fn then(&self, range: TextRange) -> Option<TextRange> {
        if range.end() <= self.same {
            return Some(range);
        }
        (range.start() >= self.ends.1).then(|| range - self.ends.1 + self.ends.0)
    }

    /// What each statement that still stands did, by its place in this text.
    pub fn marks(&self) -> Vec<Mark> {
        let marks = self.scene.map(Scene::marks).unwrap_or_default();
        marks.into_iter().filter_map(|mark| self.now(mark.range).map(|range| Mark { range, ..mark })).collect()
    }

    /// Runs a recursive walk over the tree with room for its depth.
    pub fn with_stack<R>(&self, walk: impl FnOnce() -> R) -> R {
        self.program.parsed.with_stack(walk)
    }
}

/// The bytes before the first difference, and where the texts are the same again.
fn difference(old: &[u8], new: &[u8]) -> (usize, (usize, usize)) {
    let before = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    let room = old.len().min(new.len()) - before;
    let after = old.iter().rev().zip(new.iter().rev()).take(room).take_while(|(a, b)| a == b).count();
    (before, (old.len() - after, new.len() - after))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::scene_of;

    fn range(text: &str, part: &str) -> TextRange {
        let at = text.find(part).unwrap();
        TextRange::new((at as u32).into(), ((at + part.len()) as u32).into())
    }

    #[test]
    fn places_follow_an_edit_that_was_not_run() {
        let old = "a = Object('A', 1, 1, 1)\na.min.x = 0.5\na.min.y = 0.5\n";
        let new = "a = Object('A', 1, 1, 1)\na.min.x = (0.75 +\na.min.y = 0.5\n";
        let scene = scene_of(old, None).unwrap();
        let program = Program::read(new.into());
        let view = View::new(&program, Some(&scene));
        assert!(view.is_stale());
        assert_eq!(view.now(range(old, "a.min.y = 0.5")), Some(range(new, "a.min.y = 0.5")));
        assert_eq!(view.then(range(new, "a = Object")), Some(range(old, "a = Object")));
        assert_eq!(view.now(range(old, "a.min.x = 0.5")), None);
    }

    #[test]
    fn statements_know_what_they_did() {
        let text = "a = [Object('A', 1, 1, 1) for i in range(2)]\nfor o in a:\n    o.min.x = 0.5\n";
        let scene = scene_of(text, None).unwrap();
        let marks = scene.marks();
        let of = |part: &str, deed: Deed| {
            let meant = |mark: &&Mark| mark.range.contains_range(range(text, part)) && mark.deed == deed;
            marks.iter().filter(meant).map(|mark| mark.object).collect::<Vec<_>>()
        };
        assert_eq!(of("o.min.x = 0.5", Deed::Anchored(Axis::X)), [0, 1]);
        assert_eq!(of("Object('A', 1, 1, 1)", Deed::Declared), [0, 1]);
        assert_eq!(of("for i in range(2)", Deed::Around), [0, 1]);
    }
}
