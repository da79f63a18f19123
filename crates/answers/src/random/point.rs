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

use super::quantity::Coordinate;
use super::subject::alone;
use crate::error::{CaseError, Fault, Place};
use crate::key::Table;
use standfast_inputs::random::RandomProblem;
use standfast_model::CaseFile;

/// The four numbers, if the file is of a point; none if it is of a case.
///
/// # Errors
/// If it says what a point does not have, or lacks a number.
pub(super) fn of_file(file: &CaseFile) -> Result<Option<[f64; 4]>, CaseError> {
    let inputs = file.inputs();
    if !inputs.has(Table::Point) {
        return Ok(None);
    }
    alone(file, Table::Point, "a file with a [point]")?;
    let wrong = |problem: RandomProblem, at: Place| file.error(Fault::new(problem.into(), at));
    let random = file.random().ok_or_else(|| wrong(RandomProblem::Nothing, Table::Point.into()))?;
    let names = Coordinate::ALL.map(Coordinate::name);
    if let Some(named) = random.named.iter().find(|named| !names.contains(&named.name.as_str())) {
        let (what, name) = ("[random] of a [point]".to_owned(), named.name.clone());
        let allowed = names.map(str::to_owned).to_vec();
        return Err(file.random_error(RandomProblem::Name { what, name, allowed }, named.span.clone()));
    }
    let mut values = [0.0; 4];
    for coordinate in Coordinate::ALL {
        let name = coordinate.name();
        values[coordinate as usize] = match inputs.number(coordinate.key()) {
            Some(value) => value,
            // Its law says what it is.
            None if random.named.iter().any(|named| named.name == name) => 1.0,
            None => {
                let message = format!("[point] lacks `{name}`, which is not random either");
                return Err(wrong(RandomProblem::Other(message), Table::Point.into()));
            }
        };
    }
    Ok(Some(values))
}
