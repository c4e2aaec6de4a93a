//! Error correction: what it rewrites in small scenes, and that a replay is a run.

use std::path::{Path, PathBuf};

use psdl::analysis::{Input, Options};
use psdl::check::ErrorKind;
use psdl::repair::{Change, Changes, Fix, Method, Problem, Settings, fix};
use psdl::scene::{Layout, Outcome, Told};
use psdl::syntax::tune::Cardinal;
use psdl::syntax::{ConstantId, DirectionId};
use psdl::trace::{Op, Replay, SITE, Slices, Table, apply};
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
    for slice in slices.literals() {
        let changes: Vec<Change> = if slice.id < SITE {
            let values = [slice.value + rng.random_range(-0.5..0.5), slice.value * rng.random_range(-4.0..4.0)];
            values.map(|value| Change::Constant(ConstantId(slice.id), value)).to_vec()
        } else {
            Cardinal::ALL.map(|cardinal| Change::Turn(DirectionId(slice.id - SITE), cardinal)).to_vec()
        };
        for change in changes {
            let value = match change {
                Change::Constant(id, _) if !problem.is_free(id) => continue,
                Change::Constant(_, value) => value,
                Change::Turn(_, cardinal) => f64::from(cardinal as u8),
            };
            replay.set(&ran.trace, slice, value);
            if replay.holds(&ran.trace, slice) {
                let fresh = problem.run(&Changes::default().with(change, problem.tuning()), false);
                held += 1;
                wrong += usize::from(!fresh.is_some_and(|fresh| is_same(&replay, &ran.layout, &fresh.layout)));
            }
            replay.undo();
        }
    }
    (held, wrong)
}

/// Whether the numbers of a replay are the layout of a fresh run, bit for bit.
fn is_same(replay: &Replay, recorded: &Layout, fresh: &Layout) -> bool {
    recorded.objects.iter().zip(&fresh.objects).all(|(recorded, fresh)| {
        let center = |k: usize| replay.now(recorded.center[k].num).to_bits() == fresh.center[k].value().to_bits();
        let outcome = Outcome::from_code(replay.now(recorded.settled));
        let told = if replay.now(recorded.instead) >= 0.0 { Told::Direction } else { recorded.body.told };
        (0..3).all(center) && (fresh.body.turn, fresh.body.directed, fresh.body.told) == (outcome.turn, outcome.directed, told)
    })
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

/// A program of a few objects, with much of what decisions of a program can rest on: comparisons, `min` and `max`, rounding, counts,
/// facings of every kind, frames, dictionaries and loops.
fn generated(rng: &mut ChaCha8Rng) -> String {
    let count = rng.random_range(3..8);
    let mut text = format!(
        "things = [Object('Thing', 0.5 + 0.3 * (i % 3), 0.4 + 0.2 * (i % 4), 0.6, STANDING) for i in range({count})]\n\
         def beside(a, b, gap=0.25):\n    a.min.x = b.max.x + gap\n    a.center.y = b.center.y\n\
         things[0].center.x = {:.2}\nthings[0].max.y = scene.max.y - {:.2}\n",
        rng.random_range(-2.0..2.0),
        rng.random_range(0.0..1.0)
    );
    for at in 1..count {
        let (a, b) = (format!("things[{at}]"), format!("things[{}]", rng.random_range(0..at)));
        let (x, y) = (rng.random_range(-2.0..2.0), rng.random_range(0.05..1.5));
        text += &match rng.random_range(0..12) {
            0 => format!("beside({a}, {b}, {y:.2})\n"),
            1 => format!("{a}.center.x = max({b}.center.x + {x:.2}, scene.min.x + {y:.2})\n{a}.center.y = min({x:.2}, {b}.min.y)\n"),
            2 => format!("{a}.center.x = {x:.2} if {b}.center.x > {y:.2} else -{y:.2}\n{a}.center.y = abs({x:.2}) - {y:.2}\n"),
            3 => format!("{a}.center.x = round({x:.2} * 3) / 2\n{a}.center.y = int({y:.2} * 4) * 0.3\n"),
            4 => format!("set_coordinate_frame({b})\n{a}.min.y = {b}.max.y + {y:.2}\n{a}.center.x = {x:.2}\nset_coordinate_frame(scene)\n"),
            5 => format!("{a}.center.x = math.sin({x:.2}) * 2\n{a}.center.y = {x:.2} // 0.7 + {y:.2} % 0.4\n"),
            6 => format!("{a}.center.x = {{0: {x:.2}, 1: {y:.2}}}.get({b}.facing, 0.5)\n{a}.center.y = {y:.2}\n"),
            7 => format!(
                "for k in range(int({y:.2} * 3)):\n    {a}.center.x = {x:.2} + k * {y:.2}\n{a}.center.y = sorted([{x:.2}, {y:.2}, 0.4])[1]\n"
            ),
            8 => format!("{a}.center = {b}.center + Vec({x:.2}, {y:.2}, 0.0)\n"),
            9 => format!("{a}.max.x = float(f'{{{x:.2} * 2:.1f}}')\n{a}.min.y = sum([{y:.2}, 0.25]) / 2\n"),
            10 => format!("{a}.center.x = {x:.2} ** 2 - {y:.2}\n{a}.max.y = {b}.min.y - {y:.2}\n"),
            _ => format!("{a}.max.x = scene.max.x\n{a}.center.y = {x:.2}\n"),
        };
        text += &match rng.random_range(0..9) {
            0 => format!("{a}.facing = {b}\n"),
            1 => format!("{a}.facing = {}\n", ["X_MAX", "Y_MAX", "X_MIN", "Y_MIN"][rng.random_range(0..4)]),
            2 => format!("{a}.facing = opposite({b}.facing)\n"),
            3 => format!("{a}.facing = {b}.center\n"),
            4 => format!("{a}.facing = X_MIN if {b}.facing == Y_MAX else 3\n"),
            5 => format!("{a}.facing = ({x:.2}, {y:.2})\n"),
            6 => format!("{b}.facing = {a}\n{a}.facing = {b}\n"),
            7 => format!("{a}.facing = scene\n"),
            _ => String::new(),
        };
    }
    text
}

#[test]
fn replays_of_generated_programs_are_runs_too() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let (mut held, mut noticed) = (0, 0);
    for _ in 0..150 {
        let text = generated(&mut rng);
        let problem = problem(&text);
        let (more, wrong) = compare(&problem, apply, &mut rng);
        assert_eq!(wrong, 0, "{text}");
        held += more;
        noticed += compare(&problem, |op, a, b| if op == Op::Max { b } else { apply(op, a, b) }, &mut rng).1;
    }
    assert!(held > 2000, "only {held} replays held");
    assert!(noticed > 0, "a max that is no max was not noticed");
}

