//! Laws and correlations against closed forms that the crate does not use.

use standfast_probability::copula::{Copula, CopulaError, Correlation, CorrelationMeasure};
use standfast_probability::law::{Distribution, Law, LawError, Tails};
use standfast_probability::normal;

/// ∫ φ(z) f(z) dz by the trapezoidal rule on |z| ≤ 12: no code of the crate.
fn mean(f: impl Fn(f64) -> f64) -> f64 {
    mean_by(256, f)
}

/// Integral by so many steps a unit: 16 have all digits of what is smooth.
fn mean_by(steps: i32, f: impl Fn(f64) -> f64) -> f64 {
    let h = 1.0 / f64::from(steps);
    (-12 * steps..=12 * steps)
        .map(|i| f64::from(i) * h)
        .map(|z| h * (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt() * f(z))
        .sum()
}

fn moments(law: &Distribution) -> (f64, f64) {
    let m = mean(|z| law.value(z));
    (m, mean(|z| (law.value(z) - m).powi(2)).sqrt())
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() <= relative, "{what}: {value} where {expected} is expected");
}

fn all() -> Vec<Distribution> {
    let normal = Law::normal(0.6, 0.1).unwrap();
    vec![
        normal.clone().into(),
        Law::lognormal(0.91, 0.19 * 0.91).unwrap().into(),
        Law::gumbel_of_mean(4.5, 0.9).unwrap().into(),
        Law::weibull(3.0, 1.4, 1.0).unwrap().into(),
        Law::gev(4.0, 0.7, 0.15).unwrap().into(),
        Law::gev(4.0, 0.7, -0.2).unwrap().into(),
        Law::uniform(6.8, 7.6).unwrap().into(),
        Law::triangular(1.0, 1.4, 4.0).unwrap().into(),
        Law::triangular(1.0, 4.0, 4.0).unwrap().into(),
        Law::triangular(1.0, 1.0, 4.0).unwrap().into(),
        Law::max_of(Law::gumbel(3.0, 0.4).unwrap().into(), 50.0).unwrap().into(),
        Law::gamma(0.4, 2.5, 1.0).unwrap().into(),
        Law::gamma(2.0, 0.3, 0.0).unwrap().into(),
        Law::beta(3.0, 2.0, 0.4, 0.8).unwrap().into(),
        Law::beta(0.4, 0.7, -1.0, 1.0).unwrap().into(),
        Law::exponential(0.6, 4.0).unwrap().into(),
        Law::pareto(4.0, 0.6, 0.2).unwrap().into(),
        Law::pareto(4.0, 0.6, -0.3).unwrap().into(),
        two_populations().into(),
        Distribution::truncated(two_populations(), 0.5, 6.0).unwrap(),
        Distribution::truncated(normal, 0.0, f64::INFINITY).unwrap(),
        Distribution::truncated(Law::gumbel_of_mean(4.5, 0.9).unwrap(), 1.0, 6.0).unwrap(),
    ]
}

/// Storms of two kinds.
fn two_populations() -> Law {
    let often = Law::gumbel(1.0, 0.4).unwrap().into();
    let rare = Law::lognormal(5.0, 0.5).unwrap().into();
    Law::mixture(vec![(0.97, often), (0.03, rare)]).unwrap()
}

