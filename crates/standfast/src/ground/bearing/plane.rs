//! The k–μ plane of the report's block on ground that can fail.

use super::{Ground, Kind, Reaction};
use crate::error::InputError;
use crate::ground::roots::between;
use crate::initiation::Point;
use crate::mode::Mode;
use crate::quantity::Quantity;
use crate::verdict::Verdict;

/// The plane for γ, k', a base of half width B (m) and P (N per metre run).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingPlane {
    ground: Ground,
    gamma: f64,
    k_prime: f64,
    half_width: f64,
    p: f64,
}

/// A point of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingPoint {
    /// RE, SL (either way) or BF.
    pub verdict: Verdict,
    /// R/P of the body at rest, under η = k and ε = kγ|1+k'|; it may be that it cannot rest for want of friction.
    pub factor: f64,
}

impl BearingPlane {
    /// The plane of `ground` under a block of slenderness `gamma` on a base of `half_width` (m), pressed by `p` (N per metre run), under
    /// a force at `k_prime`.
    ///
    /// # Errors
    /// If `gamma`, `half_width` or `p` is not above zero, or a number is not finite.
    pub fn new(
        ground: Ground,
        gamma: f64,
        k_prime: f64,
        half_width: f64,
        p: f64,
    ) -> Result<BearingPlane, InputError> {
        Ok(BearingPlane {
            ground,
            gamma: InputError::positive(Quantity::Slenderness, gamma)?,
            k_prime: InputError::finite(Quantity::KPrime, k_prime)?,
            half_width: InputError::positive(Quantity::HalfWidth, half_width)?,
            p: InputError::positive(Quantity::WrenchP, p)?,
        })
    }

    /// The plane of ground that bears `centric` of 1/u times P centric and upright, where B and P are one: all that `ec7`, `hansen` and
    /// an envelope without surcharge and cohesion need to know.
    ///
    /// ```
    /// use standfast::ground::bearing::{BearingPlane, Ground, GroundLaw};
    ///
    /// let sand = Ground::new(GroundLaw::Ec7, 35.0, 10e3)?;
    /// let metres = BearingPlane::new(sand, 0.7, 0.4, 7.5, 2e6)?;
    /// let pure = BearingPlane::of_share(sand, 0.7, 0.4, metres.share())?;
    /// assert!((metres.k_bf() - pure.k_bf()).abs() < 1e-12);
    /// # Ok::<(), standfast::InputError>(())
    /// ```
    ///
    /// # Errors
    /// If `gamma` or `share` is not above zero, or a number is not finite.
    pub fn of_share(
        ground: Ground,
        gamma: f64,
        k_prime: f64,
        share: f64,
    ) -> Result<BearingPlane, InputError> {
        let share = InputError::positive(Quantity::BearingShare, share)?;
        let centric = 1.0 / share / ground.centric_resistance(1.0);
        let kind = match ground.kind {
            // In units of B a base is long.
            Kind::Soil { law, angle, unit_weight, surcharge, cohesion, .. } => {
                let length = f64::INFINITY;
                let [unit_weight, surcharge, cohesion] =
                    [unit_weight, surcharge, cohesion].map(|x| x * centric);
                Kind::Soil { law, angle, unit_weight, surcharge, cohesion, length }
            }
            Kind::Undrained { strength, surcharge, .. } => {
                let [strength, surcharge] = [strength, surcharge].map(|x| x * centric);
                Kind::Undrained { strength, surcharge, length: f64::INFINITY }
            }
            Kind::Envelope { horizontal, moment, coupling, .. } => {
                Kind::Envelope { centric: ground.divisor / share, horizontal, moment, coupling }
            }
        };
        BearingPlane::new(Ground { kind, ..ground }, gamma, k_prime, 1.0, 1.0)
    }

    /// The ground.
    pub fn ground(&self) -> &Ground {
        &self.ground
    }

    /// γ.
    pub fn gamma(&self) -> f64 {
        self.gamma
    }

    /// k'.
    pub fn k_prime(&self) -> f64 {
        self.k_prime
    }

    /// u = P/V₀: the share of its centric and upright resistance that P takes. From 1 on nothing rests.
    pub fn share(&self) -> f64 {
        self.p / self.ground.centric_resistance(self.half_width)
    }

