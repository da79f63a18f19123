//! A situation on ground that can fail: what begins under the full load, and on the way there.

use super::{Ground, GroundPath, LoadFactors};
use crate::departure::Departure;
use crate::error::InputError;
use crate::mode::{Mode, Slip};
use crate::neighbour::Neighbour;
use crate::situation::{Outcome, Response, Situation};
use crate::stage::Stage;
use crate::verdict::{Decision, Verdict};

/// The answer to a situation on ground that can fail.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct BearingOutcome {
    /// The answer as of any base: rest, sliding, or the ground fails.
    pub outcome: Outcome,
    /// Load factors at which the ground fails under a body that friction holds.
    pub load_factors: LoadFactors,
}

/// The situation on `ground`: it rests or slides where it does so on rigid ground and the ground bears the reaction, R ≥ P. Where it would
/// turn, the ground under the edge that is loaded alone fails first.
///
/// # Errors
/// As [`GroundPath::new`]; or if a number is out of range.
pub fn outcome(situation: &Situation, ground: Ground) -> Result<BearingOutcome, InputError> {
    let rigid = situation.outcome()?;
    let on =
        SituatedGround { path: GroundPath::new(ground, situation)?, friction: situation.kinetic_friction() };
    let load_factors = on.path.load_factors();
    let mode = rigid.full.mode();
    let decision = on.decide(mode, 1.0);
    let motion = rigid.full.motion.filter(|_| decision.mode() == mode);
    let path = on.stages(&rigid.path, load_factors.given);
    let begins = match rigid.departure {
        Departure::AtOnce { verdict, permanent: true } => verdict.and_then(Verdict::mode),
        _ => Some(Mode::Rest),
    };
    let departure = Departure::along(on.decide(begins, 0.0).verdict, path.iter().copied().map(Ok))?;
    let boundary = rigid.full.boundary.filter(|_| decision.mode() == mode);
    let full = Response { verdict: decision.verdict, modes: decision.modes, motion, boundary, ..rigid.full };
    Ok(BearingOutcome { outcome: Outcome { full, departure, path, ..rigid }, load_factors })
}

/// The ground under a situation, and its friction to slip.
pub(super) struct SituatedGround {
    path: GroundPath,
    friction: f64,
}

impl SituatedGround {
    pub(super) fn new(path: GroundPath, friction: f64) -> SituatedGround {
        SituatedGround { path, friction }
    }

    /// Slip and friction with which a mode of the rigid problem presses the ground, neither of rest; `None` of one that turns, or flies.
    fn pressing(&self, mode: Mode) -> Option<Option<(Slip, f64)>> {
        match (mode, mode.corner(), mode.slip()) {
            (Mode::Rest, ..) => Some(None),
            (_, None, Some(slip)) => Some(Some((slip, self.friction))),
            _ => None,
        }
    }

    /// The decision on a mode of the rigid problem.
    pub(super) fn decide(&self, mode: Option<Mode>, factor: f64) -> Decision {
        let verdict = mode.map(|mode| match self.pressing(mode) {
            Some(slip) if self.path.excess(slip, factor) >= 0.0 => Verdict::Begins(mode),
            None if mode == Mode::Flight => Verdict::Begins(mode),
            _ => Verdict::BearingFailure,
        });
        Decision::from(verdict)
    }

    /// The stages of the rigid problem, parted where the ground begins to fail or to bear again; `first` is where it fails under a body
    /// at rest.
    fn stages(&self, rigid: &[Stage], first: f64) -> Vec<Stage> {
        let mut stages = Vec::new();
        for stage in rigid {
            let mode = stage.mode();
            let pressing = mode.and_then(|mode| self.pressing(mode));
            let crossings = |slip| self.path.crossings(slip, stage.from, stage.to);
            let mut ends = pressing.map_or_else(Vec::new, crossings);
            if mode == Some(Mode::Rest) {
                // One crossing, found twice.
                let is_first = |end: &&mut f64| (**end - first).abs() <= 16.0 * f64::EPSILON * first;
                ends.iter_mut().filter(is_first).for_each(|end| *end = first);
            }
            let mut from = stage.from;
            for to in ends.into_iter().chain([stage.to]).filter(|to| *to > stage.from) {
                let inside = if to.is_finite() { from + (to - from) / 2.0 } else { 2.0 * from + 1.0 };
                let Decision { verdict, modes } = self.decide(mode, inside);
                Stage { from, to, verdict, modes }.join(&mut stages);
                from = to;
            }
        }
        stages
    }
}
