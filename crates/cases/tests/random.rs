//! Probabilities of cases against numbers of another program, printed where the method is described, and against sums by hand.

use standfast::initiation::Chart;
use standfast::{Mode, Verdict};
use standfast_cases::random::{
    ChanceRequest, Chances, Draws, Happening, Method, Probability, ProbabilityError, Sliding, ValueRange,
};
use standfast_cases::{CaseFile, Document};
use standfast_probability::normal::below;
use standfast_probability::sample::{Effort, Estimate};

/// Reason why there is no answer to a text.
fn refused_of(text: &str) -> ProbabilityError {
    let file = CaseFile::parse("case.toml", text).map_err(ProbabilityError::from);
    file.and_then(|file| Probability::of(&file, ChanceRequest::default())).unwrap_err()
}

fn file(text: &str) -> CaseFile {
    CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn answer(text: &str, request: ChanceRequest) -> Probability {
    Probability::of(&file(text), request)
        .unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)))
}

fn chance(chances: &Chances, mode: Mode) -> f64 {
    let of =
        chances.modes.iter().find(|(happening, _)| *happening == Happening::Decided(Verdict::Begins(mode)));
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
    let found = answer(&format!("{POINT}{random}"), ChanceRequest::default());
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
    let found = answer(&format!("{POINT}{random}"), ChanceRequest::default());
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
        answer(&format!("{POINT}{random}"), ChanceRequest::default()).situations[0]
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
    let found = answer(&goda(FOUR), ChanceRequest { effort, ..ChanceRequest::default() });
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
        answer(&goda(three), ChanceRequest { method: Some(method), effort, ..ChanceRequest::default() })
            .situations[0]
            .not_rest
    };
    let exact = by(Method::Integrate, 1 << 22).value;
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

/// A rare failure of six random numbers, the tide among them, to a fifth of a percent with 32,768 points about it; plain Sobol' points of
/// another seed, twice as many, agree as far as they tell. No design point but that of sliding takes points away.
#[test]
fn few_points_about_a_rare_failure_tell_it_well() {
    let six = "friction = { normal = { mean = 0.62, sd = 0.06 }, lower = 0 }\n\
        bias.P = { lognormal = { mean = 0.91, cov = 0.1 } }\n\
        bias.U = { lognormal = { mean = 0.77, cov = 0.2 } }\n\
        wave.deep_water_height = { gumbel = { mean = 4.5, sd = 0.6 }, lower = 1 }\n\
        body.buoyant_weight = { normal = { mean = \"2700 kN/m\", sd = \"80 kN/m\" }, lower = 0 }\n\
        water_level = { normal = { mean = 7.1, sd = 0.3 }, lower = 5.9, upper = 8.3 }\n";
    let by = |method, points, seed| {
        let effort = Effort { points, precision: 1e-6, seed, ..Effort::default() };
        answer(&goda(six), ChanceRequest { method: Some(method), effort, ..ChanceRequest::default() })
            .situations[0]
            .not_rest
    };
    let about = by(Method::Importance, 1 << 15, 1);
    let half = |e: &Estimate| 0.5 * (e.high - e.low);
    assert!(half(&about) < 2.2e-3 * about.value, "{about:?}");
    let plain = by(Method::Sobol, 1 << 16, 2);
    assert!((plain.value - about.value).abs() < 1.5 * (half(&plain) + half(&about)), "{plain:?} {about:?}");
}

