//! The mode of the library against the report's formulas in rational arithmetic: no disagreement is allowed.
//!
//! The oracle is written from the text of chapters III and IV, with its quotients, in arithmetic that never rounds.
//! It shares neither formulas nor arithmetic with the library.

mod common;

use common::{Boundary, Random, tries};
use dashu_ratio::Relaxed as Rational;
use standfast::batch::{self, BatchError, Columns, InstructionSet};
use standfast::{Mode, Modes, Point};

fn rational(x: f64) -> Rational {
    Rational::try_from(x).unwrap()
}

/// The reported mode and the other consistent modes.
fn oracle([gamma, k_prime, k, mu]: [f64; 4]) -> (Mode, Modes) {
    let [γ, h, k, μ] = [gamma, k_prime, k, mu].map(rational);
    let [zero, one, three, four] = [0.0, 1.0, 3.0, 4.0].map(rational);
    let inverse = &one / &γ;
    let γ2 = &γ * &γ;
    let a = &four + &γ2 - &three * &γ2 * &h;
    let b = &three * &γ;
    let c = &three * &γ * (&one + &h);
    let d = &one + &four * &γ2;
    let upper = &inverse - &k * &h;
    let lower = zero.clone() - &inverse - &k * &h;

    if h < -one.clone() {
        let k_a = zero.clone() - &inverse / (&one + &h);
        let mode = if μ >= k && k <= k_a {
            Mode::Rest
        } else if μ < k && μ >= lower {
            Mode::SlideLeft
        } else if μ >= (&a * &k - &b) / (&d - &c * &k) {
            Mode::RockOPrime
        } else {
            Mode::SlideRockOPrimeLeft
        };
        return (mode, Modes::NONE);
    }

    let right_of_a = &k * (&one + &h) > inverse;
    let mu_star = (&a * &k + &b) / (&c * &k + &d);
    let size = if mu_star < zero { zero.clone() - &mu_star } else { mu_star.clone() };
    let mode = if μ >= k && !right_of_a {
        Mode::Rest
    } else if μ < lower {
        Mode::SlideRockOPrimeLeft
    } else if μ < k && μ <= upper {
        Mode::SlideLeft
    } else if μ >= size {
        Mode::RockO
    } else if mu_star > zero {
        Mode::SlideRockOLeft
    } else {
        Mode::SlideRockORight
    };

    // N = {k > k_A, k ≥ k_B', μ* ≤ μ ≤ 1/γ + kq}, for −1 < k' < 0.
    let mut others = Modes::NONE;
    if h > -one.clone() && h < zero && right_of_a {
        let q = zero.clone() - &h;
        let k_b = (&one + &γ2) / (&three * &γ * &q);
        if k >= k_b && mu_star <= μ && μ <= upper {
            others.insert(Mode::RockO);
            if mu_star < μ && μ < upper {
                others.insert(Mode::SlideRockOLeft);
            }
        }
    }
    (mode, others)
}

fn check(point: [f64; 4]) {
    let [gamma, k_prime, k, mu] = point;
    let ours = Point::new(gamma, k_prime, k, mu).unwrap();
    assert_eq!((ours.mode(), ours.others()), oracle(point), "γ, k', k, μ = {point:?}");
}

#[test]
fn a_million_random_points_agree_with_rational_arithmetic() {
    std::thread::scope(|scope| {
        for seed in 0..4 {
            scope.spawn(move || {
                let mut random = Random(seed);
                (0..tries(250_000)).for_each(|_| check(random.point()));
            });
        }
    });
}

#[test]
fn points_within_three_ulps_of_every_boundary_agree_with_rational_arithmetic() {
    std::thread::scope(|scope| {
        for half in Boundary::ALL.chunks(8) {
            scope.spawn(move || {
                for &boundary in half {
                    let mut random = Random(boundary as u64);
                    (0..tries(100_000)).for_each(|_| check(boundary.point(&mut random)));
                }
            });
        }
    });
}

/// Numbers up to the limits of the input, where products underflow and terms differ by a hundred decades, and such
/// numbers on boundaries.
#[test]
fn extreme_magnitudes_agree_with_rational_arithmetic() {
    let mut random = Random(7);
    for _ in 0..tries(20_000) {
        let [gamma, k_prime, k, mu] = [
            random.log(1e-50, 1e50),
            random.log(1e-300, 1e50),
            random.log(1e-300, 1e50),
            random.log(1e-300, 1e50),
        ];
        let k_prime = k_prime * random.pick(&[-1.0, 1.0]);
        check([gamma, k_prime, k, mu]);
        let chart = standfast::initiation::Chart::new(gamma, k_prime).unwrap();
        let curves = [chart.upper_line(), chart.lower_line(), chart.mu_star(), chart.mu_star_rising()];
        let on_curve = random.pick(&curves).at(k);
        for mu in [on_curve, k, chart.k_a()].map(|mu| random.nudge(mu)) {
            if (0.0..1e50).contains(&mu) {
                check([gamma, k_prime, k, mu]);
                check([gamma, k_prime, mu, mu]);
            }
        }
    }
    for corner in [5e-324, f64::MIN_POSITIVE, 1e-60, 1e50] {
        for k_prime in [corner, -corner, 0.0, -0.0, -1.0] {
            check([1.0, k_prime, corner, corner]);
            check([1e-50, k_prime, corner, corner]);
            check([1e50, k_prime, corner, corner]);
            check([1.0, k_prime, 0.0, -0.0]);
        }
    }
}

