//! The layout errors of single objects and pairs, term by term: what a search re-evaluates for the objects that it moved.

use crate::scene::{Anchor, Body, Cardinal, Kind, SceneInfo, Support, Target, Told, toward};

use super::rules::Rules;

/// The box of the scene. Metres, world coordinates.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bounds {
    /// The smallest coordinates: left, bottom, the ground.
    pub min: [f64; 3],
    /// The largest coordinates: right, top, the ceiling.
    pub max: [f64; 3],
    /// Whether there is a ceiling.
    pub interior: bool,
}

impl Bounds {
    /// The box of a scene.
    pub fn of(scene: &SceneInfo) -> Bounds {
        let [width, depth, height] = scene.size();
        let half = [0.5 * width, 0.5 * depth];
        Bounds { min: [-half[0], -half[1], 0.0], max: [half[0], half[1], height], interior: scene.interior }
    }

    fn size(&self) -> [f64; 3] {
        [2.0 * self.max[0], 2.0 * self.max[1], self.max[2]]
    }

    /// Distance from a body to a wall, by the wall's direction; negative beyond it.
    pub fn distance(&self, body: &Body, wall: Cardinal) -> f64 {
        match wall {
            Cardinal::XMax => self.max[0] - body.max[0],
            Cardinal::YMax => self.max[1] - body.max[1],
            Cardinal::XMin => body.min[0] - self.min[0],
            Cardinal::YMin => body.min[1] - self.min[1],
        }
    }
}

/// Whether the body is a rug: it overlaps nothing and stands in no one's way.
pub fn is_rug(rules: &Rules, body: &Body) -> bool {
    let ([width, depth, height], rug) = (body.dims, &rules.rug);
    height <= rug.ratio * width && height <= rug.ratio * depth && height < rug.height
}

/// How far one must move to part two boxes along each axis.
pub fn penetration(min: [f64; 3], max: [f64; 3], other: &Body) -> [f64; 3] {
    [0, 1, 2].map(|k| (max[k] - other.min[k]).min(other.max[k] - min[k]))
}

/// The extents that two boxes share, or `None` where they touch at most.
fn shared(rules: &Rules, min: [f64; 3], max: [f64; 3], other: &Body) -> Option<[f64; 3]> {
    let [x, y, z] = penetration(min, max, other);
    let closest = x.min(y).min(z);
    (closest >= rules.tolerance).then(|| [0, 1, 2].map(|k| max[k].min(other.max[k]) - min[k].max(other.min[k])))
}

/// The largest distance by which the body sticks out of the scene; not positive where it does not.
pub fn out_of_bounds(bounds: &Bounds, body: &Body) -> f64 {
    let below = [0, 1, 2].map(|k| bounds.min[k] - body.min[k]);
    let above = [0, 1, 2].map(|k| body.max[k] - bounds.max[k]);
    let sides = below[0].max(below[1]).max(below[2]).max(above[0]).max(above[1]);
    if bounds.interior { sides.max(above[2]) } else { sides }
}

/// The cube root of the volume that two bodies share, or `None` where they share none.
pub fn overlap(rules: &Rules, body: &Body, other: &Body) -> Option<f64> {
    if is_rug(rules, body) || is_rug(rules, other) {
        return None;
    }
    let [x, y, z] = shared(rules, body.min, body.max, other)?;
    Some(libm::pow(x * y * z, 1.0 / 3.0))
}

/// How far the top of `support` is from carrying the body: vertically, and the distance of the body's center from its footprint.
pub fn gap_to(body: &Body, support: &Body) -> (f64, f64) {
    let beside = |k: usize| (support.min[k] - body.center[k]).max(0.0) + (body.center[k] - support.max[k]).max(0.0);
    ((body.min[2] - support.max[2]).abs(), beside(0) + beside(1))
}

/// How far a standing body is from what could carry it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Gap {
    /// The distance; never more than the body's own height.
    pub metres: f64,
    /// The nearest support within that distance; the ground where there is none.
    pub support: Option<usize>,
}

impl Gap {
    /// The gap of the body numbered `index` before any other is looked at: to the ground.
    pub fn to_ground(body: &Body) -> Gap {
        let (own_height, _) = gap_to(body, body);
        Gap { metres: body.min[2].abs().min(own_height), support: None }
    }

    /// The gap where another body may carry it too. Among equals the ground comes first, then the first declared.
    pub fn or(self, body: &Body, index: usize, support: &Body) -> Gap {
        let (above, beside) = gap_to(body, support);
        let metres = above + beside;
        let tie = metres == self.metres && self.support.is_some_and(|known| index < known);
        if metres < self.metres || tie { Gap { metres, support: Some(index) } } else { self }
    }
}

