//! Chances of bodies on joints: which joint leaves rest first.

mod common;

use common::{file, near};
use standfast::contact::stack::RestLimit;
use standfast_answers::results::ResultValue;
use standfast_answers::sweep::{Factor, Sweep, SweepResult};
use standfast_cases::random::{
    ChanceProblem, ChanceRequest, Chances, Draws, Effort, FirstJoint, Happening, Method, Probability,
};
use standfast_cases::{Assessment, Document};
use standfast_probability::problem::{Outcomes, Pieces};

const QUAY: &str = include_str!("../../../examples/joints/blockwork-quay.toml");
const DAM: &str = include_str!("../../../examples/joints/dam-with-lift-joints.toml");
const CROWN: &str = include_str!("../../../examples/joints/crown-wall-on-caisson.toml");

/// Two blocks, 80 kN/m below and 60 kN/m above, pushed at the top of the upper one, which stands in the middle of the lower.
const PAIR: &str = "gravity = 10\n[body]\nfriction = 0.6\n\
    [[part]]\nname = \"lower\"\nleft = 0\nwidth = 4\nbottom = 0\nheight = 1\ndensity = 2000\n\
    [[part]]\nname = \"upper\"\nleft = 1\nwidth = 2\nbottom = 1\nheight = 1\ndensity = 3000\n\
    [[joint]]\nname = \"bed\"\nelevation = 1\nfriction = 0.5\n\
    [[load]]\nname = \"push\"\nforce = \"20 kN/m\"\nelevation = 2\n";