/// A value's normal gives back the value, far into both tails; the tails add up to one and rise with the value.
#[test]
fn values_and_normals_belong_together() {
    for law in all() {
        let mut last = f64::NEG_INFINITY;
        for i in -80..=80 {
            let z = f64::from(i) / 10.0;
            let x = law.value(z);
            assert!(x >= last, "{law:?} at {z}");
            last = x;
            let tails = law.tails(x);
            assert!((tails.below + tails.above - 1.0).abs() < 1e-14, "{law:?} at {x}: {tails:?}");
            // A law with an end has few numbers near it.
            let (from, to) = law.support();
            let near = (x - from).abs().min((to - x).abs()) < 1e-9 * x.abs();
            if !near {
                assert!((law.z(x) - z).abs() < 2e-6 * z.abs().max(1.0), "{law:?} at {z}: {x}, {}", law.z(x));
                let chance = Tails::of(z);
                let (low, high) = (law.value(z - 1e-5), law.value(z + 1e-5));
                let drawn = law.value_of_chance(normal::below(z));
                assert!(
                    (low <= drawn && drawn <= high) || chance.above < 1e-9,
                    "{law:?} at {z}: {drawn}, {x}"
                );
            }
        }
        let (from, to) = law.support();
        assert!(law.z(from) == f64::NEG_INFINITY && law.z(to) == f64::INFINITY, "{law:?}");
        assert!(law.value(-40.0) >= from && law.value(40.0) <= to);
    }
}

/// Means and deviations in closed form: Γ for Weibull's law and the general one, thirds for the triangle, Mills' ratio for the
/// truncated normal; a Gumbel maximum of n is one with its mode moved by scale · ln n.
#[test]
fn means_and_deviations_are_the_closed_forms() {
    let check = |what: &str, law: Law, m: f64, s: f64| {
        let (mean, sd) = moments(&law.into());
        assert_close(what, mean, m, 1e-7);
        assert_close(what, sd, s, 1e-6);
    };
    let gamma = libm::tgamma;
    check("normal", Law::normal(0.6, 0.1).unwrap(), 0.6, 0.1);
    check("lognormal", Law::lognormal(0.91, 0.173).unwrap(), 0.91, 0.173);
    check("gumbel", Law::gumbel_of_mean(4.5, 0.9).unwrap(), 4.5, 0.9);
    let (g1, g2) = (gamma(1.0 + 1.0 / 1.4), gamma(1.0 + 2.0 / 1.4));
    check("weibull", Law::weibull(3.0, 1.4, 1.0).unwrap(), 1.0 + 3.0 * g1, 3.0 * (g2 - g1 * g1).sqrt());
    let (g1, g2) = (gamma(1.0 - 0.15), gamma(1.0 - 0.3));
    let spread = 0.7 / 0.15 * (g2 - g1 * g1).sqrt();
    check("gev", Law::gev(4.0, 0.7, 0.15).unwrap(), 4.0 + 0.7 / 0.15 * (g1 - 1.0), spread);
    check("uniform", Law::uniform(1.0, 4.0).unwrap(), 2.5, 3.0 / 12f64.sqrt());
    let s = ((1.0 + 1.96 + 16.0 - 1.4 - 4.0 - 5.6) / 18.0f64).sqrt();
    check("triangular", Law::triangular(1.0, 1.4, 4.0).unwrap(), 6.4 / 3.0, s);
    let most = Law::max_of(Law::gumbel(3.0, 0.4).unwrap().into(), 50.0).unwrap();
    let moved: Distribution = Law::gumbel(3.0 + 0.4 * 50f64.ln(), 0.4).unwrap().into();
    for z in [-6.0, -1.0, 0.0, 2.0, 8.0] {
        assert_close("largest of 50", Distribution::from(most.clone()).value(z), moved.value(z), 1e-12);
    }
    let cut = Distribution::truncated(Law::normal(0.6, 0.1).unwrap(), 0.55, f64::INFINITY).unwrap();
    let ratio = normal::density(-0.5) / normal::above(-0.5);
    assert_close("truncated mean", mean(|z| cut.value(z)), 0.6 + 0.1 * ratio, 1e-7);
    assert_close("cut", cut.cut(), normal::below(-0.5), 1e-14);
}

