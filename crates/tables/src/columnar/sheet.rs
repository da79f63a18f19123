//! The table of a sheet of an Excel workbook, as columns of Arrow: cached values of formulas, empty cells as nulls.

use std::fs::File;
use std::io::{BufReader, Read, Seek};
use std::sync::Arc;

use arrow_array::{
    ArrayRef, BooleanArray, Date32Array, DurationMillisecondArray, Float64Array, Int64Array, RecordBatch,
    StringArray, TimestampMillisecondArray,
};
use arrow_schema::{Field, Schema};
use calamine::{DataRef, ExcelDateTime, Reader, Xlsx};

use super::unpacked;
use super::workbook::ROWS;
use crate::text::with_unit;
use crate::{TableError, TableOptions};

/// Value of a cell.
enum Cell {
    Empty,
    Number(f64),
    Truth(bool),
    /// Milliseconds since 1970.
    Moment(i64),
    /// Milliseconds; also a time of day.
    Span(i64),
    /// Also the word of an error, as `#N/A`.
    Text(String),
}

/// Words in place of the value of a formula that no program has kept in the workbook.
const NOT_KEPT: &str = "a formula without its value; open the workbook in a spreadsheet and save it";

/// Characters of a cell, as Excel has it.
const CHARACTERS: usize = 32_767;

/// Bytes of all texts of a sheet: a text that is kept once may stand in each of its cells.
const TEXTS: usize = 1 << 30;

/// Cells of a sheet, empty ones among its columns and rows too: sixty columns of all its rows.
const CELLS: usize = 1 << 26;

const DAY: i64 = 86_400_000;

/// The table of the sheet that the options name, or the first, and the last row of its head, counted from one.
pub(super) fn read(file: File, options: &TableOptions) -> Result<(RecordBatch, u64), TableError> {
    unpacked::check(&file, options, unpacked::LIMITS)?;
    let damaged = |error: calamine::XlsxError| options.damaged(error.to_string());
    let mut workbook: Xlsx<_> = Xlsx::new(BufReader::new(file)).map_err(damaged)?;
    let sheet = sheet(&workbook, options)?;
    let mut cells = workbook.worksheet_cells_reader(&sheet).map_err(damaged)?;
    let above = options.head.row.map_or(0, |row| row.get() - 1);
    let below = 1 + u32::from(options.head.has_units);
    let mut header: Option<u32> = options.head.row.map(|_| above);
    // The columns of the sheet that have a name, with their cells so far.
    let mut columns: Vec<(u32, String, Vec<Cell>)> = Vec::new();
    let (mut rows, mut room) = (0, Room { options, sheet: &sheet, texts: 0 });
    while let Some(cell) = cells.next_cell().map_err(damaged)? {
        let value = Cell::of(cell.get_value());
        let (row, column) = cell.get_position();
        if matches!(value, Cell::Empty) || row < above {
            continue;
        }
        room.hold(&value, row, column)?;
        let header = *header.get_or_insert(row);
        if row == header {
            columns.push((column, value.words().trim().to_owned(), Vec::new()));
            continue;
        }
        let Ok(place) = columns.binary_search_by_key(&column, |(column, ..)| *column) else {
            let cell = format!("{}{}", letters(column), row + 1);
            return Err(TableError::Nameless {
                name: options.name.clone(),
                cell,
                header: u64::from(header) + 1,
            });
        };
        if options.head.has_units && row == header + 1 {
            let name = &mut columns[place].1;
            *name = with_unit(std::mem::take(name), &value.words())?;
            continue;
        }
        let width = columns.len();
        let cells = &mut columns[place].2;
        // Rows rise in a sheet, and there are no more of them; what says otherwise is not a sheet.
        let index =
            row.checked_sub(header + below).filter(|_| u64::from(row) <= ROWS).map(|index| index as usize);
        let Some(index) = index.filter(|index| cells.len() <= *index) else {
            return Err(options.damaged("its cells are not in the order of rows".to_owned()));
        };
        rows = rows.max(index + 1);
        room.hold_all(rows * width)?;
        cells.resize_with(index, || Cell::Empty);
        cells.push(value);
    }
    if let Some(row) = options.head.row.filter(|_| columns.is_empty()) {
        return Err(TableError::NoHeaderRow { name: options.name.clone(), row: row.get() });
    }
    let Some(header) = header else {
        return Err(TableError::Empty { name: options.name.clone(), needed: options.needed() });
    };
    drop(cells);
    for (.., cells) in &mut columns {
        cells.resize_with(rows, || Cell::Empty);
    }
    let has_empty = columns.iter().any(|(.., cells)| cells.iter().any(|cell| matches!(cell, Cell::Empty)));
    if has_empty {
        let mut formulas = workbook.worksheet_cells_reader(&sheet).map_err(damaged)?;
        while let Some(formula) = formulas.next_formula().map_err(damaged)? {
            let (row, column) = formula.get_position();
            let Ok(place) = columns.binary_search_by_key(&column, |(column, ..)| *column) else { continue };
            let index = row.checked_sub(header + below).map(|index| index as usize);
            let cell = index.and_then(|index| columns[place].2.get_mut(index));
            if let Some(cell @ Cell::Empty) = cell.filter(|_| !formula.get_value().is_empty()) {
                *cell = Cell::Text(NOT_KEPT.to_owned());
            }
        }
    }
    let (fields, arrays): (Vec<_>, Vec<_>) = columns
        .into_iter()
        .map(|(_, name, cells)| {
            let array = array(cells);
            (Field::new(name, array.data_type().clone(), true), array)
        })
        .unzip();
    let batch = RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays);
    Ok((batch.map_err(|error| options.damaged(error.to_string()))?, u64::from(header + below)))
}

