//! Standing waves before a wall by Sainflou's formula, with straight lines between still water, surface and bed.
//!
//! ```text
//! h₀ = (πH²/L) coth kh        p₂ = wH/cosh kh at the bed        k = 2π/L,  w = ρg
//! crest    p₁ = (p₂ + wh)(H + h₀)/(h + H + h₀) at still water,  0 at H + h₀ above it, cut at the crest of the wall
//! trough   p₁ = −w(H − h₀) at H − h₀ below still water,  0 there,  −p₂ at the bed
//! uplift   p_b, that at the base of the wall, under the seaward edge, none under the heel
//! ```
//!
//! All are additions to still water. Source: the linear form as coded in a public program; the fall of the uplift to nothing at the heel is
//! recalled, not read. Validity: waves that do not break.

use std::f64::consts::{PI, TAU};

use super::pressed::{loads, resultants};
use super::warning::{breaking_limit, breaks_by_bed};
use super::{Sea, WaveWarning, deep_water_wavelength, shoaling, wavelength};
use crate::body::Body;
use crate::error::InputError;
use crate::loads::Load;
use crate::quantity::{Expected, Quantity};

/// Phase of a standing wave at the wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WavePhase {
    /// The water stands highest.
    Crest,
    /// The water stands lowest.
    Trough,
}

/// A wall under standing waves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StandingWall {
    /// h', depth of its base below still water, m.
    pub base_depth: f64,
    /// h_c, height of its crest above still water, m.
    pub crest_height: f64,
    /// B_c, width of its base, m.
    pub width: f64,
    /// True if the waves press under the base; false where it is sealed.
    pub uplift: bool,
}

/// Sainflou's pressures, added to those of still water, and what they were computed from; SI units, per metre run. In a trough they
/// are below zero: they pull towards the sea.
#[derive(Debug, Clone, PartialEq)]
pub struct Sainflou {
    /// Phase of the wave.
    pub phase: WavePhase,
    /// H, m.
    pub height: f64,
    /// L₀, m.
    pub deep_water_wavelength: f64,
    /// L at the depth h, m.
    pub wavelength: f64,
    /// h₀, m: by how much the middle of the standing wave lies above still water.
    pub h0: f64,
    /// The surface at the wall above still water, m: H + h₀, or −(H − h₀).
    pub surface: f64,
    /// How far above still water the pressure reaches on the wall, m: the surface, cut at the crest.
    pub reach: f64,
    /// p₁ at still water, or at the surface of a trough, Pa.
    pub p1: f64,
    /// p₂ at the bed, Pa.
    pub p2: f64,
    /// p_b at the base of the wall, Pa.
    pub pb: f64,
    /// p₄ at the top of the loaded wall, Pa.
    pub p4: f64,
    /// Uplift pressure at the seaward edge, Pa; none at the heel.
    pub pu: f64,
    /// P, N/m: horizontal force on the wall, towards the land.
    pub force: f64,
    /// Its moment about the base, N·m/m.
    pub force_moment: f64,
    /// U, N/m: uplift.
    pub uplift: f64,
    /// Its moment about the heel, N·m/m.
    pub uplift_moment: f64,
    /// 1 where the wave is cut at the crest, else 0: the pressures have a kink there.
    pub formulas: u32,
    /// Conditions outside the range of the formula.
    pub warnings: Vec<WaveWarning>,
}

