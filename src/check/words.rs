//! Layout errors in plain words.

use crate::scene::{Axis, Body, Cardinal, Support, Target, Told};

use super::blame::{Blame, Case, Miss};
use super::measure;
use super::violation::{ErrorKind, Violation};

/// A length for people: two decimals, more where it is short.
pub(super) fn metres(value: f64) -> String {
    let text = match value.abs() {
        long if long >= 1e6 => format!("{value:.0e}"),
        long if long >= 0.095 => format!("{value:.2}"),
        _ => format!("{value:.3}").trim_end_matches('0').trim_end_matches('.').to_owned(),
    };
    format!("{text} m")
}

fn wall(wall: Cardinal) -> &'static str {
    ["right wall", "top wall", "left wall", "bottom wall"][wall.index()]
}

impl Case<'_> {
    /// The sentence of an error, without how often it occurs.
    pub(super) fn sentence(&self, violation: &Violation, blame: &Blame) -> String {
        let name = |index: usize| self.objects[index].path.as_str();
        let subject = name(blame.subject);
        let other = blame.other.map_or("the scene", name);
        let length = metres(blame.metres);
        let body = &self.objects[blame.subject].body;
        match violation.kind {
            ErrorKind::Overlap => format!("{subject} overlaps {other} by {length}"),
            ErrorKind::OutOfBounds => format!("{subject} sticks out of the scene by {length} {}", self.way_out(blame.subject)),
            ErrorKind::Standing => {
                let support = blame.other.map(name);
                format!("{subject} {}", stands_badly(self.miss(blame.subject, blame.other), support, self.rules.tolerance))
            }
            ErrorKind::Mounted if self.hangs_by_narrow_side(blame.subject) => {
                format!("{subject} hangs on a wall by its narrow side: its wider side is {length} off the nearest wall it can lie against")
            }
            ErrorKind::Mounted => format!("{subject} hangs {length} off the nearest wall"),
            ErrorKind::Clearance => {
                let door = violation.culprit as usize;
                let obstacle = violation.other.map_or(other, |index| name(index as usize));
                format!("{obstacle} stands in the way of {} ({length})", name(door))
            }
            ErrorKind::Facing => {
                let looks = body.turn.name();
                let lies = self.direction_told(body).map_or(String::new(), |turn| format!(", {other} lies toward {}", turn.name()));
                format!("{subject} does not face {other}: it looks {looks}{lies}")
            }
            ErrorKind::FacingWall => format!("{subject} faces the {} it {} against", wall(body.turn), rests(body)),
            ErrorKind::ShortSide => {
                let wall = self.short_wall(blame.subject).map_or("wall", wall);
                format!("{subject} {} with its short side to the {wall}", rests(body))
            }
            ErrorKind::Unplaced => {
                let missing = match (body.anchors[0], body.anchors[1]) {
                    (None, None) => "x and y",
                    (None, Some(_)) => "x",
                    (Some(_), _) => "y",
                };
                let were = if missing.len() > 1 { "were" } else { "was" };
                format!("{missing} of {subject} {were} never written")
            }
        }
    }

    fn direction_told(&self, body: &Body) -> Option<Cardinal> {
        measure::direction_told(&self.bounds, body, |target| self.objects[target].body)
    }

    fn way_out(&self, index: usize) -> String {
        match self.side(index) {
            (Axis::Z, true, _) => "above the ceiling".into(),
            (Axis::Z, false, _) => "below the ground".into(),
            (Axis::X, far, _) => format!("through the {}", wall(if far { Cardinal::XMax } else { Cardinal::XMin })),
            (Axis::Y, far, _) => format!("through the {}", wall(if far { Cardinal::YMax } else { Cardinal::YMin })),
        }
    }
}

fn rests(body: &Body) -> &'static str {
    if body.support == Support::Mounted { "hangs" } else { "stands" }
}

/// What a standing object does instead of standing.
fn stands_badly(miss: Miss, support: Option<&str>, tolerance: f64) -> String {
    let beside = miss.beside[0] + miss.beside[1];
    let (above, aside) = (metres(miss.above.abs()), metres(beside));
    let name = support.unwrap_or("the ground");
    match (miss.above.abs() >= tolerance, beside >= tolerance) {
        (false, _) => format!("stands on the edge of {name}: its center is {aside} beside it"),
        (true, true) if miss.above > 0.0 => format!("floats {above} above {name} and {aside} beside it"),
        (true, true) => format!("sinks {above} below the top of {name}, {aside} beside it"),
        (true, false) if miss.above > 0.0 => format!("floats {above} above {name}"),
        (true, false) => format!("sinks {above} into {name}"),
    }
}

/// What an object was told to face, for a note; `None` where a direction or nothing.
pub(super) fn told_to_face<'a>(body: &Body, name: impl Fn(usize) -> &'a str) -> Option<&'a str> {
    match body.told {
        Told::Toward(Target::Object(id)) => Some(name(id.index())),
        Told::Toward(Target::Scene) => Some("the scene"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_short_and_never_zero_for_what_counts() {
        assert_eq!([0.3214, 12.0, 0.1, 0.05, 0.0123, 0.004].map(metres), ["0.32 m", "12.00 m", "0.10 m", "0.05 m", "0.012 m", "0.004 m"]);
    }

    #[test]
    fn a_bad_stand_is_told_by_how_it_misses() {
        let told = |above, x, support| stands_badly(Miss { above, beside: [x, 0.0] }, support, 0.01);
        assert_eq!(told(0.4, 0.0, None), "floats 0.40 m above the ground");
        assert_eq!(told(-0.1, 0.0, Some("desk")), "sinks 0.10 m into desk");
        assert_eq!(told(0.0, 0.2, Some("desk")), "stands on the edge of desk: its center is 0.20 m beside it");
        assert_eq!(told(0.3, 0.2, Some("desk")), "floats 0.30 m above desk and 0.20 m beside it");
        assert_eq!(told(-0.3, 0.2, Some("desk")), "sinks 0.30 m below the top of desk, 0.20 m beside it");
    }
}
