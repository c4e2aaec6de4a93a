//! A correction as a film: edit by edit, objects gliding, the changed line below.

use crate::check::Verdict;
use crate::scene::Layout;

use super::drawing::Drawing;
use super::page::{Caption, Extra, draw_with};
use super::solid::{Cuboid, Space};
use super::{Options, Picture};

/// A state of the scene between two edits, and the edit that led to it.
#[derive(Clone, Debug)]
pub struct Step {
    /// Where everything is.
    pub layout: Layout,
    /// Its errors.
    pub verdict: Verdict,
    /// The edit; none before the first.
    pub edit: Option<Edit>,
}

/// A line of the program before and after an edit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Edit {
    /// Where it stands, from 1.
    pub line: usize,
    /// The line as it was.
    pub old: String,
    /// The line as it is now.
    pub new: String,
}

/// A picture of a film.
#[derive(Clone, Debug)]
pub struct Frame {
    /// What is seen.
    pub drawing: Drawing,
    /// For how long. Milliseconds.
    pub millis: u16,
}

/// How long things last. Milliseconds.
const FIRST: u16 = 1400;
const READ: u16 = 900;
const GLIDE: u16 = 50;
const REST: u16 = 500;
const LAST: u16 = 2800;

/// The frames of a film, one after the other: no more than one of them has to be kept.
pub fn frames<'a>(steps: &'a [Step], rules: &'a crate::check::Rules, options: &'a Options) -> impl Iterator<Item = Frame> + 'a {
    let seen = seen(steps);
    let glide = (240 / steps.len().max(1)).clamp(4, 14);
    let frame = move |layout: &Layout, verdict: &Verdict, at: usize, millis: u16| {
        let edit = steps.get(at).and_then(|step| step.edit.as_ref());
        let caption = Caption { number: at, count: steps.len().saturating_sub(1), edit };
        let extra = Extra { keep: seen, caption: Some(caption) };
        Frame { drawing: draw_with(&Picture { layout, verdict, rules }, options, &extra), millis }
    };
    (0..steps.len()).flat_map(move |at| {
        let step = &steps[at];
        let last = at + 1 == steps.len();
        let before = at.checked_sub(1).map(|before| &steps[before]);
        // First the line is shown beside the scene as it was; then things move.
        let frames = if before.is_some() { glide + 2 } else { 1 };
        (0..frames).map(move |shown| {
            let rest = if last {
                LAST
            } else if at == 0 {
                FIRST
            } else {
                REST
            };
            match before {
                Some(before) if shown == 0 => frame(&before.layout, &before.verdict, at, READ),
                Some(before) if shown <= glide => {
                    let part = shown as f64 / (glide + 1) as f64;
                    let eased = part * part * (3.0 - 2.0 * part);
                    frame(&between(&before.layout, &step.layout, eased), &before.verdict, at, GLIDE)
                }
                _ => frame(&step.layout, &step.verdict, at, rest),
            }
        })
    })
}

/// All that is ever seen, so that the camera stands still.
fn seen(steps: &[Step]) -> Option<Cuboid> {
    let boxes = steps.iter().flat_map(|step| {
        let space = Space::of(&step.layout);
        space.solids.into_iter().chain(space.ghosts).map(|solid| solid.cuboid).collect::<Vec<_>>()
    });
    boxes.reduce(|a, b| a.with(&b))
}

/// A layout on the way from one to another.
fn between(from: &Layout, to: &Layout, part: f64) -> Layout {
    let mut layout = to.clone();
    for (object, before) in layout.objects.iter_mut().zip(&from.objects) {
        let (a, b) = (&before.body, &mut object.body);
        let mix = |a: f64, b: f64| a + (b - a) * part;
        for k in 0..3 {
            b.min[k] = mix(a.min[k], b.min[k]);
            b.max[k] = mix(a.max[k], b.max[k]);
            b.center[k] = mix(a.center[k], b.center[k]);
        }
        if part < 0.5 {
            b.turn = a.turn;
        }
    }
    layout
}
