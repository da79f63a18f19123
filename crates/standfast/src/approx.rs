//! f64 with a running bound on its rounding error: a sign is known, or known to be unknown.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::exact::{Exact, Real};

/// An arithmetic that can tell the sign of a result, or say that it cannot.
pub(crate) trait Signed: Real {
    fn sign(&self) -> Option<Ordering>;
}

/// A sign; what is not known to the digits given is zero.
pub(crate) fn sign<T: Signed>(value: &T) -> Ordering {
    value.sign().unwrap_or(Ordering::Equal)
}

impl Signed for Exact {
    fn sign(&self) -> Option<Ordering> {
        Some(Exact::sign(self))
    }
}

/// A value and a bound on its distance from the exact result.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Approx {
    value: f64,
    error: f64,
}

impl Approx {
    /// A known zero.
    pub(crate) const ZERO: Approx = Approx { value: 0.0, error: 0.0 };

    /// A rounded result: its own rounding joins the bound.
    ///
    /// A rounding loses half a unit in the last place at most. A whole one is added: the other half covers the roundings of the
    /// bound itself, which lose it less than 2⁻⁵⁰ of its size an operation. What underflows here or there loses a few
    /// smallest subnormals; the smallest normal number is more.
    #[inline(always)]
    fn rounded(value: f64, error: f64) -> Approx {
        Approx { value, error: error + f64::EPSILON * value.abs() + f64::MIN_POSITIVE }
    }

    /// The value.
    #[inline(always)]
    pub(crate) fn value(self) -> f64 {
        self.value
    }

    /// The bound on the distance of the value from the exact result.
    #[inline(always)]
    pub(crate) fn error(self) -> f64 {
        self.error
    }

    /// The value, if 40 of its bits are certain.
    pub(crate) fn precise(self) -> Option<f64> {
        (self.value.abs() > self.error * (1u64 << 40) as f64).then_some(self.value)
    }

    /// Any number within `error` of `value`.
    #[inline(always)]
    pub(crate) fn around(value: f64, error: f64) -> Approx {
        Approx { value, error }
    }

    /// True if its sign is known. Written so that a NaN or an infinite bound is unknown.
    #[inline(always)]
    pub(crate) fn is_told(self) -> bool {
        (self.value.abs() > self.error) | self.is_zero()
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        (self.value == 0.0) & (self.error == 0.0)
    }
}

impl Real for Approx {
    #[inline(always)]
    fn of(x: f64) -> Approx {
        Approx { value: x, error: 0.0 }
    }
}

impl Signed for Approx {
    #[inline(always)]
    fn sign(&self) -> Option<Ordering> {
        if self.is_told() { self.value.partial_cmp(&0.0) } else { None }
    }
}

// Sums and products without branches, so that loops over them vectorise.

impl Add for Approx {
    type Output = Approx;
    #[inline(always)]
    fn add(self, other: Approx) -> Approx {
        let (value, error) = (self.value + other.value, self.error + other.error);
        // A sum of two f64 is rounded to zero only where it is zero: μ_s − μ_k, where both are the same. A known zero adds nothing.
        let is_exact = self.is_zero() | other.is_zero() | ((value == 0.0) & (error == 0.0));
        let rounded = Approx::rounded(value, error);
        Approx { value, error: if is_exact { error } else { rounded.error } }
    }
}

impl Neg for Approx {
    type Output = Approx;
    #[inline(always)]
    fn neg(self) -> Approx {
        Approx { value: -self.value, error: self.error }
    }
}

impl Sub for Approx {
    type Output = Approx;
    #[inline(always)]
    fn sub(self, other: Approx) -> Approx {
        self + -other
    }
}

impl Mul for Approx {
    type Output = Approx;
    #[inline(always)]
    fn mul(self, other: Approx) -> Approx {
        let error =
            self.value.abs() * other.error + other.value.abs() * self.error + self.error * other.error;
        let rounded = Approx::rounded(self.value * other.value, error);
        let is_zero = self.is_zero() | other.is_zero();
        // Part by part: a choice between two pairs is a branch to the compiler.
        Approx {
            value: if is_zero { 0.0 } else { rounded.value },
            error: if is_zero { 0.0 } else { rounded.error },
        }
    }
}

impl Div for Approx {
    type Output = Approx;

