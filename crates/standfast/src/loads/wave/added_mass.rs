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

/// Mass of water that the wall above a level carries along, kg per metre run, and how high above that level its pressure acts, m: of water of
/// `density` (kg/m³) and `depth` (m) on one side. Nothing above the water.
///
/// ```text
/// A(y) = 16ρh²/π³ Σ [1 − s sin(nπy/2h)]/n³, n = 1, 3, 5 …, s = (−1)^((n−1)/2)
/// ∫A dy from y to h = 16ρh²/π³ Σ [h − y − s 2h/(nπ) cos(nπy/2h)]/n³
/// ```
pub fn added_mass_above(density: f64, depth: f64, level: f64) -> [f64; 2] {
    if level <= 0.0 {
        return [added_mass(1, density, depth), added_mass_height(depth) - level];
    }
    if level >= depth {
        return [0.0; 2];
    }
    // The sums without waves are known; what is left falls off as n⁻³ and n⁻⁴, and is of changing sign.
    let angle = PI * level / (2.0 * depth);
    let (mut mass, mut moment) = (7.0 / 8.0 * ZETA_3, 7.0 / 8.0 * ZETA_3 * (depth - level));
    for place in 0..TERMS {
        let n = 2.0 * f64::from(place) + 1.0;
        let s = if place % 2 == 0 { 1.0 } else { -1.0 };
        let (sin, cos) = (n * angle).sin_cos();
        mass -= s * sin / n.powi(3);
        moment -= s * 2.0 * depth / (n.powi(4) * PI) * cos;
    }
    let scale = 16.0 * density * depth * depth / PI.powi(3);
    [scale * mass, moment / mass]
}

/// So many terms of the series leave less than 10⁻¹² of the whole.
const TERMS: u32 = 2000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_coefficients_are_those_given() {
        assert!((added_mass(1, 1.0, 1.0) - 0.54275).abs() < 1e-5);
        assert!((added_mass(2, 1000.0, 10.0) - 1.08551 * 1e5).abs() < 1.0);
    }

    /// Of 1 m/s² on one side of 1 kg/m³: the force above a level and its moment about that, of the potential's pressure added up in strips.
    fn above(depth: f64, level: f64) -> [f64; 2] {
        let pressure = |z: f64| -> f64 {
            let terms = (0..4000).map(|n| {
                let λ = (2.0 * f64::from(n) + 1.0) * PI / (2.0 * depth);
                (if n % 2 == 0 { 2.0 } else { -2.0 }) / (λ * λ * depth) * (λ * z).cos()
            });
            terms.sum()
        };
        let (strips, height) = (4000, depth - level);
        let (mut force, mut moment) = (0.0, 0.0);
        for i in 0..strips {
            let z = height * (f64::from(i) + 0.5) / f64::from(strips);
            let strip = pressure(level + z) * height / f64::from(strips);
            force += strip;
            moment += strip * z;
        }
        [force, moment]
    }

    /// What is above a level, against the potential's pressure added up from there.
    #[test]
    fn what_is_above_a_level_is_the_pressure_there() {
        let depth = 6.0;
        for level in [0.0, 0.5, 2.0, 4.4, 5.7] {
            let [force, moment] = above(depth, level);
            let [mass, at] = added_mass_above(1000.0, depth, level);
            assert!((1000.0 * force / mass - 1.0).abs() < 1e-5, "{level}: {force} {mass}");
            assert!((moment / force / at - 1.0).abs() < 1e-5, "{level}: {} {at}", moment / force);
        }
        assert_eq!(added_mass_above(1000.0, depth, 6.0), [0.0; 2]);
        assert_eq!(added_mass_above(1000.0, depth, -2.0)[1], added_mass_height(depth) + 2.0);
    }

    /// The potential's pressure on the wall, added up over the depth.
    #[test]
    fn force_and_height_are_those_of_the_pressure() {
        let depth = 7.0;
        let [force, moment] = above(depth, 0.0);
        assert!((force / added_mass(1, 1.0, depth) - 1.0).abs() < 1e-6);
        assert!((moment / force / added_mass_height(depth) - 1.0).abs() < 1e-6);
    }
}
