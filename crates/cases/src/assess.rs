//! The answer to a case, written: as text, as JSON and as figures.

mod acting;
pub mod checks;
mod combination;
mod coordinates;
mod figures;
pub mod ground;
pub mod holding;
pub mod joints;
mod json;
mod loads;
pub mod made;
pub mod opening;
pub mod pinned;
pub mod plan;
pub mod screen;
mod sea;
mod section;
pub mod soil;
mod summary;
mod text;
pub mod verdict;

use std::ops::RangeInclusive;

use standfast::{InputError, Verdict};

use crate::document::{AnswerFigure, Document};
use crate::interface::Interface;
use crate::summary::Summary;
pub use acting::situation_title;
pub use combination::{changes as combination_changes, pair_words, pairs};
pub use loads::{floor_words, glued, left_out, share};
pub use standfast_answers::assess::{
    AnyCheck, Assessed, Assessment, Balance, BalancePart, BaseResponse, CaseCheck, Component, Elastic,
    JointPlace, Joints, MotionAssessment, Together, joint_words, predicate,
};
pub use text::criteria_met;
pub(crate) use text::{heading, met_words, note, title};

/// Load factor up to which a rising load is followed where nothing else is said, as a multiple of the full load.
pub const UP_TO: f64 = 2.0;

/// Number of governing situations that are shown one by one, with figures, where not all are asked for.
pub const GOVERNING: usize = 8;

/// View of an answer: how much of it is shown, and in which words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AssessmentView {
    /// Load factor up to which the path of a rising load is followed, as a multiple of the full load.
    pub up_to: f64,
    /// True if every situation is shown one by one; else of more than [`GOVERNING`] those that govern.
    pub all: bool,
    /// Face that spells the options in the text.
    pub interface: Interface,
}

impl Default for AssessmentView {
    /// Up to twice the load, and what governs, for a program.
    fn default() -> AssessmentView {
        AssessmentView { up_to: UP_TO, all: false, interface: Interface::Program }
    }
}

/// The multiples of the full load up to which a rising load may be followed: up to the full load at least.
const FOLLOWED: RangeInclusive<f64> = 1.0..=1e6;

/// Load factor up to which a rising load is followed, if it may be followed so far.
///
/// # Errors
/// If it is not a number from 1 to 1e6; the error says what is expected.
pub fn check_up_to(factor: f64) -> Result<f64, UpToError> {
    if FOLLOWED.contains(&factor) { Ok(factor) } else { Err(UpToError) }
}

/// Not a load up to which a rising load may be followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("expected a load factor from {} to {}, as {}", FOLLOWED.start(), FOLLOWED.end(), UP_TO)]
pub struct UpToError;

/// The situations that are shown one by one, the worst first: all, or those that govern.
pub fn shown<'a>(assessment: &'a Assessment, view: &AssessmentView) -> Vec<&'a Assessed> {
    let mut shown = assessment.worst_first();
    if !view.all {
        shown.truncate(GOVERNING);
    }
    shown
}

/// What `who` does under the full load of a case, in a sentence that has verdicts in short.
pub(crate) fn happens(assessment: &Assessment, who: &str) -> String {
    summary::happens(assessment, who, in_short)
}

/// Verdict on a body up to where its words go into detail, with its symbol: `slides and rocks about O (SRO-)`.
fn in_short(verdict: Option<Verdict>) -> String {
    let words = verdict.map(|verdict| (verdict, verdict.words()));
    let short = words.and_then(|(verdict, words)| Some((verdict, words.split_once(", ")?.0)));
    short.map_or_else(|| predicate(verdict), |(verdict, words)| format!("{words} ({verdict})"))
}

/// The figures of some situations, loads followed up to a multiple of the full load, and the section of the case.
///
/// # Errors
/// If a figure's numbers are out of range.
pub fn figures_of(
    assessment: &Assessment,
    situations: &[&Assessed],
    up_to: f64,
) -> Result<Vec<AnswerFigure>, InputError> {
    figures::of(assessment, situations.to_vec(), up_to)
}

/// JSON as `docs/answer.schema.json` has it; figures: k–μ diagrams for the loads that have a point there, the load path where loads rise
/// together, and the section.
impl Document for Assessment {
    type View = AssessmentView;

    fn summary(&self) -> Option<Summary> {
        Some(summary::summary(self))
    }

    fn text(&self, view: &AssessmentView) -> String {
        text::render(self, view)
    }

    fn json(&self, view: &AssessmentView, figures: &[String]) -> String {
        json::render(self, view, figures)
    }

    fn figures(&self, view: &AssessmentView) -> Result<Vec<AnswerFigure>, InputError> {
        figures::all(self, view)
    }
}
