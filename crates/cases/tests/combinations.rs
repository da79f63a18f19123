//! Combinations as checks of a code: values that are others in one, strengths and resistances divided, pairs of factors, criteria of its
//! own; held against files in which the same is typed, enumerations of plain combinations, and worked numbers.

mod common;

use common::{assess, file, near, number, refused};
use standfast_cases::results::{ResultName, ResultValue};
use standfast_cases::{Assessed, Assessment, AssessmentView, Document, Explained};

/// Every result of two situations, and what acts in them.
fn same(one: &Assessed, two: &Assessed, what: &str) {
    let close = |one: f64, two: f64| one == two || (one - two).abs() <= 1e-12 * one.abs().max(two.abs());
    for result in ResultName::ALL {
        match (result.of(one), result.of(two)) {
            (ResultValue::Number(one), ResultValue::Number(two)) => {
                assert!(close(one, two), "{what}: {} is {one}, expected {two}", result.name());
            }
            (one, two) => assert_eq!(one, two, "{what}: {}", result.name()),
        }
    }
    assert_eq!(one.components().len(), two.components().len(), "{what}");
}

const BODY: &str = "[body]\nwidth = \"15 m\"\nheight = \"10.5 m\"\nmass = \"346.05 t/m\"\nfriction = 0.6\n";
const WEIGHT: &str = "buoyant_weight = \"2318.64 kN/m\"\n";
const WAVE: &str = "[wave]\nH13 = \"5.8 m\"\nHmax = \"8.05 m\"\nperiod = \"11.4 s\"\nsea_bottom_slope = 0.01\n\
    water_depth = \"10.1 m\"\ndepth_above_berm = \"5.6 m\"\nbase_depth = \"7.1 m\"\ncrest_height = \"3.4 m\"\n\
    berm_width = \"8 m\"\nangle_deg = 15\nwater_density = \"1030 kg/m3\"\n";

fn goda(combination: &str) -> String {
    format!("{BODY}{WEIGHT}{WAVE}[[combination]]\n{combination}\n")
}

/// The numbers of the specification: a factor on the weight is one on m g, with the buoyancy whole; the same caisson of parts.
#[test]
fn a_factor_on_the_weight_leaves_the_buoyancy_whole() {
    let deep = |text: String| {
        text.replace("H13 = \"5.8 m\"\nHmax = \"8.05 m\"\n", "deep_water_height = \"6.3 m\"\n")
    };
    let lowered = assess(&deep(goda("factors = { weight = 0.9, wave = 1 }")));
    let one = &lowered.all[0];
    let down: f64 = one.components().iter().take(2).map(|load| load.wrench.p).sum();
    near(down, 1_979_160.0, 3e-6);
    near(number(one, ResultName::SfSliding), 0.947_993, 1e-6);
    let parts = format!(
        "[body]\nfriction = 0.6\n[[part]]\nleft = 0\nwidth = 15\nbottom = 0\nheight = 10.5\ndensity = 2400\ndensity_below_water = 2100\n\
         [water]\nlevel = 7.1\ndensity = 1030\n{WAVE}[[combination]]\nfactors = {{ weight = 0.9, wave = 1 }}\n"
    );
    near(number(&assess(&deep(parts)).all[0], ResultName::SfSliding), 0.947_994, 1e-6);
}

/// PIANC's partial factors on Goda's caisson, heights and friction times 1.2, thrust and uplift times their biases, as worked by hand.
#[test]
fn a_check_by_partial_factors_is_the_one_by_hand() {
    let pianc = "scale = { \"wave.H13\" = 1.2, \"wave.Hmax\" = 1.2 }\nmaterials = { \"body.friction\" = 1.2 }\n\
        factors = { \"wave.thrust\" = 0.9, \"wave.uplift\" = 0.77 }\ncriteria = { SF_sliding = 1.0 }";
    let checked = assess(&goda(pianc));
    let one = &checked.all[0];
    let goda = &checked.case_of(one).goda().unwrap().goda;
    near(goda.force, 1_258_310.0, 4e-6);
    near(goda.uplift, 591_654.0, 1e-6);
    near(number(one, ResultName::SfSliding), 0.822_561, 1e-6);
    assert_eq!(checked.met(), Some(false));
    // By hand: μ/1.2 (W' − 0.77 U) over 0.9 P.
    let by_hand = 0.5 * (2318.64 - 0.77 * goda.uplift / 1e3) / (0.9 * goda.force / 1e3);
    near(number(one, ResultName::SfSliding), by_hand, 1e-12);
}

