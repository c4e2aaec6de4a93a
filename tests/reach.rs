//! Moving and turning objects by hand, on the examples and the programs of the folder `PSDL_CORPUS` where there is one: a fresh run puts
//! the object where the answer says.

use psdl::analysis::{Input, Options, analyse};
use psdl::check::{Violation, check};
use psdl::repair::{Change, Changes, NEAR, Names, Problem, move_to, tunables, turn_to};
use psdl::scene::Cardinal;
use psdl::syntax::Edit;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Programs may recurse as deep as the limits let them.
const STACK: usize = 64 << 20;

/// Does something with each program, on a thread with a stack as large as programs may need.
fn with_programs(work: impl Fn(&str, Input, &Problem) + Send + Copy + 'static) {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let folders = [Some(own), std::env::var_os("PSDL_CORPUS").map(PathBuf::from)];
    let entries = folders.into_iter().flatten().flat_map(|folder| std::fs::read_dir(folder).expect("the folder can be listed"));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "psdl"));
    paths.sort();
    for path in paths {
        let run = move || {
            let text = std::fs::read_to_string(&path).expect("the program can be read");
            let template = std::fs::read_to_string(path.with_extension("template.json")).ok();
            let input = Input { text: &text, template: template.as_deref() };
            if let Ok(problem) = Problem::new(&input, &Options::default()) {
                work(&path.display().to_string(), input, &problem);
            }
        };
        std::thread::Builder::new().stack_size(STACK).spawn(run).expect("a thread").join().expect("no panic");
    }
}

fn edited(text: &str, edits: &[Edit]) -> String {
    let mut text = text.to_string();
    for (range, new) in edits.iter().rev() {
        text.replace_range(range.start().to_usize()..range.end().to_usize(), new);
    }
    text
}

#[test]
fn a_fresh_run_puts_an_object_where_the_answer_says() {
    with_programs(|name, input, problem| {
        let names = Names::of(problem.parsed());
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let objects = problem.layout().objects.len();
        for _ in 0..3.min(objects) {
            let object = rng.random_range(0..objects);
            let from = problem.layout().objects[object].body.center;
            let mut to = [0, 1].map(|k| rng.random::<bool>().then(|| from[k] + rng.random_range(-1.5..1.5))).to_vec();
            to.push(None);
            let to: [Option<f64>; 3] = [to[0], to[1], to[2]];
            let mut nearest: f64 = 0.0;
            for choice in move_to(problem, &names, object, to, None) {
                let text = edited(input.text, &choice.edits);
                let after = analyse(&Input { text: &text, ..input }, &Options::default(), None);
                let body = after.layout.as_ref().expect("a layout").objects[object].body;
                assert_eq!(body.center, choice.reached, "{name}: {}", choice.title);
                assert_eq!(after.verdict.counted().count(), choice.errors, "{name}: {}", choice.title);
                let there = (0..3).all(|k| to[k].is_none_or(|wanted| (body.center[k] - wanted).abs() <= NEAR));
                assert_eq!(there, choice.exact, "{name}: {}", choice.title);
                let target = [0, 1, 2].map(|k| to[k].unwrap_or(from[k]));
                let distance = (0..3).map(|k| (body.center[k] - target[k]).powi(2)).sum::<f64>().sqrt();
                let far = if distance > 2.0 * NEAR { distance } else { 0.0 };
                assert!(far >= nearest - 1e-9, "{name}: {} comes nearer than what is told before it", choice.title);
                nearest = far;
            }
        }
    });
}

#[test]
fn a_fresh_run_turns_an_object_as_the_answer_says() {
    with_programs(|name, input, problem| {
        let names = Names::of(problem.parsed());
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let objects = problem.layout().objects.len();
        for _ in 0..2.min(objects) {
            let object = rng.random_range(0..objects);
            let facing = Cardinal::ALL[rng.random_range(0..4)];
            for choice in turn_to(problem, &names, object, facing, None) {
                let text = edited(input.text, &choice.edits);
                let after = analyse(&Input { text: &text, ..input }, &Options::default(), None);
                let turn = after.layout.as_ref().expect("a layout").objects[object].body.turn;
                assert_eq!((turn, choice.facing), (facing, facing), "{name}: {}", choice.title);
                assert_eq!(after.verdict.counted().count(), choice.errors, "{name}: {}", choice.title);
            }
        }
    });
}

#[test]
fn an_interval_of_a_constant_has_no_errors_of_its_objects() {
    static TRIED: AtomicUsize = AtomicUsize::new(0);
    static WRONG: AtomicUsize = AtomicUsize::new(0);
    with_programs(|name, _, problem| {
        let names = Names::of(problem.parsed());
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        for constant in tunables(problem, &names, None) {
            let value = problem.tuning().constant(constant.id).expect("it is there").value;
            let moved: Vec<usize> = constant.moves.iter().map(|(object, _)| *object).collect();
            let among = |error: &&Violation| error.objects().any(|object| moved.contains(&object));
            let now = problem.verdict().counted().filter(among).count();
            assert!(constant.errors >= now, "{name}: {constant:?}");
            let is_in = constant.good.iter().any(|(low, high)| low.is_none_or(|low| low <= value) && high.is_none_or(|high| value <= high));
            assert_eq!(is_in, constant.errors == 0, "{name}: {constant:?}");
            for (low, high) in constant.good.iter().take(1) {
                let (low, high) = (low.unwrap_or(value - 5.0), high.unwrap_or(value + 5.0));
                let at = if low < high { rng.random_range(low..high) } else { low };
                let changes = Changes::default().with(Change::Constant(constant.id, at), problem.tuning());
                let Some(ran) = problem.run(&changes, false) else { continue };
                TRIED.fetch_add(1, Ordering::Relaxed);
                let wrong = check(&ran.layout, &problem.options().rules).counted().any(|error| among(&error));
                WRONG.fetch_add(usize::from(wrong), Ordering::Relaxed);
            }
        }
    });
    // What lies between two values that were looked at can be missed.
    let (tried, wrong) = (TRIED.load(Ordering::Relaxed), WRONG.load(Ordering::Relaxed));
    assert!(tried > 0 && wrong * 50 <= tried, "{wrong} of {tried} values have errors");
}
