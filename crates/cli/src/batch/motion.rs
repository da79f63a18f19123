//! Tables of motions.

use std::io::{self, Write};
use std::path::Path;

use standfast_cases::CaseFile;
use standfast_cases::layout::paragraph;
use standfast_cases::motion::{ROW_RESULTS, in_order};
use standfast_cases::sweep::heading;
use standfast_tables::{
    Interface, MotionRow, MotionTable, OnError, TableError, TableFormat, TableOptions, WrittenColumn,
    column_warnings, written,
};

use crate::args::{BatchArgs, threads};
use crate::case_file;
use crate::error::{CommandError, Result};
use crate::files_read::{FilePurpose, FilesRead};
use crate::progress::watched;
use crate::write::Pending;

/// Answers the rows of a table that vary a case of motion; returns what to print.
///
/// # Errors
/// If the table, a column or a row makes no sense, or a file cannot be read or written.
pub fn motions(args: &BatchArgs, case: &Path, file: CaseFile, files: &FilesRead) -> Result<String> {
    let is_standard = args.input.as_os_str() == "-";
    let name = if is_standard { "standard input".to_owned() } else { args.input.display().to_string() };
    if !args.map.is_empty() {
        return Err(CommandError::Option { option: "--map" });
    }
    let from = super::format(&args.input, args.input_format, "--input-format")?;
    let format = super::format(&args.output, args.output_format, "--output-format");
    let format = format?;
    let nulls = args.on_error == OnError::Null;
    let options =
        TableOptions { from, sheet: args.sheet_name.clone(), head: args.head(), ..TableOptions::new(&name) };
    let table = MotionTable::of(&read(args, &name, files)?, &options)?;
    let header = table.columns();
    if args.output != Path::new("-") {
        // Before many motions are followed for nothing.
        files.refuse_but_table(&args.output)?;
    }
    // Files that a column names need not lie beside the case.
    let named = |path: &str| header.iter().any(|column| heading(column).0 == path);
    let read = case_file::beside(case, files);
    let file = file.with_some_files(&read, &|id| !named(&id.to_string()))?;
    let rows = table.varying(&file)?;
    let results = match &args.columns[..] {
        [] => rows.results(),
        [all] if all.trim() == super::ALL => (0..ROW_RESULTS.len()).collect(),
        names => results(names)?,
    };
    let appended: Vec<&'static str> =
        results.iter().map(|i| ROW_RESULTS[*i]).chain(nulls.then_some("problem")).collect();
    if let Some(column) =
        appended.iter().copied().find(|result| header.iter().any(|column| *column == **result))
    {
        return Err(TableError::ResultExists { name, column: column.to_owned() }.into());
    }
    let threads = threads(args.threads);
    let places: Vec<usize> = (0..table.rows().len()).collect();
    let answer = |i: &usize| {
        let MotionRow { cells, problem, .. } = &table.rows()[*i];
        let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
        match problem {
            Some(problem) => Err(problem.clone()),
            None => rows.answer(&cells, &read).map_err(|fault| table.problem(*i, fault)),
        }
    };
    let answers = watched(|portion| in_order(&places, threads, portion, answer))?;
    let mut head: Vec<&str> = header.iter().map(String::as_str).collect();
    head.extend(appended);
    let unwritten = |cause: io::Error| CommandError::Write { path: args.output.clone(), cause };
    let (mut bad, mut first) = (0, None);
    let mut columns: Vec<Vec<String>> = vec![Vec::new(); head.len()];
    for (i, (row, answer)) in table.rows().iter().zip(answers).enumerate() {
        let mut cells = row.cells.clone();
        match answer {
            Ok(found) => {
                cells.extend(results.iter().map(|j| found[*j].clone()));
                cells.extend(nulls.then(String::new));
            }
            Err(problem) if nulls => {
                bad += 1;
                cells.extend(results.iter().map(|_| String::new()));
                cells.push(problem.to_string());
                first.get_or_insert_with(|| table.error(i, problem));
            }
            Err(problem) => return Err(table.error(i, problem).into()),
        }
        columns.iter_mut().zip(cells).for_each(|(column, cell)| column.push(cell));
    }
    let columns = head.iter().map(|name| (*name).to_owned()).zip(columns).enumerate();
    let columns = columns.map(|(place, (name, cells))| {
        let of_result = (place >= header.len()).then_some(&*name);
        let is_text = format == TableFormat::Csv;
        let column = if is_text { WrittenColumn::Texts(cells) } else { column(of_result, cells) };
        (name, column)
    });
    let content = written(format, &columns.collect::<Vec<_>>()).map_err(unwritten)?;
    let varied: Vec<(usize, String)> = rows.varied().collect();
    let words = varied.iter().map(|(place, key)| match header[*place].as_str() {
        column if column == key => key.clone(),
        column => format!("{key} (column {column})"),
    });
    let mut said = paragraph(&format!("varied: {}", words.collect::<Vec<_>>().join(", ")), 0);
    let places: Vec<usize> = varied.iter().map(|(place, _)| *place).collect();
    for warning in column_warnings(&file, header, &places) {
        said += &paragraph(&format!("warning: {} ({})", warning.words(None), warning.name()), 0);
    }
    rows.notes().iter().for_each(|note| said += &paragraph(note, 0));
    if let Some(first) = first {
        said +=
            &format!("warning: {bad} of {} rows without a result; the first: {first}\n", table.rows().len());
    }
    if args.output == Path::new("-") {
        crate::complain(&said);
        if format == TableFormat::Csv {
            return Ok(String::from_utf8_lossy(&content).into_owned());
        }
        io::stdout().write_all(&content).map_err(unwritten)?;
        return Ok(String::new());
    }
    Pending::create_answer(&args.output, files)?.write_all_and_finish(&content)?;
    crate::complain(&said);
    Ok(String::new())
}

