//! `standfast simulate`: the motion of a body or a block in time.

use std::fmt::Write;
use std::path::{self, Path};

use standfast_cases::motion::{
    Copies, CopiesAsked, Factors, Follow, FollowedMotion, MotionError, MotionView, STATE_AT, SeriesAsked,
    SeriesColumn, SeriesRow, StrengthAsked,
};
use standfast_tables::{TableFormat, WrittenColumn, written};

use crate::answer::PrintedAnswer;
use crate::args::{SimulateArgs, threads};
use crate::batch;
use crate::case_file;
use crate::error::{CommandError, Result};
use crate::figures::Figures;
use crate::files_read::FilesRead;
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
    let cases = file.motions()?;
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
    if let Some(series) = series.filter(|series| !is_stdout(series)) {
        series_format(series)?;
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
    let follow = Follow { divergence: true, strength, series: !no_figures || args.series.is_some() };
    let asked = args.copies.map(|number| CopiesAsked {
        number,
        spread: args.spread.unwrap_or(CopiesAsked::SPREAD),
        seed: args.seed,
        threads: threads(args.threads),
    });
    let answers = watched(|portion| {
        let copied = asked.map_or(0.0, |asked| asked.number as f64);
        let [of_all, of_copies] = portion.parts([50.0, copied]);
        let answers = FollowedMotion::of_all(cases, &follow, of_all)?;
        let count = answers.len();
        let answers = answers.into_iter().enumerate().map(|(place, followed)| match asked {
            Some(asked) => followed.copied(asked, of_copies.part(place, count)),
            None => Ok(followed),
        });
        answers.collect::<Result<Vec<FollowedMotion>, MotionError>>()
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
        write("Copies", csv, copies.csv().as_bytes())?;
    }
    Ok(PrintedAnswer { met, ..printed })
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
        asked.columns().iter().map(|column| (column.name.to_owned(), numbers(column))).collect();
    let states = rows.iter().map(|row| row.moment.state.symbol().to_owned()).collect();
    columns.insert(STATE_AT, ("state".to_owned(), WrittenColumn::Texts(states)));
    written(format, &columns).map_err(|cause| CommandError::Write { path: file.to_owned(), cause })
}
