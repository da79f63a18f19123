//! A wave that begins a rotation, followed by the motion in time.
//!
//! Thrust and uplift of the wave have the history of the slide's pulse, a symmetric triangle of its duration; everything else of the
//! case is there all the time. Impacts are without rebound. Each wave finds the body at rest, upright.

use standfast::loads::{LoadSource, Pose};
use standfast::wave::Goda;
use standfast_motion::{History, Keep, MotionProblem, is_own_weight, simulate};
use standfast_probability::sums::OtherEvent;

use crate::case::{Acting, Case, GodaWaves, Trial};
use crate::random::quantity::Bias;

/// Outcome of the wave: slide of the body at the end, and overturning. None if it cannot be followed.
pub(super) fn wave(
    case: &Case,
    waves: &GodaWaves,
    goda: Goda,
    duration: f64,
    [mu_s, mu_k]: [f64; 2],
    bias: impl Fn(Bias) -> f64,
) -> Option<OtherEvent> {
    let case = case.with_goda(GodaWaves { goda, ..waves.clone() });
    let situation = case.situation(Acting::All, Trial::AS_GIVEN).ok()?;
    let body = situation.body();
    let mut problem = MotionProblem::standing(&situation).ok()?;
    (problem.block.mu_s, problem.block.mu_k) = (mu_s, mu_k);
    for load in situation.loads().iter().filter(|load| !is_own_weight(load)) {
        if load.wrench(body, case.gravity, Pose::UPRIGHT) == standfast::Wrench::ZERO {
            continue;
        }
        let history = match load.source {
            LoadSource::WavePressure => History::triangle(bias(Bias::Thrust), 0.5 * duration, duration),
            LoadSource::WaveUplift => History::triangle(bias(Bias::Uplift), 0.5 * duration, duration),
            LoadSource::Force => History::constant(bias(Bias::Force)),
            _ => History::constant(1.0),
        };
        problem.add(&situation, load, &history.ok()?);
    }
    let outcome = simulate(&problem, Keep::default()).ok()?;
    Some(OtherEvent { amount: outcome.slide.abs(), ends: outcome.overturned() })
}
