//! A pure problem of sliding: thrust and uplift in proportion to the wave's height, no body that could turn.
//!
//! ```toml
//! [storm]
//! waves = 1000
//! tau0 = "1.5 s"
//! significant_height = "4.5 m"
//! force_per_height = "90 kN/m2"     # kN/m of thrust for each metre of height
//! uplift_per_height = "45 kN/m2"
//! buoyant_weight = "2318.64 kN/m"
//! mass = "402.45 t/m"               # with the water that moves along
//! friction = 0.6
//!
//! [random]
//! years = 50
//! friction = { normal = { mean = 0.6, sd = 0.1 }, lower = 0.05 }
//! significant_height = { gumbel = { mean = "4.5 m", sd = "0.9 m" }, lower = "1 m", every = "year" }
//! ```
//!
//! A wave slides the body where P + μU > μW'.

use standfast::{Mode, Verdict};
use standfast_probability::life::Life;
use standfast_probability::problem::RandomVector;
use standfast_probability::sample::Estimate;
use standfast_watch::Portion;

use super::answer::{SlidingError, sliding};
use super::read::storm;
use super::{Part, Pulse, Slide, Storm, StormPart, Storms, Tau0, Year, height, level};
use crate::error::{CaseError, Fault, Place};
use crate::key::{Key, Range, Table};
use crate::random::answer::{
    ChanceRequest, Chances, FirstDeparture, Happening, LifeChances, Probability, RandomNumber,
};
use crate::random::error::ProbabilityError;
use crate::random::outcome::exclusive;
use crate::random::quantity::{Bias, Quantity, RandomInput};
use crate::random::resolve::{Names, Resolve};
use crate::random::subject::alone;
use crate::units::Dimension;
use standfast_inputs::random::{Lifetime, Random, RandomProblem, Rate, ReadResult};
use standfast_model::CaseFile;
use standfast_probability::method::Method;

/// A number of a pure problem of sliding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StormField {
    /// H_1/3 of the storm, m.
    SignificantHeight,
    /// P for each metre of a wave's height, N/m².
    ForcePerHeight,
    /// U for each metre of a wave's height, N/m².
    UpliftPerHeight,
    /// W', N per metre run.
    BuoyantWeight,
    /// m, with the water that moves along, kg per metre run.
    Mass,
    /// μ.
    Friction,
}

impl StormField {
    /// All of them.
    pub const ALL: [StormField; 6] = [
        StormField::SignificantHeight,
        StormField::ForcePerHeight,
        StormField::UpliftPerHeight,
        StormField::BuoyantWeight,
        StormField::Mass,
        StormField::Friction,
    ];

    /// The key of `[storm]` that it stands under.
    pub fn key(self) -> Key {
        match self {
            StormField::SignificantHeight => Key::StormHeight,
            StormField::ForcePerHeight => Key::ForcePerHeight,
            StormField::UpliftPerHeight => Key::UpliftPerHeight,
            StormField::BuoyantWeight => Key::StormWeight,
            StormField::Mass => Key::StormMass,
            StormField::Friction => Key::StormFriction,
        }
    }

    /// Its name in a case file.
    pub fn name(self) -> &'static str {
        self.key().name()
    }

    /// Dimension of its values; none of a plain number.
    pub fn dimension(self) -> Option<Dimension> {
        self.key().info().dimension()
    }

    /// Range of its values.
    pub(in crate::random) fn range(self) -> Range {
        self.key().info().range().unwrap_or(Range::Positive)
    }
}

/// A pure problem of sliding with random numbers.
pub(in crate::random) struct PureStorm {
    pub(in crate::random) storm: Storm,
    values: [f64; 6],
    tau0: f64,
    pub(in crate::random) random: Vec<RandomInput>,
    pub(in crate::random) laws: RandomVector,
    lifetime: Lifetime,
    /// A key of `[random]` that asks about modes.
    asks: Option<&'static str>,
}

