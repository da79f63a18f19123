//! The report: which mode of response a horizontal force starts, and the motion it starts with.
//!
//! A uniform rectangular block, 2B wide and 2H high, stands on a rough rigid base. From rest, a horizontal force
//! F = k m g that points left acts at the height k'H above the centre of mass C (k' < 0: below).
//!
//! ```text
//!          2B
//!      ┌──────────┐
//!      │          │ ◄── F = k m g      k' H above C
//!  2H  │    C     │
//!      │          │        y ▲   ⟲ θ
//!      O──────────O'         └─► x
//!  ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒   f_x →, f_y ↑ at ξ right of C
//! ```
//!
//! | symbol | identifier | meaning |
//! |---|---|---|
//! | γ | `gamma` | H/B |
//! | k' | `k_prime` | height of the force above C, in H |
//! | k | `k` | F/(m g) |
//! | μ | `mu` | Coulomb friction, static and kinetic |
//!
//! Everything is non-dimensional: lengths in B, accelerations in g, angular acceleration in g/B, forces in m g.
//! With a, b, c, d of the [`Chart`], one decision covers chapters III and IV of the report, in this order:
//!
//! ```text
//! RE     if μ ≥ k and k γ (1+k') ≤ 1                 (3.4, 3.5; 4.7, 4.10)
//! SRO'-  if γ (μ + k k') < −1                         (4.92)
//! SL     if μ < k and γ (μ + k k') ≤ 1                (after 3.8; 4.18, 4.19)
//! RO     if μ (c k + d) ≥ |a k + b|                   (3.24; 4.40)
//! SRO-   if a k + b > 0,   else SRO+                  (3.40, 3.45; 4.77)
//! ```
//!
//! For k' < −1, which only effective loads reach, O' takes the part of O. A region owns its boundary in the
//! order RE, SL, RO, slide-rock. The signs are [exact](crate::sign) for the f64 given.
//!
//! For −1 < k' < 0 and strong friction (μ ≥ 4/3 at least) several modes satisfy every law at once;
//! [`Point::others`] lists those beside the one reported, which is the report's choice.
//!
//! ```
//! use standfast::{Mode, Point};
//!
//! let point = Point::new(1.0, 1.0, 2.0, 5.0)?;
//! assert_eq!(point.mode(), Mode::RockO);
//! assert_eq!(point.motion().theta_ddot, 1.125);
//! assert!(point.is_unique());
//! # Ok::<(), standfast::InputError>(())
//! ```

mod chart;
mod limits;
mod margins;
mod onset;
mod polynomials;
mod trace;

pub use chart::{Chart, ChartCase, NamedPoint, PointName};
pub use limits::{LimitState, LimitStates};
pub use margins::{Bounds, Crossing, PointMargins};
pub use trace::{Step, Trace};

use crate::approx::Approx;
use crate::contact;
use crate::error::InputError;
use crate::exact::{Exact, Real};
use crate::mode::{Mode, Modes};
use crate::motion::Motion;
use crate::quantity::Quantity;
use crate::sign;
pub(crate) use polynomials::Terms;
use polynomials::{Need, Polynomials, signed_slenderness};

/// A body and a force, reduced to the report's four numbers: a point of the k–μ plane for (γ, k').
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    gamma: f64,
    k_prime: f64,
    k: f64,
    mu: f64,
}

impl Point {
    /// The point (k, μ) of the plane for γ and k'.
    ///
    /// # Errors
    /// If a number is not finite or larger than 1e50, `gamma` is not above zero (1e-50), or `k` or `mu` is negative.
    pub fn new(gamma: f64, k_prime: f64, k: f64, mu: f64) -> Result<Point, InputError> {
        Ok(Point {
            gamma: InputError::positive(Quantity::Slenderness, gamma)?,
            k_prime: InputError::finite(Quantity::KPrime, k_prime)?,
            k: InputError::not_negative(Quantity::K, k)?,
            mu: InputError::not_negative(Quantity::Friction, mu)?,
        })
    }

    /// The point of four numbers that [`new`](Point::new) takes.
    #[inline(always)]
    pub(crate) fn of_valid(gamma: f64, k_prime: f64, k: f64, mu: f64) -> Point {
        Point { gamma, k_prime, k, mu }
    }

    /// γ = H/B.
    pub fn gamma(&self) -> f64 {
        self.gamma
    }

    /// k': height of the force above the centre of mass, in H.
    pub fn k_prime(&self) -> f64 {
        self.k_prime
    }

    /// k = F/(m g).
    pub fn k(&self) -> f64 {
        self.k
    }

    /// μ.
    pub fn mu(&self) -> f64 {
        self.mu
    }

    /// The curves and points of the k–μ plane for this γ and k'.
    pub fn chart(&self) -> Chart {
        Chart::of_valid(self.gamma, self.k_prime)
    }

    /// The mode that begins: the report's choice where several are consistent (its section IV.7).
    pub fn mode(&self) -> Mode {
        let code = sign::code([self.gamma, self.k_prime, self.k, self.mu]);
        Mode::from_code(code).expect("a valid point has a mode")
    }

