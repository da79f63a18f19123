//! Bodies of parts, objects of a given length and cylinders, as case files give them.

use standfast::Mode;
use standfast_cases::results::{ResultKind, ResultName, ResultValue};
use standfast_cases::units::Dimension;
use standfast_cases::{Assessment, CaseFile, Document};

fn assess(text: &str) -> Assessment {
    let case = CaseFile::parse("t.toml", text).unwrap().case().unwrap();
    Assessment::of(&case).unwrap()
}

fn number(assessment: &Assessment, result: ResultName) -> f64 {
    match result.of(assessment.governing()) {
        ResultValue::Number(number) => number,
        other => panic!("{}: {other:?}", result.name()),
    }
}

/// Asserts that two cases have the same results, the forces and moments of the second `times` as large.
fn same(one: &str, two: &str, times: f64) {
    let (one, two) = (assess(one), assess(two));
    // What is told of a weight less buoyancy alone is not told of both.
    for result in ResultName::ALL.iter().filter(|result| result.asked_by().is_none()) {
        let whole =
            matches!(result.info().kind, ResultKind::Number(Some(Dimension::Force | Dimension::Moment)));
        let times = if whole { times } else { 1.0 };
        match (result.of(one.governing()), result.of(two.governing())) {
            (ResultValue::Number(one), ResultValue::Number(two)) => {
                let off = (one * times - two).abs();
                assert!(one == two || off <= 1e-9 * two.abs().max(1e-9), "{}: {one} {two}", result.name());
            }
            (one, two) => assert_eq!(one, two, "{}", result.name()),
        }
    }
}

fn error(text: &str) -> String {
    let error = CaseFile::parse("t.toml", text).and_then(|file| file.case()).unwrap_err();
    standfast_cases::report(&error)
}

const LOAD: &str = "[[load]]\nforce = 300e3\nelevation = 8\n";

/// Two rectangles and two triangles that make up a uniform block answer as it does, the report's diagram included.
#[test]
fn parts_of_a_block_are_the_block() {
    let block = format!("[body]\nwidth = 15\nheight = 12\ndensity = 2100\nfriction = 0.6\n{LOAD}");
    let parts = format!(
        "[body]\nfriction = 0.6\n\
         [[part]]\nleft = 3\nwidth = 6\nbottom = 0\nheight = 4\ndensity = 2100\n\
         [[part]]\nleft = 9\nwidth = 9\nbottom = 0\nheight = 4\ndensity = 2100\n\
         [[part]]\nx = [3, 18, 18]\ny = [4, 4, 12]\ndensity = 2100\n\
         [[part]]\nleft = 3\nwidth = 15\nbottom = 4\nheight = 8\ntop_width = 0\ndensity = 0\n{LOAD}"
    );
    // The last part is the other triangle: its bottom would overlap, so it is given by its corners.
    let parts = parts.replace(
        "[[part]]\nleft = 3\nwidth = 15\nbottom = 4\nheight = 8\ntop_width = 0\ndensity = 0\n",
        "[[part]]\nx = [3, 18, 3]\ny = [4, 12, 12]\ndensity = 2100\n",
    );
    same(&block, &parts, 1.0);
    assert!(assess(&parts).governing().outcome.full.effective.is_some());
}