/// The problem, if the file is of a storm without a body; none if it is of a case.
///
/// # Errors
/// If it says what such a storm does not have, or lacks a number.
pub(in crate::random) fn of_file(
    file: &CaseFile,
    years: Option<f64>,
) -> Result<Option<PureStorm>, CaseError> {
    let inputs = file.inputs();
    if !inputs.has(Table::Storm) || inputs.has(Table::Body) {
        return Ok(None);
    }
    alone(file, Table::Storm, "a file with a [storm] and no [body]")?;
    let wrong = |(problem, span): (RandomProblem, _)| file.random_error(problem, span);
    let fault = |message: String, at: Place| file.error(Fault::new(RandomProblem::Other(message).into(), at));
    let random =
        file.random().ok_or_else(|| file.error(Fault::new(RandomProblem::Nothing.into(), Table::Storm)))?;
    if inputs.truth(Key::StormCut) == Some(true) {
        let message =
            "`cut` of [storm] is true; expected false, because without a [body] no sea has an H_max";
        return Err(fault(message.to_owned(), Key::StormCut.into()));
    }
    let of_body = [Key::StormRises, Key::StormCombination].into_iter().find(|key| inputs.get(*key).is_some());
    if let Some(key) = of_body {
        let message = format!("`{}` is of the sea at a body, and the file has no [body]", key.name());
        return Err(fault(message, key.into()));
    }
    let storm = storm(inputs).map_err(|fault| file.error(fault))?;
    let Some(storm) = storm.map(|storm| Storm { is_cut: false, ..storm }) else { return Ok(None) };
    let Tau0::Given(tau0) = storm.tau0 else {
        let message = "\"shimosako-takahashi\" takes the waves of a case; expected a time".to_owned();
        return Err(fault(message, Key::StormTau0.into()));
    };
    let mut values = [1.0; 6];
    for field in StormField::ALL {
        let name = field.name();
        let is_random = random.named.iter().any(|named| named.name == name);
        values[field as usize] = match inputs.number(field.key()) {
            Some(value) => value,
            // Its law says what it is.
            None if is_random => 1.0,
            None if field == StormField::UpliftPerHeight => 0.0,
            None => {
                let message = format!("[storm] lacks `{name}`, which is not random either");
                return Err(fault(message, Table::Storm.into()));
            }
        };
    }
    PureStorm::of(storm, values, tau0, random, years).map(Some).map_err(wrong)
}

impl PureStorm {
    fn of(
        storm: Storm,
        values: [f64; 6],
        tau0: f64,
        random: &Random,
        years: Option<f64>,
    ) -> ReadResult<PureStorm> {
        let (inputs, laws) = Resolve(Names::Storm(values)).all(random)?;
        let lifetime = random.lifetime.with_years(years);
        let asked = [(random.target_beta.is_some(), "target_beta"), (random.sensitivities, "sensitivities")];
        let asks = asked.into_iter().find(|(is_asked, _)| *is_asked).map(|(_, key)| key);
        Ok(PureStorm { storm, values, tau0, random: inputs, laws, lifetime, asks })
    }

