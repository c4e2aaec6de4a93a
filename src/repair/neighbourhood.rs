//! What single changes of a program would give, by replay: microseconds, not a run.

use super::changes::Change;
use super::measure::Score;
use super::problem::Problem;
use super::state::State;

/// A program as it is, with the record of its run.
#[derive(Debug)]
pub struct Neighbourhood<'a> {
    problem: &'a Problem,
    state: State,
}

impl<'a> Neighbourhood<'a> {
    /// What the record of the program tells.
    pub fn of(problem: &'a Problem) -> Neighbourhood<'a> {
        Neighbourhood { problem, state: State::original(problem) }
    }

    /// The errors and the movement that a change would give; `None` where it is not in the record, or a decision of the program
    /// comes out otherwise: then a run tells.
    pub fn score(&mut self, change: Change) -> Option<Score> {
        let value = self.state.replays(change)?;
        self.state.try_values(self.problem, &[value])
    }
}
