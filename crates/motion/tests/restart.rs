//! A motion that is left at a moment and goes on from there is the same motion.

mod common;

use common::{Random, problem};
use standfast::Slip;
use standfast::contact::Block;
use standfast_motion::divergence::Divergence;
use standfast_motion::{
    Going, History, Impact, Initial, Keep, MotionError, MotionOutcome, MotionProblem, simulate,
};

/// What is left of a motion from a moment on, followed from there.
fn restarted(problem: &MotionProblem, whole: &MotionOutcome, t: f64) -> MotionOutcome {
    let initial = whole.moment(t, false).unwrap().initial();
    simulate(&MotionProblem { initial, ..problem.clone() }, Keep { steps: true }).unwrap()
}

/// Stopped anywhere, within a state or just after an event, and begun again there: the rest is the same events, at the same times, to the same end,
/// within 1e-12 of half the base times the divergence of the motion.
#[test]
fn the_rest_is_the_same() {
    let (mut within, mut at_events, mut flying, mut slipping) = (0, 0, 0, 0);
    for seed in 0..300 {
        let mut random = Random::new(seed + 9000);
        let mut problem = problem(&mut random);
        match seed % 4 {
            0 => (problem.impact, problem.restitution) = (Impact::Poisson, 0.4),
            1 => problem.impact = Impact::Housner,
            _ => {}
        }
        let whole = simulate(&problem, Keep { steps: true }).unwrap();
        let last = whole.events.last().unwrap().t;
        let divergence = Divergence::of(&problem, &whole).unwrap().value;
        let bound = 1e-12 * (100.0 + divergence);
        if bound > 1e-6 {
            continue;
        }
        let events: Vec<f64> = whole.events.iter().map(|event| event.t).filter(|t| *t < last).collect();
        let mut moments: Vec<f64> = (0..12).map(|_| last * random.unit()).collect();
        let count = moments.len();
        moments.extend(events.iter().take(40));
        for (place, t) in moments.into_iter().enumerate().filter(|(_, t)| *t < last) {
            let start = whole.moment(t, false).unwrap();
            let rest = restarted(&problem, &whole, t);
            let told = format!("{seed} {t} {start:?}");
            assert_eq!(rest.end, whole.end, "{told}");
            assert_eq!(rest.events[0].state, start.state, "{told}");
            for (one, other, size) in [
                (rest.slide, whole.slide, 1.0),
                (rest.theta, whole.theta, 1.0),
                (rest.t_rest.unwrap_or(0.0), whole.t_rest.unwrap_or(0.0), 1e3),
            ] {
                assert!((one - other).abs() <= bound * size, "{told}: {one} {other} {bound}");
            }
            let follows = |outcome: &MotionOutcome| -> Vec<_> {
                let events = outcome.events.iter().filter(|event| event.t > t + 1e-9);
                events.map(|event| (event.why, event.state, event.t)).collect()
            };
            let [ours, theirs] = [&rest, &whole].map(follows);
            let kinds = |events: &[(_, _, f64)]| -> Vec<_> {
                events.iter().map(|event| (event.0, event.1)).collect()
            };
            assert_eq!(kinds(&ours), kinds(&theirs), "{told}");
            for (one, other) in ours.iter().zip(&theirs) {
                assert!((one.2 - other.2).abs() <= 1e-9 + 1e4 * bound, "{told}: {one:?} {other:?}");
            }
            for part in 0..20 {
                let at = t + (last - t) * f64::from(part) / 20.0;
                let [one, other] = [&rest, &whole].map(|outcome| outcome.at(at).unwrap());
                let off =
                    (one.x - other.x).abs().max((one.y - other.y).abs()).max((one.theta - other.theta).abs());
                assert!(off <= bound, "{told} {at}: {off} {bound}");
            }
            within += usize::from(place < count);
            at_events += usize::from(place >= count);
            flying += usize::from(start.state == standfast::Mode::Flight);
            slipping += usize::from(start.state.slip().is_some());
        }
    }
    assert!(
        within > 1000 && at_events > 1000 && flying > 50 && slipping > 500,
        "{within} {at_events} {flying} {slipping}"
    );
}

