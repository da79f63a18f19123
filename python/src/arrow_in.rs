//! Columns and tables of Arrow read through the PyCapsule interface.
//!
//! Columns are read where they lie; what has nulls or is to be converted, block by block. A row with a null has a null result.

use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::{
    ArrowPrimitiveType, Float16Type, Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type,
    UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{
    Array, ArrayRef, BooleanArray, Float64Array, RecordBatch, RecordBatchReader, UInt8Array, UInt16Array,
};
use arrow_buffer::{BooleanBuffer, NullBuffer, NullBufferBuilder};
use arrow_schema::{DataType, Field, Fields, Schema, SchemaRef};
use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::PyFloat;
use pyo3_arrow::PyChunkedArray;
use pyo3_arrow::input::{AnyArray, AnyRecordBatch};
use standfast::InputError;
use standfast_cases::Interface;
use standfast_cases::suggest::{closest, similar};

use crate::arrow_out::{ArrowArray, ArrowTable, dictionary_of_symbols};
use crate::errors::StandfastError;
use crate::grid::{Grid, Halt, Labour};
use crate::onset::{Choice, Column as Answers, Onset};
use crate::operand::{Kind, Operand, floats, is_number};
use crate::run::Run;
use crate::watch::Monitor;
use crate::{NAMES, expect_numbers, invalid};

/// One operand for a stretch of rows.
enum Column {
    Constant(f64),
    Array(ArrayRef),
}

/// Reason why a stretch has no answer.
enum Failure {
    /// A value, at a row of the stretch.
    Value(usize, InputError),
    /// A column of a type that holds no real numbers.
    Type(&'static str, DataType),
    /// Python raised an exception meanwhile.
    Stopped,
}

/// The memory of an array of primitive values.
fn primitive<T: ArrowPrimitiveType>(array: &ArrayRef, kind: Kind) -> Operand {
    let pointer = array.as_primitive::<T>().values().as_ptr().cast::<u8>();
    let (shape, strides) = (vec![array.len()], vec![size_of::<T::Native>() as isize]);
    let nulls = array.nulls().filter(|nulls| nulls.null_count() > 0).cloned();
    Operand { pointer, kind, shape, strides, nulls }
}

/// A column of real numbers; the type of one that holds something else.
fn operand(array: &ArrayRef) -> Result<Operand, DataType> {
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
        other if !is_number(other) => return Err(other.clone()),
        // The few values of a dictionary are converted once, and looked up block by block.
        _ => Operand::converted(match array.as_any_dictionary_opt() {
            Some(dictionary) => dictionary.with_values(floats(dictionary.values())),
            None => array.clone(),
        }),
    })
}

/// Lets `work` answer four columns of one length, as a grid and flags for rows without answer; returns which rows have one, if
/// some have none.
fn on_grid(
    columns: &[Column],
    run: &Run,
    monitor: &mut Monitor<'_>,
    work: impl FnOnce(&Grid, &mut [bool], Labour<'_, '_>) -> Result<(), Halt>,
) -> Result<Option<NullBuffer>, Failure> {
    let mut kept = Vec::new();
    let mut operands = Vec::new();
    for (column, name) in columns.iter().zip(NAMES) {
        let array = match column {
            Column::Constant(value) => Arc::new(Float64Array::from(vec![*value])) as ArrayRef,
            Column::Array(array) => array.clone(),
        };
        operands.push(operand(&array).map_err(|found| Failure::Type(name, found))?);
        kept.push(array);
    }
    // SAFETY: the memory belongs to arrays that `kept` keeps alive during this call.
    #[expect(unsafe_code, reason = "the grid trusts pointers and strides")]
    let grid = unsafe { Grid::new(operands, columns.len()) }
        .unwrap_or_else(|_| unreachable!("columns of one length"));
    let mut missing = grid.gaps(run.gaps());
    match work(&grid, &mut missing, run.labour(&mut |done| monitor.step(done))) {
        Ok(()) => {
            monitor.advance(grid.len());
            let some = missing.contains(&true);
            Ok(some.then(|| missing.into_iter().map(|missing| !missing).collect()))
        }
        Err(Halt::Stopped) => Err(Failure::Stopped),
        Err(Halt::Invalid) => match grid.first_invalid(run.gaps(), &mut |_| monitor.wait()) {
            Some((row, source)) => Err(Failure::Value(row, source)),
            None => Err(Failure::Stopped),
        },
    }
}