/// The gap under a standing body, or `None` where it is carried. `supports` gives the other bodies that take part.
pub fn standing<'a>(rules: &Rules, body: &Body, supports: impl Iterator<Item = (usize, &'a Body)>) -> Option<Gap> {
    if body.support != Support::Standing || body.min[2].abs() < rules.tolerance {
        return None;
    }
    let gap = supports.fold(Gap::to_ground(body), |gap, (index, support)| gap.or(body, index, support));
    (gap.metres >= rules.tolerance).then_some(gap)
}

/// Distance of a body from the nearer wall of each pair: left and right, top and bottom.
pub fn wall_gaps(bounds: &Bounds, body: &Body) -> [f64; 2] {
    [0, 1].map(|k| (body.min[k] - bounds.min[k]).abs().min((bounds.max[k] - body.max[k]).abs()))
}

/// The distance of a mounted body from the nearest wall that its wider side can lie against.
pub fn mounted(bounds: &Bounds, body: &Body) -> Option<f64> {
    if body.support != Support::Mounted {
        return None;
    }
    let ([x, y], size) = (wall_gaps(bounds, body), body.size());
    Some(if size[0] > size[1] {
        y
    } else if size[0] < size[1] {
        x
    } else {
        x.min(y)
    })
}

/// For a body that was told to face something: where that lies. `at` gives the body of another object.
pub fn direction_told(bounds: &Bounds, body: &Body, at: impl Fn(usize) -> Body) -> Option<Cardinal> {
    match body.told {
        Told::Toward(Target::Scene) => Some(toward(body.center, [0.0, 0.0, 0.5 * bounds.max[2]], bounds.size())),
        Told::Toward(Target::Object(id)) => {
            let target = at(id.index());
            Some(toward(body.center, target.center, target.size()))
        }
        Told::Never | Told::Direction | Told::Point => None,
    }
}

/// The box that a door or window keeps free; `None` for other objects.
pub fn clearance_box(rules: &Rules, door: &Body) -> Option<([f64; 3], [f64; 3])> {
    let (width, sizes) = (door.dims[0], &rules.clearance);
    let reach = match door.kind {
        Kind::Object => return None,
        Kind::Door => sizes.door * width,
        Kind::Window => (sizes.window * width).min(sizes.window_most),
    };
    let (mut min, mut max, k) = (door.min, door.max, door.turn.axis().index());
    min[k] -= reach;
    max[k] += reach;
    Some((min, max))
}

/// The mean of the x and y overlap of a body with the clearance of a door or window, or `None` where it keeps out.
pub fn clearance(rules: &Rules, door: &Body, other: &Body) -> Option<f64> {
    let (min, max) = clearance_box(rules, door)?;
    if is_rug(rules, other) {
        return None;
    }
    let [x, y, _] = shared(rules, min, max, other)?;
    Some(0.5 * (x + y))
}

/// The walls that the body is anchored against, by their direction.
pub fn against(rules: &Rules, bounds: &Bounds, body: &Body) -> [bool; 4] {
    Cardinal::ALL.map(|wall| {
        let part = if matches!(wall, Cardinal::XMax | Cardinal::YMax) { Anchor::Max } else { Anchor::Min };
        body.anchors[wall.axis().index()] == Some(part) && bounds.distance(body, wall).abs() < rules.wall_tolerance
    })
}

/// Whether the body faces by what it was told or inferred, and not by a direction or point of the program.
fn is_free_to_turn(body: &Body) -> bool {
    body.directed && !matches!(body.told, Told::Direction | Told::Point)
}

/// Whether the body was turned to a wall that it is anchored against.
pub fn faces_wall(body: &Body, against: [bool; 4]) -> bool {
    is_free_to_turn(body) && against[body.turn.index()]
}

/// The wall that the body has its short side to, if it is anchored against just that one.
pub fn short_side(body: &Body, against: [bool; 4]) -> Option<Cardinal> {
    let mut walls = Cardinal::ALL.into_iter().filter(|wall| against[wall.index()]);
    let (Some(wall), None) = (walls.next(), walls.next()) else { return None };
    let [width, depth, _] = body.dims;
    let along = body.turn.axis() != wall.axis();
    let short = if along { width >= depth } else { depth > 2.0 * width };
    (is_free_to_turn(body) && short).then_some(wall)
}
