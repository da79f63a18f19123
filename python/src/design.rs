//! The least or greatest value that meets a target, and the boundary of two: the program's answer as text, JSON, CSV and picture.

use pyo3::prelude::*;
use standfast_cases::design::{
    BoundaryRequest, Cost, Design, DesignBoundary, DesignRequest, Extreme, Minimum, MinimumRequest, Spelling,
    Target, boundary_csv,
};
use standfast_cases::{CaseFile, Document};

use crate::assess::{Slip, beside, slips};
use crate::errors::{StandfastError, of_case, of_design};
use crate::figure::figures;
use crate::watch::watched;

/// Names of the arguments of `standfast.design` in errors.
const SPELLING: Spelling = Spelling {
    vary: "vary",
    from: "lower",
    to: "upper",
    and: "and_",
    and_from: "and_lower",
    and_to: "and_upper",
    least: "greatest=False",
    greatest: "greatest=True",
    two: "vary=\"width\", and_=\"friction\"",
};

/// The same where ranges stand behind the names of several quantities.
const SPELLING_OF_SEVERAL: Spelling =
    Spelling { from: "the lower end in vary", to: "the upper end in vary", ..SPELLING };

/// Lower and upper end of a range, where they are given.
type Ends = [Option<String>; 2];

/// A request; `wanted` are the target, and whether the greatest value that meets it is.
fn request(
    file: &CaseFile,
    vary: String,
    (target, greatest): &(Option<String>, bool),
    [from, to]: Ends,
) -> PyResult<DesignRequest> {
    let target = target_of(file, target.as_deref())?;
    let extreme = if *greatest { Extreme::Greatest } else { Extreme::Least };
    Ok(DesignRequest { vary, target, extreme, from, to, spelling: &SPELLING })
}

/// The target of a text, or the case's own.
fn target_of(file: &CaseFile, target: Option<&str>) -> PyResult<Target> {
    match target {
        Some(target) => {
            target.parse().map_err(|error| StandfastError::new_err(format!("target is {target:?}; {error}")))
        }
        None => Target::own(file).map_err(|error| of_design(&error)),
    }
}

/// The least cost as text and as JSON, and the warnings of what it finds; of each quantity its name and, where they are given, its ends.
#[pyfunction]
pub(crate) fn minimum(
    py: Python<'_>,
    file: (String, String),
    vary: Vec<(String, String, String)>,
    target: Option<String>,
    cost: String,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, String, Vec<Slip>)> {
    let file = CaseFile::read(&file.0, &file.1, &beside(&file.0)).map_err(|error| of_case(&error))?;
    let target = target_of(&file, target.as_deref())?;
    let cost = Cost::find(&cost).ok_or_else(|| {
        StandfastError::new_err(format!("minimise is {cost:?}; expected \"volume\" or \"mass\""))
    })?;
    let (mut names, mut from, mut to) = (Vec::new(), Vec::new(), Vec::new());
    for (name, lower, upper) in vary {
        names.push(name);
        from.push(lower);
        to.push(upper);
    }
    let request = MinimumRequest { vary: names, target, cost, from, to, spelling: &SPELLING_OF_SEVERAL };
    watched(py, progress.as_ref(), move |portion| {
        let minimum = Minimum::of(&file, request, portion).map_err(|error| of_design(&error))?;
        Ok((minimum.text(&()), minimum.json(&(), &[]), slips(&minimum.answer().case)))
    })?
}

/// A design as text and as JSON, and the warnings of what it finds; `file` is what errors call the case, and its text.
#[pyfunction]
pub(crate) fn design(
    py: Python<'_>,
    file: (String, String),
    vary: String,
    wanted: (Option<String>, bool),
    ends: Ends,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, String, Vec<Slip>)> {
    let file = CaseFile::read(&file.0, &file.1, &beside(&file.0)).map_err(|error| of_case(&error))?;
    let request = request(&file, vary, &wanted, ends)?;
    watched(py, progress.as_ref(), move |portion| {
        let design = Design::of(&file, request, portion).map_err(|error| of_design(&error))?;
        Ok((design.text(&()), design.json(&(), &[]), slips(&design.found().answer.case)))
    })?
}

/// A boundary as text, JSON, CSV and, where there is one to draw, as SVG.
type Rendered = (String, String, String, Option<String>);

/// The boundary of a design with another quantity, `and` between `and_ends`.
#[pyfunction]
pub(crate) fn boundary(
    py: Python<'_>,
    file: (String, String),
    vary: String,
    wanted: (Option<String>, bool),
    ends: Ends,
    and_: (String, Ends),
    progress: Option<Py<PyAny>>,
) -> PyResult<Rendered> {
    let file = CaseFile::read(&file.0, &file.1, &beside(&file.0)).map_err(|error| of_case(&error))?;
    let design = request(&file, vary, &wanted, ends)?;
    watched(py, progress.as_ref(), move |portion| {
        let (and, [from, to]) = and_;
        let request = BoundaryRequest { design, and, from, to };
        let rendered = |boundary: DesignBoundary| {
            let svg = figures(&boundary, &())?.pop().map(|(_, _, svg, _)| svg);
            Ok((boundary.text(&()), boundary.json(&(), &[]), boundary_csv(&boundary), svg))
        };
        DesignBoundary::of(&file, request, portion).map_err(|error| of_design(&error)).and_then(rendered)
    })?
}