/// Mode codes of rows as they come.
struct Codes {
    codes: Vec<u8>,
    nulls: NullBufferBuilder,
}

impl Codes {
    fn append(
        &mut self,
        columns: &[Column],
        rows: usize,
        run: &Run,
        monitor: &mut Monitor<'_>,
    ) -> Result<(), Failure> {
        let start = self.codes.len();
        self.codes.resize(start + rows, 0);
        let codes = &mut self.codes[start..];
        match on_grid(columns, run, monitor, |grid, missing, labour| grid.classify(codes, missing, labour))? {
            Some(nulls) => self.nulls.append_buffer(&nulls),
            None => self.nulls.append_n_non_nulls(rows),
        }
        Ok(())
    }

    fn finish(mut self, names: bool) -> ArrowArray {
        let codes = UInt8Array::new(self.codes.into(), self.nulls.finish());
        ArrowArray::new("mode", if names { dictionary_of_symbols(codes) } else { Arc::new(codes) })
    }
}

/// The fields of a table of these columns of an onset.
fn onset_schema(choice: &Choice) -> SchemaRef {
    let field = |name| {
        let kind = match name {
            "mode" => DataType::UInt8,
            "unique" => DataType::Boolean,
            "others" => DataType::UInt16,
            _ => DataType::Float64,
        };
        Field::new(name, kind, true)
    };
    Arc::new(Schema::new(choice.names().map(field).collect::<Fields>()))
}

fn onset_batch(
    columns: &[Column],
    rows: usize,
    choice: &Choice,
    run: &Run,
    monitor: &mut Monitor<'_>,
) -> Result<RecordBatch, Failure> {
    let mut found = Onset::new(choice, rows);
    let nulls =
        on_grid(columns, run, monitor, |grid, missing, labour| grid.onset(found.columns(), missing, labour))?;
    let array = |column| -> ArrayRef {
        let nulls = nulls.clone();
        match column {
            Answers::Mode(codes) => Arc::new(UInt8Array::new(codes.into(), nulls)),
            Answers::Unique(unique) => Arc::new(BooleanArray::new(BooleanBuffer::from(unique), nulls)),
            Answers::Others(others) => Arc::new(UInt16Array::new(others.into(), nulls)),
            Answers::Motion(numbers) => Arc::new(Float64Array::new(numbers.into(), nulls)),
        }
    };
    let arrays = found.in_order(choice).map(array).collect();
    Ok(RecordBatch::try_new(onset_schema(choice), arrays).expect("the arrays are those of the schema"))
}

/// An operand of the form with four columns: an Arrow object or a `float`.
pub(crate) enum ColumnArgument {
    Number(f64),
    Chunks(Vec<ArrayRef>),
}

impl<'py> FromPyObject<'_, 'py> for ColumnArgument {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<ColumnArgument> {
        if let Ok(number) = given.cast::<PyFloat>() {
            return Ok(ColumnArgument::Number(number.value()));
        }
        let chunks: PyChunkedArray = given.extract::<AnyArray>()?.into_chunked_array()?;
        Ok(ColumnArgument::Chunks(chunks.into_inner().0))
    }
}

/// Rows in which every operand is one array or one number, and how many they are.
type Stretch = (Vec<Column>, usize);

