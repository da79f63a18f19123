//! Reads a table piece by piece, answers the pieces on all cores, and writes them in order.

use std::fs::File;
use std::io::{self, Read, Write};
use std::sync::{Arc, Mutex, PoisonError};

use arrow_array::{ArrayRef, RecordBatch};
use arrow_ipc::reader::StreamReader;
use arrow_ipc::writer::{FileWriter, StreamWriter};
use arrow_schema::{DataType, SchemaRef};

use super::answers::{Faults, Task, Values, symbols};
use super::arrow::{ArrowFile, Batches};
use super::guard::guarded;
use super::parquet::{self as pq, Encoder, Group, Part};
use super::progress::Progress;
use super::table::{self, Inputs, Numbers};
use super::text::{self, Header, Text, write_batch};
use super::{BatchError, OnError, Options, Place, RowProblem, Summary, TableFormat, pipeline};

/// The most rows of a batch, and of a row group of Parquet that is not copied.
const ROWS: usize = 1 << 17;

/// How much text is read at once: about a row group for Parquet, and otherwise as little as stays in the caches.
const TEXT: usize = 1 << 17;
const TEXT_OF_GROUP: usize = 1 << 23;

/// Where a table comes from.
pub(super) enum Input<'a> {
    Stream(Box<dyn Read + Send + 'a>),
    File(File),
}

impl<'a> Input<'a> {
    fn stream(self) -> Box<dyn Read + Send + 'a> {
        match self {
            Input::Stream(stream) => stream,
            Input::File(file) => Box::new(file),
        }
    }

    /// A file that can be read from any place: a stream is copied into a temporary one.
    fn file(self) -> io::Result<File> {
        match self {
            Input::File(file) => Ok(file),
            Input::Stream(mut stream) => {
                let mut file = tempfile::tempfile()?;
                io::copy(&mut stream, &mut file)?;
                Ok(file)
            }
        }
    }
}

/// Answers a whole table.
pub(super) fn run<W: Write + Send>(
    input: Input<'_>,
    from: TableFormat,
    output: W,
    to: TableFormat,
    options: &Options,
    progress: &Progress,
) -> Result<Summary, BatchError> {
    let task = Task { problem: options.problem, results: options.results()? };
    let damaged =
        |cause: String| BatchError::Damaged { name: options.name.clone(), format: from.name(), cause };
    let output = Remembering { output, failed: Arc::default() };
    let failed = output.failed.clone();
    // What the library for a format makes of the system's words does not read well.
    let unwritten = |cause: String| {
        let failed = failed.lock().unwrap_or_else(PoisonError::into_inner).take();
        BatchError::Write(failed.unwrap_or_else(|| io::Error::other(cause)))
    };

    let (mut source, reading) = guarded(damaged, || Source::open(input, from, to, options, progress))?;
    let (mut sink, writing) = Sink::create(output, (from, to), &reading, &task, options, &unwritten)?;
    let worker = Worker { reading: &reading, writing: &writing, task: &task, symbols: symbols(), options };
    let mut summary = Summary::default();
    let take = |done: Done| {
        let error = done.first.map(|(row, line, problem)| BatchError::Row {
            name: options.name.clone(),
            place: line.map_or(Place::Row(summary.rows + row as u64 + 1), Place::Line),
            problem,
        });
        let stop = error.is_some() && options.on_error == OnError::Stop;
        // Of text, what stands before the row is written all the same: a pipe may have a use for it.
        if !stop || to == TableFormat::Csv {
            sink.write(done.output, &reading).map_err(&unwritten)?;
        }
        match error {
            Some(error) if stop => return Err(error),
            Some(error) => drop(summary.first.get_or_insert(error)),
            None => {}
        }
        summary.rows += done.rows as u64;
        summary.bad += done.bad;
        progress.advance(done.rows as u64, done.units);
        Ok(())
    };
    pipeline::run(options.threads, || source.next(), |piece| worker.work(piece), take, damaged)?;
    guarded(|panic| panic, || sink.finish()).map_err(unwritten)?;
    Ok(summary)
}

