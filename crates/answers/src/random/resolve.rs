//! From the names and laws of a `[random]` table to what they are in a case.

use standfast_probability::copula::{Copula, CopulaError, Correlation};
use standfast_probability::law::{Distribution, Law, LawError};
use standfast_probability::problem::RandomVector;

use super::quantity::{Bias, Coordinate, Quantity, RandomInput};
use super::storm::StormField;
use crate::case::Case;
use crate::couple::Variable;
use crate::digits::digits;
use crate::inputs::Inputs;
use crate::key::{Key, Range, Table};
use crate::suggest::closest;
use standfast_inputs::random::{Parameter, Random, RandomEntry, RandomProblem, ReadResult, Written, years};
use standfast_model::CaseFile;

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
            let (law, cut) = self.law(named, &quantity)?;
            inputs.push(RandomInput { name: named.name.clone(), quantity, every: named.every, cut });
            laws.push(law);
        }
        let correlations: Vec<Correlation> = random
            .correlations
            .iter()
            .map(|&(first, second, measure)| Correlation { first, second, measure })
            .collect();
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
        Ok((inputs, RandomVector::new(laws, copula)))
    }

    /// Quantity that a name stands for.
    pub(super) fn quantity(&self, named: &RandomEntry) -> ReadResult<Quantity> {
        let (file, case, moving) = match self.0 {
            Names::Case(file, case, moving) => (file, case, moving),
            Names::Storm(_) => return of_storm(named),
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
            let waves = case.wave.is_some();
            let there = if bias == Bias::Force { !case.forces.is_empty() } else { waves };
            // Water that follows an opening follows each force as it is.
            let follows = bias == Bias::Force && case.follows_opening();
            if there && !follows {
                return Ok(Quantity::Bias(bias));
            }
            let known = match bias {
                _ if follows => {
                    "water under the base follows an opening, which a factor behind it would miss: make each load.…force random, or set \
                     opening = \"closed\" in [water]"
                }
                Bias::Force => "the case has no [[load]]",
                _ => "the case has no waves",
            };
            let (name, known) = (named.name.clone(), known.to_owned());
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
                let biases = Bias::ALL.map(Bias::name);
                let suggestion = unknown.suggestion.or_else(|| closest(name, biases).map(str::to_owned));
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

    /// The law of a random number, and what was cut of it because no body has such values.
    fn law(&self, named: &RandomEntry, quantity: &Quantity) -> ReadResult<(Distribution, f64)> {
        let law = self.plain_law(named, quantity)?;
        let (lower, upper) = self.bounds(named, quantity)?;
        let refused = |error: LawError| empty_range(named, lower, upper, &error);
        let (range, [least, most]) = (range(quantity), range(quantity).ends());
        let asked = Distribution::truncated(law.clone(), lower, upper).map_err(refused)?;
        if lower >= least && upper <= most {
            return Ok((asked, 0.0));
        }
        let cut = [asked.tails(least).below, asked.tails(most).above];
        let share: f64 = cut.iter().sum();
        if share > 1e-3 {
            let limit = match range {
                Range::NotNegative => "it is negative".to_owned(),
                _ if cut[1] == 0.0 => "it is zero or less".to_owned(),
                _ => format!("it is not {}", range.words()),
            };
            let (name, share) = (named.name.clone(), digits(share));
            return Err((RandomProblem::Unphysical { name, share, limit }, named.span.clone()));
        }
        let whole = Distribution::truncated(law, lower.max(least), upper.min(most)).map_err(refused)?;
        Ok((whole, share))
    }

    /// Bounds at which a law is cut, without bound where nothing is said.
    fn bounds(&self, named: &RandomEntry, quantity: &Quantity) -> ReadResult<(f64, f64)> {
        let bound = |parameter: &Option<Parameter>, none: f64| match parameter {
            Some(parameter) => self.value(named, quantity, parameter),
            None => Ok(none),
        };
        Ok((bound(&named.lower, f64::NEG_INFINITY)?, bound(&named.upper, f64::INFINITY)?))
    }

    /// The law before truncation.
    fn plain_law(&self, named: &RandomEntry, quantity: &Quantity) -> ReadResult<Law> {
        let find = |name: &str| named.parameters.iter().find(|parameter| parameter.name == name);
        let measured =
            |name: &str| find(name).map(|parameter| self.value(named, quantity, parameter)).transpose();
        let plain = |name: &str| find(name).map(|parameter| self.plain(named, parameter)).transpose();
        let lacks = |needed| {
            let (law, name) = (named.law, named.name.clone());
            (RandomProblem::Lacks { law, name, needed }, named.span.clone())
        };
        let need = |name: &'static str| measured(name).and_then(|value| value.ok_or_else(|| lacks(name)));
        let need_plain = |name: &'static str| plain(name).and_then(|value| value.ok_or_else(|| lacks(name)));
        // Mean and deviation; the mean is the case's value where none is given, and 1 of a bias.
        let moments = || -> ReadResult<(f64, f64)> {
            let own = match (quantity, self.0) {
                (Quantity::Key(variable), Names::Case(file, case, moving)) => {
                    let own = moving.filter(|_| variable.id().table.is_of_motion()).unwrap_or(file.inputs());
                    variable.value(own, case)
                }
                (Quantity::Point(coordinate), Names::Point(point)) => point[*coordinate as usize],
                (Quantity::Storm(field), Names::Storm(values)) => values[*field as usize],
                _ => 1.0,
            };
            let mean = measured("mean")?.unwrap_or(own);
            match (measured("sd")?, plain("cov")?) {
                (Some(_), Some(_)) => {
                    let found = "both `sd` and `cov`".to_owned();
                    let message = format!(
                        "the law {} of `{}` has {found}; expected one of them",
                        named.law, named.name
                    );
                    Err((RandomProblem::Other(message), named.span.clone()))
                }
                (Some(sd), None) => Ok((mean, sd)),
                (None, Some(cov)) => Ok((mean, cov * mean.abs())),
                (None, None) => Err(lacks("`sd`, a standard deviation, or `cov`, its share of the mean")),
            }
        };
        let law = match named.law {
            "normal" => moments().map(|(mean, sd)| Law::normal(mean, sd))?,
            "lognormal" => moments().map(|(mean, sd)| Law::lognormal(mean, sd))?,
            "gumbel" => {
                let returns: Vec<&Parameter> =
                    named.parameters.iter().filter(|parameter| years(&parameter.name).is_some()).collect();
                match (&returns[..], find("mode").or(find("scale"))) {
                    ([], None) => moments().map(|(mean, sd)| Law::gumbel_of_mean(mean, sd))?,
                    ([], Some(_)) => Law::gumbel(need("mode")?, need("scale")?),
                    ([one, two], None) => {
                        let of = |parameter: &&Parameter| -> ReadResult<(f64, f64)> {
                            let value = self.value(named, quantity, parameter)?;
                            Ok((years(&parameter.name).unwrap_or(f64::NAN), value))
                        };
                        Law::gumbel_of_returns(of(one)?, of(two)?)
                    }
                    _ => return Err(lacks("either mean and sd, mode and scale, or two return values")),
                }
            }
            "weibull" => {
                Law::weibull(need("scale")?, need_plain("shape")?, measured("location")?.unwrap_or(0.0))
            }
            "gev" => Law::gev(need("location")?, need("scale")?, need_plain("shape")?),
            "uniform" => Law::uniform(need("from")?, need("to")?),
            "triangular" => Law::triangular(need("from")?, need("mode")?, need("to")?),
            _ => {
                let inner = named.of.as_ref().ok_or_else(|| lacks("a law of which it is the largest"))?;
                let of = self.plain_law(inner, quantity)?;
                let (lower, upper) = self.bounds(inner, quantity)?;
                let of = Distribution::truncated(of, lower, upper)
                    .map_err(|error| empty_range(inner, lower, upper, &error))?;
                Law::max_of(of, need_plain("count")?)
            }
        };
        law.map_err(|error| match error {
            LawError::Parameter { parameter, value, expected, .. } => {
                let at = find(parameter).map_or(named.span.clone(), |parameter| parameter.span.clone());
                let what = format!("`{parameter}` of the law {} of `{}`", named.law, named.name);
                (RandomProblem::Value { what, written: digits(value), expected: expected.to_owned() }, at)
            }
            other => (RandomProblem::Other(other.to_string()), named.span.clone()),
        })
    }

    /// A parameter in SI units of the random number; deviations and scales too.
    fn value(&self, named: &RandomEntry, quantity: &Quantity, parameter: &Parameter) -> ReadResult<f64> {
        match (&parameter.value, quantity, self.0) {
            (Written::Text(text), Quantity::Key(variable), Names::Case(file, ..)) => {
                variable.read(text, file.inputs()).map_err(|_| {
                    let expected = match variable.dimension() {
                        Some(dimension) => {
                            format!("a number, or {} in {}", dimension.words(), dimension.understood())
                        }
                        None => "a number without unit or quotes".to_owned(),
                    };
                    let what = format!("`{}` of `{}`", parameter.name, named.name);
                    (
                        RandomProblem::Value { what, written: format!("\"{text}\""), expected },
                        parameter.span.clone(),
                    )
                })
            }
            (Written::Text(text), Quantity::Storm(field), _) => {
                let dimension = field.dimension();
                dimension.and_then(|dimension| dimension.parse(text).ok()).ok_or_else(|| {
                    let expected = match dimension {
                        Some(dimension) => {
                            format!("a number, or {} in {}", dimension.words(), dimension.understood())
                        }
                        None => "a number without unit or quotes".to_owned(),
                    };
                    let what = format!("`{}` of `{}`", parameter.name, named.name);
                    let written = format!("\"{text}\"");
                    (RandomProblem::Value { what, written, expected }, parameter.span.clone())
                })
            }
            (Written::Number(number), Quantity::Key(variable), _)
                if variable.key().info().kind.is_of_shaking()
                    && variable.dimension().is_some()
                    && *number != 0.0 =>
            {
                // As behind the key itself.
                let what = format!("`{}` of `{}`", parameter.name, named.name);
                let expected = format!("an acceleration with its unit, \"{number} g\" or \"{number} m/s2\"");
                Err((
                    RandomProblem::Value { what, written: number.to_string(), expected },
                    parameter.span.clone(),
                ))
            }
            _ => self.plain(named, parameter),
        }
    }

    fn plain(&self, named: &RandomEntry, parameter: &Parameter) -> ReadResult<f64> {
        match &parameter.value {
            Written::Number(number) if number.is_finite() => Ok(*number),
            written => {
                let written = match written {
                    Written::Number(number) => number.to_string(),
                    Written::Text(text) => format!("\"{text}\""),
                };
                let what = format!("`{}` of `{}`", parameter.name, named.name);
                let expected = match &parameter.value {
                    Written::Number(_) => "a finite number".to_owned(),
                    Written::Text(_) => "a number without unit or quotes".to_owned(),
                };
                Err((RandomProblem::Value { what, written, expected }, parameter.span.clone()))
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

/// Range of the values of a random number.
fn range(quantity: &Quantity) -> Range {
    match quantity {
        Quantity::Key(variable) => variable.range(),
        Quantity::Bias(_) => Range::NotNegative,
        Quantity::Point(coordinate) => coordinate.range(),
        Quantity::Storm(field) => field.range(),
    }
}

/// A range in which a law has no values.
fn empty_range(
    named: &RandomEntry,
    lower: f64,
    upper: f64,
    error: &LawError,
) -> (RandomProblem, std::ops::Range<usize>) {
    let problem = RandomProblem::Value {
        what: format!("the range of `{}`", named.name),
        written: format!("{} to {}", digits(lower), digits(upper)),
        expected: format!("a range in which its law has values; {error}"),
    };
    (problem, named.span.clone())
}

/// True if two names are one number.
pub(super) fn same(one: &Quantity, other: &Quantity) -> bool {
    match (one, other) {
        (Quantity::Key(one), Quantity::Key(other)) => one.id() == other.id(),
        (one, other) => one == other,
    }
}
