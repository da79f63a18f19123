//! Subjects of a file with a `[random]` table: a case, a point of the report's plane, or a storm without a body.

use super::error::ProbabilityError;
use super::point;
use super::problem::ChanceProblem;
use super::storm::{self, PureStorm};
use crate::error::{CaseError, Fault, Place};
use crate::key::{Key, Table};
use standfast_inputs::random::{Random, RandomProblem};
use standfast_model::CaseFile;

/// Subject that is asked about.
pub(super) enum ChanceSubject {
    /// A `[body]` with its loads, of a case in time at its first instant.
    Case {
        file: Box<CaseFile>,
        /// Note on the answer for the first instant, in a sentence.
        note: Option<String>,
        /// The case in time, some of whose numbers of the motion may be random; `None` where no motion is followed.
        moving: Option<Box<CaseFile>>,
    },
    /// A `[point]`.
    Point(Box<PointSubject>),
    /// A `[storm]` without a body.
    Storm(Box<PureStorm>),
}

/// A point with its random numbers, and where they stand.
pub(super) struct PointSubject {
    file: CaseFile,
    pub(super) point: [f64; 4],
    pub(super) random: Random,
}

impl PointSubject {
    /// The problem of the point, or of another with the same random numbers.
    pub(super) fn problem(
        &self,
        point: [f64; 4],
        years: Option<f64>,
    ) -> Result<ChanceProblem, ProbabilityError> {
        let wrong = |(problem, span): (RandomProblem, _)| self.file.random_error(problem, span);
        Ok(ChanceProblem::of_point(point, &self.random, years).map_err(wrong)?)
    }
}

impl ChanceSubject {
    /// Subject of a file; of a storm without a body, over this life.
    pub(super) fn of(file: &CaseFile, years: Option<f64>) -> Result<ChanceSubject, CaseError> {
        if let Some(point) = point::of_file(file)? {
            let random = file.random().cloned();
            let random =
                random.ok_or_else(|| file.error(Fault::new(RandomProblem::Nothing.into(), Table::Point)))?;
            return Ok(ChanceSubject::Point(Box::new(PointSubject { file: file.clone(), point, random })));
        }
        if let Some(pure) = storm::of_file(file, years)? {
            return Ok(ChanceSubject::Storm(Box::new(pure)));
        }
        Ok(match file.first_instant()? {
            Some(first) => {
                let moving = Some(Box::new(file.clone()));
                ChanceSubject::Case { file: Box::new(first.file), note: Some(first.note), moving }
            }
            None => ChanceSubject::Case { file: Box::new(file.clone()), note: None, moving: None },
        })
    }

    /// Its problems: one for each set of loads that act together, and each acceleration of the base that is tried.
    pub(super) fn problems(&self, years: Option<f64>) -> Result<Vec<ChanceProblem>, ProbabilityError> {
        match self {
            ChanceSubject::Case { file, moving, .. } => problems_of(file, years, moving.as_deref()),
            ChanceSubject::Point(of) => Ok(vec![of.problem(of.point, years)?]),
            ChanceSubject::Storm(_) => Err(ProbabilityError::NoBody),
        }
    }
}

/// Refuses what does not go with a table that stands in place of a body.
pub(super) fn alone(file: &CaseFile, table: Table, what: &str) -> Result<(), CaseError> {
    let inputs = file.inputs();
    let other = Table::ALL.into_iter().find(|other| inputs.has(*other) && *other != table);
    let named = |key: Key| matches!(key, Key::Title | Key::Note);
    let key = inputs.values().find(|(id, _)| id.table == Table::Top && !named(id.key));
    let (name, at) = match (other, key) {
        (Some(other), _) => (other.path(0), Place::from(other)),
        (None, Some((id, _))) => (id.to_string(), Place::from(id)),
        (None, None) => return Ok(()),
    };
    let allowed = ["title", "note", table.name(), super::RANDOM].map(str::to_owned).to_vec();
    let problem = RandomProblem::Name { what: what.to_owned(), name, allowed };
    Err(file.error(Fault::new(problem.into(), at)))
}

impl ChanceProblem {
    /// The problems of a file with a `[random]` table, to be handed to any method of `standfast_probability` with their
    /// [laws](ChanceProblem::laws): one for each set of loads that act together and each acceleration of the base that is tried; of a `[point]`
    /// the one. Outcomes are numbered by [`Mode::code`](standfast::Mode::code).
    ///
    /// # Errors
    /// If the file has no random numbers, or is of a storm without a body.
    pub fn of_file(file: &CaseFile) -> Result<Vec<ChanceProblem>, ProbabilityError> {
        ChanceSubject::of(file, None)?.problems(None)
    }
}

/// The problems of a case file with a `[random]` table; `moving` is that in time of a case whose motion is followed.
pub(super) fn problems_of(
    file: &CaseFile,
    years: Option<f64>,
    moving: Option<&CaseFile>,
) -> Result<Vec<ChanceProblem>, ProbabilityError> {
    let random = file.random().ok_or(ProbabilityError::NoRandom)?;
    let case = file.case()?;
    Ok(ChanceProblem::of(file, case, random, years, moving.map(|file| file.inputs()))?)
}
