//! Whole columns as Parquet, Arrow and Excel files.

use std::io;
use std::sync::Arc;

use arrow_array::{ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_ipc::writer::{FileWriter, StreamWriter};
use arrow_schema::ArrowError;
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;

use crate::TableFormat;
use crate::written::WrittenColumn;

/// The bytes of a file with these columns.
pub(crate) fn written(format: TableFormat, columns: &[(String, WrittenColumn)]) -> io::Result<Vec<u8>> {
    let named = columns.iter().map(|(name, column)| (name.clone(), array(column), true));
    let batch = RecordBatch::try_from_iter_with_nullable(named).map_err(other)?;
    let mut bytes = Vec::new();
    match format {
        TableFormat::Parquet => {
            let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
            let writer = ArrowWriter::try_new(&mut bytes, batch.schema(), Some(properties));
            let mut writer = writer.map_err(other)?;
            writer.write(&batch).and_then(|()| writer.close()).map_err(other)?;
        }
        #[cfg(feature = "xlsx")]
        TableFormat::Xlsx => {
            let fails = |error: super::sink::Unwritten| {
                error.into_table(|words| crate::TableError::Write(io::Error::other(words)))
            };
            let rows = Some(batch.num_rows() as u64);
            let sheet = super::workbook::Sheet::create(
                &mut bytes,
                &batch.schema(),
                super::workbook::SheetColumns::default(),
                rows,
            );
            let mut sheet = sheet.map_err(|error| other(fails(error)))?;
            sheet.write(&batch).map_err(|error| other(fails(error)))?;
            sheet.finish().map_err(other)?;
        }
        TableFormat::Arrows => {
            let mut writer = StreamWriter::try_new(&mut bytes, &batch.schema()).map_err(other)?;
            stream(&mut writer, &batch).map_err(other)?;
        }
        TableFormat::Arrow => {
            let mut writer = FileWriter::try_new(&mut bytes, &batch.schema()).map_err(other)?;
            writer.write(&batch).and_then(|()| writer.finish()).map_err(other)?;
        }
        _ => return Err(other(format!("this build leaves out {}", format.name()))),
    }
    Ok(bytes)
}

fn stream(writer: &mut StreamWriter<&mut Vec<u8>>, batch: &RecordBatch) -> Result<(), ArrowError> {
    writer.write(batch)?;
    writer.finish()
}

fn other(error: impl ToString) -> io::Error {
    io::Error::other(error.to_string())
}

fn array(column: &WrittenColumn) -> ArrayRef {
    match column {
        WrittenColumn::Numbers(values) => Arc::new(Float64Array::from(values.clone())),
        WrittenColumn::Counts(values) => Arc::new(Int64Array::from(values.clone())),
        WrittenColumn::Truths(values) => Arc::new(BooleanArray::from(values.clone())),
        WrittenColumn::Texts(values) => Arc::new(StringArray::from(values.clone())),
    }
}
