//! The outcome of a situation: the classical checks against the contact problem, the departure and the rise against the
//! response at single load factors, loads of every kind on bodies of any shape.

mod common;

use common::{Random, tries};
use standfast::Verdict::Begins;
use standfast::loads::LoadKind::{Horizontal, Weight};
use standfast::loads::{
    Action, AddedMass, BodyPoint, Earthquake, HorizontalForce, Load, LoadKind, LoadSource, Pose, PressureAt,
    PressureDiagram, StillWater, Uplift,
};
use standfast::{Bearing, Body, Corner, Departure, Mode, Situation, Slip, Stability, Stage, Verdict, Wrench};

const G: f64 = 9.81;

/// A body with or without an eccentric centre of mass and an unequal base, under loads of every kind.
fn random_situation(random: &mut Random) -> Situation {
    let (width, height) = (random.uniform(5.0, 20.0), random.uniform(5.0, 20.0));
    let mut body = Body::of_density(width, height, random.uniform(800.0, 2400.0)).unwrap();
    if random.coin() {
        let mut share = |of: f64| of * random.uniform(0.3, 0.6);
        body = body.with_base(share(width), share(width)).unwrap();
        let offset = random.uniform(-0.15, 0.15) * width;
        body = body.with_centroid(offset, random.uniform(0.3, 0.7) * height).unwrap();
    }
    let weight = body.mass() * G;
    let mut situation = Situation::new(body, random.uniform(0.0, 1.5), G).unwrap().with_weight();
    if random.coin() {
        let kinetic = situation.static_friction() * random.uniform(0.5, 1.0);
        situation = situation.with_kinetic_friction(kinetic).unwrap();
    }
    let mut added = AddedMass::NONE;
    if random.coin() {
        let level = |random: &mut Random| random.uniform(0.0, 0.9) * height;
        let (left, right) = (level(random), level(random));
        added = AddedMass::beside(1030.0, &[left, right]).unwrap();
        let water = StillWater::new(&body, left, right, 1030.0).unwrap();
        situation = situation.with_all(water.loads(&body, G)).with_added_mass(added);
    }
    if random.coin() {
        let mut pressure = || random.uniform(0.0, 0.3) * weight / width;
        let (left, right) = (pressure(), pressure());
        situation = situation.with(Uplift::new(left, right, random.coin()).unwrap().load(&body));
    }
    if random.coin() {
        let quake = Earthquake::new(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)).unwrap();
        situation = situation.with_all(quake.loads(&added));
    }
    if random.coin() {
        let at = BodyPoint { x: random.uniform(-0.5, 0.5) * width, y: random.uniform(0.0, height) };
        let mut force = || random.uniform(-0.4, 0.4) * weight;
        let (right, up) = (force(), force());
        let action = Action::Force { at, right, up };
        let kind = random.pick(&[Horizontal, Weight, LoadKind::Uplift]);
        situation = situation.with(Load::variable(LoadSource::Force, kind, action));
    }
    situation
}

/// ξ = (Xd − M)/P, where the base's reaction would act if the body rested.
fn reaction_at(body: &Body, wrench: &Wrench) -> f64 {
    (wrench.x * body.centroid_height() - wrench.m) / wrench.p
}

