//! The scene with the places of the program that made it.

use super::program::{Deed, View};
use crate::scene::{JsonViolation, layout_json};
use crate::syntax::LineIndex;
use ruff_text_size::TextRange;

/// Where an object comes from, in the text as it is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Places {
    /// As the program calls it.
    pub path: String,
    /// The statement that declared it, unless it was edited since.
    pub declaration: Option<TextRange>,
    /// The statements that placed and turned it, in order; without those that were edited since.
    pub placements: Vec<TextRange>,
}

/// The last scene as layout JSON.
pub fn layout_text(view: &View) -> Option<String> {
    let scene = view.scene?;
    let lines = LineIndex::new(&scene.text);
    let counted: Vec<_> = scene.verdict.counted().map(|error| (error, error.objects().collect::<Vec<usize>>())).collect();
    let violations = counted.iter().map(|(error, objects)| JsonViolation { kind: error.kind.name(), objects, loss: error.loss });
    let violations: Vec<JsonViolation> = violations.collect();
    Some(layout_json(&scene.layout, &violations, &|offset| lines.line(offset) as usize + 1))
}

/// Where the objects of the last scene come from, in their order.
pub fn places(view: &View) -> Vec<Places> {
    let Some(scene) = view.scene else { return Vec::new() };
    let place = |object: &crate::scene::Placed| Places { path: object.path.clone(), declaration: None, placements: Vec::new() };
    let mut places: Vec<Places> = scene.layout.objects.iter().map(place).collect();
    for mark in view.marks() {
        let Some(of) = places.get_mut(mark.object) else { continue };
        match mark.deed {
            Deed::Declared => of.declaration = Some(mark.range),
            Deed::Anchored(_) | Deed::Faced => of.placements.push(mark.range),
            Deed::Around => {}
        }
    }
    places.iter_mut().for_each(|of| of.placements.dedup());
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::Program;
    use crate::ide::tests::scene_of;

    #[test]
    fn each_object_knows_its_statements_also_after_an_edit_elsewhere() {
        let old = "a = Object('A', 1, 1, 1)\na.center.x = a.center.y = 0\na.facing = X_MAX\n";
        let new = old.replace("X_MAX", "X_M");
        let scene = scene_of(old, None).expect("a scene");
        let program = Program::read(new.as_str().into());
        let view = View::new(&program, Some(&scene));
        let places = places(&view);
        assert_eq!((places.len(), places[0].path.as_str()), (1, "a"));
        assert_eq!(places[0].declaration.map(|range| &new[range]), Some("a = Object('A', 1, 1, 1)"));
        assert_eq!(places[0].placements.iter().map(|range| &new[*range]).collect::<Vec<_>>(), ["a.center.x = a.center.y = 0"]);
        assert!(layout_text(&view).is_some_and(|text| text.contains("\"path\":\"a\"")));
    }
}
