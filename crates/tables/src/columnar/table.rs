//! Tables as columns of Arrow.

use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef, Float64Array, RecordBatch};
use arrow_cast::cast;
use arrow_cast::display::{ArrayFormatter, FormatOptions};
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};

use crate::answers::{Fault, Faults};
use crate::text::number;
use crate::{RowProblem, TableError, TableOptions};

/// The columns of the problem in a table of Arrow.
pub(crate) struct Inputs {
    /// Where they are.
    pub(crate) places: Vec<usize>,
    /// What the table calls them.
    pub(crate) names: Vec<String>,
}

impl Inputs {
    pub(crate) fn find(schema: &Schema, options: &TableOptions) -> Result<Inputs, TableError> {
        let names: Vec<String> = schema.fields().iter().map(|field| field.name().clone()).collect();
        let places = options.places(&names)?;
        for &place in &places {
            let field = schema.field(place);
            if !is_readable(field.data_type()) {
                let (name, column) = (options.name.clone(), field.name().clone());
                return Err(TableError::Type { name, column, found: in_words(field.data_type()) });
            }
        }
        Ok(Inputs { names: places.iter().map(|&place| names[place].clone()).collect(), places })
    }

    /// The problem's columns of a batch that has all columns of the table.
    pub(crate) fn numbers(&self, batch: &RecordBatch) -> Result<Numbers, ArrowError> {
        Numbers::read(
            self.places.iter().map(|&place| batch.column(place).clone()).collect(),
            batch.num_rows(),
        )
    }

    /// What is wrong with a row.
    pub(crate) fn problem(&self, numbers: &Numbers, fault: Fault) -> RowProblem {
        let Fault { row, column: place, expected } = fault;
        let column = self.names[place].clone();
        let source = &numbers.sources[place];
        if source.is_null(row) || source.data_type().is_null() {
            return RowProblem::Null { column, expected };
        }
        let options = FormatOptions::default();
        let value = ArrayFormatter::try_new(source, &options).map(|values| values.value(row).to_string());
        RowProblem::Value { column, value: value.unwrap_or_default(), expected }
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
    pub(crate) fn read(sources: Vec<ArrayRef>, rows: usize) -> Result<Numbers, ArrowError> {
        let columns = sources.iter().map(floats).collect::<Result<Vec<_>, _>>()?;
        let mut skip = Vec::new();
        let mut faults = Faults::default();
        if columns.iter().any(|column| column.null_count() > 0) {
            skip.resize(rows, false);
            for (row, skip) in skip.iter_mut().enumerate() {
                if let Some(column) = columns.iter().position(|column| column.is_null(row)) {
                    *skip = true;
                    faults.add(Fault { row, column, expected: "a number" });
                }
            }
        }
        Ok(Numbers { sources, columns, skip, faults })
    }

    pub(crate) fn columns(&self) -> Vec<&[f64]> {
        self.columns.iter().map(|column| &column.values()[..]).collect()
    }
}

fn floats(column: &ArrayRef) -> Result<Float64Array, ArrowError> {
    let is_text = match column.data_type() {
        DataType::Dictionary(_, values) => values.is_string(),
        other => other.is_string(),
    };
    if is_text {
        let texts = cast(column, &DataType::Utf8)?;
        return Ok(texts.as_string::<i32>().iter().map(|text| text.and_then(number)).collect());
    }
    Ok(cast(column, &DataType::Float64)?.as_primitive::<Float64Type>().clone())
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
