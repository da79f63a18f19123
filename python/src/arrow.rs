//! Arrow in and out through the PyCapsule interface.
//!
//! Columns are read where they lie. A column with nulls is copied, with a number in place of each null; a row with a
//! null has a null result.

use std::num::NonZero;
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::{
    ArrowPrimitiveType, Float16Type, Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type,
    UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{
    Array, ArrayRef, BooleanArray, DictionaryArray, Float64Array, RecordBatch, RecordBatchReader,
    StringArray, StructArray, UInt8Array, UInt16Array,
};
use arrow_buffer::{BooleanBuffer, NullBuffer};
use arrow_schema::{DataType, Field, FieldRef, Fields, Schema, SchemaRef};
use pyo3::exceptions::{PyKeyError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyFloat, PyTuple};
use pyo3_arrow::PyChunkedArray;
use pyo3_arrow::ffi::{ArrayIterator, to_array_pycapsules, to_schema_pycapsule, to_stream_pycapsule};
use pyo3_arrow::input::{AnyArray, AnyRecordBatch};
use standfast::batch::{MOTION, OnsetColumns};
use standfast::{InputError, Mode};
use standfast_cases::suggest::{closest, similar};

use crate::grid::{self, Grid, Kind, Operand};
use crate::invalid;

/// The names of the operands.
const NAMES: [&str; 4] = ["gamma", "k_prime", "k", "mu"];

/// One operand for a stretch of rows.
enum Column {
    Constant(f64),
    Array(ArrayRef),
}

/// What went wrong at a row.
enum Failure {
    /// A value, at a row of the stretch.
    Value(usize, InputError),
    /// A column of a type that holds no real numbers.
    Type(&'static str, DataType),
}

impl Failure {
    /// As an exception; `start` rows came before the stretch.
    fn raise(self, start: usize) -> PyErr {
        match self {
            Failure::Value(row, source) => invalid(source, &[start + row]),
            Failure::Type(name, found) => not_real(name, &found),
        }
    }
}

/// The memory of an array of primitive values, all of which are numbers.
fn primitive<T: ArrowPrimitiveType>(array: &ArrayRef, kind: Kind) -> Operand {
    let pointer = array.as_primitive::<T>().values().as_ptr().cast::<u8>();
    let (shape, strides) = (vec![array.len()], vec![size_of::<T::Native>() as isize]);
    Operand { pointer, kind, shape, strides }
}

/// An array that reads as f64, with a valid number for each null.
fn without_nulls(operand: &Operand, nulls: &NullBuffer) -> ArrayRef {
    let mut values = vec![0.0; nulls.len()];
    operand.gather(0, &mut values);
    // 1 is a valid slenderness, elevation, force and friction.
    values.iter_mut().enumerate().filter(|(row, _)| nulls.is_null(*row)).for_each(|(_, value)| *value = 1.0);
    Arc::new(Float64Array::from(values))
}

fn operand(array: &ArrayRef, name: &'static str) -> Result<Operand, Failure> {
    Ok(match array.data_type() {
        DataType::Float64 => primitive::<Float64Type>(array, Kind::F64),
        DataType::Float32 => primitive::<Float32Type>(array, Kind::F32),
        DataType::Float16 => primitive::<Float16Type>(array, Kind::F16),
        DataType::Int64 => primitive::<Int64Type>(array, Kind::I64),
        DataType::Int32 => primitive::<Int32Type>(array, Kind::I32),
        DataType::Int16 => primitive::<Int16Type>(array, Kind::I16),
        DataType::Int8 => primitive::<Int8Type>(array, Kind::I8),
        DataType::UInt64 => primitive::<UInt64Type>(array, Kind::U64),
        DataType::UInt32 => primitive::<UInt32Type>(array, Kind::U32),
        DataType::UInt16 => primitive::<UInt16Type>(array, Kind::U16),
        DataType::UInt8 => primitive::<UInt8Type>(array, Kind::U8),
        other => return Err(Failure::Type(name, other.clone())),
    })
}

/// Lets `work` read four columns of `rows` rows as a grid; returns the rows that have no null.
fn on_grid(
    columns: &[Column; 4],
    rows: usize,
    work: impl FnOnce(&Grid) -> bool,
) -> Result<Option<NullBuffer>, Failure> {
    let mut kept = Vec::new();
    let mut operands = Vec::new();
    let mut nulls = None;
    for (column, name) in columns.iter().zip(NAMES) {
        let array: ArrayRef = match column {
            Column::Constant(value) => {
                let array: ArrayRef = Arc::new(Float64Array::from(vec![*value]));
                operands.push(Operand { shape: vec![1], ..operand(&array, name)? });
                kept.push(array);
                continue;
            }
            Column::Array(array) => array.clone(),
        };
        let own = operand(&array, name)?;
        match array.nulls().filter(|own| own.null_count() > 0) {
            Some(own_nulls) => {
                nulls = NullBuffer::union(nulls.as_ref(), Some(own_nulls));
                let filled = without_nulls(&own, own_nulls);
                operands.push(operand(&filled, name)?);
                kept.push(filled);
            }
            None => operands.push(own),
        }
    }
    let Ok(operands) = <[Operand; 4]>::try_from(operands) else { unreachable!("there are four columns") };
    // SAFETY: the memory belongs to arrays that `columns` and `kept` keep alive during this call.
    #[expect(unsafe_code, reason = "the grid trusts pointers and strides")]
    let grid = unsafe { Grid::new(operands) }.unwrap_or_else(|_| unreachable!("columns of one length"));
    debug_assert!(grid.len() == rows);
    if work(&grid) {
        return Ok(nulls);
    }
    match grid.first_invalid() {
        Some((row, source)) => Err(Failure::Value(row, source)),
        None => unreachable!("Arrow arrays do not change"),
    }
}

/// Mode codes of rows as they come.
#[derive(Default)]
struct Codes {
    codes: Vec<u8>,
    /// Which rows have no null, from the first null on.
    validity: Option<Vec<bool>>,
}

impl Codes {
    fn append(&mut self, columns: &[Column; 4], rows: usize, threads: usize) -> Result<(), Failure> {
        let start = self.codes.len();
        self.codes.resize(start + rows, 0);
        let codes = &mut self.codes[start..];
        let nulls = on_grid(columns, rows, |grid| grid.classify(codes, threads))?;
        match (&mut self.validity, nulls) {
            (None, None) => {}
            (Some(validity), None) => validity.resize(start + rows, true),
            (validity, Some(nulls)) => {
                let validity = validity.get_or_insert_with(|| vec![true; start]);
                validity.extend(nulls.iter());
            }
        }
        Ok(())
    }

    fn finish(self, names: bool) -> ArrowArray {
        let nulls = self.validity.map(|valid| NullBuffer::new(BooleanBuffer::from(valid)));
        let codes = UInt8Array::new(self.codes.into(), nulls);
        let array: ArrayRef = if names { dictionary_of_symbols(codes) } else { Arc::new(codes) };
        ArrowArray::new("mode", array)
    }
}

/// Mode codes with the report's symbols as their dictionary.
pub(crate) fn dictionary_of_symbols(codes: UInt8Array) -> ArrayRef {
    let symbols = StringArray::from_iter_values(Mode::ALL.into_iter().map(Mode::symbol));
    Arc::new(
        DictionaryArray::<UInt8Type>::try_new(codes, Arc::new(symbols)).expect("every code has a symbol"),
    )
}

/// The numbers of an array, and which of them are null if any is.
pub(crate) fn numbers(array: &ArrayRef, name: &str, out: &mut [f64]) -> PyResult<Option<NullBuffer>> {
    let operand = operand(array, "").map_err(|failure| match failure {
        Failure::Type(_, found) => not_real(name, &found),
        Failure::Value(row, source) => invalid(source, &[row]),
    })?;
    operand.gather(0, out);
    Ok(array.nulls().filter(|nulls| nulls.null_count() > 0).cloned())
}

fn not_real(name: &str, found: &DataType) -> PyErr {
    PyTypeError::new_err(format!(
        "{name} has the Arrow type {found}; expected a type of real numbers, as Float64"
    ))
}

/// The error for a column that a table lacks.
pub(crate) fn no_column(name: &str, column: &str, found: &[&str]) -> PyErr {
    let meant = match column == name {
        true => similar(name, found, &NAMES),
        false => closest(column, found.iter().copied()),
    };
    let advice = match meant {
        Some(meant) => format!("did you mean {meant}? Then say map={{'{name}': '{meant}'}}"),
        None => format!("name yours with map={{'{name}': …}}"),
    };
    let found = found.join(", ");
    PyKeyError::new_err(format!("the table has no column {column} for {name}; it has {found}. {advice}"))
}

/// Where in a table the column of an operand is.
pub(crate) fn place(schema: &Schema, column: &str, name: &str) -> PyResult<usize> {
    let found: Vec<&str> = schema.fields().iter().map(|field| field.name().as_str()).collect();
    let mut places = (0..found.len()).filter(|&place| found[place] == column);
    match (places.next(), places.count()) {
        (Some(place), 0) => Ok(place),
        (Some(_), others) => Err(PyValueError::new_err(format!(
            "the table has {} columns {column}; expected one for {name}",
            others + 1
        ))),
        (None, _) => Err(no_column(name, column, &found)),
    }
}

/// The fields of an onset table.
fn onset_schema() -> SchemaRef {
    let fixed = [("mode", DataType::UInt8), ("unique", DataType::Boolean), ("others", DataType::UInt16)];
    let motion = MOTION.map(|name| (name, DataType::Float64));
    let fields = fixed.into_iter().chain(motion).map(|(name, kind)| Field::new(name, kind, true));
    Arc::new(Schema::new(fields.collect::<Fields>()))
}

fn onset_batch(columns: &[Column; 4], rows: usize, threads: usize) -> Result<RecordBatch, Failure> {
    let (mut mode, mut others) = (vec![0; rows], vec![0; rows]);
    let mut motion = [(); 9].map(|()| vec![0.0; rows]);
    let nulls = on_grid(columns, rows, |grid| {
        let motion = motion.each_mut().map(Vec::as_mut_slice);
        grid.onset(OnsetColumns { mode: &mut mode, others: &mut others, motion }, threads)
    })?;
    let unique: BooleanBuffer = others.iter().map(|&others| others == 0).collect();
    let mut arrays: Vec<ArrayRef> = vec![
        Arc::new(UInt8Array::new(mode.into(), nulls.clone())),
        Arc::new(BooleanArray::new(unique, nulls.clone())),
        Arc::new(UInt16Array::new(others.into(), nulls.clone())),
    ];
    arrays.extend(motion.map(|column| Arc::new(Float64Array::new(column.into(), nulls.clone())) as ArrayRef));
    Ok(RecordBatch::try_new(onset_schema(), arrays).expect("the arrays are those of the schema"))
}

/// An operand of the form with four columns: an Arrow object or a `float`.
pub(crate) enum Given {
    Number(f64),
    Chunks(Vec<ArrayRef>),
}

impl<'py> FromPyObject<'_, 'py> for Given {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Given> {
        if let Ok(number) = given.cast::<PyFloat>() {
            return Ok(Given::Number(number.value()));
        }
        let chunks: PyChunkedArray = given.extract::<AnyArray>()?.into_chunked_array()?;
        Ok(Given::Chunks(chunks.into_inner().0))
    }
}

