//! What is painted before what, so that near things hide far ones.
//!
//! Two boxes that do not share volume can be parted by a plane across an axis; the one on the eye's side of it is painted later. Boxes that
//! hang together in a circle, or that share volume, are taken apart: their sides are split at each other's planes until they can be sorted.

use super::camera::Camera;
use super::drawing::Point;
use super::solid::{Face, Solid};

/// Sides that belong together are split into at most so many parts; beyond it they are sorted by distance.
const MOST_PARTS: usize = 40_000;

/// At most so many pairs of boxes are looked at, and so many that are near each other on the page are compared; beyond it boxes are sorted by
/// distance.
const MOST_PAIRS: usize = 8_000_000;
const MOST_COMPARED: usize = 500_000;

/// The sides that the camera sees, far ones first. With each whether it is but a part of a side.
pub fn sorted(solids: &[Solid], camera: &Camera, tolerance: f64) -> Vec<Face> {
    let Some(eye) = camera.eye() else { return from_above(solids) };
    let mut faces = Vec::with_capacity(3 * solids.len());
    for group in groups(solids, camera, eye, tolerance) {
        let sides: Vec<Face> = group.iter().flat_map(|solid| seen(*solid, &solids[*solid], camera)).collect();
        match group.len() {
            1 => faces.extend(sides),
            _ => apart(sides, eye, tolerance, &mut faces),
        }
    }
    faces
}

/// Only tops are seen, and higher ones hide lower ones.
fn from_above(solids: &[Solid]) -> Vec<Face> {
    let mut faces: Vec<Face> = solids.iter().enumerate().map(|(index, solid)| Face::of(index, &solid.cuboid, 2, true)).collect();
    faces.sort_by(|a, b| a.at.total_cmp(&b.at));
    faces
}

fn seen(index: usize, solid: &Solid, camera: &Camera) -> impl Iterator<Item = Face> {
    let sides = (0..3).flat_map(move |axis| [false, true].map(|up| Face::of(index, &solid.cuboid, axis, up)));
    sides.filter(|face| camera.sees(face.axis, face.up, face.at))
}

/// The outline of a box on the page.
struct Outline {
    hull: Vec<Point>,
    min: Point,
    max: Point,
}

impl Outline {
    fn of(solid: &Solid, camera: &Camera) -> Outline {
        let points = solid.cuboid.corners().map(|corner| camera.project(corner));
        let (mut min, mut max) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
        for point in points {
            for k in 0..2 {
                min[k] = min[k].min(point[k]);
                max[k] = max[k].max(point[k]);
            }
        }
        Outline { hull: hull(points.to_vec()), min, max }
    }

    /// Whether the rectangles around two outlines meet.
    fn is_near(&self, other: &Outline) -> bool {
        (0..2).all(|k| self.min[k] < other.max[k] && other.min[k] < self.max[k])
    }

    /// Whether the outlines have at most borders in common.
    fn is_apart(&self, other: &Outline) -> bool {
        parted(&self.hull, &other.hull) || parted(&other.hull, &self.hull)
    }
}

/// Whether an edge of the first polygon has all of the second beyond it, within a twentieth of a pixel.
fn parted(a: &[Point], b: &[Point]) -> bool {
    (0..a.len()).any(|i| {
        let (from, to) = (a[i], a[(i + 1) % a.len()]);
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let slack = 0.05 * (dx.abs() + dy.abs());
        b.iter().all(|p| dx * (p[1] - from[1]) - dy * (p[0] - from[0]) <= slack)
    })
}

