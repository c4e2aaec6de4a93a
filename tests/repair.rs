//! Error correction: what it rewrites in small scenes, and that a replay is a run.

use std::path::{Path, PathBuf};

use psdl::analysis::{Input, Options};
use psdl::check::ErrorKind;
use psdl::repair::{Change, Changes, Fix, Method, Problem, Settings, fix};
use psdl::syntax::ConstantId;
use psdl::trace::{Op, Replay, Slices, Table, apply};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The room of the small scenes: 6 × 6 × 3.
const ROOM: &str = "\
table = Object('Table', 2.0, 1.0, 0.8)
lamp = Object('Lamp', 0.4, 0.4, 0.5)
table.center.x = scene.center.x
table.center.y = scene.center.y
";

fn problem(text: &str) -> Problem {
    Problem::new(&Input { text, template: None }, &Options::default()).unwrap_or_else(|unfit| panic!("{unfit:?}"))
}

fn corrected(text: &str, settings: &Settings) -> Fix {
    fix(&problem(text), settings)
}

/// Corrects what is added to the room: errors before and after, and the added lines as they are then.
fn room(lines: &str) -> (usize, usize, String) {
    let fix = corrected(&format!("{ROOM}{lines}"), &Settings::default());
    (fix.errors_before(), fix.errors_after(), fix.text.strip_prefix(ROOM).expect("the room as it was").to_string())
}

#[test]
fn an_object_outside_comes_in_as_far_as_it_must() {
    let (before, after, text) = room("lamp.max.x = scene.max.x + 0.5\nlamp.min.y = scene.min.y");
    assert_eq!((before, after, text.as_str()), (1, 0, "lamp.max.x = scene.max.x + 0.0\nlamp.min.y = scene.min.y"));
}

#[test]
fn what_floats_comes_down_to_what_carries_it() {
    let (before, after, text) = room("lamp.center.x = 0.1\nlamp.center.y = 0.1\nlamp.min.z = table.max.z + 0.3");
    assert_eq!((before, after, text.as_str()), (1, 0, "lamp.center.x = 0.1\nlamp.center.y = 0.1\nlamp.min.z = table.max.z + 0.0"));
}

#[test]
fn an_overlap_ends_at_contact_with_one_edit() {
    let (before, after, text) = room("lamp.center.x = table.center.x\nlamp.min.y = table.max.y - 0.15");
    assert_eq!((before, after), (1, 0));
    assert!(text == "lamp.center.x = table.center.x\nlamp.min.y = table.max.y - 0.0" || text.ends_with("table.max.y - 0.01"), "{text}");
}

#[test]
fn a_direction_is_turned_where_no_constant_helps() {
    let text = "picture = Object('Picture', 1.0, 0.1, 0.8, MOUNTED)
picture.max.y = scene.max.y
picture.center.x = 0
picture.min.z = 1
picture.facing = X_MAX";
    let fix = corrected(text, &Settings::default());
    assert_eq!((fix.errors_before(), fix.errors_after(), fix.edits.len()), (1, 0, 1));
    assert!(fix.text.contains("picture.facing = Y_M"), "{}", fix.text);
}

#[test]
fn sizes_integers_and_the_template_are_never_touched() {
    let text = "width = 9.5\nbox = Object('Box', width, 1.0, 1.0)\nbox.center.x = 0\nbox.center.y = 1";
    let fix = corrected(text, &Settings::default());
    assert_eq!((fix.errors_before(), fix.edits.len(), fix.text.as_str()), (1, 0, text));
}

#[test]
fn settings_hold() {
    let lines = "lamp.max.x = scene.max.x + 0.5\nlamp.min.y = scene.min.y\nlamp.min.z = 0.75";
    let text = format!("{ROOM}{lines}");
    let only = Settings { only: vec![ErrorKind::Standing], ..Settings::default() };
    assert!(corrected(&text, &only).text.contains("scene.max.x + 0.5"));
    assert!(corrected(&text, &Settings { max_edits: 0, ..Settings::default() }).edits.is_empty());
    assert!(corrected(&text, &Settings { budget: 0, ..Settings::default() }).edits.is_empty());
    let first_lines = psdl::syntax::ast::TextRange::up_to(u32::try_from(ROOM.len()).expect("a short text").into());
    assert!(corrected(&text, &Settings { within: Some(first_lines), ..Settings::default() }).edits.is_empty());
}