/// Gamma and beta laws by integrals of 40 digits outside this repository, far into both tails; moments and parameters belong together.
#[test]
fn gamma_and_beta_are_the_integrals() {
    let gamma = [
        (
            0.3,
            [
                6.665_813_607_833_845e-31,
                0.001_509_222_188_442_643,
                0.244_123_787_734_806_8,
                4.354_136_307_523_037,
            ],
        ),
        (
            2.5,
            [4.039_567_564_125_067e-4, 1.027_995_134_630_593_4, 2.988_121_031_604_304, 9.910_724_094_625_814],
        ),
        (
            40.0,
            [12.816_907_251_050_334, 33.701_999_822_335_736, 42.897_873_662_972_22, 61.658_473_342_432_73],
        ),
    ];
    for (shape, values) in gamma {
        let law: Distribution = Law::gamma(2.0, shape, 0.0).unwrap().into();
        for (z, value) in [-6.0, -1.0, 0.5, 3.0].into_iter().zip(values) {
            assert_close(&format!("gamma {shape} at {z}"), law.value(z), 2.0 * value, 2e-13);
        }
    }
    let far: Distribution = Law::gamma(1.0, 40.0, 0.0).unwrap().into();
    assert_close("gamma at 8", far.value(8.0), 113.252_074_498_913_63, 1e-13);
    let beta = [
        (
            (0.4, 0.7),
            [
                4.930_062_660_301_462e-23,
                0.016_111_716_235_162_11,
                0.551_757_790_620_942_9,
                0.999_767_635_089_663_9,
            ],
        ),
        (
            (3.0, 2.0),
            [
                6.272_297_903_482_874e-4,
                0.381_597_574_496_040_1,
                0.722_693_295_037_393_5,
                0.984_847_600_653_449_6,
            ],
        ),
        (
            (30.0, 50.0),
            [
                0.114_235_666_082_107_47,
                0.320_912_785_213_698_5,
                0.401_327_255_352_319_2,
                0.541_574_675_643_031_5,
            ],
        ),
    ];
    for ((a, b), values) in beta {
        let law: Distribution = Law::beta(a, b, 0.0, 1.0).unwrap().into();
        let turned: Distribution = Law::beta(b, a, 0.0, 1.0).unwrap().into();
        for (z, value) in [-6.0, -1.0, 0.5, 3.0].into_iter().zip(values) {
            assert_close(&format!("beta {a}, {b} at {z}"), law.value(z), value, 2e-13);
            assert!((1.0 - turned.value(-z) - value).abs() < 1e-13, "turned at {z}");
        }
    }
    let of = |law: Result<Law, LawError>, m: f64, s: f64| {
        let (mean, sd) = moments(&law.unwrap().into());
        assert_close("mean", mean, m, 1e-7);
        assert_close("sd", sd, s, 1e-6);
    };
    of(Law::gamma(0.4, 2.5, 1.0), 2.0, 0.4 * 2.5f64.sqrt());
    of(Law::gamma_of_mean(2.0, 0.3, 1.0), 2.0, 0.3);
    of(Law::beta_of_mean(0.6, 0.05, 0.4, 0.8), 0.6, 0.05);
    of(Law::beta(3.0, 2.0, 0.0, 1.0), 0.6, 0.2);
    of(Law::exponential(0.6, 4.0), 4.6, 0.6);
    // Mean σ/(1 − ξ), variance σ²/((1 − ξ)²(1 − 2ξ)).
    of(Law::pareto(4.0, 0.6, 0.2), 4.75, 0.75 / 0.6f64.sqrt());
    of(Law::pareto(4.0, 0.6, -0.3), 4.0 + 0.6 / 1.3, 0.6 / 1.3 / 1.6f64.sqrt());
    // A shape near zero is as good as the exponential law.
    let near: Distribution = Law::pareto(0.0, 1.0, 1e-12).unwrap().into();
    let none: Distribution = Law::exponential(1.0, 0.0).unwrap().into();
    for z in [-6.0, 0.0, 7.0] {
        assert_close("near zero", near.value(z), none.value(z), 1e-9);
    }
}

