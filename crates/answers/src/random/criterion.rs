//! Criterion that `[criteria]` sets for the probability that the body does not stay at rest.
//!
//! The upper end of the interval has to be at most the bound, so that a probability that is not known well enough does not pass. Of
//! several sets of loads that act one by one the worst counts; the accelerations of a base that is shaken both ways are one event,
//! which moves the body if any of them does.

use standfast_probability::sample::Estimate;
use standfast_watch::Portion;

use super::answer::ChanceRequest;
use super::error::ProbabilityError;
use super::joined::by_acting;
use super::problem::ChanceProblem;
use super::subject::problems_of;
use crate::case::Acting;
use crate::key::Key;
use standfast_model::CaseFile;
use standfast_model::{Bound, Criterion};

/// Probability of not resting beside its bound, `p_not_rest` of `[criteria]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChanceCriterion {
    /// The greatest probability that is allowed.
    pub required: f64,
    /// Under the set of loads where it is worst.
    pub not_rest: Estimate,
}

impl ChanceCriterion {
    pub(super) fn of(
        required: f64,
        problems: &[ChanceProblem],
        request: &ChanceRequest,
        portion: Portion<'_>,
    ) -> Result<ChanceCriterion, ProbabilityError> {
        let all = by_acting(problems, request, portion)?.into_iter().map(|(_, not_rest)| not_rest);
        let worst = all.reduce(|one, two| if two.high > one.high { two } else { one });
        let not_rest = worst.expect("a case has loads");
        Ok(ChanceCriterion { required, not_rest })
    }

    /// Probability that counts: the upper end of the interval.
    pub fn counted(&self) -> f64 {
        self.not_rest.high
    }

    /// True if it is met.
    pub fn is_met(&self) -> bool {
        self.counted() <= self.required
    }
}

/// The bound, where it is asked for.
pub(super) fn bound(criteria: &[Criterion]) -> Option<f64> {
    let asked = criteria.iter().find(|criterion| criterion.key == Key::GreatestNotRest)?;
    match asked.bound {
        Bound::AtMost(bound) => Some(bound),
        _ => None,
    }
}

/// The chance of a case file that the body does not stay at rest, for each set of loads that act together.
///
/// # Errors
/// As [`Probability::of`](super::Probability::of).
pub(crate) fn not_rest(
    file: &CaseFile,
    portion: Portion<'_>,
) -> Result<Vec<(Acting, Estimate)>, ProbabilityError> {
    by_acting(&problems_of(file, None, None)?, &ChanceRequest::default(), portion)
}
