//! The motion each mode begins with, in the report's closed form.
//!
//! It satisfies ẍ = f_x − k, ÿ = f_y − 1 and (1+γ²)/3 θ̈ = γ f_x + ξ f_y + γ k k' (3.9–3.11), Coulomb's law and
//! non-penetration to round-off. Where a quantity vanishes on a boundary (θ̈ where rocking begins, the slip of a
//! corner where it sticks), it is computed without cancellation, so its sign is right next to the boundary too.

use super::Point;
use crate::mode::Mode;
use crate::motion::Motion;
use crate::sign::{Need, signed_slenderness};

/// The motion of `mode`, which has to be consistent at `point`.
pub(super) fn motion(point: &Point, mode: Mode) -> Motion {
    let Point { gamma: γ, k_prime, k, mu: μ } = *point;
    let g = signed_slenderness(γ, k_prime);
    // σ θ̈ > 0 lifts the far corner, with σ = 1 about O and −1 about O'.
    let σ = g.signum();
    match mode {
        // ξ = −k(1+k')γ (4.8) and ξ = −(μ + k k')γ (4.17) lie on the base; rounding is not to push them off it.
        Mode::Rest => both_corners(0.0, k, (0.0 - γ * (k * (1.0 + k_prime))).clamp(-1.0, 1.0)),
        Mode::SlideLeft => both_corners(μ - k, μ, (0.0 - γ * (μ + k * k_prime)).clamp(-1.0, 1.0)),
        Mode::RockO | Mode::RockOPrime => {
            // (3.14–3.16, 4.36–4.39)
            let tip = point.polynomials(Need::Value, |p| [p.tip]).tip;
            let λ = 3.0 * tip / (4.0 * (1.0 + γ * γ));
            about_corner(σ, λ, 0.0 - g * λ, k - g * λ, 0.0)
        }
        // (3.30, 3.37; 4.64, 4.76)
        Mode::SlideRockOLeft => slipping_left(point, σ),
        // (3.43, 3.45): (3.30) and (3.37) with −μ for μ
        Mode::SlideRockORight => {
            let turn = g * (k * k_prime - μ) - 1.0;
            let regularity = 4.0 + γ * γ + 3.0 * μ * γ;
            let slip_right = point.polynomials(Need::Value, |p| [p.slip_right]).slip_right;
            slipping(point, σ, -μ, turn, -slip_right, regularity)
        }
        Mode::SlideRockOPrimeLeft if σ < 0.0 => slipping_left(point, σ),
        // (4.89, 4.95): (3.30) and (3.37) with −γ for γ
        Mode::SlideRockOPrimeLeft => {
            let toe = point.polynomials(Need::Value, |p| [p.toe]).toe;
            let tip = -γ * k * (1.0 + k_prime) - 1.0;
            let slip = 4.0 * (1.0 + γ * γ) * (μ - k) + 3.0 * tip * (μ - γ);
            slipping(point, -1.0, μ, -toe, slip, 4.0 + γ * γ + 3.0 * μ * γ)
        }
        Mode::SlideRight | Mode::SlideRockOPrimeRight | Mode::Flight => {
            unreachable!("{mode} under a force that points left")
        }
    }
}

/// Rest or sliding: no rotation, the reaction anywhere on the base.
fn both_corners(x_ddot: f64, f_x: f64, xi: f64) -> Motion {
    Motion {
        x_ddot,
        y_ddot: 0.0,
        theta_ddot: 0.0,
        f_x,
        f_y: 1.0,
        xi,
        slip: x_ddot,
        lift_o: 0.0,
        lift_o_prime: 0.0,
    }
}

/// Rotation at λ = σθ̈ > 0 about the corner at ξ = −σ.
fn about_corner(σ: f64, λ: f64, x_ddot: f64, f_x: f64, slip: f64) -> Motion {
    let far = 2.0 * λ;
    let (lift_o, lift_o_prime) = if σ > 0.0 { (0.0, far) } else { (far, 0.0) };
    Motion {
        x_ddot, y_ddot: λ, theta_ddot: σ * λ, f_x, f_y: 1.0 + λ, xi: -σ, slip, lift_o, lift_o_prime
    }
}

/// Slide-rock to the left about the corner that the force can tip the body about.
fn slipping_left(point: &Point, σ: f64) -> Motion {
    let p = point.polynomials(Need::Value, |p| [p.turn, p.slip_left, p.regularity]);
    slipping(point, σ, point.mu, p.turn, p.slip_left, p.regularity)
}

/// Slide-rock about the corner σ under f_x = f f_y, f = ±μ: λ = 3 turn/regularity, ẍ_O = slip/regularity.
fn slipping(point: &Point, σ: f64, f: f64, turn: f64, slip: f64, regularity: f64) -> Motion {
    let λ = 3.0 * turn / regularity;
    let slip = slip / regularity;
    // Rather than f_x − k, which cancels where the centre of mass hardly moves.
    let x_ddot = slip - σ * point.gamma * λ;
    about_corner(σ, λ, x_ddot, f * (1.0 + λ), slip)
}
