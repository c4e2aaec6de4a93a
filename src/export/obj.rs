//! Wavefront OBJ, Y up as its readers expect: (x, y, z) of the scene becomes (x, z, −y). Each object is a group of six faces.

use super::colour::Rgb;
use super::pieces::Pieces;
use super::words::{Unique, numbers, word};
use super::{Companion, Exported};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Corners of each face of a box, counterclockwise as seen from outside, and the number of its normal. Corners are numbered by the
/// bits x = 1, y = 2, z = 4 of the side that they lie on, in the scene's axes.
const FACES: [([usize; 4], usize); 6] =
    [([1, 3, 7, 5], 1), ([0, 4, 6, 2], 2), ([2, 6, 7, 3], 3), ([0, 1, 5, 4], 4), ([4, 5, 7, 6], 5), ([0, 2, 3, 1], 6)];
/// Right, left, away, near, up, down, as the file counts them from 1.
const NORMALS: [[f64; 3]; 6] = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];

fn y_up([x, y, z]: [f64; 3]) -> String {
    numbers([x, z, -y])
}

fn corners(min: [f64; 3], max: [f64; 3]) -> [[f64; 3]; 8] {
    std::array::from_fn(|corner| [0, 1, 2].map(|k| if corner >> k & 1 == 1 { max[k] } else { min[k] }))
}

pub(super) fn obj(pieces: &Pieces, stem: Option<&str>) -> Exported {
    let mut out = String::from("# psdl; metres, Y up\n");
    let mut materials = BTreeSet::new();
    let library = stem.map(|stem| format!("{}.mtl", word(stem)));
    if let Some(library) = &library {
        let _ = writeln!(out, "mtllib {library}");
    }
    for (object, hidden) in &pieces.hidden {
        let _ = writeln!(out, "# left out: {}: {}", word(&object.path), hidden.reason());
    }
    for normal in NORMALS {
        let _ = writeln!(out, "vn {}", y_up(normal));
    }
    let mut names = Unique::default();
    let mut written = 0;
    let mut solid = |out: &mut String, name: &str, colour: Rgb, corners: &[[f64; 3]], faces: &[([usize; 4], usize)]| {
        let _ = writeln!(out, "o {}", names.take(word(name)));
        for corner in corners {
            let _ = writeln!(out, "v {}", y_up(*corner));
        }
        if library.is_some() {
            materials.insert(colour);
            let _ = writeln!(out, "usemtl {}", colour.hex());
        }
        for (face, normal) in faces {
            let [a, b, c, d] = face.map(|corner| format!("{}//{normal}", written + corner + 1));
            let _ = writeln!(out, "f {a} {b} {c} {d}");
        }
        written += corners.len();
    };
    for piece in &pieces.shown {
        let body = &piece.object.body;
        solid(&mut out, &piece.object.path, piece.colour, &corners(body.min, body.max), &FACES);
    }
    for surface in &pieces.surfaces {
        let normal = NORMALS.iter().position(|normal| *normal == surface.normal).map_or(1, |index| index + 1);
        solid(&mut out, surface.name, surface.colour, &surface.corners, &[([0, 1, 2, 3], normal)]);
    }
    let companion = library.map(|name| Companion { name, bytes: mtl(&materials).into_bytes() });
    Exported { bytes: out.into_bytes(), companion }
}

fn mtl(materials: &BTreeSet<Rgb>) -> String {
    let mut out = String::from("# psdl\n");
    for colour in materials {
        let kd = numbers(colour.fractions());
        let _ = write!(out, "newmtl {}\nKa 0 0 0\nKd {kd}\nKs 0 0 0\nd 1\nillum 1\n", colour.hex());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_face_lies_on_its_side_and_looks_out() {
        let corners = corners([-1.0; 3], [1.0; 3]);
        for (face, normal) in FACES {
            let normal = NORMALS[normal - 1];
            let [a, b, c, _] = face.map(|corner| corners[corner]);
            let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - b[k]));
            let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            assert_eq!(cross.map(|value| value / 4.0), normal);
            assert!(face.iter().all(|corner| (0..3).all(|k| normal[k] == 0.0 || corners[*corner][k] == normal[k])));
        }
    }
}
