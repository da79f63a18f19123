//! Pressure of soil on a wall: from its angles of friction to what pushes the body and drags it down.
//!
//! φ is the angle of friction of the soil, δ that between soil and wall, β the slope of the ground, rising away from the wall, θ the batter
//! of its back (above zero the soil stands on the back: the wall is wider at its foot), ψ the angle by which an earthquake turns gravity:
//!
//! ```text
//! K = cos²(φ−θ−ψ)/{cos ψ cos²θ cos(θ+δ+ψ) [1 + √(sin(φ+δ) sin(φ−β−ψ)/(cos(θ+δ+ψ) cos(θ−β)))]²}
//! K_0 = (1 − sin φ) OCR^(sin φ) (1 + sin β)                             at rest
//! e(z) = max(0, K σ'(z) + K q cos θ cos β/cos(θ−β) − c K_c)             K_c = min(2√(K(1 + a/c)), 2.56√K)
//! ```
//!
//! K_p = tan²(45° + φ/2), to the power 1 + 1.443 (δ/φ) sin φ with friction on an upright wall beside level ground (a log spiral, fitted): of the
//! passive state e = K_p σ' + 2c√K_p, a resistance against the wall.
//!
//! z counts downwards from the ground where it meets the wall, σ' = Σγ Δz with γ above the water and γ_sat − γ_w below it, q is the
//! surcharge per horizontal metre, c cohesion and a adhesion. Per metre of height e cos(θ+δ) presses on the wall and e sin(θ+δ) drags it
//! down, linear from point to point, with a step where the soil changes. Water in the soil is a load of its own.
//!
//! K is Coulomb's for ψ = 0, Rankine's for θ = 0 and δ = β, else of Mononobe and Okabe: that of the plane wedge that pushes most. In an
//! earthquake, with (1 − k_v)g the acceleration that weighs the soil,
//!
//! ```text
//! e_E(z) = K_E (1 − k_v)(σ' + q cos θ cos β/cos(θ−β))    ΔP = ∫(e_E − e) cos(θ+δ) dz
//! tan ψ = k_h/(1 − k_v) above the water;   γ_sat k_h/((γ_sat − γ_w)(1 − k_v)) below it where the water moves with the soil,
//!         γ_d k_h/((γ_sat − γ_w)(1 − k_v)) where it moves freely, and then presses with 7/12 k_h γ_w H_w² at 0.4 H_w beside
//! ```
//!
//! The static pressure stays where it is; the increment ΔP is straight from ΔP(4 − 6η)/H at the foot to ΔP(6η − 2)/H at the top.

use super::{Action, Face, Load, LoadKind, LoadSource, PressureDiagram};
use crate::body::Body;

/// A soil; angles in degrees, SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Soil {
    /// φ, from 15 to 50.
    pub friction_angle_deg: f64,
    /// δ, φ at most to either side; below zero where the wall settles more than the soil.
    pub wall_friction_deg: f64,
    /// γ above the water, N/m³.
    pub unit_weight: f64,
    /// γ_sat, N/m³; needed where water stands in the soil.
    pub unit_weight_saturated: Option<f64>,
    /// γ_d, N/m³; of an earthquake with free pore water. That of the moist soil where it is not given.
    pub unit_weight_dry: Option<f64>,
    /// c, Pa.
    pub cohesion: f64,
    /// a on the wall, Pa.
    pub adhesion: f64,
    /// Overconsolidation ratio, of a pressure at rest.
    pub ocr: f64,
}

impl Soil {
    /// Its unit weight, its water with it where it is wet, N/m³.
    fn weight(&self, wet: bool) -> f64 {
        match self.unit_weight_saturated {
            Some(saturated) if wet => saturated,
            _ => self.unit_weight,
        }
    }
}

/// A layer of soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoilLayer {
    /// The soil.
    pub soil: Soil,
    /// Thickness at the wall, m; that of the last layer may reach below the base.
    pub thickness: f64,
}

/// State of a soil beside a wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EarthState {
    /// The wall gives way: the least push.
    Active,
    /// The wall does not move.
    AtRest,
    /// The wall is driven into it: the most that it resists with.
    Passive,
}

/// Movement of the water in a soil that is shaken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PoreWater {
    /// Apart from the soil, as in gravel.
    Free,
    /// With the soil.
    WithSoil,
}

