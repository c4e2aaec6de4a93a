//! Names on the page, none over another.

use super::camera::Area;
use super::colour::{Ink, Rgb};
use super::drawing::{Align, Drawing, Part, Point, Stroke, Text};
use super::font::{CAPITALS, Face};

/// What of the page is taken.
#[derive(Debug)]
pub struct Board {
    area: Area,
    taken: Vec<[f32; 4]>,
}

/// An object that wants a name.
#[derive(Clone, Debug)]
pub struct Wish {
    /// The name; harmless and short.
    pub name: String,
    /// The middle of its top, or of what is seen of it.
    pub at: Point,
    /// Width and height of its top on the page.
    pub room: Point,
    /// The colour that the name stands on, if it stands on the top.
    pub ground: Rgb,
    /// Whether the middle of the top is seen.
    pub seen: bool,
    /// Whether the name may stand beside the object.
    pub beside: bool,
}

impl Board {
    /// An area with nothing on it.
    pub fn new(area: Area) -> Board {
        Board { area, taken: Vec::new() }
    }

    fn is_free(&self, [x0, y0, x1, y1]: [f32; 4]) -> bool {
        let ([left, top], [width, height]) = (self.area.at, self.area.size);
        let inside = x0 >= left && y0 >= top && x1 <= left + width && y1 <= top + height;
        inside && self.taken.iter().all(|taken| x1 <= taken[0] || taken[2] <= x0 || y1 <= taken[1] || taken[3] <= y0)
    }

    /// The free place for a disc that is nearest to where it should be.
    pub fn free_disc(&mut self, at: Point, radius: f32) -> Point {
        let ring = |step: usize| {
            let (around, out) = (step % 12, (step / 12 + 1) as f32 * radius * 1.1);
            let angle = around as f32 * std::f32::consts::TAU / 12.0;
            [at[0] + out * libm::cosf(angle), at[1] + out * libm::sinf(angle)]
        };
        let frame = |[x, y]: Point| [x - radius, y - radius, x + radius, y + radius];
        let ([left, top], [width, height]) = (self.area.at, self.area.size);
        let kept = |[x, y]: Point| {
            let within = |value: f32, from: f32, size: f32| value.max(from + radius).min(from + size - radius);
            [within(x, left, width), within(y, top, height)]
        };
        let places = std::iter::once(at).chain((0..96).map(ring)).map(kept);
        let place = places.into_iter().find(|place| self.is_free(frame(*place))).unwrap_or(kept(at));
        self.taken.push(frame(place));
        place
    }

    /// Writes a text beside a point, where there is room.
    pub fn write_near(&mut self, out: &mut Drawing, at: Point, text: &str, size: f32, face: Face, colour: Rgb) {
        let (width, height) = (face.width(text, size), size);
        let gap = 5.0;
        let middles = [
            [at[0] + gap + width / 2.0, at[1]],
            [at[0] - gap - width / 2.0, at[1]],
            [at[0], at[1] - gap - height / 2.0],
            [at[0], at[1] + gap + height / 2.0],
        ];
        let frame = |[x, y]: Point| [x - width / 2.0 - 1.0, y - height / 2.0, x + width / 2.0 + 1.0, y + height / 2.0];
        if let Some(place) = middles.into_iter().find(|place| self.is_free(frame(*place))) {
            self.taken.push(frame(place));
            let halo = Some((out.paper.over(0.85), 2.0));
            out.text(
                Part::Mark,
                Text { at: baseline(place, size), align: Align::Middle, text: text.to_string(), size, face, colour, halo },
            );
        }
    }

    /// Names objects, the first of the list first; what finds no room goes without.
    pub fn name(&mut self, out: &mut Drawing, wishes: &[Wish], size: f32, ink: &Ink) {
        for wish in wishes {
            let on_top = [1.0, 0.86].into_iter().find_map(|scale| self.on_top(wish, size * scale).map(|place| (place, size * scale)));
            if let Some((place, size)) = on_top {
                let colour = wish.ground.ink();
                let halo = Some((wish.ground.over(0.6), 1.4));
                let text =
                    Text { at: baseline(place, size), align: Align::Middle, text: wish.name.clone(), size, face: Face::Sans, colour, halo };
                out.text(Part::Page, text);
            } else if wish.beside {
                self.aside(out, wish, size * 0.9, ink);
            }
        }
    }

