//! Tables as CSV text.

mod cut;

use std::io::{self, Read};
use std::ops::Range;

use csv::{ByteRecord, Reader, ReaderBuilder};

use standfast_cases::sweep::{PLAIN, heading};
use standfast_cases::typed::number_and_rest;

use crate::pieces::Done;
use crate::results::Values;
use crate::row_remarks::RowRemarks;
use crate::task::{Fault, Faults, RowFault, Task};
use crate::{RowProblem, TableError, TableHead, TableOptions};
use cut::{CutError, Pieces};

/// A CSV table, of which the header is read.
pub(crate) struct Text<R> {
    pieces: Pieces<R>,
    first: Option<Vec<u8>>,
    /// The line on which the next piece begins.
    line: u64,
    name: String,
}

/// What parts columns, and the places of a number before and behind its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Separators {
    /// Between columns.
    pub(crate) column: u8,
    /// In numbers.
    pub(crate) decimal: u8,
}

impl Default for Separators {
    fn default() -> Separators {
        Separators { column: b',', decimal: b'.' }
    }
}

impl Separators {
    /// Those of a text whose first line, read as columns parted by commas, is this: a semicolon or a tab in the one column there is parts
    /// others. Numbers have a decimal comma where one of the first row does.
    fn of(names: &[String], bytes: &[u8]) -> Separators {
        let [line] = names else { return Separators::default() };
        let parting = [b';', b'\t'].into_iter().find(|byte| line.as_bytes().contains(byte));
        let Some(column) = parting else { return Separators::default() };
        let mut rows = Rows::new(bytes, Separators { column, decimal: b'.' });
        let has_comma = |field: &[u8]| {
            field.contains(&b',')
                && field.iter().all(|byte| matches!(byte, b'0'..=b'9' | b',' | b'+' | b'-' | b' '))
        };
        // Below the names, or the units.
        let decimal = (0..3).any(|_| rows.advance() && rows.record.iter().any(has_comma));
        Separators { column, decimal: if decimal { b',' } else { b'.' } }
    }
}

/// Header of a table.
pub(crate) struct Header {
    /// The columns' names.
    pub(crate) names: Vec<String>,
    /// Places of the columns of the problem.
    pub(crate) places: Vec<usize>,
    /// The header as it is in the file, without the end of its line.
    pub(crate) bytes: Vec<u8>,
    /// End of its line.
    pub(crate) end: &'static [u8],
    /// What parts its columns.
    pub(crate) separators: Separators,
    /// Task of the rows.
    pub(crate) task: Task,
}

/// Whole rows of the table.
pub(crate) struct Piece {
    pub(crate) bytes: Vec<u8>,
    /// The line on which they begin.
    pub(crate) line: u64,
}

/// The first line of a text.
pub(crate) struct FirstLine {
    /// The columns' names.
    pub(crate) names: Vec<String>,
    /// The line as it is in the file, without its end.
    bytes: Vec<u8>,
    end: &'static [u8],
    /// What parts its columns.
    pub(crate) separators: Separators,
}

impl FirstLine {
    /// An error about the columns of a table: those that are not there may be so because nothing parts them.
    pub(crate) fn refused(&self, name: &str, error: TableError) -> TableError {
        match (&self.names[..], separator(&self.names)) {
            ([header], Some(separator)) => {
                TableError::Separator { name: name.to_owned(), separator, header: header.clone() }
            }
            _ => error,
        }
    }
}

impl<R: Read> Text<R> {
    /// Reads the header. `size` is that of a piece in bytes.
    pub(crate) fn open(
        source: R,
        size: usize,
        options: &TableOptions,
    ) -> Result<(Text<R>, Header), TableError> {
        let (text, line) = Text::begin(source, size, &options.name, options.head, || options.needed())?;
        let task = Task::of(options, &line.names);
        let (task, places) = task.map_err(|error| line.refused(&options.name, error))?;
        let FirstLine { names, bytes, end, separators } = line;
        Ok((text, Header { names, places, bytes, end, separators, task }))
    }

