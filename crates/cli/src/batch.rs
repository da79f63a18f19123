//! `standfast batch`: every row of a table of points.
//!
//! The table is read piece by piece, the pieces are answered on all cores, and written in order: a table of any length
//! needs the memory of a few pieces, and the result does not depend on the number of threads.
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

mod answers;
mod arrow;
mod columns;
mod engine;
mod error;
mod file;
mod format;
mod guard;
mod parquet;
mod pipeline;
mod problem;
mod progress;
mod table;
mod text;

pub use columns::Mapping;
pub use error::{BatchError, Place, RowProblem};
pub use file::process;
pub use format::TableFormat;
pub use guard::silence_caught_panics;
pub use problem::{Problem, ResultColumn};

use std::io::{Read, Write};
use std::sync::Arc;

use clap::ValueEnum;

use engine::Input;
use progress::Progress;

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
    /// The format of the input, if its name does not tell.
    pub from: Option<TableFormat>,
    /// The format of the output, if its name does not tell.
    pub to: Option<TableFormat>,
    /// Which problem the rows are.
    pub problem: Problem,
    /// The names the problem's columns have in the table, where they are not ours.
    pub map: Vec<Mapping>,
    /// What is computed, in this order; all results of the problem if empty.
    pub columns: Vec<ResultColumn>,
    /// What to do with a row that makes no sense.
    pub on_error: OnError,
    /// How many threads work; the result is the same for any number.
    pub threads: usize,
    /// The modes of all rows, known beforehand: for the benchmark, which measures what computing them adds to reading
    /// and writing. Only from Parquet to Parquet.
    #[doc(hidden)]
    pub known_modes: Option<Arc<[u8]>>,
}

impl Options {
    /// The report's problem with all its results on one thread; stop at the first row that makes no sense; `name` is
    /// what errors call the input.
    pub fn new(name: &str) -> Options {
        Options {
            name: name.to_owned(),
            from: None,
            to: None,
            problem: Problem::Force,
            map: Vec::new(),
            columns: Vec::new(),
            on_error: OnError::Stop,
            threads: 1,
            known_modes: None,
        }
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

/// Answers every row of a table; both formats are CSV unless the options say otherwise.
///
/// # Errors
/// If the table does not have the columns of the problem, or has a result column already; at the first row that makes
/// no sense, unless [`OnError::Null`]; or if reading or writing fails.
pub fn run(
    input: impl Read + Send,
    output: impl Write + Send,
    options: &Options,
) -> Result<Summary, BatchError> {
    let from = options.from.unwrap_or(TableFormat::Csv);
    let to = options.to.unwrap_or(TableFormat::Csv);
    engine::run(Input::Stream(Box::new(input)), from, output, to, options, &Progress::hidden())
}
