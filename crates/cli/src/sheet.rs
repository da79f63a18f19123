//! `standfast sheet`: the calculation sheet of a case, as HTML or, through a browser, as PDF.

use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use standfast_sheet::{Paper, Sheet, SheetOptions};

use crate::case_file;
use crate::error::Result;
use crate::files_read::FilesRead;
use crate::progress::watched;
use crate::write::{self, ExtensionError};

/// Format of a sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Html,
    Pdf,
}

/// A sheet's file, whose extension says how it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SheetFile {
    path: PathBuf,
    kind: Kind,
}

impl FromStr for SheetFile {
    type Err = ExtensionError;

    fn from_str(text: &str) -> Result<SheetFile, ExtensionError> {
        let (path, kind) = write::by_extension(text, "html or pdf", |extension| match extension {
            "html" => Some(Kind::Html),
            "pdf" => Some(Kind::Pdf),
            _ => None,
        })?;
        Ok(SheetFile { path, kind })
    }
}

impl fmt::Display for SheetFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.path.display().fmt(f)
    }
}

/// Writes the calculation sheet of a case file.
///
/// # Errors
/// If the case file cannot be read or makes no sense, or the sheet cannot be printed or written.
pub fn sheet(case: &Path, file: &SheetFile, options: &SheetOptions, paper: Paper) -> Result<()> {
    let read = FilesRead::default();
    let case = case_file::parse(case, &read)?;
    read.refuse(&file.path)?;
    let sheet = watched(|portion| Sheet::of_file(&case, options, portion))?;
    match file.kind {
        Kind::Html => write::write_file(&file.path, sheet.html().as_bytes(), &read)?,
        Kind::Pdf => {
            // Before a browser is started for nothing.
            let pending = write::Pending::create(&file.path, &read)?;
            pending.write_all_and_finish(&sheet.pdf(paper)?)?;
        }
    }
    Ok(())
}