/// Whatever acts: t_e is where the reaction of the contact problem acts; the pressure on the base is in equilibrium with it;
/// and the body rests if and only if it acts on the base and the factor against sliding is not below 1. The factor against
/// overturning is below 1 where it does not, or where it would not without the horizontal forces.
#[test]
fn the_classical_checks_are_those_of_the_contact_problem() {
    let mut random = Random(61);
    let mut seen = [0; 4];
    for _ in 0..tries(20_000).max(500) {
        let situation = random_situation(&mut random);
        let outcome = situation.outcome().unwrap();
        let (body, wrench) = (situation.body(), outcome.full.wrench);
        let (actions, stability) = (outcome.actions, outcome.stability);
        let weight = body.mass() * G;
        let near = |one: f64, two: f64, size: f64| (one - two).abs() <= 1e-9 * size;
        assert!(near(actions.buoyant_weight - actions.uplift, wrench.p, weight), "{situation:?}");
        assert!(near(actions.force, wrench.x.abs(), weight), "{situation:?}");
        if wrench.p.abs() < 1e-6 * weight {
            continue;
        }
        assert_eq!(outcome.full.is_lifted(), wrench.p < 0.0);
        if wrench.p < 0.0 {
            assert_eq!((stability.resultant_arm, stability.bearing), (None, Bearing::Lifted));
            assert_eq!(stability.eccentricity(body.base_width()), None);
            assert_ne!(outcome.full.mode(), Some(Mode::Rest), "{situation:?}");
            seen[0] += 1;
            continue;
        }
        let ξ = reaction_at(body, &wrench);
        let from_heel = match actions.heel {
            Corner::O => body.heel_distance() + ξ,
            Corner::OPrime => body.toe_distance() - ξ,
        };
        let arm = stability.resultant_arm.unwrap();
        let size = body.width() * weight / wrench.p;
        assert!(near(arm, from_heel, size), "{situation:?}: {arm} {from_heel}");
        let base = body.base_width();
        let from_middle = (ξ - (body.toe_distance() - body.heel_distance()) / 2.0).abs();
        assert!(near(stability.eccentricity(base).unwrap(), from_middle, size), "{situation:?}");
        let inside = arm > 0.0 && arm < base;
        match stability.bearing {
            Bearing::Pressed { heel, toe, contact, share } => {
                assert!(inside && heel >= 0.0 && toe >= 0.0 && contact <= base && share == contact / base);
                assert_eq!(stability.bearing.largest(), Some(heel.max(toe)));
                let start = if heel == 0.0 { base - contact } else { 0.0 };
                let sum = (heel + toe) / 2.0 * contact;
                let moment = sum * start + (heel + 2.0 * toe) / 6.0 * contact * contact;
                assert!(near(sum, wrench.p, weight) && near(moment, wrench.p * arm, weight * base));
                seen[1] += 1;
            }
            bearing => {
                assert_eq!(bearing, Bearing::OutsideBase);
                assert_eq!(bearing.largest(), None);
                assert!(!inside, "{situation:?}");
                seen[2] += 1;
            }
        }
        let Stability { sliding, .. } = stability;
        let vertical_arm = (actions.buoyant_weight * actions.weight_arm - actions.uplift_moment) / wrench.p;
        let on_edge = |arm: f64| [arm, base - arm].iter().any(|gap| gap.abs() < 1e-6 * base);
        if (sliding - 1.0).abs() > 1e-9 && !on_edge(arm) && !on_edge(vertical_arm) {
            let upright = inside && vertical_arm > 0.0 && vertical_arm < base;
            assert_eq!(stability.overturning() >= 1.0, upright, "{situation:?}: {stability:?}");
            let rests = outcome.full.mode() == Some(Mode::Rest);
            assert_eq!(sliding >= 1.0 && inside, rests, "{situation:?}: {stability:?}");
            seen[3] += u32::from(rests);
        }
    }
    assert!(seen.iter().all(|&count| count >= tries(80)), "{seen:?}");
}

/// Whatever acts, lifted or not: the margins are the moments of all loads about both corners and what friction leaves of the
/// horizontal force, summed here from the one wrench; and none is negative if and only if rest is a mode of the contact problem.
#[test]
fn margins_are_those_of_the_contact_problem() {
    let mut random = Random(62);
    let mut seen = [0; 4];
    for _ in 0..tries(20_000).max(500) {
        let situation = random_situation(&mut random);
        let outcome = situation.outcome().unwrap();
        let (body, Wrench { x, p, m }) = (situation.body(), outcome.full.wrench);
        let margins = outcome.actions.margins(situation.static_friction(), body);
        let weight = body.mass() * G;
        // Counter-clockwise about O, of the loads: the right corner would press more.
        let turning = m - x * body.centroid_height();
        let about = [p * body.heel_distance() - turning, p * body.toe_distance() + turning];
        let [heel, toe] = if outcome.actions.heel == Corner::O { about } else { [about[1], about[0]] };
        let sliding = situation.static_friction() * p - x.abs();
        let near = |one: f64, two: f64, size: f64| (one - two).abs() <= 1e-9 * size;
        let size = weight * body.width();
        assert!(near(margins.sliding, sliding, weight), "{situation:?}: {margins:?}");
        assert!(near(margins.overturning_about_heel, heel, size), "{situation:?}: {margins:?}");
        assert!(near(margins.overturning_about_toe, toe, size), "{situation:?}: {margins:?}");
        assert_eq!(margins.overturning(), margins.overturning_about_heel.min(margins.overturning_about_toe));
        let [slides, turns] = [margins.sliding / weight, margins.overturning() / size];
        if slides.abs() > 1e-9 && turns.abs() > 1e-9 {
            let rests = slides > 0.0 && turns > 0.0;
            assert_eq!(outcome.full.modes.contains(Mode::Rest), rests, "{situation:?}: {margins:?}");
            seen[usize::from(slides > 0.0) + 2 * usize::from(turns > 0.0)] += 1;
        }
    }
    assert!(seen.iter().all(|&count| count > tries(80)), "{seen:?}");
}

