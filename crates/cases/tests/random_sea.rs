//! Seas that are drawn: none steeper than waves can be, and those that are told.

use standfast_cases::random::{ChanceRequest, Effort, Method, Probability};
use standfast_cases::{Assessment, CaseFile};

const GODA: &str = include_str!("../../../examples/goda-2000.toml");

fn answer(text: &str, method: Option<Method>) -> Probability {
    let effort = Effort { precision: 0.01, ..Effort::default() };
    let request = ChanceRequest { effort, method, ..ChanceRequest::default() };
    Probability::of(&CaseFile::parse("case", text).unwrap(), request)
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn not_rest(text: &str) -> f64 {
    answer(text, None).situations[0].not_rest.value
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() <= relative, "{what}: {value} where {expected} is expected");
}

const FRICTION: &str = "\n[random]\nfriction = { lognormal = { mean = 0.5, cov = 0.3 } }\n";

/// Of two periods the shorter has no waves of 6.3 m: those of 0.142 L₀, L₀ = g T²/2π, are the highest. With the height random too, and a factor on it.
#[test]
fn seas_are_no_steeper_than_waves_can_be() {
    let short = 5.0;
    let highest = 0.142 * 9.81 * short * short / (2.0 * std::f64::consts::PI);
    let typed = |height: f64, period: f64| {
        let text = GODA.replace("\"6.3 m\"", &height.to_string()).replace("\"11.4 s\"", &period.to_string());
        not_rest(&format!("{text}{FRICTION}"))
    };
    let period = "wave.period = { discrete = { values = [5, 11.4], probabilities = [0.25, 0.75] } }\n";
    let expected = 0.25 * typed(highest, short) + 0.75 * typed(6.3, 11.4);
    let found = answer(&format!("{GODA}{FRICTION}{period}"), None);
    assert_close("period", found.situations[0].not_rest.value, expected, 1e-9);
    let warnings = found.warnings();
    let warning = warnings.iter().find(|warning| warning.name() == "steep-seas").expect("a warning");
    let words = warning.to_string();
    let share: f64 = words.split(' ').next().unwrap().parse().unwrap();
    assert!((share - 0.25).abs() < 0.02, "{words}");
    // The quick way, where heights alone are random.
    let heights = "wave.deep_water_height = { discrete = { values = [3, 9], probabilities = [0.5, 0.5] } }\n";
    let short_case = GODA.replace("\"11.4 s\"", "5");
    let expected = 0.5 * typed(3.0, short) + 0.5 * typed(highest, short);
    assert_close("heights", not_rest(&format!("{short_case}{FRICTION}{heights}")), expected, 1e-9);
    // A factor on the height counts.
    let bias = "bias.H0 = { discrete = { values = [1, 4], probabilities = [0.5, 0.5] } }\n";
    let case = short_case.replace("\"6.3 m\"", "2");
    let expected = 0.5 * typed(2.0, short) + 0.5 * typed(highest, short);
    assert_close("factor", not_rest(&format!("{case}{FRICTION}{bias}")), expected, 1e-9);
    // Continuous heights: the cut is a kink, and every method has the same answer.
    let heights = "wave.deep_water_height = { gumbel = { mean = 3, sd = 0.8 }, lower = 0.5 }\n";
    let text = format!("{short_case}{FRICTION}{heights}");
    let exact = not_rest(&text);
    let sampled = answer(&text, Some(Method::MonteCarlo)).situations[0].not_rest;
    assert!((sampled.value - exact).abs() < sampled.high - sampled.low, "{sampled:?}, {exact}");
}

/// A sea that is not steep says nothing; one that is typed so is warned of.
#[test]
fn steep_seas_are_told() {
    let plain = answer(include_str!("../../../examples/goda-2000-random.toml"), None);
    assert!(plain.warnings().iter().all(|warning| warning.name() != "steep-seas"));
    let file = CaseFile::parse("case", &GODA.replace("\"11.4 s\"", "5")).unwrap();
    let assessment = Assessment::of_file(&file).unwrap();
    let names: Vec<&str> = assessment.case.warnings().iter().map(|warning| warning.name()).collect();
    assert!(names.contains(&"steep-sea"), "{names:?}");
}

/// A tide that is a sine spends its time as a beta law of two halves does: the arcsine law.
#[test]
fn a_tide_is_a_beta_law() {
    let text = |level: &str| {
        format!("[point]\ngamma = 0.5\nk_prime = 0\nmu = 0.5\nk = 0.3\n[random]\nk = {level}\n")
    };
    let tide = not_rest(&text("{ beta = { alpha = 0.5, beta = 0.5, from = 0.2, to = 0.6 } }"));
    // Half of a cycle lies above the mean; above 0.5, half of the amplitude, a third.
    assert_close("sine", tide, 1.0 / 3.0, 1e-9);
}
