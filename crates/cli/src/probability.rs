//! `standfast probability`: how likely each mode is if some numbers of a case are random.

use std::num::NonZeroUsize;

use miette::Diagnostic;
use standfast_cases::random::{Effort, Probability, ProbabilityError, Request};
use thiserror::Error;

use crate::args::ProbabilityArgs;
use crate::case_file::{self, CaseFileError};
use crate::format::Format;

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
}

/// Answers a case with random numbers; returns what to print.
///
/// # Errors
/// If the case file cannot be read or makes no sense.
pub fn probability(args: &ProbabilityArgs) -> Result<String, ProbabilityCommandError> {
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
    Ok(match args.format {
        Format::Text => answer.text(),
        Format::Json => answer.json(),
    })
}