#[test]
fn the_search_of_the_paper_gives_the_same_for_the_same_seed() {
    let text = format!("{ROOM}lamp.max.x = scene.max.x + 0.5\nlamp.min.y = scene.min.y");
    let with = |seed| corrected(&text, &Settings { method: Method::Paper, seed, ..Settings::default() });
    assert_eq!(with(1).text, with(1).text);
    assert!(with(1).after.loss() < with(1).before.loss());
}

/// The examples, and what PSDL_CORPUS names.
fn programs() -> Vec<PathBuf> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("examples")];
    folders.extend(std::env::var("PSDL_CORPUS").iter().flat_map(|paths| paths.split(':').map(PathBuf::from)));
    let entries = folders.iter().filter_map(|folder| std::fs::read_dir(folder).ok()).flatten().flatten();
    let mut programs: Vec<PathBuf> =
        entries.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|end| end == "psdl")).collect();
    programs.sort();
    programs
}

fn load(path: &Path) -> Option<Problem> {
    let text = std::fs::read_to_string(path).ok()?;
    let template = std::fs::read_to_string(path.with_extension("template.json")).ok();
    Problem::new(&Input { text: &text, template: template.as_deref() }, &Options::default()).ok()
}

/// Replays random values of every constant and runs the program with the same; answers how many replays held, and how many of those
/// were not the run to the bit.
fn compare(problem: &Problem, table: Table, rng: &mut ChaCha8Rng) -> (usize, usize) {
    let ran = problem.run(&Changes::default(), true).expect("the program as it is");
    let Some(slices) = Slices::of(&ran.trace) else { return (0, 0) };
    let mut replay = Replay::with_table(&ran.trace, table);
    let (mut held, mut wrong) = (0, 0);
    for slice in slices.literals().iter().filter(|slice| problem.is_free(ConstantId(slice.id))) {
        for value in [slice.value + rng.random_range(-0.5..0.5), slice.value * rng.random_range(-4.0..4.0)] {
            replay.set(&ran.trace, slice, value);
            if replay.holds(&ran.trace, slice) {
                let changes = Changes::default().with(Change::Constant(ConstantId(slice.id), value), problem.tuning());
                let same = problem.run(&changes, false).is_some_and(|fresh| {
                    fresh.layout.objects.iter().zip(&ran.layout.objects).all(|(fresh, recorded)| {
                        let center = |k: usize| replay.now(recorded.center[k].num).to_bits() == fresh.center[k].value().to_bits();
                        (0..3).all(center) && fresh.body.turn == recorded.body.turn && fresh.body.directed == recorded.body.directed
                    })
                });
                held += 1;
                wrong += usize::from(!same);
            }
            replay.undo();
        }
    }
    (held, wrong)
}

#[test]
fn a_replay_is_a_run_bit_for_bit() {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut held = 0;
    for path in programs() {
        let Some(problem) = load(&path) else { continue };
        let (more, wrong) = compare(&problem, apply, &mut rng);
        assert_eq!(wrong, 0, "{}", path.display());
        held += more;
    }
    assert!(held > 100, "only {held} replays held");
}

#[test]
fn a_wrong_replay_table_is_noticed() {
    let wrong: Table = |op, a, b| if op == Op::Sub { b - a } else { apply(op, a, b) };
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let noticed = programs().iter().filter_map(|path| load(path)).map(|problem| compare(&problem, wrong, &mut rng).1).sum::<usize>();
    assert!(noticed > 0);
}

#[test]
fn no_fix_leaves_more_errors_or_other_objects() {
    for path in programs() {
        let Some(problem) = load(&path) else { continue };
        let fix = fix(&problem, &Settings { budget: 3000, ..Settings::default() });
        assert!(fix.errors_after() <= fix.errors_before(), "{}", path.display());
        let (layout, verdict) = problem.judge_text(&fix.text).expect("the same scene");
        assert_eq!((verdict, layout.objects.len()), (fix.after, problem.layout().objects.len()), "{}", path.display());
    }
}