    /// The other modes that satisfy the equations of motion, Coulomb's law and non-penetration.
    ///
    /// Empty except in the indeterminate set
    /// N = {−1 < k' < 0, k > k_A, k ≥ k_B', μ*(k) ≤ μ ≤ 1/γ − k k'}, where it holds RO, and inside N also SRO-.
    /// It is decided exactly. An independent witness is [`enumerate`].
    pub fn others(&self) -> Modes {
        self.others_beside(self.mode())
    }

    /// As [`others`](Point::others), where the [`mode`](Point::mode) is known, which it has to be.
    pub fn others_beside(&self, mode: Mode) -> Modes {
        let mut others = Modes::NONE;
        if self.k_prime <= -1.0 || self.k_prime >= 0.0 {
            return others;
        }
        if matches!(mode, Mode::SlideLeft | Mode::SlideRockOPrimeLeft) {
            let signs = self.polynomials(Need::Sign, |p| [p.turn, p.slip_left]);
            let Polynomials { turn, slip_left, .. } = signs;
            // That k > k_A follows: slip_left = 4(1+γ²)(μ − k) + 3 tip (μ + γ), and μ < k in both modes.
            if slip_left >= 0.0 {
                others.insert(Mode::RockO);
                if turn < 0.0 && slip_left > 0.0 {
                    others.insert(Mode::SlideRockOLeft);
                }
            }
        }
        others
    }

    /// True if [`mode`](Point::mode) is the only consistent mode.
    pub fn is_unique(&self) -> bool {
        self.others().is_empty()
    }

    /// The motion and reactions with which [`mode`](Point::mode) begins.
    pub fn motion(&self) -> Motion {
        self.motion_of(self.mode())
    }

    /// As [`motion`](Point::motion), where the mode is known.
    pub(crate) fn motion_of(&self, mode: Mode) -> Motion {
        onset::motion(self, mode)
    }

    /// The motion of `mode`, if it is [`mode`](Point::mode) or one of [`others`](Point::others).
    pub fn motion_in(&self, mode: Mode) -> Option<Motion> {
        (mode == self.mode() || self.others().contains(mode)).then(|| onset::motion(self, mode))
    }

    /// μ/k, the factor of safety against sliding of a body in air; infinite at k = 0.
    #[inline]
    pub fn safety_against_sliding(&self) -> f64 {
        if self.k == 0.0 { f64::INFINITY } else { self.mu / self.k }
    }

    /// 1/(k γ |1+k'|), the factor of safety against overturning of a body in air; infinite where the force has no
    /// moment about the corner it would tip the body over.
    #[inline]
    pub fn safety_against_overturning(&self) -> f64 {
        1.0 / (self.k * (1.0 + self.k_prime).abs() * self.gamma)
    }

    /// At which forces and frictions the mode changes.
    pub fn margins(&self) -> PointMargins {
        PointMargins::of(self)
    }

    /// Distances from the inequalities that decide its mode, as limit states.
    pub fn limit_states(&self) -> LimitStates {
        LimitStates::of(self)
    }

    /// The verdict step by step, with the report's equation numbers.
    pub fn explain(&self) -> Trace {
        Trace::of(self)
    }

    fn polynomials<const N: usize>(
        &self,
        need: Need,
        needed: impl Fn(&Polynomials<Approx>) -> [Approx; N],
    ) -> Polynomials<f64> {
        self.polynomials_about(signed_slenderness(self.gamma, self.k_prime), need, needed)
    }

    /// As [`polynomials`](Point::polynomials), for the corner O (g = γ) or O' (g = −γ).
    #[inline(always)]
    fn polynomials_about<const N: usize>(
        &self,
        g: f64,
        need: Need,
        needed: impl Fn(&Polynomials<Approx>) -> [Approx; N],
    ) -> Polynomials<f64> {
        Polynomials::known(g, self.numbers(), need, needed)
    }

    /// γ, k', k and μ.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> [f64; 4] {
        [self.gamma, self.k_prime, self.k, self.mu]
    }
}

/// The mode that begins at γ, k', k and μ.
///
/// # Errors
/// As [`Point::new`].
pub fn classify(gamma: f64, k_prime: f64, k: f64, mu: f64) -> Result<Mode, InputError> {
    Ok(Point::new(gamma, k_prime, k, mu)?.mode())
}

/// Every consistent mode at a point, by trying the modes of the [general contact problem](crate::contact) one by one: an
/// exact witness of [`Point::mode`] and [`Point::others`] that shares no formula with them.
pub fn enumerate(point: &Point) -> Modes {
    // ρ² = (1+γ²)/3 is no f64, but modes do not change if all inertia is trebled.
    fn numbers<T: Real>(point: &Point) -> contact::Numbers<T> {
        let [γ, k_prime, k, μ] = [point.gamma, point.k_prime, point.k, point.mu].map(T::of);
        let [one, three] = [1.0, 3.0].map(T::of);
        let m = k.clone() * k_prime * γ.clone();
        let rho2 = one.clone() + γ.clone() * γ.clone();
        [one.clone(), one.clone(), γ, rho2, three.clone(), three, μ.clone(), μ, -k, one, m]
    }
    contact::decide(|| numbers::<Approx>(point), || numbers::<Exact>(point)).modes
}
