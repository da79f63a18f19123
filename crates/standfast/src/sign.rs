//! Exact signs: the mode returned for four f64 is the one that exact real arithmetic gives for them.
//!
//! # The polynomials
//!
//! The whole decision of chapters III and IV, for every real k', is the signs of five polynomials in
//! (γ, k', k, μ), and of μ − k. With g = γ for the corner O (k' ≥ −1) and g = −γ for the corner O' (k' < −1):
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
//! tip = g k (1+k') − 1                turn = g D + tip          toe = turn + 2     (k' ≥ −1)
//! slip_left = G D + 3 tip (μ + g)     slip_right = G M + 3 tip (μ − g)
//! ```
//!
//! which are identities in a = 4 + γ² − 3γ²k', b = 3g, c = 3g(1+k'), d = 1 + 4γ², and in which no product
//! k k' appears that could cancel after rounding.
//!
//! # The bound
//!
//! Let ε = 2⁻⁵³, u = γ k |1+k'| and S = 1 + G M + 3 (1+u)(μ+γ). Each operation returns its exact result times
//! (1 + δ), |δ| ≤ ε (a fused multiply-add rounds once, which only helps). To first order:
//!
//! * tip + 1 = ±u takes three roundings, so `tip` is off by at most ε(3u + |tip|) ≤ ε(3 + 4|tip|) (u ≤ 1 + |tip|).
//! * `turn` by at most ε(3u + |tip| + 2γ|D| + |turn|). As tip = turn − gD and γ|D| ≤ γM ≤ GM/8 ≤ S/8, this is at
//!   most ε(5|turn| + 5 + 6γM) ≤ ε(5|turn| + 5S). `toe` = turn + 2 adds ε|toe|, and with |turn| ≤ |toe| + 2 is off by
//!   at most ε(6|toe| + 13 + 6γM). Where |toe| ≤ ½, γ|D| = 1 + u − toe ≥ ½ and S ≥ 1 + 8γM ≥ 5, so that
//!   13 + 6γM ≤ 4S; elsewhere 13ε is nothing beside |toe|.
//! * G is off by 2 roundings, D by 1, their product by 4 in all: 4ε GM. 3 tip is off by at most
//!   ε(9u + 6 max(u,1)) ≤ 15ε(1+u), times |μ ± g| ≤ μ + γ, plus two roundings of that product: together at most
//!   7ε·3(1+u)(μ+γ). The last addition adds ε S. So `slip_left` and `slip_right` are off by at most 8ε S.
//!
//! * 4 + γ² − 3μg, which decides nothing but enters the motion, by at most ε(3(4+γ²) + 3·3μγ), and where it is small,
//!   3μγ ≈ 4 + γ² ≤ GM/2 ≤ S/2: again below 8ε S.
//!
//! In every case |error| < |value| follows from |value| > 16ε S; terms in ε² and the rounding of S itself
//! (a sum of positive terms, 8 roundings) are far inside the factor of 2 between 8 and 16. Underflow adds at
//! most 2⁻¹⁰⁷⁴ to a term, multiplied by at most G: nothing beside 16ε S ≥ 2⁻⁴⁹ while S is finite. An overflow or a
//! NaN makes S infinite or NaN, and the comparison fails. So one comparison per point says that all five
//! floating-point signs are right; where it fails, exact arithmetic decides. There is no tolerance.

use std::ops::{Add, Mul, Neg, Sub};

use crate::approx::Approx;
use crate::error::{LARGEST, SMALLEST};
use crate::exact::{Exact, Real};
use crate::mode::Mode;

/// Arithmetic on f64 whose every operation rounds once: plain, or with a fused multiply-add.
pub(crate) trait Rounded: Real + Copy {
    fn value(self) -> f64;
}

impl Rounded for f64 {
    #[inline(always)]
    fn value(self) -> f64 {
        self
    }
}

/// An f64 whose [`Real::mul_add`] is one instruction and one rounding; only for code compiled for processors that
/// have it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fused(f64);

impl Rounded for Fused {
    #[inline(always)]
    fn value(self) -> f64 {
        self.0
    }
}

impl Real for Fused {
    #[inline(always)]
    fn of(x: f64) -> Fused {
        Fused(x)
    }

    #[inline(always)]
    fn mul_add(self, b: Fused, c: Fused) -> Fused {
        Fused(self.0.mul_add(b.0, c.0))
    }
}

impl Add for Fused {
    type Output = Fused;
    #[inline(always)]
    fn add(self, other: Fused) -> Fused {
        Fused(self.0 + other.0)
    }
}

impl Sub for Fused {
    type Output = Fused;
    #[inline(always)]
    fn sub(self, other: Fused) -> Fused {
        Fused(self.0 - other.0)
    }
}

impl Mul for Fused {
    type Output = Fused;
    #[inline(always)]
    fn mul(self, other: Fused) -> Fused {
        Fused(self.0 * other.0)
    }
}

