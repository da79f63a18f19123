//! Design wave heights at the wall from the deep-water height, by Goda's formulas for random waves breaking on a slope.

use super::{Sea, deep_water_wavelength, shoaling};

/// Wave heights at the wall and what they were computed from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignHeights {
    /// K_s, linear shoaling at the wall.
    pub shoaling: f64,
    /// H_1/3 at the wall, m.
    pub significant: f64,
    /// h_b = h + 5 H_1/3 tanθ, the depth five significant heights in front of the wall, m.
    pub breaking_depth: f64,
    /// H_max, m.
    pub maximum: f64,
    /// True if waves may break on the slope, h/L₀ < 0.2; deeper water only shoals.
    pub may_break: bool,
    /// The terms of H_1/3 at h.
    pub significant_terms: BreakingTerms,
    /// The terms of H_max at h_b.
    pub maximum_terms: BreakingTerms,
    /// Set of the formulas that applied where several limit each other; see [`Goda::formulas`](super::Goda::formulas).
    pub formulas: u32,
}

/// The coefficients of a breaking height, min{β₀H₀' + β₁h, β_max H₀'}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BreakingTerms {
    /// β₀.
    pub beta_0: f64,
    /// β₁.
    pub beta_1: f64,
    /// β_max.
    pub beta_max: f64,
}

impl DesignHeights {
    /// The heights for the equivalent deep-water height H₀' (m). Formulas for breaking waves hold for h/L₀ < 0.2;
    /// deeper water only shoals.
    pub(super) fn from_deep_water(sea: &Sea, height: f64) -> DesignHeights {
        DesignHeights::shoaled(sea, shoaling(sea.period, sea.water_depth, sea.gravity), height)
    }

    /// Heights for the equivalent deep-water height H₀' (m) and K_s, which depends on the sea alone.
    pub(super) fn shoaled(sea: &Sea, k_s: f64, height: f64) -> DesignHeights {
        let Sea { water_depth: h, sea_bottom_slope: t, period, gravity, .. } = *sea;
        let l0 = deep_water_wavelength(period, gravity);
        let steepness = height / l0;
        let may_break = h / l0 < 0.2;
        // min{β₀H₀' + β₁h, β_max H₀', K_s H₀'}, for H_1/3 at h and for H_max at h_b.
        let terms = |[c0, c1, s1, least, c_max]: [f64; 5]| BreakingTerms {
            beta_0: c0 * steepness.powf(-0.38) * (20.0 * t.powf(1.5)).exp(),
            beta_1: c1 * (s1 * t).exp(),
            beta_max: (c_max * steepness.powf(-0.29) * (2.4 * t).exp()).max(least),
        };
        let limited = |depth: f64, terms: &BreakingTerms, shoaled: f64| {
            let breaking = (terms.beta_0 * height + terms.beta_1 * depth).min(terms.beta_max * height);
            if may_break { breaking.min(shoaled) } else { shoaled }
        };
        let significant_terms = terms([0.028, 0.52, 4.2, 0.92, 0.32]);
        let maximum_terms = terms([0.052, 0.63, 3.8, 1.65, 0.53]);
        let significant = limited(h, &significant_terms, k_s * height);
        let breaking_depth = breaking_depth(sea, significant);
        let maximum = limited(breaking_depth, &maximum_terms, 1.8 * k_s * height);
        let which = |height_at_wall: f64, shoaled: f64, terms: &BreakingTerms, least: f64| {
            let steep = u32::from(terms.beta_max == least);
            if height_at_wall == shoaled {
                0
            } else {
                1 + steep + 2 * u32::from(height_at_wall == terms.beta_max * height)
            }
        };
        let formulas = which(significant, k_s * height, &significant_terms, 0.92)
            + 8 * which(maximum, 1.8 * k_s * height, &maximum_terms, 1.65);
        DesignHeights {
            shoaling: k_s,
            significant,
            breaking_depth,
            maximum,
            may_break,
            significant_terms,
            maximum_terms,
            formulas,
        }
    }
}

/// h_b, m.
pub(super) fn breaking_depth(sea: &Sea, significant: f64) -> f64 {
    sea.water_depth + 5.0 * significant * sea.sea_bottom_slope
}
