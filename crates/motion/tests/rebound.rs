//! Motions with a rebound: closed forms, and what every law has to keep.

mod common;

use common::{Random, problem};
use standfast::History;
use standfast::contact::Block;
use standfast_motion::{End, Impact, Initial, Keep, MotionOutcome, MotionProblem, Why, simulate};

fn followed(problem: &MotionProblem) -> MotionOutcome {
    simulate(problem, Keep::default()).unwrap()
}

fn bouncing(block: Block, e: f64) -> MotionProblem {
    let mut problem = MotionProblem::new(block, 1.0);
    (problem.impact, problem.restitution) = (Impact::Poisson, e);
    problem
}

/// Without restitution each law of a rebound is that without one, to the last digit.
#[test]
fn no_restitution_is_no_rebound() {
    for seed in 0..60 {
        let mut problem = problem(&mut Random::new(seed));
        problem.impact = Impact::Inelastic;
        let without = followed(&problem);
        for law in [Impact::Poisson, Impact::Energetic] {
            problem.impact = law;
            if law == Impact::Poisson {
                assert_eq!(followed(&problem), without, "{seed}");
            }
        }
    }
}

/// The fall that a motion begins with is no bounce, into however many steps loads part it.
#[test]
fn the_first_fall_is_no_bounce() {
    let (height, e) = (0.02, 0.3);
    let mut problem = bouncing(Block::uniform(2.0, 0.5), e);
    problem.initial = Initial { gap: height, ..Initial::default() };
    problem.base.vertical = Some(History::points(&[0.0, 0.05, 0.1], &[0.0, 1e-12, 0.0]).unwrap());
    let outcome = followed(&problem);
    assert!((outcome.max_gap - height * e * e).abs() < 1e-9, "{}", outcome.max_gap);
    assert!(outcome.t_max_gap > (2.0f64 * height).sqrt());
}

/// A block that falls flat from a height comes to rest at √(2H/g)(1 + e)/(1 − e), whatever its shape; slipping, it goes v²/(2μg) + μH, whatever e.
#[test]
fn flat_falls() {
    for (γ, e) in [(0.5, 0.3), (2.0, 0.5), (4.0, 0.7), (1.0, 0.05), (3.0, 0.9)] {
        let mut problem = bouncing(Block::uniform(γ, 0.5), e);
        let height = 0.02;
        problem.initial = Initial { gap: height, ..Initial::default() };
        let outcome = followed(&problem);
        let expected = (2.0f64 * height).sqrt() * (1.0 + e) / (1.0 - e);
        assert!(outcome.at_rest(), "{γ} {e}: {:?}", outcome.end);
        let t_rest = outcome.t_rest.unwrap();
        assert!((t_rest - expected).abs() < 1e-9, "{γ} {e}: {t_rest} {expected}");
        assert!((outcome.max_gap - height * e * e).abs() < 1e-12, "{}", outcome.max_gap);
        assert!(outcome.energy_residual().abs() < 1e-12, "{}", outcome.energy_residual());
        // Friction on its way: the bounces take no part in how far it goes.
        let (v, μ) = (0.4, 0.3);
        let mut problem = bouncing(Block::uniform(0.5 * γ.min(1.0), μ), e);
        problem.initial = Initial { gap: height, vx: Some(v), ..Initial::default() };
        let outcome = followed(&problem);
        let expected = v * v / (2.0 * μ) + μ * height;
        if outcome.max_theta == 0.0 {
            assert!((outcome.slide - expected).abs() < 1e-9, "{γ} {e}: {} {expected}", outcome.slide);
        }
    }
}

