//! Laws that depend on another random number, and laws fitted to values, whose parameters are random numbers themselves.

use standfast_probability::copula::{Correlation, CorrelationMeasure};
use standfast_probability::fit::{Family, Fit};
use standfast_probability::law::{Distribution, Law, LawError};
use standfast_probability::normal;
use standfast_probability::problem::GivenLaw;

use super::laws::{MOST_CUT, numbers, range, unphysical};
use super::{Resolve, same};
use crate::digits::digits;
use crate::random::quantity::{Quantity, RandomInput};
use crate::suggest::closest;
use standfast_inputs::random::{Parameter, Random, RandomEntry, RandomProblem, Rate, ReadResult, Written};

/// A law that may depend on another number, by some of its parameters.
struct Way {
    law: &'static str,
    /// Each with true if it is in units of the number.
    parameters: &'static [(&'static str, bool)],
    make: fn(&[f64]) -> Result<Law, LawError>,
}

const fn way(
    law: &'static str,
    parameters: &'static [(&'static str, bool)],
    make: fn(&[f64]) -> Result<Law, LawError>,
) -> Way {
    Way { law, parameters, make }
}

const WAYS: [Way; 11] = [
    way("normal", &[("mean", true), ("sd", true)], |p| Law::normal(p[0], p[1])),
    way("normal", &[("mean", true), ("cov", false)], |p| Law::normal(p[0], p[1] * p[0].abs())),
    way("lognormal", &[("mean", true), ("sd", true)], |p| Law::lognormal(p[0], p[1])),
    way("lognormal", &[("mean", true), ("cov", false)], |p| Law::lognormal(p[0], p[1] * p[0])),
    way("lognormal", &[("log_mean", false), ("log_sd", false)], |p| Law::lognormal_of_logs(p[0], p[1])),
    way("gumbel", &[("mean", true), ("sd", true)], |p| Law::gumbel_of_mean(p[0], p[1])),
    way("gumbel", &[("mean", true), ("cov", false)], |p| Law::gumbel_of_mean(p[0], p[1] * p[0].abs())),
    way("gumbel", &[("mode", true), ("scale", true)], |p| Law::gumbel(p[0], p[1])),
    way("weibull", &[("scale", true), ("shape", false)], |p| Law::weibull(p[0], p[1], 0.0)),
    way("gev", &[("location", true), ("scale", true), ("shape", false)], |p| Law::gev(p[0], p[1], p[2])),
    way("uniform", &[("from", true), ("to", true)], |p| Law::uniform(p[0], p[1])),
];

/// A parameter as a function of the number on which a law depends.
#[derive(Debug, Clone)]
enum Function {
    /// The same everywhere.
    Constant(f64),
    /// Straight between points, and the same beyond them.
    Between { at: Vec<f64>, is: Vec<f64> },
    /// constant + factor xᵖ.
    Power { constant: f64, factor: f64, power: f64 },
    /// constant + factor eʳˣ.
    Exponential { constant: f64, factor: f64, rate: f64 },
}

impl Function {
    fn value(&self, x: f64) -> f64 {
        match self {
            Function::Constant(value) => *value,
            Function::Between { at, is } => {
                let next = at.partition_point(|a| *a < x).clamp(1, at.len() - 1);
                let part = ((x - at[next - 1]) / (at[next] - at[next - 1])).clamp(0.0, 1.0);
                is[next - 1] + part * (is[next] - is[next - 1])
            }
            Function::Power { constant, factor, power } => constant + factor * x.powf(*power),
            Function::Exponential { constant, factor, rate } => constant + factor * (rate * x).exp(),
        }
    }
}

/// Laws that depend on others, each with the place of its number; and what was cut of them because no body has such values.
pub(super) type Given = (Vec<(usize, GivenLaw)>, Vec<(usize, f64)>);

