//! Factors on loads that vary in a sweep: against sums by hand, draws of `[random]` and a case with other forces; results of the sea.

use standfast_cases::random::{Draws, Happening};
use standfast_cases::results::{ResultValue, SeaResult};
use standfast_cases::sweep::{Factor, NoFactor, Sweep, SweepResult};
use standfast_cases::{Assessment, CaseFile, Problem};

const GODA: &str = include_str!("../../../examples/goda-2000.toml");
const RANDOM: &str = include_str!("../../../examples/goda-2000-random.toml");

/// The results of these names, where the numbers of these names have these values.
fn answered(text: &str, varied: &[(&str, f64)], results: &[&str]) -> Vec<f64> {
    let file = CaseFile::parse("case", text).unwrap();
    let factors = varied.iter().map(|(name, _)| Factor::find(name, None, file.inputs()).unwrap());
    let sweep = Sweep::of(&file, factors.collect()).unwrap();
    let values: Vec<_> = varied.iter().map(|(_, value)| *value).collect();
    let answer = sweep.answer(&mut sweep.scratch(), &values).unwrap();
    let number = |name: &&str| match answer.get(SweepResult::find(name).unwrap()) {
        ResultValue::Number(number) => number,
        other => panic!("{name} is {other:?}"),
    };
    results.iter().map(number).collect()
}

fn assert_near(found: f64, expected: f64, scale: f64) {
    assert!((found - expected).abs() <= 1e-12 * scale, "{found}, and {expected} by hand");
}

/// Thrust and uplift times their factors, and their moments with them or by factors of their own: sums by hand of the plain answer.
#[test]
fn waves_are_multiplied() {
    let names =
        ["P", "M_p", "U", "M_U", "buoyant_weight", "weight_arm", "margin_sliding", "margin_overturning_heel"];
    let plain = answered(GODA, &[("friction", 0.6)], &names);
    let [p, m_p, u, m_u, weight, arm, ..] = plain[..] else { panic!() };
    for [of_p, of_u, of_mp, of_mu] in [[0.9, 0.7, 0.9, 0.7], [1.1, 0.8, 0.6, 1.3], [0.0, 1.0, 0.0, 1.0]] {
        let mut varied = vec![("friction", 0.6), ("bias.P", of_p), ("bias.U", of_u)];
        if (of_mp, of_mu) != (of_p, of_u) {
            varied.extend([("bias.M_p", of_mp), ("bias.M_U", of_mu)]);
        }
        let found = answered(GODA, &varied, &names);
        for (found, expected) in found.iter().zip([of_p * p, of_mp * m_p, of_u * u, of_mu * m_u, weight, arm])
        {
            assert_near(*found, expected, expected.abs().max(p));
        }
        assert_near(found[6], 0.6 * (weight - of_u * u) - of_p * p, p);
        assert_near(found[7], weight * arm - of_mu * m_u - of_mp * m_p, m_p);
    }
}

/// Forces times a factor are the forces of another case, at their elevations; on a boundary, too, where decimals decide.
#[test]
fn forces_are_multiplied() {
    let block = |force: &str| {
        format!(
            "[body]\nwidth = 1\nheight = 1\nmass = 200\nfriction = 0.5\n[[load]]\nforce = {force}\nelevation = 0.25\n\
             [[load]]\nforce = 30\nelevation = 0.75\npermanent = true\n"
        )
    };
    let results = ["P", "M_p", "load_factor", "SF_sliding"];
    let twice = block("200").replace("force = 30", "force = 60");
    for (text, factor) in [(block("100"), 2.0), (block("400").replace("force = 30", "force = 120"), 0.5)] {
        let found = answered(&text, &[("bias.force", factor)], &results);
        let expected = answered(&twice, &[("friction", 0.5)], &results);
        found.iter().zip(expected).for_each(|(found, expected)| assert_near(*found, expected, expected));
    }
    // μ m g = 0.5 · 200 · 9.81 = 981 N, which half of the force 1962 is: on the boundary, the body rests.
    let still = |force: f64, factor: f64| {
        let text = block(&force.to_string());
        let text = text.rsplit_once("[[load]]").unwrap().0;
        let file = CaseFile::parse("case", text).unwrap();
        let bias = Factor::find("bias.force", None, file.inputs()).unwrap();
        let sweep = Sweep::of(&file, vec![bias]).unwrap();
        let answer = sweep.answer(&mut sweep.scratch(), &[factor]).unwrap();
        answer.get(SweepResult::find("mode").unwrap()) == ResultValue::Word("RE")
    };
    assert!(still(981.0, 1.0) && still(1962.0, 0.5) && !still(1962.1, 0.5) && !still(981.0, 1.0001));
}

