//! A table that is in memory, as record batches of Arrow: the results alone, of which a caller makes what it wants.

mod arrays;
pub(crate) mod inputs;

use std::sync::Arc;

use arrow_array::{ArrayRef, RecordBatch};
use arrow_schema::{ArrowError, Field, Schema};

use crate::pipeline;
use crate::results::Values;
use crate::row_remarks::RowRemarks;
use crate::{OnError, Progress, RowProblem, Summary, TableError, TableOptions, TablePlace, Varied};
use inputs::Inputs;

/// Number of rows of a case with one situation that are worked on as one: a millisecond or two, so that a run that is
/// stopped stops at once, and beside which the care for a piece does not count.
const PIECE: usize = 64;

/// A table in memory whose columns are known, and what is computed of its rows.
#[derive(Debug)]
pub struct MemoryTable {
    inputs: Inputs,
    options: TableOptions,
}

/// The results of a table in memory.
pub struct MemoryAnswer {
    /// Their names, types in Arrow, and as metadata `unit` and `description`.
    pub fields: Vec<Field>,
    /// Their values, of all rows.
    pub values: Vec<Values>,
    /// The rows that have none, from zero.
    pub without: Vec<u64>,
    /// Summary of the run.
    pub summary: Summary,
}

/// The results of some rows.
struct AnsweredRows {
    rows: usize,
    values: Vec<Values>,
    /// Faults of rows, in their order.
    problems: Vec<(usize, RowProblem)>,
    minded: RowRemarks,
}

impl MemoryTable {
    /// Prepares the options for a table with these columns; the formats they name are of no concern.
    ///
    /// # Errors
    /// If the table lacks columns, or the options name a result that there is not, or one twice.
    pub fn of(columns: &[String], options: TableOptions) -> Result<MemoryTable, TableError> {
        Ok(MemoryTable { inputs: Inputs::apart(columns, &options)?, options })
    }

    /// The places of the columns that hold what the answer needs, in the order in which they are to be given.
    pub fn places(&self) -> &[usize] {
        &self.inputs.places
    }

    /// Columns that vary a case, and what goes with them; `None` of points.
    pub fn varied(&self) -> Option<Varied> {
        self.inputs.task.varied()
    }

    /// The results.
    pub fn fields(&self) -> Vec<Field> {
        self.inputs.task.fields()
    }

    /// Answers all rows. `batches` have the columns of [`places`](MemoryTable::places) in this order, with the types of `schema`.
    /// A row with a null has no results, and is not wrong.
    ///
    /// # Errors
    /// If a column holds no numbers; at the first row that makes no sense, unless [`OnError::Null`]; if a batch cannot be
    /// had; if `progress` stops the run.
    pub fn answer(
        &self,
        schema: &Schema,
        mut batches: impl Iterator<Item = Result<RecordBatch, ArrowError>> + Send,
        progress: &dyn Progress,
    ) -> Result<MemoryAnswer, TableError> {
        self.inputs.check(schema.fields().iter().map(AsRef::as_ref), &self.options)?;
        let piece = (PIECE / self.inputs.task.situations()).max(1);
        let mut rest: Option<RecordBatch> = None;
        let next = || {
            let batch = rest.take().map(Ok).or_else(|| batches.by_ref().find(is_not_empty)).transpose();
            let batch = batch.map_err(|error| self.unread(&error))?;
            Ok(batch.map(|batch| {
                if batch.num_rows() <= piece {
                    return batch;
                }
                rest = Some(batch.slice(piece, batch.num_rows() - piece));
                batch.slice(0, piece)
            }))
        };
        let work = |batch: RecordBatch| {
            if progress.is_stopped() { Err(TableError::Stopped) } else { self.rows(&batch) }
        };
        let mut values: Vec<Values> =
            self.inputs.task.fields.iter().map(|field| Values::empty(&field.kind, 0)).collect();
        let mut without = Vec::new();
        let mut minded = RowRemarks::default();
        let mut summary = Summary { varied: self.varied(), ..Summary::default() };
        let take = |answered: AnsweredRows| {
            let AnsweredRows { rows, values: of_rows, problems, minded: of_these } = answered;
            minded.append(of_these, summary.rows);
            summary.bad += problems.len() as u64;
            without.extend(problems.iter().map(|(row, _)| summary.rows + *row as u64));
            let wrong = problems.into_iter().find(|(_, problem)| !matches!(problem, RowProblem::Null { .. }));
            if let Some((row, problem)) = wrong {
                let place = TablePlace::Row(summary.rows + row as u64 + 1);
                let error = TableError::Row { name: self.options.name.clone(), place, problem };
                if self.options.on_error == OnError::Stop {
                    return Err(error);
                }
                summary.first.get_or_insert(error);
            }
            values.iter_mut().zip(of_rows).for_each(|(all, of_rows)| all.append(of_rows));
            summary.rows += rows as u64;
            progress.advance(rows as u64, rows as u64);
            Ok(())
        };
        pipeline::run(self.options.threads, next, work, take, |cause| self.options.damaged(cause))?;
        (summary.minded, summary.worst) = minded.into_parts();
        Ok(MemoryAnswer { fields: self.fields(), values, without, summary })
    }

    fn rows(&self, batch: &RecordBatch) -> Result<AnsweredRows, TableError> {
        let rows = batch.num_rows();
        let mut numbers =
            self.inputs.read(batch.columns().to_vec(), rows).map_err(|error| self.unread(&error))?;
        let mut faults = std::mem::take(&mut numbers.faults);
        let task = &self.inputs.task;
        let mut values = task.answer(&numbers.columns(), &numbers.skip, &mut faults);
        let all = faults.all.iter().flatten();
        let mut problems: Vec<_> =
            all.map(|fault| (fault.row, self.inputs.problem(&numbers, fault))).collect();
        problems.sort_by_key(|(row, _)| *row);
        task.say_problems(&mut values, rows, problems.iter().cloned());
        Ok(AnsweredRows { rows, values, problems, minded: faults.minded })
    }

    fn unread(&self, error: &ArrowError) -> TableError {
        TableError::Read { name: self.options.name.clone(), cause: error.to_string() }
    }
}

impl MemoryAnswer {
    /// The results as one batch.
    ///
    /// # Errors
    /// If they do not fit into one.
    pub fn into_batch(self) -> Result<RecordBatch, ArrowError> {
        let arrays: Vec<ArrayRef> = self.values.into_iter().map(Values::into_array).collect();
        RecordBatch::try_new(Arc::new(Schema::new(self.fields)), arrays)
    }
}

fn is_not_empty(batch: &Result<RecordBatch, ArrowError>) -> bool {
    batch.as_ref().map_or(true, |batch| batch.num_rows() > 0)
}
