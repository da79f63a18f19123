//! Columns of Arrow written into the sheet of an Excel workbook, row by row: the memory needed does not depend on their length.

use std::io::Write;

use arrow_array::cast::AsArray;
use arrow_array::types::{DurationMillisecondType, Float64Type, TimestampMillisecondType};
use arrow_array::{Array, ArrayRef, BooleanArray, Float64Array, RecordBatch, StringArray};
use arrow_cast::cast;
use arrow_schema::{DataType, Schema, TimeUnit};
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, Workbook, Worksheet, XlsxError};

use super::sink::Unwritten;
use crate::TableError;

/// Rows of a sheet below the header.
pub(super) const ROWS: u64 = (1 << 20) - 1;

/// Columns of a sheet.
const COLUMNS: usize = 1 << 14;

/// A workbook that is written.
pub(super) struct Sheet<W> {
    output: W,
    workbook: Workbook,
    rows: u64,
    /// Columns of the table that come from text, in which numbers are to be numbers.
    texts: usize,
    /// The first column of results.
    results: usize,
    formats: Formats,
}

/// Columns of a table by what they hold.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SheetColumns {
    /// So many at the beginning come from text.
    pub(super) texts: usize,
    /// So many at the end are results.
    pub(super) results: usize,
    /// Significant digits that numbers among those are shown with, about.
    pub(super) digits: usize,
}

struct Formats {
    result: Format,
    day: Format,
    moment: Format,
    span: Format,
}

impl<W: Write> Sheet<W> {
    /// Begins a sheet with a header in bold that stays in sight; `rows` is known.
    pub(super) fn create(
        output: W,
        schema: &Schema,
        columns: SheetColumns,
        rows: Option<u64>,
    ) -> Result<Sheet<W>, Unwritten> {
        check_room(rows.unwrap_or_default(), schema.fields().len())?;
        let mut workbook = Workbook::new();
        // Equal tables give equal bytes.
        let created = ExcelDateTime::from_ymd(2000, 1, 1)?;
        workbook.set_properties(&DocProperties::new().set_creation_datetime(&created));
        let sheet = workbook.add_worksheet_with_constant_memory()?;
        let bold = Format::new().set_bold();
        for (column, field) in (0..).zip(schema.fields()) {
            let wide = field.name().chars().count().max(9) + 2;
            sheet.set_column_width(column, wide as f64)?;
        }
        sheet.set_freeze_panes(1, 0)?;
        for (column, field) in (0..).zip(schema.fields()) {
            sheet.write_string_with_format(0, column, field.name(), &bold)?;
        }
        let format = |code: &str| Format::new().set_num_format(code);
        let formats = Formats {
            result: format(&number_format(columns.digits)),
            day: format("yyyy-mm-dd"),
            moment: format("yyyy-mm-dd hh:mm:ss"),
            span: format("[h]:mm:ss"),
        };
        let SheetColumns { texts, results, .. } = columns;
        let results = schema.fields().len().saturating_sub(results);
        Ok(Sheet { output, workbook, rows: 0, texts, results, formats })
    }

    pub(super) fn write(&mut self, batch: &RecordBatch) -> Result<(), Unwritten> {
        check_room(self.rows + batch.num_rows() as u64, batch.num_columns())?;
        let columns = batch.columns().iter().enumerate();
        let columns = columns.map(|(place, column)| Column::of(column, place < self.texts));
        let columns = columns.collect::<Result<Vec<_>, _>>()?;
        let sheet = self.workbook.worksheet_from_index(0)?;
        for row in 0..batch.num_rows() {
            self.rows += 1;
            let at = u32::try_from(self.rows).unwrap_or(u32::MAX);
            for (place, column) in (0..).zip(&columns) {
                column.write(row, sheet, (at, place), usize::from(place) >= self.results, &self.formats)?;
            }
        }
        Ok(())
    }

    /// Writes other sheets behind it.
    pub(super) fn add(
        &mut self,
        write: impl FnOnce(&mut Workbook) -> Result<(), XlsxError>,
    ) -> Result<(), String> {
        write(&mut self.workbook).map_err(|error| error.to_string())
    }

    pub(super) fn finish(mut self) -> Result<W, String> {
        let bytes = self.workbook.save_to_buffer().map_err(|error| error.to_string())?;
        self.output.write_all(&bytes).map_err(|error| error.to_string())?;
        Ok(self.output)
    }
}

/// Format that shows so many significant digits of a number at least; of one below 1, or a negative one, as many as there is room for.
fn number_format(digits: usize) -> String {
    let decimals = |places: usize| match digits.saturating_sub(places) {
        0 => "0".to_owned(),
        count => format!("0.{}", "0".repeat(count)),
    };
    format!("[>=1000]{};[>=1]{};General", decimals(4), decimals(1))
}

fn check_room(rows: u64, columns: usize) -> Result<(), Unwritten> {
    let full = |found, what, room| Err(Unwritten::Table(TableError::SheetFull { found, what, room }));
    if rows > ROWS {
        return full(rows, "rows", ROWS);
    }
    if columns > COLUMNS {
        return full(columns as u64, "columns", COLUMNS as u64);
    }
    Ok(())
}

