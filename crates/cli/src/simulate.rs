//! `standfast simulate`: the motion of a body or a block in time.

use std::fmt::Write;
use std::path::{self, Path};

use standfast_cases::CaseFile;
use standfast_cases::key::Table;
use standfast_cases::motion::{
    BlockCase, BodyPoint, Copies, CopiesOptions, Copy, Factors, Follow, FollowedMotion, MotionError,
    MotionView, STATE_AT, SeriesAsked, SeriesColumn, SeriesRow, StrengthAsked, resume,
};
use standfast_tables::{MotionTable, TableFormat, TableOptions, WrittenColumn, written};

use crate::answer::PrintedAnswer;
use crate::args::{SimulateArgs, threads};
use crate::batch;
use crate::case_file;
use crate::error::{CommandError, Result};
use crate::figures::Figures;
use crate::files_read::{FilePurpose, FilesRead};
use crate::format::{Format, Shown};
use crate::progress::watched;
use crate::write;

/// Follows the motion of a case file, and writes its figures into a directory or else beside it.
///
/// # Errors
/// If a file cannot be read, the series cannot be written, or the case makes no sense.
pub fn simulate(args: &SimulateArgs) -> Result<PrintedAnswer> {
    let read = FilesRead::default();
    let file = case_file::parse(&args.case, &read)?;
    let file = match (&args.from, args.row) {
        (Some(series), Some(row)) => resumed(file, series, row.get(), &read)?,
        _ => file,
    };
    let cases = cases(args, &file)?;
    if args.check && cases.iter().all(|case| case.criteria.is_empty()) {
        return Err(CommandError::NothingToCheck {
            path: args.case.clone(),
            of: " of the motion",
            example: "slide = \"0.10 m\"\nmax_theta = \"50 mrad\"\noverturned = false",
        });
    }
    // Before a motion is followed for nothing.
    let [series, csv] = [&args.series, &args.csv].map(|table| table.as_deref());
    if let (Some(series), Some(csv)) = (series, csv)
        && is_one_file(series, csv)
    {
        return Err(CommandError::OneTable { path: csv.to_owned() });
    }
    for table in [series, csv].into_iter().flatten().filter(|table| !is_stdout(table)) {
        read.refuse(table)?;
    }
    for table in [series, csv].into_iter().flatten().filter(|table| !is_stdout(table)) {
        series_format(table)?;
    }
    let no_figures = args.no_figures || (args.brief && args.output.is_none());
    if args.sensitivity {
        eprintln!("note: --sensitivity changes nothing; the divergence of the motion is always said");
    }
    let strength = match args.strength {
        _ if args.no_strength => StrengthAsked::No,
        Some(None) => StrengthAsked::Always(Factors::Rungs),
        Some(Some(count)) => StrengthAsked::Always(Factors::Even(count.into())),
        None => StrengthAsked::IfShort(Factors::Rungs),
    };
    let series_kept = !no_figures || args.series.is_some();
    let follow = Follow { divergence: true, strength, series: series_kept, threads: threads(args.threads) };
    let answers = watched(|portion| {
        FollowedMotion::of_all(cases, &follow, portion).map_err(|error| match (&error, &args.spread) {
            (MotionError::NoSpread { .. }, Some(_)) => CommandError::Spread { problem: error.to_string() },
            _ => CommandError::from(file.motion_refused(error)),
        })
    })?;
    // The worst by the criteria is the first.
    let met = answers.first().and_then(FollowedMotion::met);
    // That of the situation that is the worst.
    let worst = answers.first();
    let rows = args.dt.map(|dt| SeriesAsked { dt, events: args.events }).zip(worst);
    let copies = worst.and_then(|worst| worst.copies.as_ref());
    // A table on standard output stands in place of the answer.
    let table = if series.is_some_and(is_stdout) {
        rows.map(|(rows, worst)| rows.csv(&worst.case, &worst.outcome))
    } else {
        copies.filter(|_| csv.is_some_and(is_stdout)).map(Copies::csv)
    };
    let is_answer = table.is_none() && args.format == Format::Text;
    let mut printed = match table {
        Some(table) => PrintedAnswer::plain(table),
        None => {
            let view = MotionView { all: args.all, ..MotionView::default() };
            let shown = Shown::of(args.brief, args.format);
            let figures = Figures::asked(args.output.as_deref(), no_figures);
            PrintedAnswer::of(&answers[..], &view, shown, figures, (&args.case, &read))
        }
    };
    let mut write = |what: &str, file: &Path, bytes: &[u8]| -> Result<()> {
        write::write_file(file, bytes, &read)?;
        if is_answer {
            let _ = writeln!(printed.answer, "{what} written to {}", file.display());
        }
        Ok(())
    };
    if let (Some(series), Some((rows, worst))) = (series.filter(|series| !is_stdout(series)), rows) {
        write("Series", series, &series_bytes(worst, rows, series)?)?;
    }
    if let (Some(csv), Some(copies)) = (csv.filter(|csv| !is_stdout(csv)), copies) {
        write("Copies", csv, &copies_bytes(copies, csv)?)?;
    }
    Ok(PrintedAnswer { met, ..printed })
}

