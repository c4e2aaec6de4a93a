//! What an editor can ask, on whole programs: at every place, half typed, and with what it changes tried by a run.

use proptest::prelude::*;
use psdl::analysis::{Analysis, Input, Options, analyse};
use psdl::check::finding::Code;
use psdl::ide::{self, At, Ground, Program, RefactoringKind, Scene, Sidecar, TemplateText, View, Wanted};
use psdl::repair::Problem;
use psdl::scene::template::{self, Template};
use psdl::syntax::scope::Role;
use ruff_text_size::{TextRange, TextSize};
use std::path::{Path, PathBuf};

/// Programs may recurse as deep as the limits let them.
const STACK: usize = 64 << 20;

/// The programs of this project, and those of the folder that `PSDL_CORPUS` names, each with its sidecar.
fn programs() -> Vec<(PathBuf, String, Option<String>)> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let folders = [Some(own), std::env::var_os("PSDL_CORPUS").map(PathBuf::from)];
    let entries = folders.iter().flatten().flat_map(|folder| std::fs::read_dir(folder).expect("the folder can be listed"));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "psdl"));
    paths.sort();
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("the program can be read");
        let sidecar = std::fs::read_to_string(path.with_extension("template.json")).ok();
        (path, text, sidecar)
    };
    paths.into_iter().map(read).collect()
}

fn with_stack<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> T {
    std::thread::Builder::new().stack_size(STACK).spawn(work).expect("a thread").join().expect("no panic")
}

fn run(text: &str, sidecar: Option<&str>) -> Analysis {
    analyse(&Input { text, template: sidecar }, &Options::default(), None)
}

fn scene(text: &str, sidecar: Option<&str>) -> Option<Scene> {
    let analysis = run(text, sidecar);
    let template = analysis.prepared.template;
    Some(Scene { text: text.into(), layout: analysis.layout?, verdict: analysis.verdict, template, partial: analysis.partial })
}

const ALL: Wanted = Wanted { coordinates: true, facings: true, parameters: true, loops: true };

/// Asks for everything that is about a whole program.
fn ask_about_all(view: &View, template: Option<&Template>) {
    let whole = TextRange::up_to(TextSize::of(view.text()));
    ide::hints(view, whole, ALL);
    ide::lenses(view);
    ide::tokens(view);
    ide::symbols(view);
    ide::folds(view);
    ide::colors(view);
    template.map(|template| (ide::to_template(view, template), ide::from_template(view, template)));
}

/// Asks for everything that is about a place.
fn ask_at(view: &View, sidecar: Option<TemplateText>, offset: TextSize) {
    let template = sidecar.map(|sidecar| sidecar.template);
    ide::hover(view, offset);
    let found = ide::completions(view, offset);
    assert!(found.replaces.end() <= TextSize::of(view.text()));
    ide::signature_help(view, offset);
    ide::definition(view, template, offset);
    ide::references(view, template, offset, true);
    ide::highlights(view, offset);
    for pair in ide::selections(view, offset).windows(2) {
        assert!(pair[1].contains_range(pair[0]), "{pair:?}");
    }
    if let Some(function) = ide::function_at(view, offset) {
        ide::incoming(view, function.selection);
        ide::outgoing(view, function.selection);
    }
    // Whatever the name, it is an answer.
    let _ = ide::prepare(view, sidecar, At::Program(offset));
    let _ = ide::rename(view, sidecar, At::Program(offset), "other");
}

fn ask(text: &str, scene: Option<&Scene>, sidecar: Option<&str>, offsets: impl Iterator<Item = usize>) {
    let program = Program::read(text.into());
    let view = View::new(&program, scene);
    let read = sidecar.and_then(|text| template::parse(text).ok());
    let sidecar = sidecar.zip(read.as_ref()).map(|(text, template)| TemplateText { text, template });
    ask_about_all(&view, read.as_ref());
    for offset in offsets {
        ask_at(&view, sidecar, TextSize::new(u32::try_from(offset).unwrap()));
    }
}

