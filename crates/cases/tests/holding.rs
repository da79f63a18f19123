//! Adhesion, couples, ties and passive soil, from the text of a case to its answer.

mod common;

use common::{assess, file, number, refused, six};
use standfast::{Mode, Verdict};
use standfast_cases::results::ResultName;

const BLOCK: &str = "[body]\nwidth = 6\nheight = 10\nmass = 122324.16\nfriction = 0.5\n";
const PUSH: &str = "[[load]]\nname = \"push\"\nforce = \"620 kN/m\"\nelevation = 7\n";
const TIE: &str =
    "[[resistance]]\nname = \"tie\"\nlimit = \"150 kN/m\"\ndirection = \"right\"\nelevation = 9\n";

fn names(text: &str) -> Vec<&'static str> {
    let case = file(text).case().unwrap();
    case.warnings().iter().map(|warning| warning.name()).collect()
}

#[test]
fn a_tie_holds_as_far_as_rest_needs_it() {
    let assessment = assess(&format!("{BLOCK}{PUSH}{TIE}"));
    let one = assessment.governing();
    assert_eq!(one.verdict(), Some(Verdict::REST));
    let held = one.outcome.held.unwrap();
    six(held.needed.unwrap()[0], 82222.2);
    six(number(one, ResultName::LoadFactor), 1.14055);
    six(number(one, ResultName::SfSliding), 750.0 / 620.0);
    six(number(one, ResultName::SfOverturningNet), 4950.0 / 4340.0);
    // A share, and a divisor of a combination.
    let half = assess(&format!("{BLOCK}{PUSH}{TIE}share = 0.5\n"));
    assert_ne!(half.governing().verdict(), Some(Verdict::REST));
    let combined = format!(
        "{BLOCK}{PUSH}{TIE}[[combination]]\nname = \"c\"\nfactors = {{ push = 1 }}\nresist = {{ tie = 1.5 }}\n"
    );
    six(number(assess(&combined).governing(), ResultName::LoadFactor), (3600.0 + 100.0 * 9.0) / 4340.0);
}

#[test]
fn adhesion_holds_the_resultant_s_part_of_the_base() {
    let dam = |adhesion: &str| {
        format!(
            "[body]\nwidth = 10\nheight = 8\nmass = 152905.1987767584\nfriction = 0.6\n{adhesion}[[load]]\nname = \"push\"\n\
             force = 1100e3\nelevation = 3.5454545454545454\n"
        )
    };
    let pressed = assess(&dam("adhesion = \"150 kPa\"\n"));
    six(number(pressed.governing(), ResultName::SfSliding), 1.8);
    six(pressed.governing().outcome.held.unwrap().adhering, 7.2);
    let effective = assess(&dam("adhesion = \"150 kPa\"\nadhesion_on = \"effective\"\n"));
    six(number(effective.governing(), ResultName::SfSliding), 1.47273);
    assert_eq!(names(&dam("adhesion = \"150 kPa\"\n")), ["adhesion-carries"]);
    assert_eq!(names(&dam("adhesion = \"50 kPa\"\n")), [""; 0]);
    // A code's factor on cohesion takes it too, resist = sliding both.
    let combined = |more: &str| {
        let text = dam("adhesion = \"150 kPa\"\n");
        assess(&format!("{text}[[combination]]\nname = \"c\"\n{more}"))
    };
    let da2 = combined("factors = { push = 1 }\nresist = { sliding = 1.1 }\n");
    six(number(da2.governing(), ResultName::SfSliding), 1.8 / 1.1);
    let da1 = combined("code = \"EN1997-DA1-2\"\nfactors = { push = 1, weight = 1 }\n");
    six(number(da1.governing(), ResultName::SfSliding), 1.8 / 1.25);
    let alone = refused(&dam("adhesion_on = \"effective\"\n"));
    assert!(alone.contains("[body] lacks `adhesion`"), "{alone}");
}

