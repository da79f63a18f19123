//! Slips that may be in a case in time whose values are possible.

use standfast_motion::{Initial, MotionProblem};

use crate::digits::digits;
use crate::motion::MotionWarning;
use crate::warning::SHAKING;

/// Points of a history further apart than this share of √(B/g) may leave out what moves the body.
const COARSE: f64 = 0.05;

/// A body keeps less of its rate at an impact than this.
const LOSSLESS: f64 = 0.999;

/// Possible slips in a problem whose histories have points up to `step` apart, if they have points.
pub(crate) fn slips(problem: &MotionProblem, step: Option<f64>) -> Vec<MotionWarning> {
    let mut slips = Vec::new();
    let gravity = problem.gravity;
    for (key, history) in [("horizontal", &problem.base.horizontal), ("vertical", &problem.base.vertical)] {
        let share = history.as_ref().map_or(0.0, |history| history.peak() / gravity);
        if share > 0.0 && !SHAKING.contains(share) {
            let name = if share > 1.0 { "strong-earthquake" } else { "weak-earthquake" };
            let words = format!(
                "the {key} acceleration of the base reaches {} g; usual peaks: {SHAKING} g. Check its unit",
                digits(share)
            );
            slips.push(MotionWarning { name, words });
        }
    }
    let still = problem.initial == Initial::default();
    if still && !problem.histories().any(|history| history.end().is_finite()) {
        let words =
            "nothing moves the body: no load goes with time, the base does not move, and it begins at rest"
                .to_owned();
        slips.push(MotionWarning { name: "nothing-moves", words });
    }
    let time = (problem.block.b1.max(problem.block.b2) / gravity).sqrt();
    if let Some(step) = step.filter(|step| *step > COARSE * time) {
        let words = format!("points are up to {step:.3} apart, {:.2} of √(B/g)", step / time);
        slips.push(MotionWarning { name: "coarse-record", words });
    }
    if let Some(ratio) = problem.ratio()
        && ratio > LOSSLESS
    {
        let words = format!(
            "a ratio of {ratio} leaves almost all of the energy at an impact; measured ones lose more"
        );
        slips.push(MotionWarning { name: "lossless-impact", words });
    }
    slips
}
