//! `[ground]` of a case: what the base bears in text, JSON, criteria, tables and designs, by hand and by what is known of it.

use serde_json::Value;
use standfast::History;
use standfast::ground::elastic::ElasticBase;
use standfast::ground::impact::ElasticBody;
use standfast::ground::strength::CrushPoint;
use standfast::{Point, Wrench};
use standfast_cases::results::{ResultName, ResultValue};
use standfast_cases::sweep::{Factor, Sweep, SweepResult};
use standfast_cases::{Assessment, AssessmentView, CaseFile, Document};

fn assessment(text: &str) -> Assessment {
    let file = CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{error}: {text}"));
    let case = file.case().unwrap_or_else(|error| panic!("{error}: {text}"));
    Assessment::of(&case).unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn json(text: &str) -> Value {
    serde_json::from_str(&assessment(text).json(&AssessmentView::default(), &[])).unwrap()
}

/// The first situation of a case.
fn situation(text: &str) -> Value {
    json(text)["situations"][0].clone()
}

fn refused(text: &str) -> String {
    let file = match CaseFile::parse("case.toml", text) {
        Ok(file) => file,
        Err(error) => return standfast_cases::report(&error),
    };
    match file.case() {
        Ok(_) => panic!("accepted: {text}"),
        Err(error) => standfast_cases::report(&error),
    }
}

const CAISSON: &str = "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = 0.6\n";
const PUSH: &str = "[[load]]\nforce = 2.7e6\nelevation = 11.5\n";

fn example(name: &str) -> String {
    let path = format!("{}/../../examples/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

/// Cases known on rigid ground, as in the specification: the ground fails before the body slides, or nearly with it.
#[test]
fn the_ground_under_goda_s_caisson_and_the_caisson_in_air() {
    let goda = example("goda-2000");
    for (angle, factor, mode) in [(35, 0.997, "BF"), (40, 1.125, "SL"), (42, 1.125, "SL")] {
        let text = format!("{goda}\n[ground]\nfriction_angle_deg = {angle}\nunit_weight = \"10 kN/m3\"\n");
        let found = situation(&text);
        assert!((found["load_factor"].as_f64().unwrap() - factor).abs() < 6e-4, "{angle}: {found}");
        assert_eq!(found["departure_mode"], mode, "{angle}");
        let of_ground =
            [(35, 0.997), (40, 1.126), (42, 1.172)].into_iter().find(|(other, _)| *other == angle);
        let ground = &found["ground"];
        assert!((ground["load_factor_ground"].as_f64().unwrap() - of_ground.unwrap().1).abs() < 6e-4);
        // 219 kPa on B' where the elastic edge has 292.
        assert!((ground["effective_pressure"].as_f64().unwrap() - 219e3).abs() < 500.0);
        assert!((found["bearing_max"].as_f64().unwrap() - 292e3).abs() < 500.0);
        assert_eq!(ground["omega"], Value::Null);
        assert_eq!(found["report"], Value::Null);
    }
    // φ ± 2°: the factors of those angles themselves.
    let at = |angle: f64| {
        let text = format!("{goda}\n[ground]\nfriction_angle_deg = {angle}\nunit_weight = 10e3\n");
        situation(&text)["ground"].clone()
    };
    let middle = at(38.0);
    assert_eq!(middle["load_factor_ground_less"], at(36.0)["load_factor_ground"]);
    assert_eq!(middle["load_factor_ground_more"], at(40.0)["load_factor_ground"]);

    let air = example("caisson-in-air") + "\n[ground]\nstrength = \"3 MPa\"\n";
    let [soft, rigid] = [situation(&air), situation(&example("caisson-in-air"))];
    assert_eq!([&rigid["departure_mode"], &rigid["mode"]], ["SL", "SRO-"]);
    assert_eq!([&soft["departure_mode"], &soft["mode"]], ["RO", "RO"]);
    assert!((soft["ground"]["omega"].as_f64().unwrap() - 0.0824).abs() < 1e-4);
    assert_eq!(rigid["ground"], Value::Null);
}

/// By hand: a strip of 10 m, P = 2000 kN/m, pushed with 300 kN/m at 4 m, so that e = 0.6 m.
#[test]
fn a_strip_by_hand() {
    let body = "gravity = 10\n[body]\nwidth = 10\nheight = 8\nmass = 200e3\nfriction = 0.6\n[[load]]\nforce = 300e3\nelevation = 4\n";
    let near = |value: &Value, expected: f64| {
        let value = value.as_f64().unwrap();
        assert!((value / expected - 1.0).abs() < 1e-9, "{value} {expected}");
    };
    let crushed = situation(&format!("{body}[ground]\nstrength = 500e3\n"));
    let ground = &crushed["ground"];
    near(&ground["omega"], 0.4);
    near(&ground["pivot"], 2.0);
    assert_eq!(ground["neutral"], Value::Null);
    near(&ground["effective_width"], 8.8);
    near(&ground["effective_pressure"], 2000e3 / 8.8);
    near(&ground["resistance"], 4400e3);
    near(&ground["factor"], 2.2);
    // λ 1200 kN m/m at the edge of what bears: 2000 (5 − 2) = 6000.
    near(&ground["load_factor_ground"], 5.0);
    near(&ground["k_BF"], 0.75);
    assert_eq!(crushed["mode"], "RE");

    // Upright and in the middle of a whole base V_0 = 20 MN/m: η = 0.15, ε = 0.12 towards the push.
    let envelope = "[ground]\nlaw = \"envelope\"\ncentric_resistance = \"20 MN/m\"\n";
    let on = situation(&format!("{body}{envelope}"));
    let (h, m) = (0.15 / 0.52, 0.12 / 0.7);
    // The resultant of a push above the base lies where it pushes.
    let radius: f64 = h * h + m * m - 0.22 * 0.15 * 0.12 / (0.52 * 0.35);
    near(&on["ground"]["resistance"], 20e6 * (1.0 - radius.sqrt()));
    assert_eq!(on["ground"]["load_factor_ground_less"], Value::Null);

    // On springs: full contact, θ = M/(⅔ k_n B³).
    let sprung = situation(&format!("{body}[ground]\nstiffness = \"40 MN/m3\"\n"));
    near(&sprung["ground"]["rotation"], 1200e3 / (2.0 / 3.0 * 40e6 * 125.0));
    let base = ElasticBase::new(5.0, 2000e3, 40e6).unwrap();
    near(&sprung["ground"]["k_overturn"], base.k_overturn(0.8, 0.0).unwrap());
    // They decide nothing of what begins.
    assert_eq!(sprung["mode"], "RE");
    assert_ne!(sprung["report"], Value::Null);
    assert_eq!(sprung["ground"]["periods"], Value::Null);
}

/// A thrust of 0.1 s on Goda's caisson: as the library has it of the same numbers; D of a sudden load on a stiff base is 2 at most.
#[test]
fn a_short_thrust() {
    let text = "[body]\nwidth = 15\nheight = 10.5\nmass = 346.05e3\nfriction = 0.6\nbuoyant_weight = 2318.64e3\n\
        [ground]\nstiffness = \"50 MN/m3\"\ntangential_stiffness = \"25 MN/m3\"\n\
        [[load]]\nforce = 940.6e3\nelevation = 5.155\nhistory = { shape = \"triangle\", rise = \"0.05 s\", duration = 0.1 }\n";
    let found = situation(text);
    let inertia = 346.05e3 * (15.0 * 15.0 + 10.5 * 10.5) / 12.0;
    let body = ElasticBody::new(7.5, 5.25, 346.05e3, inertia, 50e6, 25e6).unwrap();
    let push = Wrench { x: -940.6e3, p: 0.0, m: 940.6e3 * (5.155 - 5.25) };
    let standing = Wrench { x: 0.0, p: 2318.64e3, m: 0.0 };
    let loads = [(push, History::triangle(1.0, 0.05, 0.1).unwrap())];
    let answer = body.response(&standing, &loads, 0.6, None).unwrap();
    let ground = &found["ground"];
    for (name, expected) in [("D_shear", answer.d_shear), ("D_moment", answer.d_moment)] {
        assert!((ground[name].as_f64().unwrap() / expected.unwrap() - 1.0).abs() < 1e-9, "{name}");
    }
    // k is 940.6/2318.64 of the push, 1 + k' its elevation over that of the centre of mass.
    let number = |name: &str| ground[name].as_f64().unwrap();
    let k = number("D_shear") * 940.6 / 2318.64;
    let k_prime = 5.155 / 5.25 * number("D_moment") / number("D_shear") - 1.0;
    assert!((number("k_moved") - k).abs() < 1e-12 && (number("k_prime_moved") - k_prime).abs() < 1e-12);
    // Not where another load, which stands, pushes too.
    let second = "name = \"wave\"\n[[load]]\nname = \"ice\"\nforce = 1e4\nelevation = 9\n[[combination]]\nfactors = { wave = 1, ice = 1 }\n";
    let pushed = situation(&(text.to_owned() + second));
    assert!(pushed["ground"]["D_shear"].is_number());
    assert_eq!(
        (&pushed["ground"]["k_moved"], &pushed["ground"]["k_prime_moved"]),
        (&Value::Null, &Value::Null)
    );
    assert_eq!(ground["first_event"], "lift");
    assert_eq!(ground["events"].as_array().unwrap().len(), 2);
    assert!((ground["periods"][0].as_f64().unwrap() / answer.periods[0] - 1.0).abs() < 1e-9);
    // A rect that lasts, a step: both modes swing to twice the static at most together.
    let step = situation(&text.replace("\"triangle\", rise = \"0.05 s\", duration = 0.1", "\"constant\""));
    let [shear, moment] = ["D_shear", "D_moment"].map(|name| step["ground"][name].as_f64().unwrap());
    assert!(shear > 1.0 && shear <= 2.0 + 1e-9, "{shear}");
    assert!(moment > 1.5 && moment < 4.0, "{moment}");
    // The same points, and twice the load.
    let points = "\"points\", times = [0, 0.05, 0.1], values = [0, 0.5, 0], peak = 2";
    let same = situation(&text.replace("\"triangle\", rise = \"0.05 s\", duration = 0.1", points));
    assert_eq!(same["ground"]["first_event_time"], ground["first_event_time"]);
    assert_eq!(same["ground"]["events"][0]["load_factor"], ground["events"][0]["load_factor"]);
    // A base that yields has a third event, and springs alone none.
    let yields = situation(&text.replace("[ground]\n", "[ground]\nstrength = 250e3\n"));
    assert_eq!(yields["ground"]["events"][2]["event"], "yield");
    let still = situation(&text.replace("history", "# history"));
    assert_eq!(still["ground"]["first_event"], Value::Null);
    assert!(still["ground"]["periods"].is_array());
}

/// A lone force in air on a base that crushes is a point of the plane with ω, decision and motion; with ω → 0 the rigid answer comes back.
#[test]
fn a_crushing_base_is_the_point_of_its_plane() {
    let mut seed = 7_u64;
    let mut uniform = |from: f64, to: f64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        from + (to - from) * (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut modes = std::collections::BTreeMap::new();
    for _ in 0..300 {
        let [γ, k, μ, ω] = [uniform(0.3, 3.0), uniform(0.05, 2.0), uniform(0.1, 1.5), uniform(0.01, 1.1)];
        let height = uniform(0.0, 2.0);
        let (width, g) = (4.0, 10.0);
        let mass = 1e4 * width * γ * width / 4.0;
        let text = format!(
            "gravity = {g}\n[body]\nwidth = {width}\nheight = {}\nmass = {mass}\nfriction = {μ}\n[[load]]\nforce = {}\nelevation = {}\n",
            width * γ,
            k * mass * g,
            height * width * γ / 2.0
        );
        let strength = mass * g / (width * ω);
        let found = situation(&format!("{text}[ground]\nstrength = {strength}\n"));
        let point = CrushPoint::of(Point::new(γ, height - 1.0, k, μ).unwrap(), ω).unwrap();
        assert_eq!(found["mode"], point.verdict().symbol(), "{text}{strength}");
        *modes.entry(point.verdict().symbol()).or_insert(0) += 1;
        if let Some(motion) = point.motion() {
            let θ = found["motion"]["theta_ddot"].as_f64().unwrap();
            let expected = motion.motion.theta_ddot * g / (width / 2.0);
            assert!(
                (θ - expected).abs() <= 1e-9 * expected.abs().max(1e-9),
                "{text}{strength}: {θ} {expected}"
            );
            if let Some(neutral) = found["ground"]["neutral"].as_f64() {
                let pressed = motion.pressed.width() * width / 2.0;
                assert!((neutral / pressed - 1.0).abs() < 1e-9);
                assert!((found["ground"]["pivot"].as_f64().unwrap() * 2.0 / neutral - 1.0).abs() < 1e-12);
            }
        }
        let hard = situation(&format!("{text}[ground]\nstrength = {}\n", 1e12 * strength));
        let rigid = situation(&text);
        assert_eq!(
            [&hard["mode"], &hard["departure_mode"]],
            [&rigid["mode"], &rigid["departure_mode"]],
            "{text}"
        );
    }
    assert!(["RE", "SL", "RO", "SRO-", "BF"].iter().all(|mode| modes.contains_key(mode)), "{modes:?}");
}

/// Loads from the other side, eccentric, in both directions and in combinations give the mirrored answer.
#[test]
fn both_sides_and_combinations() {
    let ground = ["[ground]\nstrength = 800e3\n", "[ground]\nfriction_angle_deg = 36\nunit_weight = 11e3\n"];
    for ground in ground {
        let of = |rest: &str| situation(&format!("{CAISSON}{ground}{rest}"));
        let push =
            |towards: &str| of(&format!("[[load]]\nforce = 9e5\nelevation = 9\ndirection = \"{towards}\"\n"));
        let [left, right] = [push("left"), push("right")];
        for name in ["factor", "load_factor_ground", "effective_width", "k_BF"] {
            assert_eq!(left["ground"][name], right["ground"][name], "{ground}: {name}");
        }
        assert_eq!(left["load_factor"], right["load_factor"]);
        // A factor of a combination is a load that is so much larger.
        let combined = of(
            "[[combination]]\nfactors = { push = 1.5 }\n[[load]]\nname = \"push\"\nforce = 6e5\nelevation = 9\n",
        );
        let ratio =
            combined["ground"]["factor"].as_f64().unwrap() / left["ground"]["factor"].as_f64().unwrap();
        assert!((ratio - 1.0).abs() < 1e-12);
        // The worse direction of an earthquake is reported, and of the ground as well: off the middle it is the side of the mass.
        let eccentric = CAISSON.replace("friction", "centroid_offset = 1\nfriction");
        let shaken = |h: &str| {
            situation(&format!(
                "{eccentric}{ground}[earthquake]\nhorizontal = \"{h} g\"\nhorizontal_fixed = true\n"
            ))
        };
        let both = situation(&format!("{eccentric}{ground}[earthquake]\nhorizontal = \"0.2 g\"\n"));
        let factor = |found: &Value| found["ground"]["load_factor_ground"].as_f64().unwrap();
        let one = [shaken("0.2"), shaken("-0.2")];
        let least = factor(&one[0]).min(factor(&one[1]));
        assert!(factor(&one[0]) != factor(&one[1]));
        assert_eq!(factor(&both), least, "{ground}");
    }
}

/// Permanent loads that the ground does not bear, a base that cannot carry the weight, and a body that is lifted.
#[test]
fn what_does_not_stand_to_begin_with() {
    let heavy = situation(&format!("{CAISSON}[ground]\nstrength = \"200 kPa\"\n{PUSH}"));
    assert!(heavy["ground"]["omega"].as_f64().unwrap() > 1.0);
    assert_eq!(
        [&heavy["mode"], &heavy["departure"], &heavy["departure_by"]],
        ["BF", "at-once", "permanent-loads"]
    );
    assert_eq!([&heavy["departure_mode"], &heavy["mode_words"]], ["BF", "stands on ground that fails"]);
    assert_eq!(heavy["ground"]["load_factor_ground"], 0.0);
    assert_eq!(heavy["ground"]["k_BF"], 0.0);

    let weak = situation(&format!("{CAISSON}[ground]\nfriction_angle_deg = 20\nunit_weight = 5e3\n{PUSH}"));
    assert_eq!(
        [&weak["mode"], &weak["departure"], &weak["departure_by"]],
        ["BF", "at-once", "permanent-loads"]
    );
    assert!(weak["ground"]["factor"].as_f64().unwrap() < 1.0);

    let up = "[[load]]\nforce = 5e6\ndirection = \"up\"\ndistance = 7.5\n";
    let lifted = situation(&format!("{CAISSON}[ground]\nfriction_angle_deg = 40\nunit_weight = 9e3\n{up}"));
    assert_eq!([&lifted["mode"], &lifted["lifted"]], [&Value::from("FL"), &Value::from(true)]);
    for name in ["factor", "resistance", "effective_width", "effective_pressure", "omega"] {
        assert_eq!(lifted["ground"][name], Value::Null, "{name}");
    }
}

/// Criteria, with what is not met by ground that fails; a table of them; a design for one.
#[test]
fn criteria_tables_and_designs() {
    let goda = example("goda-2000");
    let ground = "\n[ground]\nfriction_angle_deg = 40\nunit_weight = \"10 kN/m3\"\n";
    let criteria =
        "[criteria]\nground_factor = 1.4\neffective_pressure_max = \"220 kPa\"\nmodes_not = [\"SL\"]\n";
    let document = json(&format!("{goda}{ground}{criteria}"));
    let found = &document["situations"][0];
    let check = |name: &str| {
        let list = document["criteria"].as_array().unwrap();
        list.iter().find(|check| check["name"] == name).unwrap().clone()
    };
    assert_eq!(check("ground_factor")["value"], found["ground"]["factor"]);
    assert_eq!(check("effective_pressure_max")["met"], true);
    let used = check("effective_pressure_max")["utilisation"].as_f64().unwrap();
    assert!((used - found["ground"]["effective_pressure"].as_f64().unwrap() / 220e3).abs() < 1e-12);
    assert_eq!(check("modes_not")["met"], true);
    let failing = json(&format!("{goda}{}{criteria}", ground.replace("40", "35")));
    assert_eq!(
        failing["criteria"].as_array().unwrap().iter().filter(|check| check["met"] == false).count(),
        2
    );
    // P/B' is a number of any base.
    let rigid = json(&format!("{goda}[criteria]\neffective_pressure_max = \"200 kPa\"\n"));
    assert_eq!(rigid["met"], false);
    assert_eq!(rigid["criteria"][0]["value"], found["ground"]["effective_pressure"]);

    let file = CaseFile::parse("case.toml", &format!("{goda}{ground}")).unwrap();
    let factor = Factor::find("ground.friction_angle_deg", None, file.inputs()).unwrap();
    let sweep = Sweep::of(&file, vec![factor]).unwrap();
    let names: Vec<_> = sweep.results().into_iter().map(SweepResult::name).collect();
    assert!(names.contains(&"load_factor_ground") && names.contains(&"mode"), "{names:?}");
    let mut scratch = sweep.scratch();
    let load_factor = SweepResult::Of(ResultName::LoadFactorGround);
    for (angle, expected) in [(35.0, 0.997), (40.0, 1.126), (42.0, 1.172)] {
        let ResultValue::Number(found) = sweep.answer(&mut scratch, &[angle]).unwrap().get(load_factor)
        else {
            panic!("{angle}");
        };
        assert!((found - expected).abs() < 6e-4, "{angle}: {found}");
    }
    assert!(
        sweep.answer(&mut scratch, &[15.0]).unwrap_err().to_string().contains("`friction_angle_deg` is 15")
    );
    // A case on rigid ground has no such columns.
    let rigid = CaseFile::parse("case.toml", &goda).unwrap();
    let rigid = Sweep::of(&rigid, vec![Factor::find("friction", None, rigid.inputs()).unwrap()]).unwrap();
    assert!(rigid.results().into_iter().all(|result| result.name() != "ground_factor"));
}

/// Every bad input: its value or its keys, and what is expected.
#[test]
fn bad_ground() {
    let with = |ground: &str| format!("{CAISSON}[ground]\n{ground}\n{PUSH}");
    for (ground, parts) in [
        ("", vec!["[ground] does not say what the base bears", "friction_angle_deg and unit_weight"]),
        (
            "strength = \"3 MPa\"\nfriction_angle_deg = 40",
            vec!["`strength` does not go with `friction_angle_deg`"],
        ),
        ("strength = \"3 MPa\"\nlaw = \"ec7\"", vec!["`strength` does not go with `law`"]),
        ("strength = \"3 MPa\"\ncentric_resistance = 1e6", vec!["does not go with `centric_resistance`"]),
        ("strength = 0", vec!["`strength` is 0", "above zero"]),
        ("strength = \"3\"", vec!["it has no unit", "MPa"]),
        ("strength = \"3 kN\"", vec!["`kN` does not fit"]),
        ("strength = \"nan MPa\"", vec!["it does not begin with a number"]),
        ("friction_angle_deg = 40", vec!["[ground] lacks `unit_weight`", "\"10 kN/m3\""]),
        ("unit_weight = 1e4", vec!["[ground] lacks `friction_angle_deg`"]),
        ("friction_angle_deg = 19.9\nunit_weight = 1e4", vec!["is 19.9", "an angle from 20 to 50 degrees"]),
        ("friction_angle_deg = 50.1\nunit_weight = 1e4", vec!["is 50.1", "an angle from 20 to 50 degrees"]),
        (
            "friction_angle_deg = \"40 deg\"\nunit_weight = 1e4",
            vec!["`friction_angle_deg` is a text", "without unit"],
        ),
        ("friction_angle_deg = 40\nunit_weight = \"10 kN/m2\"", vec!["`kN/m2` does not fit", "kN/m3"]),
        (
            "friction_angle_deg = 40\nunit_weight = 1e4\nsurcharge = -1",
            vec!["`surcharge` is -1", "zero or more"],
        ),
        (
            "friction_angle_deg = 40\nunit_weight = 1e4\nlaw = \"EC7\"",
            vec!["`law` is \"EC7\"", "\"ec7\", \"hansen\" or"],
        ),
        ("friction_angle_deg = 40\nunit_weight = 1e4\nt_h = 0.5", vec!["`t_h` is a number of the envelope"]),
        ("law = \"envelope\"", vec!["[ground] lacks `centric_resistance`"]),
        (
            "law = \"envelope\"\ncentric_resistance = 1e7\ncohesion = 1",
            vec!["`cohesion` does not go with `law = \"envelope\"`"],
        ),
        ("law = \"envelope\"\ncentric_resistance = 1e7\nC = 1.5", vec!["`C` is 1.5", "from -1 to 1"]),
        ("law = \"hansen\"", vec!["[ground] lacks `friction_angle_deg`"]),
        ("stiffness = \"50\"", vec!["it has no unit", "MN/m3"]),
        ("stiffness = \"50 MPa\"", vec!["`MPa` does not fit"]),
        ("tangential_stiffness = 1e6", vec!["[ground] lacks `stiffness`"]),
        ("strenght = 1e6", vec!["no key `strenght`", "did you mean `strength`?"]),
    ] {
        let said = refused(&with(ground));
        assert!(parts.iter().all(|part| said.contains(part)), "{ground}\n{said}");
    }
    let drum = "[body]\nshape = \"cylinder\"\nwidth = 1\nheight = 2\nmass = 4e3\nfriction = 0.6\n[[load]]\nforce = 1e3\nelevation = 1\n";
    let said = refused(&format!("{drum}[ground]\nstrength = 1e6\n"));
    assert!(said.contains("a cylinder has no `ground.strength`") && said.contains("of a strip"), "{said}");
    for (criteria, parts) in [
        ("ground_factor = 1.4", ["`ground_factor` asks for what the ground bears", "neither `strength` nor"]),
        ("rotation_max = \"2 mrad\"", ["`rotation_max` asks for how far", "no `stiffness`"]),
        ("rotation_max = \"2 gon\"", ["`gon` does not fit", "rad, mrad, deg or °"]),
    ] {
        let said = refused(&format!("{CAISSON}{PUSH}[criteria]\n{criteria}\n"));
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
    }
}

/// Loads in time that are none.
#[test]
fn bad_histories() {
    let springs = "[ground]\nstiffness = 5e7\ntangential_stiffness = 2e7\n";
    let with = |ground: &str, history: &str| format!("{CAISSON}{ground}{PUSH}{history}\n");
    for (history, parts) in [
        ("history = 0.1", vec!["`history` is a number", "a shape with its numbers"]),
        ("history = { duration = 0.1 }", vec!["the history of a [[load]] lacks `shape`", "\"church-roof\""]),
        ("history = { shape = \"triangel\" }", vec!["is \"triangel\"", "did you mean \"triangle\"?"]),
        (
            "history = { shape = \"half-sine\", duration = 1 }",
            vec!["is a sine", "of straight", "by its points"],
        ),
        (
            "history = { shape = \"triangle\", duration = 0.1 }",
            vec!["the history of a [[load]] lacks `rise`", "rise = \"0.2 s\""],
        ),
        (
            "history = { shape = \"triangle\", rise = 0.2, duration = 0.1 }",
            vec!["the history of a [[load]]: rise is 0.2", "a time from zero to the duration"],
        ),
        ("history = { shape = \"rect\", duration = \"0.1\" }", vec!["is \"0.1\"", "a time"]),
        ("history = { shape = \"rect\", duration = -0.1 }", vec!["is -0.1", "above zero"]),
        (
            "history = { shape = \"rect\", duration = 0.1, ris = 1 }",
            vec!["has no key `ris`", "did you mean `rise`?"],
        ),
        (
            "history = { shape = \"points\", times = [0, 1], values = [0] }",
            vec!["2 times and 1 values", "as many of each"],
        ),
        (
            "history = { shape = \"points\", times = [1, 0], values = [0, 1] }",
            vec!["point 2: its time is 0", "expected one after that"],
        ),
        ("history = { shape = \"points\", times = [], values = [] }", vec!["a list that is not empty"]),
        ("permanent = true\nhistory = { shape = \"constant\" }", vec!["the load is permanent"]),
    ] {
        let said = refused(&with(springs, history));
        assert!(parts.iter().all(|part| said.contains(part)), "{history}\n{said}");
    }
    let said = refused(&with("[ground]\nstrength = 3e6\n", "history = { shape = \"constant\" }"));
    assert!(
        said.contains("`load[1].history` says how a load varies in time") && said.contains("no `stiffness`"),
        "{said}"
    );
    let said = refused(&with("[ground]\nstiffness = 1e7\n", "history = { shape = \"constant\" }"));
    assert!(said.contains("no `tangential_stiffness`"), "{said}");
}

/// The margins, traces and inequalities of the rigid base are not told of another; what is left out is.
#[test]
fn nothing_rigid_is_said_of_ground_that_is_not() {
    let goda = example("goda-2000");
    let say = |ground: &str| {
        assessment(&format!("{goda}{ground}")).text(&AssessmentView::default()).replace("\n  ", " ")
    };
    let rigid = say("");
    assert_eq!(situation(&goda)["no_report"], Value::Null);
    // A load that does not push has no point, whatever the base.
    let pressed =
        "[body]\nwidth = 10\nheight = 8\nmass = 200e3\nfriction = 0.6\n[[load]]\nforce = 1e5\ndistance = 5\n";
    let pressed =
        pressed.replace("force = 1e5\ndistance = 5", "force = 1e5\ndistance = 5\ndirection = \"down\"");
    assert_eq!(situation(&pressed)["no_report"], "no-point");
    assert!(rigid.contains("Changes of mode as the friction grows") && !rigid.contains("partial factor"));
    for (ground, left_out) in [
        ("\n[ground]\nstrength = 600e3\n", "once its edge is crushed"),
        (
            "\n[ground]\nfriction_angle_deg = 35\nunit_weight = 1e4\n",
            "the shoulder of a berm, slopes, layers, pore pressure",
        ),
        ("\n[ground]\nlaw = \"envelope\"\ncentric_resistance = 5e7\n", "Butterfield and Gottardi"),
    ] {
        let text = say(ground);
        assert!(!text.contains("Changes of mode as the friction grows"), "{text}");
        assert!(text.contains("No partial factor is applied") && text.contains(left_out), "{text}");
        let found = situation(&format!("{goda}{ground}"));
        assert_eq!((&found["report"], &found["no_report"]), (&Value::Null, &Value::from("base-gives-way")));
        assert!(
            text.contains("is for rigid ground. Its inequalities, margins and changes of mode do not hold"),
            "{text}"
        );
        assert!(text.lines().all(|line| !line.contains("(3.") && !line.contains("(4.")), "{text}");
    }
}

/// R − P by hand, and whether a body can rest on its base is told by it and by what friction leaves.
#[test]
fn the_margins_say_whether_the_body_can_rest() {
    let body = "gravity = 10\n[body]\nwidth = 10\nheight = 8\nmass = 200e3\nfriction = 0.6\n";
    let grounds = [
        "strength = 500e3",
        "strength = 190e3",
        "friction_angle_deg = 35\nunit_weight = 10e3",
        "law = \"envelope\"\ncentric_resistance = 6e6",
    ];
    let mut rests = [0, 0];
    for ground in grounds {
        for force in [0.0, 300e3, 700e3, 1100e3, 1300e3, 2000e3] {
            let text = format!("{body}[ground]\n{ground}\n[[load]]\nforce = {force}\nelevation = 4\n");
            let found = situation(&text);
            let number = |value: &Value| value.as_f64().unwrap();
            let ground = &found["ground"];
            let margin = number(&ground["resistance"]) - 2000e3;
            assert!((number(&ground["margin"]) - margin).abs() < 1e-3, "{text}: {ground}");
            let can_rest = margin >= 0.0 && number(&found["margin_sliding"]) >= 0.0;
            assert_eq!(can_rest, found["mode"] == "RE", "{text}");
            rests[usize::from(can_rest)] += 1;
        }
    }
    assert!(rests[0] > 5 && rests[1] > 5, "{rests:?}");
}

/// A unit that is left out makes ground that is none: the warning shows the value; usual ground has no warning.
#[test]
fn ground_that_no_unit_was_given_for_is_warned_of() {
    let body = "[body]\nwidth = 15\nheight = 10\nmass = 300e3\nfriction = 0.6\n[[load]]\nforce = 1e5\nelevation = 5\n";
    let warned = |ground: &str| {
        let file = CaseFile::parse("case.toml", &format!("{body}[ground]\n{ground}\n")).unwrap();
        let case = file.case().unwrap();
        case.warnings().iter().map(|w| (w.name(), w.to_string())).collect::<Vec<_>>()
    };
    for (ground, value) in [
        ("stiffness = 50", "ground.stiffness = 5e-5 MN/m³"),
        ("stiffness = 50e6\ntangential_stiffness = 25", "ground.tangential_stiffness = 2.5e-5 MN/m³"),
        ("strength = 600", "ground.strength = 0.6 kPa"),
        ("friction_angle_deg = 35\nunit_weight = 10", "ground.unit_weight = 0.01 kN/m³"),
        ("strength = 2e9", "ground.strength = 2000000 kPa"),
    ] {
        let found = warned(ground);
        assert_eq!(found.len(), 1, "{ground}: {found:?}");
        assert!(found[0].0 == "unusual-ground" && found[0].1.starts_with(value), "{ground}: {found:?}");
    }
    for ground in [
        "stiffness = \"50 MN/m3\"\nstrength = \"600 kPa\"",
        "friction_angle_deg = 35\nunit_weight = \"10 kN/m3\"",
        "strength = \"200 MPa\"",
        "law = \"envelope\"\ncentric_resistance = \"20 MN/m\"",
    ] {
        assert_eq!(warned(ground), [], "{ground}");
    }
}

/// The shares of the load under which an edge lifts in time are as the factors of the combinations; the one that needs least is told, wherever
/// it stands.
#[test]
fn on_springs_the_worst_combination_is_told() {
    let text = include_str!("../../../examples/breaking-wave.toml");
    let combination = |name: &str, factor: f64| {
        format!("[[combination]]\nname = \"{name}\"\nfactors = {{ \"breaking wave\" = {factor} }}\n")
    };
    let told = |more: &str| {
        let file = CaseFile::parse("case.toml", &format!("{text}\n{more}")).unwrap();
        Assessment::of_file(&file).unwrap().summary().unwrap().near.unwrap()
    };
    let share = |words: &str| {
        let (before, _) = words.split_once(" % of these loads").unwrap();
        before.rsplit(' ').next().unwrap().parse::<f64>().unwrap()
    };
    let alone = told("");
    assert!(alone.starts_with("In time an edge lifts after "), "{alone}");
    let both = told(&(combination("less", 0.5) + &combination("more", 1.25)));
    assert!(both.starts_with("Under «more», in time an edge lifts after "), "{both}");
    assert!((1.25 * share(&both) / share(&alone) - 1.0).abs() < 2e-4, "{alone} {both}");
}

/// Clay that does not drain under a wall 10 m wide of 1600 kN/m that is pushed by 250 kN/m at 5 m: e = 1250/1600 m, B' = 10 − 2e, i_c = ½ (1 + √(1 − 250/(B' c_u))).
#[test]
fn clay_that_does_not_drain() {
    let text = |ground: &str| {
        format!(
            "gravity = 10\n[body]\nwidth = 10\nheight = 8\nmass = 160e3\nfriction = 0.5\n[[load]]\nname = \"push\"\nforce = 250e3\nelevation = 5\n[ground]\n{ground}\n"
        )
    };
    let clay = "undrained_strength = \"60 kPa\"\nsurcharge = \"20 kPa\"";
    let effective = 10.0 - 2.0 * 1250.0 / 1600.0;
    let bears = |c_u: f64, q: f64, s_c: f64| {
        let i_c = 0.5 * (1.0 + (1.0f64 - 250.0 / (effective * c_u)).sqrt());
        effective * ((std::f64::consts::PI + 2.0) * c_u * s_c * i_c + q) * 1e3
    };
    let ground =
        |text: &str, place: usize| json(text)["situations"][place]["ground"]["resistance"].as_f64().unwrap();
    let close =
        |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    close(ground(&text(clay), 0), bears(60.0, 20.0, 1.0));
    // Of a monolith 5 m long, all of it.
    let short = text(clay)
        .replace("height = 8", "height = 8\nlength = 5")
        .replace("160e3", "800e3")
        .replace("250e3", "1250e3");
    close(ground(&short, 0), 5.0 * bears(60.0, 20.0, 1.0 + 0.2 * 5.0 / effective));
    // EN 1997-1 divides c_u by 1.4 where it divides materials.
    for combination in [
        "factors = { push = 1 }\nmaterials = { \"ground.undrained_strength\" = 1.4 }",
        "code = \"EN1997-DA1-2\"\nfactors = { push = 1 }",
    ] {
        let text = format!("{}[[combination]]\nname = \"M\"\n{combination}\n", text(clay));
        close(ground(&text, 0), bears(60.0 / 1.4, 20.0, 1.0));
    }
    // What it has no use for is refused by name, and so is it where a strength is given.
    for (more, named) in [
        ("friction_angle_deg = 30", "`undrained_strength` does not go with `friction_angle_deg`"),
        ("unit_weight = \"10 kN/m3\"", "`undrained_strength` does not go with `unit_weight`"),
        ("cohesion = \"5 kPa\"", "`undrained_strength` does not go with `cohesion`"),
        ("law = \"hansen\"", "`undrained_strength` does not go with `law`"),
        ("centric_resistance = \"20 MN/m\"", "`undrained_strength` does not go with `centric_resistance`"),
        ("strength = \"600 kPa\"", "`strength` does not go with"),
    ] {
        let shown = refused(&text(&format!("{clay}\n{more}")));
        assert!(shown.contains(named), "{more}: {shown}");
    }
    let words = assessment(&text(clay)).text(&AssessmentView::default());
    assert!(words.contains("clay that does not drain, c_u = 60 kPa"), "{words}");
    // 8.4375 m · 60 kPa over 250 kN/m.
    let row = words.lines().find(|line| line.contains("sliding in the clay")).expect("a row");
    assert!(row.contains("B'c_u/|X|") && row.trim_end().ends_with("2.025"), "{row}");
    let soft = assessment(&text("undrained_strength = 60"));
    assert!(soft.case.warnings().iter().any(|warning| warning.name() == "unusual-ground"));
}
