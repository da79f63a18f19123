//! Continued fractions.

/// The continued fraction b₀ + a₁/(b₁ + a₂/(b₂ + …)), forwards by Lentz's method; `terms` gives aₙ and bₙ.
pub(crate) fn continued(first: f64, terms: impl Fn(i32) -> (f64, f64)) -> f64 {
    let away_from_zero = |x: f64| if x.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { x };
    let (mut value, mut upper, mut lower) = (first, first, 0.0);
    for term in 1..1_000_000 {
        let (a, b) = terms(term);
        lower = 1.0 / away_from_zero(b + a * lower);
        upper = away_from_zero(b + a / upper);
        value *= upper * lower;
        if (upper * lower - 1.0).abs() <= f64::EPSILON {
            break;
        }
    }
    value
}
