//! A case over all directions, written.

mod json;
mod picture;
mod text;

use standfast::InputError;
pub use standfast_answers::directions::{
    DirectionAnswer, Directions, DirectionsError, Orbit, OrbitExit, STEP, SituationDirections, StepError,
    check_step,
};

use crate::document::{AnswerFigure, Document};
use crate::summary::Summary;
pub(crate) use picture::of_assessed;
pub use picture::on_screen;
use standfast_model::CaseFile;
pub use text::csv;

/// Where rest ends along the record of each situation, in a sentence; nothing of a case without one, or without an answer.
pub fn along_records(file: &CaseFile) -> Vec<String> {
    Directions::of_file(file, STEP).map_or(Vec::new(), |directions| text::along_records(&directions))
}

/// JSON as `docs/directions.schema.json` has it; a figure of each situation.
impl Document for Directions {
    type View = ();

    fn summary(&self) -> Option<Summary> {
        Some(text::summary(self))
    }

    fn text(&self, (): &()) -> String {
        text::text(self)
    }

    fn json(&self, (): &(), figures: &[String]) -> String {
        json::json(self, figures)
    }

    fn figures(&self, (): &()) -> Result<Vec<AnswerFigure>, InputError> {
        Ok(picture::all(self))
    }
}