    /// R/P where the ground takes the friction η and the force k acts: ε = γ(η + kk').
    fn factor(&self, inclination: f64, k: f64) -> f64 {
        let share = self.gamma * (inclination + k * self.k_prime);
        let reaction = Reaction {
            half_width: self.half_width,
            p: self.p,
            x: inclination * self.p,
            e: share * self.half_width,
        };
        self.ground.factor(&reaction)
    }

    /// Verdict and factor R/P at (k, μ).
    ///
    /// # Errors
    /// If `k` or `mu` is negative or not finite.
    pub fn at(&self, k: f64, mu: f64) -> Result<BearingPoint, InputError> {
        Point::new(self.gamma, self.k_prime, k, mu)?;
        let factor = self.factor(k, k);
        let verdict = match () {
            () if mu >= k && factor >= 1.0 => Verdict::Begins(Mode::Rest),
            () if mu < k && self.factor(mu, k) >= 1.0 => Verdict::Begins(Mode::SlideLeft),
            () => Verdict::BearingFailure,
        };
        Ok(BearingPoint { verdict, factor })
    }

    /// k_BF, the force that the ground bears at most if friction holds the body; zero if it does not bear P alone.
    pub fn k_bf(&self) -> f64 {
        // R falls as k rises, and is zero where the reaction reaches the edge or the formulas end.
        let edge = 1.0 / (self.gamma * (1.0 + self.k_prime).abs());
        let excess = |k: f64| self.factor(k, k) - 1.0;
        if excess(0.0) < 0.0 { 0.0 } else { between(excess, 0.0, edge.min(MOST_INCLINED)).unwrap_or(0.0) }
    }

    /// The largest k under which a body that slides with friction `mu` is borne; infinite where the force has no moment about the base's
    /// friction (k' = 0), and `None` where no force beyond μ is borne. Through (k_BF, k_BF).
    pub fn slide_limit(&self, mu: f64) -> Option<f64> {
        self.slide_range(mu).map(|[_, most]| most)
    }

    /// The least and the largest k ≥ μ under which a body that slides with friction `mu` is borne; see
    /// [`slide_limit`](BearingPlane::slide_limit). The least is above μ only for −1 < k' < 0, where a larger force brings the reaction
    /// back towards the middle of the base.
    pub fn slide_range(&self, mu: f64) -> Option<[f64; 2]> {
        let excess = |k: f64| self.factor(mu, k) - 1.0;
        if self.k_prime == 0.0 {
            return (excess(mu) >= 0.0).then_some([mu, f64::INFINITY]);
        }
        // From the force at which the reaction is where it is borne best to those at which it is at an edge.
        let at = |share: f64| (share / self.gamma - mu) / self.k_prime;
        let best = at(self.ground.best_eccentricity(mu)).max(mu);
        if excess(best) < 0.0 {
            return None;
        }
        let (low, high) = (at(-1.0).min(at(1.0)), at(-1.0).max(at(1.0)));
        let least = if low > mu {
            between(excess, low, best).unwrap_or(best)
        } else {
            between(excess, mu, best).unwrap_or(mu)
        };
        Some([least, between(excess, best, high).unwrap_or(best)])
    }

    /// The force and the largest friction with which a body that slides is borne: (k_BF, k_BF), or for −1 < k' < 0 where the
    /// inclination alone exhausts the ground. Zeros if it does not bear P alone.
    pub fn slide_top(&self) -> [f64; 2] {
        if !(-1.0 < self.k_prime && self.k_prime < 0.0) {
            return [self.k_bf(); 2];
        }
        let best = |mu: f64| ((self.ground.best_eccentricity(mu) / self.gamma - mu) / self.k_prime).max(mu);
        let excess = |mu: f64| self.factor(mu, best(mu)) - 1.0;
        let top = if excess(0.0) < 0.0 { None } else { between(excess, 0.0, MOST_INCLINED) };
        top.map_or([0.0; 2], |mu| [best(mu), mu])
    }
}

/// η beyond which no formula of the module bears anything.
const MOST_INCLINED: f64 = 10.0;
