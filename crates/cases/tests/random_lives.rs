//! Lives of events that come by Poisson's law, bodies that have stood, and design values: against closed forms written out here.

mod common;

use common::{POINT, chances_at_point, mean, try_chances};
use standfast_cases::random::{ChanceRequest, Probability, ProbabilityError};
use standfast_cases::{CaseFile, Document};
use standfast_probability::normal::below;

fn try_answer(text: &str) -> Result<Probability, ProbabilityError> {
    try_chances(text, 0.01)
}

fn answer(random: &str) -> Probability {
    chances_at_point(random, 0.01)
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() <= relative, "{what}: {value} where {expected} is expected");
}

fn life(found: &Probability) -> f64 {
    found.situations[0].life.as_ref().unwrap().not_rest.value
}

/// Peaks over a threshold of 0.2 by an exponential law, four a year, have Gumbel's law of yearly maxima with the mode 0.2 + 0.05 ln 4: beyond the
/// threshold the two are one.
#[test]
fn peaks_over_a_threshold_have_the_law_of_yearly_maxima() {
    let peaks = "years = 50\nevents_per_year = 4\nk = { exponential = { scale = 0.05, location = 0.2 }, every = \"event\" }\n";
    let mode = 0.2 + 0.05 * 4f64.ln();
    let maxima = format!(
        "years = 50\nk = {{ gumbel = {{ mode = {mode}, scale = 0.05 }}, lower = 0, every = \"year\" }}\n"
    );
    let [of_peaks, of_maxima] = [answer(peaks), answer(&maxima)];
    assert_close("life", life(&of_peaks), life(&of_maxima), 1e-9);
    assert_close("by hand", life(&of_peaks), -(-200.0 * (-6.0f64).exp()).exp_m1(), 1e-10);
    // One event is one peak.
    assert_close("event", of_peaks.situations[0].not_rest.value, (-6.0f64).exp(), 1e-10);
    let text = of_peaks.text(&());
    assert!(text.contains("At least once in 50 years of 4 events each on average"), "{text}");
    assert!(text.contains("does not stay at rest in one event"), "{text}");
    let json = of_peaks.json(&(), &[]);
    assert!(json.contains("\"events_per_year\": 4.0") || json.contains("\"events_per_year\": 4"), "{json}");
    // Part of a year is no matter, as events are not in step with years.
    let part = answer(&peaks.replace("years = 50", "years = 0.5"));
    assert_close("half a year", life(&part), -(-2.0 * (-6.0f64).exp()).exp_m1(), 1e-9);
}

/// Friction is one of two for the whole life. What survives is more likely the rough one: by Bayes' rule, written out.
#[test]
fn years_at_rest_tell_of_those_that_follow() {
    let random = "years = 20\nsurvived = 30\nmu = { discrete = { values = [0.4, 0.6], probabilities = [0.5, 0.5] } }\n\
                  k = { exponential = { scale = 0.05, location = 0.2 }, every = \"year\" }\n";
    let found = answer(random);
    let never = |mu: f64, years: f64| (1.0 - (-(mu - 0.2) / 0.05f64).exp()).powf(years);
    let survives = |years: f64| 0.5 * never(0.4, years) + 0.5 * never(0.6, years);
    assert_close("new", life(&found), 1.0 - survives(20.0), 1e-9);
    let stood = found.situations[0].life.as_ref().unwrap().stood.unwrap();
    assert_eq!(stood.years, 30.0);
    let expected = 1.0 - survives(50.0) / survives(30.0);
    assert_close("after 30 years", stood.not_rest.value, expected, 1e-9);
    assert!(expected < 0.8 * life(&found));
    let text = found.text(&());
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("After 30 years at rest the probability in the next 20 years is 0.1177."),
        "{text}"
    );
    // Drawn, as two numbers are drawn each year beside one for life.
    let drawn = format!(
        "{random}k_prime = {{ uniform = {{ from = -0.1, to = 0.1 }}, every = \"year\" }}\ngamma = {{ uniform = {{ from = 0.4, to = 0.5 }} }}\n"
    );
    let stood = answer(&drawn).situations[0].life.as_ref().unwrap().stood.unwrap().not_rest;
    assert!(stood.low - 1e-12 <= expected && expected <= stood.high + 1e-12, "{stood:?}, {expected}");
    assert!(stood.high - stood.low < 0.3 * expected, "{stood:?}");
    // With Poisson's law: what survives weighs the two frictions, and what follows does.
    let events = random.replace("survived", "events_per_year = 2\nsurvived").replace("\"year\"", "\"event\"");
    let never = |mu: f64, years: f64| (-2.0 * years * (-(mu - 0.2) / 0.05f64).exp()).exp();
    let survives = |years: f64| 0.5 * never(0.4, years) + 0.5 * never(0.6, years);
    let stood = answer(&events).situations[0].life.as_ref().unwrap().stood.unwrap();
    assert_close("events", stood.not_rest.value, 1.0 - survives(50.0) / survives(30.0), 1e-9);
}

