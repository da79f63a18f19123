//! `standfast assess`: a body and its loads from a case file, its diagrams beside it.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use standfast::InputError;
use standfast_cases::layout::paragraph;
use standfast_cases::{Assessment, CaseError, View};
use thiserror::Error;

use crate::case_file::{self, CaseFileError};
use crate::format::Format;
use crate::write::{self, WriteError};

/// Why a case was not assessed.
#[derive(Debug, Error, Diagnostic)]
pub enum AssessError {
    /// The case file cannot be read, or is no case file.
    #[error(transparent)]
    #[diagnostic(transparent)]
    File(#[from] CaseFileError),
    /// The diagram would replace the case file.
    #[error("the diagram would be written over the case file {}", path.display())]
    #[diagnostic(help("rename the case file to end in .toml, or choose another directory with -o DIR"))]
    Overwrite {
        /// The case file.
        path: PathBuf,
    },
    /// There are no criteria to check.
    #[error("--check finds no [criteria] in {}", path.display())]
    #[diagnostic(help("add for example\n[criteria]\nSF_sliding = 1.2\nSF_overturning = 1.2"))]
    NothingToCheck {
        /// The case file.
        path: PathBuf,
    },
    /// The case makes no sense.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// The diagram cannot be drawn.
    #[error(transparent)]
    Mechanics(#[from] InputError),
    /// The diagram cannot be written.
    #[error(transparent)]
    #[diagnostic(help("-o DIR puts the diagrams into another directory"))]
    Write(#[from] WriteError),
}

/// The answer to a case, and why a diagram of it could not be written, if it could not: the answer is not lost with it.
#[derive(Debug)]
pub struct Answered {
    /// The answer to print.
    pub answer: String,
    /// What prevented a diagram.
    pub undrawn: Option<AssessError>,
    /// Whether all criteria are met; `None` where the case has none.
    pub met: Option<bool>,
}

/// Where the diagrams of a case go.
#[derive(Debug, Clone, Copy)]
pub enum Diagrams<'a> {
    /// Beside the case file; those of a case from standard input, `-`, into the current directory.
    Beside,
    /// Into this directory, which is made if it is not there.
    Into(&'a Path),
    /// Nowhere: none are drawn.
    None,
}

/// Assesses a case file, and writes its diagrams.
///
/// # Errors
/// If the case file cannot be read or makes no sense.
pub fn assess(
    path: &Path,
    diagrams: Diagrams,
    view: &View,
    format: Format,
    check: bool,
) -> Result<Answered, AssessError> {
    let (file, note) = case_file::parse_still(path)?;
    let assessment = Assessment::of(&file.case()?).map_err(|error| file.refused(error))?;
    if check && assessment.case.criteria.is_empty() {
        return Err(AssessError::NothingToCheck { path: path.to_owned() });
    }
    let mut drawn = Vec::new();
    let undrawn = draw(&assessment, view, path, diagrams, &mut drawn).err();
    let answer = match format {
        Format::Text => {
            let mut answer = assessment.text(view);
            if !drawn.is_empty() || undrawn.is_some() {
                answer += "\n";
            }
            for Drawn { words, file } in drawn {
                let _ = writeln!(answer, "{words} written to {file}");
            }
            if let Some(note) = note {
                answer += &format!("\n{}", paragraph(&format!("Note: {note}."), 0));
            }
            answer
        }
        Format::Json => {
            assessment.json(view, &drawn.into_iter().map(|Drawn { file, .. }| file).collect::<Vec<_>>())
        }
    };
    Ok(Answered { answer, undrawn, met: assessment.met() })
}

/// A diagram in its file.
struct Drawn {
    words: String,
    file: String,
}

/// Writes the figures.
fn draw(
    assessment: &Assessment,
    view: &View,
    case: &Path,
    diagrams: Diagrams,
    drawn: &mut Vec<Drawn>,
) -> Result<(), AssessError> {
    let directory = match diagrams {
        Diagrams::Beside => case.parent().unwrap_or(Path::new("")),
        Diagrams::Into(directory) => {
            write::make_directory(directory)?;
            directory
        }
        Diagrams::None => return Ok(()),
    };
    let stem = case_file::stem(case);
    for figure in assessment.figures(view)? {
        let file = directory.join(format!("{stem}{}.svg", figure.suffix));
        if case_file::is_at(case, &file) {
            return Err(AssessError::Overwrite { path: case.to_owned() });
        }
        write::write_file(&file, figure.figure.svg().as_bytes())?;
        drawn.push(Drawn { words: figure.words, file: file.display().to_string() });
    }
    Ok(())
}