/// Soil beside a face of the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Backfill {
    /// [`Face::Left`] or [`Face::Right`].
    pub face: Face,
    /// The ground at the face, above the base, m.
    pub top: f64,
    /// Whether the wall gives way.
    pub state: EarthState,
    /// β, degrees, below φ.
    pub slope_deg: f64,
    /// θ, degrees, from −20 to 30.
    pub batter_deg: f64,
    /// q, Pa.
    pub surcharge: f64,
    /// The layers from the top down, which reach the base.
    pub layers: Vec<SoilLayer>,
    /// Movement of its water in an earthquake.
    pub pore_water: PoreWater,
    /// η: height of the increment of an earthquake, as a share of that of the soil.
    pub increment_at: f64,
}

/// Still water in a soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundWater {
    /// Above the base, m.
    pub level: f64,
    /// γ_w, N/m³.
    pub unit_weight: f64,
}

/// Acceleration of the base in shares of gravity, as a soil at a wall sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaking {
    /// k_h, not below zero: towards the soil, whose inertia presses it against the wall.
    pub horizontal: f64,
    /// 1 − k_v, above zero.
    pub gravity: f64,
}

/// Pressure of a soil at a height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EarthPoint {
    /// Above the base, m.
    pub elevation: f64,
    /// Against the upright, Pa.
    pub normal: f64,
    /// Down the wall, per metre of height, Pa.
    pub tangential: f64,
}

/// Coefficients of a layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EarthCoefficients {
    /// K, K_0 or K_p.
    pub k: f64,
    /// K_c, of its cohesion; zero where it has none, and at rest; below zero in the passive state, where cohesion adds.
    pub k_c: f64,
}

/// Pressure of a soil on a wall.
#[derive(Debug, Clone, PartialEq)]
pub struct EarthPressure {
    /// Of each layer.
    pub coefficients: Vec<EarthCoefficients>,
    /// Of its weight, from the base up.
    pub soil: Vec<EarthPoint>,
    /// What the surcharge adds; empty where there is none.
    pub surcharge: Vec<EarthPoint>,
}

/// What an earthquake adds to the pressure of a soil.
#[derive(Debug, Clone, PartialEq)]
pub struct EarthIncrement {
    /// K_E of each layer, above the water and below it, with its ψ in degrees; `None` at rest, and of what has no part above or below.
    pub coefficients: Vec<[Option<[f64; 2]>; 2]>,
    /// ΔP against the upright, N per metre run.
    pub force: f64,
    /// Down the wall, N per metre run.
    pub drag: f64,
    /// Its straight diagram, from the base up.
    pub points: Vec<EarthPoint>,
    /// 7/12 k_h γ_w H_w² of free pore water, N per metre run, and its height above the base, m.
    pub pore_water: Option<[f64; 2]>,
}

/// A state in which no wedge of soil holds: the ground is steeper than its friction, turned by an earthquake, allows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TooSteep {
    /// The layer, from the top.
    pub layer: usize,
    /// The greatest k_h at which it holds.
    pub greatest: f64,
}

/// K of the active state, of Coulomb, or of Mononobe and Okabe; angles in degrees. NaN where φ − β − ψ < 0.
pub fn active(φ: f64, δ: f64, β: f64, θ: f64, ψ: f64) -> f64 {
    let [φ, δ, β, θ, ψ] = [φ, δ, β, θ, ψ].map(f64::to_radians);
    // What rounding leaves below zero of a slope as steep as it can be is nothing.
    let steep = match (φ - β - ψ).sin() {
        sin if sin < 0.0 && sin > -1e-12 => 0.0,
        sin => sin,
    };
    let inclined = (θ + δ + ψ).cos();
    let root = ((φ + δ).sin() * steep / (inclined * (θ - β).cos())).sqrt();
    (φ - θ - ψ).cos().powi(2) / (ψ.cos() * θ.cos().powi(2) * inclined * (1.0 + root).powi(2))
}

/// K_0, of a soil at rest; angles in degrees.
pub fn at_rest(φ: f64, β: f64, ocr: f64) -> f64 {
    let sin = φ.to_radians().sin();
    (1.0 - sin) * ocr.powf(sin) * (1.0 + β.to_radians().sin())
}

/// K_p of the passive state beside an upright wall and level ground; angles in degrees.
pub fn passive(φ: f64, δ: f64) -> f64 {
    let sin = φ.to_radians().sin();
    let of_rankine = (45.0 + φ / 2.0).to_radians().tan().powi(2);
    of_rankine.powf(1.0 + 1.443 * (δ / φ) * sin)
}

