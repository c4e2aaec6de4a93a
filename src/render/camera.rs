//! From the world to the page: straight from above, or in perspective from the front right.

use super::drawing::Point;
use super::solid::Cuboid;

/// A rectangle of the page, in pixels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Area {
    /// Its upper left corner.
    pub at: Point,
    /// Its width and height.
    pub size: Point,
}

impl Area {
    /// The area without a border.
    pub fn inset(&self, by: f32) -> Area {
        Area { at: [self.at[0] + by, self.at[1] + by], size: self.size.map(|side| (side - 2.0 * by).max(1.0)) }
    }

    /// Its middle.
    pub fn center(&self) -> Point {
        [self.at[0] + self.size[0] / 2.0, self.at[1] + self.size[1] / 2.0]
    }
}

/// How points of the world get onto the page.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Camera {
    /// Where the picture is taken from, in perspective.
    eye: Option<Eye>,
    /// Pixels for one unit of the projection.
    scale: f64,
    /// Where the origin of the projection is on the page.
    origin: [f64; 2],
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct Eye {
    at: [f64; 3],
    right: [f64; 3],
    up: [f64; 3],
    ahead: [f64; 3],
}

/// The direction from the scene to the eye: azimuth and elevation in degrees, and the distance in radii of what is seen.
const AZIMUTH: f64 = -66.0;
const ELEVATION: f64 = 40.0;
const DISTANCE: f64 = 3.4;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Camera {
    /// Straight from above, with all of the box in the area.
    pub fn top(seen: &Cuboid, area: Area) -> Camera {
        let camera = Camera { eye: None, scale: 1.0, origin: [0.0; 2] };
        camera.fitted(&seen.corners(), area)
    }

    /// In perspective; `seen` are the points that are to be in the area, `around` the box whose size gives the distance.
    pub fn perspective(around: &Cuboid, seen: &[[f64; 3]], area: Area) -> Camera {
        let (azimuth, elevation) = (AZIMUTH.to_radians(), ELEVATION.to_radians());
        let flat = libm::cos(elevation);
        let back = [flat * libm::cos(azimuth), flat * libm::sin(azimuth), libm::sin(elevation)];
        let size = [0, 1, 2].map(|k| around.max[k] - around.min[k]);
        let distance = DISTANCE * 0.5 * libm::sqrt(dot(size, size)).max(1e-9);
        let center = around.center();
        let ahead = back.map(|part| -part);
        let right = [-libm::sin(azimuth), libm::cos(azimuth), 0.0];
        let up = [
            right[1] * ahead[2] - right[2] * ahead[1],
            right[2] * ahead[0] - right[0] * ahead[2],
            right[0] * ahead[1] - right[1] * ahead[0],
        ];
        let at = [0, 1, 2].map(|k| center[k] + distance * back[k]);
        let camera = Camera { eye: Some(Eye { at, right, up, ahead }), scale: 1.0, origin: [0.0; 2] };
        camera.fitted(seen, area)
    }

    fn fitted(self, seen: &[[f64; 3]], area: Area) -> Camera {
        let points = seen.iter().map(|point| self.flat(*point));
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            for k in 0..2 {
                min[k] = min[k].min(point[k]);
                max[k] = max[k].max(point[k]);
            }
        }
        let scale = [0, 1].map(|k| f64::from(area.size[k]) / (max[k] - min[k]).max(1e-9));
        let scale = scale[0].min(scale[1]);
        let middle = area.center().map(f64::from);
        let origin = [middle[0] - scale * 0.5 * (min[0] + max[0]), middle[1] + scale * 0.5 * (min[1] + max[1])];
        Camera { scale, origin, ..self }
    }

    /// The projection before it is scaled: x right, y up.
    fn flat(&self, point: [f64; 3]) -> [f64; 2] {
        match &self.eye {
            None => [point[0], point[1]],
            Some(eye) => {
                let way = [0, 1, 2].map(|k| point[k] - eye.at[k]);
                let depth = dot(way, eye.ahead).max(1e-9);
                [dot(way, eye.right) / depth, dot(way, eye.up) / depth]
            }
        }
    }

    /// A point of the world on the page.
    pub fn project(&self, point: [f64; 3]) -> Point {
        let [x, y] = self.flat(point);
        [(self.origin[0] + self.scale * x) as f32, (self.origin[1] - self.scale * y) as f32]
    }

    /// Where the picture is taken from, in perspective.
    pub fn eye(&self) -> Option<[f64; 3]> {
        self.eye.map(|eye| eye.at)
    }

    /// Pixels a metre, near a point.
    pub fn metre(&self, near: [f64; 3]) -> f64 {
        match &self.eye {
            None => self.scale,
            Some(eye) => self.scale / dot([0, 1, 2].map(|k| near[k] - eye.at[k]), eye.ahead).max(1e-9),
        }
    }

    /// The direction in which a point of the page lies, from the eye.
    #[cfg(test)]
    pub fn ray(&self, at: Point) -> [f64; 3] {
        let eye = self.eye.expect("a view in perspective");
        let flat = [(f64::from(at[0]) - self.origin[0]) / self.scale, (self.origin[1] - f64::from(at[1])) / self.scale];
        [0, 1, 2].map(|k| eye.ahead[k] + flat[0] * eye.right[k] + flat[1] * eye.up[k])
    }

    /// Whether a side of a box is seen.
    pub fn sees(&self, axis: usize, up: bool, at: f64) -> bool {
        match &self.eye {
            None => axis == 2 && up,
            Some(eye) => {
                if up {
                    eye.at[axis] > at
                } else {
                    eye.at[axis] < at
                }
            }
        }
    }
}
