//! Layout errors as findings: at the statement to blame, one for all errors that come from it.

use std::fmt::Write as _;

use rustc_hash::FxHashMap;

use crate::scene::{Layout, OriginId, StepKind, Warning, WarningKind};

use super::blame::{Blame, Case, placement};
use super::finding::{Code, Finding, Place, Related};
use super::measure::Bounds;
use super::rules::Rules;
use super::violation::{ErrorKind, Verdict, Violation};
use super::words::told_to_face;

/// How many other errors of the same statement are told beside the worst.
const RELATED: usize = 10;

/// The errors of one kind that come from one statement.
struct Group {
    kind: ErrorKind,
    place: Place,
    /// With the worst first, once they are complete.
    members: Vec<(Violation, Blame)>,
}

/// What there is to say about a layout, by place. Errors from one statement are one finding, with the worst case as its headline.
pub fn findings(layout: &Layout, verdict: &Verdict, rules: &Rules) -> Vec<Finding> {
    let case = Case { objects: &layout.objects, bounds: Bounds::of(&layout.scene), rules };
    let mut told: Vec<Finding> = groups(layout, &case, verdict).into_iter().map(|group| finding(layout, &case, group)).collect();
    told.extend(layout.warnings.iter().map(|warning| vain(layout, warning)));
    told.sort_by_key(|finding| (finding.place.source, finding.place.range.start(), finding.place.range.end(), finding.code));
    if let (true, Some(first)) = (verdict.truncated, told.first_mut()) {
        first.notes.push("there are more errors in this scene than were counted".into());
    }
    told
}

/// The errors that the findings of [`findings`] stand for: of each its kind and place, and its errors with the worst first.
pub fn errors_by_place(layout: &Layout, verdict: &Verdict, rules: &Rules) -> Vec<(ErrorKind, Place, Vec<Violation>)> {
    let case = Case { objects: &layout.objects, bounds: Bounds::of(&layout.scene), rules };
    let errors = |group: Group| (group.kind, group.place, group.members.into_iter().map(|(violation, _)| violation).collect());
    groups(layout, &case, verdict).into_iter().map(errors).collect()
}

fn place(layout: &Layout, origin: OriginId) -> Place {
    let origin = layout.origins.get(origin);
    Place { source: origin.source, range: origin.range }
}

fn groups(layout: &Layout, case: &Case, verdict: &Verdict) -> Vec<Group> {
    let (mut groups, mut known) = (Vec::<Group>::new(), FxHashMap::default());
    for violation in &verdict.violations {
        let blame = case.blame(violation);
        let place = place(layout, blame.origin);
        let group = *known.entry((violation.kind, place)).or_insert_with(|| {
            groups.push(Group { kind: violation.kind, place, members: Vec::new() });
            groups.len() - 1
        });
        groups[group].members.push((*violation, blame));
    }
    let worst_first = |(a, _): &(Violation, Blame), (b, _): &(Violation, Blame)| (b.loss.cmp(&a.loss)).then(b.metres.total_cmp(&a.metres));
    groups.iter_mut().for_each(|group| group.members.sort_by(worst_first));
    groups
}

fn finding(layout: &Layout, case: &Case, group: Group) -> Finding {
    let code = group.kind.code();
    let count = group.members.len();
    let (worst, blame) = &group.members[0];
    let mut message = case.sentence(worst, blame);
    if count > 1 {
        // Writing to a string cannot fail.
        let _ = write!(message, " (and {} more from this line)", count - 1);
    }
    let mut related = Vec::new();
    around(layout, blame, group.place, &mut related);
    for (violation, blame) in group.members.iter().skip(1).take(RELATED) {
        let origin = blame.other.map_or(blame.origin, |other| placement(&layout.objects[other]));
        related.push(Related { place: place(layout, origin), message: case.sentence(violation, blame) });
    }
    if let (Some(last), true) = (related.last_mut(), count > 1 + RELATED) {
        let _ = write!(last.message, " … and {} more", count - 1 - RELATED);
    }
    Finding {
        code,
        severity: code.severity(),
        place: group.place,
        message,
        related,
        notes: notes(layout, group.kind, blame),
        count,
        metres: blame.metres,
        loss: group.members.iter().fold(0, |sum, (violation, _)| sum.saturating_add(violation.loss)),
        objects: std::iter::once(blame.subject).chain(blame.other).collect(),
        fix: None,
        suggestion: None,
        partial: false,
    }
}

