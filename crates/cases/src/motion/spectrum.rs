//! A spectrum, written.

mod pictures;
mod text;

use standfast::InputError;
use standfast_answers::motion::Spectrum;

use crate::document::{AnswerFigure, Document};
pub use text::csv as spectrum_csv;

/// JSON as `docs/spectrum.schema.json` has it.
impl Document for Spectrum {
    type View = ();

    fn text(&self, (): &()) -> String {
        text::text(self)
    }

    fn json(&self, (): &(), figures: &[String]) -> String {
        text::json(self, figures)
    }

    fn figures(&self, (): &()) -> Result<Vec<AnswerFigure>, InputError> {
        Ok(vec![AnswerFigure::new(format!("-{}", self.kind.word()), "Spectrum", pictures::figure(self))])
    }
}