/// Goda's densities, 2400 above still water and 2100 below, give the weight that his example has by hand, and the answer of the
/// case that gives it so, with its centre and moment of inertia by hand.
#[test]
fn a_caisson_of_parts_has_godas_weight() {
    let parts = include_str!("../../../examples/caisson-of-parts.toml");
    let assessment = assess(parts);
    assert!((number(&assessment, ResultName::BuoyantWeight) / 1e3 - 2318.64).abs() < 0.005);
    let ((upper, lower), width) = ((3.4 * 2400.0, 7.1 * 2100.0), 15.0);
    let y = (upper * 8.8 + lower * 3.55) / (upper + lower);
    let own = |mass: f64, height: f64, at: f64| {
        mass * width * ((width * width + height * height) / 12.0 + (at - y) * (at - y))
    };
    let inertia = own(upper, 3.4, 8.8) + own(lower, 7.1, 3.55);
    let begin = parts.find("[[part]]").unwrap();
    let end = parts.find("[water]").unwrap();
    let by_hand = format!(
        "{}width = 15\nheight = 10.5\nmass = {}\ncentroid_height = {y}\nmoment_of_inertia = {inertia}\n{}",
        &parts[..begin],
        (upper + lower) * width,
        &parts[end..]
    );
    same(&by_hand, parts, 1.0);
}

/// A wall on a wider footing in water that differs from side to side, against forces by hand.
#[test]
fn water_stands_on_a_footing() {
    let parts = "gravity = 10\n[body]\nfriction = 0.6\n[water]\nleft = 3\nright = 5\ndensity = 1000\n\
         [[part]]\nleft = -4\nwidth = 8\nbottom = 0\nheight = 1\ndensity = 2400\n\
         [[part]]\nleft = -2\nwidth = 4\nbottom = 1\nheight = 8\ndensity = 2400\n";
    let assessment = assess(parts);
    // 960 kN of parts, 40 kN of water at the left and 80 kN at the right, less 8 m of 40 kPa.
    assert!((number(&assessment, ResultName::BuoyantWeight) / 1e3 - 760.0).abs() < 1e-9);
    assert!((number(&assessment, ResultName::P) / 1e3 - 80.0).abs() < 1e-9);
    // About O: 960·4 + 40·1 + 80·7, less 8·30·4 and 8·20/2·16/3.
    let arm = (960.0 * 4.0 + 40.0 + 560.0 - 960.0 - 80.0 * 16.0 / 3.0) / 760.0;
    assert!((number(&assessment, ResultName::WeightArm) - arm).abs() < 1e-9);
    assert!(assessment.text(&Default::default()).contains("water standing on the left side"));
}

/// All widths at once, in the file and by hand; what moves with the width moves.
#[test]
fn widths_of_parts_are_scaled_together() {
    let parts = |scale: &str, [foot, left, wall]: [f64; 3]| {
        format!(
            "[body]\nfriction = 0.6\n{scale}[[part]]\nleft = 0\nwidth = {foot}\nbottom = 0\nheight = 1\ndensity = 2400\n\
             [[part]]\nleft = {left}\nwidth = {wall}\nbottom = 1\nheight = 8\ndensity = 2300\ndensity_below_water = 2000\n\
             [water]\nlevel = 4\ndensity = 1000\n{LOAD}"
        )
    };
    same(&parts("", [12.0, 3.0, 6.0]), &parts("width_scale = 1.5\n", [8.0, 2.0, 4.0]), 1.0);
}

/// A block 20 m long under the forces of 20 m is one metre of it under those of a metre.
#[test]
fn an_object_of_a_length() {
    let case = |length: &str, times: f64| {
        format!(
            "[body]\nwidth = 3\nheight = 5\nmass = {}\nfriction = 0.5\n{length}[water]\nleft = 2\nright = 1\ndensity = 1000\n\
             [uplift]\nleft = 1e3\nright = 3e3\n[earthquake]\nhorizontal = \"0.1 g\"\n[added_mass]\nsides = 2\n\
             [[pressure]]\nface = \"right\"\nelevation = [0, 4]\npressure = [9e3, 1e3]\n\
             [[pressure]]\nface = \"top\"\ndistance = [0, 2]\npressure = [9e3, 1e3]\n\
             [[load]]\nforce = {}\nelevation = 2\n",
            33e3 * times,
            20e3 * times
        )
    };
    same(&case("", 1.0), &case("length = 20\n", 20.0), 20.0);
}