/// What a combination changes is what a file has in which it is typed.
#[test]
fn a_combination_answers_as_the_file_in_which_its_values_are_typed() {
    let typed = |text: String| assess(&format!("{text}[[combination]]\nfactors = {{ wave = 1 }}\n"));
    let plain = format!("{BODY}{WEIGHT}{WAVE}");
    for (what, combination, text) in [
        ("friction", "set = { friction = 0.5 }", plain.replace("friction = 0.6", "friction = 0.5")),
        (
            "one step after another",
            "materials = { \"body.friction\" = 1.25 }\nscale = { \"body.friction\" = 1.5 }\nset = { \"body.friction\" = 0.4 }",
            plain.replace("friction = 0.6", "friction = 0.48"),
        ),
        (
            "a quotient that rounding would spoil",
            "materials = { \"body.friction\" = 1.1 }",
            plain.replace("friction = 0.6", "friction = 0.545454545454545"),
        ),
        ("resistance", "resist = { sliding = 1.5 }", plain.replace("friction = 0.6", "friction = 0.4")),
        ("a choice", "set = { \"wave.uplift\" = false }", plain.clone() + "uplift = false\n"),
        ("a list", "set = { \"wave.lambda[1]\" = 1 }", plain.clone() + "lambda = [1, 1, 1]\n"),
        (
            "heights",
            "scale = { \"wave.H13\" = 1.1, \"wave.Hmax\" = 1.2 }",
            plain.replace("\"5.8 m\"", "\"6.38 m\"").replace("\"8.05 m\"", "\"9.66 m\""),
        ),
        (
            "the sea, and what moves with it",
            "set = { water_level = \"8.1 m\" }",
            plain
                .replace("10.1 m", "11.1 m")
                .replace("5.6 m", "6.6 m")
                .replace("7.1 m", "8.1 m")
                .replace("3.4 m", "2.4 m")
                .replace("2318.64 kN/m", "2167.0755 kN/m"),
        ),
    ] {
        let (combination, list) = match what {
            "a list" => (combination, "lambda = [0.9, 1, 1]\n"),
            _ => (combination, ""),
        };
        let combined =
            assess(&format!("{plain}{list}[[combination]]\n{combination}\nfactors = {{ wave = 1 }}\n"));
        same(&combined.all[0], &typed(text).all[0], what);
    }
}

/// A load, a pressure and a part go by their names; what the file does not say may be set.
#[test]
fn loads_and_parts_go_by_their_names() {
    let text = |force: &str, pressure: &str, width: &str, extra: &str| {
        format!(
            "[body]\nfriction = 0.6\n[[part]]\nname = \"shaft\"\nleft = 0\nwidth = {width}\nbottom = 0\nheight = 6\ndensity = 2400\n\
             [[pressure]]\nname = \"sand\"\nface = \"right\"\nelevation = [0, 6]\npressure = [{pressure}, 0]\npermanent = true\n\
             [[load]]\nname = \"ice\"\nforce = {force}\nelevation = 5\n[[combination]]\nfactors = {{ ice = 1 }}\n{extra}"
        )
    };
    let named = "set = { \"load.ice.force\" = \"40 kN/m\", \"pressure.sand.pressure\" = [4e4, 0], \"part.shaft.width\" = 5 }\n";
    let (one, two) = (assess(&text("2e4", "3e4", "4", named)), assess(&text("4e4", "4e4", "5", "")));
    same(&one.all[0], &two.all[0], "by name");
    let placed = named
        .replace("load.ice", "load[1]")
        .replace("pressure.sand", "pressure[1]")
        .replace("part.shaft", "part[1]");
    same(&assess(&text("2e4", "3e4", "4", &placed)).all[0], &two.all[0], "by place");
    let silent = "set = { \"load.ice.direction\" = \"right\" }\n";
    let pushed = assess(&text("2e4", "0", "4", silent));
    assert!(pushed.all[0].components().iter().any(|load| load.name == "ice" && load.wrench.x > 0.0));
}

