//! The first root of a polynomial on an interval, by its Bernstein coefficients.
//!
//! A polynomial whose Bernstein coefficients on an interval have one sign has no root there, and as many changes of sign bound
//! the number of roots (Descartes). So halves are looked at from the left until one is known to be free of roots, or to have one.

use crate::series::LEN;

/// C(i, k)/C(n, k) for every i, k ≤ n < LEN: what makes Bernstein coefficients of those of powers.
static TO_BERNSTEIN: [[[f64; LEN]; LEN]; LEN] = to_bernstein();

const fn to_bernstein() -> [[[f64; LEN]; LEN]; LEN] {
    let mut binomial = [[0.0_f64; LEN]; LEN];
    let mut n = 0;
    while n < LEN {
        binomial[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            binomial[n][k] = binomial[n - 1][k - 1] + if k < n { binomial[n - 1][k] } else { 0.0 };
            k += 1;
        }
        n += 1;
    }
    let mut table = [[[0.0; LEN]; LEN]; LEN];
    let mut n = 0;
    while n < LEN {
        let mut i = 0;
        while i <= n {
            let mut k = 0;
            while k <= i {
                table[n][i][k] = binomial[i][k] / binomial[n][k];
                k += 1;
            }
            i += 1;
        }
        n += 1;
    }
    table
}

/// The value of a polynomial, lowest power first.
#[inline]
pub(crate) fn value(powers: &[f64], τ: f64) -> f64 {
    powers.iter().rev().fold(0.0, |sum, a| sum * τ + a)
}

/// The first τ of (0, h] at which a polynomial that is positive just after 0 is no longer positive.
///
/// If its value at 0 is not positive, the root is at 0.
#[inline]
pub(crate) fn first_root(powers: &[f64], h: f64) -> Option<f64> {
    let (first, rest) = powers.split_first()?;
    let (mut power, mut least) = (1.0, *first);
    for a in rest {
        power *= h;
        least += (a * power).min(0.0);
    }
    if least > 0.0 { None } else { search(powers, h) }
}

/// Searches for the first root, where the cheap bound could not tell.
#[cold]
fn search(powers: &[f64], h: f64) -> Option<f64> {
    let last = powers.iter().rposition(|a| *a != 0.0)?;
    let powers = &powers[..=last];
    let mut scaled = [0.0; LEN];
    let mut power = 1.0;
    for (scaled, a) in scaled.iter_mut().zip(powers) {
        *scaled = a * power;
        power *= h;
    }
    let mut bernstein = [0.0; LEN];
    for (i, b) in bernstein.iter_mut().enumerate().take(last + 1) {
        *b = (0..=i).map(|k| TO_BERNSTEIN[last][i][k] * scaled[k]).sum();
    }
    let found = isolate(&scaled[..=last], &bernstein[..=last], 0.0, 1.0, 0)?;
    Some(found * h)
}

fn isolate(powers: &[f64], bernstein: &[f64], from: f64, to: f64, depth: u32) -> Option<f64> {
    let last = bernstein.len() - 1;
    if bernstein[0] <= 0.0 {
        return Some(from);
    }
    if bernstein.iter().all(|b| *b > 0.0) {
        return None;
    }
    let changes = bernstein.windows(2).filter(|pair| (pair[0] > 0.0) != (pair[1] > 0.0)).count();
    if changes == 1 && bernstein[last] <= 0.0 {
        return Some(refine(powers, from, to));
    }
    if depth == 50 {
        return (bernstein[last] <= 0.0).then_some(to);
    }
    let (mut left, mut right) = ([0.0; LEN], [0.0; LEN]);
    right[..=last].copy_from_slice(bernstein);
    for level in 0..=last {
        left[level] = right[0];
        for i in 0..last - level {
            right[i] = 0.5 * (right[i] + right[i + 1]);
        }
    }
    // Coefficients left in `right` are the right half's, in their order.
    let middle = 0.5 * (from + to);
    isolate(powers, &left[..=last], from, middle, depth + 1)
        .or_else(|| isolate(powers, &right[..=last], middle, to, depth + 1))
}

/// The one root between two values of opposite signs: Newton's steps, halving where they leave the bracket, until the value is rounding.
fn refine(powers: &[f64], from: f64, to: f64) -> f64 {
    let (mut low, mut high) = (from, to);
    let mut at = 0.5 * (low + high);
    for _ in 0..100 {
        let (mut f, mut slope, mut size) = (0.0, 0.0, 0.0);
        for a in powers.iter().rev() {
            slope = slope * at + f;
            f = f * at + a;
            size = size * at + a.abs();
        }
        if f > 0.0 {
            low = at
        } else {
            high = at
        }
        let newton = at - f / slope;
        if f.abs() <= f64::EPSILON * size && newton >= low && newton <= high {
            return newton;
        }
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - at).abs() <= 2.0 * f64::EPSILON * at || high - low <= 2.0 * f64::EPSILON * high {
            return next;
        }
        at = next;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Polynomials made of their roots: the first inside the interval is found, whatever lies beside it.
    #[test]
    fn finds_the_first_root() {
        let product = |roots: &[f64]| {
            let mut powers = vec![1.0];
            for root in roots {
                let mut next = vec![0.0; powers.len() + 1];
                for (k, a) in powers.iter().enumerate() {
                    next[k] += a * root;
                    next[k + 1] -= a;
                }
                powers = next;
            }
            powers
        };
        for (roots, h, expected) in [
            (vec![0.3], 1.0, Some(0.3)),
            (vec![0.3], 0.2, None),
            (vec![0.3, 0.31, 0.9], 2.0, Some(0.3)),
            (vec![1.5, 1.500001, 7.0, 11.0, 3.0], 4.0, Some(1.5)),
            (vec![5.0, 6.0, 7.0, 8.0], 4.0, None),
            (vec![1e-9, 1.0], 3.0, Some(1e-9)),
            (vec![-1.0, -2.0, 0.125], 0.125, Some(0.125)),
        ] {
            let found = first_root(&product(&roots), h);
            match (found, expected) {
                (Some(found), Some(expected)) => {
                    assert!((found / expected - 1.0).abs() < 1e-9, "{roots:?} {found}")
                }
                (found, expected) => assert_eq!(found, expected, "{roots:?}"),
            }
        }
        // A parabola that nearly touches, and one that dips by a hair.
        assert_eq!(first_root(&[0.25 + 1e-12, -1.0, 1.0], 1.0), None);
        let dip = first_root(&[0.25 - 1e-10, -1.0, 1.0], 1.0).expect("two roots near 1/2");
        assert!((dip - (0.5 - 1e-5)).abs() < 1e-9, "{dip}");
        assert_eq!(first_root(&[0.0; 5], 1.0), None);
    }

    /// Every root of a random product is met in turn when the search starts again behind it.
    #[test]
    fn value_is_horner() {
        assert_eq!(value(&[1.0, 2.0, 3.0], 2.0), 17.0);
    }
}
