//! What can be wrong with a table.

use miette::Diagnostic;
use thiserror::Error;

use crate::write::WriteError;

/// Why a table was not processed.
#[derive(Debug, Error, Diagnostic)]
pub enum BatchError {
    /// There is not even a header.
    #[error("{name} is empty")]
    #[diagnostic(help("a table begins with the names of its columns, among them {needed}"))]
    Empty {
        /// The table.
        name: String,
        /// The columns needed.
        needed: String,
    },
    /// One of the columns needed is not there.
    #[error("{name} has no column {column}; its columns are {found}")]
    #[diagnostic(help("{}", rename(column, suggestion.as_deref(), needed)))]
    MissingColumn {
        /// The table.
        name: String,
        /// The column.
        column: &'static str,
        /// The columns there are.
        found: String,
        /// The one that may be meant.
        suggestion: Option<String>,
        /// The columns needed.
        needed: String,
    },
    /// One of the columns needed is there twice.
    #[error("{name} has two columns {column}")]
    TwoColumns {
        /// The table.
        name: String,
        /// The column.
        column: &'static str,
    },
    /// A column that is to be appended is there already.
    #[error("{name} already has a column {column}, which is one of the results")]
    #[diagnostic(help("rename or remove it"))]
    ResultExists {
        /// The table.
        name: String,
        /// The column.
        column: &'static str,
    },
    /// A row that makes no sense.
    #[error("{name}, line {line}, {problem}")]
    #[diagnostic(help("--on-error null leaves the results of such rows empty and goes on"))]
    Row {
        /// The table.
        name: String,
        /// Where the row begins, counted from one.
        line: u64,
        /// What is wrong with it.
        problem: RowProblem,
    },
    /// A quotation mark that swallows the rest of the table.
    #[error("{name}, line {line}: a quotation mark is opened and never closed")]
    #[diagnostic(help("a field that begins with \" has to end with \"; inside, it is written twice"))]
    Quote {
        /// The table.
        name: String,
        /// Where the row begins, counted from one.
        line: u64,
    },
    /// The table cannot be opened.
    #[error("cannot read {name}: {cause}")]
    Open {
        /// The table.
        name: String,
        /// What the system says.
        cause: std::io::Error,
    },
    /// The table cannot be read on.
    #[error("cannot read {name}: {error}")]
    Read {
        /// The table.
        name: String,
        /// What the system or the CSV reader says.
        error: csv::Error,
    },
    /// The result cannot be written.
    #[error("cannot write the result: {0}")]
    Write(csv::Error),
    /// The file of the result cannot be written.
    #[error(transparent)]
    File(#[from] WriteError),
}

/// What is wrong with a row.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum RowProblem {
    /// Too few or too many fields.
    #[error("{found} fields; expected {expected}, as many as the header has")]
    Length {
        /// The number of fields.
        found: usize,
        /// That of the header.
        expected: usize,
    },
    /// A value that no point can have.
    #[error("column {column}: \"{value}\"; expected {expected}")]
    Value {
        /// The column.
        column: &'static str,
        /// The field as it is.
        value: String,
        /// What it has to be.
        expected: &'static str,
    },
    /// Bytes that are no text.
    #[error("column {column}: \"{value}\" is not UTF-8 text")]
    Encoding {
        /// The column.
        column: String,
        /// The field with � for what cannot be read.
        value: String,
    },
}

fn rename(column: &str, suggestion: Option<&str>, needed: &str) -> String {
    match suggestion {
        Some(found) => format!("did you mean `{found}`? then name it {column}"),
        None => format!("the columns needed are {needed}, in any order"),
    }
}