/// A strength of ground is divided; of an angle the tangent, and what the ground bears as a whole.
#[test]
fn ground_is_weaker_by_its_partial_factors() {
    let soil = |angle: &str, cohesion: &str, extra: &str| {
        format!(
            "[body]\nwidth = 8\nheight = 6\nmass = 90e3\nfriction = 0.5\n[ground]\nfriction_angle_deg = {angle}\nunit_weight = 1e4\n\
             cohesion = {cohesion}\n[[load]]\nname = \"push\"\nforce = 8e4\nelevation = 3\n[[combination]]\nfactors = {{ push = 1 }}\n{extra}"
        )
    };
    let divided = "materials = { \"ground.friction_angle_deg\" = 1.25, \"ground.cohesion\" = 1.25 }\n";
    let angle = (33_f64.to_radians().tan() / 1.25).atan().to_degrees();
    near(angle, 27.4531, 2e-6);
    let (one, two) = (assess(&soil("33", "5e3", divided)), assess(&soil(&angle.to_string(), "4e3", "")));
    same(&one.all[0], &two.all[0], "tan φ/γ");
    // R/γ_R at the load; where the load rises until the ground fails, R is γ_R P.
    let [whole, less] = ["", "resist = { bearing = 1.4 }\n"].map(|extra| assess(&soil("33", "5e3", extra)));
    let factor = |answer: &Assessment| number(&answer.all[0], ResultName::GroundFactor);
    near(factor(&less), factor(&whole) / 1.4, 1e-14);
    let at = less.all[0].departure().load_factor();
    let risen = soil("33", "5e3", "").replace("force = 8e4", &format!("force = {}", 8e4 * at));
    near(number(&assess(&risen).all[0], ResultName::GroundFactor), 1.4, 1e-9);
    // A strength that the case does not write may be set, and is then divided.
    let cohesion = "set = { \"ground.cohesion\" = \"5 kPa\" }\nmaterials = { \"ground.cohesion\" = 1.25 }\n";
    let (one, two) = (soil("33", "0", cohesion).replace("cohesion = 0\n", ""), soil("33", "4e3", ""));
    same(&assess(&one).all[0], &assess(&two).all[0], "set, then divided");
    // An envelope, and a base that crushes, in which the same is typed.
    for (of, key, more) in
        [("envelope", "centric_resistance", "law = \"envelope\"\n"), ("stone", "strength", "")]
    {
        let text = |strength: f64, extra: &str| {
            format!(
                "[body]\nwidth = 8\nheight = 6\nmass = 90e3\nfriction = 0.5\n[ground]\n{more}{key} = {strength}\n[[load]]\nname = \"push\"\n\
                 force = 8e4\nelevation = 3\n[[combination]]\nfactors = {{ push = 1 }}\n{extra}"
            )
        };
        let divided = assess(&text(2.8e6, "resist = { bearing = 1.4 }\n"));
        same(&divided.all[0], &assess(&text(2.8e6 / 1.4, "")).all[0], of);
    }
}

