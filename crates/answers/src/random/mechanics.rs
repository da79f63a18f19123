//! The contact problem that drawn values make, with what each bias is on kept apart.

use standfast::contact::Block;
use standfast::ground::Base;
use standfast::loads::LoadSource;
use standfast::wave::{Goda, Heights, goda};
use standfast::{Departure, InputError, Situation, Wrench};

use super::base;
use super::outcome::LIFTED;
use super::quantity::Bias;
use super::stack::{self, Asked};
use crate::case::{Acting, Biases, Case, Foundation, GodaWaves, Trial, biased};

/// The contact problem that values make.
#[derive(Debug, Clone)]
pub(super) struct Mechanics {
    pub(super) block: Block,
    /// Base that it stands on.
    pub(super) base: Base,
    /// Of the permanent loads.
    pub(super) permanent: Wrench,
    /// Of the variable loads, which rise on the way to a first departure.
    pub(super) variable: Wrench,
    /// Set of the waves' formulas that applied.
    pub(super) formulas: u32,
    /// All that is above each joint, as one body, from the lowest joint up; none of one body.
    pub(super) above: Vec<Mechanics>,
}

impl Mechanics {
    /// Of all loads.
    pub(super) fn wrench(&self) -> Wrench {
        self.permanent + self.variable
    }

    /// Outcomes under all loads, a bit for each.
    pub(super) fn outcomes(&self) -> u64 {
        if !self.above.is_empty() {
            return stack::outcomes(self, Asked::Full);
        }
        let wrench = self.wrench();
        u64::from(wrench.p <= 0.0) << LIFTED | base::outcomes(&self.base, &self.block, &wrench)
    }

    /// Departure from rest as the variable loads rise; none where the numbers do not go together.
    pub(super) fn departure(&self) -> Option<Departure> {
        self.base.departure(&self.block, &self.permanent, &self.variable).ok()
    }
}

/// Loads on a block, in its units: those that each bias is on, and all else.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Components {
    pub(super) block: Block,
    /// Base that it stands on.
    pub(super) base: Base,
    /// Set of the waves' formulas that applied.
    pub(super) formulas: u32,
    pub(super) thrust: Wrench,
    pub(super) uplift: Wrench,
    /// Permanent and variable.
    pub(super) forces: [Wrench; 2],
    pub(super) others: [Wrench; 2],
    /// On all that is above each joint, as one body, from the lowest joint up; none of one body.
    pub(super) above: Vec<Components>,
}

impl Components {
    pub(super) fn of(
        situation: &Situation,
        foundation: Option<&Foundation>,
        formulas: u32,
    ) -> Result<Components, InputError> {
        let nothing = Wrench::ZERO;
        let mut all = Components {
            block: situation.reduced_block().0,
            base: base::under(situation, foundation)?,
            formulas,
            thrust: nothing,
            uplift: nothing,
            forces: [nothing; 2],
            others: [nothing; 2],
            above: Vec::new(),
        };
        for load in situation.loads() {
            let which = usize::from(!load.permanent);
            let part = match load.source {
                LoadSource::WavePressure => &mut all.thrust,
                LoadSource::WaveUplift => &mut all.uplift,
                LoadSource::Force => &mut all.forces[which],
                _ => &mut all.others[which],
            };
            *part = *part + situation.reduced_wrench(&situation.wrench_of(load));
        }
        Ok(all)
    }

    /// Thrust and uplift of a wave on a block, in units of m g and half the width (N, m).
    pub(super) fn of_wave(goda: &Goda, block: &Block, (weight, half_width): (f64, f64)) -> [Wrench; 2] {
        let [force, uplift] = [goda.force, goda.uplift].map(|force| force / weight);
        let [of_force, of_uplift] =
            [goda.force_moment, goda.uplift_moment].map(|moment| moment / (weight * half_width));
        // To the left at its elevation above the base, and upwards at its distance from O.
        let thrust = Wrench { x: -force, p: 0.0, m: of_force - force * block.d };
        [thrust, Wrench { x: 0.0, p: -uplift, m: of_uplift - uplift * block.b1 }]
    }

