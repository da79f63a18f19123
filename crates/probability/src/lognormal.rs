//! Fit of the lognormal curve nearest to probabilities at values.
//!
//! ```text
//! P(x) = Φ(ln(x/median)/dispersion)
//! ```
//!
//! For counts, the curve that makes them likeliest: maximum likelihood, as J. W. Baker has it for analyses at several
//! levels of a shaking (Efficient analytical fragility function fitting using dynamic structural analysis, Earthquake
//! Spectra 31, 2015, 579–599, equation 11). A probability that is known is the share of hits in a count without end, and the same sum
//!
//! ```text
//! Σ p ln P(x) + (1 − p) ln(1 − P(x))
//! ```
//!
//! is then largest for the curve of the least Kullback–Leibler divergence from the probabilities. A straight line through Φ⁻¹(p) would
//! weigh 1e-8 as much as a half; here a value counts by what a draw at it could tell, which is little far out. The sum is concave in
//! 1/dispersion and ln(median)/dispersion, so that there is one curve, found by Fisher's scoring.

use crate::normal;

/// A lognormal curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lognormal {
    /// Value of probability one half.
    pub median: f64,
    /// Its logarithmic standard deviation.
    pub dispersion: f64,
}

/// A probability nearer to 0 or 1 than this does not say alone that the curve is above 0 or below 1 there.
const TELLING: f64 = 1e-9;
/// Further out than these deviations a probability is 1e-218, and has no logarithm of what is left to 1.
const REACH: f64 = 30.0;
const MOST_STEPS: usize = 200;

impl Lognormal {
    /// The curve nearest to probabilities at values, each value counting as much as the others. None where they do not rise, or too few
    /// tell: there must be values with a probability above zero below others with one below 1.
    pub fn nearest(points: &[(f64, f64)]) -> Option<Lognormal> {
        let told: Vec<(f64, f64)> =
            points.iter().filter(|(x, p)| *x > 0.0 && !p.is_nan()).map(|(x, p)| (x.ln(), *p)).collect();
        let least = |of: &dyn Fn(f64) -> bool| {
            told.iter().filter(|(_, p)| of(*p)).map(|(x, _)| *x).fold(f64::INFINITY, f64::min)
        };
        let most = |of: &dyn Fn(f64) -> bool| {
            told.iter().filter(|(_, p)| of(*p)).map(|(x, _)| *x).fold(f64::NEG_INFINITY, f64::max)
        };
        let (some, not_all) = (|p: f64| p > TELLING, |p: f64| p < 1.0 - TELLING);
        // Else a step is likelier than any curve: one that rises, or one that falls.
        if least(&some) >= most(&not_all) || least(&not_all) >= most(&some) {
            return None;
        }
        let line = Line::nearest(&told)?;
        let found = Lognormal { median: (-line.at_zero / line.slope).exp(), dispersion: line.slope.recip() };
        (line.slope > 0.0 && found.median.is_finite() && found.median > 0.0 && found.dispersion.is_finite())
            .then_some(found)
    }

    /// P at a value; 0 at what is not above zero.
    pub fn at(&self, x: f64) -> f64 {
        if x > 0.0 { normal::below((x / self.median).ln() / self.dispersion) } else { 0.0 }
    }
}

/// z = at_zero + slope · ln x.
#[derive(Debug, Clone, Copy)]
struct Line {
    at_zero: f64,
    slope: f64,
}

