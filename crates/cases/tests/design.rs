//! Designs against closed forms, against assessments on a fine grid, and what is printed of them against an assessment of just
//! that.

use serde_json::Value;
use standfast_cases::couple::{Variable, vary};
use standfast_cases::design::{
    BoundaryRequest, Design, DesignBoundary, DesignRequest, Extreme, Spelling, Target, TargetError,
    boundary_csv,
};
use standfast_cases::{Assessment, Case, CaseFile, Check, Document, Key, Portion, report};

/// A dry block under one force: it slides at μ m g/F, and turns about the corner at m g w/(2 F e).
const BLOCK: &str = "[body]\nwidth = 4\nheight = 6\ndensity = 2400\nfriction = 0.5\n\
    [[load]]\nforce = 300e3\nelevation = 4\n";

const QUAY: &str = include_str!("../../../examples/quay.toml");
const GODA: &str = include_str!("../../../examples/goda-2000.toml");
const SEISMIC: &str = include_str!("../../../examples/seismic-block.toml");
const FLOOD: &str = include_str!("../../../examples/head-difference.toml");

fn file(text: &str) -> CaseFile {
    CaseFile::parse("case.toml", text).unwrap()
}

fn request(vary: &str, target: &str, extreme: Extreme) -> DesignRequest {
    let target = target.parse().unwrap();
    DesignRequest {
        vary: vary.to_owned(),
        target,
        extreme,
        from: None,
        to: None,
        spelling: &Spelling::PROGRAM,
    }
}

/// The JSON of a design that there is.
fn design(text: &str, request: DesignRequest) -> Value {
    let file = file(text);
    let design = Design::of(&file, request, Portion::UNSEEN).map_err(|error| report(&error)).unwrap();
    let json: Value = serde_json::from_str(&design.json(&(), &[])).unwrap();
    // The text shows the same value.
    let printed = json["found"]["printed"].as_str().unwrap();
    assert!(design.text(&()).contains(printed), "{printed} is not in\n{}", design.text(&()));
    json
}

fn refusal(text: &str, request: DesignRequest) -> String {
    let file = file(text);
    match Design::of(&file, request, Portion::UNSEEN) {
        Ok(design) => panic!("{}", design.text(&())),
        Err(error) => report(&error).split_whitespace().collect::<Vec<_>>().join(" "),
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// A case with a quantity changed, assessed; nothing where it makes no sense.
fn with(text: &str, name: &str, value: f64) -> Option<Assessment> {
    let file = file(text);
    let case = file.case().unwrap();
    let variable = Variable::find(name, file.inputs()).unwrap();
    Assessment::of(&Case::of(&vary(file.inputs(), &case, &[(&variable, value)])).ok()?).ok()
}

fn sliding(answer: &Assessment) -> f64 {
    answer.tried().map(|assessed| assessed.outcome.stability.sliding).fold(f64::INFINITY, f64::min)
}

fn overturning(answer: &Assessment) -> f64 {
    answer.tried().map(|assessed| assessed.outcome.stability.overturning()).fold(f64::INFINITY, f64::min)
}

fn near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-11, "{found}, expected {expected}");
}

/// One more or less in the last of four digits.
fn step(value: f64) -> f64 {
    10f64.powf(value.abs().log10().floor() - 3.0)
}

