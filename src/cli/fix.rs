//! `psdl fix`: a few constants and directions rewritten, so that the layout errors vanish.

use super::Outcome;
use super::args::{ConfigOptions, code_parser};
use super::configuration::Configuration;
use super::files::{self, Loaded, Program};
use super::output::{self, Failure, counted};
use crate::analysis::{Input, Options};
use crate::check::ErrorKind;
use crate::check::finding::Code;
use crate::repair::{self, Effect, Fix, Method, Problem, Settings, Unfit};
use crate::report::{FileReport, Printer};
use crate::syntax::{Edit, LineIndex};
use clap::{ValueEnum, ValueHint};
use ruff_text_size::TextRange;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Lines of context around a change.
const CONTEXT: usize = 2;

/// `psdl fix`
#[derive(clap::Args, Debug)]
#[command(after_help = "Exit status: 0 if no errors are left, 1 if some are, 2 if the work could not be done.")]
pub struct FixArgs {
    /// Files and folders; `-` is standard input. Folders are searched for `.psdl` files, with the rules of .gitignore and .ignore.
    #[arg(required = true, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    paths: Vec<PathBuf>,

    /// Show what would change; this is the default.
    #[arg(long, conflicts_with_all = ["write", "stdout"])]
    diff: bool,

    /// Write the corrected programs to their files.
    #[arg(long, conflicts_with = "stdout")]
    write: bool,

    /// Print the corrected program.
    #[arg(long)]
    stdout: bool,

    /// What may be rewritten.
    #[arg(long, value_enum, default_value_t, value_name = "KIND")]
    edits: EditKind,

    /// How to look for a correction.
    #[arg(long, value_enum, default_value_t, value_name = "METHOD")]
    method: MethodName,

    /// The seed of what is random in a method.
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,

    /// Rewrite at most so many constants and directions.
    #[arg(long, default_value_t = Settings::default().max_edits, value_name = "N")]
    max_edits: usize,

    /// Try at most about so many layouts; a run of the program counts as twenty.
    #[arg(long, default_value_t = Settings::default().budget, value_name = "N")]
    budget: usize,

    /// Work on errors of these kinds only.
    #[arg(long, value_delimiter = ',', value_name = "KINDS", value_parser = code_parser())]
    only: Vec<Code>,

    /// Rewrite only what stands on these lines.
    #[arg(long, value_name = "A-B", value_parser = lines)]
    lines: Option<(u32, u32)>,

    /// The format of the report; with `json`, the edits are in it.
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT", conflicts_with = "stdout")]
    format: FixFormat,

    /// Take standard input for the file of this name: for its template, its configuration and the report.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    stdin_filename: Option<PathBuf>,

    #[command(flatten)]
    options: ConfigOptions,
}

/// What `psdl fix` rewrites.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
enum EditKind {
    /// Float constants and directions.
    #[default]
    Elementary,
}

/// The methods of `psdl fix`.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
enum MethodName {
    /// Exact proposals from a record of the run.
    #[default]
    Guided,
    /// The random search of the paper.
    Paper,
}

/// The formats of `psdl fix`.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
enum FixFormat {
    /// Diffs and a line a file.
    #[default]
    Text,
    /// One object with an entry a file.
    Json,
}

/// Reads `12-30` or `12`; lines count from 1.
fn lines(text: &str) -> Result<(u32, u32), String> {
    let (first, last) = text.split_once('-').unwrap_or((text, text));
    match (first.trim().parse(), last.trim().parse()) {
        (Ok(first), Ok(last)) if 1 <= first && first <= last => Ok((first, last)),
        _ => Err("a range of lines looks like 12-30".to_string()),
    }
}

