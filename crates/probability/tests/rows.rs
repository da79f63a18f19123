//! Rows of bodies alike, against integrals written out here, and against bodies and years drawn one by one.

mod common;

use common::{Fails, mean};
use standfast_probability::copula::{Copula, Correlation, CorrelationMeasure};
use standfast_probability::integrate::{Within, integrate_life};
use standfast_probability::law::Law;
use standfast_probability::life::{Life, lives};
use standfast_probability::normal::below;
use standfast_probability::points::Stream;
use standfast_probability::problem::RandomVector;
use standfast_probability::row::{Row, rows};
use standfast_probability::sample::{Effort, Estimate};

/// Means and deviations of a resistance and loads.
const LAWS: [(f64, f64); 4] = [(3.9, 0.5), (0.3, 0.2), (1.2, 0.4), (0.6, 0.3)];
const BODIES: u64 = 12;
const YEARS: f64 = 20.0;

/// So many of them, of which two are correlated.
fn inputs(count: usize, correlated: (usize, usize), correlation: f64) -> RandomVector {
    let laws: Vec<_> =
        LAWS[..count].iter().map(|(mean, sd)| Law::normal(*mean, *sd).unwrap().into()).collect();
    let (first, second) = correlated;
    let measure = CorrelationMeasure::Normal(correlation);
    let copula = Copula::new(&laws, &[Correlation { first, second, measure }]).unwrap();
    RandomVector::new(laws, copula)
}

fn life(yearly: &[bool]) -> Life {
    Life { years: YEARS, yearly: yearly.to_vec(), events: None, clock: None }
}

fn row(own: &[bool]) -> Row {
    Row { bodies: BODIES, own: own.to_vec() }
}

fn effort(points: u64) -> Effort {
    Effort { precision: 0.01, points, threads: 2, ..Effort::default() }
}

fn found(inputs: &RandomVector, line: usize, row: &Row, life: &Life, points: u64) -> Estimate {
    rows(inputs, &Fails { line }, &[1], row, life, &effort(points)).estimates[0]
}

fn assert_found(what: &str, found: Estimate, expected: f64) {
    assert!((found.value - expected).abs() < found.high - found.low, "{what}: {found:?}, {expected}");
    assert!(found.high - found.low < 0.2 * expected, "{what}: {found:?}, {expected}");
}

/// In one event the bodies are independent given what is common: E[1 − (1 − p)ⁿ], integrated or drawn, whatever the line is.
#[test]
fn in_an_event_bodies_are_independent_given_what_is_common() {
    let inputs = inputs(2, (0, 1), 0.0);
    let [(r, sr), (l, sl), ..] = LAWS;
    let (l, sl) = (l + 1.8, sl + 0.2);
    let inputs = RandomVector::new(
        vec![inputs.laws()[0].clone(), Law::normal(l, sl).unwrap().into()],
        inputs.copula().clone(),
    );
    let expected = mean(|z| 1.0 - (1.0 - below((l + sl * z - r) / sr)).powi(BODIES as i32));
    let row = row(&[true, false]);
    let event = row.of_one_event();
    let integrated = integrate_life(&inputs, &Fails { line: 0 }, &[1], &event, Within::ALL_DIGITS).unwrap();
    assert!((integrated.probabilities[0] / expected - 1.0).abs() < 1e-8, "{integrated:?} {expected}");
    for line in [0, 1] {
        let drawn = lives(&inputs, &Fails { line }, &[1], &event, &effort(1 << 22)).estimates[0];
        assert_found("lives", drawn, expected);
        // A row over a life in which nothing is yearly is that event.
        let once = Life { years: 1.0, yearly: vec![false; 2], events: None, clock: None };
        assert_found("rows", found(&inputs, line, &row, &once, 1 << 22), expected);
    }
    // It lies between one body and as many that have nothing in common.
    let one = below((l - r) / sr.hypot(sl));
    assert!(one < expected && expected < 1.0 - (1.0 - one).powi(BODIES as i32));
}

/// A friction that each body has for life, and a sea that is common and yearly: the largest sea of the life counts, and given it the
/// bodies are independent. With a bias common for life besides.
#[test]
fn over_a_life_the_largest_common_load_counts() {
    let [(r, sr), (b, sb), (s, ss), _] = LAWS;
    let inputs = inputs(3, (0, 1), 0.0);
    let any = |bias: f64| {
        // The density of the largest of n normals.
        mean(|z| {
            let given = below((bias + s + ss * z - r) / sr);
            YEARS * below(z).powf(YEARS - 1.0) * (1.0 - (1.0 - given).powi(BODIES as i32))
        })
    };
    let expected = mean(|z| any(b + sb * z));
    for line in [0, 1, 2] {
        let of = found(&inputs, line, &row(&[true, false, false]), &life(&[false, false, true]), 1 << 22);
        assert_found(&format!("line {line}"), of, expected);
    }
}

