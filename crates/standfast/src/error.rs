//! The one error of the mechanics: a quantity whose value makes no sense.

/// A value that no body, load or friction can have.
///
/// The message names the quantity, shows the value, and says what is expected:
///
/// ```
/// let error = standfast::Point::new(1.0, 0.4, 2.0, -0.5).unwrap_err();
/// assert_eq!(error.to_string(), "friction μ is -0.5; expected a number from 0 to 1e50");
/// ```
///
/// The limits 1e50 and 1e-50 are far outside any use; within them no formula of this library overflows.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{quantity} is {}; expected {expected}", readable(*.value))]
pub struct InputError {
    /// The quantity in words and symbol, e.g. `friction μ`.
    pub quantity: &'static str,
    /// The value that was given.
    pub value: f64,
    /// What the quantity has to be.
    pub expected: &'static str,
}

/// The value as a person would write it: `1e300`, not three hundred digits.
fn readable(value: f64) -> String {
    let plain = value == 0.0 || !value.is_finite() || (1e-6..1e15).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// The largest magnitude of an input.
pub(crate) const LARGEST: f64 = 1e50;

/// The smallest magnitude of an input that must not be zero.
pub(crate) const SMALLEST: f64 = 1e-50;

impl InputError {
    /// Passes `value` on if it is a number of any sign.
    pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<f64, InputError> {
        InputError::within(quantity, value, -LARGEST, LARGEST, "a number from -1e50 to 1e50")
    }

    /// Passes `value` on if it is a number not below zero.
    pub(crate) fn not_negative(quantity: &'static str, value: f64) -> Result<f64, InputError> {
        InputError::within(quantity, value, 0.0, LARGEST, "a number from 0 to 1e50")
    }

    /// Passes `value` on if it is a number above zero.
    pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<f64, InputError> {
        InputError::within(quantity, value, SMALLEST, LARGEST, "a number above zero, from 1e-50 to 1e50")
    }

    /// Passes `value` on if it lies between `least` and `most`; −0 becomes 0.
    pub(crate) fn within(
        quantity: &'static str,
        value: f64,
        least: f64,
        most: f64,
        expected: &'static str,
    ) -> Result<f64, InputError> {
        if (least..=most).contains(&value) {
            Ok(value + 0.0)
        } else {
            Err(InputError { quantity, value, expected })
        }
    }
}
