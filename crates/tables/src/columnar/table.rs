//! Tables of Arrow: with results, as they are written, and as text.

use std::sync::Arc;

use arrow_array::{ArrayRef, RecordBatch};
use arrow_cast::cast;
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};

use crate::memory::inputs::in_words;

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
