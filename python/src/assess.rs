//! A case assessed: the program's answer as text, JSON and figures.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use standfast_cases::{Assessment, CaseFile, View, report};

use crate::invalid;

/// Words, suffix and SVG of a figure.
type Figure = (String, String, String);

/// The answer to the case file `text` as text, as JSON, and its figures; `name` is what errors call the case.
#[pyfunction]
pub(crate) fn assess(
    py: Python<'_>,
    name: &str,
    text: &str,
    up_to: f64,
    all: bool,
) -> PyResult<(String, String, Vec<Figure>)> {
    py.detach(|| {
        let answered = CaseFile::parse(name, text)
            .and_then(|file| Assessment::of(&file.case()?).map_err(|error| file.refused(error)));
        let assessment = answered.map_err(|error| PyValueError::new_err(report(&error)))?;
        let view = View { up_to, all };
        let figures = assessment.figures(&view).map_err(|error| invalid(error, &[]))?;
        let figures = figures
            .into_iter()
            .map(|figure| (figure.words, figure.suffix, figure.figure.svg().to_owned()))
            .collect();
        Ok((assessment.text(&view), assessment.json(&view, &[]), figures))
    })
}
