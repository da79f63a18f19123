//! Probabilities of cases against numbers of another program, printed where the method is described, and against sums by hand.

use standfast::Mode;
use standfast::initiation::Chart;
use standfast_cases::random::{Chances, Draws, Happening, Method, Probability, Request};
use standfast_probability::normal::below;
use standfast_probability::sample::Effort;

fn answer(text: &str, request: Request) -> Probability {
    Probability::of_text("case.toml", text, request)
        .unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)))
}

fn chance(chances: &Chances, mode: Mode) -> f64 {
    let of = chances.modes.iter().find(|(happening, _)| *happening == Happening::Mode(mode));
    of.map_or(0.0, |(_, estimate)| estimate.value)
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() <= relative, "{what}: {value} where {expected} is expected");
}

const POINT: &str = "[point]\ngamma = 0.8\nk_prime = 0.9167\n";

fn goda(random: &str) -> String {
    let text = include_str!("../../../examples/goda-2000.toml");
    format!("{text}\n[random]\n{random}")
}

/// Every mode of the plane by Simpson's rule in k between the report's named points, with the truncated normal laws and the
/// report's curves written out here.
#[test]
fn modes_of_the_plane_are_the_areas_between_the_reports_curves() {
    let random = "[random]\nmu = { normal = { mean = 0.6, sd = 0.1 }, lower = 0.0 }\n\
                  k = { normal = { mean = 0.45, sd = 0.12 }, lower = 0.0 }\n";
    let found = answer(&format!("{POINT}{random}"), Request::default());
    let chances = &found.situations[0];
    assert_eq!(chances.method, Method::Integrate);
    let (γ, k_prime) = (0.8, 0.9167);
    let chart = Chart::new(γ, k_prime).unwrap();
    let mass = [below(6.0), below(0.45 / 0.12)];
    let friction_below = |μ: f64| (below((μ.max(0.0) - 0.6) / 0.1) - below(-6.0)) / mass[0];
    let density = |k: f64| {
        (-0.5 * ((k - 0.45) / 0.12f64).powi(2)).exp() / (0.12 * (2.0 * std::f64::consts::PI).sqrt()) / mass[1]
    };
    let simpson = |from: f64, to: f64, f: &dyn Fn(f64) -> f64| {
        let n = 20_000;
        let h = (to - from) / f64::from(n);
        let weight = |i: i32| {
            if i == 0 || i == n {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            }
        };
        (0..=n).map(|i| weight(i) * f(from + f64::from(i) * h)).sum::<f64>() * h / 3.0
    };
    let (k_a, k_d) = (chart.k_a(), chart.k_d());
    let turning = |k: f64| 1.0 / γ - k * k_prime;
    let star = |k: f64| chart.mu_star().at(k);
    let end = 0.45 + 9.0 * 0.12;
    let rest = simpson(0.0, k_a, &|k| density(k) * (1.0 - friction_below(k)));
    let slide = simpson(0.0, k_a, &|k| density(k) * friction_below(k))
        + simpson(k_a, k_d, &|k| density(k) * friction_below(turning(k)));
    let both = simpson(k_a, k_d, &|k| density(k) * (friction_below(star(k)) - friction_below(turning(k))))
        + simpson(k_d, end, &|k| density(k) * friction_below(star(k)));
    let rock = simpson(k_a, end, &|k| density(k) * (1.0 - friction_below(star(k))));
    assert!((rest + slide + both + rock - 1.0).abs() < 1e-12);
    assert!(chart.k_e() > end, "μ* falls up to the end");
    for (mode, by_hand) in
        [(Mode::Rest, rest), (Mode::SlideLeft, slide), (Mode::SlideRockOLeft, both), (Mode::RockO, rock)]
    {
        assert_close(mode.symbol(), chance(chances, mode), by_hand, 1e-9);
    }
}

/// Φ(−β) is 8.5e-6 for both modes that meet at the corner A, where their probabilities are 2.7e-6 and 1.5e-6.
#[test]
fn a_corner_is_no_half_space() {
    let random = "[random]\nmu = { lognormal = { mean = 0.62, cov = 0.08 } }\nk = { lognormal = { mean = 0.35, cov = 0.15 } }\n";
    let found = answer(&format!("{POINT}{random}"), Request::default());
    let chances = &found.situations[0];
    assert_close("RO", chance(chances, Mode::RockO), 2.7e-6, 0.02);
    assert_close("SRO-", chance(chances, Mode::SlideRockOLeft), 1.5e-6, 0.02);
}

/// Over 50 years: 0.134 with a friction drawn once, 0.180 if it were drawn yearly.
#[test]
fn a_friction_drawn_once_is_not_one_drawn_yearly() {
    let life = |every: &str| {
        let random = format!(
            "[random]\nyears = 50\nmu = {{ lognormal = {{ mean = 0.6, cov = 0.15 }}{every} }}\n\
             k = {{ gumbel = {{ mean = 0.3, sd = 0.06 }}, lower = 0.0, every = \"year\" }}\n"
        );
        answer(&format!("{POINT}{random}"), Request::default()).situations[0]
            .life
            .clone()
            .unwrap()
            .not_rest
            .value
    };
    assert_close("once", life(""), 0.134, 0.004);
    assert_close("yearly", life(", every = \"year\""), 0.180, 0.004);
}

