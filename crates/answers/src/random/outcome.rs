//! Outcomes of a draw, by number, a bit for each: the modes by their codes, and what else there is.

use standfast::{Mode, Modes, Verdict};
use standfast_probability::problem::Pieces;

/// The body stays at rest.
pub(super) const REST: usize = Mode::Rest as usize;
/// The ground fails.
pub(super) const BEARING_FAILURE: usize = Verdict::BEARING_FAILURE_CODE as usize;
/// On a base seen from above: what ends rest as the loads rise is that the body slides, or that it tips. No mode has such a code.
pub(super) const PLAN_SLIDES: usize = 14;
/// The body tips first.
pub(super) const PLAN_TIPS: usize = 15;
/// The body is lifted.
pub(super) const FLIGHT: usize = Mode::Flight as usize;
/// The outcomes behind those of the modes, which have their codes: more than one mode is consistent.
pub(super) const NOT_UNIQUE: usize = 16;
/// Nothing presses the body on its base.
pub(super) const LIFTED: usize = 17;
/// The numbers do not go together.
pub(super) const NOT_A_BODY: usize = 18;
/// No mode is consistent.
pub(super) const NO_MODE: usize = 19;
/// The first of the outcomes of joints, two for each.
const JOINTS: usize = 20;
/// At most so many joints, the base among them: there is a bit for each outcome.
pub(super) const MOST_JOINTS: usize = (u64::BITS as usize - JOINTS) / 2;

/// Number of outcomes of bodies on so many joints, none of one body.
pub(super) fn count(joints: usize) -> usize {
    JOINTS + 2 * joints
}

/// Of bodies on joints, this joint leaves rest first, from the base, from zero: what is above it slides, or turns.
pub(super) fn of_joint(joint: usize, slides: bool) -> usize {
    JOINTS + 2 * joint + usize::from(!slides)
}

/// The joint of an outcome, and whether what is above it slides.
pub(super) fn joint(outcome: usize) -> Option<(usize, bool)> {
    let place = outcome.checked_sub(JOINTS)?;
    Some((place / 2, place.is_multiple_of(2)))
}

/// The outcomes that exclude each other and add up to one, of bodies on so many joints.
pub(super) fn of_joints(joints: usize, may_fail: bool) -> impl Iterator<Item = usize> {
    let of_joints = JOINTS..JOINTS + 2 * joints;
    [REST].into_iter().chain(of_joints).chain(may_fail.then_some(BEARING_FAILURE)).chain([NOT_A_BODY])
}

/// The outcomes that exclude each other and add up to one, on a base that may fail or on one that cannot.
pub(super) fn exclusive(may_fail: bool) -> impl Iterator<Item = usize> {
    modes().chain(may_fail.then_some(BEARING_FAILURE)).chain([NO_MODE, NOT_A_BODY])
}

/// The outcomes that exclude each other and add up to one, on a base seen from above.
pub(super) fn on_plan() -> impl Iterator<Item = usize> {
    [REST, PLAN_SLIDES, PLAN_TIPS, FLIGHT, NOT_A_BODY].into_iter()
}

/// The codes of all modes.
pub(super) fn modes() -> impl Iterator<Item = usize> {
    (0..16).filter(|code| Mode::from_code(*code as u8).is_some())
}

/// Everything but rest: modes, joints, ground that fails, and what is not a body.
pub(super) fn not_rest() -> u64 {
    exclusive(true)
        .chain(of_joints(MOST_JOINTS, false))
        .chain(on_plan())
        .filter(|outcome| *outcome != REST)
        .fold(0, |set, outcome| set | 1 << outcome)
}

/// A verdict's outcome.
pub(super) fn of_verdict(verdict: Option<Verdict>) -> usize {
    verdict.map_or(NO_MODE, |verdict| usize::from(verdict.code()))
}

/// A verdict's outcome, and whether its mode is the only one.
pub(super) fn of_modes(verdict: Option<Verdict>, modes: Modes) -> u64 {
    1 << of_verdict(verdict) | u64::from(modes.len() > 1) << NOT_UNIQUE
}

/// An interval of the line with the outcomes that hold, a bit for each, and what tells it from the one before.
pub(super) type Stretch = (f64, f64, u64, usize);

/// Intervals from left to right without those so narrow that rounding alone may have made them, between two values of one boundary: they
/// would come and go with every other number, and an integral would look for a kink at each.
pub(super) fn told_apart(all: impl Iterator<Item = Stretch>) -> Vec<Stretch> {
    const ROUNDING: f64 = 1e-12;
    let mut apart: Vec<Stretch> = Vec::new();
    for next in all.filter(|(from, to, ..)| to - from > ROUNDING * to.min(f64::MAX)) {
        match apart.last_mut() {
            Some(last) if last.2 == next.2 => last.1 = next.1,
            _ => apart.push(next),
        }
    }
    apart
}

/// No body for any value of the line.
pub(super) fn nothing(pieces: &mut Pieces) {
    pieces.push(f64::NEG_INFINITY, f64::INFINITY, NOT_A_BODY);
}

/// Outcomes that hold from one value to another, a bit for each.
pub(super) fn push_all(pieces: &mut Pieces, from: f64, to: f64, outcomes: u64) {
    (0..count(MOST_JOINTS))
        .filter(|outcome| outcomes >> outcome & 1 == 1)
        .for_each(|outcome| pieces.push(from, to, outcome));
}