    /// The quotient; nothing is known of one by what may be near zero.
    #[inline(always)]
    fn div(self, other: Approx) -> Approx {
        if self.is_zero() && other.is_told() && !other.is_zero() {
            return Approx::ZERO;
        }
        let value = self.value / other.value;
        // What the divisor is at least: half of it, so that the roundings of this line are covered by the next.
        let least = other.value.abs() - other.error;
        let error = (self.error + value.abs() * other.error + f64::MIN_POSITIVE) / least * WIDER;
        let is_known = least > 0.5 * other.value.abs();
        Approx::rounded(value, if is_known { error } else { f64::INFINITY })
    }
}

/// Covers the roundings of a bound that is made of few terms.
pub(crate) const WIDER: f64 = 1.0 + 1e-12;

#[cfg(test)]
mod tests {
    use dashu_ratio::Relaxed as Rational;

    use super::*;
    use crate::calculated_twice::{self, distance, operands, rational};

    type Both = calculated_twice::Both<Approx>;

    impl Both {
        /// The true error of the value.
        fn error(&self) -> Rational {
            distance(&rational(self.tracked.value), &self.exact)
        }

        /// True if the true error is within the bound.
        fn is_bounded(&self) -> bool {
            self.error() <= rational(self.tracked.error)
        }

        /// True if the true error is more than this share of the bound.
        fn reaches(&self, share: f64) -> bool {
            self.error() > rational(share) * rational(self.tracked.error)
        }
    }

    /// Every operation on every pair of operands, and again on the results: the bound holds, a sign that is told is right,
    /// and each operation comes near its bound.
    #[test]
    fn every_bound_holds_and_is_no_larger_than_needed() {
        let operands: Vec<Both> = operands();
        let mut results = Vec::new();
        for one in &operands {
            for two in &operands {
                results.extend([one.add(two), one.sub(two), one.mul(two)]);
            }
        }
        let check = |both: &Both| {
            let Approx { value, error } = both.tracked;
            assert!(both.is_bounded(), "{value:e} ± {error:e}: {}", both.exact);
            if let Some(sign) = both.tracked.sign() {
                assert_eq!(sign, both.exact.cmp(&rational(0.0)), "{value:e} ± {error:e}: {}", both.exact);
            }
        };
        results.iter().for_each(check);
        // A unit in the last place covers a rounding, which is half of one at most.
        assert!(results.iter().any(|both| both.reaches(0.49)));
        for (i, one) in results.iter().enumerate() {
            for two in results.iter().skip(i % 601).step_by(601).chain(&operands[i % 4..i % 4 + 4]) {
                for both in [one.add(two), one.sub(two), one.mul(two), two.mul(one)] {
                    if both.tracked.value.is_finite() && both.tracked.error.is_finite() {
                        check(&both);
                    } else {
                        assert_eq!(both.tracked.sign(), None);
                    }
                }
            }
        }
    }

    /// Quotients of results and operands: the bound holds, is no larger than needed, and nothing is known beside zero.
    #[test]
    fn quotients_are_bounded() {
        let operands: Vec<Both> = operands();
        let sums: Vec<Both> =
            operands.iter().zip(operands.iter().rev()).map(|(one, two)| one.add(two)).collect();
        let mut near = false;
        for one in operands.iter().chain(&sums) {
            for two in operands.iter().chain(&sums) {
                let quotient = one.tracked / two.tracked;
                if two.exact == rational(0.0) || !quotient.value.is_finite() || !quotient.error.is_finite() {
                    assert_eq!(quotient.sign(), None, "{:?} / {:?}", one.tracked, two.tracked);
                    continue;
                }
                let both = Both { tracked: quotient, exact: &one.exact / &two.exact };
                assert!(both.is_bounded(), "{:?} / {:?}: {quotient:?}", one.tracked, two.tracked);
                near |= both.reaches(0.4);
            }
        }
        assert!(near);
        let lost = Approx { value: 1e-17, error: 1e-16 };
        assert_eq!((Approx::of(1.0) / lost).sign(), None);
        assert_eq!((Approx::ZERO / Approx::of(3.0)).sign(), Some(Ordering::Equal));
        assert_eq!((Approx::ZERO / Approx::ZERO).sign(), None);
    }

    /// 1 + ε/2 + ε/2 + …: the value stays 1 and every addition loses ε/2, while its bound grows by ε.
    fn worn(count: u32) -> Both {
        (0..count).fold(Both::of(1.0), |sum, _| sum.add(&Both::of(f64::EPSILON / 2.0)))
    }

