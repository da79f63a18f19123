//! Columns of numbers between Arrow and numpy, for the parts of the package that work on numpy arrays.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::{
    Array, ArrayRef, BooleanArray, DictionaryArray, Float64Array, Int32Array, Int64Array, RecordBatchReader,
    StringArray, UInt8Array, UInt16Array,
};
use arrow_buffer::{BooleanBuffer, NullBuffer};
use arrow_schema::ArrowError;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3_arrow::input::AnyRecordBatch;

use crate::arrow_in::{ColumnArgument, no_column, numbers, place};
use crate::arrow_out::{ArrowArray, ArrowTable};
use crate::errors::StandfastError;

/// A column's numbers, and which of them are missing if any is.
type Column<'py> = (Bound<'py, PyArray1<f64>>, Option<Bound<'py, PyArray1<bool>>>);

/// A column as it is read, chunk by chunk.
#[derive(Default)]
struct Numbers {
    values: Vec<f64>,
    missing: Vec<bool>,
}

impl Numbers {
    fn append(&mut self, chunk: &ArrayRef, name: &str) -> PyResult<()> {
        let start = self.values.len();
        self.values.resize(start + chunk.len(), 0.0);
        self.missing.resize(start + chunk.len(), false);
        numbers(chunk, name, &mut self.values[start..], &mut self.missing[start..])
    }

    fn into_numpy(self, py: Python<'_>) -> Column<'_> {
        let some = self.missing.contains(&true);
        (PyArray1::from_vec(py, self.values), some.then(|| PyArray1::from_vec(py, self.missing)))
    }
}

/// The numbers of an Arrow column; `name` is the operand's, for errors.
#[pyfunction]
pub(crate) fn read_column<'py>(py: Python<'py>, column: ColumnArgument, name: &str) -> PyResult<Column<'py>> {
    let mut read = Numbers::default();
    match column {
        ColumnArgument::Number(value) => read.values.push(value),
        ColumnArgument::Chunks(chunks) => chunks.iter().try_for_each(|chunk| read.append(chunk, name))?,
    }
    Ok(read.into_numpy(py))
}

/// The numbers of some columns of an Arrow table, as (column, operand); `names` are those of all operands.
#[pyfunction]
pub(crate) fn read_table<'py>(
    py: Python<'py>,
    table: AnyRecordBatch,
    columns: Vec<(String, String)>,
    names: Vec<String>,
) -> PyResult<Vec<Column<'py>>> {
    let reader = table.into_reader()?;
    let schema = reader.schema();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let places = columns.iter().map(|(column, name)| place(&schema, column, name, &names));
    let places = places.collect::<PyResult<Vec<usize>>>()?;
    let read = py.detach(|| {
        let mut read: Vec<Numbers> = columns.iter().map(|_| Numbers::default()).collect();
        for batch in reader {
            let batch = batch.map_err(|error| StandfastError::new_err(error.to_string()))?;
            for ((read, &place), (_, name)) in read.iter_mut().zip(&places).zip(&columns) {
                read.append(batch.column(place), name)?;
            }
        }
        PyResult::Ok(read)
    })?;
    Ok(read.into_iter().map(|read| read.into_numpy(py)).collect())
}

/// Computed values from numpy.
#[derive(FromPyObject)]
pub(crate) enum Values<'py> {
    Codes(PyReadonlyArray1<'py, u8>),
    Sets(PyReadonlyArray1<'py, u16>),
    Places(PyReadonlyArray1<'py, i64>),
    Flags(PyReadonlyArray1<'py, bool>),
    Numbers(PyReadonlyArray1<'py, f64>),
    Words(Vec<String>),
}

/// A computed column in Arrow; null where `missing` says so. With `words` the values are places in these, the dictionary of the
/// column; `metadata` is what is said of it.
#[pyfunction]
#[pyo3(signature = (name, values, missing, words, metadata=None))]
pub(crate) fn make_array(
    name: &str,
    values: Values<'_>,
    missing: Option<PyReadonlyArray1<'_, bool>>,
    words: Option<Vec<String>>,
    metadata: Option<HashMap<String, String>>,
) -> PyResult<ArrowArray> {
    let nulls = missing.as_ref().map(|missing| {
        let valid: BooleanBuffer = missing.as_array().iter().map(|missing| !missing).collect();
        NullBuffer::new(valid)
    });
    let valid = |row| nulls.as_ref().is_none_or(|nulls| nulls.is_valid(row));
    let failed = |error: ArrowError| StandfastError::new_err(error.to_string());
    let array: ArrayRef = match (values, words) {
        (Values::Codes(codes), Some(words)) => {
            // Codes under a null are to be a place all the same.
            let place = |(row, &code)| if valid(row) { code } else { 0 };
            let codes: Vec<u8> = codes.as_array().iter().enumerate().map(place).collect();
            let codes = UInt8Array::new(codes.into(), nulls);
            Arc::new(DictionaryArray::try_new(codes, Arc::new(StringArray::from(words))).map_err(failed)?)
        }
        (Values::Places(places), Some(words)) => {
            let place = |&place: &i64| i32::try_from(place).unwrap_or(-1);
            let places: Vec<i32> = places.as_array().iter().map(place).collect();
            let places = Int32Array::new(places.into(), nulls);
            Arc::new(DictionaryArray::try_new(places, Arc::new(StringArray::from(words))).map_err(failed)?)
        }
        (_, Some(_)) => return Err(PyTypeError::new_err("words go with places in them, as uint8 or int64")),
        (Values::Codes(codes), None) => Arc::new(UInt8Array::new(codes.as_array().to_vec().into(), nulls)),
        (Values::Sets(sets), None) => Arc::new(UInt16Array::new(sets.as_array().to_vec().into(), nulls)),
        (Values::Places(places), None) => Arc::new(Int64Array::new(places.as_array().to_vec().into(), nulls)),
        (Values::Flags(flags), None) => {
            Arc::new(BooleanArray::new(flags.as_array().iter().copied().collect(), nulls))
        }
        (Values::Numbers(numbers), None) => {
            Arc::new(Float64Array::new(numbers.as_array().to_vec().into(), nulls))
        }
        (Values::Words(words), None) => {
            let words = words.iter().enumerate().map(|(row, word)| valid(row).then_some(word));
            Arc::new(words.collect::<StringArray>())
        }
    };
    Ok(ArrowArray::new(name, array).with_metadata(metadata.unwrap_or_default()))
}

/// A table in Arrow, of columns of one length.
#[pyfunction]
pub(crate) fn make_table(columns: Vec<PyRef<'_, ArrowArray>>) -> PyResult<ArrowTable> {
    ArrowTable::of_columns(&columns).map_err(|error| StandfastError::new_err(error.to_string()))
}

/// Raises the error for a column that a table lacks; `names` are those of all operands.
#[pyfunction]
pub(crate) fn refuse_column(
    name: &str,
    column: &str,
    found: Vec<String>,
    names: Vec<String>,
) -> PyResult<()> {
    let [found, names] = [&found, &names].map(|texts| texts.iter().map(String::as_str).collect::<Vec<_>>());
    Err(no_column(name, column, &found, &names))
}

/// The word that is most likely meant by another, if any is.
#[pyfunction]
pub(crate) fn closest(word: &str, known: Vec<String>) -> Option<String> {
    standfast_cases::suggest::closest(word, known.iter().map(String::as_str)).map(str::to_owned)
}

/// The name that heads a column, and the unit in brackets behind it.
#[pyfunction]
pub(crate) fn heading(column: &str) -> (&str, Option<&str>) {
    standfast_cases::sweep::heading(column)
}
