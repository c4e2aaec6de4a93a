//! What a program calls its objects: variables, and lists and dicts of them where the file has such paths.

use super::super::words::{Unique, identifier};
use super::flat::Item;
use crate::scene::template::{KEYWORDS, is_variable_name};
use rustc_hash::{FxHashMap, FxHashSet};

/// Names that the program itself uses.
const WORDS: [&str; 22] = [
    "scene",
    "CENTER",
    "Object",
    "Door",
    "Window",
    "set_title",
    "set_size",
    "set_floor_asset",
    "set_wall_asset",
    "set_coordinate_frame",
    "range",
    "STANDING",
    "MOUNTED",
    "FLOATING",
    "X_MAX",
    "Y_MAX",
    "X_MIN",
    "Y_MIN",
    "_",
    "center",
    "Vec",
    "math",
];
/// Containers are searched for objects no deeper than this.
const DEPTH: usize = 4;

/// What is assigned to a variable.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Shape {
    /// An object, by its place in the scene.
    One(usize),
    /// A list.
    List(Vec<Shape>),
    /// A dict; keys as Python writes them.
    Dict(Vec<(String, Shape)>),
}

/// The variables in the order of their declaration, and the path of each object.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Names {
    pub(super) variables: Vec<(String, Shape)>,
    pub(super) paths: Vec<String>,
}

/// `chairs[0]['left']` as `chairs` and `[0]`, `['left']`.
struct Path<'a> {
    root: &'a str,
    labels: Vec<&'a str>,
}

fn parse(wish: &str) -> Option<Path<'_>> {
    let end = wish.find('[').unwrap_or(wish.len());
    let (root, mut rest) = wish.split_at(end);
    let mut labels = Vec::new();
    while !rest.is_empty() {
        let (label, more) = rest.strip_prefix('[')?.split_once(']')?;
        if labels.len() == DEPTH || !is_label(label) {
            return None;
        }
        labels.push(label);
        rest = more;
    }
    is_variable_name(root).then_some(Path { root, labels })
}

/// A number as Python writes it, or a simple word in quotes: nothing that could be anything else.
fn is_label(label: &str) -> bool {
    let is_number =
        |text: &str| text.len() <= 6 && text.bytes().all(|byte| byte.is_ascii_digit()) && (text == "0" || !text.starts_with('0'));
    let word = label.strip_prefix('\'').and_then(|label| label.strip_suffix('\''));
    let is_word = |text: &str| text.bytes().all(|byte| byte.is_ascii_alphanumeric() || b" _-.".contains(&byte));
    !label.is_empty() && (is_number(label) || word.is_some_and(is_word))
}

