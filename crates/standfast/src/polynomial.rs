//! Polynomials by their coefficients, the constant first.

use crate::exact::Real;

/// The value at x.
pub(crate) fn value<T: Real>(f: &[T], x: &T) -> T {
    f.iter().rev().fold(T::of(0.0), |sum, coefficient| sum * x.clone() + coefficient.clone())
}

/// The product of two.
pub(crate) fn product<T: Real>(f: &[T], g: &[T]) -> Vec<T> {
    let mut all = vec![T::of(0.0); (f.len() + g.len()).saturating_sub(1)];
    for (i, a) in f.iter().enumerate() {
        for (j, b) in g.iter().enumerate() {
            all[i + j] = all[i + j].clone() + a.clone() * b.clone();
        }
    }
    all
}

/// The roots of one of the second degree; what is not a number is for the caller to drop.
pub(crate) fn quadratic_roots([c, b, a]: [f64; 3]) -> [f64; 2] {
    let root = (b * b - 4.0 * a * c).sqrt();
    // Without cancellation.
    let half = -(b + root.copysign(b)) / 2.0;
    [half / a, c / half]
}
