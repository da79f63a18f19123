//! The calculation sheet of a case, as HTML or printed to PDF.

use pyo3::exceptions::{PyRuntimeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use standfast_cases::CaseFile;
use standfast_cases::key::TITLE_BLOCK;
use standfast_cases::report;
use standfast_sheet::{Date, Paper, Sheet, SheetError, SheetOptions};

use crate::assess::{beside, checked_up_to};
use crate::errors::{StandfastError, of_sheet};
use crate::watch::watched;

/// The keys of the title block.
#[pyfunction]
pub(crate) fn title_block() -> Vec<&'static str> {
    TITLE_BLOCK.into_iter().map(|key| key.name()).collect()
}

/// The sheet as HTML, and as PDF where `print` says so: the paper, whether it is asked for, and whether the sheet is one page; `told` are keys
/// of the title block with their texts.
#[pyfunction]
pub(crate) fn sheet(
    py: Python<'_>,
    file: (String, String),
    date: Option<&str>,
    up_to: &Bound<'_, PyAny>,
    told: Vec<(String, String)>,
    print: (String, bool, bool),
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, Option<Py<PyBytes>>)> {
    let read = |date: &str| -> PyResult<Date> {
        date.parse().map_err(|error| StandfastError::new_err(format!("date is {date:?}; {error}")))
    };
    let key = |(name, text): (String, String)| {
        let key = TITLE_BLOCK.into_iter().find(|key| key.name() == name);
        let unknown = || PyTypeError::new_err(format!("a title block has no {name}"));
        Ok((key.ok_or_else(unknown)?, text))
    };
    let title_block = told.into_iter().map(key).collect::<PyResult<_>>()?;
    let (paper, is_pdf, short) = print;
    let date = date.map(read).transpose()?;
    let options = SheetOptions { title_block, date, up_to: checked_up_to(up_to)?, short };
    let paper: Paper =
        paper.parse().map_err(|error| StandfastError::new_err(format!("paper is {paper:?}; {error}")))?;
    let (html, pdf) = watched(py, progress.as_ref(), move |portion| -> PyResult<_> {
        let file = CaseFile::read(&file.0, &file.1, &beside(&file.0)).map_err(SheetError::from);
        let sheet = file.and_then(|file| Sheet::of_file(&file, &options, portion));
        let sheet = sheet.map_err(|error| of_sheet(&error))?;
        let print = |paper| sheet.pdf(paper).map_err(|error| PyRuntimeError::new_err(report(&error)));
        Ok((sheet.html().to_owned(), is_pdf.then_some(paper).map(print).transpose()?))
    })??;
    Ok((html, pdf.map(|bytes| PyBytes::new(py, &bytes).unbind())))
}
