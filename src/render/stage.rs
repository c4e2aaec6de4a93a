//! What the objects stand in: floor, walls cut away toward the viewer, a grid of metres, the scale, and what doors and windows keep free.

use crate::check::Rules;
use crate::check::measure;
use crate::scene::{Axis, Cardinal, Kind, SceneInfo};

use super::camera::{Area, Camera};
use super::colour::{self, Ink, Rgb};
use super::drawing::{Align, Contour, Drawing, Paint, Part, Point, Shape, Stroke, Text};
use super::font::Face;
use super::shadow::Layer;
use super::solid::{Cuboid, Space, clipped};

/// Paints the stage of one view.
pub struct Stage<'a> {
    /// The scene.
    pub space: &'a Space<'a>,
    /// The view.
    pub camera: &'a Camera,
    /// The colours of the page.
    pub ink: Ink,
    /// Whether the page is dark: then the stage is dimmed a little.
    pub dark: bool,
    /// The size of letters in pixels.
    pub unit: f32,
}

/// A length of 1, 2 or 5 times a power of ten, not above another.
pub fn round_length(most: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10(most.max(1e-9))));
    [5.0, 2.0, 1.0].into_iter().map(|step| step * power).find(|length| *length <= most * 1.000_001).unwrap_or(power)
}

/// A polygon in x and y at a height.
fn flat(camera: &Camera, polygon: &[[f64; 2]], z: f64) -> Vec<Point> {
    polygon.iter().map(|[x, y]| camera.project([*x, *y, z])).collect()
}

fn rectangle(min: [f64; 3], max: [f64; 3]) -> [[f64; 2]; 4] {
    [[min[0], min[1]], [max[0], min[1]], [max[0], max[1]], [min[0], max[1]]]
}