impl Neg for Fused {
    type Output = Fused;
    #[inline(always)]
    fn neg(self) -> Fused {
        Fused(-self.0)
    }
}

/// The polynomials of the module's table, and the scale S of their rounding errors.
#[derive(Debug, Clone)]
pub(crate) struct Polynomials<T> {
    pub(crate) tip: T,
    pub(crate) turn: T,
    pub(crate) toe: T,
    pub(crate) slip_left: T,
    pub(crate) slip_right: T,
    /// g (k k' − μ) − 1: `turn` with friction pushing the other way (3.43).
    pub(crate) turn_right: T,
    /// 4 + γ² − 3μg, the denominator of the slide-rock to the left: negative beyond Painlevé's bound (3.35, 4.68).
    pub(crate) regularity: T,
    scale: T,
}

/// The signed slenderness g of the corner that a force can tip the body about: γ (O), or −γ (O') for k' < −1.
#[inline(always)]
pub(crate) fn signed_slenderness(gamma: f64, k_prime: f64) -> f64 {
    if k_prime < -1.0 { -gamma } else { gamma }
}

impl<T: Real> Polynomials<T> {
    #[inline(always)]
    pub(crate) fn at([gamma, k_prime, k, mu]: [f64; 4]) -> Polynomials<T> {
        Polynomials::about(signed_slenderness(gamma, k_prime), [gamma, k_prime, k, mu])
    }

    /// The polynomials for the corner O (g = γ) or O' (g = −γ).
    #[inline(always)]
    pub(crate) fn about(g: f64, [gamma, k_prime, k, mu]: [f64; 4]) -> Polynomials<T> {
        let [one, two, three, four] = [1.0, 2.0, 3.0, 4.0].map(T::of);
        // |u|, which is u for the corner the force can tip the body about and −u for the other.
        let own = T::of(signed_slenderness(gamma, k_prime));
        let g = T::of(g);
        let [γ, k_prime, k, μ] = [gamma, k_prime, k, mu].map(T::of);

        let arm = k.clone() * (k_prime + one.clone());
        let size = own * arm.clone();
        let tip = g.clone() * arm - one.clone();
        let difference = μ.clone() - k.clone();
        let sum = μ.clone() + k;
        let turn = g.clone().mul_add(difference.clone(), tip.clone());
        let inertia = four.clone() * γ.clone().mul_add(γ.clone(), one.clone());
        let lever = three.clone() * tip.clone();
        let sticking = inertia.clone() * sum.clone();
        let regularity = γ.clone().mul_add(γ.clone(), four.clone()) - three.clone() * (μ.clone() * g.clone());
        Polynomials {
            regularity,
            turn_right: tip.clone() - g.clone() * sum.clone(),
            toe: turn.clone() + two,
            slip_left: inertia.mul_add(difference, lever.clone() * (μ.clone() + g.clone())),
            slip_right: lever.mul_add(μ.clone() - g, sticking.clone()),
            scale: three.clone().mul_add(size, three).mul_add(μ + γ, sticking) + one,
            tip,
            turn,
        }
    }
}

/// 16ε: a polynomial larger than this times the scale has the sign that floating point gives it.
const FACTOR: f64 = 1.0 / (1u64 << 49) as f64;

/// What [`screen`] returns where floating point cannot tell, or the input is not valid.
pub(crate) const UNSURE: u8 = u8::MAX;

/// The mode code of a point by floating point, or [`UNSURE`]. No branches, no division: it vectorises.
#[inline(always)]
pub(crate) fn screen<T: Rounded>(gamma: f64, k_prime: f64, k: f64, mu: f64) -> u8 {
    // Not `f64::min`, whose care for NaN costs instructions; a NaN here makes the scale NaN as well.
    let min = |a: f64, b: f64| if a < b { a } else { b };

    let polynomials = Polynomials::<T>::at([gamma, k_prime, k, mu]).map(T::value);
    let Polynomials { tip, turn, toe, slip_left, slip_right, scale, .. } = polynomials;
    let least = min(min(min(tip.abs(), turn.abs()), min(toe.abs(), slip_left.abs())), slip_right.abs());
    // The scale is larger than γ, k and μ, so these comparisons refuse whatever `Point::new` refuses.
    let valid = (gamma >= SMALLEST) & (min(k, mu) >= 0.0) & (scale <= LARGEST) & (k_prime.abs() <= LARGEST);
    let sure = (least > FACTOR * scale) & valid;
    decide(&polynomials, mu - k, k_prime < -1.0, sure)
}

