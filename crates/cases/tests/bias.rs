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