/// Bodies that have nothing in common are as many lives.
#[test]
fn what_is_not_common_is_independent() {
    let [(r, sr), (b, sb), (s, ss), _] = LAWS;
    let of_one = mean(|z| {
        let year = below((b + s - r - sr * z) / sb.hypot(ss));
        1.0 - (1.0 - year).powf(YEARS)
    });
    let expected = 1.0 - (1.0 - of_one).powi(BODIES as i32);
    let inputs = inputs(3, (0, 1), 0.0);
    for line in [0, 1] {
        let of = found(&inputs, line, &row(&[true; 3]), &life(&[false, true, true]), 1 << 22);
        assert_found(&format!("line {line}"), of, expected);
    }
}

/// All four kinds, two of them correlated, beside bodies and years that are drawn one by one, whatever the line is.
#[test]
fn all_kinds_as_if_drawn_one_by_one() {
    let rho = 0.6f64;
    // The resistance of each body with its own yearly load; the bias for life with each body's resistance.
    for (correlated, seed) in [((0, 3), 1), ((1, 0), 2), ((1, 2), 3)] {
        let inputs = inputs(4, correlated, rho);
        let (own, yearly) = ([true, false, false, true], [false, false, true, true]);
        let mut stream = Stream::new(seed, 7);
        let mut normal = || {
            let (a, b) = (stream.draw(), stream.draw());
            (-2.0 * a.ln()).sqrt() * (2.0 * std::f64::consts::PI * b).cos()
        };
        const LIVES: u32 = 10_000;
        let mut failed = 0;
        let mix = |on: f64, z: f64| rho * on + (1.0 - rho * rho).sqrt() * z;
        for _ in 0..LIVES {
            let bias = normal();
            let seas: Vec<f64> = (0..YEARS as usize)
                .map(|_| if correlated == (1, 2) { mix(bias, normal()) } else { normal() })
                .collect();
            let mut any = false;
            for _ in 0..BODIES {
                let resistance = if correlated == (1, 0) { mix(bias, normal()) } else { normal() };
                for sea in &seas {
                    let local = if correlated == (0, 3) { mix(resistance, normal()) } else { normal() };
                    let z = [resistance, bias, *sea, local];
                    let [r, loads @ ..] = [0, 1, 2, 3].map(|input| {
                        LAWS[input].0 - 0.55 * f64::from(u8::from(input == 3)) + LAWS[input].1 * z[input]
                    });
                    any |= r < loads.iter().sum::<f64>();
                }
            }
            failed += u32::from(any);
        }
        let expected = f64::from(failed) / f64::from(LIVES);
        let deviation = (expected * (1.0 - expected) / f64::from(LIVES)).sqrt();
        let laws: Vec<_> = (0..4)
            .map(|input| {
                if input == 3 { Law::normal(0.05, 0.3).unwrap().into() } else { inputs.laws()[input].clone() }
            })
            .collect();
        let inputs = RandomVector::new(laws, inputs.copula().clone());
        for line in 0..4 {
            let of = found(&inputs, line, &row(&own), &life(&yearly), 1 << 20);
            let allowed = 3.5 * deviation + (of.high - of.low);
            assert!((of.value - expected).abs() < allowed, "{correlated:?} {line}: {of:?} {expected}");
        }
    }
}

/// A sea that depends on the friction of one body would be another sea for each.
#[test]
fn what_is_common_does_not_depend_on_what_is_not() {
    let (own, yearly) = (row(&[true, false, false]), life(&[false, false, true]));
    assert_eq!(own.clash(&inputs(3, (0, 2), 0.3), &yearly), Some((0, 2)));
    assert_eq!(own.clash(&inputs(3, (0, 1), 0.3), &yearly), None);
    assert_eq!(own.clash(&inputs(3, (1, 2), 0.3), &yearly), None);
    // Within one event, all is drawn once.
    assert_eq!(own.clash(&inputs(3, (0, 2), 0.3), &life(&[false; 3])), None);
}

/// More threads, the same bytes.
#[test]
fn threads_do_not_matter() {
    let of = |threads| {
        let effort = Effort { threads, ..effort(1 << 18) };
        let (row, life) = (row(&[true, false, false, true]), life(&[false, false, true, true]));
        rows(&inputs(4, (0, 3), 0.2), &Fails { line: 1 }, &[1], &row, &life, &effort)
    };
    assert_eq!(of(1), of(3));
}
