//! The frictions with which a body that slides is borne, on any ground: as a plain search has them that looks closely and halves.

mod common;

use common::{Random, tries};
use standfast::ground::bearing::{Ground, GroundLaw, GroundPath};
use standfast::ground::load_plane::{GroundLoadPlane, LoadEdge};
use standfast::loads::{Action, Load, LoadKind, LoadSource};
use standfast::{Body, Situation, Slip};

/// No formula bears a body that slides with more.
const MOST: f64 = 10.0;

fn ground(random: &mut Random) -> Ground {
    let law = random.pick(&[GroundLaw::Ec7, GroundLaw::Hansen]);
    let soil = Ground::new(law, random.uniform(25.0, 45.0), random.log(8e3, 20e3)).unwrap();
    match random.pick(&[0, 1, 2, 3]) {
        0 => soil,
        1 => soil.with_surcharge(random.log(1e3, 1e5)).unwrap(),
        2 => soil.with_cohesion(random.log(1e3, 5e4)).unwrap().with_surcharge(random.log(1e3, 1e5)).unwrap(),
        _ => {
            let (h, m) = (random.uniform(0.2, 0.8), random.uniform(0.2, 0.6));
            Ground::envelope_with(random.log(1e6, 3e7), h, m, random.uniform(-0.9, 0.9)).unwrap()
        }
    }
}

fn situation(random: &mut Random) -> Situation {
    let (width, height) = (random.uniform(2.0, 20.0), random.uniform(2.0, 20.0));
    let body = Body::new(width, height, 2e3 * width * height).unwrap();
    let body =
        body.with_centroid(random.uniform(-0.15, 0.15) * width, random.uniform(0.3, 0.7) * height).unwrap();
    let weight = 2e3 * width * height * 9.81;
    let force = |random: &mut Random| random.uniform(-1.0, 1.0) * weight;
    let push = Action::horizontal(force(random), random.uniform(-0.5, 1.5) * height);
    let lift = random.uniform(0.0, 0.6) * weight / width;
    let uplift = Action::base_pressure(&body, lift, random.uniform(0.0, lift));
    Situation::new(body, 0.6, 9.81)
        .unwrap()
        .with_weight()
        .with(Load::variable(LoadSource::Force, LoadKind::Horizontal, push))
        .with(Load::variable(LoadSource::Uplift, LoadKind::Uplift, uplift))
}

/// R/P less 1 of a body that slides.
fn excess(path: &GroundPath, slip: Slip, factor: f64, mu: f64) -> f64 {
    path.sliding_reaction(factor, slip, mu).map_or(1.0, |at| path.ground().factor(&at) - 1.0)
}

fn halved(f: impl Fn(f64) -> f64, mut bad: f64, mut good: f64) -> f64 {
    for _ in 0..200 {
        let middle = (bad + good) / 2.0;
        if f(middle) >= 0.0 { good = middle } else { bad = middle }
    }
    good
}

/// The least and the largest friction borne: the best of many frictions, nearer by thirds, and from there halved to both ends.
fn borne(path: &GroundPath, slip: Slip, factor: f64) -> Option<[f64; 2]> {
    const STEPS: u32 = 2000;
    let f = |mu: f64| excess(path, slip, factor, mu);
    path.sliding_reaction(factor, slip, 0.0)?;
    let step = 4.0 / f64::from(STEPS);
    let near = (0..=STEPS).map(|i| step * f64::from(i)).max_by(|a, b| f(*a).total_cmp(&f(*b)))?;
    let (mut low, mut high) = ((near - step).max(0.0), near + step);
    for _ in 0..100 {
        let third = (high - low) / 3.0;
        if f(low + third) < f(high - third) { low += third } else { high -= third }
    }
    let best = [near, low].into_iter().max_by(|a, b| f(*a).total_cmp(&f(*b)))?;
    if f(best) < 0.0 {
        return None;
    }
    Some([if f(0.0) >= 0.0 { 0.0 } else { halved(f, 0.0, best) }, halved(f, MOST, best)])
}

#[test]
fn what_is_borne_is_what_a_plain_search_finds() {
    let mut random = Random(28);
    let (mut tongues, mut islands, mut bare) = (0, 0, 0);
    for _ in 0..tries(600) {
        let (given, soil) = (situation(&mut random), ground(&mut random));
        let path = GroundPath::new(soil, &given).unwrap();
        let plane = GroundLoadPlane::failing(&given, soil, 2.0).unwrap();
        for _ in 0..6 {
            let factor = random.uniform(0.0, 2.0);
            for slip in [Slip::Left, Slip::Right] {
                let ends = [false, true].map(|largest| plane.at(LoadEdge::Bearing { slip, largest }, factor));
                let expected = borne(&path, slip, factor);
                let said = format!("{soil:?}\n{given:?}\n{slip:?} at {factor}: {ends:?}, {expected:?}");
                match (expected, ends) {
                    (None, [None, None]) => bare += 1,
                    (Some([least, most]), [Some(low), Some(high)]) => {
                        // Where the ground just bears the body rounding moves both ends by much more.
                        let near = |one: f64, other: f64| (one - other).abs() < 1e-9 * (1.0 + other);
                        assert!(near(low, least) && near(high, most), "{said}");
                        tongues += 1;
                        islands += u32::from(least > 0.0);
                    }
                    _ => panic!("{said}"),
                }
            }
        }
    }
    let all = tries(600);
    assert!(tongues > all && bare > all && islands > all / 20, "{tongues}, {islands}, {bare}");
}
