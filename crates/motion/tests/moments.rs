//! What is known at a moment: equations of motion, energies and contact, all along random motions.

mod common;

use common::{Random, problem};
use standfast::Corner;
use standfast_motion::{Impact, Keep, simulate};

/// Moments about C are ρ²θ̈, whatever touches; reactions press; energies balance; corners that touch stay on the base and, without slip, in their place.
#[test]
fn equations_hold_at_every_moment() {
    let (mut both, mut one, mut none) = (0, 0, 0);
    for seed in 0..60 {
        let mut random = Random::new(seed + 500);
        let mut problem = problem(&mut random);
        if seed % 3 == 0 {
            (problem.impact, problem.restitution) = (Impact::Poisson, 0.4);
        }
        let outcome = simulate(&problem, Keep { steps: true }).unwrap();
        let block = &problem.block;
        let size = 1.0 + outcome.work.abs() + outcome.friction_loss + outcome.impact_loss;
        for i in 0..400 {
            let t = outcome.t_final * (f64::from(i) + random.unit()) / 400.0;
            let Some(now) = outcome.moment(t, false) else { continue };
            let (sin, cos) = now.theta.sin_cos();
            let lever = |corner: Corner| {
                let r = if corner == Corner::O { -block.b1 } else { block.b2 };
                [r * cos + block.d * sin, block.d * cos - r * sin]
            };
            let [left, right] = [Corner::O, Corner::OPrime].map(lever);
            let turns = left[0] * now.normal[0] + right[0] * now.normal[1];
            let along = match now.tangential {
                Some([one, other]) => left[1] * one + right[1] * other,
                None => block.d * now.friction,
            };
            let scale = 1.0 + now.loads[1].abs() + now.loads[2].abs() + block.d * now.loads[0].abs();
            let off = turns + along + now.loads[2] - block.rho2 * now.alpha;
            assert!(off.abs() < 1e-8 * scale, "{seed} {t}: {off} {now:?}");
            assert!(now.normal.iter().all(|normal| *normal > -1e-7 * scale), "{seed} {t}: {now:?}");
            let balance = now.kinetic + now.potential + now.friction_loss + now.impact_loss - now.work;
            assert!(balance.abs() < 1e-9 * size, "{seed} {t}: {balance} {now:?}");
            assert!(now.gaps.iter().all(|gap| *gap > -1e-9), "{seed} {t}: {now:?}");
            assert!(now.slide.abs() <= outcome.max_slide * (1.0 + 1e-9) + 1e-12, "{seed} {t}");
            let position = outcome.at(t).unwrap();
            assert_eq!((now.x, now.theta, now.slide), (position.x, position.theta, position.slide));
            // A difference of the positions beside it, where they are of one piece.
            let beside = [-1e-5, 1e-5].map(|step| outcome.moment(t + step, false).unwrap());
            let last = outcome.events.last().unwrap().t;
            if beside.iter().all(|other| other.state == now.state) && t > 1e-4 && t + 1e-4 < last {
                let rate = (beside[1].x - beside[0].x) / 2e-5;
                assert!(
                    (rate - now.velocity[0]).abs() < 1e-3 * (1.0 + rate.abs()),
                    "{seed} {t}: {rate} {now:?}"
                );
            }
            match now.state.corner() {
                Some(_) => one += 1,
                None if now.normal == [0.0; 2] => none += 1,
                None => both += 1,
            }
        }
    }
    assert!(both > 2000 && one > 2000 && none > 20, "{both} {one} {none}");
}

/// At a moment at which a load jumps there is what was before it, and what is after.
#[test]
fn at_a_jump_there_are_two_moments() {
    use standfast::contact::Block;
    use standfast_motion::{History, MotionProblem};
    let mut problem = MotionProblem::new(Block::uniform(0.3, 0.2), 1.0);
    problem.base.horizontal = Some(History::rect(0.5, 1.0).unwrap().starting(1.0).unwrap());
    let outcome = simulate(&problem, Keep { steps: true }).unwrap();
    let [before, after] = [true, false].map(|before| outcome.moment(1.0, before).unwrap());
    assert_eq!((before.loads[0], after.loads[0]), (0.0, -0.5));
    assert!((after.acceleration[0] + 0.3).abs() < 1e-12 && before.acceleration[0] == 0.0);
    // Friction to slip at the base as a whole; its moment parts the reaction.
    assert!((after.friction - 0.2).abs() < 1e-12 && after.tangential.is_none());
    assert!((after.normal[0] + after.normal[1] - 1.0).abs() < 1e-12);
}