/// Of pairs each way is tried: those of an enumeration typed by hand, each criterion where it is met worst.
#[test]
fn a_pair_is_its_worse_factor_for_each_criterion() {
    let case = |combinations: &str| {
        format!(
            "{BODY}[water]\nleft = \"7 m\"\nright = \"7.6 m\"\ndensity = 1025\n[[pressure]]\nname = \"sand\"\nface = \"right\"\n\
             elevation = [0, 10]\npressure = [9e4, 0]\npermanent = true\n[[load]]\nname = \"drag\"\nforce = 1.5e5\n\
             direction = \"down\"\ndistance = 15\npermanent = true\n[[load]]\nname = \"crane\"\nforce = 3e5\ndirection = \"down\"\n\
             distance = 12\n[[load]]\nname = \"bollard\"\nforce = 4e4\nelevation = 10.5\n[criteria]\nSF_sliding = 1\n\
             SF_overturning_net = 1.4\nbearing_max = 4e5\neccentricity = 3\nload_factor = 1.2\n{combinations}"
        )
    };
    let pairs = "[[combination]]\nfactors = { weight = [1.35, 1], sand = [1.35, 1], drag = [1, 1.35], crane = [1.5, 0], bollard = 1.5 }\n";
    let mut each = String::new();
    for weight in ["1.35", "1"] {
        for sand in ["1.35", "1"] {
            for drag in ["1", "1.35"] {
                for crane in ["1.5", "0"] {
                    each += &format!(
                        "[[combination]]\nfactors = {{ weight = {weight}, sand = {sand}, drag = {drag}, crane = {crane}, bollard = 1.5 }}\n"
                    );
                }
            }
        }
    }
    let (tried, enumerated) = (assess(&case(pairs)), assess(&case(&each)));
    assert_eq!((tried.all.len(), tried.all[0].tried().count()), (1, 16));
    let [one, two] = [&tried, &enumerated].map(Assessment::checks);
    assert_eq!(one.len(), 5);
    for (one, two) in one.iter().zip(&two) {
        assert_eq!(one.check, two.check, "{}", one.check.criterion);
    }
    // Not one way is the worst for all of them.
    assert!(
        one.iter().any(|check| !check.assessed.is_reported)
            && one.iter().any(|check| check.assessed.is_reported)
    );
    same(&tried.all[0], enumerated.governing(), "the worst as a whole");
    let json: serde_json::Value = serde_json::from_str(&tried.json(&AssessmentView::default(), &[])).unwrap();
    let combination = &json["situations"][0]["combination"];
    assert_eq!(combination["tried"].as_array().unwrap().len(), 15);
    assert_eq!(combination["factors"]["crane"], serde_json::json!([1.5, 0.0]));
    for (name, factor) in combination["factors_used"].as_object().unwrap() {
        assert!(combination["factors"][name].as_array().unwrap().contains(factor), "{name}");
    }
    // With an earthquake, signs and pairs multiply.
    let shaken = case(pairs).replace("bollard = 1.5 }", "bollard = 1.5, earthquake = [1, 0.3] }")
        + "[earthquake]\nhorizontal = \"0.1 g\"\nvertical = \"0.05 g\"\n";
    assert_eq!(assess(&shaken).all[0].tried().count(), 4 * 32);
}

/// A body that moves in one of the ways that are tried is not said to stay at rest, whatever a criterion finds worst.
#[test]
fn a_way_in_which_the_body_moves_is_told() {
    let text = format!(
        "{BODY}[[load]]\nname = \"push\"\nforce = 1.9e6\nelevation = 5\n[[combination]]\nfactors = {{ push = 1, weight = [1.35, 0.9] }}\n\
         [criteria]\nbearing_max = 3e5\n"
    );
    let answer = assess(&text);
    let slides = |one: &Assessed| one.mode() == Some(standfast::Mode::slide(standfast::Slip::Left));
    // The heavier body presses more, and rests; the lighter one slides.
    assert!(!slides(&answer.all[0]) && slides(&answer.all[0].others[0]));
    let summary = answer.summary().unwrap();
    assert!(summary.answer.starts_with("The body slides to the left (SL)"), "{}", summary.answer);
    let json: serde_json::Value =
        serde_json::from_str(&answer.json(&AssessmentView::default(), &[])).unwrap();
    assert_eq!(json["criteria"][0]["factors_used"]["weight"], 1.35);
}

/// The diagram of a combination is that of its own body.
#[test]
fn a_diagram_is_that_of_the_combination_s_body() {
    let text = "[body]\nwidth = 4\nheight = 4\nmass = 40e3\nfriction = 0.8\n[[load]]\nname = \"p\"\nforce = 2.5e5\nelevation = 2\n\
        [[combination]]\nset = { \"body.width\" = 2, \"body.mass\" = 40e3 }\nfactors = { p = 1 }\n";
    let typed = text
        .replace("width = 4", "width = 2")
        .replace("set = { \"body.width\" = 2, \"body.mass\" = 40e3 }\n", "");
    let figures = |text: &str| {
        let figures = assess(text).figures(&AssessmentView::default()).unwrap();
        figures
            .into_iter()
            .find(|figure| figure.words.starts_with("k–μ") || figure.words == "Diagram")
            .unwrap()
            .figure
            .svg()
            .to_owned()
    };
    assert_eq!(figures(text), figures(&typed));
}

