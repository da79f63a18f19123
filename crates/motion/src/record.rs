//! Files of recorded motion: CSV with units in its header, PEER's AT2, the SMC of the USGS.

use std::fmt;

use standfast::history::{History, HistoryError};
use standfast::number::exact;

/// The unit of a record's values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecordUnit {
    /// The acceleration of gravity: that of the case that the record goes with.
    Gravity,
    /// m/s².
    MetrePerSecondSquared,
    /// cm/s².
    CentimetrePerSecondSquared,
    /// N.
    Newton,
    /// kN.
    Kilonewton,
    /// MN.
    Meganewton,
    /// N per metre run.
    NewtonPerMetre,
    /// kN per metre run.
    KilonewtonPerMetre,
    /// MN per metre run.
    MeganewtonPerMetre,
    /// A share of what the load has itself: the column is called share.
    Share,
    /// None is given.
    Unnamed,
}

impl RecordUnit {
    const NAMED: [(&'static str, RecordUnit); 10] = [
        ("g", RecordUnit::Gravity),
        ("m_s2", RecordUnit::MetrePerSecondSquared),
        ("cm_s2", RecordUnit::CentimetrePerSecondSquared),
        ("gal", RecordUnit::CentimetrePerSecondSquared),
        ("n", RecordUnit::Newton),
        ("kn", RecordUnit::Kilonewton),
        ("mn", RecordUnit::Meganewton),
        ("n_m", RecordUnit::NewtonPerMetre),
        ("kn_m", RecordUnit::KilonewtonPerMetre),
        ("mn_m", RecordUnit::MeganewtonPerMetre),
    ];

    /// So many SI units is one of it, where `gravity` is the acceleration of gravity (m/s²); 1 if it has no name.
    pub fn si(self, gravity: f64) -> f64 {
        match self {
            RecordUnit::Gravity => gravity,
            RecordUnit::CentimetrePerSecondSquared => 0.01,
            RecordUnit::Kilonewton | RecordUnit::KilonewtonPerMetre => 1e3,
            RecordUnit::Meganewton | RecordUnit::MeganewtonPerMetre => 1e6,
            RecordUnit::MetrePerSecondSquared
            | RecordUnit::Newton
            | RecordUnit::NewtonPerMetre
            | RecordUnit::Share
            | RecordUnit::Unnamed => 1.0,
        }
    }

    /// True if the unit is one of a force per metre run.
    pub fn is_per_metre(self) -> bool {
        matches!(
            self,
            RecordUnit::NewtonPerMetre | RecordUnit::KilonewtonPerMetre | RecordUnit::MeganewtonPerMetre
        )
    }

    /// True if the unit is one of acceleration.
    pub fn is_acceleration(self) -> bool {
        matches!(
            self,
            RecordUnit::Gravity | RecordUnit::MetrePerSecondSquared | RecordUnit::CentimetrePerSecondSquared
        )
    }
}

/// A recorded history.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Times, s.
    pub times: Vec<f64>,
    /// Values in their unit.
    pub values: Vec<f64>,
    /// The unit.
    pub unit: RecordUnit,
}

/// Fault of a record file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{file}{}: {problem}", Line(*line))]
pub struct RecordError {
    /// The file.
    pub file: String,
    /// The line, from 1; `None` for the whole.
    pub line: Option<usize>,
    /// Fault found there.
    pub problem: RecordProblem,
}

struct Line(Option<usize>);

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |line| write!(f, ", line {line}"))
    }
}

