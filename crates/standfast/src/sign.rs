//! The mode of a point, decided by the signs of two polynomials, for every real k' and in any arithmetic.
//!
//! # The polynomials
//!
//! The force overturns about O where its arm about the base, k (1+k'), is not negative, and about O' where it is. Let
//! g = γ with the sign of the arm, u = g k (1+k') = γ k |1+k'| ≥ 0, D = μ − k, and
//!
//! ```text
//! x = u + g min(D, 0)          stays = 1 − |x|
//! H = 1 + γ²    L = ¾ (u − 1)    P = μ (H + L)    Q = H k − L g
//!                              sticks = P − |Q|
//! ```
//!
//! Both have a meaning. With both corners on the base, friction carries the least of k and μ, and the reaction acts at
//! |ξ| = |x| (4.8, 4.17): it has to lie on the base. With one corner lifted and the other at rest, θ̈ = L/H, f_y = (H + L)/H and
//! f_x = Q/H up to the sign of g (3.14–3.16), so that `sticks` is H (μ f_y − |f_x|) (3.24). The order of the report's section IV.7
//! then is:
//!
//! | signs | mode |
//! |---|---|
//! | stays ≥ 0 | rest, or where D < 0 sliding |
//! | else, x < 0 | slide-rock about O': the reaction leaves the base beyond the corner that the force presses down |
//! | else, sticks ≥ 0 | rock about the corner of g |
//! | else | slide-rock about it: of O to the right where Q < 0, to the left elsewhere |
//!
//! That it is the same, with the report's inequalities as polynomials (`initiation/polynomials.rs`):
//!
//! * D ≥ 0: x = u, and −`stays` = `tip`. D < 0: x − 1 = `turn` for either sign of g, and for g > 0 x + 1 = `toe`, so that
//!   `stays` ≥ 0 says `turn` ≤ 0 and `toe` ≥ 0. For g < 0 both parts of x are positive: x < 0 never occurs, as it must not.
//! * 4 (P − Q) = 4H D + 3 (u − 1)(μ + g) = `slip_left` and 4 (P + Q) = 4H (μ + k) + 3 (u − 1)(μ − g) = `slip_right`; so 4 `sticks` is
//!   the lesser. As H + L = ¼ + γ² + ¾u > 0, P is not negative, and where `sticks` < 0 the sign of Q says which one it is.
//! * For g < 0, `sticks` is asked for only where x > 1, that is u > 1 or γ (k − μ) > 1 − u; either way Q = H k + γL > 0, and O' slips to
//!   the left.
//! * k = 0 makes u = 0, D ≥ 0 and `stays` = 1: rest.
//!
//! # The bound
//!
//! In binary arithmetic that rounds each operation by a factor 1 + δ, |δ| ≤ ε, let γ, μ and D be within ε, and u within 3ε, of what they
//! are: so it is where all is done in f64 (ε = 2⁻⁵³), and where γ, μ, D and k (1+k') are formed in f64 and then rounded to f32 (ε = 2⁻²⁴;
//! what f64 rounds before is nothing beside it). k is taken as μ − D. To first order, with s = γ |min(D, 0)| ≤ γk ≤ ½Hk:
//!
//! * `stays`: u is off by 3εu, s by 3εs, their sum by ε|x| more. Either x = u − s, or x = u + s: u + s ≤ |x| + 2s. With |x| ≤ 1 + |stays| the
//!   error is at most ε(4|x| + 6s + |stays|) ≤ ε(5|stays| + 4 + 3Hk).
//! * H is off by ε(3γ² + H) ≤ 4εH, L by ε(2¼u + 2|L|). Their sum is off by at most 11ε(H + L): 3γ² + H + 2¼u + 2|L| ≤ 10(H + L), where
//!   u ≤ 1 as 4γ² + ¾u + 2½ ≤ 10(¼ + γ² + ¾u), and where u > 1 as 4γ² + 3¾u − ½ is less still. P is off by 13εP.
//! * k is off by ε(μ + |D| + k) ≤ 2ε(μ + k), Hk by ε(2Hμ + 7Hk) ≤ ε(8P + 7Hk), because H ≤ 4(H + L).
//! * Lg is off by ε(2¼uγ + 4|Lg|) ≤ ε(2¼γ + 7|Lg|), as ¾u ≤ ¾ + |L|; γ ≤ ½H, |Lg| ≤ |Q| + Hk. The last two sums add ε|Q| and ε|sticks|, and
//!   |sticks| ≤ P + |Q|. In all, `sticks` is off by at most ε(22P + 9|Q| + 14Hk + 2H).
//!
//! Let S = P + |Q| + Hk + H ≥ 1. Where |stays| and |sticks| are larger than 32εS, both have the sign that was computed: their errors
//! are below 5ε|stays| + 4εS and 22εS. So have x, where |x| > 1, and Q, where |Q| > P. Terms in ε², and that S itself is rounded (its terms
//! as above), are far inside the difference of 32 and 22.
//!
//! *Overflow.* Each number above is a term of S or a factor of one (u of P, s of Hk, Lg of Q): an infinity or a NaN makes S one, and the
//! comparison fails. *Underflow* adds at most η to a conversion or a product, η = 2⁻¹⁵⁰ in f32. While S is finite, γ² and u are below 2¹²⁸, and
//! γ is normal. What is multiplied by γ or H is then off by less than 2⁻⁸⁰H; μ, multiplied by ¾u as well, by less than 2⁻²²: nothing beside the
//! 10εS ≥ 2⁻²¹ to spare. The signs of D and k (1+k') survive it, as −0. In f64 all of it is smaller.
//!
//! There is no tolerance: where the comparison fails, the same two polynomials decide in exact arithmetic.

