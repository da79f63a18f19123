//! `standfast design`: a quantity that meets a target, the boundary of two in files, or the least change of each.

use std::fmt;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use standfast_cases::Document;
use standfast_cases::design::{
    BoundaryRequest, ChangeList, Design, DesignBoundary, DesignRequest, Extreme, Minimum, MinimumRequest,
    Spelling, Target, boundary_csv,
};

use crate::args::DesignArgs;
use crate::case_file;
use crate::draw::PictureFile;
use crate::error::{CommandError, Result};
use crate::files_read::FilesRead;
use crate::format::{Format, Shown};
use crate::progress::watched;
use crate::write::{self, ExtensionError};

/// A file for the boundary of two quantities, whose extension says what is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BoundaryFile {
    /// A picture.
    Picture(PictureFile),
    /// A table.
    Csv(PathBuf),
}

impl FromStr for BoundaryFile {
    type Err = ExtensionError;

    fn from_str(text: &str) -> Result<BoundaryFile, ExtensionError> {
        let kind = |extension: &str| match extension {
            "csv" => Some(None),
            extension => Some(Some(PictureFile::kind(extension)?)),
        };
        let (path, kind) = write::by_extension(text, "svg, png, pdf or csv", kind)?;
        Ok(match kind {
            None => BoundaryFile::Csv(path),
            Some(picture) => BoundaryFile::Picture(PictureFile::new(path, picture)),
        })
    }
}

impl BoundaryFile {
    fn path(&self) -> &Path {
        match self {
            BoundaryFile::Picture(picture) => picture.path(),
            BoundaryFile::Csv(path) => path,
        }
    }
}

impl fmt::Display for BoundaryFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.path().display().fmt(f)
    }
}

/// The design that the arguments ask for, as it is printed; files of it are written.
///
/// # Errors
/// If the case file cannot be read or makes no sense, there is no design, or a file cannot be written.
pub fn design(args: &DesignArgs) -> Result<String> {
    let read = FilesRead::default();
    let file = case_file::parse(&args.case, &read)?;
    for output in &args.output {
        // Before a boundary is looked for, or the first of several files is written.
        read.refuse(output.path())?;
    }
    if let Some(cost) = args.minimise {
        let request = MinimumRequest {
            vary: args.vary.clone(),
            target: args.target.map_or_else(|| Target::own(&file), Ok)?,
            cost,
            from: args.from.clone(),
            to: args.to.clone(),
            spelling: &Spelling::PROGRAM,
        };
        let minimum = watched(|portion| Minimum::of(&file, request, portion))?;
        return Ok(Shown::of(args.brief, args.format).text(&minimum, &(), &[]));
    }
    let Some(vary) = single(&args.vary, "--vary")? else {
        let list = watched(|portion| ChangeList::of(&file, args.target, portion))?;
        return Ok(Shown::of(args.brief, args.format).text(&list, &(), &[]));
    };
    let request = DesignRequest {
        vary,
        target: args.target.map_or_else(|| Target::own(&file), Ok)?,
        extreme: if args.greatest { Extreme::Greatest } else { Extreme::Least },
        from: single(&args.from, "--from")?,
        to: single(&args.to, "--to")?,
        spelling: &Spelling::PROGRAM,
    };
    let Some(and) = args.and.clone() else {
        let design = watched(|portion| Design::of(&file, request, portion))?;
        return Ok(Shown::of(args.brief, args.format).text(&design, &(), &[]));
    };
    let request =
        BoundaryRequest { design: request, and, from: args.and_from.clone(), to: args.and_to.clone() };
    let boundary = watched(|portion| DesignBoundary::of(&file, request, portion))?;
    let written = files(args, &boundary, &read)?;
    Ok(match args.format {
        Format::Text => boundary.text(&()) + &written,
        Format::Json => boundary.json(&(), &[]),
    })
}

/// The one value of an option that only a least cost takes several times.
fn single(values: &[String], option: &'static str) -> Result<Option<String>> {
    match values {
        [] => Ok(None),
        [value] => Ok(Some(value.clone())),
        _ => Err(CommandError::Several { option }),
    }
}

/// Writes the files; says so.
fn files(args: &DesignArgs, boundary: &DesignBoundary, read: &FilesRead) -> Result<String> {
    let mut said = if args.output.is_empty() { String::new() } else { "\n".to_owned() };
    for output in &args.output {
        let what = match output {
            BoundaryFile::Csv(path) => {
                write::write_file(path, boundary_csv(boundary).as_bytes(), read)?;
                "Table"
            }
            BoundaryFile::Picture(picture) => {
                let figure = boundary.figures(&())?.pop().ok_or(CommandError::NoBoundary)?.figure;
                picture.save(&figure, args.scale, read)?;
                "Picture"
            }
        };
        let _ = writeln!(said, "{what} written to {output}");
    }
    Ok(said)
}
