//! From file to file, with a progress bar.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use indicatif::{ProgressBar, ProgressStyle};

use super::{BatchError, Options, Summary, run};
use crate::write::{Pending, WriteError};

/// Classifies the table in one file and writes another, which appears only when it is complete; `-` is standard
/// input or output.
///
/// # Errors
/// As [`run`], or if a file cannot be opened or written.
pub fn process(input: &Path, output: &Path, options: &Options) -> Result<Summary, BatchError> {
    let source: Box<dyn Read> = if input == Path::new("-") {
        Box::new(io::stdin().lock())
    } else {
        let cause = |cause| BatchError::Open { name: options.name.clone(), cause };
        let file = File::open(input).map_err(cause)?;
        Box::new(progress_bar(file.metadata().map_err(cause)?.len()).wrap_read(file))
    };
    if output == Path::new("-") {
        return run(source, io::stdout().lock(), options).or_else(|error| match error {
            BatchError::Write(cause) if is_closed(&cause) => Ok(Summary::default()),
            other => Err(other),
        });
    }

    let mut file = Pending::create(output)?;
    if let Some(temporary) = file.temporary().map(Path::to_owned) {
        // Without a handler, the whole program works all the same; only the temporary file would stay behind.
        let _ = ctrlc::set_handler(move || {
            let _ = fs::remove_file(&temporary);
            std::process::exit(130);
        });
    }
    let summary = run(source, &mut file, options).map_err(|error| match error {
        BatchError::Write(cause) => WriteError { path: output.to_owned(), cause: plain(cause) }.into(),
        other => other,
    })?;
    file.finish()?;
    Ok(summary)
}

/// Whether the reader of a pipe went away, which is its right.
fn is_closed(error: &csv::Error) -> bool {
    matches!(error.kind(), csv::ErrorKind::Io(cause) if cause.kind() == io::ErrorKind::BrokenPipe)
}

/// The system's error without the CSV writer's words around it.
fn plain(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(cause) => cause,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// A bar on standard error that shows only if that is a terminal.
fn progress_bar(bytes: u64) -> ProgressBar {
    let bar = ProgressBar::new(bytes);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {bytes}/{total_bytes}  {eta} left") {
        bar.set_style(style);
    }
    bar
}