impl Resolve<'_> {
    /// The laws of the numbers that are given others.
    pub(super) fn given(
        &self,
        random: &Random,
        inputs: &[RandomInput],
        laws: &[Distribution],
    ) -> ReadResult<Given> {
        let mut parents = Vec::new();
        for (place, named) in random.named.iter().enumerate() {
            if let Some(of) = &named.given {
                parents.push((place, self.parent_of(named, (place, of), random, inputs)?));
            }
        }
        let (mut given, mut cuts, mut laws) = (Vec::new(), Vec::new(), laws.to_vec());
        while !parents.is_empty() {
            // First those whose other number has its law.
            let is_known = |(_, parent): &(usize, usize)| parents.iter().all(|(place, _)| place != parent);
            let Some(next) = parents.iter().position(is_known) else {
                let named = &random.named[parents[0].0];
                let others: Vec<String> =
                    parents.iter().map(|(place, _)| format!("`{}`", random.named[*place].name)).collect();
                let message = format!(
                    "the laws of {} depend on each other in a circle; expected one that is given none of them",
                    others.join(" and ")
                );
                return Err((RandomProblem::Other(message), named.span.clone()));
            };
            let (place, parent) = parents.remove(next);
            let named = &random.named[place];
            let (own, other) = (&inputs[place], &inputs[parent]);
            let law = self.given_law(named, &own.quantity, (&random.named[parent], &other.quantity))?;
            let (law, [below, above]) = law.checked(named, &other.name, &laws[parent])?;
            let cut = below + above;
            if cut > MOST_CUT {
                return Err((unphysical(named, &own.quantity, cut, above == 0.0), named.span.clone()));
            }
            laws[place] = law.at_median.clone();
            cuts.push((place, cut));
            given.push((place, GivenLaw::new(vec![parent], move |values| law.distribution(values[parent]))));
        }
        Ok((given, cuts))
    }

    /// The number on which the law of one depends: another, which is drawn no more often, and is not correlated with it.
    fn parent_of(
        &self,
        named: &RandomEntry,
        (place, of): (usize, &Parameter),
        random: &Random,
        inputs: &[RandomInput],
    ) -> ReadResult<usize> {
        let refused = |message: String| Err((RandomProblem::Other(message), of.span.clone()));
        let name = &named.name;
        let Some(parent) = self.parent(of, inputs) else {
            let others = inputs.iter().enumerate().filter(|(other, _)| *other != place);
            let names: Vec<&str> = others.map(|(_, input)| input.name.as_str()).collect();
            let expected = match &names[..] {
                [] => "another random number, and there is none".to_owned(),
                names => format!("another random number, of {}", names.join(", ")),
            };
            let meant = closest(&of.value.to_string(), names.iter().copied());
            let meant = meant.map_or(String::new(), |meant| format!(": did you mean `{meant}`?"));
            return refused(format!("`{name}` is given \"{}\"; expected {expected}{meant}", of.value));
        };
        if parent == place {
            return refused(format!("`{name}` is given itself; expected another random number"));
        }
        let (own, other) = (&inputs[place], &inputs[parent]);
        let rate = match other.every {
            _ if other.own && !own.own => Some("each = \"body\""),
            Rate::Event if own.every == Rate::Life => Some("every = \"event\""),
            Rate::Year if own.every == Rate::Life => Some("every = \"year\""),
            _ => None,
        };
        if let Some(rate) = rate {
            return refused(format!(
                "`{name}` is given `{}`, which is drawn more often; expected {rate} for both",
                other.name
            ));
        }
        if random.correlations.iter().any(|(a, b, _)| *a == place || *b == place) {
            return refused(format!(
                "`{name}` is given `{}`, and goes with others as its law says; expected no [[random.correlation]] with it",
                other.name
            ));
        }
        Ok(parent)
    }

    /// The place of the number that is meant by its name.
    fn parent(&self, of: &Parameter, inputs: &[RandomInput]) -> Option<usize> {
        let Written::Text(name) = &of.value else { return None };
        let by_name = inputs.iter().position(|input| input.name == *name);
        by_name.or_else(|| {
            let named = RandomEntry::without_law(name.clone(), of.span.clone());
            let meant = self.quantity(&named).ok()?;
            inputs.iter().position(|input| same(&input.quantity, &meant))
        })
    }

    /// The law of a number, given another.
    fn given_law(
        &self,
        named: &RandomEntry,
        quantity: &Quantity,
        other: (&RandomEntry, &Quantity),
    ) -> ReadResult<Functions> {
        let find = |name: &str| named.parameters.iter().find(|parameter| parameter.name == name);
        let ways = || WAYS.iter().filter(|way| way.law == named.law);
        let fits = |way: &&Way| {
            let parameters = way.parameters;
            parameters.len() == named.parameters.len()
                && parameters.iter().all(|(name, _)| find(name).is_some())
        };
        let Some(Way { parameters, make, .. }) = ways().find(fits) else {
            let all = |way: &Way| {
                way.parameters.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(" and ")
            };
            let ways: Vec<String> = ways().map(all).collect();
            let expected = if ways.is_empty() {
                let mut names: Vec<&str> = WAYS.iter().map(|way| way.law).collect();
                names.dedup();
                format!("one of the laws {}", names.join(", "))
            } else {
                ways.join(", or ")
            };
            let has: Vec<String> = named.parameters.iter().map(|of| format!("`{}`", of.name)).collect();
            let has = if has.is_empty() { "nothing".to_owned() } else { has.join(" and ") };
            let message = format!(
                "the law {} of `{}`, which is given another number, has {has}; expected {expected}",
                named.law, named.name
            );
            return Err((RandomProblem::Other(message), named.span.clone()));
        };
        let function = |&(name, is_measured): &(&str, bool)| {
            let parameter = find(name).expect("found above");
            self.function((named, quantity), parameter, is_measured, other)
        };
        let functions = parameters.iter().map(function).collect::<ReadResult<Vec<_>>>()?;
        if !functions.iter().any(|function| !matches!(function, Function::Constant(_))) {
            let message = format!(
                "`{}` is given another number, and no parameter of its law is a function of it, as \
                 mean = {{ at = [3, 6], is = [8, 11] }}",
                named.name
            );
            return Err((RandomProblem::Other(message), named.span.clone()));
        }
        let (bounds, range) = (self.bounds(named, quantity)?, range(quantity).ends());
        Ok(Functions { make: *make, functions, bounds, range })
    }

    /// A parameter as it is written: a value, or a function.
    fn function(
        &self,
        (named, quantity): (&RandomEntry, &Quantity),
        parameter: &Parameter,
        is_measured: bool,
        (other, of_other): (&RandomEntry, &Quantity),
    ) -> ReadResult<Function> {
        let own = |value: &Parameter| {
            if is_measured { self.value(named, quantity, value) } else { self.plain(named, value) }
        };
        let Written::Function(of) = &parameter.value else { return Ok(Function::Constant(own(parameter)?)) };
        let refused = |expected: &str| {
            let message = format!("`{}` of `{}`: expected {expected}", parameter.name, named.name);
            (RandomProblem::Other(message), parameter.span.clone())
        };
        let find = |name: &str| of.iter().find(|one| one.name == name);
        let number = |name: &str| find(name).map(|one| self.plain(named, one)).transpose();
        match [find("at"), find("is")] {
            [Some(at), Some(is)] if of.len() == 2 => {
                let at = numbers(at, &|one| self.value(other, of_other, one))?;
                let is = numbers(is, &own)?;
                let rises = at.len() >= 2 && at.windows(2).all(|pair| pair[0] < pair[1]);
                if !rises {
                    let at: Vec<String> = at.iter().map(|value| digits(*value)).collect();
                    let expected =
                        format!("two values or more in `at`, each above the last; it has {}", at.join(", "));
                    return Err(refused(&expected));
                }
                if at.len() != is.len() {
                    let expected =
                        format!("as many values in `is` as in `at`; they have {} and {}", is.len(), at.len());
                    return Err(refused(&expected));
                }
                Ok(Function::Between { at, is })
            }
            [None, None] => {
                let constant = find("constant").map(own).transpose()?.unwrap_or(0.0);
                match (number("factor")?, number("power")?, number("rate")?) {
                    (Some(factor), Some(power), None) => Ok(Function::Power { constant, factor, power }),
                    (Some(factor), None, Some(rate)) => Ok(Function::Exponential { constant, factor, rate }),
                    _ => Err(refused("`at` and `is`, or `factor` with `power` or `rate`")),
                }
            }
            _ => Err(refused("`at` and `is`, and nothing beside them")),
        }
    }

    /// Fits a law to values.
    pub(super) fn fitted(&self, named: &RandomEntry, quantity: &Quantity) -> ReadResult<Fit> {
        let find = |name: &str| named.parameters.iter().find(|parameter| parameter.name == name);
        let lacks = |needed: &'static str| {
            let name = named.name.clone();
            (RandomProblem::Lacks { law: "fitted", name, needed }, named.span.clone())
        };
        let law = find("law").ok_or_else(|| lacks("`law`, the name of the law that is fitted"))?;
        let values = find("values").ok_or_else(|| lacks("`values`, a list"))?;
        let family =
            Family::ALL.into_iter().find(|family| law.value == Written::Text(family.name().to_owned()));
        let family = family.ok_or_else(|| lacks("`law`, the name of the law that is fitted"))?;
        let origin = match find("location") {
            Some(location) if family.has_origin() => self.value(named, quantity, location)?,
            Some(location) => {
                let message =
                    format!("`location` of `{}`: the law {} has none to be given", named.name, family.name());
                return Err((RandomProblem::Other(message), location.span.clone()));
            }
            None if matches!(family, Family::Pareto | Family::Exponential) => {
                return Err(lacks("`location`, the threshold above which the values lie"));
            }
            None => 0.0,
        };
        let numbers = numbers(values, &|one| self.value(named, quantity, one))?;
        Fit::of(family, &numbers, origin).map_err(|error| {
            let message =
                format!("{} cannot be fitted to the values of `{}`: {error}", family.name(), named.name);
            (RandomProblem::Other(message), values.span.clone())
        })
    }

    /// Adds the parameters of a law that was fitted to the number at a place, with their laws and how they are correlated, and gives that law.
    pub(super) fn add_parameters(
        &self,
        named: &RandomEntry,
        (place, fit): (usize, &Fit),
        (inputs, laws): (&mut Vec<RandomInput>, &mut Vec<Distribution>),
        correlations: &mut Vec<Correlation>,
    ) -> ReadResult<(usize, GivenLaw)> {
        let first = inputs.len();
        let quantity = inputs[place].quantity.clone();
        for parameter in &fit.parameters {
            let of = Box::new(quantity.clone());
            let quantity =
                Quantity::Fitted { of, parameter: parameter.name, has_dimension: parameter.has_dimension };
            let name = format!("{}.{}", named.name, parameter.name);
            inputs.push(RandomInput { name, quantity, every: Rate::Life, own: false, cut: 0.0, fit: None });
            let wrong = |error: LawError| (RandomProblem::Other(error.to_string()), named.span.clone());
            laws.push(parameter.law().map_err(wrong)?.into());
        }
        let count = fit.parameters.len();
        for i in 0..count {
            for j in 0..i {
                let measure = CorrelationMeasure::Normal(fit.correlation[i][j]);
                correlations.push(Correlation { first: first + j, second: first + i, measure });
            }
        }
        let (lower, upper) = self.bounds(named, &quantity)?;
        let [least, most] = range(&quantity).ends();
        let bounds = (lower.max(least), upper.min(most));
        let (family, origin) = (fit.family, fit.origin);
        let likeliest = laws[place].clone();
        let law = GivenLaw::new((first..first + count).collect(), move |values| {
            let law = family.law(&values[first..first + count], origin);
            within(law, bounds).unwrap_or_else(|_| likeliest.clone())
        });
        Ok((place, law))
    }
}

