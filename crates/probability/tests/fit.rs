//! Fitted laws against closed forms and against scipy, and laws that depend on other inputs against integrals by hand.

use standfast_probability::copula::Copula;
use standfast_probability::fit::{Family, Fit, FitError};
use standfast_probability::form::design_point;
use standfast_probability::integrate::{Within, integrate, integrate_life};
use standfast_probability::law::{Distribution, Law};
use standfast_probability::life::{Life, lives};
use standfast_probability::limit_state::{Asked, reliability};
use standfast_probability::normal;
use standfast_probability::problem::{GivenLaw, Outcomes, Pieces, RandomVector};
use standfast_probability::sample::{Effort, draws, monte_carlo, sobol};

/// Highest waves of ten years, m, made up.
const HEIGHTS: [f64; 10] = [4.1, 5.2, 3.8, 4.6, 6.0, 4.4, 3.9, 5.5, 4.9, 4.2];

fn near(fit: &Fit, expected: &[(f64, f64)]) {
    assert_eq!(fit.parameters.len(), expected.len());
    for (parameter, (estimate, deviation)) in fit.parameters.iter().zip(expected) {
        let off = |a: f64, b: f64| (a - b).abs() / b.abs();
        assert!(off(parameter.estimate, *estimate) < 1e-6, "{parameter:?} {estimate}");
        assert!(off(parameter.deviation, *deviation) < 1e-5, "{parameter:?} {deviation}");
    }
}

/// Mean and deviation have s/√n and 1/√(2n), without correlation; so have those of logarithms; an exponential scale 1/√n.
#[test]
fn closed_forms() {
    let n = HEIGHTS.len() as f64;
    let moments = |values: &[f64]| {
        let mean = values.iter().sum::<f64>() / n;
        (mean, (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt())
    };
    let fit = Fit::of(Family::Normal, &HEIGHTS, 0.0).unwrap();
    let (mean, sd) = moments(&HEIGHTS);
    near(&fit, &[(mean, sd / n.sqrt()), (sd, (2.0 * n).sqrt().recip())]);
    assert!(fit.correlation[0][1].abs() < 1e-6);
    let fit = Fit::of(Family::LogNormal, &HEIGHTS, 0.0).unwrap();
    let (mean, sd) = moments(&HEIGHTS.map(f64::ln));
    near(&fit, &[(mean, sd / n.sqrt()), (sd, (2.0 * n).sqrt().recip())]);
    let fit = Fit::of(Family::Exponential, &HEIGHTS, 3.5).unwrap();
    near(&fit, &[(moments(&HEIGHTS).0 - 3.5, n.sqrt().recip())]);
}

/// Likeliest parameters of scipy 1.16 (a root of Gumbel's equation, else `logpdf` and Nelder–Mead), with the inverse of second derivatives.
#[test]
fn as_scipy_has_them() {
    let fit = Fit::of(Family::Gumbel, &HEIGHTS, 0.0).unwrap();
    near(&fit, &[(4.336518944839044, 0.17979813), (0.5402006084562867, 0.25879764)]);
    assert!((fit.correlation[0][1] - 0.3119415690501845).abs() < 1e-6);
    let fit = Fit::of(Family::Weibull, &HEIGHTS, 3.5).unwrap();
    near(&fit, &[(1.30898931, 0.18892861), (1.76848258, 0.24988807)]);
    let peaks = [0.1, 0.3, 0.2, 0.9, 1.6, 0.5, 0.05, 2.9, 0.7, 1.1, 0.4, 4.2];
    let fit = Fit::of(Family::Pareto, &peaks, 0.0).unwrap();
    near(&fit, &[(0.8618272880665686, 0.50460914), (0.21193963775647123, 0.41837813)]);
    assert!((fit.correlation[0][1] + 0.7277249450343178).abs() < 1e-5);
    let fit = Fit::of(Family::Gev, &HEIGHTS, 0.0).unwrap();
    let correlation = [fit.correlation[0][1], fit.correlation[0][2], fit.correlation[1][2]];
    for (found, expected) in correlation.into_iter().zip([0.65278482, -0.57412097, -0.53830966]) {
        assert!((found - expected).abs() < 1e-5, "{found} {expected}");
    }
    near(
        &fit,
        &[
            (4.299140610967661, 0.21018687),
            (0.5065881324336184, 0.33861661),
            (0.13257130242844334, 0.45943302),
        ],
    );
}

#[test]
fn values_that_fit_no_law_are_refused() {
    let few = Fit::of(Family::Gumbel, &[4.0, 4.0, 4.0, 4.0, 5.0, 6.0], 0.0).unwrap_err();
    assert_eq!(few, FitError::Few { count: 6, different: 3, least: 5 });
    // A value at a threshold is over it; a Weibull law has none at its origin.
    assert!(Fit::of(Family::Exponential, &HEIGHTS, 3.8).is_ok());
    assert!(Fit::of(Family::Weibull, &HEIGHTS, 3.8).is_err());
    let outside = Fit::of(Family::Weibull, &HEIGHTS, 4.0).unwrap_err();
    assert_eq!(outside, FitError::Outside { value: 3.8, origin: 4.0 });
    // Values that end abruptly: the likelihood grows without bound as the law's end comes to the largest.
    let end: Vec<f64> = (1..30).map(|i| f64::from(i).powf(0.1)).collect();
    assert_eq!(Fit::of(Family::Gev, &end, 0.0).unwrap_err(), FitError::Shape);
}

/// The first input, a resistance, is below the second, a load.
struct Below {
    line: usize,
}

impl Outcomes for Below {
    fn count(&self) -> usize {
        1
    }
    fn line(&self) -> usize {
        self.line
    }
    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        match self.line {
            0 => pieces.push(f64::NEG_INFINITY, values[1], 0),
            _ => pieces.push(values[0], f64::INFINITY, 0),
        }
    }
    fn at(&self, values: &[f64]) -> u64 {
        u64::from(values[0] < values[1])
    }
}

