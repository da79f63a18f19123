//! `standfast simulate`: the motion of a body or a block in time.

use std::fs;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use standfast_cases::motion::{
    BlockCase, BodyCaseError, Follow, MotionCaseError, all_json, body_cases, follow_all, has_block,
    series_csv,
};
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
    /// The case with a body makes no sense.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Body(#[from] BodyCaseError),
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
    let directory = args.case.parent().unwrap_or(Path::new(""));
    let read = |file: &str| {
        let bytes = fs::read(directory.join(file)).map_err(|cause| cause.to_string())?;
        // Old records have letters of other alphabets in their headers, and no meaning in them.
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    };
    let cases = if has_block(&text) {
        vec![BlockCase::parse(&name, &text, &read)?]
    } else {
        body_cases(&name, &text, &read)?
    };
    let follow = Follow { sensitivity: args.sensitivity, series: args.series.is_some() };
    let answers = follow_all(cases, &follow)?;
    let mut answer = match args.format {
        Format::Text => answers
            .iter()
            .map(|(case, followed)| case.text(followed, args.all))
            .collect::<Vec<_>>()
            .join("\n"),
        Format::Json => all_json(&answers),
    };
    if let (Some(series), Some(dt)) = (&args.series, args.dt) {
        // That of the situation that is the worst.
        let table =
            answers.first().map_or_else(String::new, |(_, followed)| series_csv(&followed.outcome, dt));
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
