//! Storms in parts, under a combination, and on a base that gives way: against storms of their own, whose means add up.

use standfast_cases::random::{ChanceRequest, Effort, Probability, ProbabilityError, Sliding};
use standfast_cases::{CaseFile, Document};

/// The example with a storm each year, and other lines in its tables; fewer years, as means are in proportion to them.
fn storm(in_storm: &str, changed: impl Fn(String) -> String) -> String {
    let text = std::fs::read_to_string("../../examples/goda-2000-storm.toml").unwrap();
    changed(text)
        .replace("tau0 = \"1.5 s\"", &format!("tau0 = \"1.5 s\"\n{in_storm}"))
        .replace("years = 50", "years = 5")
}

/// With as few lives as tell a share: means are integrated.
fn answer(text: &str) -> Result<Probability, ProbabilityError> {
    let effort = Effort { precision: 0.2, points: 1 << 16, ..Effort::default() };
    let file = CaseFile::parse("case.toml", text)?;
    Probability::of(&file, ChanceRequest { effort, ..ChanceRequest::default() })
}

fn slides(text: &str) -> Sliding {
    answer(text).unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error))).sliding.unwrap()
}

fn plain(text: String) -> String {
    text
}

/// A sea of every height times a factor.
fn lower(factor: f64) -> impl Fn(String) -> String {
    move |text| {
        let law =
            |f: f64| format!("mean = \"{} m\", sd = \"{} m\" }}, lower = \"{} m\"", 4.5 * f, 0.9 * f, f);
        let lowered = text.replace(&law(1.0), &law(factor));
        assert!(factor == 1.0 || lowered != text);
        lowered
    }
}

/// Water half a metre higher, by the depths that go with it and by the weight that it takes.
fn higher(text: String) -> String {
    let mut text = text;
    for (one, other) in [
        ("water_depth = \"10.1 m\"", "water_depth = \"10.6 m\""),
        ("depth_above_berm = \"5.6 m\"", "depth_above_berm = \"6.1 m\""),
        ("base_depth = \"7.1 m\"", "base_depth = \"7.6 m\""),
        ("crest_height = \"3.4 m\"", "crest_height = \"2.9 m\""),
        ("buoyant_weight = \"2318.64 kN/m\"", "buoyant_weight = \"2242.8542 kN/m\""),
    ] {
        assert!(text.contains(one), "{one}");
        text = text.replace(one, other);
    }
    text
}

/// As equal parts of one storm, heights and levels have the mean of storms that are all one of them.
#[test]
fn a_storm_in_parts_has_the_mean_of_its_parts() {
    let whole = slides(&storm("height_factors = [0.7, 1, 0.85]\nlevel_rises = [0, \"0.5 m\", 0]\n", plain));
    let alone = [slides(&storm("", lower(0.7))), slides(&storm("", higher)), slides(&storm("", lower(0.85)))];
    let mean = |of: &dyn Fn(&Sliding) -> f64| alone.iter().map(of).sum::<f64>() / 3.0;
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 5e-3, "{a} {b}");
    near(whole.mean.value, mean(&|one| one.mean.value));
    near(whole.waves.value, mean(&|one| one.waves.value));
    // The lives that are drawn have the mean that is integrated, and words for the storm.
    let e = whole.drawn;
    assert!((e.value - whole.mean.value).abs() < 1.5 * (e.high - e.low), "{e:?} {:?}", whole.mean);
    assert_eq!(whole.storm_words(), "a storm of 947 waves each, in 3 equal parts");
    // A peak that lasts is no part at all.
    let peak = slides(&storm("height_factors = [1, 1]\n", plain));
    assert_eq!(peak.mean.value, slides(&storm("", plain)).mean.value);
}