/// A criterion on the life is on that of a body that has stood.
#[test]
fn criteria_are_of_what_has_stood() {
    let block = "[body]\nwidth = 2\nheight = 1\nmass = 1000\nfriction = 0.5\n[[load]]\nforce = 3000\nelevation = 0.5\n[criteria]\np_life = 0.5\n\
                 [random]\nyears = 20\nSURVIVED\nfriction = { discrete = { values = [0.4, 0.6], probabilities = [0.5, 0.5] } }\n\
                 \"load[1].force\" = { gumbel = { mean = 2000, sd = 600 }, lower = 0, every = \"year\" }\n";
    let value = |survived: &str| {
        let found = try_answer(&block.replace("SURVIVED", survived)).unwrap();
        let life = found.situations[0].life.clone().unwrap();
        (found.criteria[0].counted, life)
    };
    let (new, life) = value("");
    assert_close("new", new, life.not_rest.high, 1e-9);
    let (stood, life) = value("survived = 40");
    assert_close("stood", stood, life.stood.unwrap().not_rest.high, 1e-9);
    assert!(stood < new);
}

/// Of two normal numbers the design values are μ ∓ αβσ, and characteristic ones lie 1.645 σ from the mean: EN 1990, Annex C. With a correlation
/// the point in the numbers themselves is that of the covariance: σ_i (Σ c)_i/√(cᵀΣc).
#[test]
fn design_values_are_those_of_the_code() {
    let laws = "target_beta = 3.8\nk = { normal = { mean = 0.3, sd = 0.04 } }\nmu = { normal = { mean = 0.5, sd = 0.05 } }\n";
    let found = answer(laws);
    let asked = found.situations[0].design_values.as_ref().unwrap();
    let sd = 0.04f64.hypot(0.05);
    let fractile = 1.644_853_626_951_472_7;
    for (design, (mean, of, alpha)) in
        asked.numbers.iter().zip([(0.3, 0.04, 0.04 / sd), (0.5, 0.05, -0.05 / sd)])
    {
        assert_close("α", design.alpha, alpha, 1e-6);
        assert_close("value", design.value, mean + alpha * 3.8 * of, 1e-6);
        let characteristic = mean + f64::signum(alpha) * fractile * of;
        assert_close("characteristic", design.characteristic, characteristic, 1e-9);
        let factor = if alpha > 0.0 { design.value / characteristic } else { characteristic / design.value };
        assert_close("factor", design.factor.unwrap(), factor, 1e-9);
        assert_eq!(design.fractile, if alpha > 0.0 { 0.95 } else { 0.05 });
    }
    let text = found.text(&());
    assert!(text.contains("Design values at β = 3.8") && text.contains("EN 1990, Annex C"), "{text}");
    assert!(found.json(&(), &[]).contains("\"design_values\""));
    // With ρ = −0.5, whichever number is written first.
    for order in ["\"k\", \"mu\"", "\"mu\", \"k\""] {
        let found = answer(&format!("{laws}[[random.correlation]]\nbetween = [{order}]\nnormal = -0.5\n"));
        let asked = found.situations[0].design_values.clone().unwrap();
        let (a, b, rho) = (0.04, 0.05, -0.5);
        let whole = f64::sqrt(a * a + b * b - 2.0 * rho * a * b);
        for (design, (mean, of, z)) in
            asked.numbers.iter().zip([(0.3, a, (a - rho * b) / whole), (0.5, b, (rho * a - b) / whole)])
        {
            assert_close("correlated", design.value, mean + z * 3.8 * of, 1e-6);
        }
    }
    assert!(answer(&laws.replace("target_beta = 3.8\n", "")).situations[0].design_values.is_none());
}

