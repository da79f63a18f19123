//! Conditions outside the range in which the formulas were found.

use std::f64::consts::TAU;
use std::fmt;

use super::{CaissonSection, Goda, Heights, Sea, shoaling};

/// A condition outside the formulas' range, with the values that triggered it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WaveWarning {
    /// The berm or the bed may make the waves break onto the wall, with impulsive pressures beyond these.
    ImpulsiveBreaking {
        /// B_M/L.
        berm_width_ratio: f64,
        /// d/h.
        berm_depth_ratio: f64,
        /// tanθ.
        bed_slope: f64,
        /// H₀'/L₀.
        steepness: f64,
    },
    /// h/L₀ ≥ 0.2: heights are shoaled from deep water without breaking.
    DeepWater {
        /// h/L₀.
        ratio: f64,
    },
    /// H_max is above Miche's limit 0.142 L tanh(2πh/L) for the depth at the wall.
    HigherThanBreaking {
        /// H_max, m.
        height: f64,
        /// The limit, m.
        limit: f64,
    },
    /// α₃ ≤ 0: the base is so deep that the formula would suck at it; no pressure is taken there.
    NoPressureAtBase {
        /// α₃.
        alpha_3: f64,
    },
    /// h' > h: the caisson's base lies below the sea bed in front of it.
    BaseBelowBed {
        /// h', m.
        base_depth: f64,
        /// h, m.
        water_depth: f64,
    },
    /// d > h': the armour of the berm lies below the base that it should cover.
    BermBelowBase {
        /// d, m.
        depth_above_berm: f64,
        /// h', m.
        base_depth: f64,
    },
    /// T_1/3 > 30 s: longer than wind waves and swell, for which the formulas were found.
    LongPeriod {
        /// T_1/3, s.
        period: f64,
    },
    /// H₀'/L₀ > 0.142: steeper than waves in deep water can be.
    SteepSea {
        /// H₀'/L₀.
        steepness: f64,
    },
    /// tanθ > 0.1: steeper than the beds for which the wave heights were computed.
    SteepBed {
        /// tanθ.
        bed_slope: f64,
    },
    /// Standing waves as high, or before a bed as steep, break on the wall.
    StandingWaveBreaks {
        /// H, m.
        height: f64,
        /// 0.142 L tanh(2πh/L), m.
        limit: f64,
        /// tanθ.
        bed_slope: f64,
    },
    /// A crown wall, or its sea, outside the tests that its formula comes from.
    CrownWallRange(CrownRatio),
}

/// A ratio beside the range in which a formula for crown walls was tested.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrownRatio {
    /// Its name.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// The lower end of the range.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl CrownRatio {
    /// True if it lies in the range, rounding apart.
    pub fn is_inside(&self) -> bool {
        let slack = 1e-9 * self.high;
        (self.low - slack..=self.high + slack).contains(&self.value)
    }
}

/// True if waves of this steepness H₀'/L₀ break on a wall without a berm for the slope of the bed, one of Goda's conditions.
pub(super) fn breaks_by_bed(bed_slope: f64, steepness: f64) -> bool {
    bed_slope > 0.02 && steepness < 0.03
}

/// The steepest that waves in deep water can be, H₀'/L₀: steeper ones break.
pub const STEEPEST: f64 = 0.142;

/// Miche's limit of the height of waves, m, for the depth at the wall.
pub(super) fn breaking_limit(wavelength: f64, depth: f64) -> f64 {
    STEEPEST * wavelength * (TAU * depth / wavelength).tanh()
}

/// Longest period of wind waves and swell, s.
const LONGEST_PERIOD: f64 = 30.0;

/// The steepest bed of the charts of wave heights that the formulas approximate.
const STEEPEST_BED: f64 = 0.1;

impl WaveWarning {
    pub(super) fn all(
        sea: &Sea,
        heights: &Heights,
        section: &CaissonSection,
        goda: &Goda,
    ) -> Vec<WaveWarning> {
        let h = sea.water_depth;
        let berm_width_ratio = section.berm_width / goda.wavelength;
        let berm_depth_ratio = section.depth_above_berm / h;
        let mut warnings = Vec::new();

        let bed_slope = sea.sea_bottom_slope;
        // From a height at the wall, the deep-water height that shoals to it.
        let deep_water_height = match *heights {
            Heights::DeepWater(height) => height,
            Heights::Local { significant, .. } => significant / shoaling(sea.period, h, sea.gravity),
        };
        let steepness = deep_water_height / goda.deep_water_wavelength;
        let narrow_berm = berm_width_ratio < 0.02 && breaks_by_bed(bed_slope, steepness);
        let high_berm = berm_width_ratio > 0.02 && berm_width_ratio < 0.3 && berm_depth_ratio < 0.6;
        let steep_front = goda.angle_deg < 20.0 && section.crest_height / goda.h_13 > 0.3;
        if steep_front && (narrow_berm || high_berm) {
            warnings.push(WaveWarning::ImpulsiveBreaking {
                berm_width_ratio,
                berm_depth_ratio,
                bed_slope,
                steepness,
            });
        }
        if steepness > STEEPEST && matches!(heights, Heights::DeepWater(_)) {
            warnings.push(WaveWarning::SteepSea { steepness });
        }
        let ratio = h / goda.deep_water_wavelength;
        if ratio >= 0.2 && matches!(heights, Heights::DeepWater(_)) {
            warnings.push(WaveWarning::DeepWater { ratio });
        }
        let limit = breaking_limit(goda.wavelength, h);
        if goda.h_max > limit {
            warnings.push(WaveWarning::HigherThanBreaking { height: goda.h_max, limit });
        }
        if goda.alpha_3 <= 0.0 {
            warnings.push(WaveWarning::NoPressureAtBase { alpha_3: goda.alpha_3 });
        }
        let CaissonSection { base_depth, depth_above_berm, .. } = *section;
        if base_depth > h {
            warnings.push(WaveWarning::BaseBelowBed { base_depth, water_depth: h });
        }
        if depth_above_berm > base_depth {
            warnings.push(WaveWarning::BermBelowBase { depth_above_berm, base_depth });
        }
        if sea.period > LONGEST_PERIOD {
            warnings.push(WaveWarning::LongPeriod { period: sea.period });
        }
        if bed_slope > STEEPEST_BED {
            warnings.push(WaveWarning::SteepBed { bed_slope });
        }
        warnings
    }
}