/// The parts of what a table makes have factors of their own, and the more precise name goes before.
#[test]
fn parts_of_a_load_have_factors_of_their_own() {
    let by = |factors: &str| assess(&goda(&format!("factors = {{ {factors} }}")));
    let force = |answer: &Assessment, name: &str| {
        answer.all[0]
            .components()
            .into_iter()
            .find(|load| load.name == name)
            .map_or([0.0; 2], |load| [load.wrench.x, load.wrench.p])
    };
    let whole = by("wave = 1");
    let parts = by("\"wave.uplift\" = 0.5, wave = 0.75");
    near(force(&parts, "wave pressure")[0], 0.75 * force(&whole, "wave pressure")[0], 1e-15);
    near(force(&parts, "wave uplift")[1], 0.5 * force(&whole, "wave uplift")[1], 1e-15);
    let quay = |factors: &str| {
        assess(&format!(
            "{BODY}[water]\nleft = \"6 m\"\nright = \"7 m\"\ndensity = 1000\n[[combination]]\nfactors = {{ {factors} }}\n"
        ))
    };
    // γ h²/2 on either side, by its own factor.
    let total =
        |answer: &Assessment| answer.all[0].components().iter().map(|load| load.wrench.x).sum::<f64>();
    near(
        total(&quay("\"water.left\" = 1, \"water.right\" = 1.35")),
        9810.0 * (36.0 - 1.35 * 49.0) / 2.0,
        1e-12,
    );
    near(total(&quay("water = 1.2, \"water.left\" = 1")), 9810.0 * (36.0 - 1.2 * 49.0) / 2.0, 1e-12);
    let base = quay("\"water.base\" = 1.1").all[0].components()[1].wrench.p;
    near(base, -1.1 * 9810.0 * 6.5 * 15.0, 1e-12);
    // Where a situation has several factors for the sides, each stands for itself.
    assert_eq!(quay("\"water.left\" = 1, \"water.right\" = 1.35").all[0].components().len(), 4);
    assert!(refused(&goda("factors = { \"water.left\" = 1 }")).contains("no load called \"water.left\""));
    // A part that a combination's own levels make, or leave out, has its name in all.
    let levels = format!(
        "{BODY}[water]\nleft = \"6 m\"\nright = \"6 m\"\ndensity = 1000\n[[combination]]\nset = {{ \"water.left\" = \"4 m\" }}\nfactors = {{}}\n\
         [[combination]]\nfactors = {{ \"water.left\" = 0.9 }}\n[[combination]]\nset = {{ \"water.left\" = \"4 m\" }}\n\
         factors = {{ \"water.left\" = 0.9 }}\n"
    );
    let levels = assess(&levels);
    let push = |place: usize| levels.all[place].components().iter().map(|load| load.wrench.x).sum::<f64>();
    near(push(0), 9810.0 * (16.0 - 36.0) / 2.0, 1e-12);
    assert_eq!(push(1), 0.0);
    near(push(2), 9810.0 * (0.9 * 16.0 - 36.0) / 2.0, 1e-12);
}

/// A combination's criteria are in the place of the case's, and are told with it.
#[test]
fn criteria_of_a_combination_are_its_own() {
    let text = format!(
        "{BODY}{WEIGHT}{WAVE}[criteria]\nSF_sliding = 1.2\n[[combination]]\nname = \"static\"\nfactors = {{ wave = 0.9 }}\n\
         [[combination]]\nname = \"extreme\"\nfactors = {{ wave = 1 }}\ncriteria = {{ SF_sliding = 1.1, eccentricity = \"6 m\" }}\n"
    );
    let answer = assess(&text);
    let checks = answer.checks();
    let told: Vec<_> = checks
        .iter()
        .map(|check| {
            (check.check.criterion.to_string(), answer.name(check.assessed).unwrap(), check.check.met)
        })
        .collect();
    let of = |criterion: &str, name: &str| {
        told.iter().find(|(one, of, _)| one == criterion && of == name).unwrap().2
    };
    assert_eq!(told.len(), 3);
    assert!(
        of("SF_sliding=1.2", "static")
            && of("SF_sliding=1.1", "extreme")
            && of("eccentricity=6 m", "extreme")
    );
    assert_eq!(answer.met(), Some(true));
    // The 1.2 of the case would not be met there: it is 1.164.
    assert_eq!(
        assess(&text.replace("criteria = { SF_sliding = 1.1, eccentricity = \"6 m\" }\n", "")).met(),
        Some(false)
    );
    // None of its own, none asked.
    let none = assess(&text.replace("{ SF_sliding = 1.1, eccentricity = \"6 m\" }", "{}"));
    assert_eq!(none.checks().len(), 1);
}

