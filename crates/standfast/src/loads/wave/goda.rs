//! The pressures, their resultants, and every number on the way to them.

use std::f64::consts::TAU;

use super::heights::breaking_depth;
use super::pressed::{loads, numbered, resultants};
use super::{
    CaissonSection, Choices, DesignHeights, Heights, Sea, WaveWarning, deep_water_wavelength, wavelength,
};
use crate::body::Body;
use crate::error::InputError;
use crate::loads::Load;

/// Goda's pressures on a wall and everything they were computed from; SI units, per metre run. Fields carry the names
/// of the [module's table](super).
#[derive(Debug, Clone, PartialEq)]
pub struct Goda {
    /// β after the turn towards the normal, degrees.
    pub angle_deg: f64,
    /// Computed from deep water, or `None` where the heights were given at the wall.
    pub heights: Option<DesignHeights>,
    /// H_1/3, m.
    pub h_13: f64,
    /// H_max, m.
    pub h_max: f64,
    /// L₀, m.
    pub deep_water_wavelength: f64,
    /// L, m.
    pub wavelength: f64,
    /// h_b, m.
    pub h_b: f64,
    /// η*, m: how far above still water the pressure would reach.
    pub eta_star: f64,
    /// α₁.
    pub alpha_1: f64,
    /// α₂.
    pub alpha_2: f64,
    /// α₃.
    pub alpha_3: f64,
    /// α₄.
    pub alpha_4: f64,
    /// α_I, Takahashi's impulsive coefficient, whether used or not.
    pub alpha_impulsive: f64,
    /// Terms from which α_I was computed.
    pub impulsive: Impulsive,
    /// α*, the larger of α₂ and α_I, or α₂.
    pub alpha_star: f64,
    /// h_c*, m: how far above still water the pressure reaches on the wall.
    pub h_c_star: f64,
    /// p₁ at still water, Pa.
    pub p1: f64,
    /// p₃ at the base, Pa.
    pub p3: f64,
    /// p₄ at the top of the loaded wall, Pa.
    pub p4: f64,
    /// p_u at the seaward toe, Pa; zero at the heel.
    pub pu: f64,
    /// P, N/m: horizontal force on the wall.
    pub force: f64,
    /// M_p, N·m/m: its moment about the base.
    pub force_moment: f64,
    /// U, N/m: uplift.
    pub uplift: f64,
    /// M_U, N·m/m: its moment about the heel.
    pub uplift_moment: f64,
    /// Set of the formulas that applied where several limit each other, as one number: how waves break, 2d/H_max in α₂, α_I or α₂, the
    /// crest or η*, a base below all pressure. Pressures have a kink where it changes.
    pub formulas: u32,
    /// Conditions outside the range of the formulas.
    pub warnings: Vec<WaveWarning>,
}

/// The steps to Takahashi's α_I = α_I0 α_I1 (Takahashi, Tanimoto and Shimosako 1994).
///
/// ```text
/// δ₁₁ = 0.93(B_M/L − 0.12) + 0.36((h−d)/h − 0.6)      δ₁ = 20δ₁₁ for δ₁₁ ≤ 0, else 15δ₁₁
/// δ₂₂ = −0.36(B_M/L − 0.12) + 0.93((h−d)/h − 0.6)     δ₂ = 4.9δ₂₂ for δ₂₂ ≤ 0, else 3δ₂₂
/// α_I0 = min{H/d, 2}       α_I1 = cosδ₂/coshδ₁ for δ₂ ≤ 0, else 1/(coshδ₁ √coshδ₂)
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impulsive {
    /// δ₁₁.
    pub delta_11: f64,
    /// δ₂₂.
    pub delta_22: f64,
    /// δ₁.
    pub delta_1: f64,
    /// δ₂.
    pub delta_2: f64,
    /// α_I0.
    pub alpha_i0: f64,
    /// α_I1.
    pub alpha_i1: f64,
}