/// Fault of a line of a record, or of all of it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RecordProblem {
    /// A word where a number should be.
    #[error("\"{0}\" is not a number")]
    NotANumber(String),
    /// NaN or infinite.
    #[error("\"{0}\" is not a finite number")]
    NotFinite(String),
    /// A time that does not rise.
    #[error("the time {found} is not after {before}; expected times that rise")]
    NotRising {
        /// The time.
        found: String,
        /// That before it.
        before: String,
    },
    /// Not as many values as the header says.
    #[error("the header says {said} values, and there are {found}")]
    Count {
        /// By the header.
        said: usize,
        /// In the file.
        found: usize,
    },
    /// A header that is not understood.
    #[error("\"{found}\" is not understood; expected {expected}")]
    Header {
        /// Text found.
        found: String,
        /// Text expected.
        expected: &'static str,
    },
    /// A unit that is missing or unknown.
    #[error(
        "the column \"{column}\" names no unit that is known; expected a name that ends in _g, _m_s2, _cm_s2, _N, _kN, _MN, _N_m, _kN_m or _MN_m"
    )]
    Unit {
        /// The column.
        column: String,
    },
    /// A column that there is not.
    #[error("there is no column \"{column}\"; there are {found}")]
    Column {
        /// The column.
        column: String,
        /// The columns.
        found: String,
    },
    /// Several columns of values, and none named.
    #[error("there are several columns of values: {found}; name one with `column`")]
    Columns {
        /// The columns.
        found: String,
    },
    /// Two columns of one name.
    #[error("there are two columns \"{column}\"; expected names that differ")]
    TwoColumns {
        /// The column.
        column: String,
    },
    /// A row with more or fewer cells than the header.
    #[error(
        "the row {row} has {found} cells; expected {expected}{}", too_many(*found > *expected)
    )]
    Row {
        /// The row.
        row: String,
        /// Cells.
        found: usize,
        /// Columns.
        expected: usize,
    },
    /// A number with commas in it.
    #[error("\"{0}\" is written with a comma; expected a decimal point and nothing between thousands")]
    Comma(String),
    /// A quote that holds no cell together.
    #[error(
        "{0}: a quote does not open or close a cell; expected both quotes of a cell on its line, right beside the separators"
    )]
    Quote(String),
    /// Values without times, and no step given.
    #[error("there is no column of times; expected `time_s` first, or the step `dt`")]
    NoTimes,
    /// A time that is hardly after that before it.
    #[error("the time {found} is less than 1e-9 s after {before}; expected times in s")]
    Close {
        /// The time.
        found: String,
        /// That before it.
        before: String,
    },
    /// Lines that end in an old way.
    #[error("its lines end in CR alone; expected LF or CR LF")]
    LineEnds,
    /// Text in another encoding.
    #[error("it has bytes of value 0, as UTF-16 text has; expected UTF-8")]
    Encoding,
    /// Too short.
    #[error("{0} values; expected two at least")]
    TooShort(usize),
    /// A step that is none.
    #[error("the step of time is {0}; expected a number of seconds, 1e-9 at least")]
    Step(String),
    /// Nothing there.
    #[error("the file is empty")]
    Empty,
}

fn too_many(are: bool) -> &'static str {
    if are { ", as the header has, and numbers with a decimal point, not a comma" } else { "" }
}

/// Function subtracted from a record of acceleration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Baseline {
    /// Its mean.
    Mean,
    /// The line nearest to it by least squares.
    Linear,
}

impl Record {
    /// Reads a record: AT2 and SMC are known by their headers, everything else is taken as CSV, of which `column` is read, or the only
    /// one beside the times; `dt` is the step of a file without times.
    ///
    /// # Errors
    /// See [`RecordProblem`], with file and line.
    pub fn parse(
        file: &str,
        text: &str,
        column: Option<&str>,
        dt: Option<f64>,
    ) -> Result<Record, RecordError> {
        let at = |line: Option<usize>, problem| RecordError { file: file.to_owned(), line, problem };
        let lines: Vec<&str> = text.lines().collect();
        if text.trim().is_empty() {
            return Err(at(None, RecordProblem::Empty));
        }
        if text.contains('\0') {
            return Err(at(None, RecordProblem::Encoding));
        }
        if !text.contains('\n') && text.trim_end().contains('\r') {
            return Err(at(None, RecordProblem::LineEnds));
        }
        let third = lines.get(2).map_or("", |line| line).to_uppercase();
        let read = if third.contains("UNITS OF") {
            at2(&lines)
        } else if lines.iter().take(40).any(|line| line.starts_with('|'))
            && lines.get(11).is_some_and(|l| l.contains("-32768"))
        {
            smc(&lines)
        } else {
            csv(&lines, column, dt)
        };
        let record = read.map_err(|(line, problem)| at(line, problem))?;
        if record.values.len() < 2 {
            return Err(at(None, RecordProblem::TooShort(record.values.len())));
        }
        Ok(record)
    }

