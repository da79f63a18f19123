//! Moments of laws, and how probabilities change with them, against closed forms written out here.

mod common;

use common::Fails;
use standfast_probability::copula::Copula;
use standfast_probability::form::design_point;
use standfast_probability::law::{Distribution, Law, Moments};
use standfast_probability::method::Method;
use standfast_probability::normal::{above, below, density, quantile_above};
use standfast_probability::problem::RandomVector;
use standfast_probability::sample::Effort;
use standfast_probability::slopes::slopes;
use standfast_watch::Portion;

const FAILS: Fails = Fails { line: 0 };

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!((value - expected).abs() <= relative * expected.abs(), "{what}: {value}, {expected}");
}

fn law(law: Result<Law, impl std::fmt::Debug>) -> Distribution {
    law.unwrap().into()
}

/// Of normals P = Φ(−β), β = (r − Σl)/s, s² = Σσ²: ∂P/∂r = −φ(β)/s, ∂P/∂l = φ(β)/s, ∂P/∂σ = φ(β) β σ/s².
#[test]
fn slopes_of_normals() {
    let means = [3.0, 0.6, 0.5, 0.4];
    for (deviations, method, accuracy) in [
        (&[0.5, 0.3, 0.2][..], Method::Integrate, 1e-3),
        (&[0.6, 0.5, 0.4, 0.3][..], Method::Sobol, 2e-2),
        (&[0.3, 0.2, 0.15, 0.1][..], Method::Importance, 2e-2),
    ] {
        let n = deviations.len();
        let laws: Vec<Distribution> = (0..n).map(|i| law(Law::normal(means[i], deviations[i]))).collect();
        let inputs = RandomVector::independent(laws);
        let s = deviations.iter().map(|sd| sd * sd).sum::<f64>().sqrt();
        let beta = (means[0] - means[1..n].iter().sum::<f64>()) / s;
        let about: Vec<Vec<f64>> = match method {
            Method::Importance => vec![design_point(&inputs, &FAILS, 1).unwrap().u],
            _ => Vec::new(),
        };
        for input in 0..n {
            let work = (Effort { threads: 2, ..Effort::default() }.within(Portion::UNSEEN), 1);
            let found = slopes((&inputs, &FAILS, 1), input, (method, &about, 1 << 17), work).unwrap();
            let sign = if input == 0 { -1.0 } else { 1.0 };
            let what = format!("{method} {input}");
            assert_close(&what, found.by_mean.unwrap(), sign * density(beta) / s, accuracy);
            let by_sd = density(beta) * beta * deviations[input] / (s * s);
            assert_close(&what, found.by_sd.unwrap(), by_sd, accuracy);
            assert_close(&what, found.moments.mean, means[input], 1e-12);
            assert_close(&what, found.moments.sd, deviations[input], 1e-12);
        }
    }
}

/// A lognormal resistance keeps its family: P = Φ((ln c − λ)/ζ), ζ² = ln(1 + (s/m)²), λ = ln m − ζ²/2, differentiated by hand.
#[test]
fn slopes_of_a_lognormal_are_those_of_its_family() {
    let (m, s, c) = (2.0, 0.4, 1.2);
    // The other input hardly varies.
    let inputs = RandomVector::independent(vec![law(Law::lognormal(m, s)), law(Law::normal(c, 1e-3))]);
    let work = (Effort::default().within(Portion::UNSEEN), 1);
    let found = slopes((&inputs, &FAILS, 1), 0, (Method::Integrate, &[], 0), work).unwrap();
    let v2 = (s / m).powi(2);
    let zeta = v2.ln_1p().sqrt();
    let lambda = m.ln() - 0.5 * zeta * zeta;
    let z = (c.ln() - lambda) / zeta;
    // dζ²/dm = −2 v²/(m (1 + v²)), dζ²/ds = 2 v²/(s (1 + v²)).
    let by = |d_zeta2: f64, d_ln_m: f64| {
        let d_zeta = d_zeta2 / (2.0 * zeta);
        let d_lambda = d_ln_m - 0.5 * d_zeta2;
        density(z) * (-d_lambda / zeta - z * d_zeta / zeta)
    };
    let by_mean = by(-2.0 * v2 / (m * (1.0 + v2)), 1.0 / m);
    let by_sd = by(2.0 * v2 / (s * (1.0 + v2)), 0.0);
    assert_close("mean", found.by_mean.unwrap(), by_mean, 1e-3);
    assert_close("sd", found.by_sd.unwrap(), by_sd, 1e-3);
    assert_close("mean of the law", found.moments.mean, m, 1e-12);
    assert_close("deviation of the law", found.moments.sd, s, 1e-12);
}

