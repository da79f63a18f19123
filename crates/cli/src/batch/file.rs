//! From file to file.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use indicatif::HumanCount;

use super::engine::{self, Input};
use super::progress::Progress;
use super::{BatchError, Options, Summary, TableFormat};
use crate::write::{Pending, WriteError};

/// Answers the table in one file and writes another, which appears only when it is complete; `-` is standard input or
/// output. The extensions tell the formats, unless the options do.
///
/// An interrupt (Ctrl-C) ends the program with exit code 130 and says what was done.
///
/// # Errors
/// If the table or a row makes no sense (see [`OnError`](super::OnError)), or a file cannot be opened or written.
pub fn process(input: &Path, output: &Path, options: &Options) -> Result<Summary, BatchError> {
    let from = options.from.map_or_else(|| TableFormat::of(input, "--input-format"), Ok)?;
    let to = options.to.map_or_else(|| TableFormat::of(output, "--output-format"), Ok)?;
    let (source, length) = open(input, options)?;
    let progress = Arc::new(Progress::shown(length));

    if output == Path::new("-") {
        on_interrupt(progress.clone(), "standard output is not complete".to_owned(), None);
        let sink = BufWriter::new(io::stdout());
        let outcome = engine::run(source, from, sink, to, options, &progress);
        progress.clear();
        return outcome.or_else(|error| match error {
            // The reader of a pipe went away, which is its right.
            BatchError::Write(cause) if cause.kind() == io::ErrorKind::BrokenPipe => Ok(Summary::default()),
            other => Err(other),
        });
    }
    let file = Pending::create(output)?;
    let temporary = Arc::new(Mutex::new(file.temporary().map(Path::to_owned)));
    let said = match file.temporary() {
        Some(_) => format!("{} was not written", output.display()),
        None => format!("{} is not complete", output.display()),
    };
    on_interrupt(progress.clone(), said, Some(temporary.clone()));
    let mut sink = BufWriter::with_capacity(1 << 18, file);
    let outcome = engine::run(source, from, &mut sink, to, options, &progress);
    progress.clear();
    let unwritten = |cause| WriteError { path: output.to_owned(), cause };
    let summary = outcome.map_err(|error| match error {
        BatchError::Write(cause) => unwritten(cause).into(),
        other => other,
    });
    let file = match sink.into_inner() {
        Ok(file) => file,
        Err(error) => {
            let (cause, sink) = error.into_parts();
            // Dropped, it would write once more.
            drop(sink.into_parts());
            return Err(summary.err().unwrap_or_else(|| unwritten(cause).into()));
        }
    };
    let summary = summary?;
    // From here on the file is in its place or not, and an interrupt waits until that is known.
    let _held = temporary.lock().unwrap_or_else(PoisonError::into_inner);
    file.finish()?;
    Ok(summary)
}

/// The input, and its length if that is known.
fn open(path: &Path, options: &Options) -> Result<(Input<'static>, Option<u64>), BatchError> {
    if path == Path::new("-") {
        return Ok((Input::Stream(Box::new(io::stdin())), None));
    }
    let unread = |cause: io::Error| BatchError::Read { name: options.name.clone(), cause: cause.to_string() };
    let file = File::open(path).map_err(unread)?;
    let metadata = file.metadata().map_err(unread)?;
    if metadata.is_dir() {
        return Err(unread(io::ErrorKind::IsADirectory.into()));
    }
    // A pipe with a name has no length and cannot be read from any place.
    Ok(if metadata.is_file() {
        (Input::File(file), Some(metadata.len()))
    } else {
        (Input::Stream(Box::new(file)), None)
    })
}

/// Ends the program on an interrupt: removes the temporary file, and says how far it came.
fn on_interrupt(
    progress: Arc<Progress>,
    said: String,
    temporary: Option<Arc<Mutex<Option<std::path::PathBuf>>>>,
) {
    // Without a handler, the whole program works all the same; only the temporary file would stay behind.
    let _ = ctrlc::set_handler(move || {
        let path = temporary.as_ref().map(|path| path.lock().unwrap_or_else(PoisonError::into_inner));
        if let Some(path) = path.as_ref().and_then(|path| path.as_ref()) {
            let _ = fs::remove_file(path);
        }
        progress.clear();
        let rows = progress.rows();
        let _ = writeln!(io::stderr(), "interrupted after {} rows; {said}", HumanCount(rows));
        std::process::exit(130);
    });
}