impl Stage<'_> {
    fn toned(&self, colour: Rgb) -> Rgb {
        if self.dark { colour.mix(self.ink.paper, 0.28) } else { colour }
    }

    /// Floor and walls.
    pub fn ground(&self, out: &mut Drawing) {
        let scene: &SceneInfo = &self.space.layout.scene;
        let (min, max, t) = (self.space.bounds.min, self.space.bounds.max, self.space.thickness());
        let (floor, wall) = (self.toned(colour::floor(scene)), self.toned(colour::wall(scene)));
        let around = if scene.interior { t } else { 0.0 };
        let (low, high) = ([min[0] - around, min[1] - around, 0.0], [max[0] + around, max[1] + around, 0.0]);
        if self.camera.eye().is_some() {
            let slab = |out: &mut Drawing, a: [f64; 2], b: [f64; 2], light: f64| {
                let corners = [[a[0], a[1], 0.0], [b[0], b[1], 0.0], [b[0], b[1], -t], [a[0], a[1], -t]];
                self.plain(out, &corners, floor.lit(light));
            };
            slab(out, [low[0], low[1]], [high[0], low[1]], 0.62);
            slab(out, [high[0], low[1]], [high[0], high[1]], 0.5);
        }
        if scene.interior {
            let cut = wall.lit(if self.dark { 0.75 } else { 0.62 });
            out.fill(Part::Page, flat(self.camera, &rectangle(low, high), 0.0), cut);
        }
        let edge = Stroke::solid(floor.lit(0.6), 1.0);
        out.area(Part::Page, flat(self.camera, &rectangle(min, max), 0.0), Some(floor.into()), Some(edge));
        self.grid(out, floor);
        if scene.interior && self.camera.eye().is_some() {
            self.walls(out, wall, t);
        }
    }

    fn plain(&self, out: &mut Drawing, corners: &[[f64; 3]], colour: Rgb) {
        let points = corners.iter().map(|corner| self.camera.project(*corner)).collect();
        out.area(Part::Page, points, Some(colour.into()), Some(Stroke::solid(colour.lit(0.85), 0.6)));
    }

    /// The far walls: left and back.
    fn walls(&self, out: &mut Drawing, wall: Rgb, t: f64) {
        let ([x0, y0, _], [x1, y1, h]) = (self.space.bounds.min, self.space.bounds.max);
        self.plain(out, &[[x0, y0, 0.0], [x0, y1, 0.0], [x0, y1, h], [x0, y0, h]], wall.lit(0.88));
        self.plain(out, &[[x0, y1, 0.0], [x1, y1, 0.0], [x1, y1, h], [x0, y1, h]], wall.lit(0.97));
        let cut = wall.lit(if self.dark { 0.75 } else { 0.62 });
        let top = [[x0 - t, y0 - t, h], [x0, y0 - t, h], [x0, y1, h], [x1 + t, y1, h], [x1 + t, y1 + t, h], [x0 - t, y1 + t, h]];
        self.plain(out, &[[x0 - t, y0 - t, 0.0], [x0, y0 - t, 0.0], [x0, y0 - t, h], [x0 - t, y0 - t, h]], cut);
        self.plain(out, &[[x0, y0 - t, 0.0], [x0, y0, 0.0], [x0, y0, h], [x0, y0 - t, h]], cut.lit(0.9));
        self.plain(out, &[[x1 + t, y1, 0.0], [x1 + t, y1 + t, 0.0], [x1 + t, y1 + t, h], [x1 + t, y1, h]], cut.lit(0.9));
        self.plain(out, &[[x1, y1, 0.0], [x1 + t, y1, 0.0], [x1 + t, y1, h], [x1, y1, h]], cut);
        self.plain(out, &top, cut.lit(1.12));
    }

    fn grid(&self, out: &mut Drawing, floor: Rgb) {
        let ([x0, y0, _], [x1, y1, _]) = (self.space.bounds.min, self.space.bounds.max);
        let step = self.grid_step();
        let lines = |from: f64, to: f64| {
            let count = libm::floor((to - from) / step).min(400.0) as usize;
            (1..=count).map(move |at| from + at as f64 * step).filter(move |at| to - at > 1e-6 * step)
        };
        let across = lines(x0, x1).map(|x| vec![self.camera.project([x, y0, 0.0]), self.camera.project([x, y1, 0.0])]);
        let along = lines(y0, y1).map(|y| vec![self.camera.project([x0, y, 0.0]), self.camera.project([x1, y, 0.0])]);
        out.lines(Part::Page, across.chain(along), Stroke::solid(floor.lit(if self.dark { 1.12 } else { 0.9 }), 0.8));
    }

    /// How far the lines of the grid are apart: a metre, or more where that would be too fine.
    fn grid_step(&self) -> f64 {
        let pixels = self.camera.metre(self.space.floor().center());
        let finest = 14.0 / pixels.max(1e-9);
        [1.0, 2.0, 5.0].into_iter().find(|step| *step >= finest).unwrap_or_else(|| round_length(finest * 2.0))
    }

    /// The shadows on the floor.
    pub fn shadows(&self, out: &mut Drawing, layers: &[Layer], dark: Paint) {
        for layer in layers.iter().filter(|layer| !layer.is_empty()) {
            let contours = layer.iter().map(|polygon| Contour { points: flat(self.camera, polygon, 0.0), closed: true }).collect();
            out.add(Part::Page, Shape::Path { contours, fill: Some(dark), stroke: None });
        }
    }

    /// What doors and windows keep free, hatched on the floor. `blocked` tells whether something stands there.
    pub fn clearances(&self, out: &mut Drawing, rules: &Rules, blocked: &dyn Fn(usize) -> bool) {
        for (index, object) in self.space.layout.objects.iter().enumerate() {
            let body = &object.body;
            let Some((min, max)) = measure::clearance_box(rules, body).filter(|_| body.is_placed()) else { continue };
            let Some(free) = (Cuboid { min, max }).cut(&Cuboid { min: self.space.bounds.min, max: self.space.bounds.max }) else {
                continue;
            };
            let tone = if blocked(index) { self.ink.error } else { self.ink.accent };
            let strength = if body.kind == Kind::Door { 0.75 } else { 0.45 };
            let outline = flat(self.camera, &rectangle(free.min, free.max), 0.0);
            let dash = Stroke::dashed(tone.over(strength), 1.0, 4.0);
            out.area(Part::Page, outline, Some(tone.over(0.07)), Some(dash));
            let step = 8.0 / self.camera.metre(free.center()).max(1e-9);
            let lines = hatch(&free, step).map(|[a, b]| flat(self.camera, &[a, b], 0.0));
            out.lines(Part::Page, lines, Stroke::solid(tone.over(strength * 0.6), 0.8));
        }
    }

    /// The marks of a plan on doors and windows: how a door swings, and the pane of a window. Seen from above only.
    pub fn plan_marks(&self, out: &mut Drawing) {
        for (index, object) in self.space.layout.objects.iter().enumerate() {
            let body = &object.body;
            if self.camera.eye().is_some() || body.kind != Kind::Door || !body.is_placed() {
                continue;
            }
            let width = body.dims[0];
            let (along, sign) = match body.turn {
                Cardinal::XMax => ([1.0, 0.0], [0.0, 1.0]),
                Cardinal::YMax => ([0.0, 1.0], [-1.0, 0.0]),
                Cardinal::XMin => ([-1.0, 0.0], [0.0, -1.0]),
                Cardinal::YMin => ([0.0, -1.0], [1.0, 0.0]),
            };
            let front = 0.5 * body.dims[1];
            let hinge = [0, 1].map(|k| body.center[k] + along[k] * front + sign[k] * 0.5 * width);
            let arc: Vec<[f64; 2]> = (0..=16)
                .map(|step| {
                    let angle = f64::from(step) / 16.0 * std::f64::consts::FRAC_PI_2;
                    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                    [0, 1].map(|k| hinge[k] + width * (cos * along[k] - sin * sign[k]))
                })
                .collect();
            let leaf = vec![self.camera.project([hinge[0], hinge[1], 0.0]), self.camera.project([arc[0][0], arc[0][1], 0.0])];
            let tone = self.ink.text.over(0.55);
            let part = Part::On(index as u32);
            out.line(part, leaf, Stroke::solid(tone, 1.4));
            out.line(part, flat(self.camera, &arc, 0.0), Stroke::solid(tone, 0.8));
        }
    }

    /// A scale at the front edge of the floor, or below the plan.
    pub fn scale(&self, out: &mut Drawing, area: Area) {
        let ([x0, y0, _], [x1, _, _]) = (self.space.bounds.min, self.space.bounds.max);
        let length = round_length((x1 - x0) * 0.3);
        let off = self.space.thickness() * 2.6;
        let at = |x: f64| self.camera.project([x, y0 - off, 0.0]);
        let (from, to) = (at(x0), at(x0 + length));
        let lowest = area.at[1] + area.size[1];
        let tick = self.unit * 0.28;
        let stroke = Stroke::solid(self.ink.faint, 1.2);
        out.line(Part::Page, vec![[from[0], from[1] - tick], from, to, [to[0], to[1] - tick]], stroke);
        let middle = [(from[0] + to[0]) / 2.0, ((from[1] + to[1]) / 2.0 + self.unit * 1.05).min(lowest)];
        let text = if length >= 1.0 { format!("{length} m") } else { format!("{} cm", (length * 100.0 * 1000.0).round() / 1000.0) };
        let size = self.unit * 0.78;
        out.text(Part::Page, Text { at: middle, align: Align::Middle, text, size, face: Face::Sans, colour: self.ink.faint, halo: None });
    }
}