use crate::approx::{Approx, Signed};
use crate::error::{LARGEST, SMALLEST};
use crate::exact::{Exact, Real};
use crate::mode::Mode;

/// Arithmetic in which a mode can be decided.
pub(crate) trait Number: Real {
    /// True if it is below zero; of f32 and f64, whose underflow keeps the sign, −0 too.
    fn is_negative(&self) -> bool;

    /// Its magnitude.
    fn abs(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    /// This number, which is not negative, with the sign of another.
    fn with_sign_of(self, other: &Self) -> Self {
        if other.is_negative() { -self } else { self }
    }
}

impl Number for Exact {
    fn is_negative(&self) -> bool {
        self.sign().is_lt()
    }
}

impl Number for Approx {
    fn is_negative(&self) -> bool {
        self.value() < 0.0
    }
}

/// Arithmetic in which a mode can be screened: decided where rounding does not matter.
pub(crate) trait Float: Number + Copy + Default + PartialOrd {
    /// 32ε.
    const FACTOR: Self;
    /// The smallest γ it is used for.
    const LEAST: f64;
    /// The largest S it is used for. S is larger than γ, k and μ/4, so whatever is larger than [`LARGEST`] is refused.
    const MOST: Self;
}

macro_rules! float {
    ($float:ident, $least:expr, $most:expr) => {
        impl Number for $float {
            #[inline(always)]
            fn is_negative(&self) -> bool {
                self.is_sign_negative()
            }

            #[inline(always)]
            fn abs(self) -> $float {
                $float::abs(self)
            }

            #[inline(always)]
            fn with_sign_of(self, other: &$float) -> $float {
                self.copysign(*other)
            }
        }

        impl Float for $float {
            const FACTOR: $float = 16.0 * $float::EPSILON;
            const LEAST: f64 = $least;
            const MOST: $float = $most;
        }
    };
}

// Numbers above LARGEST are infinite in f32.
float!(f32, f32::MIN_POSITIVE as f64, f32::INFINITY);
float!(f64, SMALLEST, LARGEST / 4.0);

/// γ, k (1+k'), D and μ: all that a mode depends on.
pub(crate) type Terms<T> = [T; 4];

/// The terms of a valid point.
#[inline(always)]
pub(crate) fn terms<T: Real>([gamma, k_prime, k, mu]: [f64; 4]) -> Terms<T> {
    let [γ, k_prime, k, μ] = [gamma, k_prime, k, mu].map(T::of);
    [γ, k.clone() * (k_prime + T::of(1.0)), μ.clone() - k, μ]
}

/// The terms of any four numbers, formed in f64 and then rounded; where they are not those of a point, or γ is too small for `F`, the
/// second is NaN, and the screen is not sure.
#[inline(always)]
pub(crate) fn terms_of_any<F: Float>([gamma, k_prime, k, mu]: [f64; 4]) -> Terms<F> {
    let least = if k < mu { k } else { mu };
    let valid = (gamma >= F::LEAST) & (least >= 0.0) & (k_prime.abs() <= LARGEST);
    // Adding zero turns −0 into 0, so that D is never −0.
    let [gamma, arm, surplus, mu] = terms::<f64>([gamma, k_prime, k, mu + 0.0]);
    // A NaN by bits, which costs one instruction.
    let arm = f64::from_bits(arm.to_bits() | if valid { 0 } else { u64::MAX });
    [gamma, arm, surplus, mu].map(F::of)
}

/// Value of [`screen`] where floating point cannot tell, or the terms are not those of a valid point. The last byte counts.
pub(crate) const UNSURE: u32 = u32::MAX;

/// The code of the mode by signs alone; `stays` and `sticks`, whose signs they are; and S, the size of what these are made of.
#[inline(always)]
fn decide<T: Number>([γ, arm, surplus, μ]: Terms<T>) -> (u32, T, T, T) {
    let [one, three_quarters] = [1.0, 0.75].map(T::of);

    let slides = surplus.is_negative();
    let about_o_prime = arm.is_negative();
    let k = μ.clone() - surplus.clone();
    let g = γ.clone().with_sign_of(&arm);
    let u = g.clone() * arm;
    let x = u.clone() + g.clone() * if slides { surplus } else { T::of(0.0) };
    let stays = one.clone() - x.clone().abs();

    let inertia = one.clone() + γ.clone() * γ;
    let turn = three_quarters * (u - one);
    let friction = μ * (inertia.clone() + turn.clone());
    let push = inertia.clone() * k;
    let pull = push.clone() - turn * g;
    let leftward = !pull.is_negative();
    let pull = pull.abs();
    let sticks = friction.clone() - pull.clone();

    let rock = if about_o_prime { Mode::RockOPrime } else { Mode::RockO } as u32;
    let slip = if about_o_prime { Mode::SlideRockOPrimeLeft } else { Mode::SlideRockOLeft } as u32;
    let slip = if leftward { slip } else { Mode::SlideRockORight as u32 };
    let lifts = if sticks.is_negative() { slip } else { rock };
    let lifts = if x.is_negative() { Mode::SlideRockOPrimeLeft as u32 } else { lifts };
    let both = if slides { Mode::SlideLeft } else { Mode::Rest } as u32;
    let mode = if stays.is_negative() { lifts } else { both };
    (mode, stays, sticks, friction + pull + (push + inertia))
}

/// The code of the mode by floating point, or [`UNSURE`]. No branches, no division: it vectorises.
#[inline(always)]
pub(crate) fn screen<F: Float>(terms: Terms<F>) -> u32 {
    let (mode, stays, sticks, size) = decide(terms);
    // Not `f32::min`, whose care for NaN costs instructions; a NaN here makes the size NaN as well.
    let (stays, sticks) = (stays.abs(), sticks.abs());
    let least = if stays < sticks { stays } else { sticks };
    #[expect(
        clippy::neg_cmp_op_on_partial_ord,
        reason = "no instruction in f32, where nothing is larger than MOST"
    )]
    let sure = (least > F::FACTOR * size) & !(size > F::MOST);
    if sure { mode } else { UNSURE }
}