    /// The largest magnitude, in its unit.
    pub fn peak(&self) -> f64 {
        self.values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
    }

    /// The record with its baseline taken off.
    #[must_use]
    pub fn corrected(mut self, baseline: Baseline) -> Record {
        let n = self.values.len() as f64;
        let mean = self.values.iter().sum::<f64>() / n;
        let middle = self.times.iter().sum::<f64>() / n;
        let (mut tt, mut ta) = (0.0, 0.0);
        for (t, a) in self.times.iter().zip(&self.values) {
            tt += (t - middle) * (t - middle);
            ta += (t - middle) * (a - mean);
        }
        let slope = if baseline == Baseline::Linear { ta / tt } else { 0.0 };
        for (t, a) in self.times.iter().zip(&mut self.values) {
            *a -= mean + slope * (t - middle);
        }
        self
    }

    /// The ground's velocity and displacement at the end, in the unit of the values times s and s².
    pub fn drift(&self) -> [f64; 2] {
        let (mut v, mut x) = (0.0, 0.0);
        for (t, a) in self.times.windows(2).zip(self.values.windows(2)) {
            let h = t[1] - t[0];
            x += v * h + h * h * (2.0 * a[0] + a[1]) / 6.0;
            v += h * (a[0] + a[1]) / 2.0;
        }
        [v, x]
    }

    /// The history, with values times a factor; times as they are.
    ///
    /// # Errors
    /// As [`History::points`].
    pub fn history(&self, factor: f64) -> Result<History, HistoryError> {
        Ok(History::points(&self.times, &self.values)?.times_factor(factor))
    }
}

type ReadRecord = Result<Record, (Option<usize>, RecordProblem)>;

fn number(word: &str, line: usize) -> Result<f64, (Option<usize>, RecordProblem)> {
    let found: f64 = word.parse().map_err(|_| {
        let is_number = word.contains(',') && word.replace(',', "").parse::<f64>().is_ok();
        let problem = match is_number {
            true => RecordProblem::Comma,
            false if word.contains('"') => RecordProblem::Quote,
            false => RecordProblem::NotANumber,
        };
        (Some(line), problem(short(word)))
    })?;
    if found.is_finite() { Ok(found) } else { Err((Some(line), RecordProblem::NotFinite(short(word)))) }
}

fn short(word: &str) -> String {
    let plain = |c: char| if c.is_control() { '\u{fffd}' } else { c };
    let mut short: String = word.chars().take(60).map(plain).collect();
    if short.len() < word.len() {
        short.push('…');
    }
    short
}

/// The least time between two values, s: what records have is a million times as much.
const LEAST_STEP: f64 = 1e-9;

fn step(dt: f64) -> Result<(), RecordProblem> {
    if dt >= LEAST_STEP && dt.is_finite() { Ok(()) } else { Err(RecordProblem::Step(exact(dt).to_string())) }
}

fn evenly(dt: f64, values: Vec<f64>, unit: RecordUnit) -> Record {
    Record { times: (0..values.len()).map(|i| i as f64 * dt).collect(), values, unit }
}

