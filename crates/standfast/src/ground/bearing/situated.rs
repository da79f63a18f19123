//! A situation on ground that can fail: what begins under the full load, and on the way there.

use super::{Ground, GroundPath, LoadFactors};
use crate::error::InputError;
use crate::ground::{GroundDeparture, GroundStage, GroundVerdict};
use crate::mode::{Mode, Modes, Slip};
use crate::situation::{Departure, Outcome, Situation};

/// What a situation does on ground that can fail.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingOutcome {
    /// What begins under the full load, applied at once: rest, sliding, or the ground fails.
    pub verdict: Option<GroundVerdict>,
    /// The mode of the verdict; none where the ground fails.
    pub modes: Modes,
    /// Where the body leaves rest as the variable loads rise.
    pub departure: GroundDeparture,
    /// The stages of the rising variable loads, the last without end; none where all loads are permanent.
    pub path: Vec<GroundStage>,
    /// Where the ground fails under a body that friction holds.
    pub load_factors: LoadFactors,
}

/// The situation, whose outcome on rigid ground is `rigid`, on `ground`: it rests or slides where it does so on rigid ground and the ground bears
/// the reaction, R ≥ P. Where it would turn, the ground under the edge that is loaded alone fails first.
///
/// # Errors
/// As [`GroundPath::new`].
pub fn outcome(situation: &Situation, rigid: &Outcome, ground: Ground) -> Result<BearingOutcome, InputError> {
    let on = On { path: GroundPath::new(ground, situation)?, friction: situation.kinetic_friction() };
    let load_factors = on.path.load_factors();
    let verdict = on.verdict(rigid.full.mode, 1.0);
    let path = on.stages(rigid, load_factors.given);
    let begins = match rigid.departure {
        Departure::AtOnce { mode, permanent: true } => on.verdict(mode, 0.0),
        _ => on.verdict(Some(Mode::Rest), 0.0),
    };
    Ok(BearingOutcome {
        verdict,
        modes: verdict.and_then(GroundVerdict::mode).into_iter().collect(),
        departure: GroundDeparture::along(begins, &path),
        path,
        load_factors,
    })
}

/// The ground under a situation, and its friction to slip.
pub(super) struct On {
    path: GroundPath,
    friction: f64,
}

impl On {
    pub(super) fn new(path: GroundPath, friction: f64) -> On {
        On { path, friction }
    }

    /// How a mode of the rigid problem presses the ground: at rest, or sliding with a friction; `None` of one that turns, or flies.
    fn pressing(&self, mode: Mode) -> Option<Option<(Slip, f64)>> {
        match (mode, mode.corner(), mode.slip()) {
            (Mode::Rest, ..) => Some(None),
            (_, None, Some(slip)) => Some(Some((slip, self.friction))),
            _ => None,
        }
    }

    /// What becomes of a mode of the rigid problem.
    pub(super) fn verdict(&self, mode: Option<Mode>, factor: f64) -> Option<GroundVerdict> {
        let mode = mode?;
        let begins = GroundVerdict::Begins(mode);
        Some(match self.pressing(mode) {
            Some(slip) if self.path.excess(slip, factor) >= 0.0 => begins,
            None if mode == Mode::Flight => begins,
            _ => GroundVerdict::BearingFailure,
        })
    }

    /// The stages of the rigid problem, parted where the ground begins to fail or to bear again; `first` is where it fails under a body
    /// at rest.
    fn stages(&self, rigid: &Outcome, first: f64) -> Vec<GroundStage> {
        let mut stages: Vec<GroundStage> = Vec::new();
        let mut add = |from: f64, to: f64, verdict: Option<GroundVerdict>| match stages.last_mut() {
            Some(last) if last.verdict == verdict => last.to = to,
            _ => {
                let modes = verdict.and_then(GroundVerdict::mode).into_iter().collect();
                stages.push(GroundStage { from, to, verdict, modes });
            }
        };
        for stage in &rigid.path {
            let pressing = stage.mode.and_then(|mode| self.pressing(mode));
            let crossings = |slip| self.path.crossings(slip, stage.from, stage.to);
            let mut ends = pressing.map_or_else(Vec::new, crossings);
            if stage.mode == Some(Mode::Rest) {
                // One crossing, found twice.
                let is_first = |end: &&mut f64| (**end - first).abs() <= 16.0 * f64::EPSILON * first;
                ends.iter_mut().filter(is_first).for_each(|end| *end = first);
            }
            let mut from = stage.from;
            for to in ends.into_iter().chain([stage.to]).filter(|to| *to > stage.from) {
                let inside = if to.is_finite() { from + (to - from) / 2.0 } else { 2.0 * from + 1.0 };
                add(from, to, self.verdict(stage.mode, inside));
                from = to;
            }
        }
        stages
    }
}
