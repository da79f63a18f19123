//! `standfast batch`: every row of a table of points.
//!
//! Rows are read, answered and written one by one, so that a table of any length needs the memory of one row.
//!
//! ```
//! use standfast_cli::batch::{Options, run};
//!
//! let table = "id,gamma,k_prime,k,mu\na,1,1,2,5\n";
//! let mut answer = Vec::new();
//! let summary = run(table.as_bytes(), &mut answer, &Options::new("points.csv"))?;
//! assert_eq!((summary.rows, summary.bad), (1, 0));
//! assert_eq!(
//!     String::from_utf8_lossy(&answer),
//!     "id,gamma,k_prime,k,mu,mode,unique,also,x_ddot,y_ddot,theta_ddot,f_x,f_y,xi\n\
//!      a,1,1,2,5,RO,true,,-1.125,1.125,1.125,0.875,2.125,-1.0\n"
//! );
//! # Ok::<(), standfast_cli::batch::BatchError>(())
//! ```

mod columns;
mod error;
mod file;
mod problem;
mod watched;

pub use error::{BatchError, RowProblem};
pub use file::process;
pub use problem::Problem;

use std::io::{Read, Write};

use clap::ValueEnum;
use csv::{ByteRecord, ReaderBuilder, WriterBuilder};

use columns::Inputs;
use problem::{Answer, MOST};
use watched::Watched;

/// What to do with a row that makes no sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum OnError {
    /// Stop; nothing is written
    #[default]
    Stop,
    /// Leave its results empty and go on; a row of the wrong length is filled up or cut to that of the header
    Null,
}

/// How to process a table.
#[derive(Debug, Clone)]
pub struct Options {
    /// What errors call the input.
    pub name: String,
    /// Which problem the rows are.
    pub problem: Problem,
    /// What to do with a row that makes no sense.
    pub on_error: OnError,
}

impl Options {
    /// The report's problem; stop at the first row that makes no sense; `name` is what errors call the input.
    pub fn new(name: &str) -> Options {
        Options { name: name.to_owned(), problem: Problem::Force, on_error: OnError::Stop }
    }
}

/// What was done.
#[derive(Debug, Default)]
pub struct Summary {
    /// Rows written.
    pub rows: u64,
    /// Rows among them whose results are empty.
    pub bad: u64,
    /// What was wrong with the first of those.
    pub first: Option<BatchError>,
}

/// Classifies every row of a CSV table.
///
/// # Errors
/// If the table has no header with the four columns, or has a result column already; at the first row that makes
/// no sense, unless [`OnError::Null`]; or if reading or writing fails.
pub fn run(input: impl Read, output: impl Write, options: &Options) -> Result<Summary, BatchError> {
    let name = &options.name;
    // A row of the wrong length is for us to report.
    let mut reader =
        ReaderBuilder::new().flexible(true).buffer_capacity(1 << 16).from_reader(Watched::new(input));
    let mut writer = WriterBuilder::new().buffer_capacity(1 << 16).from_writer(output);
    let read = |error| BatchError::Read { name: name.clone(), error };

    let header = reader.byte_headers().map_err(read)?.clone();
    let inputs = Inputs::find(&header, name, options.problem)?;
    let mut record = header.clone();
    let results = options.problem.results();
    results.iter().for_each(|result| record.push_field(result.as_bytes()));
    writer.write_byte_record(&record).map_err(BatchError::Write)?;

    let mut summary = Summary::default();
    while reader.read_byte_record(&mut record).map_err(read)? {
        if let Some(line) = watched::left_open(&reader, &record) {
            return Err(BatchError::Quote { name: name.clone(), line });
        }
        match answer(&record, &header, &inputs) {
            Ok(answer) => answer.append(&mut record),
            Err(problem) => {
                let line = watched::line(&reader, &record);
                let error = BatchError::Row { name: name.clone(), line, problem };
                if options.on_error == OnError::Stop {
                    return Err(error);
                }
                summary.bad += 1;
                summary.first.get_or_insert(error);
                record.truncate(header.len());
                (record.len()..header.len() + results.len()).for_each(|_| record.push_field(b""));
            }
        }
        writer.write_byte_record(&record).map_err(BatchError::Write)?;
        summary.rows += 1;
    }
    writer.flush().map_err(|error| BatchError::Write(error.into()))?;
    Ok(summary)
}

/// The answer to a row.
fn answer(record: &ByteRecord, header: &ByteRecord, inputs: &Inputs) -> Result<Answer, RowProblem> {
    if record.len() != header.len() {
        return Err(RowProblem::Length { found: record.len(), expected: header.len() });
    }
    for (field, column) in record.iter().zip(header) {
        if std::str::from_utf8(field).is_err() {
            return Err(RowProblem::Encoding { column: lossy(column), value: lossy(field) });
        }
    }
    let problem = inputs.problem;
    let mut values = [0.0; MOST];
    for ((value, column), &place) in values.iter_mut().zip(problem.columns()).zip(&inputs.places) {
        *value = number(&record[place]).ok_or_else(|| RowProblem::Value {
            column: column.name,
            value: lossy(&record[place]),
            expected: "a number",
        })?;
    }
    problem.solve(values).map_err(|error| {
        let i = problem.blame(&error);
        let value = lossy(&record[inputs.places[i]]);
        RowProblem::Value { column: problem.columns()[i].name, value, expected: error.expected }
    })
}

fn number(field: &[u8]) -> Option<f64> {
    std::str::from_utf8(field).ok()?.trim().parse().ok()
}

fn lossy(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
