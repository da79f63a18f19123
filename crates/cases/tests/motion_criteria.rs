//! Criteria on a motion, and designs for it: against closed forms, and against cases written out and read again.

use standfast_cases::design::{Design, DesignRequest, Extreme, Spelling};
use standfast_cases::motion::{Follow, FollowedMotion};
use standfast_cases::{Acting, Assessment, AssessmentView, CaseFile, Document, Portion};

const CAISSON: &str = include_str!("../../../examples/motion/caisson-breaking-wave.toml");

fn no_file(file: &str) -> Result<String, String> {
    Err(format!("no file {file}"))
}

fn follow(text: &str) -> Result<Vec<FollowedMotion>, String> {
    let file = CaseFile::read("case.toml", text, &no_file).map_err(|error| error.to_string())?;
    FollowedMotion::of_file(&file, &Follow::default()).map_err(|error| error.to_string())
}

/// Name, value, and whether it is met, of the first situation.
fn checks(text: &str) -> Vec<(&'static str, String, bool)> {
    let answers = follow(text).unwrap();
    let followed = &answers[0];
    let checks = followed.checks().into_iter();
    checks.map(|check| (check.criterion.name(), check.value_words(), check.met)).collect()
}

/// A block that a rectangle of thrust k₀ and duration T slides: s = (k₀ − μ) k₀ T²/(2μ), with g = 1.
#[test]
fn a_bound_is_met_up_to_itself() {
    let (k, μ, t) = (0.6, 0.4, 1.0_f64);
    let slide = (k - μ) * k * t * t / (2.0 * μ);
    let text = |criteria: &str| {
        format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 0.5\nmu_s = {μ}\ngravity = 1\n[motion.base]\n\
             horizontal = {{ shape = \"rect\", peak = {k}, duration = {t} }}\n[criteria]\n{criteria}\n"
        )
    };
    for (factor, met) in [(1.0 - 1e-12, false), (1.0 + 1e-12, true), (0.5, false), (2.0, true)] {
        let found = checks(&text(&format!("slide = {}", slide * factor)));
        assert_eq!((found[0].0, found[0].2), ("slide", met), "{factor}");
    }
    // The governing one first, whichever side it slides to.
    let found = checks(&text(&format!("overturned = false\nmax_theta = 0.1\nslide = {}", slide / 2.0)));
    assert_eq!(found.iter().map(|check| check.0).collect::<Vec<_>>(), ["slide", "max_theta", "overturned"]);
    let mirrored = text(&format!("slide = {}", slide / 2.0)).replace("peak = 0.6", "peak = -0.6");
    assert_eq!(checks(&mirrored), [found[0].clone()]);
    assert_eq!(checks(&text("")), []);
}

/// Of a body that overturns, or still moves when the time is up, no bound is met that nobody knows to be met.
#[test]
fn what_is_not_known_is_not_met() {
    let text = |peak: f64, t_max: f64| {
        format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 5\ngravity = 1\n[motion]\nt_max = {t_max}\n[motion.base]\n\
             horizontal = {{ shape = \"rect\", peak = {peak}, duration = 3 }}\n\
             [criteria]\noverturned = false\nmax_theta = 1\nslide = 9\n"
        )
    };
    // Twice what tips it; for so long that it goes over; then for a moment only.
    let over = checks(&text(0.7, 400.0));
    let of = |checks: &[(&str, String, bool)], name: &str| {
        let found = checks.iter().find(|check| check.0 == name).unwrap();
        (found.1.clone(), found.2)
    };
    assert_eq!(of(&over, "overturned"), ("yes".to_owned(), false));
    assert_eq!(of(&over, "slide"), ("none: the body overturns".to_owned(), false));
    assert!(!of(&over, "max_theta").1);
    let cut = checks(&text(0.7, 0.5));
    assert!(cut.iter().all(|(_, value, met)| !met && value.starts_with("not known")), "{cut:?}");
    assert!(checks(&text(0.2, 400.0)).iter().all(|check| check.2));
}

#[test]
fn criteria_of_the_motion_stand_beside_the_others_in_every_spelling() {
    let plain =
        format!("{CAISSON}\n[criteria]\nSF_sliding = 0.5\nslide = \"8 cm\"\nmax_theta = \"50 mrad\"\n");
    let head = |line: &str| format!("{line}\n{CAISSON}");
    let spellings = [
        plain.clone(),
        head("criteria = { SF_sliding = 0.5, slide = \"8 cm\", max_theta = \"50 mrad\" }"),
        head("criteria = { slide = 0.08, max_theta = 0.05, SF_sliding = 0.5 }"),
        head("criteria.slide = 0.08\ncriteria.SF_sliding = 0.5\ncriteria.max_theta = \"0.05 rad\""),
    ];
    for text in &spellings {
        let found: Vec<_> = checks(text).into_iter().map(|check| (check.0, check.2)).collect();
        assert_eq!(found, [("slide", false), ("max_theta", true)], "{text}");
        let assessment = Assessment::of_file(&CaseFile::parse("case.toml", text).unwrap()).unwrap();
        let all: Vec<_> =
            assessment.all_checks().iter().map(|check| (check.name(), check.is_met())).collect();
        assert_eq!(all, [("slide", false), ("SF_sliding", true), ("max_theta", true)]);
        assert_eq!(assessment.met(), Some(false));
        let json: serde_json::Value =
            serde_json::from_str(&assessment.json(&AssessmentView::default(), &[])).unwrap();
        assert_eq!((&json["met"], &json["criteria"][0]["name"]), (&false.into(), &"slide".into()));
        assert_eq!(json["criteria"], json["situations"][0]["criteria"]);
        assert!(json["in_time"].as_str().unwrap().contains("standfast simulate"));
    }
    let wrong = |line: &str| follow(&format!("{CAISSON}\n[criteria]\n{line}\n")).unwrap_err();
    assert!(wrong("slide = 0").contains("`slide` is 0; expected a finite number above zero"));
    assert!(wrong("overturned = true").contains("`overturned` is true; expected false"));
    assert!(wrong("max_theta = \"3 m\"").contains("`max_theta`"));
    // Of a case that says nothing of time it is refused.
    let still = "[body]\nwidth = 2\nheight = 2\nmass = 8e3\nfriction = 0.5\n[[load]]\nforce = 1e4\nelevation = 1\n[criteria]\nslide = 1\n";
    assert!(CaseFile::parse("case.toml", still).unwrap().case().unwrap_err().to_string().contains("slide"));
}

fn request(vary: &str, target: &str, extreme: Extreme, ends: Option<[&str; 2]>) -> DesignRequest {
    let [from, to] = ends.map_or([None, None], |ends| ends.map(|end| Some(end.to_owned())));
    let target = target.parse().unwrap();
    DesignRequest { vary: vary.to_owned(), target, extreme, from, to, spelling: &Spelling::PROGRAM }
}

fn designed(text: &str, request: DesignRequest) -> serde_json::Value {
    let file = CaseFile::parse("case.toml", text).unwrap();
    serde_json::from_str(&Design::of(&file, request, Portion::UNSEEN).unwrap().json(&(), &[])).unwrap()
}

/// The least friction for which Goda's caisson slides by 5 cm at most, by S = (¼ + √2/6)(s − 1)³/s² Rτ²/m, s = (P + μU)/(μW'), halved
/// down to; with P and U as `assess` has them, and m with the added mass.
#[test]
fn friction_for_a_slide_is_the_root_of_the_closed_form() {
    let lines = CAISSON.lines().filter(|line| !line.starts_with("history"));
    let still: String = lines.map(|line| format!("{line}\n")).collect();
    let still = CaseFile::parse("case.toml", &still).unwrap().case().unwrap();
    let situation = still.situation(Acting::Combination(0), standfast_cases::case::Trial::AS_GIVEN).unwrap();
    let sum = |permanent: bool| -> standfast::Wrench {
        let loads = situation.loads().iter().filter(|load| load.permanent == permanent);
        loads.map(|load| situation.wrench_of(load)).sum()
    };
    let (weight, wave) = (sum(true).p, sum(false));
    let (thrust, uplift, τ, m) = (-wave.x, -wave.p, 1.557, (346.05 + 56.4) * 1e3);
    let slide = |μ: f64| {
        let r = μ * weight;
        let s = (thrust + μ * uplift) / r;
        assert!(s < 1.0 + 0.5_f64.sqrt());
        (0.25 + 2f64.sqrt() / 6.0) * (s - 1.0).max(0.0).powi(3) / (s * s) * r * τ * τ / m
    };
    let (mut low, mut high) = (0.55, 0.9);
    while high - low > 1e-15 {
        let middle = 0.5 * (low + high);
        if slide(middle) > 0.05 {
            low = middle
        } else {
            high = middle
        }
        if (high - low).abs() <= f64::EPSILON {
            break;
        }
    }
    let found = designed(CAISSON, request("friction", "slide=0.05", Extreme::Least, None));
    let (boundary, value) =
        (found["found"]["boundary"].as_f64().unwrap(), found["found"]["value"].as_f64().unwrap());
    assert!((boundary - low).abs() < 1e-10, "{boundary} {low}");
    assert!(value >= low && value <= low * (1.0 + 2e-3), "{value} {low}");
    let printed = found["found"]["slide"].as_f64().unwrap();
    assert!((printed - slide(value)).abs() < 1e-9 * printed && printed <= 0.05, "{printed}");
    assert_eq!((&found["target"], &found["found"]["overturned"]), (&"slide=0.05 m".into(), &false.into()));
}

/// Widths at which a stone stays upright under one sine: two stretches, the same that single motions have, of texts with the width put
/// into them.
#[test]
fn what_is_not_monotone_is_found_whole() {
    let stone = |width: f64| {
        format!(
            "[body]\nwidth = {width:?}\nheight = 2.4\ndensity = 2600\nfriction = 5\n[motion]\n\
             impact = {{ law = \"ratio\", ratio = 0.8 }}\n[motion.base]\n\
             horizontal = {{ shape = \"sine\", peak = \"0.7 g\", period = \"0.9 s\", duration = \"0.9 s\" }}\n"
        )
    };
    let stands = |width: f64| !follow(&stone(width)).unwrap()[0].outcome.overturned();
    let request = request("width", "overturned=false", Extreme::Least, Some(["0.2", "1.5"]));
    let found = designed(&stone(0.6), request);
    let met = found["met"].as_array().unwrap();
    let stretches: Vec<[f64; 2]> = met
        .iter()
        .map(|stretch| ["from", "to"].map(|end| stretch[end]["boundary"].as_f64().unwrap()))
        .collect();
    assert_eq!(stretches.len(), 2, "{stretches:?}");
    assert_eq!(found["found"]["boundary"], met[0]["from"]["boundary"]);
    for width in (0..260).map(|i| 0.2 + 0.005 * f64::from(i)) {
        let inside = stretches.iter().any(|[from, to]| (*from..=*to).contains(&width));
        assert_eq!(stands(width), inside, "{width}");
    }
    for [from, to] in stretches {
        assert!(stands(from) && !stands(from * (1.0 - 1e-9)), "{from}");
        assert!(stands(to) && (to == 1.5 || !stands(to * (1.0 + 1e-9))), "{to}");
    }
    for stretch in met {
        for end in ["from", "to"] {
            assert!(stands(stretch[end]["value"].as_f64().unwrap()), "{stretch}");
        }
    }
}

/// `criteria` are those of the first instant and of the motion.
#[test]
fn all_criteria_together_are_the_harder_of_both() {
    let of = |criteria: &str, target: &str| {
        let text = format!("{CAISSON}\n[criteria]\n{criteria}\n");
        let found = designed(&text, request("mass", target, Extreme::Least, None));
        (found["found"]["boundary"].as_f64().unwrap(), found["binding"].as_str().unwrap().to_owned())
    };
    let (slide, _) = of("slide = 0.02", "slide=0.02");
    let (factor, _) = of("SF_sliding = 0.7", "SF_sliding=0.7");
    let (both, binding) = of("SF_sliding = 0.7\nslide = 0.02", "criteria");
    assert!(
        slide > factor && both == slide && binding.contains("slide is 0.02"),
        "{slide} {factor} {both} {binding}"
    );
    let (both, binding) = of("SF_sliding = 0.95\nslide = 0.02", "criteria");
    assert!(both > slide && binding.contains("SF_sliding"), "{both} {binding}");
    // A target of the motion of a case that has none.
    let still = CaseFile::parse(
        "case.toml",
        "[body]\nwidth = 2\nheight = 2\nmass = 8e3\nfriction = 0.5\n[[load]]\nforce = 1e4\nelevation = 1\n",
    )
    .unwrap();
    let error = Design::of(&still, request("width", "slide=0.1", Extreme::Least, None), Portion::UNSEEN)
        .err()
        .unwrap();
    assert!(error.to_string().contains("asks for the motion in time"), "{error}");
}

/// A record of a force is the force; in other units, or as shares of another force, it is the same motion.
#[test]
fn a_record_of_a_force_is_the_force_in_its_unit() {
    let case = |force: &str, length: &str| {
        format!(
            "[body]\nwidth = 2\nheight = 3\n{length}density = 2000\nfriction = 0.4\n[[load]]\nforce = \"{force}\"\nelevation = 0.5\n\
             history = {{ shape = \"file\", file = \"push.csv\" }}\n"
        )
    };
    // 0, 60, 80, 0 kN/m.
    let record = |header: &str, unit: f64| {
        let rows = [(0.0, 0.0), (0.3, 60.0), (0.5, 80.0), (0.9, 0.0)];
        rows.iter().fold(format!("time_s,{header}\n"), |text, (t, f)| text + &format!("{t},{}\n", f * unit))
    };
    let slid = |case: &str, record: String| -> Result<f64, String> {
        let read = |_: &str| Ok(record.clone());
        let file = CaseFile::read("case.toml", case, &read).map_err(|error| error.to_string())?;
        let answers =
            FollowedMotion::of_file(&file, &Follow::default()).map_err(|error| error.to_string())?;
        Ok(answers[0].outcome.slide)
    };
    let expected = {
        let points = "history = { shape = \"points\", times = [0, 0.3, 0.5, 0.9], values = [0, 0.75, 1, 0] }";
        let text = case("80 kN/m", "").replace("history = { shape = \"file\", file = \"push.csv\" }", points);
        follow(&text).unwrap()[0].outcome.slide
    };
    assert!(expected < -1e-3);
    let per_metre = [
        ("80 kN/m", "force_kN_m", 1.0),
        ("10 kN/m", "force_kN_m", 1.0),
        ("80 kN/m", "F_N_m", 1e3),
        ("3 kN/m", "F_MN_m", 1e-3),
        ("80 kN/m", "share", 1.0 / 80.0),
    ];
    for (force, header, unit) in per_metre {
        let found = slid(&case(force, ""), record(header, unit)).unwrap();
        assert!((found - expected).abs() < 1e-12, "{header}: {found} {expected}");
    }
    let whole = slid(&case("200 kN", "length = 2.5\n"), record("force_kN", 2.5)).unwrap();
    assert!((whole - expected).abs() < 1e-12, "{whole} {expected}");
    let refused = |force: &str, length: &str, header: &str| {
        slid(&case(force, length), record(header, 1.0)).unwrap_err()
    };
    assert!(
        refused("80 kN/m", "", "force_kN").contains("of a whole object; this case has forces per metre run")
    );
    assert!(refused("200 kN", "length = 2.5\n", "force_kN_m").contains("per metre run"));
    assert!(refused("80 kN/m", "", "force").contains("names no unit of a force"));
    assert!(refused("80 kN/m", "", "a_g").contains("a record of an acceleration"));
    assert!(refused("0 kN/m", "", "force_kN_m").contains("force of 0"));
}
