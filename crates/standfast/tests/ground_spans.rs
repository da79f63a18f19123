//! Spans of friction and departures on a base that gives way, against the decision at single frictions and the whole load path.

mod common;

use common::Random;
use standfast::contact::Block;
use standfast::ground::bearing::{self, BearingBlock, Ground, GroundLaw};
use standfast::ground::strength::{self, departure, friction_spans};
use standfast::loads::{Action, Load, LoadKind, LoadSource};
use standfast::{Body, Departure, Mode, Modes, Situation, Span, Verdict, Wrench};

fn wrench(random: &mut Random, sizes: [f64; 3]) -> Wrench {
    let [x, p, m] = sizes.map(|size| random.uniform(-size, size));
    Wrench { x, p, m }
}

fn ratio(random: &mut Random) -> f64 {
    if random.coin() { 1.0 } else { random.uniform(0.0, 1.0) }
}

/// At random frictions, and just beside every end.
fn frictions(random: &mut Random, spans: &[Span]) -> Vec<f64> {
    assert_eq!((spans[0].from, spans.last().unwrap().to), (0.0, f64::INFINITY));
    assert!(spans.windows(2).all(|pair| pair[0].to == pair[1].from && pair[0].from < pair[0].to));
    let asked = (0..8).map(|_| 10f64.powf(random.uniform(-1.5, 1.5)));
    let beside = spans.iter().skip(1).flat_map(|span| [span.from * (1.0 - 1e-8), span.from * (1.0 + 1e-8)]);
    asked.collect::<Vec<_>>().into_iter().chain(beside).collect()
}

fn at(spans: &[Span], μ: f64) -> (&Span, bool) {
    let span = spans.iter().find(|span| span.from <= μ && μ < span.to).unwrap();
    (span, spans.iter().any(|span| (span.from / μ - 1.0).abs() < 1e-9))
}

/// A base that crushes: any block, any wrench, any ratio of slip to stick, any strength.
#[test]
fn on_a_base_that_crushes_spans_are_the_decision_at_every_friction() {
    let mut random = Random(31);
    let mut several = 0;
    for _ in 0..common::tries(4000) {
        let ratio = ratio(&mut random);
        let block = random.block(ratio);
        let wrench = wrench(&mut random, [2.0, 1.5, 3.0]);
        let strength = random.log(0.2, 50.0);
        let spans = friction_spans(&block, &wrench, strength, f64::INFINITY).unwrap();
        several += u32::from(spans.iter().any(|span| span.modes.len() > 1));
        for μ in frictions(&mut random, &spans) {
            let (span, thin) = at(&spans, μ);
            let block = Block { mu_s: μ, mu_k: μ * ratio, ..block };
            let there = strength::solve(&block, &wrench, strength).unwrap();
            assert!(
                thin || (span.verdict, span.modes) == (there.verdict(), there.modes),
                "{block:?} {wrench:?} {strength} μ = {μ}: {span:?} {there:?}"
            );
        }
    }
    assert!(several > common::tries(4000) / 40, "{several}");
}

fn ground(random: &mut Random) -> Ground {
    match random.pick(&[0, 1, 2]) {
        0 => Ground::envelope(random.log(0.5e6, 60e6)).unwrap(),
        law => {
            let law = if law == 1 { GroundLaw::Ec7 } else { GroundLaw::Hansen };
            let ground = Ground::new(law, random.uniform(20.0, 50.0), random.uniform(5e3, 2e4)).unwrap();
            let surcharge = if random.coin() { random.uniform(0.0, 4e4) } else { 0.0 };
            let cohesion = if random.coin() { random.uniform(0.0, 4e4) } else { 0.0 };
            let ground = ground.with_surcharge(surcharge).unwrap().with_cohesion(cohesion).unwrap();
            if random.coin() { ground.with_length(random.log(0.5, 50.0)).unwrap() } else { ground }
        }
    }
}

