//! Pressures under the base that are not buoyancy.

use super::{Action, Load, LoadKind, LoadSource};
use crate::ball::Scalar;
use crate::body::Body;
use crate::error::InputError;
use crate::quantity::Quantity;

/// A pressure under the base, linear from corner to corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uplift<T = f64> {
    left: T,
    right: T,
    grows: bool,
}

impl<T: Scalar> Uplift<T> {
    /// `left` at O and `right` at O' (Pa); whether it `grows` with the variable loads.
    ///
    /// # Errors
    /// If a pressure is negative or not finite.
    pub fn new(left: T, right: T, grows: bool) -> Result<Uplift<T>, InputError> {
        let pressure = |pressure| InputError::not_negative(Quantity::Pressure, pressure);
        Ok(Uplift { left: pressure(left)?, right: pressure(right)?, grows })
    }

    /// At O, Pa.
    pub fn left(&self) -> T {
        self.left.clone()
    }

    /// At O', Pa.
    pub fn right(&self) -> T {
        self.right.clone()
    }

    /// True if it grows with the variable loads.
    pub fn grows(&self) -> bool {
        self.grows
    }

    /// The load under `body`.
    pub fn load(&self, body: &Body<T>) -> Load<T> {
        let action = Action::base_pressure(body, self.left(), self.right());
        Load { permanent: !self.grows, ..Load::variable(LoadSource::Uplift, LoadKind::Uplift, action) }
    }
}
