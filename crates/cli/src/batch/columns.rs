//! The columns a table has to have, and where they are.

use csv::ByteRecord;

use super::problem::Column;
use super::{BatchError, Problem, lossy};
use standfast_cases::suggest::closest;

/// Where the columns of a problem are.
pub(super) struct Inputs {
    pub(super) problem: Problem,
    pub(super) places: Vec<usize>,
}

impl Inputs {
    pub(super) fn find(header: &ByteRecord, name: &str, problem: Problem) -> Result<Inputs, BatchError> {
        if header.is_empty() {
            return Err(BatchError::Empty { name: name.to_owned(), needed: problem.needed() });
        }
        let found: Vec<String> = header.iter().map(|column| lossy(column).trim().to_owned()).collect();
        let result = problem.results().iter().find(|result| found.iter().any(|column| column == *result));
        if let Some(column) = result {
            return Err(BatchError::ResultExists { name: name.to_owned(), column });
        }
        let mut places = Vec::new();
        for column in problem.columns() {
            let mut matches =
                found.iter().enumerate().filter(|(_, found)| *found == column.name).map(|(place, _)| place);
            places.push(matches.next().ok_or_else(|| BatchError::MissingColumn {
                name: name.to_owned(),
                column: column.name,
                found: found.join(", "),
                suggestion: similar(column, &found, problem),
                needed: problem.needed(),
            })?);
            if matches.next().is_some() {
                return Err(BatchError::TwoColumns { name: name.to_owned(), column: column.name });
            }
        }
        Ok(Inputs { problem, places })
    }
}

/// The column that is most likely meant.
fn similar(column: &Column, found: &[String], problem: Problem) -> Option<String> {
    let needed = |name: &str| problem.columns().iter().any(|column| column.name == name);
    let free = || found.iter().map(String::as_str).filter(|name| !needed(name));
    let exact = free().find(|name| column.other_names.contains(&name.to_lowercase().as_str()));
    exact.or_else(|| column.other_names.iter().find_map(|other| closest(other, free()))).map(str::to_owned)
}
