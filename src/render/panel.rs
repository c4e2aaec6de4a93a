//! The list of errors beside the picture, worst first.

use crate::check::{ErrorKind, Verdict, Violation};
use crate::scene::Layout;

use super::camera::Area;
use super::colour::Ink;
use super::drawing::{Align, Drawing, Part, Text};
use super::font::Face;
use super::marks::badge;
use super::text::{counted, fitted, fitted_name, metres};

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

/// An error in a few words. Where it is too long, names are cut.
fn sentence(layout: &Layout, error: &Violation, size: f32, room: f32) -> String {
    let words = words(layout, error);
    let wide = |text: &str| Face::Sans.width(text, size);
    let name = |index: u32| layout.objects[index as usize].path.as_str();
    let names: Vec<&str> = words.iter().filter_map(|word| if let Word::Name(index) = word { Some(name(*index)) } else { None }).collect();
    let fixed: f32 = words.iter().map(|word| if let Word::Text(text) = word { wide(text) } else { 0.0 }).sum();
    let left = (room - fixed).max(size);
    let widths: Vec<f32> = names.iter().map(|name| wide(&fitted(name, Face::Sans, size, room))).collect();
    let longest = match widths.iter().sum::<f32>() <= left {
        true => left,
        // A short name leaves its room to the other.
        false => (left - widths.iter().copied().fold(left, f32::min)).max(left / names.len().max(1) as f32),
    };
    let shown = words.iter().map(|word| match word {
        Word::Text(text) => (*text).to_string(),
        Word::Name(index) => fitted_name(name(*index), Face::Sans, size, longest),
    });
    fitted(&shown.collect::<String>(), Face::Sans, size, room)
}

/// A part of a sentence.
enum Word {
    Name(u32),
    Text(&'static str),
}

fn words(layout: &Layout, error: &Violation) -> Vec<Word> {
    let culprit = Word::Name(error.culprit);
    let other = error.other.map_or(Word::Text("the scene"), Word::Name);
    let body = &layout.objects[error.culprit as usize].body;
    match error.kind {
        ErrorKind::OutOfBounds => vec![culprit, Word::Text(" sticks out")],
        ErrorKind::Overlap => vec![culprit, Word::Text(" overlaps "), other],
        ErrorKind::Standing => {
            let top = error.support.map_or(0.0, |support| layout.objects[support as usize].body.max[2]);
            let verb = match body.min[2] - top {
                above if above > 0.005 => " floats",
                above if above < -0.005 => " sinks",
                _ => " stands on an edge",
            };
            vec![culprit, Word::Text(verb)]
        }
        ErrorKind::Mounted => vec![culprit, Word::Text(" hangs off the wall")],
        ErrorKind::Facing => vec![culprit, Word::Text(" does not face "), other],
        ErrorKind::Clearance => vec![other, Word::Text(" blocks "), culprit],
        ErrorKind::FacingWall => vec![culprit, Word::Text(" faces its wall")],
        ErrorKind::ShortSide => vec![culprit, Word::Text(" has its short side to the wall")],
        ErrorKind::Unplaced => vec![culprit, Word::Text(" was never placed")],
    }
}
