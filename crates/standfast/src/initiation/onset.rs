//! The motion each mode begins with, in the report's closed form.
//!
//! It satisfies ẍ = f_x − k, ÿ = f_y − 1 and (1+γ²)/3 θ̈ = γ f_x + ξ f_y + γ k k' (3.9–3.11), Coulomb's law and
//! non-penetration to round-off. Where a quantity vanishes on a boundary (θ̈ where rocking begins, the slip of a
//! corner where it sticks), it is computed without cancellation, so its sign is right next to the boundary too.

use super::Point;
use super::polynomials::{Need, signed_slenderness};
use crate::mode::Mode;
use crate::motion::Motion;

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
        Mode::SlideRockOLeft | Mode::SlideRockOPrimeLeft => {
            // (3.30, 3.37; 4.64, 4.76), and with −γ for γ (4.89, 4.95)
            let g = if mode == Mode::SlideRockOLeft { γ } else { -γ };
            let p = point.polynomials_about(g, Need::Value, |p| [p.turn, p.slip_left, p.regularity]);
            slipping(point, g, μ, 3.0 * p.turn / p.regularity, p.slip_left / p.regularity)
        }
        Mode::SlideRockORight => {
            // (3.43, 3.45)
            let p = point.polynomials(Need::Value, |p| [p.turn_right, p.slip_right]);
            let regularity = 4.0 + γ * γ + 3.0 * μ * γ;
            slipping(point, γ, -μ, 3.0 * p.turn_right / regularity, -p.slip_right / regularity)
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

/// Slide-rock about the corner of g at the rate λ, under f_x = f f_y with f = ±μ.
fn slipping(point: &Point, g: f64, f: f64, λ: f64, slip: f64) -> Motion {
    let k = point.k;
    // Adding zero turns −0 into 0.
    let f_x = f * (1.0 + λ) + 0.0;
    // ẍ in the form that cancels less: from the corner's slip, or from the forces.
    let x_ddot = if slip.abs().max((g * λ).abs()) < k.max(f_x.abs()) { slip - g * λ } else { f_x - k };
    about_corner(g.signum(), λ, x_ddot, f_x, slip)
}
