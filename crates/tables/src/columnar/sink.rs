//! Writers of the pieces of a table.

use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

use arrow_array::RecordBatch;
use arrow_ipc::writer::{FileWriter, StreamWriter};
use arrow_schema::{DataType, SchemaRef};

use super::parquet::{self as pq, Encoder, Group};
use super::source::Reading;
use super::table;
#[cfg(feature = "xlsx")]
use super::workbook::SheetColumns;
use crate::text::Separators;
use crate::{Summary, TableError, TableFormat, TableOptions};

/// Format in which pieces are written.
pub(super) enum Writing {
    Text,
    Arrow(SchemaRef),
    Parquet(SchemaRef, Encoder),
}

/// Output of a piece.
pub(super) enum Output {
    Text(Vec<u8>),
    Batches(Vec<RecordBatch>),
    Group(Group),
}

/// Writer of the pieces.
pub(super) enum Sink<W: Write + Send> {
    Text(W),
    Arrow(Box<FileWriter<W>>),
    Arrows(Box<StreamWriter<W>>),
    Parquet(pq::Sink<W>),
    #[cfg(feature = "xlsx")]
    Sheet(Box<super::workbook::Sheet<W>>),
}

/// Reason why something was not written.
pub(super) enum Unwritten {
    /// Words of a library.
    Words(String),
    /// The table does not fit.
    #[cfg(feature = "xlsx")]
    Table(TableError),
}

impl Unwritten {
    /// Converts to an error of the table; `words` makes one of what a library says.
    pub(super) fn into_table(self, words: impl Fn(String) -> TableError) -> TableError {
        match self {
            Unwritten::Words(cause) => words(cause),
            #[cfg(feature = "xlsx")]
            Unwritten::Table(error) => error,
        }
    }
}

impl<W: Write + Send> Sink<W> {
    pub(super) fn create(
        mut output: W,
        reading: &Reading,
        options: &TableOptions,
        unwritten: &impl Fn(String) -> TableError,
    ) -> Result<(Sink<W>, Writing), TableError> {
        let task = reading.task();
        let (schema, fixed) = match reading {
            Reading::Text(header) => (header.schema(), false),
            Reading::Batches(_, schema) => (schema.clone(), options.from == TableFormat::Arrow),
            Reading::Parquet(source, _) => (source.schema(), false),
        };
        let flat = matches!(options.to, TableFormat::Csv | TableFormat::Xlsx);
        if let Some((column, found)) = table::nested(&schema).filter(|_| flat) {
            let format = options.to.name();
            return Err(TableError::Nested { name: options.name.clone(), column, found, format });
        }
        if options.to == TableFormat::Csv {
            let line = task.header(&table::header(&schema), Separators::default(), b"\n");
            output.write_all(&line).map_err(|error| unwritten(error.to_string()))?;
            return Ok((Sink::Text(output), Writing::Text));
        }
        let source = if let Reading::Parquet(source, _) = reading { Some(source) } else { None };
        // The batches of an Arrow file have to share their dictionaries, and Parquet knows only those of text.
        let schema = match (options.to, reading) {
            (TableFormat::Arrow, Reading::Batches(..)) if fixed => schema,
            (TableFormat::Parquet, Reading::Parquet(..)) => schema,
            (TableFormat::Parquet, _) => table::without_dictionaries(&schema, |values| {
                !matches!(values, DataType::Utf8 | DataType::LargeUtf8)
            }),
            _ => table::without_dictionaries(&schema, |_| true),
        };
        let schema = table::extended(&schema, task.fields());
        let failed = |error: arrow_schema::ArrowError| unwritten(error.to_string());
        Ok(match options.to {
            TableFormat::Parquet => {
                let created = pq::create(output, &schema, &task.fields, source);
                let (sink, encoder) = created.map_err(|error| unwritten(error.to_string()))?;
                (Sink::Parquet(sink), Writing::Parquet(schema, encoder))
            }
            #[cfg(feature = "xlsx")]
            TableFormat::Xlsx => {
                let texts = if let Reading::Text(header) = reading { header.names.len() } else { 0 };
                let columns = SheetColumns { texts, results: task.fields.len(), digits: task.digits() };
                let sheet =
                    super::workbook::Sheet::create(output, &schema, columns, source.map(pq::Source::rows));
                let sheet = sheet.map_err(|error| error.into_table(unwritten))?;
                (Sink::Sheet(Box::new(sheet)), Writing::Arrow(schema))
            }
            TableFormat::Arrow => {
                let writer = FileWriter::try_new(output, &schema).map_err(failed)?;
                (Sink::Arrow(Box::new(writer)), Writing::Arrow(schema))
            }
            _ => {
                let writer = StreamWriter::try_new(output, &schema).map_err(failed)?;
                (Sink::Arrows(Box::new(writer)), Writing::Arrow(schema))
            }
        })
    }

