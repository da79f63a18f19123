//! Forces in the plane, added up: a wrench.

use std::iter::Sum;
use std::ops::{Add, Mul, Neg, Sub};

/// A planar wrench at the centre of mass.
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
pub struct Wrench {
    /// X: horizontal force, to the right.
    pub x: f64,
    /// P: net vertical force, downwards.
    pub p: f64,
    /// M: moment, counter-clockwise.
    pub m: f64,
}

impl Wrench {
    /// No load.
    pub const ZERO: Wrench = Wrench { x: 0.0, p: 0.0, m: 0.0 };
}

impl Add for Wrench {
    type Output = Wrench;
    fn add(self, other: Wrench) -> Wrench {
        Wrench { x: self.x + other.x, p: self.p + other.p, m: self.m + other.m }
    }
}

impl Sub for Wrench {
    type Output = Wrench;
    fn sub(self, other: Wrench) -> Wrench {
        Wrench { x: self.x - other.x, p: self.p - other.p, m: self.m - other.m }
    }
}

impl Neg for Wrench {
    type Output = Wrench;
    fn neg(self) -> Wrench {
        Wrench { x: -self.x, p: -self.p, m: -self.m }
    }
}

impl Mul<f64> for Wrench {
    type Output = Wrench;
    fn mul(self, factor: f64) -> Wrench {
        Wrench { x: self.x * factor, p: self.p * factor, m: self.m * factor }
    }
}

impl Sum for Wrench {
    fn sum<I: Iterator<Item = Wrench>>(wrenches: I) -> Wrench {
        wrenches.fold(Wrench::ZERO, Add::add)
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
