//! Two cases side by side: sentences, and drawings of one behind the other.

use standfast_cases::assess::pinned::{
    diagram_on_paper, load_plane_on_paper, pinned_body, pinned_diagram, pinned_plane, section_on_paper,
    share_of,
};
use standfast_cases::assess::screen::{
    SectionView, load_plane_on_screen, load_plane_on_screen_beside, section_on_screen,
};
use standfast_cases::compare::{Compared, Comparison};
use standfast_cases::motion::screen::{histories_on_paper, histories_on_screen_beside, pinned_motion};
use standfast_cases::motion::{Follow, FollowedMotion};
use standfast_cases::{Assessment, CaseFile, Document};
use standfast_figures::{PinnedBody, PinnedLoad};

const AIR: &str = include_str!("../../../examples/caisson-in-air.toml");
const GODA: &str = include_str!("../../../examples/goda-2000.toml");
const PULSE: &str = include_str!("../../../examples/motion/block-base-pulse.toml");
/// The line of A in a drawing for a screen.
const DASHES: &str = "stroke-dasharray=\"7 4\"";

fn file(text: &str) -> CaseFile {
    CaseFile::parse("case.toml", text).unwrap()
}

fn assessed(text: &str) -> Assessment {
    Assessment::of_file(&file(text)).unwrap()
}

fn followed(text: &str) -> Vec<FollowedMotion> {
    let follow = Follow { series: true, ..Follow::default() };
    FollowedMotion::of_file(&file(text), &follow).unwrap()
}

/// What is said of two cases at rest.
fn told(one: &str, two: &str) -> Comparison {
    let (a, b) = (assessed(one), assessed(two));
    let tops = [a.summary(), b.summary()];
    let [a, b] = [(&a, &tops[0]), (&b, &tops[1])].map(|(rest, top)| Compared {
        rest: Some(rest),
        motions: &[],
        summary: top.as_ref(),
    });
    Comparison::of(&a, &b, &file(one).differences(&file(two)))
}

/// W = 2.1 · 15 · 12 · 9.81 = 3708.18 kN/m, and 0.6 W = 2224.9: A slides from there on. Of 17.6 m it is 4350.93 and 2610.6, and rocking
/// begins at 4350.93 · 8.8/11.5 = 3329, behind 2700.
#[test]
fn a_wider_caisson_is_told_by_its_width_and_its_forces() {
    let Comparison { answer, near, criteria } = told(AIR, &AIR.replace("\"15 m\"", "\"17.6 m\""));
    assert_eq!(answer, "A slides and rocks about O (SRO-). B, 17.6 m wide, slides to the left (SL).");
    assert_eq!(near, "A rests up to 2225 kN/m, B up to 2611 kN/m.");
    assert_eq!(criteria, "");
}

#[test]
fn one_number_names_b_and_several_do_not() {
    let answer = |two: &str| told(AIR, two).answer;
    let b = |two: &str| answer(two).split_once(". ").unwrap().1.to_owned();
    // 0.3 W = 1112 kN/m is the less, and the body slides.
    assert_eq!(b(&AIR.replace("= 0.6", "= 0.3")), "B, with friction 0.3, slides to the left (SL).");
    assert_eq!(
        b(&AIR.replace("2700 kN", "2.75 MN")),
        "B, with force 2.75 MN/m, slides and rocks about O (SRO-), too."
    );
    assert_eq!(b(&AIR.replace("2700", "2000")), "B, with force 2000 kN/m, stays at rest (RE).");
    let two = AIR.replace("= 0.6", "= 0.3").replace("\"15 m\"", "\"17.6 m\"");
    assert_eq!(b(&two), "B slides to the left (SL).");
    // A title is no number that was changed.
    let titled = AIR.replace("Caisson in air", "Wider").replace("\"15 m\"", "\"17.6 m\"");
    assert_eq!(b(&titled), "B, 17.6 m wide, slides to the left (SL).");
    assert_eq!(b(GODA), "B stays at rest (RE).");
}

