//! Limit states that are functions, against closed forms and integrals that share no code with the crate.

use std::f64::consts::{PI, SQRT_2};

use standfast_probability::copula::{Copula, Correlation, CorrelationMeasure};
use standfast_probability::law::{Distribution, Law};
use standfast_probability::limit_state::{Asked, LimitStateError, Reliability, reliability};
use standfast_probability::method::Method;
use standfast_probability::normal;
use standfast_probability::problem::RandomVector;
use standfast_probability::sample::Effort;

fn standard(n: usize) -> RandomVector {
    RandomVector::independent(vec![Law::normal(0.0, 1.0).unwrap().into(); n])
}

fn lognormal(mean: f64, cov: f64) -> Distribution {
    Law::lognormal(mean, mean * cov).unwrap().into()
}

fn precisely(method: Option<Method>) -> Asked<'static> {
    Asked {
        method,
        effort: Effort { precision: 0.003, floor: 1e-12, ..Effort::default() },
        ..Asked::default()
    }
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() <= relative, "{what}: {value} where {expected} is expected");
}

/// ∫ φ(x) f(x) dx by the trapezoidal rule.
fn mean(f: impl Fn(f64) -> f64) -> f64 {
    let h = 1.0 / 256.0;
    let density = |x: f64| h * (-0.5 * x * x).exp() / (2.0 * PI).sqrt();
    (-3072..=3072).map(|i| f64::from(i) * h).map(|x| density(x) * f(x)).sum()
}

fn holds(what: &str, found: &Reliability, expected: f64) {
    let interval = found.below_zero;
    let about = 0.5 * (interval.high - interval.low);
    assert!(
        (interval.value - expected).abs() <= 2.0 * about + 1e-9 * expected,
        "{what}: {interval:?}, {expected}"
    );
    assert!(found.precise, "{what}: {found:?}");
}

/// Two numbers are integrated: a parabola (RP22 of published benchmarks), whose probability is one integral, and a line.
#[test]
fn two_numbers_have_all_digits() {
    let parabola = |u: &[f64]| 2.5 - (u[0] + u[1]) / SQRT_2 + 0.1 * (u[0] - u[1]).powi(2);
    let expected = mean(|v| normal::above(2.5 + 0.2 * v * v));
    let found = reliability(&standard(2), &parabola, &Asked::default()).unwrap();
    assert_eq!((found.method, found.given_up), (Method::Integrate, false));
    assert_close("RP22", found.below_zero.value, expected, 1e-9);
    assert_close("β", found.design_points[0].beta, 2.5, 1e-9);
    // Known, either number leaves a root of 2.5 − u/√2 + 0.1 u², which it has none of: −0.9 < 0.
    let line = |u: &[f64]| 10.0 - 3.0 * u[0] - 4.0 * u[1];
    let found = reliability(&standard(2), &line, &Asked::default()).unwrap();
    assert_close("line", found.below_zero.value, normal::above(2.0), 1e-10);
    assert_eq!(found.line, 1);
    assert_close("first known", found.known[0].value, normal::above(2.5), 1e-10);
    assert_close("second known", found.known[1].value, normal::above(10.0 / 3.0), 1e-10);
}

/// Five lognormals, rare: the logarithm of their product is normal.
#[test]
fn a_product_of_lognormals_is_exact() {
    let covs = [0.1, 0.2, 0.15, 0.25, 0.3];
    let laws: Vec<Distribution> = covs.iter().map(|cov| lognormal(1.0, *cov)).collect();
    let spread = |cov: f64| (1.0 + cov * cov).ln();
    let variance: f64 = covs.iter().map(|cov| spread(*cov)).sum();
    let limit = (5.0 * variance.sqrt() - 0.5 * variance).exp();
    let inputs = RandomVector::independent(laws);
    let product = |x: &[f64]| limit - x.iter().product::<f64>();
    let found = reliability(&inputs, &product, &precisely(None)).unwrap();
    assert_eq!(found.method, Method::Importance);
    holds("product", &found, normal::above(5.0));
    assert_close("β", found.design_points[0].beta, 5.0, 1e-8);
    for (alpha, cov) in found.design_points[0].alpha.iter().zip(covs) {
        assert!((alpha - (spread(cov) / variance).sqrt()).abs() < 1e-4, "{alpha}, {cov}");
    }
    // What matters most is the line.
    assert_eq!(found.line, 4);
}

