//! Pairs of f64 with a running bound on their error: what [`Approx`](crate::approx::Approx) cannot tell this mostly can, at a small part
//! of the price of exact arithmetic.
//!
//! A number is `high + low`, unevaluated. Sums and products of plain f64 are exact, unless they over- or underflow; so is their sign.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use crate::approx::{Signed, WIDER};
use crate::exact::Real;

/// A value in two parts and a bound on its distance from the exact result.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Twofold {
    high: f64,
    low: f64,
    error: f64,
}

/// Half a unit in the last place, twice: roundings of the bound itself are covered.
const LOST: f64 = f64::EPSILON;
/// A product smaller than this may lose digits of its low part. One that overflows has a low part that is no number.
const SMALL: f64 = 1e-270;

/// The sum and what it lost: exact unless it overflows.
#[inline(always)]
fn sum(a: f64, b: f64) -> (f64, f64) {
    let high = a + b;
    let of_b = high - a;
    (high, (a - (high - of_b)) + (b - of_b))
}

/// The upper half of the digits and the rest.
#[inline(always)]
fn split(x: f64) -> (f64, f64) {
    let wide = 134_217_729.0 * x;
    let upper = wide - (wide - x);
    (upper, x - upper)
}

/// The product and what it lost: exact above the size above.
#[inline(always)]
fn product(a: f64, b: f64) -> (f64, f64) {
    let high = a * b;
    let ((a1, a0), (b1, b0)) = (split(a), split(b));
    (high, a0 * b0 - (((high - a1 * b1) - a0 * b1) - a1 * b0))
}

impl Twofold {
    fn size(self) -> f64 {
        self.high.abs() + self.low.abs()
    }

    fn is_zero(self) -> bool {
        self.high == 0.0 && self.low == 0.0 && self.error == 0.0
    }

    fn put_together(high: f64, low: f64, error: f64) -> Twofold {
        let (high, low) = sum(high, low);
        Twofold { high, low, error: error * WIDER }
    }
}

impl Real for Twofold {
    fn of(x: f64) -> Twofold {
        Twofold { high: x, low: 0.0, error: 0.0 }
    }
}

impl Signed for Twofold {
    fn sign(&self) -> Option<Ordering> {
        // The parts do not overlap: the high one has the sign, and the low one less than half a unit in its last place. Written so that a
        // NaN or an infinite bound is unknown.
        if self.is_zero() {
            Some(Ordering::Equal)
        } else if self.high.abs() - self.low.abs() > self.error && self.high.is_finite() {
            self.high.partial_cmp(&0.0)
        } else {
            None
        }
    }
}

impl Add for Twofold {
    type Output = Twofold;
    fn add(self, other: Twofold) -> Twofold {
        let (high, lost) = sum(self.high, other.high);
        // What these two lose is known.
        let (lows, one) = sum(self.low, other.low);
        let (low, two) = sum(lost, lows);
        Twofold::put_together(high, low, self.error + other.error + (one.abs() + two.abs()))
    }
}

impl Neg for Twofold {
    type Output = Twofold;
    fn neg(self) -> Twofold {
        Twofold { high: -self.high, low: -self.low, error: self.error }
    }
}

impl Sub for Twofold {
    type Output = Twofold;
    fn sub(self, other: Twofold) -> Twofold {
        self + -other
    }
}

impl Mul for Twofold {
    type Output = Twofold;
    fn mul(self, other: Twofold) -> Twofold {
        if self.is_zero() || other.is_zero() {
            return Twofold::of(0.0);
        }
        let (high, lost) = product(self.high, other.high);
        let crossed = [self.high * other.low, self.low * other.high];
        let lows = crossed[0] + crossed[1];
        let low = lost + lows;
        let passed = self.size() * other.error + other.size() * self.error + self.error * other.error;
        let is_plain = self.low == 0.0 && other.low == 0.0 && self.error == 0.0 && other.error == 0.0;
        let rounded = match is_plain && high.abs() > SMALL {
            true => 0.0,
            // The product of the low parts is left out; what underflows here, in the line before and in `product` is less than the last term.
            false => {
                LOST * (crossed[0].abs() + crossed[1].abs() + lows.abs() + low.abs())
                    + (self.low * other.low).abs()
                    + f64::MIN_POSITIVE
            }
        };
        Twofold::put_together(high, low, passed + rounded)
    }
}

#[cfg(test)]
mod tests {
    use dashu_ratio::Relaxed as Rational;

    use super::*;
    use crate::calculated_twice::{self, distance, operands, rational};

    type Both = calculated_twice::Both<Twofold>;

    impl Both {
        fn all(&self, other: &Both) -> [Both; 3] {
            [self.add(other), self.sub(other), self.mul(other)]
        }

        /// The true error of the value.
        fn error(&self) -> Rational {
            distance(&(rational(self.tracked.high) + rational(self.tracked.low)), &self.exact)
        }

        fn check(&self) {
            let Twofold { high, low, error } = self.tracked;
            if !high.is_finite() || !low.is_finite() || !error.is_finite() {
                assert_eq!(self.tracked.sign(), None);
                return;
            }
            assert!(self.error() <= rational(error), "{high:e} {low:e} ± {error:e}: {}", self.exact);
            if let Some(sign) = self.tracked.sign() {
                assert_eq!(sign, self.exact.cmp(&rational(0.0)), "{high:e} {low:e} ± {error:e}");
            }
        }
    }

    /// Three operations deep, on every pair of operands and a share of the results: the bound holds, and a sign that is told is right.
    #[test]
    fn every_bound_holds() {
        let operands: Vec<Both> = operands();
        let mut results: Vec<Both> = Vec::new();
        for one in &operands {
            results.extend(operands.iter().flat_map(|two| one.all(two)));
        }
        results.iter().for_each(Both::check);
        let mut deeper = Vec::new();
        for (i, one) in results.iter().enumerate() {
            for two in results.iter().skip(i % 601).step_by(601).chain(&operands[i % 4..i % 4 + 4]) {
                let all = one.all(two);
                all.iter().for_each(Both::check);
                if i % 17 == 0 {
                    deeper.extend(all);
                }
            }
        }
        for (i, one) in deeper.iter().enumerate() {
            for two in deeper.iter().skip(i % 997).step_by(9973) {
                one.all(two).iter().for_each(Both::check);
            }
        }
    }

    /// What it is for: of numbers of ordinary size a hundred bits are right, and a sum of given numbers is exact.
    #[test]
    fn a_hundred_bits_are_told() {
        let [tenth, fifth, third_tenth] = [0.1, 0.2, 0.3].map(Twofold::of);
        // In f64 the sign of this is lost.
        assert_eq!((tenth + fifth - third_tenth).sign(), Some(Ordering::Greater));
        assert_eq!((tenth * fifth - fifth * tenth).sign(), Some(Ordering::Equal));
        let [a, b] = [1.0 / 3.0, 1.0 / 7.0].map(Twofold::of);
        let cube = a * a * a * b;
        assert!(cube.error < 1e-31 * cube.high, "{cube:?}");
        // Three factors no longer are exact.
        assert_eq!((cube - b * a * a * a).sign(), None);
        assert_eq!((Twofold::of(1e300) * Twofold::of(1e300) - Twofold::of(1.0)).sign(), None);
        assert_eq!((Twofold::of(1e-200) * Twofold::of(1e-200)).sign(), None);
    }
}
