//! The list of errors beside the picture, worst first.

use crate::check::{ErrorKind, Verdict, Violation};
use crate::scene::Layout;

use super::camera::Area;
use super::colour::Ink;
use super::drawing::{Align, Drawing, Part, Text};
use super::font::Face;
use super::marks::badge;
use super::text::{counted, fitted, metres};

/// The errors of a verdict, worst first; what is not placed comes last.
pub fn worst_first(verdict: &Verdict) -> Vec<Violation> {
    let mut violations = verdict.violations.clone();
    violations.sort_by_key(|violation| (violation.kind == ErrorKind::Unplaced, std::cmp::Reverse(violation.loss)));
    violations
}

/// The list as it is laid out: which errors it shows depends on the room.
#[derive(Debug)]
pub struct Panel {
    area: Area,
    unit: f32,
    columns: usize,
    rows: usize,
}

impl Panel {
    /// A list in an area.
    pub fn new(area: Area, unit: f32) -> Panel {
        let columns = ((area.size[0] / (unit * 27.0)) as usize).max(1);
        let rows = ((area.size[1] - unit * 2.0) / (unit * 1.55)) as usize;
        Panel { area, unit, columns, rows }
    }

    /// How many errors it shows of so many; the last line tells of the others.
    pub fn shows(&self, count: usize) -> usize {
        let room = self.columns * self.rows;
        if count <= room { count } else { room.saturating_sub(1) }
    }

    /// Draws the list.
    pub fn draw(&self, out: &mut Drawing, layout: &Layout, errors: &[Violation], ink: &Ink) {
        let (unit, [left, top]) = (self.unit, self.area.at);
        let counting = errors.iter().filter(|error| error.kind != ErrorKind::Unplaced).count();
        let heading = |text: String, colour| Text {
            at: [left, top + unit],
            align: Align::Start,
            text,
            size: unit,
            face: Face::Bold,
            colour,
            halo: None,
        };
        if errors.is_empty() {
            out.text(Part::Page, heading("No errors".to_string(), ink.faint));
            return;
        }
        out.text(Part::Page, heading(counted(counting, "error"), ink.error));
        let shown = self.shows(errors.len());
        let width = self.area.size[0] / self.columns as f32;
        let at = |row: usize| [left + (row / self.rows.max(1)) as f32 * width, top + unit * (2.5 + 1.55 * (row % self.rows.max(1)) as f32)];
        for (row, error) in errors.iter().take(shown).enumerate() {
            self.row(out, layout, error, row, at(row), width - unit, ink);
        }
        if shown < errors.len() && self.rows > 0 {
            let text = format!("and {} more", errors.len() - shown);
            out.text(
                Part::Page,
                Text { at: at(shown), align: Align::Start, text, size: unit * 0.84, face: Face::Sans, colour: ink.faint, halo: None },
            );
        }
    }

    #[allow(clippy::too_many_arguments)]
    fn row(&self, out: &mut Drawing, layout: &Layout, error: &Violation, row: usize, [x, y]: [f32; 2], width: f32, ink: &Ink) {
        let (unit, size) = (self.unit, self.unit * 0.84);
        let tone = if error.kind == ErrorKind::Unplaced { ink.faint } else { ink.error };
        badge(out, [x + unit * 0.6, y - size * 0.36], unit * 0.56, row + 1, tone);
        let length = if error.metres > 0.0 { metres(error.metres) } else { String::new() };
        let room = width - unit * 1.7 - Face::Sans.width(&length, size) - unit * 0.6;
        let text = Text {
            at: [x + unit * 1.7, y],
            align: Align::Start,
            text: sentence(layout, error, size, room),
            size,
            face: Face::Sans,
            colour: ink.text,
            halo: None,
        };
        out.text(Part::Page, text);
        let end = Text { at: [x + width, y], align: Align::End, text: length, size, face: Face::Sans, colour: ink.faint, halo: None };
        out.text(Part::Page, end);
    }
}

/// An error in a few words.
fn sentence(layout: &Layout, error: &Violation, size: f32, room: f32) -> String {
    let name = |index: u32, part: f32| fitted(&layout.objects[index as usize].path, Face::Sans, size, room * part);
    let culprit = |part| name(error.culprit, part);
    let other = |part| error.other.map_or("the scene".to_string(), |index| name(index, part));
    let body = &layout.objects[error.culprit as usize].body;
    let text = match error.kind {
        ErrorKind::OutOfBounds => format!("{} sticks out", culprit(0.65)),
        ErrorKind::Overlap => format!("{} overlaps {}", culprit(0.4), other(0.4)),
        ErrorKind::Standing => {
            let top = error.support.map_or(0.0, |support| layout.objects[support as usize].body.max[2]);
            let verb = if body.min[2] > top + 0.005 {
                "floats"
            } else if body.min[2] < top - 0.005 {
                "sinks"
            } else {
                "stands on an edge"
            };
            format!("{} {verb}", culprit(0.6))
        }
        ErrorKind::Mounted => format!("{} hangs off the wall", culprit(0.5)),
        ErrorKind::Facing => format!("{} does not face {}", culprit(0.35), other(0.35)),
        ErrorKind::Clearance => format!("{} blocks {}", other(0.4), culprit(0.4)),
        ErrorKind::FacingWall => format!("{} faces its wall", culprit(0.6)),
        ErrorKind::ShortSide => format!("{} has its short side to the wall", culprit(0.4)),
        ErrorKind::Unplaced => format!("{} was never placed", culprit(0.5)),
    };
    fitted(&text, Face::Sans, size, room)
}