/// By gross moments, summed load by load about each corner: what water does under the base turns, what weighs or is
/// sucked down resists. The
/// factor is below 1 just where the reaction would act beside the base.
#[test]
fn gross_moments_are_those_of_the_loads() {
    let mut random = Random(63);
    let mut seen = [0; 3];
    for _ in 0..tries(20_000).max(500) {
        let situation = random_situation(&mut random);
        let outcome = situation.outcome().unwrap();
        let body = situation.body();
        let size = body.mass() * G * body.width();
        let uplift = situation.loads().iter().filter(|load| load.kind == LoadKind::Uplift);
        let is_sucked = uplift.map(|load| situation.wrench_of(load).p).sum::<f64>() > 0.0;
        // About O counter-clockwise, about O' clockwise: distance, sense.
        let factors = [(body.heel_distance(), 1.0), (body.toe_distance(), -1.0)].map(|(arm, sense)| {
            let [mut resisting, mut turning] = [0.0; 2];
            for load in situation.loads() {
                let Wrench { x, p, m } = situation.wrench_of(load);
                turning -= sense * x * body.centroid_height();
                match load.kind {
                    _ if load.source == LoadSource::Buoyancy => turning += sense * m - p * arm,
                    LoadKind::Uplift if !is_sucked => turning += sense * m - p * arm,
                    LoadKind::Uplift | Weight => resisting += p * arm - sense * m,
                    Horizontal => {
                        resisting += p * arm;
                        turning += sense * m;
                    }
                }
            }
            (resisting, turning)
        });
        let edge =
            |&(resisting, turning): &(f64, f64)| turning.abs() < 1e-6 * size || resisting < 1e-6 * size;
        if outcome.full.is_lifted() || factors.iter().any(edge) {
            continue;
        }
        let factor = |(resisting, turning): (f64, f64)| {
            if turning > 0.0 { resisting / turning } else { f64::INFINITY }
        };
        let [about_o, about_o_prime] = factors.map(factor);
        let expected = about_o.min(about_o_prime);
        let found = outcome.gross.overturning();
        if (about_o / about_o_prime - 1.0).abs() > 1e-9 {
            let lesser = if about_o < about_o_prime { Corner::O } else { Corner::OPrime };
            assert_eq!(outcome.gross.is_about_heel(), lesser == outcome.actions.heel, "{situation:?}");
        }
        assert!(
            found == expected || (found / expected - 1.0).abs() < 1e-9,
            "{situation:?}: {found}, {expected}"
        );
        let inside = !matches!(outcome.stability.bearing, Bearing::OutsideBase);
        if (found - 1.0).abs() > 1e-9 {
            assert_eq!(found >= 1.0, inside, "{situation:?}: {found}");
        }
        seen[usize::from(found < 1.0)] += 1;
        seen[2] += u32::from(found.is_finite() && about_o_prime < about_o);
    }
    assert!(seen.iter().all(|&count| count > tries(80)), "{seen:?}");
}

/// A pressure under the base that only turns, up at one corner and down at the other, turns as uplift does: 2 W' against W'.
#[test]
fn a_couple_under_the_base_turns() {
    let body = Body::new(4.0, 2.0, 1e4).unwrap();
    let weight = body.mass() * G;
    for sense in [1.0, -1.0] {
        let couple = Wrench { x: 0.0, p: 0.0, m: sense * weight };
        let couple = Load::variable(LoadSource::Uplift, LoadKind::Uplift, couple);
        let outcome = Situation::new(body, 0.6, G).unwrap().with_weight().with(couple).outcome().unwrap();
        assert_eq!((outcome.actions.uplift, outcome.actions.uplift_moment), (0.0, weight));
        assert_eq!((outcome.gross.about_heel, outcome.gross.about_toe), (2.0, f64::INFINITY));
    }
}

/// A reaction in the middle has no eccentricity, however its arm is rounded; any other has some, however little. A weight borne by uplift
/// to the last newton presses nowhere.
#[test]
fn an_eccentricity_is_none_or_some() {
    for i in 1..200 {
        let body = Body::new(0.1 * f64::from(i), 0.3 * f64::from(i), 1234.567 / f64::from(i)).unwrap();
        let standing = Situation::new(body, 0.6, G).unwrap().with_weight();
        let base = body.base_width();
        let stability = |m: f64, p: f64| {
            let load = Load::variable(LoadSource::Uplift, LoadKind::Uplift, Wrench { x: 0.0, p, m });
            standing.clone().with(load).outcome().unwrap().stability
        };
        let weight = body.mass() * G;
        for uplift in [0.0, 0.1, 0.7] {
            assert_eq!(stability(0.0, -uplift * weight).eccentricity(base), Some(0.0), "{i}");
        }
        for share in [1e-13, 1e-6, 0.4, 3.0] {
            let eccentricity = stability(share * base * weight, 0.0).eccentricity(base).unwrap();
            assert!(
                (eccentricity / base - share).abs() <= 1e-15 + 1e-12 * share,
                "{i} {share} {eccentricity}"
            );
        }
        let Stability { resultant_arm, bearing, .. } = stability(0.0, -weight);
        assert_eq!((resultant_arm, bearing), (None, Bearing::Lifted));
    }
}