const FOUR: &str = "friction = { lognormal = { mean = 0.636, cov = 0.15 } }\n\
    bias.P = { lognormal = { mean = 0.91, cov = 0.19 } }\n\
    bias.U = { lognormal = { mean = 0.77, cov = 0.25 } }\n\
    wave.deep_water_height = { gumbel = { mean = \"4.5 m\", sd = \"0.9 m\" }, lower = \"1 m\" }\n";

/// Goda's caisson with four random numbers: P, β at the kink of the breaking limit, and what knowing each would gain.
#[test]
fn a_caisson_under_an_uncertain_sea() {
    let effort = Effort { precision: 0.01, ..Effort::default() };
    let found = answer(&goda(FOUR), Request { effort, ..Request::default() });
    let chances = &found.situations[0];
    assert_eq!(chances.method, Method::Sobol);
    assert_close("SL", chance(chances, Mode::SlideLeft), 0.0251, 0.01);
    let point = chances.design_point.as_ref().unwrap();
    assert_close("β", point.beta, 1.781, 3e-4);
    assert_close("Φ(−β)", point.first_order(), 0.0375, 3e-3);
    assert!(point.at_change);
    assert_close("height", point.values[3], 4.7318, 1e-4);
    // friction, bias.P, bias.U, height
    for (place, (alpha2, known)) in
        [(0.35, 0.0092), (0.55, 0.0026), (0.04, 0.0218), (0.06, 0.0143)].into_iter().enumerate()
    {
        assert!((point.alpha[place].powi(2) - alpha2).abs() < 0.006, "{place}: {}", point.alpha[place]);
        assert_close("if known", chances.known[place].value, known, 0.03);
    }
}

/// Three random numbers: integration, Sobol' points, points about the design point and plain Monte Carlo agree, the last within its
/// own interval; a rare failure is 1.2e-7.
#[test]
fn methods_agree() {
    let three = "friction = { lognormal = { mean = 0.636, cov = 0.15 } }\n\
        bias.P = { lognormal = { mean = 0.91, cov = 0.19 } }\n\
        wave.deep_water_height = { gumbel = { mean = 4.5, sd = 0.9 }, lower = 1 }\n";
    let by = |method, points| {
        let effort = Effort { points, precision: 1e-3, ..Effort::default() };
        answer(&goda(three), Request { method: Some(method), effort, years: None }).situations[0].not_rest
    };
    let exact = by(Method::Integrate, 0).value;
    for (method, points, relative) in [
        (Method::Sobol, 1 << 14, 2e-3),
        (Method::Importance, 1 << 14, 5e-3),
        (Method::MonteCarlo, 1 << 16, 0.1),
    ] {
        let found = by(method, points);
        assert_close(method.name(), found.value, exact, relative);
        assert!(found.low < found.high);
    }
}

/// Wrong laws, units, names and correlations are refused with their value, where they stand.
#[test]
fn wrong_random_numbers_are_refused() {
    let refused = |random: &str, expected: &str| {
        let text = goda(random);
        let error = Probability::of_text("case.toml", &text, Request::default()).unwrap_err();
        assert!(error.to_string().contains(expected), "{random}\n{error}\n{expected}");
        let said = standfast_cases::report(&error);
        assert!(said.contains("case.toml:"), "{said}");
    };
    refused(
        "friction = { normal = { mean = 0.6, sd = -0.1 } }",
        "`sd` of the law normal of `friction` is -0.1; expected a number above 0",
    );
    refused("friction = { normal = { mean = 0.6 } }", "lacks `sd`, a standard deviation, or `cov`");
    refused("friction = { norml = { mean = 0.6, sd = 0.1 } }", "`friction` has no `norml`");
    refused("frction = { normal = { cov = 0.1 } }", "did you mean `friction`?");
    refused(
        "friction = { normal = { mean = 0.6, sd = 0.3 } }",
        "0.02275 of the law of `friction` lies where it is negative",
    );
    refused(
        "wave.deep_water_height = { normal = { mean = \"4 kN\", sd = \"1 m\" } }",
        "`mean` of `wave.deep_water_height` is \"4 kN\"; expected a number, or a length in",
    );
    refused("friction = { normal = { cov = 0.1 }, every = \"day\" }", "\"life\", drawn once, or \"year\"");
    refused(
        "friction = { normal = { cov = 0.1 } }\n\"body.friction\" = { normal = { cov = 0.1 } }",
        "random twice",
    );
    refused(
        "friction = { uniform = { from = 0.6, to = 0.5 } }",
        "`to` of the law uniform of `friction` is 0.5",
    );
    refused("bias.force = { normal = { cov = 0.1 } }", "the case has no [[load]]");
    refused("", "names no number that is random");
    refused(
        "friction = { normal = { cov = 0.1 } }\nbias.P = { lognormal = { cov = 0.1 } }\n[[random.correlation]]\n\
         between = [\"friction\", \"bias.P\"]\nrank = 1.2",
        "the correlation 1.2 of `friction` and `bias.P` cannot be; expected more than -1 and less than 1",
    );
    let forever = goda("years = 50\nfriction = { normal = { cov = 0.1 } }");
    let error = Probability::of_text("case.toml", &forever, Request::default()).unwrap_err();
    assert_eq!(error.to_string(), "a life of 50 years, and no random number is drawn yearly");
}

