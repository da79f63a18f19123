//! The columns a table has to have, and where they are.

use csv::ByteRecord;

use super::{BatchError, RESULTS, lossy};
use crate::suggest::closest;

/// The columns of γ, k', k and μ.
pub(super) const NAMES: [&str; 4] = ["gamma", "k_prime", "k", "mu"];

/// What people call them otherwise.
const OTHER_NAMES: [&[&str]; 4] = [
    &["gamma", "γ", "slenderness", "h/b"],
    &["k_prime", "k'", "kprime", "kp", "elevation", "height"],
    &["k", "force", "f", "load"],
    &["mu", "μ", "friction", "friction coefficient"],
];

/// Where the four columns are.
pub(super) struct Inputs {
    pub(super) places: [usize; 4],
}

impl Inputs {
    pub(super) fn find(header: &ByteRecord, name: &str) -> Result<Inputs, BatchError> {
        if header.is_empty() {
            return Err(BatchError::Empty { name: name.to_owned() });
        }
        let found: Vec<String> = header.iter().map(|column| lossy(column).trim().to_owned()).collect();
        if let Some(column) = RESULTS.into_iter().find(|result| found.iter().any(|column| column == result)) {
            return Err(BatchError::ResultExists { name: name.to_owned(), column });
        }
        let mut places = [0; 4];
        for (i, column) in NAMES.into_iter().enumerate() {
            let mut matches =
                found.iter().enumerate().filter(|(_, found)| *found == column).map(|(place, _)| place);
            places[i] = matches.next().ok_or_else(|| BatchError::MissingColumn {
                name: name.to_owned(),
                column,
                found: found.join(", "),
                suggestion: similar(i, &found),
            })?;
            if matches.next().is_some() {
                return Err(BatchError::TwoColumns { name: name.to_owned(), column });
            }
        }
        Ok(Inputs { places })
    }
}

/// The column that is most likely meant by `NAMES[i]`.
fn similar(i: usize, found: &[String]) -> Option<String> {
    let free = || found.iter().map(String::as_str).filter(|column| !NAMES.contains(column));
    let exact = free().find(|column| OTHER_NAMES[i].contains(&column.to_lowercase().as_str()));
    exact.or_else(|| OTHER_NAMES[i].iter().find_map(|other| closest(other, free()))).map(str::to_owned)
}
