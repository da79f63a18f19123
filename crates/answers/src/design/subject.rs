//! Subject of a design: a case at rest, or one in time with its first instant, of which numbers are varied by key.

use crate::assess::{Assessment, MotionAssessment};
use crate::case::Case;
use crate::couple::{Variable, vary};
use crate::error::{CaseError, Fault};
use crate::inputs::Inputs;
use crate::key::Table;
use crate::motion::{Follow, FollowedMotion};
use standfast_model::{CaseFile, Criterion, MotionCriterion, at_first_instant, motions};
use standfast_motion::MotionError;
use standfast_watch::Portion;

use super::error::DesignError;
use super::{Target, in_time_note};

/// A case whose numbers are varied.
pub(super) struct Subject {
    /// The case at rest: of one in time, at its first instant.
    pub(super) file: CaseFile,
    /// The case of it.
    pub(super) case: Case,
    /// Case in time.
    pub(super) time: Option<MotionSubject>,
    /// Every number that can be varied, of the first instant and of time.
    pub(super) numbers: Inputs,
}

/// A case in time beside its first instant.
pub(super) struct MotionSubject {
    pub(super) file: CaseFile,
    pub(super) case: Case,
    /// Note on the answer for the first instant: a sentence without its stop.
    pub(super) note: String,
    criteria: Vec<MotionCriterion>,
}

impl Subject {
    pub(super) fn of(file: &CaseFile) -> Result<Subject, CaseError> {
        let Some(first) = file.first_instant()? else {
            let numbers = file.inputs().clone();
            return Ok(Subject { file: file.clone(), case: file.case()?, time: None, numbers });
        };
        let (case, criteria) = (file.case()?, file.motion_criteria()?);
        let mut numbers = file.inputs().clone();
        first.file.inputs().numbers().for_each(|(id, number)| {
            if numbers.get(id).is_none() {
                numbers.set(id, number);
            }
        });
        let time = MotionSubject { file: file.clone(), case, note: first.note, criteria };
        Ok(Subject { case: first.file.case()?, file: first.file, time: Some(time), numbers })
    }

    /// Note on the answer for the first instant of a case in time.
    pub(super) fn note(&self) -> Option<String> {
        self.time.as_ref().map(|time| time.note.clone())
    }

