//! Laws of random numbers, from what is written to the law itself, in SI units of the number.

use standfast_probability::law::{Distribution, Law, LawError};
use standfast_probability::normal;

use super::{Names, Resolve};
use crate::digits::digits;
use crate::key::Range;
use crate::random::quantity::Quantity;
use standfast_inputs::random::{Parameter, RandomEntry, RandomProblem, ReadResult, Written, years};

impl Resolve<'_> {
    /// The law of a random number, and what was cut of it because no body has such values.
    pub(super) fn law(&self, named: &RandomEntry, quantity: &Quantity) -> ReadResult<(Distribution, f64)> {
        let law = self.plain_law(named, quantity)?;
        self.cut(named, quantity, law)
    }

    /// A law between its bounds, and what was cut of it because no body has such values.
    pub(super) fn cut(
        &self,
        named: &RandomEntry,
        quantity: &Quantity,
        law: Law,
    ) -> ReadResult<(Distribution, f64)> {
        let (lower, upper) = self.bounds(named, quantity)?;
        let refused = |error: LawError| empty_range(named, lower, upper, &error);
        let [least, most] = range(quantity).ends();
        let asked = Distribution::truncated(law.clone(), lower, upper).map_err(refused)?;
        if lower >= least && upper <= most {
            return Ok((asked, 0.0));
        }
        let cut = [asked.tails(least).below, asked.tails(most).above];
        let share: f64 = cut.iter().sum();
        if share > MOST_CUT {
            return Err((unphysical(named, quantity, share, cut[1] == 0.0), named.span.clone()));
        }
        let whole = Distribution::truncated(law, lower.max(least), upper.min(most)).map_err(refused)?;
        Ok((whole, share))
    }

    /// Bounds at which a law is cut, without bound where nothing is said.
    pub(super) fn bounds(&self, named: &RandomEntry, quantity: &Quantity) -> ReadResult<(f64, f64)> {
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
        let both = |names: &str| {
            let message =
                format!("the law {} of `{}` has both {names}; expected one of them", named.law, named.name);
            (RandomProblem::Other(message), named.span.clone())
        };
        // The case's value, and 1 of a bias.
        let own = || -> ReadResult<f64> {
            Ok(match (quantity, self.0) {
                (Quantity::Key(variable), Names::Case(file, case, moving)) => {
                    let own = moving.filter(|_| variable.id().table.is_of_motion()).unwrap_or(file.inputs());
                    variable.value(own, case)
                }
                (Quantity::Point(coordinate), Names::Point(point)) => point[*coordinate as usize],
                (Quantity::Storm(field), Names::Storm(values)) => values[*field as usize],
                (Quantity::Own(_), _) => return Err(lacks("`mean`")),
                _ => 1.0,
            })
        };
        // Mean and deviation.
        let moments = || -> ReadResult<(f64, f64)> {
            let mean = measured("mean")?.map_or_else(own, Ok)?;
            match (measured("sd")?, plain("cov")?) {
                (Some(_), Some(_)) => Err(both("`sd` and `cov`")),
                (Some(sd), None) => Ok((mean, sd)),
                (None, Some(cov)) => Ok((mean, cov * mean.abs())),
                (None, None) => Err(lacks("`sd`, a standard deviation, or `cov`, its share of the mean")),
            }
        };
        let law = match named.law {
            "normal" => moments().map(|(mean, sd)| Law::normal(mean, sd))?,
            "lognormal" if find("log_mean").or(find("log_sd")).is_some() => {
                if find("mean").or(find("sd")).or(find("cov")).is_some() {
                    return Err(both("`log_mean` or `log_sd`, and a mean or a deviation of the values"));
                }
                Law::lognormal_of_logs(need_plain("log_mean")?, need_plain("log_sd")?)
            }
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
            "gamma" => {
                let location = measured("location")?.unwrap_or(0.0);
                match find("shape").or(find("scale")) {
                    Some(_) => Law::gamma(need("scale")?, need_plain("shape")?, location),
                    None => moments().map(|(mean, sd)| Law::gamma_of_mean(mean, sd, location))?,
                }
            }
            "beta" => {
                let (from, to) = (need("from")?, need("to")?);
                match find("alpha").or(find("beta")) {
                    Some(_) => Law::beta(need_plain("alpha")?, need_plain("beta")?, from, to),
                    None => moments().map(|(mean, sd)| Law::beta_of_mean(mean, sd, from, to))?,
                }
            }
            "exponential" => {
                let location = measured("location")?.unwrap_or(0.0);
                let scale = match (measured("mean")?, measured("scale")?) {
                    (Some(_), Some(_)) => return Err(both("`mean` and `scale`")),
                    (_, Some(scale)) => scale,
                    (mean, None) => mean.map_or_else(own, Ok)? - location,
                };
                Law::exponential(scale, location)
            }
            "gpd" => Law::pareto(need("location")?, need("scale")?, need_plain("shape")?),
            "discrete" => {
                let lists = [find("values"), find("probabilities")];
                let [Some(values), Some(probabilities)] = lists else {
                    return Err(lacks("`values` and `probabilities`, two lists"));
                };
                let probabilities = numbers(probabilities, &|parameter| self.plain(named, parameter))?;
                Law::discrete(
                    &numbers(values, &|parameter| self.value(named, quantity, parameter))?,
                    &probabilities,
                )
            }
            "quantiles" => {
                let places = [find("probabilities"), find("normals")];
                let (Some(values), [probabilities, normals]) = (find("values"), places) else {
                    return Err(lacks("`values`, and `probabilities` below them"));
                };
                let plain = |list: &Parameter| numbers(list, &|parameter| self.plain(named, parameter));
                let normals = match (probabilities, normals) {
                    (Some(_), Some(_)) => return Err(both("`probabilities` and `normals`")),
                    (None, None) => return Err(lacks("`probabilities` below its values, or `normals`")),
                    (None, Some(normals)) => plain(normals)?,
                    (Some(list), None) => {
                        let probabilities = plain(list)?;
                        if let Some(wrong) = probabilities.iter().find(|p| !(**p > 0.0 && **p < 1.0)) {
                            let what = format!("a probability of the law quantiles of `{}`", named.name);
                            let expected = "more than 0 and less than 1".to_owned();
                            let written = digits(*wrong);
                            return Err((
                                RandomProblem::Value { what, written, expected },
                                list.span.clone(),
                            ));
                        }
                        probabilities.into_iter().map(normal::quantile).collect()
                    }
                };
                Law::quantiles(
                    &normals,
                    &numbers(values, &|parameter| self.value(named, quantity, parameter))?,
                )
            }
            "sample" => {
                let values = find("values").ok_or_else(|| lacks("its values in a list"))?;
                Law::sample(&numbers(values, &|parameter| self.value(named, quantity, parameter))?)
            }
            "mixture" => {
                let part = |part: &RandomEntry| {
                    let share = part.share.as_ref().ok_or_else(|| lacks("`probability` of each part"))?;
                    Ok((self.plain(named, share)?, self.uncut(part, quantity)?))
                };
                Law::mixture(named.of.iter().map(part).collect::<ReadResult<_>>()?)
            }
            _ => {
                let inner = named.of.first().ok_or_else(|| lacks("a law of which it is the largest"))?;
                Law::max_of(self.uncut(inner, quantity)?, need_plain("count")?)
            }
        };
        law.map_err(|error| match error {
            LawError::Parameter { parameter, value, expected, .. } => {
                let at = find(parameter).map_or(named.span.clone(), |parameter| parameter.span.clone());
                let what = format!("`{parameter}` of the law {} of `{}`", named.law, named.name);
                (RandomProblem::Value { what, written: digits(value), expected: expected.to_owned() }, at)
            }
            LawError::List { fault, .. } => {
                let message = format!("the law {} of `{}`: {fault}", named.law, named.name);
                (RandomProblem::Other(message), named.span.clone())
            }
            other => (RandomProblem::Other(other.to_string()), named.span.clone()),
        })
    }

    /// A law that another is made of, between its own bounds.
    fn uncut(&self, part: &RandomEntry, quantity: &Quantity) -> ReadResult<Distribution> {
        let (law, (lower, upper)) = (self.plain_law(part, quantity)?, self.bounds(part, quantity)?);
        Distribution::truncated(law, lower, upper).map_err(|error| empty_range(part, lower, upper, &error))
    }

    /// A parameter in SI units of the random number; deviations and scales too.
    pub(super) fn value(
        &self,
        named: &RandomEntry,
        quantity: &Quantity,
        parameter: &Parameter,
    ) -> ReadResult<f64> {
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

    pub(super) fn plain(&self, named: &RandomEntry, parameter: &Parameter) -> ReadResult<f64> {
        match &parameter.value {
            Written::Number(number) if number.is_finite() => Ok(*number),
            written => {
                let written = match written {
                    Written::Text(text) => format!("\"{text}\""),
                    written => written.to_string(),
                };
                let what = format!("`{}` of `{}`", parameter.name, named.name);
                let expected = match &parameter.value {
                    Written::Number(_) => "a finite number".to_owned(),
                    Written::Function(_) => {
                        "a number; a function of another needs `given`, its name, beside the law".to_owned()
                    }
                    _ => "a number without unit or quotes".to_owned(),
                };
                Err((RandomProblem::Value { what, written, expected }, parameter.span.clone()))
            }
        }
    }
}

