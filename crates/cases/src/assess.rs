//! A case answered: every situation of it with its outcome, and its figures. [`text`](Assessment::text) and
//! [`json`](Assessment::json) render the same answer.

pub mod checks;
mod coordinates;
mod figures;
mod json;
mod loads;
mod sea;
mod text;
pub mod verdict;

use standfast::{Departure, InputError, Outcome, Situation};

use crate::case::Case;
pub use figures::{CaseFigure, Drawn};
pub(crate) use json::SCHEMA;
pub use loads::{Component, added_mass_notes};
pub(crate) use text::heading;

/// How far a rising load is followed where nothing else is said, as a multiple of the full load.
pub const UP_TO: f64 = 2.0;

/// How many situations are shown one by one, with figures, where not all are asked for: those that govern.
pub const GOVERNING: usize = 8;

/// The answer to a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The case.
    pub case: Case,
    /// Its situations, one for each alternative force or the only one.
    pub all: Vec<Assessed>,
}

/// A situation of a case with everything that is said about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessed {
    /// Which of the case's alternative forces is among the loads.
    pub force: Option<usize>,
    /// The body under its loads.
    pub situation: Situation,
    /// What becomes of it.
    pub outcome: Outcome,
}

/// What to show of an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// How far the path of a rising load is followed, as a multiple of the full load.
    pub up_to: f64,
    /// Whether every situation is shown one by one, or of more than [`GOVERNING`] those that govern.
    pub all: bool,
}

impl Default for View {
    /// Up to twice the load, and what governs.
    fn default() -> View {
        View { up_to: UP_TO, all: false }
    }
}

impl Assessment {
    /// Answers a case.
    ///
    /// # Errors
    /// If the loads add up to what the mechanics cannot take.
    pub fn of(case: &Case) -> Result<Assessment, InputError> {
        let forces = (0..case.forces.len()).map(Some);
        let forces: Vec<_> = if case.forces.is_empty() { vec![None] } else { forces.collect() };
        let all = forces.into_iter().map(|force| {
            let situation = case.situation(force)?;
            let outcome = situation.outcome()?;
            Ok(Assessed { force, situation, outcome })
        });
        Ok(Assessment { case: case.clone(), all: all.collect::<Result<_, _>>()? })
    }

    /// The situation in which a number is least, the first of several.
    pub fn least(&self, of: impl Fn(&Assessed) -> f64) -> &Assessed {
        let least = self.all.iter().min_by(|one, two| of(one).total_cmp(&of(two)));
        least.expect("a case has a situation")
    }

    /// The situation that leaves rest first.
    pub fn governing(&self) -> &Assessed {
        self.least(|assessed| assessed.outcome.departure.load_factor())
    }

    /// The situations that are shown one by one, in their order: all, or those that leave rest first.
    pub fn shown(&self, view: &View) -> Vec<&Assessed> {
        let mut shown: Vec<_> = self.all.iter().collect();
        if !view.all && shown.len() > GOVERNING {
            let factor = |assessed: &Assessed| assessed.outcome.departure.load_factor();
            shown.sort_by(|one, two| factor(one).total_cmp(&factor(two)));
            shown.truncate(GOVERNING);
            shown.sort_by_key(|assessed| assessed.force);
        }
        shown
    }

    /// What a situation is called: its alternative force.
    pub fn name(&self, assessed: &Assessed) -> Option<String> {
        assessed.force.map(|force| self.case.force_name(force))
    }

    /// The answer for reading, in lines of at most 88 characters.
    pub fn text(&self, view: &View) -> String {
        text::render(self, view)
    }

    /// The answer as one JSON document, at full precision; `files` are those of the figures that were written. See
    /// `docs/answer.schema.json`.
    pub fn json(&self, view: &View, files: &[String]) -> String {
        json::render(self, view, files)
    }

    /// The figures: k–μ diagrams for the loads that have a point there, and the load path where loads rise together.
    ///
    /// # Errors
    /// If a figure's numbers are out of range.
    pub fn figures(&self, view: &View) -> Result<Vec<CaseFigure>, InputError> {
        figures::all(self, view)
    }
}

impl Assessed {
    /// The mode in which the body leaves rest.
    pub fn departure(&self) -> &Departure {
        &self.outcome.departure
    }
}
