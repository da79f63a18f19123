//! Many motions under one shaking.

use std::num::NonZero;
use std::thread;

use pyo3::prelude::*;
use standfast_cases::Document;
use standfast_cases::motion::{
    Spectrum, SpectrumError, SpectrumRequest, SpectrumSteps, SpectrumValues, spectrum_csv,
};

use crate::errors::StandfastError;
use crate::figure::{Figure, figures};
use crate::simulate::{MotionCase, Samples, cases, given_base};
use crate::watch::watched;

/// Arguments of a call, as `_spectrum.py` gives them.
#[derive(FromPyObject)]
pub(crate) struct Arguments {
    kind: String,
    size: Option<Values>,
    slenderness: Option<Values>,
    ratio: Option<Values>,
    scale: Option<Values>,
    threads: Option<NonZero<usize>>,
    progress: Option<Py<PyAny>>,
}

/// Text, JSON, CSV and figures, and whether they are in SI units.
type Rendered = (String, String, String, Vec<Figure>, bool);

/// Values as they are given: a text with their ends and how many, or one by one.
#[derive(FromPyObject)]
enum Values {
    Text(String),
    These(Vec<f64>),
}

fn values(name: &str, given: Option<Values>) -> PyResult<Option<SpectrumValues>> {
    let found = match given {
        None => return Ok(None),
        Some(Values::These(values)) => {
            SpectrumValues::these(values).map_err(|wrong| format!("{name} has {wrong}"))
        }
        Some(Values::Text(text)) => text.parse::<SpectrumSteps>().map(Into::into).map_err(|_| {
            format!(
                "{name} is {text:?}; expected 'from..to' or 'from..to:how many', with 0 < from < to and two or more"
            )
        }),
    };
    found.map(Some).map_err(StandfastError::new_err)
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
        kind.map_err(|error: String| StandfastError::new_err(format!("kind is {:?}; {error}", asked.kind)))?;
    let request = SpectrumRequest {
        size: values("size", asked.size)?,
        slenderness: values("slenderness", asked.slenderness)?,
        ratio: values("ratio", asked.ratio)?,
        scale: values("scale", asked.scale)?,
        threads: asked.threads.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZero::get),
        ..SpectrumRequest::new(kind)
    };
    let refused = |error: SpectrumError| StandfastError::new_err(error.to_string());
    watched(py, asked.progress.as_ref(), move |portion| {
        let (found, _) = cases(case, &base)?;
        let case = found.into_iter().next().ok_or_else(|| refused(SpectrumError::NoShaking))?;
        let spectrum = Spectrum::of(&case, &request, portion).map_err(refused)?;
        let drawn = figures(&spectrum, &())?;
        Ok((spectrum.text(&()), spectrum.json(&(), &[]), spectrum_csv(&spectrum), drawn, spectrum.si))
    })?
}
