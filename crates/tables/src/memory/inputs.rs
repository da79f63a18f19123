//! The columns of a problem in a table of Arrow, as numbers.

#[cfg(feature = "columnar")]
use arrow_array::RecordBatch;
use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef, Float64Array};
use arrow_cast::cast;
use arrow_cast::display::{ArrayFormatter, FormatOptions};
#[cfg(feature = "columnar")]
use arrow_schema::Schema;
use arrow_schema::{ArrowError, DataType, Field};

use crate::task::{Fault, Faults, RowFault, Task};
use crate::{RowProblem, TableError, TableOptions};

/// The columns of the problem in a table of Arrow.
#[derive(Debug)]
pub(crate) struct Inputs {
    /// Places of the columns.
    pub(crate) places: Vec<usize>,
    /// Names of the columns in the table.
    pub(crate) names: Vec<String>,
    /// Task of the rows.
    pub(crate) task: Task,
    /// The row of the header, where the table is that of a sheet.
    #[cfg(feature = "columnar")]
    pub(crate) header_row: Option<u64>,
}

impl Inputs {
    /// The columns of a table to which the results are appended.
    #[cfg(feature = "columnar")]
    pub(crate) fn find(schema: &Schema, options: &TableOptions) -> Result<Inputs, TableError> {
        let names: Vec<String> = schema.fields().iter().map(|field| field.name().clone()).collect();
        let (task, places) = Task::of(options, &names)?;
        let inputs = Inputs::with(task, places, &names);
        inputs.check(inputs.places.iter().map(|&place| schema.field(place)), options)?;
        Ok(inputs)
    }

    /// The columns of a table whose results stand apart from it.
    pub(crate) fn apart(names: &[String], options: &TableOptions) -> Result<Inputs, TableError> {
        let (task, places) = Task::apart(options, names)?;
        Ok(Inputs::with(task.keeping_faults(), places, names))
    }

    fn with(task: Task, places: Vec<usize>, names: &[String]) -> Inputs {
        Inputs {
            names: places.iter().map(|&place| names[place].clone()).collect(),
            places,
            task,
            #[cfg(feature = "columnar")]
            header_row: None,
        }
    }

    /// Refuses columns that hold no numbers.
    pub(crate) fn check<'a>(
        &self,
        fields: impl Iterator<Item = &'a Field>,
        options: &TableOptions,
    ) -> Result<(), TableError> {
        for (field, column) in fields.zip(&self.names) {
            if !is_readable(field.data_type()) {
                let (name, column) = (options.name.clone(), column.clone());
                return Err(TableError::Type { name, column, found: in_words(field.data_type()) });
            }
        }
        Ok(())
    }

    /// The problem's columns of a batch that has all columns of the table.
    #[cfg(feature = "columnar")]
    pub(crate) fn numbers(&self, batch: &RecordBatch) -> Result<Numbers, ArrowError> {
        self.read(self.places.iter().map(|&place| batch.column(place).clone()).collect(), batch.num_rows())
    }

    /// Columns of the problem as numbers.
    pub(crate) fn read(&self, sources: Vec<ArrayRef>, rows: usize) -> Result<Numbers, ArrowError> {
        let mut faults = self.task.faults();
        let mut columns = Vec::new();
        let mut wrong: Vec<Fault> = Vec::new();
        for (place, source) in sources.iter().enumerate() {
            columns.push(floats(source, place, &self.task, &mut wrong)?);
        }
        let mut skip = Vec::new();
        if !wrong.is_empty() {
            skip.resize(rows, false);
            // The first column of a row is the one that is reported.
            wrong.sort_by_key(|fault| fault.row);
            wrong.dedup_by_key(|fault| fault.row);
            for fault in wrong {
                skip[fault.row] = true;
                faults.add(fault);
            }
        }
        Ok(Numbers { sources, columns, skip, faults })
    }

    /// Fault of a row.
    pub(crate) fn problem(&self, numbers: &Numbers, fault: &Fault) -> RowProblem {
        let row = fault.row;
        let is_null = |place: usize| {
            let source = &numbers.sources[place];
            source.is_null(row) || source.data_type().is_null()
        };
        if let RowFault::Value { column, expected } = fault.wrong
            && is_null(column)
        {
            return RowProblem::Null { column: self.names[column].clone(), expected };
        }
        let options = FormatOptions::default();
        let text = |place: usize| {
            let values = ArrayFormatter::try_new(&numbers.sources[place], &options);
            values.map(|values| values.value(row).to_string()).unwrap_or_default()
        };
        fault.wrong.clone().in_table(|place| (self.names[place].clone(), text(place)))
    }
}

/// Numbers of any kind, and text that may hold numbers.
fn is_readable(found: &DataType) -> bool {
    match found {
        DataType::Dictionary(_, values) => is_readable(values),
        DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View | DataType::Null => true,
        other => other.is_numeric(),
    }
}

pub(crate) fn in_words(found: &DataType) -> String {
    match found {
        DataType::Boolean => "true and false".to_owned(),
        DataType::Timestamp(..) => "points in time".to_owned(),
        DataType::Date32 | DataType::Date64 => "dates".to_owned(),
        DataType::List(_) | DataType::LargeList(_) | DataType::FixedSizeList(..) => "lists".to_owned(),
        DataType::Struct(_) => "structures".to_owned(),
        other => format!("values of the type {other}"),
    }
}

/// Columns of the problem as numbers.
pub(crate) struct Numbers {
    /// As they are in the table.
    sources: Vec<ArrayRef>,
    columns: Vec<Float64Array>,
    /// Rows that are not to be answered; empty if there are none.
    pub(crate) skip: Vec<bool>,
    pub(crate) faults: Faults,
}

impl Numbers {
    pub(crate) fn columns(&self) -> Vec<&[f64]> {
        self.columns.iter().map(|column| &column.values()[..]).collect()
    }
}

/// A column as numbers of the problem; what is none is a fault of its row, and null.
fn floats(
    column: &ArrayRef,
    place: usize,
    task: &Task,
    wrong: &mut Vec<Fault>,
) -> Result<Float64Array, ArrowError> {
    let is_text = match column.data_type() {
        DataType::Dictionary(_, values) => values.is_string(),
        other => other.is_string(),
    };
    let null = |row| Fault { row, wrong: RowFault::Value { column: place, expected: "a number" } };
    if !is_text {
        let numbers = cast(column, &DataType::Float64)?.as_primitive::<Float64Type>().clone();
        wrong.extend((0..numbers.len()).filter(|row| numbers.is_null(*row)).map(null));
        let values = numbers.iter().enumerate().map(|(row, number)| match task.value(place, number?) {
            Ok(value) => Some(value),
            Err(reason) => {
                wrong.push(Fault { row, wrong: reason });
                None
            }
        });
        return Ok(values.collect());
    }
    let texts = cast(column, &DataType::Utf8)?;
    let texts = texts.as_string::<i32>().iter().enumerate();
    let number = |(row, text): (usize, Option<&str>)| {
        let read = text.map(|text| task.read(place, text));
        match read {
            Some(Ok(number)) => Some(number),
            Some(Err(reason)) => {
                wrong.push(Fault { row, wrong: reason });
                None
            }
            None => {
                wrong.push(null(row));
                None
            }
        }
    };
    Ok(texts.map(number).collect())
}