/// K_c, of cohesion `c` with adhesion `a`, beside `k`.
pub fn of_cohesion(k: f64, c: f64, a: f64) -> f64 {
    if c == 0.0 { 0.0 } else { (2.0 * (k * (1.0 + a / c)).sqrt()).min(2.56 * k.sqrt()) }
}

/// A stretch of one soil on one side of the water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoilStretch<'a> {
    /// The layer, from the top.
    pub layer: usize,
    /// Its soil.
    pub soil: &'a Soil,
    /// Its ends above the base, the upper first, m.
    pub ends: [f64; 2],
    /// σ' there, Pa.
    pub stress: [f64; 2],
    /// True if it lies below the water.
    pub wet: bool,
}

impl Backfill {
    /// Coefficients of each layer.
    pub fn coefficients(&self) -> Vec<EarthCoefficients> {
        let of = |SoilLayer { soil, .. }: &SoilLayer| match self.state {
            EarthState::Active => {
                let Soil { friction_angle_deg: φ, wall_friction_deg: δ, cohesion, adhesion, .. } = *soil;
                let k = active(φ, δ, self.slope_deg, self.batter_deg, 0.0);
                EarthCoefficients { k, k_c: of_cohesion(k, cohesion, adhesion) }
            }
            EarthState::AtRest => {
                let k = at_rest(soil.friction_angle_deg, self.slope_deg, soil.ocr);
                EarthCoefficients { k, k_c: 0.0 }
            }
            // What holds together resists the more.
            EarthState::Passive => {
                let k = passive(soil.friction_angle_deg, soil.wall_friction_deg);
                EarthCoefficients { k, k_c: -2.0 * k.sqrt() }
            }
        };
        self.layers.iter().map(of).collect()
    }

    /// The upper and the lower end of each layer above the base, m; the last reaches the base.
    pub fn bounds(&self) -> Vec<[f64; 2]> {
        let mut upper = self.top;
        let layers = self.layers.iter().enumerate();
        let bounds = layers.map(|(layer, SoilLayer { thickness, .. })| {
            let last = layer + 1 == self.layers.len();
            let lower = if last { 0.0 } else { (upper - thickness).max(0.0) };
            [std::mem::replace(&mut upper, lower), lower]
        });
        bounds.collect()
    }

