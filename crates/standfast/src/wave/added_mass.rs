//! Water that moves with a wall.

/// Mass of water that a rigid vertical wall carries along when it moves horizontally, kg per metre run: water of
/// `density` (kg/m³) and `depth` (m) on one side or on both.
///
/// 14ζ(3)/π³ ρh² = 0.54275 ρh² a side (Westergaard's problem without compressibility). Its resultant does not act at the
/// centre of mass; the coupling of sway and rotation that follows is left out.
pub fn added_mass(sides: u8, density: f64, depth: f64) -> f64 {
    /// Apéry's constant ζ(3).
    const ZETA_3: f64 = 1.202_056_903_159_594_2;
    f64::from(sides) * 14.0 * ZETA_3 / std::f64::consts::PI.powi(3) * density * depth * depth
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_coefficients_are_those_given() {
        assert!((added_mass(1, 1.0, 1.0) - 0.54275).abs() < 1e-5);
        assert!((added_mass(2, 1000.0, 10.0) - 1.08551 * 1e5).abs() < 1.0);
    }
}
