//! Probability of each mode of a case with random numbers, and draws of these numbers.

use std::num::NonZero;

use numpy::PyArray1;
use pyo3::prelude::*;
use standfast_cases::random::{
    ChanceRequest, Draws, Effort, Happening, MethodAsked, Probability, ValueRange,
};
use standfast_cases::{CaseFile, Document};

use crate::assess::{Slip, beside};
use crate::errors::{StandfastError, of_case, of_chance};
use crate::figure::{Figure, figures};
use crate::onset::NO_MODE;
use crate::simulate::{Samples, given_base};
use crate::watch::{patiently, watched};

/// Arguments of a call, as `_probability.py` and `_reliability.py` give them.
#[derive(FromPyObject)]
pub(crate) struct Arguments {
    pub(crate) method: Option<String>,
    seed: u64,
    precision: f64,
    floor: f64,
    samples: u64,
    years: Option<f64>,
    over: Option<String>,
    follow: bool,
    threads: Option<NonZero<usize>>,
    pub(crate) progress: Option<Py<PyAny>>,
}

impl Arguments {
    /// Seed, precision, floor, points and threads.
    pub(crate) fn effort(&self) -> Effort {
        let plain = Effort::default();
        Effort {
            seed: self.seed,
            precision: self.precision,
            floor: self.floor,
            points: self.samples,
            threads: self.threads.map_or(plain.threads, NonZero::get),
        }
    }
}

/// The answer to a case with random numbers.
#[pyclass(frozen, module = "standfast._standfast")]
pub(crate) struct ChanceAnswer(Probability);

#[pymethods]
impl ChanceAnswer {
    /// For reading.
    fn text(&self) -> String {
        self.0.text(&())
    }

    /// As one JSON document.
    fn json(&self) -> String {
        self.0.json(&(), &[])
    }

    /// Name and words of each of its warnings.
    fn warnings(&self) -> Vec<Slip> {
        self.0.warnings().iter().map(|warning| (warning.name(), warning.to_string())).collect()
    }

    /// The figures.
    fn figures(&self, py: Python<'_>) -> PyResult<Vec<Figure>> {
        py.detach(|| figures(&self.0, &()))
    }
}

/// Probability of each mode; `file` is the name of the case in errors, and its text.
#[pyfunction]
pub(crate) fn probability(
    py: Python<'_>,
    file: (String, String),
    asked: Arguments,
    records: Vec<(Option<Samples<'_>>, Option<Samples<'_>>)>,
) -> PyResult<ChanceAnswer> {
    let records = records.into_iter().map(given_base).collect::<PyResult<Vec<_>>>()?;
    let method = asked.method.as_deref().map(str::parse::<MethodAsked>).transpose();
    let method = method.map_err(|error: String| StandfastError::new_err(error))?;
    let effort = asked.effort();
    let request =
        ChanceRequest { effort, years: asked.years, follow: asked.follow, ..ChanceRequest::default() };
    let request = method.map_or(request, |method| request.with(method));
    let over = asked.over.as_deref().map(str::parse::<ValueRange>).transpose();
    let over = over.map_err(|error| {
        StandfastError::new_err(format!("over is {:?}: {error}", asked.over.as_deref().unwrap_or_default()))
    })?;
    watched(py, asked.progress.as_ref(), move |portion| {
        let file = CaseFile::read(&file.0, &file.1, &beside(&file.0));
        let file = file.map_err(|error| of_case(&error))?;
        let answer = Probability::under(&file, request, over.as_ref(), &records, portion);
        answer.map(ChanceAnswer).map_err(|error| of_chance(&error))
    })?
}

/// The most points, and the precision and the floor, where none are said.
#[pyfunction]
pub(crate) fn plain_effort() -> (u64, f64, f64, u64) {
    let Effort { seed, precision, floor, points, .. } = Effort::default();
    (seed, precision, floor, points)
}

/// Names with units and values of random numbers; k and k' of the report's plane, NaN where there is no such thing; codes of modes, and
/// which draws are no body; and of bodies on joints the words that the codes then are of.
type DrawnValues<'py> = (
    Vec<(String, Option<&'static str>, Bound<'py, PyArray1<f64>>)>,
    [Bound<'py, PyArray1<f64>>; 2],
    Bound<'py, PyArray1<u8>>,
    Option<Vec<String>>,
);

/// So many draws of the random numbers of a case.
#[pyfunction]
pub(crate) fn draws(
    py: Python<'_>,
    file: (String, String),
    situation: Option<String>,
    count: u64,
    seed: u64,
) -> PyResult<DrawnValues<'_>> {
    let drawn = patiently(py, move || {
        let file = CaseFile::read(&file.0, &file.1, &beside(&file.0));
        let file = file.map_err(|error| of_case(&error))?;
        Draws::of(&file, situation.as_deref(), count, seed).map_err(|error| of_chance(&error))
    })??;
    let place = |place: usize| drawn.drawn.iter().map(move |d| d.effective.map_or(f64::NAN, |p| p[place]));
    let effective = [0, 1].map(|i| PyArray1::from_iter(py, place(i)));
    let of_joints = drawn.of_joints();
    let code = |happens: Happening| match (&of_joints, happens) {
        (Some(words), Happening::First(_) | Happening::Decided(_)) => {
            let place = words.iter().position(|word| *word == happens.name());
            place.and_then(|place| u8::try_from(place).ok()).unwrap_or(NO_MODE)
        }
        (None, Happening::Decided(verdict)) => verdict.code(),
        _ => NO_MODE,
    };
    let modes = drawn.drawn.iter().map(|d| code(d.happens));
    let modes = PyArray1::from_iter(py, modes);
    let inputs = drawn.inputs.into_iter().zip(drawn.values);
    let inputs = inputs.map(|((name, unit), values)| (name, unit, PyArray1::from_vec(py, values)));
    Ok((inputs.collect(), effective, modes, of_joints))
}