/// A wall of 8 m by 12 m and 2.4 t/m³ between water of 11 m and 4 m, by hand: m g 4 m = 9040.9 kN; under the base 26 m × 9.81 × 64/6
/// = 2720.6 kN; on the sides 9.81 (11³ − 4³)/6 = 2071.5 kN. By gross moments 9040.9/4792.1 = 1.887, by Goda's 6320.3/2071.5 = 3.051.
#[test]
fn a_head_difference_by_gross_moments_and_by_goda_s() {
    let body = Body::of_density(8.0, 12.0, 2400.0).unwrap();
    for (left, right) in [(4.0, 11.0), (11.0, 4.0)] {
        let water = StillWater::new(&body, left, right, 1000.0).unwrap();
        let situation = Situation::new(body, 0.6, G).unwrap().with_weight().with_all(water.loads(&body, G));
        let outcome = situation.outcome().unwrap();
        assert!((outcome.gross.buoyancy_moment / 1e3 - 2720.64).abs() < 0.01);
        assert!((outcome.gross.buoyancy / 1e3 - 9.81 * 7.5 * 8.0).abs() < 1e-9);
        assert!((outcome.gross.overturning() - 1.8866).abs() < 5e-5, "{}", outcome.gross.overturning());
        assert!((outcome.stability.overturning() - 3.0510).abs() < 5e-5);
        assert!(outcome.gross.is_about_heel());
    }
}

/// Up to its departure the body rests, and beyond it does not, as the response at single load factors says.
#[test]
fn a_departure_is_where_rest_ends() {
    let mut random = Random(62);
    let mut seen = [0; 3];
    for _ in 0..tries(5_000).max(200) {
        let situation = random_situation(&mut random);
        let verdict_at = |factor: f64| situation.at(factor).unwrap().verdict;
        let departure = situation.outcome().unwrap().departure;
        match departure {
            Departure::Never => {
                assert!([0.0, 1.0, 1e6].iter().all(|&factor| verdict_at(factor) == Some(Verdict::REST)));
                seen[0] += 1;
            }
            Departure::AtOnce { permanent, verdict: into } => {
                assert!(permanent, "only on an edge: {situation:?}");
                assert_ne!(verdict_at(0.0), Some(Verdict::REST));
                assert_eq!(verdict_at(1e-12), into, "{situation:?}");
                seen[1] += 1;
            }
            Departure::At { factor, verdict: into } => {
                for share in [0.0, 0.3, 0.7, 1.0 - 1e-9] {
                    assert_eq!(verdict_at(factor * share), Some(Verdict::REST), "{situation:?} {factor}");
                }
                assert_eq!(verdict_at(factor * (1.0 + 1e-9)), into, "{situation:?} {factor}");
                assert_ne!(into, Some(Verdict::REST));
                seen[2] += 1;
            }
        }
        let into = match departure {
            Departure::Never => None,
            Departure::AtOnce { verdict, .. } | Departure::At { verdict, .. } => verdict,
        };
        assert_eq!(departure.verdict(), into);
        assert_eq!(departure.mode(), into.and_then(Verdict::mode));
        assert_eq!(into.is_none(), departure == Departure::Never);
        assert!(into != Some(Verdict::REST));
    }
    assert!(seen.iter().all(|&count| count > tries(125)), "{seen:?}");
}

/// A part of the load that is nothing beside the rest does not lead the path out of the range of numbers.
#[test]
fn a_part_that_is_next_to_nothing_changes_nothing() {
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    for tiny in [0.0, 1e-30, 1e-45, 1e-60, 1e-200, 5e-324] {
        let push = Wrench { x: -5000.0, p: -tiny, m: 0.0 };
        let push = Load::variable(LoadSource::Force, Horizontal, push);
        let situation = Situation::new(body, 0.6, 10.0).unwrap().with_weight().with(push);
        let outcome = situation.outcome().unwrap();
        assert_eq!(
            outcome.departure,
            Departure::At { factor: 1.2, verdict: Some(Begins(Mode::SlideLeft)) },
            "{tiny:e}"
        );
        assert_eq!(outcome.path.last().unwrap().to, f64::INFINITY);
    }
    // A load that small, alone, is a load still: 10⁻⁴⁰ N against μ m g of 6 kN.
    let push = Load::variable(LoadSource::Force, Horizontal, Action::horizontal(-1e-40, 1.0));
    let situation = Situation::new(body, 0.6, 10.0).unwrap().with_weight().with(push);
    assert!((situation.outcome().unwrap().departure.load_factor() / 6e43 - 1.0).abs() < 1e-12);
}

/// At the edge between sliding and turning the permanent loads alone make the body slide; with any share of a load that turns
/// it, it turns at once, and that is how it departs.
#[test]
fn what_moves_at_once_moves_as_the_load_begins() {
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    // γ = 1, k = 1 at k' = ½: CD at μ = 1 − ½.
    let push = Load::permanent(LoadSource::Force, Horizontal, Action::horizontal(-10_000.0, 1.5));
    let turn = Wrench { x: 0.0, p: 0.0, m: 1.0 };
    let variable = |wrench: Wrench| Load::variable(LoadSource::Other, Horizontal, wrench);
    let situation = Situation::new(body, 0.5, 10.0).unwrap().with_weight().with(push);
    let departure = |situation: Situation| situation.outcome().unwrap().departure;
    let at_once = |mode| Departure::AtOnce { verdict: Some(Begins(mode)), permanent: true };
    assert_eq!(departure(situation.clone()), at_once(Mode::SlideLeft));
    assert_eq!(departure(situation.clone().with(variable(turn))), at_once(Mode::SlideRockOLeft));
    assert_eq!(departure(situation.with(variable(turn * -1.0))), at_once(Mode::SlideLeft));
}