/// Through any point of the plane each boundary passes at some elevation of the force, for a body of any slenderness: where the
/// terms of a sign are large beside its scale's other parts, a bound without one of these would take a wrong sign for sure.
#[test]
fn boundaries_moved_through_any_point_agree_with_rational_arithmetic() {
    let mut random = Random(8);
    for _ in 0..tries(40_000).max(2_000) {
        let [γ, k] = [random.log(1e-5, 1e5), random.log(1e-9, 1e3)];
        let μ = k * random.pick(&[0.0, 1e-6, 0.3, 1.0, 3.0]);
        let inertia = 4.0 * (1.0 + γ * γ);
        // γ k (1 + k') of `tip`, `turn`, `toe`, `slip_left` and `slip_right` at zero.
        let turn = 1.0 + γ * (k - μ);
        let slips = [inertia * (k - μ) / (3.0 * (μ + γ)), inertia * (k + μ) / (3.0 * (γ - μ))];
        for u in [1.0, turn, turn - 2.0, 1.0 + slips[0], 1.0 + slips[1]] {
            let k_prime = u / (γ * k) - 1.0;
            if k_prime.abs() < 1e50 {
                check([γ, random.nudge(k_prime), k, μ]);
            }
        }
    }
}

/// The four columns of points.
fn columns_of(points: &[[f64; 4]]) -> [Vec<f64>; 4] {
    [0, 1, 2, 3].map(|i| points.iter().map(|point| point[i]).collect())
}

fn lent(columns: &[Vec<f64>; 4]) -> Columns<'_> {
    let [gamma, k_prime, k, mu] = columns;
    Columns { gamma, k_prime, k, mu }
}

/// Codes that the single call gives of points.
fn one_by_one(points: &[[f64; 4]]) -> Vec<u8> {
    points.iter().map(|&[g, h, k, m]| standfast::classify(g, h, k, m).unwrap().code()).collect()
}

/// A point that is as far from a boundary as f32 or f64 can just tell, or just not.
fn near_a_boundary(random: &mut Random) -> [f64; 4] {
    let mut point = random.pick(&Boundary::ALL).point(random);
    let distance = 2f64.powi(-14 - (random.bits() % 36) as i32);
    point[2 + random.bits() as usize % 2] *= 1.0 + distance * random.uniform(-1.0, 1.0);
    point
}

/// Every compiled kernel says what the single call says, or that it is not sure, all of them alike; and it is rarely not sure.
#[test]
fn kernels_of_all_instruction_sets_agree_with_the_single_call() {
    let mut random = Random(11);
    let mut points: Vec<[f64; 4]> = (0..tries(100_000)).map(|_| random.point()).collect();
    let ordinary = points.len();
    for boundary in Boundary::ALL {
        points.extend((0..tries(2_000)).map(|_| boundary.point(&mut random)));
    }
    let on_boundaries = points.len();
    points.extend((0..tries(100_000)).map(|_| near_a_boundary(&mut random)));
    let near = points.len();
    // Numbers that f32 has not, or only as zero, infinite or with few digits.
    points.extend((0..tries(20_000)).map(|_| {
        let mut size = || random.log(1e-60, 1e50);
        let [gamma, k_prime, k, mu] = [size(), size(), size(), size()];
        [
            gamma.max(1e-50),
            k_prime * random.pick(&[-1.0, 1.0]),
            k,
            random.pick(&[mu, k.next_up(), k, k.next_down()]),
        ]
    }));
    let columns = columns_of(&points);
    let expected = one_by_one(&points);

    let mut codes = vec![0; points.len()];
    batch::classify(lent(&columns), &mut codes).unwrap();
    assert_eq!(codes, expected);

    let mut first = None;
    for set in InstructionSet::ALL {
        codes.fill(0);
        if !set.is_available() {
            let needed = set == InstructionSet::Avx2 && cfg!(target_arch = "x86_64");
            assert!(!needed || std::env::var_os("CI").is_none(), "CI has to test the {set:?} kernel");
            eprintln!("skipped: this processor has no {set:?}");
            continue;
        }
        batch::screen_with(set, lent(&columns), &mut codes);
        let wrong =
            codes.iter().zip(&expected).filter(|(code, expected)| **code != u8::MAX && code != expected);
        assert_eq!(wrong.count(), 0, "{set:?}");
        // A third of the ordinary points are small fractions, which meet boundaries exactly.
        let unsure = |codes: &[u8]| codes.iter().filter(|code| **code == u8::MAX).count();
        assert!(
            unsure(&codes[..ordinary]) < ordinary / 50,
            "{set:?}: {} of {ordinary}",
            unsure(&codes[..ordinary])
        );
        // f64 tells most of what f32 does not.
        assert!(unsure(&codes[on_boundaries..near]) < (near - on_boundaries) / 5, "{set:?}");
        assert_eq!(first.get_or_insert_with(|| codes.clone()), &codes, "{set:?}");
    }
}

