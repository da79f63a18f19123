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

/// Kronrod's rule with 21 points, of which every second is one of Gauss and Legendre's ten: abscissa, weight, and its weight among the
/// ten (R. Piessens, E. de Doncker-Kapenga, C. Überhuber and D. Kahaner, QUADPACK, Springer 1983, QK21); those below zero mirror them.
#[allow(clippy::excessive_precision, reason = "as published")]
const NESTED: [(f64, f64, f64); 11] = [
    (0.995_657_163_025_808_080_735_5, 0.011_694_638_867_371_874_278_06, 0.0),
    (0.973_906_528_517_171_720_077_96, 0.032_558_162_307_964_727_478_82, 0.066_671_344_308_688_137_593_57),
    (0.930_157_491_355_708_226_001_21, 0.054_755_896_574_351_996_031_38, 0.0),
    (0.865_063_366_688_984_510_732_1, 0.075_039_674_810_919_952_767_04, 0.149_451_349_150_580_593_145_86),
    (0.780_817_726_586_416_897_063_72, 0.093_125_454_583_697_605_535_07, 0.0),
    (0.679_409_568_299_024_406_234_33, 0.109_387_158_802_297_641_899_21, 0.219_086_362_515_982_043_995_53),
    (0.562_757_134_668_604_683_339, 0.123_491_976_262_065_851_077_96, 0.0),
    (0.433_395_394_129_247_190_799_27, 0.134_709_217_311_473_325_928_05, 0.269_266_719_309_996_355_091_23),
    (0.294_392_862_701_460_198_131_13, 0.142_775_938_577_060_080_797_09, 0.0),
    (0.148_874_338_981_631_210_884_83, 0.147_739_104_901_338_491_374_84, 0.295_524_224_714_752_870_173_82),
    (0.0, 0.149_445_554_002_916_905_664_94, 0.0),
];

/// The abscissas in the panel from `a` to `b` of two rules, one within the other, with the weights of the one and of the other: their
/// difference tells the error of the coarser, and far more than that of the finer.
pub(crate) fn nested(a: f64, b: f64) -> impl Iterator<Item = (f64, f64, f64)> {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let at = move |sign: f64| {
        move |&(x, fine, coarse): &(f64, f64, f64)| (middle + sign * half * x, half * fine, half * coarse)
    };
    NESTED.iter().map(at(-1.0)).chain(NESTED[..10].iter().rev().map(at(1.0)))
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

    /// The finer rule is exact to degree 31, the coarser, on its ten points, to degree 19, and neither beyond.
    #[test]
    fn rules_within_each_other_are_exact_to_their_degrees() {
        let sums = |n: i32| {
            nested(-1.0, 2.0).fold((0.0, 0.0), |(fine, coarse), (x, of_fine, of_coarse)| {
                (fine + of_fine * x.powi(n), coarse + of_coarse * x.powi(n))
            })
        };
        let exact = |n: i32| (2f64.powi(n + 1) - (-1f64).powi(n + 1)) / f64::from(n + 1);
        for n in 0..=31 {
            let (fine, coarse) = sums(n);
            assert!((fine / exact(n) - 1.0).abs() < 1e-13, "degree {n}: {fine}");
            assert!(n > 19 || (coarse / exact(n) - 1.0).abs() < 1e-13, "degree {n}: {coarse}");
        }
        assert!((sums(20).1 / exact(20) - 1.0).abs() > 1e-9 && (sums(32).0 / exact(32) - 1.0).abs() > 1e-15);
        assert_eq!(nested(-1.0, 2.0).count(), 21);
    }
}