    /// The stretches of soil and water, from the top down to the base.
    pub fn stretches(&self, water: Option<GroundWater>) -> Vec<SoilStretch<'_>> {
        let (mut upper, mut stress) = (self.top, 0.0);
        let mut stretches = Vec::new();
        for (layer, (SoilLayer { soil, .. }, [_, bottom])) in
            self.layers.iter().zip(self.bounds()).enumerate()
        {
            let level = water.map_or(f64::NEG_INFINITY, |water| water.level);
            for lower in [level, bottom].map(|end| end.max(bottom)) {
                if lower >= upper {
                    continue;
                }
                let wet = upper <= level;
                let lifted = water.filter(|_| wet).map_or(0.0, |water| water.unit_weight);
                let below = stress + (soil.weight(wet) - lifted) * (upper - lower);
                stretches.push(SoilStretch {
                    layer,
                    soil,
                    ends: [upper, lower],
                    stress: [stress, below],
                    wet,
                });
                (upper, stress) = (lower, below);
            }
        }
        stretches
    }

    /// q cos θ cos β/cos(θ − β): the surcharge as the wedge has it, Pa.
    pub fn weighed_surcharge(&self) -> f64 {
        let [β, θ] = [self.slope_deg, self.batter_deg].map(f64::to_radians);
        match self.state {
            EarthState::Active => self.surcharge * (θ.cos() * β.cos() / (θ - β).cos()),
            EarthState::AtRest | EarthState::Passive => self.surcharge,
        }
    }

    /// The pressure of a soil with `water` in it.
    pub fn pressure(&self, water: Option<GroundWater>) -> EarthPressure {
        let coefficients = self.coefficients();
        let surcharge = self.weighed_surcharge();
        let (mut soil_points, mut surcharge_points) = (Vec::new(), Vec::new());
        for stretch in self.stretches(water) {
            let EarthCoefficients { k, k_c } = coefficients[stretch.layer];
            let held = stretch.soil.cohesion * k_c;
            let of_soil = stretch.stress.map(|stress| k * stress - held);
            let of_both = of_soil.map(|e| e + k * surcharge);
            // Ends, and where either passes zero, from the top down.
            let share = |[upper, lower]: [f64; 2]| {
                (upper.min(lower) < 0.0 && upper.max(lower) > 0.0).then(|| upper / (upper - lower))
            };
            let mut shares = vec![0.0, 1.0];
            shares.extend(share(of_soil));
            shares.extend(share(of_both).filter(|_| surcharge != 0.0));
            shares.sort_by(f64::total_cmp);
            shares.dedup();
            let along = |[upper, lower]: [f64; 2], share: f64| upper + (lower - upper) * share;
            // What a passive soil resists with is taken along the base alone.
            let angle = match self.state {
                EarthState::Passive => 0.0,
                _ => (self.batter_deg + stretch.soil.wall_friction_deg).to_radians(),
            };
            for share in shares {
                let soil = along(of_soil, share).max(0.0);
                let point = |e: f64| EarthPoint {
                    elevation: along(stretch.ends, share),
                    normal: e * angle.cos(),
                    tangential: e * angle.sin(),
                };
                soil_points.push(point(soil));
                // Without cohesion it is the same all over the layer.
                surcharge_points.push(point(match held {
                    0.0 => k * surcharge,
                    _ => along(of_both, share).max(0.0) - soil,
                }));
            }
        }
        if self.surcharge == 0.0 {
            surcharge_points.clear();
        }
        let [soil, surcharge] = [soil_points, surcharge_points].map(from_base);
        EarthPressure { coefficients, soil, surcharge }
    }

    /// What an earthquake adds that drives the soil against the wall.
    ///
    /// # Errors
    /// If the soil is too steep for it.
    pub fn increment(
        &self,
        water: Option<GroundWater>,
        shaking: Shaking,
    ) -> Result<EarthIncrement, TooSteep> {
        let Shaking { horizontal: k_h, gravity } = shaking;
        let stretches = self.stretches(water);
        let wet_height = water.map_or(0.0, |water| water.level.min(self.top));
        let mut coefficients = vec![[None; 2]; self.layers.len()];
        let (mut force, mut drag) = (0.0, 0.0);
        let height = self.top;
        let mut at = self.increment_at;
        match self.state {
            EarthState::Active => {
                let surcharge = self.weighed_surcharge();
                for SoilStretch { layer, soil, ends, stress, wet } in &stretches {
                    let Soil { friction_angle_deg: φ, wall_friction_deg: δ, .. } = **soil;
                    let heavier = self.inertia_share(soil, water.filter(|_| *wet));
                    let ψ = (heavier * k_h / gravity).atan().to_degrees();
                    if φ - self.slope_deg - ψ < -1e-9 {
                        let greatest = gravity * (φ - self.slope_deg).to_radians().tan() / heavier;
                        return Err(TooSteep { layer: *layer, greatest });
                    }
                    let k_e = active(φ, δ, self.slope_deg, self.batter_deg, ψ);
                    coefficients[*layer][usize::from(*wet)] = Some([k_e, ψ]);
                    let mean = (stress[0] + stress[1]) / 2.0 + surcharge;
                    let sum = k_e * gravity * mean * (ends[0] - ends[1]);
                    let angle = (self.batter_deg + δ).to_radians();
                    force += sum * angle.cos();
                    drag += sum * angle.sin();
                }
                let EarthPressure { soil, surcharge, .. } = self.pressure(water);
                for points in [soil, surcharge] {
                    force -= sums(&points, |point| point.normal)[0];
                    drag -= sums(&points, |point| point.tangential)[0];
                }
            }
            // Wood's, of a wall that does not yield.
            EarthState::AtRest => {
                let weight = |stretch: &SoilStretch<'_>| {
                    stretch.soil.weight(stretch.wet) * (stretch.ends[0] - stretch.ends[1])
                };
                force = k_h * stretches.iter().map(weight).sum::<f64>() * height;
                at = 0.6;
            }
            // It stays what it is.
            EarthState::Passive => {}
        }
        let point = |elevation: f64, share: f64| EarthPoint {
            elevation,
            normal: force * share / height,
            tangential: drag * share / height,
        };
        let points = vec![point(0.0, 4.0 - 6.0 * at), point(height, 6.0 * at - 2.0)];
        let free = water.filter(|_| self.pore_water == PoreWater::Free && wet_height > 0.0 && k_h > 0.0);
        let pore_water = free.map(|water| {
            [7.0 / 12.0 * k_h * water.unit_weight * wet_height * wet_height, PORE_WATER_AT * wet_height]
        });
        Ok(EarthIncrement { coefficients, force, drag, points, pore_water })
    }

    /// What is shaken over what weighs: the share by which k_h counts in tan ψ.
    fn inertia_share(&self, soil: &Soil, water: Option<GroundWater>) -> f64 {
        let Some(water) = water else { return 1.0 };
        let saturated = soil.weight(true);
        let shaken = match self.pore_water {
            PoreWater::WithSoil => saturated,
            PoreWater::Free => soil.unit_weight_dry.unwrap_or(soil.unit_weight),
        };
        shaken / (saturated - water.unit_weight)
    }

    /// True if a layer has water in it that stands up to `level`.
    pub fn is_wet(&self, layer: usize, level: f64) -> bool {
        level > self.bounds()[layer][1]
    }

    /// The loads of a pressure: what pushes, and what drags the body down.
    pub fn loads(&self, points: &[EarthPoint]) -> Vec<Load> {
        let diagram = |of: fn(&EarthPoint) -> f64| {
            PressureDiagram::through(points.iter().map(|point| (point.elevation, of(point))))
        };
        let push = Action::Pressure { face: self.face, diagram: diagram(|point| point.normal) };
        let mut loads = vec![Load::permanent(LoadSource::EarthPressure, LoadKind::Horizontal, push)];
        if points.iter().any(|point| point.tangential != 0.0) {
            let (face, batter) = (self.face, self.batter_deg.to_radians().tan());
            let drag = Action::Drag { face, batter, diagram: diagram(|point| point.tangential) };
            loads.push(Load::permanent(LoadSource::EarthDrag, LoadKind::Weight, drag));
        }
        loads
    }

    /// The push of free pore water in an earthquake.
    pub fn pore_load(&self, body: &Body, [force, elevation]: [f64; 2]) -> Load {
        let towards = if self.face == Face::Right { -force } else { force };
        let length = body.plan().side(body.width());
        let push = Action::horizontal(towards * length, elevation);
        Load::variable(LoadSource::PoreWater, LoadKind::Horizontal, push)
    }
}