/// Ground that fails: the rigid mode, borne or not, by the library's reaction of a situation in newtons and metres.
#[test]
fn on_ground_that_fails_spans_are_the_decision_at_every_friction() {
    let mut random = Random(47);
    let mut seen = [0; 3];
    for _ in 0..common::tries(2000) {
        let (ground, ratio) = (ground(&mut random), ratio(&mut random));
        let block = random.block(ratio);
        let mut wrench = wrench(&mut random, [0.8, 0.7, 0.9]);
        wrench.p += 0.5;
        let (length, force) = (random.log(1.0, 15.0), random.log(5e4, 5e6));
        let under = BearingBlock::new(ground, length, force).unwrap();
        let spans = under.friction_spans(&block, &wrench, f64::INFINITY).unwrap();
        for μ in frictions(&mut random, &spans) {
            let (span, thin) = at(&spans, μ);
            let block = Block { mu_s: μ, mu_k: μ * ratio, ..block };
            let there = under.decide(&block, &wrench).unwrap().verdict;
            let modes: Modes = there.and_then(Verdict::mode).into_iter().collect();
            assert!(
                thin || (span.verdict, span.modes) == (there, modes),
                "{ground:?} {block:?} {wrench:?} {length} {force} μ = {μ}: {span:?} {there:?}"
            );
            let kind = match there {
                Some(Verdict::Begins(Mode::Rest)) => 0,
                Some(Verdict::BearingFailure) => 1,
                _ => 2,
            };
            seen[kind] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > common::tries(2000) / 4), "{seen:?}");
}

/// A body in newtons and metres, pushed at a height and lifted or loaded off its middle.
fn situation(random: &mut Random) -> Situation {
    let (width, height) = (random.uniform(2.0, 20.0), random.uniform(2.0, 20.0));
    let mass = width * height * random.uniform(1200.0, 2600.0);
    let weight = mass * 9.81;
    let body = Body::new(width, height, mass).unwrap();
    let force = |action| Load::variable(LoadSource::Force, LoadKind::Horizontal, action);
    let push = Action::horizontal(weight * random.uniform(-0.9, 0.9), height * random.uniform(0.0, 1.0));
    let lift = Action::vertical(&body, weight * random.uniform(-0.4, 0.4), width * random.uniform(0.1, 0.9));
    let still = Action::horizontal(weight * random.uniform(-0.1, 0.1), height * random.uniform(0.0, 1.0));
    let still = Load::permanent(LoadSource::Force, LoadKind::Horizontal, still);
    let situation = Situation::new(body, random.uniform(0.2, 0.9), 9.81).unwrap().with_weight();
    let situation = situation.with(force(push)).with(force(lift)).with(still);
    let kinetic = situation.static_friction() * ratio(random);
    situation.with_kinetic_friction(kinetic).unwrap()
}

/// Block, permanent and variable wrench of a situation in its units.
fn reduced(situation: &Situation) -> (Block, Wrench, Wrench) {
    let at =
        |factor: f64| situation.reduced_wrench(&situation.wrench_at(factor, standfast::loads::Pose::UPRIGHT));
    (situation.reduced_block().0, at(0.0), at(1.0) + at(0.0) * -1.0)
}

fn like(found: Departure, path: Departure) -> bool {
    let same = std::mem::discriminant(&found) == std::mem::discriminant(&path);
    let near = match (found.load_factor(), path.load_factor()) {
        (one, other) if one.is_finite() && other > 0.0 => (one / other - 1.0).abs() < 1e-7,
        (one, other) => one == other,
    };
    // What moves it to begin with may be another thing as soon as anything is added.
    same && near && (matches!(found, Departure::AtOnce { .. }) || found.verdict() == path.verdict())
}

/// The departure is that of the whole load path, and what begins is that of the situation.
#[test]
fn departures_are_those_of_the_load_path() {
    let mut random = Random(91);
    let (mut failed, mut slid) = (0, 0);
    for _ in 0..common::tries(600) {
        let situation = situation(&mut random);
        let (block, permanent, variable) = reduced(&situation);
        let (length, weight) = (situation.body().width() / 2.0, situation.body().mass() * 9.81);
        let strength = weight / situation.body().width() / random.uniform(0.02, 0.9);
        let on_stone = strength::outcome(&situation, strength).unwrap().outcome;
        let found = departure(&block, &permanent, &variable, strength * length / weight).unwrap();
        assert!(
            like(found, on_stone.departure),
            "{situation:?} {strength}: {found:?} {:?}",
            on_stone.departure
        );

        let ground = ground(&mut random);
        let on_soil = bearing::outcome(&situation, ground).unwrap().outcome;
        let under = BearingBlock::new(ground, length, weight).unwrap();
        let found = under.departure(&block, &permanent, &variable).unwrap();
        assert!(
            like(found, on_soil.departure),
            "{situation:?} {ground:?}: {found:?} {:?}",
            on_soil.departure
        );
        let decision = under.decide(&block, &(permanent + variable)).unwrap();
        assert_eq!(decision.verdict, on_soil.full.verdict);
        failed += u32::from(found.verdict() == Some(Verdict::BearingFailure));
        slid += u32::from(found.verdict().is_some_and(|verdict| verdict.mode().is_some()));
    }
    assert!(failed > common::tries(600) / 10 && slid > common::tries(600) / 20, "{failed} {slid}");
}