/// A law by its values at some normals: those values, straight between two, and near to the law they are of where they are many.
#[test]
fn quantiles_are_met() {
    let law: Distribution = Law::quantiles(&[-1.0, 0.0, 2.0], &[1.0, 2.0, 5.0]).unwrap().into();
    for (z, x) in [(-1.0, 1.0), (0.0, 2.0), (2.0, 5.0)] {
        assert_eq!(law.value(z), x);
        assert!((law.z(x) - z).abs() < 1e-14);
    }
    // Straight beyond the ends.
    assert_eq!([law.value(-3.0), law.value(4.0)], [-1.0, 8.0]);
    let straight: Distribution = Law::quantiles(&[-1.0, 1.0], &[0.5, 0.7]).unwrap().into();
    let normal: Distribution = Law::normal(0.6, 0.1).unwrap().into();
    let gumbel: Distribution = Law::gumbel_of_mean(4.5, 0.9).unwrap().into();
    let normals: Vec<f64> = (-9 * 64..=9 * 64).map(|i| f64::from(i) / 64.0).collect();
    let values: Vec<f64> = normals.iter().map(|z| gumbel.value(*z)).collect();
    let many: Distribution = Law::quantiles(&normals, &values).unwrap().into();
    let mut last = f64::NEG_INFINITY;
    for i in -800..=800 {
        let z = f64::from(i) / 100.0 + 0.003;
        assert_close("straight", straight.value(z), normal.value(z), 1e-12);
        assert!((many.value(z) - gumbel.value(z)).abs() < 2e-7, "{z}");
        assert!((many.z(many.value(z)) - z).abs() < 1e-9, "{z}");
        assert!(law.value(z) > last, "{z}");
        last = law.value(z);
    }
}

/// The tails of a mixture are those of its parts by their shares; its far tail is the rare part's.
#[test]
fn a_mixture_is_its_parts() {
    let law: Distribution = two_populations().into();
    let [often, rare]: [Distribution; 2] =
        [Law::gumbel(1.0, 0.4).unwrap().into(), Law::lognormal(5.0, 0.5).unwrap().into()];
    for x in [0.2, 1.0, 2.7, 5.0, 7.5] {
        assert_close(
            "above",
            law.tails(x).above,
            0.97 * often.tails(x).above + 0.03 * rare.tails(x).above,
            1e-14,
        );
        assert_close("back", law.value(law.z(x)), x, 1e-9);
    }
    // A gap between the parts: no value lies in it, and the normals of its ends are one.
    let apart = |from, to| Distribution::from(Law::uniform(from, to).unwrap());
    let gap: Distribution =
        Law::mixture(vec![(0.3, apart(0.0, 1.0)), (0.7, apart(2.0, 3.0))]).unwrap().into();
    let at = normal::quantile(0.3);
    assert!((gap.z(1.5) - at).abs() < 1e-12);
    assert!(gap.value(at - 1e-9) <= 1.0 && gap.value(at + 1e-9) >= 2.0);
    assert_eq!(gap.breaks(), [0.0, 1.0, 2.0, 3.0]);
}

