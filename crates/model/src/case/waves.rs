//! Waves from the right, and what they amount to by the formula that the case names.

use standfast::loads::Load;
use standfast::wave::{
    Armour, CaissonSection, Choices, CrownSea, CrownWave, Goda, Heights, PedersenWall, STEEPEST, Sainflou,
    Sea, StandingWall, VanGentWall, WavePhase, WaveWarning, goda, pedersen, period_of_steepness, sainflou,
    van_gent,
};
use standfast::{Body, History};

use super::Case;
use super::history::HistoryOf;
use super::motion::CaseMotion;
use super::reader::{Reader, SAME_LENGTH};
use crate::error::{Fault, Problem};
use crate::inputs::{Inputs, Value};
use crate::key::{Key, Table};

/// Waves from the right.
#[derive(Debug, Clone, PartialEq)]
pub struct Waves {
    /// Density of the sea, kg/m³.
    pub water_density: f64,
    /// Key that gives it: that of the waves, or that of still water.
    pub density_key: Key,
    /// The formula, and what it gives.
    pub formula: WaveFormula,
    /// Variation of thrust and uplift in time.
    pub history: Option<History>,
}

/// What waves amount to by a formula.
#[expect(
    clippy::large_enum_variant,
    reason = "a case has one, and the largest is the one that tables vary by the million"
)]
#[derive(Debug, Clone, PartialEq)]
pub enum WaveFormula {
    /// Goda's.
    Goda(GodaWaves),
    /// Sainflou's.
    Sainflou(StandingWaves),
    /// One for crown walls.
    Crown(CrownWaves),
}

/// Waves by Goda's formulas.
#[derive(Debug, Clone, PartialEq)]
pub struct GodaWaves {
    /// The sea.
    pub sea: Sea,
    /// H₀'/L₀, where the period goes with the height in deep water.
    pub steepness: Option<f64>,
    /// The wave heights as they are given.
    pub heights: Heights,
    /// The caisson and its berm.
    pub section: CaissonSection,
    /// The choices in the formulas.
    pub choices: Choices,
    /// The pressures, forces and moments.
    pub goda: Goda,
}

impl GodaWaves {
    /// H₀' over the steepest that waves of its period can have, times the factor on it; `None` where the heights are those at the wall.
    pub fn share_of_steepest(&self) -> Option<f64> {
        let Heights::DeepWater(height) = self.heights else { return None };
        let [in_deep_water, _] = self.choices.height_factors;
        Some(height * in_deep_water / (STEEPEST * self.goda.deep_water_wavelength))
    }

    /// The sea of waves of these heights: with the period that goes with the one in deep water, times its factor, where the steepness is given.
    pub fn sea_of(&self, heights: &Heights, choices: &Choices) -> Sea {
        let [in_deep_water, _] = choices.height_factors;
        match (heights, self.steepness) {
            (Heights::DeepWater(height), Some(steepness)) => {
                let period = period_of_steepness(height * in_deep_water, steepness, self.sea.gravity);
                Sea { period, ..self.sea }
            }
            _ => self.sea,
        }
    }

    /// The waves with a height in deep water that is no steeper than waves can be; `None` if they cannot be found.
    pub fn broken(self) -> Option<GodaWaves> {
        let Some(share) = self.share_of_steepest().filter(|share| *share > 1.0) else { return Some(self) };
        let Heights::DeepWater(height) = self.heights else { return Some(self) };
        let height = height / share;
        let mut goda = self.goda.from_deep_water(&self.sea, &self.section, &self.choices, height)?;
        goda.formulas |= BROKEN;
        Some(GodaWaves { heights: Heights::DeepWater(height), goda, ..self })
    }
}

/// Mark in the set of formulas that applied: the height in deep water was cut.
const BROKEN: u32 = 1 << 31;

/// Waves by Sainflou's formula.
#[derive(Debug, Clone, PartialEq)]
pub struct StandingWaves {
    /// The sea.
    pub sea: Sea,
    /// Key that gives the height: `height`, or the one that it names.
    pub height_key: Key,
    /// The wall.
    pub wall: StandingWall,
    /// The pressures, forces and moments.
    pub wave: Sainflou,
}

/// Waves on a crown wall.
#[derive(Debug, Clone, PartialEq)]
pub struct CrownWaves {
    /// The sea.
    pub sea: CrownSea,
    /// The armour.
    pub armour: Armour,
    /// The wall, as its formula takes it.
    pub wall: CrownWall,
    /// The forces.
    pub wave: CrownWave,
}