#[test]
fn rates_that_do_not_go_together_are_refused() {
    let event = "k = { exponential = { scale = 0.05, location = 0.2 }, every = \"event\" }\n";
    let year = event.replace("\"event\"", "\"year\"");
    for (random, expected) in [
        (
            event.to_owned(),
            "`k` is drawn in each event; expected `events_per_year`, how many there are on average",
        ),
        (
            format!("events_per_year = 4\n{year}"),
            "`k` is drawn each year, and `events_per_year` counts events",
        ),
        (
            format!("events_per_year = 4\n{}", year.replace("year", "life")),
            "`events_per_year` counts events, and no number has every",
        ),
        (format!("events_per_year = -4\n{event}"), "`events_per_year` is -4; expected a number above zero"),
        (format!("survived = 0\n{year}"), "`survived` is 0; expected a number above zero"),
        (format!("target_beta = -1\n{year}"), "`target_beta` is -1; expected a number above zero"),
        (format!("survived = 10\n{year}"), "a life is asked for, and nothing says how many years it has"),
    ] {
        let text = format!("{POINT}{random}");
        let error = try_answer(&text).expect_err(&text);
        assert!(error.to_string().contains(expected), "{random}\n{error}");
    }
    let storm = include_str!("../../../examples/goda-2000-storm.toml");
    let stood = storm.replace("years = 50", "years = 50\nsurvived = 20");
    let error = try_answer(&stood).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the case has a [storm] and `survived`: what years at rest say of slides is not found"
    );
}

/// Slopes along means and deviations are the differences of answers to changed files; here of friction that is below a force: −f(μ), and so on.
#[test]
fn slopes_are_those_of_changed_laws() {
    let random = |mean: f64, sd: f64| {
        format!(
            "sensitivities = true\nmu = {{ normal = {{ mean = {mean}, sd = {sd} }} }}\nk = {{ gumbel = {{ mean = 0.25, sd = 0.05 }} }}\n"
        )
    };
    let p = |mean, sd| answer(&random(mean, sd)).situations[0].not_rest.value;
    let found = answer(&random(0.5, 0.05));
    let slopes = found.situations[0].slopes.as_ref().unwrap();
    let mu = slopes[0].unwrap();
    assert_close("mean", mu.by_mean.unwrap(), (p(0.501, 0.05) - p(0.499, 0.05)) / 0.002, 2e-3);
    assert_close("sd", mu.by_sd.unwrap(), (p(0.5, 0.051) - p(0.5, 0.049)) / 0.002, 2e-3);
    let text = found.text(&());
    assert!(text.contains("∂P/∂mean") && text.contains("of mu does most"), "{text}");
    let json: serde_json::Value = serde_json::from_str(&found.json(&(), &[])).unwrap();
    assert_eq!(json["sensitivities"][0]["by_mean"].as_f64().unwrap(), mu.by_mean.unwrap());
    assert_eq!(json["sensitivities"][1]["name"], "k");
    let plain = answer(&random(0.5, 0.05).replace("sensitivities = true\n", ""));
    assert_eq!(plain.situations[0].slopes, None);
    let error = try_answer(&format!("{POINT}{}", random(0.5, 0.05).replace("= true", "= 1"))).unwrap_err();
    assert!(error.to_string().contains("`sensitivities` is a number; expected true or false"), "{error}");
}

