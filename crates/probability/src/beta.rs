//! The regularised incomplete beta function: what the beta, the binomial and Student's law are at any point.

use crate::fraction::continued;
use crate::law::Tails;

/// I_x(a, b) of positive a and b, by the continued fraction of [DLMF 8.17.22](https://dlmf.nist.gov/8.17.E22), which converges fast for x
/// below (a + 1)/(a + b + 2); above by I_x(a, b) = 1 − I_{1−x}(b, a).
pub(crate) fn beta_reg(a: f64, b: f64, x: f64) -> f64 {
    tails(a, b, x, 1.0 - x).below
}

/// I_x(a, b), and 1 − I_x(a, b), where y = 1 − x; the smaller of the two has all its digits.
pub(crate) fn tails(a: f64, b: f64, x: f64, y: f64) -> Tails {
    if x <= 0.0 || y <= 0.0 {
        let below = f64::from(u8::from(x > 0.0));
        Tails { below, above: 1.0 - below }
    } else if x < (a + 1.0) / (a + b + 2.0) {
        let below = lower(a, b, x, y);
        Tails { below, above: 1.0 - below }
    } else {
        let above = lower(b, a, y, x);
        Tails { below: 1.0 - above, above }
    }
}

/// I_x(a, b), where y = 1 − x.
fn lower(a: f64, b: f64, x: f64, y: f64) -> f64 {
    let power = libm::lgamma(a + b) - libm::lgamma(a) - libm::lgamma(b) + a * x.ln() + b * y.ln();
    power.exp() / (a * fraction(a, b, x))
}

/// 1 + d₁/(1 + d₂/(1 + …)). About √max(a, b) terms are needed.
fn fraction(a: f64, b: f64, x: f64) -> f64 {
    continued(1.0, |term| {
        let m = f64::from(term / 2);
        let d = if term % 2 == 0 {
            m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
        } else {
            -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0))
        };
        (d, 1.0)
    })
}

#[cfg(test)]
pub(crate) mod tests {
    use super::beta_reg;
    use crate::points::Stream;

    /// Asserts that two numbers agree to a share.
    pub(crate) fn close(found: f64, expected: f64, share: f64, what: &str) {
        assert!((found - expected).abs() <= share * expected.abs(), "{what}: {found}, not {expected}");
    }

    /// I_x(1, b) = 1 − (1 − x)ᵇ and I_x(a, 1) = xᵃ; the arc sine for two halves; and the ends.
    #[test]
    fn in_closed_form() {
        for x in [1e-12, 1e-3, 0.2, 0.5, 0.9, 1.0 - 1e-6] {
            for n in [0.5, 1.0, 3.0, 40.0, 1e6] {
                close(beta_reg(1.0, n, x), -libm::expm1(n * libm::log1p(-x)), 1e-9, &format!("1, {n}, {x}"));
                close(beta_reg(n, 1.0, x), x.powf(n), 1e-9, &format!("{n}, 1, {x}"));
            }
            let arc = 2.0 / std::f64::consts::PI * x.sqrt().asin();
            close(beta_reg(0.5, 0.5, x), arc, 1e-12, &format!("halves, {x}"));
        }
        assert_eq!([0.0, 1.0].map(|x| beta_reg(2.0, 3.0, x)), [0.0, 1.0]);
    }

    /// The same as statrs has, where that is converged; its fraction ends after 140 terms.
    #[test]
    fn as_another_library_has_it() {
        let mut stream = Stream::new(1, 0);
        for _ in 0..3000 {
            let [a, b, x] = [stream.draw(), stream.draw(), stream.draw()];
            let [a, b] = [a, b].map(|u| (12.0 * u - 4.0).exp());
            let expected = statrs::function::beta::beta_reg(a, b, x);
            let what = format!("{a}, {b}, {x}");
            assert!((beta_reg(a, b, x) - expected).abs() <= 1e-10, "{what}: {}", beta_reg(a, b, x));
            close(beta_reg(a, b, x).max(1e-250), expected.max(1e-250), 1e-7, &what);
        }
    }

    /// As many hits as there may be points, where terms are many: half of a law that is even lies below its middle, and its limit is normal.
    #[test]
    fn of_many_points() {
        let n = 4e6;
        close(beta_reg(n, n, 0.5), 0.5, 1e-7, "the middle");
        let deviation = (1.0 / (8.0 * n)).sqrt();
        close(beta_reg(n, n, 0.5 - deviation), crate::normal::below(-1.0), 1e-6, "one deviation below");
    }
}
