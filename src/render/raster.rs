//! The drawing as pixels: PNG, and the mask of objects.

use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint as SkiaPaint, Path, PathBuilder, Pixmap, Shader, Stroke as SkiaStroke, StrokeDash, Transform,
};

use super::colour::Rgb;
use super::drawing::{Align, Contour, Drawing, Paint, Part, Shape, Stroke, Text};
use super::font::Segment;

/// Pixels in rows from the top, three bytes each.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Pixels {
    /// How many in a row.
    pub width: u32,
    /// How many rows.
    pub height: u32,
    /// Red, green, blue.
    pub rgb: Vec<u8>,
}

impl Drawing {
    /// The picture as pixels.
    pub fn to_pixels(&self) -> Pixels {
        let (width, height) = (self.width.max(1), self.height.max(1));
        let Some(mut map) = Pixmap::new(width, height) else { return Pixels { width: 0, height: 0, rgb: Vec::new() } };
        map.fill(colour(self.paper.into()));
        for item in &self.items {
            draw(&mut map, &item.shape);
        }
        // The paper covers everything, so that nothing is left that shines through.
        let rgb = map.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        Pixels { width, height, rgb }
    }

    /// The picture as PNG.
    pub fn to_png(&self) -> Vec<u8> {
        let pixels = self.to_pixels();
        encode(pixels.width, pixels.height, png::ColorType::Rgb, png::BitDepth::Eight, &pixels.rgb)
    }

    /// Which object is seen at each pixel: a PNG of 16-bit greys, 0 where there is none, else the index of the object and 1 more.
    pub fn id_mask_png(&self) -> Vec<u8> {
        let (width, height) = (self.width.max(1), self.height.max(1));
        let Some(mut map) = Pixmap::new(width, height) else { return Vec::new() };
        for item in &self.items {
            let (Part::Body(index), Shape::Path { contours, fill: Some(_), .. }) = (item.part, &item.shape) else { continue };
            let id = index.saturating_add(1).min(u32::from(u16::MAX));
            let mark = Rgb((id >> 8) as u8, id as u8, 0);
            let mut paint = paint_of(mark.into());
            paint.anti_alias = false;
            if let Some(path) = path_of(contours) {
                map.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), None);
            }
        }
        let grey: Vec<u8> = map.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1]]).collect();
        encode(width, height, png::ColorType::Grayscale, png::BitDepth::Sixteen, &grey)
    }
}

/// PNG of rows of samples.
fn encode(width: u32, height: u32, kind: png::ColorType, depth: png::BitDepth, samples: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, width, height);
    encoder.set_color(kind);
    encoder.set_depth(depth);
    encoder.set_compression(png::Compression::Balanced);
    // Flat areas compress best as they are.
    encoder.set_filter(png::Filter::NoFilter);
    // Writing to memory fails only for sizes that do not fit the samples, and these are made together.
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(samples).and_then(|()| writer.finish()));
    debug_assert!(written.is_ok(), "{written:?}");
    out
}

fn colour(paint: Paint) -> Color {
    let Rgb(r, g, b) = paint.colour;
    Color::from_rgba8(r, g, b, (paint.opacity.clamp(0.0, 1.0) * 255.0).round() as u8)
}

fn paint_of(paint: Paint) -> SkiaPaint<'static> {
    SkiaPaint { shader: Shader::SolidColor(colour(paint)), anti_alias: true, ..SkiaPaint::default() }
}

fn path_of(contours: &[Contour]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for contour in contours {
        for (at, [x, y]) in contour.points.iter().enumerate() {
            if at == 0 { builder.move_to(*x, *y) } else { builder.line_to(*x, *y) }
        }
        if contour.closed {
            builder.close();
        }
    }
    builder.finish()
}

fn draw(map: &mut Pixmap, shape: &Shape) {
    match shape {
        Shape::Path { contours, fill, stroke } => {
            if let Some(path) = path_of(contours) {
                paint(map, &path, *fill, *stroke);
            }
        }
        Shape::Disc { at, radius, fill, stroke } => {
            if let Some(path) = PathBuilder::from_circle(at[0], at[1], *radius) {
                paint(map, &path, Some(*fill), *stroke);
            }
        }
        Shape::Text(text) => write(map, text),
    }
}

fn paint(map: &mut Pixmap, path: &Path, fill: Option<Paint>, line: Option<Stroke>) {
    if let Some(fill) = fill {
        map.fill_path(path, &paint_of(fill), FillRule::Winding, Transform::identity(), None);
    }
    if let Some(line) = line {
        let dash = line.dash.and_then(|[dash, gap]| StrokeDash::new(vec![dash, gap], 0.0));
        let stroke = SkiaStroke { width: line.width, line_join: LineJoin::Round, line_cap: LineCap::Butt, dash, ..SkiaStroke::default() };
        map.stroke_path(path, &paint_of(line.paint), &stroke, Transform::identity(), None);
    }
}

fn write(map: &mut Pixmap, text: &Text) {
    let width = text.face.width(&text.text, text.size);
    let start = match text.align {
        Align::Start => text.at[0],
        Align::Middle => text.at[0] - width / 2.0,
        Align::End => text.at[0] - width,
    };
    let Some(path) = outline(text, start) else { return };
    if let Some((halo, width)) = text.halo {
        let stroke = SkiaStroke { width: width * 2.0, line_join: LineJoin::Round, ..SkiaStroke::default() };
        map.stroke_path(&path, &paint_of(halo), &stroke, Transform::identity(), None);
    }
    map.fill_path(&path, &paint_of(text.colour.into()), FillRule::Winding, Transform::identity(), None);
}

/// The letters of a text as one path.
fn outline(text: &Text, start: f32) -> Option<Path> {
    let (mut x, y, size) = (start, text.at[1], text.size);
    let mut builder = PathBuilder::new();
    for c in text.text.chars() {
        let glyph = text.face.glyph(c);
        let at = |point: [f32; 2]| (x + size * point[0], y - size * point[1]);
        for segment in &glyph.outline {
            match *segment {
                Segment::Move(point) => builder.move_to(at(point).0, at(point).1),
                Segment::Line(point) => builder.line_to(at(point).0, at(point).1),
                Segment::Quad(control, point) => builder.quad_to(at(control).0, at(control).1, at(point).0, at(point).1),
                Segment::Close => builder.close(),
            }
        }
        x += size * glyph.advance;
    }
    builder.finish()
}
