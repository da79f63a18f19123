//! Probabilities, written: as text, as JSON, as figures and for a screen.

mod document;
mod figures;
pub mod screen;
mod summary;
mod text;

use standfast::InputError;

use crate::document::{AnswerFigure, Document};
use crate::summary::Summary;
pub use standfast_answers::random::*;
pub use summary::{after_rest, of_row, over_life, period, period_of, words as criterion_words};

/// JSON as `docs/probability.schema.json` has it: of the least safe set of loads, and behind it of the others.
impl Document for Probability {
    type View = ();

    fn summary(&self) -> Option<Summary> {
        Some(summary::summary(self))
    }

    fn text(&self, (): &()) -> String {
        text::text(self)
    }

    fn json(&self, (): &(), figures: &[String]) -> String {
        document::json(self, figures)
    }

    fn figures(&self, (): &()) -> Result<Vec<AnswerFigure>, InputError> {
        Ok(figures::all(self))
    }
}
