//! Numbers with few values, and mixtures, in every method: against sums over the values and closed forms.

mod common;

use common::Fails;
use standfast_probability::copula::{Copula, Correlation, CorrelationMeasure};
use standfast_probability::form;
use standfast_probability::integrate::{Within, integrate};
use standfast_probability::law::{Distribution, Law};
use standfast_probability::normal;
use standfast_probability::problem::{Outcomes, Pieces, RandomVector};
use standfast_probability::sample::{self, Effort};

const FAILS: Fails = Fails { line: 0 };

/// The limit state, scanned.
struct Scanned(Distribution);

impl Outcomes for Scanned {
    fn count(&self) -> usize {
        1
    }

    fn line(&self) -> usize {
        0
    }

    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        let load: f64 = values[1..].iter().sum();
        pieces.scan(&self.0, &[], |x| u64::from(x < load));
    }

    fn at(&self, values: &[f64]) -> u64 {
        FAILS.at(values)
    }
}

fn normal_law(mean: f64, sd: f64) -> Distribution {
    Law::normal(mean, sd).unwrap().into()
}

fn discrete(values: &[f64], probabilities: &[f64]) -> Distribution {
    Law::discrete(values, probabilities).unwrap().into()
}

fn exact(inputs: &RandomVector) -> f64 {
    integrate(inputs, &FAILS, &[1], Within::ALL_DIGITS).unwrap().probabilities[0]
}

fn assert_close(what: &str, found: f64, expected: f64, relative: f64) {
    assert!((found / expected - 1.0).abs() <= relative, "{what}: {found} where {expected} is expected");
}

/// A load of three values beside two normal numbers is the sum of three closed forms, whichever number is the line.
#[test]
fn a_sum_over_the_values() {
    let (values, shares) = ([1.0, 2.5, 4.0], [0.9, 0.0999, 0.0001]);
    let expected: f64 = values
        .iter()
        .zip(shares)
        .map(|(load, share)| share * normal::above((5.0 - load - 0.5) / 0.5f64.hypot(0.3)))
        .sum();
    let laws = vec![normal_law(5.0, 0.5), discrete(&values, &shares), normal_law(0.5, 0.3)];
    let inputs = RandomVector::independent(laws.clone());
    assert_close("line normal", exact(&inputs), expected, 1e-12);
    let found = integrate(&inputs, &Scanned(laws[0].clone()), &[1], Within::ALL_DIGITS).unwrap();
    assert_close("scanned", found.probabilities[0], expected, 1e-10);
    // A discrete line, and nothing else that is not discrete.
    let [line, load] = [discrete(&[2.0, 3.0], &[0.25, 0.75]), discrete(&[2.0, 2.5, 3.0], &[0.5, 0.3, 0.2])];
    let inputs = RandomVector::independent(vec![line.clone(), load]);
    // 2 < 2.5 and 2 < 3; 3 < 3 does not hold, by the value itself.
    assert_close("ties", exact(&inputs), 0.25 * 0.5, 1e-13);
    let found = integrate(&inputs, &Scanned(line.clone()), &[1], Within::ALL_DIGITS).unwrap();
    assert_close("ties, scanned", found.probabilities[0], 0.125, 1e-13);
    // A discrete line beside a normal number: the sum over the line's values.
    let inputs = RandomVector::independent(vec![line, normal_law(2.2, 0.4)]);
    let sum = 0.25 * normal::below(0.2 / 0.4) + 0.75 * normal::above(0.8 / 0.4);
    assert_close("discrete line", exact(&inputs), sum, 1e-12);
    // Of three values, the one in the middle is passed where neither end of the law is.
    let three = discrete(&[2.0, 2.4, 3.0], &[0.25, 0.5, 0.25]);
    let inputs = RandomVector::independent(vec![three, normal_law(2.2, 0.4)]);
    let below = |line: f64| normal::above((line - 2.2) / 0.4);
    let sum = 0.25 * below(2.0) + 0.5 * below(2.4) + 0.25 * below(3.0);
    assert_close("three", exact(&inputs), sum, 1e-12);
}

/// A sample of 300 values is a sum of as many terms, and quick.
#[test]
fn a_sum_over_a_sample() {
    let values: Vec<f64> =
        (0..300).map(|i| 1.0 + (f64::from(i) * 0.7).sin() + 0.003 * f64::from(i)).collect();
    let expected: f64 =
        values.iter().map(|load| normal::above((4.0 - load - 0.5) / 0.5f64.hypot(0.3))).sum::<f64>() / 300.0;
    let sample = Law::sample(&values).unwrap().into();
    let inputs = RandomVector::independent(vec![normal_law(4.0, 0.5), normal_law(0.5, 0.3), sample]);
    let found = integrate(&inputs, &FAILS, &[1], Within::ALL_DIGITS).unwrap();
    assert_close("sample", found.probabilities[0], expected, 1e-12);
    assert!(found.evaluations < 300_000, "{}", found.evaluations);
}

