//! The motion of a case in time: followed to its end, in many variants as a table or a spectrum, and checked against its criteria.
//!
//! A `[block]` is a body of which only ratios matter: lengths in any one unit, the mass as 1, accelerations as they come.
//!
//! ```
//! use standfast_answers::motion::{Follow, FollowedMotion};
//! use standfast_model::CaseFile;
//!
//! let text = "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.4\ngravity = 1\n\
//!     [motion.base]\nhorizontal = { shape = \"half-sine\", peak = 0.6, duration = 2 }\n";
//! let motions = FollowedMotion::of_file(&CaseFile::parse("block.toml", text)?, &Follow::default())?;
//! assert!(motions[0].outcome.at_rest());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arrays;
mod copies;
mod criteria;
mod points;
mod resume;
mod rows;
mod series;
mod spectrum;
mod strength;

pub use arrays::{MotionOf, MotionsAsked, MotionsError, MotionsFound, ShakingArray, motions_of, still_base};
pub use copies::{Copies, Copy, CopyQuantile, Differs};
pub(crate) use criteria::worst_checks;
pub use criteria::{MotionCheck, MotionValue};
pub use points::{Extremes, PointAnswer};
pub use resume::{ResumeError, resume};
pub use rows::{ColumnError, MotionRows, RESULTS as ROW_RESULTS, RowFault};
pub use series::{STATE_AT, SeriesAsked, SeriesColumn, SeriesRow};
pub use spectrum::{
    OVERTURNING_FROM, ROCKING_LEVELS, RockingDistance, RockingEdges, Spectrum, SpectrumError, SpectrumKind,
    SpectrumPoints, SpectrumRequest, SpectrumSteps, SpectrumValues, in_order, rocking_class,
};
pub use strength::{Strength, StrengthAsked};

use standfast_model::{BlockCase, CaseFile, MotionCriterion, MotionWarning};
pub use standfast_model::{CopiesAsked, CopiesOptions, Spread};
use standfast_motion::divergence::Divergence;
use standfast_motion::{Keep, MotionError, MotionOutcome, simulate};
use standfast_probability::sample::Estimate;
use standfast_watch::Portion;

use crate::digits::digits;

use crate::error::CaseError;

/// Request for more than the motion itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Follow {
    /// True if it is run once more with inputs changed a little, to see how far the two part.
    pub divergence: bool,
    /// When it is run under stronger and weaker loads.
    pub strength: StrengthAsked,
    /// True if the whole motion is kept, for its [series](SeriesAsked) and its figures.
    pub series: bool,
    /// Number of threads for the copies that the case asks for; 0 is one.
    pub threads: usize,
}

/// The motion of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct FollowedMotion {
    /// The case that it is of.
    pub case: BlockCase,
    /// Outcome for the body.
    pub outcome: MotionOutcome,
    /// How far it parts from the motion of almost the same body, if that was asked for.
    pub divergence: Option<Divergence>,
    /// How much stronger or weaker loads have to be for another verdict, if that was asked for and there is one.
    pub strength: Option<Strength>,
    /// Points of the body whose accelerations are asked for.
    pub points: Vec<PointAnswer>,
    /// Outcomes of copies with numbers a little other, if they were asked for.
    pub copies: Option<Copies>,
    /// Warnings of possible slips, and of values outside the range of the model.
    pub warnings: Vec<MotionWarning>,
}

/// Share of the base's width below which a slide is rounding.
const ROUNDING: f64 = 1e-12;

impl FollowedMotion {
    /// Follows the motion of a case to its end.
    ///
    /// # Errors
    /// If the problem is refused.
    pub fn of(case: BlockCase, follow: &Follow) -> Result<FollowedMotion, MotionError> {
        FollowedMotion::within(case, follow, Portion::UNSEEN)
    }

    fn within(case: BlockCase, follow: &Follow, portion: Portion<'_>) -> Result<FollowedMotion, MotionError> {
        portion.check()?;
        let copied =
            case.copies.as_ref().map_or(0.0, |copies| copies.number as f64 / follow.threads.max(1) as f64);
        let [of_itself, of_strength, of_copies] = portion.parts([2.0, follow.strength.weight(&case), copied]);
        let asks_for_share = |criterion: &_| matches!(criterion, MotionCriterion::OverturnedShare(_));
        if case.copies.is_none() && case.criteria.iter().any(asks_for_share) {
            return Err(MotionError::NoCopies);
        }
        let steps = follow.series || follow.divergence || !case.points.is_empty();
        let mut outcome = simulate(&case.problem, Keep { steps })?;
        let block = &case.problem.block;
        for slide in [&mut outcome.slide, &mut outcome.max_slide] {
            if slide.abs() < ROUNDING * (block.b1 + block.b2) {
                *slide = 0.0;
            }
        }
        let divergence = follow.divergence.then(|| Divergence::of(&case.problem, &outcome)).transpose()?;
        of_itself.reached(1.0);
        let strength = Strength::of(&case, &outcome, follow.strength, of_strength)?;
        let points = case.points.iter().map(|point| PointAnswer::of(&case, &outcome, point)).collect();
        let copies = case
            .copies
            .as_ref()
            .map(|asked| Copies::of(&case.problem, &outcome, asked, follow.threads.max(1), of_copies));
        let copies = copies.transpose()?;
        portion.reached(1.0);
        if !follow.series {
            outcome.steps = Vec::new();
        }
        let mut warnings = case.warnings.clone();
        warnings.extend(found(&case, &outcome));
        warnings.extend(few_copies(&case));
        Ok(FollowedMotion { case, outcome, divergence, strength, points, copies, warnings })
    }