/// The situations of a case, with what the options say of how it begins, of points and of copies.
fn cases(args: &SimulateArgs, file: &CaseFile) -> Result<Vec<BlockCase>> {
    let mut cases = file.motions()?;
    let points = args.at.iter().enumerate().map(|(place, written)| {
        let problem = |problem: String| CommandError::Point { written: written.clone(), problem };
        BodyPoint::parse(written, place + 1, file.inputs().units()).map_err(problem)
    });
    let points = points.collect::<Result<Vec<BodyPoint>>>()?;
    for case in &mut cases {
        for point in &points {
            if case.points.iter().any(|known| known.name == point.name) {
                let problem = format!("there is a point {} already", point.name);
                return Err(CommandError::Point { written: point.name.clone(), problem });
            }
            case.points.push(point.clone());
        }
        let options = CopiesOptions { number: args.copies, spread: args.spread.clone(), seed: args.seed };
        options.put(case).map_err(|name| CommandError::NoCopies { option: name })?;
        let given = [("threads", args.threads.is_some()), ("csv", args.csv.is_some())];
        if let (None, Some((option, _))) = (&case.copies, given.into_iter().find(|(_, given)| *given)) {
            return Err(CommandError::NoCopies { option });
        }
    }
    Ok(cases)
}

/// A case whose motion goes on from a row of a series.
fn resumed(file: CaseFile, series: &Path, row: usize, read: &FilesRead) -> Result<CaseFile> {
    let name = series.display().to_string();
    let wrong = |problem: String| CommandError::From { path: series.to_owned(), row, problem };
    let bytes = read
        .read(series, FilePurpose::Series)
        .map_err(|cause| CommandError::Read { name: name.clone(), cause: cause.to_string() })?;
    let from = series_format(series)?;
    let table = MotionTable::of(&bytes, &TableOptions { from, ..TableOptions::new(&name) })?;
    let rows = table.rows();
    let found = rows.get(row - 1).ok_or_else(|| wrong(format!("it has {} rows", rows.len())))?;
    let mut inputs = file.inputs().clone();
    if inputs.has(Table::Initial) {
        eprintln!("note: row {row} of {name} stands in place of [motion.initial]");
    }
    resume(&mut inputs, &table.named(found)).map_err(|error| wrong(error.to_string()))?;
    Ok(file.varied(inputs))
}

/// True if a name is that of standard output.
fn is_stdout(table: &Path) -> bool {
    table == Path::new("-")
}

/// True if two names are of one file, which may not be there yet.
fn is_one_file(one: &Path, other: &Path) -> bool {
    let whole = |path: &Path| path::absolute(path).unwrap_or_else(|_| path.to_owned());
    whole(one) == whole(other)
}

/// The format that the name of a file asks for.
fn series_format(file: &Path) -> Result<TableFormat> {
    if TableFormat::of(file, "--series").is_err() {
        return Err(CommandError::Extension { path: file.to_owned() });
    }
    batch::format(file, None, "--series")
}

/// The copies of a motion as a table in the format that the file's name asks for.
fn copies_bytes(copies: &Copies, file: &Path) -> Result<Vec<u8>> {
    let format = series_format(file)?;
    if format == TableFormat::Csv {
        return Ok(copies.csv().into_bytes());
    }
    let rows = || copies.rows.iter();
    let numbers = |value: &dyn Fn(&Copy) -> Option<f64>| WrittenColumn::Numbers(rows().map(value).collect());
    let places = (1..=copies.rows.len() as i64).map(Some).collect();
    let mut columns = vec![("copy".to_owned(), WrittenColumn::Counts(places))];
    for (place, name) in copies.names.iter().enumerate() {
        columns.push((name.clone(), numbers(&|row| Some(row.factors[place]))));
    }
    columns.push(("end".to_owned(), WrittenColumn::Texts(rows().map(|row| row.end.to_owned()).collect())));
    let overturned = rows().map(|row| Some(row.overturned)).collect();
    columns.push(("overturned".to_owned(), WrittenColumn::Truths(overturned)));
    columns.push(("max_theta".to_owned(), numbers(&|row| (!row.overturned).then_some(row.max_theta))));
    columns.push(("slide".to_owned(), numbers(&|row| row.slide)));
    columns.push(("max_slide".to_owned(), numbers(&|row| row.max_slide)));
    written(format, &columns).map_err(|cause| CommandError::Write { path: file.to_owned(), cause })
}

/// The rows of a motion as a table in the format that the file's name asks for.
fn series_bytes(
    FollowedMotion { case, outcome, .. }: &FollowedMotion,
    asked: SeriesAsked,
    file: &Path,
) -> Result<Vec<u8>> {
    let format = series_format(file)?;
    if format == TableFormat::Csv {
        return Ok(asked.csv(case, outcome).into_bytes());
    }
    let rows: Vec<SeriesRow> = asked.rows(case, outcome).collect();
    let numbers =
        |column: &SeriesColumn| WrittenColumn::Numbers(rows.iter().map(|row| column.value(row)).collect());
    let mut columns: Vec<_> =
        asked.columns(case).iter().map(|column| (column.name.to_string(), numbers(column))).collect();
    let states = rows.iter().map(|row| row.moment.state.symbol().to_owned()).collect();
    columns.insert(STATE_AT, ("state".to_owned(), WrittenColumn::Texts(states)));
    written(format, &columns).map_err(|cause| CommandError::Write { path: file.to_owned(), cause })
}