pub(super) fn fix(args: &FixArgs, color: bool, error_color: bool) -> Result<Outcome, Failure> {
    let EditKind::Elementary = args.edits;
    let configuration = Configuration::new(&args.options, error_color);
    let programs = files::programs(&args.paths, args.stdin_filename.as_deref(), &|path| configuration.excludes(path))?;
    if args.stdout && programs.len() != 1 {
        return Err(Failure::new("--stdout takes one program"));
    }
    if args.write && programs.iter().any(|program| matches!(program, Program::Stdin(_))) {
        return Err(Failure::new("standard input cannot be written to; use --stdout"));
    }
    let (mut entries, mut outcome, mut failed) = (Vec::new(), Outcome::Clean, 0);
    for program in &programs {
        let loaded = program.load();
        let options = configuration.options(program.path())?;
        let done = correct(args, &loaded, &options, error_color);
        let done = done.and_then(|done| if args.write { write(program.path(), done) } else { Ok(done) });
        let done = match done {
            Ok(done) => done,
            Err(failure) => {
                // The other programs are corrected all the same.
                output::complain(&failure);
                entries.push(json!({ "path": loaded.path, "error": failure.to_string() }));
                failed += 1;
                continue;
            }
        };
        if done.fix.errors_after() > 0 || done.exceptions > 0 {
            outcome = Outcome::Findings;
        }
        if args.stdout {
            output::print(&done.fix.text)?;
        } else if args.format == FixFormat::Json {
            entries.push(done.json(&loaded.path, args.write));
        } else {
            output::print(&done.text_report(&loaded.path, args.write, color))?;
        }
    }
    if args.format == FixFormat::Json {
        output::print(&format!("{:#}\n", json!({ "version": 1, "files": entries })))?;
    }
    match failed {
        0 => Ok(outcome),
        _ => Err(Failure::new(format!("{} could not be corrected", counted(failed, "program")))),
    }
}

/// A program after its correction.
struct Done {
    before: String,
    fix: Fix,
    effects: Vec<Effect>,
    exceptions: usize,
    seconds: f64,
}

/// Corrects one program.
fn correct(args: &FixArgs, loaded: &Loaded, options: &Options, error_color: bool) -> Result<Done, Failure> {
    let (text, template) = loaded.texts()?;
    let start = Instant::now();
    let problem = match Problem::new(&Input { text, template: template.map(|(_, text)| text) }, options) {
        Ok(problem) => problem,
        Err(Unfit::Broken(findings)) => {
            let file = FileReport { path: &loaded.path, text, template, findings: &findings, objects: &[] };
            let report = Printer { color: error_color, ..Printer::default() }.file(&file);
            return Err(Failure::with_report(report, &format!("{}: what has errors cannot be run, nor corrected", loaded.path)));
        }
        Err(Unfit::Stopped(_)) => {
            let path = &loaded.path;
            return Err(Failure::new(format!("{path}: the program met a limit before it came to its end; nothing was corrected")));
        }
    };
    let method = if args.method == MethodName::Paper { Method::Paper } else { Method::Guided };
    let within = args.lines.map(|lines| range_of(text, lines));
    let (seed, max_edits, budget) = (args.seed, args.max_edits, args.budget);
    let fix = repair::fix(&problem, &Settings { method, seed, max_edits, budget, only: kinds(&args.only), within, watch: None });
    let seconds = start.elapsed().as_secs_f64();
    let effects = repair::effects(&problem, &fix);
    Ok(Done { before: text.to_string(), fix, effects, exceptions: problem.exceptions(), seconds })
}

fn kinds(codes: &[Code]) -> Vec<ErrorKind> {
    ErrorKind::ALL.into_iter().filter(|kind| codes.contains(&kind.code())).collect()
}

/// The bytes of some lines.
fn range_of(text: &str, (first, last): (u32, u32)) -> TextRange {
    let mut starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).skip(first as usize - 1);
    let start = starts.next().unwrap_or(text.len());
    let end = starts.nth((last - first) as usize).unwrap_or(text.len());
    let size = |at: usize| u32::try_from(at).unwrap_or(u32::MAX).into();
    TextRange::new(size(start), size(end))
}

/// Writes the corrected program over the one that was read, if that is still there.
fn write(path: &Path, done: Done) -> Result<Done, Failure> {
    if done.fix.edits.is_empty() {
        return Ok(done);
    }
    let now = std::fs::read(path).map_err(|error| Failure::at(path, &error))?;
    if now != done.before.as_bytes() {
        return Err(Failure::at(path, &"changed while it was being corrected; it was left alone"));
    }
    output::write_file(path, done.fix.text.as_bytes())?;
    Ok(done)
}