#[test]
fn fixes_of_generated_programs_never_make_them_worse() {
    let mut rng = ChaCha8Rng::seed_from_u64(12);
    let (mut clean, mut constants, mut long) = (0, 0, 0);
    for _ in 0..40 {
        let text = generated(&mut rng);
        let problem = problem(&text);
        for method in [Method::Guided, Method::Paper] {
            let fix = fix(&problem, &Settings { method, budget: 3000, ..Settings::default() });
            assert!(fix.errors_after() <= fix.errors_before() && fix.after.loss() <= fix.before.loss(), "{text}\n{}", fix.text);
            let again = Problem::new(&Input { text: &fix.text, template: None }, &Options::default()).expect("the same scene");
            assert!(again.exceptions() <= problem.exceptions(), "{}", fix.text);
            assert_eq!(again.layout().objects.len(), problem.layout().objects.len());
            clean += usize::from(fix.errors_after() == 0 && fix.errors_before() > 0);
            // However little there is to spend, numbers are such as people write.
            let hasty = psdl::repair::fix(&problem, &Settings { method, budget: 150, ..Settings::default() });
            for (_, text) in fix.edits.iter().chain(&hasty.edits) {
                constants += 1;
                long += usize::from(text.len() > 8);
            }
        }
    }
    assert!(clean > 20, "only {clean} fixes left no error");
    assert!(constants > 40 && long * 4 <= constants, "{long} of {constants} new constants are long");
}

/// How fast centers move with a literal: the replay beside two runs of the program.
#[test]
fn slopes_of_a_replay_are_those_of_runs() {
    let mut compared = 0;
    for path in programs() {
        let Some(problem) = load(&path) else { continue };
        let ran = problem.run(&Changes::default(), true).expect("the program as it is");
        let Some(slices) = Slices::of(&ran.trace) else { continue };
        let mut replay = Replay::new(&ran.trace);
        for slice in slices.literals().iter().filter(|slice| problem.is_free(ConstantId(slice.id))).take(8) {
            let step = 1e-6;
            let run = |value| problem.run(&Changes::default().with(Change::Constant(ConstantId(slice.id), value), problem.tuning()), false);
            let (Some(low), Some(high)) = (run(slice.value - step), run(slice.value + step)) else { continue };
            replay.set(&ran.trace, slice, slice.value + 1.0 / 1024.0);
            if replay.holds(&ran.trace, slice) {
                for ((object, low), high) in ran.layout.objects.iter().zip(&low.layout.objects).zip(&high.layout.objects) {
                    for k in 0..3 {
                        let slope = (replay.now(object.center[k].num) - object.body.center[k]) * 1024.0;
                        let difference = (high.body.center[k] - low.body.center[k]) / (2.0 * step);
                        // A literal inside of a sine or a square bends by its second derivative times the step.
                        assert!((slope - difference).abs() < 0.05 + 0.05 * difference.abs(), "{}: {slope} {difference}", path.display());
                        compared += 1;
                    }
                }
            }
            replay.undo();
        }
    }
    assert!(compared > 100, "only {compared} slopes were compared");
}
