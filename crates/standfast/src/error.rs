//! The one error of the mechanics: a quantity whose value makes no sense.

/// A value that no body, load or friction can have.
///
/// The message names the quantity, shows the value, and says what is expected:
///
/// ```
/// let error = standfast::Point::new(1.0, 0.4, 2.0, -0.5).unwrap_err();
/// assert_eq!(error.to_string(), "friction μ is -0.5; expected a finite number, zero or more");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{quantity} is {value}; expected {expected}")]
pub struct InputError {
    /// The quantity in words and symbol, e.g. `friction μ`.
    pub quantity: &'static str,
    /// The value that was given.
    pub value: f64,
    /// What the quantity has to be.
    pub expected: &'static str,
}

impl InputError {
    /// Passes `value` on if it is finite.
    pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<f64, InputError> {
        let expected = "a finite number";
        if value.is_finite() { Ok(value) } else { Err(InputError { quantity, value, expected }) }
    }

    /// Passes `value` on if it is finite and not below zero.
    pub(crate) fn not_negative(quantity: &'static str, value: f64) -> Result<f64, InputError> {
        let expected = "a finite number, zero or more";
        if value.is_finite() && value >= 0.0 {
            Ok(value)
        } else {
            Err(InputError { quantity, value, expected })
        }
    }

    /// Passes `value` on if it is finite and above zero.
    pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<f64, InputError> {
        let expected = "a finite number above zero";
        if value.is_finite() && value > 0.0 {
            Ok(value)
        } else {
            Err(InputError { quantity, value, expected })
        }
    }
}
