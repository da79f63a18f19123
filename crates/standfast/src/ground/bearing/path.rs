//! The ground while the load rises: its load factor beside that of sliding and rocking.

use super::{Ground, Reaction};
use crate::contact::Block;
use crate::error::InputError;
use crate::ground::roots::between;
use crate::loads::Pose;
use crate::mode::Slip;
use crate::plan::Plan;
use crate::quantity::{Expected, Quantity};
use crate::situation::Situation;
use crate::wrench::Wrench;

/// The load factors at which the ground fails, at its angle of friction and 2° to either side. Each is zero where the permanent
/// loads alone make it fail, and infinite where no multiple of the variable loads up to 10⁶ does.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LoadFactors {
    /// At the angle given.
    pub given: f64,
    /// At 2° less; `None` for an envelope, which has no angle.
    pub less: Option<f64>,
    /// At 2° more; likewise.
    pub more: Option<f64>,
}

/// The largest load factor looked at.
const FARTHEST: f64 = 1e6;

/// The width of a stretch in which a dip of R/P below 1 may be missed, as a share of its load factor.
const NARROWEST: f64 = 1e-9;

/// Footing of a situation under its loads that rise: geometry of the base, and wrenches of one metre of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Footing {
    /// Half of the base, and its middle right of the centre of mass, m.
    half_width: f64,
    middle: f64,
    depth: f64,
    permanent: Wrench,
    variable: Wrench,
}

impl Footing {
    pub(super) fn of(situation: &Situation) -> Result<Footing, InputError> {
        let body = situation.body();
        let Plan::Rectangle { length } = body.plan() else {
            return Err(InputError::new(Quantity::Width, body.width(), Expected::RectangularBase));
        };
        let at = |factor: f64| situation.wrench_at(factor, Pose::UPRIGHT) * (1.0 / length);
        let permanent = at(0.0);
        Ok(Footing {
            half_width: body.base_width() / 2.0,
            middle: (body.toe_distance() - body.heel_distance()) / 2.0,
            depth: body.centroid_height(),
            permanent,
            variable: at(1.0) + permanent * -1.0,
        })
    }

    /// That of a block of which a length of 1 is `length` (m) and a force of 1 is `force` (N per metre run).
    pub(super) fn under_block(
        block: &Block,
        length: f64,
        force: f64,
        permanent: &Wrench,
        variable: &Wrench,
    ) -> Footing {
        let [permanent, variable] = [permanent, variable].map(|Wrench { x, p, m }| Wrench {
            x: x * force,
            p: p * force,
            m: m * force * length,
        });
        Footing {
            half_width: (block.b1 + block.b2) / 2.0 * length,
            middle: (block.b2 - block.b1) / 2.0 * length,
            depth: block.d * length,
            permanent,
            variable,
        }
    }

    /// The reaction of a body at rest.
    pub(super) fn reaction(&self, factor: f64) -> Option<Reaction> {
        let wrench = self.permanent + self.variable * factor;
        self.under(&wrench, wrench.x)
    }

    /// That of a body that slides.
    fn sliding(&self, factor: f64, slip: Slip, mu: f64) -> Option<Reaction> {
        let wrench = self.permanent + self.variable * factor;
        self.under(&wrench, slip.sign() * mu * wrench.p)
    }

    /// The load factors at which the reaction of a body at rest is in the middle of the base, and upright; with `slip` and its friction the first
    /// of a body that slides. There the ground bears most, so that no stretch in which it bears is so narrow that it is missed.
    fn even(&self, slip: Option<(Slip, f64)>) -> [f64; 2] {
        let x = |w: &Wrench| slip.map_or(w.x, |(slip, mu)| slip.sign() * mu * w.p);
        let off = |w: &Wrench| x(w) * self.depth - w.m - self.middle * w.p;
        let zero = |of: &dyn Fn(&Wrench) -> f64| -of(&self.permanent) / of(&self.variable);
        [zero(&off), zero(&|w| w.x)]
    }

    /// The reaction that passes `x` to the ground, of a body that does not turn.
    fn under(&self, Wrench { p, m, .. }: &Wrench, x: f64) -> Option<Reaction> {
        if *p <= 0.0 {
            return None;
        }
        // It acts at (xd − M)/P from the centre of mass: on the side that x pushes to if that is positive.
        let e = (x * self.depth - m) / p - self.middle;
        Reaction::new(self.half_width, *p, x, e).ok()
    }
}

/// A situation's ground along its loads that rise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundPath {
    ground: Ground,
    footing: Footing,
}

impl GroundPath {
    /// The ground under the situation's body.
    ///
    /// # Errors
    /// If the base is round: the formulas are those of a strip. Of a body of a given length they leave out its ends.
    pub fn new(ground: Ground, situation: &Situation) -> Result<GroundPath, InputError> {
        Ok(GroundPath { ground, footing: Footing::of(situation)? })
    }

    pub(super) fn on(ground: Ground, footing: Footing) -> GroundPath {
        GroundPath { ground, footing }
    }

    /// The ground.
    pub fn ground(&self) -> &Ground {
        &self.ground
    }

    /// Reaction on the ground of a body at rest under a load factor; `None` if nothing presses.
    pub fn reaction(&self, factor: f64) -> Option<Reaction> {
        self.footing.reaction(factor)
    }