#[test]
fn a_dry_block_has_its_closed_form() {
    let weight_per_metre: f64 = 6.0 * 2400.0 * 9.81;
    // μ ρ g h w/F = 1.3 and ρ g h w²/(2 F e) = 1.3.
    let slides = 1.3 * 300e3 / (0.5 * weight_per_metre);
    let turns = (1.3 * 2.0 * 300e3 * 4.0 / weight_per_metre).sqrt();
    for (target, expected) in [
        ("SF_sliding=1.3", slides),
        ("SF_overturning_net=1.3", turns),
        ("factor=1.3", slides.max(turns)),
        ("load_factor=1.3", slides.max(turns)),
        ("load-factor=1.3", slides.max(turns)),
        // Rest is a factor of 1 against either.
        ("rest", (slides / 1.3).max(turns / 1.3f64.sqrt())),
    ] {
        let json = design(BLOCK, request("width", target, Extreme::Least));
        near(number(&json["found"]["boundary"]), expected);
        let rounded = number(&json["found"]["value"]);
        assert!(rounded >= expected && rounded - step(rounded) < expected, "{target}: {rounded}, {expected}");
    }
    // The other way round: the greatest force, F = μ m g/1.3, rounded down.
    let json = design(BLOCK, request("load[1].force", "SF_sliding=1.3", Extreme::Greatest));
    let expected = 0.5 * 4.0 * weight_per_metre / 1.3;
    near(number(&json["found"]["boundary"]), expected);
    let rounded = number(&json["found"]["value"]);
    assert!(rounded <= expected && rounded + step(rounded) > expected, "{rounded}, {expected}");
    // The resultant within a third of the base, F e/(m g) ≤ w/6, or the whole base pressed.
    let expected = (6.0 * 300e3 * 4.0 / weight_per_metre).sqrt();
    near(
        number(&design(BLOCK, request("width", "contact_share=1", Extreme::Least))["found"]["boundary"]),
        expected,
    );
    let json = design(BLOCK, request("load[1].force", "eccentricity=50cm", Extreme::Greatest));
    near(number(&json["found"]["boundary"]), 0.5 * 4.0 * weight_per_metre / 4.0);
    // Above it the largest pressure is (N/w)(1 + 6 e/w), N = ρ g h w.
    let json = design(BLOCK, request("load[1].force", "bearing_max=250kPa", Extreme::Greatest));
    let eccentricity = (250e3 / weight_per_metre - 1.0) * 4.0 / 6.0;
    assert!(eccentricity < 4.0 / 6.0);
    near(number(&json["found"]["boundary"]), eccentricity * 4.0 * weight_per_metre / 4.0);
}

/// The mass that slid as it was printed: 282 200 kg/m, where 282 201 and some were needed.
#[test]
fn what_is_printed_meets_the_target_and_a_digit_less_does_not() {
    let met = |target: &str, answer: &Assessment| match target {
        "rest" => answer.tried().all(|one| one.outcome.full.mode() == Some(standfast::Mode::Rest)),
        "factor=1.2" => sliding(answer) >= 1.2 && overturning(answer) >= 1.2,
        "criteria" => answer.met() == Some(true),
        _ => unreachable!("{target}"),
    };
    let wanted = [
        (BLOCK, "mass", "rest", Extreme::Least),
        (BLOCK, "mass", "factor=1.2", Extreme::Least),
        (FLOOD, "load[1].force", "factor=1.2", Extreme::Greatest),
        (GODA, "width", "factor=1.2", Extreme::Least),
        (GODA, "wave.deep_water_height", "factor=1.2", Extreme::Greatest),
        (GODA, "friction", "rest", Extreme::Least),
        (QUAY, "width", "criteria", Extreme::Least),
        (QUAY, "load[1].force", "criteria", Extreme::Greatest),
        (SEISMIC, "earthquake.horizontal", "rest", Extreme::Greatest),
        (FLOOD, "width", "factor=1.2", Extreme::Least),
    ];
    for (text, name, target, extreme) in wanted {
        let json = design(text, request(name, target, extreme));
        let printed = json["found"]["printed"].as_str().unwrap();
        let rounded = number(&json["found"]["value"]);
        // The printed text, read as the case file would be, is the number beside it.
        let file = file(text);
        let variable = Variable::find(name, file.inputs()).unwrap();
        assert_eq!(variable.read(printed, file.inputs()).unwrap(), rounded, "{printed}");
        let digits = printed.split(' ').next().unwrap().trim_start_matches(['0', '.']).len();
        assert!(digits <= 7, "{printed}");
        assert!(met(target, &with(text, name, rounded).unwrap()), "{name} {printed}, {target}");
        let worse = match extreme {
            Extreme::Least => rounded - step(rounded),
            Extreme::Greatest => rounded + step(rounded),
        };
        assert!(!met(target, &with(text, name, worse).unwrap()), "{name} {worse}, {target}");
        // What is said of the found value is said of the printed one.
        let assessed = with(text, name, rounded).unwrap();
        // But for the last bit, which JSON's reader may lose.
        let said = number(&json["found"]["SF_sliding"]);
        assert!((said / sliding(&assessed) - 1.0).abs() < 1e-15, "{name}: {said}");
    }
}

