//! Columns of Arrow written as CSV text.

use arrow_array::cast::AsArray;
use arrow_array::types::{Float32Type, Float64Type};
use arrow_array::{Array, RecordBatch};
use arrow_cast::display::{ArrayFormatter, FormatOptions};
use arrow_schema::{ArrowError, DataType};

use crate::results::Values;

/// Appends the first `rows` rows, each followed by its results, as CSV text. Floating-point numbers have as many digits
/// as they need to be read again as what they are; a null is an empty field.
pub(crate) fn write_batch(
    batch: &RecordBatch,
    results: &[Values],
    rows: usize,
    text: &mut Vec<u8>,
) -> Result<(), ArrowError> {
    enum Cells<'a> {
        Double(&'a [f64]),
        Single(&'a [f32]),
        Other(ArrayFormatter<'a>),
    }
    let options = FormatOptions::default();
    let cells = batch.columns().iter().map(|column| {
        Ok(match column.data_type() {
            DataType::Float64 => Cells::Double(column.as_primitive::<Float64Type>().values()),
            DataType::Float32 => Cells::Single(column.as_primitive::<Float32Type>().values()),
            _ => Cells::Other(ArrayFormatter::try_new(column, &options)?),
        })
    });
    let cells = cells.collect::<Result<Vec<_>, ArrowError>>()?;
    let mut writer = csv::Writer::from_writer(std::mem::take(text));
    let mut number = ryu::Buffer::new();
    let mut field = String::new();
    let mut result = Vec::new();
    let failed = |error: csv::Error| ArrowError::CsvError(error.to_string());
    for row in 0..rows {
        for (cells, column) in cells.iter().zip(batch.columns()) {
            let bytes = match cells {
                _ if column.is_null(row) => "",
                Cells::Double(values) => number.format(values[row]),
                Cells::Single(values) => number.format(values[row]),
                Cells::Other(formatter) => {
                    field.clear();
                    formatter.value(row).write(&mut field)?;
                    &field
                }
            };
            writer.write_field(bytes).map_err(failed)?;
        }
        for values in results {
            result.clear();
            values.push_text(row, &mut result);
            writer.write_field(&result).map_err(failed)?;
        }
        writer.write_record(None::<&[u8]>).map_err(failed)?;
    }
    *text = writer.into_inner().map_err(|error| ArrowError::CsvError(error.to_string()))?;
    Ok(())
}
