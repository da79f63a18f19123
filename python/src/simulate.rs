//! The motion in time of a case: the program's answer as text and JSON, and its series.

use std::collections::BTreeMap;
use std::fs;
use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use standfast::Mode;
use standfast_cases::motion::{
    BlockCase, CopiesOptions, Factors, Follow, FollowedMotion, GivenBase, MotionView, Record, RecordUnit,
    STATE_AT, SeriesAsked, SeriesColumn, SeriesRow, Spread, StrengthAsked,
};
use standfast_cases::{CaseFile, Document, Interface};

use crate::assess::Slip;
use crate::errors::{StandfastError, of_case};
use crate::figure::{Figure, figures};
use crate::watch::{patiently, watched};

/// The motion of a case in each of its situations, the worst first.
#[pyclass(frozen, module = "standfast._standfast")]
pub(crate) struct MotionAnswer {
    answers: Vec<FollowedMotion>,
    files: BTreeMap<String, String>,
    all: bool,
}

/// A record: its times, its values and their unit.
pub(crate) type Samples<'py> = (PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>, Option<String>);

/// Columns at even steps of time: name, unit and words of each, its numbers, not a number where there is none; the place of the state among them, and codes
/// of modes.
type Series<'py> = (Vec<SeriesOf<'py>>, usize, Bound<'py, PyArray1<u8>>);
type SeriesOf<'py> = (String, &'static str, &'static str, Bound<'py, PyArray1<f64>>);

#[pymethods]
impl MotionAnswer {
    /// For reading.
    fn text(&self) -> String {
        self.answers.text(&MotionView { all: self.all, interface: Interface::Python })
    }

    /// As one JSON document.
    fn json(&self) -> String {
        self.answers.json(&MotionView::default(), &[])
    }

    /// True if quantities are in SI units; those of a block are in the units of its case.
    fn is_si(&self) -> bool {
        self.answers.iter().all(|followed| followed.case.si)
    }

    /// Name and words of each warning of the worst situation.
    fn warnings(&self) -> Vec<Slip> {
        let worst = self.answers.first();
        let warnings = worst.into_iter().flat_map(|worst| &worst.warnings);
        warnings.map(|warning| (warning.name, warning.words.clone())).collect()
    }

    /// The contents of the files that the case names.
    fn files(&self) -> BTreeMap<String, String> {
        self.files.clone()
    }

    /// Words, suffix and SVG of each figure of the worst situation.
    fn figures(&self, py: Python<'_>) -> PyResult<Vec<Figure>> {
        let worst = [self.whole(py, 0)?];
        py.detach(|| figures(&worst[..], &MotionView::default()))
    }

    /// The motion in one of the situations, every `dt` until it ends, and on both sides of events if they are asked for.
    fn series<'py>(&self, py: Python<'py>, place: usize, dt: f64, events: bool) -> PyResult<Series<'py>> {
        let FollowedMotion { case, outcome, .. } = self.whole(py, place)?;
        let count = (outcome.t_final / dt + 1e-9).floor();
        if count >= 1e9 {
            return Err(StandfastError::new_err(format!("{count:e} steps; expected a longer dt")));
        }
        let asked = SeriesAsked { dt, events };
        let rows: Vec<SeriesRow> = asked.rows(&case, &outcome).collect();
        let numbers = |column: &SeriesColumn| {
            let values = rows.iter().map(|row| column.value(row).unwrap_or(f64::NAN)).collect();
            (column.name.to_string(), column.unit, column.words, PyArray1::from_vec(py, values))
        };
        let states = rows.iter().map(|row| Mode::code(row.moment.state)).collect();
        Ok((asked.columns(&case).iter().map(numbers).collect(), STATE_AT, PyArray1::from_vec(py, states)))
    }
}

impl MotionAnswer {
    /// The whole motion in one of the situations. It is followed again, because the whole of it takes far more memory than what
    /// came of it.
    fn whole(&self, py: Python<'_>, place: usize) -> PyResult<FollowedMotion> {
        let Some(followed) = self.answers.get(place) else {
            return Err(PyIndexError::new_err(format!("{place} of {} situations", self.answers.len())));
        };
        // Copies have been followed, and what is asked of them is answered.
        let case = BlockCase { copies: None, criteria: Vec::new(), ..followed.case.clone() };
        patiently(py, move || {
            let followed = FollowedMotion::of(case, &Follow { series: true, ..Follow::default() });
            followed.map_err(|error| StandfastError::new_err(error.to_string()))
        })?
    }
}

