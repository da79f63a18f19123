//! Linear waves over water of constant depth: wavelength and shoaling.

use std::f64::consts::TAU;

/// The wavelength L (m) of a wave of `period` (s) over `depth` (m) at `gravity` (m/s²): ω² = g κ tanh κh with
/// κ = 2π/L, solved to round-off.
///
/// ```
/// let wavelength = standfast::wave::wavelength(11.4, 10.1, 9.81);
/// assert!((wavelength - 107.538).abs() < 5e-4);
/// ```
pub fn wavelength(period: f64, depth: f64, gravity: f64) -> f64 {
    TAU * depth / relative_wave_number(period, depth, gravity)
}

/// The wavelength in deep water, L₀ = gT²/2π (m).
pub fn deep_water_wavelength(period: f64, gravity: f64) -> f64 {
    gravity * period * period / TAU
}

/// The period of waves of a height H₀' (m) and a steepness H₀'/L₀ in deep water, √(2π H₀'/(g s)), in s.
///
/// ```
/// let period = standfast::wave::period_of_steepness(6.3, 0.0310, 9.81);
/// assert!((6.3 / standfast::wave::deep_water_wavelength(period, 9.81) - 0.0310).abs() < 1e-12);
/// ```
pub fn period_of_steepness(height: f64, steepness: f64, gravity: f64) -> f64 {
    (TAU * height / (gravity * steepness)).sqrt()
}

/// The coefficient of linear shoaling K_s = H/H₀' at `depth`.
pub fn shoaling(period: f64, depth: f64, gravity: f64) -> f64 {
    let x = relative_wave_number(period, depth, gravity);
    // 2n = 1 + 2x/sinh 2x is twice the ratio of group speed to phase speed.
    let twice_n = 1.0 + 2.0 * x / (2.0 * x).sinh();
    (1.0 / (twice_n * x.tanh())).sqrt()
}

/// κh, the root of x tanh x = ω²h/g.
fn relative_wave_number(period: f64, depth: f64, gravity: f64) -> f64 {
    let ω = TAU / period;
    let y = ω * ω * depth / gravity;
    // Shallow √y and deep y are both below the root or at it; Newton's method on this convex function overshoots
    // once and then descends to the root, quadratically.
    let mut x = y.max(y.sqrt());
    for _ in 0..50 {
        let tanh = x.tanh();
        let next = x - (x * tanh - y) / (tanh + x * (1.0 - tanh * tanh));
        if (next - x).abs() <= f64::EPSILON * x {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_dispersion_relation_holds_to_round_off() {
        for period in [0.5, 3.0, 8.0, 11.4, 20.0, 600.0] {
            for depth in [1e-3, 0.5, 5.0, 10.1, 60.0, 4000.0] {
                let κ = TAU / wavelength(period, depth, 9.81);
                let (left, right) = ((TAU / period).powi(2), 9.81 * κ * (κ * depth).tanh());
                assert!((left - right).abs() <= 8.0 * f64::EPSILON * left, "{period} {depth}");
            }
        }
    }

    #[test]
    fn limits_of_deep_and_shallow_water() {
        let deep = wavelength(5.0, 500.0, 9.81);
        assert!((deep / deep_water_wavelength(5.0, 9.81) - 1.0).abs() < 1e-12);
        assert!((shoaling(5.0, 500.0, 9.81) - 1.0).abs() < 1e-9);
        let shallow = wavelength(600.0, 1.0, 9.81);
        assert!((shallow / (600.0 * 9.81f64.sqrt()) - 1.0).abs() < 1e-4);
    }
}
