//! A case over all horizontal directions.

use pyo3::prelude::*;
use standfast_cases::directions::{Directions, DirectionsError, check_step, csv};
use standfast_cases::{CaseFile, Document};

use crate::assess::{Slip, beside, slips};
use crate::errors::{StandfastError, of_case};
use crate::figure::{Figure, figures};

/// Text, JSON, CSV and figures, and the warnings.
type Rendered = (String, String, String, Vec<Figure>, Vec<Slip>);

/// The case file `text` with its loads turned; `name` is what errors call the case.
#[pyfunction]
pub(crate) fn directions(py: Python<'_>, name: &str, text: &str, step: f64) -> PyResult<Rendered> {
    let step =
        check_step(step).map_err(|error| StandfastError::new_err(format!("step is {step}; {error}")))?;
    py.detach(|| {
        let file = CaseFile::read(name, text, &beside(name)).map_err(|error| of_case(&error))?;
        let found = Directions::of_file(&file, step).map_err(|error| match error {
            DirectionsError::Case(error) => of_case(&error),
            other => StandfastError::new_err(other.to_string()),
        })?;
        let drawn = figures(&found, &())?;
        Ok((found.text(&()), found.json(&(), &[]), csv(&found), drawn, slips(&found.assessment.case)))
    })
}