    /// Reads the rows at its head, in which columns are `needed`.
    pub(crate) fn begin(
        mut source: R,
        size: usize,
        name: &str,
        head: TableHead,
        needed: impl Fn() -> String,
    ) -> Result<(Text<R>, FirstLine), TableError> {
        let above = head.row.map_or(0, |row| row.get() - 1);
        let unread = |cause: io::Error| TableError::Read { name: name.to_owned(), cause: cause.to_string() };
        let skipped = skip_lines(&mut source, above).map_err(unread)?;
        let empty = || match head.row {
            Some(row) => TableError::NoHeaderRow { name: name.to_owned(), row: row.get() },
            None => TableError::Empty { name: name.to_owned(), needed: needed() },
        };
        let line = 1 + u64::from(above);
        let mut text = Text { pieces: Pieces::new(source, size), first: None, line, name: name.to_owned() };
        let bytes = if skipped { text.piece()? } else { None }.ok_or_else(empty)?;
        let read = |rows: &Rows<'_>| -> Vec<String> {
            rows.record.iter().map(|name| lossy(name).trim().to_owned()).collect()
        };
        let mut rows = Rows::new(&bytes, Separators::default());
        if !rows.advance() {
            return Err(empty());
        }
        let separators = Separators::of(&read(&rows), &bytes);
        drop(rows);
        let bytes = if separators == Separators::default() {
            bytes
        } else {
            text.pieces.part_by(separators.column, bytes);
            text.piece()?.ok_or_else(empty)?
        };
        let mut rows = Rows::new(&bytes, separators);
        rows.advance();
        let mut names = read(&rows);
        let Range { start, end } = rows.range;
        let line_end: &[u8] = if bytes[end..].starts_with(b"\r\n") { b"\r\n" } else { b"\n" };
        let mut own = bytes[start..end].to_vec();
        if head.has_units {
            let no_units = || TableError::NoUnitsRow { name: name.to_owned() };
            if !rows.advance() {
                return Err(no_units());
            }
            let units = rows.record.iter().map(lossy).chain(std::iter::repeat(String::new()));
            let names_with_units = names.into_iter().zip(units).map(|(name, unit)| with_unit(name, &unit));
            names = names_with_units.collect::<Result<_, _>>()?;
            let mut writer = csv::WriterBuilder::new().delimiter(separators.column).from_writer(Vec::new());
            // Writing to memory never fails.
            writer.write_record(&names).expect("memory has room");
            own = writer.into_inner().expect("memory has room");
            own.truncate(own.trim_ascii_end().len());
        }
        let end = rows.range.end;
        let line = FirstLine { names, bytes: own, end: line_end, separators };
        text.line += feeds(&bytes[..end]);
        text.first = Some(bytes[end..].to_vec());
        Ok((text, line))
    }

    /// The next piece.
    pub(crate) fn next(&mut self) -> Result<Option<Piece>, TableError> {
        let bytes = match self.first.take() {
            Some(first) => Some(first),
            None => self.piece()?,
        };
        Ok(bytes.map(|bytes| {
            let piece = Piece { line: self.line, bytes };
            self.line += feeds(&piece.bytes);
            piece
        }))
    }

    fn piece(&mut self) -> Result<Option<Vec<u8>>, TableError> {
        self.pieces.next().map_err(|error| match error {
            CutError::Read(cause) => TableError::Read { name: self.name.clone(), cause: cause.to_string() },
            CutError::Quote => TableError::Quote { name: self.name.clone(), line: self.line },
        })
    }
}

/// The name of a column with the unit that stands below it, as one that is typed with its unit; without one where nothing is counted.
///
/// # Errors
/// If another unit stands behind the name.
pub(crate) fn with_unit(name: String, unit: &str) -> Result<String, TableError> {
    let unit = unit.trim().trim_matches(['[', ']', '(', ')']).trim();
    let counts_nothing = PLAIN.contains(&unit) || ["–", "—"].contains(&unit);
    if counts_nothing || name.is_empty() {
        return Ok(name);
    }
    match heading(&name) {
        (_, None) if name.ends_with(']') => Ok(name),
        (_, None) => Ok(format!("{name} [{unit}]")),
        (_, Some(own)) if own == unit => Ok(name),
        (_, Some(_)) => Err(TableError::TwoUnits { column: name, unit: unit.to_owned() }),
    }
}

/// Reads so many lines, whatever stands in them; false if there are not as many.
fn skip_lines(source: &mut impl Read, lines: u32) -> io::Result<bool> {
    let mut byte = [0];
    for _ in 0..lines {
        loop {
            match source.read_exact(&mut byte) {
                Ok(()) if byte == *b"\n" => break,
                Ok(()) => {}
                Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => return Ok(false),
                Err(error) => return Err(error),
            }
        }
    }
    Ok(true)
}

/// Separator that seems to part the columns of a header that has one only.
fn separator(names: &[String]) -> Option<&'static str> {
    [('|', "bars")]
        .into_iter()
        .find_map(|(separator, words)| names.iter().any(|name| name.contains(separator)).then_some(words))
}

fn feeds(text: &[u8]) -> u64 {
    memchr::memchr_iter(b'\n', text).count() as u64
}