impl Line {
    fn nearest(points: &[(f64, f64)]) -> Option<Line> {
        // About the middle the two numbers hardly hang together.
        let middle = points.iter().map(|(x, _)| x).sum::<f64>() / points.len() as f64;
        let points: Vec<(f64, f64)> = points.iter().map(|(x, p)| (x - middle, *p)).collect();
        // At first through Φ⁻¹(p) itself, which of a lognormal curve is the answer.
        let ends = normal::below(-REACH / 4.0);
        let mut line = scored(&points, |_, p| normal::quantile(p.clamp(ends, 1.0 - 1e-15)))?;
        let mut value = line.likelihood(&points);
        for _ in 0..MOST_STEPS {
            let next = scored(&points, |x, _| line.z(x))?;
            let mut share = 1.0;
            let (step, its_value) = loop {
                let part = |from: f64, to: f64| from + share * (to - from);
                let step =
                    Line { at_zero: part(line.at_zero, next.at_zero), slope: part(line.slope, next.slope) };
                let its_value = step.likelihood(&points);
                // Equal but for rounding is at the top.
                if its_value >= value - 1e-14 * value.abs() {
                    break (step, its_value);
                }
                share *= 0.5;
                if share < 1e-12 {
                    break (line, value);
                }
            };
            let moved = (step.slope - line.slope).abs().max((step.at_zero - line.at_zero).abs());
            (line, value) = (step, its_value);
            if moved <= 1e-13 * (line.slope.abs() + line.at_zero.abs()) {
                break;
            }
        }
        Some(Line { at_zero: line.at_zero - line.slope * middle, slope: line.slope })
    }

    fn z(&self, x: f64) -> f64 {
        (self.at_zero + self.slope * x).clamp(-REACH, REACH)
    }

    fn likelihood(&self, points: &[(f64, f64)]) -> f64 {
        let of = |(x, p): &(f64, f64)| {
            let z = self.z(*x);
            p * normal::below(z).ln() + (1.0 - p) * normal::above(z).ln()
        };
        points.iter().map(of).sum()
    }
}