/// A crown wall as a formula takes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CrownWall {
    /// Pedersen's.
    Pedersen(PedersenWall),
    /// Van Gent's.
    VanGent(VanGentWall),
}

impl Waves {
    /// Waves by Goda's formulas; `None` of those by another.
    pub fn goda(&self) -> Option<&GodaWaves> {
        match &self.formula {
            WaveFormula::Goda(waves) => Some(waves),
            _ => None,
        }
    }

    /// The sea's level above the base, m; `None` of one below it, before a crown wall.
    pub fn still_water(&self) -> Option<f64> {
        match &self.formula {
            WaveFormula::Goda(waves) => Some(waves.section.base_depth),
            WaveFormula::Sainflou(waves) => Some(waves.wall.base_depth),
            WaveFormula::Crown(_) => None,
        }
    }

    /// The level above the base to which their water reaches at the wall, m, where the formula says so.
    pub fn surface(&self) -> Option<f64> {
        match &self.formula {
            WaveFormula::Goda(waves) => Some(waves.section.base_depth + waves.goda.eta_star),
            WaveFormula::Sainflou(waves) => Some(waves.wall.base_depth + waves.wave.surface),
            WaveFormula::Crown(_) => None,
        }
    }

    /// Uplift pressure under the seaward edge, Pa.
    pub fn uplift(&self) -> f64 {
        match &self.formula {
            WaveFormula::Goda(waves) => waves.goda.pu,
            WaveFormula::Sainflou(waves) => waves.wave.pu,
            WaveFormula::Crown(waves) => waves.wave.pu,
        }
    }

    /// Which of the formula's branches apply, as a number: loads have a kink where it changes.
    pub fn branches(&self) -> u32 {
        match &self.formula {
            WaveFormula::Goda(waves) => waves.goda.formulas,
            WaveFormula::Sainflou(waves) => waves.wave.formulas,
            WaveFormula::Crown(waves) => waves.wave.formulas,
        }
    }

    /// Conditions outside the range of the formula.
    pub fn warnings(&self) -> Vec<WaveWarning> {
        match &self.formula {
            WaveFormula::Goda(waves) => waves.goda.warnings.clone(),
            WaveFormula::Sainflou(waves) => waves.wave.warnings.clone(),
            WaveFormula::Crown(waves) => waves.wave.warnings().collect(),
        }
    }

    /// The loads on `body`: thrust, and uplift where there is one.
    pub fn loads(&self, body: &Body) -> Vec<Load> {
        match &self.formula {
            WaveFormula::Goda(waves) => waves.goda.loads(body, waves.section.base_depth),
            WaveFormula::Sainflou(waves) => waves.wave.loads(body, waves.wall.base_depth),
            WaveFormula::Crown(waves) => waves.wave.loads(body),
        }
    }
}

impl CrownWall {
    /// Its height, m.
    pub fn height(&self) -> f64 {
        match self {
            CrownWall::Pedersen(wall) => wall.protected + wall.free,
            CrownWall::VanGent(wall) => wall.height,
        }
    }
}

impl Case {
    /// H_1/3 and H_max at the wall, m, where the waves have both.
    pub(super) fn heights_at_wall(&self) -> Option<[f64; 2]> {
        match &self.wave.as_ref()?.formula {
            WaveFormula::Goda(waves) => Some([waves.goda.h_13, waves.goda.h_max]),
            WaveFormula::Sainflou(waves) => {
                let given = Reader { inputs: &self.inputs }.heights().ok()?;
                Some(given.at_wall(&waves.sea))
            }
            WaveFormula::Crown(_) => None,
        }
    }
}

/// The word for the formula that a case takes where it names none.
pub(super) const GODA: &str = "goda";