#[test]
fn every_place_of_the_examples_can_be_asked_about() {
    with_stack(|| {
        for (_, text, sidecar) in programs().into_iter().take(4) {
            let scene = scene(&text, sidecar.as_deref());
            ask(&text, scene.as_ref(), sidecar.as_deref(), (0..text.len() + 3).step_by(3));
        }
    });
}

#[test]
fn half_typed_programs_can_be_asked_about() {
    with_stack(|| {
        for (_, text, sidecar) in programs().into_iter().take(4) {
            let scene = scene(&text, sidecar.as_deref());
            for cut in (0..text.len()).step_by(61).map(|cut| text.floor_char_boundary(cut)) {
                // Cut off at the cursor, and with a piece missing behind it.
                let behind = text.ceil_char_boundary((cut + 17).min(text.len()));
                let holed = format!("{}{}", &text[..cut], &text[behind..]);
                ask(&text[..cut], scene.as_ref(), sidecar.as_deref(), [cut].into_iter());
                ask(&holed, scene.as_ref(), sidecar.as_deref(), [cut, cut.saturating_sub(3)].into_iter());
            }
        }
    });
}

/// What must stay as it is: boxes, facings, and how many findings there are.
fn essence(analysis: &Analysis) -> (Vec<(String, String)>, usize) {
    let objects = analysis.layout.iter().flat_map(|layout| &layout.objects);
    let boxes = objects.map(|object| (format!("{:?}", object.body), object.name.clone())).collect();
    (boxes, analysis.findings.len())
}

fn applied(text: &str, edits: &[(TextRange, String)]) -> String {
    let mut text = text.to_string();
    for (range, new) in edits.iter().rev() {
        text.replace_range(range.start().to_usize()..range.end().to_usize(), new);
    }
    text
}

/// Renames what stands at an occurrence of a name and runs both programs; whether it could be renamed.
fn rename_and_run(text: &str, sidecar: Option<&str>, nth: usize, new: &str) -> bool {
    let program = Program::read(text.into());
    let view = View::new(&program, None);
    let occurrences = program.parsed.scopes.occurrences();
    let Some(found) = occurrences.get(nth % occurrences.len().max(1)) else { return false };
    let read = sidecar.and_then(|text| template::parse(text).ok());
    let both = sidecar.zip(read.as_ref()).map(|(text, template)| TemplateText { text, template });
    let Ok(rename) = ide::rename(&view, both, At::Program(found.range.start()), new) else { return false };
    let after = applied(text, &rename.program);
    let after_sidecar = sidecar.map(|text| applied(text, &rename.template));
    let (before, then) = (run(text, sidecar), run(&after, after_sidecar.as_deref()));
    assert_eq!(essence(&before), essence(&then), "{} → {new}:\n{after}", &text[found.range]);
    true
}

#[test]
fn every_variable_can_be_renamed_and_nothing_moves() {
    with_stack(|| {
        for (path, text, sidecar) in programs() {
            let program = Program::read(text.as_str().into());
            let occurrences = program.parsed.scopes.occurrences();
            let bound = (0..occurrences.len()).filter(|nth| occurrences[*nth].role == Role::Bind);
            let renamed = bound.step_by(4).filter(|nth| rename_and_run(&text, sidecar.as_deref(), *nth, "quite_new")).count();
            assert!(renamed > 0 || sidecar.is_some(), "nothing could be renamed in {}", path.display());
        }
    });
}

