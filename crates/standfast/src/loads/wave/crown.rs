//! Waves on a crown wall behind armour: Pedersen's formula for the force that 0.1 % of the waves exceed, and Van Gent's for 2 %. They are of
//! other exceedances, and not exchangeable.
//!
//! ```text
//! Pedersen    L_om = gT²/2π,  ξ = tanα/√(H_s/L_om),  R = 1.12 H_sξ (ξ ≤ 1.5) or 1.34 H_sξ^0.55,  p_m = ρg(R − A_c) ≥ 0
//!             y = (R − A_c) sin15°/(sinα cos(α − 15°)),  y_eff = min(y/2, f_c)
//!             P = 0.21 √(L_om/B_a) (1.6 p_m y_eff + ½ V p_m h'),  M = 0.55 (h' + y_eff) P about the base,  p_u = V p_m, none at the heel
//! Van Gent    z = γ_f H (1.45 ξ if ξ < 1.724, else 5 − c₂/ξ) (½ cos²β + ½),  c₂ = 6.25/1.45
//!             P = ρg H_w (z − A_c) ≥ 0,  U = 0.4 ρg B_w (z − 0.75 A_c)(1 − √(F_b/A_c)) ≥ 0
//! ```
//!
//! Sources: Pedersen as in the Coastal Engineering Manual, table VI-5-61, as coded in an open toolbox; Van Gent and Van der Werf (2019) as coded
//! by Deltares. Van Gent's P has no point of its own: it acts at half the height of the wall, and U falls to nothing at the heel; both are choices.

use super::pressed::numbered;
use super::{CrownRatio, WaveWarning, deep_water_wavelength};
use crate::body::Body;
use crate::error::InputError;
use crate::loads::{Action, Face, Load, LoadKind, LoadSource, PressureDiagram};
use crate::quantity::{Expected, Quantity};

/// The sea before a crown wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrownSea {
    /// H_s, or H_m0, m.
    pub significant: f64,
    /// T_m of Pedersen, T_{m−1,0} of Van Gent, s.
    pub period: f64,
    /// β, degrees from the wall's normal.
    pub angle_deg: f64,
    /// ρ, kg/m³.
    pub water_density: f64,
    /// g, m/s².
    pub gravity: f64,
    /// h, m, for the range of the formula alone.
    pub water_depth: Option<f64>,
}

/// Armour before a crown wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Armour {
    /// cot α of its slope.
    pub slope: f64,
    /// A_c, its crest above still water, m.
    pub crest: f64,
}

/// A crown wall for Pedersen's formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PedersenWall {
    /// B_a, width of the crest of the armour, m.
    pub armour_width: f64,
    /// h', height of the wall behind the armour, m.
    pub protected: f64,
    /// f_c, height of the wall above the armour, m.
    pub free: f64,
    /// V, share of the run-up wedge above the armour, 1 at most.
    pub volume_share: f64,
    /// Width of its base, m.
    pub base: f64,
}

/// A crown wall for Van Gent's formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VanGentWall {
    /// H_w, height of the wall, m.
    pub height: f64,
    /// B_w, width of its base, m.
    pub base: f64,
    /// F_b, its base above still water, m.
    pub freeboard: f64,
    /// γ_f of the armour.
    pub roughness: f64,
}

/// Waves on a crown wall and what they were computed from; SI units, per metre run.
#[derive(Debug, Clone, PartialEq)]
pub struct CrownWave {
    /// L_om of Pedersen, or that of T_{m−1,0}, m.
    pub wavelength: f64,
    /// ξ.
    pub xi: f64,
    /// R of Pedersen, z of Van Gent, above still water, m.
    pub run_up: f64,
    /// What Pedersen's formula goes through.
    pub pedersen: Option<PedersenTerms>,
    /// P, N/m, towards the land.
    pub force: f64,
    /// Height above the base at which it acts, m.
    pub elevation: f64,
    /// Uplift pressure at the seaward edge, Pa, none at the heel.
    pub pu: f64,
    /// Width from the seaward edge along which it falls, m.
    pub uplift_width: f64,
    /// U, N/m.
    pub uplift: f64,
    /// Which of the formulas' branches apply, as a number: the forces have a kink where it changes.
    pub formulas: u32,
    /// Ratios beside the ranges in which the formula was tested.
    pub ratios: Vec<CrownRatio>,
}

