//! The regularised incomplete gamma functions: what the gamma law is at any point.

use crate::fraction::continued;
use crate::law::Tails;

/// P(a, x) and Q(a, x) = 1 − P of positive a and x ≥ 0; the smaller of the two has all its digits. By the series of
/// [DLMF 8.11.4](https://dlmf.nist.gov/8.11.E4) for x below a + 1, and by the continued fraction of
/// [DLMF 8.9.2](https://dlmf.nist.gov/8.9.E2) above.
pub(crate) fn tails(a: f64, x: f64) -> Tails {
    if x <= 0.0 {
        return Tails { below: 0.0, above: 1.0 };
    }
    if x == f64::INFINITY {
        return Tails { below: 1.0, above: 0.0 };
    }
    let power = (a * x.ln() - x - libm::lgamma(a)).exp();
    if x < a + 1.0 {
        let below = power * series(a, x);
        Tails { below, above: 1.0 - below }
    } else {
        let above = power / fraction(a, x);
        Tails { below: 1.0 - above, above }
    }
}

/// 1/a + x/(a(a + 1)) + x²/(a(a + 1)(a + 2)) + …
fn series(a: f64, x: f64) -> f64 {
    let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
    for _ in 0..1_000_000 {
        n += 1.0;
        term *= x / n;
        sum += term;
        if term <= sum * f64::EPSILON {
            break;
        }
    }
    sum
}

/// x + 1 − a − 1(1 − a)/(x + 3 − a − 2(2 − a)/(x + 5 − a − …)). About √a terms are needed.
fn fraction(a: f64, x: f64) -> f64 {
    continued(x + 1.0 - a, |n| {
        let n = f64::from(n);
        (n * (a - n), x + 1.0 - a + 2.0 * n)
    })
}

#[cfg(test)]
mod tests {
    use super::{Tails, tails};
    use crate::beta::tests::close;
    use crate::points::Stream;

    /// Q(n, x) is e⁻ˣ(1 + x + … + xⁿ⁻¹/(n − 1)!) of whole n, and Q(½, x) = erfc √x; P is the small one near zero.
    #[test]
    fn in_closed_form() {
        for x in [1e-9, 1e-3, 0.4, 1.0, 2.5, 7.0, 40.0, 300.0] {
            let (mut term, mut sum) = (1.0, 0.0);
            for n in 1..=12 {
                sum += term;
                term *= x / f64::from(n);
                let what = format!("{n}, {x}");
                let Tails { below, above } = tails(f64::from(n), x);
                close(above, (-x).exp() * sum, 1e-12, &what);
                assert!((below + above - 1.0).abs() <= 1e-14, "{what}");
                if x < 0.01 {
                    let leading = (f64::from(n) * x.ln() - libm::lgamma(f64::from(n + 1))).exp();
                    close(below, leading, 1.1 * x, &what);
                }
            }
            close(tails(0.5, x).above, libm::erfc(x.sqrt()), 1e-12, &format!("half, {x}"));
            close(tails(0.5, x).below, libm::erf(x.sqrt()), 1e-12, &format!("half, {x}"));
        }
        assert_eq!(tails(2.0, 0.0), Tails { below: 0.0, above: 1.0 });
        assert_eq!(tails(2.0, f64::INFINITY), Tails { below: 1.0, above: 0.0 });
    }

    /// The same as statrs has.
    #[test]
    fn as_another_library_has_it() {
        let mut stream = Stream::new(1, 0);
        for _ in 0..3000 {
            let a = (10.0 * stream.draw() - 3.0).exp();
            let x = a * (4.0 * stream.draw() - 2.0).exp();
            let found = tails(a, x);
            let what = format!("{a}, {x}");
            close(found.below.max(1e-250), statrs::function::gamma::gamma_lr(a, x).max(1e-250), 1e-9, &what);
            close(found.above.max(1e-250), statrs::function::gamma::gamma_ur(a, x).max(1e-250), 1e-9, &what);
        }
    }
}
