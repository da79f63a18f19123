//! Motions of a case: their order, their criteria and their warnings, against closed forms and cases that part one condition from another.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, PI};

use standfast_answers::motion::{Follow, FollowedMotion, ResumeError, STATE_AT, SeriesAsked, resume};
use standfast_model::CaseFile;

fn followed(text: &str) -> Vec<FollowedMotion> {
    let file = CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    FollowedMotion::of_file(&file, &Follow::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn one(text: &str) -> FollowedMotion {
    followed(text).remove(0)
}

fn warns(of: &FollowedMotion, name: &str) -> bool {
    of.warnings.iter().any(|warning| warning.name == name)
}

/// A block that a rectangle of acceleration k and duration T slides by s = (k − μ) k T²/(2μ), with g = 1: what is used of each bound.
#[test]
fn what_is_used_of_a_bound() {
    let (k, μ, t) = (0.61, 0.4, 1.13_f64);
    let slide = (k - μ) * k * t * t / (2.0 * μ);
    let text = |criteria: &str| {
        format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 0.5\nmu_s = {μ}\ngravity = 1\n[motion.base]\n\
             horizontal = {{ shape = \"rect\", peak = {k}, duration = {t} }}\n{criteria}\n"
        )
    };
    assert_eq!(one(&text("")).met(), None);
    for (bound, met) in [(2.0 * slide, true), (0.5 * slide, false)] {
        let found = one(&text(&format!("[criteria]\nmax_theta = 0.1\noverturned = false\nslide = {bound}")));
        assert_eq!(found.met(), Some(met));
        let [slid, turned, over] = &found.checks()[..] else { panic!("{:?}", found.checks()) };
        assert!((slid.utilisation.unwrap() - slide / bound).abs() < 1e-9, "{slid:?}");
        assert_eq!((turned.utilisation, over.utilisation), (Some(0.0), None));
        assert_eq!([turned.met, over.met], [true, true]);
    }
    // The value is told from a bound that it all but reaches, and reads as the bound where it is that.
    let near = one(&text(&format!("[criteria]\nslide = {}", slide * (1.0 - 1e-9)))).checks()[0];
    assert_ne!(format!("≤ {}", near.value_words()), near.criterion.required(false));
    let found = near.value_words().parse::<f64>().unwrap();
    assert!((found - slide).abs() < 1e-9 * slide, "{found} {slide}");
    // One of several that is not met is enough.
    let both = format!("[criteria]\nmax_theta = 0.1\nslide = {}", 0.5 * slide);
    assert_eq!(one(&text(&both)).met(), Some(false));
}

/// A block that turns over to the side of its nearer corner has turned by a right angle, of which atan(b₁/d) is that of balance; its slide is
/// none that a bound could be met by.
#[test]
fn an_overturned_body_has_used_a_right_angle() {
    let text = "[block]\nb1 = 1\nb2 = 1.1\nd = 3\nrho2 = 3.4\nmu_s = 5\ngravity = 1\n[motion.base]\n\
                horizontal = { shape = \"rect\", peak = 0.9, duration = 3 }\n[criteria]\nslide = 9\nmax_theta = 1.0\noverturned = false\n";
    let found = one(text);
    assert!(found.outcome.overturned());
    let expected = FRAC_PI_2 / (1.0_f64 / 3.0).atan();
    assert!((found.of_balance() - expected).abs() < 1e-9, "{} {expected}", found.of_balance());
    let used = |name: &str| {
        let check = found.checks().into_iter().find(|check| check.criterion.name() == name);
        check.unwrap().utilisation
    };
    assert_eq!((used("slide"), used("overturned")), (Some(f64::INFINITY), None));
    assert!((used("max_theta").unwrap() - FRAC_PI_2).abs() < 1e-9);
    assert!(found.of_balance() < PI / 0.6, "the nearer corner counts");
}

const STONE: &str = "[body]\nwidth = 2\nheight = 6\nmass = 24e3\nfriction = 0.3\n";

/// A force on the stone, in weights of it.
fn push(name: &str, share: f64, elevation: f64, history: &str) -> String {
    format!(
        "[[load]]\nname = \"{name}\"\nforce = {}\nelevation = {elevation}\nhistory = {history}\n",
        share * 24e3 * 9.81
    )
}

/// At the crest a quarter of the weight turns the stone over without slip; at its foot half of it slides the stone far, and turns it not. The one
/// that turns over is the worst, then one that was past its balance, then the farther slide; whatever their order in the file.
#[test]
fn the_worst_motion_is_the_first() {
    let over = push("over", 0.25, 6.0, "{ shape = \"rect\", duration = 5 }");
    let far = push("far", 0.5, 0.1, "{ shape = \"rect\", duration = 2 }");
    let near = push("near", 0.5, 0.1, "{ shape = \"rect\", duration = 1 }");
    // Pushed beyond its balance, and pulled back.
    let back = (0..4000).find_map(|place| {
        let (t, pull) = (0.8 + 0.02 * f64::from(place % 80), 0.05 * f64::from(place / 80));
        let times = format!("[0, {t}, {t}, {}]", t + pull);
        let text = push(
            "back",
            0.25,
            6.0,
            &format!("{{ shape = \"points\", times = {times}, values = [1, 1, -1, -1] }}"),
        );
        let outcome = one(&format!("{STONE}{text}")).outcome;
        (outcome.past_balance && !outcome.overturned()).then_some(text)
    });
    let back = back.expect("a push beyond the balance from which it comes back");
    for loads in [[&over, &back, &far, &near], [&near, &far, &back, &over], [&far, &over, &near, &back]] {
        let text = format!("{STONE}{}", loads.map(String::as_str).concat());
        let found = followed(&text);
        let names: Vec<_> = found.iter().map(|of| of.case.situation.clone().unwrap()).collect();
        assert_eq!(names, ["over", "back", "far", "near"]);
        assert!(found[0].outcome.max_slide < found[2].outcome.max_slide);
        assert!(found[1].outcome.max_slide < found[3].outcome.max_slide);
    }
}

/// Water that moves along turns as if it did not: said of a body with added mass, to one side or upwards, that turns by more than 0.05.
#[test]
fn added_mass_of_a_body_that_turns() {
    let text = |masses: &str, peak: f64| {
        format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 3\n{masses}mu_s = 5\ngravity = 1\n[motion.base]\n\
             horizontal = {{ shape = \"half-sine\", peak = {peak}, duration = 2 }}\n"
        )
    };
    for (masses, peak, warned) in [
        ("m_x = 1.1\n", 0.7, true),
        ("m_y = 1.1\n", 0.7, true),
        ("m_x = 1.1\nm_y = 1.1\n", 0.7, true),
        ("", 0.7, false),
        ("m_x = 1.1\n", 0.34, false),
    ] {
        let found = one(&text(masses, peak));
        assert_eq!(
            found.outcome.max_theta > 0.05,
            peak == 0.7,
            "{masses} {peak}: {}",
            found.outcome.max_theta
        );
        assert_eq!(warns(&found, "added-mass-turns"), warned, "{masses} {peak}");
    }
}

/// What a shaking adds to the pressure of a backfill is left out of a motion: said where the base is shaken and the body has one.
#[test]
fn backfill_of_a_body_that_is_shaken() {
    let body = "[body]\nwidth = 10\nheight = 8\ndensity = 2300\nfriction = 0.6\n";
    let fill = "[[backfill]]\nface = \"right\"\nfriction_angle_deg = 35\nunit_weight = 18e3\n";
    let shaking = "[motion.base]\nhorizontal = { shape = \"half-sine\", peak = \"0.1 g\", duration = 1 }\n";
    let push = push("push", 0.1, 4.0, "{ shape = \"rect\", duration = 0.4 }");
    for (text, warned) in [
        (format!("{body}{fill}{shaking}"), true),
        (format!("{body}{fill}{push}"), false),
        (format!("{body}{shaking}"), false),
    ] {
        assert_eq!(warns(&one(&text), "backfill-kept"), warned, "{text}");
    }
}

/// The pressure of water under a base that is lifted is left as it is: said where there is such a pressure and the body turns.
#[test]
fn uplift_under_a_lifted_base() {
    let uplift = "[uplift]\nleft = 2e3\nright = 2e3\n";
    let turns = push("turns", 0.3, 6.0, "{ shape = \"rect\", duration = 0.4 }");
    let slides = push("slides", 0.5, 0.1, "{ shape = \"rect\", duration = 0.4 }");
    for (text, turned, warned) in [
        (format!("{STONE}{uplift}{turns}"), true, true),
        (format!("{STONE}{turns}"), true, false),
        (format!("{STONE}{uplift}{slides}"), false, false),
    ] {
        let found = one(&text);
        assert_eq!(found.outcome.max_theta > 0.0, turned, "{text}");
        assert_eq!(warns(&found, "uplift-kept"), warned, "{text}");
    }
}

/// A ratio of impact that would give energy to a body that slips is reduced, and said to be: of blocks that fall onto their other corner while
/// they slip to either side, some.
#[test]
fn a_ratio_that_would_give_energy() {
    let text = |vx: f64, ratio: f64| {
        format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 1.5\nmu_s = 0.5\ngravity = 1\n[motion]\nt_max = 0.2\n\
             impact = {{ law = \"ratio\", ratio = {ratio} }}\ninitial = {{ theta = 0.02, omega = -0.5, vx = {vx} }}\n"
        )
    };
    let mut kinds = [0, 0];
    for vx in [-1.2, -0.6, -0.2, 0.2, 0.6, 1.2] {
        let largest = one(&text(vx, 0.1)).case.problem.largest_ratio();
        let found = one(&text(vx, 0.999 * largest));
        let reduced = found.outcome.reduced_impacts > 0;
        kinds[usize::from(reduced)] += 1;
        assert_eq!(warns(&found, "ratio-reduced"), reduced, "{vx}");
    }
    assert!(kinds[0] > 0 && kinds[1] > 0, "{kinds:?}");
}

/// `overturned_share` is judged by the upper end of the interval over the copies of the case; without copies it is refused, and so is a name that scatters nothing.
#[test]
fn a_share_of_copies_may_be_asked_for() {
    let text = |copies: &str, bound: f64| {
        format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 4\nmu_s = 2\ngravity = 1\n[motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = 0.3, duration = 3 }}\n\
             {copies}[criteria]\noverturned_share = {bound}\n"
        )
    };
    // None of 60: 1 − 0.025^(1/60).
    let upper = 1.0 - 0.025_f64.powf(1.0 / 60.0);
    let copies = "[motion.copies]\nnumber = 60\nspread = 1e-6\n";
    for (bound, met) in [(upper * 1.001, true), (upper * 0.999, false)] {
        let found = one(&text(copies, bound));
        let check = found.checks()[0];
        assert_eq!((found.met(), check.met), (Some(met), met));
        assert!((check.utilisation.unwrap() - upper / bound).abs() < 1e-9, "{check:?}");
        assert!(check.failure().contains("overturned_share is at most 0.0596"), "{}", check.failure());
    }
    let refused = |copies: &str| {
        let file = CaseFile::parse("case.toml", &text(copies, 0.1)).unwrap();
        FollowedMotion::of_file(&file, &Follow::default()).unwrap_err().to_string()
    };
    assert!(refused("").contains("[motion.copies]"), "{}", refused(""));
    let named = refused("[motion.copies]\nnumber = 5\nspread = { widht = 0.1 }\n");
    assert!(named.contains("widht") && named.contains("width, height, inertia, friction, base"), "{named}");
    // A copy that still moves when the time is up may overturn yet.
    let cut = one(&text(copies, 0.9).replace("[motion.base]", "[motion]\nt_max = 1\n[motion.base]"));
    assert_eq!((cut.checks()[0].utilisation, cut.met()), (Some(f64::INFINITY), Some(false)));
}

/// A row of a series stands for keys of `[motion.initial]`, with which the rest is the same motion; one just before an event is refused.
#[test]
fn a_motion_goes_on_from_a_row() {
    let (mut states, mut gone_on, mut before) = (BTreeSet::new(), 0, 0);
    for frictions in [[0.7, 0.6], [0.4, 0.3], [0.5, 0.5]] {
        let [mu_s, mu_k] = frictions;
        let text = format!(
            "[block]\nb1 = 1\nb2 = 1.1\nd = 2\nrho2 = 1.7\nmu_s = {mu_s}\nmu_k = {mu_k}\ngravity = 1\n[motion]\n\
             impact = {{ law = \"poisson\", e = 0.3 }}\n[motion.base]\n\
             horizontal = {{ shape = \"sine\", peak = 0.7, angular_frequency = 1.3, duration = 11 }}\n\
             vertical = {{ shape = \"sine\", peak = 0.6, angular_frequency = 2.1, duration = 9 }}\n"
        );
        let file = CaseFile::parse("case.toml", &text).unwrap();
        let follow = Follow { series: true, divergence: true, ..Follow::default() };
        let whole = FollowedMotion::of_file(&file, &follow).unwrap().remove(0);
        let asked = SeriesAsked { dt: 0.25, events: true };
        let columns = asked.columns(&whole.case);
        let mut names: Vec<String> = columns.iter().map(|column| column.name.to_string()).collect();
        names.insert(STATE_AT, "state".to_owned());
        for line in asked.csv(&whole.case, &whole.outcome).lines().skip(1) {
            let cells = line.split(',').map(str::to_owned);
            let row: Vec<(String, String)> = names.iter().cloned().zip(cells).collect();
            let mut inputs = file.inputs().clone();
            match resume(&mut inputs, &row) {
                Err(ResumeError::BeforeAnEvent) => {
                    before += 1;
                    continue;
                }
                other => other.unwrap(),
            }
            let rest = FollowedMotion::of_file(&file.varied(inputs), &follow).unwrap().remove(0);
            let (one, other) = (&rest.outcome, &whole.outcome);
            let off = (one.slide - other.slide).abs() + (one.theta - other.theta).abs();
            assert!(off < 1e-12 * (100.0 + whole.divergence.unwrap().value), "{line}: {off}");
            assert_eq!(one.end, other.end, "{line}");
            states.insert(row[STATE_AT].1.clone());
            gone_on += 1;
        }
        let lacks = resume(&mut file.inputs().clone(), &[("t".to_owned(), "0".to_owned())]).unwrap_err();
        assert_eq!(lacks, ResumeError::NoColumn { column: "state" });
    }
    assert!(gone_on > 400 && before > 300 && states.len() > 5, "{gone_on} {before} {states:?}");
}
