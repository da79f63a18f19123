//! Tables as columns of Arrow.

use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef, Float64Array, RecordBatch};
use arrow_cast::cast;
use arrow_cast::display::{ArrayFormatter, FormatOptions};
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};

use crate::task::{Fault, Faults, Task, Wrong};
use crate::{RowProblem, TableError, TableOptions};

/// The columns of the problem in a table of Arrow.
pub(crate) struct Inputs {
    /// Where they are.
    pub(crate) places: Vec<usize>,
    /// What the table calls them.
    pub(crate) names: Vec<String>,
    /// What is computed of the rows.
    pub(crate) task: Task,
    /// The row of the header, where the table is that of a sheet.
    pub(crate) header_row: Option<u64>,
}

impl Inputs {
    pub(crate) fn find(schema: &Schema, options: &TableOptions) -> Result<Inputs, TableError> {
        let names: Vec<String> = schema.fields().iter().map(|field| field.name().clone()).collect();
        let (task, places) = Task::of(options, &names)?;
        for &place in &places {
            let field = schema.field(place);
            if !is_readable(field.data_type()) {
                let (name, column) = (options.name.clone(), field.name().clone());
                return Err(TableError::Type { name, column, found: in_words(field.data_type()) });
            }
        }
        Ok(Inputs {
            names: places.iter().map(|&place| names[place].clone()).collect(),
            places,
            task,
            header_row: None,
        })
    }

    /// The problem's columns of a batch that has all columns of the table.
    pub(crate) fn numbers(&self, batch: &RecordBatch) -> Result<Numbers, ArrowError> {
        self.read(self.places.iter().map(|&place| batch.column(place).clone()).collect(), batch.num_rows())
    }

    /// Columns of the problem as numbers.
    pub(crate) fn read(&self, sources: Vec<ArrayRef>, rows: usize) -> Result<Numbers, ArrowError> {
        let mut faults = self.task.faults();
        let mut columns = Vec::new();
        let mut wrong: Vec<Fault> = Vec::new();
        for (place, source) in sources.iter().enumerate() {
            columns.push(floats(source, place, &self.task, &mut wrong)?);
        }
        let mut skip = Vec::new();
        if !wrong.is_empty() {
            skip.resize(rows, false);
            // The first column of a row is the one that is reported.
            wrong.sort_by_key(|fault| fault.row);
            wrong.dedup_by_key(|fault| fault.row);
            for fault in wrong {
                skip[fault.row] = true;
                faults.add(fault);
            }
        }
        Ok(Numbers { sources, columns, skip, faults })
    }

    /// What is wrong with a row.
    pub(crate) fn problem(&self, numbers: &Numbers, fault: &Fault) -> RowProblem {
        let row = fault.row;
        let is_null = |place: usize| {
            let source = &numbers.sources[place];
            source.is_null(row) || source.data_type().is_null()
        };
        if let Wrong::Value { column, expected } = fault.wrong
            && is_null(column)
        {
            return RowProblem::Null { column: self.names[column].clone(), expected };
        }
        let options = FormatOptions::default();
        let text = |place: usize| {
            let values = ArrayFormatter::try_new(&numbers.sources[place], &options);
            values.map(|values| values.value(row).to_string()).unwrap_or_default()
        };
        fault.wrong.clone().in_table(|place| (self.names[place].clone(), text(place)))
    }
}

/// Numbers of any kind, and text that may hold numbers.
fn is_readable(found: &DataType) -> bool {
    match found {
        DataType::Dictionary(_, values) => is_readable(values),
        DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View | DataType::Null => true,
        other => other.is_numeric(),
    }
}

fn in_words(found: &DataType) -> String {
    match found {
        DataType::Boolean => "true and false".to_owned(),
        DataType::Timestamp(..) => "points in time".to_owned(),
        DataType::Date32 | DataType::Date64 => "dates".to_owned(),
        DataType::List(_) | DataType::LargeList(_) | DataType::FixedSizeList(..) => "lists".to_owned(),
        DataType::Struct(_) => "structures".to_owned(),
        other => format!("values of the type {other}"),
    }
}