/// The mode at the full load after a rise, by following the load up in small steps and keeping what began for as long as it is
/// consistent.
#[test]
fn a_rise_keeps_what_began() {
    let mut random = Random(63);
    let mut kept = 0;
    for _ in 0..tries(3_000).max(30) {
        // Strong friction on a squat body under a low force: where several modes are consistent.
        let body = Body::new(random.uniform(1.0, 4.0), 2.0, 1000.0).unwrap();
        let k = random.uniform(1.0, 12.0);
        let push = Action::horizontal(-k * 1000.0 * G, random.uniform(0.1, 0.9));
        let situation = Situation::new(body, random.uniform(1.3, 5.0), G).unwrap().with_weight();
        let situation = situation.with(Load::variable(LoadSource::Force, Horizontal, push));
        let outcome = situation.outcome().unwrap();
        if outcome.path.iter().any(|stage| stage.to - stage.from < 1e-2 && stage.from < 1.0) {
            continue;
        }
        let mut mode = Mode::Rest;
        for step in 0..=500 {
            let response = situation.at(f64::from(step) / 500.0 * (1.0 - 1e-9)).unwrap();
            if mode == Mode::Rest || !response.modes.contains(mode) {
                mode = response.mode().unwrap();
            }
        }
        assert_eq!(outcome.risen(), Some(mode), "{situation:?}");
        kept += u32::from(outcome.full.mode() != Some(mode));
    }
    assert!(kept > 0);
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    let push = Load::variable(LoadSource::Force, Horizontal, Action::horizontal(-50_000.0, 0.5));
    let outcome = Situation::new(body, 3.0, 10.0).unwrap().with_weight().with(push).outcome().unwrap();
    // γ = 1, k' = −½, k = 5, μ = 3: SL, RO and SRO- are consistent, and it has rocked since k = 2.
    assert_eq!((outcome.full.mode(), outcome.risen()), (Some(Mode::SlideLeft), Some(Mode::RockO)));
    // μ m g is 5 kN: with a load of 5 kN the body has come to the limit of rest, and not beyond.
    let push = Load::variable(LoadSource::Force, Horizontal, Action::horizontal(-5_000.0, 1.0));
    let outcome = Situation::new(body, 0.5, 10.0).unwrap().with_weight().with(push).outcome().unwrap();
    assert_eq!(outcome.departure, Departure::At { factor: 1.0, verdict: Some(Begins(Mode::SlideLeft)) });
    assert_eq!((outcome.full.mode(), outcome.risen()), (Some(Mode::Rest), Some(Mode::Rest)));
}

/// In SI units too a motion obeys Newton's laws, moves as a rigid body, and its reaction makes it; with and without the report's
/// closed form.
#[test]
fn a_motion_in_si_units_obeys_the_laws() {
    let mut random = Random(64);
    let mut seen = [0, 0];
    for i in 0..tries(2_000).max(200) {
        let situation = match i % 2 {
            0 => random_situation(&mut random),
            _ => {
                let body = Body::new(random.uniform(5.0, 20.0), random.uniform(5.0, 20.0), 2e5).unwrap();
                let push = Action::horizontal(random.uniform(-4e6, 4e6), random.uniform(0.0, body.height()));
                let push = Load::variable(LoadSource::Force, Horizontal, push);
                Situation::new(body, random.uniform(0.1, 2.0), G).unwrap().with_weight().with(push)
            }
        };
        let full = situation.outcome().unwrap().full;
        let (body, wrench, motion) = (situation.body(), full.wrench, full.motion.unwrap());
        let (b1, b2, d) = (body.heel_distance(), body.toe_distance(), body.centroid_height());
        let spin = |arm: f64| arm * motion.theta_ddot;
        let turning = [motion.f_x * d, motion.f_y * motion.xi, wrench.m];
        let added = body.mass() + situation.added_mass();
        for (left, terms) in [
            (added * motion.x_ddot, &[motion.f_x, wrench.x][..]),
            (body.mass() * motion.y_ddot, &[motion.f_y, -wrench.p]),
            (spin(body.moment_of_inertia()), &turning),
            (motion.slip, &[motion.x_ddot, spin(d)]),
            (motion.lift_o, &[motion.y_ddot, spin(-b1)]),
            (motion.lift_o_prime, &[motion.y_ddot, spin(b2)]),
        ] {
            let size: f64 = terms.iter().map(|term| term.abs()).sum();
            assert!((left - terms.iter().sum::<f64>()).abs() <= 1e-9 * size, "{situation:?} {motion:?}");
        }
        seen[usize::from(full.effective.is_some())] += u32::from(motion.theta_ddot != 0.0);
    }
    assert!(seen.iter().all(|&count| count > tries(50)), "{seen:?}");
}

