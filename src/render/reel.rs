//! Frames as one file: GIF, APNG or animated WebP. Of each frame only what changed is kept.

use std::io::{self, Write};

use rustc_hash::FxHashMap;

use super::raster::Pixels;

/// The formats of films.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// 256 colours; shown everywhere.
    Gif,
    /// All colours.
    Apng,
    /// All colours, and the smallest.
    Webp,
}

/// A part of the picture that changed, and for how long it is shown.
#[derive(Clone, Debug)]
struct Patch {
    left: u32,
    top: u32,
    pixels: Pixels,
    millis: u32,
}

/// Takes frames of one size, one after the other, and writes them as one file.
#[derive(Debug, Default)]
pub struct Reel {
    last: Option<Pixels>,
    patches: Vec<Patch>,
}

impl Reel {
    /// Adds a frame that is shown for some time. A frame that equals the last one makes that longer.
    pub fn add(&mut self, frame: Pixels, millis: u16) {
        let millis = u32::from(millis);
        let changed = match &self.last {
            None => Some([0, 0, frame.width, frame.height]),
            Some(last) => difference(last, &frame),
        };
        match (changed, self.patches.last_mut()) {
            (None, Some(patch)) => patch.millis += millis,
            (None, None) => {}
            (Some([left, top, right, bottom]), _) => {
                let pixels = part(&frame, [left, top, right, bottom]);
                self.patches.push(Patch { left, top, pixels, millis });
                self.last = Some(frame);
            }
        }
    }

    /// The film as a file. It is repeated without end.
    pub fn encode(&self, format: Format) -> io::Result<Vec<u8>> {
        match format {
            Format::Gif => self.gif(),
            Format::Apng => self.apng(),
            Format::Webp => self.webp(),
        }
    }

    fn size(&self) -> (u32, u32) {
        self.last.as_ref().map_or((1, 1), |last| (last.width, last.height))
    }

    fn gif(&self) -> io::Result<Vec<u8>> {
        let (width, height) = self.size();
        let palette = Palette::of(&self.patches);
        let mut out = Vec::new();
        let mut encoder = gif::Encoder::new(&mut out, width as u16, height as u16, &palette.colours).map_err(io::Error::other)?;
        encoder.set_repeat(gif::Repeat::Infinite).map_err(io::Error::other)?;
        let mut known = FxHashMap::default();
        for patch in &self.patches {
            let index = |pixel: &[u8]| {
                let colour = [pixel[0], pixel[1], pixel[2]];
                *known.entry(colour).or_insert_with(|| palette.nearest(colour))
            };
            let frame = gif::Frame {
                left: patch.left as u16,
                top: patch.top as u16,
                width: patch.pixels.width as u16,
                height: patch.pixels.height as u16,
                delay: (patch.millis / 10).min(u32::from(u16::MAX)) as u16,
                dispose: gif::DisposalMethod::Keep,
                buffer: patch.pixels.rgb.chunks_exact(3).map(index).collect(),
                ..gif::Frame::default()
            };
            encoder.write_frame(&frame).map_err(io::Error::other)?;
        }
        drop(encoder);
        Ok(out)
    }

    fn apng(&self) -> io::Result<Vec<u8>> {
        let (width, height) = self.size();
        let mut out = Vec::new();
        let mut encoder = png::Encoder::new(&mut out, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Balanced);
        encoder.set_filter(png::Filter::NoFilter);
        encoder.set_animated(self.patches.len().max(1) as u32, 0)?;
        let mut writer = encoder.write_header()?;
        for (at, patch) in self.patches.iter().enumerate() {
            writer.set_frame_delay(patch.millis.min(u32::from(u16::MAX)) as u16, 1000)?;
            if at > 0 {
                writer.reset_frame_position()?;
                writer.set_frame_dimension(patch.pixels.width, patch.pixels.height)?;
                writer.set_frame_position(patch.left, patch.top)?;
                writer.set_blend_op(png::BlendOp::Source)?;
                writer.set_dispose_op(png::DisposeOp::None)?;
            }
            writer.write_image_data(&patch.pixels.rgb)?;
        }
        writer.finish()?;
        Ok(out)
    }

    /// Still pictures of `image-webp` in the container that WebP has for animations.
    fn webp(&self) -> io::Result<Vec<u8>> {
        let (width, height) = self.size();
        let mut body = b"WEBP".to_vec();
        let mut features = vec![0b10, 0, 0, 0];
        features.extend(three(width - 1));
        features.extend(three(height - 1));
        chunk(&mut body, b"VP8X", &features)?;
        chunk(&mut body, b"ANIM", &[255, 255, 255, 255, 0, 0])?;
        for patch in &self.patches {
            let mut still = Vec::new();
            let (wide, high) = (patch.pixels.width, patch.pixels.height);
            let encoder = image_webp::WebPEncoder::new(&mut still);
            encoder.encode(&patch.pixels.rgb, wide, high, image_webp::ColorType::Rgb8).map_err(io::Error::other)?;
            let mut frame = Vec::new();
            for number in [patch.left / 2, patch.top / 2, wide - 1, high - 1, patch.millis.min(0xff_ffff)] {
                frame.extend(three(number));
            }
            // The patch covers what was there, and stays.
            frame.push(0b10);
            // Behind the head of the file follows the one chunk of a still picture.
            frame.extend(still.get(12..).unwrap_or_default());
            chunk(&mut body, b"ANMF", &frame)?;
        }
        let mut out = Vec::with_capacity(body.len() + 8);
        chunk(&mut out, b"RIFF", &body)?;
        Ok(out)
    }
}

fn three(number: u32) -> [u8; 3] {
    let [a, b, c, _] = number.to_le_bytes();
    [a, b, c]
}