/// Rows in which every operand is one array or one number, and how many they are.
type Stretch = ([Column; 4], usize);

/// Cuts columns into stretches of rows.
fn stretches(given: [Given; 4]) -> PyResult<Vec<Stretch>> {
    let lengths = given.each_ref().map(|given| match given {
        Given::Number(_) => None,
        Given::Chunks(chunks) => Some(chunks.iter().map(|chunk| chunk.len()).sum::<usize>()),
    });
    let mut known = lengths.iter().flatten();
    let rows = *known.next().expect("one operand at least is an Arrow column");
    if known.any(|&length| length != rows) {
        let named =
            lengths.iter().zip(NAMES).filter_map(|(length, name)| Some(format!("{name} {}", (*length)?)));
        return Err(PyValueError::new_err(format!(
            "the columns have different lengths: {}",
            named.collect::<Vec<_>>().join(", ")
        )));
    }
    let mut rest = given.map(|given| match given {
        Given::Number(value) => (value, None),
        Given::Chunks(chunks) => {
            let mut chunks: Vec<_> = chunks.into_iter().filter(|chunk| !chunk.is_empty()).collect();
            chunks.reverse();
            (0.0, Some(chunks))
        }
    });
    let mut found = Vec::new();
    let mut done = 0;
    while done < rows {
        let chunks = rest.iter().filter_map(|(_, chunks)| chunks.as_ref()?.last());
        let length = chunks.map(|chunk| chunk.len()).min().expect("rows are left");
        let columns = rest.each_mut().map(|(value, chunks)| match chunks {
            None => Column::Constant(*value),
            Some(chunks) => {
                let chunk = chunks.pop().expect("rows are left");
                if chunk.len() > length {
                    chunks.push(chunk.slice(length, chunk.len() - length));
                }
                Column::Array(chunk.slice(0, length))
            }
        });
        found.push((columns, length));
        done += length;
    }
    Ok(found)
}

