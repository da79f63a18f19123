//! Tables as columns: Parquet files, Arrow IPC files and streams, and text that comes from them or becomes them.

#[cfg(feature = "xlsx")]
mod about;
mod csv;
mod ipc;
mod parquet;
#[cfg(feature = "xlsx")]
mod sheet;
mod sink;
mod source;
mod table;
mod text;
#[cfg(feature = "xlsx")]
mod unpacked;
mod whole;
#[cfg(feature = "xlsx")]
mod workbook;
mod written;

pub(crate) use whole::text as whole_text;
pub(crate) use written::written;

use std::io::{self, Write};
use std::sync::{Arc, PoisonError};

use arrow_array::{ArrayRef, RecordBatch};

use crate::guard::guarded;
use crate::memory::inputs::{Inputs, Numbers};
use crate::pieces::{Done, TableInput, answer_pieces};
use crate::results::{SYMBOLS, Values};
use crate::row_remarks::RowRemarks;
use crate::text::{self as rows, Header};
use crate::{Progress, RowProblem, Summary, TableError, TableOptions};
use csv::write_batch;
use parquet::{self as pq, Encoder, Group, Part};
use sink::{Output, Remembering, Sink, Writing};
use source::{Piece, Reading, Source};
#[cfg(feature = "xlsx")]
use workbook::SheetColumns;

/// Writes a batch as the sheet of a workbook.
#[cfg(feature = "xlsx")]
pub(crate) fn write_sheet(batch: &RecordBatch, output: impl Write) -> Result<(), TableError> {
    let words = |cause| TableError::Write(io::Error::other(cause));
    let rows = Some(batch.num_rows() as u64);
    let sheet = workbook::Sheet::create(output, &batch.schema(), SheetColumns::default(), rows);
    let mut sheet = sheet.map_err(|error| error.into_table(words))?;
    sheet.write(batch).map_err(|error| error.into_table(words))?;
    sheet.finish().map(|_| ()).map_err(words)
}

/// Answers a whole table.
pub(crate) fn answer<W: Write + Send>(
    input: TableInput<'_>,
    output: W,
    options: &TableOptions,
    progress: &dyn Progress,
) -> Result<Summary, TableError> {
    let output = Remembering { output, failed: Arc::default() };
    let failed = output.failed.clone();
    // Words of the system do not read well as the library for a format has them.
    let unwritten = |cause: String| {
        let failed = failed.lock().unwrap_or_else(PoisonError::into_inner).take();
        TableError::Write(failed.unwrap_or_else(|| io::Error::other(cause)))
    };
    let (mut source, reading) =
        guarded(|cause| options.damaged(cause), || Source::open(input, options, progress))?;
    let (mut sink, writing) = Sink::create(output, &reading, options, &unwritten)?;
    let worker = Worker { reading: &reading, writing: &writing, options };
    let write = |output| sink.write(output, &reading).map_err(|error| error.into_table(unwritten));
    let header = reading.header_row();
    let summary =
        answer_pieces(options, header, progress, || source.next(), |piece| worker.work(piece), write)?;
    let summary = Summary { varied: reading.task().varied(), ..summary };
    let finish = || {
        sink.say(options, &reading, &summary)?;
        sink.finish()
    };
    guarded(|panic| panic, finish).map_err(unwritten)?;
    Ok(summary)
}

/// Maker of a [`Done`] from a [`Piece`], on any thread.
struct Worker<'a> {
    reading: &'a Reading,
    writing: &'a Writing,
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
        let mut answered = header.answer(piece);
        let results = arrays(std::mem::take(&mut answered.results));
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
                    answered.push(table::append(&batch, arrays(results), schema).map_err(unwritable)?);
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
            let numbers = inputs.read(sources, batch.num_rows());
            let numbers = numbers.map_err(|error| self.options.damaged(error.to_string()))?;
            let results = match &self.options.known_modes {
                Some(codes) => {
                    let start = part.start + tally.rows;
                    tally.rows += batch.num_rows();
                    vec![Values::Word(&SYMBOLS, codes[start..start + batch.num_rows()].to_vec())]
                }
                None => self.answer(&numbers, inputs, &mut tally, batch.num_rows()).0,
            };
            encoder.write(&mut columns, &arrays(results)).map_err(unwritable)?;
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
        let mut faults = numbers.faults.clone();
        let mut results = inputs.task.answer(&numbers.columns(), &numbers.skip, &mut faults);
        if let (None, Some(fault)) = (&tally.first, &faults.first) {
            tally.first = Some((tally.rows + fault.row, inputs.problem(numbers, fault)));
        }
        tally.minded.append(std::mem::take(&mut faults.minded), tally.rows as u64);
        tally.rows += rows;
        tally.bad += faults.count;
        let all = faults.all.iter().flatten().map(|fault| (fault.row, inputs.problem(numbers, fault)));
        inputs.task.say_problems(&mut results, rows, all);
        (results, faults.first.map(|fault| fault.row))
    }

    fn encode(&self, encoder: &Encoder, batches: &[RecordBatch]) -> Result<Group, TableError> {
        encoder.rows(batches).map_err(unwritable)
    }
}

fn arrays(results: Vec<Values>) -> Vec<ArrayRef> {
    results.into_iter().map(Values::into_array).collect()
}

fn unwritable(error: impl std::error::Error + Send + Sync + 'static) -> TableError {
    TableError::Write(io::Error::other(error))
}

/// Sums over the batches of a piece.
#[derive(Default)]
struct Tally {
    rows: usize,
    bad: u64,
    first: Option<(usize, RowProblem)>,
    minded: RowRemarks,
}

impl Tally {
    fn done(self, units: u64, output: Output) -> Done<Output> {
        let Tally { rows, bad, first, minded } = self;
        let first = first.map(|(row, problem)| (row, None, problem));
        Done { rows, bad, first, units, minded, output }
    }
}
