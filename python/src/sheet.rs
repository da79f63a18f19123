//! The calculation sheet of a case, as HTML or printed to PDF.

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use standfast_cases::key::TITLE_BLOCK;
use standfast_cases::report;
use standfast_sheet::{Date, Paper, Sheet, SheetOptions};

use crate::run::patiently;

/// The keys of the title block.
#[pyfunction]
pub(crate) fn title_block() -> Vec<&'static str> {
    TITLE_BLOCK.into_iter().map(|key| key.name()).collect()
}

/// The sheet as HTML, and as PDF on `paper` if one is named; `told` are keys of the title block with their texts.
#[pyfunction]
pub(crate) fn sheet(
    py: Python<'_>,
    file: (String, String),
    date: Option<&str>,
    up_to: f64,
    told: Vec<(String, String)>,
    paper: Option<&str>,
) -> PyResult<(String, Option<Py<PyBytes>>)> {
    let read = |date: &str| -> PyResult<Date> {
        date.parse().map_err(|error| PyValueError::new_err(format!("date is {date:?}; {error}")))
    };
    let key = |(name, text): (String, String)| {
        let key = TITLE_BLOCK.into_iter().find(|key| key.name() == name)?;
        Some((key, text))
    };
    let title_block = told.into_iter().filter_map(key).collect();
    let options = SheetOptions { title_block, date: date.map(read).transpose()?, up_to };
    let paper = paper.map(|paper| if paper == "letter" { Paper::Letter } else { Paper::A4 });
    let (html, pdf) = patiently(py, move || -> PyResult<_> {
        let sheet =
            Sheet::of(&file.0, &file.1, &options).map_err(|error| PyValueError::new_err(report(&error)))?;
        let print = |paper| sheet.pdf(paper).map_err(|error| PyRuntimeError::new_err(report(&error)));
        Ok((sheet.html().to_owned(), paper.map(print).transpose()?))
    })??;
    Ok((html, pdf.map(|bytes| PyBytes::new(py, &bytes).unbind())))
}
