//! f64 with a running bound on its rounding error: a sign is known, or known to be unknown.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use crate::exact::{Exact, Real};

/// An arithmetic that can tell the sign of a result, or say that it cannot.
pub(crate) trait Signed: Real {
    fn sign(&self) -> Option<Ordering>;
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
    /// A rounded result: its own rounding (one ulp covers it, a smallest subnormal what underflows) joins the
    /// bound, and the bound is widened for the roundings it suffered itself.
    fn rounded(value: f64, error: f64) -> Approx {
        const WIDER: f64 = 1.0 + 8.0 * f64::EPSILON;
        Approx { value, error: (error + f64::EPSILON * value.abs()) * WIDER + f64::MIN_POSITIVE }
    }

    /// The value, if 40 of its bits are certain.
    pub(crate) fn precise(self) -> Option<f64> {
        (self.value.abs() > self.error * (1u64 << 40) as f64).then_some(self.value)
    }

    fn is_zero(self) -> bool {
        self.value == 0.0 && self.error == 0.0
    }
}

impl Real for Approx {
    fn of(x: f64) -> Approx {
        Approx { value: x, error: 0.0 }
    }
}

impl Signed for Approx {
    fn sign(&self) -> Option<Ordering> {
        // Written so that a NaN or an infinite bound is unknown.
        if self.value.abs() > self.error || self.is_zero() { self.value.partial_cmp(&0.0) } else { None }
    }
}

impl Add for Approx {
    type Output = Approx;
    fn add(self, other: Approx) -> Approx {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        Approx::rounded(self.value + other.value, self.error + other.error)
    }
}

impl Neg for Approx {
    type Output = Approx;
    fn neg(self) -> Approx {
        Approx { value: -self.value, error: self.error }
    }
}

impl Sub for Approx {
    type Output = Approx;
    fn sub(self, other: Approx) -> Approx {
        self + -other
    }
}

impl Mul for Approx {
    type Output = Approx;
    fn mul(self, other: Approx) -> Approx {
        if self.is_zero() || other.is_zero() {
            return Approx::of(0.0);
        }
        let error =
            self.value.abs() * other.error + other.value.abs() * self.error + self.error * other.error;
        Approx::rounded(self.value * other.value, error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_lost_to_rounding_is_unknown() {
        let [tenth, fifth, third_tenth] = [0.1, 0.2, 0.3].map(Approx::of);
        assert_eq!((tenth + fifth - third_tenth).sign(), None);
        assert_eq!((tenth + fifth).sign(), Some(Ordering::Greater));
        assert_eq!((tenth * Approx::of(0.0)).sign(), Some(Ordering::Equal));
        assert_eq!((Approx::of(1e300) * Approx::of(1e300) - Approx::of(1.0)).sign(), None);
        assert_eq!((Approx::of(1e-200) * Approx::of(1e-200)).sign(), None);
    }
}
