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

/// The period goes with the height: T = √(2π H₀'/(g s)), of a height that is typed, drawn, or times a factor; and in a case that is assessed.
#[test]
fn a_period_goes_with_the_height() {
    let steepness = 0.035;
    let period = |height: f64| (2.0 * std::f64::consts::PI * height / (9.81 * steepness)).sqrt();
    let typed = |height: f64| {
        GODA.replace("\"6.3 m\"", &height.to_string()).replace("\"11.4 s\"", &period(height).to_string())
    };
    let steep = |height: f64| {
        GODA.replace("\"6.3 m\"", &height.to_string()).replace("period = \"11.4 s\"", "steepness = 0.035")
    };
    let factor = |text: &str| {
        let assessment = Assessment::of_file(&CaseFile::parse("case", text).unwrap()).unwrap();
        assessment.case.goda().unwrap().goda.force
    };
    for height in [3.0, 6.3, 7.7] {
        assert_close("force", factor(&steep(height)), factor(&typed(height)), 1e-12);
    }
    let law =
        "wave.deep_water_height = { discrete = { values = [3, 5, 7], probabilities = [0.5, 0.3, 0.2] } }\n";
    let expected = [(3.0, 0.5), (5.0, 0.3), (7.0, 0.2)]
        .map(|(height, share)| share * not_rest(&format!("{}{FRICTION}", typed(height))))
        .iter()
        .sum::<f64>();
    let found = answer(&format!("{}{FRICTION}{law}", steep(6.3)), None);
    assert_close("drawn", found.situations[0].not_rest.value, expected, 1e-9);
    assert!(found.warnings().iter().all(|warning| warning.name() != "steep-seas"));
    let bias = "bias.H0 = { discrete = { values = [0.8, 1.2], probabilities = [0.5, 0.5] } }\n";
    let of = |height: f64| not_rest(&format!("{}{FRICTION}", typed(height)));
    let expected = 0.5 * of(0.8 * 5.0) + 0.5 * of(1.2 * 5.0);
    assert_close("factor", not_rest(&format!("{}{FRICTION}{bias}", steep(5.0))), expected, 1e-9);
    // A steepness that is drawn itself.
    let drawn = "wave.steepness = { discrete = { values = [0.035, 0.05], probabilities = [0.6, 0.4] } }\n";
    let other = steep(5.0).replace("0.035", "0.05");
    let expected = 0.6 * of(5.0) + 0.4 * not_rest(&format!("{other}{FRICTION}"));
    assert_close("steepness", not_rest(&format!("{}{FRICTION}{drawn}", steep(5.0))), expected, 1e-9);
    // A combination that multiplies the heights at the wall leaves the period as it is.
    let scaled = |text: String| {
        let text = format!(
            "{text}\n[[combination]]\nname = \"scaled\"\nfactors = {{ wave = 1 }}\nscale = {{ \"wave.H13\" = 1.2, \"wave.Hmax\" = 1.2 }}\n{FRICTION}"
        );
        not_rest(&text)
    };
    assert_close("combination", scaled(steep(5.0)), scaled(typed(5.0)), 1e-12);
    for (text, expected) in [
        (steep(5.0).replace("steepness", "period = 10\nsteepness"), "`steepness`"),
        (steep(5.0).replace("deep_water_height = 5", "H13 = 4\nHmax = 7"), "no `deep_water_height`"),
        (steep(5.0).replace("0.035", "0.2"), "a steepness, above zero and 0.142 at most"),
    ] {
        let error = CaseFile::parse("case", &text).and_then(|file| Assessment::of_file(&file)).unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
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