/// Name of a case in errors and its text; the folder of the files that it names, and those that have been read.
pub(crate) type MotionCase = (String, String, String, BTreeMap<String, String>);

/// Records that are given in place of those of the base that the case names.
pub(crate) fn given_base(
    (horizontal, vertical): (Option<Samples<'_>>, Option<Samples<'_>>),
) -> PyResult<GivenBase> {
    let record = |given: Option<Samples<'_>>| -> PyResult<Option<Record>> {
        let Some((times, values, unit)) = given else { return Ok(None) };
        let (times, values) = (times.as_slice()?.to_vec(), values.as_slice()?.to_vec());
        let unit = match unit.as_deref() {
            Some("g") => RecordUnit::Gravity,
            Some("m/s2") => RecordUnit::MetrePerSecondSquared,
            Some("cm/s2") => RecordUnit::CentimetrePerSecondSquared,
            _ => RecordUnit::Unnamed,
        };
        Ok(Some(Record { times, values, unit }))
    };
    Ok(GivenBase { horizontal: record(horizontal)?, vertical: record(vertical)? })
}

/// The situations of a case, and the contents of the files that it names.
pub(crate) fn cases(
    case: MotionCase,
    base: &GivenBase,
) -> PyResult<(Vec<BlockCase>, BTreeMap<String, String>)> {
    let (file, files) = read_on(case, |_| base.clone())?;
    Ok((file.motions().map_err(|error| of_case(&error))?, files))
}

/// A case on a base of arrays, with the files that it names, and their contents.
pub(crate) fn read_on(
    (name, text, folder, files): MotionCase,
    base: impl FnOnce(&CaseFile) -> GivenBase,
) -> PyResult<(CaseFile, BTreeMap<String, String>)> {
    let known = Mutex::new(files);
    let read = |path: &str| {
        let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(text) = known.get(path) {
            return Ok(text.clone());
        }
        let bytes = fs::read(Path::new(&folder).join(path)).map_err(|cause| cause.to_string())?;
        // Old records have letters of other alphabets in their headers, and no meaning in them.
        let text = String::from_utf8_lossy(&bytes).into_owned();
        known.insert(path.to_owned(), text.clone());
        Ok(text)
    };
    let file = CaseFile::parse(&name, &text).and_then(|file| file.on_base(&base(&file)).with_files(&read));
    let file = file.map_err(|error| of_case(&error))?;
    Ok((file, known.into_inner().unwrap_or_else(PoisonError::into_inner)))
}

/// By how much numbers of copies scatter: all by one share, or each under its name.
#[derive(FromPyObject)]
pub(crate) enum SpreadGiven {
    Even(f64),
    Named(Vec<(String, f64)>),
}

/// Number, spread and seed of copies, where they are given.
pub(crate) type CopiesGiven = (Option<usize>, Option<SpreadGiven>, Option<u64>);

/// What is asked of copies.
pub(crate) fn copies_options((number, spread, seed): CopiesGiven) -> CopiesOptions {
    let spread = spread.map(|spread| match spread {
        SpreadGiven::Even(spread) => Spread::Even(spread),
        SpreadGiven::Named(named) => Spread::Named(named),
    });
    CopiesOptions { number, spread, seed }
}

/// Follows the motion of a case; `options` are whether its strength is looked for (`None`: where its records are short), and all events.
#[pyfunction]
pub(crate) fn simulate(
    py: Python<'_>,
    case: MotionCase,
    base: (Option<Samples<'_>>, Option<Samples<'_>>),
    options: (Option<bool>, bool),
    copies: CopiesGiven,
    progress: Option<Py<PyAny>>,
) -> PyResult<MotionAnswer> {
    let base = given_base(base)?;
    let (strength, all) = options;
    let copies = copies_options(copies);
    let strength = match strength {
        None => StrengthAsked::IfShort(Factors::Rungs),
        Some(true) => StrengthAsked::Always(Factors::Rungs),
        Some(false) => StrengthAsked::No,
    };
    watched(py, progress.as_ref(), move |portion| {
        let (mut cases, files) = cases(case, &base)?;
        for case in &mut cases {
            copies.put(case).map_err(|option| {
                StandfastError::new_err(format!(
                    "{option} is of copies, and none are followed; expected copies"
                ))
            })?;
        }
        let threads = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
        let answers = FollowedMotion::of_all(
            cases,
            &Follow { divergence: true, strength, series: false, threads },
            portion,
        );
        let answers = answers.map_err(|error| StandfastError::new_err(error.to_string()))?;
        Ok(MotionAnswer { answers, files, all })
    })?
}