/// Every method has the same answer, whichever input is the line, of correlated numbers.
#[test]
fn methods_and_lines_agree() {
    let laws = vec![
        Law::normal(10.0, 1.0).unwrap().into(),
        Law::normal(6.0, 1.5).unwrap().into(),
        Law::normal(1.0, 0.5).unwrap().into(),
    ];
    let measure = CorrelationMeasure::Normal(0.5);
    let copula = Copula::new(&laws, &[Correlation { first: 0, second: 1, measure }]).unwrap();
    let inputs = RandomVector::new(laws, copula);
    let sum = |x: &[f64]| x[0] - x[1] - x[2];
    let beta = 3.0 / (1.0f64 + 2.25 + 0.25 - 2.0 * 0.5 * 1.5).sqrt();
    for method in Method::ALL {
        for line in 0..3 {
            let mut asked = Asked { line: Some(line), ..precisely(Some(method)) };
            asked.effort.precision = if method == Method::MonteCarlo { 0.02 } else { 0.003 };
            let found = reliability(&inputs, &sum, &asked).unwrap();
            assert_eq!(found.line, line);
            holds(&format!("{method}, {line}"), &found, normal::above(beta));
            assert_close("β", found.design_points[0].beta, beta, 1e-8);
        }
    }
}

/// What happens at the medians has a negative index; what never happens has none.
#[test]
fn likely_and_impossible() {
    let found = reliability(&standard(2), &|u: &[f64]| -1.0 - u[0] - 0.0 * u[1], &Asked::default()).unwrap();
    assert_close("likely", found.below_zero.value, normal::below(1.0), 1e-10);
    assert_close("β", found.design_points[0].beta, -1.0, 1e-9);
    let never = reliability(&standard(2), &|_: &[f64]| 1.0, &Asked::default()).unwrap();
    assert_eq!((never.below_zero.value, never.design_points.len()), (0.0, 0));
    // One number alone.
    let one = reliability(&standard(1), &|u: &[f64]| 2.0 - u[0], &Asked::default()).unwrap();
    assert_close("one", one.below_zero.value, normal::above(2.0), 1e-12);
    assert!(one.known.is_empty());
    // Twice below zero: two tails of one number.
    let tails =
        reliability(&standard(1), &|u: &[f64]| (2.0 - u[0]) * (u[0] + 3.0), &Asked::default()).unwrap();
    assert_close("tails", tails.below_zero.value, normal::above(2.0) + normal::above(3.0), 1e-12);
}

/// Discrete numbers are summed over, and the function is decided at their values.
#[test]
fn steps_are_decided_at_their_values() {
    let steps: Distribution = Law::discrete(&[1.0, 2.0, 3.0], &[0.7, 0.2, 0.1]).unwrap().into();
    let inputs = RandomVector::independent(vec![Law::normal(4.0, 0.5).unwrap().into(), steps.clone()]);
    let found = reliability(&inputs, &|x: &[f64]| x[0] - x[1], &Asked::default()).unwrap();
    let expected = 0.7 * normal::above(6.0) + 0.2 * normal::above(4.0) + 0.1 * normal::above(2.0);
    assert_close("steps", found.below_zero.value, expected, 1e-10);
    assert_eq!(found.line, 0);
    // Two is not below two.
    let alone = RandomVector::independent(vec![steps]);
    let found = reliability(&alone, &|x: &[f64]| 2.0 - x[0], &Asked::default()).unwrap();
    assert_close("tie", found.below_zero.value, 0.1, 1e-12);
}

#[test]
fn what_is_no_number_is_refused_with_its_values() {
    let root = |u: &[f64]| 2.0 - u[1] + 0.0 * (u[0] + 3.0).sqrt();
    let error = reliability(&standard(2), &root, &Asked::default()).unwrap_err();
    let LimitStateError::NotANumber { values, probability } = error else { panic!("{error}") };
    assert!(values[0] < -3.0, "{values:?}");
    assert_close("not a number", probability, normal::above(3.0), 1e-6);
    // Farther out it is left out.
    let root = |u: &[f64]| 2.0 - u[1] + 0.0 * (u[0] + 7.0).sqrt();
    let found = reliability(&standard(2), &root, &Asked::default()).unwrap();
    assert_close("left out", found.below_zero.value, normal::above(2.0), 1e-9);
    let alone = reliability(&standard(1), &|u: &[f64]| (u[0] + 6.0).sqrt() - 1.0, &Asked::default()).unwrap();
    assert_close("alone", alone.below_zero.value, normal::below(-5.0) - normal::below(-6.0), 1e-9);
    let integrate = Asked { method: Some(Method::Integrate), ..Asked::default() };
    let error = reliability(&standard(4), &|u: &[f64]| 3.0 - u[0], &integrate).unwrap_err();
    assert_eq!(error.to_string(), "integrate takes 3 random numbers at most, of 4");
}
