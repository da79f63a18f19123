//! Cases with a base seen from above: rest over all directions, along records, by chance, and what is refused.

use std::f64::consts::{PI, SQRT_2, TAU};

use standfast_cases::directions::{Directions, SituationDirections};
use standfast_cases::random::{ChanceRequest, Happening, Method, Probability};
use standfast_cases::{Assessment, AssessmentView, CaseFile, Document};

fn record(name: &str) -> Result<String, String> {
    let path = format!("{}/../../examples/records/{name}", env!("CARGO_MANIFEST_DIR"));
    let bytes = std::fs::read(path).map_err(|error| error.to_string())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn file(text: &str) -> CaseFile {
    CaseFile::read("case.toml", text, &record)
        .unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)))
}

fn assessed(text: &str) -> Assessment {
    Assessment::of_file(&file(text)).unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)))
}

fn json(text: &str) -> serde_json::Value {
    serde_json::from_str(&assessed(text).json(&AssessmentView::default(), &[])).unwrap()
}

fn over(text: &str, step: f64) -> SituationDirections {
    Directions::of_file(&file(text), step).unwrap().all.remove(0)
}

fn refused(text: &str) -> String {
    let answered = CaseFile::read("case.toml", text, &record).and_then(|file| Assessment::of_file(&file));
    standfast_cases::report(&answered.err().unwrap_or_else(|| panic!("answered:\n{text}")))
}

const UNIT: &str = "[body]\nwidth = 2\nlength = 2\nheight = 6\nmass = 1000\nfriction = 0.7\ngravity = 10\n";

fn block(more: &str) -> String {
    format!("gravity = 10\n{}{more}", UNIT.replace("gravity = 10\n", ""))
}

/// R(φ)/d of corners by where a ray leaves the polygon: another way than the distances of its edges.
fn tips(corners: &[[f64; 2]], [x, z]: [f64; 2], height: f64) -> f64 {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let reach = ends.filter_map(|(a, b)| {
        let [e, f] = [[b[0] - a[0], b[1] - a[1]], [x, z]];
        let turns = f[0] * e[1] - f[1] * e[0];
        let along = (a[0] * e[1] - a[1] * e[0]) / turns;
        let share = (a[0] * f[1] - a[1] * f[0]) / turns;
        (turns.abs() > 1e-12 && along > 0.0 && (-1e-9..=1.0 + 1e-9).contains(&share)).then_some(along)
    });
    reach.fold(f64::INFINITY, f64::min) / height
}

/// From −x over away to +x.
fn towards(degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [-cos, sin]
}

#[test]
fn the_square_of_the_specification() {
    let of = over(&block("[[load]]\nforce = 1e4\nelevation = 3\ndirection_deg = 10\n"), 45.0);
    let factors: Vec<f64> = of.all.iter().map(|answer| answer.load_factor()).collect();
    for (place, factor) in factors.iter().enumerate() {
        let expected = if place % 2 == 0 { 1.0 / 3.0 } else { SQRT_2 / 3.0 };
        assert!((factor - expected).abs() < 1e-14, "{place}: {factor}");
    }
    assert!(!of.is_only_worst, "four edges are as near");
    // More than friction holds at the corners: there it slides.
    let slides = over(
        &block("[[load]]\nforce = 1e4\nelevation = 3\ndirection_deg = 10\n")
            .replace("friction = 0.7", "friction = 0.4"),
        45.0,
    );
    assert!((slides.all[1].load_factor() - 0.4).abs() < 1e-14);
    assert_eq!(slides.all[0].load_factor(), 1.0 / 3.0);
}

