//! The page: where title, views and list stand, and what of a scene is painted when.

use rustc_hash::FxHashSet;

use crate::check::{ErrorKind, Violation};
use crate::scene::Layout;

use super::camera::{Area, Camera};
use super::colour::{Ink, Rgb};
use super::drawing::{Align, Drawing, Part, Stroke, Text};
use super::film::Edit;
use super::font::Face;
use super::labels::{Board, Wish};
use super::marks::Marker;
use super::order::{hull, sorted};
use super::paint::Painter;
use super::panel::{Panel, worst_first};
use super::shadow::{Shadows, shadows};
use super::solid::{Cuboid, Face as Side, Solid, Space};
use super::stage::Stage;
use super::text::{counted, fitted, fitted_name, harmless};
use super::{Labels, Options, Picture, SIZES, Theme, View};

/// Names are no longer than this, in letters of the size that they are written in.
const LONGEST_NAME: f32 = 14.0;

/// Errors beyond these are listed as a number, and not drawn.
const MOST_MARKS: usize = 600;

/// What a page of a film has besides.
#[derive(Clone, Copy, Debug, Default)]
pub struct Extra<'a> {
    /// This has to be in the picture too, so that the camera stands still.
    pub keep: Option<Cuboid>,
    /// The edit under way; with one there is always a list of errors.
    pub caption: Option<Caption<'a>>,
}

/// An edit of a correction.
#[derive(Clone, Copy, Debug)]
pub struct Caption<'a> {
    /// Which of the edits, from 1; 0 before the first.
    pub number: usize,
    /// How many there are.
    pub count: usize,
    /// The line before and after.
    pub edit: Option<&'a Edit>,
}

/// Draws a picture.
pub fn draw(picture: &Picture, options: &Options) -> Drawing {
    draw_with(picture, options, &Extra::default())
}

/// Draws a page of a film.
pub fn draw_with(picture: &Picture, options: &Options, extra: &Extra) -> Drawing {
    let [width, height] = [options.size.0, options.size.1].map(|side| side.clamp(*SIZES.start(), *SIZES.end()));
    let ink = options.theme.ink();
    let mut out = Drawing::new(width, height, ink.paper);
    out.title = harmless(&picture.layout.scene.title);
    out.names = picture.layout.objects.iter().map(|object| fitted(&object.path, Face::Sans, 10.0, 600.0)).collect();
    let space = Space::of(picture.layout);
    let errors = if options.errors { worst_first(picture.verdict) } else { Vec::new() };
    let listed = !errors.is_empty() || (options.errors && extra.caption.is_some());
    let page = Page::of(width as f32, height as f32, &space, options, listed, extra.caption.is_some());
    page.title(&mut out, &space, options, &ink);
    page.caption(&mut out, extra.caption, &ink);
    let numbered = page.panel.as_ref().map_or(0, |panel| panel.shows(errors.len()));
    let content = Content {
        picture,
        options,
        space: &space,
        errors: &errors,
        numbered,
        keep: extra.keep,
        shadows: shadows(&solid_ones(&space), &space.floor()),
    };
    for (perspective, area) in &page.views {
        content.view(&mut out, *perspective, *area, page.unit);
    }
    if let Some(panel) = &page.panel {
        panel.draw(&mut out, picture.layout, &errors, &ink);
    }
    out
}

/// The bodies that throw shadows; those before a cut-away wall are as glass.
fn solid_ones(space: &Space) -> Vec<Solid> {
    let glassy = |solid: &Solid| Solid { opacity: if space.hangs_before(solid.object) { 0.3 } else { 1.0 }, ..*solid };
    space.solids.iter().map(glassy).collect()
}

/// Where everything stands.
struct Page {
    unit: f32,
    title: Option<Area>,
    /// Whether in perspective, and where.
    views: Vec<(bool, Area)>,
    panel: Option<Panel>,
    caption: Option<Area>,
}