/// The kernel takes points in blocks, of which f64 takes those that f32 cannot tell, and some that follow: every length, and every
/// order of such blocks, gives what the single call gives.
#[test]
fn batches_of_every_length_agree_with_the_single_call() {
    let mut random = Random(12);
    let points: Vec<[f64; 4]> = (0..20_000)
        .map(|index| if index / 700 % 3 == 1 { near_a_boundary(&mut random) } else { random.point() })
        .collect();
    let expected = one_by_one(&points);
    for length in (0..200).chain([700, 4095, 4096, 4097, 19_999, 20_000]) {
        let start = (length * 97) % (points.len() - length + 1);
        let columns = columns_of(&points[start..start + length]);
        let mut codes = vec![0; length];
        batch::classify(lent(&columns), &mut codes).unwrap();
        assert_eq!(codes, expected[start..start + length], "{length} points");
    }
}

/// Numbers that f32 makes zero of decide in f64: a friction below the force by less than f32 has numbers for, and zeros of either sign.
#[test]
fn differences_too_small_for_f32_decide() {
    let cases = [
        ([1.0, 0.5, 2e-60, 1e-60], Mode::SlideLeft),
        ([1.0, 0.5, 1e-60, 2e-60], Mode::Rest),
        ([1.0, 0.5, 1e-60, 1e-60], Mode::Rest),
        ([1.0, -1.5, 5e-324, 0.0], Mode::SlideLeft),
        ([1.0, -1.5, 0.0, 0.0], Mode::Rest),
        ([1.0, 0.5, -0.0, -0.0], Mode::Rest),
        ([1.0, 0.5, 0.0, -0.0], Mode::Rest),
        ([1e-40, 0.5, 1.0, 0.5], Mode::SlideLeft),
        ([1.0, 1e40, 1e-45, 1.0], Mode::Rest),
    ];
    for (point, mode) in cases {
        let columns = columns_of(&[point; 70]);
        let mut codes = vec![0; 70];
        batch::classify(lent(&columns), &mut codes).unwrap();
        assert_eq!(codes, [mode.code(); 70], "{point:?}");
        assert_eq!(one_by_one(&[point]), [mode.code()], "{point:?}");
    }
}

#[test]
fn a_batch_names_the_first_bad_value() {
    let good = [1.0; 5000];
    for (bad, expected) in [
        (f64::NAN, "point 4500: friction μ is NaN; expected a number from 0 to 1e50"),
        (-0.5, "point 4500: friction μ is -0.5; expected a number from 0 to 1e50"),
        (f64::INFINITY, "point 4500: friction μ is inf; expected a number from 0 to 1e50"),
    ] {
        let mut friction = good;
        friction[4500] = bad;
        friction[4700] = f64::NAN;
        let columns = Columns { gamma: &good, k_prime: &good, k: &good, mu: &friction };
        let error = batch::classify(columns, &mut [0; 5000]).unwrap_err();
        assert_eq!(error.to_string(), expected);
    }
    let columns = Columns { gamma: &good, k_prime: &good, k: &good[1..], mu: &good };
    let error = batch::classify(columns, &mut [0; 5000]).unwrap_err();
    assert_eq!(error, BatchError::Length { column: "k", found: 4999, expected: 5000 });
}

/// Whatever is not a valid number is caught in every column, by every kernel.
#[test]
fn no_bad_value_gets_a_mode() {
    for column in 0..4 {
        for bad in
            [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.1e50, -1.1e50, 1e-60, -1e-300, -1.0, 0.0, -0.0]
        {
            for others in [[1.0, 0.5, 0.25, 0.75], [1.0, 0.5, 1e-40, 0.75], [1.0, 0.5, 0.0, 0.0]] {
                let mut point = others;
                point[column] = bad;
                let [gamma, k_prime, k, mu] = point;
                let scalar = Point::new(gamma, k_prime, k, mu).map(|point| point.mode().code());
                let columns = [&[gamma; 9], &[k_prime; 9], &[k; 9], &[mu; 9]];
                let [slenderness, elevation, force, friction] = columns.map(|column| column.as_slice());
                let mut codes = [0; 9];
                let batch = batch::classify(
                    Columns { gamma: slenderness, k_prime: elevation, k: force, mu: friction },
                    &mut codes,
                );
                assert_eq!(batch.is_ok(), scalar.is_ok(), "column {column}, {bad}, {others:?}");
                if let Ok(code) = scalar {
                    assert_eq!(codes, [code; 9]);
                }
            }
        }
    }
}