/// Polygons and feet of any shape: in every direction the least of friction and of where a ray leaves the hull.
#[test]
fn every_direction_is_the_closed_form() {
    let corners = [[-0.7, -0.5], [0.9, -0.6], [1.1, 0.4], [0.2, 0.8], [-0.8, 0.5]];
    let list = |corners: &[[f64; 2]]| format!("{corners:?}");
    for (key, inside) in [("polygon", vec![]), ("feet", vec![[0.1, 0.1], [-0.2, 0.0]])] {
        let all = list(&[&corners[..], &inside[..]].concat());
        let text = block(&format!(
            "[base]\n{key} = {all}\n[earthquake]\nhorizontal = \"1 m/s2\"\ndirection_deg = 0\n"
        ));
        let of = over(&text, 1.0);
        for answer in &of.all {
            let tipping = tips(&corners, towards(answer.degrees), 3.0);
            let expected = tipping.min(0.7) * 10.0;
            assert!((answer.load_factor() / expected - 1.0).abs() < 1e-12, "{key} {}", answer.degrees);
            assert!((answer.tipping.load_factor / (10.0 * tipping) - 1.0).abs() < 1e-12);
        }
        let least = of.worst.unwrap().load_factor();
        assert!(of.all.iter().all(|answer| answer.load_factor() >= least * (1.0 - 1e-12)));
        // By a plane of the least width, as the page says.
        let scan = (0..36_000).map(|step| tips(&corners, towards(f64::from(step) / 100.0), 3.0));
        let scanned = scan.fold(0.7, f64::min) * 10.0;
        assert!((least / scanned - 1.0).abs() < 1e-6, "{least} {scanned}");
    }
}

#[test]
fn turned_and_mirrored_cases_answer_alike() {
    let corners = [[-0.6, -0.5], [0.8, -0.4], [0.5, 0.7], [-0.4, 0.6]];
    let case = |corners: &[[f64; 2]], degrees: f64| {
        let text = format!(
            "[base]\npolygon = {corners:?}\n[[load]]\nforce = 2500\nelevation = 2.5\ndirection_deg = {degrees}\n"
        );
        json(&block(&text))["situations"][0].clone()
    };
    let plain = case(&corners, 25.0);
    for turn in [17.0f64, 90.0, 133.0, 270.0] {
        // Clockwise from above, as directions rise.
        let (sin, cos) = turn.to_radians().sin_cos();
        let turned = corners.map(|[x, z]| [x * cos + z * sin, z * cos - x * sin]);
        let other = case(&turned, 25.0 + turn);
        for key in ["load_factor", "SF_sliding", "SF_overturning_net"] {
            let [one, two] = [&plain, &other].map(|answer| answer[key].as_f64().unwrap());
            assert!((one / two - 1.0).abs() < 1e-12, "{key} turned by {turn}: {one} {two}");
        }
        assert_eq!(plain["plan"]["contact"], other["plan"]["contact"]);
    }
    let mirrored = corners.map(|[x, z]| [-x, z]);
    let other = case(&mirrored, 180.0 - 25.0);
    let [one, two] = [&plain, &other].map(|answer| answer["load_factor"].as_f64().unwrap());
    assert!((one / two - 1.0).abs() < 1e-13);
}

#[test]
fn a_disc_lies_between_its_polygons() {
    let load = "[[load]]\nforce = 2000\nelevation = 3.5\ndirection_deg = 33.7\n";
    let ring = |radius: f64| -> Vec<[f64; 2]> {
        (0..240)
            .map(|k| f64::from(k) * TAU / 240.0)
            .map(|angle| [radius * angle.cos(), radius * angle.sin()])
            .collect()
    };
    let factor = |base: &str| {
        json(&block(&format!("[base]\n{base}\n{load}")))["situations"][0]["load_factor"].as_f64().unwrap()
    };
    let disc = factor("circle = 1.8");
    let inside = factor(&format!("polygon = {:?}", ring(0.9)));
    let outside = factor(&format!("polygon = {:?}", ring(0.9 / (PI / 240.0).cos())));
    assert!(inside <= disc && disc <= outside && outside / inside < 1.0 + 2e-4, "{inside} {disc} {outside}");
}

