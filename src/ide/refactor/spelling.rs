//! Directions in another spelling.

use super::{Ground, Refactoring, RefactoringKind};
use crate::syntax::Edit;
use crate::syntax::tune::{Direction, DirectionKind, Spelling};
use ruff_text_size::TextRange;

/// The spellings that are offered, the best first.
const OFFERED: [Spelling; 3] = [Spelling::Max, Spelling::Pos, Spelling::Number];

/// The direction at a place in other spellings, and all directions like the best of them.
pub(super) fn directions(ground: &Ground, range: TextRange) -> Vec<Refactoring> {
    let all = &ground.problem.tuning().directions;
    let edit = |direction: &Direction, spelling: Spelling| -> Option<Edit> {
        let DirectionKind::Literal(cardinal) = direction.kind else { return None };
        let new = spelling.spell(cardinal);
        let blank = if direction.glued { " " } else { "" };
        (ground.slice(direction.range) != new).then(|| (direction.range, format!("{new}{blank}")))
    };
    let chosen = all.iter().filter(|direction| matches!(direction.kind, DirectionKind::Literal(_)));
    let Some(chosen) = chosen.into_iter().find(|direction| direction.range.contains_range(range)) else { return Vec::new() };
    let rewriting = |title: String, edits: Vec<Edit>| Refactoring { title, kind: RefactoringKind::Direction, edits, sidecar: None };
    let one = |spelling: Spelling| {
        let edit = edit(chosen, spelling)?;
        Some(rewriting(format!("Write {} for {}", edit.1.trim(), ground.slice(chosen.range)), vec![edit]))
    };
    let mut found: Vec<Refactoring> = OFFERED.into_iter().filter_map(one).collect();
    let best = OFFERED[0];
    let edits: Vec<Edit> = all.iter().filter_map(|direction| edit(direction, best)).collect();
    if edits.len() > 1 && edit(chosen, best).is_some() {
        let title = format!("Write all {} directions like {}", edits.len(), best.spell(crate::syntax::tune::Cardinal::XMax));
        found.push(rewriting(title, edits));
    }
    found
}