impl Page {
    fn of(width: f32, height: f32, space: &Space, options: &Options, errors: bool, captioned: bool) -> Page {
        let unit = (width.min(height * 1.2) / 64.0).clamp(8.0, 17.0);
        let large = width >= 420.0 && height >= 300.0 && options.captions;
        let margin = if large { unit * 1.2 } else { (width.min(height) * 0.02).max(2.0) };
        let mut rest = Area { at: [0.0, 0.0], size: [width, height] }.inset(margin);
        let title = large.then(|| {
            let high = unit * 2.2;
            let area = Area { at: rest.at, size: [rest.size[0], high] };
            rest = Area { at: [rest.at[0], rest.at[1] + high], size: [rest.size[0], rest.size[1] - high] };
            area
        });
        let caption = (large && captioned).then(|| {
            let high = unit * 4.4;
            rest.size[1] -= high;
            Area { at: [rest.at[0], rest.at[1] + rest.size[1]], size: [rest.size[0], high] }
        });
        let panel = (large && errors).then(|| {
            let area = if width >= height * 1.25 {
                let wide = (rest.size[0] * 0.27).clamp(unit * 17.0, unit * 27.0);
                rest.size[0] -= wide + unit * 1.5;
                Area { at: [rest.at[0] + rest.size[0] + unit * 1.5, rest.at[1]], size: [wide, rest.size[1]] }
            } else {
                let high = (rest.size[1] * 0.24).max(unit * 6.0);
                rest.size[1] -= high + unit;
                Area { at: [rest.at[0], rest.at[1] + rest.size[1] + unit], size: [rest.size[0], high] }
            };
            Panel::new(area, unit)
        });
        Page { unit, title, views: Page::views(rest, unit, space, options.view), panel, caption }
    }

    fn views(rest: Area, unit: f32, space: &Space, view: View) -> Vec<(bool, Area)> {
        let gap = unit * 1.6;
        let [w, d, h] = [0, 1, 2].map(|k| (space.bounds.max[k] - space.bounds.min[k]) as f32);
        let high = if space.bounds.interior { h } else { 0.1 * w.max(d) };
        // How wide the views are for their height; in perspective about so.
        let plan = (w / d.max(1e-6)).clamp(0.2, 5.0);
        let perspective = ((0.9 * w + 0.5 * d) / (0.32 * w + 0.58 * d + 0.75 * high).max(1e-6)).clamp(0.5, 3.0);
        let side_by_side = {
            let room = rest.size[0] - gap;
            let first = room * (perspective / (perspective + plan)).clamp(0.4, 0.72);
            let second = [rest.at[0] + first + gap, rest.at[1]];
            [Area { at: rest.at, size: [first, rest.size[1]] }, Area { at: second, size: [room - first, rest.size[1]] }]
        };
        let stacked = {
            let room = rest.size[1] - gap;
            let first = room * (plan / (perspective + plan)).clamp(0.4, 0.72);
            let second = [rest.at[0], rest.at[1] + first + gap];
            [Area { at: rest.at, size: [rest.size[0], first] }, Area { at: second, size: [rest.size[0], room - first] }]
        };
        let used = |areas: &[Area; 2]| -> f32 {
            let shapes = [perspective, plan];
            areas.iter().zip(shapes).map(|(area, shape)| area.size[0].min(area.size[1] * shape)).map(|side| side * side).sum()
        };
        match view {
            View::Top => vec![(false, rest)],
            View::Perspective => vec![(true, rest)],
            View::Both => {
                let [first, second] = if used(&stacked) > 1.08 * used(&side_by_side) { stacked } else { side_by_side };
                vec![(true, first), (false, second)]
            }
        }
    }

