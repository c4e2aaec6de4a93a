//! A program that is tried with other values: what an editor offers for its layout errors, found on request and remembered.

use super::constant::about_constant;
use crate::analysis::{Input, Options};
use crate::check::finding::{Code, Finding, Place};
use crate::check::{ErrorKind, Violation, errors_by_place};
use crate::repair::{Names, Problem, Suggester, Tuner, title};
use crate::syntax::{ConstantId, Edit};
use rustc_hash::FxHashMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// So many suggestions are made for one finding.
const WANTED: usize = 3;

/// What is tried for one constant that is asked about may cost so much, in units of the budget of a search.
const CARE: usize = 400;

/// A change that is offered for a finding. A run of the text after it showed what the title says.
#[derive(Clone, PartialEq, Debug)]
pub struct Offer {
    /// What it does.
    pub title: String,
    /// Byte ranges of the program and what replaces them; disjoint, in ascending order.
    pub edits: Vec<Edit>,
    /// How many objects stand elsewhere after it.
    pub moves: usize,
}

/// One text of a program, run with a record.
#[derive(Debug)]
pub struct Lab {
    /// The program, ready to be run with other values.
    pub problem: Arc<Problem>,
    names: Names,
    errors: Vec<(ErrorKind, Place, Vec<Violation>)>,
    suggester: Option<Suggester>,
    known: FxHashMap<usize, Vec<Offer>>,
    tuner: Option<Tuner>,
    told: FxHashMap<ConstantId, String>,
}

impl Lab {
    /// Runs a program; `None` where it has errors, meets a limit, or the run was cancelled.
    pub fn new(input: &Input, options: &Options, cancel: Option<&AtomicBool>) -> Option<Lab> {
        let problem = Problem::unless_cancelled(input, options, cancel).ok()?;
        let names = Names::of(problem.parsed());
        let errors = errors_by_place(problem.layout(), problem.verdict(), &options.rules);
        let problem = Arc::new(problem);
        Some(Lab { problem, names, errors, suggester: None, known: FxHashMap::default(), tuner: None, told: FxHashMap::default() })
    }

    /// What constants are called.
    pub fn names(&self) -> &Names {
        &self.names
    }

    /// What a constant moves, and the values without errors, in Markdown; `None` where it may not be rewritten.
    pub fn about_constant(&mut self, id: ConstantId) -> Option<&str> {
        if !self.told.contains_key(&id) {
            let tuner = self.tuner.get_or_insert_with(|| Tuner::new(&self.problem));
            let found = tuner.tunable(&self.problem, &self.names, id, CARE)?;
            self.told.insert(id, about_constant(&self.problem, &found));
        }
        self.told.get(&id).map(String::as_str)
    }

    /// The best edits for a finding about layout errors, best first.
    pub fn offers(&mut self, finding: &Finding, cancel: Option<&AtomicBool>) -> &[Offer] {
        self.offers_at(finding.code, finding.place, cancel)
    }

    /// The same for the finding of a kind at a place.
    pub fn offers_at(&mut self, code: Code, place: Place, cancel: Option<&AtomicBool>) -> &[Offer] {
        let found = self.errors.iter().position(|(kind, at, _)| kind.code() == code && *at == place);
        let Some(index) = found else { return &[] };
        if !self.known.contains_key(&index) {
            let problem = &self.problem;
            let suggester = self.suggester.get_or_insert_with(|| Suggester::new(problem));
            let suggestions = suggester.suggest(problem, &self.errors[index].2, WANTED, cancel);
            if cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
                return &[];
            }
            let offer = |found: crate::repair::Suggestion| {
                let title = title(problem, &self.names, &found, place.range);
                Offer { title, moves: found.moved.len(), edits: found.edits }
            };
            self.known.insert(index, suggestions.into_iter().map(offer).collect());
        }
        self.known.get(&index).map_or(&[], Vec::as_slice)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyse;

    /// The titles for the first layout finding, and the text after the first of them.
    fn check(text: &str) -> (Vec<String>, Option<String>) {
        let input = Input { text, template: None };
        let findings = analyse(&input, &Options::default(), None).findings;
        let finding = findings.iter().find(|finding| finding.code.is_layout()).expect("a layout error");
        let mut lab = Lab::new(&input, &Options::default(), None).expect("it runs");
        let offers = lab.offers(finding, None);
        let after = offers.first().map(|offer| {
            let mut text = text.to_string();
            for (range, new) in offer.edits.iter().rev() {
                text.replace_range(range.start().to_usize()..range.end().to_usize(), new);
            }
            text
        });
        (offers.iter().map(|offer| offer.title.clone()).collect(), after)
    }

    #[test]
    fn the_first_offer_is_the_best() {
        let (titles, after) = check("a = Object('A', 1, 1, 1)\na.center = (0, 0, 0.5)\ngap = 0.25\na.min.z = gap\n");
        assert_eq!(titles, ["Change gap 0.25 → 0.0: clears 1 standing error, moves a"]);
        assert!(after.is_some_and(|after| after.contains("gap = 0.0\n")));
    }

    #[test]
    fn what_only_integers_decide_has_no_offer() {
        assert_eq!(check("a = Object('A', 1, 1, 1)\na.center = (0, 0, 3)\n").0, [""; 0]);
    }

    #[test]
    fn a_cancelled_question_is_not_remembered() {
        let text = "a = Object('A', 1, 1, 1)\na.center = (0, 0, 0.75)\n";
        let input = Input { text, template: None };
        let findings = analyse(&input, &Options::default(), None).findings;
        let mut lab = Lab::new(&input, &Options::default(), None).expect("it runs");
        assert!(lab.offers(&findings[0], Some(&AtomicBool::new(true))).is_empty());
        assert!(!lab.offers(&findings[0], None).is_empty());
    }
}
