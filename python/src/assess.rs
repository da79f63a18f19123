//! A case assessed: the program's answer as text, JSON and figures, each made when it is asked for.

use std::fs;
use std::path::Path;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyBool;
use standfast_cases::{
    Assessment, AssessmentView, Case, CaseFile, Document, Interface, UpToError, check_up_to,
};

use crate::errors::{StandfastError, of_case};
use crate::figure::{Figure, figures};

/// The answer to a case.
#[pyclass(frozen, module = "standfast._standfast")]
pub(crate) struct CaseAnswer {
    assessment: Assessment,
    view: AssessmentView,
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

    /// Name and words of each of its warnings.
    fn warnings(&self) -> Vec<Slip> {
        slips(&self.assessment.case)
    }

    /// The figures.
    fn figures(&self, py: Python<'_>) -> PyResult<Vec<Figure>> {
        py.detach(|| figures(&self.assessment, &self.view))
    }
}

/// Name and words of a warning.
pub(crate) type Slip = (&'static str, String);

/// The warnings of a case.
pub(crate) fn slips(case: &Case) -> Vec<Slip> {
    case.warnings().iter().map(|warning| (warning.name(), warning.to_string())).collect()
}

/// Reads the records that a case names, beside its file; those of a dict in the working directory.
pub(crate) fn beside(name: &str) -> impl Fn(&str) -> Result<String, String> {
    let folder = Path::new(name).parent().unwrap_or(Path::new("")).to_owned();
    move |file| {
        let bytes = fs::read(folder.join(file)).map_err(|cause| cause.to_string())?;
        // Old records have letters of other alphabets in their headers, and no meaning in them.
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

/// Multiple of the full load to which a rising load is followed, as Python says it.
pub(crate) fn checked_up_to(given: &Bound<'_, PyAny>) -> PyResult<f64> {
    let words = |error: UpToError| {
        format!("up_to is {}; {error}", given.repr().map_or_else(|_| "…".into(), |text| text.to_string()))
    };
    match given.extract() {
        Ok(factor) if !given.is_instance_of::<PyBool>() => {
            check_up_to(factor).map_err(|error| StandfastError::new_err(words(error)))
        }
        _ => Err(PyTypeError::new_err(words(UpToError))),
    }
}

/// The answer to the case file `text`; `name` is what errors call the case.
#[pyfunction]
pub(crate) fn assess(
    py: Python<'_>,
    name: &str,
    text: &str,
    up_to: &Bound<'_, PyAny>,
    all: bool,
) -> PyResult<CaseAnswer> {
    let up_to = checked_up_to(up_to)?;
    py.detach(|| {
        let file = CaseFile::read(name, text, &beside(name));
        let answered = file.and_then(|file| Assessment::of_file(&file));
        let assessment = answered.map_err(|error| of_case(&error))?;
        Ok(CaseAnswer { assessment, view: AssessmentView { up_to, all, interface: Interface::Python } })
    })
}
