//! Shadows on everything that lies flat: the floor and the tops of boxes. They make heights readable.
//!
//! A lamp of some size is taken as a few directions; where all of them are blocked the shadow is deep, at its edge it is soft, and the softer the
//! higher the thing that throws it.

use super::solid::{Cuboid, Solid, clipped};

/// How far a shadow moves for a metre of height, for each direction of the lamp. The last one makes the edge where things touch.
const LAMP: [[f64; 2]; 6] = [[0.46, -0.25], [0.37, -0.30], [0.34, -0.19], [0.26, -0.21], [0.19, -0.11], [0.05, -0.04]];

/// How many boxes may throw shadows on each other; in larger scenes they fall on the floor only.
const MOST: usize = 1500;

/// The shadows of one direction on one surface: polygons in x and y.
pub type Layer = Vec<Vec<[f64; 2]>>;

/// The shadows on a surface, one layer a direction of the lamp.
pub type Shadows = [Layer; LAMP.len()];

/// The shadows on the floor, and on the top of each box.
pub fn shadows(solids: &[Solid], floor: &Cuboid) -> (Shadows, Vec<Shadows>) {
    let on_floor = on(solids, floor, usize::MAX);
    let tops = if solids.len() > MOST { vec![Shadows::default(); solids.len()] } else { tops(solids) };
    (on_floor, tops)
}

fn tops(solids: &[Solid]) -> Vec<Shadows> {
    solids.iter().enumerate().map(|(index, solid)| on(solids, &solid.cuboid, index)).collect()
}

/// The shadows on the top of a box.
fn on(solids: &[Solid], surface: &Cuboid, own: usize) -> Shadows {
    let height = surface.max[2];
    let mut shadows = Shadows::default();
    let (min, max) = ([surface.min[0], surface.min[1]], [surface.max[0], surface.max[1]]);
    for (index, solid) in solids.iter().enumerate() {
        let top = solid.cuboid.max[2] - height;
        if index == own || top < 1e-4 || solid.opacity < 1.0 || !reaches(&solid.cuboid, top, min, max) {
            continue;
        }
        let bottom = (solid.cuboid.min[2] - height).max(0.0);
        for (layer, way) in shadows.iter_mut().zip(LAMP) {
            let shadow = clipped(&swept(&solid.cuboid, way.map(|part| part * bottom), way.map(|part| part * top)), min, max);
            if shadow.len() > 2 {
                layer.push(shadow);
            }
        }
    }
    shadows
}

fn reaches(cuboid: &Cuboid, top: f64, min: [f64; 2], max: [f64; 2]) -> bool {
    let (right, down) = (0.46 * top, 0.30 * top);
    cuboid.min[0] < max[0] && cuboid.max[0] + right > min[0] && cuboid.min[1] - down < max[1] && cuboid.max[1] > min[1]
}

/// What the footprint of a box covers on the way from one offset to another that lies farther right and down; counterclockwise.
fn swept(cuboid: &Cuboid, from: [f64; 2], to: [f64; 2]) -> [[f64; 2]; 6] {
    let ([x0, y0, _], [x1, y1, _]) = (cuboid.min, cuboid.max);
    let at = |x: f64, y: f64, way: [f64; 2]| [x + way[0], y + way[1]];
    [at(x0, y0, from), at(x0, y0, to), at(x1, y0, to), at(x1, y1, to), at(x1, y1, from), at(x0, y1, from)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::colour::Rgb;

    fn solid(min: [f64; 3], max: [f64; 3]) -> Solid {
        Solid { object: 0, cuboid: Cuboid { min, max }, colour: Rgb::WHITE, opacity: 1.0 }
    }

    #[test]
    fn what_floats_throws_its_shadow_aside_and_what_stands_does_not_leave_it() {
        let floor = Cuboid { min: [-5.0, -5.0, 0.0], max: [5.0, 5.0, 0.0] };
        let left = |solids: &[Solid]| shadows(solids, &floor).0[0][0].iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
        assert_eq!(left(&[solid([0.0; 3], [1.0; 3])]), 0.0);
        assert!(left(&[solid([0.0, 0.0, 1.0], [1.0, 1.0, 2.0])]) > 0.4);
    }

    #[test]
    fn shadows_fall_on_lower_tops_only() {
        let solids = [solid([0.0; 3], [2.0, 2.0, 0.5]), solid([0.5, 0.5, 0.5], [1.0, 1.0, 1.0])];
        let (_, tops) = shadows(&solids, &Cuboid { min: [-5.0, -5.0, 0.0], max: [5.0, 5.0, 0.0] });
        assert!(tops[0].iter().all(|layer| layer.len() == 1) && tops[1].iter().all(Vec::is_empty));
    }
}