/// Values with probabilities of their own: an interval from a boundary on has what lies at it; bounds keep what lies at them.
#[test]
fn values_of_their_own_lie_above_their_boundary() {
    let law: Distribution = Law::discrete(&[0.6, 0.4, 0.5], &[0.2, 0.3, 0.5]).unwrap().into();
    assert_eq!(law.support(), (0.4, 0.6));
    for (x, below) in [(0.3, 0.0), (0.4, 0.0), (0.45, 0.3), (0.5, 0.3), (0.55, 0.8), (0.6, 0.8), (0.7, 1.0)] {
        let tails = law.tails(x);
        assert!(
            (tails.below - below).abs() < 1e-15 && (tails.above - (1.0 - below)).abs() < 1e-15,
            "{x}: {tails:?}"
        );
    }
    for (z, value) in [(-9.0, 0.4), (-0.53, 0.4), (-0.52, 0.5), (0.84, 0.5), (0.85, 0.6), (9.0, 0.6)] {
        assert_eq!(law.value(z), value, "{z}");
    }
    assert_close(
        "least of many",
        Distribution::from(Law::discrete(&[1.0, 2.0], &[1e-9, 1.0 - 1e-9]).unwrap()).tails(1.5).below,
        1e-9,
        1e-14,
    );
    // Bounds at two of the values.
    let plain = Law::discrete(&[0.4, 0.5, 0.6], &[0.3, 0.5, 0.2]).unwrap();
    let cut = Distribution::truncated(plain.clone(), 0.5, 0.6).unwrap();
    assert_close("cut", cut.cut(), 0.3, 1e-15);
    assert_close("the first left", cut.tails(0.55).below, 5.0 / 7.0, 1e-15);
    assert_close("the last left", cut.tails(0.6).above, 2.0 / 7.0, 1e-14);
    let one = Distribution::truncated(plain, 0.5, 0.5).unwrap();
    assert_eq!([-9.0, 0.0, 9.0].map(|z| one.value(z)), [0.5; 3]);
    // A sample counts what stands twice, and the largest of several has the power.
    let sample = Law::sample(&[3.0, 1.0, 2.0, 2.0]).unwrap();
    let most: Distribution = Law::max_of(sample.into(), 3.0).unwrap().into();
    assert_close("none above 2", most.tails(2.5).below, 0.75f64.powi(3), 1e-14);
    assert_eq!(most.value(-1.0), 2.0);
    assert!(most.is_discrete());
}

/// F of a return value is 1 − 1/years.
#[test]
fn return_values_are_met() {
    let law: Distribution = Law::gumbel_of_returns((10.0, 5.4), (100.0, 6.9)).unwrap().into();
    assert_close("10 years", law.tails(5.4).above, 0.1, 1e-12);
    assert_close("100 years", law.tails(6.9).above, 0.01, 1e-12);
    assert!(matches!(
        Law::gumbel_of_returns((10.0, 6.9), (100.0, 5.4)),
        Err(LawError::Parameter { parameter: "value", .. })
    ));
    assert!(matches!(
        Law::gumbel_of_returns((1.0, 6.9), (100.0, 5.4)),
        Err(LawError::Parameter { parameter: "years", value: 1.0, .. })
    ));
}