/// A law whose parameters are functions of one number.
struct Functions {
    make: fn(&[f64]) -> Result<Law, LawError>,
    functions: Vec<Function>,
    bounds: (f64, f64),
    /// Least and largest value that there may be.
    range: [f64; 2],
}

impl Functions {
    fn plain(&self, x: f64) -> Result<Law, LawError> {
        let parameters: Vec<f64> = self.functions.iter().map(|function| function.value(x)).collect();
        (self.make)(&parameters)
    }

    fn at(&self, x: f64) -> Result<Distribution, LawError> {
        let ((lower, upper), [least, most]) = (self.bounds, self.range);
        within(self.plain(x), (lower.max(least), upper.min(most)))
    }

    /// The shares of the law between its bounds that no body has: below the least, and above the largest.
    fn cut(&self, x: f64) -> Result<[f64; 2], LawError> {
        let asked = within(self.plain(x), self.bounds)?;
        let [least, most] = self.range;
        Ok([asked.tails(least).below, asked.tails(most).above])
    }

    /// Looks over all that the other number may be, and gives the shares that are cut of it because no body has such values. Beyond eight
    /// deviations, where nobody knows a law, it may end.
    fn checked(
        self,
        named: &RandomEntry,
        of: &str,
        other: &Distribution,
    ) -> ReadResult<(LawOfOne, [f64; 2])> {
        const STEP: f64 = 0.25;
        const LOOKED: i32 = 32;
        const FARTHEST: i32 = 48;
        let value = |step: i32| other.value(STEP * f64::from(step));
        let wrong = |x: f64, error: LawError| {
            let what = match &error {
                LawError::Parameter { parameter, value, expected, .. } => {
                    format!("`{parameter}` is {}; expected {expected}", digits(*value))
                }
                error => error.to_string(),
            };
            let (law, name) = (named.law, &named.name);
            let message = format!("the law {law} of `{name}`, where `{of}` is {}: {what}", digits(x));
            (RandomProblem::Other(message), named.span.clone())
        };
        let mut cut = [0.0; 2];
        for step in -LOOKED..=LOOKED {
            let x = value(step);
            let shares = self.at(x).and_then(|_| self.cut(x)).map_err(|error| wrong(x, error))?;
            let weight = STEP * normal::density(STEP * f64::from(step));
            cut.iter_mut().zip(shares).for_each(|(cut, share)| *cut += weight * share);
        }
        let median = other.median();
        let at_median = self.at(median).map_err(|error| wrong(median, error))?;
        let last = |side: i32| {
            let there_is = |step: &i32| self.at(value(side * step)).is_ok();
            let last = (LOOKED..=FARTHEST).take_while(there_is).last().unwrap_or(LOOKED);
            if last == FARTHEST { f64::from(side) * f64::INFINITY } else { value(side * last) }
        };
        let looked = [last(-1), last(1)];
        Ok((LawOfOne { functions: self, looked, at_median }, cut))
    }
}

/// The same where it has been looked at.
struct LawOfOne {
    functions: Functions,
    /// Least and largest value of the other number for which there is a law: beyond them it is that at the nearer.
    looked: [f64; 2],
    at_median: Distribution,
}

impl LawOfOne {
    /// The law at a value of the other number.
    fn distribution(&self, x: f64) -> Distribution {
        let [least, most] = self.looked;
        // Between values that were looked at one may have been missed; its chance is less than any answer shows.
        self.functions.at(x.clamp(least, most)).unwrap_or_else(|_| self.at_median.clone())
    }
}

/// A law between bounds.
fn within(law: Result<Law, LawError>, (lower, upper): (f64, f64)) -> Result<Distribution, LawError> {
    Distribution::truncated(law?, lower, upper)
}
