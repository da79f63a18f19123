//! From the names and laws of a `[random]` table to what they are in a case.

use standfast_probability::copula::{Copula, CopulaError, Correlation};
use standfast_probability::problem::RandomVector;

use super::quantity::{Bias, Coordinate, Quantity, RandomInput};
use super::storm::StormField;
use crate::case::Case;
use crate::couple::Variable;
use crate::inputs::Inputs;
use crate::key::{Key, Table};
use crate::suggest::closest;
use standfast_inputs::random::{Parameter, Random, RandomEntry, RandomProblem, Rate, ReadResult};
use standfast_model::CaseFile;
use standfast_probability::law::{Distribution, Law};

mod given;
mod laws;

/// Name of the sea's level, with what goes with it.
pub(super) const WATER_LEVEL: &str = "water_level";

/// Keys that say how high water stands.
pub(super) const LEVELS: [Key; 5] =
    [Key::Level, Key::WaterLeft, Key::WaterRight, Key::BaseDepth, Key::StillWaterLevel];

/// A random number that says how high water stands, other than the level that rises.
pub(super) fn other_level<'a>(inputs: &'a [RandomInput], level: &Variable) -> Option<&'a RandomInput> {
    inputs.iter().find(|other| {
        other.variable().is_some_and(|variable| LEVELS.contains(&variable.id().key) && variable != level)
    })
}

/// From names and laws as they are written to what they are.
pub(super) struct Resolve<'a>(pub(super) Names<'a>);

/// Subject that names are of: a case, a point of the report's plane, or a storm without a body.
#[derive(Clone, Copy)]
pub(super) enum Names<'a> {
    /// A case; its file at rest and, where the motion is followed, the inputs in time, whose numbers may be random too.
    Case(&'a CaseFile, &'a Case, Option<&'a Inputs>),
    Point([f64; 4]),
    /// A storm without a body.
    Storm([f64; 6]),
    /// A limit state that is the user's own: any name is of one of its numbers.
    Own,
}

