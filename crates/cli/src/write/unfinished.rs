//! A file that is being written and may never be finished: without a name, where the system has such files, so that nothing
//! of it is left even when the program is killed.
//!
//! Linux has them (`O_TMPFILE`), on most file systems. Such a file gets its name by a link; where a file is to be replaced, by
//! a link to a temporary name, which is then moved, because a link replaces nothing: for that moment alone a
//! temporary name exists.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use tempfile::NamedTempFile;

/// A file that is being written.
#[derive(Debug)]
pub(super) enum Unfinished {
    #[cfg(target_os = "linux")]
    Unnamed(File),
    Named(NamedTempFile),
}

impl Unfinished {
    /// Begins a file that is going to be put into `place`: in the same directory, and with the permissions of an ordinary
    /// new file.
    pub(super) fn beside(place: &Path) -> io::Result<Unfinished> {
        let directory = directory(place);
        #[cfg(target_os = "linux")]
        if let Some(file) = unnamed::create(directory)? {
            return Ok(Unfinished::Unnamed(file));
        }
        #[cfg_attr(not(unix), expect(unused_mut))]
        let mut builder = builder();
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        builder.tempfile_in(directory).map(Unfinished::Named).map_err(|error| {
            // The name of the temporary file would only puzzle.
            let message = error.to_string();
            let cause = message.split(" at path ").next().unwrap_or_default();
            io::Error::new(error.kind(), cause)
        })
    }

    fn file(&self) -> &File {
        match self {
            #[cfg(target_os = "linux")]
            Unfinished::Unnamed(file) => file,
            Unfinished::Named(file) => file.as_file(),
        }
    }

    /// The name it has for now.
    pub(super) fn name(&self) -> Option<&Path> {
        match self {
            #[cfg(target_os = "linux")]
            Unfinished::Unnamed(_) => None,
            Unfinished::Named(file) => Some(file.path()),
        }
    }

    /// Puts it into `place`, with the permissions of the file that it replaces, if there is one.
    pub(super) fn put(self, place: &Path) -> io::Result<()> {
        if let Ok(found) = fs::metadata(place) {
            self.file().set_permissions(found.permissions())?;
        }
        match self {
            #[cfg(target_os = "linux")]
            Unfinished::Unnamed(file) => unnamed::put(&file, place),
            Unfinished::Named(file) => file.persist(place).map(drop).map_err(|error| error.error),
        }
    }
}

impl Write for Unfinished {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file().flush()
    }
}

fn directory(place: &Path) -> &Path {
    match place.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".standfast-");
    builder
}

/// Files without a name.
#[cfg(target_os = "linux")]
mod unnamed {
    use std::fs::{File, OpenOptions};
    use std::io;
    use std::os::fd::AsRawFd;
    use std::os::unix::fs::OpenOptionsExt;
    use std::path::Path;

    use rustix::fs::{AtFlags, CWD, OFlags, linkat};
    use rustix::io::Errno;

    /// Begins one in `directory`; `None` where there are none.
    pub(super) fn create(directory: &Path) -> io::Result<Option<File>> {
        let flags = OFlags::TMPFILE.bits().cast_signed();
        let file = OpenOptions::new().write(true).mode(0o666).custom_flags(flags).open(directory);
        match file {
            // Without /proc it could not be given a name.
            Ok(file) => Ok(Path::new(&path(&file)).exists().then_some(file)),
            Err(error) => match Errno::from_io_error(&error) {
                // Errors of an old system, and of a file system, that do not know it.
                Some(Errno::OPNOTSUPP | Errno::ISDIR | Errno::NOENT | Errno::INVAL) => Ok(None),
                _ => Err(error),
            },
        }
    }

    /// Gives it the name `place`, which another file may have.
    pub(super) fn put(file: &File, place: &Path) -> io::Result<()> {
        match link(file, place) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                let named = super::builder().make_in(super::directory(place), |name| link(file, name))?;
                named.persist(place).map(drop).map_err(|error| error.error)
            }
            linked => linked,
        }
    }

    fn link(file: &File, name: &Path) -> io::Result<()> {
        linkat(CWD, path(file), CWD, name, AtFlags::SYMLINK_FOLLOW).map_err(io::Error::from)
    }

    fn path(file: &File) -> String {
        format!("/proc/self/fd/{}", file.as_raw_fd())
    }
}