/// What warns in a combination's numbers alone is told with its name, once.
#[test]
fn a_combination_s_own_numbers_are_warned_of() {
    let warnings = |combination: &str| {
        let answer = assess(&goda(&format!("name = \"storm\"\n{combination}\nfactors = {{ wave = 1 }}")));
        answer.case.warnings().iter().map(|warning| (warning.name(), warning.to_string())).collect::<Vec<_>>()
    };
    let plain = warnings("");
    let oblique = warnings("set = { \"wave.angle_deg\" = 75 }");
    let new: Vec<_> = oblique.iter().filter(|warning| !plain.contains(warning)).collect();
    let [(name, words)] = new[..] else { panic!("{new:?}") };
    assert!(words.starts_with("in the combination \"storm\" ") && words.contains("75"), "{name}: {words}");
    // A little less high, with the same ratio, is no news of the ratio.
    assert_eq!(warnings("scale = { \"wave.H13\" = 0.99, \"wave.Hmax\" = 0.99 }"), plain);
}

/// Each wrong word is refused by its name, with what may stand there.
#[test]
fn what_a_combination_cannot_say_is_refused() {
    for (combination, expected) in [
        (
            "set = { \"wave.heigth\" = 3 }\nfactors = {}",
            "`set` calls `wave.heigth`, which is no key of this case",
        ),
        ("set = { \"body.friction\" = \"0.5 m\" }\nfactors = {}", "friction"),
        (
            "set = { \"body.friction\" = -1 }\nfactors = {}",
            "in the combination \"combination 1\" `friction` is -1",
        ),
        ("set = { \"criteria.SF_sliding\" = 1 }\nfactors = {}", "which is no key of this case"),
        ("scale = { \"wave.uplift\" = 2 }\nfactors = {}", "which is no key of this case"),
        ("scale = { friction = 1, \"body.friction\" = 2 }\nfactors = {}", "`body.friction` is named twice"),
        ("scale = { \"body.width\" = 0 }\nfactors = {}", "expected a number above zero"),
        ("scale = { \"body.width\" = \"2 m\" }\nfactors = {}", "expected numbers without unit or quotes"),
        (
            "materials = { \"body.width\" = 1.2 }\nfactors = {}",
            "`body.width` is no strength, which alone `materials` divides; the strengths of this case: body.friction",
        ),
        ("criteria = { p_not_rest = 0.2 }\nfactors = {}", "`p_not_rest` is asked of all combinations alike"),
        (
            "resist = { passive = 1.4 }\nfactors = {}",
            "no resistance called \"passive\"; the resistances: sliding, bearing",
        ),
        ("resist = { bearing = 1.4 }\nfactors = {}", "no [ground] of the case says what it bears"),
        ("criteria = { SF_slide = 1 }\nfactors = {}", "[criteria] has no key `SF_slide`"),
        (
            "criteria = { ground_factor = 1.0 }\nfactors = {}",
            "`ground_factor` asks for what the ground bears",
        ),
        ("criteria = { slide = \"0.1 m\" }\nfactors = {}", "`slide` is asked of all combinations alike"),
        ("factors = { wave = [1, 2, 3] }", "expected a factor, or two of which the worse counts"),
        ("factors = { wave = [1, -2] }", "a factor from 0 to 1000000"),
        ("factors = { weight = [1, 0] }", "the factor of the weight is 0"),
        ("set = { \"wave.caisson_width\" = \"14 m\" }\nfactors = {}", "in the combination \"combination 1\""),
    ] {
        let found = refused(&goda(combination));
        assert!(found.contains(expected), "{combination}: {found}");
    }
    let many: String =
        (0..7).map(|i| format!("[[load]]\nname = \"f{i}\"\nforce = 1e3\nelevation = 1\n")).collect();
    let pairs: Vec<_> = (0..7).map(|i| format!("f{i} = [1, 0]")).collect();
    let many = format!("{BODY}{many}[[combination]]\nfactors = {{ {} }}\n", pairs.join(", "));
    assert!(
        refused(&many).contains("7 factors are pairs, of which all of 128 ways would be tried"),
        "{}",
        refused(&many)
    );
    // The place is that of the word.
    let text = goda("scale = { friction = 1.1, \"wave.heigth\" = 2 }\nfactors = {}");
    let error = file(&text).case().unwrap_err();
    let place = error.excerpt().unwrap().places[0].clone();
    assert_eq!(&text[place], "\"wave.heigth\" = 2");
}