    /// The answer: the modes of any one wave of a storm, and the slides of a life.
    pub(in crate::random) fn answer(
        &self,
        name: &str,
        request: ChanceRequest,
        portion: Portion<'_>,
    ) -> Result<Probability, ProbabilityError> {
        let life = self.life();
        if request.follow {
            return Err(SlidingError::NoTurns.into());
        }
        if self.lifetime.survived.is_some() {
            return Err(SlidingError::Survived.into());
        }
        if self.lifetime.bodies.is_some() {
            return Err(SlidingError::NoRow.into());
        }
        if let Some(key) = self.asks {
            return Err(SlidingError::NoModes { key }.into());
        }
        let sliding = sliding(&self.storm, self, &self.laws, &life, (&request, &[]), portion)?;
        portion.check()?;
        let nothing = Estimate { value: 0.0, low: 0.0, high: 0.0 };
        let rests = |e: Estimate| Estimate { value: 1.0 - e.value, low: 1.0 - e.high, high: 1.0 - e.low };
        let all = |slides: Estimate| -> Vec<(Happening, Estimate)> {
            let of = |happening| match happening {
                Happening::REST => rests(slides),
                Happening::Decided(Verdict::Begins(Mode::SlideLeft)) => slides,
                _ => nothing,
            };
            exclusive(false).map(Happening::of).map(|happening| (happening, of(happening))).collect()
        };
        let first = all(Estimate { value: 1.0, low: 1.0, high: 1.0 });
        let chances = Chances {
            situation: Some("any one wave of a storm".to_owned()),
            line: ("the height of waves".to_owned(), true),
            method: Method::Sobol,
            given_up: false,
            points: sliding.lives * life.times().ceil() as u64,
            precise: sliding.precise,
            modes: all(sliding.wave),
            not_rest: sliding.wave,
            not_unique: Some(nothing),
            lifted: nothing,
            first_departure: FirstDeparture {
                modes: first.into_iter().filter(|(happening, _)| *happening != Happening::REST).collect(),
                never: nothing,
                at_once: nothing,
                precise: true,
            },
            design_point: None,
            design_points: None,
            design_values: None,
            slopes: None,
            known: Vec::new(),
            course: Vec::new(),
            life: self.lifetime.years.map(|years| LifeChances {
                years,
                events: self.lifetime.events_per_year,
                stood: None,
                not_rest: sliding.ever,
                // Any wave that does not slide it is one at rest.
                modes: all(sliding.ever)
                    .into_iter()
                    .map(|(h, e)| (h, if h == Happening::REST { rests(nothing) } else { e }))
                    .collect(),
                method: Method::Sobol,
                precise: true,
            }),
        };
        Ok(Probability {
            case: name.to_owned(),
            title: None,
            problem: None,
            steep_seas: 0.0,
            request,
            random: self.random.iter().map(RandomNumber::of).collect(),
            line: ("the height of waves".to_owned(), true),
            situations: vec![chances],
            joined: None,
            row: None,
            criteria: Vec::new(),
            sliding: Some(sliding),
            overturning: None,
            fragility: None,
            note: None,
        })
    }

    /// The life that is asked for; one year where none is.
    pub(in crate::random) fn life(&self) -> Life {
        let yearly = self.random.iter().map(|input| input.every != Rate::Life).collect();
        let Lifetime { years, events_per_year: events, .. } = self.lifetime;
        Life { years: years.unwrap_or(1.0), yearly, events, clock: None }
    }
}

/// A wave whose thrust is in proportion to its height.
pub(in crate::random) struct Proportional {
    /// F_S/R for each metre of height.
    slope: f64,
    significant: f64,
    /// Rτ₀²/m, m.
    scale: f64,
    pulse: Pulse,
}

impl Slide for Proportional {
    fn slide(&self, level: f64) -> f64 {
        self.scale * self.pulse.slide(self.slope * height(level, self.significant))
    }
}

impl Storms for PureStorm {
    type Wave = Proportional;

    fn storm(&self, drawn: &[f64]) -> Option<Year<Proportional>> {
        let mut values = self.values;
        let (mut of_force, mut of_uplift) = (1.0, 1.0);
        for (input, value) in self.random.iter().zip(drawn) {
            match input.quantity {
                Quantity::Storm(field) => values[field as usize] = *value,
                Quantity::Bias(Bias::Thrust) => of_force = *value,
                Quantity::Bias(Bias::Uplift) => of_uplift = *value,
                _ => {}
            }
        }
        let [significant, force, uplift, weight, mass, μ] = values;
        let resistance = μ * weight;
        let slope = (of_force * force + μ * of_uplift * uplift) / resistance;
        let scale = resistance * self.tau0 * self.tau0 / mass;
        let part = |part: &StormPart| {
            let significant = significant * part.height;
            let least = level(1.0 / slope, significant);
            // e⁻⁷⁰⁰ is no chance, and a slope of zero no slide.
            (least <= 700.0).then(|| Part {
                slides: vec![(least, f64::INFINITY)],
                turns: Vec::new(),
                cut: f64::INFINITY,
                wave: Proportional { slope, significant, scale, pulse: self.storm.pulse },
            })
        };
        let parts = &self.storm.parts;
        Year::of(parts.iter().filter_map(part).collect(), parts.len())
    }
}
