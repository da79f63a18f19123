//! Properties of every motion, on random ones.

mod common;

use common::{Random, mirrored, problem, shaken};
use standfast::Mode;
use standfast::contact::Block;
use standfast_motion::{End, History, Impact, Keep, MotionOutcome, MotionProblem, Piece, Why, simulate};

const CASES: u64 = 400;

fn run(problem: &MotionProblem) -> MotionOutcome {
    simulate(problem, Keep::default()).expect("a problem")
}

fn story(outcome: &MotionOutcome) -> Vec<(Why, Mode)> {
    outcome.events.iter().map(|event| (event.why, event.state)).collect()
}

/// A motion that a digit too many or too few would make another is no measure of the digits.
fn is_tame(outcome: &MotionOutcome) -> bool {
    outcome.impacts < 60 && outcome.end == End::AtRest
}

/// Energy is accounted for, nothing is gained at impacts and by friction, and every motion ends.
#[test]
fn energy_balances() {
    let (mut ends, mut reduced) = ([0; 5], 0);
    for seed in 0..4 * CASES {
        let problem = problem(&mut Random::new(seed));
        let outcome = run(&problem);
        let largest =
            [outcome.work, outcome.friction_loss, outcome.impact_loss, outcome.potential, outcome.kinetic]
                .into_iter()
                .fold(1e-6, |most: f64, term| most.max(term.abs()));
        assert!(
            outcome.energy_residual().abs() <= 1e-10 * largest,
            "{seed}: {} of {largest}",
            outcome.energy_residual()
        );
        assert!(outcome.friction_loss >= -1e-14 && outcome.impact_loss >= -1e-14, "{seed}");
        assert!(!matches!(outcome.end, End::NoContinuation | End::TooManyEvents), "{seed}: {problem:?}");
        reduced += outcome.reduced_impacts;
        ends[outcome.end as usize] += 1;
    }
    // Enough of each kind, or the test says little.
    assert!(ends[End::AtRest as usize] > 900 && ends[End::Overturned as usize] > 150, "{ends:?}");
    assert!(reduced > 3, "{reduced}");
}

#[test]
fn mirror_image() {
    for seed in 0..CASES {
        let problem = problem(&mut Random::new(seed));
        let (one, two) = (run(&problem), run(&mirrored(&problem)));
        let theirs: Vec<_> = story(&two).into_iter().map(|(why, state)| (why, state.mirrored())).collect();
        assert_eq!(story(&one), theirs, "{seed}");
        // In flight the slide is that of O, which has no mirror image.
        if one.events.last().unwrap().state != Mode::Flight {
            assert!((one.slide + two.slide).abs() < 1e-11, "{seed} {} {}", one.slide, two.slide);
        }
        assert!((one.max_theta - two.max_theta).abs() < 1e-11, "{seed}");
    }
}

/// Lengths times ℓ, times times √ℓ, at the same accelerations; and all accelerations times a factor, times shorter.
#[test]
fn scale() {
    let stretched = |history: &History, time: f64, factor: f64| {
        let pieces = history.pieces().iter().zip(history.times()).map(|(piece, t)| {
            let piece = match *piece {
                Piece::Line { value, slope } => Piece::Line { value, slope: slope / time },
                Piece::Sine { peak, angular_frequency, phase } => {
                    Piece::Sine { peak, angular_frequency: angular_frequency / time, phase }
                }
            };
            (t * time, piece)
        });
        let end = history.times().last().unwrap() * time;
        History::of_pieces(&pieces.collect::<Vec<_>>(), end).unwrap().times_factor(factor)
    };
    for (length, gravity) in [(4.0, 1.0), (0.25, 1.0), (1.0, 9.81), (7.5, 9.81)] {
        for seed in 0..CASES / 4 {
            let problem = problem(&mut Random::new(seed));
            let mut other = problem.clone();
            let block = &mut other.block;
            (block.b1, block.b2, block.d) = (block.b1 * length, block.b2 * length, block.d * length);
            block.rho2 *= length * length;
            let time = f64::sqrt(length / gravity);
            other.gravity = gravity;
            for load in &mut other.loads {
                load.at = load.at.map(|x| x * length);
                load.history = stretched(&load.history, time, gravity);
            }
            for history in [&mut other.base.horizontal, &mut other.base.vertical].into_iter().flatten() {
                *history = stretched(history, time, gravity);
            }
            other.t_max = Some(60.0 * time);
            let (one, two) = (run(&problem), run(&other));
            assert_eq!(one.end, two.end, "{seed}");
            if is_tame(&one) {
                assert!((one.slide - two.slide / length).abs() < 1e-9, "{seed} {length} {gravity}");
                assert!((one.max_theta - two.max_theta).abs() < 1e-9, "{seed} {length} {gravity}");
            }
        }
    }
}

