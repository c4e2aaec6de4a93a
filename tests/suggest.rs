//! What is offered beside a finding keeps its promise: on the examples, and on the programs of the folder `PSDL_CORPUS` where there is one.

use psdl::analysis::{Analysis, Input, Options, analyse};
use psdl::check::{ErrorKind, Verdict, Violation, errors_by_place};
use psdl::repair::{Change, Changes, Names, Problem, Suggester, Suggestion, title};
use psdl::scene::Body;
use psdl::syntax::{ConstantId, DirectionId, Edit};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Programs may recurse as deep as the limits let them.
const STACK: usize = 64 << 20;

struct Program {
    name: String,
    text: String,
    template: Option<String>,
}

impl Program {
    fn input(&self) -> Input<'_> {
        Input { text: &self.text, template: self.template.as_deref() }
    }
}

fn programs() -> Vec<Program> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let folders = [Some(own), std::env::var_os("PSDL_CORPUS").map(PathBuf::from)];
    let entries = folders.into_iter().flatten().flat_map(|folder| std::fs::read_dir(folder).expect("the folder can be listed"));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "psdl"));
    paths.sort();
    let read = |path: PathBuf| Program {
        name: path.display().to_string(),
        text: std::fs::read_to_string(&path).expect("the program can be read"),
        template: std::fs::read_to_string(path.with_extension("template.json")).ok(),
    };
    paths.into_iter().map(read).collect()
}

/// Does something with each program, on a thread with a stack as large as programs may need.
fn with_programs(work: impl Fn(&Program) + Send + Sync + Copy + 'static) {
    for program in programs() {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn(move || work(&program)).expect("a thread");
        thread.join().expect("no panic");
    }
}

fn edited(text: &str, edits: &[Edit]) -> String {
    let mut text = text.to_string();
    for (range, new) in edits.iter().rev() {
        text.replace_range(range.start().to_usize()..range.end().to_usize(), new);
    }
    text
}

type Key = (ErrorKind, u32, Option<u32>);

fn keys(verdict: &Verdict) -> BTreeSet<Key> {
    verdict.counted().map(|error| (error.kind, error.culprit, error.other)).collect()
}

fn bodies(analysis: &Analysis) -> Vec<Body> {
    analysis.layout.as_ref().expect("a layout").bodies()
}

fn total(tally: &[(ErrorKind, usize)]) -> usize {
    tally.iter().map(|(_, count)| count).sum()
}

/// Looks at the edited text with fresh eyes.
fn keeps_its_promise(program: &Program, before: &Analysis, suggestion: &Suggestion, errors: &[Violation], title: &str) {
    let text = edited(&program.text, &suggestion.edits);
    let after = analyse(&Input { text: &text, ..program.input() }, &Options::default(), None);
    let (old, new) = (keys(&before.verdict), keys(&after.verdict));
    let what = format!("{}: {title}", program.name);
    assert_eq!(total(&suggestion.clears), old.difference(&new).count(), "{what}");
    assert_eq!(total(&suggestion.adds), new.difference(&old).count(), "{what}");
    assert!(new.len() < old.len() || suggestion.adds.is_empty(), "{what}");
    let cleared = errors.iter().filter(|error| !new.contains(&(error.kind, error.culprit, error.other))).count();
    assert!(cleared > 0 && suggestion.complete == (cleared == errors.len()), "{what}: {cleared} of {}", errors.len());
    let moved = |(a, b): &(&Body, &Body)| (0..3).map(|k| (a.center[k] - b.center[k]).powi(2)).sum::<f64>().sqrt() > 1e-6;
    let (then, now) = (bodies(before), bodies(&after));
    assert_eq!(suggestion.moved.len(), then.iter().zip(&now).filter(moved).count(), "{what}");
    assert!(after.verdict.loss() < before.verdict.loss(), "{what}");
    for (kind, count) in &suggestion.clears {
        assert!(*count > 0 && old.iter().any(|error| error.0 == *kind), "{what}");
    }
}

#[test]
fn every_suggestion_does_what_its_title_says() {
    with_programs(|program| {
        let options = Options::default();
        let before = analyse(&program.input(), &options, None);
        let Ok(problem) = Problem::new(&program.input(), &options) else { return };
        let mut suggester = Suggester::new(&problem);
        let names = Names::of(problem.parsed());
        for (_, place, errors) in errors_by_place(problem.layout(), problem.verdict(), &options.rules) {
            for suggestion in suggester.suggest(&problem, &errors, 4, None) {
                let title = title(&problem, &names, &suggestion, place.range);
                assert!(title.contains(&format!("clears {}", total(&suggestion.clears))) || suggestion.clears.len() == 2, "{title}");
                keeps_its_promise(program, &before, &suggestion, &errors, &title);
            }
        }
    });
}

