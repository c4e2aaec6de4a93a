//! Boxes as they are seen: sides under light, shadows and arrows on tops, leaves of doors and panes of windows.

use crate::scene::{Cardinal, Kind, Told};

use super::camera::Camera;
use super::colour::Rgb;
use super::drawing::{Contour, Drawing, Paint, Part, Shape, Stroke};
use super::shadow::Shadows;
use super::solid::{Face, Solid, Space};
use super::stage::{axis_of, cut};

/// Light on the sides across x and y, and on tops.
const LIGHT: [f64; 3] = [0.72, 0.87, 1.04];

/// Paints bodies.
pub struct Painter<'a> {
    /// The scene.
    pub space: &'a Space<'a>,
    /// The view.
    pub camera: &'a Camera,
    /// The shadows on tops.
    pub shadows: &'a [Shadows],
    /// Each of the lamp's directions darkens by this.
    pub shade: Paint,
    /// The object that is pointed out, and the colour that the others fade to.
    pub highlight: Option<(u32, Rgb)>,
    /// How wide edges are, in pixels.
    pub line: f32,
}

impl Painter<'_> {
    /// The colour of a body; what is not pointed out fades.
    pub fn colour(&self, solid: &Solid) -> Rgb {
        match self.highlight {
            Some((object, paper)) if object != solid.object => solid.colour.mix(solid.colour.grey(), 0.35).mix(paper, 0.55),
            _ => solid.colour,
        }
    }

    /// Paints a part of a side, with what is drawn on it.
    pub fn face(&self, out: &mut Drawing, solids: &[Solid], face: &Face) {
        let solid = &solids[face.solid];
        let whole = Face::of(face.solid, &solid.cuboid, face.axis, face.up);
        let colour = self.colour(solid).lit(LIGHT[face.axis]);
        let points = |polygon: &[[f64; 2]]| polygon.iter().map(|at| self.camera.project(face.point(*at))).collect::<Vec<_>>();
        let body = Part::Body(solid.object);
        // Parts of a side are drawn a little larger, so that no gap is seen between them.
        let seam = (*face != whole && solid.opacity >= 1.0).then(|| Stroke::solid(colour, 0.7));
        out.area(body, points(&face.corners()), Some(colour.over(solid.opacity)), seam);
        let on = Part::On(solid.object);
        for (polygon, paint) in self.details(solid, &whole) {
            if let Some(polygon) = cut(&polygon, face.min, face.max) {
                out.fill(on, points(&polygon), Paint { opacity: paint.opacity * solid.opacity, ..paint });
            }
        }
        if face.axis == 2 && face.up {
            self.shadow(out, face, on);
            if let Some(arrow) = self.arrow(solid, &whole).and_then(|arrow| cut(&arrow, face.min, face.max)) {
                out.fill(on, points(&arrow), colour.ink().over(0.62 * solid.opacity));
            }
        }
        let size = self.camera.metre(solid.cuboid.center()) * (0..3).map(|k| solid.cuboid.max[k] - solid.cuboid.min[k]).fold(0.0, f64::max);
        let width = self.line * (size / 14.0).clamp(0.3, 1.0) as f32;
        let edges = edges(face, &whole).map(|edge| points(&edge));
        out.lines(on, edges, Stroke::solid(self.colour(solid).lit(0.5).over(0.9 * solid.opacity.max(0.6)), width));
    }

    fn shadow(&self, out: &mut Drawing, face: &Face, part: Part) {
        for layer in self.shadows.get(face.solid).into_iter().flatten() {
            let polygons = layer.iter().filter_map(|polygon| cut(polygon, face.min, face.max));
            let contours: Vec<Contour> = polygons
                .map(|polygon| Contour { points: polygon.iter().map(|at| self.camera.project(face.point(*at))).collect(), closed: true })
                .collect();
            if !contours.is_empty() {
                out.add(part, Shape::Path { contours, fill: Some(self.shade), stroke: None });
            }
        }
    }

    /// The arrow on a top that tells where an object faces: a triangle at its front.
    fn arrow(&self, solid: &Solid, top: &Face) -> Option<Vec<[f64; 2]>> {
        let body = self.space.body(solid.object);
        let pixels = self.camera.metre(top.point(top.min));
        let size = [top.max[0] - top.min[0], top.max[1] - top.min[1]];
        let length = (0.30 * size[0].min(size[1])).min(0.055 * self.space.longest());
        let told = body.directed || body.told != Told::Never;
        if body.kind != Kind::Object || !told || length * pixels < 2.2 {
            return None;
        }
        let axis = axis_of(body.turn);
        let sign = if matches!(body.turn, Cardinal::XMax | Cardinal::YMax) { 1.0 } else { -1.0 };
        let middle = [0, 1].map(|k| 0.5 * (top.min[k] + top.max[k]));
        let front = if sign > 0.0 { top.max[axis] } else { top.min[axis] };
        let tip = front - sign * 0.25 * length;
        let point = |along: f64, aside: f64| {
            let mut at = middle;
            at[axis] = along;
            at[1 - axis] += aside;
            at
        };
        let base = tip - sign * length;
        Some(vec![point(tip, 0.0), point(base, 0.62 * length), point(base + sign * 0.25 * length, 0.0), point(base, -0.62 * length)])
    }

    /// Leaves and panes on the broad sides of doors and windows.
    fn details(&self, solid: &Solid, side: &Face) -> Vec<(Vec<[f64; 2]>, Paint)> {
        let body = self.space.body(solid.object);
        let colour = self.colour(solid);
        if body.kind == Kind::Object {
            return Vec::new();
        }
        let at = |u: [f64; 2], v: [f64; 2]| {
            let point = |u: f64, v: f64| [side.min[0] + u * (side.max[0] - side.min[0]), side.min[1] + v * (side.max[1] - side.min[1])];
            vec![point(u[0], v[0]), point(u[1], v[0]), point(u[1], v[1]), point(u[0], v[1])]
        };
        if side.axis == 2 {
            // A plan shows the pane of a window as a bright line.
            let along = axis_of(body.turn);
            let (pane, line) = ([0.04, 0.96], [0.38, 0.62]);
            let polygon = if along == 0 { at(line, pane) } else { at(pane, line) };
            return if body.kind == Kind::Window { vec![(polygon, Rgb::WHITE.over(0.75))] } else { Vec::new() };
        }
        if side.axis != axis_of(body.turn) {
            return Vec::new();
        }
        match body.kind {
            Kind::Window => {
                let glass = colour.mix(Rgb::WHITE, 0.55).over(0.9);
                let wide = (side.max[0] - side.min[0]) > 1.2 * (side.max[1] - side.min[1]);
                let columns = if wide { [[0.05, 0.48], [0.52, 0.95]] } else { [[0.08, 0.47], [0.53, 0.92]] };
                columns.into_iter().flat_map(|u| [[0.07, 0.48], [0.52, 0.93]].map(|v| (at(u, v), glass))).collect()
            }
            _ => {
                let deep = colour.lit(LIGHT[side.axis] * 0.8).over(1.0);
                let knob = colour.ink().over(0.8);
                vec![(at([0.16, 0.84], [0.08, 0.44]), deep), (at([0.16, 0.84], [0.52, 0.93]), deep), (at([0.87, 0.94], [0.46, 0.5]), knob)]
            }
        }
    }
}

/// The borders of a part of a side that are borders of the side.
fn edges(face: &Face, whole: &Face) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let corners = face.corners();
    let same = [face.min[1] == whole.min[1], face.max[0] == whole.max[0], face.max[1] == whole.max[1], face.min[0] == whole.min[0]];
    (0..4).filter(move |k| same[*k]).map(move |k| [corners[k], corners[(k + 1) % 4]])
}
