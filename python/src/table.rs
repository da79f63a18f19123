//! Tables of cases: rows that vary the numbers of a case, answered on all cores.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use arrow_array::{ArrayRef, BooleanArray, Float64Array, RecordBatch, RecordBatchReader, StringArray};
use arrow_schema::{Field, Schema};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
use pyo3_arrow::input::AnyRecordBatch;
use standfast_cases::sweep::SweepResult;
use standfast_cases::{CaseFile, Explained, Id, Key};
use standfast_tables::{
    CaseTable, Interface, Mapping, MemoryAnswer, MemoryTable, NO_NAME, NO_WORD, OnError, Progress,
    RowWarning, Summary, TableError, TableOptions, TablePlace, Values, VariedColumn,
};

use crate::arrow_out::ArrowTable;
use crate::assess::beside;
use crate::errors::{StandfastError, of_case};
use crate::watch::{Caller, Watch, aside};
use crate::{at_index, written};

/// Name of the table in errors.
const NAME: &str = "the table";

/// The column that says what is wrong with a row.
const PROBLEM: &str = "problem";

/// A table of cases, of which the columns are known.
#[pyclass(frozen, module = "standfast._standfast")]
pub(crate) struct Sweep {
    table: Arc<MemoryTable>,
    /// The rows, where they come from elsewhere.
    reader: Mutex<Option<Box<dyn RecordBatchReader + Send>>>,
}

/// The names of the columns, or a table that has them.
#[derive(FromPyObject)]
pub(crate) enum Header {
    Names(Vec<String>),
    Table(AnyRecordBatch),
}

/// A column that varies the case.
#[derive(FromPyObject)]
pub(crate) enum Column<'py> {
    /// Numbers, and where they are missing.
    Numbers(PyReadonlyArray1<'py, f64>, Option<PyReadonlyArray1<'py, bool>>),
    /// Numbers with units.
    Texts(Vec<Option<String>>),
}

