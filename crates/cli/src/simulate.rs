//! `standfast simulate`: the motion of a body or a block in time.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use standfast_cases::motion::{
    BlockCase, BodyCaseError, Follow, Followed, GivenBase, all_json, cases_on, follow_all, series_csv,
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
    Case(#[from] BodyCaseError),
    /// The motion cannot be followed.
    #[error(transparent)]
    Motion(#[from] standfast_cases::motion::MotionError),
    /// The series would replace the case file.
    #[error("the series would be written over the case file {}", path.display())]
    Overwrite {
        /// The case file.
        path: PathBuf,
    },
    /// A figure would replace the case file.
    #[error("the figure would be written over the case file {}", path.display())]
    #[diagnostic(help("rename the case file to end in .toml, or choose another directory with -o DIR"))]
    FigureOverwrite {
        /// The case file.
        path: PathBuf,
    },
    /// The series or a figure cannot be written.
    #[error(transparent)]
    #[diagnostic(help("-o DIR puts the figures into another directory"))]
    Write(#[from] WriteError),
}

/// The motion of a case, and why a figure of it could not be written, if it could not: the answer is not lost with it.
#[derive(Debug)]
pub struct Simulated {
    /// The answer to print.
    pub answer: String,
    /// What prevented a figure.
    pub undrawn: Option<SimulateError>,
}

/// Follows the motion of a case file, and writes its figures into a directory or else beside it.
///
/// # Errors
/// If a file cannot be read, the series cannot be written, or the case makes no sense.
pub fn simulate(args: &SimulateArgs) -> Result<Simulated, SimulateError> {
    let name = case_file::name(&args.case);
    let text = case_file::read(&args.case)?;
    let read = record_reader(&args.case);
    let cases = cases_on(&name, &text, &read, &GivenBase::default())?;
    let to_stdout = args.series.as_ref().is_some_and(|series| series.as_os_str() == "-");
    let follow = Follow { sensitivity: args.sensitivity, series: !args.no_figures || args.series.is_some() };
    let answers = follow_all(cases, &follow)?;
    // That of the situation that is the worst.
    let table =
        |dt: f64| answers.first().map_or_else(String::new, |(_, followed)| series_csv(&followed.outcome, dt));
    if let (true, Some(dt)) = (to_stdout, args.dt) {
        return Ok(Simulated { answer: table(dt), undrawn: None });
    }
    let mut drawn = Vec::new();
    let undrawn = match answers.first() {
        Some((case, followed)) if !args.no_figures => draw(case, followed, args, &mut drawn).err(),
        _ => None,
    };
    let mut answer = match args.format {
        Format::Text => {
            let texts: Vec<_> =
                answers.iter().map(|(case, followed)| case.text(followed, args.all)).collect();
            let mut answer = texts.join("\n");
            if !drawn.is_empty() || undrawn.is_some() {
                answer += "\n";
            }
            for (words, file) in &drawn {
                let _ = writeln!(answer, "{words} written to {file}");
            }
            answer
        }
        Format::Json => all_json(&answers, &drawn.into_iter().map(|(_, file)| file).collect::<Vec<_>>()),
    };
    if let (Some(series), Some(dt)) = (&args.series, args.dt) {
        if case_file::is_at(&args.case, series) {
            return Err(SimulateError::Overwrite { path: series.clone() });
        }
        write::write_file(series, table(dt).as_bytes())?;
        if args.format == Format::Text {
            let _ = writeln!(answer, "Series written to {}", series.display());
        }
    }
    Ok(Simulated { answer, undrawn })
}

/// Reads the files that a case names, beside it.
pub(crate) fn record_reader(case: &Path) -> impl Fn(&str) -> Result<String, String> {
    let directory = case.parent().unwrap_or(Path::new("")).to_owned();
    move |file| {
        let bytes = fs::read(directory.join(file)).map_err(|cause| cause.to_string())?;
        // Old records have letters of other alphabets in their headers, and no meaning in them.
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

/// Writes the figures of a motion; `drawn` gets their words and files.
fn draw(
    case: &BlockCase,
    followed: &Followed,
    args: &SimulateArgs,
    drawn: &mut Vec<(&'static str, String)>,
) -> Result<(), SimulateError> {
    if let Some(directory) = &args.output {
        write::make_directory(directory)?;
    }
    let directory = args.output.as_deref().unwrap_or_else(|| args.case.parent().unwrap_or(Path::new("")));
    let stem = case_file::stem(&args.case);
    for figure in case.figures(followed) {
        let file = directory.join(format!("{stem}{}.svg", figure.suffix));
        if case_file::is_at(&args.case, &file) {
            return Err(SimulateError::FigureOverwrite { path: args.case.clone() });
        }
        write::write_file(&file, figure.figure.svg().as_bytes())?;
        drawn.push((figure.words, file.display().to_string()));
    }
    Ok(())
}