/// Of waves shares are told, of criteria whether they are met, and of a body that nothing holds what moves it.
#[test]
fn the_second_line_tells_up_to_which_load_each_rests() {
    let less = GODA.replace("friction = 0.6", "friction = 0.4");
    let told_goda = told(GODA, &less);
    // Goda's factor against sliding is proportional to the friction, and the load factor with the uplift that grows as it does is not:
    // the program's own path, at each friction.
    let share = |text: &str| {
        let rest = assessed(text);
        100.0 * rest.governing().departure().load_factor()
    };
    let numbers: Vec<f64> = told_goda.near.split(' ').filter_map(|word| word.parse().ok()).collect();
    assert_eq!(numbers.len(), 2, "{}", told_goda.near);
    assert!((numbers[0] - share(GODA)).abs() < 0.06 && (numbers[1] - share(&less)).abs() < 0.06);
    assert!(
        told_goda.near.starts_with("A rests up to ") && told_goda.near.contains(" % of the wave, B up to ")
    );

    let asked = format!("{GODA}\n[criteria]\nSF_sliding = 1.0\n");
    let strict = format!("{GODA}\n[criteria]\nSF_sliding = 9.0\n");
    let criteria = told(&asked, &strict).criteria;
    assert!(criteria.starts_with("A meets its criteria. Of B not met: SF_sliding is 1.165"), "{criteria}");
    assert!(told(GODA, &strict).criteria.starts_with("A has no criteria. Of B not met: "));

    let stronger = AIR.replace("2700", "4000");
    assert_eq!(told(AIR, &stronger).near, "Both rest up to 2225 kN/m.");
    let slope = AIR.replace("= 0.6", "= 0");
    assert_eq!(told(AIR, &slope).near, "A rests up to 2225 kN/m. Any share of the breaking wave moves B.");
}

fn beside(pinned: &PinnedBody) -> SectionView<'_> {
    SectionView { pinned: Some(pinned), ..SectionView::default() }
}

/// The body of A is drawn where it is not that of B, both to one scale.
#[test]
fn the_section_has_the_other_body_in_dashes() {
    let (a, wide) = (assessed(AIR), assessed(&AIR.replace("\"15 m\"", "\"17.6 m\"")));
    let body = pinned_body(&a).unwrap();
    let size = (560.0, 400.0);
    let alone = section_on_screen(&a, SectionView::default(), size).unwrap();
    let same = section_on_screen(&a, beside(&body), size).unwrap();
    assert_eq!(same.picture.figure.svg(), alone.picture.figure.svg(), "nothing doubles");
    let both = section_on_screen(&wide, beside(&body), size).unwrap();
    let svg = both.picture.figure.svg();
    assert_eq!(svg.matches(DASHES).count(), 1, "its right edge alone");
    let path = svg.split("<path d=\"M").find(|path| path.contains(DASHES)).unwrap();
    let x: f64 = path.split(' ').next().unwrap().parse().unwrap();
    let right = both.picture.body.x0 + 15.0 * both.picture.scale;
    assert!((x - right).abs() < 0.01, "{x} {right}");
    assert!(both.words.iter().any(|words| words == "Dashed: A, Caisson in air"), "{:?}", both.words);
    // The wider one in dashes: the drawing has room for it, and its fields stand at the body's own.
    let wider = pinned_body(&wide).unwrap();
    let picture = section_on_screen(&a, beside(&wider), size).unwrap().picture;
    assert!(((picture.body.x1 - picture.body.x0) / picture.scale - 15.0).abs() < 1e-9);
    assert!(picture.body.x0 + 17.6 * picture.scale < picture.figure.size().0);
    let paper = section_on_paper(&wide, &body).unwrap();
    assert!(paper.svg().contains(DASHES) && paper.labels().iter().any(|label| label.text.contains("Dashed")));
}

