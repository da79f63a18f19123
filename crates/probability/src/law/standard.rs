//! Values of laws that have no closed form for them: the normal that belongs to a value rises with it, and is met by iteration.

use super::Tails;
use crate::roots::where_met;
use crate::{beta, gamma};

/// The value of the gamma law of scale 1 with these probabilities below and above it.
pub(super) fn gamma_value(shape: f64, at: Tails) -> f64 {
    positive_value(f64::MAX, at, |x| gamma::tails(shape, x))
}

/// The value of the beta law between 0 and 1 with these probabilities below and above it, and what it lacks to 1.
pub(super) fn beta_value(a: f64, b: f64, at: Tails) -> (f64, f64) {
    if at.below <= at.above {
        let x = positive_value(1.0, at, |x| beta::tails(a, b, x, 1.0 - x));
        (x, 1.0 - x)
    } else {
        let turned = Tails { below: at.above, above: at.below };
        let y = positive_value(1.0, turned, |y| beta::tails(b, a, y, 1.0 - y));
        (1.0 - y, y)
    }
}

/// The value between 0 and `most` of a law with these tails: first its order of magnitude, as values may be as small as numbers are.
fn positive_value(most: f64, at: Tails, tails: impl Fn(f64) -> Tails) -> f64 {
    if at.below <= 0.0 {
        return 0.0;
    }
    if at.above <= 0.0 {
        return most;
    }
    let z = at.z();
    let beyond = |x: f64| tails(x).z() - z;
    let middle = |low: f64, high: f64| f64::from_bits(low.to_bits().midpoint(high.to_bits()));
    // Most laws have their values about 1.
    let (mut low, mut high) = (0.0, most);
    for start in [1e-3, 1e3] {
        if start < most {
            if beyond(start) <= 0.0 { low = start } else { high = high.min(start) }
        }
    }
    while high > 2.0 * low {
        let x = middle(low, high);
        if x == low || x == high {
            return low;
        }
        if beyond(x) <= 0.0 { low = x } else { high = x }
    }
    where_met(low, high, beyond)
}