#[pymethods]
impl Sweep {
    /// The case file `text`, varied by columns; `map` has keys and columns, `results` the names of what is computed, all if it is
    /// `None`; with `null`, rows that make no sense have no results.
    #[new]
    #[pyo3(signature = (name, text, given, map, results, null, threads))]
    fn new(
        name: &str,
        text: &str,
        given: Header,
        map: Vec<(String, String)>,
        results: Option<Vec<String>>,
        null: bool,
        threads: Option<NonZero<usize>>,
    ) -> PyResult<Sweep> {
        // Rows have no records of their own: of what a case names the files of codes count.
        let is_code = |id: Id| id.key == Key::CombinationCode;
        let file = CaseFile::parse(name, text).and_then(|file| file.with_some_files(&beside(name), &is_code));
        let case = file.and_then(CaseTable::of);
        let case = case.map_err(|error| of_case(&error))?;
        let case = match results {
            None => case,
            Some(names) if names.is_empty() => {
                return Err(StandfastError::new_err("columns is empty; expected the names of results"));
            }
            Some(names) if !null && names.iter().any(|name| name == PROBLEM) => {
                return Err(StandfastError::new_err(
                    "columns has 'problem', which says why a row has no results; expected on_error='null' beside it",
                ));
            }
            Some(names) => {
                // It is there wherever rows without results are.
                let names: Vec<_> = names.iter().filter(|name| *name != PROBLEM).collect();
                if names.is_empty() {
                    return Err(StandfastError::new_err(
                        "columns has 'problem' alone; expected a result beside it, as 'mode'",
                    ));
                }
                case.with_results(names.into_iter().map(|name| found(name)).collect::<PyResult<_>>()?)
            }
        };
        let options = TableOptions {
            case: Some(case.into()),
            map: map.into_iter().map(|(ours, theirs)| Mapping { ours, theirs }).collect(),
            on_error: if null { OnError::Null } else { OnError::Stop },
            interface: Interface::Python,
            // A text has its unit, as in a case; what was a number Python marks.
            plain_texts: false,
            threads: threads.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZero::get),
            ..TableOptions::new(NAME)
        };
        let (names, reader) = match given {
            Header::Names(names) => (names, None),
            Header::Table(table) => {
                let reader = table.into_reader()?;
                let fields = reader.schema().fields().clone();
                (fields.iter().map(|field| field.name().clone()).collect(), Some(reader))
            }
        };
        let table = MemoryTable::of(&names, options).map_err(|error| raised(error, &[]))?;
        Ok(Sweep { table: Arc::new(table), reader: Mutex::new(reader) })
    }

    /// The places of the columns that vary the case, in the order in which [`answer`](Sweep::answer) takes them.
    #[getter]
    fn places(&self) -> Vec<usize> {
        self.table.places().to_vec()
    }

    /// The columns that vary the case, and the keys that they vary.
    #[getter]
    fn varied(&self) -> Vec<(String, String)> {
        let columns = self.table.varied().unwrap_or_default().columns.into_iter();
        columns.map(|VariedColumn { column, key }| (column, key)).collect()
    }

    /// Keys that go with them, in sentences.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.table.varied().unwrap_or_default().notes
    }

    /// Warnings of possible slips: names and words.
    #[getter]
    fn warnings(&self) -> Vec<(&'static str, String)> {
        let warnings = self.table.varied().unwrap_or_default().warnings;
        warnings.iter().map(|warning| (warning.name(), warning.words(Some(Interface::Python)))).collect()
    }

    /// The results: names, units and words.
    #[getter]
    fn results(&self) -> Vec<(String, Option<String>, Option<String>)> {
        let said = |field: &Field, key: &str| field.metadata().get(key).cloned();
        let fields = self.table.fields().into_iter();
        fields
            .map(|field| (field.name().clone(), said(&field, "unit"), said(&field, "description")))
            .collect()
    }

    /// The results of rows in these columns, of an array of this shape, as numpy arrays: each with its name and what belongs
    /// to it; the rows that have none; and the warnings.
    fn answer<'py>(
        &self,
        py: Python<'py>,
        columns: Vec<Column<'py>>,
        shape: Vec<usize>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<AnsweredRows<'py>> {
        let arrays: Vec<ArrayRef> = columns.into_iter().map(Column::array).collect::<PyResult<_>>()?;
        let fields = arrays.iter().enumerate();
        let fields = fields.map(|(i, array)| Field::new(i.to_string(), array.data_type().clone(), true));
        let schema = Arc::new(Schema::new(fields.collect::<Vec<_>>()));
        let batch = RecordBatch::try_new(schema.clone(), arrays);
        let batch = batch.map_err(|error| StandfastError::new_err(error.to_string()))?;
        let caller = Caller { progress: progress.as_ref(), total: Some(batch.num_rows()) };
        let table = Arc::clone(&self.table);
        let answer =
            aside(py, &caller, true, move |watch| table.answer(&schema, std::iter::once(Ok(batch)), watch))?;
        let MemoryAnswer { fields, values, without, summary, .. } =
            answer.map_err(|error| raised(error, &shape))?;
        let columns = fields.iter().zip(values);
        let columns = columns.map(|(field, values)| in_numpy(py, field.name(), values));
        Ok((columns.collect::<PyResult<_>>()?, without, minded(&summary, &shape)))
    }

    /// The results of the table that was given, of `total` rows where that is known.
    fn answer_table(
        &self,
        py: Python<'_>,
        progress: Option<Py<PyAny>>,
        total: Option<usize>,
    ) -> PyResult<(ArrowTable, Vec<Warning>)> {
        let reader = self.reader.lock().unwrap_or_else(PoisonError::into_inner).take();
        let reader =
            reader.ok_or_else(|| PyTypeError::new_err("there is no table, or it has been answered"))?;
        let places = self.table.places();
        let unreadable = |error: arrow_schema::ArrowError| StandfastError::new_err(error.to_string());
        let schema = reader.schema().project(places).map_err(unreadable)?;
        let (caller, table) = (Caller { progress: progress.as_ref(), total }, Arc::clone(&self.table));
        let answer = aside(py, &caller, true, move |watch| {
            let batches = reader.map(|batch| batch?.project(table.places()));
            table.answer(&schema, batches, watch)
        })?;
        let answer = answer.map_err(|error| raised(error, &[]))?;
        let minded = minded(&answer.summary, &[]);
        let batch = answer.into_batch().map_err(unreadable)?;
        Ok((ArrowTable::new(batch.schema(), vec![batch]), minded))
    }
}

/// A warning that rows have: its name, how many they are, the first of them by its index, and what is said of that one.
type Warning = (&'static str, u64, Vec<usize>, String);

/// Columns of results, the rows that have none, and the warnings.
type AnsweredRows<'py> = (Vec<Bound<'py, PyTuple>>, Vec<u64>, Vec<Warning>);

fn minded(summary: &Summary, shape: &[usize]) -> Vec<Warning> {
    let of = |warning: &RowWarning| {
        (warning.name, warning.rows, index(warning.first, shape), warning.words.clone())
    };
    summary.minded.iter().map(of).collect()
}

