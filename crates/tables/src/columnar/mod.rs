//! Tables as columns: Parquet files, Arrow IPC files and streams, and text that comes from them or becomes them.

mod arrays;
mod csv;
mod ipc;
mod parquet;
mod sink;
mod table;
mod text;

use std::fs::File;
use std::io::{self, Read, Write};
use std::sync::{Arc, PoisonError};

use arrow_array::{ArrayRef, RecordBatch};
use arrow_ipc::reader::StreamReader;
use arrow_schema::SchemaRef;

use crate::answers::{Task, Values};
use crate::engine::{Done, Input, answer_pieces};
use crate::guard::guarded;
use crate::text::{self as rows, Header, Text};
use crate::{Progress, RowProblem, Summary, TableError, TableFormat, TableOptions};
use arrays::symbols;
use csv::write_batch;
use ipc::{ArrowFile, Batches};
use parquet::{self as pq, Encoder, Group, Part};
use sink::{Output, Remembering, Sink, Writing};
use table::{Inputs, Numbers};

/// The most rows of a batch, and of a row group of Parquet that is not copied.
const ROWS: usize = 1 << 17;

/// How much text is read at once: about a row group for Parquet.
const TEXT_OF_GROUP: usize = 1 << 23;

/// A file that can be read from any place: a stream is copied into a temporary one.
fn seekable(input: Input<'_>) -> io::Result<File> {
    match input {
        Input::File(file) => Ok(file),
        Input::Stream(mut stream) => {
            let mut file = tempfile::tempfile()?;
            io::copy(&mut stream, &mut file)?;
            Ok(file)
        }
    }
}

/// Answers a whole table.
pub(crate) fn answer<W: Write + Send>(
    input: Input<'_>,
    output: W,
    options: &TableOptions,
    progress: &dyn Progress,
) -> Result<Summary, TableError> {
    let task = Task::of(options)?;
    let output = Remembering { output, failed: Arc::default() };
    let failed = output.failed.clone();
    // What the library for a format makes of the system's words does not read well.
    let unwritten = |cause: String| {
        let failed = failed.lock().unwrap_or_else(PoisonError::into_inner).take();
        TableError::Write(failed.unwrap_or_else(|| io::Error::other(cause)))
    };
    let (mut source, reading) =
        guarded(|cause| options.damaged(cause), || Source::open(input, options, progress))?;
    let (mut sink, writing) = Sink::create(output, &reading, &task, options, &unwritten)?;
    let worker = Worker { reading: &reading, writing: &writing, task: &task, symbols: symbols(), options };
    let write = |output| sink.write(output, &reading).map_err(&unwritten);
    let summary = answer_pieces(options, progress, || source.next(), |piece| worker.work(piece), write)?;
    guarded(|panic| panic, || sink.finish()).map_err(unwritten)?;
    Ok(summary)
}

/// Where the pieces come from.
struct Source<'a> {
    options: &'a TableOptions,
    kind: SourceKind<'a>,
}

enum SourceKind<'a> {
    Text(Text<Box<dyn Read + Send + 'a>>),
    Batches {
        batches: Batches<'a>,
        /// What is left of a batch that was too long.
        rest: Option<RecordBatch>,
        /// Whether short batches are to be gathered.
        gather: bool,
    },
    Parquet(Box<dyn Iterator<Item = Part> + Send>),
}

/// A part of a table that is worked on as one.
enum Piece {
    Text(rows::Piece),
    /// Batches, and how many of the file end with them.
    Batches(Vec<RecordBatch>, u64),
    Part(Part),
}

/// How a piece is read.
pub(super) enum Reading {
    Text(Header),
    Batches(Inputs, SchemaRef),
    Parquet(pq::Source, Inputs),
}

