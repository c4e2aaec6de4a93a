//! The drawing as SVG. What an object consists of stands in groups that carry its index, so that a click finds it.

use std::fmt::Write as _;

use super::colour::Rgb;
use super::drawing::{Align, Contour, Drawing, Paint, Part, Point, Shape, Stroke, Text};
use super::font::Face;
use crate::markup::xml;

impl Drawing {
    /// The picture as a document of its own.
    pub fn to_svg(&self) -> String {
        let mut out = String::with_capacity(4096 + 96 * self.items.len());
        let (width, height) = (self.width, self.height);
        let _ = write!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\">\n<title>{}</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n",
            xml(&self.title),
            self.paper.hex()
        );
        let mut open = None;
        for item in &self.items {
            let group = group(item.part);
            if group != open {
                close(&mut out, open);
                self.open(&mut out, group);
                open = group;
            }
            shape(&mut out, &item.shape);
        }
        close(&mut out, open);
        out.push_str("</svg>\n");
        out
    }

    fn open(&self, out: &mut String, group: Option<Group>) {
        let _ = match group {
            None => Ok(()),
            Some(Group::Marks) => out.write_str("<g class=\"errors\" pointer-events=\"none\">\n"),
            Some(Group::Object(index)) => {
                let name = self.names.get(index as usize).map_or("", String::as_str);
                writeln!(out, "<g class=\"object\" data-object=\"{index}\"><title>{}</title>", xml(name))
            }
        };
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    Object(u32),
    Marks,
}

fn group(part: Part) -> Option<Group> {
    match part {
        Part::Page => None,
        Part::Body(index) | Part::On(index) => Some(Group::Object(index)),
        Part::Mark => Some(Group::Marks),
    }
}

fn close(out: &mut String, group: Option<Group>) {
    if group.is_some() {
        out.push_str("</g>\n");
    }
}

fn shape(out: &mut String, shape: &Shape) {
    match shape {
        Shape::Path { contours, fill, stroke } => {
            out.push_str("<path d=\"");
            contours.iter().for_each(|contour| data(out, contour));
            out.push('"');
            painted(out, *fill, *stroke);
            out.push_str("/>\n");
        }
        Shape::Disc { at, radius, fill, stroke } => {
            out.push_str("<circle cx=\"");
            number(out, at[0]);
            out.push_str("\" cy=\"");
            number(out, at[1]);
            out.push_str("\" r=\"");
            number(out, *radius);
            out.push('"');
            painted(out, Some(*fill), *stroke);
            out.push_str("/>\n");
        }
        Shape::Text(text) => written(out, text),
    }
}

/// A coordinate with a decimal or two.
fn number(out: &mut String, value: f32) {
    let hundredths = (f64::from(value) * 100.0).round() as i64;
    let (sign, rest) = (if hundredths < 0 { "-" } else { "" }, hundredths.unsigned_abs());
    let _ = match (rest / 100, rest % 100) {
        (whole, 0) => write!(out, "{sign}{whole}"),
        (whole, part) if part % 10 == 0 => write!(out, "{sign}{whole}.{}", part / 10),
        (whole, part) => write!(out, "{sign}{whole}.{part:02}"),
    };
}

fn point(out: &mut String, at: Point) {
    number(out, at[0]);
    out.push(' ');
    number(out, at[1]);
}

fn data(out: &mut String, contour: &Contour) {
    for (at, corner) in contour.points.iter().enumerate() {
        out.push(if at == 0 { 'M' } else { 'L' });
        point(out, *corner);
    }
    if contour.closed {
        out.push('Z');
    }
}

fn painted(out: &mut String, fill: Option<Paint>, stroke: Option<Stroke>) {
    match fill {
        None => out.push_str(" fill=\"none\""),
        Some(paint) => paint_of(out, "fill", paint),
    }
    let Some(stroke) = stroke else { return };
    paint_of(out, "stroke", stroke.paint);
    out.push_str(" stroke-width=\"");
    number(out, stroke.width);
    out.push_str("\" stroke-linejoin=\"round\"");
    if let Some([dash, gap]) = stroke.dash {
        out.push_str(" stroke-dasharray=\"");
        point(out, [dash, gap]);
        out.push('"');
    }
}

fn paint_of(out: &mut String, attribute: &str, paint: Paint) {
    let Rgb(r, g, b) = paint.colour;
    let _ = write!(out, " {attribute}=\"#{r:02x}{g:02x}{b:02x}\"");
    if paint.opacity < 1.0 {
        let _ = write!(out, " {attribute}-opacity=\"");
        number(out, paint.opacity);
        out.push('"');
    }
}

/// Text stays text; its width is told, so that another font takes no more room.
fn written(out: &mut String, text: &Text) {
    let width = text.face.width(&text.text, text.size);
    if text.text.is_empty() {
        return;
    }
    let start = match text.align {
        Align::Start => text.at[0],
        Align::Middle => text.at[0] - width / 2.0,
        Align::End => text.at[0] - width,
    };
    out.push_str("<text x=\"");
    number(out, start);
    out.push_str("\" y=\"");
    number(out, text.at[1]);
    out.push_str("\" font-size=\"");
    number(out, text.size);
    out.push_str("\" textLength=\"");
    number(out, width);
    let _ = write!(out, "\" lengthAdjust=\"spacingAndGlyphs\" font-family=\"{}\"", text.face.family());
    if text.face == Face::Bold {
        out.push_str(" font-weight=\"bold\"");
    }
    paint_of(out, "fill", text.colour.into());
    if let Some((paint, width)) = text.halo {
        paint_of(out, "stroke", paint);
        out.push_str(" stroke-width=\"");
        number(out, width * 2.0);
        out.push_str("\" stroke-linejoin=\"round\" paint-order=\"stroke\"");
    }
    let _ = writeln!(out, " pointer-events=\"none\" xml:space=\"preserve\">{}</text>", xml(&text.text));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let shown = |value| {
            let mut out = String::new();
            number(&mut out, value);
            out
        };
        assert_eq!([0.0, -0.001, 1.0, -1.5, 12.346, 0.05].map(shown), ["0", "0", "1", "-1.5", "12.35", "0.05"]);
    }
}