/// Where the pieces come from.
struct Source<'a> {
    options: &'a Options,
    format: TableFormat,
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
    Text(text::Piece),
    /// Batches, and how many of the file end with them.
    Batches(Vec<RecordBatch>, u64),
    Part(Part),
}

/// How a piece is read.
enum Reading {
    Text(Header),
    Batches(Inputs, SchemaRef),
    Parquet(pq::Source, Inputs),
}

impl<'a> Source<'a> {
    fn open(
        input: Input<'a>,
        from: TableFormat,
        to: TableFormat,
        options: &'a Options,
        progress: &Progress,
    ) -> Result<(Source<'a>, Reading), BatchError> {
        let name = || options.name.clone();
        let unread = |cause: io::Error| BatchError::Read { name: name(), cause: cause.to_string() };
        let damaged = |cause: String| BatchError::Damaged { name: name(), format: from.name(), cause };
        let (kind, reading) = match from {
            TableFormat::Csv => {
                let size = if to == TableFormat::Parquet { TEXT_OF_GROUP } else { TEXT };
                let (text, header) = Text::open(input.stream(), size, options)?;
                (SourceKind::Text(text), Reading::Text(header))
            }
            TableFormat::Parquet => {
                let source = pq::Source::open(input.file().map_err(unread)?);
                let source = source.map_err(|error| damaged(error.to_string()))?;
                let inputs = Inputs::find(&source.schema(), options)?;
                if let Some(codec) = inputs.places.iter().find_map(|&place| source.unreadable(place)) {
                    let cause =
                        format!("it is compressed by {codec}; expected Snappy, Zstandard, LZ4, gzip or none");
                    return Err(BatchError::Read { name: name(), cause });
                }
                progress.expect(source.rows());
                let parts = source.parts(to == TableFormat::Parquet, ROWS);
                (SourceKind::Parquet(Box::new(parts)), Reading::Parquet(source, inputs))
            }
            TableFormat::Arrow | TableFormat::Arrows => {
                let batches = match from {
                    TableFormat::Arrow => ArrowFile::open(input.file().map_err(unread)?)
                        .inspect(|file| progress.expect(file.left()))
                        .map(|file| Batches::File(Box::new(file))),
                    _ => StreamReader::try_new(input.stream(), None)
                        .map(|stream| Batches::Stream(Box::new(stream))),
                };
                let batches = batches.map_err(|error| damaged(error.to_string()))?;
                let schema = batches.schema();
                let inputs = Inputs::find(&schema, options)?;
                let gather = to == TableFormat::Parquet;
                (SourceKind::Batches { batches, rest: None, gather }, Reading::Batches(inputs, schema))
            }
        };
        Ok((Source { options, format: from, kind }, reading))
    }

