//! The names that every program has.

use std::sync::{Arc, OnceLock};

use crate::python::code::Program;
use crate::python::host::HostName;
use crate::python::program::build;
use crate::python::value::Value;
use crate::scene::terms::{Cardinal, Kind, Support, Target};
use crate::syntax::{Tuning, parse};

use super::Thing;

/// The functions of the language.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Function {
    Object,
    Door,
    Window,
    SetTitle,
    SetSize,
    SetFloorAsset,
    SetWallAsset,
    SetCoordinateFrame,
    Center,
    Opposite,
    Vec,
}

impl Function {
    /// All of them, in the order of their numbers.
    pub(super) const ALL: [Function; 11] = [
        Function::Object,
        Function::Door,
        Function::Window,
        Function::SetTitle,
        Function::SetSize,
        Function::SetFloorAsset,
        Function::SetWallAsset,
        Function::SetCoordinateFrame,
        Function::Center,
        Function::Opposite,
        Function::Vec,
    ];

    /// As programs call it.
    pub(super) fn name(self) -> &'static str {
        match self {
            Function::Object => "Object",
            Function::Door => "Door",
            Function::Window => "Window",
            Function::SetTitle => "set_title",
            Function::SetSize => "set_size",
            Function::SetFloorAsset => "set_floor_asset",
            Function::SetWallAsset => "set_wall_asset",
            Function::SetCoordinateFrame => "set_coordinate_frame",
            Function::Center => "center",
            Function::Opposite => "opposite",
            Function::Vec => "Vec",
        }
    }

    /// What it makes, for constructors of objects.
    pub(super) fn kind(self) -> Kind {
        match self {
            Function::Door => Kind::Door,
            Function::Window => Kind::Window,
            _ => Kind::Object,
        }
    }
}

const CARDINALS: [(&str, Cardinal); 12] = [
    ("X_MAX", Cardinal::XMax),
    ("Y_MAX", Cardinal::YMax),
    ("X_MIN", Cardinal::XMin),
    ("Y_MIN", Cardinal::YMin),
    ("X_POS", Cardinal::XMax),
    ("Y_POS", Cardinal::YMax),
    ("X_NEG", Cardinal::XMin),
    ("Y_NEG", Cardinal::YMin),
    ("RIGHT_WALL", Cardinal::XMax),
    ("TOP_WALL", Cardinal::YMax),
    ("LEFT_WALL", Cardinal::XMin),
    ("BOTTOM_WALL", Cardinal::YMin),
];

const SUPPORTS: [(&str, Support); 4] =
    [("STANDING", Support::Standing), ("MOUNTED", Support::Mounted), ("WALL_MOUNTED", Support::Mounted), ("FLOATING", Support::Floating)];

const SCENES: [&str; 2] = ["scene", "CENTER"];

/// Names that modules bind: the name, the module, the attribute.
const IMPORTS: [(&str, &str, &str); 16] = [
    ("sin", "math", "sin"),
    ("cos", "math", "cos"),
    ("tan", "math", "tan"),
    ("atan2", "math", "atan2"),
    ("sqrt", "math", "sqrt"),
    ("pi", "math", "pi"),
    ("radians", "math", "radians"),
    ("degrees", "math", "degrees"),
    ("floor", "math", "floor"),
    ("ceil", "math", "ceil"),
    ("hypot", "math", "hypot"),
    ("math", "_scene_math", "math"),
    ("random", "_scene_random", "random"),
    ("random_direction", "_scene_random", "random_direction"),
    ("Facing", "_scene_enums", "Facing"),
    ("Support", "_scene_enums", "Support"),
];

/// The modules in Python behind some of the names.
const MODULES: [(&str, &str); 3] = [
    ("_scene_math", include_str!("lib/math.py")),
    ("_scene_random", include_str!("lib/random.py")),
    ("_scene_enums", include_str!("lib/enums.py")),
];

static PROGRAMS: [OnceLock<Option<Arc<Program>>>; MODULES.len()] = [const { OnceLock::new() }; MODULES.len()];

/// A module behind some of the names, compiled once in a process.
pub(super) fn module(name: &str) -> Option<Arc<Program>> {
    let index = MODULES.iter().position(|(known, _)| *known == name)?;
    let compiled = |text: &str| {
        let parsed = parse(text);
        if parsed.is_complete() { build(&parsed, text, &Tuning::default()).ok() } else { None }
    };
    PROGRAMS[index].get_or_init(|| compiled(MODULES[index].1)).clone()
}

/// What a name means.
pub(super) fn lookup(name: &str) -> Option<HostName> {
    if let Some((_, cardinal)) = CARDINALS.iter().find(|(known, _)| *known == name) {
        return Some(HostName::Value(Value::int(cardinal.index() as i64)));
    }
    if let Some((_, support)) = SUPPORTS.iter().find(|(known, _)| *known == name) {
        return Some(HostName::Value(Value::int(*support as i64)));
    }
    if SCENES.contains(&name) {
        return Some(HostName::Value(Thing::Target(Target::Scene).value()));
    }
    if let Some(function) = Function::ALL.into_iter().find(|function| function.name() == name) {
        return Some(HostName::Value(Thing::Function(function).value()));
    }
    let (_, module, attribute) = IMPORTS.iter().find(|(known, ..)| *known == name)?;
    Some(HostName::Import(module, attribute))
}

/// All names.
pub(super) fn all() -> impl Iterator<Item = &'static str> {
    let cardinals = CARDINALS.iter().map(|(name, _)| *name);
    let supports = SUPPORTS.iter().map(|(name, _)| *name);
    let functions = Function::ALL.into_iter().map(Function::name);
    SCENES.into_iter().chain(functions).chain(supports).chain(cardinals).chain(IMPORTS.iter().map(|(name, ..)| *name))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_modules_behind_the_names_compile() {
        for (name, _) in super::MODULES {
            assert!(super::module(name).is_some(), "{name}");
        }
    }
}