/// The rows of a piece, one after the other.
pub(crate) struct Rows<'a> {
    bytes: &'a [u8],
    reader: Reader<&'a [u8]>,
    pub(crate) record: ByteRecord,
    /// Place of the row in the piece, without the end of its line.
    range: Range<usize>,
}

impl<'a> Rows<'a> {
    pub(crate) fn new(bytes: &'a [u8], separators: Separators) -> Rows<'a> {
        // A row of the wrong length is for us to report.
        let mut reader = ReaderBuilder::new();
        reader.has_headers(false).flexible(true).delimiter(separators.column);
        let reader = reader.from_reader(bytes);
        Rows { bytes, reader, record: ByteRecord::new(), range: 0..0 }
    }

    pub(crate) fn advance(&mut self) -> bool {
        // Reading from memory never fails.
        if !self.reader.read_byte_record(&mut self.record).unwrap_or(false) {
            return false;
        }
        let is_end = |byte: &u8| matches!(byte, b'\r' | b'\n');
        let read = usize::try_from(self.reader.position().byte()).unwrap_or(self.bytes.len());
        // The reader takes blank lines with the next row, and of CR LF the LF.
        let row = &self.bytes[self.range.end..read];
        let start = self.range.end + row.iter().take_while(|byte| is_end(byte)).count();
        let end = read - row.iter().rev().take_while(|byte| is_end(byte)).count();
        self.range = start..end.max(start);
        true
    }
}

impl Rows<'_> {
    /// That the row has as many fields as there are columns, and that they are text.
    pub(crate) fn check(&self, columns: &[String]) -> Result<(), RowProblem> {
        let record = &self.record;
        if record.len() != columns.len() {
            return Err(RowProblem::Length { found: record.len(), expected: columns.len() });
        }
        if std::str::from_utf8(&self.bytes[self.range.clone()]).is_err() {
            for (field, column) in record.iter().zip(columns) {
                if std::str::from_utf8(field).is_err() {
                    return Err(RowProblem::Encoding { column: column.clone(), value: lossy(field) });
                }
            }
        }
        Ok(())
    }

    /// The line on which the row begins, of a piece that begins on `first`.
    pub(crate) fn line(&self, first: u64) -> u64 {
        first + feeds(&self.bytes[..self.range.start])
    }
}

/// A piece whose rows are found and whose numbers are read.
pub(crate) struct Parsed {
    pub(crate) bytes: Vec<u8>,
    line: u64,
    rows: Vec<Range<usize>>,
    /// The columns of the problem.
    pub(crate) numbers: Vec<Vec<f64>>,
    /// The rows that are not to be answered; empty if there are none.
    skip: Vec<bool>,
    /// Faults of those rows.
    wrong: Vec<(usize, RowProblem)>,
}

impl Header {
    fn parse(&self, Piece { bytes, line }: Piece) -> Parsed {
        let mut found = Rows::new(&bytes, self.separators);
        let mut rows = Vec::new();
        let mut numbers: Vec<Vec<f64>> = vec![Vec::new(); self.places.len()];
        let mut skip = Vec::new();
        let mut wrong = Vec::new();
        while found.advance() {
            let row = rows.len();
            match self.numbers(&found, &mut numbers) {
                Ok(()) if skip.is_empty() => {}
                Ok(()) => skip.push(false),
                Err(problem) => {
                    numbers.iter_mut().for_each(|column| column.resize(row + 1, f64::NAN));
                    skip.resize(row, false);
                    skip.push(true);
                    wrong.push((row, problem));
                }
            }
            rows.push(found.range.clone());
        }
        drop(found);
        Parsed { bytes, line, rows, numbers, skip, wrong }
    }

    /// The rows of a piece with their results.
    pub(crate) fn answer(&self, piece: Piece) -> AnsweredRows {
        let mut parsed = self.parse(piece);
        let mut faults = self.task.faults();
        let mut results = self.task.answer(&parsed.columns(), &parsed.skip, &mut faults);
        let first = parsed.first_problem(self, &faults);
        let bad = faults.count + parsed.wrong.len() as u64;
        let found = faults.all.take().unwrap_or_default();
        let found: Vec<_> = found.iter().map(|fault| (fault.row, parsed.problem(self, fault))).collect();
        let problems = std::mem::take(&mut parsed.wrong).into_iter().chain(found);
        self.task.say_problems(&mut results, parsed.len(), problems);
        AnsweredRows { parsed, results, bad, first, minded: faults.minded }
    }

