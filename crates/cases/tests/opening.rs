//! A base that opens under steady heads, in cases: worked numbers, what was answered before, fast loads, combinations, probability.

mod common;

use common::{assess, file, near, number, six};
use standfast_cases::random::{ChanceProblem, ChanceRequest, Probability};
use standfast_cases::results::ResultName;
use standfast_cases::{Assessment, AssessmentView, CaseFile, Document, Explained};

fn wall(width: f64, friction: f64, water: &str, loads: &str) -> String {
    format!(
        "[body]\nwidth = {width}\nheight = 9\ndensity = 2400\nfriction = {friction}\n\
         [water]\nleft = 0\nright = 8\ndensity = 1000\n{water}\n{loads}"
    )
}

fn ice(force: f64) -> String {
    format!("[[load]]\nname = \"ice\"\nforce = {force}\nelevation = 8\ntogether = true\n")
}

fn json(assessment: &Assessment) -> serde_json::Value {
    serde_json::from_str(&assessment.json(&AssessmentView::default(), &[])).unwrap()
}

/// The wall of the specification, and what was answered before under `opening = "closed"`.
#[test]
fn a_wall_with_ice() {
    let assessment = assess(&wall(5.0, 0.7, "", &ice(20e3)));
    let one = assessment.governing();
    six(one.outcome.full.wrench.p, 785.418e3);
    six(number(one, ResultName::SfSliding), 1.64648);
    six(number(one, ResultName::SfOverturningNet), 1.79182);
    six(number(one, ResultName::HeelPressure), 520.879e3);
    six(number(one, ResultName::ContactLength), 3.01574);
    let opening = &json(&assessment)["situations"][0]["base_opening"];
    six(opening["contact"].as_f64().unwrap(), 3.01574);
    assert_eq!(opening["state"], "open");
    assert_eq!(opening["side"], "right");
    six(opening["pressure_open"].as_f64().unwrap(), 78.48e3);
    six(opening["uplift_closed"].as_f64().unwrap(), 196.2e3);
    assert_eq!(opening["load_factor_opens"], serde_json::Value::Null);
    let closed = assess(&wall(5.0, 0.7, "opening = \"closed\"", &ice(20e3)));
    six(number(closed.governing(), ResultName::SfSliding), 1.80970);
    near(number(closed.governing(), ResultName::HeelPressure), 498e3, 1e-4);
    assert_eq!(json(&closed)["situations"][0]["base_opening"], serde_json::Value::Null);
    // A body that nothing opens answers as with the straight line.
    let stiff = wall(9.0, 0.7, "", &ice(20e3));
    let [one, two] =
        [stiff.clone(), stiff.replace("density = 1000\n", "density = 1000\nopening = \"closed\"\n")]
            .map(|text| assess(&text));
    // It opens under more than the full load, and leaves rest then.
    let later = [ResultName::LoadFactor, ResultName::DepartureMode];
    for result in ResultName::ALL.iter().filter(|result| !later.contains(result)) {
        assert_eq!(result.of(one.governing()), result.of(two.governing()), "{}", result.name());
    }
    // From end to end.
    let through = assess(&wall(5.0, 0.7, "", &ice(110e3)));
    assert_eq!(json(&through)["situations"][0]["base_opening"]["state"], "through");
    assert_eq!(through.governing().mode(), Some(standfast::Mode::RockO));
    assert!(number(through.governing(), ResultName::SfOverturningNet) < 1.0);
}

