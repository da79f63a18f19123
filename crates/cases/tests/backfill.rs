//! Soil beside the body: worked numbers, the same pressures typed, the mirror image, an earthquake, partial factors, refusals and warnings.

mod common;

use common::{assess, file, near, number, refused, six};
use standfast_cases::results::{ResultName, ResultValue};
use standfast_cases::{Assessed, AssessmentView, Document};

const QUAY: &str = "[body]\nwidth = \"7.5 m\"\nheight = \"11 m\"\ndensity = \"2300 kg/m3\"\nfriction = 0.6\n\
    [water]\nleft = \"9 m\"\nright = \"9.5 m\"\ndensity = \"1025 kg/m3\"\n";
const SAND: &str = "[[backfill]]\nname = \"sand\"\nface = \"right\"\nfriction_angle_deg = 33\nwall_friction_deg = 22\n\
    unit_weight = \"18 kN/m3\"\nunit_weight_saturated = \"20 kN/m3\"\nsurcharge = \"20 kPa\"\n";

/// The quay of the specification, and the same with its pressure typed, its drag as a load: one answer.
#[test]
fn a_quay_answers_as_with_its_pressures_typed() {
    let made = assess(&format!("{QUAY}{SAND}"));
    let one = made.governing();
    six(one.outcome.full.wrench.x, -278.346e3);
    six(one.outcome.full.wrench.p, 1257.53e3);
    six(number(one, ResultName::ResultantArm), 3.04943);
    six(number(one, ResultName::SfSliding), 2.71073);
    six(number(one, ResultName::SfOverturningNet), 4.17267);
    let loads = one.situation.loads();
    let points = |name: &str| {
        let load = loads.iter().find(|load| load.name.as_deref() == Some(name)).unwrap();
        let standfast::loads::Action::Pressure { diagram, .. } = &load.action else { panic!() };
        let of = |of: fn(&standfast::loads::PressureAt) -> f64| -> Vec<f64> {
            diagram.points().iter().map(of).collect()
        };
        (of(|point| point.position), of(|point| point.pressure))
    };
    let drag = |name: &str| {
        let load = loads.iter().find(|load| load.name.as_deref() == Some(name)).unwrap();
        one.situation.wrench_of(load).p
    };
    let mut typed = QUAY.to_owned();
    for (name, permanent) in [("sand", true), ("sand.surcharge", false)] {
        let (elevation, pressure) = points(name);
        typed += &format!(
            "[[pressure]]\nface = \"right\"\nelevation = {elevation:?}\npressure = {pressure:?}\npermanent = {permanent}\n\
             [[load]]\nforce = {}\ndirection = \"down\"\ndistance = 7.5\npermanent = {permanent}\ntogether = true\n",
            drag(&format!("{name}, drag"))
        );
    }
    let typed = assess(&typed);
    for result in ResultName::ALL {
        match (result.of(one), result.of(typed.governing())) {
            (ResultValue::Number(one), ResultValue::Number(two)) if one != two => near(two, one, 1e-12),
            (one, two) => assert_eq!(one, two, "{}", result.name()),
        }
    }
    // Two layers of the same soil are one.
    let soil = &SAND[SAND.find("friction_angle").unwrap()..SAND.find("surcharge").unwrap()];
    let of_layers = SAND.replace(soil, "");
    let layers = format!(
        "{QUAY}{of_layers}[[backfill.layer]]\nthickness = 4\n{soil}[[backfill.layer]]\nthickness = 7\n{soil}"
    );
    let layers = assess(&layers);
    near(number(layers.governing(), ResultName::SfSliding), number(one, ResultName::SfSliding), 1e-12);
    near(number(layers.governing(), ResultName::HeelPressure), number(one, ResultName::HeelPressure), 1e-12);
}

/// Everything at the other side is the mirror image.
#[test]
fn the_other_side_is_the_mirror_image() {
    let shaken = format!(
        "{QUAY}{SAND}batter_deg = 5\nslope_deg = 4\n[earthquake]\nhorizontal = \"0.1 g\"\nvertical = \"0.05 g\"\n"
    );
    let mirrored = shaken
        .replace("left = \"9 m\"\nright = \"9.5 m\"", "left = \"9.5 m\"\nright = \"9 m\"")
        .replace("face = \"right\"", "face = \"left\"");
    let (one, two) = (assess(&shaken), assess(&mirrored));
    let (one, two) = (one.governing(), two.governing());
    assert_eq!(one.mode().map(standfast::Mode::mirrored), two.mode());
    for result in [
        ResultName::SfSliding,
        ResultName::SfOverturningNet,
        ResultName::SfOverturningGross,
        ResultName::HeelPressure,
        ResultName::LoadFactor,
    ] {
        near(number(two, result), number(one, result), 1e-10);
    }
    near(two.earthquake.unwrap().horizontal(), -one.earthquake.unwrap().horizontal(), 1e-15);
}

