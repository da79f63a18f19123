//! Columns of numbers between Arrow and numpy, for the parts of the package that work on numpy arrays.

use std::sync::Arc;

use arrow_array::{
    Array, ArrayRef, BooleanArray, Float64Array, RecordBatch, RecordBatchReader, StringArray, UInt8Array,
    UInt16Array,
};
use arrow_buffer::{BooleanBuffer, NullBuffer};
use arrow_schema::{Field, Fields, Schema};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3_arrow::input::AnyRecordBatch;

use crate::arrow::{ArrowArray, ArrowTable, Given, dictionary_of_symbols, no_column, numbers};

/// A column's numbers, and which of them are missing if any is.
type Column<'py> = (Bound<'py, PyArray1<f64>>, Option<Bound<'py, PyArray1<bool>>>);

/// A column as it is read, chunk by chunk.
#[derive(Default)]
struct Numbers {
    values: Vec<f64>,
    /// From the first null on.
    missing: Option<Vec<bool>>,
}

impl Numbers {
    fn append(&mut self, chunk: &ArrayRef, name: &str) -> PyResult<()> {
        let start = self.values.len();
        self.values.resize(start + chunk.len(), 0.0);
        let nulls = numbers(chunk, name, &mut self.values[start..])?;
        match (&mut self.missing, nulls) {
            (None, None) => {}
            (Some(missing), None) => missing.resize(start + chunk.len(), false),
            (missing, Some(nulls)) => {
                let missing = missing.get_or_insert_with(|| vec![false; start]);
                missing.extend(nulls.iter().map(|valid| !valid));
            }
        }
        Ok(())
    }

    fn into_numpy(self, py: Python<'_>) -> Column<'_> {
        (PyArray1::from_vec(py, self.values), self.missing.map(|missing| PyArray1::from_vec(py, missing)))
    }
}

/// The numbers of an Arrow column; `name` is the operand's, for errors.
#[pyfunction]
pub(crate) fn read_column<'py>(py: Python<'py>, column: Given, name: &str) -> PyResult<Column<'py>> {
    let mut read = Numbers::default();
    match column {
        Given::Number(value) => read.values.push(value),
        Given::Chunks(chunks) => chunks.iter().try_for_each(|chunk| read.append(chunk, name))?,
    }
    Ok(read.into_numpy(py))
}

/// The numbers of some columns of an Arrow table, as (column, operand).
#[pyfunction]
pub(crate) fn read_table<'py>(
    py: Python<'py>,
    table: AnyRecordBatch,
    columns: Vec<(String, String)>,
) -> PyResult<Vec<Column<'py>>> {
    let reader = table.into_reader()?;
    let schema = reader.schema();
    let places = columns.iter().map(|(column, name)| crate::arrow::place(&schema, column, name));
    let places = places.collect::<PyResult<Vec<usize>>>()?;
    let read = py.detach(|| {
        let mut read: Vec<Numbers> = columns.iter().map(|_| Numbers::default()).collect();
        for batch in reader {
            let batch = batch.map_err(|error| PyValueError::new_err(error.to_string()))?;
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
    Flags(PyReadonlyArray1<'py, bool>),
    Numbers(PyReadonlyArray1<'py, f64>),
    Words(Vec<String>),
}

/// What is missing.
type Missing<'py> = Option<PyReadonlyArray1<'py, bool>>;

fn array(values: &Values<'_>, missing: &Missing<'_>, symbols: bool) -> PyResult<ArrayRef> {
    let nulls = missing.as_ref().map(|missing| {
        let valid: BooleanBuffer = missing.as_array().iter().map(|missing| !missing).collect();
        NullBuffer::new(valid)
    });
    Ok(match values {
        Values::Codes(codes) => {
            let codes = UInt8Array::new(codes.as_array().to_vec().into(), nulls);
            if symbols { dictionary_of_symbols(codes) } else { Arc::new(codes) }
        }
        Values::Sets(sets) => Arc::new(UInt16Array::new(sets.as_array().to_vec().into(), nulls)),
        Values::Flags(flags) => {
            Arc::new(BooleanArray::new(flags.as_array().iter().copied().collect(), nulls))
        }
        Values::Numbers(numbers) => Arc::new(Float64Array::new(numbers.as_array().to_vec().into(), nulls)),
        Values::Words(words) => {
            let valid = |row| nulls.as_ref().is_none_or(|nulls| nulls.is_valid(row));
            let words = words.iter().enumerate().map(|(row, word)| valid(row).then_some(word));
            Arc::new(words.collect::<StringArray>())
        }
    })
}

/// A computed column in Arrow; with `symbols` codes become the report's symbols.
#[pyfunction]
pub(crate) fn make_array(
    name: &str,
    values: Values<'_>,
    missing: Missing<'_>,
    symbols: bool,
) -> PyResult<ArrowArray> {
    Ok(ArrowArray::new(name, array(&values, &missing, symbols)?))
}

/// Computed columns in Arrow.
#[pyfunction]
pub(crate) fn make_table(columns: Vec<(String, Values<'_>, Missing<'_>)>) -> PyResult<ArrowTable> {
    let arrays = columns.iter().map(|(_, values, missing)| array(values, missing, false));
    let arrays = arrays.collect::<PyResult<Vec<ArrayRef>>>()?;
    let named = columns.iter().zip(&arrays);
    let fields = named.map(|((name, ..), array)| Field::new(name, array.data_type().clone(), true));
    let schema = Arc::new(Schema::new(fields.collect::<Fields>()));
    let batch =
        RecordBatch::try_new(schema, arrays).map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok(ArrowTable::from(batch))
}

/// Raises the error for a column that a table lacks.
#[pyfunction]
pub(crate) fn refuse_column(name: &str, column: &str, found: Vec<String>) -> PyResult<()> {
    Err(no_column(name, column, &found.iter().map(String::as_str).collect::<Vec<_>>()))
}
