//! Series as short as the pieces of a record, beside series of full length.

mod common;

use common::{Random, problem};
use standfast::History;
use standfast::contact::Block;
use standfast_motion::divergence::Divergence;
use standfast_motion::{Impact, Keep, MotionProblem, simulate, simulate_at_length};

/// A shaking like an earthquake, in pieces so short that a series converges at once.
fn shaking(random: &mut Random, peak: f64) -> History {
    let sines: Vec<[f64; 3]> = (0..20)
        .map(|_| [random.between(0.5, 8.0), random.between(0.0, 6.3), random.between(0.3, 1.0)])
        .collect();
    let at = |t: f64| sines.iter().map(|[ω, phase, size]| size * (ω * t + phase).sin()).sum::<f64>();
    let step = random.between(0.01, 0.06);
    let values: Vec<f64> =
        (0..800).map(|i| at(f64::from(i) * step) * (f64::from(i) / 100.0).min(1.0)).collect();
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let values: Vec<f64> = values.into_iter().map(|value| value * peak / largest).collect();
    History::samples(step, &values).unwrap()
}

/// The same events, the same ends, the same places at every moment, within 1e-12 of half the base times the divergence; the balance of energy to 1e-10.
#[test]
fn short_series_say_what_full_ones_say() {
    let (mut events, mut rocked, mut compared) = (0, 0, 0);
    for seed in 0..240 {
        let mut random = Random::new(seed + 70_000);
        let mut problem = match seed % 3 {
            0 => problem(&mut random),
            _ => MotionProblem::new(Block::uniform(random.between(1.5, 9.0), random.between(0.2, 2.0)), 1.0),
        };
        let strength = random.between(0.8, 2.2) / problem.block.d;
        problem.base.horizontal = Some(shaking(&mut random, strength));
        if seed % 2 == 0 {
            problem.base.vertical = Some(shaking(&mut random, 0.3));
        }
        problem.impact = [Impact::Inelastic, Impact::Housner][seed as usize % 2];
        let short = simulate(&problem, Keep { steps: true }).unwrap();
        let long = simulate_at_length(&problem, Keep { steps: true }).unwrap();
        let bound = 1e-12 * (1.0 + Divergence::of(&problem, &short).unwrap().value);
        let size = 1.0 + short.work.abs() + short.friction_loss + short.impact_loss;
        assert!(short.energy_residual().abs() < 1e-10 * size, "{seed}: {}", short.energy_residual());
        if bound > 1e-7 {
            continue;
        }
        assert_eq!(short.end, long.end, "{seed}");
        let kinds = |outcome: &standfast_motion::MotionOutcome| -> Vec<_> {
            outcome.events.iter().map(|event| (event.why, event.state)).collect()
        };
        assert_eq!(kinds(&short), kinds(&long), "{seed}");
        for (one, other, of) in [
            (short.slide, long.slide, "slide"),
            (short.max_slide, long.max_slide, "largest slide"),
            (short.max_theta, long.max_theta, "largest angle"),
            (short.work, long.work, "work"),
            (short.impact_loss, long.impact_loss, "impacts"),
        ] {
            assert!((one - other).abs() <= bound * size, "{seed} {of}: {one} {other} {bound}");
        }
        for i in 0..400 {
            let t = short.t_final * f64::from(i) / 400.0;
            let [one, other] = [&short, &long].map(|outcome| outcome.moment(t, false).unwrap());
            if one.state != other.state {
                continue;
            }
            let off =
                (one.theta - other.theta).abs().max((one.x - other.x).abs()).max((one.y - other.y).abs());
            assert!(off <= bound, "{seed} {t}: {off} {bound}");
            let off = (one.omega - other.omega).abs().max((one.normal[0] - other.normal[0]).abs());
            assert!(off <= 1e3 * bound, "{seed} {t}: {off} {bound}\n{one:?}\n{other:?}");
            rocked += usize::from(one.state.corner().is_some());
        }
        events += short.events.len();
        compared += 1;
    }
    assert!(compared > 120 && events > 5000 && rocked > 10_000, "{compared} {events} {rocked}");
}

/// A problem is the same whatever was followed before it: shakings that are kept are those of the problem.
#[test]
fn a_shaking_that_was_kept_is_that_of_the_problem() {
    let mut random = Random::new(3);
    let (one, other) = (shaking(&mut random, 0.5), shaking(&mut random, 0.5));
    let mut problem = MotionProblem::new(Block::uniform(4.0, 0.8), 1.0);
    let mut slides = |base: &History, gravity: f64| {
        problem.base.horizontal = Some(base.clone());
        problem.gravity = gravity;
        let outcome = simulate(&problem, Keep::default()).unwrap();
        (
            outcome.max_theta,
            outcome.events.len(),
            simulate_at_length(&problem, Keep::default()).unwrap().max_theta,
        )
    };
    let first = [slides(&one, 1.0), slides(&other, 1.0), slides(&one, 1.1)];
    let again = [slides(&one, 1.0), slides(&other, 1.0), slides(&one, 1.1)];
    assert_eq!(first, again);
    assert!(
        first.iter().all(|(short, _, long)| (short - long).abs() < 1e-9)
            && first[0] != first[1]
            && first[0] != first[2]
    );
}
