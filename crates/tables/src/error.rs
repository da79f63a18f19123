//! Faults of a table.

use std::fmt;
use std::io;

use standfast_cases::motion::ColumnError;
use standfast_cases::suggest::closest;
use standfast_cases::sweep::NoFactor;
use standfast_cases::{CaseError, Explained};
use thiserror::Error;

/// Reason why a table was not processed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TableError {
    /// There is not even a header.
    #[error("{name} is empty")]
    Empty {
        /// The table.
        name: String,
        /// The columns needed.
        needed: String,
    },
    /// A header is said to stand where the table has ended.
    #[error("{name} has no row {row} with the names of its columns")]
    NoHeaderRow {
        /// The table.
        name: String,
        /// The row.
        row: u32,
    },
    /// Units are said to stand where the table has ended.
    #[error("{name} has no row of units below the names of its columns")]
    NoUnitsRow {
        /// The table.
        name: String,
    },
    /// Another unit below the name of a column than behind it.
    #[error("the column {column} has {unit} below its name, which has another unit")]
    TwoUnits {
        /// Its name.
        column: String,
        /// The unit below.
        unit: String,
    },
    /// A row of the header is said of a table whose columns have names of their own.
    #[error("{option}: {name} is {format}, whose columns have their names")]
    NoHead {
        /// The option.
        option: &'static str,
        /// The table.
        name: String,
        /// Its format.
        format: &'static str,
    },
    /// A header whose columns are parted by something else than commas.
    #[error("{name} parts its columns by {separator}: its first line is {header}")]
    Separator {
        /// The table.
        name: String,
        /// Separator that seems to stand between its columns.
        separator: &'static str,
        /// Its first line.
        header: String,
    },
    /// One of the columns needed is not there.
    #[error("{name} has no column {column}; {}", columns(found))]
    MissingColumn {
        /// The table.
        name: String,
        /// The column looked for.
        column: String,
        /// The columns there are.
        found: String,
        /// Column that may be meant, or is needed.
        help: String,
    },
    /// One of the columns needed is there twice.
    #[error("{name} has two columns {column}")]
    TwoColumns {
        /// The table.
        name: String,
        /// The column.
        column: String,
    },
    /// A column that is to be appended is there already.
    #[error("{name} already has a column {column}, which is one of the results")]
    ResultExists {
        /// The table.
        name: String,
        /// The column.
        column: String,
    },
    /// `--map` names a column that the problem does not have.
    #[error("--map {ours}=…: the problem has no column {ours}")]
    MapUnknown {
        /// The name.
        ours: String,
        /// The one that may be meant.
        suggestion: Option<String>,
        /// The columns needed.
        needed: String,
    },
    /// `--map` names a column twice.
    #[error("--map names {ours} twice")]
    MapTwice {
        /// The column.
        ours: String,
    },
    /// Two numbers of the case are to be in one column.
    #[error("{one} and {two} are both mapped to column {column} of {name}; expected a column for each")]
    OneColumn {
        /// The table.
        name: String,
        /// The column.
        column: String,
        /// The key that was mapped first.
        one: String,
        /// The other.
        two: String,
    },
    /// The case that the rows vary is wrong by itself.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// No column has the name of a number of the case.
    #[error("{name} has no column that varies the case; {}", columns(found))]
    NothingVaries {
        /// The table.
        name: String,
        /// The columns there are.
        found: String,
        /// Key that may be meant, and the keys of the case.
        help: String,
    },
    /// A column whose name begins like a key, and is none that can vary.
    #[error("{name}, column {column}: {error}")]
    NoFactor {
        /// The table.
        name: String,
        /// The column, as the table calls it.
        column: String,
        /// Reason why it varies nothing.
        error: Box<NoFactor>,
    },
    /// A column of a table of motions that cannot vary what it names.
    #[error("{name}, {error}")]
    Column {
        /// The table.
        name: String,
        /// Reason why it varies nothing.
        error: ColumnError,
    },
    /// Two columns for one number of the case.
    #[error("{name}: the columns {one} and {two} both vary {key}; expected one of them")]
    SameKey {
        /// The table.
        name: String,
        /// A column.
        one: String,
        /// Another.
        two: String,
        /// The key.
        key: String,
    },
    /// `--columns` names a result that the problem does not have.
    #[error("{option} {column}: there is no such result here")]
    NoSuchResult {
        /// The option that names it.
        option: &'static str,
        /// The column.
        column: String,
        /// Those there are.
        results: Vec<&'static str>,
    },
    /// `--columns` names a result twice.
    #[error("{option} names {column} twice")]
    ResultTwice {
        /// The option that names it.
        option: &'static str,
        /// The column.
        column: &'static str,
    },
    /// The name of a file does not tell its format.
    #[error("cannot tell the format of {name} from its extension")]
    Format {
        /// The file.
        name: String,
        /// The option that tells it.
        option: &'static str,
    },
    /// This build has no code for a format.
    #[error("{name}: {format} is left out of this build")]
    LeftOut {
        /// The table.
        name: String,
        /// The format.
        format: &'static str,
    },
    /// A column does not hold numbers.
    #[error("{name}, column {column}: holds {found}; expected numbers")]
    Type {
        /// The table.
        name: String,
        /// The column.
        column: String,
        /// Type of its values.
        found: String,
    },
    /// A sheet that the workbook does not have.
    #[error("{name} has no sheet \"{sheet}\"")]
    NoSheet {
        /// The workbook.
        name: String,
        /// The sheet.
        sheet: String,
        /// Those there are.
        sheets: String,
    },
    /// A sheet is named for a table that has none.
    #[error("--sheet-name {sheet}: {name} is not a workbook, and has no sheets")]
    NoSheets {
        /// The table.
        name: String,
        /// The sheet.
        sheet: String,
    },
    /// Values without a column name above them.
    #[error("{name}, cell {cell}: there is a value, but no name of a column in row {header}")]
    Nameless {
        /// The workbook.
        name: String,
        /// The cell.
        cell: String,
        /// The row of the header.
        header: u64,
    },
    /// More than a sheet has room for.
    #[error("{found} {what} do not fit into a sheet of an Excel workbook, which has room for {room}")]
    SheetFull {
        /// Number to be written.
        found: u64,
        /// Rows or columns.
        what: &'static str,
        /// Largest number that can be, the header apart.
        room: u64,
    },
    /// A workbook that holds more than is read.
    #[error("{name}: {part} has {found} {what} or more; expected {most} at most")]
    TooLarge {
        /// The workbook.
        name: String,
        /// Part of it.
        part: String,
        /// Number counted.
        found: u64,
        /// Thing counted.
        what: &'static str,
        /// Largest number that may be.
        most: u64,
    },
    /// A column that has no place in a text or a sheet.
    #[error("{name}, column {column}: holds {found}, for which {format} has no place")]
    Nested {
        /// The table.
        name: String,
        /// The column.
        column: String,
        /// Type of its values.
        found: String,
        /// The format to be written.
        format: &'static str,
    },
    /// A row that makes no sense.
    #[error("{name}, {place}, {problem}")]
    Row {
        /// The table.
        name: String,
        /// Place of the row.
        place: TablePlace,
        /// Fault of the row.
        problem: RowProblem,
    },
    /// A quotation mark that swallows the rest of the table.
    #[error("{name}, line {line}: a quotation mark is opened and never closed")]
    Quote {
        /// The table.
        name: String,
        /// Line on which the row begins, counted from one.
        line: u64,
    },
    /// The table cannot be opened or read on.
    #[error("cannot read {name}: {cause}")]
    Read {
        /// The table.
        name: String,
        /// Words of the system, or of the library for the format.
        cause: String,
    },
    /// The file is not what its format asks for.
    #[error("cannot read {name}: not a whole {format} file, or damaged ({})", without_prefix(cause))]
    Damaged {
        /// The table.
        name: String,
        /// The format it was taken for.
        format: &'static str,
        /// Words of the library for the format.
        cause: String,
    },
    /// Whoever is told of the progress asked for it.
    #[error("stopped")]
    Stopped,
    /// The result cannot be written.
    #[error("cannot write the result: {0}")]
    Write(io::Error),
}