/// Each number of a list.
pub(super) fn numbers(
    list: &Parameter,
    number: &dyn Fn(&Parameter) -> ReadResult<f64>,
) -> ReadResult<Vec<f64>> {
    let Written::List(values) = &list.value else { return Ok(vec![number(list)?]) };
    values.iter().map(|value| number(&Parameter { value: value.clone(), ..list.clone() })).collect()
}

/// Range of the values of a random number.
pub(super) fn range(quantity: &Quantity) -> Range {
    match quantity {
        Quantity::Key(variable) => variable.range(),
        Quantity::Bias(_) => Range::NotNegative,
        Quantity::Point(coordinate) => coordinate.range(),
        Quantity::Storm(field) => field.range(),
        Quantity::Rise(_) | Quantity::Own(_) | Quantity::Fitted { .. } => Range::Finite,
    }
}

/// The largest share of a law that is cut because no body has such values.
pub(super) const MOST_CUT: f64 = 1e-3;

/// Too much of a law lies where no body has values: below all that there are, or on both sides.
pub(super) fn unphysical(
    named: &RandomEntry,
    quantity: &Quantity,
    share: f64,
    is_below: bool,
) -> RandomProblem {
    let range = range(quantity);
    let limit = match range {
        Range::NotNegative => "it is negative".to_owned(),
        _ if is_below => "it is zero or less".to_owned(),
        _ => format!("it is not {}", range.words()),
    };
    RandomProblem::Unphysical { name: named.name.clone(), share: digits(share), limit }
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
