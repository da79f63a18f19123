//! The largest slide and rotation of a motion are those of its series: nothing at any moment is more, and there it is as much.

mod common;

use common::{Random, problem};
use standfast::Mode;
use standfast::contact::Block;
use standfast_motion::{
    End, History, Initial, Keep, LoadInTime, MotionOutcome, MotionProblem, Position, simulate,
};

/// Largest loss by rounding and the end of a series, of a length or an angle near one.
const NOTHING: f64 = 1e-11;

fn followed(problem: &MotionProblem) -> MotionOutcome {
    simulate(problem, Keep { steps: true }).expect("a problem")
}

/// Moments of a motion: evenly, and on both sides of every event.
fn moments(outcome: &MotionOutcome) -> Vec<f64> {
    let end = outcome.events.last().map_or(0.0, |event| event.t);
    let even = (0..=2000).map(|i| end * f64::from(i) / 2000.0);
    even.chain(outcome.events.iter().flat_map(|event| [event.t - 1e-13, event.t])).collect()
}

/// Displacement of the corner that touches, of O in flight and on both, worked out from the pose.
fn foot(block: &Block, at: &Position) -> f64 {
    let r = if at.state.corner() == Some(standfast::Corner::OPrime) { block.b2 } else { -block.b1 };
    at.x + r * at.theta.cos() + block.d * at.theta.sin() - r
}

/// Holds the largest slide and rotation to the series; of a body that stood upright at first.
fn hold(problem: &MotionProblem, outcome: &MotionOutcome, seed: u64) {
    assert!(outcome.slide.abs() <= outcome.max_slide, "{seed}: {} {}", outcome.slide, outcome.max_slide);
    assert!(outcome.theta.abs() <= outcome.max_theta, "{seed}: {} {}", outcome.theta, outcome.max_theta);
    for t in moments(outcome) {
        let at = outcome.at(t).unwrap();
        let slide = foot(&problem.block, &at);
        assert!((at.slide - slide).abs() <= NOTHING, "{seed} {t}: {} {slide}", at.slide);
        assert!(slide.abs() <= outcome.max_slide + NOTHING, "{seed} {t}: {slide} {}", outcome.max_slide);
        assert!(at.theta.abs() <= outcome.max_theta + NOTHING, "{seed} {t}: {at:?} {}", outcome.max_theta);
    }
    // There it is as much, at the latest just before a corner meets the base.
    let near = |t: f64| [t, t - 1e-12].map(|t| outcome.at(t).unwrap());
    let told = near(outcome.t_max_slide).map(|at| (at.slide.abs() - outcome.max_slide).abs());
    assert!(told.into_iter().any(|off| off <= NOTHING), "{seed}: {outcome:?}");
    let told = near(outcome.t_max_theta).map(|at| (at.theta.abs() - outcome.max_theta).abs());
    assert!(told.into_iter().any(|off| off <= NOTHING), "{seed}: {outcome:?}");
}

/// Motions that are cut short anywhere, and those that go on to their end.
#[test]
fn nothing_of_a_motion_is_more_than_its_largest() {
    let (mut slips, mut rocks) = (0, 0);
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let mut problem = problem(&mut random);
        if seed % 4 != 0 {
            problem.t_max = Some(random.between(0.1, 6.0));
        }
        let outcome = followed(&problem);
        hold(&problem, &outcome, seed);
        if outcome.end == End::Time {
            let last = outcome.events.last().unwrap().state;
            slips += usize::from(last.slip().is_some());
            rocks += usize::from(last.corner().is_some());
        }
    }
    assert!(slips > 50 && rocks > 30, "{slips} {rocks}");
}

/// Bodies that are thrown, tumble and come down anywhere: the slide of O turns back in flight.
#[test]
fn nothing_of_a_flight_is_more_than_its_largest() {
    let (mut overturned, mut inside) = (0, 0);
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let mut problem = problem(&mut random);
        let sign = if random.of(2) == 0 { 1.0 } else { -1.0 };
        problem.initial = Initial {
            theta: 0.0,
            omega: sign * random.between(0.0, 1.5),
            vx: Some(random.between(-0.6, 0.6)),
            vy: Some(random.between(1.6, 3.0)),
            gap: random.between(0.0, 0.3),
            ..Initial::default()
        };
        problem.t_max = Some(random.between(0.5, 12.0));
        let outcome = followed(&problem);
        hold(&problem, &outcome, seed);
        let at = outcome.at(outcome.t_max_slide).unwrap();
        let event = outcome.events.iter().any(|event| (event.t - outcome.t_max_slide).abs() < 1e-9);
        inside += usize::from(at.state == Mode::Flight && !event);
        overturned += usize::from(outcome.overturned() && at.state == Mode::Flight);
    }
    assert!(overturned > 20 && inside > 20, "{overturned} {inside}");
}

/// A flight in which the rotation turns back twice within one series: under a couple that grows evenly ω = k(t − 1)(t − 4), so that
/// θ = k(t³/3 − 5t²/2 + 4t) is 11k/6 at 1, −8k/3 at 4 and −5k/6 at the end, 5. The force follows the body, so that its moment stays F.
#[test]
fn of_two_turns_in_one_series_the_larger_is_the_largest() {
    for k in [1e-6, -1e-6] {
        let block = Block::uniform(1.0, 0.5);
        let couple = |t: f64| block.rho2 * k * (2.0 * t - 5.0);
        let history = History::points(&[0.0, 6.0], &[couple(0.0), couple(6.0)]).unwrap();
        let mut problem = MotionProblem::new(block, 1.0);
        problem.loads = vec![LoadInTime { at: [0.0, -1.0], direction: [1.0, 0.0], follows: true, history }];
        problem.initial = Initial { omega: 4.0 * k, gap: 20.0, ..Initial::default() };
        problem.t_max = Some(5.0);
        let outcome = followed(&problem);
        assert_eq!((outcome.end, outcome.steps.len()), (End::Time, 1));
        let expected = 8.0 / 3.0 * k.abs();
        assert!((outcome.max_theta - expected).abs() <= 1e-12 * expected, "{}", outcome.max_theta);
        assert!((outcome.t_max_theta - 4.0).abs() <= 1e-9, "{}", outcome.t_max_theta);
        assert!((outcome.theta + 5.0 / 6.0 * k).abs() <= 1e-12 * expected, "{}", outcome.theta);
    }
}
