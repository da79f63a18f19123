//! How near to another verdict a motion is: by the strength of its loads.

use standfast_model::{BlockCase, MotionCriterion};
use standfast_motion::strength::{Factors, Strengths, Tried, VerdictStrength, onset};
use standfast_motion::{MotionError, MotionOutcome};

/// When the strength of a motion is looked for: some fifty motions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StrengthAsked {
    /// Never.
    #[default]
    No,
    /// Where the longest record, or list of points, is short enough to wait for.
    IfShort(Factors),
    /// Whatever it takes.
    Always(Factors),
}

/// Points of a record from which on its strength is looked for only where it is asked for.
const LONG: usize = 20_000;

/// Strength of the loads of a motion at which it has another verdict.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Strength {
    /// The factor at which the body begins to move; `None` where no factor moves it, or where it does not begin at rest.
    pub onset: Option<f64>,
    /// Whether it overturns.
    pub overturning: VerdictStrength,
    /// Whether it slides too far, where a criterion says how far that is: the bound, and the verdict.
    pub slide: Option<(f64, VerdictStrength)>,
    /// Whether it turns too far, where a criterion says how far that is: the bound, and the verdict.
    pub max_theta: Option<(f64, VerdictStrength)>,
    /// The motions that were tried, their factors rising.
    pub tried: Vec<Tried>,
}

impl Strength {
    /// The strength of a case whose motion is `outcome`; `None` where it is not asked for, nothing goes with time, or the motion has no
    /// verdict.
    ///
    /// # Errors
    /// If a problem is refused.
    pub(super) fn of(
        case: &BlockCase,
        outcome: &MotionOutcome,
        asked: StrengthAsked,
    ) -> Result<Option<Strength>, MotionError> {
        let factors = match asked {
            StrengthAsked::No => return Ok(None),
            StrengthAsked::IfShort(_)
                if case.problem.histories().any(|history| history.times().len() >= LONG) =>
            {
                return Ok(None);
            }
            StrengthAsked::IfShort(factors) | StrengthAsked::Always(factors) => factors,
        };
        let varies = case.problem.histories().any(|history| history.end().is_finite());
        if !varies || !Tried::of(1.0, outcome).ended {
            return Ok(None);
        }
        let problem = &case.problem;
        let strengths = Strengths::of(problem, outcome, factors)?;
        let overturning = strengths.verdict(|tried| tried.overturned)?;
        let [mut slide, mut max_theta] = [None, None];
        for criterion in &case.criteria {
            match *criterion {
                MotionCriterion::Slide(bound) => {
                    slide = Some((bound, strengths.verdict(|tried| tried.is_beyond(bound))?));
                }
                MotionCriterion::MaxTheta(bound) => {
                    max_theta = Some((bound, strengths.verdict(|tried| tried.is_turned_beyond(bound))?));
                }
                MotionCriterion::NotOverturned => {}
            }
        }
        Ok(Some(Strength { onset: onset(problem)?, overturning, slide, max_theta, tried: strengths.tried }))
    }
}
