//! Wave loads on a vertical caisson: Goda's pressures, with Takahashi's coefficient for impulsive breaking; on a wall before which waves stand:
//! [`sainflou`](fn@sainflou), in crest and trough; on a crown wall: [`pedersen`] and [`van_gent`].
//!
//! ```text
//!                      ┌────────────┐ ─┬─
//!     p₄ at h_c* ───►  │            │  h_c
//!  ~~~~~~~~~~ p₁ ───►  │            │ ─┼─ still water
//!                      │            │  │
//!   d                  │            │  h'
//!   berm ── p₃ ─────►  │            │ ─┴─
//!  ────────────────────┴────────────┴───
//!                  p_u ▲▲▲▲▲▲▲▲  0
//!                      toe      heel
//! ```
//!
//! The symbols of this module are Goda's, and clash with the report's (P, d, h', H, k); nothing of them leaves it
//! but a force, an uplift and their moments. SI units, per metre run of caisson.
//!
//! | symbol | identifier | meaning |
//! |---|---|---|
//! | H | `h_max` | design wave height H_max |
//! | h, tanθ | `water_depth`, `sea_bottom_slope` | depth at the wall, slope of the sea bed |
//! | h_b | `h_b` | depth at 5 H_1/3 in front of the wall |
//! | d, B_M | `depth_above_berm`, `berm_width` | depth above the berm's armour, width of the berm |
//! | h', h_c | `base_depth`, `crest_height` | depth of the caisson's base, height of its crest above still water |
//! | β | `angle_deg` | angle of the waves from the wall's normal |
//! | L, L₀ | `wavelength`, `deep_water_wavelength` | at the depth h, and in deep water, for T_1/3 |
//!
//! ```text
//! η* = 0.75(1+cosβ) λ₁ H
//! α₁ = 0.6 + 0.5[(4πh/L)/sinh(4πh/L)]²         α₂ = min{(h_b−d)/(3h_b)·(H/d)², 2d/H}
//! α₃ = 1 − (h'/h)[1 − 1/cosh(2πh/L)]           α₄ = 1 − h_c*/η*,  h_c* = min(η*, h_c)
//! p₁ = ½(1+cosβ)(λ₁α₁ + λ₂α*cos²β) ρgH         α* = max(α₂, α_I), or α₂ without the impulsive coefficient
//! p₃ = α₃p₁,  p₄ = α₄p₁                        p_u = ½(1+cosβ) λ₃α₁α₃ ρgH
//! P = ½(p₁+p₃)h' + ½(p₁+p₄)h_c*                U = ½p_uB_c,  M_U = ⅔UB_c
//! M_p = (2p₁+p₃)h'²/6 + (p₁+p₄)h'h_c*/2 + (p₁+2p₄)h_c*²/6
//! ```
//!
//! References: Y. Goda, *Random Seas and Design of Maritime Structures*; S. Takahashi, K. Tanimoto, K. Shimosako (1994)
//! for the impulsive coefficient. Validity: a wall on a berm, waves that do not overtop so far that the pressure is
//! relieved; [`WaveWarning`] names what leaves the range of the formulas.

mod added_mass;
mod crown;
mod dispersion;
mod goda;
mod heights;
mod pressed;
mod sainflou;
mod warning;

pub use added_mass::{added_mass, added_mass_above, added_mass_height};
pub use crown::{Armour, CrownSea, CrownWave, PedersenTerms, PedersenWall, VanGentWall, pedersen, van_gent};
pub use dispersion::{deep_water_wavelength, period_of_steepness, shoaling, wavelength};
pub use goda::{Goda, Impulsive, goda};
pub use heights::{BreakingTerms, DesignHeights};
pub use sainflou::{Sainflou, StandingWall, WavePhase, sainflou};
pub use warning::{CrownRatio, STEEPEST, WaveWarning};

use crate::error::InputError;
use crate::quantity::{Expected, Quantity};

/// The sea in front of the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sea {
    /// h, m.
    pub water_depth: f64,
    /// tanθ.
    pub sea_bottom_slope: f64,
    /// T_1/3, s.
    pub period: f64,
    /// β, degrees from the wall's normal, used as given.
    pub angle_deg: f64,
    /// ρ, kg/m³.
    pub water_density: f64,
    /// g, m/s².
    pub gravity: f64,
}

/// Heights of the waves, as they are given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Heights {
    /// The equivalent deep-water height H₀' (m), from which the heights at the wall are computed.
    DeepWater(f64),
    /// The heights at the wall.
    Local {
        /// H_1/3, m.
        significant: f64,
        /// H_max, m.
        maximum: f64,
    },
}