    /// Follows the motion in every situation of a file; the worst first: by what is used of the criteria, overturned, past balance, by the share of
    /// copies that overturn, by the largest angle over that of balance, by the largest slide.
    ///
    /// # Errors
    /// If a load that varies has no history, or the problem is refused.
    pub fn of_file(file: &CaseFile, follow: &Follow) -> Result<Vec<FollowedMotion>, CaseError> {
        let all = FollowedMotion::of_all(file.motions()?, follow, Portion::UNSEEN);
        all.map_err(|error| file.motion_refused(error))
    }

    /// Follows the motion in every situation of a case, the worst first, as a portion of work that somebody may watch.
    ///
    /// # Errors
    /// If a problem is refused, or the work is stopped.
    pub fn of_all(
        cases: Vec<BlockCase>,
        follow: &Follow,
        portion: Portion<'_>,
    ) -> Result<Vec<FollowedMotion>, MotionError> {
        let count = cases.len();
        let one = |(place, case)| FollowedMotion::within(case, follow, portion.part(place, count));
        let followed = cases.into_iter().enumerate().map(one);
        let mut answers = followed.collect::<Result<Vec<_>, _>>()?;
        let rank = |outcome: &MotionOutcome| (!outcome.overturned(), !outcome.past_balance);
        let used = |of: &FollowedMotion| of.checks().first().map_or(0.0, MotionCheck::urgency);
        answers.sort_by(|one, two| {
            let by_criteria = used(two).total_cmp(&used(one));
            let share =
                |of: &FollowedMotion| of.copies.as_ref().map_or(0.0, |copies| copies.overturned.value);
            let by_rank = rank(&one.outcome).cmp(&rank(&two.outcome));
            let by_copies = share(two).total_cmp(&share(one));
            let by_angle = two.of_balance().total_cmp(&one.of_balance());
            let by_slide = two.outcome.max_slide.total_cmp(&one.outcome.max_slide);
            by_criteria.then(by_rank).then(by_copies).then(by_angle).then(by_slide)
        });
        Ok(answers)
    }

    /// The criteria of the case, the governing one first.
    pub fn checks(&self) -> Vec<MotionCheck> {
        let of = |criterion: &_| MotionCheck::of(*criterion, self);
        let mut checks: Vec<_> = self.case.criteria.iter().map(of).collect();
        standfast::order::by_number(&mut checks, |one| -one.urgency());
        checks
    }

    /// True if all criteria are met; `None` where there is none.
    pub fn met(&self) -> Option<bool> {
        (!self.case.criteria.is_empty()).then(|| self.checks().iter().all(|check| check.met))
    }

    /// The largest |θ| over that of balance, of the side to which it is nearer to it.
    pub fn of_balance(&self) -> f64 {
        let block = &self.case.problem.block;
        self.outcome.max_theta / (block.b1.min(block.b2) / block.d).atan()
    }
}

/// So few copies that a criterion on their share cannot be met even if all of them stand.
fn few_copies(case: &BlockCase) -> Option<MotionWarning> {
    let number = case.copies.as_ref()?.number;
    let bound = case.criteria.iter().find_map(|criterion| match criterion {
        MotionCriterion::OverturnedShare(bound) => Some(*bound),
        _ => None,
    })?;
    let reaches = Estimate::two_sided(0, number as u64).high;
    if reaches <= bound {
        return None;
    }
    let enough = match bound > 0.0 {
        true => format!("{} are enough", (0.025f64.ln() / (-bound).ln_1p()).ceil()),
        false => "no number of them shows a share of 0".to_owned(),
    };
    let words = format!(
        "of {number} copies the interval reaches to {} even if all of them stand, and overturned_share = {} is asked: {enough}",
        digits(reaches),
        digits(bound)
    );
    Some(MotionWarning { name: "few-copies", words })
}

/// Warnings that the motion itself gives reason for.
fn found(case: &BlockCase, outcome: &MotionOutcome) -> Vec<MotionWarning> {
    let mut warnings = Vec::new();
    let block = &case.problem.block;
    if (block.m_x != 1.0 || block.m_y != 1.0) && outcome.max_theta > 0.05 {
        let words = format!(
            "the body turns by {:.3} rad, and water moves with it as if it did not turn: the added mass of a rocking body is another",
            outcome.max_theta
        );
        warnings.push(MotionWarning { name: "added-mass-turns", words });
    }
    if case.uplift && outcome.max_theta > 0.0 {
        let words = "water under the base presses as before while the base is lifted: how its pressure changes there is left out".to_owned();
        warnings.push(MotionWarning { name: "uplift-kept", words });
    }
    if outcome.impulse_left_base {
        let words = "the impulse that the measured ratio asks for acts beside the base: no base can give it"
            .to_owned();
        warnings.push(MotionWarning { name: "impulse-beside-base", words });
    }
    if outcome.reduced_impacts > 0 {
        let words = format!(
            "at {} of {} impacts the measured ratio would have given energy to the body, which slips: there it is the largest that does not",
            outcome.reduced_impacts, outcome.impacts
        );
        warnings.push(MotionWarning { name: "ratio-reduced", words });
    }
    if outcome.undetermined > 0 {
        let words = format!(
            "at {} of {} impacts, first at t = {:.4}, both corners meet the base at once, or one right after the other: how they rebound hangs on \
             stiffnesses that no rigid law knows",
            outcome.undetermined, outcome.impacts, outcome.t_undetermined
        );
        warnings.push(MotionWarning { name: "rebound-undetermined", words });
    }
    if outcome.t_rest_is_bound {
        let words =
            "the last motion, too small to matter, was not followed: the time of rest is a lower bound"
                .to_owned();
        warnings.push(MotionWarning { name: "rest-is-bound", words });
    }
    warnings
}
