//! Case files, read: from a file, or from standard input where `-` stands in its place.

use std::path::Path;

use standfast_cases::{CaseFile, CodeFile};

use crate::error::{CommandError, Result};
use crate::files_read::{FilePurpose, FilesRead};

/// True if a case is read from standard input.
fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

/// Name of a case file.
pub(crate) fn name(path: &Path) -> String {
    if is_standard_input(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// Beginning of the names of files that are written beside a case file.
pub fn stem(path: &Path) -> String {
    if is_standard_input(path) {
        return "case".to_owned();
    }
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// A case file with the files that it names, which lie beside it.
///
/// # Errors
/// If it, or a file that it names, cannot be read, or is not understood.
pub fn parse(path: &Path, files: &FilesRead) -> Result<CaseFile> {
    Ok(CaseFile::read(&name(path), &read(path, files)?, &beside(path, files))?)
}

/// A case file without the files that it names.
///
/// # Errors
/// If it cannot be read, or is not understood.
pub fn parse_alone(path: &Path, files: &FilesRead) -> Result<CaseFile> {
    Ok(CaseFile::parse(&name(path), &read(path, files)?)?)
}

/// Reads the files that a case names, beside it.
pub(crate) fn beside(case: &Path, files: &FilesRead) -> impl Fn(&str) -> Result<String, String> {
    let directory = case.parent().unwrap_or(Path::new("")).to_owned();
    move |file| {
        let purpose = if CodeFile::is_called(file) { FilePurpose::Code } else { FilePurpose::Record };
        let bytes = files.read(&directory.join(file), purpose).map_err(|cause| cause.to_string())?;
        // Old records have letters of other alphabets in their headers, and no meaning in them.
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

/// The file that an editor made of `path`, where there is one: Windows hides the `.txt` that it puts behind a name.
fn ending_in_txt(path: &Path) -> Option<String> {
    let mut with_txt = path.as_os_str().to_owned();
    with_txt.push(".txt");
    let there = !path.exists() && Path::new(&with_txt).exists();
    there
        .then(|| format!("; there is {}: type that name, or rename the file", Path::new(&with_txt).display()))
}

/// The text of a case file.
///
/// # Errors
/// If it cannot be read, or is not text.
pub(crate) fn read(path: &Path, files: &FilesRead) -> Result<String> {
    let read = if is_standard_input(path) {
        files.read_standard_input(FilePurpose::Case)
    } else {
        files.read(path, FilePurpose::Case)
    };
    let bytes = read.map_err(|cause| CommandError::Read {
        name: name(path),
        cause: cause.to_string() + &ending_in_txt(path).unwrap_or_default(),
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        CommandError::Encoding { name: name(path), line }
    })
}
