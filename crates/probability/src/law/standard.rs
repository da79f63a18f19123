//! Values of laws that have no closed form for them: the normal that belongs to a value rises with it, and is met by iteration.

use super::Tails;
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

/// Where a function that rises from `low` to `high` passes zero: the largest number at which it is not above, to two units in the last place;
/// where it jumps, exactly. By Chandrupatla's choice between inverse quadratic interpolation and bisection (Advances in Engineering
/// Software 28, 1997).
pub(super) fn where_met(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    if low >= high {
        return low;
    }
    let (mut a, mut b) = (high, low);
    let (mut fa, mut fb) = (f(a), f(b));
    if fa <= 0.0 {
        return high;
    }
    if fb > 0.0 {
        return low;
    }
    let mut t = 0.5;
    // 64 halvings of a distance reach the last bit; as many again for steps that are less.
    for _ in 0..200 {
        let x = a + t * (b - a);
        let x = x.clamp(a.min(b), a.max(b));
        let fx = f(x);
        let (c, fc) = if (fx > 0.0) == (fa > 0.0) { (a, fa) } else { (b, fb) };
        if (fx > 0.0) != (fa > 0.0) {
            (b, fb) = (a, fa);
        }
        (a, fa) = (x, fx);
        let (below, above) = if fa > 0.0 { (b, a) } else { (a, b) };
        if fa == 0.0 || below.next_up() >= above {
            return below;
        }
        let width = (b - a).abs();
        let least = (above.abs().max(below.abs()) * f64::EPSILON).max(f64::MIN_POSITIVE) / width;
        let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
        let is_smooth = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        let inverse = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
        t = if is_smooth && inverse.is_finite() {
            inverse.clamp(least.min(0.5), 1.0 - least.min(0.5))
        } else {
            0.5
        };
    }
    if fa > 0.0 { b } else { a }
}