/// A brim of pressure under the wall: as the force to the right grows it holds the wall against the sea, then pushes it away.
#[test]
fn sets_that_are_no_intervals_are_found_whole() {
    // Pushed left by 200 kN/m for ever; the other force, at the same height, pushes right. Friction holds 240 kN/m either way.
    let text = "[body]\nwidth = 10\nheight = 4\nmass = 48930\nfriction = 0.5\n[[load]]\nforce = 400e3\nelevation = 0.5\n\
        permanent = true\n[[load]]\nforce = 100e3\nelevation = 0.5\ndirection = \"right\"\n";
    let holds = 0.5 * 48930.0 * 9.81;
    let mut one = request("load[2].force", "rest", Extreme::Least);
    (one.from, one.to) = (Some("0".into()), Some("1 MN/m".into()));
    let least = design(text, one.clone());
    near(number(&least["found"]["boundary"]), 400e3 - holds);
    assert_eq!(least["met"].as_array().unwrap().len(), 1);
    near(number(&least["met"][0]["to"]["boundary"]), 400e3 + holds);
    one.extreme = Extreme::Greatest;
    let greatest = design(text, one.clone());
    near(number(&greatest["found"]["boundary"]), 400e3 + holds);
    assert!(greatest["binding"].as_str().unwrap().contains("slides to the right"), "{greatest}");

    // Not to rest in a stretch in between: to slide is to rest neither way, so that a target of sliding is met outside it.
    one.target = "modes_not=[\"RE\"]".parse().unwrap();
    let refused = refusal(text, one.clone());
    assert!(refused.contains("where the range ends"), "{refused}");
    one.extreme = Extreme::Least;
    let refused = refusal(text, one.clone());
    assert!(refused.contains("from 0 N/m, where the range begins, to 159900 N/m"), "{refused}");

    // Every value on a fine grid is met just where the stretches say.
    for (text, name, target, to, extreme) in [
        (text, "load[2].force", "SF_sliding=1.5", "1 MN/m", Extreme::Least),
        (GODA, "wave.period", "SF_sliding=1.1", "20 s", Extreme::Greatest),
        (QUAY, "water.left", "contact_share=0.95", "11 m", Extreme::Least),
    ] {
        let mut asked = request(name, target, extreme);
        (asked.from, asked.to) = (Some("1".into()), Some(to.into()));
        let Target::Criterion(criterion) = asked.target else { panic!("{target}") };
        let json = design(text, asked);
        let met = json["met"].as_array().unwrap();
        let [from, to] = [0, 1].map(|end| number(&json["bracket"][end]));
        for i in 0..=500 {
            let value = from + (to - from) * f64::from(i) / 500.0;
            let listed = met.iter().any(|one| {
                (number(&one["from"]["boundary"])..=number(&one["to"]["boundary"])).contains(&value)
            });
            let found = with(text, name, value)
                .is_some_and(|answer| answer.tried().all(|assessed| Check::of(criterion, assessed).met));
            assert_eq!(found, listed, "{name} {value}");
        }
    }
}

/// A load may stand too far to either side: N e = 500 (x − 3) − 300 × 1 kN, of N = 981 + 500 kN/m.
#[test]
fn both_ends_of_a_stretch_are_found() {
    let text = "[body]\nwidth = 6\nheight = 8\nmass = 1e5\nfriction = 0.6\n\
        [[load]]\nforce = 300e3\nelevation = 1\ntogether = true\n[[load]]\nforce = 500e3\ndirection = \"down\"\ndistance = 3\n\
        together = true\n";
    let mut asked = request("load[2].distance", "eccentricity=0.5 m", Extreme::Least);
    (asked.from, asked.to) = (Some("0".into()), Some("6".into()));
    let json = design(text, asked);
    let (weight, reach) = (1e5 * 9.81 + 500e3, 0.5);
    near(number(&json["met"][0]["from"]["boundary"]), 3.0 + (300e3 - reach * weight) / 500e3);
    near(number(&json["met"][0]["to"]["boundary"]), 3.0 + (300e3 + reach * weight) / 500e3);
}

