//! Files that are either written whole or left as they were.

mod unfinished;

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::error::{CommandError, Result};
use crate::files_read::FilesRead;
use unfinished::Unfinished;

/// A file name whose extension does not say how the file is written.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{found}; the extension has to be {expected}")]
pub struct ExtensionError {
    found: String,
    expected: &'static str,
}

/// The file `text`, and what `kind` makes of its extension, which it gets in lower case; `expected` says which there are.
///
/// # Errors
/// If there is no extension, or `kind` does not know it.
pub fn by_extension<T>(
    text: &str,
    expected: &'static str,
    kind: impl Fn(&str) -> Option<T>,
) -> Result<(PathBuf, T), ExtensionError> {
    let path = PathBuf::from(text);
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    match kind(&extension.to_ascii_lowercase()) {
        Some(kind) => Ok((path, kind)),
        None if extension.is_empty() => {
            Err(ExtensionError { found: "there is no extension".to_owned(), expected })
        }
        None => Err(ExtensionError { found: format!("unknown extension `{extension}`"), expected }),
    }
}

/// A file that appears under its name only when it is [finished](Pending::finish). Dropped before, it leaves
/// nothing behind.
#[derive(Debug)]
pub struct Pending {
    path: PathBuf,
    target: Target,
}

#[derive(Debug)]
enum Target {
    /// A file that will be put into a place.
    Place(Unfinished, PathBuf),
    /// A device or pipe, which cannot be replaced but only written to.
    Device(fs::File),
}

impl Pending {
    /// Begins the file `path`, which is none of those that were read.
    ///
    /// # Errors
    /// If it is one of those, its directory does not exist or cannot be written to, or `path` is a directory.
    pub fn create(path: &Path, read: &FilesRead) -> Result<Pending> {
        read.refuse(path)?;
        Pending::begin(path)
    }

    /// Begins the answer to a table, which may replace that table, and no other file that was read.
    ///
    /// # Errors
    /// As [`Pending::create`].
    pub fn create_answer(path: &Path, read: &FilesRead) -> Result<Pending> {
        read.refuse_but_table(path)?;
        Pending::begin(path)
    }

    fn begin(path: &Path) -> Result<Pending> {
        let open = || -> io::Result<Target> {
            // A link to a file is followed, so that the file it points to is replaced and not the link.
            let place = path.canonicalize().unwrap_or_else(|_| path.to_owned());
            match fs::metadata(&place) {
                Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
                Ok(found) if !found.is_file() => {
                    return Ok(Target::Device(fs::OpenOptions::new().write(true).open(&place)?));
                }
                _ => {}
            }
            Ok(Target::Place(Unfinished::beside(&place)?, place))
        };
        let target = open().map_err(|cause| CommandError::Write { path: path.to_owned(), cause })?;
        Ok(Pending { path: path.to_owned(), target })
    }

    /// True if nothing of the file can be seen before it is finished; a device gets what is written at once.
    pub fn is_unseen(&self) -> bool {
        matches!(self.target, Target::Place(..))
    }

    /// The name of the unfinished file, if it has one: to be removed if it is never finished nor dropped.
    pub fn temporary(&self) -> Option<&Path> {
        match &self.target {
            Target::Place(file, _) => file.name(),
            Target::Device(_) => None,
        }
    }

    /// Writes the whole file and puts it in its place.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write_all_and_finish(mut self, bytes: &[u8]) -> Result<()> {
        match self.write_all(bytes) {
            Ok(()) => self.finish(),
            Err(cause) => Err(CommandError::Write { path: self.path, cause }),
        }
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// If it cannot be moved there.
    pub fn finish(self) -> Result<()> {
        match self.target {
            Target::Place(file, place) => {
                file.put(&place).map_err(|cause| CommandError::Write { path: self.path, cause })
            }
            Target::Device(_) => Ok(()),
        }
    }
}

impl Write for Pending {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.target {
            Target::Place(file, _) => file.write(bytes),
            Target::Device(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.target {
            Target::Place(file, _) => file.flush(),
            Target::Device(file) => file.flush(),
        }
    }
}

/// Writes the file `path`, whole or not at all.
///
/// # Errors
/// If it is one of the files that were read, or cannot be written.
pub fn write_file(path: &Path, bytes: &[u8], read: &FilesRead) -> Result<()> {
    Pending::create(path, read)?.write_all_and_finish(bytes)
}

/// Makes the directory `path` and those above it, if they are not there.
///
/// # Errors
/// If that is not possible.
pub fn make_directory(path: &Path) -> Result<()> {
    fs::create_dir_all(path).map_err(|cause| CommandError::Write { path: path.to_owned(), cause })
}