/// An earthquake presses the soil against the body from one side only; its names; the numbers of the specification.
#[test]
fn an_earthquake_raises_the_pressure_from_one_side() {
    let sand = SAND.replace("20 kPa", "10 kPa") + "unit_weight_dry = \"16.5 kN/m3\"\n";
    let text = format!("{QUAY}{sand}[earthquake]\nhorizontal = \"0.12 g\"\n");
    let shaken = assess(&text);
    let worst = shaken.governing();
    let of = |assessed: &Assessed, name: &str| -> Option<f64> {
        let load = assessed.situation.loads().iter().find(|load| load.name.as_deref() == Some(name))?;
        Some(assessed.situation.wrench_of(load).x)
    };
    assert!(worst.earthquake.unwrap().horizontal() > 0.0);
    six(of(worst, "sand.earthquake").unwrap(), -110.397e3);
    six(of(worst, "sand, pore water").unwrap(), -63.5240e3);
    six(of(worst, "sand").unwrap() + of(worst, "sand.surcharge").unwrap(), -204.868e3);
    let other = worst.others.iter().find(|other| other.earthquake.unwrap().horizontal() < 0.0).unwrap();
    assert_eq!(of(other, "sand.earthquake"), None);
    // Its own name goes before that of the earthquake.
    let combined = |factors: &str| {
        let assessment = assess(&format!("{text}[[combination]]\nfactors = {{ {factors} }}\n"));
        let worst = assessment.governing();
        [of(worst, "sand.earthquake").unwrap_or(0.0), of(worst, "earthquake, horizontal").unwrap_or(0.0)]
    };
    let alone = combined("earthquake = 1, \"sand.earthquake\" = 0.5");
    six(alone[0], -0.5 * 110.397e3);
    assert_eq!(combined("earthquake = 1, \"sand.earthquake\" = 0")[0], 0.0);
    six(combined("\"sand.earthquake\" = 1")[0], -110.397e3);
    // With the soil, shaken upwards as well: (1 − k_v) of the specification is 1 + a_v/g.
    let with = sand + "pore_water = \"with-soil\"\n";
    let text = format!("{QUAY}{with}[earthquake]\nhorizontal = \"0.12 g\"\nvertical = \"-0.06 g\"\n");
    let shaken = assess(&text);
    let tried = shaken.tried().find(|tried| {
        let earthquake = tried.earthquake.unwrap();
        earthquake.horizontal() > 0.0 && earthquake.vertical() < 0.0
    });
    six(of(tried.unwrap(), "sand.earthquake").unwrap(), -131.984e3);
    let json = shaken.json(&AssessmentView::default(), &[]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let made = json["situations"][0]["made_loads"].as_array().unwrap();
    let names: Vec<_> = made.iter().map(|load| load["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["sand", "sand.surcharge", "sand.earthquake"]);
    six(made[2]["coefficients"][0]["K_E"].as_f64().unwrap(), 0.349406);
    six(made[2]["coefficients"][0]["K_E_wet"].as_f64().unwrap(), 0.467576);
    six(made[2]["force_h"].as_f64().unwrap(), 131.984e3);
    six(made[0]["coefficients"][0]["K"].as_f64().unwrap(), 0.264459);
}

/// Partial factors of a code, with pairs: the numbers of the specification for a gravity wall.
#[test]
fn a_wall_by_design_approaches() {
    let wall = "[body]\nwidth = 4\nheight = 6\ndensity = 2400\nfriction = 0.6\n\
        [[backfill]]\nname = \"sand\"\nface = \"right\"\nfriction_angle_deg = 33\nwall_friction_deg = 22\nunit_weight = 19e3\n\
        surcharge = 10e3\n[[combination]]\ncriteria = { SF_sliding = 1, tipping = 1 }\n";
    let materials = "materials = { \"body.friction\" = 1.25, \"backfill.sand.friction_angle_deg\" = 1.25 }\n";
    for (combination, sliding, tipping) in [
        ("factors = { \"sand.surcharge\" = 1 }\n".to_owned(), 3.68189, 0.164303),
        (
            "factors = { weight = [1.35, 1], sand = [1.35, 1], \"sand.surcharge\" = [1.5, 0] }\n".to_owned(),
            2.74861,
            0.216962,
        ),
        (format!("factors = {{ \"sand.surcharge\" = [1.3, 0] }}\n{materials}"), 2.22102, 0.220764),
        (
            "factors = { weight = [1.35, 1], sand = [1.35, 1], \"sand.surcharge\" = [1.5, 0] }\nresist = { sliding = 1.1 }\n"
                .to_owned(),
            2.49874,
            0.216962,
        ),
        (
            format!(
                "factors = {{ weight = [1.1, 0.9], sand = [1.1, 0.9], \"sand.surcharge\" = [1.5, 0] }}\n{materials}"
            ),
            1.83018,
            0.265111,
        ),
    ] {
        let assessment = assess(&format!("{wall}{combination}"));
        let checks = assessment.checks();
        let worst = |name: &str| {
            let check = checks.iter().find(|check| check.check.criterion.name() == name).unwrap();
            match check.check.value {
                ResultValue::Number(number) => number,
                other => panic!("{other:?}"),
            }
        };
        six(worst("SF_sliding"), sliding);
        six(worst("tipping"), tipping);
    }
    // 27.4531° and 17.9119°, K 0.328516.
    let assessment = assess(&format!("{wall}factors = {{}}\n{materials}"));
    let under = assessment.case_of(assessment.governing());
    six(under.soils[0].soil.layers[0].soil.friction_angle_deg, 27.4531);
    six(under.soils[0].soil.layers[0].soil.wall_friction_deg, 17.9119);
    six(under.soils[0].pressure.coefficients[0].k, 0.328516);
    // A weak soil is divided to less than one writes.
    let weak = wall.replace("= 33", "= 16").replace("= 22", "= 8");
    let assessment = assess(&format!("{weak}factors = {{}}\n{materials}"));
    assert!(
        assessment.case_of(assessment.governing()).soils[0].soil.layers[0].soil.friction_angle_deg < 13.0
    );
}

/// What cannot be is refused with its value and the cure; what is unusual is warned of by name.
#[test]
fn slips_are_refused_or_warned_of() {
    let with = |soil: &str| format!("{QUAY}{soil}");
    for (from, to, words) in [
        ("face = \"right\"\n", "", "[[backfill]] lacks `face`"),
        ("friction_angle_deg = 33", "friction_angle_deg = 12", "expected an angle from 15 to 50 degrees"),
        (
            "wall_friction_deg = 22",
            "wall_friction_deg = 34",
            "`wall_friction_deg` is 34°; expected no more than the angle of friction of the soil, 33°",
        ),
        (
            "unit_weight_saturated = \"20 kN/m3\"\n",
            "",
            "water stands in this soil, 9.5 m above the base, and `unit_weight_saturated` is not given; add for example\nunit_weight_saturated",
        ),
        ("\"20 kN/m3\"", "\"10 kN/m3\"", "expected more than that of water, 10.05525 kN/m³"),
        (
            "surcharge = \"20 kPa\"",
            "slope_deg = 33",
            "`slope_deg` of sand is 33°; expected less than the angle of friction of its soil, 33°",
        ),
        ("surcharge = \"20 kPa\"", "top = 12", "`top` is above the crest of the body, which is 11 m high"),
        ("surcharge = \"20 kPa\"", "state = \"asleep\"", "expected \"active\", \"rest\" or \"passive\""),
        ("surcharge = \"20 kPa\"", "batter_deg = 40", "expected an angle from -20 to 30 degrees"),
        (
            "surcharge = \"20 kPa\"",
            "[[backfill.layer]]\nthickness = 3",
            "sand has layers, and `friction_angle_deg` of its own",
        ),
        (
            "surcharge = \"20 kPa\"",
            "[[load]]\nname = \"sand.surcharge\"\nforce = 9e3\nelevation = 2",
            "as the program calls what it makes",
        ),
        (
            "surcharge = \"20 kPa\"",
            "[earthquake]\nhorizontal = \"0.12 g\"\n[added_mass]\nsides = \"both\"",
            "no free water moves with the body there; sides = \"left\"",
        ),
        (
            "surcharge = \"20 kPa\"",
            "[earthquake]\nhorizontal = \"0.5 g\"",
            "does not hold under this earthquake: φ − β − ψ is below zero, k_h is 0.5; expected 0.35",
        ),
    ] {
        let text = with(&SAND.replace(from, to));
        let said = refused(&text);
        assert!(said.contains(words), "{said}\n{words}");
    }
    let short = format!(
        "{QUAY}[[backfill]]\nface = \"right\"\n[[backfill.layer]]\nthickness = 3\nfriction_angle_deg = 30\nunit_weight = 18e3\n\
         unit_weight_saturated = 20e3\n"
    );
    assert!(refused(&short).contains("the layers of backfill are 3 m thick; expected 11 m at least"));
    let names = |text: &str| -> Vec<&'static str> {
        file(text).case().unwrap().warnings().iter().map(|warning| warning.name()).collect()
    };
    assert!(names(&with(SAND)).is_empty());
    for (from, to, name) in [
        ("wall_friction_deg = 22", "wall_friction_deg = 23", "wall-friction-high"),
        ("\"20 kN/m3\"", "\"24 kN/m3\"", "saturated-weight-unusual"),
        ("\"20 kN/m3\"", "\"17.5 kN/m3\"", "saturated-weight-unusual"),
        ("\"20 kPa\"", "20", "surcharge-small"),
        (
            "surcharge = \"20 kPa\"",
            "[[pressure]]\nface = \"right\"\nelevation = [0, 5]\npressure = [5e3, 0]\npermanent = true",
            "backfill-beside-pressure",
        ),
        ("surcharge = \"20 kPa\"", "[earthquake]\nhorizontal = \"0.3 g\"", "strong-increment"),
        ("surcharge", "[[combination]]\nname = \"c\"\nfactors = { weight = 1 }\n#", "NONE"),
    ] {
        let found = names(&with(&SAND.replace(from, to)));
        assert!(found.contains(&name) || name == "NONE" && found.is_empty(), "{name}: {found:?}");
    }
    let left_out = format!("{QUAY}{SAND}[[combination]]\nname = \"c\"\nfactors = {{ weight = 1 }}\n");
    assert_eq!(names(&left_out), ["load-not-acting"]);
    let on_purpose = left_out.replace("weight = 1", "\"sand.surcharge\" = 0");
    assert!(names(&on_purpose).is_empty());
}

/// A named set is the combination that is written out by hand; what is written goes before it; criteria that cannot be answered are told.
#[test]
fn a_code_fills_in_what_is_not_written() {
    let wall = "[body]\nwidth = 4\nheight = 6\ndensity = 2400\nfriction = 0.6\n\
        [[backfill]]\nname = \"sand\"\nface = \"right\"\nfriction_angle_deg = 33\nwall_friction_deg = 22\nunit_weight = 19e3\n\
        surcharge = 10e3\n[[combination]]\n";
    let same = |code: &str, written: &str| {
        let [one, two] = [code, written].map(|lines| assess(&format!("{wall}{lines}\n")));
        let [one, two] = [&one, &two].map(|assessment| {
            let checks = assessment
                .checks()
                .into_iter()
                .map(|check| (check.check.criterion.name(), check.check.value, check.assessed.trial));
            (checks.collect::<Vec<_>>(), assessment.governing().outcome.clone())
        });
        assert_eq!(one, two, "{code}");
    };
    let pairs = "weight = [1.35, 1], sand = [1.35, 1], \"sand.surcharge\" = [1.5, 0]";
    let m2 = "materials = { \"body.friction\" = 1.25, \"backfill.sand.friction_angle_deg\" = 1.25 }";
    let sliding = "criteria = { SF_sliding = 1 }";
    same("code = \"EN1997-DA1-1\"", &format!("factors = {{ {pairs} }}\n{sliding}"));
    same(
        "code = \"EN1997-DA1-2\"",
        &format!("factors = {{ weight = 1, sand = 1, \"sand.surcharge\" = [1.3, 0] }}\n{m2}\n{sliding}"),
    );
    same(
        "code = \"EN1997-DA2\"",
        &format!("factors = {{ {pairs} }}\nresist = {{ sliding = 1.1 }}\n{sliding}"),
    );
    same(
        "code = \"EN1997-DA3\"",
        &format!(
            "factors = {{ weight = [1.35, 1], sand = 1, \"sand.surcharge\" = [1.3, 0] }}\n{m2}\n{sliding}"
        ),
    );
    let equ = "weight = [1.1, 0.9], sand = [1.1, 0.9], \"sand.surcharge\" = [1.5, 0]";
    same("code = \"EN1997-EQU\"", &format!("factors = {{ {equ} }}\n{m2}\ncriteria = {{ tipping = 1 }}"));
    let upl = "weight = [1, 0.9], sand = [1, 0.9], \"sand.surcharge\" = [1.5, 0]";
    same("code = \"EN1997-UPL\"", &format!("factors = {{ {upl} }}\n{m2}\ncriteria = {{ SF_uplift = 1 }}"));
    same(
        "code = \"UFC-3-220-20\"\noptions = { ground = \"rock\" }",
        "factors = { weight = 1, sand = 1, \"sand.surcharge\" = 1 }\n\
         criteria = { eccentricity = 1, SF_sliding = 1.5, SF_overturning_gross = 1.5 }",
    );
    // What is written goes before.
    same(
        "code = \"EN1997-DA1-2\"\nfactors = { \"sand.surcharge\" = 0 }\nmaterials = { \"body.friction\" = 1 }\ncriteria = { SF_sliding = 1.1 }",
        "factors = { weight = 1, sand = 1, \"sand.surcharge\" = 0 }\n\
         materials = { \"body.friction\" = 1, \"backfill.sand.friction_angle_deg\" = 1.25 }\ncriteria = { SF_sliding = 1.1 }",
    );
    let case = file(&format!("{wall}name = \"c\"\ncode = \"EN1997-DA2\"\n")).case().unwrap();
    let told: Vec<String> = case.warnings().iter().map(ToString::to_string).collect();
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].contains("EN1997-DA2 asks for ground_factor"), "{told:?}");
    for (lines, words) in [
        ("code = \"EN1997DA2\"", "did you mean \"EN1997-DA2\"?"),
        ("code = \"EN1997-DA2\"\noptions = { sigma = 0.2 }", "has no option sigma; leave it out"),
        (
            "code = \"UFC-3-220-20\"\noptions = { ground = \"clay\" }",
            "is \"clay\"; expected \"soil\" or \"rock\"",
        ),
        ("code = \"PIANC28-sliding\"", "asks for `p_f` in the options; expected 0.01, 0.05"),
        ("code = \"EN1997-DA2\"\n[[load]]\nforce = 9e3\nelevation = 2", "this one has no name"),
    ] {
        let said = refused(&format!("{wall}{lines}\n"));
        assert!(said.contains(words), "{said}");
    }
}