/// 4 × 6 m of 500 kN/m, 40 at 7.2 m over a lever, and a couple of 120: t_e = (1000 − 288 − 120)/500.
#[test]
fn a_couple_turns_the_body() {
    let text = "[body]\nwidth = 4\nheight = 6\nmass = 50968.39959225280\nfriction = 0.6\n[[load]]\nname = \"bollard\"\nforce = 40e3\n\
                elevation = 7.2\nlever = \"bollard hook\"\ntogether = true\n[[moment]]\nname = \"gate\"\nmoment = \"120 kN m/m\"\ntogether = true\n";
    let assessment = assess(text);
    six(assessment.governing().outcome.stability.resultant_arm.unwrap(), 1.184);
    let right = assess(
        &text.replace("together = true\n[[moment]]", "together = true\n[[moment]]\ndirection = \"right\""),
    );
    six(right.governing().outcome.stability.resultant_arm.unwrap(), (1000.0 - 288.0 + 120.0) / 500.0);
    // Alone it is an alternative; a combination names it.
    let alone = assess(
        &text
            .replace("together = true\n[[moment]]", "[[moment]]")
            .replace("120 kN m/m\"\ntogether = true", "120 kN m/m\""),
    );
    assert_eq!(alone.all.len(), 2);
    assert_eq!(alone.name(&alone.all[1]).as_deref(), Some("gate"));
    let named = format!("{text}[[combination]]\nname = \"c\"\nfactors = {{ gate = 1.5 }}\n");
    six(assess(&named).governing().outcome.stability.resultant_arm.unwrap(), (1000.0 - 180.0) / 500.0);
}

/// A wall with a fill before its toe; K_p 33° is 3.39213, half of ½ · 3.39213 · 19 · 1.5² counts.
#[test]
fn a_passive_soil_resists() {
    let wall = |more: &str| {
        format!(
            "[body]\nwidth = 4\nheight = 6\ndensity = 2400\nfriction = 0.45\n[[load]]\nname = \"push\"\nforce = 150e3\nelevation = 2\n\
             [[backfill]]\nname = \"toe fill\"\nface = \"left\"\ntop = 1.5\nstate = \"passive\"\nfriction_angle_deg = 33\nunit_weight = 19e3\n{more}"
        )
    };
    let text = wall("share = 0.5\n");
    let assessment = assess(&text);
    let one = assessment.governing();
    let k = (45.0_f64 + 16.5).to_radians().tan().powi(2);
    let resists = 0.5 * 0.5 * k * 19e3 * 2.25;
    six(one.outcome.held.unwrap().against, resists);
    six(number(one, ResultName::SfSliding), (0.45 * 4.0 * 6.0 * 2400.0 * 9.81 + resists) / 150e3);
    assert!(names(&text).contains(&"passive-with-low-factor"));
    let with_wall = assess(&wall("share = 1\nwall_friction_deg = 22\n"));
    let k = k.powf(1.0 + 1.443 * (2.0 / 3.0) * 33.0_f64.to_radians().sin());
    six(with_wall.governing().outcome.held.unwrap().against, 0.5 * k * 19e3 * 2.25);
    for (more, words) in [
        ("", "lacks `share`"),
        ("share = 0.5\nslope_deg = 5\n", "`slope_deg` of toe fill does not go with"),
        ("share = 0.5\nsurcharge = 10e3\n", "`surcharge` of toe fill does not go with"),
    ] {
        let error = refused(&wall(more));
        assert!(error.contains(words), "{error}");
    }
    let active = refused(&wall("share = 0.5\n").replace("state = \"passive\"\n", ""));
    assert!(active.contains("`share` of toe fill goes with"), "{active}");
    // Nowhere among factors; by its name or as passive among resistances.
    let combined = |factors: &str, resist: &str| {
        format!(
            "{}[[combination]]\nname = \"c\"\nfactors = {{ push = 1{factors} }}\nresist = {{ {resist} }}\n",
            wall("share = 0.5\n")
        )
    };
    assert!(refused(&combined(", \"toe fill\" = 1", "passive = 1.4")).contains("toe fill"));
    for name in ["passive", "\"toe fill\""] {
        let assessment = assess(&combined("", &format!("{name} = 1.4")));
        six(assessment.governing().outcome.held.unwrap().against, resists / 1.4);
    }
    // UFC asks for more where it counts.
    let ufc = format!("{}[[combination]]\nname = \"c\"\ncode = \"UFC-3-220-20\"\n", wall("share = 0.5\n"));
    let assessment = assess(&ufc);
    let checks = assessment.checks_in(assessment.governing());
    let sliding = checks.iter().find(|check| check.name() == "SF_sliding").unwrap();
    assert_eq!(sliding.cells()[0], "≥ 2");
}

