//! Reads a table piece by piece, answers the pieces on all cores, and writes them in order.

use std::fs::File;
use std::io::Read;

use crate::row_remarks::RowRemarks;
use crate::{
    OnError, Progress, RowProblem, Summary, TableError, TableFormat, TableOptions, TablePlace, pipeline,
};

/// Source of a table.
pub enum TableInput<'a> {
    /// Something that is read from its beginning to its end.
    Stream(Box<dyn Read + Send + 'a>),
    /// A file, which can be read at any place.
    File(File),
}

impl<'a> TableInput<'a> {
    pub(crate) fn stream(self) -> Box<dyn Read + Send + 'a> {
        match self {
            TableInput::Stream(stream) => stream,
            TableInput::File(file) => Box::new(file),
        }
    }
}

/// A piece of a table that is ready to be written.
pub(crate) struct Done<Output> {
    pub(crate) rows: usize,
    pub(crate) bad: u64,
    /// The first row without result, counted from zero, and its line in a text.
    pub(crate) first: Option<(usize, Option<u64>, RowProblem)>,
    /// Share of the piece in the whole, in the unit of the [`Progress`].
    pub(crate) units: u64,
    /// What is to be said of its rows.
    pub(crate) minded: RowRemarks,
    pub(crate) output: Output,
}

/// Answers the pieces of a table on all threads and writes them in order, until they end or a row stops the run. The rows of a
/// sheet are counted from its `header`.
pub(crate) fn answer_pieces<Piece: Send, Output: Send>(
    options: &TableOptions,
    header: Option<u64>,
    progress: &dyn Progress,
    next: impl FnMut() -> Result<Option<Piece>, TableError> + Send,
    work: impl Fn(Piece) -> Result<Done<Output>, TableError> + Sync,
    mut write: impl FnMut(Output) -> Result<(), TableError>,
) -> Result<Summary, TableError> {
    let (mut summary, mut minded) = (Summary::default(), RowRemarks::default());
    let take = |done: Done<Output>| {
        let error = done.first.map(|(row, line, problem)| TableError::Row {
            name: options.name.clone(),
            place: match (line, header, summary.rows + row as u64 + 1) {
                (Some(line), _, _) => TablePlace::Line(line),
                (None, Some(header), row) => TablePlace::SheetRow(header + row),
                (None, None, row) => TablePlace::Row(row),
            },
            problem,
        });
        let stop = error.is_some() && options.on_error == OnError::Stop;
        // Of text, what stands before the row is written all the same: a pipe may have a use for it.
        if !stop || options.to == TableFormat::Csv {
            write(done.output)?;
        }
        match error {
            Some(error) if stop => return Err(error),
            Some(error) => drop(summary.first.get_or_insert(error)),
            None => {}
        }
        minded.append(done.minded, summary.rows);
        summary.rows += done.rows as u64;
        summary.bad += done.bad;
        progress.advance(done.rows as u64, done.units);
        Ok(())
    };
    pipeline::run(options.threads, next, work, take, |cause| options.damaged(cause))?;
    let (minded, worst) = minded.into_parts();
    Ok(Summary { minded, worst, ..summary })
}

impl TableOptions {
    /// Number of rows to be written as text, the `first` of which has no result: none from one that stops everything.
    pub(crate) fn rows_to_write(&self, rows: usize, first: Option<usize>) -> usize {
        first.filter(|_| self.on_error == OnError::Stop).unwrap_or(rows)
    }

    /// Error for an input that is not whole, from the words of the library for its format.
    pub(crate) fn damaged(&self, cause: String) -> TableError {
        TableError::Damaged { name: self.name.clone(), format: self.from.name(), cause }
    }
}
