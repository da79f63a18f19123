//! Factors between what formulas give and what acts: a bias of Goda's thrust, of his uplift, of forces.
//!
//! A force times its bias acts where the force acts. A moment with a bias of its own is that about the heel O, where engineers have M_p
//! and M_U; the force then acts elsewhere.

use std::sync::Arc;

use standfast::loads::{Action, Load, LoadSource};
use standfast::wave::{Choices, Heights, goda};
use standfast::{Body, Scalar, Wrench};

use super::Case;
use super::reader::Reader;
use super::waves::{GODA, GodaWaves, WaveFormula, Waves};
use crate::error::{Fault, Problem};
use crate::inputs::Inputs;
use crate::key::{Id, Key, Table};

/// A factor between what formulas give and what acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bias {
    /// On the horizontal wave force, and on its moment unless that has one of its own.
    Thrust,
    /// On the uplift of the wave, and on its moment unless that has one of its own.
    Uplift,
    /// On the moment of the horizontal wave force about the heel.
    ThrustMoment,
    /// On the moment of the uplift about the heel.
    UpliftMoment,
    /// On every force of `[[load]]`.
    Force,
    /// On the wave height in deep water.
    DeepWaterHeight,
    /// On the wave heights at the wall, as they are found from that in deep water, or given.
    Height,
    /// On what the base bears.
    Bearing,
}

impl Bias {
    /// All of them.
    pub const ALL: [Bias; 8] = [
        Bias::Thrust,
        Bias::Uplift,
        Bias::ThrustMoment,
        Bias::UpliftMoment,
        Bias::Force,
        Bias::DeepWaterHeight,
        Bias::Height,
        Bias::Bearing,
    ];

    /// Its name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Bias::Thrust => "bias.P",
            Bias::Uplift => "bias.U",
            Bias::ThrustMoment => "bias.M_p",
            Bias::UpliftMoment => "bias.M_U",
            Bias::Force => "bias.force",
            Bias::DeepWaterHeight => "bias.H0",
            Bias::Height => "bias.H",
            Bias::Bearing => "bias.R",
        }
    }

    /// The same in words.
    pub fn words(self) -> &'static str {
        match self {
            Bias::Thrust => "factor on the thrust of the wave",
            Bias::Uplift => "factor on the uplift",
            Bias::ThrustMoment => "factor on the moment of the thrust",
            Bias::UpliftMoment => "factor on the moment of the uplift",
            Bias::Force => "factor on the forces",
            Bias::DeepWaterHeight => "factor on the wave height in deep water",
            Bias::Height => "factor on the wave heights at the wall",
            Bias::Bearing => "factor on what the base bears",
        }
    }

    /// The bias of a name.
    pub fn find(name: &str) -> Option<Bias> {
        Bias::ALL.into_iter().find(|bias| bias.name() == name)
    }

    /// The table of a case without which it is on nothing.
    pub fn table(self) -> Table {
        match self {
            Bias::Force => Table::Load,
            Bias::Bearing => Table::Ground,
            _ => Table::Wave,
        }
    }

    /// What a case of these inputs lacks for it to be on; `None` if nothing.
    pub fn lacks(self, inputs: &Inputs) -> Option<&'static str> {
        let is_goda = inputs.choice(Key::WaveFormula).is_none_or(|formula| formula == GODA);
        let bears = [Key::Strength, Key::GroundLaw, Key::GroundAngle, Key::UndrainedStrength]
            .into_iter()
            .any(|key| inputs.get(key).is_some());
        match self {
            Bias::Force => (!inputs.has(Table::Load)).then_some("no [[load]]"),
            Bias::Bearing => (!bears).then_some("no [ground] with a strength or a law"),
            _ if !inputs.has(Table::Wave) => Some("no waves"),
            Bias::Height | Bias::DeepWaterHeight if !is_goda => Some("no waves by Goda’s formulas"),
            Bias::DeepWaterHeight if inputs.get(Key::DeepWaterHeight).is_none() => {
                Some("no wave height in deep water, but those at the wall, on which `bias.H` is")
            }
            _ => None,
        }
    }

    /// True if it changes the case itself, and not a load where it is found.
    pub fn is_of_case(self) -> bool {
        matches!(self, Bias::DeepWaterHeight | Bias::Height | Bias::Bearing)
    }

    /// The biases of what is from a source: of its force, and of its moment about the heel.
    fn of(source: LoadSource) -> Option<(Bias, Option<Bias>)> {
        match source {
            LoadSource::WavePressure => Some((Bias::Thrust, Some(Bias::ThrustMoment))),
            LoadSource::WaveUplift => Some((Bias::Uplift, Some(Bias::UpliftMoment))),
            LoadSource::Force => Some((Bias::Force, None)),
            _ => None,
        }
    }
}