/// PEER's AT2: four lines, of which the third has the unit and the fourth count and step, in either of two forms.
fn at2(lines: &[&str]) -> ReadRecord {
    let third = lines[2].to_uppercase();
    let named = third.split("UNITS OF").nth(1).unwrap_or("").trim();
    let unit = match named.trim_end_matches('.').trim() {
        "G" => RecordUnit::Gravity,
        "CM/S2" | "CM/S/S" | "CM/SEC2" | "GAL" => RecordUnit::CentimetrePerSecondSquared,
        "M/S2" | "M/S/S" => RecordUnit::MetrePerSecondSquared,
        _ => {
            let expected = "ACCELERATION TIME SERIES IN UNITS OF G";
            return Err((Some(3), RecordProblem::Header { found: short(lines[2].trim()), expected }));
        }
    };
    let fourth = lines.get(3).map_or("", |line| line);
    let header = || {
        let expected = "NPTS= 4000, DT= .01 SEC, or 4000 0.01 NPTS, DT";
        (Some(4), RecordProblem::Header { found: short(fourth.trim()), expected })
    };
    let upper = fourth.to_uppercase();
    let words: Vec<&str> = upper
        .split(|c: char| c.is_whitespace() || c == ',' || c == '=')
        .filter(|word| !word.is_empty())
        .collect();
    let numbers: Vec<f64> = words.iter().filter_map(|word| word.parse().ok()).collect();
    let has = |name: &str| words.contains(&name);
    let [count, dt] = numbers[..] else { return Err(header()) };
    if !(has("NPTS") && has("DT")) || count.fract() != 0.0 || count < 0.0 {
        return Err(header());
    }
    step(dt).map_err(|problem| (Some(4), problem))?;
    let mut values = Vec::with_capacity((count as usize).min(1 << 20));
    for (i, line) in lines.iter().enumerate().skip(4) {
        for word in line.split_whitespace() {
            values.push(number(word, i + 1)?);
        }
    }
    if values.len() != count as usize {
        return Err((None, RecordProblem::Count { said: count as usize, found: values.len() }));
    }
    Ok(evenly(dt, values, unit))
}

/// The SMC format of the USGS: 11 lines of text, 6 of integers, 10 of reals, comments, then values of ten columns each, in cm/s².
fn smc(lines: &[&str]) -> ReadRecord {
    let fields = |range: std::ops::Range<usize>, width: usize| {
        let mut all = Vec::new();
        for i in range {
            let line = lines.get(i).copied().unwrap_or("");
            for cell in cells(line, width) {
                all.push(number(cell.trim(), i + 1)?);
            }
        }
        Ok::<_, (Option<usize>, RecordProblem)>(all)
    };
    let integers = fields(11..17, 10)?;
    let reals = fields(17..27, 15)?;
    let (Some(comments), Some(count), Some(rate)) = (integers.get(15), integers.get(16), reals.get(1)) else {
        let expected = "6 lines of integers and 10 of reals after 11 lines of text";
        return Err((
            Some(12),
            RecordProblem::Header { found: short(lines.get(11).map_or("", |l| l.trim())), expected },
        ));
    };
    if !(*rate > 0.0 && *rate < 1e6) {
        return Err((Some(18), RecordProblem::Step(format!("1/{rate}"))));
    }
    let first = 27 + comments.max(0.0) as usize;
    let mut values = Vec::new();
    for (i, line) in lines.iter().enumerate().skip(first) {
        for cell in cells(line, 10) {
            values.push(number(cell.trim(), i + 1)?);
        }
    }
    let said = count.max(0.0) as usize;
    if values.len() != said {
        return Err((None, RecordProblem::Count { said, found: values.len() }));
    }
    Ok(evenly(1.0 / rate, values, RecordUnit::CentimetrePerSecondSquared))
}

/// The cells of so many characters each of a line, without the empty ones at its end.
fn cells(line: &str, width: usize) -> impl Iterator<Item = &str> {
    let line = line.trim_end();
    let ends = (0..line.len().div_ceil(width)).map(move |i| i * width);
    ends.filter_map(move |start| line.get(start..(start + width).min(line.len())))
}

/// Columns of a CSV: their names, and the places of the times and the values.
struct Columns<'a> {
    names: Vec<&'a str>,
    time: Option<usize>,
    value: usize,
}