/// Points from the base up, of those from the top down; at one elevation each pressure once, and none between two that are equal to it.
fn from_base(points: Vec<EarthPoint>) -> Vec<EarthPoint> {
    let mut kept: Vec<EarthPoint> = Vec::new();
    for point in points.into_iter().rev() {
        let same = |other: &EarthPoint| (other.normal, other.tangential) == (point.normal, point.tangential);
        if kept.last() == Some(&point) {
            continue;
        }
        if let [.., before, last] = &kept[..]
            && same(before)
            && same(last)
        {
            kept.pop();
        }
        kept.push(point);
    }
    kept
}

/// The part of the push of free pore water, which acts `elevation` above the base, that is above a level: its share, and where it acts above
/// the level, m. `None` where the water does not reach so high.
///
/// ```text
/// p = 7/8 k γ_w √(h z), z below the water         above y: (1 − y/h)^1.5 of it, 0.4 (h − y) above y
/// ```
pub(super) fn pore_water_above(elevation: f64, level: f64) -> Option<[f64; 2]> {
    let height = elevation / PORE_WATER_AT;
    let above = height - level;
    (above > 0.0).then(|| [(above / height).powf(1.5), PORE_WATER_AT * above])
}

/// How high the push of free pore water acts, as a share of its height.
const PORE_WATER_AT: f64 = 0.4;

/// ∫p dy and ∫p y dy of a part of a pressure over the height, N and N·m per metre run.
pub fn sums(points: &[EarthPoint], part: fn(&EarthPoint) -> f64) -> [f64; 2] {
    points.windows(2).fold([0.0; 2], |[sum, moment], pair| {
        let [y1, y2] = [pair[0].elevation, pair[1].elevation];
        let [p1, p2] = [part(&pair[0]), part(&pair[1])];
        let of_strip = (y2 - y1) / 6.0 * (p1 * (2.0 * y1 + y2) + p2 * (y1 + 2.0 * y2));
        [sum + (p1 + p2) / 2.0 * (y2 - y1), moment + of_strip]
    })
}
