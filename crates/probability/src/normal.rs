//! The standard normal law, as accurate far out in either tail as it is in the middle.
//!
//! Φ by the complementary error function; Φ⁻¹ by Wichura's AS 241 (Applied Statistics 37, 1988, 477–484), good to 1e-16
//! relative. A probability near 1 is not a number to keep: what lies above is. So everything here has a lower and an upper form.

use std::f64::consts::FRAC_1_SQRT_2;

/// Φ(z): the probability below `z`.
pub fn below(z: f64) -> f64 {
    0.5 * libm::erfc(-z * FRAC_1_SQRT_2)
}

/// 1 − Φ(z): the probability above `z`, without cancellation.
pub fn above(z: f64) -> f64 {
    below(-z)
}

/// The probability between `from` and `to`, as a difference in the nearer tail; 0 if `to` is not above `from`.
pub fn between(from: f64, to: f64) -> f64 {
    if to <= from {
        0.0
    } else if from > 0.0 {
        above(from) - above(to)
    } else {
        below(to) - below(from)
    }
}

/// The density exp(−z²/2)/√(2π).
pub fn density(z: f64) -> f64 {
    const ROOT: f64 = 0.398_942_280_401_432_7;
    ROOT * (-0.5 * z * z).exp()
}

/// Φ⁻¹(p): the value with probability `p` below it; ∓∞ at 0 and 1.
pub fn quantile(p: f64) -> f64 {
    let q = p - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.180625 - q * q;
        return q * rational(&CENTRE, r);
    }
    if q < 0.0 { -tail(p) } else { tail(1.0 - p) }
}

/// Φ⁻¹ of each, to the same bits, in place: those in the middle at once, and then the others.
pub fn quantiles(chances: &mut [f64]) {
    const RUN: usize = 64;
    for run in chances.chunks_mut(RUN) {
        let (mut outside, mut count) = ([0; RUN], 0);
        for (i, p) in run.iter().enumerate() {
            outside[count] = i;
            count += usize::from((p - 0.5).abs() > 0.425);
        }
        let outside = &outside[..count];
        let mut tails = [0.0; RUN];
        for (tail, &i) in tails.iter_mut().zip(outside) {
            *tail = quantile(run[i]);
        }
        for p in run.iter_mut() {
            let q = *p - 0.5;
            *p = q * rational(&CENTRE, 0.180625 - q * q);
        }
        for (tail, &i) in tails.iter().zip(outside) {
            run[i] = *tail;
        }
    }
}

/// The value with probability `p` above it: −Φ⁻¹(p), of which no digit is lost for a small `p`.
pub fn quantile_above(p: f64) -> f64 {
    -quantile(p)
}

/// The value with probability `p` < 0.075 above it.
fn tail(p: f64) -> f64 {
    if p <= 0.0 {
        return f64::INFINITY;
    }
    let r = (-p.ln()).sqrt();
    if r <= 5.0 { rational(&MIDDLE, r - 1.6) } else { rational(&FAR, r - 5.0) }
}

fn rational([above, below]: &[[f64; 8]; 2], r: f64) -> f64 {
    let polynomial = |c: &[f64; 8]| c.iter().rev().fold(0.0, |sum, c| sum * r + c);
    polynomial(above) / polynomial(below)
}

#[allow(clippy::excessive_precision, reason = "as published")]
const CENTRE: [[f64; 8]; 2] = [
    [
        3.387_132_872_796_366_608,
        133.141_667_891_784_377_45,
        1_971.590_950_306_551_442_7,
        13_731.693_765_509_461_125,
        45_921.953_931_549_871_457,
        67_265.770_927_008_700_853,
        33_430.575_583_588_128_105,
        2_509.080_928_730_122_672_7,
    ],
    [
        1.0,
        42.313_330_701_600_911_252,
        687.187_007_492_057_908_3,
        5_394.196_021_424_751_107_7,
        21_213.794_301_586_595_867,
        39_307.895_800_092_710_61,
        28_729.085_735_721_942_674,
        5_226.495_278_852_854_561,
    ],
];