/// Tailwater, drains, load factors, as the specification has them.
#[test]
fn drains_tailwater_and_load_factors() {
    let of = |text: &str| {
        let assessment = assess(text);
        let one = assessment.governing();
        let opening = one.situation.base_opening().unwrap();
        (opening.contact(one.situation.body().base_width()), number(one, ResultName::SfSliding))
    };
    let tail = wall(5.0, 0.7, "", &ice(20e3)).replace("left = 0", "left = 2");
    let (contact, sliding) = of(&tail);
    six(contact, 3.07456);
    six(sliding, 1.68723);
    let (contact, sliding) = of(&wall(5.0, 0.7, "drain = { distance = 2.5, efficiency = 0.5 }", &ice(20e3)));
    six(contact, 3.19956);
    six(sliding, 1.76442);
    let lost = wall(5.0, 0.7, "drain = { distance = 4.4, efficiency = 0.5 }", &ice(20e3));
    six(of(&lost).0, 3.01574);
    let names: Vec<_> = file(&lost).case().unwrap().warnings().iter().map(|one| one.name()).collect();
    assert_eq!(names, ["base-opens", "drain-lost", "formula-recalled"]);
    let crane = "[[load]]\nforce = 60e3\ndirection = \"down\"\ndistance = 1.5\ntogether = true\n";
    for (loads, opens, slides, tips) in
        [(ice(60e3), 0.213231, 2.20945, 4.12769), (ice(60e3) + crane, 0.196829, 3.33591, 5.08024)]
    {
        let assessment = assess(&wall(6.5, 0.45, "", &loads));
        six(number(assessment.governing(), ResultName::LoadFactor), slides);
        let opening = &json(&assessment)["situations"][0]["base_opening"];
        six(opening["load_factor_opens"].as_f64().unwrap(), opens);
        six(opening["load_factor_tips"].as_f64().unwrap(), tips);
    }
    // A drained base that is closed, and one that follows no opening.
    let drain = "drain = { distance = 5, efficiency = 0.5 }";
    let [one, two] = [drain.to_owned(), format!("{drain}\nopening = \"closed\"")]
        .map(|water| assess(&wall(9.0, 0.7, &water, &ice(20e3))));
    assert_eq!(ResultName::SfSliding.of(one.governing()), ResultName::SfSliding.of(two.governing()));
    let undrained = assess(&wall(9.0, 0.7, "", &ice(20e3)));
    assert!(
        number(one.governing(), ResultName::SfSliding) > number(undrained.governing(), ResultName::SfSliding)
    );
}

/// Fast loads meet the diagram that the steady ones leave: as if that were typed.
#[test]
fn fast_loads_meet_a_held_diagram() {
    let loads =
        ice(20e3) + "[[load]]\nname = \"blow\"\nforce = 40e3\nelevation = 6\ntogether = true\nfast = true\n";
    let held = assess(&wall(5.0, 0.7, "", &loads));
    let steady = assess(&wall(5.0, 0.7, "", &ice(20e3)));
    let (one, other) = (held.governing(), steady.governing());
    let [contact, before] = [one, other].map(|one| one.situation.base_opening().unwrap().contact(5.0));
    assert_eq!(contact, before);
    near(one.outcome.full.wrench.p, other.outcome.full.wrench.p, 1e-15);
    let names: Vec<_> = held.case.warnings().iter().map(|one| one.name()).collect();
    assert_eq!(names, ["base-opens", "opening-held"]);
    let follows = assess(&wall(5.0, 0.7, "opening = \"always\"", &loads));
    assert!(follows.governing().situation.base_opening().unwrap().contact(5.0) < contact);
    // The stages of both loads, the diagram held: against a scan.
    let path = &one.outcome.path;
    for i in 1..400 {
        let λ = f64::from(i) * 0.02;
        let found = one.situation.at(λ).unwrap();
        let stage = path.iter().find(|stage| stage.from <= λ && λ < stage.to).unwrap();
        if (λ - stage.from).min(stage.to - λ) > 1e-9 {
            assert_eq!(stage.modes, found.modes, "{λ}");
        }
    }
    // An earthquake is fast, and so is what it adds to soil.
    let shaken = assess(&wall(5.0, 0.7, "", "[earthquake]\nhorizontal = \"0.05 g\"\n"));
    assert!(shaken.governing().situation.base_opening().unwrap().is_held);
}