impl Explained for TableError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            TableError::Case(error) => Some(error),
            _ => None,
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            TableError::Empty { needed, .. } => {
                format!("a table begins with the names of its columns, among them {needed}")
            }
            TableError::NoHeaderRow { .. } => {
                "--header-row counts the rows of the text or the sheet from one, empty ones among them".into()
            }
            TableError::TwoUnits { .. } => "write the unit in one of the two places".into(),
            TableError::NoUnitsRow { .. } | TableError::NoHead { .. } => {
                "--header-row and --units-row are of CSV and Excel; leave them out where the table begins with its header".into()
            }
            TableError::Separator { .. } => {
                "CSV is read with commas, semicolons or tabs between columns; convert it, or give it as .xlsx \
                 or .parquet"
                    .into()
            }
            TableError::MissingColumn { help, .. } => help.clone(),
            TableError::ResultExists { .. } => "rename or remove it".into(),
            TableError::MapUnknown { suggestion, needed, .. } => meant(suggestion.as_deref(), needed),
            TableError::NothingVaries { help, .. } => help.clone(),
            TableError::NoFactor { error, .. } => return error.help(),
            TableError::NoSuchResult { column, results, .. } => meant_result(column, results),
            TableError::Format { option, .. } => format!(
                "expected .csv or .txt, .parquet or .pq, .arrow, .ipc or .feather, .arrows, .xlsx; or say \
                 it: {option} parquet"
            ),
            TableError::LeftOut { .. } => {
                "the feature `columnar` of standfast-tables adds Parquet and Arrow, `xlsx` Excel \
                 workbooks"
                    .into()
            }
            TableError::NoSheet { sheets, .. } => format!("its sheets are {sheets}"),
            TableError::Nameless { .. } => {
                "a table begins with the names of its columns, or has them where --header-row says; what stands beside it has to go to \
                 another sheet"
                    .into()
            }
            TableError::SheetFull { .. } => "write Parquet or CSV".into(),
            TableError::TooLarge { .. } => {
                "save the table as CSV or Parquet, which are read piece by piece".into()
            }
            TableError::Nested { .. } => "write Parquet or Arrow, or leave the column out".into(),
            TableError::Row { .. } => {
                "--on-error null leaves the results of such rows empty and goes on".into()
            }
            TableError::Quote { .. } => {
                "a field that begins with \" has to end with \"; inside, it is written twice".into()
            }
            _ => return None,
        };
        Some(help)
    }
}

