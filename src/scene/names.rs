//! What the program calls its objects: `bed`, `nightstands[1]`, `room.bed`, `lamps['left']`, `create_wall() #7`.

use std::collections::VecDeque;

use rustc_hash::FxHashMap;

use super::layout::Layout;
use super::origin::StepKind;
use super::terms::ObjectId;

/// How a part of a value is reached.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Label {
    /// `[3]`
    Index(usize),
    /// `['left']`, the key as `repr` shows it.
    Key(String),
    /// `.bed`
    Attribute(String),
}

/// A value of the program, as far as it leads to objects.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Node {
    /// An object.
    Object(ObjectId),
    /// A list, dict or instance.
    Group(Vec<(Label, Node)>),
}

/// A global name and its value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Root {
    /// The name.
    pub name: String,
    /// Its value at the end of the run.
    pub node: Node,
}

fn path(base: &str, label: &Label) -> String {
    match label {
        Label::Index(index) => format!("{base}[{index}]"),
        Label::Key(key) => format!("{base}[{key}]"),
        Label::Attribute(name) => format!("{base}.{name}"),
    }
}

/// Names the objects of a layout after the globals that lead to them: the shortest way first, then the global that comes first. `roots`
/// leaves out names that a loop binds anew each time (they would name the last object after the loop variable). An object without such
/// a name is called after the function that declared it, or its category, and numbered.
pub fn name_objects(layout: &mut Layout, roots: &[Root]) {
    let mut names: Vec<Option<String>> = vec![None; layout.objects.len()];
    let mut queue: VecDeque<(&Node, String)> = roots.iter().map(|root| (&root.node, root.name.clone())).collect();
    while let Some((node, base)) = queue.pop_front() {
        match node {
            Node::Group(parts) => queue.extend(parts.iter().map(|(label, part)| (part, path(&base, label)))),
            Node::Object(id) => {
                if let Some(name) = names.get_mut(id.index()) {
                    name.get_or_insert(base);
                }
            }
        }
    }
    let mut counts = FxHashMap::<String, usize>::default();
    for (index, name) in names.into_iter().enumerate() {
        let object = &layout.objects[index];
        let maker = layout.origins.steps_around(object.declared).find_map(|step| match &step.kind {
            StepKind::Call { function } if !function.starts_with('<') => Some(format!("{function}()")),
            _ => None,
        });
        let maker = maker.unwrap_or_else(|| object.name.clone());
        let count = counts.entry(maker.clone()).or_default();
        *count += 1;
        layout.objects[index].path = name.unwrap_or_else(|| format!("{maker} #{count}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Given, Kind, NewObject, Origin, Scalar, Source, World};
    use crate::trace::Plain;
    use ruff_text_size::TextRange;

    /// The paths of objects whose declarations stood in calls of the given functions (none for the top level).
    fn names(makers: &[&str], roots: &[Root]) -> Vec<String> {
        let mut world = World::new();
        for (index, maker) in makers.iter().enumerate() {
            let call = || StepKind::Call { function: (*maker).into() };
            let inside = if maker.is_empty() { None } else { world.origins.step(None, TextRange::default(), index as u32, call) };
            let origin = world.origins.intern(Origin { source: Source::Program, range: TextRange::default(), inside });
            let (dims, support) = ([1.0, 1.0, 1.0].map(Given::from), Scalar::int(0).into());
            let new = NewObject { kind: Kind::Object, name: "Wall 3", dims, support, color: None, dynamic: false };
            world.add_object(&mut Plain, &new, origin).expect("a good object");
        }
        let mut layout = world.into_layout(&mut Plain);
        name_objects(&mut layout, roots);
        layout.objects.into_iter().map(|object| object.path).collect()
    }

    fn root(name: &str, node: Node) -> Root {
        Root { name: name.into(), node }
    }

    fn object(index: u32) -> Node {
        Node::Object(ObjectId(index))
    }

    fn list(nodes: impl IntoIterator<Item = Node>) -> Node {
        Node::Group(nodes.into_iter().enumerate().map(|(index, node)| (Label::Index(index), node)).collect())
    }

    #[test]
    fn the_shortest_way_from_a_global_names_an_object() {
        let everything = root("everything", list([list([object(0), object(1)]), object(2)]));
        let room = root("room", Node::Group(vec![(Label::Attribute("bed".into()), object(1))]));
        let lamps = root("lamps", Node::Group(vec![(Label::Key("'left'".into()), object(2)), (Label::Key("4".into()), object(3))]));
        let names = names(&["", "", "", ""], &[everything, room, lamps, root("desk", object(0)), root("other_desk", object(0))]);
        assert_eq!(names, ["desk", "room.bed", "everything[1]", "lamps[4]"]);
    }

    #[test]
    fn an_object_without_a_name_is_called_after_its_maker_or_its_category() {
        let names = names(&["create_wall", "create_wall", "", "<lambda>", "create_wall"], &[root("gate", object(1))]);
        assert_eq!(names, ["create_wall() #1", "gate", "Wall #1", "Wall #2", "create_wall() #3"]);
    }
}