/// The caisson and its berm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CaissonSection {
    /// h', depth of the caisson's base below still water, m.
    pub base_depth: f64,
    /// d, depth above the berm's armour, m.
    pub depth_above_berm: f64,
    /// h_c, height of the crest above still water, m.
    pub crest_height: f64,
    /// B_M, m.
    pub berm_width: f64,
    /// B_c, m.
    pub caisson_width: f64,
}

/// Choices in the formulas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choices {
    /// λ₁, λ₂, λ₃: factors on the standing, the breaking and the uplift pressure; 1 for a plain wall.
    pub lambda: [f64; 3],
    /// True if α* takes Takahashi's impulsive coefficient α_I into account.
    pub impulsive: bool,
    /// By how much the waves are turned towards the normal, at most to it: 0 to 15 degrees.
    pub turn_deg: f64,
    /// True if the waves press under the base; false where it is sealed.
    pub uplift: bool,
    /// Factors on the height in deep water, and on those at the wall once they are found: 1 unless an error of the estimate is looked at.
    pub height_factors: [f64; 2],
}

impl Default for Choices {
    /// A plain wall, with the impulsive coefficient, waves not turned.
    fn default() -> Choices {
        Choices { lambda: [1.0; 3], impulsive: true, turn_deg: 0.0, uplift: true, height_factors: [1.0; 2] }
    }
}

impl Sea {
    fn check(&self) -> Result<(), InputError> {
        InputError::positive(Quantity::WaterDepth, self.water_depth)?;
        InputError::not_negative(Quantity::SeaBottomSlope, self.sea_bottom_slope)?;
        InputError::positive(Quantity::WavePeriod, self.period)?;
        InputError::within(Quantity::WaveAngle, self.angle_deg, 0.0, 90.0, Expected::RightAngleAtMost)?;
        InputError::positive(Quantity::WaterDensity, self.water_density)?;
        InputError::positive(Quantity::Gravity, self.gravity)?;
        Ok(())
    }
}

impl Heights {
    /// H_1/3 and H_max at the wall, m.
    pub fn at_wall(&self, sea: &Sea) -> [f64; 2] {
        match *self {
            Heights::DeepWater(height) => {
                let heights = DesignHeights::from_deep_water(sea, height);
                [heights.significant, heights.maximum]
            }
            Heights::Local { significant, maximum } => [significant, maximum],
        }
    }

    fn check(&self) -> Result<(), InputError> {
        match *self {
            Heights::DeepWater(height) => {
                InputError::positive(Quantity::DeepWaterHeight, height)?;
            }
            Heights::Local { significant, maximum } => {
                InputError::positive(Quantity::SignificantHeight, significant)?;
                InputError::positive(Quantity::MaximumHeight, maximum)?;
                if maximum < significant {
                    let expected = Expected::NotBelowSignificantHeight;
                    return Err(InputError::new(Quantity::MaximumHeight, maximum, expected));
                }
            }
        }
        Ok(())
    }
}

impl CaissonSection {
    fn check(&self, sea: &Sea) -> Result<(), InputError> {
        InputError::positive(Quantity::BaseDepth, self.base_depth)?;
        InputError::positive(Quantity::BermDepth, self.depth_above_berm)?;
        if self.depth_above_berm > sea.water_depth {
            let expected = Expected::NotBelowSeaBed;
            return Err(InputError::new(Quantity::BermDepth, self.depth_above_berm, expected));
        }
        InputError::finite(Quantity::CrestHeight, self.crest_height)?;
        if self.crest_height <= 0.0 {
            let expected = Expected::AboveStillWater;
            return Err(InputError::new(Quantity::CrestHeight, self.crest_height, expected));
        }
        InputError::not_negative(Quantity::BermWidth, self.berm_width)?;
        InputError::positive(Quantity::CaissonWidth, self.caisson_width)?;
        Ok(())
    }
}

impl Choices {
    fn check(&self) -> Result<(), InputError> {
        let factors = [Quantity::Lambda1, Quantity::Lambda2, Quantity::Lambda3].into_iter().zip(self.lambda);
        for (factor, value) in factors {
            InputError::not_negative(factor, value)?;
        }
        InputError::within(Quantity::WaveTurn, self.turn_deg, 0.0, 15.0, Expected::FifteenDegreesAtMost)?;
        Ok(())
    }
}