impl Resolve<'_> {
    /// The random numbers, and their laws.
    pub(super) fn all(&self, random: &Random) -> ReadResult<(Vec<RandomInput>, RandomVector)> {
        let mut inputs: Vec<RandomInput> = Vec::new();
        let mut laws = Vec::new();
        for named in &random.named {
            let quantity = self.quantity(named)?;
            if let Some(other) = inputs.iter().find(|input| same(&input.quantity, &quantity)) {
                let (name, other) = (named.name.clone(), other.name.clone());
                return Err((RandomProblem::Twice { name, other }, named.span.clone()));
            }
            let fit = (named.law == "fitted").then(|| self.fitted(named, &quantity)).transpose()?;
            // The law of what depends on others is found when all are known.
            let law = match (&fit, &named.given) {
                (Some(fit), None) => fit.likeliest().map(Some),
                (None, Some(_)) => Law::normal(0.0, 1.0).map(Some),
                (Some(_), Some(of)) => {
                    let message = format!("`{}` is fitted, and given another number", named.name);
                    return Err((RandomProblem::Other(message), of.span.clone()));
                }
                (None, None) => Ok(None),
            };
            let law = law.map_err(|error| (RandomProblem::Other(error.to_string()), named.span.clone()))?;
            let (law, cut) = match law {
                Some(law) if fit.is_none() => (law.into(), 0.0),
                Some(law) => self.cut(named, &quantity, law)?,
                None => self.law(named, &quantity)?,
            };
            let name = named.name.clone();
            inputs.push(RandomInput { name, quantity, every: named.every, own: named.own, cut, fit });
            laws.push(law);
        }
        let (mut given, cuts) = self.given(random, &inputs, &laws)?;
        cuts.into_iter().for_each(|(place, cut)| inputs[place].cut = cut);
        if let Some(rise) = &random.rise {
            let (input, law) = self.rise(rise, random)?;
            if let Some(other) = input.rise_of().and_then(|level| other_level(&inputs, level)) {
                let name = &other.name;
                let message = format!(
                    "`rise_per_year` raises the water level: make `water_level` random in place of `{name}`"
                );
                return Err((RandomProblem::Other(message), rise.span.clone()));
            }
            inputs.push(input);
            laws.push(law);
        }
        let mut correlations: Vec<Correlation> = random
            .correlations
            .iter()
            .map(|&(first, second, measure)| Correlation { first, second, measure })
            .collect();
        for (place, named) in random.named.iter().enumerate() {
            let Some(fit) = inputs[place].fit.clone() else { continue };
            let of = (place, &fit);
            given.push(self.add_parameters(named, of, (&mut inputs, &mut laws), &mut correlations)?);
        }
        let copula = Copula::new(&laws, &correlations).map_err(|error| {
            let at = |first: usize, second: usize| {
                let place = random.correlations.iter().rposition(|(a, b, _)| (*a, *b) == (first, second));
                place.map_or(random.span.clone(), |place| random.correlation_spans[place].clone())
            };
            match error {
                CopulaError::Unattainable { first, second, value, from, to, beside_others } => {
                    let name = |place: usize| inputs[place].name.clone();
                    let problem = RandomProblem::Correlation {
                        first: name(first),
                        second: name(second),
                        value,
                        from,
                        to,
                        beside_others,
                    };
                    (problem, at(first, second))
                }
                CopulaError::Twice { first, second } => {
                    let names = format!("`{}` and `{}`", inputs[first].name, inputs[second].name);
                    let message = format!("the correlation of {names} is given twice");
                    (RandomProblem::Other(message), at(first, second))
                }
                CopulaError::Pair { first, .. } => {
                    let message = format!("`{}` is correlated with itself", inputs[first].name);
                    (RandomProblem::Other(message), at(first, first))
                }
                other => (RandomProblem::Other(other.to_string()), random.span.clone()),
            }
        })?;
        Ok((inputs, RandomVector::new(laws, copula).with_given(given)))
    }

    /// The rise of the water over the years, in each of which it has a value of its own: of an average year, any of them as likely.
    fn rise(&self, parameter: &Parameter, random: &Random) -> ReadResult<(RandomInput, Distribution)> {
        let refused = |message: &str| (RandomProblem::Other(message.to_owned()), parameter.span.clone());
        let level = match self.0 {
            Names::Case(file, case, _) if case.plan.is_none() => {
                Variable::find(WATER_LEVEL, file.inputs()).ok()
            }
            _ => None,
        };
        let level =
            level.ok_or_else(|| refused("`rise_per_year` raises a water level, and the case has none"))?;
        let years = random.lifetime.years.ok_or_else(|| {
            refused("`rise_per_year` rises over the `years` of a life, and nothing says how many there are")
        })?;
        let named = RandomEntry::without_law("[random]".to_owned(), parameter.span.clone());
        let rise = years * self.value(&named, &Quantity::Key(level.clone()), parameter)?;
        let law = Law::uniform(rise.min(0.0), rise.max(0.0))
            .map_err(|_| refused("`rise_per_year` is 0; expected a rise, or a fall below zero"))?;
        let every = if random.lifetime.events_per_year.is_some() { Rate::Event } else { Rate::Year };
        let quantity = Quantity::Rise(level);
        Ok((
            RandomInput { name: "rise".to_owned(), quantity, every, own: false, cut: 0.0, fit: None },
            law.into(),
        ))
    }

    /// Quantity that a name stands for.
    pub(super) fn quantity(&self, named: &RandomEntry) -> ReadResult<Quantity> {
        let (file, case, moving) = match self.0 {
            Names::Case(file, case, moving) => (file, case, moving),
            Names::Storm(_) => return of_storm(named),
            Names::Own => return Ok(Quantity::Own(named.name.clone())),
            Names::Point(_) => {
                let found = Coordinate::ALL.into_iter().find(|coordinate| coordinate.name() == named.name);
                return found.map(Quantity::Point).ok_or_else(|| {
                    let (what, name) = ("[random] of a [point]".to_owned(), named.name.clone());
                    let allowed = Coordinate::ALL.map(|coordinate| coordinate.name().to_owned()).to_vec();
                    (RandomProblem::Name { what, name, allowed }, named.span.clone())
                });
            }
        };
        if let Some(bias) = Bias::ALL.into_iter().find(|bias| bias.name() == named.name) {
            // Water that follows an opening follows each force as it is.
            let follows = bias == Bias::Force && case.follows_opening();
            let known = match bias.lacks(file.inputs()) {
                Some(lacks) => format!("the case has {lacks}"),
                None if follows => {
                    "water under the base follows an opening, which a factor behind it would miss: make each load.…force random, or set \
                     opening = \"closed\" in [water]"
                        .to_owned()
                }
                None => return Ok(Quantity::Bias(bias)),
            };
            let name = named.name.clone();
            return Err((RandomProblem::NoNumber { name, suggestion: None, known }, named.span.clone()));
        }
        let name = &named.name;
        let of_motion = |inputs: &Inputs| {
            let variable = Variable::find(name, inputs).ok()?;
            matches!(variable.id().table, Table::Impact | Table::Initial).then_some(variable)
        };
        let found = moving.and_then(of_motion).map_or_else(|| Variable::find(name, file.inputs()), Ok);
        match found {
            Ok(variable) => Ok(Quantity::Key(variable)),
            Err(_) if name.starts_with("motion.") => {
                let known = "of the motion the numbers of [motion.impact] and [motion.initial] are drawn, where it is followed over `pga`";
                let (name, known) = (named.name.clone(), known.to_owned());
                Err((RandomProblem::NoNumber { name, suggestion: None, known }, named.span.clone()))
            }
            Err(unknown) => {
                let on = |bias: &Bias| bias.lacks(file.inputs()).is_none();
                let biases: Vec<&str> = Bias::ALL.into_iter().filter(on).map(Bias::name).collect();
                let suggestion = unknown
                    .suggestion
                    .or_else(|| closest(name, Bias::ALL.map(Bias::name)).map(str::to_owned));
                let known = match unknown.unwritten {
                    Some((table, _))
                        if file.inputs().choice(Key::EarthquakeDirection).is_some()
                            && table == Table::Earthquake =>
                    {
                        "`direction_deg` is \"worst\", which is no number: leave it out, or give an angle"
                            .to_owned()
                    }
                    Some((table, line)) => {
                        format!(
                            "the case does not give it: write it first under {}, for example {line}",
                            table.header()
                        )
                    }
                    None => {
                        format!("its numbers are {}, and {}", unknown.names.join(", "), biases.join(", "))
                    }
                };
                let name = named.name.clone();
                Err((RandomProblem::NoNumber { name, suggestion, known }, named.span.clone()))
            }
        }
    }
}

/// Quantity that a name stands for in a storm without a body.
fn of_storm(named: &RandomEntry) -> ReadResult<Quantity> {
    let biases = [Bias::Thrust, Bias::Uplift];
    if let Some(bias) = biases.into_iter().find(|bias| bias.name() == named.name) {
        return Ok(Quantity::Bias(bias));
    }
    let found = StormField::ALL.into_iter().find(|field| field.name() == named.name);
    found.map(Quantity::Storm).ok_or_else(|| {
        let (what, name) = ("[random] of a [storm] without a [body]".to_owned(), named.name.clone());
        let names = StormField::ALL.map(StormField::name).into_iter().chain(biases.map(Bias::name));
        (RandomProblem::Name { what, name, allowed: names.map(str::to_owned).collect() }, named.span.clone())
    })
}

/// True if two names are one number.
pub(super) fn same(one: &Quantity, other: &Quantity) -> bool {
    match (one, other) {
        (Quantity::Key(one), Quantity::Key(other)) => one.id() == other.id(),
        (one, other) => one == other,
    }
}
