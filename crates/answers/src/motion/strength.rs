//! How near to another verdict a motion is: by the strength of its loads.

use standfast_model::{BlockCase, MotionCriterion};
use standfast_motion::strength::{Factors, Strengths, Tried, VerdictStrength, onset};
use standfast_motion::{MotionError, MotionOutcome};
use standfast_watch::Portion;

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

impl StrengthAsked {
    /// Factors at which a case is tried; `None` where its strength is not asked for.
    fn factors(self, case: &BlockCase) -> Option<Factors> {
        let is_long = || case.problem.histories().any(|history| history.times().len() >= LONG);
        match self {
            StrengthAsked::No => None,
            StrengthAsked::IfShort(factors) => Some(factors).filter(|_| !is_long()),
            StrengthAsked::Always(factors) => Some(factors),
        }
    }

    /// Number of motions that it takes, some for the halving of a change.
    pub(super) fn weight(self, case: &BlockCase) -> f64 {
        self.factors(case).map_or(0.0, |factors| factors.values().len() as f64 + HALVINGS)
    }
}

/// Number of motions, about, that a change of the verdict takes to be found between two factors.
const HALVINGS: f64 = 14.0;

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
        portion: Portion<'_>,
    ) -> Result<Option<Strength>, MotionError> {
        let Some(factors) = asked.factors(case) else { return Ok(None) };
        if !Strength::is_asked_of(case, outcome) {
            return Ok(None);
        }
        let tried = factors.values().len() as f64;
        let [of_tried, _] = portion.parts([tried, HALVINGS]);
        let strengths = Strengths::of(&case.problem, outcome, factors, of_tried)?;
        Strength::of_strengths(case, strengths).map(Some)
    }

    /// True of a motion that has a verdict, under loads that go with time.
    pub fn is_asked_of(case: &BlockCase, outcome: &MotionOutcome) -> bool {
        let varies = case.problem.histories().any(|history| history.end().is_finite());
        varies && Tried::of(1.0, outcome).ended
    }

    /// The strength of a case of motions that were [tried](Tried::under) before, one by one, their factors rising.
    ///
    /// # Errors
    /// If a problem is refused.
    pub fn of_tried(
        case: &BlockCase,
        outcome: &MotionOutcome,
        tried: Vec<Tried>,
    ) -> Result<Strength, MotionError> {
        Strength::of_strengths(case, Strengths::of_tried(&case.problem, outcome, tried))
    }

    fn of_strengths(case: &BlockCase, strengths: Strengths<'_>) -> Result<Strength, MotionError> {
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
                MotionCriterion::NotOverturned | MotionCriterion::OverturnedShare(_) => {}
            }
        }
        Ok(Strength { onset: onset(&case.problem)?, overturning, slide, max_theta, tried: strengths.tried })
    }
}