/// Draws of `[random]` as columns: the mode of each is that of the draw.
#[test]
fn a_sweep_of_draws_has_their_modes() {
    let file = CaseFile::parse("case", RANDOM).unwrap();
    let draws = Draws::of(&file, None, 2000, 7).unwrap();
    let factors = draws.inputs.iter().map(|(name, _)| Factor::find(name, None, file.inputs()).unwrap());
    let sweep = Sweep::of(&file, factors.collect()).unwrap();
    let (mut scratch, mode) = (sweep.scratch(), SweepResult::find("mode").unwrap());
    let mut moved = 0;
    for (place, drawn) in draws.drawn.iter().enumerate() {
        let values: Vec<f64> = draws.values.iter().map(|column| column[place]).collect();
        let found = sweep.answer(&mut scratch, &values).unwrap();
        let Happening::Decided(verdict) = drawn.happens else { panic!("draw {place}") };
        assert_eq!(found.get(mode), ResultValue::Word(verdict.symbol()), "draw {place}");
        moved += usize::from(verdict.symbol() != "RE");
    }
    assert!((30..100).contains(&moved), "{moved} of 2000");
}

#[test]
fn a_factor_is_on_loads_that_there_are_and_is_not_negative() {
    let file = CaseFile::parse("case", GODA).unwrap();
    let missing = Factor::find("bias.force", None, file.inputs()).unwrap_err();
    assert!(matches!(missing, NoFactor::NoLoad { .. }), "{missing}");
    assert_eq!(missing.to_string(), "the case has no [[load]] for `bias.force` to be a factor on");
    let metres = Factor::find("bias.P", Some("m"), file.inputs()).unwrap_err();
    assert!(matches!(metres, NoFactor::Unit { .. }), "{metres}");
    let factors = ["friction", "bias.U"].map(|name| Factor::find(name, None, file.inputs()).unwrap());
    let sweep = Sweep::of(&file, factors.to_vec()).unwrap();
    for wrong in [-0.1, f64::NAN, f64::INFINITY] {
        let fault = sweep.answer(&mut sweep.scratch(), &[0.6, wrong]).unwrap_err();
        assert!(matches!(fault.problem, Problem::Bias { name: "bias.U", .. }), "{fault}");
        assert_eq!(sweep.blamed(&fault), [1]);
    }
}

/// What the waves come to is that of the case file with the same height.
#[test]
fn results_of_the_sea_are_those_of_the_file() {
    let higher = GODA.replace("deep_water_height = \"6.3 m\"", "deep_water_height = \"7 m\"");
    assert_ne!(higher, GODA, "the example has another height");
    let file = CaseFile::parse("case", &higher).unwrap();
    let assessment = Assessment::of_file(&file).unwrap();
    let goda = &assessment.case.goda().unwrap().goda;
    let names: Vec<_> = SeaResult::ALL.iter().map(|result| result.name()).collect();
    let found = answered(GODA, &[("wave.deep_water_height", 7.0)], &names);
    let expected = [goda.h_13, goda.h_max, goda.deep_water_wavelength, goda.wavelength, goda.h_b];
    assert_eq!(found[..5], expected);
    assert_eq!(found[found.len() - 4..], [goda.p1, goda.p3, goda.p4, goda.pu]);
}

/// The text of Goda's caisson with other heights.
fn with_heights(text: &str, heights: &str) -> String {
    text.replace("deep_water_height = \"6.3 m\"\n", heights)
}