/// Horizontal over vertical force by hand at every sample, and where a straight way between two leaves a rectangle.
#[test]
fn the_orbit_of_a_record_ends_rest_where_it_leaves_the_area() {
    let mut dice = 7_u64;
    let mut roll = || {
        dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (dice >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    };
    let mut exits = 0;
    for _ in 0..40 {
        let times: Vec<f64> = (0..30).map(|step| f64::from(step) * 0.1).collect();
        let mut values = |most: f64| -> Vec<f64> { times.iter().map(|_| most * roll()).collect() };
        let [x, z, y] = [values(4.0), values(4.5), values(2.0)];
        let history = |values: &[f64]| {
            format!("{{ shape = \"points\", peak = \"1 m/s2\", times = {times:?}, values = {values:?} }}")
        };
        let text = block(&format!(
            "[motion.base]\nhorizontal = {}\nhorizontal_z = {}\nvertical = {}\n",
            history(&x),
            history(&z),
            history(&y)
        ))
        .replace("width = 2", "width = 1.8")
        .replace("friction = 0.7", "friction = 0.38");
        let orbit = Directions::of_file(&file(&text), 45.0).unwrap().all.remove(0).orbit.unwrap();
        // How far a state is, as a share of where rest ends: linear forms and a cone, with weight 10 and acceleration upwards.
        let used = |x: f64, z: f64, y: f64, scale: f64| {
            let p = 10.0 + scale * y;
            let [x, z] = [scale * x, scale * z].map(f64::abs);
            [3.0 * x - 0.9 * p, 3.0 * z - p, x.hypot(z) - 0.38 * p]
                .into_iter()
                .fold(f64::NEG_INFINITY, f64::max)
        };
        // By halving the scale between rest and none.
        let rests = |scale: f64| (0..30).all(|i| used(x[i], z[i], y[i], scale) <= 0.0);
        let (mut low, mut high) = (0.0, 100.0);
        for _ in 0..200 {
            let middle = (low + high) / 2.0;
            if rests(middle) { low = middle } else { high = middle }
        }
        assert!((orbit.scale / low - 1.0).abs() < 1e-9, "{} {low}", orbit.scale);
        let first = (0..29 * 4000).find(|step| {
            let (i, share) = (step / 4000, f64::from(step % 4000) / 4000.0);
            let i = i as usize;
            let at = |values: &[f64]| values[i] + share * (values[i + 1] - values[i]);
            used(at(&x), at(&z), at(&y), 1.0) > 0.0
        });
        match (first, &orbit.exit) {
            (Some(step), Some(exit)) => {
                exits += 1;
                let time = f64::from(step) * 0.1 / 4000.0;
                assert!(exit.time <= time && exit.time > time - 0.1 / 3999.0, "{} {time}", exit.time);
            }
            (None, exit) => assert!(exit.is_none() || orbit.scale > 0.999_999),
            (Some(_), None) => panic!("it leaves rest"),
        }
    }
    assert!(exits > 10, "{exits}");
}

/// Loma Prieta at Redwood City as the rack is turned: at every ten degrees the part of it at which rest ends is
/// from 1.18 to 1.57, as others found.
#[test]
fn a_rack_under_a_record_as_it_is_turned() {
    let scale = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let corners = [[-0.3, -0.5], [0.3, -0.5], [0.3, 0.5], [-0.3, 0.5]]
            .map(|[x, z]: [f64; 2]| [x * cos - z * sin, x * sin + z * cos]);
        let text = format!(
            "[body]\nwidth = 0.6\nlength = 1\nheight = 1.8\nmass = 700\nfriction = 0.55\n[base]\npolygon = {corners:?}\n[motion.base]\n\
             horizontal = {{ shape = \"file\", file = \"np01002p_4225a_a.smc\" }}\n\
             horizontal_z = {{ shape = \"file\", file = \"np01002p_4225c_a.smc\" }}\n\
             vertical = {{ shape = \"file\", file = \"np01002p_4225b_a.smc\" }}\n"
        );
        Directions::of_file(&file(&text), 90.0).unwrap().all[0].orbit.as_ref().unwrap().scale
    };
    let all: Vec<f64> = (0..18).map(|step| scale(f64::from(step) * 10.0)).collect();
    let [least, most] = [all.iter().copied().fold(9.0, f64::min), all.iter().copied().fold(0.0, f64::max)];
    assert!((least - 1.18).abs() < 0.005 && (most - 1.57).abs() < 0.005, "{least} … {most}");
}

