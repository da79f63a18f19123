//! Forces in the plane, added up: a wrench.

use std::iter::Sum;
use std::ops::{Add, Mul};

/// A planar wrench at the centre of mass.
///
/// ```text
///        ▲            M ⟲
///        │
///     ───C──► X       X to the right, P downwards
///        ▼
///        P
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
