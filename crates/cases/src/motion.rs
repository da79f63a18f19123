//! The motion in time of a case, written: as text, as JSON and as figures; and spectra.

mod figures;
pub(crate) mod json;
pub mod screen;
mod spectrum;
mod summary;
mod text;

use standfast::InputError;

use crate::document::{AnswerFigure, Document};
use crate::interface::Interface;
pub use crate::record::ReadFile;
use crate::summary::Summary;
pub use spectrum::spectrum_csv;
pub use standfast_answers::motion::*;
pub use standfast_model::{
    BlockCase, BodyPoint, FirstInstant, GivenBase, LoadPeak, MotionCriterion, MotionWarning,
};
pub use standfast_motion::record::{Record, RecordUnit};
pub use standfast_motion::strength::{Factors, Tried};
pub use standfast_motion::{End, MotionError, MotionOutcome, Position};
pub use text::{Rows, energy_rows, event_rows, number_rows, uniqueness, verdict};

/// View of motions: how much is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct MotionView {
    /// True if every event is shown; else of more than 24 the first and the last.
    pub all: bool,
    /// Interface whose option for that is named.
    pub interface: Interface,
}

/// The motions of a case in every situation, the worst first. JSON as `docs/simulate.schema.json` has it: that of the worst, with the
/// `others` in it. Figures are those of the worst, if its whole motion was kept ([`Follow::series`]).
impl Document for [FollowedMotion] {
    type View = MotionView;

    fn summary(&self) -> Option<Summary> {
        summary::summary(self)
    }

    fn text(&self, view: &MotionView) -> String {
        let texts: Vec<_> =
            self.iter().map(|followed| text::render(followed, view, self.len() == 1)).collect();
        let title = self.first().and_then(|worst| worst.case.title.as_ref());
        let title = title.map_or(String::new(), |title| format!("{title}\n\n"));
        let top = self.summary().map_or(String::new(), |summary| summary.text() + "\n");
        title + &top + &texts.join("\n")
    }

    fn json(&self, _: &MotionView, figures: &[String]) -> String {
        json::render(self, figures)
    }

    fn figures(&self, _: &MotionView) -> Result<Vec<AnswerFigure>, InputError> {
        Ok(self.first().map_or_else(Vec::new, figures::all))
    }
}