/// The result of a name.
fn found(name: &str) -> PyResult<SweepResult> {
    SweepResult::find(name).ok_or_else(|| {
        let results = SweepResult::all().map(SweepResult::name).collect();
        let (option, column) = (Interface::Python.columns(), name.to_owned());
        raised(TableError::NoSuchResult { option, column, results }, &[])
    })
}

impl Column<'_> {
    fn array(self) -> PyResult<ArrayRef> {
        Ok(match self {
            Column::Numbers(numbers, None) => Arc::new(Float64Array::from(numbers.as_slice()?.to_vec())),
            Column::Numbers(numbers, Some(missing)) => {
                let present = BooleanArray::from(
                    missing.as_slice()?.iter().map(|missing| !missing).collect::<Vec<_>>(),
                );
                let nulls = present.values().clone().into();
                Arc::new(Float64Array::new(numbers.as_slice()?.to_vec().into(), Some(nulls)))
            }
            Column::Texts(texts) => Arc::new(StringArray::from(texts)),
        })
    }
}

/// A column of results in numpy: name, array, and for numbers nothing more, for truth where it is missing, for all else the words
/// of which the array has places, -1 where there is none.
fn in_numpy<'py>(py: Python<'py>, name: &str, values: Values) -> PyResult<Bound<'py, PyTuple>> {
    let words = |places: Vec<i32>, words: Vec<String>| {
        let words = PyList::new(py, words)?;
        (name, PyArray1::from_vec(py, places), words).into_pyobject(py)
    };
    match values {
        Values::Number(numbers) => (name, PyArray1::from_vec(py, numbers), py.None()).into_pyobject(py),
        Values::Flag(flags) => {
            let missing: Vec<bool> = flags.iter().map(Option::is_none).collect();
            let flags: Vec<bool> = flags.into_iter().map(Option::unwrap_or_default).collect();
            (name, PyArray1::from_vec(py, flags), PyArray1::from_vec(py, missing)).into_pyobject(py)
        }
        Values::Word(known, codes) => {
            let place = |code| if code == NO_WORD { -1 } else { i32::from(code) };
            words(codes.into_iter().map(place).collect(), known.iter().map(ToString::to_string).collect())
        }
        Values::Name(known, places) => {
            let place = |place| if place == NO_NAME { -1 } else { place as i32 };
            words(places.into_iter().map(place).collect(), known.to_vec())
        }
        Values::Modes(sets) => {
            let (places, known) = distinct(sets.into_iter().map(|set| set.map(|modes| modes.to_string())));
            words(places, known)
        }
        Values::Text(texts) => {
            let (places, known) = distinct(texts.into_iter());
            words(places, known)
        }
        _ => Err(PyTypeError::new_err(format!("{name} has no form in numpy"))),
    }
}

/// Texts by their places among those that differ.
fn distinct(texts: impl Iterator<Item = Option<String>>) -> (Vec<i32>, Vec<String>) {
    let mut known: BTreeMap<String, i32> = BTreeMap::new();
    let places = texts.map(|text| {
        text.map_or(-1, |text| {
            let next = known.len() as i32;
            *known.entry(text).or_insert(next)
        })
    });
    let places = places.collect();
    let mut words: Vec<_> = known.into_iter().collect();
    words.sort_by_key(|(_, place)| *place);
    (places, words.into_iter().map(|(text, _)| text).collect())
}

impl Progress for Watch {
    fn advance(&self, rows: u64, _: u64) {
        self.advance(rows);
    }

    fn is_stopped(&self) -> bool {
        self.is_stopped()
    }
}

/// Exception for a fault of a row or table; rows by their index in an array of this shape.
fn raised(error: TableError, shape: &[usize]) -> PyErr {
    if let TableError::Row { place: TablePlace::Row(row), problem, .. } = &error {
        let index = index(row - 1, shape);
        let words = format!("at index {}, {problem}", written(&index));
        return at_index(StandfastError::new_err(words), &index);
    }
    let help = error.help().map_or_else(String::new, |help| format!("; {help}"));
    let words = format!("{error}{help}");
    match error {
        TableError::Case(error) => of_case(&error),
        TableError::MissingColumn { .. } => PyKeyError::new_err(words),
        TableError::Type { .. } => PyTypeError::new_err(words),
        _ => StandfastError::new_err(words),
    }
}

/// The index of a row, in the order of C.
fn index(row: u64, shape: &[usize]) -> Vec<usize> {
    let mut rest = row as usize;
    if shape.len() <= 1 {
        return vec![rest];
    }
    let mut places = Vec::new();
    for &length in shape.iter().rev() {
        places.push(rest % length.max(1));
        rest /= length.max(1);
    }
    places.reverse();
    places
}
