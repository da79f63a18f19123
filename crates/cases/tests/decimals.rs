//! Cases whose decimals put them exactly on a boundary, or a last digit beside it; the witness is whole numbers of digits.
//!
//! W = ρ w h g is a decimal if ρ, w, h and g are; a push F = μ W slides the body with the least more, and F = W w/(2e) at an elevation e
//! overturns it. Both are written to the last digit, as people put round numbers there.

use standfast::{Boundary, Departure, Mode};
use standfast_cases::sweep::{Factor, Sweep, SweepResult};
use standfast_cases::{Assessment, AssessmentView, CaseFile, Document};

/// A generator of whole numbers.
struct Dice(u64);

impl Dice {
    /// From `least` to `most`.
    fn roll(&mut self, least: u64, most: u64) -> i128 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i128::from(least + (self.0 >> 33) % (most - least + 1))
    }
}

/// `digits` · 10^−`places`, as a person writes it.
fn decimal(digits: i128, places: usize) -> String {
    let text = format!("{digits:0width$}", width = places + 1);
    let (whole, rest) = text.split_at(text.len() - places);
    format!("{whole}.{rest}0")
}

fn assess(text: &str) -> Assessment {
    let file = CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{error}: {text}"));
    Assessment::of_file(&file).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// A block of `width` and `height` in cm and `density` in kg/m³ with friction in thousandths, in water as deep as `level` cm.
struct Block {
    width: i128,
    height: i128,
    density: i128,
    friction: i128,
    level: i128,
}

impl Block {
    fn random(dice: &mut Dice, wet: bool) -> Block {
        let height = dice.roll(100, 3000);
        Block {
            width: 2 * dice.roll(50, 1500),
            height,
            density: dice.roll(1100, 2999),
            friction: dice.roll(100, 990),
            level: if wet { dice.roll(1, height as u64) } else { 0 },
        }
    }

    /// Force that presses it down, in 10⁻⁶ N: (ρ h − ρ_w level) w g.
    fn pressing(&self) -> i128 {
        (self.density * self.height - 1030 * self.level) * self.width * 981
    }

    fn text(&self, force: &str, elevation: &str, direction: &str) -> String {
        let water = match self.level {
            0 => String::new(),
            level => format!("[water]\nlevel = \"{level} cm\"\ndensity = \"1.03 t/m3\"\n"),
        };
        format!(
            "[body]\nwidth = {}\nheight = \"{} cm\"\ndensity = \"{} t/m3\"\nfriction = {}\n{water}[[load]]\nforce = \"{force} kN/m\"\n\
             elevation = {elevation}\ndirection = \"{direction}\"\n[criteria]\nSF_sliding = 1\nSF_overturning_net = 1\n",
            decimal(self.width, 2),
            self.height,
            decimal(self.density, 3),
            decimal(self.friction, 3)
        )
    }
}

/// Everything that is said of a body on the boundary, and of one beside it.
fn holds(text: &str, beyond: Option<Mode>, next: Mode, of: impl Fn(&Assessment) -> f64) {
    let answer = assess(text);
    let outcome = &answer.all[0].outcome;
    let factor = of(&answer);
    assert_eq!(outcome.full.mode(), Some(beyond.unwrap_or(Mode::Rest)), "{text}");
    assert!(answer.all[0].outcome.full.is_unique(), "{text}");
    let Departure::At { factor: departs, .. } = outcome.departure else { panic!("{text}") };
    let met = answer.checks().iter().all(|check| check.check.met);
    match beyond {
        None if outcome.full.boundary == Some(Boundary::Exact) => {
            assert_eq!((factor, departs, met), (1.0, 1.0, true), "{text}");
            let words = answer.text(&AssessmentView::default());
            assert!(!words.lines().any(|line| line.contains("holds by") && line.contains("e-1")), "{words}");
            let least = format!(
                "exactly on the boundary: with the least more load the body {} ({next})",
                next.words()
            );
            assert!(
                words.replace('\n', " ").split_whitespace().collect::<Vec<_>>().join(" ").contains(&least),
                "{words}"
            );
        }
        None => assert!(factor >= 1.0 && departs >= 1.0 && met, "{text}: {factor} {departs}"),
        Some(_) => assert!(factor < 1.0 && departs <= 1.0 && !met, "{text}: {factor} {departs}"),
    }
}

/// As a person writes it: to the last digit, a digit less and a digit more, in air and in water.
#[test]
fn bodies_on_the_boundary_of_sliding_rest() {
    let mut dice = Dice(1);
    for round in 0..250 {
        let block = Block::random(&mut dice, round % 2 == 1);
        if block.pressing() <= 0 {
            continue;
        }
        // μ P in 10⁻⁹ N: in kN there are twelve decimals. Pushed low enough, it does not turn.
        let force = block.pressing() * block.friction;
        let [side, slides] = if round % 3 == 0 { ["right", "SL+"] } else { ["left", "SL"] };
        let slides: Mode = slides.parse().unwrap();
        let text = |force: i128| block.text(&decimal(force, 12), "0.01", side);
        let sliding = |answer: &Assessment| answer.all[0].outcome.stability.sliding;
        holds(&text(force), None, slides, sliding);
        assert_eq!(
            assess(&text(force)).all[0].outcome.full.boundary,
            Some(Boundary::Exact),
            "{}",
            text(force)
        );
        holds(&text(force - 1), None, slides, sliding);
        holds(&text(force + 1), Some(slides), slides, sliding);
    }
}

#[test]
fn bodies_on_the_boundary_of_overturning_rest() {
    let mut dice = Dice(2);
    let mut tried = 0;
    for round in 0..300 {
        let block = Block { friction: 50_000, ..Block::random(&mut dice, round % 2 == 1) };
        // At 0.5, 1, 2 or 4 m: P w/(2 · 100 e) in 10⁻⁶ N, with three decimals more.
        let elevation = [50, 100, 200, 400][round % 4];
        if block.pressing() <= 0 || elevation > block.height {
            continue;
        }
        tried += 1;
        let force = block.pressing() * block.width * 1000 / (2 * elevation);
        let [side, rocks] = if round % 3 == 0 { ["right", "RO'"] } else { ["left", "RO"] };
        let rocks: Mode = rocks.parse().unwrap();
        let text = |force: i128| block.text(&decimal(force, 12), &decimal(elevation, 2), side);
        let overturning = |answer: &Assessment| answer.all[0].outcome.stability.overturning();
        holds(&text(force), None, rocks, overturning);
        let exact = assess(&text(force));
        let outcome = &exact.all[0].outcome;
        assert_eq!(outcome.full.boundary, Some(Boundary::Exact), "{}", text(force));
        assert_eq!((outcome.margins.overturning(), outcome.stability.resultant_arm), (0.0, Some(0.0)));
        holds(&text(force - 1), None, rocks, overturning);
        holds(&text(force + 1), Some(rocks), rocks, overturning);
    }
    assert!(tried > 200, "{tried}");
}

/// 3 × 5 m of 2.4 t/m³: W = 353.16 kN/m, and 353.16 · 1.5/2 = 264.870 kN/m at 2 m overturns it with the least more.
#[test]
fn a_round_number_on_overturning_rests_with_a_factor_of_one() {
    let text = |force: &str| {
        format!(
            "[body]\nwidth = \"3 m\"\nheight = \"5 m\"\ndensity = \"2.4 t/m3\"\nfriction = 50\n[[load]]\nforce = \"{force} kN/m\"\n\
             elevation = \"2 m\"\n[criteria]\nSF_overturning_net = 1\n"
        )
    };
    holds(&text("264.870"), None, Mode::RockO, |answer| answer.all[0].outcome.stability.overturning());
    // More digits than an f64 has.
    let beyond = assess(&text("264.870000000000000000000000001"));
    assert_eq!(beyond.all[0].outcome.full.mode(), Some(Mode::RockO));
    assert!(beyond.all[0].outcome.stability.overturning() < 1.0);
    assert_eq!(assess(&text("264.869999999999999999999999999")).all[0].outcome.full.mode(), Some(Mode::Rest));
}

/// What the boundary is that is asked for: a factor that is exactly 1.1 meets 1.1, and not with a last digit more of the force.
#[test]
fn criteria_are_met_by_decimals() {
    let text = |force: &str, elevation: &str, friction: &str| {
        format!(
            "[body]\nwidth = 8\nheight = 8\nmass = 150e3\nbuoyant_weight = \"286 kN/m\"\nfriction = {friction}\n[[load]]\n\
             force = \"{force} kN/m\"\nelevation = {elevation}\n[criteria]\nSF_sliding = 1.1\nSF_overturning_net = 1.1\nload_factor = 1.1\n"
        )
    };
    // 0.5 · 286/130 = 1.1, and 286 · 4/(130 · 8) = 1.1.
    for (elevation, friction) in [("1", "0.5"), ("8", "9")] {
        let met = |force: &str| {
            let answer = assess(&text(force, elevation, friction));
            let outcome = &answer.all[0].outcome;
            let factor = outcome.stability.sliding.min(outcome.stability.overturning());
            assert_eq!(outcome.departure.load_factor(), factor, "{force}");
            (factor, answer.checks().iter().all(|check| check.check.met))
        };
        assert_eq!(met("130"), (1.1, true));
        assert!(met("129.99999").1 && !met("130.00001").1);
    }
}

/// Digits beyond those of f64 count wherever they stand: in a force, a factor of a combination, a list; and everything that is said of the
/// body agrees, though f64 cannot tell its numbers from those of the boundary.
#[test]
fn long_decimals_count_wherever_they_stand() {
    let body = "gravity = 10\n[body]\nwidth = 8\nheight = 8\nmass = 100e3\nfriction = 0.5\n";
    let force =
        |force: &str| format!("{body}[[load]]\nname = \"T\"\nforce = \"{force} kN/m\"\nelevation = 2\n");
    let combined = |factor: &str| {
        format!("{}[[combination]]\nname = \"K\"\nfactors = {{ T = {factor} }}\n", force("500"))
    };
    let pressed = |pressure: &str| {
        format!(
            "{body}[[pressure]]\nface = \"right\"\nelevation = [0, 5]\npressure = [\"{pressure} kPa\", \"100 kPa\"]\n"
        )
    };
    let tries: [&dyn Fn(&str) -> String; 3] = [&force, &combined, &pressed];
    for (text, [on, inside, beyond]) in tries.into_iter().zip([
        ["500", "499.99999999999999999999", "500.00000000000000000001"],
        ["1", "0.99999999999999999999", "1.00000000000000000001"],
        ["100", "99.99999999999999999999", "100.00000000000000000001"],
    ]) {
        for (number, mode) in [(on, Mode::Rest), (inside, Mode::Rest), (beyond, Mode::SlideLeft)] {
            let answer = assess(&text(number));
            let outcome = &answer.all[0].outcome;
            let moves = mode != Mode::Rest;
            assert_eq!(outcome.full.mode(), Some(mode), "{}", text(number));
            assert_eq!(outcome.full.boundary, (number == on).then_some(Boundary::Exact), "{}", text(number));
            assert_eq!(outcome.stability.sliding < 1.0, moves, "{}", text(number));
            assert_eq!(outcome.departure.load_factor() < 1.0, moves, "{}", text(number));
            assert_eq!(outcome.departure.mode(), Some(Mode::SlideLeft));
            assert_eq!(outcome.margins.sliding < 0.0, moves, "{}", text(number));
            assert_eq!(outcome.full.motion.unwrap().x_ddot < 0.0, moves, "{}", text(number));
        }
    }
}

/// A row of a table is answered as the case that says the same.
#[test]
fn a_table_s_decimals_are_as_exact() {
    let text = "[body]\nwidth = 15.1\nheight = 6.8\ndensity = 1710\nfriction = 0.47\n[[load]]\nforce = 1\nelevation = 0.1\n";
    let file = CaseFile::parse("case.toml", text).unwrap();
    let sweep = Sweep::of(&file, vec![Factor::find("load[1].force", None, file.inputs()).unwrap()]).unwrap();
    let mode = SweepResult::find("mode").unwrap();
    let mut scratch = sweep.scratch();
    // 0.47 · 1710 · 15.1 · 6.8 · 9.81
    for (force, expected) in [(809_559.615_96, "RE"), (809_559.615_97, "SL"), (809_559.615_95, "RE")] {
        let answer = sweep.answer(&mut scratch, &[force]).unwrap();
        assert_eq!(answer.get(mode), standfast_cases::results::ResultValue::Word(expected), "{force}");
    }
}

/// π is no decimal: a drum that is pushed with μ m g, as far as f64 has it, may rest and may slide.
#[test]
fn what_is_not_rational_is_on_the_boundary_to_its_digits() {
    let mass = 2400.0 * std::f64::consts::PI * 3.0 * 3.0 / 4.0 * 5.0;
    let text = |force: f64| {
        format!(
            "[body]\nshape = \"cylinder\"\nwidth = 3\nheight = 5\ndensity = 2400\nfriction = 0.5\n[[load]]\nforce = {force}\nelevation = 0.1\n"
        )
    };
    for off in [-1e-15, 0.0, 1e-15] {
        let answer = assess(&text(0.5 * mass * 9.81 * (1.0 + off)));
        let full = &answer.all[0].outcome.full;
        assert_eq!((full.mode(), full.boundary), (Some(Mode::Rest), Some(Boundary::ToTheDigits)), "{off}");
        assert!(full.modes.contains(Mode::SlideLeft) && !answer.all[0].outcome.full.is_unique());
        assert_eq!(answer.all[0].outcome.stability.sliding, 1.0);
        let words = answer.text(&AssessmentView::default());
        assert!(words.contains("To the digits given"), "{words}");
    }
    for (off, expected) in [(1e-12, Mode::SlideLeft), (-1e-12, Mode::Rest)] {
        let answer = assess(&text(0.5 * mass * 9.81 * (1.0 + off)));
        assert_eq!(answer.all[0].outcome.full.mode(), Some(expected));
        assert!(answer.all[0].outcome.full.is_unique());
    }
}

/// At every distance from a boundary that is known to some digits only, all that is said agrees: a body that may rest has a factor of 1
/// at least, meets it, and leaves rest at its load or beyond.
#[test]
fn what_is_known_to_some_digits_is_said_alike_everywhere() {
    let text = |share: String| {
        format!(
            "[body]\nshape = \"cylinder\"\nwidth = 1.2\nheight = 0.6\ndensity = 2720\nfriction = 0.5\n[earthquake]\n\
             horizontal = \"{share} g\"\nhorizontal_fixed = true\n[criteria]\nSF_sliding = 1\nload_factor = 1\n"
        )
    };
    let mut open = 0;
    for digit in 0..60 {
        // 0.5 ± 3e-12 in steps of 1e-13.
        let answer = assess(&text(decimal(5_000_000_000_000 + digit - 30, 13)));
        let outcome = &answer.all[0].outcome;
        let (rests, sliding) = (outcome.full.mode() == Some(Mode::Rest), outcome.stability.sliding);
        assert_eq!(rests, digit <= 30 || outcome.full.boundary.is_some(), "{digit}");
        assert_eq!(rests, sliding >= 1.0, "{digit}: {sliding}");
        assert_eq!(rests, outcome.departure.load_factor() >= 1.0, "{digit}: {:?}", outcome.departure);
        assert_eq!(rests, outcome.margins.sliding >= 0.0, "{digit}");
        assert_eq!(rests, answer.checks().iter().all(|check| check.check.met), "{digit}");
        let modes = outcome.full.modes;
        let is_open = outcome.full.boundary == Some(Boundary::ToTheDigits);
        assert_eq!(modes.contains(Mode::Rest) && modes.contains(Mode::SlideLeft), is_open, "{digit}");
        open += usize::from(is_open);
    }
    assert!((1..10).contains(&open), "{open}");
}