/// A drum under a push: it tips where the moment about its rim does, slides where friction is used up, and bears as a circle.
#[test]
fn a_drum_by_hand() {
    let drum = |force: f64| {
        format!(
            "gravity = 10\n[body]\nshape = \"cylinder\"\nwidth = 2\nheight = 3\nmass = \"10 t\"\nfriction = 0.5\n\
             [[load]]\nforce = \"{force} kN\"\nelevation = 2.5\n"
        )
    };
    // 100 kN · 1 m against F · 2.5 m.
    let assessment = assess(&drum(20.0));
    assert!((number(&assessment, ResultName::SfOverturningNet) - 2.0).abs() < 1e-12);
    assert!((number(&assessment, ResultName::SfSliding) - 2.5).abs() < 1e-12);
    assert!((number(&assessment, ResultName::LoadFactor) - 2.0).abs() < 1e-12);
    // At r/4 the far edge is unloaded: p = 2 W/A, and all is in contact.
    let limit = assess(&drum(10.0));
    let most = 2.0 * 100e3 / std::f64::consts::PI;
    assert!((number(&limit, ResultName::BearingMax) / most - 1.0).abs() < 1e-9);
    assert!((number(&limit, ResultName::ContactShare) - 1.0).abs() < 1e-6);
    assert_eq!(assess(&drum(41.0)).governing().outcome.full.mode(), Some(Mode::RockO));
    let text = assessment.text(&Default::default());
    assert!(text.contains("diameter 2B") && text.contains("wobbles") && text.contains("20 kN ←"));
}

/// Faults of parts are shown at the part, or at both.
#[test]
fn faults_of_parts_are_shown_where_they_are() {
    let with = |parts: &str| format!("[body]\nfriction = 0.6\n{parts}{LOAD}");
    let block = "[[part]]\nleft = 0\nwidth = 8\nbottom = 0\nheight = 1\ndensity = 2400\n";
    let cases = [
        (
            "[[part]]\nname = \"wall\"\nleft = 2\nwidth = 4\nbottom = 0.9\nheight = 8\ndensity = 2400\n",
            "parts 1 and 2 overlap by 4 m, at x = ",
        ),
        (
            "[[part]]\nleft = 2\nwidth = 4\nbottom = 1.5\nheight = 8\ndensity = 2400\n",
            "the parts leave a gap of 0.5 m, at x = ",
        ),
        ("[[part]]\nleft = 2\nwidth = 4\nbottom = 1\ndensity = 2400\n", "[[part]] lacks `height`"),
        ("[[part]]\nleft = 2\nwidth = 4\nbottom = 1\nheight = 8\n", "[[part]] lacks `density`"),
        ("[[part]]\ndensity = 2400\n", "the part has no outline"),
        ("[[part]]\nx = [0, 8, 8]\ny = [1, 1]\ndensity = 2400\n", "`x` and `y` have 3 and 2 numbers"),
        (
            "[[part]]\nx = [0, 8, 8]\ny = [1, 1, 2]\nleft = 3\ndensity = 2400\n",
            "[[part]] has both `x` and `left`",
        ),
        (
            "[[part]]\nx = [0, 8, 0, 6]\ny = [1, 3, 2, 1]\ndensity = 2400\n",
            "part 2: its sides 1 and 3 cross or touch",
        ),
        ("[[part]]\nx = [0, 4, 8]\ny = [1, 1, 1]\ndensity = 2400\n", "part 2: the outline encloses no area"),
        (
            "[[part]]\nleft = 0\nwidth = 1\nbottom = 1\nheight = 1\ndensity = -2400\n",
            "`density` is -2400; expected a finite number",
        ),
        ("[[part]]\nleft = 30\nwidth = 1\nbottom = 0\nheight = 1\ndensity = 2400\n", "gap of 22 m"),
        (
            "[[part]]\nleft = 8.5\nwidth = 4\nbottom = 1\nheight = 2\ndensity = 2400\n",
            "what lies above 1 m does not stand on what is below it, at x = 10.5 m",
        ),
    ];
    for (part, expected) in cases {
        let error = error(&with(&format!("{block}{part}")));
        assert!(error.contains(expected), "{expected}\n{error}");
    }
    let overlapping = error(&with(&format!("{block}{}", cases[0].0)));
    assert_eq!(
        [&"^".repeat(8), &"-".repeat(8)].map(|line| overlapping.matches(line).count()),
        [1, 1],
        "{overlapping}"
    );
    for (file, expected) in [
        (
            with("[[part]]\nleft = 0\nwidth = 8\nbottom = \"20 cm\"\nheight = 1\ndensity = 2400\n"),
            "the lowest part begins 0.2 m above the base",
        ),
        (
            with("[[part]]\nx = [0, 1, -1]\ny = [0, 1, 1]\ndensity = 2400\n"),
            "touches its base, at height 0, in a point",
        ),
        (
            with("[[part]]\nx = [0, 1, 1]\ny = [-1, 0, 1]\ndensity = 2400\n"),
            "the part reaches 1 m below the base",
        ),
        (with("[[part]]\nx = [0, 1, 9, 9]\ny = [0, 0, 3, 4]\ndensity = 2400\n"), "not between the corners"),
        (with(&format!("{block}{block}")), "parts 1 and 2 overlap"),
        (
            with(block).replace("friction = 0.6", "friction = 0.6\nmass = 3"),
            "[body] has `mass`, which follows from the parts",
        ),
        (with("width_scale = 2\n"), "`width_scale` multiplies the widths of parts, and there is no [[part]]"),
    ] {
        let error = error(&file);
        assert!(error.contains(expected), "{expected}\n{error}");
    }
}

