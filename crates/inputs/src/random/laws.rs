//! Laws of random numbers, as they are written.

use standfast_probability::fit::Family;

use crate::suggest::closest;

use super::{
    Item, Parameter, RandomEntry, RandomProblem, Rate, ReadResult, Written, in_order, table, written, wrong,
};

/// The laws, by their names.
pub const LAWS: [&str; 17] = [
    "normal",
    "lognormal",
    "gumbel",
    "weibull",
    "gev",
    "uniform",
    "triangular",
    "beta",
    "gamma",
    "exponential",
    "gpd",
    "discrete",
    "sample",
    "quantiles",
    "fitted",
    "mixture",
    "max_of",
];

/// Laws that are made of others.
const COMPOUND: [&str; 2] = ["mixture", "max_of"];

/// A random number, or a table of several whose names go on.
pub(super) fn numbers(name: String, item: &Item<'_>, found: &mut Vec<RandomEntry>) -> ReadResult<()> {
    let table =
        table(item, &format!("`{name}`"), "a law in braces, as { normal = { mean = 0.6, sd = 0.1 } }")?;
    let entries = in_order(table);
    let is_law = |key: &str| LAWS.contains(&key) || ["lower", "upper", "every", "given"].contains(&key);
    if entries.iter().any(|(key, _)| is_law(key)) || entries.is_empty() {
        found.push(named(name, item)?);
        return Ok(());
    }
    let parameters = [
        "mean", "sd", "cov", "from", "to", "mode", "scale", "shape", "location", "count", "alpha", "beta",
        "values",
    ];
    let is_misspelt = |key: &str, value: &Item<'_>| match value.get_ref().as_table() {
        // A number that is said to be random by a value alone is told that it needs a law.
        None => parameters.contains(&key) || closest(key, LAWS).is_some(),
        Some(table) => {
            let has = |is: &dyn Fn(&str) -> bool| in_order(table).iter().any(|(key, _)| is(key));
            has(&|key| parameters.contains(&key)) && !has(&is_law)
        }
    };
    for (key, value) in entries {
        if is_misspelt(key, value) {
            // A law misspelt rather than a name that goes on.
            let what = format!("`{name}`");
            let allowed = LAWS.map(str::to_owned).to_vec();
            return Err((RandomProblem::Name { what, name: key.to_owned(), allowed }, value.span()));
        }
        numbers(format!("{name}.{key}"), value, found)?;
    }
    Ok(())
}

fn named(name: String, item: &Item<'_>) -> ReadResult<RandomEntry> {
    let mut named = RandomEntry::without_law(name, item.span());
    let what = format!("`{}`", named.name);
    let table = table(item, &what, "a law in braces")?;
    read_entry(
        &mut named,
        item,
        in_order(table),
        &what,
        &["lower", "upper", "every", "each", "given"],
        &LAWS,
    )?;
    Ok(named)
}

