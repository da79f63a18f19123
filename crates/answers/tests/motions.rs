//! Motions of a case: their order, their criteria and their warnings, against closed forms and cases that part one condition from another.

use std::f64::consts::{FRAC_PI_2, PI};

use standfast_answers::motion::{Follow, FollowedMotion};
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