#[test]
fn units_are_those_of_a_metre_or_of_the_whole() {
    let body = |rest: &str| format!("[body]\nwidth = 3\nheight = 5\nfriction = 0.5\n{rest}");
    let load = "[[load]]\nelevation = 2\n";
    for (file, expected) in [
        (body(&format!("mass = \"33 t\"\n{load}force = 1\n")), "expected a mass per metre run"),
        (body(&format!("mass = \"33 t\"\n{load}force = 1\n")), "its `length` in [body]"),
        (
            body(&format!("mass = 33e3\nlength = 2\n{load}force = \"9 kN/m\"\n")),
            "expected a force on the whole",
        ),
        (body(&format!("mass = 33e3\nlength = 2\n{load}force = \"9 kN/m\"\n")), "or is a cylinder"),
        (
            body(&format!("mass = 33e3\nlength = 0\n{load}force = 9\n")),
            "`length` is 0; expected a finite number above zero",
        ),
    ] {
        let error = error(&file);
        assert!(error.contains(expected), "{expected}\n{error}");
    }
    let whole = assess(&body(&format!("mass = \"33 t\"\nlength = \"50 cm\"\n{load}force = \"9 kN\"\n")));
    let text = whole.text(&Default::default());
    assert!(text.contains("33000 kg") && text.contains("9 kN ←") && !text.contains("/m "), "{text}");
    assert!(whole.json(&Default::default(), &[]).contains("\"extent\": \"whole\""));
}

