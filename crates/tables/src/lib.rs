//! Every row of a table of points, answered: columns in, columns out.
//!
//! The table is read piece by piece, the pieces are answered on all cores, and written in order: a table of any length
//! needs the memory of a few pieces, and the result does not depend on the number of threads. Rows are points, or cases: those of a
//! case file with other numbers. CSV always; Parquet, Arrow IPC files and streams with the feature `columnar`, Excel workbooks
//! with `xlsx`; record batches in memory with `memory`.
//!
//! | question | start at |
//! |---|---|
//! | How is a table answered? | [`run`], or [`answer()`] for files and progress |
//! | How is one of motions read? | [`MotionTable`] |
//! | How is one in memory answered? | `MemoryTable`, with the feature `memory` |
//! | Which columns does it need, which can be computed? | [`TableProblem`], [`ResultColumn`]; of cases [`CaseTable`] |
//! | How is a file's format told? | [`TableFormat`] |
//! | What can be wrong with it? | [`TableError`] |
//!
//! ```
//! use standfast_tables::{TableOptions, run};
//!
//! let table = "id,gamma,k_prime,k,mu\na,1,1,2,5\n";
//! let mut answer = Vec::new();
//! let summary = run(table.as_bytes(), &mut answer, &TableOptions::new("points.csv"))?;
//! assert_eq!((summary.rows, summary.bad), (1, 0));
//! assert_eq!(
//!     String::from_utf8_lossy(&answer),
//!     "id,gamma,k_prime,k,mu,mode,unique,also,x_ddot,y_ddot,theta_ddot,f_x,f_y,xi\n\
//!      a,1,1,2,5,RO,true,,-1.125,1.125,1.125,0.875,2.125,-1.0\n"
//! );
//! # Ok::<(), standfast_tables::TableError>(())
//! ```

#![forbid(unsafe_code)]

mod answers;
mod case;
#[cfg(feature = "columnar")]
mod columnar;
mod columns;
mod engine;
mod error;
mod format;
mod guard;
#[cfg(feature = "memory")]
mod memory;
mod motion;
mod pieces;
mod pipeline;
mod plain;
mod problem;
mod results;
mod row_remarks;
mod row_warning;
mod task;
mod text;
mod written;

pub use case::{CaseTable, NUMBER, TableWarning, Varied, VariedColumn, column_warnings};
pub use columns::Mapping;
pub use engine::answer;
pub use error::{RowProblem, TableError, TablePlace};
pub use format::TableFormat;
pub use guard::silence_caught_panics;
#[cfg(feature = "memory")]
pub use memory::{MemoryAnswer, MemoryTable};
pub use motion::{MotionRow, MotionTable};
pub use pieces::TableInput;
pub use plain::{PlainColumn, PlainValues, write_columns};
pub use problem::{ResultColumn, TableProblem};
#[cfg(feature = "memory")]
pub use results::{NO_NAME, NO_WORD, Values};
pub use row_remarks::WorstRow;
pub use row_warning::RowWarning;
pub use standfast_cases::Interface;
pub use written::{WrittenColumn, written};

use std::io::{Read, Write};
use std::num::NonZeroU32;
use std::sync::Arc;

/// Listener that is told how far a run is; `()` is not interested.
pub trait Progress: Sync {
    /// The units to be counted are not bytes of the input: there are `length` of them.
    fn expect(&self, length: u64) {
        let _ = length;
    }

    /// So many more rows have been written, which are so many units of the input.
    fn advance(&self, rows: u64, units: u64) {
        let _ = (rows, units);
    }

    /// True if a run in memory is to stop.
    fn is_stopped(&self) -> bool {
        false
    }
}

impl Progress for () {}

/// Treatment of a row that makes no sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum OnError {
    /// Stop; nothing is written
    #[default]
    Stop,
    /// Leave its results empty and go on; a row of the wrong length is filled up or cut to that of the header
    Null,
}

/// Rows at the head of a text or a sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TableHead {
    /// The row with the names of the columns, counted from one: what stands above is left out. The first that is not empty if it is not said.
    pub row: Option<NonZeroU32>,
    /// True if the row below it has the units of the columns.
    pub has_units: bool,
}

/// Options of processing a table.
#[derive(Debug, Clone)]
pub struct TableOptions {
    /// Name of the input in errors.
    pub name: String,
    /// The format of the input.
    pub from: TableFormat,
    /// The format of the output.
    pub to: TableFormat,
    /// The sheet of a workbook that is read; the first if it is not said.
    pub sheet: Option<String>,
    /// The rows at its head.
    pub head: TableHead,
    /// Problem that the rows are, unless they vary a case.
    pub problem: TableProblem,
    /// The case that the rows vary, and what is computed of it.
    pub case: Option<Arc<CaseTable>>,
    /// The names the problem's columns have in the table, where they are not ours.
    pub map: Vec<Mapping>,
    /// Results computed of points, in this order; all of the problem if empty.
    pub columns: Vec<ResultColumn>,
    /// Treatment of a row that makes no sense.
    pub on_error: OnError,
    /// Origin of the options, and so their names in errors.
    pub interface: Interface,
    /// True if a text may be a plain number, as every number of a text is; otherwise it has its unit, as in a case
    /// file.
    pub plain_texts: bool,
    /// Name and version of the program that answers, for a workbook to say.
    pub program: Option<String>,
    /// Number of threads; the result does not depend on it.
    pub threads: usize,
    /// The modes of all rows, known beforehand: for the benchmark, which measures what computing them adds to reading
    /// and writing. Only from Parquet to Parquet.
    #[doc(hidden)]
    pub known_modes: Option<Arc<[u8]>>,
}

impl TableOptions {
    /// The report's problem with all its results on one thread, from CSV to CSV; stop at the first row that makes no sense; `name` is
    /// what errors call the input.
    pub fn new(name: &str) -> TableOptions {
        TableOptions {
            name: name.to_owned(),
            from: TableFormat::Csv,
            to: TableFormat::Csv,
            sheet: None,
            head: TableHead::default(),
            problem: TableProblem::Force,
            case: None,
            map: Vec::new(),
            columns: Vec::new(),
            on_error: OnError::Stop,
            interface: Interface::Program,
            plain_texts: true,
            program: None,
            threads: 1,
            known_modes: None,
        }
    }
}

/// Summary of a run.
#[derive(Debug, Default)]
pub struct Summary {
    /// Rows written.
    pub rows: u64,
    /// Rows among them whose results are empty.
    pub bad: u64,
    /// Fault of the first of those.
    pub first: Option<TableError>,
    /// Columns that varied a case, and what went with them.
    pub varied: Option<Varied>,
    /// Warnings of rows whose cases are unusual.
    pub minded: Vec<RowWarning>,
    /// The worst row of each criterion of the case.
    pub worst: Vec<WorstRow>,
}

/// Answers every row of a table.
///
/// # Errors
/// If the table does not have the columns of the problem, or has a result column already; at the first row that makes
/// no sense, unless [`OnError::Null`]; or if reading or writing fails.
pub fn run(
    input: impl Read + Send,
    output: impl Write + Send,
    options: &TableOptions,
) -> Result<Summary, TableError> {
    answer(TableInput::Stream(Box::new(input)), output, options, &())
}

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