impl<'a> Columns<'a> {
    fn of(names: Vec<&'a str>, column: Option<&str>) -> Result<Columns<'a>, RecordProblem> {
        if let Some(name) =
            names.iter().enumerate().find_map(|(i, name)| names[..i].iter().find(|n| *n == name))
        {
            return Err(RecordProblem::TwoColumns { column: short(name) });
        }
        if let Some(name) = names.iter().find(|name| name.contains('"')) {
            return Err(RecordProblem::Quote(short(name)));
        }
        let is_time = |name: &str| {
            let name = name.to_lowercase();
            let (word, unit) = bracketed(&name).unwrap_or((&name, "s"));
            unit == "s" && ["time_s", "t_s", "time", "t"].contains(&word)
        };
        let time = names.iter().position(|name| is_time(name));
        let others: Vec<usize> = (0..names.len()).filter(|i| Some(*i) != time).collect();
        let listed = || {
            let more = if others.len() > LISTED { ", …" } else { "" };
            let listed = others.iter().take(LISTED).map(|i| format!("\"{}\"", short(names[*i])));
            listed.collect::<Vec<_>>().join(", ") + more
        };
        let value = match column {
            Some(column) => others
                .iter()
                .copied()
                .find(|i| names[*i] == column)
                .ok_or_else(|| RecordProblem::Column { column: column.to_owned(), found: listed() })?,
            None if others.len() == 1 => others[0],
            None => return Err(RecordProblem::Columns { found: listed() }),
        };
        Ok(Columns { names, time, value })
    }

    /// The unit that the heading of the values names: behind a line below (`a_g`), in brackets (`acc [m/s²]`), or alone (`g`).
    fn unit(&self) -> RecordUnit {
        let heading = self.names[self.value].to_lowercase();
        let bracketed = bracketed(&heading);
        let name = match bracketed {
            // Some write that a record is in g's.
            Some((_, unit)) => {
                unit.trim_end_matches("'s").replace('/', "_").replace('²', "2").replace('^', "")
            }
            None => heading.clone(),
        };
        let is_named = |unit: &str, of: RecordUnit| match bracketed {
            Some(_) => name == unit,
            None => name.ends_with(&format!("_{unit}")) || (of.is_acceleration() && name == unit),
        };
        let known = RecordUnit::NAMED.iter().filter(|(unit, of)| is_named(unit, *of));
        let unit = known.max_by_key(|(unit, _)| unit.len()).map(|(_, unit)| *unit);
        unit.unwrap_or(if name == "share" { RecordUnit::Share } else { RecordUnit::Unnamed })
    }
}

/// The word of a heading, and the unit in brackets behind it.
fn bracketed(heading: &str) -> Option<(&str, &str)> {
    let (word, unit) = heading.strip_suffix([']', ')'])?.rsplit_once(['[', '('])?;
    Some((word.trim(), unit.trim()))
}

/// So many names of columns are listed at most.
const LISTED: usize = 12;

/// Cuts lines into cells; quotes may hold a cell together.
struct Cutter {
    reader: csv_core::Reader,
    text: Vec<u8>,
    ends: Vec<usize>,
}

impl Cutter {
    fn of(separator: u8) -> Cutter {
        let reader = csv_core::ReaderBuilder::new().delimiter(separator).build();
        Cutter { reader, text: Vec::new(), ends: Vec::new() }
    }