/// Pieces cut in two change nothing; nor does all of it beginning later.
#[test]
fn splitting_and_shifting_pieces() {
    let split = |history: &History| {
        let mut pieces = Vec::new();
        for (piece, pair) in history.pieces().iter().zip(history.times().windows(2)) {
            let τ = 0.37 * (pair[1] - pair[0]);
            let second = match *piece {
                Piece::Line { value, slope } => Piece::Line { value: value + slope * τ, slope },
                Piece::Sine { peak, angular_frequency, phase } => {
                    Piece::Sine { peak, angular_frequency, phase: phase + angular_frequency * τ }
                }
            };
            pieces.extend([(pair[0], *piece), (pair[0] + τ, second)]);
        }
        History::of_pieces(&pieces, *history.times().last().unwrap()).unwrap()
    };
    for seed in 0..CASES {
        let problem = problem(&mut Random::new(seed));
        let changed = |change: &dyn Fn(&History) -> History| {
            let mut other = problem.clone();
            for load in &mut other.loads {
                load.history = change(&load.history);
            }
            for history in [&mut other.base.horizontal, &mut other.base.vertical].into_iter().flatten() {
                *history = change(history);
            }
            other
        };
        let one = run(&problem);
        let mut later = changed(&|history| history.clone().starting(2.75).unwrap());
        later.t_max = Some(62.75);
        for (other, shift) in [(changed(&split), 0.0), (later, 2.75)] {
            let two = run(&other);
            assert_eq!(one.end, two.end, "{seed} {shift}");
            if is_tame(&one) {
                assert!((one.slide - two.slide).abs() < 1e-9, "{seed} {shift} {} {}", one.slide, two.slide);
                assert!((one.max_theta - two.max_theta).abs() < 1e-9, "{seed} {shift}");
                let rested = one.t_rest.unwrap() == 0.0;
                assert!(
                    rested || (one.t_rest.unwrap() + shift - two.t_rest.unwrap()).abs() < 1e-4,
                    "{seed} {shift}"
                );
            }
        }
    }
}

/// A slender block with much friction meets the base as Housner has it, whichever law is asked for.
#[test]
fn much_friction_is_housner() {
    for seed in 0..50 {
        let mut random = Random::new(seed);
        let γ = random.between(1.5, 6.0);
        let mut block = Block::uniform(γ, 0.0);
        (block.mu_s, block.mu_k) = (1.0 / γ + 0.6, 1.0 / γ + 0.6);
        let pulse = History::half_sine(random.between(1.2, 1.6) / γ, random.between(0.5, 1.5)).unwrap();
        let mut problem = shaken(block, pulse);
        let one = run(&problem);
        problem.impact = Impact::Housner;
        let two = run(&problem);
        assert!(one.impacts > 3 && one.max_slide == 0.0, "{seed}");
        assert_eq!((story(&one), one.max_theta), (story(&two), two.max_theta), "{seed}");
        problem.impact = Impact::Ratio((2.0 * γ * γ - 1.0) / (2.0 * (1.0 + γ * γ)));
        let three = run(&problem);
        assert!((one.max_theta - three.max_theta).abs() < 1e-12, "{seed}");
    }
}

/// Reactions, gaps and slips at many moments: N ≥ 0 and gaps ≥ 0, and a corner that sticks stays.
#[test]
fn states_keep_their_conditions() {
    for seed in 0..CASES / 2 {
        let problem = problem(&mut Random::new(seed));
        let outcome = simulate(&problem, Keep { steps: true }).unwrap();
        let block = &problem.block;
        let mut last: Option<standfast_motion::Position> = None;
        for i in 0..=400 {
            let t = outcome.t_final * f64::from(i) / 400.0;
            let at = outcome.at(t).unwrap();
            let gap = |r: f64| at.y - (block.d * at.theta.cos() - r * at.theta.sin());
            let gaps = [gap(-block.b1), gap(block.b2)];
            assert!(gaps.iter().all(|gap| *gap > -1e-11), "{seed} {t} {gaps:?} {:?}", at.state);
            match (at.state, at.state.corner()) {
                (Mode::Flight, _) => {}
                (_, Some(corner)) => assert!(gaps[corner as usize].abs() < 1e-11, "{seed} {t}"),
                (_, None) => assert!(at.theta == 0.0 && gaps[0].abs() < 1e-12, "{seed} {t}"),
            }
            let sticks = |state: Mode| state.slip().is_none() && state != Mode::Flight;
            let between = |last: &standfast_motion::Position| {
                outcome
                    .events
                    .iter()
                    .filter(|event| event.t > last.t && event.t <= t)
                    .all(|event| sticks(event.state))
            };
            if let Some(last) = last.filter(|last| sticks(last.state) && sticks(at.state) && between(last)) {
                assert!((last.slide - at.slide).abs() < 1e-11, "{seed} {t} {} {}", last.slide, at.slide);
            }
            last = Some(at);
        }
    }
}
