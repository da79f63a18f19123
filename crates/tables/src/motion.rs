//! Tables of motions: text whose rows are read whole, by the reader of all other tables and with its errors.

use standfast_cases::CaseFile;
use standfast_cases::motion::{ColumnError, MotionRows, RowFault};

use crate::case::nothing_varies;
use crate::text::{FirstLine, Rows, Text, lossy};
use crate::{RowProblem, TableError, TableFormat, TableHead, TableOptions, TablePlace};

/// Bytes of text read at once.
const TEXT: usize = 1 << 17;

/// A table of motions, read whole.
pub struct MotionTable {
    name: String,
    header: FirstLine,
    rows: Vec<MotionRow>,
    /// True if its rows are lines of a text.
    is_text: bool,
}

/// A row of a table of motions.
#[derive(Debug, Clone)]
pub struct MotionRow {
    /// The cells, as many as there are columns.
    pub cells: Vec<String>,
    /// Fault of the row as text.
    pub problem: Option<RowProblem>,
    line: u64,
}

impl MotionTable {
    /// Reads a table in the format that the options name, from the bytes of its file.
    ///
    /// # Errors
    /// As [`read`](MotionTable::read), and if it is damaged, or this build leaves out its format.
    pub fn of(bytes: &[u8], options: &TableOptions) -> Result<MotionTable, TableError> {
        if options.from == TableFormat::Csv {
            return MotionTable::read(bytes, &options.name, options.head);
        }
        #[cfg(feature = "columnar")]
        {
            let input = crate::TableInput::Stream(Box::new(std::io::Cursor::new(bytes)));
            let text = crate::columnar::whole_text(input, options)?;
            let table = MotionTable::read(&text, &options.name, TableHead::default())?;
            Ok(MotionTable { is_text: false, ..table })
        }
        #[cfg(not(feature = "columnar"))]
        Err(TableError::LeftOut { name: options.name.clone(), format: options.from.name() })
    }

    /// Reads CSV text; `name` is what errors call the table.
    ///
    /// # Errors
    /// If there is no header, or a quotation mark is never closed.
    pub fn read(text: &[u8], name: &str, head: TableHead) -> Result<MotionTable, TableError> {
        let needed = || "one that varies the case".to_owned();
        let (mut text, header) = Text::begin(text, TEXT, name, head, needed)?;
        let mut rows = Vec::new();
        while let Some(piece) = text.next()? {
            let mut found = Rows::new(&piece.bytes, header.separators);
            while found.advance() {
                let problem = found.check(&header.names).err();
                let mut cells: Vec<String> = found.record.iter().map(lossy).collect();
                cells.resize(header.names.len(), String::new());
                rows.push(MotionRow { cells, problem, line: found.line(piece.line) });
            }
        }
        Ok(MotionTable { name: name.to_owned(), header, rows, is_text: true })
    }

    /// The names of the columns.
    pub fn columns(&self) -> &[String] {
        &self.header.names
    }

    /// Each column with its cell in a row.
    pub fn named(&self, row: &MotionRow) -> Vec<(String, String)> {
        self.columns().iter().cloned().zip(row.cells.iter().cloned()).collect()
    }

    /// The rows.
    pub fn rows(&self) -> &[MotionRow] {
        &self.rows
    }

    /// The case of a file, varied by the columns.
    ///
    /// # Errors
    /// If a column cannot vary what it names, none varies anything, or the case makes no sense.
    pub fn varying(&self, file: &CaseFile) -> Result<MotionRows, TableError> {
        let rows = MotionRows::of(file, self.columns()).map_err(|error| self.refused(error))?;
        if rows.varied().next().is_none() {
            let error = nothing_varies(&self.name, file, self.columns(), None);
            return Err(self.header.refused(&self.name, error));
        }
        Ok(rows)
    }

    fn refused(&self, error: ColumnError) -> TableError {
        let name = self.name.clone();
        let error = match error {
            ColumnError::NoFactor { column, error } => TableError::NoFactor { name, column, error },
            ColumnError::SameKey { one, two, key } => TableError::SameKey { name, one, two, key },
            ColumnError::Case(error) => TableError::Case(error),
            error => TableError::Column { name, error },
        };
        self.header.refused(&self.name, error)
    }

    /// A fault of a row, in the table's words.
    pub fn problem(&self, row: usize, fault: RowFault) -> RowProblem {
        let field = |place: usize| (self.columns()[place].clone(), self.rows[row].cells[place].clone());
        RowProblem::Case { fields: fault.columns.into_iter().map(field).collect(), problem: fault.problem }
    }

    /// The error of a row with a problem.
    pub fn error(&self, row: usize, problem: RowProblem) -> TableError {
        let place = if self.is_text {
            TablePlace::Line(self.rows[row].line)
        } else {
            TablePlace::Row(row as u64 + 1)
        };
        TableError::Row { name: self.name.clone(), place, problem }
    }
}