    /// The edit under way, as lines of a diff.
    fn caption(&self, out: &mut Drawing, caption: Option<Caption>, ink: &Ink) {
        let (Some(area), Some(caption)) = (self.caption, caption) else { return };
        let size = self.unit * 0.9;
        let mut line = |row: usize, text: &str, face: Face, colour: Rgb| {
            let at = [area.at[0], area.at[1] + self.unit * (1.2 + 1.45 * row as f32)];
            let text = fitted(text, face, size, area.size[0]);
            out.text(Part::Page, Text { at, align: Align::Start, text, size, face, colour, halo: None });
        };
        let Some(edit) = caption.edit else {
            line(0, &format!("{} to come", counted(caption.count, "edit")), Face::Sans, ink.faint);
            return;
        };
        line(0, &format!("Edit {} of {}, line {}", caption.number, caption.count, edit.line), Face::Sans, ink.faint);
        line(1, &format!("- {}", edit.old.trim()), Face::Mono, ink.error);
        line(2, &format!("+ {}", edit.new.trim()), Face::Mono, ink.good);
    }

    fn title(&self, out: &mut Drawing, space: &Space, options: &Options, ink: &Ink) {
        let Some(area) = self.title else { return };
        let (unit, layout): (f32, &Layout) = (self.unit, space.layout);
        let size = unit * 1.35;
        let title = if layout.scene.title.trim().is_empty() { "Untitled scene" } else { layout.scene.title.as_str() };
        let title = fitted(title, Face::Bold, size, area.size[0] * 0.62);
        let wide = Face::Bold.width(&title, size);
        let base = area.at[1] + size * 0.9;
        out.text(
            Part::Page,
            Text { at: [area.at[0], base], align: Align::Start, text: title, size, face: Face::Bold, colour: ink.text, halo: None },
        );
        let [w, d, h] = layout.scene.size();
        let mut facts = format!("{} · {} × {} × {} m", counted(layout.objects.len(), "object"), short(w), short(d), short(h));
        if space.left_out > 0 {
            facts.push_str(&format!(" · {} not drawn", space.left_out));
        }
        if options.errors && self.panel.is_none() {
            facts.push_str(" · no errors");
        }
        let text = fitted(&facts, Face::Sans, unit * 0.86, area.size[0] - wide - unit);
        let at = [area.at[0] + wide + unit, base];
        out.text(Part::Page, Text { at, align: Align::Start, text, size: unit * 0.86, face: Face::Sans, colour: ink.faint, halo: None });
    }
}

/// A length without needless decimals.
fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// What is drawn in every view.
struct Content<'a> {
    picture: &'a Picture<'a>,
    options: &'a Options,
    space: &'a Space<'a>,
    errors: &'a [Violation],
    numbered: usize,
    keep: Option<Cuboid>,
    shadows: (Shadows, Vec<Shadows>),
}