/// The bytes of a table.
fn read(args: &BatchArgs, name: &str, files: &FilesRead) -> Result<Vec<u8>> {
    let bytes = if args.input.as_os_str() == "-" {
        files.read_standard_input(FilePurpose::Table)
    } else {
        files.read(&args.input, FilePurpose::Table)
    };
    bytes.map_err(|cause| CommandError::Read { name: name.to_owned(), cause: cause.to_string() })
}

/// The cells of a column as what they are: a result of this name, or, of the table's own, numbers if all are.
fn column(result: Option<&str>, cells: Vec<String>) -> WrittenColumn {
    let numbers = || cells.iter().map(|cell| cell.parse().ok()).collect();
    match result {
        Some("end" | "situation" | "warnings" | "criterion" | "problem") => WrittenColumn::Texts(cells),
        Some("overturned" | "past_balance" | "unique" | "met") => {
            WrittenColumn::Truths(cells.iter().map(|cell| cell.parse().ok()).collect())
        }
        Some("impacts") => WrittenColumn::Counts(cells.iter().map(|cell| cell.parse().ok()).collect()),
        Some(_) => WrittenColumn::Numbers(numbers()),
        None => {
            let is_number = |cell: &String| cell.is_empty() || cell.parse::<f64>().is_ok_and(f64::is_finite);
            let all = cells.iter().all(is_number) && cells.iter().any(|cell| !cell.is_empty());
            if all { WrittenColumn::Numbers(numbers()) } else { WrittenColumn::Texts(cells) }
        }
    }
}

/// The places of the results of these names.
fn results(names: &[String]) -> Result<Vec<usize>, TableError> {
    let mut places = Vec::new();
    for name in names {
        let place = ROW_RESULTS.iter().position(|result| *result == name.trim());
        let place = place.ok_or_else(|| super::no_result(name, ROW_RESULTS.into_iter()))?;
        if places.contains(&place) {
            let (option, column) = (Interface::Program.columns(), ROW_RESULTS[place]);
            return Err(TableError::ResultTwice { option, column });
        }
        places.push(place);
    }
    Ok(places)
}