/// Met, not met, and met again: the body has to move, and its resultant may not be far off. |F − 400| > μ N, and its moment of
/// half that within 0.3 N.
#[test]
fn a_gap_between_two_stretches_is_said() {
    let text = "[body]\nwidth = 10\nheight = 4\nmass = 48930\nfriction = 0.5\n[[load]]\nforce = 400e3\nelevation = 0.5\n\
        permanent = true\n[[load]]\nforce = 100e3\nelevation = 0.5\ndirection = \"right\"\n\
        [criteria]\nmodes_not = [\"RE\"]\neccentricity = 0.3\n";
    let normal = 48930.0 * 9.81;
    let expected = [-0.6, -0.5, 0.5, 0.6].map(|share| 400e3 + share * normal);
    for (extreme, place, words) in [
        (Extreme::Least, 0, "Apart from that the target is met from 640100 N/m to 688000 N/m"),
        (Extreme::Greatest, 3, "Apart from that the target is met from 112000 N/m to 159900 N/m"),
    ] {
        let mut asked = request("load[2].force", "criteria", extreme);
        (asked.from, asked.to) = (Some("0".into()), Some("1 MN/m".into()));
        let json = design(text, asked.clone());
        near(number(&json["found"]["boundary"]), expected[place]);
        let ends = json["met"].as_array().unwrap().iter().flat_map(|one| [&one["from"], &one["to"]]);
        let ends: Vec<f64> = ends.map(|end| number(&end["boundary"])).collect();
        assert_eq!(ends.len(), 4);
        ends.iter().zip(expected).for_each(|(found, expected)| near(*found, expected));
        let file = file(text);
        let text = Design::of(&file, asked, Portion::UNSEEN)
            .unwrap()
            .text(&())
            .replace("\n ", "")
            .replace("  ", " ");
        assert!(text.contains(words), "{text}");
    }
}

#[test]
fn every_refusal_says_why() {
    let least = |vary: &str, target: &str| request(vary, target, Extreme::Least);
    let ranged = |vary: &str, target: &str, from: &str, to: &str| {
        let ends = [from, to].map(|end| (!end.is_empty()).then(|| end.to_owned()));
        let [from, to] = ends;
        DesignRequest { from, to, ..least(vary, target) }
    };
    // Permanent loads only: nothing rises.
    let still = "[body]\nwidth = 4\nheight = 6\nmass = 50e3\nfriction = 0.5\n[water]\nleft = 0\nright = 3\ndensity = 1000\n";
    let refused = refusal(still, least("width", "load_factor=1.2"));
    assert!(
        refused.contains("the target load_factor=1.2 asks how far the variable loads may rise"),
        "{refused}"
    );
    assert!(refusal(BLOCK, least("width", "criteria")).contains("[criteria]"));
    let refused = refusal(BLOCK, least("load[1].force", "rest"));
    assert!(refused.contains("there is no least load[1].force that meets the target rest"), "{refused}");
    assert!(refused.contains("--greatest gives the boundary on the other side, 282500 N/m"), "{refused}");
    let refused = refusal(BLOCK, ranged("width", "rest", "20", "30"));
    assert!(refused.contains("from 20 m to 30 m, in the whole range"), "{refused}");
    // A value that makes no case is the option's, not the file's.
    let refused = refusal(BLOCK, ranged("load[1].elevation", "rest", "7", "8"));
    assert!(
        refused.contains("no load[1].elevation from 7 m to 8 m makes a case; at 7 m: `elevation`"),
        "{refused}"
    );
    assert!(!refused.contains("case.toml"), "{refused}");
    for (vary, from, said) in [
        ("width", "2 kg", "--from is \"2 kg\": the unit `kg` does not fit"),
        ("width", "8,5", "--from is \"8,5\": it has a comma"),
        ("width", "-8", "--from is \"-8\"; expected a finite number above zero, as width has to be"),
        ("friction", "0,5", "--from is \"0,5\": it has a comma"),
        ("friction", "0.5 m", "--from is \"0.5 m\": it is a text"),
        ("mass", "5 kg/m3", "--from is \"5 kg/m3\": the unit `kg/m3` does not fit"),
    ] {
        let refused = refusal(BLOCK, ranged(vary, "rest", from, ""));
        assert!(refused.contains(said), "{refused}");
        assert!(!refused.contains("case.toml"), "{refused}");
    }
    let refused = refusal(SEISMIC, ranged("earthquake.horizontal", "rest", "0.1 gal", ""));
    assert!(refused.contains("as \"0.2 g\": g, m/s2, m/s², cm/s2, Gal or ft/s2"), "{refused}");
    let refused = refusal(SEISMIC, ranged("earthquake.horizontal", "rest", "0.1", ""));
    assert!(refused.contains("it has no unit"), "{refused}");
    assert!(
        refusal(BLOCK, ranged("width", "rest", "9", "8 m")).contains("the range from 9 m to 8 m is empty")
    );
    let refused = refusal(BLOCK, ranged("friction", "SF_overturning_net=9", "", ""));
    assert!(
        refused.contains("friction does not change how far the case is from SF_overturning_net=9"),
        "{refused}"
    );
    assert!(refused.contains("SF_overturning_net is 0.9418, not ≥ 9"), "{refused}");
    let refused = refusal(BLOCK, ranged("width", "bearing_max=1kPa", "", ""));
    assert!(refused.contains("where bearing_max is"), "{refused}");
}