/// Source, kind and growth of each kind of load; its wrench by hand.
#[test]
fn loads_say_what_they_are() {
    use LoadSource::{Buoyancy, HorizontalInertia, ShakenWater, StillWater as Water, VerticalInertia};
    let body = Body::new(10.0, 8.0, 1e5).unwrap();
    let told = |loads: &[Load]| -> Vec<(LoadSource, LoadKind, bool)> {
        loads.iter().map(|load| (load.source, load.kind, load.permanent)).collect()
    };
    let water = StillWater::new(&body, 3.0, 5.0, 1e3).unwrap();
    assert_eq!((water.left(), water.right(), water.density()), (3.0, 5.0, 1e3));
    assert_eq!(
        told(&water.loads(&body, G)),
        [(Buoyancy, Weight, true), (Water, Horizontal, true), (Water, Horizontal, true)]
    );
    let level = StillWater::new(&body, 8.0, 8.0, 1e3).unwrap();
    assert_eq!(told(&level.loads(&body, G)), [(Buoyancy, Weight, true)]);
    assert!(
        StillWater::new(&body, 8.001, 0.0, 1e3).is_err() && StillWater::new(&body, 0.0, -0.1, 1e3).is_err()
    );
    assert!(StillWater::new(&body, 0.0, 0.0, 0.0).is_err());

    for grows in [false, true] {
        let uplift = Uplift::new(2e4, 3e4, grows).unwrap();
        assert_eq!((uplift.left(), uplift.right(), uplift.grows()), (2e4, 3e4, grows));
        let load = uplift.load(&body);
        assert_eq!(told(std::slice::from_ref(&load)), [(LoadSource::Uplift, LoadKind::Uplift, !grows)]);
        let Wrench { x, p, m } = load.action.wrench(&body, G, Pose::UPRIGHT);
        // 20 kPa all over, and 10 kPa at O' falling to nothing at O: 50 kN at 20/3 m from O.
        assert_eq!((x, p), (0.0, -2.5e5));
        assert!((m - 5e4 * (20.0 / 3.0 - 5.0)).abs() < 1e-9);
    }
    assert!(Uplift::new(-1.0, 0.0, true).is_err() && Uplift::new(0.0, f64::NAN, true).is_err());

    let quake = Earthquake::new(2.0, -1.5).unwrap();
    assert_eq!((quake.horizontal(), quake.vertical()), (2.0, -1.5));
    assert!(Earthquake::new(f64::INFINITY, 0.0).is_err() && Earthquake::new(0.0, f64::NAN).is_err());
    let inertia = (HorizontalInertia, Horizontal, false);
    assert_eq!(told(&Earthquake::new(2.0, 0.0).unwrap().loads(&AddedMass::NONE)), [inertia]);
    assert_eq!(told(&quake.loads(&AddedMass::of(1e3).unwrap())), [inertia, (VerticalInertia, Weight, false)]);
    // 10 m on the left, 5 m on the right: four fifths and one fifth of the mass, each at 0.40142 of its depth.
    let added = AddedMass::beside(1e3, &[10.0, 5.0]).unwrap();
    assert!((added.mass() / (0.54275 * 1e3 * 125.0) - 1.0).abs() < 1e-5);
    assert!((added.height().unwrap() / (0.40142 * (0.8 * 10.0 + 0.2 * 5.0)) - 1.0).abs() < 2e-5);
    let loads = quake.loads(&added);
    assert_eq!(told(&loads), [inertia, (ShakenWater, Horizontal, false), (VerticalInertia, Weight, false)]);
    let [body_s, water_s, weight_s] = [0, 1, 2].map(|i| loads[i].action.wrench(&body, G, Pose::UPRIGHT));
    assert_eq!(body_s, Wrench { x: -2e5, p: 0.0, m: 0.0 });
    assert_eq!((water_s.x, water_s.p), (-2.0 * added.mass(), 0.0));
    assert!((water_s.m - 2.0 * added.mass() * (added.height().unwrap() - 4.0)).abs() < 1e-6);
    assert_eq!(weight_s, Wrench { x: 0.0, p: -1.5e5, m: 0.0 });
    assert_eq!(AddedMass::beside(1e3, &[0.0, 0.0]).unwrap(), AddedMass::NONE);
    for (density, depth) in [(-1e3, 5.0), (0.0, 5.0), (1e3, -5.0), (1e3, f64::NAN)] {
        assert!(AddedMass::beside(density, &[depth]).is_err(), "{density} {depth}");
    }
    assert_eq!((AddedMass::NONE.mass(), AddedMass::NONE.height()), (0.0, None));
    assert_eq!(AddedMass::of(7.0).unwrap().height(), None);
    assert!(AddedMass::of(-1.0).is_err());
}

/// A diagram keeps its points, and a push that has shrunk to nothing is a push still.
#[test]
fn loads_keep_what_they_are_given() {
    let points =
        vec![PressureAt { position: 1.0, pressure: 3e3 }, PressureAt { position: 2.5, pressure: -1e3 }];
    assert_eq!(PressureDiagram::new(points.clone()).unwrap().points(), points);
    for magnitude in [0.0, 1e3] {
        let push = HorizontalForce::new(magnitude, 2.0, Slip::Left).unwrap().load();
        assert_eq!((push.kind, push.permanent), (Horizontal, false));
    }
}

