//! Impacts with a measured ratio: that which is taken where a body that slips would gain energy, by the root of a quadratic; and whether the
//! base can give the impulse that it asks for.

mod common;

use common::Random;
use standfast::contact::Block;
use standfast::{Corner, Mode};
use standfast_motion::{Impact, Initial, Keep, MotionOutcome, MotionProblem, Why, simulate};

/// At θ = 0 a block turns from O to O' with θ̇⁻ < 0. With Λ_n = ẏ⁺ − ẏ⁻, ẏ⁻ = b₁θ̇⁻ and ẏ⁺ = −b₂θ̇⁺, θ̇⁺ = rθ̇⁻, and Λ_t = −sμΛ_n, s = ±1 the
/// slip after it, all per mass, the energy after it is a quadratic in r. What is taken is the larger root at which it is that before, or
/// r itself if that loses.
#[test]
fn a_ratio_that_would_gain_is_the_root_of_the_energy() {
    let mut random = Random::new(14);
    let (mut reduced, mut kept) = (0, 0);
    for _ in 0..6000 {
        let (γ, μ) = (random.between(1.0, 4.0), random.between(0.02, 0.4));
        let block = Block::uniform(γ, μ);
        let mut problem = MotionProblem::new(block, 1.0);
        let asked = random.between(0.6, 0.999) * problem.largest_ratio();
        problem.impact = Impact::Ratio(asked);
        let vx = random.between(-1.5, 1.5);
        let (theta, omega) = (random.between(0.01, 0.05), -random.between(0.3, 1.0));
        problem.initial = Initial { theta, omega, vx: Some(vx), ..Initial::default() };
        let Ok(outcome) = simulate(&problem, Keep { steps: true }) else { continue };
        let Some(place) = outcome.events.iter().position(|event| event.why == Why::Impact) else { continue };
        let impact = &outcome.events[place];
        // From flight it would land otherwise.
        let corners = [outcome.events[place - 1].state, impact.state].map(Mode::corner);
        if corners != [Some(Corner::O), Some(Corner::OPrime)] {
            continue;
        }
        let [before, after] = [true, false].map(|before| outcome.moment(impact.t, before).unwrap());
        let (ω, ω_after) = (before.omega, after.omega);
        if ω >= -1e-3 || ω_after >= 0.0 {
            continue;
        }
        let (v, v_after) = (before.velocity[0], after.velocity[0]);
        let s = (v_after + block.d * ω_after).signum();
        if (v_after + block.d * ω_after).abs() < 1e-9 {
            // It sticks: its friction is less, and there is nothing to reduce.
            continue;
        }
        let rise = block.b1 * ω;
        // Coulomb's law on the impulses.
        let normal = -block.b2 * ω_after - rise;
        assert!((v_after - v + s * μ * normal).abs() < 1e-9, "{v} {v_after} {normal}");
        // 2K⁺(r) = (v − sμ(−b₂ωr − b₁ω))² + (b₂² + ρ²)ω²r², less 2K⁻ = v² + (b₁² + ρ²)ω².
        let (slope, start) = (s * μ * block.b2 * ω, v + s * μ * rise);
        let a = slope * slope + (block.b2 * block.b2 + block.rho2) * ω * ω;
        let b = 2.0 * slope * start;
        let c = start * start - v * v - (block.b1 * block.b1 + block.rho2) * ω * ω;
        let root = (-b + (b * b - 4.0 * a * c).sqrt()) / (2.0 * a);
        let found = ω_after / ω;
        let expected = root.min(asked);
        assert!(
            (found - expected).abs() < 1e-9,
            "γ {γ} μ {μ} s {s}: {found}, expected {expected} of {asked}"
        );
        if root < asked {
            reduced += 1
        } else {
            kept += 1
        }
        assert!(root >= asked || outcome.reduced_impacts > 0);
    }
    assert!(reduced > 50 && kept > 300, "{reduced} {kept}");
}

/// Place of the impulse right of C at the first impact of a body that rocked about a corner b_old to its other side
/// without slip, with θ̇ = −1 before it, towards the corner b_new: Λ_n = m_y(b_new r + b_old), and Λ_t = −m_x d(1 − r)
/// where friction suffices, −μΛ_n where it does not; about C ξΛ_n = ρ²(1 − r) − dΛ_t.
fn place_of_impulse(block: &Block, [old, new]: [f64; 2], ratio: f64, friction: f64) -> f64 {
    let normal = block.m_y * (new * ratio + old);
    let along = (block.m_x * block.d * (1.0 - ratio)).min(friction * normal);
    (block.rho2 * (1.0 - ratio) + block.d * along) / normal
}

/// The first impact of a body that is released where it leans, and nothing after it.
fn first_impact(block: Block, impact: Impact, friction: f64, theta: f64) -> MotionOutcome {
    let mut problem = MotionProblem::new(block, 1.0);
    (problem.impact, problem.mu_impact) = (impact, Some(friction));
    problem.initial.theta = theta;
    let whole = simulate(&problem, Keep::default()).unwrap();
    let met = whole.events.iter().find(|event| event.why == Why::Impact).expect("an impact");
    problem.t_max = Some(met.t + 1e-9);
    let outcome = simulate(&problem, Keep::default()).unwrap();
    assert_eq!(outcome.impacts, 1);
    outcome
}

/// The base cannot give an impulse beside it, and gives any other: of eccentric blocks that fall to either side, at ratios on both sides of that
/// at which the impulse acts at the corner, and anywhere.
#[test]
fn an_impulse_beside_the_base_is_told() {
    let mut random = Random::new(31);
    let (mut beside, mut within, mut slipped) = (0, 0, 0);
    for _ in 0..400 {
        let mut block = Block::uniform(random.between(0.8, 4.0), 20.0);
        (block.b1, block.b2) = (random.between(0.7, 1.2), random.between(0.7, 1.2));
        (block.m_x, block.m_y) = (random.between(1.0, 1.5), random.between(1.0, 1.2));
        let friction = if random.of(2) == 0 { 20.0 } else { random.between(0.02, 0.5) };
        let theta = random.between(0.01, 0.05) * if random.of(2) == 0 { 1.0 } else { -1.0 };
        // θ > 0: it leans on O, and falls to O'.
        let corners = if theta > 0.0 { [block.b1, block.b2] } else { [block.b2, block.b1] };
        let largest = MotionProblem::new(block, 1.0).largest_ratio();
        let place = |ratio: f64| place_of_impulse(&block, corners, ratio, friction);
        // The less is left the farther out it acts: at no ratio, or from one on.
        let (mut low, mut high) = (0.0, largest);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if place(middle) > corners[1] { low = middle } else { high = middle }
        }
        for ratio in [high - 1e-7, high + 1e-7, random.between(0.0, largest)] {
            if !(0.0..=largest).contains(&ratio) {
                continue;
            }
            let outcome = first_impact(block, Impact::Ratio(ratio), friction, theta);
            if outcome.reduced_impacts > 0 {
                continue;
            }
            let expected = place(ratio) > corners[1];
            assert_eq!(outcome.impulse_left_base, expected, "{block:?} {ratio} {friction} {theta}");
            *(if expected { &mut beside } else { &mut within }) += 1;
            slipped += usize::from(place(ratio) < place_of_impulse(&block, corners, ratio, 20.0));
        }
        // The base can give whatever the laws find themselves.
        for law in [Impact::Inelastic, Impact::Housner] {
            assert!(!first_impact(block, law, friction, theta).impulse_left_base);
        }
    }
    assert!(beside > 200 && within > 200 && slipped > 100, "{beside} {within} {slipped}");
}