/// Wrong laws, units, names and correlations are refused with their value, where they stand.
#[test]
fn wrong_random_numbers_are_refused() {
    let refused = |random: &str, expected: &str| {
        let text = goda(random);
        let error = refused_of(&text);
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
    refused(
        "friction = { normal = { mean = nan, sd = 0.1 } }",
        "`mean` of `friction` is NaN; expected a finite number",
    );
    refused("years = inf\nfriction = { normal = { cov = 0.1 } }", "`years` is inf; expected a finite number");
    let point = format!("{POINT}[random]\nmuu = {{ normal = {{ mean = 0.6, sd = 0.1 }} }}\n");
    let error = refused_of(&point);
    let expected = "[random] of a [point] has no `muu`; expected gamma, k_prime, k, mu: did you mean `mu`?";
    assert_eq!(error.to_string(), expected);
    let forever = goda("years = 50\nfriction = { normal = { cov = 0.1 } }");
    let error = refused_of(&forever);
    assert_eq!(error.to_string(), "a life of 50 years, and no random number is drawn yearly");
}

/// A draw of the plane is the report's point itself, and its mode that of the closed form; more draws begin with the same ones.
#[test]
fn draws_of_the_plane_are_points_of_the_report() {
    let random =
        "[random]\nmu = { uniform = { from = 0.3, to = 0.9 } }\nk = { uniform = { from = 0.2, to = 1 } }\n";
    let text = format!("{POINT}{random}");
    let draws = |count, seed| Draws::of(&file(&text), None, count, seed).unwrap();
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
        assert_eq!(drawn.happens, Happening::Decided(Verdict::Begins(mode)), "μ = {mu}, k = {k}");
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
    let found = Draws::of(&file(&text), None, 500, 1).unwrap();
    let file =
        standfast_cases::CaseFile::parse("case.toml", include_str!("../../../examples/goda-2000.toml"));
    let case = file.unwrap().case().unwrap();
    let situation =
        case.situation(standfast_cases::Acting::All, standfast_cases::case::Trial::AS_GIVEN).unwrap();
    let wrench = situation.wrench_at(1.0, standfast::loads::Pose::UPRIGHT);
    let (k, k_prime) = (wrench.x.abs() / wrench.p, -wrench.m / (wrench.x * situation.body().height() / 2.0));
    for (drawn, mu) in found.drawn.iter().zip(&found.values[0]) {
        let [k_eff, k_prime_eff] = drawn.effective.unwrap();
        assert_close("k_eff", k_eff, k, 1e-13);
        assert_close("k'_eff", k_prime_eff, k_prime, 1e-12);
        let expected = if *mu < k { Mode::SlideLeft } else { Mode::Rest };
        assert_eq!(drawn.happens, Happening::Decided(Verdict::Begins(expected)), "μ = {mu}");
    }
    assert!(found.drawn.iter().any(|drawn| drawn.happens == Happening::REST));
    // What the plane is not of has no point in it.
    let added = format!("{text}\n[added_mass]\nmass = \"56.4 t/m\"\n");
    let found = Draws::of(&CaseFile::parse("case.toml", &added).unwrap(), None, 3, 1).unwrap();
    assert!(found.drawn.iter().all(|drawn| drawn.effective.is_none()));
}

#[test]
fn draws_ask_which_of_several_situations_is_meant() {
    let text = format!(
        "{}\n[random]\nfriction = {{ uniform = {{ from = 0.4, to = 0.7 }} }}\n",
        include_str!("../../../examples/block-two-loads.toml")
    );
    let draws = |situation| Draws::of(&file(&text), situation, 3, 1);
    let said = draws(None).unwrap_err().to_string();
    let names = Probability::of(&file(&text), ChanceRequest::default()).unwrap().situations;
    assert!(names.len() > 1);
    for name in names.iter().map(|chances| chances.situation.as_deref().unwrap()) {
        assert!(said.contains(name), "{said}");
        assert_eq!(draws(Some(name)).unwrap().drawn.len(), 3);
    }
    assert!(draws(Some("pull")).unwrap_err().to_string().starts_with("no situation is called \"pull\""));
}

/// As the loads of the report's plane rise it slides first below μ_A and rocks above, whatever k is; the caisson turns first where
/// λ_t P/(W' − λ_t U) is below μ, with λ_t = W't/(M_p + M_U) of Goda's moments about the heel.
#[test]
fn first_departures_part_at_the_load_that_turns() {
    let random = "[random]\nmu = { normal = { mean = 0.6, sd = 0.1 }, lower = 0.0 }\n\
                  k = { normal = { mean = 0.45, sd = 0.12 }, lower = 0.0 }\n";
    let found = answer(&format!("{POINT}{random}"), ChanceRequest::default());
    let first = |chances: &Chances, mode: Mode| {
        let modes = &chances.first_departure.modes;
        modes
            .iter()
            .find(|(happening, _)| *happening == Happening::Decided(Verdict::Begins(mode)))
            .unwrap()
            .1
            .value
    };
    let k_a = Chart::new(0.8, 0.9167).unwrap().k_a();
    let slides = (below((k_a - 0.6) / 0.1) - below(-6.0)) / below(6.0);
    let chances = &found.situations[0];
    assert_close("SL", first(chances, Mode::SlideLeft), slides, 1e-12);
    assert_close("RO", first(chances, Mode::RockO), 1.0 - slides, 1e-12);
    let share = |p: f64| format!("{:.1} %", 100.0 * p);
    let words = found.text(&()).split_whitespace().collect::<Vec<_>>().join(" ");
    let said = format!(
        "Were the loads to rise without end, it would first leave rest into SL in {} and RO in {} of all outcomes.",
        share(slides),
        share(1.0 - slides)
    );
    assert!(words.contains(&said), "{said}\n{words}");
    // But where the force is nothing at all.
    assert!(chances.first_departure.never.value + chances.first_departure.at_once.value < 1e-15);

    let text = goda("friction = { normal = { mean = 1.2, sd = 0.2 } }");
    let case = standfast_cases::CaseFile::parse("case.toml", &text).unwrap().case().unwrap();
    let goda = &case.goda().unwrap().goda;
    let weight = 2318640.0;
    let turning = weight * 7.5 / (goda.force_moment + goda.uplift_moment);
    let friction = turning * goda.force / (weight - turning * goda.uplift);
    let slides = (below((friction - 1.2) / 0.2) - below(-6.0)) / below(6.0);
    assert!((0.05..0.95).contains(&slides), "{slides}");
    for method in [None, Some(Method::Sobol)] {
        let found = answer(&text, ChanceRequest { method, ..ChanceRequest::default() });
        assert_close("caisson", first(&found.situations[0], Mode::SlideLeft), slides, 1e-9);
    }
    let effort = Effort { points: 1 << 16, precision: 0.01, ..Effort::default() };
    let drawn =
        answer(&text, ChanceRequest { method: Some(Method::MonteCarlo), effort, ..ChanceRequest::default() });
    assert_close("drawn", first(&drawn.situations[0], Mode::SlideLeft), slides, 0.02);
}

/// A load that is there all the time moves the body at once where friction is below X/P.
#[test]
fn some_bodies_leave_rest_at_once() {
    let text = "[body]\nwidth = 2\nheight = 1\nmass = 1000\nfriction = 0.5\n[[load]]\nname = \"rope\"\nforce = 3e3\n\
        elevation = 0.2\npermanent = true\n[[load]]\nname = \"push\"\nforce = 1e3\nelevation = 0.2\n\
        [random]\nfriction = { normal = { mean = 0.4, sd = 0.1 } }\n";
    let found = answer(text, ChanceRequest::default());
    let at_once = found.situations[0].first_departure.at_once.value;
    // Cut at zero, where no friction is.
    let by_hand = (below((3e3 / 9810.0 - 0.4) / 0.1) - below(-4.0)) / below(4.0);
    assert_close("at once", at_once, by_hand, 1e-10);
    assert_close("at rest without the push", 1.0 - at_once, 1.0 - by_hand, 1e-10);
}

/// Years drawn one by one agree with the integral over two numbers; two more that hardly vary make the first way the only one. Friction
/// drawn once is united over the years, drawn yearly it is multiplied.
#[test]
fn lives_of_more_numbers_are_drawn() {
    let life = |every: &str, more: &str| {
        let random = format!(
            "[random]\nyears = 50\nmu = {{ lognormal = {{ mean = 0.6, cov = 0.15 }}{every} }}\n\
             k = {{ gumbel = {{ mean = 0.3, sd = 0.06 }}, lower = 0.0, every = \"year\" }}\n{more}"
        );
        let effort = Effort { precision: 0.04, floor: 0.02, ..Effort::default() };
        let found = answer(&format!("{POINT}{random}"), ChanceRequest { effort, ..ChanceRequest::default() });
        found.situations[0].life.clone().unwrap()
    };
    let more = "gamma = { normal = { mean = 0.8, cov = 1e-7 } }\n\
        k_prime = { normal = { mean = 0.9167, cov = 1e-7 }, every = \"year\" }\n";
    for every in ["", ", every = \"year\""] {
        let (exact, drawn) = (life(every, ""), life(every, more));
        assert_eq!((exact.method, drawn.method), (Method::Integrate, Method::Sobol));
        let pairs = exact.modes.iter().zip(&drawn.modes).map(|((_, a), (_, b))| (a.value, *b));
        for (exact, e) in pairs.chain([(exact.not_rest.value, drawn.not_rest)]) {
            assert!(exact < 0.05 || e.high - e.low < 0.1 * e.value, "{e:?}");
            assert!((e.value - exact).abs() <= e.high - e.low + 1e-12, "{e:?} {exact}");
        }
    }
}

const STORM: &str = "[storm]\nwaves = 1000\nheights = \"rayleigh\"\ntau0 = \"1.5 s\"\nforce_per_height = \"90 kN/m2\"\n\
    uplift_per_height = \"45 kN/m2\"\nbuoyant_weight = \"2318.64 kN/m\"\nmass = \"402.45 t/m\"\n\
    [random]\nyears = 50\nfriction = { normal = { mean = 0.6, sd = 0.1 }, lower = 0.05 }\n\
    bias.P = { lognormal = { mean = 0.91, cov = 0.19 } }\n\
    significant_height = { gumbel = { mean = \"4.5 m\", sd = \"0.9 m\" }, lower = \"1 m\", every = \"year\" }\n";

/// Fifty years of storms: 0.69 m is the mean, while 73 % of all lives slide less than 0.10 m, as printed where the method is
/// described; the mean over the lives drawn is the integral.
#[test]
fn few_lives_slide_far() {
    let effort = Effort { points: 1 << 20, ..Effort::default() };
    let found = answer(STORM, ChanceRequest { effort, ..ChanceRequest::default() });
    let sliding = found.sliding.unwrap();
    assert!((sliding.mean.value - 0.69).abs() < 0.006, "{:?}", sliding.mean);
    assert!(sliding.precise);
    let less = 1.0 - sliding.exceedance[0].probability.value;
    assert!((less - 0.73).abs() < 0.01, "{less}");
    let drawn = sliding.drawn;
    assert!((drawn.value - sliding.mean.value).abs() < drawn.high - drawn.low, "{drawn:?}");
    assert_eq!(sliding.rotating.wave.value, 0.0);
    // Any wave slides it with the chance that the waves of a life have on average.
    assert_close("waves", sliding.waves.value, 50_000.0 * sliding.wave.value, 1e-12);
}

/// A caisson under one storm of 200 waves of the given sea, on a friction between 0.35 and 0.55, and what else the case has.
fn in_a_storm() -> String {
    goda("friction = { uniform = { from = 0.35, to = 0.55 } }")
        .replace("[wave]", "[added_mass]\nmass = \"56.4 t/m\"\n\n[storm]\nwaves = 200\ntau0 = 1.5\n\n[wave]")
}

/// Its weight less buoyancy, N/m, its mass with the water that moves along, kg/m, and τ₀, s.
const IN_A_STORM: (f64, f64, f64) = (2318640.0, 402_450.0, 1.5);

/// The mean over heights and frictions of what a wave does, in so many steps of each: heights by Rayleigh's law from the significant one to the largest, as smaller
/// waves do not slide it at these frictions; each wave by Goda's formulas for heights at the wall.
fn mean_of_wave(
    text: &str,
    (heights, frictions): (u32, u32),
    does: impl Fn(&standfast::wave::Goda, f64) -> f64,
) -> f64 {
    let case = file(text).case().unwrap();
    let waves = case.goda().unwrap();
    let (significant, largest) = (waves.goda.h_13, waves.goda.h_max);
    let level = |h: f64| (1.416 * h / significant).powi(2);
    let all = 1.0 - (-level(largest)).exp();
    let mut mean = 0.0;
    for i in 0..heights {
        let h = significant + (largest - significant) * (f64::from(i) + 0.5) / f64::from(heights);
        let half = 0.5 * (largest - significant) / f64::from(heights);
        let chance = ((-level(h - half)).exp() - (-level(h + half)).exp()) / all;
        let at_wall = standfast::wave::Heights::Local { significant, maximum: h };
        let goda = standfast::wave::goda(&waves.sea, &at_wall, &waves.section, &waves.choices).unwrap();
        for j in 0..frictions {
            let μ = 0.35 + 0.2 * (f64::from(j) + 0.5) / f64::from(frictions);
            mean += chance * does(&goda, μ) / f64::from(frictions);
        }
    }
    mean
}

fn slid(text: &str) -> Sliding {
    let effort = Effort { points: 1 << 16, ..Effort::default() };
    answer(text, ChanceRequest { effort, ..ChanceRequest::default() }).sliding.unwrap()
}

/// Friction alone is random: the mean by sums over frictions and heights, the mode of each wave by the classical factors, its slide by the closed form of a triangular
/// pulse.
#[test]
fn storms_of_a_case_are_sums_over_waves() {
    let (weight, mass, τ) = IN_A_STORM;
    let sliding = slid(&in_a_storm());
    let pulse = |s: f64| match s - 1.0 {
        x if x <= 0.0 => 0.0,
        x if x <= 0.5f64.sqrt() => (0.25 + 2f64.sqrt() / 6.0) * x.powi(3) / (s * s),
        x => x * x / 8.0 - 1.0 / (96.0 * s * s),
    };
    let share = |goda: &standfast::wave::Goda, μ: f64| {
        assert!(weight * 7.5 - goda.uplift_moment > goda.force_moment, "no wave turns it");
        (goda.force + μ * goda.uplift) / (μ * weight)
    };
    let steps = (1500, 200);
    let mean =
        mean_of_wave(&in_a_storm(), steps, |goda, μ| pulse(share(goda, μ)) * μ * weight * τ * τ / mass);
    let adds = mean_of_wave(&in_a_storm(), steps, |goda, μ| f64::from(u8::from(share(goda, μ) > 1.0)));
    assert!(mean > 0.0);
    assert_close("mean", sliding.mean.value, 200.0 * mean, 3e-3);
    assert_close("chance", sliding.wave.value, adds, 5e-3);
    assert_eq!(sliding.rotating.wave.value, 0.0);
    assert_eq!(sliding.years, 1.0);
}

/// The same of friction that is a tenth less once the body slips: each wave sets it off where P + μU exceeds μW', and slides it by P + μ_k U less μ_k W', which is followed in small
/// steps of time here. The published formula takes one friction.
#[test]
fn storms_of_two_frictions() {
    let (weight, mass, τ) = IN_A_STORM;
    let text = in_a_storm().replace("friction = 0.6", "friction = 0.6\nkinetic_friction = 0.54");
    let sliding = slid(&text);
    let slide = |goda: &standfast::wave::Goda, μ: f64| {
        const STEPS: u32 = 4000;
        if goda.force + μ * goda.uplift <= μ * weight {
            return 0.0;
        }
        let dt = τ / f64::from(STEPS);
        let (mut v, mut x, mut moves) = (0.0f64, 0.0, false);
        for i in 0..4 * STEPS {
            let t = (f64::from(i) + 0.5) * dt;
            let share = (1.0 - (2.0 * t / τ - 1.0).abs()).max(0.0);
            moves |= t < τ && share * (goda.force + μ * goda.uplift) > μ * weight;
            let slips = 0.9 * μ;
            let force = share * (goda.force + slips * goda.uplift) - slips * weight;
            v = if moves { (v + force / mass * dt).max(0.0) } else { 0.0 };
            moves &= v > 0.0;
            x += v * dt;
        }
        x
    };
    let mean = mean_of_wave(&text, (120, 40), slide);
    assert_close("mean", sliding.mean.value, 200.0 * mean, 1e-2);
    let one = slid(&in_a_storm());
    assert!(sliding.mean.value > 1.2 * one.mean.value, "{:?}", sliding.mean);
    let refused = refused_of(&text.replace("tau0 = 1.5", "tau0 = 1.5\npulse = \"shimosako\""));
    assert!(refused.to_string().contains("pulse = \"shimosako\" takes one friction"), "{refused}");
}

/// A caisson on so much friction that waves turn it rather than slide it: those are counted apart.
#[test]
fn waves_that_begin_a_rotation_are_no_slides() {
    let text = goda("friction = { uniform = { from = 1.5, to = 1.6 } }\n")
        .replace("[wave]", "[storm]\nwaves = 200\ntau0 = 1.5\ncut = false\n\n[wave]");
    let effort = Effort { points: 1 << 12, ..Effort::default() };
    let sliding = answer(&text, ChanceRequest { effort, ..ChanceRequest::default() }).sliding.unwrap();
    let case = standfast_cases::CaseFile::parse("case.toml", &text).unwrap().case().unwrap();
    let waves = case.goda().unwrap();
    // The height at which W't − M_U = M_p, by bisection; that at this friction no smaller wave slides it.
    let turns = |h: f64| {
        let heights = standfast::wave::Heights::Local { significant: waves.goda.h_13, maximum: h };
        let goda = standfast::wave::goda(&waves.sea, &heights, &waves.section, &waves.choices).unwrap();
        assert!(goda.force < 1.5 * (2318640.0 - goda.uplift) || h > 12.0, "{h}");
        2318640.0 * 7.5 - goda.uplift_moment < goda.force_moment
    };
    let (mut low, mut high) = (waves.goda.h_13, 40.0);
    assert!(!turns(low) && turns(high));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if turns(middle) { high = middle } else { low = middle }
    }
    let chance = (-(1.416 * high / waves.goda.h_13).powi(2)).exp();
    assert_close("turning", sliding.rotating.wave.value, chance, 1e-6);
    assert_eq!(sliding.mean.value, 0.0);
}

