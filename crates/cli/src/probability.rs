//! `standfast probability`: how likely each mode is if some numbers of a case are random.

use std::fmt::Write;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use standfast_cases::random::{Effort, Probability, ProbabilityError, Request};
use thiserror::Error;

use crate::args::ProbabilityArgs;
use crate::case_file::{self, CaseFileError};
use crate::format::Format;
use crate::write::{self, WriteError};

/// Why there are no probabilities.
#[derive(Debug, Error, Diagnostic)]
pub enum ProbabilityCommandError {
    /// The case file cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    File(#[from] CaseFileError),
    /// There is no answer.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Probability(#[from] ProbabilityError),
    /// A figure would replace the case file.
    #[error("the figure would be written over the case file {}", path.display())]
    #[diagnostic(help("rename the case file to end in .toml, or choose another directory with -o DIR"))]
    FigureOverwrite {
        /// The case file.
        path: PathBuf,
    },
    /// A figure cannot be written.
    #[error(transparent)]
    #[diagnostic(help("-o DIR puts the figures into another directory"))]
    Write(#[from] WriteError),
}

/// The answer, and why a figure of it could not be written, if it could not: the answer is not lost with it.
#[derive(Debug)]
pub struct Answered {
    /// The answer to print.
    pub answer: String,
    /// What prevented a figure.
    pub undrawn: Option<ProbabilityCommandError>,
}

/// Answers a case with random numbers, and writes its figures into a directory or else beside it.
///
/// # Errors
/// If the case file cannot be read or makes no sense.
pub fn probability(args: &ProbabilityArgs) -> Result<Answered, ProbabilityCommandError> {
    let name = case_file::name(&args.case);
    let text = case_file::read(&args.case)?;
    let plain = Effort::default();
    let effort = Effort {
        seed: args.seed,
        precision: args.precision,
        floor: args.floor,
        points: args.samples,
        threads: args.threads.map_or(plain.threads, NonZeroUsize::get),
    };
    let request = Request { method: args.method, effort, years: args.years };
    let answer = Probability::along(&name, &text, request, args.over.as_ref())?;
    let mut drawn = Vec::new();
    let undrawn = if args.no_figures { None } else { draw(&answer, &text, args, &mut drawn).err() };
    let answer = match args.format {
        Format::Text => {
            let mut said = answer.text();
            if !drawn.is_empty() || undrawn.is_some() {
                said += "\n";
            }
            for (words, file) in &drawn {
                let _ = writeln!(said, "{words} written to {file}");
            }
            said
        }
        Format::Json => answer.json_with(&drawn.into_iter().map(|(_, file)| file).collect::<Vec<_>>()),
    };
    Ok(Answered { answer, undrawn })
}

/// Writes the figures of an answer; `drawn` gets their words and files.
fn draw(
    answer: &Probability,
    text: &str,
    args: &ProbabilityArgs,
    drawn: &mut Vec<(&'static str, String)>,
) -> Result<(), ProbabilityCommandError> {
    if let Some(directory) = &args.output {
        write::make_directory(directory)?;
    }
    let directory = args.output.as_deref().unwrap_or_else(|| args.case.parent().unwrap_or(Path::new("")));
    let stem = case_file::stem(&args.case);
    for figure in answer.figures(text)? {
        let file = directory.join(format!("{stem}{}.svg", figure.suffix));
        if case_file::is_at(&args.case, &file) {
            return Err(ProbabilityCommandError::FigureOverwrite { path: args.case.clone() });
        }
        write::write_file(&file, figure.figure.svg().as_bytes())?;
        drawn.push((figure.words, file.display().to_string()));
    }
    Ok(())
}
