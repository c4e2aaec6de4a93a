//! The kinds of layout errors, each with a scene that has it.

use super::Info;
use crate::check::finding::{Code, Severity};

/// The weighted errors of a layout.
pub(super) const LAYOUT: &[Info] = &[
    Info {
        code: Code::OutOfBounds,
        name: "out-of-bounds",
        severity: Severity::Error,
        summary: "A box sticks out of the scene.",
        explanation: "The box of an object reaches beyond one of the four sides of the scene, below the ground, or, where the scene has a ceiling, above it. \
                      The message gives the largest of these distances.",
        template: None,
        example: "set_size(width=5, depth=4, height=3)\nwardrobe = Object(\"Wardrobe\", width=1.8, depth=0.6, height=2.2)\n\nwardrobe.center.x = scene.max.x - 0.5\nwardrobe.center.y = scene.center.y\nwardrobe.min.z = scene.min.z\nwardrobe.facing = Y_MIN\n",
        remedy: "Anchor the side of the object that lies at the wall (`max`, `min`) instead of its center, or bring the anchor further in.",
        fixed: "set_size(width=5, depth=4, height=3)\nwardrobe = Object(\"Wardrobe\", width=1.8, depth=0.6, height=2.2)\n\nwardrobe.max.x = scene.max.x - 0.5\nwardrobe.center.y = scene.center.y\nwardrobe.min.z = scene.min.z\nwardrobe.facing = Y_MIN\n",
    },
    Info {
        code: Code::Overlap,
        name: "overlap",
        severity: Severity::Error,
        summary: "Two boxes share volume.",
        explanation: "Two objects stand in each other by 0.01 m or more along every axis. The message names the smallest movement of one of them that parts the two. \
                      A rug (height at most a tenth of its width and of its depth, and less than 0.2 m) overlaps nothing: things may stand on it or in it.",
        template: None,
        example: "table = Object(\"Table\", width=1.6, depth=0.9, height=0.75)\nchair = Object(\"Chair\", width=0.5, depth=0.5, height=0.9)\n\ntable.center = (0, 0, 0.375)\ntable.facing = Y_MAX\nchair.center.x = table.center.x\nchair.center.y = table.max.y + 0.1\nchair.min.z = scene.min.z\nchair.facing = table\n",
        remedy: "Place the later object by the side that is next to the other one, with a gap: `chair.min.y = table.max.y + 0.1`.",
        fixed: "table = Object(\"Table\", width=1.6, depth=0.9, height=0.75)\nchair = Object(\"Chair\", width=0.5, depth=0.5, height=0.9)\n\ntable.center = (0, 0, 0.375)\ntable.facing = Y_MAX\nchair.center.x = table.center.x\nchair.min.y = table.max.y + 0.1\nchair.min.z = scene.min.z\nchair.facing = table\n",
    },
    Info {
        code: Code::Standing,
        name: "standing",
        severity: Severity::Error,
        summary: "A standing object floats in the air or has sunk into what carries it.",
        explanation: "The bottom of an object with the support `STANDING` is 0.01 m or more away from the ground and from the top of every other object that lies under its center. \
                      An object beside the center counts too, with the horizontal distance added.",
        template: None,
        example: "table = Object(\"Table\", width=1.6, depth=0.9, height=0.75)\nlamp = Object(\"Lamp\", width=0.2, depth=0.2, height=0.4)\n\ntable.center.x, table.center.y = 0, 0\ntable.facing = Y_MAX\nlamp.center.x, lamp.center.y = 0, 0\nlamp.min.z = table.max.z + 0.2\n",
        remedy: "Let its bottom be the top of what carries it (`lamp.min.z = table.max.z`) or the ground (`scene.min.z`); if it is meant to float, declare it `FLOATING`.",
        fixed: "table = Object(\"Table\", width=1.6, depth=0.9, height=0.75)\nlamp = Object(\"Lamp\", width=0.2, depth=0.2, height=0.4)\n\ntable.center.x, table.center.y = 0, 0\ntable.facing = Y_MAX\nlamp.center.x, lamp.center.y = 0, 0\nlamp.min.z = table.max.z\n",
    },
    Info {
        code: Code::Mounted,
        name: "mounted",
        severity: Severity::Error,
        summary: "A mounted object does not touch a wall.",
        explanation: "An object with the support `MOUNTED` (doors and windows always are) has its wider side away from both walls that this side can lie against; if it is square, away from all four.",
        template: None,
        example: "picture = Object(\"Picture\", width=1.0, depth=0.05, height=0.7, support=MOUNTED)\n\npicture.center.x = scene.center.x\npicture.max.y = scene.max.y - 0.3\npicture.min.z = 1.4\npicture.facing = Y_MIN\n",
        remedy: "Anchor its back to the wall without an offset, and turn it so that it faces away from the wall.",
        fixed: "picture = Object(\"Picture\", width=1.0, depth=0.05, height=0.7, support=MOUNTED)\n\npicture.center.x = scene.center.x\npicture.max.y = scene.max.y\npicture.min.z = 1.4\npicture.facing = Y_MIN\n",
    },
    Info {
        code: Code::Clearance,
        name: "clearance",
        severity: Severity::Error,
        summary: "Something stands in the way of a door or a window.",
        explanation: "Each door keeps free half of its width in front of it and behind it, each window a quarter of its width, at most 0.4 m. \
                      Another object that is no rug reaches into that room.",
        template: None,
        example: "door = Door(\"Door\", width=0.9, depth=0.1, height=2.0)\nbin = Object(\"Bin\", width=0.3, depth=0.3, height=0.5)\n\ndoor.center.x = scene.center.x\ndoor.min.y = scene.min.y\ndoor.min.z = scene.min.z\ndoor.facing = Y_MAX\nbin.center.x = door.center.x\nbin.min.y = door.max.y + 0.1\n",
        remedy: "Move the object away from the opening, by more than half of the door's width.",
        fixed: "door = Door(\"Door\", width=0.9, depth=0.1, height=2.0)\nbin = Object(\"Bin\", width=0.3, depth=0.3, height=0.5)\n\ndoor.center.x = scene.center.x\ndoor.min.y = scene.min.y\ndoor.min.z = scene.min.z\ndoor.facing = Y_MAX\nbin.min.x = door.max.x + 0.2\nbin.min.y = door.max.y + 0.1\n",
    },
    Info {
        code: Code::Facing,
        name: "facing",
        severity: Severity::Error,
        summary: "An object does not face what it was told to face.",
        explanation: "The object was given another object (or the scene) to face. Its direction was decided when its place was first read, and in the final layout that direction no longer points there, because one of the two moved later.",
        template: None,
        example: "stage = Object(\"Stage\", width=2, depth=1, height=0.5)\nseat = Object(\"Seat\", width=0.5, depth=0.6, height=0.9)\nsign = Object(\"Sign\", width=0.3, depth=0.1, height=0.3)\n\nstage.center = (0, 2, 0.25)\nstage.facing = Y_MIN\nseat.center = (0, -1, 0.45)\nseat.facing = stage\nsign.center.x = seat.max.x + 0.5\nsign.center.y = seat.center.y\nstage.center.y = -2.5\n",
        remedy: "Place both objects for good before anything reads the place of the one that turns, or set its facing again after the last move.",
        fixed: "stage = Object(\"Stage\", width=2, depth=1, height=0.5)\nseat = Object(\"Seat\", width=0.5, depth=0.6, height=0.9)\nsign = Object(\"Sign\", width=0.3, depth=0.1, height=0.3)\n\nstage.center = (0, -2.5, 0.25)\nstage.facing = Y_MAX\nseat.center = (0, -1, 0.45)\nseat.facing = stage\nsign.center.x = seat.max.x + 0.5\nsign.center.y = seat.center.y\n",
    },
    Info {
        code: Code::FacingWall,
        name: "facing-wall",
        severity: Severity::Warning,
        summary: "An object faces the wall that it stands against.",
        explanation: "An object that was told to face another one, or whose facing followed from others, is anchored against a wall and turned to that wall. \
                      An object whose direction was given outright (`o.facing = X_MAX`) is taken at its word.",
        template: None,
        example: "picture = Object(\"Picture\", width=1.0, depth=0.05, height=0.7, support=MOUNTED)\nchair = Object(\"Chair\", width=0.5, depth=0.5, height=0.9)\n\npicture.max.x = scene.max.x\npicture.center.y = scene.center.y\npicture.min.z = 1.4\npicture.facing = X_MIN\nchair.max.x = scene.max.x\nchair.center.y = picture.center.y\nchair.facing = picture\n",
        remedy: "Give the object room in front of it, or a direction that leads away from the wall.",
        fixed: "picture = Object(\"Picture\", width=1.0, depth=0.05, height=0.7, support=MOUNTED)\nchair = Object(\"Chair\", width=0.5, depth=0.5, height=0.9)\n\npicture.max.x = scene.max.x\npicture.center.y = scene.center.y\npicture.min.z = 1.4\npicture.facing = X_MIN\nchair.max.x = scene.max.x - 1.5\nchair.center.y = picture.center.y\nchair.facing = picture\n",
    },
    Info {
        code: Code::ShortSide,
        name: "short-side",
        severity: Severity::Warning,
        summary: "An object stands against a wall with its short side.",
        explanation: "An object that was told to face another one, or whose facing followed from others, is anchored against exactly one wall, but lies along it the wrong way: \
                      it faces along the wall although it is at least as wide as deep, or away from it although it is more than twice as deep as wide.",
        template: None,
        example: "window = Window(\"Window\", width=1.0, depth=0.1, height=1.0)\nsofa = Object(\"Sofa\", width=2.0, depth=0.9, height=0.8)\n\nwindow.min.x = scene.min.x\nwindow.center.y = -2.3\nwindow.min.z = 1.2\nwindow.facing = X_MAX\nsofa.center.x = scene.center.x + 1.0\nsofa.min.y = scene.min.y\nsofa.facing = window\n",
        remedy: "Face the object away from the wall, or place it away from the wall.",
        fixed: "window = Window(\"Window\", width=1.0, depth=0.1, height=1.0)\nsofa = Object(\"Sofa\", width=2.0, depth=0.9, height=0.8)\n\nwindow.min.x = scene.min.x\nwindow.center.y = -2.3\nwindow.min.z = 1.2\nwindow.facing = X_MAX\nsofa.center.x = scene.center.x + 1.0\nsofa.min.y = scene.min.y\nsofa.facing = Y_MAX\n",
    },
];
