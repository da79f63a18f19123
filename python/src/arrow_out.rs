//! Answers as arrays and tables of Arrow, given through the PyCapsule interface. What else they can do is the Python beside
//! this, in `_arrow.py`.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::{ArrowPrimitiveType, Float64Type, Int64Type, UInt8Type, UInt16Type};
use arrow_array::{Array, ArrayRef, DictionaryArray, RecordBatch, StringArray, StructArray, UInt8Array};
use arrow_cast::cast;
use arrow_schema::{ArrowError, DataType, Field, FieldRef, Schema, SchemaRef};
use arrow_select::concat::concat;
use numpy::{Element, PyArray1};
use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyTuple};
use pyo3_arrow::ffi::{ArrayIterator, to_array_pycapsules, to_schema_pycapsule, to_stream_pycapsule};
use standfast::{Mode, Verdict};

use crate::errors::StandfastError;

/// An array of Arrow.
#[pyclass(frozen, module = "standfast._standfast")]
pub(crate) struct ArrowArray {
    array: ArrayRef,
    field: FieldRef,
}

/// Codes of modes as the report's symbols, encoded by a dictionary.
pub(crate) fn dictionary_of_symbols(codes: UInt8Array) -> ArrayRef {
    let symbols = Mode::ALL.map(Mode::symbol).into_iter().chain([Verdict::BearingFailure.symbol()]);
    let symbols = StringArray::from_iter_values(symbols);
    Arc::new(DictionaryArray::<UInt8Type>::new(codes, Arc::new(symbols)))
}

impl ArrowArray {
    pub(crate) fn new(name: &str, array: ArrayRef) -> ArrowArray {
        ArrowArray { field: Arc::new(Field::new(name, array.data_type().clone(), true)), array }
    }

    /// Adds metadata to the array.
    pub(crate) fn with_metadata(self, metadata: HashMap<String, String>) -> ArrowArray {
        ArrowArray { field: Arc::new(self.field.as_ref().clone().with_metadata(metadata)), ..self }
    }
}

/// The values of an array as numpy has them; in the place of texts the places in a list of them.
type Parts<'py> = (Bound<'py, PyAny>, Option<Bound<'py, PyArray1<bool>>>, Option<Vec<String>>);

fn copied<'py, T: ArrowPrimitiveType>(py: Python<'py>, array: &dyn Array) -> Bound<'py, PyAny>
where
    T::Native: Element,
{
    PyArray1::from_slice(py, array.as_primitive::<T>().values()).into_any()
}

#[pymethods]
impl ArrowArray {
    /// The values; which of them are missing, if there are such; and the words that values are the places of, for texts.
    fn parts<'py>(&self, py: Python<'py>) -> PyResult<Parts<'py>> {
        let array = &self.array;
        let failed = |error: ArrowError| PyTypeError::new_err(error.to_string());
        let texts = |array: &dyn Array| -> PyResult<Vec<String>> {
            let texts = cast(array, &DataType::Utf8).map_err(failed)?;
            Ok(texts.as_string::<i32>().iter().map(|text| text.unwrap_or_default().to_owned()).collect())
        };
        let (values, words) = match array.data_type() {
            DataType::UInt8 => (copied::<UInt8Type>(py, array), None),
            DataType::UInt16 => (copied::<UInt16Type>(py, array), None),
            DataType::Float64 => (copied::<Float64Type>(py, array), None),
            DataType::Boolean => {
                let flags: Vec<bool> = array.as_boolean().values().iter().collect();
                (PyArray1::from_vec(py, flags).into_any(), None)
            }
            kind if kind.is_integer() => {
                (copied::<Int64Type>(py, &cast(array, &DataType::Int64).map_err(failed)?), None)
            }
            kind if kind.is_floating() => {
                (copied::<Float64Type>(py, &cast(array, &DataType::Float64).map_err(failed)?), None)
            }
            DataType::Dictionary(..) => {
                let dictionary = array.as_any_dictionary();
                let words = Some(texts(dictionary.values())?);
                match dictionary.keys().data_type() {
                    DataType::UInt8 => (copied::<UInt8Type>(py, dictionary.keys()), words),
                    _ => {
                        let places = cast(dictionary.keys(), &DataType::Int64).map_err(failed)?;
                        (copied::<Int64Type>(py, &places), words)
                    }
                }
            }
            _ => {
                let places: Vec<i64> = (0..array.len() as i64).collect();
                (PyArray1::from_vec(py, places).into_any(), Some(texts(array)?))
            }
        };
        let nulls = array.logical_nulls().filter(|nulls| nulls.null_count() > 0);
        let missing = nulls
            .map(|nulls| PyArray1::from_vec(py, nulls.iter().map(|valid| !valid).collect::<Vec<bool>>()));
        Ok((values, missing, words))
    }

    /// The values from `start` on, without a copy.
    fn slice(&self, start: usize, length: usize) -> PyResult<ArrowArray> {
        if start.checked_add(length).is_none_or(|end| end > self.array.len()) {
            return Err(StandfastError::new_err("the slice reaches beyond the array"));
        }
        Ok(ArrowArray { array: self.array.slice(start, length), field: self.field.clone() })
    }

    /// Name of the array in a table.
    #[getter]
    fn name(&self) -> String {
        self.field.name().clone()
    }

    /// Arrow's name of the type of the values; that of the texts, for texts encoded by a dictionary.
    #[getter]
    fn r#type(&self) -> String {
        match self.array.data_type() {
            DataType::Utf8 => "string".to_owned(),
            DataType::Boolean => "bool".to_owned(),
            DataType::Dictionary(..) => "dictionary of strings".to_owned(),
            other => other.to_string().to_lowercase(),
        }
    }

    /// Metadata of the values: `unit` and `description`, of results of cases.
    #[getter]
    fn metadata(&self) -> HashMap<String, String> {
        self.field.metadata().clone()
    }

    /// Number of values that are null.
    #[getter]
    fn null_count(&self) -> usize {
        self.array.logical_null_count()
    }

    fn __len__(&self) -> usize {
        self.array.len()
    }

    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        Ok(to_schema_pycapsule(py, self.field.as_ref())?)
    }

    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_array__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyCapsule>>,
    ) -> PyResult<Bound<'py, PyTuple>> {
        Ok(to_array_pycapsules(py, self.field.clone(), &self.array, requested_schema)?)
    }

    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyCapsule>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        let reader = ArrayIterator::new(vec![Ok(self.array.clone())], self.field.clone());
        Ok(to_stream_pycapsule(py, Box::new(reader), requested_schema)?)
    }
}