impl From<XlsxError> for Unwritten {
    fn from(error: XlsxError) -> Unwritten {
        Unwritten::Words(error.to_string())
    }
}

/// A column as a sheet holds it.
enum Column {
    Numbers(Float64Array),
    Truths(BooleanArray),
    /// Days since 1899-12-30.
    Days(Float64Array),
    Moments(Float64Array),
    Spans(Float64Array),
    /// Texts that may be numbers, or stay what they are.
    Texts(StringArray, bool),
}

impl Column {
    fn of(column: &ArrayRef, from_text: bool) -> Result<Column, Unwritten> {
        const DAY: f64 = 86_400_000.0;
        // From the day that sheets count from to 1970.
        const EPOCH: f64 = 25_569.0;
        let to = |kind: &DataType| cast(column, kind).map_err(|error| Unwritten::Words(error.to_string()));
        let moments = || -> Result<Float64Array, Unwritten> {
            let moments = to(&DataType::Timestamp(TimeUnit::Millisecond, None))?;
            let moments = moments.as_primitive::<TimestampMillisecondType>();
            Ok(moments.unary(|moment| moment as f64 / DAY + EPOCH))
        };
        Ok(match column.data_type() {
            // A number of more digits than a sheet keeps stays text.
            DataType::Int64 | DataType::UInt64 if !fits(column)? => {
                Column::Texts(to(&DataType::Utf8)?.as_string::<i32>().clone(), false)
            }
            kind if kind.is_numeric() => {
                Column::Numbers(to(&DataType::Float64)?.as_primitive::<Float64Type>().clone())
            }
            DataType::Boolean => Column::Truths(column.as_boolean().clone()),
            DataType::Date32 | DataType::Date64 => Column::Days(moments()?),
            DataType::Timestamp(..) => Column::Moments(moments()?),
            DataType::Duration(_) => {
                let spans = to(&DataType::Duration(TimeUnit::Millisecond))?;
                let spans = spans.as_primitive::<DurationMillisecondType>();
                Column::Spans(spans.unary(|span| span as f64 / DAY))
            }
            _ => Column::Texts(to(&DataType::Utf8)?.as_string::<i32>().clone(), from_text),
        })
    }

    fn write(
        &self,
        row: usize,
        sheet: &mut Worksheet,
        (at, place): (u32, u16),
        is_result: bool,
        formats: &Formats,
    ) -> Result<(), XlsxError> {
        let is_null = match self {
            Column::Numbers(column)
            | Column::Days(column)
            | Column::Moments(column)
            | Column::Spans(column) => column.is_null(row),
            Column::Truths(column) => column.is_null(row),
            Column::Texts(column, _) => column.is_null(row),
        };
        if is_null {
            return Ok(());
        }
        match self {
            Column::Numbers(column) if column.value(row).is_finite() && is_result => {
                sheet.write_number_with_format(at, place, column.value(row), &formats.result)
            }
            Column::Numbers(column) if column.value(row).is_finite() => {
                sheet.write_number(at, place, column.value(row))
            }
            // A sheet has no infinite numbers.
            Column::Numbers(column) => sheet.write_string(at, place, column.value(row).to_string()),
            Column::Truths(column) => sheet.write_boolean(at, place, column.value(row)),
            Column::Days(column) => {
                sheet.write_number_with_format(at, place, column.value(row), &formats.day)
            }
            Column::Moments(column) => {
                sheet.write_number_with_format(at, place, column.value(row), &formats.moment)
            }
            Column::Spans(column) => {
                sheet.write_number_with_format(at, place, column.value(row), &formats.span)
            }
            Column::Texts(column, may_be_number) => {
                let text = column.value(row);
                match number(text).filter(|_| *may_be_number) {
                    Some(number) => sheet.write_number(at, place, number),
                    None => sheet.write_string(at, place, text),
                }
            }
        }?;
        Ok(())
    }
}

/// True if all numbers of a column are known to their last digit as 64-bit floating-point numbers.
fn fits(column: &ArrayRef) -> Result<bool, Unwritten> {
    let numbers = cast(column, &DataType::Float64).map_err(|error| Unwritten::Words(error.to_string()))?;
    let largest = (1_u64 << 53) as f64;
    Ok(numbers.as_primitive::<Float64Type>().iter().flatten().all(|number| number.abs() <= largest))
}

/// The number that a text is, and not a name of digits such as 007.
fn number(text: &str) -> Option<f64> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let plain = digits.starts_with(|first: char| first.is_ascii_digit())
        && !(digits.len() > 1 && digits.starts_with('0') && !digits.starts_with("0."));
    // More digits than a number keeps are a name too.
    let count = digits.chars().filter(char::is_ascii_digit).count();
    text.parse().ok().filter(|number: &f64| plain && count <= 17 && number.is_finite())
}