/// Wrong parameters are named with their values; nothing is left between bounds.
#[test]
fn wrong_laws_are_refused() {
    let refused = |law: Result<Law, LawError>, name: &str, which: &str| match law {
        Err(LawError::Parameter { law, parameter, .. }) => assert_eq!((law, parameter), (name, which)),
        other => panic!("{name}, {which}: {other:?}"),
    };
    refused(Law::normal(0.6, 0.0), "normal", "sd");
    refused(Law::normal(f64::NAN, 1.0), "normal", "mean");
    refused(Law::lognormal(-1.0, 1.0), "lognormal", "mean");
    refused(Law::gumbel(0.0, -1.0), "gumbel", "scale");
    refused(Law::weibull(1.0, 0.0, 0.0), "weibull", "shape");
    refused(Law::gev(0.0, f64::INFINITY, 0.1), "gev", "scale");
    refused(Law::uniform(2.0, 2.0), "uniform", "to");
    refused(Law::triangular(1.0, 5.0, 4.0), "triangular", "mode");
    refused(Law::gamma(1.0, -2.0, 0.0), "gamma", "shape");
    refused(Law::gamma_of_mean(1.0, 0.2, 1.5), "gamma", "mean");
    refused(Law::beta(1.0, 2.0, 1.0, 1.0), "beta", "to");
    refused(Law::beta_of_mean(0.9, 0.2, 0.4, 0.8), "beta", "mean");
    refused(Law::beta_of_mean(0.6, 0.2, 0.4, 0.8), "beta", "sd");
    refused(Law::exponential(0.0, 1.0), "exponential", "scale");
    refused(Law::pareto(0.0, 1.0, f64::NAN), "gpd", "shape");
    let list = |law: Result<Law, LawError>| law.unwrap_err().to_string();
    let whole = Distribution::from(Law::normal(0.0, 1.0).unwrap());
    for (law, message) in [
        (
            Law::discrete(&[1.0, 2.0], &[1.0]),
            "the law discrete: 2 values and 1 probabilities; expected one probability for each value",
        ),
        (
            Law::discrete(&[1.0, 2.0], &[0.5, 0.6]),
            "the law discrete: the probabilities add up to 1.1; expected 1",
        ),
        (
            Law::discrete(&[1.0, 2.0], &[1.2, -0.2]),
            "the law discrete: a probability is 1.2; expected more than 0 and at most 1",
        ),
        (
            Law::discrete(&[1.0, 1.0], &[0.5, 0.5]),
            "the law discrete: a value stands twice; expected each once",
        ),
        (
            Law::quantiles(&[0.0], &[1.0]),
            "the law quantiles: 1 values for 1 places; expected two or more of each",
        ),
        (
            Law::quantiles(&[0.0, 1.0, 2.0], &[1.0, 3.0, 2.0]),
            "the law quantiles: values 3 and 2 follow each other; expected numbers that rise",
        ),
        (Law::sample(&[]), "the law sample: no values; expected one or more"),
        (Law::sample(&[1.0, f64::NAN]), "the law sample: a value is NaN; expected numbers"),
        (Law::mixture(vec![(1.0, whole.clone())]), "the law mixture: 1 law; expected two or more"),
        (
            Law::mixture(vec![(0.5, whole.clone()), (0.4, whole)]),
            "the law mixture: the probabilities add up to 0.9; expected 1",
        ),
    ] {
        assert_eq!(list(law), message);
    }
    refused(Law::max_of(Law::normal(0.0, 1.0).unwrap().into(), 0.5), "max_of", "count");
    let law = || Law::uniform(0.0, 1.0).unwrap();
    for (lower, upper) in [(1.0, 2.0), (0.6, 0.5), (f64::NAN, 1.0), (0.5, 0.5)] {
        assert!(
            matches!(Distribution::truncated(law(), lower, upper), Err(LawError::Empty { .. })),
            "{lower} {upper}"
        );
    }
    let message = Law::normal(0.6, -0.1).unwrap_err().to_string();
    assert_eq!(message, "sd = -0.1 of the law normal: expected a number above 0");
}

/// Of lognormals the values' correlation is a closed form: ρ_z = ln(1 + ρ c₁ c₂)/(ζ₁ ζ₂), and so are its bounds. Of ranks it is
/// 12 E[Φ(z₁)Φ(z₂)] − 3.
#[test]
fn measures_of_correlation_are_the_closed_forms() {
    let (c1, c2) = (0.19, 0.8);
    let laws: Vec<Distribution> =
        vec![Law::lognormal(0.91, 0.91 * c1).unwrap().into(), Law::lognormal(2.0, 2.0 * c2).unwrap().into()];
    let zeta = |c: f64| (1.0 + c * c).ln().sqrt();
    let pair = |measure| Copula::new(&laws, &[Correlation { first: 0, second: 1, measure }]);
    for rho in [-0.5, 0.3, 0.9] {
        let found = pair(CorrelationMeasure::Linear(rho)).unwrap().between(0, 1);
        assert_close("linear", found, (1.0 + rho * c1 * c2).ln() / (zeta(c1) * zeta(c2)), 1e-9);
        let rank = pair(CorrelationMeasure::Rank(rho)).unwrap().between(1, 0);
        let across = (1.0 - rank * rank).sqrt();
        let spearman = 12.0
            * mean_by(16, |z| normal::below(z) * mean_by(16, |w| normal::below(rank * z + across * w)))
            - 3.0;
        assert_close("rank", spearman, rho, 1e-10);
    }
    // Of a normal and a Gumbel law ρ_z = ρ σ/E[x(z) z], by quadrature of 30 digits outside this repository; of uniform laws that of ranks.
    let gumbel = |mean: f64, sd: f64| -> Distribution { Law::gumbel_of_mean(mean, sd).unwrap().into() };
    let uniform = |from, to| -> Distribution { Law::uniform(from, to).unwrap().into() };
    let linear = Correlation { first: 0, second: 1, measure: CorrelationMeasure::Linear(0.4) };
    let normal_and_gumbel = [Law::normal(0.6, 0.1).unwrap().into(), gumbel(0.4, 0.1)];
    let found = Copula::new(&normal_and_gumbel, &[linear]).unwrap().between(0, 1);
    assert_close("of Gumbel", found, 0.412_598_985_962_068_3, 1e-13);
    let found = Copula::new(&[uniform(0.0, 1.0), uniform(2.0, 5.0)], &[linear]).unwrap().between(0, 1);
    assert_close("of uniform laws", found, 2.0 * (std::f64::consts::PI * 0.4 / 6.0).sin(), 1e-12);
    let bounds = [-1.0, 1.0].map(|sign| (sign * zeta(c1) * zeta(c2)).exp_m1() / (c1 * c2));
    match pair(CorrelationMeasure::Linear(-0.95)) {
        Err(CopulaError::Unattainable { value, from, to, beside_others, .. }) => {
            assert_eq!((value, beside_others), (-0.95, false));
            assert_close("least", from, bounds[0], 1e-9);
            assert_close("most", to, bounds[1], 1e-9);
        }
        other => panic!("{other:?}"),
    }
}