impl WaveWarning {
    /// Its name, to be told apart by programs.
    pub fn name(&self) -> &'static str {
        match self {
            WaveWarning::ImpulsiveBreaking { .. } => "impulsive-breaking",
            WaveWarning::DeepWater { .. } => "deep-water",
            WaveWarning::HigherThanBreaking { .. } => "higher-than-breaking",
            WaveWarning::NoPressureAtBase { .. } => "no-pressure-at-base",
            WaveWarning::BaseBelowBed { .. } => "base-below-bed",
            WaveWarning::BermBelowBase { .. } => "berm-below-base",
            WaveWarning::LongPeriod { .. } => "long-period",
            WaveWarning::SteepBed { .. } => "steep-bed",
            WaveWarning::SteepSea { .. } => "steep-sea",
            WaveWarning::StandingWaveBreaks { .. } => "sainflou-breaking",
            WaveWarning::CrownWallRange(_) => "crown-wall-range",
        }
    }
}

impl fmt::Display for WaveWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WaveWarning::ImpulsiveBreaking { berm_width_ratio, berm_depth_ratio, bed_slope, steepness } => {
                write!(
                    f,
                    "impulsive breaking is possible: berm width B_M/L = {berm_width_ratio:.3}, depth above the berm \
                 d/h = {berm_depth_ratio:.3}, bed slope {bed_slope:.3}, steepness H0'/L0 = {steepness:.4}; the \
                 pressures may be exceeded"
                )
            }
            WaveWarning::DeepWater { ratio } => write!(
                f,
                "h/L0 = {ratio:.3} is not below 0.2: wave heights are shoaled from deep water without breaking"
            ),
            WaveWarning::HigherThanBreaking { height, limit } => write!(
                f,
                "H_max = {height:.2} m is above the breaking limit {limit:.2} m at the wall's depth \
                 (0.142 L tanh 2πh/L)"
            ),
            WaveWarning::NoPressureAtBase { alpha_3 } => {
                write!(f, "alpha_3 = {alpha_3:.3}: no pressure is taken at so deep a base")
            }
            WaveWarning::BaseBelowBed { base_depth, water_depth } => write!(
                f,
                "base_depth = {base_depth:.2} m is more than the water depth {water_depth:.2} m: the base would lie \
                 below the sea bed in front of it"
            ),
            WaveWarning::BermBelowBase { depth_above_berm, base_depth } => write!(
                f,
                "depth_above_berm = {depth_above_berm:.2} m is more than base_depth = {base_depth:.2} m: the berm \
                 would lie below the base"
            ),
            WaveWarning::LongPeriod { period } => write!(
                f,
                "period = {period} s is longer than that of wind waves and swell ({LONGEST_PERIOD} s at most), for which \
                 the formulas were found"
            ),
            WaveWarning::SteepSea { steepness } => write!(
                f,
                "steepness H0'/L0 = {steepness:.3} is more than waves in deep water can have, {STEEPEST}: they break"
            ),
            WaveWarning::SteepBed { bed_slope } => write!(
                f,
                "bed slope {bed_slope}: the wave heights were computed for beds of {STEEPEST_BED} at most"
            ),
            WaveWarning::StandingWaveBreaks { height, limit, .. } if height > limit => write!(
                f,
                "H = {height:.2} m is above the breaking limit {limit:.2} m at the wall's depth (0.142 L tanh 2πh/L): Sainflou's waves do \
                 not break"
            ),
            WaveWarning::StandingWaveBreaks { height, bed_slope, .. } => write!(
                f,
                "waves of H = {height:.2} m may break on the wall over a bed of slope {bed_slope:.3}: Sainflou's waves do not break"
            ),
            WaveWarning::CrownWallRange(CrownRatio { name, value, low, high }) => write!(
                f,
                "{name} = {value:.3} is outside {low} to {high}, the range in which the formula for crown walls was tested"
            ),
        }
    }
}
