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
                let borne = self.best(slip, factor)?;
                Some(rising.sticking(self.end(slip, factor, borne, largest)?, true))
            }
            LoadEdge::Reaction { .. } | LoadEdge::Turn { .. } => None,
        }
    }

    /// All boundaries that there are at a load factor: what several of them take is found once.
    pub(in crate::ground) fn all_at(&self, edges: &[LoadEdge], factor: f64) -> Vec<(f64, LoadEdge)> {
        let best = [Slip::Left, Slip::Right].map(|slip| self.best(slip, factor));
        let at = |edge: LoadEdge| match edge {
            LoadEdge::Bearing { slip, largest } => {
                let borne = best[usize::from(slip == Slip::Right)]?;
                Some(self.rising.sticking(self.end(slip, factor, borne, largest)?, true))
            }
            _ => self.at(edge, factor),
        };
        edges.iter().filter_map(|edge| Some((at(*edge)?, *edge))).collect()
    }

    fn excess(&self, slip: Slip, factor: f64) -> impl Fn(f64) -> f64 {
        move |mu| self.path.excess(Some((slip, mu)), factor)
    }

    /// The least or the largest friction to slip with which a body that slides is borne, of one stretch with `borne` in it. The eccentricity
    /// is least at one friction, and an inclination only takes away: what is borne is taken as one stretch.
    fn end(&self, slip: Slip, factor: f64, borne: f64, largest: bool) -> Option<f64> {
        let excess = self.excess(slip, factor);
        if largest {
            return between(excess, borne, MOST_INCLINED);
        }
        Some(if excess(0.0) < 0.0 { between(excess, 0.0, borne).unwrap_or(0.0) } else { 0.0 })
    }

    /// A friction to slip with which a body that slides is borne, if there is one.
    fn best(&self, slip: Slip, factor: f64) -> Option<f64> {
        let excess = self.excess(slip, factor);
        self.path.sliding_reaction(factor, slip, 0.0)?;
        // Up to the friction with which the reaction is in the middle of the base, and somewhat beyond.
        let even = self.path.even_friction(slip, factor).filter(|mu| (0.0..MOST_INCLINED).contains(mu));
        // Mostly it is borne at one of these.
        if let Some(borne) = [Some(0.0), even].into_iter().flatten().find(|mu| excess(*mu) >= 0.0) {
            return Some(borne);
        }
        // Beyond the middle the eccentricity grows with the friction, and soil bears less and less.
        if even.is_none() && !self.path.ground().is_envelope() {
            return None;
        }
        let reach = 1.5 * even.unwrap_or(0.0).max(0.8);
        let step = reach / f64::from(STEPS);
        let looked = (1..=STEPS).map(|i| step * f64::from(i)).map(|mu| (mu, excess(mu)));
        let (near, most) = looked.max_by(|one, two| one.1.total_cmp(&two.1))?;
        if most >= 0.0 {
            return Some(near);
        }
        let (mut low, mut high) = ((near - step).max(0.0), near + step);
        for _ in 0..80 {
            let third = (high - low) / 3.0;
            let (one, other) = (low + third, high - third);
            let (at_one, at_other) = (excess(one), excess(other));
            if at_one.max(at_other) >= 0.0 {
                return Some(if at_one >= at_other { one } else { other });
            }
            if at_one < at_other { low = one } else { high = other }
        }
        None
    }
}