/// Without a horizontal force the heel is the corner that the moment turns the body about.
#[test]
fn the_heel_follows_the_force_and_else_the_moment() {
    let body = Body::new(4.0, 2.0, 1e4).unwrap();
    let heel = |x: f64, m: f64| {
        let turn = Load::variable(LoadSource::Other, Horizontal, Wrench { x, p: 0.0, m });
        let situation = Situation::new(body, 0.6, 10.0).unwrap().with_weight().with(turn);
        situation.outcome().unwrap().actions.heel
    };
    assert_eq!([heel(0.0, 0.0), heel(0.0, 1.0), heel(-1.0, -5.0)], [Corner::O; 3]);
    assert_eq!([heel(0.0, -1.0), heel(1.0, 5.0)], [Corner::OPrime; 2]);
    // Whatever kind of load turns it, and all together.
    let under = |turns: &[(LoadKind, f64)]| {
        let turn = |&(kind, m)| Load::variable(LoadSource::Other, kind, Wrench { x: 0.0, p: 0.0, m });
        let situation =
            Situation::new(body, 0.6, 10.0).unwrap().with_weight().with_all(turns.iter().map(turn));
        situation.outcome().unwrap().actions.heel
    };
    for kind in [Weight, LoadKind::Uplift, Horizontal] {
        assert_eq!([under(&[(kind, -1.0)]), under(&[(kind, 1.0)])], [Corner::OPrime, Corner::O]);
    }
    assert_eq!(under(&[(Weight, -3.0), (LoadKind::Uplift, -2.0), (Horizontal, 4.0)]), Corner::OPrime);
    assert_eq!(under(&[(Weight, -3.0), (LoadKind::Uplift, 2.0), (Horizontal, 2.0)]), Corner::O);
}

