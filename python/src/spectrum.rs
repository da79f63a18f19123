//! Many motions under one shaking.

use std::num::NonZero;
use std::thread;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use standfast_cases::Document;
use standfast_cases::motion::{
    Progressed, Spectrum, SpectrumError, SpectrumRequest, SpectrumSteps, spectrum_csv,
};

use crate::errors::StandfastError;
use crate::figures;
use crate::simulate::{MotionCase, Samples, cases, given_base};
use crate::watch::{Caller, aside};

/// Arguments of a call, as `_spectrum.py` gives them.
#[derive(FromPyObject)]
pub(crate) struct Arguments {
    kind: String,
    size: Option<String>,
    slenderness: Option<String>,
    ratio: Option<String>,
    scale: Option<String>,
    threads: Option<NonZero<usize>>,
    progress: Option<Py<PyAny>>,
}

/// Text, JSON, CSV and SVG, and whether they are in SI units.
type Rendered = (String, String, String, String, bool);

/// A range that is given by its ends and how many values.
fn steps(name: &str, given: Option<String>) -> PyResult<Option<SpectrumSteps>> {
    let Some(text) = given else { return Ok(None) };
    let wrong = |_| {
        PyValueError::new_err(format!(
            "{name} is {text:?}; expected 'from..to' or 'from..to:how many', with 0 < from < to and two or more"
        ))
    };
    text.parse().map(Some).map_err(wrong)
}

/// The spectrum of a case.
#[pyfunction]
pub(crate) fn spectrum(
    py: Python<'_>,
    case: MotionCase,
    base: (Option<Samples<'_>>, Option<Samples<'_>>),
    asked: Arguments,
) -> PyResult<Rendered> {
    let base = given_base(base)?;
    let kind = asked.kind.parse();
    let kind =
        kind.map_err(|error: String| PyValueError::new_err(format!("kind is {:?}; {error}", asked.kind)))?;
    let request = SpectrumRequest {
        size: steps("size", asked.size)?,
        slenderness: steps("slenderness", asked.slenderness)?,
        ratio: steps("ratio", asked.ratio)?,
        scale: steps("scale", asked.scale)?,
        threads: asked.threads.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZero::get),
        ..SpectrumRequest::new(kind)
    };
    let refused = |error: SpectrumError| StandfastError::new_err(error.to_string());
    aside(py, &Caller { progress: asked.progress.as_ref(), total: None }, false, move |watch| {
        let (found, _) = cases(case, &base)?;
        let case = found.into_iter().next().ok_or_else(|| refused(SpectrumError::NoShaking))?;
        let done = |progressed| {
            if progressed == Progressed::Done {
                watch.advance(1);
            }
        };
        let spectrum = Spectrum::of(&case, &request, &done).map_err(refused)?;
        let svg = figures(&spectrum, &())?.pop().map_or_else(String::new, |(_, _, svg)| svg);
        Ok((spectrum.text(&()), spectrum.json(&(), &[]), spectrum_csv(&spectrum), svg, spectrum.si))
    })?
}