/// Columns of the problem as numbers.
pub(crate) struct Numbers {
    /// As they are in the table.
    sources: Vec<ArrayRef>,
    columns: Vec<Float64Array>,
    /// Rows that are not to be answered; empty if there are none.
    pub(crate) skip: Vec<bool>,
    pub(crate) faults: Faults,
}

impl Numbers {
    pub(crate) fn columns(&self) -> Vec<&[f64]> {
        self.columns.iter().map(|column| &column.values()[..]).collect()
    }
}

/// A column as numbers of the problem; what is none is a fault of its row, and null.
fn floats(
    column: &ArrayRef,
    place: usize,
    task: &Task,
    wrong: &mut Vec<Fault>,
) -> Result<Float64Array, ArrowError> {
    let is_text = match column.data_type() {
        DataType::Dictionary(_, values) => values.is_string(),
        other => other.is_string(),
    };
    let null = |row| Fault { row, wrong: Wrong::Value { column: place, expected: "a number" } };
    if !is_text {
        let numbers = cast(column, &DataType::Float64)?.as_primitive::<Float64Type>().clone();
        wrong.extend((0..numbers.len()).filter(|row| numbers.is_null(*row)).map(null));
        return Ok(numbers.unary(|number| task.value(place, number)));
    }
    let texts = cast(column, &DataType::Utf8)?;
    let texts = texts.as_string::<i32>().iter().enumerate();
    let number = |(row, text): (usize, Option<&str>)| {
        let read = text.map(|text| task.read(place, text));
        match read {
            Some(Ok(number)) => Some(number),
            Some(Err(reason)) => {
                wrong.push(Fault { row, wrong: reason });
                None
            }
            None => {
                wrong.push(null(row));
                None
            }
        }
    };
    Ok(texts.map(number).collect())
}

/// The columns of a table followed by results.
pub(crate) fn extended(schema: &Schema, results: Vec<Field>) -> SchemaRef {
    let fields = schema.fields().iter().cloned().chain(results.into_iter().map(Arc::new));
    Arc::new(Schema::new_with_metadata(fields.collect::<Vec<_>>(), schema.metadata().clone()))
}

/// A table with the values of dictionaries written out, where `unwanted` says so of their type.
pub(crate) fn without_dictionaries(schema: &Schema, unwanted: impl Fn(&DataType) -> bool) -> SchemaRef {
    let field = |field: &Arc<Field>| match field.data_type() {
        DataType::Dictionary(_, values) if unwanted(values) => {
            Arc::new(field.as_ref().clone().with_data_type((**values).clone()))
        }
        _ => field.clone(),
    };
    let fields = schema.fields().iter().map(field).collect::<Vec<_>>();
    Arc::new(Schema::new_with_metadata(fields, schema.metadata().clone()))
}

/// `batch` with the columns' types as in `schema`, and the results appended.
pub(crate) fn append(
    batch: &RecordBatch,
    results: Vec<ArrayRef>,
    schema: &SchemaRef,
) -> Result<RecordBatch, ArrowError> {
    let mut columns = Vec::with_capacity(schema.fields().len());
    for (column, field) in batch.columns().iter().zip(schema.fields()) {
        let as_it_is = column.data_type() == field.data_type();
        columns.push(if as_it_is { column.clone() } else { cast(column, field.data_type())? });
    }
    columns.extend(results);
    RecordBatch::try_new(schema.clone(), columns)
}

/// The first column that has no place in a CSV file, and what it holds.
pub(crate) fn nested(schema: &Schema) -> Option<(String, String)> {
    let nested = schema.fields().iter().find(|field| field.data_type().is_nested());
    nested.map(|field| (field.name().clone(), in_words(field.data_type())))
}

/// The names of the columns as a line of CSV, not ended.
pub(crate) fn header(schema: &Schema) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory never fails.
    let _ = writer.write_record(schema.fields().iter().map(|field| field.name()));
    let mut line = writer.into_inner().unwrap_or_default();
    line.pop();
    line
}