/// Where a table has an operand: in a column, or nowhere because it is the same for all rows.
#[derive(FromPyObject)]
pub(crate) enum Place {
    Column(String),
    Number(f64),
}

/// A table's batches with the columns of the operands picked out.
fn batches(
    table: AnyRecordBatch,
    places: [Place; 4],
) -> PyResult<impl Iterator<Item = PyResult<Stretch>> + Send> {
    let reader = table.into_reader()?;
    let schema = reader.schema();
    let mut picks = [Err(0.0); 4];
    for ((pick, place), name) in picks.iter_mut().zip(places).zip(NAMES) {
        *pick = match place {
            Place::Number(value) => Err(value),
            Place::Column(column) => Ok(self::place(&schema, &column, name)?),
        };
    }
    if picks.iter().all(Result::is_err) {
        return Err(PyValueError::new_err("map names no column of the table, only numbers"));
    }
    Ok(reader.map(move |batch| {
        let batch = batch.map_err(|error| PyValueError::new_err(error.to_string()))?;
        let columns = picks.map(|pick| match pick {
            Ok(column) => Column::Array(batch.column(column).clone()),
            Err(value) => Column::Constant(value),
        });
        Ok((columns, batch.num_rows()))
    }))
}

/// Runs `work` on every stretch; its failures count the rows before.
fn each(
    stretches: impl Iterator<Item = PyResult<Stretch>>,
    mut work: impl FnMut(&[Column; 4], usize) -> Result<(), Failure>,
) -> PyResult<()> {
    let mut start = 0;
    for stretch in stretches {
        let (columns, rows) = stretch?;
        if rows > 0 {
            work(&columns, rows).map_err(|failure| failure.raise(start))?;
        }
        start += rows;
    }
    Ok(())
}