/// One step of Fisher's scoring: the line through z + (p − Φ)/φ, each weighed by φ²/(Φ(1 − Φ)), what a draw there tells of z.
fn scored(points: &[(f64, f64)], z: impl Fn(f64, f64) -> f64) -> Option<Line> {
    let (mut w0, mut w1, mut w2, mut s0, mut s1) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (x, p) in points {
        let z = z(*x, *p);
        let density = normal::density(z);
        let weight = density / normal::below(z) * (density / normal::above(z));
        // In the nearer tail, of which no digit is lost.
        let missing = if z < 0.0 { p - normal::below(z) } else { normal::above(z) - (1.0 - p) };
        let target = z + missing / density;
        w0 += weight;
        w1 += weight * x;
        w2 += weight * x * x;
        s0 += weight * target;
        s1 += weight * target * x;
    }
    let determinant = w0 * w2 - w1 * w1;
    let line = Line { at_zero: (w2 * s0 - w1 * s1) / determinant, slope: (w0 * s1 - w1 * s0) / determinant };
    (line.at_zero.is_finite() && line.slope.is_finite()).then_some(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn divergence(points: &[(f64, f64)], curve: &Lognormal) -> f64 {
        let of = |p: f64, q: f64| if p == 0.0 { 0.0 } else { p * (p / q).ln() };
        let parts = points.iter().map(|(x, p)| {
            let z = (x / curve.median).ln() / curve.dispersion;
            of(*p, normal::below(z)) + of(1.0 - p, normal::above(z))
        });
        parts.sum()
    }

    /// Of a lognormal curve its own numbers come back, however far its ends lie out.
    #[test]
    fn a_lognormal_curve_is_its_own_nearest() {
        for (median, dispersion, from, to) in [
            (1.0, 0.4, 0.2, 3.0),
            (9.81e5, 0.05, 8e5, 1.4e6),
            (2e-3, 1.5, 1e-6, 1.0),
            (5.0, 0.2, 1.0, 2.5),
            (5.0, 0.2, 7.0, 30.0),
        ] {
            let own = Lognormal { median, dispersion };
            let points: Vec<(f64, f64)> = (0..=10)
                .map(|i| from + (to - from) * f64::from(i) / 10.0)
                .map(|x: f64| (x, normal::below((x / median).ln() / dispersion)))
                .collect();
            let found = Lognormal::nearest(&points).unwrap();
            let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
            assert!(near(found.median, median) && near(found.dispersion, dispersion), "{found:?} {own:?}");
        }
    }

    /// Through two points there is a curve, which is nearest: by hand, z₂ − z₁ = ln(x₂/x₁)/dispersion.
    #[test]
    fn two_probabilities_have_the_curve_through_them() {
        // Φ(−1) and Φ(2), of tables.
        let points = [(2.0, 0.158_655_253_931_457_05), (5.0, 0.977_249_868_051_820_8)];
        let found = Lognormal::nearest(&points).unwrap();
        let dispersion = 2.5f64.ln() / 3.0;
        assert!((found.dispersion / dispersion - 1.0).abs() < 1e-12, "{found:?}");
        assert!((found.median / (2.0 * dispersion.exp()) - 1.0).abs() < 1e-12, "{found:?}");
    }

    /// Counts of collapse of 40 motions each: by SciPy 1.17, `minimize(method="Nelder-Mead", xatol=1e-13, fatol=1e-15)` of −Σ
    /// hits `log_ndtr(z)` + misses `log_ndtr(-z)`, and then `root` of its two derivatives taken by hand.
    #[test]
    fn counts_have_the_likeliest_curve() {
        let levels = [0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9, 1.0];
        let hits = [0.0, 0.0, 0.0, 4.0, 6.0, 13.0, 12.0, 16.0];
        let points: Vec<(f64, f64)> = levels.into_iter().zip(hits.map(|hits| hits / 40.0)).collect();
        let found = Lognormal::nearest(&points).unwrap();
        assert!((found.median - 1.076_115_794_292_68).abs() < 1e-9, "{found:?}");
        assert!((found.dispersion - 0.429_237_203_832_318).abs() < 1e-9, "{found:?}");
    }

    /// No curve beside it is nearer, of probabilities that no lognormal curve has.
    #[test]
    fn no_other_curve_is_nearer() {
        let sets: [&[(f64, f64)]; 3] = [
            &[(1.5, 1e-12), (1.8, 0.02), (2.0, 0.6), (2.2, 0.62), (2.7, 1.0)],
            &[(1.0, 0.0), (2.0, 0.3), (3.0, 0.1), (4.0, 1.0), (5.0, 0.9)],
            &[(0.0, 0.0), (0.1, 1e-20), (0.5, 0.4), (3.0, 0.5)],
        ];
        for points in sets {
            let found = Lognormal::nearest(points).unwrap();
            let counted: Vec<(f64, f64)> = points.iter().copied().filter(|(x, _)| *x > 0.0).collect();
            let least = divergence(&counted, &found);
            for (a, b) in [(1e-4, 0.0), (-1e-4, 0.0), (0.0, 1e-4), (0.0, -1e-4), (1e-4, 1e-4), (1e-4, -1e-4)]
            {
                let other =
                    Lognormal { median: found.median * (1.0 + a), dispersion: found.dispersion * (1.0 + b) };
                assert!(divergence(&counted, &other) > least, "{points:?} {found:?}");
            }
        }
    }

    #[test]
    fn what_tells_nothing_has_no_curve() {
        let sets: [&[(f64, f64)]; 7] = [
            &[],
            &[(1.0, 0.5)],
            &[(1.0, 0.0), (2.0, 0.0)],
            &[(1.0, 1.0), (2.0, 1.0)],
            // A step is likelier than any curve.
            &[(1.0, 0.0), (2.0, 0.3), (3.0, 1.0)],
            &[(1.0, 1e-12), (2.0, 0.3), (3.0, 1.0 - 1e-12)],
            // It falls.
            &[(1.0, 0.7), (2.0, 0.3)],
        ];
        for points in sets {
            assert_eq!(Lognormal::nearest(points), None, "{points:?}");
        }
    }
}
