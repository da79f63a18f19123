//! `standfast new`: a case to begin from, or all examples.

use std::path::{Path, PathBuf};

use standfast_cases::beginnings::Beginning;
use standfast_cases::examples::EXAMPLES;

use crate::args::NewArgs;
use crate::error::{CommandError, Result};
use crate::files_read::FilesRead;
use crate::write::{make_directory, write_file};

/// Does what `standfast new` was asked, and gives back what it prints.
///
/// # Errors
/// If a file is there already, or cannot be written.
pub fn begin(args: &NewArgs) -> Result<String> {
    match (args.kind, &args.output) {
        (Some(kind), None) => Ok(kind.text.to_owned()),
        (Some(kind), Some(path)) => {
            write_new(path, kind)?;
            Ok(format!("{} written to {}\n", kind.title, path.display()))
        }
        (None, _) => examples(args.examples.as_deref().unwrap_or(Path::new("examples"))),
    }
}

/// Writes a case to a file that is not there yet.
fn write_new(path: &Path, kind: &Beginning) -> Result<()> {
    refuse_existing(path)?;
    write_file(path, kind.text.as_bytes(), &FilesRead::default())
}

/// Writes all examples into a folder in which none of them is yet.
fn examples(folder: &Path) -> Result<String> {
    let files: Vec<(PathBuf, &[u8])> =
        EXAMPLES.iter().map(|(path, bytes)| (folder.join(path), *bytes)).collect();
    for (path, _) in &files {
        refuse_existing(path)?;
    }
    for (path, bytes) in &files {
        make_directory(path.parent().unwrap_or(folder))?;
        write_file(path, bytes, &FilesRead::default())?;
    }
    Ok(format!("{} examples written to {}\n", files.len(), folder.display()))
}

/// Someone may have worked in a file that is there.
fn refuse_existing(path: &Path) -> Result<()> {
    match path.try_exists() {
        Ok(false) => Ok(()),
        Ok(true) => Err(CommandError::Exists { path: path.to_owned() }),
        Err(cause) => Err(CommandError::Write { path: path.to_owned(), cause }),
    }
}