impl Done {
    fn text_report(&self, path: &str, written: bool, color: bool) -> String {
        let paint = |code: &str, text: &str| if color { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_string() };
        let path = annotate_snippets::normalize_untrusted_str(path);
        let mut out = String::new();
        if !written && !self.fix.edits.is_empty() {
            let _ = writeln!(out, "{}\n{}", paint("1", &format!("--- {path}")), paint("1", &format!("+++ {path}")));
            for line in diff(&self.before, &self.fix.edits) {
                let shown = annotate_snippets::normalize_untrusted_str(&line);
                let code = match line.as_bytes().first() {
                    Some(b'-') => "31",
                    Some(b'+') => "32",
                    Some(b'@') => "36",
                    _ => "0",
                };
                let _ = writeln!(out, "{}", if code == "0" { shown } else { paint(code, &shown) });
            }
        }
        let index = LineIndex::new(&self.before);
        for ((range, new), effect) in self.fix.edits.iter().zip(&self.effects) {
            let line = index.line(range.start()) + 1;
            let old = self.before.get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default();
            let old = annotate_snippets::normalize_untrusted_str(&old.split_whitespace().collect::<Vec<_>>().join(" "));
            let (new, clears, moves) = (new.trim(), counted(effect.clears, "error"), counted(effect.moves, "object"));
            let _ = writeln!(out, "{path}:{line}: {old} → {new} clears {clears} and moves {moves}");
        }
        let (before, after) = (self.fix.errors_before(), self.fix.errors_after());
        let _ = writeln!(out, "{path}: {} before, {after} after {}", counted(before, "error"), counted(self.fix.edits.len(), "edit"));
        if self.exceptions > 0 {
            let _ = writeln!(out, "{path}: {} raised; only what ran was corrected", counted(self.exceptions, "statement"));
        }
        out
    }

    fn json(&self, path: &str, written: bool) -> Value {
        let (fix, effort) = (&self.fix, &self.fix.effort);
        let index = LineIndex::new(&self.before);
        let edit = |((range, new), effect): (&Edit, &Effect)| {
            let old = self.before.get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default();
            json!({
                "start": range.start().to_u32(), "end": range.end().to_u32(), "line": index.line(range.start()) + 1,
                "old": old, "new": new, "clears": effect.clears, "moves": effect.moves,
            })
        };
        json!({
            "path": path,
            "edits": fix.edits.iter().zip(&self.effects).map(edit).collect::<Vec<_>>(),
            "errors": { "before": fix.errors_before(), "after": fix.errors_after() },
            "loss": { "before": fix.before.loss(), "after": fix.after.loss() },
            "objects_moved": fix.moved, "displacement": fix.displacement, "transport": fix.transport,
            "evaluations": effort.evaluations, "replays": effort.replays, "runs": effort.runs,
            "seconds": self.seconds, "exceptions": self.exceptions, "written": written && !fix.edits.is_empty(),
        })
    }
}

/// The lines of a unified diff, without its head.
fn diff(text: &str, edits: &[Edit]) -> Vec<String> {
    let old: Vec<&str> = text.split_inclusive('\n').collect();
    let starts: Vec<usize> = old.iter().scan(0, |at, line| Some(std::mem::replace(at, *at + line.len()))).collect();
    let line_of = |at: usize| starts.partition_point(|start| *start <= at).saturating_sub(1);
    let mut hunks: Vec<(usize, usize, Vec<&Edit>)> = Vec::new();
    for edit in edits {
        let (first, last) = (line_of(edit.0.start().to_usize()), line_of(edit.0.end().to_usize().saturating_sub(1)));
        match hunks.last_mut() {
            Some((_, end, inside)) if first <= *end + 2 * CONTEXT => {
                *end = last.max(*end);
                inside.push(edit);
            }
            _ => hunks.push((first, last, vec![edit])),
        }
    }
    let (mut out, mut shift) = (Vec::new(), 0_isize);
    let shown = |prefix: char, line: &str| format!("{prefix}{}", line.trim_end_matches(['\n', '\r']));
    for (first, last, edits) in hunks {
        let changed = replaced(text, starts[first], starts.get(last + 1).copied().unwrap_or(text.len()), &edits);
        let new: Vec<&str> = changed.split_inclusive('\n').collect();
        let (from, to) = (first.saturating_sub(CONTEXT), (last + 1 + CONTEXT).min(old.len()));
        let context = (first - from) + (to - last - 1);
        let (olds, news) = (last + 1 - first + context, new.len() + context);
        out.push(format!("@@ -{},{olds} +{},{news} @@", from + 1, (from + 1).saturating_add_signed(shift)));
        out.extend(old[from..first].iter().map(|line| shown(' ', line)));
        if new.len() == last + 1 - first {
            // The same number of lines: those that stay are context.
            let mut gone = Vec::new();
            let mut come = Vec::new();
            for (before, after) in old[first..=last].iter().zip(&new) {
                if before == after {
                    out.append(&mut gone);
                    out.append(&mut come);
                    out.push(shown(' ', before));
                } else {
                    gone.push(shown('-', before));
                    come.push(shown('+', after));
                }
            }
            out.append(&mut gone);
            out.append(&mut come);
        } else {
            out.extend(old[first..=last].iter().map(|line| shown('-', line)));
            out.extend(new.iter().map(|line| shown('+', line)));
        }
        out.extend(old[last + 1..to].iter().map(|line| shown(' ', line)));
        shift += news as isize - olds as isize;
    }
    out
}