/// What single edits lead to: the errors of each.
fn all_single_edits(problem: &Problem) -> Vec<(Changes, BTreeSet<Key>)> {
    let tuning = problem.tuning();
    let mut changes = Vec::new();
    for (at, constant) in tuning.constants.iter().enumerate() {
        let id = ConstantId(u32::try_from(at).expect("few"));
        if problem.is_free(id) {
            let steps = [0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0, 1.5, 2.0];
            changes.extend(steps.into_iter().flat_map(|step| [step, -step]).map(|step| Change::Constant(id, constant.value + step)));
        }
    }
    for at in 0..tuning.directions.len() {
        let id = DirectionId(u32::try_from(at).expect("few"));
        changes.extend(psdl::syntax::tune::Cardinal::ALL.map(|cardinal| Change::Turn(id, cardinal)));
    }
    let tried = changes.into_iter().map(|change| Changes::default().with(change, tuning)).filter_map(|changes| {
        let ran = problem.run(&changes, false)?;
        let verdict = psdl::check::check(&ran.layout, &problem.options().rules);
        Some((changes, keys(&verdict)))
    });
    tried.collect()
}

#[test]
fn a_finding_that_a_single_edit_clears_has_a_suggestion() {
    with_programs(|program| {
        let options = Options::default();
        let Ok(problem) = Problem::new(&program.input(), &options) else { return };
        let mut suggester = Suggester::new(&problem);
        let old = keys(problem.verdict());
        let mut tried: Option<Vec<(Changes, BTreeSet<Key>)>> = None;
        for (kind, place, errors) in errors_by_place(problem.layout(), problem.verdict(), &options.rules) {
            if kind == ErrorKind::Unplaced || !suggester.suggest(&problem, &errors, 1, None).is_empty() {
                continue;
            }
            let tried = tried.get_or_insert_with(|| all_single_edits(&problem));
            let gone = |new: &BTreeSet<Key>| errors.iter().all(|error| !new.contains(&(error.kind, error.culprit, error.other)));
            let missed = tried.iter().find(|(_, new)| new.is_subset(&old) && gone(new));
            let missed = missed.map(|(changes, _)| problem.rewrite(changes).map(|(_, edits)| edits));
            assert!(missed.is_none(), "{}: {} at {:?}: {missed:?}", program.name, kind.name(), &program.text[place.range]);
        }
    });
}

/// The titles of the first suggestions for each finding of a program.
fn titles(text: &str) -> Vec<String> {
    let options = Options::default();
    let mut findings = analyse(&Input { text, template: None }, &options, None).findings;
    psdl::repair::add_suggestions(&Input { text, template: None }, &options, &mut findings);
    findings.into_iter().filter_map(|finding| finding.suggestion).map(|suggestion| suggestion.title).collect()
}

#[test]
fn a_title_says_what_is_written_what_vanishes_and_what_moves() {
    let row = "\
chairs = [Object('Chair', 0.5, 0.5, 1.0) for _ in range(5)]
gap = 0.4
for i, chair in enumerate(chairs):
    chair.min.x = scene.min.x + i * gap
    chair.center.y = scene.center.y
";
    assert_eq!(titles(row), ["Change gap 0.4 → 0.5: clears 4 overlaps, moves 4 chairs"]);
    let desk = "\
clock = Object('Clock', 0.4, 0.1, 0.4, MOUNTED)
clock.max.y = scene.max.y
clock.center.x = scene.center.x
clock.min.z = 2
desk = Object('Desk', 1.6, 0.7, 0.8)
desk.max.y = scene.max.y
desk.center.x = scene.center.x
desk.facing = clock
";
    assert_eq!(titles(desk), ["Turn desk to Y_MIN: clears 1 facing-wall error"]);
    let lamp = "\
offset = 0.3

lamp = Object('Lamp', 0.4, 0.4, 0.5)
lamp.center.x = lamp.center.y = 0
lamp.min.z = scene.min.z + offset * 2
";
    assert_eq!(titles(lamp), ["Change offset 0.3 → 0.0: clears 1 standing error, moves lamp"]);
}

#[test]
fn two_edits_are_offered_where_one_is_not_enough() {
    let corner = "\
box = Object('Box', 1.0, 1.0, 1.0)
box.max.x = scene.max.x + 0.4
box.max.y = scene.max.y + 0.3
";
    assert_eq!(titles(corner), ["Change 0.4 → 0.0 and change 0.3 on line 3 → 0.0: clears 1 out-of-bounds error, moves box"]);
}
