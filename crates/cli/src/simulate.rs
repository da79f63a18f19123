//! `standfast simulate`: the motion of a block in time.

use std::fs;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use standfast_cases::motion::{BlockCase, Follow, MotionCaseError, has_block, series_csv};
use thiserror::Error;

use crate::args::SimulateArgs;
use crate::case_file::{self, CaseFileError};
use crate::format::Format;
use crate::write::{self, WriteError};

/// Why a motion was not followed.
#[derive(Debug, Error, Diagnostic)]
pub enum SimulateError {
    /// The case file cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    File(#[from] CaseFileError),
    /// The case makes no sense.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] MotionCaseError),
    /// There is no block.
    #[error("{name} has no [block]")]
    #[diagnostic(help(
        "`standfast simulate --help` shows a case; `standfast assess` takes those with a [body]"
    ))]
    NoBlock {
        /// The case file.
        name: String,
    },
    /// The motion cannot be followed.
    #[error(transparent)]
    Motion(#[from] standfast_cases::motion::MotionError),
    /// The series would replace the case file.
    #[error("the series would be written over the case file {}", path.display())]
    Overwrite {
        /// The case file.
        path: PathBuf,
    },
    /// The series cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// Follows the motion of a case file; returns what to print.
///
/// # Errors
/// If a file cannot be read or written, or the case makes no sense.
pub fn simulate(args: &SimulateArgs) -> Result<String, SimulateError> {
    let name = case_file::name(&args.case);
    let text = case_file::read(&args.case)?;
    if !has_block(&text) && text.contains("[body]") {
        return Err(SimulateError::NoBlock { name });
    }
    let directory = args.case.parent().unwrap_or(Path::new(""));
    let read = |file: &str| {
        let bytes = fs::read(directory.join(file)).map_err(|cause| cause.to_string())?;
        // Old records have letters of other alphabets in their headers, and no meaning in them.
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    };
    let case = BlockCase::parse(&name, &text, &read)?;
    let follow = Follow { sensitivity: args.sensitivity, series: args.series.is_some() };
    let followed = case.follow(&follow)?;
    let mut answer = match args.format {
        Format::Text => case.text(&followed, args.all),
        Format::Json => case.json(&followed),
    };
    if let (Some(series), Some(dt)) = (&args.series, args.dt) {
        let table = series_csv(&followed.outcome, dt);
        if series.as_os_str() == "-" {
            return Ok(table);
        }
        if case_file::is_at(&args.case, series) {
            return Err(SimulateError::Overwrite { path: series.clone() });
        }
        write::write_file(series, table.as_bytes())?;
        if args.format == Format::Text {
            answer += &format!("\nSeries written to {}\n", series.display());
        }
    }
    Ok(answer)
}
