//! The motion in time of a case: `[block]`, `[motion]`, the histories of loads and base, and the answer as text and JSON.
//!
//! A `[block]` is a body of which only ratios matter: lengths in any one unit, the mass as 1, accelerations as they come.
//!
//! ```
//! use standfast_cases::CaseFile;
//! use standfast_cases::motion::Follow;
//!
//! let text = "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.4\ngravity = 1\n\
//!     [motion.base]\nhorizontal = { shape = \"half-sine\", peak = 0.6, duration = 2 }\n";
//! let motions = CaseFile::parse("block.toml", text)?.follow(&Follow::default())?;
//! assert!(motions[0].1.outcome.at_rest());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod block;
mod criteria;
mod figures;
mod first_instant;
mod json;
mod rows;
mod series;
mod slips;
mod spectrum;
mod text;

pub(crate) use block::motions;
pub use block::{BlockCase, LoadPeak};
pub use criteria::{MOTION_CRITERIA, MotionCheck, MotionCriterion, MotionValue};
pub(crate) use criteria::{met_words, worst_checks};
pub use figures::MotionFigure;
pub use first_instant::FirstInstant;
pub(crate) use first_instant::at_first_instant;
pub use json::all_json;
pub use rows::{ColumnError, MotionRows, RESULTS as ROW_RESULTS};
pub use series::{SERIES, series, series_csv};
pub use spectrum::{
    Progressed, Spectrum, SpectrumError, SpectrumKind, SpectrumPoints, SpectrumRequest, SpectrumSteps,
    in_order,
};
pub use text::Rows;

use standfast_motion::{Keep, sensitivity, simulate};

pub use crate::record::ReadFile;
pub use standfast_motion::record::{Record, RecordUnit};
pub use standfast_motion::{MotionError, MotionOutcome, Position};

/// Accelerations of the base that are given beside a case, in place of those it names: in m/s², or in the units of a `[block]`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GivenBase {
    /// To the right.
    pub horizontal: Option<Record>,
    /// Upwards.
    pub vertical: Option<Record>,
}

/// Request for more than the motion itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Follow {
    /// True if it is run once more with inputs changed a little.
    pub sensitivity: bool,
    /// True if the whole motion is kept, for its [series](series_csv) and its [figures](BlockCase::figures).
    pub series: bool,
}

/// The motion of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct FollowedMotion {
    /// Outcome for the body.
    pub outcome: MotionOutcome,
    /// The larger change of slide, in B, and of max |θ| for a relative change of friction and of d, if it was asked for.
    pub sensitivity: Option<f64>,
    /// Warnings of possible slips, and of values outside the range of the model.
    pub warnings: Vec<MotionWarning>,
}

/// Something that may be a slip, or leaves the range of the model.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionWarning {
    /// Its name.
    pub name: &'static str,
    /// The finding, with its number.
    pub words: String,
}

/// Follows the motion in every situation of a case; the worst first: by what is used of the criteria, overturned, past balance, by the
/// largest slide.
///
/// # Errors
/// If a problem is refused.
pub fn follow_all(
    cases: Vec<BlockCase>,
    follow: &Follow,
) -> Result<Vec<(BlockCase, FollowedMotion)>, MotionError> {
    let follow = |case: BlockCase| case.follow(follow).map(|followed| (case, followed));
    let mut answers = cases.into_iter().map(follow).collect::<Result<Vec<_>, _>>()?;
    let rank = |outcome: &MotionOutcome| (!outcome.overturned(), !outcome.past_balance);
    let used = |case: &BlockCase, outcome: &MotionOutcome| {
        case.checks(outcome).first().map_or(0.0, MotionCheck::urgency)
    };
    answers.sort_by(|(case, one), (other, two)| {
        let (one, two) = (&one.outcome, &two.outcome);
        let by_criteria = used(other, two).total_cmp(&used(case, one));
        by_criteria.then(rank(one).cmp(&rank(two))).then(two.max_slide.total_cmp(&one.max_slide))
    });
    Ok(answers)
}

impl BlockCase {
    /// Follows the motion to its end.
    ///
    /// # Errors
    /// If the problem is refused.
    pub fn follow(&self, follow: &Follow) -> Result<FollowedMotion, MotionError> {
        let outcome = simulate(&self.problem, Keep { steps: follow.series })?;
        let sensitivity = if follow.sensitivity { Some(sensitivity(&self.problem)?) } else { None };
        let mut warnings = self.warnings.clone();
        warnings.extend(found(self, &outcome));
        Ok(FollowedMotion { outcome, sensitivity, warnings })
    }
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
    if outcome.t_rest_is_bound {
        let words =
            "the last motion, too small to matter, was not followed: the time of rest is a lower bound"
                .to_owned();
        warnings.push(MotionWarning { name: "rest-is-bound", words });
    }
    warnings
}