/// Along the width, each point is the answer to the case of that width; the lognormal curve through a lognormal resistance is that
/// law: a force that slides where it exceeds μW.
#[test]
fn probabilities_along_a_number_are_those_of_each_value() {
    let goda = |width: &str| {
        goda("friction = { lognormal = { mean = 0.636, cov = 0.15 } }")
            .replace("width = \"15 m\"", &format!("width = \"{width}\""))
            .replace("caisson_width = \"15 m\"\n", "")
    };
    let over = |over: &str| Some(over.parse::<ValueRange>().unwrap());
    let along = Probability::along(
        &file(&goda("15 m")),
        ChanceRequest::default(),
        over("width=14 m..18 m:3").as_ref(),
    );
    let fragility = along.unwrap().fragility.unwrap();
    assert_eq!(fragility.points.iter().map(|point| point.value).collect::<Vec<_>>(), [14.0, 16.0, 18.0]);
    // A width is no strength of a load.
    assert_eq!(fragility.fit, None);
    // Mass and weight go with the width, as they do in `design`.
    let heavier = goda("16 m").replace("346.05 t/m", "369.12 t/m").replace("2318.64 kN/m", "2473.216 kN/m");
    let there = answer(&heavier, ChanceRequest::default());
    assert_close("16 m", fragility.points[1].not_rest.value, there.situations[0].not_rest.value, 1e-9);

    let pushed = "[body]\nwidth = 4\nheight = 1\nmass = 1000\nfriction = 0.5\n[[load]]\nname = \"push\"\nforce = 1e3\n\
        elevation = 0.1\n[random]\nfriction = { lognormal = { mean = 0.5, cov = 0.2 } }\n";
    let asked = over("load.push.force=2000..8000:13");
    let fragility = Probability::along(&file(pushed), ChanceRequest::default(), asked.as_ref())
        .unwrap()
        .fragility
        .unwrap();
    let fit = fragility.fit.unwrap();
    let dispersion = 1.04f64.ln().sqrt();
    assert_close("median", fit.median, 0.5 / 1.04f64.sqrt() * 9810.0, 1e-8);
    assert_close("dispersion", fit.dispersion, dispersion, 1e-8);
    assert!(fit.misfit < 1e-9);
    assert_eq!(fragility.points[4].value, 4000.0);
    let by_hand = below((4000.0 / fit.median).ln() / dispersion);
    assert_close("P", fragility.points[4].not_rest.value, by_hand, 1e-8);
}