fn chunk(out: &mut Vec<u8>, name: &[u8; 4], data: &[u8]) -> io::Result<()> {
    out.extend(name);
    out.extend(u32::try_from(data.len()).map_err(io::Error::other)?.to_le_bytes());
    out.write_all(data)?;
    if data.len() % 2 == 1 {
        out.push(0);
    }
    Ok(())
}

/// The rectangle in which two frames differ: left, top, right, bottom. Left and top are even, as WebP wants them.
fn difference(a: &Pixels, b: &Pixels) -> Option<[u32; 4]> {
    let row = 3 * a.width as usize;
    if (a.width, a.height) != (b.width, b.height) || row == 0 {
        return Some([0, 0, b.width, b.height]);
    }
    let (mut found, mut left, mut right) = (None, usize::MAX, 0);
    for (y, (one, other)) in a.rgb.chunks_exact(row).zip(b.rgb.chunks_exact(row)).enumerate() {
        if one == other {
            continue;
        }
        let differs = |x: &usize| one[*x] != other[*x];
        left = left.min((0..row).find(differs).unwrap_or(0) / 3);
        right = right.max((0..row).rev().find(differs).unwrap_or(0) / 3 + 1);
        found = Some((found.map_or(y, |(top, _)| top), y + 1));
    }
    let (top, bottom) = found?;
    Some([left as u32 & !1, top as u32 & !1, right as u32, bottom as u32])
}

fn part(frame: &Pixels, [left, top, right, bottom]: [u32; 4]) -> Pixels {
    let row = 3 * frame.width as usize;
    let inside = |line: &[u8]| line[3 * left as usize..3 * right as usize].to_vec();
    let rgb = frame.rgb.chunks_exact(row.max(1)).skip(top as usize).take((bottom - top) as usize).flat_map(inside).collect();
    Pixels { width: right - left, height: bottom - top, rgb }
}

/// The colours of a GIF: those that occur most, and what a quantizer makes of the others.
struct Palette {
    colours: Vec<u8>,
}

/// No more pixels than about this many are looked at to choose colours.
const SAMPLES: usize = 400_000;

impl Palette {
    fn of(patches: &[Patch]) -> Palette {
        let pixels: usize = patches.iter().map(|patch| patch.pixels.rgb.len() / 3).sum();
        let step = (pixels / SAMPLES).max(1);
        let mut counts: FxHashMap<[u8; 3], usize> = FxHashMap::default();
        for patch in patches {
            for pixel in patch.pixels.rgb.chunks_exact(3).step_by(step) {
                *counts.entry([pixel[0], pixel[1], pixel[2]]).or_default() += 1;
            }
        }
        let mut order: Vec<([u8; 3], usize)> = counts.into_iter().collect();
        order.sort_by_key(|(colour, count)| (std::cmp::Reverse(*count), *colour));
        // Flat colours stay as they are; the shades of edges share the rest.
        let exact = if order.len() <= 256 { 256 } else { 96 };
        let mut colours: Vec<u8> = order.iter().take(exact).flat_map(|(colour, _)| *colour).collect();
        if order.len() > 256 {
            let samples: Vec<u8> =
                order[exact..].iter().flat_map(|([r, g, b], count)| [*r, *g, *b, 255].repeat((*count).min(64))).collect();
            colours.extend(color_quant::NeuQuant::new(3, 256 - exact, &samples).color_map_rgb());
        }
        Palette { colours }
    }

    fn nearest(&self, colour: [u8; 3]) -> u8 {
        let far = |entry: &[u8]| entry.iter().zip(colour).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum::<u32>();
        let nearest = self.colours.chunks_exact(3).enumerate().min_by_key(|(_, entry)| far(entry));
        nearest.map_or(0, |(index, _)| index as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(dot: usize) -> Pixels {
        let mut rgb = vec![200; 3 * 16 * 10];
        rgb[3 * dot..3 * dot + 3].copy_from_slice(&[255, 0, 0]);
        Pixels { width: 16, height: 10, rgb }
    }

    fn reel() -> Reel {
        let mut reel = Reel::default();
        for (dot, millis) in [(5, 100), (5, 100), (70, 50), (159, 30)] {
            reel.add(frame(dot), millis);
        }
        reel
    }

    #[test]
    fn what_stays_is_not_written_again() {
        let patches = reel().patches;
        assert_eq!(patches.iter().map(|patch| patch.millis).collect::<Vec<_>>(), [200, 50, 30]);
        assert_eq!((patches[1].left, patches[1].top, patches[1].pixels.width, patches[1].pixels.height), (4, 0, 3, 5));
    }

    #[test]
    fn frames_come_back_from_webp() {
        let bytes = reel().encode(Format::Webp).unwrap();
        let mut decoder = image_webp::WebPDecoder::new(io::Cursor::new(bytes)).unwrap();
        assert!(decoder.is_animated() && decoder.num_frames() == 3 && decoder.dimensions() == (16, 10));
        for (dot, millis) in [(5, 200), (70, 50), (159, 30)] {
            let mut pixels = vec![0; decoder.output_buffer_size().unwrap()];
            assert_eq!(decoder.read_frame(&mut pixels).unwrap(), millis);
            assert_eq!(pixels, frame(dot).rgb);
        }
    }

    #[test]
    fn frames_come_back_from_apng_and_gif() {
        let bytes = reel().encode(Format::Apng).unwrap();
        let mut reader = png::Decoder::new(io::Cursor::new(bytes)).read_info().unwrap();
        assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, frame(5).rgb);

        let bytes = reel().encode(Format::Gif).unwrap();
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut decoder = options.read_info(io::Cursor::new(bytes)).unwrap();
        let mut delays = Vec::new();
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            delays.push(frame.delay);
        }
        assert_eq!(delays, [20, 5, 3]);
    }
}