/// A factor on the height in deep water is that height times it; one on those at the wall, these as they are found times it; in tables and
/// combinations.
#[test]
fn heights_are_multiplied() {
    let results = ["P", "U", "H13", "Hmax", "SF_sliding", "load_factor"];
    let near = |found: Vec<f64>, expected: Vec<f64>| {
        found
            .iter()
            .zip(expected)
            .for_each(|(found, expected)| assert_near(*found, expected, expected.abs()));
    };
    for factor in [0.5, 0.87, 1.2] {
        let typed = with_heights(GODA, &format!("deep_water_height = {}\n", 6.3 * factor));
        near(
            answered(GODA, &[("bias.H0", factor)], &results),
            answered(&typed, &[("friction", 0.6)], &results),
        );
        let own = answered(GODA, &[("friction", 0.6)], &results);
        let heights = format!("H13 = {}\nHmax = {}\n", own[2] * factor, own[3] * factor);
        let typed = with_heights(GODA, &heights);
        near(
            answered(GODA, &[("bias.H", factor)], &results),
            answered(&typed, &[("friction", 0.6)], &results),
        );
        // Of heights that are given at the wall, and beside a factor on the thrust and one in a combination.
        let given = with_heights(GODA, &format!("H13 = {}\nHmax = {}\n", own[2], own[3]));
        near(
            answered(&given, &[("bias.H", factor), ("bias.P", 0.9)], &results),
            answered(&typed, &[("bias.P", 0.9)], &results),
        );
        let combination =
            "\n[[combination]]\nname = \"storm\"\nset = { friction = 0.5 }\nfactors = { wave = 1.3 }\n";
        near(
            answered(&format!("{GODA}{combination}"), &[("bias.H", factor)], &results[4..]),
            answered(&format!("{typed}{combination}"), &[("wave.water_density", 1030.0)], &results[4..]),
        );
    }
    // Both at once.
    let both = answered(GODA, &[("bias.H0", 1.1), ("bias.H", 0.8)], &results);
    let typed = with_heights(GODA, "deep_water_height = 6.93\n");
    near(both, answered(&typed, &[("bias.H", 0.8)], &results));
}

/// A factor on what the base bears is a strength times it; of ground its resistance.
#[test]
fn what_the_base_bears_is_multiplied() {
    let text = |strength: f64| format!("{GODA}\n[ground]\nstrength = {strength}\n");
    let results = ["load_factor", "SF_bearing"];
    let known: Vec<&str> = results.into_iter().filter(|name| SweepResult::find(name).is_some()).collect();
    let found = answered(&text(600e3), &[("bias.R", 0.75)], &known);
    assert_eq!(found, answered(&text(450e3), &[("friction", 0.6)], &known));
    let soil = include_str!("../../../examples/goda-on-sand.toml");
    let factor = |bias: f64| answered(soil, &[("bias.R", bias)], &["ground_factor"])[0];
    assert_near(factor(0.8), 0.8 * factor(1.0), 1.0);
}