/// The biases of a case; none where nothing is said.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Biases([Option<f64>; Bias::ALL.len()]);

impl Biases {
    /// Sets the factor that a bias is.
    pub fn set(&mut self, bias: Bias, factor: f64) {
        self.0[bias as usize] = Some(factor);
    }

    /// The factor that a bias is, if it is set.
    pub fn get(&self, bias: Bias) -> Option<f64> {
        self.0[bias as usize]
    }

    /// The choices in Goda's formulas with the factors on heights, in deep water and at the wall.
    pub fn on_heights(&self, choices: Choices) -> Choices {
        let factors = [Bias::DeepWaterHeight, Bias::Height].map(|bias| self.get(bias).unwrap_or(1.0));
        Choices { height_factors: factors, ..choices }
    }

    /// A load on a body times its biases.
    pub(super) fn on<T: Scalar>(&self, load: Load<T>, body: &Body<T>, gravity: T) -> Load<T> {
        let Some((force, moment)) = Bias::of(load.source) else { return load };
        let of = |bias| self.get(bias).map(T::written);
        match (of(force), moment.and_then(of)) {
            (None, None) => load,
            (Some(factor), None) => load.times(factor),
            (factor, Some(of_moment)) => {
                let wrench = load.action.upright(body, gravity);
                let centre = [body.heel_distance(), body.centroid_height()];
                let of_force = factor.unwrap_or_else(|| T::of(1.0));
                Load { action: Action::Resultant(biased(wrench, centre, of_force, of_moment)), ..load }
            }
        }
    }
}

impl<T: Scalar> Case<T> {
    /// The case under these biases: wave heights and what the base bears times theirs at once, loads where each is found.
    ///
    /// # Errors
    /// If the waves cannot have such heights, or a combination sets heights at the wall where that in deep water has a bias.
    pub fn biased(self, biases: Biases) -> Result<Case<T>, Fault> {
        let mut case = Case { biases, ..self };
        if Bias::ALL.into_iter().all(|bias| !bias.is_of_case() || biases.get(bias).is_none()) {
            return Ok(case);
        }
        case.changed = std::mem::take(&mut case.changed)
            .into_iter()
            .enumerate()
            .map(|(index, changed)| {
                let Some(changed) = changed else { return Ok(None) };
                let is_deep = |wave: &Option<Waves>| {
                    let goda = wave.as_ref().and_then(Waves::goda);
                    goda.is_some_and(|waves| matches!(waves.heights, Heights::DeepWater(_)))
                };
                if biases.get(Bias::DeepWaterHeight).is_some()
                    && is_deep(&case.wave)
                    && !is_deep(&changed.wave)
                {
                    let name = Id::from(Key::DeepWaterHeight).to_string();
                    return Err(Fault::new(
                        Problem::SetAndRandom { name },
                        Id::new(Key::CombinationName, index),
                    ));
                }
                Ok(Some(Arc::new(Case::clone(&changed).with_own_biases(&biases)?)))
            })
            .collect::<Result<_, Fault>>()?;
        case.with_own_biases(&biases)
    }

    /// The case with wave heights and what the base bears times their biases.
    fn with_own_biases(mut self, biases: &Biases) -> Result<Case<T>, Fault> {
        if let Some(factor) = biases.get(Bias::Bearing) {
            self.ground = self.ground.map(|ground| ground.divided(factor.recip()));
        }
        let Some(waves) = self.wave.as_ref().and_then(Waves::goda) else { return Ok(self) };
        let choices = biases.on_heights(waves.choices);
        if choices == waves.choices {
            return Ok(self);
        }
        let sea = waves.sea_of(&waves.heights, &choices);
        let goda = goda(&sea, &waves.heights, &waves.section, &choices)
            .map_err(|error| Reader { inputs: &self.inputs }.blame(Table::Wave, error))?;
        let waves = GodaWaves { sea, choices, goda, ..waves.clone() };
        self.wave = self.wave.map(|wave| Waves { formula: WaveFormula::Goda(waves), ..wave });
        Ok(self)
    }
}

/// A wrench at a centre of mass that lies at `[b₁, d]` from the heel O, its force and its moment about O each times a factor.
pub fn biased<T: Scalar>(wrench: Wrench<T>, [b1, d]: [T; 2], of_force: T, of_moment: T) -> Wrench<T> {
    let lever = |x: T, p: T| -(b1.clone() * p) - d.clone() * x;
    let about_heel = (wrench.m + lever(wrench.x.clone(), wrench.p.clone())) * of_moment;
    let (x, p) = (wrench.x * of_force.clone(), wrench.p * of_force);
    Wrench { x: x.clone(), p: p.clone(), m: about_heel - lever(x, p) }
}