/// Three inputs: with 0.9 and 0.9 the third correlation has to lie above 0.62: 0.81 ∓ 0.19.
#[test]
fn a_matrix_that_is_none_names_the_pair() {
    let laws = vec![Distribution::from(Law::normal(0.0, 1.0).unwrap()); 3];
    let of = |first, second, value| Correlation { first, second, measure: CorrelationMeasure::Normal(value) };
    match Copula::new(&laws, &[of(0, 1, 0.9), of(0, 2, 0.5), of(1, 2, -0.5)]) {
        Err(CopulaError::Unattainable { first: 1, second: 2, from, to, beside_others: true, .. }) => {
            let (middle, half) = (0.45, (0.19f64 * 0.75).sqrt());
            assert!(
                (from - (middle - half)).abs() < 1e-6 && (to - (middle + half)).abs() < 1e-6,
                "{from} {to}"
            );
        }
        other => panic!("{other:?}"),
    }
    assert!(matches!(Copula::new(&laws, &[of(1, 1, 0.2)]), Err(CopulaError::Pair { .. })));
    assert!(matches!(Copula::new(&laws, &[of(0, 3, 0.2)]), Err(CopulaError::Pair { .. })));
    assert!(matches!(Copula::new(&laws, &[of(0, 1, 0.2), of(1, 0, 0.3)]), Err(CopulaError::Twice { .. })));
    assert!(matches!(Copula::new(&laws, &[of(0, 1, 1.5)]), Err(CopulaError::Unattainable { .. })));
    assert!(matches!(Copula::new(&laws, &[of(0, 1, f64::NAN)]), Err(CopulaError::Unattainable { .. })));
    // z = L u and back; the products of L's rows are the correlations.
    let copula = Copula::new(&laws, &[of(0, 1, 0.9), of(0, 2, 0.5), of(1, 2, 0.3)]).unwrap();
    let u = [0.3, -1.2, 2.0];
    for (a, b) in copula.independent_of(&copula.correlated(&u)).iter().zip(u) {
        assert!((a - b).abs() < 1e-14);
    }
    let unit =
        |i: usize| copula.correlated(&std::array::from_fn::<f64, 3, _>(|j| f64::from(u8::from(i == j))));
    let product = |a: usize, b: usize| (0..3).map(|i| unit(i)[a] * unit(i)[b]).sum::<f64>();
    for (a, b, rho) in [(0, 0, 1.0), (0, 1, 0.9), (0, 2, 0.5), (1, 2, 0.3)] {
        assert!((product(a, b) - rho).abs() < 1e-14);
    }
}
