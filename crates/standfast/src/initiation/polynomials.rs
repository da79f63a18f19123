//! The report's inequalities as polynomials: what motions, margins and explanations are made of.
//!
//! Every inequality of chapters III and IV is the sign of one of these polynomials in (γ, k', k, μ), or of μ − k. They are taken
//! with g = γ for the corner O, and with g = −γ for the corner O':
//!
//! | name | polynomial | is positive when |
//! |---|---|---|
//! | `tip` | g k (1+k') − 1 | the force overturns the body about the corner (3.5, 4.10) |
//! | `turn` | g (μ + k k') − 1 | it does so too with the base pulling back by μ only (3.8, 4.19) |
//! | `toe` | γ (μ + k k') + 1 | the sliding body does *not* turn about O' (4.18, 4.92) |
//! | `slip_left` | μ (c k + d) − (a k + b) | friction is enough to stop a slip of the corner to the left (3.24) |
//! | `slip_right` | μ (c k + d) + (a k + b) | friction is enough to stop a slip of the corner to the right (3.24) |
//!
//! They are evaluated through D = μ − k, M = μ + k and G = 4(1+γ²):
//!
//! ```text
//! tip = g k (1+k') − 1                turn = g D + tip          toe = turn + 2     (g = γ)
//! slip_left = G D + 3 tip (μ + g)     slip_right = G M + 3 tip (μ − g)
//! ```
//!
//! which are identities in a = 4 + γ² − 3γ²k', b = 3g, c = 3g(1+k'), d = 1 + 4γ², and in which no product
//! k k' appears that could cancel after rounding. Their rounding is [tracked](crate::approx); where it matters, they are exact. Which
//! mode begins is decided by [two others](crate::sign).

use crate::approx::{Approx, Signed};
use crate::exact::{Exact, Real};
use crate::mode::Corner;

/// The signed slenderness g of the corner that a force can tip the body about: γ (O), or −γ (O') for k' < −1.
pub(super) fn signed_slenderness(gamma: f64, k_prime: f64) -> f64 {
    if k_prime < -1.0 { -gamma } else { gamma }
}

/// What the polynomials are made of, the same for both corners.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Terms<T> {
    pub(crate) gamma: T,
    pub(crate) mu: T,
    /// γ k (1+k').
    pub(crate) moment: T,
    /// D.
    pub(crate) surplus: T,
    /// M.
    pub(crate) sum: T,
    /// G.
    pub(crate) inertia: T,
}

impl<T: Real> Terms<T> {
    /// Those of a valid point.
    #[inline(always)]
    pub(crate) fn of([gamma, k_prime, k, mu]: [f64; 4]) -> Terms<T> {
        let [one, four] = [1.0, 4.0].map(T::of);
        let [gamma, k_prime, k, mu] = [gamma, k_prime, k, mu].map(T::of);
        Terms {
            moment: gamma.clone() * (k.clone() * (k_prime + one.clone())),
            surplus: mu.clone() - k.clone(),
            sum: mu.clone() + k,
            inertia: four * (gamma.clone() * gamma.clone() + one),
            gamma,
            mu,
        }
    }

    /// g.
    #[inline(always)]
    fn slenderness(&self, corner: Corner) -> T {
        of_corner(corner, &self.gamma)
    }

    #[inline(always)]
    pub(super) fn tip(&self, corner: Corner) -> T {
        of_corner(corner, &self.moment) - T::of(1.0)
    }

    #[inline(always)]
    pub(super) fn turn(&self, corner: Corner) -> T {
        self.slenderness(corner) * self.surplus.clone() + self.tip(corner)
    }

    #[inline(always)]
    pub(super) fn slip_left(&self, corner: Corner) -> T {
        let reach = self.mu.clone() + self.slenderness(corner);
        self.inertia.clone() * self.surplus.clone() + T::of(3.0) * self.tip(corner) * reach
    }

    #[inline(always)]
    pub(super) fn slip_right(&self, corner: Corner) -> T {
        let reach = self.mu.clone() - self.slenderness(corner);
        T::of(3.0) * self.tip(corner) * reach + self.inertia.clone() * self.sum.clone()
    }
}

/// A number that has the sign of g.
#[inline(always)]
fn of_corner<T: Real>(corner: Corner, about_o: &T) -> T {
    match corner {
        Corner::O => about_o.clone(),
        Corner::OPrime => -about_o.clone(),
    }
}

