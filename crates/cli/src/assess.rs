//! `standfast assess`: a body and its loads from a case file, its diagrams beside it.

use std::path::{Path, PathBuf};

use standfast::InputError;
use standfast_cases::{Assessment, AssessmentView, CaseError, Explained};
use thiserror::Error;

use crate::case_file::{self, CaseFileError};
use crate::figures::{self, FigureError, FigureFile, Figures};
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
    /// The diagram cannot be drawn.
    #[error(transparent)]
    Mechanics(#[from] InputError),
    /// A figure cannot be written.
    #[error(transparent)]
    Figure(#[from] FigureError),
}

impl Explained for AssessError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            AssessError::File(error) => Some(error),
            AssessError::Case(error) => Some(error),
            AssessError::Figure(error) => Some(error),
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

/// The answer to a case, and why a diagram of it could not be written, if it could not: the answer is not lost with it.
#[derive(Debug)]
pub struct AssessmentAnswer {
    /// The answer to print.
    pub answer: String,
    /// Error that prevented a diagram.
    pub undrawn: Option<AssessError>,
    /// True if all criteria are met; `None` where the case has none.
    pub met: Option<bool>,
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
) -> Result<AssessmentAnswer, AssessError> {
    let read = FilesRead::default();
    let assessment = Assessment::of_file(&case_file::parse(path, &read)?)?;
    let nothing = assessment.all_checks().is_empty();
    if check && nothing {
        return Err(AssessError::NothingToCheck { path: path.to_owned() });
    }
    let mut drawn = Vec::new();
    let undrawn = draw(&assessment, view, (path, &read), figures, &mut drawn).err();
    let answer = match format {
        Format::Text => {
            let mut answer = assessment.text(view);
            if !drawn.is_empty() || undrawn.is_some() {
                answer += "\n";
            }
            answer + &figures::said(&drawn)
        }
        Format::Json => assessment.json(view, &figures::files(drawn)),
    };
    Ok(AssessmentAnswer { answer, undrawn, met: assessment.met() })
}

/// Writes the figures.
fn draw(
    assessment: &Assessment,
    view: &AssessmentView,
    (case, read): (&Path, &FilesRead),
    figures: Figures,
    drawn: &mut Vec<FigureFile>,
) -> Result<(), AssessError> {
    if !figures.are_drawn() {
        return Ok(());
    }
    let all = assessment.figures(view)?.into_iter();
    Ok(figures.write(case, read, all.map(|figure| (figure.words, figure.suffix, figure.figure)), drawn)?)
}
