//! What stands over the program and over its functions: counts, and the button that corrects.

use super::program::View;
use super::values::Values;
use super::words;
use ruff_text_size::{TextRange, TextSize};

/// What a lens does when it is clicked.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LensKind {
    /// Nothing: it tells.
    Tell,
    /// It corrects the whole program.
    FixAll,
}

/// A lens.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Lens {
    /// What it stands over.
    pub range: TextRange,
    /// What it says.
    pub title: String,
    /// What it does.
    pub kind: LensKind,
}

/// The lenses of a program.
pub fn lenses(view: &View) -> Vec<Lens> {
    let Some(scene) = view.scene else { return Vec::new() };
    let errors = scene.verdict.counted().count();
    let (objects, stale) = (scene.layout.objects.len(), if view.is_stale() { " (of the last run)" } else { "" });
    let top = TextRange::empty(TextSize::new(0));
    let title = format!("{} · {}{stale}", words::counted(objects, "object"), words::counted(errors, "error"));
    let mut lenses = vec![Lens { range: top, title, kind: LensKind::Tell }];
    if errors > 0 && !view.is_stale() {
        lenses.push(Lens { range: top, title: "Fix all".into(), kind: LensKind::FixAll });
    }
    let values = Values::new(*view);
    for def in &values.functions {
        let (objects, calls) = values.done_in(def);
        if !objects.is_empty() {
            let counts = [words::counted(calls, "call"), words::counted(objects.len(), "object")];
            let errors = words::counted(scene.errors_among(&objects), "error");
            lenses.push(Lens { range: def.name.range, title: format!("{} · {errors}", counts.join(" · ")), kind: LensKind::Tell });
        }
    }
    lenses
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    #[test]
    fn counts_and_a_button() {
        let text = "a = [Object('A', 1, 1, 1) for _ in range(2)]\ndef put(o):\n    o.center.x = 0.5\n    o.center.y = 0.5\nfor o in a:\n    put(o)\n";
        let fixture = Fixture::new(text);
        let titles: Vec<String> = lenses(&fixture.view()).into_iter().map(|lens| lens.title).collect();
        assert_eq!(titles, ["2 objects · 1 error", "Fix all", "1 call · 2 objects · 1 error"]);
        let fixture = Fixture::stale(text, "a = (\n");
        let titles: Vec<String> = lenses(&fixture.view()).into_iter().map(|lens| lens.title).collect();
        assert_eq!(titles, ["2 objects · 1 error (of the last run)"]);
    }
}