/// Place of a row, counted from one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TablePlace {
    /// The line of a text on which it begins.
    Line(u64),
    /// The row of a table that has no lines.
    Row(u64),
    /// The row of a sheet, whose header counts.
    SheetRow(u64),
}

impl fmt::Display for TablePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TablePlace::Line(line) => write!(f, "line {line}"),
            TablePlace::Row(row) => write!(f, "row {row}"),
            TablePlace::SheetRow(row) => write!(f, "row {row} of the sheet"),
        }
    }
}

/// Fault of a row.
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
        /// The column, as the table calls it.
        column: String,
        /// The field as it is.
        value: String,
        /// Range of values allowed.
        expected: &'static str,
    },
    /// Values that the case cannot have: the columns blamed, and what each says.
    #[error("{}: {problem}", in_columns(fields))]
    Case {
        /// The columns, as the table calls them, and their fields as they are.
        fields: Vec<(String, String)>,
        /// Fault, in words.
        problem: String,
    },
    /// No value.
    #[error("column {column}: null; expected {expected}")]
    Null {
        /// The column, as the table calls it.
        column: String,
        /// Range of values allowed.
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

fn columns(found: &str) -> String {
    if found.is_empty() { "it has no columns".to_owned() } else { format!("its columns are {found}") }
}

fn meant_result(column: &str, results: &[&'static str]) -> String {
    let known = format!("the results are {}", results.join(", "));
    match closest(column, results.iter().copied()).filter(|result| *result != column) {
        Some(result) => format!("did you mean `{result}`? {known}"),
        None => known,
    }
}

fn in_columns(fields: &[(String, String)]) -> String {
    let each = fields.iter().map(|(column, value)| format!("column {column}: \"{value}\""));
    each.collect::<Vec<_>>().join(", ")
}

/// The words of the library for a format, without its name for them (`Parquet error: …`).
fn without_prefix(cause: &str) -> &str {
    cause.split_once(" error: ").map_or(cause, |(_, words)| words)
}

fn meant(suggestion: Option<&str>, needed: &str) -> String {
    match suggestion {
        Some(found) => format!("did you mean `{found}`?"),
        None => format!("its columns are {needed}"),
    }
}
