//! Names that nothing gives a value, at the places where they are read.

use super::run::Execution;
use crate::check::finding::{Code, Finding, Fix, Place};
use crate::syntax::scope::Role;
use crate::syntax::{Parsed, ScopeId};
use rustc_hash::FxHashMap;

/// One finding a name, at the first place where it is read; the others are related.
pub(super) fn findings(parsed: &Parsed, run: &Execution) -> Vec<Finding> {
    let scopes = &parsed.scopes;
    let mut places: FxHashMap<&str, Vec<Place>> = FxHashMap::default();
    for found in scopes.occurrences().iter().filter(|found| found.role == Role::Load) {
        if scopes.variable(found.scope, found.name).is_some_and(|variable| variable.owner == ScopeId::MODULE) {
            places.entry(scopes.name(found.name).as_str()).or_default().push(Place::program(found.range));
        }
    }
    let finding = |(name, meant): &(String, Option<String>)| {
        let mut places = places.remove(name.as_str())?;
        places.sort_by_key(|place| place.range.start());
        let mut finding = Finding::new(Code::UnknownName, places[0], format!("name '{name}' is not defined"));
        if let Some(meant) = meant {
            finding.notes.push(format!("did you mean '{meant}'?"));
            let edits = places.iter().map(|place| (place.range, meant.clone())).collect();
            finding.fix = Some(Fix { title: format!("replace '{name}' by '{meant}'"), edits });
        }
        if places.len() > 1 {
            finding.notes.push(format!("it is read in {} places", places.len()));
        }
        Some(finding)
    };
    run.unknown.iter().filter_map(finding).collect()
}