#[test]
fn a_cylinder_is_no_wall() {
    let drum = |rest: &str| {
        format!(
            "[body]\nshape = \"cylinder\"\nwidth = 2\nheight = 3\nmass = 10e3\nfriction = 0.5\n{rest}{LOAD}"
        )
        .replace("elevation = 8", "elevation = 2")
    };
    for (rest, expected) in [
        ("length = 2\n", "a cylinder has no `body.length`"),
        ("base_left = 1\n", "a cylinder has no `body.base_left`"),
        ("[water]\nleft = 2\nright = 1\ndensity = 1000\n", "a cylinder has no `water.left`"),
        (
            "[water]\nlevel = 1\ndensity = 1000\n[added_mass]\nsides = 2\n",
            "a cylinder has no `added_mass.sides`",
        ),
        (
            "[[part]]\nx = [0, 1, 1]\ny = [0, 0, 1]\ndensity = 1\n",
            "[[part]] does not go with `shape = \"cylinder\"`",
        ),
    ] {
        let error = error(&drum(rest));
        assert!(error.contains(expected), "{expected}\n{error}");
    }
    let waves = include_str!("../../../examples/goda-2000.toml");
    let waves =
        waves.replace("[body]", "[body]\nlength = 20").replace("t/m\"", "t\"").replace("kN/m\"", "kN\"");
    assert!(error(&waves).contains("[wave] does not go with a single object"), "{}", error(&waves));
}

/// W' as given against the parts: a warning with both from 1 % on.
#[test]
fn a_given_weight_is_compared_with_the_parts() {
    let parts = include_str!("../../../examples/caisson-of-parts.toml");
    let water = parts.find("[water]").unwrap();
    let wave = parts.find("[wave]").unwrap();
    let with = |weight: f64| {
        let body = parts[..water].replace("[body]", &format!("[body]\nbuoyant_weight = {weight}"));
        let case = CaseFile::parse("t.toml", &format!("{body}{}", &parts[wave..])).unwrap().case().unwrap();
        case.warnings()
            .iter()
            .find(|warning| warning.name() == "buoyant-beside-parts")
            .map(ToString::to_string)
    };
    let weight = 15.0 * (3.4 * 2400.0 + 7.1 * (2100.0 - 1030.0)) * 9.81;
    for share in [0.9901, 1.0, 1.0099] {
        assert_eq!(with(weight * share), None);
    }
    for (share, off) in [(0.9899, "1.02 % more"), (1.0101, "0.9999 % less")] {
        let message = with(weight * share).unwrap();
        assert!(message.contains(&format!("2319 kN/m, {off}")), "{message}");
    }
}

/// Without an arm of its own, W' acts where that of the parts does: by hand for a wall off the middle of its footing.
#[test]
fn a_given_weight_of_parts_has_their_arm() {
    let wave = include_str!("../../../examples/caisson-of-parts.toml");
    let wave = &wave[wave.find("[wave]").unwrap()..];
    let parts = "[[part]]\nleft = 0\nwidth = 15\nbottom = 0\nheight = 2\ndensity = 2400\n\
         [[part]]\nleft = 2\nwidth = 8\nbottom = 2\nheight = 8.5\ndensity = 2300\n";
    // 30 m² at 7.5 m and 68 m² at 6 m; of these 5.1 m of 8 m under water.
    let [foot, wall] = [30.0 * 2400.0, 68.0 * 2300.0];
    let [foot_water, wall_water] = [30.0 * 1030.0, 5.1 * 8.0 * 1030.0];
    let weight = foot + wall - foot_water - wall_water;
    let arm = ((foot - foot_water) * 7.5 + (wall - wall_water) * 6.0) / weight;
    let text = format!("[body]\nfriction = 0.6\nbuoyant_weight = {}\n{parts}{wave}", weight * 9.81);
    let assessment = assess(&text);
    assert!((number(&assessment, ResultName::WeightArm) - arm).abs() < 1e-9);
    // The sea 1 m higher takes off as much as it displaces; of parts that are wetter, less what they take up.
    let file = CaseFile::parse(
        "t.toml",
        &text.replace("density = 2300", "density = 2300\ndensity_below_water = 2000"),
    );
    let file = file.unwrap();
    let case = file.case().unwrap();
    let level = standfast_cases::couple::Variable::find("water_level", file.inputs()).unwrap();
    let higher = standfast_cases::couple::vary(file.inputs(), &case, &[(&level, 8.1)]);
    let found = higher.number(standfast_cases::Key::BuoyantWeight).unwrap();
    assert!((found - (weight - 8.0 * (1030.0 + 300.0)) * 9.81).abs() < 1e-6, "{found}");
}

