//! `standfast batch`: every row of a table, from file to file.

pub mod motion;

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use indicatif::HumanCount;
use standfast_cases::layout::paragraph;
use standfast_cases::sweep::SweepResult;
use standfast_tables::{
    CaseTable, Interface, ResultColumn, Summary, TableError, TableFormat, TableInput, TableOptions,
    TableProblem, Varied, VariedColumn, WorstRow, answer,
};

use crate::case_file;
use crate::error::{CommandError, Result};
use crate::features::Feature;
use crate::files_read::{FilePurpose, FilesRead};
use crate::progress::Bar;
use crate::write::Pending;

/// The results of points of these names; all of the problem for none.
///
/// # Errors
/// If there is no result of a name.
pub fn columns(problem: TableProblem, names: &[String]) -> Result<Vec<ResultColumn>, TableError> {
    let all = problem.results();
    let of_name = |name: &String| {
        let found = all.iter().find(|result| result.name() == name.trim());
        found.copied().ok_or_else(|| no_result(name, all.iter().map(|result| result.name())))
    };
    names.iter().map(of_name).collect()
}

/// The name of all results.
const ALL: &str = "all";

/// The case that rows vary, with the results of these names, or `all`; with those that matter for none.
///
/// # Errors
/// If the case file cannot be read or is wrong, or there is no result of a name.
pub fn case(path: &Path, names: &[String], read: &FilesRead) -> Result<CaseTable> {
    let case = CaseTable::of(case_file::parse(path, read)?)?;
    let of_name = |name: &String| {
        let found = SweepResult::find(name.trim());
        found.ok_or_else(|| no_result(name, SweepResult::all().map(SweepResult::name)))
    };
    match names {
        [] => Ok(case.with_what_matters()),
        [name] if name.trim() == ALL => Ok(case),
        _ => Ok(case.with_results(names.iter().map(of_name).collect::<Result<_, _>>()?)),
    }
}

fn no_result(name: &str, all: impl Iterator<Item = &'static str>) -> TableError {
    let option = Interface::Program.columns();
    TableError::NoSuchResult { option, column: name.to_owned(), results: all.collect() }
}

/// Remarks on a table that was answered; empty if there are none.
pub fn said(summary: &Summary) -> String {
    let mut text = String::new();
    if let Some(Varied { columns, notes, warnings }) = &summary.varied {
        let columns = columns.iter().map(|VariedColumn { column, key }| match column == key {
            true => key.clone(),
            false => format!("{key} (column {column})"),
        });
        text += &paragraph(&format!("varied: {}", columns.collect::<Vec<_>>().join(", ")), 0);
        for note in notes {
            text += &paragraph(note, 0);
        }
        for warning in warnings {
            text += &paragraph(&format!("warning: {} ({})", warning, warning.name()), 0);
        }
    }
    for warning in &summary.minded {
        text += &paragraph(&format!("warning: {warning} ({})", warning.name), 0);
    }
    for worst in &summary.worst {
        text += &paragraph(&worst_row(worst), 0);
    }
    if let Summary { bad, rows, first: Some(first), .. } = summary {
        text += &format!("warning: {bad} of {rows} rows without a result; the first: {first}\n");
    }
    text
}

/// The worst row of a criterion, in a sentence.
fn worst_row(worst: &WorstRow) -> String {
    let WorstRow { criterion, required, value, unmet, rows, .. } = worst;
    let rows = match (*unmet, *rows) {
        (0, 1) => "met in the one row".to_owned(),
        (0, rows) => format!("met in all {rows} rows"),
        (unmet, rows) => format!("not met in {unmet} of {rows} rows"),
    };
    let under = worst.situation.as_ref().map_or(String::new(), |name| format!(" under «{name}»"));
    format!("{criterion} {required}: {rows}; the worst is {value}, in row {}{under}", worst.number())
}

