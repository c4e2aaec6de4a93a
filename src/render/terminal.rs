//! Pictures in terminals: the protocols of kitty, iTerm2 and sixel, else block characters.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use std::fmt::Write as _;

use super::drawing::Drawing;
use super::raster::Pixels;

/// How a terminal shows pictures.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Protocol {
    /// Kitty's graphics.
    Kitty,
    /// The inline images of iTerm2.
    Iterm,
    /// DEC's sixels.
    Sixel,
    /// Two pixels a character, in 24-bit colours.
    Blocks,
    /// Two pixels a character, in the 256 colours that most terminals know.
    Blocks256,
}

/// Kitty takes so much of a picture at once. Bytes.
const CHUNK: usize = 4096;

impl Protocol {
    /// The size in pixels that suits a terminal of so many columns.
    pub fn size(self, columns: usize) -> (u32, u32) {
        let columns = columns.clamp(20, 110) as u32;
        match self {
            Protocol::Blocks | Protocol::Blocks256 => (columns * FINER, columns * FINER * 9 / 16 / 2 * 2),
            _ => (columns * 9, columns * 9 * 9 / 16),
        }
    }

    /// The picture as what a terminal is sent, with the end of its line.
    pub fn show(self, drawing: &Drawing, columns: usize) -> String {
        let columns = columns.clamp(20, 110);
        let mut out = String::new();
        match self {
            Protocol::Kitty => kitty(&mut out, &drawing.to_png(), columns),
            Protocol::Iterm => {
                let png = drawing.to_png();
                let _ = write!(out, "\u{1b}]1337;File=inline=1;size={};width={columns}:{}\u{7}", png.len(), STANDARD.encode(png));
            }
            Protocol::Sixel => {
                let pixels = drawing.to_pixels();
                let rgba: Vec<u8> = pixels.rgb.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
                let options = icy_sixel::EncodeOptions { diffusion: 0.0, ..icy_sixel::EncodeOptions::default() };
                out = icy_sixel::sixel_encode(&rgba, pixels.width as usize, pixels.height as usize, &options).unwrap_or_default();
            }
            Protocol::Blocks | Protocol::Blocks256 => blocks(&mut out, &drawing.to_pixels(), self == Protocol::Blocks),
        }
        if !out.ends_with('\n') {
            out.push('\n');
        }
        out
    }
}

fn kitty(out: &mut String, png: &[u8], columns: usize) {
    let data = STANDARD.encode(png);
    let chunks: Vec<&[u8]> = data.as_bytes().chunks(CHUNK).collect();
    for (at, chunk) in chunks.iter().enumerate() {
        let more = u8::from(at + 1 < chunks.len());
        let head = if at == 0 { format!("a=T,f=100,q=2,c={columns},m={more}") } else { format!("m={more}") };
        let _ = write!(out, "\u{1b}_G{head};{}\u{1b}\\", String::from_utf8_lossy(chunk));
    }
}

/// So many pixels of the drawing, across and down, are one of the blocks.
const FINER: u32 = 4;

fn blocks(out: &mut String, pixels: &Pixels, full: bool) {
    let (width, height) = (pixels.width / FINER, pixels.height / FINER);
    for row in (0..height).step_by(2) {
        let mut last = None;
        for column in 0..width {
            let upper = mean(pixels, column, row);
            let lower = if row + 1 < height { mean(pixels, column, row + 1) } else { upper };
            if last != Some((upper, lower)) {
                let _ = match full {
                    true => write!(out, "\u{1b}[38;2;{};{};{};48;2;{};{};{}m", upper[0], upper[1], upper[2], lower[0], lower[1], lower[2]),
                    false => write!(out, "\u{1b}[38;5;{};48;5;{}m", nearest(upper), nearest(lower)),
                };
                last = Some((upper, lower));
            }
            out.push('▀');
        }
        out.push_str("\u{1b}[0m\n");
    }
}

fn mean(pixels: &Pixels, column: u32, row: u32) -> [u8; 3] {
    let mut sum = [0_u32; 3];
    for y in row * FINER..(row + 1) * FINER {
        for x in column * FINER..(column + 1) * FINER {
            let at = 3 * (y * pixels.width + x) as usize;
            (0..3).for_each(|k| sum[k] += u32::from(pixels.rgb.get(at + k).copied().unwrap_or(0)));
        }
    }
    sum.map(|part| (part / (FINER * FINER)) as u8)
}

/// The nearest of the 256 colours: the cube, or the row of greys.
fn nearest([r, g, b]: [u8; 3]) -> u8 {
    let level = |value: u8| {
        if value < 48 {
            0
        } else if value < 115 {
            1
        } else {
            (value - 35) / 40
        }
    };
    let shown = |level: u8| if level == 0 { 0 } else { 55 + 40 * level };
    let cube = [r, g, b].map(level);
    let grey = ((u32::from(r) + u32::from(g) + u32::from(b)) / 3) as u8;
    let step = (grey.saturating_sub(3) / 10).min(23);
    let far = |shown: [u8; 3]| [r, g, b].iter().zip(shown).map(|(a, b)| i32::from(a.abs_diff(b)).pow(2)).sum::<i32>();
    if far(cube.map(shown)) <= far([8 + 10 * step; 3]) { 16 + 36 * cube[0] + 6 * cube[1] + cube[2] } else { 232 + step }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::colour::Rgb;
    use crate::render::drawing::Part;

    fn halves() -> Drawing {
        let mut drawing = Drawing::new(80, 48, Rgb(255, 0, 0));
        drawing.fill(Part::Page, vec![[0.0, 24.0], [80.0, 24.0], [80.0, 48.0], [0.0, 48.0]], Rgb(0, 0, 255));
        drawing
    }

    #[test]
    fn blocks_show_two_pixels_a_character_and_leave_no_colour_behind() {
        let shown = Protocol::Blocks.show(&halves(), 20);
        let lines: Vec<&str> = shown.lines().collect();
        assert_eq!(lines.len(), 6);
        assert!(lines.iter().all(|line| line.ends_with("\u{1b}[0m") && line.matches('▀').count() == 20));
        assert!(lines[0].starts_with("\u{1b}[38;2;255;0;0;48;2;255;0;0m") && lines[5].starts_with("\u{1b}[38;2;0;0;255;48;2;0;0;255m"));
        assert!(Protocol::Blocks256.show(&halves(), 20).starts_with("\u{1b}[38;5;196;48;5;196m"));
    }

    #[test]
    fn pictures_come_back_from_kitty_and_iterm() {
        let png = halves().to_png();
        let shown = Protocol::Kitty.show(&halves(), 20);
        let data: String =
            shown.split("\u{1b}_G").skip(1).map(|part| part.split_once(';').unwrap().1.split('\u{1b}').next().unwrap()).collect();
        assert_eq!(STANDARD.decode(data).unwrap(), png);
        let shown = Protocol::Iterm.show(&halves(), 20);
        let data = shown.rsplit_once(':').unwrap().1.trim_end_matches(['\u{7}', '\n']);
        assert_eq!(STANDARD.decode(data).unwrap(), png);
    }

    #[test]
    fn sixels_come_back_as_they_were() {
        let shown = Protocol::Sixel.show(&halves(), 20);
        assert!(shown.starts_with("\u{1b}P") && shown.ends_with("\u{1b}\\\n"));
        let image = icy_sixel::SixelImage::decode(shown.trim_end().as_bytes()).unwrap();
        assert_eq!((image.width, image.height), (80, 48));
    }
}
