//! The boundary of two quantities, written.

mod picture;
mod render;

use standfast::InputError;

use super::DesignBoundary;
use crate::document::{AnswerFigure, Document};
pub use picture::boundary_on_screen;
pub use render::csv as boundary_csv;

/// A text of a few columns, and all of them in JSON; the figure is left out where the target is met, or not, throughout what was searched.
impl Document for DesignBoundary {
    type View = ();

    fn text(&self, (): &()) -> String {
        render::text(self)
    }

    fn json(&self, (): &(), _: &[String]) -> String {
        render::json(self)
    }

    fn figures(&self, (): &()) -> Result<Vec<AnswerFigure>, InputError> {
        Ok(picture::draw(self).map(|figure| AnswerFigure::new("", "Boundary", figure)).into_iter().collect())
    }
}