/// The wave pressures on a wall.
///
/// # Errors
/// If a number is not finite or not possible: a berm deeper than the sea, a crest under water, a maximum wave below
/// the significant one, a turn beyond 15 degrees.
pub fn goda(
    sea: &Sea,
    heights: &Heights,
    section: &CaissonSection,
    choices: &Choices,
) -> Result<Goda, InputError> {
    sea.check()?;
    heights.check()?;
    section.check(sea)?;
    choices.check()?;

    let Sea { water_depth: h, period, gravity: g, .. } = *sea;
    let l0 = deep_water_wavelength(period, g);
    let l = wavelength(period, h, g);
    let [in_deep_water, at_wall] = choices.height_factors;
    let heights = match *heights {
        Heights::DeepWater(height) => Heights::DeepWater(height * in_deep_water),
        at_wall => at_wall,
    };
    let (computed, found) = match heights {
        Heights::DeepWater(height) => {
            heights.check()?;
            let computed = DesignHeights::from_deep_water(sea, height);
            (Some(computed), [computed.significant, computed.maximum])
        }
        Heights::Local { significant, maximum } => (None, [significant, maximum]),
    };
    let [significant, maximum] = found.map(|height| at_wall * height);
    Heights::Local { significant, maximum }.check()?;
    let mut goda = pressures(sea, (l0, l), computed, [significant, maximum], section, choices);
    goda.warnings = WaveWarning::all(sea, &heights, section, &goda);
    Ok(goda)
}

/// Pressures that follow from the wavelengths L₀ and L and the heights H_1/3 and H_max, but for warnings.
fn pressures(
    sea: &Sea,
    (l0, l): (f64, f64),
    computed: Option<DesignHeights>,
    [h_13, h_max]: [f64; 2],
    section: &CaissonSection,
    choices: &Choices,
) -> Goda {
    let Sea { water_depth: h, water_density: ρ, gravity: g, .. } = *sea;
    let CaissonSection { base_depth, depth_above_berm: d, crest_height, caisson_width, .. } = *section;
    let [λ1, λ2, λ3] = choices.lambda;
    let h_b = breaking_depth(sea, h_13);
    let angle_deg = (sea.angle_deg - choices.turn_deg).max(0.0);
    let cos_β = angle_deg.to_radians().cos();

    let κh = TAU * h / l;
    let η_star = 0.75 * (1.0 + cos_β) * λ1 * h_max;
    let α1 = 0.6 + 0.5 * (2.0 * κh / (2.0 * κh).sinh()).powi(2);
    let α2 = ((h_b - d) / (3.0 * h_b) * (h_max / d).powi(2)).min(2.0 * d / h_max);
    let α3 = 1.0 - base_depth / h * (1.0 - 1.0 / κh.cosh());
    let h_c_star = η_star.min(crest_height);
    // Without a standing pressure nothing reaches above still water.
    let α4 = if η_star > 0.0 { 1.0 - h_c_star / η_star } else { 0.0 };
    let impulsive = Impulsive::of(h_max, h, d, section.berm_width / l);
    let α_impulsive = impulsive.alpha_i0 * impulsive.alpha_i1;
    let α_star = if choices.impulsive { α2.max(α_impulsive) } else { α2 };

    let obliquity = 0.5 * (1.0 + cos_β);
    let p1 = obliquity * (λ1 * α1 + λ2 * α_star * cos_β * cos_β) * ρ * g * h_max;
    // A base so deep that α₃ is negative would be sucked at; there is no pressure then, and a warning.
    let p3 = α3.max(0.0) * p1;
    let p4 = α4 * p1;
    let pu = if choices.uplift { obliquity * λ3 * α1 * α3.max(0.0) * ρ * g * h_max } else { 0.0 };
    let uplift = 0.5 * pu * caisson_width;
    let limits = [
        α2 == 2.0 * d / h_max,
        h_c_star == crest_height,
        α3 < 0.0,
        choices.impulsive && α_impulsive > α2,
        choices.impulsive && impulsive.alpha_i0 == 2.0,
        choices.impulsive && impulsive.delta_11 <= 0.0,
        choices.impulsive && impulsive.delta_22 <= 0.0,
    ];
    let formulas = numbered(computed.map_or(0, |heights| heights.formulas), &limits);
    let [force, force_moment] = resultants([p3, p1, p4], base_depth, h_c_star);
    Goda {
        angle_deg,
        heights: computed,
        h_13,
        h_max,
        deep_water_wavelength: l0,
        wavelength: l,
        h_b,
        eta_star: η_star,
        alpha_1: α1,
        alpha_2: α2,
        alpha_3: α3,
        alpha_4: α4,
        alpha_impulsive: α_impulsive,
        impulsive,
        alpha_star: α_star,
        h_c_star,
        p1,
        p3,
        p4,
        pu,
        force,
        force_moment,
        uplift,
        uplift_moment: 2.0 / 3.0 * uplift * caisson_width,
        formulas,
        warnings: Vec::new(),
    }
}

