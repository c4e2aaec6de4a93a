//! Layout errors drawn where they are: what two boxes share, what sticks out, how far it is to a support or a wall.

use crate::check::measure;
use crate::check::{ErrorKind, Rules, Violation};
use crate::scene::{Body, Cardinal, Target, Told};

use super::camera::Camera;
use super::colour::{Ink, Rgb};
use super::drawing::{Drawing, Part, Point, Shape, Stroke};
use super::font::Face as Letters;
use super::labels::Board;
use super::order::hull;
use super::solid::{Cuboid, Face, Space};
use super::stage::axis_of;
use super::text::metres;

/// Draws errors in one view.
pub struct Marker<'a> {
    /// The scene.
    pub space: &'a Space<'a>,
    /// The view.
    pub camera: &'a Camera,
    /// What counts.
    pub rules: &'a Rules,
    /// The colours of the page.
    pub ink: Ink,
    /// The size of letters in pixels; no lengths are written where it is too small.
    pub unit: f32,
}

/// A dashed measure between two points of the world, and what is written at it.
struct Measure {
    from: [f64; 3],
    to: [f64; 3],
    length: f64,
}

impl Marker<'_> {
    /// Draws an error, and tells where it is on the page.
    pub fn mark(&self, out: &mut Drawing, board: &mut Board, violation: &Violation) -> Option<Point> {
        let body = self.space.body(violation.culprit);
        let other = violation.other.map(|other| self.space.body(other));
        let center = Cuboid { min: body.min, max: body.max }.cut(&self.space.limits)?.center();
        let at = match (violation.kind, other) {
            (ErrorKind::Overlap, Some(other)) => self.volume(out, &shared(body.min, body.max, other)?),
            (ErrorKind::Clearance, Some(other)) => {
                let (min, max) = measure::clearance_box(self.rules, body)?;
                self.volume(out, &shared(min, max, other)?)
            }
            (ErrorKind::OutOfBounds, _) => self.protrusions(out, body),
            (ErrorKind::Standing, _) => self.standing(out, board, body, violation.support.map(|index| self.space.body(index))),
            (ErrorKind::Mounted, _) => self.mounted(out, board, body),
            (ErrorKind::Facing, _) => self.facing(out, body),
            (ErrorKind::FacingWall, _) => self.way(out, body, body.turn),
            (ErrorKind::ShortSide, _) => self.short_side(out, body),
            _ => Some(center),
        };
        Some(self.camera.project(at.unwrap_or(center)))
    }

    /// A volume that shines through what is before it.
    fn volume(&self, out: &mut Drawing, cuboid: &Cuboid) -> Option<[f64; 3]> {
        let cuboid = cuboid.cut(&self.space.limits)?;
        let tone = self.ink.error;
        let sides: Vec<Face> = (0..3).flat_map(|axis| [false, true].map(|up| Face::of(0, &cuboid, axis, up))).collect();
        let seen = |face: &Face| self.camera.sees(face.axis, face.up, face.at);
        let points = |face: &Face| face.corners().map(|at| self.camera.project(face.point(at))).to_vec();
        let outline = hull(cuboid.corners().map(|corner| self.camera.project(corner)).to_vec());
        if outline.len() > 2 {
            out.area(Part::Mark, outline, Some(tone.over(0.34)), Some(Stroke::solid(tone, 1.5)));
        }
        for face in sides.iter().filter(|face| seen(face)) {
            out.area(Part::Mark, points(face), None, Some(Stroke::solid(tone.over(0.85), 0.8)));
        }
        Some(cuboid.center())
    }

    fn protrusions(&self, out: &mut Drawing, body: &Body) -> Option<[f64; 3]> {
        let bounds = &self.space.bounds;
        let mut worst: (f64, Option<[f64; 3]>) = (0.0, None);
        for axis in 0..3 {
            let whole = Cuboid { min: body.min, max: body.max };
            let (mut low, mut high) = (whole, whole);
            low.max[axis] = low.max[axis].min(bounds.min[axis]);
            high.min[axis] = high.min[axis].max(bounds.max[axis]);
            let above = if axis < 2 || bounds.interior { body.max[axis] - bounds.max[axis] } else { 0.0 };
            for (part, by) in [(low, bounds.min[axis] - body.min[axis]), (high, above)] {
                if by < 0.004 {
                    continue;
                }
                let at = self.volume(out, &part);
                if by > worst.0 {
                    worst = (by, at);
                }
            }
        }
        worst.1
    }

    fn standing(&self, out: &mut Drawing, board: &mut Board, body: &Body, support: Option<&Body>) -> Option<[f64; 3]> {
        let bottom = [body.center[0], body.center[1], body.min[2]];
        let top = support.map_or(0.0, |support| support.max[2]);
        let mut foot = [bottom[0], bottom[1], top];
        if let Some(support) = support {
            (0..2).for_each(|k| foot[k] = foot[k].clamp(support.min[k], support.max[k]));
        }
        let below = [bottom[0], bottom[1], top];
        self.footprint(out, body, top);
        let (drop, aside) = ((bottom[2] - top).abs(), (foot[0] - below[0]).abs() + (foot[1] - below[1]).abs());
        if drop >= self.rules.tolerance {
            self.measure(out, board, &Measure { from: bottom, to: below, length: drop });
        }
        if aside >= self.rules.tolerance {
            self.measure(out, board, &Measure { from: below, to: foot, length: aside });
        }
        Some([0, 1, 2].map(|k| 0.5 * (bottom[k] + below[k])))
    }

    /// Where a body would stand.
    fn footprint(&self, out: &mut Drawing, body: &Body, z: f64) {
        let Some(cuboid) = (Cuboid { min: body.min, max: body.max }).cut(&self.space.limits) else { return };
        let flat = Face { at: z, ..Face::of(0, &cuboid, 2, true) };
        let points = flat.corners().map(|at| self.camera.project(flat.point(at))).to_vec();
        out.area(Part::Mark, points, Some(self.ink.error.over(0.12)), Some(Stroke::dashed(self.ink.error, 1.3, 4.0)));
    }

    fn mounted(&self, out: &mut Drawing, board: &mut Board, body: &Body) -> Option<[f64; 3]> {
        let ([x, y], size) = (measure::wall_gaps(&self.space.bounds, body), body.size());
        let axis = if size[0] > size[1] || (size[0] == size[1] && y < x) { 1 } else { 0 };
        let (low, high) = (body.min[axis] - self.space.bounds.min[axis], self.space.bounds.max[axis] - body.max[axis]);
        let mut from = body.center;
        let mut to = body.center;
        if low.abs() <= high.abs() {
            (from[axis], to[axis]) = (body.min[axis], self.space.bounds.min[axis]);
        } else {
            (from[axis], to[axis]) = (body.max[axis], self.space.bounds.max[axis]);
        }
        self.measure(out, board, &Measure { from, to, length: low.abs().min(high.abs()) });
        Some([0, 1, 2].map(|k| 0.5 * (from[k] + to[k])))
    }

    fn measure(&self, out: &mut Drawing, board: &mut Board, measure: &Measure) {
        let (a, b) = (self.camera.project(measure.from), self.camera.project(measure.to));
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let long = dx.hypot(dy);
        if long < 3.0 || !long.is_finite() {
            return;
        }
        let tone = self.ink.error;
        out.line(Part::Mark, vec![a, b], Stroke::solid(self.ink.paper.over(0.8), 3.6));
        out.line(Part::Mark, vec![a, b], Stroke::dashed(tone, 1.6, 4.5));
        let (nx, ny) = (-dy / long * 4.0, dx / long * 4.0);
        let tick = |p: Point| vec![[p[0] - nx, p[1] - ny], [p[0] + nx, p[1] + ny]];
        out.lines(Part::Mark, [tick(a), tick(b)], Stroke::solid(tone, 1.6));
        if self.unit >= 9.0 {
            let middle = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
            board.write_near(out, middle, &metres(measure.length), self.unit * 0.76, Letters::Bold, tone);
        }
    }

    /// An arrow from the middle of a top.
    fn way(&self, out: &mut Drawing, body: &Body, turn: Cardinal) -> Option<[f64; 3]> {
        let axis = axis_of(turn);
        let sign = if matches!(turn, Cardinal::XMax | Cardinal::YMax) { 1.0 } else { -1.0 };
        let from = [body.center[0], body.center[1], body.max[2]];
        let mut to = from;
        to[axis] += sign * (0.5 * body.size()[axis] + 0.02 * self.space.longest());
        self.arrow(out, from, to, self.ink.error, false);
        Some(from)
    }

    fn facing(&self, out: &mut Drawing, body: &Body) -> Option<[f64; 3]> {
        let from = [body.center[0], body.center[1], body.max[2]];
        let target = match body.told {
            Told::Toward(Target::Object(id)) => self.space.body(id.0).center,
            _ => self.space.floor().center(),
        };
        self.arrow(out, from, target, self.ink.mild, true);
        self.way(out, body, body.turn)
    }

    fn arrow(&self, out: &mut Drawing, from: [f64; 3], to: [f64; 3], tone: Rgb, dashed: bool) {
        let (a, b) = (self.camera.project(from), self.camera.project(to));
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let long = dx.hypot(dy);
        if long < 2.0 || !long.is_finite() {
            return;
        }
        let head = 7.0_f32.min(long * 0.6);
        let (ux, uy) = (dx / long, dy / long);
        let neck = [b[0] - ux * head, b[1] - uy * head];
        let stroke = if dashed { Stroke::dashed(tone, 1.5, 5.0) } else { Stroke::solid(tone, 2.2) };
        out.line(Part::Mark, vec![a, neck], stroke);
        let half = head * 0.5;
        out.fill(Part::Mark, vec![b, [neck[0] - uy * half, neck[1] + ux * half], [neck[0] + uy * half, neck[1] - ux * half]], tone);
    }

    /// The side that stands to the wall.
    fn short_side(&self, out: &mut Drawing, body: &Body) -> Option<[f64; 3]> {
        let against = measure::against(self.rules, &self.space.bounds, body);
        let wall = Cardinal::ALL.into_iter().find(|wall| against[wall.index()])?;
        let axis = axis_of(wall);
        let face = Face::of(0, &Cuboid { min: body.min, max: body.max }, axis, matches!(wall, Cardinal::XMax | Cardinal::YMax));
        let points = face.corners().map(|at| self.camera.project(face.point(at))).to_vec();
        out.area(Part::Mark, points, Some(self.ink.error.over(0.3)), Some(Stroke::solid(self.ink.error, 2.0)));
        Some([body.center[0], body.center[1], body.max[2]])
    }

    /// A number on the page that the list explains.
    pub fn badge(&self, out: &mut Drawing, board: &mut Board, at: Point, number: usize) {
        let radius = self.unit * 0.5;
        let at = board.free_disc(at, radius + 1.0);
        badge(out, at, radius, number, self.ink.error);
    }

    /// An object of which x or y was never written: an outline where it would stand.
    pub fn ghosts(&self, out: &mut Drawing) {
        for ghost in &self.space.ghosts {
            let outline = hull(ghost.cuboid.corners().map(|corner| self.camera.project(corner)).to_vec());
            if outline.len() > 2 {
                let part = Part::Body(ghost.object);
                let line = Stroke::dashed(self.ink.faint, 1.2, 3.5);
                out.area(part, outline, Some(ghost.colour.over(0.16)), Some(line));
            }
        }
    }
}

/// A number in a disc.
pub fn badge(out: &mut Drawing, at: Point, radius: f32, number: usize, tone: Rgb) {
    let rim = Stroke::solid(Rgb::WHITE.over(0.9), 1.2);
    out.add(Part::Mark, Shape::Disc { at, radius, fill: tone.into(), stroke: Some(rim) });
    let text = number.to_string();
    let size = radius * if text.len() < 2 { 1.25 } else { 1.3 / (0.45 * text.len() as f32 + 0.25) };
    super::labels::centered(out, Part::Mark, at, &text, size, Letters::Bold, tone.ink());
}

/// What a box shares with a body.
fn shared(min: [f64; 3], max: [f64; 3], other: &Body) -> Option<Cuboid> {
    Cuboid { min, max }.cut(&Cuboid { min: other.min, max: other.max })
}
