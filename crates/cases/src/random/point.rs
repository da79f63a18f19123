//! A point of the report's plane in place of a body: `[point]` with γ, k', k and μ.
//!
//! ```toml
//! [point]
//! gamma = 0.8
//! k_prime = 0.9167
//! k = 0.45
//! mu = 0.6
//!
//! [random]
//! mu = { normal = { mean = 0.6, sd = 0.1 } }
//! ```
//!
//! A number that is random by a law with a mean of its own need not stand in `[point]`.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::RANDOM;
use super::quantity::Coordinate;
use super::read::{Random, RandomProblem, read};
use crate::error::CaseError;
use crate::parse::{plain_number, type_of};

/// The four numbers and what is random of them, if the text is of a point; none if it is of a case.
pub(super) fn read_file(
    name: &str,
    text: &str,
    top: &DeTable<'_>,
) -> Result<Option<([f64; 4], Random)>, CaseError> {
    let Some(point) = top.get("point") else { return Ok(None) };
    let wrong = |(problem, span): (RandomProblem, _)| CaseError::new(name, text, problem.into(), vec![span]);
    let allowed = ["title", "note", "point", RANDOM];
    if let Some((key, _)) = top.iter().find(|(key, _)| !allowed.contains(&key.get_ref().as_ref())) {
        let (what, name) = ("a file with a [point]".to_owned(), key.get_ref().to_string());
        let allowed = allowed.map(str::to_owned).to_vec();
        return Err(wrong((RandomProblem::Name { what, name, allowed }, key.span())));
    }
    let random = match top.get(RANDOM) {
        Some(value) => read(value).map_err(wrong)?,
        None => return Err(wrong((RandomProblem::Nothing, point.span()))),
    };
    let values = values(point, &random).map_err(wrong)?;
    Ok(Some((values, random)))
}

fn values(point: &Spanned<DeValue<'_>>, random: &Random) -> super::read::At<[f64; 4]> {
    let what = || "[point]".to_owned();
    let Some(table) = point.get_ref().as_table() else {
        let (found, expected) = (type_of(point.get_ref()), "a table".to_owned());
        return Err((RandomProblem::Type { what: what(), found, expected }, point.span()));
    };
    let names = Coordinate::ALL.map(Coordinate::name);
    if let Some((key, _)) = table.iter().find(|(key, _)| !names.contains(&key.get_ref().as_ref())) {
        let (name, allowed) = (key.get_ref().to_string(), names.map(str::to_owned).to_vec());
        return Err((RandomProblem::Name { what: what(), name, allowed }, key.span()));
    }
    if let Some(named) = random.named.iter().find(|named| !names.contains(&named.name.as_str())) {
        let (what, name) = ("[random] of a [point]".to_owned(), named.name.clone());
        let allowed = names.map(str::to_owned).to_vec();
        return Err((RandomProblem::Name { what, name, allowed }, named.span.clone()));
    }
    let mut values = [0.0; 4];
    for coordinate in Coordinate::ALL {
        let name = coordinate.name();
        let is_random = random.named.iter().any(|named| named.name == name);
        values[coordinate as usize] = match table.get(name) {
            // Its law says what it is.
            None if is_random => 1.0,
            None => {
                let message = format!("[point] lacks `{name}`, which is not random either");
                return Err((RandomProblem::Other(message), point.span()));
            }
            Some(item) => match plain_number(item.get_ref()) {
                Some(value) if coordinate.range().contains(value) => value,
                Some(value) => {
                    let (what, expected) = (format!("`{name}`"), coordinate.range().words().to_owned());
                    return Err((
                        RandomProblem::Value { what, written: value.to_string(), expected },
                        item.span(),
                    ));
                }
                None => {
                    let (found, expected) =
                        (type_of(item.get_ref()), "a number without unit or quotes".to_owned());
                    return Err((
                        RandomProblem::Type { what: format!("`{name}`"), found, expected },
                        item.span(),
                    ));
                }
            },
        };
    }
    Ok(values)
}