/// A rare failure of six numbers, about whose design points points are taken: modes still add up to one, and none is more than that.
#[test]
fn modes_add_up_to_one_about_design_points() {
    let rare = "friction = { normal = { mean = 0.62, sd = 0.06 }, lower = 0 }\n\
        bias.P = { lognormal = { mean = 0.91, cov = 0.1 } }\nbias.U = { lognormal = { mean = 0.77, cov = 0.2 } }\n\
        wave.deep_water_height = { gumbel = { mean = 4.5, sd = 0.6 }, lower = 1 }\n";
    let text = goda(rare).replace("2318.64 kN/m", "2700 kN/m");
    let effort = Effort { points: 1 << 14, ..Effort::default() };
    let found = answer(&text, ChanceRequest { effort, ..ChanceRequest::default() });
    let chances = &found.situations[0];
    assert_eq!(chances.method, Method::Importance);
    let sum: f64 = chances.modes.iter().map(|(_, e)| e.value).sum();
    assert!((sum - 1.0).abs() < 1e-12, "{sum}");
    assert!(
        chances
            .modes
            .iter()
            .all(|(_, e)| 0.0 <= e.low && e.low <= e.value && e.value <= e.high && e.high <= 1.0)
    );
}

/// FORM of every mode: those that begin in corner A have their nearest point there, sliding where k = μ, each by the laws' own logarithms;
/// a mode in which the medians already are is at the distance 0. Nothing of the kind stands where it is not asked for.
#[test]
fn every_mode_has_its_nearest_point() {
    let text = format!(
        "{POINT}[random]\nmu = {{ lognormal = {{ mean = 0.62, cov = 0.08 }} }}\nk = {{ lognormal = {{ mean = 0.35, cov = 0.15 }} }}\n"
    );
    let form = |text: &str| {
        answer(text, ChanceRequest::default().with("form".parse().unwrap())).situations.remove(0)
    };
    let chances = form(&text);
    assert_eq!(chances.method, Method::Integrate);
    let u = |x: f64, mean: f64, cov: f64| {
        let variance = (cov * cov).ln_1p();
        (x.ln() - mean.ln() + 0.5 * variance) / variance.sqrt()
    };
    let at = |x: f64| u(x, 0.62, 0.08).hypot(u(x, 0.35, 0.15));
    let point = |chances: &Chances, mode: Mode| {
        let points = chances.design_points.as_ref().unwrap();
        points
            .iter()
            .find(|(happening, _)| *happening == Happening::Decided(Verdict::Begins(mode)))
            .unwrap()
            .1
            .clone()
    };
    let corner = Chart::new(0.8, 0.9167).unwrap().k_a();
    for mode in [Mode::RockO, Mode::SlideRockOLeft] {
        let point = point(&chances, mode);
        assert_close("β", point.beta, at(corner), 1e-9);
        assert!(point.at_change && point.values.iter().all(|x| (x - corner).abs() < 1e-9), "{point:?}");
    }
    // Along μ = k the distance is least at one place, which a golden section finds.
    let (mut a, mut b): (f64, f64) = (0.35, 0.62);
    for _ in 0..200 {
        let (one, other) = (b - 0.618_033_988_749_895 * (b - a), a + 0.618_033_988_749_895 * (b - a));
        if at(one) < at(other) { b = other } else { a = one }
    }
    assert_close("β", point(&chances, Mode::SlideLeft).beta, at(a), 1e-9);
    assert_eq!(answer(&text, ChanceRequest::default()).situations[0].design_points, None);
    // The medians slide: the distance to rest counts, as that of the half space of the other sign.
    let chances = form(&text.replace("0.35", "0.64"));
    assert_eq!(point(&chances, Mode::SlideLeft).beta, 0.0);
    let at = |x: f64| u(x, 0.62, 0.08).hypot(u(x, 0.64, 0.15));
    let nearest = (0..=100_000).map(|i| at(0.5 + 2e-6 * f64::from(i))).fold(f64::INFINITY, f64::min);
    let of_rest = chances.design_point.unwrap();
    assert!((of_rest.beta + nearest).abs() < 1e-7, "{} {nearest}", of_rest.beta);
    let parallel = of_rest.alpha.iter().zip(&of_rest.u).all(|(α, u)| (α * of_rest.beta - u).abs() < 1e-12);
    assert!(parallel && of_rest.first_order() > 0.5, "{of_rest:?}");
}

