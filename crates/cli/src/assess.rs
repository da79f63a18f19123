//! `standfast assess`: a body and its loads from a case file, its diagrams beside it.

use std::path::{Path, PathBuf};

use standfast_cases::{Assessment, AssessmentView, CaseError, Explained};
use thiserror::Error;

use crate::answer::PrintedAnswer;
use crate::case_file::{self, CaseFileError};
use crate::figures::Figures;
use crate::files_read::FilesRead;
use crate::format::Format;

/// Reason why a case was not assessed.
#[derive(Debug, Error)]
pub enum AssessError {
    /// The case file cannot be read, or is no case file.
    #[error(transparent)]
    File(#[from] CaseFileError),
    /// There are no criteria to check.
    #[error("--check finds no [criteria] in {}", path.display())]
    NothingToCheck {
        /// The case file.
        path: PathBuf,
    },
    /// The case makes no sense.
    #[error(transparent)]
    Case(#[from] CaseError),
}

impl Explained for AssessError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            AssessError::File(error) => Some(error),
            AssessError::Case(error) => Some(error),
            _ => None,
        }
    }

    fn help(&self) -> Option<String> {
        match self {
            AssessError::NothingToCheck { .. } => {
                Some("add for example\n[criteria]\nSF_sliding = 1.2\nSF_overturning = 1.2".into())
            }
            _ => None,
        }
    }
}

/// Assesses a case file, and writes its diagrams.
///
/// # Errors
/// If the case file cannot be read or makes no sense.
pub fn assess(
    path: &Path,
    figures: Figures,
    view: &AssessmentView,
    format: Format,
    check: bool,
) -> Result<PrintedAnswer, AssessError> {
    let read = FilesRead::default();
    let assessment = Assessment::of_file(&case_file::parse(path, &read)?)?;
    let nothing = assessment.all_checks().is_empty();
    if check && nothing {
        return Err(AssessError::NothingToCheck { path: path.to_owned() });
    }
    let printed = PrintedAnswer::of(&assessment, view, format, figures, (path, &read));
    Ok(PrintedAnswer { met: assessment.met(), ..printed })
}
