//! Exact arithmetic on the numbers a caller gave: sums, differences and products of f64 without rounding.
//!
//! Every finite f64 is `m·2ᵉ` with whole m and e, and so is every polynomial in such numbers. [`Exact`] keeps m
//! as a big integer, so the sign of a polynomial is the sign of m, whatever cancels. It costs about a
//! microsecond a polynomial; callers come here only where a floating-point filter cannot tell.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};

/// The arithmetic that the formulas of this library are written in: f64 and f32 where rounding is accounted for,
/// `Exact` where it is not allowed, `Approx` where it is tracked, [`Ball`](crate::Ball) from decimals as they are written.
pub trait Real:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The number `x`, unrounded.
    fn of(x: f64) -> Self;
}

impl Real for f64 {
    #[inline(always)]
    fn of(x: f64) -> f64 {
        x
    }
}

impl Real for f32 {
    /// The number `x`, rounded.
    #[inline(always)]
    fn of(x: f64) -> f32 {
        x as f32
    }
}

/// `mantissa · 2^exponent`.
#[derive(Debug, Clone)]
pub(crate) struct Exact {
    mantissa: BigInt,
    exponent: i64,
}

impl Exact {
    /// Sign of the number: below, at or above zero.
    pub(crate) fn sign(&self) -> Ordering {
        match self.mantissa.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }

    /// An f64 within one unit in the last place of this number, and of the same sign: below the smallest
    /// subnormal the result is that, not zero.
    pub(crate) fn to_f64(&self) -> f64 {
        let excess = (self.mantissa.bits() as i64 - 64).max(0);
        let leading = i128::try_from(&self.mantissa >> excess).expect("64 bits and a sign");
        let rounded = scale(leading as f64, self.exponent + excess);
        match self.sign() {
            Ordering::Equal => 0.0,
            Ordering::Greater => rounded.max(f64::from_bits(1)),
            Ordering::Less => rounded.min(-f64::from_bits(1)),
        }
    }

    /// Mantissa and exponent.
    pub(crate) fn parts(self) -> (BigInt, i64) {
        (self.mantissa, self.exponent)
    }

    /// The mantissa shifted so that the exponent becomes `exponent`, which must not be larger.
    fn aligned(self, exponent: i64) -> BigInt {
        self.mantissa << (self.exponent - exponent)
    }
}

/// `x · 2^exponent`, in steps that neither overflow nor underflow before the result does.
pub(crate) fn scale(mut x: f64, mut exponent: i64) -> f64 {
    while exponent != 0 && x != 0.0 && x.is_finite() {
        let step = exponent.clamp(-1000, 1000);
        x *= 2f64.powi(step as i32);
        exponent -= step;
    }
    x
}

impl Real for Exact {
    fn of(x: f64) -> Exact {
        assert!(x.is_finite(), "exact arithmetic on {x}");
        let bits = x.to_bits();
        let field = (bits >> 52 & 0x7ff) as i64;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let magnitude = if field == 0 { fraction } else { fraction | 1 << 52 };
        let mantissa = BigInt::from(if x.is_sign_negative() { -magnitude } else { magnitude });
        Exact { mantissa, exponent: field.max(1) - 1075 }
    }
}

impl Add for Exact {
    type Output = Exact;
    fn add(self, other: Exact) -> Exact {
        let exponent = self.exponent.min(other.exponent);
        Exact { mantissa: self.aligned(exponent) + other.aligned(exponent), exponent }
    }
}

impl Neg for Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact { mantissa: -self.mantissa, exponent: self.exponent }
    }
}

impl Sub for Exact {
    type Output = Exact;
    fn sub(self, other: Exact) -> Exact {
        self + -other
    }
}

impl Mul for Exact {
    type Output = Exact;
    fn mul(self, other: Exact) -> Exact {
        Exact { mantissa: self.mantissa * other.mantissa, exponent: self.exponent + other.exponent }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_f64_comes_back() {
        for x in [0.0, 1.0, -0.1, 1e300, -1e-300, f64::MAX, f64::MIN_POSITIVE, 5e-324, -3.5e-320] {
            assert_eq!(Exact::of(x).to_f64(), x);
        }
    }

    #[test]
    fn nothing_is_rounded() {
        // (1 + 2⁻⁵²)² − 1 − 2⁻⁵¹ = 2⁻¹⁰⁴, which f64 loses.
        let x = 1.0 + f64::EPSILON;
        let exact = |v| Exact::of(v);
        let rest = exact(x) * exact(x) - exact(1.0) - exact(2.0 * f64::EPSILON);
        assert_eq!(rest.sign(), Ordering::Greater);
        assert_eq!(rest.to_f64(), f64::EPSILON * f64::EPSILON);
        assert_eq!((exact(0.1) + exact(0.2) - exact(0.3)).sign(), Ordering::Greater);
        assert_eq!((exact(1e308) + exact(1e-308) - exact(1e308)).to_f64(), 1e-308);
    }

    #[test]
    fn products_leave_the_range_of_f64_and_return() {
        let tiny = Exact::of(5e-324) * Exact::of(1e-300);
        assert_eq!(tiny.to_f64(), 5e-324);
        assert_eq!(tiny.sign(), Ordering::Greater);
        assert_eq!((-tiny).to_f64(), -5e-324);
        let huge = Exact::of(1e300) * Exact::of(1e300);
        assert_eq!(huge.to_f64(), f64::INFINITY);
        assert_eq!((-huge).sign(), Ordering::Less);
    }
}
