//! Links between a program and its sidecar template: from the first place where the program names an entry, and back.

use super::find::occurrences_of;
use super::names::variable_of_id;
use super::program::View;
use crate::scene::template::Template;
use ruff_text_size::TextRange;

/// A link.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Link {
    /// What is clicked.
    pub range: TextRange,
    /// Where it leads in the other file.
    pub target: TextRange,
    /// What there is, in a few words.
    pub tooltip: String,
}

/// From the program to the entries of its sidecar.
pub fn to_template(view: &View, template: &Template) -> Vec<Link> {
    let mut links: Vec<Link> = template
        .objects
        .iter()
        .filter_map(|entry| {
            let range = first(view, &entry.id)?;
            Some(Link { range, target: entry.id_range, tooltip: format!("{} is declared in the template", entry.id) })
        })
        .collect();
    links.sort_by_key(|link| link.range.start());
    links
}

/// From the entries of the sidecar to where the program names them first.
pub fn from_template(view: &View, template: &Template) -> Vec<Link> {
    let link = |target: TextRange, range, id: &str| Link { range, target, tooltip: format!("{id} is placed in the program") };
    template.objects.iter().filter_map(|entry| Some(link(first(view, &entry.id)?, entry.id_range, &entry.id))).collect()
}

fn first(view: &View, id: &str) -> Option<TextRange> {
    occurrences_of(view, variable_of_id(view, id)?).first().map(|found| found.range)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    #[test]
    fn the_first_place_of_each_entry_is_a_link() {
        let template = r#"{"title": "Room", "width": 4, "depth": 4, "height": 3, "interior": true, "objects": [{"id": "desk", "name": "Desk", "width": 1, "depth": 1, "height": 1, "support": "STANDING"}]}"#;
        let fixture = Fixture::with_template("x = 1\ndesk.min.x = 0.5\ndesk.min.y = 0.5\n", Some(template));
        let read = fixture.scene.as_ref().and_then(|scene| scene.template.clone()).unwrap();
        let view = fixture.view();
        let there = to_template(&view, &read);
        assert_eq!((there.len(), &fixture.text()[there[0].range], &template[there[0].target]), (1, "desk", "\"desk\""));
        let back = from_template(&view, &read);
        assert_eq!((back[0].target, back[0].range), (there[0].range, there[0].target));
    }
}