/// In combinations heads take the factor of the water, and each has an opening of its own; ground bears what presses.
#[test]
fn combinations_and_ground() {
    let factored =
        assess(&wall(5.0, 0.7, "", &(ice(20e3) + "[[combination]]\nfactors = { water = 1.1, ice = 1 }\n")));
    let typed = wall(5.0, 0.7, "", &ice(20e3)).replace("density = 1000", "density = 1100");
    let typed = assess(&typed);
    let contact =
        |assessment: &Assessment| assessment.governing().situation.base_opening().unwrap().contact(5.0);
    near(contact(&factored), contact(&typed), 1e-12);
    near(
        number(factored.governing(), ResultName::SfSliding),
        number(typed.governing(), ResultName::SfSliding),
        1e-12,
    );
    let ground = "[ground]\nfriction_angle_deg = 40\nunit_weight = 11e3\nsurcharge = 40e3\n";
    let on_ground = assess(&wall(5.0, 0.7, "", &(ice(20e3) + ground)));
    let one = on_ground.governing();
    near(number(one, ResultName::EffectiveWidth), 2.0 * 3.01574 / 3.0, 5e-6);
    // A base that crushes follows no opening; to ask for it is refused.
    let crushing = ice(20e3) + "[ground]\nstrength = 2e6\n";
    let plain = assess(&wall(5.0, 0.7, "", &crushing));
    assert!(plain.governing().situation.base_opening().is_none());
    let asked = CaseFile::parse("c", &wall(5.0, 0.7, "opening = \"steady\"", &crushing)).unwrap();
    let error = asked.case().unwrap_err();
    assert!(error.to_string().contains("not done for a base that crushes"), "{error}");
    assert!(error.help().unwrap().contains("opening = \"closed\""));
}

/// The chance that such a wall moves: by draws of the program against plain draws of whole cases; a bias of forces is refused.
#[test]
fn chances_follow_the_opening() {
    let random = "[random]\n\"load[1].force\" = { normal = { mean = 60e3, sd = 12e3 } }\nfriction = { normal = { mean = 0.5, sd = 0.05 } }\n";
    let text = wall(5.0, 0.5, "", &ice(60e3));
    let with = file(&format!("{text}{random}"));
    let found = Probability::of(&with, ChanceRequest::default()).unwrap();
    let not_rest = found.situations[0].not_rest;
    // Friction needed at each force, by bisection of the mode: rest is P(μ above it).
    let mut sum = 0.0;
    let steps = 400;
    let normal = |z: f64| (-z * z / 2.0).exp() / (2.0 * std::f64::consts::PI).sqrt();
    for i in 0..steps {
        let z = -4.9 + 9.8 * (f64::from(i) + 0.5) / f64::from(steps);
        let force = 60e3 + 12e3 * z;
        let (mut low, mut high) = (0.0, 1.5);
        for _ in 0..40 {
            let μ = (low + high) / 2.0;
            let push = if force < 0.0 { "direction = \"right\"\n" } else { "" };
            let one = assess(&(wall(5.0, μ, "", &ice(force.abs())) + push));
            if one.governing().mode() == Some(standfast::Mode::Rest) { high = μ } else { low = μ }
        }
        let needed = (high - 0.5) / 0.05;
        // Φ by its integral.
        let below: f64 = (0..2000)
            .map(|j| -9.0 + (needed + 9.0).max(0.0) * (f64::from(j) + 0.5) / 2000.0)
            .map(normal)
            .sum::<f64>()
            * (needed + 9.0).max(0.0)
            / 2000.0;
        sum += normal(z) * below.min(1.0) * 9.8 / f64::from(steps);
    }
    let (low, high) = (not_rest.low * 0.98, not_rest.high * 1.02);
    assert!((low..=high).contains(&sum), "{sum}, not in {low} to {high}");
    let biased = format!("{text}[random]\n\"bias.force\" = {{ normal = {{ mean = 1, sd = 0.1 }} }}\n");
    let biased = file(&biased);
    let refused = ChanceProblem::of(&biased, biased.case().unwrap(), biased.random().unwrap(), None, None);
    assert!(refused.unwrap_err().to_string().contains("follows an opening"), "no refusal");
}