/// Under a combination the waves' forces are its factors times theirs; other combinations have no part.
#[test]
fn the_waves_of_a_storm_come_under_one_combination() {
    let combinations = "[[combination]]\nname = \"A\"\nfactors = { wave = 1.2 }\n[[combination]]\nname = \"B\"\nfactors = { wave = 1 }\n";
    let under = |name: &str| storm(&format!("combination = \"{name}\"\n"), plain) + combinations;
    let plain_mean = slides(&storm("", plain)).mean.value;
    assert!((slides(&under("B")).mean.value / plain_mean - 1.0).abs() < 1e-12);
    let biased = |text: String| {
        text.replace("mean = 0.91, cov", "mean = 1.092, cov").replace("mean = 0.77, cov", "mean = 0.924, cov")
    };
    let found = slides(&under("A"));
    assert!(
        (found.mean.value / slides(&storm("", biased)).mean.value - 1.0).abs() < 3e-3,
        "{:?}",
        found.mean
    );
    assert_eq!(found.storm_words(), "a storm of 947 waves each, under A");
    for (text, expected) in [
        (storm("", plain) + combinations, "leaves a choice of loads; its combinations are A, B"),
        (under("C"), "`combination` of [storm] is \"C\"; its combinations are A, B"),
        (storm("combination = \"A\"\n", plain), "is \"A\", and the case has none"),
        (under("A").replace("wave = 1.2 }", "wave = 1.2 }\neffects = true"), "its factors act on effects"),
        (storm("height_factors = [0.5, 0.9]\n", plain), "the largest of them 1, which is the peak"),
        (storm("height_factors = [1, 0]\n", plain), "expected factors above 0"),
        (
            storm("height_factors = [1, 0.5]\nlevel_rises = [0]\n", plain),
            "2 height_factors and 1 level_rises",
        ),
        (
            storm("level_rises = [0, \"0.5 m\"]\ncombination = \"A\"\n", plain)
                + "[[combination]]\nname = \"A\"\nfactors = { wave = 1 }\nset = { water_level = \"7 m\" }\n",
            "its combination sets `water_level`",
        ),
        (
            storm("level_rises = [0, \"0.5 m\"]\n", plain) + "wave.base_depth = { normal = { sd = 0.1 } }\n",
            "`wave.base_depth` is random: make `water_level` random in its place",
        ),
        (storm("level_rises = [0, \"-9 m\"]\n", plain), "part 2 of [storm]"),
        (
            storm("", plain).replace("friction = 0.6\n", "friction = 0.6\nadhesion = \"20 kPa\"\n"),
            "`adhesion` is not for storms",
        ),
    ] {
        let error = answer(&text).expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}");
    }
}

/// On stone that nothing crushes slides are those on a rigid base; on sand that fails, waves under which it does are told apart.
#[test]
fn slides_on_a_base_that_gives_way() {
    let rigid = slides(&storm("", plain));
    let stone = slides(&(storm("", plain) + "[ground]\nstrength = \"900 MPa\"\n"));
    assert!((stone.mean.value / rigid.mean.value - 1.0).abs() < 1e-6, "{:?} {:?}", stone.mean, rigid.mean);
    let sand = "[ground]\nfriction_angle_deg = 40\nunit_weight = \"10 kN/m3\"\nlaw = \"ec7\"\n";
    let text = storm("", plain) + sand;
    let found = answer(&text).unwrap();
    let sand = found.sliding.as_ref().unwrap();
    assert!(
        sand.mean.value < rigid.mean.value && sand.mean.value > 0.5 * rigid.mean.value,
        "{:?}",
        sand.mean
    );
    assert!(sand.rotating.wave.value > 0.0);
    // Few lives have such a wave; on weaker sand many, and a mean that leaves them out is warned of.
    let warned =
        |found: &Probability| found.warnings().iter().any(|warning| warning.name() == "waves-left-out");
    assert_eq!(warned(&found), sand.rotating.life.value > 0.01);
    let weaker = answer(&text.replace("friction_angle_deg = 40", "friction_angle_deg = 34")).unwrap();
    assert!(weaker.sliding.as_ref().unwrap().rotating.life.value > 0.01 && warned(&weaker));
    // What slides on sand, and what it fails under, is no less than what slides on rock.
    let moved = sand.waves.value + 5.0 * 947.0 * sand.rotating.wave.value;
    assert!(moved > rigid.waves.value && moved < 1.6 * rigid.waves.value, "{moved} {:?}", rigid.waves);
    let words = found.text(&()).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("Waves that begin a rotation, or under which the base gives way, are left out"),
        "{words}"
    );
}
