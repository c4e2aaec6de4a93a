//! Rewritings that keep the scene as it is, to the last bit: each is offered only after a run of the new text showed that.

mod literal;
mod relative;
mod spelling;
mod template;

use crate::analysis::{Input, Mode, execute, prepare};
use crate::repair::Problem;
use crate::scene::{Body, Layout};
use crate::syntax::Edit;
use ruff_text_size::TextRange;

/// How a rewriting is called where kinds are chosen.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RefactoringKind {
    /// A repeated constant becomes a variable.
    ExtractConstant,
    /// An integer becomes a float.
    Tunable,
    /// A direction is spelled in another way.
    Direction,
    /// A coordinate is taken from another object.
    Relative,
    /// The template moves into the program, or out of it.
    Template,
}

impl RefactoringKind {
    /// All kinds.
    pub const ALL: [RefactoringKind; 5] = [
        RefactoringKind::ExtractConstant,
        RefactoringKind::Tunable,
        RefactoringKind::Direction,
        RefactoringKind::Relative,
        RefactoringKind::Template,
    ];

    /// As editors know it.
    pub const fn name(self) -> &'static str {
        match self {
            RefactoringKind::ExtractConstant => "refactor.extract.psdl.constant",
            RefactoringKind::Tunable => "refactor.rewrite.psdl.tunable",
            RefactoringKind::Direction => "refactor.rewrite.psdl.direction",
            RefactoringKind::Relative => "refactor.rewrite.psdl.relative",
            RefactoringKind::Template => "refactor.rewrite.psdl.template",
        }
    }
}

/// What becomes of the sidecar template.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Sidecar {
    /// It is written beside the program.
    Created(String),
    /// It is deleted.
    Deleted,
}

/// A rewriting.
#[derive(Clone, PartialEq, Debug)]
pub struct Refactoring {
    /// What it does.
    pub title: String,
    /// Which kind.
    pub kind: RefactoringKind,
    /// Byte ranges of the program and what replaces them; disjoint, in ascending order.
    pub edits: Vec<Edit>,
    /// What becomes of the template, where that changes.
    pub sidecar: Option<Sidecar>,
}

/// A program with its template, and what a run of it gave.
#[derive(Clone, Copy, Debug)]
pub struct Ground<'a> {
    /// The program, run.
    pub problem: &'a Problem,
    /// Its sidecar template.
    pub template: Option<&'a str>,
    /// Whether a template can be written beside it, or deleted there.
    pub has_place: bool,
}

/// The rewritings of some kinds at a place.
pub fn refactorings(ground: &Ground, range: TextRange, wanted: &dyn Fn(RefactoringKind) -> bool) -> Vec<Refactoring> {
    let mut found = Vec::new();
    let mut add = |kind, candidates: &dyn Fn() -> Vec<Refactoring>, most: usize| {
        if wanted(kind) {
            found.extend(candidates().into_iter().filter(|candidate| ground.keeps(candidate)).take(most));
        }
    };
    add(RefactoringKind::ExtractConstant, &|| literal::extract(ground, range).into_iter().collect(), 1);
    add(RefactoringKind::Tunable, &|| literal::tunable(ground, range).into_iter().collect(), 1);
    add(RefactoringKind::Direction, &|| spelling::directions(ground, range), 4);
    add(RefactoringKind::Relative, &|| relative::relative(ground, range), 2);
    add(RefactoringKind::Template, &|| template::move_template(ground, range).into_iter().collect(), 1);
    found
}

/// A text after some edits.
pub(super) fn edited(text: &str, edits: &[Edit]) -> Option<String> {
    let mut text = text.to_string();
    for (range, new) in edits.iter().rev() {
        let range = range.start().to_usize()..range.end().to_usize();
        text.get(range.clone())?;
        text.replace_range(range, new);
    }
    Some(text)
}

impl Ground<'_> {
    fn text(&self) -> &str {
        self.problem.text()
    }

    /// What stands in a range.
    fn slice(&self, range: TextRange) -> &str {
        self.text().get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default()
    }

    /// Whether the program gives the same scene after a rewriting.
    fn keeps(&self, refactoring: &Refactoring) -> bool {
        let Some(text) = edited(self.text(), &refactoring.edits) else { return false };
        let template = match &refactoring.sidecar {
            None => self.template,
            Some(Sidecar::Created(text)) => Some(text.as_str()),
            Some(Sidecar::Deleted) => None,
        };
        let mode = Mode { lenient: true, trace: false };
        let prepared = prepare(&Input { text: &text, template });
        let ran = execute(&prepared, self.problem.options(), mode, None, &mut |_| {});
        ran.is_some_and(|ran| {
            ran.stop.is_none() && ran.exceptions.len() == self.problem.exceptions() && is_same(self.problem.layout(), &ran.layout)
        })
    }
}