fn answer(text: &str, method: Option<Method>) -> Probability {
    let request = ChanceRequest { method, ..ChanceRequest::default() };
    Probability::of(&file(text), request).unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn of(chances: &Chances, joint: usize, slides: bool) -> f64 {
    let asked = Happening::First(FirstJoint { joint, slides });
    chances.modes.iter().find(|(happening, _)| *happening == asked).unwrap().1.value
}

/// P(X < x) of a uniform law.
fn uniform_below(x: f64, [from, to]: [f64; 2]) -> f64 {
    ((x - from) / (to - from)).clamp(0.0, 1.0)
}

/// By hand. The upper block slides under a push above 60 μ kN/m and turns at 60 · 1 / 1 = 60 kN/m; both together slide above 140 μ and turn at
/// 140 · 2 / 2 = 140.
#[test]
fn chances_of_two_blocks_by_hand() {
    let between = [0.2, 0.6];
    let upper = "[random]\n\"joint.bed.friction\" = { uniform = { from = 0.2, to = 0.6 } }\n";
    let found = answer(&format!("{PAIR}{upper}"), None);
    let chances = &found.situations[0];
    assert_eq!(found.line, ("joint.bed.friction".to_owned(), true));
    near(of(chances, 1, true), uniform_below(20.0 / 60.0, between), 1e-12);
    assert_eq!(of(chances, 0, true), 0.0);
    near(chances.not_rest.value, of(chances, 1, true), 1e-12);
    assert_eq!(chances.not_unique, None);
    // Under a push that rises without end the joint above slides at 60 μ ≤ 36, before anything else.
    let first = &chances.first_departure;
    assert_eq!([first.never.value, first.at_once.value], [0.0, 0.0]);
    near(first.modes.iter().map(|(_, e)| e.value).sum(), 1.0, 1e-12);
    // The base is as slippery as that, 140 μ₁ < 60 μ₂, where μ₁ < 0.5 · 60/140 = 0.2143: it goes before the joint does.
    let base = format!("{PAIR}[random]\nfriction = {{ uniform = {{ from = 0.05, to = 0.45 }} }}\n")
        .replace("20 kN/m", "32 kN/m");
    let chances = answer(&base, None).situations.remove(0);
    let between = [0.05, 0.45];
    near(of(&chances, 0, true), uniform_below(30.0 / 140.0, between), 1e-12);
    near(of(&chances, 1, true), 1.0 - uniform_below(30.0 / 140.0, between), 1e-12);
    assert_eq!(chances.not_rest.value, 1.0);
    // With a push of 25 the joint holds up to 30 and the base slides below 25/140.
    let gentle = base.replace("32 kN/m", "25 kN/m");
    let chances = answer(&gentle, None).situations.remove(0);
    near(of(&chances, 0, true), uniform_below(25.0 / 140.0, between), 1e-12);
    assert_eq!(of(&chances, 1, true), 0.0);
    // The push itself: from 30 on the joint slides, which is no more than a share of all.
    let push = format!(
        "{PAIR}[random]\n\"load.push.force\" = {{ uniform = {{ from = \"10 kN/m\", to = \"50 kN/m\" }} }}\n"
    );
    let found = answer(&push, None);
    assert_eq!(found.line, ("load.push.force".to_owned(), true));
    near(of(&found.situations[0], 1, true), 0.5, 1e-12);
    // On a rough joint it turns about its end at 60.
    let rough = push
        .replace("friction = 0.5", "friction = 5")
        .replace("50 kN/m", "110 kN/m")
        .replace("friction = 0.6", "friction = 3");
    near(of(&answer(&rough, None).situations[0], 1, false), 0.5, 1e-12);
    // A push at the joint itself acts on the upper block, and below it on the lower.
    let below = push.replace("elevation = 2", "elevation = 0.5").replace("friction = 0.6", "friction = 0.25");
    let chances = answer(&below, None).situations.remove(0);
    near(of(&chances, 0, true), 0.375, 1e-12);
    assert_eq!(of(&chances, 1, true), 0.0);
}

/// Of two blocks whose frictions are both random: the joint goes first where 60 μ₂ < 140 μ₁ and 60 μ₂ < 20.
#[test]
fn two_random_frictions_by_hand() {
    let text = format!(
        "{PAIR}[random]\nfriction = {{ uniform = {{ from = 0.1, to = 0.5 }} }}\n\
         \"joint.bed.friction\" = {{ uniform = {{ from = 0.1, to = 0.6 }} }}\n"
    );
    // The base holds 20 from μ₁ = 1/7 on. Below that (0.0429 of 0.4) the joint goes first where μ₂ < 7/3 μ₁, which is from 0.2333 to 0.3333.
    let below = (1.0 / 7.0 - 0.1) / 0.4;
    let mean = (7.0 / 3.0 * 0.5 * (0.1 + 1.0 / 7.0) - 0.1) / 0.5;
    let joint = below * mean + (1.0 - below) * (1.0 / 3.0 - 0.1) / 0.5;
    let base = below * (1.0 - mean);
    for method in [None, Some(Method::Sobol), Some(Method::MonteCarlo)] {
        let found = answer(&text, method);
        let chances = &found.situations[0];
        let by = if method.is_none() { 1e-9 } else { 0.03 };
        near(of(chances, 1, true), joint, by);
        near(of(chances, 0, true), base, 3.0 * by);
        near(chances.not_rest.value, joint + base, by);
    }
}

/// Each draw of a case is the departure of that case, which is found with signs that no rounding moves.
#[test]
fn every_draw_is_the_departure_of_its_case() {
    let laws = |names: &[(&str, &str)]| {
        names
            .iter()
            .fold("[random]\n".to_owned(), |text, (name, law)| text + &format!("\"{name}\" = {law}\n"))
    };
    let wide = "{ lognormal = { cov = 0.35 } }";
    let cases = [
        (
            QUAY.to_owned(),
            laws(&[
                ("friction", wide),
                ("joint.under the cap.friction", wide),
                ("joint.on course 2.friction", wide),
                ("load.bollard.force", "{ lognormal = { cov = 0.8 } }"),
                ("water.right", "{ normal = { cov = 0.1 } }"),
            ]),
        ),
        (
            DAM.to_owned(),
            laws(&[
                ("friction", wide),
                ("water.right", "{ normal = { cov = 0.04 } }"),
                ("load.ice.force", "{ lognormal = { cov = 1.5 } }"),
            ]),
        ),
        (
            CROWN.to_owned(),
            laws(&[
                ("friction", wide),
                ("wave.deep_water_height", wide),
                ("joint.crown wall on caisson.friction", wide),
            ]),
        ),
        // So rough that they turn.
        (
            QUAY.replace("friction = 0.55", "friction = 3").replace("friction = 0.6", "friction = 3"),
            laws(&[
                ("water.right", "{ normal = { cov = 0.1 } }"),
                ("load.bollard.force", "{ lognormal = { mean = \"90 kN/m\", cov = 0.9 } }"),
            ]),
        ),
        // Adhesion holds the base alone.
        (
            PAIR.replace("friction = 0.6", "friction = 0.3\nadhesion = \"2 kPa\"")
                .replace("20 kN/m", "30 kN/m"),
            laws(&[
                ("friction", wide),
                ("joint.bed.friction", wide),
                ("load.push.force", "{ lognormal = { cov = 0.5 } }"),
            ]),
        ),
    ];
    let mut seen = [[0; 2]; 4];
    for (text, random) in cases {
        let text = file(&format!("{text}\n{random}"));
        let drawn = Draws::of(&text, None, 150, 3).unwrap();
        let factors = drawn.inputs.iter().map(|(name, _)| Factor::find(name, None, text.inputs()).unwrap());
        let sweep = Sweep::of(&text, factors.collect()).unwrap();
        let mut scratch = sweep.scratch();
        for (place, draw) in drawn.drawn.iter().enumerate() {
            let values: Vec<f64> = drawn.values.iter().map(|column| column[place]).collect();
            let found = sweep.answer(&mut scratch, &values).unwrap();
            let one = found.governing();
            let leaves = &one.joints.as_ref().unwrap().leaves;
            let rests = leaves.load_factor >= 1.0 && !leaves.at_once;
            let Happening::First(first) = draw.happens else {
                assert_eq!((draw.happens, rests), (Happening::REST, true), "{values:?}");
                continue;
            };
            assert!(!rests, "{values:?}");
            let (joint, limit) = leaves.limits[0];
            let slides = match limit {
                Some(limit) => matches!(limit, RestLimit::Slides(_)),
                None => one.outcome.departure.verdict().and_then(|v| v.mode()).unwrap().corner().is_none(),
            };
            assert_eq!((first.joint, first.slides), (joint, slides), "{values:?}");
            seen[joint][usize::from(slides)] += 1;
        }
    }
    assert!(seen.iter().all(|of_joint| of_joint.iter().sum::<usize>() > 5), "{seen:?}");
    assert!(seen.iter().map(|[turns, _]| turns).sum::<usize>() > 5, "{seen:?}");
}

/// The outcomes along a line are those at each of its points.
#[test]
fn pieces_along_a_line_are_the_outcomes_at_its_points() {
    let laws = [
        "friction = { lognormal = { cov = 0.4 } }\n\"load.bollard.force\" = { lognormal = { cov = 0.9 } }\n",
        "\"joint.under the cap.friction\" = { lognormal = { cov = 0.6 } }\nfriction = { lognormal = { cov = 0.4 } }\n",
        "\"load.bollard.force\" = { lognormal = { cov = 2 } }\n\"water.left\" = { normal = { cov = 0.05 } }\n",
    ];
    // Permanent, so that it rests or not to begin with.
    let permanent = QUAY.replace("together = true", "together = true\npermanent = true");
    let mut changes = 0;
    for (law, text) in laws.iter().flat_map(|law| [(law, QUAY), (law, permanent.as_str())]) {
        let file = file(&format!("{text}\n[random]\n{law}"));
        for problem in ChanceProblem::of_file(&file).unwrap() {
            let line = problem.line();
            let laws = problem.laws().laws();
            for other in [-2.5, -1.0, 0.0, 1.5, 3.0] {
                let mut values: Vec<f64> = laws.iter().map(|law| law.value(other)).collect();
                let mut pieces = Pieces::default();
                problem.along(&values, &mut pieces);
                let ends: Vec<f64> =
                    pieces.iter().map(|piece| piece.to).filter(|to| to.is_finite()).collect();
                changes += ends.len();
                for step in -50..=50 {
                    values[line] = laws[line].value(0.11 * f64::from(step));
                    let held =
                        pieces.iter().filter(|piece| piece.from <= values[line] && values[line] < piece.to);
                    let held = held.fold(0, |set, piece| set | 1u64 << piece.outcome);
                    let at_an_end = ends.iter().any(|end| (end - values[line]).abs() <= 1e-9 * end.abs());
                    assert!(
                        held == problem.at(&values) || at_an_end,
                        "{law} {values:?}: {held:b}\n{pieces:?}"
                    );
                }
            }
        }
    }
    assert!(changes > 20, "{changes}");
}

/// Equal friction under a shaking ties all joints: the base is named, whatever rounding does.
#[test]
fn a_tie_is_told_of_the_lowest_joint() {
    let text = "[body]\nshape = \"cylinder\"\nwidth = 1.3\nheight = 1.9\ndensity = 2713\nfriction = 0.31\n\
        [[joint]]\nname = \"one\"\nelevation = 0.7\nfriction = 0.31\n[[joint]]\nname = \"two\"\nelevation = 1.3\nfriction = 0.31\n\
        [earthquake]\nhorizontal = \"0.3 g\"\n[random]\n\"earthquake.horizontal\" = { normal = { cov = 0.1 } }\n";
    for chances in &answer(text, None).situations {
        let slides = 1.0 - below((0.31 - 0.3) / 0.03);
        near(of(chances, 0, true), slides, 1e-6);
        assert_eq!([of(chances, 1, true), of(chances, 2, true)], [0.0, 0.0]);
    }
}

/// Φ by the trapezoidal rule on its density.
fn below(z: f64) -> f64 {
    let n = 10_000;
    let h = z / f64::from(n);
    let density = |i: i32| (-0.5 * (f64::from(i) * h).powi(2)).exp() / (2.0 * std::f64::consts::PI).sqrt();
    0.5 + (0..=n).map(|i| density(i) * if i == 0 || i == n { 0.5 } else { 1.0 }).sum::<f64>() * h
}

/// Words, JSON and criterion of an answer.
#[test]
fn a_joint_is_called_by_its_name() {
    let text = format!(
        "{PAIR}[random]\n\"joint.bed.friction\" = {{ uniform = {{ from = 0.2, to = 0.6 }} }}\n[criteria]\np_not_rest = 0.1\n"
    );
    let found = answer(&text, None);
    let said = found.text(&());
    for part in [
        "The probability that not every joint stays at rest in one event is 0.3333 under push. Then joint 2 (bed) slides first.",
        "Probability that each joint leaves rest first in one event",
        "joint 2 (bed) slides first  0.3333",
        "Were the loads to rise without end, joint 2 slides first in 100 % of all outcomes.",
        "p_not_rest in one event is 0.3333",
    ] {
        let one_line = said.split_whitespace().collect::<Vec<_>>().join(" ");
        let part = part.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(one_line.contains(&part), "{part}\n{said}");
    }
    let json: serde_json::Value = serde_json::from_str(&found.json(&(), &[])).unwrap();
    assert!(json["not_unique"].is_null());
    let modes: Vec<&str> =
        json["modes"].as_array().unwrap().iter().map(|m| m["mode"].as_str().unwrap()).collect();
    assert_eq!(
        modes,
        ["RE", "joint 1 slides", "joint 1 rocks", "joint 2 slides", "joint 2 rocks", "not a body"]
    );
    // The criterion is one of the assessment too.
    let assessment = Assessment::of_file(&file(&text)).unwrap();
    near(assessment.governing().chances.as_ref().unwrap().not_rest.unwrap().value, 1.0 / 3.0, 1e-12);
}

/// More joints than there are outcomes for are refused by their number.
#[test]
fn many_joints_are_refused_by_their_number() {
    let joints = |count: usize| {
        (1..=count).fold(String::new(), |text, place| {
            text + &format!("[[joint]]\nelevation = {}\nfriction = 0.6\n", 0.2 * place as f64)
        })
    };
    let text = |count| {
        format!(
            "[body]\nwidth = 3\nheight = 6\ndensity = 2000\nfriction = 0.5\n{}[[load]]\nname = \"push\"\nforce = \"20 kN/m\"\nelevation = 5.9\n\
             [random]\nfriction = {{ normal = {{ cov = 0.1 }} }}\n",
            joints(count)
        )
    };
    let request =
        ChanceRequest { effort: Effort { points: 64, ..Effort::default() }, ..ChanceRequest::default() };
    let error = Probability::of(&file(&text(22)), request).unwrap_err().to_string();
    assert!(error.contains("22 tables [[joint]]; a probability is found of 21 of them at most"), "{error}");
    assert_eq!(Probability::of(&file(&text(21)), request).unwrap().situations[0].modes.len(), 46);
}

/// The least factors of all joints, by hand: 0.5 · 60/20 against 0.6 · 140/20, and 60 · 1/20 against 140 · 2/40. Of a joint that is lifted none.
#[test]
fn tables_have_the_least_factors_of_all_joints() {
    let found = |text: &str, name: &str| {
        let file = file(text);
        let sweep = Sweep::of(&file, Vec::new()).unwrap();
        let answer = sweep.answer(&mut sweep.scratch(), &[]).unwrap();
        let result = SweepResult::find(name).unwrap();
        (answer.get(result), answer.names(result, &[]))
    };
    let criteria = format!("{PAIR}[criteria]\nSF_sliding = 1.6\n");
    for (name, expected) in [("SF_sliding_joints", 1.5), ("SF_overturning_net_joints", 3.0)] {
        let (ResultValue::Number(least), None) = found(PAIR, name) else { panic!("{name}") };
        near(least, expected, 1e-12);
    }
    assert_eq!(found(&criteria, "criterion_joint"), (ResultValue::Nothing, Some("2".to_owned())));
    let lifted = PAIR.to_owned()
        + "[[load]]\nforce = \"70 kN/m\"\ndirection = \"up\"\nelevation = 2\ndistance = 2\ntogether = true\n";
    let lifted = lifted.replace("elevation = 2\n[[load]]", "elevation = 2\ntogether = true\n[[load]]");
    assert_eq!(found(&lifted, "SF_sliding_joints").0, ResultValue::Nothing);
}
