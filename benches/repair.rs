//! Error correction over the examples, or over the programs below the folders that PSDL_CORPUS names: one row a program, then the
//! means, for each method, and what a candidate of the replay costs. `PSDL_METHODS=guided` leaves the other out; `PSDL_LAYOUTS=DIR` writes the layouts before and after.

use std::path::{Path, PathBuf};
use std::time::Instant;

use psdl::analysis::{Input, Options};
use psdl::repair::{Change, Fix, Method, Neighbourhood, Problem, Settings, fix};
use psdl::scene::layout_json;
use psdl::syntax::ConstantId;

/// One program corrected.
struct Row {
    name: String,
    objects: usize,
    fix: Fix,
    seconds: f64,
    /// Of each candidate of a replay, in microseconds.
    candidates: Vec<f64>,
}

fn programs() -> Vec<PathBuf> {
    let folders = std::env::var("PSDL_CORPUS").unwrap_or_else(|_| concat!(env!("CARGO_MANIFEST_DIR"), "/examples").to_string());
    let listed = folders.split(':').filter_map(|folder| std::fs::read_dir(folder).ok()).flatten().flatten().map(|entry| entry.path());
    let mut programs: Vec<PathBuf> = listed.filter(|path| path.extension().is_some_and(|end| end == "psdl")).collect();
    programs.sort();
    programs
}

fn correct(path: &Path, settings: &Settings) -> Option<Row> {
    let text = std::fs::read_to_string(path).ok()?;
    let template = std::fs::read_to_string(path.with_extension("template.json")).ok();
    let input = Input { text: &text, template: template.as_deref() };
    let start = Instant::now();
    let problem = Problem::new(&input, &Options::default()).ok()?;
    let fix = fix(&problem, settings);
    let seconds = start.elapsed().as_secs_f64();
    let name = path.file_stem()?.to_string_lossy().into_owned();
    if let (Ok(folder), Some((after, _))) = (std::env::var("PSDL_LAYOUTS"), problem.judge_text(&fix.text)) {
        for (layout, end) in [(problem.layout(), "before"), (&after, "after")] {
            let json = layout_json(layout, &[], &|offset| offset.to_usize());
            std::fs::write(Path::new(&folder).join(format!("{name}.{end}.json")), json).ok()?;
        }
    }
    let candidates = candidates(&problem).unwrap_or_default();
    Some(Row { name, objects: problem.layout().objects.len(), fix, seconds, candidates })
}

/// What it takes to look at one other value of each constant, where the replay holds. Microseconds.
fn candidates(problem: &Problem) -> Option<Vec<f64>> {
    const TIMES: u32 = 50;
    let mut neighbourhood = Neighbourhood::of(problem);
    let mut found = Vec::new();
    for (at, constant) in problem.tuning().constants.iter().enumerate() {
        let id = ConstantId(u32::try_from(at).ok()?);
        let change = |time: u32| Change::Constant(id, constant.value + 0.01 * f64::from(time + 1));
        if !problem.is_free(id) || neighbourhood.score(change(0)).is_none() {
            continue;
        }
        let start = Instant::now();
        for time in 0..TIMES {
            std::hint::black_box(neighbourhood.score(change(time)));
        }
        found.push(start.elapsed().as_secs_f64() * 1e6 / f64::from(TIMES));
    }
    Some(found)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

fn table(title: &str, rows: &[Row]) -> String {
    let mut out = format!("\n{title}\n{:<34} before after edits moved   way/m  seconds evaluations replays runs   replay/us\n", "program");
    let share = |row: &Row| row.fix.moved as f64 / row.objects.max(1) as f64;
    for row in rows {
        let (fix, effort) = (&row.fix, &row.fix.effort);
        out += &format!(
            "{:<34} {:>6} {:>5} {:>5} {:>4.0}% {:>7.3} {:>8.4} {:>11} {:>7} {:>4} {:>11.2}\n",
            row.name,
            fix.errors_before(),
            fix.errors_after(),
            fix.edits.len(),
            100.0 * share(row),
            fix.displacement,
            row.seconds,
            effort.evaluations,
            effort.replays,
            effort.runs,
            median(row.candidates.clone())
        );
    }
    let n = rows.len().max(1) as f64;
    let mean = |of: &dyn Fn(&Row) -> f64| rows.iter().map(of).sum::<f64>() / n;
    let clean = rows.iter().filter(|row| row.fix.errors_after() == 0).count();
    out += &format!(
        "mean of {}: errors {:.2} -> {:.2}, clean {clean}, edits {:.2}, moved {:.1}%, way median {:.3} mean {:.3} m, \
         seconds mean {:.4} largest {:.4}, evaluations {:.0}, replays {:.0}, runs {:.0}, a candidate of the replay: median {:.2} us\n",
        rows.len(),
        mean(&|row| row.fix.errors_before() as f64),
        mean(&|row| row.fix.errors_after() as f64),
        mean(&|row| row.fix.edits.len() as f64),
        100.0 * mean(&share),
        median(rows.iter().map(|row| row.fix.displacement).collect()),
        mean(&|row| row.fix.displacement),
        mean(&|row| row.seconds),
        rows.iter().map(|row| row.seconds).fold(0.0, f64::max),
        mean(&|row| row.fix.effort.evaluations as f64),
        mean(&|row| row.fix.effort.replays as f64),
        mean(&|row| row.fix.effort.runs as f64),
        median(rows.iter().flat_map(|row| row.candidates.iter().copied()).collect())
    );
    out
}

#[allow(clippy::print_stdout)]
fn main() {
    let methods = std::env::var("PSDL_METHODS").unwrap_or_else(|_| "guided,paper".to_string());
    for method in methods.split(',') {
        let (method, seeds) = if method == "paper" { (Method::Paper, 5) } else { (Method::Guided, 1) };
        for seed in 0..seeds {
            let settings = Settings { method, seed, ..Settings::default() };
            let rows: Vec<Row> = programs().iter().filter_map(|path| correct(path, &settings)).collect();
            println!("{}", table(&format!("{method:?}, seed {seed}"), &rows));
        }
    }
}