#[allow(clippy::excessive_precision, reason = "as published")]
const MIDDLE: [[f64; 8]; 2] = [
    [
        1.423_437_110_749_683_577_34,
        4.630_337_846_156_545_295_9,
        5.769_497_221_460_691_405_5,
        3.647_848_324_763_204_605_04,
        1.270_458_252_452_368_382_58,
        0.241_780_725_177_450_611_77,
        0.022_723_844_989_269_184_583_3,
        0.000_774_545_014_278_341_407_64,
    ],
    [
        1.0,
        2.053_191_626_637_758_821_87,
        1.676_384_830_183_803_849_4,
        0.689_767_334_985_100_004_55,
        0.148_103_976_427_480_074_59,
        0.015_198_666_563_616_457_196_6,
        0.000_547_593_808_499_534_494_6,
        1.050_750_071_644_416_843_24e-9,
    ],
];

#[allow(clippy::excessive_precision, reason = "as published")]
const FAR: [[f64; 8]; 2] = [
    [
        6.657_904_643_501_103_777_2,
        5.463_784_911_164_114_369_9,
        1.784_826_539_917_291_335_8,
        0.296_560_571_828_504_891_23,
        0.026_532_189_526_576_123_093,
        0.001_242_660_947_388_078_438_6,
        0.000_027_115_555_687_434_875_781_5,
        2.010_334_399_292_288_132_65e-7,
    ],
    [
        1.0,
        0.599_832_206_555_887_937_69,
        0.136_929_880_922_735_805_31,
        0.014_875_361_290_850_614_852_5,
        0.000_786_869_131_145_613_259_1,
        0.000_018_463_183_175_100_546_818,
        1.421_511_758_316_445_888_7e-7,
        2.044_263_103_389_939_785_64e-15,
    ],
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Φ⁻¹ undoes Φ, in both tails, to the accuracy that the argument allows.
    #[test]
    fn quantile_undoes_the_probability() {
        for i in -3600..=3600 {
            let z = f64::from(i) / 100.0;
            let back = if z < 0.0 { quantile(below(z)) } else { quantile_above(above(z)) };
            assert!((back - z).abs() <= 4e-15 * z.abs().max(1e-2), "{z}: {back}");
        }
    }

    /// Many at once are what each is alone, to the last bit, in either tail and at their seams.
    #[test]
    fn many_quantiles_are_each_its_own() {
        let mut chances: Vec<f64> = (1..1000).map(|i| f64::from(i) / 1000.0).collect();
        chances.extend([1e-300, 1e-17, 0.075, 0.925, 1.0 - 1e-16, 0.5, 0.0, 1.0]);
        let alone: Vec<f64> = chances.iter().map(|p| quantile(*p)).collect();
        quantiles(&mut chances);
        assert_eq!(chances, alone);
    }

    /// Values of Φ(−z) to 17 digits by rational continued fractions (Abramowitz and Stegun, table 26.2 and beyond).
    #[test]
    fn the_tail_is_that_of_the_tables() {
        for (z, q) in [
            (1.0, 0.158_655_253_931_457_05),
            (5.0, 2.866_515_718_791_939e-7),
            (10.0, 7.619_853_024_160_527e-24),
        ] {
            assert!((above(z) / q - 1.0).abs() < 5e-14, "{z}");
            assert!((quantile_above(q) / z - 1.0).abs() < 1e-15, "{z}");
        }
    }

    /// The density is the slope of Φ; the probability between two values is its integral.
    #[test]
    fn density_and_differences_agree() {
        for z in [-9.0, -3.0, -0.5, 0.0, 1.0, 4.0, 9.0] {
            let h = 1e-4;
            let mean = (density(z - h) + 4.0 * density(z) + density(z + h)) / 6.0;
            assert!((between(z - h, z + h) / (2.0 * h * mean) - 1.0).abs() < 1e-9, "{z}");
        }
        assert_eq!(between(f64::NEG_INFINITY, f64::INFINITY), 1.0);
        assert_eq!(between(1.0, 1.0), 0.0);
        assert_eq!(between(2.0, 1.0), 0.0);
    }
}
