//! How a motion begins, or goes on from a moment of another; and how it is left.

use standfast::contact::Block;
use standfast::{Corner, Mode, Slip};

use super::{Machine, direction};
use crate::decide::{Contact, turning};
use crate::error::MotionError;
use crate::impact::CORNERS;
use crate::outcome::{End, Why};
use crate::problem::{Going, Initial};
use crate::series::{Pose, arm, lever, velocity};

impl Machine<'_> {
    /// The state at the beginning.
    pub(super) fn begin(&mut self) -> Result<Option<End>, MotionError> {
        self.first = self.pose;
        let tiny = 1e-12 * self.scales.length;
        let gap = |corner| self.pose.y - lever(self.block, corner, self.pose.θ)[1];
        let touching = self.initial.touching.unwrap_or_else(|| CORNERS.map(|corner| gap(corner) <= tiny));
        let place = |corner| [self.pose.x, lever(self.block, corner, self.pose.θ)[0]];
        self.feet = CORNERS.map(place);
        if let Some(slide) = self.initial.slide {
            self.feet.iter_mut().zip(slide).for_each(|(foot, slide)| foot[0] -= slide);
        } else if let Some(lower) = (0..2).find(|i| touching[*i]) {
            // A body that rocks over without slipping stays where it is, whichever corner it began on.
            let [x, c] = self.feet[lower];
            self.feet =
                CORNERS.map(|corner| [x + (c - arm(self.block, CORNERS[lower])), arm(self.block, corner)]);
        }
        self.max_theta[0] = self.pose.θ.abs();
        let tiny = tiny / self.scales.time;
        let end = if self.initial.touching.is_some() {
            self.resume(touching, tiny)?
        } else {
            self.begin_with(touching, tiny)?
        };
        if touching == [false, false] {
            self.gaps = self.gaps_above(self.initial.gap);
        }
        Ok(end)
    }

    /// The state of a body that begins with these corners on the base.
    fn begin_with(&mut self, touching: [bool; 2], tiny: f64) -> Result<Option<End>, MotionError> {
        let [left, right] = CORNERS.map(|corner| velocity(self.block, corner, &self.pose));
        let up = [left[1], right[1]];
        let approach = (0..2).any(|i| touching[i] && up[i] < -tiny);
        let mut closed = [0, 1].map(|i| touching[i] && up[i] <= tiny);
        let mut slip = None;
        if approach {
            let Some(after) = self.meet(touching, true) else {
                return Ok(Some(self.ended(Why::NoContinuation, End::NoContinuation)));
            };
            (closed, slip) = (after.closed, after.slip);
        } else if let Some(i) = (0..2).find(|i| closed[*i]) {
            let along = [left[0], right[0]][i];
            slip = direction(along, tiny);
        }
        if self.pose.ω.abs() * self.scales.length > tiny && closed == [true, true] {
            // Both touch and neither moves up: no rotation is left, up to rounding.
            closed = CORNERS.map(|corner| turning(corner) == self.pose.ω.signum());
        }
        let decision = self.decide(Contact { closed, slip, failed: None, zero: None, jump: true });
        self.pressed(closed, slip)?;
        Ok(self.go_on(Why::Start, decision, slip, closed))
    }

    /// Refuses a body that begins at rest and floats.
    fn pressed(&self, closed: [bool; 2], slip: Option<Slip>) -> Result<(), MotionError> {
        let pressing = self.forcing.pressing;
        let floats = closed == [true, true] && slip.is_none() && pressing <= 0.0;
        if floats { Err(MotionError::Floats { pressing }) } else { Ok(()) }
    }

    /// The state from which a motion goes on: that of the corners that are said to touch, and of their slip, where its conditions hold.
    fn resume(&mut self, closed: [bool; 2], tiny: f64) -> Result<Option<End>, MotionError> {
        let touching = CORNERS.into_iter().find(|corner| closed[*corner as usize]);
        let along = touching.map_or(0.0, |corner| velocity(self.block, corner, &self.pose)[0]);
        let slip = match self.initial.going {
            None => direction(along, tiny),
            Some(Going::Sticks) => None,
            Some(Going::Slips(slip)) => Some(slip),
        };
        // A slip that only begins has no velocity.
        let begins = along * slip.map_or(0.0, Slip::sign) <= tiny;
        if let Some(corner) = touching.filter(|_| begins) {
            self.pose.vx = -lever(self.block, corner, self.pose.θ)[1] * self.pose.ω;
        }
        self.first = self.pose;
        self.pressed(closed, slip)?;
        let same = match (closed, slip) {
            ([true, true], None) => Mode::Rest,
            ([true, true], Some(slip)) => Mode::slide(slip),
            ([false, false], _) => Mode::Flight,
            ([o, _], slip) => {
                let corner = if o { Corner::O } else { Corner::OPrime };
                slip.map_or(Mode::rock(corner), |slip| Mode::slide_rock(corner, slip))
            }
        };
        let decision = self.decide(Contact { closed, slip, failed: None, zero: None, jump: slip.is_none() });
        if decision.modes.contains(same) || same == Mode::Flight {
            // It is not chosen here, whatever else might begin.
            self.take(same, begins);
            self.say(Why::Start, [same].into_iter().collect());
            return Ok(None);
        }
        Ok(self.go_on(Why::Start, decision, slip, closed))
    }

    /// Pose, rates and contact at the end, from which the motion goes on as if it had not been left.
    pub(super) fn last(&self, time: f64) -> Initial {
        let (closed, slip) = self.contact();
        let gaps = CORNERS.map(|corner| self.pose.y - lever(self.block, corner, self.pose.θ)[1]);
        let slide = CORNERS.map(|corner| self.slide_of(corner));
        Initial {
            time,
            x: self.pose.x,
            theta: self.pose.θ,
            omega: self.pose.ω,
            vx: Some(self.pose.vx),
            vy: Some(self.pose.vy),
            gap: gaps[0].min(gaps[1]).max(0.0),
            touching: Some(closed),
            going: Some(slip.map_or(Going::Sticks, Going::Slips)),
            slide: Some(slide),
        }
    }
}

/// The pose at the beginning. A velocity that is not given is that of a lower corner that stays where it is.
pub(super) fn started(block: &Block, initial: &Initial) -> Pose {
    let Initial { x, theta: θ, omega: ω, vx, vy, gap, touching, .. } = initial.put();
    let lower = match touching {
        Some([true, false]) => Corner::O,
        Some([false, true]) => Corner::OPrime,
        _ if θ > 0.0 || (θ == 0.0 && ω >= 0.0) => Corner::O,
        _ => Corner::OPrime,
    };
    let [c, h] = lever(block, lower, θ);
    let flies = gap > 0.0 || touching == Some([false, false]);
    let (along, up) = if flies { (0.0, 0.0) } else { (-h * ω, -c * ω) };
    Pose { x, y: h + gap, θ, vx: vx.unwrap_or(along), vy: vy.unwrap_or(up), ω }
}