const GROUPS: &str = "[body]\nfriction = 0.6\n\
    [[part]]\ngroup = \"concrete\"\nleft = 0\nwidth = 15\nbottom = 0\nheight = 2\ndensity = 2400\n\
    [[part]]\ngroup = \"fill\"\nleft = 1\nwidth = 12\nbottom = 2\nheight = 8\ndensity = 1900\n\
    [[part]]\nleft = 0\nwidth = 1\nbottom = 2\nheight = 8\ndensity = 2400\n\
    [water]\nleft = 1\nright = 2\ndensity = 1000\nopening = \"closed\"\n\
    [[load]]\nname = \"push\"\nforce = 900e3\nelevation = 8\n[[combination]]\n";

fn grouped(combination: &str) -> Assessment {
    assess(&format!("{GROUPS}{combination}\n"))
}

/// The weights of groups of parts add up to the weight; a factor on one is one on its parts' densities; the more precise name goes before.
#[test]
fn groups_of_parts_have_factors_of_their_own() {
    let whole = grouped("factors = { weight = 0.9, push = 1 }");
    let apart =
        grouped("factors = { \"weight.fill\" = 0.9, \"weight.concrete\" = 0.9, weight = 0.9, push = 1 }");
    for result in ResultName::ALL {
        match (result.of(whole.governing()), result.of(apart.governing())) {
            (ResultValue::Number(one), ResultValue::Number(two)) if one != two => near(two, one, 1e-12),
            (one, two) => assert_eq!(one, two, "{}", result.name()),
        }
    }
    assert_eq!(apart.governing().components().len(), whole.governing().components().len() + 2);
    let light = grouped("factors = { \"weight.fill\" = 0.5, push = 1 }");
    let lighter = GROUPS.replace("density = 1900", "density = 950");
    let lighter = assess(&format!("{lighter}factors = {{ push = 1 }}\n"));
    for result in [ResultName::SfSliding, ResultName::SfOverturningNet, ResultName::BearingMax] {
        near(number(light.governing(), result), number(lighter.governing(), result), 1e-12);
    }
    let text = format!("{GROUPS}factors = {{ \"weight.sand\" = 0.5 }}\n");
    assert!(refused(&text).contains("weight.fill"), "{}", refused(&text));
}