/// The rest of an object's path, and its place in the scene.
type Part<'a> = (&'a [&'a str], usize);

/// Objects that share a root and stand one after the other, as what they are parts of. `None` where no list or dict has them in this
/// order at these places.
fn shape(parts: &[Part]) -> Option<Shape> {
    if let [(labels, index)] = parts
        && labels.is_empty()
    {
        return Some(Shape::One(*index));
    }
    let mut groups: Vec<(&str, Vec<Part>)> = Vec::new();
    for (labels, index) in parts {
        let (first, rest) = labels.split_first()?;
        match groups.last_mut() {
            Some((label, group)) if label == first => group.push((rest, *index)),
            _ => groups.push((first, vec![(rest, *index)])),
        }
    }
    let distinct: FxHashSet<&str> = groups.iter().map(|(label, _)| *label).collect();
    if distinct.len() != groups.len() {
        return None;
    }
    let is_list = groups.iter().enumerate().all(|(index, (label, _))| label.parse() == Ok(index));
    let parts = groups.into_iter().map(|(label, group)| Some((label.replace('\'', "\""), shape(&group)?)));
    let parts: Vec<(String, Shape)> = parts.collect::<Option<_>>()?;
    Some(if is_list { Shape::List(parts.into_iter().map(|(_, part)| part).collect()) } else { Shape::Dict(parts) })
}

pub(super) fn name(items: &[Item]) -> Names {
    let paths: Vec<Option<Path>> = items.iter().map(|item| parse(&item.wish)).collect();
    let mut uses = FxHashMap::<&str, usize>::default();
    for path in paths.iter().flatten() {
        *uses.entry(path.root).or_default() += 1;
    }
    let mut taken = Unique::reserve(WORDS.into_iter().chain(KEYWORDS));
    // What the file calls by a good name has it; the others are named around it.
    let mut groups: Vec<Option<(usize, Shape)>> = vec![None; items.len()];
    let mut index = 0;
    while index < items.len() {
        let Some(path) = &paths[index] else {
            index += 1;
            continue;
        };
        let is_part = |other: &&Option<Path>| other.as_ref().is_some_and(|other| other.root == path.root);
        let count = paths[index..].iter().take_while(is_part).count();
        let parts: Vec<Part> = (index..index + count).filter_map(|at| Some((paths[at].as_ref()?.labels.as_slice(), at))).collect();
        if uses.get(path.root) == Some(&count) && taken.is_free(path.root) {
            groups[index] = shape(&parts).map(|shape| (count, shape));
            if groups[index].is_some() {
                taken.take(path.root.to_owned());
            }
        }
        index += count;
    }
    let mut names = Names::default();
    while names.paths.len() < items.len() {
        let index = names.paths.len();
        match (groups[index].take(), &paths[index]) {
            (Some((count, shape)), Some(path)) => {
                names.variables.push((path.root.to_owned(), shape));
                names.paths.extend(items[index..index + count].iter().map(|item| item.wish.clone()));
            }
            _ => {
                let variable = taken.take(identifier(&items[index].wish.to_lowercase(), "object"));
                names.variables.push((variable.clone(), Shape::One(index)));
                names.paths.push(variable);
            }
        }
    }
    names
}

/// Paths for objects that have categories only: `chairs[0]`, `chairs[1]`, or `table` where there is one.
pub(super) fn wishes<'a>(categories: impl Iterator<Item = &'a str> + Clone) -> Vec<String> {
    let bases: Vec<String> = categories.map(|category| identifier(&category.to_lowercase(), "object")).collect();
    let mut counts = FxHashMap::<&str, usize>::default();
    bases.iter().for_each(|base| *counts.entry(base).or_default() += 1);
    let mut seen = FxHashMap::<&str, usize>::default();
    let mut out = Vec::with_capacity(bases.len());
    for base in &bases {
        if counts.get(base.as_str()) == Some(&1) {
            out.push(base.clone());
            continue;
        }
        let number = seen.entry(base).or_default();
        let plural = if base.ends_with('s') { "" } else { "s" };
        out.push(format!("{base}{plural}[{number}]"));
        *number += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Cardinal, Kind, Scalar, Support};

    fn paths(wishes: &[&str]) -> Vec<String> {
        let item = |wish: &&str| Item {
            wish: (*wish).to_owned(),
            category: "A".into(),
            kind: Kind::Object,
            support: Support::Standing,
            dims: [Scalar::float(1.0); 3],
            color: None,
            anchors: Vec::new(),
            turn: Cardinal::YMax,
            facing: super::super::flat::Facing::Free,
            remark: None,
        };
        name(&wishes.iter().map(item).collect::<Vec<_>>()).paths
    }

    #[test]
    fn lists_and_dicts_stay_where_the_order_allows_it() {
        let kept = ["bed", "chairs[0]", "chairs[1]", "lamps['left']", "lamps['right']", "grid[0][0]", "grid[0][1]", "grid[1][0]"];
        assert_eq!(paths(&kept), kept);
        assert_eq!(paths(&["a[0]", "b", "a[1]"]), ["a_0", "b", "a_1"]);
        assert_eq!(paths(&["room.bed", "create_wall() #3", "Chair #1", "chair_1"]), ["room_bed", "create_wall_3", "chair_1_2", "chair_1"]);
    }

    #[test]
    fn no_path_becomes_code_or_hides_a_name_of_the_language() {
        assert_eq!(paths(&["a[__import__('os')]", "scene", "class", "x['\"+1']"]), ["a_import_os", "scene_2", "class_2", "x_1"]);
    }

    #[test]
    fn categories_become_variables_and_lists() {
        assert_eq!(wishes(["Chair", "Table", "Chair", "床"].into_iter()), ["chairs[0]", "table", "chairs[1]", "object"]);
    }
}
