//! Designs, written: as text, as JSON, as a table and as figures.

mod boundary;
mod json;
mod minimum;
mod single;
mod summary;
mod text;

use standfast::InputError;

use crate::document::{AnswerFigure, Document};
use crate::summary::Summary;
pub use boundary::{boundary_csv, boundary_on_screen};
pub use single::{ChangeList, ChangeRow, changes_caution, changes_heading, number_words};
pub use standfast_answers::design::*;
pub use text::change_words;

/// JSON as `docs/design.schema.json` has it.
impl Document for Design {
    type View = ();

    fn summary(&self) -> Option<Summary> {
        Some(summary::summary(self))
    }

    fn text(&self, (): &()) -> String {
        text::render(self)
    }

    fn json(&self, (): &(), _: &[String]) -> String {
        json::render(self)
    }

    /// None: a design of one quantity has no figure.
    fn figures(&self, (): &()) -> Result<Vec<AnswerFigure>, InputError> {
        Ok(Vec::new())
    }
}
