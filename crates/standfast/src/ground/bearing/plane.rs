//! The k–μ plane of the report's block on ground that can fail.

use super::{Ground, Reaction};
use crate::error::InputError;
use crate::ground::GroundVerdict;
use crate::ground::roots::between;
use crate::initiation::Point;
use crate::mode::Mode;
use crate::quantity::Quantity;

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
    pub verdict: GroundVerdict,
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

    /// What happens at (k, μ).
    ///
    /// # Errors
    /// If `k` or `mu` is negative or not finite.
    pub fn at(&self, k: f64, mu: f64) -> Result<BearingPoint, InputError> {
        Point::new(self.gamma, self.k_prime, k, mu)?;
        let factor = self.factor(k, k);
        let verdict = match () {
            () if mu >= k && factor >= 1.0 => GroundVerdict::Begins(Mode::Rest),
            () if mu < k && self.factor(mu, k) >= 1.0 => GroundVerdict::Begins(Mode::SlideLeft),
            () => GroundVerdict::BearingFailure,
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
        let excess = |k: f64| self.factor(mu, k) - 1.0;
        if self.k_prime == 0.0 {
            return (excess(mu) >= 0.0).then_some(f64::INFINITY);
        }
        // From the force at which the reaction is in the middle to that at which it is at the edge.
        let middle = (-mu / self.k_prime).max(0.0);
        let edge = middle.max((1.0 / self.gamma - mu * self.k_prime.signum()) / self.k_prime.abs());
        if excess(middle) < 0.0 {
            return None;
        }
        between(excess, middle, edge).filter(|k| *k >= mu)
    }
}

/// η beyond which no formula of the module bears anything.
const MOST_INCLINED: f64 = 10.0;