/// γ = 1.5 with k', k and μ random, so that every mode with the force to the left is met, the rarest by 6e-13: as
/// validation/peers/probability.py integrates it along k, where this is integrated along μ. In the tails several conditions name one
/// boundary, rounded otherwise, and the pattern changes from one value to the next; no kink is to be looked for there.
#[test]
fn a_force_of_uncertain_height_meets_every_mode() {
    let text = "[point]\ngamma = 1.5\n[random]\nk_prime = { normal = { mean = 0.3, sd = 0.4 } }\n\
        mu = { lognormal = { mean = 0.5, cov = 0.2 } }\nk = { lognormal = { mean = 0.45, cov = 0.3 } }\n";
    let found = answer(text, ChanceRequest::default());
    let chances = &found.situations[0];
    assert_eq!(chances.method, Method::Integrate);
    let expected = [
        (Mode::Rest, 5.242802544281e-1),
        (Mode::SlideLeft, 2.177602009281e-1),
        (Mode::RockO, 2.291451703405e-1),
        (Mode::SlideRockOLeft, 2.881245496576e-2),
        (Mode::SlideRockORight, 6.191320208198e-13),
        (Mode::SlideRockOPrimeLeft, 1.919301988612e-6),
        (Mode::RockOPrime, 3.489060759992e-11),
    ];
    for (mode, probability) in expected {
        assert_close(&mode.to_string(), chance(chances, mode), probability, 1e-9);
    }
    assert!(chances.points < 1_000_000, "{}", chances.points);
}