/// Cuts columns into stretches of rows; and how many rows they have together.
fn stretches(given: Vec<ColumnArgument>) -> PyResult<(Vec<Stretch>, usize)> {
    expect_numbers(given.len())?;
    let length = |given: &ColumnArgument| match given {
        ColumnArgument::Number(_) => None,
        ColumnArgument::Chunks(chunks) => Some(chunks.iter().map(|chunk| chunk.len()).sum::<usize>()),
    };
    let lengths: Vec<Option<usize>> = given.iter().map(length).collect();
    let mut known = lengths.iter().flatten();
    let rows = *known.next().expect("one operand at least is an Arrow column");
    if known.any(|&length| length != rows) {
        let named =
            lengths.iter().zip(NAMES).filter_map(|(length, name)| Some(format!("{name} {}", (*length)?)));
        return Err(StandfastError::new_err(format!(
            "the columns have different lengths: {}",
            named.collect::<Vec<_>>().join(", ")
        )));
    }
    let apart = |given| match given {
        ColumnArgument::Number(value) => (value, None),
        ColumnArgument::Chunks(chunks) => {
            let mut chunks: Vec<_> = chunks.into_iter().filter(|chunk| !chunk.is_empty()).collect();
            chunks.reverse();
            (0.0, Some(chunks))
        }
    };
    let mut rest: Vec<(f64, Option<Vec<ArrayRef>>)> = given.into_iter().map(apart).collect();
    let mut found = Vec::new();
    let mut done = 0;
    while done < rows {
        let chunks = rest.iter().filter_map(|(_, chunks)| chunks.as_ref()?.last());
        let length = chunks.map(|chunk| chunk.len()).min().expect("rows are left");
        let columns = rest.iter_mut().map(|(value, chunks)| match chunks {
            None => Column::Constant(*value),
            Some(chunks) => {
                let chunk = chunks.pop().expect("rows are left");
                if chunk.len() > length {
                    chunks.push(chunk.slice(length, chunk.len() - length));
                }
                Column::Array(chunk.slice(0, length))
            }
        });
        found.push((columns.collect(), length));
        done += length;
    }
    Ok((found, rows))
}

/// Source of an operand: a column of the table, or a number that is the same for all rows.
#[derive(FromPyObject)]
pub(crate) enum Place {
    Column(String),
    Number(f64),
}

fn not_real(name: &str, found: &DataType) -> PyErr {
    PyTypeError::new_err(format!(
        "{name} has the Arrow type {found}; expected a type of real numbers, as Float64"
    ))
}

/// Writes the numbers of an array, and marks those that are null, in place of which 1 is written.
pub(crate) fn numbers(array: &ArrayRef, name: &str, out: &mut [f64], missing: &mut [bool]) -> PyResult<()> {
    let operand = operand(array).map_err(|found| not_real(name, &found))?;
    operand.gather_marked(0, out, missing);
    Ok(())
}

/// The error for a column that a table lacks; `names` are those of all operands, none of which is meant by another.
pub(crate) fn no_column(name: &str, column: &str, found: &[&str], names: &[&str]) -> PyErr {
    let meant = match column == name {
        true => similar(name, found, names),
        false => closest(column, found.iter().copied()),
    };
    let advice = match meant {
        Some(meant) => format!("did you mean {meant}? Then say {}", Interface::Python.map(name, meant)),
        None => format!("name yours with map={{\"{name}\": …}}"),
    };
    let has = if found.is_empty() { "no columns".to_owned() } else { found.join(", ") };
    PyKeyError::new_err(format!("the table has no column {column} for {name}; it has {has}. {advice}"))
}

/// Place in a table of the column of an operand; `names` are those of all operands.
pub(crate) fn place(schema: &Schema, column: &str, name: &str, names: &[&str]) -> PyResult<usize> {
    let found: Vec<&str> = schema.fields().iter().map(|field| field.name().as_str()).collect();
    let mut places = (0..found.len()).filter(|&place| found[place] == column);
    match (places.next(), places.count()) {
        (Some(place), 0) => Ok(place),
        (Some(_), others) => Err(StandfastError::new_err(format!(
            "the table has {} columns {column}; expected one for {name}",
            others + 1
        ))),
        (None, _) => Err(no_column(name, column, &found, names)),
    }
}