    fn on_top(&mut self, wish: &Wish, size: f32) -> Option<Point> {
        let (width, height) = (Face::Sans.width(&wish.name, size) + 3.0, size * 1.05);
        if !wish.seen || width > wish.room[0] * 1.05 || height > wish.room[1] * 1.05 {
            return None;
        }
        let shifts = [0.0, 0.22, -0.22, 0.38, -0.38];
        let places = shifts.map(|shift| [wish.at[0], wish.at[1] + shift * (wish.room[1] - height).max(0.0)]);
        let frame = |[x, y]: Point| [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0];
        let place = places.into_iter().find(|place| self.is_free(frame(*place)))?;
        self.taken.push(frame(place));
        Some(place)
    }

    /// Writes a name outside its object, with a line that leads there.
    fn aside(&mut self, out: &mut Drawing, wish: &Wish, size: f32, ink: &Ink) {
        let (width, height) = (Face::Sans.width(&wish.name, size) + 4.0, size * 1.2);
        let frame = |[x, y]: Point| [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0];
        let places = (0..48).map(|step| {
            let (around, ring) = (step % 16, step / 16);
            let angle = -std::f32::consts::FRAC_PI_2 + around as f32 * std::f32::consts::TAU / 16.0;
            let (sin, cos) = (libm::sinf(angle), libm::cosf(angle));
            let far = 0.5 + 0.9 * ring as f32;
            let (rx, ry) = (wish.room[0] * 0.5 + width * 0.5 + size * far, wish.room[1] * 0.5 + height * 0.5 + size * far);
            [wish.at[0] + rx * cos, wish.at[1] + ry * sin]
        });
        let Some(place) = places.into_iter().find(|place| self.is_free(frame(*place))) else { return };
        self.taken.push(frame(place));
        let edge = [place[0].max(wish.at[0].min(place[0] + width / 2.0)), place[1]];
        let near = [
            wish.at[0].clamp(place[0] - width / 2.0, place[0] + width / 2.0),
            edge[1] + if wish.at[1] > place[1] { height / 2.0 } else { -height / 2.0 },
        ];
        out.line(Part::Page, vec![near, wish.at], Stroke::solid(ink.text.over(0.55), 0.8));
        let halo = Some((ink.paper.over(0.8), 2.2));
        out.text(
            Part::Page,
            Text {
                at: baseline(place, size),
                align: Align::Middle,
                text: wish.name.clone(),
                size,
                face: Face::Sans,
                colour: ink.text,
                halo,
            },
        );
    }
}

/// Where the baseline of a line of capitals is whose middle is given.
fn baseline([x, y]: Point, size: f32) -> Point {
    [x, y + size * CAPITALS / 2.0]
}

/// Writes a text around a point.
pub fn centered(out: &mut Drawing, part: Part, at: Point, text: &str, size: f32, face: Face, colour: Rgb) {
    out.text(part, Text { at: baseline(at, size), align: Align::Middle, text: text.to_string(), size, face, colour, halo: None });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Theme;

    #[test]
    fn no_name_stands_over_another() {
        let mut board = Board::new(Area { at: [0.0, 0.0], size: [200.0, 200.0] });
        let mut out = Drawing::new(200, 200, Rgb::WHITE);
        let wish = |object: u32| Wish {
            name: format!("chairs[{object}]"),
            at: [100.0, 100.0],
            room: [10.0, 10.0],
            ground: Rgb::WHITE,
            seen: true,
            beside: true,
        };
        let wishes: Vec<Wish> = (0..60).map(wish).collect();
        board.name(&mut out, &wishes, 12.0, &Theme::Light.ink());
        let taken = &board.taken;
        assert!(taken.len() > 6 && taken.len() < 60);
        for (i, a) in taken.iter().enumerate() {
            assert!(taken[..i].iter().all(|b| a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1]));
        }
    }
}