/// Where the force is the only load, both are followed in shares of that of B: A's full load at 2700/3000 lies at 0.9.
#[test]
fn the_plane_of_the_load_is_one_for_both() {
    let (a, b) = (assessed(AIR), assessed(&AIR.replace("2700", "3000").replace("\"15 m\"", "\"17.6 m\"")));
    let (of_a, of_b) = (a.governing(), b.governing());
    let share = share_of(of_a, of_b);
    assert!((share - 0.9).abs() < 1e-12);
    let goda = assessed(GODA);
    assert_eq!(share_of(of_a, goda.governing()), 1.0);
    let plane = pinned_plane(&a, of_a, 3.0).unwrap().unwrap();
    let pinned = PinnedLoad { plane: &plane, share };
    let plot = (400.0, 250.0);
    let alone = load_plane_on_screen(of_b, "", 2.0, plot).unwrap().unwrap();
    let both = load_plane_on_screen_beside(of_b, "", Some(pinned), 2.0, plot).unwrap().unwrap();
    assert!(!alone.figure.svg().contains(DASHES));
    assert!(both.figure.svg().contains(DASHES));
    // A leaves rest by rocking at W b/(2e) = 3708.18 · 7.5/11.5 = 2418.4 kN/m: that upright line lies at 2418.4/3000 of B's force.
    let (x, _) = both.place(2418.378 / 3000.0, 0.0);
    let upright = |path: &&str| {
        let places: Vec<f64> =
            path.split(['M', 'L', ' ', '"']).filter_map(|word| word.parse().ok()).collect();
        path.contains(DASHES) && places.len() > 3 && places[0] == places[2] && (places[0] - x).abs() < 0.02
    };
    assert!(both.figure.svg().split("<path d=\"").any(|path| upright(&path)), "no line at {x}");
    // The view goes as far as a load of A that is three times as large.
    let far = PinnedLoad { plane: &plane, share: 3.0 };
    let wide = load_plane_on_screen_beside(of_b, "", Some(far), 2.0, plot).unwrap().unwrap();
    assert!(wide.across.to > 3.0);
    let paper = load_plane_on_paper(&b, of_b, 2.0, pinned).unwrap().unwrap();
    assert!(
        paper.svg().contains(DASHES) && paper.caption().contains("Dashed: A, Caisson in air"),
        "{}",
        paper.caption()
    );
}

#[test]
fn the_report_s_plane_has_both() {
    let (a, b) = (assessed(AIR), assessed(&AIR.replace("\"12 m\"", "\"14 m\"").replace("2700", "9000")));
    let pinned = pinned_diagram(&a, a.governing()).unwrap();
    // k = 2700/3708.18.
    assert!((pinned.k - 2700.0 / 3708.18).abs() < 1e-9 && pinned.mu == 0.6);
    let paper = diagram_on_paper(&b, b.governing(), &pinned).unwrap();
    assert!(paper.svg().contains(DASHES));
    assert!(
        paper
            .caption()
            .contains("Dashed: A, Caisson in air, breaking wave; its full load is the hollow diamond."),
        "{}",
        paper.caption()
    );
    // On ground that fails there is no such plane.
    let sand = assessed(include_str!("../../../examples/goda-on-sand.toml"));
    assert!(pinned_diagram(&sand, sand.governing()).is_none());
}

/// The histories of a stronger shaking behind those of a weaker one; none where the lengths are in another unit.
#[test]
fn histories_lie_behind_each_other() {
    let (a, b) = (followed(PULSE), followed(&PULSE.replacen("mu_s = ", "mu_k = 0.05\nmu_s = ", 1)));
    let pinned = pinned_motion(&a[0]).unwrap();
    let drawn = |motion: &FollowedMotion| {
        histories_on_screen_beside(motion, Some(&pinned), (600.0, 400.0)).unwrap().figure.svg().to_owned()
    };
    assert!(drawn(&b[0]).contains("stroke-dasharray=\"6 3.4\""));
    assert!(histories_on_paper(&b[0], &pinned).unwrap().caption().contains("Dashed: A, "));
    let metres = followed(include_str!("../../../examples/motion/caisson-breaking-wave.toml"));
    assert!(!drawn(&metres[0]).contains("stroke-dasharray=\"6 3.4\""));
}
