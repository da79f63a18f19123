//! Laws fitted to values, and laws that depend on another number, against integrals written out here.

mod common;

use common::{mean, try_chances};
use standfast_cases::random::{ChanceRequest, Effort, Method, Probability};
use standfast_cases::{CaseFile, Document};
use standfast_probability::normal::below;

/// A slender block of friction 0.8.
fn point(random: &str) -> String {
    common::POINT.replace("mu = 0.5", "mu = 0.8") + random
}

fn answer(random: &str) -> Probability {
    try_chances(&point(random), 0.005)
        .unwrap_or_else(|error| panic!("{random}\n{}", standfast_cases::report(&error)))
}

/// Yearly maxima of k, made up; Gumbel's likeliest law by a root of its equation, with the inverse of its second derivatives: mode, its error, scale,
/// the error of its logarithm, and their correlation (scipy, as in the tests of fits, of ten times these).
const FITTED: &str = "k = { fitted = { law = \"gumbel\", values = [0.41, 0.52, 0.38, 0.46, 0.60, 0.44, 0.39, 0.55, 0.49, 0.42] }, every = \"year\" }\n";
const MODE: [f64; 2] = [0.4336518944839044, 0.017979813];
const SCALE: [f64; 2] = [0.05402006084562867, 0.25879764];
const CORRELATION: f64 = 0.3119415690501845;

/// The mean over both parameters.
fn over_parameters(f: impl Fn(f64, f64) -> f64) -> f64 {
    let across = (1.0 - CORRELATION * CORRELATION).sqrt();
    mean(|z| {
        let of_mode = MODE[0] + MODE[1] * z;
        mean(|w| f(of_mode, SCALE[0] * (SCALE[1] * (CORRELATION * z + across * w)).exp()))
    })
}

/// A force that exceeds a certain friction, of an event and over a life: the parameters are drawn once for all years.
#[test]
fn a_law_that_is_fitted_has_parameters_for_a_life() {
    let found = answer(&format!("years = 30\n{FITTED}"));
    let exceeds = |mode: f64, scale: f64| -(-(-(0.8 - mode) / scale).exp()).exp_m1();
    // μ of the point is 0.8.
    let event = over_parameters(exceeds);
    let life = over_parameters(|mode, scale| 1.0 - (1.0 - exceeds(mode, scale)).powi(30));
    let chances = &found.situations[0];
    assert_eq!(chances.method, Method::Integrate);
    assert!((chances.not_rest.value / event - 1.0).abs() < 1e-4, "{:?} {event}", chances.not_rest);
    let of_life = chances.life.as_ref().unwrap().not_rest;
    assert!(
        (of_life.value - life).abs() <= (of_life.high - of_life.low).max(1e-4 * life),
        "{of_life:?} {life}"
    );
    // A law whose parameters were known would be less likely to exceed it, of an event.
    assert!(event > 1.1 * exceeds(MODE[0], SCALE[0]));
    let names: Vec<&str> = found.random.iter().map(|number| number.name.as_str()).collect();
    assert_eq!(names, ["k", "k.mode", "k.scale"]);
    let text = found.text(&()).split_whitespace().collect::<Vec<_>>().join(" ");
    let words = "k is gumbel, fitted to 10 values: mode 0.4337 ± 0.01798, scale 0.05402 ± 25.88 %. What they leave uncertain is drawn once";
    assert!(text.contains(words), "{text}");
    let json: serde_json::Value = serde_json::from_str(&found.json(&(), &[])).unwrap();
    let fit = &json["random"][0]["fit"];
    assert_eq!((&fit["law"], &fit["number"]), (&"gumbel".into(), &10.into()));
    assert!((fit["parameters"][1]["standard_error"].as_f64().unwrap() - SCALE[1]).abs() < 1e-5);
    assert_eq!(json["random"][1].get("fit"), None);
    // Everything drawn says the same.
    let effort = Effort { points: 1 << 21, precision: 0.01, ..Effort::default() };
    let request = ChanceRequest { method: Some(Method::MonteCarlo), effort, ..ChanceRequest::default() };
    let drawn = Probability::of(&CaseFile::parse("case.toml", &point(FITTED)).unwrap(), request)
        .unwrap()
        .situations[0]
        .not_rest;
    assert!(drawn.low <= event && event <= drawn.high, "{drawn:?} {event}");
}