    /// Notes on the numbers that go with these, each note once.
    pub(super) fn notes<'a>(
        &self,
        variables: impl IntoIterator<Item = &'a Variable>,
        present: &Case,
    ) -> Vec<String> {
        let mut notes: Vec<String> = Vec::new();
        for note in variables.into_iter().flat_map(|variable| variable.notes(self.file.inputs(), present)) {
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        notes.extend(self.note().as_deref().map(in_time_note));
        notes
    }

    /// The target that a case has of its own: its criteria, or without any that it rests, in time that it does not overturn.
    pub(super) fn own_target(&self) -> Target {
        match &self.time {
            _ if !self.case.all_criteria().is_empty() || self.asks_of_motion() => Target::Utilisation(1.0),
            Some(_) => Target::Motion(MotionCriterion::NotOverturned),
            None => Target::Rest,
        }
    }

    /// True if something is asked of the motion.
    pub(super) fn asks_of_motion(&self) -> bool {
        self.time.as_ref().is_some_and(|time| !time.criteria.is_empty())
    }

    /// True if the motion is followed for a target.
    ///
    /// # Errors
    /// If it asks for the motion of a case that has none.
    pub(super) fn follows(&self, target: Target) -> Result<bool, DesignError> {
        match target {
            Target::Motion(criterion) if self.time.is_none() => {
                Err(DesignError::NotInTime { name: criterion.name() })
            }
            Target::Motion(MotionCriterion::OverturnedShare(_)) => match &self.time {
                Some(time) if !time.file.inputs().has(Table::Copies) => {
                    Err(time.file.motion_refused(MotionError::NoCopies).into())
                }
                _ => Ok(true),
            },
            Target::Motion(_) => Ok(true),
            Target::Utilisation(_) => Ok(self.asks_of_motion()),
            _ => Ok(false),
        }
    }

    /// The inputs with some numbers changed: in time, where the case is so, and at rest.
    fn varied(&self, changes: &[(&Variable, f64)]) -> Result<(Option<Inputs>, Inputs), Fault> {
        let Some(time) = &self.time else { return Ok((None, vary(self.file.inputs(), &self.case, changes))) };
        // The peaks of the base follow from what is said of time, and may be changed themselves.
        let (own, derived): (Vec<_>, Vec<_>) = changes
            .iter()
            .copied()
            .partition(|(variable, _)| time.file.inputs().get(variable.id()).is_some());
        let moving = vary(time.file.inputs(), &time.case, &own);
        let mut still = at_first_instant(&moving)?.0;
        derived.iter().for_each(|(variable, value)| still.set(variable.id(), *value));
        Ok((Some(moving), still))
    }

    /// The file at rest with some numbers changed.
    ///
    /// # Errors
    /// If the motion has no such first instant.
    pub(super) fn with(&self, changes: &[(&Variable, f64)]) -> Result<CaseFile, CaseError> {
        let (_, still) = self.varied(changes).map_err(|fault| self.error(fault))?;
        Ok(self.file.varied(still))
    }

    /// The answer with some numbers changed, with the motion where it is followed.
    ///
    /// # Errors
    /// If the case cannot have these numbers, or its motion cannot be followed.
    pub(super) fn answer(
        &self,
        changes: &[(&Variable, f64)],
        follows: bool,
    ) -> Result<Assessment, CaseError> {
        let (moving, still) = self.varied(changes).map_err(|fault| self.error(fault))?;
        self.answer_of(moving, still, follows)
    }

    /// The answer of the file with other inputs: of the case in time, where it is so, and of the one at rest.
    fn answer_of(
        &self,
        moving: Option<Inputs>,
        still: Inputs,
        follows: bool,
    ) -> Result<Assessment, CaseError> {
        let case = Case::of(&still).map_err(|fault| self.file.error(fault))?;
        let mut answer = Assessment::owning(case).map_err(|error| self.file.refused(error))?;
        if let (true, Some(moving), Some(time)) = (follows, moving, &self.time) {
            let cases = motions(&moving).map_err(|fault| time.file.error(fault))?;
            let motions = FollowedMotion::of_all(cases, &Follow::default(), Portion::UNSEEN);
            let motions = motions.map_err(|error| time.file.motion_refused(error))?;
            answer.in_time =
                Some(MotionAssessment { note: time.note.clone(), criteria: time.criteria.clone(), motions });
        }
        Ok(answer)
    }

    /// The answer of the file as it is written with other numbers, with what these criteria ask of chance.
    ///
    /// # Errors
    /// As [`answer`](Subject::answer).
    pub(super) fn answer_as_written(
        &self,
        inputs: Inputs,
        follows: bool,
        chance: &[Criterion],
    ) -> Result<Assessment, CaseError> {
        let (moving, still) = match &self.time {
            None => (None, inputs),
            Some(_) => {
                let (still, _) = at_first_instant(&inputs).map_err(|fault| self.error(fault))?;
                (Some(inputs), still)
            }
        };
        let answer = self.answer_of(moving, still.clone(), follows)?;
        match chance {
            [] => Ok(answer),
            asked => answer.with_chance(&self.file.varied(still), asked, Portion::UNSEEN),
        }
    }

    /// The file as it is written, and its case.
    pub(super) fn written(&self) -> (&CaseFile, &Case) {
        self.time.as_ref().map_or((&self.file, &self.case), |time| (&time.file, &time.case))
    }

    fn error(&self, fault: Fault) -> CaseError {
        self.time.as_ref().map_or(&self.file, |time| &time.file).error(fault)
    }
}
