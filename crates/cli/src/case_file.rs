//! Case files, read.

use std::fs;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use standfast_cases::{CaseError, CaseFile};
use thiserror::Error;

/// Why a case file was not read.
#[derive(Debug, Error, Diagnostic)]
pub enum CaseFileError {
    /// The case file cannot be read.
    #[error("cannot read {}: {cause}", path.display())]
    System {
        /// The case file.
        path: PathBuf,
        /// What the system says.
        cause: std::io::Error,
    },
    /// The case file is not text.
    #[error("{} is not UTF-8 text: line {line} has a byte that is no character", path.display())]
    #[diagnostic(help("save it as UTF-8"))]
    Encoding {
        /// The case file.
        path: PathBuf,
        /// The first line with such a byte, counted from one.
        line: usize,
    },
    /// It is no case file.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
}

/// A case file.
///
/// # Errors
/// If it cannot be read, or is not understood.
pub fn parse(path: &Path) -> Result<CaseFile, CaseFileError> {
    Ok(CaseFile::parse(&path.display().to_string(), &read(path)?)?)
}

/// The text of a case file.
///
/// # Errors
/// If it cannot be read, or is not text.
fn read(path: &Path) -> Result<String, CaseFileError> {
    let bytes = fs::read(path).map_err(|cause| CaseFileError::System { path: path.to_owned(), cause })?;
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        CaseFileError::Encoding { path: path.to_owned(), line }
    })
}