/// The law of a number, or of a part of it, and what stands beside it.
fn read_entry(
    named: &mut RandomEntry,
    item: &Item<'_>,
    entries: Vec<(&str, &Item<'_>)>,
    what: &str,
    beside: &[&str],
    known: &[&'static str],
) -> ReadResult<()> {
    let mut laws = Vec::new();
    for (key, value) in entries {
        match key {
            key if beside.contains(&key) => read_beside(named, key, value)?,
            key => match known.iter().find(|law| **law == key) {
                Some(law) => laws.push((*law, value)),
                None => {
                    let allowed = known.iter().chain(beside).map(|name| (*name).to_owned()).collect();
                    let (what, name) = (what.to_owned(), key.to_owned());
                    return Err((RandomProblem::Name { what, name, allowed }, value.span()));
                }
            },
        }
    }
    let [(law, value)] = laws[..] else {
        let found = if laws.is_empty() { "no law" } else { "several laws" };
        let found =
            if what.starts_with("`max_of`") { format!("{found} in `max_of`") } else { found.to_owned() };
        return Err((RandomProblem::Laws { name: named.name.clone(), found }, item.span()));
    };
    named.law = law;
    read_law(named, value)
}

/// A bound, a rate or a probability that stands beside a law.
fn read_beside(named: &mut RandomEntry, key: &str, value: &Item<'_>) -> ReadResult<()> {
    match key {
        "lower" => named.lower = Some(parameter(key, value)?),
        "upper" => named.upper = Some(parameter(key, value)?),
        "probability" => named.share = Some(parameter(key, value)?),
        "count" => named.parameters.push(parameter(key, value)?),
        "given" => {
            let name = value.get_ref().as_str();
            let name = name.ok_or_else(|| wrong(value, "`given`", "the name of another random number"))?;
            let name = Written::Text(name.to_owned());
            named.given = Some(Parameter { name: key.to_owned(), value: name, span: value.span() });
        }
        "each" => match value.get_ref().as_str() {
            Some("body") => named.own = true,
            Some("row") => named.own = false,
            other => {
                const EXPECTED: &str = "\"body\", drawn for each body of a row, or \"row\", for all of them";
                let Some(other) = other else { return Err(wrong(value, "`each`", EXPECTED)) };
                let (what, written) = ("`each`".to_owned(), format!("\"{other}\""));
                let expected = EXPECTED.to_owned();
                return Err((RandomProblem::Value { what, written, expected }, value.span()));
            }
        },
        _ => {
            named.every = match value.get_ref().as_str() {
                Some("life") => Rate::Life,
                Some("year") => Rate::Year,
                Some("event") => Rate::Event,
                Some(other) => {
                    let (what, written) = ("`every`".to_owned(), format!("\"{other}\""));
                    let expected =
                        "\"life\", drawn once, or \"year\", drawn each year, or \"event\", drawn in each event".to_owned();
                    return Err((RandomProblem::Value { what, written, expected }, value.span()));
                }
                None => return Err(wrong(value, "`every`", "\"life\", \"year\" or \"event\"")),
            }
        }
    }
    Ok(())
}

/// The parameters of a law.
fn read_law(named: &mut RandomEntry, item: &Item<'_>) -> ReadResult<()> {
    let law = named.law;
    let what = format!("the law {law} of `{}`", named.name);
    match law {
        "sample" => {
            let values = list("values", item, &what, "its values in a list, as [4.1, 4.5, 3.9]")?;
            named.parameters.push(values);
            return Ok(());
        }
        "fitted" => return read_fitted(named, item, &what),
        "mixture" => return read_mixture(named, item, &what),
        "max_of" => return read_largest(named, item, &what),
        _ => {}
    }
    let table = table(item, &what, "its parameters in braces")?;
    let allowed: &[&str] = match law {
        "normal" => &["mean", "sd", "cov"],
        "lognormal" => &["mean", "sd", "cov", "log_mean", "log_sd"],
        "gumbel" => &["mean", "sd", "cov", "mode", "scale"],
        "weibull" => &["scale", "shape", "location"],
        "gev" | "gpd" => &["location", "scale", "shape"],
        "uniform" => &["from", "to"],
        "beta" => &["mean", "sd", "cov", "alpha", "beta", "from", "to"],
        "gamma" => &["mean", "sd", "cov", "scale", "shape", "location"],
        "exponential" => &["mean", "scale", "location"],
        "discrete" => &["values", "probabilities"],
        "quantiles" => &["values", "probabilities", "normals"],
        _ => &["from", "mode", "to"],
    };
    for (key, value) in in_order(table) {
        let returns = law == "gumbel" && years(key).is_some();
        if !allowed.contains(&key) && !returns {
            let mut allowed: Vec<String> = allowed.iter().map(|name| (*name).to_owned()).collect();
            if law == "gumbel" {
                allowed.push("two return values such as \"10 years\" and \"100 years\"".to_owned());
            }
            return Err((RandomProblem::Name { what, name: key.to_owned(), allowed }, value.span()));
        }
        let read = match law {
            _ if value.get_ref().as_table().is_some() => function(key, value, &what),
            "discrete" | "quantiles" => list(key, value, &format!("`{key}` of {what}"), "a list of numbers"),
            _ => parameter(key, value),
        };
        named.parameters.push(read?);
    }
    Ok(())
}

/// A law that is fitted to values: its family, the values, and where it begins.
fn read_fitted(named: &mut RandomEntry, item: &Item<'_>, what: &str) -> ReadResult<()> {
    for (key, value) in in_order(table(item, what, "`law` and `values` in braces")?) {
        let read = match key {
            "law" => {
                let families = Family::ALL.map(Family::name);
                let name = value.get_ref().as_str().unwrap_or_default();
                if !families.contains(&name) {
                    let (what, name) = (format!("`law` of {what}"), name.to_owned());
                    let allowed = families.map(str::to_owned).to_vec();
                    return Err((RandomProblem::Name { what, name, allowed }, value.span()));
                }
                parameter(key, value)?
            }
            "values" => {
                list(key, value, &format!("`values` of {what}"), "a list of values that were measured")?
            }
            "location" => parameter(key, value)?,
            _ => {
                let allowed = ["law", "values", "location"].map(str::to_owned).to_vec();
                let (what, name) = (what.to_owned(), key.to_owned());
                return Err((RandomProblem::Name { what, name, allowed }, value.span()));
            }
        };
        named.parameters.push(read);
    }
    Ok(())
}

/// A parameter as a function of the number on which a law depends.
fn function(name: &str, item: &Item<'_>, what: &str) -> ReadResult<Parameter> {
    let what = format!("`{name}` of {what}");
    let mut of = Vec::new();
    for (key, value) in in_order(table(item, &what, "a function in braces")?) {
        of.push(match key {
            "at" | "is" => list(key, value, &format!("`{key}` of {what}"), "a list of numbers")?,
            "constant" | "factor" | "power" | "rate" => parameter(key, value)?,
            _ => {
                let allowed = ["at", "is", "constant", "factor", "power", "rate"];
                let (name, allowed) = (key.to_owned(), allowed.map(str::to_owned).to_vec());
                return Err((RandomProblem::Name { what, name, allowed }, value.span()));
            }
        });
    }
    Ok(Parameter { name: name.to_owned(), value: Written::Function(of), span: item.span() })
}

/// The law of which the largest of several is meant: everything in the table but the count.
fn read_largest(named: &mut RandomEntry, item: &Item<'_>, what: &str) -> ReadResult<()> {
    let table = table(item, what, "its parameters in braces")?;
    let (counts, others): (Vec<_>, Vec<_>) =
        in_order(table).into_iter().partition(|(key, _)| *key == "count");
    for (key, value) in counts {
        read_beside(named, key, value)?;
    }
    let mut inner = part_of(named);
    let what = format!("`max_of` of `{}`", named.name);
    let known: Vec<&'static str> =
        LAWS.into_iter().filter(|law| !["max_of", "fitted"].contains(law)).collect();
    read_entry(&mut inner, item, others, &what, &["lower", "upper"], &known)?;
    named.of.push(inner);
    Ok(())
}

/// The laws of a mixture, each with its probability.
fn read_mixture(named: &mut RandomEntry, item: &Item<'_>, what: &str) -> ReadResult<()> {
    const EXPECTED: &str =
        "a list of laws, as [{ probability = 0.9, normal = { … } }, { probability = 0.1, gumbel = { … } }]";
    let list = item.get_ref().as_array().ok_or_else(|| wrong(item, what, EXPECTED))?;
    let is_part = |law: &&'static str| !COMPOUND.contains(law) && *law != "fitted";
    let known: Vec<&'static str> = LAWS.into_iter().filter(is_part).collect();
    for entry in list.iter() {
        let table = table(entry, &format!("a part of {what}"), "a law and its probability in braces")?;
        let mut part = part_of(named);
        let what = format!("a part of the mixture of `{}`", named.name);
        read_entry(&mut part, entry, in_order(table), &what, &["probability", "lower", "upper"], &known)?;
        if part.share.is_none() {
            let (law, name) = ("mixture", named.name.clone());
            return Err((
                RandomProblem::Lacks { law, name, needed: "`probability` of each part" },
                entry.span(),
            ));
        }
        part.span = entry.span();
        named.of.push(part);
    }
    Ok(())
}

/// An entry for a law that a number's law is made of.
fn part_of(named: &RandomEntry) -> RandomEntry {
    RandomEntry { every: named.every, ..RandomEntry::without_law(named.name.clone(), named.span.clone()) }
}

/// Several numbers, each plain or with a unit.
fn list(name: &str, item: &Item<'_>, what: &str, expected: &str) -> ReadResult<Parameter> {
    let list = item.get_ref().as_array().ok_or_else(|| wrong(item, what, expected))?;
    let number = |item: &Item<'_>| {
        let expected = "a number, or a text with a number and its unit";
        written(item).ok_or_else(|| wrong(item, format!("a value of {what}"), expected))
    };
    let values = list.iter().map(number).collect::<ReadResult<Vec<Written>>>()?;
    Ok(Parameter { name: name.to_owned(), value: Written::List(values), span: item.span() })
}

pub(super) fn parameter(name: &str, item: &Item<'_>) -> ReadResult<Parameter> {
    let value = written(item);
    let value = value
        .ok_or_else(|| wrong(item, format!("`{name}`"), "a number, or a text with a number and its unit"))?;
    Ok(Parameter { name: name.to_owned(), value, span: item.span() })
}

/// The years of a return value's name, "10 years".
pub fn years(name: &str) -> Option<f64> {
    let number = name.strip_suffix("years").or_else(|| name.strip_suffix("year"))?;
    number.trim().parse().ok()
}