/// The first input is above a level.
struct Above(f64);

impl Outcomes for Above {
    fn count(&self) -> usize {
        1
    }
    fn line(&self) -> usize {
        0
    }
    fn along(&self, _: &[f64], pieces: &mut Pieces) {
        pieces.push(self.0, f64::INFINITY, 0);
    }
    fn at(&self, values: &[f64]) -> u64 {
        u64::from(values[0] > self.0)
    }
}

/// A load whose deviation is a share of a mean that is itself random, and a resistance: R < S.
fn of_resistance_and_load() -> RandomVector {
    let laws: Vec<Distribution> = vec![
        Law::normal(3.0, 0.3).unwrap().into(),
        Law::normal(0.0, 1.0).unwrap().into(),
        Law::uniform(1.0, 2.0).unwrap().into(),
    ];
    let load = GivenLaw::new(vec![2], |values| Law::normal(values[2], 0.2 * values[2]).unwrap().into());
    RandomVector::independent(laws).with_given(vec![(1, load)])
}

/// P = ∫ Φ((m − 3)/√(0.3² + 0.04 m²)) dm over 1 … 2, by a rule of Simpson; along the resistance, and along the load whose law is given.
#[test]
fn a_law_that_is_given_is_integrated() {
    let inputs = of_resistance_and_load();
    let n = 2000;
    let f = |m: f64| normal::below((m - 3.0) / (0.09 + 0.04 * m * m).sqrt());
    let weight = |i: i32| if i == 0 || i == n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    let expected: f64 =
        (0..=n).map(|i| weight(i) * f(1.0 + f64::from(i) / f64::from(n))).sum::<f64>() / (3.0 * f64::from(n));
    for line in [0, 1] {
        let of = Below { line };
        let found = integrate(&inputs, &of, &[1], Within::ALL_DIGITS).unwrap().probabilities[0];
        assert!((found / expected - 1.0).abs() < 1e-11, "{line}: {found} {expected}");
        let effort = Effort { points: 1 << 17, precision: 1e-4, ..Effort::default() };
        let sampled = sobol(&inputs, &of, &[1], &effort).estimates[0];
        let half = 0.5 * (sampled.high - sampled.low);
        assert!((sampled.value - expected).abs() < 2.0 * half, "{line}: {sampled:?} {expected}");
        assert!(sampled.high / sampled.low < 1.01);
        let effort = Effort { points: 1 << 20, precision: 1e-3, ..Effort::default() };
        let drawn = monte_carlo(&inputs, &of, &[1], &effort).estimates[0];
        assert!(drawn.low <= expected && expected <= drawn.high, "{drawn:?} {expected}");
        // The nearest point: over m, ((3 − m)/√(0.3² + 0.04 m²))² + z(m)² is least, by a search.
        let square = |i: u32| {
            let m = 1.0 + f64::from(i) / 1e6;
            ((3.0 - m).powi(2) / (0.09 + 0.04 * m * m)) + normal::quantile(m - 1.0).powi(2)
        };
        let least = (1..1_000_000).map(square).fold(f64::INFINITY, f64::min).sqrt();
        let point = design_point(&inputs, &of, 1).unwrap();
        assert!((point.beta / least - 1.0).abs() < 1e-6, "{} {least}", point.beta);
        assert!((point.values[0] - point.values[1]).abs() < 1e-9, "{point:?}");
    }
    // Draws have the law's own values: mean 1.5, and the variance 1/12 + 0.04 E[m²].
    let (mut sum, mut squares) = (0.0, 0.0);
    draws(&inputs, 1, 100_000, |values| {
        sum += values[1] / 1e5;
        squares += values[1].powi(2) / 1e5;
    });
    assert!((sum - 1.5).abs() < 5e-3 && (squares - sum * sum - (1.0 / 12.0 + 0.04 * 7.0 / 3.0)).abs() < 3e-3);
}