#[test]
fn what_has_no_place_for_them_refuses_them_by_name() {
    let tied = format!("{BLOCK}{PUSH}{TIE}");
    for (text, words) in [
        (
            format!("{tied}[ground]\nstrength = \"500 kPa\"\n"),
            "the resistance \"tie\" is not for a body on [ground]",
        ),
        (
            format!("{BLOCK}adhesion = 1e3\n{PUSH}[ground]\nstrength = \"900 kPa\"\n"),
            "`adhesion` is not for a base that crushes",
        ),
        (
            format!("{BLOCK}shape = \"cylinder\"\nadhesion = 1e3\n{}", PUSH.replace("kN/m", "kN")),
            "`adhesion` is not for a cylinder",
        ),
        (
            format!("{BLOCK}{PUSH}history = {{ shape = \"constant\" }}\n{TIE}"),
            "is not for a body that is followed in time",
        ),
        (
            format!("{BLOCK}{PUSH}history = {{ shape = \"constant\" }}\n[[moment]]\nmoment = 1\n"),
            "a [[moment]] is not for a body that is followed in time",
        ),
        (format!("{tied}{TIE}"), "two resistances are called tie"),
        (
            format!("{BLOCK}adhesion = 1e3\n{PUSH}{TIE}{}", TIE.replace("\"tie\"", "\"anchor\"")),
            "\"anchor\" is not for a body that adheres",
        ),
        (tied.replace("\"tie\"", "\"push\""), "push"),
        (tied.replace("elevation = 9", "elevation = 11"), "`elevation`"),
        (tied.replace("direction = \"right\"\n", ""), "[[resistance]] lacks `direction`"),
        (tied.replace("direction = \"right\"", "direction = \"down\""), "[[resistance]] lacks `distance`"),
    ] {
        let error = refused(&text);
        assert!(error.contains(words), "{error}\n{text}");
    }
}

/// A rack that two ties and a weight at its foot hold: rest asks for the least of all, and no more.
#[test]
fn several_resistances_share() {
    let more =
        "[[resistance]]\nname = \"anchor\"\nlimit = \"100 kN/m\"\ndirection = \"down\"\ndistance = 5.5\n";
    let assessment = assess(&format!("{BLOCK}{PUSH}{TIE}{more}"));
    let one = assessment.governing();
    assert_eq!(one.mode(), Some(Mode::Rest));
    let needed = one.outcome.held.unwrap().needed.unwrap();
    six(needed[0] * 9.0 + needed[1] * 5.5, 740e3);
    six(
        number(one, ResultName::LoadFactor),
        (600.0_f64 + 50.0 + 150.0).min((3600.0 + 1350.0 + 550.0) / 7.0) / 620.0,
    );
}

/// A tie counts in full before rest needs it and after, so nothing jumps where rest begins to need it.
#[test]
fn factors_and_pressure_go_on_where_rest_begins_to_need_a_tie() {
    let held = |force: f64, limit: f64| {
        let text = format!(
            "[body]\nwidth = 4\nheight = 8\nmass = 80e3\nfriction = 0.7\n[[load]]\nname = \"rope\"\nforce = {force}\nelevation = 8\n\
             [[resistance]]\nname = \"tie\"\nlimit = {limit}\ndirection = \"right\"\nelevation = 8\n"
        );
        let assessment = assess(&text);
        let one = assessment.governing();
        let needed = one.outcome.held.unwrap().needed.unwrap()[0];
        (needed, number(one, ResultName::SfOverturningNet), number(one, ResultName::BearingMax))
    };
    // 80 t · 9.81 · 2 m over 8 m is 196.2 kN/m.
    let (before, after) = (held(196.1e3, 150e3), held(196.3e3, 150e3));
    assert_eq!(before.0, 0.0);
    six(after.0, 0.1e3);
    six(before.1, (196.2 + 150.0) / 196.1);
    six(after.1, (196.2 + 150.0) / 196.3);
    let step = |one: f64, two: f64| (one - two).abs() / one;
    assert!(step(before.2, after.2) < 0.01, "{before:?} {after:?}");
    // t_e = 2 − (196.3 − 150) 8/784.8 m, where all of it is less than the middle asks for.
    let off = (196.3 - 150.0) * 8.0 / 784.8;
    six(after.2, 784.8e3 / 4.0 * (1.0 + 6.0 * off / 4.0));
    // A stronger tie brings the resultant to the middle, and not beyond.
    six(held(196.3e3, 1500e3).2, 784.8e3 / 4.0);
}