/// Where the other object is placed, where both are declared, and which calls led to the statement.
fn around(layout: &Layout, blame: &Blame, primary: Place, related: &mut Vec<Related>) {
    let object = |index: usize| &layout.objects[index];
    let mut tell = |place, message| related.push(Related { place, message });
    if let Some(other) = blame.other {
        let beside =
            blame.axis.and_then(|axis| object(other).anchor(axis)).map_or_else(|| placement(object(other)), |anchor| anchor.origin);
        tell(place(layout, beside), format!("{} is placed here", object(other).path));
    }
    let declared = |index: usize| place(layout, object(index).declared);
    match blame.other {
        Some(other) if declared(other) == declared(blame.subject) => {
            tell(declared(other), format!("{} and {} are declared here", object(blame.subject).path, object(other).path));
        }
        Some(other) => {
            tell(declared(blame.subject), format!("{} is declared here", object(blame.subject).path));
            tell(declared(other), format!("{} is declared here", object(other).path));
        }
        None if declared(blame.subject) != primary => {
            tell(declared(blame.subject), format!("{} is declared here", object(blame.subject).path));
        }
        None => {}
    }
    for step in layout.origins.steps_around(blame.origin).take(2 * RELATED) {
        if let StepKind::Call { function } = &step.kind {
            tell(Place::program(step.range), format!("{function}() is called here"));
        }
    }
}

fn notes(layout: &Layout, kind: ErrorKind, blame: &Blame) -> Vec<String> {
    let path = |index: usize| layout.objects[index].path.as_str();
    let mut notes = Vec::new();
    if let Some(iteration) = iteration(layout, blame.origin) {
        notes.push(format!("{}, {iteration}", path(blame.subject)));
    }
    let body = &layout.objects[blame.subject].body;
    match (kind, told_to_face(body, path)) {
        (ErrorKind::FacingWall | ErrorKind::ShortSide, Some(target)) => notes.push(format!("it was told to face {target}")),
        (ErrorKind::FacingWall | ErrorKind::ShortSide, None) => {
            notes.push(format!("it was told no facing: {} follows from its place", body.turn.name()));
        }
        _ => {}
    }
    notes
}

/// The loop iterations around a statement, outermost first: `row = 1, i = 3`.
fn iteration(layout: &Layout, origin: OriginId) -> Option<String> {
    let loops = layout.origins.steps_around(origin).filter_map(|step| match &step.kind {
        StepKind::Loop { variable, value } if !variable.is_empty() => Some(format!("{variable} = {value}")),
        StepKind::Loop { .. } => Some(format!("iteration {}", u64::from(step.index) + 1)),
        StepKind::Call { .. } => None,
    });
    let mut loops: Vec<String> = loops.take(RELATED).collect();
    loops.reverse();
    (!loops.is_empty()).then(|| loops.join(", "))
}

/// Something that the program did in vain.
fn vain(layout: &Layout, warning: &Warning) -> Finding {
    let object = warning.object.map(|id| id.index());
    let name = object.map_or("the scene", |index| layout.objects[index].path.as_str());
    let (code, message) = match &warning.kind {
        WarningKind::SelfFacing => (Code::SelfFacing, format!("{name} is told to face itself, which means nothing")),
        WarningKind::Color { text } => (Code::BadColor, format!("the color of {name} is no RRGGBB: {text}")),
    };
    Finding {
        code,
        severity: code.severity(),
        place: place(layout, warning.origin),
        message,
        related: Vec::new(),
        notes: Vec::new(),
        count: 0,
        metres: 0.0,
        loss: 0,
        objects: object.into_iter().collect(),
        fix: None,
        suggestion: None,
        partial: false,
    }
}