    /// The cells of a line, which is not empty.
    fn cells(&mut self, line: &str) -> Result<Vec<&str>, RecordProblem> {
        self.text.resize(self.text.len().max(line.len() + 1), 0);
        self.ends.resize(self.ends.len().max(line.len() + 1), 0);
        let (_, _, text, ends) = self.reader.read_record(line.as_bytes(), &mut self.text, &mut self.ends);
        // Within quotes, the end of the line does not end the row.
        let (ended, _, _, last) =
            self.reader.read_record(b"\n", &mut self.text[text..], &mut self.ends[ends..]);
        if ended != csv_core::ReadRecordResult::Record {
            return Err(RecordProblem::Quote(short(line)));
        }
        let ends = &self.ends[..ends + last];
        let starts = [0].into_iter().chain(ends.iter().copied());
        let cells = starts.zip(ends).map(|(start, end)| std::str::from_utf8(&self.text[start..*end]));
        Ok(cells.map(|cell| cell.unwrap_or_default().trim()).collect())
    }
}

/// The cells of a line, each by itself.
fn cut(line: &str, separator: u8) -> Result<Vec<String>, RecordProblem> {
    Ok(Cutter::of(separator).cells(line)?.into_iter().map(str::to_owned).collect())
}

fn csv(lines: &[&str], column: Option<&str>, dt: Option<f64>) -> ReadRecord {
    // Lines that are empty or comments do not count; the first of the others is the header.
    let numbered =
        || lines.iter().enumerate().map(|(i, line)| (i + 1, line.trim_start_matches('\u{feff}').trim()));
    let mut rows = numbered().filter(|(_, line)| !line.is_empty() && !line.starts_with('#')).peekable();
    let Some(&(mut at, header)) = rows.peek() else { return Err((None, RecordProblem::Empty)) };
    let separator = [b';', b'\t'].into_iter().find(|c| header.as_bytes().contains(c)).unwrap_or(b',');
    let mut names = cut(header, separator).map_err(|problem| (Some(at), problem))?;
    if names.iter().all(|name| name.parse::<f64>().is_ok()) {
        // The last comment above the numbers is their header where it has as many names, as pySLAMMER writes it.
        let mut comments =
            numbered().take(at - 1).filter_map(|(i, line)| Some((i, line.strip_prefix('#')?.trim())));
        let named = comments.next_back().and_then(|(i, line)| Some((i, cut(line, separator).ok()?)));
        let Some((line, comment)) = named.filter(|(_, comment)| comment.len() == names.len()) else {
            let expected = "a header with units, as time_s,a_g";
            return Err((Some(at), RecordProblem::Header { found: short(header), expected }));
        };
        (at, names) = (line, comment);
    } else {
        rows.next();
    }
    let columns = Columns::of(names.iter().map(String::as_str).collect(), column);
    let columns = columns.map_err(|problem| (Some(at), problem))?;
    match dt {
        None if columns.time.is_none() => return Err((Some(at), RecordProblem::NoTimes)),
        Some(dt) => step(dt).map_err(|problem| (Some(at), problem))?,
        None => {}
    }
    values(rows, &columns, Cutter::of(separator), dt)
}

/// The rows under a header.
fn values<'a>(
    rows: impl Iterator<Item = (usize, &'a str)>,
    columns: &Columns<'_>,
    mut cutter: Cutter,
    dt: Option<f64>,
) -> ReadRecord {
    let expected = columns.names.len();
    let (mut times, mut values): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    for (line, row) in rows {
        let cells = cutter.cells(row).map_err(|problem| (Some(line), problem))?;
        if cells.len() != expected {
            let problem = RecordProblem::Row { row: short(row), found: cells.len(), expected };
            return Err((Some(line), problem));
        }
        let t = match columns.time {
            Some(time) => number(cells[time], line)?,
            None => dt.unwrap_or(0.0) * values.len() as f64,
        };
        let found = || exact(t).to_string();
        match times.last() {
            Some(before) if t <= *before => {
                let problem = RecordProblem::NotRising { found: found(), before: exact(*before).to_string() };
                return Err((Some(line), problem));
            }
            Some(before) if t - before < LEAST_STEP && columns.time.is_some() => {
                let problem = RecordProblem::Close { found: found(), before: exact(*before).to_string() };
                return Err((Some(line), problem));
            }
            _ => {}
        }
        times.push(t);
        values.push(number(cells[columns.value], line)?);
    }
    Ok(Record { times, values, unit: columns.unit() })
}

impl Record {
    /// Its unit; an error that names the column if there is none.
    ///
    /// # Errors
    /// If the file names no unit.
    pub fn known_unit(&self, file: &str, column: Option<&str>) -> Result<RecordUnit, RecordError> {
        if self.unit == RecordUnit::Unnamed {
            let column = column.unwrap_or("of values").to_owned();
            return Err(RecordError {
                file: file.to_owned(),
                line: None,
                problem: RecordProblem::Unit { column },
            });
        }
        Ok(self.unit)
    }
}