    /// Reaction of a body that slides with the friction `mu` towards `slip`.
    pub fn sliding_reaction(&self, factor: f64, slip: Slip, mu: f64) -> Option<Reaction> {
        self.footing.sliding(factor, slip, mu)
    }

    /// The friction with which the reaction of a body that slides is in the middle of the base.
    pub(super) fn even_friction(&self, slip: Slip, factor: f64) -> Option<f64> {
        let Wrench { p, m, .. } = self.footing.permanent + self.footing.variable * factor;
        (p > 0.0).then(|| slip.sign() * (m / p + self.footing.middle) / self.footing.depth)
    }

    /// The load factors between two at which the ground begins to bear a body that rests, or that slides with a friction, or fails under it.
    pub(super) fn crossings(&self, slip: Option<(Slip, f64)>, from: f64, to: f64) -> Vec<f64> {
        let excess = |λ: f64| self.excess(slip, λ);
        let looked = steps().chain(self.footing.even(slip));
        let mut ends: Vec<f64> = looked.filter(|λ| *λ > from && *λ < to).collect();
        ends.push(from);
        ends.extend(Some(to).filter(|to| to.is_finite()));
        ends.sort_by(f64::total_cmp);
        let bears = |λ: f64| excess(λ) >= 0.0;
        let pairs = ends.windows(2).filter(|pair| bears(pair[0]) != bears(pair[1]));
        pairs.map(|pair| between(excess, pair[0], pair[1]).unwrap_or(pair[1])).collect()
    }

    /// R/P under a load factor; `None` if nothing presses.
    pub fn factor(&self, factor: f64) -> Option<f64> {
        self.reaction(factor).map(|reaction| self.ground.factor(&reaction))
    }

    /// The least load factor above zero at which R/P falls to 1.
    fn load_factor(&self, ground: &Ground) -> f64 {
        if self.excess_on(ground, 0.0) < 0.0 {
            return 0.0;
        }
        // Uplift makes P fall and R/P no line of λ: stretch by stretch, each until it is certain that the ground bears all of it.
        let ends = (-6..=20).map(|power| f64::from(power).exp2());
        let mut low = 0.0;
        for high in ends {
            let high = high.min(FARTHEST);
            if let Some(factor) = self.first_failure(ground, low, high, high * NARROWEST) {
                return factor;
            }
            low = high;
        }
        f64::INFINITY
    }

    /// R/P less 1 of a body at rest on a ground; where nothing presses nothing fails.
    fn excess_on(&self, ground: &Ground, factor: f64) -> f64 {
        self.reaction(factor).map_or(1.0, |reaction| ground.factor(&reaction) - 1.0)
    }

    /// First load factor at which the ground fails between two, at the lower of which it does not; stretches are halved, the lower half
    /// first, until one is certain to be borne, or so narrow that rounding decides.
    fn first_failure(&self, ground: &Ground, low: f64, high: f64, narrowest: f64) -> Option<f64> {
        if self.is_borne(ground, low, high) {
            return None;
        }
        let excess = |factor: f64| self.excess_on(ground, factor);
        if high - low <= narrowest {
            return (excess(high) < 0.0).then(|| between(excess, low, high).unwrap_or(high));
        }
        let middle = low + (high - low) / 2.0;
        if let Some(factor) = self.first_failure(ground, low, middle, narrowest) {
            return Some(factor);
        }
        if excess(middle) < 0.0 {
            return Some(middle);
        }
        self.first_failure(ground, middle, high, narrowest)
    }

    /// True if the ground is certain to bear every reaction between two load factors: P and X are lines of λ, and e and η rise or fall all
    /// the way as long as P presses, so that the least R there is no less than that of the worst of both ends taken together.
    fn is_borne(&self, ground: &Ground, low: f64, high: f64) -> bool {
        match (self.reaction(low), self.reaction(high)) {
            (Some(one), Some(other)) => ground.least_resistance(&one, &other) >= one.p.max(other.p),
            // P is a line of λ: nothing presses between them either, and nothing fails.
            (None, None) => true,
            _ => false,
        }
    }

    /// The least load factor at which the ground fails under a body at rest.
    pub(super) fn failure(&self) -> f64 {
        self.load_factor(&self.ground)
    }

    /// Load factors at which the ground fails as the variable loads rise.
    pub fn load_factors(&self) -> LoadFactors {
        let turned = |by: f64| self.ground.turned(by).map(|ground| self.load_factor(&ground));
        LoadFactors { given: self.load_factor(&self.ground), less: turned(-2.0), more: turned(2.0) }
    }

    /// R/P less 1 of a body at rest, or of one that slides with a friction; where nothing presses nothing fails.
    pub(super) fn excess(&self, slip: Option<(Slip, f64)>, factor: f64) -> f64 {
        let reaction = match slip {
            None => self.reaction(factor),
            Some((slip, mu)) => self.sliding_reaction(factor, slip, mu),
        };
        reaction.map_or(1.0, |reaction| self.ground.factor(&reaction) - 1.0)
    }
}

/// The load factors at which is looked: closer where the load is of the size that was given.
fn steps() -> impl Iterator<Item = f64> {
    let near = (1..=400).map(|i| 0.01 * f64::from(i));
    near.chain((1..=400).map(|i| 4.0 * 10f64.powf(0.0135 * f64::from(i))))
}
