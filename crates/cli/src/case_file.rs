//! Case files, read: from a file, or from standard input where `-` stands in its place.

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use miette::Diagnostic;
use standfast_cases::motion::{BodyCaseError, ReadFile, Timed};
use standfast_cases::{CaseError, CaseFile};
use thiserror::Error;

/// Why a case file was not read.
#[derive(Debug, Error, Diagnostic)]
pub enum CaseFileError {
    /// The case file cannot be read.
    #[error("cannot read {name}: {cause}")]
    System {
        /// The case file.
        name: String,
        /// What the system says.
        cause: io::Error,
    },
    /// The case file is not text.
    #[error("{name} is not UTF-8 text: line {line} has a byte that is no character")]
    #[diagnostic(help("save it as UTF-8"))]
    Encoding {
        /// The case file.
        name: String,
        /// The first line with such a byte, counted from one.
        line: usize,
    },
    /// It is no case file.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// What it says of time makes no sense.
    #[error(transparent)]
    #[diagnostic(transparent)]
    InTime(#[from] BodyCaseError),
}

/// Whether a case is read from standard input.
fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

/// What a case file is called.
pub(crate) fn name(path: &Path) -> String {
    if is_standard_input(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// What the names of files that are written beside a case file begin with.
pub fn stem(path: &Path) -> String {
    if is_standard_input(path) {
        return "case".to_owned();
    }
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Whether `file` is the case file, so that writing the one would replace the other.
pub fn is_at(path: &Path, file: &Path) -> bool {
    !is_standard_input(path)
        && file.canonicalize().is_ok_and(|file| path.canonicalize().is_ok_and(|case| case == file))
}

/// A case file.
///
/// # Errors
/// If it cannot be read, or is not understood.
pub fn parse(path: &Path) -> Result<CaseFile, CaseFileError> {
    Ok(CaseFile::parse(&name(path), &read(path)?)?)
}

/// A case file as one at the first instant.
pub enum Still<'a> {
    /// One that says nothing of time.
    Still(Box<CaseFile>),
    /// One that says how loads go with time: all at their peaks.
    InTime(Box<Timed<'a>>),
}

/// Reads a case file as one at the first instant; `records` reads those that it names.
///
/// # Errors
/// If it, or a record that it names, cannot be read, or is not understood.
pub fn parse_still<'a>(path: &Path, records: &'a ReadFile<'a>) -> Result<Still<'a>, CaseFileError> {
    let (name, text) = (name(path), read(path)?);
    Ok(match Timed::of(&name, &text, records)? {
        Some(timed) => Still::InTime(Box::new(timed)),
        None => Still::Still(Box::new(CaseFile::parse(&name, &text)?)),
    })
}

/// The text of a case file.
///
/// # Errors
/// If it cannot be read, or is not text.
pub(crate) fn read(path: &Path) -> Result<String, CaseFileError> {
    let read = || {
        if !is_standard_input(path) {
            return fs::read(path);
        }
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    let bytes = read().map_err(|cause| CaseFileError::System { name: name(path), cause })?;
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        CaseFileError::Encoding { name: name(path), line }
    })
}