/// Steps of Pedersen's formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PedersenTerms {
    /// p_m, Pa.
    pub pm: f64,
    /// y, height of the run-up wedge, m.
    pub y: f64,
    /// y_eff, m.
    pub y_eff: f64,
    /// M about the base, N·m/m.
    pub moment: f64,
}

impl CrownSea {
    fn check(&self) -> Result<(), InputError> {
        InputError::positive(Quantity::SignificantHeight, self.significant)?;
        InputError::positive(Quantity::WavePeriod, self.period)?;
        InputError::within(Quantity::WaveAngle, self.angle_deg, 0.0, 90.0, Expected::RightAngleAtMost)?;
        InputError::positive(Quantity::WaterDensity, self.water_density)?;
        InputError::positive(Quantity::Gravity, self.gravity)?;
        if let Some(depth) = self.water_depth {
            InputError::positive(Quantity::WaterDepth, depth)?;
        }
        Ok(())
    }

    fn wavelength(&self) -> f64 {
        deep_water_wavelength(self.period, self.gravity)
    }
}

impl Armour {
    fn check(&self) -> Result<(), InputError> {
        InputError::positive(Quantity::ArmourSlope, self.slope)?;
        InputError::positive(Quantity::ArmourCrest, self.crest)?;
        Ok(())
    }
}

/// The force on a crown wall that 0.1 % of the waves exceed, by Pedersen's formula.
///
/// # Errors
/// If a number is not finite or not possible, or the waves come aside.
pub fn pedersen(sea: &CrownSea, armour: &Armour, wall: &PedersenWall) -> Result<CrownWave, InputError> {
    sea.check()?;
    InputError::within(Quantity::WaveAngle, sea.angle_deg, 0.0, 0.0, Expected::WavesHeadOn)?;
    armour.check()?;
    let PedersenWall { armour_width, protected, free, volume_share, base } = *wall;
    InputError::positive(Quantity::ArmourWidth, armour_width)?;
    InputError::not_negative(Quantity::WallHeight, protected)?;
    InputError::not_negative(Quantity::WallHeight, free)?;
    InputError::within(Quantity::VolumeShare, volume_share, 0.0, 1.0, Expected::ShareAtMostOne)?;
    InputError::positive(Quantity::Width, base)?;

    let (h_s, w) = (sea.significant, sea.water_density * sea.gravity);
    let l = sea.wavelength();
    let α = (1.0 / armour.slope).atan();
    let ξ = (1.0 / armour.slope) / (h_s / l).sqrt();
    let is_low = ξ <= 1.5;
    let run_up = if is_low { 1.12 * h_s * ξ } else { 1.34 * h_s * ξ.powf(0.55) };
    let over = (run_up - armour.crest).max(0.0);
    let pm = w * over;
    let lean = 15f64.to_radians();
    let y = over * lean.sin() / (α.sin() * (α - lean).cos());
    let y_eff = (0.5 * y).min(free);
    let force = 0.21 * (l / armour_width).sqrt() * (1.6 * pm * y_eff + 0.5 * volume_share * pm * protected);
    let elevation = 0.55 * (protected + y_eff);
    let pu = volume_share * pm;
    let flags = [is_low, over == 0.0, 0.5 * y > free];
    let ratio = |name, value, [low, high]: [f64; 2]| CrownRatio { name, value, low, high };
    let mut ratios = vec![
        ratio("xi", ξ, [1.1, 5.2]),
        ratio("H_s/A_c", h_s / armour.crest, [0.5, 1.5]),
        ratio("A_c/B_a", armour.crest / armour_width, [1.0, 2.6]),
        ratio("cot alpha", armour.slope, [1.5, 3.5]),
    ];
    ratios.extend(sea.water_depth.map(|depth| ratio("H_s/h", h_s / depth, [0.16, 0.35])));
    Ok(CrownWave {
        wavelength: l,
        xi: ξ,
        run_up,
        pedersen: Some(PedersenTerms { pm, y, y_eff, moment: elevation * force }),
        force,
        elevation,
        pu,
        uplift_width: base,
        uplift: 0.5 * pu * base,
        formulas: numbered(0, &flags),
        ratios,
    })
}

