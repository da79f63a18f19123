//! `standfast assess`: a body and its loads from a case file, its diagrams beside it.

use std::path::Path;

use standfast_cases::{Assessment, AssessmentView};

use crate::answer::PrintedAnswer;
use crate::case_file;
use crate::error::{CommandError, Result};
use crate::figures::Figures;
use crate::files_read::FilesRead;
use crate::format::Shown;
use crate::progress::watched;

/// Assesses a case file, and writes its diagrams.
///
/// # Errors
/// If the case file cannot be read or makes no sense.
pub fn assess(
    path: &Path,
    figures: Figures,
    view: &AssessmentView,
    shown: Shown,
    check: bool,
) -> Result<PrintedAnswer> {
    let read = FilesRead::default();
    let file = case_file::parse(path, &read)?;
    let assessment = watched(|portion| Assessment::following(&file, None, portion))?;
    let nothing = assessment.all_checks().is_empty();
    if check && nothing {
        return Err(CommandError::NothingToCheck {
            path: path.to_owned(),
            of: "",
            example: "SF_sliding = 1.2\nSF_overturning_net = 1.2",
        });
    }
    let printed = PrintedAnswer::of(&assessment, view, shown, figures, (path, &read));
    Ok(PrintedAnswer { met: assessment.met(), ..printed })
}