/// Correlated with a normal number, a discrete one is that number cut into stretches: each value's share is an integral of one variable.
#[test]
fn correlated_with_a_normal_number() {
    let rho = 0.6;
    let measure = CorrelationMeasure::Normal(rho);
    let laws = vec![normal_law(5.0, 0.5), discrete(&[1.0, 3.5], &[0.8, 0.2]), normal_law(0.5, 0.3)];
    let at = normal::quantile(0.8);
    // Resistance less the third number, given z of the load: both are normal.
    let given = |between: (usize, usize), z: f64, load: f64| {
        let across = (1.0 - rho * rho).sqrt();
        let (mean, sd) = match between {
            (0, 1) => (5.0 + 0.5 * rho * z - 0.5, (0.5 * across).hypot(0.3)),
            _ => (5.0 - 0.5 - 0.3 * rho * z, 0.5f64.hypot(0.3 * across)),
        };
        normal::below((load - mean) / sd)
    };
    for between in [(0, 1), (1, 2)] {
        let copula =
            Copula::new(&laws, &[Correlation { first: between.0, second: between.1, measure }]).unwrap();
        let inputs = RandomVector::new(laws.clone(), copula);
        let steps = 400_000;
        let expected: f64 = [(-12.0, at, 1.0), (at, 12.0, 3.5)]
            .map(|(from, to, load)| {
                let h = (to - from) / f64::from(steps);
                (0..steps)
                    .map(|i| from + (f64::from(i) + 0.5) * h)
                    .map(|z| h * normal::density(z) * given(between, z, load))
                    .sum::<f64>()
            })
            .iter()
            .sum();
        assert_close(&format!("{between:?}"), exact(&inputs), expected, 1e-8);
        let effort = Effort { precision: 0.01, floor: 1e-9, points: 1 << 20, ..Effort::default() };
        let drawn = sample::monte_carlo(&inputs, &FAILS, &[1], &effort);
        for found in [sample::sobol(&inputs, &FAILS, &[1], &effort), drawn] {
            let found = found.estimates[0];
            let about = 0.5 * (found.high - found.low);
            assert!((found.value - expected).abs() <= 2.0 * about, "{between:?}: {found:?}, {expected}");
        }
    }
}

/// Two populations of a load: the sum of both; the nearest point is that of the rare one.
#[test]
fn a_mixture_is_the_sum_of_its_parts() {
    let [often, rare] = [normal_law(1.0, 0.3), normal_law(3.5, 0.4)];
    let of =
        |load: &Distribution| exact(&RandomVector::independent(vec![normal_law(5.0, 0.5), load.clone()]));
    let expected = 0.98 * of(&often) + 0.02 * of(&rare);
    let mixture: Distribution = Law::mixture(vec![(0.98, often), (0.02, rare)]).unwrap().into();
    let inputs = RandomVector::independent(vec![normal_law(5.0, 0.5), mixture]);
    assert_close("mixture", exact(&inputs), expected, 1e-10);
    let point = form::design_point(&inputs, &FAILS, 1).unwrap();
    assert!((point.values[1] - point.values[0]).abs() < 1e-6 && point.values[1] > 3.0, "{point:?}");
    // A gap between two uniform loads is not smoothed over.
    let uniform = |from, to| Distribution::from(Law::uniform(from, to).unwrap());
    let parts = [uniform(1.0, 2.0), uniform(4.5, 5.0)];
    let expected = 0.7 * of(&parts[0]) + 0.3 * of(&parts[1]);
    let [first, second] = parts;
    let gap: Distribution = Law::mixture(vec![(0.7, first), (0.3, second)]).unwrap().into();
    let inputs = RandomVector::independent(vec![normal_law(5.0, 0.5), gap.clone()]);
    assert_close("gap", exact(&inputs), expected, 1e-11);
    // As the line.
    let turned = RandomVector::independent(vec![gap, normal_law(3.0, 0.8)]);
    let steps = 200_000;
    let share = |from: f64, to: f64| {
        let h = (to - from) / f64::from(steps);
        (0..steps).map(|i| normal::above((from + (f64::from(i) + 0.5) * h - 3.0) / 0.8)).sum::<f64>()
            / f64::from(steps)
    };
    assert_close("line", exact(&turned), 0.7 * share(1.0, 2.0) + 0.3 * share(4.5, 5.0), 1e-9);
}

/// The correlation of values of a discrete number with a normal one: ρ_z φ(z₁)/√(p(1 − p)) of two values.
#[test]
fn linear_correlation_of_two_values() {
    let laws = vec![discrete(&[1.0, 3.5], &[0.8, 0.2]), normal_law(0.5, 0.3)];
    let measure = CorrelationMeasure::Linear(0.4);
    let found = Copula::new(&laws, &[Correlation { first: 0, second: 1, measure }]).unwrap().between(0, 1);
    let at = normal::quantile(0.8);
    assert_close("linear", found, 0.4 * (0.8f64 * 0.2).sqrt() / normal::density(at), 1e-9);
}