/// The pressures of a standing wave of `height` H (m) before a wall.
///
/// ```
/// use standfast::wave::{Sea, StandingWall, WavePhase, sainflou};
///
/// let sea = Sea { water_depth: 14.0, sea_bottom_slope: 0.0, period: 9.0, angle_deg: 0.0, water_density: 1030.0, gravity: 9.81 };
/// let wall = StandingWall { base_depth: 11.0, crest_height: 6.0, width: 16.0, uplift: true };
/// let trough = sainflou(&sea, 4.5, WavePhase::Trough, &wall)?;
/// assert!((trough.force - -318_472.0).abs() < 0.5);
/// # Ok::<(), standfast::InputError>(())
/// ```
///
/// # Errors
/// If a number is not finite or not possible: waves that come aside, a base below the bed or above the trough, a crest under water.
pub fn sainflou(
    sea: &Sea,
    height: f64,
    phase: WavePhase,
    wall: &StandingWall,
) -> Result<Sainflou, InputError> {
    sea.check()?;
    InputError::within(Quantity::WaveAngle, sea.angle_deg, 0.0, 0.0, Expected::WavesHeadOn)?;
    InputError::positive(Quantity::WaveHeight, height)?;
    let StandingWall { base_depth, crest_height, width, uplift } = *wall;
    InputError::positive(Quantity::BaseDepth, base_depth)?;
    InputError::positive(Quantity::CaissonWidth, width)?;
    InputError::finite(Quantity::CrestHeight, crest_height)?;
    let refused = |quantity, value, expected| Err(InputError::new(quantity, value, expected));
    if crest_height <= 0.0 {
        return refused(Quantity::CrestHeight, crest_height, Expected::AboveStillWater);
    }
    let Sea { water_depth: h, period, water_density: ρ, gravity: g, .. } = *sea;
    if base_depth > h {
        return refused(Quantity::BaseDepth, base_depth, Expected::NotBelowBed);
    }

    let l = wavelength(period, h, g);
    let κh = TAU * h / l;
    let w = ρ * g;
    let h0 = PI * height * height / l / κh.tanh();
    if h0 >= height {
        return refused(Quantity::WaveHeight, height, Expected::StandingWave);
    }
    let p2 = w * height / κh.cosh();
    let (surface, reach, p2, [pb, p1, p4], [force, force_moment]) = match phase {
        WavePhase::Crest => {
            let surface = height + h0;
            let p1 = (p2 + w * h) * surface / (h + surface);
            let reach = surface.min(crest_height);
            let pressures = [p1 - (p1 - p2) * base_depth / h, p1, p1 * (1.0 - reach / surface)];
            (surface, reach, p2, pressures, resultants(pressures, base_depth, reach))
        }
        WavePhase::Trough => {
            let fall = height - h0;
            if base_depth < fall {
                return refused(Quantity::BaseDepth, base_depth, Expected::BelowTrough);
            }
            let p1 = -w * fall;
            let below = base_depth - fall;
            let share = if h > fall { below / (h - fall) } else { 0.0 };
            let pressures = [p1 + (-p2 - p1) * share, p1, 0.0];
            (-fall, 0.0, -p2, pressures, resultants(pressures, below, fall))
        }
    };
    let [pu, width] = if uplift { [pb, width] } else { [0.0; 2] };
    let l0 = deep_water_wavelength(period, g);
    let limit = breaking_limit(l, h);
    let steepness = height / shoaling(period, h, g) / l0;
    let slope = sea.sea_bottom_slope;
    let is_impulsive = breaks_by_bed(slope, steepness) && crest_height / height > 0.3;
    let breaks = WaveWarning::StandingWaveBreaks { height, limit, bed_slope: slope };
    Ok(Sainflou {
        phase,
        height,
        deep_water_wavelength: l0,
        wavelength: l,
        h0,
        surface,
        reach,
        p1,
        p2,
        pb,
        p4,
        pu,
        force,
        force_moment,
        uplift: 0.5 * pu * width,
        uplift_moment: pu * width * width / 3.0,
        // A trough is cut by nothing.
        formulas: u32::from(surface > crest_height),
        warnings: if height > limit || is_impulsive { vec![breaks] } else { Vec::new() },
    })
}

impl Sainflou {
    /// The pressures as loads on `body`, whose base lies `base_depth` below still water (m): on its right side, and under its base, where
    /// they press there.
    pub fn loads(&self, body: &Body, base_depth: f64) -> Vec<Load> {
        let Sainflou { p1, pb, p4, pu, surface, reach, .. } = *self;
        let wall = match self.phase {
            WavePhase::Crest => [(0.0, pb), (base_depth, p1), (base_depth + reach, p4)],
            WavePhase::Trough => [(0.0, pb), (base_depth + surface, p1), (base_depth, 0.0)],
        };
        loads(body, wall, pu)
    }
}