/// A block that falls flat while it slips, with a friction of impacts of its own: the impulses of the floor up to the time T of the last bounce are
/// g T, their moment about T is T²/2 − H, and after it the body slides on.
#[test]
fn flat_falls_with_a_friction_of_impacts() {
    let (height, μ, v) = (0.02, 0.3, 0.7);
    for (e, μ_impact) in [(0.3, 0.15), (0.5, 0.45), (0.7, 0.2), (0.1, 0.6), (0.8, 0.25)] {
        let mut problem = bouncing(Block::uniform(0.5, μ), e);
        problem.mu_impact = Some(μ_impact);
        problem.initial = Initial { gap: height, vx: Some(v), ..Initial::default() };
        let outcome = followed(&problem);
        assert!(outcome.at_rest() && outcome.max_theta < 1e-14, "{e} {μ_impact}: {}", outcome.max_theta);
        let t = (2.0f64 * height).sqrt() * (1.0 + e) / (1.0 - e);
        let left = v - μ_impact * t;
        let expected = v * t - μ_impact * (0.5 * t * t - height) + left * left / (2.0 * μ);
        assert!(left > 0.0 && (outcome.slide - expected).abs() < 1e-12, "{e} {μ_impact}: {}", outcome.slide);
        assert!(outcome.energy_residual().abs() < 1e-12, "{}", outcome.energy_residual());
    }
}

/// Bounces within bounces come to an end, whatever friction impacts have: the body rests, turns over, or moves until the time is over.
#[test]
fn bounces_within_bounces_end() {
    let (mut bounces, mut settled) = (0, 0);
    for seed in 0..200 {
        let mut random = Random::new(seed + 3000);
        let mut problem = problem(&mut random);
        (problem.impact, problem.restitution) = match seed % 2 {
            0 => (Impact::Energetic, random.between(0.05, 0.8)),
            _ => (Impact::Poisson, random.between(0.05, 0.8)),
        };
        problem.mu_impact = Some(problem.block.mu_s * random.between(0.3, 1.3));
        problem.initial.theta = random.between(-0.3, 0.3) / problem.block.d;
        let outcome = followed(&problem);
        assert!(
            !matches!(outcome.end, End::NoContinuation | End::TooManyEvents),
            "{seed}: {:?}",
            outcome.end
        );
        let size = 1.0 + outcome.work.abs() + outcome.friction_loss + outcome.impact_loss;
        assert!(outcome.energy_residual().abs() < 1e-10 * size, "{seed}: {}", outcome.energy_residual());
        bounces += outcome.bounces;
        settled += outcome.events.iter().filter(|event| event.why == Why::Settle).count();
    }
    assert!(bounces > 1000 && settled > 100, "{bounces} {settled}");
}

/// The corner that lands gives back e of its impulse: θ̇⁺ = θ̇⁻[r_H − e(1 − r_H)], which leaves rocking as it would be, but for second order in the
/// angle: rest at 6.527, 6.527 and 6.490 √(B/g) (the specification's own integrator).
#[test]
fn a_rebound_of_the_corner_that_lands_leaves_rocking_as_it_is() {
    for (e, rest) in [(0.0, 6.527), (0.3, 6.527), (0.7, 6.490)] {
        let mut problem = bouncing(Block::uniform(2.0, 0.9), e);
        problem.initial.theta = 0.1;
        let outcome = followed(&problem);
        assert!(outcome.at_rest(), "{e}: {:?}", outcome.end);
        let t = outcome.t_rest.unwrap();
        assert!((t - rest).abs() < 1e-3, "{e}: {t} {rest}");
        assert!(outcome.energy_residual().abs() < 1e-10, "{e}: {}", outcome.energy_residual());
        assert_eq!(outcome.bounces > 0, e > 0.0);
    }
}

/// Energy is kept in all that moves, whatever bounces.
#[test]
fn energy_is_kept() {
    let mut bounces = 0;
    for seed in 0..120 {
        let mut random = Random::new(seed + 1000);
        let mut problem = problem(&mut random);
        (problem.impact, problem.restitution) = match seed % 3 {
            0 => (Impact::Energetic, random.between(0.1, 0.9)),
            1 => (Impact::Housner, random.between(0.1, 0.9)),
            _ => (Impact::Poisson, random.between(0.05, 0.95)),
        };
        let outcome = followed(&problem);
        let size = 1.0 + outcome.work.abs() + outcome.friction_loss + outcome.impact_loss;
        assert!(
            outcome.energy_residual().abs() < 1e-10 * size,
            "{seed}: {:?} {}",
            outcome.end,
            outcome.energy_residual()
        );
        assert!(outcome.impact_loss >= -1e-12 * size, "{seed}: {}", outcome.impact_loss);
        bounces += outcome.bounces;
    }
    assert!(bounces > 300, "{bounces}");
}
