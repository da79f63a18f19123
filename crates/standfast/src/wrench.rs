//! Forces in the plane, added up: a wrench.

use std::iter::Sum;
use std::ops::{Add, Mul, Neg, Sub};

use crate::ball::Scalar;

/// A planar wrench at the centre of mass; in f64, unless signs must not hang on rounding ([`Scalar`]).
///
/// ```text
///        ▲            M ⟲
///        │
///     ───C──► X       X to the right, P downwards
///        ▼
///        P
/// ```
///
/// Wrenches are added and taken off, turned round, and multiplied by a number, component by component:
///
/// ```
/// use standfast::Wrench;
///
/// let weight = Wrench { x: 0.0, p: 3.0, m: 0.0 };
/// let push = Wrench { x: -1.0, p: 0.5, m: 0.25 };
/// assert_eq!(weight + push * 2.0, Wrench { x: -2.0, p: 4.0, m: 0.5 });
/// assert_eq!(weight + push - push, weight);
/// assert_eq!(-push, Wrench { x: 1.0, p: -0.5, m: -0.25 });
/// assert_eq!([weight, push, -push].into_iter().sum::<Wrench>(), weight);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Wrench<T = f64> {
    /// X: horizontal force, to the right.
    pub x: T,
    /// P: net vertical force, downwards.
    pub p: T,
    /// M: moment, counter-clockwise.
    pub m: T,
}

impl Wrench {
    /// No load.
    pub const ZERO: Wrench = Wrench { x: 0.0, p: 0.0, m: 0.0 };
}

impl<T: Scalar> Wrench<T> {
    /// No load, in any arithmetic.
    pub fn zero() -> Wrench<T> {
        Wrench { x: T::of(0.0), p: T::of(0.0), m: T::of(0.0) }
    }

    /// Sum of two; what cancels but for rounding is zero, see [`Scalar::plus`].
    pub fn plus(self, other: Wrench<T>) -> Wrench<T> {
        Wrench { x: self.x.plus(other.x), p: self.p.plus(other.p), m: self.m.plus(other.m) }
    }
}

impl<T: Scalar> Add for Wrench<T> {
    type Output = Wrench<T>;
    fn add(self, other: Wrench<T>) -> Wrench<T> {
        Wrench { x: self.x + other.x, p: self.p + other.p, m: self.m + other.m }
    }
}

impl<T: Scalar> Sub for Wrench<T> {
    type Output = Wrench<T>;
    fn sub(self, other: Wrench<T>) -> Wrench<T> {
        Wrench { x: self.x - other.x, p: self.p - other.p, m: self.m - other.m }
    }
}

impl<T: Scalar> Neg for Wrench<T> {
    type Output = Wrench<T>;
    fn neg(self) -> Wrench<T> {
        Wrench { x: -self.x, p: -self.p, m: -self.m }
    }
}

impl<T: Scalar> Mul<T> for Wrench<T> {
    type Output = Wrench<T>;
    fn mul(self, factor: T) -> Wrench<T> {
        Wrench { x: self.x * factor.clone(), p: self.p * factor.clone(), m: self.m * factor }
    }
}

impl<T: Scalar> Sum for Wrench<T> {
    fn sum<I: Iterator<Item = Wrench<T>>>(wrenches: I) -> Wrench<T> {
        wrenches.fold(Wrench::zero(), Add::add)
    }
}

#[cfg(test)]
mod tests {
    use super::Wrench;

    /// Each component by itself: numbers that no other component has.
    #[test]
    fn components_are_taken_one_by_one() {
        let one = Wrench { x: 1.5, p: -20.25, m: 300.125 };
        let other = Wrench { x: -0.25, p: 7.0, m: 11.5 };
        assert_eq!(one - other, Wrench { x: 1.75, p: -27.25, m: 288.625 });
        assert_eq!(other - one, -(one - other));
        assert_eq!(one - one, Wrench::ZERO);
        assert_eq!(one - other, one + -other);
        assert_eq!(-one, one * -1.0);
        assert_eq!(-(-one), one);
    }
}