/// Lines at 45° across a rectangle of the floor.
fn hatch(area: &Cuboid, step: f64) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let ([x0, y0, _], [x1, y1, _]) = (area.min, area.max);
    let count = libm::floor((x1 - x0 + y1 - y0) / step).min(200.0) as usize;
    (1..=count).filter_map(move |line| {
        let sum = x0 + y0 + line as f64 * step;
        let (from, to) = ((sum - y1).max(x0), (sum - y0).min(x1));
        (from < to).then_some([[from, sum - from], [to, sum - to]])
    })
}

/// A polygon of a plane cut to a rectangle of it, for what is drawn on a part of a side.
pub fn cut(polygon: &[[f64; 2]], min: [f64; 2], max: [f64; 2]) -> Option<Vec<[f64; 2]>> {
    let cut = clipped(polygon, min, max);
    (cut.len() > 2).then_some(cut)
}

/// The name of an axis that a cardinal lies along, as a number.
pub fn axis_of(turn: Cardinal) -> usize {
    match turn.axis() {
        Axis::X => 0,
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_lengths_are_one_two_or_five() {
        assert_eq!([0.9, 1.0, 3.3, 7.0, 42.0].map(round_length), [0.5, 1.0, 2.0, 5.0, 20.0]);
    }

    #[test]
    fn a_hatch_stays_inside() {
        let area = Cuboid { min: [1.0, 2.0, 0.0], max: [2.0, 4.0, 0.0] };
        let lines: Vec<_> = hatch(&area, 0.25).collect();
        assert_eq!(lines.len(), 11);
        assert!(lines.iter().flatten().all(|[x, y]| (1.0..=2.0).contains(x) && (2.0..=4.0).contains(y)));
    }
}