    pub(super) fn write(&mut self, output: Output, reading: &Reading) -> Result<(), Unwritten> {
        match (self, output) {
            #[cfg(feature = "xlsx")]
            (Sink::Sheet(sheet), Output::Batches(batches)) => {
                return batches.iter().try_for_each(|batch| sheet.write(batch));
            }
            (Sink::Text(sink), Output::Text(text)) => {
                sink.write_all(&text).map_err(|error| error.to_string())
            }
            (Sink::Arrow(sink), Output::Batches(batches)) => {
                batches.iter().try_for_each(|batch| sink.write(batch)).map_err(|error| error.to_string())
            }
            (Sink::Arrows(sink), Output::Batches(batches)) => {
                batches.iter().try_for_each(|batch| sink.write(batch)).map_err(|error| error.to_string())
            }
            (Sink::Parquet(sink), Output::Group(group)) => {
                let source = if let Reading::Parquet(source, _) = reading { Some(source) } else { None };
                sink.write(group, source).map_err(|error| error.to_string())
            }
            _ => unreachable!("a piece is made for its sink"),
        }
        .map_err(Unwritten::Words)
    }

    /// Says beside the table of a workbook what it was answered with, and what came of it.
    pub(super) fn say(
        &mut self,
        options: &TableOptions,
        reading: &Reading,
        summary: &Summary,
    ) -> Result<(), String> {
        match self {
            #[cfg(feature = "xlsx")]
            Sink::Sheet(sheet) if options.case.is_some() => {
                let fields = &reading.task().fields;
                sheet.add(|workbook| super::about::write(workbook, options, fields, summary, 1))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn finish(self) -> Result<(), String> {
        let output = match self {
            Sink::Text(output) => Ok(output),
            Sink::Arrow(writer) => writer.into_inner().map_err(|error| error.to_string()),
            Sink::Arrows(writer) => writer.into_inner().map_err(|error| error.to_string()),
            Sink::Parquet(writer) => writer.finish().map_err(|error| error.to_string()),
            #[cfg(feature = "xlsx")]
            Sink::Sheet(sheet) => sheet.finish(),
        };
        output?.flush().map_err(|error| error.to_string())
    }
}

/// An output that remembers its first error.
pub(super) struct Remembering<W> {
    pub(super) output: W,
    pub(super) failed: Arc<Mutex<Option<io::Error>>>,
}

impl<W> Remembering<W> {
    fn remember<T>(&self, outcome: io::Result<T>) -> io::Result<T> {
        outcome.map_err(|error| {
            let kind = error.kind();
            self.failed.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            kind.into()
        })
    }
}

impl<W: Write> Write for Remembering<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let outcome = self.output.write(bytes);
        // An interrupted call is to be made again, and no error.
        match outcome {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => Err(error),
            outcome => self.remember(outcome),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        let outcome = self.output.flush();
        self.remember(outcome)
    }
}