    fn next(&mut self) -> Result<Option<Piece>, BatchError> {
        match &mut self.kind {
            SourceKind::Text(text) => Ok(text.next()?.map(Piece::Text)),
            SourceKind::Parquet(parts) => Ok(parts.next().map(Piece::Part)),
            SourceKind::Batches { batches, rest, gather } => {
                let mut gathered = Vec::new();
                let mut room = ROWS;
                let mut ended = 0;
                loop {
                    let next = rest.take().map_or_else(|| batches.next(), |rest| Ok(Some(rest)));
                    let Some(batch) = next.map_err(|error| BatchError::Damaged {
                        name: self.options.name.clone(),
                        format: self.format.name(),
                        cause: error.to_string(),
                    })?
                    else {
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

/// How pieces are written.
enum Writing {
    Text,
    Arrow(SchemaRef),
    Parquet(SchemaRef, Encoder),
}

/// A piece that is ready to be written.
struct Done {
    rows: usize,
    bad: u64,
    /// The first row without result, counted from zero, and its line in a text.
    first: Option<(usize, Option<u64>, RowProblem)>,
    /// What the piece is of the whole, in the unit of the [`Progress`].
    units: u64,
    output: Output,
}

enum Output {
    Text(Vec<u8>),
    Batches(Vec<RecordBatch>),
    Group(Group),
}

/// What makes a [`Done`] of a [`Piece`], on any thread.
struct Worker<'a> {
    reading: &'a Reading,
    writing: &'a Writing,
    task: &'a Task,
    symbols: ArrayRef,
    options: &'a Options,
}

impl Worker<'_> {
    fn work(&self, piece: Piece) -> Result<Done, BatchError> {
        match (piece, self.reading) {
            (Piece::Text(piece), Reading::Text(header)) => self.text(piece, header),
            (Piece::Batches(batches, units), Reading::Batches(inputs, _)) => {
                self.batches(batches, inputs, units)
            }
            (Piece::Part(part), Reading::Parquet(source, inputs)) => match self.writing {
                Writing::Parquet(_, encoder) if part.copied => self.copied(part, source, inputs, encoder),
                _ => {
                    let batches = source.read(part).map_err(|error| self.damaged(error.to_string()))?;
                    let batches = batches.collect::<Result<Vec<_>, _>>();
                    let batches = batches.map_err(|error| self.damaged(error.to_string()))?;
                    self.batches(batches, inputs, part.rows as u64)
                }
            },
            _ => unreachable!("a source gives pieces of its own kind"),
        }
    }

    fn text(&self, piece: text::Piece, header: &Header) -> Result<Done, BatchError> {
        let parsed = header.parse(piece);
        let mut faults = Faults::default();
        let results = self.task.answer(&parsed.columns(), &parsed.skip, &mut faults);
        let first = parsed.first_problem(header, &faults);
        let output = match self.writing {
            Writing::Text => {
                let rows = self.rows_to_write(parsed.len(), first.as_ref().map(|(row, ..)| *row));
                Output::Text(parsed.write(header, &results, rows))
            }
            Writing::Arrow(schema) => {
                Output::Batches(vec![header.batch(&parsed, self.arrays(results), schema)])
            }
            Writing::Parquet(schema, encoder) => {
                Output::Group(self.encode(encoder, &[header.batch(&parsed, self.arrays(results), schema)])?)
            }
        };
        let first = first.map(|(row, line, problem)| (row, Some(line), problem));
        Ok(Done {
            rows: parsed.len(),
            bad: faults.count + parsed.wrongs,
            first,
            units: parsed.bytes(),
            output,
        })
    }

    fn batches(&self, batches: Vec<RecordBatch>, inputs: &Inputs, units: u64) -> Result<Done, BatchError> {
        let mut tally = Tally::default();
        let mut text = Vec::new();
        let mut answered = Vec::new();
        for batch in batches {
            let numbers = inputs.numbers(&batch).map_err(|error| self.damaged(error.to_string()))?;
            let (results, first) = self.answer(&numbers, inputs, &mut tally, batch.num_rows());
            match self.writing {
                Writing::Text => {
                    let rows = self.rows_to_write(batch.num_rows(), first);
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
    ) -> Result<Done, BatchError> {
        // The file gives the columns in its own order, and each once.
        let mut order = inputs.places.clone();
        order.sort_unstable();
        order.dedup();
        let order: Vec<usize> =
            inputs.places.iter().filter_map(|place| order.binary_search(place).ok()).collect();
        let mut tally = Tally::default();
        let mut columns = encoder.results().map_err(unwritable)?;
        let batches = source.read_columns(part, &inputs.places);
        for batch in batches.map_err(|error| self.damaged(error.to_string()))? {
            let batch = batch.map_err(|error| self.damaged(error.to_string()))?;
            let sources = order.iter().map(|&place| batch.column(place).clone()).collect();
            let numbers = Numbers::read(sources, batch.num_rows());
            let numbers = numbers.map_err(|error| self.damaged(error.to_string()))?;
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

    /// How many rows of a text are written: none from the one that stops everything.
    fn rows_to_write(&self, rows: usize, first: Option<usize>) -> usize {
        first.filter(|_| self.options.on_error == OnError::Stop).unwrap_or(rows)
    }

    fn arrays(&self, results: Vec<Values>) -> Vec<ArrayRef> {
        results.into_iter().map(|values| values.into_array(&self.symbols)).collect()
    }

    fn encode(&self, encoder: &Encoder, batches: &[RecordBatch]) -> Result<Group, BatchError> {
        encoder.rows(batches).map_err(unwritable)
    }

    fn damaged(&self, cause: String) -> BatchError {
        let format = match self.reading {
            Reading::Text(_) => TableFormat::Csv,
            Reading::Batches(..) => TableFormat::Arrow,
            Reading::Parquet(..) => TableFormat::Parquet,
        };
        BatchError::Damaged { name: self.options.name.clone(), format: format.name(), cause }
    }
}

fn unwritable(error: impl std::error::Error + Send + Sync + 'static) -> BatchError {
    BatchError::Write(io::Error::other(error))
}

/// What the batches of a piece add up to.
#[derive(Default)]
struct Tally {
    rows: usize,
    bad: u64,
    first: Option<(usize, RowProblem)>,
}

impl Tally {
    fn done(self, units: u64, output: Output) -> Done {
        let Tally { rows, bad, first } = self;
        Done { rows, bad, first: first.map(|(row, problem)| (row, None, problem)), units, output }
    }
}

/// Where the pieces go.
enum Sink<W: Write + Send> {
    Text(W),
    Arrow(Box<FileWriter<W>>),
    Arrows(Box<StreamWriter<W>>),
    Parquet(pq::Sink<W>),
}

impl<W: Write + Send> Sink<W> {
    fn create(
        mut output: W,
        (from, to): (TableFormat, TableFormat),
        reading: &Reading,
        task: &Task,
        options: &Options,
        unwritten: &impl Fn(String) -> BatchError,
    ) -> Result<(Sink<W>, Writing), BatchError> {
        let (schema, fixed) = match reading {
            Reading::Text(header) => (header.schema(), false),
            Reading::Batches(_, schema) => (schema.clone(), from == TableFormat::Arrow),
            Reading::Parquet(source, _) => (source.schema(), false),
        };
        if to == TableFormat::Csv {
            let mut line = match reading {
                Reading::Text(header) => header.bytes.clone(),
                _ => {
                    if let Some((column, found)) = table::nested(&schema) {
                        return Err(BatchError::Nested { name: options.name.clone(), column, found });
                    }
                    table::header(&schema)
                }
            };
            for result in &task.results {
                line.push(b',');
                line.extend_from_slice(result.name().as_bytes());
            }
            line.extend_from_slice(if let Reading::Text(header) = reading { header.end } else { b"\n" });
            output.write_all(&line).map_err(|error| unwritten(error.to_string()))?;
            return Ok((Sink::Text(output), Writing::Text));
        }
        let source = if let Reading::Parquet(source, _) = reading { Some(source) } else { None };
        // The batches of an Arrow file have to share their dictionaries, and Parquet knows only those of text.
        let schema = match (to, reading) {
            (TableFormat::Arrow, Reading::Batches(..)) if fixed => schema,
            (TableFormat::Parquet, Reading::Parquet(..)) => schema,
            (TableFormat::Parquet, _) => table::without_dictionaries(&schema, |values| {
                !matches!(values, DataType::Utf8 | DataType::LargeUtf8)
            }),
            _ => table::without_dictionaries(&schema, |_| true),
        };
        let schema = table::extended(&schema, task.fields());
        let failed = |error: arrow_schema::ArrowError| unwritten(error.to_string());
        Ok(match to {
            TableFormat::Parquet => {
                let created = pq::create(output, &schema, &task.results, source);
                let (sink, encoder) = created.map_err(|error| unwritten(error.to_string()))?;
                (Sink::Parquet(sink), Writing::Parquet(schema, encoder))
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

    fn write(&mut self, output: Output, reading: &Reading) -> Result<(), String> {
        match (self, output) {
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
    }

    fn finish(self) -> Result<(), String> {
        let output = match self {
            Sink::Text(output) => Ok(output),
            Sink::Arrow(writer) => writer.into_inner().map_err(|error| error.to_string()),
            Sink::Arrows(writer) => writer.into_inner().map_err(|error| error.to_string()),
            Sink::Parquet(writer) => writer.finish().map_err(|error| error.to_string()),
        };
        output?.flush().map_err(|error| error.to_string())
    }
}

/// An output that remembers its first error.
struct Remembering<W> {
    output: W,
    failed: Arc<Mutex<Option<io::Error>>>,
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
