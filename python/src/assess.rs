//! A case assessed: the program's answer as text, JSON and figures, each made when it is asked for.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use standfast_cases::{Assessment, CaseFile, View, report};

use crate::invalid;

/// Words, suffix and SVG of a figure.
type Figure = (String, String, String);

/// The answer to a case.
#[pyclass(frozen, module = "standfast._standfast")]
pub(crate) struct CaseAnswer {
    assessment: Assessment,
    view: View,
}

#[pymethods]
impl CaseAnswer {
    /// For reading.
    fn text(&self, py: Python<'_>) -> String {
        py.detach(|| self.assessment.text(&self.view))
    }

    /// As one JSON document.
    fn json(&self, py: Python<'_>) -> String {
        py.detach(|| self.assessment.json(&self.view, &[]))
    }

    /// The figures.
    fn figures(&self, py: Python<'_>) -> PyResult<Vec<Figure>> {
        let figures = py.detach(|| self.assessment.figures(&self.view));
        let figures = figures.map_err(|error| invalid(error, &[]))?.into_iter();
        Ok(figures.map(|figure| (figure.words, figure.suffix, figure.figure.svg().to_owned())).collect())
    }
}

/// The answer to the case file `text`; `name` is what errors call the case.
#[pyfunction]
pub(crate) fn assess(py: Python<'_>, name: &str, text: &str, up_to: f64, all: bool) -> PyResult<CaseAnswer> {
    py.detach(|| {
        let file = CaseFile::parse(name, text);
        let answered =
            file.and_then(|file| Assessment::owning(file.case()?).map_err(|error| file.refused(error)));
        let assessment = answered.map_err(|error| PyValueError::new_err(report(&error)))?;
        Ok(CaseAnswer { assessment, view: View { up_to, all } })
    })
}
