//! Gauss and Legendre's rule.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// The points of the rule in one panel.
pub(crate) const POINTS: usize = 16;

/// The abscissas of the rule on (−1, 1) and their weights.
static RULE: LazyLock<[(f64, f64); POINTS]> = LazyLock::new(|| std::array::from_fn(point));

/// The abscissa with number `i` and its weight, by Newton's steps on the Legendre polynomial.
fn point(i: usize) -> (f64, f64) {
    let n = POINTS as f64;
    let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
    let mut slope = 1.0;
    for _ in 0..8 {
        let (mut last, mut value) = (1.0, x);
        for k in 2..=POINTS {
            let k = k as f64;
            (last, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * last) / k);
        }
        slope = n * (x * value - last) / (x * x - 1.0);
        x -= value / slope;
    }
    (-x, 2.0 / ((1.0 - x * x) * slope * slope))
}

/// The abscissas of the rule in the panel from `a` to `b`, with their weights.
pub fn panel(a: f64, b: f64) -> impl Iterator<Item = (f64, f64)> {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    RULE.iter().map(move |&(x, weight)| (middle + half * x, half * weight))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rule is exact for polynomials of degree 31: ∫₋₁² xⁿ dx = (2ⁿ⁺¹ − (−1)ⁿ⁺¹)/(n+1).
    #[test]
    fn polynomials_are_integrated_exactly() {
        for n in 0..2 * POINTS as i32 {
            let sum: f64 = panel(-1.0, 2.0).map(|(x, weight)| weight * x.powi(n)).sum();
            let exact = (2f64.powi(n + 1) - (-1f64).powi(n + 1)) / f64::from(n + 1);
            assert!((sum / exact - 1.0).abs() < 1e-13, "degree {n}: {sum} {exact}");
        }
        let beyond: f64 = panel(-1.0, 1.0).map(|(x, weight)| weight * x.powi(32)).sum();
        assert!((beyond * 33.0 / 2.0 - 1.0).abs() > 1e-12);
    }
}