#[test]
fn targets_are_the_criteria_and_a_few_words() {
    let target = |text: &str| text.parse::<Target>();
    for (text, shown) in [
        ("rest", "rest"),
        ("no-rock", "no-rock"),
        ("no-slide", "no-slide"),
        ("criteria", "criteria"),
        ("utilisation=1", "criteria"),
        ("utilisation=0.9", "utilisation=0.9"),
        ("factor=1.20", "factor=1.2"),
        ("load-factor=1.1", "load_factor=1.1"),
        ("load_factor=1.1", "load_factor=1.1"),
        ("SF_sliding = 1.2", "SF_sliding=1.2"),
        ("bearing_max=300kPa", "bearing_max=300 kPa"),
        ("bearing_max=300 kN/m2", "bearing_max=300 kPa"),
        ("bearing_max=300e3", "bearing_max=300 kPa"),
        ("eccentricity=50 cm", "eccentricity=0.5 m"),
        ("contact_share=0.5", "contact_share=0.5"),
        ("modes_not=[\"RO\"]", "modes_not=[\"RO\"]"),
        ("slide = 10cm", "slide=0.1 m"),
        ("max_theta=50 mrad", "max_theta=0.05 rad"),
        ("overturned=false", "overturned=false"),
    ] {
        assert_eq!(target(text).map(|target| target.to_string()).as_deref(), Ok(shown), "{text}");
        assert_eq!(target(shown), target(text));
    }
    let said = |text: &str| {
        target(text).map_or_else(|error: TargetError| error.to_string(), |_| "a target".to_owned())
    };
    for (text, words) in [
        ("safe", "expected rest"),
        ("SF_slidin=1.2", "did you mean SF_sliding?"),
        ("SF_sliding", "SF_sliding needs a value, as in SF_sliding=1.2"),
        ("SF_sliding=", "SF_sliding needs a value"),
        ("factor", "factor needs a value"),
        ("rest=1", "rest takes no value"),
        ("SF_sliding=-1", "expected a finite number above zero"),
        ("factor=0", "expected a finite number above zero"),
        ("factor=1e9", "expected a number below 10000"),
        ("SF_sliding=1,2", "it has a comma"),
        ("bearing_max=300 kN", "the unit `kN` does not fit"),
        ("contact_share=1.2", "a share, above zero and 1 at most"),
        ("slide", "slide needs a value, as in slide=0.10 m"),
        ("slide=-1", "expected a finite number above zero"),
        ("max_theta=3 m", "the unit `m` does not fit"),
        ("overturned=true", "expected false"),
        ("overturnd=false", "did you mean overturned?"),
    ] {
        assert!(said(text).contains(words), "{text}: {}", said(text));
    }
}

/// As in a file: a plain number counts gravity, a unit says so.
#[test]
fn ranges_are_read_as_the_file_is() {
    let bracket = |from: &str, to: &str| {
        let [from, to] = [from, to].map(|end| Some(end.to_owned()));
        let asked = DesignRequest { from, to, ..request("earthquake.horizontal", "rest", Extreme::Greatest) };
        design(SEISMIC, asked)["bracket"].clone()
    };
    let counted = bracket("0.1 g", "0.6 g");
    near(number(&counted[0]), 0.1 * 9.81);
    assert_eq!(counted, bracket("0.1g", "0.6g"));
    assert_eq!(counted, bracket("\"0.1 g\"", "5.886 m/s2"));
}

#[test]
fn a_body_that_moves_though_the_target_is_met_is_named() {
    // As wide as it is it slides at μ m g/F = 58 % of the load, and is too low to turn.
    let text = "[body]\nwidth = 6\nheight = 2\nmass = 30e3\nfriction = 0.2\n[[load]]\nforce = 101.483e3\nelevation = 1\n";
    let narrow = DesignRequest { from: Some("10 cm".into()), ..request("width", "no-rock", Extreme::Least) };
    let json = design(text, narrow);
    let warnings: Vec<_> =
        json["warnings"].as_array().unwrap().iter().map(|one| one.as_str().unwrap()).collect();
    let moves = "the target is met, but not by a body at rest: from";
    assert!(
        warnings.iter().any(|one| one.starts_with(moves) && one.contains("slides to the left")),
        "{warnings:?}"
    );
    let rests = design(BLOCK, request("width", "rest", Extreme::Least));
    assert_eq!(rests["warnings"].as_array().unwrap().len(), 0, "{rests}");
}