/// What is said to touch does touch, and what is said to stick does not slip; else the gap or the velocity is named.
#[test]
fn what_does_not_touch_is_refused() {
    let at = |initial: Initial| {
        let mut problem = MotionProblem::new(Block::uniform(2.0, 0.5), 1.0);
        problem.base.horizontal = Some(History::half_sine(0.6, 2.0).unwrap());
        simulate(&MotionProblem { initial, ..problem }, Keep::default())
    };
    let tilted = Initial { theta: 0.1, touching: Some([true, false]), ..Initial::default() };
    assert!(at(tilted).is_ok());
    let wrong = at(Initial { touching: Some([false, true]), ..tilted });
    assert!(
        matches!(wrong, Err(MotionError::Apart { gap, .. }) if (gap - 2.0 * 0.1f64.sin()).abs() < 1e-12),
        "{wrong:?}"
    );
    assert!(matches!(at(Initial { touching: Some([true, true]), ..tilted }), Err(MotionError::Apart { .. })));
    assert!(matches!(at(Initial { gap: 1e-6, ..tilted }), Err(MotionError::Apart { .. })));
    assert!(at(Initial { gap: 1e-10, ..tilted }).is_ok());
    let named = |initial| match at(initial) {
        Err(MotionError::Value { name, .. }) => name,
        other => panic!("{other:?}"),
    };
    let sticks = Initial { omega: 0.2, going: Some(Going::Sticks), ..tilted };
    assert!(at(sticks).is_ok());
    assert_eq!(named(Initial { vx: Some(0.1), ..sticks }), "vx");
    assert_eq!(named(Initial { vy: Some(0.1), ..sticks }), "vy");
    assert_eq!(named(Initial { omega: 0.1, touching: Some([true, true]), ..Initial::default() }), "omega");
    assert_eq!(named(Initial { time: -1.0, ..Initial::default() }), "time");
    let slips = Some(Going::Slips(Slip::Left));
    assert_eq!(at(Initial { going: slips, ..Initial::default() }), Err(MotionError::SlipOfNone));
    let flies = Initial { gap: 0.1, touching: Some([false, false]), ..Initial::default() };
    assert_eq!(at(Initial { going: slips, ..flies }), Err(MotionError::SlipOfNone));
    let mut late = MotionProblem::new(Block::uniform(2.0, 0.5), 1.0);
    (late.t_max, late.initial.time) = (Some(3.0), 3.0);
    assert!(matches!(late.check(), Err(MotionError::Value { name: "t_max", .. })));
}

/// Where friction to stick is above friction to slip, a slip so slow that it might be none goes on if it is said to, and a corner that sticks under a
/// push that would slip it sticks.
#[test]
fn between_both_frictions_the_slip_is_told() {
    let mut block = Block::uniform(0.3, 0.3);
    block.mu_s = 0.6;
    let mut problem = MotionProblem::new(block, 1.0);
    problem.base.horizontal = Some(History::rect(-0.45, 4.0).unwrap());
    problem.initial = Initial { time: 1.0, touching: Some([true, true]), ..Initial::default() };
    let first = |going| {
        let initial = Initial { going, ..problem.initial };
        simulate(&MotionProblem { initial, ..problem.clone() }, Keep::default()).unwrap()
    };
    assert_eq!(first(Some(Going::Sticks)).slide, 0.0);
    let slips = first(Some(Going::Slips(Slip::Right)));
    // Pushed by 0.45 against 0.3 for 3, it slides 0.15 · 9 / 2, and then stops after 0.45² / (2 · 0.3).
    assert!((slips.slide - (0.675 + 0.45 * 0.45 / 0.6)).abs() < 1e-9, "{}", slips.slide);
    assert!((slips.t_rest.unwrap() - 5.5).abs() < 1e-9);
}