/// Room left for the texts of a sheet.
struct Room<'a> {
    options: &'a TableOptions,
    sheet: &'a str,
    /// Bytes.
    texts: usize,
}

impl Room<'_> {
    /// One more cell.
    fn hold(&mut self, cell: &Cell, row: u32, column: u32) -> Result<(), TableError> {
        let Cell::Text(text) = cell else { return Ok(()) };
        let characters = text.chars().count();
        if characters > CHARACTERS {
            let cell = format!("cell {}{}", letters(column), row + 1);
            return self.too_large(cell, characters, "characters", CHARACTERS);
        }
        self.texts += text.len();
        if self.texts > TEXTS {
            return self.too_large(format!("sheet {}", self.sheet), self.texts, "bytes of text", TEXTS);
        }
        Ok(())
    }

    /// So many cells, empty ones among them.
    fn hold_all(&self, cells: usize) -> Result<(), TableError> {
        if cells > CELLS {
            return self.too_large(format!("sheet {}", self.sheet), cells, "cells", CELLS);
        }
        Ok(())
    }

    fn too_large(
        &self,
        part: String,
        found: usize,
        what: &'static str,
        most: usize,
    ) -> Result<(), TableError> {
        let (name, found, most) = (self.options.name.clone(), found as u64, most as u64);
        Err(TableError::TooLarge { name, part, found, what, most })
    }
}

/// The name of the sheet to be read.
fn sheet<R: Read + Seek>(workbook: &Xlsx<R>, options: &TableOptions) -> Result<String, TableError> {
    let sheets = workbook.sheet_names();
    let wanted = match &options.sheet {
        Some(sheet) => sheets.iter().find(|name| *name == sheet),
        None => sheets.first(),
    };
    wanted.cloned().ok_or_else(|| TableError::NoSheet {
        name: options.name.clone(),
        sheet: options.sheet.clone().unwrap_or_default(),
        sheets: sheets.join(", "),
    })
}

/// The letters of a column, counted from zero.
fn letters(column: u32) -> String {
    let last = char::from(b'A' + (column % 26) as u8);
    match column / 26 {
        0 => last.to_string(),
        before => letters(before - 1) + &last.to_string(),
    }
}

impl Cell {
    fn of(value: &DataRef<'_>) -> Cell {
        match value {
            DataRef::Int(number) => Cell::Number(*number as f64),
            DataRef::Float(number) => Cell::Number(*number),
            DataRef::Bool(truth) => Cell::Truth(*truth),
            DataRef::String(text) if text.is_empty() => Cell::Empty,
            DataRef::String(text) => Cell::Text(text.clone()),
            DataRef::SharedString("") | DataRef::Empty => Cell::Empty,
            DataRef::SharedString(text) => Cell::Text((*text).to_owned()),
            DataRef::DateTime(time) => Cell::time(time),
            DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => Cell::Text(text.clone()),
            DataRef::Error(error) => Cell::Text(error.to_string()),
        }
    }