/// A force does the work of its wrench: its moment about C is the rate at which F·r grows with θ, at any pose.
#[test]
fn a_moment_is_the_rate_of_work() {
    let body = Body::new(10.0, 8.0, 1e5).unwrap().with_centroid(0.5, 3.0).unwrap();
    let mut random = Random(64);
    for _ in 0..200 {
        let at = BodyPoint { x: random.uniform(-5.0, 5.0), y: random.uniform(0.0, 8.0) };
        let (right, up) = (random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        let theta = random.uniform(-3.0, 3.0);
        let work = |theta: f64| {
            let (x, y) = (at.x - 0.5, at.y - 3.0);
            right * (x * theta.cos() - y * theta.sin()) + up * (x * theta.sin() + y * theta.cos())
        };
        let rate = (work(theta + 1e-5) - work(theta - 1e-5)) / 2e-5;
        let load = Load::variable(LoadSource::Force, Horizontal, Action::Force { at, right, up });
        let situation = Situation::new(body, 0.6, G).unwrap().with_weight().with(load);
        // Twice the force, beside the weight, which has no moment.
        let Wrench { x, p, m } = situation.wrench_at(2.0, Pose { theta });
        assert!((m - 2.0 * rate).abs() < 1e-8, "{at:?} {theta}: {m} {rate}");
        assert!((x - 2.0 * right).abs() < 1e-12 && (p - (1e5 * G - 2.0 * up)).abs() < 1e-9);
    }
}

/// A situation keeps what it is given; a response and a stage tell the other consistent modes from the one reported.
#[test]
fn a_situation_keeps_what_it_is_given() {
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    let push = Load::variable(LoadSource::Force, Horizontal, Action::horizontal(-10_000.0, 0.5));
    let plain = Situation::new(body, 3.0, 10.0).unwrap().with_weight().with(push.clone());
    let situation =
        plain.clone().with_kinetic_friction(2.5).unwrap().with_added_mass(AddedMass::of(200.0).unwrap());
    assert_eq!((situation.body(), situation.gravity()), (&body, 10.0));
    assert_eq!((situation.static_friction(), situation.kinetic_friction()), (3.0, 2.5));
    assert_eq!((plain.kinetic_friction(), situation.added_mass()), (3.0, 200.0));
    assert_eq!((situation.loads().len(), &situation.loads()[1]), (2, &push));
    assert!(plain.clone().with_kinetic_friction(3.0).is_ok());
    // γ = 1, k' = −½, k = 5, μ = 3.
    let full = plain.at(5.0).unwrap();
    assert_eq!(
        (full.modes.len(), full.others().to_string().as_str(), full.is_unique()),
        (3, "RO SRO-", false)
    );
    let rests = plain.at(1.0).unwrap();
    assert_eq!((rests.others().len(), rests.is_unique(), rests.is_lifted()), (0, true, false));
    let stage = plain.path().unwrap().into_iter().find(|stage| stage.from < 5.0 && stage.to > 5.0).unwrap();
    assert_eq!((stage.mode(), stage.others()), (full.mode(), full.others()));
    // Without variable loads there is no way to go, with nothing else there is.
    assert!(Situation::new(body, 3.0, 10.0).unwrap().with_weight().outcome().unwrap().path.is_empty());
    assert!(!Situation::new(body, 3.0, 10.0).unwrap().with(push).outcome().unwrap().path.is_empty());
    // Nothing presses a body without weight.
    let weightless = Situation::new(body, 0.5, 10.0).unwrap();
    assert!(weightless.at(1.0).unwrap().is_lifted());
    assert_eq!(weightless.at(1.0).unwrap().mode(), Some(Mode::Rest));
}

/// Only the report's own situation is the report's point: one horizontal force beside the weight of a uniform body, with one
/// friction and no added mass.
#[test]
fn the_report_s_problem_is_told_from_others() {
    let body = Body::new(2.0, 4.0, 1000.0).unwrap();
    let push = |right: f64, up: f64| {
        let action = Action::Force { at: BodyPoint { x: 0.3, y: 3.0 }, right, up };
        Load::variable(LoadSource::Force, Horizontal, action)
    };
    let on = |body: Body| Situation::new(body, 0.6, 10.0).unwrap().with_weight();
    let in_air = on(body).with(push(-5000.0, 0.0));
    let point = in_air.in_air().unwrap().point;
    assert_eq!((point.gamma(), point.k_prime(), point.k(), point.mu()), (2.0, 0.5, 0.5, 0.6));
    assert!(on(body).with(push(5000.0, 0.0)).in_air().unwrap().mirrored);
    assert_eq!(on(body).with(push(0.0, 0.0)).in_air().map(|reduced| reduced.mirrored), Some(false));
    let others = [
        on(body),
        on(body).with(push(-5000.0, 1.0)),
        on(body).with(push(-5000.0, 0.0)).with(push(-1.0, 0.0)),
        on(body).with(Load { permanent: true, ..push(-5000.0, 0.0) }),
        Situation::new(body, 0.6, 10.0).unwrap().with(push(-5000.0, 0.0)),
        on(body.with_centroid(0.1, 2.0).unwrap()).with(push(-5000.0, 0.0)),
        in_air.clone().with_kinetic_friction(0.5).unwrap(),
        in_air.clone().with_added_mass(AddedMass::of(1.0).unwrap()),
    ];
    for other in &others {
        assert!(other.in_air().is_none(), "{other:?}");
    }
    // Any wrench that presses and pushes is a point still, of an ordinary body.
    let wrench = Wrench { x: -5000.0, p: 8000.0, m: 0.0 };
    assert!(others[..5].iter().all(|other| other.effective(&wrench).is_some()));
    assert!(others[5..].iter().all(|other| other.effective(&wrench).is_none()));
    for wrench in [Wrench { x: 0.0, ..wrench }, Wrench { p: 0.0, ..wrench }, Wrench { p: -1.0, ..wrench }] {
        assert!(in_air.effective(&wrench).is_none());
    }
    // At another factor, by the wrench: the same to rounding.
    let twice = in_air.at(2.0).unwrap().effective.unwrap().point;
    assert_eq!((twice.k(), twice.k_prime()), (1.0, 0.5));
}

/// The plane of a situation holds, at its own friction, the modes of its path, and at any other those of the same body there.
#[test]
fn the_plane_of_a_situation_is_the_plane_of_its_loads() {
    let mut random = Random(65);
    for _ in 0..tries(60).max(6) {
        let situation = random_situation(&mut random);
        let up_to = random.uniform(0.5, 3.0);
        let regions = situation.plane(up_to).unwrap();
        let ratio = situation.kinetic_friction() / situation.static_friction();
        for _ in 0..100 {
            let (λ, μ) = (random.uniform(0.0, up_to), random.uniform(0.0, 2.0));
            let at = Situation::new(*situation.body(), μ, G).unwrap().with_all(situation.loads().to_vec());
            let at = at.with_kinetic_friction(μ * ratio).unwrap();
            let at = at.with_added_mass(*situation.moved_water());
            let holders =
                regions.iter().filter(|region| region.contains(λ, μ)).map(|region| Some(region.mode));
            assert_eq!(holders.collect::<Vec<_>>(), [at.at(λ).unwrap().mode()], "{situation:?} {λ} {μ}");
        }
    }
}

/// The stages up to a load factor are cut there, and none begins beyond.
#[test]
fn a_path_is_cut_at_a_load_factor() {
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    let push = Load::variable(LoadSource::Force, Horizontal, Action::horizontal(-10_000.0, 0.5));
    // RE to λ = 2, RO to 4, then SL: three stages.
    let path = Situation::new(body, 3.0, 10.0).unwrap().with_weight().with(push).path().unwrap();
    let ends = |largest| -> Vec<(f64, f64)> {
        Stage::up_to(&path, largest).iter().map(|stage| (stage.from, stage.to)).collect()
    };
    assert_eq!(ends(1.5), [(0.0, 1.5)]);
    assert_eq!(ends(2.0), [(0.0, 2.0)]);
    assert_eq!(ends(2.5), [(0.0, 2.0), (2.0, 2.5)]);
    assert_eq!(Stage::up_to(&path, 2.5)[1].mode(), Some(Mode::RockO));
}
