//! Impacts with a measured ratio at which a body that slips would gain energy: the ratio that is taken, by the root of a quadratic.

mod common;

use common::Random;
use standfast::contact::Block;
use standfast::{Corner, Mode};
use standfast_motion::{Impact, Initial, Keep, Problem, Why, simulate};

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
        let mut problem = Problem::new(block, 1.0);
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
        let (before, after) = (impact.t.next_down(), impact.t);
        let rate = |t: f64| outcome.at(t).unwrap().omega;
        let (ω, ω_after) = (rate(before), rate(after));
        if ω >= -1e-3 || ω_after >= 0.0 {
            continue;
        }
        let (v, v_after) = (outcome.velocity(before).unwrap(), outcome.velocity(after).unwrap());
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
