//! How a probability changes with the mean and the deviation of an input's law.
//!
//! By central differences with the same points: an integral has its digits, and of points in the same places the difference is as precise as the
//! probability, for along the line nothing is sampled and what is left is smooth.

use crate::law::Moments;
use crate::method::{Method, by};
use crate::problem::{Outcomes, RandomVector};
use crate::sample::{Effort, Work};

/// Slopes of a probability along the mean and the deviation of one input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes {
    /// Mean and deviation of the law before it is cut.
    pub moments: Moments,
    /// ∂P/∂mean; `None` where the law has no other mean of the same kind.
    pub by_mean: Option<f64>,
    /// ∂P/∂sd, likewise.
    pub by_sd: Option<f64>,
}

/// Step of a difference, in deviations.
const STEP: f64 = 0.01;
/// Evaluations of an integral, or points in its place.
const INTEGRATED: u64 = 1 << 19;

/// Slopes of the probability of a set along the law of one input, found by the method that found it, with as many points; `None` of a law without
/// a deviation, or one that depends on other inputs.
pub fn slopes<O: Outcomes>(
    (laws, outcomes, set): (&RandomVector, &O, u64),
    input: usize,
    (method, about, points): (Method, &[Vec<f64>], u64),
    (work, cost): (Work<'_>, u64),
) -> Option<Slopes> {
    let law = &laws.laws()[input];
    let is_given = !laws.parents(input).is_empty();
    let own = law.law().moments().filter(|own| own.sd > 0.0 && !is_given)?;
    // Hits that are counted have no slope.
    let method = if method == Method::MonteCarlo { Method::Sobol } else { method };
    let effort = match method {
        // An integral that is coarse would show its error in the difference.
        Method::Integrate => Effort { points: INTEGRATED, precision: STEP * STEP, ..work.effort },
        _ => Effort { points, precision: 0.0, floor: 0.0, ..work.effort },
    };
    let step = STEP * own.sd;
    let portions = work.portion.parts([1.0; 4]);
    let at = |moments: Moments, which: usize| {
        let changed = laws.clone().with_law(input, law.with_moments(own, moments)?);
        let work = (effort.within(portions[which]), cost);
        Some(by(method, &changed, outcomes, &[set], about, work).sampled.estimates[0].value)
    };
    let slope = |high: Option<f64>, low: Option<f64>| Some((high? - low?) / (2.0 * step));
    let with_mean = |mean: f64| Moments { mean, ..own };
    let with_sd = |sd: f64| Moments { sd, ..own };
    Some(Slopes {
        moments: own,
        by_mean: slope(at(with_mean(own.mean + step), 0), at(with_mean(own.mean - step), 1)),
        by_sd: slope(at(with_sd(own.sd + step), 2), at(with_sd(own.sd - step), 3)),
    })
}
