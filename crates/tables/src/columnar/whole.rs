//! A whole table of any format as CSV text, for readers that take rows of words.

use arrow_array::RecordBatch;
use arrow_ipc::reader::StreamReader;

use super::csv::write_batch;
use super::ipc::ArrowFile;
use super::parquet as pq;
use super::source::seekable;
use super::table::{header, nested};
use crate::guard::guarded;
use crate::pieces::TableInput;
use crate::{TableError, TableFormat, TableOptions};

/// The text, its header first, of a table in the format that the options name.
pub(crate) fn text(input: TableInput<'_>, options: &TableOptions) -> Result<Vec<u8>, TableError> {
    let batches = guarded(|cause| options.damaged(cause), || batches(input, options))?;
    let damaged = |cause: String| options.damaged(cause);
    let mut text = Vec::new();
    for (place, batch) in batches.iter().enumerate() {
        if place == 0 {
            let schema = batch.schema();
            if let Some((column, holds)) = nested(&schema) {
                return Err(damaged(format!(
                    "the column {column} holds {holds}; expected numbers and texts"
                )));
            }
            text = header(&schema);
            text.push(b'\n');
        }
        write_batch(batch, &[], batch.num_rows(), &mut text).map_err(|error| damaged(error.to_string()))?;
    }
    Ok(text)
}

fn batches(input: TableInput<'_>, options: &TableOptions) -> Result<Vec<RecordBatch>, TableError> {
    let damaged = |cause: String| options.damaged(cause);
    let unread =
        |cause: std::io::Error| TableError::Read { name: options.name.clone(), cause: cause.to_string() };
    let mut all = Vec::new();
    match options.from {
        TableFormat::Parquet => {
            let source = pq::Source::open(seekable(input).map_err(unread)?);
            let source = source.map_err(|error| damaged(error.to_string()))?;
            for part in source.parts(false, options.piece()) {
                let read = source.read(part).map_err(|error| damaged(error.to_string()))?;
                for batch in read {
                    all.push(batch.map_err(|error| damaged(error.to_string()))?);
                }
            }
        }
        TableFormat::Arrow => {
            let mut file = ArrowFile::open(seekable(input).map_err(unread)?)
                .map_err(|error| damaged(error.to_string()))?;
            while let Some(batch) = file.next().map_err(|error| damaged(error.to_string()))? {
                all.push(batch);
            }
        }
        TableFormat::Arrows => {
            let stream =
                StreamReader::try_new(input.stream(), None).map_err(|error| damaged(error.to_string()))?;
            for batch in stream {
                all.push(batch.map_err(|error| damaged(error.to_string()))?);
            }
        }
        #[cfg(feature = "xlsx")]
        TableFormat::Xlsx => all.push(super::sheet::read(seekable(input).map_err(unread)?, options)?.0),
        #[cfg(not(feature = "xlsx"))]
        TableFormat::Xlsx => {
            return Err(TableError::LeftOut { name: options.name.clone(), format: options.from.name() });
        }
        TableFormat::Csv => {}
    }
    Ok(all)
}
