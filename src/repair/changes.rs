//! What a candidate changes of a program.

use std::collections::BTreeMap;

use crate::syntax::Edit;
use crate::syntax::tune::Cardinal;
use crate::syntax::{ConstantId, DirectionId, Tuning};
use ruff_text_size::TextRange;

/// One elementary edit.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Change {
    /// A constant gets another value.
    Constant(ConstantId, f64),
    /// A direction becomes a cardinal.
    Turn(DirectionId, Cardinal),
}

/// Elementary edits that go together: no two of them rewrite the same text.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Changes {
    constants: BTreeMap<ConstantId, f64>,
    turns: BTreeMap<DirectionId, Cardinal>,
}

impl Changes {
    /// How many edits there are.
    pub fn len(&self) -> usize {
        self.constants.len() + self.turns.len()
    }

    /// Nothing changes.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// All edits: constants, then directions, each in the order of the text.
    pub fn iter(&self) -> impl Iterator<Item = Change> + '_ {
        let constants = self.constants.iter().map(|(id, value)| Change::Constant(*id, *value));
        constants.chain(self.turns.iter().map(|(id, cardinal)| Change::Turn(*id, *cardinal)))
    }

    /// These changes and one more. What it overwrites is dropped; a constant that gets its own value back is no edit.
    pub fn with(&self, change: Change, tuning: &Tuning) -> Changes {
        let mut changes = self.clone();
        match change {
            Change::Constant(id, value) => {
                let same = tuning.constant(id).is_some_and(|constant| constant.value.to_bits() == value.to_bits());
                if same {
                    changes.constants.remove(&id);
                } else if tuning.constant(id).is_some_and(|constant| !self.covers(tuning, constant.range)) {
                    changes.constants.insert(id, value);
                }
            }
            Change::Turn(id, cardinal) => {
                let Some(direction) = tuning.direction(id) else { return changes };
                let inside = |range: Option<TextRange>| range.is_some_and(|range| direction.range.contains_range(range));
                changes.constants.retain(|id, _| !inside(tuning.constant(*id).map(|constant| constant.range)));
                changes.turns.retain(|id, _| !inside(tuning.direction(*id).map(|direction| direction.range)));
                if !changes.covers(tuning, direction.range) {
                    changes.turns.insert(id, cardinal);
                }
            }
        }
        changes
    }

    /// These changes without one.
    pub fn without(&self, change: Change) -> Changes {
        let mut changes = self.clone();
        match change {
            Change::Constant(id, _) => drop(changes.constants.remove(&id)),
            Change::Turn(id, _) => drop(changes.turns.remove(&id)),
        }
        changes
    }

    /// Whether a direction that is rewritten as a whole covers a range.
    fn covers(&self, tuning: &Tuning, range: TextRange) -> bool {
        self.turns.keys().filter_map(|id| tuning.direction(*id)).any(|direction| direction.range.contains_range(range))
    }

    /// The value of a constant, where it has another one.
    pub fn constant(&self, id: ConstantId) -> Option<f64> {
        self.constants.get(&id).copied()
    }

    /// The turn of a direction, where it has another one.
    pub fn turn(&self, id: DirectionId) -> Option<Cardinal> {
        self.turns.get(&id).copied()
    }

    /// The values of constants.
    pub fn constants(&self) -> impl Iterator<Item = (ConstantId, f64)> + '_ {
        self.constants.iter().map(|(id, value)| (*id, *value))
    }

    /// The turns of directions.
    pub fn turns(&self) -> impl Iterator<Item = (DirectionId, Cardinal)> + '_ {
        self.turns.iter().map(|(id, cardinal)| (*id, *cardinal))
    }

    /// The edits of the text, by place.
    pub fn edits(&self, tuning: &Tuning) -> Vec<Edit> {
        let constants = self.constants.iter().filter_map(|(id, value)| Some(tuning.constant(*id)?.edit(*value)));
        let turns = self.turns.iter().filter_map(|(id, cardinal)| Some(tuning.turn(tuning.direction(*id)?, *cardinal)));
        let mut edits: Vec<Edit> = constants.chain(turns).collect();
        edits.sort_by_key(|(range, _)| (range.start(), range.end()));
        edits
    }
}