    /// The contact problem of these loads, each times what it is biased by.
    pub(super) fn mechanics(&self, bias: &dyn Fn(Bias) -> Option<f64>) -> Mechanics {
        let Components { block, base, formulas, .. } = *self;
        let [permanent, variable] = self.wrenches(bias);
        let above = self.above.iter().map(|above| above.mechanics(bias)).collect();
        Mechanics { block, base, permanent, variable, formulas, above }
    }

    /// The sums of the permanent and of the variable loads, each times what it is biased by.
    pub(super) fn wrenches(&self, bias: impl Fn(Bias) -> Option<f64>) -> [Wrench; 2] {
        let of_forces = bias(Bias::Force).unwrap_or(1.0);
        let Block { b1, d, .. } = self.block;
        let [permanent, variable] = [0, 1]
            .map(|which| self.others[which] + biased(self.forces[which], [b1, d], of_forces, of_forces));
        [permanent, variable + Components::waves(&self.block, [self.thrust, self.uplift], bias)]
    }

    /// Thrust and uplift of a wave, each times what it is biased by.
    pub(super) fn waves(
        block: &Block,
        [thrust, uplift]: [Wrench; 2],
        bias: impl Fn(Bias) -> Option<f64>,
    ) -> Wrench {
        let times = |wrench: Wrench, force: Bias, moment: Bias| {
            let of_force = bias(force).unwrap_or(1.0);
            biased(wrench, [block.b1, block.d], of_force, bias(moment).unwrap_or(of_force))
        };
        times(thrust, Bias::Thrust, Bias::ThrustMoment) + times(uplift, Bias::Uplift, Bias::UpliftMoment)
    }
}

/// A case of which wave heights alone are random: everything else is worked out once.
#[derive(Debug, Clone)]
pub(super) struct Quick {
    waves: GodaWaves,
    components: Components,
    /// m g, N, and half the width, m.
    scale: (f64, f64),
}

impl Quick {
    /// None where the case has no waves by Goda's formulas, or multiplies them.
    pub(super) fn of(case: &Case, acting: Acting, trial: Trial) -> Option<Quick> {
        let waves = case.goda().cloned().filter(|_| !matches!(acting, Acting::Combination(_)))?;
        let situation = case.situation(acting, trial).ok()?;
        let components = Components::of(&situation, case.ground.as_ref(), waves.goda.formulas).ok()?;
        let scale = (case.body.mass() * case.gravity, case.body.width() / 2.0);
        Some(Quick { waves, components, scale })
    }

    /// The waves with these heights, times their biases.
    fn waves(&self, heights: Heights, biases: &Biases) -> Option<GodaWaves> {
        let GodaWaves { steepness, section, choices, goda: as_given, .. } = &self.waves;
        let (section, choices) = (*section, biases.on_heights(*choices));
        let sea = self.waves.sea_of(&heights, &choices);
        let goda = match heights {
            Heights::DeepWater(height) if steepness.is_none() => {
                as_given.from_deep_water(&sea, &section, &choices, height)?
            }
            heights => goda(&sea, &heights, &section, &choices).ok()?,
        };
        GodaWaves { sea, steepness: *steepness, heights, section, choices, goda }.broken()
    }

    pub(super) fn components(&self, heights: Heights, biases: &Biases) -> Option<Components> {
        let goda = self.waves(heights, biases)?.goda;
        let [thrust, uplift] = Components::of_wave(&goda, &self.components.block, self.scale);
        Some(Components { thrust, uplift, formulas: goda.formulas, ..self.components.clone() })
    }

    /// The case, of which this is, with these heights.
    pub(super) fn case(&self, case: &Case, heights: Heights, biases: &Biases) -> Option<Case> {
        Some(case.with_goda(self.waves(heights, biases)?))
    }
}
