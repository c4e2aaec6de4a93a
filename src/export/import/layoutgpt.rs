//! LayoutGPT's answers: `bed {length: 2.0m; width: 1.6m; height: 0.5m; left: 1.2m; top: 2m; depth: 0.25m; orientation: 90 degrees;}`.
//!
//! `length` is across the object, `width` along it and `height` up, before it is turned. `left`, `top` and `depth` place its center:
//! from the room's left and far side, and above the ground. Degrees turn counterclockwise as seen from above, 0 is toward the viewer.
//! A pixel is a centimetre. What stands outside of braces may name the room: `max length 5m, max width 4m`.

use super::ImportError;
use super::flat::{Facing, Flat, Item, anchored, rounded};
use super::naming::wishes;
use crate::scene::{Cardinal, Kind, MAX_OBJECTS, Scalar};
use std::ops::Range;

/// Taken for the height of a room, metres, where nothing is higher.
const HEIGHT: f64 = 3.0;

/// A line, read.
struct Entry<'a> {
    name: &'a str,
    /// Length, width, height.
    size: [f64; 3],
    /// Left, top, depth.
    place: [f64; 3],
    degrees: f64,
    color: Option<String>,
}

#[derive(Default)]
struct Reader {
    errors: Vec<ImportError>,
    pixels: bool,
}

pub(super) fn read(text: &str) -> Result<Flat, Vec<ImportError>> {
    let mut reader = Reader::default();
    let (entries, prose) = reader.entries(text);
    if entries.is_empty() && reader.errors.is_empty() {
        reader.errors.push(ImportError::new(0..0, "there is no line like `bed {length: 2m; …}`"));
    }
    if !reader.errors.is_empty() {
        return Err(reader.errors);
    }
    let room = [reader.room(&prose, "max length"), reader.room(&prose, "max width")];
    Ok(scene(&entries, room, reader.pixels))
}

impl Reader {
    fn error(&mut self, range: Range<usize>, message: impl Into<String>) {
        if self.errors.len() < 100 {
            self.errors.push(ImportError::new(range, message));
        }
    }

    /// The entries, and what stands around them.
    fn entries<'a>(&mut self, text: &'a str) -> (Vec<Entry<'a>>, String) {
        let (mut entries, mut prose, mut at) = (Vec::new(), String::new(), 0);
        while let Some(open) = text[at..].find('{').map(|found| at + found) {
            let line = text[at..open].rfind('\n').map_or(at, |found| at + found + 1);
            prose.push_str(&text[at..line]);
            let name = text[line..open].trim().trim_start_matches(['-', '*', '.', '#', '•']).trim();
            let name =
                name.split_once(". ").filter(|(number, _)| number.bytes().all(|byte| byte.is_ascii_digit())).map_or(name, |(_, name)| name);
            let Some(close) = text[open..].find('}').map(|found| open + found) else {
                self.error(open..open + 1, "this brace is not closed");
                break;
            };
            if entries.len() >= MAX_OBJECTS {
                self.error(line..open, format!("a scene holds at most {MAX_OBJECTS} objects"));
                break;
            }
            if name.is_empty() {
                self.error(open..open + 1, "the object has no name");
            } else if let Some(entry) = self.entry(name, text, line..open, open + 1..close) {
                entries.push(entry);
            }
            at = close + 1;
        }
        prose.push_str(&text[at.min(text.len())..]);
        (entries, prose)
    }

    fn entry<'a>(&mut self, name: &'a str, text: &str, head: Range<usize>, body: Range<usize>) -> Option<Entry<'a>> {
        let mut found: [Option<f64>; 7] = [None; 7];
        let mut color = None;
        const KEYS: [&str; 7] = ["length", "width", "height", "left", "top", "depth", "orientation"];
        let mut start = body.start;
        for piece in text[body.clone()].split(';') {
            let blank = piece.len() - piece.trim_start().len();
            let range = start + blank..start + piece.len();
            start = range.end + 1;
            let Some((key, value)) = piece.split_once(':') else {
                if !piece.trim().is_empty() {
                    self.error(range, format!("this is no `name: value`: {:?}", piece.trim().chars().take(40).collect::<String>()));
                }
                continue;
            };
            let digits = value.trim().trim_start_matches('#');
            if key.trim() == "color" && digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
                color = Some(digits.to_owned());
            }
            let Some(slot) = KEYS.iter().position(|known| *known == key.trim()) else { continue };
            let number = if slot == 6 { degrees(value) } else { self.metres(value) };
            match number {
                Some(number) if slot > 2 || number > 0.0 => found[slot] = Some(number),
                Some(_) => self.error(range, format!("{} must be positive, not {}", KEYS[slot], value.trim())),
                None => self.error(range, format!("{} is a number with its unit, not {:?}", KEYS[slot], value.trim())),
            }
        }
        let wrong = !self.errors.is_empty();
        for (key, value) in KEYS.iter().zip(&found).take(6) {
            if value.is_none() && !wrong {
                self.error(head.clone(), format!("{key} is missing"));
            }
        }
        let [length, width, height, left, top, depth, orientation] = found;
        Some(Entry {
            name,
            size: [length?, width?, height?],
            place: [left?, top?, depth?],
            degrees: orientation.unwrap_or_default(),
            color,
        })
    }

    /// A length: metres, centimetres or pixels.
    fn metres(&mut self, text: &str) -> Option<f64> {
        let text = text.trim();
        let (number, divisor) = match text.trim_end_matches(|c: char| c.is_ascii_alphabetic()) {
            number if text.ends_with("px") => {
                self.pixels = true;
                (number, 100.0)
            }
            number if text.ends_with("cm") => (number, 100.0),
            number if number.len() == text.len() || text[number.len()..] == *"m" => (number, 1.0),
            _ => return None,
        };
        let value = number.trim().parse::<f64>().ok()? / divisor;
        value.is_finite().then_some(value + 0.0)
    }

    /// A measure of the room from the text around the entries.
    fn room(&mut self, prose: &str, what: &str) -> Option<f64> {
        let prose = prose.to_lowercase();
        let (_, rest) = prose.split_once(what)?;
        let rest = rest.trim_start_matches([' ', ':', '=']);
        let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '.')).unwrap_or(rest.len());
        self.metres(rest[..end].trim_end_matches('.')).filter(|length| *length > 0.0)
    }
}