/// A table's batches with the columns of the operands picked out.
fn batches(
    table: AnyRecordBatch,
    places: Vec<Place>,
) -> PyResult<impl Iterator<Item = PyResult<Stretch>> + Send> {
    let reader = table.into_reader()?;
    let schema = reader.schema();
    expect_numbers(places.len())?;
    let names = &NAMES[..places.len()];
    let mut picks = Vec::new();
    for (at, name) in places.into_iter().zip(names) {
        picks.push(match at {
            Place::Number(value) => Err(value),
            Place::Column(column) => Ok(place(&schema, &column, name, names)?),
        });
    }
    if picks.iter().all(Result::is_err) {
        return Err(StandfastError::new_err("map names no column of the table, only numbers"));
    }
    Ok(reader.map(move |batch| {
        let batch = batch.map_err(|error| StandfastError::new_err(error.to_string()))?;
        let columns = picks.iter().map(|pick| match *pick {
            Ok(column) => Column::Array(batch.column(column).clone()),
            Err(value) => Column::Constant(value),
        });
        Ok((columns.collect(), batch.num_rows()))
    }))
}

/// Runs `work` on every stretch; its failures count the rows before.
fn each(
    py: Python<'_>,
    stretches: impl Iterator<Item = PyResult<Stretch>> + Send,
    run: &Run,
    total: Option<usize>,
    mut work: impl FnMut(&[Column], usize, &mut Monitor<'_>) -> Result<(), Failure> + Send,
) -> PyResult<()> {
    let mut monitor = run.monitor(total);
    py.detach(|| {
        let mut start = 0;
        for stretch in stretches {
            let (columns, rows) = stretch?;
            if rows > 0 {
                work(&columns, rows, &mut monitor).map_err(|failure| match failure {
                    Failure::Value(row, source) => invalid(source, &[start + row]),
                    Failure::Type(name, found) => not_real(name, &found),
                    Failure::Stopped => monitor.raised().unwrap_or_else(|| {
                        StandfastError::new_err("the columns changed while they were read")
                    }),
                })?;
            }
            start += rows;
        }
        Ok::<_, PyErr>(())
    })?;
    monitor.finish(py)
}

fn classify(
    py: Python<'_>,
    stretches: impl Iterator<Item = PyResult<Stretch>> + Send,
    names: bool,
    run: &Run,
    total: Option<usize>,
) -> PyResult<ArrowArray> {
    let mut codes = Codes { codes: Vec::new(), nulls: NullBufferBuilder::new(0) };
    each(py, stretches, run, total, |columns, rows, monitor| codes.append(columns, rows, run, monitor))?;
    Ok(codes.finish(names))
}

fn onset(
    py: Python<'_>,
    stretches: impl Iterator<Item = PyResult<Stretch>> + Send,
    choice: &Choice,
    run: &Run,
    total: Option<usize>,
) -> PyResult<ArrowTable> {
    let mut batches = Vec::new();
    each(py, stretches, run, total, |columns, rows, monitor| {
        batches.push(onset_batch(columns, rows, choice, run, monitor)?);
        Ok(())
    })?;
    Ok(ArrowTable::new(onset_schema(choice), batches))
}

/// Mode codes or symbols of Arrow columns.
#[pyfunction]
pub(crate) fn classify_columns(
    py: Python<'_>,
    columns: Vec<ColumnArgument>,
    names: bool,
    run: Run,
) -> PyResult<ArrowArray> {
    let (stretches, rows) = stretches(columns)?;
    classify(py, stretches.into_iter().map(Ok), names, &run, Some(rows))
}

/// Mode codes or symbols of the rows of a table.
#[pyfunction]
pub(crate) fn classify_table(
    py: Python<'_>,
    table: AnyRecordBatch,
    places: Vec<Place>,
    names: bool,
    run: Run,
) -> PyResult<ArrowArray> {
    classify(py, batches(table, places)?, names, &run, None)
}

/// Onset of Arrow columns: the results chosen.
#[pyfunction]
pub(crate) fn onset_columns(
    py: Python<'_>,
    columns: Vec<ColumnArgument>,
    choice: Choice,
    run: Run,
) -> PyResult<ArrowTable> {
    let (stretches, rows) = stretches(columns)?;
    onset(py, stretches.into_iter().map(Ok), &choice, &run, Some(rows))
}

/// Onset of the rows of a table: the results chosen.
#[pyfunction]
pub(crate) fn onset_table(
    py: Python<'_>,
    table: AnyRecordBatch,
    places: Vec<Place>,
    choice: Choice,
    run: Run,
) -> PyResult<ArrowTable> {
    onset(py, batches(table, places)?, &choice, &run, None)
}