impl Content<'_> {
    fn camera(&self, perspective: bool, area: Area, unit: f32) -> Camera {
        let (space, t) = (self.space, self.space.thickness());
        let floor = space.floor();
        let mut around = floor;
        if space.bounds.interior {
            around.max[2] = space.bounds.max[2];
        }
        let bodies = space.solids.iter().chain(&space.ghosts);
        let kept = self.keep.unwrap_or(around);
        let seen_around = bodies.clone().fold(around.with(&kept), |around, solid| around.with(&solid.cuboid));
        let border = if self.options.captions && unit > 8.5 { unit * 0.7 } else { 1.0 };
        let scale_room = if self.has_scale(area) { unit * 1.5 } else { 0.0 };
        let mut area = area.inset(border);
        area.size[1] = (area.size[1] - scale_room).max(1.0);
        if !perspective {
            let plan = Cuboid { min: [floor.min[0] - t, floor.min[1] - t, 0.0], max: [floor.max[0] + t, floor.max[1] + t, 0.0] };
            return Camera::top(&seen_around.with(&plan), area);
        }
        let (min, max) = (space.bounds.min, space.bounds.max);
        let mut seen: Vec<[f64; 3]> = Cuboid { min: [min[0] - t, min[1] - t, -t], max: [max[0] + t, max[1] + t, 0.0] }.corners().to_vec();
        if space.bounds.interior {
            seen.extend([[min[0] - t, min[1] - t, max[2]], [min[0] - t, max[1] + t, max[2]], [max[0] + t, max[1] + t, max[2]]]);
        }
        seen.extend(bodies.flat_map(|solid| solid.cuboid.corners()));
        if let Some(kept) = self.keep {
            seen.extend(kept.corners());
        }
        Camera::perspective(&around.with(&seen_around), &seen, area)
    }

    fn has_scale(&self, area: Area) -> bool {
        self.options.captions && area.size[0] >= 200.0 && area.size[1] >= 150.0
    }

    fn view(&self, out: &mut Drawing, perspective: bool, area: Area, unit: f32) {
        let (space, ink) = (self.space, self.options.theme.ink());
        let camera = self.camera(perspective, area, unit);
        let dark = self.options.theme == Theme::Dark;
        let stage = Stage { space, camera: &camera, ink, dark, unit };
        stage.ground(out);
        let blocked: FxHashSet<u32> =
            self.errors.iter().filter(|error| error.kind == ErrorKind::Clearance).map(|error| error.culprit).collect();
        stage.clearances(out, self.picture.rules, &|index| blocked.contains(&(index as u32)));
        let shade = Rgb(0x10, 0x16, 0x28).over(if dark { 0.09 } else { 0.07 });
        stage.shadows(out, &self.shadows.0, shade);
        let solids = if perspective { solid_ones(space) } else { space.solids.clone() };
        let highlight = self.options.highlight.map(|object| (object.0, ink.paper));
        let line = if unit < 9.0 { 0.7 } else { 1.0 };
        let painter = Painter { space, camera: &camera, shadows: &self.shadows.1, shade, highlight, line };
        let tolerance = 0.25 / camera.metre(space.floor().center()).max(1e-9);
        let faces = sorted(&solids, &camera, tolerance.min(0.01));
        faces.iter().for_each(|face| painter.face(out, &solids, face));
        stage.plan_marks(out);
        let marker = Marker { space, camera: &camera, rules: self.picture.rules, ink, unit };
        marker.ghosts(out);
        self.highlighted(out, &camera, &solids, &ink);
        let mut board = Board::new(area);
        let mut places = Vec::new();
        for error in self.errors.iter().take(MOST_MARKS) {
            places.push(marker.mark(out, &mut board, error));
        }
        for (number, place) in places.into_iter().take(self.numbered).enumerate() {
            if let Some(place) = place {
                marker.badge(out, &mut board, place, number + 1);
            }
        }
        if self.options.labels != Labels::None {
            let size = if unit < 9.0 { unit } else { unit * 0.8 };
            board.name(out, &self.wishes(&camera, &solids, &faces, size, &painter), size, &ink);
        }
        if self.has_scale(area) {
            stage.scale(out, area);
        }
    }

    fn highlighted(&self, out: &mut Drawing, camera: &Camera, solids: &[Solid], ink: &Ink) {
        let Some(object) = self.options.highlight else { return };
        for solid in solids.iter().filter(|solid| solid.object == object.0) {
            let outline = hull(solid.cuboid.corners().map(|corner| camera.project(corner)).to_vec());
            out.area(Part::Mark, outline.clone(), None, Some(Stroke::solid(ink.paper.over(0.8), 5.0)));
            out.area(Part::Mark, outline, None, Some(Stroke::solid(ink.accent, 2.4)));
        }
    }

    /// The names that should be on the page, the most important first.
    fn wishes(&self, camera: &Camera, solids: &[Solid], faces: &[Side], size: f32, painter: &Painter) -> Vec<Wish> {
        const MOST_NAMES: usize = 600;
        let listed: FxHashSet<u32> =
            self.errors.iter().take(self.numbered).flat_map(|error| error.objects()).map(|index| index as u32).collect();
        let pointed = self.options.highlight.map(|object| object.0);
        let shown: Vec<Shown> = faces.iter().map(|face| Shown::of(face, camera)).collect();
        let labelled: Vec<Side> = (0..solids.len()).map(|index| side_for_name(index, &solids[index], camera)).collect();
        let room = |side: &Side| {
            let Shown { min, max, .. } = Shown::of(side, camera);
            // A rhombus has less room than the rectangle around it.
            let part = if camera.eye().is_some() { 0.86 } else { 1.0 };
            [(max[0] - min[0]) * part, (max[1] - min[1]) * part]
        };
        let mut order: Vec<(usize, [f32; 2])> = labelled.iter().map(room).enumerate().collect();
        let rank = |(index, room): &(usize, [f32; 2])| {
            let object = solids[*index].object;
            (pointed != Some(object), !listed.contains(&object), -(room[0] * room[1]))
        };
        order.sort_by(|a, b| {
            let (a, b) = (rank(a), rank(b));
            (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2))
        });
        let last_painted = last_painted(faces, solids.len());
        order
            .into_iter()
            .take(MOST_NAMES)
            .map(|(index, room)| {
                let (solid, side) = (&solids[index], &labelled[index]);
                let middle = side.point([0, 1].map(|k| 0.5 * (side.min[k] + side.max[k])));
                let at = camera.project(middle);
                let mut later = faces.iter().zip(&shown).skip(last_painted[index] + 1);
                let seen = !later.any(|(face, shown)| face.solid != index && shown.covers(at));
                let name = fitted_name(&self.picture.layout.objects[solid.object as usize].path, Face::Sans, size, size * LONGEST_NAME);
                let beside = self.options.labels == Labels::All || pointed == Some(solid.object);
                Wish { name, at, room, ground: painter.colour(solid), seen, beside }
            })
            .collect()
    }
}