impl<'a> Source<'a> {
    fn open(
        input: Input<'a>,
        options: &'a TableOptions,
        progress: &dyn Progress,
    ) -> Result<(Source<'a>, Reading), TableError> {
        let name = || options.name.clone();
        let unread = |cause: io::Error| TableError::Read { name: name(), cause: cause.to_string() };
        let damaged = |cause: String| options.damaged(cause);
        let (kind, reading) = match options.from {
            TableFormat::Csv => {
                let (text, header) = Text::open(input.stream(), TEXT_OF_GROUP, options)?;
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
                let parts = source.parts(options.to == TableFormat::Parquet, ROWS);
                (SourceKind::Parquet(Box::new(parts)), Reading::Parquet(source, inputs))
            }
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
                (SourceKind::Batches { batches, rest: None, gather }, Reading::Batches(inputs, schema))
            }
        };
        Ok((Source { options, kind }, reading))
    }

    fn next(&mut self) -> Result<Option<Piece>, TableError> {
        match &mut self.kind {
            SourceKind::Text(text) => Ok(text.next()?.map(Piece::Text)),
            SourceKind::Parquet(parts) => Ok(parts.next().map(Piece::Part)),
            SourceKind::Batches { batches, rest, gather } => {
                let mut gathered = Vec::new();
                let mut room = ROWS;
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

/// What makes a [`Done`] of a [`Piece`], on any thread.
struct Worker<'a> {
    reading: &'a Reading,
    writing: &'a Writing,
    task: &'a Task,
    symbols: ArrayRef,
    options: &'a TableOptions,
}

impl Worker<'_> {
    fn work(&self, piece: Piece) -> Result<Done<Output>, TableError> {
        match (piece, self.reading) {
            (Piece::Text(piece), Reading::Text(header)) => self.text(piece, header),
            (Piece::Batches(batches, units), Reading::Batches(inputs, _)) => {
                self.batches(batches, inputs, units)
            }
            (Piece::Part(part), Reading::Parquet(source, inputs)) => match self.writing {
                Writing::Parquet(_, encoder) if part.copied => self.copied(part, source, inputs, encoder),
                _ => {
                    let batches =
                        source.read(part).map_err(|error| self.options.damaged(error.to_string()))?;
                    let batches = batches.collect::<Result<Vec<_>, _>>();
                    let batches = batches.map_err(|error| self.options.damaged(error.to_string()))?;
                    self.batches(batches, inputs, part.rows as u64)
                }
            },
            _ => unreachable!("a source gives pieces of its own kind"),
        }
    }

    fn text(&self, piece: rows::Piece, header: &Header) -> Result<Done<Output>, TableError> {
        let mut answered = header.answer(piece, self.task);
        let results = self.arrays(std::mem::take(&mut answered.results));
        let batch = |schema| header.batch(&answered.parsed, results, schema);
        let output = match self.writing {
            Writing::Text => unreachable!("text that stays text needs no columns"),
            Writing::Arrow(schema) => Output::Batches(vec![batch(schema)]),
            Writing::Parquet(schema, encoder) => Output::Group(self.encode(encoder, &[batch(schema)])?),
        };
        Ok(answered.done(output))
    }

    fn batches(
        &self,
        batches: Vec<RecordBatch>,
        inputs: &Inputs,
        units: u64,
    ) -> Result<Done<Output>, TableError> {
        let mut tally = Tally::default();
        let mut text = Vec::new();
        let mut answered = Vec::new();
        for batch in batches {
            let numbers = inputs.numbers(&batch).map_err(|error| self.options.damaged(error.to_string()))?;
            let (results, first) = self.answer(&numbers, inputs, &mut tally, batch.num_rows());
            match self.writing {
                Writing::Text => {
                    let rows = self.options.rows_to_write(batch.num_rows(), first);
                    write_batch(&batch, &results, rows, &mut text).map_err(unwritable)?;
                    if rows < batch.num_rows() {
                        break;
                    }
                }
                Writing::Arrow(schema) | Writing::Parquet(schema, _) => {
                    answered.push(table::append(&batch, self.arrays(results), schema).map_err(unwritable)?);
                }
            }
        }
        let output = match self.writing {
            Writing::Text => Output::Text(text),
            Writing::Arrow(_) => Output::Batches(answered),
            Writing::Parquet(_, encoder) => Output::Group(self.encode(encoder, &answered)?),
        };
        Ok(tally.done(units, output))
    }

    /// The results of a row group whose columns are going to be copied.
    fn copied(
        &self,
        part: Part,
        source: &pq::Source,
        inputs: &Inputs,
        encoder: &Encoder,
    ) -> Result<Done<Output>, TableError> {
        // The file gives the columns in its own order, and each once.
        let mut order = inputs.places.clone();
        order.sort_unstable();
        order.dedup();
        let order: Vec<usize> =
            inputs.places.iter().filter_map(|place| order.binary_search(place).ok()).collect();
        let mut tally = Tally::default();
        let mut columns = encoder.results().map_err(unwritable)?;
        let batches = source.read_columns(part, &inputs.places);
        for batch in batches.map_err(|error| self.options.damaged(error.to_string()))? {
            let batch = batch.map_err(|error| self.options.damaged(error.to_string()))?;
            let sources = order.iter().map(|&place| batch.column(place).clone()).collect();
            let numbers = Numbers::read(sources, batch.num_rows());
            let numbers = numbers.map_err(|error| self.options.damaged(error.to_string()))?;
            let results = match &self.options.known_modes {
                Some(codes) => {
                    let start = part.start + tally.rows;
                    tally.rows += batch.num_rows();
                    vec![Values::Mode(codes[start..start + batch.num_rows()].to_vec())]
                }
                None => self.answer(&numbers, inputs, &mut tally, batch.num_rows()).0,
            };
            encoder.write(&mut columns, &self.arrays(results)).map_err(unwritable)?;
        }
        let columns = pq::close(columns).map_err(unwritable)?;
        Ok(tally.done(part.rows as u64, Output::Group(Group { copied: Some(part), columns })))
    }

    /// The results of a batch, and its first row without.
    fn answer(
        &self,
        numbers: &Numbers,
        inputs: &Inputs,
        tally: &mut Tally,
        rows: usize,
    ) -> (Vec<Values>, Option<usize>) {
        let mut faults = numbers.faults;
        let results = self.task.answer(&numbers.columns(), &numbers.skip, &mut faults);
        if let (None, Some(fault)) = (&tally.first, faults.first) {
            tally.first = Some((tally.rows + fault.row, inputs.problem(numbers, fault)));
        }
        tally.rows += rows;
        tally.bad += faults.count;
        (results, faults.first.map(|fault| fault.row))
    }

    fn arrays(&self, results: Vec<Values>) -> Vec<ArrayRef> {
        results.into_iter().map(|values| values.into_array(&self.symbols)).collect()
    }

    fn encode(&self, encoder: &Encoder, batches: &[RecordBatch]) -> Result<Group, TableError> {
        encoder.rows(batches).map_err(unwritable)
    }
}

fn unwritable(error: impl std::error::Error + Send + Sync + 'static) -> TableError {
    TableError::Write(io::Error::other(error))
}

/// What the batches of a piece add up to.
#[derive(Default)]
struct Tally {
    rows: usize,
    bad: u64,
    first: Option<(usize, RowProblem)>,
}

impl Tally {
    fn done(self, units: u64, output: Output) -> Done<Output> {
        let Tally { rows, bad, first } = self;
        Done { rows, bad, first: first.map(|(row, problem)| (row, None, problem)), units, output }
    }
}