/// As random numbers they are the same: one value of each, as likely as can be, is a typed one, in modes, over a life and in a storm.
#[test]
fn random_factors_are_typed_ones() {
    use standfast_cases::random::{ChanceRequest, Effort, Probability};
    let one = |name: &str, value: f64| {
        format!("{name} = {{ discrete = {{ values = [{value}], probabilities = [1] }} }}\n")
    };
    let request =
        ChanceRequest { effort: Effort { precision: 0.01, ..Effort::default() }, ..ChanceRequest::default() };
    let answer = |text: &str| {
        let found = Probability::of(&CaseFile::parse("case", text).unwrap(), request);
        found.unwrap_or_else(|error| panic!("{error}\n{text}"))
    };
    let own = answered(GODA, &[("friction", 0.6)], &["H13", "Hmax"]);
    let friction = "\n[random]\nfriction = { lognormal = { mean = 0.636, cov = 0.15 } }\n";
    let not_rest = |text: &str| answer(text).situations[0].not_rest.value;
    for (random, typed) in [
        (one("bias.H0", 0.87), with_heights(GODA, &format!("deep_water_height = {}\n", 6.3 * 0.87))),
        (
            one("bias.H", 0.87),
            with_heights(GODA, &format!("H13 = {}\nHmax = {}\n", 0.87 * own[0], 0.87 * own[1])),
        ),
    ] {
        let [found, expected] =
            [not_rest(&format!("{GODA}{friction}{random}")), not_rest(&format!("{typed}{friction}"))];
        assert!(expected > 1e-4, "{expected}");
        assert_near(found, expected, 10.0 * expected);
    }
    // Heights of other years, each times the error of the transformation: a Gumbel law times a factor is a Gumbel law.
    let sea = |mean: f64, sd: f64| {
        format!(
            "years = 50\nwave.deep_water_height = {{ gumbel = {{ mean = {mean}, sd = {sd} }}, lower = 0.5, every = \"year\" }}\n"
        )
    };
    let [biased, typed] =
        [sea(4.5, 0.5) + &one("bias.H0", 1.1), sea(4.95, 0.55).replace("lower = 0.5", "lower = 0.55")]
            .map(|sea| answer(&format!("{GODA}{friction}{sea}")));
    let life = |found: &Probability| found.situations[0].life.as_ref().unwrap().not_rest.value;
    // The one is drawn, the other integrated.
    assert!((life(&biased) / life(&typed) - 1.0).abs() < 0.02, "{}, {}", life(&biased), life(&typed));
    let storm = "\n[storm]\nwaves = 500\ntau0 = \"1.5 s\"\n";
    let slide = |text: String| answer(&text).sliding.unwrap().mean.value;
    let given = with_heights(GODA, &format!("H13 = {}\nHmax = {}\n", 0.9 * own[0], 0.9 * own[1]));
    let expected = slide(format!("{given}{storm}{friction}"));
    let found = slide(format!("{GODA}{storm}{friction}{}", one("bias.H", 0.9)));
    assert!((found / expected - 1.0).abs() < 0.02, "{found}, {expected}");
    // Ground: one number more.
    let soil =
        include_str!("../../../examples/goda-on-sand.toml").split("[criteria]").next().unwrap().to_owned();
    let [found, expected] =
        [(one("bias.R", 0.8), "ec7", 1.0), (String::new(), "ec7", 0.8)].map(|(random, law, share)| {
            // Without weight of its own below, R is that of its cohesion, which is in proportion.
            let text =
                soil.replace("law = \"ec7\"", &format!("law = \"{law}\"\ncohesion = {}", 60e3 * share));
            let text = text.replace("unit_weight = \"10 kN/m3\"", &format!("unit_weight = {}", 1e4 * share));
            not_rest(&format!("{text}{friction}{random}"))
        });
    assert_near(found, expected, 1e4 * expected);
}

/// What a factor has nothing to be on is refused by name.
#[test]
fn factors_without_anything_to_be_on_are_refused() {
    let refused = |text: &str, name: &str| {
        let file = CaseFile::parse("case", text).unwrap();
        let of_table = Factor::find(name, None, file.inputs()).unwrap_err().to_string();
        let random = format!("{text}\n[random]\n{name} = {{ normal = {{ mean = 1, sd = 0.1 }} }}\n");
        let file = CaseFile::parse("case", &random).unwrap();
        let of_random =
            standfast_cases::random::Probability::of(&file, Default::default()).unwrap_err().to_string();
        [of_table, of_random]
    };
    let local = with_heights(GODA, "H13 = 5\nHmax = 7\n");
    for (text, name, lacks) in [
        (&local[..], "bias.H0", "no wave height in deep water, but those at the wall, on which `bias.H` is"),
        (GODA, "bias.R", "no [ground] with a strength or a law"),
        (
            "[body]\nwidth = 1\nheight = 1\nmass = 200\nfriction = 0.5\n[[load]]\nforce = 3\nelevation = 0.2\n",
            "bias.H",
            "no waves",
        ),
        (GODA, "bias.force", "no [[load]]"),
        (
            include_str!("../../../examples/crown-wall-by-pedersen.toml"),
            "bias.H",
            "no waves by Goda’s formulas",
        ),
    ] {
        let [of_table, of_random] = refused(text, name);
        assert_eq!(of_table, format!("the case has {lacks} for `{name}` to be a factor on"));
        assert!(of_random.contains(&format!("the case has {lacks}")), "{of_random}");
    }
}