impl Goda {
    /// The pressures of the same sea with another deep-water height (m), without warnings; `None` where these were found from
    /// heights at the wall, or the height is not a number above zero. What depends on period and depth alone is not worked out again.
    pub fn from_deep_water(
        &self,
        sea: &Sea,
        section: &CaissonSection,
        choices: &Choices,
        height: f64,
    ) -> Option<Goda> {
        let [in_deep_water, at_wall] = choices.height_factors;
        let height = height * in_deep_water;
        Heights::DeepWater(height).check().ok()?;
        let computed = DesignHeights::shoaled(sea, self.heights?.shoaling, height);
        let lengths = (self.deep_water_wavelength, self.wavelength);
        let heights = [computed.significant, computed.maximum].map(|height| at_wall * height);
        if heights[0] <= 0.0 {
            return None;
        }
        Some(pressures(sea, lengths, Some(computed), heights, section, choices))
    }

    /// The pressures under one wave of this height (m) in the same sea, whose H_1/3 and wavelength stay. Warnings are left out.
    pub fn under_wave(&self, sea: &Sea, section: &CaissonSection, choices: &Choices, height: f64) -> Goda {
        let lengths = (self.deep_water_wavelength, self.wavelength);
        pressures(sea, lengths, self.heights, [self.h_13, height], section, choices)
    }

    /// The pressures as loads on `body`, whose base lies `base_depth` below still water (m): on its right side, and under its
    /// base, where they press there.
    pub fn loads(&self, body: &Body, base_depth: f64) -> Vec<Load> {
        let Goda { p1, p3, p4, pu, h_c_star, .. } = *self;
        loads(body, [(0.0, p3), (base_depth, p1), (base_depth + h_c_star, p4)], pu)
    }
}

impl Impulsive {
    /// For the berm width relative to the wavelength.
    fn of(h_max: f64, h: f64, d: f64, relative_width: f64) -> Impulsive {
        let (width, height) = (relative_width - 0.12, (h - d) / h - 0.6);
        let δ11 = 0.93 * width + 0.36 * height;
        let δ22 = -0.36 * width + 0.93 * height;
        let δ1 = if δ11 <= 0.0 { 20.0 } else { 15.0 } * δ11;
        let δ2 = if δ22 <= 0.0 { 4.9 } else { 3.0 } * δ22;
        let alpha_i1 =
            if δ2 <= 0.0 { δ2.cos() / δ1.cosh() } else { 1.0 / (δ1.cosh() * δ2.cosh().sqrt()) };
        Impulsive {
            delta_11: δ11,
            delta_22: δ22,
            delta_1: δ1,
            delta_2: δ2,
            alpha_i0: (h_max / d).min(2.0),
            alpha_i1,
        }
    }
}
