//! The report's block on a base that crushes.

use super::conditions::enumerate;
use super::turning::{Rate, Turn};
use super::{CrushMotion, CrushProblem, Numbers, bound, motion};
use crate::approx::Approx;
use crate::error::InputError;
use crate::exact::{Exact, Real};
use crate::ground::roots::RootSigned;
use crate::initiation::Point;
use crate::mode::{Corner, Mode, Modes, Slip};
use crate::quantity::Quantity;
use crate::twofold::Twofold;
use crate::verdict::Verdict;

use std::cmp::Ordering::{Greater, Less};

/// A point of the report's plane with ω = P/(2B q_u), the share of the base that P needs to be borne.
///
/// The decision, for k' ≥ −1, with G₁ = γ(1+k') and a region owning its boundary in this order:
///
/// ```text
/// BF     ω ≥ 1
/// RE     μ ≥ k and k G₁ ≤ 1 − ω
/// SRO'-  γ(μ + k k') < −(1 − ω)
/// SL     μ < k and γ(μ + k k') ≤ 1 − ω
/// RO     J α + R(α) = k G₁, α > 0:  |k − γα| ≤ μ N(α)          J = (1 + 4γ²)/3
/// SRO∓   else, − where k − γα > 0                              N = (1 + α)/(1 + 2ωα), R = N (1 − ωN)
/// ```
///
/// For k' < −1 (effective loads only) O' takes the part of O. ω = 0 is [`Point`] itself, decision and motion.
///
/// ```
/// use standfast::Point;
/// use standfast::ground::strength::CrushPoint;
///
/// let point = CrushPoint::new(1.0, 0.5, 1.2, 1.5, 0.2)?;
/// assert_eq!(point.verdict().symbol(), "RO");
/// let begun = point.motion().unwrap();
/// assert!(begun.motion.theta_ddot > Point::new(1.0, 0.5, 1.2, 1.5)?.motion().theta_ddot);
/// // It turns about the end of what it crushes, and its reaction is at half of that.
/// assert!((begun.neutral.unwrap() - (2.0 * begun.motion.xi + 1.0)).abs() < 1e-15);
/// assert_eq!(CrushPoint::new(1.0, 0.5, 0.0, 1.5, 1.0)?.verdict().symbol(), "BF");
/// # Ok::<(), standfast::InputError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrushPoint {
    pub(super) point: Point,
    pub(super) omega: f64,
}

/// The report's block with all its inertia trebled, so that ρ² = 1 + γ² is one of its numbers; accelerations are a third.
impl CrushProblem for CrushPoint {
    fn numbers<T: Real>(&self) -> Numbers<T> {
        let point = &self.point;
        let [γ, k_prime, k, μ] = [point.gamma(), point.k_prime(), point.k(), point.mu()].map(T::of);
        let [one, three] = [1.0, 3.0].map(T::of);
        let rho2 = one.clone() + γ.clone() * γ.clone();
        let m = k.clone() * k_prime * γ.clone();
        Numbers {
            b: [one.clone(), one.clone()],
            d: γ,
            rho2,
            m_x: three.clone(),
            m_y: three,
            mu_s: μ.clone(),
            mu_k: μ,
            x: -k,
            p: one.clone(),
            m,
            // 1/(2ω)
            q: [one, T::of(2.0) * T::of(self.omega)],
        }
    }
}

impl CrushPoint {
    /// The point (k, μ) of the plane for γ and k' on a base of ω; see [`Point::new`].
    ///
    /// # Errors
    /// As [`Point::new`]; or if `omega` is negative or not finite.
    pub fn new(gamma: f64, k_prime: f64, k: f64, mu: f64, omega: f64) -> Result<CrushPoint, InputError> {
        CrushPoint::of(Point::new(gamma, k_prime, k, mu)?, omega)
    }

    /// A point of the report's plane on a base of ω.
    ///
    /// # Errors
    /// If `omega` is negative or not finite.
    pub fn of(point: Point, omega: f64) -> Result<CrushPoint, InputError> {
        Ok(CrushPoint { point, omega: InputError::not_negative(Quantity::Omega, omega)? })
    }

    /// A point of the report's plane on a rigid base, ω = 0.
    pub fn rigid(point: Point) -> CrushPoint {
        CrushPoint { point, omega: 0.0 }
    }

    /// The point on a rigid base.
    pub fn point(&self) -> &Point {
        &self.point
    }