/// The keys of waves that a formula takes.
fn takes(formula: &str, key: Key) -> bool {
    const SEA: [Key; 6] =
        [Key::WaveFormula, Key::WaterDepth, Key::Period, Key::AngleDeg, Key::WaveWaterDensity, Key::H13];
    const CAISSON: [Key; 8] = [
        Key::SeaBottomSlope,
        Key::DeepWaterHeight,
        Key::Hmax,
        Key::CaissonWidth,
        Key::BaseDepth,
        Key::StillWaterLevel,
        Key::CrestHeight,
        Key::WaveUplift,
    ];
    const OF_GODA: [Key; 8] = [
        Key::Steepness,
        Key::DepthAboveBerm,
        Key::BermWidth,
        Key::Lambda1,
        Key::Lambda2,
        Key::Lambda3,
        Key::Impulsive,
        Key::TurnDeg,
    ];
    const STANDING: [Key; 2] = [Key::WaveHeight, Key::WavePhase];
    const ARMOUR: [Key; 2] = [Key::ArmourSlope, Key::ArmourCrest];
    const PEDERSEN: [Key; 4] = [Key::ArmourWidth, Key::ProtectedHeight, Key::FreeHeight, Key::VolumeShare];
    const VAN_GENT: [Key; 4] = [Key::WallHeight, Key::WallBase, Key::BaseFreeboard, Key::Roughness];
    let own: [&[Key]; 2] = match formula {
        GODA => [&CAISSON, &OF_GODA],
        "sainflou" => [&CAISSON, &STANDING],
        "pedersen" => [&ARMOUR, &PEDERSEN],
        _ => [&ARMOUR, &VAN_GENT],
    };
    SEA.contains(&key) || own.iter().any(|keys| keys.contains(&key))
}

/// True unless a key is one of waves by another formula than that of a case.
pub fn goes_with_waves(inputs: &Inputs, key: Key) -> bool {
    let formula = inputs.choice(Key::WaveFormula).unwrap_or(GODA);
    key.info().table != Table::Wave || takes(formula, key)
}

/// The keys of waves that a formula does not take.
pub(super) fn keys_of_others(formula: &str) -> impl Iterator<Item = Key> {
    Table::Wave.keys().filter(move |key| !takes(formula, *key))
}

