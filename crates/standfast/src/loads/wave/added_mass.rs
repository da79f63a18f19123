//! Water that moves with a wall.

use std::f64::consts::PI;

/// Apéry's constant ζ(3).
const ZETA_3: f64 = 1.202_056_903_159_594_2;

/// Dirichlet's β(4).
const BETA_4: f64 = 0.988_944_551_741_105_3;

/// Mass of water that a rigid vertical wall carries along when it moves horizontally, kg per metre run: water of
/// `density` (kg/m³) and `depth` (m) on one side or on both.
///
/// 14ζ(3)/π³ ρh² = 0.54275 ρh² a side (Westergaard's problem without compressibility). Its resultant does not act at the
/// centre of mass; the coupling of sway and rotation that follows is left out.
pub fn added_mass(sides: u8, density: f64, depth: f64) -> f64 {
    f64::from(sides) * 14.0 * ZETA_3 / PI.powi(3) * density * depth * depth
}

/// Height above the bottom of the water at which its pressure on a wall that is shaken acts, m: of the `depth` (m)
/// (1 − 16β(4)/(7π ζ(3))) = 0.40142, from the same potential.
pub fn added_mass_height(depth: f64) -> f64 {
    (1.0 - 16.0 * BETA_4 / (7.0 * PI * ZETA_3)) * depth
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_coefficients_are_those_given() {
        assert!((added_mass(1, 1.0, 1.0) - 0.54275).abs() < 1e-5);
        assert!((added_mass(2, 1000.0, 10.0) - 1.08551 * 1e5).abs() < 1.0);
    }

    /// The potential's pressure on the wall, added up over the depth.
    #[test]
    fn force_and_height_are_those_of_the_pressure() {
        let depth = 7.0;
        let pressure = |z: f64| -> f64 {
            let terms = (0..4000).map(|n| {
                let λ = (2.0 * f64::from(n) + 1.0) * PI / (2.0 * depth);
                (if n % 2 == 0 { 2.0 } else { -2.0 }) / (λ * λ * depth) * (λ * z).cos()
            });
            terms.sum()
        };
        let strips = 2000;
        let (mut force, mut moment) = (0.0, 0.0);
        for i in 0..strips {
            let z = depth * (f64::from(i) + 0.5) / f64::from(strips);
            let strip = pressure(z) * depth / f64::from(strips);
            force += strip;
            moment += strip * z;
        }
        assert!((force / added_mass(1, 1.0, depth) - 1.0).abs() < 1e-6);
        assert!((moment / force / added_mass_height(depth) - 1.0).abs() < 1e-6);
    }
}
