//! The answer to the case of the page: that of the program.

use standfast::Verdict;
use standfast::loads::Reduced;
use standfast_cases::motion::{Follow, FollowedMotion, MotionView};
use standfast_cases::{Assessed, Assessment, AssessmentView, CaseError, CaseFile, Document, Summary};
use standfast_inputs::key::Table;

/// The answer to a case.
#[derive(Debug, Clone)]
pub struct Answered {
    /// At rest, or of a case in time its first instant; `None` of a body in pure numbers, which has none.
    pub rest: Option<Assessment>,
    /// The motions of a case in time, the worst first.
    pub motions: Vec<FollowedMotion>,
}

impl Answered {
    /// The answer to a case file.
    ///
    /// # Errors
    /// As the program: if the case makes no sense, or its motion cannot be followed.
    pub fn of(file: &CaseFile) -> Result<Answered, CaseError> {
        Answered::followed(file, true)
    }

    /// The answer while a number varies: how far two motions part is not looked for.
    ///
    /// # Errors
    /// As [`of`](Answered::of).
    pub fn varied(file: &CaseFile) -> Result<Answered, CaseError> {
        Answered::followed(file, false)
    }

    fn followed(file: &CaseFile, divergence: bool) -> Result<Answered, CaseError> {
        let inputs = file.inputs();
        let follow = Follow { divergence, series: true, ..Follow::default() };
        let motions = if inputs.is_in_time() { FollowedMotion::of_file(file, &follow)? } else { Vec::new() };
        let rest = if inputs.has(Table::Block) { None } else { Some(Assessment::of_file(file)?) };
        Ok(Answered { rest, motions })
    }

    /// True of a case in time.
    pub fn is_in_time(&self) -> bool {
        !self.motions.is_empty()
    }

    /// The situation at rest, or at the first instant, that is worst.
    pub fn worst(&self) -> Option<&Assessed> {
        self.rest.as_ref().map(Assessment::governing)
    }

    /// What its worst situation begins with.
    pub fn verdict(&self) -> Option<Verdict> {
        self.worst().and_then(Assessed::verdict)
    }

    /// The top of the answer.
    pub fn summary(&self) -> Option<Summary> {
        match (&self.rest, self.is_in_time()) {
            (_, true) => self.motions[..].summary(),
            (rest, false) => rest.as_ref().and_then(Document::summary),
        }
    }

    /// The whole answer as the program prints it.
    pub fn text(&self) -> String {
        match (&self.rest, self.is_in_time()) {
            (_, true) => self.motions[..].text(&MotionView::default()),
            (rest, false) => {
                rest.as_ref().map_or(String::new(), |rest| rest.text(&AssessmentView::default()))
            }
        }
    }

    /// The whole answer as the program's JSON.
    pub fn json(&self) -> String {
        match (&self.rest, self.is_in_time()) {
            (_, true) => self.motions[..].json(&MotionView::default(), &[]),
            (rest, false) => {
                rest.as_ref().map_or(String::new(), |rest| rest.json(&AssessmentView::default(), &[]))
            }
        }
    }

    /// The point of the report's plane that the worst situation has on a rigid base; none of bodies on joints.
    pub fn point(&self) -> Option<Reduced> {
        let worst = self.worst().filter(|worst| !worst.is_on_ground() && worst.joints.is_none())?;
        worst.outcome.full.effective
    }
}