/// Whether two layouts are the same to the last bit.
pub(super) fn is_same(a: &Layout, b: &Layout) -> bool {
    let bits = |body: &Body| [body.center, body.min, body.max, body.dims].map(|corner| corner.map(f64::to_bits));
    let scene = |layout: &Layout| (layout.scene.title.clone(), layout.scene.size().map(f64::to_bits), layout.scene.interior);
    let pairs = || a.objects.iter().zip(&b.objects);
    scene(a) == scene(b)
        && a.objects.len() == b.objects.len()
        && pairs().all(|(a, b)| {
            let (x, y) = (&a.body, &b.body);
            let named = (&a.path, &a.name, &a.color, a.dynamic) == (&b.path, &b.name, &b.color, b.dynamic);
            let body =
                (x.kind, x.support, x.turn, x.told, x.directed, x.anchors) == (y.kind, y.support, y.turn, y.told, y.directed, y.anchors);
            named && body && bits(x) == bits(y)
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Options;

    /// The titles of a kind at the `|`, and program and template after the first of them.
    fn at_cursor(kind: RefactoringKind, marked: &str, template: Option<&str>) -> (Vec<String>, String, Option<String>) {
        let at = u32::try_from(marked.find('|').expect("a cursor")).expect("a short text");
        let text = marked.replacen('|', "", 1);
        let input = Input { text: &text, template };
        let problem = Problem::new(&input, &Options::default()).expect("it runs");
        let ground = Ground { problem: &problem, template, has_place: true };
        let found = refactorings(&ground, TextRange::empty(at.into()), &|other| other == kind);
        let titles = found.iter().map(|found| found.title.clone()).collect();
        let after = found.first().map_or_else(|| text.clone(), |found| edited(&text, &found.edits).expect("it can be edited"));
        let sidecar = found.first().and_then(|found| found.sidecar.clone());
        let template = match sidecar {
            Some(Sidecar::Created(text)) => Some(text),
            _ => None,
        };
        (titles, after, template)
    }

    const BOX: &str = "a = Object('A', 1, 1, 1)\nb = Object('B', 1, 1, 1)\n";

    #[test]
    fn a_repeated_constant_becomes_a_variable() {
        let (titles, after, _) = at_cursor(
            RefactoringKind::ExtractConstant,
            &format!("{BOX}a.center = (0, 0, 0.5)\nb.min.x = a.max.x + 0.|25\nb.max.y = a.min.y - 0.25\n"),
            None,
        );
        assert_eq!(titles, ["Extract 0.25, which stands here 2 times, into the variable gap"]);
        assert_eq!(after, format!("{BOX}a.center = (0, 0, 0.5)\ngap = 0.25\nb.min.x = a.max.x + gap\nb.max.y = a.min.y - gap\n"));
    }

    #[test]
    fn what_stands_once_is_not_extracted() {
        assert!(at_cursor(RefactoringKind::ExtractConstant, &format!("{BOX}a.min.x = 0.|25\n"), None).0.is_empty());
    }

    #[test]
    fn an_integer_becomes_tunable_unless_it_counts() {
        let (titles, after, _) = at_cursor(RefactoringKind::Tunable, &format!("{BOX}a.min.x = -|2\n"), None);
        assert_eq!((titles, after), (vec!["Make 2 tunable: 2.0".to_string()], format!("{BOX}a.min.x = -2.0\n")));
        assert!(at_cursor(RefactoringKind::Tunable, &format!("{BOX}for i in range(|2): a.min.x = i\n"), None).0.is_empty());
    }

    #[test]
    fn directions_are_spelled_anew() {
        let (titles, after, _) = at_cursor(RefactoringKind::Direction, &format!("{BOX}a.facing = |0\nb.facing = 3\n"), None);
        assert_eq!(titles, ["Write X_MAX for 0", "Write X_POS for 0", "Write all 2 directions like X_MAX"]);
        assert_eq!(after, format!("{BOX}a.facing = X_MAX\nb.facing = 3\n"));
        let (titles, ..) = at_cursor(RefactoringKind::Direction, &format!("{BOX}a.facing = X|_MAX\n"), None);
        assert_eq!(titles, ["Write X_POS for X_MAX", "Write 0 for X_MAX"]);
    }

    #[test]
    fn a_coordinate_is_taken_from_what_it_touches() {
        let (titles, after, _) =
            at_cursor(RefactoringKind::Relative, &format!("{BOX}a.center = (0, 0, 0.5)\nb.min.x = |0.5\nb.min.y = -0.5\n"), None);
        assert_eq!(titles[0], "Take the coordinate from a: a.max.x");
        assert!(after.contains("b.min.x = a.max.x\n"), "{after}");
        let (titles, ..) = at_cursor(RefactoringKind::Relative, &format!("{BOX}b.max.x = |3.0\nb.min.y = -0.5\n"), None);
        assert_eq!(titles[0], "Take the coordinate from scene: scene.max.x");
    }

    #[test]
    fn a_template_goes_into_the_program_and_back() {
        let template = r#"{"title": "T \"x\"", "width": 5, "depth": 4.5, "height": 3, "interior": false,
            "objects": [{"id": "chairs", "name": "Chair", "width": 0.5, "depth": 0.5, "height": 1, "support": "STANDING", "count": 2},
                        {"id": "door", "name": "Door", "kind": "door", "width": 0.9, "depth": 0.1, "height": 2, "support": "MOUNTED", "color": "8B4513"}]}"#;
        let text = "|chairs[0].min.x = 0.25\ndoor.max.x = 1\n";
        let (titles, inside, _) = at_cursor(RefactoringKind::Template, text, Some(template));
        assert_eq!(titles, ["Move the template into the program"]);
        assert!(inside.contains("chairs = [Object(\"Chair\", 0.5, 0.5, 1, STANDING) for _ in range(2)]\n"), "{inside}");
        let (titles, outside, json) = at_cursor(RefactoringKind::Template, &format!("|{inside}"), None);
        assert_eq!(titles, ["Move the template into a file beside the program"]);
        assert!(outside.ends_with(&text[1..]) && !outside.contains("Object("), "{outside}");
        assert!(json.is_some_and(|json| json.contains("\"count\": 2")));
    }
}
