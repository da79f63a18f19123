//! Readers of the pieces of a table.

use std::fs::File;
use std::io::{self, Read};

use arrow_array::RecordBatch;
use arrow_ipc::reader::StreamReader;
use arrow_schema::SchemaRef;

use super::ipc::{ArrowFile, Batches};
use super::parquet::{self as pq, Part};
use crate::memory::inputs::Inputs;
use crate::pieces::TableInput;
use crate::task::Task;
use crate::text::{self as rows, Header, Text};
use crate::{Progress, TableError, TableFormat, TableOptions};

/// Bytes of text reckoned for a row: pieces of text are to be about a row group for Parquet.
const TEXT_OF_ROW: usize = 1 << 6;

/// A file that can be read from any place: a stream is copied into a temporary one.
pub(super) fn seekable(input: TableInput<'_>) -> io::Result<File> {
    match input {
        TableInput::File(file) => Ok(file),
        TableInput::Stream(mut stream) => {
            let mut file = tempfile::tempfile()?;
            io::copy(&mut stream, &mut file)?;
            Ok(file)
        }
    }
}

/// Source of the pieces.
pub(super) struct Source<'a> {
    options: &'a TableOptions,
    kind: SourceKind<'a>,
}

enum SourceKind<'a> {
    Text(Text<Box<dyn Read + Send + 'a>>),
    Batches {
        batches: Batches<'a>,
        /// Rest of a batch that was too long.
        rest: Option<RecordBatch>,
        /// True if short batches are to be gathered.
        gather: bool,
        /// The most rows of a piece.
        rows: usize,
    },
    Parquet(Box<dyn Iterator<Item = Part> + Send>),
}

/// A part of a table that is worked on as one.
pub(super) enum Piece {
    Text(rows::Piece),
    /// Batches, and how many of the file end with them.
    Batches(Vec<RecordBatch>, u64),
    Part(Part),
}

/// Way in which a piece is read.
pub(super) enum Reading {
    Text(Header),
    Batches(Inputs, SchemaRef),
    Parquet(pq::Source, Inputs),
}

impl Reading {
    /// The row of the header, where the table is that of a sheet.
    pub(super) fn header_row(&self) -> Option<u64> {
        match self {
            Reading::Batches(inputs, _) => inputs.header_row,
            Reading::Text(_) | Reading::Parquet(..) => None,
        }
    }

    /// Task of the rows.
    pub(super) fn task(&self) -> &Task {
        match self {
            Reading::Text(header) => &header.task,
            Reading::Batches(inputs, _) | Reading::Parquet(_, inputs) => &inputs.task,
        }
    }
}

impl<'a> Source<'a> {
    pub(super) fn open(
        input: TableInput<'a>,
        options: &'a TableOptions,
        progress: &dyn Progress,
    ) -> Result<(Source<'a>, Reading), TableError> {
        let name = || options.name.clone();
        let unread = |cause: io::Error| TableError::Read { name: name(), cause: cause.to_string() };
        let damaged = |cause: String| options.damaged(cause);
        let (kind, reading) = match options.from {
            TableFormat::Csv => {
                let (text, header) = Text::open(input.stream(), options.piece() * TEXT_OF_ROW, options)?;
                (SourceKind::Text(text), Reading::Text(header))
            }
            TableFormat::Parquet => {
                let source = pq::Source::open(seekable(input).map_err(unread)?);
                let source = source.map_err(|error| damaged(error.to_string()))?;
                let inputs = Inputs::find(&source.schema(), options)?;
                if let Some(codec) = inputs.places.iter().find_map(|&place| source.unreadable(place)) {
                    let cause =
                        format!("it is compressed by {codec}; expected Snappy, Zstandard, LZ4, gzip or none");
                    return Err(TableError::Read { name: name(), cause });
                }
                progress.expect(source.rows());
                let copy = options.to == TableFormat::Parquet && inputs.task.copies();
                let parts = source.parts(copy, options.piece());
                (SourceKind::Parquet(Box::new(parts)), Reading::Parquet(source, inputs))
            }
            TableFormat::Xlsx => Source::sheet(input, options)?,
            TableFormat::Arrow | TableFormat::Arrows => {
                let batches = match options.from {
                    TableFormat::Arrow => ArrowFile::open(seekable(input).map_err(unread)?)
                        .inspect(|file| progress.expect(file.left()))
                        .map(|file| Batches::File(Box::new(file))),
                    _ => StreamReader::try_new(input.stream(), None)
                        .map(|stream| Batches::Stream(Box::new(stream))),
                };
                let batches = batches.map_err(|error| damaged(error.to_string()))?;
                let schema = batches.schema();
                let inputs = Inputs::find(&schema, options)?;
                let gather = options.to == TableFormat::Parquet;
                let rows = options.piece();
                (SourceKind::Batches { batches, rest: None, gather, rows }, Reading::Batches(inputs, schema))
            }
        };
        Ok((Source { options, kind }, reading))
    }

    /// The table of a sheet, which is read as a whole.
    #[cfg(feature = "xlsx")]
    fn sheet(input: TableInput<'a>, options: &TableOptions) -> Result<(SourceKind<'a>, Reading), TableError> {
        let unread =
            |cause: io::Error| TableError::Read { name: options.name.clone(), cause: cause.to_string() };
        let (batch, header_row) = super::sheet::read(seekable(input).map_err(unread)?, options)?;
        let schema = batch.schema();
        let inputs = Inputs { header_row: Some(header_row), ..Inputs::find(&schema, options)? };
        let batches = Batches::Whole(Some(batch), schema.clone());
        let kind = SourceKind::Batches { batches, rest: None, gather: false, rows: options.piece() };
        Ok((kind, Reading::Batches(inputs, schema)))
    }

    #[cfg(not(feature = "xlsx"))]
    fn sheet(_: TableInput<'a>, options: &TableOptions) -> Result<(SourceKind<'a>, Reading), TableError> {
        let format = TableFormat::Xlsx.name();
        Err(TableError::LeftOut { name: options.name.clone(), format })
    }

    pub(super) fn next(&mut self) -> Result<Option<Piece>, TableError> {
        match &mut self.kind {
            SourceKind::Text(text) => Ok(text.next()?.map(Piece::Text)),
            SourceKind::Parquet(parts) => Ok(parts.next().map(Piece::Part)),
            SourceKind::Batches { batches, rest, gather, rows } => {
                let mut gathered = Vec::new();
                let mut room = *rows;
                let mut ended = 0;
                loop {
                    let next = rest.take().map_or_else(|| batches.next(), |rest| Ok(Some(rest)));
                    let Some(batch) = next.map_err(|error| self.options.damaged(error.to_string()))? else {
                        break;
                    };
                    if batch.num_rows() > room {
                        gathered.push(batch.slice(0, room));
                        *rest = Some(batch.slice(room, batch.num_rows() - room));
                        break;
                    }
                    ended += 1;
                    room -= batch.num_rows();
                    gathered.push(batch);
                    if !*gather || room == 0 {
                        break;
                    }
                }
                Ok((!gathered.is_empty()).then_some(Piece::Batches(gathered, ended)))
            }
        }
    }
}