/// The convex hull, counterclockwise with y up.
pub fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let turn = |a: Point, b: Point, c: Point| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let chain = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for point in points {
            while chain.len() >= 2 && turn(chain[chain.len() - 2], chain[chain.len() - 1], point) <= 0.0 {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = chain(&mut points.iter().copied());
    hull.extend(chain(&mut points.iter().rev().copied()));
    hull
}

/// Whether `a` may hide a part of `b`: no plane between them has the eye on `b`'s side.
fn may_hide(a: &Solid, b: &Solid, eye: [f64; 3], tolerance: f64) -> bool {
    (0..3).all(|k| {
        let (a_min, a_max, b_min, b_max) = (a.cuboid.min[k], a.cuboid.max[k], b.cuboid.min[k], b.cuboid.max[k]);
        let below = a_max <= b_min + tolerance && eye[k] >= a_max.min(b_min) && a_min < b_min;
        let above = a_min >= b_max - tolerance && eye[k] <= a_min.max(b_max) && a_max > b_max;
        !below && !above
    })
}

/// The boxes in groups that can be painted one after the other.
fn groups(solids: &[Solid], camera: &Camera, eye: [f64; 3], tolerance: f64) -> Vec<Vec<usize>> {
    let outlines: Vec<Outline> = solids.iter().map(|solid| Outline::of(solid, camera)).collect();
    let mut by_left: Vec<usize> = (0..solids.len()).collect();
    by_left.sort_by(|a, b| outlines[*a].min[0].total_cmp(&outlines[*b].min[0]));
    // For each box those that must be painted before it.
    let mut before: Vec<Vec<usize>> = vec![Vec::new(); solids.len()];
    let (mut pairs, mut compared) = (0, 0);
    for (at, &a) in by_left.iter().enumerate() {
        for &b in by_left[at + 1..].iter().take_while(|b| outlines[**b].min[0] < outlines[a].max[0]) {
            pairs += 1;
            if !outlines[a].is_near(&outlines[b]) {
                continue;
            }
            compared += 1;
            if pairs > MOST_PAIRS || compared > MOST_COMPARED {
                return by_distance(solids, eye);
            }
            if outlines[a].is_apart(&outlines[b]) {
                continue;
            }
            if may_hide(&solids[a], &solids[b], eye, tolerance) {
                before[a].push(b);
            }
            if may_hide(&solids[b], &solids[a], eye, tolerance) {
                before[b].push(a);
            }
        }
    }
    before.iter_mut().for_each(|list| list.sort_unstable());
    components(&before)
}

fn by_distance(solids: &[Solid], eye: [f64; 3]) -> Vec<Vec<usize>> {
    let distance = |index: &usize| solids[*index].cuboid.center().iter().zip(eye).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
    let mut order: Vec<usize> = (0..solids.len()).collect();
    order.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
    order.into_iter().map(|index| vec![index]).collect()
}

/// The strongly connected components of a graph, those that others need first (Tarjan's algorithm, without recursion).
fn components(needs: &[Vec<usize>]) -> Vec<Vec<usize>> {
    const NEW: usize = usize::MAX;
    let count = needs.len();
    let (mut number, mut low, mut on_stack) = (vec![NEW; count], vec![0; count], vec![false; count]);
    let (mut stack, mut path, mut next, mut found) = (Vec::new(), Vec::new(), 0, Vec::new());
    for start in 0..count {
        if number[start] != NEW {
            continue;
        }
        path.push((start, 0));
        while let Some((node, edge)) = path.pop() {
            if edge == 0 {
                (number[node], low[node], on_stack[node]) = (next, next, true);
                next += 1;
                stack.push(node);
            }
            match needs[node].get(edge) {
                Some(&other) => {
                    path.push((node, edge + 1));
                    if number[other] == NEW {
                        path.push((other, 0));
                    } else if on_stack[other] {
                        low[node] = low[node].min(number[other]);
                    }
                }
                None => {
                    if let Some((parent, _)) = path.last() {
                        low[*parent] = low[*parent].min(low[node]);
                    }
                    if low[node] == number[node] {
                        let mut component = Vec::new();
                        while let Some(member) = stack.pop() {
                            on_stack[member] = false;
                            component.push(member);
                            if member == node {
                                break;
                            }
                        }
                        component.sort_unstable();
                        found.push(component);
                    }
                }
            }
        }
    }
    found
}

/// Sides that are to be sorted, and those of one plane that are.
enum Task {
    Sort(Vec<Face>),
    Done(Vec<Face>),
}

/// Sorts sides by splitting them at planes (a binary space partition), far ones first.
fn apart(sides: Vec<Face>, eye: [f64; 3], tolerance: f64, out: &mut Vec<Face>) {
    let most = out.len() + MOST_PARTS;
    let mut tasks = vec![Task::Sort(sides)];
    while let Some(task) = tasks.pop() {
        let mut sides = match task {
            Task::Sort(sides) if sides.len() > 1 => sides,
            Task::Sort(sides) | Task::Done(sides) => {
                out.extend(sides);
                continue;
            }
        };
        if out.len() + sides.len() > most {
            sides.sort_by(|a, b| distance(b, eye).total_cmp(&distance(a, eye)));
            out.extend(sides);
            continue;
        }
        let (axis, at) = plane(&sides, tolerance);
        let (mut below, mut on, mut above) = (Vec::new(), Vec::new(), Vec::new());
        for side in sides {
            let (low, high) = side.span(axis);
            if side.axis == axis && (side.at - at).abs() <= tolerance {
                on.push(side);
            } else if high <= at + tolerance {
                below.push(side);
            } else if low >= at - tolerance {
                above.push(side);
            } else {
                let (under, over) = side.split(axis, at);
                below.push(under);
                above.push(over);
            }
        }
        // Of what lies in one plane the lower is painted first; then the order of declaration.
        on.sort_by_key(|face| face.solid);
        let (far, near) = if eye[axis] > at { (below, above) } else { (above, below) };
        tasks.extend([Task::Sort(near), Task::Done(on), Task::Sort(far)]);
    }
}

fn distance(face: &Face, eye: [f64; 3]) -> f64 {
    let middle = face.point([0, 1].map(|k| 0.5 * (face.min[k] + face.max[k])));
    middle.iter().zip(eye).map(|(a, b)| (a - b) * (a - b)).sum()
}

/// The plane of a side that splits few others and leaves about as many on either hand.
fn plane(sides: &[Face], tolerance: f64) -> (usize, f64) {
    const TRIED: usize = 24;
    let step = sides.len().div_ceil(TRIED).max(1);
    let mut best = (usize::MAX, (sides[0].axis, sides[0].at));
    for candidate in sides.iter().step_by(step) {
        let (axis, at) = (candidate.axis, candidate.at);
        let (mut split, mut below, mut above) = (0_usize, 0_usize, 0_usize);
        for side in sides {
            let (low, high) = side.span(axis);
            if side.axis == axis && (side.at - at).abs() <= tolerance {
                continue;
            } else if high <= at + tolerance {
                below += 1;
            } else if low >= at - tolerance {
                above += 1;
            } else {
                split += 1;
            }
        }
        let cost = 4 * split + below.abs_diff(above);
        if cost < best.0 {
            best = (cost, (axis, at));
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::camera::Area;
    use crate::render::colour::Rgb;
    use crate::render::solid::Cuboid;
    use rand::{RngExt as _, SeedableRng};

    const ROOM: Cuboid = Cuboid { min: [-5.0, -5.0, 0.0], max: [5.0, 5.0, 4.0] };

    fn camera() -> Camera {
        Camera::perspective(&ROOM, &ROOM.corners(), Area { at: [0.0, 0.0], size: [400.0, 300.0] })
    }

    fn solid(min: [f64; 3], max: [f64; 3]) -> Solid {
        Solid { object: 0, cuboid: Cuboid { min, max }, colour: Rgb::WHITE, opacity: 1.0 }
    }

    fn holds(polygon: &[Point], at: Point) -> bool {
        let turns: Vec<f32> = (0..polygon.len())
            .map(|k| {
                let (a, b) = (polygon[k], polygon[(k + 1) % polygon.len()]);
                (b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0])
            })
            .collect();
        turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
    }

    /// The box that a ray meets first, and how far the next one is behind it.
    fn hit(solids: &[Solid], eye: [f64; 3], ray: [f64; 3]) -> Option<(usize, f64)> {
        let mut hits: Vec<(f64, usize)> = Vec::new();
        for (index, Solid { cuboid, .. }) in solids.iter().enumerate() {
            let ways = [0, 1, 2].map(|k| [(cuboid.min[k] - eye[k]) / ray[k], (cuboid.max[k] - eye[k]) / ray[k]]);
            let enter = ways.iter().map(|way| way[0].min(way[1])).fold(f64::NEG_INFINITY, f64::max);
            let leave = ways.iter().map(|way| way[0].max(way[1])).fold(f64::INFINITY, f64::min);
            if enter < leave {
                hits.push((enter, index));
            }
        }
        hits.sort_by(|a, b| a.0.total_cmp(&b.0));
        let gap = hits.get(1).map_or(f64::INFINITY, |next| next.0 - hits[0].0);
        hits.first().map(|first| (first.1, gap))
    }

    /// What is painted last at points of the page is what a ray meets first.
    fn assert_right(solids: &[Solid]) {
        let camera = camera();
        let eye = camera.eye().expect("an eye");
        let faces: Vec<(usize, Vec<Point>)> = sorted(solids, &camera, 1e-4)
            .iter()
            .map(|face| (face.solid, face.corners().map(|at| camera.project(face.point(at))).to_vec()))
            .collect();
        let mut looked = 0;
        for at in (0..60).flat_map(|x| (0..45).map(move |y| [x as f32 * 6.67 + 0.37, y as f32 * 6.67 + 0.41])) {
            let Some((expected, gap)) = hit(solids, eye, camera.ray(at)) else { continue };
            if gap < 0.01 {
                continue;
            }
            let last = faces.iter().rev().find(|(_, polygon)| holds(polygon, at)).map(|(solid, _)| *solid);
            looked += 1;
            assert!(last == Some(expected) || last.is_none(), "at {at:?}: {last:?} for {expected}");
        }
        assert!(looked > 20, "only {looked} points");
    }

    #[test]
    fn near_boxes_hide_far_ones_however_they_overlap() {
        let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(7);
        for _ in 0..25 {
            let count = random.random_range(2..40);
            let solids: Vec<Solid> = (0..count)
                .map(|_| {
                    let size: [f64; 3] = std::array::from_fn(|_| random.random_range(0.1..3.0));
                    let min: [f64; 3] = std::array::from_fn(|k| random.random_range(ROOM.min[k]..ROOM.max[k] - 0.5));
                    solid(min, [0, 1, 2].map(|k| min[k] + size[k]))
                })
                .collect();
            assert_right(&solids);
        }
    }

    #[test]
    fn three_beams_that_lie_on_each_other_in_a_circle_are_taken_apart() {
        let beams =
            [solid([-3.0, -1.0, 0.0], [3.0, 0.0, 1.0]), solid([1.0, -3.0, 1.0], [2.0, 3.0, 2.0]), solid([-3.0, 1.0, 0.5], [1.5, 2.0, 1.6])];
        assert_right(&beams);
    }

    #[test]
    fn boxes_on_each_other_and_in_each_other_are_right() {
        let stack = [
            solid([-2.0, -2.0, 0.0], [2.0, 2.0, 1.0]),
            solid([-1.0, -1.0, 1.0], [1.0, 1.0, 1.5]),
            solid([-0.5, -0.5, 0.2], [0.5, 0.5, 3.0]),
            solid([-4.9, -4.9, 0.0], [4.9, 4.9, 0.02]),
        ];
        assert_right(&stack);
    }
}
