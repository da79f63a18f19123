//! `standfast simulate`: the motion of a body or a block in time.

use std::fmt::Write;
use std::path::Path;

use standfast_cases::motion::{
    CopiesAsked, Factors, Follow, FollowedMotion, MotionError, MotionView, STATE_AT, SeriesAsked,
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
    if let Some(series) = args.series.as_ref().filter(|series| series.as_os_str() != "-") {
        // Before a motion is followed for nothing.
        read.refuse(series)?;
        series_format(series)?;
    }
    let to_stdout = args.series.as_ref().is_some_and(|series| series.as_os_str() == "-");
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
    let rows = args.dt.map(|dt| SeriesAsked { dt, events: args.events });
    if let (true, Some(rows), Some(worst)) = (to_stdout, rows, worst) {
        return Ok(PrintedAnswer { met, ..PrintedAnswer::plain(rows.csv(&worst.case, &worst.outcome)) });
    }
    let figures = Figures::asked(args.output.as_deref(), no_figures);
    let view = MotionView { all: args.all, ..MotionView::default() };
    let mut printed = PrintedAnswer::of(
        &answers[..],
        &view,
        Shown::of(args.brief, args.format),
        figures,
        (&args.case, &read),
    );
    if let (Some(series), Some(rows), Some(worst)) = (&args.series, rows, worst) {
        write::write_file(series, &series_bytes(worst, rows, series)?, &read)?;
        if args.format == Format::Text {
            let _ = writeln!(printed.answer, "Series written to {}", series.display());
        }
    }
    if let (Some(csv), Some(copies)) =
        (&args.csv, answers.first().and_then(|followed| followed.copies.as_ref()))
    {
        write::write_file(csv, &copies.csv().into_bytes(), &read)?;
        if args.format == Format::Text {
            let _ = writeln!(printed.answer, "Copies written to {}", csv.display());
        }
    }
    Ok(PrintedAnswer { met, ..printed })
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