/// A draw of the plane is the report's point itself, and its mode that of the closed form; more draws begin with the same ones.
#[test]
fn draws_of_the_plane_are_points_of_the_report() {
    let random =
        "[random]\nmu = { uniform = { from = 0.3, to = 0.9 } }\nk = { uniform = { from = 0.2, to = 1 } }\n";
    let text = format!("{POINT}{random}");
    let draws = |count, seed| Draws::of_text("case.toml", &text, None, count, seed).unwrap();
    let found = draws(20_000, 7);
    assert_eq!(found.inputs, [("mu".to_owned(), None), ("k".to_owned(), None)]);
    let mut sums = [0.0; 2];
    for (i, drawn) in found.drawn.iter().enumerate() {
        let (mu, k) = (found.values[0][i], found.values[1][i]);
        sums[0] += mu;
        sums[1] += k;
        let [k_eff, k_prime] = drawn.effective.unwrap();
        assert_eq!(k_eff, k);
        assert_close("k'", k_prime, 0.9167, 1e-14);
        let mode = standfast::Point::new(0.8, 0.9167, k, mu).unwrap().mode();
        assert_eq!(drawn.happens, Happening::Mode(mode), "μ = {mu}, k = {k}");
    }
    // Four standard errors of the means of uniform numbers.
    for (sum, mean, range) in [(sums[0], 0.6, 0.6f64), (sums[1], 0.6, 0.8)] {
        assert!((sum / 2e4 - mean).abs() < 4.0 * range / 12f64.sqrt() / 2e4f64.sqrt(), "{sum}");
    }
    let fewer = draws(10, 7);
    assert_eq!(fewer.values[1], found.values[1][..10]);
    assert_ne!(draws(10, 8).values, fewer.values);
}

/// Goda's caisson with friction alone random: the point of the plane is that of `assess`, and the body slides below the friction
/// at which the classical safety factor is 1.
#[test]
fn draws_of_a_caisson_have_its_effective_point() {
    let text = goda("friction = { uniform = { from = 0.4, to = 0.7 } }\n");
    let found = Draws::of_text("case.toml", &text, None, 500, 1).unwrap();
    let file =
        standfast_cases::CaseFile::parse("case.toml", include_str!("../../../examples/goda-2000.toml"));
    let case = file.unwrap().case().unwrap();
    let situation = case.situation(standfast_cases::Acting::All, None).unwrap();
    let wrench = situation.wrench_at(1.0, standfast::loads::Pose::UPRIGHT);
    let (k, k_prime) = (wrench.x.abs() / wrench.p, -wrench.m / (wrench.x * situation.body().height() / 2.0));
    for (drawn, mu) in found.drawn.iter().zip(&found.values[0]) {
        let [k_eff, k_prime_eff] = drawn.effective.unwrap();
        assert_close("k_eff", k_eff, k, 1e-13);
        assert_close("k'_eff", k_prime_eff, k_prime, 1e-12);
        let expected = if *mu < k { Mode::SlideLeft } else { Mode::Rest };
        assert_eq!(drawn.happens, Happening::Mode(expected), "μ = {mu}");
    }
    assert!(found.drawn.iter().any(|drawn| drawn.happens == Happening::Mode(Mode::Rest)));
    // What the plane is not of has no point in it.
    let added = format!("{text}\n[added_mass]\nmass = \"56.4 t/m\"\n");
    let found = Draws::of_text("case.toml", &added, None, 3, 1).unwrap();
    assert!(found.drawn.iter().all(|drawn| drawn.effective.is_none()));
}

#[test]
fn draws_ask_which_of_several_situations_is_meant() {
    let text = format!(
        "{}\n[random]\nfriction = {{ uniform = {{ from = 0.4, to = 0.7 }} }}\n",
        include_str!("../../../examples/block-two-loads.toml")
    );
    let draws = |situation| Draws::of_text("case.toml", &text, situation, 3, 1);
    let said = draws(None).unwrap_err().to_string();
    let names = Probability::of_text("case.toml", &text, Request::default()).unwrap().situations;
    assert!(names.len() > 1);
    for name in names.iter().map(|chances| chances.situation.as_deref().unwrap()) {
        assert!(said.contains(name), "{said}");
        assert_eq!(draws(Some(name)).unwrap().drawn.len(), 3);
    }
    assert!(draws(Some("pull")).unwrap_err().to_string().starts_with("no situation is called \"pull\""));
}