/// The code of the mode of a valid point.
#[inline]
pub(crate) fn code(point: [f64; 4]) -> u8 {
    let code = match screen(terms::<f64>(point)) {
        UNSURE => exact(point),
        code => code,
    };
    code as u8
}

/// Code of the mode without the bound above: with rounding tracked, and where that cannot tell, in exact arithmetic.
#[cold]
pub(crate) fn exact(point: [f64; 4]) -> u32 {
    tracked(point).unwrap_or_else(|| decide(terms::<Exact>(point)).0)
}

/// Code of the mode with rounding tracked, where that can tell. The errors of x and Q are in those of `stays` and `sticks`, and the signs of D
/// and k (1+k') are those of f64, right where they matter.
fn tracked(point: [f64; 4]) -> Option<u32> {
    let (mode, stays, sticks, _) = decide(terms::<Approx>(point));
    // Of a body with both corners on the base nobody asks whether one would slip.
    let is_known = stays.sign()?.is_ge() || sticks.sign().is_some();
    is_known.then_some(mode)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without a force a block of γ = 1 on μ = 0.6 rests, though `sticks` is next to nothing there: 0.6 is no f64.
    #[test]
    fn rest_is_told_where_a_slip_is_not() {
        for k_prime in [-1.5, -1.0, 0.0, 0.4, 3.0] {
            let point = [1.0, k_prime, 0.0, 0.6];
            assert_eq!(decide(terms::<Approx>(point)).2.sign(), None);
            assert_eq!(tracked(point), Some(Mode::Rest as u32));
            assert_eq!(decide(terms::<Exact>(point)).0, Mode::Rest as u32);
        }
    }
}
