//! Results of every row of a table, once its columns are known.

#[cfg(feature = "columnar")]
use standfast_cases::units::Unit;

use crate::answers::Points;
use crate::case::CaseRows;
use crate::results::{ResultField, Values};
use crate::row_remarks::RowRemarks;
use crate::text::{Separators, number};
use crate::{OnError, RowProblem, TableError, TableFormat, TableOptions, Varied};

/// Results to compute of every row.
#[derive(Debug)]
pub(crate) struct Task {
    rows: Rows,
    /// The columns appended.
    pub(crate) fields: Vec<ResultField>,
    /// True if the last of them tells the faults of rows.
    says_problems: bool,
    /// True if all faults of rows are kept.
    keeps_faults: bool,
}

#[derive(Debug)]
enum Rows {
    Points(Points),
    Case(Box<CaseRows>),
}

/// A row without result.
#[derive(Debug, Clone)]
pub(crate) struct Fault {
    pub(crate) row: usize,
    pub(crate) wrong: RowFault,
}

/// Fault of a row whose columns hold numbers; columns by their place among those of the problem.
#[derive(Debug, Clone)]
pub(crate) enum RowFault {
    /// A value that no problem can have.
    Value { column: usize, expected: &'static str },
    /// Values that a case cannot have.
    Case { columns: Vec<usize>, problem: String },
}

impl RowFault {
    /// Converts to the table's words; `field` gives the name of a column and the row's value there.
    pub(crate) fn in_table(self, field: impl Fn(usize) -> (String, String)) -> RowProblem {
        match self {
            RowFault::Value { column, expected } => {
                let (column, value) = field(column);
                RowProblem::Value { column, value, expected }
            }
            RowFault::Case { columns, problem } => {
                RowProblem::Case { fields: columns.into_iter().map(field).collect(), problem }
            }
        }
    }
}

/// The rows without result, and what is to be minded of the others.
#[derive(Debug, Clone, Default)]
pub(crate) struct Faults {
    pub(crate) count: u64,
    pub(crate) first: Option<Fault>,
    /// All of them, where it is asked for.
    pub(crate) all: Option<Vec<Fault>>,
    /// What is to be said of the rows that have a result.
    pub(crate) minded: RowRemarks,
}

impl Faults {
    pub(crate) fn add(&mut self, fault: Fault) {
        self.count += 1;
        if let Some(all) = &mut self.all {
            all.push(fault.clone());
        }
        if self.first.as_ref().is_none_or(|first| fault.row < first.row) {
            self.first = Some(fault);
        }
    }
}

impl Task {
    /// Task of a table with the columns `found`, and the places of those that hold the problem.
    ///
    /// # Errors
    /// If the table lacks columns or has a result already, or the options name a result that there is not, or one twice.
    pub(crate) fn of(options: &TableOptions, found: &[String]) -> Result<(Task, Vec<usize>), TableError> {
        // What people open has the units of the case; what programs read stays SI.
        let in_units = matches!(options.to, TableFormat::Csv | TableFormat::Xlsx);
        let (task, places) = Task::with(options, found, in_units)?;
        let is_there = |field: &&ResultField| {
            found.iter().any(|column| *column == field.name || *column == field.heading())
        };
        if let Some(field) = task.fields.iter().find(is_there) {
            return Err(TableError::ResultExists { name: options.name.clone(), column: field.heading() });
        }
        Ok((task, places))
    }

    /// Task whose results stand apart from the table.
    ///
    /// # Errors
    /// As [`of`](Task::of), but for a result that the table has.
    #[cfg(feature = "memory")]
    pub(crate) fn apart(options: &TableOptions, found: &[String]) -> Result<(Task, Vec<usize>), TableError> {
        Task::with(options, found, false)
    }

    fn with(
        options: &TableOptions,
        found: &[String],
        in_units: bool,
    ) -> Result<(Task, Vec<usize>), TableError> {
        let (rows, mut fields, places) = match &options.case {
            None => {
                let results = options.results()?;
                let field = |column: &crate::ResultColumn| ResultField {
                    name: column.name(),
                    kind: column.kind(),
                    said: None,
                    has_heading: false,
                };
                let fields = results.iter().map(field).collect();
                let places = options.places(found)?;
                let omega_by_name = options.omega_by_name(&places);
                let points = Points { problem: options.problem, results, omega_by_name };
                (Rows::Points(points), fields, places)
            }
            Some(case) => {
                let (rows, places) = CaseRows::of(options, case, found)?;
                let rows = if in_units { rows.in_units() } else { rows };
                let fields = rows.fields();
                (Rows::Case(Box::new(rows)), fields, places)
            }
        };
        let says_problems = options.case.is_some() && options.on_error == OnError::Null;
        if says_problems {
            fields.push(ResultField::PROBLEM);
        }
        Ok((Task { rows, fields, says_problems, keeps_faults: says_problems }, places))
    }