/// Of two combinations nothing rises in the one.
#[test]
fn where_nothing_rises_a_load_factor_says_nothing() {
    let text = BLOCK.replace("[[load]]", "[[load]]\nname = \"push\"")
        + "[[combination]]\nname = \"storm\"\nfactors = { push = 1 }\n[[combination]]\nname = \"calm\"\nfactors = { weight = 1 }\n";
    let json = design(&text, request("width", "load_factor=1.3", Extreme::Least));
    let warnings = json["warnings"].as_array().unwrap();
    let expected = "in calm no variable load acts: there the target is met by rest";
    assert_eq!(warnings.iter().filter_map(Value::as_str).collect::<Vec<_>>(), [expected]);
}

fn boundary(text: &str, asked: DesignRequest, and: &str, from: &str, to: &str) -> (Value, String, String) {
    let file = file(text);
    let [from, to] = [from, to].map(|end| (!end.is_empty()).then(|| end.to_owned()));
    let request = BoundaryRequest { design: asked, and: and.to_owned(), from, to };
    let boundary =
        DesignBoundary::of(&file, request, Portion::UNSEEN).map_err(|error| report(&error)).unwrap();
    let figure =
        boundary.figures(&()).unwrap().pop().map_or(String::new(), |drawn| drawn.figure.caption().to_owned());
    (serde_json::from_str(&boundary.json(&(), &[])).unwrap(), boundary_csv(&boundary), figure)
}

/// Width over friction of the dry block: w = 1.3 F/(μ ρ g h) while it slides, then what keeps it from turning. Each row of the
/// CSV is proven by assessing it, and fails with a digit less.
#[test]
fn the_boundary_of_two_quantities_is_proven_row_by_row() {
    let (json, csv, caption) =
        boundary(BLOCK, request("width", "factor=1.3", Extreme::Least), "friction", "", "");
    let weight_per_metre: f64 = 6.0 * 2400.0 * 9.81;
    let turns = (1.3 * 2.0 * 300e3 * 4.0 / weight_per_metre).sqrt();
    for column in json["columns"].as_array().unwrap() {
        let friction = number(&column["value"]);
        let expected = (1.3 * 300e3 / (friction * weight_per_metre)).max(turns);
        near(number(&column["met"][0]["from"]["boundary"]), expected);
    }
    assert!(caption.contains("Along the boundary: overturning, sliding."), "{caption}");
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("body.friction,body.width,binding,until,until_binding"));
    let file = file(BLOCK);
    let case = file.case().unwrap();
    let mut rows = 0;
    for line in lines {
        let cells: Vec<_> = line.split(',').collect();
        let [friction, width] = [0, 1].map(|cell| cells[cell].parse::<f64>().unwrap());
        let met = |width: f64| {
            let mut inputs = file.inputs().clone();
            inputs.set(Key::Friction, friction);
            inputs.set(Key::Width, width);
            let answer = Assessment::of(&Case::of(&inputs).unwrap()).unwrap();
            sliding(&answer) >= 1.3 && overturning(&answer) >= 1.3
        };
        assert!(met(width) && !met(width - step(width)), "{line}");
        let slides = friction < 1.3 * 300e3 / (turns * weight_per_metre);
        assert_eq!(cells[2], if slides { "sliding" } else { "overturning" }, "{line}");
        rows += 1;
    }
    assert!(rows > 40 && case.friction == 0.5, "{rows}");
}