    /// Chains whose error is near their bound in each of its parts: what comes with either operand, with both, and is passed
    /// on by a sum or a difference. A bound without one of them, or a few times smaller, does not hold.
    #[test]
    fn chains_of_operations_come_near_their_bound() {
        let (worn, three) = (worn(64), Both::of(3.0));
        // 1 − 1, of which nothing is left but the error.
        let lost = worn.sub(&Both::of(1.0));
        assert_eq!(lost.tracked.value, 0.0);
        for (name, both) in [
            ("sum", worn.clone()),
            ("difference", Both::of(2.0).sub(&worn)),
            ("sum of sums", worn.add(&worn)),
            ("difference from nothing", Both::of(0.0).sub(&worn)),
            ("left factor", worn.mul(&three)),
            ("right factor", three.mul(&worn)),
            ("left factor, negative", Both::of(-3.0).mul(&worn)),
            ("right factor, negative", worn.mul(&Both::of(-3.0))),
            ("square", worn.mul(&worn)),
            ("nothing known", lost.clone()),
            ("nothing known of one factor", lost.mul(&three)),
            ("nothing known of the other", three.mul(&lost)),
        ] {
            assert!(both.is_bounded() && both.reaches(0.45), "{name}: {:?}", both.tracked);
        }
        let square = lost.mul(&lost);
        assert!(square.is_bounded() && square.reaches(0.2), "{:?}", square.tracked);
        assert_eq!([lost.tracked.sign(), square.tracked.sign()], [None, None]);
    }

    /// A value counts as precise if its bound is below 2⁻⁴⁰ of it; then as many bits are right.
    #[test]
    fn a_precise_value_has_forty_bits() {
        // 1 + 4/3·2ᵗ − 1, with a bound of 2⁻⁵²: 40 bits are left from t = −12 on.
        let rest = |t: i32| {
            let small = 2f64.powi(t) * (1.0 + 1.0 / 3.0);
            Both::of(1.0).add(&Both::of(small)).sub(&Both::of(1.0))
        };
        for t in -60..0 {
            let rest = rest(t);
            assert_eq!(rest.tracked.precise().is_some(), t >= -12, "{t}");
            if let Some(value) = rest.tracked.precise() {
                assert!(rest.error() * rational(2f64.powi(40)) < rational(value.abs()), "{t}");
            }
        }
        assert_eq!(Approx::of(-0.1).precise(), Some(-0.1));
        assert_eq!(Approx::of(0.0).precise(), None);
    }

    #[test]
    fn a_sign_lost_to_rounding_is_unknown() {
        let [tenth, fifth, third_tenth] = [0.1, 0.2, 0.3].map(Approx::of);
        assert_eq!((tenth + fifth - third_tenth).sign(), None);
        assert_eq!((tenth + fifth).sign(), Some(Ordering::Greater));
        assert_eq!((-tenth - fifth).sign(), Some(Ordering::Less));
        assert_eq!((tenth * Approx::of(0.0)).sign(), Some(Ordering::Equal));
        assert_eq!((Approx::of(1e300) * Approx::of(1e300) - Approx::of(1.0)).sign(), None);
        assert_eq!((Approx::of(1e-200) * Approx::of(1e-200)).sign(), None);
    }

    /// Terms that are exactly zero cost nothing, on either side: so the conditions of a block without friction stay exact.
    #[test]
    fn zero_adds_no_error() {
        let [zero, tenth] = [0.0, 0.1].map(Approx::of);
        for sum in [zero + tenth, tenth + zero, tenth - zero, zero * tenth + tenth, tenth + tenth * zero] {
            assert_eq!((sum.value, sum.error), (0.1, 0.0));
        }
    }

    /// Values given twice cancel to a known zero, or every block with one friction would need exact arithmetic; rounded values do not.
    #[test]
    fn equal_numbers_differ_by_a_known_zero() {
        for x in [0.6, 1e-300, 5e-324, 1e300] {
            assert_eq!((Approx::of(x) - Approx::of(x)).sign(), Some(Ordering::Equal), "{x:e}");
        }
        let third = Approx::of(1.0 / 3.0) * Approx::of(3.0);
        assert_eq!((third - Approx::of(1.0)).sign(), None);
    }
}
