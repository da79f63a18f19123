//! Along which number the modes are integrated, and what each bias is on: probabilities against closed forms that share no code with the
//! crate. The normal law is Simpson's rule on its density.

use standfast_cases::CaseFile;
use standfast_cases::Document;
use standfast_cases::random::{ChanceRequest, Effort, Method, Probability};

/// ∫ of the normal density from −∞ to `z`.
fn below(z: f64) -> f64 {
    let from = -12.0_f64;
    let n = 4000;
    let h = (z - from) / f64::from(n);
    let density = |x: f64| (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt();
    let sum: f64 = (0..=n)
        .map(|i| {
            let weight = if i == 0 || i == n { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
            weight * density(from + f64::from(i) * h)
        })
        .sum();
    sum * h / 3.0
}

/// P(X > x) of a lognormal law by its mean and coefficient of variation.
fn lognormal_above(x: f64, mean: f64, cov: f64) -> f64 {
    let zeta = (1.0 + cov * cov).ln().sqrt();
    below(-((x / mean).ln() + 0.5 * zeta * zeta) / zeta)
}

fn answer(text: &str, years: Option<f64>, method: Option<Method>) -> Probability {
    let request = ChanceRequest {
        years,
        method,
        effort: Effort { precision: 0.01, ..Effort::default() },
        ..ChanceRequest::default()
    };
    Probability::of(&CaseFile::parse("case", text).unwrap(), request)
        .unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() <= relative, "{what}: {value}, expected {expected}");
}

/// A point so rough that it only rocks: from k_A = 1/(γ(1 + k')) on, whatever the friction. The force is then the line; the same by
/// points and by plain draws.
#[test]
fn where_friction_does_not_matter_the_force_is_integrated() {
    let text = "[point]\ngamma = 0.8\nk_prime = 0.9167\n[random]\nmu = { lognormal = { mean = 3.0, cov = 0.05 } }\n\
                k = { normal = { mean = 0.5, sd = 0.05 } }\n";
    let exact = below((0.5 - 1.0 / (0.8 * 1.9167)) / 0.05);
    let integrated = answer(text, None, None);
    assert_eq!(integrated.situations[0].line, ("k".to_owned(), true));
    assert_close("P", integrated.situations[0].not_rest.value, exact, 1e-9);
    for method in [Method::Sobol, Method::MonteCarlo] {
        let found = answer(text, None, Some(method)).situations.remove(0).not_rest;
        // Of points nothing is left to be drawn but what does not matter; Simpson's rule has eleven digits.
        let near = 1e-9 * exact;
        assert!(found.low - near <= exact && exact <= found.high + near, "{method}: {found:?} {exact}");
    }
    // Where it slides as well, friction stays the line.
    let both = answer(&text.replace("mean = 3.0", "mean = 0.62"), None, None);
    assert_eq!(both.situations[0].line.0, "mu");
}

const CAISSON: &str = include_str!("../../../examples/goda-2000.toml");

/// Of two biases the one with the larger |α| is the line, whichever stands first: P(b_P P > μ(W' − b_U U)) with Goda's forces
/// at H_max = 8.0495 m, P = 940.61 and U = 493.01 kN/m, and W' = 2318.64 kN/m, by the trapezoidal rule over b_U.
#[test]
fn of_two_biases_the_one_that_matters_more_is_integrated() {
    let text = format!(
        "{CAISSON}\n[random]\nbias.U = {{ lognormal = {{ mean = 0.77, cov = 0.25 }} }}\nbias.P = {{ lognormal = {{ mean = 0.91, cov = 0.19 }} }}\n"
    );
    let found = answer(&text, None, None);
    assert_eq!(found.situations[0].line, ("bias.P".to_owned(), true));
    let zeta = (1.0 + 0.25f64 * 0.25).ln().sqrt();
    let h = 1.0 / 64.0;
    let exact: f64 = (-512..=512)
        .map(|i| f64::from(i) * h)
        .map(|u| {
            let uplift = 0.77 * (zeta * u - 0.5 * zeta * zeta).exp() * 493.01;
            let weight = h * (-0.5 * u * u).exp() / (2.0 * std::f64::consts::PI).sqrt();
            // Where the uplift lifts it any thrust moves it.
            weight * lognormal_above((0.6 * (2318.64 - uplift) / 940.61).max(1e-300), 0.91, 0.19)
        })
        .sum();
    // The forces are known to five digits.
    assert_close("P", found.situations[0].not_rest.value, exact, 2e-4);
}

/// Biases of moments: on a base so rough that it cannot slide the caisson turns where b M_p + M_U, or M_p + b M_U, exceeds W' B/2, with
/// Goda's M_p = 4849.6 and M_U = 4930.4 kNm/m. Of a moment alone: forces stay as they are.
#[test]
fn biases_of_moments_are_on_moments_about_the_heel() {
    let rough = CAISSON.replace("friction = 0.6", "friction = 5.0");
    let [thrust, uplift, weight] = [4849.6, 4930.4, 2318.64 * 7.5];
    for (bias, limit) in [("bias.M_p", (weight - uplift) / thrust), ("bias.M_U", (weight - thrust) / uplift)]
    {
        let text = format!("{rough}\n[random]\n{bias} = {{ lognormal = {{ mean = 2.0, cov = 0.2 }} }}\n");
        let found = answer(&text, None, None);
        let chances = &found.situations[0];
        assert_close(bias, chances.not_rest.value, lognormal_above(limit, 2.0, 0.2), 1e-3);
        let rocks = chances.modes.iter().find(|(mode, _)| mode.name() == "RO").unwrap().1.value;
        assert_close(bias, rocks, chances.not_rest.value, 1e-9);
        // With its smooth base the same body slides, whatever its moments.
        let smooth = text.replace("friction = 5.0", "friction = 0.1");
        assert_close(bias, answer(&smooth, None, None).situations[0].not_rest.value, 1.0, 1e-12);
    }
}

/// The bias of a force is on its moment too: with `bias.P` alone the caisson turns where b M_p + M_U exceeds W' B/2, with `bias.U` alone where
/// M_p + b M_U does. Where the moment has a bias of its own, that of the force is not on it.
#[test]
fn a_bias_of_a_force_is_on_its_moment_unless_that_has_its_own() {
    let rough = CAISSON.replace("friction = 0.6", "friction = 5.0");
    let [thrust, uplift, weight] = [4849.6, 4930.4, 2318.64 * 7.5];
    for (force, moment, limit) in [
        ("bias.P", "bias.M_p", (weight - uplift) / thrust),
        ("bias.U", "bias.M_U", (weight - thrust) / uplift),
    ] {
        let law = "{ lognormal = { mean = 2.0, cov = 0.2 } }";
        let found = answer(&format!("{rough}\n[random]\n{force} = {law}\n"), None, None);
        let exact = lognormal_above(limit, 2.0, 0.2);
        assert_close(force, found.situations[0].not_rest.value, exact, 1e-3);
        let rocks = found.situations[0].modes.iter().find(|(mode, _)| mode.name() == "RO").unwrap().1.value;
        assert_close(force, rocks, exact, 1e-3);
        let [other, own] = [(1.0, 0.2), (1.8, 0.3)]
            .map(|(mean, cov)| format!("{{ lognormal = {{ mean = {mean:?}, cov = {cov:?} }} }}"));
        let found = answer(&format!("{rough}\n[random]\n{force} = {other}\n{moment} = {own}\n"), None, None);
        assert_close(moment, found.situations[0].not_rest.value, lognormal_above(limit, 1.8, 0.3), 1e-3);
    }
}

/// A block of 10 kN/m under 3 kN/m at half its height, friction 0.5, square: it slides where b · 3 > 5.
const PUSHED: &str = "[body]\nwidth = \"1 m\"\nheight = \"1 m\"\nmass = 1019.367991845056\nfriction = 0.5\n\
                      [[load]]\nname = \"push\"\nforce = \"3 kN/m\"\nelevation = \"0.5 m\"\n";

#[test]
fn a_bias_of_forces_is_on_every_load() {
    let text = format!("{PUSHED}[random]\nbias.force = {{ lognormal = {{ mean = 1.0, cov = 0.3 }} }}\n");
    let exact = lognormal_above(5.0 / 3.0, 1.0, 0.3);
    // The weight is 9.81 times the mass to 1e-12 or so; gravity is 9.81 unless given.
    assert_close("slides", answer(&text, None, None).situations[0].not_rest.value, exact, 1e-9);
}

/// It slides where 3b > 10μ: with μ of mean 0.5 and deviation 0.08 and b of mean 1 and deviation 0.2 that is a plane 2 from the means,
/// along 0.6 of b and −0.8 of μ; with one of them held there it is 1.25 and 5/3 as far, 1/√(1 − α²).
#[test]
fn the_document_has_the_omission_of_each_number() {
    let laws = "friction = { normal = { sd = 0.08 } }\nbias.force = { normal = { mean = 1.0, sd = 0.2 } }";
    let json = answer(&format!("{PUSHED}[random]\n{laws}\n"), None, None).json(&(), &[]);
    let document: serde_json::Value = serde_json::from_str(&json).unwrap();
    let near = |value: &serde_json::Value, expected: f64| {
        // Both laws are cut at zero, five and six deviations below their means.
        assert!((value.as_f64().unwrap() - expected).abs() < 1e-4, "{value} {expected}: {json}");
    };
    let importance = document["importance"].as_array().unwrap();
    for (name, alpha, omission) in [("friction", -0.8, 5.0 / 3.0), ("bias.force", 0.6, 1.25)] {
        let number = importance.iter().find(|number| number["name"] == name).unwrap();
        near(&number["alpha"], alpha);
        near(&number["omission"], omission);
    }
}

/// The years of the request go before those of the file: 1 − (1 − p)ⁿ of what is drawn yearly.
#[test]
fn years_that_are_asked_for_go_before_those_of_the_case() {
    let law = "bias.force = { lognormal = { mean = 1.0, cov = 0.2 }, every = \"year\" }";
    let text = format!("{PUSHED}[random]\nyears = 50\n{law}\n");
    let p = lognormal_above(5.0 / 3.0, 1.0, 0.2);
    for (asked, years) in [(None, 50.0), (Some(20.0), 20.0), (Some(1.0), 1.0)] {
        let life = answer(&text, asked, None).situations.remove(0).life.expect("a life");
        assert_eq!(life.years, years);
        assert_close("life", life.not_rest.value, 1.0 - (1.0 - p).powf(years), 1e-9);
    }
}

/// A force upwards along which nothing presses the body down: from its weight on.
#[test]
fn along_a_load_upwards_the_body_is_lifted_from_its_weight_on() {
    let text = "[body]\nwidth = \"1 m\"\nheight = \"1 m\"\nmass = 1019.367991845056\nfriction = 0.5\n\
                [[load]]\nname = \"crane\"\nforce = \"6 kN/m\"\ndirection = \"up\"\ndistance = \"0.5 m\"\n\
                [random]\nload.crane.force = { normal = { mean = \"6 kN/m\", sd = \"1.5 kN/m\" } }\n";
    let found = answer(text, None, None);
    assert_eq!(found.situations[0].line, ("load.crane.force".to_owned(), true));
    // Of the law what is below zero is cut.
    let exact = below((6.0 - 10.0) / 1.5) / (1.0 - below(-6.0 / 1.5));
    assert_close("lifted", found.situations[0].lifted.value, exact, 1e-9);
}

/// The largest of 50 draws of a law that is cut below: F⁵⁰ with F renormalised before it is raised, so that nothing else than cutting the
/// largest would do.
#[test]
fn the_largest_of_many_is_of_a_law_that_is_cut_first() {
    let law = "{ max_of = { count = 50, normal = { mean = 0.3, sd = 0.06 }, lower = 0.33, upper = 0.55 } }";
    let text = format!("[point]\ngamma = 0.8\nk_prime = 0.4\nmu = 0.5\n[random]\nk = {law}\n");
    let z = |x: f64| (x - 0.3) / 0.06;
    let share = (below(z(0.5)) - below(z(0.33))) / (below(z(0.55)) - below(z(0.33)));
    assert_close("P", answer(&text, None, None).situations[0].not_rest.value, 1.0 - share.powi(50), 1e-9);
}

/// Where the boundaries of several modes meet at an end of a uniform law, rounding there makes no kinks of them: three numbers are integrated
/// within half a million evaluations. With fewer allowed the integral is given up for points, and says so. By hand it rests where k < μ and
/// k γ (1 + k') < 1.
#[test]
fn an_integral_is_bounded() {
    let text = "[point]\ngamma = 0.8\nk_prime = 1\n[random]\nmu = { lognormal = { mean = 0.6, cov = 0.15 } }\n\
                k = { gumbel = { mean = 0.3, sd = 0.08 }, lower = 0 }\nk_prime = { uniform = { from = 0.8, to = 1.2 } }\n";
    let scale = 0.08 * 6.0_f64.sqrt() / std::f64::consts::PI;
    let mode = 0.3 - 0.577_215_664_901_532_9 * scale;
    let gumbel = |k: f64| (-(-(k - mode) / scale).exp()).exp();
    let density = |k: f64| gumbel(k) * (-(k - mode) / scale).exp() / scale / (1.0 - gumbel(0.0));
    let moves =
        |k: f64| 1.0 - lognormal_above(k, 0.6, 0.15) * ((1.0 / (0.8 * k) - 1.8) / 0.4).clamp(0.0, 1.0);
    let simpson = |from: f64, to: f64| {
        let h = (to - from) / 800.0;
        let at = |i: u32| from + f64::from(i) * h;
        let weight = |i: u32| if i == 0 || i == 800 { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
        (0..=800).map(|i| weight(i) * density(at(i)) * moves(at(i))).sum::<f64>() * h / 3.0
    };
    // Kinks are where the range of k' begins and ends to matter.
    let ends = [1e-9, 1.0 / (0.8 * 2.2), 1.0 / (0.8 * 1.8), 3.0];
    let exact: f64 = ends.windows(2).map(|pair| simpson(pair[0], pair[1])).sum();
    let integrated = answer(text, None, None).situations.remove(0);
    assert_eq!((integrated.method, integrated.given_up), (Method::Integrate, false));
    assert_close("P", integrated.not_rest.value, exact, 1e-8);
    assert!(integrated.points < 1 << 19, "{}", integrated.points);
    let effort = Effort { points: 20_000, seed: 2, ..Effort::default() };
    let request = ChanceRequest { effort, ..ChanceRequest::default() };
    let bounded = Probability::of(&CaseFile::parse("case", text).unwrap(), request).unwrap();
    let chances = &bounded.situations[0];
    assert_eq!((chances.method, chances.given_up), (Method::Sobol, true));
    assert!(chances.points <= 20_000, "{}", chances.points);
    assert!(
        chances.not_rest.low <= exact && exact <= chances.not_rest.high,
        "{:?} {exact}",
        chances.not_rest
    );
    assert!(bounded.text(&()).contains("An integral would take too long: sobol points took its place."));
}
