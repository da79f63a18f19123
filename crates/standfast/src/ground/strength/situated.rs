//! A situation on a base that crushes, in SI units.

use super::edges::reduced_strength;
use super::path::{bearing_range, stages};
use super::{CrushMotion, solve};
use crate::departure::Departure;
use crate::error::InputError;
use crate::loads::Pose;
use crate::situation::{Outcome, Response, Situation};
use crate::verdict::Verdict;

/// The answer to a situation on a base that crushes.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct CrushOutcome {
    /// The answer as of any base.
    pub outcome: Outcome,
    /// ω = P/(2B q_u) under the full load.
    pub omega: f64,
    /// The motion of the verdict's mode under the full load, and where the base is pressed: m/s², rad/s², N, m from the centre of mass.
    pub motion: Option<CrushMotion>,
    /// The least load factor at which the base does not bear the reaction of a body that friction holds: zero where it does not bear
    /// that of the permanent loads, infinite where it bears that of any multiple of the variable ones.
    pub load_factor: f64,
}

/// The situation on a base of `strength` q_u (Pa).
///
/// ```
/// use standfast::ground::strength::outcome;
/// use standfast::loads::{Action, Load, LoadKind, LoadSource};
/// use standfast::{Body, Situation};
///
/// // The README's caisson in air: on rigid ground it first slides, at 82.4 % of the load; on 3 MPa it rocks.
/// let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-2.7e6, 11.5));
/// let situation = Situation::new(Body::new(15.0, 12.0, 378e3)?, 0.6, 9.81)?.with_weight().with(push);
/// let on_stone = outcome(&situation, 3e6)?;
/// assert_eq!(on_stone.outcome.departure.verdict().unwrap().symbol(), "RO");
/// assert!(on_stone.outcome.departure.load_factor() < 0.824);
/// # Ok::<(), standfast::InputError>(())
/// ```
///
/// # Errors
/// If `strength` is not above zero, the base is round, or a number is out of range.
pub fn outcome(situation: &Situation, strength: f64) -> Result<CrushOutcome, InputError> {
    let rigid = situation.outcome()?;
    let reduced = reduced_strength(situation, strength)?;
    let body = situation.body();
    // Lengths in B, forces in m g, as those of the situation's block.
    let (half_width, weight) = (body.width() / 2.0, body.mass() * situation.gravity());
    let block = situation.reduced_block().0;
    let at = |factor: f64| situation.reduced_wrench(&situation.wrench_at(factor, Pose::UPRIGHT));
    let permanent = at(0.0);
    let solution = solve(&block, &at(1.0), reduced)?;
    let verdict = solution.verdict();
    let motion = verdict.and_then(Verdict::mode).and_then(|mode| solution.motion(mode));
    let motion = motion.map(|motion| motion.scaled(situation.gravity(), half_width, weight));
    let variable = at(1.0) + permanent * -1.0;
    // A load varies where it has stages on a rigid base.
    let path = match rigid.path.as_slice() {
        [] => Vec::new(),
        _ => stages(&block, &permanent, &variable, reduced)?,
    };
    let bearing = bearing_range(&block, &permanent, &variable, reduced)?;
    let load_factor = bearing.filter(|range| range.from <= 0.0).map_or(0.0, |range| range.to.max(0.0));
    let begin = solve(&block, &permanent, reduced)?.verdict();
    let departure = Departure::along(begin, path.iter().copied().map(Ok))?;
    let full = Response {
        verdict,
        modes: solution.modes,
        motion: motion.map(|crush| crush.motion),
        boundary: None,
        ..rigid.full
    };
    let outcome = Outcome { full, departure, path, ..rigid };
    Ok(CrushOutcome { outcome, omega: solution.omega(), motion, load_factor })
}