/// The polynomials of the module's table.
#[derive(Debug, Clone, Copy)]
pub(super) struct Polynomials<T> {
    pub(super) tip: T,
    pub(super) turn: T,
    pub(super) toe: T,
    pub(super) slip_left: T,
    pub(super) slip_right: T,
    /// g (k k' − μ) − 1: `turn` with friction pushing the other way (3.43).
    pub(super) turn_right: T,
    /// 4 + γ² − 3μg, the denominator of the slide-rock to the left: negative beyond Painlevé's bound (3.35, 4.68).
    pub(super) regularity: T,
}

/// Digits of the values that a caller needs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Need {
    /// Their signs.
    Sign,
    /// Their values, to 40 bits at least however much cancels.
    Value,
}

impl<T: Real> Polynomials<T> {
    /// The polynomials for the corner O (g = γ) or O' (g = −γ).
    #[inline(always)]
    fn about(g: f64, point: [f64; 4]) -> Polynomials<T> {
        let corner = if g < 0.0 { Corner::OPrime } else { Corner::O };
        let terms = Terms::<T>::of(point);
        let [two, three, four] = [2.0, 3.0, 4.0].map(T::of);
        let [g, γ, μ] = [terms.slenderness(corner), terms.gamma.clone(), terms.mu.clone()];
        Polynomials {
            tip: terms.tip(corner),
            turn: terms.turn(corner),
            toe: terms.turn(corner) + two,
            slip_left: terms.slip_left(corner),
            slip_right: terms.slip_right(corner),
            turn_right: terms.tip(corner) - g.clone() * terms.sum.clone(),
            regularity: γ.clone() * γ + four - three * (μ * g),
        }
    }

    fn map<U>(self, mut f: impl FnMut(T) -> U) -> Polynomials<U> {
        Polynomials {
            tip: f(self.tip),
            turn: f(self.turn),
            toe: f(self.toe),
            slip_left: f(self.slip_left),
            slip_right: f(self.slip_right),
            turn_right: f(self.turn_right),
            regularity: f(self.regularity),
        }
    }
}

impl Polynomials<f64> {
    /// The polynomials for the corner of g at a valid point, in floating point if that is good enough for those that
    /// `needed` picks, and exact, rounded once, if not.
    #[inline(always)]
    pub(super) fn known<const N: usize>(
        g: f64,
        point: [f64; 4],
        need: Need,
        needed: impl Fn(&Polynomials<Approx>) -> [Approx; N],
    ) -> Polynomials<f64> {
        let tracked = Polynomials::<Approx>::about(g, point);
        let is_known = |value: Approx| match need {
            Need::Sign => value.sign().is_some(),
            Need::Value => value.precise().is_some(),
        };
        if needed(&tracked).into_iter().all(is_known) {
            tracked.map(Approx::value)
        } else {
            Polynomials::exact(g, point)
        }
    }

    #[cold]
    fn exact(g: f64, point: [f64; 4]) -> Polynomials<f64> {
        Polynomials::<Exact>::about(g, point).map(|value| value.to_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A value that is asked for is worth its digits where floating point would have lost them: tip = −2⁻⁶⁰ exactly, of which
    /// γ k (1+k') − 1 would leave nothing.
    #[test]
    fn a_value_that_cancels_is_exact() {
        let (gamma, k_prime) = (1.0 - 2f64.powi(-30), 0.0);
        let k = 1.0 + 2f64.powi(-30);
        let known = Polynomials::known(gamma, [gamma, k_prime, k, 1.0], Need::Value, |p| [p.tip]);
        assert_eq!(known.tip, -2f64.powi(-60));
        let sign = Polynomials::known(gamma, [gamma, k_prime, k, 1.0], Need::Sign, |p| [p.tip]);
        assert_eq!(sign.tip, -2f64.powi(-60));
    }

    /// However large the numbers beside it, a value that is asked for has forty bits: tip of tall bodies, from 1 down to next to
    /// nothing, against exact arithmetic.
    #[test]
    fn a_value_has_forty_bits() {
        for i in 0..400 {
            let gamma = 10f64.powf(f64::from(i) / 50.0);
            for j in 0..53 {
                let k = (1.0 + 2f64.powi(-j)) / (gamma * 1.4);
                let point = [gamma, 0.4, k, 0.7];
                let known = Polynomials::known(gamma, point, Need::Value, |p| [p.tip]).tip;
                let [g, k_prime, k, one] = [gamma, 0.4, k, 1.0].map(Exact::of);
                let exact = g * k * (k_prime + one.clone()) - one;
                let error = (Exact::of(known) - exact.clone()).to_f64().abs();
                assert!(error <= 2f64.powi(-40) * exact.to_f64().abs(), "{point:?}: {known}");
            }
        }
    }
}