/// Water that rises by 2 cm a year lifts a block 6 m wide ever more: it slides where the force exceeds μ (m g − ρ g b h), of each year with its own h. The years are
/// multiplied one by one here; what is integrated is the same but for that they are moments.
#[test]
fn water_that_rises_lifts_more_each_year() {
    const BLOCK: &str = "gravity = 10\n[body]\nwidth = 6\nheight = 5\nmass = 60e3\nfriction = 0.5\n[water]\nlevel = 2\ndensity = 1000\n\
                         [[load]]\nname = \"push\"\nforce = 150e3\nelevation = 1\n[random]\nyears = 40\nrise_per_year = \"20 mm\"\n\
                         friction = { normal = { mean = 0.5, sd = 0.05 } }\n\
                         \"load.push.force\" = { normal = { mean = 150e3, sd = 15e3 }, every = \"year\" }\n";
    let slides = |mu: f64, level: f64| 1.0 - below((mu * (600e3 - 60e3 * level) - 150e3) / 15e3);
    let never =
        |mu: f64| (0..40).map(|year| 1.0 - slides(mu, 2.0 + 0.02 * (f64::from(year) + 0.5))).product::<f64>();
    let life_by_hand = mean(|z| 1.0 - never(0.5 + 0.05 * z));
    let year_by_hand = mean(|z| {
        (0..40).map(|year| slides(0.5 + 0.05 * z, 2.0 + 0.02 * (f64::from(year) + 0.5))).sum::<f64>() / 40.0
    });
    let found = try_answer(BLOCK).unwrap();
    assert_close("life", life(&found), life_by_hand, 2e-3);
    assert_close("an average year", found.situations[0].not_rest.value, year_by_hand, 1e-3);
    let text = found.text(&()).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("A year is one of the life, any of them as likely"), "{text}");
    // A tide of its own on top of it: the level that is drawn is raised.
    let tide = "water_level = { discrete = { values = [1.8, 2.2], probabilities = [0.5, 0.5] }, every = \"year\" }\n";
    let with_tide = |mu: f64, level: f64| 0.5 * (slides(mu, level - 0.2) + slides(mu, level + 0.2));
    let never = |mu: f64| {
        (0..40).map(|year| 1.0 - with_tide(mu, 2.0 + 0.02 * (f64::from(year) + 0.5))).product::<f64>()
    };
    let by_hand = mean(|z| 1.0 - never(0.5 + 0.05 * z));
    let file = CaseFile::parse("case.toml", &format!("{BLOCK}{tide}")).unwrap();
    let tidal = Probability::of(&file, ChanceRequest::default()).unwrap();
    let e = tidal.situations[0].life.as_ref().unwrap().not_rest;
    assert!((e.value - by_hand).abs() < (e.high - e.low).max(2e-3 * by_hand), "{e:?} {by_hand}");
    for (changed, expected) in [
        (
            BLOCK.replace("years = 40\n", ""),
            "`rise_per_year` rises over the `years` of a life, and nothing says how many",
        ),
        (BLOCK.replace("\"20 mm\"", "0"), "`rise_per_year` is 0; expected a rise"),
        (BLOCK.replace("\"20 mm\"", "\"20 kN\""), "`rise_per_year`"),
        (
            BLOCK.replace("[water]\nlevel = 2\ndensity = 1000\n", ""),
            "`rise_per_year` raises a water level, and the case has none",
        ),
        (
            BLOCK.replace("years = 40", "years = 40\nsurvived = 9"),
            "`survived` takes the years before as those to come",
        ),
        (BLOCK.replace(", every = \"year\"", ""), "no random number is drawn yearly"),
    ] {
        let error = try_answer(&changed).expect_err(&changed);
        assert!(error.to_string().contains(expected), "{error}");
    }
    // Part of a year is integrated as it is; a level that a combination sets, or that is drawn beside the one that rises, is refused.
    let part = try_answer(&BLOCK.replace("years = 40", "years = 0.5")).unwrap();
    assert!(life(&part) > 0.0 && life(&part) < 0.01, "{}", life(&part));
    let set = BLOCK.replace(
        "[random]",
        "[[combination]]\nname = \"C\"\nfactors = { push = 1 }\nset = { \"water.level\" = 2 }\n[random]",
    );
    let sides = BLOCK.replace("level = 2", "left = 2\nright = 2.2")
        + "water.right = { normal = { mean = 2.2, sd = 0.001 } }\n";
    for (changed, expected) in
        [(set, "water.level"), (sides, "make `water_level` random in place of `water.right`")]
    {
        let error = try_answer(&changed).expect_err(&changed);
        assert!(error.to_string().contains(expected), "{error}");
    }
    let point =
        try_answer(&format!("{POINT}years = 9\nrise_per_year = 0.1\nk = {{ normal = {{ sd = 0.05 }} }}\n"))
            .unwrap_err();
    assert!(point.to_string().contains("the case has none"), "{point}");
}