#[test]
fn the_answer_has_what_the_schema_promises() {
    let answer = json(&block(
        "[base]\nfeet = [[0, 1.2], [-0.9, -0.5], [0.9, -0.5]]\n[[load]]\nforce = 2000\nelevation = 3\ndirection_deg = 270\n",
    ));
    let situation = &answer["situations"][0];
    let plan = &situation["plan"];
    assert_eq!(plan["mode"], "RO");
    assert_eq!(plan["contact"], "edge 2");
    assert_eq!(plan["edges"], serde_json::json!([2]));
    assert_eq!(plan["direction_deg"], 270.0);
    assert_eq!(plan["slip_deg"], serde_json::Value::Null);
    assert_eq!(plan["worst_direction_deg"], 270.0);
    assert_eq!(plan["unique_in_direction"], true);
    // h P/(d X) = 0.5 · 10⁴/(3 · 2000).
    assert!((situation["load_factor"].as_f64().unwrap() - 5.0 / 6.0).abs() < 1e-12);
    assert_eq!(plan["rests"], false);
    assert!(plan["moment_about_it"].as_f64().unwrap().abs() < 1e-9);
    for key in [
        "mode",
        "mode_words",
        "motion",
        "report",
        "departure_mode",
        "heel",
        "SF_overturning_heel",
        "SF_overturning_gross",
        "bearing_max",
    ] {
        assert!(situation[key].is_null(), "{key}");
    }
    for key in ["also", "because", "path"] {
        assert_eq!(situation[key], serde_json::json!([]), "{key}");
    }
    assert_eq!((&situation["bearing"], &situation["no_report"]), (&"plan".into(), &"plan".into()));
    assert_eq!(situation["directions"].as_array().unwrap().len(), 24);
    let plane = json(&block("[[load]]\nforce = 2000\nelevation = 3\n"));
    for key in ["plan", "directions"] {
        assert!(plane["situations"][0].get(key).is_none(), "{key}");
    }
}

/// Whatever is not answered in space is refused by its name, and nothing else is.
#[test]
fn what_has_no_place_on_a_plan_is_refused() {
    let others = [
        ("[uplift]\nleft = 100\nright = 100\n", "[uplift]"),
        ("[[pressure]]\nface = \"left\"\nelevation = [0, 1]\npressure = [1, 1]\n", "[[pressure]]"),
        (
            "[[backfill]]\nface = \"left\"\ntop = 1\nfriction_angle_deg = 30\nunit_weight = 18e3\n",
            "[[backfill]]",
        ),
        ("[[resistance]]\nlimit = 100\ndirection = \"right\"\nelevation = 1\n", "[[resistance]]"),
        ("[[moment]]\nmoment = 100\n", "[[moment]]"),
        ("[[joint]]\nelevation = 1\nfriction = 0.5\n", "[[joint]]"),
        ("[ground]\nstrength = 1e6\n", "[ground]"),
        ("[added_mass]\nmass = 10\n", "[added_mass]"),
        ("[motion.impact]\nlaw = \"inelastic\"\n", "[motion.impact]"),
        ("[motion]\nt_max = 3\n", "t_max"),
        ("[water]\nleft = 1\nright = 0.5\ndensity = 1000\n", "water levels"),
    ];
    for (table, name) in others {
        let words =
            refused(&block(&format!("[[load]]\nforce = 1\nelevation = 1\ndirection_deg = 45\n{table}")));
        assert!(
            words.contains("a base seen from above is not for") && words.contains(name),
            "{table}: {words}"
        );
    }
    for key in ["adhesion = 100", "floor_deg = 1"] {
        let words = refused(
            &block("[[load]]\nforce = 1\nelevation = 1\nz = 0\n")
                .replace("friction = 0.7", &format!("friction = 0.7\n{key}")),
        );
        assert!(words.contains("a base seen from above is not for"), "{key}: {words}");
    }
    let still = block(
        "[water]\nlevel = 0.1\ndensity = 1000\n[[load]]\nforce = 1000\nelevation = 1\ndirection_deg = 45\n",
    );
    assert!(assessed(&still).governing().departure().load_factor() > 0.0);
    let shaken =
        block("[motion.base]\nhorizontal_z = { shape = \"half-sine\", peak = \"2 m/s2\", duration = 0.5 }\n");
    let words = standfast_cases::report(&file(&shaken).motions().unwrap_err());
    assert!(words.contains("not for a motion in time"), "{words}");
}

