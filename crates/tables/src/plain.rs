//! Columns that a program has, as a table: text, Parquet, Arrow or a workbook.

use std::io::Write;

use crate::{TableError, TableFormat};

/// A column of a table that is written.
#[derive(Debug, Clone, PartialEq)]
pub struct PlainColumn {
    /// Its name.
    pub name: String,
    /// The unit of its numbers, where they have one; the metadata of Parquet and Arrow say it.
    pub unit: Option<&'static str>,
    /// Its values.
    pub values: PlainValues,
}

/// The values of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum PlainValues {
    /// Numbers.
    Numbers(Vec<f64>),
    /// A few words, and which of them stands in each row.
    Words(Vec<String>, Vec<usize>),
}

impl PlainValues {
    fn len(&self) -> usize {
        match self {
            PlainValues::Numbers(numbers) => numbers.len(),
            PlainValues::Words(_, places) => places.len(),
        }
    }
}

/// Writes columns of the same length. Numbers have as many digits as they need to be read again as what they are.
///
/// # Errors
/// If writing fails, there are more rows than a workbook has, or the format is one that this build does not have.
pub fn write_columns(
    columns: &[PlainColumn],
    format: TableFormat,
    mut output: impl Write + Send,
) -> Result<(), TableError> {
    write_into(columns, format, &mut output)
}

/// Writes into any output, so that what formats have of generic code is compiled here, once.
fn write_into(
    columns: &[PlainColumn],
    format: TableFormat,
    output: &mut (dyn Write + Send),
) -> Result<(), TableError> {
    match format {
        TableFormat::Csv => text(columns, output).map_err(|error| TableError::Write(error.into())),
        #[cfg(feature = "columnar")]
        TableFormat::Parquet | TableFormat::Arrow | TableFormat::Arrows => {
            columnar::write(columns, format, output)
                .map_err(|error| TableError::Write(std::io::Error::other(error)))
        }
        #[cfg(feature = "xlsx")]
        TableFormat::Xlsx => {
            let batch =
                columnar::batch(columns).map_err(|error| TableError::Write(std::io::Error::other(error)))?;
            crate::columnar::write_sheet(&batch, output)
        }
        #[allow(unreachable_patterns, reason = "in a build that has all of them")]
        other => {
            Err(TableError::Write(std::io::Error::other(format!("{} is not in this build", other.name()))))
        }
    }
}

fn text(columns: &[PlainColumn], output: impl Write) -> Result<(), csv::Error> {
    let mut writer = csv::Writer::from_writer(output);
    writer.write_record(columns.iter().map(|column| column.name.as_str()))?;
    let rows = columns.first().map_or(0, |column| column.values.len());
    let mut number = ryu::Buffer::new();
    for row in 0..rows {
        for column in columns {
            match &column.values {
                PlainValues::Numbers(numbers) => writer.write_field(number.format(numbers[row]))?,
                PlainValues::Words(words, places) => writer.write_field(&words[places[row]])?,
            }
        }
        writer.write_record(None::<&[u8]>)?;
    }
    writer.flush()?;
    Ok(())
}

#[cfg(feature = "columnar")]
mod columnar {
    use std::collections::HashMap;
    use std::error::Error;
    use std::io::Write;
    use std::sync::Arc;

    use arrow_array::{ArrayRef, Float64Array, RecordBatch, StringArray};
    use arrow_ipc::writer::{FileWriter, StreamWriter};
    use arrow_schema::{ArrowError, DataType, Field, Schema};
    use parquet::arrow::ArrowWriter;

    use super::{PlainColumn, PlainValues};
    use crate::TableFormat;

    pub(super) fn batch(columns: &[PlainColumn]) -> Result<RecordBatch, ArrowError> {
        let field = |column: &PlainColumn| {
            let kind = match column.values {
                PlainValues::Numbers(_) => DataType::Float64,
                PlainValues::Words(..) => DataType::Utf8,
            };
            let metadata = column.unit.map(|unit| ("unit".to_owned(), unit.to_owned()));
            Field::new(&column.name, kind, false).with_metadata(HashMap::from_iter(metadata))
        };
        let array = |column: &PlainColumn| -> ArrayRef {
            match &column.values {
                PlainValues::Numbers(numbers) => Arc::new(Float64Array::from(numbers.clone())),
                PlainValues::Words(words, places) => {
                    Arc::new(StringArray::from_iter_values(places.iter().map(|place| &words[*place])))
                }
            }
        };
        let schema = Arc::new(Schema::new(columns.iter().map(field).collect::<Vec<_>>()));
        RecordBatch::try_new(schema, columns.iter().map(array).collect())
    }

    pub(super) fn write<W: Write + Send>(
        columns: &[PlainColumn],
        format: TableFormat,
        output: W,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        let batch = batch(columns)?;
        let schema = batch.schema();
        match format {
            TableFormat::Parquet => {
                let mut writer = ArrowWriter::try_new(output, schema, None)?;
                writer.write(&batch)?;
                writer.close()?;
            }
            TableFormat::Arrows => {
                let mut writer = StreamWriter::try_new(output, &schema)?;
                writer.write(&batch)?;
                writer.finish()?;
            }
            _ => {
                let mut writer = FileWriter::try_new(output, &schema)?;
                writer.write(&batch)?;
                writer.finish()?;
            }
        }
        Ok(())
    }
}