fn classify(
    py: Python<'_>,
    stretches: impl Iterator<Item = PyResult<Stretch>> + Send,
    threads: Option<NonZero<usize>>,
    names: bool,
) -> PyResult<ArrowArray> {
    let threads = grid::threads(threads);
    py.detach(|| {
        let mut codes = Codes::default();
        each(stretches, |columns, rows| codes.append(columns, rows, threads))?;
        Ok(codes.finish(names))
    })
}

fn onset(
    py: Python<'_>,
    stretches: impl Iterator<Item = PyResult<Stretch>> + Send,
    threads: Option<NonZero<usize>>,
) -> PyResult<ArrowTable> {
    let threads = grid::threads(threads);
    py.detach(|| {
        let mut batches = Vec::new();
        each(stretches, |columns, rows| {
            batches.push(onset_batch(columns, rows, threads)?);
            Ok(())
        })?;
        Ok(ArrowTable { schema: onset_schema(), batches })
    })
}

/// Mode codes or symbols of Arrow columns.
#[pyfunction]
pub(crate) fn classify_columns(
    py: Python<'_>,
    columns: [Given; 4],
    threads: Option<NonZero<usize>>,
    names: bool,
) -> PyResult<ArrowArray> {
    classify(py, stretches(columns)?.into_iter().map(Ok), threads, names)
}