    /// ω.
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// The mode that begins, or BF.
    pub fn verdict(&self) -> Verdict {
        if self.omega >= 1.0 {
            return Verdict::BearingFailure;
        }
        if self.omega == 0.0 {
            return Verdict::Begins(self.point.mode());
        }
        let float = self.numbers::<f64>();
        let mode = self
            .decide::<Approx>(&float)
            .or_else(|| self.decide::<Twofold>(&float))
            .or_else(|| self.decide::<Exact>(&float));
        Verdict::Begins(mode.expect("exact signs are always known"))
    }

    /// The other consistent modes, by trying all; empty below [`bound`](CrushPoint::bound).
    pub fn others(&self) -> Modes {
        if self.point.mu() < 0.999_999 * self.bound() {
            return Modes::NONE;
        }
        self.enumerate().without(self.verdict().mode())
    }

    /// Every consistent mode, by trying all modes one by one: a witness of [`verdict`](CrushPoint::verdict).
    pub fn enumerate(&self) -> Modes {
        enumerate(self).modes
    }

    /// True if [`verdict`](CrushPoint::verdict) is the only consistent mode.
    pub fn is_unique(&self) -> bool {
        self.others().is_empty()
    }

    /// μ_P, the friction up to which one mode only is consistent: (z + ρ²/z)/γ with z = |1 − 2ω| and ρ² = (1+γ²)/3, or
    /// 1.5 (2ρ²z)^⅓/γ where 2ρ² < z². It is 4/3 at least on a rigid base, more on one that crushes, and infinite at ω = ½.
    pub fn bound(&self) -> f64 {
        let γ = self.point.gamma();
        bound((1.0 - 2.0 * self.omega).abs(), γ, (1.0 + γ * γ) / 3.0, self.omega == 0.0)
    }

    /// The motion with which [`verdict`](CrushPoint::verdict) begins, lengths in B, accelerations in g, forces in m g; `None` for
    /// BF.
    pub fn motion(&self) -> Option<CrushMotion> {
        self.verdict().mode().map(|mode| self.begun(mode))
    }

    /// The motion of `mode`, if it is reported or one of [`others`](CrushPoint::others).
    pub fn motion_in(&self, mode: Mode) -> Option<CrushMotion> {
        (self.verdict().mode() == Some(mode) || self.others().contains(mode)).then(|| self.begun(mode))
    }

    fn begun(&self, mode: Mode) -> CrushMotion {
        let begun = motion(self, mode).scaled(3.0, 1.0, 1.0);
        if self.omega > 0.0 {
            return begun;
        }
        match self.point.motion_in(mode) {
            Some(motion) => CrushMotion { motion, ..begun },
            None => begun,
        }
    }

    /// The decision; `None` if a sign is unknown.
    fn decide<T: RootSigned>(&self, float: &Numbers<f64>) -> Option<Mode> {
        let n = self.numbers::<T>();
        let [k_prime, k, μ, ω] =
            [self.point.k_prime(), self.point.k(), self.point.mu(), self.omega].map(T::of);
        let room = T::of(1.0) - ω;
        let beyond = self.point.k_prime() < -1.0;
        let corner = if beyond { Corner::OPrime } else { Corner::O };
        let slides = (μ.clone() - k.clone()).sign()? == Less;
        // With friction μ, or k where it holds: kG₁, and its mirror for k' < −1.
        let tipping = |friction: T| {
            let moment = n.d.clone() * (friction + k.clone() * k_prime.clone());
            if beyond { -moment } else { moment }
        };
        let tips = (tipping(k.clone()) - room.clone()).sign()? == Greater;
        if !slides && !tips {
            return Some(Mode::Rest);
        }
        let turning = tipping(μ);
        if !beyond && (turning.clone() + room.clone()).sign()? == Less {
            return Some(Mode::SlideRockOPrimeLeft);
        }
        if slides && (turning - room).sign()? != Greater {
            return Some(Mode::SlideLeft);
        }
        // A force below the base: friction turns the body that slips, though it would not tip if it stuck.
        if !tips {
            return Some(Mode::SlideRockOPrimeLeft);
        }
        let turn = Turn::about(&n, corner, None);
        let near = Rate::of(float, corner, None, Turn::about(float, corner, None).surplus).root();
        for slip in [Slip::Left, Slip::Right] {
            let w = turn.slipping(&n, corner, slip, &n.mu_s);
            if T::at_roots(&turn.equation, &w, near)?.positive > 0 {
                return Some(Mode::slide_rock(corner, slip));
            }
        }
        Some(Mode::rock(corner))
    }
}
