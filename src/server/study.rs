//! What is found out about one text of a program beyond its findings, on request, and remembered while the text is the newest.

use super::run::Outcome;
use super::shared::Shared;
use crate::analysis::Input;
use crate::ide::{Lab, Search};
use crate::repair::{self, Fix, Settings, Watch};
use std::collections::VecDeque;
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// So many texts are remembered. A record of a run may be large.
const STUDIES: usize = 3;
/// So many corrections of one text are remembered.
const FIXES: usize = 4;

/// One text.
#[derive(Debug)]
pub(super) struct Study {
    pub outcome: Arc<Outcome>,
    lab: Mutex<Tried>,
    fixes: Mutex<VecDeque<(Search, Arc<Fix>)>>,
}

/// Whether the program was run with a record, and what came of it.
#[derive(Debug)]
enum Tried {
    NotYet,
    Ran(Option<Box<Lab>>),
}

/// The texts that are remembered, the newest last.
#[derive(Debug, Default)]
pub(super) struct Studies(Mutex<VecDeque<Arc<Study>>>);

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Shared {
    /// What is known about the text of an outcome. What is known about older texts of the same document is forgotten.
    pub(super) fn study(&self, outcome: &Arc<Outcome>) -> Arc<Study> {
        let mut studies = lock(&self.studies.0);
        if let Some(at) = studies.iter().position(|study| Arc::ptr_eq(&study.outcome, outcome))
            && let Some(study) = studies.remove(at)
        {
            studies.push_back(study.clone());
            return study;
        }
        studies.retain(|study| study.outcome.main.text.uri != outcome.main.text.uri);
        if studies.len() >= STUDIES {
            studies.pop_front();
        }
        let study = Study { outcome: outcome.clone(), lab: Mutex::new(Tried::NotYet), fixes: Mutex::default() };
        let study = Arc::new(study);
        studies.push_back(study.clone());
        study
    }

    /// Forgets what is known about a document.
    pub(super) fn forget_study(&self, uri: &tower_lsp_server::ls_types::Uri) {
        lock(&self.studies.0).retain(|study| study.outcome.main.text.uri.as_ref() != Some(uri));
    }
}

impl Study {
    /// The program.
    pub(super) fn input(&self) -> Input<'_> {
        Input { text: &self.outcome.main.text.text, template: self.outcome.template.as_ref().map(|template| &*template.text.text) }
    }

    /// Does something with the program run with a record; `None` where it cannot be run, or not any more.
    pub(super) fn with_lab<T>(&self, watch: &Watch, work: impl FnOnce(&mut Lab) -> T) -> Option<T> {
        if !self.outcome.ran {
            return None;
        }
        let mut lab = lock(&self.lab);
        if matches!(*lab, Tried::NotYet) {
            let tried = Lab::new(&self.input(), &self.outcome.options, Some(&watch.cancelled));
            if watch.cancelled.load(Ordering::Relaxed) {
                return None;
            }
            *lab = Tried::Ran(tried.map(Box::new));
        }
        match &mut *lab {
            Tried::Ran(Some(lab)) => Some(work(lab)),
            _ => None,
        }
    }

    /// Searches; what was found before is remembered.
    pub(super) fn fix(&self, search: &Search, watch: &Arc<Watch>) -> Option<Arc<Fix>> {
        if let Some((_, fix)) = lock(&self.fixes).iter().find(|(known, _)| known == search) {
            return Some(fix.clone());
        }
        let fix = Arc::new(self.fix_with(search, Settings::default(), watch)?);
        let mut fixes = lock(&self.fixes);
        if fixes.len() >= FIXES {
            fixes.pop_front();
        }
        fixes.push_back((search.clone(), fix.clone()));
        Some(fix)
    }

    /// Searches with other settings.
    pub(super) fn fix_with(&self, search: &Search, settings: Settings, watch: &Arc<Watch>) -> Option<Fix> {
        let problem = self.with_lab(watch, |lab| lab.problem.clone())?;
        let settings = Settings { only: search.kinds.clone(), within: search.within, watch: Some(watch.clone()), ..settings };
        let fix = repair::fix(&problem, &settings);
        (!watch.cancelled.load(Ordering::Relaxed)).then_some(fix)
    }
}
