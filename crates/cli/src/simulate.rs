//! `standfast simulate`: the motion of a body or a block in time.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use standfast_cases::motion::{
    Follow, FollowedMotion, MotionOutcome, MotionView, Position, SERIES, series, series_csv,
};
use standfast_cases::{CaseError, Explained};
use standfast_tables::{TableFormat, WrittenColumn, written};
use thiserror::Error;

use crate::answer::PrintedAnswer;
use crate::args::SimulateArgs;
use crate::batch::{self, BatchCommandError};
use crate::case_file::{self, CaseFileError};
use crate::figures::Figures;
use crate::files_read::FilesRead;
use crate::format::Format;
use crate::write::{self, WriteError};

/// Reason why a motion was not followed.
#[derive(Debug, Error)]
pub enum SimulateError {
    /// The case file cannot be read.
    #[error(transparent)]
    File(#[from] CaseFileError),
    /// The case makes no sense.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The motion cannot be followed.
    #[error(transparent)]
    Motion(#[from] standfast_cases::motion::MotionError),
    /// There are no criteria to check.
    #[error("--check finds no [criteria] of the motion in {}", path.display())]
    NothingToCheck {
        /// The case file.
        path: PathBuf,
    },
    /// The series has a name that tells no format.
    #[error("cannot tell the format of {} from its extension", path.display())]
    Extension {
        /// The file.
        path: PathBuf,
    },
    /// The series is asked for in a format that this build leaves out.
    #[error(transparent)]
    Format(Box<BatchCommandError>),
    /// The series cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

impl Explained for SimulateError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            SimulateError::File(error) => Some(error),
            SimulateError::Case(error) => Some(error),
            SimulateError::Format(error) => Some(&**error),
            SimulateError::Write(error) => Some(error),
            _ => None,
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            SimulateError::NothingToCheck { .. } => {
                "add for example\n[criteria]\nslide = \"0.10 m\"\nmax_theta = \"50 mrad\"\n\
                 overturned = false"
                    .into()
            }
            SimulateError::Extension { .. } => {
                "expected .csv or .txt, .parquet or .pq, .arrow, .ipc or .feather, .arrows, .xlsx".into()
            }
            _ => return None,
        };
        Some(help)
    }
}

/// Follows the motion of a case file, and writes its figures into a directory or else beside it.
///
/// # Errors
/// If a file cannot be read, the series cannot be written, or the case makes no sense.
pub fn simulate(args: &SimulateArgs) -> Result<PrintedAnswer, SimulateError> {
    let read = FilesRead::default();
    let file = case_file::parse(&args.case, &read)?;
    let cases = file.motions()?;
    if args.check && cases.iter().all(|case| case.criteria.is_empty()) {
        return Err(SimulateError::NothingToCheck { path: args.case.clone() });
    }
    if let Some(series) = args.series.as_ref().filter(|series| series.as_os_str() != "-") {
        // Before a motion is followed for nothing.
        read.refuse(series).map_err(WriteError::from)?;
        series_format(series)?;
    }
    let to_stdout = args.series.as_ref().is_some_and(|series| series.as_os_str() == "-");
    let follow = Follow { sensitivity: args.sensitivity, series: !args.no_figures || args.series.is_some() };
    let answers = FollowedMotion::of_all(cases, &follow)?;
    // The worst by the criteria is the first.
    let met = answers.first().and_then(FollowedMotion::met);
    // That of the situation that is the worst.
    let worst = answers.first().map(|followed| &followed.outcome);
    if let (true, Some(dt), Some(worst)) = (to_stdout, args.dt, worst) {
        return Ok(PrintedAnswer { met, ..PrintedAnswer::plain(series_csv(worst, dt)) });
    }
    let figures = Figures::asked(args.output.as_deref(), args.no_figures);
    let view = MotionView { all: args.all };
    let mut printed = PrintedAnswer::of(&answers[..], &view, args.format, figures, (&args.case, &read));
    if let (Some(series), Some(dt), Some(worst)) = (&args.series, args.dt, worst) {
        write::write_file(series, &series_bytes(worst, dt, series)?, &read)?;
        if args.format == Format::Text {
            let _ = writeln!(printed.answer, "Series written to {}", series.display());
        }
    }
    Ok(PrintedAnswer { met, ..printed })
}

/// The format that the name of a file asks for.
fn series_format(file: &Path) -> Result<TableFormat, SimulateError> {
    if TableFormat::of(file, "--series").is_err() {
        return Err(SimulateError::Extension { path: file.to_owned() });
    }
    batch::format(file, None, "--series").map_err(|error| SimulateError::Format(Box::new(error)))
}

/// The motion every `dt` as a table in the format that the file's name asks for.
fn series_bytes(outcome: &MotionOutcome, dt: f64, file: &Path) -> Result<Vec<u8>, SimulateError> {
    let format = series_format(file)?;
    if format == TableFormat::Csv {
        return Ok(series_csv(outcome, dt).into_bytes());
    }
    let rows: Vec<_> = series(outcome, dt).collect();
    let numbers = |of: fn(&(f64, Position)) -> f64| {
        WrittenColumn::Numbers(rows.iter().map(|row| Some(of(row))).collect())
    };
    let columns = [
        numbers(|(t, _)| *t),
        numbers(|(_, at)| at.slide),
        numbers(|(_, at)| at.x),
        numbers(|(_, at)| at.y),
        numbers(|(_, at)| at.theta),
        numbers(|(_, at)| at.omega),
        WrittenColumn::Texts(rows.iter().map(|(_, at)| at.state.symbol().to_owned()).collect()),
    ];
    let columns: Vec<_> = SERIES.iter().map(|name| (*name).to_owned()).zip(columns).collect();
    Ok(written(format, &columns).map_err(|cause| WriteError::System { path: file.to_owned(), cause })?)
}