/// Mean and deviation of friction under a force.
type Moments<'a> = &'a dyn Fn(f64) -> (f64, f64);

/// Friction that depends on the force: ∫ φ(z) Φ((k − m(k))/0.05) dz, where m is straight between points, and by a power and an exponential function.
#[test]
fn a_law_may_depend_on_another_number() {
    let k = |z: f64| 0.5 + 0.1 * z;
    let force = "k = { normal = { mean = 0.5, sd = 0.1 }, every = \"year\" }\n";
    let straight = |k: f64| 0.9 - 0.4 * ((k - 0.4) / 0.2).clamp(0.0, 1.0);
    let cases: [(&str, Moments<'_>); 3] = [
        ("normal = { mean = { at = [0.4, 0.6], is = [0.9, 0.5] }, sd = 0.05 }", &|k| (straight(k), 0.05)),
        ("normal = { mean = { constant = 0.1, factor = 0.8, power = 0.5 }, cov = 0.1 }", &|k| {
            (0.1 + 0.8 * k.max(0.0).sqrt(), 0.01 + 0.08 * k.max(0.0).sqrt())
        }),
        ("normal = { mean = 0.8, sd = { constant = 0.05, factor = 0.2, rate = -3 } }", &|k| {
            (0.8, 0.05 + 0.2 * (-3.0 * k).exp())
        }),
    ];
    for (law, moments) in cases {
        let random = format!("{force}mu = {{ {law}, given = \"k\", every = \"year\" }}\n");
        let found = answer(&random);
        let slides = |z: f64| {
            let (m, s) = moments(k(z));
            below((k(z) - m) / s)
        };
        let by_hand = mean(slides);
        let event = found.situations[0].not_rest.value;
        assert!((event / by_hand - 1.0).abs() < 1e-5, "{law}: {event} {by_hand}");
        let life = answer(&format!("years = 20\n{random}")).situations[0].life.as_ref().unwrap().not_rest;
        let by_hand = 1.0 - (1.0 - by_hand).powi(20);
        assert!((life.value / by_hand - 1.0).abs() < 1e-4, "{law}: {life:?} {by_hand}");
    }
}

/// At the index of the nearest point itself design values are that point, also of laws that depend on others.
#[test]
fn design_values_at_the_nearest_index_are_the_nearest_point() {
    let laws = "k = { normal = { mean = 0.4, sd = 0.08 } }\nmu = { normal = { mean = { at = [0.3, 0.5], is = [0.9, 0.7] }, sd = 0.05 }, given = \"k\" }\n";
    let beta = answer(laws).situations[0].design_point.as_ref().unwrap().beta;
    let found = answer(&format!("target_beta = {beta}\n{laws}"));
    let chances = &found.situations[0];
    let (point, design) = (chances.design_point.as_ref().unwrap(), chances.design_values.as_ref().unwrap());
    for (value, at_point) in design.numbers.iter().zip(&point.values) {
        assert!((value.value / at_point - 1.0).abs() < 1e-9, "{value:?} {at_point}");
    }
}

/// The mean, over what the fit leaves open, of a function of the force and its normal, by a coarse rule, of what is smooth.
fn mean_by_hand(of: impl Fn(f64, f64) -> f64) -> f64 {
    let coarse = |f: &dyn Fn(f64) -> f64| {
        let step = |i: i32| f64::from(i) / 8.0;
        let density = |z: f64| (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
        (-64..=64).map(|i| density(step(i)) * f(step(i)) / 8.0).sum::<f64>()
    };
    let across = (1.0 - CORRELATION * CORRELATION).sqrt();
    let at = |z: f64, w: f64, u: f64| {
        let scale = SCALE[0] * (SCALE[1] * (CORRELATION * z + across * w)).exp();
        of(MODE[0] + MODE[1] * z - scale * (-below(u).ln()).ln(), u)
    };
    coarse(&|z| coarse(&|w| coarse(&|u| at(z, w, u))))
}

/// Laws in a chain: of a force by its fit, and of friction by the force.
#[test]
fn laws_depend_on_each_other_in_a_chain() {
    let random = format!(
        "{FITTED}mu = {{ normal = {{ mean = {{ at = [-4, 4], is = [0.4, 1.2] }}, sd = 0.05 }}, given = \"k\", every = \"year\" }}\n"
    );
    let found = answer(&random);
    let by_hand = mean_by_hand(|k, _| below((k - 0.8 - 0.1 * k) / 0.05));
    let e = found.situations[0].not_rest;
    assert!((e.value - by_hand).abs() < (e.high - e.low).max(1e-4 * by_hand), "{e:?} {by_hand}");
}

/// A direction with a few values, each with a law of its own: the sea of each sector, of events by Poisson's law.
#[test]
fn sectors_have_their_own_laws() {
    let random = "years = 10\nevents_per_year = 4\n\
                  k_prime = { discrete = { values = [0, 0.3], probabilities = [0.7, 0.3] }, every = \"event\" }\n\
                  k = { gumbel = { mode = { at = [0, 0.3], is = [0.3, 0.4] }, scale = 0.06 }, given = \"k_prime\", every = \"event\" }\n";
    let found = answer(random);
    // It slides where k exceeds μ = 0.8, whatever the elevation.
    let exceeds = |mode: f64| -(-(-(0.8 - mode) / 0.06).exp()).exp_m1();
    let event = 0.7 * exceeds(0.3) + 0.3 * exceeds(0.4);
    let chances = &found.situations[0];
    assert!((chances.not_rest.value / event - 1.0).abs() < 1e-9, "{:?} {event}", chances.not_rest);
    let life = chances.life.as_ref().unwrap().not_rest.value;
    assert!((life / -(-40.0 * event).exp_m1() - 1.0).abs() < 1e-9, "{life} {event}");
}

/// A fitted number goes with another by their normals, whatever its parameters are: the two are both high in P(k > 0.8, k' low) by hand.
#[test]
fn a_fitted_number_may_be_correlated() {
    let random = format!(
        "{FITTED}mu = {{ normal = {{ mean = 0.8, sd = 0.1 }}, every = \"year\" }}\n[[random.correlation]]\nbetween = [\"k\", \"mu\"]\nnormal = 0.6\n"
    );
    let e = answer(&random).situations[0].not_rest;
    // Friction has the mean 0.8 + 0.1 · 0.6 u and 0.8 of its deviation given the force.
    let by_hand = mean_by_hand(|k, u| below((k - 0.8 - 0.06 * u) / 0.08));
    assert!((e.value - by_hand).abs() < (e.high - e.low).max(1e-4 * by_hand), "{e:?} {by_hand}");
}

#[test]
fn what_cannot_be_fitted_or_given_is_refused() {
    let force = "k = { normal = { mean = 0.5, sd = 0.1 }, every = \"year\" }\n";
    let values = "[0.41, 0.52, 0.38, 0.46, 0.60]";
    for (random, expected) in [
        (format!("{force}mu = {{ normal = {{ mean = {{ at = [0, 1], is = [1, 1] }}, sd = 0.1 }}, given = \"k\" }}\n"), "`k`, which is drawn more often; expected every = \"year\" for both"),
        (format!("{force}mu = {{ normal = {{ mean = {{ at = [0, 1], is = [1, 1] }}, sd = 0.1 }} }}\n"), "a function of another needs `given`"),
        (format!("{force}mu = {{ normal = {{ mean = 0.5, sd = 0.1 }}, given = \"k\", every = \"year\" }}\n"), "no parameter of its law is a function of it"),
        (format!("{force}mu = {{ normal = {{ mean = {{ at = [0, 1], is = [1, 1] }} }}, given = \"k\", every = \"year\" }}\n"), "expected `mean` and `sd`, or `mean` and `cov`"),
        (format!("{force}mu = {{ normal = {{ mean = {{ at = [0, 1], is = [1] }}, sd = 0.1 }}, given = \"k\", every = \"year\" }}\n"), "as many values in `is` as in `at`; they have 1 and 2"),
        (format!("{force}mu = {{ normal = {{ mean = {{ at = [0, 1], is = [0.1, -0.1] }}, cov = 0.1 }}, given = \"k\", every = \"year\" }}\n"), "of the law of `mu` lies where it is negative"),
        (format!("{force}mu = {{ normal = {{ mean = {{ factor = 1 }}, cov = 0.1 }}, given = \"k\", every = \"year\" }}\n"), "or `factor` with `power` or `rate`"),
        (format!("{force}mu = {{ triangular = {{ from = 0.1, mode = {{ factor = 1, power = 1 }}, to = 2 }}, given = \"k\", every = \"year\" }}\n"), "expected one of the laws normal, lognormal"),
        (format!("{force}mu = {{ normal = {{ mean = {{ factor = 1, power = 1 }}, cov = 0.1 }}, given = \"force\", every = \"year\" }}\n"), "`mu` is given \"force\"; expected another random number, of k"),
        (format!("{force}mu = {{ normal = {{ mean = {{ factor = 1, power = 1 }}, cov = 0.1 }}, given = \"mu\", every = \"year\" }}\n"), "`mu` is given itself"),
        ("k = { normal = { mean = { factor = 1, power = 1 }, cov = 0.1 }, given = \"mu\" }\nmu = { normal = { mean = { factor = 1, power = 1 }, cov = 0.1 }, given = \"k\" }\n".to_owned(), "the laws of `k` and `mu` depend on each other in a circle"),
        (format!("k = {{ fitted = {{ law = \"triangular\", values = {values} }} }}\n"), "has no `triangular`; expected normal, lognormal, gumbel"),
        (format!("k = {{ fitted = {{ law = \"gumbel\", values = {values}, location = 1 }} }}\n"), "the law gumbel has none to be given"),
        ("k = { fitted = { law = \"gumbel\", values = [0.4, 0.5] } }\n".to_owned(), "2 values, 2 of them different; expected 5"),
        (format!("k = {{ max_of = {{ count = 9, fitted = {{ law = \"gumbel\", values = {values} }} }} }}\n"), "`max_of` of `k` has no `fitted`"),
        (format!("k = {{ fitted = {{ law = \"gpd\", values = {values} }} }}\n"), "lacks `location`, the threshold"),
        (format!("k = {{ fitted = {{ law = \"gpd\", values = {values}, location = 0.45 }} }}\n"), "the value 0.41; expected values above 0.45"),
        (format!("k = {{ fitted = {{ law = \"gumbel\", values = {values} }}, given = \"mu\" }}\nmu = {{ normal = {{ sd = 0.1 }} }}\n"), "`k` is fitted, and given another number"),
        (format!("{force}mu = {{ normal = {{ mean = {{ factor = 1, power = 1 }}, cov = 0.1 }}, given = \"k\", every = \"year\" }}\n[[random.correlation]]\nbetween = [\"k\", \"mu\"]\nrank = 0.2\n"), "expected no [[random.correlation]] with it"),
    ] {
        let error = try_chances(&point(&random), 0.1).expect_err(&random);
        assert!(error.to_string().contains(expected), "{error}\n{random}");
    }
}
