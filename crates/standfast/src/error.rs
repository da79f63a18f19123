//! The one error of the mechanics: a quantity whose value makes no sense.

use crate::ball::Scalar;
use crate::number::exact;
use crate::quantity::{Expected, Quantity};

/// A value that no body, load or friction can have.
///
/// The quantity and the expected values are values themselves, so that a program can tell errors apart; the message names the quantity,
/// shows the value, and says what is expected:
///
/// ```
/// use standfast::Quantity;
///
/// let error = standfast::Point::new(1.0, 0.4, 2.0, -0.5).unwrap_err();
/// assert_eq!((error.quantity, error.value), (Quantity::Friction, -0.5));
/// assert_eq!(error.to_string(), "friction μ is -0.5; expected a number from 0 to 1e50");
/// assert_eq!(error.given(), "friction μ is -0.5");
/// ```
///
/// The limits 1e50 and 1e-50 are far outside any use; within them no formula of this library overflows.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{}; expected {expected}", self.given())]
#[non_exhaustive]
pub struct InputError {
    /// The quantity.
    pub quantity: Quantity,
    /// The value that was given.
    pub value: f64,
    /// Condition that the quantity has to meet.
    pub expected: Expected,
}

/// The largest magnitude of an input.
pub(crate) const LARGEST: f64 = 1e50;

/// The smallest magnitude of an input that must not be zero.
pub(crate) const SMALLEST: f64 = 1e-50;

impl InputError {
    /// The quantity with the value that was given, in words: `friction μ is -0.5`.
    pub fn given(&self) -> String {
        format!("{} is {}", self.quantity, exact(self.value))
    }

    /// True if the value is too large or too small, or has the wrong sign, by itself; it does not depend on another.
    pub fn is_about_size(&self) -> bool {
        matches!(self.expected, Expected::Finite | Expected::NotNegative | Expected::Positive)
    }

    pub(crate) fn new(quantity: Quantity, value: f64, expected: Expected) -> InputError {
        InputError { quantity, value, expected }
    }

    /// Passes `value` on if it is a number of any sign.
    pub(crate) fn finite<T: Scalar>(quantity: Quantity, value: T) -> Result<T, InputError> {
        InputError::within(quantity, value, -LARGEST, LARGEST, Expected::Finite)
    }

    /// Passes `value` on if it is a number not below zero.
    pub(crate) fn not_negative<T: Scalar>(quantity: Quantity, value: T) -> Result<T, InputError> {
        InputError::within(quantity, value, 0.0, LARGEST, Expected::NotNegative)
    }

    /// Passes `value` on if it is a number above zero.
    pub(crate) fn positive<T: Scalar>(quantity: Quantity, value: T) -> Result<T, InputError> {
        InputError::within(quantity, value, SMALLEST, LARGEST, Expected::Positive)
    }

    /// Passes `value` on if it lies between `least` and `most`; −0 becomes 0.
    pub(crate) fn within<T: Scalar>(
        quantity: Quantity,
        value: T,
        least: f64,
        most: f64,
        expected: Expected,
    ) -> Result<T, InputError> {
        match value.value() {
            number if (least..=most).contains(&number) => Ok(value + T::of(0.0)),
            number => Err(InputError::new(quantity, number, expected)),
        }
    }
}