/// The force on a crown wall that 2 % of the waves exceed, by Van Gent's formula.
///
/// # Errors
/// If a number is not finite or not possible.
pub fn van_gent(sea: &CrownSea, armour: &Armour, wall: &VanGentWall) -> Result<CrownWave, InputError> {
    sea.check()?;
    armour.check()?;
    let VanGentWall { height, base, freeboard, roughness } = *wall;
    InputError::positive(Quantity::WallHeight, height)?;
    InputError::positive(Quantity::Width, base)?;
    InputError::not_negative(Quantity::BaseFreeboard, freeboard)?;
    InputError::within(Quantity::Roughness, roughness, 0.0, 1.0, Expected::ShareAtMostOne)?;

    let (h, w) = (sea.significant, sea.water_density * sea.gravity);
    let l = sea.wavelength();
    let ξ = (1.0 / armour.slope) / (h / l).sqrt();
    // The branches meet at 1.7241: c₁ = 1.45, c₀ = 5, c₂ = c₀²/(4 c₁).
    let is_low = ξ < 1.724;
    let slope = if is_low { 1.45 * ξ } else { 5.0 - 6.25 / 1.45 / ξ };
    let cos_β = sea.angle_deg.to_radians().cos();
    let run_up = roughness * h * slope * (0.5 * cos_β * cos_β + 0.5);
    let over = run_up - armour.crest;
    let under = (run_up - 0.75 * armour.crest) * (1.0 - (freeboard / armour.crest).sqrt());
    let force = w * height * over.max(0.0);
    let uplift = 0.4 * w * base * if run_up > 0.75 * armour.crest { under.max(0.0) } else { 0.0 };
    let flags = [is_low, over <= 0.0, uplift == 0.0];
    let crest = freeboard + height;
    let ratio = |name, value, [low, high]: [f64; 2]| CrownRatio { name, value, low, high };
    Ok(CrownWave {
        wavelength: l,
        xi: ξ,
        run_up,
        pedersen: None,
        force,
        elevation: 0.5 * height,
        pu: 2.0 * uplift / base,
        uplift_width: base,
        uplift,
        formulas: numbered(0, &flags),
        ratios: vec![
            ratio("(R_c − A_c)/H", (crest - armour.crest) / h, [0.26, 0.77]),
            ratio("R_c/A_c", crest / armour.crest, [1.27, 1.55]),
            ratio("R_c/H", crest / h, [0.79, 2.18]),
            ratio("F_b/H", freeboard / h, [0.0, 0.62]),
        ],
    })
}

impl CrownWave {
    /// Warnings of ratios outside the ranges in which the formula was tested.
    pub fn warnings(&self) -> impl Iterator<Item = WaveWarning> {
        let outside = self.ratios.iter().filter(|ratio| !ratio.is_inside());
        outside.map(|ratio| WaveWarning::CrownWallRange(*ratio))
    }

    /// The loads on `body`: a force on its right side, and a pressure under its base.
    pub fn loads(&self, body: &Body) -> Vec<Load> {
        let push = Action::horizontal(-self.force, self.elevation);
        let mut loads = vec![Load::variable(LoadSource::WavePressure, LoadKind::Horizontal, push)];
        if self.pu != 0.0 {
            let edge = body.base_width();
            let diagram = PressureDiagram::through([(edge - self.uplift_width, 0.0), (edge, self.pu)]);
            let base = Action::Pressure { face: Face::Base, diagram };
            loads.push(Load::variable(LoadSource::WaveUplift, LoadKind::Uplift, base));
        }
        loads
    }
}