impl Reader<'_> {
    /// The key that says how high the sea stands above the base.
    pub(super) fn still_water_key(&self) -> Key {
        match self.number(Key::StillWaterLevel) {
            Some(_) => Key::StillWaterLevel,
            None => Key::BaseDepth,
        }
    }

    /// The sea's level above the base, m.
    pub(super) fn still_water(&self) -> Option<f64> {
        self.number(self.still_water_key())
    }

    fn base_depth(&self) -> Result<f64, Fault> {
        if self.number(Key::BaseDepth).is_some() && self.number(Key::StillWaterLevel).is_some() {
            let problem =
                Problem::BothIn { table: Table::Wave, one: Key::StillWaterLevel, two: Key::BaseDepth };
            return Err(Fault::new(problem, Key::StillWaterLevel).and(Key::BaseDepth));
        }
        self.required(self.still_water_key())
    }

    /// The word for the formula of the waves.
    fn wave_formula(&self) -> &'static str {
        self.inputs.choice(Key::WaveFormula).unwrap_or(GODA)
    }

    /// True if the waves come over a sea that stands beside the body.
    pub(super) fn sea_stands_beside(&self) -> bool {
        matches!(self.wave_formula(), GODA | "sainflou")
    }

    pub(super) fn waves(
        &self,
        body: &Body,
        gravity: f64,
        motion: Option<&mut CaseMotion>,
    ) -> Result<Waves, Fault> {
        let formula = self.wave_formula();
        if let Some(key) = keys_of_others(formula).find(|key| self.inputs.get(*key).is_some()) {
            let takes = Table::Wave.keys().filter(|key| takes(formula, *key)).map(Key::entry).collect();
            return Err(Fault::new(Problem::NotOfFormula { key, formula, takes }, key));
        }
        let density_key = self.sea_density_key();
        let water_density = self.required(density_key)?;
        let formula = match formula {
            GODA => WaveFormula::Goda(self.goda_waves(body, water_density, gravity)?),
            "sainflou" => WaveFormula::Sainflou(self.standing_waves(body, water_density, gravity)?),
            word => WaveFormula::Crown(self.crown_waves(word, body, water_density, gravity)?),
        };
        let mut waves = Waves { water_density, density_key, formula, history: None };
        let history = self.history(Table::WaveHistory, 0, HistoryOf::Waves(&waves))?;
        waves.history = self.taken(history, motion, Table::WaveHistory, 0)?;
        Ok(waves)
    }

    fn goda_waves(&self, body: &Body, water_density: f64, gravity: f64) -> Result<GodaWaves, Fault> {
        let sea = Sea {
            water_depth: self.required(Key::WaterDepth)?,
            sea_bottom_slope: self.required(Key::SeaBottomSlope)?,
            period: self.wave_period(gravity)?,
            angle_deg: self.required(Key::AngleDeg)?,
            water_density,
            gravity,
        };
        let heights = self.heights()?;
        let caisson_width = self.caisson_width(body)?;
        let section = CaissonSection {
            base_depth: self.base_depth()?,
            depth_above_berm: self.required(Key::DepthAboveBerm)?,
            crest_height: self.required(Key::CrestHeight)?,
            berm_width: self.required(Key::BermWidth)?,
            caisson_width,
        };
        let default = Choices::default();
        let factor = |key, default| self.number(key).unwrap_or(default);
        let choices = Choices {
            lambda: [
                factor(Key::Lambda1, default.lambda[0]),
                factor(Key::Lambda2, default.lambda[1]),
                factor(Key::Lambda3, default.lambda[2]),
            ],
            impulsive: self.inputs.truth(Key::Impulsive).unwrap_or(default.impulsive),
            turn_deg: factor(Key::TurnDeg, default.turn_deg),
            uplift: self.inputs.truth(Key::WaveUplift).unwrap_or(default.uplift),
            ..default
        };
        let goda =
            goda(&sea, &heights, &section, &choices).map_err(|error| self.blame(Table::Wave, error))?;
        self.crest_agrees(body, section.base_depth, section.crest_height)?;
        let steepness = self.number(Key::Steepness);
        Ok(GodaWaves { sea, steepness, heights, section, choices, goda })
    }

    fn standing_waves(&self, body: &Body, water_density: f64, gravity: f64) -> Result<StandingWaves, Fault> {
        let named = match self.inputs.get(Key::WaveHeight) {
            None => return Err(self.missing(Key::WaveHeight, 0)),
            Some(Value::Choice("H13")) => Some(Key::H13),
            Some(Value::Choice(_)) => Some(Key::Hmax),
            Some(_) => None,
        };
        let heights = [Key::DeepWaterHeight, Key::H13, Key::Hmax];
        let given = heights.into_iter().find(|key| self.number(*key).is_some());
        if let (None, Some(given)) = (named, given) {
            let problem = Problem::BothIn { table: Table::Wave, one: Key::WaveHeight, two: given };
            return Err(Fault::new(problem, Key::WaveHeight).and(given));
        }
        let deep = self.number(Key::DeepWaterHeight).is_some();
        let sea = Sea {
            water_depth: self.required(Key::WaterDepth)?,
            // Heights in deep water come over the bed; else it tells whether they break, where it is given.
            sea_bottom_slope: match deep {
                true => self.required(Key::SeaBottomSlope)?,
                false => self.number(Key::SeaBottomSlope).unwrap_or(0.0),
            },
            period: self.required(Key::Period)?,
            angle_deg: self.number(Key::AngleDeg).unwrap_or(0.0),
            water_density,
            gravity,
        };
        let height = match named {
            None => self.required(Key::WaveHeight)?,
            // One of both is enough where it is the one that is asked for.
            Some(key) if !deep => self.required(key)?,
            Some(key) => {
                let [significant, maximum] = self.heights()?.at_wall(&sea);
                if key == Key::H13 { significant } else { maximum }
            }
        };
        let height_key = named.unwrap_or(Key::WaveHeight);
        let phase = match self.inputs.choice(Key::WavePhase) {
            Some("trough") => WavePhase::Trough,
            Some(_) => WavePhase::Crest,
            None => return Err(self.missing(Key::WavePhase, 0)),
        };
        let wall = StandingWall {
            width: self.caisson_width(body)?,
            base_depth: self.base_depth()?,
            crest_height: self.required(Key::CrestHeight)?,
            uplift: self.inputs.truth(Key::WaveUplift).unwrap_or(true),
        };
        let wave = sainflou(&sea, height, phase, &wall).map_err(|error| self.blame(Table::Wave, error))?;
        self.crest_agrees(body, wall.base_depth, wall.crest_height)?;
        Ok(StandingWaves { sea, height_key, wall, wave })
    }

    fn crown_waves(
        &self,
        formula: &str,
        body: &Body,
        water_density: f64,
        gravity: f64,
    ) -> Result<CrownWaves, Fault> {
        let sea = CrownSea {
            significant: self.required(Key::H13)?,
            period: self.required(Key::Period)?,
            angle_deg: self.number(Key::AngleDeg).unwrap_or(0.0),
            water_density,
            gravity,
            water_depth: self.number(Key::WaterDepth),
        };
        let armour =
            Armour { slope: self.required(Key::ArmourSlope)?, crest: self.required(Key::ArmourCrest)? };
        let base = body.base_width();
        let (wall, wave) = match formula {
            "pedersen" => {
                let wall = PedersenWall {
                    armour_width: self.required(Key::ArmourWidth)?,
                    protected: self.required(Key::ProtectedHeight)?,
                    free: self.required(Key::FreeHeight)?,
                    volume_share: self.number(Key::VolumeShare).unwrap_or(1.0),
                    base,
                };
                (CrownWall::Pedersen(wall), pedersen(&sea, &armour, &wall))
            }
            _ => {
                let own = self.number(Key::WallBase);
                if let Some(width) = own.filter(|width| *width > base + SAME_LENGTH) {
                    let problem = Problem::WallBeyondBase { width, base };
                    return Err(Fault::new(problem, Key::WallBase).and(self.base_key()));
                }
                let wall = VanGentWall {
                    height: self.number(Key::WallHeight).unwrap_or_else(|| body.height()),
                    base: own.unwrap_or(base),
                    freeboard: self.required(Key::BaseFreeboard)?,
                    roughness: self.number(Key::Roughness).unwrap_or(1.0),
                };
                (CrownWall::VanGent(wall), van_gent(&sea, &armour, &wall))
            }
        };
        let wave = wave.map_err(|error| self.blame(Table::Wave, error))?;
        Ok(CrownWaves { sea, armour, wall, wave })
    }

    /// The period, or the one of waves of the steepness given in deep water.
    fn wave_period(&self, gravity: f64) -> Result<f64, Fault> {
        match (self.number(Key::Steepness), self.number(Key::Period), self.number(Key::DeepWaterHeight)) {
            (None, ..) => self.required(Key::Period),
            (Some(_), Some(_), _) => {
                let problem = Problem::BothIn { table: Table::Wave, one: Key::Steepness, two: Key::Period };
                Err(Fault::new(problem, Key::Steepness).and(Key::Period))
            }
            (Some(_), None, None) => Err(Fault::new(Problem::SteepnessOfNothing, Key::Steepness)),
            (Some(steepness), None, Some(height)) => Ok(period_of_steepness(height, steepness, gravity)),
        }
    }

    /// The width of the caisson's base, which may be given beside that of the body.
    fn caisson_width(&self, body: &Body) -> Result<f64, Fault> {
        let base = body.base_width();
        match self.number(Key::CaissonWidth).filter(|width| (width - base).abs() > SAME_LENGTH) {
            None => Ok(base),
            Some(width) => {
                let problem = Problem::CaissonWidth { width, base };
                Err(Fault::new(problem, Key::CaissonWidth).and(self.base_key()))
            }
        }
    }

    /// Depth of the base and height of the crest make the height of the body.
    fn crest_agrees(&self, body: &Body, base_depth: f64, crest_height: f64) -> Result<(), Fault> {
        match (base_depth + crest_height - body.height()).abs() > SAME_LENGTH {
            false => Ok(()),
            true => {
                let key = self.still_water_key();
                let problem = Problem::Height { key, base_depth, crest_height, height: body.height() };
                Err(Fault::new(problem, Key::CrestHeight).and(Key::Height))
            }
        }
    }

    pub(super) fn heights(&self) -> Result<Heights, Fault> {
        let one = |missing, at: Key| Err(Fault::new(Problem::OneWaveHeight { missing }, at));
        match (self.number(Key::DeepWaterHeight), self.number(Key::H13), self.number(Key::Hmax)) {
            (Some(height), None, None) => Ok(Heights::DeepWater(height)),
            (None, Some(significant), Some(maximum)) => Ok(Heights::Local { significant, maximum }),
            (Some(_), _, _) => Err(Fault::new(Problem::DeepAndLocal, Key::DeepWaterHeight)),
            (None, None, None) => Err(Fault::new(Problem::NoWaveHeight, Table::Wave)),
            (None, Some(_), None) => one(Key::Hmax, Key::H13),
            (None, None, Some(_)) => one(Key::H13, Key::Hmax),
        }
    }
}