/// Without a body there is no sea whose H_max could cut the heights, so that they may be said not to be cut, and not the contrary.
#[test]
fn heights_without_a_sea_are_not_cut() {
    let refusal = |cut: &str| {
        let text = format!(
            "[storm]\nwaves = 1000\ncut = {cut}\n[random]\nfriction = {{ normal = {{ mean = 0.6, sd = 0.1 }} }}\n"
        );
        refused_of(&text).to_string()
    };
    assert!(refusal("false").contains("lacks `tau0`"), "{}", refusal("false"));
    assert!(
        refusal("true").contains("expected false, because without a [body] no sea has an H_max"),
        "{}",
        refusal("true")
    );
}

/// k' = −0.6, where rocking begins by a step at a k far out: 4.4e-12, as validation/peers/probability.py integrates it along k and along μ.
#[test]
fn a_rare_mode_that_begins_by_a_step_has_its_digits() {
    let text = "[point]\ngamma = 1.5\nk_prime = -0.6\n[random]\nmu = { lognormal = { mean = 0.5, cov = 0.2 } }\n\
        k = { gumbel = { mean = 1.0, sd = 0.4 }, lower = 0 }\n";
    let found = answer(text, ChanceRequest::default());
    assert_close("RO", chance(&found.situations[0], Mode::RockO), 4.443731787831e-12, 1e-10);
}