/// A table of Arrow, in batches.
#[pyclass(frozen, module = "standfast._standfast")]
pub(crate) struct ArrowTable {
    schema: SchemaRef,
    batches: Vec<RecordBatch>,
}

impl ArrowTable {
    pub(crate) fn new(schema: SchemaRef, batches: Vec<RecordBatch>) -> ArrowTable {
        ArrowTable { schema, batches }
    }

    /// A table of columns of one length.
    pub(crate) fn of_columns(columns: &[PyRef<'_, ArrowArray>]) -> Result<ArrowTable, ArrowError> {
        let fields: Vec<FieldRef> = columns.iter().map(|column| column.field.clone()).collect();
        let arrays = columns.iter().map(|column| column.array.clone()).collect();
        let schema = Arc::new(Schema::new(fields));
        Ok(ArrowTable { schema: schema.clone(), batches: vec![RecordBatch::try_new(schema, arrays)?] })
    }
}

#[pymethods]
impl ArrowTable {
    /// A column; a copy if the table has several batches.
    fn column(&self, name: &str) -> PyResult<ArrowArray> {
        let Ok(place) = self.schema.index_of(name) else {
            let names = self.column_names().join(", ");
            return Err(PyKeyError::new_err(format!("the table has no column {name}; it has {names}")));
        };
        let field = self.schema.fields()[place].clone();
        let array = match &self.batches[..] {
            [] => arrow_array::new_empty_array(field.data_type()),
            [batch] => batch.column(place).clone(),
            batches => {
                let parts: Vec<&dyn Array> = batches.iter().map(|batch| &**batch.column(place)).collect();
                concat(&parts).map_err(|error| StandfastError::new_err(error.to_string()))?
            }
        };
        Ok(ArrowArray { array, field })
    }

    /// The rows from `start` on, without a copy.
    fn slice(&self, mut start: usize, mut length: usize) -> ArrowTable {
        let mut batches = Vec::new();
        for batch in &self.batches {
            let skipped = start.min(batch.num_rows());
            let taken = length.min(batch.num_rows() - skipped);
            (start, length) = (start - skipped, length - taken);
            if taken > 0 {
                batches.push(batch.slice(skipped, taken));
            }
        }
        ArrowTable { schema: self.schema.clone(), batches }
    }

    /// The names of the columns.
    #[getter]
    fn column_names(&self) -> Vec<String> {
        self.schema.fields().iter().map(|field| field.name().clone()).collect()
    }

    fn __len__(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }

    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        Ok(to_schema_pycapsule(py, self.schema.as_ref())?)
    }

    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyCapsule>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        let field = Field::new_struct("", self.schema.fields().clone(), false);
        let rows = |batch: &RecordBatch| Ok(Arc::new(StructArray::from(batch.clone())) as ArrayRef);
        let reader = ArrayIterator::new(self.batches.iter().map(rows).collect::<Vec<_>>(), Arc::new(field));
        Ok(to_stream_pycapsule(py, Box::new(reader), requested_schema)?)
    }
}