/// Programs with the scoping of Python in them.
fn scoped() -> impl Strategy<Value = String> {
    let name = || prop::sample::select(vec!["a", "b", "c", "gap", "o"]);
    let line = (name(), name(), name(), 0_u8..9).prop_map(|(x, y, z, form)| match form {
        0 => format!("{x} = 0.5\n"),
        1 => format!("def f_{x}({y}, {z}=0.25):\n    return {y} + gap\n").replace(&format!("{y}, {y}="), &format!("{y}, {y}_2=")),
        2 => format!("{x} = [{y} for {y} in (1.0, 2.0)][0]\n"),
        3 => "bed.min.x = scene.min.x + gap\n".to_string(),
        4 => format!("def g_{x}():\n    global {y}\n    {y} = 1.5\ng_{x}()\n"),
        5 => format!(
            "def h_{x}({y}):\n    {z} = 0.75\n    def inner():\n        return {z} + {y}\n    return inner()\nbed.min.y = h_{x}(0.5)\n"
        ),
        6 => format!("for {x} in (0.5, 1.0):\n    bed.center.x = {x}\n"),
        7 => format!("def k(o, {x}_2=0.1):\n    o.min.z = {x}_2\nk(bed, {x}_2=0.5)\n"),
        _ => format!("t_{x} = f'{{gap:.1f}} {{gap=}}'\n"),
    });
    let head = "a = b = c = o = 1.0\ngap = 0.25\nbed = Object('Bed', 2.0, 1.0, 1.0)\n";
    prop::collection::vec(line, 1..12).prop_map(move |lines| format!("{head}{}", lines.concat()))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn renaming_never_changes_the_layout(text in scoped(), nth in 0_usize..200, new in prop::sample::select(vec!["a", "b", "gap", "o", "new", "c_2", "bed", "inner"])) {
        with_stack(move || rename_and_run(&text, None, nth, new));
    }

    #[test]
    fn any_text_can_be_asked_about(text in "([a-z]{1,4}|[ \n:.,=()\\[\\]'\"#é]|for |def |0\\.5|    ){0,60}", at in 0_usize..80) {
        let at = at.min(text.len() + 1);
        with_stack(move || ask(&text, None, None, [at, text.len()].into_iter()));
    }
}

/// How often a kind of finding is told.
fn told(analysis: &Analysis, code: Code) -> usize {
    analysis.findings.iter().filter(|finding| finding.code == code).count()
}

#[test]
fn a_comment_that_hides_a_finding_hides_it_and_changes_nothing_else() {
    with_stack(|| {
        for (path, text, sidecar) in programs() {
            let before = run(&text, sidecar.as_deref());
            let program = Program::read(text.as_str().into());
            for finding in before.findings.iter().step_by(3) {
                let Some(edit) = ide::suppress(&text, &program.parsed, finding) else { continue };
                let after = run(&applied(&text, &[edit]), sidecar.as_deref());
                let what = format!("{}: {:?} at {:?}", path.display(), finding.code, finding.place.range);
                assert!(told(&after, finding.code) < told(&before, finding.code), "{what}");
                assert_eq!(told(&after, Code::UnusedSuppression), told(&before, Code::UnusedSuppression), "{what}");
                assert_eq!(essence(&after).0, essence(&before).0, "{what}");
            }
        }
    });
}

#[test]
fn every_rewriting_keeps_the_scene() {
    with_stack(|| {
        let mut kinds = std::collections::BTreeSet::new();
        for (path, text, sidecar) in programs() {
            let before = essence(&run(&text, sidecar.as_deref())).0;
            let Ok(problem) = Problem::new(&Input { text: &text, template: sidecar.as_deref() }, &Options::default()) else { continue };
            let ground = Ground { problem: &problem, template: sidecar.as_deref(), has_place: true };
            let tuning = problem.tuning();
            let places = tuning.constants.iter().map(|found| found.range).chain(tuning.directions.iter().map(|found| found.range));
            let places = places.chain(tuning.integers.iter().map(|found| found.range)).step_by(7);
            for place in places.map(|range| range.start()).chain([TextSize::new(0)]) {
                for found in ide::refactorings(&ground, TextRange::empty(place), &|_| true) {
                    let outside = match &found.sidecar {
                        None => sidecar.as_deref(),
                        Some(Sidecar::Created(json)) => Some(json.as_str()),
                        Some(Sidecar::Deleted) => None,
                    };
                    let after = applied(&text, &found.edits);
                    assert_ne!(after, text, "{}: {}", path.display(), found.title);
                    assert_eq!(essence(&run(&after, outside)).0, before, "{}: {}", path.display(), found.title);
                    kinds.insert(found.kind.name());
                }
            }
        }
        assert_eq!(kinds.len(), RefactoringKind::ALL.len(), "{kinds:?}");
    });
}
