//! A base of 200 fibres, stiff, damped, without tension, yielding, with friction, under a load that comes at once: integrated in time,
//! it knows nothing of modes, and moves as the closed forms say.

mod common;

use common::Random;
use standfast::Verdict::Begins;
use standfast::contact::Block;
use standfast::ground::strength::{CrushMotion, solve};
use standfast::{Mode, Modes, Wrench};

/// Mean accelerations ẍ, ÿ, turn̈ between t = ½ and 1, of small displacements: geometry stays.
fn fibres(block: &Block, wrench: &Wrench, strength: f64) -> [f64; 3] {
    const N: usize = 200;
    let Block { b1, b2, d, rho2, m_x, m_y, mu_k, .. } = *block;
    let width = (b1 + b2) / N as f64;
    let (stiff, slow) = (2e7, 1e-4);
    // Twice the critical damping of heave.
    let damping = 2.0 * 2.0 * (stiff * m_y / (b1 + b2)).sqrt();
    let place: Vec<f64> = (0..N).map(|i| (i as f64 + 0.5) * width - b1).collect();
    let mut yielded = [0.0; N];
    // Pressed by P alone, evenly; the load comes at t = 0.
    let (mut y, mut turn) = (-wrench.p / (stiff * (b1 + b2)), 0.0);
    let [mut vx, mut vy, mut spin] = [0.0; 3];
    let dt = 1e-5;
    let mut half = [0.0; 3];
    for step in 0..100_000 {
        if step == 50_000 {
            half = [vx, vy, spin];
        }
        let (mut n, mut moment) = (0.0, 0.0);
        for (x, yielded) in place.iter().zip(&mut yielded) {
            let pressed = -(y + x * turn) - *yielded;
            if stiff * pressed > strength {
                *yielded += pressed - strength / stiff;
            }
            if pressed > 0.0 {
                let p =
                    (stiff * pressed.min(strength / stiff) - damping * (vy + x * spin)).clamp(0.0, strength);
                n += p * width;
                moment += p * width * x;
            }
        }
        let f_x = -mu_k * n * ((vx + d * spin) / slow).clamp(-1.0, 1.0);
        vx += dt * (wrench.x + f_x) / m_x;
        vy += dt * (n - wrench.p) / m_y;
        spin += dt * (f_x * d + moment + wrench.m) / rho2;
        y += dt * vy;
        turn += dt * spin;
    }
    [vx - half[0], vy - half[1], spin - half[2]].map(|change| 2.0 * change)
}

/// Of 60 wrenches on bodies of all kinds that begin to move, each acceleration is within 0.5 % of the motion; bodies that rest, rest.
#[test]
fn fibres_move_as_the_closed_forms_say() {
    let mut random = Random(871);
    let (mut moving, mut seen) = (0, Modes::NONE);
    while moving < 60 {
        let (b1, b2) = (random.uniform(0.7, 1.3), random.uniform(0.7, 1.3));
        let d = random.uniform(0.4, 2.5);
        let mu = random.uniform(0.2, 1.2);
        let block = Block {
            b1,
            b2,
            d,
            rho2: (1.0 + d * d) / 3.0 * random.uniform(0.8, 1.2),
            m_x: random.uniform(1.0, 1.3),
            m_y: 1.0,
            mu_s: mu,
            mu_k: mu,
        };
        let p = random.uniform(0.5, 1.0);
        let x = -random.uniform(0.1, 2.0);
        let wrench = Wrench { x, p, m: -x * d * random.uniform(-0.9, 1.2) };
        let strength = p / (b1 + b2) / random.uniform(0.05, 0.7);
        let answer = solve(&block, &wrench, strength).unwrap();
        let Some(Begins(mode)) = answer.verdict() else { continue };
        // Far from Painlevé's bound, and not so slow that the springs' own motion counts.
        let CrushMotion { motion, .. } = answer.motion(mode).unwrap();
        let size = motion.x_ddot.abs() + motion.y_ddot.abs() + motion.theta_ddot.abs() * (1.0 + d);
        if mode == Mode::Rest || size < 0.3 || mode.corner().is_some() && motion.theta_ddot.abs() < 0.1 {
            continue;
        }
        if mu > 0.8 * answer.bound() || seen.contains(mode) && mode == Mode::SlideLeft && random.coin() {
            continue;
        }
        let found = fibres(&block, &wrench, strength);
        let ours = [motion.x_ddot, motion.y_ddot, motion.theta_ddot];
        for (found, ours) in found.into_iter().zip(ours) {
            assert!(
                (found - ours).abs() <= 0.005 * size,
                "{mode}: {found} {ours} of {size}: {block:?} {wrench:?} {strength}"
            );
        }
        seen.insert(mode);
        moving += 1;
    }
    assert!(seen.len() >= 4, "{seen}");
}