#[test]
fn slips_in_a_plan_are_named() {
    let load = "[[load]]\nforce = 1\nelevation = 1\ndirection_deg = 45\n";
    let of = |base: &str| block(&format!("[base]\n{base}\n{load}"));
    for (base, words) in [
        ("feet = [[0, 0], [1, 1], [2, 2]]", "on a line"),
        ("feet = [[0, 0], [1, 1]]", "on a line"),
        ("polygon = [[2, 2], [3, 2], [3, 3]]", "beside the base"),
        ("feet = [[-1, -1], [1, -1], [0, 1]]\ncircle = 1", "circle"),
        ("feet = [[-1, -1], [1, -1, 3], [0, 1]]", "a pair [x, z]"),
        ("circle = -1", "circle"),
        ("", "polygon"),
    ] {
        let found = refused(&of(base));
        assert!(found.contains(words), "{base}: {found}");
    }
    let both =
        refused(&block("[[load]]\nforce = 1\nelevation = 1\ndirection = \"right\"\ndirection_deg = 45\n"));
    assert!(both.contains("direction_deg") && both.contains("direction"), "{both}");
    let twice =
        refused(&block("[earthquake]\nhorizontal = \"1 g\"\nhorizontal_z = \"1 g\"\ndirection_deg = 45\n"));
    assert!(twice.contains("horizontal_z"), "{twice}");
    let turns = refused(&block("[[load]]\nforce = 1\nelevation = 1\ndirection_deg = 45\nz = 0.4\n"));
    assert!(turns.contains("answered on a disc alone") && turns.contains(":12:"), "{turns}");
    let lengthless = refused(&block(load).replace("length = 2\n", ""));
    assert!(lengthless.contains("length"), "{lengthless}");
    // A hull that leaves corners out says so.
    let dented = assessed(&of("polygon = [[-1, -1], [1, -1], [0, 0], [1, 1], [-1, 1]]"));
    let text = dented.text(&AssessmentView::default());
    assert!(text.contains("5 corners, 1 of them within the hull of the others"), "{text}");
}

fn chances(text: &str, method: Option<Method>) -> Probability {
    let request = ChanceRequest { method, ..ChanceRequest::default() };
    Probability::of(&file(text), request).unwrap_or_else(|error| panic!("{error}"))
}

/// A push of any direction on a square: it tips where the direction is within an angle of a side's, by hand.
#[test]
fn the_chance_of_rest_over_all_directions() {
    let text = block(
        "[[load]]\nforce = 3700\nelevation = 3\ndirection_deg = 20\n[random]\n\"load[1].direction_deg\" = { uniform = { from = 0, to = 360 } }\n",
    );
    let found = chances(&text, None);
    let chance = |slides: bool| {
        let modes = &found.situations[0].modes;
        modes.iter().find(|(happening, _)| *happening == Happening::OnPlan { slides }).unwrap().1.value
    };
    // k cos(φ) > 1/3 about each of four sides.
    let expected = 4.0 * 2.0 * (1.0f64 / 3.0 / 0.37).acos() / TAU;
    assert!((chance(false) - expected).abs() < 1e-9, "{} {expected}", chance(false));
    assert_eq!(chance(true), 0.0);
    assert!((found.situations[0].not_rest.value - expected).abs() < 1e-9);
}

/// Friction in closed form against drawing everything, of a load that both slides and tips.
#[test]
fn chance_on_a_plan_by_two_ways() {
    let text = block(
        "[base]\npolygon = [[-1, -0.8], [1.2, -1], [0.6, 1.1], [-0.9, 0.7]]\n[[load]]\nforce = 3000\nelevation = 3\ndirection_deg = 20\n[random]\n\
         friction = { lognormal = { mean = 0.36, cov = 0.15 } }\n\"load[1].direction_deg\" = { uniform = { from = 0, to = 360 } }\n",
    );
    let exact = chances(&text, None);
    let drawn = chances(&text, Some(Method::MonteCarlo));
    for slides in [true, false] {
        let of = |found: &Probability| {
            let modes = &found.situations[0].modes;
            modes.iter().find(|(happening, _)| *happening == Happening::OnPlan { slides }).unwrap().1
        };
        let (one, two) = (of(&exact), of(&drawn));
        let sigma = (two.high - two.low) / 4.0;
        assert!((one.value - two.value).abs() < 5.0 * sigma && one.value > 0.02, "{slides}: {one:?} {two:?}");
    }
}

