//! What a file with a `[random]` table is of: a case, a point of the report's plane, or a storm without a body. Its text is parsed
//! once.

use toml::Spanned;
use toml::de::DeTable;

use super::error::ProbabilityError;
use super::point;
use super::problem::Problem;
use super::read::{Random, RandomProblem};
use super::storm::{self, PureStorm};
use crate::error::CaseError;
use crate::parse::CaseFile;

/// What is asked about.
pub(super) enum Asked {
    /// A `[body]` with its loads.
    Case(Box<CaseFile>),
    /// A `[point]`.
    Point(OfPoint),
    /// A `[storm]` without a body.
    Storm(Box<PureStorm>),
}

/// A point with its random numbers, and where they stand.
pub(super) struct OfPoint {
    name: String,
    text: String,
    pub(super) point: [f64; 4],
    pub(super) random: Random,
}

impl OfPoint {
    /// The problem of the point, or of another with the same random numbers.
    pub(super) fn problem(&self, point: [f64; 4], years: Option<f64>) -> Result<Problem, ProbabilityError> {
        let wrong = |(problem, span): (RandomProblem, _)| {
            CaseError::new(&self.name, &self.text, problem.into(), vec![span])
        };
        Ok(Problem::of_point(point, &self.random, years).map_err(wrong)?)
    }
}

impl Asked {
    /// Reads a file; of a storm without a body, over this life.
    pub(super) fn read(name: &str, text: &str, years: Option<f64>) -> Result<Asked, CaseError> {
        let case = |file: CaseFile| Asked::Case(Box::new(file));
        // A text that is no TOML is for a case file to refuse.
        let Ok(document) = DeTable::parse(text) else { return CaseFile::parse(name, text).map(case) };
        let document: &Spanned<DeTable<'_>> = &document;
        if let Some((point, random)) = point::read_file(name, text, document.get_ref())? {
            let (name, text) = (name.to_owned(), text.to_owned());
            return Ok(Asked::Point(OfPoint { name, text, point, random }));
        }
        if let Some(pure) = storm::read_file(name, text, document.get_ref(), years)? {
            return Ok(Asked::Storm(Box::new(pure)));
        }
        CaseFile::of_document(name, text, document).map(case)
    }

    /// Its problems: one for each set of loads that act together, and each acceleration of the base that is tried.
    pub(super) fn problems(&self, years: Option<f64>) -> Result<Vec<Problem>, ProbabilityError> {
        match self {
            Asked::Case(file) => problems_of(file, years),
            Asked::Point(of) => Ok(vec![of.problem(of.point, years)?]),
            Asked::Storm(_) => Err(ProbabilityError::NoBody),
        }
    }
}

impl Problem {
    /// The problems of a file with a `[random]` table, to be handed to any method of `standfast_probability` with their
    /// [laws](Problem::laws): one for each set of loads that act together and each acceleration of the base that is tried; of a `[point]`
    /// the one. Outcomes are numbered by [`Mode::code`](standfast::Mode::code).
    ///
    /// # Errors
    /// If the text is no such file, or a storm without a body.
    pub fn of_text(name: &str, text: &str) -> Result<Vec<Problem>, ProbabilityError> {
        Asked::read(name, text, None)?.problems(None)
    }
}

/// The problems of a case file with a `[random]` table.
pub(super) fn problems_of(file: &CaseFile, years: Option<f64>) -> Result<Vec<Problem>, ProbabilityError> {
    let random = file.random().ok_or(ProbabilityError::NoRandom)?;
    let case = file.case()?;
    Ok(Problem::of(file, case, random, years)?)
}