/// Anchors are among what acts down, and divided as UPL divides them; a tie among what holds against tipping.
#[test]
fn resistances_count_against_uplift_and_tipping() {
    let body = "[body]\nwidth = 10\nheight = 5\ndensity = 1200\nfriction = 0.5\n[water]\nlevel = 4.8\ndensity = 1000\n[uplift]\nright = 20e3\nleft = 20e3\n";
    let anchors = "[[resistance]]\nname = \"anchors\"\nlimit = 280e3\ndirection = \"down\"\ndistance = 5\n";
    let weight = 1200.0 * 50.0 * 9.81;
    let up = 4.8 * 10.0 * 9810.0 + 200e3;
    let uplift = |text: &str| number(assess(text).governing(), ResultName::SfUplift);
    six(uplift(&format!("{body}{anchors}[criteria]\nSF_uplift = 1\n")), (weight + 280e3) / up);
    assert!(!names(&format!("{body}{anchors}")).contains(&"adhesion-carries"));
    let by_code = format!("{body}{anchors}[[combination]]\nname = \"UPL\"\ncode = \"EN1997-UPL\"\n");
    six(uplift(&by_code), (0.9 * weight + 200e3) / up);
    let pushed = "[body]\nwidth = 2\nheight = 6\nmass = 24e3\nfriction = 0.7\n[[load]]\nname = \"push\"\nforce = 100e3\nelevation = 4\n\
                  [[resistance]]\nname = \"tie\"\nlimit = 60e3\ndirection = \"right\"\nelevation = 5\n[criteria]\ntipping = 1\n";
    let assessment = assess(pushed);
    let one = assessment.governing();
    let holds = 24e3 * 9.81 + 60e3 * 5.0;
    six(number(one, ResultName::Tipping), 400e3 / holds);
    six(number(one, ResultName::SfOverturningNet), holds / 400e3);
}

/// A number without its unit that can only be meant in thousands is warned of, in each table that has such.
#[test]
fn bare_numbers_are_warned_of() {
    let soil = "[[backfill]]\nname = \"sand\"\nface = \"right\"\nfriction_angle_deg = 30\nunit_weight = 18\n";
    assert_eq!(names(&format!("{BLOCK}{soil}")), ["unusual-ground"]);
    assert_eq!(names(&format!("{BLOCK}{}", soil.replace("= 18", "= 18e3"))), [""; 0]);
    let cohesive = soil.replace("= 18", "= 18e3\ncohesion = 5");
    assert_eq!(names(&format!("{BLOCK}{cohesive}")), ["small-pressure"]);
    let couple = "[[moment]]\nname = \"gate\"\nmoment = 150\n";
    assert_eq!(names(&format!("{BLOCK}{couple}")), ["small-force"]);
    assert_eq!(names(&format!("{BLOCK}{}", couple.replace("150", "150e3"))), [""; 0]);
    assert_eq!(names(&format!("{BLOCK}{PUSH}{}", TIE.replace("\"150 kN/m\"", "150"))), ["small-force"]);
    let adhesive = BLOCK.replace("friction = 0.5", "friction = 0.5\nadhesion = 20");
    assert_eq!(names(&format!("{adhesive}{PUSH}")), ["small-pressure"]);
}