/// Laws that are moved and stretched: ∂P(X > c)/∂mean = f(c), ∂/∂sd = f(c) (c − mean)/sd. Bounds at which a law is cut stay.
#[test]
fn other_laws_are_moved_and_stretched() {
    let c = 6.0;
    let gumbel = |x: f64| {
        let y = (-(x - 4.0) / 0.7f64).exp();
        y / 0.7 * (-y).exp()
    };
    let weibull = |x: f64| {
        let y = (x - 1.0) / 3.0;
        1.8 / 3.0 * y.powf(0.8) * (-y.powf(1.8)).exp()
    };
    let tail = |x: f64| (1.0 + 0.1 * (x - 3.0) / 0.9f64).powf(-11.0) / 0.9;
    let laws: [(&str, Distribution, f64); 5] = [
        ("gumbel", law(Law::gumbel(4.0, 0.7)), gumbel(c)),
        ("weibull", law(Law::weibull(3.0, 1.8, 1.0)), weibull(c)),
        ("gpd", law(Law::pareto(3.0, 0.9, 0.1)), tail(c)),
        ("uniform", law(Law::uniform(2.0, 8.0)), 1.0 / 6.0),
        (
            "mixture",
            law(Law::mixture(vec![
                (0.7, law(Law::gumbel(4.0, 0.7))),
                (0.3, law(Law::weibull(3.0, 1.8, 1.0))),
            ])),
            0.7 * gumbel(c) + 0.3 * weibull(c),
        ),
    ];
    for (what, distribution, density) in laws {
        let inputs = RandomVector::independent(vec![law(Law::normal(c, 1e-3)), distribution]);
        let work = (Effort::default().within(Portion::UNSEEN), 1);
        let found = slopes((&inputs, &FAILS, 1), 1, (Method::Integrate, &[], 0), work).unwrap();
        let Moments { mean, sd } = found.moments;
        assert_close(what, found.by_mean.unwrap(), density, 2e-3);
        assert_close(what, found.by_sd.unwrap(), density * (c - mean) / sd, 4e-3);
    }
    // A normal law cut below at 3: P = above(z)/above(a), z = (c − m)/s, a = (3 − m)/s.
    let (m, s) = (4.0, 1.0);
    let cut = Distribution::truncated(Law::normal(m, s).unwrap(), 3.0, f64::INFINITY).unwrap();
    let inputs = RandomVector::independent(vec![law(Law::normal(c, 1e-3)), cut]);
    let work = (Effort::default().within(Portion::UNSEEN), 1);
    let found = slopes((&inputs, &FAILS, 1), 1, (Method::Integrate, &[], 0), work).unwrap();
    let (z, a) = ((c - m) / s, (3.0 - m) / s);
    let by_mean = (density(z) * above(a) - density(a) * above(z)) / (s * above(a).powi(2));
    assert_close("cut", found.by_mean.unwrap(), by_mean, 1e-3);
    // Values with probabilities of their own have no slope.
    let steps = RandomVector::new(
        vec![law(Law::normal(2.0, 1.0)), law(Law::discrete(&[0.0, 1.0], &[0.7, 0.3]))],
        Copula::independent(2),
    );
    let work = (Effort::default().within(Portion::UNSEEN), 1);
    let found = slopes((&steps, &FAILS, 1), 1, (Method::Integrate, &[], 0), work).unwrap();
    assert_eq!((found.by_mean, found.by_sd), (None, None));
    assert_close("mean", found.moments.mean, 0.3, 1e-12);
    assert_close("sd", found.moments.sd, 0.21f64.sqrt(), 1e-12);
    assert!(below(quantile_above(0.5)) == 0.5);
}

/// Closed forms of means and deviations.
#[test]
fn moments_of_laws() {
    let gamma = |x: f64| libm::tgamma(x);
    let (mode, scale) = (4.0, 0.7);
    let of = |law: Result<Law, _>| -> Moments {
        let law: Result<Law, standfast_probability::law::LawError> = law;
        law.unwrap().moments().unwrap()
    };
    for (what, found, [mean, sd], accuracy) in [
        (
            "gumbel",
            of(Law::gumbel(mode, scale)),
            [mode + 0.577_215_664_901_532_9 * scale, scale * std::f64::consts::PI / 6f64.sqrt()],
            1e-9,
        ),
        ("uniform", of(Law::uniform(2.0, 8.0)), [5.0, 6.0 / 12f64.sqrt()], 1e-9),
        ("exponential", of(Law::exponential(0.5, 2.0)), [2.5, 0.5], 1e-9),
        ("gpd", of(Law::pareto(0.0, 1.0, 0.1)), [1.0 / 0.9, 1.0 / (0.9 * 0.8f64.sqrt())], 1e-6),
        ("gamma", of(Law::gamma(0.5, 3.0, 1.0)), [2.5, 0.5 * 3f64.sqrt()], 1e-8),
        ("beta", of(Law::beta(2.0, 3.0, 1.0, 6.0)), [3.0, 1.0], 1e-8),
        ("triangular", of(Law::triangular(0.0, 1.0, 5.0)), [2.0, (21.0f64 / 18.0).sqrt()], 1e-4),
        (
            "weibull",
            of(Law::weibull(3.0, 1.8, 0.0)),
            {
                let (one, two) = (gamma(1.0 + 1.0 / 1.8), gamma(1.0 + 2.0 / 1.8));
                [3.0 * one, 3.0 * (two - one * one).sqrt()]
            },
            1e-8,
        ),
        ("sample", of(Law::sample(&[1.0, 2.0, 2.0, 3.0])), [2.0, 0.5f64.sqrt()], 1e-12),
    ] {
        assert_close(what, found.mean, mean, accuracy);
        assert_close(what, found.sd, sd, accuracy);
    }
    assert_eq!(Law::pareto(0.0, 1.0, 0.6).unwrap().moments(), None);
}