/// A load at the crest of parts, and water up to it, are where the file's decimals have them, however these add up as f64.
#[test]
fn the_crest_of_parts_is_where_their_decimals_have_it() {
    let text = |lower: u32, upper: u32, level: &str| {
        let [lower, upper] = [lower, upper].map(|tenths| f64::from(tenths) / 10.0);
        format!(
            "[body]\nfriction = 0.6\n[water]\nlevel = {level}\ndensity = 1030\n\
             [[part]]\nleft = 0\nwidth = 9\nbottom = 0\nheight = {lower}\ndensity = 2400\n\
             [[part]]\nleft = 0\nwidth = 9\nbottom = {lower}\nheight = {upper}\ndensity = 2400\n\
             [[load]]\nforce = 1e3\nelevation = {level}\n"
        )
    };
    let mut less = 0;
    for lower in 1..40 {
        for upper in 1..20 {
            let level = f64::from(lower + upper) / 10.0;
            let case = CaseFile::parse("t.toml", &text(lower, upper, &level.to_string())).unwrap().case();
            let case = case.unwrap_or_else(|error| panic!("{lower} + {upper}: {error}"));
            less += u32::from(case.body.height() < level);
        }
    }
    assert!(less > 20, "{less}");
    let above = text(7, 1, "0.8000000000000007");
    assert!(error(&above).contains("crest"));
    let above = above.replace("[water]\nlevel = 0.8000000000000007\ndensity = 1030\n", "");
    assert!(error(&above).contains("above the crest"));
}

/// One caisson, its weight given in full with water about it, or less its buoyancy: a factor on the weight is one on m g, a factor
/// on the water one on the buoyancy, and every result is the same; by hand, sliding is μ(f m g − f_w ρ g A − U)/P.
#[test]
fn a_factor_on_the_weight_is_one_in_air_however_the_weight_is_given() {
    let body =
        |more: &str| format!("[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\n{more}");
    let wave = "[wave]\ndeep_water_height = 6.3\nperiod = 11.4\nsea_bottom_slope = 0.01\nwater_depth = 10.1\ndepth_above_berm = 5.6\n\
         base_depth = 7.1\ncrest_height = 3.4\nberm_width = 8\nangle_deg = 15\nwater_density = 1030\ncaisson_width = 15\n";
    let weight = 346050.0 * 9.81;
    let displaced = 1030.0 * 9.81 * 15.0 * 7.1;
    for (factors, of_weight, of_water) in [
        ("wave = 1", 1.0, 1.0),
        ("weight = 0.9, wave = 1", 0.9, 1.0),
        ("weight = 1.05, water = 1.1, wave = 1.3", 1.05, 1.1),
    ] {
        let combination = format!("[[combination]]\nfactors = {{ {factors} }}\n");
        for arm in [7.5, 7.2] {
            let buoyant = (weight - displaced).to_string();
            // Of a body whose centre of mass is off the middle, the displaced rectangle's is not.
            let offset = (7.5 - arm) * (weight - displaced) / weight;
            let centre = format!("centroid_offset = {}\n", -offset);
            let given = body(&format!("buoyant_weight = {buoyant}\nweight_arm = {arm}\n{centre}"));
            let wet = format!("{}[water]\nlevel = 7.1\n{wave}{combination}", body(&centre));
            let (buoyant, wet) = (format!("{given}{wave}{combination}"), wet);
            same(&wet, &buoyant, 1.0);
            let found = assess(&buoyant);
            let [p, u] = [ResultName::P, ResultName::U].map(|result| number(&found, result));
            let by_hand = 0.6 * (of_weight * weight - of_water * displaced - u) / p;
            assert!((number(&found, ResultName::SfSliding) / by_hand - 1.0).abs() < 1e-12, "{factors}");
        }
    }
}
