//! `psdl render --animate`: the correction of a program as a film.

use super::output::{self, Failure};
use crate::analysis::{Input, Options};
use crate::check::{Rules, check};
use crate::render;
use crate::render::film::{Edit, Step, frames};
use crate::render::reel::{Format, Reel};
use crate::repair::{self, Change, Changes, Problem, Settings, Unfit};
use crate::scene::Layout;
use std::path::Path;

/// Pixels of a frame: hundreds of them are kept until the film is written.
const MOST_PIXELS: u32 = 1_600_000;

/// Corrects a program and films it.
pub(super) fn film(path: &Path, input: &Input, options: &Options, picture: &render::Options) -> Result<(), Failure> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    let format = match ending.as_deref() {
        Some("gif") => Format::Gif,
        Some("apng" | "png") => Format::Apng,
        Some("webp") => Format::Webp,
        _ => return Err(Failure::at(path, &"a film ends in .gif, .apng, .png or .webp")),
    };
    if picture.size.0 * picture.size.1 > MOST_PIXELS {
        return Err(Failure::new(format!("a film has at most {MOST_PIXELS} pixels: say --size 1200x750, for example")));
    }
    let problem = Problem::new(input, options).map_err(|unfit| match unfit {
        Unfit::Broken(_) => Failure::new("the program has errors, so that it cannot be corrected"),
        Unfit::Stopped(_) => Failure::new("the program met a limit before it came to its end; there is nothing to film"),
    })?;
    let fix = repair::fix(&problem, &Settings::default());
    let steps = steps(&problem, &fix.changes, &options.rules);
    let mut reel = Reel::default();
    for frame in frames(&steps, &options.rules, picture) {
        reel.add(frame.drawing.to_pixels(), frame.millis);
    }
    let bytes = reel.encode(format).map_err(|error| Failure::at(path, &error))?;
    output::write_file(path, &bytes)
}

/// The way from a program to its correction: always the edit next that leaves the least loss.
fn steps(problem: &Problem, goal: &Changes, rules: &Rules) -> Vec<Step> {
    let mut done = Changes::default();
    let mut left: Vec<Change> = goal.iter().collect();
    let mut steps = vec![Step { layout: problem.layout().clone(), verdict: problem.verdict().clone(), edit: None }];
    let mut text = problem.text().to_string();
    while !left.is_empty() {
        let tries = left.iter().enumerate().filter_map(|(at, change)| {
            let layout: Layout = problem.run(&done.with(*change, problem.tuning()), false)?.layout;
            let verdict = check(&layout, rules);
            Some((verdict.loss(), at, layout, verdict))
        });
        // Where no edit that is left can be made by itself, the film ends.
        let Some((_, at, layout, verdict)) = tries.min_by_key(|(loss, at, ..)| (*loss, *at)) else { break };
        let change = left.remove(at);
        done = done.with(change, problem.tuning());
        let Some((new, _)) = problem.rewrite(&done) else { break };
        steps.push(Step { layout, verdict, edit: edited(&text, &new) });
        text = new;
    }
    steps
}

/// The first line that differs.
fn edited(old: &str, new: &str) -> Option<Edit> {
    let mut lines = old.lines().zip(new.lines()).enumerate();
    lines.find(|(_, (old, new))| old != new).map(|(at, (old, new))| Edit { line: at + 1, old: old.to_string(), new: new.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_film_goes_from_the_program_to_its_correction() {
        let text = "set_size(6, 6, 3)\na = Object(\"Table\", 1.0, 1.0, 1.0)\nb = Object(\"Chair\", 0.5, 0.5, 1.0)\n\
                    a.center.x = 0.5\na.center.y = 0.0\nb.center.x = 0.4\nb.center.y = 0.1\n";
        let problem = Problem::new(&Input { text, template: None }, &Options::default()).expect("a program");
        let fix = repair::fix(&problem, &Settings::default());
        let steps = steps(&problem, &fix.changes, &problem.options().rules);
        assert_eq!(steps.len(), fix.edits.len() + 1);
        assert!(steps[0].edit.is_none() && steps[0].verdict.loss() > 0);
        let last = steps.last().expect("a step");
        assert_eq!(last.verdict.loss(), fix.after.loss());
        let edit = last.edit.as_ref().expect("an edit");
        assert_eq!(text.lines().nth(edit.line - 1), Some(edit.old.as_str()));
        assert_ne!(edit.old, edit.new);
    }
}