/// Mode codes or symbols of the rows of a table.
#[pyfunction]
pub(crate) fn classify_table(
    py: Python<'_>,
    table: AnyRecordBatch,
    places: [Place; 4],
    threads: Option<NonZero<usize>>,
    names: bool,
) -> PyResult<ArrowArray> {
    classify(py, batches(table, places)?, threads, names)
}

/// The onset of Arrow columns.
#[pyfunction]
pub(crate) fn onset_columns(
    py: Python<'_>,
    columns: [Given; 4],
    threads: Option<NonZero<usize>>,
) -> PyResult<ArrowTable> {
    onset(py, stretches(columns)?.into_iter().map(Ok), threads)
}

/// The onset of the rows of a table.
#[pyfunction]
pub(crate) fn onset_table(
    py: Python<'_>,
    table: AnyRecordBatch,
    places: [Place; 4],
    threads: Option<NonZero<usize>>,
) -> PyResult<ArrowTable> {
    onset(py, batches(table, places)?, threads)
}

/// An Arrow array for any library that speaks the PyCapsule interface.
#[pyclass(frozen, module = "standfast")]
pub(crate) struct ArrowArray {
    array: ArrayRef,
    field: FieldRef,
}

impl ArrowArray {
    pub(crate) fn new(name: &str, array: ArrayRef) -> ArrowArray {
        ArrowArray { field: Arc::new(Field::new(name, array.data_type().clone(), true)), array }
    }
}

#[pymethods]
impl ArrowArray {
    fn __len__(&self) -> usize {
        self.array.len()
    }

    fn __repr__(&self) -> String {
        let nulls = match self.array.null_count() {
            0 => String::new(),
            count => format!(", {count} null"),
        };
        format!("<standfast.ArrowArray: {} × {}{nulls}>", self.array.len(), self.array.data_type())
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

/// An Arrow table for any library that speaks the PyCapsule interface.
#[pyclass(frozen, module = "standfast")]
pub(crate) struct ArrowTable {
    schema: SchemaRef,
    batches: Vec<RecordBatch>,
}

impl From<RecordBatch> for ArrowTable {
    fn from(batch: RecordBatch) -> ArrowTable {
        ArrowTable { schema: batch.schema(), batches: vec![batch] }
    }
}

#[pymethods]
impl ArrowTable {
    fn __len__(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }

    fn __repr__(&self) -> String {
        format!("<standfast.ArrowTable: {} rows of {}>", self.__len__(), self.column_names().join(", "))
    }

    /// The names of the columns.
    #[getter]
    fn column_names(&self) -> Vec<String> {
        self.schema.fields().iter().map(|field| field.name().clone()).collect()
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
        let arrays: Vec<_> = self
            .batches
            .iter()
            .map(|batch| Ok(Arc::new(StructArray::from(batch.clone())) as ArrayRef))
            .collect();
        let reader = ArrayIterator::new(arrays, Arc::new(field));
        Ok(to_stream_pycapsule(py, Box::new(reader), requested_schema)?)
    }
}