/// Where sliding gives way to tipping the area of rest has a corner, on the circle and on an edge: both sides of it are told.
#[test]
fn the_area_of_rest_has_its_corners() {
    let text = block(
        "[base]\nfeet = [[0, 1.2], [-0.9, -0.5], [0.9, -0.5]]\n[[load]]\nforce = 2000\nelevation = 3\ndirection_deg = 270\n",
    )
    .replace("friction = 0.7", "friction = 0.3");
    let answer = Directions::of_file(&file(&text), 90.0).unwrap();
    let mut corners = answer.all[0].corners.clone();
    corners.sort_by(|one, two| one.degrees.total_cmp(&two.degrees));
    // Of three feet, each farther than the circle: three corners of the base, and on both sides of each the end of an edge.
    assert_eq!(corners.len(), 3 + 6 * 2);
    let pairs = corners.windows(2).filter(|pair| pair[0].tips() != pair[1].tips());
    let mut count = 0;
    for pair in pairs {
        count += 1;
        assert!(pair[1].degrees - pair[0].degrees < 1e-5);
        for one in pair {
            let tips = one.tipping.load_factor;
            assert!((one.load_factor() / tips - 1.0).abs() < 1e-6, "{one:?}");
        }
    }
    assert!((5..=6).contains(&count), "{count}");
}

/// Arcs of directions that are narrower than any scan: where an edge is reached by two thousandths more than it bears, and where friction
/// ends rest at corners alone. By hand on a square; at a million directions on three feet, of which the way out is a ray.
#[test]
fn narrow_arcs_of_directions_are_not_missed() {
    let chances = |text: &str| {
        let answer = Probability::of(&file(text), ChanceRequest::default()).unwrap();
        let chances = &answer.situations[0];
        let slides = chances.first_departure.modes.iter().find(|(mode, _)| mode.name() == "slides");
        (chances.not_rest.value, slides.map_or(0.0, |(_, share)| share.value))
    };
    let random = "[random]\n\"load[1].direction_deg\" = { uniform = { from = 0, to = 360 } }\n";
    let load = |force: f64| format!("[[load]]\nforce = {force}\nelevation = 3\ndirection_deg = 30\n{random}");
    for force in [3333.4_f64, 3340.0, 3400.0, 4000.0] {
        let exact = 8.0 * (1e4 / 3.0 / force).acos().to_degrees() / 360.0;
        let (found, _) = chances(&block(&load(force)));
        assert!((found / exact - 1.0).abs() < 1e-9, "{force}: {found} {exact}");
        // A second number, which hardly differs, keeps them.
        let two = block(&load(force)) + "\"load[1].force\" = { normal = { mean = 3400, cov = 1e-9 } }\n";
        let exact = 8.0 * (1e4 / 3.0 / 3400f64).acos().to_degrees() / 360.0;
        assert!((chances(&two).0 / exact - 1.0).abs() < 1e-6);
    }
    let corners = [[0.0, 1.2], [-0.9, -0.5], [0.9, -0.5]];
    let feet = "[base]\nfeet = [[0, 1.2], [-0.9, -0.5], [0.9, -0.5]]\n";
    for (friction, force) in [(0.3, 1700.0), (0.33, 1668.0), (0.342, 1700.0)] {
        let text = block(&format!("{feet}{}", load(force)))
            .replace("friction = 0.7", &format!("friction = {friction}"));
        let (found, slides) = chances(&text);
        let all = 200_000;
        let (mut moves, mut first) = (0, 0);
        for place in 0..all {
            let (sin, cos) = ((f64::from(place) + 0.5) / f64::from(all) * std::f64::consts::TAU).sin_cos();
            let tips = tips(&corners, [-cos, sin], 3.0);
            moves += i32::from(force / 1e4 > tips.min(friction));
            first += i32::from(friction < tips);
        }
        let [moves, first] = [moves, first].map(|count| f64::from(count) / f64::from(all));
        assert!((found - moves).abs() < 3e-5, "{friction}: {found} {moves}");
        assert!((slides - first).abs() < 3e-5, "{friction}: {slides} {first}");
        assert!(first > 0.0 && moves > 0.0);
    }
}