/// Tipping and uplift, added up by hand from the loads of the case.
#[test]
fn tipping_and_uplift_are_sums_over_the_loads() {
    let criteria = "criteria = { tipping = 1, SF_uplift = 1 }";
    let assessed = grouped(&format!("factors = {{ push = 1.2 }}\n{criteria}"));
    let assessed = assessed.governing();
    let g = 9.81;
    let weight = g * (30.0 * 2400.0 + 96.0 * 1900.0 + 8.0 * 2400.0);
    let about_o = g * (30.0 * 2400.0 * 7.5 + 96.0 * 1900.0 * 7.0 + 8.0 * 2400.0 * 0.5);
    let up = 1000.0 * g * 1.5 * 15.0;
    near(number(assessed, ResultName::SfUplift), weight / up, 1e-12);
    // Water on both sides is one load, that under the base another.
    let water = 1000.0 * g * (2f64.powi(3) - 1.0) / 6.0;
    let buoyancy = 1000.0 * g * (1.0 * 15.0 * 7.5 + 1.0 * 15.0 / 2.0 * 10.0);
    near(number(assessed, ResultName::Tipping), (1.2 * 900e3 * 8.0 + water + buoyancy) / about_o, 1e-12);
    // Told where it is asked for alone.
    let json = |text: &str| assess(text).json(&AssessmentView::default(), &[]);
    assert!(json(&format!("{GROUPS}factors = {{ push = 1 }}\n{criteria}\n")).contains("\"tipping\": 0."));
    assert!(!json(&format!("{GROUPS}factors = {{ push = 1 }}\n")).contains("tipping"));
    let given = assess(&goda("factors = { wave = 1 }\ncriteria = { tipping = 1 }"));
    assert_eq!(ResultName::Tipping.of(given.governing()), ResultValue::Nothing);
}

/// PIANC's set is the one that is written out; every cell of its table.
#[test]
fn pianc_fills_in_its_factors() {
    let typed = |water: &str, tests: bool, sigma: f64, p_f: f64| {
        goda(&format!(
            "name = \"c\"\ncode = \"PIANC28-sliding\"\noptions = {{ p_f = {p_f}, water = \"{water}\", model_tests = {tests}, sigma = {sigma} }}"
        ))
    };
    let assessment = assess(&typed("deep", false, 0.05, 0.2));
    let one = assessment.governing();
    near(one.outcome.actions.force, 0.9 * 1258.31e3, 5e-6);
    near(one.outcome.actions.uplift, 0.77 * 591.654e3, 5e-6);
    near(number(one, ResultName::SfSliding), 0.822561, 5e-6);
    const TABLE: &str = "
        deep, no tests      1.4 1.7 | 1.3 1.4 | 1.3 1.2 | 1.2 1.2 | 1.1 1.0      1.5 1.7 | 1.4 1.4 | 1.4 1.3 | 1.3 1.2 | 1.1 1.1
        deep, tests         1.3 1.5 | 1.2 1.4 | 1.2 1.2 | 1.1 1.2 | 1.0 1.2      1.4 1.5 | 1.3 1.4 | 1.3 1.2 | 1.2 1.2 | 1.1 1.0
        shallow, no tests   1.3 1.9 | 1.2 1.6 | 1.2 1.4 | 1.1 1.3 | 1.0 1.2      1.4 1.9 | 1.3 1.6 | 1.3 1.4 | 1.2 1.3 | 1.0 1.2
        shallow, tests      1.2 1.6 | 1.1 1.5 | 1.1 1.3 | 1.1 1.2 | 1.0 1.1      1.3 1.6 | 1.2 1.5 | 1.2 1.3 | 1.1 1.2 | 1.0 1.1";
    let mut cells = 0;
    for line in TABLE.lines().filter(|line| !line.trim().is_empty()) {
        let water = if line.contains("deep") { "deep" } else { "shallow" };
        let numbers: Vec<f64> = line.split([' ', '|', ',']).filter_map(|word| word.parse().ok()).collect();
        assert_eq!(numbers.len(), 20);
        for (place, pair) in numbers.chunks(2).enumerate() {
            let sigma = [0.05, 0.2][place / 5];
            let p_f = [0.01, 0.05, 0.1, 0.2, 0.4][place % 5];
            let found = assess(&typed(water, !line.contains("no tests"), sigma, p_f));
            let written = assess(&goda(&format!(
                "scale = {{ \"wave.H13\" = {0}, \"wave.Hmax\" = {0} }}\nmaterials = {{ \"body.friction\" = {1} }}\n\
                 factors = {{ \"wave.thrust\" = 0.9, \"wave.uplift\" = 0.77 }}\ncriteria = {{ SF_sliding = 1 }}",
                pair[0], pair[1]
            )));
            assert_eq!(
                ResultName::SfSliding.of(found.governing()),
                ResultName::SfSliding.of(written.governing()),
                "{line} {place}"
            );
            cells += 1;
        }
    }
    assert_eq!(cells, 40);
}