    /// Appends the numbers of a row to the columns.
    fn numbers(&self, row: &Rows<'_>, numbers: &mut [Vec<f64>]) -> Result<(), RowProblem> {
        let record = &row.record;
        row.check(&self.names)?;
        for (i, (column, &place)) in numbers.iter_mut().zip(&self.places).enumerate() {
            let field = std::str::from_utf8(&record[place]).unwrap_or_default();
            column.push(self.task.read(i, field).map_err(|wrong| self.problem(record, wrong))?);
        }
        Ok(())
    }

    /// Fault of a row, in the table's words.
    fn problem(&self, record: &ByteRecord, wrong: RowFault) -> RowProblem {
        let field = |column: usize| {
            let place = self.places[column];
            (self.names[place].clone(), record.get(place).map(lossy).unwrap_or_default())
        };
        wrong.in_table(field)
    }
}

/// Rows with their results.
pub(crate) struct AnsweredRows {
    pub(crate) parsed: Parsed,
    pub(crate) results: Vec<Values>,
    bad: u64,
    /// The first row without result, its line, and what is wrong with it.
    first: Option<(usize, u64, RowProblem)>,
    minded: RowRemarks,
}

impl AnsweredRows {
    pub(crate) fn first_row(&self) -> Option<usize> {
        self.first.as_ref().map(|(row, ..)| *row)
    }

    pub(crate) fn done<Output>(self, output: Output) -> Done<Output> {
        let AnsweredRows { parsed, bad, first, minded, .. } = self;
        let first = first.map(|(row, line, problem)| (row, Some(line), problem));
        Done { rows: parsed.len(), bad, first, units: parsed.bytes.len() as u64, minded, output }
    }
}

impl Parsed {
    pub(crate) fn len(&self) -> usize {
        self.rows.len()
    }

    /// The columns of the problem.
    fn columns(&self) -> Vec<&[f64]> {
        self.numbers.iter().map(Vec::as_slice).collect()
    }

    /// The first row without result, its line, and what is wrong with it.
    fn first_problem(&self, header: &Header, faults: &Faults) -> Option<(usize, u64, RowProblem)> {
        let fault = faults.first.as_ref().map(|fault| (fault.row, Err(fault)));
        let wrong = self.wrong.first().map(|(row, problem)| (*row, Ok(problem)));
        let (row, what) = fault.into_iter().chain(wrong).min_by_key(|(row, _)| *row)?;
        let problem = what.map_or_else(|fault| self.problem(header, fault), RowProblem::clone);
        Some((row, self.line + feeds(&self.bytes[..self.rows[row].start]), problem))
    }

    fn problem(&self, header: &Header, fault: &Fault) -> RowProblem {
        let mut row = Rows::new(&self.bytes[self.rows[fault.row].clone()], header.separators);
        row.advance();
        header.problem(&row.record, fault.wrong.clone())
    }

    /// The first `rows` rows as they are, each followed by its results.
    pub(crate) fn write(&self, header: &Header, results: &[Values], rows: usize) -> Vec<u8> {
        let mut text = Vec::with_capacity(self.bytes.len() + rows * 24 * results.len());
        let mut fields = Vec::new();
        for (row, range) in self.rows[..rows].iter().enumerate() {
            let bytes = &self.bytes[range.clone()];
            match self.skip.get(row) {
                Some(true) => {
                    fill_up(bytes, header.names.len(), header.separators, &mut fields);
                    text.extend_from_slice(&fields);
                }
                _ => text.extend_from_slice(bytes),
            }
            for values in results {
                text.push(header.separators.column);
                values.push_field(row, header.separators, &mut text);
            }
            text.extend_from_slice(header.end);
        }
        text
    }
}

/// A row with as many fields as the header has.
fn fill_up(row: &[u8], length: usize, separators: Separators, text: &mut Vec<u8>) {
    text.clear();
    let mut rows = Rows::new(row, separators);
    rows.advance();
    if rows.record.len() == length {
        text.extend_from_slice(row);
        return;
    }
    rows.record.truncate(length);
    (rows.record.len()..length).for_each(|_| rows.record.push_field(b""));
    let mut writer = csv::WriterBuilder::new().delimiter(separators.column).from_writer(std::mem::take(text));
    // Writing to memory never fails.
    let _ = writer.write_byte_record(&rows.record);
    *text = writer.into_inner().unwrap_or_default();
    text.truncate(text.len().saturating_sub(1));
}

/// The number that a field holds.
pub(crate) fn number(field: &str) -> Option<f64> {
    let field = field.trim();
    // With a decimal comma, as far as it is one number.
    let by_comma =
        || number_and_rest(field).ok().filter(|(_, rest)| rest.is_empty()).map(|(number, _)| number);
    field.parse().ok().or_else(by_comma)
}

pub(crate) fn lossy(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