/// The format of a table: the one that is said, or what the file's extension tells. `option` is the one that says it.
///
/// # Errors
/// If the extension is not known, or this build leaves out the format.
pub fn format(file: &Path, said: Option<TableFormat>, option: &'static str) -> Result<TableFormat> {
    let format = said.map_or_else(|| TableFormat::of(file, option), Ok)?;
    let feature = match format {
        TableFormat::Csv => None,
        TableFormat::Xlsx => Some(Feature::Workbooks),
        TableFormat::Parquet | TableFormat::Arrow | TableFormat::Arrows => Some(Feature::Tables),
    };
    if let Some(feature) = feature {
        let asked = if said.is_some() { option.to_owned() } else { file.display().to_string() };
        feature.require(&asked, format.name())?;
    }
    Ok(format)
}

/// Answers the table in one file and writes another, or the same, which appears only when it is complete; `-` is standard input or
/// output. No other file that was `read` is written.
///
/// An interrupt (Ctrl-C) ends the program with exit code 130 and says what was done.
///
/// # Errors
/// If the table or a row makes no sense (see [`OnError`](standfast_tables::OnError)), or a file cannot be opened or written.
pub fn process(input: &Path, output: &Path, options: &TableOptions, read: &FilesRead) -> Result<Summary> {
    let (source, length) = open(input, options, read)?;
    let progress = Arc::new(Bar::shown(length));

    if output == Path::new("-") {
        on_interrupt(progress.clone(), "standard output is not complete".to_owned(), None);
        let sink = BufWriter::new(io::stdout());
        let outcome = answer(source, sink, options, &*progress);
        progress.clear();
        return match outcome {
            // The reader of a pipe went away, which is its right.
            Err(TableError::Write(cause)) if cause.kind() == io::ErrorKind::BrokenPipe => {
                Ok(Summary::default())
            }
            outcome => Ok(outcome?),
        };
    }
    let file = Pending::create_answer(output, read)?;
    let temporary = Arc::new(Mutex::new(file.temporary().map(Path::to_owned)));
    let said = if file.is_unseen() { "was not written" } else { "is not complete" };
    let said = format!("{} {said}", output.display());
    on_interrupt(progress.clone(), said, Some(temporary.clone()));
    let mut sink = BufWriter::with_capacity(1 << 18, file);
    let outcome = answer(source, &mut sink, options, &*progress);
    progress.clear();
    let unwritten = |cause| CommandError::Write { path: output.to_owned(), cause };
    let summary = outcome.map_err(|error| match error {
        TableError::Write(cause) => unwritten(cause),
        other => other.into(),
    });
    let file = match sink.into_inner() {
        Ok(file) => file,
        Err(error) => {
            let (cause, sink) = error.into_parts();
            // Dropped, it would write once more.
            drop(sink.into_parts());
            return Err(summary.err().unwrap_or_else(|| unwritten(cause)));
        }
    };
    let summary = summary?;
    // From here on the file is in its place or not, and an interrupt waits until that is known.
    let _held = temporary.lock().unwrap_or_else(PoisonError::into_inner);
    file.finish()?;
    Ok(summary)
}

/// The input, and its length if that is known.
fn open(
    path: &Path,
    options: &TableOptions,
    read: &FilesRead,
) -> Result<(TableInput<'static>, Option<u64>), TableError> {
    if path == Path::new("-") {
        return Ok((TableInput::Stream(Box::new(io::stdin())), None));
    }
    let unread = |cause: io::Error| TableError::Read { name: options.name.clone(), cause: cause.to_string() };
    let file = read.open(path, FilePurpose::Table).map_err(unread)?;
    let metadata = file.metadata().map_err(unread)?;
    if metadata.is_dir() {
        return Err(unread(io::ErrorKind::IsADirectory.into()));
    }
    // A pipe with a name has no length and cannot be read from any place.
    Ok(if metadata.is_file() {
        (TableInput::File(file), Some(metadata.len()))
    } else {
        (TableInput::Stream(Box::new(file)), None)
    })
}

/// Ends the program on an interrupt: removes the temporary file, and says how far it came.
fn on_interrupt(progress: Arc<Bar>, said: String, temporary: Option<Arc<Mutex<Option<std::path::PathBuf>>>>) {
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