/// The side of a body that its name stands on: the top, unless another side is seen far better.
fn side_for_name(index: usize, solid: &Solid, camera: &Camera) -> Side {
    let top = Side::of(index, &solid.cuboid, 2, true);
    let area = |side: &Side| Shown::of(side, camera).area();
    let sides = [(0, true), (0, false), (1, true), (1, false)].map(|(axis, up)| Side::of(index, &solid.cuboid, axis, up));
    let seen = sides.into_iter().filter(|side| camera.sees(side.axis, side.up, side.at));
    let best = seen.max_by(|a, b| area(a).total_cmp(&area(b)));
    best.filter(|side| area(side) > 3.0 * area(&top)).unwrap_or(top)
}

/// A side on the page.
struct Shown {
    corners: [[f32; 2]; 4],
    min: [f32; 2],
    max: [f32; 2],
}

impl Shown {
    fn of(face: &Side, camera: &Camera) -> Shown {
        let corners = face.corners().map(|at| camera.project(face.point(at)));
        let of = |k: usize, pick: fn(f32, f32) -> f32| corners.iter().map(|corner| corner[k]).fold(corners[0][k], pick);
        Shown { corners, min: [of(0, f32::min), of(1, f32::min)], max: [of(0, f32::max), of(1, f32::max)] }
    }

    /// On which side of each edge a point lies.
    fn turns(&self, at: [f32; 2]) -> [f32; 4] {
        std::array::from_fn(|k| {
            let (a, b) = (self.corners[k], self.corners[(k + 1) % 4]);
            (b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0])
        })
    }

    fn covers(&self, at: [f32; 2]) -> bool {
        let near = (0..2).all(|k| self.min[k] <= at[k] && at[k] <= self.max[k]);
        near && {
            let turns = self.turns(at);
            turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
        }
    }

    /// Square pixels.
    fn area(&self) -> f32 {
        self.turns(self.corners[0]).iter().sum::<f32>().abs() / 2.0
    }
}

/// When a part of each solid's top is painted last.
fn last_painted(faces: &[Side], solids: usize) -> Vec<usize> {
    let mut last = vec![0; solids];
    for (at, face) in faces.iter().enumerate() {
        last[face.solid] = at;
    }
    last
}