/// Over a life the mean of the load is drawn once and the load each year: E[1 − Φ((R − m)/(0.2 m))ⁿ], by hand.
#[test]
fn what_lasts_is_drawn_once() {
    let laws: Vec<Distribution> =
        vec![Law::normal(0.0, 1.0).unwrap().into(), Law::uniform(1.0, 2.0).unwrap().into()];
    let load = GivenLaw::new(vec![1], |values| Law::normal(values[1], 0.2 * values[1]).unwrap().into());
    let inputs = RandomVector::new(laws, Copula::independent(2)).with_given(vec![(0, load)]);
    let n = 2000;
    let f = |m: f64| 1.0 - normal::below((3.0 - m) / (0.2 * m)).powi(30);
    let weight = |i: i32| if i == 0 || i == n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    let expected: f64 =
        (0..=n).map(|i| weight(i) * f(1.0 + f64::from(i) / f64::from(n))).sum::<f64>() / (3.0 * f64::from(n));
    let life = Life { years: 30.0, yearly: vec![true, false], events: None, clock: None };
    let of = Above(3.0);
    let found = integrate_life(&inputs, &of, &[1], &life, Within::ALL_DIGITS).unwrap().probabilities[0];
    assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
    let drawn = lives(&inputs, &of, &[1], &life, &Effort::default()).estimates[0];
    assert!(drawn.low <= expected && expected <= drawn.high, "{drawn:?} {expected}");
}

/// A limit state of one's own along an input whose law is narrow and moves far: P(x > 3) of x about m, which is normal itself.
#[test]
fn a_limit_state_along_a_law_that_is_given() {
    let laws: Vec<Distribution> = vec![Law::normal(0.0, 1.0).unwrap().into(); 2];
    let about = GivenLaw::new(vec![1], |values| Law::normal(values[1], 0.01).unwrap().into());
    let inputs = RandomVector::independent(laws).with_given(vec![(0, about)]);
    // Between two levels that lie closer than the law of the medians is looked at.
    for (from, to) in [(3.0, f64::INFINITY), (2.0, 2.004)] {
        let g = move |x: &[f64]| if from < x[0] && x[0] < to { -1.0 } else { 1.0 };
        let found = reliability(&inputs, &g, &Asked::default()).unwrap();
        let spread = 1.0001f64.sqrt();
        let by_hand = normal::below(to / spread) - normal::below(from / spread);
        let e = found.below_zero;
        assert!((e.value / by_hand - 1.0).abs() < 0.01, "{e:?} {by_hand}");
    }
}

#[test]
#[should_panic(expected = "no law depends on itself")]
fn a_law_does_not_depend_on_itself() {
    let of = |input: usize| GivenLaw::new(vec![input], |_| Law::normal(0.0, 1.0).unwrap().into());
    let laws: Vec<Distribution> = vec![Law::normal(0.0, 1.0).unwrap().into(); 2];
    let _ = RandomVector::independent(laws).with_given(vec![(0, of(1)), (1, of(0))]);
}