/// A part of a text after the edits in it.
fn replaced(text: &str, from: usize, to: usize, edits: &[&Edit]) -> String {
    let (mut out, mut at) = (String::new(), from);
    for (range, new) in edits {
        out.push_str(text.get(at..range.start().to_usize()).unwrap_or_default());
        out.push_str(new);
        at = range.end().to_usize();
    }
    out.push_str(text.get(at..to).unwrap_or_default());
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edit(text: &str, old: &str, new: &str) -> Edit {
        let start = text.find(old).expect("the text to replace");
        let size = |at: usize| u32::try_from(at).expect("a short text").into();
        (TextRange::new(size(start), size(start + old.len())), new.to_string())
    }

    #[test]
    fn a_diff_shows_changed_lines_between_two_of_context() {
        let text = "a\nb\nc\nx = 0.5\r\nd\ne\nf\ng\nh\ny = 1.5";
        let edits = [edit(text, "0.5", "0.25"), edit(text, "1.5", "2.0")];
        let expected = "@@ -2,5 +2,5 @@| b| c|-x = 0.5|+x = 0.25| d| e|@@ -8,3 +8,3 @@| g| h|-y = 1.5|+y = 2.0";
        assert_eq!(diff(text, &edits).join("|"), expected);
    }

    const OUTSIDE: &str = "table = Object('Table', 1.0, 1.0, 1.0)\ntable.max.x = scene.max.x + 0.5\ntable.center.y = 0.0\n";

    fn corrected() -> Done {
        let problem = Problem::new(&Input { text: OUTSIDE, template: None }, &Options::default()).expect("it runs");
        let fix = repair::fix(&problem, &Settings::default());
        let effects = repair::effects(&problem, &fix);
        Done { before: OUTSIDE.to_string(), fix, effects, exceptions: 0, seconds: 0.0 }
    }

    #[test]
    fn a_program_that_changed_meanwhile_is_left_alone() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.psdl");
        let newer = format!("{OUTSIDE}# one more line\n");
        std::fs::write(&path, &newer).expect("own file");
        let failure = write(&path, corrected()).map(|_| ()).expect_err("it changed");
        assert!(format!("{failure:?}").contains("changed while it was being corrected"), "{failure:?}");
        assert_eq!(std::fs::read_to_string(&path).expect("a text"), newer);

        std::fs::write(&path, OUTSIDE).expect("own file");
        assert!(write(&path, corrected()).is_ok());
        assert_eq!(std::fs::read_to_string(&path).expect("a text"), OUTSIDE.replace("0.5", "0.0"));
    }

    #[test]
    fn a_diff_is_red_and_green_where_colours_are_asked_for() {
        let report = corrected().text_report("a.psdl", false, true);
        assert!(report.contains("\u{1b}[31m-table.max.x = scene.max.x + 0.5\u{1b}[0m\n"), "{report:?}");
        assert!(report.contains("\u{1b}[32m+table.max.x = scene.max.x + 0.0\u{1b}[0m\n"), "{report:?}");
        assert!(!corrected().text_report("a.psdl", false, false).contains('\u{1b}'));
    }

    #[test]
    fn lines_are_counted_from_one_and_both_ends_belong() {
        assert_eq!(lines("2-3"), Ok((2, 3)));
        assert!(["0", "3-2", "a", "-"].iter().all(|text| lines(text).is_err()));
        let text = "a\nbb\nc\n";
        assert_eq!(&text[range_of(text, (2, 3))], "bb\nc\n");
        assert_eq!(&text[range_of(text, (9, 9))], "");
    }
}
