//! Bodies near rest under noise: thousands of tiny impacts, which every shaking keeps starting afresh. Nothing hangs, a state goes on at
//! every event, and no energy is lost from the account.

mod common;

use common::Random;
use standfast::contact::Block;
use standfast_motion::{End, History, Impact, Keep, MotionOutcome, MotionProblem, simulate};

/// Noise of `count` samples under an envelope that rises and falls, smoothed a little or not at all.
fn noise(random: &mut Random, count: usize, step: f64, peak: f64) -> History {
    let smooth = [0.0, 0.5, 0.9][random.of(3)];
    let mut value = 0.0;
    let mut values: Vec<f64> = (0..count)
        .map(|i| {
            let share = i as f64 / count as f64;
            let envelope = (4.0 * share).min(1.0) * (-3.0 * (share - 0.4).max(0.0)).exp();
            value = smooth * value + (1.0 - smooth) * (random.unit() + random.unit() + random.unit() - 1.5);
            envelope * value
        })
        .collect();
    let most = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    values.iter_mut().for_each(|value| *value *= peak / most);
    History::samples(step, &values).unwrap()
}

/// A block in half widths and its g, on a base that trembles about as much as it takes to tip or to slide it.
fn shaken(random: &mut Random, slips: bool) -> MotionProblem {
    let γ = random.between(1.2, 8.0);
    let mut block = Block::uniform(γ, if slips { random.between(0.6, 1.1) / γ } else { 1.5 / γ + 0.2 });
    if random.of(3) == 0 {
        (block.b1, block.b2) = (random.between(0.7, 1.0), random.between(0.7, 1.0));
    }
    if random.of(4) == 0 {
        block.mu_s *= random.between(1.0, 1.3);
    }
    let mut problem = MotionProblem::new(block, 1.0);
    let yields = block.mu_s.min(block.b1.min(block.b2) / γ);
    // 200 samples a second of a body whose √(B/g) is between 0.05 s and 0.4 s.
    let step = 0.005 / random.between(0.05, 0.4);
    let peak = yields * random.between(1.01, 2.5);
    problem.base.horizontal = Some(noise(random, 2000, step, peak));
    if random.of(2) == 0 {
        problem.base.vertical = Some(noise(random, 2000, step, 0.5 * peak.min(0.8)));
    }
    problem
}

fn account(outcome: &MotionOutcome) -> f64 {
    let terms =
        [outcome.work, outcome.friction_loss, outcome.impact_loss, outcome.kinetic, outcome.potential];
    outcome.energy_residual().abs() / terms.into_iter().fold(1e-12, |most: f64, term| most.max(term.abs()))
}

/// Each law over bodies that slip and bodies that do not.
#[test]
fn micro_rocking_goes_on() {
    let (mut ends, mut impacts, mut most) = ([0; 5], 0, 0);
    for seed in 0..600 {
        let mut random = Random::new(7919 + seed);
        let slips = seed % 2 == 0;
        let mut problem = shaken(&mut random, slips);
        problem.impact = match seed % 3 {
            0 => Impact::Inelastic,
            1 => Impact::Ratio(random.between(0.5, 1.0) * problem.largest_ratio()),
            _ => Impact::Ratio(random.between(0.9, 0.999) * problem.largest_ratio()),
        };
        let outcome = simulate(&problem, Keep::default()).unwrap();
        assert!(
            !matches!(outcome.end, End::NoContinuation | End::TooManyEvents),
            "{seed}: {:?} after {} events, {problem:?}",
            outcome.end,
            outcome.events.len()
        );
        assert!(account(&outcome) <= 1e-10, "{seed}: {:e}", account(&outcome));
        ends[outcome.end as usize] += 1;
        impacts += outcome.impacts;
        most = most.max(outcome.events.len());
    }
    // Enough of each, or the test says little.
    assert!(ends[End::AtRest as usize] > 500 && ends[End::Overturned as usize] > 5, "{ends:?}");
    assert!(impacts > 200_000 && most > 2000, "{impacts} impacts, {most} events at most");
}
