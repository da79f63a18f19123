//! The files that a run has read: case, records, table. No answer is written over one of them.

use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use standfast_cases::Explained;
use thiserror::Error;

/// Purpose for which a file was read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilePurpose {
    /// The case.
    Case,
    /// A record that the case or a row of a table names.
    Record,
    /// The file of a code that a combination names.
    Code,
    /// The table whose rows are answered.
    Table,
    /// The series from a row of which a motion goes on.
    Series,
}

impl FilePurpose {
    fn words(self) -> &'static str {
        match self {
            FilePurpose::Case => "the case file",
            FilePurpose::Record => "the record",
            FilePurpose::Code => "the file of a code",
            FilePurpose::Table => "the table",
            FilePurpose::Series => "the series",
        }
    }
}

/// An output that would replace what was read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("cannot write over {} {}, which was read for this answer{}", read_as.words(), read.display(), self.other_name())]
pub struct WouldReplace {
    /// The file to be written.
    pub output: PathBuf,
    /// The file that was read, as it was named.
    pub read: PathBuf,
    /// Purpose for which it was read.
    pub read_as: FilePurpose,
}

impl Explained for WouldReplace {
    fn help(&self) -> Option<String> {
        Some("give the output another name or directory".into())
    }
}

impl WouldReplace {
    /// Remark on the output's name, where it is another one.
    fn other_name(&self) -> String {
        if self.output == self.read {
            String::new()
        } else {
            format!("; {} is the same file", self.output.display())
        }
    }
}

/// The files that a run has read.
#[derive(Debug, Default)]
pub struct FilesRead(Mutex<Vec<FileRead>>);

#[derive(Debug)]
struct FileRead {
    path: PathBuf,
    read_as: FilePurpose,
    same: Identity,
}

/// Identity of a file, which all its names share.
#[derive(Debug)]
struct Identity {
    /// Path of the file, links followed.
    place: Option<PathBuf>,
    /// Device and number: those of a hard link too.
    #[cfg(unix)]
    node: (u64, u64),
}

impl Identity {
    fn of(path: &Path, #[cfg_attr(not(unix), expect(unused))] found: &Metadata) -> Identity {
        #[cfg(unix)]
        use std::os::unix::fs::MetadataExt;
        Identity {
            place: path.canonicalize().ok(),
            #[cfg(unix)]
            node: (found.dev(), found.ino()),
        }
    }

    fn is(&self, other: &Identity) -> bool {
        #[cfg(unix)]
        if self.node == other.node {
            return true;
        }
        self.place.is_some() && self.place == other.place
    }
}

impl FilesRead {
    /// Opens a file to read it.
    ///
    /// # Errors
    /// If it cannot be opened.
    pub fn open(&self, path: &Path, read_as: FilePurpose) -> io::Result<File> {
        let file = File::open(path)?;
        self.note(path, read_as, &file)?;
        Ok(file)
    }

    /// Reads a whole file.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn read(&self, path: &Path, read_as: FilePurpose) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        self.open(path, read_as)?.read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    /// Reads standard input to its end.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn read_standard_input(&self, read_as: FilePurpose) -> io::Result<Vec<u8>> {
        self.note_standard_input(read_as)?;
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    /// Notes the file that standard input may be.
    ///
    /// # Errors
    /// If the system says nothing of it.
    pub fn note_standard_input(&self, read_as: FilePurpose) -> io::Result<()> {
        #[cfg(unix)]
        {
            use std::os::fd::AsFd;
            let file = File::from(io::stdin().as_fd().try_clone_to_owned()?);
            self.note(Path::new("standard input"), read_as, &file)?;
        }
        #[cfg(not(unix))]
        let _ = read_as;
        Ok(())
    }

    /// Notes an open file; a device or a pipe is not replaced by being written to.
    fn note(&self, path: &Path, read_as: FilePurpose, file: &File) -> io::Result<()> {
        let found = file.metadata()?;
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // Rows of a table may name one record many times.
        let is_known = all.iter().any(|read| read.read_as == read_as && read.path == path);
        if found.is_file() && !is_known {
            all.push(FileRead { path: path.to_owned(), read_as, same: Identity::of(path, &found) });
        }
        Ok(())
    }

    /// Refuses an output that is one of the files.
    ///
    /// # Errors
    /// If it is.
    pub fn refuse(&self, output: &Path) -> Result<(), WouldReplace> {
        self.refuse_if(output, |_| true)
    }

    /// Refuses an output that is one of the files; the table, and nothing but the table, may be replaced by its own answer.
    ///
    /// # Errors
    /// If it is, and was read as anything but the table.
    pub fn refuse_but_table(&self, output: &Path) -> Result<(), WouldReplace> {
        self.refuse_if(output, |read_as| read_as != FilePurpose::Table)
    }

    fn refuse_if(&self, output: &Path, kept: impl Fn(FilePurpose) -> bool) -> Result<(), WouldReplace> {
        // Outputs that are not there yet replace nothing.
        let Ok(found) = fs::metadata(output) else { return Ok(()) };
        let same = Identity::of(output, &found);
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match all.iter().find(|read| kept(read.read_as) && read.same.is(&same)) {
            None => Ok(()),
            Some(FileRead { path, read_as, .. }) => {
                Err(WouldReplace { output: output.to_owned(), read: path.clone(), read_as: *read_as })
            }
        }
    }
}