/// Factors on effects leave the resistance that of the loads as they are.
#[test]
fn factors_on_effects_leave_the_resistance() {
    let wall = "[body]\nwidth = 4\nheight = 6\ndensity = 2400\nfriction = 0.6\n[ground]\nfriction_angle_deg = 35\nunit_weight = 18e3\n\
        [[backfill]]\nname = \"sand\"\nface = \"right\"\nfriction_angle_deg = 33\nwall_friction_deg = 22\nunit_weight = 19e3\n\
        surcharge = 10e3\n[[combination]]\nfactors = { weight = 1.35, sand = 1.35, \"sand.surcharge\" = 1.5 }\n";
    let plain = assess(&wall.replace("1.35", "1").replace("1.5", "1"));
    let effects = assess(&format!("{wall}effects = true\n"));
    let (plain, effects) = (plain.governing(), effects.governing());
    let wrench = |name: &str, part: fn(&standfast::Wrench) -> f64| {
        let loads = plain.situation.loads().iter();
        let of = loads.filter(|load| load.name.as_deref() == Some(name));
        of.map(|load| part(&plain.situation.wrench_of(load))).sum::<f64>()
    };
    let push = 1.35 * wrench("sand", |w| w.x) + 1.5 * wrench("sand.surcharge", |w| w.x);
    let weight = 9.81 * 4.0 * 6.0 * 2400.0;
    let down =
        1.35 * (weight + wrench("sand, drag", |w| w.p)) + 1.5 * wrench("sand.surcharge, drag", |w| w.p);
    let held = 0.6 * plain.outcome.full.wrench.p;
    near(number(effects, ResultName::SfSliding), held / push.abs(), 1e-12);
    near(number(effects, ResultName::MarginSliding), held - push.abs(), 1e-12);
    let resistance = number(plain, ResultName::GroundResistance);
    near(number(effects, ResultName::GroundResistance), resistance, 1e-15);
    near(number(effects, ResultName::GroundFactor), resistance / down, 1e-12);
    near(number(effects, ResultName::Eccentricity), number(plain, ResultName::Eccentricity), 1e-15);
}
