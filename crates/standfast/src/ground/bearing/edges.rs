//! The boundaries of the plane of load factor and friction on ground that fails.

use super::situated::SituatedGround;
use super::{Ground, GroundPath};
use crate::error::InputError;
use crate::ground::load_plane::{LoadEdge, Rising, rigid};
use crate::ground::roots::between;
use crate::mode::Slip;
use crate::situation::Situation;
use crate::verdict::Verdict;

/// A body under loads that rise, on ground that fails.
#[derive(Debug, Clone, Copy)]
pub(in crate::ground) struct FailingEdges {
    rising: Rising,
    path: GroundPath,
}

/// The friction to slip up to which is looked: no formula bears a body that slides with more.
pub(super) const MOST_INCLINED: f64 = 10.0;
/// Number of frictions looked at for one with which the ground bears the body.
const STEPS: u32 = 60;

impl FailingEdges {
    pub(in crate::ground) fn new(situation: &Situation, ground: Ground) -> Result<FailingEdges, InputError> {
        Ok(FailingEdges { rising: Rising::of(situation), path: GroundPath::new(ground, situation)? })
    }

    pub(in crate::ground) fn rising(&self) -> &Rising {
        &self.rising
    }

    pub(in crate::ground) fn verdict(
        &self,
        factor: f64,
        friction: f64,
    ) -> Result<Option<Verdict>, InputError> {
        let on = SituatedGround::new(self.path, friction * self.rising.ratio);
        Ok(on.decide(rigid(&self.rising, factor, friction)?, factor).verdict)
    }

    pub(in crate::ground) fn at(&self, edge: LoadEdge, factor: f64) -> Option<f64> {
        let rising = &self.rising;
        match edge {
            LoadEdge::Friction { slips } => Some(rising.sticking(rising.inclination(factor)?, slips)),
            LoadEdge::Bearing { slip, largest } => {
                Some(rising.sticking(self.borne(slip, factor)?[usize::from(largest)], true))
            }
            LoadEdge::Reaction { .. } | LoadEdge::Turn { .. } => None,
        }
    }

    /// The least and the largest friction to slip with which a body that slides is borne. The eccentricity
    /// is least at one friction, and an inclination only takes away: what is borne is taken as one stretch.
    fn borne(&self, slip: Slip, factor: f64) -> Option<[f64; 2]> {
        let excess = |mu: f64| self.path.excess(Some((slip, mu)), factor);
        self.path.sliding_reaction(factor, slip, 0.0)?;
        // Up to the friction with which the reaction is in the middle of the base, and somewhat beyond.
        let even = self.path.even_friction(slip, factor).filter(|mu| (0.0..MOST_INCLINED).contains(mu));
        let reach = 1.5 * even.unwrap_or(0.0).max(0.8);
        let steps: Vec<f64> = (0..=STEPS).map(|i| reach * f64::from(i) / f64::from(STEPS)).collect();
        let near = steps.into_iter().chain(even).max_by(|one, two| excess(*one).total_cmp(&excess(*two)))?;
        let step = reach / f64::from(STEPS);
        let (mut low, mut high) = ((near - step).max(0.0), near + step);
        for _ in 0..80 {
            let third = (high - low) / 3.0;
            if excess(low + third) < excess(high - third) { low += third } else { high -= third }
        }
        let middle = low + (high - low) / 2.0;
        let best = if excess(middle) > excess(near) { middle } else { near };
        if excess(best) < 0.0 {
            return None;
        }
        let least = between(excess, 0.0, best).filter(|_| excess(0.0) < 0.0).unwrap_or(0.0);
        Some([least, between(excess, best, MOST_INCLINED)?])
    }
}