/// The mode code from the signs of the polynomials and of μ − k (spec: "one decision for both chapters"), or
/// [`UNSURE`]; `beyond` says k' < −1.
///
/// Later lines override earlier ones, so they stand in reverse order of precedence.
#[inline(always)]
fn decide(signs: &Polynomials<f64>, friction_surplus: f64, beyond: bool, sure: bool) -> u8 {
    /// Codes are kept in the last byte of an f64 until the end, so that they are chosen in the same vector
    /// registers as the numbers they depend on.
    const CODES: f64 = (1u64 << 52) as f64;
    const fn code(mode: Mode) -> f64 {
        CODES + mode as u8 as f64
    }

    let slides = friction_surplus < 0.0;
    let rock = if beyond { code(Mode::RockOPrime) } else { code(Mode::RockO) };
    let mut mode = if signs.slip_right < 0.0 { code(Mode::SlideRockORight) } else { rock };
    mode = if signs.slip_left < 0.0 { code(Mode::SlideRockOLeft) } else { mode };
    mode = if (signs.slip_left < 0.0) & beyond { code(Mode::SlideRockOPrimeLeft) } else { mode };
    mode = if slides & (signs.turn <= 0.0) { code(Mode::SlideLeft) } else { mode };
    mode = if !beyond & (signs.toe < 0.0) { code(Mode::SlideRockOPrimeLeft) } else { mode };
    mode = if (signs.tip <= 0.0) & !slides { code(Mode::Rest) } else { mode };
    mode = if sure { mode } else { CODES + UNSURE as f64 };
    mode.to_bits() as u8
}

impl<T> Polynomials<T> {
    #[inline(always)]
    fn map<U>(self, mut f: impl FnMut(T) -> U) -> Polynomials<U> {
        Polynomials {
            tip: f(self.tip),
            turn: f(self.turn),
            toe: f(self.toe),
            slip_left: f(self.slip_left),
            slip_right: f(self.slip_right),
            turn_right: f(self.turn_right),
            regularity: f(self.regularity),
            scale: f(self.scale),
        }
    }
}

/// How well the values that a caller needs have to be known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Need {
    /// Their signs.
    Sign,
    /// Their values, to 40 bits at least however much cancels.
    Value,
}

impl Polynomials<f64> {
    /// The polynomials for the corner of g at a valid point, in floating point if that is good enough for those that
    /// `needed` picks, and exact, rounded once, if not.
    pub(crate) fn known<const N: usize>(
        g: f64,
        point: [f64; 4],
        need: Need,
        needed: impl Fn(&Polynomials<f64>) -> [f64; N],
    ) -> Polynomials<f64> {
        let float = Polynomials::<f64>::about(g, point);
        let floor = match need {
            Need::Sign => FACTOR * float.scale,
            Need::Value => float.scale / 256.0,
        };
        let known = |values: &Polynomials<f64>| needed(values).iter().all(|value| value.abs() > floor);
        // The scale covers all polynomials; the bound of each alone is closer, and the values are the same.
        let precise = || {
            let tracked = Polynomials::<Approx>::about(g, point);
            let precise = tracked.map(|value| value.precise().unwrap_or(f64::NAN));
            needed(&precise).iter().all(|value| !value.is_nan())
        };
        if known(&float) || need == Need::Value && precise() { float } else { Polynomials::exact(g, point) }
    }

    #[cold]
    fn exact(g: f64, point: [f64; 4]) -> Polynomials<f64> {
        Polynomials::<Exact>::about(g, point).map(|value| value.to_f64())
    }
}

/// The mode code of a valid point.
#[inline]
pub(crate) fn code(gamma: f64, k_prime: f64, k: f64, mu: f64) -> u8 {
    match screen::<f64>(gamma, k_prime, k, mu) {
        UNSURE => {
            let g = signed_slenderness(gamma, k_prime);
            decide(&Polynomials::exact(g, [gamma, k_prime, k, mu]), mu - k, k_prime < -1.0, true)
        }
        code => code,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The operations of [`Fused`] are those of f64, but for the product and sum that round once.
    #[test]
    fn a_fused_number_is_an_f64() {
        let numbers = [0.1, -3.0, 1.0 + f64::EPSILON, 1e200, -7e-9];
        for a in numbers {
            assert_eq!((-Fused(a)).value(), -a);
            for b in numbers {
                let [sum, difference, product] =
                    [Fused(a) + Fused(b), Fused(a) - Fused(b), Fused(a) * Fused(b)];
                assert_eq!([sum, difference, product].map(Fused::value), [a + b, a - b, a * b]);
                for c in numbers {
                    assert_eq!(Real::mul_add(Fused(a), Fused(b), Fused(c)).value(), a.mul_add(b, c));
                }
            }
        }
        // (1 + ε)² − (1 + 2ε) = ε², which two roundings lose.
        let [x, c] = [1.0 + f64::EPSILON, -1.0 - 2.0 * f64::EPSILON].map(Fused::of);
        assert_eq!(x.mul_add(x, c).value(), f64::EPSILON * f64::EPSILON);
    }

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