fn degrees(text: &str) -> Option<f64> {
    let number = text.trim().trim_end_matches("degrees").trim_end_matches("degree").trim_end_matches("deg").trim_end_matches('°');
    number.trim().parse::<f64>().ok().filter(|value| value.is_finite())
}

/// Where a turn leads, and whether it was rounded to a quarter.
fn turn(degrees: f64) -> (Cardinal, bool) {
    let quarters = libm::round(degrees / 90.0);
    // 0 is toward the viewer, Y_MIN; each quarter counterclockwise is the next cardinal.
    (Cardinal::from_turns(3 + (quarters % 4.0) as i64), quarters * 90.0 != degrees)
}

fn scene(entries: &[Entry], room: [Option<f64>; 2], pixels: bool) -> Flat {
    let half = |entry: &Entry| crate::scene::extents(entry.size, turn(entry.degrees).0).map(|extent| 0.5 * extent);
    let reach = |k: usize| entries.iter().map(|entry| entry.place[k] + half(entry)[k]).fold(0.1, f64::max);
    // To the next ten centimetres.
    let tenths = |value: f64| rounded(libm::ceil(value * 10.0 - 1e-9) / 10.0);
    let width = room[0].unwrap_or_else(|| tenths(reach(0)));
    let depth = room[1].unwrap_or_else(|| tenths(reach(1)));
    let height = tenths(reach(2)).max(HEIGHT);
    let mut remarks = Vec::new();
    if room.contains(&None) {
        remarks.push("The file does not give the size of the room: it is taken as large as what it holds.".to_owned());
    }
    remarks.push(format!("The file does not give the height of the room: {} m were taken.", Scalar::float(height).shown()));
    if pixels {
        remarks.push("The file counts pixels: one is taken for a centimetre.".to_owned());
    }
    let dims = [width, depth, height].map(Scalar::float);
    let mut scene = Flat { title: String::new(), dims, interior: true, floor: None, wall: None, items: Vec::new(), remarks };
    let wishes = wishes(entries.iter().map(|entry| entry.name));
    for (entry, wish) in entries.iter().zip(wishes) {
        let (turn, is_rounded) = turn(entry.degrees);
        let [left, top, up] = entry.place;
        let center = [left - 0.5 * width, 0.5 * depth - top, up].map(rounded);
        let support = scene.likely_support(center, crate::scene::extents(entry.size, turn));
        scene.items.push(Item {
            wish,
            category: entry.name.to_owned(),
            kind: Kind::Object,
            support,
            dims: entry.size.map(Scalar::float),
            color: entry.color.clone(),
            anchors: anchored(center, entry.size, turn),
            turn,
            facing: Facing::Direction,
            remark: is_rounded.then(|| format!("turned by {} degrees", Scalar::float(entry.degrees).shown())),
        });
    }
    scene
}