    /// Keeps all faults of rows.
    #[cfg(feature = "memory")]
    pub(crate) fn keeping_faults(self) -> Task {
        Task { keeps_faults: true, ..self }
    }

    /// Number of situations of a row.
    #[cfg(feature = "memory")]
    pub(crate) fn situations(&self) -> usize {
        match &self.rows {
            Rows::Points(_) => 1,
            Rows::Case(rows) => rows.situations().max(1),
        }
    }

    /// Significant digits that numbers of results are shown with.
    #[cfg(feature = "xlsx")]
    pub(crate) fn digits(&self) -> usize {
        const DIGITS: usize = 4;
        let asked = match &self.rows {
            Rows::Points(_) => None,
            Rows::Case(rows) => rows.digits(),
        };
        asked.unwrap_or(DIGITS)
    }

    /// Columns of a case that vary, with notes and warnings.
    pub(crate) fn varied(&self) -> Option<Varied> {
        match &self.rows {
            Rows::Points(_) => None,
            Rows::Case(rows) => Some(rows.varied()),
        }
    }

    /// The line of a text that names the columns of the table and the results.
    pub(crate) fn header(&self, columns: &[u8], separators: Separators, end: &[u8]) -> Vec<u8> {
        let mut line = columns.to_vec();
        for field in &self.fields {
            line.push(separators.column);
            line.extend_from_slice(field.heading().as_bytes());
        }
        line.extend_from_slice(end);
        line
    }

    /// Empty list of the faults of rows.
    pub(crate) fn faults(&self) -> Faults {
        Faults { all: self.keeps_faults.then(Vec::new), ..Faults::default() }
    }

    /// The value that a text in the column at a place of the problem's says, or what is wrong with it beside the text.
    pub(crate) fn read(&self, place: usize, text: &str) -> Result<f64, RowFault> {
        match &self.rows {
            Rows::Points(_) => number(text).ok_or(RowFault::Value { column: place, expected: "a number" }),
            Rows::Case(rows) => {
                rows.read(place, text).map_err(|problem| RowFault::Case { columns: vec![place], problem })
            }
        }
    }

    /// The value that a number in the column at a place of the problem's stands for, or what is wrong with it.
    #[cfg(feature = "memory")]
    pub(crate) fn value(&self, place: usize, number: f64) -> Result<f64, RowFault> {
        match &self.rows {
            Rows::Points(_) => Ok(number),
            Rows::Case(rows) => {
                rows.value(place, number).map_err(|problem| RowFault::Case { columns: vec![place], problem })
            }
        }
    }

    /// The unit that numbers in the column at a place of the problem's are in, where that is not the one of their values.
    #[cfg(feature = "columnar")]
    pub(crate) fn unit(&self, place: usize) -> Option<Unit> {
        match &self.rows {
            Rows::Points(_) => None,
            Rows::Case(rows) => rows.unit(place),
        }
    }

    /// The results for the problem's columns, in the order asked for. Rows marked in `skip`, which is as long as the
    /// columns or empty, get none.
    pub(crate) fn answer(&self, columns: &[&[f64]], skip: &[bool], faults: &mut Faults) -> Vec<Values> {
        match &self.rows {
            Rows::Points(points) => points.answer(columns, skip, faults),
            Rows::Case(rows) => rows.answer(columns, skip, faults),
        }
    }

    /// Appends the column that says what is wrong with rows, if there is one.
    pub(crate) fn say_problems(
        &self,
        results: &mut Vec<Values>,
        rows: usize,
        problems: impl Iterator<Item = (usize, RowProblem)>,
    ) {
        if !self.says_problems {
            return;
        }
        let mut column = vec![None; rows];
        for (row, problem) in problems {
            column[row].get_or_insert_with(|| problem.to_string());
        }
        results.push(Values::Text(column));
    }

    /// True if row groups whose columns can be copied are worked on as one, however long: the rows of a case take so
    /// long that shorter pieces are to share the cores.
    #[cfg(feature = "columnar")]
    pub(crate) fn copies(&self) -> bool {
        matches!(self.rows, Rows::Points(_))
    }
}

impl TableOptions {
    /// Largest number of rows worked on as one, where a piece can have any number.
    #[cfg(feature = "columnar")]
    pub(crate) fn piece(&self) -> usize {
        // A row of a case takes a thousand times as long as that of a point.
        if self.case.is_some() { 1 << 13 } else { 1 << 17 }
    }
}