/// Shaken by more than the friction holds, no height is low enough: rows without a value, and the set ends at a_h = μ g.
#[test]
fn where_nothing_meets_the_target_there_is_a_gap() {
    let text = SEISMIC.replace("vertical = \"-0.1 g\"", "vertical = 0");
    let asked = request("height", "factor=1", Extreme::Greatest);
    let (json, csv, caption) = boundary(&text, asked, "earthquake.horizontal", "0.2 g", "0.8 g");
    let limit = 0.5 * 9.81;
    for column in json["columns"].as_array().unwrap() {
        let (at, met) = (number(&column["value"]), column["met"].as_array().unwrap());
        assert_eq!(met.is_empty(), at > limit, "{column}");
        assert_eq!(column["binds"].as_str(), met.is_empty().then_some("sliding"));
        if at < limit {
            // g w/(a_h h) = 1.
            near(number(&met[0]["to"]["boundary"]), 8.0 * 9.81 / at);
        }
    }
    // The end is searched to four digits.
    let values: Vec<f64> =
        json["columns"].as_array().unwrap().iter().map(|one| number(&one["value"])).collect();
    let beyond = values.iter().position(|at| *at > limit).unwrap();
    assert!(values[beyond] - values[beyond - 1] < 0.002, "{:?}", &values[beyond - 1..=beyond]);
    assert!(csv.contains(",,sliding,,\n"), "{csv}");
    assert!(caption.contains("Along the boundary: overturning") && caption.contains("sliding."), "{caption}");
}

/// Mass and width both named: the mass is what it is said to be, though the file gives a density.
#[test]
fn a_mass_stays_what_it_is_as_the_width_is_changed() {
    let (json, ..) = boundary(BLOCK, request("mass", "SF_sliding=1.2", Extreme::Least), "width", "", "");
    for column in json["columns"].as_array().unwrap() {
        near(number(&column["met"][0]["from"]["boundary"]), 1.2 * 300e3 / (0.5 * 9.81));
    }
}

#[test]
fn refusals_of_two_quantities() {
    let refused = |vary: &str, target: &str, and: &str, from: Option<&str>| {
        let file = file(BLOCK);
        let from = from.map(str::to_owned);
        let design = request(vary, target, Extreme::Least);
        let request = BoundaryRequest { design, and: and.to_owned(), from, to: None };
        match DesignBoundary::of(&file, request, Portion::UNSEEN) {
            Ok(boundary) => boundary.text(&()),
            Err(error) => report(&error).split_whitespace().collect::<Vec<_>>().join(" "),
        }
    };
    assert!(refused("width", "rest", "body.width", None).contains("the same number, body.width"));
    assert!(refused("width", "rest", "frictio", None).contains("did you mean `friction`?"));
    assert!(refused("width", "rest", "friction", Some("0.5 m")).contains("--and-from is \"0.5 m\""));
    assert!(refused("width", "rest", "friction", Some("9")).contains("--and-from and --and-to"));
    let said = refused("height", "SF_overturning_net=9", "friction", None);
    assert!(said.contains("whatever friction is from 0.25 to 1, the target is not met; at 0.5: "), "{said}");
}

/// Written in whatever unit, a number is found alike, told in that unit, and read back from it as what was assessed. In g it is rounded in g.
#[test]
fn a_number_found_has_the_unit_of_the_file() {
    for (written, unit, told) in [
        ("300e3", "N/m", "300000 N/m"),
        ("\"300 kN/m\"", "kN/m", "300 kN/m"),
        ("\"0.3 MN/m\"", "MN/m", "0.3 MN/m"),
    ] {
        let file = file(&BLOCK.replace("300e3", written));
        let found =
            Design::of(&file, request("load[1].force", "SF_sliding=1.2", Extreme::Greatest), Portion::UNSEEN);
        let found = found.unwrap();
        // μ m g/(1.2 F), to four digits below.
        let exact: f64 = 0.5 * 4.0 * 6.0 * 2400.0 * 9.81 / 1.2;
        let text = &found.found().text;
        assert_eq!(text.split_once(' ').unwrap().1, unit);
        let read = found.quantity.variable.read(text, file.inputs()).unwrap();
        assert_eq!(read, found.found().rounded);
        assert!(read <= exact && exact - read < 1e-3 * exact, "{text} {exact}");
        assert_eq!(found.quantity.shown(found.quantity.present), told);
    }
    let shaken = "[body]\nwidth = 4\nheight = 6\ndensity = 2400\nfriction = 0.3\n[earthquake]\nhorizontal = \"0.1 g\"\n";
    let found = Design::of(
        &file(shaken),
        request("earthquake.horizontal", "SF_sliding=1.3", Extreme::Greatest),
        Portion::UNSEEN,
    );
    // 0.3/1.3 = 0.230769.
    assert_eq!(found.unwrap().found().text, "0.2307 g");
}