    fn time(time: &ExcelDateTime) -> Cell {
        let days = time.as_f64();
        if time.is_duration() || (0.0..1.0).contains(&days) {
            return Cell::Span((days * DAY as f64).round() as i64);
        }
        let (year, month, day, hours, minutes, seconds, milliseconds) = time.to_ymd_hms_milli();
        let seconds = (i64::from(hours) * 60 + i64::from(minutes)) * 60 + i64::from(seconds);
        Cell::Moment(
            days_since_1970(year.into(), month.into(), day.into()) * DAY
                + seconds * 1000
                + i64::from(milliseconds),
        )
    }

    /// The cell as text, where its column holds more than one kind.
    fn words(&self) -> String {
        match self {
            Cell::Empty => String::new(),
            Cell::Number(number) if is_whole(*number) => format!("{number}"),
            Cell::Number(number) => ryu::Buffer::new().format(*number).to_owned(),
            Cell::Truth(truth) => truth.to_string(),
            Cell::Moment(moment) => {
                let moment = TimestampMillisecondArray::from(vec![*moment]);
                moment.value_as_datetime(0).map_or_else(String::new, |moment| moment.to_string())
            }
            Cell::Span(span) => {
                let seconds = *span as f64 / 1000.0;
                format!("{seconds} s")
            }
            Cell::Text(text) => text.clone(),
        }
    }
}

/// Days from 1970-01-01 to a day of the Gregorian calendar, by whole periods of 400 years that begin in March.
fn days_since_1970(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let period = year.div_euclid(400);
    let in_period = year.rem_euclid(400);
    let in_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    period * 146_097 + in_period * 365 + in_period / 4 - in_period / 100 + in_year - 719_468
}

/// True if a number is whole, and known to its last digit.
fn is_whole(number: f64) -> bool {
    number.fract() == 0.0 && number.abs() < (1_u64 << 53) as f64
}

/// A column of the kind that all its cells are, or else of text.
fn array(cells: Vec<Cell>) -> ArrayRef {
    let all = |is_it: fn(&Cell) -> bool| cells.iter().all(|cell| matches!(cell, Cell::Empty) || is_it(cell));
    let times = || {
        cells.iter().map(|cell| match cell {
            Cell::Moment(time) | Cell::Span(time) => Some(*time),
            _ => None,
        })
    };
    let numbers = || {
        cells.iter().map(|cell| match cell {
            Cell::Number(number) => Some(*number),
            _ => None,
        })
    };
    if all(|_| false) {
        return Arc::new(Float64Array::new_null(cells.len()));
    }
    if all(|cell| matches!(cell, Cell::Number(number) if is_whole(*number))) {
        return Arc::new(numbers().map(|number| number.map(|number| number as i64)).collect::<Int64Array>());
    }
    if all(|cell| matches!(cell, Cell::Number(_))) {
        return Arc::new(numbers().collect::<Float64Array>());
    }
    if all(|cell| matches!(cell, Cell::Moment(moment) if moment % DAY == 0)) {
        let days = times().map(|time| time.and_then(|time| i32::try_from(time / DAY).ok()));
        return Arc::new(days.collect::<Date32Array>());
    }
    if all(|cell| matches!(cell, Cell::Moment(_))) {
        return Arc::new(times().collect::<TimestampMillisecondArray>());
    }
    if all(|cell| matches!(cell, Cell::Span(_))) {
        return Arc::new(times().collect::<DurationMillisecondArray>());
    }
    if all(|cell| matches!(cell, Cell::Truth(_))) {
        let truths = cells.iter().map(|cell| match cell {
            Cell::Truth(truth) => Some(*truth),
            _ => None,
        });
        return Arc::new(truths.collect::<BooleanArray>());
    }
    let texts = cells.iter().map(|cell| (!matches!(cell, Cell::Empty)).then(|| cell.words()));
    Arc::new(texts.collect::<StringArray>())
}
